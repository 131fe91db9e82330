# Small pictures side by side: shapes of modes, deflected shapes, orbits; and the polar diagram.

# The point on every orbit.
tiles-instant = нүктелердің бір сәттегі орны
tiles-mark = фаза белгісі x осінен өткен сәттегі орны
# Lines along the axis.
tiles-plane-x = сол сәттегі x бойынша ығысу
tiles-plane-y = y бойынша ығысу
tiles-envelope = үлкен жарты осьтер арасы
tiles-clearance = саңылау
# Remarks.
tiles-heights = Ось бойындағы сандар: дененің тірек нүктесінен биіктігі немесе біліктегі орны, { $unit }.
tiles-not-to-scale = Машина файлында денелер арасындағы қашықтықтар берілмеген. Денелер бірінің астында бірі көрсетілген.
tiles-own-scale = Әр суреттің өз масштабы бар.
tiles-more-points = Тағы { $points } нүкте кестеде.
# Lines of text of a picture.
tiles-axes = { $major } × { $minor }
tiles-circle = шеңбер, { $radius }
tiles-straight = түзу сызық
tiles-at = { $speed }{ $reason ->
        [operating] , жұмыстық айналу жиілігі
        [resonance] , резонанс
       *[chosen] {""}
    }
tiles-reason = { $reason ->
        [operating] жұмыстық айналу жиілігі
        [resonance] резонанс
       *[chosen] есептің айналу жиілігі
    }
tiles-largest = { $point }: { $amplitude }

shapes-table = Модалардың пішіндері: әр нүктенің қозғалысы, моданың ең үлкен жарты осіне қатысты
shapes-more = Жиілігі жоғарырақ тағы { $modes } мода кестеде.
shapes-alt = { $speed } кезіндегі { $modes } моданың пішіні: нүктелердің кеңістіктегі орбиталары және ось бойындағы ығысулар.
shapes-share = { $kind ->
        [axial] ось бойымен: кинетикалық энергияның { $share }
       *[torsional] бұралу: кинетикалық энергияның { $share }
    }
shapes-along = { $kind ->
        [axial] { $mode }-мода ось бойымен де қозғалады, кинетикалық энергиядағы үлесі { $share }
       *[torsional] { $mode }-модада бұралу да бар, кинетикалық энергиядағы үлесі { $share }
    }: ось бойымен және осьті айнала қозғалыс суретін қараңыз.
along-table = Модалардың ось бойымен және осьті айнала қозғалысы, машинаның нүктелерінде
along-alt = { $speed } кезіндегі { $modes } моданың ось бойымен және осьті айнала қозғалысы, ең үлкен мәніне қатысты.
orbits-alt = { $speeds } айналу жиілігіндегі { $orbits } орбита, фаза белгісі және прецессия бағыты көрсетілген.
deflected-alt = Машинаның { $speeds } айналу жиілігіндегі иілген пішіні: нүктелердің кеңістіктегі орбиталары және ось бойындағы ығысулар.
polar-alt = { $bodies } дененің тура амплитудасы мен фазасы осьтен шығатын векторлар түрінде; қисық бойында айналу жиіліктері көрсетілген.
