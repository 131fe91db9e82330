# Stability over a cross-coupled stiffness.
stability-threshold-threshold = { $damped ->
        [no] Любая перекрёстная жёсткость в точке { $place } делает машину неустойчивой при { $speed }: мода { $mode }, { $whirl } на частоте { $frequency }, не демпфирована.
       *[yes] Перекрёстная жёсткость { $value } в точке { $place } делает машину неустойчивой при { $speed }: мода { $mode }, { $whirl } на частоте { $frequency }.
    }
stability-threshold-none = При { $speed } машина остаётся устойчивой до перекрёстной жёсткости { $value } в точке { $place }.
stability-threshold-unknown = При { $speed } порог не найден до перекрёстной жёсткости { $value } в точке { $place }; устойчивость до неё не доказана.
stability-threshold-base = Без перекрёстной жёсткости наименьший логарифмический декремент прослеженных мод при { $speed } равен { $value }: мода { $mode }, { $whirl } на частоте { $frequency }.
stability-threshold-unstable-without = При { $speed } машина неустойчива и без перекрёстной жёсткости: мода { $mode }, { $whirl } на частоте { $frequency }, логарифмический декремент { $value }.
stability-threshold-level-1 = Уровень 1 выполнен (API 684, SP6.8.5.10): логарифмический декремент первой прямой моды, моды { $mode }, { $value } при ожидаемой жёсткости { $anticipated }, требуется не менее { $least_decrement }; отношение порога к ожидаемой жёсткости { $reached ->
        [yes] { $ratio }
       *[no] больше { $ratio }
    }, требуется не менее { $least_ratio }.{ $density ->
        [yes] {" "}При отношении ниже 10 учитывается и критерий плотности газа и отношения частот; он не проверен.
        [region] {" "}{ $region } Все три критерия выполнены.
       *[no] {""}
    }
stability-threshold-level-2 = Требуется анализ уровня 2 (API 684, SP6.8.5.10): логарифмический декремент первой прямой моды, моды { $mode }, { $value } при ожидаемой жёсткости { $anticipated }, требуется не менее { $least_decrement }; отношение порога к ожидаемой жёсткости { $reached ->
        [yes] { $ratio }
       *[no] больше { $ratio }
    }, требуется не менее { $least_ratio }.{ $density ->
        [region] {" "}{ $region }
       *[other] {""}
    }
stability-threshold-level-open = Уровень 1 не решён (API 684, SP6.8.5.10): логарифмический декремент первой прямой моды, моды { $mode }, { $value } при ожидаемой жёсткости { $anticipated }; { $reached ->
        [yes] отношение порога к ней { $ratio }.
        [uncounted] растущие моды до отношения { $ratio } не удалось сосчитать на всех частотах. Могут быть и другие неустойчивые.
       *[no] порог не найден до отношения { $ratio }. Увеличьте up_to.
    }{ $density ->
        [region] {" "}{ $region }
       *[other] {""}
    }
stability-threshold-region = { $region ->
        [a] Область A по API 617: отношение частоты вращения к критической { $critical_ratio } при плотности газа { $gas_density }, допускается не более { $speed_ratio_limit }. Жёсткие опоры: { $parts }.
        [b] Область B по API 617 требует уровня 2 при отношении порога к ожидаемой жёсткости ниже 10: отношение частоты вращения к критической { $critical_ratio } при плотности газа { $gas_density }, больше { $speed_ratio_limit }. Жёсткие опоры: { $parts }.
       *[dense] Область B по API 617 требует уровня 2 при отношении порога к ожидаемой жёсткости ниже 10: плотность газа { $gas_density } больше { $largest_density }, при любом отношении частоты вращения к критической.
    }
stability-threshold-region-open = Критерий плотности газа и отношения частоты вращения к критической (API 617) не проверен: { $reason ->
        [rest] положение равновесия машины не найдено.
        [supports] часть, на которую опирается ротор, не найдена. Назовите опоры в supports.
        [part] одна из частей, кроме опор, не задана матрицами масс, гироскопической и жёсткости. Если эта часть служит опорой ротора, назовите её в supports.
        [missing] критическая частота вращения на жёстких опорах не найдена.
        [uncertain] критическая частота вращения на жёстких опорах не сошлась.
       *[number] отношение частоты вращения к критической неизвестно.
    }
stability-threshold-counted = { $range ->
        [below] До частоты { $limit }
       *[all] По всему спектру
    } число растущих мод при { $stiffness }: { $growing }, столько же среди прослеженных { $followed } из { $modes } поперечных мод.
stability-threshold-missed = Число растущих при { $stiffness } мод, не прослеженных до начала неустойчивости: { $missed }. Увеличьте points.
stability-threshold-not-counted = Растущие моды при { $stiffness } не удалось сосчитать: могут быть и другие неустойчивые.
stability-threshold-meeting = Две моды сходятся в кратном корне при { $value }. За ним их номера условны.
stability-threshold-lost = Число мод, не прослеженных до наибольшей жёсткости: { $modes }. Увеличьте points.

stability-threshold-curve = мода { $mode }, { $whirl } на частоте { $frequency }
stability-threshold-alt = Логарифмический декремент в зависимости от перекрёстной жёсткости, мод: { $modes }, порогов: { $thresholds }.
