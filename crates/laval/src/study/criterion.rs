//! What "unstable" means: a growth that is felt, flutter of a machine without damping, or any growth with viscosity.
//!
//! An ideal liquid whirls slower than the rotor with negative energy in fixed axes: with any damping outside the liquid it is unstable at every speed, mostly so slowly that nobody
//! would notice. A viscous liquid without damping outside is unstable at every speed above the critical speed of the filled rotor. Both together leave a finite range. So the sign
//! of the growth alone says little of a machine with an ideal liquid.

use super::support::About;
use crate::diagnostic::Diagnostic;
use crate::model::field::{Field, FieldKind, Values, Word};
use crate::model::system::System;
use crate::outcome::{Finding, quantity};
use crate::solve::pencil::modes_about;

const WORDS: &[Word] = &[
    ("growth", "growth above growth_threshold"),
    ("flutter", "two frequencies of a machine without damping meet; refused where something damps or drives"),
    ("viscous", "any growth, with viscosity in the liquid; refused where no part has a layer that takes up energy"),
];
/// Field: what counts as unstable.
pub(super) const CRITERION: Field = Field::optional("criterion", FieldKind::Choice(WORDS), "growth", "what counts as unstable");

/// Relative distance of a root from the mirror image of another that is rounding.
const MIRROR: f64 = 1e-7;

/// What counts as unstable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Criterion {
    /// Growth above the threshold.
    Growth,
    /// Two frequencies of an undamped machine meet.
    Flutter,
    /// Any growth with viscosity.
    Viscous,
}

impl Criterion {
    /// From the field.
    pub(super) fn read(values: &Values) -> Self {
        match values.choice("criterion") {
            Some("flutter") => Criterion::Flutter,
            Some("viscous") => Criterion::Viscous,
            _ => Criterion::Growth,
        }
    }

    /// The machine is one for which this means something.
    ///
    /// # Errors
    /// A machine with damping for flutter, one without viscosity for the growth with it.
    pub(super) fn admit(self, system: &System, about: About, speed: f64) -> Result<(), Diagnostic> {
        match self {
            Criterion::Growth => Ok(()),
            Criterion::Flutter => {
                let modes = modes_about(system, &about.find(system, speed, None)?, false)?.modes;
                let largest = modes.iter().map(|m| m.value.abs()).fold(0.0, f64::max);
                let mirrored = |z: laval_num::complex::C64| modes.iter().any(|m| (m.value + z.conj()).abs() <= MIRROR * largest);
                if modes.iter().all(|m| mirrored(m.value)) {
                    return Ok(());
                }
                Err(Diagnostic::error(
                    "stability_map.criterion",
                    "flutter is for machines that nothing damps or drives; this one has damping",
                )
                .help("set all damping to 0, or take criterion = \"growth\" with a growth_threshold"))
            }
            Criterion::Viscous if system.domains(speed).iter().any(|d| !d.left && d.gap.is_finite()) => Ok(()),
            Criterion::Viscous => {
                Err(Diagnostic::error("stability_map.criterion", "no part of this machine has the viscosity that this criterion is about")
                    .help("give the liquid a viscosity, or take criterion = \"growth\" with a growth_threshold"))
            }
        }
    }

    /// What was meant, in words.
    pub(super) fn finding(self, system: &System, speed: f64, threshold: f64) -> Finding {
        let ideal = system.domains(speed).iter().any(|d| d.dense.is_some());
        let text = match self {
            Criterion::Growth if ideal => format!(
                "Unstable means: growth above {}. With an ideal liquid and damping outside it the sign of the growth says nothing: slow waves of the liquid always grow, most of them too \
                 slowly to be felt.",
                quantity(threshold, "1/s")
            ),
            Criterion::Growth => format!("Unstable means: growth above {}.", quantity(threshold, "1/s")),
            Criterion::Flutter => "Unstable means: two frequencies of the undamped machine have met. Close to the edge growth rises with the square root of the distance.".into(),
            Criterion::Viscous => format!(
                "Unstable means: growth above {} with viscosity in the liquid. Without damping outside the liquid that is every speed above the critical speed of the filled rotor; damping \
                 leaves a finite range, which little viscosity makes wide.",
                quantity(threshold, "1/s")
            ),
        };
        Finding::info("criterion", text)
    }
}
