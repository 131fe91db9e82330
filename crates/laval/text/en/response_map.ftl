# The nonlinear response over two parameters.

response-map-place = { $first } = { $x }, { $second } = { $y }
response-map-failed = { $count } of { $machines } machines { $count ->
        [one] has
       *[other] have
    } no response, for instance { $at }: { $why }.
response-map-branches-left = { $count } of { $machines } machines { $count ->
        [one] has
       *[other] have
    } a branch that ended early, see column end of the map. Peaks and jumps beyond may be missing.
response-map-peaks-not-reached = { $count } of { $machines } machines { $count ->
        [one] has
       *[other] have
    } no peak in the map: the displacement or tilt still rises where a branch ended early.

# Jumps and hysteresis.
response-map-jumping = { $jumping ->
        [none] { $known ->
            [one] The one machine does not jump
           *[other] None of the { $known } machines jumps
        } in this speed range.
        [all] { $known ->
            [one] The one machine jumps
           *[other] All { $known } machines jump
        } in this speed range{ $down ->
            [0] {""}
           *[other] , { $down } of them on run-down only
        }.
       *[some] { $count } of { $known } machines { $count ->
            [one] jumps
           *[other] jump
        } in this speed range{ $down ->
            [0] {""}
           *[other] , { $down } of them on run-down only
        }.
    }
response-map-widest-hysteresis = The widest hysteresis is { $value }, with { $at }.{ $open ->
        [yes] {" "}It continues beyond the speed range.
       *[no] {""}
    }

# Peaks.
response-map-largest-peak = The largest peak is { $value } at { $speed }, with { $at }.{ $end ->
        [yes] {" "}It lies at an end of the speed range and may rise beyond.
       *[no] {""}
    }
response-map-smallest-peak = The smallest peak is { $value } at { $speed }, with { $at }.{ $end ->
        [yes] {" "}It lies at an end of the speed range and may rise beyond.
       *[no] {""}
    }
response-map-largest-tilt = The largest tilt is { $value } at { $speed }, with { $at }.

# Stability and validity.
response-map-stability-not-requested = Stability was not computed, and states shown may be unstable. Set stability = true.
response-map-stability-unknown = Stability is unknown for some states of { $count } of { $machines } machines: { $why }. States shown may be unstable.
response-map-unstable = { $count } of { $machines } machines { $count ->
        [one] has
       *[other] have
    } unstable states that do not lie between two folds. The largest growth rate is { $value }, with { $at }.
response-map-neimark-sacker = { $count } of { $machines } machines { $count ->
        [one] has
       *[other] have
    } a Neimark–Sacker bifurcation: the response becomes a motion of two frequencies.
response-map-symmetry-breaking = { $count } of { $machines } machines { $count ->
        [one] has
       *[other] have
    } a symmetry-breaking bifurcation of the response.
response-map-period-doubling = { $count } of { $machines } machines { $count ->
        [one] has
       *[other] have
    } a period doubling of the response.
response-map-outside-validity = Not valid: { $what }. Some states of { $count } of { $machines } machines reach up to { $value } times the limit.
response-map-outside-validity-unbounded = Not valid: { $what }. It is unbounded for some states of { $count } of { $machines } machines.
