# Roots of a machine with rational time forms against those of the exact machine. The roots are in the genitive.

moved-roots-growing = неустойчивых корней
moved-roots-beyond = корней с ростом или затуханием быстрее { $margin }
moved-roots = Рациональные формы во времени смещают положения { $roots } не больше чем на { $value }.
moved-roots-lost = У { $lost ->
        [1] одного
       *[other] { $lost }
    } из { $roots } нет соответствия в точной модели; остальные смещены не больше чем на { $value }. Рост в этом движении может быть вызван рациональными формами во времени; уменьшите time_error.
moved-roots-all-lost = Ни у одного из { $roots } нет соответствия в точной модели. Рост в этом движении может быть вызван рациональными формами во времени; уменьшите time_error.
moved-roots-none = У машины с рациональными формами во времени нет { $roots }; сравнивать с точной моделью было нечего.
