# Bir tezlikda.
forced-response-amplitude = { $speed } tezlikda { $body } uchun amplituda { $value }.
forced-response-tilt = { $speed } tezlikda "{ $body }" jismining og‘ish burchagi { $value }.

# Rezonanslar.
forced-response-largest-resonance = Eng katta { $others ->
        [unbounded] chegaralangan rezonans
       *[none] rezonans
    } { $value } tezlikda: { $body } uchun amplituda { $amplitude }.{ $search ->
        [stopped] {" "}Bu hisob to‘xtaguncha topilganlarning eng kattasi.
       *[complete] {""}
    }
forced-response-largest-tilt-resonance = Og‘ish burchagining eng katta { $others ->
        [unbounded] chegaralangan rezonansi
       *[none] rezonansi
    } { $value } tezlikda: { $body } uchun amplituda { $amplitude }.{ $search ->
        [stopped] {" "}Bu hisob to‘xtaguncha topilganlarning eng kattasi.
       *[complete] {""}
    }
forced-response-undamped-resonance = { $value } tezlikda so‘nishsiz rezonans: { $body } uchun amplituda chegaralanmagan. So‘ndirish qo‘shing yoki bu tezlikdan qoching.
forced-response-other-undamped-resonance = { $value } tezlikda so‘nishsiz rezonans: amplituda chegaralanmagan. So‘ndirish qo‘shing yoki bu tezlikdan qoching.
forced-response-no-resonance = Bu oraliqda birorta ham jismda rezonans yo‘q.
forced-response-no-resonance-known = Javob ma’lum bo‘lgan joyda rezonans topilmadi.
forced-response-no-resonance-yet = Hisob to‘xtaguncha rezonans topilmadi.

# Javob qanchalik ma’lum va haqiqiy.
forced-response-frequency-only = Tezlik qadamidan ({ $step }) tor rezonanslar tushib qolgan bo‘lishi mumkin, turg‘unlik esa baholanmagan: qism faqat chastotalar sohasida berilgan.
forced-response-unknown = { $speeds } ta tezlikdan { $unknown } tasida javob noma’lum, birinchisi { $value }: u yerda qismning aniq reaksiyasi yo‘q.
forced-response-gap-closes = Tebranish { $speeds ->
        [one] { $value } tezlikda
       *[several] { $value } – { $last } oralig‘idagi tezliklarda
    } "{ $part }" qismining tirqishini (muvozanat holatida { $gap }) yopadi. Kontakt hisobga olinmagan, shuning uchun u yerda amplitudalar haqiqiy emas: nonlinear_response hisobidan foydalaning.
forced-response-validity = Haqiqiy emas: { $speed } tezlikda javob "{ $part }" qismining qo‘llanish sohasidan tashqarida, { $what } = { $value } (chegara 1).
forced-response-validity-unbounded = Haqiqiy emas: { $speed } tezlikda javob "{ $part }" qismining qo‘llanish sohasidan tashqarida, { $what } chegaralanmagan (chegara 1).

# Separation margins.
forced-response-margin-kept = Chastota zaxiralari saqlangan (API 684, SP6.8.2.10). Eng kichigi { $resonance } rezonansida: { $operating } dan { $value }, { $required } talab qilinadi ({ $body }, { $damped ->
        [yes] kuchaytirish koeffitsienti { $factor }
        [unknown] kuchaytirish koeffitsienti noma’lum
       *[no] so‘nishsiz
    }).
forced-response-margin-broken = Chastota zaxirasi kichik (API 684, SP6.8.2.10): { $resonance } rezonansi { $side ->
        [among] ish chastotalari orasida
       *[other] { $operating } dan { $value } masofada
    }, { $required } talab qilinadi ({ $body }, { $damped ->
        [yes] kuchaytirish koeffitsienti { $factor }
       *[no] so‘nishsiz
    }).
forced-response-margin-none = Bu diapazonda hech bir rezonans chastota zaxirasini talab qilmaydi (API 684, SP6.8.2.10): kuchaytirish koeffitsienti 2,5 dan kam bo‘lmagan rezonans yo‘q.{ $bounded ->
        [yes] {" "}Diapazon chetigacha javob cho‘qqining 0,707 qismidan yuqori qoladi: kuchaytirish koeffitsienti { $most } dan oshmaydi.
       *[no] {""}
    }
forced-response-margin-unknown = { $reason ->
        [stopped] Chastota zaxiralari aniqlanmadi (API 684, SP6.8.2.10): hisoblash to‘xtatildi.
        [range] Chastota zaxiralari aniqlanmadi (API 684, SP6.8.2.10): { $resonance } rezonansining yarim quvvat nuqtalari diapazondan tashqarida, shuning uchun uning kuchaytirish koeffitsienti noma’lum. Ish chastotalarigacha { $value }; { $required } gacha talab qilinishi mumkin. Diapazonni kengaytiring.
       *[neighbour] Chastota zaxiralari aniqlanmadi (API 684, SP6.8.2.10): yonidagi balandroq rezonans { $resonance } rezonansining yarim quvvat nuqtalarini yopib turadi, shuning uchun uning kuchaytirish koeffitsienti noma’lum. Ish chastotalarigacha { $value }; { $required } gacha talab qilinishi mumkin.
    }
forced-response-spin = Bu yerda "{ $spin }" aylanishi bilan aylanadigan qismlarning muvozanatsizligi ta’sir qiladi; aylanish chastotalari shu aylanishga tegishli.
forced-response-other-spins = { $spins } aylanishi bilan aylanadigan qismlarning muvozanatsizligi boshqa chastotada ta’sir qiladi va bu yerda hisobga olinmagan: spin maydonini alohida hisobda bering.

forced-response-shaft-vibration = { $part }: { $speed } da tebranish qulochi { $value }: { $standard ->
        [api_617] { $limit } chegarada (API 617)
       *[iso_7919_3] ISO 7919-3 bo‘yicha { $zone } zona; cheklovsiz uzoq ish { $limit } gacha
    }.
forced-response-shaft-vibration-broken = { $part }: { $speed } da tebranish qulochi { $value }, bu { $limit } chegaradan yuqori ({ $standard ->
        [api_617] API 617
       *[iso_7919_3] ISO 7919-3, { $zone } zona
    }). Rotorni aniqroq muvozanatlang, so‘ndirish qo‘shing yoki rezonansni siljiting.
forced-response-shaft-vibration-outside = Val tebranishi standarti { $speed } ni qamrab olmaydi.
forced-response-boundary = { $line ->
        [zone_ab] A/B zonalar
        [zone_bc] B/C zonalar
        [zone_cd] C/D zonalar
       *[api_limit] API 617
    }
