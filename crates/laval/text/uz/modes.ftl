# O‘sadigan modalar.
modes-unstable-mode = { $mode }-moda noturg‘un: { $whirl ->
        [none] statik noturg‘unlik (divergensiya)
        [forward] to‘g‘ri pretsessiya, chastotasi { $frequency }
        [backward] teskari pretsessiya, chastotasi { $frequency }
       *[vibration] tebranish, chastotasi { $frequency }
    }, o‘sish sur’ati { $value }.
modes-threshold = O‘sish sur’ati { $value } qiymatidan katta modalar noturg‘un hisoblanadi. Sekinroq to‘lqinlarning ({ $part } modeli) hammasi ham hisoblanmaydi.

# Eng sekin so‘nadigan moda.
modes-least-damped = { $among ->
        [found] Topilgan so‘nuvchi modalardan eng kam so‘nuvchisi
        [decaying] So‘nuvchi modalardan eng kam so‘nuvchisi
        [stable] Eng kam so‘nuvchi turg‘un moda
       *[all] Eng kam so‘nuvchi moda
    }{ $near ->
        [yes] {" "}(aylanish chastotasining o‘n baravarigacha)
       *[no] {""}
    }: { $mode }-moda, { $whirl }, chastotasi { $frequency }, { $damped ->
        [no] so‘nishsiz
       *[yes] nisbiy so‘nish { $value }, logarifmik dekrement { $decrement }
    }.

# Mashina turg‘unmi.
modes-stable = { $speed } tezlikda turg‘un: eng katta o‘sish sur’ati { $value }{ $threshold ->
        [zero] {""}
       *[set] , chegara { $limit }
    }.
modes-stable-below = { $speed } tezlikda { $frequency } chastotadan pastdagi modalar bo‘yicha turg‘un: eng katta o‘sish sur’ati { $value }.
modes-stable-between = { $speed } tezlikda { $from } – { $to } oralig‘idagi modalar bo‘yicha turg‘un: eng katta o‘sish sur’ati { $value }.
modes-stable-found = { $speed } tezlikda turg‘un: birorta ham moda o‘smaydi. Topilgan eng katta o‘sish sur’ati { $value }; sekinroq so‘nadigan moda tushib qolgan bo‘lishi mumkin.
modes-below-threshold = { $speed } tezlikda birorta ham moda { $limit } sur’atdan tez o‘smaydi: eng katta o‘sish sur’ati { $value }.
modes-below-threshold-found = { $speed } tezlikda birorta ham moda { $limit } sur’atdan tez o‘smaydi. Topilgan eng katta o‘sish sur’ati { $value }; sekinroq o‘sadigan yoki so‘nadigan moda tushib qolgan bo‘lishi mumkin.
modes-marginal = { $speed } tezlikda turg‘unlik chegarasida: { $lacks ->
        [stiffness] mashinani ushlab turuvchi bikrlik yo‘q
       *[damping] eng kam so‘nuvchi modaning so‘nishi nolga teng
    }.
modes-slow-growth = { $speed } tezlikda birorta ham moda { $limit } sur’atdan tez o‘smaydi, lekin { $slower ->
        [1] { $mode }-moda sekinroq o‘sadi
       *[other] { $slower } ta moda sekinroq o‘sadi
    }. To‘lqinlarning ({ $part } modeli) sekin o‘sishi aniqlanmagan; turg‘unlik isbotlanmagan.
modes-slow-growth-open = { $speed } tezlikda birorta ham moda { $limit } sur’atdan tez o‘smaydi. To‘lqinlarning ({ $part } modeli) sekin o‘sishi aniqlanmagan; turg‘unlik isbotlanmagan.
modes-stability-unknown = { $speed } tezlikda turg‘unlik isbotlanmagan: { $threshold ->
        [zero] o‘sadigan
       *[set] { $limit } sur’atdan tez o‘sadigan
    } moda topilmadi, lekin ba’zilari tushib qolgan bo‘lishi mumkin. Kichikroq frequency_limit yoki kattaroq growth_threshold qiymati qidirishni osonlashtiradi.

# Modalar qanday hisoblangan.
modes-massless = { $infinite } ta xos qiymat cheksiz: ba’zi koordinatalarning massasi yo‘q.
modes-polished = { $modes ->
        [1] Moda
       *[other] Barcha { $modes } ta moda
    } aniq xarakteristik funksiya bo‘yicha yechilgan.
modes-not-all-polished = { $modes } ta modadan { $polished } tasi aniq xarakteristik funksiya bo‘yicha yechilgan. Qolganlarining aniqligi pastroq.
modes-all-roots = O‘suvchi modalar tushib qolmagan: argument prinsipi bo‘yicha { $growing ->
        [0] o‘suvchi ildiz yo‘q
       *[other] { $growing } ta o‘suvchi ildiz bor
    }, topilgani ham shuncha. Barcha modalar aniq xarakteristik funksiyaning ildizlari.
modes-roots-missed = Argument prinsipi bo‘yicha { $growing ->
        [0] o‘suvchi ildiz yo‘q
       *[other] { $growing } ta o‘suvchi ildiz bor
    }, ammo { $found ->
        [0] birortasi ham topilmadi
       *[other] { $found } tasi topildi
    }. { $outcome ->
        [incomplete] Mashina noturg‘un va ro‘yxatda ba’zi o‘suvchi modalar yo‘q.
        [doubtful] Mashina noturg‘un, lekin o‘suvchi modalarning ba’zilari shubhali.
       *[stable] O‘suvchi modalar shubhali.
    }
modes-roots-not-counted = { $unstable ->
        [yes] Boshqa noturg‘un modalar
       *[no] Noturg‘un modalar
    } tushib qolgan bo‘lishi mumkin: o‘suvchi ildizlarni sanash bajarilmadi. Ro‘yxatdagi barcha modalar aniq xarakteristik funksiyaning ildizlari.
