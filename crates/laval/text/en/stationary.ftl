# Balancing states over the speed.

stationary-hindered = "{ $part }": { $reason }.
stationary-no-balls = This machine has no balls. Its states are the synchronous response, as in nonlinear_response.
stationary-insufficient-capacity = The balls can cancel { $value } at most, { $missing } less than the unbalance. Use heavier balls, or more of them.

# Kinds of states.
stationary-kind = { $kind ->
        [balanced] balanced
        [partly_balanced] partly balanced
        [reduced] unbalance reduced
        [touching] balls touching
        [together] balls coincident
        [opposed] balls diametrically opposite
        [spread] balls apart
       *[single] synchronous state
    }
# States that balance, fully or partly.
stationary-state = { $kind ->
        [balanced] the balanced state
        [partly_balanced] the partly balanced state
       *[reduced] the state of reduced unbalance
    }
stationary-continuum-of = { $kind ->
        [balanced] the continuum of balanced states
        [partly_balanced] the continuum of partly balanced states
       *[reduced] the continuum of states of reduced unbalance
    }
stationary-sample = { $kind ->
        [balanced] one state of the continuum of balanced states
        [partly_balanced] one state of the continuum of partly balanced states
       *[reduced] one state of the continuum of states of reduced unbalance
    }

# Ranges of speed.
stationary-stable = Branch { $branch }, { $kind }, is stable from { $from } to { $value }.
stationary-stable-throughout = Branch { $branch }, { $kind }, is stable over the whole speed range, from { $from } to { $value }.
stationary-continuum = A continuum of states was found from { $from } to { $value }: { $kind }, { $free ->
        [one] one free direction
       *[other] { $free } free directions
    }. Its stability is assessed by samples.
stationary-continuum-stable = Some states of the continuum are stable from { $from } to { $value }: { $kind }. Its stability is assessed by samples.
stationary-no-state = No synchronous state was found in the speed range. Raise starts, or compute a transient.
stationary-no-stable-state = No stable synchronous state was found from { $from } to { $value }. { $balls ->
        [yes] Balls slip, the machine whirls, or a state was missed;
       *[no] The machine whirls, or a state was missed;
    } compute a transient there.
stationary-not-balanced = No balanced or partly balanced state was found from { $from } to { $value }. { $capacity ->
        [used] The balls are too light there; use heavier balls, or pass quickly.
       *[left] Pass this range quickly.
    }
stationary-harm = From { $from } to { $to } balls increase the unbalance up to { $value } times: branch { $branch }, { $kind }. Hold the balls there, or pass quickly.
stationary-harm-of-balanced = From { $from } to { $to } balls unbalance the rotor by up to { $value }: branch { $branch }, { $kind }. Without balls the rotor is balanced; remove or hold them.
stationary-coexistence = At { $speeds ->
        [one] { $from }
       *[other] { $speeds } speeds of the table, from { $from } to { $to },
    } a balanced and an unbalanced state are both stable. The initial condition decides; compute basins.

# The best state at the operating speed.
stationary-residual-unbalance = At { $speed } the best stable state found, { $kind }, leaves an unbalance of { $value }{ $beside ->
        [times] , { $times } times that without balls
        [nothing] , although nothing is out of balance without balls
       *[none] {""}
    }.
stationary-dead-zone = At { $speed } dry friction leaves an unbalance of up to { $value }{ $effect ->
        [more] , more than without balls
       *[less] {""}
    }. It holds balls up to { $angle } from { $state }.{ $held ->
        [unstable] {" "}With the balls held the machine is unstable; reduce the friction.
       *[stable] {""}
    }
stationary-dead-zone-open = At { $speed } dry friction of { $value } holds balls beyond the ranges found. More unbalance may be left than computed; reduce the friction.
stationary-dead-zone-continuum = At { $speed } dry friction may leave an unbalance of { $value } or more beside { $continuum }.

# The balanced state over a parameter.
stationary-least-no-state = At { $speed } no balanced or partly balanced state was found at { $sought ->
        [one] one value
       *[other] { $sought } values
    } of { $parameter } from { $lowest } to { $highest }. Widen the range, or raise starts.
stationary-least-unstable = At { $speed } { $state } is unstable at { $computed ->
        [one] the one value
       *[other] all { $computed } values
    } of { $parameter } computed from { $lowest } to { $highest }.{ $reach ->
        [none] {""}
       *[other] {" "}{ $reach }
    } Widen the range, or vary another parameter.
stationary-least-above = At { $speed } { $state } becomes stable when { $parameter } exceeds { $value }.{ $ends ->
        [none] {""}
        [open] {" "}It stays stable up to { $to }.
        [exists] {" "}It stays stable up to { $to }, where it ends.
        [half] {" "}It stays stable up to { $to }, where half of the unbalance is left.
       *[lost] {" "}It stays stable up to { $to }, as far as it was followed.
    }{ $ranges }
stationary-least-from-limit = At { $speed } { $state } { $begins ->
        [exists] exists and is stable when { $parameter } exceeds { $value }.
        [half] is stable when { $parameter } exceeds { $value }, where half of the unbalance is left.
       *[lost] is stable when { $parameter } exceeds { $value }, as far as it was followed.
    }{ $ends ->
        [none] {""}
        [open] {" "}It stays stable up to { $to }.
        [exists] {" "}It stays stable up to { $to }, where it ends.
        [half] {" "}It stays stable up to { $to }, where half of the unbalance is left.
       *[lost] {" "}It stays stable up to { $to }, as far as it was followed.
    }{ $ranges }
stationary-least-between = At { $speed } { $state } is stable from { $value } to { $to } of { $parameter }, as far as it was computed.{ $ranges }
stationary-least-everywhere = At { $speed } { $state } is stable at { $computed ->
        [one] the one value
       *[other] all { $computed } values
    } of { $parameter } computed from { $lowest } to { $highest }.
stationary-least-outside = At { $speed } { $state } is stable until { $parameter } exceeds { $to }{ $ends ->
        [exists] , where it ends,
        [half] , where half of the unbalance is left,
        [lost] , as far as it was followed,
       *[open] {""}
    } and again when it exceeds { $value }.{ $ranges }
stationary-least-below = At { $speed } { $state } is stable until { $parameter } exceeds { $value }{ $ends ->
        [exists] , where it ends
        [half] , where half of the unbalance is left
        [lost] , as far as it was followed
       *[open] {""}
    }.{ $ranges }
# Behind the sentence, where the state is stable more than once.
stationary-least-ranges = { $ranges ->
        [one] {""}
       *[other] {" "}It is stable in { $ranges } ranges of { $parameter }.
    }
stationary-exists = It exists { $ends }.
stationary-followed = It was followed { $ends }.
stationary-down-to = down to { $end }{ $why ->
        [exists] , where it ends
        [half] , where half of the unbalance is left
       *[other] {""}
    }
stationary-up-to = up to { $end }{ $why ->
        [exists] , where it ends
        [half] , where half of the unbalance is left
       *[other] {""}
    }

# Errors of a parameter, and the chart.
stationary-cost = At { $speed } the best stable state found leaves an unbalance of { $first } with { $parameter } = { $from }, and { $value } with { $to }. Without balls it is { $without }.{ $effect ->
        [harm] {" "}Balls then increase the unbalance; tighten the tolerance.
        [lost] {" "}The rotor is then no longer balanced; tighten the tolerance.
       *[none] {""}
    }
stationary-cost-no-stable-state = At { $speed } no stable state was found with { $parameter } = { $value }{ $more ->
        [larger] {" "}and the { $larger ->
            [one] larger value
           *[other] { $larger } larger values
        } computed
        [some] , and at { $none } of { $computed } values in all
       *[none] {""}
    }. Tighten the tolerance, or compute a transient.
stationary-chart = Of { $value } cells of the map over speed and { $parameter }, { $balanced } are balanced, { $bistable } bistable and { $unbalanced } unbalanced. In { $unstable } no stable state was found.

# How complete the search is.
stationary-completeness = Search coverage: { $value } of the converged starts reached a known state. { $branches ->
        [0] No branch was
        [one] One branch was
       *[other] { $branches } branches were
    } found{ $stopped ->
        [yes] {" "}before the study stopped
       *[no] {""}
    }.
stationary-too-many-branches = There are more branches of states than the study follows. The list is incomplete; narrow the speed range.
stationary-unfinished = Not followed to the end: { $branches }. States beyond may be missing.
stationary-branch-near = branch { $branch } near { $speed }
stationary-more = { $count } more

# One speed.
stationary-states = At { $speed } { $states ->
        [one] the one state found is stable
       *[other] { $stable ->
            [one] one of { $states } states found is stable
           *[other] { $stable } of { $states } states found are stable
        }
    }.
stationary-states-unstable = At { $speed } { $states ->
        [one] the one state found is unstable
       *[other] all { $states } states found are unstable
    }. Compute a transient for the motion there.
stationary-states-none = At { $speed } no synchronous state was found. Raise starts, or compute a transient.
