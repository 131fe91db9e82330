# Unit symbols; the name is made of the letters and digits of the unit. A name that several units share has no message: N/m and N m are both n-m,
# kg m and kg/m³ both kg-m, s and µs both s.
unit-rpm = об/мин
unit-rpm-s = об/мин/с
unit-hz = Гц
unit-1-s = 1/с
unit-mrad = мрад
unit-mm = мм
unit-nm = нм
unit-ms = мс
unit-min = мин
unit-h = ч
unit-kg = кг
unit-g = г
unit-mg = мг
unit-g-mm = г·мм
unit-kg-mm = кг·мм
unit-kn = кН
unit-kw = кВт
unit-kj = кДж
unit-kpa = кПа
unit-gpa = ГПа
unit-l = л
unit-ml = мл
unit-l-h = л/ч
unit-l-min = л/мин
unit-degc = °C
