//! The block `[operation]` of a machine file: at which speeds the machine runs, how it gets there, and the margins it must keep.

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Bounds, Extra, Field, FieldKind};
use crate::model::system::System;
use crate::study::shared::standards::{self, VibrationStandard};
use crate::text;

/// Lines of a typical block.
pub const EXAMPLE: &str = r#"speed = { from = "2700 rpm", to = "3000 rpm" }
run_up_time = "20 s"
resonance_margin = "15 %"
instability_margin = "20 %"
"#;
/// What the block is.
pub const DOC: &str = "At which speeds the machine runs, how it gets there, and which margins it must keep: the first page of the report assesses them. \
    Limits on vibration and forces are in [limits].";

/// Distance from resonances and instability, over the operating speed, where nothing else is required (API 684).
pub const MARGIN: f64 = 0.15;

/// Fields of `[operation]`.
pub const FIELDS: &[Field] = &[
    Field::optional(
        "speed",
        FieldKind::Range { unit: "rad/s", bounds: Bounds::up_to(1e6) },
        "",
        "operating speed, or the range of operating speeds as { from = \"2700 rpm\", to = \"3000 rpm\" }; its upper end is the speed of [machine] where that gives none",
    ),
    Field::optional(
        "run_up_time",
        FieldKind::Quantity { unit: "s", bounds: Bounds::positive(1e7) },
        "",
        "time from standstill to the operating speed at constant acceleration; the run-up is then simulated for the first page",
    ),
    Field::optional(
        "resonance_margin",
        FieldKind::Quantity { unit: "", bounds: Bounds::closed(0.0, 1.0) },
        "",
        "least distance of resonances from the operating speeds, over the speed; the larger one of this and the clearance of [limits] counts, 15 % where both are absent",
    ),
    Field::optional(
        "instability_margin",
        FieldKind::Quantity { unit: "", bounds: Bounds::closed(0.0, 1.0) },
        "",
        "least distance of unstable ranges from the operating speeds, over the speed; 15 % where absent",
    ),
    Field::optional(
        "decrement",
        FieldKind::Quantity { unit: "", bounds: Bounds::positive(100.0) },
        "",
        "least logarithmic decrement of every natural mode at the operating speed, of frequencies up to ten times that speed",
    ),
    standards::BALANCE_GRADE,
    standards::SHAFT_VIBRATION,
    standards::HOUSING_VIBRATION,
];

/// How the machine is run.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Operation {
    /// Operating speeds, first and last, rad/s.
    pub speed: Option<(f64, f64)>,
    /// Time from standstill to the operating speed, s.
    pub run_up_time: Option<f64>,
    /// Least distance of resonances, over the speed.
    pub resonance_margin: Option<f64>,
    /// Least distance of unstable ranges, over the speed.
    pub instability_margin: Option<f64>,
    /// Least logarithmic decrement.
    pub decrement: Option<f64>,
    /// Balance quality grade, m/s.
    pub balance_grade: Option<f64>,
    /// Standard whose limits of shaft vibration are assessed.
    pub shaft_vibration: Option<VibrationStandard>,
    /// Standard whose limits of housing vibration are assessed.
    pub housing_vibration: Option<VibrationStandard>,
}

fn read(extra: &Extra) -> Operation {
    let v = &extra.values;
    Operation {
        speed: v.range("speed").map(|r| (r.from, r.to)),
        run_up_time: v.number("run_up_time"),
        resonance_margin: v.number("resonance_margin"),
        instability_margin: v.number("instability_margin"),
        decrement: v.number("decrement"),
        balance_grade: v.choice("balance_grade").and_then(standards::grade),
        shaft_vibration: v.choice("shaft_vibration").and_then(VibrationStandard::of),
        housing_vibration: v.choice("housing_vibration").and_then(VibrationStandard::of),
    }
}

/// Of the blocks of a machine; nothing where there is no such block.
pub fn among(extras: &[Extra]) -> Operation {
    extras.iter().find(|e| e.word == "operation").map(read).unwrap_or_default()
}

/// Least distance of resonances that the file requires, over the speed: that of `[operation]` or the clearance of `[limits]`, the larger one.
pub fn required_margin(system: &System) -> Option<f64> {
    let clearance = || system.machine.extras.iter().find(|e| e.word == "limits").and_then(|e| e.values.number("clearance"));
    // of two requirements the stricter one
    among(&system.machine.extras).resonance_margin.into_iter().chain(clearance()).reduce(f64::max)
}

/// Says what is wrong with the block.
pub fn check(extra: &Extra, system: &System, out: &mut Diagnostics) {
    let operation = read(extra);
    let Some((from, to)) = operation.speed else {
        if operation.run_up_time.is_some() && system.machine.speed.is_none_or(|w| w == 0.0) {
            let message = text!("run_up_time needs an operating speed, which neither [operation] nor [machine] gives");
            out.push(Diagnostic::error("operation.speed", message).at(extra.values.span_of("run_up_time")).help(text!("add speed")));
        }
        let standing = system.machine.speed.is_none_or(|w| w == 0.0);
        let standards = [
            ("balance_grade", operation.balance_grade.is_some()),
            ("shaft_vibration", operation.shaft_vibration.is_some()),
            ("housing_vibration", operation.housing_vibration.is_some()),
        ];
        for (field, _) in standards.into_iter().filter(|f| f.1 && standing) {
            let message = text!("{field} needs an operating speed, which neither [operation] nor [machine] gives", field);
            out.push(Diagnostic::error("operation.speed", message).at(extra.values.span_of(field)).help(text!("add speed")));
        }
        return;
    };
    let place = extra.values.span_of("speed");
    if from * to <= 0.0 {
        let message = text!("operating speeds begin above standstill and have one direction of rotation");
        let help = if from == 0.0 && to == 0.0 {
            text!("write the speed at which the machine runs, as in speed = \"3000 rpm\"; leave speed out where [machine] gives it")
        } else {
            text!("write the lowest speed at which the machine runs in place of 0: the run-up from standstill is not part of this range")
        };
        out.push(Diagnostic::error("operation.speed", message).at(place).help(help));
        return;
    }
    if from > to {
        let message = text!("the operating speeds must go from a lower to a higher value");
        let (from, to) = (text::quantity(from, "rad/s"), text::quantity(to, "rad/s"));
        let help = text!("from is {from} and to is {to}: exchange them", from, to);
        out.push(Diagnostic::error("operation.speed", message).at(place).help(help));
        return;
    }
    // the speed of [machine] is one of those at which it runs
    let (low, high) = (from, to);
    let slack = 1e-9 * high.abs().max(low.abs());
    if let Some(w) = system.machine.speed.filter(|w| !(low - slack..=high + slack).contains(w)) {
        let message = text!(
            "the speed of [machine], {w}, is not among the operating speeds, {low} to {high}",
            w = text::quantity(w, "rad/s"),
            low = text::quantity(low, "rad/s"),
            high = text::quantity(high, "rad/s")
        );
        out.push(
            Diagnostic::error("operation.speed", message)
                .at(place)
                .help(text!("give the speed in one of the two places, or change one of them")),
        );
    }
}
