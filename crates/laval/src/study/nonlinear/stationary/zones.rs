//! Ranges of states that dry friction holds: where masses stay, and what that leaves of the unbalance.

use super::Row;
use super::classify::Seen;
use super::findings::balancing;
use super::report::column_of;
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use crate::outcome::{Arg, Finding, OutcomeError, Table};
use crate::solve::stationary::{Search, State};
use crate::solve::unbalance::Unbalance;
use crate::study::shared::support::larger;
use serde::{Deserialize, Serialize};

/// A coordinate that is held.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Held {
    /// Which.
    coordinate: usize,
    /// Where it rests without friction, rad.
    rest: f64,
    /// How far below and above friction holds it, rad.
    reach: [f64; 2],
    /// The largest torque that friction holds, N m.
    friction: f64,
}

/// The range about one state of the table.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Zone {
    /// State of the table, from 0.
    pub row: usize,
    /// Coordinates that are held.
    pub held: Vec<Held>,
    /// All ends were found.
    pub closed: bool,
    /// Largest growth rate with the masses held, 1/s.
    pub growth: f64,
    /// Largest unbalance at the ends of the range, kg m, and grade number, m/s.
    pub unbalance: f64,
    pub grade: f64,
}

/// Of the states of the table.
///
/// # Errors
/// Eigenvalues that cannot be computed.
pub fn zones(system: &System, search: &mut Search, rows: &[Row], goes_on: &mut dyn FnMut(u64) -> bool) -> Result<Vec<Zone>, Diagnostic> {
    let mut out = Vec::new();
    for (row, r) in rows.iter().enumerate() {
        let Some(zone) = search.zone(&r.state, goes_on)? else { continue };
        let ends: Vec<&Vec<f64>> = zone.corners.iter().chain([&r.state.x]).collect();
        let reach = |i: usize| ends.iter().map(|x| x[i] - r.state.x[i]).fold([0.0f64; 2], |[lo, hi], d| [lo.min(d), hi.max(d)]);
        let held = zone.held.iter();
        let held = held.map(|&(i, friction)| Held { coordinate: i, rest: r.state.x[i], reach: reach(i), friction }).collect();
        let most = most_left(system, search, &r.state, ends.iter().copied());
        let unbalance = most.map_or(f64::NAN, |(_, u)| u.moment.abs());
        let grade = most.map_or(f64::NAN, |(_, u)| u.grade(unbalance, r.state.speed));
        out.push(Zone { row, held, closed: zone.closed, growth: zone.growth, unbalance, grade });
        if !goes_on(1) {
            break;
        }
    }
    Ok(out)
}

/// Of the ends of a range about a state the one with the largest unbalance; NaN counts as largest. `None` where nothing balances.
pub fn most_left<'a>(
    system: &System,
    search: &Search,
    about: &State,
    ends: impl IntoIterator<Item = &'a Vec<f64>>,
) -> Option<(&'a Vec<f64>, Unbalance)> {
    let of = |x: &Vec<f64>| Seen::of(system, search, &State { x: x.clone(), ..about.clone() }).unbalance;
    let all = ends.into_iter().filter_map(|x| Some((x, of(x)?)));
    all.reduce(|best, next| {
        let (most, own) = (best.1.moment.abs(), next.1.moment.abs());
        if own > most || own.is_nan() { next } else { best }
    })
}

/// One line for each mass of each state.
pub fn table(system: &System, rows: &[Row], zones: &[Zone]) -> Result<Table, OutcomeError> {
    let lines: Vec<(&Zone, &Held)> = zones.iter().flat_map(|z| z.held.iter().map(move |h| (z, h))).collect();
    let column = |f: &dyn Fn(&Zone, &Held) -> f64| lines.iter().map(|l| f(l.0, l.1)).collect::<Vec<f64>>();
    Table::new("dead_zone", "Ranges in which dry friction holds the masses where they are, about each state")
        .int("state", "", "number of the state", lines.iter().map(|l| l.0.row as i64 + 1).collect())
        .float("speed", "rad/s", "spin speed", column(&|z, _| rows[z.row].state.speed))
        .text("kind", "what kind of state it is without friction", lines.iter().map(|l| rows[l.0.row].class.word().into()).collect())
        .names("mass", "which mass", lines.iter().map(|l| column_of(system, l.1.coordinate)).collect())
        .float("friction", "N m", "largest torque that friction holds", column(&|_, h| h.friction))
        .float("angle", "rad", "where it rests without friction, not wrapped", column(&|_, h| h.rest))
        .float(
            "from",
            "rad",
            "lowest angle at which friction holds it, the others anywhere in their ranges",
            column(&|_, h| h.rest + h.reach[0]),
        )
        .float("to", "rad", "highest angle", column(&|_, h| h.rest + h.reach[1]))
        .flag("closed", "both ends were found; else friction holds the masses farther on", lines.iter().map(|l| l.0.closed).collect())
        .float(
            "growth_held",
            "1/s",
            "largest growth rate with the masses held; NaN where it cannot be determined",
            column(&|z, _| z.growth),
        )
        .float("unbalance", "kg m", "largest at the ends of the ranges; NaN where nothing balances", column(&|z, _| z.unbalance))
        .float("grade", "m/s", "grade number there (ISO 21940-11); NaN as above", column(&|z, _| z.grade))
        .build()
}

/// What friction leaves at the speed nearest to the one meant.
pub fn finding(rows: &[Row], zones: &[Zone], operating: f64) -> Option<Finding> {
    let off = |z: &&Zone| (rows[z.row].state.speed - operating).abs();
    let nearest = zones.iter().min_by(|a, b| off(a).total_cmp(&off(b)))?;
    let speed = rows[nearest.row].state.speed;
    let here = || zones.iter().filter(|z| rows[z.row].state.speed == speed);
    let calm = here().filter(|z| rows[z.row].stable() && rows[z.row].class.balances());
    let best = calm.min_by(|a, b| a.unbalance.total_cmp(&b.unbalance))?;
    let row = &rows[best.row];
    let without = row.seen.unbalance.map_or(f64::NAN, |u| u.without());
    if !best.closed {
        let friction = best.held.iter().map(|h| h.friction).fold(0.0, larger);
        let finding = Finding::warning("dead_zone", "stationary-dead-zone-open").value(friction, "N m");
        return Some(finding.arg("speed", Arg::speed(speed)).evidence("speed", speed, "rad/s"));
    }
    let widest = best.held.iter().map(|h| h.reach[1] - h.reach[0]).fold(0.0, larger);
    let farthest = best.held.iter().map(|h| larger(-h.reach[0], h.reach[1])).fold(0.0, larger);
    if !best.unbalance.is_finite() {
        return None;
    }
    let make = if best.unbalance <= without && !(best.growth > 0.0) { Finding::info } else { Finding::warning };
    let finding = make("dead_zone", "stationary-dead-zone")
        .value(best.unbalance, "kg m")
        .arg("speed", Arg::speed(speed))
        .arg("angle", Arg::quantity(farthest, "rad"))
        .arg("state", balancing(row.class))
        .arg("effect", Arg::word(if best.unbalance <= without { "less" } else { "more" }))
        .arg("held", Arg::word(if best.growth > 0.0 { "unstable" } else { "stable" }))
        .evidence("without the masses", without, "kg m")
        .evidence("widest range of a mass", widest, "rad")
        .evidence("grade number (ISO 21940-11)", best.grade, "m/s")
        .evidence("speed", speed, "rad/s");
    // not known for parts without a form in time
    let held = Some(best.growth).filter(|g| g.is_finite());
    Some(held.into_iter().fold(finding, |f, g| f.evidence("largest growth rate with the masses held", g, "1/s")))
}
