//! Bodies and what joins them, for the drawing of the machine.

use crate::model::field::Attach;
use crate::model::part::{At, Link, Physics};
use crate::model::system::{Slot, System, Workspace};
use crate::model::tangent::{SparseTangent, TangentScratch, Triplets};
use crate::outcome::{Arg, Block, Joint};
use crate::study::shared::stations::{Stations, carriers};

/// Values shown of a part.
const MOST_LABELS: usize = 2;

/// Bodies first, then what joins them, in the order of the file.
pub(super) fn blocks(system: &System) -> Vec<Block> {
    let mut bodies: Vec<usize> = system.stations().iter().map(|s| s.slot).collect();
    bodies.dedup();
    let stations = Stations::of(system);
    let is_body = |k: usize| bodies.contains(&k);
    let of = |name: &str| stations.all.iter().find(|s| s.body == name);
    let body = |&k: &usize| {
        let slot = &system.slots()[k];
        let own = slot.part.body().is_some_and(|b| b.parameters().stiffness.is_some());
        Block::Body {
            name: slot.name.clone(),
            rotor: slot.part.body().is_some_and(|b| b.turns()) && !pedestal(system, k, &bodies),
            flexible: slot.part.body().is_some_and(|b| b.nodes().is_some()),
            labels: labels(system, slot),
            grounded: if own { joint(system, slot) } else { Joint::default() },
            cavity: cavity(system, &slot.name),
            profile: slot.part.body().map(|b| b.profile(&system.params()[slot.params.clone()])).unwrap_or_default(),
            place: of(&slot.name).map_or(0.0, |s| s.place - s.height),
            axis: of(&slot.name).map_or([0.0; 2], |s| s.axis),
        }
    };
    let others = system.slots().iter().enumerate().filter(|(k, _)| !is_body(*k));
    let others: Vec<Block> = others
        .filter_map(|(_, s)| balls(system, s).or_else(|| liquid(system, s)).or_else(|| wheels(system, s)).or_else(|| link(system, s)))
        .collect();
    bodies.iter().map(body).chain(others).collect()
}

/// A body with coordinates of its own between a shaft and the ground: what stands below a bearing, whatever kind of part makes it.
fn pedestal(system: &System, k: usize, bodies: &[usize]) -> bool {
    let slot = &system.slots()[k];
    let bends = |k: usize| system.slots()[k].part.body().is_some_and(|b| b.nodes().is_some());
    let carrier = |k: usize| {
        system.slots()[k].layout.ports.iter().find_map(|p| match &p.link {
            Link::On(a) => a.body.as_deref(),
            Link::Between(..) => None,
        })
    };
    let number = |name: &str| bodies.iter().copied().find(|k| system.slots()[*k].name == name);
    // of the rotor: a shaft, and what it carries
    let on_shaft = |name: &str| number(name).is_some_and(|k| bends(k) || carrier(k).and_then(number).is_some_and(bends));
    if bends(k) || carrier(k).is_some() {
        return false;
    }
    // bodies that parts join with it; none is the ground
    let joined = |part: &Slot| -> Option<Option<String>> {
        part.layout.ports.iter().find_map(|p| match &p.link {
            Link::Between(a, b) if a.body.as_deref() == Some(&*slot.name) => Some(b.body.clone()),
            Link::Between(a, b) if b.body.as_deref() == Some(&*slot.name) => Some(a.body.clone()),
            _ => None,
        })
    };
    let held = |part: &Slot| joint(system, part).elastic;
    let own = slot.part.body().is_some_and(|b| b.parameters().stiffness.is_some());
    let others = || system.slots().iter().filter_map(|s| Some((s, joined(s)?)));
    let grounded = own || others().any(|(s, to)| to.is_none() && held(s));
    grounded && others().any(|(_, to)| to.is_some_and(|name| on_shaft(&name)))
}

/// The first values of a part that are not 0; what is the same in x and y stands once.
fn labels(system: &System, slot: &Slot) -> Vec<Arg> {
    let mut out = Vec::new();
    for i in slot.params.clone() {
        let (declared, x) = (&system.param_slots()[i], system.params()[i]);
        let label = Arg::quantity(x, declared.unit);
        // a value that the file need not give tells nothing
        if Some(x) != declared.default && x != 0.0 && x.is_finite() && !out.contains(&label) && out.len() < MOST_LABELS {
            out.push(label);
        }
    }
    out
}

/// A liquid in the cavity of a body.
fn liquid(system: &System, slot: &Slot) -> Option<Block> {
    let filling = slot.part.filling()?;
    let body = slot.layout.ports.iter().find_map(|p| match &p.link {
        Link::On(a) => a.body.clone(),
        Link::Between(..) => None,
    })?;
    let value = |name: &str| {
        let i = *system.param(&format!("{}.{name}", slot.name))?.first()?;
        Some(system.params()[i])
    };
    let [radius, free_surface, _] = filling.cavity()?;
    let fill = 1.0 - (value(free_surface)? / value(radius)?).powi(2);
    Some(Block::Liquid { name: slot.name.clone(), body, fill, density: value(filling.density())? })
}

/// Two wheels in mesh.
fn wheels(system: &System, slot: &Slot) -> Option<Block> {
    let wheels = slot.part.mesh()?.wheels(&system.params()[slot.params.clone()]);
    let [Some(a), Some(b)] = carriers(slot) else { return None };
    let end = |a: &Attach| Some((a.body.clone()?, a.position));
    Some(Block::Wheels { name: slot.name.clone(), ends: [end(a)?, end(b)?], radii: wheels.radii, labels: labels(system, slot) })
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

/// What a part is made of: its force on a displacement and on a velocity against each of them, where nothing is displaced. A force law that begins with no
/// stiffness, and an exact reaction over the frequency, are springs.
fn joint(system: &System, slot: &Slot) -> Joint {
    let (zero, states) = (vec![0.0; system.n()], vec![0.0; system.m()]);
    let speed = system.machine.speed.unwrap_or(0.0);
    let at = At { q: &zero, v: &zero, a: &zero, z: &states, phase: 0.0, speed, spin_accel: 0.0, t: 0.0 };
    let gap = slot.part.contacts().and_then(|contacts| {
        let p = &system.params()[slot.params.clone()];
        system.with_local(slot, &at, &mut Workspace::default(), |l| contacts.clearance(p, l))
    });
    let gap = gap.is_some_and(|g| g > 0.0);
    if matches!(slot.physics, Physics::Frequency(_)) {
        return Joint { elastic: true, damped: false, gap };
    }
    let (mut t, mut scratch) = (SparseTangent::default(), TangentScratch::default());
    system.tangent(&at, false, &mut t, &mut scratch, |s| s.name == slot.name);
    let acts = |m: &Triplets| m.0.iter().any(|&(i, j, x)| i == j && x != 0.0);
    let damped = acts(&t.v);
    let elastic = acts(&t.q) || !slot.is_linear() || !damped;
    Joint { elastic, damped, gap }
}

/// Masses that move in a body, as balls in their tracks.
fn balls(system: &System, slot: &Slot) -> Option<Block> {
    let masses = slot.part.movable_masses()?;
    let body = slot.layout.ports.iter().find_map(|p| match &p.link {
        Link::On(a) => a.body.clone(),
        Link::Between(a, _) => a.body.clone(),
    })?;
    let (zero, states) = (vec![0.0; system.n()], vec![0.0; system.m()]);
    let at = At { q: &zero, v: &zero, a: &zero, z: &states, phase: 0.0, speed: 0.0, spin_accel: 0.0, t: 0.0 };
    let p = &system.params()[slot.params.clone()];
    let outlines = system.with_local(slot, &at, &mut Workspace::default(), |l| masses.outlines(p, l));
    let count = outlines.iter().filter(|o| o.movable).count();
    let tracks = outlines.len() - count;
    (count > 0).then(|| Block::Balls { name: slot.name.clone(), body, count, tracks: tracks.max(1), labels: labels(system, slot) })
}

fn link(system: &System, slot: &Slot) -> Option<Block> {
    let end = |a: &Attach| a.body.clone().map(|b| (b, a.position));
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
    let joint = joint(system, slot);
    Some(Block::Link { name: slot.name.clone(), kind: slot.part.kind(), ends, labels: labels(system, slot), joint })
}
