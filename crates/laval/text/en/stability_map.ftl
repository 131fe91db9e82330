# The largest growth rate.
stability-map-largest-growth = The machine is unstable: largest growth rate { $value } at { $speed }, { $motion ->
        [divergence] static instability (divergence)
       *[whirl] whirl at { $frequency }
    }.
stability-map-largest-growth-of-map = Largest growth rate in the map: { $value } at { $speed } and { $parameter } = { $setting }, { $motion ->
        [divergence] static instability (divergence)
       *[whirl] whirl at { $frequency }
    }.
stability-map-stable = No mode grows { $threshold ->
        [zero] at any point
       *[set] faster than { $limit } at any point
    } { $computed ->
        [stopped] computed before the study stopped
       *[all] computed
    }: the largest growth rate is { $value }.
stability-map-marginal = No mode grows { $threshold ->
        [zero] at any point
       *[set] faster than { $limit } at any point
    } { $computed ->
        [stopped] computed before the study stopped
       *[all] computed
    }: the largest growth rate is zero.
stability-map-stable-counted = No mode grows { $threshold ->
        [zero] at any point
       *[set] faster than { $limit } at any point
    } { $computed ->
        [stopped] computed before the study stopped
       *[all] computed
    }.
stability-map-stability-unknown = Stability is not proven: no mode was found that grows{ $threshold ->
        [zero] {""}
       *[set] {" "}faster than { $limit }
    }, but some may be missing at { $open } of { $points } points. A lower frequency_limit or a higher growth_threshold eases the search.

# Ranges of speed in which the machine is unstable.
stability-map-unstable-range = Unstable from { $value } { $end ->
        [range] to the end of the range
        [stopped] to { $to }, where the study stopped
       *[boundary] to { $to }
    }{ $threshold ->
        [zero] {""}
       *[set] : growth rate above { $limit }
    }.
stability-map-unstable-from-start = Unstable from the start of the range, { $value }, { $end ->
        [range] to its end, { $to }
        [stopped] to { $to }, where the study stopped
       *[boundary] to { $to }
    }{ $threshold ->
        [zero] {""}
       *[set] : growth rate above { $limit }
    }.
stability-map-unstable-range-not-located = Unstable from a speed between { $low } and { $high } { $end ->
        [range] to the end of the range
        [stopped] to { $to }, where the study stopped
       *[boundary] to { $to }
    }{ $threshold ->
        [zero] {""}
       *[set] : growth rate above { $limit }
    }. The boundary was not located; use more points there.

# How far the growth rates are known.
stability-map-all-counted = Root count verified at { $points ->
        [one] the point
       *[other] all { $points } points
    } by the argument principle, up to { $frequency }: no { $threshold ->
        [zero] growing root
       *[set] root growing faster than { $limit }
    } is missing.
stability-map-not-all-counted = { $threshold ->
        [zero] Growing roots
       *[set] Roots growing faster than { $limit }
    } may be missing at { $open } of { $points } points. A lower frequency_limit or a higher growth_threshold eases the count.
stability-map-threshold-raised = Growth below { $value } is not resolved for waves of { $part }, which grow slowly with any damping elsewhere. The threshold is raised from { $requested }.
stability-map-undamped = { $machines ->
        [some] Part of the map
       *[all] The machine
    } has no damping: { $boundaries ->
        [none] where no mode grows, none decays
        [double] stability boundaries were located as double roots
       *[some] { $double } of { $edges } stability boundaries were located as double roots, the others bracketed
    }.
