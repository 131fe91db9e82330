# Motors and the spin.

drive-captured = Sommerfeld effect: the speed stalls at { $value }, because vibration absorbs the drive torque. Without vibration it would reach { $reachable }. Add torque or damping to pass.
drive-captured-unlimited = Sommerfeld effect: the speed stalls at { $value }, because vibration absorbs the drive torque. Without vibration it would rise without limit. Add torque or damping to pass.
drive-suffices = The motor torque suffices for this speed profile, with at least { $value } in reserve.
drive-short = The motor torque is too low for this speed profile: { $value } short at { $at }. Choose a slower profile or a stronger motor.
drive-spin-inertia = Spin acceleration and drive torque leave out parts without inertia about the axis. Give { $parameters }.
