# Critical speeds, with the response to unbalance beside them.
critical-speeds-critical-speed = Критическая частота вращения ({ $order }×) { $value }: { $whirl }, { $damped ->
        [no] без демпфирования
       *[yes] относительное демпфирование { $damping }
    }.{ $response ->
        [peak] {" "}Пик отклика { $body } при { $peak }.
        [unbounded] {" "}Отклик { $body } там не ограничен.
        [not_excited] {" "}В этой машине дисбаланс её не возбуждает.
        [no_peak] {" "}Отклик на дисбаланс там не имеет пика.
       *[none] {""}
    }
critical-speeds-response-peak = Пик отклика на дисбаланс при { $value }: амплитуда { $body } { $amplitude }. Ни одна собственная частота там не равна частоте вращения.
critical-speeds-response-unbounded = Отклик { $body } на дисбаланс не ограничен при { $value }. Ни одна собственная частота там не равна частоте вращения.
critical-speeds-none = В этом диапазоне критических частот вращения не найдено.
critical-speeds-peaks-alone = В этом диапазоне критических частот вращения не найдено: ни одна собственная частота не равна частоте вращения { $peaks ->
        [1] в пике отклика
        [one] в { $peaks } пике отклика
       *[other] в { $peaks } пиках отклика
    }.
critical-speeds-none-yet = До остановки расчёта критических частот вращения не найдено.

# Distance of the operating speed from the nearest of them.
critical-speeds-margin = Запас отстройки { $value }, требуется { $required }: рабочая частота вращения { $operating }, { $nearest ->
        [peak] ближайший пик отклика
       *[critical_speed] ближайшая слабо демпфированная критическая частота ({ $order }×)
    } { $critical }{ $located ->
        [no] , положение не уточнено
       *[yes] {""}
    }.{ $search ->
        [stopped] {" "}До остановки расчёта ближе ничего не найдено.
       *[complete] {""}
    }{ $excited ->
        [no] {" "}Дисбаланс этой машины не возбуждает там резонанса.
       *[yes] {""}
    }
critical-speeds-small-margin = Запас отстройки { $value } меньше требуемого { $required }: рабочая частота вращения { $operating }, { $nearest ->
        [peak] ближайший пик отклика
       *[critical_speed] ближайшая слабо демпфированная критическая частота ({ $order }×)
    } { $critical }{ $located ->
        [no] , положение не уточнено
       *[yes] {""}
    }. Измените частоту вращения, жёсткость или демпфирование.
critical-speeds-no-margin = Рабочая частота вращения { $operating } совпадает { $nearest ->
        [peak] с пиком отклика на дисбаланс
       *[critical_speed] со слабо демпфированной критической частотой ({ $order }×)
    }{ $located ->
        [no] , положение не уточнено
       *[yes] {""}
    }.{ $excited ->
        [no] {" "}Дисбаланс этой машины не возбуждает там резонанса.
       *[yes] {""}
    }
