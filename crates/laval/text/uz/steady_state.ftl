# Takrorlanguncha kuzatiladigan harakatlar.

steady-state-not-valid = Haqiqiy emas: { $count } ta harakat "{ $part }" qismining qo‘llanish sohasidan tashqarida, { $what } ko‘pi bilan { $value } (chegara 1).
steady-state-not-valid-unbounded = Haqiqiy emas: { $count } ta harakat "{ $part }" qismining qo‘llanish sohasidan tashqarida, { $what } chegaralanmagan (chegara 1).
