# Distributions.
uncertainty-distribution = «{ $quantity }» шамасының орташа мәні { $value }{ $spread ->
        [known] , стандартты ауытқуы { $deviation }
       *[none] {""}
    }.{ $quantiles ->
        [outer] {" "}Нұсқалардың { $lower } бөлігі { $low } мәнінен төмен, { $upper } бөлігі { $high } мәнінен төмен.
       *[none] {""}
    }{ $found ->
        [some] {" "}Ол { $samples } нұсқаның тек { $count } нұсқасында бар.
       *[all] {""}
    }
uncertainty-more = тағы { $count }
uncertainty-more-numbers = «{ $table }» кестесінде тағы { $count } шама бар.
uncertainty-no-numbers = Зерттеуде таралуын есептеуге болатын сандық нәтиже жоқ. Сандық нәтижесі бар зерттеуді таңдаңыз.
uncertainty-nothing-shown = Ешбір шаманың атауы «{ $show }» дегеннен басталмайды, сондықтан таралу салынбады. show мәнін мыналардан таңдаңыз: { $quantities }.

# Influence of the parameters.
uncertainty-most-influential = «{ $quantity }» шамасына ең көп әсер ететіні – { $parameter } параметрі: толық индексі { $value }, 95 % аралығы { $low } – { $high }.
uncertainty-most-influential-overlap = Бұл нұсқаларда «{ $quantity }» шамасына ең көп әсер ететіні – { $parameter } параметрі: толық индексі { $value }, 95 % аралығы { $low } – { $high }. Мыналардың аралықтарымен қабаттасады: { $rivals }; нұсқа санын арттыру ретін өзгертуі мүмкін.
uncertainty-unresolved-indices = Сезімталдық индекстері дәл анықталмады: { $quantities }. Бірінші ретті индекс толық индекстен { $value } шамасына дейін асады. Бұл – іріктеу қателігі. samples мәнін арттырыңыз.
uncertainty-no-indices = Сезімталдық индекстері жоқ: { $quantities }. Мәндері тұрақты немесе тым аз нұсқада табылды.
uncertainty-few-base-points = { $count } базалық нүкте сезімталдық индекстеріне тым аз: { $quantities }. Олардың 95 % аралықтары «indices» кестесінде. samples мәнін арттырыңыз.
uncertainty-largest-effect = «{ $quantity }» шамасы ең көп { $parameter } параметріне қарай өзгереді: орташа элементар эффект { $value }, 95 % аралығы { $low } – { $high }.
uncertainty-largest-effect-few = «{ $quantity }» шамасы ең көп { $parameter } параметріне қарай өзгереді: орташа элементар эффект { $value }. Оның аралығын анықтауға нұсқалар тым аз; samples мәнін арттырыңыз.

# Samples without a valid result.
uncertainty-failed-samples = { $samples } нұсқаның { $count } нұсқасында нәтиже жоқ{ $count ->
        [1] {""}
       *[other] , мысалы { $first }-нұсқада
    }: { $reason }. Статистика бұл нұсқаларды қамтымайды.
uncertainty-outside-validity = { $samples } нұсқаның { $count } нұсқасында бір нәтиже модельдің жарамдылық шегінен тыс; статистика оны қамтиды.
