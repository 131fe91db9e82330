//! Ideal liquid: plane flow in closed form, tilt by axial harmonics.
//!
//! ```text
//! L0 = m_f w^2 (sigma^2 - 2 sigma W - W^2)/(gamma sigma^2 - 2 sigma W - W^2),   gamma = (R^2 + r0^2)/(R^2 - r0^2)
//! Lt = pi rho { -w (w - 2 W) [R^2 H^3/12 - H (R^4 - r0^4)/4] + sum over odd k of [ -2 i R P(R)/kappa^2 + 2 i int P r^2 dr ] }
//! P'' + P'/r - P/r^2 = lambda^2 P,  lambda^2 = kappa^2 (1 - 4 W^2/sigma^2),   P = c1 I1(lambda r) + c2 K1(lambda r)
//! wall:     -sigma P' + 2 W P/R = (2 W - sigma) g,        g = 8 i w sigma H/(pi k)^2
//! surface:  sigma (4 W^2 - sigma^2)(P + h r0) + W^2 r0 [-sigma P' + 2 W P/r0 - (2 W - sigma) g] = 0,   h = -4 i w (w - 2 W) H/(pi k)^2
//! ```
//!
//! Close to `sigma = +-2 W` lambda vanishes; there the unknown is `y = P - g r`, which is driven by terms of the order lambda^2 only. At these points each
//! harmonic is rational in k^2 and the sum is a tangent.
//!
//! Theory: `docs/theory/liquid-in-three-dimensions.md#axial-harmonics`.

use super::sum::over_odd;
use super::{Cavity, Tilt};
use laval_num::analytic::{exp, sqrt, value};
use laval_num::bessel::{Bessel, bessel, excess, excess_k};
use laval_num::complex::{C64, Complex};
use laval_num::dense::Field;
use laval_num::scalar::Scalar;
use std::f64::consts::PI;

/// Below this |lambda R| the unknown of a harmonic is `P - g r`.
const NEAR: f64 = 2.0;
/// Relative distance from `sigma = 0, +-2 W` that is rounding of a multiple of the speed.
const CLOSE: f64 = 16.0 * f64::EPSILON;
/// Relative rounding error of a harmonic whose equations do not cancel.
const ROUNDING: f64 = 32.0 * f64::EPSILON;

/// What of the axial series is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Truncation {
    /// All harmonics.
    None,
    /// All harmonics, to eight digits.
    Rough,
    /// Up to this one, without tail.
    At(usize),
}

impl Truncation {
    /// Share of the sum that its tail is known to.
    pub(super) fn share(self) -> f64 {
        if self == Truncation::Rough { 1e-8 } else { 1e-13 }
    }
}

/// What all harmonics at one frequency share.
struct Flow<S> {
    cavity: Cavity<S>,
    speed: S,
    sigma: Complex<S>,
    /// `2 W - sigma` and `2 W + sigma`.
    less: Complex<S>,
    more: Complex<S>,
    /// `1 - 4 W^2/sigma^2` and its root with positive real part.
    deficit: Complex<S>,
    root: Complex<S>,
    /// g and h times `(pi k)^2`.
    g: Complex<S>,
    h: Complex<S>,
}

impl<S: Scalar> Cavity<S> {
    /// Force per displacement of the cavity's centre, N/m.
    pub fn planar(&self, w: Complex<S>, speed: S) -> Complex<S> {
        let (r2, s2) = (self.radius.square(), self.free.square());
        let gamma = (r2 + s2) / (r2 - s2);
        let sigma = w - Complex::real(speed);
        let rest = sigma.scale(speed.scale(2.0)) + Complex::real(speed.square());
        let square = w * w;
        if value(square) == C64::zero() {
            return square;
        }
        (square * (sigma * sigma - rest)).scale(self.full_mass()) / ((sigma * sigma).scale(gamma) - rest)
    }

    /// Moment per tilt about the cavity's centre, N m/rad. Where `sigma` is 0 or `+-2 W` derivatives hold along lines that keep it so; the sum has
    /// none across them.
    pub fn tilt(&self, w: Complex<S>, speed: S, truncation: Truncation) -> Tilt<S> {
        let flow = Flow::new(*self, w, speed);
        let mean = self.mean_tilt(w, speed);
        let column = self.column();
        let finish = |sum: Complex<S>, harmonics: usize, error: f64| {
            let value = mean + sum.scale(column);
            Tilt { value, harmonics, error: error * column.value() + f64::EPSILON * laval_num::analytic::value(mean).abs() }
        };
        let (s, o) = (value(flow.sigma), speed.value());
        let close = |x: C64| x.abs() <= CLOSE * o.abs();
        let whole = !matches!(truncation, Truncation::At(_));
        if close(s) {
            return finish(Complex::zero(), 0, 0.0);
        }
        if close(value(flow.more)) {
            let (sum, rounding) = if whole { flow.backward_sum() } else { flow.listed(truncation, Flow::backward) };
            return finish(sum, 0, rounding);
        }
        if close(value(flow.less)) {
            let (sum, rounding) = if whole { flow.forward_sum() } else { flow.listed(truncation, Flow::forward) };
            return finish(sum, 0, rounding);
        }
        if let Truncation::At(last) = truncation {
            let (sum, rounding) = flow.listed(truncation, Flow::harmonic);
            return finish(sum, last.div_ceil(2), rounding);
        }
        if s.im == 0.0 && s.re.abs() < 2.0 * o.abs() {
            let (sum, _) = flow.listed(Truncation::At(199), Flow::harmonic);
            return finish(sum, 100, f64::INFINITY);
        }
        let (height, layer) = (self.height.value(), self.radius.value() - self.free.value());
        let root = value(flow.root).abs();
        // where a harmonic has a surface wave, and where the layer is deep for it
        let free = self.free.value();
        let wave = if free > 0.0 && o != 0.0 { height * s.norm_sqr() * root / (PI * o * o * free) } else { 0.0 };
        let deep = height / (PI * layer * root);
        let total = over_odd(2.0 * wave, deep, truncation.share(), |k| flow.harmonic(k));
        finish(total.value, total.harmonics, total.error)
    }
}

impl<S: Scalar> Cavity<S> {
    /// A function, up to a positive factor, with a simple zero at every pole of [`Cavity::planar`] and of [`Cavity::tilt`] with harmonics up to `last`, analytic but at
    /// `sigma = 0`: the product of the determinants of the boundary equations.
    pub fn regular(&self, w: Complex<S>, speed: S, last: usize) -> Complex<S> {
        let flow = Flow::new(*self, w, speed);
        let mut product = Complex::one();
        if self.free.value() > 0.0 {
            let (r2, s2) = (self.radius.square(), self.free.square());
            let rest = flow.sigma.scale(speed.scale(2.0)) + Complex::real(speed.square());
            product = (flow.sigma * flow.sigma).scale((r2 + s2) / (r2 - s2)) - rest;
        }
        for k in (1..=last).step_by(2) {
            product = product * flow.determinant(k as f64);
            let size = value(product).abs();
            if size > 0.0 && size.is_finite() {
                product = product.scale(S::cst(size.recip()));
            }
        }
        product
    }
}

impl Cavity<f64> {
    /// Frequencies, rad/s in fixed axes, of the plane waves in a cavity at rest: `W + W (1 -+ sqrt(1 + gamma))/gamma`; none where there is no free surface.
    pub fn plane_waves(&self, speed: f64) -> Vec<f64> {
        let (r2, s2) = (self.radius * self.radius, self.free * self.free);
        if s2 == 0.0 || r2 <= s2 {
            return Vec::new();
        }
        let gamma = (r2 + s2) / (r2 - s2);
        let root = (1.0 + gamma).sqrt();
        [(1.0 - root) / gamma, (1.0 + root) / gamma].map(|x| speed * (1.0 + x)).to_vec()
    }
}

impl<S: Scalar> Flow<S> {
    fn new(cavity: Cavity<S>, w: Complex<S>, speed: S) -> Self {
        let sigma = w - Complex::real(speed);
        let two = Complex::real(speed.scale(2.0));
        let (less, more) = (two - sigma, two + sigma);
        let deficit = -(less * more) / (sigma * sigma);
        let height = cavity.height;
        let g = (w * sigma).mul_i().scale(height.scale(8.0));
        let h = (w * (w - two)).mul_i().scale(height.scale(-4.0));
        Flow { cavity, speed, sigma, less, more, deficit, root: sqrt(deficit), g, h }
    }

    /// Terms up to the last harmonic, and the sum of their rounding errors.
    fn listed(&self, truncation: Truncation, term: impl Fn(&Self, f64) -> (Complex<S>, f64)) -> (Complex<S>, f64) {
        let Truncation::At(last) = truncation else { return (Complex::zero(), 0.0) };
        let (mut sum, mut rounding) = (Complex::zero(), 0.0);
        for k in (1..=last).step_by(2) {
            let (t, doubt) = term(self, k as f64);
            sum += t;
            rounding += doubt;
        }
        (sum, rounding)
    }

    fn wave_number(&self, k: f64) -> S {
        S::cst(PI * k) / self.cavity.height
    }
    fn forcing(&self, k: f64) -> (Complex<S>, Complex<S>) {
        let scale = S::cst((PI * k).powi(-2));
        (self.g.scale(scale), self.h.scale(scale))
    }
    /// The share of harmonic k of the bracket and its rounding error, from its pressure at the wall, the integral of `P r^2`, and how far the equations
    /// for its pressure cancel.
    fn share(&self, wave_number: S, wall: Complex<S>, volume: Complex<S>, cancel: f64) -> (Complex<S>, f64) {
        let (value, rounding) = self.bracket(wall.scale(self.cavity.radius / wave_number.square()), volume);
        (value, cancel * rounding)
    }
    /// `g (R^4 - r0^4)/4`: the integral of `g r r^2`.
    fn solid(&self) -> S {
        let (r2, s2) = (self.cavity.radius.square(), self.cavity.free.square());
        (r2 * r2 - s2 * s2).scale(0.25)
    }

    /// Operators of the wall, `-sigma P' + 2 W P/r`, on I1 and on K1, as pairs whose sum they are.
    fn inner(&self, lambda: Complex<S>, b: &Bessel<S>, back: S) -> [Complex<S>; 2] {
        [self.less * b.i[1].scale(back), -(self.sigma * lambda * b.i[2])]
    }
    fn outer(&self, lambda: Complex<S>, b: &Bessel<S>, back: S) -> [Complex<S>; 2] {
        [self.more * b.k[1].scale(back), self.sigma * lambda * b.k[0]]
    }

    /// Determinant of the boundary equations of harmonic k without its zeros at `sigma = +-2 W`, up to a positive factor: an even function of lambda, so
    /// analytic but at `sigma = 0`, and zero where the liquid moves in a cavity at rest.
    fn determinant(&self, k: f64) -> Complex<S> {
        let Flow { cavity: Cavity { radius, free, .. }, speed, sigma, less, more, .. } = *self;
        let lambda = self.root.scale(self.wave_number(k));
        let (x, x0) = (lambda.scale(radius), lambda.scale(free));
        let turn = |x: Complex<S>| Complex::cis(x.im).scale((x.re - S::cst(x.re.value())).exp());
        let total = |t: [Complex<S>; 2]| t[0] + t[1];
        let b = bessel(x);
        let back = S::one() / radius;
        if free.value() == 0.0 {
            return total(self.inner(lambda, &b, back)) * turn(x) / (lambda * less);
        }
        let b0 = bessel(x0);
        let e = exp(x0 - x);
        let back0 = S::one() / free;
        let tension = -(sigma * sigma * sigma * self.deficit);
        let weight = speed.square() * free;
        let wall = [total(self.inner(lambda, &b, back)), total(self.outer(lambda, &b, back)) * e];
        let surface = [
            (tension * b0.i[1] + total(self.inner(lambda, &b0, back0)).scale(weight)) * e,
            tension * b0.k[1] + total(self.outer(lambda, &b0, back0)).scale(weight),
        ];
        (wall[0] * surface[1] - wall[1] * surface[0]) * turn(x - x0) / (less * more)
    }

    /// The share of harmonic k, away from `sigma = 0, +-2 W`.
    fn harmonic(&self, k: f64) -> (Complex<S>, f64) {
        let Flow { cavity: Cavity { radius, free, .. }, speed, sigma, less, .. } = *self;
        let kappa = self.wave_number(k);
        let (g, h) = self.forcing(k);
        let lambda = self.root.scale(kappa);
        let (x, x0) = (lambda.scale(radius), lambda.scale(free));
        let b = bessel(x);
        let back = S::one() / radius;
        let inner = |b: &Bessel<S>, back: S| self.inner(lambda, b, back);
        let outer = |b: &Bessel<S>, back: S| self.outer(lambda, b, back);
        // of y_p = g r E(lambda r), which answers the forcing lambda^2 g r
        let slip = |[first, second]: [Complex<S>; 2], x: Complex<S>| {
            g * (less * first - (sigma * x * x * (second + Complex::one())).scale(S::cst(0.25)))
        };
        let near = value(x).norm_sqr() < NEAR * NEAR;
        let at = if near { excess(x) } else { [Complex::zero(); 2] };
        let quarter = |r: S| (r.square() * r.square()).scale(0.25);
        let (wall, known, known_volume) = if near {
            (-slip(at, x), (g * (at[0] + Complex::one())).scale(radius), (g * (at[1] + Complex::one())).scale(quarter(radius)))
        } else {
            (less * g, Complex::zero(), Complex::zero())
        };
        let (wall_i, wall_i_size) = added(inner(&b, back));
        let r2 = radius.square();
        if free.value() == 0.0 {
            let c1 = wall / wall_i;
            let volume = c1 * b.i[2].scale(r2) / lambda + known_volume;
            return self.share(kappa, c1 * b.i[1] + known, volume, wall_i_size / value(wall_i).size());
        }
        let b0 = bessel(x0);
        let e = exp(x0 - x);
        let tension = -(sigma * sigma * sigma * self.deficit);
        let weight = speed.square() * free;
        let back0 = S::one() / free;
        // I1 normalised at the wall, K1 at the surface
        let (wall_k, wall_k_size) = added(outer(&b, back).map(|t| t * e));
        let at_surface = |z: Complex<S>, [p, q]: [Complex<S>; 2]| added([tension * z, p.scale(weight), q.scale(weight)]);
        let (surface_i, surface_i_size) = at_surface(b0.i[1] * e, inner(&b0, back0).map(|t| t * e));
        let (surface_k, surface_k_size) = at_surface(b0.k[1], outer(&b0, back0));
        let (surface, known_volume) = if near {
            let at0 = excess(x0);
            let pressure = tension * (g * (at0[0] + Complex::one()) + h).scale(free);
            (-(pressure + slip(at0, x0).scale(weight)), known_volume - (g * (at0[1] + Complex::one())).scale(quarter(free)))
        } else {
            (less * g.scale(weight) - tension * h.scale(free), known_volume)
        };
        let det = wall_i * surface_k - wall_k * surface_i;
        let c1 = (wall * surface_k - wall_k * surface) / det;
        let c2 = (wall_i * surface - surface_i * wall) / det;
        let cancel = (wall_i_size * surface_k_size + wall_k_size * surface_i_size) / value(det).size();
        let s2 = free.square();
        // of r^2 K2; for small arguments without the constant 2/lambda^2, which would cancel
        let outer_moment = if near {
            let up = exp(x0);
            let of = |x: Complex<S>, k0: Complex<S>, square: S| ((k0 * exp(-x) + excess_k(x).scale(S::cst(2.0))) * up).scale(square);
            of(x, b.k[0], r2) - of(x0, b0.k[0], s2)
        } else {
            b.k[2] * e.scale(r2) - b0.k[2].scale(s2)
        };
        let moments = c1 * (b.i[2].scale(r2) - b0.i[2] * e.scale(s2)) - c2 * outer_moment;
        self.share(kappa, c1 * b.i[1] + c2 * b.k[1] * e + known, moments / lambda + known_volume, cancel)
    }

    /// `c1, c2, c3` of the flow without Bessel functions at `sigma = -2 W`.
    fn logarithmic(&self) -> (S, S, S) {
        let (r2, s2) = (self.cavity.radius.square(), self.cavity.free.square());
        let c1 = (S::one() / s2 - S::one() / r2).scale(0.5);
        (c1, (r2 - s2).scale(0.5), (self.cavity.radius / self.cavity.free).ln())
    }
    /// The share of harmonic k at `sigma = -2 W`, where `P = g r + B/r`.
    fn backward(&self, k: f64) -> (Complex<S>, f64) {
        let kappa = self.wave_number(k);
        let (g, h) = self.forcing(k);
        if self.cavity.free.value() == 0.0 {
            return self.share(kappa, g.scale(self.cavity.radius), g.scale(self.solid()), 1.0);
        }
        let (c1, c2, c3) = self.logarithmic();
        let half = self.cavity.free.scale(0.5);
        let square = kappa.square();
        let b =
            ((g + h).scale(half.scale(4.0)) - g.scale(half * square * c2)).scale(S::one() / (half * (c1 + square * c3) - S::one() / half));
        let radius = self.cavity.radius;
        self.share(kappa, g.scale(radius) + b.scale(S::one() / radius), g.scale(self.solid()) + b.scale(c2), 1.0)
    }
    /// All of them: with `kappa = n k` and B = (u + v k^2)/(k^2 (d + e k^2)) the sum needs three series in `1/(k^2 + d/e)`.
    fn backward_sum(&self) -> (Complex<S>, f64) {
        let n2 = self.wave_number(1.0).square();
        let (g, h) = self.forcing(1.0);
        let radius = self.cavity.radius;
        if self.cavity.free.value() == 0.0 {
            return self.bracket(g.scale(radius.square().scale(FOURTHS) / n2), g.scale(self.solid().scale(SQUARES)));
        }
        let (c1, c2, c3) = self.logarithmic();
        let half = self.cavity.free.scale(0.5);
        let u = (g + h).scale(half.scale(4.0));
        let v = -g.scale(half * n2 * c2);
        let (d, e) = (half * c1 - S::one() / half, half * n2 * c3);
        let [s0, s1, s2] = odd_sums(d / e);
        // sums of B and of B/k^2
        let b0 = (v.scale(s0) + u.scale(s1)).scale(S::one() / e);
        let b1 = (v.scale(s1) + u.scale(s2)).scale(S::one() / e);
        let volume = g.scale(self.solid().scale(SQUARES)) + b0.scale(c2);
        let wall = (g.scale(radius.scale(FOURTHS)) + b1.scale(S::one() / radius)).scale(radius / n2);
        self.bracket(wall, volume)
    }
    /// `2 i (volume - wall)` and its rounding error.
    fn bracket(&self, wall: Complex<S>, volume: Complex<S>) -> (Complex<S>, f64) {
        let size = 2.0 * (value(volume).size() + value(wall).size());
        ((volume - wall).mul_i().scale(S::cst(2.0)), ROUNDING * size)
    }

    /// `A k^2` times `(d + e k^2)` of `P = A r` at `sigma = 2 W`, with d and e.
    fn rigid(&self) -> (Complex<S>, S, S) {
        let (r2, s2) = (self.cavity.radius.square(), self.cavity.free.square());
        let (g, h) = self.forcing(1.0);
        if self.cavity.free.value() == 0.0 {
            return (g, S::one(), (self.wave_number(1.0).square() * r2).scale(0.5));
        }
        let q2 = r2 / s2;
        let e = (self.wave_number(1.0).square() * (s2 - q2 * r2)).scale(0.5);
        (g.scale(S::one() - q2) - h.scale(S::cst(8.0)), S::cst(9.0) - q2, e)
    }
    /// The share of harmonic k at `sigma = 2 W`, where `P = A r`.
    fn forward(&self, k: f64) -> (Complex<S>, f64) {
        let (top, d, e) = self.rigid();
        let a = top.scale(S::one() / (S::cst(k * k) * (d + e.scale(k * k))));
        self.share(self.wave_number(k), a.scale(self.cavity.radius), a.scale(self.solid()), 1.0)
    }
    fn forward_sum(&self) -> (Complex<S>, f64) {
        let (top, d, e) = self.rigid();
        let [_, s1, s2] = odd_sums(d / e);
        let a = top.scale(S::one() / e);
        let volume = a.scale(self.solid() * s1);
        let wall = a.scale(s2 * self.cavity.radius.square() / self.wave_number(1.0).square());
        self.bracket(wall, volume)
    }
}

/// The sum of a few numbers, and of their sizes.
fn added<S: Scalar, const N: usize>(terms: [Complex<S>; N]) -> (Complex<S>, f64) {
    let (mut sum, mut size) = (Complex::zero(), 0.0);
    for t in terms {
        sum += t;
        size += value(t).size();
    }
    (sum, size)
}

/// Sums of `1/k^2` and `1/k^4` over odd k.
const SQUARES: f64 = PI * PI / 8.0;
const FOURTHS: f64 = PI * PI * PI * PI / 96.0;
/// Sums of `k^-(2 j + 2)` over odd k from 3.
const BEYOND: [f64; 16] = [
    0.23370055013616983,
    0.014678031604192055,
    0.001447076640942122,
    0.0001551790252961193,
    1.704136304482549e-05,
    1.8858485831195758e-06,
    2.092405192115001e-07,
    2.3237157379156708e-08,
    2.5814375566597727e-09,
    2.86807697455582e-10,
    3.1866775140443605e-11,
    3.5407229439205076e-12,
    3.9341246691444825e-13,
    4.3712448592291243e-14,
    4.856936823405076e-15,
    5.396595706860077e-16,
];

/// Sums over odd k of `1/(k^2 + b)`, `1/(k^2 (k^2 + b))` and `1/(k^4 (k^2 + b))`.
fn odd_sums<S: Scalar>(b: S) -> [S; 3] {
    if b.value().abs() < 0.5 {
        // the first term exactly, the others by powers of b
        let first = S::one() / (S::one() + b);
        let series = |from: usize| {
            let mut sum = S::zero();
            for j in (from..BEYOND.len()).rev() {
                sum = S::cst(BEYOND[j]) - b * sum;
            }
            first + sum
        };
        return [series(0), series(1), series(2)];
    }
    let root = b.abs().sqrt();
    let half = root.scale(0.5 * PI);
    let tangent = if b.value() < 0.0 {
        let (s, c) = half.sin_cos();
        s / c
    } else {
        // tanh, without overflow
        let e = half.scale(-2.0).exp();
        (S::one() - e) / (S::one() + e)
    };
    let s0 = tangent.scale(0.25 * PI) / root;
    let s1 = (S::cst(SQUARES) - s0) / b;
    [s0, s1, (S::cst(FOURTHS) - s1) / b]
}
