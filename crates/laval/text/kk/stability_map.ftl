# The largest growth rate.
stability-map-largest-growth = Машина орнықсыз: ең үлкен өсу жылдамдығы { $value }, { $speed } кезінде, { $motion ->
        [divergence] статикалық орнықсыздық (дивергенция)
       *[whirl] прецессия жиілігі { $frequency }
    }.
stability-map-largest-growth-of-map = Картадағы ең үлкен өсу жылдамдығы: { $value }, { $speed } және { $parameter } = { $setting } кезінде, { $motion ->
        [divergence] статикалық орнықсыздық (дивергенция)
       *[whirl] прецессия жиілігі { $frequency }
    }.
stability-map-stable = { $computed ->
        [stopped] Зерттеу тоқтағанға дейін есептелген
       *[all] Есептелген
    } бірде-бір нүктеде ешбір мода { $threshold ->
        [zero] өспейді
       *[set] { $limit } мәнінен тез өспейді
    }: ең үлкен өсу жылдамдығы { $value }.
stability-map-marginal = { $computed ->
        [stopped] Зерттеу тоқтағанға дейін есептелген
       *[all] Есептелген
    } бірде-бір нүктеде ешбір мода { $threshold ->
        [zero] өспейді
       *[set] { $limit } мәнінен тез өспейді
    }: ең үлкен өсу жылдамдығы нөлге тең.
stability-map-stable-counted = { $computed ->
        [stopped] Зерттеу тоқтағанға дейін есептелген
       *[all] Есептелген
    } бірде-бір нүктеде ешбір мода { $threshold ->
        [zero] өспейді
       *[set] { $limit } мәнінен тез өспейді
    }.
stability-map-stability-unknown = Орнықтылық дәлелденген жоқ:{ $threshold ->
        [zero] {""}
       *[set] {" "}{ $limit } мәнінен тез
    } өсетін мода табылмады, бірақ { $points } нүктенің { $open } нүктесінде кейбірі табылмай қалуы мүмкін. Төменірек frequency_limit немесе жоғарырақ growth_threshold іздеуді жеңілдетеді.

# Ranges of speed in which the machine is unstable.
stability-map-unstable-range = { $end ->
        [range] { $value } мәнінен ауқымның соңына дейін
        [stopped] { $value } – { $to } аралығында (зерттеу соңғы мәнде тоқтады)
       *[boundary] { $value } – { $to } аралығында
    } орнықсыз{ $threshold ->
        [zero] {""}
       *[set] : өсу жылдамдығы { $limit } мәнінен жоғары
    }.
stability-map-unstable-from-start = Ауқымның басынан, { $value } мәнінен, { $end ->
        [range] оның соңына, { $to } мәніне дейін
        [stopped] зерттеу тоқтаған { $to } мәніне дейін
       *[boundary] { $to } мәніне дейін
    } орнықсыз{ $threshold ->
        [zero] {""}
       *[set] : өсу жылдамдығы { $limit } мәнінен жоғары
    }.
stability-map-unstable-range-not-located = { $low } – { $high } аралығындағы бір айналу жиілігінен { $end ->
        [range] ауқымның соңына дейін
        [stopped] зерттеу тоқтаған { $to } мәніне дейін
       *[boundary] { $to } мәніне дейін
    } орнықсыз{ $threshold ->
        [zero] {""}
       *[set] : өсу жылдамдығы { $limit } мәнінен жоғары
    }. Шекараның дәл мәні анықталмады; ол жерде нүкте санын арттырыңыз.

# How far the growth rates are known.
stability-map-all-counted = Түбір саны { $points ->
        [one] жалғыз нүктеде
       *[other] барлық { $points } нүктеде
    } аргумент принципі бойынша { $frequency } жиілігіне дейін тексерілді: бірде-бір { $threshold ->
        [zero] өсетін түбір
       *[set] { $limit } мәнінен тез өсетін түбір
    } қалып қойған жоқ.
stability-map-not-all-counted = { $points } нүктенің { $open } нүктесінде { $threshold ->
        [zero] өсетін түбірлер
       *[set] { $limit } мәнінен тез өсетін түбірлер
    } табылмай қалуы мүмкін. Төменірек frequency_limit немесе жоғарырақ growth_threshold санауды жеңілдетеді.
stability-map-threshold-raised = { $part } ішіндегі толқындар үшін { $value } мәнінен төмен өсу дәл анықталмайды; басқа бөліктердегі кез келген демпферлеу оларды баяу өсіреді. Шектік мән { $requested } мәнінен арттырылды.
stability-map-undamped = { $machines ->
        [some] Картаның бір бөлігінде
       *[all] Машинада
    } демпферлеу жоқ: { $boundaries ->
        [none] ешбір мода өспейтін жерде ешбірі өшпейді де
        [double] орнықтылық шекаралары еселі түбір ретінде табылды
       *[some] { $edges } орнықтылық шекарасының { $double } шекарасы еселі түбір ретінде табылды, қалғандары аралықпен берілген
    }.
