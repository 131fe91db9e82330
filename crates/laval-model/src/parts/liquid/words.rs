//! What a liquid says of the places where its reaction is not analytic.

use crate::model::part::Words;

/// Without viscosity.
pub(super) const IDEAL: Words = Words {
    name: "an ideal liquid",
    waves: "inertial waves",
    decides: "viscosity",
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
