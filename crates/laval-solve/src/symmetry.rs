//! What a machine keeps when it is turned about its axis: found by probing its residual, part by part.

use crate::model::part::{At, DofKind, Physics, Rows};
use crate::model::system::{GlobalDof, Slot, System, Workspace, turn};
use laval_num::complex::{C64, c};
use serde::{Deserialize, Serialize};
use std::cell::RefCell;
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
    let drawn: Vec<Vec<State>> = speeds.iter().map(|&speed| State::drawn(system, speed)).collect();
    let mut broken = Vec::new();
    for (symmetry, angles) in
        [(Symmetry::Circular, &[0.7, 2.1, 4.4][..]), (Symmetry::Quarter, &[0.5 * PI][..]), (Symmetry::Half, &[PI][..])]
    {
        let cases: Vec<Turned> =
            speeds.iter().zip(&drawn).flat_map(|(&w, d)| angles.iter().map(move |&a| Turned::new(system, d, w, a))).collect();
        let culprit = system.slots().iter().find_map(|slot| {
            let own = Own::new(system, slot);
            cases.iter().find_map(|case| {
                let change = case.change(&own);
                // NaN counts as a change
                (!(change < 1e-9)).then(|| Broken { part: slot.name.clone(), angle: case.angle, change })
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

/// A state of the machine: coordinates, rates and accelerations, internal states, phase.
#[derive(Clone)]
struct State {
    q: [Vec<f64>; 3],
    z: Vec<f64>,
    phase: f64,
}

impl State {
    /// Three of any size, the same in every run.
    fn drawn(system: &System, speed: f64) -> Vec<Self> {
        let mut random = Random(0x9e37_79b9_7f4a_7c15);
        let typical = |c: &GlobalDof| if c.dof.kind == DofKind::Scalar { 1.0 } else { c.dof.typical };
        let mut one = || State {
            q: [0, 1, 2].map(|power| {
                system.coordinates().iter().map(|c| random.next() * typical(c) * unit(speed).powi(power)).collect::<Vec<f64>>()
            }),
            z: system.states().iter().map(|s| random.next() * s.dof.typical).collect(),
            phase: random.next() * PI,
        };
        (0..3).map(|_| one()).collect()
    }

    /// Turned about the axis, the phase along.
    fn turned(&self, system: &System, angle: f64) -> Self {
        let mut out = self.clone();
        out.q.iter_mut().for_each(|x| system.turn(x, angle));
        system.turn_states(&mut out.z, angle);
        out.phase += angle;
        out
    }
}

/// What rates are measured in, rad/s.
fn unit(speed: f64) -> f64 {
    if speed == 0.0 { 1.0 } else { speed }
}

/// States at one speed, and the same turned.
struct Turned<'a> {
    states: &'a [State],
    turned: Vec<State>,
    speed: f64,
    angle: f64,
}

impl<'a> Turned<'a> {
    fn new(system: &System, states: &'a [State], speed: f64, angle: f64) -> Self {
        Turned { states, turned: states.iter().map(|s| s.turned(system, angle)).collect(), speed, angle }
    }

    /// Largest change of one part's rows when the state is turned and the rows turned back, over the size of the rows of their kind (forces, moments,
    /// rates).
    fn change(&self, own: &Own) -> f64 {
        let mut worst: f64 = 0.0;
        for (state, turned) in self.states.iter().zip(&self.turned) {
            let ((f0, r0), (f1, r1)) = (own.rows(state, self.speed, 0.0), own.rows(turned, self.speed, self.angle));
            note(&mut worst, &own.kinds, &f0, &f1);
            note(&mut worst, &own.of_states, &r0, &r1);
            if matches!(own.slot.physics, Physics::Frequency(_)) {
                let (rate, [q, v, _]) = (unit(self.speed), &state.q);
                for s in [c(0.0, rate), c(0.0, 3.0 * rate), c(0.3 * rate, -0.7 * rate)] {
                    let of = |turn: f64| impedance_force(own.system, own.slot, self.speed, s, [q, v], turn);
                    let (f0, f1) = (of(0.0), of(self.angle));
                    let kinds: Vec<DofKind> = own.system.coordinates().iter().map(|d| d.dof.kind).collect();
                    for part in 0..2 {
                        note(&mut worst, &kinds, &f0[part], &f1[part]);
                    }
                }
            }
        }
        worst
    }
}

/// A part with the coordinates that it sees, pairs whole: the rows of all others are zero.
struct Own<'a> {
    system: &'a System,
    slot: &'a Slot,
    coordinates: Vec<usize>,
    kinds: Vec<DofKind>,
    of_states: Vec<DofKind>,
    /// Rows of the whole machine, zero between two uses.
    rows: RefCell<(Vec<f64>, Vec<f64>, Workspace<f64>)>,
}

impl<'a> Own<'a> {
    fn new(system: &'a System, slot: &'a Slot) -> Self {
        let kind = |i: usize| system.coordinates()[i].dof.kind;
        let whole = |i: usize| {
            let first = if i > 0 && kind(i - 1).leads_pair() { i - 1 } else { i };
            let last = if kind(i).leads_pair() { i + 1 } else { i };
            first..=last.min(system.n() - 1)
        };
        let mut coordinates: Vec<usize> = slot.coordinates().into_iter().flat_map(whole).collect();
        coordinates.dedup();
        let kinds = coordinates.iter().map(|&i| kind(i)).collect();
        let of_states = system.states()[slot.states.clone()].iter().map(|s| s.dof.kind).collect();
        let rows = RefCell::new((vec![0.0; system.n()], vec![0.0; system.m()], Workspace::default()));
        Own { system, slot, coordinates, kinds, of_states, rows }
    }

    /// Its rows and rates at a state, turned back.
    fn rows(&self, state: &State, speed: f64, turned: f64) -> (Vec<f64>, Vec<f64>) {
        let (system, [q, v, a]) = (self.system, &state.q);
        let at = At { q, v, a, z: &state.z, phase: state.phase, speed, spin_accel: 0.0, t: 0.0 };
        let (force, rate, ws) = &mut *self.rows.borrow_mut();
        let mut spin = 0.0;
        let mut out = Rows { force, rate, spin: &mut spin };
        system.part_residual(self.slot, system.params(), &at, &mut out, ws);
        let mut own: Vec<f64> = self.coordinates.iter().map(|&i| std::mem::take(&mut force[i])).collect();
        let mut rates: Vec<f64> = rate[self.slot.states.clone()].iter_mut().map(std::mem::take).collect();
        turn(self.kinds.iter().copied(), &mut own, -turned);
        turn(self.of_states.iter().copied(), &mut rates, -turned);
        (own, rates)
    }
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
