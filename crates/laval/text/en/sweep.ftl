# How the response began: at every speed anew, or from the response at the speed before.
sweep-from-start = from the initial condition
sweep-run-up = in the run-up
sweep-run-down = in the run-down

# Largest displacement or tilt.
sweep-largest = The largest { $quality ->
        [tilt] value
       *[displacement] displacement
    } of { $point } is { $value } at { $speed }, reached { $start }.
sweep-largest-recorded = The largest recorded { $quality ->
        [tilt] value
       *[displacement] displacement
    } of { $point } is { $value } at { $speed }, reached { $start }. The response does not repeat there and may become larger.

# Jumps and hysteresis. Run-up and run-down are quasi-static.
sweep-jump = In the quasi-static { $way ->
        [up] run-up
       *[down] run-down
    } { $point } jumps from { $before } to { $after }, between { $from } and { $to }.
sweep-start-jump = Started anew at each speed, { $point } changes from { $before } to { $after } between { $from } and { $to }. The initial condition crosses a basin boundary there. This differs from the fold that nonlinear_response reports; start = "up_and_down" gives the jumps of a slow run.
sweep-no-jump = The quasi-static { $way ->
        [up] run-up
       *[down] run-down
    } from { $from } to { $to } has no jump between its { $speeds } speeds.
sweep-joins = The quasi-static { $way ->
        [up] run-up reaches the branch of the run-down
       *[down] run-down reaches the branch of the run-up
    } between { $from } and { $to }. It jumps or changes steeply there; more points of the range show which.
sweep-hysteresis = Hysteresis from { $from } to { $to }, over { $value }: the response depends on the direction of the run.
sweep-hysteresis-at = Hysteresis at { $speed }, at one computed speed only: the response depends on the direction of the run. More points of the range give the width.

# Responses that repeat after several revolutions, do not repeat, or have not settled.
sweep-longer-period = Subharmonic response of order 1/{ $turns } { $place } { $start }: it repeats after { $turns } revolutions.
sweep-not-periodic = The response does not repeat within { $turns } revolutions { $place } { $start }{ $count ->
        [one] {""}
       *[other] , at { $count } speeds
    }. It is quasi-periodic, chaotic or of a longer period, and amplitudes are the largest recorded. Set lyapunov = true to distinguish chaos.
sweep-not-settled = The response does not repeat within the tolerance { $place } { $start }{ $count ->
        [one] {""}
       *[other] , at { $count } speeds
    }, although several decay times of the slowest mode have passed. It changes slowly beside a fold, or the integration error is too large. Reduce relative_tolerance.
sweep-not-settled-bounded = The response still changes { $place } { $start }{ $count ->
        [one] {""}
       *[other] , at { $count } speeds
    }: most_periods ended its settling. Amplitudes there may contain transients; raise most_periods.
sweep-settling-bounded = At { $count } of { $speeds } speeds { $start }, most_periods ended the settling before the slowest mode had decayed. The response repeats there within the tolerance.
sweep-no-decay = At { $count } of { $speeds } speeds a mode about equilibrium does not decay. Transients may remain in the results there, jumps and hysteresis included. Add damping, or confirm them with a larger most_periods.
sweep-failed-motions = The integration failed for { $count } of { $motions } responses, the first at { $first }: each { $reason }. A run starts anew from the initial condition after it, so that jumps beside it may be missing.

# Largest Lyapunov exponent.
sweep-chaos = { $count ->
        [one] One response is chaotic
       *[other] { $count } responses are chaotic
    }: the largest Lyapunov exponent is { $value }, at { $speed }. No amplitude is repeatable there; add damping or pass quickly.
sweep-no-chaos = No chaotic response was found: no Lyapunov exponent is clearly positive.
