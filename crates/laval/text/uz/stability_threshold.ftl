# Stability over a cross-coupled stiffness.
stability-threshold-threshold = { $damped ->
        [no] { $place } nuqtasidagi har qanday kesishma bikrlik mashinani { $speed } da noturg‘un qiladi: { $mode }-moda, { $frequency } chastotadagi { $whirl }, so‘ndirilmagan.
       *[yes] { $place } nuqtasidagi { $value } kesishma bikrlik mashinani { $speed } da noturg‘un qiladi: { $mode }-moda, { $frequency } chastotadagi { $whirl }.
    }
stability-threshold-none = { $speed } da mashina { $place } nuqtasidagi { $value } kesishma bikrlikkacha turg‘un.
stability-threshold-unknown = { $speed } da { $place } nuqtasidagi { $value } kesishma bikrlikkacha chegara topilmadi; ungacha turg‘unlik isbotlanmagan.
stability-threshold-base = Kesishma bikrliksiz { $speed } da kuzatilgan modalarning eng kichik logarifmik dekrementi { $value }: { $mode }-moda, { $frequency } chastotadagi { $whirl }.
stability-threshold-unstable-without = { $speed } da mashina kesishma bikrliksiz ham noturg‘un: { $mode }-moda, { $frequency } chastotadagi { $whirl }, logarifmik dekrement { $value }.
stability-threshold-level-1 = 1-daraja bajarildi (API 684, SP6.8.5.10): kutilgan { $anticipated } bikrlikda birinchi to‘g‘ri moda ({ $mode }-moda) logarifmik dekrementi { $value }, kamida { $least_decrement } talab qilinadi; chegaraning kutilgan bikrlikka nisbati { $reached ->
        [yes] { $ratio }
       *[no] { $ratio } dan katta
    }, kamida { $least_ratio } talab qilinadi.{ $density ->
        [yes] {" "}Nisbat 10 dan past bo‘lganda gaz zichligi va chastotalar nisbati mezoni ham hisobga olinadi; u tekshirilmagan.
        [region] {" "}{ $region } Uchala mezon bajarildi.
       *[no] {""}
    }
stability-threshold-level-2 = 2-darajali tahlil kerak (API 684, SP6.8.5.10): kutilgan { $anticipated } bikrlikda birinchi to‘g‘ri moda ({ $mode }-moda) logarifmik dekrementi { $value }, kamida { $least_decrement } talab qilinadi; chegaraning kutilgan bikrlikka nisbati { $reached ->
        [yes] { $ratio }
       *[no] { $ratio } dan katta
    }, kamida { $least_ratio } talab qilinadi.{ $density ->
        [region] {" "}{ $region }
       *[other] {""}
    }
stability-threshold-level-open = 1-daraja hal qilinmadi (API 684, SP6.8.5.10): kutilgan { $anticipated } bikrlikda birinchi to‘g‘ri moda ({ $mode }-moda) logarifmik dekrementi { $value }; { $reached ->
        [yes] chegaraning unga nisbati { $ratio }.
        [uncounted] { $ratio } nisbatgacha o‘suvchi modalarni barcha chastotalarda sanab bo‘lmadi. Boshqalari ham noturg‘un bo‘lishi mumkin.
       *[no] { $ratio } nisbatgacha chegara topilmadi. up_to ni oshiring.
    }{ $density ->
        [region] {" "}{ $region }
       *[other] {""}
    }
stability-threshold-region = { $region ->
        [a] API 617 bo‘yicha A soha: { $gas_density } gaz zichligida aylanish chastotasining kritik aylanish chastotasiga nisbati { $critical_ratio }, ko‘pi bilan { $speed_ratio_limit } ruxsat etiladi. Qattiq tayanchlar: { $parts }.
        [b] API 617 bo‘yicha B soha chegaraning kutilgan bikrlikka nisbati 10 dan past bo‘lganda 2-darajani talab qiladi: { $gas_density } gaz zichligida aylanish chastotasining kritik aylanish chastotasiga nisbati { $critical_ratio }, { $speed_ratio_limit } dan katta. Qattiq tayanchlar: { $parts }.
       *[dense] API 617 bo‘yicha B soha chegaraning kutilgan bikrlikka nisbati 10 dan past bo‘lganda 2-darajani talab qiladi: gaz zichligi { $gas_density }, { $largest_density } dan katta, aylanish chastotasining kritik aylanish chastotasiga har qanday nisbatida.
    }
stability-threshold-region-open = Gaz zichligi va aylanish chastotasining kritik aylanish chastotasiga nisbati mezoni (API 617) tekshirilmadi: { $reason ->
        [rest] mashinaning muvozanati topilmadi.
        [supports] rotorni tutuvchi qism topilmadi. Tayanchlarni supports maydonida nomlang.
        [part] tayanchlardan boshqa bir qism massa, giroskopik va bikrlik matritsalari bilan berilmagan. U rotorni tutsa, uni supports maydonida nomlang.
        [missing] qattiq tayanchlardagi kritik aylanish chastotasi topilmadi.
        [uncertain] qattiq tayanchlardagi kritik aylanish chastotasi yaqinlashmadi.
       *[number] aylanish chastotasining kritik aylanish chastotasiga nisbati noma’lum.
    }
stability-threshold-counted = { $range ->
        [below] { $limit } chastotagacha
       *[all] Butun spektr bo‘yicha
    } { $stiffness } da o‘suvchi modalar soni: { $growing }, kuzatilgan { $followed } moda orasida ham shuncha (ko‘ndalang modalar jami { $modes }).
stability-threshold-missed = { $stiffness } da o‘suvchi, noturg‘unlik boshigacha kuzatilmagan modalar soni: { $missed }. points ni oshiring.
stability-threshold-not-counted = { $stiffness } da o‘suvchi modalarni sanab bo‘lmadi: boshqalari ham noturg‘un bo‘lishi mumkin.
stability-threshold-meeting = Ikki moda { $value } da karrali ildizda uchrashadi. Undan keyin ularning raqamlari shartli.
stability-threshold-lost = Eng katta bikrlikkacha kuzatilmagan modalar soni: { $modes }. points ni oshiring.

stability-threshold-curve = { $mode }-moda, { $frequency } chastotadagi { $whirl }
stability-threshold-alt = Kesishma bikrlikka bog‘liq logarifmik dekrement, modalar soni: { $modes }, chegaralar soni: { $thresholds }.
