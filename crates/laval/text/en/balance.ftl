# Balls that balance by themselves.

balance-purpose = "{ $part }": { $why }.
balance-residual = The unbalance is { $value } { $when }; without the balls it would be { $without }.
balance-increased = The balls increase the unbalance from { $without } to { $value } { $when }. Change the speed, the drag or the initial positions.
balance-insufficient-capacity = The balls can cancel at most { $value } of the unbalance of { $without }. Use heavier balls or more of them.
balance-unsettled = The unbalance has not settled { $when }: the balls still move. A longer duration may show its last value.
balance-settling-time = Settling time of the residual unbalance: { $value }, to within { $share } of the unbalance without balls.
balance-masses-slip = { $count ->
        [one] One ball does
       *[other] { $count } balls do
    } not turn with the rotor: mean speed { $value }, rotor { $speed }. The unbalance keeps varying; more drag may help.
balance-masses-caught = { $count ->
        [one] One ball is
       *[other] { $count } balls are
    } caught near the natural frequency of { $near }: mean speed { $value }, rotor { $speed }. The unbalance keeps varying; pass that frequency faster or use more drag.
