# An initial value of a pair; an attractor.
basins-initial-value = { $state } = { $value }
basins-attractor = attractor { $attractor }
basins-irregular = a motion that does not repeat within { $turns } revolutions

# Attractors and their shares.
basins-attractors = { $count ->
        [0] No cell of the grid leads to a motion that repeats within { $turns } revolutions, at { $speed }.
        [one] One periodic attractor was found to be reached from the grid, at { $speed }.
       *[other] { $count } periodic attractors were found to be reached from the grid, at { $speed }.
    }
basins-share = { $value } of the cells lead to attractor { $attractor }, which repeats { $turns ->
        [1] every revolution
       *[other] after { $turns } revolutions
    }.{ $quality ->
        [none] {""}
        [tilt] {" "}The largest value of { $point } is { $size }.
       *[displacement] {" "}The largest displacement of { $point } is { $size }.
    }
basins-share-irregular = { $value } of the cells lead to motions that do not repeat within { $turns } revolutions, on one or several attractors.{ $quality ->
        [none] {""}
        [tilt] {" "}The largest value of { $point } is { $size }.
       *[displacement] {" "}The largest displacement of { $point } is { $size }.
    }
basins-more-attractors = The table "attractors" has { $count ->
        [one] one more attractor
       *[other] { $count } more attractors
    }, each with a smaller share.

# The undisturbed initial condition, and the smallest disturbance that leads elsewhere.
basins-undisturbed = The undisturbed initial condition, { $place }, leads to { $attractor }.
basins-undisturbed-everywhere = The undisturbed initial condition, { $place }, leads to { $attractor }, as does every cell of the grid{ $cells ->
        [settled] {" "}that settles
       *[all] {""}
    }.
basins-undisturbed-not-settled = The motion from the undisturbed initial condition, { $place }, did not settle within most_periods. No smallest disturbance is reported; raise most_periods.
basins-undisturbed-failed = From the undisturbed initial condition, { $place }, the motion { $reason }. No smallest disturbance is reported.
basins-smallest-disturbance = The smallest disturbance on the grid that leads to { $target } is { $scale ->
        [typical] { $value } typical sizes
       *[same] { $value }
    }, at { $disturbed }. The undisturbed initial condition, { $place }, leads to { $attractor }.

# Cells without an attractor.
basins-unbounded = In { $count } of { $cells } cells the motion grows without bound, beyond { $limit } times the typical displacement of 1 mm or tilt of 10 mrad. The machine does not return from there; limit the disturbance or add damping.
basins-failed-motions = In { $count } of { $cells } cells the motion { $reason }. These cells belong to no attractor.
basins-not-settled = In { $count } of { $cells } cells the motion did not settle within most_periods. These cells belong to no attractor; raise most_periods.
basins-settling-bounded = In { $count } of { $cells } cells most_periods ended the settling before the slowest mode had decayed. These cells are classified by their last revolutions.
basins-growing = A mode about equilibrium is unstable, growth rate { $growth }, so that the settling time is unknown. Motions that do not repeat are followed for most_periods, { $turns } revolutions. Add damping, or confirm the map with a larger most_periods.
basins-neutral = A mode about equilibrium neither decays nor grows, so that the settling time is unknown. Motions that do not repeat within most_periods, { $turns } revolutions, count as not settled. Add damping to that mode.
basins-modes-unknown = The modes about equilibrium are unknown, and so is the settling time. Motions that do not repeat are followed for most_periods, { $turns } revolutions. Confirm the map with a larger most_periods.

# Machines with balls.
basins-no-cell = No cell of the grid was computed: the study was stopped during the preliminary integrations.
basins-ends = { $count ->
        [0] No cell of the grid settles at { $speed }.
        [one] All cells that settle reach the same steady-state response at { $speed }.
       *[other] { $count } different steady-state responses are reached from the grid at { $speed }.
    }
basins-end = { $value } of the cells end in "{ $end }".{ $unbalanced ->
        [yes] {" "}The balls do not balance the rotor there; change the speed or avoid these initial conditions.
       *[no] {""}
    }
basins-end-moving = { $value } of the cells end in "{ $end }", with mean slip rates of { $rates }.{ $unbalanced ->
        [yes] {" "}The balls do not balance the rotor there; change the speed or avoid these initial conditions.
       *[no] {""}
    }
basins-end-unstable = { $value } of the cells end in "{ $end }" although it is unstable, for instance where balls start coincident. The smallest disturbance leads away from it; vary the initial conditions of the balls.
basins-recognition-none = Every motion was integrated to its end.
basins-recognition = In { $count } of { $cells } cells the end was concluded before the motion settled. Of { $tried } test motions integrated to their ends, { $wrong ->
        [0] none would have been concluded wrongly
        [one] one would have been concluded wrongly
       *[other] { $wrong } would have been concluded wrongly
    }.{ $doubtful ->
        [yes] {" "}Set recognise = "never" for a reliable map.
       *[no] {""}
    }
basins-agreement = All { $cells } cells chosen at random and integrated to the end confirm the map.
basins-agreement-at-boundaries = { $agree } of { $cells } cells chosen at random and integrated to the end confirm the map. The others lie at a basin boundary.{ $doubtful ->
        [yes] {" "}Set recognise = "never" for a reliable map.
       *[no] {""}
    }
basins-agreement-inside = { $agree } of { $cells } cells chosen at random and integrated to the end confirm the map. Of the others, { $inside ->
        [one] one does
       *[other] { $inside } do
    } not lie at a basin boundary. Set recognise = "never" for a reliable map.
