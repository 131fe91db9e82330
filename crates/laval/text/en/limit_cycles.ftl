# Self-excited whirl over the spin speed.

limit-cycles-no-edge-unstable = The equilibrium is unstable at all { $speeds } speeds from { $from } to { $to }, growth rate up to { $value }. No limit cycle begins in the range; widen it, or add damping{ $damping ->
        [none] {""}
       *[other] {" "}{ $damping }
    }.
limit-cycles-no-edge = The equilibrium is stable at all { $speeds } speeds from { $from } to { $to }: no self-excited whirl begins. Large whirls that a disturbance starts are not excluded.
limit-cycles-onset = With rising speed the equilibrium becomes { $edge ->
        [onset] unstable
       *[end] stable
    } at { $value }: { $whirl ->
        [forward] forward whirl
        [backward] backward whirl
        [mixed] mixed whirl
       *[none] vibration
    } at { $frequency }.
limit-cycles-hard = Subcritical (hard) onset: an unstable limit cycle surrounds the stable equilibrium at { $side ->
        [higher] higher
       *[lower] lower
    } speeds. Larger disturbances grow; keep them small there, or add damping.
limit-cycles-soft = Supercritical (soft) onset: a small limit cycle grows towards { $side ->
        [higher] higher
       *[lower] lower
    } speeds.
limit-cycles-onset-left = No limit cycle was followed from here: { $why }.
limit-cycles-onset-stopped = No limit cycle was followed from here before the study stopped.
limit-cycles-onset-not-found = No limit cycle was found here.
limit-cycles-bistable = Bistable from { $from } to { $to }: the equilibrium and a whirl of up to { $value } are both stable. Which one occurs depends on the history; avoid large disturbances there.
limit-cycles-bistable-invalid = Bistable from { $from } to { $to }: a whirl is stable beside the stable equilibrium. Its size is not valid: { $value } is outside the range of a part. Avoid large disturbances there.
limit-cycles-largest = The largest stable limit cycle of family { $family } has a { $quality ->
        [tilt] tilt
       *[displacement] displacement
    } of { $value } of { $body }, at { $speed } with whirl frequency { $frequency }.
limit-cycles-largest-invalid = Not valid: the largest stable limit cycle of family { $family } is outside the range of a part. The { $quality ->
        [tilt] tilt
       *[displacement] displacement
    } of { $value } of { $body }, computed at { $speed } with whirl frequency { $frequency }, is no result.
limit-cycles-largest-valid = Inside the range of all parts, it reaches { $size }, at { $speed }.
limit-cycles-all-unstable = All limit cycles of family { $family } are unstable; none of them persists.
limit-cycles-fold = The limit cycles of family { $family } fold at { $value }; this whirl does not exist beyond.
limit-cycles-unbounded = Near { $value } this whirl grows without bound: the nonlinear parts hardly deflect in it and cannot limit it. Avoid these speeds, or add damping.
limit-cycles-family-unfinished = The limit cycles of family { $family } were followed only to { $value }. { $why }
limit-cycles-stability-unknown = The stability of the limit cycles was not assessed: { $why }. They may be unstable.
