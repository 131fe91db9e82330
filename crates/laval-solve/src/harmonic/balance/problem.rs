//! The balance as equations `r(x, speed) = 0`: residual, exact tangents, monitored motion of the bodies.
//!
//! ```text
//! r = L(W) x + analysis f(u(x)) - p(W)
//! ```
//!
//! x are the terms of the nonlinear coordinates u, L and p the linear parts condensed exactly at every order, f the nonlinear forces sampled over the
//! period. Rows are in N (N m), divided by nothing: Newton scales them.
//!
//! Theory: `docs/theory/harmonic-balance.md#balance`.

pub use crate::harmonic::balance::coordinates::Nonlinear;
use serde::{Deserialize, Serialize};

use crate::diagnostic::Diagnostic;
use crate::harmonic::balance::condense::{Condenser, Order, lossy};
use crate::harmonic::balance::fourier::Into;
use crate::harmonic::balance::nonlinear::{Member, Sampled};
use crate::harmonic::balance::pace::{Pace, Parameter};
use crate::harmonic::balance::refused::refused;
use crate::harmonic::balance::sizes::{reference_stiffness, resonances};
use crate::harmonic::balance::switching::Switching;
use crate::harmonic::balance::terms::{Term, Terms};
use crate::model::system::{Pair, Station, System};
use crate::rest::rest;
use crate::symmetry::Symmetry;
use laval_num::complex::{C64, c};
use laval_num::continuation::{Failure, Zero, resonance_cap};
use laval_num::dense::{Lu, Mat, Singular};
use std::sync::atomic::{AtomicBool, Ordering};

/// How a balance is discretised.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Discretisation {
    /// Largest order kept, in multiples of the base frequency.
    pub harmonics: usize,
    /// Subharmonic divisor nu.
    pub divisor: usize,
    /// Samples of a whole period, at least.
    pub samples: usize,
    /// Symmetry imposed on the motion.
    pub symmetry: Symmetry,
}

impl Discretisation {
    /// The same with as many samples as are taken, and the symmetry that an even divisor leaves.
    pub fn whole(self) -> Self {
        let symmetry = if self.divisor.is_multiple_of(2) { Symmetry::None } else { self.symmetry };
        let samples = match symmetry.order() {
            0 => 1,
            parts => self.samples.next_multiple_of(parts),
        };
        Discretisation { symmetry, samples, ..self }
    }
}

/// Typical displacement over typical tilt, m: what a monitored tilt is multiplied by beside displacements.
const LEVER: f64 = 0.1;

/// The balance of one machine.
pub struct Balance<'a> {
    /// The machine.
    pub system: &'a System,
    /// Its nonlinear coordinates.
    pub nonlinear: Nonlinear,
    /// The harmonics.
    pub terms: Terms,
    /// The linear parts, order by order (as `terms.orders`), at the last speed.
    pub orders: Vec<Order>,
    /// The base order at the last speed that was measured alone.
    measured: Order,
    /// Samples of the last evaluation.
    pub sampled: Sampled,
    /// Parts whose law switches along the motion: not in the samples of an evaluation, only in those of [`Balance::sample`].
    pub switching: Switching,
    /// The other nonlinear parts.
    smooth: Vec<Member>,
    /// Nonlinear forces on the terms at the last evaluation.
    projected: Vec<f64>,
    pub(super) condenser: Condenser,
    /// The pace the linear parts stand at.
    pace: Option<Pace>,
    /// The linear parts stand there with their derivatives.
    has_slopes: bool,
    free: Option<Pace>,
    /// Derivatives are taken in this parameter of the machine instead of the speed.
    by: Option<Parameter>,
    pub(super) linear: Mat,
    pub(super) linear_speed: Mat,
    pub(super) load: Vec<f64>,
    pub(super) load_speed: Vec<f64>,
    scale: Vec<f64>,
    speed_scale: f64,
    /// Displacements and tilts of the stations, with their weights.
    monitored: Vec<(Pair, f64)>,
    /// Resonances of the machine linearised at rest, met by the base order: speed and half width, rad/s.
    resonances: Vec<(f64, f64)>,
    pub(in crate::harmonic) cancel: Option<&'a AtomicBool>,
    /// Receives the speed of every step along a branch.
    pub(in crate::harmonic) watch: Option<&'a (dyn Fn(f64) + Sync)>,
    pub(super) amplitudes: Vec<C64>,
    pub(super) forces: Vec<C64>,
    coefficients: Vec<f64>,
    /// Coordinates of the machine at rest, and the speed they are for.
    rest: (f64, Vec<f64>),
    loaded: bool,
    /// Evaluations of the residual so far.
    pub evaluations: u64,
}

/// Why the balance has no residual.
pub(super) const NO_RESPONSE: &str = "the linear parts have no response at this speed";

impl<'a> Balance<'a> {
    /// Sets up the balance for speeds around `speeds` (rad/s), which also set its scales.
    pub fn new(system: &'a System, d: Discretisation, speeds: (f64, f64), cancel: Option<&'a AtomicBool>) -> Result<Self, Diagnostic> {
        let nonlinear = Nonlinear::of(system);
        let terms = Terms::new(&nonlinear.kinds, d.symmetry, d.harmonics, d.divisor, d.samples);
        let reference = reference_stiffness(system, &nonlinear, 0.5 * (speeds.0 + speeds.1));
        let mut balance = Balance::unscaled(system, nonlinear, terms, reference, cancel);
        balance.speed_scale = speeds.0.abs().max(speeds.1.abs()).max(1e-3);
        balance.find_scale(speeds)?;
        balance.resonances = resonances(system, speeds);
        Ok(balance)
    }

    /// Without sizes of the unknowns: to sample the nonlinear parts along motions near a speed, not to be solved.
    pub(in crate::harmonic) fn sampler(system: &'a System, d: Discretisation, speed: f64) -> Self {
        let nonlinear = Nonlinear::of(system);
        let terms = Terms::new(&nonlinear.kinds, d.symmetry, d.harmonics, d.divisor, d.samples);
        let reference = vec![1.0; nonlinear.basis.rows.len()];
        Balance { speed_scale: speed.abs().max(1e-3), ..Balance::unscaled(system, nonlinear, terms, reference, None) }
    }

    /// The same equations of a machine whose parts have other parameters, with the same sizes; `None` where its nonlinear coordinates are others.
    pub fn of_other<'b>(&self, system: &'b System) -> Option<Balance<'b>>
    where
        'a: 'b,
    {
        let nonlinear = Nonlinear::of(system);
        if nonlinear.kinds != self.nonlinear.kinds || nonlinear.basis.rows.len() != self.nonlinear.basis.rows.len() {
            return None;
        }
        let mut other = Balance::unscaled(system, nonlinear, self.terms.clone(), self.condenser.reference.clone(), self.cancel);
        other.scale.copy_from_slice(&self.scale);
        other.speed_scale = self.speed_scale;
        Some(other)
    }

    /// The same equations once more, for another thread.
    pub(in crate::harmonic) fn twin<'b>(&self, cancel: Option<&'b AtomicBool>) -> Balance<'b>
    where
        'a: 'b,
    {
        let mut twin = Balance::unscaled(self.system, self.nonlinear.clone(), self.terms.clone(), self.condenser.reference.clone(), cancel);
        twin.scale.copy_from_slice(&self.scale);
        twin.speed_scale = self.speed_scale;
        twin.resonances.clone_from(&self.resonances);
        (twin.free, twin.by, twin.condenser.driven) = (self.free, self.by, self.condenser.driven);
        twin
    }

    fn unscaled(
        system: &'a System,
        nonlinear: Nonlinear,
        terms: Terms,
        reference: Vec<f64>,
        cancel: Option<&'a AtomicBool>,
    ) -> Balance<'a> {
        let condenser = Condenser::new(system, &nonlinear.basis, reference, terms.divisor);
        let m = nonlinear.kinds.len();
        let unknowns = terms.unknowns;
        let mut smooth = nonlinear.members.clone();
        let switching = Switching::new(system, &terms, &mut smooth);
        Balance {
            switching,
            smooth,
            projected: vec![0.0; unknowns],
            orders: vec![Order::default(); terms.orders.len()],
            measured: Order::default(),
            sampled: Sampled::default(),
            condenser,
            pace: None,
            has_slopes: false,
            free: None,
            by: None,
            linear: Mat::zeros(unknowns, unknowns),
            linear_speed: Mat::zeros(unknowns, unknowns),
            load: vec![0.0; unknowns],
            load_speed: vec![0.0; unknowns],
            scale: vec![1.0; unknowns],
            speed_scale: 1.0,
            monitored: monitored(system),
            resonances: Vec::new(),
            cancel,
            watch: None,
            amplitudes: vec![C64::zero(); m],
            forces: vec![C64::zero(); m],
            coefficients: vec![0.0; unknowns],
            rest: (f64::NAN, Vec::new()),
            loaded: system.is_loaded(),
            evaluations: 0,
            system,
            nonlinear,
            terms,
        }
    }

    /// A size for every unknown: the geometric mean over the range of the response with the reference stiffness, no less than a
    /// millionth of the coordinate's typical size.
    fn find_scale(&mut self, (lo, hi): (f64, f64)) -> Result<(), Diagnostic> {
        let mu = self.nonlinear.basis.rows.len();
        let m = self.nonlinear.kinds.len();
        let mut size = vec![0.0f64; m];
        let points = 8;
        for i in 0..points {
            let speed = lo + (hi - lo) * (i as f64 + 0.5) / points as f64;
            self.set_speed(speed).map_err(|e| refused(self.system, &self.terms, speed, &e))?;
            let mut u = vec![0.0f64; mu];
            for order in &self.orders {
                for ((u, p), k) in u.iter_mut().zip(&order.load).zip(&self.condenser.reference) {
                    *u = u.max(p.abs() / k);
                }
            }
            for (s, u) in size.iter_mut().zip(&u) {
                *s += (u.max(1e-300)).ln() / points as f64;
            }
        }
        for (i, s) in size.iter_mut().enumerate() {
            let typical = self.nonlinear.typical[i];
            // a coordinate that no linear part loads moves by the nonlinear parts alone
            let loaded = i < mu && s.exp() > 1e-200;
            *s = if loaded { s.exp().clamp(1e-6 * typical, 1e3 * typical) } else { typical };
        }
        // the two halves of a pair share one size
        for &(term, at) in &self.terms.list {
            let (c, width) = match term {
                Term::Pair { coordinate, .. } => (size[coordinate].max(size[coordinate + 1]), 2),
                Term::Scalar { coordinate, .. } => (size[coordinate], term.size()),
            };
            self.scale[at..at + width].fill(10.0 * c);
        }
        Ok(())
    }

    /// Seeks motions that no unbalance forces, at this pace: the rotating load is left out, and a speed given elsewhere is not looked at.
    pub fn set_free(&mut self, pace: Pace) {
        self.condenser.driven = false;
        self.free = Some(pace);
    }

    /// The pace of motions at a spin speed: under unbalance, or as set by [`Balance::set_free`].
    pub fn pace(&self, speed: f64) -> Pace {
        let pace = self.free.unwrap_or_else(|| Pace::forced(speed, self.terms.divisor));
        match self.by {
            None => pace,
            Some(_) => Pace { rate: [0.0; 3], parameter: self.by, ..pace },
        }
    }

    /// From here on derivatives are taken in a parameter of the machine, or again in the speed.
    pub fn differentiate_by(&mut self, parameter: Option<Parameter>) {
        self.by = parameter;
    }

    /// Condenses the linear parts at a speed, unless they stand there already.
    pub fn set_speed(&mut self, speed: f64) -> Result<(), Singular> {
        self.condense(speed, false)
    }

    /// The same, where requested with derivatives.
    pub(in crate::harmonic) fn condense(&mut self, speed: f64, slopes: bool) -> Result<(), Singular> {
        let pace = self.pace(speed);
        if self.pace == Some(pace) && (self.has_slopes || !slopes) {
            return Ok(());
        }
        self.pace = None;
        self.condenser.set_pace(self.system, &pace);
        let unknowns = self.terms.unknowns;
        self.linear.reset(unknowns, unknowns);
        self.linear_speed.reset(unknowns, unknowns);
        self.load.fill(0.0);
        self.load_speed.fill(0.0);
        let m = self.nonlinear.kinds.len();
        let mu = self.nonlinear.basis.rows.len();
        let mut force = vec![C64::zero(); m];
        self.condenser.orders(self.system, &self.terms.orders, slopes, &mut self.orders)?;
        for (order, &k) in self.orders.iter().zip(&self.terms.orders) {
            let parts = 1 + usize::from(slopes);
            for (matrix, out) in
                [(&order.stiffness, &mut self.linear), (&order.stiffness_speed, &mut self.linear_speed)].into_iter().take(parts)
            {
                add_operator(&self.terms, k, mu, matrix, &mut force, out);
            }
            for (load, out) in [(&order.load, &mut self.load), (&order.load_speed, &mut self.load_speed)].into_iter().take(parts) {
                force[..mu].copy_from_slice(load);
                force[mu..].fill(C64::zero());
                self.terms.add_amplitudes(k, &force, out);
            }
        }
        (self.pace, self.has_slopes) = (Some(pace), slopes);
        Ok(())
    }

    /// dL/dw: derivative of the linear part in the base frequency at fixed spin, unknowns by unknowns, under unbalance.
    pub fn frequency_slope(&mut self, speed: f64) -> Option<Mat> {
        let free = self.free.replace(Pace { rate: [0.0, 1.0, 0.0], ..Pace::forced(speed, self.terms.divisor) });
        let done = self.condense(speed, true).is_ok();
        let slope = self.linear_speed.clone();
        (self.free, self.pace) = (free, None);
        done.then_some(slope)
    }

    /// Coordinates at rest at a speed, from which displacements count; none for a machine without load across its axis, where all are zero, or that has no rest.
    pub fn rest(&mut self, speed: f64) -> &[f64] {
        if self.loaded && self.rest.0 != speed {
            self.rest = (speed, rest(self.system, speed).map_or_else(|_| Vec::new(), |e| e.q));
        }
        &self.rest.1
    }

    /// Unknowns of the linear machine in which `part` of the reference stiffness stands for the nonlinear parts, at a speed.
    pub fn linear_estimate(&mut self, speed: f64, part: f64) -> Option<Vec<f64>> {
        self.set_speed(speed).ok()?;
        let mut matrix = self.linear.clone();
        for &(term, at) in &self.terms.list {
            let (coordinate, next) = match term {
                Term::Pair { coordinate, .. } => (coordinate, 1),
                Term::Scalar { coordinate, .. } => (coordinate, 0),
            };
            for i in 0..term.size() {
                // states of nonlinear parts follow the coordinates and have no reference
                matrix[(at + i, at + i)] += part * self.condenser.reference.get(coordinate + i * next).copied().unwrap_or(1.0);
            }
        }
        let mut x = self.load.clone();
        Lu::new(&matrix).ok()?.solve(&mut x);
        Some(x)
    }

    /// Motion of all coordinates and linear states at order `terms.orders[which]`: complex amplitudes of real coordinates, of the last point
    /// evaluated (its samples give the forces).
    pub fn motion(&mut self, x: &[f64], which: usize, out: &mut Vec<C64>) {
        let order = std::mem::take(&mut self.orders[which]);
        self.motion_of(x, self.terms.orders[which], &order, out);
        self.orders[which] = order;
    }

    /// The same with the linear parts condensed at order `k` as given.
    fn motion_of(&mut self, x: &[f64], k: usize, order: &Order, out: &mut Vec<C64>) {
        let mu = self.nonlinear.basis.rows.len();
        self.terms.amplitudes(x, k, &mut self.amplitudes);
        self.force_amplitudes(k);
        out.clear();
        for (i, &free) in order.free.iter().enumerate() {
            let mut sum = free;
            for j in 0..mu {
                sum -= order.spread[(i, j)] * (self.forces[j] - self.amplitudes[j] * lossy(k, self.condenser.reference[j]));
            }
            out.push(sum);
        }
    }

    /// Nonlinear forces at a motion `x` on the terms, with derivatives where requested (added to).
    pub(super) fn project(&mut self, x: &[f64], p: f64, mut jac: Option<&mut Mat>, mut speed: Option<&mut [f64]>) {
        let tangents = jac.is_some() || speed.is_some();
        let pace = self.pace(p);
        self.sampled.eval(self.system, &self.smooth, &self.terms, x, pace, tangents);
        self.projected.fill(0.0);
        self.terms.analysis.mul_vec_add(&self.sampled.rows, &mut self.projected);
        if let Some(jac) = jac.as_deref_mut().filter(|_| !self.smooth.is_empty()) {
            self.sampled.add_jacobian(&self.terms, pace.frequency, jac);
        }
        if let Some(speed) = speed.as_deref_mut() {
            self.terms.analysis.mul_vec_add(&self.sampled.rows_speed, speed);
        }
        self.switching.add(self.system, &self.terms, x, pace, &mut Into { coefficients: &mut self.projected, jac, speed });
    }

    /// Amplitudes of the sampled forces at order `k`, into `self.forces`.
    pub(super) fn force_amplitudes(&mut self, k: usize) {
        self.coefficients.fill(0.0);
        for &(term, at) in &self.terms.list {
            if term.order().unsigned_abs() as usize == k {
                self.coefficients[at..at + term.size()].copy_from_slice(&self.projected[at..at + term.size()]);
            }
        }
        let (coefficients, forces) = (std::mem::take(&mut self.coefficients), &mut self.forces);
        self.terms.amplitudes(&coefficients, k, forces);
        self.coefficients = coefficients;
    }

    /// Global indices of the linear states that follow the coordinates in [`Balance::motion`].
    pub fn linear_states(&self) -> &[usize] {
        self.condenser.linear_states()
    }

    /// Base phases from `start` to `start + length` where laws switch along the motion `x`, and the name of a part whose force jumps there.
    pub fn switches(&mut self, x: &[f64], speed: f64, span: (f64, f64)) -> (Vec<f64>, Option<String>) {
        let pace = self.pace(speed);
        let (places, slot) = self.switching.places(self.system, &self.terms, x, pace, span);
        (places, slot.map(|slot| self.system.slots()[slot].name.clone()))
    }

    /// Largest nonlinear force of the last evaluation: sampled, or on a term.
    pub fn largest_force(&self) -> f64 {
        laval_num::dense::max_abs(&self.sampled.rows).max(laval_num::dense::max_abs(&self.projected))
    }

    /// Samples the nonlinear parts, with tangents, at a motion `x`; the linear parts are left alone.
    pub fn sample(&mut self, x: &[f64], speed: f64) {
        let pace = self.pace(speed);
        self.sampled.eval(self.system, &self.nonlinear.members, &self.terms, x, pace, true);
    }

    /// Memory states at `s` (1/s) that belong to amplitudes of the coordinates: eliminated in the balance, found again here.
    pub fn memory_states(&self, s: C64, coordinates: &[C64], states: &mut [C64]) {
        self.condenser.memory_states(self.system, s, coordinates, states);
    }

    /// The requested discretisation, as it is.
    pub fn discretisation(&self) -> Discretisation {
        let t = &self.terms;
        Discretisation { harmonics: t.harmonics, divisor: t.divisor, samples: t.samples * t.symmetry.order().max(1), symmetry: t.symmetry }
    }

    /// Size of the unknowns.
    pub fn scales(&self) -> &[f64] {
        &self.scale
    }

    /// Dropped force harmonics over kept ones at the last evaluated point: how much of the nonlinear force the chosen orders leave out.
    pub fn truncation(&self) -> f64 {
        let t = &self.terms;
        if t.symmetry == Symmetry::Circular {
            return 0.0;
        }
        let (m, count) = (t.coordinates, t.samples);
        let whole = count * t.symmetry.order();
        let highest = (whole - 1) / 2;
        let (mut kept, mut dropped) = (0.0f64, 0.0f64);
        let turns: Vec<C64> = (0..whole).map(|step| C64::cis(-std::f64::consts::TAU * step as f64 / whole as f64)).collect();
        let (vector, scalar) = crate::harmonic::balance::terms::admitted(t.symmetry, highest, t.divisor);
        let mut i = 0;
        while i < m {
            let pair = self.nonlinear.kinds[i].leads_pair() && i + 1 < m;
            for &n in if pair { &vector } else { &scalar } {
                let mut sum = C64::zero();
                for j in 0..count {
                    let step = (i64::from(n) * j as i64).rem_euclid(whole as i64) as usize;
                    let f = c(self.sampled.rows[j * m + i], if pair { self.sampled.rows[j * m + i + 1] } else { 0.0 });
                    sum += f * turns[step];
                }
                let size = sum.abs() / count as f64;
                if n.unsigned_abs() as usize <= t.harmonics {
                    kept = kept.max(size);
                } else if !(size <= dropped) {
                    dropped = size;
                }
            }
            i += if pair { 2 } else { 1 };
        }
        if kept == 0.0 { 0.0 } else { dropped / kept }
    }
}

/// What is monitored of the motion: displacements and tilts of the stations, with their weights.
fn monitored(system: &System) -> Vec<(Pair, f64)> {
    let of = |s: &Station| [Some((s.lateral.clone(), 1.0)), s.tilt.clone().map(|t| (t, LEVER))];
    system.stations().iter().flat_map(of).flatten().collect()
}

/// Adds the real operator of a complex matrix at order `k` on the terms.
fn add_operator(terms: &Terms, k: usize, mu: usize, matrix: &Mat<C64>, force: &mut [C64], out: &mut Mat) {
    let mut column = vec![0.0; terms.unknowns];
    for &(term, at) in &terms.list {
        if term.order().unsigned_abs() as usize != k {
            continue;
        }
        for part in 0..term.size() {
            let unit = if part == 0 { c(1.0, 0.0) } else { c(0.0, 1.0) };
            let (first, amplitudes, count) = match term {
                Term::Pair { coordinate, order } => {
                    let a = match order.signum() {
                        1 => [unit, -unit.mul_i()],
                        -1 => [unit.conj(), unit.conj().mul_i()],
                        _ => [c(unit.re, 0.0), c(unit.im, 0.0)],
                    };
                    (coordinate, a, 2)
                }
                Term::Scalar { coordinate, .. } => (coordinate, [unit.conj(), C64::zero()], 1),
            };
            if first >= mu {
                continue; // a state of a nonlinear part: all in its samples
            }
            for (i, f) in force.iter_mut().enumerate() {
                *f = if i < mu { (0..count).fold(C64::zero(), |s, j| s + matrix[(i, first + j)] * amplitudes[j]) } else { C64::zero() };
            }
            column.fill(0.0);
            terms.add_amplitudes(k, force, &mut column);
            for (i, &x) in column.iter().enumerate() {
                if x != 0.0 {
                    out[(i, at + part)] += x;
                }
            }
        }
    }
}

impl Zero for Balance<'_> {
    fn dim(&self) -> usize {
        self.terms.unknowns
    }
    fn scale(&self, out: &mut [f64]) {
        out.copy_from_slice(&self.scale);
    }
    fn parameter_scale(&self) -> f64 {
        self.speed_scale
    }
    fn eval(&mut self, x: &[f64], p: f64, r: &mut [f64], jac: Option<&mut Mat>, dr_dp: Option<&mut [f64]>) -> Result<(), Failure> {
        self.evaluations += 1;
        self.condense(p, dr_dp.is_some()).map_err(|_| Failure::Undefined(NO_RESPONSE))?;
        let (mut jac, mut dr_dp) = (jac, dr_dp);
        if let Some(jac) = jac.as_deref_mut() {
            jac.copy_from(&self.linear);
        }
        if let Some(d) = dr_dp.as_deref_mut() {
            for (d, l) in d.iter_mut().zip(&self.load_speed) {
                *d = -l;
            }
            self.linear_speed.mul_vec_add(x, d);
        }
        self.project(x, p, jac, dr_dp);
        for ((r, l), f) in r.iter_mut().zip(&self.load).zip(&self.projected) {
            *r = f - l;
        }
        self.linear.mul_vec_add(x, r);
        Ok(())
    }
    fn monitors(&self) -> usize {
        2 * self.monitored.len()
    }
    fn monitor_width(&self) -> usize {
        2
    }
    fn monitor_scale(&self, out: &mut [f64]) {
        let size = self.scale.iter().copied().fold(f64::INFINITY, f64::min);
        out.fill(1e-3 * size);
    }
    fn measure(&mut self, x: &[f64], p: f64, out: &mut [f64]) -> Result<(), Failure> {
        let Some(which) = self.terms.orders.iter().position(|&k| k == self.terms.divisor) else { return Ok(()) };
        let mut motion = Vec::new();
        if self.pace == Some(self.pace(p)) {
            self.project(x, p, None, None);
            self.motion(x, which, &mut motion);
        } else {
            // one order is enough
            self.pace = None;
            self.condenser.set_pace(self.system, &self.pace(p));
            let mut order = std::mem::take(&mut self.measured);
            let condensed = self.condenser.order(self.system, self.terms.divisor, false, &mut order);
            if condensed.is_ok() {
                self.project(x, p, None, None);
                self.motion_of(x, self.terms.divisor, &order, &mut motion);
            }
            self.measured = order;
            condensed.map_err(|_| Failure::Undefined(NO_RESPONSE))?;
        }
        for (i, (pair, lever)) in self.monitored.iter().enumerate() {
            let [x, y] = pair.amplitudes(&motion);
            let forward = (x + y.mul_i()).scale(0.5 * *lever);
            out[2 * i] = forward.re;
            out[2 * i + 1] = forward.im;
        }
        Ok(())
    }
    fn max_parameter_step(&mut self, _: &[f64], p: f64) -> f64 {
        if let Some(watch) = self.watch {
            watch(p);
        }
        self.resonances.iter().map(|&(centre, half_width)| resonance_cap(p.abs(), centre, half_width)).fold(f64::INFINITY, f64::min)
    }
    fn cancelled(&self) -> bool {
        self.cancel.is_some_and(|c| c.load(Ordering::Relaxed))
    }
}
