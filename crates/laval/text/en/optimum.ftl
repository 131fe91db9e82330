# The best machine that was found.
optimum-best = The { $extreme ->
        [largest] largest
       *[smallest] smallest
    } { $kind ->
        [speed] speed or frequency of "{ $aim }"
       *[other] "{ $aim }"
    } found within the bounds{ $search ->
        [stopped] {" "}before the study stopped
       *[complete] {""}
    } is { $value }.{ $present ->
        [change] {" "}The present machine has { $now }: a change of { $change }.
        [value] {" "}The present machine has { $now }.
       *[none] {""}
    }
optimum-recommended = { $search ->
        [stopped] Best before the study stopped
       *[complete] Recommended
    }: { $parameter } = { $value }. The present machine has { $now }.{ $bound ->
        [lower] {" "}This is the lower bound; a lower one may give a better machine.
        [upper] {" "}This is the upper bound; a higher one may give a better machine.
       *[none] {""}
    }{ $slope ->
        [rises] {" "}Towards the bound "{ $aim }" rises by { $rate } per { $step }.
        [falls] {" "}Towards the bound "{ $aim }" falls by { $rate } per { $step }.
       *[none] {""}
    }{ $range ->
        [whole] {" "}"{ $aim }" stays within { $tolerance } of the best over the whole range, { $from } to { $to }.
        [lower] {" "}"{ $aim }" stays within { $tolerance } of the best from the lower bound { $from } to { $to }.
        [upper] {" "}"{ $aim }" stays within { $tolerance } of the best from { $from } to the upper bound { $to }.
        [inside] {" "}"{ $aim }" stays within { $tolerance } of the best from { $from } to { $to }.
       *[none] {""}
    }

# Limits on other numbers.
optimum-limit-reached = "{ $number }" reaches its { $side ->
        [upper] upper
       *[lower] lower
    } limit of { $limit }. Relaxing the limit may give a better machine.
optimum-limit-kept = "{ $number }" is { $value }, within its { $side ->
        [upper] upper
       *[lower] lower
    } limit of { $limit }.

# The test of the optimum by machines beside it.
optimum-neighbours-worse = None of { $count } neighbouring machines is better.{ $limits ->
        [some] {" "}Excess over a limit counts as worse.
       *[none] {""}
    }
optimum-neighbours-alike = The search has converged: the best of { $count } neighbouring machines is better by only { $better }.{ $limits ->
        [some] {" "}Excess over a limit counts as worse.
       *[none] {""}
    }
optimum-neighbour-better = The search has not converged: of { $count } neighbouring machines the best is better by { $better }. Allow more runs.
optimum-neighbour-without = The optimum is not verified: a neighbouring machine has no "{ $aim }". Move the bounds away from such machines.
optimum-searches-cut = { $count } of { $searches } searches used all { $runs } runs before they converged. Allow more runs for a safer result.
optimum-outside-validity = A result of the recommended machine is outside the validity of a model.

# No machine was found.
optimum-none = { $search ->
        [stopped] No machine with the number "{ $aim }" was found before the study stopped, after { $runs } runs.
       *[complete] No machine tried has the number "{ $aim }". Change the bounds.
    }
optimum-none-in-limits = { $search ->
        [stopped] No machine within the limits was found before the study stopped, after { $runs } runs.
       *[complete] No machine tried keeps the limits. Widen the bounds or relax a limit.
    }
