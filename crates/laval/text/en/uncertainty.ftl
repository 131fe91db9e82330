# Distributions.
uncertainty-distribution = "{ $quantity }" has the mean { $value }{ $spread ->
        [known] {" "}and the standard deviation { $deviation }
       *[none] {""}
    }.{ $quantiles ->
        [outer] {" "}{ $lower } of the samples lie below { $low }, { $upper } below { $high }.
       *[none] {""}
    }{ $found ->
        [some] {" "}It exists in { $count } of { $samples } samples only.
       *[all] {""}
    }
uncertainty-more = { $count } more
uncertainty-more-numbers = The table "{ $table }" has { $count ->
        [one] one more quantity
       *[other] { $count } more quantities
    }.
uncertainty-no-numbers = The study has no numeric result to distribute. Choose a study with one.
uncertainty-nothing-shown = No quantity begins with "{ $show }", so that no distribution is drawn. Choose show from { $quantities }.

# Influence of the parameters.
uncertainty-most-influential = "{ $quantity }" depends most on { $parameter }: total index { $value }, 95 % interval { $low } to { $high }.
uncertainty-most-influential-overlap = In these samples "{ $quantity }" depends most on { $parameter }: total index { $value }, 95 % interval { $low } to { $high }. Intervals overlap with { $rivals }; more samples may change the order.
uncertainty-unresolved-indices = Sensitivity indices of { $quantities } are not resolved: a first-order index exceeds the total index by up to { $value }. This is a sampling error. Raise samples.
uncertainty-no-indices = No sensitivity indices of { $quantities }: the values are constant or found in too few samples.
uncertainty-few-base-points = { $count ->
        [one] One base point is
       *[other] { $count } base points are
    } too few for the sensitivity indices of { $quantities }. The table "indices" has their 95 % intervals. Raise samples.
uncertainty-largest-effect = "{ $quantity }" changes most with { $parameter }: mean elementary effect { $value }, 95 % interval { $low } to { $high }.
uncertainty-largest-effect-few = "{ $quantity }" changes most with { $parameter }: mean elementary effect { $value }. The samples are too few for its interval; raise samples.

# Samples without a valid result.
uncertainty-failed-samples = No result in { $count } of { $samples } samples{ $count ->
        [1] {""}
       *[other] , for instance sample { $first }
    }: { $reason }. The statistics omit these samples.
uncertainty-outside-validity = In { $count } of { $samples } samples a result is outside the validity of a model; the statistics include it.
