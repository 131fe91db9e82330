# The mode that grows most.
campbell-unstable = Мода { $mode } неустойчива: { $whirl ->
        [none] статическая неустойчивость (дивергенция)
        [forward] прямая прецессия, частота { $frequency }
        [backward] обратная прецессия, частота { $frequency }
       *[vibration] колебания, частота { $frequency }
    }, инкремент до { $value }, при { $speed }.

# Critical speeds.
campbell-critical-speed = Критическая частота вращения ({ $order }×) { $value }: { $whirl }, { $damped ->
        [no] без демпфирования
       *[yes] относительное демпфирование { $damping }
    }.
campbell-critical-speed-not-located = Критическая частота вращения ({ $order }×) лежит между { $value } и { $to }, но не уточнена. Задайте там больше точек.
campbell-no-critical-speed = В этом диапазоне критических частот вращения не найдено.
campbell-no-critical-speed-yet = До остановки расчёта критических частот вращения не найдено.

# How far the modes are known.
campbell-ambiguous = Соответствие мод неоднозначно на { $steps } { $steps ->
        [one] шаге
       *[other] шагах
    } частоты вращения, впервые между { $value } и { $to }. Моды там могут быть перепутаны; задайте больше точек.
campbell-slow-roots = Критические частоты медленных волн могут быть пропущены: прослежены не все корни возле мнимой оси. Сравните с резонансами расчёта forced_response.
