# Hisobotning birinchi sahifasi va terminaldagi xulosa.

# Baholar.
verdict-passed = bajarilgan
verdict-no_limit = chegara qo‘yilmagan
verdict-not_computed = hisoblanmagan
verdict-attention = e’tibor bering
verdict-failed = bajarilmagan

# Xuddi shular, terminal uchun qisqa.
short-passed = bajarildi
short-no_limit = chegara yo‘q
short-not_computed = hisoblanmadi
short-attention = e’tibor bering
short-failed = BAJARILMADI
short-near = kam

# Sarlavha.
headline-stable = { $speed } tezlikda turg‘un.
headline-stable-below = { $limit } dan past modalar bo‘yicha { $speed } tezlikda turg‘un.
headline-unstable = { $speed } tezlikda noturg‘un. Mashinani bu tezlikda ishlatmang.
headline-not-proven = { $speed } tezlikda turg‘unlik isbotlanmagan.
headline-unknown = { $speed } tezlikda turg‘unlik hisoblanmagan.
headline-unknown-table = { $speed } tezlikda turg‘unlik hisoblanmagan: "{ $part }" koeffitsiyentlari faqat { $from } dan { $to } gacha bo‘lgan tebranish chastotalari uchun berilgan; bu chastotalardagi modalarni "modes" hisobi beradi, qolganlari uchun jadvalga boshqa chastotalar qatorlarini qo‘shing.
headline-no-speed = Ish tezligi berilmagan.
headline-limit = Bajarilmagan talablar: { $checks }.
headline-not-checked = Talab qilingan, lekin tekshirilmagan: { $checks }.
headline-studies-not-run = Fayldagi bu tadqiqotlar hisobga olinmagan: { $studies }. Ular ko‘proq topishi mumkin: ishga tushiring.
headline-attention = E’tibor talab qiladi: { $checks }.
headline-buckled = Tinch holatda mashina o‘z o‘rnini saqlamaydi (statik noturg‘unlik): siljish { $time } ichida e marta o‘sadi.
headline-jump = { $kind ->
        [jump] Javob { $speed } tezlikda sakraydi
       *[bifurcation] Javobning turg‘unligi { $speed } tezlikda o‘zgaradi
    }, { $side ->
        [inside] ish tezliklari orasida
        [above] ish tezligidan { $margin } yuqorida
       *[below] ish tezligidan { $margin } pastda
    }.
headline-resonance = Eng yaqin rezonansgacha ({ $resonance }) masofa atigi { $margin }.
headline-resonance-inside = { $resonance } rezonansi ish tezliklari orasida.
headline-near-instability = Eng yaqin noturg‘unlikkacha masofa atigi { $margin }.
headline-crosses = { $count ->
        [1] Tezlashish { $from } – { $to } noturg‘un oralig‘idan o‘tadi.
       *[other] Tezlashish { $from } va { $to } orasidagi { $count } ta noturg‘un oraliqdan o‘tadi.
    }
headline-crosses-open = Tezlashishda mashina { $from } tezlikdan boshlab noturg‘un ({ $to } gacha tekshirildi).
headline-slip = Tezlashish turg‘un sinxron holati yo‘q { $from } – { $to } oralig‘idan o‘tadi.

# Uning ostidagi izohlar.
remark-here = { $speed } tezlikda
remark-below = Tezlashish yo‘lida
remark-above = Yuqorida
remark-unstable = { $open ->
        [yes] { $from } tezlikdan boshlab noturg‘un ({ $to } gacha tekshirildi):
        [below] { $to } gacha noturg‘un ({ $from } tezlikdan boshlab tekshirildi):
        [both] Tekshirilgan barcha tezliklarda noturg‘un, { $from } – { $to }:
       *[no] { $from } – { $to } oralig‘ida noturg‘un:
    } { $oscillates ->
        [yes] { $frequency } chastotali pretsessiya
       *[no] tebranishsiz harakat
    } eng xavfli tezlikda { $time } ichida e marta o‘sadi.
remark-resonance = { $speed } tezlikda rezonans, "{ $body }" jismi: { $value }.
remark-resonance-unbounded = { $speed } tezlikda so‘nishsiz rezonans: "{ $body }" jismining amplitudasi chegaralanmagan.
remark-resonances = Boshqa rezonanslar: { $speeds }.
remark-critical = Kritik aylanish chastotasi { $speed }.
remark-jump = { $count ->
        [1] Sekin tezlashish yoki sekinlashishda sakrash: { $speeds }.
       *[other] Sekin tezlashish yoki sekinlashishda sakrashlar: { $speeds }.
    }
remark-harm = { $from } – { $to } oralig‘ida sharchalar disbalansni { $times } martagacha oshiradi.
remark-stability = { $text }.
remark-vibration = Tebranish: { $text }.
remark-forces = Kuchlar: { $text }.

# Tekshiruvlar: nomi, natijasi, talabi.
check-stability = Turg‘unlik
check-instability = Eng yaqin noturg‘unlik
check-resonance = Eng yaqin rezonans
check-jump = Eng yaqin sakrash yoki bifurkatsiya
check-vibration = Tebranish
check-forces = Kuchlar
check-validity = Qo‘llanish sohasi
check-balls = Sharchalar bilan disbalans
check-run-up = Tezlashish

required-decay = { $margin ->
        [none] so‘nuvchi
       *[other] so‘nish ≥ { $margin }
    }
required-below = ≤ { $limit }
required-each = ≤ chegarasi
required-balance = { $grade }: ≤ { $limit }
required-validity = ichida
required-less-unbalance = sharchalarsizdan kam

stability-stable = { $modes ->
        [1] moda { $decay } sur’at bilan so‘nadi
       *[other] barcha { $modes } ta moda so‘nadi, eng sekini { $decay } sur’at bilan
    }
stability-stable-below = { $modes ->
        [one] { $limit } chastotadan pastdagi moda { $decay } sur’at bilan so‘nadi
       *[other] { $limit } chastotadan pastdagi barcha { $modes } moda so‘nadi, eng sekini { $decay } sur’at bilan
    }
stability-across = barcha { $modes } ko‘ndalang tebranish shakli so‘nadi, eng sekinining ko‘rsatkichi { $decay }; bo‘ylama va buralma tebranishlar so‘nishsiz
stability-unstable = { $motion ->
        [divergence] statik noturg‘unlik (divergensiya): siljish
       *[whirl] noturg‘un pretsessiya: amplituda
    } { $time } ichida e marta o‘sadi
stability-steady = bu tezlikda barqaror javob turg‘un (chiziqsiz javob)
stability-decays = eng sekin moda { $decay } sur’at bilan so‘nadi
stability-unknown = topilgan modalar o‘smaydi, lekin ba’zilari tushib qolgan bo‘lishi mumkin
stability-slow = birorta ham moda { $limit } qiymatidan tez o‘smaydi; undan sekin o‘sish aniqlanmagan
stability-neutral = eng kam so‘nuvchi modada so‘nish yo‘q
stability-balanced = balanslangan holat turg‘un
stability-state = rotorni balanslamaydigan holat turg‘un
stability-no-state = bu tezlikda turg‘un sinxron holat yo‘q
stability-needs-stationary = sharchalar rotor ichida harakatlanadi: "stationary" hisobi kerak
stability-mode = { $place ->
        [none] chastotasi { $frequency }, logarifmik dekrement { $decrement }
       *[other] chastotasi { $frequency }, logarifmik dekrement { $decrement }; eng kam turg‘un ish tezligi { $place }
    }
stability-no-mode = mashinada moda yo‘q
distance-both = pastda { $below }, yuqorida { $above }
distance-below = pastda { $below }, yuqorida { $to } tezlikkacha yo‘q
distance-above = pastda yo‘q, yuqorida { $above }
distance-stable-throughout = { $from ->
        [none] { $to } tezlikkacha topilmadi
       *[other] { $from } – { $to } oralig‘ida topilmadi
    }
distance-inside-unstable = { $open ->
        [unknown] ish tezligi noturg‘un oraliqda
        [yes] ichida, { $from } tezlikdan boshlab noturg‘un ({ $to } gacha tekshirildi)
        [below] ichida, { $to } gacha noturg‘un ({ $from } tezlikdan boshlab tekshirildi)
        [both] ichida, tekshirilgan barcha tezliklarda noturg‘un, { $from } – { $to }
       *[no] ichida, { $from } dan { $to } gacha noturg‘un
    }
distance-no-other-resonance = { $from ->
        [none] { $to } tezlikkacha boshqasi topilmadi
       *[other] { $from } – { $to } oralig‘ida boshqasi topilmadi
    }
distance-critically-damped = { $speeds } da kritik so‘ndirilgan: kuchaytirish koeffitsienti 2,5 dan past, API 684 chastota zaxirasini talab qilmaydi
distance-not-examined = talab qilingan zaxira uchun { $from } dan { $to } gacha barcha tezliklar kerak
distance-coarse = hisoblangan tezliklar juda kam: ular orasida tor soha bo‘lishi mumkin
distance-orders-open = { $orders } karra qo‘zg‘atishdagi rezonanslar izlanmadi: critical_speeds hisobini qo‘shing
distance-silent = to‘g‘ri pretsessiyaning kritik tezligi { $speeds }: bu fayldagi nomuvozanatlik uni qo‘zg‘atmaydi, boshqasi qo‘zg‘atishi mumkin
distance-no-resonance = { $from ->
        [none] { $to } tezlikkacha topilmadi
       *[other] { $from } – { $to } oralig‘ida topilmadi
    }
item-of = { $name } { $value }, chegarasi { $limit }
item = { $name } { $value }
item-force = { $rest ->
        [none] { $name } { $value }
       *[other] { $name } { $value } (statik { $rest })
    }
both = { $first }; { $second }
vibration-sizes = { $sizes }
vibration-velocity = { $name }: tezlik amplitudasi { $peak }
vibration-unbounded = bu tezlikda so‘nishsiz rezonans
forces-none = noma’lum
forces-sizes = { $sizes }
forces-with-rest = og‘irlik kabi statik yuklama bilan birga bir aylanishdagi eng katta qiymat; tebranish statik egilishdan hisoblangan
validity-none = birorta ham qism chegara bermaydi
validity-doubt = fayl hisoblarida shubhali: { $names }
validity-statement = { $part }, { $what }
validity-inside = eng yaqin chegaraning { $share } qismi: { $statement }
validity-elsewhere = bu tezlikda ichida; fayl hisoblarida tashqarida: { $outside }
validity-outside-here = chegaraning { $ratio } barobari: { $statement }
validity-unbounded = chegara cheksiz oshib ketgan: { $statement }
validity-nothing = bu tezlikda birorta ham qism baholanmagan
validity-studies = fayl hisoblarida tashqarida: { $outside }
check-run-study = fayldagi “{ $study }” hisobini bajaring
balls-no-study = "stationary" yoki "transient" hisobi kerak
balls-left = { $without } disbalansdan { $left } qoldi
run-up-computed = eng katta siljish { $value } ("{ $body }" jismi)
run-up-steady = eng katta siljish { $value } ("{ $body }" jismi), tezlashish oxirida
run-up-unknown = { $speed } tezlikdan pastda nima borligi noma’lum
run-up-buckled = tinch holatda mashina o‘z o‘rnini saqlamaydi
run-up-free = rezonanslardan ham, noturg‘un oraliqlardan ham o‘tmaydi
run-up-resonances = { $count ->
        [1] rezonansdan o‘tadi: { $resonances }
       *[other] { $count } ta rezonansdan o‘tadi: { $resonances }
    }
run-up-unstable = noturg‘un oraliqdan o‘tadi: { $ranges }
run-up-both = { $count ->
        [1] rezonansdan ({ $resonances })
       *[other] { $count } ta rezonansdan ({ $resonances })
    } va noturg‘un oraliqdan ({ $ranges }) o‘tadi
speed-span = { $from } – { $to }
why-refused = bu mashina uchun mumkin emas: { $reason }
why-too-long = bir soniyadan ko‘p vaqt oladi; hisobni faylga qo‘shing
from-study = "{ $study }" hisobi bo‘yicha
why-no-speed = 0 dan yuqori ish tezligi berilmagan

# Keyin nima qilish kerak.
next-speed = [machine] bo‘limida speed qiymatini bering: tekshiruvlar uchun ish tezligi kerak.
next-unstable = { $sides ->
        [both] { $below } dan past yoki { $above } dan yuqori tezlikni tanlang
        [below] { $below } dan past tezlikni tanlang
        [above] { $above } dan yuqori tezlikni tanlang
       *[none] Noturg‘un oraliqdan tashqaridagi tezlikni tanlang
    } yoki so‘ndirish qo‘shing; turg‘unlik xaritasiga qarang.
next-viscosity = Suyuqlikning qovushqoqligini bering: usiz { $limit } dan sekin o‘sish aniqlanmaydi.
next-validity = Qo‘llanish sohasi haqidagi xulosalarga amal qiling: ularda shubhali natijalar va modelda nimani o‘zgartirish kerakligi aytilgan.
next-buckled = { $count ->
        [0] Mashinani tinch holatda ushlab turadigan bikrlikni oshiring yoki siquvchi o‘q kuchini kamaytiring.
       *[other] { $parts } bikrligini oshiring yoki siqilishni kamaytiring: tinch holatda o‘sadigan shaklda u manfiy.
    }
next-stability-map = Turg‘un tezliklarni va zarur so‘ndirishni topish uchun "stability_map" hisobini qo‘shing.
next-resonance = Ish tezligi va rezonans orasini { $margin } yoki undan ko‘proq qiling yoki so‘ndirish qo‘shing.
next-balls = "stationary" hisobini qo‘shing: sharchalar qaysi tezliklarda balansirlashini ko‘rsatadi.
next-harm = Tezlashishda sharchalarni ushlab turing yoki turg‘unlik oralig‘idan pastdagi tezliklardan tez o‘ting.
next-jump = Ish tezligi bilan sakrash orasini { $margin } yoki undan ko‘proq uzoqlashtiring, disbalansni kamaytiring yoki so‘ndirish qo‘shing.
next-run-up = Tezlashishni modellashtiring: "run_up" hisobini qo‘shing.
next-nonlinear = "nonlinear_response" hisobini qo‘shing: mashinada chiziqsiz qismlar bor, sakrashlar istisno emas.
next-limits = [limits] bo‘limida bering: { $keys }; chegarasi yo‘q natijalar baholanmaydi.
next-studies = Faylda hisob yo‘q: [[study]] bloklarini qo‘shing, masalan { $kinds }; barcha turlarini laval studies ko‘rsatadi.

# Sahifa sarlavhalari.
page-checks = Tekshiruvlar
page-check = Tekshiruv
page-result = Natija
page-required = Talab
page-verdict = Baho
page-not-set = berilmagan
page-over-speed = Tezlik bo‘yicha holat
page-modes = { $speed } tezlikdagi modalar
page-machine = Mashina
page-next = Keyin nima qilish kerak
page-findings = Barcha xulosalar
page-fill = to‘ldirilishi { $fill }
page-balls = { $count } ta sharcha
page-mode = { $number }-moda
page-whirl = { $whirl ->
        [forward] to‘g‘ri pretsessiya
        [backward] teskari pretsessiya
        [mixed] aralash pretsessiya
        [axial] o‘q bo‘ylab
        [torsional] buralma
       *[none] pretsessiyasiz
    }
page-decrement = dekrement { $decrement }
page-grows = o‘sadi
page-not-resolved = sekin o‘sish aniqlanmagan
page-diverges = statik noturg‘unlik (divergensiya)
axis-amplitude = amplituda
axis-growth = o‘sish sur’ati
strip-unstable = noturg‘un
strip-not-examined = turg‘unlik tekshirilmagan
strip-response = noturg‘un javob
strip-jump = sakrash
axis-speed-plain = tezlik
axis-operating = ish tezligi
strip-stable-limit = pastda turg‘un
caption-both = Disbalansga chiziqli javobning amplitudasi va eng kam turg‘un modaning o‘sish sur’ati.
caption-amplitude = Disbalansga chiziqli javobning amplitudasi.
caption-growth = Eng kam turg‘un modaning o‘sish sur’ati.
strip-resonance = rezonans

# Hisobotning qolgan qismi.
page-evidence = asoslar
page-warning = Ogohlantirish
page-outside = Qo‘llanish sohasidan tashqarida
page-stopped = Erta to‘xtatilgan
page-tables = Jadvallar
page-points = Maxsus nuqtalar
page-work = Bajarilgan ish
page-input = Kirish ma’lumotlari
page-input-file = Kirish fayli: { $file }
page-provenance = Bu qanday hisoblangan
page-more = va yana { $count } ta, results.json faylida
page-more-studies = va yana { $count } ta, quyidagi hisoblar bilan birga
page-rows = { $count } ta qator
page-nothing = Hisoblarda xulosalar yo‘q; ularning grafiklari va jadvallariga qarang.
page-hint = Qiymatlarni o‘qish uchun egri chiziqni ko‘rsating. Kattalashtirish uchun sudrang, hammasini ko‘rish uchun ikki marta bosing, egri chiziqni yashirish uchun nomini bosing. Tugmalar: strelkalar, +, −, 0.
page-reset = Masshtabni tiklash
page-yes = ha
page-no = yo‘q
vibration-unstable = barqaror tebranish yo‘q: mashina noturg‘un
why-same = xuddi shu sababga ko‘ra mavjud emas

# Ish oralig‘i, oyna va chegaralar.
headline-several = Bir nechta barqaror javobdan qaysi biri yuzaga kelishi tezlashishga bog‘liq.
headline-validity = Natijalarning hammasi ham qo‘llanish sohasi ichida emas.
check-window = Ish oynasi
check-speed = Eng yuqori tezlik
check-others = Boshqa chegaralar
check-studies = Hisoblarning talablari
check-damping = So‘ndirish
required-above = ≥ { $limit }
stability-no-steady = bu tezlikda birorta ham barqaror javob turg‘un emas (chiziqsiz javob)
stability-several = bu tezlikda { $count } ta turg‘un barqaror javob bor (chiziqsiz javob)
stability-beside = tinch holat turg‘un, lekin { $value } gacha pretsessiya ham turg‘un: turtki unga olib kelishi mumkin
stability-outside-study = "stationary" hisobi bu tezlikni qamrab olmaydi
stability-unstable-range = ish tezliklarida noturg‘un: { $range }
damping-no-oscillation = tebranuvchi moda yo‘q
damping-least = logarifmik dekrement { $decrement }, chastota { $frequency }
distance-inside = ish tezliklari orasida: { $places }
vibration-nonlinear = chiziqsiz mashinaning eng katta turg‘un javobi
vibration-states = sharchalarning turg‘un holatlari bo‘yicha eng kattasi
vibration-contact = chiziqli; kontakt yuzaga kelar edi ({ $parts }), amplituda haqiqiy emas
vibration-touching = tinch holat atrofidagi kichik tebranishlar, bu holatda kontakt allaqachon bor: { $parts }
response-without-spins = { $spins } muvozanatsizligisiz: uni spin maydoni bor "forced_response" hisobi qamraydi
response-with-spins = { $spins } tebranishi qo‘shilgan, spin berilgan "forced_response" bo‘yicha
forces-without = chiziqsiz qismlarsiz: { $parts }
forces-not-linear = tinch holatdagi urinma bo‘yicha; xuddi shu harakatning qonun bo‘yicha kuchidan o‘ndan biridan ko‘proq farq qiladi: { $parts }; nonlinear_response hal qiladi
window-none = birorta tezlik ham barcha talablarni bajarmaydi
window-ranges = { $ranges }
speed-is = { $speed }
limits-left-out = bu sahifada baholanmagan: { $names }
studies-requirements = { $studies } hisobida bajarilmagan yoki tasdiqlanmagan
run-up-contact = sekin o‘tishda tebranish tirqishni yopadi: { $parts }
run-up-grows = noturg‘un oraliqlarda g‘alayon { $factor } martagacha o‘sadi
run-up-diverges = harakat cheksiz uzoqlashadi
axis-operating-range = ish tezliklari
check-shaft-vibration = Podshipniklardagi val tebranishi
check-housing-vibration = Podshipnik korpuslarining tebranishi
check-balance = Muvozanatlash sifati
check-velocity = Tebranish tezligi
velocity-sizes = { $sizes } (amplituda)
velocity-is = eng kattasi { $value } (amplituda)
validity-studies-inside = fayldagi birorta ham hisob sohadan tashqari natija topmadi
# Sahifa nimani hisobga olmaydi.
page-left-out = Bu sahifa nimani hisobga olmaydi
left-linear = Chiziqsiz qismlar ({ $parts }) muvozanat holati atrofida chiziqlashtirilgan; katta tebranish va sakrashlar uchun "nonlinear_response" hisobi kerak.
left-linear-modes = Turg‘unlik va modalar uchun chiziqsiz qismlar ({ $parts }) muvozanat holati atrofida chiziqlashtirilgan.
left-spins = Mashina aylanishidan boshqa aylanishlarning ({ $spins }) muvozanatsizligiga javob: spin maydoni bor "forced_response" hisobi kerak.
left-motions = { $tilt ->
        [bends] Bo‘ylama va buralma tebranishlar.
        [yes] Bo‘ylama va buralma tebranishlar, shuningdek jismlarning egilishi.
       *[no] Bo‘ylama, buralma va og‘ish tebranishlari, shuningdek jismlarning egilishi.
    }
left-excitation = Disbalansdan boshqa qo‘zg‘atishlar, masalan o‘qlarning nomuvofiqligi, tishli uzatmalar yoki harakatlanuvchi poydevor.
left-drive = Dvigatel: aylanish tezligi berilgan deb olinadi, rezonansdan o‘tishga quvvati yetmaydigan dvigatel ko‘rinmaydi.
left-steps = { $step } qadamdan tor noturg‘un oraliqlar.
left-steps-near = { $step } qadamdan, ish tezligi yaqinida { $near } qadamdan tor noturg‘un oraliqlar.
page-evidence-all = Sonli asoslar
page-evidence-finding = xulosa
page-evidence-value = qiymat
page-evidence-checked = nima bilan tekshirilgan
page-evidence-number = natija

balance-planes = { $rotor }: { $sizes }
item-balance = { $name } { $value }, chegarasi { $share }
balance-detail = ISO 21940-11:2016, { $planes ->
        [two] 6.2 va 7.2, podshipniklar tekisliklarida
       *[one] 6.2, faqat bosh vektor: rotorda podshipniklarning ikki tekisligi yo‘q
    }. Bosh vektor { $resultant }{ $tilts ->
        [yes] , bosh moment { $couple }
       *[no] {""}
    }; qattiq rotor sifatida muvozanatlangan
shaft-vibration-sizes = { $sizes }
item-shaft-vibration = { $name } { $value } qulochli{ $zone ->
        [none] {""}
       *[other] , { $zone } zona
    }
shaft-vibration-detail = { $standard ->
        [api_617] API 617
       *[iso_7919_3] ISO 7919-3:2009, A ilova, B va C zonalar chegarasi
    }; chegara { $speed } da. Faqat nomuvozanat, podshipniklarga nisbatan{ $nonlinear ->
        [yes] ; nochiziqli mashinaning eng katta turg‘un javobi
       *[no] {""}
    }
item-housing-vibration = { $name } { $value } (o‘rtacha kvadratik){ $zone ->
        [none] {""}
       *[other] , { $zone } zona
    }
housing-vibration-detail = ISO 20816-3, { $standard ->
        [group_1_rigid] qattiq tayanchdagi 1-guruh
        [group_1_flexible] egiluvchan tayanchdagi 1-guruh
        [group_2_rigid] qattiq tayanchdagi 2-guruh
       *[group_2_flexible] egiluvchan tayanchdagi 2-guruh
    }, B va C zonalar chegarasi; chegara { $speed } da. Faqat nomuvozanat, podshipniklar turgan jismlar{ $nonlinear ->
        [yes] ; nochiziqli mashinaning eng katta turg‘un javobi
       *[no] {""}
    }
housing-vibration-none = birorta podshipnik harakatlanadigan jismda turmaydi
shaft-vibration-no-bearing = aylanuvchi va aylanmaydigan orasida tayanch yo‘q
shaft-vibration-unknown = podshipniklarga nisbatan javob noma’lum
shaft-vibration-speed = standart bu ish tezliklarini qamrab olmaydi
