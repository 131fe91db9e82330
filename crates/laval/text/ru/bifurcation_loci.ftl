# Loci of bifurcations over speed and a parameter.

bifurcation-loci-kind = { $kind ->
        [neimark-sacker] бифуркация Неймарка–Сакера
        [period-doubling] удвоение периода
        [symmetry-breaking] потеря симметрии
        [branch-point] точка ветвления
       *[fold] складка
    }

# Turning points of loci.
bifurcation-loci-cusp = Две складки исчезают в точке сборки при { $parameter } = { $value } и { $speed }; они существуют только { $side ->
        [above] выше этого значения
       *[below] ниже этого значения
    }.
bifurcation-loci-folds-meet = Две складки сходятся при { $parameter } = { $value } и { $speed }; они существуют только { $side ->
        [above] выше этого значения
       *[below] ниже этого значения
    }. Там начинается отдельная ветвь или ветви обмениваются частями.
bifurcation-loci-extremum = Кривая { $locus }, { $kind }, поворачивает обратно при { $parameter } = { $value } и { $speed }; она лежит только { $side ->
        [above] выше
       *[below] ниже
    } этого значения.

# Folds and hysteresis.
bifurcation-loci-folds = Складки найдены при { $parameter } от { $value } до { $largest }, { $place }. Нижняя граница: { $below }; верхняя граница: { $above }.{ $stopped ->
        [yes] {" "}Расчёт остановлен; возможны и другие складки.
       *[no] {""}
    }
bifurcation-loci-limit = { $limit ->
        [cusp] точка сборки
        [folds-meet] складки сходятся
        [range] конец диапазона
       *[left] { $stopped ->
            [yes] кривая выходит из диапазона частот вращения, обрывается или была остановлена
           *[no] кривая выходит из диапазона частот вращения или обрывается
        }
    }
bifurcation-loci-widest-hysteresis = Гистерезис шире всего при { $parameter } = { $at }: ширина { $value }, начиная с { $lower }.{ $cut ->
        [yes] {" "}Складка там выходит из диапазона частот вращения; гистерезис продолжается за ним.
       *[no] {""}
    }{ $stopped ->
        [yes] {" "}Расчёт остановлен; возможны и другие складки.
       *[no] {""}
    }

# Single loci.
bifurcation-loci-fold-locus = Кривая { $locus }, складки: { $course }.
bifurcation-loci-stability-locus = Кривая { $locus }, { $kind }: { $course }.{ $whirl ->
        [yes] {" "}Частота прецессии на ней от { $lowest } до { $highest }.
       *[no] {""}
    }{ $others ->
        [all] {" "}На всей кривой есть и другие неустойчивые показатели.
        [part] {" "}На части кривой есть и другие неустойчивые показатели; эта часть не ограничивает устойчивые состояния.
       *[none] {""}
    }
bifurcation-loci-closed = замкнутая кривая
bifurcation-loci-from-to = от { $from } до { $to }
bifurcation-loci-end = { $value } при { $speed } ({ $end ->
        [value] конец диапазона параметра
        [speed] конец диапазона частот вращения
        [points] предел числа точек
        [stopped] расчёт остановлен
       *[stuck] кривая обрывается
    })
bifurcation-loci-unfinished = Кривая { $locus } обрывается при { $parameter } = { $value } и { $speed }: { $why }. Бифуркации за этой точкой могут быть пропущены.
bifurcation-loci-none = { $sought ->
        [both] Складки и другие смены устойчивости не найдены
        [folds] Складки не найдены
       *[stability] Смены устойчивости вне складок не найдены
    }{ $beside ->
        [lost] {" "}или их не удалось проследить
       *[none] {""}
    } в отклике при { $values } { $values ->
        [one] значении
       *[other] значениях
    } { $parameter }{ $stopped ->
        [yes] {" "}до остановки расчёта.
       *[no] {""}. Кривые при других значениях возможны; увеличьте points.
    }{ $beside ->
        [folds] {" "}{ $folds ->
            [one] Найдена { $folds } складка
            [few] Найдены { $folds } складки
           *[other] Найдено { $folds } складок
        }, но складки не запрошены.
       *[none] {""}
    }

# What was left out.
bifurcation-loci-starts-lost = Ни одну кривую не удалось проследить от { $count ->
        [one] { $count } бифуркации
       *[other] { $count } бифуркаций
    } рассчитанных откликов. Кривые могут быть пропущены; увеличьте points.
bifurcation-loci-no-response = Отклик не рассчитан при { $count ->
        [1] { $parameter } = { $first }
        [one] { $count } значении { $parameter }, первое { $first }
       *[other] { $count } значениях { $parameter }, первое { $first }
    }: { $why }. Кривые там могут быть пропущены.
bifurcation-loci-corners = { $count ->
        [one] { $count } складка лежит
        [few] { $count } складки лежат
       *[other] { $count } складок лежат
    } там, где закон силы меняется в ходе движения, например при замыкании контакта. Такие складки не прослеживаются.
bifurcation-loci-more = Кривых больше, чем { $most }; остальные не прослежены. Сузьте диапазон частот вращения.
bifurcation-loci-stability-unknown = Устойчивость части или всех состояний не рассчитана: { $why }. Кривые смены устойчивости могут быть пропущены.
bifurcation-loci-harmonics-short = Учтённые гармоники не передают { $value } нелинейной силы в худшей точке кривых. Увеличьте harmonics.
bifurcation-loci-parameter-range = Машины с { $parameter } { $side ->
        [below] ниже
       *[above] выше
    } { $value } не существует; эта часть диапазона пропущена: { $why }.
