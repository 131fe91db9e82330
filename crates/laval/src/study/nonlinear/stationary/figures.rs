//! Figures: displacement, unbalance and angles over the speed; the chart; what errors cost.

use super::chart::{Chart, WORDS as CELLS};
use super::classify::WORDS as CLASSES;
use super::errors::Errors;
use super::report::{Report, Reported, column_of};
use super::{findings, unit_of, wide};
use crate::model::system::System;
use crate::outcome::{Arg, Axis, Figure, Heat, Line, Message, Panel, Points, Rule, Scale, parameter_name};
use crate::study::shared::support::largest;

fn scale(wide: bool) -> Scale {
    if wide { Scale::Log } else { Scale::Linear }
}

/// A length is shown in mm, an angle in degrees, a mass in g.
fn axis(label: Arg, unit: &str) -> Axis {
    match unit {
        "m" => Axis::new(label, "mm").factor(1e3),
        "rad" => Axis::new(label, "°").factor(180.0 / std::f64::consts::PI),
        "kg" => Axis::new(label, "g").factor(1e3),
        _ => Axis::new(label, unit),
    }
}

/// What happens at special points of branches, as tables call it.
const CHANGES: &[&str] = &["fold", "branch_point", "hopf", "real_root"];

/// Words of a column, and how a legend calls them.
fn called(key: &'static str, words: &[&'static str]) -> Vec<(String, Arg)> {
    words.iter().map(|w| (w.replace('_', " "), Message::new(key).arg("word", Arg::word(w)).into())).collect()
}

/// Branches of which the angles can be distinguished from each other.
const MANY: usize = 4;

impl Report<'_> {
    pub(super) fn figures(&self, reported: &Reported) -> Vec<Figure> {
        let mut out = Vec::new();
        if !reported.points.is_empty() {
            out.push(self.branches_over_speed(reported));
        }
        if let (Some(least), Some(requested)) = (&self.least, self.stabilise)
            && least.growth.iter().any(|g| g.1.is_finite())
        {
            let title = Message::new("stationary-title-stabilised").arg("speed", Arg::speed(requested.speed));
            let alt = Message::new("stationary-alt-stabilised").arg("parameter", parameter_name(&requested.path));
            let panel = Panel::new(Axis::new("growth rate", "1/s"))
                .mark(Line::new("stabilised", "value", "growth").name("largest growth rate"))
                .mark(Rule::y(0.0, ""));
            let panel = least
                .edges
                .iter()
                .fold(panel, |p, e| p.mark(Rule::x(e.value, if e.gains { "stable from here" } else { "unstable from here" })));
            let unit = unit_of(self.system, &requested.path);
            let x = Axis { scale: scale(wide(&requested.range)), ..axis(parameter_name(&requested.path), unit) };
            out.push(Figure::new("stabilised", title, alt).x(x).panel(panel));
        }
        out.extend(self.chart.iter().filter(|c| !c.cells.is_empty()).map(|c| chart(self.system, c)));
        out.extend(self.errors.iter().enumerate().filter_map(|(k, e)| errors(self.system, e, k)));
        out
    }

    fn branches_over_speed(&self, reported: &Reported) -> Figure {
        let mut panels = Vec::new();
        let most = largest(reported.points.iter().map(|p| p.seen.radius()));
        let line = |column: String| {
            let line = Line::new("branches", "speed", column).group("kind").called(called("stationary-class", CLASSES));
            line.begins_where("begins").solid_where("stable").meaning("stable", "unstable")
        };
        let changes = self.found.paths.iter().any(|p| !p.special.is_empty());
        // of several bodies the table of continua tells the largest distance only
        let sheets = !self.continua.sheets.is_empty();
        let alone = sheets && self.system.stations().len() == 1;
        let continua = |column: &str| Points::new("continua", "speed", column).name("continuum, the sample with most");
        for body in self.system.stations() {
            let column = format!("{} radius", body.name);
            let mut panel = Panel::new(Axis::new(Arg::of("distance from the axis", Arg::name(&body.name)), "m").metres(most))
                .mark(line(column.clone()));
            if changes {
                panel = panel.mark(Points::new("changes", "speed", column).group("change").called(called("stationary-change", CHANGES)));
            }
            if alone {
                panel = panel.mark(continua("radius"));
            }
            panels.push(panel);
        }
        if reported.points.iter().any(|p| p.seen.unbalance.is_some()) {
            let panel = Panel::new(Axis::new("unbalance", "g mm").factor(1e6)).mark(line("unbalance".into()));
            let panel = panel.mark(Line::new("branches", "speed", "without").begins_where("begins").name("without the balls"));
            panels.push(if sheets { panel.mark(continua("unbalance")) } else { panel });
        }
        if !self.found.images.angles.is_empty() {
            // where branches are many the angles of those that no machine stays on hide the others
            let only = self.found.paths.len() > MANY && reported.points.iter().any(|p| p.growing == 0);
            let label = if only { "angles of the balls, stable states only" } else { "angles of the balls" };
            let mut panel = Panel::new(Axis::new(label, "rad").range(-3.3, 3.3));
            for &i in self.found.images.groups.iter().flatten() {
                panel = panel.mark(line(column_of(self.system, i)).solid_only(only));
            }
            panels.push(panel);
        }
        let alt = findings::alt(&reported.ranges, self.found.paths.len());
        let figure = Figure::new("states", "Equilibria in the rotating frame", alt).x(Axis::new("spin speed", "rad/s"));
        panels.into_iter().fold(figure, Figure::panel)
    }
}

/// Words of the chart in the order of their colours: blue, red, green, pink.
const VERDICTS: [&str; 4] = ["balanced or not", "not balanced", "balanced only", "none stable"];

fn chart(system: &System, chart: &Chart) -> Figure {
    let path = chart.path.as_str();
    let axis = Axis { scale: scale(chart.wide), ..axis(parameter_name(path), unit_of(system, path)) };
    let values = chart.cells.iter().map(|c| c.value * axis.factor);
    let (from, to) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
    let axis = if from < to { axis.range(from, to) } else { axis };
    let words = VERDICTS.map(String::from).to_vec();
    debug_assert!(CELLS.iter().all(|w| VERDICTS.contains(w)));
    let mut panel = Panel::new(axis).mark(Heat::new("chart", "speed", path, "verdict", Axis::new("stable states", "")).of_classes(words));
    if !chart.edges.is_empty() {
        panel = panel.mark(Points::new("boundary", "speed", path).group("edge"));
    }
    let named = |key: &str| Message::new(key).arg("parameter", parameter_name(path));
    let (title, alt) = (named("stationary-title-chart"), named("stationary-alt-chart"));
    Figure::new("chart", title, alt).x(Axis::new("spin speed", "rad/s")).panel(panel)
}

fn errors(system: &System, e: &Errors, k: usize) -> Option<Figure> {
    let path = &e.requested.path;
    e.costs.iter().find(|c| c.unbalance.0.is_finite())?;
    let table = format!("errors_{}", k + 1);
    let line = |column: &str, name: &'static str| Line::new(table.clone(), "value", column).name(name);
    let title = Message::new("stationary-title-errors").arg("speed", Arg::speed(e.requested.speed));
    let alt = Message::new("stationary-alt-errors").arg("parameter", parameter_name(path));
    let panel = Panel::new(Axis::new("unbalance", "g mm").factor(1e6))
        .mark(line("unbalance_least", "best stable state"))
        .mark(line("without", "without the balls"));
    let differ = e.costs.iter().any(|c| c.unbalance.1 > c.unbalance.0 * (1.0 + 1e-6));
    let panel = if differ { panel.mark(line("unbalance_largest", "worst stable state")) } else { panel };
    let x = axis(parameter_name(path), unit_of(system, path));
    Some(Figure::new(table.clone(), title, alt).x(x).panel(panel))
}
