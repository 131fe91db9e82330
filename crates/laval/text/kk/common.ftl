# Phrases that several studies share.

list-and = { $rest } және { $last }
list-or = { $rest } немесе { $last }
# A body, a point of a body, the tilt of a body.
body = «{ $body }» денесі
point = «{ $body }» денесінің { $height } биіктіктегі нүктесі
tilt-of = «{ $body }» денесінің көлбеу бұрышы
# A range of speeds.
range = { $from } – { $to } аралығында
at = { $at } кезінде

# A coefficient table that a study leaves.
beyond-table = «{ $part }» бөлшегінің кестесі { $from } – { $to } аралығын қамтиды. { $sides ->
        [both] Одан тыс, төмен қарай { $lowest } мәніне, жоғары қарай { $highest } мәніне дейін,
        [below] Одан төмен, { $lowest } мәніне дейін,
       *[above] Одан жоғары, { $highest } мәніне дейін,
    } коэффициенттері { $rule ->
        [hold] шеткі мәндерінде тұрақты қалады
        [linear] шеткі көлбеулігімен сызықты жалғастырылады
       *[refuse] белгісіз
    }.
beyond-table-note = «{ $part }» бөлшегінің кестесінен тыс.

# Nothing excites the machine.
unforced = Машинада қоздыру жоқ: ең үлкен ығысу { $value }, резонанс көрсетілмейді. Дискіге эксцентриситет, дисбаланс немесе қиғаштық беріңіз.

# Linear studies: what they are linearised about.
support-linearised = { $n ->
        [one] Бейсызық бөлшек
       *[other] Бейсызық бөлшектер
    } ({ $parts }) { $state ->
        [undeflected] деформацияланбаған күй
       *[deflected] жүктеме астындағы тепе-теңдік
    } маңында сызықтандырылған. Нәтижелер кіші тербеліске ғана жарамды.
support-fitted-part = Бастапқы меншікті мәндер «{ $part }» бөлшегінің рационал жуықтауынан алынды; олар оның дәл импедансымен нақтыланды.
support-open-gap = «{ $part }» бөлшегінің саңылауы тепе-теңдікте ашық және қатаңдық қоспайды. Жанасу салыстырмалы ығысу { $value } мәнінен асқанда басталады.
support-outside = «{ $part }» бөлшегі { $speed } кезінде тербеліссіз де жарамдылық шегінен тыс: { $what } = { $value } (шегі 1).
support-outside-unbounded = «{ $part }» бөлшегі { $speed } кезінде тербеліссіз де жарамдылық шегінен тыс: { $what } шексіз (шегі 1).

# Motions outside the validity of a part.
validity-states = Жарамсыз: кейбір күйлер { $place } «{ $part }» бөлшегінің жарамдылық шегінен тыс ({ $what } = { $value }, шегі 1).
validity-states-unbounded = Жарамсыз: кейбір күйлер { $place } «{ $part }» бөлшегінің жарамдылық шегінен тыс ({ $what } шексіз, шегі 1).
validity-motions = Жарамсыз: кейбір { $motions } «{ $part }» бөлшегінің жарамдылық шегінен тыс ({ $what } = { $value }, шегі 1).
validity-motions-unbounded = Жарамсыз: кейбір { $motions } «{ $part }» бөлшегінің жарамдылық шегінен тыс ({ $what } шексіз, шегі 1).

# Count of roots by the argument principle.
region-growing-root = өсетін түбір
region-faster-root = { $growth } мәнінен тез өсетін түбір
region-all-roots = Түбір саны тексерілді (аргумент принципі): { $frequency } жиілігінен төмен бірде-бір { $root } қалып қойған жоқ. { $found ->
        [0] Саналған облыстарда түбір жоқ
        [1] Саналған облыстардағы жалғыз түбір белгілі
       *[other] Саналған облыстардағы барлық { $found } түбір белгілі
    }.
region-all-modes = { $found ->
        [0] { $frequency } жиілігінен төмен мода жоқ
        [1] { $frequency } жиілігінен төмен жалғыз мода есептелді
       *[other] { $frequency } жиілігінен төмен барлық { $found } мода есептелді
    }; бірде-бірі қалып қойған жоқ (түбір саны аргумент принципімен тексерілді). Жоғары модалар есептелмейді: машинада { $states } күй айнымалысы бар. Шекті frequency_limit береді.
region-modes-followed = { $frequency } жиілігінен төмен барлық мода қадағаланды: олардың саны { $all } айналу жиілігінің { $speeds } мәнінде тексерілді (аргумент принципі). Жоғары модалар есептелмейді; шекті frequency_limit береді.
region-modes-not-counted = { $frequency } жиілігінен төмен модалар қалып қойған болуы мүмкін: санау { $open } айналу жиілігінде нәтиже бермеді. Басқа frequency_limit мәнін қолданып көріңіз.
region-slower-roots-missed = Түбір саны тексерілді (аргумент принципі): { $frequency } жиілігінен төмен бірде-бір { $root } қалып қойған жоқ. { $part } ішіндегі баяу толқындар саналған, бірақ есептелмеген тағы { $missing } түбір қосады.
region-roots-missed = Орнықтылық дәлелденген жоқ: саналған { $missing } түбір табылмады, { $missing ->
        [one] ол
       *[other] олардың бірі
    } { $root } болуы мүмкін. frequency_limit мәнін азайтыңыз немесе growth_threshold мәнін 0-ден үлкен етіп қойыңыз.
region-roots-not-counted = { $proven ->
        [yes] { $frequency } жиілігінен төмен бірде-бір { $root } қалып қойған жоқ, бірақ одан баяу түбірлер табылмай қалуы мүмкін
       *[no] Орнықтылық дәлелденген жоқ, түбірлер табылмай қалуы мүмкін
    }: { $all } облыстың { $open } облысында санау нәтиже бермеді. Басқа frequency_limit мәнін қолданып көріңіз.
region-uncounted-roots = { $all } түбірдің { $outside } түбірі саналған облыстардан тыс жатыр. Олардың жанында басқа түбірлер табылмай қалуы мүмкін.
region-dense-range = { $speed } кезінде { $part } ішіндегі { $waves } { $from } – { $to } аралығындағы тура жиіліктерде үздіксіз спектр түзеді. Басқа бөліктердегі демпферлеу олардың кейбірін баяу өсіреді, сондықтан тек шектік мәннен жоғары өсу орнықсыздықты білдіреді. Одан баяу өсуді анықтайтын { $loss } модельде жоқ.
region-half-plane = Тек өсетін түбірлер саналады. { $part } бар машинаның өшетін түбірлері іздеу арқылы табылады; тербелісте әрең байқалатын түбір табылмай қалуы мүмкін.
region-accumulation = { $from } – { $to } аралығындағы, өсуі немесе өшуі { $growth } мәнінен төмен түбірлер саналмайды: { $speed } кезінде толқындар онда жиналады.
region-other-orders = тағы { $n }
region-orders-without-response = Тербелістің { $n ->
        [one] реті
       *[other] реттері
    } ({ $orders }) { $value } кезінде { $from } – { $to } аралығындағы үздіксіз спектрге түседі, оны { $waves } түзеді. Онда { $part } орныққан жауап бермейді, теңдеулердің шешімі жоқ. { $remedy }.
region-orders-of-kept-waves = Тербелістің { $n ->
        [one] реті
       *[other] реттері
    } ({ $orders }) { $value } кезінде { $from } – { $to } аралығындағы үздіксіз спектрге түседі, оны { $waves } түзеді. Онда { $part } орныққан жауап бермейді; { $kept }.

# A study that ended early, or did not begin.
watch-nothing-shown = Нәтиже жоқ: зерттеу аралық нәтижесі жоқ есептеу кезінде тоқтатылды.
store-incomplete = Сұралған { $requested } { $rows } ішінен тек { $done } есептелді.
store-incomplete-kept = Сұралған { $requested } { $rows } ішінен тек { $done } есептелді. Сол команда есептеуді жалғастырады.
run-refused = { $reason }
run-refused-alike = Зерттеу «{ $study }» зерттеуімен бірдей себептен орындалмайды.

# Vessels that the dynamics lack.
cups-not-carried = Динамикада «{ $vessel }» ыдысының массасы мен дисбалансы жоқ: оны ешбір дене көтермейді. on = "{ $body }" деп, mass және centre_of_mass қосыңыз.
cups-not-carried-by-any = Динамикада «{ $vessel }» ыдысының массасы мен дисбалансы жоқ: оны ешбір дене көтермейді. on өрісінде денені көрсетіп, mass және centre_of_mass қосыңыз.
cups-bowl-without-liquid = Динамикада «{ $vessel }» ыдысындағы сұйықтық жоқ. Барабан денесіне kind = "liquid" өрісі бар [[part]] қосыңыз немесе массаны сол денеге қосыңыз.
