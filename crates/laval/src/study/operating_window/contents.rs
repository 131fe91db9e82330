//! What a separation changes in the machine that is judged for stability: the same contents before and after it.
//!
//! Equations: a liquid of density rho_f with the volume fraction phi of particles of density rho_p fills the volume V of a cup evenly at first; after the separation the
//! particles lie at its bottom (light ones at its surface), y_p from the hinge instead of y_m:
//!
//! ```text
//! m_x = phi (rho_p - rho_f) V        l' = l + m_x (y_p - y_m)/m        Jy' = Jy + m_x (y_p^2 - int y^2 dy/(L - y_top))
//! ```
//!
//! Where liquid flows through (bowls, disc stacks, decanters) each liquid of the machine has the density of its file while the suspension fills it, and that density times
//! `rho_f/(rho_f + phi (rho_p - rho_f))` when it is clear.
//!
//! Validity: no thickness of the pellet, which bounds the change of l; the mass of cups and their contents stays.
//!
//! Sources: `theory/separation.md` section 13, couplings.

use crate::diagnostic::Diagnostic;
use crate::model::field::Attach;
use crate::model::system::System;
use crate::separation::load::Ring;
use crate::separation::machine::Separator;
use crate::study::duty::task::Task;

/// What is different after a separation.
#[derive(Clone, Debug)]
pub(super) struct Changed {
    /// The cups, all of them.
    pub cups: Vec<(Attach, Ring)>,
    /// Parameters of the machine by path.
    pub overrides: Vec<(String, f64)>,
}

/// What a task changes; `None`: nothing. `own` is the position among `cups` of the cup that separates.
pub(super) fn changed(system: &System, task: &Task, cups: &[(Attach, Ring)], own: Option<usize>) -> Option<Changed> {
    let (medium, rho) = (&task.suspension.medium, task.suspension.powder.density.quantile(0.5));
    let excess = medium.volume_fraction * (rho - medium.density);
    if excess == 0.0 {
        return None;
    }
    let mut out = Changed { cups: cups.to_vec(), overrides: vec![] };
    match (&task.vessel.separator, own) {
        (Separator::Cup(cup), Some(k)) => {
            let (v, body) = (&cup.vessel, &mut out.cups.get_mut(k)?.1.cup.body);
            let moved = excess * v.volume();
            let end = if excess > 0.0 { v.bottom } else { v.top };
            let (middle, square) = (0.5 * (v.top + v.bottom), (v.top * v.top + v.top * v.bottom + v.bottom * v.bottom) / 3.0);
            body.along += moved * (end - middle) / body.mass;
            body.moment_along += moved * (end * end - square);
        }
        (Separator::Tube(t, _), Some(k)) => {
            let body = &mut out.cups.get_mut(k)?.1.cup.body;
            let moved = excess * std::f64::consts::PI * t.radius * t.radius * (t.length - t.surface);
            let (end, middle) = (if excess > 0.0 { t.length } else { t.surface }, 0.5 * (t.surface + t.length));
            body.along += moved * (end - middle) / body.mass;
            body.moment_along = body.moment_along.max(body.mass * body.along * body.along);
        }
        (Separator::Cup(_) | Separator::Tube(..), None) => return None,
        _ => {
            let clear = medium.density / (medium.density + excess);
            for slot in system.slots().iter().filter(|s| s.part.kind() == "liquid") {
                let path = format!("{}.density", slot.name);
                let now = system.param(&path).and_then(|i| system.params().get(*i.first()?).copied());
                out.overrides.extend(now.map(|rho| (path, rho * clear)));
            }
            if out.overrides.is_empty() {
                return None;
            }
        }
    }
    Some(out)
}

/// The machine with these parameters.
pub(super) fn overridden(system: &System, overrides: &[(String, f64)]) -> Result<System, Diagnostic> {
    let by_path: Vec<(&str, f64)> = overrides.iter().map(|(p, x)| (p.as_str(), *x)).collect();
    system.with(&by_path).map_err(|d| {
        let why = d.0.into_iter().next().map(|d| d.message).unwrap_or_default();
        Diagnostic::error("operating_window.contents", format!("the machine with what it has separated does not exist: {why}"))
    })
}
