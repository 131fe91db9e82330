//! Growing roots beyond the frequency up to which modes are sought: the rest of the right half plane, as far as roots of a polynomial can lie.
//!
//! The degree of `det T(s)` is at most the sum of the highest powers of s in its rows. A square about zero that holds as many roots by their count holds all of them.

use super::Determinant;
use super::region::Piece;
use laval_num::contour::{NOISE, Region, missing};

/// Half the side of the square, over the frequency of an unknown by itself; factor to the next one, and how many are tried.
const FIRST: f64 = 4.0;
const WIDER: f64 = 8.0;
const TRIES: usize = 4;
/// Highest over lowest frequency of a rectangle.
const STEP: f64 = 4.0;
/// Growth over the size of the largest root that is rounding.
const ROUNDING: f64 = 1e-12;

/// The right half plane beyond a frequency in rectangles.
pub(super) struct Beyond {
    pub pieces: Vec<Piece>,
    /// No root is larger.
    pub reach: f64,
}

/// Rectangles that hold all roots that grow faster than the margin and are not below the frequency, by growth and frequency, and the evaluations it took. `None` where no bound of
/// the roots is proven.
pub(super) fn beyond(f: &mut Determinant, (margin, frequency): (f64, f64), mirrored: bool, budget: u64) -> (Option<Beyond>, u64) {
    let mut evaluations = 0;
    let Some((degree, size)) = bound(f) else { return (None, 0) };
    let mut reach = FIRST * size.max(frequency);
    for _ in 0..TRIES {
        f.scale_for(reach);
        let low = if mirrored { 0.0 } else { -reach };
        let square = Region { re: (-reach, reach), im: (low, reach), mirrored, reach: &|_| f64::INFINITY, noise: NOISE };
        let (count, spent) = missing(&mut *f, &square, &[], budget);
        evaluations += spent;
        if count == Some(degree) {
            return (Some(Beyond { pieces: pieces((margin, frequency), reach, mirrored), reach }), evaluations);
        }
        reach *= WIDER;
    }
    (None, evaluations)
}

/// The largest degree that the determinant can have, and the size of the fastest unknown by itself.
fn bound(f: &Determinant) -> Option<(i64, f64)> {
    let terms = f.t.as_polynomial()?.each_ref().map(|all| f.of.taken(all));
    let pattern = f.of.inner.pattern();
    let (mut degree, mut size) = (0, 0.0f64);
    for i in 0..pattern.n() {
        let power = (0..3).rev().find(|&k| pattern.row(i).any(|(e, _)| terms[k][e].abs() > 0.0))?;
        degree += power as i64;
        let own = |k: usize| pattern.index(i, i).map_or(0.0, |e| terms[k][e].abs());
        let of = |x: f64| if x.is_finite() { x } else { 0.0 };
        size = size.max(match power {
            2 => of((own(0) / own(2)).sqrt()).max(of(own(1) / own(2))),
            1 => of(own(0) / own(1)),
            _ => 0.0,
        });
    }
    Some((degree, size))
}

fn pieces((margin, frequency): (f64, f64), reach: f64, mirrored: bool) -> Vec<Piece> {
    let low = if mirrored { 0.0 } else { -frequency };
    let mut out = vec![Piece { growth: (margin.max(frequency), reach), band: (low, frequency), bare: false }];
    let growth = (margin.max(ROUNDING * reach), reach);
    let mut from = frequency;
    while from < reach {
        let to = if STEP * from < reach { STEP * from } else { reach };
        out.push(Piece { growth, band: (from, to), bare: false });
        if !mirrored {
            out.push(Piece { growth, band: (-to, -from), bare: false });
        }
        from = to;
    }
    out.retain(|p| p.growth.1 > p.growth.0);
    out
}
