# Harakatning boshlanishi.

start-undeflected = Harakat deformatsiyalanmagan holatdan boshlanadi va undan o‘lchanadi: { $why }. Siljishlar yuk ostidagi deformatsiyani ham o‘z ichiga oladi.
