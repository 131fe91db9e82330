# Distributions.
uncertainty-distribution = Величина «{ $quantity }»: среднее { $value }{ $spread ->
        [known] , стандартное отклонение { $deviation }
       *[none] {""}
    }.{ $quantiles ->
        [outer] {" "}{ $lower } реализаций лежат ниже { $low }, { $upper } ниже { $high }.
       *[none] {""}
    }{ $found ->
        [some] {" "}Она существует только в { $count } из { $samples } { $samples ->
            [one] реализации
           *[other] реализаций
        }.
       *[all] {""}
    }
uncertainty-more = ещё { $count }
uncertainty-more-numbers = В таблице «{ $table }» ещё { $count } { $count ->
        [one] величина
        [few] величины
       *[other] величин
    }.
uncertainty-no-numbers = Расчёт не даёт числового результата, для которого можно построить распределение. Выберите расчёт с таким результатом.
uncertainty-nothing-shown = Ни одна величина не начинается с «{ $show }», поэтому распределение не построено. Выберите show из: { $quantities }.

# Influence of the parameters.
uncertainty-most-influential = Величина «{ $quantity }» сильнее всего зависит от { $parameter }: полный индекс { $value }, интервал 95 % от { $low } до { $high }.
uncertainty-most-influential-overlap = В этих реализациях величина «{ $quantity }» сильнее всего зависит от { $parameter }: полный индекс { $value }, интервал 95 % от { $low } до { $high }. Интервалы перекрываются с { $rivals }; с большим числом реализаций порядок может измениться.
uncertainty-unresolved-indices = Индексы чувствительности для { $quantities } не разрешены: индекс первого порядка превышает полный индекс до { $value }. Это погрешность выборки. Увеличьте samples.
uncertainty-no-indices = Индексов чувствительности для { $quantities } нет: значения постоянны или найдены в слишком малом числе реализаций.
uncertainty-few-base-points = { $count ->
        [one] { $count } базовой точки
       *[other] { $count } базовых точек
    } слишком мало для индексов чувствительности { $quantities }. Их интервалы 95 % приведены в таблице «indices». Увеличьте samples.
uncertainty-largest-effect = Величина «{ $quantity }» сильнее всего меняется с { $parameter }: средний элементарный эффект { $value }, интервал 95 % от { $low } до { $high }.
uncertainty-largest-effect-few = Величина «{ $quantity }» сильнее всего меняется с { $parameter }: средний элементарный эффект { $value }. Для его интервала реализаций слишком мало; увеличьте samples.

# Samples without a valid result.
uncertainty-failed-samples = Нет результата в { $count } из { $samples } { $samples ->
        [one] реализации
       *[other] реализаций
    }{ $count ->
        [1] {""}
       *[other] , например в реализации { $first }
    }: { $reason }. Статистика их не учитывает.
uncertainty-outside-validity = В { $count } из { $samples } { $samples ->
        [one] реализации
       *[other] реализаций
    } результат вне области применимости модели; статистика его учитывает.
