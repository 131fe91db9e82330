# Symbols of units, word by word: `N/mm` is unit-N, a slash and unit-mm; µ is written u.

unit-rpm = ayl/min
unit-Hz = Gs
unit-mil = mil
unit-in = dyuym
unit-ft = fut
