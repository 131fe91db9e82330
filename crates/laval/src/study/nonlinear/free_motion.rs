//! What the studies of free motions share: how far bodies move, whether models hold, fields, ends.

use crate::diagnostic::Diagnostic;
use crate::model::field::{Bounds, Field, FieldKind, Value, Values};
use crate::model::part::At;
use crate::model::probe::Probe;
use crate::model::system::{Pair, System, Workspace};
use crate::outcome::{self, Arg, Finding, Message, TableBuilder};
use crate::solve::harmonic::balance::orbit::Orbit;
use crate::solve::harmonic::balance::pace::Pace;
use crate::solve::harmonic::balance::problem::{Balance, Discretisation};
use crate::solve::harmonic::free::backbone::MOST_HARMONICS;
use crate::study::shared::probes;
use crate::study::shared::support::largest;
use crate::study::shared::validity::Uses;
use crate::text;
use laval_num::continuation::{End, Refusal};
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// Field: largest order.
pub(in crate::study) const HARMONICS: Field = Field::optional(
    "harmonics",
    FieldKind::IntegerOrAuto { min: 1, max: MOST_HARMONICS as i64 },
    "auto",
    "largest order of the whirl frequency kept; auto raises it until the dropped force is below truncation",
);
/// Field: what the automatic choice of orders accepts.
pub(in crate::study) const TRUNCATION: Field = Field::optional(
    "truncation",
    FieldKind::Quantity { unit: "", bounds: Bounds::closed(1e-15, 1.0) },
    "1e-7",
    "dropped over kept force harmonics that auto accepts",
);
/// Field: most points of a family.
pub(in crate::study) const MAX_POINTS: Field =
    Field::optional("max_points", FieldKind::Integer { min: 10, max: 1_000_000 }, "2000", "most points of a family");

/// Orders, truncation and points from their fields.
pub(in crate::study) fn read(values: &Values) -> (Option<usize>, f64, usize) {
    let harmonics = match values.get("harmonics") {
        Some(Value::Integer(h)) => usize::try_from(*h).ok(),
        _ => None,
    };
    let points = values.integer("max_points").and_then(|i| usize::try_from(i).ok()).unwrap_or(2_000);
    (harmonics, values.number("truncation").unwrap_or(1e-7), points)
}

/// A machine of constant speed.
///
/// # Errors
/// A free drive.
pub(in crate::study) fn constant_speed(system: &System) -> Result<(), Diagnostic> {
    if system.machine.drive == crate::model::system::Drive::Free {
        return Err(Diagnostic::error(
            "free.drive",
            text!("free whirls are sought at constant speed, and the speed of this machine is free"),
        )
        .help(text!(
            "prescribe the speed of the machine (leave out its free drive), or follow the free machine in time with a transient study"
        )));
    }
    Ok(())
}

/// Instants of a period at which validity is taken.
const SAMPLES: usize = 16;

/// Measures free motions of one machine.
pub(in crate::study) struct Measure<'a> {
    system: &'a System,
    balance: Balance<'a>,
    /// Displacements of the stations.
    bodies: Vec<Pair>,
    /// Probes that are measured, by index: the reference points of the bodies first.
    which: Vec<usize>,
}

/// How far a motion goes.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Measured {
    /// Per body: modulus of the first order in the direction of the whirl, m.
    pub first: Vec<f64>,
    /// Per probe: largest value over a period, m or rad.
    pub largest: Vec<f64>,
    /// Use of the parts' validity; `None` where the motion could not be had.
    pub uses: Option<Uses>,
}

impl<'a> Measure<'a> {
    /// For motions of this discretisation, at frequencies about `frequency`.
    ///
    /// # Errors
    /// A body that drifts.
    pub fn new(system: &'a System, d: Discretisation, frequency: f64) -> Result<Self, Diagnostic> {
        let w = frequency.abs().max(1e-3);
        let balance = Balance::new(system, d, (0.9 * w, 1.1 * w), None)?;
        let bodies = system.stations().iter().map(|s| s.lateral.clone()).collect();
        Ok(Measure { system, balance, bodies, which: probes::ordered(system) })
    }

    /// A motion with harmonics `x` at speed, frequency and drive.
    pub fn of(&mut self, [speed, frequency, drive]: [f64; 3], x: &[f64]) -> Measured {
        self.balance.set_free(Pace { speed, frequency, drive, rate: [0.0; 3], parameter: None });
        let Ok(orbit) = Orbit::of(&mut self.balance, x, speed) else {
            let [first, largest] = [self.bodies.len(), self.which.len()].map(|n| vec![f64::NAN; n]);
            return Measured { first, largest, uses: None };
        };
        let (n, m) = (self.system.n(), self.system.m());
        let (mut q, mut v, mut a, mut z) = (vec![0.0; n], vec![0.0; n], vec![0.0; n], vec![0.0; m]);
        let first = |x: &Pair| {
            let (forward, backward) = orbit.whirl(x, 1);
            forward.abs().max(backward.abs())
        };
        let (mut uses, mut ws) = (Uses::default(), Workspace::default());
        for j in 0..SAMPLES {
            let tau = TAU * j as f64 / SAMPLES as f64;
            orbit.at(tau, &mut q, &mut v, &mut a, &mut z);
            let at = At { q: &q, v: &v, a: &a, z: &z, phase: 0.0, speed, spin_accel: 0.0, t: tau / frequency };
            uses.see(self.system, &at, &mut ws);
        }
        let largest = probes::sizes(self.system, &self.which, &orbit, 1);
        Measured { first: self.bodies.iter().map(first).collect(), largest, uses: Some(uses) }
    }
}

/// What is said of a whirl frequency in tables.
pub(in crate::study) const FREQUENCY: &str = "whirl frequency; negative: backward, where the machine has no preferred direction";

/// Motions of all families in order: the number of the family from 0, the motion, how far it goes.
pub(in crate::study) fn in_order<'a, T>(
    families: impl IntoIterator<Item = &'a [T]>,
    measured: &'a [Vec<Measured>],
) -> Vec<(usize, &'a T, &'a Measured)> {
    let one = |(k, (motions, measured)): (usize, (&'a [T], &'a Vec<Measured>))| {
        motions.iter().zip(measured).map(move |(motion, measured)| (k, motion, measured))
    };
    families.into_iter().zip(measured).enumerate().flat_map(one).collect()
}

/// The columns of how far each body goes.
pub(in crate::study) fn body_columns(mut t: TableBuilder, probes: &[Probe], measured: &[&Measured]) -> TableBuilder {
    for (k, p) in probes.iter().enumerate() {
        if p.is_reference() {
            let doc = "modulus of the first-order amplitude; NaN when it could not be had";
            t = t.float(format!("{} first order", probes::owner(p)), "m", doc, measured.iter().map(|m| m.first[k]).collect());
        }
        let doc = Arg::noted(probes::largest_doc(p), "NaN when it could not be had");
        t = t.float(probes::largest_column(p), p.unit(), doc, measured.iter().map(|m| m.largest[k]).collect());
    }
    t
}

/// The columns of how far motions are to be trusted.
pub(in crate::study) fn trust_columns(
    t: TableBuilder,
    system: &System,
    truncation: Vec<f64>,
    residual: Vec<f64>,
    measured: &[&Measured],
) -> TableBuilder {
    t.float("truncation", "", "dropped over kept force harmonics; NaN when it could not be had", truncation)
        .float("residual", "", "scaled residual of the balance", residual)
        .float(
            "validity",
            "",
            "largest use of a part's validity; above 1 is outside; NaN when it could not be had",
            measured.iter().map(|m| m.uses.as_ref().map_or(f64::NAN, |u| u.worst(system).0)).collect(),
        )
        .flag(VALID, "every part is inside its validity", measured.iter().map(|m| valid(system, m)).collect())
}

/// Column of [`valid`].
pub(in crate::study) const VALID: &str = "valid";

/// Every part is inside its validity in a motion; not where that is not known.
pub(in crate::study) fn valid(system: &System, m: &Measured) -> bool {
    m.uses.as_ref().is_some_and(|u| u.worst(system).0 <= 1.0)
}

/// That automatic orders leave out more than was requested at the worst motion.
pub(in crate::study) fn short(
    harmonics: Option<usize>,
    accepted: f64,
    truncations: impl Iterator<Item = f64>,
    kept: usize,
) -> Option<Finding> {
    let dropped = largest(truncations);
    (harmonics.is_none() && !(dropped <= accepted)).then(|| {
        let finding = match dropped.is_nan() {
            true => Finding::warning("harmonics_short", "free-motion-harmonics-unknown"),
            false => Finding::warning("harmonics_short", "free-motion-harmonics"),
        };
        finding.value_as(Arg::percent(dropped)).evidence("orders kept", kept as f64, "")
    })
}

/// That motions leave the validity of models: the largest use of each statement.
pub(in crate::study) fn invalid(system: &System, all: &[&Measured], what: &str) -> Vec<Finding> {
    let mut uses = Uses::default();
    all.iter().filter_map(|m| m.uses.as_ref()).for_each(|u| uses.join(u));
    let mut out = uses.of_motions(system, what);
    let unknown = all.iter().filter(|m| m.uses.is_none()).count();
    if unknown > 0 {
        let finding = Finding::invalid("validity", "free-motion-unmeasured").value(unknown as f64, "");
        out.push(finding.arg("all", Arg::count(all.len())).arg("motions", Arg::term(what)));
    }
    out
}

/// Why a family could not be followed further in a study that ended like this; `None` when it was followed to its end.
pub(in crate::study) fn unfinished(end: &End, study: outcome::End) -> Option<Message> {
    let because = |word| Some(Message::new("free-motion-end").arg("why", Arg::word(word)));
    match end {
        End::Reached | End::Closed => None,
        End::StepTooSmall { why: Refusal::Parameter, .. } => because("unbounded"),
        End::StepTooSmall { .. } => because("unsolved"),
        End::NewtonFailed { .. } => because("start"),
        End::MaxPoints if study == outcome::End::WorkLimit => because("work-limit"),
        End::MaxPoints => because("points"),
        End::Cancelled => because("cancelled"),
    }
}

/// The end of a study from those of its families.
pub(in crate::study) fn end<'e>(ends: impl Iterator<Item = &'e End> + Clone) -> outcome::End {
    if ends.clone().any(|e| *e == End::Cancelled) {
        return outcome::End::Cancelled;
    }
    for e in ends {
        match *e {
            End::StepTooSmall { at, .. } => return outcome::End::StepTooSmall { at },
            End::NewtonFailed { at, residual, .. } => return outcome::End::NewtonFailed { at, residual },
            End::MaxPoints => return outcome::End::MaxPoints,
            _ => {}
        }
    }
    outcome::End::Reached
}
