# The machine is unstable where a response or critical speeds are reported.
growing-unstable = The machine is unstable { $place ->
        [one] at { $from }
        [all] at every speed computed, from { $from } to { $to }
        [single] at one of { $computed } speeds computed, { $from }
       *[several] at { $unstable } of { $computed } speeds computed, between { $from } and { $to }
    }. Growth rate { $place ->
        [one] { $value }
        [single] { $value }
       *[several] up to { $value }, at { $speed }
    }, { $motion ->
        [divergence] static instability (divergence)
       *[whirl] whirl at { $frequency }
    }. { $follows ->
        [response] Amplitudes and resonances there belong to an unstable solution: remove the instability first.
       *[speeds] Critical speeds and separation margins do not apply there: remove the instability first.
    }
