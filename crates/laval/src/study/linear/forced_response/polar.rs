//! Polar diagram of a linear response: forward amplitude and phase of the bodies as vectors from the axis, with speeds along the curve.

use super::{ForcedResponseResult, beside};
use crate::model::probe::Probe;
use crate::model::system::System;
use crate::outcome::{Arg, Axis, Figure, Line, Message, Panel, Points, Table, TableBuilder, Text};
use crate::study::shared::probes;
use crate::study::shared::support::probe_name;
use laval_num::complex::{C64, c};

/// Bodies drawn at most; those that move less than this share of the largest cannot be seen.
const BODIES: usize = 4;
const SEEN: f64 = 0.02;
/// Speeds marked at most, and their least distance over the size of the figure.
const MARKS: usize = 9;
const APART: f64 = 0.16;

/// The response as vectors.
pub(super) struct Polar<'a> {
    bodies: Vec<&'a Probe>,
    /// Speed, and the vector of every body, in the order of the speeds.
    rows: Vec<(f64, Vec<C64>)>,
    /// Rows that are marked.
    marks: Vec<usize>,
}

impl<'a> Polar<'a> {
    /// None of a response at one speed, without bound, or of bodies that only tilt.
    pub fn of(system: &'a System, result: &ForcedResponseResult) -> Option<Polar<'a>> {
        let curve = &result.curve;
        if curve.points.len() < 8 || !curve.poles().is_empty() {
            return None;
        }
        let vector = |p: &Probe, x: &[C64]| {
            let [a, b] = p.amplitudes(x);
            crate::solve::sectors::circular(a, b).0
        };
        let largest = |p: &Probe| curve.points.iter().map(|r| vector(p, &r.x).abs()).filter(|x| x.is_finite()).fold(0.0, f64::max);
        let mut bodies: Vec<(&Probe, f64)> = system.probes().iter().filter(|p| p.is_reference()).map(|p| (p, largest(p))).collect();
        let most = bodies.iter().map(|b| b.1).fold(0.0, f64::max);
        bodies.sort_by(|a, b| b.1.total_cmp(&a.1));
        bodies.retain(|b| b.1 > SEEN * most);
        bodies.truncate(BODIES);
        let bodies: Vec<&Probe> = bodies.into_iter().map(|b| b.0).collect();
        let first = *bodies.first()?;
        let mut rows: Vec<(f64, Vec<C64>)> = Vec::new();
        for r in &curve.points {
            rows.push((r.speed, bodies.iter().map(|p| vector(p, &r.x)).collect()));
        }
        for r in &result.orbits.between {
            rows.push((r.speed, bodies.iter().map(|p| vector(p, &r.x)).collect()));
        }
        let mut wanted = Vec::new();
        for a in &result.orbits.at {
            let of = |p: &&Probe| {
                let k = result.orbits.stations.all.iter().position(|s| s.body == p.name && p.is_at(s.height));
                k.map_or(C64::zero(), |k| a.motions[k][0])
            };
            rows.push((a.speed, bodies.iter().map(of).collect()));
            wanted.push(a.speed);
        }
        rows.retain(|r| r.1.iter().all(|z| z.is_finite()));
        rows.sort_by(|a, b| a.0.total_cmp(&b.0));
        rows.dedup_by(|a, b| a.0 == b.0);
        let marks = marks(&rows, &wanted, largest(first));
        Some(Polar { bodies, rows, marks })
    }

    pub fn table(&self) -> TableBuilder {
        let mut table = Table::new("polar", "Forward amplitudes as vectors from the axis, over the spin speed").float(
            "speed",
            "rad/s",
            "spin speed",
            self.rows.iter().map(|r| r.0).collect(),
        );
        for (k, p) in self.bodies.iter().enumerate() {
            let (n, part) = (probe_name(p), |f: fn(&C64) -> f64| self.rows.iter().map(|r| f(&r.1[k])).collect::<Vec<f64>>());
            table = table.float(format!("in_phase.{n}"), "m", "part along the key mark", part(|z| z.re)).float(
                format!("quadrature.{n}"),
                "m",
                "part a quarter turn ahead of the key mark",
                part(|z| z.im),
            );
        }
        let marked = (0..self.rows.len()).map(|i| if self.marks.contains(&i) { self.rows[i].1[0].im } else { f64::NAN }).collect();
        table.float("marked", "m", "quadrature of the first body at the speeds that the figure names; NaN elsewhere", marked)
    }

    pub fn figure(&self) -> Figure {
        let most = self.rows.iter().flat_map(|r| &r.1).map(|z| z.abs()).fold(0.0, f64::max);
        // beyond the curves there is room for the speeds beside them
        let ends = |part: fn(&C64) -> f64, below: f64, above: f64| {
            let all = self.rows.iter().flat_map(|r| &r.1).map(part);
            let (low, high) = all.fold((0.0f64, 0.0f64), |(a, b), x| (a.min(x), b.max(x)));
            (low - below * (high - low), high + above * (high - low))
        };
        let axis = |label: &'static str, (low, high): (f64, f64)| {
            let axis = Axis::new(label, "").metres(most);
            let factor = axis.factor;
            axis.range(factor * low, factor * high)
        };
        let (across, up) = (ends(|z| z.re, 0.25, 0.3), ends(|z| z.im, 0.12, 0.12));
        let mut panel = Panel::new(axis("quadrature, ahead of the key mark", up));
        for p in &self.bodies {
            let n = probe_name(p);
            panel = panel.mark(Line::new("polar", format!("in_phase.{n}"), format!("quadrature.{n}")).name(probes::label(p)).path());
        }
        let first = self.bodies.first().map_or(String::new(), |p| probe_name(p));
        panel = panel.mark(Points::new("polar", format!("in_phase.{first}"), "marked").small().name("speeds"));
        // as many digits as tell neighbours apart
        let mut speeds: Vec<f64> = self.marks.iter().map(|&i| self.rows[i].0.abs()).collect();
        speeds.sort_by(f64::total_cmp);
        let nearest = speeds.windows(2).map(|w| (w[1] - w[0]) / w[1]).filter(|d| *d > 0.0).fold(1.0, f64::min);
        let digits = (1.0 - nearest.log10()).ceil().clamp(4.0, 7.0) as u8;
        let marked: Vec<C64> = self.marks.iter().map(|&i| self.rows[i].1[0]).collect();
        let curves: Vec<Vec<C64>> = (0..self.bodies.len()).map(|k| self.rows.iter().map(|r| r.1[k]).collect()).collect();
        let words = beside::places(&marked, &curves, c(across.0, up.0), c(across.1, up.1));
        for (&i, z) in self.marks.iter().zip(words) {
            panel = panel.mark(Text::new(z.re, z.im, Arg::speed(self.rows[i].0).digits(digits)));
        }
        let alt = Message::new("polar-alt").arg("bodies", Arg::count(self.bodies.len()));
        let x = axis("in phase with the key mark", across);
        Figure::new("polar", "Polar diagram", alt).x(x).panel(panel).equal()
    }
}

/// Rows to mark: the speeds wanted, then others far from those already marked.
fn marks(rows: &[(f64, Vec<C64>)], wanted: &[f64], size: f64) -> Vec<usize> {
    let mut out: Vec<usize> = Vec::new();
    let near = |i: usize, out: &[usize], apart: f64| out.iter().any(|&j| (rows[i].1[0] - rows[j].1[0]).abs() < apart * size);
    for w in wanted {
        if let Some(i) = rows.iter().position(|r| r.0 == *w).filter(|&i| !near(i, &out, 0.5 * APART)) {
            out.push(i);
        }
    }
    for (i, r) in rows.iter().enumerate() {
        if out.len() < MARKS && !near(i, &out, APART) && r.1[0].abs() > 0.05 * size {
            out.push(i);
        }
    }
    out.sort_unstable();
    out
}
