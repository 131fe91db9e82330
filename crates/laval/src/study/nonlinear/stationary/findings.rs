//! Findings for balancing: where it balances, where it does harm, where nothing is stable, what errors cost.

use super::classify::Class;
use super::errors::Errors;
use super::follow::Why;
use super::least::Least;
use super::ranges::{Harm, Range, existing, rest, union};
use super::report::{Report, Reported};
use super::{Varied, unit_of};
use crate::outcome::{Finding, quantity, significant};
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

fn speed(w: f64) -> String {
    quantity(w, "rad/s")
}

impl Report<'_> {
    pub(super) fn findings(&self, reported: &Reported) -> Vec<Finding> {
        let mut out = Vec::new();
        for (slot, text) in self.system.warnings() {
            let name = &self.system.slots()[slot].name;
            out.push(Finding::warning("hindered", format!("\"{name}\": {text}.")).of(name));
        }
        let movable = !self.found.images.angles.is_empty();
        if !movable {
            let text = "This machine has no masses that move round in the rotor, such as the balls of a balancer, for which this study is made: its states are its \
                        synchronous motion, which nonlinear_response follows as well.";
            out.push(Finding::info("no_masses", text));
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
        let place = if whole { "over the whole range, up to {}".to_string() } else { format!("from {} to {{}}", speed(r.from)) };
        let text = format!("Branch {} ({}) is stable {place}.", r.path + 1, r.class.words());
        Finding::info(id, text)
            .of(format!("branch {} from {}", r.path + 1, significant(r.from, 6)))
            .value(r.to, "rad/s")
            .evidence("from", r.from, "rad/s")
    }

    fn continuum(&self) -> Vec<Finding> {
        let all = self.continua.spans.iter();
        all.map(|s| {
            let kind = s.class.words();
            let text = match s.stable {
                false => {
                    let plural = if s.free > 1 { "s" } else { "" };
                    format!(
                        "Samples of a continuum of states that are {kind}, with {} free direction{plural}, were found from {} to {{}}.",
                        s.free,
                        speed(s.from)
                    )
                }
                true => {
                    format!("Of the samples of the continuum of states that are {kind} some are stable from {} to {{}}.", speed(s.from))
                }
            };
            let id = match (s.stable, s.class.balances()) {
                (false, _) => "continuum",
                (true, true) => "balanced_stable",
                (true, false) => "stable_states",
            };
            let here = self.continua.sheets.iter().filter(|x| (x.class, x.free) == (s.class, s.free) && (s.from..=s.to).contains(&x.speed));
            let (assessed, stable) = here.fold((0, 0), |n, x| (n.0 + x.samples, n.1 + x.stable));
            Finding::info(id, text)
                .of(format!("continuum from {}", significant(s.from, 6)))
                .value(s.to, "rad/s")
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
            let text = "No state at rest in axes that turn with the rotor was found.";
            return vec![Finding::warning("no_state", text).evidence("starts", self.found.starts[0] as f64, "")];
        }
        if !self.complete {
            return Vec::new();
        }
        let gaps = rest(self.range, &self.covered(reported, false), GAP * (self.range.1 - self.range.0));
        let movable = !self.found.images.angles.is_empty();
        let why = if movable { "the movable masses slip, the machine whirls, or no start led to one" } else { "the machine whirls" };
        let say = |(from, to): (f64, f64)| {
            let text = format!("No stable state was found from {} to {{}}: {why}.", speed(from));
            Finding::warning("no_stable_state", text)
                .of(format!("from {}", significant(from, 6)))
                .value(to, "rad/s")
                .evidence("from", from, "rad/s")
                .evidence("branches followed", self.found.paths.len() as f64, "")
        };
        // ends of two ranges at one change of stability are located each for itself
        gaps.into_iter().filter(|(from, to)| speed(*from) != speed(*to)).map(say).collect()
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
        for (from, to) in rest(self.range, &exist, GAP * width).into_iter().filter(|(from, to)| speed(*from) != speed(*to)) {
            // at the edge of existence the masses stand together or have nothing left
            let near = |w: f64| (w - from).abs().min((w - to).abs());
            let edge = seen.clone().filter(|(p, _)| p.class.balances()).min_by(|a, b| near(a.0.speed).total_cmp(&near(b.0.speed)));
            let share = edge.map(|(_, u)| u.correction.abs() / u.capacity).filter(|s| s.is_finite());
            let used = share.is_some_and(|s| s > USED_UP);
            let why = if used { ": the masses would need a larger moment than they have" } else { "" };
            let finding = Finding::warning("not_balanced", format!("No state that balances was found from {} to {{}}{why}.", speed(from)))
                .of(format!("from {}", significant(from, 6)))
                .value(to, "rad/s")
                .evidence("from", from, "rad/s");
            out.push(
                share.into_iter().fold(finding, |f, s| f.evidence("share of their capacity at the nearest state that balances", s, "")),
            );
        }
        out
    }

    fn harm(&self, reported: &Reported) -> Vec<Finding> {
        let say = |(k, h): &(usize, Harm)| {
            let r = &reported.ranges[*k];
            let (branch, class) = (r.path + 1, r.class.words());
            let ends = format!("{} to {}", speed(h.from), speed(h.to));
            let text = if h.relative {
                format!(
                    "The masses increase the unbalance from {ends}: stable states of branch {branch} ({class}) leave up to {{}} times that without them."
                )
            } else {
                format!(
                    "The masses unbalance the rotor from {ends}: stable states of branch {branch} ({class}) leave up to {{}}, and nothing is out of balance without them."
                )
            };
            Finding::warning("harm", text)
                .of(format!("branch {branch} from {}", significant(h.from, 6)))
                .value(h.most, if h.relative { "" } else { "kg m" })
                .evidence("from", h.from, "rad/s")
                .evidence("to", h.to, "rad/s")
        };
        reported.harm.iter().map(say).collect()
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
        let text = format!(
            "At {{}} speeds of the table, from {} to {}, a state that balances and one that does not are both stable: which is reached depends on the start.",
            speed(first),
            speed(last)
        );
        Some(
            Finding::warning("coexistence", text)
                .value(both.len() as f64, "")
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
        let share = match u.without() {
            0.0 => "; nothing is out of balance without the masses".to_string(),
            without if left > 0.0 => format!(", {} times that without the masses", significant(left / without, 3)),
            _ => String::new(),
        };
        let text = format!("At {} the best stable state found ({}) leaves an unbalance of {{}}{share}.", speed(nearest), class.words());
        let worst = all.iter().map(|x| x.1.moment.abs()).fold(u.moment.abs(), larger);
        let finding = Finding::info("residual_unbalance", text)
            .value(left, "kg m")
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
        let unit = unit_of(self.system, &requested.path);
        let (at, path) = (speed(requested.speed), &requested.path);
        let value = |x: f64| quantity(x, unit);
        let ends = format!("between {} and {}", value(requested.range.from), value(requested.range.to));
        let Some(class) = least.class else {
            let text = format!(
                "At {at} no state that balances was found at the {} values of {path} {ends} at which states were sought.",
                least.sought
            );
            return Finding::warning("least", text).of(path).evidence("values at which states were sought", least.sought as f64, "");
        };
        let state = if least.loose {
            format!("one state of the continuum that is {}", class.words())
        } else {
            format!("the state that is {}", class.words())
        };
        let limit_at = |x: f64| least.limits.iter().flatten().find(|l| l.value == x);
        // where it is followed no farther, and why
        let why = |x: f64| match limit_at(x).map(|l| l.why) {
            Some(Why::Exists) => ", where it ends",
            Some(Why::Half) => ", where it leaves half of the unbalance",
            Some(Why::Lost) => ", as far as it was followed",
            None => "",
        };
        let known: Vec<f64> = least.growth.iter().map(|g| g.1).filter(|g| g.is_finite()).collect();
        let (low, high) = (least.limits[0].map(|l| l.value), least.limits[1].map(|l| l.value));
        let exists = |x: f64| limit_at(x).is_some_and(|l| l.why == Why::Exists);
        let reach = match (low, high) {
            (None, None) => String::new(),
            (Some(a), None) if exists(a) => format!(" It exists from {} on.", value(a)),
            (None, Some(b)) if exists(b) => format!(" It exists up to {}.", value(b)),
            (Some(a), Some(b)) if exists(a) && exists(b) => format!(" It exists from {} to {}.", value(a), value(b)),
            (a, b) => {
                let from = a.map_or(String::new(), |a| format!(" from {}{}", value(a), why(a)));
                let to = b.map_or(String::new(), |b| format!(" to {}{}", value(b), why(b)));
                format!(" It was followed{from}{to}.")
            }
        };
        let gains = |x: f64| least.edges.iter().find(|e| e.gains && e.value == x);
        let (from, to) = least.stable.first().copied().unwrap_or((f64::NAN, f64::NAN));
        let whole = |x: f64, end: f64| x == end;
        let more = match least.stable.len() {
            0 | 1 => String::new(),
            n => format!(" It is stable in {n} ranges of {path}."),
        };
        let until = if whole(to, requested.range.to) { String::new() } else { format!(" and stays so up to {}{}", value(to), why(to)) };
        let (text, shown) = if least.stable.is_empty() {
            (format!("At {at} {state} is unstable at all {} values of {path} {ends} at which it was computed.{reach}", known.len()), None)
        } else if gains(from).is_some() {
            (format!("At {at} {state} becomes stable when {path} rises above {{}}{until}.{more}"), Some(from))
        } else if limit_at(from).is_some() {
            let first = if limit_at(from).is_some_and(|l| l.why == Why::Exists) { "exists and is stable" } else { "is stable" };
            let from_where = why(from).replace(", where it ends", "");
            (format!("At {at} {state} {first} when {path} rises above {{}}{from_where}{until}.{more}"), Some(from))
        } else if !whole(from, requested.range.from) {
            (format!("At {at} {state} is stable from {{}} to {} of {path}, as far as it was computed.{more}", value(to)), Some(from))
        } else if whole(to, requested.range.to) && least.stable.len() == 1 {
            (format!("At {at} {state} is stable at all {} values of {path} computed {ends}.", known.len()), None)
        } else {
            match least.edges.iter().find(|e| e.gains && e.value > to) {
                Some(e) => {
                    let until = format!("{}{}", value(to), why(to));
                    (
                        format!("At {at} {state} is stable until {path} rises above {until}, and again when it rises above {{}}.{more}"),
                        Some(e.value),
                    )
                }
                None => (format!("At {at} {state} is stable until {path} rises above {{}}{}.{more}", why(to)), Some(to)),
            }
        };
        let make = if least.stable.is_empty() { Finding::warning } else { Finding::info };
        let mut finding = make("least", text).of(path);
        if let Some(x) = shown {
            finding = finding.value(x, unit);
        }
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
        let (from, to) = (quantity(first.value, unit), quantity(last.value, unit));
        let at = speed(e.requested.speed);
        if let Some(lost) = e.costs.iter().position(|c| c.stable == 0) {
            let none = e.costs.iter().filter(|c| c.stable == 0).count();
            let onward = e.costs[lost..].iter().all(|c| c.stable == 0);
            let rest = if onward && none > 1 { format!(" and the {} larger values computed", none - 1) } else { String::new() };
            let rest = if onward { rest } else { format!(", and at {none} of {} values in all", e.costs.len()) };
            let text = format!("At {at} no stable state was found at {path} = {{}}{rest}.");
            let finding = Finding::warning("cost", text).of(path).value(e.costs[lost].value, unit);
            let before = lost.checked_sub(1).map(|k| e.costs[k].value);
            return Some(before.into_iter().fold(finding, |f, b| f.evidence("a stable state is there at", b, unit)));
        }
        if !(last.unbalance.0.is_finite() && first.unbalance.0.is_finite()) {
            return None;
        }
        let text = format!(
            "At {at} the best stable state found leaves an unbalance of {} with {path} = {from}, and of {{}} with {to} ({} without the masses).",
            quantity(left_of(first.unbalance.0, first.without), "kg m"),
            quantity(last.without, "kg m")
        );
        let most = e.costs.iter().map(|c| c.unbalance.0).fold(f64::NEG_INFINITY, larger);
        let harm = last.unbalance.0 > last.without;
        let make = if harm || !last.balances && first.balances { Finding::warning } else { Finding::info };
        let more = [
            ("left by the worst stable state at the end", last.unbalance.1, "kg m"),
            ("largest of the values computed", most, "kg m"),
            ("grade number at the end", last.grade, "m/s"),
        ];
        let mut finding = backed(make("cost", text).of(path).value(left_of(last.unbalance.0, last.without), "kg m"), &more);
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
        let text = format!(
            "Over speed and {}, of {{}} cells {} have stable states that balance only, {} such and others, {} others only; in {} none was found.",
            chart.path,
            count(only),
            count(both),
            count(not),
            count(none)
        );
        Some(Finding::info("chart", text).of(&chart.path).value(all as f64, "").evidence(
            "located points of the boundary",
            chart.edges.len() as f64,
            "",
        ))
    }
}

/// With what evidence has a value.
fn backed(finding: Finding, more: &[(&str, f64, &str)]) -> Finding {
    more.iter().filter(|m| m.1.is_finite()).fold(finding, |f, m| f.evidence(m.0, m.1, m.2))
}

/// The masses are too light for the unbalance.
fn capacity(reported: &Reported) -> Option<Finding> {
    let seen = reported.points.iter().filter_map(|p| p.seen.unbalance);
    let needed = seen.clone().map(|u| u.without()).reduce(larger).filter(|x| x.is_finite())?;
    let most = seen.map(|u| u.capacity).reduce(larger).filter(|most| *most < (1.0 - NOTHING) * needed)?;
    let text = format!("The masses can cancel {{}} at most, less than the unbalance of {}.", quantity(needed, "kg m"));
    Some(Finding::warning("insufficient_capacity", text).value(most, "kg m").evidence("needed", needed, "kg m"))
}

fn completeness(found: &Found, loose: usize, complete: bool) -> Vec<Finding> {
    let [starts, led, known] = found.starts.map(|n| n as f64);
    let share = if led > 0.0 { (known + loose as f64) / led } else { 0.0 };
    let so_far = if complete { "" } else { " before the study stopped" };
    let text = format!(
        "{} branches of states were found{so_far}; {{}} of the starts that led to a state led to one known before.",
        found.paths.len()
    );
    let reported = Finding::info("completeness", text)
        .value(share, "")
        .evidence("starts", starts, "")
        .evidence("starts that led to a state", led, "")
        .evidence("starts that led to states that are not isolated", loose as f64, "");
    let crowded = Finding::warning("too_many_branches", "There are more branches of states than are followed: the list is not complete.");
    if found.crowded { vec![reported, crowded] } else { vec![reported] }
}

fn unfinished(found: &Found) -> Option<Finding> {
    let lost = |(k, p): (usize, &crate::solve::stationary::Path)| {
        let ends = [p.branch.first_end.as_ref(), Some(&p.branch.end)];
        let at = ends.into_iter().flatten().find_map(|e| match e {
            End::StepTooSmall { at, .. } => Some(*at),
            End::MaxPoints => p.branch.points.last().map(|q| q.p),
            _ => None,
        })?;
        Some(format!("branch {} near {}", k + 1, speed(at)))
    };
    let all: Vec<String> = found.paths.iter().enumerate().filter_map(lost).collect();
    let few = all.iter().take(5).cloned().collect::<Vec<_>>().join(", ");
    let more = if all.len() > 5 { format!(" and {} more", all.len() - 5) } else { String::new() };
    (!all.is_empty()).then(|| Finding::warning("unfinished", format!("Not followed to their ends: {few}{more}.")))
}

/// Classes in a sentence for those who cannot see the figure.
pub(super) fn alt(ranges: &[Range], branches: usize) -> String {
    let each = ranges.iter().map(|r| format!("{} from {} to {} rad/s", words(r.class), significant(r.from, 4), significant(r.to, 4)));
    let stable = each.collect::<Vec<_>>().join("; ");
    let stable = if stable.is_empty() { "no state is stable".to_string() } else { format!("stable: {stable}") };
    format!("{branches} branches of states at rest in turning axes over the spin speed; {stable}.")
}

fn words(class: Class) -> &'static str {
    class.words()
}
