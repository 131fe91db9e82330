### Sentences of diagnostics and of the command line, one for each template in the sources.
### Written by LAVAL_WRITE_DOCS=1 cargo test -p laval --test program templates.

## laval-model/src/diagnostic.rs

diag-it-cannot-be-assembled-8afc = it cannot be assembled
diag-did-you-mean-dcdc = did you mean { $near }? { $list }

## laval-model/src/model/assemble.rs

diag-the-position-is-not-on-the-d41c = the position { $position } is not on the body, which reaches from { $low } to { $high }
diag-the-machine-has-no-body-that-7801 = the machine has no body that can move
diag-add-a-part-such-as-a-ab6a = add a part such as a disc: [[part]] with kind = "disc" and a mass
diag-two-parts-are-named-638c = two parts are named "{ $name }"
diag-give-each-part-its-own-name-aa86 = give each part its own name
diag-part-takes-parameters-b0e6 = part "{ $name }" takes { $slots } parameters
diag-is-attached-to-which-does-not-caff = "{ $slot }" is attached to "{ $name }", which does not exist
diag-bodies-of-this-machine-ground-e4bc = bodies of this machine: { $bodies }, ground
diag-is-attached-to-which-is-not-24c5 = "{ $slot }" is attached to "{ $name }", which is not a body
diag-is-a-attach-to-a-disc-9439 = "{ $name }" is a { $kind }; attach to a disc, a shaft or a foundation
diag-is-attached-to-itself-by-way-b48c = "{ $name }" is attached to itself by way of other bodies
diag-joins-a-point-to-itself-4999 = "{ $name }" joins a point to itself
diag-joins-two-points-of-one-body-7eda = "{ $name }" joins two points of one body
diag-a-bearing-or-shaft-joins-a-78c9 = a bearing or shaft joins a body to another one, or to "ground"

## laval-model/src/model/field.rs

diag-above-0-26cb = above 0
diag-above-5980 = above { $least }
diag-0-or-more-6fec = 0 or more
diag-at-least-c24a = at least { $least }
diag-finite-511b = finite
diag-at-most-0c11 = at most { $most }
diag-between-and-c753 = between { $least } and { $most }
diag-between-0-and-9eeb = between 0 and { $most }
diag-and-at-most-cc06 = { $least } and at most { $most }

## laval-model/src/model/inertia.rs

diag-and-no-inertia-is-left-for-2cc3 = "{ $slot }": { $what }, and no inertia is left for { $name }

## laval-model/src/model/params.rs

diag-is-missing-3e54 = { $name } is missing
diag-is-it-must-be-2e8e = { $name } is { $value }; it must be { $wanted }

## laval-model/src/model/spins.rs

diag-no-part-of-the-machine-turns-2e6a = no part of the machine turns with a spin "{ $name }"
diag-spins-of-this-machine-d82c = spins of this machine: { $spins }
diag-is-fixed-to-which-turns-with-7c07 = "{ $slot }" is fixed to "{ $body }", which turns with another spin
diag-leave-spin-out-it-turns-with-b814 = leave spin out: it turns with that body; or give it coordinates of its own and a bearing between the two
diag-add-a-part-of-kind-speed-cc8c = add a part of kind = "speed_ratio" with this name and its ratio to the speed of the machine
diag-turns-with-the-spin-which-does-1f6e = "{ $slot }" turns with the spin "{ $name }", which does not exist

## laval-model/src/model/system.rs

diag-parameters-of-a-reduced-machine-cannot-b5d6 = parameters of a reduced machine cannot be changed
diag-parts-of-this-machine-eb3a = parts of this machine: { $names }
diag-what-a-file-says-in-another-eeb2 = what a file says in another form, as a fill by its volume, is varied by the parameter it stands for
diag-parameters-of-7bbb = parameters of "{ $part }": { $near } ({ $other })
diag-there-is-no-parameter-of-has-463f = there is no parameter "{ $path }": { $name } of "{ $part }" has one row
diag-there-is-no-parameter-of-has-193c = there is no parameter "{ $path }": { $name } of "{ $part }" has { $count } rows
diag-rows-are-numbered-from-1-parameters-b396 = rows are numbered from 1; parameters of the last: { $near }
diag-is-no-parameter-is-a-list-4dcc = "{ $path }" is no parameter: "{ $name }" is a list, whose rows are numbered from 1
diag-there-is-no-parameter-is-given-8dab = there is no parameter "{ $path }": "{ $part }" is given without { $name }
diag-is-no-parameter-is-a-list-51d9 = "{ $path }" is no parameter: "{ $name }" is a list, and studies hold its values
diag-there-is-no-parameter-e472 = there is no parameter "{ $path }"

## laval-model/src/model/timed.rs

diag-has-no-form-in-the-time-79ba = "{ $name }" has no form in the time domain: { $why }
diag-use-a-study-in-the-frequency-2f24 = use a study in the frequency domain, such as forced_response

## laval-model/src/numerics.rs

diag-the-table-has-no-rows-b81e = the table has no rows
diag-the-columns-have-and-rows-7e32 = the columns have { $x } and { $y } rows
diag-row-holds-a-number-that-is-048f = row { $row } holds a number that is not finite
diag-the-argument-in-row-is-not-f142 = the argument in row { $row } is not above the one before
diag-singular-matrix-no-pivot-in-column-de5d = singular matrix (no pivot in column { $column })
diag-a-matrix-of-the-eigenvalue-problem-a9ba = a matrix of the eigenvalue problem has an entry that is not finite
diag-the-eigenvalue-iteration-did-not-converge-94cd = the eigenvalue iteration did not converge
diag-every-number-is-an-eigenvalue-the-489e = every number is an eigenvalue: the determinant vanishes identically
diag-the-equations-are-not-defined-here-d632 = the equations are not defined here: { $why }
diag-cancelled-7c41 = cancelled

## laval-model/src/parts/balancer_ball/mod.rs

diag-a-track-has-balls-d20f = a track has { $n } balls
diag-give-a-whole-number-of-balls-054f = give a whole number of balls, at least 1, for each track
diag-the-tracks-have-more-than-balls-1d9d = the tracks have more than { $most } balls together
diag-give-fewer-balls-6bc4 = give fewer balls
diag-a-track-has-times-the-radius-4cd8 = a track has { $r } times the radius
diag-radius-is-a-positive-ratio-to-18f8 = radius is a positive ratio to track_radius
diag-a-track-is-tilted-by-more-dbfd = a track is tilted by more than 1.5 rad
diag-tilt-is-in-addition-to-that-0d1b = tilt is in addition to that of the balancer
diag-balls-is-the-number-on-all-f8b1 = balls is the number on all tracks together; leave it out, the tracks say how many each has
diag-balls-and-the-tracks-have-75ed = balls = { $n }, and the tracks have { $each } = { $all }
diag-mass-ratios-are-given-for-balls-a4df = { $given } mass ratios are given for { $balls } balls
diag-mass-ratios-are-given-for-balls-4735 = { $given } mass ratios are given for { $balls } balls on { $tracks } tracks
diag-one-ratio-for-each-ball-track-9a94 = one ratio for each ball, track by track
diag-the-tilt-of-the-tracks-locks-0ce0 = the tilt of the tracks locks the balls to the node line: r sin^2(tilt) = { $locking } should stay below a tenth of the eccentricity of the ring, { $tenth }
diag-a-free-ring-needs-inertia-about-cb88 = a free ring needs inertia about its node line: give diametral_inertia
diag-no-ring-has-a-polar-inertia-5c83 = no ring has a polar inertia ({ $polar_inertia }) above twice its diametral inertia ({ $diametral_inertia }); a thin ring has just twice
diag-acts-on-free-rings-and-these-e719 = { $field } acts on free rings, and these are fixed: give rings = "free" as well
diag-the-ring-centre-from-the-shaft-43cc = the ring centre ({ $s } from the shaft) lies outside the track (radius { $r })
diag-balls-do-not-fit-on-track-6b52 = { $n } balls do not fit on track { $number }: there is room for { $fits }
diag-balls-that-touch-and-balls-that-edac = balls that touch and balls that do not are different machines: build each by itself
diag-balls-that-touch-need-their-size-32af = balls that touch need their size: give ball_radius
diag-weight-acts-across-a-horizontal-axis-910f = weight acts across a horizontal axis, not along it: give gravity = 0 (the weight across the axis is known from the machine)

## laval-model/src/parts/bearing_cubic.rs

diag-the-force-no-longer-restores-beyond-d9b0 = the force no longer restores beyond a deflection of { $d }: it pushes away
diag-valid-to-the-deflection-the-law-7022 = valid_to, the deflection the law holds for
diag-softens-c1a5 = softens
diag-this-is-below-check-sign-and-761b = this is below { $place }; check sign and unit (N/m^3), or state the range of the law with valid_to
diag-an-isotropic-law-has-the-same-6751 = an isotropic law has the same { $field } in x and y
diag-give-one-value-or-use-law-a1f9 = give one value, or use law = "per_axis"

## laval-model/src/parts/bearing_hertz.rs

diag-a-radial-law-has-no-preload-346e = a radial law has no preload: its clearance cannot be negative
diag-use-law-per-axis-where-a-ac72 = use law = "per_axis", where a negative clearance is the interference of opposed contacts
diag-contact-angle-is-given-without-balls-aa45 = contact_angle is given without balls
diag-a-coefficient-holds-the-angle-already-7b11 = a coefficient holds the angle already: take contact_angle away
diag-the-bearing-has-no-contact-coefficient-5cac = the bearing has no contact coefficient
diag-give-coefficient-or-balls-and-ball-ccc8 = give coefficient, or balls and ball_diameter
diag-coefficient-is-given-beside-the-geometry-f29d = coefficient is given beside the geometry of the balls
diag-balls-is-given-without-ball-diameter-a70a = balls is given without ball_diameter
diag-ball-diameter-is-given-without-balls-6beb = ball_diameter is given without balls
diag-the-contact-coefficient-must-be-positive-11f4 = the contact coefficient must be positive
diag-a-hertz-contact-without-preload-has-e0b4 = a Hertz contact without preload has no stiffness at rest: give an amplitude to linearise at (a harmonic study does), a preload (law = "per_axis" with a negative clearance), or a bearing_cubic fitted over the amplitudes of interest

## laval-model/src/parts/bearing_journal.rs

diag-a-clearance-of-makes-no-film-3b22 = a clearance of { $clearance } makes no film at a diameter of { $diameter }: usual are 0.05 to 0.2 % of the diameter
diag-its-length-is-of-its-diameter-a9a3 = its length is { $ratio } of its diameter: the closed form of the short bearing holds up to 0.5, and from 1 on it is far too stiff

## laval-model/src/parts/bearing_linear/asynchronous.rs

diag-column-row-is-not-a-finite-b5da = column { $name }: row { $number } is not a finite number
diag-frequencies-of-vibration-are-not-negative-43a1 = frequencies of vibration are not negative: row { $number } has { $frequency }
diag-a-table-over-speed-and-frequency-ef2a = a table over speed and frequency has at least two frequencies; leave frequency out where the coefficients do not depend on it
diag-a-table-over-speed-and-frequency-9644 = a table over speed and frequency has at least two speeds
diag-rows-and-are-of-one-speed-2741 = rows { $first } and { $second } are of one speed and frequency: { $speed } and { $frequency }
diag-every-speed-of-the-table-has-5ca8 = every speed of the table has all its frequencies, { $all } rows: that of { $speed } at { $frequency } is missing
diag-every-speed-of-the-table-has-b24d = every speed of the table has all its frequencies, { $all } rows: { $count } are missing, the first of { $speed } at { $frequency }

## laval-model/src/parts/bearing_linear/mod.rs

diag-is-given-beside-bb0c = { $short } is given beside { $twice }
diag-stands-for-and-give-the-one-5d24 = { $short } stands for { $first } and { $second }: give the one value or these two
diag-the-bearing-has-no-coefficient-all-9c73 = the bearing has no coefficient: all eight are zero
diag-give-stiffness-or-kxx-and-kyy-27b3 = give stiffness, or kxx and kyy (and what else it has), or a table over speed
diag-beyond-is-given-without-a-table-38bd = beyond is given without a table
diag-constant-coefficients-hold-at-every-speed-c9f6 = constant coefficients hold at every speed: take beyond away, or give a table over speed
diag-is-given-as-a-constant-beside-d5bb = { $name } is given as a constant beside a table
diag-a-bearing-has-constant-coefficients-or-463b = a bearing has constant coefficients or a table: put constants into the table as equal rows
diag-this-bearing-was-built-without-kzz-bac1 = this bearing was built without kzz
diag-the-coefficients-come-from-the-table-544d = the coefficients come from the table: a constant beside it has no effect

## laval-model/src/parts/bearing_linear/table.rs

diag-column-has-rows-and-column-speed-849d = column { $name } has { $values } rows and column speed has { $speed }
diag-a-table-over-speed-has-at-7512 = a table over speed has at least two rows; for one speed give the coefficients themselves
diag-speeds-must-increase-from-row-to-61ab = speeds must increase from row to row: row { $number } has { $speed } after { $before }
diag-column-speed-e6ee = column speed: { $why }

## laval-model/src/parts/bearing_rolling.rs

diag-the-ratio-of-the-stiffnesses-is-f766 = the ratio of the stiffnesses is known from 8 to 16 rolling elements, not of { $count }
diag-give-ratio-the-stiffness-across-the-9a5b = give ratio: the stiffness across the load over that along it; it comes near 1 for many rolling elements under preload
diag-the-ratio-of-the-stiffnesses-is-dd9f = the ratio of the stiffnesses is known from 8 to 16 rolling elements

## laval-model/src/parts/constant_force.rs

diag-this-part-does-nothing-give-a-ce05 = this part does nothing: give a force or a moment
diag-this-force-was-built-without-d9df = this force was built without { $name }

## laval-model/src/parts/coupling.rs

diag-the-coupling-does-nothing-give-it-f96d = the coupling does nothing: give it a stiffness
diag-a-coupling-joins-shafts-of-one-3e2d = a coupling joins shafts of one speed; between shafts of different speeds use a gear or a bearing

## laval-model/src/parts/damper.rs

diag-rotating-damping-must-be-the-same-4a19 = rotating damping must be the same in x and y
diag-different-values-in-rotating-axes-would-4b5b = different values in rotating axes would make the machine's equations periodic in time
diag-this-damper-was-built-without-tilt-db59 = this damper was built without tilt

## laval-model/src/parts/disc.rs

diag-mass-is-it-must-be-0-a8a8 = mass is { $mass }; it must be 0, for a point without inertia, or at least { $least }
diag-has-no-effect-on-a-disc-44a1 = { $name } has no effect on a disc that another body carries
diag-it-moves-as-that-body-does-d19c = it moves as that body does: say { $name } of the body
diag-an-unbalance-of-a669 = an unbalance of { $u }
diag-sizes-are-positive-phase-180-deg-1024 = sizes are positive; phase = "180 deg" turns one round
diag-an-unbalance-has-no-place-4d16 = an unbalance has no place
diag-phase-is-an-angle-up-to-6ebd = phase is an angle up to 1000 rad, at a height up to 100 m
diag-the-height-of-an-unbalance-acts-aa0a = the height of an unbalance acts on the tilt, and this disc does not tilt
diag-give-diametral-inertia-as-well-or-5350 = give diametral_inertia as well, or leave at out
diag-no-body-has-a-polar-inertia-d7e0 = no body has a polar inertia ({ $polar_inertia }) above twice its diametral inertia ({ $diametral_inertia }); a thin disc has just twice
diag-acts-on-the-tilt-and-this-25d2 = { $field } acts on the tilt, and this disc does not tilt: give diametral_inertia as well

## laval-model/src/parts/gear.rs

diag-a-wheel-sits-on-a-turning-8ee2 = a wheel sits on a turning body, not on the ground
diag-name-the-two-shafts-or-discs-cbce = name the two shafts or discs that carry the wheels
diag-a-gear-joins-the-rotations-of-7f02 = a gear joins the rotations of two bodies: say torsional = true of both
diag-the-second-body-turns-times-as-56df = the second body turns { $ratio } times as fast as the first, and by the radii { $needed } times; give it a spin of that ratio

## laval-model/src/parts/liquid/check.rs

diag-the-free-surface-radius-lies-outside-6f91 = the free surface (radius { $value }) lies outside the cavity (radius { $radius })
diag-an-empty-a-partly-filled-and-0108 = an empty, a partly filled and a full cavity are different machines: build each by itself
diag-planar-knows-no-tilt-of-the-902a = planar knows no tilt of the cavity: give model = "strip" or "spatial" for a cavity that is skew
diag-a-liquid-with-viscosity-and-one-e51c = a liquid with viscosity and one without are different machines: build each by itself
diag-this-model-knows-no-viscosity-planar-a984 = this model knows no viscosity: planar, strip and spatial do
diag-a-full-cavity-with-viscosity-is-2bad = a full cavity with viscosity is not among the models: leave viscosity out, or a little air in
diag-the-viscosity-damps-the-wave-by-4b0e = the viscosity damps the wave by itself: give one of the two
diag-this-model-knows-no-wave-damping-8681 = this model knows no wave damping: spatial takes a viscosity

## laval-model/src/parts/liquid/mod.rs

diag-the-free-surface-is-the-inner-bfe9 = the free surface is the inner face of the layer on the wall: 0 is full, the cavity radius is empty
diag-this-is-times-what-the-cavity-e6e6 = this is { $fraction } times what the cavity holds
diag-the-cavity-holds-of-this-liquid-6415 = the cavity holds { $cavity }, { $density } of this liquid
diag-only-odd-harmonics-act-on-a-e4ca = only odd harmonics act on a tilt, and the last one is to be odd
diag-give-axial-harmonics-or-dfc4 = give axial_harmonics = { $less } or { $more }
diag-has-no-axial-harmonics-9a50 = { $word } has no axial harmonics
diag-model-spatial-has-them-leave-axial-677f = model = "spatial" has them; leave axial_harmonics out otherwise
diag-without-viscosity-is-exact-in-time-1ca0 = { $word } without viscosity is exact in time
diag-leave-time-error-out-with-model-2e83 = leave time_error out; with model = "spatial" or a viscosity it sets the number of waves
diag-planar-tilt-takes-from-the-tilt-aab4 = planar_tilt takes { $taken } from the tilt inertia of a cavity as tall as this: strip and spatial do not
diag-give-model-strip-or-spatial-or-9e71 = give model = "strip" or "spatial"; or the body more diametral_inertia

## laval-model/src/parts/liquid/timed.rs

diag-its-waves-are-computed-up-to-7190 = its waves are computed up to axial_harmonics = { $most }; leave axial_harmonics out for all of them
diag-waves-d3ee = { $n } waves
diag-that-of-a-cavity-that-is-b496 = that of a cavity that is skew to its shaft holds at constant speed only
diag-the-layer-of-a-viscous-liquid-2e6d = the layer of a viscous liquid depends on the speed, so that its form is made for one; transient and basins run at one
diag-the-layer-of-a-viscous-liquid-1419 = the layer of a viscous liquid depends on the speed, so that its form holds at constant speed only
diag-do-not-give-its-reaction-with-e64e = { $most } do not give its reaction with a relative error of { $allowed }; allow a larger time_error
diag-without-spin-nothing-holds-the-layer-f2d3 = without spin nothing holds the layer on the wall
diag-give-the-study-a-speed-above-e978 = give the study a speed above 0; for a machine that stands still model = "frozen" without viscosity counts the liquid as a mass
diag-try-time-error-64e7 = try time_error = { $reached }
diag-allow-a-larger-time-error-b71c = allow a larger time_error
diag-do-not-give-its-reaction-on-8989 = { $most } do not give its reaction on { $of } with a relative error of { $allowed }; { $larger }{ $strip }
diag-its-reaction-on-cannot-be-computed-87db = its reaction on { $of } cannot be computed to a tenth of the error allowed, { $allowed }, for all motions up to four times the speed{ $strip }
diag-finding-the-form-of-its-reaction-e706 = finding the form of its reaction on { $of } takes too much work; allow a larger time_error{ $strip }
diag-displacement-4336 = displacement
diag-poles-23e2 = { $n } poles
diag-tilt-023c = tilt
diag-or-model-strip-9bf1 = , or model = "strip"
diag-its-form-in-the-time-domain-7c9b = its form in the time domain was made for another cavity; its size and its filling cannot be varied here

## laval-model/src/parts/motor.rs

diag-a-motor-with-curve-needs-2cf6 = a motor with curve = "{ $word }" needs { $name }
diag-add-10f4 = add { $name }
diag-a-motor-with-curve-table-needs-b9a6 = a motor with curve = "table" needs a table
diag-add-table-43fb = add table = {"{"} speed = [..], share = [..] {"}"}
diag-the-torque-cannot-be-interpolated-7b6d = the torque cannot be interpolated: { $why }
diag-speeds-must-increase-from-row-to-ac99 = speeds must increase from row to row
diag-a-table-is-given-beside-curve-91c7 = a table is given beside curve = "{ $word }"
diag-say-curve-table-or-take-the-6386 = say curve = "table", or take the table away
diag-the-torque-curve-needs-a-synchronous-b5c7 = the torque curve needs a synchronous_speed above 0
diag-limited-power-needs-a-torque-and-2f00 = limited power needs a torque and a power above 0

## laval-model/src/parts/shaft/layer.rs

diag-layer-the-inner-diameter-must-be-f017 = layer { $number }: the inner diameter must be less than the outer one
diag-inner-diameter-is-that-of-the-d9f3 = inner_diameter is that of the shaft under a sleeve
diag-layer-has-no-material-modulus-shear-103d = layer { $number } has no material: modulus, shear_modulus and density are those of a solid, and stiffness is a share from 0 to 1
diag-leave-out-what-it-has-in-944a = leave out what it has in common with the shaft; stiffness = 0 is a layer with mass alone
diag-layer-goes-from-to-e940 = layer { $number } goes from { $from } to { $to }
diag-it-lies-on-the-shaft-from-d944 = it lies on the shaft, from its lower to its upper end: between 0 and { $length }

## laval-model/src/parts/shaft/mod.rs

diag-a-shaft-has-1-to-sections-a510 = a shaft has 1 to { $most } sections
diag-give-each-section-one-entry-in-0a0d = give each section one entry in every list
diag-a-section-is-long-06c8 = a section is { $length } long
diag-lengths-are-between-1-m-and-249f = lengths are between 1 µm and 1 km
diag-the-outer-diameter-of-a-section-ec18 = the outer diameter of a section is { $diameter }
diag-diameters-are-between-1-m-and-c7e8 = diameters are between 1 µm and 100 m
diag-a-shaft-of-elements-bead = a shaft of { $elements } elements
diag-it-has-at-most-6555 = it has at most { $most }
diag-section-the-inner-diameter-must-be-eed5 = section { $number }: the inner diameter must be less than the outer one
diag-layer-overlaps-the-shaft-at-its-d014 = layer { $number } overlaps the shaft at { $position }: its inner diameter is { $inner }, the outer diameter of the shaft there { $outer }
diag-layers-and-are-in-the-same-4df9 = layers { $first } and { $second } are in the same space at { $position }
diag-modulus-and-shear-modulus-make-a-9d86 = modulus and shear_modulus make a Poisson's ratio of { $nu }, which no metal has: E = 2 G (1 + nu)
diag-it-is-long-and-up-to-8cad = it is { $length } long and up to { $diameter } thick: lengths without a unit are in metres
diag-a-compression-of-buckles-it-unless-2945 = a compression of { $force } buckles it, unless bearings between its ends hold it: with both ends clamped it bears { $limit } at most

## laval-model/src/parts/shaft_lumped.rs

diag-is-given-without-a-diameter-3d73 = { $name } is given without a diameter
diag-a-round-shaft-takes-diameter-below-a7a1 = a round shaft takes diameter, below or above or both; a stated stiffness takes none of them
diag-the-shaft-has-no-stiffness-13d9 = the shaft has no stiffness
diag-give-stiffness-or-the-diameter-of-f6c0 = give stiffness, or the diameter of a round shaft and its length below or above the point
diag-a-shaft-with-material-damping-must-c344 = a shaft with material damping must be equally stiff in x and y
diag-unequal-stiffness-in-fixed-axes-is-1ae5 = unequal stiffness in fixed axes is a support, which does not turn: use a damper part beside it
diag-cross-stiffness-is-at-most-sqrt-01fb = cross_stiffness is at most sqrt(kx ky) = { $limit }: more would push outwards
diag-coupling-is-at-most-sqrt-stiffness-3fd0 = coupling is at most sqrt(stiffness tilt_stiffness) = { $limit }: more would give energy when bent (a clamped shaft has 0.87 of that)
diag-this-shaft-was-built-without-tilt-fed7 = this shaft was built without tilt
diag-this-shaft-was-built-without-material-7603 = this shaft was built without material damping
diag-this-shaft-was-built-from-its-1847 = this shaft was built from its stiffness
diag-is-given-beside-the-diameter-of-1b3b = { $name } is given beside the diameter of a round shaft
diag-the-stiffness-follows-from-the-geometry-5348 = the stiffness follows from the geometry: take one of them away
diag-is-given-without-the-length-5c8d = { $end } is given without the length { $length }
diag-give-as-well-or-take-away-4a55 = give { $length } as well, or take { $end } away
diag-a-round-shaft-needs-a-length-8bde = a round shaft needs a length
diag-give-below-the-length-from-its-37dc = give below, the length from its lower end to the point, or above, or both
diag-inner-diameter-is-less-than-diameter-22f4 = inner_diameter is less than diameter
diag-is-at-least-0bb6 = { $name } is at least { $value }
diag-this-shaft-was-built-without-bd20 = this shaft was built without { $name }
diag-a-shaft-pinned-at-its-only-7de2 = a shaft pinned at its only end holds nothing: clamp it, or give its other end
diag-the-stiffness-of-this-shaft-follows-b189 = the stiffness of this shaft follows from its geometry

## laval-model/src/parts/shaft_viscoelastic/mod.rs

diag-the-material-creeps-without-bound-in-8145 = the material creeps without bound: in the long run it would keep 1 - K(0) = { $kept } of its stiffness, which must stay above 0; this kernel is admissible below { $share } of its amplitude
diag-give-amplitude-exponent-and-decay-of-e770 = give amplitude, exponent and decay of one weakly singular term, or several terms, or exponentials
diag-the-memory-of-the-material-is-3490 = the memory of the material is given twice: { $second } beside { $first }
diag-columns-share-and-rate-need-equally-dc8a = columns share and rate need equally many rows, at least one
diag-row-a-share-is-not-negative-fdba = row { $row }: a share is not negative, and a rate lies between 0 and 1e12 1/s
diag-the-memory-of-the-material-is-6cac = the memory of the material is not given
diag-the-kernel-a-t-a-1-3db1 = the kernel A t^(a-1) exp(-b t) needs its { $missing } beside { $given }
diag-columns-amplitude-exponent-and-decay-need-7b2b = columns amplitude, exponent and decay need equally many rows, at least one
diag-row-of-the-terms-is-no-14f0 = row { $number } of the terms is no kernel: amplitude 0 or more, exponent above 0 and at most 0.99, decay above 0
diag-lower-the-amplitude-or-raise-the-adb9 = lower the amplitude, or raise the decay: a kernel that decays slowly relaxes more
diag-more-than-exponentials-would-be-needed-ac2b = more than { $most } exponentials would be needed for this kernel, accuracy and band in time
diag-request-less-accuracy-a-narrower-band-022e = request less accuracy, a narrower band, or give a faster decay
diag-the-shaft-has-no-stiffness-give-ad68 = the shaft has no stiffness: give it, or say with supports how a round shaft is held
diag-supports-needs-the-of-the-shaft-8082 = supports = "{ $word }" needs the { $name } of the shaft
diag-has-no-effect-with-supports-6287 = { $name } has no effect with supports = "{ $word }"
diag-the-disc-at-is-not-between-4718 = the disc at { $x } is not between supports at a distance of { $l }
diag-the-exponentials-were-chosen-for-another-1eef = the exponentials were chosen for another kernel and miss this one by more than their accuracy: build the machine with it, or widen band
diag-amplitude-exponent-and-decay-have-no-58ce = amplitude, exponent and decay have no effect beside several terms
diag-amplitude-exponent-and-decay-have-no-4e1d = amplitude, exponent and decay have no effect beside exponentials

## laval-model/src/parts/speed_ratio.rs

diag-a-spin-of-ratio-0-stands-f193 = a spin of ratio 0 stands still: parts that do not turn need none

## laval-model/src/parts/spin_load.rs

diag-this-part-does-nothing-give-inertia-1f62 = this part does nothing: give inertia, drag or windage

## laval-model/src/units/mod.rs

diag-is-needed-and-has-no-unit-a022 = { $wanted } is needed, and { $digits } has no unit
diag-write-the-unit-behind-the-number-6a68 = write the unit behind the number ({ $examples }); without quotes a number is in { $expected }
diag-a-pure-number-0885 = a pure number
diag-is-needed-is-f561 = { $need } is needed ({ $ex }); { $text } is { $is }
diag-lb-is-a-mass-the-force-a3b2 = lb is a mass; the force is lbf: write { $meant }
diag-is-needed-leaves-open-whether-turns-c66a = { $need } is needed ({ $ex }); { $text } leaves open whether turns or radians are meant
diag-for-turns-write-rpm-hz-or-aed2 = for turns write rpm, Hz or rev; for radians write rad
diag-is-needed-is-a-torque-9c88 = { $need } is needed ({ $ex }); { $text } is a torque
diag-is-needed-is-an-energy-4e75 = { $need } is needed ({ $ex }); { $text } is an energy

## laval-model/src/units/parse.rs

diag-this-is-not-a-number-3ddb = this is not a number
diag-the-number-is-too-large-d1af = the number is too large
diag-the-number-is-too-small-to-26fc = the number is too small to be distinguished from 0
diag-a-finite-number-is-needed-not-7676 = a finite number is needed, not { $head }
diag-this-text-is-empty-267d = this text is empty
diag-begins-with-no-number-ac94 = { $text } begins with no number
diag-a-quantity-is-a-number-and-9dba = a quantity is a number and a unit; { $what }
diag-write-it-as-in-70-mm-3a41 = write it as in "70 mm"
diag-has-a-comma-in-its-number-f608 = { $text } has a comma in its number
diag-write-the-decimal-point-as-in-e955 = write the decimal point, as in "1.5 mm", and no separators
diag-has-a-space-inside-its-number-6e0d = { $text } has a space inside its number
diag-write-the-digits-together-as-in-4256 = write the digits together, as in "3000 rpm"
diag-writes-a-power-of-ten-in-9497 = { $text } writes a power of ten in words
diag-write-it-as-in-1-1e7-c4a9 = write it as in "1.1e7 N/m"
diag-has-two-decimal-points-edcf = { $text } has two decimal points
diag-write-the-number-as-in-1-bee8 = write the number as in "1.5 mm", without separators
diag-is-too-long-for-a-unit-846f = { $text } is too long for a unit
diag-does-not-belong-in-a-unit-043f = { $text } does not belong in a unit
diag-a-temperature-in-degc-stands-alone-276c = a temperature in degC stands alone
diag-for-differences-and-in-products-write-9698 = for differences and in products write K
diag-this-unit-is-out-of-all-3847 = this unit is out of all bounds
diag-a-unit-cannot-begin-with-a-1143 = a unit cannot begin with a product sign
diag-has-two-readings-is-what-follows-4dcc = { $whole } has two readings: is what follows the / and a space above or below it?
diag-put-products-below-a-in-parentheses-42fc = put products below a / in parentheses, as in N/(m s), or write them first, as in N s/m
diag-too-many-parentheses-45b6 = too many parentheses
diag-a-closing-parenthesis-is-missing-6a33 = a closing parenthesis is missing
diag-nothing-fcf7 = nothing
diag-a-unit-is-expected-here-not-6ef4 = a unit is expected here, not { $what }
diag-is-not-a-known-unit-cbb5 = { $word } is not a known unit
diag-did-you-mean-fa5e = did you mean { $near }?
diag-a-closing-parenthesis-is-missing-in-1333 = a closing parenthesis is missing in a power
diag-this-power-is-not-between-20-2848 = this power is not between -20 and 20, or is 0
diag-a-power-is-a-number-as-f8ee = a power is a number, as in m^2, m^1.5 or m^(10/9)

## laval-model/src/units/table.rs

diag-a-quantity-in-af40 = a quantity in { $unit }

## laval-solve/src/co_rotating.rs

diag-from-the-undeflected-machine-no-state-da81 = from the undeflected machine no state that turns with the rotor was found
diag-the-machine-has-no-state-that-5f47 = the machine has no state that turns with the rotor: { $reason }
diag-studies-about-rest-about-rest-by-e3da = studies about rest (about = "rest"), by harmonics, and in time (transient, run_up) take such a machine
diag-the-machine-has-no-equilibrium-at-cc55 = the machine has no equilibrium at rest either: transient and run_up give the motion in time
diag-the-weight-of-pulls-to-one-fdd8 = the weight of "{ $name }" pulls to one side (axis = "horizontal")
diag-differs-in-x-and-y-a4f1 = { $base } differs in x ({ $x } { $unit }) and y ({ $y } { $unit })
diag-the-forces-of-do-not-turn-00ed = the forces of "{ $name }" ({ $kind }) do not turn along when machine and state are turned

## laval-solve/src/ensemble/mod.rs

diag-has-memory-states-which-an-explicit-422f = "{ $name }" has memory states, which an explicit method cannot follow
diag-use-method-stiff-baf2 = use method = "stiff"

## laval-solve/src/harmonic/balance/refused.rs

diag-order-of-the-motion-would-lie-2fd8 = order { $orders } of the motion would lie inside the dense range of { $waves } of { $name }, from { $a } to { $b } at { $speed }, where it has no steady response
diag-orders-of-the-motion-would-lie-8d8e = orders { $orders } of the motion would lie inside the dense range of { $waves } of { $name }, from { $a } to { $b } at { $speed }, where it has no steady response
diag-with-symmetry-half-where-the-law-928a = { $remedy }; with symmetry = "half", where the law has it, only odd orders move
diag-the-machine-has-no-periodic-motion-32a0 = the machine has no periodic motion at some order: { $why }
diag-a-body-without-any-spring-drifts-536a = a body without any spring drifts; a coordinate without mass, damping and stiffness is undetermined

## laval-solve/src/harmonic/branches/response.rs

diag-the-machine-is-symmetric-by-any-0931 = the machine is symmetric by any turn: its motion is computed as circular, of order 1 alone, and none of { $divisor } turns is among these
diag-leave-subharmonic-out-or-write-symmetry-70a8 = leave subharmonic out, or write symmetry = "none" to keep more orders
diag-leave-subharmonic-out-or-write-symmetry-a746 = leave subharmonic out, or write symmetry = "half" or "none" to keep more orders
diag-the-machine-has-no-symmetry-by-0c76 = the machine has no symmetry by { $symmetry }: part "{ $part }" changes when turned
diag-the-machine-has-no-symmetry-by-3964 = the machine has no symmetry by { $symmetry }
diag-use-symmetry-auto-this-machine-is-2aec = use symmetry = "auto"; this machine is symmetric by { $symmetry }
diag-no-periodic-motion-was-found-at-47e1 = no periodic motion was found at { $lo } nor at { $hi }
diag-integrate-the-machine-in-time-transient-0e26 = integrate the machine in time (transient, sweep): its motion may not repeat after one turn, or not at all
diag-the-response-cannot-be-followed-ba98 = the response cannot be followed: { $e }

## laval-solve/src/harmonic/free/backbone.rs

diag-all-parts-of-this-machine-are-e65c = all parts of this machine are linear: its free whirls have the same frequency at any amplitude
diag-use-modes-or-campbell-for-these-cd7a = use modes or campbell for these frequencies
diag-the-family-cannot-be-followed-5ca8 = the family cannot be followed: { $e }
diag-the-asymptotes-could-not-be-computed-1ebf = the asymptotes could not be computed: { $why }

## laval-solve/src/harmonic/free/cycles.rs

diag-all-parts-of-this-machine-are-26e6 = all parts of this machine are linear: where it is unstable its whirl grows without bound
diag-use-stability-map-for-the-ranges-5a82 = use stability_map for the ranges of speed in which it does
diag-nothing-damps-this-machine-its-free-59a9 = nothing damps this machine: its free whirls form families of every amplitude, and none of them is a limit cycle
diag-use-backbone-for-the-families-or-b5f7 = use backbone for the families, or give the machine damping ({ $by })
diag-use-backbone-for-the-families-or-cf95 = use backbone for the families, or give the machine damping
diag-the-cycles-cannot-be-followed-0df2 = the cycles cannot be followed: { $e }

## laval-solve/src/harmonic/free/whirl.rs

diag-the-force-of-depends-on-the-5b01 = the force of "{ $name }" depends on the angle of the rotor or on time: this machine has no free motion
diag-use-nonlinear-response-for-the-motion-1f45 = use nonlinear_response for the motion that is forced, or a transient

## laval-solve/src/harmonic/loci/chain.rs

diag-the-locus-cannot-be-followed-7127 = the locus cannot be followed: { $e }

## laval-solve/src/harmonic/loci/existence.rs

diag-choose-another-range-of-the-parameter-8d88 = choose another range of the parameter
diag-the-machine-does-not-exist-at-9578 = the machine does not exist at any value tried of { $path }: { $why }
diag-the-machine-does-not-exist-at-b3f3 = the machine does not exist at any value tried of { $path }
diag-the-machine-exists-at-a-single-e5fd = the machine exists at a single value of { $path } in this range

## laval-solve/src/harmonic/stability/floquet.rs

diag-has-no-time-domain-form-4e95 = "{ $part }" has no time-domain form: { $why }
diag-the-machine-has-first-order-states-7ed4 = the machine has { $n } first-order states, more than the map of a period can carry
diag-the-force-of-jumps-when-it-ebe9 = the force of "{ $part }" jumps when it touches, and what such a jump does to a disturbance is not computed
diag-a-coordinate-has-no-mass-1332 = a coordinate has no mass

## laval-solve/src/motion/direct.rs

diag-the-spin-angle-451f = the spin angle
diag-the-mass-matrix-is-singular-no-91ea = the mass matrix is singular: no inertia of its own is left for { $place }
diag-no-places-of-the-coordinates-without-3d01 = no places of the coordinates without inertia balance their forces
diag-without-inertia-no-damping-or-stiffness-fdb8 = without inertia, no damping or stiffness determines { $place }
diag-the-mass-matrix-has-an-entry-344a = the mass matrix has an entry that is not finite (at { $place })

## laval-solve/src/motion/mod.rs

diag-the-machine-has-no-equations-of-754e = the machine has no equations of motion: { $what }
diag-a-coordinate-follows-from-inertia-or-9b2d = a coordinate follows from inertia, or without it from a damper or a spring that holds it: give the part that owns it a mass or hold it, and give a spin that is free a moment of inertia about the axis

## laval-solve/src/motion/trajectory.rs

diag-the-motion-cannot-be-computed-from-98a8 = the motion cannot be computed from its start: { $what }

## laval-solve/src/own_frequency/mod.rs

diag-the-tables-of-have-no-frequencies-af27 = the tables of { $names } have no frequencies in common
diag-write-beyond-hold-or-beyond-linear-53dc = write beyond = "hold" or beyond = "linear" where a table may be left, or add rows
diag-no-part-of-this-machine-is-9c3e = no part of this machine is given in a table over the frequency of vibration

## laval-solve/src/pencil.rs

diag-is-given-in-the-frequency-domain-f133 = "{ $name }" is given in the frequency domain only: { $why }
diag-forced-response-works-with-it-and-dda6 = forced_response works with it, and modes about rest where the part says where it is analytic
diag-the-modes-at-could-not-be-a843 = the modes at { $speed } could not be computed: { $e }
diag-a-coordinate-with-neither-mass-damping-44a1 = a coordinate with neither mass, damping nor stiffness leaves the modes undetermined

## laval-solve/src/programme.rs

diag-the-speeds-must-be-finite-and-08cc = the speeds must be finite and the duration of the change positive
diag-an-exponential-change-never-reaches-or-b31b = an exponential change never reaches or leaves standstill: both speeds need the same sign
diag-a-polynomial-of-the-speed-has-15d4 = a polynomial of the speed has 1 to { $most } coefficients, not { $given }
diag-the-coefficients-must-be-finite-and-99d2 = the coefficients must be finite and the duration of the change positive
diag-a-table-of-speeds-needs-at-8eba = a table of speeds needs at least two points, and as many speeds as times
diag-times-and-speeds-must-be-finite-3507 = times and speeds must be finite
diag-the-times-must-increase-is-followed-8e71 = the times must increase; { $first } is followed by { $second }
diag-the-speed-changes-faster-than-can-3094 = the speed changes faster than can be computed

## laval-solve/src/rest.rs

diag-the-machine-has-no-rest-the-72b5 = the machine has no rest: the force of "{ $name }" turns with the rotor
diag-transient-gives-the-motion-in-time-681b = transient gives the motion in time
diag-stationary-gives-the-states-that-turn-c025 = stationary gives the states that turn with the rotor and their stability, transient and run_up the motion in time
diag-transient-and-run-up-give-the-0238 = transient and run_up give the motion in time
diag-cannot-be-linearised-at-rest-01cd = "{ $name }" cannot be linearised at rest: { $reason }
diag-use-a-nonlinear-study-or-one-c104 = use a nonlinear study or one in time, or give the part a preload
diag-the-machine-has-no-equilibrium-under-d65d = the machine has no equilibrium under its loads: some coordinate is not held by any stiffness
diag-attach-a-bearing-shaft-or-foundation-b11e = attach a bearing, shaft or foundation to every body that carries a load; masses that move freely, such as the balls of a balancer, have no equilibrium at rest: { $free }
diag-no-equilibrium-was-found-newton-s-d993 = no equilibrium was found (Newton's method stopped with a step of { $step } typical sizes)
diag-check-the-load-and-the-characteristics-cdab = check the load and the characteristics of nonlinear parts, or start from another state

## laval-solve/src/roots/mod.rs

diag-a-part-without-time-form-is-6af5 = a part without time form is linearised about rest only
diag-leave-about-out-067c = leave about out
diag-does-not-say-where-its-dynamic-c7f1 = "{ $name }" does not say where its dynamic stiffness is analytic
diag-without-that-no-roots-can-be-e4c1 = without that no roots can be counted; forced_response works with it
diag-the-frequencies-of-the-machine-have-ce0d = the frequencies of the machine have no bound from which roots could be counted
diag-give-frequency-limit-df65 = give frequency_limit

## laval-solve/src/support_map/mod.rs

diag-is-not-given-by-mass-gyroscopic-1bec = "{ $name }" is not given by mass, gyroscopic and stiffness matrices, and it is no support that the map replaces
diag-name-it-in-supports-if-it-35db = name it in supports if it is one; otherwise campbell and critical_speeds take every part

## laval-separation/src/batch.rs

diag-no-path-in-space-5c87 = no path in space

## laval-separation/src/carried.rs

diag-cups-swing-out-against-a-weight-0f4e = cups swing out against a weight along the axis, which a horizontal machine has not; say at which tilt they are held

## laval-separation/src/law.rs

diag-the-shares-below-must-rise-from-712b = the shares below must rise from 0 to 1
diag-the-last-share-below-is-it-e864 = the last share below is { $last }; it must be 1
diag-the-shares-of-the-classes-must-211d = the shares of the classes must not be negative, and not all zero
diag-values-have-shares-6d11 = { $values } values have { $shares } shares
diag-the-values-must-be-positive-and-34e1 = the values must be positive and increase from row to row

## laval-separation/src/motion.rs

diag-the-drag-law-changes-its-piece-c2a7 = the drag law changes its piece again and again at { $t }
diag-the-step-became-too-small-at-f4f4 = the step became too small at { $t }
diag-stopped-at-after-steps-69bb = stopped at { $t } after { $steps } steps

## laval-separation/src/recovery.rs

diag-stopped-9dac = stopped

## laval-separation/src/slowest.rs

diag-no-place-of-the-liquid-is-aad6 = no place of the liquid is found where a path begins

## laval/src/cases/design.rs

diag-is-no-value-9845 = { $path }: { $x } is no value
diag-the-grid-has-more-points-than-9c74 = the grid has more points than can be counted
diag-the-values-of-a-list-lie-32f5 = the values of a list lie in the folder of its cases
diag-the-design-has-no-case-22d6 = the design has no case
diag-cases-are-more-than-can-be-6c04 = { $cases } cases are more than can be numbered
diag-cannot-read-9ee9 = cannot read { $path }: { $e }
diag-is-damaged-6361 = { $path } is damaged
diag-parameters-are-more-than-the-dimensions-aac5 = { $k } parameters are more than the { $most } dimensions of the Sobol sequence
diag-and-are-the-same-parameter-dc84 = "{ $first }" and "{ $second }" are the same parameter

## laval/src/cases/mod.rs

diag-the-machine-has-no-study-026d = the machine has no study "{ $name }"
diag-files-of-cases-with-numbers-each-e703 = files of { $rows } cases with { $columns } numbers each are too large: at most { $most } numbers in a file
diag-stopped-before-the-first-case-3403 = stopped before the first case
diag-the-study-has-no-numbers-for-11b4 = the study has no numbers for this machine: { $why }

## laval/src/file/assemble.rs

diag-its-studies-2ae7 = its studies: { $all }
diag-the-machine-has-no-study-1dcb = the machine has no study "{ $word }"
diag-give-about-turning-or-c5d1 = give { $studies } about = "turning"; or { $or }
diag-give-about-turning-e2db = give { $studies } about = "turning"
diag-study-713d = study { $one }
diag-studies-a7da = studies { $names }
diag-the-machine-has-coordinates-and-states-452d = the machine has { $n } coordinates and { $m } states of parts; at most { $most } together are computed
diag-cannot-be-built-from-what-is-17a3 = { $kind } "{ $name }" cannot be built from what is given
diag-gives-a-force-that-is-not-403d = { $kind } "{ $name }" gives a force that is not a finite number
diag-a-value-of-this-part-is-16e4 = a value of this part is too large or too small to compute with

## laval/src/file/blocks.rs

diag-the-machine-has-no-parts-7f63 = the machine has no parts
diag-describe-each-part-in-a-block-256d = describe each part in a block that begins with [[part]]
diag-there-is-one-in-a-file-3572 = there is one { $word } in a file
diag-double-brackets-f6a7 = double brackets
diag-must-be-a-block-394a = { $word } must be a block
diag-write-with-single-brackets-once-and-c02a = write [{ $word }], with single brackets, once, and its keys below
diag-a-is-a-part-write-part-f85c = a { $key } is a part: write [[part]] and below it kind = "{ $key }"
diag-is-a-study-write-study-and-f8f8 = { $key } is a study: write [[study]] and below it kind = "{ $key }"
diag-every-key-stands-in-a-block-7dc3 = every key stands in a block: [machine], [[part]] or [[study]]; { $name } belongs below [machine]
diag-every-key-stands-in-a-block-8b85 = every key stands in a block: [machine], [[part]] or [[study]]
diag-a-file-has-one-machine-and-cd0f = a file has one [machine], and blocks [[part]] and [[study]]
diag-a-file-has-one-machine-and-ffdb = a file has one [machine], and blocks [[part]] and [[study]]; also { $beside }
diag-is-not-a-block-of-a-3d1c = { $key } is not a block of a machine file
diag-unknown-04cc = unknown
diag-must-be-a-block-f338 = { $what } must be a block
diag-write-and-its-keys-below-0c3c = write [[{ $what }]] and its keys below
diag-a-must-be-a-block-not-807b = a { $what } must be a block, not { $shape }
diag-two-blocks-are-named-4142 = two blocks [[{ $what }]] are named { $name }
diag-two-blocks-are-named-apart-from-7b57 = two blocks [[{ $what }]] are named { $name } (apart from capitals the same as { $first })
diag-taken-above-5dad = taken above
diag-give-each-its-own-name-others-21ca = give each its own name; others refer to it by that name
diag-has-no-key-beb0 = { $who } has no key { $key }
diag-it-stands-inside-06c3 = it stands inside { $f }: { $f } = {"{"} { $key } = .. {"}"}
diag-did-you-mean-its-keys-68cd = did you mean { $near }? Its keys: { $all }
diag-its-keys-4d57 = its keys: { $all }
diag-unknown-key-b3fe = unknown key
diag-needs-d775 = { $who } needs { $name }: { $doc }
diag-add-605c = add { $example }
diag-is-missing-e95c = { $name } = .. is missing
diag-the-file-has-no-machine-block-3137 = the file has no [machine] block
diag-begin-it-with-machine-and-below-3516 = begin it with [machine] and, below, name = ".." and speed = "3000 rpm"

## laval/src/file/constructed.rs

diag-there-is-no-kind-of-study-7368 = there is no kind of study "{ $kind }"
diag-there-is-59f4 = there is { $all }
diag-the-study-cannot-be-made-from-9149 = the study cannot be made from these fields
diag-the-fields-of-are-an-object-9722 = the fields of { $kind } are an object, not { $shape }
diag-write-df54 = write {"{"} "speed": 300.0 {"}"}

## laval/src/file/declared.rs

diag-the-declared-default-cannot-be-used-a68d = the declared default { $default } cannot be used: { $text }
diag-is-not-an-si-unit-b335 = { $kind }.{ $name }: { $unit } is not an SI unit

## laval/src/file/edits.rs

diag-the-file-has-no-number-bda7 = the file has no number "{ $path }"
diag-two-changes-are-of-the-same-1bd6 = two changes are of the same place in the file
diag-is-not-written-in-the-file-f870 = { $path } is not written in the file
diag-is-it-must-be-06bd = { $who } is { $value }; it must be { $bounds }
diag-is-no-quantity-296e = { $text } is no quantity

## laval/src/file/held.rs

diag-nothing-holds-the-tilt-of-alone-ad2e = nothing holds the tilt of "{ $name }" ({ $names }), alone or with that of the bodies it is joined to
diag-hold-it-at-a-second-place-041d = hold it at a second place: attach another bearing
diag-let-a-shaft-act-on-the-94fc = let a shaft act on the tilt (tilt_stiffness, or a round shaft), hold the body at two heights, or leave out its diametral_inertia: then it does not tilt
diag-nothing-holds-in-it-can-move-41a0 = nothing holds "{ $name }" in { $names }: it can move away, alone or with the bodies it is joined to
diag-join-it-to-ground-or-to-f640 = join it to "ground" or to a foundation with a bearing or a shaft; a damper holds nothing in place
diag-nothing-holds-along-the-axis-dda5 = nothing holds "{ $name }" along the axis
diag-give-a-bearing-its-kzz-or-f5a6 = give a bearing its kzz, or a coupling its axial_stiffness
diag-nothing-holds-the-rotation-of-about-508e = nothing holds the rotation of "{ $name }" about the axis, alone or with what it is joined to or in mesh with: it may turn faster or slower than the spin
diag-modes-show-this-rotation-at-0-d9cb = modes show this rotation at 0 Hz, which is no instability; a coupling with torsional_stiffness to "ground" joins it to a drive at the spin speed
diag-of-has-no-effect-what-it-e0f8 = { $name } of "{ $slot }" has no effect: what it is joined to does not tilt
diag-give-a-disc-its-diametral-inertia-7912 = give a disc its diametral_inertia to let it tilt
diag-the-moment-of-has-no-effect-5998 = the moment of "{ $name }" has no effect: what it acts on does not tilt
diag-no-part-turns-with-c0c8 = no part turns with "{ $name }"
diag-name-it-in-a-shaft-or-b28c = name it in a shaft or disc: spin = "{ $name }"
diag-acts-along-the-axis-without-effect-7085 = "{ $name }" acts along the axis without effect: what it is joined to does not move along it
diag-say-axial-true-of-the-shaft-de0a = say axial = true of the shaft or disc
diag-acts-about-the-axis-without-effect-88c2 = "{ $name }" acts about the axis without effect: what it is joined to does not twist
diag-say-torsional-true-of-the-shaft-8e85 = say torsional = true of the shaft or disc
diag-is-clamped-at-which-does-not-8696 = "{ $name }" is clamped at "{ $body }", which does not tilt
diag-give-its-to-let-it-tilt-696b = give "{ $body }" its { $lets } to let it tilt

## laval/src/file/joints.rs

diag-this-machine-has-no-body-add-f649 = this machine has no body: add a part such as a disc
diag-bodies-of-this-machine-e555 = bodies of this machine: { $all }
diag-is-attached-to-which-does-not-e3d3 = { $kind } "{ $block }" is attached to "{ $name }", which does not exist
diag-no-such-body-1f1f = no such body
diag-is-attached-to-which-is-a-ef10 = { $kind } "{ $block }" is attached to "{ $name }", which is a { $other } and not a body
diag-not-a-body-2491 = not a body
diag-is-attached-to-e4e1 = { $kind } "{ $block }" is attached to "{ $name }": { $beyond }
diag-not-on-the-body-23cd = not on the body
diag-the-position-on-has-no-effect-fbb2 = the position on "{ $name }" has no effect: that { $kind } does not tilt
diag-no-effect-04cf = no effect

## laval/src/file/mod.rs

diag-the-kind-of-is-declared-twice-ad11 = the kind of { $what } { $kind } is declared twice
diag-declares-the-key-twice-abcf = { $kind } declares the key { $name } twice

## laval/src/file/names.rs

diag-unknown-parameter-af90 = unknown parameter
diag-coordinates-of-this-machine-baed = coordinates of this machine: { $all }
diag-there-is-no-coordinate-e0c3 = there is no coordinate "{ $name }"
diag-unknown-coordinate-5bfd = unknown coordinate

## laval/src/file/naming.rs

diag-write-kind-not-type-4ed8 = write kind = { $t }, not type
diag-write-kind-with-one-of-9d60 = write kind = ".." with one of: { $all }
diag-this-says-no-kind-ea9b = this { $block } says no kind
diag-kind-is-missing-ef9a = kind = ".." is missing
diag-kind-must-be-a-word-in-cd0b = { $block }: kind must be a word in quotes, not { $shape }
diag-there-is-no-kind-of-called-2deb = there is no kind of { $what } called { $t }
diag-unknown-kind-35ae = unknown kind
diag-kinds-of-studies-de0a = kinds of studies: { $all }
diag-kinds-of-s-5328 = kinds of { $what }s: { $all }
diag-the-name-of-a-must-be-68d4 = the name of a { $what } must be a text in quotes, not { $shape }
diag-a-cannot-be-named-ground-fe8c = a { $what } cannot be named "ground"
diag-reserved-1e48 = reserved
diag-ground-is-the-fixed-surroundings-that-f758 = "ground" is the fixed surroundings that parts may be attached to
diag-cannot-be-the-name-of-a-90a3 = { $t } cannot be the name of a { $what }
diag-not-a-name-8729 = not a name
diag-a-name-is-made-of-letters-2e08 = a name is made of letters of any script, digits, spaces, _ and -, begins with a letter or digit and has at most 64 characters
diag-for-instance-5228 = for instance { $name }: { $help }

## laval/src/file/nested.rs

diag-write-the-name-of-a-study-e443 = write the name of a study of this file, or { $example }
diag-a-study-76fb = a study
diag-studies-of-this-file-that-can-5f25 = studies of this file that can be run: { $all }
diag-add-such-a-study-to-this-bcab = add such a study to this file, or write { $example } here
diag-is-but-no-study-has-that-9fe6 = { $who } is { $name }, but no study has that name
diag-no-such-study-32eb = no such study
diag-cannot-be-a-study-of-kind-15ef = { $who } cannot be a study of kind { $kind }, which runs a study itself
diag-runs-another-study-11b5 = runs another study
diag-write-4281 = write [{"{"} parameter = "drum.mass", distribution = "normal", deviation = "2 %" {"}"}]
diag-a-list-of-uncertain-parameters-3ed5 = a list of uncertain parameters
diag-names-twice-9ac4 = { $who } names { $parameter } twice
diag-named-above-004f = named above
diag-an-uncertain-parameter-196d = an uncertain parameter
diag-has-no-f0cb = { $who } has no { $key }
diag-is-missing-9c2c = { $key } = .. is missing
diag-a-text-6622 = a text
diag-cannot-be-eb0f = { $who } cannot be { $kind }
diag-distributions-8a45 = distributions: { $all } ({ $meanings })
diag-not-a-distribution-147d = not a distribution

## laval/src/file/numbers.rs

diag-write-a-number-with-a-unit-5e75 = write a number with a unit in quotes ({ $example }), or a bare number in SI units
diag-a-finite-number-is-needed-9e4f = { $who }: a finite number is needed
diag-not-finite-0a50 = not finite
diag-write-if-you-mean-percent-1b90 = write "{ $x } %" if you mean percent
diag-give-a-value-b1a9 = give a value { $bounds }
diag-a-bare-number-is-in-put-f863 = a bare number is in { $unit }; put number and unit in quotes to use others ({ $examples })
diag-out-of-bounds-444d = out of bounds
diag-a-whole-number-or-auto-fc98 = a whole number, or "auto"
diag-a-whole-number-5f04 = a whole number
diag-is-it-must-be-a-whole-6f22 = { $who } is { $i }; it must be a whole number from { $min } to { $max }, or "auto"
diag-is-it-must-be-a-whole-a695 = { $who } is { $i }; it must be a whole number from { $min } to { $max }
diag-write-without-quotes-c0ab = write { $t } without quotes
diag-is-needed-not-0ee8 = { $who }: { $wanted } is needed, not { $t }
diag-not-a-whole-number-a94c = not a whole number
diag-write-df59 = write { $number }
diag-is-needed-this-number-has-a-f0fe = { $who }: { $wanted } is needed; this number has a fraction or is too large
diag-write-one-value-for-both-directions-1e77 = write one value for both directions, or {"{"} x = .., y = .. {"}"}
diag-write-exactly-one-of-them-df4b = write exactly one of them: {"{"} { $names } = .. {"}"}
diag-one-of-several-quantities-7ee2 = one of several quantities
diag-wants-exactly-one-of-none-given-5b19 = { $who } wants exactly one of { $names }; none given
diag-wants-exactly-one-of-given-eadc = { $who } wants exactly one of { $names }; { $found } given
diag-exactly-one-6b94 = exactly one
diag-write-one-value-or-with-values-9303 = write one value, or {"{"} from = .., to = .., points = .. {"}"}, with values in { $examples }
diag-write-one-value-or-with-numbers-3184 = write one value, or {"{"} from = .., to = .., points = .. {"}"}, with numbers
diag-a-range-f017 = a range
diag-a-range-is-points-may-be-3a42 = a range is {"{"} from = .., to = .., points = .. {"}"}; points may be left out
diag-begins-and-ends-at-9f6a = { $who } begins and ends at { $from }
diag-empty-range-0d7b = empty range
diag-from-and-to-must-differ-6d65 = from and to must differ
diag-a-finite-number-with-a-unit-65fb = a finite number with a unit
diag-a-table-of-columns-f422 = a table of columns
diag-write-2117 = write {"{"} { $names } {"}"}
diag-has-no-column-40e2 = { $who } has no column { $name } ({ $doc })
diag-is-missing-fa44 = { $name } = [..] is missing
diag-the-columns-differ-in-length-has-d5e8 = { $who }: the columns differ in length: { $first } has { $n } values, { $name } has { $column }
diag-other-length-7560 = other length
diag-has-no-columns-4cc3 = { $who } has no columns
diag-empty-a649 = empty
diag-row-has-no-7ab0 = { $who }, row { $row }, has no { $name } ({ $doc })
diag-put-it-in-brackets-also-when-fec0 = put it in brackets, also when it is one value: [..]
diag-a-list-of-numbers-ae1f = a list of numbers
diag-the-list-is-empty-168a = { $who }: the list is empty

## laval/src/file/reader.rs

diag-the-file-has-mb-at-most-251d = the file has { $size } MB; at most 64 MB are read
diag-tables-within-more-than-others-are-f2ff = tables within more than { $most } others are not read
diag-nested-too-deeply-40e0 = nested too deeply
diag-the-file-is-no-text-byte-0366 = the file is no text: byte { $number } is NUL (0x00), which no text holds
diag-nul-402d = NUL
diag-save-it-as-utf-8-text-af88 = save it as UTF-8 text; files in UTF-16, and files that were damaged, hold such bytes
diag-it-looks-like-utf-16-save-fb74 = it looks like UTF-16; save it as UTF-8
diag-save-it-as-utf-8-often-3d66 = save it as UTF-8; often a unit sign such as µ or ° in an older encoding is the cause
diag-the-file-is-not-utf-8-a89f = the file is not UTF-8 text: byte { $number } is 0x{ $byte }
diag-here-44f0 = here
diag-a-machine-is-an-object-with-b397 = a machine is an object with machine, part and study, not { $shape }

## laval/src/file/references.rs

diag-the-name-of-a-body-2307 = the name of a body
diag-write-drum-or-4587 = write "drum", or {"{"} body = "drum", at = "40 mm" {"}"}
diag-must-be-a-body-the-ground-3c72 = { $who } must be a body; the ground is not allowed here
diag-the-name-of-a-body-is-95ae = { $who }: the name of a body is missing
diag-names-no-body-382f = { $who } names no body
diag-body-is-missing-8cdf = body = .. is missing
diag-write-f6dd = write {"{"} body = "drum", at = "40 mm" {"}"}
diag-the-ground-has-no-position-42fd = { $who }: the ground has no position
diag-leave-this-out-139b = leave this out
diag-write-between-drum-base-one-of-ab81 = write between = ["drum", "base"]; one of the two may be "ground"
diag-a-list-of-two-points-271a = a list of two points
diag-must-name-two-points-given-82c3 = { $who } must name two points; { $given } given
diag-two-points-bc22 = two points
diag-connects-with-itself-7d64 = { $who } connects { $what } with itself
diag-the-same-point-twice-e8b6 = the same point twice
diag-is-but-no-part-is-named-3d65 = { $who } is { $path }, but no part is named { $block }
diag-parts-of-this-file-001d = parts of this file: { $all }
diag-no-such-part-f861 = no such part
diag-is-but-is-a-list-whose-f379 = { $who } is { $path }, but "{ $name }" is a list, whose rows are numbered from 1
diag-parameters-of-a-0768 = parameters of a { $kind }: { $all }
diag-a-list-no-parameter-e77d = a list, no parameter
diag-is-but-is-a-list-studies-307e = { $who } is { $path }, but "{ $name }" is a list: studies hold its values
diag-studies-vary-single-numbers-parameters-of-2b8a = studies vary single numbers; parameters of a { $kind }: { $all }
diag-names-the-part-and-none-of-5c03 = { $who } names the part { $block } and none of its parameters
diag-is-but-a-has-no-parameter-d1e5 = { $who } is { $path }, but a { $kind } has no parameter { $rest }
diag-no-such-parameter-4b6b = no such parameter
diag-write-0abe = write {"{"} parameter = "part.parameter", from = .., to = .., points = .. {"}"}
diag-the-range-of-a-parameter-5b06 = the range of a parameter
diag-names-no-parameter-1d76 = { $who } names no parameter
diag-parameter-is-missing-4f11 = parameter = .. is missing
diag-the-path-of-a-parameter-9555 = the path of a parameter
diag-write-5182 = write [{"{"} parameter = "part.parameter", from = .., to = .. {"}"}]
diag-a-list-of-ranges-of-parameters-9cbf = a list of ranges of parameters
diag-names-twice-8475 = { $who } names { $path } twice
diag-the-name-of-a-coordinate-6fbe = the name of a coordinate
diag-the-name-of-a-coordinate-is-24bc = { $who }: the name of a coordinate is missing
diag-write-it-as-in-drum-x-5010 = write it as in "drum.x"
diag-a-table-of-initial-values-4b73 = a table of initial values
diag-write-e21e = write {"{"} "drum.x" = "1 mm", "drum.x'" = "0.1 m/s" {"}"}

## laval/src/file/render.rs

diag-error-a6c0 = error
diag-warning-6bce = warning
diag-help-9b8b = help
diag-also-named-in-lines-and-more-5c20 = { $message } (also named in lines { $lines } and { $left } more)
diag-also-named-in-line-e5a1 = { $message } (also named in line { $line })
diag-also-named-in-lines-and-6dd4 = { $message } (also named in lines { $lines } and { $last })
diag-and-more-9d04 = ... and { $n } more

## laval/src/file/syntax.rs

diag-the-list-of-is-not-closed-7aa9 = the list of { $key } is not closed
diag-the-table-of-is-not-closed-f05f = the table of { $key } is not closed
diag-is-missing-a1f6 = { $missing } is missing
diag-write-ab95 = write { $line }
diag-needs-double-brackets-66da = [{ $what }] needs double brackets
diag-single-brackets-040e = single brackets
diag-write-there-may-be-several-5078 = write [[{ $what }]]: there may be several
diag-so-far-only-the-syntax-and-f296 = so far only the syntax and single values were checked: how parts and studies fit together is looked at once the syntax is right
diag-this-line-holds-the-control-character-c33b = this line holds the control character { $code }, which no text has
diag-remove-it-f612 = remove it
diag-stands-twice-in-the-file-4a48 = { $body } stands twice in the file
diag-the-second-time-236c = the second time
diag-write-one-block-or-double-brackets-7c6f = write one block, or double brackets where several are allowed: [[part]], [[study]]
diag-the-key-is-given-twice-in-59e4 = the key { $word } is given twice in one block
diag-keep-one-of-the-two-a-15af = keep one of the two; a further part begins with its own [[part]]
diag-the-header-of-this-block-is-b840 = the header of this block is not closed properly
diag-brackets-91a2 = brackets
diag-write-machine-c5b2 = write [machine]
diag-write-d669 = write [[{ $word }]]
diag-this-line-is-neither-a-block-beb3 = this line is neither a block header nor a key with a value
diag-not-understood-f2b2 = not understood
diag-write-key-value-machine-part-or-0363 = write key = value, [machine], [[part]] or [[study]]; a remark begins with #
diag-the-value-of-is-missing-b5bb = the value of { $key } is missing
diag-nothing-behind-02e0 = nothing behind =
diag-write-8c88 = write { $key } = ".."
diag-cannot-be-a-key-1991 = { $key } cannot be a key
diag-not-a-key-1e19 = not a key
diag-a-key-is-one-word-of-4542 = a key is one word of letters, digits, _ and -; write key = value
diag-a-quotation-mark-is-missing-in-97fa = a quotation mark is missing in the value of { $key }
diag-not-closed-f52d = not closed
diag-write-dea8 = write { $key } = "{ $value }
diag-write-981e = write { $key } = { $value }"
diag-texts-and-quantities-stand-between-two-eaf9 = texts and quantities stand between two quotation marks
diag-a-brace-is-missing-in-the-f638 = a brace is missing in the value of { $key }
diag-must-match-94c5 = {"{"} and {"}"} must match
diag-a-table-is-written-1c60 = a table is written {"{"} x = "..", y = ".." {"}"}
diag-a-bracket-is-missing-in-the-9d9f = a bracket is missing in the value of { $key }
diag-and-must-match-d619 = [ and ] must match
diag-a-list-is-written-a8d4 = a list is written ["..", ".."]
diag-the-value-of-cannot-be-read-12c4 = the value of { $key } cannot be read
diag-inside-lists-and-tables-too-texts-7ba8 = inside lists and tables, too, texts and quantities stand in quotes, with commas between entries: {"{"} x = "1 mm", y = "2 mm" {"}"}
diag-the-value-of-must-stand-in-fc2a = the value of { $key } must stand in quotes, because it has a unit
diag-quotes-are-missing-ee9e = quotes are missing
diag-write-4a1c = write { $key } = "{ $value }"
diag-the-value-of-must-stand-in-d51a = the value of { $key } must stand in quotes
diag-this-line-cannot-be-read-0302 = this line cannot be read: { $why }

## laval/src/file/tree.rs

diag-a-number-d67a = a number
diag-true-or-false-80f6 = true or false
diag-an-empty-list-4d93 = an empty list
diag-a-list-4075 = a list
diag-a-table-9be6 = a table
diag-a-date-402c = a date
diag-null-3ca3 = null

## laval/src/file/unusual.rs

diag-is-no-machine-has-less-than-088d = { $who }: { $name } is { $value }; no machine has less than { $least }
diag-is-no-machine-has-more-than-21e1 = { $who }: { $name } is { $value }; no machine has more than { $most }
diag-far-outside-a589 = far outside
diag-check-the-number-and-its-unit-ee7b = check the number and its unit; it is computed as it stands

## laval/src/file/values.rs

diag-unknown-unit-f106 = unknown unit
diag-no-unit-2424 = no unit
diag-wrong-dimension-b8aa = wrong dimension
diag-turns-or-radians-4d76 = turns or radians?
diag-no-number-15dc = no number
diag-a-pure-number-has-none-a311 = a pure number has none
diag-is-given-in-2983 = { $quantity } is given in { $examples }
diag-is-needed-not-f6c2 = { $who }: { $wanted } is needed, not { $shape }
diag-allowed-here-b4fe = allowed here: { $all }
diag-put-it-in-quotes-8ea7 = put it in quotes
diag-a-word-8144 = a word
diag-write-one-of-91bc = write one of { $all }
diag-cannot-be-e72c = { $who } cannot be { $t }
diag-did-you-mean-choose-eeac = did you mean { $near }? Choose { $all }
diag-choose-c55d = choose { $all }
diag-not-one-of-its-words-2a4f = not one of its words
diag-write-true-or-false-without-quotes-cb7a = write true or false, without quotes

## laval/src/import/machine.rs

diag-between-the-rows-of-a-table-98ce = between the rows of a table ROSS 2 draws a spline, laval a monotone cubic as ROSS 3
diag-cone-mid-section-gives-the-cones-61fb = cone = "mid_section" gives the cones of ROSS; without it they converge faster
diag-lateral-motion-alone-is-carried-over-869f = lateral motion alone is carried over; axial = true and torsional = true of the shaft add the others
diag-ross-takes-g-9-8065-m-9851 = ROSS takes g = 9.8065 m/s^2 in run_static, laval 9.80665 m/s^2
diag-is-at-node-where-neither-the-2fb9 = { $element } is at node { $node }, where neither the shaft nor a point mass is

## laval/src/import/model.rs

diag-has-no-3dc9 = { $element } has no { $key }
diag-of-must-be-not-c7c2 = { $key } of { $element } must be { $wanted }, not { $shape }
diag-a-finite-number-ee7c = a finite number
diag-the-number-of-a-node-from-0b42 = the number of a node, from 0 to { $most }
diag-a-list-of-finite-numbers-3e52 = a list of finite numbers
diag-the-length-of-must-be-positive-9a7e = the length of { $element } must be positive
diag-has-values-of-for-speeds-0087 = { $element } has { $n } values of { $key } for { $wanted } speeds

## laval/src/import/notes.rs

diag-and-more-1d3b = { $names } and { $n } more
diag-left-out-5499 = { $elements }: { $keys } left out
diag-not-read-as-no-element-of-a77e = { $elements }: not read, as no element of this kind has such a key: { $keys }
diag-a-disc-without-teeth-e596 = { $elements }: a disc without teeth
diag-the-mean-of-mx-and-my-8318 = { $elements }: the mean of mx and my is taken
diag-of-the-coefficients-over-speed-and-9cb9 = { $elements }: of the coefficients over speed and frequency those at frequency = speed are taken
diag-coefficients-over-frequency-are-taken-over-59b6 = { $elements }: coefficients over frequency are taken over speed
diag-the-coefficients-are-those-in-the-45ec = { $elements }: the coefficients are those in the file, the geometry is left out
diag-in-effect-in-all-studies-ross-43d4 = { $elements }: in effect in all studies; ROSS leaves seals out of run_static
diag-a-layer-of-the-shaft-with-e9c1 = { $elements }: a layer of the shaft, with one shear angle; ROSS gives every layer its own
diag-the-mass-is-carried-over-as-2fac = { $elements }: the mass is carried over as a disc, the stiffness is left out
diag-left-out-there-are-no-lateral-3572 = { $elements }: left out, there are no lateral coefficients

## laval/src/import/ross.rs

diag-it-is-not-utf-8-text-eb31 = it is not UTF-8 text
diag-it-is-not-a-table-of-ed88 = it is not a table of elements
diag-its-tables-are-nested-too-deeply-59ac = its tables are nested too deeply
diag-this-model-is-no-machine-here-551b = this model is no machine here: { $why }
diag-this-is-no-model-that-ross-c0a1 = this is no model that ROSS has saved: { $why }
diag-rotor-save-rotor-toml-and-rotor-8e3a = rotor.save("rotor.toml") and rotor.save("rotor.json") of ROSS 2 and 3 write models that can be read
diag-the-file-cannot-be-read-3769 = the file cannot be read: { $why }
diag-elements-of-the-kind-are-not-89d8 = elements of the kind { $class } are not imported
diag-elements-that-are-imported-23a2 = elements that are imported: { $all }
diag-it-has-no-shaftelement-bf65 = it has no ShaftElement

## laval/src/import/shaft.rs

diag-no-element-of-the-shaft-lies-e19b = no element of the shaft lies between the nodes { $k } and { $next }
diag-the-shafts-of-several-rotors-in-ca3c = the shafts of several rotors in one model are not imported
diag-of-elements-differs-that-of-is-d2a2 = { $key } of { $n } elements differs; that of { $first } is taken for the whole shaft
diag-rotary-inertia-and-gyroscopic-are-on-f7ff = rotary_inertia and gyroscopic are on in all elements; { $n } have them off

## laval/src/outcome/mod.rs

diag-the-end-bff1 = the end
diag-in-the-table-1bb6 = { $name } in the table { $table }
diag-column-of-table-has-rows-the-d4c8 = column `{ $column }` of table `{ $table }` has { $found } rows, the columns before it have { $expected }
diag-is-no-finite-number-6158 = { $what } is no finite number
diag-two-s-are-named-baa3 = two { $what }s are named `{ $name }`
diag-figure-needs-which-is-missing-0bb0 = figure `{ $figure }` needs { $expected } `{ $table }`, which is missing
diag-figure-needs-in-table-137d = figure `{ $figure }` needs { $expected } `{ $column }` in table `{ $table }`
diag-the-result-cannot-be-computed-16f8 = the result cannot be computed: { $e }
diag-a-value-of-the-machine-or-bcfe = a value of the machine or of the study is too large or too small
diag-the-study-s-result-is-inconsistent-dc5b = the study's result is inconsistent: { $e }

## laval/src/output_folder.rs

diag-it-is-a-file-e707 = it is a file
diag-cannot-make-the-folder-4dd9 = cannot make the folder { $folder }: { $why }
diag-name-another-one-with-out-d81d = name another one with --out
diag-cannot-write-f8b7 = cannot write { $path }: { $e }
diag-mend-the-permissions-of-the-folder-8e1f = mend the permissions of the folder, or name another one with --out
diag-was-not-made-by-this-program-0488 = { $path } was not made by this program and is left as it is
diag-move-it-elsewhere-or-name-another-3b1e = move it elsewhere, or name another folder with --out
diag-another-process-is-writing-into-92c3 = another process is writing into { $folder }
diag-another-process-number-is-writing-into-7450 = another process (number { $number }) is writing into { $folder }
diag-wait-until-it-has-ended-or-add0 = wait until it has ended, or name another folder with --out

## laval/src/reach/criticals.rs

diag-a-critical-speed-has-an-order-339b = a critical speed has an order above 0 and a speed
diag-there-is-no-such-critical-speed-ea55 = there is no such critical speed near { $at }

## laval/src/reach/limits.rs

diag-a-limit-of-stability-has-a-12c8 = a limit of stability has a speed
diag-there-is-no-limit-of-stability-8182 = there is no limit of stability near { $at }

## laval/src/reach/machine.rs

diag-is-released-twice-f3c3 = { $path } is released twice
diag-the-released-range-must-hold-the-a291 = { $path }: the released range must hold the value of the file

## laval/src/reach/mod.rs

diag-no-parameter-is-released-bfda = no parameter is released
diag-the-wanted-value-is-no-number-92b4 = the wanted value is no number
diag-the-released-parameters-do-not-move-1fda = the released parameters do not move this result
diag-the-search-ended-at-beyond-this-d436 = the search ended at { $value }: beyond, this result does not exist or no longer follows the released parameters
diag-is-the-nearest-that-can-be-c523 = { $value } is the nearest that can be reached: { $names } stands at its bound
diag-is-the-nearest-that-can-be-c685 = { $value } is the nearest that can be reached: { $names } stand at their bounds

## laval/src/reach/search.rs

diag-the-machine-of-the-file-does-df10 = the machine of the file does not have this result
diag-the-result-at-cannot-be-moved-edb0 = the result at { $stated } cannot be moved: the nearest that can be followed is at { $found }

## laval/src/report/renew.rs

diag-is-where-results-are-to-be-4cdb = { $path } is { $what }, where results are to be written
diag-a-file-of-another-program-48c0 = a file of another program
diag-a-folder-3924 = a folder
diag-no-folder-511c = no folder

## laval/src/report/write.rs

diag-cannot-write-581b = cannot write { $path }: { $source }
diag-cannot-write-1-file-written-before-39ef = cannot write { $path }: { $source } (1 file written before it is complete)
diag-cannot-write-files-written-before-it-09e7 = cannot write { $path }: { $source } ({ $n } files written before it are complete)
diag-study-2678 = study `{ $study }`: { $source }

## laval/src/store/cells.rs

diag-a-chunk-of-rows-and-columns-2774 = a chunk of { $rows } rows and { $columns } columns was computed as { $found }

## laval/src/store/folder.rs

diag-cannot-remove-7a2c = cannot remove { $path }: { $e }
diag-was-not-written-by-this-program-ed9c = { $path } was not written by this program
diag-move-it-elsewhere-or-give-the-a880 = move it elsewhere, or give the results another folder with --out
diag-is-no-manifest-of-this-program-a5a1 = { $path } is no manifest of this program: { $why }
diag-give-the-results-another-folder-with-e621 = give the results another folder with --out, or start anew with --fresh (which removes what the folder holds)
diag-its-format-is-this-program-writes-7167 = its format is { $found }, this program writes format { $own }
diag-its-format-is-none-this-program-4126 = its format is none, this program writes format { $own }
diag-the-order-of-its-blocks-f191 = the order of its blocks
diag-and-more-2ac0 = and { $more } more
diag-holds-results-of-another-build-of-dcdb = { $path } holds results of another build of the program or another processor: { $all }
diag-holds-results-of-another-input-472e = { $path } holds results of another input: { $all }
diag-give-the-new-results-another-folder-4370 = give the new results another folder with --out, or start anew with --fresh (which removes the old ones)
diag-missing-b4f3 = missing
diag-damaged-72ee = damaged
diag-is-rows-to-are-missing-2dec = { $path } is { $why }: rows { $first } to { $last } are missing
diag-is-rows-to-are-computed-again-50b5 = { $path } is { $why }: rows { $first } to { $last } are computed again
diag-not-of-this-study-f8d5 = not of this study
diag-chunk-cannot-be-written-as-parquet-3b0c = chunk { $index } cannot be written as Parquet: { $e }
diag-the-manifest-cannot-be-written-2360 = the manifest cannot be written: { $e }
diag-cannot-write-of-chunks-are-complete-f917 = cannot write { $path }: { $e }; { $kept } of { $all } chunks are complete and kept
diag-make-room-or-mend-the-folder-66a3 = make room or mend the folder, then run the same command: it continues from there
diag-name-another-folder-with-out-b101 = name another folder with --out

## laval/src/store/manifest.rs

diag-not-given-e003 = not given
diag-was-now-babc = { $what } was { $old }, now { $new }

## laval/src/store/mod.rs

diag-a-study-needs-at-least-one-c0d9 = a study needs at least one row, one row in a chunk, and one column
diag-rows-in-chunks-of-are-more-d0c6 = { $rows } rows in chunks of { $chunk } are more than { $most } chunks
diag-two-columns-are-named-f7a1 = two columns are named "{ $name }"
diag-this-build-cannot-write-parquet-which-dbd2 = this build cannot write Parquet, which long studies are kept in
diag-the-study-is-planned-not-run-a333 = the study is planned, not run
diag-part-of-has-no-rows-d16b = part { $number } of { $of } has no rows
diag-part-of-of-rows-are-there-9818 = part { $number } of { $of }: { $done } of { $total } rows are there
diag-of-rows-are-missing-those-of-2c01 = { $rows } of { $all } rows are missing, those of the chunks { $shown } of { $of }
diag-run-the-parts-that-have-not-0f55 = run the parts that have not ended once more; chunk k belongs to part ((k - 1) mod n) + 1 of n. laval run computes what is missing
diag-there-is-no-column-4824 = there is no column "{ $column }"

## laval/src/store/reader.rs

diag-belongs-to-another-study-another-build-5178 = { $path } belongs to another study, another build or another processor

## laval/src/study/centrifuge/cups/mod.rs

diag-the-tube-holds-no-liquid-its-6763 = the tube holds no liquid: its surface lies at the bottom or below
diag-measure-surface-and-length-from-the-42d5 = measure surface and length from the mouth
diag-the-centre-of-mass-lies-far-8fab = the centre of mass lies far below the bottom of the tube
diag-measure-it-from-the-mouth-with-8dfb = measure it from the mouth, with contents
diag-the-tube-reaches-across-the-spin-499b = the tube reaches across the spin axis
diag-increase-mouth-radius-fce8 = increase mouth_radius
diag-inner-radius-must-be-smaller-than-25c4 = inner_radius must be smaller than outer_radius
diag-exchange-them-3e47 = exchange them
diag-the-liquid-s-surface-must-lie-5953 = the liquid's surface must lie inside the bowl: surface_radius below bowl_radius
diag-the-surface-is-the-inner-face-68b0 = the surface is the inner face of the liquid
diag-how-far-the-cup-swings-out-dd7a = how far the cup swings out depends on its centre of mass, which is missing
diag-add-centre-of-mass-60-mm-c3bc = add centre_of_mass = "60 mm" (from the hinge, with contents), or hold the cup at a tilt
diag-a-moment-of-inertia-needs-the-c51e = a moment of inertia needs the mass it belongs to
diag-add-mass-bcf9 = add mass
diag-no-body-has-these-second-moments-f674 = no body has these second moments about the hinge
diag-moment-along-is-at-least-mass-d9e1 = moment_along is at least mass times centre_of_mass squared; moment_product squared is at most moment_along times moment_across
diag-the-cup-holds-no-liquid-its-de84 = the cup holds no liquid: its surface lies at the bottom or below
diag-measure-surface-and-bottom-from-the-e09d = measure surface and bottom from the hinge, outwards
diag-the-centre-of-mass-lies-from-b498 = the centre of mass lies { $along } from the hinge, far below the bottom of the cup at { $bottom }
diag-measure-both-from-the-hinge-7e75 = measure both from the hinge
diag-the-centre-of-mass-lies-outside-6a05 = the centre of mass lies outside the cup
diag-at-most-cup-radius-to-either-3b6a = at most cup_radius to either side of its axis
diag-the-surface-of-the-liquid-reaches-d8a6 = the surface of the liquid reaches across the spin axis when the cup has swung out
diag-increase-hinge-radius-772a = increase hinge_radius
diag-cups-with-an-inner-radius-of-c132 = { $count } cups with an inner radius of { $inner } reach into each other as they hang
diag-cups-with-an-inner-radius-of-fb5e = { $count } cups with an inner radius of { $inner } reach into each other at a tilt of { $tilt }
diag-is-at-least-for-of-them-dc43 = { $field } is at least { $least } for { $count } of them, without their walls; or give fewer with count
diag-which-carries-it-does-not-exist-4469 = "{ $name }", which carries it, does not exist
diag-has-no-mass-of-its-own-2665 = "{ $name }" has no mass of its own that cups could add to
diag-has-no-unbalance-of-its-own-02c9 = "{ $name }" has no unbalance of its own that cups could add to
diag-attach-the-cups-to-a-disc-1150 = attach the cups to a disc
diag-what-loads-a-body-needs-mass-c12e = what loads a body needs mass and centre_of_mass
diag-add-both-with-contents-or-leave-f30c = add both, with contents; or leave on out
diag-values-are-given-for-cups-f8d1 = { $given } values are given for { $count } cups
diag-give-one-for-each-0-for-ec2c = give one for each, 0 for those that fit
diag-a-centre-of-mass-would-lie-abc7 = a centre of mass would lie at the hinge or beyond it
diag-differences-are-small-against-centre-of-e735 = differences are small against centre_of_mass
diag-a-cup-would-weigh-less-than-81ed = a cup would weigh less than nothing
diag-a-missing-cup-is-minus-its-dac8 = a missing cup is minus its mass
diag-a-viscosity-in-the-table-is-2768 = a viscosity in the table is not positive
diag-check-the-column-and-its-unit-81c4 = check the column and its unit
diag-the-viscosity-table-goes-from-k-9d41 = the viscosity table goes from { $low } K to { $high } K; at { $t } K it says nothing
diag-extend-the-table-viscosity-is-not-baa6 = extend the table: viscosity is not extrapolated
diag-give-temperatures-in-increasing-order-7f7b = give temperatures in increasing order
diag-a-viscosity-table-needs-the-temperature-23e1 = a viscosity table needs the temperature at which the liquid is separated
diag-add-temperature-60-degc-e709 = add temperature = "60 degC"
diag-both-viscosity-and-viscosity-table-are-815f = both viscosity and viscosity_table are given
diag-keep-one-of-them-c17f = keep one of them
diag-the-viscosity-of-the-liquid-is-2fd6 = the viscosity of the liquid is missing
diag-add-viscosity-1-mpa-s-or-7227 = add viscosity = "1 mPa s", or a viscosity_table and a temperature
diag-the-size-of-the-particles-is-30da = the size of the particles is missing
diag-the-sizes-are-given-in-several-7b62 = the sizes are given in several ways: { $given }
diag-say-one-of-diameter-median-diameter-f077 = say one of diameter; median_diameter with geometric_deviation; characteristic_diameter with spread; sizes
diag-needs-beside-it-6e09 = { $way } needs { $field } beside it
diag-add-7c9e = add { $field }
diag-a-powder-needs-either-undersize-or-49e9 = a powder needs either undersize or share for its diameters
diag-sizes-6b6c = sizes = {"{"} diameter = [..], undersize = [..] {"}"}
diag-the-densities-are-given-in-two-09e3 = the densities are given in two ways
diag-keep-densities-or-density-deviation-6dc6 = keep densities or density_deviation
diag-densities-3bfb = densities = {"{"} density = [..], share = [..] {"}"}
diag-there-is-no-cup-named-acf8 = there is no cup named "{ $name }"
diag-cups-of-this-machine-27de = cups of this machine: { $names }
diag-this-machine-has-several-cups-2aed = this machine has several cups
diag-add-cup-with-one-of-031d = add cup = .. with one of { $names }
diag-this-machine-has-nothing-that-separates-3ac4 = this machine has nothing that separates
diag-add-a-block-cup-with-kind-40e1 = add a block [[cup]] with kind = "swinging", "fixed_angle", "tubular_bowl", "disc_stack" or "decanter"
diag-this-machine-has-nothing-to-separate-394f = this machine has nothing to separate
diag-add-a-block-suspension-with-liquid-03ca = add a block [suspension] with liquid_density, viscosity, particle_density and diameter

## laval/src/study/centrifuge/cups/task.rs

diag-the-time-in-which-the-cups-9fc8 = the time in which the cups must have separated is needed
diag-add-time-30-min-1419 = add time = "30 min"
diag-liquid-flows-through-its-throughput-is-8a11 = liquid flows through "{ $name }": its throughput is needed, not a time
diag-add-throughput-500-l-h-and-bb7c = add throughput = "500 l/h", and no time
diag-nothing-flows-through-9d8a = nothing flows through "{ $name }"
diag-give-time-10-min-instead-dae6 = give time = "10 min" instead
diag-a-decanter-is-counted-by-its-261e = a decanter is counted by its Sigma, which exists for Stokes' drag alone
diag-use-drag-stokes-in-suspension-or-3b00 = use drag = "stokes" in [suspension], or a tubular_bowl of the same Sigma
diag-particles-and-liquid-have-the-same-cff9 = particles and liquid have the same density: nothing separates
diag-give-particle-density-another-value-than-a77a = give particle_density another value than liquid_density
diag-particles-of-do-not-fit-into-38bc = particles of { $size } do not fit into "{ $name }", which is { $wide } wide
diag-check-the-unit-of-the-diameter-dbc5 = check the unit of the diameter in [suspension]
diag-the-path-of-a-particle-could-e89c = the path of a particle could not be computed: { $why }
diag-a-particle-that-moves-much-faster-ed21 = a particle that moves much faster than the cup turns needs drag = "schiller_naumann"

## laval/src/study/centrifuge/operating_window/contents.rs

diag-the-machine-with-what-it-has-9372 = the machine with what it has separated does not exist: { $why }

## laval/src/study/centrifuge/operating_window/mod.rs

diag-speeds-to-evaluate-and-more-where-773d = speeds to evaluate, and more where something happens

## laval/src/study/centrifuge/operating_window/passage.rs

diag-turns-of-the-rotor-to-integrate-afa3 = turns of the rotor to integrate in the simulation of the passage
diag-give-the-ramp-another-duration-60fd = give the ramp another duration
diag-the-passage-could-not-be-computed-78f4 = the passage could not be computed beyond { $speed }
diag-shorten-the-ramp-or-the-range-4b36 = shorten the ramp or the range of speeds; a machine that is unstable below the window may move without bound

## laval/src/study/centrifuge/operating_window/request.rs

diag-begin-at-a-low-speed-such-c83d = begin at a low speed, such as a tenth of the highest
diag-the-range-of-speeds-must-begin-f56a = the range of speeds must begin above standstill
diag-write-uncertain-8963 = write uncertain = {"{"} suspension.viscosity = "20 %" {"}"}
diag-which-parameters-are-uncertain-is-missing-54c5 = which parameters are uncertain is missing
diag-uncertain-parameters-are-too-many-every-d443 = { $found } uncertain parameters are too many: every corner is evaluated
diag-keep-at-most-five-c64b = keep at most five
diag-a-time-or-throughput-needs-something-af88 = a time or throughput needs something to separate, and something that separates it
diag-add-the-blocks-cup-and-suspension-053e = add the blocks [[cup]] and [suspension]
diag-the-run-up-to-the-top-68a1 = the run-up to the top of the range takes { $ramp }, longer than the { $time } at hand that count from its start
diag-give-a-shorter-ramp-a-lower-8b36 = give a shorter ramp, a lower top of the range or more time; with count_ramp = false the time counts from the end of the run-up
diag-add-ramp-60-s-the-time-db06 = add ramp = "60 s": the time to the top of the range of speeds
diag-the-state-that-a-run-up-6a0f = the state that a run-up leads to needs the time of the run-up
diag-the-limits-on-the-passage-need-c4b8 = the limits on the passage need the time of the run-up
diag-there-is-no-separation-whose-time-37dc = there is no separation whose time could be shortest
diag-add-cup-suspension-and-time-throughput-fb74 = add [[cup]], [suspension] and time (throughput where liquid flows through)
diag-no-limit-on-vibration-is-given-8f35 = no limit on vibration is given that amplitudes could be measured against
diag-add-displacement-velocity-tilt-force-or-cb12 = add displacement, velocity, tilt, force or moment to [limits]
diag-what-the-study-requires-of-the-db03 = what the study requires of the machine does not fit its cups and suspension

## laval/src/study/centrifuge/operating_window/steady.rs

diag-the-stability-of-a-steady-state-99a6 = the stability of a steady state cannot be assessed: { $why }
diag-a-steady-state-cannot-be-evaluated-0b1c = a steady state cannot be evaluated: { $e }

## laval/src/study/centrifuge/operating_window/vary.rs

diag-numbers-of-539d = numbers of "{ $name }": { $own }
diag-cannot-be-b533 = { $path } cannot be { $value }
diag-has-no-number-to-vary-071a = "{ $name }" has no number { $field } to vary
diag-give-it-a-value-in-its-ae9c = give it a value in its block first

## laval/src/study/centrifuge/separation/meter.rs

diag-paths-of-particles-to-integrate-roughly-2ddf = paths of particles to integrate, roughly

## laval/src/study/centrifuge/separation/mod.rs

diag-a-programme-begins-at-time-0-7c07 = a programme begins at time 0, turns one way, and ends turning
diag-the-last-speed-is-held-c274 = the last speed is held
diag-give-times-in-increasing-order-c8b3 = give times in increasing order
diag-both-a-programme-and-a-ramp-0676 = both a programme and a ramp are given
diag-release-0-mm-20-mm-0-a72d = release = ["0 mm", "20 mm", "0 mm"]
diag-a-place-has-three-components-not-e4ba = a place has three components, not { $n }
diag-release-velocity-0-m-s-0-3bd1 = release_velocity = ["0 m/s", "0.1 m/s", "0 m/s"]
diag-a-velocity-has-three-components-not-760c = a velocity has three components, not { $n }
diag-a-velocity-belongs-to-a-particle-bd64 = a velocity belongs to a particle that is released
diag-add-release-0-mm-20-mm-ac24 = add release = ["0 mm", "20 mm", "0 mm"]
diag-a-particle-whose-drag-balances-the-2608 = a particle whose drag balances the field has no velocity of its own to begin with
diag-take-it-out-or-take-model-988f = take it out, or take model = "exact"
diag-a-run-up-needs-two-different-e12f = a run-up needs two different speeds; this one begins and ends at standstill
diag-give-another-speed-or-leave-ramp-df25 = give another speed, or leave ramp out
diag-liquid-flows-through-this-machine-which-9d11 = liquid flows through this machine, which is fed at speed: it has no run-up to count
diag-leave-it-out-7b2b = leave it out
diag-the-run-up-takes-longer-than-c0f0 = the run-up takes { $ramp }, longer than the { $time } at hand: the speed is never reached
diag-give-a-shorter-ramp-or-more-719c = give a shorter ramp or more time
diag-one-particle-can-be-followed-in-007a = one particle can be followed in cups and tubes only
diag-leave-release-out-355c = leave release out
diag-no-particle-finds-liquid-in-this-b6b2 = no particle finds liquid in this tube
diag-lower-surface-or-raise-length-f51b = lower surface, or raise length

## laval/src/study/context.rs

diag-making-the-time-form-of-6c7f = making the time form of { $names }

## laval/src/study/kind.rs

diag-the-study-was-stopped-within-a-cbf2 = the study was stopped within a computation that has no partial result

## laval/src/study/linear/approximation.rs

diag-no-part-of-this-machine-has-b90f = no part of this machine has an approximation to be compared with
diag-parts-with-waves-without-number-have-9300 = parts with waves without number have one; leave compare out otherwise
diag-the-approximation-is-no-machine-47ae = the approximation is no machine: { $why }
diag-leave-compare-out-5311 = leave compare out

## laval/src/study/linear/bearing_coefficients.rs

diag-the-machine-has-no-support-with-f148 = the machine has no support with coefficients
diag-a-support-is-a-part-with-05ea = a support is a part with stiffness between what turns and what does not; supports names others

## laval/src/study/linear/campbell.rs

diag-speeds-at-which-modes-are-counted-0ff8 = speeds at which modes are counted, one after another
diag-speeds-at-which-roots-are-counted-0176 = speeds at which roots are counted, one after another
diag-eigenvalue-problems-to-solve-3ff3 = eigenvalue problems to solve
diag-modes-shows-the-modes-at-one-aec9 = { $help }; modes shows the modes at one speed

## laval/src/study/linear/criterion.rs

diag-flutter-is-for-machines-that-nothing-8c74 = flutter is for machines that nothing damps or drives; this one has damping
diag-set-all-damping-to-0-or-3e29 = set all damping to 0, or take criterion = "growth" with a growth_threshold
diag-no-part-of-this-machine-has-754c = no part of this machine has losses like the viscosity that this criterion is about
diag-give-one-a-viscosity-or-take-ccca = give one a viscosity, or take criterion = "growth" with a growth_threshold

## laval/src/study/linear/forced_response/mod.rs

diag-no-body-of-this-machine-moves-0be8 = no body of this machine moves across the axis
diag-separation-margins-need-an-operating-speed-78a5 = separation margins need an operating speed
diag-give-speed-in-machine-or-the-6a56 = give speed in [machine], or the range of operating speeds in [operation]
diag-separation-margins-are-those-of-the-c6b2 = separation margins are those of the speed of the machine
diag-leave-standard-out-or-spin-c43d = leave standard out, or spin
diag-responses-at-speeds-of-coordinates-ffcf = responses at { $speeds } speeds of { $n } coordinates
diag-give-the-range-fewer-points-where-a938 = give the range fewer points: where the response bends it is refined without them
diag-nothing-forces-this-machine-at-the-bc0c = nothing forces this machine at the spin speed
diag-give-a-disc-an-eccentricity-an-cc3c = give a disc an eccentricity, an unbalance or a skew
diag-speeds-to-solve-for-and-more-309f = speeds to solve for, and more where the response bends

## laval/src/study/linear/harmonic_force/mod.rs

diag-frequency-belongs-to-one-spin-speed-36ee = frequency belongs to one spin speed
diag-give-one-speed-or-order-in-c27b = give one speed, or order in place of frequency
diag-order-and-frequency-both-say-how-ed69 = order and frequency both say how fast the force is
diag-leave-one-of-them-out-0b3f = leave one of them out
diag-separation-margins-are-those-of-a-5324 = separation margins are those of a range of speeds
diag-leave-frequency-out-and-give-a-f93a = leave frequency out and give a range of speeds
diag-responses-at-values-of-coordinates-e18e = responses at { $values } values of { $n } coordinates
diag-give-the-range-fewer-points-f548 = give the range fewer points
diag-the-point-on-which-the-force-7c2b = the point on which the force acts does not move across the axis
diag-name-a-point-of-a-disc-206e = name a point of a disc, a shaft or a foundation
diag-responses-to-compute-cf95 = responses to compute

## laval/src/study/linear/modes/mod.rs

diag-terms-of-series-in-every-evaluation-3314 = terms of series in every evaluation of the function whose roots are counted

## laval/src/study/linear/stability_map/mod.rs

diag-a-map-of-by-points-is-6344 = a map of { $speeds } by { $values } points is too large
diag-at-most-points-in-all-2d77 = at most { $most } points in all
diag-the-machine-does-not-exist-at-46f1 = the machine does not exist at { $path } = { $x }: { $why }
diag-narrow-the-range-of-the-parameter-aa3f = narrow the range of the parameter

## laval/src/study/linear/stability_threshold/mod.rs

diag-up-to-is-below-the-anticipated-90ef = up_to is below the anticipated stiffness { $anticipated }
diag-give-a-larger-up-to-or-f72d = give a larger up_to, or leave it out
diag-no-lateral-mode-of-this-machine-bf9e = no lateral mode of this machine oscillates
diag-cross-coupled-stiffness-makes-lateral-modes-69e4 = cross-coupled stiffness makes lateral modes unstable: modes lists those of the machine
diag-roots-to-follow-61c7 = roots to follow
diag-no-mode-becomes-less-stable-with-f0e4 = no mode becomes less stable with the stiffness, so that there is no largest one to propose
diag-give-up-to-2dd8 = give up_to

## laval/src/study/linear/static/aligned.rs

diag-says-how-couplings-are-aligned-and-e84a = { $field } says how couplings are aligned, and couplings names none
diag-name-couplings-or-remove-fddd = name couplings, or remove { $field }
diag-joins-no-shaft-that-bends-to-a48c = "{ $name }" joins no shaft that bends to another body
diag-name-a-coupling-between-two-shafts-cfbb = name a coupling between two shafts, or a place as "shaft at 1200 mm"
diag-couplings-names-which-is-neither-a-b851 = couplings names "{ $name }", which is neither a part nor a place of a shaft
diag-a-place-of-a-shaft-is-497d = a place of a shaft is written as "shaft at 1200 mm"
diag-is-no-node-of-the-shaft-5235 = { $name } is no node of the shaft: the nearest is at { $near }
diag-end-a-section-of-the-shaft-39cd = end a section of the shaft there
diag-loads-of-couplings-vanish-only-with-76f3 = { $needed } loads of couplings vanish only with as many supports that may move, and there are { $free }
diag-name-fewer-couplings-keep-fewer-supports-5374 = name fewer couplings, keep fewer supports, or choose aligned_for = "moment"
diag-and-support-the-same-place-with-773a = "{ $a }" and "{ $b }" support the same place with different offsets
diag-give-them-the-same-offsets-or-ca7d = give them the same offsets, or name one of them in supports

## laval/src/study/linear/support_stiffness_map/mod.rs

diag-the-machine-has-no-support-that-86fb = the machine has no support that could be replaced

## laval/src/study/motion/basins/axes.rs

diag-must-name-one-initial-value-beside-a61c = { $field } must name one initial value beside the run-up; it names { $given }
diag-must-name-two-initial-values-it-6efa = { $field } must name two initial values; it names { $given }
diag-write-1-rad-8cd7 = write { $field } = {"{"} "{ $mass }" = "1 rad" {"}"}
diag-write-x-1-mm-32e6 = write { $field } = {"{"} "{ $body }.x" = "1 mm" {"}"}
diag-write-x-1-mm-y-1-3c85 = write { $field } = {"{"} "{ $body }.x" = "1 mm", "{ $body }.y" = "1 mm" {"}"}
diag-to-names-but-from-names-7aff = to names { $to }, but from names { $from }
diag-both-name-the-same-a658 = both name the same
diag-must-go-from-a-lower-to-d49b = "{ $name }" must go from a lower to a higher value
diag-a-grid-of-by-points-is-75a7 = a grid of { $first } by { $second } points is too large
diag-points-must-be-whole-numbers-from-9f75 = points must be whole numbers from 2 to { $most }, not { $x }
diag-points-names-which-is-not-varied-9569 = points names "{ $n }", which is not varied
diag-varied-are-2f80 = varied are { $names }

## laval/src/study/motion/basins/masses/mod.rs

diag-starts-followed-beforehand-then-those-of-0602 = starts followed beforehand, then those of the map
diag-motions-to-follow-until-their-masses-76f2 = motions to follow until their masses rest or go on moving alike

## laval/src/study/motion/basins/mod.rs

diag-basins-need-a-speed-above-there-e9a5 = basins need a speed above { $least }: there is no period at rest
diag-a-run-up-makes-no-difference-e5b8 = a run-up makes no difference at { $speed }: this machine has no masses that move round in axes that turn with it
diag-leave-run-up-out-90f9 = leave run_up out
diag-motions-with-numbers-each-a1ca = { $rows } motions with { $columns } numbers each
diag-the-spin-of-this-machine-is-c90d = the spin of this machine is free: it has no speed at which motions settle
diag-leave-drive-free-out-or-follow-efcb = leave drive = "free" out, or follow its motion with transient
diag-motions-to-follow-cells-and-the-b5b2 = { $count } motions to follow ({ $cells } cells and the undisturbed start), each for up to { $turns } turns: { $what }, so that nothing says how long settling takes
diag-motions-to-follow-until-they-repeat-fe68 = motions to follow until they repeat
diag-at-rest-a-mode-of-this-c2da = at rest a mode of this machine grows by { $growth }
diag-at-rest-a-mode-of-this-8b63 = at rest a mode of this machine neither decays nor grows
diag-the-modes-of-this-machine-at-bdf2 = the modes of this machine at rest are not known

## laval/src/study/motion/basins/report.rs

diag-the-attractors-are-not-those-of-fdb9 = the attractors are not those of these motions

## laval/src/study/motion/history/mod.rs

diag-output-times-of-coordinates-d440 = { $outputs } output times of { $n } coordinates
diag-give-fewer-points-a-longer-output-6e5a = give fewer points (a longer output_step), or leave out velocities and observables
diag-the-study-was-stopped-before-its-ea66 = the study was stopped before its machine in time was there
diag-turns-of-the-rotor-to-integrate-2fed = turns of the rotor to integrate, { $duration }

## laval/src/study/motion/motion_map/mod.rs

diag-both-a-range-of-speeds-and-8fcf = both a range of speeds and a parameter along x are given
diag-say-one-or-the-other-5112 = say one or the other
diag-a-map-of-two-parameters-needs-75f7 = a map of two parameters needs a speed above zero
diag-add-speed-3000-rpm-here-or-39c1 = add speed = "3000 rpm" here or to [machine]
diag-vary-two-parameters-e3b5 = vary two parameters
diag-a-map-of-by-motions-is-21b0 = a map of { $a } by { $b } motions is too large
diag-at-most-motions-in-all-6722 = at most { $most } motions in all
diag-this-study-needs-a-range-of-c0d9 = this study needs a range of speeds
diag-add-speed-or-a-speed-to-16b1 = add speed = {"{"} from = "1000 rpm", to = "5000 rpm" {"}"}, or a speed to [machine]
diag-or-give-x-a-second-parameter-93d9 = { $help }, or give x a second parameter: the speed is then the same everywhere
diag-a-map-needs-speeds-above-there-fb49 = a map needs speeds above { $least }: there is no period at rest

## laval/src/study/motion/record.rs

diag-a-state-of-coordinates-and-internal-7bda = a state of { $coordinates } coordinates and { $states } internal states is not one of this machine, which has { $n } and in time { $m }
diag-continue-from-a-motion-of-the-8d3a = continue from a motion of the same machine

## laval/src/study/motion/run_up/mod.rs

diag-the-spin-of-this-machine-is-d361 = the spin of this machine is free and cannot follow a programme
diag-use-a-transient-study-or-take-56cc = use a transient study, or take the free drive away
diag-the-times-must-begin-at-0-0bad = the times must begin at 0
diag-both-a-programme-and-are-given-4c93 = both a programme and { $given } are given
diag-how-long-the-change-of-speed-5c35 = how long the change of speed takes is missing
diag-add-duration-10-s-or-a-7616 = add duration = "10 s", or a programme of times and speeds
diag-both-a-polynomial-and-to-are-f613 = both a polynomial and to are given
diag-neither-the-study-nor-the-machine-29cc = neither the study nor the machine says which speed to reach
diag-add-to-3000-rpm-0fb7 = add to = "3000 rpm"
diag-from-and-to-are-both-2250 = from and to are both { $speed }
diag-this-stays-at-5025 = this { $field } stays at { $speed }
diag-from-and-the-speed-of-the-93ff = from and the speed of the machine are both { $speed }
diag-a-run-up-needs-two-different-5573 = a run-up needs two different speeds; { $said }
diag-give-another-speed-or-take-a-94e2 = give another speed, or take a transient study for a constant speed

## laval/src/study/motion/spectra/mod.rs

diag-there-is-fac5 = there is { $known }
diag-there-is-no-body-96f6 = there is no body "{ $name }"
diag-spectra-up-to-order-of-this-f7e0 = spectra up to order { $highest } of this record need { $total } samples, which are too many
diag-at-most-lower-highest-order-or-75cb = at most { $most }: lower highest_order, or follow a shorter motion

## laval/src/study/motion/start.rs

diag-there-is-no-coordinate-or-state-1f90 = there is no coordinate or state "{ $name }"
diag-is-it-must-lie-between-and-e08b = "{ $name }" is { $value }; it must lie between { $least } and { $most } in SI units
diag-is-given-twice-6139 = "{ $name }" is given twice
diag-has-ebf9 = "{ $part }" has { $own }
diag-this-machine-has-58cb = this machine has { $names }

## laval/src/study/motion/steady_state/stored.rs

diag-there-is-no-column-4b0b = there is no column "{ $name }"

## laval/src/study/motion/sweep/mod.rs

diag-at-one-speed-nonlinear-response-finds-425e = { $help }; at one speed nonlinear_response finds the steady motions, basins and transient where a start leads
diag-a-sweep-needs-speeds-above-there-49bc = a sweep needs speeds above { $least }: there is no period at rest
diag-give-the-range-fewer-points-or-9d64 = give the range fewer points, or leave out the waterfall
diag-the-spin-of-this-machine-is-9eab = the spin of this machine is free: it has no speed of its own to be swept
diag-is-no-displacement-or-tilt-of-e52c = "{ $name }" is no displacement or tilt of a body
diag-name-one-such-as-0026 = name one such as { $known }

## laval/src/study/motion/transient.rs

diag-neither-the-study-nor-the-machine-bf96 = neither the study nor the machine says the spin speed
diag-add-speed-3000-rpm-to-machine-1ffb = add speed = "3000 rpm" to [machine] or to the study
diag-a-kick-changes-rates-only-2906 = a kick changes rates only
diag-name-rates-with-such-as-drum-cc29 = name rates with ', such as "drum.x'"
diag-the-kick-at-comes-after-the-1d6d = the kick at { $at } comes after the end at { $duration }
diag-outputs-are-too-many-cef8 = { $step } outputs are too many
diag-at-most-1000000-outputs-a3ad = at most 1000000 outputs
diag-both-output-step-and-points-are-e4e5 = both output_step and points are given
diag-the-duration-must-be-positive-3a15 = the duration must be positive

## laval/src/study/nonlinear/backbone.rs

diag-amplitude-must-go-from-a-lower-9ac3 = amplitude must go from a lower to a higher value
diag-exchange-from-and-to-b115 = exchange from and to

## laval/src/study/nonlinear/bifurcation_loci/mod.rs

diag-the-range-of-speeds-comes-too-4b94 = the range of speeds comes too near to standstill, where no unbalance acts
diag-keep-both-ends-above-or-both-75ce = keep both ends above { $slowest }, or both below { $lowest } for rotation the other way round
diag-the-response-at-values-is-too-4ab4 = the response at { $points } values is too much
diag-points-is-the-number-of-values-4cb3 = points is the number of values at which loci are started: at most { $most }
diag-a-steady-response-is-computed-at-5056 = a steady response is computed at constant speed, and the speed of this machine is free
diag-prescribe-the-speed-of-the-machine-c769 = prescribe the speed of the machine: leave out its free drive
diag-the-machine-does-not-exist-at-0b99 = the machine does not exist at any value tried of { $path }; at { $at }: { $why }
diag-the-stability-of-this-machine-s-7f76 = the stability of this machine's motions cannot be assessed: { $why }
diag-kinds-folds-needs-no-stability-641f = kinds = "folds" needs no stability

## laval/src/study/nonlinear/free_motion.rs

diag-free-whirls-are-sought-at-constant-efd0 = free whirls are sought at constant speed, and the speed of this machine is free
diag-prescribe-the-speed-of-the-machine-cac7 = prescribe the speed of the machine (leave out its free drive), or follow the free machine in time with a transient study

## laval/src/study/nonlinear/methods.rs

diag-the-methods-are-compared-at-constant-0e38 = the methods are compared at constant speed, and the speed of this machine is free
diag-prescribe-the-speed-of-the-machine-176a = prescribe the speed of the machine (leave out its free drive)

## laval/src/study/nonlinear/nonlinear_response/mod.rs

diag-the-stored-response-is-of-one-2c20 = the stored response is of one speed, and this study is over a range
diag-order-of-the-base-frequency-does-bd3d = order { $h } of the base frequency does not reach the unbalance, which has order { $divisor }
diag-with-subharmonic-n-orders-count-in-3fdb = with subharmonic = n, orders count in steps of speed / n: keep at least n of them
diag-motions-of-turns-of-the-rotor-b128 = motions of { $divisor } turns of the rotor have no symmetry by a { $symmetry }: only those of an odd number of turns do
diag-write-symmetry-none-or-an-odd-deb5 = write symmetry = "none", or an odd number for subharmonic

## laval/src/study/nonlinear/progress.rs

diag-steady-response-at-3e8c = steady response at { $speed }
diag-branch-from-the-lowest-speed-at-2bf4 = branch from the lowest speed, at { $speed }
diag-branch-from-the-highest-speed-at-0be3 = branch from the highest speed, at { $speed }
diag-further-branch-at-c050 = further branch, at { $speed }
diag-stability-of-the-branch-from-the-29af = stability of the branch from the lowest speed, at { $speed }
diag-stability-of-the-branch-from-the-a793 = stability of the branch from the highest speed, at { $speed }
diag-stability-of-a-further-branch-at-5e02 = stability of a further branch, at { $speed }

## laval/src/study/nonlinear/response_map/mod.rs

diag-vary-two-parameters-for-one-see-e9a8 = vary two parameters; for one, see nonlinear_response with uncertainty, or give y another
diag-a-map-of-by-machines-is-1075 = a map of { $x } by { $y } machines is too large
diag-at-most-machines-in-all-be30 = at most { $most } machines in all
diag-is-spaced-in-equal-ratios-but-54d2 = { $field } is spaced in equal ratios, but does not begin above 0
diag-begin-above-0-or-leave-out-53e4 = begin above 0, or leave { $spacing } out

## laval/src/study/nonlinear/stationary/chart.rs

diag-cells-of-the-chart-7498 = cells of the chart

## laval/src/study/nonlinear/stationary/mod.rs

diag-the-chart-has-too-many-cells-daa9 = the chart has too many cells
diag-at-most-speeds-times-values-4009 = at most { $most } speeds times values
diag-needs-the-speed-of-the-state-7fe7 = { $field } needs the speed of the state that is meant
diag-give-stabilise-at-3000-rpm-or-1a65 = give stabilise_at = "3000 rpm", or a speed in [machine]
diag-stationary-states-are-sought-at-given-86e6 = stationary states are sought at given speeds, and the speed of this machine is free
diag-prescribe-the-speed-of-the-machine-7fd4 = prescribe the speed of the machine, or follow the free machine in time with a transient study
diag-at-ff93 = at { $path } = { $x }: { $message }
diag-starts-to-follow-65c8 = starts to follow
diag-starts-to-follow-where-no-state-812e = starts to follow where no state is stable

## laval/src/study/overview/over_frequency.rs

diag-modes-with-frequencies-outside-the-table-1aa5 = modes with frequencies outside the table of "{ $name }" are not known

## laval/src/study/parameters/optimum/machine.rs

diag-name-each-once-190a = name each once
diag-the-bounds-must-go-from-a-c5c6 = { $path }: the bounds must go from a lower to a higher value
diag-is-not-admissible-6d63 = { $path }: { $x } { $unit } is not admissible

## laval/src/study/parameters/optimum/mod.rs

diag-runs-of-the-study-at-most-7d3f = runs of the study { $kind } at most

## laval/src/study/parameters/optimum/request.rs

diag-one-number-can-be-made-small-4ee5 = one number can be made small or large, not two at once
diag-leave-out-minimise-or-maximise-and-6712 = leave out minimise or maximise, and give the other number a limit by at_most or at_least
diag-nothing-is-named-that-should-become-6ec6 = nothing is named that should become small or large
diag-write-minimise-largest-displacement-or-maximise-3d38 = write minimise = "largest_displacement", or maximise = "widest_window"
diag-the-limit-on-is-how-far-18f2 = the limit on "{ $name }" is { $value }: how far it is kept is measured by its size
diag-give-a-number-other-than-zero-cc0a = give a number other than zero
diag-it-finds-3a16 = it finds: { $all }
diag-the-study-finds-no-number-of-fd93 = the study { $kind } finds no number "{ $name }" of this machine
diag-the-limit-on-6641 = the limit on "{ $name }": { $message }
diag-parameters-are-too-many-to-search-ed70 = { $count } parameters are too many to search

## laval/src/study/parameters/uncertainty/mod.rs

diag-runs-of-the-study-56de = runs of the study { $kind }
diag-samples-of-parameters-require-runs-which-5bcc = { $samples } samples of { $k } parameters require { $runs } runs, which are too many
diag-at-most-runs-in-all-ae2b = at most { $most } runs in all
diag-parameters-need-dimensions-the-sobol-sequence-167d = { $k } parameters need { $dimensions } dimensions; the Sobol sequence has { $most }
diag-use-method-monte-carlo-82d8 = use method = "monte_carlo"

## laval/src/study/parameters/uncertainty/tolerance.rs

diag-name-x-or-y-b884 = name { $path }.x or { $path }.y
diag-its-values-in-x-and-y-af7c = its values in x and y differ, so that there is no single one to be uncertain
diag-give-its-standard-deviation-a-tolerance-7843 = give its standard deviation: a tolerance that 99.7 % of the parts keep is three of them
diag-it-takes-7437 = it takes { $allowed }
diag-a-distribution-has-no-0fa8 = a distribution "{ $distribution }" has no { $other }
diag-the-standard-deviation-is-missing-81a3 = the standard deviation is missing
diag-add-deviation-2-440b = add deviation = "2 %"
diag-the-machine-s-value-is-0-d673 = the machine's value is 0, of which every share is 0: give a number with a unit
diag-it-must-be-above-0-7e37 = it must be above 0
diag-a-standard-deviation-of-leaves-nothing-4f0b = a standard deviation of { $deviation } leaves nothing uncertain
diag-a-log-normal-number-is-positive-29ac = a log-normal number is positive, its mean cannot be { $mean }
diag-use-normal-or-give-a-mean-b5e5 = use "normal", or give a mean
diag-either-from-and-to-or-tolerance-38f5 = either from and to, or tolerance, is needed
diag-write-tolerance-5-or-from-to-8859 = write tolerance = "5 %", or from = .., to = ..
diag-the-machine-s-value-is-0-bcf9 = the machine's value is 0, of which every share is 0: give numbers with a unit
diag-from-must-lie-below-to-2ee8 = from must lie below to
diag-there-is-nothing-between-and-3b19 = there is nothing between { $from } and { $to }
diag-is-not-admissible-for-this-parameter-c787 = { $value } is not admissible for this parameter
diag-narrow-the-interval-69e6 = narrow the interval
diag-its-most-probable-value-lies-outside-fd45 = its most probable value, { $mode }, lies outside { $from } to { $to }
diag-give-mode-or-other-ends-6d7c = give mode, or other ends

## laval/src/study/shared/limits.rs

diag-names-a-point-that-does-not-8b5a = { $field } names "{ $n }", a point that "{ $body }" does not have
diag-it-reaches-from-to-517d = it reaches from { $from } to { $to }
diag-there-are-a-point-of-a-a331 = there are { $all }; a point of a body is written as "drum at 100 mm"
diag-there-are-f68d = there are { $all }
diag-names-which-is-no-body-of-c478 = { $field } names "{ $n }", which is no body of this machine
diag-names-which-is-no-body-that-b6c8 = { $field } names "{ $n }", which is no body that tilts of this machine
diag-names-which-is-no-part-with-b98a = { $field } names "{ $n }", which is no part with a force
diag-names-which-is-no-part-with-b270 = { $field } names "{ $n }", which is no part with a moment
diag-rated-density-belongs-to-a-highest-83e1 = rated_density belongs to a highest speed, which is missing
diag-add-speed-8e93 = add speed

## laval/src/study/shared/operation.rs

diag-run-up-time-needs-an-operating-a26f = run_up_time needs an operating speed, which neither [operation] nor [machine] gives
diag-needs-an-operating-speed-which-neither-3164 = { $field } needs an operating speed, which neither [operation] nor [machine] gives
diag-operating-speeds-begin-above-standstill-and-7f11 = operating speeds begin above standstill and have one direction of rotation
diag-write-the-speed-at-which-the-49ba = write the speed at which the machine runs, as in speed = "3000 rpm"; leave speed out where [machine] gives it
diag-write-the-lowest-speed-at-which-520c = write the lowest speed at which the machine runs in place of 0: the run-up from standstill is not part of this range
diag-the-operating-speeds-must-go-from-00fe = the operating speeds must go from a lower to a higher value
diag-from-is-and-to-is-exchange-b990 = from is { $from } and to is { $to }: exchange them
diag-the-speed-of-machine-is-not-8ca9 = the speed of [machine], { $w }, is not among the operating speeds, { $low } to { $high }
diag-give-the-speed-in-one-of-bf60 = give the speed in one of the two places, or change one of them

## laval/src/study/shared/presentation.rs

diag-write-file-si-or-units-such-3458 = write file, si, or units such as "rpm, mm, kN"

## laval/src/study/shared/size.rs

diag-spectra-of-states-6d66 = { $speeds } spectra of { $states } states
diag-rows-of-numbers-866d = { $rows } rows of { $columns } numbers
diag-give-fewer-points-6535 = give fewer points
diag-take-about-gb-of-memory-more-e408 = { $of } take about { $needed } GB of memory, more than the { $most } GB allowed

## laval/src/study/shared/speed_range.rs

diag-this-study-knows-one-spin-and-77ac = this study knows one spin, and the machine has another one, "{ $name }"
diag-modes-campbell-critical-speeds-stability-map-4ae2 = modes, campbell, critical_speeds, stability_map, forced_response, harmonic_force, static, transient and run_up take several spins
diag-the-study-needs-the-coefficients-of-46db = the study needs the coefficients of "{ $name }" at { $from }; its table goes from { $low } to { $high }
diag-the-study-needs-the-coefficients-of-bb45 = the study needs the coefficients of "{ $name }" from { $from } to { $to }; its table goes from { $low } to { $high }
diag-turns-times-as-fast-as-the-880f = "{ $name }" turns { $ratio } times as fast as the machine, and its table is over that speed: write negative speeds, and cross-coupled coefficients for that direction
diag-keep-to-speeds-of-the-table-c95a = keep to speeds of the table, add rows to it, or write beyond = "hold" or beyond = "linear" in "{ $name }": results beyond are then marked

## laval/src/study/shared/support.rs

diag-with-roots-are-counted-where-they-c786 = with { $name } roots are counted where they grow: whether one decays more slowly than at a growth_threshold below 0 is not known
diag-give-a-growth-threshold-of-0-2976 = give a growth_threshold of 0 or more; a transient shows how fast a motion dies out
diag-this-study-needs-a-spin-speed-9f43 = this study needs a spin speed
diag-give-speed-3000-rpm-here-or-331c = give speed = "3000 rpm" here, or once for all studies in [machine]
diag-give-two-values-that-differ-9f93 = give two values that differ
diag-modes-forced-response-stability-map-and-3533 = { $help }; modes, forced_response, stability_map and transient take one speed
diag-is-one-value-and-this-study-31a8 = { $field } is one value, and this study needs a range
diag-write-2145 = write { $field } = {"{"} from = .., to = .. {"}"}
diag-must-go-from-a-lower-to-a4b0 = { $field } must go from a lower to a higher value
diag-needs-ends-farther-apart-bf86 = { $field } needs ends farther apart
diag-is-too-narrow-its-ends-differ-11bf = { $field } is too narrow: its ends differ by less than a billionth
diag-needs-at-least-points-6b87 = { $field } needs at least { $least } points
diag-leave-points-out-for-a-fitting-7f88 = leave points out for a fitting number
diag-requires-points-which-are-too-many-10f6 = { $field } requires { $points } points, which are too many
diag-at-most-points-a673 = at most { $most } points

## laval/src/study/shared/supporting.rs

diag-is-named-twice-b544 = "{ $name }" is named twice
diag-there-is-no-part-8a0d = there is no part "{ $name }"
diag-does-not-join-a-turning-body-fc00 = "{ $name }" does not join a turning body to anything
diag-parts-that-join-a-turning-body-fe2b = parts that join a turning body to something: { $names }

## laval/src/study/shared/vibration.rs

diag-the-coefficients-of-depend-on-the-57ae = the coefficients of "{ $name }" depend on the frequency of vibration, and this study does not take such a part
diag-modes-campbell-critical-speeds-forced-response-790a = modes, campbell, critical_speeds, forced_response and harmonic_force take it; for this study give a table over the speed alone
diag-the-study-needs-the-coefficients-of-3837 = the study needs the coefficients of "{ $name }" at a frequency of vibration of { $from }; its table goes from { $low } to { $high }
diag-the-study-needs-the-coefficients-of-1fc0 = the study needs the coefficients of "{ $name }" at frequencies of vibration from { $from } to { $to }; its table goes from { $low } to { $high }
diag-keep-to-frequencies-of-the-table-734e = keep to frequencies of the table, add rows to it, or write beyond = "hold" or beyond = "linear" in "{ $name }": results beyond are then marked

## laval/src/validation/case.rs

diag-the-page-has-no-title-2925 = the page has no title
diag-begin-with-and-the-title-83c9 = begin with # and the title
diag-the-page-has-no-section-d2bd = the page has no section "{ $name }"
diag-add-fcbe = add ## { $name }
diag-the-section-is-empty-0b37 = the section "{ $name }" is empty
diag-the-page-has-no-machine-c709 = the page has no machine
diag-put-a-machine-file-between-toml-2325 = put a machine file between ```toml machine and ```
diag-no-value-is-expected-22f6 = no value is expected
diag-the-section-expected-has-no-table-c765 = the section "Expected" has no table
diag-the-page-states-but-its-rows-f7c0 = the page states "{ $stated }", but its rows make it "{ $follows }"
diag-the-page-states-but-its-rows-0743 = the page states "{ $stated }", but its rows without an explanation make it "{ $follows }"
diag-an-explanation-stands-under-3fb0 = an explanation stands under ## { $title }
diag-the-page-does-not-say-its-f080 = the page does not say its { $name }
diag-add-a-row-to-its-first-8318 = add a row | { $name } | ... | to its first table
diag-is-no-kind-of-evidence-bf15 = "{ $text }" is no kind of evidence
diag-kinds-bca8 = kinds: { $all }
diag-is-no-verdict-9eae = "{ $text }" is no verdict
diag-verdicts-aed9 = verdicts: { $all }

## laval/src/validation/check.rs

diag-study-d667 = study "{ $study }", { $value }: { $message }
diag-two-studies-of-this-page-are-65d7 = two studies of this page are named "{ $name }"
diag-give-each-study-of-the-page-b597 = give each study of the page a name of its own
diag-study-0e6f = study "{ $name }": { $message }
diag-there-is-no-such-study-did-9e00 = there is no such study; did you mean { $near }?
diag-there-is-no-such-study-studies-0c07 = there is no such study; studies: { $names }

## laval/src/validation/table.rs

diag-columns-d1e7 = columns: { $names }
diag-is-no-column-of-expected-values-1c61 = "{ $text }" is no column of expected values
diag-the-table-of-expected-values-has-2910 = the table of expected values has no column "{ $name }"
diag-this-row-has-cells-the-head-f3a7 = this row has { $cells } cells, the head of the table has { $head }
diag-write-a-bar-inside-a-cell-27c3 = write a bar inside a cell as \|
diag-names-no-number-641a = "{ $value }" names no number
diag-write-table-column-finding-id-point-5e10 = write TABLE / COLUMN, finding ID, point KIND, or count of points KIND
diag-chooses-no-row-215f = "{ $at }" chooses no row
diag-write-column-value-column-near-value-5781 = write COLUMN = VALUE, COLUMN near VALUE, near VALUE, nr N, first, last, largest or smallest, with commas between
diag-is-no-number-1ee1 = "{ $expected_text }" is no number
diag-write-a-number-below-number-or-9700 = write a number, below NUMBER or above NUMBER; the unit has a column of its own
diag-is-no-unit-c915 = "{ $unit }" is no unit: { $why }
diag-nothing-is-near-zero-relatively-8c8d = nothing is near zero relatively
diag-give-an-absolute-tolerance-ee84 = give an absolute tolerance
diag-is-no-tolerance-c48d = "{ $text }" is no tolerance
diag-write-number-relative-or-number-absolute-5828 = write NUMBER relative or NUMBER absolute (in the unit of the row), above zero
diag-a-bound-has-no-tolerance-39ac = a bound has no tolerance
diag-leave-the-cell-empty-4f74 = leave the cell empty
diag-is-no-scatter-a3e2 = "{ $text }" is no scatter
diag-write-number-relative-or-number-absolute-1921 = write NUMBER relative or NUMBER absolute
diag-is-no-verdict-of-a-row-57c7 = "{ $text }" is no verdict of a row
diag-write-agrees-within-source-scatter-or-587e = write agrees, within source scatter or differs

## laval/src/validation/value.rs

diag-there-is-no-table-436e = there is no table "{ $name }"; { $known }
diag-there-is-no-finding-02c2 = there is no finding "{ $id }"; { $list }
diag-the-finding-has-no-number-4631 = the finding "{ $id }" has no number
diag-there-is-no-special-point-d8e6 = there is no special point "{ $kind }"; { $kinds }
diag-this-study-has-no-tables-7eca = this study has no tables
diag-tables-4319 = tables: { $names }
diag-this-study-has-no-columns-f570 = this study has no columns
diag-this-study-has-no-findings-ef54 = this study has no findings
diag-findings-d1c2 = findings: { $names }
diag-this-study-has-no-special-points-42e1 = this study has no special points
diag-special-points-4d1f = special points: { $names }
diag-this-study-has-no-evidence-a7b1 = this study has no evidence
diag-evidence-442f = evidence: { $names }
diag-there-is-no-evidence-687a = there is no evidence "{ $what }"; { $list }
diag-there-is-no-table-976e = there is no table "{ $table }"; { $list }
diag-table-has-no-column-fd60 = table "{ $table }" has no column "{ $name }"; { $list }
diag-table-has-no-rows-2058 = table "{ $table }" has no rows
diag-column-holds-no-numbers-56ce = column "{ $column }" holds no numbers
diag-column-is-yes-or-no-not-311a = column "{ $name }" is yes or no, not "{ $value }"
diag-points-and-findings-have-no-columns-05d3 = points and findings have no columns
diag-no-row-fits-b5e9 = no row fits
diag-rows-fit-say-which-one-in-6aea = { $n } rows fit: say which one in the column "at"

## laval-studio/src/answer.rs

diag-the-machine-file-gives-no-speed-4340 = the machine file gives no speed
diag-the-figure-cannot-be-drawn-666c = the figure cannot be drawn: { $e }

## laval-studio/src/edit.rs

diag-one-of-value-and-written-is-a69e = { $path }: one of value and written is needed

## laval-studio/src/folder.rs

diag-is-no-machine-file-toml-in-cfe5 = { $name } is no machine file (.toml) in the folder of the studio
diag-there-is-no-file-33b6 = there is no file { $path }
diag-is-larger-than-mb-3ad7 = { $path } is larger than { $size } MB
diag-is-a-folder-53b6 = { $path } is a folder
diag-has-changed-on-the-disk-since-3764 = { $path } has changed on the disk since it was opened

## laval-studio/src/motion.rs

diag-the-request-names-no-motion-2e64 = the request names no motion
diag-the-response-has-no-bound-at-244c = the response has no bound at this speed: an undamped resonance
diag-no-state-of-the-nonlinear-response-5f5e = no state of the nonlinear response was found at this speed
diag-the-file-has-no-transient-e71e = the file has no transient { $name }

## laval-studio/src/reach.rs

diag-there-is-no-result-that-can-f05c = there is no result { $what } that can be moved

## laval-studio/src/routes.rs

diag-the-request-cannot-be-read-8f3c = the request cannot be read: { $e }
diag-this-is-a-defect-of-the-4010 = this is a defect of the program, not of your file: the computation failed
diag-there-is-no-such-run-165f = there is no such run

## laval-studio/src/runs.rs

diag-the-machine-has-no-such-study-f80c = the machine has no such study
diag-the-study-cannot-be-started-3c9f = the study cannot be started: { $e }
diag-the-report-cannot-be-drawn-a076 = the report cannot be drawn: { $e }

## laval-studio/src/server.rs

diag-the-server-cannot-be-started-9a0d = the server cannot be started: { $e }
diag-a-token-has-at-least-8-da81 = a token has at least 8 letters and digits
diag-cannot-open-9fcf = cannot open { $path }: { $e }
diag-is-a-link-out-of-its-b2fe = { $path } is a link out of its folder
diag-port-cannot-be-used-ed07 = port { $port } cannot be used: { $e }
diag-give-another-port-or-leave-port-5c64 = give another port, or leave --port out: a free one is taken

## laval-studio/src/share.rs

diag-at-most-designs-fit-into-one-c17c = at most { $most } designs fit into one file

## laval-studio/src/start.rs

diag-there-is-no-example-1e32 = there is no example { $name }
diag-name-a-file-or-an-example-9b54 = name a file or an example

## laval-cli/src/check.rs

diag-ok-de5c = ok: { $machine }
diag-part-193f = { $n } part
diag-parts-799d = { $n } parts
diag-coordinate-a21a = { $n } coordinate
diag-coordinates-ea2c = { $n } coordinates
diag-internal-state-da0f = { $n } internal state
diag-internal-states-7af1 = { $n } internal states
diag-no-studies-e162 = no studies

## laval-cli/src/import.rs

diag-left-out-or-different-in-ross-343d = Left out, or different in ROSS:

## laval-cli/src/input.rs

diag-is-a-folder-not-a-machine-7bfd = { $path } is a folder, not a machine file
diag-give-the-file-20d8 = give the file: { $inside }
diag-is-larger-than-64-mb-6cae = { $path } is larger than 64 MB
diag-laval-new-writes-a-machine-file-4dc1 = laval new writes a machine file to start from

## laval-cli/src/interrupt.rs

diag-warning-ctrl-c-will-stop-at-f5b8 = warning: Ctrl-C will stop at once and lose what is not yet written ({ $e })

## laval-cli/src/lib.rs

diag-note-threads-cannot-be-started-one-a291 = note: { $wanted } threads cannot be started ({ $e }): one computes. RAYON_NUM_THREADS says how many are wanted.
diag-laval-this-is-a-defect-of-ae66 = laval: this is a defect of the program, not of your file. Please report it with the machine file and the message above

## laval-cli/src/new.rs

diag-templates-877f = templates: { $all }
diag-there-is-no-template-a3c1 = there is no template { $word }
diag-exists-and-is-not-overwritten-c379 = { $path } exists and is not overwritten
diag-name-another-file-with-out-8c40 = name another file with --out

## laval-cli/src/pdf.rs

diag-no-chromium-was-found-to-print-c305 = no Chromium was found to print the report with
diag-install-one-of-or-open-in-6eb6 = install one of { $names }, or open { $page } in a browser and print it
diag-could-not-print-the-report-90eb = { $browser } could not print the report: { $why }

## laval-cli/src/pieces.rs

diag-no-study-of-divides-into-parts-548e = no study of { $file } divides into parts
diag-leave-out-part-laval-run-computes-7c4e = leave out --part: laval run computes all of them
diag-parts-are-requested-and-no-study-4ded = { $of } parts are requested, and no study of { $file } divides into more than { $most }
diag-number-the-parts-from-1-to-d23e = number the parts from 1/{ $most } to { $most }/{ $most }, or take fewer; laval plan says how each study divides

## laval-cli/src/progress.rs

diag-about-left-b4f4 = { $done }, about { $left } left
diag-done-a112 = { $percent } % done
diag-1-step-done-2d12 = 1 step done
diag-steps-done-0233 = { $steps } steps done
diag-computing-for-ab42 = computing for { $time }
diag-after-7501 = { $done } after { $time }
diag-s-b884 = { $n } s
diag-min-4434 = { $n } min
diag-h-76f9 = { $n } h
diag-days-910f = { $n } days

## laval-cli/src/run.rs

diag-contains-no-study-e25a = { $file } contains no study
diag-add-a-study-block-laval-studies-c25e = add a [[study]] block; laval studies lists the kinds
diag-stopping-ctrl-c-again-stops-at-3a4d = stopping; Ctrl-C again stops at once
diag-not-run-3464 = not run: { $left }
diag-warning-also-holds-results-of-study-0789 = warning: { $out } also holds results of study { $names }, which is of an earlier machine file
diag-warning-also-holds-results-of-studies-8275 = warning: { $out } also holds results of studies { $names }, which are of an earlier machine file
diag-pdf-prints-report-html-which-format-eca7 = --pdf prints report.html, which --format leaves out
diag-laval-study-has-no-result-1a9b = laval: study "{ $name }" has no result
diag-laval-7bec = laval: { $why }

## laval-cli/src/show.rs

diag-there-is-no-kind-of-called-63a8 = there is no kind of { $what } called { $word }

## laval-cli/src/studio.rs

diag-is-no-machine-file-its-name-3c42 = { $path } is no machine file: its name does not end in .toml
diag-the-studio-is-open-in-the-faee = The studio is open in the browser; Ctrl-C ends it.
diag-note-no-browser-could-be-opened-e857 = note: no browser could be opened; open the address above

## laval-cli/src/terminal.rs

diag-laval-cannot-write-to-standard-output-26ab = laval: cannot write to standard output: { $e }

## laval-cli/src/validate.rs

diag-of-cases-are-not-as-their-544a = { $n } of { $all } cases are not as their pages state
diag-there-is-no-case-in-3f6d = there is no case in { $folder }
diag-a-case-is-a-page-topic-2974 = a case is a page TOPIC/CASE.md; docs/validation.md says how to write one
diag-no-case-has-in-its-name-a164 = no case has { $text } in its name
diag-there-is-no-folder-validation-here-49db = there is no folder "validation" here or above
diag-run-inside-the-source-repository-of-1fee = run inside the source repository of laval, or name a folder of cases
diag-laval-cannot-write-fadf = laval: cannot write { $path }: { $e }
