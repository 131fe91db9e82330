# Steady response to unbalance of a machine with nonlinear parts.

# Which branch; stands behind the word "branch".
nonlinear-response-branch = { $origin ->
        [low] from low speed
        [high] from high speed
        [broken] of less symmetry from { $speed }
        [doubled] of doubled period from { $speed }
        [crossing] crossing at { $speed }
        [mixed] with x and y on different states
        [subharmonic] repeating every { $turns } turns
       *[start] apart from the others
    }
# Which part of a branch; likewise.
nonlinear-response-stretch = { $place ->
        [before] { $branch } up to its fold at { $to }
        [beyond] { $branch } beyond its fold at { $from }
        [between] { $branch } between its folds at { $from } and { $to }
       *[whole] { $branch }
    }
nonlinear-response-more-ranges = { $n } more { $n ->
        [one] range
       *[other] ranges
    }

# Why a branch ended. Whole sentences.
nonlinear-response-end = { $why ->
        [work-limit] The work limit was reached.
        [range] The range of speeds ends there.
        [points] The largest number of points was reached; raise max_points.
        [cancelled] The study was stopped on request.
        [closed] The branch closes on itself.
        [start] The initial condition did not converge.
        [undefined] The equations are not defined there: { $cause }.
        [infinite] A force or its derivative has no finite value there; a part is used outside its range.
        [singular] The equations have no unique solution there: a coordinate is unconstrained, or branches cross.
        [sharp] The branch turns too sharply there; keep more harmonics, or smooth an abrupt force law.
        [strayed] The nearest solution beyond belongs to another branch; narrow the range of speeds about it.
        [resonance] The motion of a body changes too fast there, as at an undamped resonance; add damping to the bodies.
        [unbounded] The amplitude grows without bound at nearly constant speed, as at an undamped resonance; add damping.
       *[unsolved] The equations could not be solved beyond it; keep more harmonics, or smooth an abrupt force law.
    }

# Run-up and run-down so slow that the response follows the branches.
nonlinear-response-jump = Quasi-static { $way ->
        [up] run-up
       *[down] run-down
    }: the response jumps { $again ->
        [no] at
       *[yes] again at
    } { $value }{ $onto ->
        [none] {""}
       *[other] , onto the branch { $onto }
    }.
nonlinear-response-jump-unstable-before = The response before this jump is unstable { $ranges }; the machine may depart from it there.
nonlinear-response-jump-landing = { $stable ->
        [0] No computed state is stable just beyond the jump; `transient` shows the motion there.
       *[other] { $stable } states are stable beyond the jump; `basins` shows which is reached.
    }
nonlinear-response-no-jump = Quasi-static { $way ->
        [up] run-up
       *[down] run-down
    } from { $from } to { $to }: no jump{ $amplitude ->
        [rising] , but the amplitude still rises at the end of the range
       *[other] {""}
    }.
nonlinear-response-no-fold = Quasi-static { $way ->
        [up] run-up
       *[down] run-down
    } from { $from } to { $to }: no fold, but the response is unstable { $ranges }.
nonlinear-response-sweep-unfinished = Quasi-static { $way ->
        [up] run-up
       *[down] run-down
    }: the branch was followed only to { $value }. Jumps beyond are not known. { $why }
nonlinear-response-sweep-not-followed = Quasi-static { $way ->
        [up] run-up
       *[down] run-down
    }: the branches were not followed. { $why }
nonlinear-response-sweep-unstable = Quasi-static { $way ->
        [up] run-up
       *[down] run-down
    }: the fold at { $value } causes no jump, because the response before it is unstable { $ranges }. `transient` shows the motion there.
nonlinear-response-sweep-unknown = Quasi-static { $way ->
        [up] run-up
       *[down] run-down
    }: no periodic solution was found at its first speed, { $value }. Begin at another speed, or set states = "all".
nonlinear-response-start-not-followed = The solution at { $value }, an end of the range, could not be followed from outside the range. A machine brought to this speed may respond differently; widen the range.
nonlinear-response-two-branches = Two separate branches were found, one from low speed and one from high speed. Which one applies depends on the history of the speed.
nonlinear-response-branch-unfinished = The branch { $branch } was followed beyond { $folds ->
        [one] its fold
       *[other] its folds
    } only to { $value }. { $why }

# The upper branch goes on beyond the range.
nonlinear-response-not-closed = The upper branch reaches { $speed }, the end of the range, without a fold: amplitude { $value }, { $lower } on the lower branch. The end of the range is no jump.
nonlinear-response-beyond = { $beyond ->
        [closes] Continued beyond the range, the branch folds at { $at }; the response jumps there.
        [stays] Damping dissipates { $share } of the available unbalance power there and { $limit } at high speed. A fold occurs at 100 %, so this branch has none.
        [rises] Damping dissipates { $share } of the available unbalance power there and more at higher speed. A fold occurs at 100 %, beyond { $reach } times this speed.
        [lost] Damping dissipates { $share } of the available unbalance power there; a fold occurs at 100 %. The branch could be continued only to { $at }.
       *[unknown] Damping dissipates { $share } of the available unbalance power there; a fold occurs at 100 %.
    }

# The search for further states.
nonlinear-response-further-states = Further states, { $kind }: { $branches ->
        [one] one branch
       *[other] { $branches } branches
    } from { $value } to { $to }, { $stability ->
        [some] partly stable between { $low } and { $high }
        [none] unstable throughout
       *[unknown] stability not known
    }.
nonlinear-response-copies = { $kind ->
        [turned] Each branch represents up to { $copies } symmetric copies.
       *[later] Each branch represents up to { $copies } copies: turned by the symmetry of the machine, or delayed by a turn of the rotor.
    }
nonlinear-response-no-further-states = No further states were found from { $starts ->
        [0] mixed and subharmonic initial conditions
       *[other] mixed, subharmonic and random initial conditions
    }. The search is not exhaustive.
nonlinear-response-families-left-out = Not all families of states were followed. Narrow the range of speeds to see the others.
nonlinear-response-search-not-begun = The search for further states was not begun, because the main branches are not complete. Further states are not excluded.
nonlinear-response-search-stopped = The search for further states is not complete: { $speeds } of { $all-speeds } speeds and { $starts } of { $all-starts } random initial conditions were tried. Further states may be missing.
nonlinear-response-search-in-time = { $starts } of { $all-starts } initial conditions were integrated in time.

# Largest values.
nonlinear-response-largest = The largest steady displacement is { $value }, of { $body } { $place ->
        [end] at an end of the range, { $speed }
       *[inside] at { $speed }
    }.
nonlinear-response-largest-at-left-end = Its branch was followed only to there; larger displacements beyond are not excluded.
nonlinear-response-largest-left = Its branch was followed only to { $left }; larger displacements beyond are not excluded.
nonlinear-response-largest-of = The largest steady displacement of { $body } is { $value }, at { $speed }.
nonlinear-response-largest-tilt = The largest steady tilt of "{ $body }" is { $value }, at { $speed }.
nonlinear-response-not-reached = The largest steady { $quality ->
        [tilt] tilt
       *[displacement] displacement
    } of { $body } was not reached: { $value } and rising at { $speed }, where the branch { $branch } was left.
nonlinear-response-unbounded = The steady { $quality ->
        [tilt] tilt
       *[displacement] displacement
    } of { $body } is unbounded: { $value } and rising at { $speed }, where the branch { $branch } was left. Add damping.
nonlinear-response-largest-force = The largest steady force of "{ $part }" is { $value }, at { $speed }.
nonlinear-response-largest-force-left = The response was not followed to its end; larger forces are not excluded.
nonlinear-response-antiresonance = Antiresonance: the force of "{ $part }" falls to { $force } at { $value }, { $share } of the smaller maximum beside it.
nonlinear-response-tuning = Tuning: a stiffness of { $value } of "{ $body }", now { $stiffness }, would reduce the force of "{ $part }" at { $speed } from { $before } to { $after } on the lower branch.
nonlinear-response-tuned = { $stability ->
        [stable] The tuned response is stable.
        [unstable] The tuned response is unstable, growth rate { $growth }; do not tune the foundation without more damping.
       *[unknown] The stability of the tuned response was not assessed.
    }
nonlinear-response-self-centring = Self-centring: the amplitude of "{ $body }" tends to { $value } at high speed. At { $speed } it is { $amplitude }, a difference of { $difference } in amplitude and phase.
nonlinear-response-centred = The difference is below { $close } from { $from } on.
nonlinear-response-centred-beyond = Extrapolated, the difference falls below { $close } at { $from }.
nonlinear-response-centring-unstable = The response at { $speed } is unstable.
nonlinear-response-force-limit = The force of "{ $part }" tends to { $value } at high speed on the lower branch.

# Stability.
nonlinear-response-unstable = The branch { $stretch } is unstable { $ranges }. The largest growth rate is { $value }, at { $speed }. Avoid these speeds, or add damping.
nonlinear-response-stability = With rising speed the branch { $stretch } { $way ->
        [lost] becomes unstable
       *[gained] becomes stable
    } { $place ->
        [located] at { $value }
       *[bracketed] near { $value }, between { $from } and { $to }
    }: { $event }.
nonlinear-response-event = { $kind ->
        [neimark-sacker] Neimark–Sacker bifurcation, { $way ->
            [lost] vibration at { $frequency } grows above it
           *[gained] vibration at { $frequency } decays above it
        }
        [torus] Neimark–Sacker bifurcation, vibration at a second frequency { $way ->
            [lost] grows above it
           *[gained] decays above it
        }
        [period-doubling] period doubling, successive periods differ
        [symmetry-breaking] symmetry breaking, states of less symmetry branch off
       *[branch-point] branch point, another branch crosses
    }
nonlinear-response-more-bifurcations = { $more ->
        [one] One more bifurcation is
       *[other] { $more } more bifurcations are
    } listed in the table.
nonlinear-response-stability-checked = The stability of { $states ->
        [one] one state
       *[other] { $states } states
    } was verified by two methods that use no symmetry; growth rates differ by at most { $value }.
nonlinear-response-stability-contradicted = Two further methods contradict the stability in { $contradictions } of { $checks } comparisons; growth rates differ by up to { $value }. Treat the stability as not proven.
nonlinear-response-stability-not-checked = The stability was not verified by a second method: { $why }.
nonlinear-response-nothing-checked = The stability was not verified by a second method: no state was assessed again.
nonlinear-response-stability-not-requested = Stability was not requested, and the states may be unstable. Set stability = true.
nonlinear-response-stability-reduced = For stability the linear parts were reduced to { $coordinates } coordinates. Up to { $frequency } their receptance at the nonlinear parts differs by { $value } from that of the whole machine.
nonlinear-response-stability-unknown = The stability of the states was not assessed: { $why }. They may be unstable.
nonlinear-response-stability-partly-unknown = The stability of { $unknown } of { $all } states was not assessed: { $why }. They may be unstable.
# Why stability was not assessed.
nonlinear-response-unassessed = { $why ->
        [no-time-form] "{ $part }" has no time-domain form: { $cause }
        [states] the machine has { $states } first-order states, more than the monodromy matrix may have
        [massless] a coordinate has no mass
        [jumps] the force of "{ $part }" jumps when it touches, and the effect of such a jump on a disturbance is not computed
       *[failed] { $cause }
    }
nonlinear-response-stability-fit = Stability was assessed with the fitted time form of "{ $part }"; the states themselves are exact.
nonlinear-response-determinant = The stability of { $states ->
        [one] one state
       *[other] { $states } states
    } was assessed by Hill's determinant with the exact impedances. Exponents growing faster than { $value } were counted; of decaying ones only some are known.
nonlinear-response-balls-elsewhere = No computed state is stable. Balls have further states; use `stationary`, `transient` or `basins`.

# Validity.
nonlinear-response-harmonics = The harmonics kept leave out { $value } of the nonlinear force at the worst point. Sharp details of the motion are not resolved; smooth force laws with kinks.
nonlinear-response-no-number = "{ $part }" gives no finite force in some states. The response is not valid there.

# Orders beside the synchronous one.
nonlinear-response-no-orders = No sub- or superharmonic amplitude of a body exceeds { $limit }.
nonlinear-response-order-range = The { $kind ->
        [superharmonic] superharmonic
        [subharmonic] subharmonic
       *[component] component
    } of order { $divisor ->
        [1] { $order }
       *[other] { $order }/{ $divisor }
    } of "{ $body }" exceeds { $limit } { $extent ->
        [all] from { $value } to { $to }, on the whole branch { $branch }
        [inside] from { $value } to { $to } on the branch { $branch }
        [begins] up to { $to } on the branch { $branch }, which begins at { $value }
       *[ends] from { $value } on the branch { $branch }, which ends at { $to }
    }. It reaches { $largest } at { $speed }, { $sense ->
        [forward] forward whirl
        [backward] backward whirl
       *[line] along a line
    }.
nonlinear-response-more-orders = { $more ->
        [one] One more range of orders above { $limit } is
       *[other] { $more } more ranges of orders above { $limit } are
    } listed among the special points.

# One speed.
nonlinear-response-no-motion = No periodic solution was found at { $speed }. `transient` shows the motion there.
nonlinear-response-no-motion-stopped = No periodic solution was found at { $speed } before the study stopped.
nonlinear-response-all-unstable = { $count ->
        [one] The only periodic solution found at { $speed } is
       *[other] All { $count } periodic solutions found at { $speed } are
    } unstable. `transient` shows the motion there.
nonlinear-response-steady = At { $speed } the largest { $quality ->
        [tilt] tilt
       *[displacement] displacement
    } of { $body } is { $value }{ $count ->
        [1] {""}
       *[other] , in solution { $number } of { $count }
    }. { $stability ->
        [stable] The response is stable.
        [unstable] The response is unstable.
       *[unknown] The stability of the response is not known.
    }
nonlinear-response-period = It repeats after { $turns } turns.
nonlinear-response-no-excitation = The machine has no excitation.
