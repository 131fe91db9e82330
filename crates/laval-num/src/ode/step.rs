//! One accepted step and its continuous extension.

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
        y.fill(0.0);
        for (i, row) in self.rows.chunks_exact(n.max(1)).enumerate().rev() {
            let w = if i % 2 == 0 { x } else { 1.0 - x };
            for (y, f) in y.iter_mut().zip(row) {
                *y = (*y + f) * w;
            }
        }
        for (y, y0) in y.iter_mut().zip(self.y0) {
            *y += y0;
        }
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
