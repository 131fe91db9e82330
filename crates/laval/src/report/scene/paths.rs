//! Curves as points: pieces of them, gaps, angles without jumps, smooth paths with their start and direction.

use super::ARROW;
use super::axes::extent;

/// Steps between two points of a smooth path, and its most points for them.
const SMOOTH: usize = 4;
const MOST_SMOOTH: usize = 2000;

/// The start of a path, and an arrowhead where it has gone half its size: shape, meaning, place.
pub(super) fn ends(points: &[(f64, f64)]) -> Vec<(usize, &'static str, (f64, f64))> {
    let known: Vec<(f64, f64)> = points.iter().copied().filter(|p| p.0.is_finite() && p.1.is_finite()).collect();
    let Some(&start) = known.first() else { return Vec::new() };
    let span = |f: &dyn Fn(&(f64, f64)) -> f64| extent(known.iter().map(f), false).map_or(0.0, |(a, b)| b - a);
    let size = span(&|p| p.0).max(span(&|p| p.1));
    let mut out = vec![(0, "start", start)];
    let mut gone = 0.0;
    for w in known.windows(2) {
        let (dx, dy) = (w[1].0 - w[0].0, w[1].1 - w[0].1);
        gone += dx.hypot(dy);
        if gone > 0.5 * size && size > 0.0 {
            let degrees = dy.atan2(dx).to_degrees().rem_euclid(360.0).round() as usize % 360;
            out.push((ARROW + degrees, "direction", w[1]));
            break;
        }
    }
    out
}

/// The curve of Catmull and Rom through the points of a path.
pub(super) fn smooth(points: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    if points.len() < 3 || points.len() > MOST_SMOOTH {
        return points;
    }
    let mut out = Vec::with_capacity(SMOOTH * points.len());
    for k in 0..points.len() - 1 {
        let (a, b) = (points[k], points[k + 1]);
        // beside a gap the curve ends straight
        let finite = |p: &(f64, f64)| p.0.is_finite() && p.1.is_finite();
        let before = k.checked_sub(1).map(|i| points[i]).filter(finite).unwrap_or(a);
        let after = points.get(k + 2).copied().filter(finite).unwrap_or(b);
        for j in 0..SMOOTH {
            let t = j as f64 / SMOOTH as f64;
            let at = |p: f64, a: f64, b: f64, q: f64| {
                a + 0.5 * t * ((b - p) + t * ((2.0 * p - 5.0 * a + 4.0 * b - q) + t * (3.0 * (a - b) + q - p)))
            };
            out.push(if j == 0 { a } else { (at(before.0, a.0, b.0, after.0), at(before.1, a.1, b.1, after.1)) });
        }
    }
    out.extend(points.last());
    out
}

/// Adds whole periods to the values of the rows, so that none jumps by more than half of one. Of two ways that are as long the one is taken that stays nearer to
/// where a resonance that lags leads: from zero to minus half a period.
pub(super) fn unwrap(values: &mut [f64], rows: &[usize], period: f64) {
    let mut before = f64::NAN;
    for &i in rows {
        let v = values[i];
        if !v.is_finite() {
            continue;
        }
        if before.is_finite() {
            let turns = ((before - v) / period).round();
            let near = v + turns * period;
            let other = if near > before { near - period } else { near + period };
            let tie = ((near - before).abs() - (other - before).abs()).abs() < 1e-3 * period;
            let home = |x: f64| (x + 0.25 * period).abs();
            values[i] = if tie && home(other) < home(near) { other } else { near };
        }
        before = values[i];
    }
}

/// The points of the rows, with a gap before each that begins anew.
pub(super) fn pieces_of(rows: &[usize], at: impl Fn(usize) -> (f64, f64), begins: Option<&[bool]>) -> Vec<(f64, f64)> {
    let gap = |i: usize| begins.is_some_and(|b| b[i]).then_some((f64::NAN, f64::NAN));
    rows.iter().flat_map(|&i| gap(i).into_iter().chain([at(i)])).collect()
}

/// Pieces whose both ends are flagged, and the others, each broken by NaN where the other takes over.
#[allow(clippy::type_complexity)]
pub(super) fn split(
    rows: &[usize],
    at: impl Fn(usize) -> (f64, f64),
    solid: &[bool],
    begins: Option<&[bool]>,
) -> (Vec<(f64, f64)>, Vec<(f64, f64)>) {
    let mut out = [Vec::new(), Vec::new()];
    let mut current = None;
    for w in rows.windows(2) {
        if begins.is_some_and(|b| b[w[1]]) {
            current = None;
            continue;
        }
        let side = usize::from(!(solid[w[0]] && solid[w[1]]));
        if current != Some(side) {
            if !out[side].is_empty() {
                out[side].push((f64::NAN, f64::NAN));
            }
            out[side].push(at(w[0]));
            current = Some(side);
        }
        out[side].push(at(w[1]));
    }
    let [full, dashed] = out;
    (full, dashed)
}
