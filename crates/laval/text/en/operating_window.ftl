# Requirements, as they stand in sentences.
operating-window-requirement = { $name ->
        [separation] separation time
        [residence] residence time
        [vibration] vibration
        [self_centred] self-centring of the rotor
        [stable] stability
        [clear] clearance of natural frequencies
        [passage] passage of resonances
        [strength] highest speed
        [valid] validity of the parts
       *[range] the computed range
    }
operating-window-at-jump = { $requirement } at a jump
operating-window-span = { $from } to { $to }

# What binds in a requirement.
operating-window-limited = { $quantity ->
        [displacement] displacement
        [velocity] vibration velocity
        [tilt] tilt
        [force] force
       *[moment] moment
    } of "{ $of }"
operating-window-centre-of-mass = distance of the centre of mass of "{ $body }" from the axis
operating-window-growth-rate = growth rate{ $contents ->
        [before] {" "}before the separation
        [after] {" "}after the separation
       *[always] {""}
    }
operating-window-mode = distance of the mode at { $frequency } from order { $order }
operating-window-swing = distance of the cup swing from order { $order }
operating-window-moved = displacement of "{ $of }" at { $speed }
operating-window-torque = drive torque
operating-window-model = validity of "{ $part }" ({ $statement })
operating-window-path = a particle path cannot be computed ({ $why })
operating-window-without-bound = the amplitude is unbounded at an undamped resonance
operating-window-no-state = no stable steady state exists

# Windows and their ends.
operating-window-window = The machine may run from { $from } to { $value }. Limited below by { $below }, above by { $above }.
operating-window-widest-window = The widest window spans { $value }, from { $from } to { $to }.
operating-window-edge = The window { $side ->
        [begins] begins
       *[ends] ends
    } at { $value }: { $reason }.
operating-window-reason = the { $what } reaches its limit
operating-window-reason-limit = the { $what } reaches its limit, { $limit }
operating-window-reason-undefined = beyond it { $what }
operating-window-reason-jump = beyond it the { $what } jumps to { $factor } times its limit{ $states ->
        [0] {""}
        [1] {""}
       *[other] {" "}in one of { $states } stable states, any of which a slow run-up or run-down can reach
    }{ $fold ->
        [yes] , at a fold
       *[no] {""}
    }
operating-window-reason-jump-undefined = beyond it the { $what } jumps past its limit{ $states ->
        [0] {""}
        [1] {""}
       *[other] {" "}in one of { $states } stable states, any of which a slow run-up or run-down can reach
    }{ $fold ->
        [yes] , at a fold
       *[no] {""}
    }
operating-window-robust-window = Robust window: { $from } to { $value }, for a speed tolerance of { $tolerance }{ $corners ->
        [0] {""}
       *[other] {" "}and all { $corners } corners of the uncertain parameters
    }.
operating-window-no-robust-window = No speed keeps all requirements for a speed tolerance of { $tolerance }{ $corners ->
        [0] {""}
       *[other] {" "}and all { $corners } corners of the uncertain parameters
    }. Reduce the tolerances or relax a limit.
operating-window-incomplete = The study was stopped early. Not computed: { $parts }.
operating-window-missing = { $part ->
        [refinement] the search for narrow interruptions between the computed speeds
        [robust] the robust window
       *[map] the map
    }

# No window.
operating-window-no-window = No computed speed in the range keeps all requirements.
operating-window-unstable = The machine is unstable at every computed speed: its growth rate is at least { $value }. Remove the instability before other limits.
operating-window-growth-margin = No computed speed keeps the growth_margin of { $required }: the lowest growth rate is { $value }{ $damping ->
        [none] , and nothing damps at least one mode
       *[some] {""}
    }. Add damping, or lower growth_margin.
operating-window-excluding = No computed speed keeps both requirements: { $first } and { $second }.
operating-window-lower-throughput = Lowering the throughput to { $share } of its value would open a window at { $speed }.
operating-window-relaxation = Raising { $requirement ->
        [separation] the available time
        [vibration] the binding vibration limit
        [self_centred] the self-centring limit
        [passage] the binding passage limit
       *[strength] the highest speed
    } to { $factor } times its value would open a window at { $speed }.
operating-window-no-relaxation = No single relaxation opens a window: at every computed speed two or more requirements are broken, or one has no margin.

# The recommended speed.
operating-window-best-speed = Recommended speed: { $value }. { $why ->
        [margin] The least margin is largest there
        [next_margin] The least margin ({ $least }) is the same from { $from } to { $to }; the next one ({ $next }) decides
        [throughput] The throughput can be largest there
        [time] The separation is shortest there
        [energy] The energy is lowest there
       *[amplitude] The vibration is smallest there
    }.{ $duty ->
        [throughput] {" "}The throughput can be up to { $throughput }.
        [time] {" "}The separation takes { $time }.
       *[none] {""}
    }
operating-window-binding = The least margin at the recommended speed is { $value }: { $requirement }.
operating-window-binding-detail = The least margin at the recommended speed is { $value }: { $requirement }, { $detail }.
operating-window-not-faster = Above the recommended speed the window ends at { $value }, limited by { $requirement }.
operating-window-field = The centrifugal field at the recommended speed is { $inner } g at the liquid surface and { $value } g at the outer radius.
operating-window-outside-robust = The recommended speed, { $value }, is outside the robust window, { $ranges }. Choose a speed inside it.
operating-window-shortest-time = The shortest separation time with all other requirements kept is { $value }, at { $speed }.
operating-window-shortest-residence = The shortest residence time with all other requirements kept is { $value }, at { $speed }: a throughput of { $throughput }.

# Remarks.
operating-window-tilt-without-limit = No limit applies to the tilt of "{ $body }", up to { $value } at { $speed }. Its displacement is checked at the reference point only: add tilt to [limits].
operating-window-not-checked = Not checked (no limit set): { $requirements }.
operating-window-few-requirements = Only stability limits this window: it is not yet an operating window. Add [limits], or [[cup]] with [suspension].
operating-window-nonlinear = { $policy ->
        [reached] Of several stable branches, the one that the run-up of this file reaches is checked. The window holds for this run-up only
        [highest] Of several stable branches, the one with the largest vibration is checked
       *[all] All stable branches of the nonlinear response are checked: a speed is excluded if one of them exceeds a limit
    }.
operating-window-passage-peak = { $way ->
        [up] Run-up to
       *[down] Run-down from
    } { $top }: the displacement of "{ $body }" reaches { $value } at { $speed }.
operating-window-passage-torque = The run-up requires a drive torque of up to { $value }.
operating-window-braking = Braking as fast as the run-up loads the pellet sideways with { $value } of the centrifugal field.
operating-window-gravity = At { $speed }, the lower end of the window, the field at the innermost liquid is { $value } g. The model neglects gravity, which is valid above { $least } g: separation there is an estimate.
operating-window-run-up-estimate = The run-up counts as { $value } at full speed, estimated by the field at mean radius: the liquid of fixed-angle tubes shifts during the run-up.
