//! Findings, tables and bars.

use super::Sensitivity;
use super::places::{Derivatives, Kind, Place, Without};
use crate::diagnostic::Diagnostic;
use crate::outcome::{
    Arg, Axis, Band, End, Figure, Finding, Message, Outcome, Panel, Rule, SpecialPoint, Table, parameter_name, significant,
};
use crate::study::Study;
use crate::study::shared::probes;
use crate::study::shared::support::{inconsistent, probe_name};
use laval_num::order::SortByNumber;

/// A relative change per unit of a parameter of zero that is rounding.
const NOTHING: f64 = 1e-9;
/// Figures at most: jumps and the highest peaks.
const FIGURES: usize = 6;

impl Place {
    fn name(&self) -> String {
        let speed = significant(self.moved.speed, 5);
        match self.kind {
            Kind::Peak if self.probe.is_tilt() => format!("peak of the tilt of {} at {speed} rad/s", self.probe.name),
            Kind::Peak => format!("peak of {} at {speed} rad/s", probe_name(&self.probe)),
            Kind::JumpUp => format!("jump up at {speed} rad/s"),
            Kind::JumpDown => format!("jump down at {speed} rad/s"),
        }
    }

    /// The same as a phrase.
    fn phrase(&self) -> Message {
        let at = |key: &str| Message::new(key).arg("speed", Arg::speed(self.moved.speed).digits(5));
        match self.kind {
            Kind::Peak => at("sensitivity-place-peak").arg("point", probes::arg(&self.probe)),
            Kind::JumpUp => at("sensitivity-place-jump").arg("way", Arg::word("up")),
            Kind::JumpDown => at("sensitivity-place-jump").arg("way", Arg::word("down")),
        }
    }

    fn word(&self) -> &'static str {
        match self.kind {
            Kind::Peak => "peak",
            Kind::JumpUp => "jump up",
            Kind::JumpDown => "jump down",
        }
    }

    /// Relative influence of every parameter: on the speed, on the displacement.
    fn relative(&self, found: &Derivatives) -> Vec<[f64; 2]> {
        let m = &self.moved;
        found.parameters.iter().zip(&m.slopes).map(|(p, s)| [s.speed * p.value / m.speed, s.value * p.value / m.value]).collect()
    }

    /// The parameter moves the place by more than rounding does.
    fn acts(&self, found: &Derivatives, k: usize) -> bool {
        let (p, m) = (&found.parameters[k], &self.moved);
        // of what is zero, as an angle, one unit counts
        let least = if p.value == 0.0 { NOTHING } else { 0.0 };
        let share = |slope: f64, of: f64| (slope / of).abs();
        !(share(m.slopes[k].speed, m.speed) <= least && share(m.slopes[k].value, m.value) <= least)
    }

    /// Parameters by falling influence; those without any are left out.
    fn order(&self, found: &Derivatives) -> Vec<usize> {
        let relative = self.relative(found);
        // what is unknown comes last
        let size = |&k: &usize| if relative[k].iter().any(|r| r.is_nan()) { -1.0 } else { relative[k][0].abs().max(relative[k][1].abs()) };
        let acts = |&k: &usize| self.acts(found, k);
        let mut order: Vec<usize> = (0..relative.len()).filter(acts).collect();
        order.sort_by_number_down(|a| size(a));
        order
    }
}

impl Derivatives {
    /// Some place is one of a tilt.
    fn tilts(&self) -> bool {
        self.places.iter().any(|p| p.probe.is_tilt())
    }
}

/// The parameter of most influence on the speed (0) or size (1) of a place, and how much that changes for one per cent more of it.
fn influence(place: &Place, found: &Derivatives, which: usize) -> Message {
    let relative = place.relative(found);
    let known = (0..relative.len()).filter(|&k| relative[k][which].is_finite());
    match known.max_by(|&a, &b| relative[a][which].abs().total_cmp(&relative[b][which].abs())) {
        Some(k) => {
            let x = relative[k][which];
            Message::new("sensitivity-influence")
                .arg("parameter", Arg::name(&found.parameters[k].path))
                .arg("direction", Arg::word(if x < 0.0 { "falls" } else { "rises" }))
                .arg("change", Arg::percent(0.01 * x.abs()))
        }
        None => Message::new("sensitivity-influence-unknown"),
    }
}

fn finding(place: &Place, found: &Derivatives) -> Finding {
    let m = &place.moved;
    let key = match place.kind {
        Kind::Peak => "sensitivity-peak",
        Kind::JumpUp | Kind::JumpDown => "sensitivity-jump",
    };
    Finding::info(place.word().replace(' ', "_"), key)
        .of(probe_name(&place.probe))
        .value(m.value, place.probe.unit())
        .arg("way", Arg::word(if place.kind == Kind::JumpDown { "down" } else { "up" }))
        .arg("point", probes::arg(&place.probe))
        .arg("quality", Arg::word(probes::quality(&place.probe)))
        .arg("speed", Arg::speed(m.speed))
        .arg("size-influence", influence(place, found, 1))
        .arg("speed-influence", influence(place, found, 0))
        .evidence("relative change of the second derivatives at the last narrowing of the step", m.settled, "")
        .evidence("relative slope left along the branch", m.slope_left, "")
        .evidence("speed", m.speed, "rad/s")
}

/// Everything a reader gets.
pub(super) fn report(found: &Derivatives, end: End, bars: usize, name: &str) -> Result<Outcome, Diagnostic> {
    let mut out = Outcome::new(Sensitivity::KIND, name).over("speed", "rad/s").end(end);
    for p in &found.places {
        out = out.finding(finding(p, found));
        let at = p.moved.speed;
        out = out.special_point(SpecialPoint::new(p.word(), at, (at, at)).of(probe_name(&p.probe)).evidence(
            probes::quality(&p.probe),
            p.moved.value,
            p.probe.unit(),
        ));
    }
    let mut reasons: Vec<(&Without, Vec<f64>)> = Vec::new();
    for (speed, why) in &found.without {
        match reasons.iter_mut().find(|r| r.0 == why) {
            Some(r) => r.1.push(*speed),
            None => reasons.push((why, vec![*speed])),
        }
    }
    for (why, speeds) in reasons {
        let finding = match why {
            Without::Corner => Finding::warning("no_derivative", "sensitivity-no-derivative-corner"),
            Without::Jump(part) => Finding::warning("no_derivative", "sensitivity-no-derivative-jump").arg("part", Arg::name(part)),
            Without::Unconverged => Finding::warning("no_derivative", "sensitivity-no-derivative-open"),
        };
        let highest = speeds.iter().fold(0.0, |m: f64, s| m.max(s.abs()));
        let finding = finding.value(speeds[0], "rad/s").arg("more", Arg::count(speeds.len() - 1)).arg("highest", Arg::speed(highest));
        out = out.finding(finding);
    }
    let unknown = |k: &usize| found.places.iter().any(|p| p.relative(found)[*k].iter().any(|r| !r.is_finite()));
    let unknown: Vec<&str> = (0..found.parameters.len()).filter(unknown).map(|k| found.parameters[k].path.as_str()).collect();
    if !unknown.is_empty() {
        out = out.finding(Finding::warning("no_influence", "sensitivity-no-influence").arg("parameters", Arg::names(unknown)));
    }
    if found.places.is_empty() {
        let ended = if end == End::Reached { "complete" } else { "stopped" };
        out = out.finding(Finding::info("nothing_stationary", "sensitivity-nothing-stationary").arg("end", Arg::word(ended)));
        return out.checked().map_err(inconsistent);
    }
    let idle: Vec<&str> = (0..found.parameters.len())
        .filter(|&k| !found.places.iter().any(|p| p.acts(found, k)))
        .map(|k| found.parameters[k].path.as_str())
        .collect();
    if !idle.is_empty() {
        out = out.finding(Finding::info("without_influence", "sensitivity-without-influence").arg("parameters", Arg::names(idle)));
    }
    out = out.table(places(found)?).table(sensitivities(found)?);
    let mut drawn: Vec<usize> = (0..found.places.len()).collect();
    let size = |p: &Place| p.moved.value / p.probe.typical();
    let rank = |&i: &usize| (found.places[i].kind == Kind::Peak, -size(&found.places[i]));
    drawn.sort_by(|a, b| rank(a).0.cmp(&rank(b).0).then(rank(a).1.total_cmp(&rank(b).1)));
    drawn.truncate(FIGURES);
    drawn.sort_unstable();
    for i in drawn {
        out = tornado(out, found, i, bars)?;
    }
    out.work("places", found.places.len() as u64).work("parameters", found.parameters.len() as u64).checked().map_err(inconsistent)
}

fn places(found: &Derivatives) -> Result<Table, Diagnostic> {
    let all = &found.places;
    let float = |f: &dyn Fn(&Place) -> f64| all.iter().map(f).collect::<Vec<f64>>();
    let size = |tilt: bool| float(&|p| if p.probe.is_tilt() == tilt { p.moved.value } else { f64::NAN });
    let mut table = Table::new("places", "Peaks and folds of the steady response")
        .int("place", "", "number of the place", (1..=all.len() as i64).collect())
        .text(
            "kind",
            "peak of a displacement or tilt, or fold where a slow sweep jumps",
            all.iter().map(|p| p.word().to_string()).collect(),
        )
        .names("body", "body, point of a body, or tilt of a body", all.iter().map(|p| probe_name(&p.probe)).collect())
        .int("branch", "", "number of the branch", all.iter().map(|p| p.branch as i64 + 1).collect())
        .float("speed", "rad/s", "spin speed", float(&|p| p.moved.speed))
        .float("displacement", "m", "largest over a period; NaN of a tilt", size(false));
    if found.tilts() {
        table = table.float("tilt", "rad", "largest over a period; NaN of a displacement", size(true));
    }
    table
        .float("settled", "", "relative change of the second derivatives at the last narrowing of the step", float(&|p| p.moved.settled))
        .float("slope left", "", "relative slope left along the branch", float(&|p| p.moved.slope_left))
        .int("orders", "", "orders kept", vec![found.harmonics as i64; all.len()])
        .build()
        .map_err(inconsistent)
}

/// Index of a place and of a parameter, and its relative influence on speed and displacement.
type Row = (usize, usize, [f64; 2]);

fn sensitivities(found: &Derivatives) -> Result<Table, Diagnostic> {
    let rows: Vec<Row> = found
        .places
        .iter()
        .enumerate()
        .flat_map(|(i, p)| {
            let relative = p.relative(found);
            p.order(found).into_iter().map(move |k| (i, k, relative[k]))
        })
        .collect();
    let of = |r: &Row| (&found.places[r.0], &found.parameters[r.1], found.places[r.0].moved.slopes[r.1]);
    let text = |f: &dyn Fn(&Row) -> String| rows.iter().map(f).collect::<Vec<String>>();
    let float = |f: &dyn Fn(&Row) -> f64| rows.iter().map(f).collect::<Vec<f64>>();
    let size = |tilt: bool, f: &dyn Fn(&Row) -> f64| float(&|r| if of(r).0.probe.is_tilt() == tilt { f(r) } else { f64::NAN });
    let table = Table::new("sensitivities", "Derivatives of every place in every parameter, by falling relative influence")
        .int("place", "", "number of the place", rows.iter().map(|r| r.0 as i64 + 1).collect())
        .phrases("what", "the place", rows.iter().map(|r| (of(r).0.name(), of(r).0.phrase().into())).collect())
        .names("parameter", "path; both halves of a lateral pair together where it has no .x", text(&|r| of(r).1.path.clone()))
        .float("value", "", "of the parameter, in its unit", float(&|r| of(r).1.value))
        .names("unit", "of the parameter", text(&|r| of(r).1.unit.to_string()))
        .float("speed slope", "", "d speed / d parameter, rad/s per unit of the parameter", float(&|r| of(r).2.speed))
        .float(
            "displacement slope",
            "",
            "d displacement / d parameter, m per unit of the parameter; NaN of a tilt",
            size(false, &|r| of(r).2.value),
        )
        .float("influence on speed", "", "relative change of the speed over that of the parameter", float(&|r| r.2[0]))
        .float(
            "influence on displacement",
            "",
            "relative change of the displacement over that of the parameter; NaN of a tilt",
            size(false, &|r| r.2[1]),
        );
    let table = if found.tilts() {
        let slope = "d tilt / d parameter, rad per unit of the parameter; NaN of a displacement";
        let influence = "relative change of the tilt over that of the parameter; NaN of a displacement";
        table.float("tilt slope", "", slope, size(true, &|r| of(r).2.value)).float(
            "influence on tilt",
            "",
            influence,
            size(true, &|r| r.2[1]),
        )
    } else {
        table
    };
    table.build().map_err(inconsistent)
}

/// Horizontal bars, the parameter of most influence on top.
fn tornado(mut out: Outcome, found: &Derivatives, i: usize, bars: usize) -> Result<Outcome, Diagnostic> {
    let place = &found.places[i];
    let relative = place.relative(found);
    let shown: Vec<usize> = place
        .order(found)
        .into_iter()
        .filter(|&k| relative[k] != [0.0; 2] && relative[k].iter().all(|r| r.is_finite()))
        .take(bars)
        .collect();
    if shown.is_empty() {
        return Ok(out);
    }
    let count = shown.len();
    let names = shown.iter().enumerate().map(|(row, &k)| ((count - row) as f64, parameter_name(&found.parameters[k].path))).collect();
    let mut panel = Panel::new(Axis::new("parameter", "").range(0.4, count as f64 + 0.6).names(names));
    for (side, name) in [(1, probes::quality(&place.probe)), (0, "speed")] {
        let (mut x, mut low, mut high) = (Vec::new(), Vec::new(), Vec::new());
        for (row, &k) in shown.iter().enumerate() {
            let top = (count - row) as f64 + if side == 1 { 0.4 } else { 0.0 };
            x.extend([0.0, relative[k][side], f64::NAN]);
            low.extend([top - 0.4; 3]);
            high.extend([top; 3]);
        }
        let table = format!("bars {} {name}", i + 1);
        let doc = Message::new("sensitivity-table-bars").arg("quality", Arg::word(name)).arg("place", place.phrase());
        let shape = Table::new(&table, doc)
            .float("x", "", "foot and end of a bar; NaN between bars", x)
            .float("low", "", "lower side", low)
            .float("high", "", "upper side", high)
            .build()
            .map_err(inconsistent)?;
        let band = Band::between(&table, "x", "low", "high").name(name).bar();
        panel = panel.mark(if side == 1 { band.neutral() } else { band.good() });
        out = out.table(shape);
    }
    let title = Message::new("sensitivity-title").arg("place", place.phrase());
    let alt = Message::new("sensitivity-alt").arg("count", Arg::count(count));
    let figure = Figure::new(format!("influence-{}", i + 1), title, alt)
        .x(Axis::new("change in per cent for one per cent more of the parameter", ""));
    Ok(out.figure(figure.panel(panel.mark(Rule::x(0.0, "")))))
}
