# Parts of sentences.
separation-recovery = { $share }
separation-recovery-from = { $share } of the particles from { $diameter } on
separation-particles = particles
separation-particles-from = particles from { $diameter } on
separation-in-time = in { $time }
separation-at-throughput = at { $throughput }
separation-without-spin = without spin
separation-at-speed = at { $speed }
separation-no-run-up = {""}
separation-run-up-included = , including the run-up of { $duration }
separation-run-up-estimated = , including the run-up of { $duration }, estimated by the field at mean radius
separation-vessel = { $kind ->
        [swinging] swinging cup
        [fixed_angle] fixed-angle tube
        [tubular_bowl] tubular bowl
        [disc_stack] disc stack
       *[decanter] decanter
    }

# What is caught.
separation-caught = The { $vessel } catches { $value } of the { $particles } { $at_hand } { $spin }{ $run_up }.
separation-all-sampled-caught = The { $vessel } catches all sampled particles, nearly { $value } of the { $particles }, { $at_hand } { $spin }{ $run_up }. The last ones would take { $last }.
separation-all-sampled-caught-some-never = The { $vessel } catches all sampled particles, nearly { $value } of the { $particles }, { $at_hand } { $spin }{ $run_up }. Some are never caught.
separation-never-caught = Catching { $recovery } is impossible { $spin }: some particles stay in the liquid. Lower recovery, or raise diameter.
separation-time-needed = Catching { $recovery } takes { $value } { $spin }{ $run_up }.
separation-residence-needed = Catching { $recovery } takes a residence time of { $value } { $spin }, a throughput of at most { $throughput }.
separation-no-spin-needed = Gravity alone catches { $recovery } { $at_hand }: no spin is needed.
separation-speed-needed = Catching { $recovery } { $at_hand } takes at least { $value }{ $run_up ->
        [none] {""}
        [same] , with the run-up at the same acceleration
       *[programme] , with all speeds of the programme in proportion
    }.
separation-no-speed-suffices = No computed speed up to { $highest } catches { $recovery } { $at_hand }{ $run_up ->
        [none] {""}
        [same] , with the run-up at the same acceleration
       *[programme] , with all speeds of the programme in proportion
    }. { $flow ->
        [yes] Lower throughput or recovery
       *[no] Raise time, or lower recovery
    }.
separation-one-speed = The required speed for { $recovery } and the sensitivities are not computed: up to { $times } times this speed every particle would be integrated with its inertia. Use model = "drifting", which neglects inertia, or compute single speeds.
separation-nothing-shown = No result: the work limit, counted in particle paths, ended the study before all paths were computed.
separation-cut-size = Cut size: half of the { $particles ->
        [light] light particles
       *[heavy] particles
    } of { $value } are caught{ $estimate ->
        [none] {""}
        [inertia] , inertia neglected
       *[run_up] , estimated without inertia, with the run-up by the field at mean radius
    }.
separation-released = The released particle reaches the { $surface ->
        [wall] wall
        [bottom] bottom
       *[surface] liquid surface
    } after { $value }, at { $along } along the cup.
separation-released-stays = The released particle never reaches a surface: it stays in the liquid.
separation-released-outside = The release point is outside the liquid, and no path is computed. Move release into the liquid.

# The cup and its field.
separation-tilt = The cup swings out to { $value } from the vertical.
separation-tilt-none = The cup hangs vertically: it does not swing out at this speed.
separation-tilt-held = The cup is held at a tilt of { $value }.
separation-field = The centrifugal field is { $surface } g at the liquid surface and { $value } g at the outer radius.
separation-no-field = Gravity alone acts: the centrifugal field is { $value } g.

# Validity of the model.
separation-gravity = At the required speed the field at the innermost liquid is { $value } g. The model neglects gravity, which is valid above { $least } g: the required speed is an estimate.
separation-validity = Validity in doubt ({ $name } = { $value }, limit { $limit }): { $meaning }.
separation-validity-undefined = Validity in doubt ({ $name } is not finite, limit { $limit }): { $meaning }.
