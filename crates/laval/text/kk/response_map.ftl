# The nonlinear response over two parameters.

response-map-place = { $first } = { $x }, { $second } = { $y }
response-map-failed = { $machines } машинаның { $count } машинасында тербеліс табылмады, мысалы { $at } болғанда: { $why }.
response-map-branches-left = { $machines } машинаның { $count } машинасында ерте аяқталған тармақ бар, картаның end бағанын қараңыз. Одан арғы шыңдар мен секірістер табылмай қалуы мүмкін.
response-map-peaks-not-reached = { $machines } машинаның { $count } машинасында картада шың жоқ: тармақ ерте аяқталған жерде ығысу немесе көлбеу бұрышы әлі өсіп тұр.

# Jumps and hysteresis.
response-map-jumping = { $jumping ->
        [none] Айналу жиілігінің бұл ауқымында { $known ->
            [one] жалғыз машинада
           *[other] { $known } машинаның ешқайсысында
        } секіріс жоқ.
        [all] Айналу жиілігінің бұл ауқымында { $known ->
            [one] жалғыз машинада
           *[other] барлық { $known } машинада
        } секіріс бар{ $down ->
            [0] {""}
           *[other] , соның ішінде тек баяулау кезінде: { $down } машинада
        }.
       *[some] Айналу жиілігінің бұл ауқымында { $known } машинаның { $count } машинасында секіріс бар{ $down ->
            [0] {""}
           *[other] , соның ішінде тек баяулау кезінде: { $down } машинада
        }.
    }
response-map-widest-hysteresis = Ең кең гистерезис { $value }, { $at } болғанда.{ $open ->
        [yes] {" "}Ол айналу жиілігінің ауқымынан әрі жалғасады.
       *[no] {""}
    }

# Peaks.
response-map-largest-peak = Ең үлкен шың { $value }, { $speed } кезінде, { $at } болғанда.{ $end ->
        [yes] {" "}Ол айналу жиілігі ауқымының шетінде жатыр, одан әрі өсуі мүмкін.
       *[no] {""}
    }
response-map-smallest-peak = Ең кіші шың { $value }, { $speed } кезінде, { $at } болғанда.{ $end ->
        [yes] {" "}Ол айналу жиілігі ауқымының шетінде жатыр, одан әрі өсуі мүмкін.
       *[no] {""}
    }
response-map-largest-tilt = Ең үлкен көлбеу бұрышы { $value }, { $speed } кезінде, { $at } болғанда.

# Stability and validity.
response-map-stability-not-requested = Орнықтылық есептелмеген, көрсетілген күйлер орнықсыз болуы мүмкін. stability = true қойыңыз.
response-map-stability-unknown = { $machines } машинаның { $count } машинасында кейбір күйлердің орнықтылығы белгісіз: { $why }. Көрсетілген күйлер орнықсыз болуы мүмкін.
response-map-unstable = { $machines } машинаның { $count } машинасында екі бұрылу нүктесінің арасына жатпайтын орнықсыз күйлер бар. Ең үлкен өсу жылдамдығы { $value }, { $at } болғанда.
response-map-neimark-sacker = { $machines } машинаның { $count } машинасында Неймарк – Сакер бифуркациясы бар: тербеліс екі жиілікті қозғалысқа айналады.
response-map-symmetry-breaking = { $machines } машинаның { $count } машинасында тербеліс симметриясын бұзатын бифуркация бар.
response-map-period-doubling = { $machines } машинаның { $count } машинасында тербеліс периодының екі еселенуі бар.
response-map-outside-validity = Жарамсыз: { $what }. { $machines } машинаның { $count } машинасында кейбір күйлер шектің { $value } есесіне жетеді.
response-map-outside-validity-unbounded = Жарамсыз: { $what }. { $machines } машинаның { $count } машинасында кейбір күйлерде ол шексіз.
