//! What separates in a machine without being part of the machine that moves.

use crate::model::field::Extra;
use crate::model::system::System;
use crate::outcome::Finding;

/// The vessels of a machine that its dynamics know nothing of: cups that name no body to carry them, and bowls in a machine without liquid; one finding each, of all
/// vessels or of those with this name.
pub fn uncarried(system: &System, name: Option<&str>) -> Vec<Finding> {
    let asked = |e: &&Extra| e.word == "cup" && name.is_none_or(|n| e.name == n);
    let holds_liquid = system.slots().iter().any(|s| system.param(&format!("{}.cavity_radius", s.name)).is_some());
    let body = system.slots().iter().find(|s| s.layout.body && system.param(&format!("{}.mass", s.name)).is_some());
    let body = body.map_or("the body that carries them", |s| s.name.as_str());
    let told = |e: &Extra| {
        let name = &e.name;
        match e.kind {
            "swinging" | "fixed_angle" if e.values.attach("on").is_none() => Some(Finding::warning(
                "cups_not_carried",
                format!(
                    "\"{name}\" hangs on no body: neither its mass nor its unbalance is in the dynamics of this machine. Say what carries it, as on = \"{body}\", with mass and \
                     centre_of_mass."
                ),
            )),
            "tubular_bowl" | "disc_stack" | "decanter" if !holds_liquid => Some(Finding::warning(
                "bowl_without_liquid",
                format!(
                    "The liquid in \"{name}\" is not in the dynamics of this machine: add [[part]] with kind = \"liquid\" in the body that is the bowl (or its mass to that body)."
                ),
            )),
            _ => None,
        }
    };
    system.machine.extras.iter().filter(asked).filter_map(told).collect()
}
