# Texts of figures and tables: labels, titles, and what a figure shows to readers who cannot see it.

# What belongs to a body or part: "largest tilt of drum". The owner is a name of the machine file.
label-of = { $what } of { $owner }
# A point of a body.
label-point = { $body } at { $height }
# The same in front of a number.
named-point = { $body } (at { $height })
# A quantity and a reservation about it: "semi-major axis of the orbit; NaN where the motion failed".
label-noted = { $what }; { $note }
# A flag that is not set: "not stable".
label-not = not { $what }
# A mark with a range of the axis: "unstable 100 to 120".
label-between = { $label } { $from } to { $to }
# A multiple of the spin speed.
label-order = { $order }×
label-mode = mode { $number }
label-operating-margin = operating speed ± { $margin }

# Linear studies.
campbell-alt = Frequencies and growth rates of { $modes ->
        [one] one mode
       *[other] { $modes } modes
    } over spin speed, with { $criticals ->
        [one] one critical speed
       *[other] { $criticals } critical speeds
    }.{ $above ->
        [0] {""}
        [one] {" "}Above the axis, beyond { $top }: one more mode.
       *[other] {" "}Above the axis, beyond { $top }: { $above } more modes.
    }
stability-map-operating = operating speed: { $growth }
stability-map-alt = Largest growth rate over spin speed, with the ranges above the threshold. Below it the frequency of that mode; a gap marks a change to another mode.
stability-map-alt-parameter = Largest growth rate over { $parameter } at { $speed }.
stability-map-alt-map = Largest growth rate over spin speed and { $parameter }, with the boundary of stability.
modes-table = Natural modes about { $state }
modes-alt = Growth rates of { $modes ->
        [one] one mode
       *[other] { $modes } modes
    } over frequency at { $speed }.
approximation-degree = degree { $degree }
approximation-alt = Grey lines: frequencies and growth rates of the machine over spin speed. Points: those of its approximation of degree { $degree }.
forced-response-amplification = AF { $factor }
forced-response-alt = Amplitudes of { $bodies ->
        [one] one body
       *[other] { $bodies } bodies
    } over spin speed{ $bounded ->
        [no] , without bound at { $speed }
        [none] , without resonance
       *[yes] ; the largest resonance is at { $speed }
    }.

# Centrifuges.
operating-window-alt = Margins of all requirements over the spin speed, with the ranges in which all are kept.
operating-window-alt-none = Margins of all requirements over the spin speed. At every speed one of them is broken.
operating-window-alt-time = Time to the recovery over the spin speed, with the available time.
operating-window-alt-trade = Lowest and highest speed of the window over the available time.
operating-window-alt-map = Least margin over spin speed and { $parameter }. The curve is the edge of the window.
operating-window-table-map = Least margin over spin speed and { $parameter } (separation from at most { $places } places)
separation-table-demand = Time that catches { $share } over the speed
separation-alt-efficiency = Share of the particles caught over time, with the available time and the recovery requested.
separation-alt-grade = Share of the particles caught in the available time over their diameter.
separation-alt-demand = Time to the recovery requested over the spin speed.
separation-alt-pellet = Places where particles leave the liquid: share of all particles, along the cup for the wall, from its axis for bottom and surface.
separation-alt-paths-bowl = Paths of some particles in the axes of the bowl: way in the sense of rotation against the liquid, over the way outwards.
separation-alt-paths-cup = Paths of some particles in the axes of the cup, across it and in the sense of rotation, from the surface (left) to the bottom (right).
separation-alt-paths-time = Distance of some particles from the spin axis over time, until they leave or the available time ends.
separation-alt-released = Place of the particle released and tilt of its cup over time.

# Studies of parameters.
optimum-alt-search = Best { $aim } over the runs of { $searches ->
        [one] one search
       *[other] { $searches } searches
    }.
optimum-title-profile = Around the optimum: { $parameter }
optimum-alt-profile = { $aim } over { $parameter } through the optimum, the other parameters at their best.
optimum-worse = { $share } worse
sensitivity-place-peak = peak at { $speed } of { $point }
sensitivity-place-jump = { $way ->
        [up] upward
       *[down] downward
    } jump at { $speed }
sensitivity-title = Influence on the { $place }
sensitivity-alt = Relative influence of the { $count ->
        [one] parameter that matters most
       *[other] { $count } parameters that matter most
    }, one pair of bars each.
sensitivity-table-bars = Bars of the figure: influence on the { $quality ->
        [speed] speed
        [tilt] tilt
       *[displacement] displacement
    }, { $place }
uncertainty-table-histogram = Histogram of { $quantity }: both ends of every bar
uncertainty-table-distribution = Share of the samples below a value of { $quantity }
uncertainty-table-bars = Bars of the figure: { $kind } of { $quantity }
uncertainty-title-distribution = Distribution of { $quantity } ({ $samples ->
        [one] one sample
       *[other] { $samples } samples
    }{ $alike ->
        [0] {""}
        [one] , one number alike
       *[other] , { $alike } numbers alike
    })
uncertainty-alt-distribution = Histogram of { $quantity } over { $samples ->
        [one] one sample
       *[other] { $samples } samples
    }, from { $low } to { $high }.
uncertainty-title-indices = Sensitivity indices of { $quantity }
uncertainty-title-effects = Elementary effects on { $quantity }
uncertainty-alt-bars = Influence on { $quantity }: one bar for each of { $parameters ->
        [one] one parameter
       *[other] { $parameters } parameters
    }.
uncertainty-share-of-variance = share of the variance, from { $samples ->
        [one] one sample
       *[other] { $samples } samples
    }{ $rough ->
        [yes] : a rough estimate
       *[no] {""}
    }
uncertainty-quantile = { $share } quantile

# Nonlinear studies.
nonlinear-response-alt = Largest displacement of each body over speed, on { $branches ->
        [one] one branch
       *[other] { $branches } branches
    } with { $folds ->
        [0] no fold
        [one] one fold
       *[other] { $folds } folds
    }{ $largest ->
        [known] ; the largest, { $value } of { $point }, is at { $speed }
       *[unknown] {""}
    }.
nonlinear-response-alt-jumps = Largest displacement near the folds, enlarged.
nonlinear-response-alt-forces = Largest force over a period of { $parts ->
        [one] one part
       *[other] { $parts } parts
    } over speed.
nonlinear-response-alt-orders = Semi-major axes of the sub- and superharmonic orders over spin speed ({ $bodies }), with the threshold.
nonlinear-response-limit = { $part }, high speed
nonlinear-response-map-evidence = map over the whole period, tolerance { $tolerance }: states
backbone-begins = { $origin ->
        [mode] from { $frequency }
       *[asymptote] beside { $frequency }
    }
backbone-alt = Amplitude of the deflection over whirl frequency at { $speed }, { $families ->
        [one] one family
       *[other] { $families } families
    }.
methods-alt = Deviation of each method from the converged peak over spin speed, all states.
limit-cycles-alt = Largest displacement and frequency of limit cycles over spin speed: { $families ->
        [one] one family
       *[other] { $families } families
    } from { $edges ->
        [one] one edge
       *[other] { $edges } edges
    } of the instability of the equilibrium.
bifurcation-loci-alt = Loci in the plane of spin speed and { $parameter }: { $folds } of folds, { $others } of other changes of stability, with { $cusps ->
        [0] no cusp
        [one] one cusp
       *[other] { $cusps } cusps
    }.
response-map-alt = { $what ->
        [peak] Largest stable displacement
        [tilt] Largest stable tilt
        [hysteresis] Width of the speeds with several states, blank where there is one,
       *[sweeps] Result of slow sweeps up and down
    } over { $x } and { $y }{ $border ->
        [yes] , with the border between machines with and without jumps
       *[no] {""}
    }.
stationary-alt-range = { $state } from { $from } to { $to }
stationary-alt = { $branches ->
        [one] One branch
       *[other] { $branches } branches
    } of equilibria in the rotating frame over spin speed; { $stable ->
        [0] no equilibrium is stable
       *[other] stable: { $ranges }
    }.
stationary-title-stabilised = Growth of the balanced state at { $speed }
stationary-alt-stabilised = Largest growth rate of the balanced state over { $parameter }.
stationary-title-chart = Balanced state over speed and { $parameter }
stationary-alt-chart = Balance of the stable states over spin speed and { $parameter }, with the located boundary of the balanced state.
stationary-title-errors = Unbalance left at { $speed }
stationary-alt-errors = Unbalance left by the best and the worst stable state over { $parameter }, and without the balls.
stationary-table-stabilised = Largest growth rate of the balanced state at { $speed } over { $parameter }
stationary-table-chart = The balanced state and the stable states over speed and { $parameter }
stationary-table-errors = Unbalance caused by errors of { $parameter } at { $speed }
stationary-class = { $word ->
        [balanced] balanced
        [partly_balanced] partly balanced
        [reduced] unbalance reduced
        [touching] balls touching
        [together] balls coincident
        [opposed] balls diametrically opposite
        [spread] balls apart
       *[single] equilibrium
    }
stationary-change = { $word ->
        [fold] branch turns back (fold)
        [branch_point] branches cross
        [hopf] oscillation begins (Hopf)
       *[real_root] stability changes
    }
stationary-growing-roots = growing roots { $side ->
        [before] before
       *[behind] behind
    }{ $several ->
        [yes] , branch { $branch }
       *[no] {""}
    }

# Motions in time.
history-table-last-turns = Motion of the bodies over the last { $turns } turns, { $samples } samples in each
history-alt-envelope = Largest displacement of each body from equilibrium within a turn, over time.
history-alt-lateral = Displacements x and y of each body over time.
history-alt-orbit = Path of each body in the plane, to scale; a dot at its start, an arrow in its direction.
history-alt-energy = Change of the stored energy since the start, heat and the work done on the machine over time. Below, the error of the energy balance.
balance-alt = Unbalance with and without the balls, capacity of the balls, and balance quality grade over time.
balance-alt-angles = Angles in the rotor over time, from −180° to 180°: balls from the node line, tilts of free rings.
run-up-alt-drive = Spin speed, torque and power of the drive over time.
run-up-alt-envelope = Largest displacement of each body from equilibrium within a turn, over spin speed.
spectra-alt = Amplitudes of "{ $body }" over { $along ->
        [speed] spin speed
       *[time] time
    } and { $over ->
        [order] order
       *[frequency] frequency
    }. Positive is forward, negative backward.
sweep-alt = Largest displacement or tilt of each body over spin speed (start: { $ways }).
sweep-alt-bifurcation = { $state } at phase zero over spin speed: one point for every turn of the period (start: { $ways }).
sweep-alt-waterfall = Order spectra of "{ $body }" over spin speed (start: { $way }). Negative orders are backward.
sweep-alt-lyapunov = Largest Lyapunov exponent over spin speed (start: { $ways }).
motion-map-alt = { $what } over { $x } and { $y }.
basins-alt = Attractor reached from each initial condition at { $speed }, over { $x } and { $y }.
basins-sized = { $body } { $size } (attractor { $attractor })
basins-grid-step = grid step of { $state }
basins-typical-size = typical size of { $state }
animation-alt = Seen along the axis: the centres of the bodies with the phase reference mark, tracks and balls. Displacements are drawn { $enlarged } times as large as the tracks.
store-requested = { $rows } requested

# How a study ended.
end-place = { $parameter } = { $at }
end-reached = The study ran to its end.
end-step-too-small = The study stopped early: the step became too small at { $place }.
end-no-solution = The study stopped early: no solution was found at { $place } (residual { $residual }).
end-no-values = The study stopped early: no solution was found at { $place } (the equations have no finite values there).
end-unbounded = The study stopped early: the motion went beyond all bounds at { $place }.
end-cancelled = The study was cancelled; the completed part is shown.
end-refused = The study was refused: this machine cannot answer it.
end-max-points = The study stopped early: it reached the largest number of points allowed (max_points, --work-limit).
end-work-limit = The study stopped early: it reached the limit on its work (--work-limit); the completed part is shown.
