//! The envelope of a motion: its largest displacements, window by window, and the rate at which it grows.

use serde::{Deserialize, Serialize};
use std::f64::consts::{FRAC_PI_2, PI};

/// Largest displacement of a body.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Peak {
    /// |x + i y| from rest, m.
    pub amplitude: f64,
    /// When, s.
    pub t: f64,
}

/// One window of the envelope of a body.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Window {
    /// Largest displacement from rest in it; NaN when nothing was computed there.
    pub peak: Peak,
    /// Angle the displacement vector has turned through since the start, at `last`, rad.
    pub angle: f64,
    /// Last time seen in it.
    pub last: f64,
}

/// Rate of an exponential envelope.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Growth {
    /// Growth rate, 1/s.
    pub rate: f64,
    /// How far slopes over parts of the record differ from it, 1/s: at least twice the standard error of the fit.
    pub uncertainty: f64,
    /// Mean angular velocity of the displacement vector, rad/s; negative turns against the axis.
    pub frequency: f64,
    /// Start of the record used, s.
    pub from: f64,
}

/// Log-slope of the envelope over the second half of a trajectory. Its points are the largest displacements of half turns of the displacement; of windows,
/// where the displacement keeps its direction through four turns of the spin (each of `turn`, s). `None` when there are fewer than eight.
pub fn growth(windows: &[Window], turn: f64) -> Option<Growth> {
    growth_of(windows, turn, 8)
}

/// As [`growth`], of this many half turns at least (four or more).
pub fn growth_of(windows: &[Window], turn: f64, least: usize) -> Option<Growth> {
    // long steps of a machine that does not move yet leave windows without a value
    let filled = windows.iter().rposition(|w| w.last.is_finite()).map_or(0, |k| k + 1);
    let used: Vec<&Window> =
        windows[filled / 2..filled].iter().filter(|w| w.peak.amplitude > 0.0 && w.peak.amplitude.is_finite()).collect();
    let (a, b) = (*used.first()?, *used.last()?);
    let mut peaks: Vec<Peak> = Vec::new();
    if (b.angle - a.angle).abs() < FRAC_PI_2 && b.last - a.last > 4.0 * turn {
        peaks.extend(used.iter().map(|w| w.peak));
    } else {
        let (mut begun, mut largest) = (a.angle, Peak::default());
        for w in &used {
            if w.peak.amplitude > largest.amplitude {
                largest = w.peak;
            }
            if (w.angle - begun).abs() >= PI {
                peaks.push(largest);
                (begun, largest) = (w.angle, Peak::default());
            }
        }
    }
    if peaks.len() < least.max(4) {
        return None;
    }
    let points: Vec<(f64, f64)> = peaks.iter().map(|p| (p.t, p.amplitude.ln())).collect();
    let (rate, error) = slope(&points);
    let half = points.len() / 2;
    let (first, second) = (slope(&points[..half]).0, slope(&points[half..]).0);
    let spread = [(first - rate).abs(), (second - rate).abs(), 2.0 * error]
        .into_iter()
        .fold(0.0, |m: f64, x| if x > m || x.is_nan() { x } else { m });
    Some(Growth { rate, uncertainty: spread, frequency: (b.angle - a.angle) / (b.last - a.last), from: a.peak.t })
}

/// Least-squares slope and its standard error.
fn slope(points: &[(f64, f64)]) -> (f64, f64) {
    let n = points.len() as f64;
    let (tm, xm) = (points.iter().map(|p| p.0).sum::<f64>() / n, points.iter().map(|p| p.1).sum::<f64>() / n);
    let (mut stt, mut stx) = (0.0, 0.0);
    for (t, x) in points {
        stt += (t - tm) * (t - tm);
        stx += (t - tm) * (x - xm);
    }
    let k = stx / stt;
    let rest: f64 = points.iter().map(|(t, x)| (x - xm - k * (t - tm)).powi(2)).sum();
    (k, (rest / ((n - 2.0).max(1.0) * stt)).sqrt())
}
