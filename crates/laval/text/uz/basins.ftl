# Juftlikning boshlang‘ich qiymati; attraktor.
basins-initial-value = { $state } = { $value }
# Jo‘nalish shaklida: "... olib boradi" bilan ishlatiladi.
basins-attractor = { $attractor }-attraktorga
basins-irregular = { $turns } ta aylanish ichida takrorlanmaydigan harakatga

# Attraktorlar va ularning ulushlari.
basins-attractors = { $count ->
        [0] { $speed } tezlikda to‘rning birorta katagi ham { $turns } ta aylanish ichida takrorlanadigan harakatga olib bormaydi.
       *[other] { $speed } tezlikda to‘rdan boriladigan { $count } ta davriy attraktor topildi.
    }
basins-share = Kataklarning { $value } qismi { $attractor }-attraktorga olib boradi, u { $turns ->
        [1] har aylanishda
       *[other] { $turns } ta aylanishdan keyin
    } takrorlanadi.{ $quality ->
        [none] {""}
        [tilt] {" "}{ $point } uchun eng katta qiymat { $size }.
       *[displacement] {" "}{ $point } uchun eng katta siljish { $size }.
    }
basins-share-irregular = Kataklarning { $value } qismi { $turns } ta aylanish ichida takrorlanmaydigan harakatlarga, bitta yoki bir nechta attraktorga olib boradi.{ $quality ->
        [none] {""}
        [tilt] {" "}{ $point } uchun eng katta qiymat { $size }.
       *[displacement] {" "}{ $point } uchun eng katta siljish { $size }.
    }
basins-more-attractors = "attractors" jadvalida yana { $count } ta attraktor bor, ulushi kichikroq.

# G‘alayonlanmagan boshlang‘ich shart va boshqa joyga olib boradigan eng kichik g‘alayon.
basins-undisturbed = G‘alayonlanmagan boshlang‘ich shart ({ $place }) { $attractor } olib boradi.
basins-undisturbed-everywhere = G‘alayonlanmagan boshlang‘ich shart ({ $place }) { $attractor } olib boradi; to‘rning { $cells ->
        [settled] barqarorlashadigan barcha kataklari
       *[all] barcha kataklari
    } ham shu yerga olib boradi.
basins-undisturbed-not-settled = G‘alayonlanmagan boshlang‘ich shartdan ({ $place }) boshlangan harakat most_periods ichida barqarorlashmadi. Eng kichik g‘alayon keltirilmaydi; most_periods qiymatini oshiring.
basins-undisturbed-failed = G‘alayonlanmagan boshlang‘ich shartdan ({ $place }) boshlangan harakat { $reason }. Eng kichik g‘alayon keltirilmaydi.
basins-smallest-disturbance = To‘rda { $target } olib boradigan eng kichik g‘alayon { $scale ->
        [typical] { $value } xarakterli o‘lchamga teng
       *[same] { $value }
    } ({ $disturbed }). G‘alayonlanmagan boshlang‘ich shart ({ $place }) { $attractor } olib boradi.

# Attraktorsiz kataklar.
basins-unbounded = { $cells } ta katakdan { $count } tasida harakat cheksiz o‘sadi: u xarakterli siljishdan (1 mm) yoki og‘ish burchagidan (10 mrad) { $limit } martadan ham katta bo‘ladi. Mashina u yerdan qaytmaydi; g‘alayonni cheklang yoki so‘ndirish qo‘shing.
basins-failed-motions = { $cells } ta katakdan { $count } tasida harakat { $reason }. Bu kataklar hech bir attraktorga tegishli emas.
basins-not-settled = { $cells } ta katakdan { $count } tasida harakat most_periods ichida barqarorlashmadi. Bu kataklar hech bir attraktorga tegishli emas; most_periods qiymatini oshiring.
basins-settling-bounded = { $cells } ta katakdan { $count } tasida kuzatish eng sekin moda so‘nib bo‘lmasdan most_periods chegarasida to‘xtadi. Bu kataklar oxirgi aylanishlari bo‘yicha tasniflangan.
basins-growing = Muvozanat holati atrofidagi moda noturg‘un, o‘sish sur’ati { $growth }, shuning uchun barqarorlashish vaqti noma’lum. Takrorlanmaydigan harakatlar most_periods davomida ({ $turns } ta aylanish) kuzatiladi. So‘ndirish qo‘shing yoki xaritani kattaroq most_periods bilan tasdiqlang.
basins-neutral = Muvozanat holati atrofidagi moda so‘nmaydi ham, o‘smaydi ham, shuning uchun barqarorlashish vaqti noma’lum. most_periods ichida ({ $turns } ta aylanish) takrorlanmagan harakatlar barqarorlashmagan deb hisoblanadi. Bu modaga so‘ndirish qo‘shing.
basins-modes-unknown = Muvozanat holati atrofidagi modalar noma’lum, barqarorlashish vaqti ham noma’lum. Takrorlanmaydigan harakatlar most_periods davomida ({ $turns } ta aylanish) kuzatiladi. Xaritani kattaroq most_periods bilan tasdiqlang.

# Sharchali mashinalar.
basins-no-cell = To‘rning birorta katagi ham hisoblanmadi: hisob dastlabki integrallash vaqtida to‘xtatilgan.
basins-ends = { $count ->
        [0] { $speed } tezlikda to‘rning birorta katagi ham barqarorlashmaydi.
        [1] { $speed } tezlikda barqarorlashadigan barcha kataklar bir xil barqaror javobga keladi.
       *[other] { $speed } tezlikda to‘rdan { $count } xil barqaror javobga kelinadi.
    }
basins-end = Kataklarning { $value } qismi "{ $end }" holatida tugaydi.{ $unbalanced ->
        [yes] {" "}U yerda sharchalar rotorni balansirlamaydi; tezlikni o‘zgartiring yoki bu boshlang‘ich shartlardan qoching.
       *[no] {""}
    }
basins-end-moving = Kataklarning { $value } qismi "{ $end }" holatida tugaydi, o‘rtacha sirpanish tezliklari: { $rates }.{ $unbalanced ->
        [yes] {" "}U yerda sharchalar rotorni balansirlamaydi; tezlikni o‘zgartiring yoki bu boshlang‘ich shartlardan qoching.
       *[no] {""}
    }
basins-end-unstable = Kataklarning { $value } qismi "{ $end }" holatida tugaydi, holbuki u noturg‘un: masalan, sharchalar bir joydan boshlaganda shunday bo‘ladi. Eng kichik g‘alayon undan chiqarib yuboradi; sharchalarning boshlang‘ich shartlarini o‘zgartirib ko‘ring.
basins-recognition-none = Har bir harakat oxirigacha integrallandi.
basins-recognition = { $cells } ta katakdan { $count } tasida yakun harakat barqarorlashmasdan oldin aniqlandi. Oxirigacha integrallangan { $tried } ta sinov harakatidan { $wrong ->
        [0] birortasining ham yakuni noto‘g‘ri aniqlanmas edi
       *[other] { $wrong } tasining yakuni noto‘g‘ri aniqlangan bo‘lar edi
    }.{ $doubtful ->
        [yes] {" "}Ishonchli xarita uchun recognise = "never" qo‘ying.
       *[no] {""}
    }
basins-agreement = Tasodifiy tanlab, oxirigacha integrallangan barcha { $cells } ta katak xaritani tasdiqlaydi.
basins-agreement-at-boundaries = Tasodifiy tanlab, oxirigacha integrallangan { $cells } ta katakdan { $agree } tasi xaritani tasdiqlaydi. Qolganlari tortilish sohalari chegarasida.{ $doubtful ->
        [yes] {" "}Ishonchli xarita uchun recognise = "never" qo‘ying.
       *[no] {""}
    }
basins-agreement-inside = Tasodifiy tanlab, oxirigacha integrallangan { $cells } ta katakdan { $agree } tasi xaritani tasdiqlaydi. Qolganlaridan { $inside } tasi tortilish sohalari chegarasida emas. Ishonchli xarita uchun recognise = "never" qo‘ying.
