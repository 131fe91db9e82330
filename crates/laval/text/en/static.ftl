# The machine at rest under its weight.
static-sag = { $place ->
        [along] { $body } at { $position }
       *[body] { $body }
    } is deflected by { $value } on the stiffness of its supports at { $speed }.{ $load ->
        [force] {" "}Constant forces deflect it; the weight acts along the axis.
        [offsets] {" "}Offsets of the supports are included.
        [raised] {" "}Offsets of the supports deflect it; the weight acts along the axis.
       *[weight] {""}
    }
static-rigid-sag = On rigid supports { $place ->
        [along] { $body } at { $position }
       *[body] { $body }
    } is deflected by { $value }.
static-load = { $part } carries { $value }, the largest load of a support. The whole machine weighs { $weight }.
static-moment = The largest bending moment is { $value }: { $body } at { $position }.
static-vertical = The weight of { $weight } acts along the axis: nothing is deflected, and no bearing carries a lateral load.
static-weightless = No weight and no constant force acts: nothing is deflected.
static-not-held = Rigid supports in the places of the bearings alone do not hold the machine: their results are left out. Name more parts in supports.
static-mass = { $body } with all it carries: mass { $value }{ $tilts ->
        [yes] , centre of mass at { $centre }, moment of inertia { $polar } about the axis and { $diametral } across it
       *[no] {""}
    }.
static-unloaded = At these offsets { $part } pulls the shaft down with { $value }: a real bearing loses its load. Raise it, or lower its neighbours.
static-offset-load = The offsets change the load of { $part } from { $before } to { $value }, the largest change of a support.
static-offsets-free = The offsets change no load of a support: the machine is statically determinate.
static-determinate = Offsets of the supports change none of their loads: the machine is statically determinate.
static-influence = { $part } is the support whose load depends most on its height: { $value }.
static-coupling = { $place } carries a bending moment of { $value } and a shear force of { $shear }.
static-aligned = { $part } at a height of { $value }{ $aside ->
        [yes] {" "}and { $sideways } sideways
       *[no] {""}
    } frees the couplings of load. It then carries { $load }.
static-not-aligned = No heights of the supports free the couplings of load. Name other couplings, or keep other supports.
static-spare = { $spare ->
        [one] One more height is free
       *[other] { $spare } more heights are free
    } than the couplings determine: the smallest changes are given.

static-line = { $plane ->
        [x] x
       *[y] y
    }, { $supports ->
        [rigid] rigid supports
        [aligned] couplings free of load
       *[own] own stiffness of the supports
    }
static-alt = Deflection, shear force and bending moment at rest along { $shafts ->
        [one] the shaft
       *[other] { $shafts } shafts
    }.
