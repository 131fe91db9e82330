# Balancing states over the speed.

stationary-hindered = «{ $part }» бөлшегі: { $reason }.
stationary-no-balls = Бұл машинада шарик жоқ. Оның күйлері – nonlinear_response зерттеуіндегідей синхронды тербеліс.
stationary-insufficient-capacity = Шариктер ең көбі { $value } теңгере алады, бұл дисбаланстан { $missing } кем. Ауырырақ немесе көбірек шарик қолданыңыз.

# Kinds of states.
stationary-kind = { $kind ->
        [balanced] теңгерілген
        [partly_balanced] ішінара теңгерілген
        [reduced] дисбалансы азайған
        [touching] шариктер жанасқан
        [together] шариктер беттескен
        [opposed] шариктер диаметр бойынша қарама-қарсы
        [spread] шариктер бөлек
       *[single] синхронды күй
    }
# States that balance, fully or partly.
stationary-state = { $kind ->
        [balanced] теңгерілген күй
        [partly_balanced] ішінара теңгерілген күй
       *[reduced] дисбалансы азайған күй
    }
stationary-continuum-of = { $kind ->
        [balanced] теңгерілген күйлер континуумы
        [partly_balanced] ішінара теңгерілген күйлер континуумы
       *[reduced] дисбалансы азайған күйлер континуумы
    }
stationary-sample = { $kind ->
        [balanced] теңгерілген күйлер континуумының бір күйі
        [partly_balanced] ішінара теңгерілген күйлер континуумының бір күйі
       *[reduced] дисбалансы азайған күйлер континуумының бір күйі
    }

# Ranges of speed.
stationary-stable = { $branch }-тармақ ({ $kind }) { $from } – { $value } аралығында орнықты.
stationary-stable-throughout = { $branch }-тармақ ({ $kind }) айналу жиілігінің бүкіл ауқымында, { $from } – { $value } аралығында орнықты.
stationary-continuum = { $from } – { $value } аралығында күйлер континуумы табылды: { $kind }, { $free } еркін бағыт. Оның орнықтылығы жеке күйлер бойынша бағаланады.
stationary-continuum-stable = { $from } – { $value } аралығында континуумның кейбір күйлері орнықты: { $kind }. Оның орнықтылығы жеке күйлер бойынша бағаланады.
stationary-no-state = Айналу жиілігінің ауқымында синхронды күй табылмады. starts мәнін арттырыңыз немесе transient есептеңіз.
stationary-no-stable-state = { $from } – { $value } аралығында орнықты синхронды күй табылмады. { $balls ->
        [yes] Шариктер сырғиды, машина прецессия жасайды немесе бір күй табылмай қалды;
       *[no] Машина прецессия жасайды немесе бір күй табылмай қалды;
    } онда transient есептеңіз.
stationary-not-balanced = { $from } – { $value } аралығында теңгерілген немесе ішінара теңгерілген күй табылмады. { $capacity ->
        [used] Онда шариктер тым жеңіл; ауырырақ шариктер қолданыңыз немесе тез өтіңіз.
       *[left] Бұл аралықтан тез өтіңіз.
    }
stationary-harm = { $from } – { $to } аралығында шариктер дисбалансты { $value } есеге дейін арттырады: { $branch }-тармақ, { $kind }. Онда шариктерді бекітіңіз немесе тез өтіңіз.
stationary-harm-of-balanced = { $from } – { $to } аралығында шариктер ең көбі { $value } дисбаланс тудырады: { $branch }-тармақ, { $kind }. Шариктерсіз ротор теңгерілген; оларды алып тастаңыз немесе бекітіңіз.
stationary-coexistence = { $speeds ->
        [one] { $from } кезінде
       *[other] Кестенің { $speeds } айналу жиілігінде ({ $from } – { $to } аралығында)
    } теңгерілген күй де, теңгерілмеген күй де орнықты. Қайсысы орнығатынын бастапқы шарт шешеді; basins есептеңіз.

# The best state at the operating speed.
stationary-residual-unbalance = { $speed } кезінде табылған ең жақсы орнықты күйдің ({ $kind }) қалдық дисбалансы { $value }{ $beside ->
        [times] , бұл шариктерсіз дисбаланстың { $times } есесі
        [nothing] , шариктерсіз дисбаланс мүлдем жоқ болса да
       *[none] {""}
    }.
stationary-dead-zone = { $speed } кезінде құрғақ үйкеліс салдарынан ең көбі { $value } дисбаланс қалады{ $effect ->
        [more] , бұл шариктерсіз мәннен көп
       *[less] {""}
    }. Ол шариктерді мына күйден { $angle } бұрышқа дейін ұстап қалады: { $state }.{ $held ->
        [unstable] {" "}Шариктер ұсталғанда машина орнықсыз; үйкелісті азайтыңыз.
       *[stable] {""}
    }
stationary-dead-zone-open = { $speed } кезінде { $value } құрғақ үйкеліс шариктерді табылған аралықтардан тыс та ұстап қалады. Есептелгеннен көп дисбаланс қалуы мүмкін; үйкелісті азайтыңыз.
stationary-dead-zone-continuum = { $speed } кезінде { $continuum } маңында құрғақ үйкеліс салдарынан { $value } немесе одан көп дисбаланс қалуы мүмкін.

# The balanced state over a parameter.
stationary-least-no-state = { $speed } кезінде { $parameter } параметрінің { $lowest } – { $highest } аралығындағы { $sought } мәнінде теңгерілген немесе ішінара теңгерілген күй табылмады. Ауқымды кеңейтіңіз немесе starts мәнін арттырыңыз.
stationary-least-unstable = { $speed } кезінде { $state } { $parameter } параметрінің { $lowest } – { $highest } аралығында есептелген { $computed ->
        [one] жалғыз мәнінде
       *[other] барлық { $computed } мәнінде
    } орнықсыз.{ $reach ->
        [none] {""}
       *[other] {" "}{ $reach }
    } Ауқымды кеңейтіңіз немесе басқа параметрді өзгертіңіз.
stationary-least-above = { $speed } кезінде { $parameter } параметрі { $value } мәнінен асқанда { $state } орнықты болады.{ $ends ->
        [none] {""}
        [open] {" "}Ол { $to } мәніне дейін орнықты.
        [exists] {" "}Ол { $to } мәніне дейін орнықты, онда күй аяқталады.
        [half] {" "}Ол { $to } мәніне дейін орнықты, онда дисбаланстың жартысы қалады.
       *[lost] {" "}Ол есептелген { $to } мәніне дейін орнықты.
    }{ $ranges }
stationary-least-from-limit = { $speed } кезінде { $parameter } параметрі { $value } мәнінен асқанда { $state } { $begins ->
        [exists] бар және орнықты.
        [half] орнықты, сол мәнде дисбаланстың жартысы қалады.
       *[lost] орнықты, одан төмен есептелмеген.
    }{ $ends ->
        [none] {""}
        [open] {" "}Ол { $to } мәніне дейін орнықты.
        [exists] {" "}Ол { $to } мәніне дейін орнықты, онда күй аяқталады.
        [half] {" "}Ол { $to } мәніне дейін орнықты, онда дисбаланстың жартысы қалады.
       *[lost] {" "}Ол есептелген { $to } мәніне дейін орнықты.
    }{ $ranges }
stationary-least-between = { $speed } кезінде { $state } { $parameter } параметрінің { $value } – { $to } аралығында орнықты, бұл – есептелген бөлігі.{ $ranges }
stationary-least-everywhere = { $speed } кезінде { $state } { $parameter } параметрінің { $lowest } – { $highest } аралығында есептелген { $computed ->
        [one] жалғыз мәнінде
       *[other] барлық { $computed } мәнінде
    } орнықты.
stationary-least-outside = { $speed } кезінде { $state } { $parameter } параметрі { $to } мәнінен асқанша орнықты{ $ends ->
        [exists] {" "}(онда күй аяқталады)
        [half] {" "}(онда дисбаланстың жартысы қалады)
        [lost] {" "}(есептелген мәнге дейін)
       *[open] {""}
    }, ал { $value } мәнінен асқанда қайтадан орнықты болады.{ $ranges }
stationary-least-below = { $speed } кезінде { $state } { $parameter } параметрі { $value } мәнінен асқанша орнықты{ $ends ->
        [exists] {" "}(онда күй аяқталады)
        [half] {" "}(онда дисбаланстың жартысы қалады)
        [lost] {" "}(есептелген мәнге дейін)
       *[open] {""}
    }.{ $ranges }
# Behind the sentence, where the state is stable more than once.
stationary-least-ranges = { $ranges ->
        [one] {""}
       *[other] {" "}Ол { $parameter } параметрінің { $ranges } аралығында орнықты.
    }
stationary-exists = Күй бар: { $ends }.
stationary-followed = Күй есептелген: { $ends }.
stationary-down-to = төмен қарай { $end } мәніне дейін{ $why ->
        [exists] {" "}(онда ол аяқталады)
        [half] {" "}(онда дисбаланстың жартысы қалады)
       *[other] {""}
    }
stationary-up-to = жоғары қарай { $end } мәніне дейін{ $why ->
        [exists] {" "}(онда ол аяқталады)
        [half] {" "}(онда дисбаланстың жартысы қалады)
       *[other] {""}
    }

# Errors of a parameter, and the chart.
stationary-cost = { $speed } кезінде табылған ең жақсы орнықты күйдің қалдық дисбалансы { $parameter } = { $from } болғанда { $first }, { $to } болғанда { $value }. Шариктерсіз ол { $without }.{ $effect ->
        [harm] {" "}Ол кезде шариктер дисбалансты арттырады; шақтаманы тарылтыңыз.
        [lost] {" "}Ол кезде ротор енді теңгерілмеген; шақтаманы тарылтыңыз.
       *[none] {""}
    }
stationary-cost-no-stable-state = { $speed } кезінде { $parameter } = { $value } болғанда{ $more ->
        [larger] {" "}және есептелген { $larger ->
            [one] одан үлкен мәнде
           *[other] одан үлкен { $larger } мәнде
        }
        [some] , барлығы { $computed } мәннің { $none } мәнінде
       *[none] {""}
    } орнықты күй табылмады. Шақтаманы тарылтыңыз немесе transient есептеңіз.
stationary-chart = Айналу жиілігі мен { $parameter } параметрінің картасындағы { $value } ұяшықтың { $balanced } ұяшығы теңгерілген, { $bistable } ұяшығы екі орнықты күйлі, { $unbalanced } ұяшығы теңгерілмеген. { $unstable } ұяшықта орнықты күй табылмады.

# How complete the search is.
stationary-completeness = Іздеудің толықтығы: жинақталған бастапқы шарттардың { $value } бөлігі белгілі күйге жетті. { $stopped ->
        [yes] Зерттеу тоқтағанға дейін табылған тармақ саны:
       *[no] Табылған тармақ саны:
    } { $branches }.
stationary-too-many-branches = Күйлер тармағы зерттеу жалғастыра алатыннан көп. Тізім толық емес; айналу жиілігінің ауқымын тарылтыңыз.
stationary-unfinished = Соңына дейін жалғастырылмады: { $branches }. Одан арғы күйлер табылмай қалуы мүмкін.
stationary-branch-near = { $branch }-тармақ, { $speed } маңында
stationary-more = тағы { $count }

# One speed.
stationary-states = { $speed } кезінде { $states ->
        [one] табылған жалғыз күй орнықты
       *[other] табылған { $states } күйдің { $stable ->
            [one] біреуі орнықты
           *[other] { $stable } күйі орнықты
        }
    }.
stationary-states-unstable = { $speed } кезінде { $states ->
        [one] табылған жалғыз күй орнықсыз
       *[other] табылған барлық { $states } күй орнықсыз
    }. Ондағы қозғалыс үшін transient есептеңіз.
stationary-states-none = { $speed } кезінде синхронды күй табылмады. starts мәнін арттырыңыз немесе transient есептеңіз.
