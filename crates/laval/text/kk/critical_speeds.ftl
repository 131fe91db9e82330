# Critical speeds, with the response to unbalance beside them.
critical-speeds-critical-speed = { $order }× сындық айналу жиілігі { $value }: { $whirl }, { $damped ->
        [no] демпферленбеген
       *[yes] салыстырмалы демпферлеуі { $damping }
    }.{ $response ->
        [peak] {" "}{ $body }: тербеліс шыңы { $peak } кезінде.
        [unbounded] {" "}{ $body }: онда тербеліс шексіз.
        [not_excited] {" "}Бұл машинада дисбаланс оны қоздырмайды.
        [no_peak] {" "}Онда дисбаланстан болатын тербелістің шыңы жоқ.
       *[none] {""}
    }
critical-speeds-response-peak = Дисбаланстан болатын тербелістің шыңы { $value } кезінде: { $body }, амплитудасы { $amplitude }. Онда ешбір меншікті жиілік айналу жиілігіне тең емес.
critical-speeds-response-unbounded = Дисбаланстан болатын тербеліс { $value } кезінде шексіз: { $body }. Онда ешбір меншікті жиілік айналу жиілігіне тең емес.
critical-speeds-none = Бұл ауқымда сындық айналу жиілігі табылмады.
critical-speeds-peaks-alone = Бұл ауқымда сындық айналу жиілігі табылмады: { $peaks ->
        [one] тербеліс шыңында
       *[other] { $peaks } тербеліс шыңында
    } ешбір меншікті жиілік айналу жиілігіне тең емес.
critical-speeds-none-yet = Зерттеу тоқтағанға дейін сындық айналу жиілігі табылмады.

# Distance of the operating speed from the nearest of them.
critical-speeds-margin = Алшақтық қоры { $value }, талап етілетіні { $required }: жұмыстық айналу жиілігі { $operating }, { $nearest ->
        [peak] ең жақын тербеліс шыңы
       *[critical_speed] ең жақын әлсіз демпферленген { $order }× сындық айналу жиілігі
    } { $critical }{ $located ->
        [no] , дәл мәні анықталмаған
       *[yes] {""}
    }.{ $search ->
        [stopped] {" "}Бұл – зерттеу тоқтағанға дейін табылғандардың ең жақыны.
       *[complete] {""}
    }{ $excited ->
        [no] {" "}Бұл машинаның дисбалансы онда резонанс қоздырмайды.
       *[yes] {""}
    }
critical-speeds-small-margin = Алшақтық қоры { $value } талап етілетін { $required } мәнінен төмен: жұмыстық айналу жиілігі { $operating }, { $nearest ->
        [peak] ең жақын тербеліс шыңы
       *[critical_speed] ең жақын әлсіз демпферленген { $order }× сындық айналу жиілігі
    } { $critical }{ $located ->
        [no] , дәл мәні анықталмаған
       *[yes] {""}
    }. Айналу жиілігін, қатаңдықты немесе демпферлеуді өзгертіңіз.
critical-speeds-no-margin = Жұмыстық айналу жиілігі { $operating } – { $nearest ->
        [peak] дисбаланстан болатын тербелістің шыңы
       *[critical_speed] әлсіз демпферленген { $order }× сындық айналу жиілігі
    }{ $located ->
        [no] , дәл мәні анықталмаған
       *[yes] {""}
    }.{ $excited ->
        [no] {" "}Бұл машинаның дисбалансы онда резонанс қоздырмайды.
       *[yes] {""}
    }
