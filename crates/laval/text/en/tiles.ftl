# Small pictures side by side: shapes of modes, deflected shapes, orbits; and the polar diagram.

# The point on every orbit.
tiles-instant = position of the points at one instant
tiles-mark = position as the phase reference mark passes the x axis
# Lines along the axis.
tiles-plane-x = displacement in x at that instant
tiles-plane-y = displacement in y
tiles-envelope = between the semi-major axes
tiles-clearance = clearance
# Remarks.
tiles-heights = Numbers along the axis: height above the reference point of the body, or position on the shaft [{ $unit }].
tiles-not-to-scale = The machine file gives no distances between the bodies. They are drawn one below the other.
tiles-own-scale = Each picture has its own scale.
tiles-more-points = { $points ->
        [one] One more point is
       *[other] { $points } more points are
    } in the table.
# Lines of text of a picture.
tiles-axes = { $major } × { $minor }
tiles-circle = circle, { $radius }
tiles-straight = straight line
tiles-at = { $speed }{ $reason ->
        [operating] , operating speed
        [resonance] , resonance
       *[chosen] {""}
    }
tiles-reason = { $reason ->
        [operating] operating speed
        [resonance] resonance
       *[chosen] speed of the study
    }
tiles-largest = { $point }: { $amplitude }

shapes-table = Mode shapes: motion of every point over the largest semi-major axis of the mode
shapes-more = { $modes ->
        [one] One more mode, of higher frequency, is
       *[other] { $modes } more modes, of higher frequency, are
    } in the table.
shapes-alt = Shapes of { $modes ->
        [one] one mode
       *[other] { $modes } modes
    } at { $speed }: orbits of the points in space and displacements along the axis.
shapes-share = { $kind ->
        [axial] axial: { $share } of the kinetic energy
       *[torsional] twist: { $share } of the kinetic energy
    }
shapes-along = { $kind ->
        [axial] Mode { $mode } also moves along the axis, with { $share } of its kinetic energy
       *[torsional] Mode { $mode } also twists, with { $share } of its kinetic energy
    }: see the figure of the motion along and about the axis.
along-table = Motion of the modes along and about the axis at the stations
along-alt = Motion of { $modes ->
        [one] one mode
       *[other] { $modes } modes
    } along and about the axis at { $speed }, each over its largest value.
orbits-alt = { $orbits ->
        [one] One orbit
       *[other] { $orbits } orbits
    } at { $speeds ->
        [one] one speed
       *[other] { $speeds } speeds
    }, with the phase reference mark and the direction of whirl.
deflected-alt = Deflected shape of the machine at { $speeds ->
        [one] one speed
       *[other] { $speeds } speeds
    }: orbits of the points in space and displacements along the axis.
polar-alt = Forward amplitude and phase of { $bodies ->
        [one] one body
       *[other] { $bodies } bodies
    } as vectors from the axis, with speeds along the curve.
