# Phrases that several studies share.

list-and = { $rest } и { $last }
list-or = { $rest } или { $last }
# A body, a point of a body, the tilt of a body: in the genitive.
body = тела «{ $body }»
point = тела «{ $body }» на высоте { $height }
tilt-of = наклона тела «{ $body }»
# A range of speeds.
range = от { $from } до { $to }
at = при { $at }

# A coefficient table that a study leaves.
beyond-table = Таблица элемента «{ $part }» охватывает значения от { $from } до { $to }. { $sides ->
        [both] Вне её, вниз до { $lowest } и вверх до { $highest },
        [below] Ниже её, до { $lowest },
       *[above] Выше её, до { $highest },
    } коэффициенты { $rule ->
        [hold] приняты равными крайним
        [linear] продолжены по крайнему наклону
       *[refuse] неизвестны
    }.
beyond-table-note = Вне таблицы элемента «{ $part }».
beyond-table-frequency = Таблица элемента «{ $part }» охватывает частоты колебаний от { $from } до { $to }. { $sides ->
        [both] Вне её, вниз до { $lowest } и вверх до { $highest },
        [below] Ниже её, до { $lowest },
       *[above] Выше её, до { $highest },
    } коэффициенты { $rule ->
        [hold] приняты равными крайним
        [linear] продолжены по крайнему наклону
       *[refuse] неизвестны
    }.
over-frequency-beyond = { $n ->
        [1] Частота моды { $modes } лежит
       *[other] Частоты мод { $modes } лежат
    } вне таблицы элемента «{ $part }», которая охватывает значения от { $from } до { $to }: там результат недействителен.
over-frequency-growth-unassessed = Устойчивость не оценена: { $n ->
        [1] элемент { $parts } имеет
       *[other] элементы { $parts } имеют
    } здесь коэффициенты частоты возбуждения. Используйте modes или campbell, где у каждой моды коэффициенты её собственной частоты.
over-frequency-counted = { $n ->
        [1] Элемент { $parts } имеет
       *[other] Элементы { $parts } имеют
    } в каждой моде коэффициенты её собственной частоты. { $speeds ->
        [1] По счёту
       *[other] По счёту при { $speeds } частотах вращения
    } ни одна мода от { $from } до { $to } не пропущена.
over-frequency-not-counted = { $speeds ->
        [1] Моды
       *[other] При { $open } из { $speeds } частот вращения моды
    } от { $from } до { $to } могли быть пропущены: с коэффициентами { $n ->
        [1] элемента { $parts }
       *[other] элементов { $parts }
    } на собственной частоте счёт расходится с найденными модами. Поиск облегчают более узкая таблица или больше строк.
over-frequency-outside = Моды { $sides ->
        [both] ниже { $from } и выше { $to } не рассчитаны: там кончается таблица или frequency_limit
        [below] ниже { $from } не рассчитаны: там таблица начинается
       *[above] выше { $to } не рассчитаны: там кончается таблица или frequency_limit
    }. Инкремент там неизвестен.

# Nothing excites the machine.
unforced = Машина не возбуждается: наибольшее перемещение { $value }, резонансы не указаны. Задайте диску эксцентриситет, дисбаланс или перекос.

# Linear studies: what they are linearised about.
support-linearised = { $n ->
        [1] Нелинейный элемент { $parts } линеаризован
       *[other] Нелинейные элементы { $parts } линеаризованы
    } около { $state ->
        [undeflected] недеформированного состояния
       *[deflected] положения равновесия под нагрузкой
    }. Результаты верны для малых колебаний.
support-fitted-part = Начальные собственные значения получены с рациональной аппроксимацией элемента «{ $part }»; они уточнены с его точным импедансом.
support-open-gap = Зазор элемента «{ $part }» в положении равновесия открыт и не добавляет жёсткости. Контакт начинается при относительном перемещении больше { $value }.
support-outside = Элемент «{ $part }» при { $speed } вне области применимости даже без колебаний: { $what } = { $value } (предел 1).
support-outside-unbounded = Элемент «{ $part }» при { $speed } вне области применимости даже без колебаний: { $what } = ∞ (предел 1).

# Motions outside the validity of a part.
validity-states = Недействительно: часть состояний { $place } вне области применимости элемента «{ $part }» ({ $what } = { $value }, предел 1).
validity-states-unbounded = Недействительно: часть состояний { $place } вне области применимости элемента «{ $part }» ({ $what } = ∞, предел 1).
validity-motions = Недействительно: часть { $motions } вне области применимости элемента «{ $part }» ({ $what } = { $value }, предел 1).
validity-motions-unbounded = Недействительно: часть { $motions } вне области применимости элемента «{ $part }» ({ $what } = ∞, предел 1).

# Count of roots by the argument principle.
region-growing-root = неустойчивый корень
region-faster-root = корень с инкрементом больше { $growth }
region-all-roots = Число корней проверено (принцип аргумента): ниже { $frequency } не пропущен ни один { $root }. { $found ->
        [0] В проверенных областях корней нет
        [1] Единственный корень в проверенных областях известен
       *[other] Все корни в проверенных областях известны, их { $found }
    }.
region-all-modes = { $found ->
        [0] Ниже { $frequency } у машины нет мод
        [1] Единственная мода ниже { $frequency } вычислена
       *[other] Вычислены все моды ниже { $frequency }, их { $found }
    }; ни одна не пропущена (число корней проверено по принципу аргумента). Моды выше не вычислены: у машины { $states } состояний. Границу задаёт frequency_limit.
region-modes-followed = Прослежены все моды ниже { $frequency }: их число проверено на { $speeds } из { $all } частот вращения (принцип аргумента). Моды выше не вычислены; границу задаёт frequency_limit.
region-modes-not-counted = Ниже { $frequency } могут быть пропущены моды: подсчёт не удался на { $open } из проверенных частот вращения. Задайте другой frequency_limit.
region-slower-roots-missed = Число корней проверено (принцип аргумента): ниже { $frequency } не пропущен ни один { $root }. Медленные волны { $part } добавляют { $missing ->
        [one] { $missing } корень, который учтён при подсчёте, но не вычислен
        [few] { $missing } корня, которые учтены при подсчёте, но не вычислены
       *[other] { $missing } корней, которые учтены при подсчёте, но не вычислены
    }.
region-roots-missed = Устойчивость не доказана: { $missing ->
        [1] один учтённый корень не найден, и это может быть
        [one] { $missing } учтённый корень не найден, и среди них может быть
        [few] { $missing } учтённых корня не найдены, и среди них может быть
       *[other] { $missing } учтённых корней не найдены, и среди них может быть
    } { $root }. Уменьшите frequency_limit или задайте growth_threshold больше 0.
region-roots-not-counted = { $proven ->
        [yes] Ниже { $frequency } не пропущен ни один { $root }, но более медленные корни могут быть пропущены
       *[no] Устойчивость не доказана, корни могут быть пропущены
    }: подсчёт не удался в { $open } из { $all } { $all ->
        [one] области
       *[other] областей
    }. Попробуйте другое значение frequency_limit.
region-uncounted-roots = Корней вне проверенных областей: { $outside } из { $all }. Рядом с ними могут быть пропущены другие корни.
region-dense-range = При { $speed } спектр { $waves } { $part } непрерывен на частотах прямой прецессии от { $from } до { $to }. Демпфирование вне этого элемента вызывает медленный рост некоторых из них, поэтому неустойчивостью считается только рост быстрее порога. Более медленный рост зависит от { $loss }, чего в модели нет.
region-half-plane = Подсчитаны только неустойчивые корни. Затухающие корни машины при наличии { $part } найдены поиском; корень, который слабо виден в отклике, может быть пропущен.
region-accumulation = Корни от { $from } до { $to } с ростом или затуханием медленнее { $growth } не подсчитаны: при { $speed } там сгущаются волны.
region-other-orders = ещё { $n }
region-orders-without-response = { $n ->
        [1] Порядок отклика { $orders } лежит
       *[other] Порядки отклика { $orders } лежат
    } в непрерывном спектре { $waves }, от { $from } до { $to } при { $value }. Там у { $part } нет установившегося отклика, и уравнения не имеют решения. { $remedy }.
region-orders-of-kept-waves = { $n ->
        [1] Порядок отклика { $orders } лежит
       *[other] Порядки отклика { $orders } лежат
    } в непрерывном спектре { $waves }, от { $from } до { $to } при { $value }. Там у { $part } нет установившегося отклика; { $kept }.

# A study that ended early, or did not begin.
watch-nothing-shown = Результата нет: расчёт остановлен внутри вычисления, у которого нет частичного результата.
store-incomplete = Рассчитаны не все { $rows }: { $done } из { $requested }.
store-incomplete-kept = Рассчитаны не все { $rows }: { $done } из { $requested }. Та же команда продолжит расчёт с этого места.
run-refused = { $reason }
run-refused-alike = Расчёт отклонён по той же причине, что и расчёт «{ $study }».

# Vessels that the dynamics lack.
cups-not-carried = В динамике не учтены масса и дисбаланс сосуда «{ $vessel }»: он не закреплён ни на одном теле. Добавьте on = "{ $body }" с mass и centre_of_mass.
cups-not-carried-by-any = В динамике не учтены масса и дисбаланс сосуда «{ $vessel }»: он не закреплён ни на одном теле. Укажите тело в on и добавьте mass и centre_of_mass.
cups-bowl-without-liquid = В динамике не учтена жидкость в сосуде «{ $vessel }». Добавьте [[part]] с kind = "liquid" в тело барабана или добавьте её массу к этому телу.
