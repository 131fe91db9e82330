//! A machine of many coordinates as one of few, for motions in time.
//!
//! Linear parts whose matrices are those of any speed, and whose loads grow with its square, become one structure over the ports of all other parts and some modes
//! ([`crate::reduction`]). What is left of the machine sees its coordinates through the basis.

use crate::characteristic::{Equilibrium, Frame};
use crate::harmonic::balance::condense::Basis;
use crate::large::{is_large, usual_frequency};
use crate::model::part::{At, Physics};
use crate::model::projected::Structure;
use crate::model::system::{Drive, Slot, System};
use crate::model::tangent::{SparseTangent, TangentOf, TangentScratch};
use crate::reduction::{Reduced, Reduction, projected};
use laval_num::dense::Mat;
use std::sync::Arc;

/// Frequency up to which the reduced machine is compared, over the largest speed at least; difference of its receptance that is enough; coordinates at most.
const OF_SPEED: f64 = 8.0;
const ENOUGH: f64 = 1e-4;
const MOST: usize = 120;
/// Difference of matrices at speeds that are one but for rounding, over their size.
const SAME: f64 = 1e-12;

/// A machine over few coordinates.
pub struct ReducedMachine {
    /// The machine.
    pub system: Arc<System>,
    /// What it was reduced to.
    pub reduced: Reduced,
    /// Its coordinates over those of the whole machine.
    inverse: Mat,
    n: usize,
    basis: Mat,
    /// Which parts the structure stands for.
    inside: Vec<bool>,
    structure: Structure,
}

/// Tangent and loads of some linear parts at rest, at a spin speed, phase and spin acceleration.
fn at(system: &System, [speed, phase, spin_accel]: [f64; 3], which: impl Fn(&Slot) -> bool) -> SparseTangent {
    let (q, z) = (vec![0.0; system.n()], vec![0.0; system.m()]);
    let at = At { q: &q, v: &q, a: &q, z: &z, phase, speed, spin_accel, t: 0.0 };
    let (mut tangent, mut scratch) = (SparseTangent::default(), TangentScratch::default());
    system.tangent(&at, false, &mut tangent, &mut scratch, which);
    tangent
}

/// Its matrices are K + W N, C + W G and M at every speed, and its loads f0 + W^2 f.
pub(crate) fn is_plain(system: &System, slot: &Slot) -> bool {
    if slot.physics != Physics::Linear || !slot.states.is_empty() || slot.part.contacts().is_some() || slot.part.movable_masses().is_some()
    {
        return false;
    }
    if slot.is_steady() {
        return true;
    }
    let w = system.machine.speed.filter(|w| *w != 0.0).unwrap_or(100.0);
    let [a, b, c, d] = [0.0, w, 2.0 * w, 3.0 * w].map(|w| at(system, [w, 0.6, 0.0], |s| s.name == slot.name));
    let entries = |t: &SparseTangent, k: usize| -> Vec<f64> {
        let list = [&t.q, &t.v, &t.a][k.min(2)];
        if k < 3 { list.0.iter().map(|e| e.2).collect() } else { t.force.clone() }
    };
    // loads of another spin have another angle than those of the structure
    let turned = |phase: f64| entries(&at(system, [w, phase, 0.0], |s| s.name == slot.name), 3);
    if slot.ratio.is_some() && turned(0.0) != turned(1.0) {
        return false;
    }
    // second differences, third ones of the loads
    (0..4).all(|k| {
        let [a, b, c, d] = [&a, &b, &c, &d].map(|t| entries(t, k));
        let size = a.iter().chain(&d).fold(0.0f64, |m, x| m.max(x.abs()));
        let even = |i: usize| if k < 3 { d[i] - 2.0 * c[i] + b[i] } else { d[i] - 3.0 * c[i] + 3.0 * b[i] - a[i] };
        let near = |i: usize| a[i] - 2.0 * b[i] + c[i];
        (0..a.len()).all(|i| even(i).abs() <= SAME * size && (k == 3 || near(i).abs() <= SAME * size))
    })
}

impl ReducedMachine {
    /// Of a machine of many states, for motions up to a spin speed (rad/s). `None` of a small machine, of one whose spin is free, and where the receptance of the ports is not met.
    pub fn of(system: &System, fastest: f64) -> Option<Self> {
        Self::varying(system, fastest, &[])
    }

    /// The same, with these parts (by slot) left as they are, so that their parameters may vary: [`ReducedMachine::member`].
    pub fn varying(system: &System, fastest: f64, varied: &[usize]) -> Option<Self> {
        if !is_large(system) || system.machine.drive == Drive::Free {
            return None;
        }
        let plain = |(k, s): (usize, &Slot)| !varied.contains(&k) && is_plain(system, s);
        let inside: Vec<bool> = system.slots().iter().enumerate().map(plain).collect();
        let is_inside = |s: &Slot| system.slots().iter().zip(&inside).any(|(o, inside)| *inside && o.name == s.name);
        let n = system.n();
        let mut ports = Basis::default();
        for slot in system.slots().iter().zip(&inside).filter(|(_, inside)| !**inside).map(|x| x.0) {
            for row in &slot.map {
                ports.express(row, n);
            }
        }
        let about = Equilibrium::zero(system, Frame::Fixed, fastest);
        let frequency = if fastest == 0.0 { usual_frequency(system, &about) } else { OF_SPEED * fastest.abs() };
        let found = Reduction::new(system, &is_inside, &ports.rows, frequency, &[0.0, fastest], ENOUGH, MOST.min(n / 2))?;
        let basis = &found.basis;
        let over = |given: [f64; 3]| {
            let mut t = TangentOf::<Mat>::default();
            projected(basis, &at(system, given, is_inside), &mut t);
            t
        };
        let (quarter, half) = (std::f64::consts::FRAC_PI_2, std::f64::consts::PI);
        let (still, turning, later) = (over([0.0; 3]), over([1.0, 0.0, 0.0]), over([1.0, quarter, 0.0]));
        let (accelerated, beyond, behind) = (over([0.0, 0.0, 1.0]), over([0.0, quarter, 1.0]), over([0.0, half, 1.0]));
        let less = |a: &Mat, b: &Mat| Mat::from_fn(a.rows(), a.cols(), |i, j| a[(i, j)] - b[(i, j)]);
        let load = |t: &TangentOf<Mat>| -> Vec<f64> { still.force.iter().zip(&t.force).map(|(f, g)| f - g).collect() };
        let constant: Vec<f64> = load(&accelerated).iter().zip(load(&behind)).map(|(a, b)| 0.5 * (a + b)).collect();
        let beside = |t: &TangentOf<Mat>| load(t).iter().zip(&constant).map(|(x, c)| x - c).collect();
        let (cos, sin) = (beside(&accelerated), beside(&beyond));
        let structure = Structure {
            gyroscopic: less(&turning.v, &still.v),
            circulatory: less(&turning.q, &still.q),
            spin_accel_stiffness: less(&accelerated.q, &still.q),
            force: still.force.iter().map(|f| -f).collect(),
            turning: [load(&turning), load(&later)],
            spin_accel: [constant, cos, sin],
            mass: still.a,
            damping: still.v,
            stiffness: still.q,
        };
        let inverse = found.inverse(&at(system, [0.0; 3], is_inside).a, &ports.rows);
        let own = Arc::new(system.projected(basis, &inside, structure.clone()));
        Some(ReducedMachine { system: own, reduced: found.summary(), inverse, n, basis: found.basis, inside, structure })
    }

    /// The machine with other parameters of parts that were left as they are, over the same coordinates. `None` where another part is attached to it elsewhere.
    pub fn member(&self, whole: &System, changed: &System) -> Option<System> {
        let same = |(a, b): (&Slot, &Slot)| a.map == b.map && a.states == b.states;
        let fits = whole.slots().len() == changed.slots().len() && whole.slots().iter().zip(changed.slots()).all(same);
        fits.then(|| changed.projected(&self.basis, &self.inside, self.structure.clone()))
    }

    /// A state (q, v, z) of the whole machine in its own coordinates: displacements of the ports, and of the modes what the inertia sees.
    pub fn state(&self, y: &[f64]) -> Vec<f64> {
        let part = |from: usize| self.coordinates(&y[from..from + self.n]);
        [part(0), part(self.n), y[2 * self.n..].to_vec()].concat()
    }
    /// Coordinates or rates of the whole machine in its own.
    pub fn coordinates(&self, x: &[f64]) -> Vec<f64> {
        (0..self.inverse.rows()).map(|i| self.inverse.row(i).iter().zip(x).map(|(a, x)| a * x).sum()).collect()
    }
}
