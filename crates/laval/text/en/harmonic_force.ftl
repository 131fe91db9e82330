# Response to a harmonic force.
harmonic-force-largest = The largest resonance is at { $value }: { $body } reaches { $amplitude }{ $known ->
        [yes] , amplification factor { $factor }
       *[no] {""}
    }.
harmonic-force-unbounded = Undamped resonance at { $value }: the amplitude of { $body } is unbounded.
harmonic-force-singular = Undamped resonance at { $value }: the amplitude is unbounded.
harmonic-force-none = No body has a resonance in this range of the { $over ->
        [speed] speed
       *[frequency] frequency
    }.
harmonic-force-amplitude = At { $speed } the amplitude of { $body } is { $value }.
harmonic-force-frequency-only = Resonances narrower than the step may be missing, and stability was not assessed: a part is given in the frequency domain only.
harmonic-force-margin-kept = Separation margins kept (API 684, SP6.8.2.10). The resonance at { $resonance } keeps least: { $value }, { $required } required { $known ->
        [yes] with its amplification factor of { $factor }
       *[no] whatever its amplification factor, which is not known
    }.
harmonic-force-margin-broken = Separation margin too small (API 684, SP6.8.2.10): the resonance at { $resonance } keeps { $value }, { $required } required with its amplification factor of { $factor }.
harmonic-force-gap-closes = The vibration closes the gap of "{ $part }", { $gap } at equilibrium, from { $value } to { $last }. Contact is neglected, so that the amplitudes are not valid there.
harmonic-force-validity = Not valid: the response is outside the range of "{ $part }" at { $place }, { $what } = { $value } (limit 1).
harmonic-force-validity-unbounded = Not valid: the response is outside the range of "{ $part }" at { $place }, { $what } is unbounded (limit 1).

harmonic-force-alt = Amplitudes of all points under a harmonic force, with { $peaks ->
        [0] no resonance
        [one] one resonance
       *[other] { $peaks } resonances
    }.
