//! A machine that stands: bodies from top to bottom above the ground, labels in a column beside them.

use super::super::super::text::px;
use super::glyphs::{ball, ground, joint, lines, reach, rect, text};
use super::{Body, Parts, WIDTH};
use crate::outcome::Joint;
use std::fmt::Write;

/// Middle line of the bodies.
const MIDDLE: f64 = 96.0;
/// Half width and height of a body without cavity.
const HALF: f64 = 60.0;
const BODY: f64 = 46.0;
/// Most half width; distance between two bodies; of many bodies heights and distances are smaller.
const WIDEST: f64 = 78.0;
const GAP: f64 = 58.0;
const MANY: usize = 5;
/// Distance of what passes a body from it, and of two such.
const PASSING: f64 = 8.0;
const LINE: f64 = 14.0;

struct Placed {
    top: f64,
    half: f64,
    height: f64,
}

/// A label and the place it belongs to.
struct Label {
    at: (f64, f64),
    lines: Vec<(&'static str, String)>,
}

pub(super) fn upright(parts: &Parts) -> (String, String) {
    let small = if parts.bodies.len() > MANY { 0.75 } else { 1.0 };
    let mut placed: Vec<Placed> = Vec::new();
    let mut y = 18.0;
    for (k, b) in parts.bodies.iter().enumerate() {
        let tracks: usize = parts.balls.iter().filter(|r| r.body == k).map(|r| r.tracks).sum();
        let (half, height) = shape(b, small);
        let height = height.max(15.0 * tracks as f64 + 6.0);
        placed.push(Placed { top: y, half, height });
        y += height + small * GAP;
    }
    let floor = y;
    let mut s = String::new();
    let mut wanted: Vec<Label> = Vec::new();
    let mut right = MIDDLE + placed.iter().map(|p| p.half).fold(0.0, f64::max);
    let body_edge = right;
    for (k, (b, p)) in parts.bodies.iter().zip(&placed).enumerate() {
        body(&mut s, b, p);
        let mut row = 0;
        for r in parts.balls.iter().filter(|r| r.body == k) {
            let first = p.top + 0.5 * p.height - 7.5 * (tracks(parts, k) as f64 - 1.0) + 15.0 * row as f64;
            for t in 0..r.tracks {
                for side in [-1.0, 1.0] {
                    ball(&mut s, MIDDLE + side * (p.half - 9.0), first + 15.0 * t as f64);
                }
            }
            row += r.tracks;
            wanted.push(Label { at: (MIDDLE + p.half - 3.0, first), lines: Vec::new() });
        }
        for _ in parts.liquids.iter().filter(|l| l.body == k) {
            wanted.push(Label { at: (MIDDLE + p.half - 12.0, p.top + 0.7 * p.height), lines: Vec::new() });
        }
        wanted.push(Label { at: (MIDDLE + p.half, p.top + 0.3 * p.height), lines: Vec::new() });
        let own = b.grounded;
        if (own.elastic || own.damped) && k + 1 == placed.len() {
            for side in [-1.0, 1.0] {
                joint(&mut s, MIDDLE + side * (p.half - 18.0), p.top + p.height, floor, own);
            }
        }
    }
    // what passes other bodies runs beside them all, each further out than the one before
    let mut beside = Beside { edge: body_edge };
    for (k, b) in parts.bodies.iter().enumerate() {
        if own_joint(b) && k + 1 < placed.len() {
            beside.joint(&mut s, &placed[k], None, (floor, b.grounded));
        }
    }
    // links from the same body downwards share the width
    let count = placed.len();
    let ends: Vec<(usize, usize)> = parts.links.iter().map(|l| span(l.ends.map(|e| e.map(|e| e.0)), count)).collect();
    for (i, (a, b)) in ends.iter().copied().enumerate() {
        let same: Vec<usize> = (0..ends.len()).filter(|&j| ends[j] == (a, b)).collect();
        let k = same.iter().position(|&j| j == i).unwrap_or_default();
        let (from, to) = (placed[a].top + placed[a].height, placed.get(b).map_or(floor, |p| p.top));
        let link = &parts.links[i];
        // what passes another body runs beside it
        let passes = b > a + 1;
        let narrow = placed[a].half.min(placed.get(b).map_or(HALF, |p| p.half)) - 14.0;
        let own = placed[a].half - 36.0;
        let room = if b == count && own_joint(&parts.bodies[a]) { own.min(narrow) } else { narrow };
        if passes {
            let (x, y) = beside.joint(&mut s, &placed[a], placed.get(b), (floor, link.joint));
            wanted.push(Label { at: (x + reach(link.joint), y), lines: Vec::new() });
            continue;
        }
        let x = if same.len() == 1 { MIDDLE } else { MIDDLE - room + 2.0 * room * k as f64 / (same.len() - 1) as f64 };
        joint(&mut s, x, from, to, link.joint);
        let along = (k as f64 + 1.0) / (same.len() as f64 + 1.0);
        wanted.push(Label { at: (x + reach(link.joint), from + along * (to - from)), lines: Vec::new() });
    }
    right = right.max(beside.edge);
    let edge = if beside.edge > body_edge { right + 4.0 } else { MIDDLE + WIDEST + 4.0 };
    ground(&mut s, MIDDLE - 84.0, edge.max(MIDDLE + 84.0), floor, false);
    if parts.bodies.iter().any(|b| b.rotor) {
        let end = placed.iter().zip(&parts.bodies).filter(|p| p.1.rotor).map(|p| p.0.top + p.0.height).fold(floor.min(40.0), f64::max);
        let _ = write!(s, "<path class=\"axis\" d=\"M{0} 4V{1}\"/>", px(MIDDLE), px(end + 10.0));
    }
    let column = edge.max(right) + 18.0;
    let room = WIDTH - column - 2.0;
    // the labels in the order in which their places were noted: balls and bodies, then links
    let mut texts = Vec::new();
    for (k, b) in parts.bodies.iter().enumerate() {
        texts.extend(parts.balls.iter().filter(|r| r.body == k).map(|r| lines(r.name, &r.text, room)));
        texts.extend(parts.liquids.iter().filter(|l| l.body == k).map(|l| lines(l.name, &l.text, room)));
        texts.push(lines(b.name, &b.text, room));
    }
    texts.extend(parts.links.iter().map(|l| lines(l.name, &l.text, room)));
    wanted.iter_mut().zip(texts).for_each(|(w, t)| w.lines = t);
    let bottom = labels(&mut s, wanted, column);
    (s, px(bottom.max(floor + 14.0)))
}

/// The strip beside the bodies in which parts run that pass some of them.
struct Beside {
    /// Where the last of them ends.
    edge: f64,
}

impl Beside {
    /// From the side of a body down to that of another, or to the floor. Returns the middle of the part.
    fn joint(&mut self, s: &mut String, from: &Placed, to: Option<&Placed>, (floor, kind): (f64, Joint)) -> (f64, f64) {
        let x = self.edge + PASSING + reach(kind);
        let top = from.top + from.height - 8.0;
        let bottom = to.map_or(floor, |p| p.top + 8.0);
        let _ = write!(s, "<path class=\"spr\" d=\"M{} {}H{}\"/>", px(MIDDLE + from.half), px(top), px(x));
        joint(s, x, top, bottom, kind);
        if let Some(p) = to {
            let _ = write!(s, "<path class=\"spr\" d=\"M{} {}H{}\"/>", px(x), px(bottom), px(MIDDLE + p.half));
        }
        self.edge = x + reach(kind);
        (x, 0.5 * (top + bottom))
    }
}

fn tracks(parts: &Parts, body: usize) -> usize {
    parts.balls.iter().filter(|r| r.body == body).map(|r| r.tracks).sum()
}

fn own_joint(b: &Body) -> bool {
    b.grounded.elastic || b.grounded.damped
}

/// The upper and the lower end of a link; the ground is below all.
fn span(ends: [Option<usize>; 2], count: usize) -> (usize, usize) {
    let [a, b] = ends.map(|e| e.unwrap_or(count));
    (a.min(b), a.max(b))
}

/// Labels from top to bottom, none upon another, with lines to their places. Returns where they end.
fn labels(s: &mut String, mut wanted: Vec<Label>, column: f64) -> f64 {
    wanted.sort_by(|a, b| a.at.1.total_cmp(&b.at.1));
    let mut free = 12.0;
    for w in &wanted {
        let base = (w.at.1 - 0.5 * LINE * (w.lines.len() as f64 - 1.0)).max(free);
        for (k, (class, line)) in w.lines.iter().enumerate() {
            text(s, class, (column, base + LINE * k as f64), line);
        }
        let _ = write!(s, "<path class=\"lead\" d=\"M{} {}L{} {}\"/>", px(w.at.0), px(w.at.1), px(column - 4.0), px(base - 4.0));
        free = base + LINE * w.lines.len() as f64 + 4.0;
    }
    free - 4.0
}

/// Half width and height of a body, to the proportions of its cavity.
fn shape(b: &Body, small: f64) -> (f64, f64) {
    match b.cavity {
        Some((radius, _, height)) => {
            let scale = (70.0 / radius).min(120.0 / height);
            ((scale * radius + 8.0).max(24.0), (scale * height + 16.0).max(30.0))
        }
        None => (HALF, small * BODY),
    }
}

fn body(s: &mut String, b: &Body, p: &Placed) {
    let class = if b.rotor { "steel" } else { "hous" };
    rect(s, class, (MIDDLE - p.half, p.top), (2.0 * p.half, p.height));
    let Some((radius, free, _)) = b.cavity else { return };
    let (inner, depth) = (p.half - 8.0, p.height - 16.0);
    let layer = inner * (1.0 - (free / radius).clamp(0.0, 1.0));
    rect(s, "hollow", (MIDDLE - inner, p.top + 8.0), (2.0 * inner, depth));
    for x in [MIDDLE - inner, MIDDLE + inner - layer] {
        rect(s, "oil", (x, p.top + 8.0), (layer, depth));
    }
}
