# The mode that grows most.
campbell-unstable = Mode { $mode } is unstable: { $whirl ->
        [none] static instability (divergence)
        [forward] forward whirl at { $frequency }
        [backward] backward whirl at { $frequency }
       *[vibration] vibration at { $frequency }
    }, growth rate up to { $value }, at { $speed }.

# Critical speeds.
campbell-critical-speed = { $order }x critical speed at { $value }: { $whirl }, { $damped ->
        [no] undamped
       *[yes] damping ratio { $damping }
    }.
campbell-critical-speed-not-located = A { $order }x critical speed lies between { $value } and { $to }, but was not located. Use more points there.
campbell-no-critical-speed = No critical speed was found in this range.
campbell-no-critical-speed-yet = No critical speed was found before the study stopped.

# How far the modes are known.
campbell-ambiguous = Mode tracking is ambiguous at { $steps ->
        [one] 1 step
       *[other] { $steps } steps
    } of the speed, first between { $value } and { $to }. Modes may be exchanged there; use more points.
campbell-slow-roots = Critical speeds of slow waves may be missing: not all roots near the imaginary axis are followed. Compare with the resonances of forced_response.
