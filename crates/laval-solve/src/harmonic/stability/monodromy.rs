//! The map of small disturbances over a period, or over the part of it that a symmetry repeats.
//!
//! `Y' = A(t) Y` from the identity: as a product of equal steps where the law is smooth (`super::product`), else by adaptive integration of order 8 from one switch of a law to the next: between them A is smooth. Where a force is
//! continuous at a switch, so is Y; where it jumps the map would need the jump of Y as well, and none is given.

use crate::harmonic::balance::first_order::first_order;
use crate::harmonic::balance::fourier::{motion_at, turns};
use crate::harmonic::balance::orbit::Orbit;
use crate::harmonic::balance::problem::Balance;
use crate::harmonic::stability::floquet::{Block, Exponents, Method, Stability, Unassessed, balance_scale, rounding};
use crate::model::part::At;
use laval_num::dense::Mat;
use laval_num::ode::{Control, Dop853, End, Ode, Tolerance, integrate, ode};
use laval_num::order::ascending;
use laval_num::work::spend;
use std::cell::Cell;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::sync::atomic::{AtomicBool, Ordering};

/// Tolerance of the integration, where no other is requested.
pub(super) const TOLERANCE: f64 = 1e-10;

/// Part of the period by which an instant on a switch is moved inside the part that is integrated.
const INSIDE: f64 = 1e-11;

/// The part between two switches that is integrated.
struct Window<'a> {
    ends: Cell<(f64, f64)>,
    tolerance: f64,
    cancel: Option<&'a AtomicBool>,
}

impl<'a> Window<'a> {
    fn new(tolerance: f64, cancel: Option<&'a AtomicBool>) -> Self {
        Window { ends: Cell::default(), tolerance, cancel }
    }

    /// The instant `t`, not on the switch itself, where either law might answer.
    fn inside(&self, t: f64) -> f64 {
        let (from, to) = self.ends.get();
        t.max(from).min(to)
    }

    /// From 0 through all `breaks`; the number of steps, taken from those `left`.
    fn integrate<P: Ode>(
        &self,
        dop: &mut Dop853,
        problem: &mut P,
        y: &mut [f64],
        breaks: &[f64],
        left: &mut u64,
    ) -> Result<u64, Unassessed> {
        let (mut from, mut steps) = (0.0, 0);
        let margin = INSIDE * breaks.last().copied().unwrap_or(0.0);
        for &to in breaks {
            self.ends.set((from + margin, to - margin));
            let all = || Tolerance::All(self.tolerance);
            let stopped = || self.cancel.is_some_and(|c| c.load(Ordering::Relaxed));
            let control = Control { max_steps: *left, cancel: Some(&stopped), ..Control::new(all(), all()) };
            let run = integrate(dop, problem, from, y, to, &control, &mut ());
            let spent = run.work.steps + run.work.rejected;
            steps += spent;
            *left = left.saturating_sub(spent);
            match run.end {
                End::Reached => from = to,
                End::WorkLimit { .. } => {
                    return Err(Unassessed::Failed("the maps over the period took more steps than a response is given".into()));
                }
                End::StepTooSmall { .. } => {
                    return Err(Unassessed::Failed("a force changes too abruptly for the map over the period to be integrated".into()));
                }
                End::Failed { what, .. } => {
                    return Err(Unassessed::Failed(format!("the map over the period could not be integrated: {what}")));
                }
                _ => return Err(Unassessed::Failed("the map over the period ended early".into())),
            }
        }
        Ok(steps)
    }
}

/// Ends of the parts of `0..period` between switches, ascending.
fn breaks(balance: &mut Balance, x: &[f64], speed: f64, parts: usize, period: f64) -> Result<Vec<f64>, Unassessed> {
    if parts == 0 {
        return Ok(vec![period]);
    }
    let (length, forward) = (TAU / parts as f64, balance.pace(speed).frequency > 0.0);
    let (places, jumps) = balance.switches(x, speed, (if forward { 0.0 } else { -length }, length));
    if let Some(part) = jumps {
        return Err(Unassessed::Jumps(part));
    }
    let mut at: Vec<f64> = places.into_iter().map(|tau| tau.abs() / length * period).chain([period]).collect();
    ascending(&mut at);
    let least = 4.0 * INSIDE * period;
    at.dedup_by(|b, a| *b - *a <= least);
    at.retain(|t| *t > least);
    match at.last_mut() {
        Some(last) => *last = period,
        None => at.push(period),
    }
    Ok(at)
}

impl Stability {
    /// The map over the repeated part of the period, block by block; of all states together where a law `switches`.
    pub(super) fn map(&mut self, balance: &mut Balance, x: &[f64], speed: f64, switches: bool) -> Result<Exponents, Unassessed> {
        let terms = &balance.terms;
        let blocks = self.blocks(balance, switches);
        // a turn by a quarter mixes x and y: with blocks apart the half turn keeps them apart
        // and coordinates of a reduced machine do not turn in pairs: all of them change their sign in half a turn
        let vectors = |c: &crate::model::system::GlobalDof| c.dof.kind.leads_pair() || c.dof.kind.ends_pair();
        let signs = balance.system.coordinates().iter().chain(balance.system.states()).all(vectors);
        let parts = match terms.symmetry.order() {
            order if self.reduction().is_some() => order.min(if signs { 2 } else { 1 }),
            order if blocks.len() > 1 => order.min(2),
            order => order,
        };
        let pace = balance.pace(speed);
        let base = pace.frequency.abs();
        let period = TAU / base / parts as f64;
        let direction = pace.frequency.signum();
        let product = if switches || self.adaptive { None } else { self.product(balance, x, speed, &blocks, (parts, period)) };
        let (maps, steps) = match product {
            Some(found) => found,
            None => self.integrated(balance, x, speed, &blocks, (parts, period))?,
        };
        // turned back by the symmetry: a half turn changes the sign of pairs, a quarter turns them (against the spin for nu = 3 mod 4)
        let angle = match parts {
            2 => PI,
            4 => quarter(balance.terms.divisor) * direction,
            _ => 0.0,
        };
        let mut values = Vec::new();
        for (block, map) in blocks.iter().zip(&maps) {
            let map = self.turned_back(&block.states, map, angle);
            for z in self.eigenvalues(&map)? {
                values.push(z.ln().scale(1.0 / period));
            }
        }
        Ok(Exponents { values, error: self.tolerance * steps.max(1) as f64 / period, method: Method::Map, span: period })
    }

    /// Maps of the blocks over the base phase `TAU / parts`, which takes `period` seconds, by adapted steps from one switch of a law to the next; and the number of steps.
    fn integrated(
        &mut self,
        balance: &mut Balance,
        x: &[f64],
        speed: f64,
        blocks: &[Block],
        (parts, period): (usize, f64),
    ) -> Result<(Vec<Mat>, u64), Unassessed> {
        let pace = balance.pace(speed);
        let (base, direction) = (pace.frequency.abs(), pace.frequency.signum());
        let breaks = breaks(balance, x, speed, parts, period)?;
        let terms = &balance.terms;
        let window = Window::new(self.tolerance, balance.cancel);
        let (mut motion, mut turned) = ([0; 3].map(|_| vec![0.0; terms.coordinates]), Vec::new());
        let mut y: Vec<f64> = Vec::new();
        for block in blocks {
            y.extend(Mat::<f64>::identity(block.states.len()).data());
        }
        let mut a = Vec::new();
        let mut sampled = std::mem::take(&mut self.sampled);
        let mut dop = std::mem::replace(&mut self.dop, Dop853::new());
        let (system, members) = (balance.system, &balance.nonlinear.members);
        let mut problem = ode(y.len(), |t, y, dy| {
            let tau = base * window.inside(t) * direction;
            spend((y.len() * y.len().isqrt() + 10 * terms.coordinates * terms.harmonics) as u64);
            turns(tau, terms.harmonics, &mut turned);
            motion_at(terms, x, pace.frequency, &turned, &mut motion);
            let [u, v, w] = &motion;
            sampled.eval_at(system, members, terms, tau, [u, v, w], pace, true);
            let mut offset = 0;
            for block in blocks {
                let d = block.states.len();
                a.clear();
                a.extend_from_slice(&block.constant);
                for e in &block.entries {
                    a[e.row * d + e.col] += e.factor * sampled.tangent(e.derivative)[(e.j, e.k)];
                }
                let y = &y[offset..offset + d * d];
                for (row, out) in a.chunks_exact(d).zip(dy[offset..offset + d * d].chunks_exact_mut(d)) {
                    out.fill(0.0);
                    for (&factor, y) in row.iter().zip(y.chunks_exact(d)) {
                        if factor != 0.0 {
                            for (o, &y) in out.iter_mut().zip(y) {
                                *o += factor * y;
                            }
                        }
                    }
                }
                offset += d * d;
            }
        });
        let run = window.integrate(&mut dop, &mut problem, &mut y, &breaks, &mut self.steps_left);
        self.sampled = sampled;
        self.dop = dop;
        let steps = run?;
        let mut maps = Vec::with_capacity(blocks.len());
        let mut offset = 0;
        for block in blocks {
            let d = block.states.len();
            maps.push(Mat::from_fn(d, d, |i, j| y[offset + i * d + j]));
            offset += d * d;
        }
        Ok((maps, steps))
    }

    fn turned_back(&self, block: &[usize], map: &Mat, angle: f64) -> Mat {
        let (s, co) = if angle == PI { (0.0, -1.0) } else { angle.sin_cos() };
        let mut out = map.clone();
        if self.reduction().is_some() && angle == PI {
            out.data_mut().iter_mut().for_each(|x| *x = -*x);
            return out;
        }
        for (i, &state) in block.iter().enumerate() {
            let second = state > 0 && self.pairs[state - 1];
            if !(self.pairs[state] || second) {
                continue;
            }
            let partner = block.iter().position(|&b| b == if second { state - 1 } else { state + 1 });
            for j in 0..block.len() {
                // turning back: x cos + y sin, y cos - x sin
                let other = partner.map_or(0.0, |p| map[(p, j)]) * if second { -s } else { s };
                out[(i, j)] = co * map[(i, j)] + other;
            }
        }
        out
    }

    /// Configuration-dependent mass, or states in nonlinear parts: everything differentiated along the motion.
    pub(super) fn general(&mut self, balance: &mut Balance, x: &[f64], speed: f64) -> Result<Exponents, Unassessed> {
        let parts = balance.terms.symmetry.order();
        let pace = balance.pace(speed);
        let period = TAU / pace.frequency.abs() / parts.max(1) as f64;
        let breaks = breaks(balance, x, speed, parts, period)?;
        let window = Window::new(self.tolerance, balance.cancel);
        let orbit = Orbit::of(balance, x, speed).map_err(|e| Unassessed::Failed(e.to_string()))?;
        let system = balance.system;
        let (n, m) = (self.n, self.m);
        let states = self.pairs.len();
        let orders = self.orders.clone();
        let terms = &balance.terms;
        let direction = pace.frequency.signum();
        let (mut q, mut v, mut acc, mut z) = (vec![0.0; n], vec![0.0; n], vec![0.0; n], vec![0.0; m]);
        let mut tangent = std::mem::take(&mut self.tangent);
        let mut scratch = std::mem::take(&mut self.scratch);
        let base = orbit.frequency.abs();
        let mut matrix = |t: f64| -> Result<Mat, Unassessed> {
            let tau = base * t * direction;
            orbit.at(tau, &mut q, &mut v, &mut acc, &mut z);
            let at = At { q: &q, v: &v, a: &acc, z: &z, phase: terms.divisor as f64 * tau, speed, spin_accel: 0.0, t };
            system.tangent(&at, false, &mut tangent, &mut scratch, |_| true);
            let of_states = orders.as_ref().map_or_else(|| first_order(&tangent), |o| o.over_states(&tangent));
            of_states.ok_or(Unassessed::Massless)
        };
        let mut a0 = matrix(0.0)?;
        if self.scale.is_empty() {
            self.scale = balance_scale(&a0, &self.pairs);
        }
        let scale = self.scale.clone();
        let scaled = |a: &mut Mat| {
            for i in 0..states {
                for j in 0..states {
                    a[(i, j)] *= scale[j] / scale[i];
                }
            }
        };
        scaled(&mut a0);
        if parts == 0 {
            for (i, _) in self.pairs.iter().enumerate().filter(|(_, p)| **p) {
                a0[(i, i + 1)] += pace.frequency * terms.divisor as f64;
                a0[(i + 1, i)] -= pace.frequency * terms.divisor as f64;
            }
            self.tangent = tangent;
            self.scratch = scratch;
            let values = self.eigenvalues(&a0)?;
            return Ok(Exponents { values, error: rounding(&a0), method: Method::Rotating, span: 0.0 });
        }
        let mut y = Mat::<f64>::identity(states).data().to_vec();
        let mut failure = None;
        let mut problem = ode(y.len(), |t, y, dy| {
            spend((states * states * states) as u64);
            let mut a = match matrix(window.inside(t)) {
                Ok(a) => a,
                Err(e) => {
                    failure = Some(e);
                    dy.fill(f64::NAN);
                    return;
                }
            };
            scaled(&mut a);
            for i in 0..states {
                let out = &mut dy[i * states..(i + 1) * states];
                out.fill(0.0);
                for k in 0..states {
                    for (o, &y) in out.iter_mut().zip(&y[k * states..(k + 1) * states]) {
                        *o += a[(i, k)] * y;
                    }
                }
            }
        });
        let run = window.integrate(&mut self.dop, &mut problem, &mut y, &breaks, &mut self.steps_left);
        self.tangent = tangent;
        self.scratch = scratch;
        if let Some(failure) = failure {
            return Err(failure);
        }
        let steps = run?;
        let angle = match parts {
            2 => PI,
            4 => quarter(terms.divisor) * direction,
            _ => 0.0,
        };
        let all: Vec<usize> = (0..states).collect();
        let map = self.turned_back(&all, &Mat::from_fn(states, states, |i, j| y[i * states + j]), angle);
        let values = self.eigenvalues(&map)?.into_iter().map(|z| z.ln().scale(1.0 / period)).collect();
        Ok(Exponents { values, error: self.tolerance * steps.max(1) as f64 / period, method: Method::Map, span: period })
    }
}

/// Angle by which a quarter of the base period turns the motion.
fn quarter(divisor: usize) -> f64 {
    if divisor % 4 == 3 { -FRAC_PI_2 } else { FRAC_PI_2 }
}
