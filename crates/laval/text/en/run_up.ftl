# Run-up and run-down.

# Peaks of the envelope.
run-up-resonance = The amplitude of { $body } peaks at { $value } in passing a resonance.
run-up-peak = The amplitude of { $body } peaks at { $value }.
run-up-unstable-range = The machine is unstable { $range }: there the amplitude of { $body } grows by a factor of up to { $factor } and peaks at { $value }. Pass this range quickly, or add damping.
run-up-swings = The amplitude of { $body } is largest at { $value }, while balls circulate in the rotor. This peak is no resonance.

# Drive.
run-up-torque = The speed profile takes a drive torque of up to { $value }, at { $speed }.
run-up-torque-beyond-motors = The speed profile takes a torque of up to { $value } beside that of the motors, at { $speed }.
run-up-power = The speed profile takes a drive power of up to { $value }, at { $speed }.
run-up-power-beyond-motors = The speed profile takes a power of up to { $value } beside that of the motors, at { $speed }.
