# The first page of a report, and the summary in the terminal.

# Verdicts.
verdict-passed = выполнено
verdict-no_limit = предел не задан
verdict-not_computed = не рассчитано
verdict-attention = внимание
verdict-failed = не выполнено

# The same, short, for the terminal.
short-passed = норма
short-no_limit = не задано
short-not_computed = нет данных
short-attention = внимание
short-failed = НАРУШЕНО
short-near = мало

# Headline.
headline-stable = Устойчиво при { $speed }.
headline-stable-below = Устойчиво при { $speed }, насколько показывают моды ниже { $limit }.
headline-unstable = Неустойчиво при { $speed }. Не эксплуатируйте машину при этой частоте вращения.
headline-not-proven = Устойчивость при { $speed } не доказана.
headline-unknown = Устойчивость при { $speed } не рассчитана.
headline-unknown-table = Устойчивость при { $speed } не рассчитана: коэффициенты «{ $part }» заданы только для частот колебаний от { $from } до { $to }; расчёт «modes» даёт моды на этих частотах, а строки таблицы для других частот — остальные моды.
headline-no-speed = Рабочая частота вращения не задана.
headline-limit = Не выполнено: { $checks }.
headline-not-checked = Требуется, но не проверено: { $checks }.
headline-studies-not-run = Не учтены исследования из файла: { $studies }. Они могут найти больше: запустите их.
headline-attention = Требует внимания: { $checks }.
headline-several = Какой из нескольких установившихся откликов возникнет, зависит от разгона.
headline-validity = Не все результаты лежат в области применимости.
headline-buckled = В покое машина не удерживает положение (потеря статической устойчивости): перемещение растёт в e раз за { $time }.
headline-jump = { $kind ->
        [jump] Отклик скачком меняется при { $speed }
       *[bifurcation] Устойчивость отклика меняется при { $speed }
    }, { $side ->
        [inside] среди рабочих частот вращения
        [above] на { $margin } выше рабочей частоты вращения
       *[below] на { $margin } ниже рабочей частоты вращения
    }.
headline-resonance = Ближайший резонанс, { $resonance }, отстоит всего на { $margin }.
headline-resonance-inside = Резонанс при { $resonance } лежит среди рабочих частот вращения.
headline-near-instability = Ближайшая неустойчивость отстоит всего на { $margin }.
headline-crosses = { $count ->
        [1] Разгон проходит через неустойчивый диапазон, от { $from } до { $to }.
        [one] Разгон проходит через { $count } неустойчивый диапазон между { $from } и { $to }.
        [few] Разгон проходит через { $count } неустойчивых диапазона между { $from } и { $to }.
       *[other] Разгон проходит через { $count } неустойчивых диапазонов между { $from } и { $to }.
    }
headline-crosses-open = При разгоне машина неустойчива начиная с { $from } (исследовано до { $to }).
headline-slip = Разгон проходит диапазон от { $from } до { $to } без устойчивого синхронного состояния.

# Remarks below it.
remark-here = При { $speed }
remark-below = При разгоне
remark-above = Выше
remark-unstable = { $open ->
        [yes] Неустойчиво начиная с { $from } (исследовано до { $to }):
        [below] Неустойчиво до { $to } (исследовано от { $from }):
        [both] Неустойчиво при всех исследованных частотах вращения, от { $from } до { $to }:
       *[no] Неустойчиво от { $from } до { $to }:
    } { $oscillates ->
        [yes] прецессия с частотой { $frequency }
       *[no] движение без колебаний
    } растёт в e раз за { $time } при наихудшей частоте вращения.
remark-resonance = Резонанс при { $speed }, «{ $body }» { $value }.
remark-resonance-unbounded = Резонанс без демпфирования при { $speed }: амплитуда тела «{ $body }» не ограничена.
remark-resonances = Другие резонансы при { $speeds }.
remark-critical = Критическая частота вращения { $speed }.
remark-jump = При медленном изменении частоты вращения отклик меняется скачком при { $speeds }.
remark-harm = От { $from } до { $to } шарики увеличивают дисбаланс, самое большее в { $times } раза.
remark-stability = { $text }.
remark-vibration = Вибрация: { $text }.
remark-forces = Силы: { $text }.

# Checks: name, result, requirement.
check-stability = Устойчивость
check-instability = Ближайшая неустойчивость
check-resonance = Ближайший резонанс
check-jump = Ближайший скачок или бифуркация
check-vibration = Вибрация
check-shaft-vibration = Вибрация вала в подшипниках
check-housing-vibration = Вибрация корпусов подшипников
check-balance = Качество балансировки
check-velocity = Виброскорость
check-forces = Силы
check-validity = Применимость
check-balls = Дисбаланс с шариками
check-run-up = Разгон
check-window = Рабочее окно
check-speed = Наибольшая частота вращения
check-others = Остальные пределы
check-studies = Требования расчётов
check-damping = Демпфирование

required-decay = { $margin ->
        [none] затухание
       *[other] затухание ≥ { $margin }
    }
required-below = ≤ { $limit }
required-each = ≤ пределов
required-above = ≥ { $limit }
required-balance = { $grade }: ≤ { $limit }
required-validity = в пределах
required-less-unbalance = меньше, чем без шариков

stability-stable = { $modes ->
        [1] мода затухает со скоростью { $decay }
       *[other] затухают все моды ({ $modes }), самая медленная со скоростью { $decay }
    }
stability-stable-below = { $modes ->
        [1] мода ниже { $limit } затухает со скоростью { $decay }
       *[other] все моды ниже { $limit } затухают (их { $modes }), самая медленная со скоростью { $decay }
    }
stability-across = { $modes ->
        [one] { $modes } поперечная форма затухает, самая медленная с показателем { $decay }
        [few] { $modes } поперечные формы затухают, самая медленная с показателем { $decay }
       *[other] { $modes } поперечных форм затухают, самая медленная с показателем { $decay }
    }; продольные и крутильные колебания без демпфирования
stability-unstable = { $motion ->
        [divergence] статическая неустойчивость (дивергенция): перемещение
       *[whirl] неустойчивая прецессия: амплитуда
    } растёт в e раз за { $time }
stability-steady = установившийся отклик при этой частоте вращения устойчив (нелинейный отклик)
stability-decays = самая медленная мода затухает со скоростью { $decay }
stability-unknown = растущих мод не найдено, но некоторые могут быть пропущены
stability-slow = нет роста быстрее { $limit }; более медленный не разрешается
stability-neutral = наименее демпфированная мода не имеет демпфирования
stability-balanced = уравновешенное состояние устойчиво
stability-state = устойчиво состояние, которое не уравновешивает ротор
stability-no-state = устойчивого синхронного состояния при этой частоте вращения нет
stability-needs-stationary = в роторе движутся шарики: нужен расчёт «stationary»
stability-no-steady = ни один установившийся отклик при этой частоте вращения не устойчив (нелинейный отклик)
stability-several = устойчивых установившихся откликов при этой частоте вращения: { $count } (нелинейный отклик)
stability-beside = покой устойчив, но устойчива и прецессия до { $value }: к ней может привести возмущение
stability-outside-study = расчёт «stationary» не охватывает эту частоту вращения
stability-unstable-range = неустойчиво при рабочих частотах вращения: { $range }
damping-no-oscillation = колебательных мод нет
damping-least = логарифмический декремент { $decrement } на частоте { $frequency }
stability-mode = { $place ->
        [none] на частоте { $frequency }, логарифмический декремент { $decrement }
       *[other] на частоте { $frequency }, логарифмический декремент { $decrement }; наименее устойчива рабочая частота вращения { $place }
    }
stability-no-mode = у машины нет мод
distance-both = { $below } снизу, { $above } сверху
distance-below = { $below } снизу, сверху нет до { $to }
distance-above = снизу нет, { $above } сверху
distance-stable-throughout = { $from ->
        [none] не найдена до { $to }
       *[other] не найдена от { $from } до { $to }
    }
distance-inside-unstable = { $open ->
        [unknown] рабочая частота вращения лежит в неустойчивом диапазоне
        [yes] внутри, неустойчиво от { $from } и выше (исследовано до { $to })
        [below] внутри, неустойчиво до { $to } (исследовано от { $from })
        [both] внутри, неустойчиво при всех исследованных частотах вращения, от { $from } до { $to }
       *[no] внутри, неустойчиво от { $from } до { $to }
    }
distance-inside = среди рабочих частот вращения: { $places }
distance-no-other-resonance = { $from ->
        [none] других нет до { $to }
       *[other] других нет в диапазоне от { $from } до { $to }
    }
distance-critically-damped = критически демпфирован при { $speeds }: коэффициент усиления ниже 2,5, API 684 не требует запаса по частоте
distance-not-examined = для требуемого запаса нужны все частоты вращения от { $from } до { $to }
distance-coarse = рассчитано слишком мало частот вращения: между ними может лежать узкая область
distance-orders-open = резонансы при возбуждении с кратностью { $orders } не искались: добавьте расчёт critical_speeds
distance-silent = критическая частота вращения прямой прецессии { $speeds }: дисбаланс этого файла её не возбуждает, другой может
distance-no-resonance = { $from ->
        [none] нет до { $to }
       *[other] нет в диапазоне от { $from } до { $to }
    }
item-of = { $name } { $value } из { $limit }
item = { $name } { $value }
item-force = { $rest ->
        [none] { $name } { $value }
       *[other] { $name } { $value } (статическая { $rest })
    }
both = { $first }; { $second }
vibration-sizes = { $sizes }
vibration-velocity = { $name } { $peak }, пик виброскорости
velocity-sizes = { $sizes } (пик)
velocity-is = наибольшее значение { $value } (пик)
vibration-nonlinear = наибольший устойчивый отклик нелинейной машины
vibration-states = наибольшее по устойчивым состояниям шариков
vibration-contact = линейный расчёт; возник бы контакт ({ $parts }), амплитуда недействительна
vibration-touching = малые колебания около покоя, при котором уже есть контакт: { $parts }
response-without-spins = без дисбаланса { $spins }: его учитывает "forced_response" с полем spin
response-with-spins = с добавленной вибрацией { $spins } из расчёта «forced_response» со spin
forces-without = без нелинейных элементов: { $parts }
forces-not-linear = по касательной в покое; отличается более чем на десятую от силы того же движения по закону: { $parts }; решает nonlinear_response
vibration-unstable = установившихся колебаний нет: машина неустойчива
vibration-unbounded = резонанс без демпфирования при этой частоте вращения
forces-none = неизвестны
forces-sizes = { $sizes }
forces-with-rest = наибольшее за оборот вместе со статической нагрузкой, например весом; вибрация отсчитана от статического прогиба
validity-none = ни один элемент не указывает предела
validity-doubt = в расчётах файла под сомнением: { $names }
validity-statement = { $part }, { $what }
validity-inside = { $share } ближайшего предела: { $statement }
validity-elsewhere = в пределах при этой частоте вращения; в расчётах файла вне пределов: { $outside }
validity-outside-here = отношение к пределу { $ratio }: { $statement }
validity-unbounded = предел превышен неограниченно: { $statement }
validity-nothing = при этой частоте вращения не оценён ни один элемент
validity-studies-inside = ни один расчёт файла не дал результатов вне области применимости
validity-studies = в расчётах файла вне пределов: { $outside }
window-none = ни одна частота вращения не удовлетворяет всем требованиям
window-ranges = { $ranges }
speed-is = { $speed }
limits-left-out = на этой странице не оценены: { $names }
studies-requirements = не выполнены или не подтверждены в { $studies }
check-run-study = выполните расчёт «{ $study }» из файла
balls-no-study = нужен расчёт «stationary» или «transient»
balls-left = осталось { $left } из { $without }
run-up-computed = наибольшее перемещение { $value } («{ $body }»)
run-up-steady = наибольшее перемещение { $value } («{ $body }»), в конце разгона
run-up-unknown = что лежит ниже { $speed }, неизвестно
run-up-contact = при медленном проходе вибрация закрывает зазор: { $parts }
run-up-grows = в неустойчивых диапазонах возмущение растёт с коэффициентом до { $factor }
run-up-diverges = движение расходится
run-up-buckled = в покое машина не удерживает положение
run-up-free = без резонансов и неустойчивых диапазонов
run-up-resonances = проходит через { $count ->
        [1] резонанс при { $resonances }
        [one] { $count } резонанс, при { $resonances }
        [few] { $count } резонанса, при { $resonances }
       *[other] { $count } резонансов, при { $resonances }
    }
run-up-unstable = проходит через { $several ->
        [1] неустойчивый диапазон
       *[other] неустойчивые диапазоны
    } { $ranges }
run-up-both = проходит через { $count ->
        [1] резонанс при { $resonances }
        [one] { $count } резонанс, при { $resonances },
        [few] { $count } резонанса, при { $resonances },
       *[other] { $count } резонансов, при { $resonances },
    } и через { $several ->
        [1] неустойчивый диапазон
       *[other] неустойчивые диапазоны
    } { $ranges }
speed-span = { $from } – { $to }
why-refused = неприменимо к этой машине: { $reason }
why-same = неприменимо по той же причине
why-too-long = занимает больше секунды; добавьте расчёт в файл
from-study = по расчёту «{ $study }»
why-no-speed = рабочая частота вращения выше 0 не задана

# What to do next.
next-speed = Задайте speed в [machine]: для проверок нужна рабочая частота вращения.
next-unstable = { $sides ->
        [both] Выберите частоту вращения ниже { $below } или выше { $above }
        [below] Выберите частоту вращения ниже { $below }
        [above] Выберите частоту вращения выше { $above }
       *[none] Выберите частоту вращения вне неустойчивого диапазона
    } или добавьте демпфирование; см. карту устойчивости.
next-viscosity = Задайте вязкость жидкости: без неё рост медленнее { $limit } не разрешается.
next-validity = Учтите выводы о применимости: в них названы сомнительные результаты и то, что изменить в модели.
next-buckled = { $count ->
        [0] Увеличьте жёсткость, удерживающую машину в покое, или уменьшите сжимающую осевую силу.
       *[other] Увеличьте жёсткость { $parts } или уменьшите сжатие: при растущей в покое форме она отрицательна.
    }
next-stability-map = Добавьте расчёт «stability_map», чтобы найти устойчивые частоты вращения и нужное демпфирование.
next-resonance = Разведите рабочую частоту вращения и резонанс на { $margin } или больше либо добавьте демпфирование.
next-balls = Добавьте расчёт «stationary»: при каких частотах вращения шарики уравновешивают ротор.
next-harm = Удерживайте шарики при разгоне или быстро проходите частоты вращения ниже диапазона устойчивости.
next-jump = Отстройте рабочую частоту вращения от скачка на { $margin } или больше, уменьшите дисбаланс или добавьте демпфирование.
next-run-up = Рассчитайте разгон: добавьте расчёт «run_up».
next-nonlinear = Добавьте расчёт «nonlinear_response»: в машине есть нелинейные элементы, скачки не исключены.
next-limits = Задайте в [limits]: { $keys }; без предела результаты не оцениваются.
next-studies = В файле нет расчётов: добавьте блоки [[study]], например { $kinds }; все виды показывает laval studies.
page-left-out = Что не учтено на этой странице
left-linear = Нелинейные элементы ({ $parts }) линеаризованы около положения равновесия; для больших колебаний и скачков нужен расчёт «nonlinear_response».
left-linear-modes = Для устойчивости и мод нелинейные элементы ({ $parts }) линеаризованы около положения равновесия.
left-spins = Отклик на дисбаланс других вращений ({ $spins }), чем вращение машины: нужен расчёт "forced_response" с полем spin.
left-motions = { $tilt ->
        [bends] Осевые и крутильные колебания.
        [yes] Осевые и крутильные колебания и изгиб тел.
       *[no] Осевые, крутильные и угловые колебания и изгиб тел.
    }
left-excitation = Возбуждение, кроме дисбаланса: несоосность, зубчатые передачи, колебания основания.
left-drive = Двигатель: частота вращения задана, поэтому не видно, хватает ли двигателя для прохождения резонанса.
left-steps = Неустойчивые диапазоны уже { $step }.
left-steps-near = Неустойчивые диапазоны уже { $step }, вблизи рабочей частоты вращения — уже { $near }.

# Headings of the page.
page-checks = Проверки
page-check = Проверка
page-result = Результат
page-required = Требование
page-verdict = Оценка
page-not-set = не задано
page-over-speed = Поведение по частоте вращения
page-modes = Моды при { $speed }
page-machine = Машина
page-next = Что делать дальше
page-findings = Все выводы
page-fill = заполнение { $fill }
page-balls = { $count ->
        [one] { $count } шарик
        [few] { $count } шарика
       *[other] { $count } шариков
    }
page-mode = Мода { $number }
page-whirl = { $whirl ->
        [forward] прямая
        [backward] обратная
        [mixed] смешанная
        [axial] осевая
        [torsional] крутильная
       *[none] без прецессии
    }
page-decrement = декремент { $decrement }
page-grows = растёт
page-not-resolved = медленный рост не разрешается
page-diverges = статическая неустойчивость (дивергенция)
axis-amplitude = амплитуда
axis-growth = инкремент
strip-unstable = неустойчиво
strip-not-examined = устойчивость не исследована
strip-response = неустойчивый отклик
strip-jump = скачок
axis-speed-plain = частота вращения
axis-operating = рабочая частота вращения
axis-operating-range = рабочие частоты вращения
strip-stable-limit = ниже устойчиво
caption-both = Амплитуда линейного отклика на дисбаланс и инкремент наименее устойчивой моды.
caption-amplitude = Амплитуда линейного отклика на дисбаланс.
caption-growth = Инкремент наименее устойчивой моды.
strip-resonance = резонанс

# The rest of the report.
page-evidence = подтверждающие данные
page-evidence-all = Подтверждающие данные расчётов
page-evidence-finding = вывод
page-evidence-value = значение
page-evidence-checked = чем проверено
page-evidence-number = результат
page-warning = Предупреждение
page-outside = Вне области применимости
page-stopped = Остановлено раньше времени
page-tables = Таблицы
page-points = Особые точки
page-work = Объём вычислений
page-input = Исходные данные
page-input-file = Исходный файл { $file }
page-provenance = Как выполнен расчёт
page-more = и ещё { $count } в results.json
page-more-studies = и ещё { $count } вместе с расчётами ниже
page-rows = { $count } { $count ->
        [one] строка
        [few] строки
       *[other] строк
    }
page-nothing = В расчётах нет выводов; см. рисунки и таблицы.
page-hint = Наведите указатель на кривую, чтобы прочитать значения. Перетащите, чтобы увеличить; двойной щелчок показывает всё; щелчок по имени скрывает кривую. Клавиши: стрелки, +, −, 0.
page-reset = Сбросить масштаб
page-yes = да
page-no = нет

balance-planes = { $rotor }: { $sizes }
item-balance = { $name } { $value } из { $share }
balance-detail = ISO 21940-11:2016, { $planes ->
        [two] 6.2 и 7.2, в плоскостях подшипников
       *[one] 6.2, только главный вектор: у ротора нет двух плоскостей подшипников
    }. Главный вектор { $resultant }{ $tilts ->
        [yes] , главный момент { $couple }
       *[no] {""}
    }; балансировка как жёсткого ротора
shaft-vibration-sizes = { $sizes }
item-shaft-vibration = { $name } { $value } размах{ $zone ->
        [none] {""}
       *[other] , зона { $zone }
    }
shaft-vibration-detail = { $standard ->
        [api_617] API 617
       *[iso_7919_3] ISO 7919-3:2009, приложение A, граница зон B и C
    }; предел при { $speed }. Только дисбаланс, относительно подшипников{ $nonlinear ->
        [yes] ; наибольший устойчивый отклик нелинейной машины
       *[no] {""}
    }
item-housing-vibration = { $name } { $value } (СКЗ){ $zone ->
        [none] {""}
       *[other] , зона { $zone }
    }
housing-vibration-detail = ISO 20816-3, { $standard ->
        [group_1_rigid] группа 1 на жёстких опорах
        [group_1_flexible] группа 1 на податливых опорах
        [group_2_rigid] группа 2 на жёстких опорах
       *[group_2_flexible] группа 2 на податливых опорах
    }, граница зон B и C; предел при { $speed }. Только дисбаланс, того, на чём стоят подшипники{ $nonlinear ->
        [yes] ; наибольший устойчивый отклик нелинейной машины
       *[no] {""}
    }
housing-vibration-none = ни один подшипник не стоит на подвижном теле
shaft-vibration-no-bearing = нет опоры между вращающимся и невращающимся
shaft-vibration-unknown = отклик относительно подшипников неизвестен
shaft-vibration-speed = стандарт не распространяется на эти рабочие частоты вращения
