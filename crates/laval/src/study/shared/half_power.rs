//! Amplification factor of a peak by its width at half power: `AF = Nc/(N2 - N1)`, where the amplitude is 1/sqrt(2) of the peak at N1 and N2 (API 684, SP6.8.2.1).

use laval_num::univariate::root;

/// Relative uncertainty of a half-power point.
const TOLERANCE: f64 = 1e-12;

/// Where the amplitude has fallen to 1/sqrt(2) of a peak (place, amplitude) on both sides, solved for between the samples (rising places); NaN on a side where it does not fall so far, is
/// not known, or rises above the peak before.
pub fn sides(peak: (f64, f64), samples: &[(f64, f64)], mut at: impl FnMut(f64) -> Option<f64>) -> [f64; 2] {
    let level = peak.1 / std::f64::consts::SQRT_2;
    let beyond = samples.partition_point(|s| s.0 <= peak.0);
    let mut side = |points: &mut dyn Iterator<Item = &(f64, f64)>| {
        let mut before = peak;
        for &here in points {
            if here.1 <= level {
                let f = |x: f64| at(x).map(|a| a - level);
                return root(f, (before.0, before.1 - level), (here.0, here.1 - level), TOLERANCE * peak.0.abs()).unwrap_or(f64::NAN);
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
        let samples: Vec<(f64, f64)> = (0..40).map(|k| 0.55 * f64::from(k)).map(|x| (x, f(x))).collect();
        let [low, high] = sides((10.0, 1.0), &samples, |x| Some(f(x)));
        assert!((low - 9.0).abs() < 1e-11 && (high - 11.0).abs() < 1e-11, "{low} {high}");
        assert!((factor(10.0, [low, high]) - 5.0).abs() < 1e-10);
        let short: Vec<(f64, f64)> = samples.iter().copied().filter(|s| s.0 < 10.8).collect();
        assert!(sides((10.0, 1.0), &short, |x| Some(f(x)))[1].is_nan());
        let mut higher = samples.clone();
        higher.iter_mut().filter(|s| s.0 > 10.4 && s.0 < 10.9).for_each(|s| s.1 = 2.0);
        assert!(sides((10.0, 1.0), &higher, |x| Some(f(x)))[1].is_nan());
        higher.iter_mut().filter(|s| s.0 > 10.4 && s.0 < 10.9).for_each(|s| s.1 = f64::NAN);
        assert!(factor(10.0, sides((10.0, 1.0), &higher, |x| Some(f(x)))).is_nan());
    }
}
