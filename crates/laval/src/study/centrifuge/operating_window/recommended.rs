//! The recommended speed, the shortest time, and what a reader should know of both.

use super::margins::{NAMES, Point, VALID};
use super::report::{Shown, rpm, words};
use super::{Counted, Objective, Policy};
use crate::outcome::{Finding, Outcome, SpecialPoint, Status, quantity, significant};
use crate::separation::measures::rcf;
use crate::separation::validity::{FIELD, gravity_felt};
use crate::study::centrifuge::cups::uncarried;
use crate::study::motion::drive::without_inertia;
use crate::study::shared::support::RPM;

impl Shown<'_> {
    pub fn recommended(&self, mut out: Outcome) -> Outcome {
        let (s, m) = (self.study, &self.found.main);
        let Some(best) = &m.best else { return out };
        let why = match s.objective {
            Objective::Margin => match (same(&m.points, best), best.binding(), best.next()) {
                (Some((low, high)), Some(least), Some(next)) => format!(
                    "the next margin ({}) decides, because the least one ({}) is the same from {} to {}",
                    NAMES[next],
                    NAMES[least.name],
                    rpm(low),
                    rpm(high)
                ),
                _ => "the least margin is largest".into(),
            },
            Objective::Time if self.flow().is_some() => "the throughput could be largest".into(),
            Objective::Time => "the separation is shortest".into(),
            Objective::Energy => "the energy is least".into(),
            Objective::Amplitude => "the vibration is smallest".into(),
        };
        let mut text = format!("Recommended: {{}}, where {why}");
        if best.needed.is_finite() {
            text += &match self.flow() {
                Some((_, volume)) => format!("; the throughput may then be up to {}", litres(volume / best.needed)),
                None => format!("; the separation then takes {}", in_words(best.needed)),
            };
        }
        let mut f = Finding::info("best_speed", text + ".").value(best.speed, "rad/s").shown_as(best.speed * RPM, "rpm");
        for margin in &best.margins {
            f = f.evidence(format!("margin of {}", NAMES[margin.name]), margin.value, "");
        }
        f = f.evidence("largest growth rate", best.growth, "1/s");
        out = out.finding(f.evidence("tilt", best.tilt, "rad").evidence("unbalance of the cups", best.unbalance, "kg m"));
        out = self.outside(out, best);
        if let Some(b) = best.binding() {
            let text = format!("There the requirement \"{}\" is nearest to its limit ({}): margin {{}}.", NAMES[b.name], b.detail);
            out = out.finding(Finding::info("binding", text).value(b.value, "").shown_as(100.0 * b.value, "%"));
        }
        // why not faster: the requirement at the end of the interval above
        if let Some(i) = m.intervals.iter().find(|i| i.low.speed <= best.speed && best.speed <= i.high.speed)
            && i.high.event != "domain limit"
        {
            let text = format!("Why not faster: at {{}} the window ends, by {}.", words(&i.high.binding, self.flow().is_some()));
            out = out.finding(Finding::info("not_faster", text).value(i.high.speed, "rad/s").shown_as(i.high.speed * RPM, "rpm"));
        }
        if let Some(task) = &self.task {
            let (r1, r2) = task.vessel.separator.at(best.speed).radii();
            let g = task.suspension.medium.gravity;
            let text = format!("The field there grows from {} g to {{}} g.", significant(rcf(best.speed, r1, g), 4));
            out = out.finding(Finding::info("rcf", text).value(rcf(best.speed, r2, g), ""));
        }
        out
    }

    /// A recommended speed that the robust window does not contain.
    fn outside(&self, out: Outcome, best: &Point) -> Outcome {
        let Some(r) = self.found.robust.as_ref().filter(|r| !r.intervals.is_empty()) else { return out };
        if within(&r.intervals, best.speed) {
            return out;
        }
        let all: Vec<String> = r.intervals.iter().map(|(a, b)| format!("{} to {}", rpm(*a), rpm(*b))).collect();
        let text = format!("The recommended speed, {{}}, lies outside the robust window, {}.", all.join(" and "));
        out.finding(Finding::warning("outside_robust", text).value(best.speed, "rad/s").shown_as(best.speed * RPM, "rpm"))
    }

    /// Time needed at a speed of the scan with the run-up, where everything but the separation is kept.
    pub fn shortest(&self, out: Outcome) -> Outcome {
        let m = &self.found.main;
        let Some(task) = &self.task else { return out };
        let kept = m.points.iter().filter(|p| p.feasible_without(0) && p.needed.is_finite());
        match kept.min_by(|a, b| a.needed.total_cmp(&b.needed)) {
            Some(p) => {
                let text = match self.flow() {
                    Some((_, volume)) => {
                        let most = litres(volume / p.needed);
                        format!("The shortest residence time the machine allows is {{}}, a throughput of {most}, at {}.", rpm(p.speed))
                    }
                    None => format!("The shortest time the machine allows is {{}}, at {}.", rpm(p.speed)),
                };
                out.finding(
                    Finding::info("shortest_time", text)
                        .value(p.needed, "s")
                        .evidence(if self.flow().is_some() { "residence time" } else { "time at hand" }, task.time, "s")
                        .evidence("speed", p.speed, "rad/s"),
                )
            }
            None => out,
        }
    }

    /// Bodies whose tilt no limit sees.
    fn leaning(&self, mut out: Outcome) -> Outcome {
        let m = &self.found.main;
        for body in &m.unseen {
            let inside = m.points.iter().filter(|p| p.feasible()).filter_map(|p| Some((*p.leans.get(body.index)?, p.speed)));
            let Some((tilt, speed)) = inside.max_by(|a, b| a.0.total_cmp(&b.0)).filter(|x| x.0 > 0.0) else { continue };
            let text = format!(
                "\"{}\" tilts by up to {{}} inside the windows, at {}, and no limit applies to its tilt: its displacement counts at the reference point alone. Add tilt to \
                 [limits].",
                body.name,
                rpm(speed)
            );
            out = out
                .finding(Finding::warning("tilt_without_limit", text).of(&body.name).value(tilt, "rad").evidence("speed", speed, "rad/s"));
        }
        out
    }

    pub fn remarks(&self, mut out: Outcome) -> Outcome {
        let m = &self.found.main;
        out = uncarried(self.system, None).into_iter().fold(out, Outcome::finding);
        out = self.doubts(out);
        out = self.leaning(out);
        let required = |name: usize| m.points.iter().any(|p| p.margin(name).is_some());
        let absent: Vec<&str> = (0..NAMES.len()).filter(|&n| n != VALID && !required(n)).map(|n| NAMES[n]).collect();
        if !absent.is_empty() {
            let text = format!("Not checked, because nothing in the file requires it: {}.", absent.join(", "));
            out = out.finding(Finding::info("not_checked", text));
        }
        if !required(0) && !required(1) && !required(5) && !required(6) {
            out = out.finding(Finding::warning(
                "few_requirements",
                "Only stability bounds this window: give [limits], and [[cup]] with [suspension], to make it one to run by.",
            ));
        }
        if let Some(h) = m.harmonics {
            let assessed = match self.policy {
                Policy::All => "a speed where any stable one breaks a limit is outside",
                Policy::Reached => {
                    "of several stable ones that is assessed which the run-up of this file leads to; the window holds for this run-up only"
                }
                Policy::Highest => "of several stable ones that with the largest vibration is assessed",
            };
            let text = format!("Steady states of the nonlinear machine are those of all its branches; {assessed}.");
            out = out.finding(Finding::info("nonlinear", text).evidence("orders kept", h as f64, ""));
        }
        for w in &m.folds {
            out = out.special_point(SpecialPoint::new("fold", *w, (*w, *w)).status(Status::Bracketed));
        }
        if let Some(p) = &m.passage {
            let top = self.study.speed.to;
            for peak in p.peaks(top) {
                let way = if peak.up { "up" } else { "down" };
                let range = if peak.up { "to" } else { "from" };
                let text = format!(
                    "On the way {way} {range} {}, the highest speed of the range, \"{}\" moves by up to {{}}, at {}.",
                    rpm(top),
                    peak.body,
                    rpm(peak.speed)
                );
                let f = Finding::info("passage_peak", text).value(peak.displacement, "m").evidence("speed", peak.speed, "rad/s");
                out = out.finding(f.of(peak.body));
            }
            out = out.finding(Finding::info("passage_torque", "The run-up takes a torque of up to {}.").value(p.torque(top), "N m"));
            out = without_inertia(self.system, "The torque of the run-up is").into_iter().fold(out, Outcome::finding);
        }
        if let (Some(t), Some(task), Some(best)) = (self.ramp, &self.task, &m.best) {
            let (_, r2) = task.vessel.separator.at(best.speed).radii();
            let share = self.study.speed.to / t * r2 / (best.speed * best.speed * r2);
            let text = "Braking as fast as the run-up, the pellet is pulled sideways with {} of the field that holds it.";
            out = out.finding(Finding::info("braking", text).value(share, "").shown_as(100.0 * share, "%"));
        }
        out
    }

    /// Where the model of the separation is doubtful.
    fn doubts(&self, mut out: Outcome) -> Outcome {
        let m = &self.found.main;
        let Some(task) = &self.task else { return out };
        let (separator, g) = (&task.vessel.separator, task.suspension.medium.gravity);
        let lowest = m.intervals.first().map(|i| i.low.speed);
        if let Some((w, field)) = lowest.and_then(|w| Some((w, gravity_felt(separator, w, g)?))) {
            let text = format!(
                "At the lower end of the window, {}, the field is {{}} g at the innermost liquid; the model of a machine that liquid flows through leaves gravity out, which \
                 holds from {} g on.",
                rpm(w),
                significant(FIELD, 2)
            );
            out = out.finding(Finding::warning("gravity", text).value(field, "").evidence("least field over gravity", FIELD, ""));
        }
        if let Some(Counted { counted, duration, equivalent }) = m.counted {
            let text = "The liquid of fixed-angle tubes shifts while the speed changes: the run-up counts by an estimate, the field at mean radius, as {} at full speed.";
            out = out.finding(
                Finding::info("run_up_estimate", text).value(counted, "s").evidence("duration of the run-up", duration, "s").evidence(
                    "by the square of the speed alone",
                    equivalent,
                    "s",
                ),
            );
        }
        out
    }
}

/// Relative difference of least margins that are the same.
const SAME: f64 = 1e-9;

/// The lowest and the highest speed around the recommended one that have its least margin; `None` where it has a largest one.
fn same(points: &[Point], best: &Point) -> Option<(f64, f64)> {
    let binding = best.binding()?;
    let alike = |p: &&Point| {
        p.feasible() && p.binding().is_some_and(|m| m.name == binding.name) && (p.least() - best.least()).abs() <= SAME * best.least().abs()
    };
    let below = points.iter().rev().filter(|p| p.speed < best.speed).take_while(alike).last();
    let above = points.iter().filter(|p| p.speed > best.speed).take_while(alike).last();
    let (low, high) = (below.map_or(best.speed, |p| p.speed), above.map_or(best.speed, |p| p.speed));
    // what the search for the best adds beside it is no range
    (high - low > 1e-5 * best.speed.abs()).then_some((low, high))
}

fn within(intervals: &[(f64, f64)], speed: f64) -> bool {
    intervals.iter().any(|(a, b)| *a <= speed && speed <= *b)
}

/// A throughput for people.
fn litres(q: f64) -> String {
    format!("{} l/h", significant(q * 3.6e6, 4))
}

/// A time for people: minutes beyond ten of them.
fn in_words(t: f64) -> String {
    if t >= 600.0 { format!("{} min", significant(t / 60.0, 4)) } else { quantity(t, "s") }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::centrifuge::operating_window::margins::Margin;

    fn point(speed: f64, values: &[f64]) -> Point {
        let margins = values.iter().enumerate().map(|(name, &value)| Margin { name, value, detail: String::new() }).collect();
        Point { speed, margins, needed: 0.0, tilt: 0.0, unbalance: 0.0, states: 1, energy: 0.0, growth: 0.0, leans: vec![] }
    }

    /// The least margin is the same from 2 to 4: there the next one decides.
    #[test]
    fn a_least_margin_that_is_the_same_over_a_range() {
        let points =
            [(1.0, 0.1, 0.5), (2.0, 0.4, 0.2), (3.0, 0.6, 0.2), (4.0, 0.5, 0.2), (5.0, 0.1, 0.2)].map(|(w, a, b)| point(w, &[a, b]));
        assert_eq!(same(&points, &points[2]), Some((2.0, 4.0)));
        assert_eq!((points[2].binding().map(|m| m.name), points[2].next()), (Some(1), Some(0)));
        let peak = [0.1, 0.3, 0.2].map(|a| point(10.0 * a, &[a, 0.9]));
        assert_eq!(same(&peak, &peak[1]), None);
    }

    #[test]
    fn speeds_within_a_robust_window() {
        assert!(within(&[(1.0, 2.0), (3.0, 4.0)], 3.5) && !within(&[(1.0, 2.0), (3.0, 4.0)], 2.5));
    }
}
