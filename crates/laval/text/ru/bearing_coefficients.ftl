# Supports at rest over the speed.
bearing-coefficients-state = { $part } несёт { $value } при { $speed }; жёсткость по x { $x }, по y { $y }.
bearing-coefficients-film = { $part } несёт { $value } при { $speed } с эксцентриситетом { $eccentricity } зазора{ $loaded ->
        [yes] {" "}под углом { $attitude } к нагрузке
       *[no] {""}
    }{ $shows ->
        [film] ; толщина плёнки не меньше { $film }, потери { $power }
       *[nothing] {""}
    }.
bearing-coefficients-threshold = { $any ->
        [all] Любая жёсткая масса на { $part } прецессирует
       *[some] Жёсткая масса больше { $value } на { $part } прецессирует
    } с частотой { $share } частоты вращения; гибкий ротор прецессирует раньше.
bearing-coefficients-no-rest = Частот вращения без положения равновесия: { $count }, вплоть до { $value }.
bearing-coefficients-alt = Опоры машины в покое при { $speeds } частотах вращения, по одной линии на каждую.
