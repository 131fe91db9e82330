//! Figures of a separation.

use super::report::Shown;
use crate::outcome::{Axis, Figure, Line, Outcome, Panel, Points, Rule};

impl Shown<'_> {
    pub fn figures(&self, mut out: Outcome) -> Outcome {
        let s = self.study;
        let line = |y: &str, name: &'static str| Line::new("efficiency", "time", y).name(name);
        let mut panel = Panel::new(Axis::new("recovery", "%").factor(100.0).range(0.0, 102.0)).mark(line("efficiency", "all"));
        let flow = self.flow();
        for (column, name) in [("wall", "at the wall"), ("bottom", "at the bottom"), ("surface", "at the surface")] {
            let used = out
                .find_table("efficiency")
                .and_then(|t| t.column(column))
                .is_some_and(|c| c.number(c.data.len().saturating_sub(1)).is_some_and(|x| x > 0.0));
            if used && !flow {
                panel = panel.mark(line(column, name));
            }
        }
        panel = panel.mark(Rule::x(s.task.time, if flow { "residence time" } else { "available time" })).mark(Rule::y(s.task.recovery, ""));
        let unit = if s.task.time >= 600.0 { ("min", 1.0 / 60.0) } else { ("s", 1.0) };
        let x = Axis::log(if flow { "residence time" } else { "time" }, unit.0).factor(unit.1);
        let alt = "separation-alt-efficiency";
        out = out.figure(Figure::new("efficiency", "Recovery over time", alt).x(x).panel(panel));
        if out.find_table("grade").is_some_and(|t| t.rows() > 0) {
            let panel = Panel::new(Axis::new("recovery", "%").factor(100.0).range(0.0, 102.0))
                .mark(Line::new("grade", "diameter", "efficiency"))
                .mark(Rule::y(0.5, "cut size"));
            let alt = "separation-alt-grade";
            out = out.figure(Figure::new("grade", "Grade efficiency", alt).x(Axis::new("diameter", "µm").factor(1e6)).panel(panel));
        }
        if out.find_table("demand").is_some() {
            let panel = Panel::new(Axis::log("time needed", unit.0).factor(unit.1))
                .mark(Line::new("demand", "speed", "time"))
                .mark(Rule::x(s.speed, "this speed"))
                .mark(Rule::y(s.task.time, if flow { "residence time" } else { "available time" }));
            let alt = "separation-alt-demand";
            out = out.figure(Figure::new("demand", "Separation time over speed", alt).x(Axis::log("spin speed", "rad/s")).panel(panel));
        }
        if out.find_table("pellet").is_some() {
            let along =
                Panel::new(Axis::new("share of all", "%").factor(100.0)).mark(Points::new("pellet", "middle", "share").group("where"));
            let alt = "separation-alt-pellet";
            out =
                out.figure(Figure::new("pellet", "Deposition of the particles", alt).x(Axis::new("place", "mm").factor(1e3)).panel(along));
        }
        if out.find_table("paths").is_some() {
            let across = |c: &str, label: &'static str| {
                Panel::new(Axis::new(label, "mm").factor(1e3)).mark(Line::new("paths", "y", c).group("particle"))
            };
            // in a bowl the paths lie in the plane of rotation
            out = out.figure(if flow {
                let alt = "separation-alt-paths-bowl";
                let x = Axis::new("outwards from the spin axis", "mm").factor(1e3);
                Figure::new("paths", "Paths in the bowl", alt).x(x).panel(across("z", "in the sense of rotation"))
            } else {
                let alt = "separation-alt-paths-cup";
                let x = Axis::new("along the cup", "mm").factor(1e3);
                Figure::new("paths", "Paths in the cup", alt).x(x).panel(across("x", "x")).panel(across("z", "z"))
            });
            let panel = Panel::new(Axis::new("radius", "mm").factor(1e3)).mark(Line::new("paths", "time", "radius").group("particle"));
            let alt = "separation-alt-paths-time";
            out = out.figure(
                Figure::new("paths_time", "Radial position over time", alt).x(Axis::new("time", unit.0).factor(unit.1)).panel(panel),
            );
        }
        if out.find_table("released").is_some() {
            let place = |c: &'static str| Line::new("released", "time", c).name(c);
            let mut tilt = Panel::new(Axis::new("tilt", "°").factor(180.0 / std::f64::consts::PI))
                .mark(Line::new("released", "time", "tilt").name("cup"));
            if out.find_table("released").is_some_and(|t| t.column("static tilt").is_some()) {
                tilt = tilt.mark(Line::new("released", "time", "static tilt").name("equilibrium at the speed of the moment"));
            }
            let along = Panel::new(Axis::new("along the cup", "mm").factor(1e3)).mark(place("y"));
            let across = Panel::new(Axis::new("across", "mm").factor(1e3)).mark(place("x")).mark(place("z"));
            let alt = "separation-alt-released";
            out = out.figure(
                Figure::new("released", "The particle released", alt).x(Axis::new("time", "s")).panel(along).panel(across).panel(tilt),
            );
        }
        out
    }
}
