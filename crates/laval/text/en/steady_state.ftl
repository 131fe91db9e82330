# Motions followed until they repeat.

steady-state-not-valid = Not valid: { $count ->
        [one] one motion is
       *[other] { $count } motions are
    } outside the range of "{ $part }", { $what } up to { $value } (limit 1).
steady-state-not-valid-unbounded = Not valid: { $count ->
        [one] one motion is
       *[other] { $count } motions are
    } outside the range of "{ $part }", { $what } is unbounded (limit 1).
