//! Maps of the largest peak, of the width of the hysteresis, and of what slow sweeps do.

use super::ParameterAxis;
use super::cells::{SWEEPS, TILT};
use super::report::Map;
use crate::outcome::{Arg, Axis, Figure, Heat, Line, Mark, Message, Outcome, Panel, parameter_name};

/// A ratio of values from which colours go by powers of ten.
const WIDE: f64 = 30.0;

/// Lengths in units that people read.
fn lengths(label: impl Into<Arg>, largest: f64, log: bool) -> Axis {
    let (unit, factor) = if largest < 1e-3 { ("µm", 1e6) } else { ("mm", 1e3) };
    let axis = if log { Axis::log(label, unit) } else { Axis::new(label, unit) };
    axis.factor(factor)
}

fn drawn(axis: &ParameterAxis, values: &[f64]) -> Axis {
    let largest = values.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    match axis.unit {
        "m" => lengths(parameter_name(&axis.path), largest, axis.logarithmic),
        unit if axis.logarithmic => Axis::log(parameter_name(&axis.path), unit),
        unit => Axis::new(parameter_name(&axis.path), unit),
    }
}

pub(super) fn add(map: &Map, mut outcome: Outcome) -> Outcome {
    if map.len() == 0 {
        return outcome;
    }
    let axes = &map.study.axes;
    let (x, y) = (&axes[0].path, &axes[1].path);
    let figure = |name: &'static str, title: &'static str, mark: Mark, border: bool| {
        let mut panel = Panel::new(drawn(&axes[1], &map.values[1])).mark(mark);
        let border = border && !map.border.is_empty();
        if border {
            panel = panel.mark(Line::new("border", "x", "y").begins_where("begins").name("border of jumps"));
        }
        let alt = Message::new("response-map-alt")
            .arg("what", Arg::word(name))
            .arg("x", parameter_name(x))
            .arg("y", parameter_name(y))
            .arg("border", Arg::word(if border { "yes" } else { "no" }));
        Figure::new(name, title, alt).x(drawn(&axes[0], &map.values[0])).panel(panel)
    };
    let known = |name: &str| {
        let all = map.column(name).iter().filter(|x| x.is_finite());
        all.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(*x), b.max(*x)))
    };
    let (least, most) = known("peak");
    if least <= most {
        let colours = lengths("largest peak", most, least > 0.0 && most > WIDE * least);
        let heat = Heat::new("map", x, y, "peak", colours);
        outcome = outcome.figure(figure("peak", "Largest peak", heat.into(), true));
    }
    let (least, most) = known(TILT);
    if least <= most {
        let colours = Axis::new("largest tilt", "mrad").factor(1e3);
        let heat = Heat::new("map", x, y, TILT, colours);
        outcome = outcome.figure(figure("tilt", "Largest tilt", heat.into(), true));
    }
    let (_, widest) = known("hysteresis");
    if widest > 0.0 {
        // machines without several states stay blank
        let heat = Heat::new("map", x, y, "hysteresis", Axis::log("width of the hysteresis", "rad/s"));
        outcome = outcome.figure(figure("hysteresis", "Hysteresis", heat.into(), true));
    }
    let classes: Vec<String> = SWEEPS.iter().map(|s| s.to_string()).collect();
    let heat = Heat::new("map", x, y, "sweeps", Axis::new("slow sweeps", "")).of_classes(classes);
    outcome.figure(figure("sweeps", "Result of slow sweeps", heat.into(), false))
}
