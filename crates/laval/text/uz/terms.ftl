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
