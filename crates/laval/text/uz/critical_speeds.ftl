# Kritik aylanish chastotalari va ular yonidagi disbalansga javob.
critical-speeds-critical-speed = { $order }x kritik aylanish chastotasi { $value }: { $whirl }, { $damped ->
        [no] so‘nishsiz
       *[yes] nisbiy so‘nish { $damping }
    }.{ $response ->
        [peak] {" "}{ $body } uchun javob cho‘qqisi { $peak } tezlikda.
        [unbounded] {" "}U yerda { $body } uchun javob chegaralanmagan.
        [not_excited] {" "}Bu mashinada disbalans uni qo‘zg‘atmaydi.
        [no_peak] {" "}U yerda disbalansga javobning cho‘qqisi yo‘q.
       *[none] {""}
    }
critical-speeds-response-peak = Disbalansga javob cho‘qqisi { $value } tezlikda: { $body } uchun amplituda { $amplitude }. U yerda hech bir xususiy chastota aylanish tezligiga teng emas.
critical-speeds-response-unbounded = { $value } tezlikda { $body } uchun disbalansga javob chegaralanmagan. U yerda hech bir xususiy chastota aylanish tezligiga teng emas.
critical-speeds-none = Bu oraliqda kritik aylanish chastotasi topilmadi.
critical-speeds-peaks-alone = Bu oraliqda kritik aylanish chastotasi topilmadi: { $peaks ->
        [1] javob cho‘qqisida
       *[other] { $peaks } ta javob cho‘qqisida
    } hech bir xususiy chastota aylanish tezligiga teng emas.
critical-speeds-none-yet = Hisob to‘xtaguncha kritik aylanish chastotasi topilmadi.

# Ish tezligining eng yaqinidan uzoqligi.
critical-speeds-margin = Kritik chastotadan uzoqlik zaxirasi { $value }, talab { $required }: ish tezligi { $operating }, { $nearest ->
        [peak] eng yaqin javob cho‘qqisi
       *[critical_speed] kam so‘nuvchi eng yaqin { $order }x kritik aylanish chastotasi
    } { $critical }{ $located ->
        [no] , aniq joyi topilmagan
       *[yes] {""}
    }.{ $search ->
        [stopped] {" "}Bu hisob to‘xtaguncha topilganlarning eng yaqini.
       *[complete] {""}
    }{ $excited ->
        [no] {" "}Bu mashinaning disbalansi u yerda rezonansni qo‘zg‘atmaydi.
       *[yes] {""}
    }
critical-speeds-small-margin = Kritik chastotadan uzoqlik zaxirasi { $value } talab qilingan { $required } qiymatidan kichik: ish tezligi { $operating }, { $nearest ->
        [peak] eng yaqin javob cho‘qqisi
       *[critical_speed] kam so‘nuvchi eng yaqin { $order }x kritik aylanish chastotasi
    } { $critical }{ $located ->
        [no] , aniq joyi topilmagan
       *[yes] {""}
    }. Tezlikni, bikrlikni yoki so‘ndirishni o‘zgartiring.
critical-speeds-no-margin = Ish tezligi { $operating } { $nearest ->
        [peak] disbalansga javob cho‘qqisiga
       *[critical_speed] kam so‘nuvchi { $order }x kritik aylanish chastotasiga
    } to‘g‘ri keladi{ $located ->
        [no] , uning aniq joyi topilmagan
       *[yes] {""}
    }.{ $excited ->
        [no] {" "}Bu mashinaning disbalansi u yerda rezonansni qo‘zg‘atmaydi.
       *[yes] {""}
    }
