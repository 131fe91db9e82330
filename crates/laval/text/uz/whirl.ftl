# Moda qanday harakatlanadi.
whirl-direction = { $whirl ->
        [forward] to‘g‘ri pretsessiya
        [backward] teskari pretsessiya
        [mixed] aralash pretsessiya, to‘g‘ri ulushi { $forward_share }
        [straight] to‘g‘ri chiziq bo‘ylab aralash pretsessiya
        [axial] o‘q bo‘ylab tebranish
        [torsional] buralma tebranish
       *[none] tebranish
    }
