//! Linear synchronous response: `T(i W) X = F` with the forces that turn with the rotor.

use super::characteristic::{Characteristic, Equilibrium, Frame, is_polynomial, nonlinear_states};
use super::locate::State;
use super::sectors::{Sectors, circular, imaginary};
use super::spectra_ahead;
use crate::diagnostic::Diagnostic;
use crate::model::linear::{Form, LinearModel, LinearScratch};
use crate::model::part::At;
use crate::model::probe::Probe;
use crate::model::system::System;
use crate::model::tangent::{SparseTangent, TangentScratch};
use laval_num::complex::{C64, c};
use laval_num::dense::Field;
use laval_num::factor::{Each, Factors, Forced, Plan, Solved, Terms};
use laval_num::lanes::LANES;
use laval_num::work::spend;
use serde::{Deserialize, Serialize};
use std::f64::consts::{FRAC_PI_2, PI};

/// Complex amplitudes `X` of the motion `Re(X exp(i phase))` over the unknowns of the characteristic matrix, in x and y.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Response {
    /// Spin speed, rad/s.
    pub speed: f64,
    /// Amplitudes: coordinates, then states.
    pub x: Vec<C64>,
    /// Residual of the linear system over the size of its right side.
    pub residual: f64,
}

impl Response {
    /// Forward and backward circular amplitudes of the pair that starts at coordinate `i`.
    pub fn circles(&self, i: usize) -> (C64, C64) {
        circular(self.x[i], self.x[i + 1])
    }
    /// Semi-major axis of the orbit.
    pub fn major(&self, i: usize) -> f64 {
        let (f, b) = self.circles(i);
        f.abs() + b.abs()
    }
    /// Forward and backward circular amplitudes of what a probe measures.
    pub fn circles_of(&self, probe: &Probe) -> (C64, C64) {
        let [x, y] = probe.amplitudes(&self.x);
        circular(x, y)
    }
    /// Semi-major axis of what a probe measures, m or rad.
    pub fn size(&self, probe: &Probe) -> f64 {
        let (f, b) = self.circles_of(probe);
        f.abs() + b.abs()
    }
    /// Direction of the major axis, the angle from x in rad, above -pi/2 and at most pi/2: there the circles meet, at the mean of their phases. NaN of a circle, which has none.
    pub fn direction(&self, i: usize) -> f64 {
        direction(self.circles(i))
    }
    /// The same of what a probe measures.
    pub fn direction_of(&self, probe: &Probe) -> f64 {
        direction(self.circles_of(probe))
    }
}

fn direction((f, b): (C64, C64)) -> f64 {
    let less = f.abs().min(b.abs());
    if !(less > CIRCLE * (f.abs() + b.abs())) {
        return f64::NAN;
    }
    let angle = 0.5 * (f * b).arg();
    // a line along y is one direction, not two
    if angle <= -FRAC_PI_2 { angle + PI } else { angle }
}

/// The smaller of two circles over the orbit below which the orbit is a circle itself, to rounding.
const CIRCLE: f64 = 1e-9;

/// Response at a speed; `None` where T is singular (an undamped resonance). Zero at standstill, where no unbalance acts.
///
/// # Errors
/// As the state.
pub fn response(system: &System, state: State, speed: f64) -> Result<Option<Response>, Diagnostic> {
    let Equations { plan, entries, polynomial, load, sectors } = equations(system, state, speed)?;
    // at standstill no unbalance acts, and what no stiffness holds stays where it is
    let still = speed == 0.0 && load.iter().all(|f| *f == C64::ZERO) && entries.iter().all(|x| x.is_finite());
    let at_rest = Response { speed, x: vec![C64::ZERO; load.len()], residual: 0.0 };
    Ok(solve(plan, &entries, polynomial, load, speed).or(still.then_some(at_rest)).map(|mut r| {
        if let Some(sectors) = sectors {
            sectors.restore(&mut r.x);
        }
        r
    }))
}

/// The same at some speeds: of a large machine whose T is a polynomial as many together as there are lanes.
///
/// # Errors
/// As the state, speed by speed.
pub fn responses(system: &System, state: State, speeds: &[f64]) -> Vec<Result<Option<Response>, Diagnostic>> {
    let some: Vec<&[f64]> = speeds.chunks(LANES).collect();
    spectra_ahead::together(&some, |some| together(system, state, some)).into_iter().flatten().collect()
}

/// Chunks of lanes that are computed on all processors, looking ahead.
const CHUNKS: usize = 4;

/// Responses at speeds that are looked at from left to right, some of them together.
pub(super) struct Ahead<'a> {
    system: &'a System,
    state: State<'a>,
    /// Ascending.
    planned: Vec<f64>,
    known: Vec<(f64, Result<Option<Response>, Diagnostic>)>,
}

impl<'a> Ahead<'a> {
    /// At these speeds (ascending) and in the middle between them.
    pub fn new(system: &'a System, state: State<'a>, speeds: &[f64]) -> Self {
        let mut planned = Vec::new();
        // dear by themselves, or many together: looking ahead pays
        if plan(system).suits_lanes() || !is_polynomial(system) {
            for pair in speeds.windows(2) {
                planned.extend([pair[0], 0.5 * (pair[0] + pair[1])]);
            }
            planned.extend(speeds.last());
        }
        Ahead { system, state, planned, known: Vec::new() }
    }

    /// As [`response`].
    ///
    /// # Errors
    /// As the state.
    pub fn at(&mut self, speed: f64) -> Result<Option<Response>, Diagnostic> {
        let place = self.planned.partition_point(|&w| w < speed);
        if self.planned.get(place) == Some(&speed) && self.known.iter().all(|k| k.0 != speed) {
            // the middle before is looked at after the speed
            let first = place.saturating_sub(1);
            let some = &self.planned[first..self.planned.len().min(first + CHUNKS * LANES)];
            self.known = some.iter().copied().zip(responses(self.system, self.state, some)).collect();
        }
        match self.known.iter().position(|k| k.0 == speed) {
            Some(k) => self.known.swap_remove(k).1,
            None => response(self.system, self.state, speed),
        }
    }
}

fn together(system: &System, state: State, speeds: &[f64]) -> Vec<Result<Option<Response>, Diagnostic>> {
    let single = |&speed: &f64| response(system, state, speed);
    if !plan(system).suits_lanes() || !is_polynomial(system) {
        return speeds.iter().map(single).collect();
    }
    let all: Vec<Result<Equations, Diagnostic>> = speeds.iter().map(|&speed| equations(system, state, speed)).collect();
    let (mut which, mut systems) = (Vec::new(), Vec::new());
    for (k, equations) in all.iter().enumerate() {
        if let Ok(Equations { polynomial: Some(terms), load, sectors: None, .. }) = equations
            && speeds[k] != 0.0
        {
            which.push(k);
            systems.push(Forced { frequency: speeds[k], terms: terms.each_ref().map(Vec::as_slice), right: load });
        }
    }
    let mut out: Vec<Option<Result<Option<Response>, Diagnostic>>> = speeds.iter().map(|_| None).collect();
    for (k, solved) in which.into_iter().zip(Each::default().solve(plan(system), &systems)) {
        let size = all[k].iter().flat_map(|e| &e.load).map(|z| z.abs()).fold(0.0, f64::max);
        let response = |s: Solved| Response { speed: speeds[k], x: s.x, residual: if size > 0.0 { s.residual / size } else { s.residual } };
        out[k] = solved.map(response).map(|r| Ok(Some(r)));
    }
    // what the lanes do not give is solved for by itself
    out.into_iter().zip(speeds).map(|(found, speed)| found.unwrap_or_else(|| single(speed))).collect()
}

/// Whether T is known at a speed: where a part has no accurate reaction it holds what is no number, and then there is no response that could grow without bound either.
///
/// # Errors
/// As the state.
pub fn is_known(system: &System, state: State, speed: f64) -> Result<bool, Diagnostic> {
    Ok(equations(system, state, speed)?.entries.iter().all(|x| x.is_finite()))
}

/// T as entries and the load, in x and y or in sectors, which are then given.
struct Equations<'a> {
    plan: &'a Plan,
    entries: Vec<C64>,
    /// `A0, A1, A2` of T, where it is a polynomial.
    polynomial: Option<[Vec<f64>; 3]>,
    load: Vec<C64>,
    sectors: Option<Sectors>,
}

fn equations<'a>(system: &'a System, state: State, speed: f64) -> Result<Equations<'a>, Diagnostic> {
    let about = state(speed)?;
    Ok(if about.frame == Frame::Fixed && nonlinear_states(system).is_empty() {
        fixed(system, speed, Some(&about))
    } else {
        let mut t = Characteristic::new(system, &about);
        let [entries, _] = t.entries(imaginary(speed));
        let (_, mut load) = t.loads();
        t.sectors().polarise(&mut load);
        Equations { plan: plan(system), entries, polynomial: None, load, sectors: Some(t.sectors().clone()) }
    })
}

fn plan(system: &System) -> &Plan {
    system.assembly(Form::Frequency).plan()
}

/// Response of the linear parts alone, nonlinear parts left out; `None` where they hold no body.
pub fn of_linear_parts(system: &System, speed: f64) -> Option<Response> {
    let Equations { plan, entries, polynomial, load, .. } = fixed(system, speed, None);
    solve(plan, &entries, polynomial, load, speed)
}

/// T(i W) and the load in x and y, without derivatives: all that a response about a state at rest takes. Without a state nonlinear parts are left out.
fn fixed<'a>(system: &'a System, speed: f64, about: Option<&Equilibrium>) -> Equations<'a> {
    let (n, s) = (system.n(), c(0.0, speed));
    let (mut model, mut scratch) = (LinearModel::default(), LinearScratch::default());
    system.linear(system.params(), speed, Form::Frequency, &mut model, &mut scratch);
    let mut polynomial = (is_polynomial(system) && !model.plan().is_dense()).then(|| model.polynomial());
    let mut entries = match &polynomial {
        Some([a0, a1, a2]) => {
            spend(4 * a0.len() as u64);
            a0.iter().zip(a1).zip(a2).map(|((a0, a1), a2)| c(a0 - speed * speed * a2, speed * a1)).collect()
        }
        None => {
            let mut entries = Vec::new();
            system.dynamic_stiffness_entries(system.params(), &model, Form::Frequency, s, &mut entries, &mut scratch);
            entries
        }
    };
    if let Some(about) = about.filter(|_| system.slots().iter().any(|s| !s.is_linear())) {
        let zero = vec![0.0; n];
        let at = At { q: &about.q, v: &zero, a: &zero, z: &about.z, phase: 0.0, speed, spin_accel: 0.0, t: 0.0 };
        let (mut t, mut ts) = (SparseTangent::default(), TangentScratch::default());
        system.tangent(&at, false, &mut t, &mut ts, |s| !s.is_linear());
        for (power, (tangent, factor)) in [(&t.q, C64::ONE), (&t.v, s), (&t.a, s * s)].into_iter().enumerate() {
            for &(i, j, x) in &tangent.0 {
                if let Some(e) = model.pattern().index(i, j) {
                    entries[e] += factor.scale(x);
                    polynomial.iter_mut().for_each(|terms| terms[power][e] += x);
                }
            }
        }
    }
    if about.is_none() {
        // states of nonlinear parts are left out with them
        for i in model.held()..model.pattern().n() {
            model.pattern().row(i).filter(|x| x.1 == i).for_each(|(e, _)| {
                entries[e] = C64::ONE;
                polynomial.iter_mut().for_each(|terms| terms[0][e] = 1.0);
            });
        }
    }
    let b = &model.loads;
    let load = (0..model.pattern().n()).map(|i| if i < n { c(b.force_cos[i], -b.force_sin[i]) } else { C64::ZERO }).collect();
    Equations { plan: plan(system), entries, polynomial, load, sectors: None }
}

/// Solves with refinement.
fn solve(plan: &Plan, entries: &[C64], polynomial: Option<[Vec<f64>; 3]>, load: Vec<C64>, speed: f64) -> Option<Response> {
    let size = load.iter().map(|z| z.abs()).fold(0.0, f64::max);
    let factors = Factors::new(plan, entries).ok()?;
    let pattern = plan.pattern();
    let s = c(0.0, speed);
    let exact = polynomial.as_ref().map(|[a0, a1, a2]| [(C64::ONE, &a0[..]), (s, &a1[..]), (s * s, &a2[..])]);
    let exact = exact.as_ref().map(|terms| Terms { pattern, terms });
    let rest = |x: &[C64]| -> Vec<C64> {
        if let Some(exact) = &exact {
            return exact.residual(x, &load);
        }
        let row = |i: usize| pattern.row(i).fold(C64::ZERO, |sum, (e, j)| sum + entries[e] * x[j]);
        load.iter().enumerate().map(|(i, f)| *f - row(i)).collect()
    };
    let mut x = load.clone();
    if let Some(exact) = &exact {
        exact.solve(&factors, &mut x);
    } else {
        factors.solve(&mut x);
        let mut r = rest(&x);
        factors.solve(&mut r);
        x.iter_mut().zip(&r).for_each(|(x, r)| *x += *r);
    }
    if !x.iter().all(|z| z.is_finite()) {
        return None;
    }
    let residual = rest(&x).iter().map(|r| r.abs()).fold(0.0, f64::max);
    Some(Response { speed, x, residual: if size > 0.0 { residual / size } else { residual } })
}
