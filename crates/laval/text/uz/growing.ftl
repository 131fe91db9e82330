# Javob yoki kritik aylanish chastotalari keltirilgan joyda mashina noturg‘un.
growing-unstable = Mashina { $place ->
        [one] { $from } tezlikda
        [all] hisoblangan barcha tezliklarda, { $from } – { $to } oralig‘ida
        [single] hisoblangan { $computed } ta tezlikdan birida, { $from } tezlikda
       *[several] hisoblangan { $computed } ta tezlikdan { $unstable } tasida, { $from } – { $to } oralig‘ida
    } noturg‘un. O‘sish sur’ati { $place ->
        [one] { $value }
        [single] { $value }
       *[several] ko‘pi bilan { $value } ({ $speed } tezlikda)
    }, { $motion ->
        [divergence] statik noturg‘unlik (divergensiya)
       *[whirl] pretsessiya chastotasi { $frequency }
    }. { $follows ->
        [response] U yerdagi amplitudalar va rezonanslar noturg‘un yechimga tegishli: avval noturg‘unlikni bartaraf qiling.
       *[speeds] Kritik aylanish chastotalari va uzoqlik zaxiralari u yerda qo‘llanmaydi: avval noturg‘unlikni bartaraf qiling.
    }
