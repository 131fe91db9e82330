# What the studies in time share.

# The last moment of a record, within a sentence.
history-end = соңында
history-stop = интегралдау тоқтаған сәтте ({ $at })

# Displacements.
history-largest = «{ $body }» денесінің тепе-теңдіктен ең үлкен { $quality ->
        [tilt] көлбеу бұрышы
       *[displacement] ығысуы
    } { $value }.
history-at-equilibrium = «{ $body }» денесі интегралдау дәлдігі шегінде тепе-теңдікте қалады.
history-only-tilts = «{ $body }» денесі көлбейді, бірақ ығысуы интегралдау дәлдігі шегінде тепе-теңдікте қалады.
history-unresolved = «{ $body }» денесі тепе-теңдіктен { $value } шамасынан артық ауытқымайды; бұл дәлдікте интегралдау оны нөлден ажырата алмайды: relative_tolerance мәнін азайтыңыз.

# A motion that passes every bound.
history-unbounded = «{ $body }» денесінің қозғалысы { $speed } кезінде шексіз өседі: интегралдау аяқталған сәтте ({ $at }) тепе-теңдіктен { $displacement } ауытқиды. Бұл айналу жиілігінен аулақ болыңыз немесе демпферлеу қосыңыз.
history-unbounded-exponential = «{ $body }» денесінің қозғалысы { $speed } кезінде шексіз өседі, өсу жылдамдығы { $value }: интегралдау аяқталған сәтте ({ $at }) тепе-теңдіктен { $displacement } ауытқиды. Бұл айналу жиілігінен аулақ болыңыз немесе демпферлеу қосыңыз.
history-unbounded-linear = «{ $body }» денесінің қозғалысы { $speed } кезінде уақыт бойынша сызықты өседі, жылдамдығы { $value }: интегралдау аяқталған сәтте ({ $at }) тепе-теңдіктен { $displacement } ауытқиды. Бұл айналу жиілігінен аулақ болыңыз немесе демпферлеу қосыңыз.

# An integration that ended early.
history-work-limit = Қадам санының шегіне (--work-limit) { $value } сәтінде жетті. Қалғанын есептеу үшін оны арттырыңыз.
history-step-too-small = Интегралдау { $value } сәтінде тоқтады, өйткені ешбір қадам дәлдік талабын қанағаттандырмайды. Онда қозғалыс шексіз өсуі мүмкін; басқа әдісті немесе үлкенірек relative_tolerance мәнін қолданып көріңіз.
history-integration-failed = Интегралдау { $value } сәтінде тоқтады: { $why }. Одан кейінгі қозғалыс жоқ.

# Rational forms of parts in time.
history-reduced = Машинаның сызықты бөліктері { $coordinates } координатаға келтірілді. { $frequency } жиілікке дейін басқа бөліктер бекітілген жерлердегі икемділігі бүтін машинаның икемділігінен { $value } шамаға өзгеше.
history-time-form = Уақыт бойынша есептеуде «{ $part }» бөлшегінің орнына { $states } күйі бар рационал форма алынған. Оның салыстырмалы қателігі ең көбі { $value }, { $scope }.
history-time-fit = Уақыт бойынша есептеуде «{ $part }» бөлшегінің жиіліктік сипаттамасының орнына рационал жуықтау алынған. Оның салыстырмалы қателігі { $value }.

# Validity of parts along the motion.
history-valid = «{ $part }» бөлшегі жарамдылық шегінде: { $what } ≤ { $value } (шегі 1).
history-valid-after-start = «{ $part }» бөлшегі { $above ->
        [standstill] ротор айнала бастағаннан кейін
       *[speed] { $speed } мәнінен жоғары
    } жарамдылық шегінде: { $what } ≤ { $value } (шегі 1).
history-valid-while-turning = «{ $part }» бөлшегі { $above ->
        [standstill] ротор айналып тұрғанда
       *[speed] { $speed } мәнінен жоғары
    } жарамдылық шегінде: { $what } ≤ 1.
history-valid-later = «{ $part }» бөлшегі { $value } сәтіне дейін жарамсыз, ол кезде айналу жиілігі { $speed }: { $what } 1-ден асады. Сол сәтке дейінгі қозғалысты пайдаланбаңыз.
history-not-valid = «{ $part }» бөлшегі жарамдылық шегінен асты: { $what } = { $value } (шегі 1). Қозғалыс { $first } сәтінен бастап жарамсыз.
history-not-valid-unbounded = «{ $part }» бөлшегі жарамдылық шегінен асты: { $what } шексіз (шегі 1). Қозғалыс { $first } сәтінен бастап жарамсыз.

# Contacts and gaps.
history-contacts = Ауыспалы күш заңдары { $count } рет ауысты; әр ауысудың уақыты дәл анықталды.

# Energy balance.
history-energy-closes = Энергия балансының қателігі алмасқан энергияның { $value } бөлігі.
history-energy-closes-to-rounding = Энергия балансы дөңгелектеу дәлдігімен сақталады: жиналған немесе алмасқан энергияның { $value } бөлігі.
history-energy-missing = Энергия балансында алмасқан энергияның { $value } бөлігі жетпейді. relative_tolerance мәнін азайтыңыз.
history-energy-out-of-range = Энергия балансы жоқ: энергиялар сандар ауқымынан асады. Баланс бұл қозғалысты растамайды; шексіз өсудің бар-жоғын тексеріңіз.
history-energy-unknown = Энергия балансы жоқ: «{ $part }» бөлшегі өз энергиясын бермейді.
