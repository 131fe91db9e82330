# Phrases that parts and solvers supply in English. The name is made of the letters and digits of the English text.

# Validity of parts: what is limited, over its limit.
term-distance-of-the-speed-from-the-middle-of-the-bearing-table-over-half-its-range = отношение отклонения частоты вращения от середины таблицы опоры к половине её диапазона
term-distance-of-the-speed-from-the-middle-of-the-torque-table-over-half-its-range = отношение отклонения частоты вращения от середины таблицы момента к половине её диапазона
term-tilt-over-0-1-rad = отношение наклона к 0,1 рад
term-bearing-deflection-over-the-range-of-its-law = отношение деформации опоры к диапазону её закона
term-surface-excursion-over-layer-thickness = отношение отклонения поверхности к толщине слоя
term-surface-excursion-over-layer-thickness-at-the-spin-frequency = отношение отклонения поверхности к толщине слоя на частоте вращения
term-change-of-the-speed-within-a-turn-over-a-tenth-of-it = отношение изменения частоты вращения за оборот к её десятой доле
term-distance-of-the-speed-from-that-of-its-form-in-time-over-a-billionth-of-it = отношение отличия частоты вращения от частоты формы во времени к её миллиардной доле
term-wall-acceleration-over-centrifugal-acceleration-of-the-layer = отношение ускорения стенки к центробежному ускорению слоя
term-overlap-of-balls-in-contact-over-a-tenth-of-their-size = отношение перекрытия соприкасающихся шариков к десятой доле их размера
term-size-of-a-ball-over-the-distance-to-the-next = отношение размера шарика к расстоянию до соседнего

# Parts, waves and losses: in the genitive.
term-a-part = элемента
term-an-ideal-liquid = идеальной жидкости
term-a-viscous-liquid = вязкой жидкости
term-waves = волн
term-inertial-waves = инерционных волн
term-damping-in-the-parts = демпфирования в элементах
term-viscosity-in-the-liquid = вязкости жидкости

# Liquids: what gives a response, what is computed, what damps.
term-damping-in-the-part-gives-it-an-answer = Отклик элементу даёт демпфирование в нём
term-a-viscosity-model-strip-or-as-an-approximation-axial-harmonics-gives-the-liquid-a-response-at-every-order = Отклик жидкости на каждом порядке даёт вязкость, model = "strip" или, приближённо, axial_harmonics
term-what-is-computed-there-are-the-few-waves-kept = там рассчитаны немногие учтённые волны
term-what-is-computed-there-are-the-waves-of-the-axial-harmonics-kept-and-every-further-harmonic-puts-others-beside-them-a-viscosity-decides = там рассчитаны волны учтённых осевых гармоник, и каждая следующая гармоника добавляет рядом с ними другие; решает вязкость
term-without-damping-outside-the-liquid-that-is-every-speed-above-the-critical-speed-of-the-filled-rotor-damping-leaves-a-finite-range-which-little-viscosity-makes-wide = Без демпфирования вне жидкости это любая частота вращения выше критической частоты заполненного ротора; с демпфированием остаётся конечный диапазон, широкий при малой вязкости.
term-of-the-liquid-s-wave-wave-damping = волны жидкости: wave_damping
term-of-tilts-that-grow-or-decay-by-a-twentieth-of-the-speed-or-more-up-to-four-times-the-speed-in-rotor-axes = для наклонов, которые растут или затухают не медленнее двадцатой доли частоты вращения, до четырёхкратной частоты вращения в осях ротора
term-of-motions-that-do-not-decay-up-to-four-times-the-speed-in-rotor-axes = для незатухающих движений, до четырёхкратной частоты вращения в осях ротора
term-the-layer-of-a-viscous-liquid-at-the-wall-remembers-its-whole-past = слой вязкой жидкости у стенки помнит всё своё прошлое
term-a-liquid-that-flows-along-the-axis-has-infinitely-many-waves = жидкость, текущая вдоль оси, имеет бесконечно много волн

# Separation: what bounds the model, and what it means beyond.
term-reynolds = число Рейнольдса
term-inertia = инерция
term-dilute = объёмная доля частиц
term-brownian = броуновское движение
term-gravity = сила тяжести
term-surface = поверхность
term-mouth = горловина
term-wall-share = доля на стенке
term-spin-up = раскрутка жидкости
term-stokes-law-overstates-the-velocity-above-1-use-drag-schiller-naumann = закон Стокса завышает скорость; выше 1 задайте drag = "schiller_naumann"
term-the-drag-law-ends-at-the-drag-crisis = закон сопротивления заканчивается на кризисе сопротивления
term-inertia-and-coriolis-forces-are-felt-below-10-drag-laws-of-still-liquid-are-doubtful = заметны инерция и силы Кориолиса; ниже 10 законы сопротивления для покоящейся жидкости сомнительны
term-particles-hinder-each-other-more-than-the-model-says = частицы мешают друг другу сильнее, чем предполагает модель
term-diffusion-works-against-settling-trajectories-alone-mislead = диффузия противодействует осаждению: одни траектории вводят в заблуждение
term-tilt-and-settling-depend-strongly-on-gravity = наклон и осаждение сильно зависят от силы тяжести
term-the-free-surface-is-curved-which-the-model-of-a-swinging-cup-leaves-out = свободная поверхность искривлена, модель откидного стакана этого не учитывает
term-the-field-at-the-innermost-liquid-over-gravity-is-not-large-the-model-of-machines-that-liquid-flows-through-leaves-gravity-out = ускорение у самого внутреннего слоя жидкости не велико по сравнению с силой тяжести; модель проточных машин её не учитывает
term-the-liquid-reaches-the-mouth-without-a-cap-it-spills = жидкость доходит до горловины: без крышки она выливается
term-most-particles-meet-the-side-wall-where-they-slide-on-in-reality-which-clears-the-liquid-sooner = большинство частиц попадает на боковую стенку; в действительности они скользят по ней дальше, и жидкость очищается раньше
term-the-liquid-lags-behind-the-cup-while-the-speed-changes = при изменении частоты вращения жидкость отстаёт от стакана
term-no-path-in-space = нет пространственной траектории
term-no-place-of-the-liquid-is-found-where-a-path-begins = в жидкости не найдено места, где начинается траектория

# Rows of a study: in the nominative. Motions of a study: in the genitive.
term-rows = строки
term-motions = движения
term-free-whirls = свободных движений
term-cycles = предельных циклов
term-motions-on-the-loci = движений на кривых

# Why a motion failed, behind its noun.
term-grows-without-bound = растёт неограниченно
term-leaves-the-range-of-numbers = выходит за пределы представимых чисел
term-needs-steps-below-the-resolution-of-time = требует шагов меньше разрешения по времени
term-needs-too-many-steps = требует слишком много шагов
term-cannot-start = не может начаться
term-changes-side-too-often = слишком часто меняет сторону переключения
term-shooting-was-lost = не рассчитано: потеряны данные метода стрельбы

# Ends of motions with balls.
term-balanced = уравновешено
term-partly-balanced = частично уравновешено
term-unbalance-reduced = дисбаланс уменьшен
term-masses-touching = шарики соприкасаются
term-masses-together = шарики совпадают
term-masses-opposed = шарики диаметрально противоположны
term-masses-apart = шарики разведены
term-single-state = синхронное состояние
term-balanced-unstable = уравновешено, неустойчиво
term-partly-balanced-unstable = частично уравновешено, неустойчиво
term-unbalance-reduced-unstable = дисбаланс уменьшен, неустойчиво
term-masses-touching-unstable = шарики соприкасаются, неустойчиво
term-masses-together-unstable = шарики совпадают, неустойчиво
term-masses-opposed-unstable = шарики диаметрально противоположны, неустойчиво
term-masses-apart-unstable = шарики разведены, неустойчиво
term-single-state-unstable = синхронное состояние, неустойчиво
term-masses-go-round = шарики обращаются
term-some-masses-go-round = часть шариков обращается
term-masses-swing = шарики качаются
term-at-rest = покой
term-moves-on = движение продолжается
term-not-settled = не установилось
term-failed = не рассчитано
term-at-rest-balanced = покой, уравновешено
term-at-rest-partly-balanced = покой, частично уравновешено
term-at-rest-unbalance-reduced = покой, дисбаланс уменьшен
term-at-rest-masses-touching = покой, шарики соприкасаются
term-at-rest-masses-together = покой, шарики совпадают
term-at-rest-masses-opposed = покой, шарики диаметрально противоположны
term-at-rest-masses-apart = покой, шарики разведены
term-at-rest-single-state = покой, синхронное состояние

# Families of states.
term-from-low-speed = со стороны низких частот вращения
term-from-high-speed = со стороны высоких частот вращения
term-x-and-y-on-different-states = x и y в разных состояниях
term-of-less-symmetry = с пониженной симметрией
term-of-doubled-period = с удвоенным периодом
term-repeating-every-2-turns = с повторением через 2 оборота
term-repeating-every-3-turns = с повторением через 3 оборота
term-of-longer-period = с более длинным периодом
term-apart-from-the-others = отдельно от других

# Why something was not followed, assessed or computed.
term-the-family-of-another-onset-ends-here = здесь заканчивается семейство другой точки возбуждения
term-the-machine-is-pushed-aside-without-whirling = машина отклоняется без прецессии
term-its-cycles-lie-outside-the-range-of-speeds = его циклы лежат вне диапазона частот вращения
term-it-does-not-deflect-the-nonlinear-parts-and-its-growth-has-no-bound = нелинейные элементы не деформируются, и рост не ограничен
term-no-small-cycle-was-found-near-it = малый цикл вблизи не найден
term-its-start-did-not-converge = начальное приближение не дало сходимости
term-no-further-point-was-found-as-where-it-meets-another-locus = следующая точка не найдена, как при встрече с другой кривой
term-the-locus-leaves-the-range-of-speeds = кривая выходит из диапазона частот вращения
term-the-bordered-jacobian-is-singular-neither-a-simple-fold-nor-a-simple-branch-point = окаймлённый якобиан вырожден: это не простая складка и не простая точка ветвления
term-the-jacobian-has-no-single-null-vector = якобиан не имеет единственного нулевого вектора
term-a-monitored-quantity-is-not-finite = контролируемая величина не конечна
term-the-linear-parts-have-no-response-at-this-speed = линейные элементы не имеют отклика при этой частоте вращения
term-the-machine-does-not-exist-at-this-value-of-the-parameter = при этом значении параметра машины не существует
term-the-nonlinear-coordinates-change-with-the-parameter = нелинейные координаты меняются с параметром
term-the-stability-of-the-motion-cannot-be-assessed-there = устойчивость движения там оценить нельзя
term-the-motion-has-no-exponents = у движения нет показателей
term-the-maps-over-the-period-took-more-steps-than-a-response-is-given = отображение за период требует больше шагов, чем отведено отклику
term-a-force-changes-too-abruptly-for-the-map-over-the-period-to-be-integrated = сила меняется слишком резко для интегрирования отображения за период
term-the-map-over-the-period-ended-early = расчёт отображения за период прерван
term-hill-s-method-is-for-machines-whose-nonlinear-parts-have-neither-mass-nor-states = метод Хилла предназначен для машин, нелинейные элементы которых не имеют ни массы, ни внутренних состояний
term-hill-s-method-is-for-motions-along-which-no-law-switches = метод Хилла предназначен для движений, в ходе которых законы сил не переключаются
term-hill-s-determinant-is-for-machines-whose-nonlinear-parts-have-neither-mass-nor-states = определитель Хилла предназначен для машин, нелинейные элементы которых не имеют ни массы, ни внутренних состояний
term-hill-s-determinant-is-for-motions-along-which-no-law-switches = определитель Хилла предназначен для движений, в ходе которых законы сил не переключаются
term-it-is-written-for-a-law-that-acts-on-x-and-y-apart-and-alike-symmetric-by-a-quarter-turn-not-by-any = он выведен для закона, действующего по x и y раздельно и одинаково (симметрия при повороте на четверть оборота, а не на любой угол)
term-it-is-written-for-one-deflection-with-a-force-that-depends-on-nothing-else = он выведен для одной деформации и силы, которая зависит только от неё
term-the-nonlinear-force-is-not-c0-d-c1-d-3-in-x-and-y-apart = нелинейная сила не имеет вида c0 d + c1 d^3 по x и y раздельно
term-the-law-does-not-harden-its-free-oscillation-is-no-elliptic-cosine = характеристика не жёсткая: свободные колебания — не эллиптический косинус
term-the-deflection-feels-no-mass = деформация не связана с массой
term-the-machine-drifts = машина дрейфует
term-no-step-of-the-integration-however-short-met-its-tolerance = ни один, даже самый короткий, шаг интегрирования не дал заданной точности
term-the-integration-was-stopped = интегрирование остановлено

# Dimensions in words, as diagnostics name them: in the nominative.
term-a-pure-number = безразмерное число
term-a-speed = частота вращения
term-a-length = длина
term-a-mass = масса
term-a-time = время
term-an-angle = угол
term-a-force = сила
term-a-stiffness = жёсткость
term-a-damping-constant = коэффициент демпфирования
term-a-cubic-stiffness = кубическая жёсткость
term-a-hertz-contact-stiffness = контактная жёсткость по Герцу
term-a-pressure = давление
term-a-rotational-stiffness = угловая жёсткость
term-a-rotational-damping-constant = коэффициент углового демпфирования
term-a-torque = момент силы
term-an-energy = энергия
term-a-power = мощность
term-an-unbalance = дисбаланс
term-a-moment-of-inertia = момент инерции
term-an-area = площадь
term-a-volume = объём
term-a-second-moment-of-area = момент инерции сечения
term-a-density = плотность
term-a-mass-per-length = масса на единицу длины
term-a-velocity = скорость
term-an-acceleration = ускорение
term-an-angular-acceleration = угловое ускорение
term-a-rate = скорость изменения
term-a-rate-squared = квадрат скорости изменения
term-a-number-per-length = величина на единицу длины
term-a-number-per-area = величина на единицу площади
term-a-dynamic-viscosity = динамическая вязкость
term-a-kinematic-viscosity = кинематическая вязкость
term-a-volume-flow = объёмный расход
term-a-temperature = температура
term-a-coefficient-per-kelvin = температурный коэффициент
term-a-heat-conductance = тепловая проводимость
term-a-heat-capacity = теплоёмкость
term-a-current = сила тока
term-a-voltage = электрическое напряжение
term-a-resistance = электрическое сопротивление
term-an-inductance = индуктивность
term-a-force-per-current = сила на единицу тока
term-a-torque-per-current = момент силы на единицу тока
term-a-voltage-constant = коэффициент ЭДС
term-an-impulse = импульс силы
term-a-stiffness-density-gradient = градиент плотности жёсткости
term-a-torque-over-the-square-of-a-speed = отношение момента силы к квадрату частоты вращения
term-an-angular-momentum = момент импульса
term-an-angle-per-length = угол на единицу длины

# Symmetries of a machine, as diagnostics name them: in the nominative.
term-half-turn = поворот на пол-оборота
term-quarter-turn = поворот на четверть оборота
term-any-turn = любой поворот
