# Studiya sahifasining so‘zlari.
studio-text = Mashina fayli
studio-machine = Mashina
studio-figures = Natijalar
studio-view = Ko‘rinish
studio-tab-text = Matn
studio-tab-machine = Mashina
studio-tab-figures = Natijalar
studio-tab-section = Kesim
studio-tab-space = 3-D
studio-want-page = Hisobotning birinchi sahifasi
studio-want-modes = Modalar
studio-want-campbell = Kempbell diagrammasi
studio-want-stability = Turg‘unlik
studio-want-forced = Disbalansga javob
studio-want-nonlinear = Chiziqsiz javob
studio-short-page = Birinchi sahifa
studio-short-modes = Modalar
studio-short-campbell = Kempbell
studio-short-stability = Turg‘unlik
studio-short-forced = Disbalans
studio-short-nonlinear = Chiziqsiz
studio-nothing = Bu mashina uchun natija yo‘q.

# Fayl va matn.
studio-open = Ochish
studio-save = Saqlash
studio-save-as = Boshqacha saqlash
studio-saved = { $name } fayli saqlandi.
studio-unsaved = O‘zgarishlar saqlanmagan.
studio-new-file = yangi fayl
studio-file-name = Fayl nomi
studio-file-name-wrong = Shu jildning .toml bilan tugaydigan fayl nomi kerak, masalan rotor.toml.
studio-files = Shu jildning fayllari
studio-examples = Misollar
studio-changed-on-disk = Diskdagi fayl o‘zgargan
studio-overwrite = Ustidan yozish
studio-load-from-disk = Diskdan yuklash
studio-undo = Bekor qilish
studio-redo = Takrorlash
studio-errors = Fayldagi xatolar ({ $count }). Birinchisi
studio-lost = Dastur bilan aloqa yo‘q. Matn shu yerda saqlanadi; aloqa har soniyada tekshiriladi.
studio-unsent = Aloqa tiklanganda yuboriladi: { $name }.
studio-close = Yopish
studio-language = Til
studio-theme-system = Ranglar: tizimdagidek
studio-theme-light = Ranglar: yorug‘
studio-theme-dark = Ranglar: to‘q
studio-unit = birlik
studio-default = odatiy qiymat

# Parametrlar va tutqichlar.
studio-parameters = Parametrlar
studio-parameter = Parametr
studio-value = qiymat
studio-range = Oraliq
studio-from = Dan
studio-to = Gacha
studio-drag-this = Suring: { $name }, { $value }

# Uch o‘lchamli harakat.
studio-motion = Harakat
studio-motion-forced = Disbalansga chiziqli javob, { $value } ayl/min
studio-motion-nonlinear = Disbalansga chiziqsiz javob, { $value } ayl/min
studio-motion-state = { $count }-holat
studio-motion-unstable = noturg‘un
studio-motion-start = Muvozanat holatidan o‘tish jarayoni, { $value } ayl/min
studio-motion-transient = “{ $name }” o‘tish jarayoni
studio-shown = Eng katta siljish: { $value }. Kattalashtirish × { $from }, sekinlashtirish × { $to }.
studio-computing = Hisob bajarilmoqda
studio-time = { $value } s
studio-mode = { $count }-moda
studio-whirl-forward = to‘g‘ri pretsessiya
studio-whirl-backward = teskari pretsessiya
studio-whirl-mixed = aralash pretsessiya
studio-whirl-axial = o‘q bo‘ylab
studio-whirl-torsional = buralma
studio-whirl-none = pretsessiyasiz
studio-play = Boshlash
studio-pause = Pauza
studio-amplitude = Amplituda
studio-speed = Aylanish chastotasi
studio-rpm = ayl/min
studio-hertz = Hz
studio-grows = o‘sadi, { $value } 1/s
studio-decays = so‘nadi, { $value } 1/s
studio-space-help = Mashinaning uch o‘lchamli ko‘rinishi. Burish: sudrash yoki yo‘nalish tugmalari; masofa: plyus va minus.
studio-no-space = Bu brauzer uch o‘lchamli grafikani qo‘llamaydi.

# Sudrab belgilanadigan natijalar.
studio-reach = Natijani belgilash
studio-released = erkin
studio-released-help = Dastur bu parametrni oralig‘ida o‘zgartirishi mumkin.
studio-release-first = Erkin parametrlarni belgilang, so‘ng grafikda kritik aylanish chastotasini, turg‘unlik chegarasini, cho‘qqini yoki sakrashni suring.
studio-pull-help = Erkin parametrlar: { $count }. Grafikda kritik aylanish chastotasini, turg‘unlik chegarasini, cho‘qqini yoki sakrashni suring.
studio-pull-this = Suring: { $name }
studio-reach-running = { $name }: { $value } bo‘ladigan qiymatlar izlanmoqda …
studio-reached = { $name }: { $value } qiymatiga erishildi.
studio-not-reached = { $name }: { $value } qiymatiga erishilmadi.
studio-share-column = Ulushi
studio-at-bound = chegarada
studio-take-nearest = Eng yaqin qiymatlarni olish
studio-not-a-number = { $name } birligidagi yoki shu kattalikning boshqa birligi bilan yozilgan son kerak.
studio-trade = O‘zgarish bahosi
studio-trade-curve = Erkin parametrlar o‘zgarishining natijaga bog‘liqligi
studio-change = parametrlar o‘zgarishi,
studio-alone = Alohida
studio-result = Natija

# Taqqoslash va ulashish.
studio-pin = Mahkamlash
studio-pin-help = Bu variantni taqqoslash uchun mahkamlash.
studio-share = Ulashish
studio-share-help = Matn, natijalar va mahkamlangan variantlar bilan bitta HTML fayl.
studio-compare = Taqqoslash
studio-check = Tekshiruv
studio-now = Hozir
studio-design = Variant
studio-name = Nomi
studio-take-back = Qaytarish
studio-take-back-this = { $name } variantini qaytarish
studio-remove = Olib tashlash
studio-remove-this = { $name }: olib tashlash

# Hisoblarni bajarish.
studio-runs = Fayldagi hisoblar
studio-no-studies = Faylda hisoblar yo‘q.
studio-run = Hisoblash
studio-run-this = { $name }: hisoblash
studio-resume = Davom ettirish
studio-cancel = To‘xtatish
studio-report = Hisobot
studio-state-waiting = kutilmoqda
studio-state-running = bajarilmoqda
studio-state-paused = to‘xtatib turilgan
studio-state-done = bajarildi
studio-state-cancelled = to‘xtatildi
studio-state-failed = bajarilmadi
