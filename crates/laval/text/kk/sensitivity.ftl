# The parameter of most influence.
sensitivity-influence = ең көп { $parameter } параметріне байланысты: параметр 1 % артқанда { $change } { $direction ->
        [falls] кемиді
       *[rises] артады
    }
sensitivity-influence-unknown = белгісіз үлеске өзгереді

# Peaks and folds of the steady-state response.
sensitivity-peak = { $point }: шыңы { $value }, { $speed } кезінде; шың мәні { $size-influence }. Шыңның айналу жиілігі { $speed-influence }.
sensitivity-jump = { $way ->
        [up] Екпіндеу
       *[down] Баяулау
    } кезіндегі секірістің айналу жиілігі { $speed }; ол { $speed-influence }. { $point }: ондағы { $quality ->
        [tilt] мәні
       *[displacement] ығысуы
    } { $value }; ол { $size-influence }.
sensitivity-nothing-stationary = { $end ->
        [stopped] Зерттеу тоқтағанға дейін
       *[complete] Айналу жиілігінің ауқымында
    } тербелістің шыңы да, бұрылу нүктесі де табылмады.

# Places and parameters without an influence.
sensitivity-no-derivative-corner = { $value } кезінде{ $more ->
        [0] {""}
       *[other] {" "}және тағы { $more } орында, ең жоғарысы { $highest },
    } сезімталдық берілмейді: тармақ күш заңы ауысатын сынық нүктеде бұрылады. Ондағы параметрлерді қолмен немесе uncertainty арқылы өзгертіңіз.
sensitivity-no-derivative-jump = { $value } кезінде{ $more ->
        [0] {""}
       *[other] {" "}және тағы { $more } орында, ең жоғарысы { $highest },
    } сезімталдық берілмейді: «{ $part }» бөлшегінің күші секіреді. Ондағы параметрлерді қолмен немесе uncertainty арқылы өзгертіңіз.
sensitivity-no-derivative-open = { $value } кезінде{ $more ->
        [0] {""}
       *[other] {" "}және тағы { $more } орында, ең жоғарысы { $highest },
    } сезімталдық берілмейді: туындылар жинақталмады. Ондағы параметрлерді қолмен немесе uncertainty арқылы өзгертіңіз.
sensitivity-no-influence = Мына параметрлердің әсері кейбір орындарда белгісіз: { $parameters }. Кестелерде олар сол орындарда соңында тұр.
sensitivity-without-influence = Тізімдегі шыңдар мен бұрылу нүктелеріне әсері жоқ: { $parameters }.
