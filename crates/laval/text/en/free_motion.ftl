# What the studies of free motions share.

# Why a family of motions ended. Whole sentences.
free-motion-end = { $why ->
        [unbounded] The amplitude grows without bound there.
        [start] No motion of this size was found near the first estimate.
        [work-limit] The work limit was reached.
        [points] The largest number of points was reached; raise max_points.
        [cancelled] The study was stopped on request.
       *[unsolved] The equations could not be solved beyond it; keep more harmonics.
    }
free-motion-harmonics = The harmonics kept leave out { $value } of the nonlinear force at the worst point. Sharp details of the motion are not resolved; smooth force laws with kinks.
free-motion-harmonics-unknown = The nonlinear force left out by the harmonics kept is not known at some points. Amplitudes and frequencies there are not verified.
free-motion-unmeasured = { $value } of { $all } { $motions } could not be evaluated. Their amplitude and validity are not known.
