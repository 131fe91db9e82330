# Tezlik va parametr tekisligidagi bifurkatsiya chiziqlari.

bifurcation-loci-kind = { $kind ->
        [neimark-sacker] Neymark–Saker bifurkatsiyasi
        [period-doubling] davr ikkilanishi
        [symmetry-breaking] simmetriya buzilishi
        [branch-point] tarmoqlanish nuqtasi
       *[fold] buklanish
    }

# Chiziqlarning burilish nuqtalari.
bifurcation-loci-cusp = { $parameter } = { $value } bo‘lganda { $speed } tezlikda ikki buklanish qaytish nuqtasida yo‘qoladi; ular faqat { $side ->
        [above] bu qiymatdan yuqorida
       *[below] bu qiymatdan pastda
    } mavjud.
bifurcation-loci-folds-meet = { $parameter } = { $value } bo‘lganda { $speed } tezlikda ikki buklanish uchrashadi; ular faqat { $side ->
        [above] bu qiymatdan yuqorida
       *[below] bu qiymatdan pastda
    } mavjud. U yerda ajralgan tarmoq boshlanadi yoki tarmoqlar qismlarini almashadi.
bifurcation-loci-extremum = { $locus }-chiziq ({ $kind }) { $parameter } = { $value } bo‘lganda { $speed } tezlikda orqaga qaytadi; u faqat { $side ->
        [above] bu qiymatdan yuqorida
       *[below] bu qiymatdan pastda
    } joylashgan.

# Buklanishlar va gisterezis.
bifurcation-loci-folds = Buklanishlar { $parameter } parametrining { $value } – { $largest } oralig‘ida, { $place } topildi. Quyi chegara: { $below }; yuqori chegara: { $above }.{ $stopped ->
        [yes] {" "}Hisob to‘xtatilgan; boshqalari ham bo‘lishi mumkin.
       *[no] {""}
    }
bifurcation-loci-limit = { $limit ->
        [cusp] qaytish nuqtasi
        [folds-meet] buklanishlar uchrashadigan nuqta
        [range] oraliqning oxiri
       *[left] { $stopped ->
            [yes] chiziq tezlik oralig‘idan chiqadi, erta tugaydi yoki to‘xtatilgan
           *[no] chiziq tezlik oralig‘idan chiqadi yoki erta tugaydi
        }
    }
bifurcation-loci-widest-hysteresis = Gisterezis { $parameter } = { $at } bo‘lganda eng keng: kengligi { $value }, { $lower } tezlikdan boshlanadi.{ $cut ->
        [yes] {" "}U yerda buklanish tezlik oralig‘idan chiqadi; gisterezis undan nariga davom etadi.
       *[no] {""}
    }{ $stopped ->
        [yes] {" "}Hisob to‘xtatilgan; boshqalari ham bo‘lishi mumkin.
       *[no] {""}
    }

# Alohida chiziqlar.
bifurcation-loci-fold-locus = { $locus }-chiziq, buklanishlar: { $course }.
bifurcation-loci-stability-locus = { $locus }-chiziq, { $kind }: { $course }.{ $whirl ->
        [yes] {" "}U yerda pretsessiya chastotasi { $lowest } – { $highest } oralig‘ida.
       *[no] {""}
    }{ $others ->
        [all] {" "}Butun chiziq bo‘ylab boshqa ko‘rsatkichlar noturg‘un.
        [part] {" "}Chiziqning bir qismida boshqa ko‘rsatkichlar noturg‘un; bu qism turg‘un holatlarni chegaralamaydi.
       *[none] {""}
    }
bifurcation-loci-closed = yopiq egri chiziq
bifurcation-loci-from-to = boshi { $from }; oxiri { $to }
bifurcation-loci-end = { $value } qiymati, { $speed } tezlikda ({ $end ->
        [value] parametr oralig‘ining oxiri
        [speed] tezlik oralig‘ining oxiri
        [points] nuqtalar soni chegarasi
        [stopped] hisob to‘xtatilgan joy
       *[stuck] chiziq erta tugagan joy
    })
bifurcation-loci-unfinished = { $locus }-chiziq { $parameter } = { $value } bo‘lganda { $speed } tezlikda erta tugaydi: { $why }. Undan naridagi bifurkatsiyalar tushib qolgan bo‘lishi mumkin.
bifurcation-loci-none = { $parameter } parametrining { $values } ta qiymatidagi javobda{ $stopped ->
        [yes] {" "}hisob to‘xtaguncha
       *[no] {""}
    }{ $beside ->
        [lost] {" "}kuzatish mumkin bo‘lgan
       *[none] {""}
    } { $sought ->
        [both] buklanish ham, turg‘unlikning boshqa o‘zgarishi ham topilmadi
        [folds] buklanish topilmadi
       *[stability] turg‘unlikning buklanishlardan tashqari o‘zgarishi topilmadi
    }.{ $stopped ->
        [yes] {""}
       *[no] {" "}Boshqa qiymatlarda chiziqlar bo‘lishi mumkin; points qiymatini oshiring.
    }{ $beside ->
        [folds] {" "}{ $folds } ta buklanish so‘ralmagan.
       *[none] {""}
    }

# Nima tashlab ketilgan.
bifurcation-loci-starts-lost = Hisoblangan javoblardagi { $count } ta bifurkatsiyadan boshlab chiziqni kuzatib bo‘lmadi. Chiziqlar tushib qolgan bo‘lishi mumkin; points qiymatini oshiring.
bifurcation-loci-no-response = { $count ->
        [1] { $parameter } = { $first } bo‘lganda
       *[other] { $parameter } parametrining { $count } ta qiymatida (birinchisi { $first })
    } javob hisoblanmadi: { $why }. U yerdagi chiziqlar tushib qolgan bo‘lishi mumkin.
bifurcation-loci-corners = { $count } ta buklanish harakat davomida kuch qonuni o‘zgaradigan joyda, masalan kontakt yopiladigan joyda yotadi. Bunday buklanishlar kuzatilmaydi.
bifurcation-loci-more = Chiziqlar { $most } tadan ko‘p; qolganlari kuzatilmadi. Tezlik oralig‘ini toraytiring.
bifurcation-loci-stability-unknown = Ba’zi yoki barcha holatlar uchun turg‘unlik hisoblanmadi: { $why }. Turg‘unlik o‘zgarishi chiziqlari tushib qolgan bo‘lishi mumkin.
bifurcation-loci-harmonics-short = Saqlangan garmonikalar chiziqlarning eng yomon nuqtasida chiziqsiz kuchning { $value } qismini hisobga olmaydi. harmonics qiymatini oshiring.
bifurcation-loci-parameter-range = { $parameter } parametri { $value } qiymatidan { $side ->
        [below] kichik
       *[above] katta
    } bo‘lganda mashina mavjud emas; oraliqning bu qismi tashlab ketildi: { $why }.
