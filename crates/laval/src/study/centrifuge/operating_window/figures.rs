//! Figures of an operating window.

use super::report::{Shown, rpm};
use crate::outcome::{Axis, Band, Figure, Heat, Line, Outcome, Panel, Points, Rule};
use crate::study::shared::support::RPM;

/// Least end of the colour scale of a map.
const LEAST_ROOM: f64 = 0.05;

impl Shown<'_> {
    pub fn figures(&self, mut out: Outcome) -> Outcome {
        let m = &self.found.main;
        let speed = || Axis::new("spin speed", "rpm").factor(RPM);
        let mut panel = Panel::new(Axis::new("margin", "").range(-1.02, 1.02));
        for (k, i) in m.intervals.iter().enumerate() {
            let band = Band::x(i.low.speed, i.high.speed);
            panel = panel.mark(if k == 0 { band.name("window") } else { band });
        }
        panel = panel.mark(Line::new("margins", "speed", "shown").group("requirement")).mark(Rule::y(0.0, ""));
        if let Some(best) = &m.best {
            panel = panel.mark(Rule::x(best.speed, "recommended"));
        }
        let spans: Vec<String> = m.intervals.iter().map(|i| format!("{} to {}", rpm(i.low.speed), rpm(i.high.speed))).collect();
        let alt = if spans.is_empty() {
            "Margins of all requirements over the spin speed; nowhere are all of them above zero.".to_string()
        } else {
            format!("Margins of all requirements over the spin speed; all are above zero from {}.", spans.join(" and from "))
        };
        out = out.figure(Figure::new("window", "Operating window", alt).x(speed()).panel(panel));
        let at_hand = if self.flow().is_some() { "residence time" } else { "time at hand" };
        if self.task.is_some() && m.points.iter().any(|p| p.needed.is_finite()) {
            let (unit, factor) = if self.task.as_ref().is_some_and(|d| d.time >= 600.0) { ("min", 1.0 / 60.0) } else { ("s", 1.0) };
            let mut panel = Panel::new(Axis::log("time needed", unit).factor(factor));
            for i in &m.intervals {
                panel = panel.mark(Band::x(i.low.speed, i.high.speed).name("window"));
            }
            panel = panel.mark(Line::new("speeds", "speed", "time").name("time to the recovery"));
            panel = panel.mark(Rule::y(self.task.as_ref().map_or(f64::NAN, |d| d.time), at_hand));
            if let Some(best) = &m.best {
                panel = panel.mark(Rule::x(best.speed, "recommended"));
            }
            let alt = "Time that the recovery takes over the spin speed, with the time there is for it.";
            out = out.figure(Figure::new("time", "Time of the separation", alt).x(speed()).panel(panel));
        }
        if out.find_table("trade").is_some_and(|t| t.rows() > 0) {
            let panel = Panel::new(Axis::log(at_hand, "min").factor(1.0 / 60.0))
                .mark(Points::new("trade", "low", "time").name("lowest speed"))
                .mark(Points::new("trade", "high", "time").name("highest speed"));
            let alt = format!("Lowest and highest speed of the window over the {at_hand}.");
            out = out.figure(Figure::new("trade", format!("Window over the {at_hand}"), alt).x(speed()).panel(panel));
        }
        if let Some(map) = &self.found.map {
            let (unit, factor) = match map.unit {
                "m" => ("mm", 1e3),
                "Pa s" => ("mPa s", 1e3),
                u => (u, 1.0),
            };
            let (unit, column) = if unit == "K" { ("°C", "celsius".to_string()) } else { (unit, map.path.clone()) };
            // one scale for both sides of the edge, as wide as the room inside it
            let room = map.cells.iter().map(|c| c.margin).fold(0.0, f64::max);
            let room = if room > 0.0 { room.max(LEAST_ROOM) } else { 1.0 };
            let heat =
                Heat::new("map", "speed", column, "margin", Axis::new("least margin", "").range(-room, room)).diverging().contour(0.0);
            let panel = Panel::new(Axis::new(map.path.clone(), unit).factor(factor)).mark(heat);
            let alt = format!("Least margin over spin speed and {}; the curve is the edge of the window.", map.path);
            out = out.figure(Figure::new("map", "Window over speed and parameter", alt).x(speed()).panel(panel));
        }
        out
    }
}
