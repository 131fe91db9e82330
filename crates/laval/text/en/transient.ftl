# Motion in time.

transient-still-growing = The { $quality ->
        [tilt] tilt
       *[displacement] displacement
    } of "{ $body }" from equilibrium still grows { $when }. So far its largest value is { $value }.
transient-end-state = "{ $body }" is { $value } from equilibrium { $when }.
transient-end-speed = The spin speed is { $value } { $when }.

# Growth, from the second half of the envelope.
transient-grows = The amplitude of { $body } grows: growth rate { $value } in the second half of the record. Avoid this speed or add damping.
transient-decays = The amplitude of { $body } decays: growth rate { $value } in the second half of the record.
transient-steady = The amplitude of { $body } neither grows nor decays significantly in the second half of the record: growth rate { $value } ± { $uncertainty }.
transient-grows-linearly = The amplitude of { $body } grows linearly in time, by { $value }, in the second half of the record. Avoid this speed or add damping.
transient-decreases-linearly = The amplitude of { $body } decreases linearly in time, by { $value }, in the second half of the record.
transient-grows-ever-more-slowly = The amplitude of { $body } grows more slowly than exponentially: in the second half of the record its relative rate falls from { $first } to { $value }. A longer duration shows whether it stops.
transient-windows-too-long = Growth is not assessed: one window of the envelope, { $value }, holds several turns of the record. Give a shorter duration.
transient-too-short = Growth is not assessed: the record holds too few turns of the displacement. Give a longer duration.
