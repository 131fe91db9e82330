//! What a machine keeps when it is turned about its axis: found by probing its residual, part by part.

use crate::model::part::{At, DofKind, Rows};
use crate::model::system::{Slot, System, Workspace};
use std::f64::consts::PI;

/// Turning that leaves the equations unchanged when the spin phase is turned along.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Symmetry {
    /// None.
    None,
    /// By half a turn: `z -> -z`. Only odd orders of vectors, even orders of scalars.
    Half,
    /// By a quarter: `z -> i z`. Orders 1, -3, 5, -7 of vectors; 0, 4, 8 of scalars.
    Quarter,
    /// By any angle: circular motion, one order.
    Circular,
}

impl Symmetry {
    /// Turns into which one period splits into equal parts (0 for [`Symmetry::Circular`]: one sample is enough).
    pub fn order(self) -> usize {
        match self {
            Symmetry::None => 1,
            Symmetry::Half => 2,
            Symmetry::Quarter => 4,
            Symmetry::Circular => 0,
        }
    }
    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Symmetry::None => "none",
            Symmetry::Half => "half turn",
            Symmetry::Quarter => "quarter turn",
            Symmetry::Circular => "any turn",
        }
    }
}

/// A part that changes when turned, and by how much relative to its own forces.
#[derive(Clone, Debug, PartialEq)]
pub struct Broken {
    /// Its name.
    pub part: String,
    /// Angle of the turn, rad.
    pub angle: f64,
    /// Largest change of its rows over their size.
    pub change: f64,
}

/// The largest symmetry of the machine at a spin speed, and the first part that breaks each larger one.
pub fn probe(system: &System, speed: f64) -> (Symmetry, Vec<Broken>) {
    let mut broken = Vec::new();
    for (symmetry, angles) in
        [(Symmetry::Circular, &[0.7, 2.1, 4.4][..]), (Symmetry::Quarter, &[0.5 * PI][..]), (Symmetry::Half, &[PI][..])]
    {
        let culprit = system.slots().iter().find_map(|slot| {
            angles.iter().find_map(|&angle| {
                let change = change_under_turn(system, slot, speed, angle);
                // NaN counts as a change
                (!(change < 1e-9)).then(|| Broken { part: slot.name.clone(), angle, change })
            })
        });
        match culprit {
            None => return (symmetry, broken),
            Some(b) => broken.push(b),
        }
    }
    (Symmetry::None, broken)
}

/// Largest change of one part's rows when the state and the phase are turned by `angle` and the rows turned back, over their size.
pub fn change_under_turn(system: &System, slot: &Slot, speed: f64, angle: f64) -> f64 {
    let mut seed = 0x9e37_79b9_7f4a_7c15u64;
    let mut random = move || {
        seed ^= seed << 13;
        seed ^= seed >> 7;
        seed ^= seed << 17;
        (seed >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    };
    let (n, m) = (system.n(), system.m());
    let rate = if speed == 0.0 { 1.0 } else { speed };
    let mut worst: f64 = 0.0;
    for _ in 0..3 {
        let mut sized = |power: i32| -> Vec<f64> {
            system
                .coordinates()
                .iter()
                .map(|c| random() * if c.dof.kind == DofKind::Scalar { 1.0 } else { c.dof.typical } * rate.powi(power))
                .collect()
        };
        let (q, v, a) = (sized(0), sized(1), sized(2));
        let z: Vec<f64> = system.states().iter().map(|s| random() * s.dof.typical).collect();
        let phase = random() * PI;
        let rows = |turn: f64| {
            let (mut q, mut v, mut a, mut z) = (q.clone(), v.clone(), a.clone(), z.clone());
            for x in [&mut q, &mut v, &mut a] {
                system.turn(x, turn);
            }
            system.turn_states(&mut z, turn);
            let at = At { q: &q, v: &v, a: &a, z: &z, phase: phase + turn, speed, spin_accel: 0.0, t: 0.0 };
            let (mut force, mut rate, mut spin) = (vec![0.0; n], vec![0.0; m], 0.0);
            let mut out = Rows { force: &mut force, rate: &mut rate, spin: &mut spin };
            system.residual(system.params(), &at, &mut out, &mut Workspace::default(), |s| s.name == slot.name);
            system.turn(&mut force, -turn);
            system.turn_states(&mut rate, -turn);
            (force, rate)
        };
        let (f0, r0) = rows(0.0);
        let (f1, r1) = rows(angle);
        for (x, y) in [(&f0, &f1), (&r0, &r1)] {
            let size = x.iter().fold(0.0f64, |s, x| s + x.abs());
            for (x, y) in x.iter().zip(y) {
                let change = if x == y { 0.0 } else { (x - y).abs() / size };
                if change > worst || change.is_nan() {
                    worst = change;
                }
            }
        }
    }
    worst
}
