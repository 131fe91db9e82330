# Critical speeds, with the response to unbalance beside them.
critical-speeds-critical-speed = { $order }x critical speed at { $value }: { $whirl }, { $damped ->
        [no] undamped
       *[yes] damping ratio { $damping }
    }.{ $response ->
        [peak] {" "}Response peak at { $peak }: { $body }.
        [unbounded] {" "}The response of { $body } is unbounded there.
        [not_excited] {" "}Unbalance does not excite it in this machine.
        [no_peak] {" "}The unbalance response has no peak there.
       *[none] {""}
    }
critical-speeds-response-peak = The unbalance response peaks at { $value }: { $body } reaches { $amplitude }. No natural frequency equals the speed there.
critical-speeds-response-unbounded = The unbalance response of { $body } is unbounded at { $value }. No natural frequency equals the speed there.
critical-speeds-none = No critical speed was found in this range.
critical-speeds-peaks-alone = No critical speed was found in this range: no natural frequency equals the speed at { $peaks ->
        [one] the response peak
       *[other] the { $peaks } response peaks
    }.
critical-speeds-none-yet = No critical speed was found before the study stopped.

# Distance of the operating speed from the nearest of them.
critical-speeds-margin = Separation margin { $value }, required { $required }: operating speed { $operating }, { $nearest ->
        [peak] nearest response peak
       *[critical_speed] nearest lightly damped { $order }x critical speed
    } { $critical }{ $located ->
        [no] , not located
       *[yes] {""}
    }.{ $search ->
        [stopped] {" "}It is the nearest one found before the study stopped.
       *[complete] {""}
    }{ $excited ->
        [no] {" "}The unbalance of this machine excites no resonance there.
       *[yes] {""}
    }
critical-speeds-small-margin = Separation margin { $value } is below the required { $required }: operating speed { $operating }, { $nearest ->
        [peak] nearest response peak
       *[critical_speed] nearest lightly damped { $order }x critical speed
    } { $critical }{ $located ->
        [no] , not located
       *[yes] {""}
    }. Change the speed, the stiffness or the damping.
critical-speeds-no-margin = The operating speed, { $operating }, is { $nearest ->
        [peak] a peak of the unbalance response
       *[critical_speed] a lightly damped { $order }x critical speed
    }{ $located ->
        [no] , not located
       *[yes] {""}
    }.{ $excited ->
        [no] {" "}The unbalance of this machine excites no resonance there.
       *[yes] {""}
    }
