# How a mode moves.
whirl-direction = { $whirl ->
        [forward] прямая прецессия
        [backward] обратная прецессия
        [mixed] смешанная прецессия с долей прямой { $forward_share }
        [straight] смешанная прецессия по прямой линии
        [axial] осевые колебания
        [torsional] крутильные колебания
       *[none] колебания
    }
