# Stability over a cross-coupled stiffness.
stability-threshold-threshold = { $damped ->
        [no] Any cross-coupled stiffness at { $place } makes the machine unstable at { $speed }: mode { $mode }, { $whirl } at { $frequency }, is undamped.
       *[yes] A cross-coupled stiffness of { $value } at { $place } makes the machine unstable at { $speed }: mode { $mode }, { $whirl } at { $frequency }.
    }
stability-threshold-none = The machine stays stable at { $speed } up to a cross-coupled stiffness of { $value } at { $place }.
stability-threshold-unknown = No threshold was found at { $speed } up to a cross-coupled stiffness of { $value } at { $place }; stability up to there is not proven.
stability-threshold-base = Without cross-coupled stiffness the least logarithmic decrement of the modes that are followed is, at { $speed }, { $value }: mode { $mode }, { $whirl } at { $frequency }.
stability-threshold-unstable-without = The machine is unstable at { $speed } without cross-coupled stiffness: mode { $mode }, { $whirl } at { $frequency }, logarithmic decrement { $value }.
stability-threshold-level-1 = Level 1 passed (API 684, SP6.8.5.10): logarithmic decrement { $value } of the first forward mode, mode { $mode }, with the anticipated { $anticipated }, at least { $least_decrement } required; threshold { $reached ->
        [yes] { $ratio }
       *[no] more than { $ratio }
    } times the anticipated stiffness, at least { $least_ratio } required.{ $density ->
        [yes] {" "}Below a ratio of 10 the criterion of gas density and speed ratio counts as well; it is not assessed.
        [region] {" "}{ $region } All three criteria are met.
       *[no] {""}
    }
stability-threshold-level-2 = Level 2 analysis required (API 684, SP6.8.5.10): logarithmic decrement { $value } of the first forward mode, mode { $mode }, with the anticipated { $anticipated }, at least { $least_decrement } required; threshold { $reached ->
        [yes] { $ratio }
       *[no] more than { $ratio }
    } times the anticipated stiffness, at least { $least_ratio } required.{ $density ->
        [region] {" "}{ $region }
       *[other] {""}
    }
stability-threshold-level-open = Level 1 is not decided (API 684, SP6.8.5.10): logarithmic decrement { $value } of the first forward mode, mode { $mode }, with the anticipated { $anticipated }; { $reached ->
        [yes] threshold { $ratio } times that.
        [uncounted] the modes that grow below { $ratio } times that could not be counted at all frequencies. Others may be unstable.
       *[no] no threshold was found up to { $ratio } times that. Raise up_to.
    }{ $density ->
        [region] {" "}{ $region }
       *[other] {""}
    }
stability-threshold-region = { $region ->
        [a] Region A of API 617: critical speed ratio { $critical_ratio } at a gas density of { $gas_density }, at most { $speed_ratio_limit } permitted. Rigid supports: { $parts }.
        [b] Region B of API 617 requires level 2 below ten times the anticipated stiffness: critical speed ratio { $critical_ratio } at a gas density of { $gas_density }, above { $speed_ratio_limit }. Rigid supports: { $parts }.
       *[dense] Region B of API 617 requires level 2 below ten times the anticipated stiffness: gas density { $gas_density }, above { $largest_density }, at any critical speed ratio.
    }
stability-threshold-region-open = The criterion of gas density and critical speed ratio (API 617) is not assessed: { $reason ->
        [rest] no equilibrium of the machine was found.
        [supports] no part was found that supports the rotor. Name the supports in supports.
        [part] a part beside the supports is not given by mass, gyroscopic and stiffness matrices. Name it in supports if it supports the rotor.
        [missing] no critical speed on rigid supports was found.
        [uncertain] the critical speed on rigid supports is not converged.
       *[number] the critical speed ratio is not known.
    }
stability-threshold-counted = { $growing ->
        [0] No mode grows
        [one] One mode grows
       *[other] { $growing } modes grow
    } at { $stiffness } { $range ->
        [below] below { $limit }
       *[all] by all of the spectrum
    }, as many as among the { $followed } of { $modes } lateral modes followed.
stability-threshold-missed = { $missed ->
        [one] One mode
       *[other] { $missed } modes
    } that grow at { $stiffness } could not be followed back to where they become unstable. Raise points.
stability-threshold-not-counted = The modes that grow at { $stiffness } could not be counted: others may be unstable.
stability-threshold-meeting = Two modes meet in a double root at { $value }. Beyond it their numbers are a convention.
stability-threshold-lost = { $modes ->
        [one] One mode
       *[other] { $modes } modes
    } could not be followed to the largest stiffness. Raise points.

stability-threshold-curve = mode { $mode }, { $whirl } at { $frequency }
stability-threshold-alt = Logarithmic decrement of { $modes ->
        [one] one mode
       *[other] { $modes } modes
    } over the cross-coupled stiffness, with { $thresholds ->
        [0] no threshold
        [one] one threshold
       *[other] { $thresholds } thresholds
    }.
