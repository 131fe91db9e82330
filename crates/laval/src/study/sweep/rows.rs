//! Rows of a sweep and their columns.

use super::super::settled::measure::{HIGHEST, LINES, ORDERS, POINTS};
use super::super::settled::period::Verdict;
use super::super::settled::{Settled, measure::BodyMeasure};
use super::lyapunov::Exponent;
use super::{Carried, Fleet, Sweep, Way};
use crate::store::{Cells, Column, Kind};

/// One motion.
pub(super) struct Row {
    pub way: Way,
    pub speed: f64,
    pub rate: Option<f64>,
    pub settled: Settled,
    pub exponent: Option<Exponent>,
}

type Read<T> = Box<dyn Fn(&Row) -> T>;

enum Of {
    Number(Read<f64>),
    Count(Read<Option<i64>>),
    Word(Read<Option<String>>),
}

/// A column, and how it is read off a row.
pub(super) struct RowColumn {
    pub column: Column,
    of: Of,
}

/// Beginning of the names of the columns that hold the state at the end.
pub(super) const STATE: &str = "state.";

fn number(name: impl Into<String>, unit: &str, doc: &str, of: impl Fn(&Row) -> f64 + 'static) -> RowColumn {
    RowColumn { column: Column::float(name, unit, doc), of: Of::Number(Box::new(of)) }
}

fn count(name: &str, doc: &str, of: impl Fn(&Row) -> Option<i64> + 'static) -> RowColumn {
    RowColumn { column: Column::int(name, "", doc), of: Of::Count(Box::new(of)) }
}

fn word(name: &str, doc: &str, of: impl Fn(&Row) -> Option<String> + 'static) -> RowColumn {
    RowColumn { column: Column::text(name, doc), of: Of::Word(Box::new(of)) }
}

fn body(name: impl Into<String>, b: usize, doc: &str, of: impl Fn(&BodyMeasure) -> f64 + 'static) -> RowColumn {
    number(name, "m", doc, move |r| r.settled.measure.as_ref().map_or(f64::NAN, |m| of(&m.bodies[b])))
}

/// The columns.
pub(super) fn columns(study: &Sweep, fleet: &Fleet) -> Vec<RowColumn> {
    let whole = |x: u64| i64::try_from(x).ok();
    let mut out = vec![
        word("start", "how the motion began", |r| Some(r.way.word().into())),
        number("speed", "rad/s", "spin speed", |r| r.speed),
        word("motion", "periodic, not periodic, not settled or failed", |r| Some(r.settled.verdict.word().into())),
        count("period", "forcing periods after which the motion repeats", |r| {
            if let Verdict::Period(k) = r.settled.verdict { i64::try_from(k).ok() } else { None }
        }),
        number("remaining", "", "estimated distance from the settled motion over its size", |r| r.settled.remaining),
        number("decay", "1/s", "decay rate of the slowest mode at rest", |r| r.rate.unwrap_or(f64::NAN)),
        count("periods", "forcing periods integrated", move |r| whole(r.settled.periods)),
        count("bounded", "1 where the largest number of periods cut the settling short", |r| Some(i64::from(r.settled.bounded))),
        count("steps", "integration steps", move |r| whole(r.settled.steps)),
        word("failure", "why there is no motion", |r| if let Verdict::Failed(why) = r.settled.verdict { Some(why.into()) } else { None }),
    ];
    if study.rules.shooting {
        let shot = |r: &Row| r.settled.shot.unwrap_or((f64::NAN, f64::NAN));
        out.push(number("residual", "", "last correction of shooting over the size of the motion", move |r| shot(r).0));
        out.push(number("multiplier", "", "largest modulus of the multipliers of the motion", move |r| shot(r).1));
    }
    let validity = |r: &Row| r.settled.measure.as_ref().and_then(|m| m.validity.clone());
    out.push(number("validity", "", "largest use of a part's validity; above 1 is outside", move |r| {
        validity(r).map_or(f64::NAN, |v| if v.1.is_nan() { f64::INFINITY } else { v.1 })
    }));
    out.push(word("limit", "the statement of validity used most", move |r| validity(r).map(|v| v.0)));
    for (b, own) in fleet.bodies.iter().enumerate() {
        let n = &own.name;
        out.push(body(format!("amplitude.{n}"), b, "largest displacement", |m| m.peak));
        out.push(body(format!("rms.{n}"), b, "root of the mean squared displacement", |m| m.rms));
        for h in 0..ORDERS {
            let doc = if h == 0 { "mean displacement" } else { "semi-major axis of the motion of this order" };
            out.push(body(format!("order_{h}.{n}"), b, doc, move |m| m.orders[h]));
        }
        out.push(body(format!("subharmonic.{n}"), b, "semi-major axis at order 1/period of a motion of period above 1", |m| m.sub));
    }
    if study.lyapunov.is_some() {
        let of = |r: &Row| r.exponent.unwrap_or((f64::NAN, f64::NAN));
        out.push(number("lyapunov", "1/s", "largest Lyapunov exponent", move |r| of(r).0));
        out.push(number("lyapunov_halves", "1/s", "difference of the exponent between the halves of its time", move |r| of(r).1));
    }
    let column = 2 * study.section.0 + study.section.1;
    for p in 0..POINTS {
        out.push(number(point(p), "m", "displacement at phase zero, oldest first", move |r| {
            r.settled.measure.as_ref().and_then(|m| m.points.get(p)).map_or(f64::NAN, |x| x[column])
        }));
    }
    if study.waterfall.is_some() {
        for line in 0..=LINES * HIGHEST {
            let doc = "semi-major axis at this order";
            out.push(number(spectrum(line), "m", doc, move |r| {
                r.settled.measure.as_ref().and_then(|m| m.spectrum.get(line)).copied().unwrap_or(f64::NAN)
            }));
        }
    }
    let system = &fleet.system;
    let rate = |unit: &str| if unit.is_empty() { "1/s".to_string() } else { format!("{unit}/s") };
    let coordinates = system.coordinates().iter().map(|c| (c.name.clone(), c.dof.unit.to_string()));
    let rates = system.coordinates().iter().map(|c| (format!("{}'", c.name), rate(c.dof.unit)));
    let states = system.states().iter().map(|c| (c.name.clone(), c.dof.unit.to_string()));
    for (i, (name, unit)) in coordinates.chain(rates).chain(states).enumerate() {
        out.push(number(format!("{STATE}{name}"), &unit, "state at the end, at phase zero", move |r| {
            r.settled.y.get(i).copied().unwrap_or(f64::NAN)
        }));
    }
    out
}

/// Name of the column of a Poincare point.
pub(super) fn point(p: usize) -> String {
    format!("point_{p}")
}

/// Name of the column of a line of the spectrum.
pub(super) fn spectrum(line: usize) -> String {
    format!("spectrum_{line}")
}

/// Cells of a chunk.
pub(super) fn cells(columns: &[RowColumn], rows: &[Row]) -> Vec<Cells> {
    let one = |c: &RowColumn| match &c.of {
        Of::Number(f) => Cells::Float(rows.iter().map(f).collect()),
        Of::Count(f) => Cells::Int(rows.iter().map(f).collect()),
        Of::Word(f) => Cells::Text(rows.iter().map(f).collect()),
    };
    columns.iter().map(one).collect()
}

/// The states at the end of a chunk, for each way; none where a motion failed.
pub(super) fn states(columns: &[RowColumn], cells: &[Cells], ways: usize) -> Carried {
    let own: Vec<&Cells> =
        columns.iter().zip(cells).filter(|(c, _)| c.column.kind == Kind::Float && c.column.name.starts_with(STATE)).map(|x| x.1).collect();
    let rows = cells.first().map_or(0, Cells::len);
    let last = |w: usize| {
        let y: Vec<f64> = own.iter().map(|c| c.number(rows.saturating_sub(ways) + w)).collect();
        y.iter().all(|x| x.is_finite()).then_some(y)
    };
    (0..ways).map(last).collect()
}
