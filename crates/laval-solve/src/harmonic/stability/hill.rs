//! Hill's method without sorting: the map over a period from the Fourier coefficients of A(t).
//!
//! A disturbance obeys `y' = sum_j A_j exp(i j w t) y`. The lifted quantities `z_k = exp(i k w t) y` obey equations with constant coefficients,
//!
//! ```text
//! z_k' = i k w z_k + sum_j A_j z_(k+j),      z_k(0) = y(0) for every k,      y(T) = z_0(T)
//! ```
//!
//! so that `Phi(T) = C exp(H T) W` with Hill's infinite matrix H, W = (I, I, ...) and C picking `z_0`: a projection of all of H that needs no choice among
//! its eigenvalues. H is cut off at |k| <= N, the exponential is summed as Taylor series on parts of the period, and N is raised until the exponents
//! settle. `z_(-k)` is the conjugate of `z_k`.
//!
//! Theory: `docs/theory/harmonic-balance.md#stability`.
//!
//! Source: F. Bayer, R. I. Leine, Sorting-free Hill-based stability analysis of periodic solutions through Koopman analysis, Nonlinear Dynamics 111 (2023).

use crate::harmonic::balance::problem::Balance;
use crate::harmonic::stability::floquet::{Exponents, Method, Stability, Unassessed};
use crate::symmetry::Symmetry;
use laval_num::complex::{C64, c};
use laval_num::dense::Mat;
use laval_num::order::SortByNumber;
use std::f64::consts::TAU;

/// Coefficients of A below this part of the largest are left out.
const SMALL: f64 = 1e-14;

/// The most orders of the lifted equations.
const MOST_ORDERS: usize = 96;

/// The most products of entries of H with columns, steps times terms, that an exponential may take: some seconds.
const MOST_WORK: f64 = 1e8;

/// Exponents have settled when growth rates change by no more than this part of the base frequency.
const SETTLED: f64 = 1e-9;

/// Entries of A at one order: row, column, value.
type Entries = Vec<(usize, usize, C64)>;

/// Exponents of the motion last sampled; its balance must hold the whole period ([`Symmetry::None`]).
pub fn exponents(stability: &mut Stability, balance: &mut Balance, x: &[f64], speed: f64) -> Result<Exponents, Unassessed> {
    if !stability.constant_mass {
        return Err(Unassessed::Failed("Hill's method is for machines whose nonlinear parts have neither mass nor states".into()));
    }
    if balance.terms.symmetry != Symmetry::None || !balance.switches(x, speed, (0.0, TAU)).0.is_empty() {
        return Err(Unassessed::Failed("Hill's method is for motions along which no law switches".into()));
    }
    stability.set_speed(balance, speed)?;
    let coefficients = coefficients(stability, balance);
    let base = speed.abs() / balance.terms.divisor as f64;
    // at negative speeds the base phase runs backwards
    let lifted = Lifted { d: stability.constant.rows(), base, forward: speed > 0.0, coefficients };
    let period = TAU / base;
    let mut before: Option<Vec<C64>> = None;
    let mut orders = 12;
    let mut change = f64::INFINITY;
    while orders <= MOST_ORDERS {
        let map = lifted.map(orders, period)?;
        let mut values: Vec<C64> = stability.eigenvalues(&map)?.into_iter().map(|z| z.ln().scale(1.0 / period)).collect();
        values.sort_by_number_down(|a| a.re);
        if let Some(before) = &before {
            change = (values[0].re - before[0].re).abs();
            if change <= SETTLED * base {
                return Ok(Exponents { values, error: change.max(1e-13 * base), method: Method::Map, span: period });
            }
        }
        before = Some(values);
        orders += orders / 2;
    }
    Err(Unassessed::Failed(format!(
        "Hill's method did not settle with {MOST_ORDERS} orders: growth rates still change by {change:.1e} 1/s"
    )))
}

/// Fourier coefficients of A for orders from 0 up: all of the constant part, and what the nonlinear coordinates add.
fn coefficients(stability: &Stability, balance: &Balance) -> Vec<Entries> {
    let (count, mu) = (balance.terms.samples, balance.terms.coordinates);
    let d = stability.constant.rows();
    let mut all: Vec<Mat<C64>> = Vec::new();
    for k in 0..=(count - 1) / 2 {
        let mut a = Mat::from_fn(d, d, |i, j| c(if k == 0 { stability.constant[(i, j)] } else { 0.0 }, 0.0));
        for e in &stability.entries {
            let tangent = balance.sampled.tangent(e.derivative);
            let sum = (0..count).fold(C64::zero(), |sum, s| {
                let step = (k * s) % count;
                sum + C64::cis(-TAU * step as f64 / count as f64).scale(tangent[(s * mu + e.j, e.k)])
            });
            a[(e.row, e.col)] += sum.scale(e.factor / count as f64);
        }
        all.push(a);
    }
    let largest = all.iter().flat_map(|a| a.data()).map(|z| z.abs()).fold(0.0, f64::max);
    let mut out: Vec<Entries> = all
        .iter()
        .map(|a| {
            let places = (0..d).flat_map(|i| (0..d).map(move |j| (i, j)));
            places.map(|(i, j)| (i, j, a[(i, j)])).filter(|e| e.2.abs() > SMALL * largest).collect()
        })
        .collect();
    while out.len() > 1 && out.last().is_some_and(Vec::is_empty) {
        out.pop();
    }
    out
}

struct Lifted {
    d: usize,
    base: f64,
    forward: bool,
    coefficients: Vec<Entries>,
}

impl Lifted {
    /// The spacing of the orders that couple.
    fn spacing(&self) -> usize {
        let gcd = |mut a: usize, mut b: usize| {
            while b != 0 {
                (a, b) = (b, a % b);
            }
            a
        };
        let used = self.coefficients.iter().enumerate().skip(1).filter(|(_, e)| !e.is_empty());
        used.fold(0, |g, (k, _)| gcd(g, k)).max(1)
    }

    /// `C exp(H T) W` with orders up to `orders` times the spacing.
    fn map(&self, orders: usize, period: f64) -> Result<Mat, Unassessed> {
        let (d, g) = (self.d, self.spacing());
        let size = d * d;
        let row_sum = |e: &Entries| {
            let mut rows = vec![0.0; d];
            e.iter().for_each(|&(i, _, z)| rows[i] += z.abs());
            rows.into_iter().fold(0.0, f64::max)
        };
        let coupling: f64 = self.coefficients.iter().enumerate().map(|(k, e)| if k == 0 { 1.0 } else { 2.0 } * row_sum(e)).sum();
        let norm = (orders * g) as f64 * self.base + coupling;
        let parts = (norm * period / 4.0).ceil().max(1.0);
        let entries: usize = self.coefficients.iter().map(Vec::len).sum();
        let work = parts * ((orders + 1) * entries * d) as f64;
        if !(work <= MOST_WORK) {
            return Err(Unassessed::Failed(format!(
                "Hill's method would need {parts:.0} steps per period with {orders} orders: the machine is too stiff for it"
            )));
        }
        let h = period / parts;
        let mut z = vec![C64::zero(); (orders + 1) * size];
        for k in 0..=orders {
            for i in 0..d {
                z[k * size + i * d + i] = C64::one();
            }
        }
        let (mut term, mut next) = (z.clone(), z.clone());
        for _ in 0..parts as usize {
            term.copy_from_slice(&z);
            for n in 1..60 {
                self.apply(orders, g, &term, &mut next);
                let mut largest = 0.0f64;
                for ((t, x), z) in term.iter_mut().zip(&next).zip(z.iter_mut()) {
                    *t = x.scale(h / n as f64);
                    *z += *t;
                    largest = largest.max(t.norm_sqr());
                }
                if largest.sqrt() <= 1e-17 {
                    break;
                }
            }
        }
        Ok(Mat::from_fn(d, d, |i, j| z[i * d + j].re))
    }

    /// `out = H z`, orders from 0 up; `z_(-k)` is the conjugate.
    fn apply(&self, orders: usize, g: usize, z: &[C64], out: &mut [C64]) {
        let (d, size) = (self.d, self.d * self.d);
        for k in 0..=orders {
            let own = c(0.0, (k * g) as f64 * self.base);
            let target = &mut out[k * size..(k + 1) * size];
            for (o, z) in target.iter_mut().zip(&z[k * size..]) {
                *o = own * *z;
            }
            for j in (0..self.coefficients.len()).step_by(g) {
                let entries = &self.coefficients[j];
                let shifts = [(j / g) as isize, -((j / g) as isize)];
                for shift in &shifts[..if j == 0 { 1 } else { 2 }] {
                    let from = k as isize + shift;
                    if from.unsigned_abs() > orders {
                        continue;
                    }
                    let conjugated = (*shift < 0) == self.forward && j > 0;
                    let source = &z[from.unsigned_abs() * size..][..size];
                    for &(row, column, value) in entries {
                        let value = if conjugated { value.conj() } else { value };
                        let target = &mut target[row * d..(row + 1) * d];
                        for (o, z) in target.iter_mut().zip(&source[column * d..]) {
                            *o += value * if from < 0 { z.conj() } else { *z };
                        }
                    }
                }
            }
        }
    }
}
