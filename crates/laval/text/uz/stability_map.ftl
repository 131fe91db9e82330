# Eng katta o‘sish sur’ati.
stability-map-largest-growth = Mashina noturg‘un: eng katta o‘sish sur’ati { $value }, { $speed } tezlikda, { $motion ->
        [divergence] statik noturg‘unlik (divergensiya)
       *[whirl] pretsessiya chastotasi { $frequency }
    }.
stability-map-largest-growth-of-map = Xaritadagi eng katta o‘sish sur’ati: { $value }, { $speed } tezlikda, { $parameter } = { $setting } bo‘lganda, { $motion ->
        [divergence] statik noturg‘unlik (divergensiya)
       *[whirl] pretsessiya chastotasi { $frequency }
    }.
stability-map-stable = { $computed ->
        [stopped] Hisob to‘xtaguncha hisoblangan
       *[all] Hisoblangan
    } nuqtalarning birortasida ham moda { $threshold ->
        [zero] o‘smaydi
       *[set] { $limit } sur’atdan tez o‘smaydi
    }: eng katta o‘sish sur’ati { $value }.
stability-map-marginal = { $computed ->
        [stopped] Hisob to‘xtaguncha hisoblangan
       *[all] Hisoblangan
    } nuqtalarning birortasida ham moda { $threshold ->
        [zero] o‘smaydi
       *[set] { $limit } sur’atdan tez o‘smaydi
    }: eng katta o‘sish sur’ati nolga teng.
stability-map-stable-counted = { $computed ->
        [stopped] Hisob to‘xtaguncha hisoblangan
       *[all] Hisoblangan
    } nuqtalarning birortasida ham moda { $threshold ->
        [zero] o‘smaydi
       *[set] { $limit } sur’atdan tez o‘smaydi
    }.
stability-map-stability-unknown = Turg‘unlik isbotlanmagan: { $threshold ->
        [zero] o‘sadigan
       *[set] { $limit } sur’atdan tez o‘sadigan
    } moda topilmadi, lekin { $points } ta nuqtadan { $open } tasida ba’zilari tushib qolgan bo‘lishi mumkin. Kichikroq frequency_limit yoki kattaroq growth_threshold qiymati qidirishni osonlashtiradi.

# Mashina noturg‘un bo‘lgan tezlik oraliqlari.
stability-map-unstable-range = { $value } tezlikdan { $end ->
        [range] oraliq oxirigacha
        [stopped] { $to } tezlikkacha (hisob shu yerda to‘xtagan)
       *[boundary] { $to } tezlikkacha
    } noturg‘un{ $threshold ->
        [zero] {""}
       *[set] : o‘sish sur’ati { $limit } qiymatidan katta
    }.
stability-map-unstable-from-start = Oraliq boshidan ({ $value }) { $end ->
        [range] oxirigacha ({ $to })
        [stopped] { $to } tezlikkacha (hisob shu yerda to‘xtagan)
       *[boundary] { $to } tezlikkacha
    } noturg‘un{ $threshold ->
        [zero] {""}
       *[set] : o‘sish sur’ati { $limit } qiymatidan katta
    }.
stability-map-unstable-range-not-located = { $low } va { $high } orasidagi tezlikdan { $end ->
        [range] oraliq oxirigacha
        [stopped] { $to } tezlikkacha (hisob shu yerda to‘xtagan)
       *[boundary] { $to } tezlikkacha
    } noturg‘un{ $threshold ->
        [zero] {""}
       *[set] : o‘sish sur’ati { $limit } qiymatidan katta
    }. Chegaraning aniq joyi topilmadi; u yerda ko‘proq nuqta oling.

# O‘sish sur’atlari qanchalik ma’lum.
stability-map-all-counted = Ildizlar soni { $points ->
        [1] yagona nuqtada
       *[other] barcha { $points } ta nuqtada
    } argument prinsipi bo‘yicha { $frequency } chastotagacha tekshirilgan: { $threshold ->
        [zero] birorta ham o‘suvchi ildiz
       *[set] birorta ham { $limit } sur’atdan tez o‘suvchi ildiz
    } tushib qolmagan.
stability-map-not-all-counted = { $points } ta nuqtadan { $open } tasida { $threshold ->
        [zero] o‘suvchi ildizlar
       *[set] { $limit } sur’atdan tez o‘suvchi ildizlar
    } tushib qolgan bo‘lishi mumkin. Kichikroq frequency_limit yoki kattaroq growth_threshold qiymati sanashni osonlashtiradi.
stability-map-threshold-raised = { $value } sur’atdan sekin o‘sish { $part } modelining to‘lqinlari uchun aniqlanmaydi: ular boshqa joydagi har qanday so‘ndirishda sekin o‘sadi. Chegaraviy qiymat so‘ralgan { $requested } qiymatidan oshirilgan.
stability-map-undamped = { $machines ->
        [some] Xaritaning bir qismida
       *[all] Mashinada
    } so‘ndirish yo‘q: { $boundaries ->
        [none] moda o‘smaydigan joyda modalar so‘nmaydi ham
        [double] turg‘unlik chegaralari karrali ildizlar sifatida aniqlangan
       *[some] { $edges } ta turg‘unlik chegarasidan { $double } tasi karrali ildiz sifatida aniqlangan, qolganlari oraliq bilan chegaralangan
    }.
