# Yaqinlashgan javob yonidagi taqribiy usullar.

methods-method = { $method ->
        [harmonic] { $order }-tartibgacha garmonik balans
        [averaging] o‘rtalash
        [elliptic] elliptik balans
        [time] vaqt bo‘yicha integrallash
       *[converged] yaqinlashgan garmonik balans
    }
methods-unstable = Solishtirilgan { $states } ta holatdan { $unstable } tasi noturg‘un; mashina { $unstable ->
        [1] bu holatda
       *[other] bu holatlarda
    } qolmaydi.
methods-deviation = Eng katta xato ({ $method }) eng katta cho‘qqining { $value } qismiga teng, { $speed } tezlikda, { $state }-holatda.
methods-exact = Solishtirilgan tezliklarda cho‘qqilar ({ $method }) yaxlitlash aniqligida yaqinlashgan qiymatlarga teng.
methods-missing = { $states } ta holatdan { $missing } tasi topilmadi.
methods-no-states = Birorta holat ham topilmadi ({ $method }).
methods-averaging-stability = { $wrong ->
        [0] O‘rtalash { $states } ta holatning barchasi uchun turg‘unlikni to‘g‘ri beradi.
       *[other] O‘rtalash { $states } ta holatdan { $wrong } tasi uchun turg‘unlikni noto‘g‘ri beradi, chunki u faqat tezlikka yaqin modani o‘z ichiga oladi.
    }
methods-fold-deviation = Bitta garmonika, shuningdek o‘rtalash, { $speed } tezlikdagi buklanishni { $value } kattalikka suradi.
methods-no-elliptic-balance = Elliptik balans bajarilmadi: { $why }.
methods-no-time-integration = Ba’zi holatlar vaqt bo‘yicha integrallanmadi: { $why }.
methods-one-harmonic-exact = Mashina izotrop: javobi doiraviy va bitta garmonika aniq.
