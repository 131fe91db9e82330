# The first page of a report, and the summary in the terminal.

# Verdicts.
verdict-passed = сай келеді
verdict-no_limit = шек берілмеген
verdict-not_computed = есептелмеген
verdict-attention = назар аударыңыз
verdict-failed = сай келмейді

# The same, short, for the terminal.
short-passed = сай
short-no_limit = шек жоқ
short-not_computed = есеп жоқ
short-attention = назар
short-failed = САЙ ЕМЕС
short-near = аз

# Headline.
headline-stable = { $speed } кезінде орнықты.
headline-stable-below = { $speed } кезінде { $limit } жиілігінен төмен модалар бойынша орнықты.
headline-unstable = { $speed } кезінде орнықсыз. Машинаны бұл айналу жиілігінде пайдаланбаңыз.
headline-not-proven = { $speed } кезінде орнықтылық дәлелденген жоқ.
headline-unknown = { $speed } кезінде орнықтылық есептелмеген.
headline-unknown-table = { $speed } кезінде орнықтылық есептелмеген: «{ $part }» коэффициенттері тек { $from } мен { $to } аралығындағы тербеліс жиіліктерінде берілген; осы жиіліктердегі модаларды «modes» зерттеуі береді, қалғандары үшін кестеге басқа жиіліктердің жолдарын қосыңыз.
headline-no-speed = Жұмыстық айналу жиілігі берілмеген.
headline-limit = Орындалмаған талаптар: { $checks }.
headline-not-checked = Талап етілген, бірақ тексерілмеген: { $checks }.
headline-studies-not-run = Файлдағы мына зерттеулер ескерілмеген: { $studies }. Олар көбірек таба алады: іске қосыңыз.
headline-attention = Назар аудару керек: { $checks }.
headline-buckled = Тыныштықта машина орнын сақтамайды (статикалық орнықсыздық): ығысудың e есе өсу уақыты { $time }.
headline-jump = { $kind ->
        [jump] Жауап { $speed } кезінде секіреді
       *[bifurcation] Жауаптың орнықтылығы { $speed } кезінде өзгереді
    }, { $side ->
        [inside] жұмыстық айналу жиіліктерінің арасында
        [above] жұмыстық айналу жиілігінен { $margin } жоғары
       *[below] жұмыстық айналу жиілігінен { $margin } төмен
    }.
headline-resonance = Ең жақын резонансқа ({ $resonance }) дейін бар болғаны { $margin }.
headline-resonance-inside = { $resonance } резонансы жұмыстық айналу жиіліктерінің арасында.
headline-near-instability = Ең жақын орнықсыздыққа дейін бар болғаны { $margin }.
headline-crosses = { $count ->
        [one] Екпіндеу орнықсыз аралықтан өтеді: { $from } – { $to }.
       *[other] Екпіндеу { $from } – { $to } аралығында жатқан { $count } орнықсыз аралықтан өтеді.
    }
headline-crosses-open = Екпіндеу кезінде машина { $from } мәнінен бастап орнықсыз ({ $to } мәніне дейін зерттелді).
headline-slip = Екпіндеу орнықты синхронды күйі жоқ { $from } – { $to } аралығынан өтеді.

# Remarks below it.
remark-here = { $speed } кезінде
remark-below = Екпіндеу кезінде
remark-above = Одан жоғары
remark-unstable = { $open ->
        [yes] { $from } мәнінен бастап орнықсыз ({ $to } мәніне дейін зерттелді):
        [below] { $to } мәніне дейін орнықсыз ({ $from } мәнінен бастап зерттелді):
        [both] Зерттелген барлық айналу жиіліктерінде орнықсыз, { $from } – { $to }:
       *[no] { $from } – { $to } аралығында орнықсыз:
    } { $oscillates ->
        [yes] прецессия, жиілігі { $frequency }
       *[no] тербеліссіз қозғалыс
    }, ең қауіпті айналу жиілігінде e есе өсу уақыты { $time }.
remark-resonance = Резонанс { $speed } кезінде, «{ $body }» денесі { $value }.
remark-resonance-unbounded = Демпферленбеген резонанс { $speed } кезінде: «{ $body }» денесінің амплитудасы шексіз.
remark-resonances = Басқа резонанстар: { $speeds }.
remark-critical = Сындық айналу жиілігі { $speed }.
remark-jump = { $count ->
        [one] Айналу жиілігі баяу өзгергенде секіріс болатын мән: { $speeds }.
       *[other] Айналу жиілігі баяу өзгергенде секіріс болатын мәндер: { $speeds }.
    }
remark-harm = { $from } – { $to } аралығында шариктер дисбалансты { $times } есеге дейін арттырады.
remark-stability = { $text }.
remark-vibration = Тербеліс: { $text }.
remark-forces = Күштер: { $text }.

# Checks: name, result, requirement.
check-stability = Орнықтылық
check-instability = Ең жақын орнықсыздық
check-resonance = Ең жақын резонанс
check-jump = Ең жақын секіріс немесе бифуркация
check-vibration = Тербеліс
check-forces = Күштер
check-validity = Жарамдылық
check-balls = Шариктермен дисбаланс
check-run-up = Екпіндеу

required-decay = { $margin ->
        [none] өшетін
       *[other] өшу ≥ { $margin }
    }
required-below = ≤ { $limit }
required-each = ≤ шектері
required-balance = { $grade }: ≤ { $limit }
required-validity = шек ішінде
required-less-unbalance = шариксіз мәннен аз

stability-stable = { $modes ->
        [one] мода өшеді, өшу жылдамдығы { $decay }
       *[other] барлық { $modes } мода өшеді, ең баяуының өшу жылдамдығы { $decay }
    }
stability-stable-below = { $modes ->
        [one] { $limit } жиілігінен төмен мода { $decay } жылдамдықпен өшеді
       *[other] { $limit } жиілігінен төмен барлық { $modes } мода өшеді, ең баяуы { $decay } жылдамдықпен
    }
stability-across = барлық { $modes } көлденең тербеліс түрі өшеді, ең баяуының көрсеткіші { $decay }; бойлық және бұралу тербелістері демпферленбеген
stability-unstable = { $motion ->
        [divergence] статикалық орнықсыздық (дивергенция), ығысудың
       *[whirl] орнықсыз прецессия, амплитуданың
    } e есе өсу уақыты { $time }
stability-steady = бұл айналу жиілігінде орныққан тербеліс орнықты (бейсызық тербеліс)
stability-decays = ең баяу мода { $decay } жылдамдықпен өшеді
stability-unknown = табылған ешбір мода өспейді, бірақ кейбірі табылмай қалуы мүмкін
stability-slow = ешбір мода { $limit } мәнінен тез өспейді; одан баяу өсу анықталмайды
stability-neutral = ең әлсіз демпферленген моданың демпферлеуі жоқ
stability-balanced = теңгерілген күй орнықты
stability-state = роторды теңгермейтін күй орнықты
stability-no-state = бұл айналу жиілігінде орнықты синхронды күй жоқ
stability-needs-stationary = роторда шариктер қозғалады: «stationary» зерттеуі қажет
stability-mode = { $place ->
        [none] жиілігі { $frequency }, логарифмдік декременті { $decrement }
       *[other] жиілігі { $frequency }, логарифмдік декременті { $decrement }; орнықтылығы ең төмен жұмыстық айналу жиілігі { $place }
    }
stability-no-mode = машинада мода жоқ
distance-both = төменде { $below }, жоғарыда { $above }
distance-below = төменде { $below }, жоғарыда { $to } мәніне дейін жоқ
distance-above = төменде жоқ, жоғарыда { $above }
distance-stable-throughout = { $from ->
        [none] { $to } мәніне дейін табылмады
       *[other] { $from } – { $to } аралығында табылмады
    }
distance-inside-unstable = { $open ->
        [unknown] жұмыстық айналу жиілігі орнықсыз аралықта
        [yes] ішінде, { $from } мәнінен бастап орнықсыз ({ $to } мәніне дейін зерттелді)
        [below] ішінде, { $to } мәніне дейін орнықсыз ({ $from } мәнінен бастап зерттелді)
        [both] ішінде, зерттелген барлық айналу жиіліктерінде орнықсыз, { $from } – { $to }
       *[no] ішінде, { $from } – { $to } аралығында орнықсыз
    }
distance-no-other-resonance = { $from ->
        [none] { $to } мәніне дейін басқасы табылмады
       *[other] { $from } – { $to } аралығында басқасы табылмады
    }
distance-critically-damped = { $speeds } кезінде критикалық демпферленген: күшейту коэффициенті 2,5-тен төмен, API 684 жиілік қорын талап етпейді
distance-not-examined = талап етілген қорға { $from } пен { $to } арасындағы барлық айналу жиілігі керек
distance-coarse = есептелген айналу жиіліктері тым аз: олардың арасында тар аймақ болуы мүмкін
distance-orders-open = { $orders } еселік қоздыру кезіндегі резонанстар ізделген жоқ: critical_speeds зерттеуін қосыңыз
distance-silent = тура прецессияның сындық айналу жиілігі { $speeds }: осы файлдағы теңгерімсіздік оны қоздырмайды, басқасы қоздыруы мүмкін
distance-no-resonance = { $from ->
        [none] { $to } мәніне дейін табылмады
       *[other] { $from } – { $to } аралығында табылмады
    }
item-of = { $name } { $value }, шегі { $limit }
item = { $name } { $value }
item-force = { $rest ->
        [none] { $name } { $value }
       *[other] { $name } { $value } (статикалық { $rest })
    }
both = { $first }; { $second }
vibration-sizes = { $sizes }
vibration-velocity = { $name }: жылдамдық шыңы { $peak }
vibration-unbounded = бұл айналу жиілігінде демпферленбеген резонанс
forces-none = белгісіз
forces-sizes = { $sizes }
forces-with-rest = салмақ сияқты статикалық жүктемемен қоса бір айналымдағы ең үлкен мәні; тербеліс статикалық иілуден саналған
validity-none = ешбір бөлшектің шегі көрсетілмеген
validity-doubt = файл зерттеулерінде күмәнді: { $names }
validity-statement = { $part }, { $what }
validity-inside = ең жақын шектің { $share } бөлігі: { $statement }
validity-elsewhere = бұл айналу жиілігінде шек ішінде; файл зерттеулерінде шектен тыс: { $outside }
validity-outside-here = шектің { $ratio } есесі: { $statement }
validity-unbounded = шектен шексіз асады: { $statement }
validity-nothing = бұл айналу жиілігінде ешбір бөлшек бағаланбады
validity-studies = файл зерттеулерінде шектен тыс: { $outside }
check-run-study = файлдағы «{ $study }» зерттеуін орындаңыз
balls-no-study = «stationary» немесе «transient» зерттеуі қажет
balls-left = { $left } қалды, шариктерсіз { $without }
run-up-computed = ең үлкен ығысу { $value } («{ $body }»)
run-up-steady = ең үлкен ығысу { $value } («{ $body }»), екпіндеу соңында
run-up-unknown = { $speed } мәнінен төмен не болатыны белгісіз
run-up-buckled = тыныштықта машина орнын сақтамайды
run-up-free = резонанстан да, орнықсыз аралықтан да өтпейді
run-up-resonances = { $count ->
        [one] резонанстан өтеді: { $resonances }
       *[other] { $count } резонанстан өтеді: { $resonances }
    }
run-up-unstable = орнықсыз аралықтан өтеді: { $ranges }
run-up-both = { $count ->
        [one] резонанстан ({ $resonances })
       *[other] { $count } резонанстан ({ $resonances })
    } және орнықсыз аралықтан ({ $ranges }) өтеді
speed-span = { $from } – { $to }
why-refused = бұл машина үшін есептелмейді: { $reason }
why-same = сол себептен есептелмейді
why-too-long = бір секундтан ұзақ есептеледі; зерттеуді файлға қосыңыз
from-study = «{ $study }» зерттеуі бойынша
why-no-speed = 0-ден жоғары жұмыстық айналу жиілігі берілмеген

# What to do next.
next-speed = [machine] бөлімінде speed беріңіз: тексеруге жұмыстық айналу жиілігі қажет.
next-unstable = { $sides ->
        [both] { $below } мәнінен төмен немесе { $above } мәнінен жоғары айналу жиілігін таңдаңыз
        [below] { $below } мәнінен төмен айналу жиілігін таңдаңыз
        [above] { $above } мәнінен жоғары айналу жиілігін таңдаңыз
       *[none] Орнықсыз аралықтан тыс айналу жиілігін таңдаңыз
    } немесе демпферлеу қосыңыз; орнықтылық картасын қараңыз.
next-viscosity = Сұйықтықтың тұтқырлығын беріңіз: онсыз { $limit } мәнінен баяу өсу анықталмайды.
next-validity = Жарамдылық туралы қорытындыларды ескеріңіз: онда күмәнді нәтижелер және модельде нені өзгерту керегі аталған.
next-buckled = { $count ->
        [0] Машинаны тыныштықта ұстайтын қатаңдықты арттырыңыз немесе сығатын осьтік күшті азайтыңыз.
       *[other] { $parts } қатаңдығын арттырыңыз немесе сығуды азайтыңыз: тыныштықта өсетін пішінде ол теріс.
    }
next-stability-map = Орнықты айналу жиіліктерін және қажетті демпферлеуді табу үшін «stability_map» зерттеуін қосыңыз.
next-resonance = Жұмыстық айналу жиілігі мен резонанстың арасын { $margin } немесе одан көп алшақтатыңыз немесе демпферлеу қосыңыз.
next-balls = «stationary» зерттеуін қосыңыз: шариктер қандай айналу жиіліктерінде теңгереді.
next-harm = Екпіндеу кезінде шариктерді ұстап тұрыңыз немесе орнықтылық аралығынан төменгі айналу жиіліктерінен жылдам өтіңіз.
next-jump = Жұмыстық айналу жиілігі мен секірістің арасын { $margin } немесе одан көп алшақтатыңыз, дисбалансты азайтыңыз немесе демпферлеуді қосыңыз.
next-run-up = Екпіндеуді модельдеңіз: «run_up» зерттеуін қосыңыз.
next-nonlinear = «nonlinear_response» зерттеуін қосыңыз: машинада бейсызық бөлшектер бар, секірістер болуы мүмкін.
next-limits = [limits] бөлімінде беріңіз: { $keys }; шегі жоқ нәтижелер бағаланбайды.
next-studies = Файлда зерттеу жоқ: [[study]] бөлімдерін қосыңыз, мысалы { $kinds }; барлық түрін laval studies көрсетеді.

# Headings of the page.
page-checks = Тексерулер
page-check = Тексеру
page-result = Нәтиже
page-required = Талап
page-verdict = Қорытынды
page-not-set = берілмеген
page-over-speed = Айналу жиілігіне тәуелділік
page-modes = { $speed } кезіндегі модалар
page-machine = Машина
page-next = Келесі қадамдар
page-findings = Барлық нәтиже
page-fill = толтырылуы { $fill }
page-balls = { $count } шарик
page-mode = { $number }-мода
page-whirl = { $whirl ->
        [forward] тура
        [backward] кері
        [mixed] аралас
        [axial] осьтік
        [torsional] бұралу
       *[none] прецессиясыз
    }
page-decrement = декремент { $decrement }
page-grows = өседі
page-not-resolved = баяу өсу анықталмайды
page-diverges = статикалық орнықсыздық (дивергенция)
axis-amplitude = амплитуда
axis-growth = өсу жылдамдығы
strip-unstable = орнықсыз
strip-not-examined = орнықтылық зерттелмеген
strip-response = орнықсыз жауап
strip-jump = секіріс
axis-speed-plain = айналу жиілігі
axis-operating = жұмыстық айналу жиілігі
strip-stable-limit = одан төмен орнықты
caption-both = Дисбаланстан болатын сызықты тербелістің амплитудасы және орнықтылығы ең төмен моданың өсу жылдамдығы.
caption-amplitude = Дисбаланстан болатын сызықты тербелістің амплитудасы.
caption-growth = Орнықтылығы ең төмен моданың өсу жылдамдығы.
strip-resonance = резонанс

# The rest of the report.
page-evidence = Негіздеме
page-warning = Ескерту
page-outside = Жарамдылық шегінен тыс
page-stopped = Ерте тоқтатылған
page-tables = Кестелер
page-points = Ерекше нүктелер
page-work = Есептеу көлемі
page-input = Бастапқы деректер
page-input-file = Бастапқы файл { $file }
page-provenance = Бұл қалай есептелді
page-more = тағы { $count }, results.json файлында
page-more-studies = тағы { $count }, төмендегі зерттеулерде
page-rows = { $count } жол
page-nothing = Зерттеулерде тұжырым жоқ; олардың графиктері мен кестелерін қараңыз.
page-hint = Мәндерін оқу үшін қисыққа меңзеңіз. Масштабтау үшін тартып апарыңыз, бәрін көру үшін екі рет шертіңіз, қисықты жасыру үшін атауын шертіңіз. Пернелер: бағыттауыштар, +, −, 0.
page-reset = Масштабты қалпына келтіру
page-yes = иә
page-no = жоқ
vibration-unstable = орныққан тербеліс жоқ: машина орнықсыз

# Operating range, further checks and studies left out.
headline-several = Бірнеше орныққан тербелістің қайсысы болатыны екпіндеуге байланысты.
headline-validity = Барлық нәтиже жарамдылық шегінде емес.
check-window = Жұмыс аралығы
check-speed = Ең жоғары айналу жиілігі
check-others = Басқа шектер
check-studies = Зерттеулердің талаптары
check-damping = Демпферлеу
required-above = ≥ { $limit }
stability-no-steady = бұл айналу жиілігінде ешбір орныққан тербеліс орнықты емес (бейсызық тербеліс)
stability-several = бұл айналу жиілігінде { $count } орнықты орныққан тербеліс бар (бейсызық тербеліс)
stability-beside = тыныштық күйі орнықты, бірақ { $value } дейінгі прецессия да орнықты: ұйытқу соған апаруы мүмкін
stability-outside-study = «stationary» зерттеуі бұл айналу жиілігін қамтымайды
stability-unstable-range = жұмыстық айналу жиіліктерінде орнықсыз: { $range }
damping-no-oscillation = тербелмелі мода жоқ
damping-least = логарифмдік декременті { $decrement }, жиілігі { $frequency }
distance-inside = жұмыстық айналу жиіліктерінің арасында: { $places }
vibration-nonlinear = бейсызық машинаның ең үлкен орнықты тербелісі
vibration-states = шариктердің орнықты күйлері бойынша ең үлкені
vibration-contact = сызықты есеп; мына бөлшектер жанасар еді: { $parts }; амплитуда жарамсыз
vibration-touching = тыныштық маңындағы шағын тербелістер; сол күйде жанасып тұрған бөлшектер: { $parts }
response-without-spins = { $spins } теңгерімсіздігінсіз: оны spin өрісі бар "forced_response" есебі қамтиды
response-with-spins = { $spins } дірілі қосылған, spin берілген «forced_response» бойынша
forces-without = бейсызық бөлшектерсіз: { $parts }
forces-not-linear = тыныштықтағы жанама бойынша; дәл сол қозғалыстың заң бойынша күшінен оннан бірінен көп айырмасы бар: { $parts }; nonlinear_response шешеді
window-none = ешбір айналу жиілігі барлық талапты орындамайды
window-ranges = { $ranges }
speed-is = { $speed }
limits-left-out = бұл бетте бағаланбаған: { $names }
studies-requirements = { $studies } ішінде орындалмаған немесе расталмаған
run-up-contact = баяу өткенде діріл мына бөлшектердің саңылауын жабады: { $parts }
run-up-grows = орнықсыз аралықтарда ауытқу { $factor } есеге дейін өседі
run-up-diverges = қозғалыс шексіз өседі
axis-operating-range = жұмыстық айналу жиіліктері
check-shaft-vibration = Мойынтіректердегі білік дірілі
check-housing-vibration = Мойынтірек корпустарының дірілі
check-balance = Теңгеру сапасы
check-velocity = Тербеліс жылдамдығы
velocity-sizes = { $sizes } (шыңы)
velocity-is = ең үлкені { $value } (шың мәні)
validity-studies-inside = файлдағы зерттеулерде шектен тыс ештеңе табылмады

# What the page leaves out.
page-left-out = Бұл бет нені ескермейді
left-linear = Бейсызық бөлшектер ({ $parts }) тепе-теңдік маңында сызықтандырылған; үлкен тербелістер мен секірістер үшін «nonlinear_response» зерттеуі қажет.
left-linear-modes = Орнықтылық пен модалар бейсызық бөлшектерді ({ $parts }) тепе-теңдік маңында сызықтандырып есептелген.
left-spins = Машинаның айналуынан басқа айналулардың ({ $spins }) теңгерімсіздігіне жауап: spin өрісі бар "forced_response" есебі керек.
left-motions = { $tilt ->
        [bends] Осьтік және бұралу тербелістері.
        [yes] Осьтік және бұралу тербелістері, денелердің иілуі.
       *[no] Осьтік, бұралу және көлбеу тербелістері, денелердің иілуі.
    }
left-excitation = Дисбаланстан басқа қоздыру, мысалы біліктердің центрлес еместігі, тісті берілістер немесе тұрақсыз фундамент.
left-drive = Қозғалтқыш: айналу жиілігі берілген, сондықтан резонанстан өтуге қуаты жетпейтін қозғалтқыш байқалмайды.
left-steps = Ені { $step } мәнінен тар орнықсыз аралықтар.
left-steps-near = Ені { $step } мәнінен тар орнықсыз аралықтар, жұмыстық айналу жиілігінің маңында { $near } мәнінен тар.

# One table of evidence.
page-evidence-all = Сандық негіздеме
page-evidence-finding = тұжырым
page-evidence-value = мәні
page-evidence-checked = тексерілген шама
page-evidence-number = нәтижесі

balance-planes = { $rotor }: { $sizes }
item-balance = { $name } { $value }, шегі { $share }
balance-detail = ISO 21940-11:2016, { $planes ->
        [two] 6.2 және 7.2, мойынтіректер жазықтықтарында
       *[one] 6.2, тек бас вектор: роторда мойынтіректердің екі жазықтығы жоқ
    }. Бас вектор { $resultant }{ $tilts ->
        [yes] , бас момент { $couple }
       *[no] {""}
    }; қатты ротор ретінде теңгерілген
shaft-vibration-sizes = { $sizes }
item-shaft-vibration = { $name } { $value } құлаш{ $zone ->
        [none] {""}
       *[other] , { $zone } аймағы
    }
shaft-vibration-detail = { $standard ->
        [api_617] API 617
       *[iso_7919_3] ISO 7919-3:2009, A қосымшасы, B және C аймақтарының шекарасы
    }; шек { $speed } кезінде. Тек теңгерімсіздік, мойынтіректерге қатысты{ $nonlinear ->
        [yes] ; сызықты емес машинаның ең үлкен орнықты жауабы
       *[no] {""}
    }
item-housing-vibration = { $name } { $value } (орташа квадраттық){ $zone ->
        [none] {""}
       *[other] , { $zone } аймағы
    }
housing-vibration-detail = ISO 20816-3, { $standard ->
        [group_1_rigid] қатаң тіректегі 1-топ
        [group_1_flexible] икемді тіректегі 1-топ
        [group_2_rigid] қатаң тіректегі 2-топ
       *[group_2_flexible] икемді тіректегі 2-топ
    }, B және C аймақтарының шекарасы; шек { $speed } кезінде. Тек теңгерімсіздік, мойынтіректер тұрған денелер{ $nonlinear ->
        [yes] ; сызықты емес машинаның ең үлкен орнықты жауабы
       *[no] {""}
    }
housing-vibration-none = бірде-бір мойынтірек қозғалатын денеде тұрған жоқ
shaft-vibration-no-bearing = айналатын мен айналмайтын арасында тірек жоқ
shaft-vibration-unknown = мойынтіректерге қатысты жауап белгісіз
shaft-vibration-speed = стандарт бұл жұмыс айналу жиіліктерін қамтымайды
