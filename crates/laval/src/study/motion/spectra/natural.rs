//! Natural frequencies of the machine linearised at rest, for waterfalls: lines that a motion may meet.

use super::analyse::Window;
use crate::model::system::System;
use crate::outcome::{Arg, Line, Table, TableBuilder};
use crate::solve::pencil::{FLAT, modes_about};
use crate::solve::rest::rest;
use crate::solve::roots::transcendental;
use crate::study::shared::stations::Stations;
use laval_num::complex::C64;
use serde::{Deserialize, Serialize};

/// Instants at which modes are computed, at most, and lines on each side of zero.
const INSTANTS: usize = 24;
const LINES: usize = 8;
/// Displacement over the largest of all points above which a point moves.
const MOVES: f64 = 1e-3;
/// Name of the table.
const NAME: &str = "natural_frequencies";

/// A natural frequency at one instant of a motion.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct NaturalFrequency {
    /// Time at the middle of the window, s.
    pub t: f64,
    /// Spin speed there, rad/s.
    pub speed: f64,
    /// Number in order of size, negative where it turns against the machine.
    pub line: i64,
    /// rad/s; negative turns against the machine.
    pub frequency: f64,
}

impl NaturalFrequency {
    /// Its place on an axis of frequencies, or of orders.
    pub(super) fn on(&self, axis: &str) -> f64 {
        match axis {
            "order" if self.speed == 0.0 => f64::NAN,
            "order" => self.frequency / self.speed.abs(),
            _ => self.frequency,
        }
    }
}

/// Lines over the instants of these windows, one after the other; empty where the machine cannot be linearised at rest. A mode in which points go round both ways is
/// on both sides of zero.
pub(in crate::study) fn natural(system: &System, windows: &[Window]) -> Vec<NaturalFrequency> {
    let mut out = Vec::new();
    // the roots of a machine without form in time take seconds at every speed
    if transcendental(system) {
        return out;
    }
    let (stations, count) = (Stations::of(system), windows.len().min(INSTANTS));
    for k in 0..count {
        let w = &windows[if count > 1 { k * (windows.len() - 1) / (count - 1) } else { 0 }];
        let Ok(spectrum) = rest(system, w.speed).and_then(|about| modes_about(system, &about, false)) else { continue };
        for side in [1, -1] {
            let lateral = spectrum.modes.iter().filter(|m| m.whirl.is_lateral() && m.frequency() > 0.0);
            let own = lateral.filter(|m| goes_round(&stations.motion(&m.q), side));
            let mut all: Vec<f64> = own.map(|m| m.frequency()).collect();
            all.sort_by(f64::total_cmp);
            let line =
                |(i, f): (usize, f64)| NaturalFrequency { t: w.t, speed: w.speed, line: side * (i as i64 + 1), frequency: side as f64 * f };
            out.extend(all.into_iter().take(LINES).enumerate().map(line));
        }
    }
    out.sort_by_key(|r| r.line);
    out
}

/// Of points that move, some go round with the machine (`side` 1) or against it (-1), or along a line. Shafts that turn against the machine whirl forward on side -1.
fn goes_round(motion: &[[C64; 2]], side: i64) -> bool {
    let circles = || motion.iter().map(|m| if side > 0 { [m[0].abs(), m[1].abs()] } else { [m[1].abs(), m[0].abs()] });
    let largest = circles().map(|[own, other]| own + other).fold(0.0, f64::max);
    circles().any(|[own, other]| own + other > MOVES * largest && other <= own * (1.0 + FLAT))
}

pub(super) fn table(rows: &[NaturalFrequency]) -> TableBuilder {
    let column = |f: fn(&NaturalFrequency) -> f64| rows.iter().map(f).collect::<Vec<f64>>();
    Table::new(NAME, "Natural frequencies of the machine linearised at rest, backward ones negative")
        .int("line", "", "number in order of frequency, negative for backward whirl", rows.iter().map(|r| r.line).collect())
        .float("t", "s", "time at the middle of the window", column(|r| r.t))
        .float("speed", "rad/s", "spin speed there", column(|r| r.speed))
        .float("frequency", "rad/s", "natural frequency; negative turns against the rotor", column(|r| r.frequency))
        .float("order", "", "natural frequency over spin frequency", column(|r| r.on("order")))
        .flag("observed", "found in the motion; these are computed", vec![false; rows.len()])
}

/// The lines, dashed and without names of their own.
pub(super) fn line(rows: &[NaturalFrequency], x: &str, y: &str) -> Line {
    let mut names: Vec<(String, Arg)> = Vec::new();
    for r in rows {
        let key = format!("line {}", r.line);
        if names.iter().all(|n| n.0 != key) {
            names.push((key, Arg::default()));
        }
    }
    let line = Line::new(NAME, x, y).group("line").called(names).reference();
    line.solid_where("observed").meaning(Arg::default(), "natural frequency")
}

#[cfg(test)]
mod tests {
    use super::*;
    use laval_num::complex::c;

    /// A point that goes round one way is on that side, one along a line on both; points that hardly move do not decide.
    #[test]
    fn sides_are_those_of_the_points_that_move() {
        let circle = |f: f64, b: f64| [c(f, 0.0), c(0.0, b)];
        let sides = |motion: &[[C64; 2]]| [1, -1].map(|side| goes_round(motion, side));
        assert_eq!(sides(&[circle(1.0, 0.1)]), [true, false]);
        assert_eq!(sides(&[circle(0.1, 1.0)]), [false, true]);
        assert_eq!(sides(&[circle(1.0, 1.0)]), [true, true]);
        assert_eq!(sides(&[circle(1.0, 0.0), circle(0.0, 0.5)]), [true, true]);
        assert_eq!(sides(&[circle(1.0, 0.0), circle(0.0, 1e-4)]), [true, false]);
    }
}
