# The best machine that was found.
optimum-best = { $extreme ->
        [largest] Наибольшее
       *[smallest] Наименьшее
    } { $kind ->
        [speed] значение частоты «{ $aim }»
       *[other] значение «{ $aim }»
    }, найденное в границах{ $search ->
        [stopped] {" "}до остановки расчёта
       *[complete] {""}
    }: { $value }.{ $present ->
        [change] {" "}У нынешней машины { $now }: изменение { $change }.
        [value] {" "}У нынешней машины { $now }.
       *[none] {""}
    }
optimum-recommended = { $search ->
        [stopped] Лучшее до остановки расчёта
       *[complete] Рекомендуется
    }: { $parameter } = { $value }. У нынешней машины { $now }.{ $bound ->
        [lower] {" "}Это нижняя граница; при меньшей машина может быть лучше.
        [upper] {" "}Это верхняя граница; при большей машина может быть лучше.
       *[none] {""}
    }{ $slope ->
        [rises] {" "}К границе значение «{ $aim }» растёт на { $rate } при изменении параметра на { $step }.
        [falls] {" "}К границе значение «{ $aim }» снижается на { $rate } при изменении параметра на { $step }.
       *[none] {""}
    }{ $range ->
        [whole] {" "}Значение «{ $aim }» отличается от лучшего не больше чем на { $tolerance } во всём диапазоне, от { $from } до { $to }.
        [lower] {" "}Значение «{ $aim }» отличается от лучшего не больше чем на { $tolerance } от нижней границы { $from } до { $to }.
        [upper] {" "}Значение «{ $aim }» отличается от лучшего не больше чем на { $tolerance } от { $from } до верхней границы { $to }.
        [inside] {" "}Значение «{ $aim }» отличается от лучшего не больше чем на { $tolerance } от { $from } до { $to }.
       *[none] {""}
    }

# Limits on other numbers.
optimum-limit-reached = Значение «{ $number }» достигает { $side ->
        [upper] верхнего
       *[lower] нижнего
    } предела { $limit }. Ослабление предела может дать лучшую машину.
optimum-limit-kept = Значение «{ $number }» { $value }, в пределах { $side ->
        [upper] верхнего
       *[lower] нижнего
    } ограничения { $limit }.

# The test of the optimum by machines beside it.
optimum-neighbours-worse = Ни одна из соседних машин ({ $count }) не лучше.{ $limits ->
        [some] {" "}Превышение предела считается ухудшением.
       *[none] {""}
    }
optimum-neighbours-alike = Поиск сошёлся: лучшая из соседних машин ({ $count }) лучше лишь на { $better }.{ $limits ->
        [some] {" "}Превышение предела считается ухудшением.
       *[none] {""}
    }
optimum-neighbour-better = Поиск не сошёлся: лучшая из соседних машин ({ $count }) лучше на { $better }. Разрешите больше прогонов.
optimum-neighbour-without = Оптимум не проверен: у одной из соседних машин нет значения «{ $aim }». Отодвиньте границы от таких машин.
optimum-searches-cut = Все прогоны ({ $runs }) исчерпаны до сходимости в { $count } из { $searches } { $searches ->
        [one] поиска
       *[other] поисков
    }. Для более надёжного результата разрешите больше прогонов.
optimum-outside-validity = Один из результатов рекомендуемой машины вне области применимости модели.

# No machine was found.
optimum-none = { $search ->
        [stopped] До остановки расчёта, после { $runs } { $runs ->
            [one] прогона
           *[other] прогонов
        }, не найдено машины со значением «{ $aim }».
       *[complete] Ни одна испытанная машина не имеет значения «{ $aim }». Измените границы.
    }
optimum-none-in-limits = { $search ->
        [stopped] До остановки расчёта, после { $runs } { $runs ->
            [one] прогона
           *[other] прогонов
        }, не найдено машины в заданных пределах.
       *[complete] Ни одна испытанная машина не соблюдает пределы. Расширьте границы или ослабьте предел.
    }
