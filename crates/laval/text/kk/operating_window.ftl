# Requirements, as they stand in sentences.
operating-window-requirement = { $name ->
        [separation] сепарация уақыты
        [residence] болу уақыты
        [vibration] тербеліс
        [self_centred] ротордың өздігінен центрленуі
        [stable] орнықтылық
        [clear] меншікті жиіліктерден алшақтық
        [passage] резонанстардан өту
        [strength] ең жоғары айналу жиілігі
        [valid] бөлшектердің жарамдылығы
       *[range] есептелген ауқым
    }
operating-window-at-jump = { $requirement } (секірісте)
operating-window-span = { $from } – { $to }

# What binds in a requirement.
operating-window-limited = «{ $of }» { $quantity ->
        [displacement] ығысуы
        [velocity] тербеліс жылдамдығы
        [tilt] көлбеу бұрышы
        [force] күші
       *[moment] моменті
    }
operating-window-centre-of-mass = «{ $body }» денесінің масса центрінен оське дейінгі қашықтық
operating-window-growth-rate = { $contents ->
        [before] сепарацияға дейінгі өсу жылдамдығы
        [after] сепарациядан кейінгі өсу жылдамдығы
       *[always] өсу жылдамдығы
    }
operating-window-mode = жиілігі { $frequency } моданың айналу жиілігінің { $order } есесінен алшақтығы
operating-window-swing = стакан тербелісінің айналу жиілігінің { $order } есесінен алшақтығы
operating-window-moved = «{ $of }» ығысуы, { $speed } кезінде
operating-window-torque = жетек моменті
operating-window-model = «{ $part }» бөлшегінің жарамдылығы ({ $statement })
operating-window-path = суспензия бөлшегінің жолын есептеу мүмкін емес ({ $why })
operating-window-without-bound = демпферленбеген резонанста амплитуда шексіз
operating-window-no-state = орнықты орныққан күй жоқ

# Windows and their ends.
operating-window-window = Машина { $from } – { $value } аралығында жұмыс істей алады. Төменгі шекті { $below } белгілейді, жоғарғы шекті { $above } белгілейді.
operating-window-widest-window = Ең кең жұмыс аралығының ені { $value }: { $from } – { $to }.
operating-window-edge = Жұмыс аралығының { $side ->
        [begins] басы
       *[ends] соңы
    } { $value }: { $reason }.
operating-window-reason = { $what } шегіне жетеді
operating-window-reason-limit = { $what } шегіне ({ $limit }) жетеді
operating-window-reason-undefined = одан әрі { $what }
operating-window-reason-jump = одан әрі { $what } шегінің { $factor } есесіне секіреді{ $states ->
        [0] {""}
        [1] {""}
       *[other] , бұл { $states } орнықты күйдің бірінде болады, олардың кез келгеніне баяу екпіндеу немесе баяулау жеткізуі мүмкін
    }{ $fold ->
        [yes] , бұрылу нүктесінде
       *[no] {""}
    }
operating-window-reason-jump-undefined = одан әрі { $what } шегінен секіріп асады{ $states ->
        [0] {""}
        [1] {""}
       *[other] , бұл { $states } орнықты күйдің бірінде болады, олардың кез келгеніне баяу екпіндеу немесе баяулау жеткізуі мүмкін
    }{ $fold ->
        [yes] , бұрылу нүктесінде
       *[no] {""}
    }
operating-window-robust-window = Ауытқуға төзімді жұмыс аралығы: { $from } – { $value }, айналу жиілігінің { $tolerance } ауытқуы{ $corners ->
        [0] {""}
       *[other] {" "}және белгісіз параметрлердің барлық { $corners } шеткі жиыны
    } ескерілген.
operating-window-no-robust-window = Айналу жиілігінің { $tolerance } ауытқуында{ $corners ->
        [0] {""}
       *[other] {" "}және белгісіз параметрлердің барлық { $corners } шеткі жиынында
    } ешбір айналу жиілігі барлық талапты орындамайды. Ауытқуларды азайтыңыз немесе бір шекті босатыңыз.
operating-window-incomplete = Зерттеу ерте тоқтатылды. Есептелмегені: { $parts }.
operating-window-missing = { $part ->
        [refinement] есептелген айналу жиіліктерінің арасындағы тар үзілістерді іздеу
        [robust] ауытқуға төзімді жұмыс аралығы
       *[map] карта
    }

# No window.
operating-window-no-window = Ауқымда есептелген ешбір айналу жиілігі барлық талапты орындамайды.
operating-window-unstable = Машина есептелген барлық айналу жиілігінде орнықсыз: өсу жылдамдығы кемінде { $value }. Басқа шектерден бұрын орнықсыздықты жойыңыз.
operating-window-growth-margin = Есептелген ешбір айналу жиілігі growth_margin талабын ({ $required }) орындамайды: ең төмен өсу жылдамдығы { $value }{ $damping ->
        [none] , кемінде бір мода мүлдем демпферленбеген
       *[some] {""}
    }. Демпферлеу қосыңыз немесе growth_margin мәнін азайтыңыз.
operating-window-excluding = Есептелген ешбір айналу жиілігі мына екі талапты қатар орындамайды: { $first } және { $second }.
operating-window-lower-throughput = Өнімділікті қазіргі мәнінің { $share } деңгейіне түсіру { $speed } кезінде жұмыс аралығын ашар еді.
operating-window-relaxation = { $requirement ->
        [separation] Берілген уақытты
        [vibration] Шектеп тұрған тербеліс шегін
        [self_centred] Өздігінен центрлену шегін
        [passage] Шектеп тұрған резонанстан өту шегін
       *[strength] Ең жоғары айналу жиілігін
    } қазіргі мәнінің { $factor } есесіне арттыру { $speed } кезінде жұмыс аралығын ашар еді.
operating-window-no-relaxation = Бір ғана шекті босату жұмыс аралығын ашпайды: есептелген әр айналу жиілігінде екі немесе одан көп талап бұзылған немесе біреуінің қоры жоқ.

# The recommended speed.
operating-window-best-speed = Ұсынылатын айналу жиілігі: { $value }. { $why ->
        [margin] Онда ең кіші қор ең үлкен
        [next_margin] Ең кіші қор ({ $least }) { $from } – { $to } аралығында бірдей; келесісі ({ $next }) шешеді
        [throughput] Онда өнімділік ең үлкен болуы мүмкін
        [time] Онда сепарация ең қысқа
        [energy] Онда энергия ең аз
       *[amplitude] Онда тербеліс ең кіші
    }.{ $duty ->
        [throughput] {" "}Өнімділік ең көбі { $throughput } болуы мүмкін.
        [time] {" "}Сепарация уақыты { $time }.
       *[none] {""}
    }
operating-window-binding = Ұсынылатын айналу жиілігіндегі ең кіші қор { $value }: { $requirement }.
operating-window-binding-detail = Ұсынылатын айналу жиілігіндегі ең кіші қор { $value }: { $requirement }, { $detail }.
operating-window-not-faster = Ұсынылатын айналу жиілігінен жоғары жұмыс аралығы { $value } кезінде аяқталады, шекті { $requirement } белгілейді.
operating-window-field = Ұсынылатын айналу жиілігінде центрден тепкіш өріс сұйықтық бетінде { $inner } g, сыртқы радиуста { $value } g.
operating-window-outside-robust = Ұсынылатын айналу жиілігі { $value } ауытқуға төзімді жұмыс аралығынан ({ $ranges }) тыс. Осы аралықтан айналу жиілігін таңдаңыз.
operating-window-shortest-time = Қалған барлық талап орындалғандағы ең қысқа сепарация уақыты { $value }, { $speed } кезінде.
operating-window-shortest-residence = Қалған барлық талап орындалғандағы ең қысқа болу уақыты { $value }, { $speed } кезінде: өнімділігі { $throughput }.

# Remarks.
operating-window-tilt-without-limit = «{ $body }» денесінің көлбеу бұрышына шек қойылмаған, ол { $value } мәніне жетеді, { $speed } кезінде. Дененің ығысуы тек тірек нүктесінде тексеріледі: [limits] бөліміне tilt қосыңыз.
operating-window-not-checked = Тексерілмеді (шек берілмеген): { $requirements }.
operating-window-few-requirements = Бұл аралықты тек орнықтылық шектейді: ол әлі жұмыс аралығы емес. [limits] немесе [suspension] бар [[cup]] қосыңыз.
operating-window-nonlinear = { $policy ->
        [reached] Бірнеше орнықты тармақтың ішінен осы файлдағы екпіндеу жететіні тексеріледі. Жұмыс аралығы тек осы екпіндеуге жарамды
        [highest] Бірнеше орнықты тармақтың ішінен тербелісі ең үлкені тексеріледі
       *[all] Бейсызық тербелістің барлық орнықты тармағы тексеріледі: олардың бірі шектен асса, айналу жиілігі алынып тасталады
    }.
operating-window-passage-peak = { $way ->
        [up] { $top } мәніне дейін екпіндеу
       *[down] { $top } мәнінен баяулау
    }: «{ $body }» денесінің ығысуы { $value } мәніне жетеді, { $speed } кезінде.
operating-window-passage-torque = Екпіндеуге ең көбі { $value } жетек моменті қажет.
operating-window-braking = Екпіндеудей жылдам тежеу тұнбаға бүйірінен центрден тепкіш өрістің { $value } бөлігіндей жүк түсіреді.
operating-window-gravity = Жұмыс аралығының төменгі шетінде ({ $speed }) ең ішкі сұйықтықтағы өріс { $value } g. Модель ауырлық күшін ескермейді, бұл { $least } g мәнінен жоғары жарамды: ондағы сепарация – бағалау ғана.
operating-window-run-up-estimate = Екпіндеу толық айналу жиілігіндегі { $value } уақытқа тең деп алынды, ол орташа радиустағы өріс бойынша бағаланды: бекітілген бұрышты пробиркалардағы сұйықтық екпіндеу кезінде ығысады.
