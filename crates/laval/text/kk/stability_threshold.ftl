# Stability over a cross-coupled stiffness.
stability-threshold-threshold = { $damped ->
        [no] { $place } нүктесіндегі кез келген айқас қатаңдық машинаны { $speed } кезінде орнықсыз етеді: { $mode }-мода, { $frequency } жиіліктегі { $whirl }, демпферленбеген.
       *[yes] { $place } нүктесіндегі { $value } айқас қатаңдық машинаны { $speed } кезінде орнықсыз етеді: { $mode }-мода, { $frequency } жиіліктегі { $whirl }.
    }
stability-threshold-none = { $speed } кезінде машина { $place } нүктесіндегі { $value } айқас қатаңдыққа дейін орнықты.
stability-threshold-unknown = { $speed } кезінде { $place } нүктесіндегі { $value } айқас қатаңдыққа дейін шек табылмады; оған дейінгі орнықтылық дәлелденбеген.
stability-threshold-base = Айқас қатаңдықсыз { $speed } кезіндегі ең кіші логарифмдік декремент { $value }: { $mode }-мода, { $frequency } жиіліктегі { $whirl }.
stability-threshold-unstable-without = { $speed } кезінде машина айқас қатаңдықсыз да орнықсыз: { $mode }-мода, { $frequency } жиіліктегі { $whirl }, логарифмдік декремент { $value }.
stability-threshold-level-1 = 1-деңгей орындалды (API 684, SP6.8.5.10): күтілетін { $anticipated } қатаңдықта логарифмдік декремент { $value }, кемінде { $least_decrement } талап етіледі; шектің күтілетін қатаңдыққа қатынасы { $reached ->
        [yes] { $ratio }
       *[no] { $ratio } мәнінен үлкен
    }, кемінде { $least_ratio } талап етіледі.{ $density ->
        [yes] {" "}Қатынас 10-нан төмен болғанда газ тығыздығы мен жиіліктер қатынасының критерийі де есепке алынады; ол тексерілмеген.
       *[no] {""}
    }
stability-threshold-level-2 = 2-деңгейлі талдау қажет (API 684, SP6.8.5.10): күтілетін { $anticipated } қатаңдықта логарифмдік декремент { $value }, кемінде { $least_decrement } талап етіледі; шектің күтілетін қатаңдыққа қатынасы { $reached ->
        [yes] { $ratio }
       *[no] { $ratio } мәнінен үлкен
    }, кемінде { $least_ratio } талап етіледі.
stability-threshold-level-open = 1-деңгей шешілмеді (API 684, SP6.8.5.10): күтілетін { $anticipated } қатаңдықта логарифмдік декремент { $value }; { $ratio } қатынасқа дейін шек табылмады. up_to мәнін үлкейтіңіз.
stability-threshold-counted = Бүкіл спектр бойынша { $stiffness } кезіндегі өсетін модалар саны: { $growing }, бақыланған { $followed } мода арасында да сонша (көлденең модалар барлығы { $modes }).
stability-threshold-missed = { $stiffness } кезінде өсетін, орнықсыздықтың басына дейін бақыланбаған модалар саны: { $missed }. points мәнін үлкейтіңіз.
stability-threshold-not-counted = { $stiffness } кезінде өсетін модаларды санау мүмкін болмады: басқалары да орнықсыз болуы мүмкін.
stability-threshold-meeting = Екі мода { $value } кезінде еселі түбірде түйіседі. Одан әрі олардың нөмірлері шартты.
stability-threshold-lost = Ең үлкен қатаңдыққа дейін бақыланбаған модалар саны: { $modes }. points мәнін үлкейтіңіз.

stability-threshold-curve = { $mode }-мода, { $frequency } жиіліктегі { $whirl }
stability-threshold-alt = Айқас қатаңдыққа байланысты логарифмдік декремент, мода саны: { $modes }, шек саны: { $thresholds }.
