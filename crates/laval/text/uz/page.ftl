# Hisobot sahifasi.
page-nameless = nomsiz mashina
page-report = laval hisoboti
page-from = manba: { $file }
# Kirish fayli xeshining birinchi raqamlari oldida.
page-hash = kirish
page-results = Xulosalar
page-studies = Hisoblar
page-kind = tur
page-bracket = oraliq kengligi
page-status = holat
page-doubtful = shubhali: { $reason }
page-first-rows = { $count } ta qatordan dastlabki { $first } tasi.
# Fayl nomi oldida.
page-all-values = Barcha qiymatlar:
page-no-data = bu oraliqda ma’lumot yo‘q
page-also-marked = Yana belgilangan: { $labels }
page-nothing-to-report = bajarildi, xulosa yo‘q
# Harakatni ko‘rsatish tugmalari va ro‘yxatlari.
play-play = Boshlash
play-pause = To‘xtatib turish
play-time = Vaqt
play-axes = Sanoq sistemasi
play-turning = aylanuvchi sanoq sistemasi
play-fixed = qo‘zg‘almas sanoq sistemasi
play-pace = Sur’at
play-whole = hammasi 20 s ichida
play-turn = soniyasiga bir aylanish
