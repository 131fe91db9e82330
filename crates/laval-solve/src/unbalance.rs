//! What is left of the unbalance of a machine at a state: the force of everything that turns, with all bodies held in their places.
//!
//! ```text
//! U(W, z_b = 0) = -F/W^2 e^{-i th}         F: sum of the lateral forces on the bodies that turn with coordinates other than theirs frozen
//! G = 1000 W |U|/M                         grade number of ISO 21940-11, mm/s
//! ```
//!
//! Symbols: W spin speed, rad/s; th spin angle, rad; U unbalance, kg m; M mass of the bodies that turn and of all they carry, kg.
//!
//! Theory: `docs/theory/ball-balancers.md#stationary-states`.
//!
//! Sources: ISO 21940-11:2016 for the grade.

use crate::model::part::{At, DofKind, Rows};
use crate::model::system::{System, Workspace};
use laval_num::complex::{C64, c};
use serde::{Deserialize, Serialize};

/// Unbalance of a machine at a state.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Unbalance {
    /// In axes that turn with the rotor, kg m.
    pub moment: C64,
    /// What the parts that balance by themselves have in it, kg m.
    pub correction: C64,
    /// The most they can have, kg m.
    pub capacity: f64,
    /// Mass of the bodies that turn, kg.
    pub mass: f64,
    /// Largest force (N; of angles N m) with which movable masses push each other.
    pub contact: f64,
}

/// Share of what goes into it below which a difference is rounding.
const ROUNDING: f64 = 1e-12;

impl Unbalance {
    /// Without the movable masses, kg m; zero where it is rounding beside what the masses have.
    pub fn without(&self) -> f64 {
        let own = (self.moment - self.correction).abs();
        let size = self.moment.abs() + self.correction.abs() + self.capacity;
        if own <= ROUNDING * size { 0.0 } else { own }
    }
    /// Grade number of an unbalance (kg m) at a speed (rad/s), m/s.
    pub fn grade(&self, unbalance: f64, speed: f64) -> f64 {
        speed.abs() * unbalance / self.mass
    }
}

/// Unbalance at the configuration of `at`: of its coordinates those that do not turn with the machine count, such as the angles of balls.
pub fn unbalance(system: &System, at: &At<f64>, ws: &mut Workspace<f64>) -> Unbalance {
    let n = system.n();
    // what turns may change with the speed; where it hardly turns the forces are rounding beside the weight
    let top = if at.speed.abs() >= 1.0 { at.speed } else { 100.0 };
    let (zero, states) = (vec![0.0; n], vec![0.0; system.m()]);
    let kinds: Vec<DofKind> = system.coordinates().iter().map(|c| c.dof.kind).collect();
    let q: Vec<f64> = kinds.iter().zip(at.q).map(|(k, &q)| if k.leads_pair() || k.ends_pair() { 0.0 } else { q }).collect();
    let mut rows = |speed: f64, a: &[f64]| {
        let (mut force, mut rate, mut spin) = (vec![0.0; n], vec![0.0; system.m()], 0.0);
        let point = At { q: &q, v: &zero, a, z: &states, phase: 0.0, speed, spin_accel: 0.0, t: at.t };
        let mut out = Rows { force: &mut force, rate: &mut rate, spin: &mut spin };
        system.residual(system.params(), &point, &mut out, ws, |_| true);
        force
    };
    let (still, turning) = (rows(0.0, &zero), rows(top, &zero));
    let (mut moment, mut mass) = (C64::zero(), 0.0);
    let mut accelerated = zero.clone();
    for x in (0..n).filter(|&i| kinds[i] == DofKind::VectorX) {
        let own = c(still[x] - turning[x], still[x + 1] - turning[x + 1]).scale(1.0 / (top * top));
        if own != C64::zero() {
            moment += own;
            accelerated[x] = 1.0;
        }
    }
    if moment == C64::zero() {
        // nothing is out of balance: all bodies count
        (0..n).filter(|&i| kinds[i] == DofKind::VectorX).for_each(|x| accelerated[x] = 1.0);
    }
    let carried = rows(0.0, &accelerated);
    for x in (0..n).filter(|&i| accelerated[i] == 1.0) {
        mass += carried[x] - still[x];
    }
    let (mut correction, mut capacity, mut contact) = (C64::zero(), 0.0, 0.0);
    for (_, part) in system.corrections(&At { q: &q, v: &zero, a: &zero, z: &states, phase: 0.0, ..*at }, ws) {
        correction += c(part.moment[0], part.moment[1]);
        capacity += part.capacity;
        if !(part.contact <= contact) {
            contact = part.contact;
        }
    }
    Unbalance { moment, correction, capacity, mass, contact }
}
