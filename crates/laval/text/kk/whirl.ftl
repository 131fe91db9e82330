# How a mode moves.
whirl-direction = { $whirl ->
        [forward] тура прецессия
        [backward] кері прецессия
        [mixed] аралас прецессия, тура бөлігі { $forward_share }
        [straight] түзу бойымен аралас прецессия
        [axial] осьтік тербеліс
        [torsional] бұралу тербелісі
       *[none] тербеліс
    }
