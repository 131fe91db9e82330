//! The figure.

use super::shown::{Shown, assessed};
use super::stretches::unstable_throughout;
use super::sweeps::reached;
use crate::model::probe::Probe;
use crate::outcome::{Arg, Axis, Band, Figure, Line, Message, Panel, Rule};
use crate::solve::harmonic::branches::branch::Origin;
use crate::solve::harmonic::branches::response::{Response, Traced};
use crate::study::shared::probes;

/// Parts in the figure of forces at most.
const MOST_FORCES: usize = 4;
/// Share of the speeds that the jumps fill up to which they are enlarged.
const NARROW: f64 = 0.2;

impl Shown<'_> {
    /// Largest displacement and growth rate over the speed; with `all` families of states, every body in a panel of its own.
    pub(super) fn figure(&self, response: &Response, all: bool, speeds: (f64, f64)) -> Figure {
        let moved =
            self.measured.sizes.iter().flatten().flat_map(|s| self.probes.iter().zip(s)).filter(|(p, _)| !p.is_tilt()).map(|s| *s.1);
        let values: Vec<f64> = moved.filter(|a| *a > 0.0 && a.is_finite()).collect();
        let (least, most) = values.iter().fold((f64::INFINITY, 0.0f64), |(l, m), &a| (l.min(a), m.max(a)));
        let factor_of = |label: Arg| {
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
        let column = |column: String, shown: Arg| {
            let line = grouped(Line::new("response", "speed", column).name(shown));
            let line = line.solid_where("not unstable");
            if whole { line } else { line.meaning("stable or not assessed", "unstable") }
        };
        let line = |name: &str| column(format!("{name} {measure} displacement"), Arg::default());
        let displaced = self.displaced();
        let mut panels: Vec<Panel> = if !displaced {
            vec![]
        } else if all {
            self.bodies.iter().map(|name| factor_of(Arg::of("rms displacement", Arg::name(name))).mark(line(name))).collect()
        } else {
            let panel = factor_of("largest displacement".into());
            let shown = self.probes.iter().filter(|p| !p.is_tilt());
            vec![shown.fold(panel, |panel, p| panel.mark(column(probes::largest_column(p), probes::label(p))))]
        };
        // the largest tilts are among what parts show
        let tilt = |p: &&Probe| p.is_tilt() && self.measured.observed.iter().any(|o| o.0 == format!("{} tilt", p.name));
        let tilts: Vec<&Probe> = self.probes.iter().filter(tilt).collect();
        if !tilts.is_empty() {
            let panel = Panel::new(Axis::new("largest tilt", "mrad").factor(1e3));
            panels.push(tilts.iter().fold(panel, |panel, p| panel.mark(column(format!("{} tilt", p.name), Arg::name(&p.name)))));
        }
        let main = response.branches.iter().filter(|b| matches!(b.origin, Origin::Low | Origin::High));
        let [up, down] = [true, false].map(|up| reached(response, up, speeds));
        if let Some(first) = panels.first_mut() {
            for f in main.flat_map(|b| &b.folds) {
                let words = match f.upper {
                    true if up.contains(&f.speed) => "jump (run-up)",
                    false if down.contains(&f.speed) => "jump (run-down)",
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
        let mut figure = Figure::new("response", "Steady-state unbalance response", alt).x(Axis::new("speed", "rad/s"));
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

    /// The displacement beside the jumps, where they fill little of the range of speeds; `None` where they do not.
    pub(super) fn jump_figure(&self, response: &Response, figure: &Figure, speeds: (f64, f64)) -> Option<Figure> {
        let folds = response.branches.iter().flat_map(|b| &b.folds).map(|f| f.speed);
        let (lo, hi) = folds.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), w| (l.min(w), h.max(w)));
        let (from, to) = (speeds.0.min(speeds.1), speeds.0.max(speeds.1));
        let margin = (hi - lo).max(1e-3 * (to - from));
        if !(hi > lo && hi - lo < NARROW * (to - from)) {
            return None;
        }
        let mut panel = figure.panels.first()?.clone();
        panel.y.range = None;
        let x = Axis::new("speed", "rad/s").range((lo - margin).max(from), (hi + margin).min(to));
        Some(Figure::new("jumps", "Steady-state response at the jumps", "nonlinear-response-alt-jumps").x(x).panel(panel))
    }

    /// Forces of bearings and to the ground over the speed, with what they tend to.
    pub(super) fn force_figure(&self, response: &Response, all: bool) -> Option<Figure> {
        let limits = self.force_limits();
        let mut panel = Panel::new(Axis::log("largest force", "N"));
        let mut count = 0;
        for e in self.measured.forces.iter().take(MOST_FORCES) {
            let name = &self.system.slots()[e.slot].name;
            let column = self
                .measured
                .observed
                .iter()
                .find(|(n, unit)| unit == "N" && n.strip_prefix(name.as_str()).is_some_and(|n| n.starts_with(' ')))?;
            let line = Line::new("response", "speed", &column.0).name(Arg::name(name)).solid_where("not unstable");
            let line = match (all, response.branches.len()) {
                (true, _) => line.group("states").begins_where("begins"),
                (false, 1) => line,
                _ => line.group("branch"),
            };
            panel = panel.mark(line);
            for (_, limit) in limits.iter().filter(|l| l.0 == e.slot) {
                panel = panel.mark(Rule::y(*limit, Message::new("nonlinear-response-limit").arg("part", Arg::name(name))));
            }
            count += 1;
        }
        let alt = Message::new("nonlinear-response-alt-forces").arg("parts", Arg::count(count));
        (count > 0).then(|| Figure::new("forces", "Forces of the steady-state response", alt).x(Axis::new("speed", "rad/s")).panel(panel))
    }

    fn alt(&self, response: &Response) -> Message {
        let folds = response.branches.iter().map(|b| b.folds.len()).sum::<usize>();
        let alt =
            Message::new("nonlinear-response-alt").arg("branches", Arg::count(response.branches.len())).arg("folds", Arg::count(folds));
        match self.most() {
            Some(l) if self.measured.rising.is_none() && self.displaced() => alt
                .arg("largest", Arg::word("known"))
                .arg("value", Arg::quantity(l.best().0, "m"))
                .arg("point", self.place(l))
                .arg("speed", Arg::speed(l.best().1)),
            _ => alt.arg("largest", Arg::word("unknown")),
        }
    }
}
