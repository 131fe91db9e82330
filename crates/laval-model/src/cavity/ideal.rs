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

use super::sum::{Series, SideBySide, Term, over_odd, side_by_side, size, spread};
use super::{Cavity, Tilt};
use laval_num::analytic::{exp, sqrt, value};
use laval_num::bessel::{Bessel, bessel, excess, excess_k};
use laval_num::complex::{C64, Complex};
use laval_num::lanes::LaneScalar;
use laval_num::scalar::Scalar;
use std::f64::consts::PI;

/// Below this |lambda R| the unknown of a harmonic is `P - g r`.
const NEAR: f64 = 2.0;
/// Beyond so many times that rounding does not decide which unknown it is.
const SURELY: f64 = 1.0 + 1e-9;
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
#[derive(Clone, Copy)]
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
            return finish(sum, 0, rounding.value());
        }
        if close(value(flow.less)) {
            let (sum, rounding) = if whole { flow.forward_sum() } else { flow.listed(truncation, Flow::forward) };
            return finish(sum, 0, rounding.value());
        }
        if let Truncation::At(last) = truncation {
            let (sum, rounding) = flow.listed(truncation, Flow::single);
            return finish(sum, last.div_ceil(2), rounding.value());
        }
        if s.im == 0.0 && s.re.abs() < 2.0 * o.abs() {
            let (sum, _) = flow.listed(Truncation::At(199), Flow::single);
            return finish(sum, 100, f64::INFINITY);
        }
        let (height, layer) = (self.height.value(), self.radius.value() - self.free.value());
        let root = value(flow.root).abs();
        // where a harmonic has a surface wave, and where the layer is deep for it
        let free = self.free.value();
        let wave = if free > 0.0 && o != 0.0 { height * s.norm_sqr() * root / (PI * o * o * free) } else { 0.0 };
        let deep = height / (PI * layer * root);
        let total = over_odd(2.0 * wave, deep, truncation.share(), &flow);
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
    fn listed(&self, truncation: Truncation, term: impl Fn(&Self, S::Base) -> (Complex<S>, S::Base)) -> (Complex<S>, S::Base) {
        let (mut sum, mut rounding) = (Complex::zero(), S::Base::zero());
        let Truncation::At(last) = truncation else { return (sum, rounding) };
        for k in (1..=last).step_by(2) {
            let (t, doubt) = term(self, S::Base::cst(k as f64));
            sum += t;
            rounding += doubt;
        }
        (sum, rounding)
    }

    #[inline(always)]
    fn wave_number(&self, k: S::Base) -> S {
        S::constant(k.scale(PI)) / self.cavity.height
    }
    #[inline(always)]
    fn forcing(&self, k: S::Base) -> (Complex<S>, Complex<S>) {
        let scale = S::constant(S::Base::one() / k.scale(PI).square());
        (self.g.scale(scale), self.h.scale(scale))
    }
    /// The share of harmonic k of the bracket and its rounding error, from its pressure at the wall, the integral of `P r^2`, and how far the equations
    /// for its pressure cancel.
    #[inline(always)]
    fn share(&self, wave_number: S, wall: Complex<S>, volume: Complex<S>, cancel: S::Base) -> (Complex<S>, S::Base) {
        let (value, rounding) = self.bracket(wall.scale(self.cavity.radius / wave_number.square()), volume);
        (value, cancel * rounding)
    }
    /// `g (R^4 - r0^4)/4`: the integral of `g r r^2`.
    fn solid(&self) -> S {
        let (r2, s2) = (self.cavity.radius.square(), self.cavity.free.square());
        (r2 * r2 - s2 * s2).scale(0.25)
    }

    /// The same flow in lanes.
    #[inline(always)]
    fn spread<L: LaneScalar>(&self) -> Flow<S::Over<L>> {
        let z = spread::<S, L>;
        Flow {
            cavity: self.cavity.spread::<L>(),
            speed: self.speed.spread::<L>(),
            sigma: z(self.sigma),
            less: z(self.less),
            more: z(self.more),
            deficit: z(self.deficit),
            root: z(self.root),
            g: z(self.g),
            h: z(self.h),
        }
    }

    /// The share of harmonic k, away from `sigma = 0, +-2 W`.
    fn single(&self, k: S::Base) -> (Complex<S>, S::Base) {
        let x = self.root.scale(self.wave_number(k) * self.cavity.radius);
        self.harmonic(k, value(x).norm_sqr() < NEAR * NEAR)
    }

    /// Operators of the wall, `-sigma P' + 2 W P/r`, on I1 and on K1, as pairs whose sum they are.
    #[inline(always)]
    fn inner(&self, lambda: Complex<S>, b: &Bessel<S>, back: S) -> [Complex<S>; 2] {
        [self.less * b.i[1].scale(back), -(self.sigma * lambda * b.i[2])]
    }
    #[inline(always)]
    fn outer(&self, lambda: Complex<S>, b: &Bessel<S>, back: S) -> [Complex<S>; 2] {
        [self.more * b.k[1].scale(back), self.sigma * lambda * b.k[0]]
    }

    /// Determinant of the boundary equations of harmonic k without its zeros at `sigma = +-2 W`, up to a positive factor: an even function of lambda, so
    /// analytic but at `sigma = 0`, and zero where the liquid moves in a cavity at rest.
    fn determinant(&self, k: f64) -> Complex<S> {
        let Flow { cavity: Cavity { radius, free, .. }, speed, sigma, less, more, .. } = *self;
        let lambda = self.root.scale(self.wave_number(S::Base::cst(k)));
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

    /// The same; `near` where the unknown is `P - g r`.
    #[inline(always)]
    fn harmonic(&self, k: S::Base, near: bool) -> (Complex<S>, S::Base) {
        let Flow { cavity: Cavity { radius, free, .. }, speed, sigma, less, .. } = *self;
        let kappa = self.wave_number(k);
        let (g, h) = self.forcing(k);
        let lambda = self.root.scale(kappa);
        let (x, x0) = (lambda.scale(radius), lambda.scale(free));
        let [b, b0] = both(x, x0);
        let back = S::one() / radius;
        let at = if near { excess(x) } else { [Complex::zero(); 2] };
        let (wall, known, known_volume) = if near {
            let known = (g * (at[0] + Complex::one())).scale(radius);
            (-self.slip(g, at, x), known, (g * (at[1] + Complex::one())).scale(quarter(radius)))
        } else {
            (less * g, Complex::zero(), Complex::zero())
        };
        let (wall_i, wall_i_size) = added(self.inner(lambda, &b, back));
        let r2 = radius.square();
        if free.value() == 0.0 {
            let c1 = wall / wall_i;
            let volume = c1 * b.i[2].scale(r2) / lambda + known_volume;
            return self.share(kappa, c1 * b.i[1] + known, volume, wall_i_size / size(wall_i));
        }
        let e = exp(x0 - x);
        let tension = -(sigma * sigma * sigma * self.deficit);
        let weight = speed.square() * free;
        let back0 = S::one() / free;
        // I1 normalised at the wall, K1 at the surface
        let [p, q] = self.outer(lambda, &b, back);
        let (wall_k, wall_k_size) = added([p * e, q * e]);
        let [p, q] = self.inner(lambda, &b0, back0);
        let (surface_i, surface_i_size) = added([tension * (b0.i[1] * e), (p * e).scale(weight), (q * e).scale(weight)]);
        let [p, q] = self.outer(lambda, &b0, back0);
        let (surface_k, surface_k_size) = added([tension * b0.k[1], p.scale(weight), q.scale(weight)]);
        let (surface, known_volume) = if near {
            let at0 = excess(x0);
            let pressure = tension * (g * (at0[0] + Complex::one()) + h).scale(free);
            let slip = self.slip(g, at0, x0).scale(weight);
            (-(pressure + slip), known_volume - (g * (at0[1] + Complex::one())).scale(quarter(free)))
        } else {
            (less * g.scale(weight) - tension * h.scale(free), known_volume)
        };
        let det = wall_i * surface_k - wall_k * surface_i;
        let c1 = (wall * surface_k - wall_k * surface) / det;
        let c2 = (wall_i * surface - surface_i * wall) / det;
        let cancel = (wall_i_size * surface_k_size + wall_k_size * surface_i_size) / size(det);
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

    /// The operator of the wall on y_p = g r E(lambda r), which answers the forcing lambda^2 g r.
    fn slip(&self, g: Complex<S>, [first, second]: [Complex<S>; 2], x: Complex<S>) -> Complex<S> {
        g * (self.less * first - (self.sigma * x * x * (second + Complex::one())).scale(S::cst(0.25)))
    }

    /// `c1, c2, c3` of the flow without Bessel functions at `sigma = -2 W`.
    fn logarithmic(&self) -> (S, S, S) {
        let (r2, s2) = (self.cavity.radius.square(), self.cavity.free.square());
        let c1 = (S::one() / s2 - S::one() / r2).scale(0.5);
        (c1, (r2 - s2).scale(0.5), (self.cavity.radius / self.cavity.free).ln())
    }
    /// The share of harmonic k at `sigma = -2 W`, where `P = g r + B/r`.
    fn backward(&self, k: S::Base) -> (Complex<S>, S::Base) {
        let kappa = self.wave_number(k);
        let (g, h) = self.forcing(k);
        if self.cavity.free.value() == 0.0 {
            return self.share(kappa, g.scale(self.cavity.radius), g.scale(self.solid()), S::Base::one());
        }
        let (c1, c2, c3) = self.logarithmic();
        let half = self.cavity.free.scale(0.5);
        let square = kappa.square();
        let b =
            ((g + h).scale(half.scale(4.0)) - g.scale(half * square * c2)).scale(S::one() / (half * (c1 + square * c3) - S::one() / half));
        let radius = self.cavity.radius;
        self.share(kappa, g.scale(radius) + b.scale(S::one() / radius), g.scale(self.solid()) + b.scale(c2), S::Base::one())
    }
    /// All of them: with `kappa = n k` and B = (u + v k^2)/(k^2 (d + e k^2)) the sum needs three series in `1/(k^2 + d/e)`.
    fn backward_sum(&self) -> (Complex<S>, S::Base) {
        let n2 = self.wave_number(S::Base::one()).square();
        let (g, h) = self.forcing(S::Base::one());
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
    #[inline(always)]
    fn bracket(&self, wall: Complex<S>, volume: Complex<S>) -> (Complex<S>, S::Base) {
        ((volume - wall).mul_i().scale(S::cst(2.0)), (size(volume) + size(wall)).scale(2.0 * ROUNDING))
    }

    /// `A k^2` times `(d + e k^2)` of `P = A r` at `sigma = 2 W`, with d and e.
    fn rigid(&self) -> (Complex<S>, S, S) {
        let (r2, s2) = (self.cavity.radius.square(), self.cavity.free.square());
        let (g, h) = self.forcing(S::Base::one());
        if self.cavity.free.value() == 0.0 {
            return (g, S::one(), (self.wave_number(S::Base::one()).square() * r2).scale(0.5));
        }
        let q2 = r2 / s2;
        let e = (self.wave_number(S::Base::one()).square() * (s2 - q2 * r2)).scale(0.5);
        (g.scale(S::one() - q2) - h.scale(S::cst(8.0)), S::cst(9.0) - q2, e)
    }
    /// The share of harmonic k at `sigma = 2 W`, where `P = A r`.
    fn forward(&self, k: S::Base) -> (Complex<S>, S::Base) {
        let (top, d, e) = self.rigid();
        let square = S::constant(k.square());
        let a = top.scale(S::one() / (square * (d + e * square)));
        self.share(self.wave_number(k), a.scale(self.cavity.radius), a.scale(self.solid()), S::Base::one())
    }
    fn forward_sum(&self) -> (Complex<S>, S::Base) {
        let (top, d, e) = self.rigid();
        let [_, s1, s2] = odd_sums(d / e);
        let a = top.scale(S::one() / e);
        let volume = a.scale(self.solid() * s1);
        let wall = a.scale(s2 * self.cavity.radius.square() / self.wave_number(S::Base::one()).square());
        self.bracket(wall, volume)
    }
}

impl<S: Scalar> Series<S> for Flow<S> {
    fn terms(&self, all: &[f64], out: &mut Vec<Term<S>>) {
        side_by_side(self, all, out);
    }
}

impl<S: Scalar> SideBySide<S> for Flow<S> {
    /// Where the unknown is another, and where the free surface lies on the axis.
    fn apart(&self, k: f64) -> bool {
        let Cavity { radius, free, height, .. } = self.cavity;
        let x = value(self.root).abs() * PI * k / height.value() * radius.value();
        // rounding does not decide which unknown it is; NaN is apart
        !(free.value() != 0.0 && x > SURELY * NEAR)
    }
    fn alone(&self, k: f64) -> Term<S> {
        let (term, doubt) = self.single(S::Base::cst(k));
        (term, doubt.value())
    }
    #[inline(always)]
    fn together<L: LaneScalar>(&self, ks: L) -> (Complex<S::Over<L>>, L) {
        self.spread::<L>().harmonic(ks, false)
    }
}

/// Functions of both arguments; none at 0. One loop, so that they are compiled once.
#[inline(always)]
fn both<S: Scalar>(x: Complex<S>, x0: Complex<S>) -> [Bessel<S>; 2] {
    let (all, nothing) = ([x, x0], Bessel { i: [Complex::zero(); 3], k: [Complex::zero(); 3] });
    let mut out = [nothing; 2];
    for i in 0..2 {
        if value(all[i]) != C64::zero() {
            out[i] = bessel(all[i]);
        }
    }
    out
}

/// `r^4/4`.
fn quarter<S: Scalar>(r: S) -> S {
    (r.square() * r.square()).scale(0.25)
}

/// The sum of a few numbers, and of their sizes.
#[inline(always)]
fn added<S: Scalar, const N: usize>(terms: [Complex<S>; N]) -> (Complex<S>, S::Base) {
    let (mut sum, mut sizes) = (Complex::zero(), S::Base::zero());
    for t in terms {
        sum += t;
        sizes += size(t);
    }
    (sum, sizes)
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

#[cfg(test)]
mod tests {
    use super::*;
    use laval_num::complex::c;
    use laval_num::dual::Dual;

    type D = Dual<f64, 1>;

    /// Side by side each harmonic is what it is by itself, with its derivative, whatever its unknown and however many there are.
    #[test]
    fn harmonics_side_by_side_are_those_one_by_one() {
        let cavity = Cavity { radius: 0.14, free: 0.09, height: 0.3, density: 870.0 };
        let lifted = Cavity { radius: D::cst(0.14), free: D::seed(0.09, 0), height: D::cst(0.3), density: D::cst(870.0) };
        for (w, speed) in [(c(50.0, 10.0), 300.0), (c(-290.0, 1e-3), 150.0), (c(900.0, 0.0), 120.0)] {
            let flow = Flow::new(cavity, w, speed);
            let derived = Flow::new(lifted, Complex::cst(w), D::cst(speed));
            let ks: Vec<f64> = (0..37).map(|i| 2.0 * f64::from(i) + 1.0).chain([60.3, 181.7, 944.0]).collect();
            let (mut out, mut slopes) = (Vec::new(), Vec::new());
            flow.terms(&ks, &mut out);
            derived.terms(&ks, &mut slopes);
            assert!(out.len() == ks.len() && slopes.len() == ks.len());
            for ((&k, term), with_slope) in ks.iter().zip(out).zip(slopes) {
                let (alone, doubt) = flow.single(k);
                assert!((term.0 - alone).abs() <= 1e-13 * alone.abs() + term.1 && (term.1 - doubt).abs() <= 1e-6 * doubt, "{w:?} {k}");
                let (one, _) = derived.single(k);
                let (a, b) = (c(one.re.eps[0], one.im.eps[0]), c(with_slope.0.re.eps[0], with_slope.0.im.eps[0]));
                assert!((a - b).abs() <= 1e-11 * a.abs(), "{w:?} {k}: {a:?} {b:?}");
                assert!((value(with_slope.0) - term.0).abs() <= 1e-13 * alone.abs() + term.1, "{w:?} {k}");
            }
        }
    }
}
