# Undamped critical speeds over the stiffness of the supports.
support-map-intersection = Critical speed { $mode } is { $value } with all supports as stiff as { $bearing }. At { $stiffness } each they hold { $share } of the strain energy.{ $moves ->
        [supports] {" "}Other bearings move it.
        [rotor] {" "}Only another rotor moves it.
       *[both] {" "}Bearings and rotor both move it.
    }
support-map-rigid = On rigid supports the lowest critical speed with forward whirl is { $value }. No bearing raises it beyond that.
support-map-free = Without supports the lowest critical speed with forward whirl is { $value }. Motions of the free rotor at zero speed are left out.
support-map-fewer = { $modes ->
        [0] The rotor has no forward critical speed: its polar moment of inertia exceeds the diametral one
        [one] The rotor has one critical speed
       *[other] The rotor has { $modes } critical speeds
    } in the map. Modes with a larger polar than diametral moment of inertia have none.
support-map-counted = All { $roots } critical speeds are counted: the numbers below and above each differ by one.
support-map-together = { $roots ->
        [one] One critical speed lies
       *[other] { $roots } critical speeds lie
    } too close to another to be counted by itself.
support-map-replaced = Replaced by equal stiffness in x and y, without damping and cross terms: { $parts }. Pedestals and masses stay.{ $nonlinears ->
        [0] {""}
       *[other] {" "}A bearing whose stiffness depends on its load and deflection has no curve here: { $nonlinear }.
    }{ $softs ->
        [0] {""}
       *[other] {" "}Without positive stiffness, and so without a curve: { $soft }.
    }
support-map-directions = The machine prefers a direction beside its bearings: curves hold forward and backward whirls.
support-map-spin = Speeds are those of what turns with "{ $spin }", { $ratio } times the speed of the machine.{ $others ->
        [0] {""}
       *[other] {" "}What turns otherwise has critical speeds of its own: give spin in a study of its own.
    }
support-map-machine-spin = Speeds are those of the machine. What turns with { $spins } has critical speeds of its own: give spin in a study of its own.

support-map-bearing = { $parts }{ $axes ->
        [x] , kxx
        [y] , kyy
       *[both] {""}
    }
support-map-curve = critical speed { $mode }
support-map-at-rest = natural frequency { $mode } at rest
support-map-alt = Critical speeds over the stiffness of every support: { $curves ->
        [one] one curve
       *[other] { $curves } curves
    }, { $points ->
        [0] which no bearing of the machine meets
        [one] which a bearing of the machine meets in one point
       *[other] which bearings of the machine meet in { $points } points
    }.
