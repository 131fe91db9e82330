//! All stable steady states of the machine at a speed: linear response, or every branch of the nonlinear one.

use super::detail::Detail;
use crate::diagnostic::Diagnostic;
use crate::model::part::{At, Observed};
use crate::model::system::{System, Workspace};
use crate::solve::characteristic::Characteristic;
use crate::solve::extrema::unbounded_at;
use crate::solve::harmonic::balance::orbit::Orbit;
use crate::solve::harmonic::balance::problem::{Balance, Discretisation};
use crate::solve::harmonic::branches::measure::{Measure, fastest};
use crate::solve::harmonic::branches::response::{Request, Response, respond};
use crate::solve::harmonic::stability::floquet::Stability;
use crate::solve::linear_response::response;
use crate::solve::pencil::wants_polish;
use crate::solve::pencil::{Spectrum, modes_about};
use crate::solve::rest::rest;
use crate::study::shared::support::{growth_error, growth_rounding, larger};
use crate::text;
use laval_num::complex::C64;
use laval_num::newton::{Options, newton};
use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::sync::atomic::AtomicBool;

/// One steady state, by what limits speak of.
#[derive(Clone, Debug)]
pub(super) struct State {
    /// Largest displacement of each body, at any of its points where something is attached, m.
    pub displacement: Vec<f64>,
    /// Largest velocity of each body, the same, m/s.
    pub velocity: Vec<f64>,
    /// Largest displacement, m, and velocity, m/s, of each probe that is no tilt.
    pub points: Vec<[f64; 2]>,
    /// Largest tilt of each body, rad; 0 of a body that does not tilt.
    pub tilt: Vec<f64>,
    /// Largest force of each part that shows one, N.
    pub force: BTreeMap<String, f64>,
    /// Largest moment of each part that shows one, N m.
    pub moment: BTreeMap<String, f64>,
    /// Largest use of the validity of a part, and of which; none where no part states one.
    pub validity: Option<(f64, Detail)>,
    /// Forward amplitude of each body at the spin frequency, m.
    pub forward: Vec<C64>,
    /// The same of its tilt, rad; 0 of a body that does not tilt.
    pub lean: Vec<C64>,
    /// Of the disturbance that grows most.
    pub growth: Growth,
    /// Torque of the drive that holds the speed, mean over a turn, N m.
    pub torque: f64,
    /// Does not grow beyond its error.
    pub stable: bool,
}

/// How fast the disturbance grows that grows most.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Growth {
    /// Its rate, 1/s.
    pub rate: f64,
    /// By how much a rate exceeds its error at most, 1/s: not above 0 where nothing grows beyond it.
    pub beyond: f64,
}

impl Growth {
    /// Of a spectrum.
    pub fn of(spectrum: &Spectrum) -> Self {
        let rounding = growth_rounding(spectrum);
        let beyond = spectrum.modes.iter().map(|m| m.growth() - growth_error(m, rounding));
        Growth { rate: spectrum.least_stable().map_or(f64::NEG_INFINITY, |m| m.growth()), beyond: beyond.fold(f64::NEG_INFINITY, larger) }
    }

    /// Excess over the rate at which disturbances must die out, 1/s. Where none is required, what neither grows nor decays to its error is kept.
    pub fn excess(self, required: f64) -> f64 {
        if required > 0.0 { self.rate + required } else { self.beyond }
    }
}

const SAMPLES: usize = 48;

/// What an orbit shows.
fn shown(system: &System, orbit: &Orbit, offset: &[f64], order: usize, growth: Growth) -> State {
    let (n, m) = (system.n(), system.m());
    let (mut q, mut v, mut a, mut z) = (vec![0.0; n], vec![0.0; n], vec![0.0; n], vec![0.0; m]);
    let bodies = system.stations();
    let mut out = State {
        displacement: vec![0.0; bodies.len()],
        velocity: vec![0.0; bodies.len()],
        points: vec![[0.0; 2]; system.probes().len()],
        tilt: vec![0.0; bodies.len()],
        force: BTreeMap::new(),
        moment: BTreeMap::new(),
        validity: None,
        forward: bodies.iter().map(|b| orbit.whirl(&b.lateral, order).0).collect(),
        lean: bodies.iter().map(|b| b.tilt.as_ref().map_or(C64::zero(), |t| orbit.whirl(t, order).0)).collect(),
        growth,
        torque: 0.0,
        stable: growth.beyond <= 0.0,
    };
    // NaN stays
    let raise = |x: &mut f64, y: f64| {
        if !(y <= *x) {
            *x = y;
        }
    };
    let mut ws = Workspace::default();
    for j in 0..SAMPLES {
        let tau = TAU * j as f64 / SAMPLES as f64;
        orbit.at(tau, &mut q, &mut v, &mut a, &mut z);
        q.iter_mut().zip(offset).for_each(|(q, o)| *q += o);
        let at =
            At { q: &q, v: &v, a: &a, z: &z, phase: order as f64 * tau, speed: orbit.speed, spin_accel: 0.0, t: tau / orbit.frequency };
        for (slot, o) in system.observe(&at, &mut ws) {
            let of = match (o.unit, o.name) {
                ("N", _) => &mut out.force,
                ("N m", Observed::MOMENT) => &mut out.moment,
                _ => continue,
            };
            raise(of.entry(system.slots()[slot].name.clone()).or_insert(0.0), o.value.abs());
        }
        for (slot, u) in system.validity(&at, &mut ws) {
            // NaN stays
            if out.validity.as_ref().is_none_or(|v| !(u.ratio <= v.0) && !v.0.is_nan()) {
                out.validity = Some((u.ratio, Detail::Model { part: system.slots()[slot].name.clone(), statement: u.what }));
            }
        }
        let (mut force, mut rate, mut spin) = (vec![0.0; n], vec![0.0; m], 0.0);
        let mut rows = crate::model::part::Rows { force: &mut force, rate: &mut rate, spin: &mut spin };
        system.residual(system.params(), &at, &mut rows, &mut ws, |_| true);
        out.torque += spin / SAMPLES as f64;
    }
    // the largest values lie between the instants; displacements count from rest
    for (k, p) in system.probes().iter().enumerate() {
        let of = if p.is_tilt() { &mut out.tilt } else { &mut out.displacement };
        let size = Measure::Probe(k).largest(system, orbit, order).0;
        raise(&mut of[p.station], size);
        raise(&mut out.points[k][0], size);
        if !p.is_tilt() {
            let velocity = fastest(p, orbit);
            raise(&mut out.velocity[p.station], velocity);
            raise(&mut out.points[k][1], velocity);
        }
    }
    if offset.iter().all(|o| *o == 0.0) {
        for slot in Measure::forces(system) {
            raise(out.force.entry(system.slots()[slot].name.clone()).or_insert(0.0), Measure::Force(slot).largest(system, orbit, order).0);
        }
    }
    out
}

/// The spectrum about rest.
pub(super) fn spectrum(system: &System, speed: f64) -> Result<Spectrum, Diagnostic> {
    modes_about(system, &rest(system, speed)?, wants_polish(system))
}

/// Decay over the speed below which a resonance may be without bound.
const UNDAMPED: f64 = 1e-6;

/// The steady state of a linear machine; `None` at an undamped resonance, where amplitudes are what rounding makes of infinity.
pub(super) fn linear(system: &System, speed: f64, growth: Growth) -> Result<Option<State>, Diagnostic> {
    let find = |w: f64| rest(system, w);
    if !(growth.rate < -UNDAMPED * speed.abs()) && unbounded_at(system, &find, system.probes(), speed) {
        return Ok(None);
    }
    let Some(r) = response(system, &find, speed)? else { return Ok(None) };
    let about = rest(system, speed)?;
    let t = Characteristic::new(system, &about);
    let mut states = vec![C64::zero(); system.m()];
    for (&k, x) in t.states().iter().zip(&r.x[system.n()..]) {
        states[k] = *x;
    }
    let orbit = Orbit {
        speed,
        frequency: speed,
        orders: vec![1],
        coordinates: vec![r.x[..system.n()].to_vec()],
        states: vec![states],
        ..Orbit::default()
    };
    Ok(Some(shown(system, &orbit, &about.q, 1, growth)))
}

/// A part of the machine states a validity.
pub(super) fn states_validity(system: &System, speed: f64) -> bool {
    let (q, z) = (vec![0.0; system.n()], vec![0.0; system.m()]);
    let at = At { q: &q, v: &q, a: &q, z: &z, phase: 0.0, speed, spin_accel: 0.0, t: 0.0 };
    !system.validity(&at, &mut Workspace::default()).is_empty()
}

/// Branches of the nonlinear response of the machine as it is at one speed: where the states at speeds nearby start from.
pub(super) struct Branches {
    response: Response,
    range: (f64, f64),
}

impl Branches {
    /// Follows all branches over a range.
    pub fn follow(system: &System, range: (f64, f64), cancel: &AtomicBool) -> Result<Self, Diagnostic> {
        let request = Request { stability: false, ..Request::over(range.0, range.1) };
        Ok(Branches { response: respond(system, &request, cancel, &|_| ())?, range })
    }

    /// Discretisation in words, for evidence.
    pub fn harmonics(&self) -> usize {
        self.response.discretisation.harmonics
    }

    /// Folds found on the way, rad/s.
    pub fn folds(&self) -> impl Iterator<Item = f64> + '_ {
        self.response.branches.iter().flat_map(|b| &b.folds).map(|f| f.speed)
    }

    /// All steady states of a machine at a speed, on this branch structure; `Err` when stability cannot be assessed.
    pub fn at(&self, system: &System, speed: f64) -> Result<Vec<State>, Diagnostic> {
        let d: Discretisation = self.response.discretisation;
        let mut balance = Balance::new(system, d, self.range, None)?;
        let mut stability = Stability::new(system).map_err(|why| {
            Diagnostic::error("operating_window.stability", text!("the stability of a steady state cannot be assessed: {why}", why))
        })?;
        let mut found: Vec<Vec<f64>> = Vec::new();
        for mut x in self.starts(speed) {
            if newton(&mut balance, &mut x, speed, &Options { to_rounding: true, ..Options::default() }).is_err() {
                continue;
            }
            let scale = balance.scales().to_vec();
            let same = |y: &Vec<f64>| y.iter().zip(&x).zip(&scale).all(|((a, b), s)| (a - b).abs() <= 1e-6 * s.max(a.abs()));
            if !found.iter().any(same) {
                found.push(x);
            }
        }
        let mut out = Vec::new();
        for x in found {
            balance.sample(&x, speed);
            let exponents = stability.exponents(&mut balance, &x, speed);
            let unknown = Growth { rate: f64::NAN, beyond: f64::NAN };
            let growth = exponents.map_or(unknown, |e| Growth { rate: e.growth(), beyond: e.growth() - e.error });
            let orbit = Orbit::of(&mut balance, &x, speed)
                .map_err(|e| Diagnostic::error("operating_window.orbit", text!("a steady state cannot be evaluated: {e}", e)))?;
            out.push(shown(system, &orbit, &[], d.divisor, growth));
        }
        Ok(out)
    }

    /// Estimates of all states at a speed: between the points of the branches, and between a fold and the points on both its sides, where a state
    /// departs like the square root of the distance.
    fn starts(&self, speed: f64) -> Vec<Vec<f64>> {
        let between = |a: f64, b: f64| a.min(b) <= speed && speed <= a.max(b);
        let mix = |a: &[f64], b: &[f64], share: f64| a.iter().zip(b).map(|(a, b)| a + share * (b - a)).collect::<Vec<f64>>();
        let mut out = Vec::new();
        for branch in &self.response.branches {
            for pair in branch.points.windows(2).filter(|p| between(p[0].speed, p[1].speed)) {
                let (a, b) = (&pair[0], &pair[1]);
                out.push(mix(&a.x, &b.x, if b.speed == a.speed { 0.0 } else { (speed - a.speed) / (b.speed - a.speed) }));
            }
            for f in &branch.folds {
                let sides = [branch.points.get(f.after), branch.points.get(f.after + 1)];
                for p in sides.into_iter().flatten().filter(|p| between(f.speed, p.speed) && p.speed != f.speed) {
                    out.push(mix(&f.x, &p.x, ((speed - f.speed) / (p.speed - f.speed)).sqrt()));
                }
            }
        }
        out
    }
}
