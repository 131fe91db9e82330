//! Texts of a liquid for findings about the places where its reaction is not analytic: inertial waves, layers at walls.

use crate::model::part::Words;

/// Without viscosity.
pub(super) const IDEAL: Words = Words {
    name: "an ideal liquid",
    waves: "inertial waves",
    dense: "are the dense range of inertial waves of an ideal liquid: on the imaginary axis there are roots without number, and with damping \
        outside it some of them always grow, slowly. What counts is growth above a threshold; viscosity decides about the rest.",
    slow: " With an ideal liquid and damping outside it the sign of the growth says nothing: its slow waves always grow, most of them too slowly \
        to be felt.",
    remedy: "A viscosity, model = \"strip\" or, as an approximation, axial_harmonics gives the liquid a response at every order",
    kept: "what is computed there are the waves of the axial harmonics kept, and every further harmonic puts others beside them; a viscosity decides",
    ..VISCOUS
};

/// With viscosity.
pub(super) const VISCOUS: Words = Words {
    name: "a viscous liquid",
    loss: "viscosity in the liquid",
    verdict: " Without damping outside the liquid that is every speed above the critical speed of the filled rotor; damping leaves a finite range, which little viscosity makes wide.",
    layer: "a layer at the wall",
    ..Words::PLAIN
};
