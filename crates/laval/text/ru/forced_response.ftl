# At one speed.
forced-response-amplitude = Амплитуда { $body } при { $speed }: { $value }.
forced-response-tilt = Наклон тела «{ $body }» при { $speed }: { $value }.

# Resonances.
forced-response-largest-resonance = Наибольший { $others ->
        [unbounded] ограниченный резонанс
       *[none] резонанс
    } при { $value }: амплитуда { $body } { $amplitude }.{ $search ->
        [stopped] {" "}Это наибольший из найденных до остановки расчёта.
       *[complete] {""}
    }
forced-response-largest-tilt-resonance = Наибольший { $others ->
        [unbounded] ограниченный резонанс по наклону
       *[none] резонанс по наклону
    } при { $value }: амплитуда { $body } { $amplitude }.{ $search ->
        [stopped] {" "}Это наибольший из найденных до остановки расчёта.
       *[complete] {""}
    }
forced-response-undamped-resonance = Резонанс без демпфирования при { $value }: амплитуда { $body } не ограничена. Добавьте демпфирование или избегайте этой частоты вращения.
forced-response-other-undamped-resonance = Резонанс без демпфирования при { $value }: амплитуда не ограничена. Добавьте демпфирование или избегайте этой частоты вращения.
forced-response-no-resonance = В этом диапазоне резонансов нет ни у одного тела.
forced-response-no-resonance-known = Там, где отклик известен, резонансов не найдено.
forced-response-no-resonance-yet = До остановки расчёта резонансов не найдено.

# How far the response is known and valid.
forced-response-frequency-only = Резонансы, более узкие, чем шаг частоты вращения { $step }, могут быть пропущены, устойчивость не оценена: один из элементов задан только в частотной области.
forced-response-unknown = Отклик неизвестен при { $unknown } из { $speeds } { $speeds ->
        [one] значения
       *[other] значений
    } частоты вращения, впервые при { $value }: реакция одного из элементов там неточна.
forced-response-gap-closes = Колебания закрывают зазор элемента «{ $part }», { $gap } в положении равновесия, { $speeds ->
        [one] при { $value }
       *[several] при частотах вращения от { $value } до { $last }
    }. Контакт не учтён, поэтому амплитуды там недействительны: используйте nonlinear_response.
forced-response-validity = Недействительно: отклик при { $speed } вне области применимости элемента «{ $part }», { $what } = { $value } (предел 1).
forced-response-validity-unbounded = Недействительно: отклик при { $speed } вне области применимости элемента «{ $part }», { $what } = ∞ (предел 1).

# Separation margins.
forced-response-margin-kept = Запасы по частоте выдержаны (API 684, SP6.8.2.10). Наименьший у резонанса при { $resonance }: { $value } от { $operating }, требуется { $required } ({ $body }, { $damped ->
        [yes] коэффициент усиления { $factor }
        [unknown] коэффициент усиления неизвестен
       *[no] без демпфирования
    }).
forced-response-margin-broken = Запас по частоте мал (API 684, SP6.8.2.10): резонанс при { $resonance } { $side ->
        [among] лежит среди рабочих частот вращения
       *[other] отстоит на { $value } от { $operating }
    }, требуется { $required } ({ $body }, { $damped ->
        [yes] коэффициент усиления { $factor }
       *[no] без демпфирования
    }).
forced-response-margin-none = Ни один резонанс в этом диапазоне не требует запаса по частоте (API 684, SP6.8.2.10): коэффициентов усиления от 2,5 нет.{ $bounded ->
        [yes] {" "}До края диапазона отклик остаётся выше 0,707 пика: коэффициент усиления не более { $most }.
       *[no] {""}
    }
forced-response-margin-unknown = { $reason ->
        [stopped] Запасы по частоте не определены (API 684, SP6.8.2.10): расчёт остановлен.
        [range] Запасы по частоте не определены (API 684, SP6.8.2.10): точки половинной мощности резонанса при { $resonance } лежат вне диапазона, и его коэффициент усиления неизвестен. До рабочих частот вращения { $value }; может потребоваться до { $required }. Расширьте диапазон.
       *[neighbour] Запасы по частоте не определены (API 684, SP6.8.2.10): более высокий соседний резонанс закрывает точки половинной мощности резонанса при { $resonance }, и его коэффициент усиления неизвестен. До рабочих частот вращения { $value }; может потребоваться до { $required }.
    }
forced-response-spin = Здесь действует дисбаланс того, что вращается вместе с "{ $spin }"; частоты вращения относятся к этому вращению.
forced-response-other-spins = Дисбаланс того, что вращается вместе с { $spins }, действует с другой частотой и здесь не учтён: задайте spin в отдельном расчёте.

forced-response-shaft-vibration = { $part }: размах вибрации { $value } при { $speed }: { $standard ->
        [api_617] в пределах { $limit } (API 617)
       *[iso_7919_3] зона { $zone } ISO 7919-3; длительная работа без ограничений до { $limit }
    }.
forced-response-shaft-vibration-broken = { $part }: размах вибрации { $value } при { $speed } выше { $limit } ({ $standard ->
        [api_617] API 617
       *[iso_7919_3] ISO 7919-3, зона { $zone }
    }). Отбалансируйте ротор точнее, добавьте демпфирование или сместите резонанс.
forced-response-shaft-vibration-outside = Стандарт на вибрацию вала не распространяется на { $speed }.
forced-response-boundary = { $line ->
        [zone_ab] зоны A/B
        [zone_bc] зоны B/C
        [zone_cd] зоны C/D
       *[api_limit] API 617
    }
