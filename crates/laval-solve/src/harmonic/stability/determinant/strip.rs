//! How many exponents of a motion grow: zeros of Hill's determinant ([`super`]) in one strip, counted by the argument principle.
//!
//! `D(s) = h(s) prod_n det Y(s + i n w)`, and `h = det(1 + G (T - S))` repeats with w and tends to one far to the right: on the upper and the lower edge of the strip it turns by the
//! same, on the right one by nothing. What the product turns by on these three edges is what one order alone turns by on the three outer sides of the rectangle that
//! all orders together make up:
//!
//! ```text
//! 2 pi (growing exponents) = turn of det Y around (below, right, above) - turn of D along the margin, upwards, over one base frequency
//! ```
//!
//! Along the margin it is D itself that is followed: of h alone a zero and a pole on both sides of the margin would hide each other.

use super::{BELOW, Hill, reach};
use laval_num::complex::{C64, c};
use laval_num::contour::turned;
use std::f64::consts::TAU;

/// Most evaluations along one path.
const BUDGET: u64 = 50_000;
/// By how much of a turn the turns may differ from whole ones: orders that are left out.
const WHOLE: f64 = 0.02;
/// Width of the rectangle over the highest frequency.
const WIDTH: f64 = 2.0;
/// Frequency, over the highest, at which nothing but masses is felt.
const FAR: f64 = 1e3;

/// Right of all roots of one order: growth below this, 1/s.
fn top(hill: &mut Hill) -> Option<f64> {
    let far = FAR * hill.fastest;
    let (_, [g, _]) = hill.order(c(0.0, far), true)?;
    let stiffest = hill.reference.iter().enumerate().map(|(k, s)| (s * g[(k, k)].abs()).sqrt() * far).fold(0.0, f64::max);
    Some(WIDTH * hill.fastest.max(stiffest)).filter(|t| t.is_finite())
}

/// Number of zeros in a strip right of the margin; `None` where it could not be determined with these orders.
pub(super) fn count(hill: &mut Hill, margin: f64) -> Option<i64> {
    let domains = hill.domains.clone();
    let (speed, width, orders) = (hill.speed, hill.base.abs(), hill.orders as f64);
    let right = top(hill)?;
    // real multipliers, which lie at multiples of half the base frequency, are not at its ends
    let low = -BELOW * width;
    let (below, above) = (low - orders * width, low + (orders + 1.0) * width);
    let alone = |s: C64| reach(&domains, speed, None, s);
    let around = [c(margin, below), c(right, below), c(right, above), c(margin, above)];
    let outer = turned(|s| hill.alone(s), &around, &alone, BUDGET)?;
    let together = |s: C64| reach(&domains, speed, Some(width), s);
    let inner = turned(|s| hill.at(s, true), &[c(margin, low), c(margin, low + width)], &together, BUDGET)?;
    let turns = (outer - inner) / TAU;
    ((turns - turns.round()).abs() <= WHOLE).then(|| turns.round() as i64)
}
