# Run-up and run-down.

# Peaks of the envelope.
run-up-resonance = Пик амплитуды { $body } при { $value }, прохождение резонанса.
run-up-peak = Пик амплитуды { $body } при { $value }.
run-up-unstable-range = Машина неустойчива { $range }: амплитуда { $body } растёт там с коэффициентом до { $factor }, пик при { $value }. Проходите этот диапазон быстро или добавьте демпфирование.
run-up-swings = Амплитуда { $body } наибольшая при { $value }, пока шарики обращаются в роторе. Этот пик — не резонанс.

# Drive.
run-up-torque = Программа разгона требует момента привода до { $value }, при { $speed }.
run-up-torque-beyond-motors = Программа разгона требует момента до { $value } сверх момента двигателей, при { $speed }.
run-up-power = Программа разгона требует мощности привода до { $value }, при { $speed }.
run-up-power-beyond-motors = Программа разгона требует мощности до { $value } сверх мощности двигателей, при { $speed }.
