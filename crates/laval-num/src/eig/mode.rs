//! A mode, its normalisation and order.

use super::number::{inner, norm2};
use crate::complex::{C64, c};
use serde::{Deserialize, Serialize};

/// An eigenvalue with its right and left vectors and the evidence for them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Mode {
    /// Eigenvalue s = growth + i frequency.
    pub value: C64,
    /// Right vector, Euclidean norm one, the first of its largest components real and positive.
    pub right: Vec<C64>,
    /// Left vector (`y^H A = s y^H`), Euclidean norm one.
    pub left: Vec<C64>,
    /// Backward error: the size of the relative change of the matrices for which value and vectors would be exact,
    /// the larger of right and left, in the scaled coordinates.
    pub residual: f64,
    /// First-order change of the value per relative change of the matrices (in the scaled coordinates, in the unit of the value);
    /// infinite for a defective eigenvalue.
    pub sensitivity: f64,
}

impl Mode {
    /// First-order estimate of the error of the value: sensitivity times backward error (at least one rounding). At a defective
    /// eigenvalue of order k the true error grows as the k-th root instead, and this estimate is larger still.
    pub fn error(&self) -> f64 {
        let r = if self.residual < f64::EPSILON { f64::EPSILON } else { self.residual };
        self.sensitivity * r
    }
    /// The conjugate mode of a real problem.
    pub fn conj(&self) -> Mode {
        let conj = |v: &[C64]| v.iter().map(|z| z.conj()).collect();
        Mode { value: self.value.conj(), right: conj(&self.right), left: conj(&self.left), ..*self }
    }
    /// Scales both vectors as described in the module; `derivative_x` is the vector whose product `y^H ..` becomes real and not negative.
    pub(super) fn normalise(&mut self, derivative_x: impl Fn(&[C64]) -> Vec<C64>) {
        let n = norm2(&self.right);
        let size = |z: &C64| z.scale(1.0 / n).norm_sqr();
        let largest = self.right.iter().map(size).fold(0.0, f64::max);
        // Components equal to rounding count as equal, so that the choice does not depend on the last bit.
        let lead = self.right.iter().find(|z| size(z) >= largest * (1.0 - 2e-8)).copied().unwrap_or(c(1.0, 0.0));
        turn(&mut self.right, lead, n);
        let n = norm2(&self.left);
        let product = inner(&derivative_x(&self.right), &self.left);
        turn(&mut self.left, product, n);
    }
}

/// `v *= conj(phase of lead) / n`.
fn turn(v: &mut [C64], lead: C64, n: f64) {
    let a = lead.abs();
    let phase = if a > 0.0 { lead.conj().scale(1.0 / a) } else { c(1.0, 0.0) };
    if n > 0.0 {
        for z in v {
            *z = (*z * phase).scale(1.0 / n);
        }
    }
}

/// Sorts by frequency, then growth; for a real problem `modes` holds Im s >= 0 only and the conjugates are added.
pub(super) fn sorted(mut modes: Vec<Mode>, real: bool) -> Vec<Mode> {
    modes.sort_by(|a, b| order(&a.value, &b.value));
    if !real {
        return modes;
    }
    let mut all = Vec::with_capacity(2 * modes.len());
    for m in modes {
        let conj = (m.value.im > 0.0).then(|| m.conj());
        all.push(m);
        all.extend(conj);
    }
    all
}

/// |Im|, then Re, then the sign of Im (positive first).
pub(super) fn order(a: &C64, b: &C64) -> std::cmp::Ordering {
    a.im.abs().total_cmp(&b.im.abs()).then(a.re.total_cmp(&b.re)).then(b.im.total_cmp(&a.im))
}

/// The modes with Im s >= 0: one of each conjugate pair and the real ones.
pub fn upper_half(modes: &[Mode]) -> Vec<Mode> {
    modes.iter().filter(|m| m.value.im >= 0.0).cloned().collect()
}
