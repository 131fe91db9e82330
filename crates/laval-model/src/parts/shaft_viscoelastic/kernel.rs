//! Weakly singular kernels `G(t) = A t^(a-1) exp(-b t)`: their transform, and the sums of exponentials that stand for them in time.
//!
//! ```text
//! K(s) = A Gamma(a) (b + s)^-a = W int_-inf^inf m^(1-a)/(b + m + s) dy,   m = exp(y),   W = A/Gamma(1-a)
//! ```
//!
//! The trapezoid rule with step h turns the integral into exponentials with rates `b + m0 exp(h j)`. Its error falls as `exp(-pi^2/h)` on the imaginary
//! axis, where the nearest pole of the integrand lies a quarter turn away. Its two endless tails are summed: what is slower than m0 acts as one
//! exponential (two moments of m, Gauss), what is faster than the band as one exponential and a constant (three moments of 1/m, Gauss-Radau). Strengths and
//! rates are closed forms of A, a and b, so that they can be differentiated.
//!
//! Theory: `docs/theory/viscoelastic-shafts.md#sum-of-exponentials`.

use laval_num::complex::{C64, Complex, c};
use laval_num::gamma::gamma;
use laval_num::scalar::Scalar;

/// One term `A t^(a-1) exp(-b t)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Term<S = f64> {
    /// A, 1/s^a.
    pub amplitude: S,
    /// a, between 0 and 1.
    pub exponent: S,
    /// b, 1/s.
    pub decay: S,
}

impl<S: Scalar> Term<S> {
    /// K(s), principal branch: cut from -b to the left.
    #[inline(always)]
    pub fn transform(&self, s: Complex<S>) -> Complex<S> {
        let p = s + Complex::real(self.decay);
        let size = self.amplitude * gamma(self.exponent) * (-(self.exponent * p.re.norm2(p.im).ln())).exp();
        Complex::cis(-(self.exponent * p.im.atan2(p.re))).scale(size)
    }
}

impl Term {
    /// K(0): the share of the stiffness that is lost in the long run.
    pub fn relaxed(&self) -> f64 {
        self.transform(C64::zero()).re
    }
    /// The numbers describe a kernel.
    pub fn is_sound(&self) -> bool {
        self.amplitude >= 0.0 && self.exponent > 0.0 && self.exponent < 1.0 && self.decay > 0.0 && self.relaxed().is_finite()
    }
}

/// One exponential of a sum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exponential<S> {
    /// c, 1/s.
    pub strength: S,
    /// lambda, 1/s.
    pub rate: S,
}

/// Rates above the decay of a term: `inner` of them from m0 in steps of h in their logarithm, one below, one above.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ladder {
    first: f64,
    step: f64,
    inner: usize,
}

impl Ladder {
    /// For rates of motion from 0 to `band` with about `quality` e-folds of accuracy.
    fn new(term: &Term, band: f64, quality: f64) -> Self {
        let step = std::f64::consts::PI.powi(2) / quality;
        let first = term.decay * (-quality / (3.0 - term.exponent)).exp();
        let last = (term.decay + band) * (quality / (3.0 + term.exponent)).exp();
        Ladder { first, step, inner: ((last / first).ln() / step).ceil().max(1.0) as usize + 1 }
    }
    /// Number of exponentials.
    pub fn count(&self) -> usize {
        self.inner + 2
    }
    /// `m^power` for the rung `k`.
    #[inline(always)]
    fn rung<S: Scalar>(&self, k: f64, power: S) -> S {
        (power.scale(self.first.ln() + self.step * k)).exp()
    }
    #[inline(always)]
    fn weight<S: Scalar>(&self, term: &Term<S>) -> S {
        term.amplitude.scale(self.step) / gamma(S::one() - term.exponent)
    }
    /// Moments `sum c_j/m_j^(1+i)`, i = 0, 1, 2, of the rungs above the ladder, over the weight.
    #[inline(always)]
    fn above<S: Scalar>(&self, term: &Term<S>) -> [S; 3] {
        let mut moments = [S::zero(); 3];
        for (i, m) in moments.iter_mut().enumerate() {
            let power = -(term.exponent + S::cst(i as f64));
            *m = self.rung(self.inner as f64, power) / (S::one() - power.scale(self.step).exp());
        }
        moments
    }
    /// Sum of `m^power` over the rungs -1, -2, ...
    #[inline(always)]
    fn below<S: Scalar>(&self, power: S) -> S {
        self.rung(-1.0, power) / (S::one() - power.scale(-self.step).exp())
    }
    /// delta: what acts at once.
    #[inline(always)]
    pub fn constant<S: Scalar>(&self, term: &Term<S>) -> S {
        let [m0, m1, m2] = self.above(term);
        self.weight(term) * (m0 - m1 * m1 / m2)
    }
    /// Exponential `k` of [`Ladder::count`], in order of rates.
    #[inline(always)]
    pub fn exponential<S: Scalar>(&self, term: &Term<S>, k: usize) -> Exponential<S> {
        let power = S::one() - term.exponent;
        if k == 0 {
            let (sum, first) = (self.below(power), self.below(power + S::one()));
            return Exponential { strength: self.weight(term) * sum, rate: term.decay + first / sum };
        }
        if k > self.inner {
            let [_, m1, m2] = self.above(term);
            // w/(1 + p x) with x = m2/m1 and w x = m1
            let fast = m1 / m2;
            return Exponential { strength: self.weight(term) * m1 * fast * fast, rate: term.decay + fast };
        }
        let k = (k - 1) as f64;
        Exponential { strength: self.weight(term) * self.rung(k, power), rate: term.decay + S::cst(self.first * (self.step * k).exp()) }
    }
    /// Transform of the sum.
    fn transform(&self, term: &Term, s: C64) -> C64 {
        let each = |k: usize| {
            let e = self.exponential(term, k);
            c(e.strength, 0.0) / (s + c(e.rate, 0.0))
        };
        (0..self.count()).map(each).fold(c(self.constant(term), 0.0), |sum, x| sum + x)
    }
}

/// Most exponentials that a kernel is given.
pub const MOST: usize = 400;

/// The largest error of the exponentials, relative to the dynamic stiffness `1 - K`, for motions with frequencies from 0 to `band` (rad/s): steady ones, and
/// ones that decay with three tenths of their frequency.
pub fn error(terms: &[Term], ladders: &[Ladder], band: f64) -> f64 {
    let lowest = 0.01 * terms.iter().map(|t| t.decay).fold(band, f64::min);
    let decades = (band / lowest).log10();
    let points = (8.0 * decades).ceil().clamp(8.0, 400.0);
    let mut worst = 0.0;
    for k in 0..=points as usize + 1 {
        // the first is rest
        let w = if k == 0 { 0.0 } else { lowest * 10f64.powf(decades * (k - 1) as f64 / points) };
        for s in [c(0.0, w), c(-0.3 * w, w)] {
            let (mut exact, mut fitted) = (c(1.0, 0.0), c(1.0, 0.0));
            for (term, ladder) in terms.iter().zip(ladders) {
                exact -= term.transform(s);
                fitted -= ladder.transform(term, s);
            }
            let e = (fitted - exact).abs() / exact.abs();
            if e > worst || e.is_nan() {
                worst = e;
            }
        }
    }
    worst
}

/// The fewest exponentials that keep the error a third below `accuracy`, so that the parameters may vary a little, with the error measured. `None` where
/// [`MOST`] do not suffice.
pub fn choose(terms: &[Term], accuracy: f64, band: f64) -> Option<(Vec<Ladder>, f64)> {
    if !terms.iter().all(Term::is_sound) {
        return None;
    }
    let mut quality = 1.0;
    loop {
        let ladders: Vec<Ladder> = terms.iter().map(|t| Ladder::new(t, band, quality)).collect();
        if ladders.iter().map(Ladder::count).sum::<usize>() > MOST {
            return None;
        }
        let error = error(terms, &ladders, band);
        if error <= accuracy / 1.5 {
            return Some((ladders, error));
        }
        quality *= 1.06;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TERM: Term = Term { amplitude: 0.008, exponent: 0.15, decay: 0.05 };

    /// The moments of both tails, summed one by one.
    #[test]
    fn tails_are_summed() {
        for exponent in [0.1, 0.5, 0.9] {
            let term = Term { exponent, ..TERM };
            let ladder = Ladder::new(&term, 1e3, 6.0);
            let w = ladder.weight(&term);
            let rung = |k: i32| ladder.first * (ladder.step * f64::from(k)).exp();
            let low = ladder.exponential(&term, 0);
            let sum = |power: f64| (1..4000).map(|k| w * rung(-k).powf(power)).sum::<f64>();
            let (s0, s1) = (sum(1.0 - exponent), sum(2.0 - exponent));
            assert!((low.strength - s0).abs() < 1e-12 * s0 && (low.rate - term.decay - s1 / s0).abs() < 1e-12 * s1 / s0);
            let high = ladder.exponential(&term, ladder.count() - 1);
            let n = ladder.inner as i32;
            let m: Vec<f64> = (0..3).map(|i| (n..n + 4000).map(|k| w * rung(k).powf(-exponent - f64::from(i))).sum()).collect();
            let (c, fast) = (high.strength, high.rate - term.decay);
            let found = [ladder.constant(&term) + c / fast, c / fast.powi(2), c / fast.powi(3)];
            for (f, m) in found.iter().zip(&m) {
                assert!((f - m).abs() < 1e-10 * m, "{exponent}: {found:?} {m:?}");
            }
        }
    }

    /// In time the exponentials are the kernel, from the fastest of the band to ten decay times.
    #[test]
    fn exponentials_are_the_kernel_in_time() {
        for exponent in [0.15, 0.5, 0.8] {
            let term = Term { exponent, ..TERM };
            let (ladders, error) = choose(&[term], 1e-7, 1e4).unwrap();
            assert!(error <= 1e-7 / 1.5);
            for t in [1e-3, 1e-2, 0.1, 1.0, 10.0, 200.0] {
                let kernel = term.amplitude * f64::powf(t, exponent - 1.0) * (-term.decay * t).exp();
                let sum: f64 =
                    (0..ladders[0].count()).map(|k| ladders[0].exponential(&term, k)).map(|e| e.strength * (-e.rate * t).exp()).sum();
                assert!((sum - kernel).abs() < 1e-4 * kernel, "{exponent} {t}: {sum} {kernel}");
            }
        }
    }

    #[test]
    fn accuracy_costs_terms_and_has_a_bound() {
        let count = |accuracy: f64| choose(&[TERM], accuracy, 1e4).map(|l| l.0[0].count());
        let counts = [1e-3, 1e-5, 1e-7, 1e-9].map(|a| count(a).unwrap());
        assert!(counts.windows(2).all(|w| w[0] < w[1]) && counts[1] <= 32 && counts[3] < 120, "{counts:?}");
        assert_eq!(choose(&[Term { decay: 1e-300, ..TERM }], 1e-9, 1e7).map(|l| l.0[0].count()), None);
    }

    /// What is not a number ends the search.
    #[test]
    fn what_is_no_kernel_has_no_ladder() {
        for term in [Term { decay: f64::NAN, ..TERM }, Term { exponent: f64::NAN, ..TERM }, Term { amplitude: f64::NAN, ..TERM }] {
            assert!(!term.is_sound() && choose(&[term], 1e-5, 1e4).is_none(), "{term:?}");
        }
    }
}
