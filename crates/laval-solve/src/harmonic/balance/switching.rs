//! Nonlinear parts whose law switches along the motion (a contact that closes and opens), projected onto the harmonics without sampling error.
//!
//! Equally spaced samples see such a law change only when one of them crosses the surface: the sampled balance has as many corners as
//! samples, and no number of samples is exact. Here the places of the period where a law switches are located, and the projection
//!
//! ```text
//! coefficient = 1/L integral over the repeated part, of length L, of row(tau) times synthesis(tau)
//! ```
//!
//! is integrated between them by Gauss's rule in panels, stretched like a square towards a switch so that forces like `u^(1/2)` and `u^(3/2)` are smooth in
//! the variable of integration. The balance then depends on its unknowns as smoothly as the exact one. A force that jumps at the switch adds
//! the jump times the motion of the switch to the tangents.

use crate::harmonic::balance::fourier::{Coefficients, Into, motion_at, turns};
use crate::harmonic::balance::nonlinear::{Member, Sampled};
use crate::harmonic::balance::pace::Pace;
use crate::harmonic::balance::terms::Terms;
use crate::model::system::System;
use laval_num::complex::C64;
use laval_num::dense::Mat;
use laval_num::order::SortByNumber;
use laval_num::quadrature::gauss;
use laval_num::univariate::bracket;
use std::f64::consts::TAU;

/// Points of Gauss's rule in a panel.
const POINTS: usize = 12;
/// Angle by which the fastest factor of the integrand turns over a panel, at most: the rule is exact to rounding for it.
const PANEL: f64 = 12.0;
/// Way in base phase to either side of a switch over which a force is seen to jump.
const NEAR: f64 = 1e-9;
/// Way in base phase from a switch at which other surfaces are seen beside it.
const BESIDE: f64 = 1e-7;

/// A place of the period where a law switches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event {
    /// Base phase.
    pub tau: f64,
    member: usize,
    surface: usize,
}

/// The switching parts of a machine, and where their laws switched at the last evaluation.
#[derive(Default)]
pub struct Switching {
    members: Vec<Member>,
    /// Switches of the last evaluation, ascending over the repeated part of the period.
    pub events: Vec<Event>,
    rule: Vec<(f64, f64)>,
    gain: Vec<f64>,
    point: Sampled,
    turns: Vec<C64>,
    u: [Vec<f64>; 3],
    surfaces: Vec<f64>,
    seen: Coefficients,
}

impl Switching {
    /// Of parts that state surfaces where their law changes; takes these out of `members`.
    pub fn new(system: &System, terms: &Terms, members: &mut Vec<Member>) -> Switching {
        let mut s = Switching { rule: gauss(POINTS), gain: vec![0.0; terms.unknowns], ..Switching::default() };
        for &(term, at) in &terms.list {
            s.gain[at..at + term.size()].fill(term.gain());
        }
        // circular motion sees one state of a law all along
        if terms.symmetry.order() == 0 {
            return s;
        }
        let (x, pace) = (vec![0.0; terms.unknowns], Pace::forced(1.0, terms.divisor));
        for k in (0..members.len()).rev() {
            s.members.push(members[k].clone());
            s.state(terms, &x, 0.0, pace);
            let last = s.members.len() - 1;
            if s.surfaces_of(system, terms, last, 0.0, pace).is_empty() {
                s.members.pop();
            } else {
                members.remove(k);
            }
        }
        s
    }

    /// Whether there is any such part.
    pub fn is_empty(&self) -> bool {
        self.members.is_empty()
    }

    /// Length of the repeated part of the period.
    fn length(terms: &Terms) -> f64 {
        TAU / terms.symmetry.order().max(1) as f64
    }

    /// Motion at a base phase.
    fn state(&mut self, terms: &Terms, x: &[f64], tau: f64, pace: Pace) {
        turns(tau, terms.harmonics, &mut self.turns);
        motion_at(terms, x, pace.frequency, &self.turns, &mut self.u);
    }

    fn surfaces_of(&mut self, system: &System, terms: &Terms, member: usize, tau: f64, pace: Pace) -> &[f64] {
        let [q, v, a] = &self.u;
        self.point.switches_at(system, &self.members[member], terms, tau, [q, v, a], pace, &mut self.surfaces);
        &self.surfaces
    }

    /// Locates the switches of the motion `x` at base phases from `start` to `start + length`.
    fn locate(&mut self, system: &System, terms: &Terms, x: &[f64], pace: Pace, (start, length): (f64, f64)) {
        self.events.clear();
        let count = (terms.samples as f64 * length / Self::length(terms)).round() as usize;
        let h = length / count as f64;
        for member in 0..self.members.len() {
            let mut seen: Vec<Vec<f64>> = Vec::with_capacity(count + 3);
            // one step more on both sides, to see a law that hardly switches at an end
            for j in 0..count + 3 {
                let tau = start + (j as f64 - 1.0) * h;
                self.state(terms, x, tau, pace);
                seen.push(self.surfaces_of(system, terms, member, tau, pace).to_vec());
            }
            let surfaces = seen.iter().map(Vec::len).min().unwrap_or(0);
            let of = |s: &mut Self, surface: usize, tau: f64| {
                s.state(terms, x, tau, pace);
                s.surfaces_of(system, terms, member, tau, pace).get(surface).copied().unwrap_or(f64::NAN)
            };
            let mut roots = Vec::new();
            for surface in 0..surfaces {
                for j in 1..count + 2 {
                    let (a, b, c) = (seen[j - 1][surface], seen[j][surface], seen[j + 1][surface]);
                    let tau = start + (j as f64 - 1.0) * h;
                    if (b < 0.0) != (c < 0.0) && j <= count {
                        roots.push((root(|t| of(self, surface, t), [tau, tau + h], [b, c]), surface));
                    }
                    // between samples of one sign the law may switch there and back: at the vertex of the parabola through three
                    let bend = a - 2.0 * b + c;
                    let same = (a < 0.0) == (b < 0.0) && (b < 0.0) == (c < 0.0);
                    if same && b != 0.0 && bend * b > 0.0 && (c - a).abs() <= bend.abs() {
                        let (at, value) = vertex(|t| of(self, surface, t), tau, h, [a, b, c]);
                        if (value < 0.0) != (b < 0.0) {
                            roots.push((root(|t| of(self, surface, t), [tau - h, at], [a, value]), surface));
                            roots.push((root(|t| of(self, surface, t), [at, tau + h], [value, c]), surface));
                        }
                    }
                }
            }
            // a surface may end at another one, between the same samples: seen beside that
            if surfaces > 1 {
                for (at, _) in roots.clone() {
                    let j = ((at - start) / h).floor().clamp(0.0, count as f64);
                    for [from, to] in [[start + j * h, at - BESIDE], [at + BESIDE, start + (j + 1.0) * h]] {
                        let [left, right] = [from, to].map(|tau| {
                            self.state(terms, x, tau, pace);
                            self.surfaces_of(system, terms, member, tau, pace).to_vec()
                        });
                        for surface in (0..surfaces).filter(|&k| from < to && (left[k] < 0.0) != (right[k] < 0.0)) {
                            roots.push((root(|t| of(self, surface, t), [from, to], [left[surface], right[surface]]), surface));
                        }
                    }
                }
            }
            let within = roots.into_iter().filter(|(t, _)| (start..start + length).contains(t));
            self.events.extend(within.map(|(tau, surface)| Event { tau, member, surface }));
        }
        self.events.sort_by_number(|a| a.tau);
        // two surfaces of a part met together, or one place seen from two sides
        self.events.dedup_by(|b, a| b.member == a.member && b.tau - a.tau <= 1e-12);
    }

    /// Adds the projections of all switching parts at a motion `x`.
    pub fn add(&mut self, system: &System, terms: &Terms, x: &[f64], pace: Pace, out: &mut Into) {
        if self.members.is_empty() {
            return;
        }
        let length = Self::length(terms);
        self.locate(system, terms, x, pace, (0.0, length));
        let tangents = out.jac.is_some() || out.speed.is_some();
        let frequency = pace.frequency;
        self.seen.clear(terms);
        let longest = PANEL / (2 * terms.harmonics + 4) as f64;
        let mut from = (0.0, false);
        let ends: Vec<(f64, bool)> = self.events.iter().map(|e| (e.tau, true)).chain([(length, false)]).collect();
        let rule = std::mem::take(&mut self.rule);
        for to in ends {
            let span = to.0 - from.0;
            let least = 1 + usize::from(from.1 && to.1);
            let panels = ((span / longest).ceil() as usize).max(least);
            let wide = span / panels as f64;
            for k in 0..panels {
                let start = from.0 + k as f64 * wide;
                for &(y, weight) in &rule {
                    let (at, stretched) = match () {
                        () if from.1 && k == 0 => (y * y, 2.0 * y),
                        () if to.1 && k + 1 == panels => (1.0 - y * y, 2.0 * y),
                        () => (y, 1.0),
                    };
                    let tau = start + at * wide;
                    turns(tau, if tangents { 2 } else { 1 } * terms.harmonics, &mut self.turns);
                    motion_at(terms, x, frequency, &self.turns, &mut self.u);
                    let [q, v, a] = &self.u;
                    self.point.eval_at(system, &self.members, terms, tau, [q, v, a], pace, tangents);
                    let share = weight * stretched * wide / length;
                    self.seen.add_rows(&self.point.rows, &self.turns, share);
                    if tangents {
                        let by = [0, 1, 2].map(|d| self.point.tangent(d));
                        self.seen.add_tangents(&self.point.rows_speed, by, &self.turns, share);
                    }
                }
            }
            from = to;
        }
        self.rule = rule;
        self.seen.project(terms, frequency, out);
        if tangents {
            self.add_jumps(system, terms, x, pace, out);
        }
    }

    /// Change of the rows at a switch, where the force jumps there.
    fn jump(&mut self, system: &System, terms: &Terms, x: &[f64], pace: Pace, event: Event) -> Option<Vec<f64>> {
        let mut change = |near: f64| {
            let [before, mut after] = [event.tau - near, event.tau + near].map(|tau| {
                self.state(terms, x, tau, pace);
                let [q, v, a] = &self.u;
                self.point.eval_at(system, &self.members[event.member..=event.member], terms, tau, [q, v, a], pace, false);
                self.point.rows.clone()
            });
            after.iter_mut().zip(&before).for_each(|(a, b)| *a -= b);
            after
        };
        let (jump, wide) = (change(NEAR), change(100.0 * NEAR));
        let size = |v: &[f64]| v.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        // a continuous force changes by more over a longer way: like its square root at least
        (size(&jump) > 0.5 * size(&wide)).then_some(jump)
    }

    /// Base phases from `start` to `start + length` where laws switch along the motion `x`, and the slot of a part whose force jumps there.
    pub fn places(&mut self, system: &System, terms: &Terms, x: &[f64], pace: Pace, span: (f64, f64)) -> (Vec<f64>, Option<usize>) {
        if self.members.is_empty() {
            return (Vec::new(), None);
        }
        self.locate(system, terms, x, pace, span);
        let events = self.events.clone();
        let jumping = events.iter().find(|&&e| self.jump(system, terms, x, pace, e).is_some());
        (events.iter().map(|e| e.tau).collect(), jumping.map(|e| self.members[e.member].slot))
    }

    /// Where rows jump at a switch: the jump times d tau / d unknowns, from the surface held at zero.
    fn add_jumps(&mut self, system: &System, terms: &Terms, x: &[f64], pace: Pace, out: &mut Into) {
        let length = Self::length(terms);
        let near = NEAR;
        let mut synthesis = [0; 3].map(|_| Mat::default());
        for event in self.events.clone() {
            let Some(jump) = self.jump(system, terms, x, pace, event) else { continue };
            terms.rows_at(event.tau, &mut synthesis);
            let surface = |s: &mut Self, tau: f64| s.surfaces_of(system, terms, event.member, tau, pace)[event.surface];
            self.state(terms, x, event.tau + near, pace);
            let later = surface(self, event.tau);
            self.state(terms, x, event.tau - near, pace);
            let rate = (later - surface(self, event.tau)) / (2.0 * near);
            // derivatives of the surface in coordinates and rates by central differences
            self.state(terms, x, event.tau, pace);
            let (m, w) = (terms.coordinates, pace.frequency);
            let mut by_unknown = vec![0.0; terms.unknowns];
            let mut by_speed = 0.0;
            for (d, factor) in [(0, 1.0), (1, w)] {
                let step = 1e-6 * self.u[d].iter().fold(0.0, |m: f64, u| m.max(u.abs()));
                for c in (0..m).filter(|_| step > 0.0) {
                    let own = self.u[d][c];
                    self.u[d][c] = own + step;
                    let plus = surface(self, event.tau);
                    self.u[d][c] = own - step;
                    let slope = (plus - surface(self, event.tau)) / (2.0 * step);
                    self.u[d][c] = own;
                    for (b, e) in by_unknown.iter_mut().zip(synthesis[d].row(c)) {
                        *b += slope * factor * e;
                    }
                    by_speed += if d == 1 { slope * own * pace.stretch() } else { 0.0 };
                }
            }
            for i in 0..terms.unknowns {
                let projected: f64 = (0..m).map(|c| self.gain[i] * synthesis[0][(c, i)] * jump[c]).sum::<f64>() / length;
                if let Some(jac) = &mut out.jac {
                    for (o, b) in jac.row_mut(i).iter_mut().zip(&by_unknown) {
                        *o += projected * b / rate;
                    }
                }
                if let Some(s) = &mut out.speed {
                    s[i] += projected * by_speed / rate;
                }
            }
        }
    }
}

/// Zero of `f` in a bracket with these end values.
fn root(f: impl FnMut(f64) -> f64, [a, b]: [f64; 2], [fa, fb]: [f64; 2]) -> f64 {
    bracket(a, fa, b, fb, f).map_or(b, |zero| zero.1)
}

/// Extremum towards zero of `f` between `tau - h` and `tau + h`, where it has these values; stops where the sign changes.
fn vertex(mut f: impl FnMut(f64) -> f64, tau: f64, mut h: f64, [mut a, mut b, mut c]: [f64; 3]) -> (f64, f64) {
    let (sign, mut at) = (b.signum(), tau);
    for _ in 0..6 {
        let shift = 0.5 * h * (a - c) / (a - 2.0 * b + c);
        let t = at + shift.clamp(-h, h);
        let value = f(t);
        if !(value * sign > 0.0) {
            return (t, value);
        }
        (at, b, h) = (t, value, 0.1 * h);
        (a, c) = (f(at - h), f(at + h));
        if !((a - 2.0 * b + c) * sign > 0.0) {
            break;
        }
    }
    (at, b)
}
