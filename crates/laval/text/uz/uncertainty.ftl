# Taqsimotlar.
uncertainty-distribution = "{ $quantity }" kattaligining o‘rta qiymati { $value }{ $spread ->
        [known] , standart chetlanishi { $deviation }
       *[none] {""}
    }.{ $quantiles ->
        [outer] {" "}Namunalarning { $lower } qismi { $low } qiymatidan kichik, { $upper } qismi { $high } qiymatidan kichik.
       *[none] {""}
    }{ $found ->
        [some] {" "}U { $samples } ta namunadan faqat { $count } tasida mavjud.
       *[all] {""}
    }
uncertainty-more = yana { $count } ta
uncertainty-more-numbers = "{ $table }" jadvalida yana { $count } ta kattalik bor.
uncertainty-no-numbers = Hisobning taqsimotini topish mumkin bo‘lgan sonli natijasi yo‘q. Sonli natijasi bor hisobni tanlang.
uncertainty-nothing-shown = Birorta ham kattalik "{ $show }" bilan boshlanmaydi, shuning uchun taqsimot chizilmagan. show qiymatini quyidagilardan tanlang: { $quantities }.

# Parametrlarning ta’siri.
uncertainty-most-influential = "{ $quantity }" kattaligi eng ko‘p { $parameter } parametriga bog‘liq: to‘liq indeks { $value }, 95 % ishonch oralig‘i { $low } – { $high }.
uncertainty-most-influential-overlap = Bu namunalarda "{ $quantity }" kattaligi eng ko‘p { $parameter } parametriga bog‘liq: to‘liq indeks { $value }, 95 % ishonch oralig‘i { $low } – { $high }. U boshqa parametrlarning ishonch oraliqlari bilan kesishadi ({ $rivals }); ko‘proq namuna tartibni o‘zgartirishi mumkin.
uncertainty-unresolved-indices = Quyidagi kattaliklarning sezgirlik indekslari aniqlanmagan: { $quantities }. Birinchi tartibli indeks to‘liq indeksdan ko‘pi bilan { $value } katta. Bu tanlanma xatosi. samples qiymatini oshiring.
uncertainty-no-indices = Quyidagi kattaliklarning sezgirlik indekslari yo‘q: { $quantities }. Qiymatlar o‘zgarmas yoki juda kam namunada topilgan.
uncertainty-few-base-points = { $count } ta asosiy nuqta quyidagi kattaliklarning sezgirlik indekslari uchun juda kam: { $quantities }. "indices" jadvalida ularning 95 % ishonch oraliqlari bor. samples qiymatini oshiring.
uncertainty-largest-effect = "{ $quantity }" kattaligini eng ko‘p { $parameter } parametri o‘zgartiradi: o‘rtacha elementar ta’sir { $value }, 95 % ishonch oralig‘i { $low } – { $high }.
uncertainty-largest-effect-few = "{ $quantity }" kattaligini eng ko‘p { $parameter } parametri o‘zgartiradi: o‘rtacha elementar ta’sir { $value }. Namunalar uning ishonch oralig‘i uchun juda kam; samples qiymatini oshiring.

# Haqiqiy natijasi yo‘q namunalar.
uncertainty-failed-samples = { $samples } ta namunadan { $count } tasida natija yo‘q{ $count ->
        [1] {""}
       *[other] , masalan { $first }-namunada
    }: { $reason }. Statistikaga bu namunalar kirmagan.
uncertainty-outside-validity = { $samples } ta namunadan { $count } tasida natija model qo‘llanish sohasidan tashqarida; statistikaga u kiritilgan.
