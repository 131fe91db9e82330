//! Findings and tables of a sweep.

use super::super::start;
use super::super::steady_state::measure::{HIGHEST, LINES, POINTS};
use super::super::steady_state::period::LONGEST;
use super::super::steady_state::stored::{self, limits};
use super::refine::{JUMP, about_mean};
use super::rows::{STATE, mean, point, spectrum};
use super::{Shown, Sweep, SweepResult, Way, figures};
use crate::diagnostic::Diagnostic;
use crate::model::probe::Probe;
use crate::outcome::{Arg, Finding, Message, Outcome, SpecialPoint, Status, Table};
use crate::store::{Collected, Kind};
use crate::study::Study;
use crate::study::shared::probes;
use crate::study::shared::support::inconsistent;
use laval_num::order::SortByNumber;
use std::collections::BTreeMap;
use std::ops::RangeInclusive;

/// Times the changes on both sides that a jump is, at least: a resonance between two speeds is none.
const BEYOND: f64 = 4.0;
/// Share of the larger amplitude by which motions of both directions differ where there is hysteresis.
const APART: f64 = 0.01;

/// Rows of one way, in the order of their steps.
pub(super) struct Path {
    pub way: Way,
    pub speed: Vec<f64>,
    pub motion: Vec<String>,
    pub period: Vec<f64>,
    pub bounded: Vec<bool>,
    /// By probe.
    pub amplitude: Vec<Vec<f64>>,
    /// The same without the mean displacement, where that is known.
    pub about_mean: Vec<Vec<f64>>,
    /// By probe the size below which it is not resolved beside the rest of the motions of this way.
    pub unresolved: Vec<f64>,
    /// By probe: jumps are recognised by a reference point first, then by another point, then by a tilt.
    pub rank: Vec<u8>,
    /// Speeds between which smaller steps place a jump on the way to each row; NaN where there is none.
    pub placed: Vec<(f64, f64)>,
}

/// A change between two neighbouring speeds that the motion on either side does not announce.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Jump {
    pub way: Way,
    pub before: f64,
    pub after: f64,
    /// The same in smaller steps.
    pub placed: (f64, f64),
    pub probe: usize,
    pub amplitudes: (f64, f64),
}

fn paths(shown: &Shown, results: &Collected) -> Vec<Path> {
    let ways = &shown.study.ways;
    let motion = results.words("motion");
    let own = |column: &str, w: usize| results.numbers(column).into_iter().skip(w).step_by(ways.len()).collect::<Vec<f64>>();
    let one = |(w, way): (usize, &Way)| {
        let amplitude = shown.probes.iter().map(|p| own(&probes::column(p), w)).collect::<Vec<_>>();
        let about_mean = |(p, a): (&Probe, &Vec<f64>)| {
            let means = if p.is_reference() { own(&mean(p), w) } else { vec![0.0; a.len()] };
            a.iter().zip(means).map(|(a, m)| about_mean(*a, m)).collect()
        };
        let about_mean = shown.probes.iter().zip(&amplitude).map(about_mean).collect();
        let largest = |a: &Vec<f64>| a.iter().copied().fold(0.0, f64::max);
        let loudest = probes::loudest(shown.probes.iter().zip(amplitude.iter().map(largest)));
        Path {
            way: *way,
            speed: own("speed", w),
            motion: motion.iter().skip(w).step_by(ways.len()).cloned().collect(),
            period: own("period", w),
            bounded: own("bounded", w).iter().map(|b| *b == 1.0).collect(),
            placed: own("jump_before", w).into_iter().zip(own("jump_after", w)).collect(),
            amplitude,
            about_mean,
            rank: shown.probes.iter().map(|p| if p.is_tilt() { 2 } else { u8::from(!p.is_reference()) }).collect(),
            unresolved: shown.probes.iter().map(|p| shown.unresolved() * loudest * p.typical()).collect(),
        }
    };
    ways.iter().enumerate().map(one).collect()
}

/// Jumps of a path.
fn jumps(path: &Path) -> Vec<Jump> {
    let change = |a: &[f64], i: usize| if i + 1 < a.len() { (a[i + 1] - a[i]).abs() } else { f64::NAN };
    let mut out = Vec::new();
    for i in 0..path.speed.len().saturating_sub(1) {
        let share = |k: usize, a: &[f64]| change(a, i) / path.about_mean[k][i].max(path.about_mean[k][i + 1]);
        let resolved = |k: usize, a: &[f64]| a[i].max(a[i + 1]) > path.unresolved[k];
        let clear = |k: usize, a: &[f64]| {
            let sides = [if i > 0 { change(a, i - 1) } else { f64::NAN }, change(a, i + 1)];
            let known: Vec<f64> = sides.into_iter().filter(|x| x.is_finite()).collect();
            share(k, a) > JUMP && !known.is_empty() && known.iter().all(|x| change(a, i) > BEYOND * x)
        };
        let placed = Some(path.placed[i + 1]).filter(|p| p.0.is_finite() && p.1.is_finite());
        // in smaller steps the motion went on from one to the other
        if path.way != Way::Rest && placed.is_none() && [i, i + 1].iter().all(|&k| path.motion[k] == "periodic") {
            continue;
        }
        let all = path.amplitude.iter().enumerate().filter(|(k, a)| clear(*k, a) && resolved(*k, a));
        let found = all.max_by(|a, b| path.rank[b.0].cmp(&path.rank[a.0]).then(change(a.1, i).total_cmp(&change(b.1, i))));
        if let Some((probe, a)) = found {
            let (before, after) = (path.speed[i], path.speed[i + 1]);
            out.push(Jump { way: path.way, before, after, placed: placed.unwrap_or((before, after)), probe, amplitudes: (a[i], a[i + 1]) });
        }
    }
    out
}

/// Longest stretches of rows for which something holds.
fn stretches(len: usize, holds: impl Fn(usize) -> bool) -> Vec<RangeInclusive<usize>> {
    let mut out: Vec<RangeInclusive<usize>> = Vec::new();
    for i in (0..len).filter(|&i| holds(i)) {
        match out.last_mut() {
            Some(r) if *r.end() + 1 == i => *r = *r.start()..=i,
            _ => out.push(i..=i),
        }
    }
    out
}

/// One speed, or a range of rising ones.
fn place(speed: &[f64], range: &RangeInclusive<usize>) -> Message {
    let (a, b) = (speed[*range.start()], speed[*range.end()]);
    if a == b {
        return Message::new("at").arg("at", Arg::speed(a));
    }
    let digits = digits((a, b));
    Message::new("range").arg("from", Arg::speed(a.min(b)).digits(digits)).arg("to", Arg::speed(a.max(b)).digits(digits))
}

/// Digits that tell two speeds apart in every unit.
fn digits((a, b): (f64, f64)) -> u8 {
    let apart = (a - b).abs() / a.abs().max(b.abs());
    (1.0 - apart.log10()).ceil().clamp(4.0, 12.0) as u8
}

/// How the motion began.
fn begun(way: Way) -> Message {
    Message::new(match way {
        Way::Rest => "sweep-from-start",
        Way::Up => "sweep-run-up",
        Way::Down => "sweep-run-down",
    })
}

pub(super) fn report(shown: &Shown, result: &SweepResult, name: &str) -> Result<Outcome, Diagnostic> {
    let results = &result.motions;
    let means = shown.probes.iter().filter(|p| p.is_reference()).map(mean);
    let amplitudes = shown.probes.iter().map(probes::column).chain(means);
    let own = ["start", "speed", "decay", "jump_before", "jump_after", "motion", "period", "bounded", "validity", "steps", "failure"];
    stored::check(results, own.map(String::from).into_iter().chain(amplitudes))?;
    let paths = paths(shown, results);
    let mut outcome = Outcome::new(Sweep::KIND, name).over("speed", "rad/s").end(result.end);
    let jumps: Vec<Jump> = paths.iter().flat_map(jumps).collect();
    for f in results.remark().into_iter().chain(start::undeflected(&result.undeflected)) {
        outcome = outcome.finding(f);
    }
    outcome = undamped(results, outcome);
    outcome = largest(shown, &paths, outcome);
    outcome = reported_jumps(shown, &paths, &jumps, outcome);
    outcome = hysteresis(&paths, &jumps, outcome);
    outcome = motions(&paths, outcome);
    outcome = failures(results, outcome);
    let speeds = results.numbers("speed");
    outcome = limits(results, |row, f| f.evidence("at", speeds[row], "rad/s"), outcome);
    outcome = exponents(shown.study, results, outcome);
    let steps = results.numbers("steps").iter().sum::<f64>();
    outcome = outcome.work("motions", results.done).work("steps", steps as u64);
    outcome = tables(shown, results, &jumps, outcome)?;
    figures::figures(shown, &paths, results.done > 0, outcome).checked().map_err(inconsistent)
}

/// Speeds at which a mode at rest does not decay: settling has no end there.
fn undamped(results: &Collected, outcome: Outcome) -> Outcome {
    // every way passes the same speeds
    let mut decay: Vec<(f64, f64)> = results.numbers("speed").into_iter().zip(results.numbers("decay")).collect();
    decay.sort_by_number(|a| a.0);
    decay.dedup_by(|a, b| a.0 == b.0);
    let none = decay.iter().filter(|x| !x.1.is_finite()).count();
    if none == 0 {
        return outcome;
    }
    let finding = Finding::warning("no_decay", "sweep-no-decay").value(none as f64, "");
    outcome.finding(finding.arg("count", Arg::count(none)).arg("speeds", Arg::count(decay.len())))
}

fn largest(shown: &Shown, paths: &[Path], mut outcome: Outcome) -> Outcome {
    let sizes = paths.iter().flat_map(|p| shown.probes.iter().zip(&p.amplitude)).flat_map(|(p, a)| a.iter().map(move |a| (p, *a)));
    if probes::unforced(shown.system, &shown.study.spin_speeds(shown.system), sizes) {
        return outcome.finding(Finding::info("largest_displacement", probes::UNFORCED).value(0.0, "m"));
    }
    for (k, probe) in shown.probes.iter().enumerate() {
        let of = |p: &'_ Path, i: usize| (p.way, p.speed[i], p.amplitude[k][i], p.motion[i] == "periodic");
        let all = paths.iter().flat_map(|p| (0..p.speed.len()).map(move |i| of(p, i)));
        let Some((way, speed, a, repeats)) = all.filter(|x| x.2.is_finite()).max_by(|x, y| x.2.total_cmp(&y.2)) else { continue };
        // of a body that only tilts its tilt is reported
        if shown.tilts(probe) && paths.iter().all(|p| a <= p.unresolved[k]) {
            continue;
        }
        // of a motion that does not repeat the largest of the periods recorded
        let key = if repeats { "sweep-largest" } else { "sweep-largest-recorded" };
        let (quality, owner) = (probes::quality(probe), probes::owner(probe));
        let finding = Finding::info(format!("largest_{quality}"), key)
            .of(owner)
            .arg("point", probes::arg(probe))
            .arg("quality", Arg::word(quality))
            .arg("speed", Arg::speed(speed))
            .arg("start", begun(way));
        outcome = outcome.finding(finding.value(a, probe.unit()).evidence("speed", speed, "rad/s"));
    }
    outcome
}

fn reported_jumps(shown: &Shown, paths: &[Path], jumps: &[Jump], mut outcome: Outcome) -> Outcome {
    for j in jumps {
        let probe = &shown.probes[j.probe];
        let unit = probe.unit();
        let (id, key) = match j.way {
            Way::Rest => ("start_jump", "sweep-start-jump"),
            Way::Up => ("jump_up", "sweep-jump"),
            Way::Down => ("jump_down", "sweep-jump"),
        };
        let digits = digits(j.placed);
        let finding = Finding::info(id, key)
            .value(j.placed.1, "rad/s")
            .arg("point", probes::arg(probe))
            .arg("before", Arg::quantity(j.amplitudes.0, unit))
            .arg("after", Arg::quantity(j.amplitudes.1, unit))
            .arg("from", Arg::speed(j.placed.0).digits(digits))
            .arg("to", Arg::speed(j.placed.1).digits(digits))
            .arg("way", Arg::word(j.way.word()))
            .evidence("last speed before", j.placed.0, "rad/s");
        let finding = finding.evidence("amplitude before", j.amplitudes.0, unit).evidence("amplitude after", j.amplitudes.1, unit);
        let special = SpecialPoint::new(id, j.placed.1, j.placed).status(Status::Bracketed);
        outcome = outcome.finding(finding).special_point(special);
    }
    // nothing is said of speeds that could not be computed, nor of motions without one amplitude
    let whole =
        |p: &&Path| p.speed.len() > 2 && p.amplitude.iter().flatten().all(|a| a.is_finite()) && p.motion.iter().all(|m| m == "periodic");
    for p in paths.iter().filter(|p| p.way != Way::Rest && !jumps.iter().any(|j| j.way == p.way)).filter(whole) {
        // a step that the ratio of amplitudes does not show
        let joined = joined(paths, p.way);
        let (id, key) = match joined {
            Some(_) => (format!("joins_{}", p.way.word()), "sweep-joins"),
            None => (format!("no_jump_{}", p.way.word()), "sweep-no-jump"),
        };
        let (from, to) = joined.unwrap_or((p.speed[0], p.speed[p.speed.len() - 1]));
        let digits = digits((from, to));
        let finding = Finding::info(id, key)
            .arg("way", Arg::word(p.way.word()))
            .arg("from", Arg::speed(from).digits(digits))
            .arg("to", Arg::speed(to).digits(digits))
            .arg("speeds", Arg::count(p.speed.len()));
        outcome = outcome.finding(finding);
    }
    outcome
}

/// The two speeds between which a way leaves the stretch where it differs from the other way, in the order it meets them.
fn joined(paths: &[Path], way: Way) -> Option<(f64, f64)> {
    let (up, differing) = differing(paths)?;
    let speeds = &up.speed;
    differing.iter().find_map(|r| match way {
        Way::Up => Some((speeds[*r.end()], *speeds.get(r.end() + 1)?)),
        Way::Down => Some((speeds[*r.start()], *speeds.get(r.start().checked_sub(1)?)?)),
        Way::Rest => None,
    })
}

/// The way up, and the stretches of its speeds at which the way down ends in another motion.
fn differing(paths: &[Path]) -> Option<(&Path, Vec<RangeInclusive<usize>>)> {
    let find = |way: Way| paths.iter().find(|p| p.way == way);
    let (up, down) = (find(Way::Up)?, find(Way::Down)?);
    let n = up.speed.len();
    let other = |i: usize| down.speed.iter().position(|w| *w == up.speed[i]);
    // what never repeats has no one amplitude
    let repeat = |i: usize, j: usize| [&up.motion[i], &down.motion[j]].iter().all(|m| m.as_str() == "periodic");
    let differ = |i: usize| {
        let Some(j) = other(i) else { return false };
        let apart = |b: usize| {
            let (u, d) = (up.amplitude[b][i], down.amplitude[b][j]);
            (u - d).abs() > APART * u.max(d) && u.max(d) > up.unresolved[b].max(down.unresolved[b])
        };
        repeat(i, j) && (0..up.amplitude.len()).any(apart)
    };
    // between two of them speeds at which nothing is known belong to one stretch
    let unknown = |i: usize| other(i).is_some_and(|j| !repeat(i, j));
    let mut out: Vec<RangeInclusive<usize>> = Vec::new();
    for r in stretches(n, differ) {
        match out.last_mut() {
            Some(last) if (*last.end() + 1..*r.start()).all(unknown) => *last = *last.start()..=*r.end(),
            _ => out.push(r),
        }
    }
    Some((up, out))
}

/// Speeds at which the way up and the way down end in different motions: on to where one of them jumps, which is known more closely than the speeds computed.
fn hysteresis(paths: &[Path], jumps: &[Jump], mut outcome: Outcome) -> Outcome {
    let Some((up, differing)) = differing(paths) else { return outcome };
    for r in differing {
        let (first, last) = (up.speed[*r.start()], up.speed[*r.end()]);
        let left = |way: Way, at: f64| jumps.iter().find(|j| j.way == way && j.before == at).map_or(at, |j| j.placed.0);
        let (a, b) = (left(Way::Down, first), left(Way::Up, last));
        let finding = if a == b {
            Finding::info("hysteresis", "sweep-hysteresis-at").arg("speed", Arg::speed(a))
        } else {
            let digits = digits((a, b));
            let finding = Finding::info("hysteresis", "sweep-hysteresis").value(b - a, "rad/s");
            finding.arg("from", Arg::speed(a.min(b)).digits(digits)).arg("to", Arg::speed(a.max(b)).digits(digits))
        };
        outcome = outcome.finding(finding.evidence("from", a, "rad/s").evidence("to", b, "rad/s"));
    }
    outcome
}

/// Motions of longer period, without period, unsettled.
fn motions(paths: &[Path], mut outcome: Outcome) -> Outcome {
    for p in paths {
        let n = p.speed.len();
        for k in 2..=LONGEST {
            for r in stretches(n, |i| p.period[i] == k as f64) {
                let finding = Finding::info("longer_period", "sweep-longer-period").value(k as f64, "").arg("turns", Arg::count(k));
                outcome = outcome.finding(spanned(finding, p, &r));
            }
        }
        // whether the largest number of periods ended the settling, where it matters
        for (id, wanted, bounded, key) in [
            ("not_periodic", "not periodic", None, "sweep-not-periodic"),
            ("not_settled", "not settled", Some(true), "sweep-not-settled-bounded"),
            ("not_settled", "not settled", Some(false), "sweep-not-settled"),
        ] {
            for r in stretches(n, |i| p.motion[i] == wanted && bounded.is_none_or(|b| p.bounded[i] == b)) {
                let count = r.end() - r.start() + 1;
                let finding = Finding::warning(id, key).value(count as f64, "").arg("count", Arg::count(count));
                outcome = outcome.finding(spanned(finding.arg("turns", Arg::count(LONGEST)), p, &r));
            }
        }
        let cut = (0..n).filter(|&i| p.bounded[i] && p.motion[i] == "periodic").count();
        if cut > 0 {
            let finding = Finding::info("settling_bounded", "sweep-settling-bounded").value(cut as f64, "");
            outcome = outcome.finding(finding.arg("count", Arg::count(cut)).arg("speeds", Arg::count(n)).arg("start", begun(p.way)));
        }
    }
    outcome
}

fn spanned(finding: Finding, p: &Path, r: &RangeInclusive<usize>) -> Finding {
    let (a, b) = (p.speed[*r.start()], p.speed[*r.end()]);
    let finding = finding.arg("place", place(&p.speed, r)).arg("start", begun(p.way));
    finding.evidence("from", a.min(b), "rad/s").evidence("to", a.max(b), "rad/s")
}

fn failures(results: &Collected, mut outcome: Outcome) -> Outcome {
    let speeds = results.numbers("speed");
    let mut causes: BTreeMap<String, (usize, f64)> = BTreeMap::new();
    for (why, speed) in results.words("failure").into_iter().zip(&speeds).filter(|x| !x.0.is_empty()) {
        causes.entry(why).or_insert((0, *speed)).0 += 1;
    }
    for (why, (count, first)) in causes {
        let finding = Finding::warning("failed_motions", "sweep-failed-motions")
            .of(&why)
            .value(count as f64, "")
            .arg("count", Arg::count(count))
            .arg("motions", Arg::count(speeds.len()))
            .arg("first", Arg::speed(first))
            .arg("reason", Arg::term(why))
            .evidence("first at", first, "rad/s");
        outcome = outcome.finding(finding);
    }
    outcome
}

fn exponents(study: &Sweep, results: &Collected, outcome: Outcome) -> Outcome {
    if study.lyapunov.is_none() {
        return outcome;
    }
    let (speed, value, halves) = (results.numbers("speed"), results.numbers("lyapunov"), results.numbers("lyapunov_halves"));
    let clear: Vec<usize> = (0..value.len()).filter(|&i| value[i] > 3.0 * halves[i]).collect();
    let Some(&top) = clear.iter().max_by(|&&a, &&b| value[a].total_cmp(&value[b])) else {
        return outcome.finding(Finding::info("no_chaos", "sweep-no-chaos"));
    };
    let finding = Finding::warning("chaos", "sweep-chaos")
        .value(value[top], "1/s")
        .arg("count", Arg::count(clear.len()))
        .arg("speed", Arg::speed(speed[top]))
        .evidence("at", speed[top], "rad/s");
    outcome.finding(finding.evidence("difference between the halves of its time", halves[top], "1/s"))
}

fn tables(shown: &Shown, results: &Collected, jumps: &[Jump], mut outcome: Outcome) -> Result<Outcome, Diagnostic> {
    let skipped = |name: &str| ["point_", "spectrum_"].iter().any(|p| name.starts_with(p)) || name.starts_with(STATE);
    let mut table = Table::new("sweep", "Steady-state motion at every speed");
    for (c, _) in results.columns.iter().filter(|c| !skipped(&c.0.name)) {
        table = match c.kind {
            Kind::Text => table.text(&c.name, Arg::term(&c.doc), results.words(&c.name)),
            _ => {
                // infinity marks what has no bound
                let values: Vec<f64> = results.numbers(&c.name).iter().map(|x| if x.is_finite() { *x } else { f64::NAN }).collect();
                let doc = Arg::term(&c.doc);
                let doc = if values.iter().any(|x| x.is_nan()) { Arg::noted(doc, "NaN where there is none") } else { doc };
                table.float(&c.name, &c.unit, doc, values)
            }
        };
    }
    outcome = outcome.table(table.build().map_err(inconsistent)?);
    let (start, speed, period) = (results.words("start"), results.numbers("speed"), results.numbers("period"));
    let points = (0..POINTS).map(|p| results.numbers(&point(p))).collect::<Vec<_>>();
    let section = &shown.probes[shown.study.section.0];
    let (quality, unit) = (probes::quality(section), section.unit());
    // a motion of period k has k points, the last ones
    let kept = |row: usize| POINTS - if period[row].is_finite() { (period[row] as usize).clamp(1, POINTS) } else { POINTS };
    let rows: Vec<(usize, f64)> =
        (0..speed.len()).flat_map(|r| points[kept(r)..].iter().map(move |p| (r, p[r]))).filter(|x| x.1.is_finite()).collect();
    let poincare =
        Table::new("poincare", "Value of the section at phase zero: one point for every period of a motion, 32 where it does not repeat")
            .text("start", "how the motion began", rows.iter().map(|r| start[r.0].clone()).collect())
            .float("speed", "rad/s", "spin speed", rows.iter().map(|r| speed[r.0]).collect())
            .float(quality, unit, quality, rows.iter().map(|r| r.1).collect());
    outcome = outcome.table(poincare.build().map_err(inconsistent)?);
    if shown.study.waterfall.is_some() {
        let lines = (0..=2 * LINES * HIGHEST).map(|l| results.numbers(&spectrum(l))).collect::<Vec<_>>();
        let first = shown.study.ways[0].word();
        let rows: Vec<(usize, usize)> =
            (0..speed.len()).filter(|&r| start[r] == first).flat_map(|r| (0..lines.len()).map(move |l| (r, l))).collect();
        let table = Table::new("waterfall", "Circular parts of the motion over speed and order")
            .float("speed", "rad/s", "spin speed", rows.iter().map(|r| speed[r.0]).collect())
            .float(
                "order",
                "",
                "frequency over spin speed; negative turns backward",
                rows.iter().map(|r| r.1 as f64 / LINES as f64 - HIGHEST as f64).collect(),
            )
            .float(
                "amplitude",
                "m",
                "radius of the circular part, root mean square over stretches of 16 periods; NaN where the motion failed",
                rows.iter().map(|r| lines[r.1][r.0]).collect(),
            );
        outcome = outcome.table(table.build().map_err(inconsistent)?);
    }
    outcome = outcome.table(end_states(results)?);
    let column = |f: &dyn Fn(&Jump) -> f64| jumps.iter().map(f).collect::<Vec<f64>>();
    let size = |tilt: bool, of: &dyn Fn(&Jump) -> f64| column(&|j| if shown.probes[j.probe].is_tilt() == tilt { of(j) } else { f64::NAN });
    let mut table = Table::new("jumps", "Jumps between neighbouring speeds")
        .text("start", "how the motion began", jumps.iter().map(|j| j.way.word().into()).collect())
        .names("body", "body whose amplitude changes most", jumps.iter().map(|j| probes::owner(&shown.probes[j.probe])).collect())
        .float("before", "rad/s", "last speed before", column(&|j| j.before))
        .float("after", "rad/s", "first speed after", column(&|j| j.after))
        .float("placed_before", "rad/s", "last speed before, in smaller steps", column(&|j| j.placed.0))
        .float("placed_after", "rad/s", "first speed after, in smaller steps", column(&|j| j.placed.1))
        .float("amplitude_before", "m", "largest displacement before; NaN of a tilt", size(false, &|j| j.amplitudes.0))
        .float("amplitude_after", "m", "largest displacement after; NaN of a tilt", size(false, &|j| j.amplitudes.1));
    if jumps.iter().any(|j| shown.probes[j.probe].is_tilt()) {
        table = table.float("tilt_before", "rad", "largest tilt before; NaN of a displacement", size(true, &|j| j.amplitudes.0)).float(
            "tilt_after",
            "rad",
            "largest tilt after; NaN of a displacement",
            size(true, &|j| j.amplitudes.1),
        );
    }
    Ok(outcome.table(table.build().map_err(inconsistent)?))
}

/// States at the last speed computed, from which another sweep can go on.
fn end_states(results: &Collected) -> Result<Table, Diagnostic> {
    let start = results.words("start");
    let mut rows: Vec<(&str, &str, &str, f64)> = Vec::new();
    for (c, _) in &results.columns {
        let Some(name) = c.name.strip_prefix(STATE) else { continue };
        let values = results.numbers(&c.name);
        for way in [Way::Rest, Way::Up, Way::Down] {
            if let Some(i) = start.iter().rposition(|s| s == way.word()) {
                rows.push((way.word(), name, c.unit.as_str(), values[i]));
            }
        }
    }
    Table::new("end_states", "State at the last speed of each way, at phase zero: what `initial` of another sweep may be given")
        .text("start", "how the motion began", rows.iter().map(|r| r.0.into()).collect())
        .names("state", "coordinate, rate or internal state", rows.iter().map(|r| r.1.into()).collect())
        .names("unit", "unit of the value", rows.iter().map(|r| r.2.into()).collect())
        .float("value", "", "value; NaN where the motion failed", rows.iter().map(|r| r.3).collect())
        .build()
        .map_err(inconsistent)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::{Style, Units};

    fn path(amplitude: &[f64]) -> Path {
        let n = amplitude.len();
        Path {
            way: Way::Up,
            speed: (0..n).map(|i| i as f64).collect(),
            motion: vec!["periodic".into(); n],
            period: vec![1.0; n],
            bounded: vec![false; n],
            amplitude: vec![amplitude.to_vec()],
            about_mean: vec![amplitude.to_vec()],
            unresolved: vec![1e-5],
            rank: vec![0],
            placed: vec![(f64::NAN, f64::NAN); n],
        }
    }

    #[test]
    fn a_step_without_a_jump_joins_the_other_way() {
        let up = path(&[1.0, 1.2, 1.4, 1.6, 1.8]);
        let mut down = path(&[1.8, 1.6, 1.2, 1.1, 1.0]);
        down.way = Way::Down;
        down.speed.reverse();
        // at speed 2 the ways differ: 1.4 up, 1.2 down
        let paths = [up, down];
        assert_eq!(joined(&paths, Way::Up), Some((2.0, 3.0)));
        assert_eq!(joined(&paths, Way::Down), Some((1.0, 0.0)));
        assert_eq!(joined(&paths, Way::Rest), None);
        assert_eq!(joined(&paths[..1], Way::Up), None);
    }

    /// A rotor that has sagged by 20 and moves by 5 about its mean: the jump is a quarter of nothing but the motion.
    #[test]
    fn a_sag_does_not_hide_a_jump() {
        let mut sagged = path(&[25.0, 25.1, 25.2, 23.0, 22.9]);
        sagged.placed[3] = (2.25, 2.5);
        assert_eq!(jumps(&sagged), []);
        sagged.about_mean[0].iter_mut().for_each(|a| *a -= 20.0);
        assert_eq!(jumps(&sagged).len(), 1);
    }

    #[test]
    fn a_hysteresis_ends_where_a_way_jumps() {
        let up = path(&[1.0, 1.2, 1.4, 1.6, 9.0, 9.1]);
        let mut down = path(&[9.1, 9.0, 8.9, 8.8, 1.2, 1.0]);
        down.way = Way::Down;
        down.speed.reverse();
        let jump =
            |way: Way, before: f64, after: f64, placed: (f64, f64)| Jump { way, before, after, placed, probe: 0, amplitudes: (1.0, 9.0) };
        let both = [jump(Way::Up, 3.0, 4.0, (3.5, 3.6)), jump(Way::Down, 2.0, 1.0, (1.7, 1.6))];
        let found = |paths: &[Path], jumps: &[Jump]| {
            let o = hysteresis(paths, jumps, Outcome::new("sweep", "s"));
            o.findings.iter().map(|f| (f.sentence(), f.value)).collect::<Vec<_>>()
        };
        let mut paths = [up, down];
        let one = found(&paths, &both);
        assert!(one.len() == 1 && one[0].0.starts_with("Hysteresis from 1.7 rad/s to 3.5 rad/s") && one[0].1 == Some(3.5 - 1.7), "{one:?}");
        // speeds between at which a motion has not settled are no end
        paths[0].amplitude[0] = vec![1.0, 1.0, 2.0, 2.0, 2.0, 9.1];
        paths[1].amplitude[0] = vec![9.1, 9.0, 8.9, 8.8, 1.0, 1.0];
        paths[0].motion[3] = "not settled".into();
        assert_eq!(found(&paths, &[]).len(), 1);
        // at one speed alone it has no width
        paths[0].amplitude[0] = vec![1.0, 1.0, 2.0, 8.8, 9.0, 9.1];
        paths[1].amplitude[0] = vec![9.1, 9.0, 8.8, 8.9, 1.0, 1.0];
        paths[0].motion[3] = "periodic".into();
        let one = found(&paths, &[]);
        assert!(one.len() == 1 && one[0].1.is_none() && one[0].0.starts_with("Hysteresis at 2 rad/s"), "{one:?}");
    }

    #[test]
    fn a_jump_is_no_resonance() {
        let mut falls = path(&[5.0, 5.2, 5.3, 1.0, 0.9]);
        // smaller steps go on
        assert_eq!(jumps(&falls), []);
        falls.placed[3] = (2.25, 2.5);
        let fold = jumps(&falls);
        assert_eq!((fold.len(), fold[0].before, fold[0].after, fold[0].placed), (1, 2.0, 3.0, (2.25, 2.5)));
        // started anew there are no steps
        falls.placed[3] = (f64::NAN, f64::NAN);
        falls.way = Way::Rest;
        assert_eq!(jumps(&falls).len(), 1);
        // two speeds read differently in every unit
        assert_eq!((digits((2.25, 2.5)), digits((2395.7, 2395.9))), (4, 6));
        let rpm = Style { units: Units::everyday(), ..Style::default() };
        for pair in [(2.25, 2.5), (2395.7, 2395.9), (1.057_19, 1.057_21), (999.999_96, 1000.0)] {
            for style in [Style::default(), rpm.clone()] {
                let [a, b] = [pair.0, pair.1].map(|w| style.arg(&Arg::speed(w).digits(digits(pair))));
                assert_ne!(a, b);
            }
        }
        // narrow resonances, sampled once or twice
        assert_eq!(jumps(&path(&[1.0, 1.1, 9.0, 1.1, 1.0])), []);
        assert_eq!(jumps(&path(&[1.0, 2.0, 8.0, 2.5, 1.0])), []);
        assert_eq!(jumps(&path(&[1.0, f64::NAN, 8.0, 2.5, 1.0])), []);
    }
}
