# Bir aylanish tezligidagi chiziqsiz normal modalar: chastotaning amplitudaga bog‘liqligi.

backbone-family = { $value } tezlikda { $whirl ->
        [forward] to‘g‘ri pretsessiyali chiziqsiz normal moda
        [backward] teskari pretsessiyali chiziqsiz normal moda
       *[none] chiziqsiz normal moda
    } amplituda ortishi bilan { $trend ->
        [hardens] qattiqlashadi
       *[softens] yumshaydi
    }: chastotasi { $first-amplitude } amplitudada { $first }, { $last-amplitude } amplitudada { $last }.
backbone-family-constant = { $value } tezlikda { $whirl ->
        [forward] to‘g‘ri pretsessiyali chiziqsiz normal modaning
        [backward] teskari pretsessiyali chiziqsiz normal modaning
       *[none] chiziqsiz normal modaning
    } chastotasi { $first-amplitude } – { $last-amplitude } amplitudalar oralig‘ida o‘zgarmaydi.
backbone-turning = U avval { $trend ->
        [hardens] qattiqlashadi
       *[softens] yumshaydi
    }: { $amplitude } amplitudada chastotasi { $frequency }.
backbone-family-beside-asymptote = { $whirl ->
        [forward] To‘g‘ri pretsessiyali chiziqsiz normal moda
        [backward] Teskari pretsessiyali chiziqsiz normal moda
       *[none] Chiziqsiz normal moda
    } { $asymptote } asimptotasi yonida joylashgan, boshida chiziqli moda yo‘q. Chastotasi { $first-amplitude } amplitudada { $value }, so‘ng { $least } qiymatigacha pasayadi va { $last-amplitude } amplitudada { $last } qiymatida tugaydi.
backbone-no-family = Bu tezlikda chiziqsiz normal moda topilmadi.
backbone-undamped = Hisoblangan barcha amplitudalarda modalar so‘nishsiz.
backbone-driven = Mashinada so‘ndirish bor. Bu modalardagi yo‘qotishlarni massaga proporsional manfiy so‘ndirish (ko‘pi bilan { $value }) qoplaydi.
backbone-merged-modes = Chastotasi { $value } bo‘lgan chiziqli modadan chiziqsiz normal moda boshlanmaydi. U qo‘shilib ketgan ikki modaning noturg‘unlik sohasida, o‘sish sur’ati { $growth }; so‘ndirish qo‘shing yoki tezlikni o‘zgartiring.
backbone-asymptotes = Chiziqsiz qismlar absolyut qattiq deb olinsa, { $n ->
        [one] xususiy chastota
       *[other] xususiy chastotalar
    } { $frequencies }. U yerda qattiqlashuvchi mashinaning amplitudasi chegaralanmagan.
backbone-synchronous = { $value } amplitudada bu modaning chastotasi aylanish chastotasiga teng; u yerda disbalans uni qo‘zg‘atadi.
backbone-whirl-ends = Chastotasi { $mode } bo‘lgan moda { $value } amplitudada tugaydi: chastotasi { $frequency } qiymatigacha pasayadi va qaytaruvchi kuch qolmaydi.
backbone-family-unfinished = Chastotasi { $mode } bo‘lgan moda faqat { $value } amplitudagacha kuzatildi. { $why }
