# Response to a harmonic force.
harmonic-force-largest = Наибольший резонанс при { $value }: { $body } достигает { $amplitude }{ $known ->
        [yes] , коэффициент усиления { $factor }
       *[no] {""}
    }.
harmonic-force-unbounded = Резонанс без демпфирования при { $value }: амплитуда { $body } не ограничена.
harmonic-force-singular = Резонанс без демпфирования при { $value }: амплитуда не ограничена.
harmonic-force-none = В этом диапазоне { $over ->
        [speed] частот вращения
       *[frequency] частот
    } резонансов нет.
harmonic-force-amplitude = При { $speed } амплитуда { $body } равна { $value }.
harmonic-force-frequency-only = Резонансы уже шага могут быть пропущены, устойчивость не проверена: один из элементов задан только в частотной области.
harmonic-force-margin-kept = Запасы по частоте выдержаны (API 684, SP6.8.2.10). Наименьший у резонанса при { $resonance }: { $value }, требуется { $required } { $known ->
        [yes] при коэффициенте усиления { $factor }
       *[no] при любом коэффициенте усиления (он неизвестен)
    }.
harmonic-force-margin-broken = Запас по частоте мал (API 684, SP6.8.2.10): у резонанса при { $resonance } { $value }, требуется { $required } при коэффициенте усиления { $factor }.
harmonic-force-gap-closes = Колебания закрывают зазор «{ $part }», в равновесии { $gap }, от { $value } до { $last }. Контакт не учтён, поэтому амплитуды там неприменимы.
harmonic-force-validity = Неприменимо: отклик вне области «{ $part }» при { $place }, { $what } = { $value } (предел 1).
harmonic-force-validity-unbounded = Неприменимо: отклик вне области «{ $part }» при { $place }, { $what } не ограничено (предел 1).

harmonic-force-alt = Амплитуды всех точек под действием гармонической силы, резонансов: { $peaks }.
