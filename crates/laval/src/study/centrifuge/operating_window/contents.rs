//! What a separation changes in the machine that is assessed for stability: the same contents before and after it.
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
//! Sources: `docs/theory/operating-window.md#change-of-the-contents`.

use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use crate::separation::cup::Hanging;
use crate::separation::exit::Cylinder;
use crate::separation::separator::Separator;
use crate::study::centrifuge::cups::task::Task;
use crate::study::centrifuge::cups::{Carried, exchanged};
use crate::text;

/// What is different after a separation.
#[derive(Clone, Debug)]
pub(super) struct Changed {
    /// The cups, all of them.
    pub cups: Vec<Carried>,
    /// Parameters of the machine by path.
    pub overrides: Vec<(String, f64)>,
}

/// What a task changes; `None`: nothing. `own` is the position among `cups` of the cup that separates.
pub(super) fn changed(system: &System, task: &Task, cups: &[Carried], own: Option<usize>) -> Option<Changed> {
    let (medium, rho) = (&task.suspension.medium, task.suspension.powder.density.quantile(0.5));
    let excess = medium.volume_fraction * (rho - medium.density);
    if excess == 0.0 {
        return None;
    }
    let mut out = Changed { cups: cups.to_vec(), overrides: vec![] };
    match (&task.vessel.separator, own) {
        (Separator::Cup(cup), Some(k)) => packed(&mut out.cups.get_mut(k)?.ring.cup.body, &cup.vessel, excess),
        (Separator::Tube(t, _), Some(k)) => {
            let inside = Cylinder { radius: t.radius, bottom: t.length, top: t.surface };
            packed(&mut out.cups.get_mut(k)?.ring.cup.body, &inside, excess);
        }
        (Separator::Cup(_) | Separator::Tube(..), None) => return None,
        _ => {
            let clear = medium.density / (medium.density + excess);
            for slot in system.slots() {
                let Some(liquid) = slot.part.filling() else { continue };
                let path = format!("{}.{}", slot.name, liquid.density());
                if let Some(&rho) = system.param(&path).and_then(|i| system.params().get(*i.first()?)) {
                    out.overrides.push((path, rho * clear));
                }
            }
            if out.overrides.is_empty() {
                return None;
            }
        }
    }
    Some(out)
}

/// The particles of a vessel, with the density `excess` more than the liquid they displace when spread over it, gathered at its bottom (light ones at its surface).
fn packed(body: &mut Hanging, v: &Cylinder, excess: f64) {
    let moved = excess * v.volume();
    let end = if excess > 0.0 { v.bottom } else { v.top };
    body.along += moved * (end - 0.5 * (v.top + v.bottom)) / body.mass;
    body.moment_along += moved * (end * end - (v.top * v.top + v.top * v.bottom + v.bottom * v.bottom) / 3.0);
}

/// The machine after the separation.
pub(super) fn after(system: &System, changed: &Changed) -> Result<System, Diagnostic> {
    let by_path: Vec<(&str, f64)> = changed.overrides.iter().map(|(p, x)| (p.as_str(), *x)).collect();
    system.with(&by_path).and_then(|s| exchanged(&s, &changed.cups)).map_err(|d| {
        let why = d.into_error().message;
        Diagnostic::error("operating_window.contents", text!("the machine with what it has separated does not exist: {why}", why))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Slices of the suspension, before and after, summed one by one.
    #[test]
    fn slices_add_up() {
        let v = Cylinder { radius: 0.04, bottom: 0.3, top: 0.05 };
        let (empty, density, n) = ((1.4, 0.2, 0.08), 900.0, 20_000);
        let height = (v.bottom - v.top) / n as f64;
        let area = std::f64::consts::PI * v.radius * v.radius;
        let filled = |extra: f64| -> Hanging {
            let slice = |k: usize| (area * height * (density + extra), v.top + height * (k as f64 + 0.5));
            let sum = |p: i32| (0..n).map(|k| slice(k).0 * slice(k).1.powi(p)).sum::<f64>();
            let mass = empty.0 + sum(0);
            let along = (empty.0 * empty.1 + sum(1)) / mass;
            Hanging { mass, along, moment_along: empty.2 + sum(2), ..Hanging::point(mass, along) }
        };
        for excess in [150.0, -60.0] {
            let mut body = filled(excess);
            packed(&mut body, &v, excess);
            // clear liquid, and what the particles weigh more (light ones: less) at the end
            let (clear, end, m) = (filled(0.0), if excess > 0.0 { v.bottom } else { v.top }, excess * v.volume());
            let along = (clear.mass * clear.along + m * end) / (clear.mass + m);
            assert!((body.mass / (clear.mass + m) - 1.0).abs() < 1e-12);
            assert!(
                (body.along / along - 1.0).abs() < 1e-8 && (body.moment_along / (clear.moment_along + m * end * end) - 1.0).abs() < 1e-8
            );
            // both move the centre of mass to the bottom
            assert!(body.along > filled(excess).along);
        }
    }
}
