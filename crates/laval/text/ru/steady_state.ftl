# Motions followed until they repeat.

steady-state-not-valid = Недействительно: { $count } { $count ->
        [one] движение
        [few] движения
       *[other] движений
    } вне области применимости элемента «{ $part }», { $what } до { $value } (предел 1).
steady-state-not-valid-unbounded = Недействительно: { $count } { $count ->
        [one] движение
        [few] движения
       *[other] движений
    } вне области применимости элемента «{ $part }», { $what } = ∞ (предел 1).
