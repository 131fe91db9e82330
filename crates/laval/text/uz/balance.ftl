# O‘zi balansirlovchi sharchalar.

balance-purpose = "{ $part }" qismi: { $why }.
balance-residual = Disbalans { $when } { $value }; sharchalarsiz u { $without } bo‘lar edi.
balance-increased = Sharchalar disbalansni oshiradi: u { $when } { $value }, sharchalarsiz { $without }. Tezlikni, qarshilikni yoki boshlang‘ich holatlarni o‘zgartiring.
balance-insufficient-capacity = Sharchalar { $without } disbalansning ko‘pi bilan { $value } qismini yo‘qota oladi. Og‘irroq yoki ko‘proq sharcha ishlating.
balance-unsettled = Disbalans { $when } hali barqarorlashmagan: sharchalar harakatda. Davomiylik oshirilsa, uning oxirgi qiymati ko‘rinishi mumkin.
balance-settling-time = Qoldiq disbalansning barqarorlashish vaqti { $value } (sharchalarsiz disbalansning { $share } aniqligida).
balance-masses-slip = { $count } ta sharcha rotor bilan birga aylanmaydi: ularning o‘rtacha tezligi { $value }, rotorniki { $speed }. Disbalans o‘zgarib turadi; qarshilikni oshirish yordam berishi mumkin.
balance-masses-caught = { $count } ta sharcha { $near } xususiy chastota yaqinida tutilib qolgan: ularning o‘rtacha tezligi { $value }, rotorniki { $speed }. Disbalans o‘zgarib turadi; bu chastotadan tezroq o‘ting yoki qarshilikni oshiring.
