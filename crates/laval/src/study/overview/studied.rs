//! Results of the studies of the file, for what would take the page itself too long.

use super::operating::Operating;
use crate::model::field::RangeValue;
use crate::model::probe::Probe;
use crate::model::spins::same_ratio;
use crate::model::system::System;
use crate::outcome::{Arg, Finding, Level, Outcome, Resonance};
use crate::solve::extrema::{Curve, Extremum};
use crate::solve::linear_response::Response;
use crate::solve::stability::{Edge, Row, Sample};
use crate::solve::sweep::Strongest;
use crate::study::Study;
use crate::study::linear::campbell::{Campbell, CampbellResult};
use crate::study::linear::criterion::Criterion;
use crate::study::linear::critical_speeds::{CriticalSpeeds, CriticalSpeedsResult};
use crate::study::linear::forced_response::{ForcedResponse, ForcedResponseResult};
use crate::study::linear::modes::{Modes, ModesResult};
use crate::study::linear::stability_map::{StabilityMap, StabilityMapResult};
use crate::study::shared::probes;
use crate::study::shared::support::About;
use laval_num::complex::{C64, c};
use laval_num::order::SortByNumber;

/// Peaks smaller than this share of the largest are no resonances of the page.
const SMALL: f64 = 0.02;
/// Two speeds that differ by less than this share are one.
const SAME: f64 = 1e-9;

/// A result and the name of the study that computed it.
pub(super) type Found<R> = Option<(R, String)>;

/// Studies of one kind that reached their end.
fn complete<S: 'static, R: 'static>(outcomes: &[Outcome]) -> impl Iterator<Item = (&S, &R, &str)> {
    let whole = outcomes.iter().filter(|o| o.end.is_complete());
    whole.filter_map(|o| o.kept.get::<S, R>().map(|(study, result)| (study, result, o.name.as_str())))
}

/// Speeds with their sign that a study must cover.
#[derive(Clone, Copy)]
pub(super) struct Needed {
    from: f64,
    to: f64,
}

impl Needed {
    pub fn of(operating: Operating, sign: f64) -> Needed {
        let ends = [sign * operating.low, sign * operating.high];
        Needed { from: ends[0].min(ends[1]), to: ends[0].max(ends[1]) }
    }

    pub fn between(a: f64, b: f64) -> Needed {
        Needed { from: a.min(b), to: a.max(b) }
    }

    fn holds(self, speed: f64) -> bool {
        let slack = SAME * speed.abs();
        self.from <= speed + slack && speed - slack <= self.to
    }

    fn within(self, range: &RangeValue) -> bool {
        let slack = SAME * self.to.abs().max(self.from.abs());
        range.from <= self.from + slack && self.to - slack <= range.to
    }
}

/// Responses over the speed of the machine; those of another spin have speeds of their own.
fn responses(outcomes: &[Outcome]) -> impl Iterator<Item = (&ForcedResponse, &ForcedResponseResult, &str)> {
    complete::<ForcedResponse, ForcedResponseResult>(outcomes).filter(|(s, ..)| s.spin.is_none())
}

/// Responses to the unbalance of a spin of another ratio to the machine, with that ratio.
fn of_spins<'o>(system: &'o System, outcomes: &'o [Outcome]) -> impl Iterator<Item = (f64, &'o ForcedResponse, &'o ForcedResponseResult)> {
    let spins = system.spins();
    complete::<ForcedResponse, ForcedResponseResult>(outcomes).filter_map(move |(s, r, _)| {
        let name = s.spin.as_ref()?;
        let spin = spins.iter().find(|x| x.name.as_ref() == Some(name))?;
        Some((spin.ratio, s, r))
    })
}

/// The response to the unbalance of this spin at its own speeds.
pub(super) fn spin_response(outcomes: &[Outcome], spin: &str, needed: Needed) -> Option<ForcedResponseResult> {
    let all = complete::<ForcedResponse, ForcedResponseResult>(outcomes).filter(|(s, ..)| s.spin.as_deref() == Some(spin));
    all.filter(|(s, ..)| needed.within(&s.speed)).find_map(|(_, r, _)| part(r, needed))
}

/// A response to the unbalance of a spin of this ratio, either way round, covers these speeds of the machine.
pub(super) fn spin_searched(system: &System, outcomes: &[Outcome], ratio: f64, (low, high): (f64, f64)) -> bool {
    of_spins(system, outcomes).any(|(own, s, _)| {
        let ends = [s.speed.from / own, s.speed.to / own].map(f64::abs);
        let slack = 1.0 + SAME;
        same_ratio(own.abs(), ratio) && ends[0].min(ends[1]) <= low * slack && high <= ends[0].max(ends[1]) * slack
    })
}

/// Peaks of the displacements in the responses to the unbalance of other spins, at amounts of the speed of the machine.
pub(super) fn spin_peaks(system: &System, outcomes: &[Outcome]) -> Vec<Resonance> {
    let probes = system.probes();
    let mut out: Vec<Resonance> = Vec::new();
    for (ratio, _, r) in of_spins(system, outcomes) {
        let maxima: Vec<_> = r.curve.extrema.iter().filter(|e| e.maximum && !probes[e.probe].is_tilt()).collect();
        let size = |e: &Extremum| if e.unbounded { f64::INFINITY } else { e.value };
        let largest = maxima.iter().filter(|e| !e.unbounded).map(|e| e.value).fold(0.0, f64::max);
        let mut sorted: Vec<_> = maxima.into_iter().filter(|e| size(e) >= SMALL * largest).collect();
        sorted.sort_by_number_down(|e| size(e));
        for e in sorted {
            let speed = (e.speed / ratio).abs();
            if !out.iter().any(|known| (known.speed - speed).abs() < 0.02 * speed) {
                out.push(Resonance { speed, amplitude: Some((probes::named(&probes[e.probe]), size(e))) });
            }
        }
    }
    out
}

/// Modes about the equilibrium at this speed.
pub(super) fn modes(outcomes: &[Outcome], speed: f64) -> Found<ModesResult> {
    let fits = |s: &Modes| s.about == About::Rest && s.threshold == 0.0 && (s.speed - speed).abs() <= SAME * speed.abs();
    let found = complete::<Modes, ModesResult>(outcomes).find(|(s, ..)| fits(s));
    found.map(|(_, r, name)| (r.clone(), name.to_string()))
}

/// The mode that grows most among those that a study of modes found unstable at one of the operating speeds, and the study's name: it may have looked at higher frequencies than the page.
pub(super) fn unstable(outcomes: &[Outcome], needed: Needed) -> Option<(C64, &str)> {
    let inside = |s: &Modes| s.about == About::Rest && needed.holds(s.speed);
    let own = outcomes.iter().filter(|o| o.findings.iter().any(|f| f.id == "unstable_mode"));
    let found = own.filter_map(|o| o.kept.get::<Modes, ModesResult>().map(|(s, r)| (s, r, o.name.as_str())));
    let grows = found.filter(|(s, ..)| inside(s)).filter_map(|(_, r, name)| Some((r.spectrum.least_stable()?.value, name)));
    grows.filter(|(value, _)| value.re > 0.0).max_by(|a, b| a.0.re.total_cmp(&b.0.re))
}

/// A study of modes at one of these speeds rests on something outside its validity.
pub(super) fn modes_outside(outcomes: &[Outcome], needed: Needed) -> bool {
    let outside = outcomes.iter().filter(|o| o.findings.iter().any(|f| f.level == Level::Invalid));
    outside.filter_map(|o| o.kept.get::<Modes, ModesResult>()).any(|(s, _)| needed.holds(s.speed))
}

/// The largest stable whirl that a study of limit cycles found beside the state at rest at one of the operating speeds, and the study's name.
pub(super) fn whirl_beside(outcomes: &[Outcome], sign: f64, operating: Operating) -> Option<(Arg, &str)> {
    let all =
        outcomes.iter().flat_map(|o| o.findings.iter().map(move |f| (f, o.name.as_str()))).filter(|(f, _)| f.id == "whirl_beside_rest");
    let holds = |f: &Finding| {
        let ends = f.number("from").zip(f.number("to")).map(|(a, b)| (sign * a, sign * b));
        ends.is_some_and(|(a, b)| a.min(b) <= operating.high && operating.low <= a.max(b))
    };
    let (f, name) = all.filter(|(f, _)| holds(f)).max_by(|a, b| a.0.value.unwrap_or(0.0).total_cmp(&b.0.value.unwrap_or(0.0)))?;
    Some((Arg::quantity(f.value?, &f.unit), name))
}

/// Growth over the speed: of a stability map, else the mode that grows most along another study.
pub(super) fn growth(outcomes: &[Outcome], needed: Needed) -> Found<Row> {
    let fits = |s: &StabilityMap| {
        let plain = s.parameter.is_none() && s.about == About::Rest && s.criterion == Criterion::Growth && s.threshold == 0.0;
        plain && needed.within(&s.speed)
    };
    let map = complete::<StabilityMap, StabilityMapResult>(outcomes).filter(|(s, ..)| fits(s));
    let mut map = map.filter_map(|(_, r, name)| Some((r.rows.first()?.clone(), name.to_string())));
    let campbell = || {
        let all = complete::<Campbell, CampbellResult>(outcomes).filter(|(s, ..)| needed.within(&s.speed) && reaches(s, &[1.0]));
        all.map(|(_, r, name)| (&r.strongest, name)).find(|(s, _)| !s.is_empty())
    };
    let criticals = || {
        let all = complete::<CriticalSpeeds, CriticalSpeedsResult>(outcomes).filter(|(s, ..)| needed.within(&s.speed));
        all.map(|(_, r, name)| (&r.strongest, name)).find(|(s, _)| !s.is_empty())
    };
    let forced = || {
        let all = responses(outcomes).filter(|(s, ..)| needed.within(&s.speed));
        all.map(|(_, r, name)| (&r.strongest, name)).find(|(s, _)| !s.is_empty())
    };
    let along = || campbell().or_else(criticals).or_else(forced).map(|(all, name)| (row(all), name.to_string()));
    map.next().or_else(along)
}

/// The growth along the speed with its crossings of zero, each between two speeds.
fn row(strongest: &[Strongest]) -> Row {
    // a growth within its error is none
    let value = |s: &Strongest| if s.grows { s.value } else { c(s.value.re.min(0.0), s.value.im) };
    let sample = |s: &Strongest| Sample {
        speed: s.speed,
        value: value(s),
        sector: None,
        size: s.value.abs(),
        on_grid: true,
        other: false,
        growing: None,
        counted: false,
    };
    let samples: Vec<Sample> = strongest.iter().map(sample).collect();
    let mut out = Row::default();
    for pair in samples.windows(2) {
        let (a, b) = (pair[0], pair[1]);
        if out.unstable(&a, 0.0) == out.unstable(&b, 0.0) {
            continue;
        }
        let share = (a.value.re / (a.value.re - b.value.re)).clamp(0.0, 1.0);
        let share = if share.is_nan() { 0.5 } else { share };
        out.edges.push(Edge {
            speed: a.speed + share * (b.speed - a.speed),
            onset: out.unstable(&b, 0.0),
            value: b.value,
            double: false,
            bracket: (a.speed, b.speed),
            located: false,
            step: b.speed - a.speed,
        });
    }
    Row { samples, ..out }
}

/// The frequencies to which modes were followed hold all that these orders excite.
fn reaches(study: &Campbell, orders: &[f64]) -> bool {
    let highest = orders.iter().fold(0.0f64, |m, k| m.max(k.abs())) * study.speed.to.abs().max(study.speed.from.abs());
    study.frequency.is_none_or(|limit| limit >= highest)
}

/// Critical speeds of these orders, with the response beside them where a study of the file computed it.
pub(super) fn criticals(outcomes: &[Outcome], needed: Needed, orders: &[f64]) -> Found<CriticalSpeedsResult> {
    let all = |have: &[f64]| orders.iter().all(|k| have.contains(k));
    let own = complete::<CriticalSpeeds, CriticalSpeedsResult>(outcomes).find(|(s, ..)| needed.within(&s.speed) && all(&s.orders));
    let own = own.map(|(_, r, name)| (r.clone(), name.to_string()));
    let campbell = || {
        let mut fits = complete::<Campbell, CampbellResult>(outcomes);
        let (_, r, name) = fits.find(|(s, ..)| needed.within(&s.speed) && all(&s.orders) && reaches(s, orders))?;
        let found = CriticalSpeedsResult {
            crossings: r.crossings.clone(),
            strongest: r.strongest.clone(),
            spectra: r.speeds.len() as u64,
            counts: r.counts.clone(),
            response: forced(outcomes, needed).map(|f| f.0.curve),
            states: r.states.clone(),
            end: r.end,
        };
        Some((found, name.to_string()))
    };
    let (mut found, name) = own.or_else(campbell)?;
    found.crossings.retain(|c| orders.contains(&c.order));
    Some((found, name))
}

/// The study whose response stands beside critical speeds of this study: its own, or that of a forced response.
pub(super) fn response_beside(outcomes: &[Outcome], needed: Option<Needed>, name: &str) -> Option<String> {
    let own = outcomes.iter().any(|o| o.name == name && o.kind == CriticalSpeeds::KIND);
    if own { Some(name.to_string()) } else { forced(outcomes, needed?).map(|f| f.1) }
}

/// The response over a range that holds the speeds needed.
pub(super) fn forced(outcomes: &[Outcome], needed: Needed) -> Found<ForcedResponseResult> {
    let wide = |s: &ForcedResponse| !s.speed.is_one() && needed.within(&s.speed);
    let found = responses(outcomes).find(|(s, ..)| wide(s));
    found.map(|(_, r, name)| (r.clone(), name.to_string()))
}

/// Peaks of displacements of all responses that assess the margins of API 684, and whether each is critically damped.
pub(super) fn damped_peaks(outcomes: &[Outcome], probes: &[Probe]) -> Vec<(f64, bool)> {
    responses(outcomes).filter(|(s, ..)| s.margins).flat_map(|(_, r, _)| r.damped_peaks(probes)).collect()
}

/// The response at the speeds needed alone, taken from one that covers them.
pub(super) fn response(outcomes: &[Outcome], needed: Needed) -> Found<ForcedResponseResult> {
    let found = responses(outcomes).find(|(s, ..)| needed.within(&s.speed));
    found.and_then(|(_, r, name)| Some((part(r, needed)?, name.to_string())))
}

/// A row between two others, by its first and the share of the second.
type Between = (usize, f64);

/// Rows at the ends of the speeds needed and those between them.
fn rows(speeds: &[f64], needed: Needed) -> Option<Vec<Between>> {
    let slack = SAME * needed.to.abs().max(needed.from.abs());
    let at = |w: f64| {
        if let Some(k) = speeds.iter().position(|s| (s - w).abs() <= slack) {
            return Some((k, 0.0));
        }
        let k = speeds.windows(2).position(|p| p[0] < w && w < p[1])?;
        Some((k, (w - speeds[k]) / (speeds[k + 1] - speeds[k])))
    };
    let inside = (0..speeds.len()).filter(|&k| speeds[k] > needed.from + slack && speeds[k] < needed.to - slack);
    let first = at(needed.from)?;
    let one = needed.to - needed.from <= slack;
    let last = if one { None } else { Some(at(needed.to)?) };
    Some([first].into_iter().chain(inside.map(|k| (k, 0.0))).chain(last).collect())
}

fn part(result: &ForcedResponseResult, needed: Needed) -> Option<ForcedResponseResult> {
    let points = &result.curve.points;
    let speeds: Vec<f64> = points.iter().map(|p| p.speed).collect();
    let rows = rows(&speeds, needed)?;
    let mix = |v: &[f64], (k, x): Between| if x == 0.0 { v[k] } else { v[k] + x * (v[k + 1] - v[k]) };
    let each = |v: &[f64]| rows.iter().map(|&r| mix(v, r)).collect::<Vec<f64>>();
    let point = |&(k, x): &Between| {
        let a = &points[k];
        if x == 0.0 {
            return a.clone();
        }
        let b = &points[k + 1];
        let both = a.x.iter().zip(&b.x).map(|(a, b)| *a + (*b - *a).scale(x)).collect();
        Response { speed: a.speed + x * (b.speed - a.speed), x: both, residual: a.residual.max(b.residual) }
    };
    let inside = |w: f64| (needed.from..=needed.to).contains(&w);
    let mut out = result.clone();
    out.curve = Curve {
        points: rows.iter().map(point).collect(),
        extrema: result.curve.extrema.iter().filter(|e| inside(e.speed)).copied().collect(),
        singular: result.curve.singular.iter().filter(|w| inside(**w)).copied().collect(),
        unknown: result.curve.unknown.iter().filter(|w| inside(**w)).copied().collect(),
        ..result.curve.clone()
    };
    out.observed.validity = each(&result.observed.validity);
    out.observed.quantities.iter_mut().chain(&mut out.observed.laws).for_each(|q| q.values = each(&q.values));
    out.observed.uses.iter_mut().for_each(|u| u.ratios = each(&u.ratios));
    out.observed.closed.retain(|gap| gap.from <= needed.to && needed.from <= gap.to);
    Some(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_at_and_between_speeds() {
        let speeds = [10.0, 20.0, 30.0, 40.0];
        let of = |from, to| rows(&speeds, Needed { from, to });
        assert_eq!(of(20.0, 20.0), Some(vec![(1, 0.0)]));
        assert_eq!(of(12.5, 12.5), Some(vec![(0, 0.25)]));
        assert_eq!(of(12.5, 30.0), Some(vec![(0, 0.25), (1, 0.0), (2, 0.0)]));
        assert_eq!(of(12.5, 37.5), Some(vec![(0, 0.25), (1, 0.0), (2, 0.0), (2, 0.75)]));
        assert_eq!((of(5.0, 5.0), of(30.0, 50.0)), (None, None));
    }

    #[test]
    fn crossings_between_two_speeds() {
        let strongest = |speed, growth, grows| Strongest { speed, value: c(growth, 5.0), grows };
        let r = row(&[strongest(1.0, -1.0, false), strongest(2.0, 3.0, true), strongest(3.0, 1e-12, false)]);
        assert_eq!(r.edges.iter().map(|e| (e.speed, e.onset)).collect::<Vec<_>>(), [(1.25, true), (3.0, false)]);
        assert_eq!(r.unstable_ranges(0.0), [(1.25, 3.0)]);
    }
}
