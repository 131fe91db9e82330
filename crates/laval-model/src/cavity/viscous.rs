//! Viscous liquid: plane flow, and tilt with end caps that do not hold the liquid, both by Bessel functions.
//!
//! Plane flow, stream function `psi = A r + B/r + C I1(mu r) + D K1(mu r)`, `mu^2 = i sigma/nu`, `f = w^2 Q`:
//!
//! ```text
//! u = -i psi/r,  v = -psi',  p = r [sigma v - 2 i W u + f - i nu (lap psi)'],  lap psi = mu^2 (C I1 + D K1)
//! R:  u = v = 0;   r0:  v' - v/r0 - i u/r0 = 0,  i sigma (p - 2 nu u') + W^2 r0 u = 0;   F = pi R H rho [p(R) - i nu v'(R)]
//! ```
//!
//! Tilt, harmonic k: pressure and flow are sums over the three roots of `s (i sigma - nu s)^2 = 4 W^2 kappa^2`, each with I and K. With
//! `mu^2 = s + kappa^2`, `c = i sigma - nu s`, and `Z0, Z1, Z2 = I0, I1, I2` or `-K0, K1, -K2`,
//!
//! ```text
//! p = Z1(mu r),  u + i v = -mu Z0/(c + 2 i W),  u - i v = -mu Z2/(c - 2 i W),  w = kappa Z1/c
//! forcing g: p = 0, u = g/(i sigma + 2 i W + nu kappa^2), v = -i u, w = 0
//! R:  u = v = w = 0;   r0:  v' - v/r0 - i u/r0 = 0,  w' - kappa u = 0,  i sigma (p - 2 nu u' + h r0) + W^2 r0 u = 0
//! Lt = pi rho { as for the ideal liquid, k = 0, + sum [ R(-2 i (p - i nu v')/kappa^2 + 2 i R nu w'/kappa) at R + 2 i int (p - 2 nu kappa w) r^2 dr ] }
//! ```
//!
//! Theory: `docs/theory/liquid-in-three-dimensions.md#viscous-liquid`.

use super::sum::{Series, Term, over_odd};
use super::{Cavity, Tilt, Truncation};
use laval_num::analytic::{exp, sqrt, value};
use laval_num::bessel::{Bessel, bessel, excess, excess_k};
use laval_num::complex::{C64, Complex, c};
use laval_num::dense::Field;
use laval_num::scalar::Scalar;
use std::f64::consts::PI;

/// Below this `|mu| R` the plane flows are counted from their limits `r`, `1/r`, `r^3` and `r ln r`.
const ALIKE: f64 = 1.5;
/// Below this `|mu R|^2` the value is the mean of two beside it.
const LIMIT: f64 = 1e-8;
/// Its tail moves so slowly with the joint that what it moves by says less of what is left.
const SLOW: f64 = 1e-11;
/// Relative rounding error of what six flows contribute.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

impl<S: Scalar> Cavity<S> {
    /// Force per displacement of the cavity's centre, N/m, of a liquid of kinematic viscosity `nu` above 0.
    pub fn planar_viscous(&self, w: Complex<S>, speed: S, nu: S) -> Complex<S> {
        let sigma = value(w) - C64::real(speed.value());
        let (nu0, radius) = (nu.value(), self.radius.value());
        let unit = nu0 / (radius * radius);
        if sigma.abs() > LIMIT * unit {
            return self.planar_flow(w, speed, nu);
        }
        let aside = [4.0 * LIMIT, -4.0 * LIMIT].map(|x| self.planar_flow(w + Complex::cst(c(0.0, x * unit)), speed, nu));
        (aside[0] + aside[1]).scale(S::cst(0.5))
    }

    fn planar_flow(&self, w: Complex<S>, speed: S, nu: S) -> Complex<S> {
        let (one, two) = (S::one(), S::cst(2.0));
        let sigma = w - Complex::real(speed);
        let force = w * w;
        let i_sigma = sigma.mul_i();
        let mu2 = i_sigma.scale(one / nu);
        let mu = sqrt(mu2);
        let (radius, free) = (self.radius, self.free);
        let (x, x0) = (mu.scale(radius), mu.scale(free));
        let (b, b0) = (bessel(x), bessel(x0));
        let e = exp(x0 - x);
        let alike = value(x).abs() < ALIKE;
        // psi, psi', psi'', lap psi, (lap psi)' of the four flows at r
        let flows = |b: &Bessel<S>, x: Complex<S>, r: S, i: Complex<S>, k: Complex<S>| {
            let back = one / r;
            let with_second = |z: Complex<S>, slope: Complex<S>, lap: Complex<S>, lap_slope: Complex<S>| {
                [z, slope, lap + (z.scale(back) - slope).scale(back), lap, lap_slope]
            };
            let bent =
                |z1: Complex<S>, slope: Complex<S>, factor: Complex<S>| with_second(z1, slope, mu2 * z1, mu2 * slope).map(|f| f * factor);
            let (i1, k1) = (b.i[1], b.k[1]);
            let (zero, real) = (Complex::zero(), Complex::real);
            let straight = [real(r / radius), real(one / radius), zero, zero, zero];
            let inverse = [real(free * back), real(-(free * back.square())), real((free * back * back.square()).scale(2.0)), zero, zero];
            if alike {
                // (2 I1/mu - r)/mu^2 and (mu K1 - 1/r)/mu^2
                let ([first, second], third) = (excess(x), excess_k(x));
                let down = exp(-x);
                let (k0, k1) = (b.k[0] * down, mu * b.k[1] * down);
                let bend = (x * x * (second + Complex::one())).scale(S::cst(0.25));
                let cubic = first.scale(r) / mu2;
                let steep = third.scale(r);
                let lap = (first + Complex::one()).scale(r);
                return [
                    straight,
                    inverse,
                    with_second(cubic, (bend + first) / mu2, lap, bend + first + Complex::one()),
                    with_second(steep, -k0 - steep.scale(back), k1, -(mu2 * k0) - k1.scale(back)),
                ];
            }
            [straight, inverse, bent(i1, mu * b.i[0] - i1.scale(back), i), bent(k1, -(mu * b.k[0]) - k1.scale(back), k)]
        };
        let wall = flows(&b, x, radius, Complex::one(), e);
        let surface = flows(&b0, x0, free, e, Complex::one());
        let slip = speed.square() * free;
        let back = one / free;
        let mut a = [[Complex::zero(); 4]; 4];
        for j in 0..4 {
            let [psi, first, second, _, rot] = surface[j];
            let u = -psi.mul_i().scale(back);
            let slope = (psi.scale(back) - first).mul_i().scale(back);
            let p = (u.mul_i().scale(speed * two) + sigma * first + rot.mul_i().scale(nu)).scale(-free);
            a[0][j] = wall[j][0];
            a[1][j] = wall[j][1];
            a[2][j] = first.scale(back) - psi.scale(back.square()) - second;
            a[3][j] = i_sigma * (p - slope.scale(nu * two)) + u.scale(slip);
        }
        let zero = Complex::zero();
        let constants = solve(a, [zero, zero, zero, -(i_sigma * force.scale(free))]);
        let (mut rot, mut second) = (zero, zero);
        for j in 0..4 {
            rot += constants[j] * wall[j][4];
            second += constants[j] * wall[j][2];
        }
        // no flow at the wall: p = R (f - i nu (lap psi)'), v' = -psi''
        let pressure = (force - rot.mul_i().scale(nu)).scale(radius);
        (pressure + second.mul_i().scale(nu)).scale(self.column() * radius * self.height)
    }

    /// Moment per tilt about the cavity's centre, N m/rad, of a liquid of kinematic viscosity `nu` above 0; no slip at the wall, free slip at the
    /// ends. Not a number at speed 0, where the roots coincide.
    pub fn tilt_viscous(&self, w: Complex<S>, speed: S, nu: S, truncation: Truncation) -> Tilt<S> {
        let sigma = w - Complex::real(speed);
        let two = Complex::real(speed.scale(2.0));
        let g = (w * sigma).mul_i().scale(self.height.scale(8.0));
        let h = (w * (w - two)).mul_i().scale(self.height.scale(-4.0));
        let flow = Waves { cavity: *self, speed, nu, i_sigma: sigma.mul_i(), g, h };
        let mean = self.mean_tilt(w, speed);
        let column = self.column();
        let (s, o, nu0) = (value(sigma).abs(), speed.value().abs(), nu.value());
        let (sum, harmonics, error) = match truncation {
            Truncation::At(last) => {
                let (mut sum, mut rounding) = (Complex::zero(), 0.0);
                for k in (1..=last).step_by(2) {
                    let (t, doubt) = flow.harmonic(k as f64);
                    sum += t;
                    rounding += doubt;
                }
                (sum, last.div_ceil(2), rounding)
            }
            Truncation::None | Truncation::Rough => {
                let height = self.height.value();
                let root = ((s * s - 4.0 * o * o).abs().sqrt() / s).min(1e3);
                let wave = if o > 0.0 { height * s * s * root / (PI * o * o * self.free.value()) } else { 0.0 };
                // harmonics that viscosity damps within a turn
                let damped = height / PI * (s.max(o) / nu0).sqrt();
                let total = over_odd(2.0 * wave, damped, truncation.share().min(SLOW), &flow);
                (total.value, total.harmonics, total.error)
            }
        };
        let value = mean + sum.scale(column);
        Tilt { value, harmonics, error: error * column.value() + f64::EPSILON * laval_num::analytic::value(mean).abs() }
    }
}

/// What all harmonics at one frequency share.
struct Waves<S> {
    cavity: Cavity<S>,
    speed: S,
    nu: S,
    i_sigma: Complex<S>,
    /// g and h times `(pi k)^2`.
    g: Complex<S>,
    h: Complex<S>,
}

/// One of six flows at one radius.
struct Shape<S> {
    p: Complex<S>,
    plus: Complex<S>,
    minus: Complex<S>,
    axial: Complex<S>,
    plus_slope: Complex<S>,
    minus_slope: Complex<S>,
    axial_slope: Complex<S>,
    /// `int p r^2 dr` without constant.
    volume: Complex<S>,
}

impl<S: Scalar> Waves<S> {
    /// The share of harmonic k of the bracket, and its rounding error.
    fn harmonic(&self, k: f64) -> (Complex<S>, f64) {
        let Waves { cavity: Cavity { radius, free, height, .. }, speed, nu, i_sigma, .. } = *self;
        let (one, two, half) = (S::one(), S::cst(2.0), S::cst(0.5));
        let kappa = S::cst(PI * k) / height;
        let scale = S::cst((PI * k).powi(-2));
        let (g, h) = (self.g.scale(scale), self.h.scale(scale));
        let turn = Complex::i().scale(speed.scale(2.0));
        let drift = g / (i_sigma + turn + Complex::real(nu * kappa.square()));
        let roots = self.roots(kappa);
        let mut shapes = Vec::with_capacity(6);
        for root in roots {
            let (plus, minus) = (root + turn, root - turn);
            // mu^2 = kappa^2 (c + 2 i W)(c - 2 i W)/c^2
            let mu = sqrt(plus * minus).scale(kappa) / root;
            let mu = if value(mu).re < 0.0 { -mu } else { mu };
            let (x, x0) = (mu.scale(radius), mu.scale(free));
            let (b, b0) = (bessel(x), bessel(x0));
            let e = exp(x0 - x);
            let flow = |z: [Complex<S>; 3], sign: f64, r: S, factor: Complex<S>| {
                let back = one / r;
                let [z0, z1, z2] = [z[0].scale(S::cst(sign)), z[1], z[2].scale(S::cst(sign))].map(|z| z * factor);
                let mu2 = mu * mu;
                let (up, down, along) = (plus.recip(), minus.recip(), root.recip().scale(kappa));
                Shape {
                    p: z1,
                    plus: -(mu * z0 * up),
                    minus: -(mu * z2 * down),
                    axial: z1 * along,
                    plus_slope: -(mu2 * z1 * up),
                    minus_slope: -((mu2 * z1 - (mu * z2).scale(back * two)) * down),
                    axial_slope: (mu * z0 - z1.scale(back)) * along,
                    volume: z2.scale(r.square()) / mu,
                }
            };
            shapes.push((flow(b.i, 1.0, radius, Complex::one()), flow(b0.i, 1.0, free, e)));
            shapes.push((flow(b.k, -1.0, radius, e), flow(b0.k, -1.0, free, Complex::one())));
        }
        let slip = speed.square() * free;
        let back = one / free;
        let mut a = [[Complex::zero(); 6]; 6];
        for (j, (wall, surface)) in shapes.iter().enumerate() {
            let u = (surface.plus + surface.minus).scale(half);
            let u_slope = (surface.plus_slope + surface.minus_slope).scale(half);
            // i v = (plus - minus)/2
            let iv_slope = (surface.plus_slope - surface.minus_slope).scale(half);
            a[0][j] = wall.plus;
            a[1][j] = wall.minus;
            a[2][j] = wall.axial;
            // i (v' - v/r - i u/r) = i v' - (i v - u)/r = i v' + minus/r
            a[3][j] = iv_slope + surface.minus.scale(back);
            a[4][j] = surface.axial_slope - u.scale(kappa);
            a[5][j] = i_sigma * (surface.p - u_slope.scale(nu * two)) + u.scale(slip);
        }
        let zero = Complex::zero();
        let right = [-drift.scale(two), zero, zero, zero, drift.scale(kappa), -(drift.scale(slip) + i_sigma * h.scale(free))];
        let constants = solve(a, right);
        let (mut wall_sum, mut volume, mut size) = (zero, zero, 0.0);
        let twice = (nu * kappa).scale(2.0);
        for (&x, (root, (wall, surface))) in constants.iter().zip(roots.iter().flat_map(|r| [r, r]).zip(&shapes)) {
            let iv_slope = (wall.plus_slope - wall.minus_slope).scale(half);
            let stress = wall.p - iv_slope.scale(nu);
            let at_wall = (x * (wall.axial_slope.scale(nu * radius * kappa) - stress)).scale(radius / kappa.square());
            let inside = x * (wall.volume - surface.volume) * (Complex::one() - root.recip().scale(twice * kappa));
            wall_sum += at_wall;
            volume += inside;
            size += value(at_wall).size() + value(inside).size();
        }
        // beside sigma = -2 W the drift is large and almost one of the flows
        let cancel = value(turn - i_sigma).abs() / value(i_sigma + turn + Complex::real(nu * kappa.square())).abs();
        ((wall_sum + volume).mul_i().scale(two), ROUNDING * size * (1.0 + 0.05 * cancel))
    }

    /// The three `c` of `c^2 (i sigma - c) = 4 W^2 kappa^2 nu`.
    fn roots(&self, kappa: S) -> [Complex<S>; 3] {
        let product = self.speed.square().scale(4.0) * kappa.square() * self.nu;
        let (linear, constant) = (value(self.i_sigma), product.value());
        // all at once (Durand and Kerner), then each by Newton's method, which also carries the derivatives
        let size = linear.abs().max(constant.cbrt());
        let mut z = [0.0, 1.0, 2.0].map(|j| C64::cis(0.4 + 2.0 * PI / 3.0 * j).scale(size));
        for _ in 0..60 {
            let mut moved = 0.0;
            for j in 0..3 {
                let value = z[j] * z[j] * (z[j] - linear) + c(constant, 0.0);
                let others = (z[j] - z[(j + 1) % 3]) * (z[j] - z[(j + 2) % 3]);
                let step = value / others;
                z[j] -= step;
                moved = step.size().max(moved);
            }
            if !(moved > 1e-14 * size) {
                break;
            }
        }
        z.map(|z| {
            let mut z = Complex::cst(z);
            for _ in 0..2 {
                let value = z * z * (z - self.i_sigma) + Complex::real(product);
                let slope = z * (z.scale(S::cst(3.0)) - self.i_sigma.scale(S::cst(2.0)));
                z -= value / slope;
            }
            z
        })
    }
}

impl<S: Scalar> Series<S> for Waves<S> {
    // in lanes its six flows and their equations take a third of the build of this crate
    fn terms(&self, all: &[f64], out: &mut Vec<Term<S>>) {
        out.extend(all.iter().map(|k| self.harmonic(*k)));
    }
}

/// Solution of a small system: rows scaled, partial pivoting, one step of refinement.
fn solve<S: Scalar, const N: usize>(mut a: [[Complex<S>; N]; N], mut b: [Complex<S>; N]) -> [Complex<S>; N] {
    for (row, b) in a.iter_mut().zip(&mut b) {
        let size = row.iter().map(|x| value(*x).size()).fold(0.0, f64::max);
        if size > 0.0 {
            let scale = S::cst(size.recip());
            row.iter_mut().for_each(|x| *x = x.scale(scale));
            *b = b.scale(scale);
        }
    }
    let mut lu = a;
    let mut order: [usize; N] = std::array::from_fn(|i| i);
    for j in 0..N {
        let mut pivot = j;
        for i in j + 1..N {
            if value(lu[i][j]).norm_sqr() > value(lu[pivot][j]).norm_sqr() {
                pivot = i;
            }
        }
        lu.swap(j, pivot);
        order.swap(j, pivot);
        let inverse = lu[j][j].recip();
        for i in j + 1..N {
            let factor = lu[i][j] * inverse;
            lu[i][j] = factor;
            for m in j + 1..N {
                let known = factor * lu[j][m];
                lu[i][m] -= known;
            }
        }
    }
    let back = |b: &[Complex<S>; N]| {
        let mut x: [Complex<S>; N] = std::array::from_fn(|i| b[order[i]]);
        for i in 0..N {
            for j in 0..i {
                let known = lu[i][j] * x[j];
                x[i] -= known;
            }
        }
        for i in (0..N).rev() {
            for j in i + 1..N {
                let known = lu[i][j] * x[j];
                x[i] -= known;
            }
            x[i] = x[i] / lu[i][i];
        }
        x
    };
    let x = back(&b);
    let rest: [Complex<S>; N] = std::array::from_fn(|i| (0..N).fold(b[i], |s, j| s - a[i][j] * x[j]));
    let correction = back(&rest);
    std::array::from_fn(|i| x[i] + correction[i])
}
