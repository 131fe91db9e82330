//! What of the motion of bodies counts as motion: the displacement of every point where something is attached or that is named, and the tilt.

use super::station::Pair;
use laval_num::complex::C64;
use laval_num::scalar::Scalar;
use serde::{Deserialize, Serialize};

/// What a probe measures.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Sight {
    /// Displacement of the body's point at this height above its reference point, m.
    Displacement(f64),
    /// Tilt.
    Tilt,
}

/// A pair of components that is measured of a body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Probe {
    /// Index in [`stations`](super::system::System::stations).
    pub station: usize,
    /// Name of the body.
    pub name: String,
    /// What it measures.
    pub sight: Sight,
    /// Significant digits of the height that distinguish the points of this body.
    pub digits: usize,
    /// The body bends: no point of it is its reference.
    pub flexible: bool,
    /// Both components over the coordinates.
    pub rows: Pair,
}

impl Probe {
    /// The displacement of a [station](super::station::Station).
    pub fn is_reference(&self) -> bool {
        match self.sight {
            Sight::Displacement(z) => self.flexible || z == 0.0,
            Sight::Tilt => false,
        }
    }
    /// Height of the point, where its name holds it: not of the reference point of a rigid body.
    pub fn height(&self) -> Option<f64> {
        match self.sight {
            Sight::Displacement(z) if self.flexible || z != 0.0 => Some(z),
            _ => None,
        }
    }
    /// The displacement of the point at this height.
    pub fn is_at(&self, height: f64) -> bool {
        matches!(self.sight, Sight::Displacement(z) if same_height(z, height))
    }
    /// It measures the tilt.
    pub fn is_tilt(&self) -> bool {
        self.sight == Sight::Tilt
    }
    /// SI unit.
    pub fn unit(&self) -> &'static str {
        if self.is_tilt() { "rad" } else { "m" }
    }
    /// A typical size, for comparisons with rounding only.
    pub fn typical(&self) -> f64 {
        if self.is_tilt() { 1e-2 } else { 1e-3 }
    }
    /// Both components at these coordinates.
    pub fn of(&self, q: &[f64]) -> [f64; 2] {
        self.rows.of(q)
    }
    /// The same in scalars.
    pub fn scaled<S: Scalar>(&self, q: &[S]) -> [S; 2] {
        self.rows.scaled(q)
    }
    /// Both components of amplitudes.
    pub fn amplitudes(&self, q: &[C64]) -> [C64; 2] {
        self.rows.amplitudes(q)
    }
}

/// Equal to the rounding of a conversion between units: "235.1 mm" and "0.2351 m".
pub(super) fn same_height(a: f64, b: f64) -> bool {
    (a - b).abs() <= 4.0 * f64::EPSILON * a.abs().max(b.abs())
}

/// The fewest significant digits, at least four, to which no two of these sorted heights are equal; 17 tell all numbers apart.
pub(super) fn distinct_digits(heights: &[f64]) -> usize {
    let rounded = |z: f64, digits: usize| format!("{z:.*e}", digits - 1);
    let distinct = |digits: &usize| heights.windows(2).all(|w| rounded(w[0], *digits) != rounded(w[1], *digits));
    (4..17).find(distinct).unwrap_or(17)
}

#[cfg(test)]
mod tests {
    use super::*;
    /// Points of one body are named apart, however close they are.
    #[test]
    fn digits_tell_heights_apart() {
        for (heights, digits) in [(&[][..], 4), (&[-0.2, 0.1], 4), (&[-0.23512, -0.23508], 5), (&[0.1, 0.1 + 1e-12], 12)] {
            assert_eq!(distinct_digits(heights), digits, "{heights:?}");
        }
        assert!(same_height(0.3, 0.1 + 0.2) && same_height(235.1 * 1e-3, 0.2351) && !same_height(0.3, 0.3 + 1e-14));
    }
}
