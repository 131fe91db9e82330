# Vaqt bo‘yicha hisoblar uchun umumiy.

# Yozuvning oxirgi payti, gap ichida.
history-end = oxirida
history-stop = integrallash to‘xtagan { $at } paytida

# Siljishlar.
history-largest = "{ $body }" jismining { $quality ->
        [tilt] muvozanat holatidan eng katta og‘ish burchagi
       *[displacement] muvozanat holatidan eng katta siljishi
    } { $value }.
history-at-equilibrium = "{ $body }" jismi integrallash aniqligi doirasida muvozanat holatida qoladi.
history-only-tilts = "{ $body }" jismi og‘adi, lekin siljishi integrallash aniqligi doirasida muvozanat holatida qoladi.
history-unresolved = "{ $body }" jismi muvozanatdan ko‘pi bilan { $value } ga chetlashadi; bu aniqlikda integrallash uni noldan ajrata olmaydi: relative_tolerance ni kamaytiring.

# Har qanday chegaradan oshadigan harakat.
history-unbounded = "{ $body }" jismining harakati { $speed } tezlikda uzoqlashadi: integrallash tugagan { $at } paytida muvozanat holatidan siljish { $displacement }. Bu tezlikdan qoching yoki so‘ndirish qo‘shing.
history-unbounded-exponential = "{ $body }" jismining harakati { $speed } tezlikda { $value } o‘sish sur’ati bilan uzoqlashadi: integrallash tugagan { $at } paytida muvozanat holatidan siljish { $displacement }. Bu tezlikdan qoching yoki so‘ndirish qo‘shing.
history-unbounded-linear = "{ $body }" jismining harakati { $speed } tezlikda vaqt bo‘yicha chiziqli, { $value } sur’at bilan uzoqlashadi: integrallash tugagan { $at } paytida muvozanat holatidan siljish { $displacement }. Bu tezlikdan qoching yoki so‘ndirish qo‘shing.

# Erta tugagan integrallash.
history-work-limit = { $value } paytida qadamlar chegarasiga (--work-limit) yetildi. Qolganini hisoblash uchun uni oshiring.
history-step-too-small = Integrallash { $value } paytida to‘xtadi, chunki hech qanday qadam kerakli aniqlikni bermaydi. U yerda harakat uzoqlashishi mumkin; boshqa usulni yoki kattaroq relative_tolerance qiymatini sinab ko‘ring.
history-integration-failed = Integrallash { $value } paytida to‘xtadi: { $why }. Undan keyingi harakat yo‘q.

# Qismlarning vaqt sohasidagi ratsional shakllari.
history-reduced = Mashinaning chiziqli qismlari { $coordinates } ta koordinataga keltirildi. { $frequency } chastotagacha boshqa qismlar biriktirilgan joylardagi moyilligi butun mashinanikidan { $value } ga farq qiladi.
history-time-form = Vaqt sohasida "{ $part }" qismi { $states } ta holatli ratsional shakl bilan almashtirilgan. Uning nisbiy xatosi ko‘pi bilan { $value }, { $scope }.
history-time-fit = Vaqt sohasida "{ $part }" qismining chastotaviy xarakteristikasi ratsional approksimatsiya bilan almashtirilgan. Uning nisbiy xatosi { $value }.

# Harakat davomida qismlarning qo‘llanish sohasi.
history-valid = "{ $part }" qismi qo‘llanish sohasida: { $what } ≤ { $value } (chegara 1).
history-valid-after-start = "{ $part }" qismi { $above ->
        [standstill] rotor aylana boshlaganidan keyin
       *[speed] { $speed } tezlikdan yuqorida
    } qo‘llanish sohasida: { $what } ≤ { $value } (chegara 1).
history-valid-while-turning = "{ $part }" qismi { $above ->
        [standstill] rotor aylanayotganda
       *[speed] { $speed } tezlikdan yuqorida
    } qo‘llanish sohasida: { $what } ≤ 1.
history-valid-later = "{ $part }" qismi { $value } paytigacha qo‘llanish sohasidan tashqarida (o‘sha paytdagi tezlik { $speed }): { $what } 1 chegarasidan oshadi. Undan oldingi harakatdan foydalanmang.
history-not-valid = "{ $part }" qismining qo‘llanish sohasidan chiqildi: { $what } = { $value } (chegara 1). Harakat { $first } paytidan boshlab haqiqiy emas.
history-not-valid-unbounded = "{ $part }" qismining qo‘llanish sohasidan chiqildi: { $what } chegaralanmagan (chegara 1). Harakat { $first } paytidan boshlab haqiqiy emas.

# Kontaktlar va tirqishlar.
history-contacts = Almashinuvchi kuch qonunlari { $count } marta tomonini o‘zgartirdi; har bir almashinuv payti aniqlangan.

# Energiya balansi.
history-energy-closes = Energiya balansi almashilgan energiyaning { $value } aniqligida bajariladi.
history-energy-closes-to-rounding = Energiya balansi yaxlitlash aniqligida bajariladi: saqlangan yoki almashilgan energiyaning { $value } qismi.
history-energy-missing = Energiya balansida almashilgan energiyaning { $value } qismi yetishmaydi. Kichikroq relative_tolerance qiymatini oling.
history-energy-out-of-range = Energiya balansi yo‘q: energiyalar sonlar diapazonidan oshadi. U bu harakatni tasdiqlamaydi; uzoqlashishni tekshiring.
history-energy-unknown = Energiya balansi yo‘q: "{ $part }" qismi o‘z energiyasini bermaydi.
