# Nonlinear normal modes at one spin speed: frequency against amplitude.

backbone-family = { $whirl ->
        [forward] Тура бейсызық нормаль мода
        [backward] Кері бейсызық нормаль мода
       *[none] Бейсызық нормаль мода
    }, бастапқы жиілігі { $value }, { $trend ->
        [hardens] қатаяды
       *[softens] жұмсарады
    }: амплитуда { $first-amplitude } болғанда жиілігі { $first }, амплитуда { $last-amplitude } болғанда { $last }.
backbone-family-constant = { $whirl ->
        [forward] Тура бейсызық нормаль мода
        [backward] Кері бейсызық нормаль мода
       *[none] Бейсызық нормаль мода
    }, жиілігі { $value }: { $first-amplitude } – { $last-amplitude } аралығындағы барлық амплитудада жиілік бірдей.
backbone-turning = Ол алдымен { $trend ->
        [hardens] қатаяды
       *[softens] жұмсарады
    }: амплитуда { $amplitude } болғанда жиілігі { $frequency }.
backbone-family-beside-asymptote = { $whirl ->
        [forward] Тура бейсызық нормаль мода
        [backward] Кері бейсызық нормаль мода
       *[none] Бейсызық нормаль мода
    } { $asymptote } асимптотасының жанында орналасқан, басында сызықты мода жоқ. Бастапқы жиілігі { $value }, амплитудасы { $first-amplitude }; амплитуда { $least } мәніне дейін кемиді, соңғы жиілігі { $last }, амплитудасы { $last-amplitude }.
backbone-no-family = Бұл айналу жиілігінде бейсызық нормаль мода табылмады.
backbone-undamped = Есептелген барлық амплитудада модалар демпферленбеген.
backbone-driven = Машина демпферленген. Бұл модалардың энергия шығынын массаға пропорционал теріс демпферлеу теңгереді, ең көбі { $value }.
backbone-merged-modes = Жиілігі { $value } сызықты модадан бейсызық нормаль мода басталмайды. Ол қосылып кеткен екі моданың орнықсыздық жолағында жатыр, өсу жылдамдығы { $growth }; демпферлеу қосыңыз немесе айналу жиілігін өзгертіңіз.
backbone-asymptotes = Бейсызық бөлшектер қатаң болғанда { $n ->
        [one] меншікті жиілік
       *[other] меншікті жиіліктер
    }: { $frequencies }. Онда қатаятын машинаның амплитудасы шексіз.
backbone-synchronous = Амплитуда { $value } болғанда бұл моданың жиілігі айналу жиілігіне тең; онда оны дисбаланс қоздырады.
backbone-whirl-ends = Жиілігі { $mode } мода амплитуда { $value } болғанда аяқталады: жиілігі { $frequency } мәніне дейін төмендейді, қалпына келтіретін күш қалмайды.
backbone-family-unfinished = Жиілігі { $mode } мода тек { $value } амплитудасына дейін есептелді. { $why }
