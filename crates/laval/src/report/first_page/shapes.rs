//! Modes as small pictures of the orbits of the bodies.

use super::super::text::{prose, px};
use super::super::words::Style;
use crate::outcome::{Arg, Message, Mode, Overview};
use std::f64::consts::{FRAC_1_SQRT_2, TAU};
use std::fmt::Write;

/// Half of the drawing.
const HALF: f64 = 42.0;
/// Radius of the largest orbit.
const LARGEST: f64 = 34.0;

pub(in crate::report) fn modes(s: &mut String, page: &Overview, style: &Style) {
    let bodies = names(page);
    s.push_str("<div class=\"modes\">\n");
    for (k, m) in page.modes.iter().enumerate() {
        mode(s, k + 1, m, &bodies, style);
    }
    s.push_str("</div>\n<p class=\"key\">");
    for (k, name) in bodies.iter().enumerate() {
        let _ = write!(s, "<i class=\"k{}\"></i>{}", k % 7, prose(name));
    }
    s.push_str("</p>\n");
}

/// Bodies in the order of the machine.
fn names(page: &Overview) -> Vec<&str> {
    let mut out: Vec<&str> = Vec::new();
    for o in page.modes.iter().flat_map(|m| &m.orbits) {
        if !out.contains(&o.0.as_str()) {
            out.push(&o.0);
        }
    }
    out
}

fn mode(s: &mut String, number: usize, m: &Mode, bodies: &[&str], style: &Style) {
    let say = |m: Message| prose(&style.message(&m));
    let whirl = say(Message::new("page-whirl").arg("whirl", Arg::word(m.whirl)));
    let frequency = prose(&style.arg(&Arg::frequency(m.frequency)));
    let damping = if m.grows && m.frequency == 0.0 {
        say(Message::new("page-diverges"))
    } else if m.grows {
        say(Message::new("page-grows"))
    } else if m.growth > 0.0 {
        say(Message::new("page-not-resolved"))
    } else {
        let decrement = -TAU * m.growth / m.frequency;
        say(Message::new("page-decrement").arg("decrement", Arg::number(decrement)))
    };
    let class = if m.grows { " grows" } else { "" };
    let _ = write!(
        s,
        "<div class=\"mode{class}\"><div class=\"mf\">{frequency}</div><svg viewBox=\"{0} {0} {1} {1}\" role=\"img\" aria-label=\"{2}\"><path class=\"ax2\" d=\"M{0} 0H{3}M0 {0}V{3}\"/>",
        px(-HALF),
        px(2.0 * HALF),
        say(Message::new("page-mode").arg("number", Arg::count(number))),
        px(HALF)
    );
    for ((name, a, b), angle) in m.orbits.iter().zip(&m.angles) {
        let k = bodies.iter().position(|n| n == name).unwrap_or(0) % 7;
        let (rx, ry) = (LARGEST * a, LARGEST * b.abs());
        let _ = write!(s, "<g transform=\"rotate({})\">", px(-angle.to_degrees()));
        let _ = write!(s, "<ellipse class=\"orb k{k}\" rx=\"{}\" ry=\"{}\"/>", px(rx.max(1.0)), px(ry.max(0.4)));
        let _ = write!(s, "<circle class=\"dotk k{k}\" cx=\"{}\" cy=\"0\" r=\"3\"/></g>", px(rx));
    }
    // the direction, as an arrow on the outermost orbit
    let outermost = m.orbits.iter().zip(&m.angles).max_by(|x, y| x.0.1.total_cmp(&y.0.1));
    if let ("forward" | "backward", Some(((_, a, b), angle))) = (m.whirl, outermost) {
        let up = if *b < 0.0 { 1.0 } else { -1.0 };
        let (c, d) = (FRAC_1_SQRT_2 * LARGEST * a, FRAC_1_SQRT_2 * LARGEST * b.abs());
        // the arrow points along the tangent at 45 degrees
        let (tx, ty) = (-c, up * d);
        let size = tx.hypot(ty).max(1e-9);
        let (tx, ty) = (5.0 * tx / size, 5.0 * ty / size);
        let (x, y) = (c, up * d);
        let _ = write!(
            s,
            "<path class=\"arrow\" transform=\"rotate({})\" d=\"M{} {}L{} {}L{} {}\"/>",
            px(-angle.to_degrees()),
            px(x - tx - 0.6 * ty),
            px(y - ty + 0.6 * tx),
            px(x),
            px(y),
            px(x - tx + 0.6 * ty),
            px(y - ty - 0.6 * tx)
        );
    }
    // bodies that move at least half as far as the one that moves most
    let mut most: Vec<String> = Vec::new();
    for name in m.orbits.iter().filter(|o| o.1 >= 0.5).map(|o| prose(&o.0)) {
        if !most.contains(&name) {
            most.push(name);
        }
    }
    let _ = writeln!(s, "</svg><div>{}</div><div>{whirl}</div><div class=\"mw\">{damping}</div></div>", most.join(" + "));
}
