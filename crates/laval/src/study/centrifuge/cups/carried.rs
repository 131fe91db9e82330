//! What separates, as a load of the machine that moves: cups that a body carries are a part of it, other vessels are not.

use super::vessel;
use crate::diagnostic::Diagnostics;
use crate::model::field::{Attach, Extra};
use crate::model::params::{Family, NoParams};
use crate::model::part::Part;
use crate::model::system::{PartInput, System};
use crate::outcome::{Arg, Finding};
use crate::separation::carried::Cups;
use crate::separation::load::Ring;

/// Cups that a body carries.
#[derive(Clone, Debug)]
pub struct Carried {
    /// Name of the block, and of the part.
    pub name: String,
    /// The body, and the height of the hinges on it.
    pub on: Attach,
    /// The cups.
    pub ring: Ring,
}

/// The cups of the machine's blocks that a body carries.
pub fn carried(system: &System) -> Vec<Carried> {
    let cups = system.machine.extras.iter().filter(|e| e.word == "cup");
    let found = cups.filter_map(|e| vessel(e, system, &mut Diagnostics::default()));
    found.filter_map(|v| v.load.map(|(on, ring)| Carried { name: v.name, on, ring })).collect()
}

/// The part that cups are.
pub fn part(extra: &Extra, system: &System) -> Option<PartInput> {
    let found = vessel(extra, system, &mut Diagnostics::default())?;
    let (on, ring) = found.load?;
    Some(PartInput { span: extra.values.span_of("on"), ..input(&Carried { name: found.name, on, ring }) })
}

fn input(c: &Carried) -> PartInput {
    let part = Cups::new(c.on.clone(), c.ring.clone()).erased();
    PartInput { name: c.name.clone(), part, params: NoParams::to_vec(&()), span: None }
}

/// The machine with other cups in the places of its own.
///
/// # Errors
/// As [`System::assemble`].
pub fn exchanged(system: &System, cups: &[Carried]) -> Result<System, Diagnostics> {
    let mut inputs = system.inputs();
    for c in cups {
        match inputs.iter_mut().find(|i| i.name == c.name) {
            Some(place) => *place = PartInput { span: place.span.clone(), ..input(c) },
            None => inputs.push(input(c)),
        }
    }
    System::assemble(system.machine.clone(), inputs)
}

/// The vessels of a machine that its dynamics know nothing of: cups that name no body to carry them, and bowls in a machine without liquid; one finding each, of all
/// vessels or of those with this name.
pub fn uncarried(system: &System, name: Option<&str>) -> Vec<Finding> {
    let requested = |e: &&Extra| e.word == "cup" && name.is_none_or(|n| e.name == n);
    let holds_liquid = system.slots().iter().any(|s| s.part.filling().is_some());
    let body = system.slots().iter().find(|s| s.part.body().is_some_and(|b| b.parameters().mass.is_some()));
    let reported = |e: &Extra| {
        let finding = match e.kind {
            "swinging" | "fixed_angle" if e.values.attach("on").is_none() => match body {
                Some(body) => Finding::warning("cups_not_carried", "cups-not-carried").arg("body", Arg::name(&body.name)),
                None => Finding::warning("cups_not_carried", "cups-not-carried-by-any"),
            },
            "tubular_bowl" | "disc_stack" | "decanter" if !holds_liquid => {
                Finding::warning("bowl_without_liquid", "cups-bowl-without-liquid")
            }
            _ => return None,
        };
        Some(finding.arg("vessel", Arg::name(&e.name)))
    };
    system.machine.extras.iter().filter(requested).filter_map(reported).collect()
}
