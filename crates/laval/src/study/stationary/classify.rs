//! What kind of state it is, by what the bodies and the parts show of it.

use crate::model::part::{At, Observed};
use crate::model::system::{System, Workspace};
use crate::solve::characteristic::coordinate_sectors;
use crate::solve::stationary::images::wrapped;
use crate::solve::stationary::{Search, State};
use std::f64::consts::PI;

/// Kinds of states.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Class {
    /// No body is displaced.
    Balanced,
    /// A distance that the part with the movable masses shows is zero: its own centre lies on the axis.
    PartlyBalanced,
    /// All masses that may be exchanged lie at one angle.
    Together,
    /// Two of them lie opposite each other.
    Opposed,
    /// They lie apart.
    Spread,
    /// No part has masses that move.
    Single,
}

/// Words of the classes, in order.
pub const WORDS: &[&str] = &["balanced", "partly_balanced", "together", "opposed", "spread", "single"];

impl Class {
    /// The word in tables.
    pub fn word(self) -> &'static str {
        WORDS[self as usize]
    }
    /// In a sentence.
    pub fn words(self) -> &'static str {
        match self {
            Class::Balanced => "balanced",
            Class::PartlyBalanced => "partly balanced",
            Class::Together => "masses together",
            Class::Opposed => "masses opposed",
            Class::Spread => "masses apart",
            Class::Single => "state",
        }
    }
}

/// Displacements over those of other states at the same speed that count as none.
const NONE: f64 = 1e-6;
/// Angles that are equal, rad.
const EQUAL: f64 = 1e-5;
/// Distance from the node line within which a mass is locked to it, rad.
const LOCKED: f64 = 0.3;

/// What a state shows.
#[derive(Clone, Debug)]
pub struct Seen {
    /// Displacements of the bodies in turning axes, m.
    pub bodies: Vec<[f64; 2]>,
    /// What the parts with movable masses show: part, quantity.
    pub quantities: Vec<(String, Observed)>,
    /// Angles of the exchangeable groups, wrapped, rad.
    pub groups: Vec<Vec<f64>>,
    /// All masses of the parts that warn of themselves lie near the line their angles are counted from: the tilt of their tracks holds them there.
    pub locked: bool,
}

impl Seen {
    /// Of a state.
    pub fn of(system: &System, search: &Search, state: &State) -> Self {
        let about = search.problem().equilibrium(&state.x, state.speed);
        let sectors = coordinate_sectors(system);
        let (v, a) = (about.velocity(&sectors), about.acceleration(&sectors));
        let at = At { q: &about.q, v: &v, a: &a, z: &about.z, phase: 0.0, speed: state.speed, spin_accel: 0.0, t: 0.0 };
        let movable = |slot: usize| search.images().angles.iter().any(|&i| system.coordinates()[i].slot == slot);
        let shown = system.observe(&at, &mut Workspace::default());
        let quantities: Vec<(String, Observed)> =
            shown.into_iter().filter(|(k, _)| movable(*k)).map(|(k, o)| (system.slots()[k].name.clone(), o)).collect();
        let groups: Vec<Vec<f64>> = search.images().groups.iter().map(|g| g.iter().map(|&i| wrapped(about.q[i])).collect()).collect();
        let near = |x: &f64| x.abs().min(PI - x.abs()) < LOCKED;
        let hindered: Vec<usize> = system.warnings().into_iter().map(|w| w.0).collect();
        let slot = |group: &Vec<usize>| system.coordinates()[group[0]].slot;
        let held: Vec<bool> = search
            .images()
            .groups
            .iter()
            .zip(&groups)
            .filter(|(g, _)| hindered.contains(&slot(g)))
            .map(|(_, angles)| angles.iter().all(near))
            .collect();
        let locked = !held.is_empty() && held.into_iter().all(|x| x);
        let bodies = system.bodies().iter().map(|b| [about.q[b.x], about.q[b.x + 1]]).collect();
        Seen { bodies, quantities, groups, locked }
    }

    /// The largest displacement and the largest of every quantity over some states.
    pub fn largest(all: &[Seen]) -> (f64, Vec<f64>) {
        let radius = all.iter().flat_map(|s| &s.bodies).map(|b| b[0].hypot(b[1])).fold(0.0, f64::max);
        let count = all.first().map_or(0, |s| s.quantities.len());
        let of = |k: usize| all.iter().filter_map(|s| s.quantities.get(k)).map(|q| q.1.value.abs()).fold(0.0, f64::max);
        (radius, (0..count).map(of).collect())
    }

    /// Its kind, beside the largest displacements of all states at the speed.
    pub fn class(&self, (radius, quantities): &(f64, Vec<f64>)) -> Class {
        if self.groups.is_empty() {
            return Class::Single;
        }
        if self.bodies.iter().all(|b| b[0].hypot(b[1]) <= NONE * radius) {
            return Class::Balanced;
        }
        let none = |(q, most): (&(String, Observed), &f64)| q.1.unit == "m" && q.1.value.abs() <= NONE * most.max(*radius);
        if self.quantities.iter().zip(quantities).any(none) {
            return Class::PartlyBalanced;
        }
        let several = || self.groups.iter().filter(|g| g.len() > 1);
        if several().next().is_none() {
            return Class::Spread;
        }
        let together = |g: &Vec<f64>| g.iter().all(|x| wrapped(x - g[0]).abs() < EQUAL);
        let opposed = |g: &Vec<f64>| g.len() == 2 && PI - wrapped(g[1] - g[0]).abs() < EQUAL;
        if several().all(together) {
            Class::Together
        } else if several().all(opposed) {
            Class::Opposed
        } else {
            Class::Spread
        }
    }
}
