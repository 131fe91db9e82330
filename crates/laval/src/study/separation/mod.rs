//! Separation of a suspension in a cup, tube, bowl or disc stack at one speed: how much is caught, when, where, and what that takes.
//!
//! Equations: those of [`crate::separation`]: the exact motion of every particle of a fixed, evenly spread set (closed form at constant speed with
//! Stokes drag, integration otherwise), its first exit, and the order statistics of the exit times.
//!
//! Symbols: t_q time in which a share q is caught; d_q size of which a share q is caught.
//!
//! Validity: flags in the table `validity`; contact ends a particle's motion.
//!
//! Sources: `theory/separation.md`; 000_a291f7ede1484e56 chapter 3.

mod report;

use super::duty::{self, CUP, Suspension, Vessel};
use super::support::{SPEED, speed};
use super::{Context, Study};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Bounds, Field, FieldKind, Values};
use crate::model::system::System;
use crate::outcome::Outcome;
use crate::separation::closed::{Closed, Steady};
use crate::separation::ensemble::{self, Member, Model, members};
use crate::separation::exit::{Exit, first_exit};
use crate::separation::machine::{Separator, Turning};
use crate::separation::motion::{Journey, Lost, Tilt};
use crate::separation::particle::{Drag, Particle};
use crate::separation::ramp::Ramp;
use rayon::prelude::*;
use std::sync::atomic::{AtomicU64, Ordering};

/// See the [module](self).
pub struct Separation {
    /// What separates.
    pub vessel: Vessel,
    /// What is separated.
    pub suspension: Suspension,
    /// Spin speed, rad/s.
    pub speed: f64,
    /// Time at hand, s: from the start of the run-up; the residence time of a machine that flows through.
    pub time: f64,
    /// Throughput, m^3/s, when it was given.
    pub throughput: Option<f64>,
    /// Share to be caught.
    pub recovery: f64,
    /// Number of particles.
    pub particles: usize,
    /// With inertia or without.
    pub model: Model,
    /// All start where it takes longest.
    pub slowest: bool,
    /// Start of one particle to follow, m.
    pub release: Option<[f64; 3]>,
    /// Paths shown.
    pub paths: usize,
    /// The speed in time, when it does not begin at once.
    pub ramp: Option<Ramp>,
    /// k-factor of another rotor, S h.
    pub transfer: Option<f64>,
}

impl Study for Separation {
    const KIND: &'static str = "separation";
    const DOC: &'static str = "Particles of the suspension followed through a cup, tube, bowl or disc stack at one speed: share caught over time, cut size, \
        grade efficiency, where the pellet lies, the time and speed a recovery needs with their sensitivities, and engineering measures \
        (RCF, k-factor, Sigma). Needs the blocks [[cup]] and [suspension].";
    const FIELDS: &'static [Field] = &[
        CUP,
        Field::optional("speed", SPEED, "", "spin speed; the machine's when left out"),
        Field::optional(
            "time",
            FieldKind::Quantity { unit: "s", bounds: Bounds::positive(1e9) },
            "",
            "time at hand in cups and tubes; an hour when left out",
        ),
        Field::optional(
            "throughput",
            FieldKind::Quantity { unit: "m^3/s", bounds: Bounds::positive(1e3) },
            "",
            "flow through a bowl, disc stack or decanter; it gives the residence time",
        ),
        Field::optional(
            "recovery",
            FieldKind::Quantity { unit: "", bounds: Bounds { min: 0.0, max: 1.0, min_open: true } },
            "0.95",
            "share to be caught, q",
        ),
        Field::optional("particles", FieldKind::Integer { min: 16, max: 10_000_000 }, "4096", "particles of the fixed set"),
        Field::optional(
            "model",
            FieldKind::Choice(&[("exact", "inertia and Coriolis forces included"), ("drifting", "drag and field in balance")]),
            "exact",
            "motion of the particles",
        ),
        Field::optional(
            "start",
            FieldKind::Choice(&[
                ("even", "spread evenly over the liquid"),
                ("slowest", "all on the axis where it takes longest: full clearing, as k-factor and Sigma count"),
            ]),
            "even",
            "where particles start",
        ),
        Field::optional(
            "release",
            FieldKind::List { unit: "m", bounds: Bounds::within(100.0) },
            "",
            "place [x, y, z] in the cup of one particle of median size, released at rest and followed",
        ),
        Field::optional("paths", FieldKind::Integer { min: 0, max: 200 }, "12", "particles whose paths are shown"),
        Field::optional(
            "ramp",
            FieldKind::Quantity { unit: "s", bounds: Bounds::positive(1e7) },
            "",
            "time of the run-up from rest, during which particles move and cups swing out",
        ),
        Field::optional(
            "ramp_shape",
            FieldKind::Choice(&[("linear", "constant acceleration"), ("smooth", "10 u^3 - 15 u^4 + 6 u^5")]),
            "smooth",
            "how the speed rises",
        ),
        Field::optional(
            "programme",
            FieldKind::Columns(&[("time", "s", true, "times, increasing, from 0"), ("speed", "rad/s", true, "spin speed at these times")]),
            "",
            "speeds at given times, joined smoothly, instead of speed and ramp",
        ),
        Field::optional(
            "transfer_k",
            FieldKind::Quantity { unit: "", bounds: Bounds::positive(1e12) },
            "",
            "k-factor (in S h) of another rotor: the time that clears as much there",
        ),
    ];

    fn build(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        let before = diagnostics.0.len();
        let vessel = duty::the_vessel(values, system, diagnostics);
        let suspension = duty::the_suspension(values, system, diagnostics);
        let mut wrong = |field: &str, code: &'static str, message: String, help: &str| {
            diagnostics.push(Diagnostic::error(code, message).at(values.span_of(field)).help(help));
        };
        let mut ramp = None;
        let mut programmed = None;
        if let Some(table) = values.columns("programme") {
            let (t, w) = (table.get("time")?, table.get("speed")?);
            if t.first() != Some(&0.0) || w.iter().any(|w| *w < 0.0) || !w.last().is_some_and(|w| *w > 0.0) {
                wrong(
                    "programme",
                    "separation.programme",
                    "a programme begins at time 0, turns one way, and ends turning".into(),
                    "the last speed is held",
                );
            }
            match Ramp::table(t, w) {
                Ok(r) => (programmed, ramp) = (w.last().copied(), Some(r)),
                Err(e) => wrong("programme", "separation.programme", e.to_string(), "give times in increasing order"),
            }
            if values.number("ramp").is_some() {
                wrong("ramp", "separation.programme", "both a programme and a ramp are given".into(), "keep one of them");
            }
        }
        let release = match values.list("release") {
            None => None,
            Some([x, y, z]) => Some([*x, *y, *z]),
            Some(other) => {
                wrong(
                    "release",
                    "separation.release",
                    format!("a place has three coordinates, not {}", other.len()),
                    "release = [\"0 mm\", \"20 mm\", \"0 mm\"]",
                );
                None
            }
        };
        let speed = match programmed {
            Some(w) => Some(w),
            None => speed(values, system, diagnostics),
        };
        if let (Some(d), Some(w)) = (values.number("ramp"), speed) {
            ramp = Some(if values.choice("ramp_shape") == Some("linear") { Ramp::Linear(w, d) } else { Ramp::Smooth(w, d) });
        }
        if diagnostics.0.len() > before {
            return None;
        }
        let (vessel, suspension, speed) = (vessel?, suspension?, speed?);
        let flow = vessel.separator.flow_volume();
        let throughput = values.number("throughput");
        let mut wrong = |field: &str, code: &'static str, message: String, help: &str| {
            diagnostics.push(Diagnostic::error(code, message).at(values.span_of(field)).help(help));
        };
        let time = match (flow, throughput, values.number("time")) {
            (Some(volume), Some(q), None) => volume / q,
            (None, None, t) => t.unwrap_or(3600.0),
            (Some(_), _, _) => {
                wrong(
                    "throughput",
                    "separation.throughput",
                    format!("liquid flows through \"{}\": its throughput is needed, not a time", vessel.name),
                    "add throughput = \"500 l/h\"",
                );
                return None;
            }
            (None, Some(_), _) => {
                wrong(
                    "throughput",
                    "separation.throughput",
                    format!("nothing flows through \"{}\"", vessel.name),
                    "give time = \"10 min\" instead",
                );
                return None;
            }
        };
        let in_cup = matches!(vessel.separator, Separator::Cup(_) | Separator::Tube(..));
        if ramp.is_some() && !matches!(vessel.separator, Separator::Cup(_)) {
            wrong(
                "ramp",
                "separation.ramp",
                "a run-up can be followed in swinging cups only".into(),
                "leave it out; the table measures tells the equivalent time",
            );
            return None;
        }
        if release.is_some() && !in_cup {
            wrong("release", "separation.release", "one particle can be followed in cups and tubes only".into(), "leave release out");
            return None;
        }
        let drag = suspension.medium.drag == Drag::SchillerNaumann;
        if drag && !matches!(vessel.separator, Separator::Cup(_)) {
            wrong(
                "cup",
                "separation.drag",
                "the drag law of Schiller and Naumann is followed in swinging cups only".into(),
                "use drag = \"stokes\" in [suspension]",
            );
            return None;
        }
        let n = suspension.powder.density.quantile(0.5);
        if n == suspension.medium.density && suspension.powder.density.is_single() {
            wrong(
                "",
                "separation.neutral",
                "particles and liquid have the same density: nothing separates".into(),
                "give particle_density another value than liquid_density",
            );
            return None;
        }
        Some(Separation {
            speed,
            time,
            throughput,
            recovery: values.number("recovery").unwrap_or(0.95),
            particles: values.integer("particles").map_or(4096, |n| n.max(1) as usize),
            model: if values.choice("model") == Some("drifting") && !drag { Model::Drifting } else { Model::Inertial },
            slowest: values.choice("start") == Some("slowest"),
            release,
            paths: values.integer("paths").map_or(12, |n| n.max(0) as usize),
            ramp,
            transfer: values.number("transfer_k"),
            vessel,
            suspension,
        })
    }

    fn run(&self, system: &System, context: &Context) -> Result<Outcome, Diagnostic> {
        let turning = self.vessel.separator.at(self.speed);
        let crowd = self.crowd(&turning);
        if crowd.is_empty() {
            return Err(
                Diagnostic::error("separation.empty", "no particle finds liquid in this tube").help("lower surface, or raise length")
            );
        }
        let Some(exits) = self.exits(&turning, &crowd, context)? else {
            return Ok(Outcome::new(Self::KIND, context.name).end(crate::outcome::End::Cancelled));
        };
        report::Found { study: self, turning, crowd, exits }.outcome(system, context)
    }
}

/// Local error of an integration, relative: for the crowd, and for one particle.
const CROWD: f64 = 1e-8;
const ONE: f64 = 1e-11;

impl Separation {
    /// The members of the ensemble.
    pub fn crowd(&self, turning: &Turning) -> Vec<Member> {
        let mut out = members(turning, self.particles);
        if self.slowest {
            let heavy = self.suspension.powder.density.quantile(0.5) > self.suspension.medium.density;
            out.iter_mut().for_each(|m| m.start = turning.slowest(heavy));
        }
        out
    }

    /// No closed form holds.
    pub fn integrated(&self) -> bool {
        self.ramp.is_some() || self.suspension.medium.drag == Drag::SchillerNaumann
    }

    /// The journey of a particle, where no closed form holds.
    pub fn journey(&self, particle: Particle) -> Option<Journey> {
        let Separator::Cup(cup) = &self.vessel.separator else { return None };
        let (ramp, tilt) = match (&self.ramp, cup.held) {
            (Some(r), None) => (r.clone(), Tilt::Swinging(cup.hanging)),
            (Some(r), Some(tilt)) => (r.clone(), Tilt::Fixed { tilt, hinge: cup.hanging.hinge }),
            (None, held) => {
                let tilt = held.unwrap_or_else(|| cup.hanging.equilibrium(self.speed));
                (Ramp::Constant(self.speed), Tilt::Fixed { tilt, hinge: cup.hanging.hinge })
            }
        };
        Some(Journey { medium: self.suspension.medium, particle, ramp, tilt, vessel: cup.vessel })
    }

    /// Exits in the order of the members; particles still under way long after the time at hand count as staying. `None` when cancelled.
    fn exits(&self, turning: &Turning, crowd: &[Member], context: &Context) -> Result<Option<Vec<Option<Exit>>>, Diagnostic> {
        let done = AtomicU64::new(0);
        let total = crowd.len() as u64;
        let out: Result<Vec<Option<Exit>>, Diagnostic> = crowd
            .par_iter()
            .map(|m| {
                if context.cancelled() {
                    return Ok(None);
                }
                let at = done.fetch_add(1, Ordering::Relaxed) + 1;
                if at.is_multiple_of(1024) || self.integrated() {
                    context.progress.report(at, total);
                }
                let particle = self.suspension.powder.particle(&m.point);
                match self.journey(particle) {
                    Some(journey) if self.integrated() => self.arrive(&journey, m.start, CROWD).map(|a| a.0),
                    _ => Ok(ensemble::leave(turning, &self.suspension.medium, &particle, m, self.model)),
                }
            })
            .collect();
        context.progress.report(total, total);
        let out = out?;
        Ok((!context.cancelled()).then_some(out))
    }

    /// First exit by integration, and the largest Reynolds number at its steps. Once the speed is held and the cup has come to rest the motion goes on in
    /// closed form; a cup without damping is taken as at rest at once, because every hinge damps.
    pub fn arrive(&self, journey: &Journey, start: [f64; 3], tolerance: f64) -> Result<(Option<Exit>, f64), Diagnostic> {
        let lost = |Lost(why): Lost| {
            Diagnostic::error("separation.motion", format!("the path of a particle could not be computed: {why}"))
                .help("a particle that moves much faster than the cup turns needs drag = \"schiller_naumann\"")
        };
        let (damping, settled) = match &journey.tilt {
            Tilt::Swinging(cup) => (cup.damping, cup.equilibrium(self.speed)),
            Tilt::Fixed { tilt, .. } => (0.0, *tilt),
        };
        let rates = journey.medium.rates(&journey.particle);
        let swinging = journey.ramp.duration() + if damping > 0.0 { 40.0 / damping } else { 0.0 };
        let mut state = journey.start(start);
        let (mut t, mut reynolds) = (0.0, 0.0);
        if swinging > 0.0 {
            let a = journey.follow(state, swinging, tolerance, &[]).map_err(lost)?;
            (t, state, reynolds) = (a.last.t, a.last.state, a.reynolds);
            if a.exit.is_some() {
                return Ok((a.exit, reynolds));
            }
        }
        let steady = Steady { speed: self.speed, tilt: settled, hinge: journey.hinge(), gravity: journey.medium.gravity };
        let (place, velocity) = ([state[0], state[1], state[2]], [state[3], state[4], state[5]]);
        let field = (self.speed.powi(2) * steady.radius(place)).hypot(steady.gravity);
        let horizon = (journey.vessel.bottom - journey.vessel.top) / (rates.sedimentation.abs() * field);
        if journey.medium.drag == Drag::Stokes {
            let path = Closed::new(&rates, &steady, place, velocity);
            let exit = first_exit(&path, &journey.vessel, horizon).map(|e| Exit { time: e.time + t, ..e });
            let last = exit.map_or(0.0, |e| e.velocity.iter().map(|v| v * v).sum::<f64>().sqrt());
            return Ok((exit, reynolds.max(journey.medium.reynolds(&journey.particle, last))));
        }
        let held =
            Journey { ramp: Ramp::Constant(self.speed), tilt: Tilt::Fixed { tilt: settled, hinge: steady.hinge }, ..journey.clone() };
        (state[6], state[7]) = (settled, 0.0);
        let a = held.follow(state, 100.0 * (horizon + 1.0 / self.speed.abs().max(1e-3)), tolerance, &[]).map_err(lost)?;
        Ok((a.exit.map(|e| Exit { time: e.time + t, ..e }), reynolds.max(a.reynolds)))
    }
}
