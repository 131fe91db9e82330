# Xaritadagi joy.
motion-map-speed = tezlik { $speed }
motion-map-parameter = { $parameter } = { $value }

motion-map-largest = { $point } uchun eng katta { $quality ->
        [tilt] qiymat
       *[displacement] siljish
    } { $value } ({ $place }).

# Javob qanday takrorlanadi.
motion-map-every-turn = Barqarorlashgan har bir javob har aylanishda takrorlanadi: { $points } ta nuqtadan { $count } tasida.
motion-map-subharmonic = { $points } ta nuqtadan { $count } tasida, masalan { $place } bo‘lganda, javob 1/{ $turns } tartibli subgarmonik.
motion-map-longer-period = { $points } ta nuqtadan { $count } tasida, masalan { $place } bo‘lganda, javob faqat { $turns } tadan ko‘p aylanishdan keyin takrorlanadi.
motion-map-not-periodic = { $points } ta nuqtadan { $count } tasida, masalan { $place } bo‘lganda, javob { $turns } ta aylanish ichida takrorlanmaydi. U yerda javob kvazidavriy, xaotik yoki davri uzunroq.

# Natijasiz nuqtalar.
motion-map-not-settled = { $points } ta nuqtadan { $count } tasida javob most_periods ichida barqarorlashmadi. U yerdagi amplitudalarda o‘tish jarayonlari bo‘lishi mumkin; most_periods qiymatini oshiring.
motion-map-failed-machines = { $points } ta nuqtadan { $count } tasida, masalan { $place } bo‘lganda, parametrlar yaroqli mashinani bermaydi: { $reason }.
motion-map-failed-motions = { $points } ta nuqtadan { $count } tasida, masalan { $place } bo‘lganda, harakat { $reason }. Bu nuqtalarda natija yo‘q.
