# Supports at rest over the speed.
bearing-coefficients-state = { $part } carries { $value } at { $speed }, with a stiffness of { $x } in x and { $y } in y.
bearing-coefficients-film = { $part } carries { $value } at { $speed } at an eccentricity of { $eccentricity } of its clearance{ $loaded ->
        [yes] , { $attitude } from the load
       *[no] {""}
    }{ $shows ->
        [film] ; the film is at least { $film } thick and takes { $power }
       *[nothing] {""}
    }.
bearing-coefficients-threshold = { $any ->
        [all] Every rigid mass on { $part } whirls
       *[some] A rigid mass of more than { $value } on { $part } whirls
    }, at { $share } of the speed; a flexible rotor whirls earlier.
bearing-coefficients-no-rest = { $count ->
        [one] One speed has
       *[other] { $count } speeds have
    } no state at rest, up to { $value }.
bearing-coefficients-alt = The supports of the machine at rest at { $speeds } speeds, one line for each.
