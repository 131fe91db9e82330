# What the studies in time share.

# The last moment of a record, within a sentence.
history-end = at the end
history-stop = at { $at }, where the integration stopped

# Displacements.
history-largest = The largest { $quality ->
        [tilt] tilt
       *[displacement] displacement
    } of "{ $body }" from equilibrium is { $value }.
history-at-equilibrium = "{ $body }" stays at equilibrium, within the tolerance of the integration.
history-only-tilts = "{ $body }" tilts, but its displacement stays at equilibrium within the tolerance of the integration.
history-unresolved = "{ $body }" moves from equilibrium by at most { $value }, which the integration cannot distinguish from none at this tolerance: lower relative_tolerance.

# A motion that passes every bound.
history-unbounded = The motion of "{ $body }" diverges at { $speed }: it is { $displacement } from equilibrium at { $at }, where the integration ended. Avoid this speed or add damping.
history-unbounded-exponential = The motion of "{ $body }" diverges at { $speed } with a growth rate of { $value }: it is { $displacement } from equilibrium at { $at }, where the integration ended. Avoid this speed or add damping.
history-unbounded-linear = The motion of "{ $body }" diverges at { $speed }, linearly in time by { $value }: it is { $displacement } from equilibrium at { $at }, where the integration ended. Avoid this speed or add damping.

# An integration that ended early.
history-work-limit = The limit on steps, --work-limit, was reached at { $value }. Raise it to compute the rest.
history-step-too-small = The integration stopped at { $value }, because no step meets the tolerance. The motion may diverge there; try another method or a larger relative_tolerance.
history-integration-failed = The integration stopped at { $value }: { $why }. The motion after that is missing.

# Rational forms of parts in time.
history-reduced = The linear parts of the machine were reduced to { $coordinates } coordinates. Up to { $frequency } their receptance where other parts are attached differs by { $value } from that of the whole machine.
history-time-form = A rational form with { $states ->
        [one] one state
       *[other] { $states } states
    } replaces "{ $part }" in time. Its relative error is at most { $value }, { $scope }.
history-time-fit = A rational fit replaces the frequency response of "{ $part }" in time. Its relative error is { $value }.

# Validity of parts along the motion.
history-valid = "{ $part }" is within validity: { $what } ≤ { $value } (limit 1).
history-valid-after-start = "{ $part }" is within validity { $above ->
        [standstill] once the rotor turns
       *[speed] above { $speed }
    }: { $what } ≤ { $value } (limit 1).
history-valid-while-turning = "{ $part }" is within validity { $above ->
        [standstill] while the rotor turns
       *[speed] above { $speed }
    }: { $what } ≤ 1.
history-valid-later = "{ $part }" is not valid before { $value }, when the speed is { $speed }: { $what } exceeds 1. Do not use the motion before that time.
history-not-valid = Validity exceeded for "{ $part }": { $what } = { $value } (limit 1). The motion is not valid from { $first } on.
history-not-valid-unbounded = Validity exceeded for "{ $part }": { $what } is unbounded (limit 1). The motion is not valid from { $first } on.

# Contacts and gaps.
history-contacts = Force laws with a switch changed side { $count ->
        [one] once
       *[other] { $count } times
    }; every switch was located in time.

# Energy balance.
history-energy-closes = The energy balance closes to { $value } of the energy exchanged.
history-energy-closes-to-rounding = The energy balance closes to rounding, { $value } of the energy stored or exchanged.
history-energy-missing = The energy balance misses { $value } of the energy exchanged. Use a smaller relative_tolerance.
history-energy-out-of-range = No energy balance: the energies exceed the range of numbers. It does not confirm this motion; look for divergence.
history-energy-unknown = No energy balance: "{ $part }" does not provide its energy.
