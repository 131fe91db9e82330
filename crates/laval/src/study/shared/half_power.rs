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
}
