//! What a balancing engineer is told: where it balances, where it does harm, where nothing is stable, what errors cost.

use super::classify::Class;
use super::errors::Errors;
use super::least::Least;
use super::ranges::{Range, existing, harmful, rest, union};
use super::report::{Report, Told};
use super::{Row, Varied, unit_of};
use crate::outcome::{Finding, quantity, significant};
use crate::solve::stationary::Found;
use crate::study::support::larger;
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
    pub(super) fn findings(&self, told: &Told) -> Vec<Finding> {
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
        out.extend(capacity(told).filter(|_| movable));
        out.extend(self.operating());
        out.extend(told.ranges.iter().map(|r| self.stable(r)));
        out.extend(self.continuum());
        out.extend(super::zones::finding(&self.rows, &self.zones, self.operating));
        out.extend(super::slack::finding(&self.continua.sheets, &self.slack, self.operating));
        out.extend(self.unstable(told));
        if movable {
            out.extend(self.unbalanced(told));
            out.extend(self.harm(told));
            out.extend(self.coexisting());
        }
        if let (Some(least), Some(asked)) = (&self.least, self.stabilise) {
            out.push(self.stabilised(least, asked));
        }
        out.extend(self.errors.iter().filter_map(|e| self.cost(e)));
        out.extend(self.charted());
        out.extend(completeness(self.found, self.continua.starts));
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
                        "States that are {kind} form a continuum with {} free direction{plural} from {} to {{}}.",
                        s.free,
                        speed(s.from)
                    )
                }
                true => format!("Of the continuum of states that are {kind} some are stable from {} to {{}}.", speed(s.from)),
            };
            let id = match (s.stable, s.class.balances()) {
                (false, _) => "continuum",
                (true, true) => "balanced_stable",
                (true, false) => "stable_states",
            };
            let here = self.continua.sheets.iter().filter(|x| (x.class, x.free) == (s.class, s.free) && (s.from..=s.to).contains(&x.speed));
            let (judged, stable) = here.fold((0, 0), |n, x| (n.0 + x.samples, n.1 + x.stable));
            Finding::info(id, text)
                .of(format!("continuum from {}", significant(s.from, 6)))
                .value(s.to, "rad/s")
                .evidence("from", s.from, "rad/s")
                .evidence("samples judged", judged as f64, "")
                .evidence("stable samples", stable as f64, "")
        })
        .collect()
    }

    /// Speeds at which some state is stable.
    fn covered(&self, told: &Told, balanced: bool) -> Vec<(f64, f64)> {
        let ranges = told.ranges.iter().filter(|r| !balanced || r.class.balances()).map(|r| (r.from, r.to));
        let spans = self.continua.spans.iter().filter(|s| s.stable && (!balanced || s.class.balances())).map(|s| (s.from, s.to));
        union(ranges.chain(spans).collect(), GAP * (self.range.1 - self.range.0))
    }

    fn unstable(&self, told: &Told) -> Vec<Finding> {
        if self.complete && told.points.is_empty() && self.continua.sheets.is_empty() {
            let text = "No state at rest in axes that turn with the rotor was found.";
            return vec![Finding::warning("no_state", text).evidence("starts", self.found.starts[0] as f64, "")];
        }
        if !self.complete {
            return Vec::new();
        }
        let gaps = rest(self.range, &self.covered(told, false), GAP * (self.range.1 - self.range.0));
        let movable = !self.found.images.angles.is_empty();
        let why = if movable { "the movable masses slip, the machine whirls, or the starts met none" } else { "the machine whirls" };
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
    fn unbalanced(&self, told: &Told) -> Vec<Finding> {
        if !self.complete {
            return Vec::new();
        }
        let mut out = Vec::new();
        let seen = told.points.iter().filter_map(|p| Some((p, p.seen.unbalance?)));
        let spans = self.continua.spans.iter().filter(|s| s.class.balances()).map(|s| (s.from, s.to));
        let width = self.range.1 - self.range.0;
        let exist = union(existing(&told.points).into_iter().chain(spans).collect(), GAP * width);
        for (from, to) in rest(self.range, &exist, GAP * width).into_iter().filter(|(from, to)| speed(*from) != speed(*to)) {
            // at the edge of existence the masses stand together or have nothing left
            let near = |w: f64| (w - from).abs().min((w - to).abs());
            let edge = seen.clone().filter(|(p, _)| p.class.balances()).min_by(|a, b| near(a.0.speed).total_cmp(&near(b.0.speed)));
            let share = edge.map(|(_, u)| u.correction.abs() / u.capacity).filter(|s| s.is_finite());
            let used = share.is_some_and(|s| s > USED_UP);
            let why = if used { ": the masses would need a larger moment than they have" } else { "" };
            let finding = Finding::warning("not_balanced", format!("No state balances from {} to {{}}{why}.", speed(from)))
                .of(format!("from {}", significant(from, 6)))
                .value(to, "rad/s")
                .evidence("from", from, "rad/s");
            out.push(
                share.into_iter().fold(finding, |f, s| f.evidence("share of their capacity at the nearest state that balances", s, "")),
            );
        }
        out
    }

    fn harm(&self, told: &Told) -> Vec<Finding> {
        let mut out = Vec::new();
        for r in &told.ranges {
            for (from, to, most) in harmful(&told.points, r) {
                let text = format!(
                    "The masses do harm from {} to {}: where branch {} ({}) is stable they leave up to {{}} times the unbalance without them.",
                    speed(from),
                    speed(to),
                    r.path + 1,
                    r.class.words()
                );
                out.push(
                    Finding::warning("harm", text)
                        .of(format!("branch {} from {}", r.path + 1, significant(from, 6)))
                        .value(most, "")
                        .evidence("from", from, "rad/s")
                        .evidence("to", to, "rad/s"),
                );
            }
        }
        out
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
        let nearest = self.rows.iter().map(|r| r.state.speed).min_by(|a, b| (a - w).abs().total_cmp(&(b - w).abs()))?;
        let stable = || self.rows.iter().filter(|r| r.state.speed == nearest && r.stable());
        let left = |r: &&Row| r.seen.unbalance.map_or(f64::NAN, |u| u.moment.abs());
        let best = stable().min_by(|a, b| left(a).total_cmp(&left(b)))?;
        let u = best.seen.unbalance.filter(|u| u.moment.abs().is_finite() && u.without().is_finite())?;
        let share = best
            .seen
            .share()
            .filter(|s| *s > NOTHING)
            .map_or(String::new(), |s| format!(", {} times that without the masses", significant(s, 3)));
        let text = format!("At {} the best stable state ({}) leaves an unbalance of {{}}{share}.", speed(nearest), best.class.words());
        let worst = stable().map(|r| left(&r)).fold(u.moment.abs(), larger);
        let finding = Finding::info("residual_unbalance", text)
            .value(left_of(u.moment.abs(), u.without()), "kg m")
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

    fn stabilised(&self, least: &Least, asked: &Varied) -> Finding {
        let unit = unit_of(self.system, &asked.path);
        let at = speed(asked.speed);
        let (lo, hi) = (quantity(asked.range.from, unit), quantity(asked.range.to, unit));
        let Some(class) = least.class else {
            let text = format!("There is no state at {at} that balances, whatever {} between {lo} and {hi}.", asked.path);
            return Finding::warning("least", text).of(&asked.path);
        };
        let state = if least.loose {
            format!("one state of the continuum that is {}", class.words())
        } else {
            format!("the state that is {}", class.words())
        };
        match least.edges.iter().find(|e| e.gains) {
            Some(e) => {
                let text = format!("At {at} {state} becomes stable when {} rises above {{}}.", asked.path);
                let finding = Finding::info("least", text).of(&asked.path).value(e.value, unit);
                if e.frequency.is_finite() {
                    finding.evidence("frequency of the root in turning axes", e.frequency, "rad/s")
                } else {
                    finding
                }
            }
            None => {
                let stable = least.growth.iter().all(|g| g.1 <= 0.0);
                let lost = least.edges.first();
                let text = match lost {
                    _ if stable => format!("At {at} {state} is stable for every {} between {lo} and {hi}.", asked.path),
                    Some(e) => format!("At {at} {state} is stable until {} rises above {}.", asked.path, quantity(e.value, unit)),
                    None => format!("At {at} {state} is nowhere made stable by {} between {lo} and {hi}.", asked.path),
                };
                let worst = least.growth.iter().map(|g| g.1).filter(|g| g.is_finite()).reduce(f64::max);
                let finding = if stable || lost.is_some() { Finding::info("least", text) } else { Finding::warning("least", text) };
                worst.into_iter().fold(finding.of(&asked.path), |f, worst| f.evidence("largest growth rate in the range", worst, "1/s"))
            }
        }
    }

    fn cost(&self, e: &Errors) -> Option<Finding> {
        let (path, unit) = (&e.asked.path, unit_of(self.system, &e.asked.path));
        let (first, last) = (e.costs.first()?, e.costs.last()?);
        let (from, to) = (quantity(first.value, unit), quantity(last.value, unit));
        let at = speed(e.asked.speed);
        if let Some(lost) = e.costs.iter().find(|c| c.stable == 0) {
            let text = format!("At {at} no state is stable from {path} = {{}} on.");
            return Some(Finding::warning("cost", text).of(path).value(lost.value, unit));
        }
        if !(last.unbalance.0.is_finite() && first.unbalance.0.is_finite()) {
            return None;
        }
        let text = format!(
            "At {at}, with {path} from {from} to {to}, the best stable state leaves {} to {{}} of unbalance ({} without the masses).",
            quantity(left_of(first.unbalance.0, first.without), "kg m"),
            quantity(last.without, "kg m")
        );
        let harm = last.unbalance.0 > last.without;
        let make = if harm || !last.balances && first.balances { Finding::warning } else { Finding::info };
        let more =
            [("left by the worst stable state at the end", last.unbalance.1, "kg m"), ("grade number at the end", last.grade, "m/s")];
        let mut finding = backed(make("cost", text).of(path).value(left_of(last.unbalance.0, last.without), "kg m"), &more);
        if let Some(c) = e.costs.iter().find(|c| first.balances && !c.balances) {
            finding = finding.evidence("no stable state balances from", c.value, unit);
        }
        Some(finding)
    }

    fn charted(&self) -> Option<Finding> {
        let chart = self.chart.as_ref()?;
        let count = |word: &str| chart.cells.iter().filter(|c| c.word() == word).count();
        let [only, both, not, none] = super::chart::WORDS else { return None };
        let all = chart.cells.len();
        let text = format!(
            "Over speed and {}, of {{}} cells {} only balance, {} may balance or not, {} only do not, {} have no stable state.",
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
fn capacity(told: &Told) -> Option<Finding> {
    let seen = told.points.iter().filter_map(|p| p.seen.unbalance);
    let needed = seen.clone().map(|u| u.without()).reduce(larger).filter(|x| x.is_finite())?;
    let most = seen.map(|u| u.capacity).reduce(larger).filter(|most| *most < (1.0 - NOTHING) * needed)?;
    let text = format!("The masses can cancel {{}} at most, less than the unbalance of {}.", quantity(needed, "kg m"));
    Some(Finding::warning("insufficient_capacity", text).value(most, "kg m").evidence("needed", needed, "kg m"))
}

fn completeness(found: &Found, loose: usize) -> Vec<Finding> {
    let [starts, led, known] = found.starts.map(|n| n as f64);
    let share = if led > 0.0 { (known + loose as f64) / led } else { 0.0 };
    let text =
        format!("{} branches of states were found; {{}} of the starts that led to a state led to one known before.", found.paths.len());
    let told = Finding::info("completeness", text)
        .value(share, "")
        .evidence("starts", starts, "")
        .evidence("starts that led to a state", led, "")
        .evidence("starts that led to states that are not isolated", loose as f64, "");
    let crowded = Finding::warning("too_many_branches", "There are more branches of states than are followed: the list is not complete.");
    if found.crowded { vec![told, crowded] } else { vec![told] }
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
