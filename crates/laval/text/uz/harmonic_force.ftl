# Response to a harmonic force.
harmonic-force-largest = Eng katta rezonans { $value } da: { $body } { $amplitude } ga yetadi{ $known ->
        [yes] , kuchaytirish koeffitsienti { $factor }
       *[no] {""}
    }.
harmonic-force-unbounded = { $value } da so‘nishsiz rezonans: { $body } amplitudasi cheksiz.
harmonic-force-singular = { $value } da so‘nishsiz rezonans: amplituda cheksiz.
harmonic-force-none = Bu { $over ->
        [speed] aylanish chastotalari
       *[frequency] chastotalar
    } diapazonida rezonans yo‘q.
harmonic-force-amplitude = { $speed } da { $body } amplitudasi { $value }.
harmonic-force-frequency-only = Qadamdan tor rezonanslar qolib ketishi mumkin, turg‘unlik tekshirilmagan: bir element faqat chastota sohasida berilgan.
harmonic-force-margin-kept = Chastota zaxiralari saqlangan (API 684, SP6.8.2.10). Eng kichigi { $resonance } rezonansida: { $value }, { $known ->
        [yes] kuchaytirish koeffitsienti { $factor } bo‘lganda
       *[no] kuchaytirish koeffitsienti (u noma’lum) qanday bo‘lmasin
    } { $required } talab qilinadi.
harmonic-force-margin-broken = Chastota zaxirasi kichik (API 684, SP6.8.2.10): { $resonance } rezonansida { $value }, kuchaytirish koeffitsienti { $factor } bo‘lganda { $required } talab qilinadi.
harmonic-force-gap-closes = Tebranish «{ $part }» tirqishini yopadi, muvozanatda { $gap }, { $value } dan { $last } gacha. Kontakt hisobga olinmagan, shuning uchun amplitudalar u yerda yaroqsiz.
harmonic-force-validity = Yaroqsiz: javob { $place } da «{ $part }» sohasidan tashqarida, { $what } = { $value } (chegara 1).
harmonic-force-validity-unbounded = Yaroqsiz: javob { $place } da «{ $part }» sohasidan tashqarida, { $what } cheksiz (chegara 1).

harmonic-force-alt = Garmonik kuch ta’siridagi barcha nuqtalar amplitudalari, rezonanslar soni: { $peaks }.
