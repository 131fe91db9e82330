# Loci of bifurcations over speed and a parameter.

bifurcation-loci-kind = { $kind ->
        [neimark-sacker] Неймарк – Сакер бифуркациясы
        [period-doubling] периодтың екі еселенуі
        [symmetry-breaking] симметрияның бұзылуы
        [branch-point] тармақталу нүктесі
       *[fold] бұрылу нүктесі
    }

# Turning points of loci.
bifurcation-loci-cusp = { $parameter } = { $value } және { $speed } кезінде екі бұрылу нүктесі үшкір нүктеде (касп) жойылады; олар тек осы мәннен { $side ->
        [above] жоғары
       *[below] төмен
    } болады.
bifurcation-loci-folds-meet = { $parameter } = { $value } және { $speed } кезінде екі бұрылу нүктесі түйіседі; олар тек осы мәннен { $side ->
        [above] жоғары
       *[below] төмен
    } болады. Онда бөлек тармақ басталады немесе тармақтар бөліктерімен алмасады.
bifurcation-loci-extremum = { $locus }-сызық ({ $kind }) { $parameter } = { $value } және { $speed } кезінде кері бұрылады; ол тек осы мәннен { $side ->
        [above] жоғары
       *[below] төмен
    } жатады.

# Folds and hysteresis.
bifurcation-loci-folds = Бұрылу нүктелері { $parameter } параметрінің { $value } – { $largest } аралығында табылды, { $place }. Төменгі шек: { $below }; жоғарғы шек: { $above }.{ $stopped ->
        [yes] {" "}Зерттеу тоқтатылды; басқалары да болуы мүмкін.
       *[no] {""}
    }
bifurcation-loci-limit = { $limit ->
        [cusp] үшкір нүкте (касп)
        [folds-meet] бұрылу нүктелері түйіседі
        [range] ауқымның шеті
       *[left] { $stopped ->
            [yes] сызық айналу жиілігінің ауқымынан шығады, ерте аяқталады немесе тоқтатылды
           *[no] сызық айналу жиілігінің ауқымынан шығады немесе ерте аяқталады
        }
    }
bifurcation-loci-widest-hysteresis = Гистерезис { $parameter } = { $at } кезінде ең кең: ені { $value }, төменгі шеті { $lower }.{ $cut ->
        [yes] {" "}Онда бұрылу нүктесі айналу жиілігінің ауқымынан шығады; гистерезис одан әрі жалғасады.
       *[no] {""}
    }{ $stopped ->
        [yes] {" "}Зерттеу тоқтатылды; одан кеңі де болуы мүмкін.
       *[no] {""}
    }

# Single loci.
bifurcation-loci-fold-locus = { $locus }-сызық, бұрылу нүктелері: { $course }.
bifurcation-loci-stability-locus = { $locus }-сызық, { $kind }: { $course }.{ $whirl ->
        [yes] {" "}Ондағы прецессия жиілігі { $lowest } – { $highest } аралығында.
       *[no] {""}
    }{ $others ->
        [all] {" "}Бүкіл сызық бойында басқа көрсеткіштер орнықсыз.
        [part] {" "}Сызықтың бір бөлігінде басқа көрсеткіштер орнықсыз; ол бөлік орнықты күйлерді шектемейді.
       *[none] {""}
    }
bifurcation-loci-closed = тұйық қисық
bifurcation-loci-from-to = басы { $from }; соңы { $to }
bifurcation-loci-end = { $value }, { $speed } кезінде, { $end ->
        [value] параметр ауқымының шеті
        [speed] айналу жиілігі ауқымының шеті
        [points] нүкте санының шегі
        [stopped] зерттеу тоқтатылған жер
       *[stuck] ерте аяқталған жер
    }
bifurcation-loci-unfinished = { $locus }-сызық { $parameter } = { $value } және { $speed } кезінде ерте аяқталады: { $why }. Одан арғы бифуркациялар табылмай қалуы мүмкін.
bifurcation-loci-none = { $parameter } параметрінің { $values } мәніндегі тербелістерде{ $beside ->
        [lost] {" "}жалғастыруға болатын
       *[none] {""}
    } { $sought ->
        [both] бұрылу нүктесі де, орнықтылықтың басқа өзгерісі де
        [folds] бұрылу нүктесі
       *[stability] бұрылу нүктесінен басқа орнықтылық өзгерісі
    }{ $stopped ->
        [yes] {" "}зерттеу тоқтағанға дейін табылмады.
       *[no] {" "}табылмады. Басқа мәндерде сызықтар болуы мүмкін; points мәнін арттырыңыз.
    }{ $beside ->
        [folds] {" "}{ $folds } бұрылу нүктесі табылды, бірақ олар сұралмаған.
       *[none] {""}
    }

# What was left out.
bifurcation-loci-starts-lost = Есептелген тербелістердің { $count } бифуркациясынан сызық жүргізілмеді. Сызықтар табылмай қалуы мүмкін; points мәнін арттырыңыз.
bifurcation-loci-no-response = Тербеліс { $count ->
        [one] { $parameter } = { $first } кезінде
       *[other] { $parameter } параметрінің { $count } мәнінде, алғашқысы { $first },
    } есептелмеді: { $why }. Ондағы сызықтар табылмай қалуы мүмкін.
bifurcation-loci-corners = { $count } бұрылу нүктесі күш заңы қозғалыс бойында өзгеретін жерде жатыр, мысалы жанасу басталғанда. Мұндай бұрылу нүктелері жалғастырылмайды.
bifurcation-loci-more = Сызықтар саны { $most } шегінен көп; қалғандары есептелмеді. Айналу жиілігінің ауқымын тарылтыңыз.
bifurcation-loci-stability-unknown = Кейбір немесе барлық күйдің орнықтылығы есептелмеді: { $why }. Орнықтылық өзгеретін сызықтар табылмай қалуы мүмкін.
bifurcation-loci-harmonics-short = Сақталған гармоникалар сызықтардың ең нашар нүктесінде бейсызық күштің { $value } бөлігін қамтымайды. harmonics мәнін арттырыңыз.
bifurcation-loci-parameter-range = { $parameter } параметрі { $value } мәнінен { $side ->
        [below] төмен
       *[above] жоғары
    } болатын машина жоқ; ауқымның бұл бөлігі есептелмеді: { $why }.
