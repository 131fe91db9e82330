# Dvigatellar va aylanish.

drive-captured = Zommerfeld effekti: tezlik { $value } qiymatida to‘xtab qoladi, chunki tebranish yuritma momentini yutadi. Tebranishsiz u { $reachable } qiymatiga yetar edi. O‘tish uchun moment yoki so‘ndirish qo‘shing.
drive-captured-unlimited = Zommerfeld effekti: tezlik { $value } qiymatida to‘xtab qoladi, chunki tebranish yuritma momentini yutadi. Tebranishsiz u cheksiz ortar edi. O‘tish uchun moment yoki so‘ndirish qo‘shing.
drive-suffices = Dvigatel momenti bu tezlik profili uchun yetarli, zaxira kamida { $value }.
drive-short = Dvigatel momenti bu tezlik profili uchun kam: { $at } tezlikda { $value } yetishmaydi. Sekinroq profil yoki kuchliroq dvigatel tanlang.
drive-spin-inertia = Aylanish tezlanishi va yuritma momentida o‘q atrofida inersiyasi yo‘q qismlar hisobga olinmagan. { $parameters } qiymatini bering.
