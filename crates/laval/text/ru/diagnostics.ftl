### Sentences of diagnostics and of the command line; the names are those of text/en/diagnostics.ftl.

diag-error-a6c0 = ошибка
diag-warning-6bce = предупреждение
diag-help-9b8b = подсказка
diag-did-you-mean-dcdc = возможно, имелось в виду { $near }? { $list }
diag-did-you-mean-fa5e = возможно, имелось в виду { $near }?
diag-bodies-of-this-machine-e555 = тела этой машины: { $all }
diag-is-attached-to-which-does-not-e3d3 = { $kind } «{ $block }»: присоединение к телу «{ $name }», которого нет
diag-no-such-body-1f1f = такого тела нет
diag-also-named-in-line-e5a1 = { $message } (также в строке { $line })
diag-also-named-in-lines-and-6dd4 = { $message } (также в строках { $lines } и { $last })
diag-also-named-in-lines-and-more-5c20 = { $message } (также в строках { $lines } и ещё в { $left })
diag-and-more-9d04 = ... и ещё { $n }

# laval/src/file
diag-give-about-turning-or-c5d1 = задайте about = "turning": { $studies }; или { $or }
diag-give-about-turning-e2db = задайте about = "turning": { $studies }
diag-study-713d = расчёт { $one }
diag-studies-a7da = расчёты { $names }
diag-cannot-be-built-from-what-is-17a3 = { $kind } «{ $name }»: по заданным данным элемент построить нельзя
diag-gives-a-force-that-is-not-403d = { $kind } «{ $name }»: сила элемента не является конечным числом
diag-a-value-of-this-part-is-16e4 = одно из значений этого элемента слишком велико или слишком мало для вычислений

diag-the-machine-has-no-parts-7f63 = в машине нет элементов
diag-describe-each-part-in-a-block-256d = опишите каждый элемент в блоке, который начинается с [[part]]
diag-there-is-one-in-a-file-3572 = блок { $word } в файле только один
diag-double-brackets-f6a7 = двойные скобки
diag-must-be-a-block-394a = { $word } должно быть блоком
diag-write-with-single-brackets-once-and-c02a = напишите [{ $word }] один раз, в одинарных скобках, и под ним его ключи
diag-a-is-a-part-write-part-f85c = { $key } — вид элемента: напишите [[part]] и под ним kind = "{ $key }"
diag-is-a-study-write-study-and-f8f8 = { $key } — вид расчёта: напишите [[study]] и под ним kind = "{ $key }"
diag-every-key-stands-in-a-block-7dc3 = каждый ключ стоит в блоке: [machine], [[part]] или [[study]]; { $name } стоит под [machine]
diag-every-key-stands-in-a-block-8b85 = каждый ключ стоит в блоке: [machine], [[part]] или [[study]]
diag-a-file-has-one-machine-and-cd0f = в файле один блок [machine] и блоки [[part]] и [[study]]
diag-a-file-has-one-machine-and-ffdb = в файле один блок [machine] и блоки [[part]] и [[study]], а также { $beside }
diag-is-not-a-block-of-a-3d1c = { $key } не является блоком файла машины
diag-unknown-04cc = неизвестно
diag-needs-double-brackets-66da = для [{ $what }] нужны двойные скобки
diag-single-brackets-040e = одинарные скобки
diag-write-there-may-be-several-5078 = напишите [[{ $what }]]: таких блоков может быть несколько
diag-must-be-a-block-f338 = { $what } должно быть блоком
diag-write-and-its-keys-below-0c3c = напишите [[{ $what }]] и под ним его ключи
diag-a-must-be-a-block-not-807b = { $what } должно быть блоком; здесь { $shape }
diag-two-blocks-are-named-4142 = два блока [[{ $what }]] имеют одно имя { $name }
diag-two-blocks-are-named-apart-from-7b57 = два блока [[{ $what }]] имеют одно имя { $name } (от { $first } отличаются только прописные буквы)
diag-taken-above-5dad = имя занято выше
diag-give-each-its-own-name-others-21ca = дайте каждому своё имя; другие блоки ссылаются на него по имени
diag-has-no-key-beb0 = { $who }: ключа { $key } нет
diag-it-stands-inside-06c3 = он стоит внутри { $f }: { $f } = {"{"} { $key } = .. {"}"}
diag-did-you-mean-its-keys-68cd = возможно, имелось в виду { $near }? Ключи: { $all }
diag-its-keys-4d57 = ключи: { $all }
diag-unknown-key-b3fe = неизвестный ключ
diag-needs-d775 = { $who }: нужен ключ { $name }: { $doc }
diag-add-605c = добавьте { $example }
diag-is-missing-e95c = нет { $name } = ..
diag-the-file-has-no-machine-block-3137 = в файле нет блока [machine]
diag-begin-it-with-machine-and-below-3516 = начните файл с [machine], ниже напишите name = ".." и speed = "3000 rpm"

diag-there-is-no-kind-of-study-7368 = вида расчёта «{ $kind }» нет
diag-there-is-59f4 = имеются: { $all }
diag-the-study-cannot-be-made-from-9149 = из этих полей расчёт составить нельзя
diag-the-fields-of-are-an-object-9722 = поля { $kind } должны быть объектом; здесь { $shape }
diag-write-df54 = напишите {"{"} "speed": 300.0 {"}"}
diag-the-declared-default-cannot-be-used-a68d = объявленное значение по умолчанию { $default } непригодно: { $text }
diag-is-not-an-si-unit-b335 = { $kind }.{ $name }: { $unit } не является единицей СИ

diag-nothing-holds-in-it-can-move-41a0 = ничто не удерживает «{ $name }» в направлениях { $names }: тело может уйти, одно или вместе с соединёнными с ним телами
diag-join-it-to-ground-or-to-f640 = соедините его с "ground" или с основанием опорой либо валом; демпфер положения не удерживает
diag-of-has-no-effect-what-it-e0f8 = { $name } элемента «{ $slot }» не действует: присоединённое тело не наклоняется
diag-give-a-disc-its-diametral-inertia-7912 = чтобы диск мог наклоняться, задайте ему diametral_inertia
diag-is-clamped-at-which-does-not-8696 = «{ $name }» заделан в «{ $body }», а это тело не наклоняется
diag-give-its-to-let-it-tilt-696b = чтобы «{ $body }» мог наклоняться, задайте ему { $lets }

diag-this-machine-has-no-body-add-f649 = в этой машине нет тел: добавьте элемент, например диск
diag-is-attached-to-which-is-a-ef10 = { $kind } «{ $block }»: присоединение к «{ $name }», а это { $other }, не тело
diag-not-a-body-2491 = не тело
diag-the-position-on-has-no-effect-fbb2 = положение на «{ $name }» не действует: { $kind } не наклоняется
diag-no-effect-04cf = не действует

diag-the-kind-of-is-declared-twice-ad11 = вид { $kind } ({ $what }) объявлен дважды
diag-declares-the-key-twice-abcf = { $kind }: ключ { $name } объявлен дважды

diag-unknown-parameter-af90 = неизвестный параметр
diag-coordinates-of-this-machine-baed = координаты этой машины: { $all }
diag-there-is-no-coordinate-e0c3 = координаты «{ $name }» нет
diag-unknown-coordinate-5bfd = неизвестная координата

diag-write-kind-not-type-4ed8 = напишите kind = { $t } вместо type
diag-write-kind-with-one-of-9d60 = напишите kind = ".." с одним из слов: { $all }
diag-this-says-no-kind-ea9b = в этом блоке { $block } не указан вид
diag-kind-is-missing-ef9a = нет kind = ".."
diag-kind-must-be-a-word-in-cd0b = { $block }: kind должно быть словом в кавычках; здесь { $shape }
diag-there-is-no-kind-of-called-2deb = вида { $t } ({ $what }) нет
diag-unknown-kind-35ae = неизвестный вид
diag-kinds-of-studies-de0a = виды расчётов: { $all }
diag-kinds-of-s-5328 = виды { $what }: { $all }
diag-the-name-of-a-must-be-68d4 = имя блока { $what } должно быть текстом в кавычках; здесь { $shape }
diag-a-cannot-be-named-ground-fe8c = блок { $what } нельзя назвать "ground"
diag-reserved-1e48 = зарезервировано
diag-ground-is-the-fixed-surroundings-that-f758 = "ground" — неподвижная опорная система, к которой можно присоединять элементы
diag-cannot-be-the-name-of-a-90a3 = { $t } не может быть именем блока { $what }
diag-not-a-name-8729 = не имя
diag-a-name-is-made-of-letters-2e08 = имя состоит из букв любой письменности, цифр, пробелов, _ и -, начинается с буквы или цифры и содержит не более 64 знаков
diag-for-instance-5228 = например, { $name }: { $help }

diag-write-the-name-of-a-study-e443 = напишите имя расчёта из этого файла или { $example }
diag-a-study-76fb = расчёт
diag-studies-of-this-file-that-can-5f25 = расчёты этого файла, которые можно выполнить: { $all }
diag-add-such-a-study-to-this-bcab = добавьте такой расчёт в этот файл или напишите здесь { $example }
diag-is-but-no-study-has-that-9fe6 = { $who } = { $name }, но расчёта с таким именем нет
diag-no-such-study-32eb = такого расчёта нет
diag-cannot-be-a-study-of-kind-15ef = { $who }: расчёт вида { $kind } недопустим, он сам выполняет другой расчёт
diag-runs-another-study-11b5 = выполняет другой расчёт
diag-write-4281 = напишите [{"{"} parameter = "drum.mass", distribution = "normal", deviation = "2 %" {"}"}]
diag-a-list-of-uncertain-parameters-3ed5 = список неопределённых параметров
diag-names-twice-9ac4 = { $who }: параметр { $parameter } назван дважды
diag-named-above-004f = назван выше
diag-an-uncertain-parameter-196d = неопределённый параметр
diag-has-no-f0cb = { $who }: ключа { $key } нет
diag-is-missing-9c2c = нет { $key } = ..
diag-a-text-6622 = текст
diag-cannot-be-eb0f = { $who }: значение { $kind } недопустимо
diag-distributions-8a45 = распределения: { $all } ({ $meanings })
diag-not-a-distribution-147d = не распределение

diag-write-a-number-with-a-unit-5e75 = напишите число с единицей в кавычках ({ $example }) или число без единицы в СИ
diag-a-finite-number-is-needed-9e4f = { $who }: нужно конечное число
diag-not-finite-0a50 = не конечное число
diag-is-it-must-be-06bd = { $who } = { $value }; допустимые значения: { $bounds }
diag-write-if-you-mean-percent-1b90 = если имеются в виду проценты, напишите "{ $x } %"
diag-a-bare-number-is-in-put-f863 = число без единицы читается в { $unit }; для других единиц заключите число с единицей в кавычки ({ $examples })
diag-out-of-bounds-444d = вне допустимых пределов
diag-a-whole-number-or-auto-fc98 = целое число или "auto"
diag-a-whole-number-5f04 = целое число
diag-is-it-must-be-a-whole-6f22 = { $who } = { $i }; допустимо целое число от { $min } до { $max } или "auto"
diag-is-it-must-be-a-whole-a695 = { $who } = { $i }; допустимо целое число от { $min } до { $max }
diag-write-without-quotes-c0ab = напишите { $t } без кавычек
diag-is-needed-not-0ee8 = { $who }: ожидается { $wanted }, задано { $t }
diag-not-a-whole-number-a94c = не целое число
diag-write-df59 = напишите { $number }
diag-is-needed-this-number-has-a-f0fe = { $who }: ожидается { $wanted }; это число дробное или слишком велико
diag-write-one-value-for-both-directions-1e77 = напишите одно значение для обоих направлений или {"{"} x = .., y = .. {"}"}
diag-write-exactly-one-of-them-df4b = напишите ровно одно из них: {"{"} { $names } = .. {"}"}
diag-one-of-several-quantities-7ee2 = одна из нескольких величин
diag-wants-exactly-one-of-none-given-5b19 = { $who }: нужно ровно одно из { $names }; не задано ни одного
diag-wants-exactly-one-of-given-eadc = { $who }: нужно ровно одно из { $names }; задано { $found }
diag-exactly-one-6b94 = ровно одно
diag-write-one-value-or-with-values-9303 = напишите одно значение или {"{"} from = .., to = .., points = .. {"}"} со значениями в { $examples }
diag-write-one-value-or-with-numbers-3184 = напишите одно значение или {"{"} from = .., to = .., points = .. {"}"} с числами
diag-a-range-f017 = диапазон
diag-a-range-is-points-may-be-3a42 = диапазон задаётся как {"{"} from = .., to = .., points = .. {"}"}; points можно не указывать
diag-begins-and-ends-at-9f6a = { $who }: начало и конец диапазона равны { $from }
diag-empty-range-0d7b = пустой диапазон
diag-from-and-to-must-differ-6d65 = from и to должны различаться
diag-a-finite-number-with-a-unit-65fb = конечное число с единицей
diag-a-table-of-columns-f422 = таблица столбцов
diag-write-2117 = напишите {"{"} { $names } {"}"}
diag-has-no-column-40e2 = { $who }: нет столбца { $name } ({ $doc })
diag-is-missing-fa44 = нет { $name } = [..]
diag-the-columns-differ-in-length-has-d5e8 = { $who }: столбцы разной длины: число значений в { $first } равно { $n }, в { $name } равно { $column }
diag-other-length-7560 = другая длина
diag-has-no-columns-4cc3 = { $who }: столбцов нет
diag-empty-a649 = пусто
diag-put-it-in-brackets-also-when-fec0 = заключите в квадратные скобки, даже если значение одно: [..]
diag-a-list-of-numbers-ae1f = список чисел
diag-the-list-is-empty-168a = { $who }: список пуст

diag-the-file-has-mb-at-most-251d = размер файла { $size } МБ; читаются файлы до 64 МБ
diag-tables-within-more-than-others-are-f2ff = таблицы, вложенные более чем в { $most } других, не читаются
diag-nested-too-deeply-40e0 = слишком глубокая вложенность
diag-the-file-is-no-text-byte-0366 = файл не является текстом: байт { $number } равен NUL (0x00), в тексте такого байта не бывает
diag-nul-402d = NUL
diag-save-it-as-utf-8-text-af88 = сохраните его как текст UTF-8; такие байты бывают в файлах UTF-16 и в повреждённых файлах
diag-it-looks-like-utf-16-save-fb74 = это похоже на UTF-16; сохраните файл в UTF-8
diag-save-it-as-utf-8-often-3d66 = сохраните файл в UTF-8; частая причина — знак единицы, например µ или °, в старой кодировке
diag-the-file-is-not-utf-8-a89f = файл не является текстом UTF-8: байт { $number } равен 0x{ $byte }
diag-here-44f0 = здесь
diag-a-machine-is-an-object-with-b397 = машина должна быть объектом с machine, part и study; здесь { $shape }

diag-the-name-of-a-body-2307 = имя тела
diag-write-drum-or-4587 = напишите "drum" или {"{"} body = "drum", at = "40 mm" {"}"}
diag-must-be-a-body-the-ground-3c72 = { $who } должно быть телом; "ground" здесь недопустимо
diag-the-name-of-a-body-is-95ae = { $who }: нет имени тела
diag-names-no-body-382f = { $who }: тело не названо
diag-body-is-missing-8cdf = нет body = ..
diag-write-f6dd = напишите {"{"} body = "drum", at = "40 mm" {"}"}
diag-the-ground-has-no-position-42fd = { $who }: у "ground" нет положения
diag-leave-this-out-139b = уберите это
diag-write-between-drum-base-one-of-ab81 = напишите between = ["drum", "base"]; одной из двух точек может быть "ground"
diag-a-list-of-two-points-271a = список из двух точек
diag-must-name-two-points-given-82c3 = { $who }: нужно назвать две точки, названо { $given }
diag-two-points-bc22 = две точки
diag-connects-with-itself-7d64 = { $who } соединяет { $what } с самим собой
diag-the-same-point-twice-e8b6 = одна и та же точка дважды
diag-is-but-no-part-is-named-3d65 = { $who } = { $path }, но элемента с именем { $block } нет
diag-parts-of-this-file-001d = элементы этого файла: { $all }
diag-no-such-part-f861 = такого элемента нет
diag-is-but-is-a-list-studies-307e = { $who } = { $path }, но «{ $name }» — список: его значения в расчётах неизменны
diag-studies-vary-single-numbers-parameters-of-2b8a = расчёты варьируют отдельные числа; параметры { $kind }: { $all }
diag-a-list-no-parameter-e77d = список, не параметр
diag-names-the-part-and-none-of-5c03 = { $who }: назван элемент { $block }, но ни один из его параметров
diag-is-but-a-has-no-parameter-d1e5 = { $who } = { $path }, но у { $kind } нет параметра { $rest }
diag-parameters-of-a-0768 = параметры { $kind }: { $all }
diag-no-such-parameter-4b6b = такого параметра нет
diag-write-0abe = напишите {"{"} parameter = "part.parameter", from = .., to = .., points = .. {"}"}
diag-the-range-of-a-parameter-5b06 = диапазон параметра
diag-names-no-parameter-1d76 = { $who }: параметр не назван
diag-parameter-is-missing-4f11 = нет parameter = ..
diag-the-path-of-a-parameter-9555 = путь параметра
diag-write-5182 = напишите [{"{"} parameter = "part.parameter", from = .., to = .. {"}"}]
diag-a-list-of-ranges-of-parameters-9cbf = список диапазонов параметров
diag-names-twice-8475 = { $who }: { $path } назван дважды
diag-the-name-of-a-coordinate-6fbe = имя координаты
diag-the-name-of-a-coordinate-is-24bc = { $who }: нет имени координаты
diag-write-it-as-in-drum-x-5010 = пишите, как в примере: "drum.x"
diag-a-table-of-initial-values-4b73 = таблица начальных значений
diag-write-e21e = напишите {"{"} "drum.x" = "1 mm", "drum.x'" = "0.1 m/s" {"}"}

diag-the-list-of-is-not-closed-7aa9 = список { $key } не закрыт
diag-the-table-of-is-not-closed-f05f = таблица { $key } не закрыта
diag-is-missing-a1f6 = нет { $missing }
diag-write-ab95 = напишите { $line }
diag-so-far-only-the-syntax-and-f296 = пока проверены только синтаксис и отдельные значения: согласованность элементов и расчётов проверяется после исправления синтаксиса
diag-this-line-holds-the-control-character-c33b = в этой строке управляющий символ { $code }, которого в тексте не бывает
diag-remove-it-f612 = удалите его
diag-stands-twice-in-the-file-4a48 = { $body } стоит в файле дважды
diag-the-second-time-236c = второй раз
diag-write-one-block-or-double-brackets-7c6f = оставьте один блок или, где блоков может быть несколько, поставьте двойные скобки: [[part]], [[study]]
diag-the-key-is-given-twice-in-59e4 = ключ { $word } задан в одном блоке дважды
diag-keep-one-of-the-two-a-15af = оставьте один из двух; следующий элемент начинается со своего [[part]]
diag-the-header-of-this-block-is-b840 = заголовок этого блока закрыт неправильно
diag-brackets-91a2 = скобки
diag-write-machine-c5b2 = напишите [machine]
diag-write-d669 = напишите [[{ $word }]]
diag-this-line-is-neither-a-block-beb3 = эта строка — не заголовок блока и не ключ со значением
diag-not-understood-f2b2 = непонятно
diag-write-key-value-machine-part-or-0363 = напишите ключ = значение, [machine], [[part]] или [[study]]; примечание начинается с #
diag-the-value-of-is-missing-b5bb = нет значения { $key }
diag-nothing-behind-02e0 = после = ничего нет
diag-write-8c88 = напишите { $key } = ".."
diag-cannot-be-a-key-1991 = { $key } не может быть ключом
diag-not-a-key-1e19 = не ключ
diag-a-key-is-one-word-of-4542 = ключ — одно слово из латинских букв, цифр, _ и -; напишите ключ = значение
diag-a-quotation-mark-is-missing-in-97fa = в значении { $key } не хватает кавычки
diag-not-closed-f52d = не закрыто
diag-write-dea8 = напишите { $key } = "{ $value }
diag-write-981e = напишите { $key } = { $value }"
diag-texts-and-quantities-stand-between-two-eaf9 = тексты и величины заключаются в две кавычки
diag-a-brace-is-missing-in-the-f638 = в значении { $key } не хватает фигурной скобки
diag-must-match-94c5 = {"{"} и {"}"} должны соответствовать друг другу
diag-a-table-is-written-1c60 = таблица записывается так: {"{"} x = "..", y = ".." {"}"}
diag-a-bracket-is-missing-in-the-9d9f = в значении { $key } не хватает квадратной скобки
diag-and-must-match-d619 = [ и ] должны соответствовать друг другу
diag-a-list-is-written-a8d4 = список записывается так: ["..", ".."]
diag-the-value-of-cannot-be-read-12c4 = значение { $key } не читается
diag-inside-lists-and-tables-too-texts-7ba8 = в списках и таблицах тексты и величины также стоят в кавычках, между записями ставится запятая: {"{"} x = "1 mm", y = "2 mm" {"}"}
diag-the-value-of-must-stand-in-fc2a = значение { $key } должно стоять в кавычках, так как оно имеет единицу
diag-quotes-are-missing-ee9e = нет кавычек
diag-write-4a1c = напишите { $key } = "{ $value }"
diag-the-value-of-must-stand-in-d51a = значение { $key } должно стоять в кавычках
diag-this-line-cannot-be-read-0302 = эта строка не читается: { $why }

diag-a-number-d67a = число
diag-true-or-false-80f6 = true или false
diag-an-empty-list-4d93 = пустой список
diag-a-list-4075 = список
diag-a-table-9be6 = таблица
diag-a-date-402c = дата
diag-null-3ca3 = null

diag-unknown-unit-f106 = неизвестная единица
diag-no-unit-2424 = нет единицы
diag-wrong-dimension-b8aa = неверная размерность
diag-turns-or-radians-4d76 = обороты или радианы?
diag-no-number-15dc = нет числа
diag-a-pure-number-has-none-a311 = у безразмерного числа единицы нет
diag-is-given-in-2983 = { $quantity } задаётся в { $examples }
diag-is-needed-not-f6c2 = { $who }: ожидается { $wanted }, здесь { $shape }
diag-allowed-here-b4fe = здесь допустимы: { $all }
diag-put-it-in-quotes-8ea7 = заключите в кавычки
diag-a-word-8144 = слово
diag-write-one-of-91bc = напишите одно из: { $all }
diag-cannot-be-e72c = { $who }: значение { $t } недопустимо
diag-did-you-mean-choose-eeac = возможно, имелось в виду { $near }? Выберите: { $all }
diag-choose-c55d = выберите: { $all }
diag-not-one-of-its-words-2a4f = такого слова здесь нет
diag-write-true-or-false-without-quotes-cb7a = напишите true или false без кавычек

# laval-model: units
diag-is-needed-and-has-no-unit-a022 = ожидается { $wanted }, а у { $digits } нет единицы
diag-write-the-unit-behind-the-number-6a68 = напишите единицу после числа ({ $examples }); число без кавычек читается в { $expected }
diag-a-pure-number-0885 = безразмерное число
diag-is-needed-is-f561 = ожидается { $need } ({ $ex }); { $text } — { $is }
diag-is-needed-leaves-open-whether-turns-c66a = ожидается { $need } ({ $ex }); в { $text } не указано, обороты это или радианы
diag-for-turns-write-rpm-hz-or-aed2 = для оборотов напишите rpm, Hz или rev, для радианов rad
diag-is-needed-is-a-torque-9c88 = ожидается { $need } ({ $ex }); { $text } — момент силы
diag-is-needed-is-an-energy-4e75 = ожидается { $need } ({ $ex }); { $text } — энергия
diag-this-is-not-a-number-3ddb = это не число
diag-the-number-is-too-large-d1af = число слишком велико
diag-the-number-is-too-small-to-26fc = число слишком мало и неотличимо от 0
diag-a-finite-number-is-needed-not-7676 = ожидается конечное число, задано { $head }
diag-this-text-is-empty-267d = этот текст пуст
diag-begins-with-no-number-ac94 = { $text } начинается не с числа
diag-a-quantity-is-a-number-and-9dba = величина — это число и единица; { $what }
diag-write-it-as-in-70-mm-3a41 = пишите, как в примере: "70 mm"
diag-has-a-comma-in-its-number-f608 = в числе { $text } есть запятая
diag-write-the-decimal-point-as-in-e955 = пишите десятичную точку, как в "1.5 mm", без разделителей
diag-has-a-space-inside-its-number-6e0d = в числе { $text } есть пробел
diag-write-the-digits-together-as-in-4256 = пишите цифры слитно, как в "3000 rpm"
diag-writes-a-power-of-ten-in-9497 = в { $text } степень десяти записана произведением
diag-write-it-as-in-1-1e7-c4a9 = пишите, как в примере: "1.1e7 N/m"
diag-has-two-decimal-points-edcf = в { $text } две десятичные точки
diag-write-the-number-as-in-1-bee8 = пишите число, как в "1.5 mm", без разделителей
diag-is-too-long-for-a-unit-846f = { $text } слишком длинно для единицы
diag-does-not-belong-in-a-unit-043f = { $text } в единице недопустимо
diag-a-temperature-in-degc-stands-alone-276c = температура в degC стоит отдельно
diag-for-differences-and-in-products-write-9698 = для разностей и в произведениях пишите K
diag-this-unit-is-out-of-all-3847 = эта единица вне допустимых пределов
diag-a-unit-cannot-begin-with-a-1143 = единица не может начинаться со знака умножения
diag-has-two-readings-is-what-follows-4dcc = { $whole } читается двояко: то, что стоит после / и пробела, в числителе или в знаменателе?
diag-put-products-below-a-in-parentheses-42fc = произведение под знаком / заключите в круглые скобки, как в N/(m s), или запишите его первым, как в N s/m
diag-too-many-parentheses-45b6 = слишком много круглых скобок
diag-a-closing-parenthesis-is-missing-6a33 = не хватает закрывающей круглой скобки
diag-nothing-fcf7 = ничего
diag-a-unit-is-expected-here-not-6ef4 = здесь ожидается единица; найдено: { $what }
diag-is-not-a-known-unit-cbb5 = единица { $word } неизвестна
diag-a-closing-parenthesis-is-missing-in-1333 = в показателе степени не хватает закрывающей круглой скобки
diag-this-power-is-not-between-20-2848 = этот показатель степени равен 0 или лежит вне диапазона от -20 до 20
diag-a-power-is-a-number-as-f8ee = показатель степени — число, как в m^2, m^1.5 или m^(10/9)
diag-a-quantity-in-af40 = величина в { $unit }

# laval-model: model
diag-it-cannot-be-assembled-8afc = модель нельзя составить
diag-above-0-26cb = больше 0
diag-above-5980 = больше { $least }
diag-0-or-more-6fec = не меньше 0
diag-at-least-c24a = не меньше { $least }
diag-finite-511b = конечные
diag-at-most-0c11 = не больше { $most }
diag-between-and-c753 = от { $least } до { $most }
diag-between-0-and-9eeb = от 0 до { $most }
diag-and-at-most-cc06 = { $least } и не больше { $most }
diag-and-no-inertia-is-left-for-2cc3 = «{ $slot }»: { $what }, и для { $name } инерции не остаётся
diag-is-missing-3e54 = не задано: { $name }
diag-is-it-must-be-2e8e = { $name } = { $value }; допустимые значения: { $wanted }
diag-the-machine-has-no-body-that-7801 = в машине нет подвижных тел
diag-add-a-part-such-as-a-ab6a = добавьте элемент, например диск: [[part]] с kind = "disc" и массой
diag-two-parts-are-named-638c = два элемента имеют имя «{ $name }»
diag-give-each-part-its-own-name-aa86 = дайте каждому элементу своё имя
diag-part-takes-parameters-b0e6 = у элемента «{ $name }» должно быть параметров: { $slots }
diag-is-attached-to-which-does-not-caff = «{ $slot }»: присоединение к «{ $name }», которого нет
diag-bodies-of-this-machine-ground-e4bc = тела этой машины: { $bodies }, ground
diag-is-attached-to-which-is-not-24c5 = «{ $slot }»: присоединение к «{ $name }», а это не тело
diag-joins-a-point-to-itself-4999 = «{ $name }» соединяет точку с самой собой
diag-parts-of-this-machine-eb3a = элементы этой машины: { $names }
diag-what-a-file-says-in-another-eeb2 = величину, заданную в файле в другой форме (например, заполнение объёмом), варьируют через параметр, который она заменяет
diag-parameters-of-7bbb = параметры элемента «{ $part }»: { $near } ({ $other })
diag-is-no-parameter-is-a-list-51d9 = «{ $path }» — не параметр: «{ $name }» — список, его значения в расчётах неизменны
diag-there-is-no-parameter-e472 = параметра «{ $path }» нет
diag-has-no-form-in-the-time-79ba = «{ $name }» не имеет представления во временной области: { $why }
diag-use-a-study-in-the-frequency-2f24 = используйте расчёт в частотной области, например forced_response
diag-the-table-has-no-rows-b81e = в таблице нет строк
diag-the-columns-have-and-rows-7e32 = в столбцах разное число строк: { $x } и { $y }
diag-row-holds-a-number-that-is-048f = в строке { $row } стоит не конечное число
diag-the-argument-in-row-is-not-f142 = аргумент в строке { $row } не больше предыдущего
diag-singular-matrix-no-pivot-in-column-de5d = вырожденная матрица (нет ведущего элемента в столбце { $column })
diag-a-matrix-of-the-eigenvalue-problem-a9ba = в матрице задачи на собственные значения есть не конечное число
diag-the-eigenvalue-iteration-did-not-converge-94cd = итерации при поиске собственных значений не сошлись
diag-every-number-is-an-eigenvalue-the-489e = любое число является собственным значением: определитель тождественно равен нулю
diag-the-equations-are-not-defined-here-d632 = уравнения здесь не определены: { $why }
diag-cancelled-7c41 = отменено

# laval-model: parts
diag-a-track-has-balls-d20f = число шариков на дорожке задано как { $n }
diag-give-a-whole-number-of-balls-054f = задайте для каждой дорожки целое число шариков, не меньше 1
diag-the-tracks-have-more-than-balls-1d9d = на дорожках вместе больше { $most } шариков
diag-give-fewer-balls-6bc4 = задайте меньше шариков
diag-a-track-has-times-the-radius-4cd8 = радиус дорожки задан как { $r } от track_radius
diag-radius-is-a-positive-ratio-to-18f8 = radius — положительное отношение к track_radius
diag-a-track-is-tilted-by-more-dbfd = дорожка наклонена больше чем на 1.5 rad
diag-tilt-is-in-addition-to-that-0d1b = tilt прибавляется к наклону балансира
diag-balls-is-the-number-on-all-f8b1 = balls — число шариков на всех дорожках вместе; уберите его, числа для дорожек уже заданы
diag-balls-and-the-tracks-have-75ed = balls = { $n }, а на дорожках { $each } = { $all }
diag-mass-ratios-are-given-for-balls-a4df = задано отношений масс: { $given }, шариков: { $balls }
diag-mass-ratios-are-given-for-balls-4735 = задано отношений масс: { $given }, шариков: { $balls }, дорожек: { $tracks }
diag-one-ratio-for-each-ball-track-9a94 = задайте по одному отношению для каждого шарика, по порядку дорожек
diag-the-tilt-of-the-tracks-locks-0ce0 = наклон дорожек запирает шарики у линии узлов: r sin^2(tilt) = { $locking } должно быть меньше десятой доли эксцентриситета кольца, { $tenth }
diag-a-free-ring-needs-inertia-about-cb88 = свободному кольцу нужен момент инерции относительно линии узлов: задайте diametral_inertia
diag-no-ring-has-a-polar-inertia-5c83 = полярный момент инерции кольца ({ $polar_inertia }) не может превышать удвоенный экваториальный ({ $diametral_inertia }); для тонкого кольца он ровно вдвое больше
diag-acts-on-free-rings-and-these-e719 = { $field } действует на свободные кольца, а эти закреплены: задайте также rings = "free"
diag-the-ring-centre-from-the-shaft-43cc = центр кольца ({ $s } от вала) лежит вне дорожки (радиус { $r })
diag-balls-do-not-fit-on-track-6b52 = { $n ->
        [one] { $n } шарик не помещается
        [few] { $n } шарика не помещаются
       *[other] { $n } шариков не помещаются
    } на дорожке { $number }: место есть для { $fits }
diag-balls-that-touch-and-balls-that-edac = соприкасающиеся и несоприкасающиеся шарики — разные машины: постройте каждую отдельно
diag-balls-that-touch-need-their-size-32af = для соприкасающихся шариков нужен их размер: задайте ball_radius
diag-weight-acts-across-a-horizontal-axis-910f = при горизонтальной оси сила тяжести действует поперёк неё, не вдоль: задайте gravity = 0 (сила тяжести поперёк оси известна из машины)

diag-the-force-no-longer-restores-beyond-d9b0 = при деформации больше { $d } сила перестаёт быть восстанавливающей и отталкивает от положения равновесия
diag-valid-to-the-deflection-the-law-7022 = valid_to — деформации, до которой действует закон
diag-softens-c1a5 = мягкая характеристика
diag-this-is-below-check-sign-and-761b = это меньше { $place }; проверьте знак и единицу (N/m^3) или укажите область применимости закона в valid_to
diag-an-isotropic-law-has-the-same-6751 = у изотропного закона { $field } одинаково по x и y
diag-give-one-value-or-use-law-a1f9 = задайте одно значение или law = "per_axis"
diag-a-radial-law-has-no-preload-346e = радиальный закон не имеет предварительного натяга: его зазор не может быть отрицательным
diag-use-law-per-axis-where-a-ac72 = задайте law = "per_axis": там отрицательный зазор означает натяг встречных контактов
diag-a-hertz-contact-without-preload-has-e0b4 = контакт Герца без предварительного натяга не имеет жёсткости в состоянии покоя: задайте амплитуду линеаризации (гармонический расчёт её использует), предварительный натяг (law = "per_axis" с отрицательным зазором) или bearing_cubic, приближённую на нужных амплитудах

diag-a-table-over-speed-has-at-7512 = в таблице по частоте вращения не меньше двух строк; для одной частоты задайте сами коэффициенты
diag-speeds-must-increase-from-row-to-61ab = частоты вращения должны возрастать по строкам: в строке { $number } стоит { $speed } после { $before }
diag-column-speed-e6ee = столбец speed: { $why }
diag-column-has-rows-and-column-speed-849d = в столбце { $name } строк { $values }, в столбце speed { $speed }
diag-column-row-is-not-a-finite-b5da = столбец { $name }: в строке { $number } не конечное число
diag-frequencies-of-vibration-are-not-negative-43a1 = частоты колебаний не бывают отрицательными: в строке { $number } задано { $frequency }
diag-a-table-over-speed-and-frequency-ef2a = в таблице по частоте вращения и частоте колебаний не меньше двух частот колебаний; если коэффициенты от неё не зависят, уберите frequency
diag-a-table-over-speed-and-frequency-9644 = в таблице по частоте вращения и частоте колебаний не меньше двух частот вращения
diag-rows-and-are-of-one-speed-2741 = строки { $first } и { $second } относятся к одной паре частот вращения и колебаний: { $speed } и { $frequency }
diag-every-speed-of-the-table-has-5ca8 = у каждой частоты вращения в таблице есть все частоты колебаний, всего строк { $all }: нет строки { $speed } при { $frequency }
diag-every-speed-of-the-table-has-b24d = у каждой частоты вращения в таблице есть все частоты колебаний, всего строк { $all }: не хватает { $count }, первая из них { $speed } при { $frequency }
diag-is-given-beside-bb0c = { $short } задано вместе с { $twice }
diag-stands-for-and-give-the-one-5d24 = { $short } заменяет { $first } и { $second }: задайте одно это значение или эти два
diag-the-bearing-has-no-coefficient-all-9c73 = у опоры нет коэффициентов: все восемь равны нулю
diag-give-stiffness-or-kxx-and-kyy-27b3 = задайте stiffness, или kxx и kyy (и остальные коэффициенты), или таблицу по частоте вращения
diag-beyond-is-given-without-a-table-38bd = beyond задано без таблицы
diag-constant-coefficients-hold-at-every-speed-c9f6 = постоянные коэффициенты действуют при любой частоте вращения: уберите beyond или задайте таблицу по частоте вращения
diag-is-given-as-a-constant-beside-d5bb = { $name } задано постоянным вместе с таблицей
diag-a-bearing-has-constant-coefficients-or-463b = опора имеет постоянные коэффициенты или таблицу: внесите постоянные в таблицу равными строками
diag-the-coefficients-come-from-the-table-544d = коэффициенты берутся из таблицы: постоянное значение рядом с ней не действует

diag-rotating-damping-must-be-the-same-4a19 = вращающееся демпфирование должно быть одинаковым по x и y
diag-different-values-in-rotating-axes-would-4b5b = при разных значениях во вращающихся осях уравнения машины периодичны по времени
diag-this-damper-was-built-without-tilt-db59 = этот демпфер построен без наклона
diag-an-unbalance-of-a669 = дисбаланс { $u }
diag-sizes-are-positive-phase-180-deg-1024 = значения дисбаланса положительны; phase = "180 deg" меняет направление на противоположное
diag-an-unbalance-has-no-place-4d16 = положение дисбаланса недопустимо
diag-phase-is-an-angle-up-to-6ebd = phase — угол до 1000 rad, высота до 100 m
diag-the-height-of-an-unbalance-acts-aa0a = высота дисбаланса влияет на наклон, а этот диск не наклоняется
diag-give-diametral-inertia-as-well-or-5350 = задайте также diametral_inertia или уберите at
diag-no-body-has-a-polar-inertia-d7e0 = полярный момент инерции тела ({ $polar_inertia }) не может превышать удвоенный экваториальный ({ $diametral_inertia }); для тонкого диска он ровно вдвое больше
diag-acts-on-the-tilt-and-this-25d2 = { $field } влияет на наклон, а этот диск не наклоняется: задайте также diametral_inertia

diag-the-free-surface-radius-lies-outside-6f91 = свободная поверхность (радиус { $value }) лежит вне полости (радиус { $radius })
diag-an-empty-a-partly-filled-and-0108 = пустая, частично заполненная и полная полости — разные машины: постройте каждую отдельно
diag-planar-knows-no-tilt-of-the-902a = модель planar не учитывает наклон полости: для перекошенной полости задайте model = "strip" или "spatial"
diag-a-liquid-with-viscosity-and-one-e51c = жидкость с вязкостью и без вязкости — разные машины: постройте каждую отдельно
diag-this-model-knows-no-viscosity-planar-a984 = эта модель не учитывает вязкость: её учитывают planar, strip и spatial
diag-a-full-cavity-with-viscosity-is-2bad = для полной полости с вязкостью модели нет: уберите вязкость или оставьте в полости немного воздуха
diag-the-viscosity-damps-the-wave-by-4b0e = вязкость сама демпфирует волну: задайте одно из двух
diag-this-model-knows-no-wave-damping-8681 = эта модель не учитывает демпфирование волн: для spatial задайте вязкость
diag-the-free-surface-is-the-inner-bfe9 = свободная поверхность — внутренняя граница слоя у стенки: 0 означает полную полость, радиус полости — пустую
diag-this-is-times-what-the-cavity-e6e6 = это составляет { $fraction } объёма полости
diag-the-cavity-holds-of-this-liquid-6415 = полость вмещает { $cavity }, { $density } этой жидкости
diag-only-odd-harmonics-act-on-a-e4ca = на наклон действуют только нечётные гармоники, и последняя должна быть нечётной
diag-give-axial-harmonics-or-dfc4 = задайте axial_harmonics = { $less } или { $more }
diag-has-no-axial-harmonics-9a50 = у модели { $word } нет осевых гармоник
diag-model-spatial-has-them-leave-axial-677f = они есть у model = "spatial"; в остальных случаях уберите axial_harmonics
diag-without-viscosity-is-exact-in-time-1ca0 = модель { $word } без вязкости точна во временной области
diag-leave-time-error-out-with-model-2e83 = уберите time_error; при model = "spatial" или с вязкостью он определяет число волн
diag-planar-tilt-takes-from-the-tilt-aab4 = planar_tilt вычитает { $taken } из момента инерции наклона полости такой высоты; strip и spatial этого не делают
diag-give-model-strip-or-spatial-or-9e71 = задайте model = "strip" или "spatial" или увеличьте diametral_inertia тела
diag-its-waves-are-computed-up-to-7190 = её волны рассчитываются до axial_harmonics = { $most }; для всех волн уберите axial_harmonics
diag-waves-d3ee = { $n ->
        [one] { $n } волна
        [few] { $n } волны
       *[other] { $n } волн
    }
diag-that-of-a-cavity-that-is-b496 = представление полости с перекосом относительно вала действует только при постоянной частоте вращения
diag-the-layer-of-a-viscous-liquid-2e6d = слой вязкой жидкости зависит от частоты вращения, поэтому его представление строится для одной; transient и basins выполняются при одной
diag-the-layer-of-a-viscous-liquid-1419 = слой вязкой жидкости зависит от частоты вращения, поэтому его представление действует только при постоянной
diag-do-not-give-its-reaction-with-e64e = { $most } не дают его реакции с относительной погрешностью { $allowed }; увеличьте time_error
diag-without-spin-nothing-holds-the-layer-f2d3 = без вращения слой на стенке ничто не удерживает
diag-give-the-study-a-speed-above-e978 = задайте расчёту частоту вращения больше 0; для неподвижной машины model = "frozen" без вязкости учитывает жидкость как массу
diag-try-time-error-64e7 = попробуйте time_error = { $reached }
diag-allow-a-larger-time-error-b71c = увеличьте time_error
diag-do-not-give-its-reaction-on-8989 = { $most } не дают реакции на { $of } с относительной погрешностью { $allowed }; { $larger }{ $strip }
diag-its-reaction-on-cannot-be-computed-87db = реакцию на { $of } нельзя вычислить с точностью до десятой доли допустимой погрешности { $allowed } для всех движений до четырёхкратной частоты вращения{ $strip }
diag-finding-the-form-of-its-reaction-e706 = построение представления реакции на { $of } слишком трудоёмко; увеличьте time_error{ $strip }
diag-displacement-4336 = перемещение
diag-poles-23e2 = { $n ->
        [one] { $n } полюс
        [few] { $n } полюса
       *[other] { $n } полюсов
    }
diag-tilt-023c = наклон
diag-or-model-strip-9bf1 = {" "}или model = "strip"
diag-its-form-in-the-time-domain-7c9b = представление во временной области построено для другой полости; её размер и заполнение здесь нельзя варьировать

diag-a-motor-with-curve-needs-2cf6 = двигателю с curve = "{ $word }" нужно { $name }
diag-add-10f4 = добавьте { $name }
diag-a-motor-with-curve-table-needs-b9a6 = двигателю с curve = "table" нужна таблица
diag-add-table-43fb = добавьте table = {"{"} speed = [..], share = [..] {"}"}
diag-the-torque-cannot-be-interpolated-7b6d = момент нельзя интерполировать: { $why }
diag-speeds-must-increase-from-row-to-ac99 = частоты вращения должны возрастать по строкам
diag-a-table-is-given-beside-curve-91c7 = таблица задана вместе с curve = "{ $word }"
diag-say-curve-table-or-take-the-6386 = задайте curve = "table" или уберите таблицу
diag-the-torque-curve-needs-a-synchronous-b5c7 = для кривой момента нужно synchronous_speed больше 0
diag-limited-power-needs-a-torque-and-2f00 = при ограниченной мощности нужны момент и мощность больше 0
diag-is-given-without-a-diameter-3d73 = { $name } задано без diameter
diag-a-round-shaft-takes-diameter-below-a7a1 = круглому валу задают diameter, below или above либо оба; при заданной жёсткости их не указывают
diag-the-shaft-has-no-stiffness-13d9 = у вала нет жёсткости
diag-give-stiffness-or-the-diameter-of-f6c0 = задайте stiffness или диаметр круглого вала и его длину below или above от точки
diag-a-shaft-with-material-damping-must-c344 = вал с материальным демпфированием должен быть одинаково жёстким по x и y
diag-unequal-stiffness-in-fixed-axes-is-1ae5 = неодинаковая жёсткость в неподвижных осях — свойство невращающейся опоры: поставьте рядом демпфер
diag-cross-stiffness-is-at-most-sqrt-01fb = cross_stiffness не больше sqrt(kx ky) = { $limit }: при большем значении сила отталкивает от положения равновесия
diag-coupling-is-at-most-sqrt-stiffness-3fd0 = coupling не больше sqrt(stiffness tilt_stiffness) = { $limit }: при большем значении изгиб отдавал бы энергию (у заделанного вала 0.87 этого предела)
diag-this-shaft-was-built-without-tilt-fed7 = этот вал построен без наклона
diag-this-shaft-was-built-without-material-7603 = этот вал построен без материального демпфирования
diag-this-shaft-was-built-from-its-1847 = этот вал построен по жёсткости
diag-is-given-beside-the-diameter-of-1b3b = { $name } задано вместе с диаметром круглого вала
diag-the-stiffness-follows-from-the-geometry-5348 = жёсткость определяется геометрией: уберите одно из двух
diag-is-given-without-the-length-5c8d = { $end } задано без длины { $length }
diag-give-as-well-or-take-away-4a55 = задайте также { $length } или уберите { $end }
diag-a-round-shaft-needs-a-length-8bde = круглому валу нужна длина
diag-give-below-the-length-from-its-37dc = задайте below (длина от нижнего конца до точки), above или оба
diag-inner-diameter-is-less-than-diameter-22f4 = inner_diameter должно быть меньше diameter
diag-is-at-least-0bb6 = { $name } не меньше { $value }
diag-this-shaft-was-built-without-bd20 = этот вал построен без { $name }
diag-a-shaft-pinned-at-its-only-7de2 = вал с шарниром на единственном конце ничего не удерживает: заделайте его или задайте второй конец
diag-the-stiffness-of-this-shaft-follows-b189 = жёсткость этого вала определяется его геометрией

diag-the-material-creeps-without-bound-in-8145 = материал неограниченно ползёт: со временем он сохранит 1 - K(0) = { $kept } жёсткости, а эта доля должна оставаться больше 0; это ядро допустимо при амплитуде меньше { $share } заданной
diag-give-amplitude-exponent-and-decay-of-e770 = задайте amplitude, exponent и decay одного слабосингулярного члена, несколько членов или экспоненты
diag-the-memory-of-the-material-is-3490 = память материала задана дважды: { $second } вместе с { $first }
diag-columns-share-and-rate-need-equally-dc8a = в столбцах share и rate должно быть одинаковое число строк, не меньше одной
diag-row-a-share-is-not-negative-fdba = строка { $row }: share не отрицательно, rate лежит от 0 до 1e12 1/s
diag-the-memory-of-the-material-is-6cac = память материала не задана
diag-the-kernel-a-t-a-1-3db1 = ядру A t^(a-1) exp(-b t) вместе с { $given } нужно { $missing }
diag-columns-amplitude-exponent-and-decay-need-7b2b = в столбцах amplitude, exponent и decay должно быть одинаковое число строк, не меньше одной
diag-row-of-the-terms-is-no-14f0 = строка { $number } не задаёт ядра: amplitude не меньше 0, exponent больше 0 и не больше 0.99, decay больше 0
diag-lower-the-amplitude-or-raise-the-adb9 = уменьшите amplitude или увеличьте decay: медленно затухающее ядро релаксирует сильнее
diag-more-than-exponentials-would-be-needed-ac2b = для этого ядра, точности и временной полосы потребовалось бы больше { $most } экспонент
diag-request-less-accuracy-a-narrower-band-022e = снизьте точность, сузьте полосу или задайте более быстрое затухание
diag-the-shaft-has-no-stiffness-give-ad68 = у вала нет жёсткости: задайте её или укажите в supports, как закреплён круглый вал
diag-supports-needs-the-of-the-shaft-8082 = при supports = "{ $word }" нужно { $name } вала
diag-has-no-effect-with-supports-6287 = { $name } не действует при supports = "{ $word }"
diag-the-disc-at-is-not-between-4718 = диск на { $x } не между опорами на расстоянии { $l }
diag-the-exponentials-were-chosen-for-another-1eef = экспоненты подобраны для другого ядра и отклоняются от этого больше заданной точности: постройте машину с ним или расширьте полосу
diag-amplitude-exponent-and-decay-have-no-58ce = amplitude, exponent и decay не действуют вместе с несколькими членами
diag-amplitude-exponent-and-decay-have-no-4e1d = amplitude, exponent и decay не действуют вместе с экспонентами
diag-this-part-does-nothing-give-inertia-1f62 = этот элемент не действует: задайте inertia, drag или windage

# laval-cli
diag-ok-de5c = в порядке: { $machine }
diag-part-193f = { $n } элемент
diag-parts-799d = { $n ->
        [one] { $n } элемент
        [few] { $n } элемента
       *[other] { $n } элементов
    }
diag-coordinate-a21a = { $n } координата
diag-coordinates-ea2c = { $n ->
        [one] { $n } координата
        [few] { $n } координаты
       *[other] { $n } координат
    }
diag-internal-state-da0f = { $n } внутреннее состояние
diag-internal-states-7af1 = { $n ->
        [one] { $n } внутреннее состояние
        [few] { $n } внутренних состояния
       *[other] { $n } внутренних состояний
    }
diag-no-studies-e162 = расчётов нет
diag-is-a-folder-not-a-machine-7bfd = { $path } — папка, а не файл машины
diag-give-the-file-20d8 = укажите файл: { $inside }
diag-is-larger-than-64-mb-6cae = { $path } больше 64 МБ
diag-there-is-no-file-33b6 = файла { $path } нет
diag-laval-new-writes-a-machine-file-4dc1 = laval new создаёт файл машины для начала работы
diag-laval-this-is-a-defect-of-ae66 = laval: это ошибка программы, а не вашего файла. Сообщите о ней, приложив файл машины и сообщение выше
diag-templates-877f = шаблоны: { $all }
diag-there-is-no-template-a3c1 = шаблона { $word } нет
diag-exists-and-is-not-overwritten-c379 = { $path } уже есть и не перезаписывается
diag-name-another-file-with-out-8c40 = укажите другой файл в --out
diag-no-chromium-was-found-to-print-c305 = Chromium для печати отчёта не найден
diag-install-one-of-or-open-in-6eb6 = установите одну из программ { $names } или откройте { $page } в браузере и напечатайте
diag-could-not-print-the-report-90eb = { $browser }: напечатать отчёт не удалось: { $why }
diag-done-a112 = выполнено { $percent } %
diag-1-step-done-2d12 = выполнен 1 шаг
diag-steps-done-0233 = выполнено шагов: { $steps }
diag-about-left-b4f4 = { $done }, осталось около { $left }
diag-computing-for-ab42 = идёт расчёт, прошло { $time }
diag-after-7501 = { $done }, прошло { $time }
diag-s-b884 = { $n } с
diag-min-4434 = { $n } мин
diag-h-76f9 = { $n } ч
diag-days-910f = { $n } сут
diag-contains-no-study-e25a = { $file } не содержит расчётов
diag-add-a-study-block-laval-studies-c25e = добавьте блок [[study]]; виды расчётов показывает laval studies
diag-its-studies-2ae7 = его расчёты: { $all }
diag-the-machine-has-no-study-1dcb = в машине нет расчёта «{ $word }»
diag-stopping-ctrl-c-again-stops-at-3a4d = остановка; повторное Ctrl-C прервёт расчёт сразу
diag-warning-ctrl-c-will-stop-at-f5b8 = предупреждение: Ctrl-C прервёт расчёт сразу, незаписанное будет потеряно ({ $e })
diag-not-run-3464 = не выполнено: { $left }
diag-warning-also-holds-results-of-study-0789 = предупреждение: { $out } содержит также результаты расчёта { $names } от прежнего файла машины
diag-warning-also-holds-results-of-studies-8275 = предупреждение: { $out } содержит также результаты расчётов { $names } от прежнего файла машины
diag-pdf-prints-report-html-which-format-eca7 = --pdf печатает report.html, а --format его исключает
diag-laval-study-has-no-result-1a9b = laval: у расчёта «{ $name }» нет результата
diag-laval-7bec = laval: { $why }
diag-there-is-no-kind-of-called-63a8 = вида { $word } ({ $what }) нет
diag-laval-cannot-write-to-standard-output-26ab = laval: запись в стандартный вывод невозможна: { $e }

# laval/src/outcome, output_folder, report, store
diag-the-end-bff1 = конец
diag-in-the-table-1bb6 = { $name } в таблице { $table }
diag-column-of-table-has-rows-the-d4c8 = в столбце `{ $column }` таблицы `{ $table }` строк { $found }, в столбцах перед ним { $expected }
diag-is-no-finite-number-6158 = { $what } не является конечным числом
diag-two-s-are-named-baa3 = имя `{ $name }` встречается дважды ({ $what })
diag-figure-needs-which-is-missing-0bb0 = рисунку `{ $figure }` нужно { $expected } `{ $table }`, этого нет
diag-figure-needs-in-table-137d = рисунку `{ $figure }` нужно { $expected } `{ $column }` в таблице `{ $table }`
diag-the-result-cannot-be-computed-16f8 = результат вычислить нельзя: { $e }
diag-a-value-of-the-machine-or-bcfe = одно из значений машины или расчёта слишком велико или слишком мало
diag-the-study-s-result-is-inconsistent-dc5b = результат расчёта противоречив: { $e }
diag-it-is-a-file-e707 = это файл
diag-cannot-make-the-folder-4dd9 = папку { $folder } создать не удалось: { $why }
diag-name-another-one-with-out-d81d = укажите другую в --out
diag-cannot-write-f8b7 = записать { $path } не удалось: { $e }
diag-mend-the-permissions-of-the-folder-8e1f = исправьте права доступа к папке или укажите другую в --out
diag-was-not-made-by-this-program-0488 = { $path } создано не этой программой и оставлено без изменений
diag-move-it-elsewhere-or-name-another-3b1e = переместите это в другое место или укажите другую папку в --out
diag-another-process-is-writing-into-92c3 = в { $folder } пишет другой процесс
diag-another-process-number-is-writing-into-7450 = в { $folder } пишет другой процесс (номер { $number })
diag-wait-until-it-has-ended-or-add0 = дождитесь его завершения или укажите другую папку в --out
diag-is-where-results-are-to-be-4cdb = на месте { $path }, куда записываются результаты, стоит { $what }
diag-a-file-of-another-program-48c0 = файл другой программы
diag-a-folder-3924 = папка
diag-no-folder-511c = не папка
diag-cannot-write-581b = записать { $path } не удалось: { $source }
diag-cannot-write-1-file-written-before-39ef = записать { $path } не удалось: { $source } (записанный до этого 1 файл полон)
diag-cannot-write-files-written-before-it-09e7 = записать { $path } не удалось: { $source } (записанные до этого файлы полны: { $n })
diag-study-2678 = расчёт `{ $study }`: { $source }
diag-a-chunk-of-rows-and-columns-2774 = блок из { $rows } строк и { $columns } столбцов рассчитан как { $found }
diag-cannot-remove-7a2c = удалить { $path } не удалось: { $e }
diag-was-not-written-by-this-program-ed9c = { $path } записано не этой программой
diag-move-it-elsewhere-or-give-the-a880 = переместите это в другое место или укажите для результатов другую папку в --out
diag-is-no-manifest-of-this-program-a5a1 = { $path } не является описью этой программы: { $why }
diag-give-the-results-another-folder-with-e621 = укажите для результатов другую папку в --out или начните заново с --fresh (содержимое папки удаляется)
diag-its-format-is-this-program-writes-7167 = её формат { $found }, эта программа пишет формат { $own }
diag-its-format-is-none-this-program-4126 = её формат не указан, эта программа пишет формат { $own }
diag-the-order-of-its-blocks-f191 = порядок блоков
diag-and-more-2ac0 = и ещё { $more }
diag-holds-results-of-another-build-of-dcdb = { $path } содержит результаты другой сборки программы или другого процессора: { $all }
diag-holds-results-of-another-input-472e = { $path } содержит результаты для других исходных данных: { $all }
diag-give-the-new-results-another-folder-4370 = укажите для новых результатов другую папку в --out или начните заново с --fresh (прежние результаты удаляются)
diag-missing-b4f3 = отсутствует
diag-damaged-72ee = повреждено
diag-is-rows-to-are-computed-again-50b5 = { $path }: { $why }; строки с { $first } по { $last } рассчитываются заново
diag-not-of-this-study-f8d5 = не от этого расчёта
diag-chunk-cannot-be-written-as-parquet-3b0c = блок { $index } записать в Parquet не удалось: { $e }
diag-cannot-read-9ee9 = прочитать { $path } не удалось: { $e }
diag-the-manifest-cannot-be-written-2360 = записать опись не удалось: { $e }
diag-cannot-write-of-chunks-are-complete-f917 = записать { $path } не удалось: { $e }; готовы и сохранены { $kept } из { $all } блоков
diag-make-room-or-mend-the-folder-66a3 = освободите место или исправьте папку и повторите ту же команду: расчёт продолжится с этого места
diag-name-another-folder-with-out-b101 = укажите другую папку в --out
diag-not-given-e003 = не задано
diag-was-now-babc = { $what }: было { $old }, теперь { $new }
diag-a-study-needs-at-least-one-c0d9 = расчёту нужны хотя бы одна строка, одна строка в блоке и один столбец
diag-rows-in-chunks-of-are-more-d0c6 = { $rows } строк блоками по { $chunk } — больше { $most } блоков
diag-two-columns-are-named-f7a1 = два столбца имеют имя «{ $name }»
diag-this-build-cannot-write-parquet-which-dbd2 = эта сборка не пишет Parquet, в котором хранятся длинные расчёты
diag-there-is-no-column-4824 = столбца «{ $column }» нет

# laval/src/study: centrifuge
diag-the-tube-holds-no-liquid-its-6763 = в пробирке нет жидкости: её поверхность лежит у дна или ниже
diag-measure-surface-and-length-from-the-42d5 = отсчитывайте surface и length от горловины
diag-the-centre-of-mass-lies-far-8fab = центр масс лежит намного ниже дна пробирки
diag-measure-it-from-the-mouth-with-8dfb = отсчитывайте его от горловины, с содержимым
diag-the-tube-reaches-across-the-spin-499b = пробирка пересекает ось вращения
diag-increase-mouth-radius-fce8 = увеличьте mouth_radius
diag-inner-radius-must-be-smaller-than-25c4 = inner_radius должно быть меньше outer_radius
diag-exchange-them-3e47 = поменяйте их местами
diag-the-liquid-s-surface-must-lie-5953 = поверхность жидкости должна лежать внутри барабана: surface_radius меньше bowl_radius
diag-the-surface-is-the-inner-face-68b0 = поверхность — внутренняя граница жидкости
diag-how-far-the-cup-swings-out-dd7a = отклонение стакана зависит от его центра масс, а он не задан
diag-add-centre-of-mass-60-mm-c3bc = добавьте centre_of_mass = "60 mm" (от шарнира, с содержимым) или закрепите стакан под углом
diag-a-moment-of-inertia-needs-the-c51e = моменту инерции нужна масса, к которой он относится
diag-add-mass-bcf9 = добавьте mass
diag-no-body-has-these-second-moments-f674 = такие моменты инерции относительно шарнира невозможны
diag-moment-along-is-at-least-mass-d9e1 = moment_along не меньше mass, умноженного на квадрат centre_of_mass; квадрат moment_product не больше moment_along, умноженного на moment_across
diag-the-cup-holds-no-liquid-its-de84 = в стакане нет жидкости: её поверхность лежит у дна или ниже
diag-measure-surface-and-bottom-from-the-e09d = отсчитывайте surface и bottom от шарнира наружу
diag-the-centre-of-mass-lies-from-b498 = центр масс лежит на { $along } от шарнира, намного ниже дна стакана ({ $bottom })
diag-measure-both-from-the-hinge-7e75 = отсчитывайте оба от шарнира
diag-the-centre-of-mass-lies-outside-6a05 = центр масс лежит вне стакана
diag-at-most-cup-radius-to-either-3b6a = по обе стороны от его оси не больше cup_radius
diag-the-surface-of-the-liquid-reaches-d8a6 = поверхность жидкости пересекает ось вращения при отклонённом стакане
diag-increase-hinge-radius-772a = увеличьте hinge_radius
diag-cups-with-an-inner-radius-of-c132 = стаканы с внутренним радиусом { $inner } (их число { $count }) в висячем положении пересекаются
diag-cups-with-an-inner-radius-of-fb5e = стаканы с внутренним радиусом { $inner } (их число { $count }) при наклоне { $tilt } пересекаются
diag-is-at-least-for-of-them-dc43 = { $field } не меньше { $least } при числе стаканов { $count }, без учёта стенок; или уменьшите число в count
diag-which-carries-it-does-not-exist-4469 = несущего тела «{ $name }» нет
diag-has-no-mass-of-its-own-2665 = у «{ $name }» нет собственной массы, к которой можно прибавить стаканы
diag-has-no-unbalance-of-its-own-02c9 = у «{ $name }» нет собственного дисбаланса, к которому можно прибавить стаканы
diag-attach-the-cups-to-a-disc-1150 = закрепите стаканы на диске
diag-what-loads-a-body-needs-mass-c12e = для нагрузки на тело нужны mass и centre_of_mass
diag-add-both-with-contents-or-leave-f30c = добавьте оба, с содержимым, или уберите on
diag-values-are-given-for-cups-f8d1 = задано значений: { $given }, стаканов: { $count }
diag-give-one-for-each-0-for-ec2c = задайте по одному для каждого, 0 для стаканов без отличий
diag-a-centre-of-mass-would-lie-abc7 = один из центров масс оказался бы у шарнира или за ним
diag-differences-are-small-against-centre-of-e735 = отличия должны быть малы по сравнению с centre_of_mass
diag-a-cup-would-weigh-less-than-81ed = масса одного из стаканов оказалась бы отрицательной
diag-a-missing-cup-is-minus-its-dac8 = отсутствующий стакан — это минус его масса
diag-a-viscosity-in-the-table-is-2768 = в таблице есть вязкость не больше нуля
diag-check-the-column-and-its-unit-81c4 = проверьте столбец и его единицу
diag-the-viscosity-table-goes-from-k-9d41 = таблица вязкости охватывает значения от { $low } K до { $high } K; для { $t } K данных нет
diag-extend-the-table-viscosity-is-not-baa6 = расширьте таблицу: вязкость не экстраполируется
diag-give-temperatures-in-increasing-order-7f7b = задайте температуры по возрастанию
diag-a-viscosity-table-needs-the-temperature-23e1 = для таблицы вязкости нужна температура разделения жидкости
diag-add-temperature-60-degc-e709 = добавьте temperature = "60 degC"
diag-both-viscosity-and-viscosity-table-are-815f = заданы и viscosity, и viscosity_table
diag-keep-one-of-them-c17f = оставьте одно из двух
diag-the-viscosity-of-the-liquid-is-2fd6 = не задана вязкость жидкости
diag-add-viscosity-1-mpa-s-or-7227 = добавьте viscosity = "1 mPa s" или viscosity_table и temperature
diag-the-size-of-the-particles-is-30da = не задан размер частиц
diag-the-sizes-are-given-in-several-7b62 = размеры заданы несколькими способами: { $given }
diag-say-one-of-diameter-median-diameter-f077 = задайте одно: diameter; median_diameter с geometric_deviation; characteristic_diameter с spread; sizes
diag-needs-beside-it-6e09 = вместе с { $way } нужно { $field }
diag-add-7c9e = добавьте { $field }
diag-a-powder-needs-either-undersize-or-49e9 = порошку нужны для его диаметров либо undersize, либо share
diag-sizes-6b6c = sizes = {"{"} diameter = [..], undersize = [..] {"}"}
diag-the-densities-are-given-in-two-09e3 = плотности заданы двумя способами
diag-keep-densities-or-density-deviation-6dc6 = оставьте densities или density_deviation
diag-densities-3bfb = densities = {"{"} density = [..], share = [..] {"}"}
diag-there-is-no-cup-named-acf8 = стакана с именем «{ $name }» нет
diag-cups-of-this-machine-27de = стаканы этой машины: { $names }
diag-this-machine-has-several-cups-2aed = в этой машине несколько стаканов
diag-add-cup-with-one-of-031d = добавьте cup = .. с одним из имён { $names }
diag-this-machine-has-nothing-that-separates-3ac4 = в этой машине нет разделяющего устройства
diag-add-a-block-cup-with-kind-40e1 = добавьте блок [[cup]] с kind = "swinging", "fixed_angle", "tubular_bowl", "disc_stack" или "decanter"
diag-this-machine-has-nothing-to-separate-394f = в этой машине нечего разделять
diag-add-a-block-suspension-with-liquid-03ca = добавьте блок [suspension] с liquid_density, viscosity, particle_density и diameter

diag-the-time-in-which-the-cups-9fc8 = нужно время, за которое стаканы должны завершить разделение
diag-add-time-30-min-1419 = добавьте time = "30 min"
diag-liquid-flows-through-its-throughput-is-8a11 = через «{ $name }» течёт жидкость: нужна производительность, а не время
diag-add-throughput-500-l-h-and-bb7c = добавьте throughput = "500 l/h" и уберите time
diag-nothing-flows-through-9d8a = через «{ $name }» жидкость не течёт
diag-give-time-10-min-instead-dae6 = задайте вместо этого time = "10 min"
diag-a-decanter-is-counted-by-its-261e = декантер рассчитывается по Sigma, определённой только для сопротивления Стокса
diag-use-drag-stokes-in-suspension-or-3b00 = задайте в [suspension] drag = "stokes" или используйте tubular_bowl с той же Sigma
diag-particles-and-liquid-have-the-same-cff9 = плотности частиц и жидкости равны: разделения нет
diag-give-particle-density-another-value-than-a77a = задайте particle_density, отличное от liquid_density
diag-particles-of-do-not-fit-into-38bc = частицы размером { $size } не помещаются в «{ $name }» шириной { $wide }
diag-check-the-unit-of-the-diameter-dbc5 = проверьте единицу диаметра в [suspension]
diag-the-path-of-a-particle-could-e89c = траекторию частицы рассчитать не удалось: { $why }
diag-a-particle-that-moves-much-faster-ed21 = для частицы, которая движется намного быстрее вращения стакана, нужно drag = "schiller_naumann"
diag-the-machine-with-what-it-has-9372 = машины с отделённым в ней осадком не существует: { $why }
diag-speeds-to-evaluate-and-more-where-773d = частот вращения для расчёта и дополнительные там, где отклик меняется
diag-turns-of-the-rotor-to-integrate-afa3 = оборотов ротора для интегрирования при моделировании прохождения резонансов
diag-give-the-ramp-another-duration-60fd = задайте другую длительность разгона
diag-the-passage-could-not-be-computed-78f4 = прохождение резонансов рассчитано только до { $speed }
diag-shorten-the-ramp-or-the-range-4b36 = сократите разгон или диапазон частот вращения; перемещения машины, неустойчивой ниже окна, могут расти неограниченно
diag-begin-at-a-low-speed-such-c83d = начинайте с низкой частоты вращения, например с десятой доли наибольшей
diag-the-range-of-speeds-must-begin-f56a = диапазон частот вращения должен начинаться выше нуля
diag-write-uncertain-8963 = напишите uncertain = {"{"} suspension.viscosity = "20 %" {"}"}
diag-which-parameters-are-uncertain-is-missing-54c5 = не указано, какие параметры неопределённые
diag-uncertain-parameters-are-too-many-every-d443 = неопределённых параметров слишком много ({ $found }): рассчитывается каждое сочетание крайних значений
diag-keep-at-most-five-c64b = оставьте не больше пяти
diag-a-time-or-throughput-needs-something-af88 = для времени или производительности нужны разделяемая суспензия и разделяющее устройство
diag-add-the-blocks-cup-and-suspension-053e = добавьте блоки [[cup]] и [suspension]
diag-the-run-up-to-the-top-68a1 = разгон до верхней границы диапазона занимает { $ramp }, больше располагаемого времени { $time }, которое отсчитывается от его начала
diag-give-a-shorter-ramp-a-lower-8b36 = задайте более короткий разгон, более низкую верхнюю границу или больше времени; при count_ramp = false время отсчитывается от конца разгона
diag-add-ramp-60-s-the-time-db06 = добавьте ramp = "60 s": время до верхней границы диапазона частот вращения
diag-the-state-that-a-run-up-6a0f = для состояния после разгона нужно время разгона
diag-the-limits-on-the-passage-need-c4b8 = для пределов при прохождении резонансов нужно время разгона
diag-there-is-no-separation-whose-time-37dc = нет разделения, время которого можно сделать наименьшим
diag-add-cup-suspension-and-time-throughput-fb74 = добавьте [[cup]], [suspension] и time (throughput, если жидкость проточная)
diag-no-limit-on-vibration-is-given-8f35 = не задан предел вибрации, с которым сравниваются амплитуды
diag-add-displacement-velocity-tilt-force-or-cb12 = добавьте в [limits] displacement, velocity, tilt, force или moment
diag-what-the-study-requires-of-the-db03 = требования расчёта не согласованы со стаканами и суспензией машины
diag-the-stability-of-a-steady-state-99a6 = устойчивость установившегося состояния оценить нельзя: { $why }
diag-a-steady-state-cannot-be-evaluated-0b1c = установившееся состояние рассчитать нельзя: { $e }
diag-numbers-of-539d = числа «{ $name }»: { $own }
diag-cannot-be-b533 = { $path }: значение { $value } недопустимо
diag-has-no-number-to-vary-071a = у «{ $name }» нет числа { $field }, которое можно варьировать
diag-give-it-a-value-in-its-ae9c = сначала задайте ему значение в его блоке
diag-paths-of-particles-to-integrate-roughly-2ddf = траекторий частиц для интегрирования, приблизительно
diag-a-programme-begins-at-time-0-7c07 = программа начинается в момент 0, вращение идёт в одну сторону и к концу не прекращается
diag-the-last-speed-is-held-c274 = последняя частота вращения сохраняется
diag-give-times-in-increasing-order-c8b3 = задайте моменты времени по возрастанию
diag-both-a-programme-and-a-ramp-0676 = заданы и программа, и разгон
diag-release-0-mm-20-mm-0-a72d = release = ["0 mm", "20 mm", "0 mm"]
diag-a-place-has-three-components-not-e4ba = у места три составляющие, задано { $n }
diag-release-velocity-0-m-s-0-3bd1 = release_velocity = ["0 m/s", "0.1 m/s", "0 m/s"]
diag-a-velocity-has-three-components-not-760c = у скорости три составляющие, задано { $n }
diag-a-velocity-belongs-to-a-particle-bd64 = скорость задаётся выпущенной частице
diag-add-release-0-mm-20-mm-ac24 = добавьте release = ["0 mm", "20 mm", "0 mm"]
diag-a-particle-whose-drag-balances-the-2608 = частица, у которой сопротивление уравновешивает поле, не имеет собственной начальной скорости
diag-take-it-out-or-take-model-988f = уберите её или задайте model = "exact"
diag-a-run-up-needs-two-different-e12f = разгону нужны две разные частоты вращения; этот начинается и кончается на нуле
diag-give-another-speed-or-leave-ramp-df25 = задайте другую частоту вращения или уберите ramp
diag-liquid-flows-through-this-machine-which-9d11 = машина проточная, и жидкость подаётся на рабочей частоте вращения: учитывать разгон не нужно
diag-leave-it-out-7b2b = уберите это
diag-the-run-up-takes-longer-than-c0f0 = разгон занимает { $ramp }, больше располагаемого времени { $time }: частота вращения не достигается
diag-give-a-shorter-ramp-or-more-719c = задайте более короткий разгон или больше времени
diag-one-particle-can-be-followed-in-007a = траектория одной частицы рассчитывается только в стаканах и пробирках
diag-leave-release-out-355c = уберите release
diag-no-particle-finds-liquid-in-this-b6b2 = в этой пробирке нет жидкости, в которой могли бы двигаться частицы
diag-lower-surface-or-raise-length-f51b = уменьшите surface или увеличьте length
diag-making-the-time-form-of-6c7f = построение представления во временной области для { $names }
diag-the-study-was-stopped-within-a-cbf2 = расчёт остановлен внутри вычисления, у которого нет частичного результата

# laval/src/study: linear
diag-no-part-of-this-machine-has-b90f = ни у одного элемента этой машины нет аппроксимации для сравнения
diag-parts-with-waves-without-number-have-9300 = она есть у элементов с непрерывным спектром волн; в остальных случаях уберите compare
diag-the-approximation-is-no-machine-47ae = аппроксимация не образует машину: { $why }
diag-leave-compare-out-5311 = уберите compare
diag-speeds-at-which-roots-are-counted-0176 = частот вращения, при которых корни подсчитываются последовательно
diag-eigenvalue-problems-to-solve-3ff3 = задач на собственные значения для решения
diag-modes-shows-the-modes-at-one-aec9 = { $help }; моды при одной частоте вращения показывает modes
diag-flutter-is-for-machines-that-nothing-8c74 = flutter предназначен для машин без демпфирования и привода; в этой машине демпфирование есть
diag-set-all-damping-to-0-or-3e29 = приравняйте всё демпфирование к 0 или задайте criterion = "growth" с growth_threshold
diag-no-part-of-this-machine-has-754c = ни у одного элемента этой машины нет потерь (таких как вязкость), к которым относится этот критерий
diag-give-one-a-viscosity-or-take-ccca = задайте одному из элементов вязкость или criterion = "growth" с growth_threshold
diag-no-body-of-this-machine-moves-0be8 = ни одно тело этой машины не движется поперёк оси
diag-responses-at-speeds-of-coordinates-ffcf = отклики (частот вращения: { $speeds }, координат: { $n })
diag-give-the-range-fewer-points-where-a938 = задайте диапазону меньше точек: там, где отклик меняется резко, сетка уточняется без них
diag-nothing-forces-this-machine-at-the-bc0c = эту машину на частоте вращения ничто не возбуждает
diag-give-a-disc-an-eccentricity-an-cc3c = задайте диску эксцентриситет, дисбаланс или перекос
diag-speeds-to-solve-for-and-more-309f = частот вращения для расчёта и дополнительные там, где отклик меняется резко
diag-terms-of-series-in-every-evaluation-3314 = членов ряда в каждом вычислении функции, корни которой подсчитываются
diag-a-map-of-by-points-is-6344 = карта из { $speeds } на { $values } точек слишком велика
diag-at-most-points-in-all-2d77 = всего не больше { $most } точек
diag-the-machine-does-not-exist-at-46f1 = при { $path } = { $x } машины не существует: { $why }
diag-narrow-the-range-of-the-parameter-aa3f = сузьте диапазон параметра

# laval/src/study: motion
diag-must-name-one-initial-value-beside-a61c = { $field }: вместе с разгоном нужно назвать одно начальное значение; названо { $given }
diag-must-name-two-initial-values-it-6efa = { $field }: нужно назвать два начальных значения; названо { $given }
diag-write-1-rad-8cd7 = напишите { $field } = {"{"} "{ $mass }" = "1 rad" {"}"}
diag-write-x-1-mm-32e6 = напишите { $field } = {"{"} "{ $body }.x" = "1 mm" {"}"}
diag-write-x-1-mm-y-1-3c85 = напишите { $field } = {"{"} "{ $body }.x" = "1 mm", "{ $body }.y" = "1 mm" {"}"}
diag-to-names-but-from-names-7aff = в to названо { $to }, а в from названо { $from }
diag-both-name-the-same-a658 = названия в обоих должны совпадать
diag-must-go-from-a-lower-to-d49b = «{ $name }» должно идти от меньшего значения к большему
diag-a-grid-of-by-points-is-75a7 = сетка из { $first } на { $second } точек слишком велика
diag-points-must-be-whole-numbers-from-9f75 = points — целые числа от 2 до { $most }, задано { $x }
diag-points-names-which-is-not-varied-9569 = в points названо «{ $n }», которое не варьируется
diag-varied-are-2f80 = варьируются { $names }
diag-starts-followed-beforehand-then-those-of-0602 = начальных условий прослеживаются заранее, затем начальные условия карты
diag-motions-to-follow-until-their-masses-76f2 = движений для прослеживания до покоя шариков или до установившегося движения
diag-basins-need-a-speed-above-there-e9a5 = для basins нужна частота вращения больше { $least }: в покое периода нет
diag-a-run-up-makes-no-difference-e5b8 = разгон при { $speed } не влияет: в этой машине нет шариков, обращающихся в осях, вращающихся вместе с ней
diag-leave-run-up-out-90f9 = уберите run_up
diag-the-spin-of-this-machine-is-c90d = вращение этой машины свободно: частоты вращения, при которой движения устанавливаются, нет
diag-leave-drive-free-out-or-follow-efcb = уберите drive = "free" или рассчитайте движение расчётом transient
diag-motions-to-follow-cells-and-the-b5b2 = { $count } движений для прослеживания (ячеек { $cells } и невозмущённое начальное условие), каждое не больше { $turns } оборотов: { $what }, поэтому длительность установления неизвестна
diag-motions-to-follow-until-they-repeat-fe68 = движений для прослеживания до повторения
diag-at-rest-a-mode-of-this-c2da = около положения равновесия мода этой машины растёт с инкрементом { $growth }
diag-at-rest-a-mode-of-this-8b63 = около положения равновесия мода этой машины не растёт и не затухает
diag-the-modes-of-this-machine-at-bdf2 = моды этой машины около положения равновесия неизвестны
diag-the-attractors-are-not-those-of-fdb9 = аттракторы относятся к другим движениям
diag-output-times-of-coordinates-d440 = результаты (моментов вывода: { $outputs }, координат: { $n })
diag-give-fewer-points-a-longer-output-6e5a = задайте меньше точек (больший output_step) или уберите velocities и observables
diag-the-study-was-stopped-before-its-ea66 = расчёт остановлен до построения машины во временной области
diag-turns-of-the-rotor-to-integrate-2fed = оборотов ротора для интегрирования, { $duration }
diag-both-a-range-of-speeds-and-8fcf = заданы и диапазон частот вращения, и параметр по x
diag-say-one-or-the-other-5112 = задайте одно из двух
diag-a-map-of-two-parameters-needs-75f7 = для карты по двум параметрам нужна частота вращения больше нуля
diag-add-speed-3000-rpm-here-or-39c1 = добавьте speed = "3000 rpm" здесь или в [machine]
diag-and-are-the-same-parameter-dc84 = «{ $first }» и «{ $second }» — один и тот же параметр
diag-is-no-value-9845 = { $path }: { $x } не является допустимым числом
diag-the-grid-has-more-points-than-9c74 = в сетке больше точек, чем можно сосчитать
diag-the-values-of-a-list-lie-32f5 = значения списка хранятся в папке его вариантов
diag-the-design-has-no-case-22d6 = план не содержит ни одного варианта
diag-cases-are-more-than-can-be-6c04 = вариантов { $cases } — больше, чем можно пронумеровать
diag-is-damaged-6361 = { $path }: файл повреждён
diag-parameters-are-more-than-the-dimensions-aac5 = параметров { $k } — больше, чем размерностей последовательности Соболя ({ $most })
diag-the-machine-has-no-study-026d = у машины нет расчёта «{ $name }»
diag-stopped-before-the-first-case-3403 = остановлено до первого варианта
diag-the-study-has-no-numbers-for-11b4 = расчёт не даёт чисел для этой машины: { $why }
diag-belongs-to-another-study-another-build-5178 = { $path } относится к другому расчёту, другой сборке или другому процессору
diag-vary-two-parameters-e3b5 = варьируйте два параметра
diag-a-map-of-by-motions-is-21b0 = карта из { $a } на { $b } движений слишком велика
diag-at-most-motions-in-all-6722 = всего не больше { $most } движений
diag-this-study-needs-a-range-of-c0d9 = этому расчёту нужен диапазон частот вращения
diag-add-speed-or-a-speed-to-16b1 = добавьте speed = {"{"} from = "1000 rpm", to = "5000 rpm" {"}"} или частоту вращения в [machine]
diag-or-give-x-a-second-parameter-93d9 = { $help }, или задайте по x второй параметр: тогда частота вращения везде одинакова
diag-a-map-needs-speeds-above-there-fb49 = для карты нужны частоты вращения больше { $least }: в покое периода нет
diag-a-state-of-coordinates-and-internal-7bda = состояние (координат: { $coordinates }, внутренних состояний: { $states }) не относится к этой машине (координат: { $n }, внутренних состояний во временной области: { $m })
diag-continue-from-a-motion-of-the-8d3a = продолжайте с движения той же машины
diag-the-spin-of-this-machine-is-d361 = вращение этой машины свободно и не может следовать программе
diag-use-a-transient-study-or-take-56cc = используйте расчёт transient или уберите свободный привод
diag-the-times-must-begin-at-0-0bad = моменты времени должны начинаться с 0
diag-both-a-programme-and-are-given-4c93 = заданы и программа, и { $given }
diag-how-long-the-change-of-speed-5c35 = не задана длительность изменения частоты вращения
diag-add-duration-10-s-or-a-7616 = добавьте duration = "10 s" или программу из моментов времени и частот вращения
diag-both-a-polynomial-and-to-are-f613 = заданы и многочлен, и to
diag-neither-the-study-nor-the-machine-29cc = ни в расчёте, ни в машине не указана конечная частота вращения
diag-add-to-3000-rpm-0fb7 = добавьте to = "3000 rpm"
diag-from-and-to-are-both-2250 = from и to равны { $speed }
diag-this-stays-at-5025 = заданное { $field } всё время равно { $speed }
diag-from-and-the-speed-of-the-93ff = from и частота вращения машины равны { $speed }
diag-a-run-up-needs-two-different-5573 = разгону нужны две разные частоты вращения; { $said }
diag-give-another-speed-or-take-a-94e2 = задайте другую частоту вращения или, при постоянной, используйте расчёт transient
diag-there-is-fac5 = имеется { $known }
diag-there-is-no-body-96f6 = тела «{ $name }» нет
diag-spectra-up-to-order-of-this-f7e0 = для спектров этой записи до порядка { $highest } нужно отсчётов { $total }, это слишком много
diag-at-most-lower-highest-order-or-75cb = не больше { $most }: уменьшите highest_order или рассчитайте более короткое движение
diag-there-is-no-coordinate-or-state-1f90 = координаты или состояния «{ $name }» нет
diag-is-it-must-lie-between-and-e08b = «{ $name }» = { $value }; допустимо от { $least } до { $most } в единицах СИ
diag-is-given-twice-6139 = «{ $name }» задано дважды
diag-has-ebf9 = у «{ $part }» есть { $own }
diag-this-machine-has-58cb = в этой машине есть { $names }
diag-there-is-no-column-4b0b = столбца «{ $name }» нет
diag-at-one-speed-nonlinear-response-finds-425e = { $help }; при одной частоте вращения установившиеся движения находит nonlinear_response, а исход движения от начального условия — basins и transient
diag-a-sweep-needs-speeds-above-there-49bc = для sweep нужны частоты вращения больше { $least }: в покое периода нет
diag-motions-with-numbers-each-a1ca = движения (их число { $rows }, чисел в каждом { $columns })
diag-give-the-range-fewer-points-or-9d64 = задайте диапазону меньше точек или уберите waterfall
diag-the-spin-of-this-machine-is-9eab = вращение этой машины свободно: собственной частоты вращения для прохождения диапазона у неё нет
diag-is-no-displacement-or-tilt-of-e52c = «{ $name }» — не перемещение и не наклон тела
diag-name-one-such-as-0026 = назовите одно, например { $known }
diag-neither-the-study-nor-the-machine-bf96 = ни в расчёте, ни в машине не указана частота вращения
diag-add-speed-3000-rpm-to-machine-1ffb = добавьте speed = "3000 rpm" в [machine] или в расчёт
diag-a-kick-changes-rates-only-2906 = удар меняет только скорости
diag-name-rates-with-such-as-drum-cc29 = называйте скорости с ', например "drum.x'"
diag-the-kick-at-comes-after-the-1d6d = удар при { $at } наступает после конца при { $duration }
diag-outputs-are-too-many-cef8 = { $step } моментов вывода слишком много
diag-at-most-1000000-outputs-a3ad = не больше 1000000 моментов вывода
diag-both-output-step-and-points-are-e4e5 = заданы и output_step, и points
diag-the-duration-must-be-positive-3a15 = длительность должна быть положительной

# laval/src/study: nonlinear
diag-amplitude-must-go-from-a-lower-9ac3 = amplitude должно идти от меньшего значения к большему
diag-exchange-from-and-to-b115 = поменяйте местами from и to
diag-the-range-of-speeds-comes-too-4b94 = диапазон частот вращения слишком близко подходит к нулю, где дисбаланс не действует
diag-keep-both-ends-above-or-both-75ce = держите оба конца выше { $slowest } или, для обратного вращения, оба ниже { $lowest }
diag-the-response-at-values-is-too-4ab4 = отклик при { $points } значениях слишком объёмен
diag-points-is-the-number-of-values-4cb3 = points — число значений, от которых начинаются кривые: не больше { $most }
diag-a-steady-response-is-computed-at-5056 = установившийся отклик рассчитывается при постоянной частоте вращения, а вращение этой машины свободно
diag-prescribe-the-speed-of-the-machine-c769 = задайте частоту вращения машины: уберите свободный привод
diag-the-machine-does-not-exist-at-0b99 = машины не существует ни при одном из опробованных значений { $path }; при { $at }: { $why }
diag-the-stability-of-this-machine-s-7f76 = устойчивость движений этой машины оценить нельзя: { $why }
diag-kinds-folds-needs-no-stability-641f = для kinds = "folds" устойчивость не нужна
diag-free-whirls-are-sought-at-constant-efd0 = свободные движения ищутся при постоянной частоте вращения, а вращение этой машины свободно
diag-prescribe-the-speed-of-the-machine-cac7 = задайте частоту вращения машины (уберите свободный привод) или рассчитайте свободную машину во времени расчётом transient
diag-the-methods-are-compared-at-constant-0e38 = методы сравниваются при постоянной частоте вращения, а вращение этой машины свободно
diag-prescribe-the-speed-of-the-machine-176a = задайте частоту вращения машины (уберите свободный привод)
diag-the-stored-response-is-of-one-2c20 = сохранённый отклик рассчитан при одной частоте вращения, а этот расчёт выполняется в диапазоне
diag-order-of-the-base-frequency-does-bd3d = порядок { $h } основной частоты не достигает дисбаланса, порядок которого { $divisor }
diag-with-subharmonic-n-orders-count-in-3fdb = при subharmonic = n порядки отсчитываются с шагом частота вращения / n: сохраните не меньше n порядков
diag-motions-of-turns-of-the-rotor-b128 = у движений с периодом { $divisor ->
        [one] { $divisor } оборот
        [few] { $divisor } оборота
       *[other] { $divisor } оборотов
    } ротора нет симметрии «{ $symmetry }»: она есть только при нечётном числе оборотов
diag-write-symmetry-none-or-an-odd-deb5 = напишите symmetry = "none" или нечётное число в subharmonic
diag-vary-two-parameters-for-one-see-e9a8 = варьируйте два параметра; для одного есть nonlinear_response с uncertainty, или задайте по y другой
diag-a-map-of-by-machines-is-1075 = карта из { $x } на { $y } машин слишком велика
diag-at-most-machines-in-all-be30 = всего не больше { $most } машин
diag-responses-to-compute-cf95 = откликов для расчёта
diag-is-spaced-in-equal-ratios-but-54d2 = { $field } делится в равных отношениях, но начинается не выше 0
diag-begin-above-0-or-leave-out-53e4 = начните выше 0 или уберите { $spacing }
diag-cells-of-the-chart-7498 = ячеек диаграммы
diag-the-chart-has-too-many-cells-daa9 = в диаграмме слишком много ячеек
diag-at-most-speeds-times-values-4009 = произведение числа частот вращения на число значений не больше { $most }
diag-needs-the-speed-of-the-state-7fe7 = для { $field } нужна частота вращения рассматриваемого состояния
diag-give-stabilise-at-3000-rpm-or-1a65 = задайте stabilise_at = "3000 rpm" или частоту вращения в [machine]
diag-stationary-states-are-sought-at-given-86e6 = стационарные состояния ищутся при заданных частотах вращения, а вращение этой машины свободно
diag-prescribe-the-speed-of-the-machine-7fd4 = задайте частоту вращения машины или рассчитайте свободную машину во времени расчётом transient
diag-at-ff93 = при { $path } = { $x }: { $message }
diag-starts-to-follow-65c8 = начальных условий для прослеживания
diag-starts-to-follow-where-no-state-812e = начальных условий для прослеживания там, где нет устойчивых состояний

# laval/src/study: parameters, shared
diag-name-each-once-190a = назовите каждый один раз
diag-the-bounds-must-go-from-a-c5c6 = { $path }: границы должны идти от меньшего значения к большему
diag-is-not-admissible-6d63 = { $path }: { $x } { $unit } недопустимо
diag-runs-of-the-study-at-most-7d3f = выполнений расчёта { $kind }, не больше
diag-one-number-can-be-made-small-4ee5 = минимизировать или максимизировать можно одно число, не два сразу
diag-leave-out-minimise-or-maximise-and-6712 = уберите minimise или maximise и задайте другому числу предел в at_most или at_least
diag-nothing-is-named-that-should-become-6ec6 = не указано, что минимизировать или максимизировать
diag-write-minimise-largest-displacement-or-maximise-3d38 = напишите minimise = "largest_displacement" или maximise = "widest_window"
diag-the-limit-on-is-how-far-18f2 = предел для «{ $name }» равен { $value }: запас до предела измеряется в его долях
diag-give-a-number-other-than-zero-cc0a = задайте число, отличное от нуля
diag-it-finds-3a16 = он вычисляет: { $all }
diag-the-study-finds-no-number-of-fd93 = расчёт { $kind } не вычисляет для этой машины числа «{ $name }»
diag-the-limit-on-6641 = предел для «{ $name }»: { $message }
diag-parameters-are-too-many-to-search-ed70 = { $count ->
        [one] { $count } параметр
        [few] { $count } параметра
       *[other] { $count } параметров
    } — слишком много для поиска
diag-runs-of-the-study-56de = выполнений расчёта { $kind }
diag-samples-of-parameters-require-runs-which-5bcc = для { $samples } выборок по { $k } параметрам нужно { $runs } выполнений, это слишком много
diag-at-most-runs-in-all-ae2b = всего не больше { $most } выполнений
diag-parameters-need-dimensions-the-sobol-sequence-167d = для { $k } параметров нужно { $dimensions } измерений, в последовательности Соболя их { $most }
diag-use-method-monte-carlo-82d8 = задайте method = "monte_carlo"
diag-name-x-or-y-b884 = назовите { $path }.x или { $path }.y
diag-its-values-in-x-and-y-af7c = его значения по x и y различаются, поэтому единственного неопределённого значения нет
diag-give-its-standard-deviation-a-tolerance-7843 = задайте его стандартное отклонение: допуск, в который укладываются 99.7 % деталей, равен трём отклонениям
diag-it-takes-7437 = допустимы { $allowed }
diag-a-distribution-has-no-0fa8 = у распределения «{ $distribution }» нет { $other }
diag-the-standard-deviation-is-missing-81a3 = не задано стандартное отклонение
diag-add-deviation-2-440b = добавьте deviation = "2 %"
diag-the-machine-s-value-is-0-d673 = значение в машине равно 0, и любая его доля равна 0: задайте число с единицей
diag-it-must-be-above-0-7e37 = должно быть больше 0
diag-a-standard-deviation-of-leaves-nothing-4f0b = при стандартном отклонении { $deviation } неопределённости нет
diag-a-log-normal-number-is-positive-29ac = логнормальная величина положительна, её среднее не может быть { $mean }
diag-use-normal-or-give-a-mean-b5e5 = задайте "normal" или среднее
diag-either-from-and-to-or-tolerance-38f5 = нужно либо from и to, либо tolerance
diag-write-tolerance-5-or-from-to-8859 = напишите tolerance = "5 %" или from = .., to = ..
diag-the-machine-s-value-is-0-bcf9 = значение в машине равно 0, и любая его доля равна 0: задайте числа с единицей
diag-from-must-lie-below-to-2ee8 = from должно быть меньше to
diag-there-is-nothing-between-and-3b19 = между { $from } и { $to } ничего нет
diag-is-not-admissible-for-this-parameter-c787 = { $value } недопустимо для этого параметра
diag-narrow-the-interval-69e6 = сузьте интервал
diag-its-most-probable-value-lies-outside-fd45 = его наиболее вероятное значение { $mode } лежит вне интервала от { $from } до { $to }
diag-give-mode-or-other-ends-6d7c = задайте mode или другие концы
diag-there-are-a-point-of-a-a331 = имеются { $all }; точка тела записывается как "drum at 100 mm"
diag-there-are-f68d = имеются { $all }
diag-names-which-is-no-body-of-c478 = { $field }: названо «{ $n }», такого тела в этой машине нет
diag-names-which-is-no-body-that-b6c8 = { $field }: названо «{ $n }», такого наклоняющегося тела в этой машине нет
diag-names-which-is-no-part-with-b98a = { $field }: названо «{ $n }», это не элемент с силой
diag-names-which-is-no-part-with-b270 = { $field }: названо «{ $n }», это не элемент с моментом
diag-rated-density-belongs-to-a-highest-83e1 = rated_density относится к наибольшей частоте вращения, а она не задана
diag-add-speed-8e93 = добавьте speed
diag-run-up-time-needs-an-operating-a26f = для run_up_time нужна рабочая частота вращения, а её не задают ни [operation], ни [machine]
diag-operating-speeds-begin-above-standstill-and-7f11 = рабочие частоты вращения начинаются выше нуля и имеют одно направление вращения
diag-the-operating-speeds-must-go-from-00fe = рабочие частоты вращения должны идти от меньшего значения к большему
diag-from-is-and-to-is-exchange-b990 = from равно { $from }, to равно { $to }: поменяйте их местами
diag-the-speed-of-machine-is-not-8ca9 = частота вращения из [machine], { $w }, не входит в рабочие частоты вращения, от { $low } до { $high }
diag-give-the-speed-in-one-of-bf60 = задайте частоту вращения в одном из двух мест или измените одну из них
diag-write-file-si-or-units-such-3458 = напишите file, si или единицы, например "rpm, mm, kN"
diag-spectra-of-states-6d66 = спектры (частот вращения: { $speeds }, состояний: { $states })
diag-give-the-range-fewer-points-f548 = задайте диапазону меньше точек
diag-rows-of-numbers-866d = строки (их число { $rows }, чисел в каждой { $columns })
diag-give-fewer-points-6535 = уменьшите число точек
diag-take-about-gb-of-memory-more-e408 = { $of }: нужно около { $needed } ГБ памяти, больше допустимых { $most } ГБ
diag-the-study-needs-the-coefficients-of-46db = расчёту нужны коэффициенты «{ $name }» при { $from }; его таблица охватывает значения от { $low } до { $high }
diag-the-study-needs-the-coefficients-of-bb45 = расчёту нужны коэффициенты «{ $name }» от { $from } до { $to }; его таблица охватывает значения от { $low } до { $high }
diag-keep-to-speeds-of-the-table-c95a = оставайтесь в пределах таблицы, добавьте в неё строки или напишите beyond = "hold" либо beyond = "linear" в «{ $name }»: результаты вне таблицы тогда отмечаются
diag-the-tables-of-have-no-frequencies-af27 = у таблиц { $names } нет общих частот колебаний
diag-write-beyond-hold-or-beyond-linear-53dc = напишите beyond = "hold" либо beyond = "linear" там, где таблицу можно покидать, или добавьте строки
diag-no-part-of-this-machine-is-9c3e = ни один элемент этой машины не задан таблицей по частоте колебаний
diag-speeds-at-which-modes-are-counted-0ff8 = частот вращения, при которых моды подсчитываются одна за другой
diag-modes-with-frequencies-outside-the-table-1aa5 = моды с частотами вне таблицы «{ $name }» неизвестны
diag-the-coefficients-of-depend-on-the-57ae = коэффициенты «{ $name }» зависят от частоты колебаний, и этот расчёт такого элемента не принимает
diag-modes-campbell-critical-speeds-forced-response-790a = его принимают modes, campbell, critical_speeds, forced_response и harmonic_force; для этого расчёта задайте таблицу только по частоте вращения
diag-the-study-needs-the-coefficients-of-3837 = расчёту нужны коэффициенты «{ $name }» при частоте колебаний { $from }; его таблица охватывает значения от { $low } до { $high }
diag-the-study-needs-the-coefficients-of-1fc0 = расчёту нужны коэффициенты «{ $name }» при частотах колебаний от { $from } до { $to }; его таблица охватывает значения от { $low } до { $high }
diag-keep-to-frequencies-of-the-table-734e = оставайтесь в пределах частот таблицы, добавьте в неё строки или напишите beyond = "hold" либо beyond = "linear" в «{ $name }»: результаты вне таблицы тогда отмечаются
diag-with-roots-are-counted-where-they-c786 = при наличии { $name } подсчитываются только растущие корни: затухает ли корень медленнее, чем при growth_threshold ниже 0, неизвестно
diag-give-a-growth-threshold-of-0-2976 = задайте growth_threshold не меньше 0; скорость затухания движения показывает transient
diag-this-study-needs-a-spin-speed-9f43 = этому расчёту нужна частота вращения
diag-give-speed-3000-rpm-here-or-331c = задайте speed = "3000 rpm" здесь или один раз для всех расчётов в [machine]
diag-give-two-values-that-differ-9f93 = задайте два разных значения
diag-modes-forced-response-stability-map-and-3533 = { $help }; modes, forced_response, stability_map и transient выполняются при одной частоте вращения
diag-is-one-value-and-this-study-31a8 = { $field } — одно значение, а этому расчёту нужен диапазон
diag-write-2145 = напишите { $field } = {"{"} from = .., to = .. {"}"}
diag-must-go-from-a-lower-to-a4b0 = { $field } должно идти от меньшего значения к большему
diag-needs-ends-farther-apart-bf86 = { $field }: раздвиньте концы диапазона
diag-is-too-narrow-its-ends-differ-11bf = { $field }: диапазон слишком узок, его концы различаются меньше чем на миллиардную долю
diag-needs-at-least-points-6b87 = { $field }: нужно не меньше { $least } точек
diag-leave-points-out-for-a-fitting-7f88 = уберите points: подходящее число точек выбирается автоматически
diag-requires-points-which-are-too-many-10f6 = { $field }: требуется { $points } точек, это слишком много
diag-at-most-points-a673 = не больше { $most } точек

# laval-solve
diag-has-memory-states-which-an-explicit-422f = «{ $name }» имеет состояния памяти, которые явный метод рассчитать не может
diag-use-method-stiff-baf2 = задайте method = "stiff"
diag-order-of-the-motion-would-lie-2fd8 = порядок { $orders } движения лежит в непрерывном спектре { $waves } { $name }, от { $a } до { $b } при { $speed }, где установившегося отклика нет
diag-orders-of-the-motion-would-lie-8d8e = порядки { $orders } движения лежат в непрерывном спектре { $waves } { $name }, от { $a } до { $b } при { $speed }, где установившегося отклика нет
diag-with-symmetry-half-where-the-law-928a = { $remedy }; при symmetry = "half", если закон такую симметрию имеет, движутся только нечётные порядки
diag-the-machine-has-no-periodic-motion-32a0 = у машины нет периодического движения на некотором порядке: { $why }
diag-a-body-without-any-spring-drifts-536a = тело без упругой связи дрейфует; координата без массы, демпфирования и жёсткости не определена
diag-the-machine-is-symmetric-by-any-0931 = машина симметрична при любом повороте: её движение рассчитывается как круговое, только порядка 1, и движений с периодом { $divisor ->
        [one] { $divisor } оборот
        [few] { $divisor } оборота
       *[other] { $divisor } оборотов
    } среди них нет
diag-leave-subharmonic-out-or-write-symmetry-70a8 = уберите subharmonic или напишите symmetry = "none", чтобы учесть больше порядков
diag-leave-subharmonic-out-or-write-symmetry-a746 = уберите subharmonic или напишите symmetry = "half" либо "none", чтобы учесть больше порядков
diag-the-machine-has-no-symmetry-by-0c76 = у машины нет симметрии «{ $symmetry }»: элемент «{ $part }» при повороте меняется
diag-the-machine-has-no-symmetry-by-3964 = у машины нет симметрии «{ $symmetry }»
diag-use-symmetry-auto-this-machine-is-2aec = задайте symmetry = "auto"; симметрия этой машины: { $symmetry }
diag-the-response-cannot-be-followed-ba98 = отклик проследить нельзя: { $e }
diag-no-periodic-motion-was-found-at-47e1 = периодическое движение не найдено ни при { $lo }, ни при { $hi }
diag-integrate-the-machine-in-time-transient-0e26 = проинтегрируйте машину во времени (transient, sweep): её движение может не повторяться через один оборот или вообще
diag-all-parts-of-this-machine-are-e65c = все элементы этой машины линейны: частота свободных движений не зависит от амплитуды
diag-use-modes-or-campbell-for-these-cd7a = для этих частот используйте modes или campbell
diag-the-family-cannot-be-followed-5ca8 = семейство проследить нельзя: { $e }
diag-the-asymptotes-could-not-be-computed-1ebf = асимптоты рассчитать не удалось: { $why }
diag-all-parts-of-this-machine-are-26e6 = все элементы этой машины линейны: там, где она неустойчива, прецессия неограниченно растёт
diag-use-stability-map-for-the-ranges-5a82 = диапазоны частот вращения, где это происходит, даёт stability_map
diag-nothing-damps-this-machine-its-free-59a9 = демпфирования в машине нет: свободные движения образуют семейства со всеми амплитудами, и предельных циклов среди них нет
diag-use-backbone-for-the-families-or-b5f7 = для семейств используйте backbone или задайте машине демпфирование ({ $by })
diag-use-backbone-for-the-families-or-cf95 = для семейств используйте backbone или задайте машине демпфирование
diag-the-cycles-cannot-be-followed-0df2 = циклы проследить нельзя: { $e }
diag-the-force-of-depends-on-the-5b01 = сила «{ $name }» зависит от угла ротора или от времени: у этой машины нет свободного движения
diag-use-nonlinear-response-for-the-motion-1f45 = для вынужденного движения используйте nonlinear_response или расчёт transient
diag-choose-another-range-of-the-parameter-8d88 = выберите другой диапазон параметра
diag-the-machine-does-not-exist-at-9578 = машины не существует ни при одном из опробованных значений { $path }: { $why }
diag-the-machine-does-not-exist-at-b3f3 = машины не существует ни при одном из опробованных значений { $path }
diag-the-machine-exists-at-a-single-e5fd = в этом диапазоне машина существует только при одном значении { $path }
diag-the-locus-cannot-be-followed-7127 = кривую проследить нельзя: { $e }
diag-has-no-time-domain-form-4e95 = «{ $part }» не имеет представления во временной области: { $why }
diag-the-machine-has-first-order-states-7ed4 = в машине { $n } состояний первого порядка, это больше, чем допускает отображение за период
diag-the-force-of-jumps-when-it-ebe9 = сила «{ $part }» при касании меняется скачком, и его влияние на возмущение не рассчитывается
diag-a-coordinate-has-no-mass-1332 = у одной из координат нет массы
diag-the-spin-angle-451f = угол поворота
diag-the-mass-matrix-is-singular-no-91ea = матрица масс вырождена: собственной инерции не остаётся для { $place }
diag-the-mass-matrix-has-an-entry-344a = в матрице масс есть не конечное число ({ $place })
diag-the-machine-has-no-equations-of-754e = уравнений движения у машины нет: { $what }
diag-no-places-of-the-coordinates-without-3d01 = силы не уравновешиваются ни при каком положении координат без инерции
diag-without-inertia-no-damping-or-stiffness-fdb8 = без инерции ни демпфирование, ни жёсткость не определяет { $place }
diag-a-coordinate-follows-from-inertia-or-9b2d = координата следует из инерции, а без неё — из демпфера или пружины, которые её удерживают: задайте элементу, которому она принадлежит, массу или удержите её, а свободному вращению — момент инерции относительно оси
diag-the-motion-cannot-be-computed-from-98a8 = движение от его начального состояния рассчитать нельзя: { $what }
diag-is-given-in-the-frequency-domain-f133 = «{ $name }» задан только в частотной области: { $why }
diag-forced-response-works-with-it-and-dda6 = с ним выполняются forced_response и modes около положения равновесия, если область аналитичности элемента известна
diag-the-modes-at-could-not-be-a843 = моды при { $speed } рассчитать не удалось: { $e }
diag-a-coordinate-with-neither-mass-damping-44a1 = моды не определены: есть координата без массы, демпфирования и жёсткости
diag-the-speeds-must-be-finite-and-08cc = частоты вращения должны быть конечными, а длительность изменения — положительной
diag-an-exponential-change-never-reaches-or-b31b = экспоненциальное изменение никогда не достигает нуля и не начинается с него: обе частоты вращения должны иметь одинаковый знак
diag-a-polynomial-of-the-speed-has-15d4 = у многочлена частоты вращения от 1 до { $most } коэффициентов, задано { $given }
diag-the-coefficients-must-be-finite-and-99d2 = коэффициенты должны быть конечными, а длительность изменения — положительной
diag-a-table-of-speeds-needs-at-8eba = таблице частот вращения нужно не меньше двух точек, и частот столько же, сколько моментов времени
diag-times-and-speeds-must-be-finite-3507 = моменты времени и частоты вращения должны быть конечными
diag-the-times-must-increase-is-followed-8e71 = моменты времени должны возрастать; после { $first } следует { $second }
diag-the-speed-changes-faster-than-can-3094 = частота вращения меняется слишком быстро для расчёта
diag-the-machine-has-no-rest-the-72b5 = у машины нет положения равновесия: сила «{ $name }» вращается вместе с ротором
diag-transient-gives-the-motion-in-time-681b = движение во времени даёт transient
diag-stationary-gives-the-states-that-turn-c025 = состояния, вращающиеся вместе с ротором, и их устойчивость даёт stationary, движение во времени — transient и run_up
diag-transient-and-run-up-give-the-0238 = движение во времени дают transient и run_up
diag-cannot-be-linearised-at-rest-01cd = «{ $name }» нельзя линеаризовать около положения равновесия: { $reason }
diag-use-a-nonlinear-study-or-one-c104 = используйте нелинейный расчёт или расчёт во времени либо задайте элементу предварительный натяг
diag-the-machine-has-no-equilibrium-under-d65d = у машины нет положения равновесия под нагрузкой: некоторая координата не удерживается жёсткостью
diag-attach-a-bearing-shaft-or-foundation-b11e = присоедините опору, вал или основание к каждому нагруженному телу; у свободно движущихся масс, таких как шарики балансира, нет положения равновесия: { $free }
diag-no-equilibrium-was-found-newton-s-d993 = положение равновесия не найдено (метод Ньютона остановился с шагом { $step } характерных размеров)
diag-check-the-load-and-the-characteristics-cdab = проверьте нагрузку и характеристики нелинейных элементов или начните с другого состояния
diag-a-part-without-time-form-is-6af5 = элемент без представления во временной области линеаризуется только около положения равновесия
diag-leave-about-out-067c = уберите about
diag-does-not-say-where-its-dynamic-c7f1 = для «{ $name }» не указана область аналитичности его динамической жёсткости
diag-without-that-no-roots-can-be-e4c1 = без этого корни подсчитать нельзя; с ним выполняется forced_response
diag-the-frequencies-of-the-machine-have-ce0d = частоты машины не ограничены, и подсчитать корни нельзя
diag-give-frequency-limit-df65 = задайте frequency_limit
diag-from-the-undeflected-machine-no-state-da81 = от недеформированной машины не найдено состояние, вращающееся вместе с ротором
diag-the-machine-has-no-state-that-5f47 = у машины нет состояния, вращающегося вместе с ротором: { $reason }
diag-studies-about-rest-about-rest-by-e3da = для такой машины подходят расчёты около положения равновесия (about = "rest"), гармонические и во времени (transient, run_up)
diag-the-machine-has-no-equilibrium-at-cc55 = у машины нет и положения равновесия: движение во времени дают transient и run_up
diag-the-weight-of-pulls-to-one-fdd8 = сила тяжести «{ $name }» действует в одну сторону (axis = "horizontal")
diag-differs-in-x-and-y-a4f1 = { $base } различается по x ({ $x } { $unit }) и y ({ $y } { $unit })
diag-the-forces-of-do-not-turn-00ed = силы «{ $name }» ({ $kind }) не поворачиваются вместе с машиной и состоянием

# laval-separation
diag-no-path-in-space-5c87 = нет пространственной траектории
diag-cups-swing-out-against-a-weight-0f4e = стаканы отклоняются против силы тяжести вдоль оси, а в горизонтальной машине её нет; укажите угол, под которым они закреплены
diag-the-shares-below-must-rise-from-712b = накопленные доли должны возрастать от 0 до 1
diag-the-last-share-below-is-it-e864 = последняя накопленная доля равна { $last }; она должна быть равна 1
diag-the-shares-of-the-classes-must-211d = доли классов не должны быть отрицательными и не должны все равняться нулю
diag-values-have-shares-6d11 = число значений { $values }, число долей { $shares }
diag-the-values-must-be-positive-and-34e1 = значения должны быть положительными и возрастать по строкам
diag-the-drag-law-changes-its-piece-c2a7 = закон сопротивления многократно меняет свой участок при { $t }
diag-the-step-became-too-small-at-f4f4 = шаг стал слишком мал при { $t }
diag-stopped-at-after-steps-69bb = остановлено при { $t } после { $steps } шагов
diag-stopped-9dac = остановлено
diag-no-place-of-the-liquid-is-aad6 = в жидкости не найдено места, где начинается траектория

# laval-cli: validate
diag-of-cases-are-not-as-their-544a = случаев, не соответствующих своим страницам: { $n } из { $all }
diag-there-is-no-case-in-3f6d = в { $folder } нет проверочных случаев
diag-a-case-is-a-page-topic-2974 = проверочный случай — страница TOPIC/CASE.md; как её писать, сказано в docs/validation.md
diag-no-case-has-in-its-name-a164 = проверочного случая с { $text } в имени нет
diag-there-is-no-folder-validation-here-49db = папки "validation" нет ни здесь, ни выше
diag-run-inside-the-source-repository-of-1fee = запустите в репозитории исходных текстов laval или укажите папку с проверочными случаями
diag-laval-cannot-write-fadf = laval: записать { $path } не удалось: { $e }

## Studies in parts

diag-is-rows-to-are-missing-2dec = файл { $path }: { $why }; строк с { $first } по { $last } нет
diag-of-rows-are-missing-those-of-2c01 = нет строк: { $rows } из { $all }, из частей таблицы с номерами { $shown } из { $of }
diag-part-of-has-no-rows-d16b = часть { $number } из { $of }: строк нет
diag-part-of-of-rows-are-there-9818 = часть { $number } из { $of }: готово строк { $done } из { $total }
diag-run-the-parts-that-have-not-0f55 = запустите незавершённые части ещё раз; кусок k относится к части ((k - 1) mod n) + 1 из n. laval run вычисляет недостающее
diag-the-study-is-planned-not-run-a333 = расчёт запланирован, но не выполнен
diag-lb-is-a-mass-the-force-a3b2 = lb — единица массы; единица силы — lbf: напишите { $meant }
diag-write-the-speed-at-which-the-49ba = задайте частоту вращения, на которой работает машина, например speed = "3000 rpm"; если она задана в [machine], уберите speed
diag-write-the-lowest-speed-at-which-520c = вместо 0 задайте наименьшую рабочую частоту вращения: разгон из неподвижного состояния в этот диапазон не входит
diag-give-a-value-b1a9 = допустимы значения: { $bounds }
diag-nothing-holds-the-tilt-of-alone-ad2e = ничто не удерживает наклон «{ $name }» ({ $names }), отдельно или вместе с наклоном соединённых с ним тел
diag-let-a-shaft-act-on-the-94fc = пусть на наклон действует вал (tilt_stiffness или круглый вал), удерживайте тело на двух высотах или не задавайте diametral_inertia: тогда оно не наклоняется
diag-no-study-of-divides-into-parts-548e = ни одно исследование файла { $file } не делится на части
diag-leave-out-part-laval-run-computes-7c4e = уберите --part: laval run рассчитает все исследования
diag-parts-are-requested-and-no-study-4ded = запрошено частей: { $of }, но ни одно исследование файла { $file } не делится больше чем на { $most }
diag-number-the-parts-from-1-to-d23e = нумеруйте части от 1/{ $most } до { $most }/{ $most } или возьмите меньше частей; laval plan показывает, как делится каждое исследование
diag-is-no-machine-has-less-than-088d = { $who }: { $name } = { $value }; у машин не бывает меньше { $least }
diag-is-no-machine-has-more-than-21e1 = { $who }: { $name } = { $value }; у машин не бывает больше { $most }
diag-far-outside-a589 = далеко за пределами
diag-check-the-number-and-its-unit-ee7b = проверьте число и его единицу; расчёт идёт с ним как есть
diag-files-of-cases-with-numbers-each-e703 = файлы по { $rows } случаев с { $columns } числами в каждом слишком велики: в файле может быть не более { $most } чисел
diag-the-machine-has-coordinates-and-states-452d = у машины { $n } координат и { $m } состояний элементов; рассчитывается не более { $most } вместе
diag-note-threads-cannot-be-started-one-a291 = замечание: запустить потоки (их число { $wanted }) не удалось ({ $e }): считает один. Сколько потоков нужно, задаёт RAYON_NUM_THREADS.

# laval-model/src/parts/shaft
diag-the-position-is-not-on-the-d41c = положение { $position } не лежит на теле, которое простирается от { $low } до { $high }
diag-is-a-attach-to-a-disc-9439 = «{ $name }» — { $kind }; присоединяйте к диску, к валу или к основанию
diag-is-attached-to-itself-by-way-b48c = «{ $name }» присоединено к самому себе через другие тела
diag-parameters-of-a-reduced-machine-cannot-b5d6 = параметры сведённой машины изменить нельзя
diag-a-shaft-has-1-to-sections-a510 = у вала от 1 до { $most } участков
diag-give-each-section-one-entry-in-0a0d = дайте каждому участку одно значение в каждом списке
diag-a-section-is-long-06c8 = длина участка { $length }
diag-lengths-are-between-1-m-and-249f = длины лежат между 1 мкм и 1 км
diag-the-outer-diameter-of-a-section-ec18 = наружный диаметр участка { $diameter }
diag-diameters-are-between-1-m-and-c7e8 = диаметры лежат между 1 мкм и 100 м
diag-section-the-inner-diameter-must-be-eed5 = участок { $number }: внутренний диаметр должен быть меньше наружного
diag-modulus-and-shear-modulus-make-a-9d86 = modulus и shear_modulus дают коэффициент Пуассона { $nu }, какого нет ни у одного металла: E = 2 G (1 + nu)
diag-is-attached-to-e4e1 = { $kind } «{ $block }»: присоединение к «{ $name }»: { $beyond }
diag-not-on-the-body-23cd = не на теле
diag-row-has-no-7ab0 = { $who }, строка { $row }: нет { $name } ({ $doc })
diag-a-compression-of-buckles-it-unless-2945 = сжатие { $force } вызывает потерю устойчивости, если подшипники между концами его не держат: с обоими заделанными концами он выдерживает не более { $limit }
diag-hold-it-at-a-second-place-041d = закрепите его во втором месте: добавьте ещё один подшипник

# Supports of the rotor
diag-is-not-given-by-mass-gyroscopic-1bec = «{ $name }» не задана матрицами масс, гироскопических сил и жёсткости и не является опорой, которую заменяет карта
diag-name-it-in-supports-if-it-35db = если это опора, назовите её в supports; иначе любую часть принимают campbell и critical_speeds
diag-the-machine-has-no-support-that-86fb = у машины нет опоры, которую можно заменить
diag-a-support-is-a-part-with-05ea = опора — часть с жёсткостью между вращающимся и невращающимся; supports называет другие
diag-there-is-no-part-8a0d = части «{ $name }» нет
diag-does-not-join-a-turning-body-fc00 = «{ $name }» не соединяет вращающееся тело ни с чем
diag-parts-that-join-a-turning-body-fe2b = части, которые соединяют вращающееся тело с чем-либо: { $names }
diag-there-is-no-parameter-of-has-463f = параметра «{ $path }» нет: в { $name } элемента «{ $part }» одна строка
diag-there-is-no-parameter-of-has-193c = параметра «{ $path }» нет: число строк { $name } элемента «{ $part }» равно { $count }
diag-rows-are-numbered-from-1-parameters-b396 = строки нумеруются с 1; параметры последней: { $near }
diag-steady-response-at-3e8c = установившийся отклик при { $speed }
diag-branch-from-the-lowest-speed-at-2bf4 = ветвь от наименьшей частоты вращения, при { $speed }
diag-branch-from-the-highest-speed-at-0be3 = ветвь от наибольшей частоты вращения, при { $speed }
diag-further-branch-at-c050 = другая ветвь, при { $speed }
diag-stability-of-the-branch-from-the-29af = устойчивость ветви от наименьшей частоты вращения, при { $speed }
diag-stability-of-the-branch-from-the-a793 = устойчивость ветви от наибольшей частоты вращения, при { $speed }
diag-stability-of-a-further-branch-at-5e02 = устойчивость другой ветви, при { $speed }

# laval/src/import, laval-cli/src/import.rs

diag-left-out-there-are-no-lateral-3572 = { $elements }: пропущен, поперечных коэффициентов нет
diag-between-the-rows-of-a-table-98ce = между строками таблицы ROSS 2 проводит сплайн, laval — монотонную кубическую кривую, как ROSS 3
diag-cone-mid-section-gives-the-cones-61fb = cone = "mid_section" даёт конусы ROSS; без этого ключа они сходятся быстрее
diag-lateral-motion-alone-is-carried-over-869f = перенесены только поперечные движения; остальные добавляют axial = true и torsional = true у вала
diag-ross-takes-g-9-8065-m-9851 = ROSS берёт g = 9.8065 m/s^2 в run_static, laval — 9.80665 m/s^2
diag-is-at-node-where-neither-the-2fb9 = { $element } стоит в узле { $node }, где нет ни вала, ни сосредоточенной массы
diag-has-no-3dc9 = у { $element } нет ключа { $key }
diag-of-must-be-not-c7c2 = { $key } у { $element }: нужно { $wanted }, а не { $shape }
diag-a-finite-number-ee7c = конечное число
diag-the-number-of-a-node-from-0b42 = номер узла от 0 до { $most }
diag-a-list-of-finite-numbers-3e52 = список конечных чисел
diag-left-out-5499 = { $elements }: не перенесено: { $keys }
diag-a-disc-without-teeth-e596 = { $elements }: диск без зубьев
diag-the-mean-of-mx-and-my-8318 = { $elements }: взято среднее mx и my
diag-the-length-of-must-be-positive-9a7e = длина { $element } должна быть положительной
diag-has-values-of-for-speeds-0087 = у { $element } значений { $key }: { $n }, а частот вращения: { $wanted }
diag-of-the-coefficients-over-speed-and-9cb9 = { $elements }: из коэффициентов по частоте вращения и частоте колебаний взяты те, где обе частоты равны
diag-coefficients-over-frequency-are-taken-over-59b6 = { $elements }: коэффициенты по частоте колебаний взяты по частоте вращения
diag-the-coefficients-are-those-in-the-45ec = { $elements }: коэффициенты взяты из файла, геометрия не перенесена
diag-in-effect-in-all-studies-ross-43d4 = { $elements }: учтено во всех расчётах; ROSS в run_static уплотнений не учитывает
diag-it-is-not-utf-8-text-eb31 = это не текст UTF-8
diag-it-is-not-a-table-of-ed88 = это не таблица элементов
diag-its-tables-are-nested-too-deeply-59ac = таблицы вложены слишком глубоко
diag-this-model-is-no-machine-here-551b = по этой модели машину построить нельзя: { $why }
diag-this-is-no-model-that-ross-c0a1 = это не модель, сохранённая программой ROSS: { $why }
diag-rotor-save-rotor-toml-and-rotor-8e3a = читаются модели, которые записывают rotor.save("rotor.toml") и rotor.save("rotor.json") в ROSS 2 и 3
diag-the-file-cannot-be-read-3769 = файл не читается: { $why }
diag-elements-of-the-kind-are-not-89d8 = элементы вида { $class } не переносятся
diag-elements-that-are-imported-23a2 = переносятся элементы: { $all }
diag-it-has-no-shaftelement-bf65 = в ней нет ShaftElement
diag-no-element-of-the-shaft-lies-e19b = между узлами { $k } и { $next } нет элемента вала
diag-the-shafts-of-several-rotors-in-ca3c = валы нескольких роторов в одной модели не переносятся
diag-the-mass-is-carried-over-as-2fac = { $elements }: масса перенесена как диск, жёсткость не перенесена
diag-of-elements-differs-that-of-is-d2a2 = { $key } отличается (элементов: { $n }); для всего вала взято значение из { $first }
diag-rotary-inertia-and-gyroscopic-are-on-f7ff = rotary_inertia и gyroscopic включены во всех элементах; в модели они выключены (элементов: { $n })
diag-left-out-or-different-in-ross-343d = Не перенесено или иначе в ROSS:
diag-and-more-1d3b = { $names } и ещё { $n }
diag-add-a-part-of-kind-speed-cc8c = добавьте деталь kind = "speed_ratio" с этим именем и её отношением к частоте вращения машины
diag-spins-of-this-machine-d82c = вращения этой машины: { $spins }
diag-turns-with-the-spin-which-does-1f6e = "{ $slot }" вращается вместе с "{ $name }", а такого вращения нет
diag-a-coupling-joins-shafts-of-one-3e2d = муфта соединяет валы с одной частотой вращения; между валами с разной частотой нужны зубчатая передача или подшипник
diag-a-wheel-sits-on-a-turning-8ee2 = колесо сидит на вращающемся теле, а не на земле
diag-name-the-two-shafts-or-discs-cbce = назовите два вала или диска, на которых сидят колёса
diag-the-second-body-turns-times-as-56df = второе тело вращается в { $ratio } раза быстрее первого, а по радиусам в { $needed }; задайте ему вращение с этим отношением
diag-a-spin-of-ratio-0-stands-f193 = вращение с отношением 0 стоит на месте: деталям, которые не вращаются, оно не нужно
diag-this-study-knows-one-spin-and-77ac = этому расчёту нужно одно вращение, а у машины есть другое, "{ $name }"
diag-contact-angle-is-given-without-balls-aa45 = contact_angle задан без balls
diag-a-coefficient-holds-the-angle-already-7b11 = коэффициент уже учитывает угол: уберите contact_angle
diag-the-bearing-has-no-contact-coefficient-5cac = у подшипника нет контактного коэффициента
diag-give-coefficient-or-balls-and-ball-ccc8 = задайте coefficient или balls и ball_diameter
diag-coefficient-is-given-beside-the-geometry-f29d = coefficient задан вместе с геометрией шариков
diag-balls-is-given-without-ball-diameter-a70a = balls задан без ball_diameter
diag-ball-diameter-is-given-without-balls-6beb = ball_diameter задан без balls
diag-the-contact-coefficient-must-be-positive-11f4 = контактный коэффициент должен быть положительным
diag-the-ratio-of-the-stiffnesses-is-f766 = отношение жёсткостей известно для 8–16 тел качения, но не для { $count }
diag-give-ratio-the-stiffness-across-the-9a5b = задайте ratio: отношение жёсткости поперёк нагрузки к жёсткости вдоль неё; при многих телах качения с натягом оно близко к 1
diag-the-ratio-of-the-stiffnesses-is-dd9f = отношение жёсткостей известно для 8–16 тел качения
diag-layer-goes-from-to-e940 = слой { $number } идёт от { $from } до { $to }
diag-it-lies-on-the-shaft-from-d944 = он лежит на валу, от нижнего конца к верхнему: от 0 до { $length }
diag-layer-the-inner-diameter-must-be-f017 = слой { $number }: внутренний диаметр должен быть меньше наружного
diag-inner-diameter-is-that-of-the-d9f3 = inner_diameter втулки равен диаметру вала под ней
diag-layer-has-no-material-modulus-shear-103d = у слоя { $number } нет материала: modulus, shear_modulus и density задают твёрдое тело, stiffness — доля от 0 до 1
diag-leave-out-what-it-has-in-944a = не задавайте то, что у него общее с валом; stiffness = 0 — слой только с массой
diag-layer-overlaps-the-shaft-at-its-d014 = слой { $number } пересекается с валом в { $position }: его внутренний диаметр { $inner }, наружный диаметр вала там { $outer }
diag-a-layer-of-the-shaft-with-e9c1 = { $elements }: слой вала с общим углом сдвига; в ROSS у каждого слоя свой
diag-separation-margins-need-an-operating-speed-78a5 = для запасов по частоте нужна рабочая частота вращения
diag-give-speed-in-machine-or-the-6a56 = задайте speed в [machine] или диапазон рабочих частот в [operation]
diag-frequency-belongs-to-one-spin-speed-36ee = frequency относится к одной частоте вращения
diag-give-one-speed-or-order-in-c27b = задайте одну частоту вращения или order вместо frequency
diag-order-and-frequency-both-say-how-ed69 = order и frequency оба задают частоту силы
diag-leave-one-of-them-out-0b3f = уберите одно из них
diag-separation-margins-are-those-of-a-5324 = запасы по частоте относятся к диапазону частот вращения
diag-leave-frequency-out-and-give-a-f93a = уберите frequency и задайте диапазон частот вращения
diag-responses-at-values-of-coordinates-e18e = отклики при { $values } значениях для { $n } координат
diag-the-point-on-which-the-force-7c2b = точка приложения силы не движется поперёк оси
diag-name-a-point-of-a-disc-206e = назовите точку диска, вала или основания
diag-up-to-is-below-the-anticipated-90ef = up_to меньше ожидаемой жёсткости { $anticipated }
diag-give-a-larger-up-to-or-f72d = задайте больший up_to или уберите его
diag-no-lateral-mode-of-this-machine-bf9e = у этой машины нет колебательных поперечных мод
diag-cross-coupled-stiffness-makes-lateral-modes-69e4 = перекрёстная жёсткость делает неустойчивыми поперечные моды: modes перечисляет моды машины
diag-roots-to-follow-61c7 = корней для отслеживания
diag-no-mode-becomes-less-stable-with-f0e4 = ни одна мода не теряет устойчивость с ростом жёсткости, поэтому наибольшую предложить нельзя
diag-give-up-to-2dd8 = задайте up_to
diag-is-fixed-to-which-turns-with-7c07 = "{ $slot }" закреплено на "{ $body }", а то вращается вместе с другим вращением
diag-leave-spin-out-it-turns-with-b814 = уберите spin: тело вращается вместе с тем, на чём закреплено; или дайте ему свои координаты и подшипник между ними
diag-modes-campbell-critical-speeds-stability-map-4ae2 = несколько вращений допускают modes, campbell, critical_speeds, stability_map, forced_response, harmonic_force, static, transient и run_up
diag-says-how-couplings-are-aligned-and-e84a = { $field } относится к центровке муфт, а в couplings не названо ни одной
diag-name-couplings-or-remove-fddd = назовите муфты в couplings или уберите { $field }
diag-joins-no-shaft-that-bends-to-a48c = "{ $name }" не соединяет изгибаемый вал с другим телом
diag-name-a-coupling-between-two-shafts-cfbb = назовите муфту между двумя валами или место, например "shaft at 1200 mm"
diag-couplings-names-which-is-neither-a-b851 = couplings называет "{ $name }", а это ни часть, ни место вала
diag-a-place-of-a-shaft-is-497d = место вала записывают как "shaft at 1200 mm"
diag-is-no-node-of-the-shaft-5235 = { $name } не узел вала: ближайший на { $near }
diag-end-a-section-of-the-shaft-39cd = закончите там участок вала
diag-loads-of-couplings-vanish-only-with-76f3 = { $needed } нагрузки муфт исчезают только при стольких же подвижных опорах, а их { $free }
diag-name-fewer-couplings-keep-fewer-supports-5374 = назовите меньше муфт, закрепите меньше опор или выберите aligned_for = "moment"
diag-and-support-the-same-place-with-773a = "{ $a }" и "{ $b }" поддерживают одно место с разными смещениями
diag-give-them-the-same-offsets-or-ca7d = дайте им одинаковые смещения или назовите одну из них в supports
diag-needs-an-operating-speed-which-neither-3164 = для { $field } нужна рабочая частота вращения, а её нет ни в [operation], ни в [machine]

# constant forces, spins without parts, supports named twice
diag-this-part-does-nothing-give-a-ce05 = элемент ничего не делает: задайте силу или момент
diag-this-force-was-built-without-d9df = эта сила построена без { $name }
diag-the-moment-of-has-no-effect-5998 = момент «{ $name }» не действует: то, на что он действует, не наклоняется
diag-no-part-turns-with-c0c8 = с «{ $name }» не вращается ни один элемент
diag-name-it-in-a-shaft-or-b28c = назовите его в вале или диске: spin = "{ $name }"
diag-is-named-twice-b544 = «{ $name }» названо дважды
diag-joins-two-points-of-one-body-7eda = «{ $name }» соединяет две точки одного тела
diag-a-bearing-or-shaft-joins-a-78c9 = опора или вал соединяет тело с другим телом или с "ground"
diag-a-gear-joins-the-rotations-of-7f02 = передача связывает вращения двух тел: задайте torsional = true для обоих
diag-layers-and-are-in-the-same-4df9 = слои { $first } и { $second } занимают одно место в { $position }
diag-names-a-point-that-does-not-8b5a = { $field } называет «{ $n }» – точку, которой у «{ $body }» нет
diag-it-reaches-from-to-517d = тело простирается от { $from } до { $to }
diag-not-read-as-no-element-of-a77e = { $elements }: не прочитано, у элементов этого вида нет таких ключей: { $keys }
diag-turns-times-as-fast-as-the-880f = «{ $name }» вращается в { $ratio } раза быстрее машины, и его таблица задаётся по этой частоте: запишите отрицательные частоты вращения и перекрёстные коэффициенты для этого направления
diag-the-file-has-no-number-bda7 = в файле нет числа «{ $path }»
diag-two-changes-are-of-the-same-1bd6 = два изменения относятся к одному месту файла
diag-is-not-written-in-the-file-f870 = { $path } в файле не записан
diag-is-no-quantity-296e = { $text } – не величина
diag-a-critical-speed-has-an-order-339b = у критической частоты вращения есть порядок больше 0 и частота
diag-there-is-no-such-critical-speed-ea55 = вблизи { $at } такой критической частоты вращения нет
diag-a-limit-of-stability-has-a-12c8 = у границы устойчивости есть частота вращения
diag-there-is-no-limit-of-stability-8182 = вблизи { $at } границы устойчивости нет
diag-is-released-twice-f3c3 = { $path } освобождён дважды
diag-the-released-range-must-hold-the-a291 = { $path }: освобождённый диапазон должен содержать значение файла
diag-no-parameter-is-released-bfda = ни один параметр не освобождён
diag-the-wanted-value-is-no-number-92b4 = желаемое значение – не число
diag-the-released-parameters-do-not-move-1fda = освобождённые параметры этот результат не сдвигают
diag-the-search-ended-at-beyond-this-d436 = поиск закончен на { $value }: дальше этого результата нет или он не следует за освобождёнными параметрами
diag-is-the-nearest-that-can-be-c523 = ближайшее достижимое значение – { $value }: { $names } на своей границе
diag-is-the-nearest-that-can-be-c685 = ближайшее достижимое значение – { $value }: { $names } на своих границах
diag-the-machine-of-the-file-does-df10 = у машины файла такого результата нет
diag-the-machine-file-gives-no-speed-4340 = в файле машины не задана частота вращения
diag-the-figure-cannot-be-drawn-666c = рисунок построить нельзя: { $e }
diag-one-of-value-and-written-is-a69e = { $path }: нужно одно из двух – value или written
diag-is-no-machine-file-toml-in-cfe5 = { $name } – не файл машины (.toml) в папке студии
diag-is-larger-than-mb-3ad7 = { $path } больше { $size } МБ
diag-has-changed-on-the-disk-since-3764 = { $path } изменён на диске после открытия
diag-there-is-no-result-that-can-f05c = нет результата { $what }, который можно сдвинуть
diag-the-request-cannot-be-read-8f3c = запрос не читается: { $e }
diag-this-is-a-defect-of-the-4010 = это ошибка программы, а не вашего файла: расчёт не выполнен
diag-there-is-no-such-run-165f = такого расчёта нет
diag-the-machine-has-no-such-study-f80c = у машины нет такого исследования
diag-the-study-cannot-be-started-3c9f = исследование не запускается: { $e }
diag-the-report-cannot-be-drawn-a076 = отчёт построить нельзя: { $e }
diag-the-server-cannot-be-started-9a0d = сервер не запускается: { $e }
diag-a-token-has-at-least-8-da81 = в секрете адреса не меньше 8 букв и цифр
diag-cannot-open-9fcf = { $path } не открывается: { $e }
diag-at-most-designs-fit-into-one-c17c = в один файл входит не больше { $most } вариантов
diag-there-is-no-example-1e32 = примера { $name } нет
diag-name-a-file-or-an-example-9b54 = назовите файл или пример
diag-is-no-machine-file-its-name-3c42 = { $path } – не файл машины: имя не кончается на .toml
diag-the-studio-is-open-in-the-faee = Студия открыта в браузере; Ctrl-C завершает её.
diag-note-no-browser-could-be-opened-e857 = замечание: браузер открыть не удалось; откройте адрес выше
diag-the-request-names-no-motion-2e64 = в запросе не указано движение
diag-the-response-has-no-bound-at-244c = отклик при этой частоте вращения не ограничен: резонанс без демпфирования
diag-no-state-of-the-nonlinear-response-5f5e = при этой частоте вращения не найдено ни одного режима нелинейного отклика
diag-the-file-has-no-transient-e71e = в файле нет расчёта transient с именем { $name }
diag-the-result-at-cannot-be-moved-edb0 = результат при { $stated } нельзя передвинуть: ближайший, за которым можно следить, находится при { $found }
diag-is-a-link-out-of-its-b2fe = { $path } — ссылка за пределы своей папки
diag-port-cannot-be-used-ed07 = порт { $port } использовать нельзя: { $e }
diag-give-another-port-or-leave-port-5c64 = укажите другой порт или уберите --port: будет взят свободный
