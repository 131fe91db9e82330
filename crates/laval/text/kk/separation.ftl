# Parts of sentences.
separation-recovery = бөлшектердің { $share } бөлігін
separation-recovery-from = диаметрі { $diameter } және одан ірі бөлшектердің { $share } бөлігін
separation-particles = бөлшектердің
separation-particles-from = диаметрі { $diameter } және одан ірі бөлшектердің
separation-in-time = { $time } ішінде
separation-at-throughput = { $throughput } өнімділікте
separation-without-spin = айналусыз
separation-at-speed = { $speed } кезінде
separation-no-run-up = {""}
separation-run-up-included = , оның ішінде екпіндеу { $duration }
separation-run-up-estimated = , оның ішінде екпіндеу { $duration }, ол орташа радиустағы өріс бойынша бағаланған
separation-vessel = { $kind ->
        [swinging] Бұрылмалы стакан
        [fixed_angle] Бекітілген бұрышты пробирка
        [tubular_bowl] Түтікті барабан
        [disc_stack] Табақшалар пакеті
       *[decanter] Декантер
    }

# What is caught.
separation-caught = { $vessel }: { $particles } { $value } бөлігі ұсталады, { $at_hand }, { $spin }{ $run_up }.
separation-all-sampled-caught = { $vessel }: барлық есептелген бөлшек ұсталады, бұл { $particles } { $value } бөлігіне жуық, { $at_hand }, { $spin }{ $run_up }. Соңғыларына { $last } қажет болар еді.
separation-all-sampled-caught-some-never = { $vessel }: барлық есептелген бөлшек ұсталады, бұл { $particles } { $value } бөлігіне жуық, { $at_hand }, { $spin }{ $run_up }. Кейбірі ешқашан ұсталмайды.
separation-never-caught = Талап орындалмайды: { $recovery } { $spin } ұстау мүмкін емес, кейбір бөлшектер сұйықтықта қалады. recovery мәнін азайтыңыз немесе diameter мәнін арттырыңыз.
separation-time-needed = Қажетті уақыт { $value }: { $recovery } ұстау үшін, { $spin }{ $run_up }.
separation-residence-needed = Қажетті болу уақыты { $value }: { $recovery } ұстау үшін, { $spin }, өнімділік ең көбі { $throughput }.
separation-no-spin-needed = Айналу қажет емес: { $recovery } { $at_hand } ауырлық күшінің өзі ұстайды.
separation-speed-needed = Қажетті айналу жиілігі кемінде { $value }: { $recovery } { $at_hand } ұстау үшін{ $run_up ->
        [none] {""}
        [same] , екпіндеу үдеуі өзгермегенде
       *[programme] , бағдарламадағы барлық айналу жиілігі пропорционал өзгергенде
    }.
separation-no-speed-suffices = { $highest } мәніне дейін есептелген ешбір айналу жиілігі жеткіліксіз: { $recovery } { $at_hand } ұстау мүмкін емес{ $run_up ->
        [none] {""}
        [same] , екпіндеу үдеуі өзгермегенде
       *[programme] , бағдарламадағы барлық айналу жиілігі пропорционал өзгергенде
    }. { $flow ->
        [yes] throughput немесе recovery мәнін азайтыңыз
       *[no] time мәнін арттырыңыз немесе recovery мәнін азайтыңыз
    }.
separation-one-speed = Қажетті айналу жиілігі ({ $recovery } ұстау үшін) және сезімталдықтар есептелмейді: бұл айналу жиілігінің { $times } есесіне дейін әр бөлшек инерциясымен интегралданар еді. Инерцияны ескермейтін model = "drifting" қолданыңыз немесе жеке айналу жиіліктерін есептеңіз.
separation-nothing-shown = Нәтиже жоқ: бөлшек жолдарымен есептелетін көлем шегі барлық жол есептелгенге дейін зерттеуді аяқтады.
separation-cut-size = Бөлу өлшемі: { $value } өлшемді { $particles ->
        [light] жеңіл бөлшектердің
       *[heavy] ауыр бөлшектердің
    } жартысы ұсталады{ $estimate ->
        [none] {""}
        [inertia] , инерция ескерілмеген
       *[run_up] , инерциясыз бағаланған, екпіндеу орташа радиустағы өріс бойынша алынған
    }.
separation-released = Жіберілген бөлшек { $value } өткенде { $surface ->
        [wall] қабырғаға
        [bottom] түпке
       *[surface] сұйықтық бетіне
    } жетеді, стакан бойымен { $along }.
separation-released-stays = Жіберілген бөлшек ешбір бетке жетпейді: ол сұйықтықта қалады.
separation-released-outside = Жіберу нүктесі сұйықтықтан тыс, жол есептелмейді. release нүктесін сұйықтық ішіне жылжытыңыз.

# The cup and its field.
separation-tilt = Стакан тік бағыттан { $value } бұрылады.
separation-tilt-none = Стакан тік ілініп тұр: бұл айналу жиілігінде ол бұрылмайды.
separation-tilt-held = Стаканның бекітілген көлбеулік бұрышы { $value }.
separation-field = Центрден тепкіш өріс сұйықтық бетінде { $surface } g, сыртқы радиуста { $value } g.
separation-no-field = Тек ауырлық күші әсер етеді: центрден тепкіш өріс { $value } g.

# Validity of the model.
separation-gravity = Қажетті айналу жиілігінде ең ішкі сұйықтықтағы өріс { $value } g. Модель ауырлық күшін ескермейді, бұл { $least } g мәнінен жоғары жарамды: қажетті айналу жиілігі – бағалау ғана.
separation-validity = Жарамдылығы күмәнді ({ $name } = { $value }, шегі { $limit }): { $meaning }.
separation-validity-undefined = Жарамдылығы күмәнді ({ $name } ақырлы емес, шегі { $limit }): { $meaning }.
