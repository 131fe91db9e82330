# Chiziqsiz qismlari bor mashinaning disbalansga barqaror javobi.

# Qaysi tarmoq; "tarmoq" so‘zidan oldin turadi.
nonlinear-response-branch = { $origin ->
        [low] past tezlikdan boshlangan
        [high] yuqori tezlikdan boshlangan
        [broken] { $speed } tezlikda boshlangan, simmetriyasi kamroq
        [doubled] { $speed } tezlikda boshlangan, davri ikkilangan
        [crossing] { $speed } tezlikda kesib o‘tuvchi
        [mixed] x va y bo‘yicha turli holatdagi
        [subharmonic] har { $turns } ta aylanishda takrorlanuvchi
       *[start] boshqalardan alohida
    }
# Tarmoqning qaysi qismi; xuddi shunday.
nonlinear-response-stretch = { $place ->
        [before] { $branch }, { $to } tezlikdagi buklanishgacha
        [beyond] { $branch }, { $from } tezlikdagi buklanishdan keyin
        [between] { $branch }, { $from } va { $to } tezliklardagi buklanishlar orasida
       *[whole] { $branch }
    }
nonlinear-response-more-ranges = yana { $n } ta oraliqda

# Tarmoq nega tugagan. To‘liq gaplar.
nonlinear-response-end = { $why ->
        [work-limit] Ish chegarasiga yetildi.
        [range] U yerda tezlik oralig‘i tugaydi.
        [points] Nuqtalarning eng katta soniga yetildi; max_points qiymatini oshiring.
        [cancelled] Hisob so‘rov bo‘yicha to‘xtatildi.
        [closed] Tarmoq o‘z-o‘ziga tutashadi.
        [start] Boshlang‘ich shart yaqinlashmadi.
        [undefined] U yerda tenglamalar aniqlanmagan: { $cause }.
        [infinite] U yerda kuch yoki uning hosilasi chekli qiymatga ega emas; qism o‘z oralig‘idan tashqarida ishlatilgan.
        [singular] U yerda tenglamalarning yagona yechimi yo‘q: koordinata bog‘lanmagan yoki tarmoqlar kesishadi.
        [sharp] U yerda tarmoq juda keskin buriladi; ko‘proq garmonika saqlang yoki keskin kuch qonunini silliqlang.
        [strayed] Undan naridagi eng yaqin yechim boshqa tarmoqqa tegishli; tezlik oralig‘ini uning atrofida toraytiring.
        [resonance] U yerda jismning harakati juda tez o‘zgaradi, so‘nishsiz rezonansdagi kabi; jismlarga so‘ndirish qo‘shing.
        [unbounded] Amplituda deyarli o‘zgarmas tezlikda cheksiz o‘sadi, so‘nishsiz rezonansdagi kabi; so‘ndirish qo‘shing.
       *[unsolved] Undan nariga tenglamalarni yechib bo‘lmadi; ko‘proq garmonika saqlang yoki keskin kuch qonunini silliqlang.
    }

# Javob tarmoqlar bo‘ylab boradigan darajada sekin tezlashish va sekinlashish.
nonlinear-response-jump = Kvazistatik { $way ->
        [up] tezlashish
       *[down] sekinlashish
    }: javob { $value } tezlikda { $again ->
        [no] sakraydi
       *[yes] yana sakraydi
    }{ $onto ->
        [none] {""}
       *[other] , o‘tadigan tarmog‘i: { $onto }
    }.
nonlinear-response-jump-unstable-before = Bu sakrashdan oldin javob { $ranges } noturg‘un; mashina u yerda undan chetlashishi mumkin.
nonlinear-response-jump-landing = { $stable ->
        [0] Sakrashdan keyingi hisoblangan holatlarning birortasi ham turg‘un emas; u yerdagi harakatni `transient` hisobi ko‘rsatadi.
       *[other] Sakrashdan keyin { $stable } ta holat turg‘un; qaysi biriga kelinishini `basins` hisobi ko‘rsatadi.
    }
nonlinear-response-no-jump = Kvazistatik { $way ->
        [up] tezlashish
       *[down] sekinlashish
    } { $from } tezlikdan { $to } tezlikkacha: sakrash yo‘q{ $amplitude ->
        [rising] , lekin oraliq oxirida amplituda hali o‘sadi
       *[other] {""}
    }.
nonlinear-response-no-fold = Kvazistatik { $way ->
        [up] tezlashish
       *[down] sekinlashish
    } { $from } tezlikdan { $to } tezlikkacha: buklanish yo‘q, lekin javob { $ranges } noturg‘un.
nonlinear-response-sweep-unfinished = Kvazistatik { $way ->
        [up] tezlashish
       *[down] sekinlashish
    }: tarmoq faqat { $value } tezlikkacha kuzatildi. Undan naridagi sakrashlar noma’lum. { $why }
nonlinear-response-sweep-not-followed = Kvazistatik { $way ->
        [up] tezlashish
       *[down] sekinlashish
    }: tarmoqlar kuzatilmadi. { $why }
nonlinear-response-sweep-unstable = Kvazistatik { $way ->
        [up] tezlashish
       *[down] sekinlashish
    }: { $value } tezlikdagi buklanish sakrashga olib kelmaydi, chunki undan oldin javob { $ranges } noturg‘un. U yerdagi harakatni `transient` hisobi ko‘rsatadi.
nonlinear-response-sweep-unknown = Kvazistatik { $way ->
        [up] tezlashish
       *[down] sekinlashish
    }: uning birinchi tezligida ({ $value }) davriy yechim topilmadi. Boshqa tezlikdan boshlang yoki states = "all" qo‘ying.
nonlinear-response-start-not-followed = Oraliq chetidagi { $value } tezlikdagi yechimga oraliqdan tashqaridan kuzatib kelib bo‘lmadi. Shu tezlikka keltirilgan mashinaning javobi boshqacha bo‘lishi mumkin; oraliqni kengaytiring.
nonlinear-response-two-branches = Ikkita alohida tarmoq topildi: biri past tezlikdan, ikkinchisi yuqori tezlikdan boshlanadi. Qaysi biri amalga oshishi tezlikning oldingi o‘zgarishiga bog‘liq.
nonlinear-response-branch-unfinished = { $value } tezlikdan nariga kuzatilmagan tarmoq: { $branch }; { $folds ->
        [1] buklanishdan
       *[other] buklanishlardan
    } keyin u faqat shu joygacha kuzatilgan. { $why }

# Yuqori tarmoq oraliqdan nariga davom etadi.
nonlinear-response-not-closed = Yuqori tarmoq oraliq oxiriga, { $speed } tezlikka, buklanishsiz yetadi: amplituda { $value }, quyi tarmoqda { $lower }. Oraliq oxiri sakrash emas.
nonlinear-response-beyond = { $beyond ->
        [closes] Oraliqdan nariga davom ettirilganda tarmoq { $at } tezlikda buklanadi; u yerda javob sakraydi.
        [stays] So‘ndirish u yerda disbalans bera oladigan quvvatning { $share } qismini, yuqori tezlikda { $limit } qismini sochadi. Buklanish 100 % bo‘lganda yuz beradi, shuning uchun bu tarmoqda buklanish yo‘q.
        [rises] So‘ndirish u yerda disbalans bera oladigan quvvatning { $share } qismini, yuqoriroq tezlikda undan ko‘pini sochadi. Buklanish 100 % bo‘lganda, bu tezlikning { $reach } barobaridan yuqorida yuz beradi.
        [lost] So‘ndirish u yerda disbalans bera oladigan quvvatning { $share } qismini sochadi; buklanish 100 % bo‘lganda yuz beradi. Tarmoqni faqat { $at } tezlikkacha davom ettirib bo‘ldi.
       *[unknown] So‘ndirish u yerda disbalans bera oladigan quvvatning { $share } qismini sochadi; buklanish 100 % bo‘lganda yuz beradi.
    }

# Boshqa holatlarni qidirish.
nonlinear-response-further-states = Boshqa holatlar ({ $kind }): { $branches } ta tarmoq, { $value } – { $to } oralig‘ida, { $stability ->
        [some] { $low } – { $high } oralig‘ida qisman turg‘un
        [none] butunlay noturg‘un
       *[unknown] turg‘unligi noma’lum
    }.
nonlinear-response-copies = { $kind ->
        [turned] Har bir tarmoq ko‘pi bilan { $copies } ta simmetrik nusxani ifodalaydi.
       *[later] Har bir tarmoq ko‘pi bilan { $copies } ta nusxani ifodalaydi: ular mashina simmetriyasi bo‘yicha burilgan yoki rotorning bir aylanishiga kechikkan.
    }
nonlinear-response-no-further-states = { $starts ->
        [0] Aralash va subgarmonik
       *[other] Aralash, subgarmonik va tasodifiy
    } boshlang‘ich shartlardan boshqa holatlar topilmadi. Qidirish to‘liq qamrovli emas.
nonlinear-response-families-left-out = Holatlar oilalarining hammasi ham kuzatilmadi. Qolganlarini ko‘rish uchun tezlik oralig‘ini toraytiring.
nonlinear-response-search-not-begun = Boshqa holatlarni qidirish boshlanmadi, chunki asosiy tarmoqlar to‘liq emas. Boshqa holatlar istisno emas.
nonlinear-response-search-stopped = Boshqa holatlarni qidirish to‘liq emas: { $all-speeds } ta tezlikdan { $speeds } tasi va { $all-starts } ta tasodifiy boshlang‘ich shartdan { $starts } tasi sinaldi. Boshqa holatlar tushib qolgan bo‘lishi mumkin.
nonlinear-response-search-in-time = { $all-starts } ta boshlang‘ich shartdan { $starts } tasi vaqt bo‘yicha integrallandi.

# Eng katta qiymatlar.
nonlinear-response-largest = Eng katta barqaror siljish { $value } ({ $body }), { $place ->
        [end] oraliq chetida, { $speed } tezlikda
       *[inside] { $speed } tezlikda
    }.
nonlinear-response-largest-at-left-end = Uning tarmog‘i faqat shu joygacha kuzatildi; undan narida kattaroq siljishlar istisno emas.
nonlinear-response-largest-left = Uning tarmog‘i faqat { $left } tezlikkacha kuzatildi; undan narida kattaroq siljishlar istisno emas.
nonlinear-response-largest-of = { $body } uchun eng katta barqaror siljish { $value }, { $speed } tezlikda.
nonlinear-response-largest-tilt = "{ $body }" jismining eng katta barqaror og‘ish burchagi { $value }, { $speed } tezlikda.
nonlinear-response-not-reached = { $body } uchun eng katta barqaror { $quality ->
        [tilt] og‘ish burchagiga
       *[displacement] siljishga
    } yetilmadi: { $speed } tezlikda u { $value } va o‘smoqda; bu yerda tarmoq ({ $branch }) kuzatuvi tugagan.
nonlinear-response-unbounded = { $body } uchun barqaror { $quality ->
        [tilt] og‘ish burchagi
       *[displacement] siljish
    } chegaralanmagan: { $speed } tezlikda u { $value } va o‘smoqda; bu yerda tarmoq ({ $branch }) kuzatuvi tugagan. So‘ndirish qo‘shing.
nonlinear-response-largest-force = "{ $part }" qismining eng katta barqaror kuchi { $value }, { $speed } tezlikda.
nonlinear-response-largest-force-left = Javob oxirigacha kuzatilmadi; kattaroq kuchlar istisno emas.
nonlinear-response-antiresonance = Antirezonans: "{ $part }" qismining kuchi { $value } tezlikda { $force } qiymatigacha kamayadi, bu yonidagi kichikroq maksimumning { $share } qismi.
nonlinear-response-tuning = Sozlash: "{ $body }" jismining bikrligi hozirgi { $stiffness } o‘rniga { $value } bo‘lsa, { $speed } tezlikda "{ $part }" qismining kuchi quyi tarmoqda { $before } o‘rniga { $after } bo‘lar edi.
nonlinear-response-tuned = { $stability ->
        [stable] Sozlangan javob turg‘un.
        [unstable] Sozlangan javob noturg‘un, o‘sish sur’ati { $growth }; so‘ndirishni oshirmay poydevorni sozlamang.
       *[unknown] Sozlangan javobning turg‘unligi baholanmagan.
    }
nonlinear-response-self-centring = O‘z-o‘zidan markazlashish: "{ $body }" jismining amplitudasi yuqori tezlikda { $value } qiymatiga intiladi. { $speed } tezlikda u { $amplitude }, amplituda va faza bo‘yicha farq { $difference }.
nonlinear-response-centred = Farq { $from } tezlikdan boshlab { $close } qiymatidan kichik.
nonlinear-response-centred-beyond = Ekstrapolyatsiyaga ko‘ra farq { $from } tezlikda { $close } qiymatidan kichik bo‘ladi.
nonlinear-response-centring-unstable = { $speed } tezlikda javob noturg‘un.
nonlinear-response-force-limit = Quyi tarmoqda "{ $part }" qismining kuchi yuqori tezlikda { $value } qiymatiga intiladi.

# Turg‘unlik.
nonlinear-response-unstable = Noturg‘un tarmoq: { $stretch }; u { $ranges } noturg‘un. Eng katta o‘sish sur’ati { $value }, { $speed } tezlikda. Bu tezliklardan qoching yoki so‘ndirish qo‘shing.
nonlinear-response-stability = Tezlik ortganda tarmoq ({ $stretch }) { $place ->
        [located] { $value } tezlikda
       *[bracketed] { $value } tezlik yaqinida, { $from } – { $to } oralig‘ida,
    } { $way ->
        [lost] noturg‘un bo‘ladi
       *[gained] turg‘un bo‘ladi
    }: { $event }.
nonlinear-response-event = { $kind ->
        [neimark-sacker] Neymark–Saker bifurkatsiyasi, undan yuqorida { $frequency } chastotali tebranish { $way ->
            [lost] o‘sadi
           *[gained] so‘nadi
        }
        [torus] Neymark–Saker bifurkatsiyasi, undan yuqorida ikkinchi chastotali tebranish { $way ->
            [lost] o‘sadi
           *[gained] so‘nadi
        }
        [period-doubling] davr ikkilanishi, ketma-ket davrlar farq qiladi
        [symmetry-breaking] simmetriya buzilishi, simmetriyasi kamroq holatlar ajralib chiqadi
       *[branch-point] tarmoqlanish nuqtasi, boshqa tarmoq kesib o‘tadi
    }
nonlinear-response-more-bifurcations = Yana { $more } ta bifurkatsiya jadvalda keltirilgan.
nonlinear-response-stability-checked = { $states } ta holatning turg‘unligi simmetriyadan foydalanmaydigan ikki usul bilan tekshirildi; o‘sish sur’atlari ko‘pi bilan { $value } farq qiladi.
nonlinear-response-stability-contradicted = Yana ikki usul turg‘unlik natijasiga { $checks } ta solishtirishdan { $contradictions } tasida zid keladi; o‘sish sur’atlari { $value } qiymatigacha farq qiladi. Turg‘unlikni isbotlanmagan deb hisoblang.
nonlinear-response-stability-not-checked = Turg‘unlik ikkinchi usul bilan tekshirilmagan: { $why }.
nonlinear-response-nothing-checked = Turg‘unlik ikkinchi usul bilan tekshirilmagan: birorta ham holat qayta baholanmadi.
nonlinear-response-stability-not-requested = Turg‘unlik so‘ralmagan, holatlar noturg‘un bo‘lishi mumkin. stability = true qo‘ying.
nonlinear-response-stability-reduced = Turg‘unlikni baholash uchun chiziqli qismlar { $coordinates } ta koordinataga keltirildi. { $frequency } chastotagacha ularning nochiziqli qismlardagi moyilligi butun mashinanikidan { $value } ga farq qiladi.
nonlinear-response-stability-unknown = Holatlarning turg‘unligi baholanmagan: { $why }. Ular noturg‘un bo‘lishi mumkin.
nonlinear-response-stability-partly-unknown = { $all } ta holatdan { $unknown } tasining turg‘unligi baholanmagan: { $why }. Ular noturg‘un bo‘lishi mumkin.
# Turg‘unlik nega baholanmagan.
nonlinear-response-unassessed = { $why ->
        [no-time-form] "{ $part }" qismining vaqt sohasidagi shakli yo‘q: { $cause }
        [states] mashinada { $states } ta birinchi tartibli holat bor, bu monodromiya matritsasi uchun ruxsat etilganidan ko‘p
        [massless] koordinataning massasi yo‘q
        [jumps] "{ $part }" qismining kuchi tegish paytida sakraydi, bunday sakrashning g‘alayonga ta’siri hisoblanmaydi
       *[failed] { $cause }
    }
nonlinear-response-stability-fit = Turg‘unlik "{ $part }" qismining vaqt sohasidagi approksimatsiyalangan shakli bilan baholangan; holatlarning o‘zi aniq.
nonlinear-response-determinant = { $states } ta holatning turg‘unligi aniq impedanslar bilan Hill determinanti bo‘yicha baholandi. { $value } sur’atdan tez o‘suvchi ko‘rsatkichlar sanalgan; so‘nuvchilarining faqat ba’zilari ma’lum.
nonlinear-response-balls-elsewhere = Hisoblangan holatlarning birortasi ham turg‘un emas. Sharchalarning boshqa holatlari bor; `stationary`, `transient` yoki `basins` hisobidan foydalaning.

# Qo‘llanish sohasi.
nonlinear-response-harmonics = Saqlangan garmonikalar eng yomon nuqtada chiziqsiz kuchning { $value } qismini hisobga olmaydi. Harakatning keskin tafsilotlari aniqlanmagan; kuch qonunlarining siniq joylarini silliqlang.
nonlinear-response-no-number = "{ $part }" qismi ba’zi holatlarda chekli kuch bermaydi. U yerda javob haqiqiy emas.

# Sinxron tartibdan boshqa tartiblar.
nonlinear-response-no-orders = Birorta ham jismning sub- yoki supergarmonik amplitudasi { $limit } qiymatidan oshmaydi.
nonlinear-response-order-range = "{ $body }" jismining { $divisor ->
        [1] { $order }
       *[other] { $order }/{ $divisor }
    } tartibli { $kind ->
        [superharmonic] supergarmonikasi
        [subharmonic] subgarmonikasi
       *[component] tashkil etuvchisi
    } { $limit } qiymatidan oshadi, { $extent ->
        [all] { $value } – { $to } oralig‘ida, butun tarmoqda ({ $branch })
        [inside] { $value } – { $to } oralig‘ida, tarmoq: { $branch }
        [begins] { $to } tezlikkacha; tarmoq ({ $branch }) { $value } tezlikda boshlanadi
       *[ends] { $value } tezlikdan boshlab; tarmoq ({ $branch }) { $to } tezlikda tugaydi
    }. Eng katta qiymati { $largest }, { $speed } tezlikda, { $sense ->
        [forward] to‘g‘ri pretsessiya
        [backward] teskari pretsessiya
       *[line] to‘g‘ri chiziq bo‘ylab
    }.
nonlinear-response-more-orders = { $limit } qiymatidan oshadigan yana { $more } ta tartib oralig‘i maxsus nuqtalar qatorida keltirilgan.

# Bitta tezlik.
nonlinear-response-no-motion = { $speed } tezlikda davriy yechim topilmadi. U yerdagi harakatni `transient` hisobi ko‘rsatadi.
nonlinear-response-no-motion-stopped = Hisob to‘xtaguncha { $speed } tezlikda davriy yechim topilmadi.
nonlinear-response-all-unstable = { $speed } tezlikda topilgan { $count ->
        [1] yagona davriy yechim
       *[other] barcha { $count } ta davriy yechim
    } noturg‘un. U yerdagi harakatni `transient` hisobi ko‘rsatadi.
nonlinear-response-steady = { $speed } tezlikda { $body } uchun eng katta { $quality ->
        [tilt] og‘ish burchagi
       *[displacement] siljish
    } { $value }{ $count ->
        [1] {""}
       *[other] , { $count } ta yechimdan { $number }-yechimda
    }. { $stability ->
        [stable] Javob turg‘un.
        [unstable] Javob noturg‘un.
       *[unknown] Javobning turg‘unligi noma’lum.
    }
nonlinear-response-period = U { $turns } ta aylanishdan keyin takrorlanadi.
nonlinear-response-no-excitation = Mashinani hech narsa qo‘zg‘atmaydi.
