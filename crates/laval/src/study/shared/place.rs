//! A point of a body, as a field of a study.

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::assemble::outside;
use crate::model::field::{Attach, Values};
use crate::model::system::System;
use crate::outcome::{Arg, Message};
use crate::text;

/// Digits of a position in a sentence.
const DIGITS: u8 = 6;

/// The point that a field names; `None` where it is not given, or does not exist.
pub fn read(field: &str, values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<Attach> {
    let place = values.attach(field)?;
    let name = place.body.clone()?;
    let bodies = || system.slots().iter().filter(|s| s.layout.body).map(|s| s.name.as_str());
    let Some(slot) = system.slot(&name).filter(|s| s.layout.body) else {
        diagnostics.push(
            Diagnostic::error("body.missing", text!("there is no body \"{name}\"", name))
                .at(values.span_of(field))
                .about(name)
                .help(text!("bodies of this machine: {all}", all = bodies().collect::<Vec<_>>().join(", "))),
        );
        return None;
    };
    let ends = slot.part.body().and_then(|b| b.nodes()).and_then(|n| Some([*n.first()?, *n.last()?]));
    if let Some(why) = ends.and_then(|ends| outside(place.position, ends)) {
        diagnostics.push(Diagnostic::error("body.position", why).at(values.span_of(field)));
        return None;
    }
    Some(place)
}

/// The point in a sentence: the body, and where it is on a body with several points.
pub fn label(place: &Attach) -> Arg {
    let body = Arg::name(place.body.clone().unwrap_or_default());
    if place.position == 0.0 {
        return body;
    }
    Message::new("label-point").arg("body", body).arg("height", Arg::quantity(place.position, "m").digits(DIGITS)).into()
}
