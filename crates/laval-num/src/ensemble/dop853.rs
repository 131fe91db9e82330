//! One step of the explicit method of order 8 in lanes.

use super::EnsembleProblem;
use super::method::{Attempt, Ends, Method, bounded, stored};
use crate::lanes::{Bits, LANES, LaneBits, LaneScalar};
use crate::ode::nystrom::{self as pairs, Pair};
use crate::ode::tableau::C;

const STAGES: usize = 16;
const ROWS: usize = 7;
const SAFETY: f64 = 0.9;
const MIN_FACTOR: f64 = 1.0 / 3.0;
const MAX_FACTOR: f64 = 6.0;

/// Storage of the method: states and stages of the members.
pub(super) struct Dop853<S> {
    ends: Ends<S>,
    /// State of a stage, with the problem's room behind it.
    w: Vec<S>,
    /// Stage after stage; stage 12 is f at the end of the step.
    k: Vec<S>,
    /// Rows of the interpolant, see [`Dop853::eval`].
    rows: Vec<S>,
    t0: S,
    t1: S,
    h: S,
}

/// Distance of the stages in storage: odd, so that no two of them lie a multiple of 4096 bytes apart, which a processor takes for one place.
#[inline(always)]
fn stride(n: usize) -> usize {
    n | 1
}

/// What rates give: `y + h sum_m a_m k_m`; of positions `y + h c v + h^2 sum_m b_m k_m`.
struct Stage<'a, S> {
    y: &'a [S],
    h: S,
    k: &'a [S],
    positions: usize,
    c: f64,
}

impl<S: LaneScalar> Stage<'_, S> {
    #[inline(always)]
    fn state<const N: usize>(&self, out: &mut [S], row: &Pair<N>) {
        let (n, p, y, h) = (self.y.len(), self.positions, self.y, self.h);
        let others = n - p;
        assert!(out.len() == n && self.k.len() == STAGES * stride(others) && p <= others);
        // SAFETY: the indices stay below the lengths asserted, and a row names stages below STAGES
        unsafe {
            for j in 0..p {
                let (v, q) = both(self.k, others, row, j);
                let velocity = *y.get_unchecked(p + j);
                *out.get_unchecked_mut(p + j) = velocity + h * v;
                *out.get_unchecked_mut(j) = *y.get_unchecked(j) + h * (velocity.scale(self.c) + h * q);
            }
            for j in p..others {
                *out.get_unchecked_mut(p + j) = *y.get_unchecked(p + j) + h * both(self.k, others, row, j).0;
            }
        }
    }
}

/// `sum_m a_m k_m` and `sum_m b_m k_m` of the rate `j`.
///
/// # Safety
/// `k` must have STAGES times `stride(n)` entries, and `j` be below `n`.
#[inline(always)]
unsafe fn both<S: LaneScalar, const N: usize>(k: &[S], n: usize, row: &Pair<N>, j: usize) -> (S, S) {
    // SAFETY: as demanded
    unsafe {
        let n = stride(n);
        let first = *k.get_unchecked(row[0].0 * n + j);
        let (mut a, mut b) = (first.scale(row[0].1), first.scale(row[0].2));
        for m in 1..N {
            let x = *k.get_unchecked(row[m].0 * n + j);
            if row[m].1 != 0.0 {
                a += x.scale(row[m].1);
            }
            if row[m].2 != 0.0 {
                b += x.scale(row[m].2);
            }
        }
        (a, b)
    }
}

/// Squares of both errors over the tolerances, and zero or NaN for the states at the end.
struct Sums<S> {
    e5: S,
    e3: S,
    finite: S,
}

impl<S: LaneScalar> Sums<S> {
    #[inline(always)]
    fn add(&mut self, x5: S, x3: S, inverse: S, end: S) {
        self.e5 += (x5 * inverse).square();
        self.e3 += (x3 * inverse).square();
        self.finite += end.scale(0.0);
    }
}

impl<S: LaneScalar> Dop853<S> {
    /// Stages `from` to `to`, one after the other; a single place where the right side is inlined.
    #[inline(always)]
    fn stages<C: EnsembleProblem<S>>(&mut self, problem: &mut C, from: usize, to: usize) {
        let (n, h, positions) = (self.ends.n, self.h, self.ends.positions);
        let others = n - positions;
        for i in from..=to {
            let state = if i == 12 { &mut self.ends.y1 } else { &mut self.w };
            let t = if i == 11 || i == 12 { self.t1 } else { self.t0 + h.scale(C[i]) };
            // the end of the step has the time of the stage before it
            if i != 12 {
                problem.time(t);
            }
            let from = Stage { y: &self.ends.y0[..n], h, k: &self.k, positions, c: C[i] };
            let w = &mut state[..n];
            match i {
                1 => from.state(w, &pairs::P1),
                2 => from.state(w, &pairs::P2),
                3 => from.state(w, &pairs::P3),
                4 => from.state(w, &pairs::P4),
                5 => from.state(w, &pairs::P5),
                6 => from.state(w, &pairs::P6),
                7 => from.state(w, &pairs::P7),
                8 => from.state(w, &pairs::P8),
                9 => from.state(w, &pairs::P9),
                10 => from.state(w, &pairs::P10),
                11 => from.state(w, &pairs::P11),
                12 => from.state(w, &pairs::P12),
                13 => from.state(w, &pairs::P13),
                14 => from.state(w, &pairs::P14),
                _ => from.state(w, &pairs::P15),
            }
            problem.rhs(t, state, &mut self.k[i * stride(others)..][..others]);
        }
    }

    /// The error norm of the formula 8(5,3): h e5^2 / sqrt(e5^2 + e3^2/100), and the lanes whose end state is finite.
    #[inline(always)]
    fn error(&self) -> (S, LaneBits) {
        let (n, p, h) = (self.ends.n, self.ends.positions, self.h);
        let others = n - p;
        assert!(self.k.len() == STAGES * stride(others) && p <= others);
        let mut sums = Sums { e5: S::zero(), e3: S::zero(), finite: S::zero() };
        // SAFETY: asserted
        unsafe {
            for j in 0..p {
                let ((v5, q5), (v3, q3)) = (both(&self.k, others, &pairs::E5, j), both(&self.k, others, &pairs::E3, j));
                sums.add(v5, v3, self.ends.weight(p + j), self.ends.y1[p + j]);
                sums.add(q5, q3, h * self.ends.weight(j), self.ends.y1[j]);
            }
            for j in p..others {
                let (x5, x3) = (both(&self.k, others, &pairs::E5, j).0, both(&self.k, others, &pairs::E3, j).0);
                sums.add(x5, x3, self.ends.weight(p + j), self.ends.y1[p + j]);
            }
        }
        let Sums { e5, e3, finite } = sums;
        let norm = self.h * e5 / ((e5 + e3.scale(0.01)).scale(n as f64)).sqrt();
        // 0/0 is no error; a NaN of the states stays
        let norm = S::select(e5.le(S::zero()), S::zero(), norm);
        (norm, finite.finite())
    }
}

impl<S: LaneScalar> Method<S> for Dop853<S> {
    #[inline(always)]
    fn root(x: S) -> S {
        x.sqrt().sqrt().sqrt()
    }

    fn new(n: usize, positions: usize, room: usize) -> Self {
        let zeros = |len: usize| vec![S::zero(); len];
        Dop853 {
            ends: Ends::new(n, positions, room),
            w: zeros(n + room),
            k: zeros(STAGES * stride(n - positions)),
            rows: zeros(ROWS * n),
            t0: S::zero(),
            t1: S::one(),
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
        for s in self.k.iter_mut().chain(&mut self.rows) {
            *s = s.with(lane, 0.0);
        }
    }

    /// Derivative at the start of the `fresh` lanes, and the length of a first step.
    #[inline(always)]
    fn begin<C: EnsembleProblem<S>>(&mut self, problem: &mut C, t0: S, t1: S, fresh: Bits) -> S {
        let (n, p) = (self.ends.n, self.ends.positions);
        let (f, g) = self.rows.split_at_mut(n);
        let h = self.ends.first_step::<C, Self>(problem, (t0, t1), (&mut self.w, f, &mut g[..n]));
        for j in 0..n - p {
            self.k[j] = super::lanes_of(fresh, f[p + j], self.k[j]);
        }
        h
    }

    #[inline(always)]
    fn attempt<C: EnsembleProblem<S>>(&mut self, problem: &mut C, t0: S, t1: S, h: S) -> Attempt<S> {
        (self.t0, self.t1, self.h) = (t0, t1, h);
        self.stages(problem, 1, 12);
        let (error, finite) = self.error();
        let accepted = S::bits(error.lt(S::one()));
        let factor = bounded(S::cst(SAFETY) / Self::root(error), MIN_FACTOR, MAX_FACTOR);
        Attempt { accepted: LaneBits(accepted.0 & finite.0), finite, factor }
    }

    /// The interpolant of order 7 over the step.
    #[inline(always)]
    fn dense<C: EnsembleProblem<S>>(&mut self, problem: &mut C) {
        self.stages(problem, 13, 15);
        let (n, p, h) = (self.ends.n, self.ends.positions, self.h);
        let end = 12 * stride(n - p);
        for j in 0..n {
            let (y0, y1) = (&self.ends.y0, &self.ends.y1);
            let (f0, f1) = if j < p { (y0[p + j], y1[p + j]) } else { (self.k[j - p], self.k[end + j - p]) };
            let (f0, f1, d) = (h * f0, h * f1, y1[j] - y0[j]);
            self.rows[j] = d;
            self.rows[n + j] = f0 - d;
            self.rows[2 * n + j] = d - f1 - (f0 - d);
        }
        self.w.fill(S::zero());
        // these rows sum to zero
        let from = Stage { y: &self.w[..n], h, k: &self.k, positions: p, c: 0.0 };
        from.state(&mut self.rows[3 * n..4 * n], &pairs::D3);
        from.state(&mut self.rows[4 * n..5 * n], &pairs::D4);
        from.state(&mut self.rows[5 * n..6 * n], &pairs::D5);
        from.state(&mut self.rows[6 * n..7 * n], &pairs::D6);
    }

    /// y0, y1, rows.
    #[inline(always)]
    fn interpolants(&self, out: &mut Vec<[f64; LANES]>) {
        let n = self.ends.n;
        stored(self.ends.y0[..n].iter().chain(&self.ends.y1[..n]).chain(&self.rows), out);
    }
    /// y = y0 + x (F0 + (1-x) (F1 + x (F2 + ...))), x = (t - t0)/(t1 - t0).
    fn eval(interpolant: &[f64], (t0, t1): (f64, f64), t: f64, y: &mut [f64]) {
        let n = y.len();
        if t == t1 {
            y.copy_from_slice(&interpolant[n..2 * n]);
            return;
        }
        let x = (t - t0) / (t1 - t0);
        y.fill(0.0);
        for i in (0..ROWS).rev() {
            let w = if i % 2 == 0 { x } else { 1.0 - x };
            for (y, f) in y.iter_mut().zip(&interpolant[(2 + i) * n..(3 + i) * n]) {
                *y = (*y + f) * w;
            }
        }
        for (y, y0) in y.iter_mut().zip(&interpolant[..n]) {
            *y += y0;
        }
    }

    /// Makes the end of the step the start of the next in the lanes given.
    #[inline(always)]
    fn advance(&mut self, accepted: Bits) {
        let n = self.ends.n;
        let others = n - self.ends.positions;
        let end = 12 * stride(others);
        if accepted == Bits::MAX {
            std::mem::swap(&mut self.ends.y0, &mut self.ends.y1);
            self.k.copy_within(end..end + others, 0);
            return;
        }
        for j in 0..n {
            self.ends.y0[j] = super::lanes_of(accepted, self.ends.y1[j], self.ends.y0[j]);
        }
        for j in 0..others {
            self.k[j] = super::lanes_of(accepted, self.k[end + j], self.k[j]);
        }
    }
}
