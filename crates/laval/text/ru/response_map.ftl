# The nonlinear response over two parameters.

response-map-place = { $first } = { $x }, { $second } = { $y }
response-map-failed = У { $count } из { $machines } { $machines ->
        [one] машины
       *[other] машин
    } нет отклика, например с { $at }: { $why }.
response-map-branches-left = У { $count } из { $machines } { $machines ->
        [one] машины
       *[other] машин
    } одна из ветвей обрывается, см. столбец end карты. Пики и скачки дальше могут быть пропущены.
response-map-peaks-not-reached = У { $count } из { $machines } { $machines ->
        [one] машины
       *[other] машин
    } на карте нет пика: перемещение или наклон ещё растёт там, где ветвь обрывается.

# Jumps and hysteresis.
response-map-jumping = { $jumping ->
        [none] { $known ->
            [1] У единственной машины нет скачков
           *[other] Ни у одной из машин ({ $known }) нет скачков
        } в этом диапазоне частот вращения.
        [all] { $known ->
            [1] У единственной машины есть скачок
           *[other] У всех машин ({ $known }) есть скачок
        } в этом диапазоне частот вращения{ $down ->
            [0] {""}
           *[other] , из них у { $down } только при выбеге
        }.
       *[some] У { $count } из { $known } { $known ->
            [one] машины
           *[other] машин
        } есть скачок в этом диапазоне частот вращения{ $down ->
            [0] {""}
           *[other] , из них у { $down } только при выбеге
        }.
    }
response-map-widest-hysteresis = Самый широкий гистерезис { $value }, с { $at }.{ $open ->
        [yes] {" "}Он продолжается за диапазоном частот вращения.
       *[no] {""}
    }

# Peaks.
response-map-largest-peak = Наибольший пик { $value } при { $speed }, с { $at }.{ $end ->
        [yes] {" "}Он лежит на конце диапазона частот вращения и дальше может расти.
       *[no] {""}
    }
response-map-smallest-peak = Наименьший пик { $value } при { $speed }, с { $at }.{ $end ->
        [yes] {" "}Он лежит на конце диапазона частот вращения и дальше может расти.
       *[no] {""}
    }
response-map-largest-tilt = Наибольший наклон { $value } при { $speed }, с { $at }.

# Stability and validity.
response-map-stability-not-requested = Устойчивость не рассчитана, показанные состояния могут быть неустойчивы. Задайте stability = true.
response-map-stability-unknown = У { $count } из { $machines } { $machines ->
        [one] машины
       *[other] машин
    } устойчивость некоторых состояний неизвестна: { $why }. Показанные состояния могут быть неустойчивы.
response-map-unstable = У { $count } из { $machines } { $machines ->
        [one] машины
       *[other] машин
    } есть неустойчивые состояния, лежащие не между двумя складками. Наибольший инкремент { $value }, с { $at }.
response-map-neimark-sacker = У { $count } из { $machines } { $machines ->
        [one] машины
       *[other] машин
    } есть бифуркация Неймарка–Сакера: отклик становится двухчастотным движением.
response-map-symmetry-breaking = У { $count } из { $machines } { $machines ->
        [one] машины
       *[other] машин
    } есть бифуркация потери симметрии отклика.
response-map-period-doubling = У { $count } из { $machines } { $machines ->
        [one] машины
       *[other] машин
    } есть удвоение периода отклика.
response-map-outside-validity = Недействительно: { $what }. У { $count } из { $machines } { $machines ->
        [one] машины
       *[other] машин
    } отношение к пределу в некоторых состояниях достигает { $value }.
response-map-outside-validity-unbounded = Недействительно: { $what }. У { $count } из { $machines } { $machines ->
        [one] машины
       *[other] машин
    } эта величина в некоторых состояниях не ограничена.
