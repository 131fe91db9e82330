# Approximate methods beside the converged response.

methods-method = { $method ->
        [harmonic] { $order }-ретке дейінгі гармоникалық баланс
        [averaging] орташалау
        [elliptic] эллиптикалық баланс
        [time] уақыт бойынша интегралдау
       *[converged] жинақталған гармоникалық баланс
    }
methods-unstable = Салыстырылған { $states } күйдің { $unstable } күйі орнықсыз; машина { $unstable ->
        [one] ол күйде
       *[other] ондай күйлерде
    } қалмайды.
methods-deviation = Ең үлкен қателік ({ $method }) ең биік шыңның { $value } бөлігі, { $speed } кезінде, { $state }-күйде.
methods-exact = Салыстырылған айналу жиіліктерінде шыңдар ({ $method }) жинақталған мәндерге дөңгелектеу дәлдігімен тең.
methods-missing = { $states } күйдің { $missing } күйі табылмады.
methods-no-states = Бірде-бір күй табылмады ({ $method }).
methods-averaging-stability = { $wrong ->
        [0] Орташалау орнықтылықты { $states } күйдің { $states } күйінде дұрыс береді.
       *[other] Орташалау орнықтылықты { $states } күйдің { $wrong } күйінде қате береді, өйткені ол тек айналу жиілігіне жақын моданы қамтиды.
    }
methods-fold-deviation = Бір гармоника да, орташалау да { $speed } кезіндегі бұрылу нүктесін { $value } шамасына ығыстырады.
methods-no-elliptic-balance = Эллиптикалық баланс есептелмеді: { $why }.
methods-no-time-integration = Кейбір күйлер уақыт бойынша интегралданбады: { $why }.
methods-one-harmonic-exact = Машина изотропты: тербелісі шеңбер бойымен өтеді, бір гармоника дәл нәтиже береді.
