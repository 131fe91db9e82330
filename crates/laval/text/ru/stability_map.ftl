# The largest growth rate.
stability-map-largest-growth = Машина неустойчива: наибольший инкремент { $value } при { $speed }, { $motion ->
        [divergence] статическая неустойчивость (дивергенция)
       *[whirl] частота прецессии { $frequency }
    }.
stability-map-largest-growth-of-map = Наибольший инкремент на карте: { $value } при { $speed } и { $parameter } = { $setting }, { $motion ->
        [divergence] статическая неустойчивость (дивергенция)
       *[whirl] частота прецессии { $frequency }
    }.
stability-map-stable = Ни в одной { $computed ->
        [stopped] точке, рассчитанной до остановки,
       *[all] рассчитанной точке
    } ни одна мода не растёт{ $threshold ->
        [zero] {""}
       *[set] {" "}быстрее { $limit }
    }: наибольший инкремент { $value }.
stability-map-marginal = Ни в одной { $computed ->
        [stopped] точке, рассчитанной до остановки,
       *[all] рассчитанной точке
    } ни одна мода не растёт{ $threshold ->
        [zero] {""}
       *[set] {" "}быстрее { $limit }
    }: наибольший инкремент равен нулю.
stability-map-stable-counted = Ни в одной { $computed ->
        [stopped] точке, рассчитанной до остановки,
       *[all] рассчитанной точке
    } ни одна мода не растёт{ $threshold ->
        [zero] {""}
       *[set] {" "}быстрее { $limit }
    }.
stability-map-stability-unknown = Устойчивость не доказана: { $threshold ->
        [zero] растущих мод не найдено
       *[set] мод, растущих быстрее { $limit }, не найдено
    }, но некоторые могут быть пропущены в { $open } из { $points } { $points ->
        [one] точки
       *[other] точек
    }. Меньшее frequency_limit или большее growth_threshold облегчит поиск.

# Ranges of speed in which the machine is unstable.
stability-map-unstable-range = Неустойчиво от { $value } { $end ->
        [range] до конца диапазона
        [stopped] до { $to }, где расчёт остановлен
       *[boundary] до { $to }
    }{ $threshold ->
        [zero] {""}
       *[set] : инкремент больше { $limit }
    }.
stability-map-unstable-from-start = Неустойчиво от начала диапазона, { $value }, { $end ->
        [range] до его конца, { $to }
        [stopped] до { $to }, где расчёт остановлен
       *[boundary] до { $to }
    }{ $threshold ->
        [zero] {""}
       *[set] : инкремент больше { $limit }
    }.
stability-map-unstable-range-not-located = Неустойчиво от частоты вращения между { $low } и { $high } { $end ->
        [range] до конца диапазона
        [stopped] до { $to }, где расчёт остановлен
       *[boundary] до { $to }
    }{ $threshold ->
        [zero] {""}
       *[set] : инкремент больше { $limit }
    }. Граница не уточнена; задайте там больше точек.

# How far the growth rates are known.
stability-map-all-counted = Число корней проверено { $points ->
        [1] в точке
        [one] во всех { $points } точках
       *[other] во всех { $points } точках
    } по принципу аргумента, до { $frequency }: не пропущен ни один { $threshold ->
        [zero] неустойчивый корень
       *[set] корень с инкрементом больше { $limit }
    }.
stability-map-not-all-counted = { $threshold ->
        [zero] Неустойчивые корни
       *[set] Корни с инкрементом больше { $limit }
    } могут быть пропущены в { $open } из { $points } { $points ->
        [one] точки
       *[other] точек
    }. Меньшее frequency_limit или большее growth_threshold облегчит подсчёт.
stability-map-threshold-raised = Рост медленнее { $value } не разрешается для волн { $part }, которые медленно растут при любом демпфировании вне этого элемента. Порог повышен с { $requested }.
stability-map-undamped = { $machines ->
        [some] На части карты
       *[all] У машины
    } нет демпфирования: { $boundaries ->
        [none] там, где ни одна мода не растёт, ни одна и не затухает
        [double] границы устойчивости найдены как двойные корни
       *[some] как двойные корни { $double ->
            [one] найдена { $double }
           *[other] найдены { $double }
        } из { $edges } { $edges ->
            [one] границы
           *[other] границ
        } устойчивости, остальные заключены в интервал
    }.
