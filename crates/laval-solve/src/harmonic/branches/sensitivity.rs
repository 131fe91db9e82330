//! How stationary points of a branch (peaks of a displacement, folds) move with the parameters of the machine.
//!
//! With y = (x, W) the unknowns of the balance and the speed, `R(y; p) = 0` a branch and phi what is stationary on it (the largest displacement at a peak, the
//! speed W itself at a fold):
//!
//! ```text
//! L = phi - l^T R        l^T dR/dy = dphi/dy   (solvable where phi is stationary along the branch)
//! dphi/dp = dL/dp
//! J n = -dR/dp,  n . t = 0,  J t = 0           J = dR/dy, t the tangent of the branch
//! dy/dp = n + a t,   a = -(n^T H t + t^T d(dL/dy)/dp) / (t^T H t),   H = d2L/dy2
//! ```
//!
//! At a fold l is the left null vector of dR/dx scaled to `l^T dR/dW = 1`, and `dW/dp = -l^T dR/dp`. First derivatives are exact: dual numbers through the parts and
//! the condensation. Of second ones only those along t are needed, `d/de` of dL/dy and dL/dp at `y + e t` with l held; they are taken by differences of
//! fourth order of the exact first ones, with a step that is narrowed until they settle. What is left is stated. Where the weight bends the machine, displacements count from rest, and how
//! that place moves is taken by differences as well.
//!
//! Symbols: R residual of the balance; t in unknowns over their scales.
//!
//! Validity: simple stationary points; laws whose force jumps have no such derivatives. Both halves of a lateral pair move together where a symmetry is imposed.
//!
//! Theory: `docs/theory/harmonic-balance.md#sensitivity`.
//!
//! Sources: implicit function theorem; envelope theorem.

use crate::harmonic::balance::orbit::Orbit;
use crate::harmonic::balance::pace::Parameter;
use crate::harmonic::balance::problem::Balance;
use crate::harmonic::branches::measure::{Instant, Measure};
use crate::model::erased::D1;
use crate::model::system::System;
use crate::rest::rest;
use crate::symmetry::Symmetry;
use laval_num::complex::{C64, c};
use laval_num::continuation::Zero;
use laval_num::dense::{Lu, Mat, dot, norm};
use serde::{Deserialize, Serialize};

/// What is stationary.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stationary {
    /// A peak of this.
    Peak(Measure),
    /// The speed: a fold.
    Fold,
}

/// A parameter of a machine, by path.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Named {
    /// `drum.mass`; a lateral pair that moves together has no `.x`.
    pub path: String,
    /// SI unit.
    #[serde(deserialize_with = "laval_num::text::one")]
    pub unit: laval_num::text::Text,
    /// Value.
    pub value: f64,
    /// Which.
    pub parameter: Parameter,
}

/// Derivatives at a stationary point in one parameter.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Slope {
    /// d speed / dp.
    pub speed: f64,
    /// d measure / dp.
    pub value: f64,
}

/// A stationary point and how it moves.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Moved {
    /// Spin speed, rad/s.
    pub speed: f64,
    /// The measure there.
    pub value: f64,
    /// Unknowns.
    pub x: Vec<f64>,
    /// In the order of the parameters.
    pub slopes: Vec<Slope>,
    /// Slope of what is stationary left along the branch, relative to it, per scaled arclength.
    pub slope_left: f64,
    /// Relative change of the second derivatives at the last narrowing of the step.
    pub settled: f64,
}

/// The parameters that may vary of a machine whose motions have this symmetry. The halves of a lateral pair move together where the symmetry or their part
/// has them equal.
pub fn parameters(system: &System, symmetry: Symmetry) -> Vec<Named> {
    let symmetric = matches!(symmetry, Symmetry::Circular | Symmetry::Quarter);
    let (slots, values) = (system.param_slots(), system.params());
    let varies = |first: usize, count: usize| {
        [1e-3, -1e-3].iter().any(|h| {
            let moved = |v: f64| if v == 0.0 { *h } else { v * (1.0 + h) };
            let changed: Vec<(&str, f64)> = (first..first + count).map(|i| (slots[i].name.as_str(), moved(values[i]))).collect();
            system.with(&changed).is_ok()
        })
    };
    let mut out: Vec<Named> = Vec::new();
    let mut first = 0;
    while first < slots.len() {
        let slot = &slots[first];
        let pair = slot.name.strip_suffix(".x").filter(|p| slots.get(first + 1).is_some_and(|s| s.name.strip_suffix(".y") == Some(p)));
        let (path, count) = match pair {
            Some(path) if values[first] == values[first + 1] && (symmetric || !varies(first, 1)) => (path.to_string(), 2),
            _ => (slot.name.clone(), 1),
        };
        if varies(first, count) {
            out.push(Named { path, unit: slot.unit, value: values[first], parameter: Parameter { first, count } });
        }
        first += count;
    }
    out
}

/// First derivatives at a point, all in the scaled unknowns and speed.
struct Local {
    /// Rows of J, n x (n + 1).
    j: Mat,
    r: Vec<f64>,
    /// dphi/dy and the measure with its own gradient.
    phi: Vec<f64>,
    value: f64,
    gradient: Vec<f64>,
    /// Both components of the measured pair, differentiated at the instant that counts.
    pair: [Vec<f64>; 2],
    /// By parameter: dR/dp, dphi/dp, d measure/dp.
    r_p: Vec<Vec<f64>>,
    phi_p: Vec<f64>,
    value_p: Vec<f64>,
    tau: f64,
}

/// Derivatives of one stationary point.
struct Point<'b, 'a> {
    balance: &'b mut Balance<'a>,
    what: Stationary,
    measure: Measure,
    parameters: &'b [Parameter],
    scale: Vec<f64>,
    /// Base phase of the largest value, kept between neighbouring points.
    tau: Option<f64>,
}

/// The stationary point near `(x, speed)` and its derivatives; `along` is a guess of the direction of the branch in (x, speed). `measure` is what a fold is
/// recognised by. `None` where the derivatives do not exist or do not settle.
pub fn moved(
    balance: &mut Balance,
    (x, speed): (&[f64], f64),
    along: &[f64],
    what: Stationary,
    measure: Measure,
    parameters: &[Parameter],
) -> Option<Moved> {
    let mut scale = balance.scales().to_vec();
    scale.push(balance.parameter_scale());
    let mut point = Point { balance, what, measure, parameters, scale, tau: None };
    let found = point.moved(x, speed, along);
    point.balance.differentiate_by(None);
    found
}

/// Steps of the differences over the size of the unknowns: the widest, and the factor between them.
const WIDEST: f64 = 0.02;
/// The least such size over the arclength in which the measured motion changes by itself: the unknowns may stand still where it moves, as the nonlinear
/// coordinates do of a rotor that only tilts.
const STILL: f64 = 0.1;
const NARROWER: f64 = 0.4;
const STEPS: usize = 12;
/// Change at which the differences have settled, and at which they are given up.
const SETTLED: f64 = 1e-10;
const LOST: f64 = 1e-4;
/// Relative step of the differences of the place of rest.
const REST_STEP: f64 = 1e-3;
/// Newton steps along the branch to the peak.
const POLISH: usize = 6;

impl Point<'_, '_> {
    fn moved(&mut self, x: &[f64], speed: f64, along: &[f64]) -> Option<Moved> {
        let n = x.len();
        let mut y: Vec<f64> = x.iter().chain([&speed]).zip(&self.scale).map(|(y, s)| y / s).collect();
        let mut t: Vec<f64> = along.iter().zip(&self.scale).map(|(t, s)| t / s).collect();
        let mut left = f64::NAN;
        for step in 0..=POLISH {
            let local = self.local(&y, true)?;
            let (lu, rows) = border(&local.j, &mut t)?;
            let l = adjoint(&local, &t, &rows)?;
            let slope = dot(&local.phi, &t);
            // a peak by its value, a fold by the size of the speed
            let unit = if self.what == Stationary::Fold { self.scale[n] } else { local.value };
            let relative = (slope / unit).abs();
            if self.what == Stationary::Fold || !(relative < left) && step > 0 || step == POLISH {
                return self.derivatives(&y, &t, local, &lu, &rows, &l, relative);
            }
            left = relative;
            let second = self.second(&y, &t, &l, local.reach(&t), true)?;
            let curvature = dot(&second.0[..n + 1], &t);
            // Newton's method on the slope along the branch and on the residual
            let mut d: Vec<f64> = local.r.iter().zip(&rows).map(|(r, w)| -r * w).collect();
            d.push(-slope / curvature);
            lu.solve(&mut d);
            if !d.iter().all(|d| d.is_finite()) || norm(&d) > 0.1 * norm(&y) {
                return None;
            }
            y.iter_mut().zip(&d).for_each(|(y, d)| *y += d);
        }
        None
    }

    #[allow(clippy::too_many_arguments)]
    fn derivatives(&mut self, y: &[f64], t: &[f64], local: Local, lu: &Lu, rows: &[f64], l: &[f64], left: f64) -> Option<Moved> {
        let n = rows.len();
        let (h, lp, settled) = self.second(y, t, l, local.reach(t), false)?;
        let curvature = dot(&h, t);
        if !(settled < LOST) || curvature == 0.0 {
            return None;
        }
        let mut slopes = Vec::with_capacity(self.parameters.len());
        for (k, r_p) in local.r_p.iter().enumerate() {
            let mut d: Vec<f64> = r_p.iter().zip(rows).map(|(r, w)| -r * w).chain([0.0]).collect();
            lu.solve(&mut d);
            let a = -(dot(&d, &h) + lp[k]) / curvature;
            d.iter_mut().zip(t).for_each(|(d, t)| *d += a * t);
            let stationary = local.phi_p[k] - dot(l, r_p);
            let (speed, value) = match self.what {
                Stationary::Peak(_) => (d[n] * self.scale[n], stationary),
                Stationary::Fold => (stationary, dot(&local.gradient, &d) + local.value_p[k]),
            };
            slopes.push(Slope { speed, value });
        }
        let x = y[..n].iter().zip(&self.scale).map(|(y, s)| y * s).collect();
        Some(Moved { speed: y[n] * self.scale[n], value: local.value, x, slopes, slope_left: left, settled })
    }

    /// d/de at e = 0 of dL/dy and (unless `only_y`) dL/dp at y + e t, l held, and how well they have settled. The measured motion changes by itself in the
    /// arclength `reach`.
    fn second(&mut self, y: &[f64], t: &[f64], l: &[f64], reach: f64, only_y: bool) -> Option<(Vec<f64>, Vec<f64>, f64)> {
        let n = y.len() - 1;
        let size = norm(&y[..n]).max(STILL * reach.min(norm(y)));
        let tau = self.tau;
        let at = |point: &mut Self, e: f64| -> Option<Vec<f64>> {
            point.tau = tau;
            let shifted: Vec<f64> = y.iter().zip(t).map(|(y, t)| y + e * t).collect();
            let local = point.local(&shifted, !only_y)?;
            let mut g: Vec<f64> = (0..n + 1).map(|j| local.phi[j] - (0..n).map(|i| l[i] * local.j[(i, j)]).sum::<f64>()).collect();
            g.extend(local.r_p.iter().zip(&local.phi_p).map(|(r, p)| p - dot(l, r)));
            Some(g)
        };
        let mut best: Option<(Vec<f64>, f64)> = None;
        let mut before: Option<Vec<f64>> = None;
        let mut e = WIDEST * size;
        for _ in 0..STEPS {
            let shifts = [2.0, 1.0, -1.0, -2.0].map(|k| at(self, k * e));
            e *= NARROWER;
            let [Some(a), Some(b), Some(c), Some(d)] = shifts else { continue };
            let now: Vec<f64> = (0..a.len()).map(|i| (8.0 * (b[i] - c[i]) - (a[i] - d[i])) / (12.0 * e / NARROWER)).collect();
            if let Some(old) = &before {
                // what counts: the curvature along t, and every parameter's influence against the largest
                let curvature = |g: &[f64]| dot(&g[..n + 1], t);
                let mut change = ((curvature(&now) - curvature(old)) / curvature(&now)).abs();
                let influence = |g: f64, k: usize| (g * self.balance.system.params()[self.parameters[k].first]).abs();
                let largest = now[n + 1..].iter().enumerate().fold(0.0f64, |m, (k, g)| m.max(influence(*g, k)));
                for (k, (a, b)) in now[n + 1..].iter().zip(&old[n + 1..]).enumerate() {
                    let own = influence(a - b, k) / largest;
                    if largest > 0.0 && !(own <= change) {
                        change = own;
                    }
                }
                if best.as_ref().is_none_or(|b| !(change >= b.1)) {
                    best = Some((now.clone(), change));
                }
                if change <= SETTLED {
                    break;
                }
            }
            before = Some(now);
        }
        self.tau = tau;
        let (g, change) = best?;
        let lp = g[n + 1..].to_vec();
        Some((g[..n + 1].to_vec(), lp, change))
    }

    /// First derivatives at scaled (x, W).
    fn local(&mut self, y: &[f64], with_parameters: bool) -> Option<Local> {
        let n = y.len() - 1;
        let (x, speed): (Vec<f64>, f64) = (y[..n].iter().zip(&self.scale).map(|(y, s)| y * s).collect(), y[n] * self.scale[n]);
        self.balance.differentiate_by(None);
        let (mut r, mut jac, mut by_speed) = (vec![0.0; n], Mat::zeros(n, n), vec![0.0; n]);
        let orbit = Orbit::of(self.balance, &x, speed).ok()?;
        self.balance.eval(&x, speed, &mut r, None, None).ok()?;
        let by_unknown = self.balance.motion_tangent(&x, speed, &mut jac).ok()?;
        let turned = self.balance.motion_rates(&x, speed, &mut by_speed).ok()?;
        let mut j = Mat::zeros(n, n + 1);
        for i in 0..n {
            for k in 0..n {
                j[(i, k)] = jac[(i, k)] * self.scale[k];
            }
            j[(i, n)] = by_speed[i] * self.scale[n];
        }
        let turns = self.balance.terms.divisor;
        let tau = match self.tau {
            None => self.measure.largest(self.balance.system, &orbit, turns).1,
            Some(tau) => self.measure.near(self.balance.system, &orbit, turns, tau),
        };
        self.tau = Some(tau);
        let seen = Seen { orbit: &orbit, turns, tau };
        let columns = |c: usize| by_unknown.iter().map(|m| (0..m.rows()).map(|i| m[(i, c)]).collect::<Vec<C64>>()).collect::<Vec<_>>();
        let mut unit = vec![0.0; n];
        let (mut gradient, mut pair) = (vec![0.0; n + 1], [vec![0.0; n + 1], vec![0.0; n + 1]]);
        let mut value = f64::NAN;
        for k in 0..=n {
            let sloped = if k < n {
                unit[k] = 1.0;
                self.slope(&seen, &columns(k), Some(&unit), 0.0, None)
            } else {
                self.slope(&seen, &turned, None, 1.0, None)
            };
            unit.fill(0.0);
            let [a, b] = sloped.pair;
            (value, gradient[k]) = (sloped.size, sloped.slope * self.scale[k]);
            (pair[0][k], pair[1][k]) = (a * self.scale[k], b * self.scale[k]);
        }
        let mut phi = gradient.clone();
        if self.what == Stationary::Fold {
            phi.fill(0.0);
            phi[n] = self.scale[n];
        }
        let mut out = Local { j, r, phi, value, gradient, pair, r_p: vec![], phi_p: vec![], value_p: vec![], tau };
        if with_parameters {
            for &p in self.parameters {
                self.balance.differentiate_by(Some(p));
                let mut rates = vec![0.0; n];
                let motion = self.balance.motion_rates(&x, speed, &mut rates).ok()?;
                let slope = self.slope(&seen, &motion, None, 0.0, Some(p)).slope;
                out.r_p.push(rates);
                out.value_p.push(slope);
                out.phi_p.push(if self.what == Stationary::Fold { 0.0 } else { slope });
            }
            self.balance.differentiate_by(None);
        }
        let finite = out.value.is_finite() && out.gradient.iter().chain(&out.r).all(|x| x.is_finite()) && out.tau.is_finite();
        finite.then_some(out)
    }

    /// The measure at the instant of its largest value, and its derivative where the amplitudes of the motion have the derivatives `motion` (coordinates, then
    /// linear states, order by order), the unknowns move by `unit`, the speed at this rate, and a parameter.
    fn slope(&self, seen: &Seen, motion: &[Vec<C64>], unit: Option<&[f64]>, by_speed: f64, parameter: Option<Parameter>) -> Sloped {
        let system = self.balance.system;
        let (n, m) = (system.n(), system.m());
        let zero = D1::lift(0.0);
        let (mut q, mut v, mut accel, mut z) = (vec![zero; n], vec![zero; n], vec![zero; n], vec![zero; m]);
        let mu = self.balance.nonlinear.basis.rows.len();
        let mut own = vec![C64::zero(); self.balance.terms.coordinates];
        let stretch = by_speed / seen.turns as f64;
        for (which, &k) in seen.orbit.orders.iter().enumerate() {
            let turn = C64::cis(k as f64 * seen.tau);
            let w = k as f64 * seen.orbit.frequency;
            for i in 0..n {
                let (a, d) = (seen.orbit.coordinates[which][i] * turn, motion[which][i] * turn);
                q[i].re += a.re;
                q[i].eps[0] += d.re;
                v[i].re -= w * a.im;
                v[i].eps[0] -= w * d.im + k as f64 * stretch * a.im;
                accel[i].re -= w * w * a.re;
                accel[i].eps[0] -= w * w * d.re + 2.0 * w * k as f64 * stretch * a.re;
            }
            for (i, s) in seen.orbit.states[which].iter().enumerate() {
                z[i].re += (*s * turn).re;
            }
            for (&g, d) in self.balance.linear_states().iter().zip(&motion[which][n..]) {
                z[g].eps[0] += (*d * turn).re;
            }
            if let Some(unit) = unit {
                self.balance.terms.amplitudes(unit, k, &mut own);
                for (&g, d) in self.balance.nonlinear.states.iter().zip(&own[mu..]) {
                    z[g].eps[0] += (*d * turn).re;
                }
            }
        }
        let params: Vec<D1> =
            system.params().iter().enumerate().map(|(i, &p)| D1 { re: p, eps: [parameter.map_or(0.0, |q| q.rate(i))] }).collect();
        let speed = D1 { re: seen.orbit.speed, eps: [by_speed] };
        let now = Instant { q: &q, v: &v, a: &accel, z: &z, phase: seen.turns as f64 * seen.tau, speed };
        let [a, b] = self.measure.at(system, &params, &now);
        let [a, b] = match self.measure {
            Measure::Probe(k) if !seen.orbit.rest.is_empty() => {
                let probe = &system.probes()[k];
                let [x, y] = self.rest_slope(seen.orbit.speed, by_speed, parameter, &|q| probe.of(q));
                let place = seen.orbit.rest_seen(probe);
                [a - D1 { re: place[0], eps: [x] }, b - D1 { re: place[1], eps: [y] }]
            }
            _ => [a, b],
        };
        let size = c(a.re, b.re).abs();
        Sloped { size, slope: (a.re * a.eps[0] + b.re * b.eps[0]) / size, pair: [a.eps[0], b.eps[0]] }
    }

    /// How the place of rest of a pair moves with the speed (at this rate) or a parameter, by differences of fourth order; NaN where
    /// there is no rest beside it. It moves with neither where only unknowns do.
    fn rest_slope(&self, speed: f64, by_speed: f64, parameter: Option<Parameter>, seen: &dyn Fn(&[f64]) -> [f64; 2]) -> [f64; 2] {
        let system = self.balance.system;
        let at = |e: f64| -> Option<[f64; 2]> {
            let q = match parameter {
                None => rest(system, speed + e).ok()?.q,
                Some(p) => {
                    let slots = &system.param_slots()[p.first..p.first + p.count];
                    let values: Vec<(&str, f64)> =
                        slots.iter().zip(&system.params()[p.first..]).map(|(s, v)| (s.name.as_str(), v + e)).collect();
                    rest(&system.with(&values).ok()?, speed).ok()?.q
                }
            };
            Some(seen(&q))
        };
        let size = match parameter {
            None if by_speed == 0.0 => return [0.0; 2],
            None => speed.abs(),
            Some(p) => system.params()[p.first].abs(),
        };
        let h = REST_STEP * if size > 0.0 { size } else { 1.0 };
        let slope = || {
            let [a, b, c, d] = [at(-2.0 * h)?, at(-h)?, at(h)?, at(2.0 * h)?];
            Some([0, 1].map(|i| (a[i] - 8.0 * b[i] + 8.0 * c[i] - d[i]) / (12.0 * h)))
        };
        // a parameter that nothing at rest depends on may stand at the end of its range
        let rate = if parameter.is_some() { 1.0 } else { by_speed };
        slope().or_else(|| at(h).zip(at(0.0)).filter(|(a, b)| a == b).map(|_| [0.0; 2])).map_or([f64::NAN; 2], |s| s.map(|s| s * rate))
    }
}

/// The size of a measure, its derivative, and the derivatives of both components.
struct Sloped {
    size: f64,
    slope: f64,
    pair: [f64; 2],
}

impl Local {
    /// The arclength along the tangent in which the measured pair changes by itself.
    fn reach(&self, t: &[f64]) -> f64 {
        self.value / dot(&self.pair[0], t).hypot(dot(&self.pair[1], t))
    }
}

/// A motion at the instant that counts.
struct Seen<'o> {
    orbit: &'o Orbit,
    turns: usize,
    tau: f64,
}

/// Factors J, its rows weighted to size one, bordered by the tangent, which is found on the way; the weights.
fn border(j: &Mat, t: &mut Vec<f64>) -> Option<(Lu, Vec<f64>)> {
    let n = j.rows();
    let rows: Vec<f64> = (0..n).map(|i| 1.0 / norm(j.row(i))).collect();
    let mut full = Mat::zeros(n + 1, n + 1);
    for i in 0..n {
        for (f, x) in full.row_mut(i).iter_mut().zip(j.row(i)) {
            *f = rows[i] * x;
        }
    }
    let mut lu = Lu::default();
    for _ in 0..3 {
        let length = norm(t);
        if !(length > 0.0 && length.is_finite()) {
            return None;
        }
        t.iter_mut().for_each(|t| *t /= length);
        full.row_mut(n).copy_from_slice(t);
        lu.factor(&full).ok()?;
        let mut next = vec![0.0; n + 1];
        next[n] = 1.0;
        lu.solve(&mut next);
        *t = next;
    }
    let length = norm(t);
    t.iter_mut().for_each(|t| *t /= length);
    full.row_mut(n).copy_from_slice(t);
    lu.factor(&full).ok()?;
    Some((lu, rows))
}

/// l with `l^T J = dphi/dy` but for what dphi/dy has along the tangent.
fn adjoint(local: &Local, t: &[f64], rows: &[f64]) -> Option<Vec<f64>> {
    let n = rows.len();
    let transposed = Mat::from_fn(n + 1, n + 1, |i, k| if k < n { rows[k] * local.j[(k, i)] } else { t[i] });
    let mut l = local.phi.clone();
    Lu::new(&transposed).ok()?.solve(&mut l);
    l.truncate(n);
    l.iter_mut().zip(rows).for_each(|(l, w)| *l *= w);
    l.iter().all(|l| l.is_finite()).then_some(l)
}
