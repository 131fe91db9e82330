//! Findings for balancing: where it balances, where it does harm, where nothing is stable, what errors cost.

use super::classify::Class;
use super::errors::Errors;
use super::follow::{Limit, Why};
use super::least::Least;
use super::ranges::{Harm, Range, existing, rest, union};
use super::report::{Report, Reported};
use super::{Varied, unit_of};
use crate::outcome::{Arg, Finding, Message, significant};
use crate::solve::stationary::Found;
use crate::solve::unbalance::Unbalance;
use crate::study::shared::support::larger;
use crate::study::shared::validity::Uses;
use laval_num::continuation::End;

/// Share of the range below which a gap between two intervals is none.
const GAP: f64 = 1e-6;
/// Share of their capacity above which the masses have nothing left.
const USED_UP: f64 = 0.999;

/// Share of the unbalance without the masses below which what is left is rounding.
const NOTHING: f64 = 1e-9;

/// What is left, or zero where it is rounding beside what was there.
fn left_of(left: f64, without: f64) -> f64 {
    if left <= NOTHING * without { 0.0 } else { left }
}

/// Ends of two ranges at one change of stability are located each for itself: what differs less is no gap.
fn wide(ends: &(f64, f64)) -> bool {
    significant(ends.0, 4) != significant(ends.1, 4)
}

/// The kind of a state.
pub(super) fn kind(class: Class) -> Message {
    Message::new("stationary-kind").arg("kind", Arg::word(class.word()))
}

/// A state that balances.
pub(super) fn balancing(class: Class) -> Message {
    Message::new("stationary-state").arg("kind", Arg::word(class.word()))
}

impl Report<'_> {
    pub(super) fn findings(&self, reported: &Reported) -> Vec<Finding> {
        let mut out = Vec::new();
        for (slot, reason) in self.system.warnings() {
            let name = &self.system.slots()[slot].name;
            let finding = Finding::warning("hindered", "stationary-hindered").of(name);
            out.push(finding.arg("part", Arg::name(name)).arg("reason", reason));
        }
        let movable = !self.found.images.angles.is_empty();
        if !movable {
            out.push(Finding::info("no_masses", "stationary-no-balls"));
        }
        out.extend(capacity(reported).filter(|_| movable));
        out.extend(self.operating());
        out.extend(reported.ranges.iter().map(|r| self.stable(r)));
        out.extend(self.continuum());
        out.extend(super::zones::finding(self.rows, self.zones, self.operating));
        out.extend(super::slack::finding(&self.continua.sheets, self.slack, self.operating));
        out.extend(self.unstable(reported));
        if movable {
            out.extend(self.unbalanced(reported));
            out.extend(self.harm(reported));
            out.extend(self.coexisting());
        }
        if let (Some(least), Some(requested)) = (&self.least, self.stabilise) {
            out.push(self.stabilised(least, requested));
        }
        out.extend(self.errors.iter().filter_map(|e| self.cost(e)));
        out.extend(self.charted());
        let mut uses = Uses::default();
        let seen =
            self.rows.iter().map(|r| &r.seen).chain(reported.points.iter().map(|p| &p.seen)).chain(&reported.special).map(|s| &s.uses);
        seen.chain(self.continua.sheets.iter().map(|s| &s.uses)).for_each(|u| uses.join(u));
        out.extend(uses.of_states(self.system));
        out.extend(completeness(self.found, self.continua.starts, self.complete));
        out.extend(unfinished(self.found));
        out
    }

    fn stable(&self, r: &Range) -> Finding {
        let id = if r.class.balances() { "balanced_stable" } else { "stable_states" };
        let whole = r.from <= self.range.0 && r.to >= self.range.1;
        Finding::info(id, if whole { "stationary-stable-throughout" } else { "stationary-stable" })
            .of(format!("branch {} from {}", r.path + 1, significant(r.from, 6)))
            .value(r.to, "rad/s")
            .arg("branch", Arg::count(r.path + 1))
            .arg("kind", kind(r.class))
            .arg("from", Arg::speed(r.from))
            .evidence("from", r.from, "rad/s")
    }

    fn continuum(&self) -> Vec<Finding> {
        let all = self.continua.spans.iter();
        all.map(|s| {
            let id = match (s.stable, s.class.balances()) {
                (false, _) => "continuum",
                (true, true) => "balanced_stable",
                (true, false) => "stable_states",
            };
            let here = self.continua.sheets.iter().filter(|x| (x.class, x.free) == (s.class, s.free) && (s.from..=s.to).contains(&x.speed));
            let (assessed, stable) = here.fold((0, 0), |n, x| (n.0 + x.samples, n.1 + x.stable));
            Finding::info(id, if s.stable { "stationary-continuum-stable" } else { "stationary-continuum" })
                .of(format!("continuum from {}", significant(s.from, 6)))
                .value(s.to, "rad/s")
                .arg("kind", kind(s.class))
                .arg("free", Arg::count(s.free))
                .arg("from", Arg::speed(s.from))
                .evidence("from", s.from, "rad/s")
                .evidence("samples assessed", assessed as f64, "")
                .evidence("stable samples", stable as f64, "")
        })
        .collect()
    }

    /// Speeds at which some state is stable.
    fn covered(&self, reported: &Reported, balanced: bool) -> Vec<(f64, f64)> {
        let ranges = reported.ranges.iter().filter(|r| !balanced || r.class.balances()).map(|r| (r.from, r.to));
        let spans = self.continua.spans.iter().filter(|s| s.stable && (!balanced || s.class.balances())).map(|s| (s.from, s.to));
        union(ranges.chain(spans).collect(), GAP * (self.range.1 - self.range.0))
    }

    fn unstable(&self, reported: &Reported) -> Vec<Finding> {
        if self.complete && reported.points.is_empty() && self.continua.sheets.is_empty() {
            return vec![Finding::warning("no_state", "stationary-no-state").evidence("starts", self.found.starts[0] as f64, "")];
        }
        if !self.complete {
            return Vec::new();
        }
        let gaps = rest(self.range, &self.covered(reported, false), GAP * (self.range.1 - self.range.0));
        let movable = !self.found.images.angles.is_empty();
        let gap = |(from, to): (f64, f64)| {
            Finding::warning("no_stable_state", "stationary-no-stable-state")
                .of(format!("from {}", significant(from, 6)))
                .value(to, "rad/s")
                .arg("from", Arg::speed(from))
                .arg("balls", Arg::word(if movable { "yes" } else { "no" }))
                .evidence("from", from, "rad/s")
                .evidence("branches followed", self.found.paths.len() as f64, "")
        };
        gaps.into_iter().filter(wide).map(gap).collect()
    }

    /// Where there is no state that balances, and whether the masses suffice.
    fn unbalanced(&self, reported: &Reported) -> Vec<Finding> {
        if !self.complete {
            return Vec::new();
        }
        let mut out = Vec::new();
        let seen = reported.points.iter().filter_map(|p| Some((p, p.seen.unbalance?)));
        let spans = self.continua.spans.iter().filter(|s| s.class.balances()).map(|s| (s.from, s.to));
        let width = self.range.1 - self.range.0;
        let exist = union(existing(self.found, &reported.points).into_iter().chain(spans).collect(), GAP * width);
        for (from, to) in rest(self.range, &exist, GAP * width).into_iter().filter(wide) {
            // at the edge of existence the masses stand together or have nothing left
            let near = |w: f64| (w - from).abs().min((w - to).abs());
            let edge = seen.clone().filter(|(p, _)| p.class.balances()).min_by(|a, b| near(a.0.speed).total_cmp(&near(b.0.speed)));
            let share = edge.map(|(_, u)| u.correction.abs() / u.capacity).filter(|s| s.is_finite());
            let used = share.is_some_and(|s| s > USED_UP);
            let finding = Finding::warning("not_balanced", "stationary-not-balanced")
                .of(format!("from {}", significant(from, 6)))
                .value(to, "rad/s")
                .arg("from", Arg::speed(from))
                .arg("capacity", Arg::word(if used { "used" } else { "left" }))
                .evidence("from", from, "rad/s");
            out.push(
                share.into_iter().fold(finding, |f, s| f.evidence("share of their capacity at the nearest state that balances", s, "")),
            );
        }
        out
    }

    fn harm(&self, reported: &Reported) -> Vec<Finding> {
        let one = |(k, h): &(usize, Harm)| {
            let r = &reported.ranges[*k];
            let branch = r.path + 1;
            let finding = if h.relative {
                // at least 1.001 times, which three digits do not tell from 1
                Finding::warning("harm", "stationary-harm").value_as(Arg::number(h.most).digits(4))
            } else {
                Finding::warning("harm", "stationary-harm-of-balanced").value(h.most, "kg m")
            };
            finding
                .of(format!("branch {branch} from {}", significant(h.from, 6)))
                .arg("branch", Arg::count(branch))
                .arg("kind", kind(r.class))
                .arg("from", Arg::speed(h.from))
                .arg("to", Arg::speed(h.to))
                .evidence("from", h.from, "rad/s")
                .evidence("to", h.to, "rad/s")
        };
        reported.harm.iter().map(one).collect()
    }

    /// Speeds of the table at which the balanced state is stable and another is, too.
    fn coexisting(&self) -> Option<Finding> {
        let mut speeds: Vec<f64> = self.rows.iter().map(|r| r.state.speed).collect();
        speeds.dedup();
        let stable = |w: f64| self.rows.iter().filter(move |r| r.state.speed == w && r.stable());
        let both: Vec<f64> = speeds
            .into_iter()
            .filter(|&w| {
                let sheet =
                    |balanced: bool| self.continua.sheets.iter().any(|s| s.speed == w && s.stable > 0 && s.class.balances() == balanced);
                (stable(w).any(|r| r.class.balances()) || sheet(true)) && (stable(w).any(|r| !r.class.balances()) || sheet(false))
            })
            .collect();
        let (first, last) = (both.first().copied()?, both.last().copied()?);
        Some(
            Finding::warning("coexistence", "stationary-coexistence")
                .value(both.len() as f64, "")
                .arg("speeds", Arg::count(both.len()))
                .arg("from", Arg::speed(first))
                .arg("to", Arg::speed(last))
                .evidence("from", first, "rad/s")
                .evidence("to", last, "rad/s"),
        )
    }

    /// What is stable at the operating speed, the best state first.
    fn operating(&self) -> Option<Finding> {
        let w = self.operating;
        let speeds = self.rows.iter().map(|r| r.state.speed).chain(self.continua.sheets.iter().map(|s| s.speed));
        let nearest = speeds.min_by(|a, b| (a - w).abs().total_cmp(&(b - w).abs()))?;
        let alone = self.rows.iter().filter(|r| r.state.speed == nearest && r.stable());
        let alone = alone.filter_map(|r| Some((r.class, r.seen.unbalance?)));
        let sheets = self.continua.sheets.iter().filter(|s| s.speed == nearest && s.stable > 0);
        let all: Vec<(Class, Unbalance)> = alone.chain(sheets.filter_map(|s| Some((s.class, s.unbalance?)))).collect();
        let (class, u) = *all.iter().min_by(|a, b| a.1.moment.abs().total_cmp(&b.1.moment.abs()))?;
        if !(u.moment.abs().is_finite() && u.without().is_finite()) {
            return None;
        }
        let left = left_of(u.moment.abs(), u.without());
        let worst = all.iter().map(|x| x.1.moment.abs()).fold(u.moment.abs(), larger);
        let finding = Finding::info("residual_unbalance", "stationary-residual-unbalance")
            .value(left, "kg m")
            .arg("speed", Arg::speed(nearest))
            .arg("kind", kind(class));
        let finding = match u.without() {
            0.0 => finding.arg("beside", Arg::word("nothing")),
            without if left > 0.0 => finding.arg("beside", Arg::word("times")).arg("times", Arg::number(left / without)),
            _ => finding.arg("beside", Arg::word("none")),
        };
        let finding = finding
            .evidence("speed", nearest, "rad/s")
            .evidence("without the masses", u.without(), "kg m")
            .evidence("capacity", u.capacity, "kg m");
        let more = [
            ("left by the worst stable state", worst, "kg m"),
            ("grade number (ISO 21940-11)", u.grade(u.moment.abs(), nearest), "m/s"),
            ("grade number without the masses", u.grade(u.without(), nearest), "m/s"),
        ];
        Some(backed(finding, &more))
    }

    fn stabilised(&self, least: &Least, requested: &Varied) -> Finding {
        let (path, unit) = (&requested.path, unit_of(self.system, &requested.path));
        let (lowest, highest) = (requested.range.from, requested.range.to);
        let value = |x: f64| Arg::quantity(x, unit);
        let common = |f: Finding| {
            let f = f.of(path).arg("speed", Arg::speed(requested.speed)).arg("parameter", Arg::name(path));
            f.arg("lowest", value(lowest)).arg("highest", value(highest))
        };
        let Some(class) = least.class else {
            return common(Finding::warning("least", "stationary-least-no-state")).arg("sought", Arg::count(least.sought)).evidence(
                "values at which states were sought",
                least.sought as f64,
                "",
            );
        };
        let state = if least.loose { Message::new("stationary-sample").arg("kind", Arg::word(class.word())) } else { balancing(class) };
        let limit_at = |x: f64| least.limits.iter().flatten().find(|l| l.value == x);
        let why = |x: f64| limit_at(x).map_or("open", |l| ending(l.why));
        let gains = |x: f64| least.edges.iter().find(|e| e.gains && e.value == x);
        let known: Vec<f64> = least.growth.iter().map(|g| g.1).filter(|g| g.is_finite()).collect();
        let (from, to) = least.stable.first().copied().unwrap_or((f64::NAN, f64::NAN));
        let again = least.edges.iter().find(|e| e.gains && e.value > to);
        let (key, shown) = match () {
            () if least.stable.is_empty() => ("stationary-least-unstable", None),
            () if gains(from).is_some() => ("stationary-least-above", Some(from)),
            () if limit_at(from).is_some() => ("stationary-least-from-limit", Some(from)),
            () if from != lowest => ("stationary-least-between", Some(from)),
            () if to == highest && least.stable.len() == 1 => ("stationary-least-everywhere", None),
            () => match again {
                Some(e) => ("stationary-least-outside", Some(e.value)),
                None => ("stationary-least-below", Some(to)),
            },
        };
        let make = if least.stable.is_empty() { Finding::warning } else { Finding::info };
        let mut finding = common(make("least", key)).arg("state", state).arg("computed", Arg::count(known.len()));
        if let Some(x) = shown {
            finding = finding.value(x, unit);
        }
        finding = if least.stable.is_empty() {
            finding.arg("reach", reach(least, &value))
        } else {
            let ranges = Message::new("stationary-least-ranges").arg("ranges", Arg::count(least.stable.len()));
            finding
                .arg("begins", Arg::word(why(from)))
                .arg("to", value(to))
                .arg("ends", Arg::word(if to == highest { "none" } else { why(to) }))
                .arg("ranges", ranges.arg("parameter", Arg::name(path)))
        };
        if let Some(frequency) = gains(from).map(|e| e.frequency).filter(|f| f.is_finite()) {
            finding = finding.evidence("frequency of the root in turning axes", frequency, "rad/s");
        }
        if let Some(l) = limit_at(from) {
            finding = finding.evidence("width of the bracket of the limit", l.bracket.1 - l.bracket.0, unit);
        }
        let finding = known
            .iter()
            .copied()
            .reduce(f64::max)
            .into_iter()
            .fold(finding, |f, worst| f.evidence("largest growth rate in the range", worst, "1/s"));
        finding.evidence("values computed", known.len() as f64, "")
    }

    fn cost(&self, e: &Errors) -> Option<Finding> {
        let (path, unit) = (&e.requested.path, unit_of(self.system, &e.requested.path));
        let (first, last) = (e.costs.first()?, e.costs.last()?);
        let common = |f: Finding| f.of(path).arg("speed", Arg::speed(e.requested.speed)).arg("parameter", Arg::name(path));
        if let Some(lost) = e.costs.iter().position(|c| c.stable == 0) {
            let none = e.costs.iter().filter(|c| c.stable == 0).count();
            let onward = e.costs[lost..].iter().all(|c| c.stable == 0);
            let more = match (onward, none) {
                (true, 1) => "none",
                (true, _) => "larger",
                (false, _) => "some",
            };
            let finding = common(Finding::warning("cost", "stationary-cost-no-stable-state"))
                .value(e.costs[lost].value, unit)
                .arg("more", Arg::word(more))
                .arg("larger", Arg::count(none - 1))
                .arg("none", Arg::count(none))
                .arg("computed", Arg::count(e.costs.len()));
            let before = lost.checked_sub(1).map(|k| e.costs[k].value);
            return Some(before.into_iter().fold(finding, |f, b| f.evidence("a stable state is there at", b, unit)));
        }
        if !(last.unbalance.0.is_finite() && first.unbalance.0.is_finite()) {
            return None;
        }
        let most = e.costs.iter().map(|c| c.unbalance.0).fold(f64::NEG_INFINITY, larger);
        let effect = match () {
            () if last.unbalance.0 > last.without => "harm",
            () if !last.balances && first.balances => "lost",
            () => "none",
        };
        let make = if effect == "none" { Finding::info } else { Finding::warning };
        let more = [
            ("left by the worst stable state at the end", last.unbalance.1, "kg m"),
            ("largest of the values computed", most, "kg m"),
            ("grade number at the end", last.grade, "m/s"),
        ];
        let finding = common(make("cost", "stationary-cost"))
            .value(left_of(last.unbalance.0, last.without), "kg m")
            .arg("to", Arg::quantity(last.value, unit))
            .arg("first", Arg::quantity(left_of(first.unbalance.0, first.without), "kg m"))
            .arg("from", Arg::quantity(first.value, unit))
            .arg("without", Arg::quantity(last.without, "kg m"))
            .arg("effect", Arg::word(effect));
        let mut finding = backed(finding, &more);
        if let Some(c) = e.costs.iter().find(|c| first.balances && !c.balances) {
            finding = finding.evidence("first value at which no stable state balances", c.value, unit);
        }
        Some(finding)
    }

    fn charted(&self) -> Option<Finding> {
        let chart = self.chart.as_ref()?;
        let count = |word: &str| chart.cells.iter().filter(|c| c.word() == word).count();
        let [only, both, not, none] = super::chart::WORDS else { return None };
        let all = chart.cells.len();
        Some(
            Finding::info("chart", "stationary-chart")
                .of(&chart.path)
                .value(all as f64, "")
                .arg("parameter", Arg::name(&chart.path))
                .arg("balanced", Arg::count(count(only)))
                .arg("bistable", Arg::count(count(both)))
                .arg("unbalanced", Arg::count(count(not)))
                .arg("unstable", Arg::count(count(none)))
                .evidence("located points of the boundary", chart.edges.len() as f64, ""),
        )
    }
}

/// Why a state is followed no farther, as a word of the sentences.
fn ending(why: Why) -> &'static str {
    match why {
        Why::Exists => "exists",
        Why::Half => "half",
        Why::Lost => "lost",
    }
}

/// Down to which value and up to which the state exists, or was followed.
fn reach(least: &Least, value: &dyn Fn(f64) -> Arg) -> Arg {
    let ends = [("stationary-down-to", least.limits[0]), ("stationary-up-to", least.limits[1])];
    let ends: Vec<(&str, Limit)> = ends.into_iter().filter_map(|(key, l)| Some((key, l?))).collect();
    let exists = ends.iter().all(|e| e.1.why == Why::Exists);
    let phrase = |(key, l): (&str, Limit)| {
        let why = if exists { "open" } else { ending(l.why) };
        Message::new(key).arg("end", value(l.value)).arg("why", Arg::word(why)).into()
    };
    if ends.is_empty() {
        return Arg::word("none");
    }
    let key = if exists { "stationary-exists" } else { "stationary-followed" };
    Message::new(key).arg("ends", Arg::List(ends.into_iter().map(phrase).collect())).into()
}

/// With what evidence has a value.
fn backed(finding: Finding, more: &[(&'static str, f64, &str)]) -> Finding {
    more.iter().filter(|m| m.1.is_finite()).fold(finding, |f, m| f.evidence(m.0, m.1, m.2))
}

/// The masses are too light for the unbalance.
fn capacity(reported: &Reported) -> Option<Finding> {
    let seen = reported.points.iter().filter_map(|p| p.seen.unbalance);
    let needed = seen.clone().map(|u| u.without()).reduce(larger).filter(|x| x.is_finite())?;
    let most = seen.map(|u| u.capacity).reduce(larger).filter(|most| *most < (1.0 - NOTHING) * needed)?;
    let finding = Finding::warning("insufficient_capacity", "stationary-insufficient-capacity").value(most, "kg m");
    Some(finding.arg("missing", Arg::quantity(needed - most, "kg m")).evidence("needed", needed, "kg m"))
}

fn completeness(found: &Found, loose: usize, complete: bool) -> Vec<Finding> {
    let [starts, led, known] = found.starts.map(|n| n as f64);
    let share = if led > 0.0 { (known + loose as f64) / led } else { 0.0 };
    let reported = Finding::info("completeness", "stationary-completeness")
        .value_as(Arg::percent(share))
        .arg("branches", Arg::count(found.paths.len()))
        .arg("stopped", Arg::word(if complete { "no" } else { "yes" }))
        .evidence("starts", starts, "")
        .evidence("starts that led to a state", led, "")
        .evidence("starts that led to states that are not isolated", loose as f64, "");
    let crowded = Finding::warning("too_many_branches", "stationary-too-many-branches");
    if found.crowded { vec![reported, crowded] } else { vec![reported] }
}

/// Branches that are named in one sentence.
const NAMED: usize = 5;

fn unfinished(found: &Found) -> Option<Finding> {
    let lost = |(k, p): (usize, &crate::solve::stationary::Path)| {
        let ends = [p.branch.first_end.as_ref(), Some(&p.branch.end)];
        let at = ends.into_iter().flatten().find_map(|e| match e {
            End::StepTooSmall { at, .. } => Some(*at),
            End::MaxPoints => p.branch.points.last().map(|q| q.p),
            _ => None,
        })?;
        Some(Message::new("stationary-branch-near").arg("branch", Arg::count(k + 1)).arg("speed", Arg::speed(at)))
    };
    let all: Vec<Message> = found.paths.iter().enumerate().filter_map(lost).collect();
    let more = all.len().checked_sub(NAMED).filter(|n| *n > 0).map(|n| Message::new("stationary-more").arg("count", Arg::count(n)));
    let branches = all.iter().take(NAMED).cloned().chain(more).map(Arg::Phrase).collect();
    (!all.is_empty()).then(|| Finding::warning("unfinished", "stationary-unfinished").arg("branches", Arg::List(branches)))
}

/// The figure for those who cannot see it.
pub(super) fn alt(ranges: &[Range], branches: usize) -> Message {
    let each = ranges.iter().map(|r| {
        let range = Message::new("stationary-alt-range").arg("state", Arg::term(r.class.words()));
        range.arg("from", Arg::speed(r.from)).arg("to", Arg::speed(r.to)).into()
    });
    Message::new("stationary-alt")
        .arg("branches", Arg::count(branches))
        .arg("stable", Arg::count(ranges.len()))
        .arg("ranges", Arg::List(each.collect()))
}
