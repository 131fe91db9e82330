# At one speed.
forced-response-amplitude = At { $speed } the amplitude of { $body } is { $value }.
forced-response-tilt = The tilt of "{ $body }" at { $speed } is { $value }.

# Resonances.
forced-response-largest-resonance = The largest { $others ->
        [unbounded] bounded resonance
       *[none] resonance
    } is at { $value }: { $body } reaches { $amplitude }.{ $search ->
        [stopped] {" "}It is the largest one found before the study stopped.
       *[complete] {""}
    }
forced-response-largest-tilt-resonance = The largest { $others ->
        [unbounded] bounded tilt resonance
       *[none] tilt resonance
    } is at { $value }: { $body } reaches { $amplitude }.{ $search ->
        [stopped] {" "}It is the largest one found before the study stopped.
       *[complete] {""}
    }
forced-response-undamped-resonance = Undamped resonance at { $value }: the amplitude of { $body } is unbounded. Add damping or avoid this speed.
forced-response-other-undamped-resonance = Undamped resonance at { $value }: the amplitude is unbounded. Add damping or avoid this speed.
forced-response-no-resonance = No body has a resonance in this range.
forced-response-no-resonance-known = No resonance was found where the response is known.
forced-response-no-resonance-yet = No resonance was found before the study stopped.

# How far the response is known and valid.
forced-response-frequency-only = Resonances narrower than the speed step, { $step }, may be missing, and stability was not assessed: a part is given in the frequency domain only.
forced-response-unknown = The response is not known at { $unknown } of { $speeds } speeds, first at { $value }: a part has no accurate reaction there.
forced-response-gap-closes = The vibration closes the gap of "{ $part }", { $gap } at equilibrium, { $speeds ->
        [one] at { $value }
       *[several] at speeds from { $value } to { $last }
    }. Contact is neglected, so that the amplitudes are not valid there: use nonlinear_response.
forced-response-validity = Not valid: the response is outside the range of "{ $part }" at { $speed }, { $what } = { $value } (limit 1).
forced-response-validity-unbounded = Not valid: the response is outside the range of "{ $part }" at { $speed }, { $what } is unbounded (limit 1).
