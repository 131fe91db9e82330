# Erkin harakatlarni o‘rganuvchi hisoblar uchun umumiy.

# Harakatlar oilasi nega tugagan. To‘liq gaplar.
free-motion-end = { $why ->
        [unbounded] U yerda amplituda cheksiz o‘sadi.
        [start] Birinchi taxmin yaqinida bunday kattalikdagi harakat topilmadi.
        [work-limit] Ish chegarasiga yetildi.
        [points] Nuqtalarning eng katta soniga yetildi; max_points qiymatini oshiring.
        [cancelled] Hisob so‘rov bo‘yicha to‘xtatildi.
       *[unsolved] Undan nariga tenglamalarni yechib bo‘lmadi; ko‘proq garmonika saqlang.
    }
free-motion-harmonics = Saqlangan garmonikalar eng yomon nuqtada chiziqsiz kuchning { $value } qismini hisobga olmaydi. Harakatning keskin tafsilotlari aniqlanmagan; kuch qonunlarining siniq joylarini silliqlang.
free-motion-harmonics-unknown = Saqlangan garmonikalar hisobga olmagan chiziqsiz kuch ba’zi nuqtalarda noma’lum. U yerdagi amplitudalar va chastotalar tekshirilmagan.
free-motion-unmeasured = { $all } ta harakatdan ({ $motions }) { $value } tasini baholab bo‘lmadi. Ularning amplitudasi va qo‘llanish sohasi noma’lum.
