# Loci of bifurcations over speed and a parameter.

bifurcation-loci-kind = { $kind ->
        [neimark-sacker] Neimark–Sacker bifurcation
        [period-doubling] period doubling
        [symmetry-breaking] symmetry breaking
        [branch-point] branch point
       *[fold] fold
    }

# Turning points of loci.
bifurcation-loci-cusp = Two folds vanish in a cusp at { $parameter } = { $value } and { $speed }; { $side ->
        [above] they exist above this value only
       *[below] they exist below this value only
    }.
bifurcation-loci-folds-meet = Two folds meet at { $parameter } = { $value } and { $speed }; { $side ->
        [above] they exist above this value only
       *[below] they exist below this value only
    }. A detached branch begins there, or branches exchange their parts.
bifurcation-loci-extremum = Locus { $locus }, { $kind }, turns back at { $parameter } = { $value } and { $speed }; it lies { $side ->
        [above] above
       *[below] below
    } this value only.

# Folds and hysteresis.
bifurcation-loci-folds = Folds were found for { $parameter } from { $value } to { $largest }, { $place }. Lower limit: { $below }; upper limit: { $above }.{ $stopped ->
        [yes] {" "}The study was stopped; more may exist.
       *[no] {""}
    }
bifurcation-loci-limit = { $limit ->
        [cusp] a cusp
        [folds-meet] folds meet
        [range] the end of the range
       *[left] { $stopped ->
            [yes] a locus leaves the speed range, ends early or was stopped
           *[no] a locus leaves the speed range or ends early
        }
    }
bifurcation-loci-widest-hysteresis = The hysteresis is widest at { $parameter } = { $at }: it spans { $value }, from { $lower } on.{ $cut ->
        [yes] {" "}A fold leaves the speed range there; the hysteresis continues beyond it.
       *[no] {""}
    }{ $stopped ->
        [yes] {" "}The study was stopped; more may exist.
       *[no] {""}
    }

# Single loci.
bifurcation-loci-fold-locus = Locus { $locus }, folds: { $course }.
bifurcation-loci-stability-locus = Locus { $locus }, { $kind }: { $course }.{ $whirl ->
        [yes] {" "}The whirl frequency there lies between { $lowest } and { $highest }.
       *[no] {""}
    }{ $others ->
        [all] {" "}Other exponents are unstable along the whole locus.
        [part] {" "}Along a part of it other exponents are unstable; that part does not bound stable states.
       *[none] {""}
    }
bifurcation-loci-closed = a closed curve
bifurcation-loci-from-to = from { $from }, to { $to }
bifurcation-loci-end = { $value } at { $speed }, { $end ->
        [value] the end of the parameter range
        [speed] the end of the speed range
        [points] the limit of points
        [stopped] where the study was stopped
       *[stuck] where it ends early
    }
bifurcation-loci-unfinished = Locus { $locus } ends early at { $parameter } = { $value } and { $speed }: { $why }. Bifurcations beyond may be missing.
bifurcation-loci-none = { $sought ->
        [both] No fold and no other change of stability
        [folds] No fold
       *[stability] No change of stability away from folds
    } was found{ $beside ->
        [lost] {" "}that could be followed
       *[none] {""}
    } in the response at { $values ->
        [one] one value
       *[other] { $values } values
    } of { $parameter }{ $stopped ->
        [yes] {" "}before the study stopped.
       *[no] {""}. Loci at other values are possible; raise points.
    }{ $beside ->
        [folds] {" "}{ $folds ->
            [one] One fold was
           *[other] { $folds } folds were
        } not requested.
       *[none] {""}
    }

# What was left out.
bifurcation-loci-starts-lost = No locus could be followed from { $count ->
        [one] one bifurcation
       *[other] { $count } bifurcations
    } of the computed responses. Loci may be missing; raise points.
bifurcation-loci-no-response = No response was computed at { $count ->
        [one] { $parameter } = { $first }
       *[other] { $count } values of { $parameter }, first at { $first }
    }: { $why }. Loci there may be missing.
bifurcation-loci-corners = { $count ->
        [one] One fold lies
       *[other] { $count } folds lie
    } where a force law changes along the motion, as where a contact closes. Such folds are not followed.
bifurcation-loci-more = There are more than { $most } loci; the others were not followed. Narrow the speed range.
bifurcation-loci-stability-unknown = Stability was not computed for some or all states: { $why }. Loci of stability changes may be missing.
bifurcation-loci-harmonics-short = The harmonics kept leave out { $value } of the nonlinear force at the worst point of the loci. Raise harmonics.
bifurcation-loci-parameter-range = No machine exists with { $parameter } { $side ->
        [below] below
       *[above] above
    } { $value }; that part of the range was left out: { $why }.
