//! The steady motions at one speed.
//!
//! They are those of the branches over a narrow range about it, corrected at the speed itself.

use super::shown::{holder, quality};
use crate::diagnostic::Diagnostic;
use crate::model::probe::Probe;
use crate::model::system::System;
use crate::outcome::{Arg, End, Finding, Message, Outcome, Table};
use crate::solve::harmonic::balance::orbit::Orbit;
use crate::solve::harmonic::balance::problem::Balance;
use crate::solve::harmonic::branches::response::{Request, Response};
use crate::solve::harmonic::stability::floquet::Stability;
use crate::study::Context;
use crate::study::shared::probes;
use crate::study::shared::speed_range::SpinSpeeds;
use crate::study::shared::support::inconsistent;
use laval_num::continuation::Zero;
use laval_num::dense::Mat;
use laval_num::newton::{Options, newton};
use laval_num::order::SortByNumber;
use serde::{Deserialize, Serialize};

/// Half the width of the range in which branches are followed, over the speed.
const ASIDE: f64 = 1e-3;
/// Relative difference of two motions that are one.
const SAME: f64 = 1e-7;

/// The range of speeds in which branches are followed.
pub(in crate::study) fn around(speed: f64) -> (f64, f64) {
    (speed - ASIDE * speed.abs(), speed + ASIDE * speed.abs())
}

/// A motion at the speed.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Motion {
    /// Largest value of each probe over a period, m or rad.
    pub amplitudes: Vec<f64>,
    /// Period in turns.
    pub turns: usize,
    /// Largest growth rate and its error, 1/s; NaN where it was not assessed.
    pub growth: (f64, f64),
}

impl Motion {
    fn stability(&self) -> &'static str {
        match self.growth {
            (g, e) if g <= e => "stable",
            (g, _) if g.is_nan() => "of unknown stability",
            _ => "unstable",
        }
    }
}

/// Motions at the speed, by the displacement of the first body.
pub(super) fn motions(
    system: &System,
    request: &Request,
    response: &Response,
    speed: f64,
    context: &Context,
) -> Result<Vec<Motion>, Diagnostic> {
    let (which, probes) = (probes::ordered(system), probes::all(system));
    let mut stability = if request.stability { Stability::new(system).ok() } else { None };
    let mut out: Vec<Motion> = Vec::new();
    for branch in &response.branches {
        let mut balance = Balance::new(system, branch.discretisation.whole(), request.speeds, Some(context.cancel))?;
        let n = balance.dim();
        let (mut r, mut jac) = (vec![0.0; n], Mat::zeros(n, n));
        for w in branch.points.windows(2) {
            let (a, b) = (w[0].speed, w[1].speed);
            if (a - speed) * (b - speed) > 0.0 || a == b || w.iter().any(|p| p.x.len() != n) {
                continue;
            }
            let t = (speed - a) / (b - a);
            let mut x: Vec<f64> = w[0].x.iter().zip(&w[1].x).map(|(p, q)| p + t * (q - p)).collect();
            let options = Options { to_rounding: true, ..Options::default() };
            if newton(&mut balance, &mut x, speed, &options).is_err() || balance.eval(&x, speed, &mut r, Some(&mut jac), None).is_err() {
                continue;
            }
            let Ok(orbit) = Orbit::of(&mut balance, &x, speed) else { continue };
            let turns = branch.turns();
            let amplitudes = probes::sizes(system, &which, &orbit, turns);
            // what is rounding beside the rest of a motion tells nothing of it
            let loud = probes::loudest(probes.iter().zip(amplitudes.iter().copied()));
            let near = |p: &Probe, a: f64, b: f64| (a - b).abs() <= SAME * a.max(b) || probes::still(p, a.max(b), loud, probes::ROUNDING);
            let same =
                |m: &Motion| m.turns == turns && probes.iter().zip(m.amplitudes.iter().zip(&amplitudes)).all(|(p, (a, b))| near(p, *a, *b));
            if out.iter().any(same) {
                continue;
            }
            let exponents = stability.as_mut().and_then(|s| s.exponents(&mut balance, &x, speed).ok());
            out.push(Motion { amplitudes, turns, growth: exponents.map_or((f64::NAN, f64::NAN), |e| (e.growth(), e.error)) });
        }
    }
    out.sort_by_number(|a| *a.amplitudes.first().unwrap_or(&0.0));
    Ok(out)
}

/// Findings and the table of the motions at a speed.
pub(super) fn outcome(
    kind: &str,
    system: &System,
    response: &Response,
    (speed, found): (f64, &[Motion]),
    name: &str,
    end: End,
) -> Result<Outcome, Diagnostic> {
    let probes = probes::all(system);
    let loud = probes::loudest(found.iter().flat_map(|m| probes.iter().zip(m.amplitudes.iter().copied())));
    let tilts = |b: usize| probes.iter().any(|p| p.is_tilt() && p.station == b);
    let complete = end == End::Reached;
    let mut outcome = Outcome::new(kind, name).over("speed", "rad/s").end(end);
    for (name, count) in &response.work {
        outcome = outcome.work(*name, *count);
    }
    let count = found.len();
    if found.is_empty() {
        let finding = match complete {
            true => Finding::warning("no_motion", "nonlinear-response-no-motion"),
            false => Finding::warning("no_motion", "nonlinear-response-no-motion-stopped"),
        };
        outcome = outcome.finding(finding.arg("speed", Arg::speed(speed)));
    } else if found.iter().all(|m| m.stability() == "unstable") {
        let finding = Finding::warning("unstable", "nonlinear-response-all-unstable");
        outcome = outcome.finding(finding.arg("speed", Arg::speed(speed)).arg("count", Arg::count(count)));
    }
    let sizes = found.iter().flat_map(|m| probes.iter().zip(m.amplitudes.iter().copied()));
    let unforced = probes::unforced(system, &[SpinSpeeds::one(speed)], sizes);
    for (k, m) in found.iter().enumerate() {
        // of a body that only tilts its tilt is reported
        let reported = |(p, a): &(&Probe, &f64)| p.is_tilt() || !tilts(p.station) || !probes::still(p, **a, loud, probes::ROUNDING);
        for (p, a) in probes.iter().zip(&m.amplitudes).filter(reported) {
            let id = if p.is_tilt() { "steady_tilt" } else { "steady_motion" };
            let mut finding = Finding::info(id, "nonlinear-response-steady")
                .of(format!("{} {}", k + 1, probes::owner(p)))
                .value(*a, p.unit())
                .arg("speed", Arg::speed(speed))
                .arg("quality", quality(p))
                .arg("body", holder(p))
                .arg("number", Arg::count(k + 1))
                .arg("count", Arg::count(count))
                .arg("stability", Arg::word(if m.growth.0.is_nan() { "unknown" } else { m.stability() }));
            if m.turns > 1 {
                finding.notes.push(Message::new("nonlinear-response-period").arg("turns", Arg::count(m.turns)));
            }
            finding.notes.extend(unforced.then(|| Message::new("nonlinear-response-no-excitation")));
            outcome = outcome.finding(finding.evidence("largest growth rate", m.growth.0, "1/s").evidence("error", m.growth.1, "1/s"));
        }
    }
    let mut table = Table::new("motions", "Steady motions")
        .int("motion", "", "number by the displacement of the first body", (1..=count as i64).collect())
        .int("turns", "", "period in turns of the rotor", found.iter().map(|m| m.turns as i64).collect());
    for (i, p) in probes.iter().enumerate() {
        let doc = if p.is_tilt() { "largest tilt over a period" } else { "largest displacement over a period" };
        table = table.float(probes::column(p), p.unit(), doc, found.iter().map(|m| m.amplitudes[i]).collect());
    }
    let table = table
        .text("stability", "stable, unstable or of unknown stability", found.iter().map(|m| m.stability().into()).collect())
        .float_if_any("growth", "1/s", "largest growth rate; NaN where it was not assessed", found.iter().map(|m| m.growth.0).collect());
    outcome.table(table.build().map_err(inconsistent)?).checked().map_err(Diagnostic::from)
}
