# Steady response to unbalance of a machine with nonlinear parts.

# Which branch; stands behind the word "branch".
nonlinear-response-branch = { $origin ->
        [low] со стороны низких частот вращения
        [high] со стороны высоких частот вращения
        [broken] с пониженной симметрией от { $speed }
        [doubled] с удвоенным периодом от { $speed }
        [crossing] с пересечением при { $speed }
        [mixed] с x и y в разных состояниях
        [subharmonic] с повторением через { $turns } { $turns ->
            [one] оборот
            [few] оборота
           *[other] оборотов
        }
       *[start] отдельно от других
    }
# Which part of a branch; likewise.
nonlinear-response-stretch = { $place ->
        [before] { $branch } до её складки при { $to }
        [beyond] { $branch } после её складки при { $from }
        [between] { $branch } между её складками при { $from } и { $to }
       *[whole] { $branch }
    }
nonlinear-response-more-ranges = ещё в { $n } { $n ->
        [one] диапазоне
       *[other] диапазонах
    }

# Why a branch ended. Whole sentences.
nonlinear-response-end = { $why ->
        [work-limit] Достигнут предел объёма вычислений.
        [range] Там заканчивается диапазон частот вращения.
        [points] Достигнуто наибольшее число точек; увеличьте max_points.
        [cancelled] Расчёт остановлен по запросу.
        [closed] Ветвь замыкается.
        [start] Начальные условия не дали сходимости.
        [undefined] Уравнения там не определены: { $cause }.
        [infinite] Сила или её производная там не имеет конечного значения; элемент используется вне своего диапазона.
        [singular] Уравнения там не имеют единственного решения: координата не закреплена или ветви пересекаются.
        [sharp] Ветвь там поворачивает слишком резко; учтите больше гармоник или сгладьте резкий закон силы.
        [strayed] Ближайшее дальнейшее решение принадлежит другой ветви; сузьте диапазон частот вращения вокруг него.
        [resonance] Движение тела там меняется слишком быстро, как при резонансе без демпфирования; добавьте демпфирование тел.
        [unbounded] Амплитуда растёт неограниченно при почти постоянной частоте вращения, как при резонансе без демпфирования; добавьте демпфирование.
       *[unsolved] Дальше решить уравнения не удалось; учтите больше гармоник или сгладьте резкий закон силы.
    }

# Run-up and run-down so slow that the response follows the branches.
nonlinear-response-jump = { $way ->
        [up] Квазистатический разгон
       *[down] Квазистатический выбег
    }: отклик { $again ->
        [no] меняется скачком
       *[yes] снова меняется скачком
    } при { $value }{ $onto ->
        [none] {""}
       *[other] {" "}с переходом на ветвь { $onto }
    }.
nonlinear-response-jump-unstable-before = Отклик перед этим скачком неустойчив { $ranges }; там машина может от него отойти.
nonlinear-response-jump-landing = { $stable ->
        [0] Сразу после скачка нет устойчивых рассчитанных состояний; движение там покажет `transient`.
        [one] После скачка { $stable } устойчивое состояние; какое достигается, покажет `basins`.
        [few] После скачка { $stable } устойчивых состояния; какое достигается, покажет `basins`.
       *[other] После скачка { $stable } устойчивых состояний; какое достигается, покажет `basins`.
    }
nonlinear-response-no-jump = { $way ->
        [up] Квазистатический разгон
       *[down] Квазистатический выбег
    } от { $from } до { $to }: скачков нет{ $amplitude ->
        [rising] , но амплитуда в конце диапазона ещё растёт
       *[other] {""}
    }.
nonlinear-response-no-fold = { $way ->
        [up] Квазистатический разгон
       *[down] Квазистатический выбег
    } от { $from } до { $to }: складок нет, но отклик неустойчив { $ranges }.
nonlinear-response-sweep-unfinished = { $way ->
        [up] Квазистатический разгон
       *[down] Квазистатический выбег
    }: ветвь прослежена только до { $value }. Скачки дальше неизвестны. { $why }
nonlinear-response-sweep-not-followed = { $way ->
        [up] Квазистатический разгон
       *[down] Квазистатический выбег
    }: ветви не прослежены. { $why }
nonlinear-response-sweep-unstable = { $way ->
        [up] Квазистатический разгон
       *[down] Квазистатический выбег
    }: складка при { $value } не вызывает скачка, так как отклик перед ней неустойчив { $ranges }. Движение там покажет `transient`.
nonlinear-response-sweep-unknown = { $way ->
        [up] Квазистатический разгон
       *[down] Квазистатический выбег
    }: при его первой частоте вращения { $value } периодическое решение не найдено. Начните с другой частоты вращения или задайте states = "all".
nonlinear-response-start-not-followed = Решение при { $value }, на границе диапазона, не удалось проследить извне диапазона. Машина, выведенная на эту частоту вращения, может вести себя иначе; расширьте диапазон.
nonlinear-response-two-branches = Найдены две отдельные ветви: со стороны низких и со стороны высоких частот вращения. Какая из них реализуется, зависит от предыстории частоты вращения.
nonlinear-response-branch-unfinished = Ветвь { $branch } прослежена после { $folds ->
        [1] её складки
       *[other] её складок
    } только до { $value }. { $why }

# The upper branch goes on beyond the range.
nonlinear-response-not-closed = Верхняя ветвь доходит без складки до { $speed }, конца диапазона: амплитуда { $value }, на нижней ветви { $lower }. Конец диапазона — не скачок.
nonlinear-response-beyond = { $beyond ->
        [closes] При продолжении за диапазон ветвь имеет складку при { $at }; отклик там меняется скачком.
        [stays] Демпфирование рассеивает там { $share } располагаемой мощности дисбаланса, а при высокой частоте вращения { $limit }. Складка возникает при 100 %, поэтому у этой ветви её нет.
        [rises] Демпфирование рассеивает там { $share } располагаемой мощности дисбаланса, при большей частоте вращения больше. Складка возникает при 100 %, дальше этой частоты, умноженной на { $reach }.
        [lost] Демпфирование рассеивает там { $share } располагаемой мощности дисбаланса; складка возникает при 100 %. Продолжить ветвь удалось только до { $at }.
       *[unknown] Демпфирование рассеивает там { $share } располагаемой мощности дисбаланса; складка возникает при 100 %.
    }

# The search for further states.
nonlinear-response-further-states = Дополнительные состояния, { $kind }: { $branches } { $branches ->
        [one] ветвь
        [few] ветви
       *[other] ветвей
    } от { $value } до { $to }, { $stability ->
        [some] частично устойчивы между { $low } и { $high }
        [none] всюду неустойчивы
       *[unknown] устойчивость неизвестна
    }.
nonlinear-response-copies = { $kind ->
        [turned] Каждая ветвь представляет симметричные копии числом до { $copies }.
       *[later] Каждая ветвь представляет копии числом до { $copies }: повёрнутые по симметрии машины или запаздывающие на оборот ротора.
    }
nonlinear-response-no-further-states = Дополнительных состояний не найдено: испытаны { $starts ->
        [0] смешанные и субгармонические начальные условия
       *[other] смешанные, субгармонические и случайные начальные условия
    }. Поиск не исчерпывающий.
nonlinear-response-families-left-out = Прослежены не все семейства состояний. Сузьте диапазон частот вращения, чтобы увидеть остальные.
nonlinear-response-search-not-begun = Поиск дополнительных состояний не начат, так как основные ветви не полны. Дополнительные состояния не исключены.
nonlinear-response-search-stopped = Поиск дополнительных состояний не завершён: испытано { $speeds } из { $all-speeds } частот вращения и { $starts } из { $all-starts } случайных начальных условий. Дополнительные состояния могут быть пропущены.
nonlinear-response-search-in-time = По времени проинтегрировано { $starts } из { $all-starts } начальных условий.

# Largest values.
nonlinear-response-largest = Наибольшее установившееся перемещение: { $value }, у { $body } { $place ->
        [end] на конце диапазона, { $speed }
       *[inside] при { $speed }
    }.
nonlinear-response-largest-at-left-end = Эта ветвь прослежена только до этого места; дальше не исключены перемещения больше этого.
nonlinear-response-largest-left = Эта ветвь прослежена только до { $left }; дальше не исключены перемещения больше этого.
nonlinear-response-largest-of = Наибольшее установившееся перемещение { $body }: { $value }, при { $speed }.
nonlinear-response-largest-tilt = Наибольший установившийся наклон тела «{ $body }»: { $value }, при { $speed }.
nonlinear-response-not-reached = { $quality ->
        [tilt] Наибольший установившийся наклон { $body } не достигнут
       *[displacement] Наибольшее установившееся перемещение { $body } не достигнуто
    }: { $value } с ростом при { $speed }, где прослеживание ветви { $branch } прекращено.
nonlinear-response-unbounded = { $quality ->
        [tilt] Установившийся наклон { $body } не ограничен
       *[displacement] Установившееся перемещение { $body } не ограничено
    }: { $value } с ростом при { $speed }, где прослеживание ветви { $branch } прекращено. Добавьте демпфирование.
nonlinear-response-largest-force = Наибольшая установившаяся сила элемента «{ $part }»: { $value }, при { $speed }.
nonlinear-response-largest-force-left = Отклик прослежен не до конца; силы больше этой не исключены.
nonlinear-response-antiresonance = Антирезонанс: сила элемента «{ $part }» падает до { $force } при { $value }, это { $share } от меньшего из соседних максимумов.
nonlinear-response-tuning = Настройка: жёсткость { $value } тела «{ $body }» (сейчас { $stiffness }) снизила бы силу элемента «{ $part }» при { $speed } с { $before } до { $after } на нижней ветви.
nonlinear-response-tuned = { $stability ->
        [stable] Отклик после настройки устойчив.
        [unstable] Отклик после настройки неустойчив, инкремент { $growth }; не настраивайте фундамент без дополнительного демпфирования.
       *[unknown] Устойчивость отклика после настройки не оценена.
    }
nonlinear-response-self-centring = Самоцентрирование: при высокой частоте вращения амплитуда тела «{ $body }» стремится к { $value }. При { $speed } она { $amplitude }, отличие { $difference } по амплитуде и фазе.
nonlinear-response-centred = Отличие меньше { $close } начиная с { $from }.
nonlinear-response-centred-beyond = По экстраполяции отличие становится меньше { $close } при { $from }.
nonlinear-response-centring-unstable = Отклик при { $speed } неустойчив.
nonlinear-response-force-limit = На нижней ветви сила элемента «{ $part }» при высокой частоте вращения стремится к { $value }.

# Stability.
nonlinear-response-unstable = Ветвь { $stretch } неустойчива { $ranges }. Наибольший инкремент { $value }, при { $speed }. Избегайте этих частот вращения или добавьте демпфирование.
nonlinear-response-stability = С ростом частоты вращения ветвь { $stretch } становится { $way ->
        [lost] неустойчивой
       *[gained] устойчивой
    } { $place ->
        [located] при { $value }
       *[bracketed] вблизи { $value }, между { $from } и { $to }
    }: { $event }.
nonlinear-response-event = { $kind ->
        [neimark-sacker] бифуркация Неймарка–Сакера, выше неё колебания с частотой { $frequency } { $way ->
            [lost] растут
           *[gained] затухают
        }
        [torus] бифуркация Неймарка–Сакера, выше неё колебания со второй частотой { $way ->
            [lost] растут
           *[gained] затухают
        }
        [period-doubling] удвоение периода, соседние периоды различаются
        [symmetry-breaking] потеря симметрии, ответвляются состояния с пониженной симметрией
       *[branch-point] точка ветвления, пересечение с другой ветвью
    }
nonlinear-response-more-bifurcations = В таблице ещё { $more } { $more ->
        [one] бифуркация
        [few] бифуркации
       *[other] бифуркаций
    }.
nonlinear-response-stability-checked = Устойчивость { $states } { $states ->
        [one] состояния
       *[other] состояний
    } проверена двумя методами, не использующими симметрию; инкременты различаются не больше чем на { $value }.
nonlinear-response-stability-contradicted = Два других метода противоречат оценке устойчивости в { $contradictions } из { $checks } { $checks ->
        [one] сравнения
       *[other] сравнений
    }; инкременты различаются до { $value }. Считайте устойчивость недоказанной.
nonlinear-response-stability-not-checked = Устойчивость не проверена вторым методом: { $why }.
nonlinear-response-nothing-checked = Устойчивость не проверена вторым методом: ни одно состояние не оценено повторно.
nonlinear-response-stability-not-requested = Оценка устойчивости не запрошена, состояния могут быть неустойчивы. Задайте stability = true.
nonlinear-response-stability-reduced = Для оценки устойчивости линейные части сведены к { $coordinates } координатам. До частоты { $frequency } их податливость в точках нелинейных частей отличается от податливости всей машины на { $value }.
nonlinear-response-stability-unknown = Устойчивость состояний не оценена: { $why }. Они могут быть неустойчивы.
nonlinear-response-stability-partly-unknown = Устойчивость { $unknown } из { $all } { $all ->
        [one] состояния
       *[other] состояний
    } не оценена: { $why }. Они могут быть неустойчивы.
# Why stability was not assessed.
nonlinear-response-unassessed = { $why ->
        [no-time-form] элемент «{ $part }» не имеет формы во временной области: { $cause }
        [states] { $states ->
            [one] машина имеет { $states } состояние первого порядка
            [few] машина имеет { $states } состояния первого порядка
           *[other] машина имеет { $states } состояний первого порядка
        }, больше, чем допускает матрица монодромии
        [massless] одна из координат не имеет массы
        [jumps] сила элемента «{ $part }» при касании меняется скачком, и влияние такого скачка на возмущение не рассчитывается
       *[failed] { $cause }
    }
nonlinear-response-stability-fit = Устойчивость оценена по аппроксимации элемента «{ $part }» во времени; сами состояния точны.
nonlinear-response-determinant = Устойчивость { $states } { $states ->
        [one] состояния
       *[other] состояний
    } оценена по определителю Хилла с точными импедансами. Подсчитаны показатели, растущие быстрее { $value }; из затухающих известны лишь некоторые.
nonlinear-response-balls-elsewhere = Среди рассчитанных состояний нет устойчивых. У шариков есть другие состояния; используйте `stationary`, `transient` или `basins`.

# Validity.
nonlinear-response-harmonics = Учтённые гармоники не передают { $value } нелинейной силы в худшей точке. Резкие особенности движения не разрешены; сгладьте законы сил с изломами.
nonlinear-response-no-number = Элемент «{ $part }» в некоторых состояниях не даёт конечной силы. Отклик там недействителен.

# Orders beside the synchronous one.
nonlinear-response-no-orders = Ни у одного тела суб- и супергармонические амплитуды не превышают { $limit }.
nonlinear-response-order-range = { $kind ->
        [superharmonic] Супергармоника
        [subharmonic] Субгармоника
       *[component] Составляющая
    } порядка { $divisor ->
        [1] { $order }
       *[other] { $order }/{ $divisor }
    } тела «{ $body }» превышает { $limit } { $extent ->
        [all] от { $value } до { $to }, на всей ветви { $branch }
        [inside] от { $value } до { $to } на ветви { $branch }
        [begins] до { $to } на ветви { $branch }, которая начинается при { $value }
       *[ends] от { $value } на ветви { $branch }, которая заканчивается при { $to }
    }. Она достигает { $largest } при { $speed }, { $sense ->
        [forward] прямая прецессия
        [backward] обратная прецессия
       *[line] по прямой линии
    }.
nonlinear-response-more-orders = В особых точках указано ещё { $more } { $more ->
        [one] диапазон
        [few] диапазона
       *[other] диапазонов
    } порядков с амплитудой больше { $limit }.

# One speed.
nonlinear-response-no-motion = При { $speed } периодическое решение не найдено. Движение там покажет `transient`.
nonlinear-response-no-motion-stopped = До остановки расчёта периодическое решение при { $speed } не найдено.
nonlinear-response-all-unstable = { $count ->
        [1] Единственное найденное периодическое решение при { $speed } неустойчиво.
       *[other] Все найденные периодические решения при { $speed } неустойчивы ({ $count }).
    } Движение там покажет `transient`.
nonlinear-response-steady = При { $speed } { $quality ->
        [tilt] наибольший наклон
       *[displacement] наибольшее перемещение
    } { $body }: { $value }{ $count ->
        [1] {""}
       *[other] , решение { $number } из { $count }
    }. { $stability ->
        [stable] Отклик устойчив.
        [unstable] Отклик неустойчив.
       *[unknown] Устойчивость отклика неизвестна.
    }
nonlinear-response-period = Отклик повторяется через { $turns } { $turns ->
        [one] оборот
        [few] оборота
       *[other] оборотов
    }.
nonlinear-response-no-excitation = Машина не возбуждается.
