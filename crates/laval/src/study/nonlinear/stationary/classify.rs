//! What kind of state it is, by what the bodies and the parts show of it.

use crate::model::part::{At, Observed};
use crate::model::probe::Probe;
use crate::model::system::{System, Workspace};
use crate::solve::characteristic::coordinate_sectors;
use crate::solve::stationary::images::wrapped;
use crate::solve::stationary::{Search, State};
use crate::solve::unbalance::{Unbalance, unbalance};
use crate::study::shared::support::{larger, largest};
use crate::study::shared::validity::Uses;
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// Kinds of states.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Class {
    /// No body is displaced or tilted.
    Balanced,
    /// A distance that the part with the movable masses shows is zero: its own centre lies on the axis.
    PartlyBalanced,
    /// The masses lie apart and leave less than half of the unbalance, as on a track that is slightly tilted.
    Reduced,
    /// Masses push each other.
    Touching,
    /// All masses of each part lie at one angle.
    Together,
    /// They lie on one line, some of them opposite the others.
    Opposed,
    /// They lie apart.
    Spread,
    /// No part has masses that move, or only one.
    Single,
}

/// Words of the classes, in order.
pub const WORDS: &[&str] = &["balanced", "partly_balanced", "reduced", "touching", "together", "opposed", "spread", "single"];

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
            Class::Reduced => "unbalance reduced",
            Class::Touching => "masses touching",
            Class::Together => "masses together",
            Class::Opposed => "masses opposed",
            Class::Spread => "masses apart",
            Class::Single => "single state",
        }
    }
    /// The masses do what they are there for.
    pub fn balances(self) -> bool {
        self <= Class::Reduced
    }
}

/// Displacements over those with the masses held anywhere that count as none.
const NONE: f64 = 1e-6;
/// Share of the unbalance below which masses that lie apart balance in part.
pub const HALF: f64 = 0.5;
/// Angles that are equal, rad.
const EQUAL: f64 = 1e-5;
/// Distance from the node line within which a mass is locked to it, rad.
const LOCKED: f64 = 0.3;
/// Places at which the masses are held for comparison.
const HELD: usize = 3;

/// What a state shows.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Seen {
    /// Displacements of the bodies in turning axes, m.
    pub bodies: Vec<[f64; 2]>,
    /// Distances from the axis of the other points of bodies where something is attached or that are named, m.
    pub points: Vec<f64>,
    /// Tilts of the bodies that tilt, rad.
    pub tilts: Vec<f64>,
    /// What the parts with movable masses show: part, quantity.
    pub quantities: Vec<(String, Observed)>,
    /// Angles of the exchangeable groups, wrapped, rad.
    pub groups: Vec<Vec<f64>>,
    /// The same, part by part.
    parts: Vec<Vec<f64>>,
    /// All masses of the parts that warn of themselves lie near the line their angles are counted from: the tilt of their tracks holds them there.
    pub locked: bool,
    /// The unbalance with the masses where they are; `None` where no part balances by itself.
    pub unbalance: Option<Unbalance>,
    /// Use of the parts' validity.
    pub uses: Uses,
}

/// The largest of what is seen with the masses held at some places at this speed.
#[derive(Clone, Debug, Default)]
pub struct Scale {
    radius: f64,
    tilt: f64,
    quantities: Vec<f64>,
}

impl Scale {
    /// At a speed.
    pub fn at(system: &System, search: &mut Search, speed: f64) -> Self {
        let held: Vec<Vec<f64>> = (0..HELD).filter_map(|k| search.start(k, speed)).collect();
        let all: Vec<Seen> = held.into_iter().map(|x| Seen::of(system, search, &State { branch: 0, speed, x, error: 0.0 })).collect();
        let count = all.first().map_or(0, |s| s.quantities.len());
        let quantity = |k: usize| largest(all.iter().filter_map(|s| s.quantities.get(k)).map(|q| q.1.value.abs()));
        Scale {
            radius: largest(all.iter().map(Seen::radius)),
            tilt: largest(all.iter().map(Seen::tilt)),
            quantities: (0..count).map(quantity).collect(),
        }
    }
}

impl Seen {
    /// Of a state.
    pub fn of(system: &System, search: &Search, state: &State) -> Self {
        let about = search.problem().equilibrium(&state.x, state.speed);
        let sectors = coordinate_sectors(system);
        let (v, a) = (about.velocity(&sectors), about.acceleration(&sectors));
        let at = At { q: &about.q, v: &v, a: &a, z: &about.z, phase: 0.0, speed: state.speed, spin_accel: 0.0, t: 0.0 };
        let (images, coordinates) = (search.images(), system.coordinates());
        let movable = |slot: usize| images.angles.iter().any(|&i| coordinates[i].slot == slot);
        let mut ws = Workspace::default();
        let shown = system.observe(&at, &mut ws);
        let quantities: Vec<(String, Observed)> =
            shown.into_iter().filter(|(k, _)| movable(*k)).map(|(k, o)| (system.slots()[k].name.clone(), o)).collect();
        let groups: Vec<Vec<f64>> = images.groups.iter().map(|g| g.iter().map(|&i| wrapped(about.q[i])).collect()).collect();
        // a ring that turns over is no mass
        let masses = images.angles.iter().filter(|&i| images.flips.iter().all(|f| f.0 != *i));
        let mut parts: Vec<(usize, Vec<f64>)> = Vec::new();
        for &i in masses {
            let slot = coordinates[i].slot;
            match parts.iter_mut().find(|p| p.0 == slot) {
                Some(p) => p.1.push(wrapped(about.q[i])),
                None => parts.push((slot, vec![wrapped(about.q[i])])),
            }
        }
        let near = |x: &f64| x.abs().min(PI - x.abs()) < LOCKED;
        let hindered: Vec<usize> = system.warnings().into_iter().map(|w| w.0).collect();
        let mut held = parts.iter().filter(|p| hindered.contains(&p.0)).peekable();
        let locked = held.peek().is_some() && held.all(|p| p.1.iter().all(near));
        let bodies = system.stations().iter().map(|s| s.lateral.of(&about.q)).collect();
        let size = |p: &Probe| {
            let [x, y] = p.of(&about.q);
            x.hypot(y)
        };
        let (tilts, points): (Vec<&Probe>, Vec<&Probe>) = system.probes().iter().filter(|p| !p.is_reference()).partition(|p| p.is_tilt());
        let [points, tilts] = [points, tilts].map(|all| all.into_iter().map(size).collect());
        let balancing = !system.corrections(&at, &mut ws).is_empty();
        let unbalance = balancing.then(|| unbalance(system, &at, &mut ws));
        let mut uses = Uses::default();
        uses.see(system, &at, &mut ws);
        Seen { bodies, points, tilts, quantities, groups, parts: parts.into_iter().map(|p| p.1).collect(), locked, unbalance, uses }
    }

    /// Largest distance of a point of a body from the axis, m.
    pub fn radius(&self) -> f64 {
        largest(self.bodies.iter().map(|b| b[0].hypot(b[1])).chain(self.points.iter().copied()))
    }

    /// Largest tilt of a body, rad.
    pub fn tilt(&self) -> f64 {
        largest(self.tilts.iter().copied())
    }

    /// Largest force (N; of angles N m) with which movable masses push each other.
    pub fn contact(&self) -> f64 {
        self.unbalance.map_or(0.0, |u| u.contact)
    }

    /// Unbalance over that without the movable masses; `None` where nothing is out of balance without them.
    pub fn share(&self) -> Option<f64> {
        let u = self.unbalance?;
        Some(u.moment.abs() / u.without()).filter(|share| u.without() > 0.0 && share.is_finite())
    }

    /// Its kind, beside what is seen at its speed with the masses held.
    pub fn class(&self, scale: &Scale) -> Class {
        if self.parts.is_empty() {
            return Class::Single;
        }
        if self.radius() <= NONE * scale.radius && self.tilt() <= NONE * scale.tilt {
            return Class::Balanced;
        }
        let none = |(q, most): (&(String, Observed), &f64)| q.1.unit == "m" && q.1.value.abs() <= NONE * larger(*most, scale.radius);
        if self.quantities.iter().zip(&scale.quantities).any(none) {
            return Class::PartlyBalanced;
        }
        let several = || self.parts.iter().filter(|g| g.len() > 1);
        if several().next().is_none() {
            return match self.share() {
                Some(share) if share < HALF => Class::Reduced,
                _ if self.parts.len() > 1 => Class::Spread,
                _ => Class::Single,
            };
        }
        let off = |g: &Vec<f64>, x: &f64| wrapped(x - g[0]).abs();
        if self.contact() > 0.0 {
            return if self.share().is_some_and(|share| share < HALF) { Class::Reduced } else { Class::Touching };
        }
        if several().all(|g| g.iter().all(|x| off(g, x) < EQUAL)) {
            Class::Together
        } else if several().all(|g| g.iter().all(|x| off(g, x) < EQUAL || PI - off(g, x) < EQUAL)) {
            Class::Opposed
        } else if self.share().is_some_and(|share| share < HALF) {
            Class::Reduced
        } else {
            Class::Spread
        }
    }
}
