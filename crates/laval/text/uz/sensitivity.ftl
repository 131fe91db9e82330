# Eng ko‘p ta’sir qiluvchi parametr.
sensitivity-influence = eng ko‘p { $parameter } parametriga bog‘liq: parametr 1 % oshganda { $change } { $direction ->
        [falls] kamayadi
       *[rises] ortadi
    }
sensitivity-influence-unknown = noma’lum ulushga o‘zgaradi

# Barqaror javobning cho‘qqilari va buklanishlari.
sensitivity-peak = { $point } uchun cho‘qqi { $value } ({ $speed } tezlikda): u { $size-influence }. Cho‘qqi tezligi { $speed-influence }.
sensitivity-jump = { $way ->
        [up] Yuqoriga
       *[down] Pastga
    } sakrash tezligi { $speed }: u { $speed-influence }. U yerda { $point } uchun { $quality ->
        [tilt] qiymat
       *[displacement] siljish
    } { $value }: u { $size-influence }.
sensitivity-nothing-stationary = { $end ->
        [stopped] Hisob to‘xtaguncha
       *[complete] Tezlik oralig‘ida
    } javobning cho‘qqisi ham, buklanishi ham topilmadi.

# Ta’siri yo‘q joylar va parametrlar.
sensitivity-no-derivative-corner = { $value } tezlikda{ $more ->
        [0] {""}
       *[other] {" "}va { $highest } tezlikkacha yana { $more } ta joyda
    } sezgirlik keltirilmaydi: tarmoq kuch qonuni almashinadigan siniq joyda buriladi. U yerda parametrlarni qo‘lda yoki uncertainty hisobi bilan o‘zgartiring.
sensitivity-no-derivative-jump = { $value } tezlikda{ $more ->
        [0] {""}
       *[other] {" "}va { $highest } tezlikkacha yana { $more } ta joyda
    } sezgirlik keltirilmaydi: "{ $part }" qismining kuchi sakraydi. U yerda parametrlarni qo‘lda yoki uncertainty hisobi bilan o‘zgartiring.
sensitivity-no-derivative-open = { $value } tezlikda{ $more ->
        [0] {""}
       *[other] {" "}va { $highest } tezlikkacha yana { $more } ta joyda
    } sezgirlik keltirilmaydi: hosilalar yaqinlashmadi. U yerda parametrlarni qo‘lda yoki uncertainty hisobi bilan o‘zgartiring.
sensitivity-no-influence = Ba’zi joylarda quyidagi parametrlarning ta’siri noma’lum: { $parameters }. U yerda jadvallarda ular oxirida keltirilgan.
sensitivity-without-influence = Keltirilgan cho‘qqilar va buklanishlarga ta’siri yo‘q: { $parameters }.
