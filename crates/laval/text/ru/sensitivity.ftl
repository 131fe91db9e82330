# The parameter of most influence.
sensitivity-influence = сильнее всего зависит от { $parameter }: { $direction ->
        [falls] снижение
       *[rises] рост
    } на { $change } при его увеличении на 1 %
sensitivity-influence-unknown = меняется на неизвестную долю

# Peaks and folds of the steady-state response.
sensitivity-peak = Пиковое значение для { $point }, { $value } при { $speed }, { $size-influence }. Частота вращения пика { $speed-influence }.
sensitivity-jump = Частота вращения скачка { $way ->
        [up] при разгоне
       *[down] при выбеге
    }, { $speed }, { $speed-influence }. { $quality ->
        [tilt] Значение
       *[displacement] Перемещение
    } { $point } там, { $value }, { $size-influence }.
sensitivity-nothing-stationary = Пиков и складок отклика { $end ->
        [stopped] до остановки расчёта
       *[complete] в диапазоне частот вращения
    } не найдено.

# Places and parameters without an influence.
sensitivity-no-derivative-corner = Чувствительность не определена при { $value }{ $more ->
        [0] {""}
        [one] {" "}и ещё в { $more } месте, до { $highest }
       *[other] {" "}и ещё в { $more } местах, до { $highest }
    }: ветвь имеет там излом из-за переключения закона силы. Варьируйте там параметры вручную или расчётом uncertainty.
sensitivity-no-derivative-jump = Чувствительность не определена при { $value }{ $more ->
        [0] {""}
        [one] {" "}и ещё в { $more } месте, до { $highest }
       *[other] {" "}и ещё в { $more } местах, до { $highest }
    }: сила элемента «{ $part }» меняется скачком. Варьируйте там параметры вручную или расчётом uncertainty.
sensitivity-no-derivative-open = Чувствительность не определена при { $value }{ $more ->
        [0] {""}
        [one] {" "}и ещё в { $more } месте, до { $highest }
       *[other] {" "}и ещё в { $more } местах, до { $highest }
    }: производные не сошлись. Варьируйте там параметры вручную или расчётом uncertainty.
sensitivity-no-influence = Влияние { $parameters } в некоторых местах неизвестно; в таблицах оно стоит там последним.
sensitivity-without-influence = На указанные пики и складки не влияют: { $parameters }.
