# At one speed.
forced-response-amplitude = { $body }: { $speed } кезінде амплитудасы { $value }.
forced-response-tilt = «{ $body }» денесінің көлбеу бұрышы { $speed } кезінде { $value }.

# Resonances.
forced-response-largest-resonance = Ең үлкен { $others ->
        [unbounded] шектеулі резонанс
       *[none] резонанс
    } { $value } кезінде: { $body }, амплитудасы { $amplitude }.{ $search ->
        [stopped] {" "}Бұл – зерттеу тоқтағанға дейін табылғандардың ең үлкені.
       *[complete] {""}
    }
forced-response-largest-tilt-resonance = Көлбеу бұрышының ең үлкен { $others ->
        [unbounded] шектеулі резонансы
       *[none] резонансы
    } { $value } кезінде: { $body }, амплитудасы { $amplitude }.{ $search ->
        [stopped] {" "}Бұл – зерттеу тоқтағанға дейін табылғандардың ең үлкені.
       *[complete] {""}
    }
forced-response-undamped-resonance = Демпферленбеген резонанс, { $value } кезінде: { $body }, амплитудасы шексіз. Демпферлеу қосыңыз немесе бұл айналу жиілігінен аулақ болыңыз.
forced-response-other-undamped-resonance = Демпферленбеген резонанс, { $value } кезінде: амплитудасы шексіз. Демпферлеу қосыңыз немесе бұл айналу жиілігінен аулақ болыңыз.
forced-response-no-resonance = Бұл ауқымда ешбір дененің резонансы жоқ.
forced-response-no-resonance-known = Тербелісі белгілі айналу жиіліктерінде резонанс табылмады.
forced-response-no-resonance-yet = Зерттеу тоқтағанға дейін резонанс табылмады.

# How far the response is known and valid.
forced-response-frequency-only = Айналу жиілігінің { $step } қадамынан тар резонанстар табылмай қалуы мүмкін, орнықтылық бағаланған жоқ: бір бөлшек тек жиіліктік облыста берілген.
forced-response-unknown = Тербеліс { $speeds } айналу жиілігінің { $unknown } мәнінде белгісіз, алғашқысы { $value }: онда бір бөлшектің реакциясы дәл есептелмейді.
forced-response-gap-closes = Тербеліс { $speeds ->
        [one] { $value } кезінде
       *[several] { $value } – { $last } аралығында
    } «{ $part }» бөлшегінің тепе-теңдіктегі { $gap } саңылауын жабады. Жанасу ескерілмеген, сондықтан ондағы амплитудалар жарамсыз: nonlinear_response қолданыңыз.
forced-response-validity = Жарамсыз: тербеліс { $speed } кезінде «{ $part }» бөлшегінің жарамдылық шегінен тыс, { $what } = { $value } (шегі 1).
forced-response-validity-unbounded = Жарамсыз: тербеліс { $speed } кезінде «{ $part }» бөлшегінің жарамдылық шегінен тыс, { $what } шексіз (шегі 1).

# Separation margins.
forced-response-margin-kept = Жиілік қорлары сақталған (API 684, SP6.8.2.10). Ең азы { $resonance } резонансында: { $operating } жиілігінен { $value }, { $required } талап етіледі ({ $body }, { $damped ->
        [yes] күшейту коэффициенті { $factor }
        [unknown] күшейту коэффициенті белгісіз
       *[no] демпферлеусіз
    }).
forced-response-margin-broken = Жиілік қоры аз (API 684, SP6.8.2.10): { $resonance } резонансы { $side ->
        [among] жұмыс жиіліктерінің арасында
       *[other] { $operating } жиілігінен { $value } қашықтықта
    }, { $required } талап етіледі ({ $body }, { $damped ->
        [yes] күшейту коэффициенті { $factor }
       *[no] демпферлеусіз
    }).
forced-response-margin-none = Бұл диапазонда ешбір резонанс жиілік қорын талап етпейді (API 684, SP6.8.2.10): күшейту коэффициенті 2,5-тен кем емес резонанс жоқ.{ $bounded ->
        [yes] {" "}Диапазонның шетіне дейін жауап шыңның 0,707-сінен жоғары қалады: күшейту коэффициенті { $most } мәнінен аспайды.
       *[no] {""}
    }
forced-response-margin-unknown = { $reason ->
        [stopped] Жиілік қорлары анықталмады (API 684, SP6.8.2.10): есептеу тоқтатылды.
        [range] Жиілік қорлары анықталмады (API 684, SP6.8.2.10): { $resonance } резонансының жартылай қуат нүктелері диапазоннан тыс, сондықтан оның күшейту коэффициенті белгісіз. Жұмыс жиіліктеріне дейін { $value }; { $required } дейін талап етілуі мүмкін. Диапазонды кеңейтіңіз.
       *[neighbour] Жиілік қорлары анықталмады (API 684, SP6.8.2.10): көрші биік резонанс { $resonance } резонансының жартылай қуат нүктелерін жауып тұр, сондықтан оның күшейту коэффициенті белгісіз. Жұмыс жиіліктеріне дейін { $value }; { $required } дейін талап етілуі мүмкін.
    }
forced-response-spin = Мұнда "{ $spin }" айналуымен айналатын бөлшектердің теңгерімсіздігі әсер етеді; айналу жиіліктері осы айналуға қатысты.
forced-response-other-spins = { $spins } айналуымен айналатын бөлшектердің теңгерімсіздігі басқа жиілікте әсер етеді және мұнда ескерілмеген: spin өрісін жеке есепте беріңіз.

forced-response-shaft-vibration = { $part }: { $speed } кезінде діріл құлашы { $value }: { $standard ->
        [api_617] { $limit } шегінде (API 617)
       *[iso_7919_3] ISO 7919-3 бойынша { $zone } аймағы; шектеусіз ұзақ жұмыс { $limit } дейін
    }.
forced-response-shaft-vibration-broken = { $part }: { $speed } кезінде діріл құлашы { $value }, бұл { $limit } шегінен жоғары ({ $standard ->
        [api_617] API 617
       *[iso_7919_3] ISO 7919-3, { $zone } аймағы
    }). Роторды дәлірек теңгеріңіз, демпферлеу қосыңыз немесе резонансты жылжытыңыз.
forced-response-shaft-vibration-outside = Білік дірілінің стандарты { $speed } жиілігін қамтымайды.
forced-response-boundary = { $line ->
        [zone_ab] A/B аймақтары
        [zone_bc] B/C аймақтары
        [zone_cd] C/D аймақтары
       *[api_limit] API 617
    }
