# Turg‘unlik xaritasida nima noturg‘un deb ataladi.
criterion-growth = Mezon: o‘sish sur’ati { $limit } qiymatidan katta.
criterion-growth-of-waves = Mezon: o‘sish sur’ati { $limit } qiymatidan katta. Sekin to‘lqinlarni { $part } modelidan tashqaridagi so‘ndirish o‘stiradi, ko‘pchiligini sezilmas darajada: o‘sish sur’atining ishorasi yolg‘iz o‘zi hal qilmaydi.
criterion-flutter = Mezon: flatter, so‘nishsiz mashinaning ikki chastotasi ustma-ust tushadi. Chegara yaqinida o‘sish sur’ati undan uzoqlikning kvadrat ildiziga proporsional ortadi.
criterion-viscous = Mezon: o‘sish sur’ati { $limit } qiymatidan katta, { $loss } hisobga olingan.
criterion-viscous-range = Mezon: o‘sish sur’ati { $limit } qiymatidan katta, { $loss } hisobga olingan. { $range }
