//! What is measured of a periodic motion: the distance of a point from its rest position, a tilt, or the force of a part. The largest over a period counts.
//!
//! The force of a part is what its residual puts on its first pair of coordinates: of a bearing what it transmits, of a liquid what it puts on the wall of its
//! cavity, with its inertia. That of a body is without its own inertia: of a foundation what its spring and damper give to the ground.

use crate::harmonic::balance::orbit::Orbit;
use crate::model::blocks::Blocks;
use crate::model::erased::Evaluate;
use crate::model::part::{At, Rows};
use crate::model::probe::Probe;
use crate::model::slot::{Slot, gather};
use crate::model::system::{System, Workspace};
use crate::symmetry::Symmetry;
use laval_num::complex::C64;
use laval_num::fourier::Roots;
use laval_num::refill::refill;
use std::f64::consts::TAU;
use std::ops::Range;

/// A quantity with a size at every instant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// What the probe with this index among [`System::probes`] measures, from rest, m or rad.
    Probe(usize),
    /// Force, N, of the part in this slot.
    Force(usize),
}

/// Instants of a period, at least, at which the largest value is looked for before it is refined.
const SAMPLES: usize = 64;
/// The same of a circular motion, of which one order is all there is.
const ROUND: usize = 4;

/// The state of a machine at one instant in scalars of kind `S`.
pub(super) struct Instant<'a, S> {
    /// Coordinates, rates, states.
    pub q: &'a [S],
    /// Their rates.
    pub v: &'a [S],
    /// Accelerations.
    pub a: &'a [S],
    /// Internal states.
    pub z: &'a [S],
    /// Phase of the spin, rad.
    pub phase: f64,
    /// Spin speed, rad/s.
    pub speed: S,
}

impl Measure {
    /// The forces of a machine that can be measured: those that a part shows in N, where no state of it is eliminated.
    pub fn forces(system: &System) -> Vec<usize> {
        let (n, m) = (system.n(), system.m());
        let (q, z) = (vec![0.0; n], vec![0.0; m]);
        let at = At { q: &q, v: &q, a: &q, z: &z, phase: 0.0, speed: 1.0, spin_accel: 0.0, t: 0.0 };
        let mut slots: Vec<usize> =
            system.observe(&at, &mut Workspace::default()).iter().filter(|(_, o)| o.unit == "N").map(|o| o.0).collect();
        slots.dedup();
        slots.retain(|&k| system.slots()[k].memory == 0 && system.slots()[k].map.len() >= 2);
        slots
    }

    /// SI unit.
    pub fn unit(self, system: &System) -> &'static str {
        match self {
            Measure::Probe(k) => system.probes()[k].unit(),
            Measure::Force(_) => "N",
        }
    }

    /// A linear function of the motion, up to constant loads and those that turn with the rotor.
    fn is_linear(self, system: &System) -> bool {
        match self {
            Measure::Probe(_) => true,
            Measure::Force(slot) => system.slots()[slot].is_linear(),
        }
    }

    /// The coordinates and states that it depends on.
    pub(super) fn coordinates(self, system: &System) -> (Vec<usize>, Range<usize>) {
        match self {
            Measure::Probe(k) => (system.probes()[k].rows.0.iter().flatten().map(|x| x.0).collect(), 0..0),
            Measure::Force(slot) => (system.slots()[slot].coordinates(), system.slots()[slot].states.clone()),
        }
    }

    /// Both components at an instant.
    pub(super) fn at<S: Evaluate>(self, system: &System, params: &[S], now: &Instant<S>) -> [S; 2] {
        match self {
            Measure::Probe(k) => system.probes()[k].scaled(now.q),
            Measure::Force(slot) => {
                let slot = &system.slots()[slot];
                let own = Instant { z: &now.z[slot.states.clone()], ..*now };
                Local::new().force(slot, &slot.map, params, &own)
            }
        }
    }

    /// Both components at base phase `tau` of a motion of this period in turns.
    pub fn components_at(self, system: &System, orbit: &Orbit, turns: usize, tau: f64) -> [f64; 2] {
        Track::new(self, system, orbit, turns).at(tau)
    }

    /// The samples that [`Measure::first_order`] takes of motions with orders to this one.
    pub fn samples(highest: usize, turns: usize, symmetry: Symmetry) -> Roots {
        Roots::new(if symmetry == Symmetry::Circular { ROUND } else { turns * SAMPLES.max(8 * highest.div_ceil(turns)) })
    }

    /// Complex amplitudes of both components at the spin frequency: `Re(amplitude exp(i phase))`. Of a symmetric motion only part of the period is sampled; of a
    /// linear measure only the motion at the spin frequency.
    pub fn first_order(self, system: &System, orbit: &Orbit, turns: usize, (symmetry, samples): (Symmetry, &Roots)) -> [C64; 2] {
        let linear = symmetry != Symmetry::Circular && self.is_linear(system);
        let alone = linear.then(|| orbit.of_order(turns)).flatten().map(|alone| (alone, Roots::new(ROUND * turns)));
        let (orbit, samples) = alone.as_ref().map_or((orbit, samples), |(alone, few)| (alone, few));
        let count = samples.count();
        // after half a turn both components have changed their signs, and so has the wave they are compared with; after a quarter y is what x was, and the motion turns forward
        let taken = match symmetry {
            Symmetry::Quarter if turns == 1 => count / 4,
            Symmetry::Half if turns == 1 => count / 2,
            _ => count,
        };
        let mut track = Track::new(self, system, orbit, turns);
        let mut out = [C64::zero(); 2];
        for j in 0..taken {
            let back = samples.at(turns, j).conj().scale(2.0 / taken as f64);
            for (o, f) in out.iter_mut().zip(track.sample(samples, j)) {
                *o += back.scale(f);
            }
        }
        if taken < count / 2 {
            let [x, y] = out;
            let forward = (x + y.mul_i()).scale(0.5);
            return [forward, -forward.mul_i()];
        }
        out
    }

    /// The square of its size at base phase `tau` of a motion of this period in turns.
    pub fn square_at(self, system: &System, orbit: &Orbit, turns: usize, tau: f64) -> f64 {
        Track::new(self, system, orbit, turns).square(tau)
    }

    /// Largest value over a period, and the base phase where it is reached.
    pub fn largest(self, system: &System, orbit: &Orbit, turns: usize) -> (f64, f64) {
        self.largest_of_part(system, orbit, turns, 1)
    }

    /// The same of a motion whose sizes repeat with so many equal parts of the period.
    pub(in crate::harmonic) fn largest_of_part(self, system: &System, orbit: &Orbit, turns: usize, parts: usize) -> (f64, f64) {
        let samples = SAMPLES.max(8 * orbit.orders.last().copied().unwrap_or(1));
        let (h, roots) = (TAU / samples as f64, Roots::new(samples));
        let mut track = Track::new(self, system, orbit, turns);
        let mut size = |j: usize| {
            let [x, y] = track.sample(&roots, j);
            x * x + y * y
        };
        let (mut tau, mut best) = (0.0, size(0));
        for j in 1..samples.div_ceil(parts) {
            let r = size(j);
            if !(r <= best) {
                (tau, best) = (roots.phase(j), r);
            }
        }
        let refined = match self {
            Measure::Probe(k) => stationary(|tau| orbit.probe_at(&system.probes()[k], tau), (tau, best), h),
            Measure::Force(_) => vertex(|tau| track.square(tau), (tau, best), h),
        };
        (refined.1.sqrt(), refined.0)
    }

    /// Base phase of the largest value of a motion, where that of one beside it is known.
    pub(in crate::harmonic) fn near(self, system: &System, orbit: &Orbit, turns: usize, tau: f64) -> f64 {
        let mut track = Track::new(self, system, orbit, turns);
        let mut square = |tau: f64| track.square(tau);
        let (best, h) = (square(tau), 0.01);
        match self {
            Measure::Probe(k) => stationary(|tau| orbit.probe_at(&system.probes()[k], tau), (tau, best), h).0,
            Measure::Force(_) => vertex(square, (tau, best), h).0,
        }
    }
}

/// Largest velocity of what a probe measures over a period, m/s or rad/s.
pub fn fastest(probe: &Probe, orbit: &Orbit) -> f64 {
    let samples = SAMPLES.max(8 * orbit.orders.last().copied().unwrap_or(1));
    let h = TAU / samples as f64;
    let square = |tau: f64| {
        let [_, [x, y], _] = orbit.probe_at(probe, tau);
        x * x + y * y
    };
    let (mut tau, mut best) = (0.0, square(0.0));
    for j in 1..samples {
        let r = square(h * j as f64);
        // NaN stays
        if !(r <= best) {
            (tau, best) = (h * j as f64, r);
        }
    }
    vertex(square, (tau, best), h).1.sqrt() * orbit.frequency.abs()
}

/// Newton's method on the rate of the squared distance, where it leads to more.
fn stationary(pair: impl Fn(f64) -> [[f64; 2]; 3], (mut tau, mut best): (f64, f64), h: f64) -> (f64, f64) {
    for _ in 0..8 {
        let [[x, y], [dx, dy], [ddx, ddy]] = pair(tau);
        let (rate, bend) = (x * dx + y * dy, dx * dx + dy * dy + x * ddx + y * ddy);
        if !(bend < 0.0) {
            break;
        }
        let next = tau + (-rate / bend).clamp(-h, h);
        let [[x, y], ..] = pair(next);
        let r = x * x + y * y;
        if !(r > best) {
            break;
        }
        (tau, best) = (next, r);
    }
    (tau, best)
}

/// Vertices of parabolas through three instants ever closer to each other, where they lead to more.
fn vertex(mut square: impl FnMut(f64) -> f64, (mut tau, mut best): (f64, f64), mut h: f64) -> (f64, f64) {
    for _ in 0..4 {
        let (a, c) = (square(tau - h), square(tau + h));
        let bend = a - 2.0 * best + c;
        if bend < 0.0 {
            let next = tau + (0.5 * h * (a - c) / bend).clamp(-h, h);
            let r = square(next);
            if r > best {
                (tau, best) = (next, r);
            }
        }
        h *= 0.1;
    }
    (tau, best)
}

/// A measure along one motion. Thousands of instants of a branch share these vectors: allocating them for each took most of the time.
struct Track<'a> {
    measure: Measure,
    system: &'a System,
    orbit: &'a Orbit,
    turns: usize,
    q: Vec<f64>,
    v: Vec<f64>,
    a: Vec<f64>,
    z: Vec<f64>,
    /// Coordinates of the part whose force is measured, and what it sees as combinations of these.
    own: Vec<usize>,
    map: Vec<Vec<(usize, f64)>>,
    local: Local<f64>,
}

impl<'a> Track<'a> {
    fn new(measure: Measure, system: &'a System, orbit: &'a Orbit, turns: usize) -> Self {
        let mut track = Track {
            measure,
            system,
            orbit,
            turns,
            q: vec![],
            v: vec![],
            a: vec![],
            z: vec![],
            own: vec![],
            map: vec![],
            local: Local::new(),
        };
        if let Measure::Force(slot) = measure {
            let slot = &system.slots()[slot];
            let own = slot.coordinates();
            let place = |i: usize| own.partition_point(|&o| o < i);
            track.map = slot.map.iter().map(|row| row.iter().map(|&(i, g)| (place(i), g)).collect()).collect();
            for x in [&mut track.q, &mut track.v, &mut track.a] {
                x.resize(own.len(), 0.0);
            }
            track.z.resize(slot.states.len(), 0.0);
            track.own = own;
        }
        track
    }

    /// Both components at base phase `tau`.
    fn at(&mut self, tau: f64) -> [f64; 2] {
        let Track { system, orbit, .. } = *self;
        match self.measure {
            Measure::Probe(k) => orbit.probe_at(&system.probes()[k], tau)[0],
            Measure::Force(slot) => {
                let states = system.slots()[slot].states.clone();
                orbit.at_some(&self.own, states, tau, [&mut self.q, &mut self.v, &mut self.a, &mut self.z]);
                self.force(slot, self.turns as f64 * tau)
            }
        }
    }

    /// The same at a sample of a period.
    fn sample(&mut self, roots: &Roots, j: usize) -> [f64; 2] {
        let Track { system, orbit, .. } = *self;
        match self.measure {
            Measure::Probe(k) => orbit.probe_at_sample(&system.probes()[k], roots, j),
            Measure::Force(slot) => {
                let states = system.slots()[slot].states.clone();
                orbit.some_at_sample(&self.own, states, (roots, j), [&mut self.q, &mut self.v, &mut self.a, &mut self.z]);
                self.force(slot, self.turns as f64 * roots.phase(j))
            }
        }
    }

    /// The force of a part at the instant that was read.
    fn force(&mut self, slot: usize, phase: f64) -> [f64; 2] {
        let now = Instant { q: &self.q, v: &self.v, a: &self.a, z: &self.z, phase, speed: self.orbit.speed };
        self.local.force(&self.system.slots()[slot], &self.map, self.system.params(), &now)
    }

    /// The square of the size.
    fn square(&mut self, tau: f64) -> f64 {
        let [x, y] = self.at(tau);
        x * x + y * y
    }
}

/// What a part sees and gives at one instant.
struct Local<S> {
    q: Vec<S>,
    v: Vec<S>,
    a: Vec<S>,
    rows: Vec<S>,
    rate: Vec<S>,
    blocks: Blocks<S>,
}

impl<S: Evaluate> Local<S> {
    fn new() -> Self {
        Local { q: Vec::new(), v: Vec::new(), a: Vec::new(), rows: Vec::new(), rate: Vec::new(), blocks: Blocks::default() }
    }

    /// What a part puts on its first pair of coordinates, N; a body what it does without its own inertia.
    /// Its coordinates are those of `map` among those of the instant, whose states are its own.
    fn force(&mut self, slot: &Slot, map: &[Vec<(usize, f64)>], params: &[S], now: &Instant<S>) -> [S; 2] {
        let Local { q, v, a, rows, rate, blocks } = self;
        gather(map, now.q, q);
        gather(map, now.v, v);
        if slot.layout.body {
            refill(a, slot.map.len(), S::zero());
        } else {
            gather(map, now.a, a);
            a.iter_mut().zip(&slot.weight).for_each(|(a, g)| *a += S::cst(*g));
        }
        refill(rows, slot.map.len(), S::zero());
        refill(rate, slot.states.len(), S::zero());
        let mut spin = S::zero();
        let point = At { q, v, a, z: now.z, phase: S::cst(now.phase), speed: now.speed, spin_accel: S::zero(), t: S::zero() };
        let at = slot.turned(params, point);
        let mut out = Rows { force: rows, rate, spin: &mut spin };
        S::residual(&*slot.part, &params[slot.params.clone()], &at, &mut out, blocks);
        [rows[0], rows[1]]
    }
}
