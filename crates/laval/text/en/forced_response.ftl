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

# Separation margins.
forced-response-margin-kept = Separation margins kept (API 684, SP6.8.2.10). The resonance at { $resonance } keeps least: { $value } from { $operating }, { $required } required ({ $body }, { $damped ->
        [yes] amplification factor { $factor }
        [unknown] amplification factor not known
       *[no] undamped
    }).
forced-response-margin-broken = Separation margin too small (API 684, SP6.8.2.10): the resonance at { $resonance } { $side ->
        [among] lies among the operating speeds
       *[other] is { $value } from { $operating }
    }, { $required } required ({ $body }, { $damped ->
        [yes] amplification factor { $factor }
       *[no] undamped
    }).
forced-response-margin-none = No resonance in this range requires a separation margin (API 684, SP6.8.2.10): none has an amplification factor of 2.5 or more.{ $bounded ->
        [yes] {" "}The response stays above 0.707 of a peak up to an end of the range: its factor is at most { $most }.
       *[no] {""}
    }
forced-response-margin-unknown = { $reason ->
        [stopped] Separation margins are not decided (API 684, SP6.8.2.10): the study was stopped.
        [range] Separation margins are not decided (API 684, SP6.8.2.10): the half-power points of the resonance at { $resonance } lie outside the range, so that its amplification factor is not known. It is { $value } from the operating speeds; up to { $required } may be required. Extend the range.
       *[neighbour] Separation margins are not decided (API 684, SP6.8.2.10): a higher resonance beside that at { $resonance } covers its half-power points, so that its amplification factor is not known. It is { $value } from the operating speeds; up to { $required } may be required.
    }
forced-response-spin = The unbalance of what turns with "{ $spin }" acts here, and speeds are those of this spin.
forced-response-other-spins = The unbalance of what turns with { $spins } acts at another frequency and is left out here: give spin in a study of its own.

forced-response-shaft-vibration = { $part } vibrates { $value } peak to peak at { $speed }: { $standard ->
        [api_617] within the limit of { $limit } (API 617)
       *[iso_7919_3] zone { $zone } of ISO 7919-3; unrestricted operation reaches up to { $limit }
    }.
forced-response-shaft-vibration-broken = { $part } vibrates { $value } peak to peak at { $speed }, above { $limit } ({ $standard ->
        [api_617] API 617
       *[iso_7919_3] ISO 7919-3, zone { $zone }
    }). Balance the rotor finer, add damping, or move the resonance.
forced-response-shaft-vibration-outside = The standard of shaft vibration does not cover { $speed }.
forced-response-boundary = { $line ->
        [zone_ab] zones A/B
        [zone_bc] zones B/C
        [zone_cd] zones C/D
       *[api_limit] API 617
    }
