//! What "unstable" means: a growth that is felt, flutter of a machine without damping, or any growth where a part inside the rotor takes up energy.
//!
//! Waves that nothing inside a part damps have negative energy in fixed axes where they travel slower than the rotor turns: with any damping outside they grow at every speed, mostly so
//! slowly that nobody would notice. With losses inside and none outside the machine is unstable at every speed above a critical one. Both together leave a finite range. So the sign of
//! the growth alone says little of a machine with such waves; what a part has to say of itself it says in its [`Words`].
//!
//! Theory: `docs/theory/liquid-in-three-dimensions.md#stability-criteria`.

use crate::diagnostic::Diagnostic;
use crate::model::field::{Field, FieldKind, Values, Word};
use crate::model::part::{Domain, Words};
use crate::model::system::System;
use crate::outcome::{Arg, Finding};
use crate::solve::pencil::modes_about;
use crate::study::shared::support::About;
use crate::text;

const WORDS: &[Word] = &[
    ("growth", "growth above growth_threshold"),
    ("flutter", "two frequencies of a machine without damping meet; refused where something damps or drives"),
    ("viscous", "any growth, with what takes up energy inside the parts that turn; refused where no part has a layer that does"),
];
/// Field: what counts as unstable.
pub(in crate::study) const CRITERION: Field = Field::optional("criterion", FieldKind::Choice(WORDS), "growth", "what counts as unstable");

/// Relative distance of a root from the mirror image of another that is rounding.
const MIRROR: f64 = 1e-7;

/// What counts as unstable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Criterion {
    /// Growth above the threshold.
    Growth,
    /// Two frequencies of an undamped machine meet.
    Flutter,
    /// Any growth, with losses inside the parts.
    Viscous,
}

/// A part whose waves die out by what it takes up itself.
fn lossy(d: &Domain) -> bool {
    !d.left && d.gap.is_finite()
}

impl Criterion {
    /// From the field.
    pub(in crate::study) fn read(values: &Values) -> Self {
        match values.choice("criterion") {
            Some("flutter") => Criterion::Flutter,
            Some("viscous") => Criterion::Viscous,
            _ => Criterion::Growth,
        }
    }

    /// The machine is one for which this means something.
    ///
    /// # Errors
    /// A machine with damping for flutter, one without losses inside its parts for the growth with them.
    pub(in crate::study) fn admit(self, system: &System, about: About, speed: f64) -> Result<(), Diagnostic> {
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
                    text!("flutter is for machines that nothing damps or drives; this one has damping"),
                )
                .help(text!("set all damping to 0, or take criterion = \"growth\" with a growth_threshold")))
            }
            Criterion::Viscous if system.domains(speed).iter().any(lossy) => Ok(()),
            Criterion::Viscous => Err(Diagnostic::error(
                "stability_map.criterion",
                text!("no part of this machine has losses like the viscosity that this criterion is about"),
            )
            .help(text!("give one a viscosity, or take criterion = \"growth\" with a growth_threshold"))),
        }
    }

    /// What is called unstable.
    pub(in crate::study) fn finding(self, system: &System, speed: f64, threshold: f64) -> Finding {
        let domains = system.domains(speed);
        let dense = domains.iter().find(|d| d.dense.is_some()).map(|d| d.words);
        let Words { loss, verdict, .. } = domains.iter().find(|d| lossy(d)).map_or(Words::PLAIN, |d| d.words);
        let limit = Arg::quantity(threshold, "1/s");
        match (self, dense) {
            (Criterion::Growth, None) => Finding::info("criterion", "criterion-growth").arg("limit", limit),
            (Criterion::Growth, Some(words)) => {
                Finding::info("criterion", "criterion-growth-of-waves").arg("limit", limit).arg("part", Arg::term(words.name))
            }
            (Criterion::Flutter, _) => Finding::info("criterion", "criterion-flutter"),
            (Criterion::Viscous, _) => {
                let finding = match verdict.trim() {
                    "" => Finding::info("criterion", "criterion-viscous"),
                    verdict => Finding::info("criterion", "criterion-viscous-range").arg("range", Arg::term(verdict)),
                };
                finding.arg("limit", limit).arg("loss", Arg::term(loss))
            }
        }
    }
}
