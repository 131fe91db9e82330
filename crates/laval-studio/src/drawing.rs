//! The machine in section, to scale, with handles on what can be dragged.

use crate::scene::{Section, Solid};
use laval::file::Number;
use laval::model::system::System;
use laval::outcome::Block;
use laval::report::{Style, escape, fragment};
use serde_json::{Value as Json, json};
use std::fmt::Write;

/// The longer side of the drawing, and the room around the machine.
const SIDE: f64 = 372.0;
const ROOM: f64 = 26.0;
/// Height over width of a drawing at most.
const TALLEST: f64 = 1.1;

/// From metres to the drawing.
struct View {
    scale: f64,
    horizontal: bool,
    /// Of the axis.
    middle: f64,
    /// Where the lowest place is drawn, and that place.
    low: (f64, f64),
}

impl View {
    fn point(&self, z: f64, r: f64) -> (f64, f64) {
        let along = self.scale * (z - self.low.1);
        match self.horizontal {
            true => (self.low.0 + along, self.middle - self.scale * r),
            false => (self.middle + self.scale * r, self.low.0 - along),
        }
    }
}

fn px(x: f64) -> f64 {
    (100.0 * x).round() / 100.0
}

/// Fill of a solid where no style sheet says otherwise.
fn fill(kind: &str) -> &'static str {
    match kind {
        "shaft" => "#9aa7b5",
        "disc" => "#7f93ab",
        "liquid" => "#4aa3df",
        "bearing" => "#e0a030",
        _ => "#c9ccd1",
    }
}

/// The drawing, and its handles. A machine of no size is drawn as a scheme.
pub(crate) fn drawing(system: &System, blocks: &[Block], horizontal: bool, section: &Section, numbers: &[Number], style: &Style) -> Json {
    let ((low, high), radius) = section.extent();
    if !(high > low && radius > 0.0 && (high - low).is_finite()) {
        return json!({ "svg": fragment::machine(blocks, horizontal, style), "handles": [] });
    }
    let (long, across) = (high - low, 2.0 * radius);
    let (wide, tall) = if section.horizontal { (long, across) } else { (across, long) };
    let scale = ((SIDE - 2.0 * ROOM) / wide).min((TALLEST * SIDE - 2.0 * ROOM) / tall);
    let height = (scale * tall + 2.0 * ROOM).max(120.0);
    let view = match section.horizontal {
        true => View { scale, horizontal: true, middle: 0.5 * height, low: (0.5 * (SIDE - scale * long), low) },
        false => View { scale, horizontal: false, middle: 0.5 * SIDE, low: (0.5 * (height + scale * long), low) },
    };
    let names: Vec<String> = section.solids.iter().map(|s| escape(&s.name)).collect();
    let mut s = format!("<svg viewBox=\"0 0 {SIDE} {}\" role=\"img\" aria-label=\"{}\">", px(height), names.join(", "));
    let mut drawn: Vec<&Solid> = section.solids.iter().collect();
    let order = ["housing", "bearing", "liquid", "disc", "shaft"];
    drawn.sort_by_key(|d| order.iter().position(|k| *k == d.kind));
    for solid in drawn {
        draw(&mut s, solid, &view);
    }
    let ((x1, y1), (x2, y2)) = (view.point(low - 0.5 * ROOM / scale, 0.0), view.point(high + 0.5 * ROOM / scale, 0.0));
    let _ = write!(
        s,
        "<path class=\"axis\" d=\"M{} {}L{} {}\" fill=\"none\" stroke=\"#888\" stroke-width=\"0.8\" stroke-dasharray=\"9 3 2 3\"/></svg>",
        px(x1),
        px(y1),
        px(x2),
        px(y2)
    );
    json!({ "svg": s, "handles": handles(system, section, numbers, &view) })
}

/// Both halves of a section.
fn draw(s: &mut String, solid: &Solid, view: &View) {
    let mut d = String::new();
    for side in [1.0, -1.0] {
        for (k, [z, r]) in solid.outline.iter().enumerate() {
            let (x, y) = view.point(*z, side * r + solid.at[1]);
            let _ = write!(d, "{}{} {}", if k == 0 { "M" } else { "L" }, px(x), px(y));
        }
        d.push('Z');
    }
    let _ = write!(
        s,
        "<path class=\"solid {}\" data-name=\"{}\" d=\"{d}\" fill=\"{}\" stroke=\"#445\" stroke-width=\"0.8\"><title>{}</title></path>",
        solid.kind,
        escape(&solid.name),
        fill(solid.kind),
        escape(&solid.name)
    );
}

/// Positions of attachments, radii and height of cavities.
fn handles(system: &System, section: &Section, numbers: &[Number], view: &View) -> Vec<Json> {
    let (along, across) = if view.horizontal { ("x", "y") } else { ("y", "x") };
    // upwards is towards smaller y
    let sign = if view.horizontal { 1.0 } else { -1.0 };
    let mut out = Vec::new();
    let mut handle = |n: &Number, z: f64, r: f64, axis: &str, per: f64| {
        let (x, y) = view.point(z, r);
        let label = n.path.replace('_', " ").replacen('.', " ", 1);
        out.push(
            json!({ "path": n.path, "label": label, "x": px(x), "y": px(y), "axis": axis, "scale": per / view.scale, "value": n.value }),
        );
    };
    for n in numbers {
        let part = n.path.split('.').next().unwrap_or_default();
        if let Some(body) = n.on.as_deref() {
            // a position has an effect on bodies that tilt or bend alone; parts without a drawing have no handle
            let body_part = system.slot(body).and_then(|s| s.part.body());
            let long = body_part.is_some_and(|b| b.turns() && (b.nodes().is_some() || b.without_tilt().is_none()));
            let drawn = section.solids.iter().any(|s| s.name == part);
            if long && drawn {
                let z = section.place(body, n.value);
                let own = section.solids.iter().find(|s| s.name == part || s.body.as_deref() == Some(part));
                let rim = own.map_or(0.0, |s| s.outline.iter().map(|p| p[1]).fold(0.0, f64::max));
                handle(n, z, -rim.max(section.radius(z)), along, sign);
            }
            continue;
        }
        let Some(names) = system.slot(part).and_then(|s| s.part.filling()).and_then(|f| f.cavity()) else { continue };
        let key = n.path.split_once('.').map_or("", |p| p.1);
        let Some(liquid) = system.slot(part).and_then(|slot| {
            let carried = |s: &&Solid| {
                let on = |p: &laval::model::part::Link| matches!(p, laval::model::part::Link::On(a) if a.body == s.body);
                s.kind == "liquid" && slot.layout.ports.iter().any(|p| on(&p.link))
            };
            section.solids.iter().find(carried)
        }) else {
            continue;
        };
        let [low, high] = [f64::min, f64::max].map(|f| liquid.outline.iter().map(|p| p[0]).reduce(f).unwrap_or(0.0));
        let middle = 0.5 * (low + high);
        // a radius grows to the right, or upwards
        let outwards = if view.horizontal { -1.0 } else { 1.0 };
        match names.iter().position(|name| *name == key) {
            Some(0) => handle(n, middle, n.value, across, outwards),
            Some(1) => handle(n, middle, n.value, across, outwards),
            Some(2) => handle(n, high, 0.0, along, 2.0 * sign),
            _ => {}
        }
    }
    out
}
