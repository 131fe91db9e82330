//! One step of the Rosenbrock method Rodas5P in lanes: implicit, order 5, stiffly accurate, L-stable; no iteration, so that lanes never wait for
//! one another.
//!
//! ```text
//! (1/(g h) - J) k_s = f(t + c_s h, y + sum_m a_sm k_m) + (1/h) sum_m c_sm k_m + h d_s f_t,     y1 = y + sum_m a_8m k_m + k_8,   error k_8
//! y(t + x h) = (1 - x) y0 + x (y1 + (1 - x) (K1 + x (K2 + x K3))),   K_i = sum_m h_im k_m
//! ```
//!
//! J and f_t are differences, forward in the states and of second order in time.
//!
//! Source: G. Steinebach, Construction of Rosenbrock-Wanner method Rodas5P and numerical benchmarks within the Julia Differential Equations
//! package, BIT Numer. Math. 63 (2023) 27.

use super::EnsembleProblem;
use super::method::{Attempt, Ends, Method, bounded, rates, stored};
use crate::lanes::{Bits, LANES, LaneBits, LaneScalar};

const STAGES: usize = 8;
const SAFETY: f64 = 0.9;
const MIN_FACTOR: f64 = 0.2;
const MAX_FACTOR: f64 = 6.0;

const GAMMA: f64 = 0.21193756319429014;
const C: [f64; STAGES] = [0.0, 0.6358126895828704, 0.4095798393397535, 0.9769306725060716, 0.4288403609558664, 1.0, 1.0, 1.0];
/// d_s; those of the last stages are zero.
const D: [f64; 5] = [0.21193756319429014, -0.42387512638858027, -0.3384627126235924, 1.8046452872882734, 2.325825639765069];
/// a_sm of the stages 2 to 6; those of the stages 7 and 8 are those of the stage 6 followed by ones.
const A: [[f64; 5]; 5] = [
    [3.0, 0.0, 0.0, 0.0, 0.0],
    [2.849394379747939, 0.45842242204463923, 0.0, 0.0, 0.0],
    [-6.954028509809101, 2.489845061869568, -10.358996098473584, 0.0, 0.0],
    [2.8029986275628964, 0.5072464736228206, -0.3988312541770524, -0.04721187230404641, 0.0],
    [-7.502846399306121, 2.561846144803919, -11.627539656261098, -0.18268767659942256, 0.030198172008377946],
];
/// c_sm of the stages 2 to 8.
const COUPLING: [[f64; 7]; 7] = [
    [-14.155112264123755, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [-17.97296035885952, -2.859693295451294, 0.0, 0.0, 0.0, 0.0, 0.0],
    [147.12150275711716, -1.41221402718213, 71.68940251302358, 0.0, 0.0, 0.0, 0.0],
    [165.43517024871676, -0.4592823456491126, 42.90938336958603, -5.961986721573306, 0.0, 0.0, 0.0],
    [24.854864614690072, -3.0009227002832186, 47.4931110020768, 5.5814197821558125, -0.6610691825249471, 0.0, 0.0],
    [30.91273214028599, -3.1208243349937974, 77.79954646070892, 34.28646028294783, -19.097331116725623, -28.087943162872662, 0.0],
    [
        37.80277123390563,
        -3.2571969029072276,
        112.26918849496327,
        66.9347231244047,
        -40.06618937091002,
        -54.66780262877968,
        -9.48861652309627,
    ],
];
/// h_im of the interpolant.
const H: [[f64; STAGES]; 3] = [
    [
        25.948786856663858,
        -2.5579724845846235,
        10.433815404888879,
        -2.3679251022685204,
        0.524948541321073,
        1.1241088310450404,
        0.4272876194431874,
        -0.17202221070155493,
    ],
    [
        -9.91568850695171,
        -0.9689944594115154,
        3.0438037242978453,
        -24.495224566215796,
        20.176138334709044,
        15.98066361424651,
        -6.789040303419874,
        -6.710236069923372,
    ],
    [
        11.419903575922262,
        2.8879645146136994,
        72.92137995996029,
        80.12511834622643,
        -52.072871366152654,
        -59.78993625266729,
        -0.15582684282751913,
        4.883087185713722,
    ],
];

/// Step of the difference in time over that of the method.
const MOMENT: f64 = 0.01;
/// Root of the rounding: step of a difference over the size of the state.
const NUDGE: f64 = 1.4901161193847656e-8;
/// Size of a state nothing is known of.
const LEAST_SIZE: f64 = 1e-30;

/// Storage of the method.
pub(super) struct Rodas<S: LaneScalar> {
    ends: Ends<S>,
    /// State of a call of the right side, with the problem's room behind it, and what it gives.
    w: Vec<S>,
    f: Vec<S>,
    /// Right side at the start, derivative in time.
    f0: Vec<S>,
    ft: Vec<S>,
    /// 1/(g h) - J row by row, then its factors with inverse pivots; the last state comes first, because the states that few others read stand
    /// last.
    matrix: Vec<S>,
    /// For each pivot and each row below it, whether the two were exchanged.
    exchanged: Vec<S::Mask>,
    /// Stage after stage.
    k: Vec<S>,
    /// K1, K2, K3.
    rows: Vec<S>,
    h: S,
}

/// What a call of the right side is for.
enum Call {
    Start,
    /// Derivative in a state.
    State(usize),
    /// Derivative in time, first and second value.
    Soon,
    Later,
    Stage(usize),
}

impl<S: LaneScalar> Rodas<S> {
    fn call(&self, i: usize) -> Call {
        let n = self.ends.n;
        match i {
            0 => Call::Start,
            i if i <= n => Call::State(i - 1),
            i if i == n + 1 => Call::Soon,
            i if i == n + 2 => Call::Later,
            i => Call::Stage(i - n - 2),
        }
    }

    /// Writes the state of a call to `w`.
    #[inline(always)]
    fn prepare(&mut self, call: &Call) {
        let n = self.ends.n;
        let (w, y0) = (&mut self.w[..n], &self.ends.y0[..n]);
        match *call {
            Call::Start | Call::Soon | Call::Later => w.copy_from_slice(y0),
            Call::State(j) => {
                if j > 0 {
                    w[j - 1] = y0[j - 1];
                }
                let typical = self.ends.absolute[j] / self.ends.relative[j];
                let mut size = larger((self.h * self.f0[j]).abs(), y0[j].abs());
                // a state without relative tolerance has no typical size
                size = S::select(typical.lt(S::cst(f64::INFINITY)), larger(typical, size), size);
                w[j] = y0[j] + larger(size, S::cst(LEAST_SIZE)).scale(NUDGE);
            }
            Call::Stage(s) if s < 6 => {
                for j in 0..n {
                    let mut x = y0[j];
                    for (m, &a) in A[s - 1][..s].iter().enumerate() {
                        x += self.k[m * n + j].scale(a);
                    }
                    w[j] = x;
                }
            }
            // the state of the stage before is still there
            Call::Stage(s) => {
                for j in 0..n {
                    w[j] += self.k[(s - 1) * n + j];
                }
            }
        }
    }

    /// Takes what the right side gave.
    #[inline(always)]
    fn take(&mut self, call: &Call) {
        let n = self.ends.n;
        match *call {
            Call::Start => self.f0.copy_from_slice(&self.f),
            Call::State(j) => {
                let inverse = S::one() / (self.w[j] - self.ends.y0[j]);
                for i in 0..n {
                    self.matrix[(n - 1 - i) * n + n - 1 - j] = -((self.f[i] - self.f0[i]) * inverse);
                }
                let own = S::one() / self.h.scale(GAMMA);
                self.matrix[(n - 1 - j) * (n + 1)] += own;
            }
            Call::Soon => {
                for i in 0..n {
                    self.ft[i] = self.f[i].scale(4.0) - self.f0[i].scale(3.0);
                }
            }
            Call::Later => {
                let inverse = S::one() / self.h.scale(2.0 * MOMENT);
                for i in 0..n {
                    self.ft[i] = (self.ft[i] - self.f[i]) * inverse;
                }
                self.factor();
                self.f.copy_from_slice(&self.f0);
                self.stage(0);
            }
            Call::Stage(s) => self.stage(s),
        }
    }

    /// Solves for a stage.
    #[inline(always)]
    fn stage(&mut self, s: usize) {
        let n = self.ends.n;
        let inverse = S::one() / self.h;
        for i in 0..n {
            let mut x = self.f[i];
            if s > 0 {
                let mut sum = S::zero();
                for (m, &c) in COUPLING[s - 1][..s].iter().enumerate() {
                    sum += self.k[m * n + i].scale(c);
                }
                x += sum * inverse;
            }
            if let Some(&d) = D.get(s) {
                x += (self.h * self.ft[i]).scale(d);
            }
            self.f[i] = x;
        }
        self.solve();
        self.k[s * n..(s + 1) * n].copy_from_slice(&self.f);
    }

    /// Elimination with partial pivoting, in each lane its own.
    #[inline(always)]
    fn factor(&mut self) {
        let n = self.ends.n;
        let mut pair = 0;
        for p in 0..n {
            let (above, below) = self.matrix.split_at_mut((p + 1) * n);
            let pivot = &mut above[p * n..];
            for row in below.chunks_exact_mut(n) {
                let mask = pivot[p].abs().lt(row[p].abs());
                self.exchanged[pair] = mask;
                pair += 1;
                if S::bits(mask).any() {
                    for (a, b) in pivot[p..].iter_mut().zip(&mut row[p..]) {
                        (*a, *b) = (S::select(mask, *b, *a), S::select(mask, *a, *b));
                    }
                }
            }
            pivot[p] = S::one() / pivot[p];
            for row in below.chunks_exact_mut(n) {
                let factor = row[p] * pivot[p];
                row[p] = factor;
                if S::bits(factor.abs().le(S::zero())).all() {
                    continue;
                }
                for (b, a) in row[p + 1..].iter_mut().zip(&pivot[p + 1..]) {
                    *b -= factor * *a;
                }
            }
        }
    }

    /// Solves in place of `f`.
    #[inline(always)]
    fn solve(&mut self) {
        let (n, b) = (self.ends.n, &mut self.f);
        b.reverse();
        let mut pair = 0;
        for p in 0..n {
            for i in p + 1..n {
                let mask = self.exchanged[pair];
                pair += 1;
                if S::bits(mask).any() {
                    (b[p], b[i]) = (S::select(mask, b[i], b[p]), S::select(mask, b[p], b[i]));
                }
            }
            let x = b[p];
            for i in p + 1..n {
                b[i] -= self.matrix[i * n + p] * x;
            }
        }
        for p in (0..n).rev() {
            let row = &self.matrix[p * n..(p + 1) * n];
            let mut x = b[p];
            for (a, b) in row[p + 1..].iter().zip(&b[p + 1..]) {
                x -= *a * *b;
            }
            b[p] = x * row[p];
        }
        b.reverse();
    }

    /// rms of the last stage over the tolerances, and the lanes whose end state is finite.
    #[inline(always)]
    fn error(&self) -> (S, LaneBits) {
        let n = self.ends.n;
        let (mut sum, mut finite) = (S::zero(), S::zero());
        for j in 0..n {
            let e = self.k[(STAGES - 1) * n + j];
            // 0/0 is no error
            sum += S::select(e.abs().le(S::zero()), S::zero(), e * self.ends.weight(j)).square();
            finite += self.ends.y1[j].scale(0.0);
        }
        ((sum / S::cst(n.max(1) as f64)).sqrt(), finite.finite())
    }
}

impl<S: LaneScalar> Method<S> for Rodas<S> {
    #[inline(always)]
    fn root(x: S) -> S {
        x.pow_pos(0.2)
    }

    fn new(n: usize, positions: usize, room: usize) -> Self {
        let zeros = |len: usize| vec![S::zero(); len];
        Rodas {
            ends: Ends::new(n, positions, room),
            w: zeros(n + room),
            f: zeros(n),
            f0: zeros(n),
            ft: zeros(n),
            matrix: zeros(n * n),
            exchanged: vec![S::zero().lt(S::zero()); n * n.saturating_sub(1) / 2],
            k: zeros(STAGES * n),
            rows: zeros(3 * n),
            h: S::one(),
        }
    }

    fn ends(&self) -> &Ends<S> {
        &self.ends
    }
    fn ends_mut(&mut self) -> &mut Ends<S> {
        &mut self.ends
    }
    fn clear(&mut self, lane: usize) {
        self.ends.clear(lane);
    }

    #[inline(always)]
    fn begin<C: EnsembleProblem<S>>(&mut self, problem: &mut C, t0: S, t1: S, _: Bits) -> S {
        self.ends.first_step::<C, Self>(problem, (t0, t1), (&mut self.w, &mut self.f0, &mut self.f))
    }

    #[inline(always)]
    fn attempt<Cr: EnsembleProblem<S>>(&mut self, problem: &mut Cr, t0: S, t1: S, h: S) -> Attempt<S> {
        self.h = h;
        let n = self.ends.n;
        // a single place where the right side is inlined
        for i in 0..n + 2 + STAGES {
            let call = self.call(i);
            let t = match call {
                Call::Start | Call::State(_) => t0,
                Call::Soon => t0 + h.scale(MOMENT),
                Call::Later => t0 + h.scale(2.0 * MOMENT),
                Call::Stage(s) if s < 5 => t0 + h.scale(C[s]),
                Call::Stage(_) => t1,
            };
            self.prepare(&call);
            if !matches!(call, Call::State(_)) {
                problem.time(t);
            }
            rates(problem, t, self.ends.positions, &mut self.w, &mut self.f);
            self.take(&call);
        }
        for j in 0..n {
            self.ends.y1[j] = self.w[j] + self.k[(STAGES - 1) * n + j];
        }
        let (error, finite) = self.error();
        let accepted = S::bits(error.lt(S::one()));
        // what is not finite stays so in the factor
        let factor = bounded(S::cst(SAFETY) / Self::root(error) + error.scale(0.0), MIN_FACTOR, MAX_FACTOR);
        Attempt { accepted: LaneBits(accepted.0 & finite.0), finite, factor }
    }

    #[inline(always)]
    fn dense<Cr: EnsembleProblem<S>>(&mut self, _: &mut Cr) {
        let n = self.ends.n;
        for (row, h) in self.rows.chunks_exact_mut(n.max(1)).zip(&H) {
            for (j, x) in row.iter_mut().enumerate() {
                let mut sum = S::zero();
                for (m, &c) in h.iter().enumerate() {
                    sum += self.k[m * n + j].scale(c);
                }
                *x = sum;
            }
        }
    }

    #[inline(always)]
    fn interpolants(&self, out: &mut Vec<[f64; LANES]>) {
        let n = self.ends.n;
        stored(self.ends.y0[..n].iter().chain(&self.ends.y1[..n]).chain(&self.rows), out);
    }
    fn eval(interpolant: &[f64], (t0, t1): (f64, f64), t: f64, y: &mut [f64]) {
        let n = y.len();
        if t == t1 {
            y.copy_from_slice(&interpolant[n..2 * n]);
            return;
        }
        let x = (t - t0) / (t1 - t0);
        for (j, y) in y.iter_mut().enumerate() {
            let [y0, y1, k1, k2, k3] = std::array::from_fn(|i| interpolant[i * n + j]);
            *y = (1.0 - x) * y0 + x * (y1 + (1.0 - x) * (k1 + x * (k2 + x * k3)));
        }
    }

    #[inline(always)]
    fn advance(&mut self, accepted: Bits) {
        for j in 0..self.ends.n {
            self.ends.y0[j] = super::lanes_of(accepted, self.ends.y1[j], self.ends.y0[j]);
        }
    }
}

/// The larger; `b` where `a` is not a number.
#[inline(always)]
fn larger<S: LaneScalar>(a: S, b: S) -> S {
    S::select(b.lt(a), a, b)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ensemble::{Ended, Leg, Seat};
    use crate::lanes::{Kernel, LANES, Level, dispatch};

    /// y' = -2 t y^2: y = 1/(1 + t^2).
    struct Bell;
    impl<S: LaneScalar> EnsembleProblem<S> for Bell {
        fn dim(&self) -> usize {
            1
        }
        fn time(&mut self, _: S) {}
        #[inline(always)]
        fn rhs(&mut self, t: S, y: &mut [S], dy: &mut [S]) {
            dy[0] = -((t * y[0] * y[0]).scale(2.0));
        }
        fn load(&mut self, _: usize, _: Seat) -> Option<Leg> {
            None
        }
        fn ended(&mut self, _: usize, _: &Ended, _: &mut [f64]) -> Option<Leg> {
            None
        }
    }

    /// Errors of one step at its end and in its middle, and the estimate.
    struct OneStep(f64);
    impl Kernel for OneStep {
        type Out = [f64; 3];
        #[inline(always)]
        fn run<S: LaneScalar>(self) -> [f64; 3] {
            let (t0, h) = (0.3, self.0);
            let exact = |t: f64| 1.0 / (1.0 + t * t);
            let mut r = Rodas::<S>::new(1, 0, 0);
            r.ends_mut().seat(0, &[exact(t0)], &[1e-9], &[1e-9]);
            let attempt = r.attempt(&mut Bell, S::cst(t0), S::cst(t0 + h), S::cst(h));
            assert!(attempt.finite.get(0));
            r.dense(&mut Bell);
            let mut interpolants = Vec::new();
            r.interpolants(&mut interpolants);
            let first: Vec<f64> = interpolants.iter().map(|of_lanes| of_lanes[0]).collect();
            let error = |t: f64| {
                let mut y = [0.0];
                Rodas::<S>::eval(&first, (t0, t0 + h), t, &mut y);
                y[0] - exact(t)
            };
            [error(t0 + h), error(t0 + 0.4 * h), r.k[STAGES - 1].get(0)].map(f64::abs)
        }
    }

    /// Local errors fall as h^6, those of the interpolant and the estimate as h^5.
    #[test]
    fn the_orders_are_five_and_four() {
        let of = |h: f64| dispatch(Level::best(), OneStep(h));
        let (a, b) = (of(0.05), of(0.025));
        let order: Vec<f64> = a.iter().zip(&b).map(|(a, b)| (a / b).log2()).collect();
        // at these steps exact derivatives give 5.75, 4.85 and 4.27; the limits need more digits
        let expected = [5.75, 4.85, 4.27];
        assert!(order.iter().zip(expected).all(|(o, e)| (o - e).abs() < 0.1), "{order:?}: {a:?} {b:?}");
    }

    /// Matrices of which some lanes require exchanges and others do not.
    struct Solve;
    impl Kernel for Solve {
        type Out = ();
        #[inline(always)]
        fn run<S: LaneScalar>(self) {
            let n = 7;
            let mut r = Rodas::<S>::new(n, 0, 0);
            let entry = |i: usize, j: usize, lane: usize| {
                let x = ((i * 31 + j * 17 + lane * 13 + i * j * lane) % 23) as f64 - 11.0;
                // odd lanes have zeros on the diagonal
                if i == j { if lane % 2 == 1 { 0.0 } else { x + 40.0 } } else { x }
            };
            for i in 0..n {
                for j in 0..n {
                    r.matrix[(n - 1 - i) * n + n - 1 - j] = S::from_array(std::array::from_fn(|lane| entry(i, j, lane)));
                }
                r.f[i] = S::from_array(std::array::from_fn(|lane| 1.0 + (i * lane % 5) as f64));
            }
            let b: Vec<[f64; LANES]> = r.f.iter().map(|x| x.to_array()).collect();
            r.factor();
            r.solve();
            for lane in 0..LANES {
                for i in 0..n {
                    let sum: f64 = (0..n).map(|j| entry(i, j, lane) * r.f[j].get(lane)).sum();
                    assert!((sum - b[i][lane]).abs() < 1e-11, "{lane} {i}: {sum} {}", b[i][lane]);
                }
            }
        }
    }

    #[test]
    fn lanes_pivot_on_their_own() {
        Level::supported().for_each(|level| dispatch(level, Solve));
    }
}
