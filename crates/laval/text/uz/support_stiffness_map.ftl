# Undamped critical speeds over the stiffness of the supports.
support-map-intersection = Barcha tayanchlar { $bearing } kabi bikr bo‘lsa, { $mode }-kritik aylanish chastotasi { $value }. Har biri { $stiffness } bo‘lganda deformatsiya energiyasining { $share } qismi tayanchlarda.{ $moves ->
        [supports] {" "}Uni boshqa podshipniklar siljitadi.
        [rotor] {" "}Uni faqat boshqa rotor siljitadi.
       *[both] {" "}Uni podshipniklar ham, rotor ham siljitadi.
    }
support-map-rigid = Qattiq tayanchlarda to‘g‘ri pretsessiyaning eng past kritik aylanish chastotasi { $value }. Hech bir podshipnik uni bundan yuqori ko‘tarmaydi.
support-map-free = Tayanchlarsiz to‘g‘ri pretsessiyaning eng past kritik aylanish chastotasi { $value }. Erkin rotorning nol chastotadagi harakatlari hisobga olinmaydi.
support-map-fewer = { $modes ->
        [0] Rotorning to‘g‘ri kritik aylanish chastotasi yo‘q: qutbiy inersiya momenti ekvatorialdan katta
       *[other] Xaritada rotorning { $modes } ta kritik aylanish chastotasi bor
    }. Qutbiy inersiya momenti ekvatorialdan katta modalarda ular bo‘lmaydi.
support-map-counted = Barcha { $roots } ta kritik aylanish chastotasi sanaldi: har birining ostidagi va ustidagi sonlar birga farq qiladi.
support-map-together = Alohida sanash uchun boshqasiga juda yaqin kritik aylanish chastotalari soni: { $roots }.
support-map-replaced = x va y bo‘yicha teng bikrlik bilan, so‘nishsiz va kesishma hadlarsiz almashtirildi: { $parts }. Ustunlar va massalar qoladi.{ $nonlinears ->
        [0] {""}
       *[other] {" "}Bikrligi yuk va siljishga bog‘liq podshipnikning bu yerda egri chizig‘i yo‘q: { $nonlinear }.
    }{ $softs ->
        [0] {""}
       *[other] {" "}Musbat bikrligi yo‘q, shuning uchun egri chizig‘i ham yo‘q: { $soft }.
    }
support-map-directions = Podshipniklardan tashqari mashinada ajralib turgan yo‘nalish bor: egri chiziqlarda to‘g‘ri va teskari pretsessiyalar bor.
support-map-spin = Aylanish chastotalari "{ $spin }" aylanishi bilan aylanadigan qismlarga tegishli, mashina aylanish chastotasiga nisbati { $ratio }.{ $others ->
        [0] {""}
       *[other] {" "}Boshqacha aylanadigan qismlarning o‘z kritik aylanish chastotalari bor: spin maydonini alohida hisobda bering.
    }
support-map-machine-spin = Aylanish chastotalari mashinaga tegishli. { $spins } aylanishi bilan aylanadigan qismlarning o‘z kritik aylanish chastotalari bor: spin maydonini alohida hisobda bering.

support-map-bearing = { $parts }{ $axes ->
        [x] , kxx
        [y] , kyy
       *[both] {""}
    }
support-map-curve = { $mode }-kritik chastota
support-map-at-rest = tinch holatdagi { $mode }-xususiy chastota
support-map-alt = Har bir tayanch bikrligiga bog‘liq kritik aylanish chastotalari, egri chiziqlar soni: { $curves }, mashina podshipniklari bilan kesishish nuqtalari: { $points }.
