# Small pictures side by side: shapes of modes, deflected shapes, orbits; and the polar diagram.

# The point on every orbit.
tiles-instant = nuqtalarning bir lahzadagi o‘rni
tiles-mark = faza belgisi x o‘qidan o‘tgan lahzadagi o‘rni
# Lines along the axis.
tiles-plane-x = shu lahzada x bo‘yicha siljish
tiles-plane-y = y bo‘yicha siljish
tiles-envelope = katta yarim o‘qlar orasi
tiles-clearance = tirqish
# Remarks.
tiles-heights = O‘q bo‘ylab sonlar: jismning tayanch nuqtasidan balandlik yoki valdagi joyi, { $unit }.
tiles-not-to-scale = Mashina faylida jismlar orasidagi masofalar berilmagan. Jismlar biri ostida biri ko‘rsatilgan.
tiles-own-scale = Har bir rasmning o‘z masshtabi bor.
tiles-more-points = Yana { $points } ta nuqta jadvalda.
# Lines of text of a picture.
tiles-axes = { $major } × { $minor }
tiles-circle = aylana, { $radius }
tiles-straight = to‘g‘ri chiziq
tiles-at = { $speed }{ $reason ->
        [operating] , ish tezligi
        [resonance] , rezonans
       *[chosen] {""}
    }
tiles-reason = { $reason ->
        [operating] ish tezligi
        [resonance] rezonans
       *[chosen] hisob tezligi
    }
tiles-largest = { $point }: { $amplitude }

shapes-table = Modalar shakllari: har bir nuqtaning harakati, modaning eng katta yarim o‘qiga nisbatan
shapes-more = Chastotasi yuqoriroq yana { $modes } ta moda jadvalda.
shapes-alt = { $speed } tezlikda { $modes } ta modaning shakli: nuqtalarning fazodagi orbitalari va o‘q bo‘ylab siljishlar.
shapes-share = { $kind ->
        [axial] o‘q bo‘ylab: kinetik energiyaning { $share } ulushi
       *[torsional] buralish: kinetik energiyaning { $share } ulushi
    }
shapes-along = { $kind ->
        [axial] { $mode }-moda o‘q bo‘ylab ham harakatlanadi, kinetik energiyadagi ulushi { $share }
       *[torsional] { $mode }-modada buralish ham bor, kinetik energiyadagi ulushi { $share }
    }: o‘q bo‘ylab va o‘q atrofidagi harakat rasmiga qarang.
along-table = Modalarning o‘q bo‘ylab va o‘q atrofidagi harakati, mashina nuqtalarida
along-alt = { $speed } tezlikda { $modes } ta modaning o‘q bo‘ylab va o‘q atrofidagi harakati, eng katta qiymatiga nisbatan.
orbits-alt = { $speeds } ta tezlikda { $orbits } ta orbita, faza belgisi va pretsessiya yo‘nalishi bilan.
deflected-alt = Mashinaning { $speeds } ta tezlikdagi egilgan shakli: nuqtalarning fazodagi orbitalari va o‘q bo‘ylab siljishlar.
polar-alt = { $bodies } ta jism to‘g‘ri amplitudasi va fazasi o‘qdan chiqqan vektorlar ko‘rinishida; egri chiziq bo‘ylab tezliklar yozilgan.
