# The parameter of most influence.
sensitivity-influence = changes most with { $parameter }: it { $direction ->
        [falls] falls
       *[rises] rises
    } by { $change } for 1 % more
sensitivity-influence-unknown = changes by an unknown share

# Peaks and folds of the steady-state response.
sensitivity-peak = The peak of { $point }, { $value } at { $speed }, { $size-influence }. Its speed { $speed-influence }.
sensitivity-jump = The speed of the { $way ->
        [up] upward
       *[down] downward
    } jump, { $speed }, { $speed-influence }. The { $quality ->
        [tilt] value
       *[displacement] displacement
    } of { $point } there, { $value }, { $size-influence }.
sensitivity-nothing-stationary = No peak and no fold of the response was found { $end ->
        [stopped] before the study stopped
       *[complete] in the speed range
    }.

# Places and parameters without an influence.
sensitivity-no-derivative-corner = No sensitivity is given at { $value }{ $more ->
        [0] {""}
        [one] {" "}and at one more place, up to { $highest }
       *[other] {" "}and at { $more } more places, up to { $highest }
    }: the branch turns at a corner, where a force law switches. Vary the parameters there by hand or with uncertainty.
sensitivity-no-derivative-jump = No sensitivity is given at { $value }{ $more ->
        [0] {""}
        [one] {" "}and at one more place, up to { $highest }
       *[other] {" "}and at { $more } more places, up to { $highest }
    }: the force of "{ $part }" jumps. Vary the parameters there by hand or with uncertainty.
sensitivity-no-derivative-open = No sensitivity is given at { $value }{ $more ->
        [0] {""}
        [one] {" "}and at one more place, up to { $highest }
       *[other] {" "}and at { $more } more places, up to { $highest }
    }: the derivatives did not converge. Vary the parameters there by hand or with uncertainty.
sensitivity-no-influence = The influence of { $parameters } is unknown at some places, where the tables list it last.
sensitivity-without-influence = No influence on the listed peaks and folds: { $parameters }.
