//! From samples to lines: windows over frequency and over orders, and the parts that stand out.

use super::Spectra;
use crate::solve::programme::Spin;
use crate::study::shared::support::largest;
use laval_num::complex::{C64, c};
use laval_num::fourier::{Fft, hann};
use laval_num::order::SortByNumber;
use serde::{Deserialize, Serialize};
use std::f64::consts::{PI, TAU};

/// Lines over orders, per order.
pub(super) const LINES: usize = 16;
/// Turns of a window at least and at most: the lines of orders stand closer than the orders it distinguishes.
const FEWEST_TURNS: f64 = 4.0;
const MOST_TURNS: f64 = 64.0;
/// Half the width of a line, over the reciprocal of the turns: nothing nearer to a larger part is a part of its own.
const HALF_WIDTH: f64 = 2.5;
/// Height over what the windows of larger parts leave there, from which a line is a part.
const CLEAR: f64 = 4.0;
/// Parts of a window at most.
const MOST_PARTS: usize = 6;
/// Frequencies on one side of zero that are listed at most.
const MOST_FREQUENCIES: usize = 400;

/// Samples of a motion, equally spaced.
#[derive(Clone, Debug, Default)]
pub(super) struct Record {
    t: Vec<f64>,
    phase: Vec<f64>,
    speed: Vec<f64>,
    z: Vec<C64>,
}

impl Record {
    /// The next sample: time, spin, x and y.
    pub fn push(&mut self, t: f64, spin: Spin, (x, y): (f64, f64)) {
        self.t.push(t);
        self.phase.push(spin.phase);
        self.speed.push(spin.speed);
        self.z.push(c(x, y));
    }
}

/// A part of a motion at an order: signed, forward positive.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Part {
    /// Frequency over the spin speed.
    pub order: f64,
    /// Radius of its circle, m.
    pub amplitude: f64,
}

/// The spectra of one window.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Window {
    /// Time at its middle, s.
    pub t: f64,
    /// Spin speed there, rad/s.
    pub speed: f64,
    /// Turns of the rotor that its orders are taken over; NaN where there are too few.
    pub turns: f64,
    /// Frequency, rad/s, and amplitude, rising.
    pub frequencies: Vec<(f64, f64)>,
    /// Order and amplitude, rising; empty where there are too few turns.
    pub orders: Vec<(f64, f64)>,
    /// Parts beside the mean and the synchronous one that stand out, largest first.
    pub parts: Vec<Part>,
}

/// All whole windows of a record.
pub(super) fn windows(spectra: &Spectra, record: &Record) -> Vec<Window> {
    let (n, hop) = (spectra.samples, spectra.hop());
    let fft = Fft::at_least(n);
    let shape = hann(n);
    (0..spectra.count).map_while(|k| (k * hop + n < record.z.len()).then(|| window(spectra, record, k * hop, &fft, &shape))).collect()
}

fn window(spectra: &Spectra, record: &Record, from: usize, fft: &Fft, shape: &[f64]) -> Window {
    let n = fft.len();
    let middle = from + n / 2;
    let (t, speed) = (record.t[middle], record.speed[middle]);
    let sense = if speed < 0.0 { -1.0 } else { 1.0 };
    // lines over frequency
    let mut x: Vec<C64> = record.z[from..from + n].iter().zip(shape).map(|(z, h)| z.scale(2.0 * h)).collect();
    fft.forward(&mut x);
    let step = TAU / (record.t[from + n] - record.t[from]);
    let top = ((spectra.highest * spectra.fastest / step).ceil() as i64).clamp(1, n as i64 / 2 - 1);
    // lines that a reader could not distinguish are merged: the highest counts
    let merged = (top as usize).div_ceil(MOST_FREQUENCIES) as i64;
    let reach = (top / merged).max(1);
    let frequencies = (-reach..=reach).map(|g| {
        let lines = (g * merged - (merged - 1) / 2)..=(g * merged + merged / 2);
        let height = largest(lines.map(|k| x[((sense as i64) * k).rem_euclid(n as i64) as usize].abs()));
        (g as f64 * merged as f64 * step, height)
    });
    let frequencies = frequencies.collect();
    let (turns, orders, parts) = orders(spectra, record, from);
    Window { t, speed, turns, frequencies, orders, parts }
}

/// The part of a window over which orders are taken, in the spin angle.
struct Turning<'r> {
    record: &'r Record,
    range: std::ops::Range<usize>,
    /// Weights `h(p) W`, over their sum.
    weights: Vec<f64>,
}

impl<'r> Turning<'r> {
    /// `None` where the rotor turns too little, or back and forth.
    fn of(record: &'r Record, from: usize, n: usize) -> Option<(Self, f64)> {
        let phase = &record.phase;
        let (a, b) = (phase[from], phase[from + n]);
        let whole = (b - a).abs() / TAU;
        let one_way = record.speed[from..=from + n].iter().all(|w| *w != 0.0 && (*w > 0.0) == (b > a));
        if !(one_way && whole >= FEWEST_TURNS) {
            return None;
        }
        let turns = whole.min(MOST_TURNS);
        let half = 0.5 * turns * TAU;
        let middle = 0.5 * (a + b);
        let inside = |j: &usize| (phase[*j] - middle).abs() < half;
        let first = (from..=from + n).find(inside)?;
        let last = (from..=from + n).rev().find(inside)?;
        let weight = |j: usize| 0.5 * (1.0 + (PI * (phase[j] - middle) / half).cos()) * record.speed[j].abs();
        let weights: Vec<f64> = (first..=last).map(weight).collect();
        let sum: f64 = weights.iter().sum();
        let weights = weights.into_iter().map(|w| w / sum).collect();
        Some((Turning { record, range: first..last + 1, weights }, turns))
    }

    /// Amplitudes at the orders `-reach/LINES .. reach/LINES`: from one line to the next every sample turns on by the same angle.
    fn lines(&self, reach: i64) -> Vec<(f64, f64)> {
        let phase = &self.record.phase[self.range.clone()];
        let first = -reach as f64 / LINES as f64;
        let own = self.record.z[self.range.clone()].iter().zip(phase).zip(&self.weights);
        let mut turned: Vec<C64> = own.map(|((z, p), w)| (*z * C64::cis(-first * p)).scale(*w)).collect();
        let step: Vec<C64> = phase.iter().map(|p| C64::cis(-p / LINES as f64)).collect();
        let line = |k: i64| {
            let height = turned.iter().fold(C64::zero(), |s, z| s + *z).abs();
            turned.iter_mut().zip(&step).for_each(|(z, s)| *z = *z * *s);
            (k as f64 / LINES as f64, height)
        };
        (-reach..=reach).map(line).collect()
    }

    /// Amplitude at a signed order.
    fn height(&self, order: f64) -> f64 {
        let own = self.record.z[self.range.clone()].iter().zip(&self.record.phase[self.range.clone()]).zip(&self.weights);
        own.fold(C64::zero(), |s, ((z, p), w)| s + (*z * C64::cis(-order * p)).scale(*w)).abs()
    }
}

/// Turns, lines over orders, and the parts that stand out.
fn orders(spectra: &Spectra, record: &Record, from: usize) -> (f64, Vec<(f64, f64)>, Vec<Part>) {
    let Some((turning, turns)) = Turning::of(record, from, spectra.samples) else { return (f64::NAN, Vec::new(), Vec::new()) };
    let reach = (spectra.highest * LINES as f64).floor() as i64;
    let lines = turning.lines(reach);
    let parts = parts(&turning, &lines, turns);
    (turns, lines, parts)
}

/// What Hann's window of so many turns leaves of a unit line at a distance in order: its side lobes at most.
fn left(distance: f64, turns: f64) -> f64 {
    let d = distance.abs() * turns;
    if d <= HALF_WIDTH { 1.0 } else { 1.0 / (PI * d * (d * d - 1.0)) }
}

/// Local maxima that larger parts do not explain, the mean and the synchronous part left out; largest first.
fn parts(turning: &Turning, lines: &[(f64, f64)], turns: f64) -> Vec<Part> {
    let tops = lines.windows(3).filter(|w| w[1].1 >= w[0].1 && w[1].1 > w[2].1);
    let mut tops: Vec<Part> = tops.map(|w| Part { order: w[1].0, amplitude: w[1].1 }).collect();
    tops.sort_by_number_down(|a| a.amplitude);
    // the mean and the synchronous part are always parts, whether they have a maximum of their own or not
    let known = [0.0, 1.0].map(|order| Part { order, amplitude: turning.height(order) });
    let mut out: Vec<Part> = Vec::new();
    let others = |out: &[Part]| known.iter().copied().chain(out.iter().copied()).collect::<Vec<Part>>();
    let clear = |p: &Part, out: &[Part]| {
        let explained: f64 = others(out).iter().map(|o| o.amplitude * left(p.order - o.order, turns)).sum();
        p.amplitude > CLEAR * explained
    };
    for top in tops {
        if out.len() >= MOST_PARTS {
            break;
        }
        // the line nearest to a part may lie too near to another, though the part does not
        if clear(&top, &out) {
            let p = refined(turning, top.order);
            let near = others(&out).iter().any(|o| (p.order - o.order).abs() * turns <= HALF_WIDTH);
            if !near && clear(&p, &out) {
                out.push(p);
            }
        }
    }
    out.sort_by_number_down(|a| a.amplitude);
    out
}

/// A maximum between two lines (golden section).
fn refined(turning: &Turning, order: f64) -> Part {
    const GOLDEN: f64 = 0.618_033_988_749_894_8;
    let step = 1.0 / LINES as f64;
    let (mut a, mut b) = (order - step, order + step);
    for _ in 0..24 {
        let (l, r) = (b - GOLDEN * (b - a), a + GOLDEN * (b - a));
        if turning.height(l) > turning.height(r) {
            b = r;
        } else {
            a = l;
        }
    }
    let order = 0.5 * (a + b);
    Part { order, amplitude: turning.height(order) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::system::{Pair, Station};

    fn station() -> Station {
        let lateral = Pair::coordinates(0);
        Station { name: "b".into(), slot: 0, position: 0.0, digits: 4, flexible: false, lateral, tilt: None }
    }

    fn spectra(highest: f64, fastest: f64, duration: f64, count: usize) -> Spectra {
        let length = 2.0 * duration / (count + 1) as f64;
        let samples = ((8.0 * highest * fastest / TAU * length).ceil() as usize).max(64).next_power_of_two();
        Spectra { body: station(), count, highest, threshold: None, duration, fastest, samples }
    }

    /// A record of circular parts (order, amplitude, phase) while the speed rises linearly.
    fn recorded(s: &Spectra, speeds: (f64, f64), parts: &[(f64, f64, f64)]) -> Record {
        let mut r = Record::default();
        for t in s.times() {
            let slope = (speeds.1 - speeds.0) / s.duration;
            let spin = Spin { phase: speeds.0 * t + 0.5 * slope * t * t, speed: speeds.0 + slope * t, accel: slope };
            let z: C64 = parts.iter().fold(C64::zero(), |z, p| z + C64::cis(p.0 * spin.phase + p.2).scale(p.1));
            r.push(t, spin, (z.re, z.im));
        }
        r
    }

    const PARTS: [(f64, f64, f64); 4] = [(1.0, 2.0, 0.3), (-3.0, 0.25, 1.0), (0.46, 0.5, -0.7), (0.0, 0.1, 0.0)];

    #[test]
    fn orders_keep_their_amplitudes_while_the_speed_rises() {
        for speeds in [(500.0, 900.0), (-500.0, -900.0), (900.0, 300.0)] {
            let s = spectra(4.0, 900.0, 8.0, 20);
            let all = windows(&s, &recorded(&s, speeds, &PARTS));
            assert_eq!(all.len(), 20);
            for w in all {
                assert!(w.turns >= 20.0 && w.turns <= 64.0);
                let line = |order: f64| w.orders.iter().find(|l| l.0 == order).unwrap().1;
                assert!((line(1.0) - 2.0).abs() < 2e-3 && (line(-3.0) - 0.25).abs() < 2e-3, "{} {}", line(1.0), line(-3.0));
                // backward and forward are not mixed up
                assert!(line(-1.0) < 2e-3 && line(3.0) < 2e-3);
                assert_eq!(w.parts.len(), 2, "{:?}", w.parts);
                assert!((w.parts[0].order - 0.46).abs() < 2e-3 && (w.parts[0].amplitude - 0.5).abs() < 2e-3, "{:?}", w.parts);
                assert!((w.parts[1].order + 3.0).abs() < 2e-3 && (w.parts[1].amplitude - 0.25).abs() < 2e-3);
            }
        }
    }

    /// At constant speed a part on a line of frequency has exactly its amplitude, half of it on both neighbours; Parseval's theorem holds for the window.
    #[test]
    fn frequencies_keep_amplitudes_and_power() {
        let (count, duration) = (7, 4.0);
        let step = TAU / (2.0 * duration / (count + 1) as f64);
        let speed = 40.0 * step;
        let s = spectra(4.0, speed, duration, count);
        for sign in [1.0, -1.0] {
            let parts = [(1.0, 2.0, 0.3), (-0.5, 0.7, 1.0)];
            let record = recorded(&s, (sign * speed, sign * speed), &parts);
            for w in windows(&s, &record) {
                let at = |f: f64| w.frequencies.iter().find(|l| (l.0 - f).abs() < 1e-9 * speed).unwrap().1;
                assert!((at(speed) - 2.0).abs() < 1e-10 && (at(-0.5 * speed) - 0.7).abs() < 1e-10, "{} {}", at(speed), at(-0.5 * speed));
                assert!((at(speed + step) - 1.0).abs() < 1e-10 && at(-speed) < 1e-10 && at(0.5 * speed) < 1e-10);
                let lines: f64 = w.frequencies.iter().map(|l| l.1 * l.1).sum();
                let n = s.samples;
                let shape = hann(n);
                let time: f64 = record.z[..n].iter().zip(&shape).map(|(z, h)| (z.scale(2.0 * h)).norm_sqr()).sum::<f64>() / n as f64;
                assert!((lines / time - 1.0).abs() < 1e-9, "{lines} {time}");
            }
        }
    }

    #[test]
    fn few_turns_have_no_orders() {
        let s = spectra(4.0, 10.0, 4.0, 20);
        let all = windows(&s, &recorded(&s, (1.0, 10.0), &PARTS));
        assert!(all.iter().all(|w| w.turns.is_nan() && w.orders.is_empty() && w.parts.is_empty()));
    }
}
