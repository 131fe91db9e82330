### Sentences of diagnostics and of the command line; the names are those of text/en/diagnostics.ftl.

diag-error-a6c0 = қате
diag-warning-6bce = ескерту
diag-help-9b8b = кеңес
diag-did-you-mean-dcdc = мүмкін, { $near } деп жазбақ болдыңыз ба? { $list }
diag-did-you-mean-fa5e = мүмкін, { $near } деп жазбақ болдыңыз ба?
diag-bodies-of-this-machine-e555 = бұл машинаның денелері: { $all }
diag-is-attached-to-which-does-not-e3d3 = { $kind } «{ $block }»: бекітілген «{ $name }» денесі жоқ
diag-no-such-body-1f1f = мұндай дене жоқ
diag-also-named-in-line-e5a1 = { $message } ({ $line } жолында да бар)
diag-also-named-in-lines-and-6dd4 = { $message } ({ $lines } және { $last } жолдарында да бар)
diag-also-named-in-lines-and-more-5c20 = { $message } ({ $lines } жолдарында және тағы { $left } жерде бар)
diag-and-more-9d04 = ... және тағы { $n }

## laval/src/file/assemble.rs

diag-give-about-turning-or-c5d1 = { $studies }: about = "turning" өрісін беріңіз; немесе { $or }
diag-give-about-turning-e2db = { $studies }: about = "turning" өрісін беріңіз
diag-study-713d = { $one } зерттеуі
diag-studies-a7da = { $names } зерттеулері
diag-cannot-be-built-from-what-is-17a3 = { $kind } «{ $name }»: берілген мәндер бойынша құру мүмкін емес
diag-gives-a-force-that-is-not-403d = { $kind } «{ $name }»: күші ақырлы сан емес
diag-a-value-of-this-part-is-16e4 = бұл бөлшектің бір мәні есептеу үшін тым үлкен немесе тым кіші

## laval/src/file/blocks.rs

diag-the-machine-has-no-parts-7f63 = машинада бөлшек жоқ
diag-describe-each-part-in-a-block-256d = әр бөлшекті [[part]] деп басталатын бөлімде сипаттаңыз
diag-there-is-one-in-a-file-3572 = файлда { $word } біреу ғана болады
diag-double-brackets-f6a7 = қос жақша
diag-must-be-a-block-394a = { $word } бөлім болуы керек
diag-write-with-single-brackets-once-and-c02a = [{ $word }] тақырыбын бір рет, дара жақшамен жазыңыз, өрістерін оның астына қойыңыз
diag-a-is-a-part-write-part-f85c = { $key } – бөлшек: [[part]] деп, оның астына kind = "{ $key }" деп жазыңыз
diag-is-a-study-write-study-and-f8f8 = { $key } – зерттеу: [[study]] деп, оның астына kind = "{ $key }" деп жазыңыз
diag-every-key-stands-in-a-block-7dc3 = әр өріс бір бөлімде тұрады: [machine], [[part]] немесе [[study]]; { $name } өрісінің орны – [machine] астында
diag-every-key-stands-in-a-block-8b85 = әр өріс бір бөлімде тұрады: [machine], [[part]] немесе [[study]]
diag-a-file-has-one-machine-and-cd0f = файлда бір [machine] бөлімі және [[part]], [[study]] бөлімдері болады
diag-a-file-has-one-machine-and-ffdb = файлда бір [machine] бөлімі және [[part]], [[study]] бөлімдері болады; сондай-ақ { $beside }
diag-is-not-a-block-of-a-3d1c = { $key }: машина файлында мұндай бөлім жоқ
diag-unknown-04cc = белгісіз
diag-needs-double-brackets-66da = [{ $what }]: қос жақша керек
diag-single-brackets-040e = дара жақша
diag-write-there-may-be-several-5078 = [[{ $what }]] деп жазыңыз: олар бірнешеу болуы мүмкін
diag-must-be-a-block-f338 = { $what } бөлім болуы керек
diag-write-and-its-keys-below-0c3c = [[{ $what }]] деп, өрістерін оның астына жазыңыз
diag-a-must-be-a-block-not-807b = { $what }: бөлім керек, жазылғаны: { $shape }
diag-two-blocks-are-named-4142 = екі [[{ $what }]] бөлімінің аты бірдей: { $name }
diag-two-blocks-are-named-apart-from-7b57 = екі [[{ $what }]] бөлімінің аты бірдей: { $name } ({ $first } атынан бас әріптермен ғана ерекшеленеді)
diag-taken-above-5dad = жоғарыда берілген
diag-give-each-its-own-name-others-21ca = әрқайсысына өз атын беріңіз; басқалар оған осы атпен сілтейді
diag-has-no-key-beb0 = { $who }: { $key } өрісі жоқ
diag-it-stands-inside-06c3 = оның орны – { $f } өрісінің ішінде: { $f } = {"{"} { $key } = .. {"}"}
diag-did-you-mean-its-keys-68cd = мүмкін, { $near } деп жазбақ болдыңыз ба? Өрістері: { $all }
diag-its-keys-4d57 = өрістері: { $all }
diag-unknown-key-b3fe = белгісіз өріс
diag-needs-d775 = { $who }: { $name } өрісі керек: { $doc }
diag-add-605c = { $example } қосыңыз
diag-is-missing-e95c = { $name } = .. жоқ
diag-the-file-has-no-machine-block-3137 = файлда [machine] бөлімі жоқ
diag-begin-it-with-machine-and-below-3516 = файлды [machine] деп бастап, астына name = ".." және speed = "3000 rpm" деп жазыңыз

## laval/src/file/constructed.rs

diag-there-is-no-kind-of-study-7368 = зерттеудің «{ $kind }» түрі жоқ
diag-there-is-59f4 = бары: { $all }
diag-the-study-cannot-be-made-from-9149 = бұл өрістер бойынша зерттеуді құру мүмкін емес
diag-the-fields-of-are-an-object-9722 = { $kind } өрістері объект болуы керек, берілгені: { $shape }
diag-write-df54 = {"{"} "speed": 300.0 {"}"} деп жазыңыз

## laval/src/file/declared.rs

diag-the-declared-default-cannot-be-used-a68d = жарияланған әдепкі { $default } мәнін қолдану мүмкін емес: { $text }
diag-is-not-an-si-unit-b335 = { $kind }.{ $name }: { $unit } – SI бірлігі емес

## laval/src/file/held.rs

diag-nothing-holds-in-it-can-move-41a0 = «{ $name }» денесін { $names } бағытында ештеңе ұстап тұрған жоқ: ол жалғыз немесе жалғанған денелермен бірге ығысып кетуі мүмкін
diag-join-it-to-ground-or-to-f640 = оны мойынтірекпен немесе білікпен «ground» немесе іргетас денесіне жалғаңыз; демпфер ешнәрсені орнында ұстамайды
diag-of-has-no-effect-what-it-e0f8 = { $name } мәні («{ $slot }») әсер етпейді: ол жалғанған дене көлбемейді
diag-give-a-disc-its-diametral-inertia-7912 = диск көлбеуі үшін оған diametral_inertia беріңіз
diag-is-clamped-at-which-does-not-8696 = «{ $name }» бөлшегі «{ $body }» денесіне қатаң бекітілген, ал ол көлбемейді
diag-give-its-to-let-it-tilt-696b = «{ $body }» денесі көлбеуі үшін оған { $lets } беріңіз

## laval/src/file/joints.rs

diag-this-machine-has-no-body-add-f649 = бұл машинада дене жоқ: бөлшек қосыңыз, мысалы диск
diag-is-attached-to-which-is-a-ef10 = { $kind } «{ $block }»: бекітілген «{ $name }» бөлшегі ({ $other }) дене емес
diag-not-a-body-2491 = дене емес
diag-the-position-on-has-no-effect-fbb2 = «{ $name }» денесіндегі орын әсер етпейді: оның түрі { $kind }, ол көлбемейді
diag-no-effect-04cf = әсері жоқ

## laval/src/file/mod.rs

diag-the-kind-of-is-declared-twice-ad11 = { $what }: { $kind } түрі екі рет жарияланған
diag-declares-the-key-twice-abcf = { $kind }: { $name } өрісі екі рет жарияланған

## laval/src/file/names.rs

diag-unknown-parameter-af90 = белгісіз параметр
diag-coordinates-of-this-machine-baed = бұл машинаның координаталары: { $all }
diag-there-is-no-coordinate-e0c3 = «{ $name }» координатасы жоқ
diag-unknown-coordinate-5bfd = белгісіз координата

## laval/src/file/naming.rs

diag-write-kind-not-type-4ed8 = type емес, kind = { $t } деп жазыңыз
diag-write-kind-with-one-of-9d60 = kind = ".." деп жазып, мыналардың бірін беріңіз: { $all }
diag-this-says-no-kind-ea9b = бұл { $block } бөлімінде түр көрсетілмеген
diag-kind-is-missing-ef9a = kind = ".." жоқ
diag-kind-must-be-a-word-in-cd0b = { $block }: kind тырнақшадағы сөз болуы керек, жазылғаны: { $shape }
diag-there-is-no-kind-of-called-2deb = { $what } үшін { $t } түрі жоқ
diag-unknown-kind-35ae = белгісіз түр
diag-kinds-of-studies-de0a = зерттеу түрлері: { $all }
diag-kinds-of-s-5328 = { $what } түрлері: { $all }
diag-the-name-of-a-must-be-68d4 = { $what } аты тырнақшадағы мәтін болуы керек, жазылғаны: { $shape }
diag-a-cannot-be-named-ground-fe8c = { $what } үшін «ground» аты рұқсат етілмейді
diag-reserved-1e48 = сақталған ат
diag-ground-is-the-fixed-surroundings-that-f758 = «ground» – бөлшектер бекітілетін қозғалмайтын орта
diag-cannot-be-the-name-of-a-90a3 = { $t } аты { $what } үшін жарамайды
diag-not-a-name-8729 = ат емес
diag-for-instance-5228 = мысалы, { $name }: { $help }

## laval/src/file/nested.rs

diag-write-the-name-of-a-study-e443 = осы файлдағы зерттеу атын немесе { $example } деп жазыңыз
diag-a-study-76fb = зерттеу
diag-studies-of-this-file-that-can-5f25 = осы файлдың орындауға болатын зерттеулері: { $all }
diag-add-such-a-study-to-this-bcab = осы файлға сондай зерттеу қосыңыз немесе мұнда { $example } деп жазыңыз
diag-is-but-no-study-has-that-9fe6 = { $who } = { $name }, бірақ мұндай атты зерттеу жоқ
diag-no-such-study-32eb = мұндай зерттеу жоқ
diag-cannot-be-a-study-of-kind-15ef = { $who }: { $kind } түріндегі зерттеу болмайды, ол өзі басқа зерттеуді орындайды
diag-runs-another-study-11b5 = басқа зерттеуді орындайды
diag-write-4281 = [{"{"} parameter = "drum.mass", distribution = "normal", deviation = "2 %" {"}"}] деп жазыңыз
diag-a-list-of-uncertain-parameters-3ed5 = белгісіздігі бар параметрлер тізімі
diag-names-twice-9ac4 = { $who }: { $parameter } екі рет аталған
diag-named-above-004f = жоғарыда аталған
diag-an-uncertain-parameter-196d = белгісіздігі бар параметр
diag-has-no-f0cb = { $who }: { $key } жоқ
diag-is-missing-9c2c = { $key } = .. жоқ
diag-a-text-6622 = мәтін
diag-cannot-be-eb0f = { $who }: { $kind } мәні жарамайды
diag-distributions-8a45 = үлестірімдер: { $all } ({ $meanings })
diag-not-a-distribution-147d = үлестірім емес

## laval/src/file/numbers.rs

diag-write-a-number-with-a-unit-5e75 = бірлігі бар санды тырнақшада ({ $example }) немесе бірліксіз санды SI бірлігінде жазыңыз
diag-a-finite-number-is-needed-9e4f = { $who }: ақырлы сан керек
diag-not-finite-0a50 = ақырлы емес
diag-is-it-must-be-06bd = { $who } = { $value }; рұқсат етілетін мән: { $bounds }
diag-write-if-you-mean-percent-1b90 = процент болса, "{ $x } %" деп жазыңыз
diag-a-bare-number-is-in-put-f863 = бірліксіз санның бірлігі { $unit }; басқа бірлік ({ $examples }) үшін сан мен бірлікті тырнақшаға алыңыз
diag-out-of-bounds-444d = шектен тыс
diag-a-whole-number-or-auto-fc98 = бүтін сан немесе "auto"
diag-a-whole-number-5f04 = бүтін сан
diag-is-it-must-be-a-whole-6f22 = { $who } = { $i }; { $min } – { $max } аралығындағы бүтін сан немесе "auto" керек
diag-is-it-must-be-a-whole-a695 = { $who } = { $i }; { $min } – { $max } аралығындағы бүтін сан керек
diag-write-without-quotes-c0ab = { $t } мәнін тырнақшасыз жазыңыз
diag-is-needed-not-0ee8 = { $who }: керегі { $wanted }, жазылғаны: { $t }
diag-not-a-whole-number-a94c = бүтін сан емес
diag-write-df59 = { $number } деп жазыңыз
diag-is-needed-this-number-has-a-f0fe = { $who }: керегі { $wanted }; бұл сан бөлшек немесе тым үлкен
diag-write-one-value-for-both-directions-1e77 = екі бағытқа бір мән немесе {"{"} x = .., y = .. {"}"} жазыңыз
diag-write-exactly-one-of-them-df4b = мыналардың тек біреуін жазыңыз: {"{"} { $names } = .. {"}"}
diag-one-of-several-quantities-7ee2 = бірнеше шаманың бірі
diag-wants-exactly-one-of-none-given-5b19 = { $who }: { $names } ішінен дәл біреуі керек; ешқайсысы берілмеген
diag-wants-exactly-one-of-given-eadc = { $who }: { $names } ішінен дәл біреуі керек; берілгені: { $found }
diag-exactly-one-6b94 = дәл біреу
diag-write-one-value-or-with-values-9303 = бір мән немесе {"{"} from = .., to = .., points = .. {"}"} жазыңыз, мәндерінің бірлігі: { $examples }
diag-write-one-value-or-with-numbers-3184 = бір мән немесе {"{"} from = .., to = .., points = .. {"}"} жазыңыз, мәндері – сандар
diag-a-range-f017 = ауқым
diag-a-range-is-points-may-be-3a42 = ауқым былай жазылады: {"{"} from = .., to = .., points = .. {"}"}; points өрісін қалдыруға болады
diag-begins-and-ends-at-9f6a = { $who }: басы да, соңы да { $from }
diag-empty-range-0d7b = бос ауқым
diag-from-and-to-must-differ-6d65 = from мен to әртүрлі болуы керек
diag-a-finite-number-with-a-unit-65fb = бірлігі бар ақырлы сан
diag-a-table-of-columns-f422 = бағандар кестесі
diag-write-2117 = {"{"} { $names } {"}"} деп жазыңыз
diag-has-no-column-40e2 = { $who }: { $name } бағаны жоқ ({ $doc })
diag-is-missing-fa44 = { $name } = [..] жоқ
diag-the-columns-differ-in-length-has-d5e8 = { $who }: бағандардың ұзындығы әртүрлі: { $first } бағанында { $n } мән, { $name } бағанында { $column } мән
diag-other-length-7560 = ұзындығы басқа
diag-has-no-columns-4cc3 = { $who }: баған жоқ
diag-empty-a649 = бос
diag-put-it-in-brackets-also-when-fec0 = мәнді тік жақшаға алыңыз, ол біреу болса да: [..]
diag-a-list-of-numbers-ae1f = сандар тізімі
diag-the-list-is-empty-168a = { $who }: тізім бос

## laval/src/file/reader.rs

diag-the-file-has-mb-at-most-251d = файл көлемі { $size } MB; көп дегенде 64 MB оқылады
diag-tables-within-more-than-others-are-f2ff = { $most } кестеден артық кестенің ішіне салынған кестелер оқылмайды
diag-nested-too-deeply-40e0 = қабаттасуы тым терең
diag-the-file-is-no-text-byte-0366 = файл мәтін емес: { $number }-байт NUL (0x00), мәтінде ондай байт болмайды
diag-nul-402d = NUL
diag-save-it-as-utf-8-often-3d66 = файлды UTF-8 түрінде сақтаңыз; көбіне себебі – ескі кодтаудағы µ немесе ° бірлік таңбасы
diag-the-file-is-not-utf-8-a89f = файл UTF-8 мәтіні емес: { $number }-байт 0x{ $byte }
diag-here-44f0 = осында
diag-a-machine-is-an-object-with-b397 = машина – machine, part және study өрістері бар объект, берілгені: { $shape }

## laval/src/file/references.rs

diag-the-name-of-a-body-2307 = дене аты
diag-write-drum-or-4587 = "drum" немесе {"{"} body = "drum", at = "40 mm" {"}"} деп жазыңыз
diag-must-be-a-body-the-ground-3c72 = { $who }: дене керек; мұнда ground рұқсат етілмейді
diag-the-name-of-a-body-is-95ae = { $who }: дене аты жоқ
diag-names-no-body-382f = { $who }: дене аталмаған
diag-body-is-missing-8cdf = body = .. жоқ
diag-write-f6dd = {"{"} body = "drum", at = "40 mm" {"}"} деп жазыңыз
diag-the-ground-has-no-position-42fd = { $who }: ground үшін орын берілмейді
diag-leave-this-out-139b = мұны алып тастаңыз
diag-write-between-drum-base-one-of-ab81 = between = ["drum", "base"] деп жазыңыз; екеуінің бірі "ground" болуы мүмкін
diag-a-list-of-two-points-271a = екі нүкте тізімі
diag-must-name-two-points-given-82c3 = { $who }: екі нүкте аталуы керек; берілгені: { $given }
diag-two-points-bc22 = екі нүкте
diag-connects-with-itself-7d64 = { $who }: { $what } нүктесі өзіне жалғанған
diag-the-same-point-twice-e8b6 = бір нүкте екі рет
diag-is-but-no-part-is-named-3d65 = { $who } = { $path }, бірақ { $block } атты бөлшек жоқ
diag-parts-of-this-file-001d = осы файлдың бөлшектері: { $all }
diag-no-such-part-f861 = мұндай бөлшек жоқ
diag-is-but-is-a-list-studies-307e = { $who } = { $path }, бірақ «{ $name }» – тізім: зерттеулер оның мәндерін өзгертпейді
diag-studies-vary-single-numbers-parameters-of-2b8a = зерттеулер жеке сандарды өзгертеді; { $kind } параметрлері: { $all }
diag-a-list-no-parameter-e77d = тізім, параметр емес
diag-names-the-part-and-none-of-5c03 = { $who }: { $block } бөлшегі аталған, ал параметрі аталмаған
diag-is-but-a-has-no-parameter-d1e5 = { $who } = { $path }, бірақ { $kind } түрінде { $rest } параметрі жоқ
diag-parameters-of-a-0768 = { $kind } параметрлері: { $all }
diag-no-such-parameter-4b6b = мұндай параметр жоқ
diag-write-0abe = {"{"} parameter = "part.parameter", from = .., to = .., points = .. {"}"} деп жазыңыз
diag-the-range-of-a-parameter-5b06 = параметр ауқымы
diag-names-no-parameter-1d76 = { $who }: параметр аталмаған
diag-parameter-is-missing-4f11 = parameter = .. жоқ
diag-the-path-of-a-parameter-9555 = параметр жолы
diag-write-5182 = [{"{"} parameter = "part.parameter", from = .., to = .. {"}"}] деп жазыңыз
diag-a-list-of-ranges-of-parameters-9cbf = параметр ауқымдарының тізімі
diag-names-twice-8475 = { $who }: { $path } екі рет аталған
diag-the-name-of-a-coordinate-6fbe = координата аты
diag-the-name-of-a-coordinate-is-24bc = { $who }: координата аты жоқ
diag-write-it-as-in-drum-x-5010 = "drum.x" түрінде жазыңыз
diag-a-table-of-initial-values-4b73 = бастапқы мәндер кестесі
diag-write-e21e = {"{"} "drum.x" = "1 mm", "drum.x'" = "0.1 m/s" {"}"} деп жазыңыз

## laval/src/file/syntax.rs

diag-the-list-of-is-not-closed-7aa9 = { $key } тізімі жабылмаған
diag-the-table-of-is-not-closed-f05f = { $key } кестесі жабылмаған
diag-is-missing-a1f6 = { $missing } жоқ
diag-write-ab95 = { $line } деп жазыңыз
diag-so-far-only-the-syntax-and-f296 = әзірге тек синтаксис пен жеке мәндер тексерілді: бөлшектер мен зерттеулердің сәйкестігі синтаксис түзетілген соң тексеріледі
diag-this-line-holds-the-control-character-c33b = бұл жолда { $code } басқару таңбасы бар, мәтінде ондай таңба болмайды
diag-remove-it-f612 = оны алып тастаңыз
diag-stands-twice-in-the-file-4a48 = { $body } файлда екі рет тұр
diag-the-second-time-236c = екінші рет
diag-write-one-block-or-double-brackets-7c6f = бір бөлім жазыңыз немесе бірнешеуі рұқсат етілсе, қос жақша қойыңыз: [[part]], [[study]]
diag-the-key-is-given-twice-in-59e4 = { $word } өрісі бір бөлімде екі рет берілген
diag-keep-one-of-the-two-a-15af = екеуінің бірін қалдырыңыз; келесі бөлшек өз [[part]] тақырыбынан басталады
diag-the-header-of-this-block-is-b840 = бұл бөлімнің тақырыбы дұрыс жабылмаған
diag-brackets-91a2 = жақша
diag-write-machine-c5b2 = [machine] деп жазыңыз
diag-write-d669 = [[{ $word }]] деп жазыңыз
diag-this-line-is-neither-a-block-beb3 = бұл жол бөлім тақырыбы да, мәні бар өріс те емес
diag-not-understood-f2b2 = түсініксіз
diag-write-key-value-machine-part-or-0363 = өріс = мән, [machine], [[part]] немесе [[study]] деп жазыңыз; түсініктеме # таңбасынан басталады
diag-the-value-of-is-missing-b5bb = { $key } өрісінің мәні жоқ
diag-nothing-behind-02e0 = = белгісінен кейін ештеңе жоқ
diag-write-8c88 = { $key } = ".." деп жазыңыз
diag-cannot-be-a-key-1991 = { $key } өріс аты бола алмайды
diag-not-a-key-1e19 = өріс аты емес
diag-a-key-is-one-word-of-4542 = өріс аты – әріптерден, цифрлардан, _ және - таңбаларынан тұратын бір сөз; өріс = мән деп жазыңыз
diag-a-quotation-mark-is-missing-in-97fa = { $key } өрісінің мәнінде тырнақша жетіспейді
diag-not-closed-f52d = жабылмаған
diag-write-dea8 = { $key } = "{ $value } деп жазыңыз
diag-write-981e = { $key } = { $value }" деп жазыңыз
diag-texts-and-quantities-stand-between-two-eaf9 = мәтіндер мен шамалар екі тырнақшаның арасында тұрады
diag-a-brace-is-missing-in-the-f638 = { $key } өрісінің мәнінде фигуралық жақша жетіспейді
diag-must-match-94c5 = {"{"} және {"}"} жақшалары жұптасуы керек
diag-a-table-is-written-1c60 = кесте былай жазылады: {"{"} x = "..", y = ".." {"}"}
diag-a-bracket-is-missing-in-the-9d9f = { $key } өрісінің мәнінде тік жақша жетіспейді
diag-and-must-match-d619 = [ және ] жақшалары жұптасуы керек
diag-a-list-is-written-a8d4 = тізім былай жазылады: ["..", ".."]
diag-the-value-of-cannot-be-read-12c4 = { $key } өрісінің мәні оқылмайды
diag-inside-lists-and-tables-too-texts-7ba8 = тізім мен кестенің ішінде де мәтіндер мен шамалар тырнақшада тұрады, элементтер үтірмен бөлінеді: {"{"} x = "1 mm", y = "2 mm" {"}"}
diag-the-value-of-must-stand-in-fc2a = { $key } өрісінің мәні тырнақшада тұруы керек, себебі оның бірлігі бар
diag-quotes-are-missing-ee9e = тырнақша жоқ
diag-write-4a1c = { $key } = "{ $value }" деп жазыңыз
diag-the-value-of-must-stand-in-d51a = { $key } өрісінің мәні тырнақшада тұруы керек
diag-this-line-cannot-be-read-0302 = бұл жол оқылмайды: { $why }

## laval/src/file/tree.rs

diag-a-number-d67a = сан
diag-true-or-false-80f6 = true немесе false
diag-an-empty-list-4d93 = бос тізім
diag-a-list-4075 = тізім
diag-a-table-9be6 = кесте
diag-a-date-402c = күн
diag-null-3ca3 = null

## laval/src/file/values.rs

diag-unknown-unit-f106 = белгісіз бірлік
diag-no-unit-2424 = бірлігі жоқ
diag-wrong-dimension-b8aa = өлшемділігі басқа
diag-turns-or-radians-4d76 = айналым ба, радиан ба?
diag-no-number-15dc = сан жоқ
diag-a-pure-number-has-none-a311 = өлшемсіз санда бірлік болмайды
diag-is-given-in-2983 = { $quantity } – бірліктері: { $examples }
diag-is-needed-not-f6c2 = { $who }: керегі { $wanted }, жазылғаны: { $shape }
diag-allowed-here-b4fe = мұнда рұқсат етілетіні: { $all }
diag-put-it-in-quotes-8ea7 = тырнақшаға алыңыз
diag-a-word-8144 = сөз
diag-write-one-of-91bc = мыналардың бірін жазыңыз: { $all }
diag-cannot-be-e72c = { $who }: { $t } мәні жарамайды
diag-did-you-mean-choose-eeac = мүмкін, { $near } деп жазбақ болдыңыз ба? Таңдаңыз: { $all }
diag-choose-c55d = таңдаңыз: { $all }
diag-not-one-of-its-words-2a4f = рұқсат етілген сөздердің бірі емес
diag-write-true-or-false-without-quotes-cb7a = true немесе false деп тырнақшасыз жазыңыз

## laval-model/src/diagnostic.rs

diag-it-cannot-be-assembled-8afc = құрастыру мүмкін емес

## laval-model/src/model/field.rs

diag-above-0-26cb = 0 мәнінен үлкен
diag-above-5980 = { $least } мәнінен үлкен
diag-0-or-more-6fec = 0 немесе одан үлкен
diag-at-least-c24a = кемінде { $least }
diag-finite-511b = ақырлы
diag-at-most-0c11 = көп дегенде { $most }
diag-between-and-c753 = { $least } – { $most } аралығында
diag-between-0-and-9eeb = 0 – { $most } аралығында
diag-and-at-most-cc06 = { $least }, көп дегенде { $most }

## laval-model/src/model/inertia.rs

diag-and-no-inertia-is-left-for-2cc3 = «{ $slot }»: { $what }, { $name } координатасында инерция қалмайды

## laval-model/src/model/params.rs

diag-is-missing-3e54 = { $name } берілмеген
diag-is-it-must-be-2e8e = { $name } = { $value }; рұқсат етілетін мән: { $wanted }

## laval-model/src/model/system.rs

diag-the-machine-has-no-body-that-7801 = машинада қозғала алатын дене жоқ
diag-add-a-part-such-as-a-ab6a = бөлшек қосыңыз, мысалы диск: kind = "disc" және массасы бар [[part]]
diag-two-parts-are-named-638c = екі бөлшектің аты бірдей: «{ $name }»
diag-give-each-part-its-own-name-aa86 = әр бөлшекке өз атын беріңіз
diag-part-takes-parameters-b0e6 = «{ $name }» бөлшегінің параметр саны: { $slots }
diag-is-attached-to-which-does-not-caff = «{ $slot }»: бекітілген «{ $name }» денесі жоқ
diag-bodies-of-this-machine-ground-e4bc = бұл машинаның денелері: { $bodies }, ground
diag-is-attached-to-which-is-not-24c5 = «{ $slot }»: бекітілген «{ $name }» бөлшегі дене емес
diag-joins-a-point-to-itself-4999 = «{ $name }» бөлшегі нүктені өзіне жалғайды
diag-parts-of-this-machine-eb3a = бұл машинаның бөлшектері: { $names }
diag-what-a-file-says-in-another-eeb2 = файлда басқа түрде берілген шама (мысалы, көлемі бойынша толтыру) ол білдіретін параметр арқылы өзгертіледі
diag-parameters-of-7bbb = «{ $part }» бөлшегінің параметрлері: { $near } ({ $other })
diag-is-no-parameter-is-a-list-51d9 = «{ $path }» параметр емес: «{ $name }» – тізім, зерттеулер оның мәндерін өзгертпейді
diag-there-is-no-parameter-e472 = «{ $path }» параметрі жоқ

## laval-model/src/model/timed.rs

diag-has-no-form-in-the-time-79ba = «{ $name }» бөлшегінің уақыт облысындағы формасы жоқ: { $why }
diag-use-a-study-in-the-frequency-2f24 = жиілік облысындағы зерттеуді қолданыңыз, мысалы forced_response

## laval-model/src/numerics.rs

diag-the-table-has-no-rows-b81e = кестеде жол жоқ
diag-the-columns-have-and-rows-7e32 = бағандардағы жол саны: { $x } және { $y }
diag-row-holds-a-number-that-is-048f = { $row }-жолда ақырлы емес сан бар
diag-the-argument-in-row-is-not-f142 = { $row }-жолдағы аргумент алдыңғысынан үлкен емес
diag-singular-matrix-no-pivot-in-column-de5d = матрица ерекше ({ $column }-бағанда жетекші элемент жоқ)
diag-a-matrix-of-the-eigenvalue-problem-a9ba = меншікті мәндер есебінің матрицасында ақырлы емес элемент бар
diag-the-eigenvalue-iteration-did-not-converge-94cd = меншікті мәндерді табатын итерация жинақталмады
diag-every-number-is-an-eigenvalue-the-489e = кез келген сан меншікті мән: анықтауыш тепе-тең нөлге тең
diag-the-equations-are-not-defined-here-d632 = мұнда теңдеулер анықталмаған: { $why }
diag-cancelled-7c41 = тоқтатылды

## laval-model/src/parts/balancer_ball/mod.rs

diag-a-track-has-balls-d20f = бір жолда { $n } шарик бар
diag-give-a-whole-number-of-balls-054f = әр жолға шарик санын бүтін санмен, кемінде 1 деп беріңіз
diag-the-tracks-have-more-than-balls-1d9d = жолдардағы шариктердің жалпы саны { $most } мәнінен асады
diag-give-fewer-balls-6bc4 = шарик санын азайтыңыз
diag-a-track-has-times-the-radius-4cd8 = бір жолдың радиусы негізгі радиустың { $r } есесі
diag-radius-is-a-positive-ratio-to-18f8 = radius – track_radius мәніне оң қатынас
diag-a-track-is-tilted-by-more-dbfd = бір жолдың көлбеуі 1.5 rad мәнінен асады
diag-tilt-is-in-addition-to-that-0d1b = tilt мәні теңгергіштің көлбеуіне қосылады
diag-balls-is-the-number-on-all-f8b1 = balls – барлық жолдағы шариктердің жалпы саны; оны алып тастаңыз, әр жолдағы саны жолдарда берілген
diag-balls-and-the-tracks-have-75ed = balls = { $n }, ал жолдардағы саны { $each } = { $all }
diag-mass-ratios-are-given-for-balls-a4df = { $balls } шарикке { $given } масса қатынасы берілген
diag-mass-ratios-are-given-for-balls-4735 = { $balls } шарикке (жол саны { $tracks }) { $given } масса қатынасы берілген
diag-one-ratio-for-each-ball-track-9a94 = әр шарикке бір қатынас керек, жол-жолымен
diag-the-tilt-of-the-tracks-locks-0ce0 = жолдардың көлбеуі шариктерді түйін сызығында бекітіп қояды: r sin^2(tilt) = { $locking } мәні сақина эксцентриситетінің оннан бірінен, { $tenth } мәнінен аз болуы керек
diag-a-free-ring-needs-inertia-about-cb88 = еркін сақинаға түйін сызығына қатысты инерция моменті керек: diametral_inertia беріңіз
diag-no-ring-has-a-polar-inertia-5c83 = ешбір сақинаның полярлық инерция моменті ({ $polar_inertia }) диаметрлік моментінің ({ $diametral_inertia }) екі есесінен аспайды; жұқа сақинада дәл екі есе
diag-acts-on-free-rings-and-these-e719 = { $field } еркін сақиналарға ғана әсер етеді, бұл сақиналар бекітілген: rings = "free" мәнін де беріңіз
diag-the-ring-centre-from-the-shaft-43cc = сақина центрі (біліктен { $s }) жолдан тыс (радиусы { $r })
diag-balls-do-not-fit-on-track-6b52 = { $number }-жолға { $n } шарик сыймайды: { $fits } шарикке ғана орын бар
diag-balls-that-touch-and-balls-that-edac = жанасатын және жанаспайтын шариктер – әртүрлі машина: әрқайсысын бөлек құрыңыз
diag-balls-that-touch-need-their-size-32af = жанасатын шариктерге өлшем керек: ball_radius беріңіз

## laval-model/src/parts/bearing_cubic.rs

diag-the-force-no-longer-restores-beyond-d9b0 = деформация { $d } мәнінен асқанда күш қайтарушы болмайды: ол итереді
diag-valid-to-the-deflection-the-law-7022 = заң жарамды деформация шегі valid_to
diag-softens-c1a5 = қатаңдығы кемиді
diag-this-is-below-check-sign-and-761b = бұл шектен ({ $place }) төмен; таңбасы мен бірлігін (N/m^3) тексеріңіз немесе valid_to арқылы заңның жарамды ауқымын беріңіз
diag-an-isotropic-law-has-the-same-6751 = изотропты заңда { $field } мәні x пен y бағыттарында бірдей
diag-give-one-value-or-use-law-a1f9 = бір мән беріңіз немесе law = "per_axis" қолданыңыз

## laval-model/src/parts/bearing_hertz.rs

diag-a-radial-law-has-no-preload-346e = радиалды заңда алдын ала керіліс жоқ: саңылауы теріс бола алмайды
diag-use-law-per-axis-where-a-ac72 = law = "per_axis" қолданыңыз: онда теріс саңылау – қарама-қарсы жанасулардың керілісі
diag-a-hertz-contact-without-preload-has-e0b4 = керіліссіз Герц жанасуының тыныштықта қатаңдығы жоқ: сызықтандыру амплитудасын беріңіз (гармоникалық зерттеу өзі береді), керіліс (law = "per_axis" және теріс саңылау) немесе қажетті амплитудаларға жуықталған bearing_cubic беріңіз

## laval-model/src/parts/bearing_linear/mod.rs

diag-a-table-over-speed-has-at-7512 = айналу жиілігі бойынша кестеде кемінде екі жол болады; бір айналу жиілігі үшін коэффициенттердің өзін беріңіз
diag-speeds-must-increase-from-row-to-61ab = айналу жиіліктері жолдан жолға өсуі керек: { $number }-жолда { $speed }, оның алдында { $before }
diag-column-speed-e6ee = speed бағаны: { $why }
diag-column-has-rows-and-column-speed-849d = { $name } бағанында { $values } жол, speed бағанында { $speed } жол бар
diag-column-row-is-not-a-finite-b5da = { $name } бағаны: { $number }-жолдағы мән ақырлы сан емес
diag-frequencies-of-vibration-are-not-negative-43a1 = тербеліс жиіліктері теріс болмайды: { $number }-жолда { $frequency } берілген
diag-a-table-over-speed-and-frequency-ef2a = айналу жиілігі мен тербеліс жиілігі бойынша кестеде кемінде екі тербеліс жиілігі болады; коэффициенттер оған тәуелсіз болса, frequency бағанын алып тастаңыз
diag-a-table-over-speed-and-frequency-9644 = айналу жиілігі мен тербеліс жиілігі бойынша кестеде кемінде екі айналу жиілігі болады
diag-rows-and-are-of-one-speed-2741 = { $first } және { $second } жолдар бір айналу жиілігі мен тербеліс жиілігіне жатады: { $speed } және { $frequency }
diag-every-speed-of-the-table-has-5ca8 = кестенің әр айналу жиілігінде барлық тербеліс жиіліктері болады, барлығы { $all } жол: { $frequency } кезіндегі { $speed } жолы жоқ
diag-every-speed-of-the-table-has-b24d = кестенің әр айналу жиілігінде барлық тербеліс жиіліктері болады, барлығы { $all } жол: { $count } жол жетіспейді, біріншісі { $frequency } кезіндегі { $speed }
diag-is-given-beside-bb0c = { $short } пен { $twice } қатар берілген
diag-stands-for-and-give-the-one-5d24 = { $short } мәні { $first } және { $second } мәндерін бірден білдіреді: не сол бір мәнді, не осы екеуін беріңіз
diag-the-bearing-has-no-coefficient-all-9c73 = мойынтіректе коэффициент жоқ: сегізі де нөл
diag-give-stiffness-or-kxx-and-kyy-27b3 = stiffness немесе kxx пен kyy (қажет болса басқаларын) немесе айналу жиілігі бойынша кесте беріңіз
diag-beyond-is-given-without-a-table-38bd = beyond кестесіз берілген
diag-constant-coefficients-hold-at-every-speed-c9f6 = тұрақты коэффициенттер кез келген айналу жиілігінде жарамды: beyond мәнін алып тастаңыз немесе айналу жиілігі бойынша кесте беріңіз
diag-is-given-as-a-constant-beside-d5bb = { $name } тұрақтысы кестемен қатар берілген
diag-a-bearing-has-constant-coefficients-or-463b = мойынтіректе не тұрақты коэффициенттер, не кесте болады: тұрақтыларды кестеге бірдей жолдар етіп қойыңыз
diag-the-coefficients-come-from-the-table-544d = коэффициенттер кестеден алынады: қатар берілген тұрақты әсер етпейді

## laval-model/src/parts/damper.rs

diag-rotating-damping-must-be-the-same-4a19 = айналатын демпферлеу x пен y бағыттарында бірдей болуы керек
diag-different-values-in-rotating-axes-would-4b5b = айналатын осьтердегі әртүрлі мәндер машина теңдеулерін уақыт бойынша периодты етеді
diag-this-damper-was-built-without-tilt-db59 = бұл демпфер көлбеусіз құрылған

## laval-model/src/parts/disc.rs

diag-an-unbalance-of-a669 = { $u } дисбалансы
diag-sizes-are-positive-phase-180-deg-1024 = өлшемдер оң болады; phase = "180 deg" оны қарсы жаққа бұрады
diag-an-unbalance-has-no-place-4d16 = дисбаланстың орны жоқ
diag-phase-is-an-angle-up-to-6ebd = phase – 1000 rad мәніне дейінгі бұрыш, биіктігі 100 m мәніне дейін
diag-the-height-of-an-unbalance-acts-aa0a = дисбаланстың биіктігі көлбеуге әсер етеді, ал бұл диск көлбемейді
diag-give-diametral-inertia-as-well-or-5350 = diametral_inertia мәнін де беріңіз немесе at өрісін алып тастаңыз
diag-no-body-has-a-polar-inertia-d7e0 = ешбір дененің полярлық инерция моменті ({ $polar_inertia }) диаметрлік моментінің ({ $diametral_inertia }) екі есесінен аспайды; жұқа дискіде дәл екі есе
diag-acts-on-the-tilt-and-this-25d2 = { $field } көлбеуге әсер етеді, ал бұл диск көлбемейді: diametral_inertia мәнін де беріңіз

## laval-model/src/parts/liquid/check.rs

diag-the-free-surface-radius-lies-outside-6f91 = еркін бет (радиусы { $value }) қуыстан тыс (радиусы { $radius })
diag-an-empty-a-partly-filled-and-0108 = бос, ішінара толған және толық қуыс – әртүрлі машиналар: әрқайсысын бөлек құрыңыз
diag-planar-knows-no-tilt-of-the-902a = planar моделінде қуыс көлбеуі жоқ: қисайған қуыс үшін model = "strip" немесе "spatial" беріңіз
diag-a-liquid-with-viscosity-and-one-e51c = тұтқыр және тұтқырлығы жоқ сұйықтық – әртүрлі машиналар: әрқайсысын бөлек құрыңыз
diag-this-model-knows-no-viscosity-planar-a984 = бұл модельде тұтқырлық жоқ; ол planar, strip және spatial модельдерінде бар
diag-a-full-cavity-with-viscosity-is-2bad = тұтқыр сұйықтыққа толық толған қуыс модельдердің ішінде жоқ: viscosity мәнін алып тастаңыз немесе аздап ауа қалдырыңыз
diag-the-viscosity-damps-the-wave-by-4b0e = тұтқырлықтың өзі толқынды демпферлейді: екеуінің бірін беріңіз
diag-this-model-knows-no-wave-damping-8681 = бұл модельде толқын демпферлеуі жоқ: spatial моделіне тұтқырлық беріледі

## laval-model/src/parts/liquid/mod.rs

diag-the-free-surface-is-the-inner-bfe9 = еркін бет – қабырғадағы қабаттың ішкі беті: 0 болса, толық, қуыс радиусына тең болса, бос
diag-this-is-times-what-the-cavity-e6e6 = бұл қуыс сыйымдылығының { $fraction } есесі
diag-the-cavity-holds-of-this-liquid-6415 = қуыс сыйымдылығы { $cavity }, бұл сұйықтықтан { $density }
diag-only-odd-harmonics-act-on-a-e4ca = көлбеуге тек тақ гармоникалар әсер етеді, соңғысы тақ болуы керек
diag-give-axial-harmonics-or-dfc4 = axial_harmonics = { $less } немесе { $more } беріңіз
diag-has-no-axial-harmonics-9a50 = { $word } моделінде осьтік гармоникалар жоқ
diag-model-spatial-has-them-leave-axial-677f = олар model = "spatial" моделінде бар; басқа жағдайда axial_harmonics өрісін алып тастаңыз
diag-without-viscosity-is-exact-in-time-1ca0 = тұтқырлықсыз { $word } моделі уақыт облысында дәл
diag-leave-time-error-out-with-model-2e83 = time_error өрісін алып тастаңыз; model = "spatial" немесе тұтқырлық болса, ол толқындар санын анықтайды
diag-planar-tilt-takes-from-the-tilt-aab4 = planar_tilt осындай биік қуыстың көлбеу инерциясын { $taken } мәніне азайтады: strip пен spatial азайтпайды
diag-give-model-strip-or-spatial-or-9e71 = model = "strip" немесе "spatial" беріңіз; немесе дененің diametral_inertia мәнін арттырыңыз

## laval-model/src/parts/liquid/timed.rs

diag-its-waves-are-computed-up-to-7190 = оның толқындары axial_harmonics = { $most } мәніне дейін есептеледі; барлығы керек болса, axial_harmonics өрісін алып тастаңыз
diag-waves-d3ee = { $n } толқын
diag-that-of-a-cavity-that-is-b496 = білігіне қарай қисайған қуыстың формасы тек тұрақты айналу жиілігінде жарамды
diag-the-layer-of-a-viscous-liquid-2e6d = тұтқыр сұйықтық қабаты айналу жиілігіне тәуелді, сондықтан оның уақыт облысындағы формасы бір жиілік үшін құрылады; transient пен basins бір жиілікте есептеледі
diag-the-layer-of-a-viscous-liquid-1419 = тұтқыр сұйықтық қабаты айналу жиілігіне тәуелді, сондықтан оның уақыт облысындағы формасы тек тұрақты айналу жиілігінде жарамды
diag-do-not-give-its-reaction-with-e64e = { $most } оның реакциясын { $allowed } салыстырмалы қателікпен бермейді; time_error мәнін арттырыңыз
diag-without-spin-nothing-holds-the-layer-f2d3 = айналусыз қабатты қабырғада ештеңе ұстап тұрмайды
diag-give-the-study-a-speed-above-e978 = зерттеуге 0 мәнінен үлкен айналу жиілігін беріңіз; тыныш тұрған машинада тұтқырлықсыз model = "frozen" сұйықтықты масса ретінде есепке алады
diag-try-time-error-64e7 = time_error = { $reached } мәнін қолданып көріңіз
diag-allow-a-larger-time-error-b71c = time_error мәнін арттырыңыз
diag-do-not-give-its-reaction-on-8989 = { $most } оның реакциясын ({ $of }) { $allowed } салыстырмалы қателікпен бермейді; { $larger }{ $strip }
diag-its-reaction-on-cannot-be-computed-87db = оның реакциясын ({ $of }) айналу жиілігінің төрт есесіне дейінгі барлық қозғалыс үшін рұқсат етілген { $allowed } қателігінің оннан біріндей дәлдікпен есептеу мүмкін емес{ $strip }
diag-finding-the-form-of-its-reaction-e706 = оның реакциясының ({ $of }) формасын табу тым көп есептеуді қажет етеді; time_error мәнін арттырыңыз{ $strip }
diag-displacement-4336 = ығысу
diag-poles-23e2 = { $n } полюс
diag-tilt-023c = көлбеу
diag-or-model-strip-9bf1 = , немесе model = "strip" қолданыңыз
diag-its-form-in-the-time-domain-7c9b = оның уақыт облысындағы формасы басқа қуыс үшін құрылған; мұнда оның өлшемі мен толтырылуын өзгертуге болмайды

## laval-model/src/parts/motor.rs

diag-a-motor-with-curve-needs-2cf6 = curve = "{ $word }" мәні бар моторға { $name } керек
diag-add-10f4 = { $name } қосыңыз
diag-a-motor-with-curve-table-needs-b9a6 = curve = "table" мәні бар моторға кесте керек
diag-add-table-43fb = table = {"{"} speed = [..], share = [..] {"}"} қосыңыз
diag-the-torque-cannot-be-interpolated-7b6d = моментті интерполяциялау мүмкін емес: { $why }
diag-speeds-must-increase-from-row-to-ac99 = айналу жиіліктері жолдан жолға өсуі керек
diag-a-table-is-given-beside-curve-91c7 = кесте curve = "{ $word }" мәнімен қатар берілген
diag-say-curve-table-or-take-the-6386 = curve = "table" беріңіз немесе кестені алып тастаңыз
diag-the-torque-curve-needs-a-synchronous-b5c7 = момент қисығына 0 мәнінен үлкен synchronous_speed керек
diag-limited-power-needs-a-torque-and-2f00 = шектелген қуат үшін 0 мәнінен үлкен момент пен қуат керек

## laval/src/file/naming.rs

diag-a-name-is-made-of-letters-2e08 = ат кез келген жазудың әріптерінен, цифрлардан, бос орындардан, _ және - таңбаларынан тұрады, әріптен немесе цифрдан басталады, ұзындығы 64 таңбадан аспайды

## laval/src/file/reader.rs

diag-save-it-as-utf-8-text-af88 = файлды UTF-8 мәтіні түрінде сақтаңыз; ондай байттар UTF-16 файлдарында және бүлінген файлдарда болады
diag-it-looks-like-utf-16-save-fb74 = бұл UTF-16 сияқты; файлды UTF-8 түрінде сақтаңыз

## laval-model/src/parts/balancer_ball/mod.rs

diag-weight-acts-across-a-horizontal-axis-910f = ауырлық күші көлденең осьтің бойымен емес, оған көлденең бағытта әсер етеді: gravity = 0 беріңіз (оське көлденең ауырлық күші машинадан белгілі)

## laval-model/src/parts/shaft_lumped.rs

diag-is-given-without-a-diameter-3d73 = { $name } диаметрсіз берілген
diag-a-round-shaft-takes-diameter-below-a7a1 = дөңгелек білікке diameter және below немесе above немесе екеуі де беріледі; қатаңдығы берілген білікке олардың ешқайсысы берілмейді
diag-the-shaft-has-no-stiffness-13d9 = біліктің қатаңдығы берілмеген
diag-give-stiffness-or-the-diameter-of-f6c0 = stiffness беріңіз немесе дөңгелек біліктің диаметрін және нүктеден төмен не жоғары ұзындығын беріңіз
diag-a-shaft-with-material-damping-must-c344 = материалында демпферлеу бар біліктің қатаңдығы x пен y бағыттарында бірдей болуы керек
diag-unequal-stiffness-in-fixed-axes-is-1ae5 = қозғалмайтын осьтердегі әртүрлі қатаңдық – айналмайтын тірек: қасына damper бөлшегін қосыңыз
diag-cross-stiffness-is-at-most-sqrt-01fb = cross_stiffness мәні sqrt(kx ky) = { $limit } мәнінен аспайды: одан үлкені сыртқа итерер еді
diag-coupling-is-at-most-sqrt-stiffness-3fd0 = coupling мәні sqrt(stiffness tilt_stiffness) = { $limit } мәнінен аспайды: одан үлкені иілгенде энергия берер еді (қатаң бекітілген білікте оның 0.87 бөлігі)
diag-this-shaft-was-built-without-tilt-fed7 = бұл білік көлбеусіз құрылған
diag-this-shaft-was-built-without-material-7603 = бұл білік материал демпферлеуінсіз құрылған
diag-this-shaft-was-built-from-its-1847 = бұл білік өз қатаңдығы бойынша құрылған
diag-is-given-beside-the-diameter-of-1b3b = { $name } дөңгелек біліктің диаметрімен қатар берілген
diag-the-stiffness-follows-from-the-geometry-5348 = қатаңдық өлшемдерден есептеледі: екеуінің бірін алып тастаңыз
diag-is-given-without-the-length-5c8d = { $end } өрісі { $length } ұзындығынсыз берілген
diag-give-as-well-or-take-away-4a55 = { $length } мәнін де беріңіз немесе { $end } өрісін алып тастаңыз
diag-a-round-shaft-needs-a-length-8bde = дөңгелек білікке ұзындық керек
diag-inner-diameter-is-less-than-diameter-22f4 = inner_diameter мәні diameter мәнінен кіші болады
diag-is-at-least-0bb6 = { $name } мәні кемінде { $value }
diag-this-shaft-was-built-without-bd20 = бұл білік { $name } өрісінсіз құрылған
diag-a-shaft-pinned-at-its-only-7de2 = жалғыз шеті топсалы білік ештеңені ұстамайды: оны қатаң бекітіңіз немесе екінші шетін беріңіз
diag-the-stiffness-of-this-shaft-follows-b189 = бұл біліктің қатаңдығы өлшемдерінен есептеледі

## laval-model/src/parts/shaft_viscoelastic/mod.rs

diag-the-material-creeps-without-bound-in-8145 = материал шексіз жылжиды: ұзақ уақытта ол қатаңдығының 1 - K(0) = { $kept } бөлігін ғана сақтар еді, ал ол 0 мәнінен үлкен болуы керек; бұл ядро амплитудасының { $share } бөлігінен төмен мәнде жарамды
diag-give-amplitude-exponent-and-decay-of-e770 = әлсіз ерекше бір мүшенің amplitude, exponent және decay мәндерін немесе бірнеше мүше (terms) немесе exponentials беріңіз
diag-the-memory-of-the-material-is-3490 = материал жады екі рет берілген: { $first } және { $second }
diag-columns-share-and-rate-need-equally-dc8a = share және rate бағандарында жол саны бірдей, кемінде бір болуы керек
diag-row-a-share-is-not-negative-fdba = { $row }-жол: үлес теріс болмайды, rate мәні 0 мен 1e12 1/s аралығында жатады
diag-the-memory-of-the-material-is-6cac = материал жады берілмеген
diag-the-kernel-a-t-a-1-3db1 = A t^(a-1) exp(-b t) ядросына { $given } мәнімен бірге { $missing } керек
diag-columns-amplitude-exponent-and-decay-need-7b2b = amplitude, exponent және decay бағандарында жол саны бірдей, кемінде бір болуы керек
diag-row-of-the-terms-is-no-14f0 = terms кестесінің { $number }-жолы ядро емес: amplitude 0 немесе одан үлкен, exponent 0 мәнінен үлкен және көп дегенде 0.99, decay 0 мәнінен үлкен болуы керек
diag-lower-the-amplitude-or-raise-the-adb9 = amplitude мәнін азайтыңыз немесе decay мәнін арттырыңыз: баяу өшетін ядроның релаксациясы көбірек
diag-more-than-exponentials-would-be-needed-ac2b = бұл ядро, дәлдік және уақыт жолағы үшін { $most } мәнінен көп экспонента керек
diag-request-less-accuracy-a-narrower-band-022e = дәлдікті азайтыңыз, жолақты тарылтыңыз немесе тезірек өшетін ядро беріңіз
diag-the-shaft-has-no-stiffness-give-ad68 = біліктің қатаңдығы берілмеген: оны беріңіз немесе supports арқылы дөңгелек біліктің тірелу тәсілін көрсетіңіз
diag-supports-needs-the-of-the-shaft-8082 = supports = "{ $word }" үшін біліктің { $name } мәні керек
diag-has-no-effect-with-supports-6287 = supports = "{ $word }" болса, { $name } әсер етпейді
diag-the-disc-at-is-not-between-4718 = { $x } орнындағы диск аралығы { $l } болатын тіректердің арасында емес
diag-the-exponentials-were-chosen-for-another-1eef = экспоненталар басқа ядро үшін таңдалған, бұл ядродан айырмасы олардың дәлдігінен асады: машинаны осы ядромен құрыңыз немесе band жолағын кеңейтіңіз
diag-amplitude-exponent-and-decay-have-no-58ce = terms берілсе, amplitude, exponent және decay әсер етпейді
diag-amplitude-exponent-and-decay-have-no-4e1d = exponentials берілсе, amplitude, exponent және decay әсер етпейді

## laval-model/src/parts/spin_load.rs

diag-this-part-does-nothing-give-inertia-1f62 = бұл бөлшек ештеңеге әсер етпейді: inertia, drag немесе windage беріңіз

## laval-model/src/units/mod.rs

diag-is-needed-and-has-no-unit-a022 = керегі { $wanted }, ал { $digits } мәнінің бірлігі жоқ
diag-write-the-unit-behind-the-number-6a68 = саннан кейін бірлігін жазыңыз ({ $examples }); тырнақшасыз санның бірлігі { $expected }
diag-a-pure-number-0885 = өлшемсіз сан
diag-is-needed-is-f561 = керегі { $need } ({ $ex }); { $text } – { $is }
diag-is-needed-leaves-open-whether-turns-c66a = керегі { $need } ({ $ex }); { $text } айналым ба, радиан ба, белгісіз
diag-for-turns-write-rpm-hz-or-aed2 = айналым болса rpm, Hz немесе rev, радиан болса rad жазыңыз
diag-is-needed-is-a-torque-9c88 = керегі { $need } ({ $ex }); { $text } – айналдырушы момент
diag-is-needed-is-an-energy-4e75 = керегі { $need } ({ $ex }); { $text } – энергия

## laval-model/src/units/parse.rs

diag-this-is-not-a-number-3ddb = бұл сан емес
diag-the-number-is-too-large-d1af = сан тым үлкен
diag-the-number-is-too-small-to-26fc = сан тым кіші, оны 0 мәнінен ажырату мүмкін емес
diag-a-finite-number-is-needed-not-7676 = ақырлы сан керек, жазылғаны: { $head }
diag-this-text-is-empty-267d = бұл мәтін бос
diag-begins-with-no-number-ac94 = { $text } саннан басталмайды
diag-a-quantity-is-a-number-and-9dba = шама – сан мен бірлік; { $what }
diag-write-it-as-in-70-mm-3a41 = "70 mm" түрінде жазыңыз
diag-has-a-comma-in-its-number-f608 = { $text }: санда үтір бар
diag-write-the-decimal-point-as-in-e955 = ондық нүкте қойып, "1.5 mm" түрінде жазыңыз, разрядтарды бөлмеңіз
diag-has-a-space-inside-its-number-6e0d = { $text }: санның ішінде бос орын бар
diag-write-the-digits-together-as-in-4256 = цифрларды бірге, "3000 rpm" түрінде жазыңыз
diag-writes-a-power-of-ten-in-9497 = { $text }: онның дәрежесі сөзбен жазылған
diag-write-it-as-in-1-1e7-c4a9 = "1.1e7 N/m" түрінде жазыңыз
diag-has-two-decimal-points-edcf = { $text }: екі ондық нүкте бар
diag-write-the-number-as-in-1-bee8 = санды разрядтарға бөлмей, "1.5 mm" түрінде жазыңыз
diag-is-too-long-for-a-unit-846f = { $text } бірлік үшін тым ұзын
diag-does-not-belong-in-a-unit-043f = { $text } бірлікте болмайды
diag-a-temperature-in-degc-stands-alone-276c = degC бірлігіндегі температура жеке тұрады
diag-for-differences-and-in-products-write-9698 = айырмалар мен көбейтінділерде K жазыңыз
diag-this-unit-is-out-of-all-3847 = бұл бірлік барлық шектен тыс
diag-a-unit-cannot-begin-with-a-1143 = бірлік көбейту таңбасынан басталмайды
diag-has-two-readings-is-what-follows-4dcc = { $whole } екі түрлі оқылады: / мен бос орыннан кейінгі бірлік алымда ма, бөлімде ме?
diag-put-products-below-a-in-parentheses-42fc = бөлімдегі көбейтінділерді N/(m s) сияқты дөңгелек жақшаға алыңыз немесе N s/m сияқты алдымен алымын жазыңыз
diag-too-many-parentheses-45b6 = дөңгелек жақша тым көп
diag-a-closing-parenthesis-is-missing-6a33 = жабатын дөңгелек жақша жоқ
diag-nothing-fcf7 = ештеңе жоқ
diag-a-unit-is-expected-here-not-6ef4 = мұнда бірлік керек, жазылғаны: { $what }
diag-is-not-a-known-unit-cbb5 = { $word } – белгісіз бірлік
diag-a-closing-parenthesis-is-missing-in-1333 = дәрежеде жабатын дөңгелек жақша жоқ
diag-this-power-is-not-between-20-2848 = бұл дәреже -20 мен 20 аралығынан тыс немесе 0
diag-a-power-is-a-number-as-f8ee = дәреже – сан, мысалы m^2, m^1.5 немесе m^(10/9)

## laval-model/src/units/table.rs

diag-a-quantity-in-af40 = бірлігі { $unit } болатын шама

## laval-separation/src/batch.rs

diag-no-path-in-space-5c87 = кеңістіктік траектория жоқ

## laval-separation/src/carried.rs

diag-cups-swing-out-against-a-weight-0f4e = стакандар ось бойымен әсер ететін ауырлық күшіне қарсы ауытқиды, ал көлденең машинада ондай күш жоқ; олар қандай көлбеу бұрышында ұсталатынын көрсетіңіз

## laval-separation/src/law.rs

diag-the-shares-below-must-rise-from-712b = жинақталған үлестер 0 мәнінен 1 мәніне дейін өсуі керек
diag-the-last-share-below-is-it-e864 = соңғы жинақталған үлес { $last }; ол 1 болуы керек
diag-the-shares-of-the-classes-must-211d = кластардың үлестері теріс болмауы және бәрі бірдей нөл болмауы керек
diag-values-have-shares-6d11 = { $values } мәнге { $shares } үлес берілген
diag-the-values-must-be-positive-and-34e1 = мәндер оң болуы және жолдан жолға өсуі керек

## laval-separation/src/motion.rs

diag-the-drag-law-changes-its-piece-c2a7 = кедергі заңы { $t } сәтінде бөлігін қайта-қайта ауыстырады
diag-the-step-became-too-small-at-f4f4 = қадам { $t } сәтінде тым кішірейді
diag-stopped-at-after-steps-69bb = { $steps } қадамнан кейін { $t } сәтінде тоқтатылды

## laval-separation/src/recovery.rs

diag-stopped-9dac = тоқтатылды

## laval-separation/src/slowest.rs

diag-no-place-of-the-liquid-is-aad6 = сұйықтықта траектория басталатын орын табылмады

## laval/src/outcome/mod.rs

diag-the-end-bff1 = соңы
diag-in-the-table-1bb6 = { $name }, { $table } кестесінде
diag-column-of-table-has-rows-the-d4c8 = `{ $table }` кестесінің `{ $column }` бағанында { $found } жол, ал алдыңғы бағандарда { $expected } жол бар
diag-is-no-finite-number-6158 = { $what } ақырлы сан емес
diag-two-s-are-named-baa3 = { $what }: екеуінің аты бірдей, `{ $name }`
diag-figure-needs-which-is-missing-0bb0 = `{ $figure }` суретіне { $expected } `{ $table }` керек, ол жоқ
diag-figure-needs-in-table-137d = `{ $figure }` суретіне `{ $table }` кестесінде { $expected } `{ $column }` керек
diag-the-result-cannot-be-computed-16f8 = нәтижені есептеу мүмкін емес: { $e }
diag-a-value-of-the-machine-or-bcfe = машинаның немесе зерттеудің бір мәні тым үлкен немесе тым кіші
diag-the-study-s-result-is-inconsistent-dc5b = зерттеу нәтижесінде қайшылық бар: { $e }

## laval/src/output_folder.rs

diag-it-is-a-file-e707 = бұл – файл
diag-cannot-make-the-folder-4dd9 = { $folder } қалтасын жасау мүмкін емес: { $why }
diag-name-another-one-with-out-d81d = --out арқылы басқасын беріңіз
diag-cannot-write-f8b7 = { $path } файлына жазу мүмкін емес: { $e }
diag-mend-the-permissions-of-the-folder-8e1f = қалтаға рұқсатты түзетіңіз немесе --out арқылы басқасын беріңіз
diag-was-not-made-by-this-program-0488 = { $path } осы бағдарламамен жасалмаған, сондықтан өзгеріссіз қалады
diag-move-it-elsewhere-or-name-another-3b1e = оны басқа жерге көшіріңіз немесе --out арқылы басқа қалта беріңіз
diag-another-process-is-writing-into-92c3 = { $folder } қалтасына басқа процесс жазып жатыр
diag-another-process-number-is-writing-into-7450 = { $folder } қалтасына басқа процесс (нөмірі { $number }) жазып жатыр
diag-wait-until-it-has-ended-or-add0 = оның аяқталуын күтіңіз немесе --out арқылы басқа қалта беріңіз

## laval/src/report/renew.rs

diag-is-where-results-are-to-be-4cdb = { $path } – { $what }, ал нәтижелер сол орынға жазылуы керек
diag-a-file-of-another-program-48c0 = басқа бағдарламаның файлы
diag-a-folder-3924 = қалта
diag-no-folder-511c = қалта емес

## laval/src/report/write.rs

diag-cannot-write-581b = { $path } файлына жазу мүмкін емес: { $source }
diag-cannot-write-1-file-written-before-39ef = { $path } файлына жазу мүмкін емес: { $source } (бұған дейін жазылған 1 файл толық)
diag-cannot-write-files-written-before-it-09e7 = { $path } файлына жазу мүмкін емес: { $source } (бұған дейін жазылған { $n } файл толық)
diag-study-2678 = `{ $study }` зерттеуі: { $source }

## laval/src/store/cells.rs

diag-a-chunk-of-rows-and-columns-2774 = { $rows } жолдық, { $columns } бағандық бөлік { $found } өлшемімен есептелді

## laval/src/store/folder.rs

diag-cannot-remove-7a2c = { $path } файлын өшіру мүмкін емес: { $e }
diag-was-not-written-by-this-program-ed9c = { $path } осы бағдарламамен жазылмаған
diag-move-it-elsewhere-or-give-the-a880 = оны басқа жерге көшіріңіз немесе --out арқылы нәтижелерге басқа қалта беріңіз
diag-is-no-manifest-of-this-program-a5a1 = { $path } осы бағдарламаның манифесі емес: { $why }
diag-give-the-results-another-folder-with-e621 = --out арқылы нәтижелерге басқа қалта беріңіз немесе --fresh арқылы басынан бастаңыз (ол қалтадағыны өшіреді)
diag-its-format-is-this-program-writes-7167 = оның пішімі { $found }, бұл бағдарлама { $own } пішімінде жазады
diag-its-format-is-none-this-program-4126 = оның пішімі көрсетілмеген, бұл бағдарлама { $own } пішімінде жазады
diag-the-order-of-its-blocks-f191 = бөлімдерінің реті
diag-and-more-2ac0 = және тағы { $more }
diag-holds-results-of-another-build-of-dcdb = { $path } қалтасында бағдарламаның басқа жинағының немесе басқа процессордың нәтижелері бар: { $all }
diag-holds-results-of-another-input-472e = { $path } қалтасында басқа бастапқы деректердің нәтижелері бар: { $all }
diag-give-the-new-results-another-folder-4370 = --out арқылы жаңа нәтижелерге басқа қалта беріңіз немесе --fresh арқылы басынан бастаңыз (ол ескілерін өшіреді)
diag-missing-b4f3 = жоқ
diag-damaged-72ee = бүлінген
diag-is-rows-to-are-computed-again-50b5 = { $path } { $why }: { $first } – { $last } жолдары қайта есептеледі
diag-not-of-this-study-f8d5 = осы зерттеудікі емес
diag-chunk-cannot-be-written-as-parquet-3b0c = { $index }-бөлікті Parquet түрінде жазу мүмкін емес: { $e }
diag-cannot-read-9ee9 = { $path } файлын оқу мүмкін емес: { $e }
diag-the-manifest-cannot-be-written-2360 = манифесті жазу мүмкін емес: { $e }
diag-cannot-write-of-chunks-are-complete-f917 = { $path } файлына жазу мүмкін емес: { $e }; { $all } бөліктің { $kept } бөлігі толық, сақталған
diag-make-room-or-mend-the-folder-66a3 = дискіде орын босатыңыз немесе қалтаны түзетіңіз, содан кейін сол команданы қайталаңыз: есептеу сол жерден жалғасады
diag-name-another-folder-with-out-b101 = --out арқылы басқа қалта беріңіз

## laval/src/store/manifest.rs

diag-not-given-e003 = берілмеген
diag-was-now-babc = { $what }: бұрын { $old }, қазір { $new }

## laval/src/store/mod.rs

diag-a-study-needs-at-least-one-c0d9 = зерттеуге кемінде бір жол, бөлікке бір жол және бір баған керек
diag-rows-in-chunks-of-are-more-d0c6 = { $chunk } жолдан бөлінген { $rows } жол { $most } бөліктен асады
diag-two-columns-are-named-f7a1 = екі бағанның аты бірдей: «{ $name }»
diag-this-build-cannot-write-parquet-which-dbd2 = бұл жинақ Parquet жаза алмайды, ал ұзақ зерттеулер сонда сақталады
diag-there-is-no-column-4824 = «{ $column }» бағаны жоқ

## laval-cli/src/check.rs

diag-ok-de5c = жарамды: { $machine }
diag-part-193f = { $n } бөлшек
diag-parts-799d = { $n } бөлшек
diag-coordinate-a21a = { $n } координата
diag-coordinates-ea2c = { $n } координата
diag-internal-state-da0f = { $n } ішкі күй
diag-internal-states-7af1 = { $n } ішкі күй
diag-no-studies-e162 = зерттеу жоқ

## laval-cli/src/input.rs

diag-is-a-folder-not-a-machine-7bfd = { $path } – қалта, машина файлы емес
diag-give-the-file-20d8 = файлды беріңіз: { $inside }
diag-is-larger-than-64-mb-6cae = { $path } файлы 64 MB мәнінен үлкен
diag-there-is-no-file-33b6 = { $path } файлы жоқ
diag-laval-new-writes-a-machine-file-4dc1 = laval new бастапқы машина файлын жазады

## laval-cli/src/lib.rs

diag-laval-this-is-a-defect-of-ae66 = laval: бұл – файлыңыздың емес, бағдарламаның қатесі. Машина файлымен және жоғарыдағы хабармен бірге хабарлаңыз

## laval-cli/src/new.rs

diag-templates-877f = үлгілер: { $all }
diag-there-is-no-template-a3c1 = { $word } үлгісі жоқ
diag-exists-and-is-not-overwritten-c379 = { $path } файлы бар, оның үстінен жазылмайды
diag-name-another-file-with-out-8c40 = --out арқылы басқа файл атын беріңіз

## laval-cli/src/pdf.rs

diag-no-chromium-was-found-to-print-c305 = есепті басып шығаратын Chromium табылмады
diag-install-one-of-or-open-in-6eb6 = мыналардың бірін орнатыңыз: { $names }, немесе { $page } бетін браузерде ашып, басып шығарыңыз
diag-could-not-print-the-report-90eb = { $browser } есепті басып шығара алмады: { $why }

## laval-cli/src/progress.rs

diag-done-a112 = { $percent } % орындалды
diag-1-step-done-2d12 = 1 қадам орындалды
diag-steps-done-0233 = { $steps } қадам орындалды
diag-about-left-b4f4 = { $done }, шамамен { $left } қалды
diag-computing-for-ab42 = есептелуде, { $time } өтті
diag-after-7501 = { $done }, { $time } өтті
diag-s-b884 = { $n } с
diag-min-4434 = { $n } мин
diag-h-76f9 = { $n } сағ
diag-days-910f = { $n } күн

## laval-cli/src/run.rs

diag-contains-no-study-e25a = { $file } файлында зерттеу жоқ
diag-add-a-study-block-laval-studies-c25e = [[study]] бөлімін қосыңыз; түрлерін laval studies көрсетеді
diag-its-studies-2ae7 = оның зерттеулері: { $all }
diag-the-machine-has-no-study-1dcb = машинада «{ $word }» зерттеуі жоқ
diag-stopping-ctrl-c-again-stops-at-3a4d = тоқтатылып жатыр; Ctrl-C тағы басылса, бірден тоқтайды
diag-warning-ctrl-c-will-stop-at-f5b8 = ескерту: Ctrl-C бірден тоқтатады, әлі жазылмаған нәтиже жоғалады ({ $e })
diag-not-run-3464 = орындалмады: { $left }
diag-warning-also-holds-results-of-study-0789 = ескерту: { $out } қалтасында { $names } зерттеуінің нәтижесі де бар, ол бұрынғы машина файлынан
diag-warning-also-holds-results-of-studies-8275 = ескерту: { $out } қалтасында { $names } зерттеулерінің нәтижелері де бар, олар бұрынғы машина файлынан
diag-pdf-prints-report-html-which-format-eca7 = --pdf параметрі report.html файлын басып шығарады, ал --format оны шығармайды
diag-laval-study-has-no-result-1a9b = laval: «{ $name }» зерттеуінің нәтижесі жоқ
diag-laval-7bec = laval: { $why }

## laval-cli/src/show.rs

diag-there-is-no-kind-of-called-63a8 = { $what } үшін { $word } түрі жоқ

## laval-cli/src/terminal.rs

diag-laval-cannot-write-to-standard-output-26ab = laval: стандартты шығысқа жазу мүмкін емес: { $e }

## laval-model/src/parts/shaft_lumped.rs

diag-give-below-the-length-from-its-37dc = below (төменгі шетінен нүктеге дейінгі ұзындық) немесе above немесе екеуін де беріңіз

## laval/src/study/centrifuge/cups/mod.rs

diag-the-tube-holds-no-liquid-its-6763 = пробиркада сұйықтық жоқ: оның беті түп деңгейінде немесе одан төмен
diag-measure-surface-and-length-from-the-42d5 = surface пен length мәндерін ауыздан өлшеңіз
diag-the-centre-of-mass-lies-far-8fab = масса центрі пробирка түбінен әлдеқайда төмен
diag-measure-it-from-the-mouth-with-8dfb = оны ауыздан, ішіндегісімен бірге өлшеңіз
diag-the-tube-reaches-across-the-spin-499b = пробирка айналу осін кесіп өтеді
diag-increase-mouth-radius-fce8 = mouth_radius мәнін арттырыңыз
diag-inner-radius-must-be-smaller-than-25c4 = inner_radius мәні outer_radius мәнінен кіші болуы керек
diag-exchange-them-3e47 = олардың орнын ауыстырыңыз
diag-the-liquid-s-surface-must-lie-5953 = сұйықтық беті барабан ішінде болуы керек: surface_radius мәні bowl_radius мәнінен кіші
diag-the-surface-is-the-inner-face-68b0 = бұл бет – сұйықтықтың ішкі беті
diag-how-far-the-cup-swings-out-dd7a = стаканның ауытқуы оның масса центріне тәуелді, ал ол берілмеген
diag-add-centre-of-mass-60-mm-c3bc = centre_of_mass = "60 mm" (топсадан, ішіндегісімен бірге) қосыңыз немесе стаканға тұрақты көлбеу беріңіз
diag-a-moment-of-inertia-needs-the-c51e = инерция моментіне оның массасы керек
diag-add-mass-bcf9 = mass қосыңыз
diag-no-body-has-these-second-moments-f674 = топсаға қатысты мұндай екінші моменттері бар дене жоқ
diag-moment-along-is-at-least-mass-d9e1 = moment_along кемінде mass пен centre_of_mass квадратының көбейтіндісіне тең; moment_product квадраты moment_along пен moment_across көбейтіндісінен аспайды
diag-the-cup-holds-no-liquid-its-de84 = стаканда сұйықтық жоқ: оның беті түп деңгейінде немесе одан төмен
diag-measure-surface-and-bottom-from-the-e09d = surface пен bottom мәндерін топсадан сыртқа қарай өлшеңіз
diag-the-centre-of-mass-lies-from-b498 = масса центрі топсадан { $along } қашықтықта, ал стакан түбі { $bottom }: центр одан әлдеқайда төмен
diag-measure-both-from-the-hinge-7e75 = екеуін де топсадан өлшеңіз
diag-the-centre-of-mass-lies-outside-6a05 = масса центрі стаканнан тыс
diag-at-most-cup-radius-to-either-3b6a = осінің екі жағына көп дегенде cup_radius мәніндей
diag-the-surface-of-the-liquid-reaches-d8a6 = стакан ауытқығанда сұйықтық беті айналу осін кесіп өтеді
diag-increase-hinge-radius-772a = hinge_radius мәнін арттырыңыз
diag-cups-with-an-inner-radius-of-c132 = ішкі радиусы { $inner } болатын { $count } стакан салбырап тұрғанда бір-біріне кіреді
diag-cups-with-an-inner-radius-of-fb5e = ішкі радиусы { $inner } болатын { $count } стакан { $tilt } көлбеуде бір-біріне кіреді
diag-is-at-least-for-of-them-dc43 = { $count } стаканға { $field } мәні қабырғаларын есептемегенде кемінде { $least } болуы керек; немесе count мәнін азайтыңыз
diag-which-carries-it-does-not-exist-4469 = оны көтеретін «{ $name }» денесі жоқ
diag-has-no-mass-of-its-own-2665 = «{ $name }» денесінің стакандар массасы қосылатын өз массасы жоқ
diag-has-no-unbalance-of-its-own-02c9 = «{ $name }» денесінің стакандар дисбалансы қосылатын өз дисбалансы жоқ
diag-attach-the-cups-to-a-disc-1150 = стакандарды дискіге бекітіңіз
diag-what-loads-a-body-needs-mass-c12e = денеге жүктеме түсіретін ыдысқа mass және centre_of_mass керек
diag-add-both-with-contents-or-leave-f30c = екеуін де ішіндегісімен бірге қосыңыз; немесе on өрісін алып тастаңыз
diag-values-are-given-for-cups-f8d1 = { $count } стаканға { $given } мән берілген
diag-give-one-for-each-0-for-ec2c = әрқайсысына бір мән беріңіз, айырмасы жоғына 0 беріңіз
diag-a-centre-of-mass-would-lie-abc7 = бір масса центрі топсада немесе одан әрі жатар еді
diag-differences-are-small-against-centre-of-e735 = айырмалар centre_of_mass мәнімен салыстырғанда аз болады
diag-a-cup-would-weigh-less-than-81ed = бір стаканның массасы теріс болар еді
diag-a-missing-cup-is-minus-its-dac8 = жоқ стакан – оның теріс таңбалы массасы
diag-a-viscosity-in-the-table-is-2768 = кестедегі бір тұтқырлық оң емес
diag-check-the-column-and-its-unit-81c4 = бағанды және оның бірлігін тексеріңіз
diag-the-viscosity-table-goes-from-k-9d41 = тұтқырлық кестесі { $low } K – { $high } K аралығын қамтиды; { $t } K үшін мән жоқ
diag-extend-the-table-viscosity-is-not-baa6 = кестені ұзартыңыз: тұтқырлық экстраполяцияланбайды
diag-give-temperatures-in-increasing-order-7f7b = температураларды өсу ретімен беріңіз
diag-a-viscosity-table-needs-the-temperature-23e1 = тұтқырлық кестесіне сепарация температурасы керек
diag-add-temperature-60-degc-e709 = temperature = "60 degC" қосыңыз
diag-both-viscosity-and-viscosity-table-are-815f = viscosity мен viscosity_table қатар берілген
diag-keep-one-of-them-c17f = екеуінің бірін қалдырыңыз
diag-the-viscosity-of-the-liquid-is-2fd6 = сұйықтықтың тұтқырлығы берілмеген
diag-add-viscosity-1-mpa-s-or-7227 = viscosity = "1 mPa s" немесе viscosity_table пен temperature қосыңыз
diag-the-size-of-the-particles-is-30da = бөлшектердің өлшемі берілмеген
diag-the-sizes-are-given-in-several-7b62 = өлшемдер бірнеше тәсілмен берілген: { $given }
diag-say-one-of-diameter-median-diameter-f077 = бір тәсілін таңдаңыз: diameter; median_diameter және geometric_deviation; characteristic_diameter және spread; sizes
diag-needs-beside-it-6e09 = { $way } өрісімен бірге { $field } керек
diag-add-7c9e = { $field } қосыңыз
diag-a-powder-needs-either-undersize-or-49e9 = ұнтақ диаметрлеріне undersize немесе share керек
diag-sizes-6b6c = sizes = {"{"} diameter = [..], undersize = [..] {"}"}
diag-the-densities-are-given-in-two-09e3 = тығыздықтар екі тәсілмен берілген
diag-keep-densities-or-density-deviation-6dc6 = densities немесе density_deviation өрісінің бірін қалдырыңыз
diag-densities-3bfb = densities = {"{"} density = [..], share = [..] {"}"}
diag-there-is-no-cup-named-acf8 = «{ $name }» атты стакан жоқ
diag-cups-of-this-machine-27de = бұл машинаның стакандары: { $names }
diag-this-machine-has-several-cups-2aed = бұл машинада бірнеше стакан бар
diag-add-cup-with-one-of-031d = cup = .. қосып, мыналардың бірін беріңіз: { $names }
diag-this-machine-has-nothing-that-separates-3ac4 = бұл машинада сепарация ыдысы жоқ
diag-add-a-block-cup-with-kind-40e1 = kind = "swinging", "fixed_angle", "tubular_bowl", "disc_stack" немесе "decanter" мәні бар [[cup]] бөлімін қосыңыз
diag-this-machine-has-nothing-to-separate-394f = бұл машинада ажырататын суспензия жоқ
diag-add-a-block-suspension-with-liquid-03ca = [suspension] бөлімін liquid_density, viscosity, particle_density және diameter өрістерімен қосыңыз

## laval/src/study/centrifuge/cups/task.rs

diag-the-time-in-which-the-cups-9fc8 = стакандарда сепарация аяқталуы тиіс уақыт керек
diag-add-time-30-min-1419 = time = "30 min" қосыңыз
diag-liquid-flows-through-its-throughput-is-8a11 = «{ $name }» ыдысы ағынды: оған уақыт емес, өнімділік керек
diag-add-throughput-500-l-h-and-bb7c = throughput = "500 l/h" қосып, time өрісін алып тастаңыз
diag-nothing-flows-through-9d8a = «{ $name }» ыдысы ағынды емес
diag-give-time-10-min-instead-dae6 = оның орнына time = "10 min" беріңіз
diag-a-decanter-is-counted-by-its-261e = декантер өзінің Sigma мәнімен есептеледі, ол тек Стокс кедергісі үшін анықталған
diag-use-drag-stokes-in-suspension-or-3b00 = [suspension] бөлімінде drag = "stokes" қолданыңыз немесе Sigma мәні бірдей tubular_bowl беріңіз
diag-particles-and-liquid-have-the-same-cff9 = бөлшектер мен сұйықтықтың тығыздығы бірдей: сепарация болмайды
diag-give-particle-density-another-value-than-a77a = particle_density мәнін liquid_density мәнінен өзге етіп беріңіз
diag-particles-of-do-not-fit-into-38bc = өлшемі { $size } бөлшектер «{ $name }» ыдысына сыймайды, оның ені { $wide }
diag-check-the-unit-of-the-diameter-dbc5 = [suspension] бөліміндегі diameter бірлігін тексеріңіз
diag-the-path-of-a-particle-could-e89c = бөлшек траекториясын есептеу мүмкін болмады: { $why }
diag-a-particle-that-moves-much-faster-ed21 = стакан айналуынан әлдеқайда жылдам қозғалатын бөлшекке drag = "schiller_naumann" керек

## laval/src/study/centrifuge/operating_window/contents.rs

diag-the-machine-with-what-it-has-9372 = ажыратылған тұнбасы бар машинаны құру мүмкін емес: { $why }

## laval/src/study/centrifuge/operating_window/mod.rs

diag-speeds-to-evaluate-and-more-where-773d = айналу жиілігін бағалау керек, өзгеріс болатын жерде одан да көп

## laval/src/study/centrifuge/operating_window/passage.rs

diag-turns-of-the-rotor-to-integrate-afa3 = екпіндеу кезіндегі резонанстан өтуді модельдеу үшін ротордың осынша айналымын интегралдау керек
diag-give-the-ramp-another-duration-60fd = екпіндеуге (ramp) басқа ұзақтық беріңіз
diag-the-passage-could-not-be-computed-78f4 = өтуді { $speed } мәнінен әрі есептеу мүмкін болмады
diag-shorten-the-ramp-or-the-range-4b36 = екпіндеуді немесе айналу жиілігінің ауқымын қысқартыңыз; жұмыс аралығынан төменде орнықсыз машинаның қозғалысы шексіз өсуі мүмкін

## laval/src/study/centrifuge/operating_window/request.rs

diag-begin-at-a-low-speed-such-c83d = төмен айналу жиілігінен бастаңыз, мысалы ең үлкенінің оннан бірінен
diag-the-range-of-speeds-must-begin-f56a = айналу жиілігінің ауқымы нөлден жоғары басталуы керек
diag-write-uncertain-8963 = uncertain = {"{"} suspension.viscosity = "20 %" {"}"} деп жазыңыз
diag-which-parameters-are-uncertain-is-missing-54c5 = белгісіздігі бар параметрлер көрсетілмеген
diag-uncertain-parameters-are-too-many-every-d443 = белгісіздігі бар { $found } параметр тым көп: шектердің әр үйлесімі есептеледі
diag-keep-at-most-five-c64b = көп дегенде бесеуін қалдырыңыз
diag-a-time-or-throughput-needs-something-af88 = уақыт немесе өнімділік берілсе, ажырататын суспензия мен сепарация ыдысы керек
diag-add-the-blocks-cup-and-suspension-053e = [[cup]] және [suspension] бөлімдерін қосыңыз
diag-the-run-up-to-the-top-68a1 = ауқымның жоғарғы шегіне дейінгі екпіндеу уақыты { $ramp }, ол екпіндеу басынан саналатын { $time } уақытынан ұзақ
diag-give-a-shorter-ramp-a-lower-8b36 = қысқарақ екпіндеу, төменірек жоғарғы шек немесе көбірек уақыт беріңіз; count_ramp = false болса, уақыт екпіндеу соңынан саналады
diag-add-ramp-60-s-the-time-db06 = ramp = "60 s" қосыңыз: айналу жиілігінің жоғарғы шегіне дейінгі уақыт
diag-the-state-that-a-run-up-6a0f = екпіндеуден кейін болатын күйді анықтауға екпіндеу уақыты керек
diag-the-limits-on-the-passage-need-c4b8 = резонанстан өту шектеріне екпіндеу уақыты керек
diag-there-is-no-separation-whose-time-37dc = уақыты ең қысқа болатын сепарация жоқ
diag-add-cup-suspension-and-time-throughput-fb74 = [[cup]], [suspension] және time (ағынды болса, throughput) қосыңыз
diag-no-limit-on-vibration-is-given-8f35 = амплитудалар салыстырылатын тербеліс шегі берілмеген
diag-add-displacement-velocity-tilt-force-or-cb12 = [limits] бөліміне displacement, velocity, tilt, force немесе moment қосыңыз
diag-what-the-study-requires-of-the-db03 = зерттеудің машинаға талабы оның стакандары мен суспензиясына сәйкес емес

## laval/src/study/centrifuge/operating_window/steady.rs

diag-the-stability-of-a-steady-state-99a6 = орныққан күйдің орнықтылығын бағалау мүмкін емес: { $why }
diag-a-steady-state-cannot-be-evaluated-0b1c = орныққан күйді есептеу мүмкін емес: { $e }

## laval/src/study/centrifuge/operating_window/vary.rs

diag-numbers-of-539d = «{ $name }» сандары: { $own }
diag-cannot-be-b533 = { $path }: { $value } мәні жарамайды
diag-has-no-number-to-vary-071a = «{ $name }» ішінде өзгертуге болатын { $field } саны жоқ
diag-give-it-a-value-in-its-ae9c = алдымен оған өз бөлімінде мән беріңіз

## laval/src/study/centrifuge/separation/meter.rs

diag-paths-of-particles-to-integrate-roughly-2ddf = бөлшек траекториясын интегралдау керек, шамамен

## laval/src/study/centrifuge/separation/mod.rs

diag-a-programme-begins-at-time-0-7c07 = бағдарлама 0 уақытында басталады, айналу бағыты бір болады, соңында ротор айналып тұрады
diag-the-last-speed-is-held-c274 = соңғы айналу жиілігі сақталады
diag-give-times-in-increasing-order-c8b3 = уақыттарды өсу ретімен беріңіз
diag-both-a-programme-and-a-ramp-0676 = programme мен ramp қатар берілген
diag-release-0-mm-20-mm-0-a72d = release = ["0 mm", "20 mm", "0 mm"]
diag-a-place-has-three-components-not-e4ba = орынның үш құраушысы болады, берілгені: { $n }
diag-release-velocity-0-m-s-0-3bd1 = release_velocity = ["0 m/s", "0.1 m/s", "0 m/s"]
diag-a-velocity-has-three-components-not-760c = жылдамдықтың үш құраушысы болады, берілгені: { $n }
diag-a-velocity-belongs-to-a-particle-bd64 = жылдамдық жіберілген бөлшекке ғана беріледі
diag-add-release-0-mm-20-mm-ac24 = release = ["0 mm", "20 mm", "0 mm"] қосыңыз
diag-a-particle-whose-drag-balances-the-2608 = кедергісі өрісті теңгеретін бөлшектің бастапқы жылдамдығы берілмейді
diag-take-it-out-or-take-model-988f = оны алып тастаңыз немесе model = "exact" беріңіз
diag-a-run-up-needs-two-different-e12f = екпіндеуге екі әртүрлі айналу жиілігі керек; мұнда басында да, соңында да ротор тыныш тұр
diag-give-another-speed-or-leave-ramp-df25 = басқа айналу жиілігін беріңіз немесе ramp өрісін алып тастаңыз
diag-liquid-flows-through-this-machine-which-9d11 = бұл машина ағынды, сұйықтық оған жұмыстық айналу жиілігінде беріледі: есепке алатын екпіндеу жоқ
diag-the-run-up-takes-longer-than-c0f0 = екпіндеу уақыты { $ramp }, ол берілген { $time } уақытынан ұзақ: айналу жиілігіне жету мүмкін емес
diag-give-a-shorter-ramp-or-more-719c = қысқарақ екпіндеу немесе көбірек уақыт беріңіз
diag-one-particle-can-be-followed-in-007a = жеке бөлшек тек стакандар мен пробиркаларда есептеледі
diag-leave-release-out-355c = release өрісін алып тастаңыз
diag-no-particle-finds-liquid-in-this-b6b2 = бұл пробиркада бөлшекке сұйықтық жоқ
diag-lower-surface-or-raise-length-f51b = surface мәнін азайтыңыз немесе length мәнін арттырыңыз

## laval/src/study/context.rs

diag-making-the-time-form-of-6c7f = { $names } үшін уақыт облысындағы форма құрылып жатыр

## laval/src/study/kind.rs

diag-the-study-was-stopped-within-a-cbf2 = зерттеу аралық нәтижесі жоқ есептеу кезінде тоқтатылды

## laval/src/study/linear/approximation.rs

diag-no-part-of-this-machine-has-b90f = бұл машинада салыстыруға болатын жуықтауы бар бөлшек жоқ
diag-parts-with-waves-without-number-have-9300 = мұндай жуықтау шексіз көп толқыны бар бөлшектерде бар; басқа жағдайда compare өрісін алып тастаңыз
diag-the-approximation-is-no-machine-47ae = жуықтау бойынша машинаны құру мүмкін емес: { $why }
diag-leave-compare-out-5311 = compare өрісін алып тастаңыз

## laval/src/study/linear/campbell.rs

diag-speeds-at-which-roots-are-counted-0176 = айналу жиілігінде түбірлерді кезекпен санау керек
diag-eigenvalue-problems-to-solve-3ff3 = меншікті мәндер есебін шешу керек
diag-modes-shows-the-modes-at-one-aec9 = { $help }; modes бір айналу жиілігіндегі модаларды көрсетеді

## laval/src/study/linear/criterion.rs

diag-flutter-is-for-machines-that-nothing-8c74 = flutter демпферлеуі де, жетегі де жоқ машиналарға арналған; бұл машинада демпферлеу бар
diag-set-all-damping-to-0-or-3e29 = барлық демпферлеуді 0 етіңіз немесе criterion = "growth" пен growth_threshold беріңіз
diag-no-part-of-this-machine-has-754c = бұл машинада критерийге қажетті, тұтқырлық сияқты шығыны бар бөлшек жоқ
diag-give-one-a-viscosity-or-take-ccca = бір бөлшекке тұтқырлық беріңіз немесе criterion = "growth" пен growth_threshold беріңіз

## laval/src/study/linear/forced_response/mod.rs

diag-no-body-of-this-machine-moves-0be8 = бұл машинада оське көлденең қозғалатын дене жоқ
diag-responses-at-speeds-of-coordinates-ffcf = { $speeds } айналу жиілігінде { $n } координатаның жауабы
diag-give-the-range-fewer-points-where-a938 = ауқымға аз нүкте беріңіз: жауап қисайған жерде тор онсыз да тығыздалады
diag-nothing-forces-this-machine-at-the-bc0c = бұл машинада айналу жиілігімен қоздыру жоқ
diag-give-a-disc-an-eccentricity-an-cc3c = дискіге эксцентриситет, дисбаланс немесе қиғаштық беріңіз
diag-speeds-to-solve-for-and-more-309f = айналу жиілігі үшін шешу керек, жауап қисайған жерде одан да көп

## laval/src/study/linear/modes/mod.rs

diag-terms-of-series-in-every-evaluation-3314 = түбірлері саналатын функцияның әр есептеуінде қатар мүшесі керек

## laval/src/study/linear/stability_map/mod.rs

diag-a-map-of-by-points-is-6344 = { $speeds } × { $values } нүктелік карта тым үлкен
diag-at-most-points-in-all-2d77 = барлығы көп дегенде { $most } нүкте
diag-the-machine-does-not-exist-at-46f1 = { $path } = { $x } болса, машинаны құру мүмкін емес: { $why }
diag-narrow-the-range-of-the-parameter-aa3f = параметр ауқымын тарылтыңыз

## laval/src/study/centrifuge/separation/mod.rs

diag-leave-it-out-7b2b = оны алып тастаңыз

## laval/src/study/motion/basins/axes.rs

diag-must-name-one-initial-value-beside-a61c = { $field }: екпіндеумен бірге бір бастапқы мән аталуы керек; аталғаны: { $given }
diag-must-name-two-initial-values-it-6efa = { $field }: екі бастапқы мән аталуы керек; аталғаны: { $given }
diag-write-1-rad-8cd7 = { $field } = {"{"} "{ $mass }" = "1 rad" {"}"} деп жазыңыз
diag-write-x-1-mm-32e6 = { $field } = {"{"} "{ $body }.x" = "1 mm" {"}"} деп жазыңыз
diag-write-x-1-mm-y-1-3c85 = { $field } = {"{"} "{ $body }.x" = "1 mm", "{ $body }.y" = "1 mm" {"}"} деп жазыңыз
diag-to-names-but-from-names-7aff = to өрісінде { $to }, ал from өрісінде { $from } аталған
diag-both-name-the-same-a658 = екеуінде де бір координаталарды атаңыз
diag-must-go-from-a-lower-to-d49b = «{ $name }» кіші мәннен үлкен мәнге қарай берілуі керек
diag-a-grid-of-by-points-is-75a7 = { $first } × { $second } нүктелік тор тым үлкен
diag-points-must-be-whole-numbers-from-9f75 = points – 2 мен { $most } аралығындағы бүтін сан, берілгені: { $x }
diag-points-names-which-is-not-varied-9569 = points өрісінде «{ $n }» аталған, ал ол өзгертілмейді
diag-varied-are-2f80 = өзгертілетіндер: { $names }

## laval/src/study/motion/basins/masses/mod.rs

diag-starts-followed-beforehand-then-those-of-0602 = бастапқы шарт алдын ала есептеледі, содан кейін картадағылар
diag-motions-to-follow-until-their-masses-76f2 = қозғалысты шариктер тоқтағанша немесе бірқалыпты қозғалғанша есептеу керек

## laval/src/study/motion/basins/mod.rs

diag-basins-need-a-speed-above-there-e9a5 = basins зерттеуіне { $least } мәнінен үлкен айналу жиілігі керек: тыныштықта период жоқ
diag-a-run-up-makes-no-difference-e5b8 = екпіндеу { $speed } кезінде нәтижені өзгертпейді: бұл машинада айналатын осьтерде қозғалатын шариктер жоқ
diag-leave-run-up-out-90f9 = run_up өрісін алып тастаңыз
diag-the-spin-of-this-machine-is-c90d = бұл машинаның айналуы еркін: қозғалыс орнығатын айналу жиілігі берілмеген
diag-leave-drive-free-out-or-follow-efcb = drive = "free" өрісін алып тастаңыз немесе қозғалысты transient зерттеуімен есептеңіз
diag-motions-to-follow-cells-and-the-b5b2 = { $count } қозғалысты есептеу керек ({ $cells } ұяшық және ұйытқусыз бастапқы шарт), әрқайсысы көп дегенде { $turns } айналым: { $what }, сондықтан орнығу уақыты алдын ала белгісіз
diag-motions-to-follow-until-they-repeat-fe68 = қозғалысты қайталанғанша есептеу керек
diag-at-rest-a-mode-of-this-c2da = тыныштықта бұл машинаның бір модасы { $growth } жылдамдығымен өседі
diag-at-rest-a-mode-of-this-8b63 = тыныштықта бұл машинаның бір модасы өшпейді де, өспейді де
diag-the-modes-of-this-machine-at-bdf2 = бұл машинаның тыныштықтағы модалары белгісіз

## laval/src/study/motion/basins/report.rs

diag-the-attractors-are-not-those-of-fdb9 = аттракторлар бұл қозғалыстардікі емес

## laval/src/study/motion/history/mod.rs

diag-output-times-of-coordinates-d440 = { $n } координатаның { $outputs } шығыс сәті
diag-give-fewer-points-a-longer-output-6e5a = нүкте санын азайтыңыз (output_step мәнін арттырыңыз) немесе жылдамдықтар мен бақыланатын шамаларды алып тастаңыз
diag-the-study-was-stopped-before-its-ea66 = зерттеу машинаның уақыт облысындағы формасы құрылғанға дейін тоқтатылды
diag-turns-of-the-rotor-to-integrate-2fed = ротор айналымын интегралдау керек, { $duration }

## laval/src/study/motion/motion_map/mod.rs

diag-both-a-range-of-speeds-and-8fcf = айналу жиілігінің ауқымы мен x бойындағы параметр қатар берілген
diag-say-one-or-the-other-5112 = екеуінің бірін ғана беріңіз
diag-a-map-of-two-parameters-needs-75f7 = екі параметр картасына нөлден үлкен айналу жиілігі керек
diag-add-speed-3000-rpm-here-or-39c1 = speed = "3000 rpm" өрісін осында немесе [machine] бөліміне қосыңыз
diag-and-are-the-same-parameter-dc84 = «{ $first }» мен «{ $second }» – бір параметр
diag-is-no-value-9845 = { $path }: { $x } – мән бола алмайды
diag-the-grid-has-more-points-than-9c74 = тордағы нүктелер саны есептеуге келмейтіндей көп
diag-the-values-of-a-list-lie-32f5 = тізімнің мәндері оның нұсқаларының қалтасында сақталады
diag-the-design-has-no-case-22d6 = жоспарда бірде-бір нұсқа жоқ
diag-cases-are-more-than-can-be-6c04 = { $cases } нұсқа – нөмірлеуге болатыннан көп
diag-is-damaged-6361 = { $path }: файл бүлінген
diag-parameters-are-more-than-the-dimensions-aac5 = { $k } параметр Соболь тізбегінің { $most } өлшемінен көп
diag-the-machine-has-no-study-026d = машинада «{ $name }» зерттеуі жоқ
diag-stopped-before-the-first-case-3403 = бірінші нұсқаға дейін тоқтатылды
diag-the-study-has-no-numbers-for-11b4 = зерттеу бұл машина үшін сан бермейді: { $why }
diag-belongs-to-another-study-another-build-5178 = { $path } басқа зерттеуге, басқа жинаққа немесе басқа процессорға тиесілі
diag-vary-two-parameters-e3b5 = екі параметрді өзгертіңіз
diag-a-map-of-by-motions-is-21b0 = { $a } × { $b } қозғалыс картасы тым үлкен
diag-at-most-motions-in-all-6722 = барлығы көп дегенде { $most } қозғалыс
diag-this-study-needs-a-range-of-c0d9 = бұл зерттеуге айналу жиілігінің ауқымы керек
diag-add-speed-or-a-speed-to-16b1 = speed = {"{"} from = "1000 rpm", to = "5000 rpm" {"}"} қосыңыз немесе [machine] бөліміне speed беріңіз
diag-or-give-x-a-second-parameter-93d9 = { $help }, немесе x өрісіне екінші параметрді беріңіз: онда айналу жиілігі барлық жерде бірдей
diag-a-map-needs-speeds-above-there-fb49 = картаға { $least } мәнінен үлкен айналу жиілігі керек: тыныштықта период жоқ

## laval/src/study/motion/record.rs

diag-a-state-of-coordinates-and-internal-7bda = { $coordinates } координата мен { $states } ішкі күйден тұратын күй бұл машинаға сәйкес емес: онда { $n } координата, уақыт облысындағы формасында { $m } ішкі күй бар
diag-continue-from-a-motion-of-the-8d3a = сол машинаның қозғалысынан жалғастырыңыз

## laval/src/study/motion/run_up/mod.rs

diag-the-spin-of-this-machine-is-d361 = бұл машинаның айналуы еркін, ол бағдарлама бойынша айналмайды
diag-use-a-transient-study-or-take-56cc = transient зерттеуін қолданыңыз немесе еркін жетекті алып тастаңыз
diag-the-times-must-begin-at-0-0bad = уақыттар 0 мәнінен басталуы керек
diag-both-a-programme-and-are-given-4c93 = programme мен { $given } қатар берілген
diag-how-long-the-change-of-speed-5c35 = айналу жиілігі өзгеретін уақыт ұзақтығы берілмеген
diag-add-duration-10-s-or-a-7616 = duration = "10 s" немесе уақыттар мен айналу жиіліктерінің бағдарламасын қосыңыз
diag-both-a-polynomial-and-to-are-f613 = polynomial мен to қатар берілген
diag-neither-the-study-nor-the-machine-29cc = соңғы айналу жиілігі зерттеуде де, машинада да берілмеген
diag-add-to-3000-rpm-0fb7 = to = "3000 rpm" қосыңыз
diag-from-and-to-are-both-2250 = from пен to екеуі де { $speed }
diag-this-stays-at-5025 = { $field } бойынша айналу жиілігі тұрақты: { $speed }
diag-from-and-the-speed-of-the-93ff = from пен машинаның айналу жиілігі екеуі де { $speed }
diag-a-run-up-needs-two-different-5573 = екпіндеуге екі әртүрлі айналу жиілігі керек; { $said }
diag-give-another-speed-or-take-a-94e2 = басқа айналу жиілігін беріңіз немесе тұрақты айналу жиілігі үшін transient зерттеуін қолданыңыз

## laval/src/study/motion/spectra/mod.rs

diag-there-is-fac5 = бары: { $known }
diag-there-is-no-body-96f6 = «{ $name }» денесі жоқ
diag-spectra-up-to-order-of-this-f7e0 = бұл жазбаның { $highest } ретіне дейінгі спектрлеріне { $total } есеп нүктесі керек, бұл тым көп
diag-at-most-lower-highest-order-or-75cb = көп дегенде { $most }: highest_order мәнін азайтыңыз немесе қысқарақ қозғалысты есептеңіз

## laval/src/study/motion/start.rs

diag-there-is-no-coordinate-or-state-1f90 = «{ $name }» координатасы немесе күйі жоқ
diag-is-it-must-lie-between-and-e08b = «{ $name }» = { $value }; SI бірлігінде { $least } – { $most } аралығында болуы керек
diag-is-given-twice-6139 = «{ $name }» екі рет берілген
diag-has-ebf9 = «{ $part }» бөлшегінде бары: { $own }
diag-this-machine-has-58cb = бұл машинада бары: { $names }

## laval/src/study/motion/steady_state/stored.rs

diag-there-is-no-column-4b0b = «{ $name }» бағаны жоқ

## laval/src/study/motion/sweep/mod.rs

diag-at-one-speed-nonlinear-response-finds-425e = { $help }; бір айналу жиілігінде орныққан қозғалыстарды nonlinear_response табады, бастапқы шарттан шығатын қозғалысты basins пен transient көрсетеді
diag-a-sweep-needs-speeds-above-there-49bc = sweep зерттеуіне { $least } мәнінен үлкен айналу жиілігі керек: тыныштықта период жоқ
diag-motions-with-numbers-each-a1ca = әрқайсысында { $columns } сан бар { $rows } қозғалыс
diag-give-the-range-fewer-points-or-9d64 = ауқымға аз нүкте беріңіз немесе waterfall өрісін алып тастаңыз
diag-the-spin-of-this-machine-is-9eab = бұл машинаның айналуы еркін: ауқым бойымен өзгертетін айналу жиілігі жоқ
diag-is-no-displacement-or-tilt-of-e52c = «{ $name }» дененің ығысуы да, көлбеуі де емес
diag-name-one-such-as-0026 = мысалы, мынаны атаңыз: { $known }

## laval/src/study/motion/transient.rs

diag-neither-the-study-nor-the-machine-bf96 = айналу жиілігі зерттеуде де, машинада да берілмеген
diag-add-speed-3000-rpm-to-machine-1ffb = speed = "3000 rpm" өрісін [machine] бөліміне немесе зерттеуге қосыңыз
diag-a-kick-changes-rates-only-2906 = соққы тек жылдамдықтарды өзгертеді
diag-name-rates-with-such-as-drum-cc29 = жылдамдықтарды ' таңбасымен атаңыз, мысалы "drum.x'"
diag-the-kick-at-comes-after-the-1d6d = соққы { $at } сәтінде, ал есептеу { $duration } сәтінде аяқталады
diag-outputs-are-too-many-cef8 = { $step } шығыс сәті тым көп
diag-at-most-1000000-outputs-a3ad = көп дегенде 1000000 шығыс сәті
diag-both-output-step-and-points-are-e4e5 = output_step пен points қатар берілген
diag-the-duration-must-be-positive-3a15 = ұзақтық оң болуы керек

## laval/src/study/nonlinear/backbone.rs

diag-amplitude-must-go-from-a-lower-9ac3 = amplitude кіші мәннен үлкен мәнге қарай берілуі керек
diag-exchange-from-and-to-b115 = from мен to орнын ауыстырыңыз

## laval/src/study/nonlinear/bifurcation_loci/mod.rs

diag-the-range-of-speeds-comes-too-4b94 = айналу жиілігінің ауқымы нөлге тым жақын, онда дисбаланс әсер етпейді
diag-keep-both-ends-above-or-both-75ce = екі шегін де { $slowest } мәнінен жоғары немесе кері айналу үшін { $lowest } мәнінен төмен беріңіз
diag-the-response-at-values-is-too-4ab4 = { $points } мәндегі жауапты есептеу тым көп
diag-points-is-the-number-of-values-4cb3 = points – сызықтар басталатын мәндер саны: көп дегенде { $most }
diag-a-steady-response-is-computed-at-5056 = орныққан жауап тұрақты айналу жиілігінде есептеледі, ал бұл машинаның айналу жиілігі еркін
diag-prescribe-the-speed-of-the-machine-c769 = машинаның айналу жиілігін беріңіз: еркін жетекті алып тастаңыз
diag-the-machine-does-not-exist-at-0b99 = { $path } параметрінің тексерілген ешбір мәнінде машинаны құру мүмкін емес; { $at } мәнінде: { $why }
diag-the-stability-of-this-machine-s-7f76 = бұл машина қозғалыстарының орнықтылығын бағалау мүмкін емес: { $why }
diag-kinds-folds-needs-no-stability-641f = kinds = "folds" үшін орнықтылық қажет емес

## laval/src/study/nonlinear/free_motion.rs

diag-free-whirls-are-sought-at-constant-efd0 = еркін прецессиялар тұрақты айналу жиілігінде ізделеді, ал бұл машинаның айналу жиілігі еркін
diag-prescribe-the-speed-of-the-machine-cac7 = машинаның айналу жиілігін беріңіз (еркін жетекті алып тастаңыз) немесе еркін машинаны уақыт бойынша transient зерттеуімен есептеңіз

## laval/src/study/nonlinear/methods.rs

diag-the-methods-are-compared-at-constant-0e38 = әдістер тұрақты айналу жиілігінде салыстырылады, ал бұл машинаның айналу жиілігі еркін
diag-prescribe-the-speed-of-the-machine-176a = машинаның айналу жиілігін беріңіз (еркін жетекті алып тастаңыз)

## laval/src/study/nonlinear/nonlinear_response/mod.rs

diag-the-stored-response-is-of-one-2c20 = сақталған жауап бір айналу жиілігі үшін есептелген, ал бұл зерттеуде ауқым берілген
diag-order-of-the-base-frequency-does-bd3d = базалық жиіліктің { $h }-реті дисбалансты қамтымайды, дисбаланстың реті { $divisor }
diag-with-subharmonic-n-orders-count-in-3fdb = subharmonic = n болса, реттер айналу жиілігінің n бөлігімен (speed / n) саналады: кемінде n рет беріңіз
diag-motions-of-turns-of-the-rotor-b128 = ротордың { $divisor } айналымында қайталанатын қозғалыстарда { $symmetry } симметриясы жоқ: ол айналым саны тақ болғанда ғана бар
diag-write-symmetry-none-or-an-odd-deb5 = symmetry = "none" немесе subharmonic үшін тақ сан жазыңыз

## laval/src/study/nonlinear/response_map/mod.rs

diag-vary-two-parameters-for-one-see-e9a8 = екі параметрді өзгертіңіз; бір параметр үшін nonlinear_response пен uncertainty зерттеулерін қолданыңыз немесе y өрісіне басқа параметр беріңіз
diag-a-map-of-by-machines-is-1075 = { $x } × { $y } машина картасы тым үлкен
diag-at-most-machines-in-all-be30 = барлығы көп дегенде { $most } машина
diag-responses-to-compute-cf95 = жауапты есептеу керек
diag-is-spaced-in-equal-ratios-but-54d2 = { $field } тең қатынаспен бөлінген, ал басы 0 мәнінен үлкен емес
diag-begin-above-0-or-leave-out-53e4 = басын 0 мәнінен үлкен етіңіз немесе { $spacing } өрісін алып тастаңыз

## laval/src/study/nonlinear/stationary/chart.rs

diag-cells-of-the-chart-7498 = диаграмма ұяшығы

## laval/src/study/nonlinear/stationary/mod.rs

diag-the-chart-has-too-many-cells-daa9 = диаграммада ұяшық тым көп
diag-at-most-speeds-times-values-4009 = айналу жиіліктері мен мәндер санының көбейтіндісі көп дегенде { $most }
diag-needs-the-speed-of-the-state-7fe7 = { $field } үшін көзделген күйдің айналу жиілігі керек
diag-give-stabilise-at-3000-rpm-or-1a65 = stabilise_at = "3000 rpm" немесе [machine] бөлімінде speed беріңіз
diag-stationary-states-are-sought-at-given-86e6 = стационар күйлер берілген айналу жиіліктерінде ізделеді, ал бұл машинаның айналу жиілігі еркін
diag-prescribe-the-speed-of-the-machine-7fd4 = машинаның айналу жиілігін беріңіз немесе еркін машинаны уақыт бойынша transient зерттеуімен есептеңіз
diag-at-ff93 = { $path } = { $x } болса: { $message }
diag-starts-to-follow-65c8 = бастапқы шартты есептеу керек
diag-starts-to-follow-where-no-state-812e = орнықты күй жоқ жерде бастапқы шартты есептеу керек

## laval/src/study/parameters/optimum/machine.rs

diag-name-each-once-190a = әрқайсысын бір рет атаңыз
diag-the-bounds-must-go-from-a-c5c6 = { $path }: шектер кіші мәннен үлкен мәнге қарай берілуі керек
diag-is-not-admissible-6d63 = { $path }: { $x } { $unit } мәніне рұқсат жоқ

## laval/src/study/parameters/optimum/mod.rs

diag-runs-of-the-study-at-most-7d3f = рет көп дегенде { $kind } зерттеуі есептеледі

## laval/src/study/parameters/optimum/request.rs

diag-one-number-can-be-made-small-4ee5 = бір санды ғана ең кіші немесе ең үлкен етуге болады, екеуін бірден емес
diag-leave-out-minimise-or-maximise-and-6712 = minimise немесе maximise өрісінің бірін алып тастап, екінші санға at_most немесе at_least арқылы шек беріңіз
diag-nothing-is-named-that-should-become-6ec6 = ең кіші немесе ең үлкен болатын шама аталмаған
diag-write-minimise-largest-displacement-or-maximise-3d38 = minimise = "largest_displacement" немесе maximise = "widest_window" деп жазыңыз
diag-the-limit-on-is-how-far-18f2 = «{ $name }» шегі { $value }: оның орындалу қоры шектің өз мәнімен өлшенеді
diag-give-a-number-other-than-zero-cc0a = нөлден өзге сан беріңіз
diag-it-finds-3a16 = ол табатын шамалар: { $all }
diag-the-study-finds-no-number-of-fd93 = { $kind } зерттеуі бұл машинада «{ $name }» шамасын таппайды
diag-the-limit-on-6641 = «{ $name }» шегі: { $message }
diag-parameters-are-too-many-to-search-ed70 = { $count } параметр іздеу үшін тым көп

## laval/src/study/parameters/uncertainty/mod.rs

diag-runs-of-the-study-56de = рет { $kind } зерттеуі есептеледі
diag-samples-of-parameters-require-runs-which-5bcc = { $k } параметрдің { $samples } нұсқасына { $runs } есептеу керек, бұл тым көп
diag-at-most-runs-in-all-ae2b = барлығы көп дегенде { $most } есептеу
diag-parameters-need-dimensions-the-sobol-sequence-167d = { $k } параметрге { $dimensions } өлшем керек; Соболь тізбегінде { $most } өлшем бар
diag-use-method-monte-carlo-82d8 = method = "monte_carlo" қолданыңыз

## laval/src/study/parameters/uncertainty/tolerance.rs

diag-name-x-or-y-b884 = { $path }.x немесе { $path }.y деп атаңыз
diag-its-values-in-x-and-y-af7c = оның x пен y мәндері әртүрлі, сондықтан белгісіздік берілетін жалғыз мән жоқ
diag-give-its-standard-deviation-a-tolerance-7843 = оның стандартты ауытқуын беріңіз: бөлшектердің 99.7 % бөлігі сақтайтын шақтама – үш стандартты ауытқу
diag-it-takes-7437 = оның өрістері: { $allowed }
diag-a-distribution-has-no-0fa8 = «{ $distribution }» үлестірімінде { $other } жоқ
diag-the-standard-deviation-is-missing-81a3 = стандартты ауытқу берілмеген
diag-add-deviation-2-440b = deviation = "2 %" қосыңыз
diag-the-machine-s-value-is-0-d673 = машинадағы мәні 0, оның кез келген үлесі 0: бірлігі бар сан беріңіз
diag-it-must-be-above-0-7e37 = 0 мәнінен үлкен болуы керек
diag-a-standard-deviation-of-leaves-nothing-4f0b = { $deviation } стандартты ауытқуы белгісіздік бермейді
diag-a-log-normal-number-is-positive-29ac = логнормал сан оң болады, оның орташасы { $mean } болуы мүмкін емес
diag-use-normal-or-give-a-mean-b5e5 = "normal" қолданыңыз немесе mean беріңіз
diag-either-from-and-to-or-tolerance-38f5 = from мен to немесе tolerance керек
diag-write-tolerance-5-or-from-to-8859 = tolerance = "5 %" немесе from = .., to = .. деп жазыңыз
diag-the-machine-s-value-is-0-bcf9 = машинадағы мәні 0, оның кез келген үлесі 0: бірлігі бар сандар беріңіз
diag-from-must-lie-below-to-2ee8 = from мәні to мәнінен кіші болуы керек
diag-there-is-nothing-between-and-3b19 = { $from } мен { $to } мәндерінің арасында аралық жоқ
diag-is-not-admissible-for-this-parameter-c787 = { $value } мәні бұл параметр үшін рұқсат етілмейді
diag-narrow-the-interval-69e6 = аралықты тарылтыңыз
diag-its-most-probable-value-lies-outside-fd45 = ең ықтимал мәні { $mode } { $from } – { $to } аралығынан тыс
diag-give-mode-or-other-ends-6d7c = mode мәнін немесе басқа шектерді беріңіз

## laval/src/study/shared/limits.rs

diag-there-are-a-point-of-a-a331 = бары: { $all }; дене нүктесі "drum at 100 mm" түрінде жазылады
diag-there-are-f68d = бары: { $all }
diag-names-which-is-no-body-of-c478 = { $field }: бұл машинада «{ $n }» денесі жоқ
diag-names-which-is-no-body-that-b6c8 = { $field }: бұл машинада көлбейтін «{ $n }» денесі жоқ
diag-names-which-is-no-part-with-b98a = { $field }: «{ $n }» күші бар бөлшек емес
diag-names-which-is-no-part-with-b270 = { $field }: «{ $n }» моменті бар бөлшек емес
diag-rated-density-belongs-to-a-highest-83e1 = rated_density ең үлкен айналу жиілігіне қатысты, ал ол берілмеген
diag-add-speed-8e93 = speed қосыңыз

## laval/src/study/shared/operation.rs

diag-run-up-time-needs-an-operating-a26f = run_up_time үшін жұмыстық айналу жиілігі керек, ол [operation] бөлімінде де, [machine] бөлімінде де берілмеген
diag-operating-speeds-begin-above-standstill-and-7f11 = жұмыстық айналу жиіліктері нөлден жоғары басталады, айналу бағыты бір болады
diag-the-operating-speeds-must-go-from-00fe = жұмыстық айналу жиіліктері кіші мәннен үлкен мәнге қарай берілуі керек
diag-from-is-and-to-is-exchange-b990 = from мәні { $from }, to мәні { $to }: орындарын ауыстырыңыз
diag-the-speed-of-machine-is-not-8ca9 = [machine] бөліміндегі айналу жиілігі { $w } жұмыстық айналу жиіліктерінің { $low } – { $high } аралығынан тыс
diag-give-the-speed-in-one-of-bf60 = айналу жиілігін екі орынның бірінде беріңіз немесе бірін өзгертіңіз

## laval/src/study/shared/presentation.rs

diag-write-file-si-or-units-such-3458 = file, si немесе "rpm, mm, kN" сияқты бірліктерді жазыңыз

## laval/src/study/shared/size.rs

diag-spectra-of-states-6d66 = { $states } күйлі { $speeds } спектр
diag-give-the-range-fewer-points-f548 = ауқымға аз нүкте беріңіз
diag-rows-of-numbers-866d = әрқайсысында { $columns } сан бар { $rows } жол
diag-give-fewer-points-6535 = нүктелер санын азайтыңыз
diag-take-about-gb-of-memory-more-e408 = { $of }: шамамен { $needed } GB жад керек, рұқсат етілгені { $most } GB

## laval/src/study/shared/speed_range.rs

diag-the-study-needs-the-coefficients-of-46db = зерттеуге «{ $name }» коэффициенттерінің { $from } кезіндегі мәндері керек; кестесі { $low } – { $high } аралығын қамтиды
diag-the-study-needs-the-coefficients-of-bb45 = зерттеуге «{ $name }» коэффициенттерінің { $from } – { $to } аралығындағы мәндері керек; кестесі { $low } – { $high } аралығын қамтиды
diag-keep-to-speeds-of-the-table-c95a = кестедегі айналу жиіліктерімен шектеліңіз, кестеге жол қосыңыз немесе «{ $name }» бөлшегінде beyond = "hold" немесе beyond = "linear" деп жазыңыз: кестеден тыс нәтижелер белгіленеді
diag-the-tables-of-have-no-frequencies-af27 = { $names } кестелерінің ортақ тербеліс жиіліктері жоқ
diag-write-beyond-hold-or-beyond-linear-53dc = кестеден шығуға болатын жерде beyond = "hold" немесе beyond = "linear" деп жазыңыз не жол қосыңыз
diag-no-part-of-this-machine-is-9c3e = бұл машинаның бірде-бір бөлшегі тербеліс жиілігі бойынша кестемен берілмеген
diag-speeds-at-which-modes-are-counted-0ff8 = айналу жиілігі, оларда модалар бірінен соң бірі саналады
diag-modes-with-frequencies-outside-the-table-1aa5 = жиіліктері «{ $name }» кестесінен тыс модалар белгісіз
diag-the-coefficients-of-depend-on-the-57ae = «{ $name }» коэффициенттері тербеліс жиілігіне тәуелді, ал бұл есеп мұндай бөлшекті қабылдамайды
diag-modes-campbell-critical-speeds-forced-response-790a = оны modes, campbell, critical_speeds, forced_response және harmonic_force қабылдайды; бұл есеп үшін тек айналу жиілігі бойынша кесте беріңіз
diag-the-study-needs-the-coefficients-of-3837 = зерттеуге «{ $name }» коэффициенттерінің { $from } тербеліс жиілігіндегі мәндері керек; кестесі { $low } – { $high } аралығын қамтиды
diag-the-study-needs-the-coefficients-of-1fc0 = зерттеуге «{ $name }» коэффициенттерінің { $from } – { $to } тербеліс жиіліктеріндегі мәндері керек; кестесі { $low } – { $high } аралығын қамтиды
diag-keep-to-frequencies-of-the-table-734e = кестедегі тербеліс жиіліктерімен шектеліңіз, кестеге жол қосыңыз немесе «{ $name }» бөлшегінде beyond = "hold" немесе beyond = "linear" деп жазыңыз: кестеден тыс нәтижелер белгіленеді

## laval/src/study/shared/support.rs

diag-with-roots-are-counted-where-they-c786 = { $name } бар машинада тек өсетін түбірлер саналады: growth_threshold мәні 0-ден кіші болғанда одан баяу өшетін түбірдің бар-жоғы белгісіз
diag-give-a-growth-threshold-of-0-2976 = growth_threshold мәнін 0 немесе одан үлкен етіңіз; қозғалыстың өшу жылдамдығын transient көрсетеді
diag-this-study-needs-a-spin-speed-9f43 = бұл зерттеуге айналу жиілігі керек
diag-give-speed-3000-rpm-here-or-331c = speed = "3000 rpm" өрісін осында немесе барлық зерттеуге бірден [machine] бөлімінде беріңіз
diag-give-two-values-that-differ-9f93 = екі әртүрлі мән беріңіз
diag-modes-forced-response-stability-map-and-3533 = { $help }; modes, forced_response, stability_map және transient бір айналу жиілігінде есептейді
diag-is-one-value-and-this-study-31a8 = { $field } – бір мән, ал бұл зерттеуге ауқым керек
diag-write-2145 = { $field } = {"{"} from = .., to = .. {"}"} деп жазыңыз
diag-must-go-from-a-lower-to-a4b0 = { $field } кіші мәннен үлкен мәнге қарай берілуі керек
diag-needs-ends-farther-apart-bf86 = { $field }: шеттерінің арасы алшағырақ болуы керек
diag-is-too-narrow-its-ends-differ-11bf = { $field } тым тар: шеттерінің айырмасы миллиардтан бірінен аз
diag-needs-at-least-points-6b87 = { $field }: кемінде { $least } нүкте керек
diag-leave-points-out-for-a-fitting-7f88 = points өрісін алып тастаңыз, сонда қолайлы сан таңдалады
diag-requires-points-which-are-too-many-10f6 = { $field }: { $points } нүкте керек, бұл тым көп
diag-at-most-points-a673 = көп дегенде { $most } нүкте

## laval-solve/src/ensemble/mod.rs

diag-has-memory-states-which-an-explicit-422f = «{ $name }» бөлшегінде жады күйлері бар, айқын әдіс оларды есептей алмайды
diag-use-method-stiff-baf2 = method = "stiff" қолданыңыз

## laval-solve/src/harmonic/balance/refused.rs

diag-order-of-the-motion-would-lie-2fd8 = қозғалыстың { $orders } реті үздіксіз спектрге түсер еді ({ $name }: { $waves }, { $speed } кезінде { $a } – { $b } аралығы), онда орныққан жауап жоқ
diag-orders-of-the-motion-would-lie-8d8e = қозғалыстың { $orders } реттері үздіксіз спектрге түсер еді ({ $name }: { $waves }, { $speed } кезінде { $a } – { $b } аралығы), онда орныққан жауап жоқ
diag-with-symmetry-half-where-the-law-928a = { $remedy }; заңда мүмкін болса, symmetry = "half" мәнінде тек тақ реттер қозғалады
diag-the-machine-has-no-periodic-motion-32a0 = бір ретте машинаның периодты қозғалысы жоқ: { $why }
diag-a-body-without-any-spring-drifts-536a = серіппесіз дене ығысып кетеді; массасы, демпферлеуі және қатаңдығы жоқ координата анықталмаған

## laval-solve/src/harmonic/branches/response.rs

diag-the-machine-is-symmetric-by-any-0931 = машина кез келген бұрышқа симметриялы: қозғалысы тек 1-ретті шеңберлік қозғалыс ретінде есептеледі, { $divisor } айналымда қайталанатын қозғалыс оған жатпайды
diag-leave-subharmonic-out-or-write-symmetry-70a8 = subharmonic өрісін алып тастаңыз немесе көбірек рет сақтау үшін symmetry = "none" жазыңыз
diag-leave-subharmonic-out-or-write-symmetry-a746 = subharmonic өрісін алып тастаңыз немесе көбірек рет сақтау үшін symmetry = "half" немесе "none" жазыңыз
diag-the-machine-has-no-symmetry-by-0c76 = машинада { $symmetry } симметриясы жоқ: бұрғанда «{ $part }» бөлшегі өзгереді
diag-the-machine-has-no-symmetry-by-3964 = машинада { $symmetry } симметриясы жоқ
diag-use-symmetry-auto-this-machine-is-2aec = symmetry = "auto" қолданыңыз; бұл машинада { $symmetry } симметриясы бар
diag-the-response-cannot-be-followed-ba98 = жауапты жалғастырып есептеу мүмкін емес: { $e }
diag-no-periodic-motion-was-found-at-47e1 = { $lo } кезінде де, { $hi } кезінде де периодты қозғалыс табылмады
diag-integrate-the-machine-in-time-transient-0e26 = машинаны уақыт бойынша интегралдаңыз (transient, sweep): оның қозғалысы бір айналымнан кейін қайталанбауы немесе мүлде қайталанбауы мүмкін

## laval-solve/src/harmonic/free/backbone.rs

diag-all-parts-of-this-machine-are-e65c = бұл машинаның барлық бөлшегі сызықты: еркін прецессияларының жиілігі кез келген амплитудада бірдей
diag-use-modes-or-campbell-for-these-cd7a = бұл жиіліктер үшін modes немесе campbell қолданыңыз
diag-the-family-cannot-be-followed-5ca8 = топты жалғастырып есептеу мүмкін емес: { $e }
diag-the-asymptotes-could-not-be-computed-1ebf = асимптоталарды есептеу мүмкін болмады: { $why }

## laval-solve/src/harmonic/free/cycles.rs

diag-all-parts-of-this-machine-are-26e6 = бұл машинаның барлық бөлшегі сызықты: орнықсыз болғанда прецессиясы шексіз өседі
diag-use-stability-map-for-the-ranges-5a82 = орнықсыз айналу жиілігі аралықтары үшін stability_map қолданыңыз
diag-nothing-damps-this-machine-its-free-59a9 = бұл машинада демпферлеу жоқ: еркін прецессиялары барлық амплитудалы топтар түзеді, олардың ешқайсысы шектік цикл емес
diag-use-backbone-for-the-families-or-b5f7 = топтар үшін backbone қолданыңыз немесе машинаға демпферлеу беріңіз ({ $by })
diag-use-backbone-for-the-families-or-cf95 = топтар үшін backbone қолданыңыз немесе машинаға демпферлеу беріңіз
diag-the-cycles-cannot-be-followed-0df2 = циклдерді жалғастырып есептеу мүмкін емес: { $e }

## laval-solve/src/harmonic/free/whirl.rs

diag-the-force-of-depends-on-the-5b01 = «{ $name }» күші ротор бұрышына немесе уақытқа тәуелді: бұл машинада еркін қозғалыс жоқ
diag-use-nonlinear-response-for-the-motion-1f45 = мәжбүрлі қозғалыс үшін nonlinear_response немесе transient қолданыңыз

## laval-solve/src/harmonic/loci/existence.rs

diag-choose-another-range-of-the-parameter-8d88 = параметрдің басқа ауқымын таңдаңыз
diag-the-machine-does-not-exist-at-9578 = { $path } параметрінің тексерілген ешбір мәнінде машинаны құру мүмкін емес: { $why }
diag-the-machine-does-not-exist-at-b3f3 = { $path } параметрінің тексерілген ешбір мәнінде машинаны құру мүмкін емес
diag-the-machine-exists-at-a-single-e5fd = бұл ауқымда машинаны { $path } параметрінің бір ғана мәнінде құруға болады

## laval-solve/src/harmonic/loci/search.rs

diag-the-locus-cannot-be-followed-7127 = бифуркация сызығын жалғастырып есептеу мүмкін емес: { $e }

## laval-solve/src/harmonic/stability/floquet.rs

diag-has-no-time-domain-form-4e95 = «{ $part }» бөлшегінің уақыт облысындағы формасы жоқ: { $why }
diag-the-machine-has-first-order-states-7ed4 = машинада бірінші ретті { $n } күй бар, бұл период бойынша бейнелеу шегінен көп
diag-the-force-of-jumps-when-it-ebe9 = «{ $part }» бөлшегінің күші жанасқанда секіреді, мұндай секірістің ұйытқуға әсері есептелмейді
diag-a-coordinate-has-no-mass-1332 = бір координатаның массасы жоқ

## laval-solve/src/motion/direct.rs

diag-the-spin-angle-451f = айналу бұрышы
diag-the-mass-matrix-is-singular-no-91ea = масса матрицасы ерекше: «{ $place }» координатасында өз инерциясы қалмайды
diag-the-mass-matrix-has-an-entry-344a = масса матрицасында ақырлы емес элемент бар («{ $place }» координатасы)

## laval-solve/src/motion/mod.rs

diag-the-machine-has-no-equations-of-754e = машинаның қозғалыс теңдеулері жоқ: { $what }
diag-no-places-of-the-coordinates-without-3d01 = инерциясыз координаталардың ешбір орнында күштер теңеспейді
diag-without-inertia-no-damping-or-stiffness-fdb8 = инерциясыз «{ $place }» координатасын демпфирлеу де, қатаңдық та анықтамайды
diag-a-coordinate-follows-from-inertia-or-9b2d = координата инерциядан, ал инерциясыз — оны ұстайтын демпферден немесе серіппеден анықталады: оған ие бөлшекке масса беріңіз немесе оны бекітіңіз, ал еркін айналуға оське қатысты инерция моментін беріңіз

## laval-solve/src/motion/trajectory.rs

diag-the-motion-cannot-be-computed-from-98a8 = қозғалысты бастапқы шартынан есептеу мүмкін емес: { $what }

## laval-solve/src/pencil.rs

diag-is-given-in-the-frequency-domain-f133 = «{ $name }» тек жиілік облысында берілген: { $why }
diag-forced-response-works-with-it-and-dda6 = онымен forced_response жұмыс істейді, ал бөлшектің аналитикалық облысы көрсетілсе, тепе-теңдік маңындағы modes та жұмыс істейді
diag-the-modes-at-could-not-be-a843 = { $speed } кезіндегі модаларды есептеу мүмкін болмады: { $e }
diag-a-coordinate-with-neither-mass-damping-44a1 = массасы, демпферлеуі және қатаңдығы жоқ координата модаларды анықталмаған етеді

## laval-solve/src/programme.rs

diag-the-speeds-must-be-finite-and-08cc = айналу жиіліктері ақырлы, өзгеру ұзақтығы оң болуы керек
diag-an-exponential-change-never-reaches-or-b31b = экспоненциалды өзгеріс нөлге жетпейді және нөлден басталмайды: екі айналу жиілігінің таңбасы бірдей болуы керек
diag-a-polynomial-of-the-speed-has-15d4 = айналу жиілігінің көпмүшесінде 1 – { $most } коэффициент болады, берілгені: { $given }
diag-the-coefficients-must-be-finite-and-99d2 = коэффициенттер ақырлы, өзгеру ұзақтығы оң болуы керек
diag-a-table-of-speeds-needs-at-8eba = айналу жиіліктері кестесіне кемінде екі нүкте керек, айналу жиіліктері мен уақыттардың саны бірдей болуы керек
diag-times-and-speeds-must-be-finite-3507 = уақыттар мен айналу жиіліктері ақырлы болуы керек
diag-the-times-must-increase-is-followed-8e71 = уақыттар өсуі керек; { $first } мәнінен кейін { $second } берілген
diag-the-speed-changes-faster-than-can-3094 = айналу жиілігінің өзгеруі есептеу үшін тым жылдам

## laval-solve/src/rest.rs

diag-the-machine-has-no-rest-the-72b5 = машинаның тыныштық күйі жоқ: «{ $name }» күші ротормен бірге айналады
diag-transient-gives-the-motion-in-time-681b = transient қозғалысты уақыт бойынша есептейді
diag-stationary-gives-the-states-that-turn-c025 = stationary ротормен бірге айналатын күйлерді және олардың орнықтылығын, transient пен run_up қозғалысты уақыт бойынша есептейді
diag-transient-and-run-up-give-the-0238 = transient пен run_up қозғалысты уақыт бойынша есептейді
diag-cannot-be-linearised-at-rest-01cd = «{ $name }» бөлшегін тыныштықта сызықтандыру мүмкін емес: { $reason }
diag-use-a-nonlinear-study-or-one-c104 = бейсызық зерттеуді немесе уақыт бойынша зерттеуді қолданыңыз немесе бөлшекке алдын ала керіліс беріңіз
diag-the-machine-has-no-equilibrium-under-d65d = жүктеме астында машинаның тепе-теңдігі жоқ: бір координатаны ешбір қатаңдық ұстап тұрған жоқ
diag-attach-a-bearing-shaft-or-foundation-b11e = жүктеме көтеретін әр денеге мойынтірек, білік немесе іргетас бекітіңіз; теңгергіш шариктері сияқты еркін қозғалатын массалардың тыныштықта тепе-теңдігі жоқ: { $free }
diag-no-equilibrium-was-found-newton-s-d993 = тепе-теңдік табылмады (Ньютон әдісі тоқтады, қадамы сипаттық өлшемнің { $step } есесі)
diag-check-the-load-and-the-characteristics-cdab = жүктеме мен бейсызық бөлшектердің сипаттамаларын тексеріңіз немесе басқа күйден бастаңыз

## laval-solve/src/roots.rs

diag-a-part-without-time-form-is-6af5 = уақыт облысындағы формасы жоқ бөлшек тек тыныштық күй маңында сызықтандырылады
diag-leave-about-out-067c = about өрісін алып тастаңыз
diag-does-not-say-where-its-dynamic-c7f1 = «{ $name }» бөлшегінде динамикалық қатаңдықтың аналитикалық облысы көрсетілмеген
diag-without-that-no-roots-can-be-e4c1 = онсыз түбірлерді санау мүмкін емес; онымен forced_response жұмыс істейді
diag-the-frequencies-of-the-machine-have-ce0d = машина жиіліктерінің түбір санауға болатын шегі жоқ
diag-give-frequency-limit-df65 = frequency_limit беріңіз

## laval-solve/src/co_rotating.rs

diag-from-the-undeflected-machine-no-state-da81 = деформацияланбаған машинадан бастағанда ротормен бірге айналатын күй табылмады
diag-the-machine-has-no-state-that-5f47 = машинада ротормен бірге айналатын күй жоқ: { $reason }
diag-studies-about-rest-about-rest-by-e3da = мұндай машинаға тыныштық күй маңындағы зерттеулер (about = "rest"), гармоникалық зерттеулер және уақыт бойынша зерттеулер (transient, run_up) жарайды
diag-the-machine-has-no-equilibrium-at-cc55 = машинаның тыныштықта да тепе-теңдігі жоқ: transient пен run_up қозғалысты уақыт бойынша есептейді
diag-the-weight-of-pulls-to-one-fdd8 = «{ $name }» салмағы бір жаққа тартады (axis = "horizontal")
diag-differs-in-x-and-y-a4f1 = { $base } мәні x ({ $x } { $unit }) және y ({ $y } { $unit }) бағыттарында әртүрлі
diag-the-forces-of-do-not-turn-00ed = машина мен күйді бұрғанда «{ $name }» ({ $kind }) күштері бірге бұрылмайды

## Studies in parts

diag-is-rows-to-are-missing-2dec = { $path } файлы: { $why }; { $first }–{ $last } жолдар жоқ
diag-of-rows-are-missing-those-of-2c01 = жоқ жолдар саны: { $all } жолдан { $rows }, бөліктер нөмірі { $shown } (барлығы { $of })
diag-part-of-has-no-rows-d16b = { $number }-бөлік (барлығы { $of }): жол жоқ
diag-part-of-of-rows-are-there-9818 = { $number }-бөлік (барлығы { $of }): { $total } жолдан { $done } дайын
diag-run-the-parts-that-have-not-0f55 = аяқталмаған бөліктерді қайта іске қосыңыз; k кесегі n бөліктің ((k - 1) mod n) + 1 бөлігіне жатады. laval run жоғын есептейді
diag-the-study-is-planned-not-run-a333 = зерттеу жоспарланды, бірақ орындалған жоқ
diag-lb-is-a-mass-the-force-a3b2 = lb – масса бірлігі; күш бірлігі – lbf: { $meant } деп жазыңыз
diag-write-the-speed-at-which-the-49ba = машина жұмыс істейтін айналу жиілігін жазыңыз, мысалы speed = "3000 rpm"; ол [machine] ішінде берілсе, speed кілтін алып тастаңыз
diag-write-the-lowest-speed-at-which-520c = 0 орнына машина жұмыс істейтін ең төменгі айналу жиілігін жазыңыз: тыныштықтан екпін алу бұл аралыққа кірмейді
diag-give-a-value-b1a9 = рұқсат етілген мәндер: { $bounds }
diag-nothing-holds-the-tilt-of-alone-ad2e = «{ $name }» көлбеуін ({ $names }) ештеңе ұстамайды, жеке де, онымен жалғанған денелермен бірге де
diag-let-a-shaft-act-on-the-94fc = білік көлбеуге әсер етсін (tilt_stiffness немесе дөңгелек білік), денені екі биіктікте ұстаңыз немесе diametral_inertia бермеңіз: онда ол көлбемейді
diag-no-study-of-divides-into-parts-548e = { $file } файлының бірде-бір зерттеуі бөліктерге бөлінбейді
diag-leave-out-part-laval-run-computes-7c4e = --part қоспаңыз: laval run барлық зерттеуді есептейді
diag-parts-are-requested-and-no-study-4ded = { $of } бөлік сұралды, ал { $file } файлының бірде-бір зерттеуі { $most } бөліктен артыққа бөлінбейді
diag-number-the-parts-from-1-to-d23e = бөліктерді 1/{ $most } бастап { $most }/{ $most } дейін нөмірлеңіз немесе азырақ алыңыз; әр зерттеудің қалай бөлінетінін laval plan көрсетеді
diag-is-no-machine-has-less-than-088d = { $who }: { $name } = { $value }; машиналарда { $least } мәнінен аз болмайды
diag-is-no-machine-has-more-than-21e1 = { $who }: { $name } = { $value }; машиналарда { $most } мәнінен көп болмайды
diag-far-outside-a589 = шектен әлдеқайда тыс
diag-check-the-number-and-its-unit-ee7b = сан мен оның бірлігін тексеріңіз; есептеу осы мәнмен жүреді
diag-files-of-cases-with-numbers-each-e703 = { $rows } жағдайдан, әрқайсысында { $columns } саннан тұратын файлдар тым үлкен: бір файлда ең көбі { $most } сан
diag-the-machine-has-coordinates-and-states-452d = машинада { $n } координата және элементтердің { $m } күйі бар; бірге ең көбі { $most } есептеледі
diag-note-threads-cannot-be-started-one-a291 = ескерту: { $wanted } ағынды іске қосу мүмкін болмады ({ $e }): бір ағын есептейді. Қанша ағын керегін RAYON_NUM_THREADS айтады.

# laval-model/src/parts/shaft
diag-the-position-is-not-on-the-d41c = { $position } орны денеден тыс: дене { $low } мен { $high } аралығында
diag-is-a-attach-to-a-disc-9439 = «{ $name }» бөлшегінің түрі { $kind }; дискіге, білікке немесе іргетасқа бекітіңіз
diag-is-attached-to-itself-by-way-b48c = «{ $name }» басқа денелер арқылы өзіне бекітілген
diag-parameters-of-a-reduced-machine-cannot-b5d6 = келтірілген машинаның параметрлерін өзгертуге болмайды
diag-a-shaft-has-1-to-sections-a510 = біліктің бөліктері 1-ден { $most } дейін болады
diag-give-each-section-one-entry-in-0a0d = әр бөлікке әр тізімде бір мән беріңіз
diag-a-section-is-long-06c8 = бөліктің ұзындығы { $length }
diag-lengths-are-between-1-m-and-249f = ұзындықтар 1 мкм мен 1 км аралығында
diag-the-outer-diameter-of-a-section-ec18 = бөліктің сыртқы диаметрі { $diameter }
diag-diameters-are-between-1-m-and-c7e8 = диаметрлер 1 мкм мен 100 м аралығында
diag-section-the-inner-diameter-must-be-eed5 = { $number }-бөлік: ішкі диаметр сыртқысынан кіші болуы керек
diag-modulus-and-shear-modulus-make-a-9d86 = modulus пен shear_modulus Пуассон коэффициентін { $nu } береді, ондай металл жоқ: E = 2 G (1 + nu)
diag-is-attached-to-e4e1 = { $kind } «{ $block }» мынаған бекітілген: «{ $name }»; { $beyond }
diag-not-on-the-body-23cd = денеде емес
diag-row-has-no-7ab0 = { $who }, { $row }-жол: { $name } жоқ ({ $doc })
diag-a-compression-of-buckles-it-unless-2945 = { $force } сығу оны майыстырады, егер ұштарының арасындағы мойынтіректер ұстамаса: екі ұшы бекітілгенде ол ең көбі { $limit } көтереді
diag-hold-it-at-a-second-place-041d = оны екінші жерде ұстаңыз: тағы бір мойынтірек қосыңыз

# Supports of the rotor
diag-is-not-given-by-mass-gyroscopic-1bec = «{ $name }» масса, гироскоптық және қатаңдық матрицаларымен берілмеген және карта ауыстыратын тірек емес
diag-name-it-in-supports-if-it-35db = егер ол тірек болса, supports өрісінде атаңыз; әйтпесе campbell мен critical_speeds кез келген бөлікті қабылдайды
diag-the-machine-has-no-support-that-86fb = машинада ауыстыруға болатын тірек жоқ
diag-a-support-is-a-part-with-05ea = тірек – айналатын мен айналмайтынның арасындағы қатаңдығы бар бөлік; supports басқаларын атайды
diag-there-is-no-part-8a0d = «{ $name }» бөлігі жоқ
diag-does-not-join-a-turning-body-fc00 = «{ $name }» айналатын денені ештеңемен қоспайды
diag-parts-that-join-a-turning-body-fe2b = айналатын денені бірдеңемен қосатын бөліктер: { $names }
diag-there-is-no-parameter-of-has-463f = «{ $path }» параметрі жоқ: «{ $part }» элементінің { $name } тізімінде бір жол бар
diag-there-is-no-parameter-of-has-193c = «{ $path }» параметрі жоқ: «{ $part }» элементінің { $name } тізіміндегі жол саны { $count }
diag-rows-are-numbered-from-1-parameters-b396 = жолдар 1-ден бастап нөмірленеді; соңғысының параметрлері: { $near }
diag-steady-response-at-3e8c = { $speed } кезіндегі орныққан жауап
diag-branch-from-the-lowest-speed-at-2bf4 = ең төмен айналу жиілігінен басталған тармақ, { $speed } кезінде
diag-branch-from-the-highest-speed-at-0be3 = ең жоғары айналу жиілігінен басталған тармақ, { $speed } кезінде
diag-further-branch-at-c050 = басқа тармақ, { $speed } кезінде
diag-stability-of-the-branch-from-the-29af = ең төмен айналу жиілігінен басталған тармақтың орнықтылығы, { $speed } кезінде
diag-stability-of-the-branch-from-the-a793 = ең жоғары айналу жиілігінен басталған тармақтың орнықтылығы, { $speed } кезінде
diag-stability-of-a-further-branch-at-5e02 = басқа тармақтың орнықтылығы, { $speed } кезінде

# laval/src/import, laval-cli/src/import.rs

diag-left-out-there-are-no-lateral-3572 = { $elements }: алынып тасталды, көлденең коэффициенттері жоқ
diag-between-the-rows-of-a-table-98ce = кестенің жолдары арасында ROSS 2 сплайн, laval ROSS 3 сияқты монотонды кубтық қисық жүргізеді
diag-cone-mid-section-gives-the-cones-61fb = cone = "mid_section" ROSS конустарын береді; бұл кілтсіз олар тезірек жинақталады
diag-lateral-motion-alone-is-carried-over-869f = тек көлденең қозғалыстар көшірілді; қалғандарын біліктің axial = true және torsional = true кілттері қосады
diag-ross-takes-g-9-8065-m-9851 = ROSS run_static есебінде g = 9.8065 m/s^2 алады, laval 9.80665 m/s^2 алады
diag-is-at-node-where-neither-the-2fb9 = { $element } { $node }-түйінде тұр, онда білік те, шоғырланған масса да жоқ
diag-has-no-3dc9 = { $element } ішінде { $key } кілті жоқ
diag-of-must-be-not-c7c2 = { $element } ішіндегі { $key }: { $wanted } керек, { $shape } емес
diag-a-finite-number-ee7c = ақырлы сан
diag-the-number-of-a-node-from-0b42 = 0 мен { $most } арасындағы түйін нөмірі
diag-a-list-of-finite-numbers-3e52 = ақырлы сандар тізімі
diag-left-out-5499 = { $elements }: көшірілмеді: { $keys }
diag-a-disc-without-teeth-e596 = { $elements }: тістері жоқ диск
diag-the-mean-of-mx-and-my-8318 = { $elements }: mx пен my орташасы алынды
diag-the-length-of-must-be-positive-9a7e = { $element } ұзындығы оң болуы керек
diag-has-values-of-for-speeds-0087 = { $element } ішінде { $key } мәндері: { $n }, ал айналу жиіліктері: { $wanted }
diag-of-the-coefficients-over-speed-and-9cb9 = { $elements }: айналу жиілігі мен тербеліс жиілігі бойынша коэффициенттерден екі жиілік тең болатындары алынды
diag-coefficients-over-frequency-are-taken-over-59b6 = { $elements }: тербеліс жиілігі бойынша коэффициенттер айналу жиілігі бойынша алынды
diag-the-coefficients-are-those-in-the-45ec = { $elements }: коэффициенттер файлдан алынды, геометрия көшірілмеді
diag-in-effect-in-all-studies-ross-43d4 = { $elements }: барлық есептерде ескеріледі; ROSS run_static есебінде тығыздағыштарды ескермейді
diag-it-is-not-utf-8-text-eb31 = бұл UTF-8 мәтіні емес
diag-it-is-not-a-table-of-ed88 = бұл элементтер кестесі емес
diag-its-tables-are-nested-too-deeply-59ac = кестелер тым терең кірістірілген
diag-this-model-is-no-machine-here-551b = бұл модель бойынша машина құруға болмайды: { $why }
diag-this-is-no-model-that-ross-c0a1 = бұл ROSS сақтаған модель емес: { $why }
diag-rotor-save-rotor-toml-and-rotor-8e3a = ROSS 2 және 3 ішіндегі rotor.save("rotor.toml") мен rotor.save("rotor.json") жазған модельдер оқылады
diag-the-file-cannot-be-read-3769 = файл оқылмайды: { $why }
diag-elements-of-the-kind-are-not-89d8 = { $class } түріндегі элементтер көшірілмейді
diag-elements-that-are-imported-23a2 = көшірілетін элементтер: { $all }
diag-it-has-no-shaftelement-bf65 = онда ShaftElement жоқ
diag-no-element-of-the-shaft-lies-e19b = { $k } және { $next } түйіндері арасында білік элементі жоқ
diag-the-shafts-of-several-rotors-in-ca3c = бір модельдегі бірнеше ротордың біліктері көшірілмейді
diag-the-mass-is-carried-over-as-2fac = { $elements }: масса диск ретінде көшірілді, қатаңдық көшірілмеді
diag-of-elements-differs-that-of-is-d2a2 = { $key } өзгеше (элементтер саны: { $n }); бүкіл білікке { $first } мәні алынды
diag-rotary-inertia-and-gyroscopic-are-on-f7ff = rotary_inertia мен gyroscopic барлық элементтерде қосулы; модельде олар өшірулі (элементтер саны: { $n })
diag-left-out-or-different-in-ross-343d = Көшірілмеді немесе ROSS ішінде басқаша:
diag-and-more-1d3b = { $names } және тағы { $n }
diag-add-a-part-of-kind-speed-cc8c = осы аты бар kind = "speed_ratio" бөлшегін және оның машинаның айналу жиілігіне қатынасын қосыңыз
diag-spins-of-this-machine-d82c = осы машинаның айналулары: { $spins }
diag-turns-with-the-spin-which-does-1f6e = "{ $slot }" "{ $name }" айналуымен айналады, ал ондай айналу жоқ
diag-a-coupling-joins-shafts-of-one-3e2d = муфта айналу жиілігі бірдей біліктерді қосады; әртүрлі жиіліктегі біліктер арасында тісті беріліс немесе подшипник керек
diag-a-wheel-sits-on-a-turning-8ee2 = дөңгелек айналатын денеде отырады, жерде емес
diag-name-the-two-shafts-or-discs-cbce = дөңгелектер отырған екі білікті немесе дискіні атаңыз
diag-the-second-body-turns-times-as-56df = екінші дене біріншіден { $ratio } есе жылдам айналады, ал радиустар бойынша { $needed } есе; оған осы қатынастағы айналу беріңіз
diag-a-spin-of-ratio-0-stands-f193 = қатынасы 0 айналу орнында тұр: айналмайтын бөлшектерге ол керек емес
diag-this-study-knows-one-spin-and-77ac = бұл есепке бір айналу керек, ал машинада басқасы бар, "{ $name }"
diag-contact-angle-is-given-without-balls-aa45 = contact_angle мәні balls-сыз берілген
diag-a-coefficient-holds-the-angle-already-7b11 = коэффициент бұрышты есепке алады: contact_angle-ды алып тастаңыз
diag-the-bearing-has-no-contact-coefficient-5cac = мойынтіректің жанасу коэффициенті жоқ
diag-give-coefficient-or-balls-and-ball-ccc8 = coefficient немесе balls пен ball_diameter беріңіз
diag-coefficient-is-given-beside-the-geometry-f29d = coefficient шариктер геометриясымен бірге берілген
diag-balls-is-given-without-ball-diameter-a70a = balls мәні ball_diameter-сіз берілген
diag-ball-diameter-is-given-without-balls-6beb = ball_diameter мәні balls-сыз берілген
diag-the-contact-coefficient-must-be-positive-11f4 = жанасу коэффициенті оң болуы керек
diag-the-ratio-of-the-stiffnesses-is-f766 = қатаңдықтар қатынасы 8–16 домалау денесі үшін белгілі, { $count } үшін емес
diag-give-ratio-the-stiffness-across-the-9a5b = ratio беріңіз: жүктемеге көлденең қатаңдықтың бойлық қатаңдыққа қатынасы; керілген көп домалау денесінде ол 1-ге жақын
diag-the-ratio-of-the-stiffnesses-is-dd9f = қатаңдықтар қатынасы 8–16 домалау денесі үшін белгілі
diag-layer-goes-from-to-e940 = { $number }-қабат { $from } бастап { $to } дейін
diag-it-lies-on-the-shaft-from-d944 = ол біліктің бойында, төменгі ұшынан жоғарғысына: 0 мен { $length } аралығында
diag-layer-the-inner-diameter-must-be-f017 = { $number }-қабат: ішкі диаметр сыртқысынан кіші болуы керек
diag-inner-diameter-is-that-of-the-d9f3 = төлкенің inner_diameter мәні оның астындағы білік диаметрі
diag-layer-has-no-material-modulus-shear-103d = { $number }-қабаттың материалы жоқ: modulus, shear_modulus және density қатты денені береді, stiffness — 0-ден 1-ге дейінгі үлес
diag-leave-out-what-it-has-in-944a = білікпен ортақ мәндерін бермеңіз; stiffness = 0 — тек массасы бар қабат
diag-layer-overlaps-the-shaft-at-its-d014 = { $number }-қабат { $position } жерінде білікпен қиылысады: ішкі диаметрі { $inner }, біліктің ондағы сыртқы диаметрі { $outer }
diag-a-layer-of-the-shaft-with-e9c1 = { $elements }: ортақ ығысу бұрышы бар білік қабаты; ROSS-та әр қабаттың өзінікі
diag-separation-margins-need-an-operating-speed-78a5 = жиілік қорларына жұмыс жиілігі керек
diag-give-speed-in-machine-or-the-6a56 = [machine] ішінде speed немесе [operation] ішінде жұмыс жиіліктерінің диапазонын беріңіз
diag-frequency-belongs-to-one-spin-speed-36ee = frequency бір айналу жиілігіне жатады
diag-give-one-speed-or-order-in-c27b = бір жиілік немесе frequency орнына order беріңіз
diag-order-and-frequency-both-say-how-ed69 = order да, frequency де күштің жиілігін береді
diag-leave-one-of-them-out-0b3f = біреуін алып тастаңыз
diag-separation-margins-are-those-of-a-5324 = жиілік қорлары айналу жиіліктерінің диапазонына жатады
diag-leave-frequency-out-and-give-a-f93a = frequency-ді алып тастап, айналу жиіліктерінің диапазонын беріңіз
diag-responses-at-values-of-coordinates-e18e = { $n } координатаның { $values } мәндегі жауаптары
diag-the-point-on-which-the-force-7c2b = күш түсетін нүкте өське көлденең қозғалмайды
diag-name-a-point-of-a-disc-206e = дискінің, біліктің немесе іргетастың нүктесін атаңыз
diag-up-to-is-below-the-anticipated-90ef = up_to күтілетін { $anticipated } қатаңдықтан кіші
diag-give-a-larger-up-to-or-f72d = үлкенірек up_to беріңіз немесе алып тастаңыз
diag-no-lateral-mode-of-this-machine-bf9e = бұл машинаның тербелмелі көлденең модасы жоқ
diag-cross-coupled-stiffness-makes-lateral-modes-69e4 = айқас қатаңдық көлденең модаларды орнықсыз етеді: modes машина модаларын тізеді
diag-roots-to-follow-61c7 = бақыланатын түбірлер
diag-no-mode-becomes-less-stable-with-f0e4 = қатаңдықпен ешбір мода орнықтылығын жоғалтпайды, сондықтан ең үлкенін ұсыну мүмкін емес
diag-give-up-to-2dd8 = up_to беріңіз
diag-is-fixed-to-which-turns-with-7c07 = "{ $slot }" "{ $body }" денесіне бекітілген, ал ол басқа айналумен айналады
diag-leave-spin-out-it-turns-with-b814 = spin өрісін алып тастаңыз: дене бекітілген денемен бірге айналады; немесе оған өз координаттарын және араларына подшипник беріңіз
diag-modes-campbell-critical-speeds-stability-map-4ae2 = бірнеше айналуға modes, campbell, critical_speeds, stability_map, forced_response, harmonic_force, static, transient және run_up жол береді
diag-says-how-couplings-are-aligned-and-e84a = { $field } муфталарды ортаға келтіруге қатысты, ал couplings өрісінде ешбірі аталмаған
diag-name-couplings-or-remove-fddd = couplings өрісінде муфталарды атаңыз немесе { $field } өрісін алып тастаңыз
diag-joins-no-shaft-that-bends-to-a48c = "{ $name }" иілетін білікті басқа денемен қоспайды
diag-name-a-coupling-between-two-shafts-cfbb = екі білік арасындағы муфтаны немесе орынды атаңыз, мысалы "shaft at 1200 mm"
diag-couplings-names-which-is-neither-a-b851 = couplings өрісі "{ $name }" атауын береді, ал бұл бөлік те, біліктің орны да емес
diag-a-place-of-a-shaft-is-497d = біліктің орны "shaft at 1200 mm" түрінде жазылады
diag-is-no-node-of-the-shaft-5235 = { $name } біліктің түйіні емес: ең жақыны { $near } жерінде
diag-end-a-section-of-the-shaft-39cd = біліктің бөлігін сол жерде аяқтаңыз
diag-loads-of-couplings-vanish-only-with-76f3 = муфталардың { $needed } жүктемесі сонша жылжымалы тірек болғанда ғана жойылады, ал олар { $free }
diag-name-fewer-couplings-keep-fewer-supports-5374 = азырақ муфта атаңыз, азырақ тіректі қалдырыңыз немесе aligned_for = "moment" таңдаңыз
diag-and-support-the-same-place-with-773a = "{ $a }" және "{ $b }" бір орынды әртүрлі ығысумен ұстайды
diag-give-them-the-same-offsets-or-ca7d = оларға бірдей ығысу беріңіз немесе біреуін supports өрісінде атаңыз
diag-needs-an-operating-speed-which-neither-3164 = { $field } үшін жұмыс айналу жиілігі керек, ал ол [operation] ішінде де, [machine] ішінде де жоқ

# constant forces, spins without parts, supports named twice
diag-this-part-does-nothing-give-a-ce05 = бұл бөлшек ештеңе істемейді: күш немесе момент беріңіз
diag-this-force-was-built-without-d9df = бұл күш { $name } қасиетінсіз құрылған
diag-the-moment-of-has-no-effect-5998 = «{ $name }» моменті әсер етпейді: ол әсер ететін дене көлбемейді
diag-no-part-turns-with-c0c8 = «{ $name }» айналысымен ешбір бөлшек айналмайды
diag-name-it-in-a-shaft-or-b28c = оны білікте немесе дискіде атаңыз: spin = "{ $name }"
diag-is-named-twice-b544 = «{ $name }» екі рет аталған
diag-joins-two-points-of-one-body-7eda = «{ $name }» бір дененің екі нүктесін қосады
diag-a-bearing-or-shaft-joins-a-78c9 = мойынтірек не білік денені басқа денемен немесе "ground"-пен қосады
diag-a-gear-joins-the-rotations-of-7f02 = беріліс екі дененің айналуын байланыстырады: екеуіне де torsional = true беріңіз
diag-layers-and-are-in-the-same-4df9 = { $first } және { $second } қабаттары { $position } орнында бір жерде жатыр
diag-names-a-point-that-does-not-8b5a = { $field } «{ $n }» нүктесін атайды, «{ $body }» денесінде ондай нүкте жоқ
diag-it-reaches-from-to-517d = ол { $from } мен { $to } аралығында
diag-not-read-as-no-element-of-a77e = { $elements }: оқылмады, мұндай түрдегі элементтерде ондай кілт жоқ: { $keys }
diag-turns-times-as-fast-as-the-880f = «{ $name }» машинадан { $ratio } есе жылдам айналады, кестесі сол жиілік бойынша беріледі: теріс айналу жиіліктерін және сол бағыттың айқас коэффициенттерін жазыңыз
diag-the-file-has-no-number-bda7 = файлда «{ $path }» саны жоқ
diag-two-changes-are-of-the-same-1bd6 = екі өзгеріс файлдың бір орнына қатысты
diag-is-not-written-in-the-file-f870 = { $path } файлда жазылмаған
diag-is-no-quantity-296e = { $text } – шама емес
diag-a-critical-speed-has-an-order-339b = критикалық айналу жиілігінің реті 0-ден үлкен және жиілігі болады
diag-there-is-no-such-critical-speed-ea55 = { $at } маңында мұндай критикалық айналу жиілігі жоқ
diag-a-limit-of-stability-has-a-12c8 = орнықтылық шегінің айналу жиілігі болады
diag-there-is-no-limit-of-stability-8182 = { $at } маңында орнықтылық шегі жоқ
diag-is-released-twice-f3c3 = { $path } екі рет босатылған
diag-the-released-range-must-hold-the-a291 = { $path }: босатылған аралықта файлдағы мән болуы керек
diag-no-parameter-is-released-bfda = бірде-бір параметр босатылмаған
diag-the-wanted-value-is-no-number-92b4 = қалаулы мән – сан емес
diag-the-released-parameters-do-not-move-1fda = босатылған параметрлер бұл нәтижені жылжытпайды
diag-the-search-ended-at-beyond-this-d436 = іздеу { $value } мәнінде аяқталды: одан әрі бұл нәтиже жоқ немесе босатылған параметрлерге бағынбайды
diag-is-the-nearest-that-can-be-c523 = қол жеткізуге болатын ең жақын мән – { $value }: { $names } өз шегінде тұр
diag-is-the-nearest-that-can-be-c685 = қол жеткізуге болатын ең жақын мән – { $value }: { $names } өз шектерінде тұр
diag-the-machine-of-the-file-does-df10 = файлдағы машинада мұндай нәтиже жоқ
diag-the-machine-file-gives-no-speed-4340 = машина файлында айналу жиілігі берілмеген
diag-the-figure-cannot-be-drawn-666c = сурет салынбайды: { $e }
diag-one-of-value-and-written-is-a69e = { $path }: value немесе written қажет, екеуі бірге емес
diag-is-no-machine-file-toml-in-cfe5 = { $name } – студия бумасындағы машина файлы (.toml) емес
diag-is-larger-than-mb-3ad7 = { $path } { $size } МБ-тан үлкен
diag-has-changed-on-the-disk-since-3764 = { $path } ашылғаннан кейін дискіде өзгерген
diag-there-is-no-result-that-can-f05c = жылжытуға болатын { $what } нәтижесі жоқ
diag-the-request-cannot-be-read-8f3c = сұрау оқылмайды: { $e }
diag-this-is-a-defect-of-the-4010 = бұл файлдың емес, бағдарламаның қатесі: есептеу орындалмады
diag-there-is-no-such-run-165f = мұндай есептеу жоқ
diag-the-machine-has-no-such-study-f80c = машинада мұндай зерттеу жоқ
diag-the-study-cannot-be-started-3c9f = зерттеу іске қосылмайды: { $e }
diag-the-report-cannot-be-drawn-a076 = есеп салынбайды: { $e }
diag-the-server-cannot-be-started-9a0d = сервер іске қосылмайды: { $e }
diag-a-token-has-at-least-8-da81 = мекенжай құпиясында кемінде 8 әріп пен цифр болады
diag-cannot-open-9fcf = { $path } ашылмайды: { $e }
diag-at-most-designs-fit-into-one-c17c = бір файлға ең көбі { $most } нұсқа сыяды
diag-there-is-no-example-1e32 = { $name } мысалы жоқ
diag-name-a-file-or-an-example-9b54 = файлды немесе мысалды атаңыз
diag-is-no-machine-file-its-name-3c42 = { $path } – машина файлы емес: аты .toml болып аяқталмайды
diag-the-studio-is-open-in-the-faee = Студия браузерде ашылды; Ctrl-C оны аяқтайды.
diag-note-no-browser-could-be-opened-e857 = ескерту: браузер ашылмады; жоғарыдағы мекенжайды ашыңыз
diag-the-request-names-no-motion-2e64 = сұрауда қозғалыс көрсетілмеген
diag-the-response-has-no-bound-at-244c = бұл айналу жиілігінде тербеліс шектелмейді: өшірілмейтін резонанс
diag-no-state-of-the-nonlinear-response-5f5e = бұл айналу жиілігінде бейсызық тербелістің күйі табылмады
diag-the-file-has-no-transient-e71e = файлда { $name } атты transient зерттеуі жоқ
diag-the-result-at-cannot-be-moved-edb0 = { $stated } кезіндегі нәтижені жылжытуға болмайды: бақылауға болатын ең жақыны { $found } кезінде
diag-is-a-link-out-of-its-b2fe = { $path } — өз қалтасынан тыс сілтеме
diag-port-cannot-be-used-ed07 = { $port } портын пайдалануға болмайды: { $e }
diag-give-another-port-or-leave-port-5c64 = басқа порт көрсетіңіз немесе --port жазбаңыз: бос порт алынады
