# Roots of a machine with rational time forms against those of the exact machine.

moved-roots-growing = growing roots
moved-roots-beyond = roots with growth or decay above { $margin }
moved-roots = Rational time forms move { $roots } by at most { $value }.
moved-roots-lost = { $lost ->
        [one] One of the { $roots } has
       *[other] { $lost } of the { $roots } have
    } no counterpart in the exact machine; the others move by at most { $value }. Growth in this motion may come from the rational time forms; use a smaller time_error.
moved-roots-all-lost = None of the { $roots } has a counterpart in the exact machine. Growth in this motion may come from the rational time forms; use a smaller time_error.
moved-roots-none = The machine with rational time forms has no { $roots }; none was compared with the exact machine.
