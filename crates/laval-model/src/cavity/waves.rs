//! Time form of the tilt reaction of an ideal liquid: a finite sum over its waves.
//!
//! In rotor axes the energy of the liquid is positive, so that its waves are the eigenvectors of a symmetric pencil with real frequencies `W x_j`, and the reaction is a sum
//! over them with positive shares:
//!
//! ```text
//! Lt = pi rho { -w (w - 2 W) [R^2 H^3/12 - H (R^4 - r0^4)/4] + 2 R^2 w (w - W) sum c_k - w^2 sum_k sum_j a_j x/(x - x_j) }
//! a_j = c_k (q_j . (2 d + r0^2 e) - r0^2 s_j)^2,   c_k = 8 H^3/(pi k)^4,   x = (w - W)/W
//! A q = x E q:   E = [[T, 0], [0, r0^2]],  A = [[2 C, r0^2 e], [r0^2 e^T, 0]]
//! T = int (u u' + v v' + z z') r dr,   C = int (u v' + v u') r dr,   d = int (u - v) r dr,   e = u(r0)
//! ```
//!
//! over flows `(u, i v, z)` without divergence, `(r u)' + v + kappa r z = 0`, that vanish at the wall, and the surface s. Fields are polynomials in r: the
//! waves that matter converge with the degree, and whatever the degree all frequencies are real and all shares positive, so that nothing grows that does not
//! in the liquid. Waves without number are then taken together with their neighbours: sums of shares and of `a_j x_j` stay, and so do reality and signs. At
//! `w = W` the form is exact whatever it leaves out.
//!
//! What is close to a wave on the real axis cannot be distinguished from afar: the error is that for motions that grow or decay at no less than [`MARGIN`] of the speed.
//!
//! Symbols as in [cavity](super); derived from the equations there.
//!
//! Theory: `docs/theory/liquid-in-three-dimensions.md#time-forms`.

use super::rational::{Rational, Wave};
use super::{Cavity, Truncation};
use laval_num::complex::{C64, c};
use laval_num::dense::Mat;
use laval_num::eig::definite;
use laval_num::order::SortByNumber;
use laval_num::quadrature::gauss;
use std::f64::consts::PI;

/// Growth or decay over the speed from which on the error of the form holds.
pub const MARGIN: f64 = 0.05;
/// Highest frequency in rotor axes over the speed to which it holds.
pub const BAND: f64 = 4.0;
/// Harmonics and degrees that are tried for all harmonics, and degrees for given ones.
const ALL: [(usize, usize); 4] = [(21, 10), (41, 14), (81, 18), (161, 24)];
const DEGREES: [usize; 4] = [10, 16, 24, 32];
/// Highest harmonic whose waves are computed.
pub const MOST_HARMONICS: usize = 161;
/// Most waves a form may have.
pub const MOST_WAVES: usize = 160;
/// Places along the band where the waves are compared with the exact reaction.
const COMPARED: usize = 41;
/// Places where the form is compared with all waves.
const PLACES: usize = 1201;
/// The error between places is no more than this times that at them.
pub(super) const BETWEEN: f64 = 1.5;

/// A time form with its error.
#[derive(Clone, Debug, PartialEq)]
pub struct Fitted {
    /// The form.
    pub form: Rational,
    /// Largest error over `|L| + |L of k = 0|`.
    pub error: f64,
}

/// Waves of some harmonics: frequencies over the speed and shares, ascending, and the sum of `c_k`.
struct Ladder {
    places: Vec<f64>,
    shares: Vec<f64>,
    sum: f64,
}

impl Cavity<f64> {
    /// The tilt reaction as a sum over waves, of which there are as many as the `accuracy` requires; `None` where so many do not reach it. `count` waves at the most.
    pub fn tilt_in_time(&self, truncation: Truncation, accuracy: f64, count: usize) -> Option<Fitted> {
        let levels: Vec<(usize, usize)> = match truncation {
            Truncation::At(last) if last > MOST_HARMONICS => return None,
            Truncation::At(last) => DEGREES.iter().map(|d| (last, *d)).collect(),
            _ => ALL.to_vec(),
        };
        let axis = |n: usize| (0..n).map(move |i| c(BAND * (2.0 * i as f64 / (n - 1) as f64 - 1.0), MARGIN));
        let exact: Vec<(C64, C64)> = axis(COMPARED).map(|x| (x, self.tilt(x + C64::one(), 1.0, truncation).value)).collect();
        for (last, degree) in levels {
            let Some(ladder) = self.ladder(last, degree) else { continue };
            let all = self.summed(&ladder);
            let apart = |x: C64, should: C64, form: &Rational| (form.at(x + C64::one(), 1.0) - should).abs() / self.size(x, should);
            let series = exact.iter().map(|&(x, should)| apart(x, should, &all)).fold(0.0, largest);
            if !(BETWEEN * series <= 0.5 * accuracy) {
                continue;
            }
            let fine: Vec<(C64, C64)> = axis(PLACES).map(|x| (x, all.at(x + C64::one(), 1.0))).collect();
            let mut step = 8;
            while step <= count {
                let form = self.summed(&self.gathered(&ladder, step, &fine));
                let error = BETWEEN * (series + fine.iter().map(|&(x, should)| apart(x, should, &form)).fold(0.0, largest));
                if error <= accuracy {
                    return Some(Fitted { form, error });
                }
                step += step / 4;
            }
        }
        None
    }

    /// What errors at `x` are compared with.
    fn size(&self, x: C64, tilt: C64) -> f64 {
        tilt.abs() + self.mean_tilt(x + C64::one(), 1.0).abs()
    }

    fn summed(&self, ladder: &Ladder) -> Rational {
        let (mean, shell) = (self.mean(), 2.0 * self.radius * self.radius * ladder.sum);
        let waves = ladder.places.iter().zip(&ladder.shares);
        let inertia = shell - mean - ladder.shares.iter().sum::<f64>();
        let waves = waves.map(|(x, a)| Wave { place: c(*x, 0.0), strength: c(a * x, 0.0) }).collect();
        Rational { inertia, turning: 2.0 * mean - shell, waves }.scaled(PI * self.density)
    }

    fn ladder(&self, last: usize, degree: usize) -> Option<Ladder> {
        let mut found = Vec::new();
        let mut sum = 0.0;
        for k in (1..=last).step_by(2) {
            let factor = 8.0 * self.height.powi(3) / (PI * k as f64).powi(4);
            sum += factor;
            found.extend(self.waves(k, degree)?.into_iter().map(|(x, a)| (x, factor * a)));
        }
        found.sort_by_number(|a| a.0);
        let (places, shares) = found.into_iter().unzip();
        Some(Ladder { places, shares, sum })
    }

    /// Waves of one harmonic with polynomials of so many terms: places and shares over `c_k`.
    fn waves(&self, k: usize, terms: usize) -> Option<Vec<(f64, f64)>> {
        let Cavity { radius, free, height, .. } = *self;
        let (depth, kappa, square) = (radius - free, PI * k as f64 / height, free * free);
        let surface = usize::from(free > 0.0);
        let n = 2 * terms;
        let (mut inertia, mut turning) = (Mat::zeros(n + surface, n + surface), Mat::zeros(n + surface, n + surface));
        let mut drive = vec![0.0; n];
        for (x, weight) in gauss(terms + 4) {
            // the rule is that of the unit interval
            let (r, weight) = (free + depth * x, depth * weight);
            let (value, slope) = legendre(terms, 2.0 * x - 1.0);
            let fields: Vec<[f64; 3]> = (0..n)
                .map(|i| {
                    if i < terms {
                        let (p, dp) = (value[i], slope[i] * 2.0 / depth);
                        let u = (radius - r) / radius * p;
                        let du = (radius - r) / radius * dp - p / radius;
                        [u, -(u + r * du), 0.0]
                    } else {
                        let p = value[i - terms];
                        [0.0, r / radius * p, -p / (kappa * radius)]
                    }
                })
                .collect();
            for i in 0..n {
                let [u, v, z] = fields[i];
                drive[i] += r * weight * (u - v);
                for (j, &[u2, v2, z2]) in fields.iter().enumerate().take(i + 1) {
                    inertia[(i, j)] += r * weight * (u * u2 + v * v2 + z * z2);
                    turning[(i, j)] += 2.0 * r * weight * (u * v2 + v * u2);
                }
            }
        }
        let (end, _) = legendre(terms, -1.0);
        let rise = |i: usize| if i < terms { depth / radius * end[i] } else { 0.0 };
        if surface == 1 {
            inertia[(n, n)] = square;
            for i in 0..n {
                turning[(n, i)] = square * rise(i);
            }
        }
        let (places, modes) = definite(&turning, &inertia).ok()?;
        let share = |j: usize| {
            let flow: f64 = (0..n).map(|i| modes[(i, j)] * (2.0 * drive[i] + square * rise(i))).sum();
            (flow - if surface == 1 { square * modes[(n, j)] } else { 0.0 }).powi(2)
        };
        Some(places.iter().enumerate().map(|(j, x)| (*x, share(j))).collect())
    }

    /// So many waves in place of all: neighbours become one where that moves the reaction least. `along` has the reaction along the band.
    fn gathered(&self, ladder: &Ladder, count: usize, along: &[(C64, C64)]) -> Ladder {
        // relative to the size of the reaction at the place of the wave
        let weight = |x: f64| {
            let at = ((x / BAND + 1.0) * 0.5 * (along.len() - 1) as f64).round() as usize;
            let (x, should) = along[at.min(along.len() - 1)];
            (x + C64::one()).norm_sqr() * PI * self.density / self.size(x, should)
        };
        let together = |(x1, a1): (f64, f64), (x2, a2): (f64, f64)| {
            let a = a1 + a2;
            (if a > 0.0 { (a1 * x1 + a2 * x2) / a } else { x1 }, a)
        };
        let cost = |one: (f64, f64), two: (f64, f64)| {
            let (x, a) = together(one, two);
            if !(a > 0.0) {
                return 0.0;
            }
            let (apart, inside) = (two.0 - one.0, x.clamp(-BAND, BAND));
            let distance = MARGIN.hypot(x - inside);
            one.1 * two.1 / a * apart * apart * inside.hypot(MARGIN) / (distance.powi(3) * (1.0 + apart / distance)) * weight(inside)
        };
        let mut list: Vec<(f64, f64)> = ladder.places.iter().copied().zip(ladder.shares.iter().copied()).collect();
        let mut costs: Vec<f64> = list.windows(2).map(|w| cost(w[0], w[1])).collect();
        while list.len() > count.max(1) {
            let Some(i) = (0..costs.len()).min_by(|&i, &j| costs[i].total_cmp(&costs[j])) else { break };
            list[i] = together(list[i], list[i + 1]);
            list.remove(i + 1);
            costs.remove(i);
            if i > 0 {
                costs[i - 1] = cost(list[i - 1], list[i]);
            }
            if i + 1 < list.len() {
                costs[i] = cost(list[i], list[i + 1]);
            }
        }
        let (places, shares) = list.into_iter().unzip();
        Ladder { places, shares, sum: ladder.sum }
    }
}

/// The larger; NaN stays.
pub(super) fn largest(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { a.max(b) }
}

/// Legendre polynomials and their derivatives.
pub(super) fn legendre(count: usize, x: f64) -> (Vec<f64>, Vec<f64>) {
    let (mut p, mut d) = (vec![1.0, x], vec![0.0, 1.0]);
    for n in 2..count.max(2) {
        let k = n as f64;
        p.push(((2.0 * k - 1.0) * x * p[n - 1] - (k - 1.0) * p[n - 2]) / k);
        d.push(d[n - 2] + (2.0 * k - 1.0) * p[n - 1]);
    }
    (p, d)
}
