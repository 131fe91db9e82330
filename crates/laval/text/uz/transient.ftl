# Vaqt bo‘yicha harakat.

transient-still-growing = "{ $body }" jismining muvozanat holatidan { $quality ->
        [tilt] og‘ish burchagi
       *[displacement] siljishi
    } { $when } hali o‘sadi. Shu paytgacha uning eng katta qiymati { $value }.
transient-end-state = "{ $body }" jismi { $when } muvozanat holatidan { $value } masofada.
transient-end-speed = Aylanish tezligi { $when } { $value }.

# O‘sish, o‘ramaning ikkinchi yarmi bo‘yicha.
transient-grows = { $body } uchun amplituda o‘sadi: yozuvning ikkinchi yarmida o‘sish sur’ati { $value }. Bu tezlikdan qoching yoki so‘ndirish qo‘shing.
transient-decays = { $body } uchun amplituda so‘nadi: yozuvning ikkinchi yarmida o‘sish sur’ati { $value }.
transient-steady = { $body } uchun amplituda yozuvning ikkinchi yarmida sezilarli o‘smaydi ham, so‘nmaydi ham: o‘sish sur’ati { $value } ± { $uncertainty }.
transient-grows-linearly = { $body } uchun amplituda yozuvning ikkinchi yarmida vaqt bo‘yicha chiziqli, { $value } sur’at bilan o‘sadi. Bu tezlikdan qoching yoki so‘ndirish qo‘shing.
transient-decreases-linearly = { $body } uchun amplituda yozuvning ikkinchi yarmida vaqt bo‘yicha chiziqli, { $value } sur’at bilan kamayadi.
transient-grows-ever-more-slowly = { $body } uchun amplituda eksponensial qonundan sekinroq o‘sadi: yozuvning ikkinchi yarmida uning nisbiy sur’ati { $first } qiymatidan { $value } qiymatigacha kamayadi. O‘sish to‘xtash-to‘xtamasligini uzunroq davomiylik ko‘rsatadi.
transient-windows-too-long = O‘sish baholanmagan: o‘ramaning bitta oynasi ({ $value }) yozuvning bir necha aylanishini o‘z ichiga oladi. Davomiylikni qisqartiring.
transient-too-short = O‘sish baholanmagan: yozuvda siljishning aylanishlari juda kam. Davomiylikni oshiring.
