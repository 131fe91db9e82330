# The machine at rest under its weight.
static-sag = { $place ->
        [along] { $body } на { $position }
       *[body] { $body }
    }: прогиб { $value } при жёсткости опор на частоте вращения { $speed }.{ $load ->
        [force] {" "}Его вызывают постоянные силы; вес направлен вдоль оси.
       *[weight] {""}
    }
static-rigid-sag = На жёстких опорах { $place ->
        [along] { $body } на { $position }
       *[body] { $body }
    }: прогиб { $value }.
static-load = Наибольшая нагрузка на опору: { $part } несёт { $value }. Вся машина весит { $weight }.
static-moment = Наибольший изгибающий момент { $value }: { $body } на { $position }.
static-vertical = Вес { $weight } направлен вдоль оси: прогибов нет, и ни один подшипник не несёт поперечной нагрузки.
static-weightless = Ни вес, ни постоянные силы не действуют: прогибов нет.
static-not-held = Одни жёсткие опоры на местах подшипников не удерживают машину: их результаты опущены. Назовите больше частей в supports.
static-mass = { $body } со всем, что на нём: масса { $value }{ $tilts ->
        [yes] , центр масс на { $centre }, момент инерции { $polar } относительно оси и { $diametral } поперёк неё
       *[no] {""}
    }.

static-line = { $plane ->
        [x] x
       *[y] y
    }, { $supports ->
        [rigid] жёсткие опоры
       *[own] собственная жёсткость опор
    }
static-alt = Прогиб, поперечная сила и изгибающий момент в покое вдоль { $shafts ->
        [one] { $shafts } вала
       *[other] { $shafts } валов
    }.
