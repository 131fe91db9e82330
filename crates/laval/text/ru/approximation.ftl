# The machine beside its approximation with few waves.
approximation-modes = Аппроксимация — многочлен степени { $degree }. Из { $modes } { $modes ->
        [one] её моды
       *[other] её мод
    } на расстоянии до { $within } от корня полной модели { $met ->
        [one] лежит
       *[other] лежат
    } { $met }. Наибольшее расхождение { $value }, при { $speed }: частота { $frequency } вместо { $whole_frequency }, инкремент { $growth } вместо { $whole_growth }.
approximation-growth = Наибольший инкремент полной модели { $whole_growth } при { $whole_speed }, аппроксимации { $growth } при { $speed }. Разность { $value }.
