# Harakat davomidagi spektrlar.

# Jism harakatining tashkil etuvchilari.
spectra-superharmonic = "{ $body }" jismining { $order }-tartibli { $whirl ->
        [forward] to‘g‘ri
       *[backward] teskari
    } supergarmonikasi
spectra-spin-frequency = "{ $body }" jismining aylanish chastotasidagi { $whirl ->
        [forward] to‘g‘ri
       *[backward] teskari
    } tashkil etuvchisi
spectra-subharmonic = "{ $body }" jismining { $p }/{ $q } tartibli { $whirl ->
        [forward] to‘g‘ri
       *[backward] teskari
    } subgarmonikasi
spectra-fraction = "{ $body }" jismining { $p }/{ $q } tartibli { $whirl ->
        [forward] to‘g‘ri
       *[backward] teskari
    } tashkil etuvchisi
spectra-asynchronous = "{ $body }" jismining { $whirl ->
        [forward] to‘g‘ri
       *[backward] teskari
    } asinxron tashkil etuvchisi (aylanish chastotasining { $order } barobari)

spectra-component = { $component }: { $value } – { $to } oralig‘ida { $limit } qiymatidan katta, eng kattasi { $largest }, { $at } tezlikda.{ $course ->
        [intermittent] {" "}U { $between } ta oynadan { $count } tasida bu qiymatdan oshadi.
       *[throughout] {""}
    }
spectra-component-at-speed = { $component }: { $value } tezlikda { $limit } qiymatidan katta, eng kattasi { $largest }.{ $course ->
        [intermittent] {" "}U { $between } ta oynadan { $count } tasida bu qiymatdan oshadi.
       *[throughout] {""}
    }
spectra-more-components = "{ $body }" jismining yana { $count } ta tashkil etuvchisi { $limit } qiymatidan oshadi.
spectra-fleeting = "{ $body }" jismining tashkil etuvchilari { $limit } qiymatidan faqat ayrim oynalarda oshadi, so‘nuvchi erkin tebranish kabi: ko‘pi bilan { $value }, { $speed } tezlikda.
spectra-no-components = "{ $body }" jismining sinxrondan boshqa birorta ham tashkil etuvchisi { $limit } qiymatidan oshmaydi.{ $short ->
        [0] {""}
       *[other] {" "}To‘rt aylanishdan qisqa { $short } ta oyna tashlab ketilgan.
    }
spectra-no-lasting-components = "{ $body }" jismining sinxrondan boshqa birorta ham davomli tashkil etuvchisi { $limit } qiymatidan oshmaydi.{ $short ->
        [0] {""}
       *[other] {" "}To‘rt aylanishdan qisqa { $short } ta oyna tashlab ketilgan.
    }
spectra-no-motion = "{ $body }" jismi tebranmaydi: uning spektrlari nolga teng.
spectra-no-orders = Tartiblar spektri yo‘q: spektrlar kaskadining oynalarida rotorning to‘rttadan kam aylanishi bor. Kamroq spektr so‘rang.
spectra-none = Spektrlar yo‘q: harakat spektrlar kaskadining birinchi oynasidan oldin tugagan.
