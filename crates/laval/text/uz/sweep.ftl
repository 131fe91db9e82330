# Javob qanday boshlangan: har bir tezlikda yangidan yoki oldingi tezlikdagi javobdan.
sweep-from-start = boshlang‘ich shartdan boshlanganda
sweep-run-up = tezlashishda
sweep-run-down = sekinlashishda

# Eng katta siljish yoki og‘ish burchagi.
sweep-largest = { $point } uchun eng katta { $quality ->
        [tilt] qiymat
       *[displacement] siljish
    } { $value }, { $speed } tezlikda, { $start } olingan.
sweep-largest-recorded = { $point } uchun qayd etilgan eng katta { $quality ->
        [tilt] qiymat
       *[displacement] siljish
    } { $value }, { $speed } tezlikda, { $start } olingan. U yerda javob takrorlanmaydi va kattalashishi mumkin.

# Sakrashlar va gisterezis. Tezlashish va sekinlashish kvazistatik.
sweep-jump = Kvazistatik { $way ->
        [up] tezlashishda
       *[down] sekinlashishda
    } { $from } – { $to } oralig‘ida sakrash: { $point }, { $before } o‘rniga { $after }.
sweep-start-jump = Har bir tezlikda yangidan boshlanganda { $from } – { $to } oralig‘ida o‘zgarish: { $point }, { $before } o‘rniga { $after }. U yerda boshlang‘ich shart tortilish sohasi chegarasidan o‘tadi. Bu nonlinear_response hisobi keltiradigan buklanishdan farq qiladi; sekin o‘tishdagi sakrashlarni start = "up_and_down" beradi.
sweep-no-jump = Kvazistatik { $way ->
        [up] tezlashishda
       *[down] sekinlashishda
    } { $from } tezlikdan { $to } tezlikkacha, { $speeds } ta tezlik orasida, sakrash yo‘q.
sweep-joins = Kvazistatik { $way ->
        [up] tezlashish sekinlashish tarmog‘iga
       *[down] sekinlashish tezlashish tarmog‘iga
    } { $from } – { $to } oralig‘ida yetib keladi. U yerda sakraydi yoki keskin o‘zgaradi; qaysi biri ekanini oraliqdagi ko‘proq nuqta ko‘rsatadi.
sweep-hysteresis = { $from } – { $to } oralig‘ida gisterezis, kengligi { $value }: javob o‘tish yo‘nalishiga bog‘liq.
sweep-hysteresis-at = { $speed } tezlikda, faqat bitta hisoblangan tezlikda, gisterezis: javob o‘tish yo‘nalishiga bog‘liq. Oraliqdagi ko‘proq nuqta kenglikni beradi.

# Bir necha aylanishdan keyin takrorlanadigan, takrorlanmaydigan yoki barqarorlashmagan javoblar.
sweep-longer-period = 1/{ $turns } tartibli subgarmonik javob { $place }, { $start }: u { $turns } ta aylanishdan keyin takrorlanadi.
sweep-not-periodic = Javob { $place }, { $start }{ $count ->
        [1] ,
       *[other] , { $count } ta tezlikda,
    } { $turns } ta aylanish ichida takrorlanmaydi. U kvazidavriy, xaotik yoki davri uzunroq, amplitudalar esa qayd etilgan eng katta qiymatlar. Xaosni ajratish uchun lyapunov = true qo‘ying.
sweep-not-settled = Javob { $place }, { $start }{ $count ->
        [1] ,
       *[other] , { $count } ta tezlikda,
    } kerakli aniqlikda takrorlanmaydi, holbuki eng sekin modaning bir necha so‘nish vaqti o‘tgan. U buklanish yonida sekin o‘zgaradi yoki integrallash xatosi juda katta. relative_tolerance qiymatini kamaytiring.
sweep-not-settled-bounded = Javob { $place }, { $start }{ $count ->
        [1] ,
       *[other] , { $count } ta tezlikda,
    } hali o‘zgaradi: kuzatish most_periods chegarasida to‘xtagan. U yerdagi amplitudalarda o‘tish jarayonlari bo‘lishi mumkin; most_periods qiymatini oshiring.
sweep-settling-bounded = { $speeds } ta tezlikdan { $count } tasida, { $start }, kuzatish eng sekin moda so‘nib bo‘lmasdan most_periods chegarasida to‘xtadi. U yerda javob kerakli aniqlikda takrorlanadi.
sweep-no-decay = { $speeds } ta tezlikdan { $count } tasida muvozanat holati atrofidagi moda so‘nmaydi. U yerdagi natijalarda, jumladan sakrashlar va gisterezisda, o‘tish jarayonlari qolgan bo‘lishi mumkin. So‘ndirish qo‘shing yoki ularni kattaroq most_periods bilan tasdiqlang.
sweep-failed-motions = { $motions } ta javobdan { $count } tasida integrallash bajarilmadi, birinchisi { $first } tezlikda: har biri { $reason }. Undan keyin hisob boshlang‘ich shartdan yangidan boshlanadi, shuning uchun uning yonidagi sakrashlar tushib qolgan bo‘lishi mumkin.

# Eng katta Lyapunov ko‘rsatkichi.
sweep-chaos = { $count } ta javob xaotik: eng katta Lyapunov ko‘rsatkichi { $value }, { $speed } tezlikda. U yerda amplituda takrorlanmaydi; so‘ndirish qo‘shing yoki tez o‘ting.
sweep-no-chaos = Xaotik javob topilmadi: birorta ham Lyapunov ko‘rsatkichi aniq musbat emas.
