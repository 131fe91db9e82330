# Mashina va kam to‘lqinli taqribiy model.
approximation-modes = Taqribiy modelning ({ $degree }-darajali polinom) { $modes } ta modasidan { $met } tasi to‘liq mashina ildiziga { $within } aniqlikda mos keladi. Eng katta chetlanish { $value }, { $speed } tezlikda: chastota { $whole_frequency } o‘rniga { $frequency }, o‘sish sur’ati { $whole_growth } o‘rniga { $growth }.
approximation-growth = Eng katta o‘sish sur’ati: to‘liq mashinada { $whole_growth } ({ $whole_speed } tezlikda), taqribiy modelda { $growth } ({ $speed } tezlikda). Farq { $value }.
