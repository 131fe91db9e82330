# Студия бетінің сөздері.
studio-text = Машина файлы
studio-machine = Машина
studio-figures = Нәтижелер
studio-view = Көрініс
studio-tab-text = Мәтін
studio-tab-machine = Машина
studio-tab-figures = Нәтижелер
studio-tab-section = Қима
studio-tab-space = 3-D
studio-want-page = Есептің бірінші беті
studio-want-modes = Модалар
studio-want-campbell = Кэмпбелл диаграммасы
studio-want-stability = Орнықтылық
studio-want-forced = Дисбаланстан болатын тербеліс
studio-want-nonlinear = Бейсызық тербеліс
studio-short-page = Бірінші бет
studio-short-modes = Модалар
studio-short-campbell = Кэмпбелл
studio-short-stability = Орнықтылық
studio-short-forced = Дисбаланс
studio-short-nonlinear = Бейсызық
studio-nothing = Бұл машина үшін нәтиже жоқ.

# Файл мен мәтін.
studio-open = Ашу
studio-save = Сақтау
studio-save-as = Басқаша сақтау
studio-saved = { $name } файлы сақталды.
studio-unsaved = Өзгерістер сақталмаған.
studio-new-file = жаңа файл
studio-file-name = Файл атауы
studio-file-name-wrong = Осы қалтадағы .toml деп аяқталатын файл атауы қажет, мысалы rotor.toml.
studio-files = Осы қалтаның файлдары
studio-examples = Мысалдар
studio-changed-on-disk = Дискідегі файл өзгерген
studio-overwrite = Үстінен жазу
studio-load-from-disk = Дискіден жүктеу
studio-undo = Болдырмау
studio-redo = Қайталау
studio-errors = Файлдағы қателер ({ $count }). Біріншісі
studio-lost = Бағдарламамен байланыс жоқ. Мәтін осында сақталады; байланыс секунд сайын тексеріледі.
studio-unsent = Байланыс қалпына келгенде жіберіледі: { $name }.
studio-close = Жабу
studio-language = Тіл
studio-theme-system = Түстер: жүйедегідей
studio-theme-light = Түстер: ашық
studio-theme-dark = Түстер: қою
studio-unit = бірлік
studio-default = әдепкі мән

# Параметрлер мен тұтқалар.
studio-parameters = Параметрлер
studio-parameter = Параметр
studio-value = мәні
studio-range = Ауқым
studio-from = Бастап
studio-to = Дейін
studio-drag-this = Сүйреңіз: { $name }, { $value }

# Үш өлшемді қозғалыс.
studio-motion = Қозғалыс
studio-motion-forced = Дисбаланстан болатын сызықтық тербеліс, { $value } айн/мин
studio-motion-nonlinear = Дисбаланстан болатын бейсызық тербеліс, { $value } айн/мин
studio-motion-state = { $count }-күй
studio-motion-unstable = орнықсыз
studio-motion-start = Тепе-теңдіктен басталатын өтпелі процесс, { $value } айн/мин
studio-motion-transient = «{ $name }» өтпелі процесі
studio-shown = Ең үлкен ығысу: { $value }. Үлкейту × { $from }, баяулату × { $to }.
studio-computing = Есептеу жүріп жатыр
studio-time = { $value } с
studio-mode = { $count }-мода
studio-whirl-forward = тура прецессия
studio-whirl-backward = кері прецессия
studio-whirl-mixed = аралас прецессия
studio-whirl-axial = осьтік
studio-whirl-torsional = бұралу
studio-whirl-none = прецессиясыз
studio-play = Ойнату
studio-pause = Кідірту
studio-amplitude = Амплитуда
studio-speed = Айналу жиілігі
studio-rpm = айн/мин
studio-hertz = Гц
studio-grows = өседі, { $value } 1/с
studio-decays = өшеді, { $value } 1/с
studio-space-help = Машинаның үш өлшемді көрінісі. Бұру: сүйреу немесе бағыттауыш пернелер; қашықтық: плюс пен минус.
studio-no-space = Бұл браузер үш өлшемді графиканы қолдамайды.

# Сүйреп берілетін нәтижелер.
studio-reach = Нәтижені беру
studio-released = бос
studio-released-help = Бағдарлама бұл параметрді ауқымы ішінде өзгерте алады.
studio-release-first = Бос параметрлерді белгілеңіз, содан кейін графикте сындық айналу жиілігін, орнықтылық шегін, шыңды немесе секірісті сүйреңіз.
studio-pull-help = Бос параметрлер: { $count }. Графикте сындық айналу жиілігін, орнықтылық шегін, шыңды немесе секірісті сүйреңіз.
studio-pull-this = Сүйреңіз: { $name }
studio-reach-running = { $name }: { $value } болатын мәндер ізделуде …
studio-reached = { $name }: { $value } мәніне жетті.
studio-not-reached = { $name }: { $value } мәніне жетпеді.
studio-share-column = Үлесі
studio-at-bound = шекарада
studio-take-nearest = Ең жақын мәндерді алу
studio-not-a-number = { $name } бірлігіндегі немесе сол шаманың басқа бірлігі бар сан қажет.
studio-trade = Өзгеріс құны
studio-trade-curve = Бос параметрлер өзгерісінің нәтижеге тәуелділігі
studio-change = параметрлер өзгерісі,
studio-alone = Жеке
studio-result = Нәтиже

# Салыстыру мен бөлісу.
studio-pin = Бекіту
studio-pin-help = Бұл нұсқаны салыстыру үшін бекіту.
studio-share = Бөлісу
studio-share-help = Мәтіні, нәтижелері және бекітілген нұсқалары бар бір HTML файлы.
studio-compare = Салыстыру
studio-check = Тексеру
studio-now = Қазір
studio-design = Нұсқа
studio-name = Атауы
studio-take-back = Қайтару
studio-take-back-this = { $name } нұсқасын қайтару
studio-remove = Алып тастау
studio-remove-this = { $name } алып тастау

# Зерттеулерді орындау.
studio-runs = Файлдағы зерттеулер
studio-no-studies = Файлда зерттеулер жоқ.
studio-run = Есептеу
studio-run-this = { $name } есептеу
studio-resume = Жалғастыру
studio-cancel = Тоқтату
studio-report = Есеп
studio-state-waiting = күту
studio-state-running = орындалуда
studio-state-paused = кідіртілген
studio-state-done = орындалды
studio-state-cancelled = тоқтатылды
studio-state-failed = орындалмады
