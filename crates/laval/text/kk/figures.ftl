# Sentences of figures and tables: descriptions, titles, labels with names and numbers.

# What belongs to a body or part. The owner is a name of the machine file.
label-of = { $what } ({ $owner })
# A point of a body.
label-point = «{ $body }» денесі, { $height } биіктікте
# The same in front of a number.
named-point = { $body } ({ $height } биіктікте)
# A quantity and a reservation about it.
label-noted = { $what }; { $note }
# A flag that is not set.
label-not = { $what } емес
# A mark with a range of the axis.
label-between = { $label }: { $from } – { $to }
# A multiple of the spin speed.
label-order = { $order }×
label-mode = { $number }-мода
label-operating-margin = жұмыстық айналу жиілігі ± { $margin }

# Linear studies.
campbell-alt = Айналу жиілігіне тәуелді { $modes ->
        [one] бір моданың жиілігі мен өсу жылдамдығы
       *[other] { $modes } моданың жиіліктері мен өсу жылдамдықтары
    }, { $criticals ->
        [one] бір сындық айналу жиілігі
       *[other] { $criticals } сындық айналу жиілігі
    } белгіленген.{ $above ->
        [0] {""}
        [one] {" "}Ось шегінен жоғары, { $top } мәнінен әрі: тағы бір мода.
       *[other] {" "}Ось шегінен жоғары, { $top } мәнінен әрі: тағы { $above } мода.
    }
stability-map-operating = жұмыстық айналу жиілігі: { $growth }
stability-map-alt = Айналу жиілігіне тәуелді ең үлкен өсу жылдамдығы, шектік мәннен асатын аралықтар белгіленген. Төменде сол моданың жиілігі; үзіліс басқа модаға ауысуды көрсетеді.
stability-map-alt-parameter = { $parameter } параметріне тәуелді ең үлкен өсу жылдамдығы, { $speed } кезінде.
stability-map-alt-map = Айналу жиілігі мен { $parameter } параметріне тәуелді ең үлкен өсу жылдамдығы, орнықтылық шекарасы көрсетілген.
modes-table = Меншікті модалар; сызықтандыру күйі: { $state }
modes-alt = { $speed } кезіндегі { $modes ->
        [one] бір моданың өсу жылдамдығы
       *[other] { $modes } моданың өсу жылдамдықтары
    } мен жиілігі.
approximation-degree = { $degree }-дәреже
approximation-alt = Сұр сызықтар: машинаның айналу жиілігіне тәуелді жиіліктері мен өсу жылдамдықтары. Нүктелер: оның { $degree }-дәрежелі жуықтауындағы мәндер.
forced-response-amplification = күшейту коэффициенті { $factor }
forced-response-alt = Айналу жиілігіне тәуелді { $bodies ->
        [one] бір дененің амплитудасы
       *[other] { $bodies } дененің амплитудалары
    }{ $bounded ->
        [no] , { $speed } кезінде шексіз
        [none] , резонанс жоқ
       *[yes] ; ең үлкен резонанс { $speed } кезінде
    }.

# Centrifuges.
operating-window-alt = Айналу жиілігіне тәуелді барлық талаптың қорлары, бәрі орындалатын аралықтар белгіленген.
operating-window-alt-none = Айналу жиілігіне тәуелді барлық талаптың қорлары. Әр айналу жиілігінде бір талап бұзылады.
operating-window-alt-time = Талап етілген бөлікті ұстау уақыты айналу жиілігіне тәуелді, берілген уақыт белгіленген.
operating-window-alt-trade = Жұмыс аралығының ең төмен және ең жоғары айналу жиілігі берілген уақытқа тәуелді.
operating-window-alt-map = Айналу жиілігі мен { $parameter } параметріне тәуелді ең кіші қор. Қисық – жұмыс аралығының шекарасы.
operating-window-table-map = Айналу жиілігі мен { $parameter } параметріне тәуелді ең кіші қор (сепарация ең көбі { $places } орыннан)
separation-table-demand = Айналу жиілігіне тәуелді { $share } бөлігін ұстау уақыты
separation-alt-efficiency = Уақытқа тәуелді ұсталған бөлшектер үлесі, берілген уақыт пен талап етілген бөлік белгіленген.
separation-alt-grade = Берілген уақытта ұсталған бөлшектер үлесі олардың диаметріне тәуелді.
separation-alt-demand = Айналу жиілігіне тәуелді талап етілген бөлікті ұстау уақыты.
separation-alt-pellet = Бөлшектер сұйықтықтан шығатын орындар: барлық бөлшектердің үлесі, қабырға үшін стакан бойымен, түп пен бет үшін оның осінен.
separation-alt-paths-bowl = Кейбір бөлшектердің барабан осьтеріндегі жолдары: айналу бағытымен сұйықтыққа қатысты жол және сыртқа қарай жол.
separation-alt-paths-cup = Кейбір бөлшектердің стакан осьтеріндегі жолдары, стаканға көлденең және айналу бағытымен, беттен (сол жақта) түпке дейін (оң жақта).
separation-alt-paths-time = Кейбір бөлшектердің айналу осінен қашықтығы уақытқа тәуелді, олар шыққанға немесе берілген уақыт біткенге дейін.
separation-alt-released = Жіберілген бөлшектің орны мен стаканның көлбеу бұрышы уақытқа тәуелді.

# Studies of parameters.
optimum-alt-search = «{ $aim }» шамасының ең жақсы мәні, { $searches ->
        [one] бір іздеудің
       *[other] { $searches } іздеудің
    } есептеулері бойымен.
optimum-title-profile = Оптимум маңында: { $parameter }
optimum-alt-profile = «{ $aim }» шамасы оптимум арқылы { $parameter } параметріне тәуелді, басқа параметрлер ең жақсы мәндерінде.
optimum-worse = { $share } нашар
sensitivity-place-peak = { $point }, шыңы { $speed } кезінде
sensitivity-place-jump = { $way ->
        [up] екпіндеу
       *[down] баяулау
    } секірісі, { $speed } кезінде
sensitivity-title = Параметрлердің әсері: { $place }
sensitivity-alt = { $count ->
        [one] Ең маңызды параметрдің
       *[other] Ең маңызды { $count } параметрдің
    } салыстырмалы әсері, әрқайсысына екі баған.
sensitivity-table-bars = Сурет бағандары, { $quality ->
        [speed] айналу жиілігіне
        [tilt] көлбеу бұрышына
       *[displacement] ығысуға
    } әсері: { $place }
uncertainty-table-histogram = «{ $quantity }» шамасының гистограммасы: әр бағанның екі шеті
uncertainty-table-distribution = «{ $quantity }» шамасы берілген мәннен төмен нұсқалардың үлесі
uncertainty-table-bars = Сурет бағандары: { $kind }, «{ $quantity }» шамасы
uncertainty-title-distribution = «{ $quantity }» шамасының таралуы ({ $samples ->
        [one] бір нұсқа
       *[other] { $samples } нұсқа
    }{ $alike ->
        [0] {""}
        [one] , таралуы осындай тағы бір шама
       *[other] , таралуы осындай тағы { $alike } шама
    })
uncertainty-alt-distribution = «{ $quantity }» шамасының { $samples ->
        [one] бір нұсқа
       *[other] { $samples } нұсқа
    } бойынша гистограммасы, { $low } – { $high } аралығында.
uncertainty-title-indices = «{ $quantity }» шамасының сезімталдық индекстері
uncertainty-title-effects = «{ $quantity }» шамасына элементар эффектілер
uncertainty-alt-bars = «{ $quantity }» шамасына әсер: { $parameters ->
        [one] бір параметрге
       *[other] { $parameters } параметрдің әрқайсысына
    } бір баған.
uncertainty-share-of-variance = дисперсиядағы үлес, { $samples ->
        [one] бір нұсқадан
       *[other] { $samples } нұсқадан
    }{ $rough ->
        [yes] : шамамен бағаланған
       *[no] {""}
    }
uncertainty-quantile = { $share } квантилі

# Nonlinear studies.
nonlinear-response-alt = Әр дененің айналу жиілігіне тәуелді ең үлкен ығысуы, { $branches ->
        [one] бір тармақта
       *[other] { $branches } тармақта
    }, { $folds ->
        [0] бұрылу нүктесі жоқ
        [one] бір бұрылу нүктесімен
       *[other] { $folds } бұрылу нүктесімен
    }{ $largest ->
        [known] ; ең үлкені { $value } ({ $point }), { $speed } кезінде
       *[unknown] {""}
    }.
nonlinear-response-alt-jumps = Бұрылу нүктелері маңындағы ең үлкен ығысу, үлкейтілген.
nonlinear-response-alt-forces = Айналу жиілігіне тәуелді { $parts ->
        [one] бір бөлшектің
       *[other] { $parts } бөлшектің
    } бір периодтағы ең үлкен күші.
nonlinear-response-alt-orders = Суб- және ультрагармоникалық реттердің айналу жиілігіне тәуелді үлкен жарты осьтері ({ $bodies }), шектік мән белгіленген.
nonlinear-response-limit = { $part }, жоғары айналу жиілігі
nonlinear-response-map-evidence = бүкіл период бойынша бейнелеу, шақтамасы { $tolerance }: күй саны
backbone-begins = { $origin ->
        [mode] { $frequency } жиілігінен
       *[asymptote] { $frequency } асимптотасының жанында
    }
backbone-alt = { $speed } кезінде прецессия жиілігіне тәуелді деформация амплитудасы, { $families ->
        [one] бір топ
       *[other] { $families } топ
    }.
methods-alt = Әр әдістің жинақталған шыңнан ауытқуы айналу жиілігіне тәуелді, барлық күйлер.
limit-cycles-alt = Шектік циклдердің айналу жиілігіне тәуелді ең үлкен ығысуы мен жиілігі: тепе-теңдік орнықсыздығының { $edges ->
        [one] бір шетінен
       *[other] { $edges } шетінен
    } басталған { $families ->
        [one] бір топ
       *[other] { $families } топ
    }.
bifurcation-loci-alt = Айналу жиілігі мен { $parameter } параметрі жазықтығындағы сызықтар: бұрылу нүктелерінің { $folds } сызығы, орнықтылықтың басқа өзгерістерінің { $others } сызығы, { $cusps ->
        [0] үшкір нүкте жоқ
        [one] бір үшкір нүкте
       *[other] { $cusps } үшкір нүкте
    }.
response-map-alt = { $what ->
        [peak] Ең үлкен орнықты ығысу
        [tilt] Ең үлкен орнықты көлбеу бұрышы
        [hysteresis] Бірнеше күйі бар айналу жиіліктері аралығының ені (бір күй болса – бос)
       *[sweeps] Квазистатикалық екпіндеу мен баяулаудың нәтижесі
    }, осьтері: { $x } және { $y }{ $border ->
        [yes] ; секірісі бар және секіріссіз машиналардың шекарасы көрсетілген
       *[no] {""}
    }.
stationary-alt-range = { $state }, { $from } – { $to }
stationary-alt = Айналатын санақ жүйесіндегі айналу жиілігіне тәуелді тепе-теңдік күйлерінің { $branches ->
        [one] бір тармағы
       *[other] { $branches } тармағы
    }; { $stable ->
        [0] ешбір тепе-теңдік орнықты емес
       *[other] орнықтылары: { $ranges }
    }.
stationary-title-stabilised = Теңгерілген күйдің өсу жылдамдығы, { $speed } кезінде
stationary-alt-stabilised = Теңгерілген күйдің { $parameter } параметріне тәуелді ең үлкен өсу жылдамдығы.
stationary-title-chart = Теңгерілген күй: айналу жиілігі және { $parameter } параметрі
stationary-alt-chart = Орнықты күйлердің теңгерілуі айналу жиілігі мен { $parameter } параметріне тәуелді, теңгерілген күйдің анықталған шекарасы көрсетілген.
stationary-title-errors = Қалдық дисбаланс, { $speed } кезінде
stationary-alt-errors = Ең жақсы және ең нашар орнықты күйдің қалдық дисбалансы және шариктерсіз дисбаланс, { $parameter } параметріне тәуелді.
stationary-table-stabilised = Теңгерілген күйдің { $parameter } параметріне тәуелді ең үлкен өсу жылдамдығы, { $speed } кезінде
stationary-table-chart = Айналу жиілігі мен { $parameter } параметріне тәуелді теңгерілген күй және орнықты күйлер
stationary-table-errors = { $parameter } параметрінің қателіктерінен болатын дисбаланс, { $speed } кезінде
stationary-class = { $word ->
        [balanced] теңгерілген
        [partly_balanced] жартылай теңгерілген
        [reduced] дисбаланс азайған
        [touching] шариктер жанасқан
        [together] шариктер бір жерде
        [opposed] шариктер қарама-қарсы
        [spread] шариктер ажыраған
       *[single] тепе-теңдік
    }
stationary-change = { $word ->
        [fold] тармақ бұрылады (бұрылу нүктесі)
        [branch_point] тармақтар қиылысады
        [hopf] тербеліс басталады (Хопф)
       *[real_root] орнықтылық өзгереді
    }
stationary-growing-roots = өсетін түбірлер, { $side ->
        [before] одан бұрын
       *[behind] одан кейін
    }{ $several ->
        [yes] , { $branch }-тармақ
       *[no] {""}
    }

# Motions in time.
history-table-last-turns = Денелердің соңғы { $turns } айналымдағы қозғалысы, әр айналымда { $samples } нүкте
history-alt-envelope = Әр дененің бір айналымдағы тепе-теңдіктен ең үлкен ығысуы, уақытқа тәуелді.
history-alt-lateral = Әр дененің x және y ығысулары, уақытқа тәуелді.
history-alt-orbit = Әр дененің жазықтықтағы жолы, масштабта; нүкте – басы, бағыттама – бағыты.
history-alt-energy = Жиналған энергияның басынан бергі өзгерісі, жылу және машинаға жасалған жұмыс, уақытқа тәуелді. Төменде – энергия балансының қателігі.
balance-alt = Шариктермен және шариктерсіз дисбаланс, шариктердің теңгеру қабілеті және теңгеру дәлдігінің класы, уақытқа тәуелді.
balance-alt-angles = Ротордағы бұрыштар уақытқа тәуелді, −180° – 180° аралығында: шариктер түйін сызығынан, еркін сақиналардың көлбеу бұрыштары.
run-up-alt-drive = Жетектің айналу жиілігі, моменті және қуаты уақытқа тәуелді.
run-up-alt-envelope = Әр дененің бір айналымдағы тепе-теңдіктен ең үлкен ығысуы, айналу жиілігіне тәуелді.
spectra-alt = «{ $body }» денесінің амплитудалары, осьтері: { $along ->
        [speed] айналу жиілігі
       *[time] уақыт
    } және { $over ->
        [order] рет
       *[frequency] жиілік
    }. Оң мәндер – тура прецессия, теріс мәндер – кері прецессия.
sweep-alt = Әр дененің айналу жиілігіне тәуелді ең үлкен ығысуы немесе көлбеу бұрышы (басталуы: { $ways }).
sweep-alt-bifurcation = Нөлдік фазадағы { $state }, айналу жиілігіне тәуелді: периодтың әр айналымына бір нүкте (басталуы: { $ways }).
sweep-alt-waterfall = «{ $body }» денесінің айналу жиілігіне тәуелді рет спектрлері (басталуы: { $way }). Теріс реттер – кері прецессия.
sweep-alt-lyapunov = Айналу жиілігіне тәуелді ең үлкен Ляпунов көрсеткіші (басталуы: { $ways }).
motion-map-alt = { $what }, осьтері: { $x } және { $y }.
basins-alt = { $speed } кезінде әр бастапқы шарттан алынатын аттрактор, осьтері: { $x } және { $y }.
basins-sized = { $body }: { $size } ({ $attractor }-аттрактор)
basins-grid-step = тор қадамы ({ $state })
basins-typical-size = типтік өлшем ({ $state })
animation-alt = Ось бойымен көрініс: денелердің центрлері мен фаза белгісі, жолдар және шариктер. Ығысулар жолдарға қарағанда { $enlarged } есе үлкейтіп салынған.
store-requested = сұралған { $rows }

# How a study ended.
end-place = { $parameter } = { $at }
end-reached = Зерттеу соңына дейін орындалды.
end-step-too-small = Зерттеу ерте тоқтады: { $place } болғанда қадам тым кішірейді.
end-no-solution = Зерттеу ерте тоқтады: { $place } болғанда шешім табылмады (қалдығы { $residual }).
end-no-values = Зерттеу ерте тоқтады: { $place } болғанда шешім табылмады (онда теңдеулердің ақырлы мәні жоқ).
end-unbounded = Зерттеу ерте тоқтады: { $place } болғанда қозғалыс барлық шектен асты.
end-cancelled = Зерттеу сұрау бойынша тоқтатылды; есептелген бөлігі көрсетілген.
end-refused = Зерттеу орындалмады: ол бұл машинаға қолданылмайды.
end-max-points = Зерттеу ерте тоқтады: нүктелердің рұқсат етілген ең көп санына жетті (max_points, --work-limit).
end-work-limit = Зерттеу ерте тоқтады: есептеу көлемінің шегіне жетті (--work-limit); есептелген бөлігі көрсетілген.
