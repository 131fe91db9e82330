//! Columns of rows that hold a settled motion.

use super::measure::BodyMeasure;
use super::period::Verdict;
use super::{Rules, SteadyState};
use crate::model::probe::Probe;
use crate::model::system::System;
use crate::store::{Cells, Column};
use crate::study::shared::probes;

/// A row of a study that settles motions.
pub trait Row {
    fn steady_state(&self) -> &SteadyState;
}

type Read<R, T> = Box<dyn Fn(&R) -> T>;

enum Of<R> {
    Number(Read<R, f64>),
    Count(Read<R, Option<i64>>),
    Word(Read<R, Option<String>>),
}

/// A column, and how it is read off a row.
pub struct RowColumn<R> {
    pub column: Column,
    of: Of<R>,
}

pub fn number<R>(name: impl Into<String>, unit: &str, doc: &str, of: impl Fn(&R) -> f64 + 'static) -> RowColumn<R> {
    RowColumn { column: Column::float(name, unit, doc), of: Of::Number(Box::new(of)) }
}

pub fn count<R>(name: &str, doc: &str, of: impl Fn(&R) -> Option<i64> + 'static) -> RowColumn<R> {
    RowColumn { column: Column::int(name, "", doc), of: Of::Count(Box::new(of)) }
}

pub fn word<R>(name: &str, doc: &str, of: impl Fn(&R) -> Option<String> + 'static) -> RowColumn<R> {
    RowColumn { column: Column::text(name, doc), of: Of::Word(Box::new(of)) }
}

/// A measure of a body; NaN where there is no motion.
pub fn body<R: Row>(name: impl Into<String>, b: usize, doc: &str, of: impl Fn(&BodyMeasure) -> f64 + 'static) -> RowColumn<R> {
    number(name, "m", doc, move |r: &R| r.steady_state().measure.as_ref().map_or(f64::NAN, |m| of(&m.bodies[b])))
}

/// The largest displacements of points beside the reference points of bodies, and the largest tilts.
pub fn others<R: Row>(system: &System) -> Vec<RowColumn<R>> {
    let of = |(k, probe): (usize, Probe)| {
        let doc = if probe.is_tilt() { "largest tilt" } else { "largest displacement" };
        number(probes::column(&probe), probe.unit(), doc, move |r: &R| {
            r.steady_state().measure.as_ref().map_or(f64::NAN, |m| m.bodies[k].peak)
        })
    };
    probes::all(system).into_iter().enumerate().filter(|p| !p.1.is_reference()).map(of).collect()
}

/// How the motion was assessed, what that took, and where it leaves the model of a part.
pub fn verdict_columns<R: Row>(rules: &Rules) -> Vec<RowColumn<R>> {
    let whole = |x: u64| i64::try_from(x).ok();
    let mut out: Vec<RowColumn<R>> = vec![
        word("motion", "periodic, not periodic, not settled or failed", |r: &R| Some(r.steady_state().verdict.word().into())),
        count("period", "forcing periods after which the motion repeats", |r: &R| {
            if let Verdict::Period(k) = r.steady_state().verdict { i64::try_from(k).ok() } else { None }
        }),
        number("remaining", "", "estimated distance from the settled motion over its size", |r: &R| r.steady_state().remaining),
        count("periods", "forcing periods integrated", move |r: &R| whole(r.steady_state().periods)),
        count("bounded", "1 where the largest number of periods cut the settling short", |r: &R| Some(i64::from(r.steady_state().bounded))),
        count("steps", "integration steps", move |r: &R| whole(r.steady_state().steps)),
        word("failure", "why there is no motion", |r: &R| {
            if let Verdict::Failed(why) = r.steady_state().verdict { Some(why.into()) } else { None }
        }),
    ];
    if rules.shooting {
        let shot = |r: &R| r.steady_state().shot.unwrap_or((f64::NAN, f64::NAN));
        out.push(number("residual", "", "last correction of shooting over the size of the motion", move |r: &R| shot(r).0));
        out.push(number("multiplier", "", "largest modulus of the multipliers of the motion", move |r: &R| shot(r).1));
    }
    let validity = |r: &R| r.steady_state().measure.as_ref().and_then(|m| m.validity.clone());
    out.push(number("validity", "", "largest use of a part's validity; above 1 is outside", move |r: &R| {
        validity(r).map_or(f64::NAN, |v| if v.1.is_nan() { f64::INFINITY } else { v.1 })
    }));
    out.push(word("limit", "the statement of validity used most", move |r: &R| validity(r).map(|v| v.0)));
    out
}

/// Cells of a chunk.
pub fn cells<R>(columns: &[RowColumn<R>], rows: &[R]) -> Vec<Cells> {
    let one = |c: &RowColumn<R>| match &c.of {
        Of::Number(f) => Cells::Float(rows.iter().map(f).collect()),
        Of::Count(f) => Cells::Int(rows.iter().map(f).collect()),
        Of::Word(f) => Cells::Text(rows.iter().map(f).collect()),
    };
    columns.iter().map(one).collect()
}
