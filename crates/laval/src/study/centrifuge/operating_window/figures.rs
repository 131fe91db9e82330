//! Figures of an operating window.

use super::margins::NAMES;
use super::report::Shown;
use crate::outcome::{Arg, Axis, Band, Figure, Heat, Line, Message, Outcome, Panel, Points, Rule, Text, parameter_name};

/// A requirement in a figure.
fn words(name: &str, flow: bool) -> &'static str {
    match name {
        "separation" if flow => "residence time",
        "separation" => "separation time",
        "vibration" => "vibration",
        "self_centred" => "self-centring",
        "stable" => "stability",
        "clear" => "natural frequencies",
        "passage" => "passage",
        "strength" => "strength",
        _ => "validity of the parts",
    }
}

/// Least end of the colour scale of a map.
const LEAST_ROOM: f64 = 0.05;

impl Shown<'_> {
    pub fn figures(&self, mut out: Outcome) -> Outcome {
        let m = &self.found.main;
        let speed = || Axis::new("spin speed", "rad/s");
        let required = self.required();
        let n = required.len() as f64;
        let names = required.iter().enumerate().map(|(k, r)| (n - k as f64, words(NAMES[*r], self.flow().is_some()).into())).collect();
        let mut panel = Panel::new(Axis::new("requirement", "").range(0.4, n + 0.6).names(names));
        for i in &m.intervals {
            panel = panel.mark(Band::x(i.low.speed, i.high.speed).name("window: all kept").good());
        }
        panel = panel.mark(Band::between("requirements", "speed", "kept low", "kept high").name("kept").bar().good());
        panel = panel.mark(Band::between("requirements", "speed", "broken low", "broken high").name("not kept").bar().bad());
        let operating = self
            .system
            .machine
            .speed
            .filter(|w| m.points.first().zip(m.points.last()).is_some_and(|(a, b)| (a.speed..=b.speed).contains(w)));
        if let Some(w) = operating {
            panel = panel.mark(Rule::x(w, "operating speed"));
        }
        if let Some(best) = &m.best {
            panel = panel.mark(Rule::x(best.speed, "recommended, with its margins"));
            for (k, r) in required.iter().enumerate() {
                let margin = best.margins.iter().find(|x| x.name == *r).map(|x| x.value).filter(|v| v.is_finite());
                if let Some(v) = margin {
                    panel = panel.mark(Text::new(best.speed, n - k as f64 - 0.08, Arg::number(v).digits(2)));
                }
            }
        }
        let alt = if m.intervals.is_empty() { "operating-window-alt-none" } else { "operating-window-alt" };
        out = out.figure(Figure::new("window", "Operating window", alt).x(speed()).panel(panel));
        let flow = self.flow().is_some();
        let at_hand = if flow { "residence time" } else { "available time" };
        if self.task.is_some() && m.points.iter().any(|p| p.needed.is_finite()) {
            let (unit, factor) = if self.task.as_ref().is_some_and(|d| d.time >= 600.0) { ("min", 1.0 / 60.0) } else { ("s", 1.0) };
            let mut panel = Panel::new(Axis::log("time needed", unit).factor(factor));
            for i in &m.intervals {
                panel = panel.mark(Band::x(i.low.speed, i.high.speed).name("window").good());
            }
            panel = panel.mark(Line::new("speeds", "speed", "time").name("time to the recovery"));
            panel = panel.mark(Rule::y(self.task.as_ref().map_or(f64::NAN, |d| d.time), at_hand));
            if let Some(best) = &m.best {
                panel = panel.mark(Rule::x(best.speed, "recommended"));
            }
            let alt = "operating-window-alt-time";
            out = out.figure(Figure::new("time", "Time of the separation", alt).x(speed()).panel(panel));
        }
        if out.find_table("trade").is_some_and(|t| t.rows() > 0) {
            let mut panel = Panel::new(speed());
            // an area needs one low and one high speed at every time
            let times: Vec<f64> = out
                .find_table("trade")
                .and_then(|t| t.column("time"))
                .map_or(Vec::new(), |c| (0..c.data.len()).filter_map(|i| c.number(i)).collect());
            panel = if times.windows(2).all(|w| w[0] < w[1]) {
                let side = |y: &str| Line::new("trade", "time", y);
                panel = panel.mark(Band::between("trade", "time", "low", "high").name("window").good());
                panel.mark(side("low").name("lowest speed")).mark(side("high").name("highest speed"))
            } else {
                panel
                    .mark(Points::new("trade", "time", "low").name("lowest speed"))
                    .mark(Points::new("trade", "time", "high").name("highest speed"))
            };
            if let Some(task) = &self.task {
                panel = panel.mark(Rule::x(task.time, if flow { "residence time required" } else { "available time required" }));
            }
            let title = if flow { "Window over the residence time" } else { "Window over the available time" };
            let x = Axis::log(at_hand, "min").factor(1.0 / 60.0);
            out = out.figure(Figure::new("trade", title, "operating-window-alt-trade").x(x).panel(panel));
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
            let heat = Heat::new("map", "speed", column, "margin", Axis::new("least margin", "").range(-room, room)).allowed().contour(0.0);
            let axis = Axis::new(parameter_name(&map.path), unit).factor(factor);
            let mut panel = Panel::new(axis).mark(heat);
            if let Some(best) = &m.best {
                panel = panel.mark(Rule::x(best.speed, "recommended"));
            }
            let alt = Message::new("operating-window-alt-map").arg("parameter", parameter_name(&map.path));
            out = out.figure(Figure::new("map", "Window over speed and parameter", alt).x(speed()).panel(panel));
        }
        out
    }
}
