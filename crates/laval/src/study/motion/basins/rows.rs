//! Rows of the study and their columns.

use super::super::start::state_names;
use super::super::steady_state::SteadyState;
use super::super::steady_state::columns::{self, RowColumn, body, number};
use super::super::steady_state::period::LONGEST;
use super::{Basins, Members};

/// One motion.
pub(super) struct Row {
    /// Initial values along both axes.
    pub place: [f64; 2],
    pub steady_state: SteadyState,
}

impl columns::Row for Row {
    fn steady_state(&self) -> &SteadyState {
        &self.steady_state
    }
}

/// Names of the columns of initial values.
pub(super) const PLACE: [&str; 2] = ["x", "y"];

/// The columns.
pub(super) fn columns(study: &Basins, members: &Members) -> Vec<RowColumn<Row>> {
    let mut out: Vec<RowColumn<Row>> = Vec::new();
    for (k, axis) in study.axes.iter().enumerate() {
        out.push(number(PLACE[k], &axis.unit, &format!("initial value of {}", axis.name), move |r: &Row| r.place[k]));
    }
    out.extend(columns::verdict_columns(&study.rules));
    for (b, own) in members.bodies.iter().enumerate() {
        out.push(body(format!("amplitude.{}", own.name), b, "largest displacement", |m| m.peak));
        out.push(body(format!("rms.{}", own.name), b, "root of the mean squared displacement", |m| m.rms));
    }
    out.extend(columns::others(&members.system));
    for p in 0..LONGEST {
        for (i, (name, unit)) in state_names(&members.system).into_iter().enumerate() {
            let doc = "state at phase zero, so many turns before the end; none where the motion does not repeat or has repeated before";
            out.push(number(orbit(p, &name), &unit, doc, move |r: &Row| {
                let orbit = &r.steady_state.orbit;
                orbit.len().checked_sub(p + 1).map_or(f64::NAN, |at| orbit[at][i])
            }));
        }
    }
    out
}

/// Name of the column of a state `p` turns before the end.
pub(super) fn orbit(p: usize, state: &str) -> String {
    format!("orbit_{p}.{state}")
}
