# The mode that grows most.
campbell-unstable = { $mode }-мода орнықсыз: { $whirl ->
        [none] статикалық орнықсыздық (дивергенция)
        [forward] тура прецессия, жиілігі { $frequency }
        [backward] кері прецессия, жиілігі { $frequency }
       *[vibration] тербеліс, жиілігі { $frequency }
    }, ең үлкен өсу жылдамдығы { $value }, { $speed } кезінде.

# Critical speeds.
campbell-critical-speed = { $order }× сындық айналу жиілігі { $value }: { $whirl }, { $damped ->
        [no] демпферленбеген
       *[yes] салыстырмалы демпферлеуі { $damping }
    }.
campbell-critical-speed-not-located = { $order }× сындық айналу жиілігі { $value } – { $to } аралығында жатыр, бірақ дәл мәні анықталмады. Ол жерде нүкте санын арттырыңыз.
campbell-no-critical-speed = Бұл ауқымда сындық айналу жиілігі табылмады.
campbell-no-critical-speed-yet = Зерттеу тоқтағанға дейін сындық айналу жиілігі табылмады.

# How far the modes are known.
campbell-ambiguous = Айналу жиілігінің { $steps } қадамында модаларды қадағалау бірмәнді емес, алғашқысы { $value } – { $to } аралығында. Онда модалар ауысып кеткен болуы мүмкін; нүкте санын арттырыңыз.
campbell-slow-roots = Баяу толқындардың сындық айналу жиіліктері табылмай қалуы мүмкін: жорамал ось маңындағы түбірлердің бәрі жалғастырылмайды. forced_response резонанстарымен салыстырыңыз.
