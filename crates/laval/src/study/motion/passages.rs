//! Passages through resonances, read from the envelope of a motion whose spin speed changes.
//!
//! After a resonance the free vibration it left beats against the forced one. Beats come once per turn of the forced motion against the free one; a
//! passage is a peak that the envelope of the beats, too, falls away from.

use crate::model::system::System;
use crate::solve::motion::envelope::{Peak, Window};
use crate::solve::programme::Spin;
use std::f64::consts::PI;

/// Most turns of the machine that forced motions take to come back.
const LONGEST: f64 = 20.0;
/// A peak stands out when the envelope falls to this fraction of it on both sides.
pub(in crate::study) const PROMINENT: f64 = 0.7;
/// Half of a little more than one beat, as an angle of the forced motion against the free one.
pub(in crate::study) const BEAT: f64 = 1.25 * PI;

/// The envelope at every window: the largest displacement in it and within `reach` of the angle of the rotor, so that what comes back within it does not show.
/// Ends where the motion ends.
pub(in crate::study) fn envelope(windows: &[Window], spin: &dyn Fn(f64) -> Spin, reach: f64) -> Vec<Peak> {
    let peaks: Vec<Peak> = windows.iter().map(|w| w.peak).take_while(|p| p.amplitude.is_finite()).collect();
    let angles: Vec<f64> = peaks.iter().map(|p| spin(p.t).phase).collect();
    widened(&peaks, &angles, reach, 0)
}

/// Half of the longest of the angles after which forced motions come back: the turns of orbits that are no circles, and the beats of the motions that two spins
/// force. Beats longer than [`LONGEST`] turns are seen as such.
pub(in crate::study) fn reach(system: &System) -> f64 {
    let ratios: Vec<f64> = std::iter::once(1.0).chain(system.spins().iter().map(|s| s.ratio.abs())).filter(|r| *r > 0.0).collect();
    let turns = ratios.iter().map(|r| 1.0 / r);
    let beats = ratios.iter().enumerate().flat_map(|(k, a)| ratios[..k].iter().map(move |b| 1.0 / (a - b).abs()));
    PI * turns.chain(beats).filter(|x| *x <= LONGEST).fold(1.0, f64::max)
}

/// The largest of the neighbours whose angle differs by at most `reach`, and of so many on either side in any case.
fn widened(peaks: &[Peak], angles: &[f64], reach: f64, least: usize) -> Vec<Peak> {
    let near = |k: usize, i: &usize| k.abs_diff(*i) <= least || (angles[*i] - angles[k]).abs() <= reach;
    let larger = |a: Peak, i: usize| if peaks[i].amplitude > a.amplitude { peaks[i] } else { a };
    let one = |k: usize| {
        let left = (0..k).rev().take_while(|i| near(k, i)).fold(peaks[k], larger);
        (k + 1..peaks.len()).take_while(|i| near(k, i)).fold(left, larger)
    };
    (0..peaks.len()).map(one).collect()
}

/// Places in an [`envelope`] where a resonance is passed.
pub(in crate::study) fn passages(envelope: &[Peak], spin: &dyn Fn(f64) -> Spin) -> Vec<usize> {
    let mut out: Vec<usize> = Vec::new();
    let beats = |stretch: &[Peak], reference: f64| {
        let angles: Vec<f64> = stretch.iter().map(|p| spin(p.t).phase - reference * p.t).collect();
        widened(stretch, &angles, BEAT, 1)
    };
    for k in prominent(envelope) {
        let Some(&before) = out.last() else {
            out.push(k);
            continue;
        };
        let (a, b) = (envelope[before].amplitude, envelope[k].amplitude);
        let reference = spin(envelope[before].t).speed;
        let stretch = &envelope[before..=k];
        // free vibration decays: what is higher than the peak before it is no beat of that
        let between = if b > a { stretch.to_vec() } else { beats(stretch, reference) };
        let saddle = between.iter().map(|p| p.amplitude).fold(f64::INFINITY, f64::min);
        if saddle <= PROMINENT * a.min(b) {
            out.push(k);
        } else if b > a {
            out.pop();
            out.push(k);
        }
    }
    out
}

/// An envelope falls well below `top` before it exceeds it.
fn falls<'p>(mut side: impl Iterator<Item = &'p Peak>, top: f64) -> bool {
    let decided = |p: &Peak| {
        if p.amplitude > top || p.amplitude.is_nan() { Some(false) } else { (p.amplitude < PROMINENT * top).then_some(true) }
    };
    side.find_map(decided) == Some(true)
}

/// Peaks that stand out on both sides, each once.
fn prominent(envelope: &[Peak]) -> Vec<usize> {
    let mut out: Vec<usize> = Vec::new();
    for (i, p) in envelope.iter().enumerate() {
        // neighbours share a peak they both see
        let seen = out.last().is_some_and(|&k| envelope[k].t == p.t);
        let left = || falls(envelope[..i].iter().rev(), p.amplitude);
        let right = || falls(envelope[i + 1..].iter(), p.amplitude);
        if !seen && p.amplitude > 0.0 && left() && right() {
            out.push(i);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Speed rises by 1 rad/s each second from 0.
    fn spin(t: f64) -> Spin {
        Spin { phase: 0.5 * t * t, speed: t, accel: 1.0 }
    }
    /// The largest in each window of 0.1 s: beats that are faster do not show.
    fn sampled(amplitude: impl Fn(f64) -> f64) -> Vec<Peak> {
        let probe = |t: f64| Peak { amplitude: amplitude(t), t };
        let largest = |a: Peak, b: Peak| if b.amplitude > a.amplitude { b } else { a };
        let window = |k: usize| (0..50).map(|i| probe(0.1 * k as f64 + 0.002 * i as f64)).fold(Peak::default(), largest);
        (0..1000).map(window).collect()
    }
    fn speeds(e: &[Peak]) -> Vec<f64> {
        passages(e, &spin).into_iter().map(|k| spin(e[k].t).speed).collect()
    }
    fn bell(t: f64, at: f64, width: f64) -> f64 {
        (-((t - at) / width).powi(2)).exp()
    }
    /// A resonance at `at` that leaves a free vibration beating against the forced motion.
    fn beating(t: f64, at: f64, size: f64) -> f64 {
        let decay = if t >= at { (-(t - at) / 12.0).exp() } else { 0.0 };
        let beat = 0.5 * (t - at) * (t - at);
        size * (if t < at { bell(t, at, 2.0) } else { decay * (0.55 + 0.45 * beat.cos()) })
    }

    #[test]
    fn prominent_peaks_only() {
        let all = |a: &[f64]| prominent(&a.iter().enumerate().map(|(i, &amplitude)| Peak { amplitude, t: i as f64 }).collect::<Vec<_>>());
        assert_eq!(all(&[1.0, 2.0, 1.9, 2.1, 1.0, 0.5, 3.0, 0.1]), [3, 6]);
        assert_eq!(all(&[1.0, 2.0, 3.0]), Vec::<usize>::new());
        assert_eq!(all(&[1.0, f64::NAN, 3.0, 1.0]), Vec::<usize>::new());
    }

    #[test]
    fn beats_are_no_passages() {
        let e = sampled(|t| 1e-6 + beating(t, 20.0, 1e-3));
        assert!(prominent(&e).len() > 5, "the envelope beats");
        assert_eq!(speeds(&e), [20.0]);
    }

    #[test]
    fn a_second_resonance_is_one_with_and_without_beats() {
        let beats = sampled(|t| 1e-6 + beating(t, 20.0, 1e-3) + beating(t, 60.0, 0.5e-3));
        assert_eq!(speeds(&beats).len(), 2, "{:?}", speeds(&beats));
        let damped = sampled(|t| 1e-6 + bell(t, 20.0, 2.0) + 0.5 * bell(t, 60.0, 2.0));
        assert_eq!(speeds(&damped), [20.0, 60.0]);
        let rising = sampled(|t| 1e-6 + 0.5 * bell(t, 20.0, 2.0) + bell(t, 60.0, 2.0));
        assert_eq!(speeds(&rising), [20.0, 60.0]);
    }

    #[test]
    fn an_ellipse_has_no_ripple() {
        // two maxima a turn, dozens of windows a turn
        let windows: Vec<Window> = (0..4000)
            .map(|k| {
                let t = 40.0 + k as f64 * 0.002;
                let amplitude = 1.0 + 0.5 * (2.0 * spin(t).phase).cos();
                Window { peak: Peak { amplitude, t }, angle: 0.0, last: t }
            })
            .collect();
        let flat = envelope(&windows, &spin, PI);
        assert!(flat.iter().all(|p| p.amplitude > 1.4));
        assert!(passages(&flat, &spin).is_empty());
    }
}
