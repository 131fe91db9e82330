# Aylanish tezligi bo‘yicha o‘z-o‘zidan qo‘zg‘aluvchi pretsessiya.

limit-cycles-no-edge-unstable = Muvozanat holati { $from } – { $to } oralig‘idagi barcha { $speeds } ta tezlikda noturg‘un, o‘sish sur’ati ko‘pi bilan { $value }. Bu oraliqda limit sikl boshlanmaydi; oraliqni kengaytiring yoki so‘ndirish qo‘shing{ $damping ->
        [none] {""}
       *[other] {" "}({ $damping })
    }.
limit-cycles-no-edge = Muvozanat holati { $from } – { $to } oralig‘idagi barcha { $speeds } ta tezlikda turg‘un: o‘z-o‘zidan qo‘zg‘aluvchi pretsessiya boshlanmaydi. G‘alayondan boshlanadigan katta pretsessiyalar istisno emas.
limit-cycles-onset = Tezlik ortganda { $value } tezlikda muvozanat holati { $edge ->
        [onset] noturg‘un
       *[end] turg‘un
    } bo‘ladi: { $whirl ->
        [forward] to‘g‘ri pretsessiya
        [backward] teskari pretsessiya
        [mixed] aralash pretsessiya
       *[none] tebranish
    }, chastotasi { $frequency }.
limit-cycles-hard = Subkritik (keskin) qo‘zg‘alish: { $side ->
        [higher] yuqoriroq
       *[lower] pastroq
    } tezliklarda turg‘un muvozanat holati noturg‘un limit sikl bilan o‘ralgan. Kattaroq g‘alayonlar o‘sadi; u yerda ularni kichik saqlang yoki so‘ndirish qo‘shing.
limit-cycles-soft = Superkritik (yumshoq) qo‘zg‘alish: kichik limit sikl { $side ->
        [higher] yuqoriroq
       *[lower] pastroq
    } tezliklar tomon kattalashadi.
limit-cycles-onset-left = Bu yerdan boshlab limit sikl kuzatib borilmadi: { $why }.
limit-cycles-onset-stopped = Hisob to‘xtaguncha bu yerdan boshlab limit sikl kuzatib borilmadi.
limit-cycles-onset-not-found = Bu yerda limit sikl topilmadi.
limit-cycles-bistable = { $from } – { $to } oralig‘ida bistabil: muvozanat holati ham, amplitudasi ko‘pi bilan { $value } bo‘lgan pretsessiya ham turg‘un. Qaysi biri yuzaga kelishi oldingi harakatga bog‘liq; u yerda katta g‘alayonlardan saqlaning.
limit-cycles-largest = { $family }-oilaning eng katta turg‘un limit sikli: { $body } uchun { $quality ->
        [tilt] og‘ish burchagi
       *[displacement] siljish
    } { $value }, { $speed } tezlikda, pretsessiya chastotasi { $frequency }.
limit-cycles-all-unstable = { $family }-oilaning barcha limit sikllari noturg‘un; birortasi ham saqlanib qolmaydi.
limit-cycles-fold = { $family }-oilaning limit sikllari { $value } tezlikda buklanadi; undan nari bu pretsessiya mavjud emas.
limit-cycles-unbounded = { $value } tezlik yaqinida bu pretsessiya cheksiz o‘sadi: unda chiziqsiz qismlar deyarli deformatsiyalanmaydi va uni cheklay olmaydi. Bu tezliklardan qoching yoki so‘ndirish qo‘shing.
limit-cycles-family-unfinished = { $family }-oilaning limit sikllari faqat { $value } tezlikkacha kuzatildi. { $why }
limit-cycles-stability-unknown = Limit sikllarning turg‘unligi baholanmagan: { $why }. Ular noturg‘un bo‘lishi mumkin.
limit-cycles-bistable-invalid = { $from } – { $to } oralig‘ida bistabil: turg‘un muvozanat holati yonida pretsessiya ham turg‘un. Uning kattaligi haqiqiy emas: { $value } qismning qo‘llanish sohasidan tashqarida. U yerda katta g‘alayonlardan saqlaning.
limit-cycles-largest-invalid = Haqiqiy emas: { $family }-oilaning eng katta turg‘un limit sikli qismning qo‘llanish sohasidan tashqarida. { $speed } tezlikda { $body } uchun hisoblangan { $quality ->
        [tilt] og‘ish burchagi
       *[displacement] siljish
    } { $value } (pretsessiya chastotasi { $frequency }) natija hisoblanmaydi.
limit-cycles-largest-valid = Barcha qismlarning qo‘llanish sohasi ichida uning eng katta qiymati { $size }, { $speed } tezlikda.
