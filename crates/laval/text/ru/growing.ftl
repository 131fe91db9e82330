# The machine is unstable where a response or critical speeds are reported.
growing-unstable = Машина неустойчива { $place ->
        [one] при { $from }
        [all] при всех рассчитанных частотах вращения, от { $from } до { $to }
        [single] при одной из рассчитанных частот вращения ({ $computed }), { $from }
       *[several] при { $unstable } из { $computed } { $computed ->
            [one] рассчитанного значения
           *[other] рассчитанных значений
        } частоты вращения, между { $from } и { $to }
    }. Инкремент { $place ->
        [one] { $value }
        [single] { $value }
       *[several] до { $value }, при { $speed }
    }, { $motion ->
        [divergence] статическая неустойчивость (дивергенция)
       *[whirl] частота прецессии { $frequency }
    }. { $follows ->
        [response] Амплитуды и резонансы там относятся к неустойчивому решению: сначала устраните неустойчивость.
       *[speeds] Критические частоты вращения и запасы отстройки там неприменимы: сначала устраните неустойчивость.
    }
