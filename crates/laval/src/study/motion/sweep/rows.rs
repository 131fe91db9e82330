//! Rows of a sweep and their columns.

use super::super::start::state_names;
use super::super::steady_state::SteadyState;
use super::super::steady_state::columns::{self, RowColumn, body, number, word};
use super::super::steady_state::measure::{HIGHEST, LINES, ORDERS, POINTS};
use super::super::steady_state::period::Verdict;
use super::lyapunov::Exponent;
use super::refine::{Followed, about_mean};
use super::{Carried, Members, Sweep, Way};
use crate::model::probe::Probe;
use crate::store::{Cells, Kind};
use crate::study::shared::probes;

/// One motion.
pub(super) struct Row {
    pub way: Way,
    pub speed: f64,
    pub rate: Option<f64>,
    pub steady_state: SteadyState,
    pub exponent: Option<Exponent>,
    /// Speeds between which the motion jumped on the way from the speed before, rad/s.
    pub jump: Option<(f64, f64)>,
}

impl columns::Row for Row {
    fn steady_state(&self) -> &SteadyState {
        &self.steady_state
    }
}

/// Beginning of the names of the columns that hold the state at the end.
pub(super) const STATE: &str = "state.";

/// The columns.
pub(super) fn columns(study: &Sweep, members: &Members) -> Vec<RowColumn<Row>> {
    let mut out = vec![
        word("start", "how the motion began", |r: &Row| Some(r.way.word().into())),
        number("speed", "rad/s", "spin speed", |r: &Row| r.speed),
        number("decay", "1/s", "decay rate of the slowest mode at rest", |r: &Row| r.rate.unwrap_or(f64::NAN)),
    ];
    let jump = |r: &Row| r.jump.unwrap_or((f64::NAN, f64::NAN));
    let doc = "in smaller steps from the speed before: last speed before the amplitude changes by a quarter";
    out.push(number("jump_before", "rad/s", doc, move |r: &Row| jump(r).0));
    out.push(number("jump_after", "rad/s", "first speed after that change", move |r: &Row| jump(r).1));
    out.extend(columns::verdict_columns(&study.rules));
    for (b, own) in members.stations.iter().enumerate() {
        let n = &own.name;
        out.push(body(format!("amplitude.{n}"), b, "largest displacement", |m| m.peak));
        out.push(body(format!("rms.{n}"), b, "root of the mean squared displacement", |m| m.rms));
        for h in 0..ORDERS {
            let doc = if h == 0 { "mean displacement" } else { "semi-major axis of the motion of this order" };
            out.push(body(format!("order_{h}.{n}"), b, doc, move |m| m.orders[h]));
        }
        out.push(body(format!("subharmonic.{n}"), b, "semi-major axis at order 1/period of a motion of period above 1", |m| m.sub));
    }
    out.extend(columns::others(&members.system));
    if study.lyapunov.is_some() {
        let of = |r: &Row| r.exponent.unwrap_or((f64::NAN, f64::NAN));
        out.push(number("lyapunov", "1/s", "largest Lyapunov exponent", move |r: &Row| of(r).0));
        out.push(number("lyapunov_halves", "1/s", "difference of the exponent between the halves of its time", move |r: &Row| of(r).1));
    }
    let column = 2 * study.section.0 + study.section.1;
    let unit = members.probes[study.section.0].unit();
    for p in 0..POINTS {
        out.push(number(point(p), unit, "value at phase zero, oldest first", move |r: &Row| {
            r.steady_state.measure.as_ref().and_then(|m| m.points.get(p)).map_or(f64::NAN, |x| x[column])
        }));
    }
    if study.waterfall.is_some() {
        for line in 0..=2 * LINES * HIGHEST {
            let doc = "radius of the circular part at this order, the first at the order -4";
            out.push(number(spectrum(line), "m", doc, move |r: &Row| {
                r.steady_state.measure.as_ref().and_then(|m| m.spectrum.get(line)).copied().unwrap_or(f64::NAN)
            }));
        }
    }
    let system = &members.system;
    for (i, (name, unit)) in state_names(system).into_iter().enumerate() {
        out.push(number(format!("{STATE}{name}"), &unit, "state at the end, at phase zero", move |r: &Row| {
            r.steady_state.y.get(i).copied().unwrap_or(f64::NAN)
        }));
    }
    out
}

/// Name of the column of the mean displacement of a body.
pub(super) fn mean(p: &Probe) -> String {
    format!("order_0.{}", p.name)
}

/// Name of the column of a Poincare point.
pub(super) fn point(p: usize) -> String {
    format!("point_{p}")
}

/// Name of the column of a line of the spectrum.
pub(super) fn spectrum(line: usize) -> String {
    format!("spectrum_{line}")
}

/// The motions at the end of a chunk, for each way; none where a motion failed.
pub(super) fn states(columns: &[RowColumn<Row>], cells: &[Cells], (ways, probes): (usize, &[Probe])) -> Carried {
    let own = |what: &str| -> Vec<&Cells> {
        let fits = |c: &RowColumn<Row>| c.column.kind == Kind::Float && c.column.name.starts_with(what);
        columns.iter().zip(cells).filter(|(c, _)| fits(c)).map(|x| x.1).collect()
    };
    let column = |name: &str| columns.iter().zip(cells).find(|c| c.0.column.name == name).map(|c| c.1);
    let named = |p: &Probe| {
        let mean = if p.is_reference() { column(&mean(p)) } else { None };
        column(&probes::column(p)).map(|c| (p.typical(), c, mean))
    };
    let (state, amplitude) = (own(STATE), probes.iter().filter_map(named).collect::<Vec<_>>());
    let motion = columns.iter().zip(cells).find(|(c, _)| c.column.name == "motion").map(|x| x.1);
    let rows = cells.first().map_or(0, Cells::len);
    let last = |w: usize| {
        let row = rows.saturating_sub(ways) + w;
        let y: Vec<f64> = state.iter().map(|c| c.number(row)).collect();
        let about_mean = amplitude.iter().map(|(typical, c, m)| about_mean(c.number(row), m.map_or(0.0, |m| m.number(row))) / typical);
        let about_mean = about_mean.collect();
        let amplitude = amplitude.iter().map(|(typical, c, _)| c.number(row) / typical).collect();
        let is = |verdict: Verdict| motion.and_then(|m| m.word(row)) == Some(verdict.word());
        let (wanders, repeats) = (is(Verdict::NotPeriodic), is(Verdict::Period(1)));
        y.iter().all(|x| x.is_finite()).then_some(Followed { y, amplitude, about_mean, wanders, repeats })
    };
    (0..ways).map(last).collect()
}
