### Sentences of diagnostics and of the command line; the names are those of text/en/diagnostics.ftl.

diag-error-a6c0 = xato
diag-warning-6bce = ogohlantirish
diag-help-9b8b = maslahat
diag-did-you-mean-dcdc = balki { $near } demoqchi bo‘lgandirsiz? { $list }
diag-did-you-mean-fa5e = balki { $near } demoqchi bo‘lgandirsiz?
diag-bodies-of-this-machine-e555 = bu mashinaning jismlari: { $all }
diag-is-attached-to-which-does-not-e3d3 = { $kind } "{ $block }": biriktirilgan "{ $name }" jismi mavjud emas
diag-no-such-body-1f1f = bunday jism yo‘q
diag-also-named-in-line-e5a1 = { $message } ({ $line }-qatorda ham bor)
diag-also-named-in-lines-and-6dd4 = { $message } ({ $lines } va { $last }-qatorlarda ham bor)
diag-also-named-in-lines-and-more-5c20 = { $message } ({ $lines }-qatorlarda va yana { $left } joyda bor)
diag-and-more-9d04 = ... va yana { $n } ta

## laval/src/file/assemble.rs

diag-give-about-turning-or-c5d1 = { $studies } uchun about = "turning" bering; yoki: { $or }
diag-give-about-turning-e2db = { $studies } uchun about = "turning" bering
diag-study-713d = "{ $one }" hisobi
diag-studies-a7da = { $names } hisoblari
diag-cannot-be-built-from-what-is-17a3 = { $kind } "{ $name }": berilgan qiymatlardan bu qismni tuzib bo‘lmaydi
diag-gives-a-force-that-is-not-403d = { $kind } "{ $name }": bu qism beradigan kuch chekli son emas
diag-a-value-of-this-part-is-16e4 = bu qismning bir qiymati hisoblash uchun juda katta yoki juda kichik

## laval/src/file/blocks.rs

diag-the-machine-has-no-parts-7f63 = mashinada qismlar yo‘q
diag-describe-each-part-in-a-block-256d = har bir qismni [[part]] bilan boshlanadigan blokda tavsiflang
diag-there-is-one-in-a-file-3572 = faylda { $word } bloki bitta bo‘ladi
diag-double-brackets-f6a7 = qo‘sh qavslar
diag-must-be-a-block-394a = { $word } blok bo‘lishi kerak
diag-write-with-single-brackets-once-and-c02a = [{ $word }] sarlavhasini yakka qavslarda, bir marta yozing, kalitlarini esa uning ostiga
diag-a-is-a-part-write-part-f85c = { $key } qism turidir: [[part]] va uning ostida kind = "{ $key }" yozing
diag-is-a-study-write-study-and-f8f8 = { $key } hisob turidir: [[study]] va uning ostida kind = "{ $key }" yozing
diag-every-key-stands-in-a-block-7dc3 = har bir kalit [machine], [[part]] yoki [[study]] blokida turadi; { $name } kaliti [machine] ostida yoziladi
diag-every-key-stands-in-a-block-8b85 = har bir kalit [machine], [[part]] yoki [[study]] blokida turadi
diag-a-file-has-one-machine-and-cd0f = faylda bitta [machine] hamda [[part]] va [[study]] bloklari bo‘ladi
diag-a-file-has-one-machine-and-ffdb = faylda bitta [machine] hamda [[part]] va [[study]] bloklari bo‘ladi; shuningdek: { $beside }
diag-is-not-a-block-of-a-3d1c = mashina faylida { $key } degan blok bo‘lmaydi
diag-unknown-04cc = noma’lum
diag-needs-double-brackets-66da = [{ $what }] sarlavhasiga qo‘sh qavslar kerak
diag-single-brackets-040e = yakka qavslar
diag-write-there-may-be-several-5078 = [[{ $what }]] ko‘rinishida yozing: bunday bloklar bir nechta bo‘lishi mumkin
diag-must-be-a-block-f338 = { $what } blok bo‘lishi kerak
diag-write-and-its-keys-below-0c3c = [[{ $what }]] sarlavhasini va uning ostida kalitlarini yozing
diag-a-must-be-a-block-not-807b = { $what } blok bo‘lishi kerak; berilgani: { $shape }
diag-two-blocks-are-named-4142 = ikkita [[{ $what }]] blokining nomi bir xil: { $name }
diag-two-blocks-are-named-apart-from-7b57 = ikkita [[{ $what }]] blokining nomi bir xil: { $name } (katta-kichik harflarni hisobga olmaganda { $first } bilan bir xil)
diag-taken-above-5dad = yuqorida band qilingan
diag-give-each-its-own-name-others-21ca = har biriga alohida nom bering; boshqa bloklar unga shu nom bilan murojaat qiladi
diag-has-no-key-beb0 = { $who }: { $key } kaliti yo‘q
diag-it-stands-inside-06c3 = u { $f } ichida turadi: { $f } = {"{"} { $key } = .. {"}"}
diag-did-you-mean-its-keys-68cd = balki { $near } demoqchi bo‘lgandirsiz? Kalitlari: { $all }
diag-its-keys-4d57 = kalitlari: { $all }
diag-unknown-key-b3fe = noma’lum kalit
diag-needs-d775 = { $who }: { $name } kaliti kerak: { $doc }
diag-add-605c = { $example } qo‘shing
diag-is-missing-e95c = { $name } = .. yo‘q
diag-the-file-has-no-machine-block-3137 = faylda [machine] bloki yo‘q
diag-begin-it-with-machine-and-below-3516 = faylni [machine] bilan boshlang, uning ostida name = ".." va speed = "3000 rpm" yozing

## laval/src/file/constructed.rs

diag-there-is-no-kind-of-study-7368 = "{ $kind }" degan hisob turi yo‘q
diag-there-is-59f4 = mavjudlari: { $all }
diag-the-study-cannot-be-made-from-9149 = bu maydonlardan hisob tuzib bo‘lmaydi
diag-the-fields-of-are-an-object-9722 = { $kind } maydonlari obyekt bo‘lishi kerak; berilgani: { $shape }
diag-write-df54 = {"{"} "speed": 300.0 {"}"} ko‘rinishida yozing

## laval/src/file/declared.rs

diag-the-declared-default-cannot-be-used-a68d = e’lon qilingan standart qiymat { $default } yaroqsiz: { $text }
diag-is-not-an-si-unit-b335 = { $kind }.{ $name }: { $unit } birligi SI birligi emas

## laval/src/file/held.rs

diag-nothing-holds-in-it-can-move-41a0 = "{ $name }" jismini { $names } bo‘yicha hech narsa ushlab turmaydi: u yolg‘iz yoki o‘zi ulangan jismlar bilan birga siljib ketishi mumkin
diag-join-it-to-ground-or-to-f640 = uni podshipnik yoki val bilan "ground" yoki poydevorga ulang; damper joyida ushlab turmaydi
diag-of-has-no-effect-what-it-e0f8 = "{ $slot }" qismining { $name } parametri ta’sir qilmaydi: u ulangan jism og‘maydi
diag-give-a-disc-its-diametral-inertia-7912 = disk og‘ishi uchun unga diametral_inertia bering
diag-is-clamped-at-which-does-not-8696 = "{ $name }" qismi "{ $body }" jismiga qattiq mahkamlangan, u esa og‘maydi
diag-give-its-to-let-it-tilt-696b = "{ $body }" jismi og‘ishi uchun unga { $lets } bering

## laval/src/file/joints.rs

diag-this-machine-has-no-body-add-f649 = bu mashinada jism yo‘q: disk kabi qism qo‘shing
diag-is-attached-to-which-is-a-ef10 = { $kind } "{ $block }": biriktirilgan "{ $name }" jism emas, uning turi: { $other }
diag-not-a-body-2491 = jism emas
diag-the-position-on-has-no-effect-fbb2 = "{ $name }" jismidagi joylashuv ta’sir qilmaydi: bu jism ({ $kind }) og‘maydi
diag-no-effect-04cf = ta’sir qilmaydi

## laval/src/file/mod.rs

diag-the-kind-of-is-declared-twice-ad11 = { $what } uchun { $kind } turi ikki marta e’lon qilingan
diag-declares-the-key-twice-abcf = { $kind }: { $name } kaliti ikki marta e’lon qilingan

## laval/src/file/names.rs

diag-unknown-parameter-af90 = noma’lum parametr
diag-coordinates-of-this-machine-baed = bu mashinaning koordinatalari: { $all }
diag-there-is-no-coordinate-e0c3 = "{ $name }" koordinatasi yo‘q
diag-unknown-coordinate-5bfd = noma’lum koordinata

## laval/src/file/naming.rs

diag-write-kind-not-type-4ed8 = type emas, kind = { $t } yozing
diag-write-kind-with-one-of-9d60 = kind = ".." uchun quyidagilardan birini yozing: { $all }
diag-this-says-no-kind-ea9b = { $block } blokida tur ko‘rsatilmagan
diag-kind-is-missing-ef9a = kind = ".." yo‘q
diag-kind-must-be-a-word-in-cd0b = { $block }: kind qo‘shtirnoq ichidagi so‘z bo‘lishi kerak; berilgani: { $shape }
diag-there-is-no-kind-of-called-2deb = { $what } blokining { $t } degan turi yo‘q
diag-unknown-kind-35ae = noma’lum tur
diag-kinds-of-studies-de0a = hisob turlari: { $all }
diag-kinds-of-s-5328 = { $what } turlari: { $all }
diag-the-name-of-a-must-be-68d4 = { $what } nomi qo‘shtirnoq ichidagi matn bo‘lishi kerak; berilgani: { $shape }
diag-a-cannot-be-named-ground-fe8c = { $what } nomi "ground" bo‘la olmaydi
diag-reserved-1e48 = band qilingan
diag-ground-is-the-fixed-surroundings-that-f758 = "ground" qismlar biriktirilishi mumkin bo‘lgan qo‘zg‘almas muhitni bildiradi
diag-cannot-be-the-name-of-a-90a3 = { $t } so‘zi { $what } nomi bo‘la olmaydi
diag-not-a-name-8729 = nom emas
diag-a-name-is-made-of-letters-2e08 = nom istalgan yozuv harflari, raqamlar, bo‘sh joylar, _ va - belgilaridan tuziladi, harf yoki raqam bilan boshlanadi va ko‘pi bilan 64 ta belgidan iborat bo‘ladi
diag-for-instance-5228 = masalan, { $name }: { $help }

## laval/src/file/nested.rs

diag-write-the-name-of-a-study-e443 = shu fayldagi hisob nomini yozing yoki { $example } yozing
diag-a-study-76fb = hisob
diag-studies-of-this-file-that-can-5f25 = shu faylda bajarish mumkin bo‘lgan hisoblar: { $all }
diag-add-such-a-study-to-this-bcab = faylga shunday hisob qo‘shing yoki bu yerda { $example } yozing
diag-is-but-no-study-has-that-9fe6 = { $who }: qiymati { $name }, lekin bunday nomli hisob yo‘q
diag-no-such-study-32eb = bunday hisob yo‘q
diag-cannot-be-a-study-of-kind-15ef = { $who }: { $kind } turidagi hisob bu yerda bo‘la olmaydi, chunki u o‘zi boshqa hisobni bajaradi
diag-runs-another-study-11b5 = boshqa hisobni bajaradi
diag-write-4281 = [{"{"} parameter = "drum.mass", distribution = "normal", deviation = "2 %" {"}"}] ko‘rinishida yozing
diag-a-list-of-uncertain-parameters-3ed5 = noaniq parametrlar ro‘yxati
diag-names-twice-9ac4 = { $who }: { $parameter } parametri ikki marta ko‘rsatilgan
diag-named-above-004f = yuqorida ko‘rsatilgan
diag-an-uncertain-parameter-196d = noaniq parametr
diag-has-no-f0cb = { $who }: { $key } kaliti yo‘q
diag-is-missing-9c2c = { $key } = .. yo‘q
diag-a-text-6622 = matn
diag-cannot-be-eb0f = { $who }: qiymat { $kind } bo‘la olmaydi
diag-distributions-8a45 = taqsimotlar: { $all } ({ $meanings })
diag-not-a-distribution-147d = taqsimot emas

## laval/src/file/numbers.rs

diag-write-a-number-with-a-unit-5e75 = sonni birligi bilan qo‘shtirnoq ichida yozing ({ $example }) yoki SI birliklaridagi yalang son yozing
diag-a-finite-number-is-needed-9e4f = { $who }: chekli son kerak
diag-not-finite-0a50 = chekli emas
diag-is-it-must-be-06bd = { $who }: qiymati { $value }; talab: { $bounds }
diag-write-if-you-mean-percent-1b90 = foizni nazarda tutgan bo‘lsangiz, "{ $x } %" yozing
diag-a-bare-number-is-in-put-f863 = yalang son { $unit } birligida olinadi; boshqa birliklar uchun son va birlikni qo‘shtirnoq ichiga yozing ({ $examples })
diag-out-of-bounds-444d = chegaradan tashqarida
diag-a-whole-number-or-auto-fc98 = butun son yoki "auto"
diag-a-whole-number-5f04 = butun son
diag-is-it-must-be-a-whole-6f22 = { $who }: qiymati { $i }; { $min } – { $max } oralig‘idagi butun son yoki "auto" bo‘lishi kerak
diag-is-it-must-be-a-whole-a695 = { $who }: qiymati { $i }; { $min } – { $max } oralig‘idagi butun son bo‘lishi kerak
diag-write-without-quotes-c0ab = { $t } qiymatini qo‘shtirnoqsiz yozing
diag-is-needed-not-0ee8 = { $who }: kerakli qiymat: { $wanted }; berilgani: { $t }
diag-not-a-whole-number-a94c = butun son emas
diag-write-df59 = { $number } yozing
diag-is-needed-this-number-has-a-f0fe = { $who }: kerakli qiymat: { $wanted }; bu son kasr qismga ega yoki juda katta
diag-write-one-value-for-both-directions-1e77 = ikkala yo‘nalish uchun bitta qiymat yoki {"{"} x = .., y = .. {"}"} yozing
diag-write-exactly-one-of-them-df4b = ulardan faqat bittasini yozing: {"{"} { $names } = .. {"}"}
diag-one-of-several-quantities-7ee2 = bir nechta kattalikdan bittasi
diag-wants-exactly-one-of-none-given-5b19 = { $who }: { $names } kalitlaridan faqat bittasi kerak; birortasi ham berilmagan
diag-wants-exactly-one-of-given-eadc = { $who }: { $names } kalitlaridan faqat bittasi kerak; berilganlari { $found } ta
diag-exactly-one-6b94 = faqat bittasi
diag-write-one-value-or-with-values-9303 = bitta qiymat yoki {"{"} from = .., to = .., points = .. {"}"} yozing, qiymatlar birliklari: { $examples }
diag-write-one-value-or-with-numbers-3184 = bitta qiymat yoki {"{"} from = .., to = .., points = .. {"}"} yozing, qiymatlar sonlar bo‘lsin
diag-a-range-f017 = oraliq
diag-a-range-is-points-may-be-3a42 = oraliq {"{"} from = .., to = .., points = .. {"}"} ko‘rinishida yoziladi; points yozilmasa ham bo‘ladi
diag-begins-and-ends-at-9f6a = { $who }: boshi va oxiri bir xil, { $from }
diag-empty-range-0d7b = bo‘sh oraliq
diag-from-and-to-must-differ-6d65 = from va to har xil bo‘lishi kerak
diag-a-finite-number-with-a-unit-65fb = birligi ko‘rsatilgan chekli son
diag-a-table-of-columns-f422 = ustunlar jadvali
diag-write-2117 = {"{"} { $names } {"}"} ko‘rinishida yozing
diag-has-no-column-40e2 = { $who }: { $name } ustuni yo‘q ({ $doc })
diag-is-missing-fa44 = { $name } = [..] yo‘q
diag-the-columns-differ-in-length-has-d5e8 = { $who }: ustunlar uzunligi har xil: { $first } ustunida { $n } ta qiymat, { $name } ustunida { $column } ta
diag-other-length-7560 = uzunligi boshqa
diag-has-no-columns-4cc3 = { $who }: ustunlar yo‘q
diag-empty-a649 = bo‘sh
diag-put-it-in-brackets-also-when-fec0 = bitta qiymat bo‘lsa ham, uni qavs ichiga yozing: [..]
diag-a-list-of-numbers-ae1f = sonlar ro‘yxati
diag-the-list-is-empty-168a = { $who }: ro‘yxat bo‘sh

## laval/src/file/reader.rs

diag-the-file-has-mb-at-most-251d = fayl hajmi { $size } MB; ko‘pi bilan 64 MB o‘qiladi
diag-tables-within-more-than-others-are-f2ff = { $most } tadan ko‘p jadval ichidagi jadvallar o‘qilmaydi
diag-nested-too-deeply-40e0 = ichma-ichlik juda chuqur
diag-the-file-is-no-text-byte-0366 = fayl matn emas: { $number }-bayt NUL (0x00), matnda bunday bayt bo‘lmaydi
diag-nul-402d = NUL
diag-save-it-as-utf-8-text-af88 = uni UTF-8 matni sifatida saqlang; bunday baytlar UTF-16 fayllarida va shikastlangan fayllarda uchraydi
diag-it-looks-like-utf-16-save-fb74 = bu UTF-16 kodlashiga o‘xshaydi; uni UTF-8 sifatida saqlang
diag-save-it-as-utf-8-often-3d66 = uni UTF-8 sifatida saqlang; ko‘pincha eski kodlashdagi µ yoki ° kabi birlik belgisi sabab bo‘ladi
diag-the-file-is-not-utf-8-a89f = fayl UTF-8 matni emas: { $number }-bayt 0x{ $byte }
diag-here-44f0 = shu yerda
diag-a-machine-is-an-object-with-b397 = mashina machine, part va study kalitlari bor obyekt bo‘lishi kerak; berilgani: { $shape }

## laval/src/file/references.rs

diag-the-name-of-a-body-2307 = jism nomi
diag-write-drum-or-4587 = "drum" yoki {"{"} body = "drum", at = "40 mm" {"}"} yozing
diag-must-be-a-body-the-ground-3c72 = { $who }: jism kerak; bu yerda "ground" mumkin emas
diag-the-name-of-a-body-is-95ae = { $who }: jism nomi yo‘q
diag-names-no-body-382f = { $who }: jism ko‘rsatilmagan
diag-body-is-missing-8cdf = body = .. yo‘q
diag-write-f6dd = {"{"} body = "drum", at = "40 mm" {"}"} ko‘rinishida yozing
diag-the-ground-has-no-position-42fd = { $who }: "ground" joylashuvga ega emas
diag-leave-this-out-139b = buni olib tashlang
diag-write-between-drum-base-one-of-ab81 = between = ["drum", "base"] ko‘rinishida yozing; ikkalasidan biri "ground" bo‘lishi mumkin
diag-a-list-of-two-points-271a = ikki nuqta ro‘yxati
diag-must-name-two-points-given-82c3 = { $who }: ikki nuqta kerak; berilganlari { $given } ta
diag-two-points-bc22 = ikki nuqta
diag-connects-with-itself-7d64 = { $who }: { $what } o‘zi bilan ulangan
diag-the-same-point-twice-e8b6 = bir nuqta ikki marta
diag-is-but-no-part-is-named-3d65 = { $who }: qiymati { $path }, lekin { $block } nomli qism yo‘q
diag-parts-of-this-file-001d = shu fayldagi qismlar: { $all }
diag-no-such-part-f861 = bunday qism yo‘q
diag-is-but-is-a-list-studies-307e = { $who }: qiymati { $path }, lekin "{ $name }" ro‘yxatdir: hisoblar uning qiymatlarini o‘zgartirmaydi
diag-studies-vary-single-numbers-parameters-of-2b8a = hisoblar yakka sonlarni o‘zgartiradi; { $kind } parametrlari: { $all }
diag-a-list-no-parameter-e77d = ro‘yxat, parametr emas
diag-names-the-part-and-none-of-5c03 = { $who }: { $block } qismi ko‘rsatilgan, uning parametri esa yo‘q
diag-is-but-a-has-no-parameter-d1e5 = { $who }: qiymati { $path }, lekin { $kind } turida { $rest } parametri yo‘q
diag-parameters-of-a-0768 = { $kind } parametrlari: { $all }
diag-no-such-parameter-4b6b = bunday parametr yo‘q
diag-write-0abe = {"{"} parameter = "part.parameter", from = .., to = .., points = .. {"}"} ko‘rinishida yozing
diag-the-range-of-a-parameter-5b06 = parametr oralig‘i
diag-names-no-parameter-1d76 = { $who }: parametr ko‘rsatilmagan
diag-parameter-is-missing-4f11 = parameter = .. yo‘q
diag-the-path-of-a-parameter-9555 = parametr yo‘li
diag-write-5182 = [{"{"} parameter = "part.parameter", from = .., to = .. {"}"}] ko‘rinishida yozing
diag-a-list-of-ranges-of-parameters-9cbf = parametrlar oraliqlari ro‘yxati
diag-names-twice-8475 = { $who }: { $path } ikki marta ko‘rsatilgan
diag-the-name-of-a-coordinate-6fbe = koordinata nomi
diag-the-name-of-a-coordinate-is-24bc = { $who }: koordinata nomi yo‘q
diag-write-it-as-in-drum-x-5010 = uni "drum.x" kabi yozing
diag-a-table-of-initial-values-4b73 = boshlang‘ich qiymatlar jadvali
diag-write-e21e = {"{"} "drum.x" = "1 mm", "drum.x'" = "0.1 m/s" {"}"} ko‘rinishida yozing

## laval/src/file/syntax.rs

diag-the-list-of-is-not-closed-7aa9 = { $key } ro‘yxati yopilmagan
diag-the-table-of-is-not-closed-f05f = { $key } jadvali yopilmagan
diag-is-missing-a1f6 = { $missing } yo‘q
diag-write-ab95 = { $line } yozing
diag-so-far-only-the-syntax-and-f296 = hozircha faqat sintaksis va yakka qiymatlar tekshirildi: qismlar va hisoblarning o‘zaro mosligi sintaksis to‘g‘ri bo‘lgandan keyin tekshiriladi
diag-this-line-holds-the-control-character-c33b = bu qatorda { $code } boshqaruv belgisi bor, matnda bunday belgi bo‘lmaydi
diag-remove-it-f612 = uni olib tashlang
diag-stands-twice-in-the-file-4a48 = { $body } faylda ikki marta uchraydi
diag-the-second-time-236c = ikkinchi marta
diag-write-one-block-or-double-brackets-7c6f = bitta blok yozing yoki bir nechtasi mumkin bo‘lgan joyda qo‘sh qavs ishlating: [[part]], [[study]]
diag-the-key-is-given-twice-in-59e4 = bir blokda { $word } kaliti ikki marta berilgan
diag-keep-one-of-the-two-a-15af = ikkalasidan bittasini qoldiring; keyingi qism o‘z [[part]] sarlavhasi bilan boshlanadi
diag-the-header-of-this-block-is-b840 = bu blok sarlavhasi to‘g‘ri yopilmagan
diag-brackets-91a2 = qavslar
diag-write-machine-c5b2 = [machine] yozing
diag-write-d669 = [[{ $word }]] yozing
diag-this-line-is-neither-a-block-beb3 = bu qator blok sarlavhasi ham, qiymatli kalit ham emas
diag-not-understood-f2b2 = tushunarsiz
diag-write-key-value-machine-part-or-0363 = key = value, [machine], [[part]] yoki [[study]] yozing; izoh # bilan boshlanadi
diag-the-value-of-is-missing-b5bb = { $key } qiymati yo‘q
diag-nothing-behind-02e0 = = belgisidan keyin hech narsa yo‘q
diag-write-8c88 = { $key } = ".." ko‘rinishida yozing
diag-cannot-be-a-key-1991 = { $key } kalit bo‘la olmaydi
diag-not-a-key-1e19 = kalit emas
diag-a-key-is-one-word-of-4542 = kalit harflar, raqamlar, _ va - belgilaridan tuzilgan bitta so‘zdir; key = value ko‘rinishida yozing
diag-a-quotation-mark-is-missing-in-97fa = { $key } qiymatida qo‘shtirnoq yetishmaydi
diag-not-closed-f52d = yopilmagan
diag-write-dea8 = to‘g‘ri yozilishi: { $key } = "{ $value }
diag-write-981e = to‘g‘ri yozilishi: { $key } = { $value }"
diag-texts-and-quantities-stand-between-two-eaf9 = matnlar va kattaliklar ikki qo‘shtirnoq orasida yoziladi
diag-a-brace-is-missing-in-the-f638 = { $key } qiymatida figurali qavs yetishmaydi
diag-must-match-94c5 = {"{"} va {"}"} soni mos kelishi kerak
diag-a-table-is-written-1c60 = jadval {"{"} x = "..", y = ".." {"}"} ko‘rinishida yoziladi
diag-a-bracket-is-missing-in-the-9d9f = { $key } qiymatida kvadrat qavs yetishmaydi
diag-and-must-match-d619 = ochuvchi va yopuvchi kvadrat qavslar soni mos kelishi kerak
diag-a-list-is-written-a8d4 = ro‘yxat ["..", ".."] ko‘rinishida yoziladi
diag-the-value-of-cannot-be-read-12c4 = { $key } qiymatini o‘qib bo‘lmaydi
diag-inside-lists-and-tables-too-texts-7ba8 = ro‘yxat va jadvallar ichida ham matnlar va kattaliklar qo‘shtirnoqda turadi, elementlar vergul bilan ajratiladi: {"{"} x = "1 mm", y = "2 mm" {"}"}
diag-the-value-of-must-stand-in-fc2a = { $key } qiymati qo‘shtirnoq ichida turishi kerak, chunki uning birligi bor
diag-quotes-are-missing-ee9e = qo‘shtirnoq yetishmaydi
diag-write-4a1c = { $key } = "{ $value }" ko‘rinishida yozing
diag-the-value-of-must-stand-in-d51a = { $key } qiymati qo‘shtirnoq ichida turishi kerak
diag-this-line-cannot-be-read-0302 = bu qatorni o‘qib bo‘lmaydi: { $why }

## laval/src/file/tree.rs

diag-a-number-d67a = son
diag-true-or-false-80f6 = true yoki false
diag-an-empty-list-4d93 = bo‘sh ro‘yxat
diag-a-list-4075 = ro‘yxat
diag-a-table-9be6 = jadval
diag-a-date-402c = sana
diag-null-3ca3 = null

## laval/src/file/values.rs

diag-unknown-unit-f106 = noma’lum birlik
diag-no-unit-2424 = birlik yo‘q
diag-wrong-dimension-b8aa = o‘lchamlik mos emas
diag-turns-or-radians-4d76 = aylanishmi yoki radianmi?
diag-no-number-15dc = son yo‘q
diag-a-pure-number-has-none-a311 = o‘lchamsiz sonning birligi bo‘lmaydi
diag-is-given-in-2983 = { $quantity }: birliklari { $examples }
diag-is-needed-not-f6c2 = { $who }: kerakli qiymat: { $wanted }; berilgani: { $shape }
diag-allowed-here-b4fe = bu yerda mumkin: { $all }
diag-put-it-in-quotes-8ea7 = uni qo‘shtirnoq ichiga oling
diag-a-word-8144 = so‘z
diag-write-one-of-91bc = quyidagilardan birini yozing: { $all }
diag-cannot-be-e72c = { $who }: qiymat { $t } bo‘la olmaydi
diag-did-you-mean-choose-eeac = balki { $near } demoqchi bo‘lgandirsiz? Tanlang: { $all }
diag-choose-c55d = tanlang: { $all }
diag-not-one-of-its-words-2a4f = ruxsat etilgan so‘zlardan emas
diag-write-true-or-false-without-quotes-cb7a = true yoki false qiymatini qo‘shtirnoqsiz yozing

## laval-model/src/diagnostic.rs

diag-it-cannot-be-assembled-8afc = uni yig‘ib bo‘lmaydi

## laval-model/src/model/field.rs

diag-above-0-26cb = 0 dan katta
diag-above-5980 = { $least } qiymatidan katta
diag-0-or-more-6fec = 0 yoki undan katta
diag-at-least-c24a = kamida { $least }
diag-finite-511b = chekli
diag-at-most-0c11 = ko‘pi bilan { $most }
diag-between-and-c753 = { $least } – { $most } oralig‘ida
diag-between-0-and-9eeb = 0 – { $most } oralig‘ida
diag-and-at-most-cc06 = { $least } va ko‘pi bilan { $most }

## laval-model/src/model/inertia.rs

diag-and-no-inertia-is-left-for-2cc3 = "{ $slot }" qismi: { $what }, { $name } uchun inersiya qolmaydi

## laval-model/src/model/params.rs

diag-is-missing-3e54 = { $name } berilmagan
diag-is-it-must-be-2e8e = { $name }: qiymati { $value }; talab: { $wanted }

## laval-model/src/model/system.rs

diag-the-machine-has-no-body-that-7801 = mashinada harakatlana oladigan jism yo‘q
diag-add-a-part-such-as-a-ab6a = disk kabi qism qo‘shing: kind = "disc" va massasi bor [[part]]
diag-two-parts-are-named-638c = ikkita qismning nomi bir xil: "{ $name }"
diag-give-each-part-its-own-name-aa86 = har bir qismga alohida nom bering
diag-part-takes-parameters-b0e6 = "{ $name }" qismining parametrlari soni { $slots } ta
diag-is-attached-to-which-does-not-caff = "{ $slot }" qismi biriktirilgan "{ $name }" jismi mavjud emas
diag-bodies-of-this-machine-ground-e4bc = bu mashinaning jismlari: { $bodies }, ground
diag-is-attached-to-which-is-not-24c5 = "{ $slot }" qismi biriktirilgan "{ $name }" jism emas
diag-joins-a-point-to-itself-4999 = "{ $name }" qismi bir nuqtani o‘zi bilan ulaydi
diag-parts-of-this-machine-eb3a = bu mashinaning qismlari: { $names }
diag-what-a-file-says-in-another-eeb2 = faylda boshqa shaklda berilgan kattalik, masalan hajm bilan berilgan to‘ldirish, o‘zi ifodalaydigan parametr orqali o‘zgartiriladi
diag-parameters-of-7bbb = "{ $part }" qismining parametrlari: { $near } ({ $other })
diag-is-no-parameter-is-a-list-51d9 = "{ $path }" parametr emas: "{ $name }" ro‘yxatdir, hisoblar uning qiymatlarini o‘zgartirmaydi
diag-there-is-no-parameter-e472 = "{ $path }" parametri yo‘q

## laval-model/src/model/timed.rs

diag-has-no-form-in-the-time-79ba = "{ $name }" qismining vaqt sohasidagi shakli yo‘q: { $why }
diag-use-a-study-in-the-frequency-2f24 = chastota sohasidagi hisobdan foydalaning, masalan forced_response

## laval-model/src/numerics.rs

diag-the-table-has-no-rows-b81e = jadvalda qator yo‘q
diag-the-columns-have-and-rows-7e32 = ustunlardagi qatorlar soni har xil: { $x } va { $y }
diag-row-holds-a-number-that-is-048f = { $row }-qatordagi son chekli emas
diag-the-argument-in-row-is-not-f142 = { $row }-qatordagi argument oldingisidan katta emas
diag-singular-matrix-no-pivot-in-column-de5d = matritsa singulyar ({ $column }-ustunda yetakchi element yo‘q)
diag-a-matrix-of-the-eigenvalue-problem-a9ba = xos qiymatlar masalasining matritsasida chekli bo‘lmagan element bor
diag-the-eigenvalue-iteration-did-not-converge-94cd = xos qiymatlar iteratsiyasi yaqinlashmadi
diag-every-number-is-an-eigenvalue-the-489e = har qanday son xos qiymat bo‘ladi: determinant aynan nolga teng
diag-the-equations-are-not-defined-here-d632 = tenglamalar bu yerda aniqlanmagan: { $why }
diag-cancelled-7c41 = bekor qilindi

## laval-model/src/parts/balancer_ball/mod.rs

diag-a-track-has-balls-d20f = yo‘lakdagi sharchalar soni: { $n }
diag-give-a-whole-number-of-balls-054f = har bir yo‘lakka sharchalar sonini butun son bilan bering, kamida 1 ta
diag-the-tracks-have-more-than-balls-1d9d = yo‘laklardagi sharchalarning jami { $most } tadan ko‘p
diag-give-fewer-balls-6bc4 = sharchalar sonini kamaytiring
diag-a-track-has-times-the-radius-4cd8 = yo‘lak radiusiga nisbat { $r } deb berilgan
diag-radius-is-a-positive-ratio-to-18f8 = radius qiymati track_radius qiymatiga musbat nisbatdir
diag-a-track-is-tilted-by-more-dbfd = yo‘lakning og‘ish burchagi 1.5 rad qiymatidan katta
diag-tilt-is-in-addition-to-that-0d1b = tilt balansirning og‘ish burchagiga qo‘shiladi
diag-balls-is-the-number-on-all-f8b1 = balls barcha yo‘laklardagi sharchalarning umumiy sonidir; uni olib tashlang, har bir yo‘lakdagi sonni tracks beradi
diag-balls-and-the-tracks-have-75ed = balls = { $n }, yo‘laklarda esa { $each } = { $all } ta
diag-mass-ratios-are-given-for-balls-a4df = { $balls } ta sharcha uchun { $given } ta massa nisbati berilgan
diag-mass-ratios-are-given-for-balls-4735 = { $tracks } ta yo‘lakdagi { $balls } ta sharcha uchun { $given } ta massa nisbati berilgan
diag-one-ratio-for-each-ball-track-9a94 = har bir sharcha uchun bitta nisbat, yo‘lakma-yo‘lak
diag-the-tilt-of-the-tracks-locks-0ce0 = yo‘laklar og‘ishi sharchalarni tugunlar chizig‘ida ushlab qoladi: r sin^2(tilt) = { $locking }, u halqa ekssentrisitetining o‘ndan biridan ({ $tenth }) kichik bo‘lishi kerak
diag-a-free-ring-needs-inertia-about-cb88 = erkin halqaga tugunlar chizig‘i atrofidagi inersiya kerak: diametral_inertia bering
diag-no-ring-has-a-polar-inertia-5c83 = halqaning qutbiy inersiyasi ({ $polar_inertia }) diametral inersiyasining ({ $diametral_inertia }) ikki barobaridan katta bo‘la olmaydi; yupqa halqada u aniq ikki barobar
diag-acts-on-free-rings-and-these-e719 = { $field } erkin halqalarga ta’sir qiladi, bu halqalar esa mahkamlangan: rings = "free" ham bering
diag-the-ring-centre-from-the-shaft-43cc = halqa markazi (valdan { $s } masofada) yo‘lakdan (radiusi { $r }) tashqarida
diag-balls-do-not-fit-on-track-6b52 = { $number }-yo‘lakka { $n } ta sharcha sig‘maydi: joy { $fits } ta sharcha uchun yetadi
diag-balls-that-touch-and-balls-that-edac = sharchalari bir-biriga tegadigan va tegmaydigan mashinalar har xil: har birini alohida tuzing
diag-balls-that-touch-need-their-size-32af = bir-biriga tegadigan sharchalarning o‘lchami kerak: ball_radius bering
diag-weight-acts-across-a-horizontal-axis-910f = og‘irlik kuchi gorizontal o‘qqa ko‘ndalang ta’sir qiladi, o‘q bo‘ylab emas: gravity = 0 bering (o‘qqa ko‘ndalang og‘irlik kuchi mashinadan ma’lum)

## laval-model/src/parts/bearing_cubic.rs

diag-the-force-no-longer-restores-beyond-d9b0 = deformatsiya { $d } qiymatidan oshganda kuch tiklovchi bo‘lmay qoladi: u itaradi
diag-valid-to-the-deflection-the-law-7022 = valid_to, kuch qonuni o‘rinli bo‘lgan deformatsiya
diag-softens-c1a5 = yumshaydi
diag-this-is-below-check-sign-and-761b = bu { $place } qiymatidan kichik; ishorasini va birligini (N/m^3) tekshiring yoki qonun oralig‘ini valid_to bilan bering
diag-give-one-value-or-use-law-a1f9 = bitta qiymat bering yoki law = "per_axis" ishlating

## laval-model/src/parts/bearing_hertz.rs

diag-a-radial-law-has-no-preload-346e = radial qonunda dastlabki taranglik yo‘q: tirqish manfiy bo‘la olmaydi
diag-use-law-per-axis-where-a-ac72 = law = "per_axis" ishlating, unda manfiy tirqish qarama-qarshi kontaktlarning tarangligini bildiradi
diag-a-hertz-contact-without-preload-has-e0b4 = dastlabki taranglik bo‘lmasa, Hertz kontaktining tinch holatda bikrligi yo‘q: chiziqlantirish amplitudasini bering (garmonik hisob uni o‘zi beradi), dastlabki taranglik bering (law = "per_axis" va manfiy tirqish) yoki kerakli amplitudalarga moslangan bearing_cubic ishlating

## laval-model/src/parts/bearing_linear/mod.rs

diag-a-table-over-speed-has-at-7512 = tezlik bo‘yicha jadvalda kamida ikki qator bo‘ladi; bitta tezlik uchun koeffitsiyentlarning o‘zini bering
diag-speeds-must-increase-from-row-to-61ab = tezliklar qatordan qatorga ortishi kerak: { $number }-qatorda { $speed }, undan oldin { $before }
diag-column-speed-e6ee = speed ustuni: { $why }
diag-column-has-rows-and-column-speed-849d = { $name } ustunida { $values } ta qator, speed ustunida { $speed } ta qator bor
diag-column-row-is-not-a-finite-b5da = { $name } ustuni: { $number }-qatordagi qiymat chekli son emas
diag-frequencies-of-vibration-are-not-negative-43a1 = tebranish chastotalari manfiy bo‘lmaydi: { $number }-qatorda { $frequency } berilgan
diag-a-table-over-speed-and-frequency-ef2a = tezlik va tebranish chastotasi bo‘yicha jadvalda kamida ikki chastota bo‘ladi; koeffitsiyentlar unga bog‘liq bo‘lmasa, frequency ustunini olib tashlang
diag-a-table-over-speed-and-frequency-9644 = tezlik va tebranish chastotasi bo‘yicha jadvalda kamida ikki tezlik bo‘ladi
diag-rows-and-are-of-one-speed-2741 = { $first } va { $second }-qatorlar bitta tezlik va chastotaga tegishli: { $speed } va { $frequency }
diag-every-speed-of-the-table-has-5ca8 = jadvalning har bir tezligida barcha chastotalar bo‘ladi, jami { $all } qator: { $frequency } chastotadagi { $speed } qatori yo‘q
diag-every-speed-of-the-table-has-b24d = jadvalning har bir tezligida barcha chastotalar bo‘ladi, jami { $all } qator: { $count } qator yetishmaydi, birinchisi { $frequency } chastotadagi { $speed }
diag-is-given-beside-bb0c = { $short } kaliti { $twice } bilan birga berilgan
diag-stands-for-and-give-the-one-5d24 = { $short } kaliti { $first } va { $second } o‘rnida turadi: yo bitta qiymatni, yo shu ikkitasini bering
diag-the-bearing-has-no-coefficient-all-9c73 = podshipnikning koeffitsiyenti yo‘q: sakkiztasi ham nol
diag-give-stiffness-or-kxx-and-kyy-27b3 = stiffness yoki kxx va kyy (hamda boshqa koeffitsiyentlarini) yoki tezlik bo‘yicha jadval bering
diag-beyond-is-given-without-a-table-38bd = beyond jadvalsiz berilgan
diag-constant-coefficients-hold-at-every-speed-c9f6 = o‘zgarmas koeffitsiyentlar har qanday tezlikda o‘rinli: beyond kalitini olib tashlang yoki tezlik bo‘yicha jadval bering
diag-is-given-as-a-constant-beside-d5bb = { $name } o‘zgarmas qiymat sifatida jadval bilan birga berilgan
diag-a-bearing-has-constant-coefficients-or-463b = podshipnikda yo o‘zgarmas koeffitsiyentlar, yo jadval bo‘ladi: o‘zgarmas qiymatlarni jadvalga teng qatorlar qilib kiriting
diag-the-coefficients-come-from-the-table-544d = koeffitsiyentlar jadvaldan olinadi: uning yonidagi o‘zgarmas qiymat ta’sir qilmaydi

## laval-model/src/parts/damper.rs

diag-rotating-damping-must-be-the-same-4a19 = aylanuvchi so‘ndirish x va y bo‘yicha bir xil bo‘lishi kerak
diag-different-values-in-rotating-axes-would-4b5b = aylanuvchi o‘qlardagi har xil qiymatlar mashina tenglamalarini vaqt bo‘yicha davriy qilar edi
diag-this-damper-was-built-without-tilt-db59 = bu damper og‘ishsiz tuzilgan

## laval-model/src/parts/disc.rs

diag-an-unbalance-of-a669 = disbalans { $u } deb berilgan
diag-sizes-are-positive-phase-180-deg-1024 = kattaliklar musbat bo‘ladi; phase = "180 deg" disbalansni qarama-qarshi tomonga buradi
diag-an-unbalance-has-no-place-4d16 = disbalansning joyi yo‘q
diag-phase-is-an-angle-up-to-6ebd = phase ko‘pi bilan 1000 rad burchak, balandlik ko‘pi bilan 100 m
diag-the-height-of-an-unbalance-acts-aa0a = disbalans balandligi og‘ishga ta’sir qiladi, bu disk esa og‘maydi
diag-give-diametral-inertia-as-well-or-5350 = diametral_inertia ham bering yoki at kalitini olib tashlang
diag-no-body-has-a-polar-inertia-d7e0 = jismning qutbiy inersiyasi ({ $polar_inertia }) diametral inersiyasining ({ $diametral_inertia }) ikki barobaridan katta bo‘la olmaydi; yupqa diskda u aniq ikki barobar
diag-acts-on-the-tilt-and-this-25d2 = { $field } og‘ishga ta’sir qiladi, bu disk esa og‘maydi: diametral_inertia ham bering

## laval-model/src/parts/liquid/check.rs

diag-the-free-surface-radius-lies-outside-6f91 = erkin sirt (radiusi { $value }) bo‘shliqdan (radiusi { $radius }) tashqarida
diag-an-empty-a-partly-filled-and-0108 = bo‘sh, qisman to‘ldirilgan va to‘la bo‘shliqlar har xil mashinalardir: har birini alohida tuzing
diag-planar-knows-no-tilt-of-the-902a = planar bo‘shliqning og‘ishini hisobga olmaydi: qiyshiq bo‘shliq uchun model = "strip" yoki "spatial" bering
diag-a-liquid-with-viscosity-and-one-e51c = qovushqoqligi bor va qovushqoqligi yo‘q suyuqlik har xil mashinalardir: har birini alohida tuzing
diag-this-model-knows-no-viscosity-planar-a984 = bu model qovushqoqlikni hisobga olmaydi: uni planar, strip va spatial hisobga oladi
diag-a-full-cavity-with-viscosity-is-2bad = qovushqoq suyuqlik bilan to‘la bo‘shliq uchun model yo‘q: viscosity kalitini olib tashlang yoki biroz havo qoldiring
diag-the-viscosity-damps-the-wave-by-4b0e = qovushqoqlik to‘lqinni o‘zi so‘ndiradi: ikkalasidan birini bering
diag-this-model-knows-no-wave-damping-8681 = bu modelda wave_damping yo‘q: spatial uchun viscosity beriladi

## laval-model/src/parts/liquid/mod.rs

diag-the-free-surface-is-the-inner-bfe9 = erkin sirt devordagi qatlamning ichki sirtidir: 0 to‘la, bo‘shliq radiusi bo‘sh holatni bildiradi
diag-this-is-times-what-the-cavity-e6e6 = bu bo‘shliq sig‘imining { $fraction } barobari
diag-the-cavity-holds-of-this-liquid-6415 = bo‘shliqqa { $cavity }, ya’ni bu suyuqlikdan { $density } sig‘adi
diag-only-odd-harmonics-act-on-a-e4ca = og‘ishga faqat toq garmonikalar ta’sir qiladi, oxirgisi toq bo‘lishi kerak
diag-give-axial-harmonics-or-dfc4 = axial_harmonics = { $less } yoki { $more } bering
diag-has-no-axial-harmonics-9a50 = { $word } modelida o‘q bo‘yicha garmonikalar yo‘q
diag-model-spatial-has-them-leave-axial-677f = ular model = "spatial" uchun mavjud; boshqa hollarda axial_harmonics kalitini olib tashlang
diag-without-viscosity-is-exact-in-time-1ca0 = { $word } modeli qovushqoqliksiz vaqt sohasida aniq
diag-leave-time-error-out-with-model-2e83 = time_error kalitini olib tashlang; model = "spatial" bo‘lganda yoki qovushqoqlik berilganda u to‘lqinlar sonini belgilaydi
diag-planar-tilt-takes-from-the-tilt-aab4 = planar_tilt bunday balandlikdagi bo‘shliqning og‘ish inersiyasidan { $taken } ayiradi: strip va spatial ayirmaydi
diag-give-model-strip-or-spatial-or-9e71 = model = "strip" yoki "spatial" bering; yoki jismning diametral_inertia qiymatini oshiring

## laval-model/src/parts/liquid/timed.rs

diag-its-waves-are-computed-up-to-7190 = uning to‘lqinlari ko‘pi bilan axial_harmonics = { $most } uchun hisoblanadi; hammasini hisobga olish uchun axial_harmonics kalitini olib tashlang
diag-waves-d3ee = { $n } ta to‘lqin
diag-that-of-a-cavity-that-is-b496 = valga nisbatan qiyshiq bo‘shliqning shakli faqat o‘zgarmas tezlikda o‘rinli
diag-the-layer-of-a-viscous-liquid-2e6d = qovushqoq suyuqlik qatlami tezlikka bog‘liq, shuning uchun uning shakli bitta tezlik uchun tuziladi; transient va basins bitta tezlikda bajariladi
diag-the-layer-of-a-viscous-liquid-1419 = qovushqoq suyuqlik qatlami tezlikka bog‘liq, shuning uchun uning shakli faqat o‘zgarmas tezlikda o‘rinli
diag-do-not-give-its-reaction-with-e64e = { $most } uning reaksiyasini { $allowed } nisbiy xato bilan bera olmaydi; time_error qiymatini oshiring
diag-without-spin-nothing-holds-the-layer-f2d3 = aylanishsiz qatlamni devorda hech narsa ushlab turmaydi
diag-give-the-study-a-speed-above-e978 = hisobga 0 dan katta tezlik bering; aylanmaydigan mashinada qovushqoqliksiz model = "frozen" suyuqlikni massa deb hisoblaydi
diag-try-time-error-64e7 = time_error = { $reached } qiymatini sinab ko‘ring
diag-allow-a-larger-time-error-b71c = time_error qiymatini oshiring
diag-do-not-give-its-reaction-on-8989 = { $most } uning { $of } bo‘yicha reaksiyasini { $allowed } nisbiy xato bilan bera olmaydi; { $larger }{ $strip }
diag-its-reaction-on-cannot-be-computed-87db = uning { $of } bo‘yicha reaksiyasini tezlikning to‘rt barobarigacha bo‘lgan barcha harakatlar uchun ruxsat etilgan { $allowed } xatoning o‘ndan biri aniqligida hisoblab bo‘lmaydi{ $strip }
diag-finding-the-form-of-its-reaction-e706 = uning { $of } bo‘yicha reaksiyasi shaklini topish juda ko‘p hisoblash talab qiladi; time_error qiymatini oshiring{ $strip }
diag-displacement-4336 = siljish
diag-poles-23e2 = { $n } ta qutb
diag-tilt-023c = og‘ish
diag-or-model-strip-9bf1 = , yoki model = "strip" bering
diag-its-form-in-the-time-domain-7c9b = uning vaqt sohasidagi shakli boshqa bo‘shliq uchun tuzilgan; bu yerda o‘lchamini va to‘ldirilishini o‘zgartirib bo‘lmaydi

## laval-model/src/parts/motor.rs

diag-a-motor-with-curve-needs-2cf6 = curve = "{ $word }" bo‘lgan dvigatelga { $name } kerak
diag-add-10f4 = { $name } qo‘shing
diag-a-motor-with-curve-table-needs-b9a6 = curve = "table" bo‘lgan dvigatelga jadval kerak
diag-add-table-43fb = table = {"{"} speed = [..], share = [..] {"}"} qo‘shing
diag-the-torque-cannot-be-interpolated-7b6d = momentni interpolyatsiya qilib bo‘lmaydi: { $why }
diag-speeds-must-increase-from-row-to-ac99 = tezliklar qatordan qatorga ortishi kerak
diag-a-table-is-given-beside-curve-91c7 = jadval curve = "{ $word }" bilan birga berilgan
diag-say-curve-table-or-take-the-6386 = curve = "table" bering yoki jadvalni olib tashlang
diag-the-torque-curve-needs-a-synchronous-b5c7 = moment egri chizig‘iga 0 dan katta synchronous_speed kerak
diag-limited-power-needs-a-torque-and-2f00 = cheklangan quvvat uchun 0 dan katta moment va quvvat kerak

## laval-model/src/parts/shaft_lumped.rs

diag-is-given-without-a-diameter-3d73 = { $name } kaliti diameter kalitisiz berilgan
diag-a-round-shaft-takes-diameter-below-a7a1 = doiraviy valga diameter hamda below, above yoki ikkalasi beriladi; bikrligi berilgan valga bularning birortasi ham berilmaydi
diag-the-shaft-has-no-stiffness-13d9 = valning bikrligi yo‘q
diag-give-stiffness-or-the-diameter-of-f6c0 = stiffness bering yoki doiraviy valning diameter qiymatini va nuqtadan pastki yoki yuqorigi uzunligini bering
diag-a-shaft-with-material-damping-must-c344 = materialida so‘ndirish bor valning bikrligi x va y bo‘yicha bir xil bo‘lishi kerak
diag-unequal-stiffness-in-fixed-axes-is-1ae5 = qo‘zg‘almas o‘qlarda teng bo‘lmagan bikrlik aylanmaydigan tayanchni bildiradi: yoniga damper qismini qo‘shing
diag-cross-stiffness-is-at-most-sqrt-01fb = cross_stiffness ko‘pi bilan sqrt(kx ky) = { $limit }: undan kattasi tashqariga itaradi
diag-coupling-is-at-most-sqrt-stiffness-3fd0 = coupling ko‘pi bilan sqrt(stiffness tilt_stiffness) = { $limit }: undan kattasi egilganda energiya beradi (qattiq mahkamlangan valda shu qiymatning 0.87 qismi)
diag-this-shaft-was-built-without-tilt-fed7 = bu val og‘ishsiz tuzilgan
diag-this-shaft-was-built-without-material-7603 = bu val materialidagi so‘ndirishsiz tuzilgan
diag-this-shaft-was-built-from-its-1847 = bu val bikrligi bo‘yicha tuzilgan
diag-is-given-beside-the-diameter-of-1b3b = { $name } doiraviy valning diameter qiymati bilan birga berilgan
diag-the-stiffness-follows-from-the-geometry-5348 = bikrlik geometriyadan kelib chiqadi: ulardan birini olib tashlang
diag-is-given-without-the-length-5c8d = { $end } kaliti { $length } uzunligisiz berilgan
diag-give-as-well-or-take-away-4a55 = { $length } ham bering yoki { $end } kalitini olib tashlang
diag-a-round-shaft-needs-a-length-8bde = doiraviy valga uzunlik kerak
diag-give-below-the-length-from-its-37dc = below (pastki uchidan nuqtagacha uzunlik), above yoki ikkalasini bering
diag-inner-diameter-is-less-than-diameter-22f4 = inner_diameter qiymati diameter qiymatidan kichik bo‘ladi
diag-is-at-least-0bb6 = { $name } kamida { $value }
diag-this-shaft-was-built-without-bd20 = bu val { $name } kalitisiz tuzilgan
diag-a-shaft-pinned-at-its-only-7de2 = yagona uchi sharnirli val hech narsani ushlab turmaydi: uni qattiq mahkamlang yoki ikkinchi uchini bering
diag-the-stiffness-of-this-shaft-follows-b189 = bu valning bikrligi geometriyasidan kelib chiqadi

## laval-model/src/parts/shaft_viscoelastic/mod.rs

diag-the-material-creeps-without-bound-in-8145 = material cheksiz oquvchan: uzoq muddatda bikrligining 1 - K(0) = { $kept } qismi qoladi, bu 0 dan katta bo‘lishi kerak; bu yadro amplitudasining { $share } qismidan pastda yaroqli
diag-give-amplitude-exponent-and-decay-of-e770 = bitta kuchsiz singulyar had uchun amplitude, exponent va decay bering yoki bir nechta had (terms), yoki eksponentalar (exponentials) bering
diag-the-memory-of-the-material-is-3490 = material xotirasi ikki marta berilgan: { $first } yonida { $second }
diag-columns-share-and-rate-need-equally-dc8a = share va rate ustunlarida qatorlar soni teng bo‘lishi kerak, kamida bitta
diag-row-a-share-is-not-negative-fdba = { $row }-qator: share manfiy bo‘lmaydi, rate 0 va 1e12 1/s orasida yotadi
diag-the-memory-of-the-material-is-6cac = material xotirasi berilmagan
diag-the-kernel-a-t-a-1-3db1 = A t^(a-1) exp(-b t) yadrosiga { $given } yonida { $missing } ham kerak
diag-columns-amplitude-exponent-and-decay-need-7b2b = amplitude, exponent va decay ustunlarida qatorlar soni teng bo‘lishi kerak, kamida bitta
diag-row-of-the-terms-is-no-14f0 = hadlarning { $number }-qatori yadro emas: amplitude 0 yoki undan katta, exponent 0 dan katta va ko‘pi bilan 0.99, decay 0 dan katta bo‘ladi
diag-lower-the-amplitude-or-raise-the-adb9 = amplitude qiymatini kamaytiring yoki decay qiymatini oshiring: sekin so‘nuvchi yadro ko‘proq relaksatsiya beradi
diag-more-than-exponentials-would-be-needed-ac2b = bu yadro, aniqlik va vaqt oralig‘i uchun { $most } tadan ko‘p eksponenta kerak bo‘lar edi
diag-request-less-accuracy-a-narrower-band-022e = aniqlik talabini yumshating, oraliqni toraytiring yoki tezroq so‘nish (decay) bering
diag-the-shaft-has-no-stiffness-give-ad68 = valning bikrligi yo‘q: uni bering yoki supports bilan doiraviy val qanday mahkamlanganini ko‘rsating
diag-supports-needs-the-of-the-shaft-8082 = supports = "{ $word }" uchun valning { $name } qiymati kerak
diag-has-no-effect-with-supports-6287 = supports = "{ $word }" bo‘lganda { $name } ta’sir qilmaydi
diag-the-disc-at-is-not-between-4718 = { $x } joyidagi disk oralig‘i { $l } bo‘lgan tayanchlar orasida emas
diag-the-exponentials-were-chosen-for-another-1eef = eksponentalar boshqa yadro uchun tanlangan, bu yadroda ularning xatosi belgilangan aniqlikdan katta: mashinani shu yadro bilan tuzing yoki band oralig‘ini kengaytiring
diag-amplitude-exponent-and-decay-have-no-58ce = bir nechta had berilganda amplitude, exponent va decay ta’sir qilmaydi
diag-amplitude-exponent-and-decay-have-no-4e1d = exponentials berilganda amplitude, exponent va decay ta’sir qilmaydi

## laval-model/src/parts/spin_load.rs

diag-this-part-does-nothing-give-inertia-1f62 = bu qism hech narsa bajarmaydi: inertia, drag yoki windage bering

## laval-model/src/units/mod.rs

diag-is-needed-and-has-no-unit-a022 = kerakli qiymat: { $wanted }; { $digits } sonining birligi yo‘q
diag-write-the-unit-behind-the-number-6a68 = sondan keyin birligini yozing ({ $examples }); qo‘shtirnoqsiz son { $expected } birligida olinadi
diag-a-pure-number-0885 = o‘lchamsiz son
diag-is-needed-is-f561 = kerakli qiymat: { $need } ({ $ex }); { $text } esa: { $is }
diag-is-needed-leaves-open-whether-turns-c66a = kerakli qiymat: { $need } ({ $ex }); { $text } aylanishni yoki radianni bildirishi noaniq
diag-for-turns-write-rpm-hz-or-aed2 = aylanishlar uchun rpm, Hz yoki rev; radianlar uchun rad yozing
diag-is-needed-is-a-torque-9c88 = kerakli qiymat: { $need } ({ $ex }); { $text } esa moment
diag-is-needed-is-an-energy-4e75 = kerakli qiymat: { $need } ({ $ex }); { $text } esa energiya

## laval-model/src/units/parse.rs

diag-this-is-not-a-number-3ddb = bu son emas
diag-the-number-is-too-large-d1af = son juda katta
diag-the-number-is-too-small-to-26fc = son juda kichik, uni 0 dan farqlab bo‘lmaydi
diag-a-finite-number-is-needed-not-7676 = chekli son kerak; berilgani: { $head }
diag-this-text-is-empty-267d = bu matn bo‘sh
diag-begins-with-no-number-ac94 = { $text } son bilan boshlanmaydi
diag-a-quantity-is-a-number-and-9dba = kattalik son va birlikdan iborat; { $what }
diag-write-it-as-in-70-mm-3a41 = "70 mm" kabi yozing
diag-has-a-comma-in-its-number-f608 = { $text } sonida vergul bor
diag-write-the-decimal-point-as-in-e955 = o‘nli nuqta yozing, masalan "1.5 mm", ajratgichlarsiz
diag-has-a-space-inside-its-number-6e0d = { $text } sonining ichida bo‘sh joy bor
diag-write-the-digits-together-as-in-4256 = raqamlarni qo‘shib yozing, masalan "3000 rpm"
diag-writes-a-power-of-ten-in-9497 = { $text } matnida o‘nning darajasi so‘z bilan yozilgan
diag-write-it-as-in-1-1e7-c4a9 = "1.1e7 N/m" kabi yozing
diag-has-two-decimal-points-edcf = { $text } sonida ikkita o‘nli nuqta bor
diag-write-the-number-as-in-1-bee8 = sonni "1.5 mm" kabi, ajratgichlarsiz yozing
diag-is-too-long-for-a-unit-846f = { $text } birlik uchun juda uzun
diag-does-not-belong-in-a-unit-043f = { $text } birlikda bo‘lmaydi
diag-a-temperature-in-degc-stands-alone-276c = degC birligidagi harorat alohida turadi
diag-for-differences-and-in-products-write-9698 = farqlar va ko‘paytmalar uchun K yozing
diag-this-unit-is-out-of-all-3847 = bu birlik barcha chegaralardan tashqarida
diag-a-unit-cannot-begin-with-a-1143 = birlik ko‘paytirish belgisi bilan boshlana olmaydi
diag-has-two-readings-is-what-follows-4dcc = { $whole } ikki xil o‘qiladi: / va bo‘sh joydan keyingi qism suratdami yoki maxrajdami?
diag-put-products-below-a-in-parentheses-42fc = / belgisidan keyingi ko‘paytmani qavsga oling, masalan N/(m s), yoki ko‘paytmani oldin yozing, masalan N s/m
diag-too-many-parentheses-45b6 = qavslar juda ko‘p
diag-a-closing-parenthesis-is-missing-6a33 = yopuvchi qavs yetishmaydi
diag-nothing-fcf7 = hech narsa
diag-a-unit-is-expected-here-not-6ef4 = bu yerda birlik kutiladi; berilgani: { $what }
diag-is-not-a-known-unit-cbb5 = { $word } ma’lum birlik emas
diag-a-closing-parenthesis-is-missing-in-1333 = darajada yopuvchi qavs yetishmaydi
diag-this-power-is-not-between-20-2848 = bu daraja -20 va 20 orasida emas yoki 0 ga teng
diag-a-power-is-a-number-as-f8ee = daraja son bo‘ladi, masalan m^2, m^1.5 yoki m^(10/9)

## laval-model/src/units/table.rs

diag-a-quantity-in-af40 = { $unit } birligidagi kattalik

## laval-model/src/parts/bearing_cubic.rs

diag-an-isotropic-law-has-the-same-6751 = izotrop qonunda { $field } x va y bo‘yicha bir xil

## laval-cli/src/check.rs

diag-ok-de5c = xato yo‘q: { $machine }
diag-part-193f = { $n } ta qism
diag-parts-799d = { $n } ta qism
diag-coordinate-a21a = { $n } ta koordinata
diag-coordinates-ea2c = { $n } ta koordinata
diag-internal-state-da0f = { $n } ta ichki holat
diag-internal-states-7af1 = { $n } ta ichki holat
diag-no-studies-e162 = hisoblar yo‘q

## laval-cli/src/input.rs

diag-is-a-folder-not-a-machine-7bfd = { $path } mashina fayli emas, papkadir
diag-give-the-file-20d8 = faylni ko‘rsating: { $inside }
diag-is-larger-than-64-mb-6cae = { $path } fayli 64 MB chegarasidan katta
diag-there-is-no-file-33b6 = { $path } fayli yo‘q
diag-laval-new-writes-a-machine-file-4dc1 = boshlash uchun mashina faylini laval new buyrug‘i yozadi

## laval-cli/src/lib.rs

diag-laval-this-is-a-defect-of-ae66 = laval: bu sizning faylingizdagi emas, dasturdagi nuqsondir. Uni mashina fayli va yuqoridagi xabar bilan birga bildiring

## laval-cli/src/new.rs

diag-templates-877f = shablonlar: { $all }
diag-there-is-no-template-a3c1 = { $word } shabloni yo‘q
diag-exists-and-is-not-overwritten-c379 = { $path } fayli mavjud, uning ustidan yozilmaydi
diag-name-another-file-with-out-8c40 = --out bilan boshqa fayl ko‘rsating

## laval-cli/src/pdf.rs

diag-no-chromium-was-found-to-print-c305 = hisobotni chop etish uchun Chromium topilmadi
diag-install-one-of-or-open-in-6eb6 = quyidagilardan birini o‘rnating: { $names }; yoki { $page } sahifasini brauzerda ochib, chop eting
diag-could-not-print-the-report-90eb = { $browser } hisobotni chop eta olmadi: { $why }

## laval-cli/src/progress.rs

diag-done-a112 = { $percent } % bajarildi
diag-1-step-done-2d12 = 1 qadam bajarildi
diag-steps-done-0233 = { $steps } ta qadam bajarildi
diag-about-left-b4f4 = { $done }, taxminan { $left } qoldi
diag-computing-for-ab42 = hisoblanmoqda, { $time } o‘tdi
diag-after-7501 = { $done }, { $time } o‘tdi
diag-s-b884 = { $n } s
diag-min-4434 = { $n } min
diag-h-76f9 = { $n } soat
diag-days-910f = { $n } kun

## laval-cli/src/run.rs

diag-contains-no-study-e25a = { $file } faylida hisob yo‘q
diag-add-a-study-block-laval-studies-c25e = [[study]] bloki qo‘shing; turlarini laval studies buyrug‘i ko‘rsatadi
diag-its-studies-2ae7 = undagi hisoblar: { $all }
diag-the-machine-has-no-study-1dcb = mashinada "{ $word }" hisobi yo‘q
diag-stopping-ctrl-c-again-stops-at-3a4d = to‘xtatilmoqda; yana Ctrl-C bosilsa, darhol to‘xtaydi
diag-warning-ctrl-c-will-stop-at-f5b8 = ogohlantirish: Ctrl-C darhol to‘xtatadi, hali yozilmagan natijalar yo‘qoladi ({ $e })
diag-not-run-3464 = bajarilmadi: { $left }
diag-warning-also-holds-results-of-study-0789 = ogohlantirish: { $out } papkasida { $names } hisobining natijalari ham bor, ular avvalgi mashina fayliga tegishli
diag-warning-also-holds-results-of-studies-8275 = ogohlantirish: { $out } papkasida { $names } hisoblarining natijalari ham bor, ular avvalgi mashina fayliga tegishli
diag-pdf-prints-report-html-which-format-eca7 = --pdf report.html faylini chop etadi, --format esa uni chiqarmaydi
diag-laval-study-has-no-result-1a9b = laval: "{ $name }" hisobining natijasi yo‘q
diag-laval-7bec = laval: { $why }

## laval-cli/src/show.rs

diag-there-is-no-kind-of-called-63a8 = { $what } blokining { $word } degan turi yo‘q

## laval-cli/src/terminal.rs

diag-laval-cannot-write-to-standard-output-26ab = laval: standart chiqishga yozib bo‘lmaydi: { $e }

## laval/src/outcome/mod.rs

diag-the-end-bff1 = oxiri
diag-in-the-table-1bb6 = { $table } jadvalidagi { $name }
diag-column-of-table-has-rows-the-d4c8 = `{ $table }` jadvalining `{ $column }` ustunida { $found } ta qator, undan oldingi ustunlarda { $expected } ta qator bor
diag-is-no-finite-number-6158 = { $what } chekli son emas
diag-two-s-are-named-baa3 = ikkita { $what } nomi bir xil: `{ $name }`
diag-figure-needs-which-is-missing-0bb0 = `{ $figure }` grafigiga { $expected } `{ $table }` kerak, u esa yo‘q
diag-figure-needs-in-table-137d = `{ $figure }` grafigiga `{ $table }` jadvalidagi { $expected } `{ $column }` kerak
diag-the-result-cannot-be-computed-16f8 = natijani hisoblab bo‘lmaydi: { $e }
diag-a-value-of-the-machine-or-bcfe = mashinaning yoki hisobning bir qiymati juda katta yoki juda kichik
diag-the-study-s-result-is-inconsistent-dc5b = hisob natijasi ziddiyatli: { $e }

## laval/src/output_folder.rs

diag-it-is-a-file-e707 = bu fayl
diag-cannot-make-the-folder-4dd9 = { $folder } papkasini yaratib bo‘lmaydi: { $why }
diag-name-another-one-with-out-d81d = --out bilan boshqasini ko‘rsating
diag-cannot-write-f8b7 = { $path } fayliga yozib bo‘lmaydi: { $e }
diag-mend-the-permissions-of-the-folder-8e1f = papkaga kirish huquqlarini to‘g‘rilang yoki --out bilan boshqa papka ko‘rsating
diag-was-not-made-by-this-program-0488 = { $path } bu dastur tomonidan yaratilmagan, u o‘zgartirilmaydi
diag-move-it-elsewhere-or-name-another-3b1e = uni boshqa joyga ko‘chiring yoki --out bilan boshqa papka ko‘rsating
diag-another-process-is-writing-into-92c3 = { $folder } papkasiga boshqa jarayon yozmoqda
diag-another-process-number-is-writing-into-7450 = { $folder } papkasiga boshqa jarayon (raqami { $number }) yozmoqda
diag-wait-until-it-has-ended-or-add0 = u tugaguncha kuting yoki --out bilan boshqa papka ko‘rsating

## laval/src/report/renew.rs

diag-is-where-results-are-to-be-4cdb = { $path }: { $what }, natijalar esa shu yerga yozilishi kerak
diag-a-file-of-another-program-48c0 = boshqa dastur fayli
diag-a-folder-3924 = papka
diag-no-folder-511c = papka emas

## laval/src/report/write.rs

diag-cannot-write-581b = { $path } fayliga yozib bo‘lmaydi: { $source }
diag-cannot-write-1-file-written-before-39ef = { $path } fayliga yozib bo‘lmaydi: { $source } (undan oldin yozilgan 1 ta fayl to‘liq)
diag-cannot-write-files-written-before-it-09e7 = { $path } fayliga yozib bo‘lmaydi: { $source } (undan oldin yozilgan { $n } ta fayl to‘liq)
diag-study-2678 = `{ $study }` hisobi: { $source }

## laval/src/store/cells.rs

diag-a-chunk-of-rows-and-columns-2774 = { $rows } ta qator va { $columns } ta ustunli bo‘lak { $found } o‘lchamda hisoblangan

## laval/src/store/folder.rs

diag-cannot-remove-7a2c = { $path } faylini o‘chirib bo‘lmaydi: { $e }
diag-was-not-written-by-this-program-ed9c = { $path } bu dastur tomonidan yozilmagan
diag-move-it-elsewhere-or-give-the-a880 = uni boshqa joyga ko‘chiring yoki natijalarga --out bilan boshqa papka bering
diag-is-no-manifest-of-this-program-a5a1 = { $path } bu dasturning manifesti emas: { $why }
diag-give-the-results-another-folder-with-e621 = natijalarga --out bilan boshqa papka bering yoki --fresh bilan yangidan boshlang (papkadagi fayllar o‘chiriladi)
diag-its-format-is-this-program-writes-7167 = uning formati { $found }, bu dastur { $own } formatida yozadi
diag-its-format-is-none-this-program-4126 = uning formati yo‘q, bu dastur { $own } formatida yozadi
diag-the-order-of-its-blocks-f191 = bloklari tartibi
diag-and-more-2ac0 = va yana { $more } ta
diag-holds-results-of-another-build-of-dcdb = { $path } dasturning boshqa yig‘masi yoki boshqa protsessor natijalarini saqlaydi: { $all }
diag-holds-results-of-another-input-472e = { $path } boshqa kirish ma’lumotlari natijalarini saqlaydi: { $all }
diag-give-the-new-results-another-folder-4370 = yangi natijalarga --out bilan boshqa papka bering yoki --fresh bilan yangidan boshlang (eski natijalar o‘chiriladi)
diag-missing-b4f3 = mavjud emas
diag-damaged-72ee = shikastlangan
diag-is-rows-to-are-computed-again-50b5 = { $path } { $why }: { $first } – { $last } qatorlar qayta hisoblanadi
diag-not-of-this-study-f8d5 = bu hisobga tegishli emas
diag-chunk-cannot-be-written-as-parquet-3b0c = { $index }-bo‘lakni Parquet sifatida yozib bo‘lmaydi: { $e }
diag-cannot-read-9ee9 = { $path } faylini o‘qib bo‘lmaydi: { $e }
diag-the-manifest-cannot-be-written-2360 = manifestni yozib bo‘lmaydi: { $e }
diag-cannot-write-of-chunks-are-complete-f917 = { $path } fayliga yozib bo‘lmaydi: { $e }; { $all } ta bo‘lakdan { $kept } tasi to‘liq va saqlangan
diag-make-room-or-mend-the-folder-66a3 = diskda joy bo‘shating yoki papkani tuzating, keyin o‘sha buyruqni bering: u shu joydan davom etadi
diag-name-another-folder-with-out-b101 = --out bilan boshqa papka ko‘rsating

## laval/src/store/manifest.rs

diag-not-given-e003 = berilmagan
diag-was-now-babc = { $what }: avval { $old }, hozir { $new }

## laval/src/store/mod.rs

diag-a-study-needs-at-least-one-c0d9 = hisobda kamida bitta qator, bo‘lakda kamida bitta qator va kamida bitta ustun bo‘lishi kerak
diag-rows-in-chunks-of-are-more-d0c6 = { $rows } ta qator { $chunk } tadan bo‘linganda { $most } tadan ko‘p bo‘lak hosil bo‘ladi
diag-two-columns-are-named-f7a1 = ikkita ustunning nomi bir xil: "{ $name }"
diag-this-build-cannot-write-parquet-which-dbd2 = bu yig‘ma Parquet yoza olmaydi, uzun hisoblar esa shu formatda saqlanadi
diag-there-is-no-column-4824 = "{ $column }" ustuni yo‘q

## laval/src/study/centrifuge/cups/mod.rs

diag-the-tube-holds-no-liquid-its-6763 = probirkada suyuqlik yo‘q: uning sirti tubda yoki undan pastda
diag-measure-surface-and-length-from-the-42d5 = surface va length qiymatlarini og‘izdan o‘lchang
diag-the-centre-of-mass-lies-far-8fab = massa markazi probirka tubidan ancha pastda
diag-measure-it-from-the-mouth-with-8dfb = uni og‘izdan, tarkibi bilan birga o‘lchang
diag-the-tube-reaches-across-the-spin-499b = probirka aylanish o‘qini kesib o‘tadi
diag-increase-mouth-radius-fce8 = mouth_radius qiymatini oshiring
diag-inner-radius-must-be-smaller-than-25c4 = inner_radius qiymati outer_radius qiymatidan kichik bo‘lishi kerak
diag-exchange-them-3e47 = ularni almashtiring
diag-the-liquid-s-surface-must-lie-5953 = suyuqlik sirti baraban ichida bo‘lishi kerak: surface_radius qiymati bowl_radius qiymatidan kichik
diag-the-surface-is-the-inner-face-68b0 = sirt suyuqlikning ichki yuzasidir
diag-how-far-the-cup-swings-out-dd7a = stakanning og‘ishi uning massa markaziga bog‘liq, massa markazi esa berilmagan
diag-add-centre-of-mass-60-mm-c3bc = centre_of_mass = "60 mm" qo‘shing (osma sharnirdan, tarkibi bilan) yoki stakanni berilgan og‘ish burchagida (tilt) mahkamlang
diag-a-moment-of-inertia-needs-the-c51e = inersiya momentiga u tegishli bo‘lgan massa kerak
diag-add-mass-bcf9 = mass qo‘shing
diag-no-body-has-these-second-moments-f674 = sharnirga nisbatan bunday ikkinchi tartibli momentlarga ega jism yo‘q
diag-moment-along-is-at-least-mass-d9e1 = moment_along kamida mass va centre_of_mass kvadrati ko‘paytmasiga teng; moment_product kvadrati ko‘pi bilan moment_along va moment_across ko‘paytmasiga teng
diag-the-cup-holds-no-liquid-its-de84 = stakanda suyuqlik yo‘q: uning sirti tubda yoki undan pastda
diag-measure-surface-and-bottom-from-the-e09d = surface va bottom qiymatlarini sharnirdan tashqariga qarab o‘lchang
diag-the-centre-of-mass-lies-from-b498 = massa markazi sharnirdan { $along } masofada, { $bottom } masofadagi stakan tubidan ancha pastda
diag-measure-both-from-the-hinge-7e75 = ikkalasini ham sharnirdan o‘lchang
diag-the-centre-of-mass-lies-outside-6a05 = massa markazi stakandan tashqarida
diag-at-most-cup-radius-to-either-3b6a = o‘qining har ikki tomoniga ko‘pi bilan cup_radius
diag-the-surface-of-the-liquid-reaches-d8a6 = stakan og‘ganda suyuqlik sirti aylanish o‘qini kesib o‘tadi
diag-increase-hinge-radius-772a = hinge_radius qiymatini oshiring
diag-cups-with-an-inner-radius-of-c132 = ichki radiusi { $inner } bo‘lgan { $count } ta stakan osilib turganda bir-biriga kiradi
diag-cups-with-an-inner-radius-of-fb5e = ichki radiusi { $inner } bo‘lgan { $count } ta stakan { $tilt } og‘ish burchagida bir-biriga kiradi
diag-is-at-least-for-of-them-dc43 = { $count } ta stakan uchun { $field } kamida { $least }, devorlarini hisobga olmaganda; yoki count bilan stakanlar sonini kamaytiring
diag-which-carries-it-does-not-exist-4469 = uni ko‘taradigan "{ $name }" jismi mavjud emas
diag-has-no-mass-of-its-own-2665 = "{ $name }" jismining stakanlar massasi qo‘shiladigan o‘z massasi yo‘q
diag-has-no-unbalance-of-its-own-02c9 = "{ $name }" jismining stakanlar disbalansi qo‘shiladigan o‘z disbalansi yo‘q
diag-attach-the-cups-to-a-disc-1150 = stakanlarni diskka biriktiring
diag-what-loads-a-body-needs-mass-c12e = jismga yuk bo‘ladigan stakan uchun mass va centre_of_mass kerak
diag-add-both-with-contents-or-leave-f30c = ikkalasini ham tarkibi bilan birga qo‘shing; yoki on kalitini olib tashlang
diag-values-are-given-for-cups-f8d1 = { $count } ta stakan uchun { $given } ta qiymat berilgan
diag-give-one-for-each-0-for-ec2c = har bir stakan uchun bittadan bering, farqi yo‘qlari uchun 0
diag-a-centre-of-mass-would-lie-abc7 = biror stakanning massa markazi sharnirda yoki uning narigi tomonida bo‘lib qoladi
diag-differences-are-small-against-centre-of-e735 = farqlar centre_of_mass qiymatiga nisbatan kichik bo‘ladi
diag-a-cup-would-weigh-less-than-81ed = biror stakanning massasi manfiy bo‘lib qoladi
diag-a-missing-cup-is-minus-its-dac8 = yo‘q stakan o‘z massasining manfiysi bilan beriladi
diag-a-viscosity-in-the-table-is-2768 = jadvaldagi bir qovushqoqlik musbat emas
diag-check-the-column-and-its-unit-81c4 = ustunni va uning birligini tekshiring
diag-the-viscosity-table-goes-from-k-9d41 = qovushqoqlik jadvali { $low } – { $high } K oralig‘ini qamraydi; { $t } K haroratda qiymati yo‘q
diag-extend-the-table-viscosity-is-not-baa6 = jadvalni kengaytiring: qovushqoqlik ekstrapolyatsiya qilinmaydi
diag-give-temperatures-in-increasing-order-7f7b = haroratlarni o‘sish tartibida bering
diag-a-viscosity-table-needs-the-temperature-23e1 = qovushqoqlik jadvali uchun suyuqlik ajratiladigan harorat kerak
diag-add-temperature-60-degc-e709 = temperature = "60 degC" qo‘shing
diag-both-viscosity-and-viscosity-table-are-815f = viscosity ham, viscosity_table ham berilgan
diag-keep-one-of-them-c17f = ulardan bittasini qoldiring
diag-the-viscosity-of-the-liquid-is-2fd6 = suyuqlikning qovushqoqligi berilmagan
diag-add-viscosity-1-mpa-s-or-7227 = viscosity = "1 mPa s" yoki viscosity_table va temperature qo‘shing
diag-the-size-of-the-particles-is-30da = zarralar o‘lchami berilmagan
diag-the-sizes-are-given-in-several-7b62 = o‘lchamlar bir necha usulda berilgan: { $given }
diag-say-one-of-diameter-median-diameter-f077 = quyidagilardan birini bering: diameter; median_diameter va geometric_deviation; characteristic_diameter va spread; sizes
diag-needs-beside-it-6e09 = { $way } yonida { $field } ham kerak
diag-add-7c9e = { $field } qo‘shing
diag-a-powder-needs-either-undersize-or-49e9 = kukun diametrlari uchun undersize yoki share kaliti kerak
diag-sizes-6b6c = sizes = {"{"} diameter = [..], undersize = [..] {"}"}
diag-the-densities-are-given-in-two-09e3 = zichliklar ikki usulda berilgan
diag-keep-densities-or-density-deviation-6dc6 = densities yoki density_deviation kalitlaridan birini qoldiring
diag-densities-3bfb = densities = {"{"} density = [..], share = [..] {"}"}
diag-there-is-no-cup-named-acf8 = "{ $name }" nomli stakan yo‘q
diag-cups-of-this-machine-27de = bu mashinaning stakanlari: { $names }
diag-this-machine-has-several-cups-2aed = bu mashinada bir nechta stakan bor
diag-add-cup-with-one-of-031d = cup = .. qo‘shing, nomi quyidagilardan biri: { $names }
diag-this-machine-has-nothing-that-separates-3ac4 = bu mashinada ajratadigan idish yo‘q
diag-add-a-block-cup-with-kind-40e1 = kind = "swinging", "fixed_angle", "tubular_bowl", "disc_stack" yoki "decanter" bo‘lgan [[cup]] bloki qo‘shing
diag-this-machine-has-nothing-to-separate-394f = bu mashinada ajratiladigan suspenziya yo‘q
diag-add-a-block-suspension-with-liquid-03ca = liquid_density, viscosity, particle_density va diameter kalitlari bor [suspension] bloki qo‘shing

## laval/src/study/centrifuge/cups/task.rs

diag-the-time-in-which-the-cups-9fc8 = stakanlarda ajratish uchun berilgan vaqt kerak
diag-add-time-30-min-1419 = time = "30 min" qo‘shing
diag-liquid-flows-through-its-throughput-is-8a11 = "{ $name }" idishi oqimli: vaqt emas, unumdorlik kerak
diag-add-throughput-500-l-h-and-bb7c = throughput = "500 l/h" qo‘shing, time kerak emas
diag-nothing-flows-through-9d8a = "{ $name }" idishi oqimli emas
diag-give-time-10-min-instead-dae6 = o‘rniga time = "10 min" bering
diag-a-decanter-is-counted-by-its-261e = dekanter Sigma qiymati bo‘yicha hisoblanadi, u esa faqat Stoks qarshiligi uchun mavjud
diag-use-drag-stokes-in-suspension-or-3b00 = [suspension] blokida drag = "stokes" ishlating yoki Sigma qiymati bir xil bo‘lgan tubular_bowl oling
diag-particles-and-liquid-have-the-same-cff9 = zarralar va suyuqlik zichligi bir xil: hech narsa ajralmaydi
diag-give-particle-density-another-value-than-a77a = particle_density uchun liquid_density qiymatidan boshqa qiymat bering
diag-particles-of-do-not-fit-into-38bc = { $size } o‘lchamli zarralar kengligi { $wide } bo‘lgan "{ $name }" idishiga sig‘maydi
diag-check-the-unit-of-the-diameter-dbc5 = [suspension] blokidagi diametr birligini tekshiring
diag-the-path-of-a-particle-could-e89c = zarra yo‘lini hisoblab bo‘lmadi: { $why }
diag-a-particle-that-moves-much-faster-ed21 = stakan aylanishidan ancha tez harakatlanadigan zarra uchun drag = "schiller_naumann" kerak

## laval/src/study/centrifuge/operating_window/contents.rs

diag-the-machine-with-what-it-has-9372 = ajratilgan tarkibi bilan bunday mashina mavjud emas: { $why }

## laval/src/study/centrifuge/operating_window/mod.rs

diag-speeds-to-evaluate-and-more-where-773d = ta baholanadigan tezlik, o‘zgarish bo‘lgan joylarda yana qo‘shiladi

## laval/src/study/centrifuge/operating_window/passage.rs

diag-turns-of-the-rotor-to-integrate-afa3 = ta rotor aylanishi o‘tish modelida integrallanadi
diag-give-the-ramp-another-duration-60fd = ramp uchun boshqa davomiylik bering
diag-the-passage-could-not-be-computed-78f4 = o‘tishni { $speed } tezlikdan nariga hisoblab bo‘lmadi
diag-shorten-the-ramp-or-the-range-4b36 = ramp davomiyligini yoki tezliklar oralig‘ini qisqartiring; oynadan pastda noturg‘un mashinaning harakati cheksiz o‘sishi mumkin

## laval/src/study/centrifuge/operating_window/request.rs

diag-begin-at-a-low-speed-such-c83d = past tezlikdan boshlang, masalan eng yuqori tezlikning o‘ndan biridan
diag-the-range-of-speeds-must-begin-f56a = tezliklar oralig‘i noldan katta tezlikdan boshlanishi kerak
diag-write-uncertain-8963 = uncertain = {"{"} suspension.viscosity = "20 %" {"}"} ko‘rinishida yozing
diag-which-parameters-are-uncertain-is-missing-54c5 = qaysi parametrlar noaniqligi ko‘rsatilmagan
diag-uncertain-parameters-are-too-many-every-d443 = { $found } ta noaniq parametr juda ko‘p: chegaralarining har bir kombinatsiyasi baholanadi
diag-keep-at-most-five-c64b = ko‘pi bilan beshtasini qoldiring
diag-a-time-or-throughput-needs-something-af88 = vaqt yoki unumdorlik uchun ajratiladigan suspenziya va ajratadigan idish kerak
diag-add-the-blocks-cup-and-suspension-053e = [[cup]] va [suspension] bloklarini qo‘shing
diag-the-run-up-to-the-top-68a1 = oraliqning eng yuqori tezligigacha tezlashish { $ramp } davom etadi, bu uning boshidan hisoblanadigan mavjud vaqtdan ({ $time }) uzun
diag-give-a-shorter-ramp-a-lower-8b36 = ramp qiymatini kamaytiring, oraliqning yuqori chegarasini pasaytiring yoki vaqtni oshiring; count_ramp = false bo‘lganda vaqt tezlashish oxiridan hisoblanadi
diag-add-ramp-60-s-the-time-db06 = ramp = "60 s" qo‘shing: tezliklar oralig‘ining eng yuqori tezligigacha bo‘lgan vaqt
diag-the-state-that-a-run-up-6a0f = tezlashish olib boradigan holat uchun tezlashish vaqti kerak
diag-the-limits-on-the-passage-need-c4b8 = o‘tish chegaralari uchun tezlashish vaqti kerak
diag-there-is-no-separation-whose-time-37dc = vaqti eng qisqa qilinadigan ajratish yo‘q
diag-add-cup-suspension-and-time-throughput-fb74 = [[cup]], [suspension] va time (oqimli idishda throughput) qo‘shing
diag-no-limit-on-vibration-is-given-8f35 = amplitudalar taqqoslanadigan tebranish chegarasi berilmagan
diag-add-displacement-velocity-tilt-force-or-cb12 = [limits] blokiga displacement, velocity, tilt, force yoki moment qo‘shing
diag-what-the-study-requires-of-the-db03 = hisobning mashinaga qo‘ygan talabi uning stakanlari va suspenziyasiga mos emas

## laval/src/study/centrifuge/operating_window/steady.rs

diag-the-stability-of-a-steady-state-99a6 = barqaror holatning turg‘unligini baholab bo‘lmaydi: { $why }
diag-a-steady-state-cannot-be-evaluated-0b1c = barqaror holatni hisoblab bo‘lmaydi: { $e }

## laval/src/study/centrifuge/operating_window/vary.rs

diag-numbers-of-539d = "{ $name }" kattaliklari: { $own }
diag-cannot-be-b533 = { $path } qiymati { $value } bo‘la olmaydi
diag-has-no-number-to-vary-071a = "{ $name }" blokida o‘zgartiriladigan { $field } soni yo‘q
diag-give-it-a-value-in-its-ae9c = avval uning blokida unga qiymat bering

## laval/src/study/centrifuge/separation/meter.rs

diag-paths-of-particles-to-integrate-roughly-2ddf = ta zarra yo‘li integrallanadi, taxminan

## laval/src/study/centrifuge/separation/mod.rs

diag-a-programme-begins-at-time-0-7c07 = tezlik dasturi 0 vaqtdan boshlanadi, bir yo‘nalishda aylanadi va oxirida aylanish davom etadi
diag-the-last-speed-is-held-c274 = oxirgi tezlik saqlanadi
diag-give-times-in-increasing-order-c8b3 = vaqtlarni o‘sish tartibida bering
diag-both-a-programme-and-a-ramp-0676 = programme ham, ramp ham berilgan
diag-release-0-mm-20-mm-0-a72d = release = ["0 mm", "20 mm", "0 mm"]
diag-a-place-has-three-components-not-e4ba = joyning uchta komponenti bo‘ladi; berilganlari { $n } ta
diag-release-velocity-0-m-s-0-3bd1 = release_velocity = ["0 m/s", "0.1 m/s", "0 m/s"]
diag-a-velocity-has-three-components-not-760c = tezlikning uchta komponenti bo‘ladi; berilganlari { $n } ta
diag-a-velocity-belongs-to-a-particle-bd64 = tezlik qo‘yib yuboriladigan zarraga tegishli
diag-add-release-0-mm-20-mm-ac24 = release = ["0 mm", "20 mm", "0 mm"] qo‘shing
diag-a-particle-whose-drag-balances-the-2608 = qarshiligi maydonni muvozanatlaydigan zarraning o‘z boshlang‘ich tezligi yo‘q
diag-take-it-out-or-take-model-988f = uni olib tashlang yoki model = "exact" oling
diag-a-run-up-needs-two-different-e12f = tezlashish uchun ikki xil tezlik kerak; bu tezlashish nol tezlikda boshlanadi va tugaydi
diag-give-another-speed-or-leave-ramp-df25 = boshqa tezlik bering yoki ramp kalitini olib tashlang
diag-liquid-flows-through-this-machine-which-9d11 = bu mashina oqimli, unga suyuqlik ish tezligida beriladi: hisobga olinadigan tezlashish yo‘q
diag-leave-it-out-7b2b = uni olib tashlang
diag-the-run-up-takes-longer-than-c0f0 = tezlashish { $ramp } davom etadi, bu mavjud vaqtdan ({ $time }) uzun: tezlikka hech qachon yetilmaydi
diag-give-a-shorter-ramp-or-more-719c = tezlashish vaqtini qisqartiring yoki vaqtni oshiring
diag-one-particle-can-be-followed-in-007a = bitta zarrani faqat stakan va probirkalarda kuzatish mumkin
diag-leave-release-out-355c = release kalitini olib tashlang
diag-no-particle-finds-liquid-in-this-b6b2 = bu probirkada zarra suyuqlikka tushmaydi
diag-lower-surface-or-raise-length-f51b = surface qiymatini kamaytiring yoki length qiymatini oshiring

## laval/src/study/context.rs

diag-making-the-time-form-of-6c7f = vaqt sohasidagi shakl tuzilmoqda: { $names }

## laval/src/study/kind.rs

diag-the-study-was-stopped-within-a-cbf2 = hisob qisman natija bermaydigan hisoblash paytida to‘xtatildi

## laval/src/study/linear/approximation.rs

diag-no-part-of-this-machine-has-b90f = bu mashinaning birorta qismida taqqoslanadigan approksimatsiya yo‘q
diag-parts-with-waves-without-number-have-9300 = u cheksiz ko‘p to‘lqinli qismlarda bor; boshqa hollarda compare kalitini olib tashlang
diag-the-approximation-is-no-machine-47ae = approksimatsiyadan mashina tuzib bo‘lmaydi: { $why }
diag-leave-compare-out-5311 = compare kalitini olib tashlang

## laval/src/study/linear/campbell.rs

diag-speeds-at-which-roots-are-counted-0176 = ta tezlikda ildizlar sanaladi, birin-ketin
diag-eigenvalue-problems-to-solve-3ff3 = ta xos qiymatlar masalasi yechiladi
diag-modes-shows-the-modes-at-one-aec9 = { $help }; bitta tezlikdagi modalarni modes hisobi beradi

## laval/src/study/linear/criterion.rs

diag-flutter-is-for-machines-that-nothing-8c74 = flutter mezoni so‘ndirishi ham, yuritmasi ham yo‘q mashinalar uchun; bu mashinada so‘ndirish bor
diag-set-all-damping-to-0-or-3e29 = barcha so‘ndirishlarni 0 qiling yoki criterion = "growth" va growth_threshold ishlating
diag-no-part-of-this-machine-has-754c = bu mashinaning birorta qismida bu mezon uchun kerakli yo‘qotish, masalan qovushqoqlik, yo‘q
diag-give-one-a-viscosity-or-take-ccca = biror qismga viscosity bering yoki criterion = "growth" va growth_threshold ishlating

## laval/src/study/linear/forced_response/mod.rs

diag-no-body-of-this-machine-moves-0be8 = bu mashinada o‘qqa ko‘ndalang harakatlanadigan jism yo‘q
diag-responses-at-speeds-of-coordinates-ffcf = { $speeds } ta tezlikda { $n } ta koordinata javobi
diag-give-the-range-fewer-points-where-a938 = oraliqda nuqtalar sonini kamaytiring: javob egilgan joylarda nuqtalar o‘zi qo‘shiladi
diag-nothing-forces-this-machine-at-the-bc0c = bu mashinani aylanish chastotasida hech narsa qo‘zg‘atmaydi
diag-give-a-disc-an-eccentricity-an-cc3c = diskka ekssentrisitet, disbalans yoki qiyshiqlik bering
diag-speeds-to-solve-for-and-more-309f = ta tezlik yechiladi, javob egilgan joylarda yana qo‘shiladi

## laval/src/study/linear/modes/mod.rs

diag-terms-of-series-in-every-evaluation-3314 = ta qator hadi, ildizlari sanaladigan funksiyaning har bir hisoblanishida

## laval/src/study/linear/stability_map/mod.rs

diag-a-map-of-by-points-is-6344 = { $speeds } × { $values } nuqtali xarita juda katta
diag-at-most-points-in-all-2d77 = jami ko‘pi bilan { $most } ta nuqta
diag-the-machine-does-not-exist-at-46f1 = { $path } = { $x } bo‘lganda mashina mavjud emas: { $why }
diag-narrow-the-range-of-the-parameter-aa3f = parametr oralig‘ini toraytiring

## laval/src/study/motion/basins/axes.rs

diag-must-name-one-initial-value-beside-a61c = { $field }: run_up bilan birga bitta boshlang‘ich qiymat ko‘rsatilishi kerak; ko‘rsatilganlari { $given } ta
diag-must-name-two-initial-values-it-6efa = { $field }: ikkita boshlang‘ich qiymat ko‘rsatilishi kerak; ko‘rsatilganlari { $given } ta
diag-write-1-rad-8cd7 = { $field } = {"{"} "{ $mass }" = "1 rad" {"}"} ko‘rinishida yozing
diag-write-x-1-mm-32e6 = { $field } = {"{"} "{ $body }.x" = "1 mm" {"}"} ko‘rinishida yozing
diag-write-x-1-mm-y-1-3c85 = { $field } = {"{"} "{ $body }.x" = "1 mm", "{ $body }.y" = "1 mm" {"}"} ko‘rinishida yozing
diag-to-names-but-from-names-7aff = to kalitida { $to }, from kalitida esa { $from } ko‘rsatilgan
diag-both-name-the-same-a658 = ikkalasida ham bir xil qiymatlarni ko‘rsating
diag-must-go-from-a-lower-to-d49b = "{ $name }" kichik qiymatdan katta qiymatga borishi kerak
diag-a-grid-of-by-points-is-75a7 = { $first } × { $second } nuqtali to‘r juda katta
diag-points-must-be-whole-numbers-from-9f75 = points 2 – { $most } oralig‘idagi butun sonlar bo‘lishi kerak; berilgani: { $x }
diag-points-names-which-is-not-varied-9569 = points kalitida "{ $n }" ko‘rsatilgan, u esa o‘zgartirilmaydi
diag-varied-are-2f80 = o‘zgartiriladiganlar: { $names }

## laval/src/study/motion/basins/masses/mod.rs

diag-starts-followed-beforehand-then-those-of-0602 = ta boshlang‘ich shart kuzatiladi, avval dastlabkilari, keyin xaritadagilari
diag-motions-to-follow-until-their-masses-76f2 = ta harakat sharchalar tinch holatga kelguncha yoki bir xil harakatlanguncha kuzatiladi

## laval/src/study/motion/basins/mod.rs

diag-basins-need-a-speed-above-there-e9a5 = basins uchun { $least } qiymatidan katta tezlik kerak: aylanmaydigan mashinada davr yo‘q
diag-a-run-up-makes-no-difference-e5b8 = { $speed } tezlikda tezlashish ta’sir qilmaydi: bu mashinada u bilan birga aylanuvchi o‘qlarda harakatlanadigan sharchalar yo‘q
diag-leave-run-up-out-90f9 = run_up kalitini olib tashlang
diag-the-spin-of-this-machine-is-c90d = bu mashinaning aylanishi erkin: harakatlar barqarorlashadigan tezlik berilmagan
diag-leave-drive-free-out-or-follow-efcb = drive = "free" kalitini olib tashlang yoki harakatni transient hisobi bilan kuzating
diag-motions-to-follow-cells-and-the-b5b2 = kuzatiladigan harakatlar soni { $count } ({ $cells } ta katak va g‘alayonlanmagan boshlang‘ich shart), har biri ko‘pi bilan { $turns } ta aylanish: { $what }, shuning uchun barqarorlashish vaqti noma’lum
diag-motions-to-follow-until-they-repeat-fe68 = ta harakat takrorlanguncha kuzatiladi
diag-at-rest-a-mode-of-this-c2da = muvozanat holati atrofidagi moda { $growth } sur’at bilan o‘sadi
diag-at-rest-a-mode-of-this-8b63 = muvozanat holati atrofidagi moda so‘nmaydi ham, o‘smaydi ham
diag-the-modes-of-this-machine-at-bdf2 = muvozanat holati atrofidagi modalar noma’lum

## laval/src/study/motion/basins/report.rs

diag-the-attractors-are-not-those-of-fdb9 = attraktorlar bu harakatlarga tegishli emas

## laval/src/study/motion/history/mod.rs

diag-output-times-of-coordinates-d440 = { $n } ta koordinataning { $outputs } ta chiqish vaqtidagi qiymatlari
diag-give-fewer-points-a-longer-output-6e5a = nuqtalar sonini kamaytiring (output_step qiymatini oshiring) yoki velocities va observables kalitlarini olib tashlang
diag-the-study-was-stopped-before-its-ea66 = hisob mashinaning vaqt sohasidagi shakli tuzilmasdan to‘xtatildi
diag-turns-of-the-rotor-to-integrate-2fed = ta rotor aylanishi integrallanadi, { $duration }

## laval/src/study/motion/motion_map/mod.rs

diag-both-a-range-of-speeds-and-8fcf = tezlik oralig‘i ham, x bo‘yicha parametr ham berilgan
diag-say-one-or-the-other-5112 = ulardan bittasini bering
diag-a-map-of-two-parameters-needs-75f7 = ikki parametr xaritasiga noldan katta tezlik kerak
diag-add-speed-3000-rpm-here-or-39c1 = speed = "3000 rpm" kalitini shu yerga yoki [machine] blokiga qo‘shing
diag-and-are-the-same-parameter-dc84 = "{ $first }" va "{ $second }" bitta parametrdir
diag-is-no-value-9845 = { $path }: { $x } qiymat bo‘la olmaydi
diag-the-grid-has-more-points-than-9c74 = to‘rdagi nuqtalar sanab bo‘lmas darajada ko‘p
diag-the-values-of-a-list-lie-32f5 = ro‘yxat qiymatlari uning variantlari papkasida saqlanadi
diag-the-design-has-no-case-22d6 = rejada birorta ham variant yo‘q
diag-cases-are-more-than-can-be-6c04 = { $cases } ta variant raqamlash mumkin bo‘lganidan ko‘p
diag-is-damaged-6361 = { $path }: fayl buzilgan
diag-parameters-are-more-than-the-dimensions-aac5 = { $k } ta parametr Sobol ketma-ketligining { $most } o‘lchamidan ko‘p
diag-the-machine-has-no-study-026d = mashinada "{ $name }" hisobi yo‘q
diag-stopped-before-the-first-case-3403 = birinchi variantgacha to‘xtatildi
diag-the-study-has-no-numbers-for-11b4 = hisob bu mashina uchun son bermaydi: { $why }
diag-belongs-to-another-study-another-build-5178 = { $path } boshqa hisobga, boshqa yig‘maga yoki boshqa protsessorga tegishli
diag-vary-two-parameters-e3b5 = ikkita har xil parametrni o‘zgartiring
diag-a-map-of-by-motions-is-21b0 = { $a } × { $b } harakatli xarita juda katta
diag-at-most-motions-in-all-6722 = jami ko‘pi bilan { $most } ta harakat
diag-this-study-needs-a-range-of-c0d9 = bu hisobga tezlik oralig‘i kerak
diag-add-speed-or-a-speed-to-16b1 = speed = {"{"} from = "1000 rpm", to = "5000 rpm" {"}"} qo‘shing yoki [machine] blokiga speed qo‘shing
diag-or-give-x-a-second-parameter-93d9 = { $help }, yoki x uchun ikkinchi parametr bering: unda tezlik hamma joyda bir xil bo‘ladi
diag-a-map-needs-speeds-above-there-fb49 = xaritaga { $least } qiymatidan katta tezliklar kerak: aylanmaydigan mashinada davr yo‘q

## laval/src/study/motion/record.rs

diag-a-state-of-coordinates-and-internal-7bda = { $coordinates } ta koordinatali va { $states } ta ichki holatli boshlang‘ich holat bu mashinaga tegishli emas: bu mashinada ular { $n } va vaqt sohasida { $m } ta
diag-continue-from-a-motion-of-the-8d3a = xuddi shu mashinaning harakatidan davom ettiring

## laval/src/study/motion/run_up/mod.rs

diag-the-spin-of-this-machine-is-d361 = bu mashinaning aylanishi erkin, u tezlik dasturi bo‘yicha yura olmaydi
diag-use-a-transient-study-or-take-56cc = transient hisobidan foydalaning yoki erkin yuritmani olib tashlang
diag-the-times-must-begin-at-0-0bad = vaqtlar 0 dan boshlanishi kerak
diag-both-a-programme-and-are-given-4c93 = programme ham, { $given } ham berilgan
diag-how-long-the-change-of-speed-5c35 = tezlik o‘zgarishining davomiyligi berilmagan
diag-add-duration-10-s-or-a-7616 = duration = "10 s" yoki vaqtlar va tezliklar dasturini (programme) qo‘shing
diag-both-a-polynomial-and-to-are-f613 = polynomial ham, to ham berilgan
diag-neither-the-study-nor-the-machine-29cc = yakuniy tezlik hisobda ham, mashinada ham berilmagan
diag-add-to-3000-rpm-0fb7 = to = "3000 rpm" qo‘shing
diag-from-and-to-are-both-2250 = from va to bir xil: { $speed }
diag-this-stays-at-5025 = { $field } bo‘yicha tezlik { $speed } qiymatida o‘zgarmaydi
diag-from-and-the-speed-of-the-93ff = from va mashina tezligi bir xil: { $speed }
diag-a-run-up-needs-two-different-5573 = tezlashish uchun ikki xil tezlik kerak; { $said }
diag-give-another-speed-or-take-a-94e2 = boshqa tezlik bering yoki o‘zgarmas tezlik uchun transient hisobini oling

## laval/src/study/motion/spectra/mod.rs

diag-there-is-fac5 = mavjudlari: { $known }
diag-there-is-no-body-96f6 = "{ $name }" jismi yo‘q
diag-spectra-up-to-order-of-this-f7e0 = bu yozuvning { $highest }-tartibgacha spektrlari uchun { $total } ta namuna kerak, bu juda ko‘p
diag-at-most-lower-highest-order-or-75cb = ko‘pi bilan { $most } ta: highest_order qiymatini kamaytiring yoki qisqaroq harakatni kuzating

## laval/src/study/motion/start.rs

diag-there-is-no-coordinate-or-state-1f90 = "{ $name }" degan koordinata yoki holat yo‘q
diag-is-it-must-lie-between-and-e08b = "{ $name }" qiymati { $value }; u SI birliklarida { $least } – { $most } oralig‘ida bo‘lishi kerak
diag-is-given-twice-6139 = "{ $name }" ikki marta berilgan
diag-has-ebf9 = "{ $part }" qismida mavjudlari: { $own }
diag-this-machine-has-58cb = bu mashinada mavjudlari: { $names }

## laval/src/study/motion/steady_state/stored.rs

diag-there-is-no-column-4b0b = "{ $name }" ustuni yo‘q

## laval/src/study/motion/sweep/mod.rs

diag-at-one-speed-nonlinear-response-finds-425e = { $help }; bitta tezlikda barqaror javoblarni nonlinear_response, boshlang‘ich shart nimaga olib borishini basins va transient hisoblari beradi
diag-a-sweep-needs-speeds-above-there-49bc = sweep uchun { $least } qiymatidan katta tezliklar kerak: aylanmaydigan mashinada davr yo‘q
diag-motions-with-numbers-each-a1ca = har birida { $columns } ta son bo‘lgan { $rows } ta harakat
diag-give-the-range-fewer-points-or-9d64 = oraliqda nuqtalar sonini kamaytiring yoki spektrlar kaskadini (waterfall) olib tashlang
diag-the-spin-of-this-machine-is-9eab = bu mashinaning aylanishi erkin: undan o‘tiladigan tezlik oralig‘i yo‘q
diag-is-no-displacement-or-tilt-of-e52c = "{ $name }" jismning siljishi ham, og‘ish burchagi ham emas
diag-name-one-such-as-0026 = shunday kattalikni ko‘rsating, masalan { $known }

## laval/src/study/motion/transient.rs

diag-neither-the-study-nor-the-machine-bf96 = aylanish tezligi hisobda ham, mashinada ham berilmagan
diag-add-speed-3000-rpm-to-machine-1ffb = [machine] blokiga yoki hisobga speed = "3000 rpm" qo‘shing
diag-a-kick-changes-rates-only-2906 = turtki faqat tezliklarni o‘zgartiradi
diag-name-rates-with-such-as-drum-cc29 = tezliklarni ' belgisi bilan ko‘rsating, masalan "drum.x'"
diag-the-kick-at-comes-after-the-1d6d = { $at } vaqtdagi turtki { $duration } vaqtdagi tugashdan keyin keladi
diag-outputs-are-too-many-cef8 = { $step } ta chiqish juda ko‘p
diag-at-most-1000000-outputs-a3ad = ko‘pi bilan 1000000 ta chiqish
diag-both-output-step-and-points-are-e4e5 = output_step ham, points ham berilgan
diag-the-duration-must-be-positive-3a15 = davomiylik musbat bo‘lishi kerak

## laval/src/study/nonlinear/backbone.rs

diag-amplitude-must-go-from-a-lower-9ac3 = amplitude kichik qiymatdan katta qiymatga borishi kerak
diag-exchange-from-and-to-b115 = from va to qiymatlarini almashtiring

## laval/src/study/nonlinear/bifurcation_loci/mod.rs

diag-the-range-of-speeds-comes-too-4b94 = tezliklar oralig‘i disbalans ta’sir qilmaydigan nol tezlikka juda yaqin
diag-keep-both-ends-above-or-both-75ce = ikkala uchini { $slowest } qiymatidan yuqorida yoki teskari aylanish uchun ikkalasini { $lowest } qiymatidan pastda saqlang
diag-the-response-at-values-is-too-4ab4 = { $points } ta qiymatdagi javoblarni hisoblash hajmi juda katta
diag-points-is-the-number-of-values-4cb3 = points chiziqlar boshlanadigan qiymatlar soni: ko‘pi bilan { $most }
diag-a-steady-response-is-computed-at-5056 = barqaror javob o‘zgarmas tezlikda hisoblanadi, bu mashinaning tezligi esa erkin
diag-prescribe-the-speed-of-the-machine-c769 = mashina tezligini bering: erkin yuritmasini olib tashlang
diag-the-machine-does-not-exist-at-0b99 = { $path } parametrining sinalgan birorta qiymatida ham mashina mavjud emas; { $at } qiymatida: { $why }
diag-the-stability-of-this-machine-s-7f76 = bu mashina harakatlarining turg‘unligini baholab bo‘lmaydi: { $why }
diag-kinds-folds-needs-no-stability-641f = kinds = "folds" uchun turg‘unlik kerak emas

## laval/src/study/nonlinear/free_motion.rs

diag-free-whirls-are-sought-at-constant-efd0 = erkin pretsessiyalar o‘zgarmas tezlikda hisoblanadi, bu mashinaning tezligi esa erkin
diag-prescribe-the-speed-of-the-machine-cac7 = mashina tezligini bering (erkin yuritmasini olib tashlang) yoki erkin mashinani vaqt bo‘yicha transient hisobi bilan kuzating

## laval/src/study/nonlinear/methods.rs

diag-the-methods-are-compared-at-constant-0e38 = usullar o‘zgarmas tezlikda solishtiriladi, bu mashinaning tezligi esa erkin
diag-prescribe-the-speed-of-the-machine-176a = mashina tezligini bering (erkin yuritmasini olib tashlang)

## laval/src/study/nonlinear/nonlinear_response/mod.rs

diag-the-stored-response-is-of-one-2c20 = saqlangan javob bitta tezlikka tegishli, bu hisob esa oraliq bo‘yicha
diag-order-of-the-base-frequency-does-bd3d = asosiy chastotaning { $h }-tartibi disbalansga yetmaydi, uning tartibi { $divisor }
diag-with-subharmonic-n-orders-count-in-3fdb = subharmonic = n bo‘lganda tartiblar speed / n qadam bilan sanaladi: kamida n ta tartib saqlang
diag-motions-of-turns-of-the-rotor-b128 = rotorning { $divisor } ta aylanishidagi harakatlarda "{ $symmetry }" simmetriyasi yo‘q: u faqat toq sonli aylanishlarda bor
diag-write-symmetry-none-or-an-odd-deb5 = symmetry = "none" yozing yoki subharmonic uchun toq son bering

## laval/src/study/nonlinear/response_map/mod.rs

diag-vary-two-parameters-for-one-see-e9a8 = ikkita parametrni o‘zgartiring; bitta parametr uchun nonlinear_response va uncertainty hisoblariga qarang yoki y uchun boshqa parametr bering
diag-a-map-of-by-machines-is-1075 = { $x } × { $y } mashinali xarita juda katta
diag-at-most-machines-in-all-be30 = jami ko‘pi bilan { $most } ta mashina
diag-responses-to-compute-cf95 = ta javob hisoblanadi
diag-is-spaced-in-equal-ratios-but-54d2 = { $field } nuqtalari teng nisbatda joylashadi, lekin boshi 0 dan katta emas
diag-begin-above-0-or-leave-out-53e4 = 0 dan katta qiymatdan boshlang yoki { $spacing } kalitini olib tashlang

## laval/src/study/nonlinear/stationary/chart.rs

diag-cells-of-the-chart-7498 = ta xarita katagi

## laval/src/study/nonlinear/stationary/mod.rs

diag-the-chart-has-too-many-cells-daa9 = xaritada kataklar juda ko‘p
diag-at-most-speeds-times-values-4009 = tezliklar soni va qiymatlar soni ko‘paytmasi ko‘pi bilan { $most }
diag-needs-the-speed-of-the-state-7fe7 = { $field } uchun nazarda tutilgan holatning tezligi kerak
diag-give-stabilise-at-3000-rpm-or-1a65 = stabilise_at = "3000 rpm" yoki [machine] blokida speed bering
diag-stationary-states-are-sought-at-given-86e6 = sinxron holatlar berilgan tezliklarda qidiriladi, bu mashinaning tezligi esa erkin
diag-prescribe-the-speed-of-the-machine-7fd4 = mashina tezligini bering yoki erkin mashinani vaqt bo‘yicha transient hisobi bilan kuzating
diag-at-ff93 = { $path } = { $x } bo‘lganda: { $message }
diag-starts-to-follow-65c8 = ta boshlang‘ich shart kuzatiladi
diag-starts-to-follow-where-no-state-812e = ta boshlang‘ich shart turg‘un holat yo‘q joyda kuzatiladi

## laval/src/study/parameters/optimum/machine.rs

diag-name-each-once-190a = har birini bir marta ko‘rsating
diag-the-bounds-must-go-from-a-c5c6 = { $path }: chegaralar kichik qiymatdan katta qiymatga borishi kerak
diag-is-not-admissible-6d63 = { $path }: { $x } { $unit } yaroqsiz

## laval/src/study/parameters/optimum/mod.rs

diag-runs-of-the-study-at-most-7d3f = ta hisoblash, ko‘pi bilan ({ $kind } hisobi)

## laval/src/study/parameters/optimum/request.rs

diag-one-number-can-be-made-small-4ee5 = bir vaqtda ikkita emas, bitta kattalik kichik yoki katta qilinadi
diag-leave-out-minimise-or-maximise-and-6712 = minimise yoki maximise kalitini olib tashlang, ikkinchi kattalikka at_most yoki at_least bilan chegara bering
diag-nothing-is-named-that-should-become-6ec6 = kichik yoki katta qilinadigan kattalik ko‘rsatilmagan
diag-write-minimise-largest-displacement-or-maximise-3d38 = minimise = "largest_displacement" yoki maximise = "widest_window" yozing
diag-the-limit-on-is-how-far-18f2 = "{ $name }" kattaligining chegarasi { $value }: bajarilish darajasi shu qiymatga nisbatan o‘lchanadi
diag-give-a-number-other-than-zero-cc0a = noldan boshqa son bering
diag-it-finds-3a16 = u topadigan kattaliklar: { $all }
diag-the-study-finds-no-number-of-fd93 = { $kind } hisobi bu mashinaning "{ $name }" kattaligini topmaydi
diag-the-limit-on-6641 = "{ $name }" kattaligining chegarasi: { $message }
diag-parameters-are-too-many-to-search-ed70 = qidirish uchun { $count } ta parametr juda ko‘p

## laval/src/study/parameters/uncertainty/mod.rs

diag-runs-of-the-study-56de = ta hisoblash ({ $kind } hisobi)
diag-samples-of-parameters-require-runs-which-5bcc = { $k } ta parametrning { $samples } ta namunasi { $runs } ta hisoblash talab qiladi, bu juda ko‘p
diag-at-most-runs-in-all-ae2b = jami ko‘pi bilan { $most } ta hisoblash
diag-parameters-need-dimensions-the-sobol-sequence-167d = { $k } ta parametrga { $dimensions } o‘lcham kerak; Sobol ketma-ketligida { $most } ta o‘lcham bor
diag-use-method-monte-carlo-82d8 = method = "monte_carlo" ishlating

## laval/src/study/parameters/uncertainty/tolerance.rs

diag-name-x-or-y-b884 = { $path }.x yoki { $path }.y ko‘rsating
diag-its-values-in-x-and-y-af7c = uning x va y qiymatlari har xil, shuning uchun noaniq deb olinadigan yagona qiymat yo‘q
diag-give-its-standard-deviation-a-tolerance-7843 = standart chetlanishini bering: qismlarning 99.7 % ulushi bajaradigan dopusk uchta standart chetlanishga teng
diag-it-takes-7437 = u quyidagilarni qabul qiladi: { $allowed }
diag-a-distribution-has-no-0fa8 = "{ $distribution }" taqsimotida { $other } bo‘lmaydi
diag-the-standard-deviation-is-missing-81a3 = standart chetlanish berilmagan
diag-add-deviation-2-440b = deviation = "2 %" qo‘shing
diag-the-machine-s-value-is-0-d673 = mashinadagi qiymat 0, uning har qanday ulushi 0: birligi ko‘rsatilgan son bering
diag-it-must-be-above-0-7e37 = u 0 dan katta bo‘lishi kerak
diag-a-standard-deviation-of-leaves-nothing-4f0b = { $deviation } standart chetlanishda noaniqlik qolmaydi
diag-a-log-normal-number-is-positive-29ac = lognormal kattalik musbat, uning o‘rta qiymati { $mean } bo‘la olmaydi
diag-use-normal-or-give-a-mean-b5e5 = "normal" ishlating yoki mean bering
diag-either-from-and-to-or-tolerance-38f5 = yo from va to, yo tolerance kerak
diag-write-tolerance-5-or-from-to-8859 = tolerance = "5 %" yoki from = .., to = .. yozing
diag-the-machine-s-value-is-0-bcf9 = mashinadagi qiymat 0, uning har qanday ulushi 0: birligi ko‘rsatilgan sonlar bering
diag-from-must-lie-below-to-2ee8 = from qiymati to qiymatidan kichik bo‘lishi kerak
diag-there-is-nothing-between-and-3b19 = { $from } va { $to } orasida hech narsa yo‘q
diag-is-not-admissible-for-this-parameter-c787 = bu parametr uchun { $value } yaroqsiz
diag-narrow-the-interval-69e6 = oraliqni toraytiring
diag-its-most-probable-value-lies-outside-fd45 = eng ehtimolli qiymati { $mode } { $from } – { $to } oralig‘idan tashqarida
diag-give-mode-or-other-ends-6d7c = mode yoki boshqa uchlar bering

## laval/src/study/shared/limits.rs

diag-there-are-a-point-of-a-a331 = mavjudlari: { $all }; jism nuqtasi "drum at 100 mm" kabi yoziladi
diag-there-are-f68d = mavjudlari: { $all }
diag-names-which-is-no-body-of-c478 = { $field }: "{ $n }" bu mashinaning jismi emas
diag-names-which-is-no-body-that-b6c8 = { $field }: "{ $n }" bu mashinaning og‘adigan jismi emas
diag-names-which-is-no-part-with-b98a = { $field }: "{ $n }" kuchi bo‘lgan qism emas
diag-names-which-is-no-part-with-b270 = { $field }: "{ $n }" momenti bo‘lgan qism emas
diag-rated-density-belongs-to-a-highest-83e1 = rated_density eng yuqori tezlikka tegishli, u esa berilmagan
diag-add-speed-8e93 = speed qo‘shing

## laval/src/study/shared/operation.rs

diag-run-up-time-needs-an-operating-a26f = run_up_time uchun ish tezligi kerak, u [operation] blokida ham, [machine] blokida ham berilmagan
diag-operating-speeds-begin-above-standstill-and-7f11 = ish tezliklari noldan katta qiymatdan boshlanadi va aylanish yo‘nalishi bitta
diag-the-operating-speeds-must-go-from-00fe = ish tezliklari kichik qiymatdan katta qiymatga qarab berilishi kerak
diag-from-is-and-to-is-exchange-b990 = from qiymati { $from }, to qiymati { $to }: o‘rnini almashtiring
diag-the-speed-of-machine-is-not-8ca9 = [machine] blokidagi tezlik { $w } ish tezliklari oralig‘ida emas: { $low } – { $high }
diag-give-the-speed-in-one-of-bf60 = tezlikni ikki joydan birida bering yoki ulardan birini o‘zgartiring

## laval/src/study/shared/presentation.rs

diag-write-file-si-or-units-such-3458 = file, si yoki birliklarni yozing, masalan "rpm, mm, kN"

## laval/src/study/shared/size.rs

diag-spectra-of-states-6d66 = { $states } ta holatning { $speeds } ta spektri
diag-give-the-range-fewer-points-f548 = oraliqda nuqtalar sonini kamaytiring
diag-rows-of-numbers-866d = har birida { $columns } ta son bo‘lgan { $rows } ta qator
diag-give-fewer-points-6535 = nuqtalar sonini kamaytiring
diag-take-about-gb-of-memory-more-e408 = { $of } taxminan { $needed } GB xotira talab qiladi, ruxsat etilgani { $most } GB

## laval/src/study/shared/speed_range.rs

diag-the-study-needs-the-coefficients-of-46db = hisobga "{ $name }" qismining { $from } tezlikdagi koeffitsiyentlari kerak; jadvali { $low } – { $high } oralig‘ini qamraydi
diag-the-study-needs-the-coefficients-of-bb45 = hisobga "{ $name }" qismining { $from } – { $to } oralig‘idagi koeffitsiyentlari kerak; jadvali { $low } – { $high } oralig‘ini qamraydi
diag-keep-to-speeds-of-the-table-c95a = jadval tezliklarida qoling, jadvalga qatorlar qo‘shing yoki "{ $name }" qismida beyond = "hold" yoki beyond = "linear" yozing: jadvaldan tashqaridagi natijalar belgilab ko‘rsatiladi
diag-the-tables-of-have-no-frequencies-af27 = { $names } jadvallarining umumiy chastotalari yo‘q
diag-write-beyond-hold-or-beyond-linear-53dc = jadvaldan chiqish mumkin bo‘lgan joyda beyond = "hold" yoki beyond = "linear" yozing yoki qatorlar qo‘shing
diag-no-part-of-this-machine-is-9c3e = bu mashinaning birorta qismi tebranish chastotasi bo‘yicha jadval bilan berilmagan
diag-speeds-at-which-modes-are-counted-0ff8 = tezlik, ularda modalar birin-ketin sanaladi
diag-modes-with-frequencies-outside-the-table-1aa5 = chastotalari "{ $name }" jadvalidan tashqaridagi modalar noma’lum
diag-the-coefficients-of-depend-on-the-57ae = "{ $name }" koeffitsiyentlari tebranish chastotasiga bog‘liq, bu hisob esa bunday qismni qabul qilmaydi
diag-modes-campbell-critical-speeds-forced-response-790a = uni modes, campbell, critical_speeds, forced_response va harmonic_force qabul qiladi; bu hisob uchun faqat tezlik bo‘yicha jadval bering
diag-the-study-needs-the-coefficients-of-3837 = hisobga "{ $name }" qismining { $from } tebranish chastotasidagi koeffitsiyentlari kerak; jadvali { $low } – { $high } oralig‘ini qamraydi
diag-the-study-needs-the-coefficients-of-1fc0 = hisobga "{ $name }" qismining { $from } – { $to } tebranish chastotalaridagi koeffitsiyentlari kerak; jadvali { $low } – { $high } oralig‘ini qamraydi
diag-keep-to-frequencies-of-the-table-734e = jadval chastotalarida qoling, jadvalga qatorlar qo‘shing yoki "{ $name }" qismida beyond = "hold" yoki beyond = "linear" yozing: jadvaldan tashqaridagi natijalar belgilab ko‘rsatiladi

## laval/src/study/shared/support.rs

diag-with-roots-are-counted-where-they-c786 = { $name } bo‘lganda faqat o‘suvchi ildizlar sanaladi: noldan kichik growth_threshold qiymatidan sekin so‘nadigan ildiz bor-yo‘qligi noma’lum
diag-give-a-growth-threshold-of-0-2976 = growth_threshold uchun 0 yoki undan katta qiymat bering; harakat qanchalik tez so‘nishini transient hisobi ko‘rsatadi
diag-this-study-needs-a-spin-speed-9f43 = bu hisobga aylanish tezligi kerak
diag-give-speed-3000-rpm-here-or-331c = speed = "3000 rpm" kalitini shu yerda yoki barcha hisoblar uchun bir marta [machine] blokida bering
diag-give-two-values-that-differ-9f93 = ikkita har xil qiymat bering
diag-modes-forced-response-stability-map-and-3533 = { $help }; modes, forced_response, stability_map va transient bitta tezlikni qabul qiladi
diag-is-one-value-and-this-study-31a8 = { $field }: bitta qiymat berilgan, bu hisobga esa oraliq kerak
diag-write-2145 = { $field } = {"{"} from = .., to = .. {"}"} ko‘rinishida yozing
diag-must-go-from-a-lower-to-a4b0 = { $field } kichik qiymatdan katta qiymatga borishi kerak
diag-needs-ends-farther-apart-bf86 = { $field }: uchlar orasi kattaroq bo‘lishi kerak
diag-is-too-narrow-its-ends-differ-11bf = { $field } juda tor: uchlarining farqi milliarddan birdan kichik
diag-needs-at-least-points-6b87 = { $field }: kamida { $least } ta nuqta kerak
diag-leave-points-out-for-a-fitting-7f88 = mos son tanlanishi uchun points kalitini olib tashlang
diag-requires-points-which-are-too-many-10f6 = { $field }: { $points } ta nuqta talab qilinadi, bu juda ko‘p
diag-at-most-points-a673 = ko‘pi bilan { $most } ta nuqta

## laval-solve/src/ensemble/mod.rs

diag-has-memory-states-which-an-explicit-422f = "{ $name }" qismida xotira holatlari bor, oshkor usul ularni kuzata olmaydi
diag-use-method-stiff-baf2 = method = "stiff" ishlating

## laval-solve/src/harmonic/balance/refused.rs

diag-order-of-the-motion-would-lie-2fd8 = harakatning tartibi ({ $orders }) { $speed } tezlikda { $name } qismining uzluksiz spektriga ({ $waves }), { $a } – { $b } oralig‘iga tushadi; u yerda barqaror javob yo‘q
diag-orders-of-the-motion-would-lie-8d8e = harakatning tartiblari ({ $orders }) { $speed } tezlikda { $name } qismining uzluksiz spektriga ({ $waves }), { $a } – { $b } oralig‘iga tushadi; u yerda barqaror javob yo‘q
diag-with-symmetry-half-where-the-law-928a = { $remedy }; symmetry = "half" bo‘lganda, kuch qonuni bunga yo‘l qo‘ysa, faqat toq tartiblar qatnashadi
diag-the-machine-has-no-periodic-motion-32a0 = biror tartibda mashinaning davriy harakati yo‘q: { $why }
diag-a-body-without-any-spring-drifts-536a = birorta ham prujinasi yo‘q jism siljib ketadi; massasi, so‘ndirishi va bikrligi yo‘q koordinata aniqlanmagan

## laval-solve/src/harmonic/branches/response.rs

diag-the-machine-is-symmetric-by-any-0931 = mashina ixtiyoriy burilishga simmetrik: uning harakati doiraviy, faqat 1-tartibli deb hisoblanadi, ular orasida rotorning { $divisor } ta aylanishidagi harakat yo‘q
diag-leave-subharmonic-out-or-write-symmetry-70a8 = subharmonic kalitini olib tashlang yoki ko‘proq tartibni saqlash uchun symmetry = "none" yozing
diag-leave-subharmonic-out-or-write-symmetry-a746 = subharmonic kalitini olib tashlang yoki ko‘proq tartibni saqlash uchun symmetry = "half" yoki "none" yozing
diag-the-machine-has-no-symmetry-by-0c76 = mashinada "{ $symmetry }" simmetriyasi yo‘q: "{ $part }" qismi burilganda o‘zgaradi
diag-the-machine-has-no-symmetry-by-3964 = mashinada "{ $symmetry }" simmetriyasi yo‘q
diag-use-symmetry-auto-this-machine-is-2aec = symmetry = "auto" ishlating; bu mashinaning simmetriyasi: { $symmetry }
diag-the-response-cannot-be-followed-ba98 = javobni kuzatib bo‘lmaydi: { $e }
diag-no-periodic-motion-was-found-at-47e1 = { $lo } tezlikda ham, { $hi } tezlikda ham davriy harakat topilmadi
diag-integrate-the-machine-in-time-transient-0e26 = mashinani vaqt bo‘yicha integrallang (transient, sweep): uning harakati bir aylanishdan keyin takrorlanmasligi yoki umuman takrorlanmasligi mumkin

## laval-solve/src/harmonic/free/backbone.rs

diag-all-parts-of-this-machine-are-e65c = bu mashinaning barcha qismlari chiziqli: erkin pretsessiyalarining chastotasi har qanday amplitudada bir xil
diag-use-modes-or-campbell-for-these-cd7a = bu chastotalar uchun modes yoki campbell hisobidan foydalaning
diag-the-family-cannot-be-followed-5ca8 = oilani kuzatib bo‘lmaydi: { $e }
diag-the-asymptotes-could-not-be-computed-1ebf = asimptotalarni hisoblab bo‘lmadi: { $why }

## laval-solve/src/harmonic/free/cycles.rs

diag-all-parts-of-this-machine-are-26e6 = bu mashinaning barcha qismlari chiziqli: noturg‘un tezliklarda pretsessiyasi cheksiz o‘sadi
diag-use-stability-map-for-the-ranges-5a82 = noturg‘un tezliklar oraliqlari uchun stability_map hisobidan foydalaning
diag-nothing-damps-this-machine-its-free-59a9 = bu mashinada so‘ndirish yo‘q: erkin pretsessiyalari har qanday amplitudali oilalarni hosil qiladi, ularning birortasi ham limit sikl emas
diag-use-backbone-for-the-families-or-b5f7 = oilalar uchun backbone hisobidan foydalaning yoki mashinaga so‘ndirish bering ({ $by })
diag-use-backbone-for-the-families-or-cf95 = oilalar uchun backbone hisobidan foydalaning yoki mashinaga so‘ndirish bering
diag-the-cycles-cannot-be-followed-0df2 = sikllarni kuzatib bo‘lmaydi: { $e }

## laval-solve/src/harmonic/free/whirl.rs

diag-the-force-of-depends-on-the-5b01 = "{ $name }" qismining kuchi rotor burchagiga yoki vaqtga bog‘liq: bu mashinaning erkin harakati yo‘q
diag-use-nonlinear-response-for-the-motion-1f45 = majburiy harakat uchun nonlinear_response yoki transient hisobidan foydalaning

## laval-solve/src/harmonic/loci/existence.rs

diag-choose-another-range-of-the-parameter-8d88 = parametrning boshqa oralig‘ini tanlang
diag-the-machine-does-not-exist-at-9578 = { $path } parametrining sinalgan birorta qiymatida ham mashina mavjud emas: { $why }
diag-the-machine-does-not-exist-at-b3f3 = { $path } parametrining sinalgan birorta qiymatida ham mashina mavjud emas
diag-the-machine-exists-at-a-single-e5fd = bu oraliqda mashina { $path } parametrining yagona qiymatida mavjud

## laval-solve/src/harmonic/loci/search.rs

diag-the-locus-cannot-be-followed-7127 = chiziqni kuzatib bo‘lmaydi: { $e }

## laval-solve/src/harmonic/stability/floquet.rs

diag-has-no-time-domain-form-4e95 = "{ $part }" qismining vaqt sohasidagi shakli yo‘q: { $why }
diag-the-machine-has-first-order-states-7ed4 = mashinada { $n } ta birinchi tartibli holat bor, bu davr akslantirishi uchun juda ko‘p
diag-the-force-of-jumps-when-it-ebe9 = tegish paytida "{ $part }" qismining kuchi sakraydi, bunday sakrashning g‘alayonga ta’siri hisoblanmaydi
diag-a-coordinate-has-no-mass-1332 = biror koordinataning massasi yo‘q

## laval-solve/src/motion/direct.rs

diag-the-spin-angle-451f = aylanish burchagi
diag-the-mass-matrix-is-singular-no-91ea = massa matritsasi singulyar: { $place } uchun o‘z inersiyasi qolmaydi
diag-the-mass-matrix-has-an-entry-344a = massa matritsasida chekli bo‘lmagan element bor ({ $place })

## laval-solve/src/motion/mod.rs

diag-the-machine-has-no-equations-of-754e = mashinaning harakat tenglamalari yo‘q: { $what }
diag-no-places-of-the-coordinates-without-3d01 = inersiyasiz koordinatalarning hech bir joyida kuchlar muvozanatlashmaydi
diag-without-inertia-no-damping-or-stiffness-fdb8 = inersiyasiz { $place } ni na dempferlash, na bikrlik belgilaydi
diag-a-coordinate-follows-from-inertia-or-9b2d = koordinata inersiyadan, inersiyasiz esa uni ushlab turuvchi dempfer yoki prujinadan aniqlanadi: u tegishli bo‘lgan qismga massa bering yoki uni ushlab turing, erkin aylanishga esa o‘qqa nisbatan inersiya momenti bering

## laval-solve/src/motion/trajectory.rs

diag-the-motion-cannot-be-computed-from-98a8 = harakatni boshlang‘ich shartidan hisoblab bo‘lmaydi: { $what }

## laval-solve/src/pencil.rs

diag-is-given-in-the-frequency-domain-f133 = "{ $name }" qismi faqat chastota sohasida berilgan: { $why }
diag-forced-response-works-with-it-and-dda6 = bu qism bilan forced_response hisobi ishlaydi, qism qayerda analitik ekanini ko‘rsatsa, muvozanat holati atrofidagi modes ham
diag-the-modes-at-could-not-be-a843 = { $speed } tezlikdagi modalarni hisoblab bo‘lmadi: { $e }
diag-a-coordinate-with-neither-mass-damping-44a1 = massasi ham, so‘ndirishi ham, bikrligi ham yo‘q koordinata tufayli modalar aniqlanmaydi

## laval-solve/src/programme.rs

diag-the-speeds-must-be-finite-and-08cc = tezliklar chekli, o‘zgarish davomiyligi musbat bo‘lishi kerak
diag-an-exponential-change-never-reaches-or-b31b = eksponensial o‘zgarish nol tezlikka hech qachon yetmaydi va undan boshlanmaydi: ikkala tezlikning ishorasi bir xil bo‘lishi kerak
diag-a-polynomial-of-the-speed-has-15d4 = tezlik polinomida 1 – { $most } ta koeffitsiyent bo‘ladi; berilganlari { $given } ta
diag-the-coefficients-must-be-finite-and-99d2 = koeffitsiyentlar chekli, o‘zgarish davomiyligi musbat bo‘lishi kerak
diag-a-table-of-speeds-needs-at-8eba = tezliklar jadvalida kamida ikki nuqta, tezliklar soni esa vaqtlar soniga teng bo‘lishi kerak
diag-times-and-speeds-must-be-finite-3507 = vaqtlar va tezliklar chekli bo‘lishi kerak
diag-the-times-must-increase-is-followed-8e71 = vaqtlar ortib borishi kerak; { $first } vaqtdan keyin { $second } berilgan
diag-the-speed-changes-faster-than-can-3094 = tezlik hisoblash mumkin bo‘lganidan tezroq o‘zgaradi

## laval-solve/src/rest.rs

diag-the-machine-has-no-rest-the-72b5 = mashinaning tinch holati yo‘q: "{ $name }" qismining kuchi rotor bilan birga aylanadi
diag-transient-gives-the-motion-in-time-681b = vaqt bo‘yicha harakatni transient hisobi beradi
diag-stationary-gives-the-states-that-turn-c025 = rotor bilan birga aylanuvchi holatlarni va ularning turg‘unligini stationary, vaqt bo‘yicha harakatni transient va run_up hisoblari beradi
diag-transient-and-run-up-give-the-0238 = vaqt bo‘yicha harakatni transient va run_up hisoblari beradi
diag-cannot-be-linearised-at-rest-01cd = "{ $name }" qismini muvozanat holati atrofida chiziqlantirib bo‘lmaydi: { $reason }
diag-use-a-nonlinear-study-or-one-c104 = chiziqsiz hisobdan yoki vaqt bo‘yicha hisobdan foydalaning, yoxud qismga dastlabki taranglik bering
diag-the-machine-has-no-equilibrium-under-d65d = mashinaning yuk ostida muvozanat holati yo‘q: biror koordinatani hech qanday bikrlik ushlab turmaydi
diag-attach-a-bearing-shaft-or-foundation-b11e = yuk ko‘taradigan har bir jismga podshipnik, val yoki poydevor biriktiring; erkin harakatlanadigan massalarning, masalan balansir sharchalarining, tinch muvozanat holati bo‘lmaydi: { $free }
diag-no-equilibrium-was-found-newton-s-d993 = muvozanat holati topilmadi (Nyuton usuli { $step } xarakterli o‘lchamga teng qadamda to‘xtadi)
diag-check-the-load-and-the-characteristics-cdab = yukni va chiziqsiz qismlar xarakteristikalarini tekshiring yoki boshqa holatdan boshlang

## laval-solve/src/roots.rs

diag-a-part-without-time-form-is-6af5 = vaqt sohasidagi shakli yo‘q qism faqat muvozanat holati atrofida chiziqlantiriladi
diag-leave-about-out-067c = about kalitini olib tashlang
diag-does-not-say-where-its-dynamic-c7f1 = "{ $name }" qismi dinamik bikrligi qayerda analitik ekanini ko‘rsatmaydi
diag-without-that-no-roots-can-be-e4c1 = busiz ildizlarni sanab bo‘lmaydi; bu qism bilan forced_response ishlaydi
diag-the-frequencies-of-the-machine-have-ce0d = mashina chastotalarining ildizlarni sanashni boshlash mumkin bo‘lgan chegarasi yo‘q
diag-give-frequency-limit-df65 = frequency_limit bering

## laval-solve/src/co_rotating.rs

diag-from-the-undeflected-machine-no-state-da81 = deformatsiyalanmagan mashinadan boshlab rotor bilan birga aylanuvchi holat topilmadi
diag-the-machine-has-no-state-that-5f47 = mashinaning rotor bilan birga aylanuvchi holati yo‘q: { $reason }
diag-studies-about-rest-about-rest-by-e3da = bunday mashinani muvozanat holati atrofidagi (about = "rest"), garmonik va vaqt bo‘yicha (transient, run_up) hisoblar qabul qiladi
diag-the-machine-has-no-equilibrium-at-cc55 = mashinaning tinch muvozanat holati ham yo‘q: vaqt bo‘yicha harakatni transient va run_up hisoblari beradi
diag-the-weight-of-pulls-to-one-fdd8 = "{ $name }" qismining og‘irlik kuchi bir tomonga tortadi (axis = "horizontal")
diag-differs-in-x-and-y-a4f1 = { $base } x ({ $x } { $unit }) va y ({ $y } { $unit }) bo‘yicha har xil
diag-the-forces-of-do-not-turn-00ed = mashina va holat burilganda "{ $name }" ({ $kind }) qismining kuchlari ular bilan birga burilmaydi

## laval-separation/src/batch.rs

diag-no-path-in-space-5c87 = fazoda yo‘l yo‘q

## laval-separation/src/carried.rs

diag-cups-swing-out-against-a-weight-0f4e = stakanlarning og‘ishi uchun o‘q bo‘ylab og‘irlik kuchi kerak, gorizontal mashinada esa bunday kuch yo‘q; ular mahkamlangan og‘ish burchagini (tilt) bering

## laval-separation/src/law.rs

diag-the-shares-below-must-rise-from-712b = undersize ulushlari 0 dan 1 gacha ortib borishi kerak
diag-the-last-share-below-is-it-e864 = oxirgi undersize ulushi { $last }; u 1 bo‘lishi kerak
diag-the-shares-of-the-classes-must-211d = sinflarning ulushlari manfiy bo‘lmasligi va hammasi nol bo‘lmasligi kerak
diag-values-have-shares-6d11 = { $values } ta qiymatga { $shares } ta ulush berilgan
diag-the-values-must-be-positive-and-34e1 = qiymatlar musbat va qatordan qatorga ortib borishi kerak

## laval-separation/src/motion.rs

diag-the-drag-law-changes-its-piece-c2a7 = qarshilik qonuni { $t } vaqtda bo‘lagini qayta-qayta almashtiradi
diag-the-step-became-too-small-at-f4f4 = { $t } vaqtda qadam juda kichik bo‘lib qoldi
diag-stopped-at-after-steps-69bb = { $t } vaqtda, { $steps } ta qadamdan keyin to‘xtatildi

## laval-separation/src/recovery.rs

diag-stopped-9dac = to‘xtatildi

## laval-separation/src/slowest.rs

diag-no-place-of-the-liquid-is-aad6 = suyuqlikda yo‘l boshlanadigan joy topilmadi

## laval-cli/src/validate.rs

diag-of-cases-are-not-as-their-544a = { $all } ta misoldan { $n } tasi o‘z sahifasidagi ma’lumotga mos emas
diag-there-is-no-case-in-3f6d = { $folder } papkasida misol yo‘q
diag-a-case-is-a-page-topic-2974 = misol TOPIC/CASE.md sahifasidir; uni yozish tartibi docs/validation.md faylida
diag-no-case-has-in-its-name-a164 = nomida { $text } bor misol yo‘q
diag-there-is-no-folder-validation-here-49db = bu yerda va yuqoridagi papkalarda "validation" papkasi yo‘q
diag-run-inside-the-source-repository-of-1fee = laval manba repozitoriysi ichida bajaring yoki misollar papkasini ko‘rsating
diag-laval-cannot-write-fadf = laval: { $path } fayliga yozib bo‘lmaydi: { $e }

## Studies in parts

diag-is-rows-to-are-missing-2dec = { $path } fayli: { $why }; { $first }–{ $last } qatorlar yo‘q
diag-of-rows-are-missing-those-of-2c01 = yo‘q qatorlar soni: { $all } qatordan { $rows }, bo‘laklar raqami { $shown } (jami { $of })
diag-part-of-has-no-rows-d16b = { $number }-qism (jami { $of }): qator yo‘q
diag-part-of-of-rows-are-there-9818 = { $number }-qism (jami { $of }): { $total } qatordan { $done } tayyor
diag-run-the-parts-that-have-not-0f55 = tugamagan qismlarni qayta ishga tushiring; k bo‘lagi n qismning ((k - 1) mod n) + 1 qismiga tegishli. laval run yetishmaganini hisoblaydi
diag-the-study-is-planned-not-run-a333 = hisob rejalashtirildi, bajarilmadi
diag-lb-is-a-mass-the-force-a3b2 = lb – massa birligi; kuch birligi – lbf: { $meant } deb yozing
diag-write-the-speed-at-which-the-49ba = mashina ishlaydigan aylanish tezligini yozing, masalan speed = "3000 rpm"; u [machine] da berilgan bo‘lsa, speed kalitini olib tashlang
diag-write-the-lowest-speed-at-which-520c = 0 o‘rniga mashina ishlaydigan eng past aylanish tezligini yozing: to‘xtagan holatdan tezlanish bu oraliqqa kirmaydi
diag-give-a-value-b1a9 = ruxsat etilgan qiymatlar: { $bounds }
diag-nothing-holds-the-tilt-of-alone-ad2e = "{ $name }" og‘ishini ({ $names }) hech narsa ushlamaydi, alohida ham, u bilan bog‘langan jismlar bilan birga ham
diag-let-a-shaft-act-on-the-94fc = og‘ishga val ta’sir qilsin (tilt_stiffness yoki dumaloq val), jismni ikki balandlikda ushlang yoki diametral_inertia bermang: shunda u og‘maydi
diag-no-study-of-divides-into-parts-548e = { $file } faylining hech bir tadqiqoti qismlarga bo‘linmaydi
diag-leave-out-part-laval-run-computes-7c4e = --part ni olib tashlang: laval run barcha tadqiqotlarni hisoblaydi
diag-parts-are-requested-and-no-study-4ded = { $of } ta qism so‘raldi, { $file } faylining hech bir tadqiqoti esa { $most } tadan ortiq qismga bo‘linmaydi
diag-number-the-parts-from-1-to-d23e = qismlarni 1/{ $most } dan { $most }/{ $most } gacha raqamlang yoki kamroq oling; har bir tadqiqot qanday bo‘linishini laval plan ko‘rsatadi
diag-is-no-machine-has-less-than-088d = { $who }: { $name } = { $value }; mashinalarda { $least } dan kam bo‘lmaydi
diag-is-no-machine-has-more-than-21e1 = { $who }: { $name } = { $value }; mashinalarda { $most } dan ko‘p bo‘lmaydi
diag-far-outside-a589 = chegaradan ancha tashqarida
diag-check-the-number-and-its-unit-ee7b = son va uning birligini tekshiring; hisob shu qiymat bilan bajariladi
diag-files-of-cases-with-numbers-each-e703 = har birida { $columns } ta son bo‘lgan { $rows } ta holatdan iborat fayllar juda katta: bitta faylda ko‘pi bilan { $most } ta son
diag-the-machine-has-coordinates-and-states-452d = mashinada { $n } ta koordinata va elementlarning { $m } ta holati bor; birgalikda ko‘pi bilan { $most } tasi hisoblanadi
diag-note-threads-cannot-be-started-one-a291 = eslatma: { $wanted } ta oqimni ishga tushirib bo‘lmadi ({ $e }): bittasi hisoblaydi. Nechta oqim kerakligini RAYON_NUM_THREADS aytadi.

# laval-model/src/parts/shaft
diag-the-position-is-not-on-the-d41c = { $position } joyi jismdan tashqarida: jism { $low } dan { $high } gacha
diag-is-a-attach-to-a-disc-9439 = "{ $name }" turi: { $kind }; disk, val yoki poydevorga biriktiring
diag-is-attached-to-itself-by-way-b48c = "{ $name }" boshqa jismlar orqali o‘ziga biriktirilgan
diag-parameters-of-a-reduced-machine-cannot-b5d6 = keltirilgan mashinaning parametrlarini o‘zgartirib bo‘lmaydi
diag-a-shaft-has-1-to-sections-a510 = valning bo‘laklari 1 dan { $most } gacha bo‘ladi
diag-give-each-section-one-entry-in-0a0d = har bir bo‘lakka har bir ro‘yxatda bitta qiymat bering
diag-a-section-is-long-06c8 = bo‘lakning uzunligi { $length }
diag-lengths-are-between-1-m-and-249f = uzunliklar 1 mkm va 1 km orasida
diag-the-outer-diameter-of-a-section-ec18 = bo‘lakning tashqi diametri { $diameter }
diag-diameters-are-between-1-m-and-c7e8 = diametrlar 1 mkm va 100 m orasida
diag-section-the-inner-diameter-must-be-eed5 = { $number }-bo‘lak: ichki diametr tashqisidan kichik bo‘lishi kerak
diag-modulus-and-shear-modulus-make-a-9d86 = modulus va shear_modulus Puasson koeffitsiyentini { $nu } beradi, bunday metall yo‘q: E = 2 G (1 + nu)
diag-is-attached-to-e4e1 = { $kind } "{ $block }" "{ $name }" ga biriktirilgan: { $beyond }
diag-not-on-the-body-23cd = jismda emas
diag-row-has-no-7ab0 = { $who }, { $row }-qator: { $name } yo‘q ({ $doc })
diag-a-compression-of-buckles-it-unless-2945 = { $force } siqish uni egib yuboradi, agar uchlari orasidagi podshipniklar ushlab turmasa: ikkala uchi mahkamlanganda u ko‘pi bilan { $limit } ni ko‘taradi
diag-hold-it-at-a-second-place-041d = uni ikkinchi joyda ushlang: yana bitta podshipnik qo‘shing

# Supports of the rotor
diag-is-not-given-by-mass-gyroscopic-1bec = "{ $name }" massa, giroskopik va bikrlik matritsalari bilan berilmagan va xarita almashtiradigan tayanch emas
diag-name-it-in-supports-if-it-35db = agar u tayanch bo‘lsa, supports maydonida nomlang; aks holda campbell va critical_speeds har qanday qismni qabul qiladi
diag-the-machine-has-no-support-that-86fb = mashinada almashtirsa bo‘ladigan tayanch yo‘q
diag-a-support-is-a-part-with-05ea = tayanch – aylanadigan va aylanmaydigan orasidagi bikrligi bor qism; supports boshqalarini nomlaydi
diag-there-is-no-part-8a0d = "{ $name }" qismi yo‘q
diag-does-not-join-a-turning-body-fc00 = "{ $name }" aylanuvchi jismni hech narsa bilan bog‘lamaydi
diag-parts-that-join-a-turning-body-fe2b = aylanuvchi jismni biror narsa bilan bog‘laydigan qismlar: { $names }
diag-there-is-no-parameter-of-has-463f = "{ $path }" parametri yo‘q: "{ $part }" qismining { $name } ro‘yxatida bitta qator bor
diag-there-is-no-parameter-of-has-193c = "{ $path }" parametri yo‘q: "{ $part }" qismining { $name } ro‘yxatida { $count } ta qator bor
diag-rows-are-numbered-from-1-parameters-b396 = qatorlar 1 dan boshlab raqamlanadi; oxirgisining parametrlari: { $near }
diag-steady-response-at-3e8c = { $speed } tezlikdagi barqaror javob
diag-branch-from-the-lowest-speed-at-2bf4 = eng past tezlikdan boshlangan tarmoq, { $speed } tezlikda
diag-branch-from-the-highest-speed-at-0be3 = eng yuqori tezlikdan boshlangan tarmoq, { $speed } tezlikda
diag-further-branch-at-c050 = boshqa tarmoq, { $speed } tezlikda
diag-stability-of-the-branch-from-the-29af = eng past tezlikdan boshlangan tarmoqning turg‘unligi, { $speed } tezlikda
diag-stability-of-the-branch-from-the-a793 = eng yuqori tezlikdan boshlangan tarmoqning turg‘unligi, { $speed } tezlikda
diag-stability-of-a-further-branch-at-5e02 = boshqa tarmoqning turg‘unligi, { $speed } tezlikda

# laval/src/import, laval-cli/src/import.rs

diag-left-out-there-are-no-lateral-3572 = { $elements }: qoldirildi, ko‘ndalang koeffitsiyentlari yo‘q
diag-between-the-rows-of-a-table-98ce = jadval qatorlari orasida ROSS 2 splayn, laval esa ROSS 3 kabi monoton kubik egri chiziq o‘tkazadi
diag-cone-mid-section-gives-the-cones-61fb = cone = "mid_section" ROSS konuslarini beradi; bu kalitsiz ular tezroq yaqinlashadi
diag-lateral-motion-alone-is-carried-over-869f = faqat ko‘ndalang harakatlar ko‘chirildi; qolganlarini valning axial = true va torsional = true kalitlari qo‘shadi
diag-ross-takes-g-9-8065-m-9851 = ROSS run_static hisobida g = 9.8065 m/s^2 oladi, laval 9.80665 m/s^2 oladi
diag-is-at-node-where-neither-the-2fb9 = { $element } { $node }-tugunda turibdi, u yerda val ham, nuqtaviy massa ham yo‘q
diag-has-no-3dc9 = { $element } ichida { $key } kaliti yo‘q
diag-of-must-be-not-c7c2 = { $element } ichidagi { $key }: { $wanted } kerak, { $shape } emas
diag-a-finite-number-ee7c = chekli son
diag-the-number-of-a-node-from-0b42 = 0 dan { $most } gacha tugun raqami
diag-a-list-of-finite-numbers-3e52 = chekli sonlar ro‘yxati
diag-left-out-5499 = { $elements }: ko‘chirilmadi: { $keys }
diag-a-disc-without-teeth-e596 = { $elements }: tishsiz disk
diag-the-mean-of-mx-and-my-8318 = { $elements }: mx va my o‘rtachasi olindi
diag-the-length-of-must-be-positive-9a7e = { $element } uzunligi musbat bo‘lishi kerak
diag-has-values-of-for-speeds-0087 = { $element } ichida { $key } qiymatlari: { $n }, tezliklar esa: { $wanted }
diag-of-the-coefficients-over-speed-and-9cb9 = { $elements }: tezlik va tebranish chastotasi bo‘yicha koeffitsiyentlardan ikkalasi teng bo‘lganlari olindi
diag-coefficients-over-frequency-are-taken-over-59b6 = { $elements }: tebranish chastotasi bo‘yicha koeffitsiyentlar tezlik bo‘yicha olindi
diag-the-coefficients-are-those-in-the-45ec = { $elements }: koeffitsiyentlar fayldan olindi, geometriya ko‘chirilmadi
diag-in-effect-in-all-studies-ross-43d4 = { $elements }: barcha hisoblarda hisobga olinadi; ROSS run_static hisobida zichlagichlarni hisobga olmaydi
diag-it-is-not-utf-8-text-eb31 = bu UTF-8 matni emas
diag-it-is-not-a-table-of-ed88 = bu elementlar jadvali emas
diag-its-tables-are-nested-too-deeply-59ac = jadvallar juda chuqur joylashtirilgan
diag-this-model-is-no-machine-here-551b = bu model bo‘yicha mashina tuzib bo‘lmaydi: { $why }
diag-this-is-no-model-that-ross-c0a1 = bu ROSS saqlagan model emas: { $why }
diag-rotor-save-rotor-toml-and-rotor-8e3a = ROSS 2 va 3 dagi rotor.save("rotor.toml") va rotor.save("rotor.json") yozgan modellar o‘qiladi
diag-the-file-cannot-be-read-3769 = fayl o‘qilmaydi: { $why }
diag-elements-of-the-kind-are-not-89d8 = { $class } turidagi elementlar ko‘chirilmaydi
diag-elements-that-are-imported-23a2 = ko‘chiriladigan elementlar: { $all }
diag-it-has-no-shaftelement-bf65 = unda ShaftElement yo‘q
diag-no-element-of-the-shaft-lies-e19b = { $k } va { $next } tugunlari orasida val elementi yo‘q
diag-the-shafts-of-several-rotors-in-ca3c = bitta modeldagi bir nechta rotorning vallari ko‘chirilmaydi
diag-the-mass-is-carried-over-as-2fac = { $elements }: massa disk sifatida ko‘chirildi, bikrlik ko‘chirilmadi
diag-of-elements-differs-that-of-is-d2a2 = { $key } farq qiladi (elementlar soni: { $n }); butun val uchun { $first } qiymati olindi
diag-rotary-inertia-and-gyroscopic-are-on-f7ff = rotary_inertia va gyroscopic barcha elementlarda yoqilgan; modelda ular o‘chirilgan (elementlar soni: { $n })
diag-left-out-or-different-in-ross-343d = Ko‘chirilmadi yoki ROSS da boshqacha:
diag-and-more-1d3b = { $names } va yana { $n }
diag-add-a-part-of-kind-speed-cc8c = shu nomli kind = "speed_ratio" qismini va uning mashina aylanish chastotasiga nisbatini qo‘shing
diag-spins-of-this-machine-d82c = bu mashinaning aylanishlari: { $spins }
diag-turns-with-the-spin-which-does-1f6e = "{ $slot }" "{ $name }" aylanishi bilan aylanadi, bunday aylanish esa yo‘q
diag-a-coupling-joins-shafts-of-one-3e2d = mufta bir xil chastotada aylanadigan vallarni ulaydi; har xil chastotadagi vallar orasida tishli uzatma yoki podshipnik kerak
diag-a-wheel-sits-on-a-turning-8ee2 = g‘ildirak aylanadigan jismda o‘tiradi, yerda emas
diag-name-the-two-shafts-or-discs-cbce = g‘ildiraklar o‘tirgan ikki val yoki diskni ayting
diag-the-second-body-turns-times-as-56df = ikkinchi jism birinchidan { $ratio } marta tez aylanadi, radiuslar bo‘yicha esa { $needed } marta; unga shu nisbatdagi aylanish bering
diag-a-spin-of-ratio-0-stands-f193 = nisbati 0 bo‘lgan aylanish joyida turadi: aylanmaydigan qismlarga u kerak emas
diag-this-study-knows-one-spin-and-77ac = bu hisobga bitta aylanish kerak, mashinada esa boshqasi bor, "{ $name }"
diag-contact-angle-is-given-without-balls-aa45 = contact_angle balls-siz berilgan
diag-a-coefficient-holds-the-angle-already-7b11 = koeffitsiyent burchakni hisobga oladi: contact_angle ni olib tashlang
diag-the-bearing-has-no-contact-coefficient-5cac = podshipnikning kontakt koeffitsiyenti yo‘q
diag-give-coefficient-or-balls-and-ball-ccc8 = coefficient yoki balls va ball_diameter bering
diag-coefficient-is-given-beside-the-geometry-f29d = coefficient sharchalar geometriyasi bilan birga berilgan
diag-balls-is-given-without-ball-diameter-a70a = balls ball_diameter-siz berilgan
diag-ball-diameter-is-given-without-balls-6beb = ball_diameter balls-siz berilgan
diag-the-contact-coefficient-must-be-positive-11f4 = kontakt koeffitsiyenti musbat bo‘lishi kerak
diag-the-ratio-of-the-stiffnesses-is-f766 = bikrliklar nisbati 8–16 dumalash jismi uchun ma’lum, { $count } uchun emas
diag-give-ratio-the-stiffness-across-the-9a5b = ratio bering: yuklamaga ko‘ndalang bikrlikning bo‘ylama bikrlikka nisbati; taranglangan ko‘p dumalash jismida u 1 ga yaqin
diag-the-ratio-of-the-stiffnesses-is-dd9f = bikrliklar nisbati 8–16 dumalash jismi uchun ma’lum
diag-layer-goes-from-to-e940 = { $number }-qatlam { $from } dan { $to } gacha
diag-it-lies-on-the-shaft-from-d944 = u valda, pastki uchidan yuqorisigacha: 0 va { $length } orasida
diag-layer-the-inner-diameter-must-be-f017 = { $number }-qatlam: ichki diametr tashqisidan kichik bo‘lishi kerak
diag-inner-diameter-is-that-of-the-d9f3 = vtulkaning inner_diameter qiymati uning ostidagi val diametri
diag-layer-has-no-material-modulus-shear-103d = { $number }-qatlamning materiali yo‘q: modulus, shear_modulus va density qattiq jismni beradi, stiffness — 0 dan 1 gacha ulush
diag-leave-out-what-it-has-in-944a = val bilan umumiy qiymatlarini bermang; stiffness = 0 — faqat massali qatlam
diag-layer-overlaps-the-shaft-at-its-d014 = { $number }-qatlam { $position } da val bilan kesishadi: ichki diametri { $inner }, valning u yerdagi tashqi diametri { $outer }
diag-a-layer-of-the-shaft-with-e9c1 = { $elements }: umumiy siljish burchakli val qatlami; ROSS da har qatlamniki o‘ziniki
diag-separation-margins-need-an-operating-speed-78a5 = chastota zaxiralari uchun ish chastotasi kerak
diag-give-speed-in-machine-or-the-6a56 = [machine] da speed yoki [operation] da ish chastotalari diapazonini bering
diag-frequency-belongs-to-one-spin-speed-36ee = frequency bitta aylanish chastotasiga tegishli
diag-give-one-speed-or-order-in-c27b = bitta chastota yoki frequency o‘rniga order bering
diag-order-and-frequency-both-say-how-ed69 = order ham, frequency ham kuch chastotasini beradi
diag-leave-one-of-them-out-0b3f = birini olib tashlang
diag-separation-margins-are-those-of-a-5324 = chastota zaxiralari aylanish chastotalari diapazoniga tegishli
diag-leave-frequency-out-and-give-a-f93a = frequency ni olib tashlab, aylanish chastotalari diapazonini bering
diag-responses-at-values-of-coordinates-e18e = { $n } koordinataning { $values } qiymatdagi javoblari
diag-the-point-on-which-the-force-7c2b = kuch qo‘yilgan nuqta o‘qqa ko‘ndalang harakatlanmaydi
diag-name-a-point-of-a-disc-206e = disk, val yoki poydevor nuqtasini ayting
diag-up-to-is-below-the-anticipated-90ef = up_to kutilgan { $anticipated } bikrlikdan kichik
diag-give-a-larger-up-to-or-f72d = kattaroq up_to bering yoki olib tashlang
diag-no-lateral-mode-of-this-machine-bf9e = bu mashinaning tebranma ko‘ndalang modasi yo‘q
diag-cross-coupled-stiffness-makes-lateral-modes-69e4 = kesishma bikrlik ko‘ndalang modalarni noturg‘un qiladi: modes mashina modalarini sanaydi
diag-roots-to-follow-61c7 = kuzatiladigan ildizlar
diag-no-mode-becomes-less-stable-with-f0e4 = bikrlik bilan hech bir moda turg‘unligini yo‘qotmaydi, shuning uchun eng kattasini taklif qilib bo‘lmaydi
diag-give-up-to-2dd8 = up_to bering
diag-is-fixed-to-which-turns-with-7c07 = "{ $slot }" "{ $body }" jismiga mahkamlangan, u esa boshqa aylanish bilan aylanadi
diag-leave-spin-out-it-turns-with-b814 = spin maydonini olib tashlang: jism mahkamlangan jism bilan birga aylanadi; yoki unga o‘z koordinatalarini va orasiga podshipnik bering
diag-modes-campbell-critical-speeds-stability-map-4ae2 = bir necha aylanishga modes, campbell, critical_speeds, stability_map, forced_response, harmonic_force, static, transient va run_up yo‘l qo‘yadi
diag-says-how-couplings-are-aligned-and-e84a = { $field } muftalarni markazlashga tegishli, couplings maydonida esa birortasi nomlanmagan
diag-name-couplings-or-remove-fddd = couplings maydonida muftalarni nomlang yoki { $field } maydonini olib tashlang
diag-joins-no-shaft-that-bends-to-a48c = "{ $name }" egiladigan valni boshqa jism bilan ulamaydi
diag-name-a-coupling-between-two-shafts-cfbb = ikki val orasidagi muftani yoki joyni nomlang, masalan "shaft at 1200 mm"
diag-couplings-names-which-is-neither-a-b851 = couplings maydoni "{ $name }" nomini beradi, bu esa na qism, na valning joyi
diag-a-place-of-a-shaft-is-497d = valning joyi "shaft at 1200 mm" ko‘rinishida yoziladi
diag-is-no-node-of-the-shaft-5235 = { $name } valning tuguni emas: eng yaqini { $near } joyida
diag-end-a-section-of-the-shaft-39cd = val bo‘lagini shu joyda tugating
diag-loads-of-couplings-vanish-only-with-76f3 = muftalarning { $needed } ta yuklamasi shuncha siljiydigan tayanch bo‘lgandagina yo‘qoladi, ular esa { $free } ta
diag-name-fewer-couplings-keep-fewer-supports-5374 = kamroq mufta nomlang, kamroq tayanchni qoldiring yoki aligned_for = "moment" ni tanlang
diag-and-support-the-same-place-with-773a = "{ $a }" va "{ $b }" bitta joyni turli siljish bilan tutib turadi
diag-give-them-the-same-offsets-or-ca7d = ularga bir xil siljish bering yoki bittasini supports maydonida nomlang
diag-needs-an-operating-speed-which-neither-3164 = { $field } uchun ish tezligi kerak, u esa na [operation] da, na [machine] da berilgan

# constant forces, spins without parts, supports named twice
diag-this-part-does-nothing-give-a-ce05 = bu qism hech narsa qilmaydi: kuch yoki moment bering
diag-this-force-was-built-without-d9df = bu kuch { $name } siz qurilgan
diag-the-moment-of-has-no-effect-5998 = "{ $name }" momenti ta’sir qilmaydi: u ta’sir qiladigan jism og‘maydi
diag-no-part-turns-with-c0c8 = "{ $name }" bilan hech bir qism aylanmaydi
diag-name-it-in-a-shaft-or-b28c = uni val yoki diskda nomlang: spin = "{ $name }"
diag-is-named-twice-b544 = "{ $name }" ikki marta nomlangan
diag-joins-two-points-of-one-body-7eda = "{ $name }" bitta jismning ikki nuqtasini bog‘laydi
diag-a-bearing-or-shaft-joins-a-78c9 = podshipnik yoki val jismni boshqa jism yoki "ground" bilan bog‘laydi
diag-a-gear-joins-the-rotations-of-7f02 = uzatma ikki jismning aylanishini bog‘laydi: ikkalasiga ham torsional = true bering
diag-layers-and-are-in-the-same-4df9 = { $first } va { $second } qatlamlar { $position } da bir joyda yotadi
diag-names-a-point-that-does-not-8b5a = { $field } "{ $n }" nuqtani ko‘rsatadi, "{ $body }" jismida bunday nuqta yo‘q
diag-it-reaches-from-to-517d = u { $from } dan { $to } gacha cho‘zilgan
diag-not-read-as-no-element-of-a77e = { $elements }: o‘qilmadi, bunday turdagi elementlarda bunday kalit yo‘q: { $keys }
diag-turns-times-as-fast-as-the-880f = "{ $name }" mashinadan { $ratio } marta tez aylanadi, jadvali shu tezlik bo‘yicha beriladi: manfiy tezliklar va shu yo‘nalishdagi kesishma koeffitsientlarni yozing
diag-the-file-has-no-number-bda7 = faylda "{ $path }" soni yo‘q
diag-two-changes-are-of-the-same-1bd6 = ikkita o‘zgarish faylning bir joyiga tegishli
diag-is-not-written-in-the-file-f870 = { $path } faylda yozilmagan
diag-is-no-quantity-296e = { $text } – kattalik emas
diag-a-critical-speed-has-an-order-339b = kritik aylanish chastotasining tartibi 0 dan katta va chastotasi bo‘ladi
diag-there-is-no-such-critical-speed-ea55 = { $at } yaqinida bunday kritik aylanish chastotasi yo‘q
diag-a-limit-of-stability-has-a-12c8 = turg‘unlik chegarasining aylanish chastotasi bo‘ladi
diag-there-is-no-limit-of-stability-8182 = { $at } yaqinida turg‘unlik chegarasi yo‘q
diag-is-released-twice-f3c3 = { $path } ikki marta bo‘shatilgan
diag-the-released-range-must-hold-the-a291 = { $path }: bo‘shatilgan oraliqda fayldagi qiymat bo‘lishi kerak
diag-no-parameter-is-released-bfda = birorta parametr bo‘shatilmagan
diag-the-wanted-value-is-no-number-92b4 = istalgan qiymat son emas
diag-the-released-parameters-do-not-move-1fda = bo‘shatilgan parametrlar bu natijani siljitmaydi
diag-the-search-ended-at-beyond-this-d436 = qidiruv { $value } da tugadi: undan narida bu natija yo‘q yoki bo‘shatilgan parametrlarga ergashmaydi
diag-is-the-nearest-that-can-be-c523 = yetish mumkin bo‘lgan eng yaqin qiymat – { $value }: { $names } o‘z chegarasida
diag-is-the-nearest-that-can-be-c685 = yetish mumkin bo‘lgan eng yaqin qiymat – { $value }: { $names } o‘z chegaralarida
diag-the-machine-of-the-file-does-df10 = fayldagi mashinada bunday natija yo‘q
diag-the-machine-file-gives-no-speed-4340 = mashina faylida aylanish chastotasi berilmagan
diag-the-figure-cannot-be-drawn-666c = rasmni chizib bo‘lmaydi: { $e }
diag-one-of-value-and-written-is-a69e = { $path }: value yoki written kerak, ikkalasi birga emas
diag-is-no-machine-file-toml-in-cfe5 = { $name } – studiya papkasidagi mashina fayli (.toml) emas
diag-is-larger-than-mb-3ad7 = { $path } { $size } MB dan katta
diag-has-changed-on-the-disk-since-3764 = { $path } ochilgandan keyin diskda o‘zgargan
diag-there-is-no-result-that-can-f05c = siljitish mumkin bo‘lgan { $what } natijasi yo‘q
diag-the-request-cannot-be-read-8f3c = so‘rovni o‘qib bo‘lmaydi: { $e }
diag-this-is-a-defect-of-the-4010 = bu faylning emas, dasturning xatosi: hisob bajarilmadi
diag-there-is-no-such-run-165f = bunday hisob yo‘q
diag-the-machine-has-no-such-study-f80c = mashinada bunday tadqiqot yo‘q
diag-the-study-cannot-be-started-3c9f = tadqiqotni boshlab bo‘lmaydi: { $e }
diag-the-report-cannot-be-drawn-a076 = hisobotni tuzib bo‘lmaydi: { $e }
diag-the-server-cannot-be-started-9a0d = serverni ishga tushirib bo‘lmaydi: { $e }
diag-a-token-has-at-least-8-da81 = manzil sirida kamida 8 ta harf va raqam bo‘ladi
diag-cannot-open-9fcf = { $path } ochilmaydi: { $e }
diag-at-most-designs-fit-into-one-c17c = bitta faylga ko‘pi bilan { $most } ta variant sig‘adi
diag-there-is-no-example-1e32 = { $name } misoli yo‘q
diag-name-a-file-or-an-example-9b54 = fayl yoki misolni nomlang
diag-is-no-machine-file-its-name-3c42 = { $path } – mashina fayli emas: nomi .toml bilan tugamaydi
diag-the-studio-is-open-in-the-faee = Studiya brauzerda ochildi; Ctrl-C uni tugatadi.
diag-note-no-browser-could-be-opened-e857 = eslatma: brauzer ochilmadi; yuqoridagi manzilni oching
diag-the-request-names-no-motion-2e64 = so‘rovda harakat ko‘rsatilmagan
diag-the-response-has-no-bound-at-244c = bu tezlikda javob chegaralanmagan: so‘ndirishsiz rezonans
diag-no-state-of-the-nonlinear-response-5f5e = bu tezlikda chiziqsiz javobning holati topilmadi
diag-the-file-has-no-transient-e71e = faylda { $name } nomli transient hisobi yo‘q
diag-the-result-at-cannot-be-moved-edb0 = { $stated } dagi natijani siljitib bo‘lmaydi: kuzatish mumkin bo‘lgan eng yaqini { $found } da
diag-is-a-link-out-of-its-b2fe = { $path } — o‘z jildidan tashqariga havola
diag-port-cannot-be-used-ed07 = { $port } portidan foydalanib bo‘lmaydi: { $e }
diag-give-another-port-or-leave-port-5c64 = boshqa port ko‘rsating yoki --port yozmang: bo‘sh port olinadi
