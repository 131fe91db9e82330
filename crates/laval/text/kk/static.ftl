# The machine at rest under its weight.
static-sag = { $place ->
        [along] { $body }, { $position } жерінде
       *[body] { $body }
    }: { $speed } айналу жиілігіндегі тіректер қатаңдығында иілуі { $value }.{ $load ->
        [force] {" "}Оны тұрақты күштер тудырады; салмақ ось бойымен әсер етеді.
       *[weight] {""}
    }
static-rigid-sag = Қатты тіректерде { $place ->
        [along] { $body }, { $position } жерінде
       *[body] { $body }
    }: иілуі { $value }.
static-load = Тіректің ең үлкен жүктемесі: { $part }, { $value }. Бүкіл машинаның салмағы { $weight }.
static-moment = Ең үлкен июші момент { $value }: { $body }, { $position } жерінде.
static-vertical = { $weight } салмақ ось бойымен әсер етеді: иілу жоқ, ешбір мойынтірек көлденең жүктеме көтермейді.
static-weightless = Салмақ та, тұрақты күш те әсер етпейді: иілу жоқ.
static-not-held = Мойынтіректер орнындағы қатты тіректердің өзі машинаны ұстамайды: олардың нәтижелері берілмейді. supports өрісінде көбірек бөлікті атаңыз.
static-mass = { $body } және ондағының бәрі: массасы { $value }{ $tilts ->
        [yes] , масса центрі { $centre } жерінде, инерция моменті оське қатысты { $polar }, оған көлденең { $diametral }
       *[no] {""}
    }.

static-line = { $plane ->
        [x] x
       *[y] y
    }, { $supports ->
        [rigid] қатты тіректер
       *[own] тіректердің өз қатаңдығы
    }
static-alt = { $shafts ->
        [one] Білік
       *[other] { $shafts } білік
    } бойындағы тыныштықтағы иілу, көлденең күш және июші момент.
