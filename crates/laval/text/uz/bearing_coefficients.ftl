# Supports at rest over the speed.
bearing-coefficients-state = { $speed } da { $part } { $value } ko‘taradi; bikrligi x bo‘yicha { $x }, y bo‘yicha { $y }.
bearing-coefficients-film = { $speed } da { $part } { $value } ko‘taradi, ekssentrisiteti tirqishning { $eccentricity } qismi{ $loaded ->
        [yes] , yuklamadan burchagi { $attitude }
       *[no] {""}
    }{ $shows ->
        [film] ; pardaning qalinligi kamida { $film }, yo‘qotish { $power }
       *[nothing] {""}
    }.
bearing-coefficients-threshold = { $any ->
        [all] { $part } ustidagi har qanday bikr massa pretsessiya qiladi
       *[some] { $part } ustidagi { $value } dan ortiq bikr massa pretsessiya qiladi
    }, chastotasi aylanish chastotasining { $share } qismi; egiluvchan rotor ertaroq boshlaydi.
bearing-coefficients-no-rest = Muvozanat holati yo‘q aylanish chastotalari: { $count }, { $value } gacha.
bearing-coefficients-alt = { $speeds } aylanish chastotasidagi tinch mashina tayanchlari, har biriga bir chiziq.
