//! Tuning of a foundation so that a bearing on it carries no force at the speed of the machine.
//!
//! A body of mass M on a spring c whirls by itself where `W^2 = c/M`: it then follows the rotor, and the bearing between them stays undeflected. With the
//! damping chi0 of the foundation the force that remains is about `chi0 W |z|`.

use super::measuring::Measuring;
use super::shown::Shown;
use crate::model::capability::body::BodyParameters;
use crate::model::system::System;
use crate::outcome::{Arg, Finding, Message};
use crate::solve::harmonic::balance::orbit::Orbit;
use crate::solve::harmonic::balance::problem::{Balance, Discretisation};
use crate::solve::harmonic::branches::measure::Measure;
use crate::solve::harmonic::branches::response::{Request, Response};
use crate::solve::harmonic::stability::floquet::Stability;
use laval_num::continuation::Zero;
use laval_num::newton::{Options, newton};
use serde::{Deserialize, Serialize};

/// A foundation tuned to the speed of the machine.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Tuned {
    /// Name of the foundation.
    pub body: String,
    /// Index of the part on it among the parts of the machine.
    pub slot: usize,
    /// Speed of the machine, rad/s.
    pub speed: f64,
    /// Stiffness, N/m: as it is, and tuned.
    pub stiffness: [f64; 2],
    /// Largest force of the part, N: as it is, and tuned.
    pub force: [f64; 2],
    /// Growth rate of the tuned state, 1/s; NaN when not assessed.
    pub growth: f64,
    /// The tuned state lasts; `None` when not assessed.
    pub stable: Option<bool>,
    /// Scaled residual of the tuned state.
    pub residual: f64,
}

/// A state of small motion.
struct Small {
    /// Largest force of the part, N.
    force: f64,
    /// Growth rate, 1/s, and whether it lasts; `None` when not assessed.
    growth: Option<(f64, bool)>,
    /// Scaled residual.
    residual: f64,
}

/// The state that Newton's method finds from rest.
fn state(system: &System, d: Discretisation, request: &Request, speed: f64, slot: usize) -> Option<Small> {
    let mut balance = Balance::new(system, d, request.speeds, None).ok()?;
    let mut x = vec![0.0; balance.dim()];
    let done = newton(&mut balance, &mut x, speed, &Options { to_rounding: true, ..Options::default() }).ok()?;
    let orbit = Orbit::of(&mut balance, &x, speed).ok()?;
    let force = Measure::Force(slot).largest(system, &orbit, d.divisor).0;
    balance.sample(&x, speed);
    let exponents =
        if request.stability { Stability::new(system).ok().and_then(|mut s| s.exponents(&mut balance, &x, speed).ok()) } else { None };
    Some(Small { force, growth: exponents.map(|e| (e.growth(), e.stable())), residual: done.residual })
}

impl Measuring<'_> {
    /// For every body on a spring of its own and every nonlinear part between it and another body, at the machine's speed.
    pub(super) fn tuning(&self, response: &Response, request: &Request) -> Vec<Tuned> {
        let system = self.system;
        let Some(speed) = system.machine.speed.filter(|w| (request.speeds.0..=request.speeds.1).contains(w)) else { return Vec::new() };
        let d = response.discretisation.whole();
        let mut out = Vec::new();
        for (body, x) in &self.bodies {
            let Some(carrier) = system.slot(body).and_then(|s| s.part.body()) else { continue };
            let BodyParameters { mass: Some(mass), stiffness: Some(support), .. } = carrier.parameters() else { continue };
            let value = |path: &str| {
                let at = system.param(&format!("{body}.{path}"))?;
                let all: Vec<f64> = at.iter().map(|&i| system.params()[i]).collect();
                all.windows(2).all(|p| p[0] == p[1]).then(|| all[0])
            };
            let (Some(mass), Some(stiffness)) = (value(mass), value(support)) else { continue };
            let tuned = mass * speed * speed;
            for slot in Measure::forces(system) {
                let part = &system.slots()[slot];
                let joins = |i: usize| part.map[i].len() > 1 && part.map[i].iter().any(|&(g, _)| x.0[i] == [(g, 1.0)]);
                if part.is_linear() || !(joins(0) && joins(1)) {
                    continue;
                }
                let Ok(changed) = system.with(&[(&format!("{body}.{support}"), tuned)]) else { continue };
                let (Some(before), Some(after)) = (state(system, d, request, speed, slot), state(&changed, d, request, speed, slot)) else {
                    continue;
                };
                out.push(Tuned {
                    body: body.to_string(),
                    slot,
                    speed,
                    stiffness: [stiffness, tuned],
                    force: [before.force, after.force],
                    growth: after.growth.map_or(f64::NAN, |g| g.0),
                    stable: after.growth.map(|g| g.1),
                    residual: after.residual,
                });
            }
        }
        out
    }
}

impl Shown<'_> {
    /// What tuning would do.
    pub(super) fn tuning_findings(&self) -> Vec<Finding> {
        let say = |t: &Tuned| {
            let name = &self.system.slots()[t.slot].name;
            let stability = match t.stable {
                Some(true) => "stable",
                Some(false) => "unstable",
                None => "unknown",
            };
            let mut finding = if t.stable == Some(false) {
                Finding::warning("foundation_tuning", "nonlinear-response-tuning")
            } else {
                Finding::info("foundation_tuning", "nonlinear-response-tuning")
            };
            let tuned = Message::new("nonlinear-response-tuned").arg("stability", Arg::word(stability));
            finding.notes.push(tuned.arg("growth", Arg::quantity(t.growth, "1/s")));
            finding
                .of(name)
                .value(t.stiffness[1], "N/m")
                .arg("part", Arg::name(name))
                .arg("body", Arg::name(&t.body))
                .arg("speed", Arg::speed(t.speed))
                .arg("stiffness", Arg::quantity(t.stiffness[0], "N/m"))
                .arg("before", Arg::quantity(t.force[0], "N"))
                .arg("after", Arg::quantity(t.force[1], "N"))
                .evidence("force when tuned", t.force[1], "N")
                .evidence("force as it is", t.force[0], "N")
                .evidence("growth rate when tuned", t.growth, "1/s")
                .evidence("scaled residual when tuned", t.residual, "")
        };
        self.measured.tuned.iter().filter(|t| t.force[1] < t.force[0]).map(say).collect()
    }
}
