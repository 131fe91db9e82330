# Spectra along a motion.

# Components of the motion of a body; they begin a sentence.
spectra-superharmonic = { $whirl ->
        [forward] Прямая
       *[backward] Обратная
    } супергармоника порядка { $order } тела «{ $body }»
spectra-spin-frequency = { $whirl ->
        [forward] Прямая
       *[backward] Обратная
    } составляющая тела «{ $body }» с частотой вращения
spectra-subharmonic = { $whirl ->
        [forward] Прямая
       *[backward] Обратная
    } субгармоника порядка { $p }/{ $q } тела «{ $body }»
spectra-fraction = { $whirl ->
        [forward] Прямая
       *[backward] Обратная
    } составляющая порядка { $p }/{ $q } тела «{ $body }»
spectra-asynchronous = { $whirl ->
        [forward] Прямая
       *[backward] Обратная
    } асинхронная составляющая тела «{ $body }», отношение к частоте вращения { $order }

spectra-component = { $component }: больше { $limit } от { $value } до { $to }, наибольшая { $largest } при { $at }.{ $course ->
        [intermittent] {" "}Порог превышен в { $count } из { $between } { $between ->
            [one] окна
           *[other] окон
        }.
       *[throughout] {""}
    }
spectra-component-at-speed = { $component }: больше { $limit } при { $value }, наибольшая { $largest }.{ $course ->
        [intermittent] {" "}Порог превышен в { $count } из { $between } { $between ->
            [one] окна
           *[other] окон
        }.
       *[throughout] {""}
    }
spectra-more-components = Ещё { $count } { $count ->
        [one] составляющая тела «{ $body }» превышает
        [few] составляющие тела «{ $body }» превышают
       *[other] составляющих тела «{ $body }» превышают
    } { $limit }.
spectra-fleeting = Составляющие тела «{ $body }» превышают { $limit } только в отдельных окнах, как затухающие свободные колебания: до { $value } при { $speed }.
spectra-no-components = Ни одна составляющая тела «{ $body }», кроме синхронной, не превышает { $limit }.{ $short ->
        [0] {""}
        [one] {" "}Пропущено { $short } окно короче четырёх оборотов.
        [few] {" "}Пропущены { $short } окна короче четырёх оборотов.
       *[other] {" "}Пропущено { $short } окон короче четырёх оборотов.
    }
spectra-no-lasting-components = Ни одна длительная составляющая тела «{ $body }», кроме синхронной, не превышает { $limit }.{ $short ->
        [0] {""}
        [one] {" "}Пропущено { $short } окно короче четырёх оборотов.
        [few] {" "}Пропущены { $short } окна короче четырёх оборотов.
       *[other] {" "}Пропущено { $short } окон короче четырёх оборотов.
    }
spectra-no-motion = Тело «{ $body }» не колеблется: его спектры равны нулю.
spectra-no-orders = Порядковых спектров нет: окна каскадной диаграммы короче четырёх оборотов ротора. Запросите меньше спектров.
spectra-none = Спектров нет: движение закончилось раньше первого окна каскадной диаграммы.
