# Fixed phrases that parts supply in English; a name is made of the letters and digits of the phrase.

# Statements of validity: each is a ratio whose limit is 1.
term-tilt-over-0-1-rad = көлбеу бұрышының 0,1 рад мәніне қатынасы
term-bearing-deflection-over-the-range-of-its-law = мойынтірек деформациясының оның заңы жарамды ауқымға қатынасы
term-distance-of-the-speed-from-the-middle-of-the-bearing-table-over-half-its-range = айналу жиілігінің мойынтірек кестесінің ортасынан алшақтығының кестенің жарты ауқымына қатынасы
term-distance-of-the-speed-from-the-middle-of-the-torque-table-over-half-its-range = айналу жиілігінің момент кестесінің ортасынан алшақтығының кестенің жарты ауқымына қатынасы
term-surface-excursion-over-layer-thickness = сұйықтық беті ауытқуының қабат қалыңдығына қатынасы
term-surface-excursion-over-layer-thickness-at-the-spin-frequency = сұйықтық бетінің айналу жиілігіндегі ауытқуының қабат қалыңдығына қатынасы
term-change-of-the-speed-within-a-turn-over-a-tenth-of-it = айналу жиілігінің бір айналымдағы өзгерісінің оның оннан біріне қатынасы
term-distance-of-the-speed-from-that-of-its-form-in-time-over-a-billionth-of-it = айналу жиілігінің уақыттағы форма жиілігінен айырмасының оның миллиардтан біріне қатынасы
term-wall-acceleration-over-centrifugal-acceleration-of-the-layer = қабырға үдеуінің қабаттың центрден тепкіш үдеуіне қатынасы
term-overlap-of-balls-in-contact-over-a-tenth-of-their-size = жанасқан шариктердің бір-біріне енуінің олардың өлшемінің оннан біріне қатынасы
term-size-of-a-ball-over-the-distance-to-the-next = шарик өлшемінің көрші шарикке дейінгі қашықтыққа қатынасы

# Parts with waves or losses, and what helps.
term-a-part = бөлшек
term-an-ideal-liquid = идеал сұйықтық
term-a-viscous-liquid = тұтқыр сұйықтық
term-waves = толқындар
term-inertial-waves = инерциялық толқындар
term-damping-in-the-parts = бөлшектердегі демпферлеу
term-viscosity-in-the-liquid = сұйықтықтың тұтқырлығы
term-damping-in-the-part-gives-it-an-answer = Бөлшектегі демпферлеу оның жауабын береді
term-a-viscosity-model-strip-or-as-an-approximation-axial-harmonics-gives-the-liquid-a-response-at-every-order = Тұтқырлық, model = "strip" немесе жуықтау ретінде axial_harmonics сұйықтықтың әр реттегі жауабын береді
term-what-is-computed-there-are-the-few-waves-kept = онда тек сақталған бірнеше толқын есептеледі
term-what-is-computed-there-are-the-waves-of-the-axial-harmonics-kept-and-every-further-harmonic-puts-others-beside-them-a-viscosity-decides = онда тек сақталған осьтік гармоникалардың толқындары есептеледі, әр қосымша гармоника олардың жанына жаңа толқындар қосады; нақты жауапты тұтқырлық береді
term-without-damping-outside-the-liquid-that-is-every-speed-above-the-critical-speed-of-the-filled-rotor-damping-leaves-a-finite-range-which-little-viscosity-makes-wide = Сұйықтықтан тыс демпферлеу болмаса, бұл – толтырылған ротордың сындық айналу жиілігінен жоғары барлық айналу жиілігі; демпферлеу шектеулі аралық қалдырады, аз тұтқырлықта ол кең.
term-of-the-liquid-s-wave-wave-damping = сұйықтық толқынының демпферлеуі: wave_damping

# Motions and rows that are counted; nouns behind a numeral are singular.
term-free-whirls = еркін прецессиялар
term-cycles = шектік циклдер
term-motions-on-the-loci = бифуркация сызықтарындағы қозғалыстар
term-motions = қозғалыс
term-rows = жол

# Why a motion was not followed, as a verb.
term-grows-without-bound = шексіз өседі
term-leaves-the-range-of-numbers = сандар ауқымынан шығады
term-needs-steps-below-the-resolution-of-time = уақыттың айыру шегінен кіші қадамды қажет етеді
term-needs-too-many-steps = тым көп қадамды қажет етеді
term-cannot-start = басталмайды
term-changes-side-too-often = күш заңының жағын тым жиі ауыстырады
term-shooting-was-lost = ату әдісімен табылмады
term-has-no-run-up = екпіндеуді есептеуге келмейді

# States of balls, as names.
term-balanced = теңгерілген
term-partly-balanced = ішінара теңгерілген
term-unbalance-reduced = дисбалансы азайған
term-masses-touching = шариктер жанасқан
term-masses-together = шариктер беттескен
term-masses-opposed = шариктер қарама-қарсы
term-masses-apart = шариктер бөлек
term-single-state = жалғыз күй
term-balanced-unstable = теңгерілген, орнықсыз
term-partly-balanced-unstable = ішінара теңгерілген, орнықсыз
term-unbalance-reduced-unstable = дисбалансы азайған, орнықсыз
term-masses-touching-unstable = шариктер жанасқан, орнықсыз
term-masses-together-unstable = шариктер беттескен, орнықсыз
term-masses-opposed-unstable = шариктер қарама-қарсы, орнықсыз
term-masses-apart-unstable = шариктер бөлек, орнықсыз
term-single-state-unstable = жалғыз күй, орнықсыз
term-masses-go-round = шариктер айналып жүреді
term-some-masses-go-round = кейбір шариктер айналып жүреді
term-masses-swing = шариктер тербеледі
term-at-rest = тыныштық
term-at-rest-balanced = тыныштық, теңгерілген
term-at-rest-partly-balanced = тыныштық, ішінара теңгерілген
term-at-rest-unbalance-reduced = тыныштық, дисбалансы азайған
term-at-rest-masses-touching = тыныштық, шариктер жанасқан
term-at-rest-masses-together = тыныштық, шариктер беттескен
term-at-rest-masses-opposed = тыныштық, шариктер қарама-қарсы
term-at-rest-masses-apart = тыныштық, шариктер бөлек
term-at-rest-single-state = тыныштық, жалғыз күй

# The same where several of a kind are numbered.
term-balanced-1 = теңгерілген (1)
term-balanced-2 = теңгерілген (2)
term-balanced-3 = теңгерілген (3)
term-balanced-4 = теңгерілген (4)
term-partly-balanced-1 = ішінара теңгерілген (1)
term-partly-balanced-2 = ішінара теңгерілген (2)
term-partly-balanced-3 = ішінара теңгерілген (3)
term-partly-balanced-4 = ішінара теңгерілген (4)
term-unbalance-reduced-1 = дисбалансы азайған (1)
term-unbalance-reduced-2 = дисбалансы азайған (2)
term-unbalance-reduced-3 = дисбалансы азайған (3)
term-unbalance-reduced-4 = дисбалансы азайған (4)
term-masses-touching-1 = шариктер жанасқан (1)
term-masses-touching-2 = шариктер жанасқан (2)
term-masses-touching-3 = шариктер жанасқан (3)
term-masses-touching-4 = шариктер жанасқан (4)
term-masses-together-1 = шариктер беттескен (1)
term-masses-together-2 = шариктер беттескен (2)
term-masses-together-3 = шариктер беттескен (3)
term-masses-together-4 = шариктер беттескен (4)
term-masses-opposed-1 = шариктер қарама-қарсы (1)
term-masses-opposed-2 = шариктер қарама-қарсы (2)
term-masses-opposed-3 = шариктер қарама-қарсы (3)
term-masses-opposed-4 = шариктер қарама-қарсы (4)
term-masses-apart-1 = шариктер бөлек (1)
term-masses-apart-2 = шариктер бөлек (2)
term-masses-apart-3 = шариктер бөлек (3)
term-masses-apart-4 = шариктер бөлек (4)
term-single-state-1 = жалғыз күй (1)
term-single-state-2 = жалғыз күй (2)
term-single-state-3 = жалғыз күй (3)
term-single-state-4 = жалғыз күй (4)
term-balanced-unstable-1 = теңгерілген, орнықсыз (1)
term-balanced-unstable-2 = теңгерілген, орнықсыз (2)
term-balanced-unstable-3 = теңгерілген, орнықсыз (3)
term-balanced-unstable-4 = теңгерілген, орнықсыз (4)
term-partly-balanced-unstable-1 = ішінара теңгерілген, орнықсыз (1)
term-partly-balanced-unstable-2 = ішінара теңгерілген, орнықсыз (2)
term-partly-balanced-unstable-3 = ішінара теңгерілген, орнықсыз (3)
term-partly-balanced-unstable-4 = ішінара теңгерілген, орнықсыз (4)
term-unbalance-reduced-unstable-1 = дисбалансы азайған, орнықсыз (1)
term-unbalance-reduced-unstable-2 = дисбалансы азайған, орнықсыз (2)
term-unbalance-reduced-unstable-3 = дисбалансы азайған, орнықсыз (3)
term-unbalance-reduced-unstable-4 = дисбалансы азайған, орнықсыз (4)
term-masses-touching-unstable-1 = шариктер жанасқан, орнықсыз (1)
term-masses-touching-unstable-2 = шариктер жанасқан, орнықсыз (2)
term-masses-touching-unstable-3 = шариктер жанасқан, орнықсыз (3)
term-masses-touching-unstable-4 = шариктер жанасқан, орнықсыз (4)
term-masses-together-unstable-1 = шариктер беттескен, орнықсыз (1)
term-masses-together-unstable-2 = шариктер беттескен, орнықсыз (2)
term-masses-together-unstable-3 = шариктер беттескен, орнықсыз (3)
term-masses-together-unstable-4 = шариктер беттескен, орнықсыз (4)
term-masses-opposed-unstable-1 = шариктер қарама-қарсы, орнықсыз (1)
term-masses-opposed-unstable-2 = шариктер қарама-қарсы, орнықсыз (2)
term-masses-opposed-unstable-3 = шариктер қарама-қарсы, орнықсыз (3)
term-masses-opposed-unstable-4 = шариктер қарама-қарсы, орнықсыз (4)
term-masses-apart-unstable-1 = шариктер бөлек, орнықсыз (1)
term-masses-apart-unstable-2 = шариктер бөлек, орнықсыз (2)
term-masses-apart-unstable-3 = шариктер бөлек, орнықсыз (3)
term-masses-apart-unstable-4 = шариктер бөлек, орнықсыз (4)
term-single-state-unstable-1 = жалғыз күй, орнықсыз (1)
term-single-state-unstable-2 = жалғыз күй, орнықсыз (2)
term-single-state-unstable-3 = жалғыз күй, орнықсыз (3)
term-single-state-unstable-4 = жалғыз күй, орнықсыз (4)
term-masses-go-round-1 = шариктер айналып жүреді (1)
term-masses-go-round-2 = шариктер айналып жүреді (2)
term-masses-go-round-3 = шариктер айналып жүреді (3)
term-masses-go-round-4 = шариктер айналып жүреді (4)
term-some-masses-go-round-1 = кейбір шариктер айналып жүреді (1)
term-some-masses-go-round-2 = кейбір шариктер айналып жүреді (2)
term-some-masses-go-round-3 = кейбір шариктер айналып жүреді (3)
term-some-masses-go-round-4 = кейбір шариктер айналып жүреді (4)
term-masses-swing-1 = шариктер тербеледі (1)
term-masses-swing-2 = шариктер тербеледі (2)
term-masses-swing-3 = шариктер тербеледі (3)
term-masses-swing-4 = шариктер тербеледі (4)
term-at-rest-1 = тыныштық (1)
term-at-rest-2 = тыныштық (2)
term-at-rest-3 = тыныштық (3)
term-at-rest-4 = тыныштық (4)
term-at-rest-balanced-1 = тыныштық, теңгерілген (1)
term-at-rest-balanced-2 = тыныштық, теңгерілген (2)
term-at-rest-balanced-3 = тыныштық, теңгерілген (3)
term-at-rest-balanced-4 = тыныштық, теңгерілген (4)
term-at-rest-partly-balanced-1 = тыныштық, ішінара теңгерілген (1)
term-at-rest-partly-balanced-2 = тыныштық, ішінара теңгерілген (2)
term-at-rest-partly-balanced-3 = тыныштық, ішінара теңгерілген (3)
term-at-rest-partly-balanced-4 = тыныштық, ішінара теңгерілген (4)
term-at-rest-unbalance-reduced-1 = тыныштық, дисбалансы азайған (1)
term-at-rest-unbalance-reduced-2 = тыныштық, дисбалансы азайған (2)
term-at-rest-unbalance-reduced-3 = тыныштық, дисбалансы азайған (3)
term-at-rest-unbalance-reduced-4 = тыныштық, дисбалансы азайған (4)
term-at-rest-masses-touching-1 = тыныштық, шариктер жанасқан (1)
term-at-rest-masses-touching-2 = тыныштық, шариктер жанасқан (2)
term-at-rest-masses-touching-3 = тыныштық, шариктер жанасқан (3)
term-at-rest-masses-touching-4 = тыныштық, шариктер жанасқан (4)
term-at-rest-masses-together-1 = тыныштық, шариктер беттескен (1)
term-at-rest-masses-together-2 = тыныштық, шариктер беттескен (2)
term-at-rest-masses-together-3 = тыныштық, шариктер беттескен (3)
term-at-rest-masses-together-4 = тыныштық, шариктер беттескен (4)
term-at-rest-masses-opposed-1 = тыныштық, шариктер қарама-қарсы (1)
term-at-rest-masses-opposed-2 = тыныштық, шариктер қарама-қарсы (2)
term-at-rest-masses-opposed-3 = тыныштық, шариктер қарама-қарсы (3)
term-at-rest-masses-opposed-4 = тыныштық, шариктер қарама-қарсы (4)
term-at-rest-masses-apart-1 = тыныштық, шариктер бөлек (1)
term-at-rest-masses-apart-2 = тыныштық, шариктер бөлек (2)
term-at-rest-masses-apart-3 = тыныштық, шариктер бөлек (3)
term-at-rest-masses-apart-4 = тыныштық, шариктер бөлек (4)
term-at-rest-single-state-1 = тыныштық, жалғыз күй (1)
term-at-rest-single-state-2 = тыныштық, жалғыз күй (2)
term-at-rest-single-state-3 = тыныштық, жалғыз күй (3)
term-at-rest-single-state-4 = тыныштық, жалғыз күй (4)

# Kinds of further states.
term-from-low-speed = төмен айналу жиілігінен
term-from-high-speed = жоғары айналу жиілігінен
term-x-and-y-on-different-states = x пен y әртүрлі күйде
term-of-less-symmetry = симметриясы төмен
term-of-doubled-period = периоды екі еселенген
term-repeating-every-2-turns = 2 айналым сайын қайталанатын
term-repeating-every-3-turns = 3 айналым сайын қайталанатын
term-of-longer-period = периоды ұзағырақ
term-apart-from-the-others = басқалардан бөлек
term-moves-on = қозғалыс жалғасады
term-not-settled = орнықпаған
term-failed = есептелмеген

# Why stability was not assessed.
term-a-force-changes-too-abruptly-for-the-map-over-the-period-to-be-integrated = күш тым шұғыл өзгереді, период бойынша бейнелеуді интегралдау мүмкін емес
term-the-map-over-the-period-ended-early = период бойынша бейнелеу ерте аяқталды
term-the-maps-over-the-period-took-more-steps-than-a-response-is-given = период бойынша бейнелеулер бір тербеліске берілген қадам санынан асты
term-hill-s-method-is-for-machines-whose-nonlinear-parts-have-neither-mass-nor-states = Хилл әдісі бейсызық бөлшектерінің массасы да, күйлері де жоқ машиналарға арналған
term-hill-s-method-is-for-motions-along-which-no-law-switches = Хилл әдісі бойында ешбір заң ауыспайтын қозғалыстарға арналған
term-hill-s-determinant-is-for-machines-whose-nonlinear-parts-have-neither-mass-nor-states = Хилл анықтауышы бейсызық бөлшектерінің массасы да, күйлері де жоқ машиналарға арналған
term-hill-s-determinant-is-for-motions-along-which-no-law-switches = Хилл анықтауышы бойында ешбір заң ауыспайтын қозғалыстарға арналған
term-the-exponents-that-grow-could-not-be-counted-on-hill-s-determinant = өсетін көрсеткіштерді Хилл анықтауышы бойынша санау мүмкін болмады
term-counting-the-exponents-that-grow-takes-more-work-than-a-motion-or-a-response-is-given-parts-with-shorter-series-make-it-less = өсетін көрсеткіштерді санау бір қозғалысқа немесе тербеліске берілген есептеу көлемінен асады; қатары қысқарақ бөлшектер оны азайтады

# Why equations are not defined, or a locus ends.
term-the-linear-parts-have-no-response-at-this-speed = бұл айналу жиілігінде сызықты бөлшектердің жауабы жоқ
term-the-jacobian-has-no-single-null-vector = якобианның жалғыз нөлдік векторы жоқ
term-the-locus-leaves-the-range-of-speeds = сызық айналу жиілігінің ауқымынан шығады
term-the-machine-does-not-exist-at-this-value-of-the-parameter = параметрдің бұл мәнінде машина жоқ
term-the-machine-does-not-exist-at-this-value = бұл мәнде машина жоқ
term-the-nonlinear-coordinates-change-with-the-parameter = бейсызық координаталар параметрмен бірге өзгереді
term-the-stability-of-the-motion-cannot-be-assessed-there = онда қозғалыстың орнықтылығын бағалау мүмкін емес
term-the-motion-has-no-exponents = қозғалыстың көрсеткіштері жоқ
term-the-states-do-not-form-a-surface-there = онда күйлер бет түзбейді
term-the-bordered-jacobian-is-singular-neither-a-simple-fold-nor-a-simple-branch-point = көмкерілген якобиан ерекше: жай бұрылу нүктесі де, жай тармақталу нүктесі де емес
term-a-monitored-quantity-is-not-finite = бақыланатын шама ақырлы емес
term-its-start-did-not-converge = бастапқы шарты жинақталмады
term-no-further-point-was-found-as-where-it-meets-another-locus = келесі нүкте табылмады, мысалы ол басқа сызықпен түйіскенде

# Parts without a form in time, and how far forms hold.
term-the-layer-of-a-viscous-liquid-at-the-wall-remembers-its-whole-past = қабырғадағы тұтқыр сұйықтық қабаты бүкіл өткенін есте сақтайды
term-a-liquid-that-flows-along-the-axis-has-infinitely-many-waves = ось бойымен ағатын сұйықтықта шексіз көп толқын бар
term-of-tilts-that-grow-or-decay-by-a-twentieth-of-the-speed-or-more-up-to-four-times-the-speed-in-rotor-axes = өсу не өшу жылдамдығы айналу жиілігінің жиырмадан бірінен кем емес көлбеулер үшін, ротор осьтерінде айналу жиілігінің төрт есесіне дейін
term-of-motions-that-do-not-decay-up-to-four-times-the-speed-in-rotor-axes = өшпейтін қозғалыстар үшін, ротор осьтерінде айналу жиілігінің төрт есесіне дейін

# Why elliptic balance or time integration was left out.
term-it-is-written-for-a-law-that-acts-on-x-and-y-apart-and-alike-symmetric-by-a-quarter-turn-not-by-any = ол x пен y бағыттарында бөлек әрі бірдей әсер ететін заңға арналған (симметриясы ширек айналымда, кез келген бұрышта емес)
term-it-is-written-for-one-deflection-with-a-force-that-depends-on-nothing-else = ол күші тек бір деформацияға тәуелді заңға арналған
term-the-nonlinear-force-is-not-c0-d-c1-d-3-in-x-and-y-apart = бейсызық күш x пен y бағыттарында бөлек c0 d + c1 d^3 түрінде емес
term-the-law-does-not-harden-its-free-oscillation-is-no-elliptic-cosine = заң қатаймайды: оның еркін тербелісі эллиптикалық косинус емес
term-the-machine-drifts = машина ығысып кетеді
term-the-deflection-feels-no-mass = деформацияға масса әсер етпейді
term-no-step-of-the-integration-however-short-met-its-tolerance = интегралдаудың ешбір қадамы, қаншалықты қысқа болса да, дәлдік талабын қанағаттандырмады
term-the-integration-was-stopped = интегралдау тоқтатылды

# Why no limit cycle was followed.
term-the-family-of-another-onset-ends-here = мұнда басқа қозудан басталған топ аяқталады
term-the-machine-is-pushed-aside-without-whirling = машина прецессиясыз бір жаққа ығысады
term-its-cycles-lie-outside-the-range-of-speeds = оның циклдері айналу жиілігінің ауқымынан тыс жатыр
term-it-does-not-deflect-the-nonlinear-parts-and-its-growth-has-no-bound = ол бейсызық бөлшектерді деформацияламайды, өсуі шексіз
term-no-small-cycle-was-found-near-it = оның маңында кіші цикл табылмады

# Why a motion has no equilibrium, or a particle no path.
term-the-machine-has-no-equilibrium-under-its-loads-some-coordinate-is-not-held-by-any-stiffness = жүктеме астында машинаның тепе-теңдігі жоқ: бір координатаны ешбір қатаңдық ұстап тұрған жоқ
term-without-spin-nothing-holds-the-layer-on-the-wall = айналусыз қабатты қабырғада ештеңе ұстап тұрмайды
term-no-path-in-space = кеңістіктік траектория жоқ
term-no-place-of-the-liquid-is-found-where-a-path-begins = сұйықтықта траектория басталатын орын табылмады

# Numbers that show whether a separation is within validity, and their meaning.
term-reynolds = Рейнольдс саны
term-inertia = инерция көрсеткіші
term-dilute = көлемдік үлес
term-brownian = Пекле саны
term-gravity = өрістің ауырлық күшіне қатынасы
term-surface = бет қисықтығы
term-mouth = ауызға жету
term-wall-share = бүйір қабырға үлесі
term-spin-up = айналымға тартылу уақыты
term-stokes-law-overstates-the-velocity-above-1-use-drag-schiller-naumann = Стокс заңы жылдамдықты асыра көрсетеді; 1-ден жоғары болса, drag = "schiller_naumann" қолданыңыз
term-the-drag-law-ends-at-the-drag-crisis = кедергі заңы кедергі дағдарысына дейін ғана жарамды
term-inertia-and-coriolis-forces-are-felt-below-10-drag-laws-of-still-liquid-are-doubtful = инерция мен Кориолис күштерінің әсері сезіледі; 10-нан төмен болса, тыныш сұйықтықтың кедергі заңдары күмәнді
term-particles-hinder-each-other-more-than-the-model-says = бөлшектер бір-біріне модель көрсеткеннен көбірек кедергі жасайды
term-diffusion-works-against-settling-trajectories-alone-mislead = диффузия тұнуға қарсы әсер етеді: тек траекториялар бойынша қорытынды қате
term-tilt-and-settling-depend-strongly-on-gravity = көлбеулік пен тұну ауырлық күшіне қатты тәуелді
term-the-free-surface-is-curved-which-the-model-of-a-swinging-cup-leaves-out = еркін бет қисық, бұрылмалы стаканның моделі мұны ескермейді
term-the-field-at-the-innermost-liquid-over-gravity-is-not-large-the-model-of-machines-that-liquid-flows-through-leaves-gravity-out = ең ішкі сұйықтықтағы өрістің ауырлық күшіне қатынасы үлкен емес; ағынды машиналар моделі ауырлық күшін ескермейді
term-the-liquid-reaches-the-mouth-without-a-cap-it-spills = сұйықтық ауызға жетеді: қақпақсыз төгіледі
term-most-particles-meet-the-side-wall-where-they-slide-on-in-reality-which-clears-the-liquid-sooner = бөлшектердің көбі бүйір қабырғаға жетеді, шын мәнінде олар сол бойымен сырғиды, сондықтан сұйықтық тезірек тазарады
term-the-liquid-lags-behind-the-cup-while-the-speed-changes = айналу жиілігі өзгергенде сұйықтық стаканнан қалып қояды

# Dimensions of units, in words.
term-a-pure-number = өлшемсіз сан
term-a-speed = айналу жиілігі
term-a-length = ұзындық
term-a-mass = масса
term-a-time = уақыт
term-an-angle = бұрыш
term-a-force = күш
term-a-stiffness = қатаңдық
term-a-damping-constant = демпферлеу коэффициенті
term-a-cubic-stiffness = кубтық қатаңдық
term-a-hertz-contact-stiffness = Герц жанасуының қатаңдығы
term-a-pressure = қысым
term-a-rotational-stiffness = бұрыштық қатаңдық
term-a-rotational-damping-constant = бұрыштық демпферлеу коэффициенті
term-a-torque = айналдырушы момент
term-an-energy = энергия
term-a-power = қуат
term-an-unbalance = дисбаланс
term-a-moment-of-inertia = инерция моменті
term-an-area = аудан
term-a-volume = көлем
term-a-second-moment-of-area = қиманың инерция моменті
term-a-density = тығыздық
term-a-mass-per-length = ұзындық бірлігіне келетін масса
term-a-velocity = жылдамдық
term-an-acceleration = үдеу
term-an-angular-acceleration = бұрыштық үдеу
term-a-rate = уақыт бірлігіндегі өзгеру жылдамдығы
term-a-rate-squared = өзгеру жылдамдығының квадраты
term-a-number-per-length = ұзындық бірлігіне келетін сан
term-a-number-per-area = аудан бірлігіне келетін сан
term-a-dynamic-viscosity = динамикалық тұтқырлық
term-a-kinematic-viscosity = кинематикалық тұтқырлық
term-a-volume-flow = көлемдік шығын
term-a-temperature = температура
term-a-coefficient-per-kelvin = 1 K температураға келетін коэффициент
term-a-heat-conductance = жылу өткізгіштік
term-a-heat-capacity = жылу сыйымдылығы
term-a-current = ток күші
term-a-voltage = кернеу
term-a-resistance = кедергі
term-an-inductance = индуктивтілік
term-a-force-per-current = ток бірлігіне келетін күш
term-a-torque-per-current = ток бірлігіне келетін момент
term-a-voltage-constant = кернеу тұрақтысы
term-an-impulse = күш импульсі
term-a-stiffness-density-gradient = қатаңдық тығыздығының градиенті
term-a-torque-over-the-square-of-a-speed = моменттің айналу жиілігі квадратына қатынасы
term-an-angular-momentum = импульс моменті
term-an-angle-per-length = ұзындық бірлігіне келетін бұрыш
