# Vaqt sohasida ratsional shakllari bor mashina ildizlari aniq mashina ildizlari bilan solishtirilgan.

moved-roots-growing = o‘suvchi ildizlar
moved-roots-beyond = o‘sish yoki so‘nish sur’ati { $margin } qiymatidan katta ildizlar
moved-roots = Vaqt sohasidagi ratsional shakllar tufayli { $roots } ko‘pi bilan { $value } siljiydi.
moved-roots-lost = Vaqt sohasida ratsional shakllari bor mashinaning ildizlaridan ({ $roots }) { $lost } tasiga aniq mashinada mos ildiz yo‘q; qolganlari ko‘pi bilan { $value } siljiydi. Bu harakatdagi o‘sish vaqt sohasidagi ratsional shakllardan kelib chiqishi mumkin; kichikroq time_error qiymatini oling.
moved-roots-all-lost = Vaqt sohasida ratsional shakllari bor mashinaning ildizlaridan ({ $roots }) birortasiga ham aniq mashinada mos ildiz yo‘q. Bu harakatdagi o‘sish vaqt sohasidagi ratsional shakllardan kelib chiqishi mumkin; kichikroq time_error qiymatini oling.
moved-roots-none = Vaqt sohasida ratsional shakllari bor mashinada bunday ildizlar yo‘q ({ $roots }); birortasi ham aniq mashina bilan solishtirilmadi.
