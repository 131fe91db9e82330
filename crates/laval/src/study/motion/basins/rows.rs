//! Rows of the study and their columns.

use super::super::start::state_names;
use super::super::steady_state::SteadyState;
use super::super::steady_state::columns::{self, RowColumn, body, number};
use super::super::steady_state::period::{LONGEST, Verdict};
use super::super::steady_state::stored;
use super::attractors::Motion;
use super::{Basins, Members, ModesAtRest};
use crate::diagnostic::Diagnostic;
use crate::model::probe::Probe;
use crate::store::Collected;
use crate::study::shared::probes;

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
        out.push(number(PLACE[k], &axis.unit, &axis.meaning().to_string(), move |r: &Row| r.place[k]));
    }
    out.extend(columns::verdict_columns(&study.rules));
    for (b, own) in members.stations.iter().enumerate() {
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

/// The motions of stored rows, with their Poincare sets.
///
/// # Errors
/// Rows that are not those of this study and machine.
pub(super) fn motions(
    study: &Basins,
    results: &Collected,
    states: &[(String, String)],
    all: &[Probe],
    modes: &ModesAtRest,
) -> Result<Vec<Motion>, Diagnostic> {
    let orbits = (0..LONGEST).flat_map(|p| states.iter().map(move |s| orbit(p, &s.0)));
    let own = ["motion", "period", "remaining"].map(String::from);
    stored::check(results, own.into_iter().chain(orbits))?;
    let states: Vec<Vec<Vec<f64>>> = (0..LONGEST).map(|p| states.iter().map(|n| results.numbers(&orbit(p, &n.0))).collect()).collect();
    let (word, period, remaining) = (results.words("motion"), results.numbers("period"), results.numbers("remaining"));
    let amplitude = lead(study, results, all).map_or_else(Vec::new, |k| results.numbers(&probes::column(&all[k])));
    let one = |r: usize| {
        let k = period[r];
        let turns = if k.is_finite() { (k as usize).min(LONGEST) } else { 0 };
        Motion {
            orbit: (0..turns).rev().map(|p| states[p].iter().map(|c| c[r]).collect()).collect(),
            // where a mode neither decays nor grows, what does not repeat may never settle
            irregular: word[r] == Verdict::NotPeriodic.word() && !modes.neutral,
            remaining: remaining[r],
            amplitude: amplitude.get(r).copied().unwrap_or(f64::NAN),
        }
    };
    Ok((0..word.len()).map(one).collect())
}

/// The probe by which attractors are ordered and named: the first body, or its tilt where it only tilts.
pub(super) fn lead(study: &Basins, results: &Collected, all: &[Probe]) -> Option<usize> {
    let sizes = all.iter().map(|p| (p.clone(), results.numbers(&probes::column(p)))).collect();
    let known = probes::resolved(sizes, study.rules.tolerance);
    let first = known.iter().min_by_key(|k| k.0.station).and_then(|k| all.iter().position(|p| *p == k.0)).unwrap_or(0);
    (first < all.len()).then_some(first)
}

/// Name of the column of a state `p` turns before the end.
pub(super) fn orbit(p: usize, state: &str) -> String {
    format!("orbit_{p}.{state}")
}
