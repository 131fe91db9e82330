# Phrases that several studies share.

list-and = { $rest } and { $last }
list-or = { $rest } or { $last }
# A body, a point of a body, the tilt of a body.
body = "{ $body }"
point = "{ $body }" at { $height }
tilt-of = the tilt of "{ $body }"
# A range of speeds.
range = from { $from } to { $to }
at = at { $at }

# A coefficient table that a study leaves.
beyond-table = The table of "{ $part }" covers { $from } to { $to }. { $sides ->
        [both] Beyond it, down to { $lowest } and up to { $highest },
        [below] Below it, down to { $lowest },
       *[above] Above it, up to { $highest },
    } its coefficients are { $rule ->
        [hold] held at its ends
        [linear] continued along its slope at the ends
       *[refuse] unknown
    }.
beyond-table-note = Outside the table of "{ $part }".
beyond-table-frequency = The table of "{ $part }" covers frequencies of vibration from { $from } to { $to }. { $sides ->
        [both] Beyond it, down to { $lowest } and up to { $highest },
        [below] Below it, down to { $lowest },
       *[above] Above it, up to { $highest },
    } its coefficients are { $rule ->
        [hold] held at its ends
        [linear] continued along its slope at the ends
       *[refuse] unknown
    }.
over-frequency-beyond = { $n ->
        [one] The frequency of mode { $modes } lies
       *[other] The frequencies of modes { $modes } lie
    } outside the table of "{ $part }", which covers { $from } to { $to }: not valid there.
over-frequency-growth-unassessed = Stability is not assessed: { $n ->
        [one] { $parts } has
       *[other] { $parts } have
    } the coefficients of the excitation here. Use modes or campbell, where every mode has those of its own frequency.
over-frequency-counted = { $n ->
        [one] { $parts } has
       *[other] { $parts } have
    } in each mode the coefficients of its own frequency. { $speeds ->
        [one] No mode
       *[other] At { $speeds } speeds no mode
    } from { $from } to { $to } is missing by the count.
over-frequency-not-counted = { $speeds ->
        [one] Modes may be missing
       *[other] At { $open } of { $speeds } speeds modes may be missing
    } from { $from } to { $to }: with the coefficients of { $n ->
        [one] { $parts }
       *[other] the parts { $parts }
    } at the own frequency the count differs from the modes found. A narrower table or more rows ease the search.
over-frequency-outside = Modes { $sides ->
        [both] below { $from } and above { $to } are not computed: the table or frequency_limit ends there
        [below] below { $from } are not computed: the table begins there
       *[above] above { $to } are not computed: the table or frequency_limit ends there
    }. Growth there is not known.

# Nothing excites the machine.
unforced = The machine has no excitation: the largest displacement is { $value }, and no resonance is reported. Give a disc an eccentricity, an unbalance or a skew.

# Linear studies: what they are linearised about.
support-linearised = { $n ->
        [one] The nonlinear part { $parts } is
       *[other] The nonlinear parts { $parts } are
    } linearised about the { $state ->
        [undeflected] undeflected state
       *[deflected] equilibrium under load
    }. Results hold for small vibration.
support-fitted-part = Initial eigenvalues come from a rational fit of "{ $part }"; they are refined with its exact impedance.
support-open-gap = The gap of "{ $part }" is open at equilibrium and adds no stiffness. Contact begins at a relative displacement above { $value }.
support-outside = "{ $part }" is outside its validity at { $speed }, even without vibration: { $what } = { $value } (limit 1).
support-outside-unbounded = "{ $part }" is outside its validity at { $speed }, even without vibration: { $what } is unbounded (limit 1).

# Motions outside the validity of a part.
validity-states = Not valid: some states { $place } are outside the range of "{ $part }" ({ $what } = { $value }, limit 1).
validity-states-unbounded = Not valid: some states { $place } are outside the range of "{ $part }" ({ $what } is unbounded, limit 1).
validity-motions = Not valid: some { $motions } are outside the range of "{ $part }" ({ $what } = { $value }, limit 1).
validity-motions-unbounded = Not valid: some { $motions } are outside the range of "{ $part }" ({ $what } is unbounded, limit 1).

# Count of roots by the argument principle.
region-growing-root = growing root
region-faster-root = root growing faster than { $growth }
region-all-roots = Root count verified (argument principle): no { $root } below { $frequency } is missing. { $found ->
        [0] The counted regions contain no root
        [1] The only root in the counted regions is known
       *[other] All { $found } roots in the counted regions are known
    }.
region-at-zero = { $count ->
        [one] One root lies
       *[other] { $count } roots lie
    } at zero or close to it: motions of the whole machine or of a part that nothing holds. They are not among the modes.
region-all-modes = { $found ->
        [0] The machine has no mode below { $frequency }
        [1] The only mode below { $frequency } is computed
       *[other] All { $found } modes below { $frequency } are computed
    }, none is missing (roots counted by the argument principle). Modes above are not computed: the machine has { $states } states. frequency_limit sets the limit.
region-modes-followed = All modes below { $frequency } are followed: their number was verified at { $speeds } of { $all } speeds (argument principle). Modes above are not computed; frequency_limit sets the limit.
region-modes-not-counted = Modes below { $frequency } may be missing: their count failed at { $open } of the speeds where it was tried. Try another frequency_limit.
region-slower-roots-missed = Root count verified (argument principle): no { $root } below { $frequency } is missing. Slow waves of { $part } add { $missing ->
        [one] one root that is counted but not computed
       *[other] { $missing } roots that are counted but not computed
    }.
region-roots-missed = Stability is not proven: { $missing ->
        [one] one counted root was not found, and it
       *[other] { $missing } counted roots were not found, and one of them
    } may be a { $root }. Lower frequency_limit, or set growth_threshold above 0.
region-roots-not-counted = { $proven ->
        [yes] No { $root } below { $frequency } is missing, but slower roots may be
       *[no] Stability is not proven, and roots may be missing
    }: the count failed in { $open } of { $all } regions. Try another frequency_limit.
region-uncounted-roots = { $outside } of { $all } roots lie outside the counted regions. Other roots may be missing beside them.
region-dense-range = At { $speed } { $waves } of { $part } form a continuous spectrum at forward frequencies from { $from } to { $to }. Damping elsewhere makes some of them grow slowly, so that only growth above a threshold means instability. Slower growth depends on { $loss }, which the model lacks.
region-half-plane = Only growing roots are counted. Decaying roots of a machine with { $part } are searched for; one that hardly shows in the response may be missing.
region-accumulation = Roots from { $from } to { $to } with growth or decay below { $growth } are not counted: at { $speed } waves accumulate there.
region-other-orders = { $n } { $n ->
        [one] other
       *[other] others
    }
region-orders-without-response = { $n ->
        [one] Order { $orders } of the response lies
       *[other] Orders { $orders } of the response lie
    } in the continuous spectrum of { $waves }, from { $from } to { $to } at { $value }. There { $part } has no steady response, and the equations have no solution. { $remedy }.
region-orders-of-kept-waves = { $n ->
        [one] Order { $orders } of the response lies
       *[other] Orders { $orders } of the response lie
    } in the continuous spectrum of { $waves }, from { $from } to { $to } at { $value }. There { $part } has no steady response; { $kept }.

# A study that ended early, or did not begin.
watch-nothing-shown = No result: the study was stopped within a computation that has no partial result.
store-incomplete = Only { $done } of { $requested } { $rows } were computed.
store-incomplete-kept = Only { $done } of { $requested } { $rows } were computed. The same command continues from there.
run-refused = { $reason }
run-refused-alike = The study is refused for the same reason as "{ $study }".

# Vessels that the dynamics lack.
cups-not-carried = The dynamics lack the mass and the unbalance of "{ $vessel }": no body carries it. Add on = "{ $body }", with mass and centre_of_mass.
cups-not-carried-by-any = The dynamics lack the mass and the unbalance of "{ $vessel }": no body carries it. Add the body as on, with mass and centre_of_mass.
cups-bowl-without-liquid = The dynamics lack the liquid in "{ $vessel }". Add a [[part]] with kind = "liquid" in the body of the bowl, or add the mass to that body.
