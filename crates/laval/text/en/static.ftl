# The machine at rest under its weight.
static-sag = { $place ->
        [along] { $body } at { $position }
       *[body] { $body }
    } sags by { $value } on the stiffness of its supports at { $speed }.{ $load ->
        [force] {" "}Constant forces deflect it; the weight acts along the axis.
       *[weight] {""}
    }
static-rigid-sag = On rigid supports { $place ->
        [along] { $body } at { $position }
       *[body] { $body }
    } sags by { $value }.
static-load = { $part } carries { $value }, the largest load of a support. The whole machine weighs { $weight }.
static-moment = The largest bending moment is { $value }: { $body } at { $position }.
static-vertical = The weight of { $weight } acts along the axis: nothing is deflected, and no bearing carries a lateral load.
static-weightless = No weight and no constant force acts: nothing is deflected.
static-not-held = Rigid supports in the places of the bearings alone do not hold the machine: their results are left out. Name more parts in supports.
static-mass = { $body } with all it carries: mass { $value }{ $tilts ->
        [yes] , centre of mass at { $centre }, moment of inertia { $polar } about the axis and { $diametral } across it
       *[no] {""}
    }.

static-line = { $plane ->
        [x] x
       *[y] y
    }, { $supports ->
        [rigid] rigid supports
       *[own] own stiffness of the supports
    }
static-alt = Deflection, shear force and bending moment at rest along { $shafts ->
        [one] the shaft
       *[other] { $shafts } shafts
    }.
