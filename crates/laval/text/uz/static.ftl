# The machine at rest under its weight.
static-sag = { $place ->
        [along] { $body }, { $position } joyida
       *[body] { $body }
    }: { $speed } tezlikdagi tayanchlar bikrligida egilishi { $value }.{ $load ->
        [force] {" "}Uni doimiy kuchlar yuzaga keltiradi; og‘irlik o‘q bo‘ylab ta’sir qiladi.
        [offsets] {" "}Tayanchlarning siljishi hisobga olingan.
        [raised] {" "}Uni tayanchlarning siljishi yuzaga keltiradi; og‘irlik o‘q bo‘ylab ta’sir qiladi.
       *[weight] {""}
    }
static-rigid-sag = Qattiq tayanchlarda { $place ->
        [along] { $body }, { $position } joyida
       *[body] { $body }
    }: egilishi { $value }.
static-load = Tayanchning eng katta yuklamasi: { $part }, { $value }. Butun mashinaning og‘irligi { $weight }.
static-moment = Eng katta eguvchi moment { $value }: { $body }, { $position } joyida.
static-vertical = { $weight } og‘irlik o‘q bo‘ylab ta’sir qiladi: egilish yo‘q, hech bir podshipnik ko‘ndalang yuklama ko‘tarmaydi.
static-weightless = Og‘irlik ham, doimiy kuch ham ta’sir qilmaydi: egilish yo‘q.
static-not-held = Podshipniklar o‘rnidagi qattiq tayanchlarning o‘zi mashinani ushlab turmaydi: ularning natijalari berilmaydi. supports maydonida ko‘proq qismni nomlang.
static-mass = { $body } va undagi hamma narsa: massasi { $value }{ $tilts ->
        [yes] , massa markazi { $centre } joyida, inersiya momenti o‘qqa nisbatan { $polar }, unga ko‘ndalang { $diametral }
       *[no] {""}
    }.
static-unloaded = Bu siljishlarda { $part } valni { $value } kuch bilan pastga tortadi: haqiqiy podshipnik yuklamasini yo‘qotadi. Uni ko‘taring yoki qo‘shnilarini tushiring.
static-offset-load = Siljishlar { $part } yuklamasini { $before } dan { $value } ga o‘zgartiradi: bu tayanchlar orasidagi eng katta o‘zgarish.
static-offsets-free = Siljishlar tayanchlarning yuklamasini o‘zgartirmaydi: mashina statik aniqlangan.
static-determinate = Tayanchlarning siljishi ularning yuklamasini o‘zgartirmaydi: mashina statik aniqlangan.
static-influence = Yuklamasi o‘z balandligiga eng ko‘p bog‘liq tayanch: { $part }, { $value }.
static-coupling = { $place }: eguvchi moment { $value }, ko‘ndalang kuch { $shear }.
static-aligned = { $part } { $value } balandlikda{ $aside ->
        [yes] {" "}va yonga { $sideways } siljiganda
       *[no] {""}
    }: muftalar yuklamasiz. Shunda tayanch yuklamasi { $load }.
static-not-aligned = Tayanchlarning hech bir balandligi muftalarni yuklamadan xoli qilmaydi. Boshqa muftalarni yoki boshqa qo‘zg‘almas tayanchlarni nomlang.
static-spare = Muftalar aniqlaydiganidan { $spare ->
        [one] { $spare } ta balandlik
       *[other] { $spare } ta balandlik
    } ortiq: eng kichik o‘zgarishlar berilgan.

static-line = { $plane ->
        [x] x
       *[y] y
    }, { $supports ->
        [rigid] qattiq tayanchlar
        [aligned] yuklamasiz muftalar
       *[own] tayanchlarning o‘z bikrligi
    }
static-alt = { $shafts ->
        [one] Val
       *[other] { $shafts } val
    } bo‘ylab tinch holatdagi egilish, ko‘ndalang kuch va eguvchi moment.
