//! Signs of the scheme: spring, dashpot, gap, ground, ball.

use super::super::super::text::{escape, px};
use crate::outcome::Joint;
use std::fmt::Write;

/// Half distance of a spring and the dashpot beside it.
const BESIDE: f64 = 9.0;
const SIZE: f64 = 12.5;

/// What joins two places one above the other.
pub(super) fn joint(s: &mut String, x: f64, from: f64, to: f64, joint: Joint) {
    let (from, to) = (from.min(to), from.max(to));
    match (joint.elastic || !joint.damped, joint.damped) {
        (true, true) => {
            let _ = write!(s, "<path class=\"spr\" d=\"{}\"/>", spring(x - BESIDE, from, to, joint.gap));
            let _ = write!(s, "<path class=\"spr\" d=\"{}\"/>", dashpot(x + BESIDE, from, to));
        }
        (true, false) => {
            let _ = write!(s, "<path class=\"spr\" d=\"{}\"/>", spring(x, from, to, joint.gap));
        }
        (false, _) => {
            let _ = write!(s, "<path class=\"spr\" d=\"{}\"/>", dashpot(x, from, to));
        }
    }
}

/// How far a joint reaches to both sides.
pub(super) fn reach(joint: Joint) -> f64 {
    if joint.elastic && joint.damped { BESIDE + 7.0 } else { 7.0 }
}

/// A zigzag, with two plates apart below it where there is a gap; of a long one the rest is straight.
fn spring(x: f64, from: f64, to: f64, gap: bool) -> String {
    const LONGEST: f64 = 60.0;
    let low = if gap { to - 12.0 } else { to - 6.0 };
    let (start, end) = (from + 6.0, low.max(from + 10.0));
    let rest = (0.5 * (end - start - LONGEST)).max(0.0);
    let (start, end) = (start + rest, end - rest);
    let turns = 6;
    let mut d = format!("M{} {}V{}", px(x), px(from), px(start));
    for k in 0..turns {
        let y = start + (end - start) * (f64::from(k) + 0.5) / f64::from(turns);
        let side = if k % 2 == 0 { 6.0 } else { -6.0 };
        let _ = write!(d, "L{} {}", px(x + side), px(y));
    }
    let _ = write!(d, "L{} {}", px(x), px(end));
    if gap {
        let _ =
            write!(d, "V{0}M{1} {0}H{2}M{1} {3}H{2}M{4} {3}V{5}", px(end + 2.0), px(x - 7.0), px(x + 7.0), px(end + 7.0), px(x), px(to));
    } else {
        let _ = write!(d, "V{}", px(to));
    }
    d
}

/// A piston in its cylinder.
fn dashpot(x: f64, from: f64, to: f64) -> String {
    let middle = 0.5 * (from + to);
    format!(
        "M{x} {f}V{m}M{l} {m}H{r}M{a} {u}V{d}H{b}V{u}M{x} {d}V{t}",
        x = px(x),
        f = px(from),
        m = px(middle),
        l = px(x - 4.5),
        r = px(x + 4.5),
        a = px(x - 7.0),
        b = px(x + 7.0),
        u = px(middle - 7.0),
        d = px(middle + 7.0),
        t = px(to)
    )
}

/// The ground below a line, or above it.
pub(super) fn ground(s: &mut String, from: f64, to: f64, y: f64, above: bool) {
    let _ = write!(s, "<path class=\"gnd\" d=\"M{} {}H{}\"/>", px(from), px(y), px(to));
    let count = ((to - from) / 12.5) as usize;
    let (dx, dy) = if above { (6, -7) } else { (-6, 7) };
    for k in 0..=count {
        let x = from + 3.0 + 12.5 * k as f64;
        if x < to + 1.0 {
            let _ = write!(s, "<path class=\"gnd2\" d=\"M{} {}l{dx} {dy}\"/>", px(x), px(y));
        }
    }
}

pub(super) fn rect(s: &mut String, class: &str, (x, y): (f64, f64), (w, h): (f64, f64)) {
    let _ =
        write!(s, "<rect class=\"{class}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>", px(x), px(y), px(w.max(0.0)), px(h.max(0.0)));
}

/// A ball in its track, seen in the section.
pub(super) fn ball(s: &mut String, x: f64, y: f64) {
    rect(s, "hollow", (x - 6.0, y - 6.0), (12.0, 12.0));
    let _ = write!(s, "<circle class=\"ballk\" cx=\"{}\" cy=\"{}\" r=\"4.5\"/>", px(x), px(y));
}

pub(super) fn text(s: &mut String, class: &str, (x, y): (f64, f64), words: &str) {
    let _ = write!(s, "<text class=\"{class}\" x=\"{}\" y=\"{}\">{}</text>", px(x), px(y), escape(words));
}

/// Name and values in lines no wider than this.
pub(super) fn lines(name: &str, values: &str, room: f64) -> Vec<(&'static str, String)> {
    let of = |class: &'static str, text: &str, size: f64| {
        let lines = super::super::super::text::wrap(text, size, room);
        lines.into_iter().filter(|l| !l.is_empty()).map(|l| (class, l)).collect::<Vec<_>>()
    };
    // bold letters are wider
    let mut out = of("dl b", name, 1.08 * SIZE);
    out.extend(of("dl", values, SIZE));
    out
}
