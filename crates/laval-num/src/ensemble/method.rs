//! What a one-step method in lanes gives, and the ends of a step that all methods keep.

use super::EnsembleProblem;
use crate::lanes::{Bits, LANES, LaneBits, LaneScalar};

/// Outcome of a step tried in all lanes.
pub(super) struct Attempt<S> {
    pub accepted: LaneBits,
    /// Lanes whose end state is finite.
    pub finite: LaneBits,
    /// Proposed length of the next step over that of this one.
    pub factor: S,
}

/// A one-step method. What holds a right side must be `#[inline(always)]`.
pub(super) trait Method<S: LaneScalar>: Sized {
    /// The root of the method's order.
    fn root(x: S) -> S;
    /// For `n` states, of which the first are so many positions, with the problem's room behind them.
    fn new(n: usize, positions: usize, room: usize) -> Self;
    fn ends(&self) -> &Ends<S>;
    fn ends_mut(&mut self) -> &mut Ends<S>;
    /// Makes all storage of a lane harmless.
    fn clear(&mut self, lane: usize);
    /// Prepares the `fresh` lanes and proposes the length of a first step.
    fn begin<C: EnsembleProblem<S>>(&mut self, problem: &mut C, t0: S, t1: S, fresh: Bits) -> S;
    /// Tries the step of every lane from `t0` to `t1 = t0 + h`.
    fn attempt<C: EnsembleProblem<S>>(&mut self, problem: &mut C, t0: S, t1: S, h: S) -> Attempt<S>;
    /// The interpolant over the step.
    fn dense<C: EnsembleProblem<S>>(&mut self, problem: &mut C);
    /// Makes the end of the step the start of the next in the lanes given.
    fn advance(&mut self, accepted: Bits);
    /// The interpolants of all lanes with both ends of the step, value by value.
    fn interpolants(&self, out: &mut Vec<[f64; LANES]>);
    /// Reads the interpolant of one lane at a time of the step.
    fn eval(interpolant: &[f64], span: (f64, f64), t: f64, y: &mut [f64]);
}

/// Both ends of a step, and the tolerances.
pub(super) struct Ends<S> {
    pub n: usize,
    /// The first states, whose rates are the states behind them.
    pub positions: usize,
    pub relative: Vec<S>,
    pub absolute: Vec<S>,
    /// States at both ends of the step, each with the problem's room behind it.
    pub y0: Vec<S>,
    pub y1: Vec<S>,
}

/// The values of all lanes.
#[inline(always)]
pub(super) fn stored<'a, S: LaneScalar + 'a>(values: impl Iterator<Item = &'a S>, out: &mut Vec<[f64; LANES]>) {
    out.clear();
    for s in values {
        let mut row = [0.0; LANES];
        s.store(&mut row);
        out.push(row);
    }
}

impl<S: LaneScalar> Ends<S> {
    pub fn new(n: usize, positions: usize, room: usize) -> Self {
        let zeros = |len: usize| vec![S::zero(); len];
        Ends { n, positions, relative: zeros(n), absolute: vec![S::one(); n], y0: zeros(n + room), y1: zeros(n + room) }
    }

    /// Puts a member into a lane.
    pub fn seat(&mut self, lane: usize, y: &[f64], relative: &[f64], absolute: &[f64]) {
        self.set_state(lane, y);
        for j in 0..self.n {
            self.relative[j] = self.relative[j].with(lane, relative[j]);
            self.absolute[j] = self.absolute[j].with(lane, absolute[j]);
        }
    }
    pub fn set_state(&mut self, lane: usize, y: &[f64]) {
        for (s, &x) in self.y0.iter_mut().zip(y) {
            *s = s.with(lane, x);
        }
    }
    pub fn state(&self, lane: usize, y: &mut [f64]) {
        for (s, x) in self.y0.iter().zip(y) {
            *x = s.get(lane);
        }
    }
    pub fn clear(&mut self, lane: usize) {
        for s in self.y0.iter_mut().chain(&mut self.y1) {
            *s = s.with(lane, 0.0);
        }
        for s in &mut self.absolute {
            *s = s.with(lane, 1.0);
        }
    }

    /// Length of a first step by one explicit Euler step (Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, section II.4);
    /// leaves the derivative at the start in `f`.
    #[inline(always)]
    pub fn first_step<C: EnsembleProblem<S>, M: Method<S>>(
        &mut self,
        problem: &mut C,
        (t0, t1): (S, S),
        (w, f, g): (&mut [S], &mut [S], &mut [S]),
    ) -> S {
        let n = self.n;
        let mut h0 = S::zero();
        for round in 0..2 {
            // a single place where the right side is inlined
            let state = if round == 0 { &mut self.y0[..] } else { &mut *w };
            problem.time(t0 + h0);
            rates(problem, t0 + h0, self.positions, state, &mut *g);
            if round == 1 {
                break;
            }
            f.copy_from_slice(g);
            h0 = self.euler_step(f, t1 - t0);
            for j in 0..n {
                w[j] = self.y0[j] + h0 * f[j];
            }
        }
        let d1 = self.size(f);
        for j in 0..n {
            w[j] = g[j] - f[j];
        }
        let d2 = self.size(&w[..n]) / h0;
        let d = S::select(d1.lt(d2), d2, d1);
        let floor = S::cst(1e-6);
        let flat = h0.scale(1e-3);
        let flat = S::select(flat.lt(floor), floor, flat);
        let h1 = S::select(d.le(S::cst(1e-15)), flat, M::root(S::cst(0.01) / d));
        let h = S::select(h1.lt(h0.scale(100.0)), h1, h0.scale(100.0));
        let span = t1 - t0;
        let h = S::select(h.lt(span), h, span);
        // a derivative that is not finite stays one
        h + d1.scale(0.0)
    }

    /// Length of an Euler step that changes the state by about a hundredth.
    #[inline(always)]
    fn euler_step(&self, f: &[S], span: S) -> S {
        let (d0, d1, tiny) = (self.size(&self.y0[..self.n]), self.size(f), S::cst(1e-5));
        let small = S::select(d0.lt(tiny), S::one(), S::select(d1.lt(tiny), S::one(), S::zero()));
        let guess = small.select_pos(S::cst(1e-6), (d0 / d1).scale(0.01));
        S::select(guess.lt(span), guess, span)
    }

    /// rms of x over the tolerances at the start.
    #[inline(always)]
    fn size(&self, x: &[S]) -> S {
        let mut sum = S::zero();
        for j in 0..self.n {
            let scale = self.absolute[j] + self.relative[j] * self.y0[j].abs();
            sum += nonzero_ratio(x[j], scale).square();
        }
        (sum / S::cst(self.n.max(1) as f64)).sqrt()
    }

    /// One over the tolerated error of state `j` over the step.
    #[inline(always)]
    pub fn weight(&self, j: usize) -> S {
        let (a, b) = (self.y0[j].abs(), self.y1[j].abs());
        S::one() / (self.absolute[j] + self.relative[j] * S::select(a.lt(b), b, a))
    }
}

/// The rates of all states.
#[inline(always)]
pub(super) fn rates<S: LaneScalar, C: EnsembleProblem<S>>(problem: &mut C, t: S, positions: usize, y: &mut [S], dy: &mut [S]) {
    let (of_positions, others) = dy.split_at_mut(positions);
    problem.rhs(t, y, others);
    of_positions.copy_from_slice(&y[positions..2 * positions]);
}

/// `safety/root(error)` within its bounds; the least for what is not a number.
#[inline(always)]
pub(super) fn bounded<S: LaneScalar>(factor: S, least: f64, most: f64) -> S {
    let (least, most) = (S::cst(least), S::cst(most));
    // NaN takes the least
    let factor = S::select(least.lt(factor), factor, least);
    S::select(factor.lt(most), factor, most)
}

/// `x / scale`, and 0 where `x` is, whatever the scale.
#[inline(always)]
fn nonzero_ratio<S: LaneScalar>(x: S, scale: S) -> S {
    S::select(x.abs().le(S::zero()), S::zero(), x / scale)
}
