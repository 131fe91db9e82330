//! Tables of the states, and the outcome.

use super::chart::Chart;
use super::classify::Seen;
use super::continua::Continua;
use super::errors::Errors;
use super::least::Least;
use super::ranges::{self, Harm, Range, Shown};
use super::slack::{self, Left};
use super::zones::{self, Zone};
use super::{Row, StationaryResult, Study, Varied, unit_of};
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use crate::outcome::{Arg, Message, Outcome, OutcomeError, SpecialPoint, Status, Table, TableBuilder, parameter_name};
use crate::solve::stationary::{Change, Found, Located, Path, Search};
use crate::study::shared::support::probe_name;
use laval_num::order::SortByNumber;
use serde::{Deserialize, Serialize};

/// What is to be reported.
pub(super) struct Report<'a> {
    pub system: &'a System,
    pub range: (f64, f64),
    /// Speed the machine is meant for, rad/s.
    pub operating: f64,
    pub stabilise: Option<&'a Varied>,
    pub found: &'a Found,
    pub rows: &'a [Row],
    pub continua: &'a Continua,
    pub zones: &'a [Zone],
    pub slack: &'a [Left],
    pub least: Option<&'a Least>,
    pub errors: &'a [Errors],
    pub chart: Option<&'a Chart>,
    /// Nothing was left out for want of time.
    pub complete: bool,
}

/// What follows from the branches.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Reported {
    /// Points of all branches.
    pub points: Vec<Shown>,
    /// Ranges in which states are stable.
    pub ranges: Vec<Range>,
    /// Where in which of them the masses make the unbalance larger.
    pub harm: Vec<(usize, Harm)>,
    /// What the special points show.
    pub special: Vec<Seen>,
}

impl Reported {
    pub(super) fn of(system: &System, search: &mut Search, found: &Found, highest: f64) -> Self {
        let points = ranges::points(system, search, found);
        let ranges = ranges::stable(system, search, found, &points, highest);
        let special = found.paths.iter().flat_map(|p| &p.special).map(|l| Seen::of(system, search, &l.state)).collect();
        let mut harm = Vec::new();
        for (k, r) in ranges.iter().enumerate() {
            harm.extend(ranges::harmful(system, search, found, &points, r).into_iter().map(|h| (k, h)));
        }
        Reported { points, ranges, harm, special }
    }
}

/// The column of an angle.
pub(super) fn column_of(system: &System, coordinate: usize) -> String {
    system.coordinates()[coordinate].name.clone()
}

impl Report<'_> {
    pub fn outcome(&self, result: &StationaryResult, name: &str) -> Result<Outcome, Diagnostic> {
        let (found, reported) = (self.found, &result.shown);
        let mut out = Outcome::new(super::Stationary::KIND, name)
            .over("speed", "rad/s")
            .end(result.end)
            .work("starts", found.starts[0])
            .work("points", found.paths.iter().map(|p| p.points.len() as u64).sum());
        for f in self.findings(reported) {
            out = out.finding(f);
        }
        for place in &result.places {
            let place: Vec<(usize, &Located)> = place.iter().filter_map(|&(k, i)| Some((k, found.paths.get(k)?.special.get(i)?))).collect();
            out = out.special_point(special_point(&place));
        }
        for t in self.tables(reported).map_err(Diagnostic::from)? {
            out = out.table(t);
        }
        for f in self.figures(reported) {
            out = out.figure(f);
        }
        out.checked().map_err(Diagnostic::from)
    }

    fn tables(&self, reported: &Reported) -> Result<Vec<Table>, OutcomeError> {
        let mut all = Vec::new();
        if !self.rows.is_empty() {
            all.extend([self.states()?, self.eigenvalues()?]);
        }
        if !reported.points.is_empty() {
            all.push(self.branches(&reported.points)?);
        }
        if !reported.special.is_empty() {
            all.push(self.changes(&reported.special)?);
        }
        if !self.continua.sheets.is_empty() {
            all.push(self.continua()?);
        }
        if !self.zones.is_empty() {
            all.push(zones::table(self.system, self.rows, self.zones)?);
        }
        if !self.slack.is_empty() {
            all.push(slack::table(self.system, &self.continua.sheets, self.slack)?);
        }
        if let (Some(least), Some(requested)) = (&self.least, self.stabilise) {
            all.push(self.parameter(least, requested)?);
        }
        if let Some(chart) = self.chart.as_ref().filter(|c| !c.cells.is_empty()) {
            all.push(self.chart(chart)?);
            if !chart.edges.is_empty() {
                all.push(self.boundary(chart)?);
            }
        }
        for (k, e) in self.errors.iter().enumerate().filter(|(_, e)| !e.costs.is_empty()) {
            all.push(self.costs(e, k)?);
        }
        Ok(all)
    }

    /// Columns for bodies, angles, what parts show, and the unbalance.
    fn columns(&self, mut t: TableBuilder, seen: &[&Seen]) -> TableBuilder {
        for (k, body) in self.system.stations().iter().enumerate() {
            let of = |f: &dyn Fn(&[f64; 2]) -> f64| seen.iter().map(|s| f(&s.bodies[k])).collect::<Vec<f64>>();
            t = t
                .float(format!("{} radius", body.name), "m", "distance from the axis", of(&|b| b[0].hypot(b[1])))
                .float(format!("{} x", body.name), "m", "displacement in turning axes, along the key mark", of(&|b| b[0]))
                .float(format!("{} y", body.name), "m", "displacement in turning axes, a quarter turn ahead of it", of(&|b| b[1]));
        }
        let others =
            |tilt: bool| self.system.probes().iter().filter(move |p| !p.is_reference() && p.is_tilt() == tilt).map(probe_name).enumerate();
        for (k, name) in others(false) {
            t = t.float(format!("{name} radius"), "m", "distance from the axis", seen.iter().map(|s| s.points[k]).collect());
        }
        for (k, name) in others(true) {
            t = t.float(name, "rad", "angle of the tilt", seen.iter().map(|s| s.tilts[k]).collect());
        }
        let groups = &self.found.images.groups;
        let places: Vec<(usize, usize)> = groups.iter().enumerate().flat_map(|(g, list)| (0..list.len()).map(move |i| (g, i))).collect();
        for (g, i) in places {
            let name = column_of(self.system, groups[g][i]);
            t = t.float(name, "rad", "angle, between -pi and pi", seen.iter().map(|s| s.groups[g][i]).collect());
        }
        let first = seen.first().map_or(&[][..], |s| &s.quantities[..]);
        for (k, (part, q)) in first.iter().enumerate() {
            if q.unit == "rad" || q.unit == "rad/s" {
                continue;
            }
            let values = seen.iter().map(|s| s.quantities.get(k).map_or(f64::NAN, |q| q.1.value)).collect();
            t = t.float(format!("{part} {}", q.name), q.unit, "shown by the part", values);
        }
        if seen.iter().any(|s| s.unbalance.is_some()) {
            let of = |f: &dyn Fn(&Seen) -> Option<f64>| seen.iter().map(|s| f(s).unwrap_or(f64::NAN)).collect::<Vec<f64>>();
            let doc = "unbalance with the masses where they are; NaN where none balance";
            t = t.float("unbalance", "kg m", doc, of(&|s| s.unbalance.map(|u| u.moment.abs()))).float(
                "without",
                "kg m",
                "unbalance without the masses; NaN as above",
                of(&|s| s.unbalance.map(|u| u.without())),
            );
            if seen.iter().any(|s| s.contact() > 0.0) {
                let doc = "largest torque with which masses that touch push each other; 0 where none do";
                t = t.float("contact", "N m", doc, seen.iter().map(|s| s.contact()).collect());
            }
        }
        t
    }

    fn states(&self) -> Result<Table, OutcomeError> {
        let rows = &self.rows;
        let column = |f: &dyn Fn(&Row) -> f64| rows.iter().map(f).collect::<Vec<f64>>();
        let t = Table::new("states", "States at each speed; of states that differ by the names of equal masses only one")
            .int("state", "", "number", (1..=rows.len() as i64).collect())
            .float("speed", "rad/s", "spin speed", column(&|r| r.state.speed))
            .int("branch", "", "branch it lies on", rows.iter().map(|r| r.state.branch as i64 + 1).collect())
            .text("kind", "what kind of state it is", rows.iter().map(|r| r.class.word().into()).collect())
            .flag("locked", "the tilt of the tracks holds the masses near the node line", rows.iter().map(|r| r.seen.locked).collect())
            .flag("stable", "no root grows", rows.iter().map(Row::stable).collect())
            .int("growing", "", "number of growing roots", rows.iter().map(|r| r.stability.growing as i64).collect())
            .float("growth", "1/s", "largest growth rate; NaN where there is no root", column(&|r| r.stability.growth()));
        let seen: Vec<&Seen> = rows.iter().map(|r| &r.seen).collect();
        let t = self.columns(t, &seen);
        let t = if rows.iter().any(|r| r.seen.unbalance.is_some()) {
            let grade = |r: &Row| r.seen.unbalance.map_or(f64::NAN, |u| u.grade(u.moment.abs(), r.state.speed));
            t.float("grade", "m/s", "speed times unbalance over mass (ISO 21940-11); NaN where nothing balances", column(&grade))
        } else {
            t
        };
        t.float("error", "", "estimated error over the typical sizes", column(&|r| r.state.error)).leading().build()
    }

    fn eigenvalues(&self) -> Result<Table, OutcomeError> {
        let rows: Vec<(usize, f64, f64, f64)> = self
            .rows
            .iter()
            .enumerate()
            .flat_map(|(k, r)| r.stability.values.iter().map(move |v| (k, r.state.speed, v.0.re, v.0.im)))
            .collect();
        Table::new("eigenvalues", "Eigenvalues about the states, in turning axes; those with a frequency stand for a conjugate pair")
            .int("state", "", "number of the state", rows.iter().map(|r| r.0 as i64 + 1).collect())
            .float("speed", "rad/s", "spin speed", rows.iter().map(|r| r.1).collect())
            .float("growth", "1/s", "growth rate", rows.iter().map(|r| r.2).collect())
            .float("frequency", "rad/s", "frequency in turning axes", rows.iter().map(|r| r.3).collect())
            .build()
    }

    fn branches(&self, points: &[Shown]) -> Result<Table, OutcomeError> {
        let t = Table::new("branches", "Branches of states, point by point; a branch may turn back in speed")
            .int("branch", "", "number of the branch", points.iter().map(|p| p.path as i64 + 1).collect())
            .float("speed", "rad/s", "spin speed", points.iter().map(|p| p.speed).collect())
            .text("kind", "what kind of state it is", points.iter().map(|p| p.class.word().into()).collect())
            .flag("stable", "no root grows", points.iter().map(|p| p.growing == 0).collect())
            .int("growing", "", "number of growing roots", points.iter().map(|p| p.growing as i64).collect())
            .float("growth", "1/s", "largest growth rate; NaN where there is no root", points.iter().map(|p| p.growth).collect())
            .flag(
                "begins",
                "a curve begins: another branch or kind, or an angle has passed half a turn",
                points.iter().map(|p| p.begins).collect(),
            );
        let seen: Vec<&Seen> = points.iter().map(|p| &p.seen).collect();
        self.columns(t, &seen).build()
    }

    fn changes(&self, seen: &[Seen]) -> Result<Table, OutcomeError> {
        let all: Vec<(usize, &Located)> =
            self.found.paths.iter().enumerate().flat_map(|(k, p): (usize, &Path)| p.special.iter().map(move |l| (k, l))).collect();
        let doc = "fold: two states meet and vanish; branch_point: another branch crosses; hopf: an oscillation begins or ends; real_root: a root crosses zero";
        let column = |f: &dyn Fn(&Located) -> f64| all.iter().map(|a| f(a.1)).collect::<Vec<f64>>();
        let t = Table::new("changes", "Folds, branch points and changes of stability along each branch")
            .int("branch", "", "number of the branch", all.iter().map(|a| a.0 as i64 + 1).collect())
            .text("change", doc, all.iter().map(|a| a.1.change.word().into()).collect())
            .float("speed", "rad/s", "spin speed", column(&|l| l.state.speed))
            .float(
                "frequency",
                "rad/s",
                "frequency of the root that crosses, in turning axes; NaN where it was not located",
                column(&|l| l.frequency),
            )
            .int("growing_before", "", "growing roots before it along the branch", all.iter().map(|a| a.1.growing.0 as i64).collect())
            .int("growing_behind", "", "growing roots behind it", all.iter().map(|a| a.1.growing.1 as i64).collect())
            .flag("located", "located to rounding, not bracketed only", all.iter().map(|a| a.1.located).collect());
        self.columns(t, &seen.iter().collect::<Vec<_>>()).build()
    }

    fn continua(&self) -> Result<Table, OutcomeError> {
        let all = &self.continua.sheets;
        let column = |f: &dyn Fn(&super::continua::Sheet) -> f64| all.iter().map(f).collect::<Vec<f64>>();
        Table::new("continua", "Continua of equilibria, by samples: balls that balance in a continuum of ways")
            .float("speed", "rad/s", "spin speed", column(&|s| s.speed))
            .text("kind", "what kind of states they are", all.iter().map(|s| s.class.word().into()).collect())
            .int("free", "", "directions in which they are free", all.iter().map(|s| s.free as i64).collect())
            .int("samples", "", "samples assessed", all.iter().map(|s| s.samples as i64).collect())
            .int("stable", "", "of these stable but for the free directions", all.iter().map(|s| s.stable as i64).collect())
            .float(
                "growth_least",
                "1/s",
                "growth rate of the sample that grows least; NaN where all directions are free",
                column(&|s| s.growth.0),
            )
            .float("growth_largest", "1/s", "of the one that grows most; NaN as above", column(&|s| s.growth.1))
            .float("radius", "m", "largest distance of a point of a body from the axis", column(&|s| s.radius))
            .float(
                "unbalance",
                "kg m",
                "unbalance of the sample with most; NaN where nothing balances",
                column(&|s| s.unbalance.map_or(f64::NAN, |u| u.moment.abs())),
            )
            .build()
    }

    fn parameter(&self, least: &Least, requested: &Varied) -> Result<Table, OutcomeError> {
        let unit = unit_of(self.system, &requested.path);
        let mut rows: Vec<(f64, f64, bool)> = least.growth.iter().map(|g| (g.0, g.1, false)).collect();
        rows.extend(least.edges.iter().map(|e| (e.value, 0.0, true)));
        rows.sort_by_number(|a| a.0);
        let parameter = parameter_name(&requested.path);
        let doc = Message::new("stationary-table-stabilised").arg("speed", Arg::speed(requested.speed)).arg("parameter", parameter.clone());
        Table::new("stabilised", doc)
            .float("value", unit, parameter, rows.iter().map(|r| r.0).collect())
            .float("growth", "1/s", "largest growth rate; NaN where there is no such state", rows.iter().map(|r| r.1).collect())
            .flag("edge", "stability changes here", rows.iter().map(|r| r.2).collect())
            .build()
    }

    fn chart(&self, chart: &Chart) -> Result<Table, OutcomeError> {
        let all = &chart.cells;
        let kind = |c: &super::chart::Cell| c.class.map_or("none".to_string(), |c| c.word().to_string());
        Table::new("chart", Message::new("stationary-table-chart").arg("parameter", parameter_name(&chart.path)))
            .float("speed", "rad/s", "spin speed", all.iter().map(|c| c.speed).collect())
            .float(chart.path.clone(), unit_of(self.system, &chart.path), "parameter", all.iter().map(|c| c.value).collect())
            .text("balanced", "kind of the state that balances best; none where there is none", all.iter().map(kind).collect())
            .float("growth", "1/s", "its largest growth rate; NaN where no state balances", all.iter().map(|c| c.growth).collect())
            .int("stable", "", "number of stable states", all.iter().map(|c| c.stable as i64).collect())
            .text("verdict", "whether the stable states balance", all.iter().map(|c| c.word().into()).collect())
            .float(
                "worst",
                "",
                "largest unbalance of a stable state over that without the masses; NaN where none is stable",
                all.iter().map(|c| c.share).collect(),
            )
            .build()
    }

    fn boundary(&self, chart: &Chart) -> Result<Table, OutcomeError> {
        let all = &chart.edges;
        Table::new(
            "boundary",
            "Boundary of the balanced state: begin, end or change of stability, located along the speed and between the values",
        )
        .float("speed", "rad/s", "spin speed", all.iter().map(|e| e.speed).collect())
        .float(chart.path.clone(), unit_of(self.system, &chart.path), "parameter", all.iter().map(|e| e.value).collect())
        .text(
            "edge",
            "limit of existence: the state vanishes or meets its mirror image; half of the unbalance left: it goes on and leaves more; stability changes",
            all.iter().map(|e| e.kind.words().into()).collect(),
        )
        .float(
            "frequency",
            "rad/s",
            "frequency of the root that crosses, in turning axes; NaN where none was located, as at limits of existence and for continua",
            all.iter().map(|e| e.frequency).collect(),
        )
        .build()
    }

    fn costs(&self, e: &Errors, k: usize) -> Result<Table, OutcomeError> {
        let path = &e.requested.path;
        let parameter = parameter_name(path);
        let doc = Message::new("stationary-table-errors").arg("speed", Arg::speed(e.requested.speed)).arg("parameter", parameter.clone());
        let column = |f: &dyn Fn(&super::errors::Cost) -> f64| e.costs.iter().map(f).collect::<Vec<f64>>();
        Table::new(format!("errors_{}", k + 1), doc)
            .float("value", unit_of(self.system, path), parameter, column(&|c| c.value))
            .int("stable", "", "number of stable states", e.costs.iter().map(|c| c.stable as i64).collect())
            .flag("balances", "one of them balances", e.costs.iter().map(|c| c.balances).collect())
            .float("unbalance_least", "kg m", "left by the best stable state; NaN where none is stable", column(&|c| c.unbalance.0))
            .float("unbalance_largest", "kg m", "left by the worst stable state; NaN where none is stable", column(&|c| c.unbalance.1))
            .float("without", "kg m", "unbalance without the masses; NaN where no state was found", column(&|c| c.without))
            .float("grade", "m/s", "grade number of the best (ISO 21940-11); NaN where none is stable", column(&|c| c.grade))
            .float(
                "radius_least",
                "m",
                "least of the largest distance of a point of a body; NaN where none is stable",
                column(&|c| c.radius.0),
            )
            .float("radius_largest", "m", "largest distance of a point of a body; NaN where none is stable", column(&|c| c.radius.1))
            .build()
    }
}

/// Distance in typical sizes within which a branch point of one branch is that of another.
const ONE: f64 = 1e-4;

/// The special points, those at which branches cross each other once, with the branches.
pub(super) fn places(found: &Found, search: &Search) -> Vec<Vec<(usize, usize)>> {
    let at = |(k, i): (usize, usize)| &found.paths[k].special[i];
    let mut out: Vec<Vec<(usize, usize)>> = Vec::new();
    for place in found.paths.iter().enumerate().flat_map(|(k, p)| (0..p.special.len()).map(move |i| (k, i))) {
        let l = at(place);
        let known = |known: &&mut Vec<(usize, usize)>| {
            let o = at(known[0]);
            let widest = [o, l].iter().map(|l| l.bracket.1 - l.bracket.0).fold(1e-9 * o.state.speed.abs(), f64::max);
            o.change == Change::BranchPoint
                && l.change == Change::BranchPoint
                && (o.state.speed - l.state.speed).abs() <= widest
                && found.images.distance(&o.state.x, &l.state.x, search.scale()) <= ONE
        };
        match out.iter_mut().find(known) {
            Some(known) => known.push(place),
            None => out.push(vec![place]),
        }
    }
    // the best known first
    let width = |p: &(usize, usize)| at(*p).bracket.1 - at(*p).bracket.0;
    out.iter_mut().for_each(|all| all.sort_by_number(|a| width(a)));
    out
}

fn special_point(place: &[(usize, &Located)]) -> SpecialPoint {
    let l = place[0].1;
    let status = if l.located { Status::Located } else { Status::Bracketed };
    let mut branches: Vec<usize> = place.iter().map(|p| p.0 + 1).collect();
    branches.sort_unstable();
    branches.dedup();
    let names = branches.iter().map(ToString::to_string).collect::<Vec<_>>();
    let subject = match names.split_last() {
        Some((last, [])) => format!("branch {last}"),
        Some((last, others)) => format!("branches {} and {last}", others.join(", ")),
        None => String::new(),
    };
    let point = SpecialPoint::new(l.change.word(), l.state.speed, l.bracket).of(subject).status(status);
    // a root that was not located has no frequency
    let point = if l.frequency.is_finite() { point.evidence("frequency in turning axes", l.frequency, "rad/s") } else { point };
    place.iter().fold(point, |point, (k, l)| {
        let roots = |side: &'static str| {
            let several = Arg::word(if branches.len() > 1 { "yes" } else { "no" });
            Message::new("stationary-growing-roots").arg("side", Arg::word(side)).arg("several", several).arg("branch", Arg::count(k + 1))
        };
        point.evidence(roots("before"), l.growing.0 as f64, "").evidence(roots("behind"), l.growing.1 as f64, "")
    })
}
