# A place on the map.
motion-map-speed = айналу жиілігі { $speed }
motion-map-parameter = { $parameter } = { $value }

motion-map-largest = { $point }: ең үлкен { $quality ->
        [tilt] мәні
       *[displacement] ығысуы
    } { $value }, { $place } болғанда.

# How the response repeats.
motion-map-every-turn = Орнығатын барлық тербеліс әр айналым сайын қайталанады: { $points } нүктенің { $count } нүктесі.
motion-map-subharmonic = { $points } нүктенің { $count } нүктесінде тербеліс субгармоникалық, реті 1/{ $turns }, мысалы { $place } болғанда.
motion-map-longer-period = { $points } нүктенің { $count } нүктесінде тербеліс тек { $turns } айналымнан кешірек қайталанады, мысалы { $place } болғанда.
motion-map-not-periodic = { $points } нүктенің { $count } нүктесінде тербеліс { $turns } айналым ішінде қайталанбайды, мысалы { $place } болғанда. Онда ол квазипериодты, хаостық немесе периоды ұзағырақ.

# Points without a result.
motion-map-not-settled = { $points } нүктенің { $count } нүктесінде тербеліс most_periods ішінде орнықпады. Ондағы амплитудаларда өтпелі процесс болуы мүмкін; most_periods мәнін арттырыңыз.
motion-map-failed-machines = { $points } нүктенің { $count } нүктесінде параметрлер жарамды машина бермейді, мысалы { $place } болғанда: { $reason }.
motion-map-failed-motions = { $points } нүктенің { $count } нүктесінде қозғалыс { $reason }, мысалы { $place } болғанда. Бұл нүктелердің нәтижесі жоқ.
