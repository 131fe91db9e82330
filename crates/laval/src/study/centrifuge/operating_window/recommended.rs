//! The recommended speed, the shortest time, and what a reader should know of both.

use super::margins::{NAMES, Point, VALID};
use super::report::{Shown, requirement};
use super::{Counted, Objective, Policy};
use crate::outcome::{Arg, Finding, Message, Outcome, SpecialPoint, Status};
use crate::separation::measures::rcf;
use crate::separation::validity::{FIELD, gravity_felt};
use crate::study::centrifuge::cups::uncarried;
use crate::study::motion::drive::spin_inertia;

impl Shown<'_> {
    pub fn recommended(&self, mut out: Outcome) -> Outcome {
        let (s, m) = (self.study, &self.found.main);
        let Some(best) = &m.best else { return out };
        let mut f = Finding::info("best_speed", "operating-window-best-speed").value(best.speed, "rad/s");
        let why = match s.objective {
            Objective::Margin => match (same(&m.points, best), best.binding(), best.next()) {
                (Some((low, high)), Some(least), Some(next)) => {
                    let of = |name: usize| requirement(NAMES[name], self.flow().is_some());
                    f = f.arg("least", of(least.name)).arg("next", of(next)).arg("from", Arg::speed(low)).arg("to", Arg::speed(high));
                    "next_margin"
                }
                _ => "margin",
            },
            Objective::Time if self.flow().is_some() => "throughput",
            Objective::Time => "time",
            Objective::Energy => "energy",
            Objective::Amplitude => "amplitude",
        };
        f = f.arg("why", Arg::word(why));
        f = match self.flow() {
            _ if !best.needed.is_finite() => f.arg("duty", Arg::word("none")),
            Some((_, volume)) => f.arg("duty", Arg::word("throughput")).arg("throughput", Arg::quantity(volume / best.needed, "m^3/s")),
            None => f.arg("duty", Arg::word("time")).arg("time", Arg::quantity(best.needed, "s")),
        };
        for margin in &best.margins {
            f = f.evidence(Arg::of("margin", NAMES[margin.name]), margin.value, "");
        }
        f = f.evidence("largest growth rate", best.growth, "1/s");
        out = out.finding(f.evidence("tilt", best.tilt, "rad").evidence("unbalance of the cups", best.unbalance, "kg m"));
        out = self.outside(out, best);
        if let Some(b) = best.binding() {
            let finding = match b.detail.phrase() {
                Some(detail) => Finding::info("binding", "operating-window-binding-detail").arg("detail", detail),
                None => Finding::info("binding", "operating-window-binding"),
            };
            let of = requirement(NAMES[b.name], self.flow().is_some());
            out = out.finding(finding.value_as(Arg::percent(b.value)).arg("requirement", of));
        }
        // why not faster: the requirement at the end of the interval above
        if let Some(i) = m.intervals.iter().find(|i| i.low.speed <= best.speed && best.speed <= i.high.speed)
            && i.high.event != "domain limit"
        {
            let finding = Finding::info("not_faster", "operating-window-not-faster").value(i.high.speed, "rad/s");
            out = out.finding(finding.arg("requirement", requirement(&i.high.binding, self.flow().is_some())));
        }
        if let Some(task) = &self.task {
            let (r1, r2) = task.vessel.separator.at(best.speed).radii();
            let g = task.suspension.medium.gravity;
            let finding = Finding::info("rcf", "operating-window-field").value(rcf(best.speed, r2, g), "");
            out = out.finding(finding.arg("inner", Arg::number(rcf(best.speed, r1, g))));
        }
        out
    }

    /// A recommended speed that the robust window does not contain.
    fn outside(&self, out: Outcome, best: &Point) -> Outcome {
        let Some(r) = self.found.robust.as_ref().filter(|r| !r.intervals.is_empty()) else { return out };
        if within(&r.intervals, best.speed) {
            return out;
        }
        let range = |(from, to): &(f64, f64)| {
            Message::new("operating-window-span").arg("from", Arg::speed(*from)).arg("to", Arg::speed(*to)).into()
        };
        let finding = Finding::warning("outside_robust", "operating-window-outside-robust").value(best.speed, "rad/s");
        out.finding(finding.arg("ranges", Arg::List(r.intervals.iter().map(range).collect())))
    }

    /// Time needed at a speed of the scan with the run-up, where everything but the separation is kept.
    pub fn shortest(&self, out: Outcome) -> Outcome {
        let m = &self.found.main;
        let Some(task) = &self.task else { return out };
        let kept = m.points.iter().filter(|p| p.feasible_without(0) && p.needed.is_finite());
        match kept.min_by(|a, b| a.needed.total_cmp(&b.needed)) {
            Some(p) => {
                let finding = match self.flow() {
                    Some((_, volume)) => Finding::info("shortest_time", "operating-window-shortest-residence")
                        .value(p.needed, "s")
                        .arg("throughput", Arg::quantity(volume / p.needed, "m^3/s"))
                        .evidence("residence time", task.time, "s"),
                    None => Finding::info("shortest_time", "operating-window-shortest-time").value(p.needed, "s").evidence(
                        "time at hand",
                        task.time,
                        "s",
                    ),
                };
                out.finding(finding.arg("speed", Arg::speed(p.speed)).evidence("speed", p.speed, "rad/s"))
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
            let finding = Finding::warning("tilt_without_limit", "operating-window-tilt-without-limit").of(&body.name).value(tilt, "rad");
            let finding = finding.arg("body", Arg::name(&body.name)).arg("speed", Arg::speed(speed));
            out = out.finding(finding.evidence("speed", speed, "rad/s"));
        }
        out
    }

    pub fn remarks(&self, mut out: Outcome) -> Outcome {
        let m = &self.found.main;
        out = uncarried(self.system, None).into_iter().fold(out, Outcome::finding);
        out = self.doubts(out);
        out = self.leaning(out);
        let required = |name: usize| m.points.iter().any(|p| p.margin(name).is_some());
        let absent = (0..NAMES.len()).filter(|&n| n != VALID && !required(n));
        let absent: Vec<Arg> = absent.map(|n| requirement(NAMES[n], self.flow().is_some()).into()).collect();
        if !absent.is_empty() {
            out = out.finding(Finding::info("not_checked", "operating-window-not-checked").arg("requirements", Arg::List(absent)));
        }
        if !required(0) && !required(1) && !required(5) && !required(6) {
            out = out.finding(Finding::warning("few_requirements", "operating-window-few-requirements"));
        }
        if let Some(h) = m.harmonics {
            let policy = match self.policy {
                Policy::All => "all",
                Policy::Reached => "reached",
                Policy::Highest => "highest",
            };
            let finding = Finding::info("nonlinear", "operating-window-nonlinear").arg("policy", Arg::word(policy));
            out = out.finding(finding.evidence("orders kept", h as f64, ""));
        }
        for w in &m.folds {
            out = out.special_point(SpecialPoint::new("fold", *w, (*w, *w)).status(Status::Bracketed));
        }
        if let Some(p) = &m.passage {
            let top = self.study.speed.to;
            for peak in p.peaks(top) {
                let finding = Finding::info("passage_peak", "operating-window-passage-peak").value(peak.displacement, "m");
                let finding = finding.arg("way", Arg::word(if peak.up { "up" } else { "down" })).arg("top", Arg::speed(top));
                let finding = finding.arg("body", Arg::name(&peak.body)).arg("speed", Arg::speed(peak.speed));
                out = out.finding(finding.evidence("speed", peak.speed, "rad/s").of(peak.body));
            }
            out = out.finding(Finding::info("passage_torque", "operating-window-passage-torque").value(p.torque(top), "N m"));
            out = spin_inertia(self.system).into_iter().fold(out, Outcome::finding);
        }
        if let (Some(t), Some(task), Some(best)) = (self.ramp, &self.task, &m.best) {
            let (_, r2) = task.vessel.separator.at(best.speed).radii();
            let share = self.study.speed.to / t * r2 / (best.speed * best.speed * r2);
            out = out.finding(Finding::info("braking", "operating-window-braking").value_as(Arg::percent(share)));
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
            let finding = Finding::warning("gravity", "operating-window-gravity").value(field, "").arg("speed", Arg::speed(w));
            out = out.finding(finding.arg("least", Arg::number(FIELD)).evidence("least field over gravity", FIELD, ""));
        }
        if let Some(Counted { counted, duration, equivalent }) = m.counted {
            out = out.finding(
                Finding::info("run_up_estimate", "operating-window-run-up-estimate")
                    .value(counted, "s")
                    .evidence("duration of the run-up", duration, "s")
                    .evidence("by the square of the speed alone", equivalent, "s"),
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::centrifuge::operating_window::detail::Detail;
    use crate::study::centrifuge::operating_window::margins::Margin;

    fn point(speed: f64, values: &[f64]) -> Point {
        let margins = values.iter().enumerate().map(|(name, &value)| Margin { name, value, detail: Detail::Itself }).collect();
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
