# How a mode moves.
whirl-direction = { $whirl ->
        [forward] forward whirl
        [backward] backward whirl
        [mixed] mixed whirl with { $forward_share } forward share
        [straight] mixed whirl on a straight line
        [axial] axial vibration
        [torsional] torsional vibration
       *[none] vibration
    }
