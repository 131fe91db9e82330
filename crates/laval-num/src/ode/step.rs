//! One accepted step and its continuous extension.

use crate::lanes::{Kernel, LANES, LaneScalar, Level, dispatch};

/// An accepted step from `t0` to `t1` (`t1 < t0` when integrating backwards) and the solution between.
///
/// A step that a terminal event cuts short ends at the event.
#[derive(Clone, Copy, Debug)]
pub struct Step<'a> {
    /// Start.
    pub t0: f64,
    /// End.
    pub t1: f64,
    /// State at the start.
    pub y0: &'a [f64],
    /// State at the end.
    pub y1: &'a [f64],
    /// Full length of the step, h.
    pub(super) h: f64,
    /// y = y0 + x (F0 + (1-x) (F1 + x (F2 + (1-x) (F3 + ...)))), x = (t - t0)/h; row after row.
    pub(super) rows: &'a [f64],
}

impl Step<'_> {
    /// The state at `t`, to the order of the method's dense output (7 for [`super::Dop853`], 3 for [`super::Radau`]) inside the step.
    pub fn eval(&self, t: f64, y: &mut [f64]) {
        if t == self.t1 {
            y.copy_from_slice(self.y1);
            return;
        }
        let (n, x) = (self.y0.len(), (t - self.t0) / self.h);
        dispatch(Level::best(), Eval { step: self, x, y: &mut y[..n] });
    }

    /// The derivative of [`Step::eval`] at `t`, one order less accurate than the state.
    pub fn eval_derivative(&self, t: f64, dy: &mut [f64]) {
        let (n, x) = (self.y0.len(), (t - self.t0) / self.h);
        for (j, dy) in dy.iter_mut().enumerate() {
            let (mut value, mut slope) = (0.0, 0.0);
            for (i, row) in self.rows.chunks_exact(n.max(1)).enumerate().rev() {
                let (w, dw) = if i % 2 == 0 { (x, 1.0) } else { (1.0 - x, -1.0) };
                value += row[j];
                slope = slope * w + value * dw;
                value *= w;
            }
            *dy = slope / self.h;
        }
    }
}

/// Some states at a time; all operations are those of single numbers.
struct Eval<'a> {
    step: &'a Step<'a>,
    x: f64,
    y: &'a mut [f64],
}

impl Kernel for Eval<'_> {
    type Out = ();
    #[inline(always)]
    fn run<S: LaneScalar>(self) {
        let Eval { step: Step { y0, rows, .. }, x, y } = self;
        let (n, factors) = (y.len(), [x, 1.0 - x]);
        let count = rows.len() / n.max(1);
        let (blocks, rest) = y.as_chunks_mut::<LANES>();
        let from = blocks.len() * LANES;
        for (k, y) in blocks.iter_mut().enumerate() {
            let mut value = S::cst(0.0);
            for i in (0..count).rev() {
                value = (value + load(rows, i * n + k * LANES)) * S::cst(factors[i % 2]);
            }
            (value + load(y0, k * LANES)).store(y);
        }
        for (j, y) in (from..n).zip(rest) {
            let mut value = 0.0;
            for i in (0..count).rev() {
                value = (value + rows[i * n + j]) * factors[i % 2];
            }
            *y = value + y0[j];
        }
    }
}

#[inline(always)]
fn load<S: LaneScalar>(x: &[f64], from: usize) -> S {
    S::load(&x[from..].as_chunks::<LANES>().0[0])
}
