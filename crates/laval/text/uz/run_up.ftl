# Tezlashish va sekinlashish.

# O‘rama cho‘qqilari.
run-up-resonance = { $body } uchun amplituda rezonansdan o‘tishda { $value } cho‘qqiga yetadi.
run-up-peak = { $body } uchun amplitudaning cho‘qqisi { $value }.
run-up-unstable-range = Mashina { $range } noturg‘un: u yerda { $body } uchun amplituda ko‘pi bilan { $factor } marta o‘sadi va { $value } cho‘qqiga yetadi. Bu oraliqdan tez o‘ting yoki so‘ndirish qo‘shing.
run-up-swings = { $body } uchun eng katta amplituda { $value }, u sharchalar rotor ichida aylanib yurganda kuzatiladi. Bu cho‘qqi rezonans emas.

# Yuritma.
run-up-torque = Tezlik profili uchun zarur yuritma momenti ko‘pi bilan { $value }, { $speed } tezlikda.
run-up-torque-beyond-motors = Tezlik profili uchun dvigatellar momentidan tashqari zarur moment ko‘pi bilan { $value }, { $speed } tezlikda.
run-up-power = Tezlik profili uchun zarur yuritma quvvati ko‘pi bilan { $value }, { $speed } tezlikda.
run-up-power-beyond-motors = Tezlik profili uchun dvigatellar quvvatidan tashqari zarur quvvat ko‘pi bilan { $value }, { $speed } tezlikda.
