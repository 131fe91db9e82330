# Parts of sentences.
separation-recovery = { $share } частиц
separation-recovery-from = { $share } частиц размером от { $diameter }
separation-particles = частиц
separation-particles-from = частиц размером от { $diameter }
separation-in-time = за { $time }
separation-at-throughput = при производительности { $throughput }
separation-without-spin = без вращения
separation-at-speed = при { $speed }
separation-no-run-up = {""}
separation-run-up-included = , включая разгон { $duration }
separation-run-up-estimated = , включая разгон { $duration }, оценённый по ускорению на среднем радиусе
# Begins a sentence.
separation-vessel = { $kind ->
        [swinging] Откидной стакан
        [fixed_angle] Пробирка углового ротора
        [tubular_bowl] Трубчатый барабан
        [disc_stack] Тарельчатый сепаратор
       *[decanter] Декантер
    }

# What is caught.
separation-caught = { $vessel } улавливает { $value } { $particles } { $at_hand } { $spin }{ $run_up }.
separation-all-sampled-caught = { $vessel } улавливает все частицы выборки, почти { $value } { $particles }, { $at_hand } { $spin }{ $run_up }. Последним понадобилось бы { $last }.
separation-all-sampled-caught-some-never = { $vessel } улавливает все частицы выборки, почти { $value } { $particles }, { $at_hand } { $spin }{ $run_up }. Некоторые не улавливаются никогда.
separation-never-caught = Улавливание { $recovery } { $spin } невозможно: часть частиц остаётся в жидкости. Уменьшите recovery или увеличьте diameter.
separation-time-needed = Улавливание { $recovery } { $spin } занимает { $value }{ $run_up }.
separation-residence-needed = Улавливание { $recovery } { $spin } требует времени пребывания { $value }, то есть производительности не больше { $throughput }.
separation-no-spin-needed = Улавливание { $recovery } { $at_hand } обеспечивает одна сила тяжести: вращение не нужно.
separation-speed-needed = Улавливание { $recovery } { $at_hand } требует частоты вращения не меньше { $value }{ $run_up ->
        [none] {""}
        [same] , разгон с тем же ускорением
       *[programme] , все частоты вращения программы в той же пропорции
    }.
separation-no-speed-suffices = Ни одна рассчитанная частота вращения до { $highest } не обеспечивает улавливания { $recovery } { $at_hand }{ $run_up ->
        [none] {""}
        [same] , разгон с тем же ускорением
       *[programme] , все частоты вращения программы в той же пропорции
    }. { $flow ->
        [yes] Уменьшите throughput или recovery
       *[no] Увеличьте time или уменьшите recovery
    }.
separation-one-speed = Частота вращения, нужная для улавливания { $recovery }, и чувствительности не рассчитаны: до частоты, большей заданной с коэффициентом { $times }, каждую частицу пришлось бы интегрировать с её инерцией. Задайте model = "drifting", где инерция не учтена, или рассчитайте отдельные частоты вращения.
separation-nothing-shown = Результата нет: предел объёма вычислений, в траекториях частиц, остановил расчёт до вычисления всех траекторий.
separation-cut-size = Граничный размер: улавливается половина { $particles ->
        [light] лёгких частиц
       *[heavy] частиц
    } размером { $value }{ $estimate ->
        [none] {""}
        [inertia] , без учёта инерции
       *[run_up] , оценка без учёта инерции, разгон учтён по ускорению на среднем радиусе
    }.
separation-released = Выпущенная частица достигает { $surface ->
        [wall] стенки
        [bottom] дна
       *[surface] поверхности жидкости
    } через { $value }, на { $along } вдоль стакана.
separation-released-stays = Выпущенная частица никогда не достигает поверхностей: она остаётся в жидкости.
separation-released-outside = Точка выпуска вне жидкости, траектория не рассчитана. Переместите release в жидкость.

# The cup and its field.
separation-tilt = Стакан отклоняется на { $value } от вертикали.
separation-tilt-none = Стакан висит вертикально: при этой частоте вращения он не отклоняется.
separation-tilt-held = Стакан удерживается под углом наклона { $value }.
separation-field = Центробежное ускорение: { $surface } g на поверхности жидкости и { $value } g на наружном радиусе.
separation-no-field = Действует одна сила тяжести: центробежное ускорение { $value } g.

# Validity of the model.
separation-gravity = При нужной частоте вращения ускорение у самого внутреннего слоя жидкости { $value } g. Модель пренебрегает силой тяжести, что верно выше { $least } g: нужная частота вращения — лишь оценка.
separation-validity = Применимость под сомнением ({ $name } = { $value }, предел { $limit }): { $meaning }.
separation-validity-undefined = Применимость под сомнением ({ $name } — не конечное число, предел { $limit }): { $meaning }.
