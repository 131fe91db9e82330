//! The machine as a scheme: bodies from top to bottom, what joins them as springs, the ground below; cavities to scale.

use super::super::text::{escape, px};
use super::super::words::Style;
use crate::outcome::{Arg, Block, Overview};
use std::fmt::Write;

const WIDTH: f64 = 372.0;
/// Middle line of the bodies.
const MIDDLE: f64 = 150.0;
const BODY: f64 = 46.0;
/// Least distance between two bodies, and the room of the name and the values of one link.
const GAP: f64 = 58.0;
const LINE: f64 = 27.0;
/// Half width of a body without cavity.
const HALF: f64 = 60.0;
/// Links drawn beside each other at one place.
const BESIDE: usize = 3;
/// Bodies drawn; of more the first.
const MOST: usize = 7;

struct Placed<'a> {
    name: &'a str,
    top: f64,
    half: f64,
    height: f64,
}

pub(super) fn drawing(page: &Overview, style: &Style) -> String {
    let mut bodies: Vec<&Block> = page.machine.iter().filter(|b| matches!(b, Block::Body { .. })).collect();
    // what turns stands above what carries it
    bodies.sort_by_key(|b| matches!(b, Block::Body { rotor: false, .. }));
    bodies.truncate(MOST);
    let mut s = String::new();
    let (mut y, mut placed) = (18.0, Vec::new());
    let order: Vec<&str> = bodies.iter().map(|b| name_of(b)).collect();
    for (k, b) in bodies.iter().enumerate() {
        let Block::Body { name, rotor, labels, cavity, .. } = b else { continue };
        let (half, height) = cavity.map_or((HALF, BODY), |(r, _, h)| shape(r, h));
        body(&mut s, (y, half, height), *rotor, *cavity);
        let text = words(style, labels);
        label(&mut s, MIDDLE + half + 8.0, y + 0.5 * height - 3.0, name, &text);
        placed.push(Placed { name, top: y, half, height });
        y += height + GAP.max(8.0 + LINE * below(page, &order, k).min(BESIDE) as f64);
    }
    let ground = y;
    links(&mut s, page, style, &placed, ground);
    for (b, p) in bodies.iter().zip(&placed) {
        if matches!(b, Block::Body { grounded: true, .. }) {
            for x in [MIDDLE - p.half + 12.0, MIDDLE + p.half - 12.0] {
                let _ = write!(s, "<path class=\"spr\" d=\"{}\"/>", spring(x, p.top + p.height, ground));
            }
        }
    }
    let _ = write!(s, "<path class=\"gnd\" d=\"M{} {ground}H{}\"/>", px(MIDDLE - 90.0), px(MIDDLE + 90.0));
    for k in 0..15 {
        let x = MIDDLE - 88.0 + 12.5 * f64::from(k);
        let _ = write!(s, "<path class=\"gnd2\" d=\"M{} {ground}l-6 7\"/>", px(x));
    }
    if page.machine.iter().any(|b| matches!(b, Block::Body { rotor: true, .. })) {
        let end = placed.last().map_or(ground, |p| p.top + p.height);
        let _ = write!(s, "<path class=\"axis\" d=\"M{0} 4V{1}\"/>", px(MIDDLE), px(end));
    }
    let height = px(ground + 14.0);
    format!("<svg viewBox=\"0 0 {WIDTH} {height}\" role=\"img\" aria-label=\"{}\">{s}</svg>\n", escape(&names(&placed)))
}

fn name_of(block: &Block) -> &str {
    match block {
        Block::Body { name, .. } | Block::Link { name, .. } => name,
    }
}

/// Links from this body to what stands below it.
fn below(page: &Overview, order: &[&str], body: usize) -> usize {
    let place = |end: &Option<(String, f64)>| match end {
        Some((name, _)) => order.iter().position(|n| n == name),
        None => Some(order.len()),
    };
    let ends = page.machine.iter().filter_map(|b| match b {
        Block::Link { ends, .. } => Some((place(&ends[0])?, place(&ends[1])?)),
        Block::Body { .. } => None,
    });
    ends.filter(|(a, b)| a != b && a.min(b) == &body).count()
}

fn names(placed: &[Placed]) -> String {
    placed.iter().map(|p| p.name).collect::<Vec<_>>().join(", ")
}

/// Half width and height of a body around a cavity, to the scale of its proportions.
fn shape(radius: f64, height: f64) -> (f64, f64) {
    let scale = (70.0 / radius).min(120.0 / height);
    ((scale * radius + 8.0).max(24.0), (scale * height + 16.0).max(30.0))
}

fn body(s: &mut String, (y, half, height): (f64, f64, f64), rotor: bool, cavity: Option<(f64, f64, f64)>) {
    let class = if rotor { "steel" } else { "hous" };
    let _ = write!(
        s,
        "<rect class=\"{class}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>",
        px(MIDDLE - half),
        px(y),
        px(2.0 * half),
        px(height)
    );
    let Some((radius, free, _)) = cavity else { return };
    let (inner, depth) = (half - 8.0, height - 16.0);
    let layer = inner * (1.0 - (free / radius).clamp(0.0, 1.0));
    let _ = write!(
        s,
        "<rect class=\"hollow\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>",
        px(MIDDLE - inner),
        px(y + 8.0),
        px(2.0 * inner),
        px(depth)
    );
    for x in [MIDDLE - inner, MIDDLE + inner - layer] {
        let _ = write!(s, "<rect class=\"oil\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>", px(x), px(y + 8.0), px(layer), px(depth));
    }
}

fn words(style: &Style, labels: &[Arg]) -> String {
    labels.iter().map(|l| style.arg(l)).collect::<Vec<_>>().join(", ")
}

fn label(s: &mut String, x: f64, y: f64, name: &str, values: &str) {
    let cut = |text: &str, most: usize| {
        if text.chars().count() > most { text.chars().take(most - 1).chain(['…']).collect() } else { text.to_string() }
    };
    let room = ((WIDTH - x) / 6.6).max(6.0) as usize;
    let _ = write!(s, "<text class=\"dl b\" x=\"{}\" y=\"{}\">{}</text>", px(x), px(y), escape(&cut(name, room)));
    let _ = write!(s, "<text class=\"dl\" x=\"{}\" y=\"{}\">{}</text>", px(x), px(y + 13.0), escape(&cut(values, room)));
}

/// Springs between the bodies, and from the lowest to the ground.
fn links(s: &mut String, page: &Overview, style: &Style, placed: &[Placed], ground: f64) {
    let find = |end: &Option<(String, f64)>| match end {
        Some((name, _)) => placed.iter().position(|p| p.name == name),
        None => Some(placed.len()),
    };
    let mut taken = vec![0usize; placed.len() + 1];
    for block in &page.machine {
        let Block::Link { name, ends, labels, .. } = block else { continue };
        let (Some(a), Some(b)) = (find(&ends[0]), find(&ends[1])) else { continue };
        let (a, b) = (a.min(b), a.max(b));
        let text = words(style, labels);
        if a == b {
            continue;
        }
        let from = placed[a].top + placed[a].height;
        let to = placed.get(b).map_or(ground, |p| p.top);
        let k = taken[a];
        taken[a] += 1;
        if k >= BESIDE {
            continue;
        }
        // what passes another body runs beside it
        let passes = placed[a + 1..b.min(placed.len())].iter().map(|p| p.half).fold(0.0, f64::max);
        let x = if passes > 0.0 { MIDDLE - passes - 14.0 - 12.0 * k as f64 } else { MIDDLE - 36.0 + 36.0 * k as f64 };
        let _ = write!(s, "<path class=\"spr\" d=\"{}\"/>", spring(x, from, to));
        if passes > 0.0 {
            label(s, 4.0, 0.5 * (from + to) - 4.0 + 28.0 * k as f64, name, &text);
        } else {
            let right = MIDDLE + 46.0 + 8.0;
            label(s, right, from + 16.0 + LINE * k as f64, name, &text);
        }
    }
}

/// A zigzag from top to bottom.
fn spring(x: f64, from: f64, to: f64) -> String {
    let (start, end) = (from + 8.0, to - 8.0);
    let turns = 6;
    let mut d = format!("M{} {}V{}", px(x), px(from), px(start));
    for k in 0..turns {
        let y = start + (end - start) * (f64::from(k) + 0.5) / f64::from(turns);
        let side = if k % 2 == 0 { 6.0 } else { -6.0 };
        let _ = write!(d, "L{} {}", px(x + side), px(y));
    }
    let _ = write!(d, "L{} {}V{}", px(x), px(end), px(to));
    d
}
