# The first page of a report, and the summary in the terminal.

# Verdicts.
verdict-passed = met
verdict-no_limit = no limit set
verdict-not_computed = not computed
verdict-attention = attention
verdict-failed = not met

# The same, short, for the terminal.
short-passed = ok
short-no_limit = no limit
short-not_computed = not known
short-attention = attention
short-failed = NOT MET
short-near = near

# Headline.
headline-stable = Stable at { $speed }.
headline-stable-below = Stable at { $speed }, as far as modes below { $limit } show.
headline-unstable = Unstable at { $speed }. Do not run the machine at this speed.
headline-not-proven = Stability at { $speed } is not proven.
headline-unknown = Stability at { $speed } was not computed.
headline-unknown-table = Stability at { $speed } was not computed: the coefficients of "{ $part }" hold only at frequencies of vibration from { $from } to { $to }; the study "modes" gives the modes at these frequencies, and rows for other frequencies in the table give the rest.
headline-no-speed = No operating speed is set.
headline-limit = Not met: { $checks }.
headline-not-checked = Required and not checked: { $checks }.
headline-studies-not-run = Not included are these studies of the file: { $studies }. They may find more: run them.
headline-attention = Needs attention: { $checks }.
headline-several = Which of several steady responses occurs depends on the run-up.
headline-validity = Not all results are within validity.
headline-buckled = At rest the machine does not hold its position (buckling): a displacement grows by the factor e in { $time }.
headline-jump = { $kind ->
        [jump] The response jumps at { $speed }
       *[bifurcation] The stability of the response changes at { $speed }
    }, { $side ->
        [inside] among the operating speeds
        [above] { $margin } above the operating speed
       *[below] { $margin } below the operating speed
    }.
headline-resonance = The nearest resonance, { $resonance }, is only { $margin } away.
headline-resonance-inside = The resonance at { $resonance } lies among the operating speeds.
headline-near-instability = The nearest instability is only { $margin } away.
headline-crosses = { $count ->
        [one] The run-up crosses an unstable range, { $from } to { $to }.
       *[other] The run-up crosses { $count } unstable ranges between { $from } and { $to }.
    }
headline-crosses-open = On the way up the machine is unstable from { $from } on (examined up to { $to }).
headline-slip = The run-up crosses { $from } to { $to } without a stable synchronous state.

# Remarks below it.
remark-here = At { $speed }
remark-below = On the way up
remark-above = Above
remark-unstable = { $open ->
        [yes] Unstable from { $from } on (examined up to { $to }):
        [below] Unstable up to { $to } (examined from { $from }):
        [both] Unstable at all speeds examined, { $from } to { $to }:
       *[no] Unstable from { $from } to { $to }:
    } { $oscillates ->
        [yes] whirl at { $frequency }
       *[no] motion without oscillation
    } grows by the factor e in { $time } at the worst speed.
remark-resonance = Resonance at { $speed }, "{ $body }" { $value }.
remark-resonance-unbounded = Undamped resonance at { $speed }: the amplitude of "{ $body }" has no bound.
remark-resonances = Further resonances at { $speeds }.
remark-critical = Critical speed { $speed }.
remark-jump = { $count ->
        [one] A slow run jumps at { $speeds }.
       *[other] A slow run jumps at { $speeds }.
    }
remark-harm = From { $from } to { $to } the balls increase the unbalance up to { $times } times.
remark-stability = { $text }.
remark-vibration = Vibration: { $text }.
remark-forces = Forces: { $text }.

# Checks: name, result, requirement.
check-stability = Stability
check-instability = Nearest instability
check-resonance = Nearest resonance
check-jump = Nearest jump or bifurcation
check-vibration = Vibration
check-shaft-vibration = Shaft vibration in bearings
check-housing-vibration = Vibration of bearing housings
check-balance = Balance quality
check-velocity = Vibration velocity
check-forces = Forces
check-validity = Validity
check-balls = Unbalance with balls
check-run-up = Run-up
check-window = Operating window
check-speed = Highest speed
check-others = Other limits
check-studies = Requirements of studies
check-damping = Damping

required-decay = { $margin ->
        [none] decaying
       *[other] decay ≥ { $margin }
    }
required-below = ≤ { $limit }
required-each = ≤ limits
required-above = ≥ { $limit }
required-balance = { $grade }: ≤ { $limit }
required-validity = inside
required-less-unbalance = less than without

stability-stable = { $modes ->
        [one] the mode decays at { $decay }
       *[other] all { $modes } modes decay, the slowest at { $decay }
    }
stability-stable-below = { $modes ->
        [one] the mode below { $limit } decays at { $decay }
       *[other] all { $modes } modes below { $limit } decay, the slowest at { $decay }
    }
stability-across = { $modes ->
        [one] the mode across the axis decays at { $decay }
       *[other] all { $modes } modes across the axis decay, the slowest at { $decay }
    }; vibration along or about it has no damping
stability-unstable = { $motion ->
        [divergence] statically unstable (divergence): a displacement
       *[whirl] the machine whirls: the amplitude
    } grows by the factor e in { $time }
stability-steady = the steady response is stable at this speed (nonlinear response)
stability-decays = the slowest mode decays at { $decay }
stability-unknown = no mode found grows, but some may be missing
stability-slow = no growth above { $limit }; slower growth is not resolved
stability-neutral = the least damped mode has no damping
stability-balanced = the balanced state is stable
stability-state = a state that does not balance is stable
stability-no-state = no stable synchronous state at this speed
stability-needs-stationary = balls move in the rotor: needs a study "stationary"
stability-no-steady = no steady response is stable at this speed (nonlinear response)
stability-several = { $count } stable steady responses at this speed (nonlinear response)
stability-beside = stable at rest, but so is a whirl of { $value }: a disturbance may lead to it
stability-outside-study = the study "stationary" does not cover this speed
stability-unstable-range = unstable at operating speeds: { $range }
damping-no-oscillation = no mode oscillates
damping-least = logarithmic decrement { $decrement } at { $frequency }
stability-mode = { $place ->
        [none] at { $frequency }, logarithmic decrement { $decrement }
       *[other] at { $frequency }, logarithmic decrement { $decrement }; the least stable operating speed is { $place }
    }
stability-no-mode = the machine has no mode
distance-both = { $below } below, { $above } above
distance-below = { $below } below, none above up to { $to }
distance-above = none below, { $above } above
distance-stable-throughout = { $from ->
        [none] none found up to { $to }
       *[other] none found from { $from } to { $to }
    }
distance-inside-unstable = { $open ->
        [unknown] the operating speed is in an unstable range
        [yes] inside, unstable from { $from } on (examined up to { $to })
        [below] inside, unstable up to { $to } (examined from { $from })
        [both] inside, unstable at all speeds examined, { $from } to { $to }
       *[no] inside, unstable from { $from } to { $to }
    }
distance-inside = among the operating speeds: { $places }
distance-no-other-resonance = { $from ->
        [none] no other found up to { $to }
       *[other] no other found from { $from } to { $to }
    }
distance-critically-damped = critically damped at { $speeds }: amplification factor below 2.5, API 684 requires no separation margin
distance-not-examined = the distance required needs all speeds from { $from } to { $to }
distance-coarse = too few speeds computed: a narrow range may lie between two of them
distance-orders-open = resonances with excitation at { $orders } times the speed were not searched: add a study critical_speeds
distance-silent = forward critical speed at { $speeds }: the unbalance of this file does not excite it, another one may
distance-no-resonance = { $from ->
        [none] none found up to { $to }
       *[other] none found from { $from } to { $to }
    }
item-of = { $name } { $value } of { $limit }
item = { $name } { $value }
item-force = { $rest ->
        [none] { $name } { $value }
       *[other] { $name } { $value } (static { $rest })
    }
both = { $first }; { $second }
vibration-sizes = { $sizes }
vibration-velocity = { $name } { $peak } peak velocity
velocity-sizes = { $sizes } (peak)
velocity-is = largest { $value } (peak)
vibration-nonlinear = largest stable response of the nonlinear machine
vibration-states = largest stable state of the balls
vibration-contact = linear; { $parts } would touch, and the amplitude is not valid
vibration-touching = small vibration about rest, where { $parts } is already in contact
response-without-spins = without the unbalance of { $spins }, which "forced_response" with spin takes
response-with-spins = with the vibration of { $spins } added, from "forced_response" with spin
forces-without = without nonlinear parts: { $parts }
forces-not-linear = by the tangent at rest; more than a tenth away from the force of the same motion by the law of { $parts }: nonlinear_response decides
vibration-unbounded = undamped resonance at this speed
forces-none = of no part known
forces-sizes = { $sizes }
forces-with-rest = largest value over a turn with the static load, such as weight; the vibration is counted from the static deflection
validity-none = no part states a limit
validity-doubt = some results are in doubt, see the studies: { $names }
validity-statement = { $part }, { $what }
validity-inside = { $share } of the nearest limit: { $statement }
validity-elsewhere = inside at this speed; outside in the studies: { $outside }
validity-outside-here = { $ratio } times the limit: { $statement }
validity-unbounded = exceeded without bound: { $statement }
validity-nothing = no part was assessed at this speed
validity-studies-inside = no study of the file found anything outside
validity-studies = outside in the studies: { $outside }
window-none = no speed keeps all requirements
window-ranges = { $ranges }
speed-is = { $speed }
limits-left-out = not assessed on this page: { $names }
studies-requirements = not met, or not known to be, in { $studies }
check-run-study = run the study “{ $study }” of the file
balls-no-study = needs a study "stationary" or "transient"
balls-left = { $left } left of { $without }
run-up-computed = largest displacement { $value } ("{ $body }")
run-up-steady = largest displacement { $value } ("{ $body }"), at the end of the run-up
run-up-unknown = what lies below { $speed } is not known
run-up-contact = at slow passage the vibration closes the gap of { $parts }
run-up-grows = in unstable ranges a disturbance grows up to { $factor } times
run-up-diverges = the motion diverges
run-up-buckled = at rest the machine does not hold its position
run-up-free = crosses no resonance and no unstable range
run-up-resonances = { $count ->
        [one] crosses the resonance at { $resonances }
       *[other] crosses { $count } resonances, at { $resonances }
    }
run-up-unstable = crosses the unstable { $several ->
        [one] range
       *[other] ranges
    } { $ranges }
run-up-both = crosses { $count ->
        [one] the resonance at { $resonances }
       *[other] { $count } resonances, at { $resonances },
    } and the unstable { $several ->
        [one] range
       *[other] ranges
    } { $ranges }
speed-span = { $from } – { $to }
why-refused = not available for this machine: { $reason }
why-same = not available for the same reason
why-too-long = takes longer than a second; add the study to the file
from-study = from the study "{ $study }"
why-no-speed = no operating speed above 0 is set

# What to do next.
next-speed = Set speed in [machine]: the checks need an operating speed.
next-unstable = { $sides ->
        [both] Choose a speed below { $below } or above { $above }
        [below] Choose a speed below { $below }
        [above] Choose a speed above { $above }
       *[none] Choose a speed outside the unstable range
    }, or add damping; see the stability map.
next-viscosity = Give the liquid its viscosity: without it growth slower than { $limit } is not resolved.
next-validity = Follow the findings on validity: they name the results in doubt and what to change in the model.
next-buckled = { $count ->
        [0] Raise the stiffness that holds the machine at rest, or lower the compressive axial force.
       *[other] Raise the stiffness of { $parts } or lower the compression: it is negative in the shape that grows at rest.
    }
next-stability-map = Add a study "stability_map" to find stable speeds and the damping that is needed.
next-resonance = Move the operating speed or the resonance apart by { $margin } or more, or add damping.
next-balls = Add a study "stationary": at which speeds the balls balance.
next-harm = Hold the balls during the run-up, or pass the speeds below the stable range quickly.
next-jump = Move the operating speed and the jump apart by { $margin } or more, lower the unbalance, or add damping.
next-run-up = Simulate the run-up: add a study "run_up".
next-nonlinear = Add a study "nonlinear_response": the machine has nonlinear parts, and jumps are not excluded.
next-limits = Set { $keys } in [limits]: the results without a limit are not assessed.
next-studies = The file has no study: add [[study]] blocks, for instance { $kinds }; laval studies lists all kinds.

# What the page leaves out.
page-left-out = What this page leaves out
left-linear = Nonlinear parts ({ $parts }) are linearised about the equilibrium; large vibration and jumps need a study "nonlinear_response".
left-linear-modes = Stability and modes linearise the nonlinear parts ({ $parts }) about the equilibrium.
left-spins = The response to unbalance of other spins ({ $spins }) than that of the machine: it needs a study "forced_response" with spin.
left-motions = { $tilt ->
        [bends] Axial and torsional vibration.
        [yes] Axial and torsional vibration, and bending of bodies.
       *[no] Axial, torsional and tilting vibration, and bending of bodies.
    }
left-excitation = Excitation other than unbalance, such as misalignment, gears or an unsteady foundation.
left-drive = The motor: the spin speed is prescribed, and a motor that is too weak to pass a resonance is not seen.
left-steps = Unstable ranges narrower than { $step }.
left-steps-near = Unstable ranges narrower than { $step }, near the operating speed narrower than { $near }.

# Headings of the page.
page-checks = Checks
page-check = Check
page-result = Result
page-required = Required
page-verdict = Verdict
page-not-set = not set
page-over-speed = Behaviour over the speed
page-modes = Modes at { $speed }
page-machine = Machine
page-next = What to do next
page-findings = All findings
page-fill = fill { $fill }
page-balls = { $count ->
        [one] one ball
       *[other] { $count } balls
    }
page-mode = Mode { $number }
page-whirl = { $whirl ->
        [forward] forward
        [backward] backward
        [mixed] mixed
        [axial] along the axis
        [torsional] torsional
       *[none] no whirl
    }
page-decrement = decrement { $decrement }
page-grows = grows
page-not-resolved = slow growth not resolved
page-diverges = static instability (divergence)
axis-amplitude = amplitude
axis-growth = growth rate
strip-unstable = unstable
strip-not-examined = stability not examined
strip-response = unstable response
strip-jump = jump
axis-speed-plain = speed
axis-operating = operating speed
axis-operating-range = operating speeds
strip-stable-limit = stable below
caption-both = Amplitude of the linear unbalance response, and growth rate of the least stable mode.
caption-amplitude = Amplitude of the linear unbalance response.
caption-growth = Growth rate of the least stable mode.
strip-resonance = resonance

# The rest of the report.
page-evidence = evidence
page-evidence-all = Numerical evidence
page-evidence-finding = finding
page-evidence-value = value
page-evidence-checked = checked by
page-evidence-number = result
page-warning = Warning
page-outside = Outside validity
page-stopped = Stopped early
page-tables = Tables
page-points = Special points
page-work = Work done
page-input = Input
page-input-file = Input file { $file }
page-provenance = How this was computed
page-more = and { $count } more in results.json
page-more-studies = and { $count } more with the studies below
page-rows = { $count ->
        [one] 1 row
       *[other] { $count } rows
    }
page-nothing = The studies have no findings; see their figures and tables.
page-hint = Point at a curve to read its values. Drag to zoom, double-click to see all, click a name to hide its curve. Keys: arrows, +, −, 0.
page-reset = Reset zoom
page-yes = yes
page-no = no
vibration-unstable = no steady vibration: the machine is unstable

balance-planes = { $rotor }: { $sizes }
item-balance = { $name } { $value } of { $share }
balance-detail = ISO 21940-11:2016, { $planes ->
        [two] 6.2 and 7.2, in the planes of the bearings
       *[one] 6.2, the resultant alone: the rotor has no two bearing planes
    }. Resultant { $resultant }{ $tilts ->
        [yes] , couple { $couple }
       *[no] {""}
    }; balanced as a rigid rotor
shaft-vibration-sizes = { $sizes }
item-shaft-vibration = { $name } { $value } peak to peak{ $zone ->
        [none] {""}
       *[other] , zone { $zone }
    }
shaft-vibration-detail = { $standard ->
        [api_617] API 617
       *[iso_7919_3] ISO 7919-3:2009, annex A, boundary of zones B and C
    }; limit at { $speed }. Unbalance alone, relative to the bearings{ $nonlinear ->
        [yes] ; largest stable response of the nonlinear machine
       *[no] {""}
    }
item-housing-vibration = { $name } { $value } rms{ $zone ->
        [none] {""}
       *[other] , zone { $zone }
    }
housing-vibration-detail = ISO 20816-3, { $standard ->
        [group_1_rigid] group 1 on rigid supports
        [group_1_flexible] group 1 on flexible supports
        [group_2_rigid] group 2 on rigid supports
       *[group_2_flexible] group 2 on flexible supports
    }, boundary of zones B and C; limit at { $speed }. Unbalance alone, of what the bearings stand on{ $nonlinear ->
        [yes] ; largest stable response of the nonlinear machine
       *[no] {""}
    }
housing-vibration-none = no bearing stands on a body that moves
shaft-vibration-no-bearing = no support between what turns and what does not
shaft-vibration-unknown = no response relative to the bearings is known
shaft-vibration-speed = the standard does not cover these operating speeds
