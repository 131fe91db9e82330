# Motions followed until they repeat.

steady-state-not-valid = Жарамсыз: { $count } қозғалыс «{ $part }» бөлшегінің жарамдылық шегінен тыс, ең үлкені: { $what } = { $value } (шегі 1).
steady-state-not-valid-unbounded = Жарамсыз: { $count } қозғалыс «{ $part }» бөлшегінің жарамдылық шегінен тыс, { $what } шексіз (шегі 1).
