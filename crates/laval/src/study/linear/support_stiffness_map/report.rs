//! Tables, figure and findings of a map over the stiffness of the supports.

use super::{Bearing, Intersection, MapResult, Row, SupportStiffnessMap, Turned, others};
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use crate::outcome::{Arg, Axis, Figure, Finding, Line, Message, Outcome, Panel, Points, Rule, Table};
use crate::solve::support_map::{Root, Spin};
use crate::study::Study;
use crate::study::linear::operating::operating;
use crate::study::shared::support::{RPM, inconsistent, largest};

pub(super) struct Shown<'a> {
    pub study: &'a SupportStiffnessMap,
    /// At the spin that speeds are those of.
    pub system: &'a System,
    pub turned: &'a Turned,
    pub result: &'a MapResult,
}

/// Energy share from which on the supports decide, and below which the rotor does.
const DECIDES: f64 = 0.5;
const HARDLY: f64 = 0.1;

impl Shown<'_> {
    pub(super) fn outcome(&self, name: &str) -> Result<Outcome, Diagnostic> {
        let mut outcome =
            Outcome::new(SupportStiffnessMap::KIND, name).end(self.result.end).work("eigenproblems", self.result.curves.len() as u64);
        outcome = self.findings().into_iter().fold(outcome, Outcome::finding);
        outcome = outcome.table(self.intersections()?).table(self.limits()?).table(self.map()?);
        let bearings = self.bearings()?;
        if bearings.rows() > 0 {
            outcome = outcome.table(bearings);
        }
        outcome = outcome.figure(self.figure());
        outcome.checked().map_err(inconsistent)
    }

    fn name(&self, slot: usize) -> String {
        self.system.slots()[slot].name.clone()
    }

    /// Parts and directions of a bearing.
    fn label(&self, b: &Bearing) -> (String, Arg) {
        let names: Vec<String> = {
            let mut out: Vec<String> = b.of.iter().map(|(s, _)| self.name(*s)).collect();
            out.dedup();
            out
        };
        let axes = match (b.of.iter().any(|x| x.1 == 0), b.of.iter().any(|x| x.1 == 1)) {
            (true, true) => "both",
            (true, false) => "x",
            _ => "y",
        };
        let read = Message::new("support-map-bearing").arg("parts", Arg::names(names.clone())).arg("axes", Arg::word(axes));
        let suffix = match axes {
            "both" => "",
            "x" => " kxx",
            _ => " kyy",
        };
        (names.join(", ") + suffix, read.into())
    }

    fn roots(&self) -> impl Iterator<Item = (&Row, usize, &Root)> {
        self.result.curves.iter().flat_map(|row| row.roots.iter().enumerate().map(move |(k, r)| (row, k, r)))
    }

    fn map(&self) -> Result<Table, Diagnostic> {
        let rows: Vec<_> = self.roots().collect();
        let column = |f: &dyn Fn(&Row, &Root) -> f64| rows.iter().map(|(row, _, r)| f(row, r)).collect::<Vec<f64>>();
        Table::new("map", "Critical speeds over the stiffness of every support")
            .float("stiffness", "N/m", "stiffness of every support, in x and y", column(&|row, _| row.stiffness))
            .int("mode", "", "number of the curve, from the lowest", rows.iter().map(|x| x.1 as i64 + 1).collect())
            .float("speed", "rad/s", "critical speed; of the rotor at rest its natural frequency", column(&|_, r| r.speed))
            .float("speed_rpm", "rpm", "the same", column(&|_, r| r.speed * RPM))
            .float("support_energy", "", "share of the strain energy in the supports", column(&|_, r| r.share))
            .float("forward_share", "", "share of the forward part in the squared amplitudes", column(&|_, r| r.forward))
            .text("rotor", "turning with the whirl, or at rest", rows.iter().map(|x| word(x.0.spin).into()).collect())
            .text("curve", "curve of the figure", rows.iter().map(|x| curve(x.0.spin, x.1)).collect())
            .flag("forward", "forward whirl", rows.iter().map(|x| x.0.spin == Spin::Rest || x.2.forward >= 0.5).collect())
            .build()
            .map_err(inconsistent)
    }

    fn limits(&self) -> Result<Table, Diagnostic> {
        let all: Vec<(&Root, bool)> =
            self.result.free.iter().map(|r| (r, false)).chain(self.result.rigid.iter().map(|r| (r, true))).collect();
        Table::new("limits", "Critical speeds without supports and on rigid ones")
            .flag("rigid", "on rigid supports; otherwise without any", all.iter().map(|x| x.1).collect())
            .float("speed", "rad/s", "critical speed", all.iter().map(|x| x.0.speed).collect())
            .float("speed_rpm", "rpm", "critical speed", all.iter().map(|x| x.0.speed * RPM).collect())
            .float("forward_share", "", "share of the forward part in the squared amplitudes", all.iter().map(|x| x.0.forward).collect())
            .build()
            .map_err(inconsistent)
    }

    fn intersections(&self) -> Result<Table, Diagnostic> {
        let all = &self.result.intersections;
        let column = |f: fn(&Intersection) -> f64| all.iter().map(f).collect::<Vec<f64>>();
        Table::new("intersections", "Critical speeds with all supports as stiff as a bearing of the machine")
            .leading()
            .phrases("bearing", "bearing, and direction", all.iter().map(|i| self.label(&self.result.bearings[i.bearing])).collect())
            .int("mode", "", "number of the curve", all.iter().map(|i| i.curve as i64 + 1).collect())
            .float("stiffness", "N/m", "stiffness", column(|i| i.stiffness))
            .float("speed", "rad/s", "critical speed", column(|i| i.root.speed))
            .float("speed_rpm", "rpm", "critical speed", column(|i| i.root.speed * RPM))
            .float("support_energy", "", "share of the strain energy in the supports", column(|i| i.root.share))
            .float("forward_share", "", "share of the forward part in the squared amplitudes", column(|i| i.root.forward))
            .build()
            .map_err(inconsistent)
    }

    fn bearings(&self) -> Result<Table, Diagnostic> {
        let (low, high) = self.speeds();
        let mut rows: Vec<(usize, f64, f64)> = Vec::new();
        for (k, b) in self.result.bearings.iter().enumerate() {
            if b.constant {
                rows.extend([low, high].map(|w| (k, w, b.points[0].1)));
            } else {
                rows.extend(b.points.iter().filter(|p| p.1 > 0.0 && p.0 <= high).map(|p| (k, p.0, p.1)));
            }
        }
        Table::new("bearings", "Stiffness of the bearings of the machine over the speed")
            .phrases("bearing", "bearing, and direction", rows.iter().map(|r| self.label(&self.result.bearings[r.0])).collect())
            .float("speed", "rad/s", "spin speed", rows.iter().map(|r| r.1).collect())
            .float("stiffness", "N/m", "stiffness", rows.iter().map(|r| r.2).collect())
            .build()
            .map_err(inconsistent)
    }

    /// Lowest and highest speed of the figure.
    fn speeds(&self) -> (f64, f64) {
        let all = || self.roots().map(|x| x.2.speed).chain(self.result.rigid.iter().map(|r| r.speed));
        (all().fold(f64::INFINITY, f64::min), all().fold(0.0, f64::max))
    }

    fn figure(&self) -> Figure {
        let mut panel = Panel::new(Axis::log("critical speed", "rad/s")).height(1.8);
        let mut names: Vec<(String, Arg)> = Vec::new();
        for spin in [Spin::Synchronous, Spin::Rest] {
            for k in 0..self.study.modes {
                let sentence = if spin == Spin::Rest { "support-map-at-rest" } else { "support-map-curve" };
                names.push((curve(spin, k), Message::new(sentence).arg("mode", Arg::count(k + 1)).into()));
            }
        }
        let line = Line::new("map", "stiffness", "speed").group("curve").called(names);
        panel = panel.mark(if self.result.forward_alone {
            line
        } else {
            line.solid_where("forward").meaning("forward whirl", "backward whirl")
        });
        if !self.result.bearings.is_empty() {
            panel = panel.mark(
                Line::new("bearings", "stiffness", "speed")
                    .group("bearing")
                    .called(self.result.bearings.iter().map(|b| self.label(b)).collect()),
            );
        }
        if !self.result.intersections.is_empty() {
            panel = panel.mark(Points::new("intersections", "stiffness", "speed").name("as stiff as the bearing"));
        }
        // limits that the curves reach
        let top = self.roots().map(|x| x.2.speed).fold(0.0, f64::max);
        for (label, roots) in [("no supports", &self.result.free), ("rigid supports", &self.result.rigid)] {
            for r in roots.iter().filter(|r| r.speed <= 1.02 * top && r.forward >= 0.5) {
                panel = panel.mark(Rule::y(r.speed, label));
            }
        }
        let (low, high) = self.speeds();
        let sense = self.turned.sense;
        if let Some(w) = operating(self.system, sense * low, sense * high) {
            panel = panel.mark(Rule::y(w.speed().abs(), "operating speed"));
        }
        let alt = Message::new("support-map-alt")
            .arg("curves", Arg::count(self.study.modes))
            .arg("points", Arg::count(self.result.intersections.len()));
        Figure::new("map", "Critical speeds over the stiffness of the supports", alt)
            .x(Axis::log("stiffness of every support", "N/m"))
            .panel(panel)
    }

    /// Which spin speeds are those of, in a machine of several or one that turns with none of its bodies.
    fn spin(&self) -> Option<Finding> {
        let others = others(self.system);
        if let Some(spin) = &self.turned.spin {
            let finding = Finding::info("spin", "support-map-spin").arg("spin", Arg::name(spin.name.as_deref().unwrap_or_default()));
            return Some(finding.arg("ratio", Arg::number(spin.ratio)).arg("others", Arg::count(others.len())));
        }
        let names: Vec<String> = others.iter().filter_map(|s| s.name.as_ref()).map(|name| format!("\"{name}\"")).collect();
        (!names.is_empty()).then(|| Finding::info("spin", "support-map-machine-spin").arg("spins", Arg::term(names.join(", "))))
    }

    fn findings(&self) -> Vec<Finding> {
        let r = self.result;
        let mut out: Vec<Finding> = self.spin().into_iter().collect();
        let lowest = |roots: &[Root]| roots.iter().find(|r| r.forward >= 0.5).cloned();
        // the bearings of the machine first: the map is drawn for them
        for i in r.intersections.iter().filter(|i| i.root.forward >= 0.5) {
            let (subject, bearing) = self.label(&r.bearings[i.bearing]);
            let weight = if i.root.share >= DECIDES {
                "supports"
            } else if i.root.share <= HARDLY {
                "rotor"
            } else {
                "both"
            };
            let finding = Finding::info("intersection", "support-map-intersection")
                .of(format!("{subject}, mode {}", i.curve + 1))
                .value(i.root.speed, "rad/s")
                .arg("mode", Arg::count(i.curve + 1))
                .arg("bearing", bearing)
                .arg("stiffness", Arg::quantity(i.stiffness, "N/m"))
                .arg("share", Arg::percent(i.root.share))
                .arg("moves", Arg::word(weight));
            out.push(finding.evidence("last change of the speed, over it", i.root.change, "").evidence(
                "distance of the critical speed from the speed of the stiffness, over it",
                i.defect,
                "",
            ));
        }
        if let Some(rigid) = lowest(&r.rigid) {
            let finding = Finding::info("rigid_limit", "support-map-rigid").value(rigid.speed, "rad/s");
            out.push(finding.evidence("last change of the speed, over it", rigid.change, ""));
        }
        if let Some(free) = lowest(&r.free) {
            let finding = Finding::info("free_limit", "support-map-free").value(free.speed, "rad/s");
            out.push(finding.evidence("last change of the speed, over it", free.change, ""));
        }
        let most = r.curves.iter().map(|row| row.roots.len()).max().unwrap_or(0);
        if most < self.study.modes && r.end.is_complete() {
            out.push(Finding::info("fewer", "support-map-fewer").arg("modes", Arg::count(most)));
        }
        let uncounted = self.roots().filter(|x| !x.2.counted).count();
        let finding = if uncounted == 0 {
            Finding::info("counted", "support-map-counted").arg("roots", Arg::count(self.roots().count()))
        } else {
            Finding::info("together", "support-map-together").arg("roots", Arg::count(uncounted))
        };
        out.push(finding.evidence("largest last change of a speed, over it", largest(self.roots().map(|x| x.2.change)), ""));
        let without = |linear: bool| -> Vec<String> {
            let drawn = |s: usize| r.bearings.iter().any(|b| b.of.iter().any(|x| x.0 == s));
            let of = r.supports.iter().filter(|&&s| self.system.slots()[s].is_linear() == linear && !drawn(s));
            of.map(|&s| self.name(s)).collect()
        };
        let (nonlinear, soft) = (without(false), without(true));
        out.push(
            Finding::info("replaced", "support-map-replaced")
                .arg("parts", Arg::names(r.supports.iter().map(|&s| self.name(s))))
                .arg("nonlinears", Arg::count(nonlinear.len()))
                .arg("nonlinear", Arg::names(nonlinear))
                .arg("softs", Arg::count(soft.len()))
                .arg("soft", Arg::names(soft)),
        );
        if !r.forward_alone {
            out.push(Finding::info("directions", "support-map-directions"));
        }
        out
    }
}

fn word(spin: Spin) -> &'static str {
    if spin == Spin::Rest { "at rest" } else { "turning" }
}

/// Name of a curve.
fn curve(spin: Spin, k: usize) -> String {
    format!("{} {}", word(spin), k + 1)
}
