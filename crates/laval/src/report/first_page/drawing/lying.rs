//! A machine that lies: the rotor from left to right, its supports and what they stand on below it, numbers at the parts and their names below.

use super::super::super::text::px;
use super::glyphs::{ball, ground, joint, lines, reach, rect, text};
use super::places::{Places, places};
use super::rows::Rows;
use super::{Body, Parts, WIDTH};
use crate::outcome::Joint;
use std::fmt::Write;

pub(super) const LEFT: f64 = 44.0;
pub(super) const RIGHT: f64 = WIDTH - 44.0;
/// Half height and half length of a disc, most of a body with a cavity.
const DISC: (f64, f64) = (36.0, 11.0);
const CAVITY: (f64, f64) = (44.0, 60.0);
/// Length of supports, height of what they stand on.
const SUPPORT: f64 = 46.0;
const BLOCK: f64 = 22.0;
const SHAFT: f64 = 5.0;
/// Half the width of a wheel on a shaft.
const WHEEL: f64 = 6.0;
/// Room beside the ends of a shaft.
pub(super) const BESIDE: f64 = 14.0;
const LINE: f64 = 15.0;

/// Numbers at the parts, and their names.
#[derive(Default)]
struct Key {
    entries: Vec<(String, String)>,
}

impl Key {
    fn mark(&mut self, s: &mut String, (x, y): (f64, f64), name: &str, values: &str) {
        self.entries.push((name.into(), values.into()));
        let _ = write!(s, "<circle class=\"num\" cx=\"{}\" cy=\"{}\" r=\"7.5\"/>", px(x), px(y));
        let _ =
            write!(s, "<text class=\"dl b\" text-anchor=\"middle\" x=\"{}\" y=\"{}\">{}</text>", px(x), px(y + 4.0), self.entries.len());
    }
}

/// A joint at a place, downwards to a block or to the ground (`None`).
struct Support<'a> {
    x: f64,
    row: usize,
    /// Along the axis of the machine, m.
    place: f64,
    to: Option<usize>,
    joint: Joint,
    name: &'a str,
    text: &'a str,
    stands: Stands,
}

/// Where a support ends.
#[derive(Clone, Copy, PartialEq)]
enum Stands {
    /// On a block below, or on the floor.
    Below,
    /// On ground above the machine.
    Above,
    /// On ground beside the shaft, between two others.
    Beside,
}

pub(super) fn lying(parts: &Parts) -> (String, String) {
    let rotors: Vec<usize> = (0..parts.bodies.len()).filter(|&k| parts.bodies[k].rotor).collect();
    let blocks: Vec<usize> = (0..parts.bodies.len()).filter(|&k| !parts.bodies[k].rotor).collect();
    let at = places(parts);
    let heights: Vec<f64> = parts.bodies.iter().map(|b| shape(b, at.scale).0).collect();
    let rows = Rows::of(parts, at.scale, &heights);
    let half = |k: &usize| {
        let (tall, long) = shape(&parts.bodies[*k], at.scale);
        (rows.wheel(parts, *k).unwrap_or(tall), long)
    };
    let several = rows.up.len() > 1;
    // of every row the half height of what it carries
    let wheels = || parts.wheels.iter().zip(&rows.wheels).flat_map(|(w, r)| [0, 1].map(|k| (w.ends[k], r[k])));
    let tallest: Vec<f64> = (0..rows.up.len())
        .map(|row| {
            let own = rotors.iter().filter(|k| rows.of[**k] == row).map(|k| half(k).0);
            let own = own.chain(wheels().filter(|w| rows.of[w.0.0] == row).map(|w| w.1));
            own.fold(if several { 0.0 } else { DISC.0 }, f64::max)
        })
        .collect();
    let mut supports = supports(parts, &rotors, &blocks, &at, &rows);
    // what would cut the side of a body stands beside it
    for p in &mut supports {
        let cut = |k: &&usize| rows.of[**k] == p.row && (2.0..half(k).1 + reach(p.joint) + 2.0).contains(&(at.point(**k, 0.0) - p.x).abs());
        if let Some(k) = rotors.iter().find(cut) {
            p.x = at.point(*k, 0.0) + (half(k).1 + reach(p.joint) + 3.0).copysign(p.x - at.point(*k, 0.0));
        }
    }
    let above = supports.iter().any(|p| p.stands == Stands::Above);
    let highest = (0..tallest.len()).map(|row| rows.up[row] + tallest[row]).fold(0.0, f64::max);
    let lowest = (0..tallest.len()).map(|row| tallest[row] - rows.up[row]).fold(0.0, f64::max);
    let base = if above { 60.0 } else { 20.0 } + highest;
    let axis = |row: usize| base - rows.up[row];
    let mut s = String::new();
    let mut key = Key::default();
    // the rotor
    let outlined = rotors.iter().any(|k| !parts.bodies[*k].profile.is_empty());
    let (mut first, mut last) = (f64::INFINITY, f64::NEG_INFINITY);
    for row in 0..rows.up.len() {
        let own = rotors.iter().filter(|k| rows.of[**k] == row).map(|&k| at.point(k, 0.0));
        let xs = own.chain(supports.iter().filter(|p| p.row == row).map(|p| p.x));
        let xs = xs.chain(wheels().filter(|w| rows.of[w.0.0] == row).map(|w| at.point(w.0.0, w.0.1)));
        let (a, b) = xs.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
        if a > b {
            continue;
        }
        let y = axis(row);
        let _ = write!(s, "<path class=\"axis\" d=\"M{} {y}H{}\"/>", px(a - 34.0), px(b + 34.0), y = px(y));
        if !outlined {
            rect(&mut s, "steel", (a - 16.0, y - SHAFT), (b - a + 32.0, 2.0 * SHAFT));
        }
        (first, last) = (first.min(a), last.max(b));
    }
    for &k in &rotors {
        let (b, x, (tall, long), axis) = (&parts.bodies[k], at.point(k, 0.0), half(&k), axis(rows.of[k]));
        if b.flexible {
            outline(&mut s, &at, k, b, axis);
            key.mark(&mut s, (x + 24.0, axis - tall - 11.0), b.name, &b.text);
        } else {
            body(&mut s, b, (x, axis), (tall, long));
            key.mark(&mut s, (x + long + 10.0, axis - tall + 2.0), b.name, &b.text);
        }
        for r in parts.balls.iter().filter(|r| r.body == k) {
            for t in 0..r.tracks {
                let dx = 15.0 * (t as f64 - 0.5 * (r.tracks as f64 - 1.0));
                ball(&mut s, x + dx, axis - tall + 9.0);
                ball(&mut s, x + dx, axis + tall - 9.0);
            }
            key.mark(&mut s, (x + long + 10.0, axis + tall - 4.0), r.name, &r.text);
        }
        for l in parts.liquids.iter().filter(|l| l.body == k) {
            key.mark(&mut s, (x, axis - tall + 14.0), l.name, &l.text);
        }
    }
    for (w, radii) in parts.wheels.iter().zip(&rows.wheels) {
        for ((k, height), r) in w.ends.into_iter().zip(radii) {
            if rows.wheel(parts, k).is_none() {
                rect(&mut s, "steel", (at.point(k, height) - WHEEL, axis(rows.of[k]) - r), (2.0 * WHEEL, 2.0 * r));
            }
        }
        // where the teeth meet
        let ((a, height), (b, _)) = (w.ends[0], w.ends[1]);
        let (from, to) = (axis(rows.of[a]), axis(rows.of[b]));
        let mesh = from + radii[0].copysign(to - from);
        key.mark(&mut s, (at.point(a, height) + DISC.1 + 12.0, mesh), w.name, &w.text);
    }
    // shafts between bodies of the rotor
    for l in &parts.links {
        if let [Some(a), Some(b)] = l.ends
            && parts.bodies[a.0].rotor
            && parts.bodies[b.0].rotor
        {
            let y = axis(rows.of[a.0]) - 16.0;
            key.mark(&mut s, (0.5 * (at.point(a.0, a.1) + at.point(b.0, b.1)), y), l.name, &l.text);
        }
    }
    // blocks below, each as wide as what stands on it
    let mut below = String::new();
    let top = |level: usize| base + lowest + SUPPORT + (BLOCK + SUPPORT) * level as f64;
    let floor = top(blocks.len());
    for (level, &k) in blocks.iter().enumerate() {
        let own: Vec<f64> = supports.iter().filter(|p| p.to == Some(level)).map(|p| p.x).collect();
        let (from, to) = own.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x - 30.0), b.max(x + 30.0)));
        let (from, to) = if from < to { (from, to) } else { (LEFT + 40.0, RIGHT - 40.0) };
        rect(&mut below, "hous", (from, top(level)), (to - from, BLOCK));
        let b = &parts.bodies[k];
        key.mark(&mut below, (0.5 * (from + to), top(level) + 0.5 * BLOCK), b.name, &b.text);
        if b.grounded.elastic || b.grounded.damped {
            for x in [from + 20.0, to - 20.0] {
                joint(&mut below, x, top(level) + BLOCK, floor, b.grounded);
            }
        }
        // what joins it with blocks further down, and with the ground
        let mut beside = 0.0;
        for l in &parts.links {
            let [a, b] = l.ends.map(|e| e.map(|e| e.0));
            let other = if a == Some(k) { b } else { a };
            let lower = other.map(|o| blocks.iter().position(|x| *x == o));
            let target = match lower {
                Some(Some(l)) if l > level => Some(top(l)),
                None => Some(floor),
                _ => None,
            };
            if let Some(to_y) = target.filter(|_| a == Some(k) || b == Some(k)) {
                let x = 0.5 * (from + to) + beside;
                joint(&mut below, x, top(level) + BLOCK, to_y, l.joint);
                key.mark(&mut below, (x + reach(l.joint) + 10.0, top(level) + BLOCK + 0.5 * SUPPORT), l.name, &l.text);
                beside += 44.0;
            }
        }
    }
    for p in &supports {
        let (axis, tallest) = (axis(p.row), tallest[p.row]);
        // on a body it ends at its edge
        let own: Vec<usize> = rotors.iter().copied().filter(|k| rows.of[*k] == p.row).collect();
        let on = own.iter().find(|k| (at.point(**k, 0.0) - p.x).abs() < half(k).1);
        let edge = on.map_or_else(|| surface(parts, &at, &own, p.place), |k| half(k).0);
        let beside = reach(p.joint) + 10.0;
        match p.stands {
            Stands::Above => {
                let (end, from) = (axis - edge, base - highest - 40.0);
                joint(&mut below, p.x, from, end, p.joint);
                ground(&mut below, p.x - 16.0, p.x + 16.0, from, true);
                key.mark(&mut below, (p.x - beside, 0.5 * (from + end)), p.name, p.text);
            }
            Stands::Below => {
                let foot = p.to.map_or(floor, top);
                joint(&mut below, p.x, axis + edge, foot, p.joint);
                let from = if several { base + lowest } else { axis + tallest.max(edge) };
                key.mark(&mut below, (p.x + beside, 0.5 * (from + foot)), p.name, p.text);
            }
            Stands::Beside => {
                let foot = axis + edge + 0.7 * SUPPORT;
                joint(&mut below, p.x, axis + edge, foot, p.joint);
                ground(&mut below, p.x - 16.0, p.x + 16.0, foot, false);
                key.mark(&mut below, (p.x + beside, 0.5 * (axis + edge + foot)), p.name, p.text);
            }
        }
    }
    ground(&mut below, first.min(LEFT) - 20.0, last.max(RIGHT) + 20.0, floor, false);
    // what passes a shaft lies behind it
    let mut s = if several { below + &s } else { s + &below };
    let mut y = floor + 28.0;
    for (k, (name, values)) in key.entries.iter().enumerate() {
        text(&mut s, "dl b", (6.0, y), &(k + 1).to_string());
        for (class, line) in lines(name, values, WIDTH - 34.0) {
            text(&mut s, class, (28.0, y), &line);
            y += LINE;
        }
        y += 3.0;
    }
    (s, px(y - 6.0))
}

/// What carries the rotor. Parts at one place stand beside each other; what would pass a block, or another shaft, leads upwards or ends beside it.
fn supports<'a>(parts: &'a Parts, rotors: &[usize], blocks: &[usize], at: &Places, rows: &Rows) -> Vec<Support<'a>> {
    let mut out: Vec<Support> = Vec::new();
    for l in &parts.links {
        let on = |e: Option<(usize, f64)>| e.filter(|e| rotors.contains(&e.0));
        let (rotor, other) = match (on(l.ends[0]), on(l.ends[1])) {
            (Some(r), None) => (r, l.ends[1]),
            (None, Some(r)) => (r, l.ends[0]),
            _ => continue,
        };
        let to = other.and_then(|o| blocks.iter().position(|b| *b == o.0));
        let row = rows.of[rotor.0];
        let passes = |way: f64| rows.up.iter().any(|up| way * (up - rows.up[row]) > 0.0);
        let stands = match to {
            Some(_) => Stands::Below,
            None if blocks.is_empty() && !passes(-1.0) => Stands::Below,
            None if !passes(1.0) => Stands::Above,
            None => Stands::Beside,
        };
        out.push(Support {
            x: at.point(rotor.0, rotor.1),
            row,
            place: parts.bodies[rotor.0].place + rotor.1,
            to,
            joint: l.joint,
            name: l.name,
            text: &l.text,
            stands,
        });
    }
    let mut k = 0;
    while k < out.len() {
        let beside = |j: &usize| (out[*j].x - out[k].x).abs() < 1.0 && (out[*j].row, out[*j].stands) == (out[k].row, out[k].stands);
        let same: Vec<usize> = (0..out.len()).filter(beside).collect();
        if same.len() > 1 && same[0] == k {
            let (middle, step) = (out[k].x, 36.0);
            for (i, &j) in same.iter().enumerate() {
                out[j].x = middle + step * (i as f64 - 0.5 * (same.len() as f64 - 1.0));
            }
        }
        k += 1;
    }
    out
}

/// The drawing of a shaft over its diameters: the scale of the lengths, but for very thin and very thick shafts.
fn thickness(b: &Body, scale: f64) -> f64 {
    let largest = b.profile.iter().flat_map(|p| [p[2], p[3]]).fold(0.0, f64::max);
    (scale * largest).clamp(2.0 * SHAFT, 2.0 * DISC.0) / largest
}

/// A shaft with the diameters of its sections.
fn outline(s: &mut String, at: &Places, k: usize, b: &Body, axis: f64) {
    if b.profile.is_empty() {
        return;
    }
    let (place, size) = (at.bodies[k], 0.5 * thickness(b, at.scale));
    let mut upper: Vec<(f64, f64)> =
        b.profile.iter().flat_map(|p| [(at.along(place + p[0]), p[2]), (at.along(place + p[1]), p[3])]).collect();
    // pieces of one diameter are one
    upper.dedup();
    let straight = |k: usize, u: &[(f64, f64)]| k > 0 && k + 1 < u.len() && u[k - 1].1 == u[k].1 && u[k].1 == u[k + 1].1;
    let corners: Vec<(f64, f64)> = (0..upper.len()).filter(|&k| !straight(k, &upper)).map(|k| (upper[k].0, size * upper[k].1)).collect();
    let lower = corners.iter().rev().map(|c| (c.0, axis + c.1));
    let points: Vec<String> = corners.iter().map(|c| (c.0, axis - c.1)).chain(lower).map(|(x, y)| format!("{} {}", px(x), px(y))).collect();
    let _ = write!(s, "<path class=\"steel\" d=\"M{}Z\"/>", points.join("L"));
}

/// Half thickness of the shaft that is drawn at a place along the axis; where two diameters meet that of the thicker one.
fn surface(parts: &Parts, at: &Places, rotors: &[usize], place: f64) -> f64 {
    let of = |k: &usize| {
        let b = &parts.bodies[*k];
        let z = place - b.place;
        let slack = 1e-9 * b.profile.last().map_or(0.0, |p| p[1]);
        let here = b.profile.iter().filter(|p| p[0] - slack <= z && z <= p[1] + slack);
        let diameter = here.map(|p| p[2] + (p[3] - p[2]) * (z - p[0]) / (p[1] - p[0])).reduce(f64::max)?;
        Some(0.5 * thickness(b, at.scale) * diameter)
    };
    rotors.iter().find_map(of).unwrap_or(SHAFT)
}

/// Half height and half length of a body of the rotor.
fn shape(b: &Body, scale: f64) -> (f64, f64) {
    match b.cavity {
        _ if !b.profile.is_empty() => {
            let largest = b.profile.iter().flat_map(|p| [p[2], p[3]]).fold(0.0, f64::max);
            (0.5 * thickness(b, scale) * largest, 0.0)
        }
        _ if b.flexible => (SHAFT, 0.0),
        Some((radius, _, height)) => {
            let scale = (CAVITY.0 / radius).min(CAVITY.1 / (0.5 * height));
            ((scale * radius + 7.0).max(20.0), (0.5 * scale * height + 7.0).max(16.0))
        }
        None => DISC,
    }
}

fn body(s: &mut String, b: &Body, (x, y): (f64, f64), (tall, long): (f64, f64)) {
    rect(s, "steel", (x - long, y - tall), (2.0 * long, 2.0 * tall));
    let Some((radius, free, _)) = b.cavity else { return };
    let (inner, depth) = (tall - 7.0, long - 7.0);
    let layer = inner * (1.0 - (free / radius).clamp(0.0, 1.0));
    rect(s, "hollow", (x - depth, y - inner), (2.0 * depth, 2.0 * inner));
    for from in [y - inner, y + inner - layer] {
        rect(s, "oil", (x - depth, from), (2.0 * depth, layer));
    }
}
