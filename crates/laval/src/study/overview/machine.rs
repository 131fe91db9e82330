//! Bodies and what joins them, for the drawing of the machine.

use crate::model::part::Link;
use crate::model::system::{Slot, System};
use crate::outcome::{Arg, Block};

/// Values shown of a part.
const MOST_LABELS: usize = 2;

/// Bodies first, then what joins them, in the order of the file.
pub(super) fn blocks(system: &System) -> Vec<Block> {
    let bodies = system.bodies();
    let is_body = |k: usize| bodies.iter().any(|b| b.slot == k);
    let body = |k: usize, slot: &Slot| Block::Body {
        name: slot.name.clone(),
        rotor: turns(system, k),
        labels: labels(system, slot),
        grounded: slot.part.body().is_some_and(|b| b.parameters().stiffness.is_some()),
        cavity: cavity(system, &slot.name),
    };
    let drawn = system.slots().iter().enumerate();
    let bodies: Vec<Block> = drawn.clone().filter(|(k, _)| is_body(*k)).map(|(k, s)| body(k, s)).collect();
    let links = drawn.filter(|(k, _)| !is_body(*k)).flat_map(|(_, s)| link(system, s));
    bodies.into_iter().chain(links).collect()
}

/// The body spins with the rotor: it can carry an unbalance.
fn turns(system: &System, slot: usize) -> bool {
    system.slots()[slot].part.body().is_some_and(|b| b.parameters().unbalance.is_some())
}

/// The first values of a part that are not 0, one of each pair over x and y.
fn labels(system: &System, slot: &Slot) -> Vec<Arg> {
    let mut out = Vec::new();
    let mut seen: Vec<&str> = Vec::new();
    for i in slot.params.clone() {
        let (declared, x) = (&system.param_slots()[i], system.params()[i]);
        let name = declared.name.strip_prefix(&slot.name).map_or("", |n| n.trim_start_matches('.'));
        let name = name.split('.').next().unwrap_or_default();
        if x != 0.0 && x.is_finite() && !seen.contains(&name) && out.len() < MOST_LABELS {
            seen.push(name);
            out.push(Arg::quantity(x, declared.unit));
        }
    }
    out
}

/// Radius, free surface and height of the cavity of a liquid in this body.
fn cavity(system: &System, body: &str) -> Option<(f64, f64, f64)> {
    let on = |s: &&Slot| s.layout.ports.iter().any(|p| matches!(&p.link, Link::On(a) if a.body.as_deref() == Some(body)));
    let (liquid, filling) = system.slots().iter().filter(on).find_map(|s| Some((s, s.part.filling()?)))?;
    let value = |name: &str| {
        let i = *system.param(&format!("{}.{name}", liquid.name))?.first()?;
        Some(system.params()[i])
    };
    let [radius, free_surface, height] = filling.cavity()?;
    Some((value(radius)?, value(free_surface)?, value(height)?))
}

fn link(system: &System, slot: &Slot) -> Option<Block> {
    let end = |a: &crate::model::field::Attach| a.body.clone().map(|b| (b, a.position));
    let ends = slot.layout.ports.iter().find_map(|p| match &p.link {
        Link::Between(a, b) => Some([end(a), end(b)]),
        Link::On(_) => None,
    });
    let ends = ends.or_else(|| {
        slot.layout.ports.iter().find_map(|p| match &p.link {
            Link::On(a) => Some([end(a), end(a)]),
            Link::Between(..) => None,
        })
    })?;
    Some(Block::Link { name: slot.name.clone(), kind: slot.part.kind(), ends, labels: labels(system, slot) })
}
