# Grafiklar, jadvallar va hisob yakuni uchun iboralar.

# Jism yoki qismga tegishli kattalik: "eng katta og‘ish burchagi (drum)". Egasi mashina faylidagi nom.
label-of = { $what } ({ $owner })
# Jismning nuqtasi.
label-point = { $body }, { $height } balandlik
# The same in front of a number.
named-point = { $body } ({ $height } balandlikda)
# Kattalik va unga izoh: "orbitaning katta yarim o‘qi; harakat hisoblanmagan joyda NaN".
label-noted = { $what }; { $note }
# Qo‘yilmagan belgi: "turg‘un emas".
label-not = { $what } emas
# O‘qning oralig‘i bor belgi: "noturg‘un 100 – 120".
label-between = { $label } { $from } – { $to }
# Aylanish tezligining karralisi.
label-order = { $order }×
label-mode = { $number }-moda
label-operating-margin = ish tezligi ± { $margin }

# Chiziqli hisoblar.
campbell-alt = Aylanish tezligi bo‘yicha { $modes } ta modaning chastotalari va o‘sish sur’atlari, { $criticals } ta kritik aylanish chastotasi bilan.{ $above ->
        [0] {""}
       *[other] {" "}O‘qdan yuqorida, { $top } qiymatidan narida: yana { $above } ta moda.
    }
stability-map-operating = ish tezligi: { $growth }
stability-map-alt = Aylanish tezligi bo‘yicha eng katta o‘sish sur’ati va u chegaradan oshadigan oraliqlar. Pastda shu modaning chastotasi; uzilish boshqa modaga o‘tishni bildiradi.
stability-map-alt-parameter = { $speed } tezlikda { $parameter } parametri bo‘yicha eng katta o‘sish sur’ati.
stability-map-alt-map = Aylanish tezligi va { $parameter } parametri bo‘yicha eng katta o‘sish sur’ati, turg‘unlik chegarasi bilan.
modes-table = Xususiy modalar, qaysi holat atrofida: { $state }
modes-alt = { $speed } tezlikda { $modes } ta modaning chastota bo‘yicha o‘sish sur’atlari.
approximation-degree = { $degree }-daraja
approximation-alt = Kulrang chiziqlar: mashinaning aylanish tezligi bo‘yicha chastotalari va o‘sish sur’atlari. Nuqtalar: uning { $degree }-darajali taqribiy modeliniki.
forced-response-amplification = kuchaytirish koeffitsiyenti { $factor }
forced-response-alt = Aylanish tezligi bo‘yicha { $bodies } ta jismning amplitudalari{ $bounded ->
        [no] , { $speed } tezlikda chegaralanmagan
        [none] , rezonanssiz
       *[yes] ; eng katta rezonans { $speed } tezlikda
    }.

# Sentrifugalar.
operating-window-alt = Aylanish tezligi bo‘yicha barcha talablarning zaxiralari va ularning hammasi bajariladigan oraliqlar.
operating-window-alt-none = Aylanish tezligi bo‘yicha barcha talablarning zaxiralari. Har bir tezlikda ulardan biri buzilgan.
operating-window-alt-time = Aylanish tezligi bo‘yicha ajratish vaqti va mavjud vaqt.
operating-window-alt-trade = Mavjud vaqt bo‘yicha oynaning eng past va eng yuqori tezligi.
operating-window-alt-map = Aylanish tezligi va { $parameter } parametri bo‘yicha eng kichik zaxira. Egri chiziq oynaning chetini ko‘rsatadi.
operating-window-table-map = Aylanish tezligi va { $parameter } parametri bo‘yicha eng kichik zaxira (ajratish ko‘pi bilan { $places } ta joydan)
separation-table-demand = Tezlik bo‘yicha zarralarning { $share } qismini ajratish vaqti
separation-alt-efficiency = Vaqt bo‘yicha zarralarning ajratilgan qismi, mavjud vaqt va talab qilingan qism bilan.
separation-alt-grade = Zarra diametri bo‘yicha mavjud vaqt ichida ajratilgan qism.
separation-alt-demand = Aylanish tezligi bo‘yicha talab qilingan qismni ajratish vaqti.
separation-alt-pellet = Zarralar suyuqlikdan chiqadigan joylar: barcha zarralarning ulushi, devor uchun stakan bo‘ylab, tub va sirt uchun uning o‘qidan masofa bo‘yicha.
separation-alt-paths-bowl = Baraban o‘qlarida ba’zi zarralarning yo‘llari: tashqariga siljish bo‘yicha suyuqlikka nisbatan aylanish yo‘nalishidagi siljish.
separation-alt-paths-cup = Stakan o‘qlarida ba’zi zarralarning yo‘llari: stakan ko‘ndalangi bo‘yicha va aylanish yo‘nalishida, sirtdan (chapda) tubgacha (o‘ngda).
separation-alt-paths-time = Vaqt bo‘yicha ba’zi zarralarning aylanish o‘qidan masofasi, ular suyuqlikdan chiqquncha yoki mavjud vaqt tugaguncha.
separation-alt-released = Vaqt bo‘yicha qo‘yib yuborilgan zarraning joyi va uning stakanining og‘ish burchagi.

# Parametrlarni o‘rganish.
optimum-alt-search = { $searches } ta qidirishning hisoblashlari bo‘yicha "{ $aim }" kattaligining eng yaxshi qiymati.
optimum-title-profile = Optimum atrofida: { $parameter }
optimum-alt-profile = Optimum orqali { $parameter } parametri bo‘yicha "{ $aim }" kattaligi, boshqa parametrlar eng yaxshi qiymatlarida.
optimum-worse = { $share } yomonroq
sensitivity-place-peak = { $speed } tezlikdagi cho‘qqi ({ $point })
sensitivity-place-jump = { $speed } tezlikda { $way ->
        [up] yuqoriga
       *[down] pastga
    } sakrash
sensitivity-title = Ta’sir: { $place }
sensitivity-alt = Eng muhim { $count } ta parametrning nisbiy ta’siri, har biriga bir juft ustun.
sensitivity-table-bars = Grafik ustunlari: { $quality ->
        [speed] tezlikka
        [tilt] og‘ish burchagiga
       *[displacement] siljishga
    } ta’sir, { $place }
uncertainty-table-histogram = { $quantity } kattaligining gistogrammasi: har bir ustunning ikkala uchi
uncertainty-table-distribution = { $quantity } kattaligining qiymatidan kichik namunalar ulushi
uncertainty-table-bars = Grafik ustunlari: { $kind }, { $quantity } kattaligi
uncertainty-title-distribution = { $quantity } kattaligining taqsimoti ({ $samples } ta namuna{ $alike ->
        [0] {""}
       *[other] , bir xil sonlar: { $alike }
    })
uncertainty-alt-distribution = { $samples } ta namuna bo‘yicha { $quantity } kattaligining gistogrammasi, { $low } – { $high } oralig‘ida.
uncertainty-title-indices = { $quantity } kattaligining sezgirlik indekslari
uncertainty-title-effects = { $quantity } kattaligiga elementar ta’sirlar
uncertainty-alt-bars = { $quantity } kattaligiga ta’sir: { $parameters } ta parametrning har biriga bittadan ustun.
uncertainty-share-of-variance = dispersiyadagi ulush, { $samples } ta namunadan{ $rough ->
        [yes] : taxminiy baho
       *[no] {""}
    }
uncertainty-quantile = { $share } kvantil

# Chiziqsiz hisoblar.
nonlinear-response-alt = Tezlik bo‘yicha har bir jismning eng katta siljishi, { $branches } ta tarmoqda, { $folds ->
        [0] buklanishsiz
       *[other] { $folds } ta buklanish bilan
    }{ $largest ->
        [known] ; eng kattasi { $value } ({ $point }), { $speed } tezlikda
       *[unknown] {""}
    }.
nonlinear-response-alt-jumps = Buklanishlar yaqinidagi eng katta siljish, kattalashtirilgan.
nonlinear-response-alt-forces = Tezlik bo‘yicha { $parts } ta qismning davr ichidagi eng katta kuchi.
nonlinear-response-alt-orders = Aylanish tezligi bo‘yicha sub- va supergarmonik tartiblarning katta yarim o‘qlari ({ $bodies }), chegara bilan.
nonlinear-response-limit = { $part }, yuqori tezlik
nonlinear-response-map-evidence = butun davr akslantirishi, aniqlik { $tolerance }: holatlar
backbone-begins = { $origin ->
        [mode] { $frequency } chastotadan boshlanadi
       *[asymptote] { $frequency } chastota yonida
    }
backbone-alt = { $speed } tezlikda pretsessiya chastotasi bo‘yicha deformatsiya amplitudasi, { $families } ta oila.
methods-alt = Aylanish tezligi bo‘yicha har bir usulning yaqinlashgan cho‘qqidan chetlanishi, barcha holatlar.
limit-cycles-alt = Aylanish tezligi bo‘yicha limit sikllarning eng katta siljishi va chastotasi: muvozanat noturg‘unligining { $edges } ta chetidan boshlangan { $families } ta oila.
bifurcation-loci-alt = Aylanish tezligi va { $parameter } parametri tekisligidagi chiziqlar: buklanishlar { $folds } ta, turg‘unlikning boshqa o‘zgarishlari { $others } ta, { $cusps ->
        [0] qaytish nuqtasi yo‘q
       *[other] qaytish nuqtalari { $cusps } ta
    }.
response-map-alt = { $x } va { $y } bo‘yicha { $what ->
        [peak] eng katta turg‘un siljish
        [tilt] eng katta turg‘un og‘ish burchagi
        [hysteresis] bir nechta holat bo‘lgan tezliklar kengligi (holat yagona joyda bo‘sh)
       *[sweeps] sekin tezlashish va sekinlashish natijasi
    }{ $border ->
        [yes] , sakrashi bor va sakrashi yo‘q mashinalar chegarasi bilan
       *[no] {""}
    }.
stationary-alt-range = { $state }: { $from } – { $to }
stationary-alt = Aylanish tezligi bo‘yicha aylanuvchi sanoq sistemasidagi muvozanat holatlarining { $branches } ta tarmog‘i; { $stable ->
        [0] birorta ham muvozanat holati turg‘un emas
       *[other] turg‘un: { $ranges }
    }.
stationary-title-stabilised = { $speed } tezlikda balansirlangan holatning o‘sish sur’ati
stationary-alt-stabilised = { $parameter } parametri bo‘yicha balansirlangan holatning eng katta o‘sish sur’ati.
stationary-title-chart = Tezlik va { $parameter } parametri bo‘yicha balansirlangan holat
stationary-alt-chart = Aylanish tezligi va { $parameter } parametri bo‘yicha turg‘un holatlarning balansirlanishi, balansirlangan holatning aniqlangan chegarasi bilan.
stationary-title-errors = { $speed } tezlikda qolgan disbalans
stationary-alt-errors = { $parameter } parametri bo‘yicha eng yaxshi va eng yomon turg‘un holat qoldiradigan disbalans, shuningdek sharchalarsiz disbalans.
stationary-table-stabilised = { $speed } tezlikda { $parameter } parametri bo‘yicha balansirlangan holatning eng katta o‘sish sur’ati
stationary-table-chart = Tezlik va { $parameter } parametri bo‘yicha balansirlangan holat va turg‘un holatlar
stationary-table-errors = { $speed } tezlikda { $parameter } parametri xatolari keltirib chiqaradigan disbalans
stationary-class = { $word ->
        [balanced] balanslangan
        [partly_balanced] qisman balanslangan
        [reduced] disbalansi kamaygan
        [touching] sharchalar tegib turgan
        [together] sharchalar bir joyda
        [opposed] sharchalar qarama-qarshi
        [spread] sharchalar ajralgan
       *[single] muvozanat holati
    }
stationary-change = { $word ->
        [fold] tarmoq qaytadi (buklanish)
        [branch_point] tarmoqlar kesishadi
        [hopf] tebranish boshlanadi (Xopf)
       *[real_root] turg‘unlik o‘zgaradi
    }
stationary-growing-roots = o‘suvchi ildizlar, { $side ->
        [before] undan oldin
       *[behind] undan keyin
    }{ $several ->
        [yes] , { $branch }-tarmoq
       *[no] {""}
    }

# Vaqt bo‘yicha harakatlar.
history-table-last-turns = Oxirgi { $turns } ta aylanish davomida jismlarning harakati, har birida { $samples } ta nuqta
history-alt-envelope = Vaqt bo‘yicha har bir jismning aylanish ichida muvozanat holatidan eng katta siljishi.
history-alt-lateral = Vaqt bo‘yicha har bir jismning x va y siljishlari.
history-alt-orbit = Har bir jismning tekislikdagi yo‘li, masshtabda; boshida nuqta, yo‘nalishida strelka.
history-alt-energy = Vaqt bo‘yicha saqlangan energiyaning boshidan o‘zgarishi, issiqlik va mashina ustida bajarilgan ish. Pastda energiya balansining xatosi.
balance-alt = Vaqt bo‘yicha sharchalar bilan va sharchalarsiz disbalans, sharchalar imkoniyati va balansirlash aniqligi sinfi.
balance-alt-angles = Vaqt bo‘yicha rotordagi burchaklar, −180° dan 180° gacha: sharchalarniki tugun chizig‘idan, erkin halqalarniki og‘ish burchagi.
run-up-alt-drive = Vaqt bo‘yicha aylanish tezligi, yuritma momenti va quvvati.
run-up-alt-envelope = Aylanish tezligi bo‘yicha har bir jismning aylanish ichida muvozanat holatidan eng katta siljishi.
spectra-alt = "{ $body }" jismining { $along ->
        [speed] aylanish tezligi
       *[time] vaqt
    } va { $over ->
        [order] tartib
       *[frequency] chastota
    } bo‘yicha amplitudalari. Musbat qiymatlar to‘g‘ri, manfiylari teskari pretsessiya.
sweep-alt = Aylanish tezligi bo‘yicha har bir jismning eng katta siljishi yoki og‘ish burchagi (boshlanishi: { $ways }).
sweep-alt-bifurcation = Aylanish tezligi bo‘yicha nol fazadagi { $state }: davrning har bir aylanishi uchun bitta nuqta (boshlanishi: { $ways }).
sweep-alt-waterfall = "{ $body }" jismining aylanish tezligi bo‘yicha tartiblar spektrlari (boshlanishi: { $way }). Manfiy tartiblar teskari pretsessiya.
sweep-alt-lyapunov = Aylanish tezligi bo‘yicha eng katta Lyapunov ko‘rsatkichi (boshlanishi: { $ways }).
motion-map-alt = { $x } va { $y } bo‘yicha: { $what }.
basins-alt = { $speed } tezlikda { $x } va { $y } bo‘yicha har bir boshlang‘ich shartdan boriladigan attraktor.
basins-sized = { $body }: { $size } ({ $attractor }-attraktor)
basins-grid-step = to‘r qadami ({ $state })
basins-typical-size = xarakterli o‘lcham ({ $state })
animation-alt = O‘q bo‘ylab ko‘rinish: jismlarning faza belgisi qo‘yilgan markazlari, yo‘laklar va sharchalar. Siljishlar yo‘laklarga nisbatan { $enlarged } marta katta chizilgan.
store-requested = so‘ralgan { $rows }

# Hisob qanday tugagan.
end-place = { $parameter } = { $at }
end-reached = Hisob oxirigacha bajarildi.
end-step-too-small = Hisob erta to‘xtadi: qadam juda kichik bo‘lib qoldi ({ $place }).
end-no-solution = Hisob erta to‘xtadi: yechim topilmadi ({ $place }, tafovut { $residual }).
end-no-values = Hisob erta to‘xtadi: yechim topilmadi ({ $place }, u yerda tenglamalar chekli qiymatlarga ega emas).
end-unbounded = Hisob erta to‘xtadi: harakat barcha chegaralardan oshdi ({ $place }).
end-cancelled = Hisob bekor qilindi; bajarilgan qismi ko‘rsatilgan.
end-refused = Hisob bajarilmadi: bu mashina uchun uning javobi yo‘q.
end-max-points = Hisob erta to‘xtadi: ruxsat etilgan eng katta nuqtalar soniga yetildi (max_points, --work-limit).
end-work-limit = Hisob erta to‘xtadi: ish chegarasiga (--work-limit) yetildi; bajarilgan qismi ko‘rsatilgan.
