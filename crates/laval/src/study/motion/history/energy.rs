//! The energy balance of a motion.

use super::tables::Columns;
use crate::diagnostic::Diagnostic;
use crate::outcome::{Arg, Axis, Figure, Finding, Line, Outcome, Panel, Table};
use crate::solve::motion::Motion;
use crate::solve::motion::trajectory::Trajectory;
use crate::study::motion::record::MotionRecord;
use serde::{Deserialize, Serialize};

/// The energy balance at the outputs of a motion, J.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct EnergyAccount {
    /// Change of the stored energy since the start.
    pub change: Vec<f64>,
    /// Kinetic and potential energy, that of the spin with it.
    pub stored: Vec<f64>,
    /// Turned into heat since the start.
    pub dissipated: Vec<f64>,
    /// Work of the parts' own sources and of a kick since the start.
    pub supplied: Vec<f64>,
    /// Work of the drive since the start.
    pub drive: Vec<f64>,
    /// Work of the weight since the start.
    pub weight: Vec<f64>,
    /// Change of the stored energy that the others do not explain.
    pub missing: Vec<f64>,
    /// Largest missing energy.
    pub largest_missing: f64,
    /// Largest flows and changes, and the largest stored energy beside that of the spin alone.
    pub exchanged: f64,
    /// Largest stored energy.
    pub largest_stored: f64,
}

impl EnergyAccount {
    /// `None` without an account.
    pub(in crate::study) fn of(motion: &mut Motion, trajectory: &Trajectory) -> Option<EnergyAccount> {
        let k = motion.account_start()?;
        let dim = trajectory.state.len();
        let rows: Vec<&[f64]> = trajectory.states.chunks_exact(dim).collect();
        let stored: Vec<f64> = trajectory.times.iter().zip(&rows).map(|(&t, y)| motion.stored_energy(t, y).unwrap_or(f64::NAN)).collect();
        // the first output holds the energy of a kick at its time: the account begins before it
        let first = stored.first().zip(rows.first()).map_or(f64::NAN, |(e, y)| e - y[k + 1]);
        let (mut missing, mut swing, mut vibration, mut most) = (0.0f64, 0.0f64, 0.0f64, 0.0f64);
        let grow = |m: &mut f64, x: f64| {
            if x > *m || x.is_nan() {
                *m = x;
            }
        };
        let mut motionless = vec![0.0; dim];
        let mut lack = Vec::with_capacity(rows.len());
        let mut flows = [0.0f64; 4];
        for ((y, e), &t) in rows.iter().zip(&stored).zip(&trajectory.times) {
            if let Some(s) = motion.spin_start() {
                motionless[s..s + 2].copy_from_slice(&y[s..s + 2]);
            }
            let spin = motion.stored_energy(t, &motionless).unwrap_or(f64::NAN);
            grow(&mut vibration, (e - spin).abs());
            grow(&mut most, e.abs());
            let change = e - first;
            let x = change - (-y[k] + y[k + 1] + y[k + 2] + y[k + 3]);
            lack.push(x);
            grow(&mut missing, x.abs());
            grow(&mut swing, change.abs());
            for (f, x) in flows.iter_mut().zip(&y[k..]) {
                grow(f, x.abs());
            }
        }
        let column = |i: usize| rows.iter().map(|y| y[k + i]).collect::<Vec<f64>>();
        Some(EnergyAccount {
            change: stored.iter().map(|e| e - first).collect(),
            stored,
            dissipated: column(0),
            supplied: column(1),
            drive: column(2),
            weight: column(3),
            missing: lack,
            largest_missing: missing,
            exchanged: flows.iter().sum::<f64>() + swing + vibration,
            largest_stored: most,
        })
    }

    fn table(&self, times: &[f64]) -> Result<Table, Diagnostic> {
        let mut c = Columns::default();
        c.add("t", "s", "time", times.to_vec());
        c.add("change", "J", "change of the stored energy since the start", self.change.clone());
        c.add("stored", "J", "kinetic and potential energy, that of the spin with it", self.stored.clone());
        c.add("dissipated", "J", "turned into heat since the start", self.dissipated.clone());
        c.add("supplied", "J", "work of the parts' own sources and of a kick since the start", self.supplied.clone());
        c.add("drive", "J", "work of the drive since the start", self.drive.clone());
        c.add("weight", "J", "work of the weight since the start", self.weight.clone());
        let doc = "change of the stored energy not explained by the others: the error of the integration";
        c.add("missing", "J", doc, self.missing.clone());
        c.table("energy", "Energy balance against time")
    }

    /// Whether the balance closes.
    fn finding(&self) -> Finding {
        if !(self.largest_missing.is_finite() && self.exchanged.is_finite()) {
            return Finding::warning("no_energy_balance", "history-energy-out-of-range");
        }
        // differences of stored energies hold no more digits than these
        let whole = self.largest_stored + self.exchanged;
        if self.largest_missing <= ROUNDING * whole {
            let share = if whole > 0.0 { self.largest_missing / whole } else { 0.0 };
            let finding = Finding::info("energy_balance", "history-energy-closes-to-rounding").value(share, "");
            return finding.evidence("largest missing energy", self.largest_missing, "J").evidence("energy", whole, "J");
        }
        let ratio = if self.exchanged > 0.0 { self.largest_missing / self.exchanged } else { self.largest_missing };
        let finding = if ratio < 1e-4 {
            Finding::info("energy_balance", "history-energy-closes")
        } else {
            Finding::warning("energy_balance", "history-energy-missing")
        };
        let finding = finding.value(ratio, "");
        finding.evidence("largest missing energy", self.largest_missing, "J").evidence("energy exchanged", self.exchanged, "J")
    }
}

/// Rounding of an energy over its size: some tens of operations.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Whether the energy balance closes, or why there is none; of a motion that goes beyond all bounds it says nothing.
pub(in crate::study) fn findings(record: &MotionRecord) -> Vec<Finding> {
    let closes = record.energy.as_ref().filter(|_| record.left.is_none()).map(EnergyAccount::finding);
    let missing = |part: &String| Finding::info("no_energy_account", "history-energy-unknown").arg("part", Arg::name(part));
    let none = record.no_account.as_ref().map(missing);
    closes.into_iter().chain(none).collect()
}

/// Appends the table and the figure of the balance.
///
/// # Errors
/// A table that contradicts itself.
pub(in crate::study) fn shown(record: &MotionRecord, outcome: Outcome) -> Result<Outcome, Diagnostic> {
    let Some(energy) = &record.energy else { return Ok(outcome) };
    let outcome = outcome.table(energy.table(&record.times)?);
    // a balance that closes has nothing to show
    let closes = energy.largest_missing <= CLOSES * energy.exchanged;
    Ok(if closes { outcome } else { outcome.figure(figure(energy)) })
}

/// Missing energy over that exchanged up to which the balance is not drawn.
const CLOSES: f64 = 1e-6;

fn figure(energy: &EnergyAccount) -> Figure {
    let line = |column: &'static str| Line::new("energy", "t", column).name(column);
    let mut panel = Panel::new(Axis::new("energy", "J"));
    // the energy of the spin would dwarf all others
    panel = panel.mark(line("change").name("change of the stored energy"));
    let flows = [("dissipated", &energy.dissipated), ("supplied", &energy.supplied), ("drive", &energy.drive), ("weight", &energy.weight)];
    for (column, _) in flows.into_iter().filter(|f| f.1.iter().any(|e| *e != 0.0)) {
        panel = panel.mark(line(column));
    }
    Figure::new("energy", "Energy since the start", "history-alt-energy")
        .x(Axis::new("time", "s"))
        .panel(panel)
        .panel(Panel::new(Axis::new("missing", "J")).mark(line("missing")))
}
