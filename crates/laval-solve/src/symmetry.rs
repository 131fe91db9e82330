//! What a machine keeps when it is turned about its axis: found by probing its residual, part by part.

use crate::model::part::{At, DofKind, Physics, Rows};
use crate::model::system::{GlobalDof, Slot, System, Workspace};
use laval_num::complex::{C64, c};
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// Turning that leaves the equations unchanged when the spin phase is turned along.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
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
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Broken {
    /// Its name.
    pub part: String,
    /// Angle of the turn, rad.
    pub angle: f64,
    /// Largest change of its rows over their size.
    pub change: f64,
}

/// The largest symmetry of the machine at every one of some spin speeds (rad/s), and the first part that breaks each larger one.
///
/// Parts whose coefficients depend on the speed may be symmetric at one speed and not at another, so a range is probed at several.
pub fn probe(system: &System, speeds: &[f64]) -> (Symmetry, Vec<Broken>) {
    let mut broken = Vec::new();
    for (symmetry, angles) in
        [(Symmetry::Circular, &[0.7, 2.1, 4.4][..]), (Symmetry::Quarter, &[0.5 * PI][..]), (Symmetry::Half, &[PI][..])]
    {
        let culprit = system.slots().iter().find_map(|slot| {
            speeds.iter().flat_map(|&w| angles.iter().map(move |&a| (w, a))).find_map(|(speed, angle)| {
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

/// Speeds at which a range is probed: its ends and an irregular choice between.
pub fn probed_speeds((lo, hi): (f64, f64)) -> Vec<f64> {
    let golden = |k: f64| (0.618_033_988_749_895 * k).fract();
    [0.0, 1.0].into_iter().chain((1..=6).map(|k| golden(f64::from(k)))).map(|t| lo + t * (hi - lo)).collect()
}

/// Largest change of one part's rows when the state and the phase are turned by `angle` and the rows turned back, over the size of the rows of
/// their kind (forces, moments, rates).
pub fn change_under_turn(system: &System, slot: &Slot, speed: f64, angle: f64) -> f64 {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let (n, m) = (system.n(), system.m());
    let rate = if speed == 0.0 { 1.0 } else { speed };
    let mut worst: f64 = 0.0;
    for _ in 0..3 {
        let mut sized = |power: i32| -> Vec<f64> {
            system
                .coordinates()
                .iter()
                .map(|c| random.next() * if c.dof.kind == DofKind::Scalar { 1.0 } else { c.dof.typical } * rate.powi(power))
                .collect()
        };
        let (q, v, a) = (sized(0), sized(1), sized(2));
        let z: Vec<f64> = system.states().iter().map(|s| random.next() * s.dof.typical).collect();
        let phase = random.next() * PI;
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
        let ((f0, r0), (f1, r1)) = (rows(0.0), rows(angle));
        let kinds = |dofs: &[GlobalDof]| dofs.iter().map(|d| d.dof.kind).collect::<Vec<_>>();
        note(&mut worst, &kinds(system.coordinates()), &f0, &f1);
        note(&mut worst, &kinds(system.states()), &r0, &r1);
        if matches!(slot.physics, Physics::Frequency(_)) {
            for s in [c(0.0, rate), c(0.0, 3.0 * rate), c(0.3 * rate, -0.7 * rate)] {
                let turned = |turn: f64| impedance_force(system, slot, speed, s, [&q, &v], turn);
                let (f0, f1) = (turned(0.0), turned(angle));
                for part in 0..2 {
                    note(&mut worst, &kinds(system.coordinates()), &f0[part], &f1[part]);
                }
            }
        }
    }
    worst
}

/// Force of a frequency-domain part at `s` for turned complex amplitudes `re + i im / |s|`, turned back: real and imaginary part.
fn impedance_force(system: &System, slot: &Slot, speed: f64, s: C64, amplitude: [&[f64]; 2], turn: f64) -> [Vec<f64>; 2] {
    let k = slot.map.len();
    let mut z = vec![C64::zero(); k * k];
    if let Some(part) = slot.part.frequency_domain() {
        part.impedance_f64(&system.params()[slot.params.clone()], s, slot.speed(system.params(), speed), &mut z);
    }
    let mut parts = amplitude.map(<[f64]>::to_vec);
    parts[1].iter_mut().for_each(|x| *x /= s.abs());
    parts.iter_mut().for_each(|x| system.turn(x, turn));
    let local = |row: &[(usize, f64)]| row.iter().fold(C64::zero(), |sum, &(g, x)| sum + c(parts[0][g], parts[1][g]).scale(x));
    let u: Vec<C64> = slot.map.iter().map(|row| local(row)).collect();
    let mut out = [vec![0.0; system.n()], vec![0.0; system.n()]];
    for (i, row) in slot.map.iter().enumerate() {
        let f = (0..k).fold(C64::zero(), |sum, j| sum + z[i * k + j] * u[j]);
        for &(g, x) in row {
            out[0][g] += x * f.re;
            out[1][g] += x * f.im;
        }
    }
    out.iter_mut().for_each(|x| system.turn(x, -turn));
    out
}

/// Raises `worst` to the largest difference of rows over the size of the rows of their kind.
fn note(worst: &mut f64, kinds: &[DofKind], x: &[f64], y: &[f64]) {
    let mut size = [0.0; DofKind::CLASSES];
    for (&k, x) in kinds.iter().zip(x) {
        size[k.class()] += x.abs();
    }
    let all: f64 = size.iter().sum();
    for ((&k, x), y) in kinds.iter().zip(x).zip(y) {
        // rows that are zero but for rounding do not speak for themselves
        let scale = size[k.class()].max(1e-6 * all);
        let change = if x == y { 0.0 } else { (x - y).abs() / scale };
        if change > *worst || change.is_nan() {
            *worst = change;
        }
    }
}

/// Xorshift, from -1 to 1: the same probes in every run.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}
