# Phrases that several studies share.

list-and = { $rest } and { $last }
# A body, a point of a body, the tilt of a body.
body = "{ $body }"
point = "{ $body }" at { $height }
tilt-of = the tilt of "{ $body }"
# A range of speeds.
range = from { $from } to { $to }
at = at { $at }

# A coefficient table that a study leaves.
beyond-table = The table of "{ $part }" covers { $from } to { $to }. { $sides ->
        [both] Beyond it, down to { $lowest } and up to { $highest },
        [below] Below it, down to { $lowest },
       *[above] Above it, up to { $highest },
    } its coefficients are { $rule ->
        [hold] held at its ends
        [linear] continued along its slope at the ends
       *[refuse] unknown
    }.
beyond-table-note = Outside the table of "{ $part }".
