//! A separation as a study requests it: the same words, the same checks and the same particles in every study.

use super::{Suspension, Vessel, the_suspension, the_vessel, wrong};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Bounds, Field, FieldKind, Values};
use crate::model::system::System;
use crate::separation::batch::{Batch, RunUp};
use crate::separation::motion::Lost;
use crate::separation::particle::Drag;
use crate::separation::recovery::{Recovery, Watch};
use crate::separation::separator::Separator;
use crate::separation::suspension::Model;
use crate::text;

/// A separation that is requested.
#[derive(Clone, Debug)]
pub struct Task {
    /// What separates.
    pub vessel: Vessel,
    /// What is separated.
    pub suspension: Suspension,
    /// Time at hand, s: from the start of the run-up; the residence time of a machine that liquid flows through.
    pub time: f64,
    /// Throughput, m^3/s, when it was given.
    pub throughput: Option<f64>,
    /// Share to be caught.
    pub recovery: f64,
    /// How it is computed; without a run-up yet.
    pub batch: Batch,
}

/// Throughput.
pub const THROUGHPUT: Field = Field::optional(
    "throughput",
    FieldKind::Quantity { unit: "m^3/s", bounds: Bounds::positive(1e3) },
    "",
    "flow through a bowl, disc stack or decanter; it gives the residence time",
);
/// Share.
pub const RECOVERY: Field = Field::optional(
    "recovery",
    FieldKind::Quantity { unit: "", bounds: Bounds { min: 0.0, max: 1.0, min_open: true } },
    "0.95",
    "share to be caught, q",
);
/// Size.
pub const DIAMETER: Field = Field::optional(
    "diameter",
    FieldKind::Quantity { unit: "m", bounds: Bounds { min: 0.0, max: 0.1, min_open: true } },
    "",
    "the share counts among the particles of this size and larger, instead of the whole powder",
);
/// Places.
pub const PARTICLES: Field = Field::optional(
    "particles",
    FieldKind::Integer { min: 16, max: 10_000_000 },
    "1024",
    "places of the fixed set at which particles start",
);
/// Model.
pub const MODEL: Field = Field::optional(
    "model",
    FieldKind::Choice(&[
        (
            "adaptive",
            "exact at a held speed with Stokes' drag; otherwise with inertia for particles whose drag rate is below 100 times the spin speed, drifting for the rest",
        ),
        ("exact", "inertia of every particle, the swing of the cups in a run-up"),
        ("drifting", "drag and field in balance"),
    ]),
    "adaptive",
    "motion of the particles",
);
/// Start.
pub const START: Field = Field::optional(
    "start",
    FieldKind::Choice(&[
        ("even", "spread evenly over the liquid"),
        ("slowest", "all on the axis where it takes longest: full clearing, as k-factor and Sigma count"),
    ]),
    "even",
    "where particles start",
);

/// Reads a task; says all that is wrong. `time` holds when none is given.
pub fn task(values: &Values, system: &System, time: Option<f64>, out: &mut Diagnostics) -> Option<Task> {
    let before = out.0.len();
    let vessel = the_vessel(values, system, out);
    let suspension = the_suspension(values, system, out);
    let (vessel, suspension) = (vessel?, suspension?);
    let throughput = values.number("throughput");
    let time = match (vessel.separator.flow_volume(), throughput, values.number("time")) {
        (Some(volume), Some(q), None) => Some(volume / q),
        (None, None, given) => {
            let time = given.or(time);
            if time.is_none() {
                let message = text!("the time in which the cups must have separated is needed");
                wrong(out, values, "time", "separation.time", message, text!("add time = \"30 min\""));
            }
            time
        }
        (Some(_), ..) => {
            let message = text!("liquid flows through \"{name}\": its throughput is needed, not a time", name = vessel.name);
            wrong(out, values, "throughput", "separation.throughput", message, text!("add throughput = \"500 l/h\", and no time"));
            None
        }
        (None, Some(_), _) => {
            let message = text!("nothing flows through \"{name}\"", name = vessel.name);
            wrong(out, values, "throughput", "separation.throughput", message, text!("give time = \"10 min\" instead"));
            None
        }
    };
    let nonlinear = suspension.medium.drag == Drag::SchillerNaumann;
    if nonlinear && matches!(vessel.separator, Separator::Decanter(_)) {
        let message = text!("a decanter is counted by its Sigma, which exists for Stokes' drag alone");
        wrong(
            out,
            values,
            "cup",
            "separation.drag",
            message,
            text!("use drag = \"stokes\" in [suspension], or a tubular_bowl of the same Sigma"),
        );
    }
    let (powder, liquid) = (&suspension.powder, suspension.medium.density);
    if powder.density.quantile(0.5) == liquid && powder.density.is_single() {
        let message = text!("particles and liquid have the same density: nothing separates");
        wrong(out, values, "", "separation.neutral", message, text!("give particle_density another value than liquid_density"));
    }
    let (wide, middle) = (vessel.separator.width(), powder.size.quantile(0.5));
    if !(middle <= wide) {
        let message = text!(
            "particles of {size} do not fit into \"{name}\", which is {wide} wide",
            size = text::quantity(middle, "m"),
            name = vessel.name,
            wide = text::quantity(wide, "m")
        );
        wrong(out, values, "", "separation.size", message, text!("check the unit of the diameter in [suspension]"));
    }
    if out.0.len() > before {
        return None;
    }
    let batch = Batch {
        separator: vessel.separator,
        medium: suspension.medium,
        powder: suspension.powder.clone(),
        from: values.number("diameter"),
        places: values.integer("particles").map_or(1024, |n| n.max(1) as usize),
        slowest: values.choice("start") == Some("slowest"),
        model: match values.choice("model") {
            Some("drifting") => Model::Drifting,
            Some("exact") => Model::Inertial,
            _ => Model::Adaptive,
        },
        run_up: RunUp::None,
    };
    Some(Task { vessel, suspension, time: time?, throughput, recovery: values.number("recovery").unwrap_or(0.95), batch })
}

/// A particle whose path could not be computed.
pub fn lost(Lost(why): Lost) -> Diagnostic {
    Diagnostic::error("separation.motion", text!("the path of a particle could not be computed: {why}", why))
        .help(text!("a particle that moves much faster than the cup turns needs drag = \"schiller_naumann\""))
}

/// Time a share of a batch takes at a speed, s; `watch` receives every path.
///
/// # Errors
/// When a path cannot be computed, or the watch says stop.
pub fn needed(batch: &Batch, speed: f64, share: f64, watch: Watch) -> Result<f64, Diagnostic> {
    let spinning = batch.at(speed);
    Recovery::watched(&spinning, None, watch).and_then(|mut r| r.time(share)).map_err(lost)
}
