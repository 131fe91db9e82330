# What the studies in time share.

# The last moment of a record, within a sentence.
history-end = в конце расчёта
history-stop = в момент остановки интегрирования ({ $at })

# Displacements.
history-largest = { $quality ->
        [tilt] Наибольший наклон
       *[displacement] Наибольшее перемещение
    } тела «{ $body }» от положения равновесия: { $value }.
history-at-equilibrium = Тело «{ $body }» остаётся в положении равновесия с точностью интегрирования.
history-only-tilts = Тело «{ $body }» наклоняется, но его перемещение от положения равновесия равно нулю с точностью интегрирования.

# A motion that passes every bound.
history-unbounded = Движение тела «{ $body }» расходится при { $speed }: отклонение от положения равновесия { $displacement } в момент { $at }, когда интегрирование закончилось. Избегайте этой частоты вращения или добавьте демпфирование.
history-unbounded-exponential = Движение тела «{ $body }» расходится при { $speed } с инкрементом { $value }: отклонение от положения равновесия { $displacement } в момент { $at }, когда интегрирование закончилось. Избегайте этой частоты вращения или добавьте демпфирование.
history-unbounded-linear = Движение тела «{ $body }» расходится при { $speed }, линейно по времени со скоростью { $value }: отклонение от положения равновесия { $displacement } в момент { $at }, когда интегрирование закончилось. Избегайте этой частоты вращения или добавьте демпфирование.

# An integration that ended early.
history-work-limit = Предел числа шагов --work-limit достигнут в момент { $value }. Увеличьте его, чтобы рассчитать остальное.
history-step-too-small = Интегрирование остановилось в момент { $value }: ни один шаг не даёт заданной точности. Движение там может расходиться; попробуйте другой метод или большее relative_tolerance.
history-integration-failed = Интегрирование остановилось в момент { $value }: { $why }. Движение после этого момента отсутствует.

# Rational forms of parts in time.
history-reduced = Линейные части машины сведены к { $coordinates } координатам. До частоты { $frequency } их податливость в точках крепления других частей отличается от податливости всей машины на { $value }.
history-time-form = Во временной области элемент «{ $part }» заменён рациональной формой с { $states } { $states ->
        [one] состоянием
       *[other] состояниями
    }. Её относительная погрешность не больше { $value }, { $scope }.
history-time-fit = Во временной области частотная характеристика элемента «{ $part }» заменена рациональной аппроксимацией. Её относительная погрешность { $value }.

# Validity of parts along the motion.
history-valid = Элемент «{ $part }» в области применимости: { $what } ≤ { $value } (предел 1).
history-valid-after-start = Элемент «{ $part }» в области применимости { $above ->
        [standstill] с начала вращения ротора
       *[speed] выше { $speed }
    }: { $what } ≤ { $value } (предел 1).
history-valid-while-turning = Элемент «{ $part }» в области применимости{ $above ->
        [standstill] , пока ротор вращается
       *[speed] {" "}выше { $speed }
    }: { $what } ≤ 1.
history-valid-later = Элемент «{ $part }» вне области применимости до момента { $value }, когда частота вращения { $speed }: { $what } > 1. Не используйте движение до этого момента.
history-not-valid = Элемент «{ $part }» вышел из области применимости: { $what } = { $value } (предел 1). Движение недействительно начиная с момента { $first }.
history-not-valid-unbounded = Элемент «{ $part }» вышел из области применимости: { $what } = ∞ (предел 1). Движение недействительно начиная с момента { $first }.

# Contacts and gaps.
history-contacts = Законы сил с переключением сменили сторону { $count } { $count ->
        [one] раз
        [few] раза
       *[other] раз
    }; момент каждого переключения определён.

# Energy balance.
history-energy-closes = Баланс энергии сходится с точностью { $value } от переданной энергии.
history-energy-closes-to-rounding = Баланс энергии сходится с точностью округления, { $value } от накопленной или переданной энергии.
history-energy-missing = Баланс энергии не сходится: расхождение { $value } от переданной энергии. Уменьшите relative_tolerance.
history-energy-out-of-range = Баланса энергии нет: энергии выходят за пределы представимых чисел. Он не подтверждает это движение; проверьте, не расходится ли оно.
history-energy-unknown = Баланса энергии нет: элемент «{ $part }» не сообщает своей энергии.
