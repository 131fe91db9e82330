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
    /// Whether it is a rate at all.
    pub course: Course,
}

/// The course of an envelope in time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Course {
    /// Its logarithm is straight, or no other course fits better.
    Exponential,
    /// The envelope itself is straight, as at an undamped resonance or of a body that drifts.
    Straight {
        /// Slope, m/s or rad/s.
        slope: f64,
        /// How far slopes over parts of the record differ from it: at least twice the standard error of the fit.
        uncertainty: f64,
    },
    /// It grows, and the slope of its logarithm falls like 1/t.
    Falling {
        /// That slope over the first half of the record used, 1/s.
        first: f64,
        /// Over the second.
        second: f64,
    },
}

/// Share of the squared misfit of an exponential below which another course takes its place.
const BETTER: f64 = 0.25;
/// Relative misfit of one point that is the error of the integration.
const EXACT: f64 = 1e-6;

/// Log-slope of the envelope over the second half of a trajectory. Its points are the largest displacements of half turns of the displacement; of windows,
/// where the displacement keeps its direction through four turns of the spin (each of `turn`, s). `None` when there are fewer than eight.
pub fn growth(windows: &[Window], turn: f64) -> Option<Growth> {
    growth_of(windows, turn, 8)
}

/// As [`growth`], of this many half turns at least (four or more).
pub fn growth_of(windows: &[Window], turn: f64, least: usize) -> Option<Growth> {
    // an integration that ended early leaves the last windows without a value
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
    let (first, second, uncertainty) = spread(&points, rate, error);
    let course = course(&points, (rate, first, second));
    Some(Growth { rate, uncertainty, frequency: (b.angle - a.angle) / (b.last - a.last), from: a.peak.t, course })
}

/// Slopes of both halves, and how far they and twice the standard error are from the slope of all.
fn spread(points: &[(f64, f64)], whole: f64, error: f64) -> (f64, f64, f64) {
    let half = points.len() / 2;
    let (first, second) = (slope(&points[..half]).0, slope(&points[half..]).0);
    let spread = [(first - whole).abs(), (second - whole).abs(), 2.0 * error];
    (first, second, spread.into_iter().fold(0.0, |m: f64, x| if x > m || x.is_nan() { x } else { m }))
}

/// The course of an envelope given by times and logarithms, whose logarithm has these slopes as a whole, in its first and in its second half.
fn course(points: &[(f64, f64)], (rate, first, second): (f64, f64, f64)) -> Course {
    let exact = points.len() as f64 * EXACT * EXACT;
    // misfits of the logarithm; NaN where a course has no value
    let misfit = |of: &dyn Fn(f64) -> f64| exact + points.iter().map(|&(t, x)| (x - of(t)).powi(2)).sum::<f64>();
    let mean = |list: &[(f64, f64)]| {
        let n = list.len() as f64;
        (list.iter().map(|p| p.0).sum::<f64>() / n, list.iter().map(|p| p.1).sum::<f64>() / n)
    };
    let (tm, xm) = mean(points);
    let exponential = misfit(&|t| xm + rate * (t - tm));
    // in units of the largest, which neither over- nor underflows
    let top = points.iter().map(|p| p.1).fold(f64::NEG_INFINITY, f64::max);
    let plain: Vec<(f64, f64)> = points.iter().map(|&(t, x)| (t, (x - top).exp())).collect();
    let (steep, error) = slope(&plain);
    let middle = mean(&plain).1;
    let straight = misfit(&|t| top + (middle + steep * (t - tm)).ln());
    let doubly: Vec<(f64, f64)> = points.iter().map(|&(t, x)| (t.ln(), x)).collect();
    let (power, at) = (slope(&doubly).0, mean(&doubly));
    let power = misfit(&|t| at.1 + power * (t.ln() - at.0));
    if straight < BETTER * exponential && !(power < BETTER * straight) {
        let uncertainty = spread(&plain, steep, error).2;
        return Course::Straight { slope: steep * top.exp(), uncertainty: uncertainty * top.exp() };
    }
    if rate > 0.0 && power < BETTER * exponential {
        return Course::Falling { first, second };
    }
    Course::Exponential
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

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    /// The envelope `amplitude(t)` of a displacement that turns at 100 rad/s, over 2 s.
    fn windows(amplitude: impl Fn(f64) -> f64) -> Vec<Window> {
        let one = |k: u32| {
            let t = 2.0 * f64::from(k + 1) / 400.0;
            Window { peak: Peak { amplitude: amplitude(t), t }, angle: 100.0 * t, last: t }
        };
        (0..400).map(one).collect()
    }

    #[test]
    fn only_an_exponential_has_a_rate() {
        let of = |amplitude: &dyn Fn(f64) -> f64| growth(&windows(amplitude), TAU / 100.0).unwrap();
        for rate in [-3.0, -0.2, 0.2, 8.0] {
            let g = of(&|t| 1e-3 * (rate * t).exp());
            assert!(g.course == Course::Exponential && (g.rate - rate).abs() < 1e-9, "{g:?}");
        }
        // the logarithm of what grows like t has the slopes of an exponential to within their spread
        for (start, speed) in [(0.0, 2e-3), (1e-3, 4e-3), (1e-3, -3e-4)] {
            let g = of(&|t| start + speed * t);
            assert!(g.rate.abs() > 3.0 * g.uncertainty, "{g:?}");
            let Course::Straight { slope, uncertainty } = g.course else { panic!("{g:?}") };
            assert!((slope - speed).abs() < 1e-9 * speed.abs() && uncertainty < 1e-9 * speed.abs(), "{g:?}");
        }
        let g = of(&|t| 1e-3 * t * t);
        let Course::Falling { first, second } = g.course else { panic!("{g:?}") };
        assert!(first > 1.2 * second && second > 0.0, "{g:?}");
        // a ripple of the envelope hides neither
        let ripple = |t: f64| 1.0 + 2e-3 * (37.0 * t).sin();
        assert_eq!(of(&|t| (0.7 * t).exp() * ripple(t)).course, Course::Exponential);
        assert!(matches!(of(&|t| t * ripple(t)).course, Course::Straight { .. }));
    }
}
