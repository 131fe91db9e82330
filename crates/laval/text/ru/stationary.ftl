# Balancing states over the speed.

stationary-hindered = Элемент «{ $part }»: { $reason }.
stationary-no-balls = В этой машине нет шариков. Её состояния — синхронный отклик, как в nonlinear_response.
stationary-insufficient-capacity = Шарики могут уравновесить не более { $value }, на { $missing } меньше дисбаланса. Возьмите более тяжёлые шарики или больше шариков.

# Kinds of states.
stationary-kind = { $kind ->
        [balanced] уравновешено
        [partly_balanced] частично уравновешено
        [reduced] дисбаланс уменьшен
        [touching] шарики соприкасаются
        [together] шарики совпадают
        [opposed] шарики диаметрально противоположны
        [spread] шарики разведены
       *[single] синхронное состояние
    }
# States that balance, fully or partly.
stationary-state = { $kind ->
        [balanced] уравновешенное состояние
        [partly_balanced] частично уравновешенное состояние
       *[reduced] состояние с уменьшенным дисбалансом
    }
# In the genitive.
stationary-continuum-of = { $kind ->
        [balanced] континуума уравновешенных состояний
        [partly_balanced] континуума частично уравновешенных состояний
       *[reduced] континуума состояний с уменьшенным дисбалансом
    }
stationary-sample = { $kind ->
        [balanced] одно состояние из континуума уравновешенных состояний
        [partly_balanced] одно состояние из континуума частично уравновешенных состояний
       *[reduced] одно состояние из континуума состояний с уменьшенным дисбалансом
    }

# Ranges of speed.
stationary-stable = Ветвь { $branch } ({ $kind }) устойчива от { $from } до { $value }.
stationary-stable-throughout = Ветвь { $branch } ({ $kind }) устойчива во всём диапазоне частот вращения, от { $from } до { $value }.
stationary-continuum = Найден континуум состояний от { $from } до { $value }: { $kind }, { $free } { $free ->
        [one] свободное направление
        [few] свободных направления
       *[other] свободных направлений
    }. Его устойчивость оценена по выборке.
stationary-continuum-stable = Некоторые состояния континуума устойчивы от { $from } до { $value }: { $kind }. Его устойчивость оценена по выборке.
stationary-no-state = В диапазоне частот вращения не найдено ни одного синхронного состояния. Увеличьте starts или рассчитайте transient.
stationary-no-stable-state = От { $from } до { $value } не найдено ни одного устойчивого синхронного состояния. { $balls ->
        [yes] Шарики проскальзывают, машина прецессирует или состояние пропущено;
       *[no] Машина прецессирует или состояние пропущено;
    } рассчитайте там transient.
stationary-not-balanced = От { $from } до { $value } не найдено ни одного уравновешенного или частично уравновешенного состояния. { $capacity ->
        [used] Шарики там слишком лёгкие; возьмите более тяжёлые или проходите диапазон быстро.
       *[left] Проходите этот диапазон быстро.
    }
stationary-harm = От { $from } до { $to } шарики увеличивают дисбаланс с коэффициентом до { $value }: ветвь { $branch } ({ $kind }). Закрепите там шарики или проходите диапазон быстро.
stationary-harm-of-balanced = От { $from } до { $to } шарики создают дисбаланс ротора до { $value }: ветвь { $branch } ({ $kind }). Без шариков ротор уравновешен; уберите или закрепите их.
stationary-coexistence = При { $speeds ->
        [1] { $from }
        [one] { $speeds } значении частоты вращения из таблицы, от { $from } до { $to },
       *[other] { $speeds } значениях частоты вращения из таблицы, от { $from } до { $to },
    } устойчивы и уравновешенное, и неуравновешенное состояние. Исход решают начальные условия; рассчитайте basins.

# The best state at the operating speed.
stationary-residual-unbalance = При { $speed } лучшее найденное устойчивое состояние ({ $kind }) оставляет дисбаланс { $value }{ $beside ->
        [times] , отношение к дисбалансу без шариков { $times }
        [nothing] , хотя без шариков дисбаланса нет
       *[none] {""}
    }.
stationary-dead-zone = При { $speed } сухое трение оставляет дисбаланс до { $value }{ $effect ->
        [more] , больше, чем без шариков
       *[less] {""}
    }. Оно удерживает шарики на угловом расстоянии до { $angle } (отсчёт: { $state }).{ $held ->
        [unstable] {" "}С удержанными шариками машина неустойчива; уменьшите трение.
       *[stable] {""}
    }
stationary-dead-zone-open = При { $speed } сухое трение { $value } удерживает шарики и вне найденных диапазонов. Может остаться больший дисбаланс, чем рассчитано; уменьшите трение.
stationary-dead-zone-continuum = При { $speed } сухое трение может оставить дисбаланс { $value } или больше возле { $continuum }.

# The balanced state over a parameter.
stationary-least-no-state = При { $speed } не найдено ни одного уравновешенного или частично уравновешенного состояния при { $sought } { $sought ->
        [one] значении
       *[other] значениях
    } { $parameter } от { $lowest } до { $highest }. Расширьте диапазон или увеличьте starts.
stationary-least-unstable = При { $speed } { $state } неустойчиво при { $computed ->
        [1] единственном рассчитанном значении { $parameter }
       *[other] всех рассчитанных значениях { $parameter } ({ $computed })
    } от { $lowest } до { $highest }.{ $reach ->
        [none] {""}
       *[other] {" "}{ $reach }
    } Расширьте диапазон или варьируйте другой параметр.
stationary-least-above = При { $speed } { $state } становится устойчивым, когда { $parameter } больше { $value }.{ $ends ->
        [none] {""}
        [open] {" "}Оно остаётся устойчивым до { $to }.
        [exists] {" "}Оно остаётся устойчивым до { $to }, где заканчивается.
        [half] {" "}Оно остаётся устойчивым до { $to }, где остаётся половина дисбаланса.
       *[lost] {" "}Оно остаётся устойчивым до { $to }, насколько прослежено.
    }{ $ranges }
stationary-least-from-limit = При { $speed } { $state } { $begins ->
        [exists] существует и устойчиво, когда { $parameter } больше { $value }.
        [half] устойчиво, когда { $parameter } больше { $value }, где остаётся половина дисбаланса.
       *[lost] устойчиво, когда { $parameter } больше { $value }, насколько прослежено.
    }{ $ends ->
        [none] {""}
        [open] {" "}Оно остаётся устойчивым до { $to }.
        [exists] {" "}Оно остаётся устойчивым до { $to }, где заканчивается.
        [half] {" "}Оно остаётся устойчивым до { $to }, где остаётся половина дисбаланса.
       *[lost] {" "}Оно остаётся устойчивым до { $to }, насколько прослежено.
    }{ $ranges }
stationary-least-between = При { $speed } { $state } устойчиво при { $parameter } от { $value } до { $to }, насколько рассчитано.{ $ranges }
stationary-least-everywhere = При { $speed } { $state } устойчиво при { $computed ->
        [1] единственном рассчитанном значении { $parameter }
       *[other] всех рассчитанных значениях { $parameter } ({ $computed })
    } от { $lowest } до { $highest }.
stationary-least-outside = При { $speed } { $state } устойчиво, пока { $parameter } не больше { $to }{ $ends ->
        [exists] , где оно заканчивается
        [half] , где остаётся половина дисбаланса
        [lost] , насколько прослежено
       *[open] {""}
    }, и снова, когда { $parameter } больше { $value }.{ $ranges }
stationary-least-below = При { $speed } { $state } устойчиво, пока { $parameter } не больше { $value }{ $ends ->
        [exists] , где оно заканчивается
        [half] , где остаётся половина дисбаланса
        [lost] , насколько прослежено
       *[open] {""}
    }.{ $ranges }
# Behind the sentence, where the state is stable more than once.
stationary-least-ranges = { $ranges ->
        [1] {""}
        [one] {" "}Оно устойчиво в { $ranges } диапазоне { $parameter }.
       *[other] {" "}Оно устойчиво в { $ranges } диапазонах { $parameter }.
    }
stationary-exists = Оно существует { $ends }.
stationary-followed = Оно прослежено { $ends }.
stationary-down-to = вниз до { $end }{ $why ->
        [exists] {" "}(там оно заканчивается)
        [half] {" "}(там остаётся половина дисбаланса)
       *[other] {""}
    }
stationary-up-to = вверх до { $end }{ $why ->
        [exists] {" "}(там оно заканчивается)
        [half] {" "}(там остаётся половина дисбаланса)
       *[other] {""}
    }

# Errors of a parameter, and the chart.
stationary-cost = При { $speed } лучшее найденное устойчивое состояние оставляет дисбаланс { $first } при { $parameter } = { $from } и { $value } при { $to }. Без шариков он { $without }.{ $effect ->
        [harm] {" "}Шарики тогда увеличивают дисбаланс; ужесточите допуск.
        [lost] {" "}Ротор тогда уже не уравновешен; ужесточите допуск.
       *[none] {""}
    }
stationary-cost-no-stable-state = При { $speed } не найдено ни одного устойчивого состояния при { $parameter } = { $value }{ $more ->
        [larger] {" "}и при { $larger ->
            [one] { $larger } более высоком рассчитанном значении
           *[other] { $larger } более высоких рассчитанных значениях
        }
        [some] , а всего при { $none } из { $computed } { $computed ->
            [one] значения
           *[other] значений
        }
       *[none] {""}
    }. Ужесточите допуск или рассчитайте transient.
stationary-chart = Карта по частоте вращения и { $parameter }, ячеек { $value }: уравновешены { $balanced }, бистабильны { $bistable }, не уравновешены { $unbalanced }. Без найденного устойчивого состояния { $unstable }.

# How complete the search is.
stationary-completeness = Полнота поиска: { $value } сошедшихся начальных приближений дали известное состояние. { $branches ->
        [0] Ветвей не найдено
        [one] Найдена { $branches } ветвь
        [few] Найдены { $branches } ветви
       *[other] Найдено { $branches } ветвей
    }{ $stopped ->
        [yes] {" "}до остановки расчёта
       *[no] {""}
    }.
stationary-too-many-branches = Ветвей состояний больше, чем прослеживает расчёт. Список не полон; сузьте диапазон частот вращения.
stationary-unfinished = Прослежены не до конца: { $branches }. Состояния дальше могут быть пропущены.
stationary-branch-near = ветвь { $branch } вблизи { $speed }
stationary-more = ещё { $count }

# One speed.
stationary-states = При { $speed } { $states ->
        [1] единственное найденное состояние устойчиво
       *[other] { $stable ->
            [one] устойчиво { $stable }
           *[other] устойчивы { $stable }
        } из { $states } { $states ->
            [one] найденного состояния
           *[other] найденных состояний
        }
    }.
stationary-states-unstable = При { $speed } { $states ->
        [1] единственное найденное состояние неустойчиво
       *[other] все найденные состояния неустойчивы ({ $states })
    }. Для движения там рассчитайте transient.
stationary-states-none = При { $speed } не найдено ни одного синхронного состояния. Увеличьте starts или рассчитайте transient.
