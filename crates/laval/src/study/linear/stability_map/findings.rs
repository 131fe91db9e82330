//! What a stability map says.

use super::report::{Cell, Shown};
use crate::model::part::{Domain, Words};
use crate::outcome::{Finding, quantity};
use crate::solve::stability::Edge;
use crate::study::linear::criterion::Criterion;
use crate::study::shared::region;
use crate::study::shared::support::beyond_rounding;

impl Shown<'_> {
    pub fn findings(&self) -> Vec<Finding> {
        let mut out: Vec<Finding> = self.strongest().into_iter().collect();
        if !self.two() && !self.study.speed.is_one() {
            out.extend(self.ranges());
        }
        // of other machines what grows is unstable and nothing is to be explained
        if self.endless || self.study.criterion != Criterion::Growth {
            out.push(self.study.criterion.finding(self.system, self.study.speed.to, self.threshold));
        }
        if self.endless {
            out.extend(self.counts());
        }
        out.extend(self.undamped());
        out
    }

    fn limit(&self) -> String {
        quantity(self.threshold, "1/s")
    }

    fn unstable(&self) -> bool {
        self.rows().iter().any(|r| r.samples.iter().any(|s| r.unstable(s, self.threshold)))
    }

    /// Points where the count does not agree with the roots found.
    fn open(&self) -> usize {
        self.cells.iter().filter(|c| self.endless && c.sample.growing.is_none() && !c.crossing).count()
    }

    /// Points of the map that are none of its boundary.
    fn points(&self) -> usize {
        self.cells.iter().filter(|c| !c.crossing).count()
    }

    /// The largest growth, or that there is none.
    fn strongest(&self) -> Option<Finding> {
        let of = |c: &Cell| (c.row, c.sample.speed, c.sample.value);
        let highest = self.peaks.iter().map(|&(k, p)| (k, p.speed, p.value)).chain(self.cells.iter().map(of));
        let (k, speed, s) = highest.max_by(|a, b| a.2.re.total_cmp(&b.2.re))?;
        let limit = self.limit();
        let computed = if self.complete() { "" } else { " before the study stopped" };
        let finding = if self.unstable() {
            let with = if self.two() { format!(" at {} = {}", self.name, quantity(self.value(k), self.unit)) } else { String::new() };
            let text = format!(
                "{} strongest instability grows at {{}}, at {}{with}, {}.",
                if self.two() { "Of the machines computed the" } else { "The" },
                quantity(speed, "rad/s"),
                if s.im == 0.0 { "without oscillation".into() } else { format!("whirling at {}", quantity(s.im, "rad/s")) }
            );
            Finding::warning("largest_growth", text).value(s.re, "1/s")
        } else if self.endless {
            match self.open() {
                0 => Finding::info("stable", format!("No mode grows faster than {limit} at any point computed{computed}.")),
                open => {
                    let points = self.points();
                    let text =
                        format!("No mode was found that grows faster than {limit}, but at {open} of {points} points some may be missing.");
                    Finding::warning("stability_unknown", text)
                }
            }
        } else {
            let sizes = self.rows().iter().flat_map(|r| &r.samples).map(|s| s.size).fold(0.0, f64::max);
            let growth = beyond_rounding(s.re, sizes);
            let largest = if growth == 0.0 { "zero to rounding" } else { "{}" };
            let text = format!("No mode grows faster than {limit} at any point computed{computed}; the largest growth rate is {largest}.");
            Finding::info("stable", text).value(growth, "1/s")
        };
        Some(finding.evidence("speed", speed, "rad/s"))
    }

    /// Along one line: the ranges of speed where it is unstable.
    fn ranges(&self) -> Vec<Finding> {
        let mut out = Vec::new();
        let (limit, edges) = (self.limit(), &self.edges);
        let samples = self.rows().first().map_or(&[][..], |r| &r.samples);
        let (first, last) = (self.study.speed.from, samples.last().map_or(self.study.speed.from, |s| s.speed));
        let (whole, range_end) = if self.complete() {
            ("", "the end of the range".to_string())
        } else {
            (", where the study stopped", format!("{}, where the study stopped", quantity(last, "rad/s")))
        };
        // an unstable start has no onset inside the range
        let start = match edges.first() {
            Some(e) if !e.1.onset => Some(quantity(e.1.speed, "rad/s")),
            None if self.unstable() => Some(quantity(last, "rad/s") + whole),
            _ => None,
        };
        if let Some(until) = start {
            let text = format!("Growth exceeds {limit} from the start of the range, {{}}, to {until}.");
            let to = edges.first().map_or(last, |e| e.1.speed);
            out.push(Finding::warning("unstable_range", text).value(first, "rad/s").evidence("to", to, "rad/s"));
        }
        for (w, e) in edges.iter().enumerate().filter(|(_, e)| e.1.onset) {
            let until = edges.get(w + 1).map_or_else(|| format!(" to {range_end}"), |n| format!(" to {}", quantity(n.1.speed, "rad/s")));
            let to = edges.get(w + 1).map_or(last, |n| n.1.speed);
            let finding = onset(e.1, &until, &limit).evidence("uncertainty of the onset", e.1.step, "rad/s");
            out.push(finding.evidence("to", to, "rad/s"));
        }
        out
    }

    /// Of a machine with roots without number: what was counted.
    fn counts(&self) -> Vec<Finding> {
        let mut out = Vec::new();
        let (limit, open, points) = (self.limit(), self.open(), self.points());
        let evaluations: u64 = self.rows().iter().map(|r| r.evaluations).sum();
        let finding = if open == 0 {
            let text =
                format!("At all {points} points the argument principle counts as many roots that grow faster than {limit} as were found.");
            Finding::info("all_counted", text)
        } else {
            let text = format!("At {{}} of {points} points it could not be proven that no root that grows faster than {limit} is missing.");
            Finding::warning("not_all_counted", text).value(open as f64, "")
        };
        out.push(finding.evidence("evaluations of the characteristic function", evaluations as f64, ""));
        if self.threshold > self.study.threshold {
            let words = self.system.domains(self.study.speed.to).into_iter().find(Domain::undamped).map_or(Words::PLAIN, |d| d.words);
            let text = format!(
                "Waves of {} grow slowly with any damping outside it: growth counts from {{}} on instead of {}, because slower waves are not all computed.",
                words.name,
                quantity(self.study.threshold, "1/s")
            );
            out.push(Finding::warning("threshold_raised", text).value(self.threshold, "1/s"));
        }
        let from = self.study.speed.from;
        out.extend(region::limits(&self.system.domains(from), from));
        out
    }

    /// That nothing damps the machine, and what its boundaries are then.
    fn undamped(&self) -> Option<Finding> {
        let rows = self.rows();
        rows.iter().any(|r| r.undamped).then(|| {
            let machine = if rows.iter().all(|r| r.undamped) { "The machine has no damping" } else { "Where the machine has no damping" };
            let own = || rows.iter().filter(|r| r.undamped).flat_map(|r| &r.edges);
            let (double, all) = (own().filter(|e| e.double).count(), own().count());
            let how = match (double, all) {
                (_, 0) => ": where no mode grows, none decays either".to_string(),
                (d, a) if d == a => ": its stability boundaries are double roots and were solved for as such".into(),
                (d, a) => format!(": its stability boundaries are double roots; {d} of {a} were solved for as such, the others bracketed"),
            };
            Finding::info("undamped", format!("{machine}{how}."))
        })
    }
}

/// From where on the machine is unstable, and `until` where.
fn onset(e: &Edge, until: &str, limit: &str) -> Finding {
    if e.located {
        let text = format!("Unstable from {{}}{until}: growth above {limit}.");
        return Finding::warning("unstable_range", text).value(e.speed, "rad/s");
    }
    let (a, b) = e.bracket;
    let text = format!(
        "Unstable from between {} and {}, where the boundary could not be located,{until}: growth above {limit}.",
        quantity(a, "rad/s"),
        quantity(b, "rad/s")
    );
    Finding::warning("unstable_range", text)
}
