//! Tables, special points and the figure of a stability map.

use super::regions::Regions;
use super::{StabilityMap, StabilityMapResult};
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use crate::outcome::{
    Arg, Axis, Band, Figure, Heat, Line, Message, Outcome, Panel, Points, Rule, SpecialPoint, Status, Table, TableBuilder, parameter_name,
};
use crate::solve::roots::in_region;
use crate::solve::stability::{Edge, Peak, Row, Sample};
use crate::study::Study;
use crate::study::linear::operating::operating;
use crate::study::shared::support::inconsistent;
use laval_num::order::SortByNumber;

/// A point of the map: its row, what is known there, and whether it is a point of the boundary.
pub(super) struct Cell {
    pub row: usize,
    pub sample: Sample,
    pub crossing: bool,
}

pub(super) struct Shown<'a> {
    pub study: &'a StabilityMap,
    pub system: &'a System,
    pub result: &'a StabilityMapResult,
    /// Roots without number: those that grow are counted, others are not all known.
    pub endless: bool,
    /// Growth from which on a mode counts as unstable, 1/s.
    pub threshold: f64,
    /// Name and unit of the parameter.
    pub name: String,
    pub unit: &'static str,
    values: Vec<Option<f64>>,
    pub cells: Vec<Cell>,
    /// With their rows.
    pub edges: Vec<(usize, &'a Edge)>,
    pub peaks: Vec<(usize, &'a Peak)>,
}

/// A growth rate so many times as large hides another on a linear axis.
const HIDES: f64 = 12.0;
/// Linear part of an axis of growth, over its end, at least.
const SMALLEST: f64 = 1e-4;

/// The root that crosses a boundary, there.
fn at_boundary(e: &Edge) -> Sample {
    Sample { speed: e.speed, value: e.value, sector: None, size: 0.0, on_grid: false, other: false, growing: None, counted: false }
}

impl<'a> Shown<'a> {
    pub fn new(study: &'a StabilityMap, system: &'a System, result: &'a StabilityMapResult) -> Self {
        let (rows, endless, two) = (&result.rows, in_region(system), study.parameter.is_some());
        let (name, unit) = match &study.parameter {
            Some((path, _)) => {
                let unit = system.param(path).and_then(|i| system.param_slots().get(*i.first()?)).map_or("", |s| s.unit);
                (path.clone(), unit)
            }
            None => (String::new(), ""),
        };
        // the map keeps the grid; along one line the points between belong to it too
        let each = |(row, r): (usize, &'a Row)| {
            r.samples.iter().filter(|s| s.on_grid || !two).map(move |s| Cell { row, sample: *s, crossing: false })
        };
        let mut cells: Vec<Cell> = rows.iter().enumerate().flat_map(each).collect();
        // the curve of what is known ends at its boundary, not at the last point before it
        let ends = rows.iter().take(usize::from(endless && !two)).flat_map(|r| &r.edges).filter(|e| e.located);
        cells.extend(ends.map(|e| Cell { row: 0, sample: at_boundary(e), crossing: true }));
        if !two {
            cells.sort_by_number(|a| a.sample.speed);
        }
        Shown {
            study,
            system,
            result,
            endless,
            threshold: if endless { study.least(system, &study.speed.linspace(200)) } else { study.threshold },
            name,
            unit,
            values: study.values(),
            cells,
            edges: rows.iter().enumerate().flat_map(|(k, r)| r.edges.iter().map(move |e| (k, e))).collect(),
            peaks: rows.iter().enumerate().flat_map(|(k, r)| r.peaks.iter().map(move |p| (k, p))).collect(),
        }
    }

    pub fn outcome(&self, name: &str) -> Result<Outcome, Diagnostic> {
        let (one, two) = (self.study.speed.is_one(), self.two());
        let solved: u64 = self.rows().iter().map(|r| r.solved).sum();
        let mut out = Outcome::new(StabilityMap::KIND, name).over("speed", "rad/s").end(self.result.end).work("eigenproblems", solved);
        out = self.special_points().into_iter().fold(out, Outcome::special_point);
        out = self.findings().into_iter().chain(self.result.states.remarks(self.system)).fold(out, Outcome::finding);
        let map = self.map_table()?;
        let (grows, whirls) = (map.column("growth").is_some(), map.column("frequency").is_some());
        out = out.table(map);
        // along the speed there are no boundaries and peaks at one speed, and without a parameter no curve
        if !one {
            out = out.table(self.boundary_table()?).table(self.peaks_table()?);
        }
        if two && !self.regions().is_empty() {
            out = out.table(self.regions().table(&self.name, self.unit).build().map_err(inconsistent)?);
        }
        // where nothing is known to grow there is nothing to draw
        if grows && (two || !one) {
            out = out.figure(self.figure(whirls));
        }
        out.checked().map_err(inconsistent)
    }

    pub fn rows(&self) -> &'a [Row] {
        &self.result.rows
    }

    /// The speed and a parameter vary.
    pub fn two(&self) -> bool {
        self.study.parameter.is_some()
    }

    pub fn complete(&self) -> bool {
        self.result.end.is_complete()
    }

    /// Value of the parameter in a row.
    pub fn value(&self, row: usize) -> f64 {
        self.values[row].unwrap_or(f64::NAN)
    }

    /// Roots that grow no faster are not all known.
    fn unknown(&self, c: &Cell) -> bool {
        self.endless && !(c.sample.value.re > self.threshold) && !c.crossing
    }

    fn special_points(&self) -> Vec<SpecialPoint> {
        let mut out = Vec::new();
        let at = |p: SpecialPoint, k: usize| if self.two() { p.evidence(parameter_name(&self.name), self.value(k), self.unit) } else { p };
        for &(k, e) in &self.edges {
            let kind = if e.onset { "instability_onset" } else { "instability_end" };
            let status = if e.located { Status::Located } else { Status::Bracketed };
            let point = SpecialPoint::new(kind, e.speed, e.bracket).status(status).evidence("frequency", e.value.im, "rad/s");
            out.push(at(point.evidence("uncertainty", e.step, "rad/s"), k));
        }
        for &(k, p) in &self.peaks {
            let point = SpecialPoint::new("growth_peak", p.speed, p.bracket).evidence("growth", p.value.re, "1/s");
            out.push(at(point.evidence("frequency", p.value.im, "rad/s"), k));
        }
        out
    }

    /// A table that begins with the speed and, where it varies, the parameter.
    fn places(&self, table: TableBuilder, speeds: Vec<f64>, rows: impl Iterator<Item = usize>) -> TableBuilder {
        let table = table.float("speed", "rad/s", "spin speed", speeds);
        let values = rows.map(|k| self.value(k)).collect();
        if self.two() { table.float(&self.name, self.unit, "parameter", values) } else { table }
    }

    fn map_table(&self) -> Result<Table, Diagnostic> {
        let cells = &self.cells;
        // where all growth is rounding no mode is the strongest
        let frequency = |c: &Cell| {
            let row = &self.rows()[c.row];
            if self.unknown(c) || row.undamped && !row.unstable(&c.sample, 0.0) { f64::NAN } else { c.sample.value.im }
        };
        let map = Table::new("map", "Largest growth rate");
        let map = self
            .places(map, cells.iter().map(|c| c.sample.speed).collect(), cells.iter().map(|c| c.row))
            .float_if_any(
                "growth",
                "1/s",
                if self.endless {
                    "largest growth rate of all modes; NaN where none grows faster than the threshold"
                } else {
                    "largest growth rate of all modes"
                },
                cells.iter().map(|c| if self.unknown(c) { f64::NAN } else { c.sample.value.re }).collect(),
            )
            .float_if_any(
                "frequency",
                "rad/s",
                "frequency of that mode; NaN where nothing damps or drives any, or none grows",
                cells.iter().map(frequency).collect(),
            )
            .flag("other_mode", "it is another mode than at the speed before", cells.iter().map(|c| c.sample.other).collect());
        let map = if self.endless {
            let number = |c: &Cell| c.sample.growing.map_or(f64::NAN, |n| n as f64);
            let doc = "modes that grow faster than the threshold, by the argument principle; NaN where the count could not be brought to agree with the roots found, and \
                       at a boundary";
            map.float_if_any("growing", "", doc, cells.iter().map(number).collect())
        } else {
            map
        };
        map.build().map_err(inconsistent)
    }

    fn boundary_table(&self) -> Result<Table, Diagnostic> {
        let edges = &self.edges;
        let boundary = Table::new("boundary", "Points where the growth rate crosses the threshold, located");
        self.places(boundary, edges.iter().map(|e| e.1.speed).collect(), edges.iter().map(|e| e.0))
            .text(
                "edge",
                "onset: unstable above this speed; end: stable above",
                edges.iter().map(|e| if e.1.onset { "onset" } else { "end" }.into()).collect(),
            )
            .float("growth", "1/s", "growth rate", edges.iter().map(|e| e.1.value.re).collect())
            .float("frequency", "rad/s", "frequency", edges.iter().map(|e| e.1.value.im).collect())
            .text("method", "how it was located", edges.iter().map(|e| if e.1.double { "double root" } else { "bracket" }.into()).collect())
            .float("uncertainty", "rad/s", "last step or bracket", edges.iter().map(|e| e.1.step).collect())
            .build()
            .map_err(inconsistent)
    }

    fn peaks_table(&self) -> Result<Table, Diagnostic> {
        let peaks = &self.peaks;
        let tops = Table::new("peaks", "Maxima of the growth rate over the speed");
        self.places(tops, peaks.iter().map(|p| p.1.speed).collect(), peaks.iter().map(|p| p.0))
            .float("growth", "1/s", "growth rate", peaks.iter().map(|p| p.1.value.re).collect())
            .float("frequency", "rad/s", "frequency", peaks.iter().map(|p| p.1.value.im).collect())
            .build()
            .map_err(inconsistent)
    }

    /// Unstable regions, where all of their boundary is located.
    fn regions(&self) -> Regions {
        if self.endless || !self.two() || self.study.speed.is_one() || !self.complete() || self.edges.iter().any(|e| !e.1.located) {
            return Regions::default();
        }
        let rows = self.rows().iter().enumerate();
        Regions::of(&rows.map(|(k, r)| (self.value(k), r.unstable_ranges(self.threshold))).collect::<Vec<_>>())
    }

    /// Growth rates of which the map has curves: halves of the largest.
    fn levels(&self) -> Vec<f64> {
        let most = self.cells.iter().map(|c| c.sample.value.re).filter(|g| g.is_finite()).fold(0.0, f64::max);
        let round = |x: f64| {
            let power = 10f64.powf(x.log10().floor());
            [5.0, 2.0, 1.0].into_iter().map(|m| m * power).find(|v| *v <= x * (1.0 + 1e-9)).unwrap_or(power)
        };
        if !(most > self.threshold.max(0.0)) {
            return Vec::new();
        }
        let mut out: Vec<f64> = [0.8, 0.4, 0.15].into_iter().map(|share| round(share * most)).filter(|g| *g > self.threshold).collect();
        out.dedup();
        out
    }

    /// Largest growth rate at the operating speed; NaN where it is not known.
    fn growth_operating(&self) -> f64 {
        let cell = self.result.operating.map(|sample| Cell { row: 0, sample, crossing: false });
        cell.filter(|c| !self.unknown(c)).map_or(f64::NAN, |c| c.sample.value.re)
    }

    /// Axis of the growth rate: where the largest hides the reserve, or the value at the operating speed, logarithmic on both sides of zero.
    fn growth_axis(&self, operating: f64) -> Axis {
        let axis = Axis::new("growth rate", "1/s");
        let known = self.cells.iter().filter(|c| !self.unknown(c)).map(|c| c.sample.value.re).filter(|g| g.is_finite());
        let (lo, hi) = known.fold((0.0f64, 0.0f64), |(a, b), g| (a.min(g), b.max(g)));
        let largest = hi.max(-lo);
        let small = [-lo, hi, operating.abs()].into_iter().filter(|v| *v > 0.0).fold(largest, f64::min);
        if !(largest > HIDES * small) {
            return axis;
        }
        let knee = 10f64.powf(small.log10().floor()).max(SMALLEST * largest);
        Axis { label: "growth rate, logarithmic on both sides of zero".into(), ..axis }.knee(knee)
    }

    fn figure(&self, whirls: bool) -> Figure {
        let (name, unit, threshold) = (self.name.clone(), self.unit, self.threshold);
        let speed_axis = Axis::new("spin speed", "rad/s");
        let operating = operating(self.system, self.study.speed.from, self.study.speed.to);
        if self.study.speed.is_one() {
            let growth = Panel::new(Axis::new("growth rate", "1/s"))
                .mark(Line::new("map", name.clone(), "growth").name("largest growth rate"))
                .mark(Rule::y(threshold, "threshold"));
            let alt = Message::new("stability-map-alt-parameter").arg("parameter", parameter_name(&name));
            let alt = alt.arg("speed", Arg::speed(self.study.speed.from));
            let figure = Figure::new("stability", "Largest growth rate", alt);
            return figure.x(Axis::parameter(&name, unit)).panel(growth);
        }
        if self.two() {
            let heat = Heat::new("map", "speed", name.clone(), "growth", Axis::new("growth rate", "1/s")).diverging();
            let located = !self.regions().is_empty();
            let heat = if located { heat.curves(self.levels()) } else { heat.contour(threshold) };
            let alt = Message::new("stability-map-alt-map").arg("parameter", parameter_name(&name));
            let mut panel = Panel::new(Axis::parameter(&name, unit)).mark(heat);
            if located {
                panel = panel.mark(Band::across("regions", name.clone(), "from", "to").group("region").bad().name("unstable"));
            }
            if let Some(o) = &operating {
                panel = panel.mark(o.rule());
            }
            let own = self.system.param(&name).and_then(|i| self.system.params().get(*i.first()?).copied());
            let range = self.study.parameter.as_ref().map(|p| &p.1);
            if let Some(value) = own.filter(|v| range.is_some_and(|r| (r.from.min(r.to)..=r.from.max(r.to)).contains(v))) {
                panel = panel.mark(Rule::y(value, "machine"));
            }
            let boundary = Points::new("boundary", "speed", name).small().name("boundary, located");
            return Figure::new("stability", "Stability map", alt).x(speed_axis).panel(panel.mark(boundary));
        }
        let here = operating.as_ref().map(|o| (o, self.growth_operating()));
        let mut growth = Panel::new(self.growth_axis(here.as_ref().map_or(f64::NAN, |h| h.1)));
        if let Some((o, value)) = &here {
            let growing = Message::new("stability-map-operating").arg("growth", Arg::quantity(*value, "1/s"));
            growth = growth.mark(if value.is_finite() { Rule::x(o.speed(), growing) } else { o.rule() });
        }
        for (from, to) in self.rows()[0].unstable_ranges(threshold) {
            growth = growth.mark(Band::x(from, to).name("unstable").strip());
            growth = growth.mark(Rule::x(from, "unstable").between(from, to));
        }
        growth = growth
            .mark(Line::new("map", "speed", "growth").name("largest growth rate"))
            .mark(Rule::y(threshold, if threshold == 0.0 { "unstable above" } else { "threshold" }))
            .mark(Points::new("peaks", "speed", "growth").name("peak"))
            .mark(Points::new("boundary", "speed", "growth").name("boundary"));
        let frequency = Line::new("map", "speed", "frequency").name("its frequency").begins_where("other_mode");
        let figure = Figure::new("stability", "Largest growth rate", "stability-map-alt").x(speed_axis).panel(growth);
        let below = Panel::new(Axis::new("frequency of the strongest mode", "rad/s")).mark(frequency);
        if whirls { figure.panel(below) } else { figure }
    }
}
