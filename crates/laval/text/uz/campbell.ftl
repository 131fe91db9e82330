# Eng tez o‘sadigan moda.
campbell-unstable = { $mode }-moda noturg‘un: { $whirl ->
        [none] statik noturg‘unlik (divergensiya)
        [forward] to‘g‘ri pretsessiya, chastotasi { $frequency }
        [backward] teskari pretsessiya, chastotasi { $frequency }
       *[vibration] tebranish, chastotasi { $frequency }
    }, o‘sish sur’ati ko‘pi bilan { $value }, { $speed } tezlikda.

# Kritik aylanish chastotalari.
campbell-critical-speed = { $order }x kritik aylanish chastotasi { $value }: { $whirl }, { $damped ->
        [no] so‘nishsiz
       *[yes] nisbiy so‘nish { $damping }
    }.
campbell-critical-speed-not-located = { $order }x kritik aylanish chastotasi { $value } – { $to } oralig‘ida, lekin aniq joyi topilmadi. U yerda ko‘proq nuqta oling.
campbell-no-critical-speed = Bu oraliqda kritik aylanish chastotasi topilmadi.
campbell-no-critical-speed-yet = Hisob to‘xtaguncha kritik aylanish chastotasi topilmadi.

# Modalar qanchalik ma’lum.
campbell-ambiguous = Modalarni kuzatish tezlikning { $steps } ta qadamida bir qiymatli emas, birinchisi { $value } – { $to } oralig‘ida. U yerda modalar o‘rin almashgan bo‘lishi mumkin; ko‘proq nuqta oling.
campbell-slow-roots = Sekin to‘lqinlarning kritik aylanish chastotalari tushib qolgan bo‘lishi mumkin: mavhum o‘q yaqinidagi ildizlarning hammasi ham kuzatilmaydi. forced_response rezonanslari bilan solishtiring.
