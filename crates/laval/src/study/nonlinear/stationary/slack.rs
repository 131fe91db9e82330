//! What dry friction leaves of the unbalance where three and more masses balance in a continuum of ways.
//!
//! From stable samples of the continuum the masses are moved along straight ways until friction gives way; the largest unbalance met counts. More may be left
//! at places that no way leads to: what is reported is met, not a bound.

use super::continua::Sheet;
use super::report::column_of;
use super::zones::most_left;
use crate::model::system::System;
use crate::outcome::{Arg, Finding, Message, OutcomeError, Table};
use crate::solve::stationary::{Search, State};
use crate::study::shared::support::larger;
use serde::{Deserialize, Serialize};

/// Samples of a continuum from which ways are gone.
const SAMPLES: usize = 6;

/// A mass that is held where most is left.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Mass {
    /// Its coordinate.
    coordinate: usize,
    /// The largest torque that friction holds, N m.
    friction: f64,
    /// Where it is, rad.
    angle: f64,
}

/// What was met about one continuum at one speed.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Left {
    /// Of the continua, from 0.
    pub sheet: usize,
    /// Masses held.
    pub held: Vec<Mass>,
    /// Friction gave way on all ways.
    pub closed: bool,
    /// Ways gone.
    pub ways: usize,
    /// Largest unbalance met, kg m, its grade number, m/s, and the unbalance without the masses, kg m; NaN where nothing balances.
    pub unbalance: f64,
    pub grade: f64,
    pub without: f64,
}

/// About the continua of which some states are stable.
pub fn slack(system: &System, search: &mut Search, sheets: &[Sheet], goes_on: &mut dyn FnMut(u64) -> bool) -> Vec<Left> {
    let mut out = Vec::new();
    for (sheet, s) in sheets.iter().enumerate().filter(|(_, s)| !s.places.is_empty()) {
        let mut here = Left { sheet, held: Vec::new(), closed: true, ways: 0, unbalance: f64::NAN, grade: f64::NAN, without: f64::NAN };
        for (tried, x) in s.places.iter().take(SAMPLES).enumerate() {
            let state = State { branch: 0, speed: s.speed, x: x.clone(), error: 0.0 };
            let Some(found) = search.slack(&state, tried as u32, goes_on) else { break };
            here.ways += found.ends.len();
            here.closed &= found.closed;
            if let Some((x, u)) = most_left(system, search, &state, &found.ends)
                && !(u.moment.abs() <= here.unbalance)
            {
                (here.unbalance, here.without) = (u.moment.abs(), u.without());
                here.grade = u.grade(here.unbalance, s.speed);
                here.held = found.held.iter().map(|&(coordinate, friction)| Mass { coordinate, friction, angle: x[coordinate] }).collect();
            }
            if !goes_on(0) {
                return out;
            }
        }
        if !here.held.is_empty() {
            out.push(here);
        }
    }
    out
}

/// One line for each mass of each continuum.
pub fn table(system: &System, sheets: &[Sheet], left: &[Left]) -> Result<Table, OutcomeError> {
    let lines: Vec<(&Left, &Mass)> = left.iter().flat_map(|l| l.held.iter().map(move |h| (l, h))).collect();
    let column = |f: &dyn Fn(&Left, &Mass) -> f64| lines.iter().map(|l| f(l.0, l.1)).collect::<Vec<f64>>();
    Table::new("dead_zone_continua", "The most unbalance met that dry friction holds about states of a continuum")
        .float("speed", "rad/s", "spin speed", column(&|l, _| sheets[l.sheet].speed))
        .text(
            "kind",
            "what kind of states they are without friction",
            lines.iter().map(|l| sheets[l.0.sheet].class.word().into()).collect(),
        )
        .names("mass", "which mass", lines.iter().map(|l| column_of(system, l.1.coordinate)).collect())
        .float("friction", "N m", "largest torque that friction holds", column(&|_, h| h.friction))
        .float("angle", "rad", "where it is held and most unbalance is left, not wrapped", column(&|_, h| h.angle))
        .flag("closed", "friction gave way on all ways; else it holds the masses farther on", lines.iter().map(|l| l.0.closed).collect())
        .int("ways", "", "ways that were gone", lines.iter().map(|l| l.0.ways as i64).collect())
        .float("unbalance", "kg m", "largest met; NaN where nothing balances", column(&|l, _| l.unbalance))
        .float("grade", "m/s", "grade number there (ISO 21940-11); NaN as above", column(&|l, _| l.grade))
        .build()
}

/// What friction leaves at the speed nearest to the one meant.
pub fn finding(sheets: &[Sheet], left: &[Left], operating: f64) -> Option<Finding> {
    let off = |l: &&Left| (sheets[l.sheet].speed - operating).abs();
    let balancing = left.iter().filter(|l| sheets[l.sheet].class.balances() && l.unbalance.is_finite());
    let nearest = balancing.min_by(|a, b| off(a).total_cmp(&off(b)))?;
    let sheet = &sheets[nearest.sheet];
    let make = if nearest.unbalance <= 0.5 * nearest.without { Finding::info } else { Finding::warning };
    let friction = nearest.held.iter().map(|h| h.friction).fold(0.0, larger);
    Some(
        make("dead_zone", "stationary-dead-zone-continuum")
            .of("continuum")
            .value(nearest.unbalance, "kg m")
            .arg("speed", Arg::speed(sheet.speed))
            .arg("continuum", Message::new("stationary-continuum-of").arg("kind", Arg::word(sheet.class.word())))
            .evidence("without the masses", nearest.without, "kg m")
            .evidence("friction", friction, "N m")
            .evidence("grade number (ISO 21940-11)", nearest.grade, "m/s")
            .evidence("ways gone", nearest.ways as f64, "")
            .evidence("speed", sheet.speed, "rad/s"),
    )
}
