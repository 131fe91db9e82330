# Talablar, gaplarda qanday turishi.
operating-window-requirement = { $name ->
        [separation] ajratish vaqti
        [residence] bo‘lish vaqti
        [vibration] tebranish
        [self_centred] rotorning o‘z-o‘zidan markazlashishi
        [stable] turg‘unlik
        [clear] xususiy chastotalardan uzoqlik
        [passage] rezonanslardan o‘tish
        [strength] eng yuqori tezlik
        [valid] qismlarning qo‘llanish sohasi
       *[range] hisoblangan oraliq
    }
operating-window-at-jump = { $requirement } (sakrashda)
operating-window-span = { $from } – { $to }

# Talabda nima chegaralaydi.
operating-window-limited = { $quantity ->
        [displacement] "{ $of }" jismining siljishi
        [velocity] "{ $of }" jismining tebranish tezligi
        [tilt] "{ $of }" jismining og‘ish burchagi
        [force] "{ $of }" qismining kuchi
       *[moment] "{ $of }" qismining momenti
    }
operating-window-centre-of-mass = "{ $body }" jismi massa markazining o‘qdan uzoqligi
operating-window-growth-rate = { $contents ->
        [before] ajratishdan oldingi o‘sish sur’ati
        [after] ajratishdan keyingi o‘sish sur’ati
       *[always] o‘sish sur’ati
    }
operating-window-mode = chastotasi { $frequency } bo‘lgan modaning { $order }-tartibdan uzoqligi
operating-window-swing = stakan tebranishining { $order }-tartibdan uzoqligi
operating-window-moved = { $speed } tezlikda "{ $of }" jismining siljishi
operating-window-torque = yuritma momenti
operating-window-model = "{ $part }" qismining qo‘llanish sohasi ({ $statement })
operating-window-path = zarra yo‘lini hisoblab bo‘lmaydi ({ $why })
operating-window-without-bound = so‘nishsiz rezonansda amplituda chegaralanmagan
operating-window-no-state = turg‘un barqaror holat yo‘q

# Oynalar va ularning chetlari.
operating-window-window = Mashina { $from } – { $value } oralig‘ida ishlashi mumkin. Quyi chegara sababi: { $below }; yuqori chegara sababi: { $above }.
operating-window-widest-window = Eng keng oyna kengligi { $value }, { $from } – { $to } oralig‘ida.
operating-window-edge = Oyna { $value } tezlikda { $side ->
        [begins] boshlanadi
       *[ends] tugaydi
    }: { $reason }.
operating-window-reason = { $what } o‘z chegarasiga yetadi
operating-window-reason-limit = { $what } o‘z chegarasiga ({ $limit }) yetadi
operating-window-reason-undefined = undan narida { $what }
operating-window-reason-jump = undan narida { $what } sakrab, o‘z chegarasining { $factor } barobariga yetadi{ $states ->
        [0] {""}
        [1] {""}
       *[other] {" "}({ $states } ta turg‘un holatdan birida; sekin tezlashish yoki sekinlashish ularning har biriga olib kelishi mumkin)
    }{ $fold ->
        [yes] , buklanishda
       *[no] {""}
    }
operating-window-reason-jump-undefined = undan narida { $what } sakrab, o‘z chegarasidan oshadi{ $states ->
        [0] {""}
        [1] {""}
       *[other] {" "}({ $states } ta turg‘un holatdan birida; sekin tezlashish yoki sekinlashish ularning har biriga olib kelishi mumkin)
    }{ $fold ->
        [yes] , buklanishda
       *[no] {""}
    }
operating-window-robust-window = Ishonchli oyna: { $from } – { $value } oralig‘i, tezlik dopuski { $tolerance }{ $corners ->
        [0] {""}
       *[other] {" "}va noaniq parametrlarning barcha { $corners } ta chekka birikmasi uchun
    }.
operating-window-no-robust-window = Tezlik dopuski { $tolerance }{ $corners ->
        [0] {""}
       *[other] {" "}va noaniq parametrlarning barcha { $corners } ta chekka birikmasi
    } uchun birorta tezlik ham barcha talablarni bajarmaydi. Dopusklarni kamaytiring yoki biror chegarani yumshating.
operating-window-incomplete = Hisob erta to‘xtatilgan. Hisoblanmagan: { $parts }.
operating-window-missing = { $part ->
        [refinement] hisoblangan tezliklar orasidagi tor uzilishlarni qidirish
        [robust] ishonchli oyna
       *[map] xarita
    }

# Oyna yo‘q.
operating-window-no-window = Oraliqdagi hisoblangan tezliklarning birortasi ham barcha talablarni bajarmaydi.
operating-window-unstable = Mashina hisoblangan har bir tezlikda noturg‘un: o‘sish sur’ati kamida { $value }. Boshqa chegaralardan oldin noturg‘unlikni bartaraf qiling.
operating-window-growth-margin = Hisoblangan tezliklarning birortasi ham growth_margin talabini ({ $required }) bajarmaydi: eng kichik o‘sish sur’ati { $value }{ $damping ->
        [none] , kamida bitta moda hech narsa bilan so‘ndirilmaydi
       *[some] {""}
    }. So‘ndirish qo‘shing yoki growth_margin qiymatini kamaytiring.
operating-window-excluding = Hisoblangan tezliklarning birortasi ham ikkala talabni birga bajarmaydi: { $first } va { $second }.
operating-window-lower-throughput = Unumdorlik hozirgi qiymatining { $share } qismigacha kamaytirilsa, { $speed } tezlikda oyna ochilar edi.
operating-window-relaxation = { $requirement ->
        [separation] Ajratish uchun berilgan vaqt
        [vibration] Cheklovchi tebranish chegarasi
        [self_centred] O‘z-o‘zidan markazlashish chegarasi
        [passage] Cheklovchi o‘tish chegarasi
       *[strength] Eng yuqori tezlik
    } { $factor } barobar oshirilsa, { $speed } tezlikda oyna ochilar edi.
operating-window-no-relaxation = Birorta chegarani yolg‘iz yumshatish ham oyna ochmaydi: hisoblangan har bir tezlikda ikki yoki undan ko‘p talab buzilgan yoki birining zaxirasi yo‘q.

# Tavsiya etilgan tezlik.
operating-window-best-speed = Tavsiya etilgan tezlik: { $value }. { $why ->
        [margin] Eng kichik zaxira u yerda eng katta
        [next_margin] Eng kichik zaxira ({ $least }) { $from } – { $to } oralig‘ida bir xil; keyingisi ({ $next }) hal qiladi
        [throughput] Unumdorlik u yerda eng katta bo‘la oladi
        [time] Ajratish u yerda eng qisqa
        [energy] Energiya u yerda eng kam
       *[amplitude] Tebranish u yerda eng kichik
    }.{ $duty ->
        [throughput] {" "}Unumdorlik ko‘pi bilan { $throughput } bo‘la oladi.
        [time] {" "}Ajratish vaqti { $time }.
       *[none] {""}
    }
operating-window-binding = Tavsiya etilgan tezlikda eng kichik zaxira { $value }: { $requirement }.
operating-window-binding-detail = Tavsiya etilgan tezlikda eng kichik zaxira { $value }: { $requirement }, { $detail }.
operating-window-not-faster = Tavsiya etilgan tezlikdan yuqorida oyna { $value } tezlikda tugaydi, sababi: { $requirement }.
operating-window-field = Tavsiya etilgan tezlikda markazdan qochma maydon suyuqlik sirtida { $inner } g, tashqi radiusda { $value } g.
operating-window-outside-robust = Tavsiya etilgan tezlik { $value } ishonchli oynadan ({ $ranges }) tashqarida. Uning ichidan tezlik tanlang.
operating-window-shortest-time = Qolgan barcha talablar bajarilganda eng qisqa ajratish vaqti { $value }, { $speed } tezlikda.
operating-window-shortest-residence = Qolgan barcha talablar bajarilganda eng qisqa bo‘lish vaqti { $value }, { $speed } tezlikda: unumdorlik { $throughput }.

# Eslatmalar.
operating-window-tilt-without-limit = "{ $body }" jismining og‘ish burchagiga chegara qo‘yilmagan, u { $speed } tezlikda { $value } qiymatigacha yetadi. Uning siljishi faqat tayanch nuqtada tekshiriladi: [limits] bo‘limiga tilt qo‘shing.
operating-window-not-checked = Tekshirilmagan (chegara qo‘yilmagan): { $requirements }.
operating-window-few-requirements = Bu oynani faqat turg‘unlik chegaralaydi: u hali ish oynasi emas. [limits] yoki [suspension] bilan [[cup]] qo‘shing.
operating-window-nonlinear = { $policy ->
        [reached] Bir nechta turg‘un tarmoqdan shu faylning tezlashishi yetib boradigani tekshiriladi. Oyna faqat shu tezlashish uchun o‘rinli
        [highest] Bir nechta turg‘un tarmoqdan tebranishi eng katta bo‘lgani tekshiriladi
       *[all] Chiziqsiz javobning barcha turg‘un tarmoqlari tekshiriladi: ulardan biri chegaradan oshsa, tezlik istisno qilinadi
    }.
operating-window-passage-peak = { $way ->
        [up] { $top } tezlikkacha tezlashish
       *[down] { $top } tezlikdan sekinlashish
    }: "{ $body }" jismining siljishi { $speed } tezlikda { $value } qiymatiga yetadi.
operating-window-passage-torque = Tezlashish uchun zarur yuritma momenti ko‘pi bilan { $value }.
operating-window-braking = Tezlashish kabi tez tormozlash cho‘kmani yon tomonga markazdan qochma maydonning { $value } qismi bilan yuklaydi.
operating-window-gravity = Oynaning quyi chetida, { $speed } tezlikda, eng ichki suyuqlikdagi maydon { $value } g. Model og‘irlik kuchini hisobga olmaydi, bu { $least } g qiymatidan yuqorida o‘rinli: u yerdagi ajratish taxminiy baho.
operating-window-run-up-estimate = Tezlashish to‘liq tezlikdagi { $value } vaqtga teng deb olingan, bu o‘rtacha radiusdagi maydon bo‘yicha baholangan: qiya probirkalardagi suyuqlik tezlashish davomida siljiydi.
