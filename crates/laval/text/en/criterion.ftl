# What a stability map calls unstable.
criterion-growth = Criterion: growth rate above { $limit }.
criterion-growth-of-waves = Criterion: growth rate above { $limit }. Damping outside { $part } makes slow waves grow, most of them negligibly: the sign of the growth rate alone does not decide.
criterion-flutter = Criterion: flutter, two frequencies of the undamped machine coincide. Near the boundary the growth rate rises with the square root of the distance.
criterion-viscous = Criterion: growth rate above { $limit } with { $loss }.
criterion-viscous-range = Criterion: growth rate above { $limit } with { $loss }. { $range }
