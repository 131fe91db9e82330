# Approximate methods beside the converged response.

# In the genitive.
methods-method = { $method ->
        [harmonic] гармонического баланса порядка { $order }
        [averaging] метода усреднения
        [elliptic] эллиптического баланса
        [time] интегрирования по времени
       *[converged] сошедшегося гармонического баланса
    }
methods-unstable = Из { $states } { $states ->
        [one] сравнённого состояния
       *[other] сравнённых состояний
    } { $unstable ->
        [one] неустойчиво { $unstable }; машина в нём не остаётся
       *[other] неустойчивы { $unstable }; машина в них не остаётся
    }.
methods-deviation = Наибольшая погрешность { $method }: { $value } от наибольшего пика, при { $speed } в состоянии { $state }.
methods-exact = Пики по результатам { $method } совпадают с точными до округления при сравнённых частотах вращения.
methods-missing = Отсутствуют состояния: { $missing } из { $states }.
methods-no-states = С помощью { $method } не найдено ни одного состояния.
methods-averaging-stability = { $wrong ->
        [0] Метод усреднения верно определяет устойчивость всех сравнённых состояний: { $states } из { $states }.
       *[other] Метод усреднения неверно определяет устойчивость { $wrong } из { $states } { $states ->
            [one] состояния
           *[other] состояний
        }, так как содержит только моду вблизи частоты вращения.
    }
methods-fold-deviation = Одна гармоника, как и усреднение, смещает складку при { $speed } на { $value }.
methods-no-elliptic-balance = Эллиптический баланс не выполнен: { $why }.
methods-no-time-integration = Некоторые состояния не проинтегрированы по времени: { $why }.
methods-one-harmonic-exact = Машина изотропна: её отклик — круговая прецессия, и одна гармоника точна.
