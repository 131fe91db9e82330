# Bir nechta hisob uchun umumiy iboralar.

list-and = { $rest } va { $last }
list-or = { $rest } yoki { $last }
# Jism, jism nuqtasi, jismning og‘ish burchagi.
body = "{ $body }" jismi
point = "{ $body }" jismining { $height } balandlikdagi nuqtasi
tilt-of = "{ $body }" jismining og‘ish burchagi
# Tezlik oralig‘i.
range = { $from } – { $to } oralig‘ida
at = { $at } tezlikda

# Hisob koeffitsiyentlar jadvalidan tashqariga chiqadi.
beyond-table = "{ $part }" qismining jadvali { $from } – { $to } oralig‘ini qamraydi. { $sides ->
        [both] Undan tashqarida, { $lowest } – { $highest } oralig‘ida,
        [below] Undan pastda, { $lowest } tezlikkacha,
       *[above] Undan yuqorida, { $highest } tezlikkacha,
    } koeffitsiyentlar { $rule ->
        [hold] jadval chetidagi qiymatda saqlanadi
        [linear] jadval chetidagi qiyalik bo‘yicha davom ettiriladi
       *[refuse] noma’lum
    }.
beyond-table-note = "{ $part }" qismining jadvalidan tashqarida.
beyond-table-frequency = "{ $part }" qismining jadvali { $from } – { $to } tebranish chastotalarini qamraydi. { $sides ->
        [both] Undan tashqarida, { $lowest } – { $highest } oralig‘ida,
        [below] Undan pastda, { $lowest } chastotagacha,
       *[above] Undan yuqorida, { $highest } chastotagacha,
    } koeffitsiyentlar { $rule ->
        [hold] jadval chetidagi qiymatda saqlanadi
        [linear] jadval chetidagi qiyalik bo‘yicha davom ettiriladi
       *[refuse] noma’lum
    }.
over-frequency-beyond = { $n ->
        [one] { $modes }-modaning chastotasi
       *[other] { $modes } modalarning chastotalari
    } "{ $part }" qismining { $from } – { $to } oralig‘ini qamraydigan jadvalidan tashqarida: u yerda natija yaroqsiz.
over-frequency-growth-unassessed = Turg‘unlik baholanmadi: bu yerda { $n ->
        [one] { $parts } qismining
       *[other] { $parts } qismlarining
    } koeffitsiyentlari qo‘zg‘atish chastotasiniki. modes yoki campbell tadqiqotidan foydalaning: ularda har bir modada o‘z chastotasining koeffitsiyentlari bo‘ladi.
over-frequency-counted = Har bir modada { $n ->
        [one] { $parts } qismining
       *[other] { $parts } qismlarining
    } koeffitsiyentlari shu modaning o‘z chastotasiniki. { $speeds ->
        [one] Sanoq bo‘yicha
       *[other] { $speeds } ta tezlikdagi sanoq bo‘yicha
    } { $from } – { $to } oralig‘ida birorta ham moda tushib qolmagan.
over-frequency-not-counted = { $speeds ->
        [one] { $from } – { $to } oralig‘ida
       *[other] { $speeds } ta tezlikdan { $open } tasida { $from } – { $to } oralig‘ida
    } modalar tushib qolgan bo‘lishi mumkin: { $n ->
        [one] { $parts } qismining
       *[other] { $parts } qismlarining
    } o‘z chastotasidagi koeffitsiyentlari bilan sanoq topilgan modalarga mos emas. Torroq jadval yoki ko‘proq qator izlashni osonlashtiradi.
over-frequency-outside = { $sides ->
        [both] { $from } chastotadan past va { $to } chastotadan yuqori modalar hisoblanmadi: jadval yoki frequency_limit o‘sha yerda tugaydi
        [below] { $from } chastotadan past modalar hisoblanmadi: jadval o‘sha yerda boshlanadi
       *[above] { $to } chastotadan yuqori modalar hisoblanmadi: jadval yoki frequency_limit o‘sha yerda tugaydi
    }. U yerdagi o‘sish sur’ati noma’lum.

# Mashinani hech narsa qo‘zg‘atmaydi.
unforced = Mashinani hech narsa qo‘zg‘atmaydi: eng katta siljish { $value }, rezonans keltirilmaydi. Diskka ekssentrisitet, disbalans yoki qiyshiqlik bering.

# Chiziqli hisoblar: nima atrofida chiziqlantirilgan.
support-linearised = { $n ->
        [one] Chiziqsiz qism ({ $parts })
       *[other] Chiziqsiz qismlar ({ $parts })
    } { $state ->
        [undeflected] deformatsiyalanmagan holat
       *[deflected] yuk ostidagi muvozanat holati
    } atrofida chiziqlantirilgan. Natijalar kichik tebranishlar uchun o‘rinli.
support-fitted-part = Boshlang‘ich xos qiymatlar "{ $part }" qismining ratsional approksimatsiyasidan olinadi; ular uning aniq impedansi bilan aniqlashtiriladi.
support-open-gap = "{ $part }" qismining tirqishi muvozanat holatida ochiq va bikrlik qo‘shmaydi. Nisbiy siljish { $value } qiymatidan oshganda kontakt boshlanadi.
support-outside = "{ $part }" qismi { $speed } tezlikda tebranishsiz ham qo‘llanish sohasidan tashqarida: { $what } = { $value } (chegara 1).
support-outside-unbounded = "{ $part }" qismi { $speed } tezlikda tebranishsiz ham qo‘llanish sohasidan tashqarida: { $what } chegaralanmagan (chegara 1).

# Qismning qo‘llanish sohasidan tashqaridagi harakatlar.
validity-states = Haqiqiy emas: ba’zi holatlar { $place } "{ $part }" qismining qo‘llanish sohasidan tashqarida ({ $what } = { $value }; chegara 1).
validity-states-unbounded = Haqiqiy emas: ba’zi holatlar { $place } "{ $part }" qismining qo‘llanish sohasidan tashqarida ({ $what } chegaralanmagan; chegara 1).
validity-motions = Haqiqiy emas: ba’zi { $motions } "{ $part }" qismining qo‘llanish sohasidan tashqarida ({ $what } = { $value }; chegara 1).
validity-motions-unbounded = Haqiqiy emas: ba’zi { $motions } "{ $part }" qismining qo‘llanish sohasidan tashqarida ({ $what } chegaralanmagan; chegara 1).

# Argument prinsipi bo‘yicha ildizlar soni.
region-growing-root = o‘suvchi ildiz
region-faster-root = o‘sish sur’ati { $growth } qiymatidan katta ildiz
region-all-roots = Ildizlar soni tekshirilgan (argument prinsipi): { $frequency } chastotadan pastda birorta ham { $root } tushib qolmagan. { $found ->
        [0] Sanalgan sohalarda ildiz yo‘q
        [1] Sanalgan sohalardagi yagona ildiz ma’lum
       *[other] Sanalgan sohalardagi barcha { $found } ta ildiz ma’lum
    }.
region-at-zero = { $count } ta ildiz nolga teng yoki unga juda yaqin: bu — hech narsa tutib turmagan butun mashina yoki uning qismi harakatlari. Ular tebranish shakllari orasida yoʻq.
region-all-modes = { $found ->
        [0] { $frequency } chastotadan pastda moda yo‘q
        [1] { $frequency } chastotadan pastdagi yagona moda hisoblangan
       *[other] { $frequency } chastotadan pastdagi barcha { $found } ta moda hisoblangan
    }; birortasi ham tushib qolmagan (ildizlar soni argument prinsipi bo‘yicha tekshirilgan). Yuqori modalar hisoblanmaydi: mashinada { $states } ta holat o‘zgaruvchisi bor. Chegarani frequency_limit beradi.
region-modes-followed = { $frequency } chastotadan pastdagi barcha modalar kuzatildi: ularning soni { $all } tezlikdan { $speeds } tasida tekshirildi (argument prinsipi). Yuqori modalar hisoblanmaydi; chegarani frequency_limit beradi.
region-modes-not-counted = { $frequency } chastotadan pastda modalar tushib qolgan bo‘lishi mumkin: tekshirilgan tezliklarning { $open } tasida sanash natija bermadi. Boshqa frequency_limit bilan urinib ko‘ring.
region-slower-roots-missed = Ildizlar soni tekshirilgan (argument prinsipi): { $frequency } chastotadan pastda birorta ham { $root } tushib qolmagan. Sanalgan, lekin hisoblanmagan yana { $missing } ta ildiz { $part } modelining sekin to‘lqinlaridan kelib chiqadi.
region-roots-missed = Turg‘unlik isbotlanmagan: { $missing ->
        [1] sanalgan bitta ildiz topilmadi, u
       *[other] sanalgan { $missing } ta ildiz topilmadi, ulardan biri
    } { $root } bo‘lishi mumkin. frequency_limit qiymatini kamaytiring yoki growth_threshold qiymatini noldan katta qiling.
region-roots-not-counted = { $proven ->
        [yes] { $frequency } chastotadan pastda birorta ham { $root } tushib qolmagan, lekin sekinroq ildizlar tushib qolgan bo‘lishi mumkin
       *[no] Turg‘unlik isbotlanmagan, ildizlar tushib qolgan bo‘lishi mumkin
    }: { $all } ta sohadan { $open } tasida sanash bajarilmadi. Boshqa frequency_limit qiymatini sinab ko‘ring.
region-uncounted-roots = { $all } ta ildizdan { $outside } tasi sanalgan sohalardan tashqarida. Ularning yonida boshqa ildizlar tushib qolgan bo‘lishi mumkin.
region-dense-range = { $speed } tezlikda { $part } modelida { $waves } to‘g‘ri pretsessiyaning { $from } – { $to } chastotalar oralig‘ida uzluksiz spektr hosil qiladi. Boshqa joydagi so‘ndirish ulardan ba’zilarini sekin o‘stiradi, shuning uchun faqat chegaraviy qiymatdan tez o‘sish noturg‘unlikni bildiradi. Sekinroq o‘sishni { $loss } belgilaydi, modelda esa u yo‘q.
region-half-plane = Faqat o‘suvchi ildizlar sanaladi. Mashinada { $part } modeli bor, uning so‘nuvchi ildizlari qidiriladi; javobda deyarli sezilmaydigan ildiz tushib qolgan bo‘lishi mumkin.
region-accumulation = O‘sish yoki so‘nish sur’ati { $growth } qiymatidan kichik bo‘lgan { $from } – { $to } oralig‘idagi ildizlar sanalmaydi: { $speed } tezlikda u yerda to‘lqinlar to‘planadi.
region-other-orders = yana { $n } ta
region-orders-without-response = { $n ->
        [one] Javobning tartibi ({ $orders })
       *[other] Javobning tartiblari ({ $orders })
    } uzluksiz spektrga ({ $waves }) tushadi: { $value } tezlikda { $from } – { $to } oralig‘i. U yerda { $part } modelida barqaror javob yo‘q va tenglamalarning yechimi yo‘q. { $remedy }.
region-orders-of-kept-waves = { $n ->
        [one] Javobning tartibi ({ $orders })
       *[other] Javobning tartiblari ({ $orders })
    } uzluksiz spektrga ({ $waves }) tushadi: { $value } tezlikda { $from } – { $to } oralig‘i. U yerda { $part } modelida barqaror javob yo‘q; { $kept }.

# Erta tugagan yoki boshlanmagan hisob.
watch-nothing-shown = Natija yo‘q: hisob qisman natija bermaydigan hisoblash paytida to‘xtatildi.
store-incomplete = Faqat { $done } ta { $rows } hisoblandi, so‘ralgani { $requested } ta.
store-incomplete-kept = Faqat { $done } ta { $rows } hisoblandi, so‘ralgani { $requested } ta. Xuddi shu buyruq hisobni shu joydan davom ettiradi.
run-refused = { $reason }
run-refused-alike = Bu hisob "{ $study }" hisobi bilan bir xil sababga ko‘ra rad etildi.

# Dinamikada hisobga olinmagan idishlar.
cups-not-carried = Dinamikada "{ $vessel }" idishining massasi va disbalansi yo‘q: uni hech qaysi jism ko‘tarmaydi. on = "{ $body }" kalitini mass va centre_of_mass bilan birga qo‘shing.
cups-not-carried-by-any = Dinamikada "{ $vessel }" idishining massasi va disbalansi yo‘q: uni hech qaysi jism ko‘tarmaydi. Jismni on kaliti bilan, mass va centre_of_mass bilan birga qo‘shing.
cups-bowl-without-liquid = Dinamikada "{ $vessel }" idishidagi suyuqlik yo‘q. Baraban jismiga kind = "liquid" bo‘lgan [[part]] qo‘shing yoki massani shu jismga qo‘shing.
