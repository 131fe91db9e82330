# Qismlar va usullar ingliz tilida beradigan qat’iy iboralar.

# Qo‘llanish sohasi haqidagi iboralar: qiymatning chegaraga nisbati.
term-tilt-over-0-1-rad = og‘ish burchagining 0,1 rad chegaraga nisbati
term-bearing-deflection-over-the-range-of-its-law = podshipnik deformatsiyasining uning kuch qonuni oralig‘iga nisbati
term-surface-excursion-over-layer-thickness = suyuqlik sirti siljishining qatlam qalinligiga nisbati
term-surface-excursion-over-layer-thickness-at-the-spin-frequency = aylanish chastotasida suyuqlik sirti siljishining qatlam qalinligiga nisbati
term-change-of-the-speed-within-a-turn-over-a-tenth-of-it = bir aylanish ichida tezlik o‘zgarishining tezlikning o‘ndan biriga nisbati
term-distance-of-the-speed-from-that-of-its-form-in-time-over-a-billionth-of-it = tezlikning vaqt sohasidagi shakl tezligidan farqining uning milliarddan biriga nisbati
term-wall-acceleration-over-centrifugal-acceleration-of-the-layer = devor tezlanishining qatlamning markazdan qochma tezlanishiga nisbati
term-overlap-of-balls-in-contact-over-a-tenth-of-their-size = tegib turgan sharchalar ustma-ust tushishining ular o‘lchamining o‘ndan biriga nisbati
term-size-of-a-ball-over-the-distance-to-the-next = sharcha o‘lchamining keyingi sharchagacha bo‘lgan masofaga nisbati
term-distance-of-the-speed-from-the-middle-of-the-bearing-table-over-half-its-range = tezlikning podshipnik jadvali o‘rtasidan uzoqligining jadval oralig‘ining yarmiga nisbati
term-distance-of-the-speed-from-the-middle-of-the-torque-table-over-half-its-range = tezlikning moment jadvali o‘rtasidan uzoqligining jadval oralig‘ining yarmiga nisbati

# Suyuqlik va boshqa qismlar: nomi, to‘lqinlari, yo‘qotishlari.
term-a-part = qism
term-waves = to‘lqinlar
term-damping-in-the-parts = qismlardagi so‘ndirish
term-damping-in-the-part-gives-it-an-answer = Qismdagi so‘ndirish unga javob beradi
term-what-is-computed-there-are-the-few-waves-kept = u yerda faqat saqlangan kam sonli to‘lqinlar hisoblanadi
term-an-ideal-liquid = ideal suyuqlik
term-inertial-waves = inersion to‘lqinlar
term-a-viscosity-model-strip-or-as-an-approximation-axial-harmonics-gives-the-liquid-a-response-at-every-order = Qovushqoqlik, model = "strip" yoki, taqribiy ravishda, axial_harmonics suyuqlikka har bir tartibda javob beradi
term-what-is-computed-there-are-the-waves-of-the-axial-harmonics-kept-and-every-further-harmonic-puts-others-beside-them-a-viscosity-decides = u yerda saqlangan o‘q bo‘yicha garmonikalarning to‘lqinlari hisoblanadi, har bir keyingi garmonika ularning yoniga boshqalarini qo‘shadi; qovushqoqlik hal qiladi
term-a-viscous-liquid = qovushqoq suyuqlik
term-viscosity-in-the-liquid = suyuqlikdagi qovushqoqlik
term-without-damping-outside-the-liquid-that-is-every-speed-above-the-critical-speed-of-the-filled-rotor-damping-leaves-a-finite-range-which-little-viscosity-makes-wide = Suyuqlikdan tashqarida so‘ndirish bo‘lmasa, bu to‘ldirilgan rotorning kritik aylanish chastotasidan yuqoridagi har qanday tezlik; so‘ndirish chekli oraliq qoldiradi, kichik qovushqoqlik uni kengaytiradi.
term-of-the-liquid-s-wave-wave-damping = suyuqlik to‘lqini uchun: wave_damping

# Qismning vaqt sohasidagi shakli.
term-of-tilts-that-grow-or-decay-by-a-twentieth-of-the-speed-or-more-up-to-four-times-the-speed-in-rotor-axes = rotor o‘qlarida tezlikning to‘rt barobarigacha bo‘lgan, tezlikning yigirmadan biri yoki undan katta sur’at bilan o‘sadigan yoki so‘nadigan og‘ishlar uchun
term-of-motions-that-do-not-decay-up-to-four-times-the-speed-in-rotor-axes = rotor o‘qlarida tezlikning to‘rt barobarigacha bo‘lgan, so‘nmaydigan harakatlar uchun
term-the-layer-of-a-viscous-liquid-at-the-wall-remembers-its-whole-past = devor yonidagi qovushqoq suyuqlik qatlami butun o‘tmishiga bog‘liq
term-a-liquid-that-flows-along-the-axis-has-infinitely-many-waves = o‘q bo‘ylab oqadigan suyuqlikning to‘lqinlari cheksiz ko‘p
term-without-spin-nothing-holds-the-layer-on-the-wall = aylanishsiz qatlamni devorda hech narsa ushlab turmaydi

# Hisoblangan qatorlar va harakatlar. Birlik: "10 ta harakat". Ko‘plik: "ba’zi sikllar".
term-rows = qator
term-motions = harakat
term-cycles = sikllar
term-free-whirls = erkin pretsessiyalar
term-motions-on-the-loci = chiziqlardagi harakatlar

# Harakat nega natija bermadi: "harakat ...".
term-grows-without-bound = cheksiz o‘sadi
term-leaves-the-range-of-numbers = sonlar diapazonidan chiqadi
term-needs-steps-below-the-resolution-of-time = vaqt aniqligidan kichik qadamlarni talab qiladi
term-needs-too-many-steps = juda ko‘p qadam talab qiladi
term-cannot-start = boshlana olmaydi
term-changes-side-too-often = kuch qonunining tomonini juda tez-tez almashtiradi
term-shooting-was-lost = nishonga olish usulida yo‘qoldi

# Sharchalar harakatining yakuni.
term-balanced = balansirlangan
term-partly-balanced = qisman balansirlangan
term-unbalance-reduced = disbalans kamaygan
term-masses-touching = sharchalar bir-biriga tegib turadi
term-masses-together = sharchalar birgalikda
term-masses-opposed = sharchalar qarama-qarshi
term-masses-apart = sharchalar alohida
term-single-state = sinxron holat
term-balanced-unstable = balansirlangan, noturg‘un
term-partly-balanced-unstable = qisman balansirlangan, noturg‘un
term-unbalance-reduced-unstable = disbalans kamaygan, noturg‘un
term-masses-touching-unstable = sharchalar bir-biriga tegib turadi, noturg‘un
term-masses-together-unstable = sharchalar birgalikda, noturg‘un
term-masses-opposed-unstable = sharchalar qarama-qarshi, noturg‘un
term-masses-apart-unstable = sharchalar alohida, noturg‘un
term-single-state-unstable = sinxron holat, noturg‘un
term-at-rest-balanced = tinch: balansirlangan
term-at-rest-partly-balanced = tinch: qisman balansirlangan
term-at-rest-unbalance-reduced = tinch: disbalans kamaygan
term-at-rest-masses-touching = tinch: sharchalar bir-biriga tegib turadi
term-at-rest-masses-together = tinch: sharchalar birgalikda
term-at-rest-masses-opposed = tinch: sharchalar qarama-qarshi
term-at-rest-masses-apart = tinch: sharchalar alohida
term-at-rest-single-state = tinch: sinxron holat
term-masses-go-round = sharchalar aylanib yuradi
term-some-masses-go-round = ba’zi sharchalar aylanib yuradi
term-masses-swing = sharchalar tebranadi
term-at-rest = tinch
term-moves-on = harakatda davom etadi

# Qo‘shimcha holatlar oilalari.
term-from-low-speed = past tezlikdan boshlangan
term-from-high-speed = yuqori tezlikdan boshlangan
term-x-and-y-on-different-states = x va y bo‘yicha turli holatlarda
term-of-less-symmetry = simmetriyasi kamroq
term-of-doubled-period = davri ikkilangan
term-repeating-every-2-turns = har 2 ta aylanishda takrorlanuvchi
term-repeating-every-3-turns = har 3 ta aylanishda takrorlanuvchi
term-of-longer-period = davri uzunroq
term-apart-from-the-others = boshqalardan alohida

# Bifurkatsiya chizig‘i yoki tarmoq nega tugadi.
term-its-start-did-not-converge = uning boshlang‘ich nuqtasi yaqinlashmadi
term-no-further-point-was-found-as-where-it-meets-another-locus = keyingi nuqta topilmadi, masalan boshqa chiziq bilan uchrashgan joydagi kabi
term-the-linear-parts-have-no-response-at-this-speed = chiziqli qismlarning bu tezlikda javobi yo‘q
term-the-jacobian-has-no-single-null-vector = yakobianning yagona nol vektori yo‘q
term-the-bordered-jacobian-is-singular-neither-a-simple-fold-nor-a-simple-branch-point = hoshiyalangan yakobian singulyar: bu oddiy buklanish ham, oddiy tarmoqlanish nuqtasi ham emas
term-the-locus-leaves-the-range-of-speeds = chiziq tezlik oralig‘idan chiqadi
term-the-machine-does-not-exist-at-this-value-of-the-parameter = parametrning bu qiymatida mashina mavjud emas
term-the-machine-does-not-exist-at-this-value = bu qiymatda mashina mavjud emas
term-the-nonlinear-coordinates-change-with-the-parameter = parametr bilan chiziqsiz koordinatalar o‘zgaradi
term-the-stability-of-the-motion-cannot-be-assessed-there = u yerda harakatning turg‘unligini baholab bo‘lmaydi
term-the-motion-has-no-exponents = harakatning ko‘rsatkichlari yo‘q
term-the-states-do-not-form-a-surface-there = u yerda holatlar sirt hosil qilmaydi
term-a-monitored-quantity-is-not-finite = kuzatilayotgan kattalik chekli emas

# Limit sikllar oilasi nega boshlanmadi.
term-the-family-of-another-onset-ends-here = bu yerda boshqa qo‘zg‘alish oilasi tugaydi
term-the-machine-is-pushed-aside-without-whirling = mashina pretsessiyasiz chetga suriladi
term-its-cycles-lie-outside-the-range-of-speeds = uning sikllari tezlik oralig‘idan tashqarida
term-it-does-not-deflect-the-nonlinear-parts-and-its-growth-has-no-bound = u chiziqsiz qismlarni deformatsiyalamaydi va o‘sishi chegaralanmagan
term-no-small-cycle-was-found-near-it = uning yaqinida kichik sikl topilmadi

# Turg‘unlik nega baholanmadi.
term-the-maps-over-the-period-took-more-steps-than-a-response-is-given = davr akslantirishlari bir javob uchun berilganidan ko‘p qadam oldi
term-a-force-changes-too-abruptly-for-the-map-over-the-period-to-be-integrated = kuch juda keskin o‘zgaradi, davr akslantirishini integrallab bo‘lmaydi
term-the-map-over-the-period-ended-early = davr akslantirishi erta tugadi
term-hill-s-method-is-for-machines-whose-nonlinear-parts-have-neither-mass-nor-states = Hill usuli chiziqsiz qismlarida massa ham, holatlar ham bo‘lmagan mashinalar uchun mo‘ljallangan
term-hill-s-method-is-for-motions-along-which-no-law-switches = Hill usuli davomida hech bir kuch qonuni almashinmaydigan harakatlar uchun mo‘ljallangan

# Taqribiy usul nega bajarilmadi.
term-no-step-of-the-integration-however-short-met-its-tolerance = integrallashning hech qanday kichik qadami kerakli aniqlikni bermadi
term-the-integration-was-stopped = integrallash to‘xtatildi
term-it-is-written-for-a-law-that-acts-on-x-and-y-apart-and-alike-symmetric-by-a-quarter-turn-not-by-any = u x va y bo‘yicha alohida va bir xil ta’sir qiladigan kuch qonuni uchun yozilgan (chorak burilishga simmetrik, ixtiyoriy burilishga emas)
term-the-machine-drifts = mashina siljib ketadi
term-it-is-written-for-one-deflection-with-a-force-that-depends-on-nothing-else = u kuchi faqat bitta deformatsiyaga bog‘liq bo‘lgan hol uchun yozilgan
term-the-nonlinear-force-is-not-c0-d-c1-d-3-in-x-and-y-apart = chiziqsiz kuch x va y bo‘yicha alohida c0 d + c1 d^3 ko‘rinishida emas
term-the-law-does-not-harden-its-free-oscillation-is-no-elliptic-cosine = kuch qonuni qattiqlashmaydi: uning erkin tebranishi elliptik kosinus emas

# Boshlang‘ich muvozanat.
term-the-machine-has-no-equilibrium-under-its-loads-some-coordinate-is-not-held-by-any-stiffness = mashinaning yuk ostida muvozanat holati yo‘q: qandaydir koordinatani hech bir bikrlik ushlab turmaydi

# Ajratish modelining qo‘llanish sohasi: sonlar nomi va ma’nosi.
term-reynolds = Reynolds soni
term-inertia = inersiya soni
term-dilute = hajmiy ulush
term-brownian = Pekle soni
term-gravity = maydonning og‘irlik kuchiga nisbati
term-surface = sirt egriligi
term-mouth = suyuqlikning og‘izga yetishi
term-wall-share = devor ulushi
term-spin-up = tezlashish soni
term-stokes-law-overstates-the-velocity-above-1-use-drag-schiller-naumann = Stoks qonuni tezlikni oshirib beradi; qiymat 1 dan katta bo‘lsa, drag = "schiller_naumann" ishlating
term-the-drag-law-ends-at-the-drag-crisis = qarshilik qonuni qarshilik krizisida tugaydi
term-inertia-and-coriolis-forces-are-felt-below-10-drag-laws-of-still-liquid-are-doubtful = inersiya va Koriolis kuchlari sezilarli; qiymat 10 dan kichik bo‘lsa, tinch suyuqlik uchun qarshilik qonunlari shubhali
term-particles-hinder-each-other-more-than-the-model-says = zarralar bir-biriga modeldagidan ko‘proq xalaqit beradi
term-diffusion-works-against-settling-trajectories-alone-mislead = diffuziya cho‘kishga qarshi ta’sir qiladi: trayektoriyalarning o‘zi noto‘g‘ri xulosaga olib keladi
term-tilt-and-settling-depend-strongly-on-gravity = og‘ish va cho‘kish og‘irlik kuchiga kuchli bog‘liq
term-the-free-surface-is-curved-which-the-model-of-a-swinging-cup-leaves-out = erkin sirt egri, osma stakan modeli buni hisobga olmaydi
term-the-field-at-the-innermost-liquid-over-gravity-is-not-large-the-model-of-machines-that-liquid-flows-through-leaves-gravity-out = eng ichki suyuqlikdagi maydonning og‘irlik kuchiga nisbati katta emas; oqimli mashinalar modeli og‘irlik kuchini hisobga olmaydi
term-the-liquid-reaches-the-mouth-without-a-cap-it-spills = suyuqlik og‘izga yetadi: qopqoqsiz u to‘kiladi
term-most-particles-meet-the-side-wall-where-they-slide-on-in-reality-which-clears-the-liquid-sooner = ko‘pchilik zarralar yon devorga uriladi, aslida ular devor bo‘ylab sirpanib boradi va suyuqlik tezroq tozalanadi
term-the-liquid-lags-behind-the-cup-while-the-speed-changes = tezlik o‘zgarayotganda suyuqlik stakandan orqada qoladi

# Birliklarning o‘lchamligi so‘z bilan.
term-a-pure-number = o‘lchamsiz son
term-a-speed = aylanish tezligi
term-a-length = uzunlik
term-a-mass = massa
term-a-time = vaqt
term-an-angle = burchak
term-a-force = kuch
term-a-stiffness = bikrlik
term-a-damping-constant = so‘ndirish koeffitsiyenti
term-a-cubic-stiffness = kubik bikrlik
term-a-hertz-contact-stiffness = Hertz kontakt bikrligi
term-a-pressure = bosim
term-a-rotational-stiffness = burchak bikrligi
term-a-rotational-damping-constant = burchak so‘ndirish koeffitsiyenti
term-a-torque = moment
term-an-energy = energiya
term-a-power = quvvat
term-an-unbalance = disbalans
term-a-moment-of-inertia = inersiya momenti
term-an-area = yuza
term-a-volume = hajm
term-a-second-moment-of-area = kesimning inersiya momenti
term-a-density = zichlik
term-a-mass-per-length = uzunlik birligiga to‘g‘ri keladigan massa
term-a-velocity = chiziqli tezlik
term-an-acceleration = tezlanish
term-an-angular-acceleration = burchak tezlanishi
term-a-rate = sur’at
term-a-rate-squared = sur’at kvadrati
term-a-number-per-length = uzunlik birligiga to‘g‘ri keladigan son
term-a-number-per-area = yuza birligiga to‘g‘ri keladigan son
term-a-dynamic-viscosity = dinamik qovushqoqlik
term-a-kinematic-viscosity = kinematik qovushqoqlik
term-a-volume-flow = hajmiy sarf
term-a-temperature = harorat
term-a-coefficient-per-kelvin = bir kelvinga to‘g‘ri keladigan koeffitsiyent
term-a-heat-conductance = issiqlik o‘tkazuvchanligi
term-a-heat-capacity = issiqlik sig‘imi
term-a-current = tok
term-a-voltage = kuchlanish
term-a-resistance = elektr qarshiligi
term-an-inductance = induktivlik
term-a-force-per-current = tok birligiga to‘g‘ri keladigan kuch
term-a-torque-per-current = tok birligiga to‘g‘ri keladigan moment
term-a-voltage-constant = kuchlanish doimiysi
term-an-impulse = impuls
term-a-stiffness-density-gradient = bikrlik zichligi gradiyenti
term-a-torque-over-the-square-of-a-speed = momentning tezlik kvadratiga nisbati
term-an-angular-momentum = impuls momenti
term-an-angle-per-length = uzunlik birligiga to‘g‘ri keladigan burchak

# Meanings of keys and of their words.
term-10-u-3-15-u-4-6-u-5 = 10 u^3 - 15 u^4 + 6 u^5
term-c-r2-2-3-r1-r2-4-r1-2-8 = C = (r2^2 + 3 r1 r2 + 4 r1^2)/8
term-c-r2-2-r1-r2-2-r1-2-4-tubular-slices-averaged-over-the-cone = C = (r2^2 + r1 r2 + 2 r1^2)/4: konus bo‘yicha o‘rtachalangan naysimon qatlamlar
term-cb-d-d0-3-2-along-d-the-same-in-all-directions = d bo‘ylab Cb [|d| - d0]^(3/2): barcha yo‘nalishlarda bir xil
term-english = ingliz tili
term-russian = rus tili
term-kazakh = qozoq tili
term-uzbek-latin-letters = o‘zbek tili, lotin yozuvi
term-kloss-s-curve-torque-at-breakdown-synchronous-speed-breakdown-slip = Kloss egri chizig‘i: kritik moment, synchronous_speed, breakdown_slip
term-a-rigid-ring-for-bounds-only = qattiq halqa: faqat baholash uchun
term-a-study-beyond-the-speeds-of-the-table-is-refused = jadval tezliklaridan tashqaridagi tadqiqot rad etiladi
term-a-support-or-a-shaft-that-does-not-turn = aylanmaydigan tayanch yoki val
term-acceleration-that-begins-and-ends-at-zero = noldan boshlanib, nol bilan tugaydigan tezlanish
term-against-deflection-and-slope = egilish va burilishga qarshi
term-against-deflection-only = faqat egilishga qarshi
term-all-on-the-axis-where-it-takes-longest-full-clearing-as-k-factor-and-sigma-count = hammasi yo‘l eng uzoq bo‘lgan o‘qda: k-omil va Sigma hisoblagandek to‘liq tindirish
term-all-orders = barcha tartiblar
term-all-three = uchalasi ham
term-also-mixed-less-symmetric-and-subharmonic-states-and-those-apart-from-the-others = shuningdek aralash, kamroq simmetrik va subgarmonik holatlar hamda boshqalardan alohida turganlar
term-angle-between-disc-and-spin-axis-th = tarelka va aylanish o‘qi orasidagi burchak, th
term-angle-between-tube-and-spin-axis = probirka va aylanish o‘qi orasidagi burchak
term-any-growth-with-what-takes-up-energy-inside-the-parts-that-turn-refused-where-no-part-has-a-layer-that-does = har qanday o‘sish, aylanuvchi qismlar ichidagi energiya yo‘qotilishi bilan; bunday qism bo‘lmasa, rad etiladi
term-as-many-e-folds-of-the-slowest-mode-as-the-tolerance-requires = eng sekin moda aniqlik talab qilgancha e marta kamayadi
term-axes-at-rest = qo‘zg‘almas o‘qlar
term-axes-that-turn-with-the-rotor = rotor bilan aylanadigan o‘qlar
term-both-side-by-side = ikkalasi ham, yonma-yon
term-c0-d-c1-d-2-d = c0 d + c1 |d|^2 d
term-c0-dx-c1-dx-3-and-c0-dy-c1-dy-3 = c0 dx + c1 dx^3 va c0 dy + c1 dy^3
term-cavity-height-h = bo‘shliq balandligi h
term-cavity-radius-r = bo‘shliq radiusi R
term-changes-of-stability-away-from-folds-alone = faqat buklanishlardan tashqaridagi turg‘unlik o‘zgarishlari
term-constant-acceleration = o‘zgarmas tezlanish
term-constant-rate-relative-to-the-speed-coasting-down-against-viscous-drag = tezlikka nisbatan o‘zgarmas sur’at: qovushqoq qarshilikda erkin sekinlashish
term-contact-coefficient-cb-of-the-whole-bearing = butun podshipnikning kontakt koeffitsiyenti Cb
term-contact-stiffness-k = kontakt bikrligi k
term-cubic-coefficient-c1-of-the-total-force = to‘liq kuchning kubik koeffitsiyenti c1
term-damping-c = so‘ndirish c
term-density-of-the-liquid-rho-f = suyuqlik zichligi, rho_f
term-density-of-the-particles-rho-p-the-median-where-they-differ = zarralar zichligi, rho_p; har xil bo‘lsa, medianasi
term-deviation-standard-deviation-mean-unless-it-is-the-value-of-the-machine = deviation: o‘rtacha kvadratik og‘ish; o‘rtacha qiymat mashinanikidan farq qilsa, mean
term-diameter-d-of-the-shaft = val diametri d
term-distance-from-the-hinge-to-the-bottom-along-the-cup-l = stakan bo‘ylab sharnirdan tubigacha masofa, L
term-distributions-alone = faqat taqsimotlar
term-drag-and-field-in-balance = qarshilik va maydon muvozanatda
term-each-ring-turns-about-its-node-line-its-tilt-is-a-coordinate = har bir halqa o‘z tugun chizig‘i atrofida buriladi: uning og‘ishi koordinatadir
term-elementary-effects-of-morris-instead-of-distributions-samples-times-number-of-parameters-1-runs = taqsimotlar o‘rniga Morrisning elementar ta’sirlari: samples × (parametrlar soni + 1) hisob
term-equal-ratios = teng nisbatlar
term-equal-steps = teng qadamlar
term-every-motion-is-followed-to-its-end = har bir harakat oxirigacha hisoblanadi
term-every-stable-steady-state-must-keep-the-limits = har bir turg‘un barqaror holat chegaralarga rioya qilishi kerak
term-exact-at-a-held-speed-with-stokes-drag-otherwise-with-inertia-for-particles-whose-drag-rate-is-below-100-times-the-spin-speed-drifting-for-the-rest = o‘zgarmas tezlikda va Stoks qarshiligida aniq; aks holda relaksatsiya sur’ati aylanish tezligining 100 barobaridan past zarralar inersiya bilan, qolganlari dreyf bilan
term-explicit-unless-memory-states-or-stability-make-it-slow = xotira o‘zgaruvchilari yoki turg‘unlik sekinlashtirmasa, oshkor usul
term-first-bending-mode-of-a-round-shaft-on-simple-supports-the-disc-then-has-half-the-mass-of-the-shaft = sharnirli tayanchlardagi dumaloq valning birinchi egilish modasi; disk massasi valning yarmiga teng
term-first-order-and-total-indices-of-sobol-samples-times-number-of-parameters-2-runs = Sobolning birinchi tartibli va to‘liq indekslari: samples × (parametrlar soni + 2) hisob
term-five-e-folds-then-newton-s-method-on-the-poincare-map-the-long-way-where-it-fails = e^5 marta so‘nish, so‘ng Puankare akslantirishi uchun Nyuton usuli; muvaffaqiyatsiz bo‘lsa, uzoq yo‘l
term-flow-in-three-dimensions-exact-in-the-frequency-domain-in-time-a-sum-over-waves = uch o‘lchamli oqim; chastota sohasida aniq, vaqtda to‘lqinlar yig‘indisi
term-folds-alone = faqat buklanishlar
term-folds-and-changes-of-stability = buklanishlar va turg‘unlik o‘zgarishlari
term-from-and-to-or-tolerance-half-the-width-about-the-value-of-the-machine = from va to yoki tolerance: mashina qiymati atrofidagi kenglikning yarmi
term-from-each-speed-to-the-next-higher-one = har bir tezlikdan keyingi yuqorisiga
term-from-each-speed-to-the-next-lower-one = har bir tezlikdan keyingi pastiga
term-from-the-mouth-to-the-bottom = og‘zidan tubigacha
term-from-the-same-state-at-every-speed-which-motion-is-reached-depends-on-it = har bir tezlikda bir xil holatdan: qaysi harakatga yetilishi shunga bog‘liq
term-gravity-acts-along-the-axis = og‘irlik kuchi o‘q bo‘ylab ta’sir qiladi
term-gravity-points-to-y = og‘irlik kuchi -y yo‘nalishida
term-growth-above-growth-threshold = growth_threshold dan yuqori o‘sish
term-how-much-liquid = suyuqlik miqdori
term-how-the-cubic-force-depends-on-direction = kubik kuchning yo‘nalishga bog‘liqligi
term-how-the-force-depends-on-direction = kuchning yo‘nalishga bog‘liqligi
term-implicit-order-5 = oshkormas, 5-tartib
term-independent-random-points = mustaqil tasodifiy nuqtalar
term-inertia-of-every-particle-the-swing-of-the-cups-in-a-run-up = har bir zarraning inersiyasi, tezlanishda stakanlarning og‘ishi
term-inner-edge-of-the-discs-r1 = tarelkalarning ichki cheti, r1
term-inner-radius-of-the-bowl-r2 = barabanning ichki radiusi, r2
term-inner-radius-r = ichki radius, r
term-largest-least-margin-where-it-is-nearly-the-same-the-largest-next-one = eng kichik zaxiraning eng kattasi; deyarli teng bo‘lsa, keyingisining eng kattasi
term-least-kinetic-energy-and-work-of-the-drive = eng kam kinetik energiya va yuritma ishi
term-length-a-of-the-shaft-from-the-lower-support-to-the-point = pastki tayanchdan nuqtagacha val uzunligi a
term-length-b-of-the-shaft-from-the-point-to-the-upper-support = nuqtadan yuqori tayanchgacha val uzunligi b
term-length-of-the-cylinder-l1 = silindr uzunligi, L1
term-length-of-the-liquid-lb = suyuqlik uzunligi, Lb
term-linear-coefficient-c0-of-the-total-force = to‘liq kuchning chiziqli koeffitsiyenti c0
term-liquid-density-rho = suyuqlik zichligi rho
term-lower-ends-of-two-initial-values-displacements-drum-x-rates-drum-x-or-internal-states-the-map-shows-coordinates-before-rates-before-internal-states-the-first-along-x = ikki boshlang‘ich qiymatning pastki chegaralari: ko‘chishlar ("drum.x"), tezliklar ("drum.x'") yoki ichki o‘zgaruvchilar; xaritada koordinatalar tezliklardan, ular ichki o‘zgaruvchilardan oldin turadi: birinchisi x bo‘ylab
term-mass-m = massa M
term-mass-m-of-a-ball = sharcha massasi m
term-no-geometry-the-stiffness-is-given = geometriyasiz: bikrlik berilgan
term-number-of-gaps-n = tirqishlar soni, N
term-on-large-maps-a-motion-ends-as-soon-as-it-is-known-where-it-goes-it-came-half-as-near-to-an-attractor-as-any-motion-followed-beforehand-that-went-elsewhere = katta xaritalarda harakat qayerga borishi ma’lum bo‘lishi bilan to‘xtatiladi: u attraktorga boshqasiga ketgan avvalgi har qanday harakatdan ikki barobar yaqin keldi
term-one-spin-speed-or-a-range-of-200-points-unless-given = bitta aylanish tezligi yoki oraliq; berilmasa, 200 nuqta
term-one-spin-speed-or-a-range-points-400-unless-given-are-added-where-the-response-bends = bitta aylanish tezligi yoki oraliq: javob egilgan joyda nuqtalar (berilmasa, 400) qo‘shiladi
term-one-spin-speed-or-a-range-compared-at-25-points-unless-given = bitta aylanish tezligi yoki oraliq; berilmasa, 25 nuqtada taqqoslanadi
term-only-the-machine-as-it-is = faqat mashinaning o‘zi
term-opposed-contacts-on-each-axis-a-negative-clearance-is-a-preloaded-pair = har bir o‘qda qarama-qarshi kontaktlar; manfiy tirqish – oldindan taranglangan juftlik
term-order-8-for-motions-that-are-not-stiff = 8-tartib, qattiq bo‘lmagan harakatlar uchun
term-outer-edge-of-the-discs-r2 = tarelkalarning tashqi cheti, r2
term-plane-flow-in-every-slice-driven-by-the-motion-of-that-slice = har bir qatlamda shu qatlam harakati keltirib chiqargan tekis oqim
term-plane-flow-and-of-the-reaction-on-tilt-what-needs-no-axial-flow-an-approximation = tekis oqim, og‘ishga reaksiyadan esa o‘q bo‘ylab oqim talab qilmaydigan qismi: taqribiy
term-plane-flow-driven-by-the-motion-of-the-cavity-centre-no-reaction-on-tilt = bo‘shliq markazi harakati keltirib chiqargan tekis oqim; og‘ishga reaksiyasiz
term-points-of-a-scrambled-sobol-sequence-which-fill-the-space-evenly = fazoni bir tekis to‘ldiradigan aralashtirilgan Sobol ketma-ketligi nuqtalari
term-proportional-to-the-velocity-re-below-1 = tezlikka proporsional: Re 1 dan kichik
term-radial-gap-g = radial tirqish g
term-radius-of-the-centre-of-the-mouth-from-the-spin-axis = og‘iz markazining aylanish o‘qidan masofasi
term-radius-of-the-hinge-from-the-spin-axis-l-st = sharnirning aylanish o‘qidan masofasi, L_st
term-radius-of-the-liquid-s-surface-r1 = suyuqlik sirtining radiusi, r1
term-radius-r-of-the-circle-the-centres-of-the-balls-run-on = sharcha markazlari harakatlanadigan aylana radiusi r
term-range-of-the-spin-speed-negative-speeds-turn-clockwise = aylanish tezligi oralig‘i; manfiy tezliklar soat mili yo‘nalishida
term-round-shaft-clamped-at-both-ends = ikkala uchi qistirilgan dumaloq val
term-round-shaft-clamped-at-one-end = bir uchi qistirilgan dumaloq val
term-round-shaft-on-simple-supports = sharnirli tayanchlardagi dumaloq val
term-round-shaft-on-two-simple-bearings-the-disc-beyond-the-second = ikki sharnirli tayanchdagi dumaloq val, disk ikkinchisidan narida
term-shortest-separation-or-largest-throughput = eng qisqa ajratish yoki eng katta unumdorlik
term-smallest-vibration-against-its-limits = chegaralarga nisbatan eng kichik tebranish
term-speeds-over-which-states-are-followed-from-a-ten-thousandth-of-the-highest-on-at-standstill-nothing-holds-the-masses-points-number-of-speeds-in-the-table-of-states-21-unless-given = holatlar kuzatiladigan tezliklar, eng kattasining o‘n mingdan biridan boshlab (to‘xtaganda massalarni hech narsa ushlamaydi); points: holatlar jadvalidagi tezliklar soni, berilmasa, 21
term-spin-speeds-looked-at-points-120-unless-given-are-added-where-something-happens = ko‘riladigan aylanish tezliklari; o‘zgarish bo‘lgan joyda nuqtalar (berilmasa, 120) qo‘shiladi
term-spin-speeds-to-search-120-points-unless-given = qidiriladigan aylanish tezliklari; berilmasa, 120 nuqta
term-spin-speeds-above-zero-200-points-unless-given = noldan katta aylanish tezliklari; berilmasa, 200 nuqta
term-spin-speeds-120-points-unless-given = aylanish tezliklari; berilmasa, 120 nuqta
term-spin-speeds-rest-is-assessed-at-200-unless-points-are-given = aylanish tezliklari; points berilmasa, muvozanat 200 nuqtada baholanadi
term-spread-evenly-over-the-liquid = suyuqlik bo‘ylab bir tekis
term-stiffness-c2-of-all-supports-together = barcha tayanchlarning umumiy bikrligi c2
term-stiffness-k1-of-the-lower-support = pastki tayanch bikrligi k1
term-stiffness-k2-of-the-upper-support = yuqori tayanch bikrligi k2
term-straight-on-along-the-slope-at-the-ends-results-there-are-marked-as-outside-the-table = uchlaridagi qiyalik bo‘ylab to‘g‘ri davom etadi; u yerdagi natijalar jadvaldan tashqarida deb belgilanadi
term-studies-say-how-the-spin-speed-goes-its-torque-is-a-result = aylanish tezligining borishini tadqiqotlar beradi; uning momenti natijadir
term-the-body-that-carries-it = uni ko‘tarib turgan jism
term-the-body-whose-cavity-it-fills-at-the-middle-of-the-cavity-s-height = bo‘shlig‘ini suyuqlik to‘ldiradigan jism, bo‘shliq balandligining o‘rtasida
term-the-first-and-last-row-hold-beyond-results-there-are-marked-as-outside-the-table = uchlaridan narida birinchi va oxirgi qatorlar amal qiladi; u yerdagi natijalar jadvaldan tashqarida deb belgilanadi
term-the-largest-symmetry-the-machine-has = mashinaning eng yuqori simmetriyasi
term-the-machine-with-few-waves-in-place-of-waves-without-number-of-parts-that-have-such-a-form-of-a-liquid-in-three-dimensions-planar-tilt = uzluksiz spektr o‘rniga sanoqli to‘lqinlari bor mashina, shunday shakli bor qismlar uchun: uch o‘lchamli suyuqlik uchun planar_tilt
term-the-material-turns-with-the-rotor-and-remembers-in-its-axes = material rotor bilan aylanadi, xotirasi uning o‘qlarida
term-the-one-that-the-run-up-of-the-file-leads-to-and-valid-for-that-run-up-only = fayldagi tezlanish olib boradigani; faqat shu tezlanish uchun o‘rinli
term-the-one-with-the-largest-vibration-against-its-limits = chegaralarga nisbatan tebranishi eng katta bo‘lgani
term-the-parameter-along-x-20-points-unless-given = x bo‘ylab parametr; berilmasa, 20 nuqta
term-the-parameter-along-y-20-points-unless-given = y bo‘ylab parametr; berilmasa, 20 nuqta
term-the-parameter-along-y-50-points-unless-given = y bo‘ylab parametr; berilmasa, 50 nuqta
term-the-parameter-and-its-range-points-is-the-number-of-values-at-which-the-response-is-computed-to-find-starts-5-unless-given = parametr va uning oralig‘i; points – boshlang‘ich nuqtalarni topish uchun javob hisoblanadigan qiymatlar soni, berilmasa, 5
term-the-parameters-and-their-bounds-a-range-over-a-decade-and-more-is-searched-in-the-logarithm = parametrlar va ularning chegaralari; dekadadan keng oraliq logarifm bo‘yicha qidiriladi
term-the-point-of-the-rotor-at-which-the-lengths-meet-and-what-the-supports-stand-on = rotorning uzunliklar tutashadigan nuqtasi va tayanchlar turgan narsa
term-the-same-for-what-cannot-be-negative-its-logarithm-is-normal = manfiy bo‘lmaydigan kattaliklar uchun xuddi shu: logarifmi normal taqsimlangan
term-the-same-most-probable-at-mode-the-value-of-the-machine-unless-given = xuddi shu, eng ehtimollisi mode da; berilmasa, mashina qiymatida
term-the-spin-follows-from-the-torques-of-the-parts-such-as-a-motor = aylanishni qismlarning, masalan dvigatelning, momentlari belgilaydi
term-the-state-that-turns-with-the-rotor-seen-in-axes-that-turn-with-it-frequencies-are-counted-from-the-spin = rotor bilan aylanadigan holat, u bilan aylanadigan o‘qlarda (chastotalar aylanishdan hisoblanadi)
term-the-static-equilibrium-seen-in-fixed-axes = qo‘zg‘almas o‘qlardagi statik muvozanat
term-the-tilt-stays-as-it-is = og‘ish o‘zgarmaydi
term-the-two-points-it-joins = u bog‘laydigan ikki nuqta
term-the-two-points-it-joins-the-carried-one-first = u bog‘laydigan ikki nuqta, avval ko‘tariladigani
term-the-two-points-it-keeps-together = u birga ushlab turadigan ikki nuqta
term-the-uncertain-parameters-independent-of-each-other = bir-biriga bog‘liq bo‘lmagan noaniq parametrlar
term-those-of-the-branches-from-both-ends-of-the-range = oraliqning ikkala uchidan chiqadigan tarmoqlardagilari
term-through-the-points-of-the-table = jadval nuqtalari orqali
term-time-to-compute = hisoblanadigan vaqt
term-torque-t-at-standstill-at-breakdown-for-a-squirrel-cage-the-largest-for-limited-power-what-the-shares-of-a-table-are-multiplied-with = moment T: to‘xtaganda; qisqa tutashtirilgan rotor uchun kritik; quvvati cheklangan bo‘lsa, eng kattasi; jadval ulushlarining ko‘paytuvchisi
term-torque-at-every-speed = har qanday tezlikdagi moment
term-torque-at-standstill-falls-in-a-straight-line-to-zero-at-synchronous-speed = to‘xtagandagi moment synchronous_speed da nolgacha chiziqli kamayadi
term-torque-up-to-the-speed-where-it-takes-the-power-less-above = quvvat to‘liq olinadigan tezlikkacha moment, undan yuqorida kamroq
term-two-frequencies-of-a-machine-without-damping-meet-refused-where-something-damps-or-drives = so‘ndirishsiz mashinaning ikki chastotasi uchrashadi; so‘ndirish yoki energiya berish bo‘lsa, rad etiladi
term-up-to-turbulent-flow-around-the-particle = zarra atrofidagi turbulent oqimgacha
term-upper-ends-of-the-same-two = xuddi shu ikkitasining yuqori chegaralari
term-wetted-length-of-the-cone-l2 = konusning ho‘llangan uzunligi, L2
term-what-is-computed-for-every-machine = har bir mashina uchun nima hisoblanadi
term-what-is-computed-for-every-sample = har bir tanlama uchun nima hisoblanadi
term-z-t-t-2-z-t-odd-orders = z(t + T/2) = -z(t): toq tartiblar
term-z-t-t-4-i-z-t-orders-1-3-5-7 = z(t + T/4) = i z(t): 1, -3, 5, -7 tartiblari
