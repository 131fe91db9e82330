//! Parts that support what turns: bearings and springs to the ground or to a body that stands.

use super::Statics;
use super::forces::stiffness;
use crate::characteristic::{Equilibrium, Frame};
use crate::model::field::Attach;
use crate::model::part::Link;
use crate::model::system::{Pair, Slot, System};
use crate::rest::clearance;

/// A part that supports a turning body.
#[derive(Clone, Debug)]
pub struct Support {
    /// Slot of the part.
    pub slot: usize,
    /// Slot of the turning body.
    pub body: usize,
    /// Position on it, m.
    pub position: f64,
    /// Displacement of that place.
    pub place: Pair,
    /// The place belongs to a body that bends.
    pub flexible: bool,
}

fn slot_of<'a>(system: &'a System, attach: &Attach) -> Option<(usize, &'a Slot)> {
    let name = attach.body.as_ref()?;
    system.slots().iter().enumerate().find(|(_, s)| &s.name == name)
}

fn turns(slot: &Slot) -> bool {
    slot.part.body().is_some_and(|b| b.turns())
}

fn bends(slot: &Slot) -> bool {
    slot.part.body().is_some_and(|b| b.nodes().is_some())
}

/// The body whose coordinates a place is made of.
fn root(system: &System, place: &Pair) -> Option<usize> {
    Some(system.coordinates()[place.0[0].first()?.0].slot)
}

/// A rigid body with coordinates of its own that some other part joins to the ground: a pedestal.
fn stands(system: &System, own: usize) -> bool {
    let body = &system.slots()[own];
    let grounds = |s: &Slot| {
        s.layout.ports.iter().any(|p| {
            let mut ends = p.link.ends();
            ends.any(|a| a.body.is_none()) && p.link.bodies().any(|b| b == body.name)
        })
    };
    !body.own.is_empty() && !bends(body) && system.slots().iter().any(grounds)
}

/// The part has a gap that is open at a state of rest.
pub(crate) fn is_open(system: &System, slot: &Slot, at: &Statics) -> bool {
    let seen = system.slots().iter().position(|s| s.name == slot.name).map_or_else(|| at.q.clone(), |k| at.seen_by(k).into_owned());
    let about = Equilibrium { q: seen, z: at.z.clone(), ..Equilibrium::zero(system, Frame::Fixed, at.speed) };
    clearance(system, slot, &about).is_some_and(|gap| gap > 0.0)
}

/// kxx and kyy of a linear part at a speed (rad/s), N/m.
pub fn diagonal(system: &System, slot: usize, speed: f64) -> Option<[f64; 2]> {
    let slot = &system.slots()[slot];
    let n = slot.map.len();
    (slot.is_linear() && n >= 2).then(|| stiffness(system, slot, speed)).map(|k| [k[0], k[n + 1]])
}

/// The part holds its points at rest, x and y.
fn carries(system: &System, slot: &Slot, at: &Statics) -> bool {
    if slot.map.len() < 2 {
        return false;
    }
    if slot.is_linear() {
        let (k, n) = (stiffness(system, slot, at.speed), slot.map.len());
        return (0..2).all(|i| k[i * n + i] != 0.0);
    }
    !is_open(system, slot, at)
}

/// A part between the place of a turning body and another, of either order.
fn between(system: &System, slot: usize, admitted: impl Fn(usize, Option<(usize, &Slot)>) -> bool) -> Option<Support> {
    let one = |turning: &Attach, other: &Attach| -> Option<Support> {
        let (body, rotor) = slot_of(system, turning)?;
        let place = system.point(body, turning.position)?;
        let own = root(system, &place)?;
        let wanted = turns(rotor) && admitted(own, slot_of(system, other));
        wanted.then(|| Support { slot, body, position: turning.position, flexible: bends(&system.slots()[own]), place })
    };
    system.slots()[slot].layout.ports.iter().find_map(|port| match &port.link {
        Link::Between(a, b) => one(a, b).or_else(|| one(b, a)),
        Link::On(_) => None,
    })
}

/// The force of a part on its first point is that on the turning body, or on the first of two that turn.
pub fn turning_first(system: &System, slot: usize) -> bool {
    let Some(Link::Between(a, _)) = system.slots()[slot].layout.ports.first().map(|p| &p.link) else { return true };
    let first = slot_of(system, a);
    first.is_some_and(|(_, s)| turns(s)) || named(system, slot).is_none_or(|s| first.is_some_and(|(k, _)| k == s.body))
}

/// A part as support, whatever it joins a turning body to; `None` of one that joins none to anything.
pub fn named(system: &System, slot: usize) -> Option<Support> {
    between(system, slot, |_, other| other.is_none_or(|(_, s)| !turns(s))).or_else(|| between(system, slot, |_, _| true))
}

/// The part joins rotations: a drive or a piece of the shaft, which supports nothing.
fn joins_rotations(slot: &Slot) -> bool {
    slot.layout.ports.iter().any(|p| p.kind.twist)
}

/// All parts that join a turning body to the ground or to a body that does not turn, and hold it at a state of rest; of a shaft whose pedestals are discs
/// those to rigid bodies that stand on the ground.
pub fn supports(system: &System, at: &Statics) -> Vec<Support> {
    let holds = |slot: &Slot| !slot.layout.body && !joins_rotations(slot) && carries(system, slot, at);
    let parts = || (0..system.slots().len()).filter(|&k| holds(&system.slots()[k]));
    let found: Vec<Support> = parts().filter_map(|k| between(system, k, |_, other| other.is_none_or(|(_, s)| !turns(s)))).collect();
    if !system.slots().iter().any(bends) || found.iter().any(|s| s.flexible) {
        return found;
    }
    let pedestal = |own: usize, other: Option<(usize, &Slot)>| bends(&system.slots()[own]) && other.is_none_or(|(k, _)| stands(system, k));
    parts().filter_map(|k| between(system, k, pedestal)).collect()
}
