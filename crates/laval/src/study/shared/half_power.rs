//! Amplification factor of a peak by its width at half power: `AF = Nc/(N2 - N1)`, where the amplitude is 1/sqrt(2) of the peak at N1 and N2 (API 684, SP6.8.2.1).

use crate::model::probe::Probe;
use crate::solve::extremum::{BESIDE, Search};
use crate::solve::linear_response::Response;
use laval_num::univariate::root;

/// Relative uncertainty of a half-power point.
const TOLERANCE: f64 = 1e-12;

/// Where the amplitude of a probe has fallen to 1/sqrt(2) of a peak (place, amplitude) on both sides, between responses by rising places.
pub fn of_responses(peak: (f64, f64), responses: &[Response], sight: &Probe, search: &mut Search) -> [f64; 2] {
    let samples: Vec<(f64, f64)> = responses.iter().map(|r| (r.speed, r.size(sight))).collect();
    let level = peak.1 / std::f64::consts::SQRT_2;
    sides(peak, &samples, |a, b| {
        let (low, high) = (a.0.min(b.0), a.0.max(b.0));
        let first = samples.partition_point(|s| s.0 < low).saturating_sub(BESIDE);
        let last = (samples.partition_point(|s| s.0 <= high) + BESIDE).min(samples.len());
        let smooth = search.level(&responses[first..last], [a, b], sight, level);
        smooth
            .or_else(|| root(|x| search.at(x, sight).map(|a| a - level), (a.0, a.1 - level), (b.0, b.1 - level), TOLERANCE * peak.0.abs()))
    })
}

/// Where the amplitude has fallen to 1/sqrt(2) of a peak (place, amplitude) on both sides, solved for between two samples (rising places); NaN on a side where it does not fall so far, is
/// not known, or rises above the peak before.
fn sides(peak: (f64, f64), samples: &[(f64, f64)], mut between: impl FnMut((f64, f64), (f64, f64)) -> Option<f64>) -> [f64; 2] {
    let level = peak.1 / std::f64::consts::SQRT_2;
    let beyond = samples.partition_point(|s| s.0 <= peak.0);
    let mut side = |points: &mut dyn Iterator<Item = &(f64, f64)>| {
        let mut before = peak;
        for &here in points {
            if here.1 <= level {
                return between(before, here).unwrap_or(f64::NAN);
            }
            if !(here.1 <= peak.1 * (1.0 + 1e-9)) {
                return f64::NAN;
            }
            before = here;
        }
        f64::NAN
    };
    [side(&mut samples[..beyond].iter().rev()), side(&mut samples[beyond..].iter())]
}

/// Position between the last two places, from the last, at which the slope at the end is read.
const END: f64 = 1e-3;

/// Last places on both sides of a peak (place, amplitude) up to which the amplitude stays above 1/sqrt(2) of it, where no half-power point is found: the ends of the responses. NaN on a
/// side with such a point, where the amplitude rises above the peak, falls to half power between two responses, or is not known at one of the `gaps`.
pub fn ends(peak: (f64, f64), points: [f64; 2], responses: &[Response], gaps: &[f64], sight: &Probe, search: &mut Search) -> [f64; 2] {
    let samples: Vec<(f64, f64)> = responses.iter().map(|r| (r.speed, r.size(sight))).collect();
    let level = peak.1 / std::f64::consts::SQRT_2;
    let beyond = samples.partition_point(|s| s.0 <= peak.0);
    let mut side = |above: bool| -> Option<f64> {
        let (from, to) = if above { (beyond, samples.len()) } else { (0, beyond) };
        let of = samples.get(from..to).filter(|of| !of.is_empty())?;
        let (end, before) = match above {
            true => (*samples.last()?, *samples.get(samples.len().checked_sub(2)?)?),
            false => (*samples.first()?, *samples.get(1)?),
        };
        let within = |s: &(f64, f64)| s.1 > level && s.1 <= peak.1 * (1.0 + 1e-9);
        let unknown = gaps.iter().any(|g| !((g - peak.0) * (g - end.0) > 0.0));
        if !of.iter().all(within) || unknown {
            return None;
        }
        for k in from.max(1)..to.min(samples.len() - 1) {
            if samples[k].1 <= samples[k - 1].1 && samples[k].1 <= samples[k + 1].1 {
                let first = (k - 1).saturating_sub(BESIDE);
                let around = &responses[first..(k + 2 + BESIDE).min(responses.len())];
                search.extremum(around, k - first, sight, false).filter(|lowest| lowest.1 > level)?;
            }
        }
        // the last response may lie behind a minimum
        if end.1 < before.1 {
            search.at(end.0 + END * (before.0 - end.0), sight).filter(|x| *x >= end.1)?;
        }
        Some(end.0)
    };
    [0, 1].map(|k| if points[k].is_nan() { side(k == 1).unwrap_or(f64::NAN) } else { f64::NAN })
}

/// What the factor is at most where half-power points are missing and the response stays above half power up to the ends of the range: `Nc/(We - N1)`, `Nc/(N2 - Wb)` or `Nc/(We - Wb)`.
/// NaN where the factor is known, and where such an end is not.
pub fn at_most(place: f64, points: [f64; 2], ends: [f64; 2]) -> f64 {
    match points.iter().any(|x| x.is_nan()) {
        true => factor(place, [0, 1].map(|k| if points[k].is_nan() { ends[k] } else { points[k] })),
        false => f64::NAN,
    }
}

/// The factor; NaN where a side is not known.
pub fn factor(place: f64, [low, high]: [f64; 2]) -> f64 {
    place.abs() / (high - low).abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A resonance curve 1/sqrt(1 + x^2) about 10: half power at 9 and 11. A higher peak beside it, or an end, leaves the side unknown.
    #[test]
    fn points_are_solved_for() {
        let f = |x: f64| 1.0 / (1.0 + (x - 10.0) * (x - 10.0)).sqrt();
        let level = 1.0 / std::f64::consts::SQRT_2;
        let solved = |a: (f64, f64), b: (f64, f64)| root(|x| Some(f(x) - level), (a.0, a.1 - level), (b.0, b.1 - level), 1e-12);
        let samples: Vec<(f64, f64)> = (0..40).map(|k| 0.55 * f64::from(k)).map(|x| (x, f(x))).collect();
        let [low, high] = sides((10.0, 1.0), &samples, solved);
        assert!((low - 9.0).abs() < 1e-11 && (high - 11.0).abs() < 1e-11, "{low} {high}");
        assert!((factor(10.0, [low, high]) - 5.0).abs() < 1e-10);
        let short: Vec<(f64, f64)> = samples.iter().copied().filter(|s| s.0 < 10.8).collect();
        assert!(sides((10.0, 1.0), &short, solved)[1].is_nan());
        let mut higher = samples.clone();
        higher.iter_mut().filter(|s| s.0 > 10.4 && s.0 < 10.9).for_each(|s| s.1 = 2.0);
        assert!(sides((10.0, 1.0), &higher, solved)[1].is_nan());
        higher.iter_mut().filter(|s| s.0 > 10.4 && s.0 < 10.9).for_each(|s| s.1 = f64::NAN);
        assert!(factor(10.0, sides((10.0, 1.0), &higher, solved)).is_nan());
    }

    /// The missing side counts up to the end of the range; nothing passes that is not known.
    #[test]
    fn factor_is_bounded_by_the_range() {
        let nan = f64::NAN;
        assert!(at_most(10.0, [9.0, 11.0], [nan; 2]).is_nan());
        assert_eq!(at_most(10.0, [9.0, nan], [nan, 14.0]), 2.0);
        assert_eq!(at_most(10.0, [nan, 11.0], [1.0, nan]), 1.0);
        assert_eq!(at_most(10.0, [nan, nan], [4.0, 14.0]), 1.0);
        for (points, ends) in [([9.0, nan], [nan, nan]), ([nan, nan], [4.0, nan]), ([nan, nan], [nan, 14.0])] {
            assert!(at_most(10.0, points, ends).is_nan());
        }
    }
}
