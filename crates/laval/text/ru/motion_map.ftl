# A place on the map, in the prepositional.
motion-map-speed = частоте вращения { $speed }
motion-map-parameter = { $parameter } = { $value }

motion-map-largest = { $quality ->
        [tilt] Наибольшее значение
       *[displacement] Наибольшее перемещение
    } { $point }: { $value }, при { $place }.

# How the response repeats.
motion-map-every-turn = Каждый установившийся отклик повторяется за оборот: { $count } из { $points } { $points ->
        [one] точки
       *[other] точек
    }.
motion-map-subharmonic = Отклик субгармонический порядка 1/{ $turns } в { $count } из { $points } { $points ->
        [one] точки
       *[other] точек
    }, например при { $place }.
motion-map-longer-period = Отклик повторяется только более чем через { $turns } { $turns ->
        [one] оборот
        [few] оборота
       *[other] оборотов
    } в { $count } из { $points } { $points ->
        [one] точки
       *[other] точек
    }, например при { $place }.
motion-map-not-periodic = Отклик не повторяется за { $turns } { $turns ->
        [one] оборот
        [few] оборота
       *[other] оборотов
    } в { $count } из { $points } { $points ->
        [one] точки
       *[other] точек
    }, например при { $place }. Он там квазипериодический, хаотический или с более длинным периодом.

# Points without a result.
motion-map-not-settled = Отклик не установился за most_periods в { $count } из { $points } { $points ->
        [one] точки
       *[other] точек
    }. Амплитуды там могут содержать переходный процесс; увеличьте most_periods.
motion-map-failed-machines = Параметры не дают допустимой машины в { $count } из { $points } { $points ->
        [one] точки
       *[other] точек
    }, например при { $place }: { $reason }.
motion-map-failed-motions = В { $count } из { $points } { $points ->
        [one] точки
       *[other] точек
    } движение { $reason }, например при { $place }. У этих точек нет результата.
