# Small pictures side by side: shapes of modes, deflected shapes, orbits; and the polar diagram.

# The point on every orbit.
tiles-instant = положение точек в один момент времени
tiles-mark = положение в момент, когда метка фазы проходит ось x
# Lines along the axis.
tiles-plane-x = перемещение по x в этот момент
tiles-plane-y = перемещение по y
tiles-envelope = между большими полуосями
tiles-clearance = зазор
# Remarks.
tiles-heights = Числа вдоль оси: высота над опорной точкой тела или положение на валу, { $unit }.
tiles-not-to-scale = Расстояния между телами в файле машины не заданы. Тела показаны одно под другим.
tiles-own-scale = У каждого рисунка свой масштаб.
tiles-more-points = { $points ->
        [one] Ещё { $points } точка
        [few] Ещё { $points } точки
       *[other] Ещё { $points } точек
    } — в таблице.
# Lines of text of a picture.
tiles-axes = { $major } × { $minor }
tiles-circle = окружность, { $radius }
tiles-straight = прямая линия
tiles-at = { $speed }{ $reason ->
        [operating] , рабочая частота вращения
        [resonance] , резонанс
       *[chosen] {""}
    }
tiles-reason = { $reason ->
        [operating] рабочая частота вращения
        [resonance] резонанс
       *[chosen] частота вращения расчёта
    }
tiles-largest = { $point }: { $amplitude }

shapes-table = Формы мод: движение каждой точки, отнесённое к наибольшей большой полуоси моды
shapes-more = { $modes ->
        [one] Ещё { $modes } мода более высокой частоты
        [few] Ещё { $modes } моды более высокой частоты
       *[other] Ещё { $modes } мод более высокой частоты
    } — в таблице.
shapes-alt = Формы { $modes ->
        [one] { $modes } моды
       *[other] { $modes } мод
    } при { $speed }: орбиты точек в пространстве и перемещения вдоль оси.
shapes-share = { $kind ->
        [axial] вдоль оси: { $share } кинетической энергии
       *[torsional] кручение: { $share } кинетической энергии
    }
shapes-along = { $kind ->
        [axial] Мода { $mode } движется и вдоль оси, доля кинетической энергии { $share }
       *[torsional] В моде { $mode } есть и кручение, доля кинетической энергии { $share }
    }: см. рисунок движения вдоль оси и вокруг неё.
along-table = Движение мод вдоль оси и вокруг неё в точках машины
along-alt = Движение { $modes ->
        [one] { $modes } моды
       *[other] { $modes } мод
    } вдоль оси и вокруг неё при { $speed }, отнесённое к наибольшему значению.
orbits-alt = { $orbits ->
        [one] { $orbits } орбита
        [few] { $orbits } орбиты
       *[other] { $orbits } орбит
    } при { $speeds ->
        [one] { $speeds } частоте
       *[other] { $speeds } частотах
    } вращения, с меткой фазы и направлением прецессии.
deflected-alt = Форма прогиба машины при { $speeds ->
        [one] { $speeds } частоте
       *[other] { $speeds } частотах
    } вращения: орбиты точек в пространстве и перемещения вдоль оси.
polar-alt = Амплитуда и фаза прямой составляющей { $bodies ->
        [one] { $bodies } тела
       *[other] { $bodies } тел
    } в виде векторов от оси; вдоль кривой указаны частоты вращения.
