# A place on the map.
motion-map-speed = a speed of { $speed }
motion-map-parameter = { $parameter } = { $value }

motion-map-largest = The largest { $quality ->
        [tilt] value
       *[displacement] displacement
    } of { $point } is { $value }, at { $place }.

# How the response repeats.
motion-map-every-turn = Every response that settles repeats each revolution: { $count } of { $points } points.
motion-map-subharmonic = The response is subharmonic of order 1/{ $turns } at { $count } of { $points } points, for instance at { $place }.
motion-map-longer-period = The response repeats only after more than { $turns } revolutions at { $count } of { $points } points, for instance at { $place }.
motion-map-not-periodic = The response does not repeat within { $turns } revolutions at { $count } of { $points } points, for instance at { $place }. It is quasi-periodic, chaotic or of a longer period there.

# Points without a result.
motion-map-not-settled = The response did not settle within most_periods at { $count } of { $points } points. Amplitudes there may contain transients; raise most_periods.
motion-map-failed-machines = The parameters give no valid machine at { $count } of { $points } points, for instance at { $place }: { $reason }.
motion-map-failed-motions = At { $count } of { $points } points the motion { $reason }, for instance at { $place }. These points have no result.
