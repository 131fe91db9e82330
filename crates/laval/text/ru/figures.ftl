# Texts of figures and tables: labels, titles, and what a figure shows to readers who cannot see it.

# What belongs to a body or part. The owner is a name of the machine file: it stands in brackets, without a case.
label-of = { $what } ({ $owner })
# A point of a body.
label-point = { $body }, высота { $height }
# The same in front of a number.
named-point = { $body } (высота { $height })
# A quantity and a reservation about it.
label-noted = { $what }; { $note }
# A flag that is not set.
label-not = не { $what }
# A mark with a range of the axis.
label-between = { $label } от { $from } до { $to }
# A multiple of the spin speed.
label-order = { $order }×
label-mode = мода { $number }
label-operating-margin = рабочая частота вращения ± { $margin }

# Linear studies.
campbell-alt = Частоты и инкременты { $modes ->
        [one] { $modes } моды
       *[other] { $modes } мод
    } в зависимости от частоты вращения; { $criticals ->
        [one] { $criticals } критическая частота вращения
        [few] { $criticals } критические частоты вращения
       *[other] { $criticals } критических частот вращения
    }.{ $above ->
        [0] {""}
        [one] {" "}Выше оси, за { $top }: ещё { $above } мода.
        [few] {" "}Выше оси, за { $top }: ещё { $above } моды.
       *[other] {" "}Выше оси, за { $top }: ещё { $above } мод.
    }
stability-map-operating = рабочая частота вращения: { $growth }
stability-map-alt = Наибольший инкремент в зависимости от частоты вращения и диапазоны, где он выше порога. Ниже — частота этой моды; разрыв означает переход к другой моде.
stability-map-alt-parameter = Наибольший инкремент в зависимости от параметра «{ $parameter }» при { $speed }.
stability-map-alt-map = Наибольший инкремент в зависимости от частоты вращения и параметра «{ $parameter }», с границей устойчивости.
modes-table = Собственные моды (состояние: { $state })
modes-alt = Инкременты { $modes ->
        [one] { $modes } моды
       *[other] { $modes } мод
    } в зависимости от частоты колебаний при { $speed }.
approximation-degree = степень { $degree }
approximation-alt = Серые линии: частоты и инкременты машины в зависимости от частоты вращения. Точки: то же для её аппроксимации степени { $degree }.
forced-response-amplification = AF { $factor }
forced-response-alt = Амплитуды { $bodies ->
        [one] { $bodies } тела
       *[other] { $bodies } тел
    } в зависимости от частоты вращения{ $bounded ->
        [no] , без ограничения при { $speed }
        [none] , без резонансов
       *[yes] ; наибольший резонанс при { $speed }
    }.

# Centrifuges.
operating-window-alt = Запасы по всем требованиям в зависимости от частоты вращения и диапазоны, где соблюдены все требования.
operating-window-alt-none = Запасы по всем требованиям в зависимости от частоты вращения. При каждой частоте нарушено хотя бы одно требование.
operating-window-alt-time = Время до заданной доли улавливания в зависимости от частоты вращения и располагаемое время.
operating-window-alt-trade = Наименьшая и наибольшая частоты вращения окна в зависимости от располагаемого времени.
operating-window-alt-map = Наименьший запас в зависимости от частоты вращения и параметра «{ $parameter }». Кривая — граница окна.
operating-window-table-map = Наименьший запас в зависимости от частоты вращения и параметра «{ $parameter }» (разделение по { $places ->
        [one] { $places } начальному положению
       *[other] { $places } начальным положениям
    } или меньше)
separation-table-demand = Время улавливания { $share } в зависимости от частоты вращения
separation-alt-efficiency = Доля уловленных частиц в зависимости от времени, с располагаемым временем и заданной долей улавливания.
separation-alt-grade = Доля частиц, уловленных за располагаемое время, в зависимости от их диаметра.
separation-alt-demand = Время до заданной доли улавливания в зависимости от частоты вращения.
separation-alt-pellet = Места, где частицы покидают жидкость: доля всех частиц; для стенки — вдоль стакана, для дна и поверхности — от его оси.
separation-alt-paths-bowl = Траектории некоторых частиц в осях барабана: путь относительно жидкости в сторону вращения в зависимости от пути наружу.
separation-alt-paths-cup = Траектории некоторых частиц в осях стакана, поперёк него и в сторону вращения, от поверхности (слева) до дна (справа).
separation-alt-paths-time = Расстояние некоторых частиц от оси вращения в зависимости от времени, пока они не покинут жидкость или не истечёт располагаемое время.
separation-alt-released = Положение выпущенной частицы и наклон её стакана в зависимости от времени.

# Studies of parameters.
optimum-alt-search = Лучшее значение «{ $aim }» по прогонам { $searches ->
        [one] { $searches } поиска
       *[other] { $searches } поисков
    }.
optimum-title-profile = Вблизи оптимума: { $parameter }
optimum-alt-profile = Значение «{ $aim }» в зависимости от параметра «{ $parameter }» через оптимум; остальные параметры наилучшие.
optimum-worse = на { $share } хуже
sensitivity-place-peak = пик { $point } при { $speed }
sensitivity-place-jump = { $way ->
        [up] скачок при разгоне, { $speed }
       *[down] скачок при выбеге, { $speed }
    }
sensitivity-title = Влияние параметров: { $place }
sensitivity-alt = Относительное влияние { $count ->
        [one] { $count } важнейшего параметра
       *[other] { $count } важнейших параметров
    }, по паре столбцов на каждый.
sensitivity-table-bars = Столбцы рисунка: влияние на { $quality ->
        [speed] частоту вращения
        [tilt] наклон
       *[displacement] перемещение
    }, { $place }
uncertainty-table-histogram = Гистограмма величины «{ $quantity }»: оба края каждого столбца
uncertainty-table-distribution = Доля реализаций ниже значения величины «{ $quantity }»
uncertainty-table-bars = Столбцы рисунка: { $kind }, величина «{ $quantity }»
uncertainty-title-distribution = Распределение величины «{ $quantity }» ({ $samples ->
        [one] { $samples } реализация
        [few] { $samples } реализации
       *[other] { $samples } реализаций
    }{ $alike ->
        [0] {""}
        [one] , ещё { $alike } такая же величина
        [few] , ещё { $alike } такие же величины
       *[other] , ещё { $alike } таких же величин
    })
uncertainty-alt-distribution = Гистограмма величины «{ $quantity }» по { $samples ->
        [one] { $samples } реализации
       *[other] { $samples } реализациям
    }, от { $low } до { $high }.
uncertainty-title-indices = Индексы чувствительности величины «{ $quantity }»
uncertainty-title-effects = Элементарные эффекты для величины «{ $quantity }»
uncertainty-alt-bars = Влияние на величину «{ $quantity }»: по столбцу на каждый из { $parameters ->
        [one] { $parameters } параметра
       *[other] { $parameters } параметров
    }.
uncertainty-share-of-variance = доля дисперсии, по { $samples ->
        [one] { $samples } реализации
       *[other] { $samples } реализациям
    }{ $rough ->
        [yes] : грубая оценка
       *[no] {""}
    }
uncertainty-quantile = квантиль { $share }

# Nonlinear studies.
nonlinear-response-alt = Наибольшее перемещение каждого тела в зависимости от частоты вращения: { $branches ->
        [one] { $branches } ветвь
        [few] { $branches } ветви
       *[other] { $branches } ветвей
    }, { $folds ->
        [0] складок нет
        [one] { $folds } складка
        [few] { $folds } складки
       *[other] { $folds } складок
    }{ $largest ->
        [known] ; наибольшее, { $value } у { $point }, при { $speed }
       *[unknown] {""}
    }.
nonlinear-response-alt-jumps = Наибольшее перемещение вблизи складок, увеличено.
nonlinear-response-alt-forces = Наибольшая за период сила { $parts ->
        [one] { $parts } элемента
       *[other] { $parts } элементов
    } в зависимости от частоты вращения.
nonlinear-response-alt-orders = Большие полуоси субгармоник и супергармоник в зависимости от частоты вращения ({ $bodies }), с порогом.
nonlinear-response-limit = { $part }, высокая частота вращения
nonlinear-response-map-evidence = отображение за весь период, допуск { $tolerance }: состояния
backbone-begins = { $origin ->
        [mode] от { $frequency }
       *[asymptote] возле { $frequency }
    }
backbone-alt = Амплитуда деформации в зависимости от частоты прецессии при { $speed }: { $families ->
        [one] { $families } семейство
        [few] { $families } семейства
       *[other] { $families } семейств
    }.
methods-alt = Отклонение каждого метода от сошедшегося пика в зависимости от частоты вращения, все состояния.
limit-cycles-alt = Наибольшее перемещение и частота предельных циклов в зависимости от частоты вращения: { $families ->
        [one] { $families } семейство
        [few] { $families } семейства
       *[other] { $families } семейств
    } от { $edges ->
        [one] { $edges } границы
       *[other] { $edges } границ
    } неустойчивости положения равновесия.
bifurcation-loci-alt = Кривые бифуркаций на плоскости частоты вращения и параметра «{ $parameter }»: складок — { $folds }, других смен устойчивости — { $others }, { $cusps ->
        [0] точек сборки нет
        [one] { $cusps } точка сборки
        [few] { $cusps } точки сборки
       *[other] { $cusps } точек сборки
    }.
response-map-alt = { $what ->
        [peak] Наибольшее устойчивое перемещение
        [tilt] Наибольший устойчивый наклон
        [hysteresis] Ширина диапазона частот вращения с несколькими состояниями (пусто, где состояние одно)
       *[sweeps] Результат медленных разгона и выбега
    } в зависимости от параметров «{ $x }» и «{ $y }»{ $border ->
        [yes] , с границей между машинами со скачками и без них
       *[no] {""}
    }.
stationary-alt-range = { $state } от { $from } до { $to }
stationary-alt = { $branches ->
        [one] { $branches } ветвь
        [few] { $branches } ветви
       *[other] { $branches } ветвей
    } положений равновесия во вращающейся системе координат в зависимости от частоты вращения; { $stable ->
        [0] устойчивых положений равновесия нет
       *[other] устойчиво: { $ranges }
    }.
stationary-title-stabilised = Инкремент уравновешенного состояния при { $speed }
stationary-alt-stabilised = Наибольший инкремент уравновешенного состояния в зависимости от параметра «{ $parameter }».
stationary-title-chart = Уравновешенное состояние по частоте вращения и параметру «{ $parameter }»
stationary-alt-chart = Уравновешенность устойчивых состояний в зависимости от частоты вращения и параметра «{ $parameter }», с уточнённой границей уравновешенного состояния.
stationary-title-errors = Остаточный дисбаланс при { $speed }
stationary-alt-errors = Дисбаланс, оставляемый лучшим и худшим устойчивыми состояниями, в зависимости от параметра «{ $parameter }», и дисбаланс без шариков.
stationary-table-stabilised = Наибольший инкремент уравновешенного состояния при { $speed } в зависимости от параметра «{ $parameter }»
stationary-table-chart = Уравновешенное состояние и устойчивые состояния по частоте вращения и параметру «{ $parameter }»
stationary-table-errors = Дисбаланс из-за погрешностей параметра «{ $parameter }» при { $speed }
stationary-class = { $word ->
        [balanced] уравновешено
        [partly_balanced] уравновешено частично
        [reduced] дисбаланс уменьшен
        [touching] шарики соприкасаются
        [together] шарики совпадают
        [opposed] шарики диаметрально противоположны
        [spread] шарики разведены
       *[single] положение равновесия
    }
stationary-change = { $word ->
        [fold] поворот ветви (складка)
        [branch_point] пересечение ветвей
        [hopf] начало колебаний (Хопф)
       *[real_root] смена устойчивости
    }
stationary-growing-roots = неустойчивые корни { $side ->
        [before] до смены
       *[behind] после смены
    }{ $several ->
        [yes] , ветвь { $branch }
       *[no] {""}
    }

# Motions in time.
history-table-last-turns = Движение тел за последние { $turns ->
        [one] { $turns } оборот
        [few] { $turns } оборота
       *[other] { $turns } оборотов
    }, отсчётов на оборот: { $samples }
history-alt-envelope = Наибольшее за оборот перемещение каждого тела от положения равновесия в зависимости от времени.
history-alt-lateral = Перемещения x и y каждого тела в зависимости от времени.
history-alt-orbit = Траектория каждого тела в плоскости, в масштабе; точка в начале, стрелка по направлению движения.
history-alt-energy = Изменение накопленной энергии с начала движения, тепло и работа над машиной в зависимости от времени. Ниже — погрешность баланса энергии.
balance-alt = Дисбаланс с шариками и без них, наибольший уравновешиваемый шариками дисбаланс и класс точности балансировки в зависимости от времени.
balance-alt-angles = Углы в роторе в зависимости от времени, от −180° до 180°: шарики от линии узлов, наклоны свободных колец.
run-up-alt-drive = Частота вращения, момент и мощность привода в зависимости от времени.
run-up-alt-envelope = Наибольшее за оборот перемещение каждого тела от положения равновесия в зависимости от частоты вращения.
spectra-alt = Амплитуды тела «{ $body }» в зависимости от { $along ->
        [speed] частоты вращения
       *[time] времени
    } и { $over ->
        [order] порядка
       *[frequency] частоты
    }. Положительные значения — прямая прецессия, отрицательные — обратная.
sweep-alt = Наибольшее перемещение или наклон каждого тела в зависимости от частоты вращения (начало: { $ways }).
sweep-alt-bifurcation = { $state } при нулевой фазе в зависимости от частоты вращения: по точке на каждый оборот периода (начало: { $ways }).
sweep-alt-waterfall = Порядковые спектры тела «{ $body }» в зависимости от частоты вращения (начало: { $way }). Отрицательные порядки — обратная прецессия.
sweep-alt-lyapunov = Наибольший показатель Ляпунова в зависимости от частоты вращения (начало: { $ways }).
motion-map-alt = { $what } в зависимости от параметров «{ $x }» и «{ $y }».
basins-alt = Аттрактор, достигаемый от каждых начальных условий при { $speed }, в зависимости от величин «{ $x }» и «{ $y }».
basins-sized = { $body } { $size } (аттрактор { $attractor })
basins-grid-step = шаг сетки ({ $state })
basins-typical-size = характерный размер ({ $state })
animation-alt = Вид вдоль оси: центры тел с меткой фазы, беговые дорожки и шарики. Масштаб перемещений больше масштаба дорожек, отношение { $enlarged }.
store-requested = { $rows }, запрошено

# How a study ended.
end-place = { $parameter } = { $at }
end-reached = Расчёт выполнен до конца.
end-step-too-small = Расчёт остановлен раньше времени: шаг стал слишком малым. Место остановки: { $place }.
end-no-solution = Расчёт остановлен раньше времени: решение не найдено (невязка { $residual }). Место остановки: { $place }.
end-no-values = Расчёт остановлен раньше времени: решение не найдено: уравнения не имеют конечных значений. Место остановки: { $place }.
end-unbounded = Расчёт остановлен раньше времени: движение вышло за все границы. Место остановки: { $place }.
end-cancelled = Расчёт прерван; показана выполненная часть.
end-refused = Расчёт отклонён: он неприменим к этой машине.
end-max-points = Расчёт остановлен раньше времени: достигнуто наибольшее допустимое число точек (max_points, --work-limit).
end-work-limit = Расчёт остановлен раньше времени: достигнут предел объёма вычислений (--work-limit); показана выполненная часть.
