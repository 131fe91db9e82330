# Tezlik bo‘yicha balansirlash holatlari.

stationary-hindered = "{ $part }" qismi: { $reason }.
stationary-no-balls = Bu mashinada sharchalar yo‘q. Uning holatlari nonlinear_response hisobidagi kabi sinxron javobdir.
stationary-insufficient-capacity = Sharchalar ko‘pi bilan { $value } disbalansni yo‘qota oladi, bu mavjud disbalansdan { $missing } kam. Og‘irroq yoki ko‘proq sharcha ishlating.

# Holat turlari.
stationary-kind = { $kind ->
        [balanced] balansirlangan
        [partly_balanced] qisman balansirlangan
        [reduced] disbalans kamaygan
        [touching] sharchalar bir-biriga tegib turadi
        [together] sharchalar birgalikda
        [opposed] sharchalar qarama-qarshi
        [spread] sharchalar alohida
       *[single] sinxron holat
    }
# To‘liq yoki qisman balansirlaydigan holatlar.
stationary-state = { $kind ->
        [balanced] balansirlangan holat
        [partly_balanced] qisman balansirlangan holat
       *[reduced] disbalansi kamaygan holat
    }
stationary-continuum-of = { $kind ->
        [balanced] balansirlangan holatlar kontinuumi
        [partly_balanced] qisman balansirlangan holatlar kontinuumi
       *[reduced] disbalansi kamaygan holatlar kontinuumi
    }
stationary-sample = { $kind ->
        [balanced] balansirlangan holatlar kontinuumidagi bitta holat
        [partly_balanced] qisman balansirlangan holatlar kontinuumidagi bitta holat
       *[reduced] disbalansi kamaygan holatlar kontinuumidagi bitta holat
    }

# Tezlik oraliqlari.
stationary-stable = { $branch }-tarmoq ({ $kind }) { $from } – { $value } oralig‘ida turg‘un.
stationary-stable-throughout = { $branch }-tarmoq ({ $kind }) butun tezlik oralig‘ida, { $from } – { $value } oralig‘ida turg‘un.
stationary-continuum = { $from } – { $value } oralig‘ida holatlar kontinuumi topildi: { $kind }, { $free } ta erkin yo‘nalish. Uning turg‘unligi namunalar bo‘yicha baholanadi.
stationary-continuum-stable = Kontinuumning ba’zi holatlari { $from } – { $value } oralig‘ida turg‘un: { $kind }. Uning turg‘unligi namunalar bo‘yicha baholanadi.
stationary-no-state = Tezlik oralig‘ida sinxron holat topilmadi. starts qiymatini oshiring yoki transient hisobini bajaring.
stationary-no-stable-state = { $from } – { $value } oralig‘ida turg‘un sinxron holat topilmadi. { $balls ->
        [yes] Sharchalar sirpanadi, mashina pretsessiya qiladi yoki biror holat tushib qolgan;
       *[no] Mashina pretsessiya qiladi yoki biror holat tushib qolgan;
    } u yerda transient hisobini bajaring.
stationary-not-balanced = { $from } – { $value } oralig‘ida balansirlangan yoki qisman balansirlangan holat topilmadi. { $capacity ->
        [used] Sharchalar u yerda juda yengil; og‘irroq sharchalar ishlating yoki tez o‘ting.
       *[left] Bu oraliqdan tez o‘ting.
    }
stationary-harm = { $from } – { $to } oralig‘ida sharchalar disbalansni { $value } martagacha oshiradi: { $branch }-tarmoq, { $kind }. U yerda sharchalarni ushlab turing yoki tez o‘ting.
stationary-harm-of-balanced = { $from } – { $to } oralig‘ida sharchalar rotorda ko‘pi bilan { $value } disbalans hosil qiladi: { $branch }-tarmoq, { $kind }. Sharchalarsiz rotor balansirlangan; ularni olib tashlang yoki ushlab turing.
stationary-coexistence = { $speeds ->
        [1] { $from } tezlikda
       *[other] Jadvalning { $speeds } ta tezligida, { $from } – { $to } oralig‘ida,
    } balansirlangan holat ham, balansirlanmagan holat ham turg‘un. Boshlang‘ich shart hal qiladi; basins hisobini bajaring.

# Ish tezligidagi eng yaxshi holat.
stationary-residual-unbalance = { $speed } tezlikda topilgan eng yaxshi turg‘un holat ({ $kind }) qoldiradigan disbalans { $value }{ $beside ->
        [times] , bu sharchalarsiz disbalansning { $times } barobari
        [nothing] , holbuki sharchalarsiz disbalans yo‘q
       *[none] {""}
    }.
stationary-dead-zone = { $speed } tezlikda quruq ishqalanish ko‘pi bilan { $value } disbalans qoldiradi{ $effect ->
        [more] , bu sharchalarsizdan ko‘p
       *[less] {""}
    }. U sharchalarni { $angle } burchakkacha ushlab turadi (sanoq boshi: { $state }).{ $held ->
        [unstable] {" "}Sharchalar ushlab turilganda mashina noturg‘un; ishqalanishni kamaytiring.
       *[stable] {""}
    }
stationary-dead-zone-open = { $speed } tezlikda { $value } quruq ishqalanish sharchalarni topilgan oraliqlardan tashqarida ham ushlab turadi. Hisoblanganidan ko‘proq disbalans qolishi mumkin; ishqalanishni kamaytiring.
stationary-dead-zone-continuum = { $speed } tezlikda { $continuum } yonida quruq ishqalanish { $value } yoki undan ko‘p disbalans qoldirishi mumkin.

# Parametr bo‘yicha balansirlangan holat.
stationary-least-no-state = { $speed } tezlikda { $parameter } parametrining { $lowest } – { $highest } oralig‘idagi { $sought } ta qiymatida balansirlangan yoki qisman balansirlangan holat topilmadi. Oraliqni kengaytiring yoki starts qiymatini oshiring.
stationary-least-unstable = { $speed } tezlikda { $state } { $parameter } parametrining { $lowest } – { $highest } oralig‘ida hisoblangan { $computed ->
        [1] yagona qiymatida
       *[other] barcha { $computed } ta qiymatida
    } noturg‘un.{ $reach ->
        [none] {""}
       *[other] {" "}{ $reach }
    } Oraliqni kengaytiring yoki boshqa parametrni o‘zgartiring.
stationary-least-above = { $speed } tezlikda { $state } { $parameter } parametri { $value } qiymatidan oshganda turg‘un bo‘ladi.{ $ends ->
        [none] {""}
        [open] {" "}U { $to } qiymatigacha turg‘un qoladi.
        [exists] {" "}U { $to } qiymatigacha turg‘un qoladi va u yerda tugaydi.
        [half] {" "}U { $to } qiymatigacha turg‘un qoladi, u yerda disbalansning yarmi qoladi.
       *[lost] {" "}U { $to } qiymatigacha, kuzatilgan joygacha, turg‘un qoladi.
    }{ $ranges }
stationary-least-from-limit = { $speed } tezlikda { $state } { $parameter } parametri { $value } qiymatidan oshganda { $begins ->
        [exists] mavjud va turg‘un.
        [half] turg‘un, bu qiymatda disbalansning yarmi qoladi.
       *[lost] turg‘un, u shu joygacha kuzatilgan.
    }{ $ends ->
        [none] {""}
        [open] {" "}U { $to } qiymatigacha turg‘un qoladi.
        [exists] {" "}U { $to } qiymatigacha turg‘un qoladi va u yerda tugaydi.
        [half] {" "}U { $to } qiymatigacha turg‘un qoladi, u yerda disbalansning yarmi qoladi.
       *[lost] {" "}U { $to } qiymatigacha, kuzatilgan joygacha, turg‘un qoladi.
    }{ $ranges }
stationary-least-between = { $speed } tezlikda { $state } { $parameter } parametrining { $value } – { $to } oralig‘ida, hisoblangan joylarda, turg‘un.{ $ranges }
stationary-least-everywhere = { $speed } tezlikda { $state } { $parameter } parametrining { $lowest } – { $highest } oralig‘ida hisoblangan { $computed ->
        [1] yagona qiymatida
       *[other] barcha { $computed } ta qiymatida
    } turg‘un.
stationary-least-outside = { $speed } tezlikda { $state } { $parameter } parametri { $to } qiymatidan oshguncha turg‘un{ $ends ->
        [exists] {" "}(u yerda holat tugaydi)
        [half] {" "}(u yerda disbalansning yarmi qoladi)
        [lost] {" "}(shu joygacha kuzatilgan)
       *[open] {""}
    } va { $value } qiymatidan oshganda yana turg‘un.{ $ranges }
stationary-least-below = { $speed } tezlikda { $state } { $parameter } parametri { $value } qiymatidan oshguncha turg‘un{ $ends ->
        [exists] , u yerda holat tugaydi
        [half] , u yerda disbalansning yarmi qoladi
        [lost] , shu joygacha kuzatilgan
       *[open] {""}
    }.{ $ranges }
# Gapdan keyin, holat bir necha oraliqda turg‘un bo‘lganda.
stationary-least-ranges = { $ranges ->
        [1] {""}
       *[other] {" "}U { $parameter } parametrining { $ranges } ta oralig‘ida turg‘un.
    }
stationary-exists = U mavjud: { $ends }.
stationary-followed = U kuzatilgan: { $ends }.
stationary-down-to = pastda { $end } qiymatigacha{ $why ->
        [exists] , u yerda tugaydi
        [half] , u yerda disbalansning yarmi qoladi
       *[other] {""}
    }
stationary-up-to = yuqorida { $end } qiymatigacha{ $why ->
        [exists] , u yerda tugaydi
        [half] , u yerda disbalansning yarmi qoladi
       *[other] {""}
    }

# Parametr xatolari va diagramma.
stationary-cost = { $speed } tezlikda topilgan eng yaxshi turg‘un holat qoldiradigan disbalans { $parameter } = { $from } bo‘lganda { $first }, { $to } bo‘lganda { $value }. Sharchalarsiz u { $without }.{ $effect ->
        [harm] {" "}Bunda sharchalar disbalansni oshiradi; dopuskni toraytiring.
        [lost] {" "}Bunda rotor endi balansirlangan emas; dopuskni toraytiring.
       *[none] {""}
    }
stationary-cost-no-stable-state = { $speed } tezlikda { $parameter } = { $value } bo‘lganda{ $more ->
        [larger] {" "}va hisoblangan { $larger } ta kattaroq qiymatda
        [some] , jami { $computed } ta qiymatdan { $none } tasida
       *[none] {""}
    } turg‘un holat topilmadi. Dopuskni toraytiring yoki transient hisobini bajaring.
stationary-chart = Tezlik va { $parameter } parametri xaritasining { $value } ta katagidan { $balanced } tasi balansirlangan, { $bistable } tasi bistabil, { $unbalanced } tasi balansirlanmagan. { $unstable } tasida turg‘un holat topilmadi.

# Qidirish qanchalik to‘liq.
stationary-completeness = Qidirish qamrovi: yaqinlashgan boshlang‘ich shartlarning { $value } qismi ma’lum holatga keldi.{ $stopped ->
        [yes] {" "}Hisob to‘xtaguncha
       *[no] {" "}Jami
    } { $branches ->
        [0] birorta ham tarmoq topilmadi
       *[other] { $branches } ta tarmoq topildi
    }.
stationary-too-many-branches = Holat tarmoqlari hisob kuzatadigandan ko‘p. Ro‘yxat to‘liq emas; tezlik oralig‘ini toraytiring.
stationary-unfinished = Oxirigacha kuzatilmagan: { $branches }. Undan naridagi holatlar tushib qolgan bo‘lishi mumkin.
stationary-branch-near = { $branch }-tarmoq ({ $speed } tezlik yaqinida)
stationary-more = yana { $count } ta

# Bitta tezlik.
stationary-states = { $speed } tezlikda { $states ->
        [1] topilgan yagona holat turg‘un
       *[other] topilgan { $states } ta holatdan { $stable } tasi turg‘un
    }.
stationary-states-unstable = { $speed } tezlikda { $states ->
        [1] topilgan yagona holat noturg‘un
       *[other] topilgan barcha { $states } ta holat noturg‘un
    }. U yerdagi harakat uchun transient hisobini bajaring.
stationary-states-none = { $speed } tezlikda sinxron holat topilmadi. starts qiymatini oshiring yoki transient hisobini bajaring.
