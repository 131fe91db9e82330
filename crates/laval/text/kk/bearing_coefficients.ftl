# Supports at rest over the speed.
bearing-coefficients-state = { $speed } кезінде { $part } { $value } көтереді; қатаңдығы x бойынша { $x }, y бойынша { $y }.
bearing-coefficients-film = { $speed } кезінде { $part } { $value } көтереді, эксцентриситеті саңылаудың { $eccentricity }{ $loaded ->
        [yes] , жүктемеден бұрышы { $attitude }
       *[no] {""}
    }{ $shows ->
        [film] ; қабықша қалыңдығы кемінде { $film }, шығыны { $power }
       *[nothing] {""}
    }.
bearing-coefficients-threshold = { $any ->
        [all] { $part } үстіндегі кез келген қатты масса прецессия жасайды
       *[some] { $part } үстіндегі { $value } артық қатты масса прецессия жасайды
    }, жиілігі айналу жиілігінің { $share }; иілгіш ротор ертерек бастайды.
bearing-coefficients-no-rest = Тепе-теңдік күйі жоқ айналу жиіліктері: { $count }, { $value } дейін.
bearing-coefficients-alt = { $speeds } айналу жиілігіндегі тыныштықтағы машина тіректері, әрқайсысына бір сызық.
