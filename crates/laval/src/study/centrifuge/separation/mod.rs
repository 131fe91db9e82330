//! Separation of a suspension in a cup, tube, bowl or disc stack at one speed: how much is caught, when, where, and what that takes.
//!
//! Equations: those of [`crate::separation`]: the exact motion of every particle of a fixed, evenly spread set (closed form at constant speed with
//! Stokes drag, integration otherwise), its first exit, and the order statistics of the exit times.
//!
//! Symbols: t_q time in which a share q is caught; d_q size of which a share q is caught.
//!
//! Validity: flags in the table `validity`; contact ends a particle's motion.
//!
//! Sources: `docs/theory/separation.md`; 000_a291f7ede1484e56 chapter 3.

mod compute;
mod demand;
mod figures;
mod findings;
mod meter;
mod report;
mod result;
mod tables;

use super::cups::CUP;
use super::cups::task::{self, DIAMETER, MODEL, PARTICLES, RECOVERY, START, THROUGHPUT, Task, lost};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Bounds, Field, FieldKind, Values};
use crate::model::system::System;
use crate::outcome::{End, Finding, Outcome};
use crate::separation::batch::{RunUp, Spinning};
use crate::separation::exit::Exit;
use crate::separation::motion::Lost;
use crate::separation::particle::Particle;
use crate::separation::ramp::Ramp;
use crate::separation::recovery::Watch;
use crate::separation::separator::Separator;
use crate::separation::suspension::Member;
use crate::study::shared::size::Size;
use crate::study::shared::speed_range::SpinSpeeds;
use crate::study::shared::support::{SPEED, speed};
use crate::study::{Context, Study};
use crate::text;
use crate::text::Text;
use compute::Ensemble;
use laval_num::work::Here;
use meter::Meter;
use rayon::prelude::*;
use report::Shown;
pub use result::{Demand, PARAMETERS, Path, Recovered, Released, RunUpTime, Separated, SeparationResult, SpeedNeeded};

/// See the [module](self).
pub struct Separation {
    /// The request; its batch carries the run-up.
    pub task: Task,
    /// Spin speed, rad/s.
    pub speed: f64,
    /// Start of one particle to follow, m.
    pub release: Option<[f64; 3]>,
    /// Its velocity relative to the cup, m/s.
    pub release_velocity: [f64; 3],
    /// Paths shown.
    pub paths: usize,
    /// k-factor of another rotor, S h.
    pub transfer: Option<f64>,
}

impl Study for Separation {
    type Result = SeparationResult;
    const KIND: &'static str = "separation";
    const EXAMPLE: &'static str = r#"speed = "3000 rpm"
time = "8 min"
particles = 2048
ramp = "30 s"
"#;
    const DOC: &'static str = "Particles of the suspension followed through a cup, tube, bowl or disc stack at one speed: share caught over time, cut size, \
        grade efficiency, where the pellet lies, the time and speed a recovery needs with their sensitivities, and engineering measures \
        (RCF, k-factor, Sigma). Speeds are searched on the same account of time as everything else, with the run-up at the same acceleration; not where every \
        particle must be integrated with its inertia (model = \"exact\" with a run-up or nonlinear drag). Needs the blocks [[cup]] and [suspension].";
    const FIELDS: &'static [Field] = &[
        CUP,
        Field::optional("speed", SPEED, "", "spin speed; the machine's when left out"),
        Field::optional(
            "time",
            FieldKind::Quantity { unit: "s", bounds: Bounds::positive(1e9) },
            "",
            "time at hand in cups and tubes; an hour when left out",
        ),
        THROUGHPUT,
        RECOVERY,
        DIAMETER,
        PARTICLES,
        MODEL,
        START,
        Field::optional(
            "release",
            FieldKind::List { unit: "m", bounds: Bounds::within(100.0) },
            "",
            "place [x, y, z] in the cup of one particle of median size, released and followed by the model of the study: with its inertia unless model = \"drifting\"",
        ),
        Field::optional(
            "release_velocity",
            FieldKind::List { unit: "m/s", bounds: Bounds::within(1000.0) },
            "",
            "velocity [x', y', z'] relative to the cup with which that particle is released; at rest when left out",
        ),
        Field::optional(
            "paths",
            FieldKind::Integer { min: 0, max: 200 },
            "12",
            "particles whose paths are shown, the first of the set, until they leave or the time at hand ends",
        ),
        Field::optional(
            "ramp",
            FieldKind::Quantity { unit: "s", bounds: Bounds::positive(1e7) },
            "",
            "time of the run-up from rest, counted in the time at hand; particles settle on the way, cups swing out; of fixed-angle tubes an estimate by the field at mean radius",
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
            "speeds at given times, joined by a monotone cubic (PCHIP, slopes of Fritsch and Butland), instead of speed and ramp; the speed a recovery needs and the sensitivities scale all of them",
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
        let task = task::task(values, system, Some(3600.0), diagnostics);
        let mut wrong = |field: &str, code: &'static str, message: Text, help: Text| {
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
                    text!("a programme begins at time 0, turns one way, and ends turning"),
                    text!("the last speed is held"),
                );
            }
            match Ramp::table(t, w) {
                Ok(r) => (programmed, ramp) = (w.last().copied(), Some(r)),
                Err(e) => wrong("programme", "separation.programme", text!("{why}", why = e), text!("give times in increasing order")),
            }
            if values.number("ramp").is_some() {
                wrong("ramp", "separation.programme", text!("both a programme and a ramp are given"), text!("keep one of them"));
            }
        }
        let mut three = |field: &'static str, message: fn(usize) -> Text, help: Text| match values.list(field) {
            None => None,
            Some([x, y, z]) => Some([*x, *y, *z]),
            Some(other) => {
                wrong(field, "separation.release", message(other.len()), help);
                None
            }
        };
        let help = text!("release = [\"0 mm\", \"20 mm\", \"0 mm\"]");
        let release = three("release", |n| text!("a place has three components, not {n}", n), help);
        let help = text!("release_velocity = [\"0 m/s\", \"0.1 m/s\", \"0 m/s\"]");
        let thrown = three("release_velocity", |n| text!("a velocity has three components, not {n}", n), help);
        if thrown.is_some() && values.list("release").is_none() {
            let message = text!("a velocity belongs to a particle that is released");
            wrong("release_velocity", "separation.release", message, text!("add release = [\"0 mm\", \"20 mm\", \"0 mm\"]"));
        }
        if thrown.is_some() && values.choice("model") == Some("drifting") {
            let message = text!("a particle whose drag balances the field has no velocity of its own to begin with");
            wrong("release_velocity", "separation.release", message, text!("take it out, or take model = \"exact\""));
        }
        let speed = match programmed {
            Some(w) => Some(w),
            None => speed(values, system, diagnostics),
        };
        if programmed.is_none() && values.number("ramp").is_some() && speed == Some(0.0) {
            diagnostics.push(
                Diagnostic::error("separation.ramp", text!("a run-up needs two different speeds; this one begins and ends at standstill"))
                    .at(values.span_of("ramp"))
                    .help(text!("give another speed, or leave ramp out")),
            );
        }
        let run_up = match (ramp, values.number("ramp"), speed) {
            (Some(programme), ..) => RunUp::Programme(programme),
            (None, Some(d), Some(w)) if w != 0.0 => {
                if values.choice("ramp_shape") == Some("linear") {
                    RunUp::Linear(d / w.abs())
                } else {
                    RunUp::Smooth(d / w.abs())
                }
            }
            _ => RunUp::None,
        };
        if diagnostics.0.len() > before {
            return None;
        }
        let (mut task, speed) = (task?, speed?);
        let mut wrong = |field: &str, code: &'static str, message: Text, help: Text| {
            diagnostics.push(Diagnostic::error(code, message).at(values.span_of(field)).help(help));
        };
        if run_up != RunUp::None && task.throughput.is_some() {
            let field = if values.number("ramp").is_some() { "ramp" } else { "programme" };
            let message = text!("liquid flows through this machine, which is fed at speed: it has no run-up to count");
            wrong(field, "separation.ramp", message, text!("leave it out"));
            return None;
        }
        if let Some(ramp) = values.number("ramp").filter(|t| run_up != RunUp::None && !(*t <= task.time)) {
            let (ramp, time) = (text::quantity(ramp, "s"), text::quantity(task.time, "s"));
            let message = text!("the run-up takes {ramp}, longer than the {time} at hand: the speed is never reached", ramp, time);
            wrong("ramp", "separation.ramp", message, text!("give a shorter ramp or more time"));
            return None;
        }
        let in_cup = matches!(task.vessel.separator, Separator::Cup(_) | Separator::Tube(..));
        if release.is_some() && !in_cup {
            wrong(
                "release",
                "separation.release",
                text!("one particle can be followed in cups and tubes only"),
                text!("leave release out"),
            );
            return None;
        }
        task.batch.run_up = run_up;
        Some(Separation {
            task,
            speed,
            release,
            release_velocity: thrown.unwrap_or([0.0; 3]),
            paths: values.integer("paths").map_or(12, |n| n.max(0) as usize),
            transfer: values.number("transfer_k"),
        })
    }

    fn spin_speeds(&self, _: &System) -> Vec<SpinSpeeds> {
        Vec::new()
    }

    fn size(&self, _: &System) -> Option<Size> {
        // start, sizes and exit of every particle
        Some(Size::of_rows(self.task.batch.places, 4))
    }

    fn compute(&self, _: &System, context: &Context) -> Result<SeparationResult, Diagnostic> {
        let spinning = self.task.batch.at(self.speed);
        if spinning.crowd.is_empty() {
            return Err(Diagnostic::error("separation.empty", text!("no particle finds liquid in this tube"))
                .help(text!("lower surface, or raise length")));
        }
        let meter = Meter::new(self, &spinning, context);
        let (watch, goes_on) = (|| meter.one(), || meter.goes_on());
        let found = exits(&spinning, &watch).and_then(|exits| Ensemble::new(self, &spinning, exits, (&watch, &goes_on))?.separated());
        // what was not computed is not said
        if context.cancelled() {
            return Ok(SeparationResult { found: None, end: End::Cancelled });
        }
        if !goes_on() {
            return Ok(SeparationResult { found: None, end: End::WorkLimit });
        }
        meter.finish();
        Ok(SeparationResult { found: Some(found?), end: End::Reached })
    }

    fn report(&self, system: &System, result: &SeparationResult, name: &str) -> Result<Outcome, Diagnostic> {
        if let Some(found) = &result.found {
            return Shown { study: self, found }.outcome(system, name);
        }
        let out = Outcome::new(Self::KIND, name).end(result.end);
        if result.end == End::Cancelled {
            return Ok(out);
        }
        Ok(out.finding(Finding::info("nothing_shown", "separation-nothing-shown")))
    }
}

impl Separation {
    /// The particle of median size and density.
    fn median(&self) -> Particle {
        let p = &self.task.suspension.powder;
        Particle { radius: 0.5 * p.size.quantile(0.5), density: p.density.quantile(0.5) }
    }

    /// The particles are heavier than the liquid.
    fn heavy(&self) -> bool {
        self.median().density > self.task.suspension.medium.density
    }
}

/// Local error of the integration of one particle, relative.
const ONE: f64 = 1e-11;

/// Exits of the members with sizes of their own, in their order.
fn exits(spinning: &Spinning, watch: Watch) -> Result<Vec<Option<Exit>>, Diagnostic> {
    let here = Here::now();
    let exit = |m: &Member| {
        let _counted = here.enter();
        let found = spinning.exit(&spinning.batch.powder.particle(&m.point), m);
        if watch() { found } else { Err(Lost(text!("stopped"))) }
    };
    spinning.crowd.par_iter().map(exit).collect::<Result<_, Lost>>().map_err(lost)
}
