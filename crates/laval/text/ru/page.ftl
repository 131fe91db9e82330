# Words of the report's own page and of the terminal, beside those of the first page.

page-nameless = машина без названия
page-report = отчёт laval
page-from = из { $file }
# In front of the first digits of the hash of the input file.
page-hash = исходные данные
page-results = Выводы
page-studies = Расчёты
page-kind = вид
page-bracket = ширина интервала
page-status = состояние
page-doubtful = под сомнением: { $reason }
page-first-rows = Показано строк: { $first } из { $count }.
# In front of the name of a file.
page-all-values = Все значения:
page-no-data = в этом диапазоне нет данных
page-also-marked = Также отмечено: { $labels }
page-nothing-to-report = выполнено, выводов нет

# Buttons and lists of a motion that is played.
play-play = Пуск
play-pause = Пауза
play-time = Время
play-axes = Система координат
play-turning = вращающаяся система координат
play-fixed = неподвижная система координат
play-pace = Скорость показа
play-whole = всё за 20 с
play-turn = один оборот в секунду
