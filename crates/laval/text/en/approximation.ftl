# The machine beside its approximation with few waves.
approximation-modes = { $met } of { $modes } modes of the approximation, a polynomial of degree { $degree }, { $met ->
        [one] lies
       *[other] lie
    } within { $within } of a root of the whole machine. Largest deviation { $value }, at { $speed }: frequency { $frequency } instead of { $whole_frequency }, growth rate { $growth } instead of { $whole_growth }.
approximation-growth = Largest growth rate of the whole machine { $whole_growth } at { $whole_speed }, of the approximation { $growth } at { $speed }. The difference is { $value }.
