//! Loci on which states change their stability away from folds: Neimark-Sacker, period doubling, symmetry breaking.
//!
//! ```text
//! r(x, W, q) = 0,    a(x, W, q) T = 0,    arg(x, W, q) - theta = 0
//! ```
//!
//! with a the growth rate and arg the angle of the Floquet multiplier over T, the part of the period that the symmetry of the motion repeats, and theta an
//! unknown that tells which multiplier is meant: the one nearest to `exp(i theta)`. Of a real multiplier theta is known and the last equation is left out.
//!
//! The gradient of growth and angle is had by differences in three directions instead of all: two tangents of the surface r = 0, and the shortest way back onto it.
//! Newton's step has no part in any other.

use crate::harmonic::balance::problem::Balance;
use crate::harmonic::loci::folds::scaled;
use crate::harmonic::loci::varied::{Varied, linearised};
use crate::harmonic::stability::floquet::{Exponents, Stability};
use crate::symmetry::Symmetry;
use laval_num::complex::C64;
use laval_num::continuation::{Failure, Zero};
use laval_num::dense::{Mat, dot, norm};
use std::f64::consts::{PI, TAU};

/// Tolerance of the maps over the period.
pub(super) const TOLERANCE: f64 = 1e-12;

/// Step of differences of exponents, in scaled unknowns: their error is that of an integration.
const STEP: f64 = 1e-5;

/// Changes of stability. Unknowns: n harmonics, the speed and, of a pair of multipliers, its angle, rad.
pub struct CrossingLocus<'a> {
    /// The machine.
    pub varied: Varied<'a>,
    /// Angle of a real multiplier, 0 or pi; `None` of a pair.
    pub real: Option<f64>,
}

/// Exponents of a motion by the method that fits all of a locus.
pub(super) fn exponents(balance: &mut Balance, x: &[f64], speed: f64) -> Result<Exponents, Failure> {
    const UNASSESSED: Failure = Failure::Undefined("the stability of the motion cannot be assessed there");
    let mut assessor = Stability::new(balance.system).map_err(|_| UNASSESSED)?.with_tolerance(TOLERANCE);
    balance.sample(x, speed);
    let circular = balance.terms.symmetry == Symmetry::Circular;
    if circular { assessor.exponents(balance, x, speed) } else { assessor.mapped(balance, x, speed) }.map_err(|_| UNASSESSED)
}

/// Time over which an exponent's multiplier is taken, s.
pub(super) fn span(exponents: &Exponents, speed: f64) -> f64 {
    if exponents.span > 0.0 { exponents.span } else { TAU / speed.abs() }
}

/// Angle of the multiplier of an exponent, rad, of a pair the positive one.
pub(super) fn angle(exponent: C64, exponents: &Exponents, speed: f64) -> f64 {
    let turned = (exponent.im * span(exponents, speed)).abs();
    // constant coefficients leave no choice among aliases
    if exponents.span == 0.0 {
        return turned;
    }
    let turned = turned.rem_euclid(TAU);
    if turned > PI { TAU - turned } else { turned }
}

/// The exponent whose multiplier is nearest to `exp(i theta)`: its index.
pub(super) fn nearest(exponents: &Exponents, speed: f64, theta: f64) -> Option<usize> {
    let time = span(exponents, speed);
    let distance = |z: &C64| (z.re * time).hypot(angle(*z, exponents, speed) - theta);
    (0..exponents.values.len()).min_by(|&a, &b| distance(&exponents.values[a]).total_cmp(&distance(&exponents.values[b])))
}

/// Growth over the span and angle of the multiplier that is meant.
fn seen(balance: &mut Balance, x: &[f64], speed: f64, theta: f64) -> Result<[f64; 2], Failure> {
    let all = exponents(balance, x, speed)?;
    let which = nearest(&all, speed, theta).ok_or(Failure::Undefined("the motion has no exponents"))?;
    let z = all.values[which];
    Ok([z.re * span(&all, speed), angle(z, &all, speed)])
}

impl CrossingLocus<'_> {
    /// Number of unknowns of the motion alone.
    pub fn size(&self) -> usize {
        self.varied.terms().unknowns
    }
    /// Angle of the multiplier at these unknowns, rad.
    pub fn theta(&self, y: &[f64]) -> f64 {
        self.real.unwrap_or_else(|| y[self.size() + 1])
    }

    /// Derivatives of growth and angle along a direction in scaled (x, speed, parameter).
    fn along(&mut self, at: &[f64], theta: f64, own: [f64; 2], direction: &[f64]) -> Result<[f64; 2], Failure> {
        let n = self.size();
        let h = STEP * norm(at).max(1.0);
        let mut side = |h: f64| {
            let y: Vec<f64> = at.iter().zip(direction).map(|(y, t)| y + h * t).collect();
            let x: Vec<f64> = y[..n].iter().zip(self.varied.scales()).map(|(y, s)| y * s).collect();
            let (speed, value) = (y[n] * self.varied.speed_scale(), y[n + 1] * self.varied.value_scale());
            self.varied.at(value, |balance| seen(balance, &x, speed, theta))
        };
        let difference = |a: [f64; 2], b: [f64; 2], h: f64| [(a[0] - b[0]) / h, (a[1] - b[1]) / h];
        match (side(h), side(-h)) {
            (Err(Failure::Cancelled), _) | (_, Err(Failure::Cancelled)) => Err(Failure::Cancelled),
            (Ok(a), Ok(b)) => Ok(difference(a, b, 2.0 * h)),
            (Ok(a), Err(_)) => Ok(difference(a, own, h)),
            (Err(_), b) => Ok(difference(own, b?, h)),
        }
    }
}

/// Two unit vectors normal to each other and to the rows of a matrix with two columns more than rows, and the shortest solution of `rows d = -r`.
pub fn plane(rows: &Mat, r: &[f64]) -> Option<([Vec<f64>; 2], Vec<f64>)> {
    let m = rows.cols();
    let mut basis: Vec<Vec<f64>> = Vec::with_capacity(m);
    // takes its parts along the basis off a vector and gives them
    let reduce = |basis: &[Vec<f64>], v: &mut Vec<f64>| {
        let mut parts = vec![0.0; basis.len()];
        for _ in 0..2 {
            for (b, part) in basis.iter().zip(&mut parts) {
                let c = dot(b, v);
                v.iter_mut().zip(b).for_each(|(v, b)| *v -= c * b);
                *part += c;
            }
        }
        parts
    };
    let mut back: Vec<f64> = Vec::with_capacity(rows.rows());
    for i in 0..rows.rows() {
        let mut v = rows.row(i).to_vec();
        let size = norm(&v);
        v.iter_mut().for_each(|v| *v /= size);
        let parts = reduce(&basis, &mut v);
        let rest = norm(&v);
        if !(rest > 1e-13) {
            return None;
        }
        v.iter_mut().for_each(|v| *v /= rest);
        back.push((-r[i] / size - dot(&parts, &back)) / rest);
        basis.push(v);
    }
    let mut shortest = vec![0.0; m];
    for (c, b) in back.iter().zip(&basis) {
        shortest.iter_mut().zip(b).for_each(|(d, b)| *d += c * b);
    }
    let mut out: Vec<Vec<f64>> = Vec::with_capacity(2);
    for _ in 0..2 {
        // the unit vector with the longest rest
        let rest = |j: usize| basis.iter().map(|b| b[j] * b[j]).sum::<f64>();
        let j = (0..m).min_by(|&a, &b| rest(a).total_cmp(&rest(b)))?;
        let mut v = vec![0.0; m];
        v[j] = 1.0;
        reduce(&basis, &mut v);
        let size = norm(&v);
        v.iter_mut().for_each(|v| *v /= size);
        basis.push(v.clone());
        out.push(v);
    }
    Some((out.try_into().ok()?, shortest))
}

impl Zero for CrossingLocus<'_> {
    fn dim(&self) -> usize {
        self.size() + if self.real.is_some() { 1 } else { 2 }
    }
    fn scale(&self, out: &mut [f64]) {
        let n = self.size();
        out[..n].copy_from_slice(self.varied.scales());
        out[n] = self.varied.speed_scale();
        out[n + 1..].fill(1.0);
    }
    fn parameter_scale(&self) -> f64 {
        self.varied.value_scale()
    }
    fn eval(&mut self, y: &[f64], q: f64, r: &mut [f64], jac: Option<&mut Mat>, dr_dq: Option<&mut [f64]>) -> Result<(), Failure> {
        let n = self.size();
        let (x, speed, theta) = (&y[..n], y[n], self.theta(y));
        if self.varied.beyond(speed) {
            return Err(Failure::Undefined("the locus leaves the range of speeds"));
        }
        let pair = self.real.is_none();
        let ((residual, a, by_speed), own) =
            self.varied.at(q, |balance| Ok((linearised(balance, x, speed)?, seen(balance, x, speed, theta)?)))?;
        r[..n].copy_from_slice(&residual);
        r[n] = own[0];
        if pair {
            r[n + 1] = own[1] - theta;
        }
        if jac.is_none() && dr_dq.is_none() {
            return Ok(());
        }
        let by_value = self.varied.slope(q, &|balance| Ok(linearised(balance, x, speed)?.0))?;
        let (scale, speed_scale, value_scale) = (self.varied.scales().to_vec(), self.varied.speed_scale(), self.varied.value_scale());
        let mut rows = Mat::from_fn(n, n + 2, |i, j| match j {
            j if j < n => a[(i, j)],
            j if j == n => by_speed[i],
            _ => by_value[i],
        });
        let sizes: Vec<f64> = scale.iter().copied().chain([speed_scale, value_scale]).collect();
        scaled(&mut rows, &sizes);
        let (tangents, mut back) = plane(&rows, &residual).ok_or(Failure::Undefined("the states do not form a surface there"))?;
        let at: Vec<f64> = x.iter().copied().chain([speed, q]).zip(&sizes).map(|(y, s)| y / s).collect();
        let mut gradient = [vec![0.0; n + 2], vec![0.0; n + 2]];
        let way = norm(&back);
        let off = way > 1e-9 * norm(&at).max(1.0);
        back.iter_mut().for_each(|b| *b /= way);
        for t in tangents.iter().chain(off.then_some(&back)) {
            let slopes = self.along(&at, theta, own, t)?;
            for (g, slope) in gradient.iter_mut().zip(slopes) {
                for ((g, t), s) in g.iter_mut().zip(t).zip(&sizes) {
                    *g += slope * t / s;
                }
            }
        }
        if let Some(jac) = jac {
            for i in 0..n {
                jac.row_mut(i)[..n].copy_from_slice(a.row(i));
                jac[(i, n)] = by_speed[i];
            }
            jac.row_mut(n)[..=n].copy_from_slice(&gradient[0][..=n]);
            if pair {
                jac.row_mut(n + 1)[..=n].copy_from_slice(&gradient[1][..=n]);
                jac[(n + 1, n + 1)] = -1.0;
            }
        }
        if let Some(out) = dr_dq {
            out[..n].copy_from_slice(&by_value);
            out[n] = gradient[0][n + 1];
            if pair {
                out[n + 1] = gradient[1][n + 1];
            }
        }
        Ok(())
    }
    fn cancelled(&self) -> bool {
        self.varied.cancelled()
    }
}
