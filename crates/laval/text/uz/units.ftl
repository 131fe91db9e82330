# O‘lchov birliklari, xalqaro belgidan farq qiladiganlari.
unit-rpm = ayl/min
unit-rpm-s = ayl/min/s
unit-hz = Gs
unit-khz = kGs
unit-rev = ayl
unit-turn = ayl
unit-rev-s = ayl/s
unit-rev-min = ayl/min
