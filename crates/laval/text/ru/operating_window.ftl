# Requirements, as they stand in sentences.
operating-window-requirement = { $name ->
        [separation] время разделения
        [residence] время пребывания
        [vibration] вибрация
        [self_centred] самоцентрирование ротора
        [stable] устойчивость
        [clear] отстройка от собственных частот
        [passage] прохождение резонансов
        [strength] наибольшая частота вращения
        [valid] применимость моделей элементов
       *[range] рассчитанный диапазон
    }
operating-window-at-jump = { $requirement } при скачке
operating-window-span = от { $from } до { $to }

# What binds in a requirement.
operating-window-limited = { $quantity ->
        [displacement] перемещение тела «{ $of }»
        [velocity] виброскорость тела «{ $of }»
        [tilt] наклон тела «{ $of }»
        [force] сила элемента «{ $of }»
       *[moment] момент элемента «{ $of }»
    }
operating-window-centre-of-mass = расстояние центра масс тела «{ $body }» от оси
operating-window-growth-rate = инкремент{ $contents ->
        [before] {" "}до разделения
        [after] {" "}после разделения
       *[always] {""}
    }
operating-window-mode = расстояние моды { $frequency } от порядка { $order }
operating-window-swing = расстояние частоты качания стаканов от порядка { $order }
operating-window-moved = перемещение тела «{ $of }» при { $speed }
operating-window-torque = момент привода
operating-window-model = применимость модели элемента «{ $part }» ({ $statement })
operating-window-path = траекторию частицы рассчитать нельзя ({ $why })
operating-window-without-bound = амплитуда не ограничена при резонансе без демпфирования
operating-window-no-state = устойчивого установившегося режима нет

# Windows and their ends.
operating-window-window = Машина может работать от { $from } до { $value }. Ограничение снизу: { $below }, сверху: { $above }.
operating-window-widest-window = Ширина самого широкого окна { $value }, от { $from } до { $to }.
operating-window-edge = Окно { $side ->
        [begins] начинается
       *[ends] заканчивается
    } при { $value }: { $reason }.
operating-window-reason = { $what } достигает предела
operating-window-reason-limit = { $what } достигает предела { $limit }
operating-window-reason-undefined = за этой границей { $what }
operating-window-reason-jump = за этой границей { $what } скачком выходит за предел (отношение к пределу { $factor }){ $states ->
        [0] {""}
        [1] {""}
       *[other] {" "}в одном из устойчивых состояний ({ $states }), любого из которых может достичь медленный разгон или выбег
    }{ $fold ->
        [yes] , на складке
       *[no] {""}
    }
operating-window-reason-jump-undefined = за этой границей { $what } скачком выходит за предел{ $states ->
        [0] {""}
        [1] {""}
       *[other] {" "}в одном из устойчивых состояний ({ $states }), любого из которых может достичь медленный разгон или выбег
    }{ $fold ->
        [yes] , на складке
       *[no] {""}
    }
operating-window-robust-window = Робастное окно: от { $from } до { $value }, при допуске на частоту вращения { $tolerance }{ $corners ->
        [0] {""}
       *[other] {" "}и всех сочетаниях крайних значений неопределённых параметров ({ $corners })
    }.
operating-window-no-robust-window = Ни одна частота вращения не удовлетворяет всем требованиям при допуске на частоту вращения { $tolerance }{ $corners ->
        [0] {""}
       *[other] {" "}и всех сочетаниях крайних значений неопределённых параметров ({ $corners })
    }. Уменьшите допуски или ослабьте предел.
operating-window-incomplete = Расчёт остановлен раньше времени. Не рассчитано: { $parts }.
operating-window-missing = { $part ->
        [refinement] поиск узких разрывов между рассчитанными частотами вращения
        [robust] робастное окно
       *[map] карта
    }

# No window.
operating-window-no-window = Ни одна рассчитанная частота вращения в диапазоне не удовлетворяет всем требованиям.
operating-window-unstable = Машина неустойчива при всех рассчитанных частотах вращения: инкремент не меньше { $value }. Устраните неустойчивость прежде других ограничений.
operating-window-growth-margin = Ни одна рассчитанная частота вращения не обеспечивает growth_margin { $required }: наименьший инкремент { $value }{ $damping ->
        [none] , и хотя бы одна мода ничем не демпфирована
       *[some] {""}
    }. Добавьте демпфирование или уменьшите growth_margin.
operating-window-excluding = Ни одна рассчитанная частота вращения не удовлетворяет обоим требованиям ({ $first }, { $second }).
operating-window-lower-throughput = Снижение производительности до { $share } от заданной открыло бы окно при { $speed }.
operating-window-relaxation = Увеличение { $requirement ->
        [separation] располагаемого времени
        [vibration] определяющего предела вибрации
        [self_centred] предела самоцентрирования
        [passage] определяющего предела прохождения
       *[strength] наибольшей частоты вращения
    } с коэффициентом { $factor } открыло бы окно при { $speed }.
operating-window-no-relaxation = Ослабление одного требования окна не открывает: при каждой рассчитанной частоте вращения нарушены два или больше требований или у одного из них нет запаса.

# The recommended speed.
operating-window-best-speed = Рекомендуемая частота вращения: { $value }. { $why ->
        [margin] Наименьший запас там наибольший
        [next_margin] Наименьший запас ({ $least }) одинаков от { $from } до { $to }; решает следующий ({ $next })
        [throughput] Производительность там может быть наибольшей
        [time] Разделение там самое быстрое
        [energy] Энергия там наименьшая
       *[amplitude] Вибрация там наименьшая
    }.{ $duty ->
        [throughput] {" "}Производительность может достигать { $throughput }.
        [time] {" "}Разделение занимает { $time }.
       *[none] {""}
    }
operating-window-binding = Наименьший запас при рекомендуемой частоте вращения { $value }: { $requirement }.
operating-window-binding-detail = Наименьший запас при рекомендуемой частоте вращения { $value }: { $requirement }, { $detail }.
operating-window-not-faster = Выше рекомендуемой частоты вращения окно заканчивается при { $value }; ограничение: { $requirement }.
operating-window-field = Центробежное ускорение при рекомендуемой частоте вращения: { $inner } g на поверхности жидкости и { $value } g на наружном радиусе.
operating-window-outside-robust = Рекомендуемая частота вращения { $value } вне робастного окна, { $ranges }. Выберите частоту внутри него.
operating-window-shortest-time = Наименьшее время разделения при соблюдении всех остальных требований { $value }, при { $speed }.
operating-window-shortest-residence = Наименьшее время пребывания при соблюдении всех остальных требований { $value }, при { $speed }: производительность { $throughput }.

# Remarks.
operating-window-tilt-without-limit = Для наклона тела «{ $body }», до { $value } при { $speed }, предел не задан. Его перемещение проверяется только в опорной точке: добавьте tilt в [limits].
operating-window-not-checked = Не проверено (предел не задан): { $requirements }.
operating-window-few-requirements = Это окно ограничено только устойчивостью: это ещё не рабочее окно. Добавьте [limits] или [[cup]] с [suspension].
operating-window-nonlinear = { $policy ->
        [reached] Из нескольких устойчивых ветвей проверена та, которой достигает разгон из этого файла. Окно верно только для этого разгона
        [highest] Из нескольких устойчивых ветвей проверена ветвь с наибольшей вибрацией
       *[all] Проверены все устойчивые ветви нелинейного отклика: частота вращения исключается, если хотя бы одна из них превышает предел
    }.
operating-window-passage-peak = { $way ->
        [up] Разгон до { $top }
       *[down] Выбег от { $top }
    }: перемещение тела «{ $body }» достигает { $value } при { $speed }.
operating-window-passage-torque = Разгон требует момента привода до { $value }.
operating-window-braking = Торможение с тем же ускорением, что и разгон, нагружает осадок вбок силой в { $value } от центробежной.
operating-window-gravity = При { $speed }, на нижнем конце окна, ускорение у самого внутреннего слоя жидкости { $value } g. Модель пренебрегает силой тяжести, что верно выше { $least } g: разделение там — лишь оценка.
operating-window-run-up-estimate = Разгон засчитан как { $value } на полной частоте вращения, по оценке ускорения на среднем радиусе: жидкость в пробирках углового ротора при разгоне смещается.
