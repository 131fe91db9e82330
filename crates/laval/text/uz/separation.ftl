# Gap qismlari. Ajratish darajasi va idish nomi gap boshida turadi.
separation-recovery = Zarralarning { $share } qismini ajratish
separation-recovery-from = { $diameter } va undan katta zarralarning { $share } qismini ajratish
separation-particles = zarralarning
separation-particles-from = { $diameter } va undan katta zarralarning
separation-in-time = { $time } ichida
separation-at-throughput = { $throughput } unumdorlikda
separation-without-spin = aylanishsiz
separation-at-speed = { $speed } tezlikda
separation-no-run-up = {""}
separation-run-up-included = {" "}({ $duration } tezlashish bilan birga)
separation-run-up-estimated = {" "}({ $duration } tezlashish bilan birga, u o‘rtacha radiusdagi maydon bo‘yicha baholangan)
separation-vessel = { $kind ->
        [swinging] Osma stakan
        [fixed_angle] Qiya probirka
        [tubular_bowl] Trubasimon baraban
        [disc_stack] Likopchali baraban
       *[decanter] Dekanter
    }

# Nima ajratiladi.
separation-caught = { $vessel } { $at_hand } { $spin } { $particles } { $value } qismini ajratadi{ $run_up }.
separation-all-sampled-caught = { $vessel } { $at_hand } { $spin } barcha namuna zarralarni, ya’ni { $particles } deyarli { $value } qismini ajratadi{ $run_up }. Oxirgilari uchun { $last } kerak bo‘lar edi.
separation-all-sampled-caught-some-never = { $vessel } { $at_hand } { $spin } barcha namuna zarralarni, ya’ni { $particles } deyarli { $value } qismini ajratadi{ $run_up }. Ba’zi zarralar hech qachon ajralmaydi.
separation-never-caught = { $recovery } { $spin } mumkin emas: ba’zi zarralar suyuqlikda qoladi. recovery qiymatini kamaytiring yoki diameter qiymatini oshiring.
separation-time-needed = { $recovery } { $spin } { $value } vaqt oladi{ $run_up }.
separation-residence-needed = { $recovery } uchun { $spin } { $value } bo‘lish vaqti kerak, unumdorlik ko‘pi bilan { $throughput }.
separation-no-spin-needed = { $recovery } uchun { $at_hand } og‘irlik kuchining o‘zi yetarli: aylanish kerak emas.
separation-speed-needed = { $recovery } uchun { $at_hand } kamida { $value } tezlik kerak{ $run_up ->
        [none] {""}
        [same] , tezlashish o‘sha tezlanish bilan
       *[programme] , dasturning barcha tezliklari mutanosib o‘zgaradi
    }.
separation-no-speed-suffices = { $recovery } uchun { $highest } tezlikkacha hisoblangan tezliklarning birortasi ham { $at_hand } yetarli emas{ $run_up ->
        [none] {""}
        [same] , tezlashish o‘sha tezlanish bilan
       *[programme] , dasturning barcha tezliklari mutanosib o‘zgaradi
    }. { $flow ->
        [yes] throughput yoki recovery qiymatini kamaytiring
       *[no] time qiymatini oshiring yoki recovery qiymatini kamaytiring
    }.
separation-one-speed = { $recovery } uchun zarur tezlik va sezgirliklar hisoblanmagan: bu tezlikning { $times } barobarigacha har bir zarra inersiyasi bilan integrallanishi kerak bo‘lar edi. Inersiyani hisobga olmaydigan model = "drifting" sozlamasidan foydalaning yoki alohida tezliklarni hisoblang.
separation-nothing-shown = Natija yo‘q: zarra yo‘llari soni bilan o‘lchanadigan ish chegarasi barcha yo‘llar hisoblanmasdan hisobni tugatdi.
separation-cut-size = Ajratish chegarasi: diametri { $value } bo‘lgan { $particles ->
        [light] yengil zarralarning
       *[heavy] zarralarning
    } yarmi ajratiladi{ $estimate ->
        [none] {""}
        [inertia] , inersiya hisobga olinmagan
       *[run_up] , inersiyasiz baholangan, tezlashish o‘rtacha radiusdagi maydon bo‘yicha olingan
    }.
separation-released = Qo‘yib yuborilgan zarra { $value } vaqtdan keyin { $surface ->
        [wall] devorga
        [bottom] tubga
       *[surface] suyuqlik sirtiga
    } yetadi, stakan bo‘ylab { $along } masofada.
separation-released-stays = Qo‘yib yuborilgan zarra hech qachon sirtga yetmaydi: u suyuqlikda qoladi.
separation-released-outside = Qo‘yib yuborish nuqtasi suyuqlikdan tashqarida, shuning uchun yo‘l hisoblanmaydi. release nuqtasini suyuqlik ichiga ko‘chiring.

# Stakan va uning maydoni.
separation-tilt = Stakan vertikaldan { $value } burchakka og‘adi.
separation-tilt-none = Stakan vertikal osilib turadi: bu tezlikda u og‘maydi.
separation-tilt-held = Stakan { $value } og‘ish burchagida mahkamlangan.
separation-field = Markazdan qochma maydon suyuqlik sirtida { $surface } g, tashqi radiusda { $value } g.
separation-no-field = Faqat og‘irlik kuchi ta’sir qiladi: markazdan qochma maydon { $value } g.

# Modelning qo‘llanish sohasi.
separation-gravity = Zarur tezlikda eng ichki suyuqlikdagi maydon { $value } g. Model og‘irlik kuchini hisobga olmaydi, bu { $least } g qiymatidan yuqorida o‘rinli: zarur tezlik taxminiy baho.
separation-validity = Qo‘llanish sohasi shubhali ({ $name } = { $value }, chegara { $limit }): { $meaning }.
separation-validity-undefined = Qo‘llanish sohasi shubhali ({ $name } chekli emas, chegara { $limit }): { $meaning }.
