# Modes that grow.
modes-unstable-mode = Mode { $mode } is unstable: { $whirl ->
        [none] static instability (divergence)
        [forward] forward whirl at { $frequency }
        [backward] backward whirl at { $frequency }
       *[vibration] vibration at { $frequency }
    }, growth rate { $value }.
modes-threshold = Modes count as unstable above a growth rate of { $value }. Slower waves of { $part } are not all computed.

# The mode that decays most slowly.
modes-least-damped = { $among ->
        [found] Least damped of the decaying modes found
        [decaying] Least damped of the decaying modes
        [stable] Least damped stable mode
       *[all] Least damped mode
    }{ $near ->
        [yes] {" "}up to ten times the spin speed
       *[no] {""}
    }: mode { $mode }, { $whirl } at { $frequency }, { $damped ->
        [no] undamped
       *[yes] damping ratio { $value }, logarithmic decrement { $decrement }
    }.

# Whether the machine is stable.
modes-stable = Stable at { $speed }: the largest growth rate is { $value }{ $threshold ->
        [zero] {""}
       *[set] , the limit { $limit }
    }.
modes-stable-below = Stable at { $speed }, as far as modes below { $frequency } tell: the largest growth rate is { $value }.
modes-stable-between = Stable at { $speed }, as far as modes from { $from } to { $to } tell: the largest growth rate is { $value }.
modes-stable-found = Stable at { $speed }: no mode grows. The largest growth rate found is { $value }; a mode that decays more slowly may be missing.
modes-below-threshold = No mode grows faster than { $limit } at { $speed }: the largest growth rate is { $value }.
modes-below-threshold-found = No mode grows faster than { $limit } at { $speed }. The largest growth rate found is { $value }; a mode that grows or decays more slowly may be missing.
modes-marginal = Marginally stable at { $speed }: { $lacks ->
        [stiffness] no stiffness holds the machine
       *[damping] the least damped mode has zero damping
    }.
modes-slow-growth = No mode grows faster than { $limit } at { $speed }, but { $slower ->
        [one] mode { $mode } grows more slowly
       *[other] { $slower } modes grow more slowly
    }. Slow growth of waves of { $part } is not resolved; stability is not proven.
modes-slow-growth-open = No mode grows faster than { $limit } at { $speed }. Slow growth of waves of { $part } is not resolved; stability is not proven.
modes-stability-unknown = Stability at { $speed } is not proven: no mode was found that grows{ $threshold ->
        [zero] {""}
       *[set] {" "}faster than { $limit }
    }, but some may be missing. A lower frequency_limit or a higher growth_threshold eases the search.

# How the modes were computed.
modes-massless = { $infinite ->
        [one] 1 eigenvalue is infinite
       *[other] { $infinite } eigenvalues are infinite
    }: some coordinates have no mass.
modes-polished = { $modes ->
        [one] The mode was solved
       *[other] All { $modes } modes were solved
    } on the exact characteristic function.
modes-not-all-polished = { $polished } of { $modes } modes were solved on the exact characteristic function. The others are less accurate.
modes-all-roots = No growing mode is missing: the argument principle counts { $growing ->
        [0] no growing root
        [1] one growing root
       *[other] { $growing } growing roots
    }, as many as were found. All modes are roots of the exact characteristic function.
modes-roots-missed = The argument principle counts { $growing ->
        [0] no growing root
        [1] one growing root
       *[other] { $growing } growing roots
    }, but { $found ->
        [0] none was
        [1] one was
       *[other] { $found } were
    } found. { $outcome ->
        [incomplete] The machine is unstable, and growing modes are missing from the list.
        [doubtful] The machine is unstable, but some of the growing modes are doubtful.
       *[stable] The growing modes are doubtful.
    }
modes-roots-not-counted = { $unstable ->
        [yes] Further unstable modes
       *[no] Unstable modes
    } may be missing: the count of growing roots failed. All modes listed are roots of the exact characteristic function.
