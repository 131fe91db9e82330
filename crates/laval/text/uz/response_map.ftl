# Ikki parametr bo‘yicha chiziqsiz javob.

response-map-place = { $first } = { $x }, { $second } = { $y }
response-map-failed = { $machines } ta mashinadan { $count } tasida, masalan { $at } bo‘lganda, javob yo‘q: { $why }.
response-map-branches-left = { $machines } ta mashinadan { $count } tasida erta tugagan tarmoq bor, xaritaning end ustuniga qarang. Undan naridagi cho‘qqilar va sakrashlar tushib qolgan bo‘lishi mumkin.
response-map-peaks-not-reached = { $machines } ta mashinadan { $count } tasining xaritada cho‘qqisi yo‘q: tarmoq erta tugagan joyda siljish yoki og‘ish burchagi hali o‘sadi.

# Sakrashlar va gisterezis.
response-map-jumping = { $jumping ->
        [none] { $known ->
            [1] Yagona mashina bu tezlik oralig‘ida sakramaydi
           *[other] { $known } ta mashinadan birortasi ham bu tezlik oralig‘ida sakramaydi
        }.
        [all] { $known ->
            [1] Yagona mashina bu tezlik oralig‘ida sakraydi
           *[other] Barcha { $known } ta mashina bu tezlik oralig‘ida sakraydi
        }{ $down ->
            [0] {""}
           *[other] , ulardan { $down } tasi faqat sekinlashishda
        }.
       *[some] { $known } ta mashinadan { $count } tasi bu tezlik oralig‘ida sakraydi{ $down ->
            [0] {""}
           *[other] , ulardan { $down } tasi faqat sekinlashishda
        }.
    }
response-map-widest-hysteresis = Eng keng gisterezis { $value }, { $at } bo‘lganda.{ $open ->
        [yes] {" "}U tezlik oralig‘idan nariga davom etadi.
       *[no] {""}
    }

# Cho‘qqilar.
response-map-largest-peak = Eng katta cho‘qqi { $value }, { $speed } tezlikda, { $at } bo‘lganda.{ $end ->
        [yes] {" "}U tezlik oralig‘ining chetida va undan narida o‘sishi mumkin.
       *[no] {""}
    }
response-map-smallest-peak = Eng kichik cho‘qqi { $value }, { $speed } tezlikda, { $at } bo‘lganda.{ $end ->
        [yes] {" "}U tezlik oralig‘ining chetida va undan narida o‘sishi mumkin.
       *[no] {""}
    }
response-map-largest-tilt = Eng katta og‘ish burchagi { $value }, { $speed } tezlikda, { $at } bo‘lganda.

# Turg‘unlik va qo‘llanish sohasi.
response-map-stability-not-requested = Turg‘unlik hisoblanmagan, ko‘rsatilgan holatlar noturg‘un bo‘lishi mumkin. stability = true qo‘ying.
response-map-stability-unknown = { $machines } ta mashinadan { $count } tasining ba’zi holatlari uchun turg‘unlik noma’lum: { $why }. Ko‘rsatilgan holatlar noturg‘un bo‘lishi mumkin.
response-map-unstable = { $machines } ta mashinadan { $count } tasida ikki buklanish orasida yotmaydigan noturg‘un holatlar bor. Eng katta o‘sish sur’ati { $value }, { $at } bo‘lganda.
response-map-neimark-sacker = { $machines } ta mashinadan { $count } tasida Neymark–Saker bifurkatsiyasi bor: javob ikki chastotali harakatga aylanadi.
response-map-symmetry-breaking = { $machines } ta mashinadan { $count } tasida javobning simmetriyasi buziladigan bifurkatsiya bor.
response-map-period-doubling = { $machines } ta mashinadan { $count } tasida javobning davri ikkilanadi.
response-map-outside-validity = Haqiqiy emas: { $what }. { $machines } ta mashinadan { $count } tasining ba’zi holatlari chegaraning { $value } barobariga yetadi.
response-map-outside-validity-unbounded = Haqiqiy emas: { $what }. { $machines } ta mashinadan { $count } tasining ba’zi holatlari uchun u chegaralanmagan.
