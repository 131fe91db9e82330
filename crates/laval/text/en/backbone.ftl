# Nonlinear normal modes at one spin speed: frequency against amplitude.

backbone-family = { $whirl ->
        [forward] Forward nonlinear normal mode
        [backward] Backward nonlinear normal mode
       *[none] Nonlinear normal mode
    } at { $value }: { $trend ->
        [hardens] hardening
       *[softens] softening
    } from { $first } at an amplitude of { $first-amplitude } to { $last } at { $last-amplitude }.
backbone-family-constant = { $whirl ->
        [forward] Forward nonlinear normal mode
        [backward] Backward nonlinear normal mode
       *[none] Nonlinear normal mode
    } at { $value }: the frequency is the same at all amplitudes from { $first-amplitude } to { $last-amplitude }.
backbone-turning = It first { $trend ->
        [hardens] hardens
       *[softens] softens
    }, to { $frequency } at an amplitude of { $amplitude }.
backbone-family-beside-asymptote = { $whirl ->
        [forward] Forward nonlinear normal mode
        [backward] Backward nonlinear normal mode
       *[none] Nonlinear normal mode
    } beside the asymptote { $asymptote }, without a linear mode at its beginning. From { $value } at an amplitude of { $first-amplitude } it goes down to { $least } and ends at { $last } with { $last-amplitude }.
backbone-no-family = No nonlinear normal mode was found at this speed.
backbone-undamped = The modes are undamped at all amplitudes computed.
backbone-driven = The machine is damped. Negative damping proportional to mass, at most { $value }, balances the losses of these modes.
backbone-merged-modes = No nonlinear normal mode begins at the linear mode of { $value }. It is inside an instability band of two merged modes, growth rate { $growth }; add damping or change the speed.
backbone-asymptotes = With rigid nonlinear parts the natural { $n ->
        [one] frequency is
       *[other] frequencies are
    } { $frequencies }. There the amplitude of a hardening machine is unbounded.
backbone-synchronous = At an amplitude of { $value } this mode has the frequency of the spin; unbalance excites it there.
backbone-whirl-ends = The mode at { $mode } ends at an amplitude of { $value }: its frequency falls to { $frequency }, and no restoring force remains.
backbone-family-unfinished = The mode at { $mode } was followed only to an amplitude of { $value }. { $why }
