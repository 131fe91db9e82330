//! One step of the explicit method of order 8 in lanes.

use super::Crew;
use super::method::{Attempt, Ends, Method, bounded};
use crate::lanes::{Bits, LaneBits, LaneScalar};
use crate::ode::tableau::{self as t8, Row};

const STAGES: usize = 16;
const ROWS: usize = 7;
const SAFETY: f64 = 0.9;
const MIN_FACTOR: f64 = 1.0 / 3.0;
const MAX_FACTOR: f64 = 6.0;

/// Storage of the method: states and stages of the members.
pub(super) struct Dop853<S> {
    ends: Ends<S>,
    /// State of a stage, with the crew's room behind it.
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

/// `out = y + h sum_m a_m k_m`.
#[inline(always)]
fn combine<S: LaneScalar, const N: usize>(out: &mut [S], y: &[S], h: S, k: &[S], row: &Row<N>) {
    let n = out.len();
    assert!(y.len() == n && k.len() == STAGES * stride(n));
    // SAFETY: j is below the length of `out` and `y`, and a row names stages below STAGES
    let mut j = 0;
    while j + 2 <= n {
        unsafe {
            let (a, b) = (sum(k, n, row, j), sum(k, n, row, j + 1));
            *out.get_unchecked_mut(j) = *y.get_unchecked(j) + h * a;
            *out.get_unchecked_mut(j + 1) = *y.get_unchecked(j + 1) + h * b;
        }
        j += 2;
    }
    if j < n {
        unsafe { *out.get_unchecked_mut(j) = *y.get_unchecked(j) + h * sum(k, n, row, j) };
    }
}

/// `sum_m a_m k_m` of state `j`.
///
/// # Safety
/// `k` must have STAGES times `n` entries, more than `j` each.
#[inline(always)]
unsafe fn sum<S: LaneScalar, const N: usize>(k: &[S], n: usize, row: &Row<N>, j: usize) -> S {
    // SAFETY: as demanded
    unsafe {
        let n = stride(n);
        let mut s = k.get_unchecked(row[0].0 * n + j).scale(row[0].1);
        for m in 1..N {
            s += k.get_unchecked(row[m].0 * n + j).scale(row[m].1);
        }
        s
    }
}

impl<S: LaneScalar> Dop853<S> {
    /// Stages `from` to `to`, one after the other; a single place where the right side is inlined.
    #[inline(always)]
    fn stages<C: Crew<S>>(&mut self, crew: &mut C, from: usize, to: usize) {
        let (n, h) = (self.ends.n, self.h);
        let (y, k) = (&self.ends.y0[..n], &mut self.k);
        for i in from..=to {
            let state = if i == 12 { &mut self.ends.y1 } else { &mut self.w };
            let w = &mut state[..n];
            let t = if i == 11 || i == 12 { self.t1 } else { self.t0 + h.scale(t8::C[i]) };
            crew.time(t);
            match i {
                1 => combine(w, y, h, k, &t8::A1),
                2 => combine(w, y, h, k, &t8::A2),
                3 => combine(w, y, h, k, &t8::A3),
                4 => combine(w, y, h, k, &t8::A4),
                5 => combine(w, y, h, k, &t8::A5),
                6 => combine(w, y, h, k, &t8::A6),
                7 => combine(w, y, h, k, &t8::A7),
                8 => combine(w, y, h, k, &t8::A8),
                9 => combine(w, y, h, k, &t8::A9),
                10 => combine(w, y, h, k, &t8::A10),
                11 => combine(w, y, h, k, &t8::A11),
                12 => combine(w, y, h, k, &t8::B),
                13 => combine(w, y, h, k, &t8::A13),
                14 => combine(w, y, h, k, &t8::A14),
                _ => combine(w, y, h, k, &t8::A15),
            }
            crew.rhs(t, state, &mut k[i * stride(n)..][..n]);
        }
    }

    /// The error norm of the formula 8(5,3): h e5^2 / sqrt(e5^2 + e3^2/100), and the lanes whose end state is finite.
    #[inline(always)]
    fn error(&self) -> (S, LaneBits) {
        let n = self.ends.n;
        assert!(self.k.len() == STAGES * stride(n));
        let inverse_h = S::one() / self.h;
        let (mut e5, mut e3, mut finite) = (S::zero(), S::zero(), S::zero());
        for j in 0..n {
            let (y0, y1) = (self.ends.y0[j], self.ends.y1[j]);
            let inverse = self.ends.weight(j);
            // SAFETY: asserted
            let (x5, x3) = unsafe { (sum(&self.k, n, &t8::E5, j), (y1 - y0) * inverse_h - sum(&self.k, n, &t8::BHH, j)) };
            e5 += (x5 * inverse).square();
            e3 += (x3 * inverse).square();
            finite += y1.scale(0.0);
        }
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

    fn new(n: usize, room: usize) -> Self {
        let zeros = |len: usize| vec![S::zero(); len];
        Dop853 {
            ends: Ends::new(n, room),
            w: zeros(n + room),
            k: zeros(STAGES * stride(n)),
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
    fn begin<C: Crew<S>>(&mut self, crew: &mut C, t0: S, t1: S, fresh: Bits) -> S {
        let n = self.ends.n;
        let (f, g) = self.rows.split_at_mut(n);
        let h = self.ends.first_step::<C, Self>(crew, (t0, t1), (&mut self.w, f, &mut g[..n]));
        for j in 0..n {
            self.k[j] = super::lanes_of(fresh, f[j], self.k[j]);
        }
        h
    }

    #[inline(always)]
    fn attempt<C: Crew<S>>(&mut self, crew: &mut C, t0: S, t1: S, h: S) -> Attempt<S> {
        (self.t0, self.t1, self.h) = (t0, t1, h);
        self.stages(crew, 1, 12);
        let (error, finite) = self.error();
        let accepted = S::bits(error.lt(S::one()));
        let factor = bounded(S::cst(SAFETY) / Self::root(error), MIN_FACTOR, MAX_FACTOR);
        Attempt { accepted: LaneBits(accepted.0 & finite.0), finite, factor }
    }

    /// The interpolant of order 7 over the step.
    #[inline(always)]
    fn dense<C: Crew<S>>(&mut self, crew: &mut C) {
        let (n, h) = (self.ends.n, self.h);
        self.stages(crew, 13, 15);
        for j in 0..n {
            let (f0, f1, d) = (h * self.k[j], h * self.k[12 * stride(n) + j], self.ends.y1[j] - self.ends.y0[j]);
            self.rows[j] = d;
            self.rows[n + j] = f0 - d;
            self.rows[2 * n + j] = d - f1 - (f0 - d);
        }
        self.w.fill(S::zero());
        combine(&mut self.rows[3 * n..4 * n], &self.w[..n], h, &self.k, &t8::D3);
        combine(&mut self.rows[4 * n..5 * n], &self.w[..n], h, &self.k, &t8::D4);
        combine(&mut self.rows[5 * n..6 * n], &self.w[..n], h, &self.k, &t8::D5);
        combine(&mut self.rows[6 * n..7 * n], &self.w[..n], h, &self.k, &t8::D6);
    }

    /// The lane's interpolant and its ends, to be read at several times: y0, y1, rows.
    fn extract(&self, lane: usize, out: &mut [f64]) {
        for (x, s) in out.iter_mut().zip(self.ends.y0[..self.ends.n].iter().chain(&self.ends.y1[..self.ends.n]).chain(&self.rows)) {
            *x = s.get(lane);
        }
    }
    /// Length of what [`Dop853::extract`] fills.
    fn extract_len(n: usize) -> usize {
        (2 + ROWS) * n
    }
    /// Reads an extract: y = y0 + x (F0 + (1-x) (F1 + x (F2 + ...))), x = (t - t0)/(t1 - t0).
    fn eval(extract: &[f64], (t0, t1): (f64, f64), t: f64, y: &mut [f64]) {
        let n = y.len();
        if t == t1 {
            y.copy_from_slice(&extract[n..2 * n]);
            return;
        }
        let x = (t - t0) / (t1 - t0);
        y.fill(0.0);
        for i in (0..ROWS).rev() {
            let w = if i % 2 == 0 { x } else { 1.0 - x };
            for (y, f) in y.iter_mut().zip(&extract[(2 + i) * n..(3 + i) * n]) {
                *y = (*y + f) * w;
            }
        }
        for (y, y0) in y.iter_mut().zip(&extract[..n]) {
            *y += y0;
        }
    }

    /// Makes the end of the step the start of the next in the lanes given.
    #[inline(always)]
    fn advance(&mut self, accepted: Bits) {
        let n = self.ends.n;
        if accepted == Bits::MAX {
            std::mem::swap(&mut self.ends.y0, &mut self.ends.y1);
            self.k.copy_within(12 * stride(n)..12 * stride(n) + n, 0);
            return;
        }
        for j in 0..n {
            self.ends.y0[j] = super::lanes_of(accepted, self.ends.y1[j], self.ends.y0[j]);
            self.k[j] = super::lanes_of(accepted, self.k[12 * stride(n) + j], self.k[j]);
        }
    }
}
