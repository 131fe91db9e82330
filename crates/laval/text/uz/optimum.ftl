# Topilgan eng yaxshi mashina.
optimum-best = Chegaralar ichida{ $search ->
        [stopped] {" "}hisob to‘xtaguncha
       *[complete] {""}
    } topilgan { $kind ->
        [speed] "{ $aim }" kattaligining { $extreme ->
            [largest] eng katta tezligi yoki chastotasi
           *[smallest] eng kichik tezligi yoki chastotasi
        }
       *[other] "{ $aim }" kattaligining { $extreme ->
            [largest] eng katta qiymati
           *[smallest] eng kichik qiymati
        }
    } { $value }.{ $present ->
        [change] {" "}Hozirgi mashinada { $now }: o‘zgarish { $change }.
        [value] {" "}Hozirgi mashinada { $now }.
       *[none] {""}
    }
optimum-recommended = { $search ->
        [stopped] Hisob to‘xtaguncha topilgan eng yaxshisi
       *[complete] Tavsiya etiladi
    }: { $parameter } = { $value }. Hozirgi mashinada { $now }.{ $bound ->
        [lower] {" "}Bu quyi chegara; chegara pastroq bo‘lsa, mashina yaxshiroq bo‘lishi mumkin.
        [upper] {" "}Bu yuqori chegara; chegara yuqoriroq bo‘lsa, mashina yaxshiroq bo‘lishi mumkin.
       *[none] {""}
    }{ $slope ->
        [rises] {" "}Chegara tomon "{ $aim }" kattaligi har { $step } uchun { $rate } ortadi.
        [falls] {" "}Chegara tomon "{ $aim }" kattaligi har { $step } uchun { $rate } kamayadi.
       *[none] {""}
    }{ $range ->
        [whole] {" "}"{ $aim }" kattaligi butun { $from } – { $to } oralig‘ida eng yaxshi qiymatdan ko‘pi bilan { $tolerance } farq qiladi.
        [lower] {" "}"{ $aim }" kattaligi { $from } (quyi chegara) – { $to } oralig‘ida eng yaxshi qiymatdan ko‘pi bilan { $tolerance } farq qiladi.
        [upper] {" "}"{ $aim }" kattaligi { $from } – { $to } (yuqori chegara) oralig‘ida eng yaxshi qiymatdan ko‘pi bilan { $tolerance } farq qiladi.
        [inside] {" "}"{ $aim }" kattaligi { $from } – { $to } oralig‘ida eng yaxshi qiymatdan ko‘pi bilan { $tolerance } farq qiladi.
       *[none] {""}
    }

# Boshqa kattaliklar chegaralari.
optimum-limit-reached = "{ $number }" kattaligi { $side ->
        [upper] yuqori
       *[lower] quyi
    } chegarasiga ({ $limit }) yetadi. Chegarani yumshatish mashinani yaxshilashi mumkin.
optimum-limit-kept = "{ $number }" kattaligi { $value }, { $side ->
        [upper] yuqori
       *[lower] quyi
    } chegarasi ({ $limit }) doirasida.

# Optimumni qo‘shni mashinalar bilan tekshirish.
optimum-neighbours-worse = { $count } ta qo‘shni mashinadan birortasi ham yaxshiroq emas.{ $limits ->
        [some] {" "}Chegaradan oshish yomonroq deb hisoblanadi.
       *[none] {""}
    }
optimum-neighbours-alike = Qidirish yaqinlashgan: { $count } ta qo‘shni mashinaning eng yaxshisi atigi { $better } yaxshiroq.{ $limits ->
        [some] {" "}Chegaradan oshish yomonroq deb hisoblanadi.
       *[none] {""}
    }
optimum-neighbour-better = Qidirish yaqinlashmagan: { $count } ta qo‘shni mashinaning eng yaxshisi { $better } yaxshiroq. Ko‘proq hisoblashga ruxsat bering.
optimum-neighbour-without = Optimum tekshirilmagan: qo‘shni mashinada "{ $aim }" kattaligi yo‘q. Chegaralarni bunday mashinalardan uzoqlashtiring.
optimum-searches-cut = { $searches } ta qidirishdan { $count } tasi barcha { $runs } ta hisoblashni yaqinlashmasdan sarflab bo‘ldi. Ishonchliroq natija uchun ko‘proq hisoblashga ruxsat bering.
optimum-outside-validity = Tavsiya etilgan mashinaning natijasi model qo‘llanish sohasidan tashqarida.

# Mashina topilmadi.
optimum-none = { $search ->
        [stopped] Hisob to‘xtaguncha, { $runs } ta hisoblashda, "{ $aim }" kattaligi bor mashina topilmadi.
       *[complete] Sinalgan mashinalarning birortasida ham "{ $aim }" kattaligi yo‘q. Chegaralarni o‘zgartiring.
    }
optimum-none-in-limits = { $search ->
        [stopped] Hisob to‘xtaguncha, { $runs } ta hisoblashda, chegaralarni bajaradigan mashina topilmadi.
       *[complete] Sinalgan mashinalarning birortasi ham chegaralarni bajarmaydi. Oraliqlarni kengaytiring yoki biror chegarani yumshating.
    }
