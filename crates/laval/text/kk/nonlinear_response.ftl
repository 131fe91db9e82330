# Steady response to unbalance of a machine with nonlinear parts.

# Which branch; stands before the word "тармақ".
nonlinear-response-branch = { $origin ->
        [low] төмен айналу жиілігінен басталған
        [high] жоғары айналу жиілігінен басталған
        [broken] { $speed } кезінде басталған, симметриясы төмен
        [doubled] { $speed } кезінде басталған, периоды екі еселенген
        [crossing] { $speed } кезінде қиып өтетін
        [mixed] x пен y әртүрлі күйдегі
        [subharmonic] { $turns } айналым сайын қайталанатын
       *[start] басқалардан бөлек
    }
# Which part of a branch, with the word "тармақ".
nonlinear-response-stretch = { $place ->
        [before] { $branch } тармақтың { $to } кезіндегі бұрылу нүктесіне дейінгі бөлігі
        [beyond] { $branch } тармақтың { $from } кезіндегі бұрылу нүктесінен кейінгі бөлігі
        [between] { $branch } тармақтың { $from } және { $to } кезіндегі бұрылу нүктелері арасындағы бөлігі
       *[whole] { $branch } тармақ
    }
nonlinear-response-more-ranges = тағы { $n } аралықта

# Why a branch ended. Whole sentences.
nonlinear-response-end = { $why ->
        [work-limit] Есептеу көлемінің шегіне жетті.
        [range] Онда айналу жиілігінің ауқымы аяқталады.
        [points] Нүктелердің ең көп санына жетті; max_points мәнін арттырыңыз.
        [cancelled] Зерттеу сұрау бойынша тоқтатылды.
        [closed] Тармақ тұйықталады.
        [start] Бастапқы шарт жинақталмады.
        [undefined] Онда теңдеулер анықталмаған: { $cause }.
        [infinite] Онда күштің немесе оның туындысының ақырлы мәні жоқ; бөлшек өз ауқымынан тыс қолданылған.
        [singular] Онда теңдеулердің жалғыз шешімі жоқ: координата бекітілмеген немесе тармақтар қиылысады.
        [sharp] Онда тармақ тым шұғыл бұрылады; көбірек гармоника сақтаңыз немесе шұғыл күш заңын тегістеңіз.
        [strayed] Одан арғы ең жақын шешім басқа тармаққа жатады; оның маңында айналу жиілігінің ауқымын тарылтыңыз.
        [resonance] Онда дененің қозғалысы тым тез өзгереді, мысалы демпферленбеген резонанстағыдай; денелерге демпферлеу қосыңыз.
        [unbounded] Айналу жиілігі дерлік тұрақты болғанда амплитуда шексіз өседі, мысалы демпферленбеген резонанстағыдай; демпферлеу қосыңыз.
       *[unsolved] Одан әрі теңдеулер шешілмеді; көбірек гармоника сақтаңыз немесе шұғыл күш заңын тегістеңіз.
    }

# Run-up and run-down so slow that the response follows the branches.
nonlinear-response-jump = Квазистатикалық { $way ->
        [up] екпіндеу
       *[down] баяулау
    }: тербеліс { $value } кезінде{ $again ->
        [no] {""}
       *[yes] {" "}тағы
    } секіреді{ $onto ->
        [none] {""}
       *[other] , жаңа күйі { $onto } тармақта
    }.
nonlinear-response-jump-unstable-before = Бұл секіріске дейінгі тербеліс { $ranges } орнықсыз; онда машина одан ауытқып кетуі мүмкін.
nonlinear-response-jump-landing = { $stable ->
        [0] Секірістің дәл артында есептелген күйлердің ешқайсысы орнықты емес; ондағы қозғалысты `transient` көрсетеді.
       *[other] Секірістен кейін { $stable } күй орнықты; қайсысы орнығатынын `basins` көрсетеді.
    }
nonlinear-response-no-jump = Квазистатикалық { $way ->
        [up] екпіндеу
       *[down] баяулау
    }, { $from } – { $to } аралығында: секіріс жоқ{ $amplitude ->
        [rising] , бірақ ауқымның соңында амплитуда әлі өсіп тұр
       *[other] {""}
    }.
nonlinear-response-no-fold = Квазистатикалық { $way ->
        [up] екпіндеу
       *[down] баяулау
    }, { $from } – { $to } аралығында: бұрылу нүктесі жоқ, бірақ тербеліс { $ranges } орнықсыз.
nonlinear-response-sweep-unfinished = Квазистатикалық { $way ->
        [up] екпіндеу
       *[down] баяулау
    }: тармақ тек { $value } мәніне дейін жалғастырылды. Одан арғы секірістер белгісіз. { $why }
nonlinear-response-sweep-not-followed = Квазистатикалық { $way ->
        [up] екпіндеу
       *[down] баяулау
    }: тармақтар жалғастырылмады. { $why }
nonlinear-response-sweep-unstable = Квазистатикалық { $way ->
        [up] екпіндеу
       *[down] баяулау
    }: { $value } кезіндегі бұрылу нүктесі секіріс тудырмайды, өйткені оған дейінгі тербеліс { $ranges } орнықсыз. Ондағы қозғалысты `transient` көрсетеді.
nonlinear-response-sweep-unknown = Квазистатикалық { $way ->
        [up] екпіндеу
       *[down] баяулау
    }: бірінші айналу жиілігінде, { $value }, периодты шешім табылмады. Басқа айналу жиілігінен бастаңыз немесе states = "all" қойыңыз.
nonlinear-response-start-not-followed = Ауқымның шетіндегі ({ $value }) шешім ауқымның сыртынан жалғастырылмады. Осы айналу жиілігіне жеткізілген машинаның тербелісі өзгеше болуы мүмкін; ауқымды кеңейтіңіз.
nonlinear-response-two-branches = Екі бөлек тармақ табылды: бірі төмен айналу жиілігінен, бірі жоғары айналу жиілігінен басталады. Қайсысы орнығатыны айналу жиілігінің бұрынғы өзгерісіне байланысты.
nonlinear-response-branch-unfinished = Толық емес: { $branch } тармақ { $folds ->
        [one] бұрылу нүктесінен
       *[other] бұрылу нүктелерінен
    } кейін тек { $value } мәніне дейін есептелді. { $why }

# The upper branch goes on beyond the range.
nonlinear-response-not-closed = Жоғарғы тармақ ауқымның шетіне ({ $speed }) бұрылу нүктесінсіз жетеді: амплитуда { $value }, төменгі тармақта { $lower }. Ауқымның шеті секіріс емес.
nonlinear-response-beyond = { $beyond ->
        [closes] Ауқымнан әрі жалғастырғанда тармақ { $at } кезінде кері бұрылады; тербеліс онда секіреді.
        [stays] Демпферлеу дисбаланстың қолда бар қуатының онда { $share }, жоғары айналу жиілігінде { $limit } бөлігін шашыратады. Бұрылу нүктесі 100 % болғанда пайда болады, сондықтан бұл тармақта ол жоқ.
        [rises] Демпферлеу дисбаланстың қолда бар қуатының онда { $share }, жоғарырақ айналу жиілігінде одан да көп бөлігін шашыратады. Бұрылу нүктесі 100 % болғанда, осы айналу жиілігінің { $reach } есесінен әрі пайда болады.
        [lost] Демпферлеу онда дисбаланстың қолда бар қуатының { $share } бөлігін шашыратады; бұрылу нүктесі 100 % болғанда пайда болады. Тармақ тек { $at } мәніне дейін жалғастырылды.
       *[unknown] Демпферлеу онда дисбаланстың қолда бар қуатының { $share } бөлігін шашыратады; бұрылу нүктесі 100 % болғанда пайда болады.
    }

# The search for further states.
nonlinear-response-further-states = Басқа күйлер, { $kind }: { $value } – { $to } аралығында { $branches } тармақ, { $stability ->
        [some] { $low } – { $high } аралығында ішінара орнықты
        [none] барлық жерде орнықсыз
       *[unknown] орнықтылығы белгісіз
    }.
nonlinear-response-copies = { $kind ->
        [turned] Әр тармақ ең көбі { $copies } симметриялы көшірмені білдіреді.
       *[later] Әр тармақ ең көбі { $copies } көшірмені білдіреді: машина симметриясы бойынша бұрылған немесе ротордың бір айналымына кешіккен.
    }
nonlinear-response-no-further-states = { $starts ->
        [0] Аралас және субгармоникалық бастапқы шарттардан
       *[other] Аралас, субгармоникалық және кездейсоқ бастапқы шарттардан
    } бастағанда басқа күйлер табылмады. Іздеу толық емес.
nonlinear-response-families-left-out = Күйлердің барлық тобы жалғастырылған жоқ. Қалғандарын көру үшін айналу жиілігінің ауқымын тарылтыңыз.
nonlinear-response-search-not-begun = Басқа күйлерді іздеу басталмады, өйткені негізгі тармақтар толық емес. Басқа күйлер болуы мүмкін.
nonlinear-response-search-stopped = Басқа күйлерді іздеу аяқталмады: { $all-speeds } айналу жиілігінің { $speeds } мәні және { $all-starts } кездейсоқ бастапқы шарттың { $starts } шарты тексерілді. Басқа күйлер табылмай қалуы мүмкін.
nonlinear-response-search-in-time = { $all-starts } бастапқы шарттың { $starts } шарты уақыт бойынша интегралданды.

# Largest values.
nonlinear-response-largest = Ең үлкен орныққан ығысу { $value }: { $body }, { $place ->
        [end] ауқымның шетінде, { $speed }
       *[inside] { $speed } кезінде
    }.
nonlinear-response-largest-at-left-end = Оның тармағы тек осы жерге дейін жалғастырылды; одан әрі үлкенірек ығысулар болуы мүмкін.
nonlinear-response-largest-left = Оның тармағы тек { $left } мәніне дейін жалғастырылды; одан әрі үлкенірек ығысулар болуы мүмкін.
nonlinear-response-largest-of = { $body }: ең үлкен орныққан ығысуы { $value }, { $speed } кезінде.
nonlinear-response-largest-tilt = «{ $body }» денесінің ең үлкен орныққан көлбеу бұрышы { $value }, { $speed } кезінде.
nonlinear-response-not-reached = { $body }: ең үлкен орныққан { $quality ->
        [tilt] көлбеу бұрышы
       *[displacement] ығысуы
    } табылмады; { $branch } тармақтың жалғасы үзілген { $speed } кезінде мәні { $value } және өсіп тұр.
nonlinear-response-unbounded = { $body }: орныққан { $quality ->
        [tilt] көлбеу бұрышы
       *[displacement] ығысуы
    } шексіз; { $branch } тармақтың жалғасы үзілген { $speed } кезінде мәні { $value } және өсіп тұр. Демпферлеу қосыңыз.
nonlinear-response-largest-force = «{ $part }» бөлшегінің ең үлкен орныққан күші { $value }, { $speed } кезінде.
nonlinear-response-largest-force-left = Тербеліс соңына дейін жалғастырылмады; үлкенірек күштер болуы мүмкін.
nonlinear-response-antiresonance = Антирезонанс: «{ $part }» бөлшегінің күші { $value } кезінде { $force } мәніне дейін төмендейді, бұл көрші максимумдардың кішісінің { $share } бөлігі.
nonlinear-response-tuning = Баптау: «{ $body }» денесінің қатаңдығы { $value } болса (қазір { $stiffness }), «{ $part }» бөлшегінің күші { $speed } кезінде төменгі тармақта { $before } мәнінен { $after } мәніне дейін азаяды.
nonlinear-response-tuned = { $stability ->
        [stable] Бапталған тербеліс орнықты.
        [unstable] Бапталған тербеліс орнықсыз, өсу жылдамдығы { $growth }; демпферлеу қоспай фундаментті баптамаңыз.
       *[unknown] Бапталған тербелістің орнықтылығы бағаланбады.
    }
nonlinear-response-self-centring = Өздігінен центрлену: жоғары айналу жиілігінде «{ $body }» денесінің амплитудасы { $value } мәніне ұмтылады. { $speed } кезінде ол { $amplitude }, амплитуда мен фаза бойынша айырмасы { $difference }.
nonlinear-response-centred = Айырма { $from } мәнінен бастап { $close } мәнінен төмен.
nonlinear-response-centred-beyond = Экстраполяция бойынша айырма { $from } кезінде { $close } мәнінен төмендейді.
nonlinear-response-centring-unstable = { $speed } кезіндегі тербеліс орнықсыз.
nonlinear-response-force-limit = Жоғары айналу жиілігінде төменгі тармақта «{ $part }» бөлшегінің күші { $value } мәніне ұмтылады.

# Stability.
nonlinear-response-unstable = Орнықсыз: { $stretch }, { $ranges }. Ең үлкен өсу жылдамдығы { $value }, { $speed } кезінде. Бұл айналу жиіліктерінен аулақ болыңыз немесе демпферлеу қосыңыз.
nonlinear-response-stability = Айналу жиілігі артқанда { $stretch } { $place ->
        [located] { $value } кезінде
       *[bracketed] { $value } маңында ({ $from } – { $to } аралығында)
    } { $way ->
        [lost] орнықсыз
       *[gained] орнықты
    } болады: { $event }.
nonlinear-response-event = { $kind ->
        [neimark-sacker] Неймарк – Сакер бифуркациясы, { $way ->
            [lost] одан жоғары { $frequency } жиілікті тербеліс өседі
           *[gained] одан жоғары { $frequency } жиілікті тербеліс өшеді
        }
        [torus] Неймарк – Сакер бифуркациясы, { $way ->
            [lost] одан жоғары екінші жиіліктегі тербеліс өседі
           *[gained] одан жоғары екінші жиіліктегі тербеліс өшеді
        }
        [period-doubling] периодтың екі еселенуі, көршілес периодтар әртүрлі
        [symmetry-breaking] симметрияның бұзылуы, симметриясы төмен күйлер тармақталады
       *[branch-point] тармақталу нүктесі, басқа тармақ қиып өтеді
    }
nonlinear-response-more-bifurcations = Тағы { $more } бифуркация кестеде көрсетілген.
nonlinear-response-stability-checked = { $states } күйдің орнықтылығы симметрияны қолданбайтын екі әдіспен тексерілді; өсу жылдамдықтарының айырмасы ең көбі { $value }.
nonlinear-response-stability-contradicted = Тағы екі әдіс { $checks } салыстырудың { $contradictions } жағдайында орнықтылыққа қайшы келеді; өсу жылдамдықтарының айырмасы { $value } мәніне жетеді. Орнықтылықты дәлелденбеген деп есептеңіз.
nonlinear-response-stability-not-checked = Орнықтылық екінші әдіспен тексерілмеді: { $why }.
nonlinear-response-nothing-checked = Орнықтылық екінші әдіспен тексерілмеді: бірде-бір күй қайта бағаланған жоқ.
nonlinear-response-stability-not-requested = Орнықтылық сұралмаған, күйлер орнықсыз болуы мүмкін. stability = true қойыңыз.
nonlinear-response-stability-reduced = Орнықтылықты бағалау үшін сызықты бөліктер { $coordinates } координатаға келтірілді. { $frequency } жиілікке дейін олардың сызықты емес бөліктердегі икемділігі бүтін машинаның икемділігінен { $value } шамаға өзгеше.
nonlinear-response-stability-unknown = Күйлердің орнықтылығы бағаланбады: { $why }. Олар орнықсыз болуы мүмкін.
nonlinear-response-stability-partly-unknown = { $all } күйдің { $unknown } күйінің орнықтылығы бағаланбады: { $why }. Олар орнықсыз болуы мүмкін.
# Why stability was not assessed.
nonlinear-response-unassessed = { $why ->
        [no-time-form] «{ $part }» бөлшегінің уақыт облысындағы формасы жоқ: { $cause }
        [states] машинада { $states } бірінші ретті күй бар, монодромия матрицасына бұл тым көп
        [massless] бір координатаның массасы жоқ
        [jumps] жанасу кезінде «{ $part }» бөлшегінің күші секіреді, ондай секірістің ауытқуға әсері есептелмейді
       *[failed] { $cause }
    }
nonlinear-response-stability-fit = Орнықтылық «{ $part }» бөлшегінің уақыттағы жуық формасымен бағаланды; күйлердің өзі дәл.
nonlinear-response-determinant = { $states } күйдің орнықтылығы дәл импеданстармен Хилл анықтауышы бойынша бағаланды. Өсу жылдамдығы { $value } мәнінен жоғары көрсеткіштер саналды; өшетіндерінің тек кейбірі белгілі.
nonlinear-response-balls-elsewhere = Есептелген күйлердің ешқайсысы орнықты емес. Шариктердің басқа да күйлері бар; `stationary`, `transient` немесе `basins` қолданыңыз.

# Validity.
nonlinear-response-harmonics = Сақталған гармоникалар ең нашар нүктеде бейсызық күштің { $value } бөлігін қамтымайды. Қозғалыстың шұғыл өзгерістері дәл көрсетілмейді; сынық нүктелері бар күш заңдарын тегістеңіз.
nonlinear-response-no-number = «{ $part }» бөлшегі кейбір күйлерде ақырлы күш бермейді. Ондағы тербеліс жарамсыз.

# Orders beside the synchronous one.
nonlinear-response-no-orders = Ешбір дененің суб- немесе ультрагармоникалық амплитудасы { $limit } мәнінен аспайды.
nonlinear-response-order-range = «{ $body }» денесінің { $kind ->
        [superharmonic] ультрагармоникасы
        [subharmonic] субгармоникасы
       *[component] құраушысы
    }, реті { $divisor ->
        [1] { $order }
       *[other] { $order }/{ $divisor }
    }, { $value } – { $to } аралығында { $limit } мәнінен асады: { $extent ->
        [all] { $branch } тармақтың бойында түгел
        [inside] { $branch } тармақта
        [begins] { $branch } тармақта, ол { $value } кезінде басталады
       *[ends] { $branch } тармақта, ол { $to } кезінде аяқталады
    }. Ең үлкен мәні { $largest }, { $speed } кезінде, { $sense ->
        [forward] тура прецессия
        [backward] кері прецессия
       *[line] түзу бойымен
    }.
nonlinear-response-more-orders = Құраушылары { $limit } мәнінен асатын тағы { $more } аралық ерекше нүктелер тізімінде көрсетілген.

# One speed.
nonlinear-response-no-motion = { $speed } кезінде периодты шешім табылмады. Ондағы қозғалысты `transient` көрсетеді.
nonlinear-response-no-motion-stopped = Зерттеу тоқтағанға дейін { $speed } кезінде периодты шешім табылмады.
nonlinear-response-all-unstable = { $speed } кезінде табылған { $count ->
        [one] жалғыз периодты шешім
       *[other] барлық { $count } периодты шешім
    } орнықсыз. Ондағы қозғалысты `transient` көрсетеді.
nonlinear-response-steady = { $body }: { $speed } кезінде ең үлкен { $quality ->
        [tilt] көлбеу бұрышы
       *[displacement] ығысуы
    } { $value }{ $count ->
        [1] {""}
       *[other] , { $count } шешімнің { $number }-шешімінде
    }. { $stability ->
        [stable] Тербеліс орнықты.
        [unstable] Тербеліс орнықсыз.
       *[unknown] Тербелістің орнықтылығы белгісіз.
    }
nonlinear-response-period = Ол { $turns } айналымнан кейін қайталанады.
nonlinear-response-no-excitation = Машинада қоздыру жоқ.
