//! Peaks of the envelope along a run-up, and what they are.

use super::RunUp;
use crate::model::system::System;
use crate::solve::motion::envelope::Peak;
use crate::solve::motion::trajectory::Trajectory;
use crate::solve::programme::Spin;
use crate::study::motion::balance;
use crate::study::motion::history;
use crate::study::motion::passages::{PROMINENT, envelope, passages, reach};
use crate::study::motion::record::MotionRecord;
use crate::study::motion::unstable::{Range, Rate, Rates};
use serde::{Deserialize, Serialize};

/// Peaks of the envelope of a body or of its tilt.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BodyPassages {
    /// Name of the body.
    pub body: String,
    /// It is the tilt of the body.
    pub tilt: bool,
    /// Peaks by time.
    pub passages: Vec<Passage>,
    /// Peaks while masses go round in the rotor.
    pub swings: Option<Swings>,
}

/// A peak of an envelope.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Passage {
    /// Spin speed, rad/s.
    pub speed: f64,
    /// Speeds at the values of the envelope before and after it, rad/s.
    pub beside: (f64, f64),
    /// When, s.
    pub t: f64,
    /// Amplitude, m or rad.
    pub amplitude: f64,
    /// What it is.
    pub nature: Nature,
    /// Further peaks of the same passage: beats of the free motion with the forced one, or of free motions with one another.
    pub beats: usize,
}

/// Share of the free motion, at least, in a peak from which the envelope of its beats falls to [`PROMINENT`]: forced and free parts add up at the peak and
/// take off each other between two.
const FREE: f64 = 0.5 * (1.0 - PROMINENT);

/// What a peak of an envelope is.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Nature {
    /// The spin speed meets a natural frequency on the way.
    Resonance,
    /// The motion grows through a range in which the machine is unstable.
    Unstable(Range),
    /// No more than a peak.
    Peak,
}

/// Peaks of an envelope while masses go round in the rotor.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Swings {
    /// Number of peaks.
    pub peaks: usize,
    /// Largest amplitude, m or rad.
    pub amplitude: f64,
    /// Spin speed there, rad/s.
    pub speed: f64,
}

impl RunUp {
    /// The passages of all bodies and tilts that move.
    pub(super) fn passages(
        &self,
        system: &System,
        record: &MotionRecord,
        trajectory: &Trajectory,
        stop: &dyn Fn() -> bool,
    ) -> Vec<BodyPassages> {
        let mut rates: Option<Option<Rates>> = None;
        let mut out = Vec::new();
        let spin = |t: f64| self.programme.at(t);
        for own in history::probe_motions(system, record, history::negligible(&self.settings, &record.rest)) {
            if own.peak.amplitude <= own.still {
                continue;
            }
            let seen = envelope(own.windows, &spin, reach(system));
            let mut found = BodyPassages { body: own.body.clone(), tilt: own.tilt, passages: Vec::new(), swings: None };
            let mut round: Vec<(f64, f64)> = Vec::new();
            let passed = passages(&seen, &spin);
            if !passed.is_empty() && rates.is_none() {
                rates = Some(Rates::along(system, record.run.t, &|t| spin(t).speed, stop));
            }
            for &i in &passed {
                let p = seen[i];
                let speed = |k: usize| spin(seen[k].t).speed;
                let beside = |mut k: Box<dyn Iterator<Item = usize>>| k.find(|&k| seen[k].t != p.t).map_or(speed(i), speed);
                let (before, after) = (beside(Box::new((0..i).rev())), beside(Box::new(i + 1..seen.len())));
                let at = spin(p.t).speed;
                if before == at && after == at {
                    // nothing is passed while the speed is held
                    continue;
                }
                if balance::slips(system, trajectory, p.t, &|t| spin(t).phase) {
                    round.push((p.amplitude, at));
                    continue;
                }
                let since = lowest_before(&seen, &passed, i);
                let rate = |t: f64| if stop() { None } else { Rate::at(system, t, spin(t).speed) };
                let nature = nature(rates.as_mut().and_then(Option::as_mut), [since, p.t], &spin, &rate);
                found.passages.push(Passage { speed: at, beside: (before, after), t: p.t, amplitude: p.amplitude, nature, beats: 0 });
            }
            if let Some(Some(rates)) = &rates {
                found.passages = without_beats(&found.passages, rates, &spin);
            }
            let most = round.iter().max_by(|a, b| a.0.total_cmp(&b.0));
            found.swings = most.map(|&(amplitude, speed)| Swings { peaks: round.len(), amplitude, speed });
            out.push(found);
        }
        out
    }
}

/// What a peak of the envelope is, from the time since which it rises: a resonance where the machine is stable and the spin speed meets a natural frequency on the way
/// or has passed one within a beat, growth through a range in which it is not stable, else no more than a peak.
fn nature(rates: Option<&mut Rates>, [since, until]: [f64; 2], spin: &dyn Fn(f64) -> Spin, rate: &dyn Fn(f64) -> Option<Rate>) -> Nature {
    let Some(rates) = rates else { return Nature::Peak };
    let grows = |rates: &Rates| rates.most(since, until).filter(|range| range.factor > 1.0 / PROMINENT).map(Nature::Unstable);
    if let Some(unstable) = grows(rates) {
        return unstable;
    }
    if !rates.meets(since, until) && !rates.lags(until, spin) {
        return Nature::Peak;
    }
    // an unstable range beside the natural frequency may be narrower than the steps so far
    rates.resolve(since, until, rate);
    grows(rates).unwrap_or(Nature::Resonance)
}

/// Peaks without the beats after a resonance. Until the spin speed passes a further natural frequency, all peaks that the free motion of a passage can cause belong to
/// it, and the largest of those within a beat of the natural frequency stands for them. After a further natural frequency, a peak no higher than the last beat is a beat too: that
/// mode is not excited.
fn without_beats(all: &[Passage], rates: &Rates, spin: &dyn Fn(f64) -> Spin) -> Vec<Passage> {
    let mut out: Vec<Passage> = Vec::new();
    // the resonance passed last, and the last beat after it
    let mut last: Option<(usize, f64)> = None;
    for p in all {
        let resonance = p.nature == Nature::Resonance;
        if let Some((k, beat)) = last
            && !matches!(p.nature, Nature::Unstable(_))
            && FREE * p.amplitude <= out[k].amplitude * rates.left(out[k].t, p.t)
        {
            let further = rates.crossed(p.t) > rates.crossed(out[k].t);
            if !resonance || !further || p.amplitude <= beat {
                let beats = out[k].beats + 1;
                if resonance && !further && p.amplitude > out[k].amplitude && rates.lags(p.t, spin) {
                    out[k] = *p;
                }
                out[k].beats = beats;
                last = Some((k, p.amplitude));
                continue;
            }
        }
        last = match p.nature {
            Nature::Resonance => Some((out.len(), 0.0)),
            Nature::Unstable(_) => None,
            Nature::Peak => last,
        };
        out.push(*p);
    }
    out
}

/// The time of the lowest place of an envelope between a passage and the one before it.
fn lowest_before(seen: &[Peak], passed: &[usize], at: usize) -> f64 {
    let from = passed.iter().copied().take_while(|&k| k < at).last().unwrap_or(0);
    seen[from..=at].iter().min_by(|a, b| a.amplitude.total_cmp(&b.amplitude)).map_or(0.0, |p| p.t)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// After a resonance at 52 s, whose free motion decays by exp(-0.5 t): what it can cause is a beat of it, a peak that is higher than that is one of its own.
    #[test]
    fn peaks_that_the_free_motion_can_cause_are_beats() {
        let (rates, spin) = Rates::of_one_passage(-0.5);
        let peak = |t: f64, amplitude: f64, nature: Nature| Passage { speed: t, beside: (t, t), t, amplitude, nature, beats: 0 };
        let all = [
            peak(30.0, 0.1, Nature::Peak),
            peak(52.0, 1.0, Nature::Resonance),
            peak(54.0, 0.5, Nature::Peak),
            peak(56.0, 0.3, Nature::Resonance),
            peak(70.0, 0.3, Nature::Peak),
        ];
        let left: Vec<(f64, usize)> = without_beats(&all, &rates, &spin).iter().map(|p| (p.t, p.beats)).collect();
        // exp(-0.5 * 18) is less than 0.15 * 0.3
        assert_eq!(left, [(30.0, 0), (52.0, 2), (70.0, 0)]);
    }
}
