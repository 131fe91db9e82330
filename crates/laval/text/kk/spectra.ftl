# Spectra along a motion.

# Components of the motion of a body.
spectra-superharmonic = «{ $body }» денесінің { $whirl ->
        [forward] тура
       *[backward] кері
    } ультрагармоникасы, реті { $order }
spectra-spin-frequency = «{ $body }» денесінің айналу жиілігіндегі { $whirl ->
        [forward] тура
       *[backward] кері
    } құраушысы
spectra-subharmonic = «{ $body }» денесінің { $whirl ->
        [forward] тура
       *[backward] кері
    } субгармоникасы, реті { $p }/{ $q }
spectra-fraction = «{ $body }» денесінің { $whirl ->
        [forward] тура
       *[backward] кері
    } құраушысы, реті { $p }/{ $q }
spectra-asynchronous = «{ $body }» денесінің { $whirl ->
        [forward] тура
       *[backward] кері
    } асинхронды құраушысы, айналу жиілігінен { $order } есе

spectra-component = { $component }: { $value } – { $to } аралығында { $limit } мәнінен жоғары, ең үлкені { $largest }, { $at } кезінде.{ $course ->
        [intermittent] {" "}Ол { $between } терезенің { $count } терезесінде шектік мәннен асады.
       *[throughout] {""}
    }
spectra-component-at-speed = { $component }: { $value } кезінде { $limit } мәнінен жоғары, ең үлкені { $largest }.{ $course ->
        [intermittent] {" "}Ол { $between } терезенің { $count } терезесінде шектік мәннен асады.
       *[throughout] {""}
    }
spectra-more-components = «{ $body }» денесінің тағы { $count } құраушысы { $limit } мәнінен асады.
spectra-fleeting = «{ $body }» денесінің құраушылары { $limit } мәнінен тек жеке терезелерде асады, өшетін еркін тербелістегідей: ең үлкені { $value }, { $speed } кезінде.
spectra-no-components = «{ $body }» денесінің синхронды құраушыдан басқа ешбір құраушысы { $limit } мәнінен аспайды.{ $short ->
        [0] {""}
       *[other] {" "}Төрт айналымнан қысқа { $short } терезе есепке алынбады.
    }
spectra-no-lasting-components = «{ $body }» денесінің синхронды құраушыдан басқа ешбір тұрақты құраушысы { $limit } мәнінен аспайды.{ $short ->
        [0] {""}
       *[other] {" "}Төрт айналымнан қысқа { $short } терезе есепке алынбады.
    }
spectra-no-motion = «{ $body }» денесі тербелмейді: спектрлері нөлге тең.
spectra-no-orders = Рет спектрлері жоқ: каскадты спектрдің терезелері ротордың төрт айналымынан қысқа. Аздау спектр сұраңыз.
spectra-none = Спектр жоқ: қозғалыс каскадты спектрдің бірінші терезесіне дейін аяқталды.
