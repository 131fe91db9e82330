//! Growth, response and jumps over the spin speed.

use super::{Facts, ends, studied};
use crate::model::probe::Probe;
use crate::outcome::{Band, BandPlace, Mark, OverSpeed, Resonance, Unstable};
use crate::solve::criticals::Critical;
use crate::solve::extrema::{Curve, Extremum};
use crate::solve::stability::Row;
use crate::study::Study;
use crate::study::linear::campbell::damping;
use crate::study::linear::whirl::aperiodic;
use crate::study::nonlinear::nonlinear_response::NonlinearResponse;
use crate::study::shared::margins::resonant;
use crate::study::shared::probes::{self, farthest};
use laval_num::order::{SortByNumber, ascending};

/// The lowest speed shown, over the lowest event.
const SHOWN: f64 = 0.25;
/// Peaks smaller than this share of the largest are not resonances of the page.
const SMALL: f64 = 0.02;
/// Nor are peaks that rise less than this above the lower speeds and above the higher ones, by a share of their height: a response that hardly changes.
const RISE: f64 = 0.02;
/// Distance of two speeds, over them, from which on the growth between them is not read from a straight line.
const APART: f64 = 0.05;
/// Distance from a speed that is known to be stable, over it.
const BESIDE: f64 = 1e-4;
/// Speeds that differ by less than this share are one resonance.
const SAME: f64 = 0.02;
/// Two modes that a load excites at the same speed, but for rounding, are one resonance.
const EQUAL: f64 = 1e-9;

/// What is known over the speed; none where nothing is.
pub(super) fn over_speed(facts: &Facts) -> Option<OverSpeed> {
    let mut out = OverSpeed {
        range: facts.range,
        jumps: places(facts, ["jump_up", "jump_down"]),
        bifurcations: places(facts, ["stability_lost", "stability_gained"]),
        ..OverSpeed::default()
    };
    let rows = [facts.stability.get(), facts.near.as_ref()];
    if rows.iter().any(Option::is_some) {
        out.threshold = facts.threshold;
        // about the operating speeds also ranges narrower than the steps over the whole range
        let all = rows.into_iter().flatten().flat_map(|row| unstable(row, facts));
        out.unstable = united(all.collect());
        (out.growth_speed, out.growth) = growth(facts).into_iter().unzip();
        out.examined = ends(&out.growth_speed);
    }
    out.unstable_response = unstable_responses(facts, &out.unstable);
    let forced = facts.forced.as_ref().map(|f| &f.curve);
    let response = facts.criticals.get().map_or(forced, |found| found.response.as_ref());
    let found = || facts.criticals.get().into_iter().chain(&facts.narrow).flat_map(|found| &found.crossings);
    if facts.criticals.get().is_some() || facts.narrow.is_some() || forced.is_some() {
        match response {
            Some(curve) => {
                out.response_speed = curve.points.iter().map(|p| facts.sign * p.speed).collect();
                let size = |p: &Probe| curve.points.iter().map(|r| r.size(p)).collect();
                out.amplitudes = most_moved(facts, curve).into_iter().map(|p| (probes::label(p), size(p))).collect();
                out.resonances = peaks(facts, curve);
            }
            None => {
                let light = found().filter(|c| {
                    // unbalance does not excite what whirls against the spin of a machine without preferred direction
                    turns(facts) && c.driven_by_unbalance() && c.located() && resonant(damping(c))
                });
                out.resonances = light.map(|c: &Critical| Resonance { speed: facts.sign * c.speed, amplitude: None }).collect();
            }
        }
        // what excites at other multiples of the speed meets the modes elsewhere; a spin against that of the machine excites at its speed, too
        let spins = facts.system.spins();
        let excited = |c: &Critical| c.order != 1.0 || spins.iter().any(|s| c.driven_by(s.ratio));
        let other = found().filter(|c| excited(c) && c.located() && resonant(damping(c)));
        out.resonances.extend(other.map(|c| Resonance { speed: facts.sign * c.speed, amplitude: None }));
        // beside a response over other speeds
        let driven = |c: &Critical| turns(facts) && c.driven_by_unbalance() && c.located() && resonant(damping(c));
        let beside = facts.narrow.iter().flat_map(|n| &n.crossings).filter(|c| driven(c)).map(|c| facts.sign * c.speed);
        let beside = beside.map(|speed| Resonance { speed, amplitude: None });
        for r in beside.chain(studied::spin_peaks(facts.system, facts.outcomes)) {
            if !out.resonances.iter().any(|known| (known.speed - r.speed).abs() < SAME * r.speed.abs()) {
                out.resonances.push(r);
            }
        }
        out.resonances.sort_by_number(|a| a.speed);
        out.resonances.dedup_by(|next, kept| {
            let one = (next.speed - kept.speed).abs() <= EQUAL * kept.speed.abs();
            if one && kept.amplitude.is_none() {
                std::mem::swap(next, kept);
            }
            one
        });
        // a margin that the file requires holds for every resonance
        if facts.resonance_margin().is_none() {
            out.critically_damped = critically_damped(facts, &out.resonances);
        }
    }
    if facts.sign < 0.0 {
        out.growth_speed.reverse();
        out.growth.reverse();
        out.response_speed.reverse();
        out.amplitudes.iter_mut().for_each(|a| a.1.reverse());
    }
    if let Some(curve) = response {
        with_peaks(facts, curve, &mut out);
    }
    out.shown = shown(facts, &out);
    let known = !(out.growth.is_empty() && out.response_speed.is_empty() && out.jumps.is_empty() && out.unstable_response.is_empty());
    known.then_some(out)
}

/// Some body turns with the speed of the machine.
fn turns(facts: &Facts) -> bool {
    facts.system.slots().iter().any(|s| s.ratio.is_none() && s.part.body().is_some_and(|b| b.turns()))
}

/// Peaks of the response beside which every peak of a displacement is critically damped, by a response of the file that assesses the margins of API 684.
fn critically_damped(facts: &Facts, resonances: &[Resonance]) -> Vec<f64> {
    let assessed = studied::damped_peaks(facts.outcomes, facts.system.probes());
    let damped = |w: f64| {
        let mut beside = assessed.iter().filter(|p| (facts.sign * p.0 - w).abs() < SAME * w.abs()).peekable();
        beside.peek().is_some() && beside.all(|p| p.1)
    };
    let peaks = resonances.iter().filter(|r| r.amplitude.as_ref().is_some_and(|a| a.1.is_finite()));
    peaks.map(|r| r.speed).filter(|w| damped(*w)).collect()
}

/// The point of each body that moves most over the speed.
fn most_moved<'f>(facts: &'f Facts, curve: &Curve) -> Vec<&'f Probe> {
    let largest = |p: &Probe| {
        let peaks = curve.extrema.iter().filter(|e| facts.system.probes()[e.probe] == *p).map(|e| e.value);
        let all = curve.points.iter().map(|r| r.size(p)).chain(peaks);
        all.filter(|x| x.is_finite()).fold(0.0, f64::max)
    };
    farthest(facts.system, largest).into_iter().map(|p| p.0).collect()
}

/// Peaks that are narrower than the steps of the response, each in the curve of its body.
fn with_peaks(facts: &Facts, curve: &Curve, out: &mut OverSpeed) {
    let (all, shown) = (facts.system.probes(), most_moved(facts, curve));
    for e in curve.extrema.iter().filter(|e| e.maximum && !e.unbounded) {
        let Some(own) = shown.iter().position(|p| **p == all[e.probe]) else { continue };
        let speed = facts.sign * e.speed;
        let at = out.response_speed.partition_point(|w| *w < speed);
        if at == 0 || at == out.response_speed.len() {
            continue;
        }
        let (below, above) = (out.response_speed[at - 1], out.response_speed[at]);
        let share = (speed - below) / (above - below);
        out.response_speed.insert(at, speed);
        for (k, (_, sizes)) in out.amplitudes.iter_mut().enumerate() {
            let between = sizes[at - 1] + share * (sizes[at] - sizes[at - 1]);
            sizes.insert(at, if k == own { e.value } else { between });
        }
    }
}

/// From well below the lowest event or the operating speed on.
fn shown(facts: &Facts, over: &OverSpeed) -> (f64, f64) {
    let events = over
        .unstable
        .iter()
        .filter(|u| !u.open.0)
        .map(|u| u.from)
        .chain(over.unstable_response.iter().map(|u| u.0))
        .chain(over.resonances.iter().map(|r| r.speed))
        .chain(over.jumps.iter().copied());
    let lowest = events.chain(facts.operating.map(|o| o.low)).fold(f64::INFINITY, f64::min);
    let from = if lowest.is_finite() { SHOWN * lowest } else { 0.0 };
    (from.max(over.range.0), over.range.1)
}

/// Maxima of the response, one for all bodies that peak together.
fn peaks(facts: &Facts, curve: &Curve) -> Vec<Resonance> {
    let all = facts.system.probes();
    let maxima: Vec<_> = curve.extrema.iter().filter(|e| e.maximum).collect();
    let size = |e: &Extremum| if e.unbounded { f64::INFINITY } else { e.value / all[e.probe].typical() };
    let largest = maxima.iter().filter(|e| !e.unbounded).map(|e| size(e)).fold(0.0, f64::max);
    let mut out: Vec<Resonance> = Vec::new();
    let mut sorted = maxima.clone();
    sorted.sort_by_number_down(|a| size(a));
    // the lowest response on either side
    let rises = |e: &Extremum| {
        let side = |below: bool| {
            curve.points.iter().filter(move |p| (p.speed < e.speed) == below).map(|p| p.size(&all[e.probe])).fold(f64::INFINITY, f64::min)
        };
        let floor = [true, false].map(side).into_iter().filter(|x| x.is_finite()).fold(0.0, f64::max);
        e.unbounded || !(e.value - floor <= RISE * e.value)
    };
    // beside a sharp first resonance a further critical speed is small, but shown by the curve
    let critical = |e: &Extremum| {
        let found = facts.criticals.get().into_iter().flat_map(|c| &c.crossings);
        let mut light = found.filter(|c| c.driven_by_unbalance() && c.located() && resonant(damping(c)));
        light.any(|c| (c.speed - e.speed).abs() < SAME * e.speed.abs())
    };
    for e in sorted.into_iter().filter(|e| size(e) >= SMALL * largest && rises(e) || critical(e)) {
        if out.iter().any(|r| (r.speed - facts.sign * e.speed).abs() < SAME * e.speed.abs()) {
            continue;
        }
        let amplitude =
            (!all[e.probe].is_tilt()).then(|| (probes::named(&all[e.probe]), if e.unbounded { f64::INFINITY } else { e.value }));
        out.push(Resonance { speed: facts.sign * e.speed, amplitude });
    }
    out
}

/// Growth along the speed, with that about the operating speeds where it goes on from there: the whole range may have ended early, or is not known.
fn growth(facts: &Facts) -> Vec<(f64, f64)> {
    let of = |row: &Row| row.samples.iter().map(|s| (facts.sign * s.speed, s.value.re)).collect::<Vec<_>>();
    let mut out = facts.stability.get().map(of).unwrap_or_default();
    out.sort_by_number(|p| p.0);
    let mut near = facts.near.as_ref().map(of).unwrap_or_default();
    near.sort_by_number(|p| p.0);
    let Some((first, last)) = out.first().zip(out.last()).map(|(a, b)| (a.0, b.0)) else { return near };
    // speeds between them would not be examined
    let (a, b) = near.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), p| (a.min(p.0), b.max(p.0)));
    if a <= last && first <= b {
        let (below, above): (Vec<_>, Vec<_>) = near.into_iter().filter(|p| p.0 < first || p.0 > last).partition(|p| p.0 < first);
        out = below.into_iter().chain(out).chain(above).collect();
    }
    out
}

/// Unstable ranges of several examinations, those that overlap as one. A range that one of them leaves open ends where another found its end.
fn united(mut all: Vec<Unstable>) -> Vec<Unstable> {
    all.sort_by_number(|u| u.from);
    let mut out: Vec<Unstable> = Vec::new();
    for u in all {
        match out.last_mut() {
            // between the last speed of one and the first of the next nothing was examined: not stable
            Some(k) if u.from <= k.to || k.open.1 && u.open.0 => {
                if u.to > k.to {
                    (k.to, k.open.1) = (u.to, u.open.1);
                }
                if u.growth > k.growth {
                    (k.growth, k.frequency) = (u.growth, u.frequency);
                }
            }
            _ => out.push(u),
        }
    }
    out
}

/// Ranges above the threshold, with what grows most in each.
fn unstable(row: &Row, facts: &Facts) -> Vec<Unstable> {
    let sign = facts.sign;
    // the operating speed, where its own modes are stable
    let least = facts.modes.as_ref().and_then(|(s, m)| Some((s.speed, m.get()?.spectrum.least_stable()?.growth())));
    let stable = least.filter(|m| m.1 < 0.0).map(|m| m.0);
    let (Some(first), Some(last)) = (row.samples.first(), row.samples.last()) else { return Vec::new() };
    let one = |(from, to): (f64, f64)| {
        let samples = row.samples.iter().filter(|s| (from..=to).contains(&s.speed)).map(|s| s.value);
        let peaks = row.peaks.iter().filter(|p| (from..=to).contains(&p.speed)).map(|p| p.value);
        let edges = row.edges.iter().filter(|e| e.speed == from || e.speed == to).map(|e| e.value);
        let worst = samples.chain(peaks).chain(edges).max_by(|a, b| a.re.total_cmp(&b.re))?;
        let open = (from == first.speed, to == last.speed);
        // an edge that is not located lies anywhere between two speeds: where these are far apart the unstable range is the largest that it can be
        let edge = |w: f64| {
            let e = row.edges.iter().find(|e| e.speed == w && !e.located)?;
            let (a, b) = (e.bracket.0.min(e.bracket.1), e.bracket.0.max(e.bracket.1));
            (b - a > APART * a.abs().max(b.abs())).then_some((a, b))
        };
        let within = |(a, b): (f64, f64)| stable.filter(|w| a < *w && *w < b);
        let from = edge(from).map_or(from, |e| within(e).map_or(e.0, |w| w + BESIDE * w.abs()));
        let to = edge(to).map_or(to, |e| within(e).map_or(e.1, |w| w - BESIDE * w.abs()));
        let (from, to, open) = if sign > 0.0 { (from, to, open) } else { (-to, -from, (open.1, open.0)) };
        Some(Unstable { from, to, open, growth: worst.re, frequency: if aperiodic(worst) { 0.0 } else { worst.im.abs() } })
    };
    let mut out: Vec<Unstable> = ranges(row, facts.threshold).into_iter().filter_map(one).collect();
    out.sort_by_number(|a| a.from);
    out
}

/// Ranges between located edges, and those of samples that lie outside of them: counted spectra have samples alone.
fn ranges(row: &Row, threshold: f64) -> Vec<(f64, f64)> {
    let mut out = row.unstable_ranges(threshold);
    // a row that ended early may lack the edge at which its last range ends
    let last = row.samples.last().filter(|s| !row.unstable(s, threshold));
    if let (Some(range), Some(last)) = (out.last_mut(), last)
        && range.1 == last.speed
    {
        let inside = row.samples.iter().filter(|s| s.speed >= range.0 && row.unstable(s, threshold));
        range.1 = inside.map(|s| s.speed).fold(range.0, f64::max);
    }
    let mut run: Option<(f64, f64)> = None;
    for s in &row.samples {
        let located = out.iter().any(|r| (r.0..=r.1).contains(&s.speed));
        if row.unstable(s, threshold) && !located {
            run = Some(run.map_or((s.speed, s.speed), |r| (r.0, s.speed)));
        } else {
            out.extend(run.take());
        }
    }
    out.extend(run);
    out.sort_by_number(|a| a.0);
    out
}

/// Speeds of findings of the nonlinear responses of the file, ascending.
fn places(facts: &Facts, ids: [&str; 2]) -> Vec<f64> {
    let responses = facts.outcomes.iter().filter(|o| o.kind == NonlinearResponse::KIND);
    let found = responses.flat_map(|o| &o.findings).filter(|f| ids.contains(&f.id.as_str()));
    let mut out: Vec<f64> = found.filter_map(|f| f.value).map(|w| facts.sign * w).filter(|w| *w > 0.0).collect();
    ascending(&mut out);
    out
}

/// Ranges in which a nonlinear response of the file has no stable motion, where the linearised machine is not unstable.
fn unstable_responses(facts: &Facts, linear: &[Unstable]) -> Vec<(f64, f64)> {
    let responses = facts.outcomes.iter().filter(|o| o.kind == NonlinearResponse::KIND);
    let marks = responses.flat_map(|o| &o.figures).filter(|f| f.name == "response").flat_map(|f| f.panels.first()).flat_map(|p| &p.marks);
    let bands = marks.filter_map(|m| match m {
        Mark::Band(Band { place: BandPlace::X(a, b), strip: true, .. }) => Some((facts.sign * a, facts.sign * b)),
        _ => None,
    });
    let mut out: Vec<(f64, f64)> = bands.map(|(a, b)| (a.min(b), a.max(b))).filter(|r| r.1 > 0.0).collect();
    out.retain(|r| !linear.iter().any(|u| u.from <= r.1 && r.0 <= u.to));
    out.sort_by(|a, b| a.0.total_cmp(&b.0));
    out.dedup();
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn range(from: f64, to: f64, open: (bool, bool), growth: f64) -> Unstable {
        Unstable { from, to, open, growth, frequency: growth }
    }

    /// An end is that of an examination that found it, else the last speed examined.
    #[test]
    fn overlapping_ranges_are_one_and_keep_an_open_end() {
        let early = range(20.0, 28.0, (false, true), 1.0);
        assert_eq!(united(vec![range(24.0, 36.0, (true, true), 2.0), early.clone()]), [range(20.0, 36.0, (false, true), 2.0)]);
        assert_eq!(united(vec![early.clone(), range(24.0, 30.0, (true, false), 0.5)]), [range(20.0, 30.0, (false, false), 1.0)]);
        // neither found an end between them
        assert_eq!(united(vec![early.clone(), range(30.0, 36.0, (true, true), 0.5)]), [range(20.0, 36.0, (false, true), 1.0)]);
        let apart = [early, range(30.0, 36.0, (false, true), 0.5)];
        assert_eq!(united(apart.to_vec()), apart);
    }
}
