//! Findings of a stability map.

use super::report::{Cell, Shown};
use crate::model::part::{Domain, Words};
use crate::outcome::{Arg, Finding};
use crate::solve::roots::has_more_modes;
use crate::solve::stability::Edge;
use crate::study::linear::criterion::Criterion;
use crate::study::linear::growing::limit;
use crate::study::linear::whirl::aperiodic;
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

    /// The word `computed`: whether the study reached its end.
    fn computed(&self) -> Arg {
        Arg::word(if self.complete() { "all" } else { "stopped" })
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
        let finding = if self.unstable() {
            let finding = if self.two() {
                let parameter = Arg::quantity(self.value(k), self.unit);
                Finding::warning("largest_growth", "stability-map-largest-growth-of-map")
                    .arg("parameter", Arg::name(&self.name))
                    .arg("setting", parameter)
            } else {
                Finding::warning("largest_growth", "stability-map-largest-growth")
            };
            finding
                .value(s.re, "1/s")
                .arg("speed", Arg::speed(speed))
                .arg("motion", Arg::word(if aperiodic(s) { "divergence" } else { "whirl" }))
                .arg("frequency", Arg::frequency(s.im))
        } else if self.endless {
            match self.open() {
                0 => Finding::info("stable", "stability-map-stable-counted").arg("computed", self.computed()),
                open => Finding::warning("stability_unknown", "stability-map-stability-unknown")
                    .arg("open", Arg::count(open))
                    .arg("points", Arg::count(self.points())),
            }
        } else {
            let sizes = self.rows().iter().flat_map(|r| &r.samples).map(|s| s.size).fold(0.0, f64::max);
            let growth = beyond_rounding(s.re, sizes);
            let finding = if growth == 0.0 {
                Finding::info("stable", "stability-map-marginal")
            } else {
                Finding::info("stable", "stability-map-stable")
            };
            finding.value(growth, "1/s").arg("computed", self.computed())
        };
        Some(limit(finding, self.threshold).evidence("speed", speed, "rad/s"))
    }

    /// Along one line: the ranges of speed where it is unstable.
    fn ranges(&self) -> Vec<Finding> {
        let mut out = Vec::new();
        let edges = &self.edges;
        let samples = self.rows().first().map_or(&[][..], |r| &r.samples);
        let (first, last) = (self.study.speed.from, samples.last().map_or(self.study.speed.from, |s| s.speed));
        // where a range ends: at a boundary, or where the study does
        let until = |next: Option<&(usize, &Edge)>| match next {
            Some(e) => ("boundary", e.1.speed),
            None if self.complete() => ("range", last),
            None => ("stopped", last),
        };
        let range = |finding: Finding, (end, to): (&'static str, f64)| {
            limit(finding.arg("end", Arg::word(end)).arg("to", Arg::speed(to)), self.threshold)
        };
        // an unstable start has no onset inside the range
        let start = match edges.first() {
            Some(e) if !e.1.onset => true,
            None => self.unstable(),
            _ => false,
        };
        if start {
            let end = until(edges.first());
            let finding = Finding::warning("unstable_range", "stability-map-unstable-from-start").value(first, "rad/s");
            out.push(range(finding, end).evidence("to", end.1, "rad/s"));
        }
        for (k, (_, e)) in edges.iter().enumerate().filter(|(_, e)| e.1.onset) {
            let end = until(edges.get(k + 1));
            let finding = range(onset(e), end).evidence("uncertainty of the onset", e.step, "rad/s");
            out.push(finding.evidence("to", end.1, "rad/s"));
        }
        out
    }

    /// Of a machine with roots without number: what was counted.
    fn counts(&self) -> Vec<Finding> {
        let mut out = Vec::new();
        let open = self.open();
        let evaluations: u64 = self.rows().iter().map(|r| r.evaluations).sum();
        let finding = if open == 0 {
            let frequency = self.rows().iter().filter_map(|r| r.frequency).fold(f64::INFINITY, f64::min);
            Finding::info("all_counted", "stability-map-all-counted").arg("frequency", Arg::frequency(frequency))
        } else {
            Finding::warning("not_all_counted", "stability-map-not-all-counted").value(open as f64, "").arg("open", Arg::count(open))
        };
        let finding = limit(finding.arg("points", Arg::count(self.points())), self.threshold);
        out.push(finding.evidence("evaluations of the characteristic function", evaluations as f64, ""));
        if self.threshold > self.study.threshold && !has_more_modes(self.system) {
            let words = self.system.domains(self.study.speed.to).into_iter().find(Domain::undamped).map_or(Words::PLAIN, |d| d.words);
            out.push(
                Finding::warning("threshold_raised", "stability-map-threshold-raised")
                    .value(self.threshold, "1/s")
                    .arg("part", Arg::term(words.name))
                    .arg("requested", Arg::quantity(self.study.threshold, "1/s")),
            );
        }
        let from = self.study.speed.from;
        out.extend(region::limits(&self.system.domains(from), from));
        out
    }

    /// That nothing damps the machine, and what its boundaries are then.
    fn undamped(&self) -> Option<Finding> {
        let rows = self.rows();
        rows.iter().any(|r| r.undamped).then(|| {
            let own = || rows.iter().filter(|r| r.undamped).flat_map(|r| &r.edges);
            let (double, all) = (own().filter(|e| e.double).count(), own().count());
            let boundaries = match (double, all) {
                (_, 0) => "none",
                (d, a) if d == a => "double",
                _ => "some",
            };
            Finding::info("undamped", "stability-map-undamped")
                .arg("machines", Arg::word(if rows.iter().all(|r| r.undamped) { "all" } else { "some" }))
                .arg("boundaries", Arg::word(boundaries))
                .arg("double", Arg::count(double))
                .arg("edges", Arg::count(all))
        })
    }
}

/// From where on the machine is unstable.
fn onset(e: &Edge) -> Finding {
    if e.located {
        return Finding::warning("unstable_range", "stability-map-unstable-range").value(e.speed, "rad/s");
    }
    let narrow = |w: f64| Arg::speed(w).digits(6);
    let finding = Finding::warning("unstable_range", "stability-map-unstable-range-not-located");
    finding.arg("low", narrow(e.bracket.0)).arg("high", narrow(e.bracket.1))
}
