//! Places for words beside marked points of curves in the plane, off the curves and off each other.

use laval_num::complex::{C64, c};
use std::f64::consts::TAU;

/// Widths and heights of words and of the plane in the smaller of the drawings, pixels.
const SIDE: f64 = 340.0;
const HALF: (f64, f64) = (30.0, 8.0);
/// Distances from the point tried, pixels, and directions.
const GAPS: [f64; 4] = [5.0, 12.0, 22.0, 36.0];
const DIRECTIONS: usize = 24;

/// A rectangle about a place.
struct Frame {
    at: C64,
    half: (f64, f64),
}

impl Frame {
    fn holds(&self, z: C64) -> bool {
        (z.re - self.at.re).abs() < self.half.0 && (z.im - self.at.im).abs() < self.half.1
    }

    fn meets(&self, other: &Frame) -> bool {
        (self.at.re - other.at.re).abs() < self.half.0 + other.half.0 && (self.at.im - other.at.im).abs() < self.half.1 + other.half.1
    }
}

/// Middles of the words at `points`; the plane reaches from `low` to `high`.
pub(super) fn places(points: &[C64], curves: &[Vec<C64>], low: C64, high: C64) -> Vec<C64> {
    let pixel = (high.re - low.re).max(high.im - low.im) / SIDE;
    let half = (HALF.0 * pixel, HALF.1 * pixel);
    let drawn = drawn(curves, half.1);
    let mut frames: Vec<Frame> = Vec::new();
    for &z in points {
        let away = if z.abs() > 0.0 { z.scale(1.0 / z.abs()) } else { c(1.0, 0.0) };
        let tried = GAPS.iter().flat_map(|gap| (0..DIRECTIONS).map(move |k| (*gap, TAU * k as f64 / DIRECTIONS as f64)));
        let scored = tried.map(|(gap, angle)| {
            let d = c(angle.cos(), angle.sin());
            // the edge of the words is this far from the point
            let reach = (half.0 / d.re.abs().max(1e-9)).min(half.1 / d.im.abs().max(1e-9));
            let frame = Frame { at: z + d.scale(reach + gap * pixel), half };
            let over = |f: &Frame| drawn.iter().filter(|p| f.holds(**p)).count() as f64;
            let marks = points.iter().filter(|p| frame.holds(**p)).count() as f64;
            let words = frames.iter().filter(|f| f.meets(&frame)).count() as f64;
            let beyond = frame.at.re - half.0 < low.re
                || frame.at.re + half.0 > high.re
                || frame.at.im - half.1 < low.im
                || frame.at.im + half.1 > high.im;
            let turned = 1.0 - (d.re * away.re + d.im * away.im);
            let score = 10.0 * (over(&frame) + marks) + 100.0 * (words + f64::from(beyond)) + 0.05 * gap + 0.3 * turned;
            (score, frame)
        });
        frames.extend(scored.min_by(|a, b| a.0.total_cmp(&b.0)).map(|s| s.1));
    }
    frames.into_iter().map(|f| f.at).collect()
}

/// Points along the curves no farther apart than this.
fn drawn(curves: &[Vec<C64>], apart: f64) -> Vec<C64> {
    const MOST: f64 = 200.0;
    let mut out = Vec::new();
    for pair in curves.iter().flat_map(|c| c.windows(2)) {
        let way = pair[1] - pair[0];
        let pieces = (way.abs() / apart).ceil().clamp(1.0, MOST);
        out.extend((0..pieces as usize).map(|k| pair[0] + way.scale(k as f64 / pieces)));
    }
    out.extend(curves.iter().filter_map(|c| c.last()));
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    /// On a circle through the axis, as a resonance draws it, and one inside it, every word finds a place off both and off the others.
    #[test]
    fn words_stand_off_the_curves() {
        let circle = |size: f64| -> Vec<C64> {
            (0..=200).map(|k| TAU * f64::from(k) / 200.0).map(|a| c(size * a.sin(), size * (a.cos() - 1.0))).collect()
        };
        let curves = [circle(1.0), circle(0.75)];
        let points: Vec<C64> = (1..9).map(|k| curves[0][20 * k + 10]).collect();
        let (low, high) = (c(-1.3, -2.3), c(1.5, 0.3));
        let all = places(&points, &curves, low, high);
        let pixel = (high.re - low.re) / SIDE;
        let half = (HALF.0 * pixel, HALF.1 * pixel);
        let frames: Vec<Frame> = all.iter().map(|at| Frame { at: *at, half }).collect();
        for (i, f) in frames.iter().enumerate() {
            assert!(curves.iter().flatten().all(|z| !f.holds(*z)), "{i}");
            assert!(frames[..i].iter().all(|g| !f.meets(g)), "{i}");
            // and it is seen which point is meant
            assert!((f.at - points[i]).abs() < 80.0 * pixel, "{i}");
        }
    }
}
