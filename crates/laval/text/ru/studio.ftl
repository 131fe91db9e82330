# Слова страницы студии.
studio-text = Файл машины
studio-machine = Машина
studio-figures = Результаты
studio-view = Вид
studio-tab-text = Текст
studio-tab-machine = Машина
studio-tab-figures = Результаты
studio-tab-section = Разрез
studio-tab-space = 3-D
studio-want-page = Первая страница отчёта
studio-want-modes = Моды
studio-want-campbell = Диаграмма Кэмпбелла
studio-want-stability = Устойчивость
studio-want-forced = Отклик на дисбаланс
studio-want-nonlinear = Нелинейный отклик
studio-short-page = Первая страница
studio-short-modes = Моды
studio-short-campbell = Кэмпбелл
studio-short-stability = Устойчивость
studio-short-forced = Дисбаланс
studio-short-nonlinear = Нелинейный
studio-nothing = Для этой машины результата нет.

# Файл и текст.
studio-open = Открыть
studio-save = Сохранить
studio-save-as = Сохранить как
studio-saved = Файл { $name } сохранён.
studio-unsaved = Изменения не сохранены.
studio-new-file = новый файл
studio-file-name = Имя файла
studio-file-name-wrong = Нужно имя файла этой папки с окончанием .toml, например rotor.toml.
studio-files = Файлы этой папки
studio-examples = Примеры
studio-changed-on-disk = Файл на диске изменён
studio-overwrite = Перезаписать
studio-load-from-disk = Загрузить с диска
studio-undo = Отменить
studio-redo = Повторить
studio-errors = Ошибки в файле ({ $count }). Первая
studio-lost = Нет связи с программой. Текст сохраняется здесь; попытка соединения каждую секунду.
studio-unsent = Будет отправлено после восстановления связи: { $name }.
studio-close = Закрыть
studio-language = Язык
studio-theme-system = Цвета: системные
studio-theme-light = Цвета: светлые
studio-theme-dark = Цвета: тёмные
studio-unit = единица
studio-default = по умолчанию

# Параметры и ручки.
studio-parameters = Параметры
studio-parameter = Параметр
studio-value = значение
studio-range = Диапазон
studio-from = От
studio-to = До
studio-drag-this = Перетащите: { $name }, { $value }

# Движение в объёме.
studio-motion = Движение
studio-motion-forced = Линейный отклик на дисбаланс, { $value } об/мин
studio-motion-nonlinear = Нелинейный отклик на дисбаланс, { $value } об/мин
studio-motion-state = режим { $count }
studio-motion-unstable = неустойчивый
studio-motion-start = Переходный процесс из равновесия, { $value } об/мин
studio-motion-transient = Переходный процесс «{ $name }»
studio-shown = Наибольшее смещение: { $value }. Увеличение × { $from }, замедление × { $to }.
studio-computing = Выполняется расчёт
studio-time = { $value } с
studio-mode = Мода { $count }
studio-whirl-forward = прямая прецессия
studio-whirl-backward = обратная прецессия
studio-whirl-mixed = смешанная прецессия
studio-whirl-axial = осевая
studio-whirl-torsional = крутильная
studio-whirl-none = без прецессии
studio-play = Пуск
studio-pause = Пауза
studio-amplitude = Амплитуда
studio-speed = Частота вращения
studio-rpm = об/мин
studio-hertz = Гц
studio-grows = растёт, { $value } 1/с
studio-decays = затухает, { $value } 1/с
studio-space-help = Машина в объёме. Поворот: перетаскивание или клавиши со стрелками; расстояние: плюс и минус.
studio-no-space = Этот браузер не поддерживает трёхмерную графику.

# Результаты, которые задаются перетаскиванием.
studio-reach = Задать результат
studio-released = свободен
studio-released-help = Программа может менять этот параметр в его диапазоне.
studio-release-first = Отметьте свободные параметры, затем перетащите на рисунке критическую частоту вращения, границу устойчивости, пик или скачок.
studio-pull-help = Свободных параметров: { $count }. Перетащите на рисунке критическую частоту вращения, границу устойчивости, пик или скачок.
studio-pull-this = Перетащите: { $name }
studio-reach-running = Подбираются значения, при которых { $name }: { $value } …
studio-reached = { $name }: значение { $value } достигнуто.
studio-not-reached = { $name }: значение { $value } не достигнуто.
studio-share-column = Доля
studio-at-bound = на границе
studio-take-nearest = Взять ближайшие значения
studio-not-a-number = Нужно число в { $name } или с единицей той же величины.
studio-trade = Цена изменения
studio-trade-curve = Изменение свободных параметров в зависимости от результата
studio-change = изменение параметров,
studio-alone = Отдельно
studio-result = Результат

# Сравнение и передача.
studio-pin = Закрепить
studio-pin-help = Закрепить этот вариант для сравнения.
studio-share = Поделиться
studio-share-help = Один файл HTML с текстом, результатами и закреплёнными вариантами.
studio-compare = Сравнение
studio-check = Проверка
studio-now = Сейчас
studio-design = Вариант
studio-name = Название
studio-take-back = Вернуть
studio-take-back-this = Вернуть { $name }
studio-remove = Убрать
studio-remove-this = Убрать { $name }

# Выполнение расчётов.
studio-runs = Расчёты из файла
studio-no-studies = В файле нет расчётов.
studio-run = Рассчитать
studio-run-this = Рассчитать { $name }
studio-resume = Продолжить
studio-cancel = Прервать
studio-report = Отчёт
studio-state-waiting = ожидание
studio-state-running = выполняется
studio-state-paused = приостановлен
studio-state-done = выполнен
studio-state-cancelled = прерван
studio-state-failed = не выполнен
