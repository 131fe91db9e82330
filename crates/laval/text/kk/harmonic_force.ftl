# Response to a harmonic force.
harmonic-force-largest = Ең үлкен резонанс { $value } кезінде: { $body } { $amplitude } мәніне жетеді{ $known ->
        [yes] , күшейту коэффициенті { $factor }
       *[no] {""}
    }.
harmonic-force-unbounded = { $value } кезінде демпферлеусіз резонанс: { $body } амплитудасы шексіз.
harmonic-force-singular = { $value } кезінде демпферлеусіз резонанс: амплитуда шексіз.
harmonic-force-none = Бұл { $over ->
        [speed] айналу жиіліктері
       *[frequency] жиіліктер
    } диапазонында резонанс жоқ.
harmonic-force-amplitude = { $speed } кезінде { $body } амплитудасы { $value }.
harmonic-force-frequency-only = Қадамнан тар резонанстар қалып қоюы мүмкін, орнықтылық тексерілмеген: бір элемент тек жиілік облысында берілген.
harmonic-force-margin-kept = Жиілік қорлары сақталған (API 684, SP6.8.2.10). Ең азы { $resonance } резонансында: { $value }, { $known ->
        [yes] күшейту коэффициенті { $factor } болғанда
       *[no] күшейту коэффициенті (ол белгісіз) кез келген болғанда
    } { $required } талап етіледі.
harmonic-force-margin-broken = Жиілік қоры аз (API 684, SP6.8.2.10): { $resonance } резонансында { $value }, күшейту коэффициенті { $factor } болғанда { $required } талап етіледі.
harmonic-force-gap-closes = Тербеліс «{ $part }» саңылауын жабады, тепе-теңдікте { $gap }, { $value } бастап { $last } дейін. Жанасу ескерілмеген, сондықтан амплитудалар онда жарамсыз.
harmonic-force-validity = Жарамсыз: жауап { $place } кезінде «{ $part }» аумағынан тыс, { $what } = { $value } (шегі 1).
harmonic-force-validity-unbounded = Жарамсыз: жауап { $place } кезінде «{ $part }» аумағынан тыс, { $what } шексіз (шегі 1).

harmonic-force-alt = Гармоникалық күш әсеріндегі барлық нүкте амплитудалары, резонанс саны: { $peaks }.
