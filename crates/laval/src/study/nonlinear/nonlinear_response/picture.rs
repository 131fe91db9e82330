//! The figure.

use super::shown::{Shown, assessed};
use super::stretches::unstable_throughout;
use super::sweeps::reached;
use crate::model::probe::Probe;
use crate::outcome::{Axis, Band, Figure, Line, Panel, Rule, quantity, significant};
use crate::solve::harmonic::branches::branch::Origin;
use crate::solve::harmonic::branches::response::{Response, Traced};
use crate::study::shared::probes;

/// Panels of the figure of forces at most.
const MOST_PANELS: usize = 4;

impl Shown<'_> {
    /// Largest displacement and growth rate over the speed; with `all` families of states, every body in a panel of its own.
    pub(super) fn figure(&self, response: &Response, all: bool, speeds: (f64, f64)) -> Figure {
        let moved =
            self.measured.sizes.iter().flatten().flat_map(|s| self.probes.iter().zip(s)).filter(|(p, _)| !p.is_tilt()).map(|s| *s.1);
        let values: Vec<f64> = moved.filter(|a| *a > 0.0 && a.is_finite()).collect();
        let (least, most) = values.iter().fold((f64::INFINITY, 0.0f64), |(l, m), &a| (l.min(a), m.max(a)));
        let factor_of = |label: String| {
            // on a linear axis families lie apart that on a logarithmic one do not
            let axis = if most > 100.0 * least && !all { Axis::log(label, "m") } else { Axis::new(label, "m") };
            Panel::new(axis.metres(most))
        };
        let assessed = assessed(response);
        let whole = response.branches.iter().flat_map(|b| &b.points).all(|p| p.exponents.is_some());
        // one family of states needs no number in the legend
        let grouped = |line: Line| match (all, response.branches.len()) {
            (true, _) => line.group("states").begins_where("begins"),
            (false, 1) => line,
            _ => line.group("branch"),
        };
        // mixed states are as large as the larger of their planes, but not in the mean
        let measure = if all { "rms" } else { "largest" };
        let column = |column: String, shown: &str| {
            let line = grouped(Line::new("response", "speed", column).name(shown));
            let line = line.solid_where("not unstable");
            if whole { line } else { line.meaning("stable or not assessed", "unstable") }
        };
        let line = |name: &str, shown: &str| column(format!("{name} {measure} displacement"), shown);
        let displaced = self.displaced();
        let mut panels: Vec<Panel> = if !displaced {
            vec![]
        } else if all {
            self.bodies.iter().map(|name| factor_of(format!("rms displacement of {name}")).mark(line(name, ""))).collect()
        } else {
            let panel = factor_of("largest displacement".into());
            let shown = self.probes.iter().filter(|p| !p.is_tilt());
            vec![shown.fold(panel, |panel, p| panel.mark(column(probes::largest_column(p), &probes::owner(p))))]
        };
        // the largest tilts are among what parts show
        let tilt = |p: &&Probe| p.is_tilt() && self.measured.observed.iter().any(|o| o.0 == format!("{} tilt", p.name));
        let tilts: Vec<&Probe> = self.probes.iter().filter(tilt).collect();
        if !tilts.is_empty() {
            let panel = Panel::new(Axis::new("largest tilt", "mrad").factor(1e3));
            panels.push(tilts.iter().fold(panel, |panel, p| panel.mark(column(format!("{} tilt", p.name), &p.name))));
        }
        let main = response.branches.iter().filter(|b| matches!(b.origin, Origin::Low | Origin::High));
        let [up, down] = [true, false].map(|up| reached(response, up, speeds));
        if let Some(first) = panels.first_mut() {
            for f in main.flat_map(|b| &b.folds) {
                let words = match f.upper {
                    true if up.contains(&f.speed) => "jump up-sweep",
                    false if down.contains(&f.speed) => "jump down-sweep",
                    _ => "fold",
                };
                *first = first.clone().mark(Rule::x(f.speed, words));
            }
        }
        let shown = |b: &&Traced| !all || matches!(b.origin, Origin::Low | Origin::High);
        let unstable = match assessed {
            true => unstable_throughout(&response.branches.iter().filter(shown).collect::<Vec<_>>()),
            false => Vec::new(),
        };
        for panel in &mut panels {
            for &(from, to) in &unstable {
                *panel = panel.clone().mark(Band::x(from, to).name("unstable").strip());
            }
        }
        let alt = self.alt(response);
        let mut figure = Figure::new("response", "Steady response to unbalance", alt).x(Axis::new("speed", "rad/s"));
        figure = panels.into_iter().fold(figure, Figure::panel);
        if assessed {
            let mut growth = Panel::new(Axis::new("growth rate", "1/s"));
            for &(from, to) in &unstable {
                growth = growth.mark(Band::x(from, to).name("unstable").strip());
            }
            let name = if all { "" } else { "largest growth rate" };
            let growth =
                growth.mark(grouped(Line::new("response", "speed", "growth rate").name(name)).solid_where("stable")).mark(Rule::y(0.0, ""));
            figure = figure.panel(growth);
        }
        figure
    }

    /// Forces of bearings and to the ground over the speed, a panel each, with what they tend to.
    pub(super) fn force_figure(&self, response: &Response, all: bool) -> Option<Figure> {
        let mut figure = Figure::new(
            "forces",
            "Forces of the steady response",
            format!("Largest force over a period of {} parts against speed.", self.measured.forces.len()),
        )
        .x(Axis::new("speed", "rad/s"));
        let limits = self.force_limits();
        for e in self.measured.forces.iter().take(MOST_PANELS) {
            let name = &self.system.slots()[e.slot].name;
            let column = self
                .measured
                .observed
                .iter()
                .find(|(n, unit)| unit == "N" && n.strip_prefix(name.as_str()).is_some_and(|n| n.starts_with(' ')))?;
            let line = Line::new("response", "speed", &column.0).name("largest over a period").solid_where("not unstable");
            let line = match (all, response.branches.len()) {
                (true, _) => line.group("states").begins_where("begins"),
                (false, 1) => line,
                _ => line.group("branch"),
            };
            let mut panel = Panel::new(Axis::log(&column.0, "N")).mark(line);
            for (_, limit) in limits.iter().filter(|l| l.0 == e.slot) {
                panel = panel.mark(Rule::y(*limit, "at ever higher speed"));
            }
            figure = figure.panel(panel);
        }
        (!figure.panels.is_empty()).then_some(figure)
    }

    fn alt(&self, response: &Response) -> String {
        let folds = response.branches.iter().map(|b| b.folds.len()).sum::<usize>();
        match self.most() {
            Some(l) if self.measured.rising.is_none() && self.displaced() => format!(
                "Largest displacement of each body against speed, on {} branch(es) with {folds} fold(s); the largest, {} of {}, is at {} rad/s.",
                response.branches.len(),
                quantity(l.best().0, "m"),
                l.owner,
                significant(l.best().1, 5)
            ),
            _ => "Largest displacement of each body against speed.".into(),
        }
    }
}
