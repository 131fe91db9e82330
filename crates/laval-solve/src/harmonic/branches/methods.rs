//! Approximate methods beside the converged periodic motion: harmonic balance with few orders, averaging, elliptic balance, integration in time.
//!
//! Averaging (van der Pol) lets one harmonic vary slowly, `z = D(t) exp(i W t)`:
//!
//! ```text
//! -i K'(w) D' + K D + N(D) = p,    K' = dK/dw at fixed spin
//! ```
//!
//! Its stationary states are those of one-harmonic balance. Beside them it gives growth rates of the slow motion, which know the mode near the speed only.
//!
//! Theory: `docs/theory/approximate-methods.md#averaging`.

use crate::diagnostic::Diagnostic;
use crate::harmonic::balance::elliptic::{law, motions};
use crate::harmonic::balance::orbit::Orbit;
use crate::harmonic::balance::problem::Balance;
use crate::harmonic::balance::terms::Term;
use crate::harmonic::branches::response::Response;
use crate::harmonic::stability::floquet::{Exponents, Stability};
use crate::model::probe::Probe;
use crate::model::system::System;
use crate::motion::Motion;
use crate::programme::Programme;
use crate::symmetry::Symmetry;
use laval_num::continuation::Zero;
use laval_num::dense::{Lu, Mat};
use laval_num::newton::{Options, newton};
use laval_num::ode::{Control, Dop853, End, Tolerance, integrate};
use laval_num::order::SortByNumber;
use laval_num::work::piece;
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;
use std::sync::atomic::AtomicBool;

/// A method.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Method {
    /// Harmonic balance with orders up to this one.
    Harmonic(usize),
    /// Averaging: one harmonic, slowly varying.
    Averaging,
    /// Elliptic balance.
    Elliptic,
    /// Integration in time.
    Time,
    /// Harmonic balance with as many orders as change nothing.
    Converged,
}

impl std::fmt::Display for Method {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Method::Harmonic(h) => write!(f, "harmonic balance to order {h}"),
            Method::Averaging => f.write_str("averaging"),
            Method::Elliptic => f.write_str("elliptic balance"),
            Method::Time => f.write_str("time integration"),
            Method::Converged => f.write_str("converged"),
        }
    }
}

/// One state by one method.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Value {
    /// Spin speed, rad/s.
    pub speed: f64,
    /// Number of the state at this speed, by amplitude.
    pub state: usize,
    /// Method.
    pub method: Method,
    /// Largest size of the [`component`] of each of the system's probes over a period, m or rad; NaN when the method has no such state.
    pub peaks: Vec<f64>,
    /// Largest change of a peak from the converged one, over the largest converged peak, both in the typical size of their kind.
    pub deviation: f64,
    /// Largest growth rate it gives, 1/s; NaN when it gives none.
    pub growth: f64,
    /// Error of the growth rate, 1/s; 0 when there is no estimate.
    pub growth_error: f64,
    /// k^2 of elliptic balance.
    pub parameter: f64,
}

/// All of them.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Comparison {
    /// By speed, state, method.
    pub values: Vec<Value>,
    /// Why elliptic balance was left out.
    #[serde(deserialize_with = "laval_num::text::optional")]
    pub no_elliptic: Option<laval_num::text::Text>,
    /// Why time integration was left out.
    pub no_time: Option<String>,
    /// Not ended before the last speed.
    pub complete: bool,
}

/// Steps of integration a period, at most.
const STEPS: u64 = 2000;
/// Periods over which a state is followed in time.
const PERIODS: usize = 5;
/// Instants of a period at which peaks are looked for.
const INSTANTS: usize = 256;

/// Orders of harmonic balance worth a comparison with a converged response: up to `most`.
pub fn orders(response: &Response, most: usize) -> Vec<usize> {
    let d = response.discretisation;
    let step = if d.symmetry == Symmetry::None { 1 } else { 2 };
    if d.symmetry == Symmetry::Circular { vec![1] } else { (1..=most.min(d.harmonics)).step_by(step).collect() }
}

/// Compares the methods at some speeds with a converged response; `lower` are the responses with orders up to some numbers.
///
/// # Errors
/// A balance that cannot be set up.
pub fn compare(
    system: &System,
    response: &Response,
    range: (f64, f64),
    speeds: &[f64],
    lower: &[(usize, Response)],
    cancel: &AtomicBool,
    tick: &dyn Fn(u64),
) -> Result<Comparison, Diagnostic> {
    let d = response.discretisation;
    let elliptic = law(system, d.symmetry, range.1);
    let mut out = Comparison { values: Vec::new(), no_elliptic: elliptic.err(), no_time: None, complete: true };
    let mut full = Balance::new(system, d, range, None)?;
    let mut few: Vec<(usize, &Response, Balance)> = Vec::new();
    for (h, r) in lower {
        few.push((*h, r, Balance::new(system, r.discretisation, range, None)?));
    }
    let mut assessor = Stability::new(system).ok();
    for (i, &speed) in speeds.iter().enumerate() {
        if cancel.load(std::sync::atomic::Ordering::Relaxed) {
            out.complete = false;
            break;
        }
        // a speed is listed whole or not at all
        let (listed, no_time) = (out.values.len(), out.no_time.clone());
        let whole = piece(|| {
            let states = states_at(&mut full, response, speed);
            let sizes: Vec<f64> = states.iter().map(|s| s.1).collect();
            let most = sizes.iter().copied().fold(0.0, f64::max);
            let elliptic_states = elliptic.map_or(Vec::new(), |law| motions(system, &law, speed, 4.0 * most));
            let with_elliptic = paired(&sizes, &elliptic_states.iter().map(|e| e.first.abs()).collect::<Vec<_>>());
            let lower_states: Vec<Vec<(Vec<f64>, f64)>> = few.iter_mut().map(|(_, r, balance)| states_at(balance, r, speed)).collect();
            let with_lower: Vec<Vec<Option<usize>>> =
                lower_states.iter().map(|l| paired(&sizes, &l.iter().map(|s| s.1).collect::<Vec<_>>())).collect();
            for (state, (x, _)) in states.iter().enumerate() {
                let Ok(orbit) = Orbit::of(&mut full, x, speed) else { continue };
                let exact = peaks(system, &orbit);
                full.sample(x, speed);
                let exponents = assessor.as_mut().and_then(|s| s.exponents(&mut full, x, speed).ok());
                let (growth, growth_error) = exponents.map_or((f64::NAN, 0.0), |e: Exponents| (e.growth(), e.error));
                let mut push = |method: Method, own: Vec<f64>, growth: f64, parameter: f64| {
                    let deviation = if own.is_empty() { f64::NAN } else { deviation(system.probes(), &own, &exact) };
                    let peaks = if own.is_empty() { vec![f64::NAN; exact.len()] } else { own };
                    out.values.push(Value { speed, state, method, peaks, deviation, growth, growth_error: 0.0, parameter });
                };
                for (k, (h, _, balance)) in few.iter_mut().enumerate() {
                    let found = with_lower[k][state].map(|j| &lower_states[k][j].0);
                    let own = found.and_then(|x| Orbit::of(balance, x, speed).ok());
                    let own = own.map_or(Vec::new(), |o| peaks(system, &o));
                    if *h == 1 {
                        let growth = found.and_then(|x| slow_growth(balance, x, speed)).unwrap_or(f64::NAN);
                        push(Method::Averaging, own.clone(), growth, f64::NAN);
                    }
                    push(Method::Harmonic(*h), own, f64::NAN, f64::NAN);
                }
                if elliptic.is_ok() {
                    let near = with_elliptic[state].map(|j| &elliptic_states[j]);
                    let own = near.map_or(Vec::new(), |e| peaks(system, &e.motion));
                    push(Method::Elliptic, own, f64::NAN, near.map_or(f64::NAN, |e| e.parameter));
                }
                match in_time(system, &orbit, d.divisor) {
                    Ok(own) => push(Method::Time, own, f64::NAN, f64::NAN),
                    Err(why) => out.no_time = Some(why),
                }
                // the comparison's own last line
                let mut push = |own: Vec<f64>| {
                    out.values.push(Value {
                        speed,
                        state,
                        method: Method::Converged,
                        peaks: own,
                        deviation: 0.0,
                        growth,
                        growth_error,
                        parameter: f64::NAN,
                    });
                };
                push(exact.clone());
            }
        });
        if whole.is_none() {
            out.values.truncate(listed);
            (out.no_time, out.complete) = (no_time, false);
            break;
        }
        tick(i as u64 + 1);
    }
    Ok(out)
}

/// States of the response at a speed, by amplitude: unknowns, and the first order of the first pair.
fn states_at(balance: &mut Balance, response: &Response, speed: f64) -> Vec<(Vec<f64>, f64)> {
    let mut out: Vec<(Vec<f64>, f64)> = Vec::new();
    for w in response.branches.iter().flat_map(|b| b.points.windows(2)) {
        let (a, b) = (w[0].speed, w[1].speed);
        if (a - speed) * (b - speed) > 0.0 || a == b || w.iter().any(|p| p.x.len() != balance.dim()) {
            continue;
        }
        let t = (speed - a) / (b - a);
        let mut x: Vec<f64> = w[0].x.iter().zip(&w[1].x).map(|(p, q)| p + t * (q - p)).collect();
        if newton(balance, &mut x, speed, &Options { to_rounding: true, ..Options::default() }).is_err() {
            continue;
        }
        let first = first_order(balance, &x);
        if !out.iter().any(|(_, f)| (f - first).abs() <= 1e-7 * first.abs()) {
            out.push((x, first));
        }
    }
    out.sort_by_number(|a| a.1);
    out
}

/// Size of the harmonics at the forcing order.
fn first_order(balance: &Balance, x: &[f64]) -> f64 {
    let terms = &balance.terms;
    let own = terms.list.iter().filter(|(t, _)| t.order().unsigned_abs() as usize == terms.divisor);
    own.map(|&(t, at)| x[at..at + t.size()].iter().map(|v| v * v).sum::<f64>()).sum::<f64>().sqrt()
}

/// Which of `others` belongs to each of `own` states, both by amplitude: rank by rank where there are as many, else the nearest, each once.
fn paired(own: &[f64], others: &[f64]) -> Vec<Option<usize>> {
    if own.len() == others.len() {
        return (0..own.len()).map(Some).collect();
    }
    let mut out = vec![None; own.len()];
    let mut all: Vec<(f64, usize, usize)> = Vec::new();
    for (i, a) in own.iter().enumerate() {
        all.extend(others.iter().enumerate().map(|(j, b)| ((a / b).ln().abs(), i, j)));
    }
    all.sort_by_number(|a| a.0);
    for (distance, i, j) in all {
        if distance < 0.5 && out[i].is_none() && !out.contains(&Some(j)) {
            out[i] = Some(j);
        }
    }
    out
}

/// Which component of a probe is compared: that in the plane of x. A tilt about y moves points along x.
pub fn component(probe: &Probe) -> usize {
    usize::from(probe.is_tilt())
}

/// Largest change of a peak over the largest of the exact ones; sizes of displacements and tilts over what is typical of each.
fn deviation(probes: &[Probe], own: &[f64], exact: &[f64]) -> f64 {
    let largest = probes.iter().zip(exact).map(|(p, x)| x / p.typical()).fold(0.0, f64::max);
    let changes = probes.iter().zip(own.iter().zip(exact)).map(|(p, (a, b))| (a - b).abs() / p.typical());
    changes.fold(0.0, |m: f64, c| if c <= m { m } else { c }) / largest
}

/// Largest size of the component of every probe over a period.
fn peaks(system: &System, orbit: &Orbit) -> Vec<f64> {
    let h = TAU / INSTANTS as f64;
    let of = |probe: &Probe| {
        let side = component(probe);
        let size = |tau: f64| orbit.probe_at(probe, tau)[0][side].abs();
        let at = |j: usize| size(h * j as f64);
        let Some(best) = (0..INSTANTS).max_by(|&a, &b| at(a).total_cmp(&at(b))) else { return f64::NAN };
        // refined by halving the neighbourhood of the largest sample
        let (mut centre, mut width) = (h * best as f64, h);
        let mut value = at(best);
        for _ in 0..60 {
            for tau in [centre - 0.5 * width, centre + 0.5 * width] {
                let v = size(tau);
                if v > value {
                    (centre, value) = (tau, v);
                }
            }
            width *= 0.5;
        }
        value
    };
    system.probes().iter().map(of).collect()
}

/// Peaks of the last of some periods, followed in time from the converged motion.
fn in_time(system: &System, orbit: &Orbit, divisor: usize) -> Result<Vec<f64>, String> {
    let law = crate::motion::SpinLaw::Programme(Programme::constant(orbit.speed, 0.0));
    let mut motion = Motion::new(system, law).map_err(|d| d.message.to_string())?;
    if let Some(d) = motion.refuses_explicit() {
        return Err(d.message.to_string());
    }
    let (n, m) = (system.n(), system.m());
    let (mut q, mut v, mut a, mut z) = (vec![0.0; n], vec![0.0; n], vec![0.0; n], vec![0.0; m]);
    orbit.at(0.0, &mut q, &mut v, &mut a, &mut z);
    let mut y = [&q[..], &v[..], &z[..]].concat();
    let period = TAU * divisor as f64 / orbit.speed.abs();
    let start = period * (PERIODS - 1) as f64;
    let probes = system.probes();
    let places: Vec<f64> = probes.iter().map(|p| orbit.rest_seen(p)[component(p)]).collect();
    let mut seen = vec![0.0f64; probes.len()];
    let absolute = 1e-12 * y[..n].iter().fold(1e-12, |m: f64, x| m.max(x.abs()));
    let outputs: Vec<f64> = (0..=16 * INSTANTS).map(|j| start + period * j as f64 / (16 * INSTANTS) as f64).collect();
    let end = period * PERIODS as f64;
    let control = Control {
        outputs: &outputs[..16 * INSTANTS],
        max_steps: STEPS * PERIODS as u64,
        ..Control::new(Tolerance::All(1e-11), Tolerance::All(absolute))
    };
    struct Seen<'s>(&'s [Probe], &'s [f64], &'s mut Vec<f64>);
    impl laval_num::ode::Observer for Seen<'_> {
        fn output(&mut self, _: usize, _: f64, y: &[f64]) {
            for ((s, probe), rest) in self.2.iter_mut().zip(self.0).zip(self.1) {
                *s = s.max((probe.of(y)[component(probe)] - rest).abs());
            }
        }
    }
    let run = integrate(&mut Dop853::new(), &mut motion, 0.0, &mut y, end, &control, &mut Seen(probes, &places, &mut seen));
    match run.end {
        End::Reached => Ok(seen),
        End::WorkLimit { .. } => {
            Err(format!("the explicit method needs more than {STEPS} steps a period: some motions die out too fast for it"))
        }
        End::Failed { what, .. } => Err(format!("the integration could not go on: {what}")),
        End::StepTooSmall { .. } => Err("no step of the integration, however short, met its tolerance".into()),
        End::Cancelled { .. } | End::Event { .. } => Err("the integration was stopped".into()),
    }
}

/// Largest growth rate of the slow motion of the harmonics: eigenvalues of `-(L'_w (-i))^-1 dr/dx`.
pub fn slow_growth(balance: &mut Balance, x: &[f64], speed: f64) -> Option<f64> {
    let n = balance.dim();
    let (mut r, mut jac) = (vec![0.0; n], Mat::zeros(n, n));
    balance.eval(x, speed, &mut r, Some(&mut jac), None).ok()?;
    // dK/dw at fixed spin, column by column: the derivative of the linear part along each unknown
    let slope = balance.frequency_slope(speed)?;
    let mut slow = Mat::zeros(n, n);
    for &(term, at) in &balance.terms.list {
        if term.size() != 2 {
            return None;
        }
        // times -i for forward orders of vectors; the amplitude of other terms stands conjugate
        let sign = if matches!(term, Term::Pair { order, .. } if order > 0) { 1.0 } else { -1.0 };
        for i in 0..n {
            slow[(i, at)] = -sign * slope[(i, at + 1)];
            slow[(i, at + 1)] = sign * slope[(i, at)];
        }
    }
    let mut a = jac;
    Lu::new(&slow).ok()?.solve_mat(&mut a);
    a.data_mut().iter_mut().for_each(|x| *x = -*x);
    let values = laval_num::eig::eigenvalues(&a).ok()?;
    let growth = values.iter().map(|v| v.re).fold(f64::NEG_INFINITY, f64::max);
    growth.is_finite().then_some(growth)
}
