# Approximate methods beside the converged response.

methods-method = { $method ->
        [harmonic] harmonic balance to order { $order }
        [averaging] averaging
        [elliptic] elliptic balance
        [time] time integration
       *[converged] converged harmonic balance
    }
methods-unstable = { $unstable } of { $states } compared states { $unstable ->
        [one] is
       *[other] are
    } unstable; the machine does not stay in { $unstable ->
        [one] it
       *[other] them
    }.
methods-deviation = The largest error of { $method } is { $value } of the largest peak, at { $speed } in state { $state }.
methods-exact = The peaks by { $method } equal the converged ones to rounding at the speeds compared.
methods-missing = { $missing } of { $states } states are missing.
methods-no-states = None of the states was found by { $method }.
methods-averaging-stability = { $wrong ->
        [0] Averaging gives the correct stability for { $states } of { $states } states.
       *[other] Averaging gives the wrong stability for { $wrong } of { $states } states, because it contains only the mode near the speed.
    }
methods-fold-deviation = One harmonic, and averaging likewise, shift the fold at { $speed } by { $value }.
methods-no-elliptic-balance = Elliptic balance was left out: { $why }.
methods-no-time-integration = Some states were not integrated in time: { $why }.
methods-one-harmonic-exact = The machine is isotropic: its response is circular, and one harmonic is exact.
