//! Where and how a branch of periodic motions loses or regains stability away from its folds.
//!
//! Along a branch the number of exponents that grow changes where one of them, or a pair, crosses the imaginary axis. With the exponents in order of
//! growth the k-th growth rate is a continuous function of the arclength: its zero is located on corrected points, like any special point. What happens
//! there is recognised by the multiplier over the part of the period that the symmetry of the motion repeats (turned back by that symmetry):
//!
//! | multiplier | over the whole period | event |
//! | --- | --- | --- |
//! | +1 | +1 | fold; away from a fold a branch point: states of the same symmetry cross |
//! | -1, motion symmetric | +1 | symmetry breaking: a pair of less symmetric states branches off |
//! | -1, motion without symmetry | -1 | period doubling: a motion of twice the period branches off |
//! | a complex pair | a complex pair | Neimark-Sacker: a second frequency appears beside the spin |
//!
//! Branches assessed on Hill's determinant, whose decaying exponents are not all known: `crate::harmonic::branches::on_determinant`.
//!
//! Theory: `docs/theory/harmonic-balance.md#bifurcations`.

use crate::harmonic::balance::problem::Balance;
use crate::harmonic::branches::branch::Assessor;
use crate::harmonic::stability::floquet::{Exponents, Method};
use laval_num::complex::C64;
use laval_num::continuation::{Point, Settings, Special, Status, zero_between};
use laval_num::order::SortByNumber;
use serde::{Deserialize, Serialize};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// What happens to the states where stability changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Event {
    /// States of the same symmetry and period cross.
    BranchPoint,
    /// States of less symmetry branch off.
    SymmetryBreaking,
    /// States of twice the period branch off.
    PeriodDoubling,
    /// A motion of two frequencies branches off.
    NeimarkSacker,
}

impl Event {
    /// The field's term.
    pub fn name(self) -> &'static str {
        match self {
            Event::BranchPoint => "branch point",
            Event::SymmetryBreaking => "symmetry breaking",
            Event::PeriodDoubling => "period doubling",
            Event::NeimarkSacker => "Neimark-Sacker",
        }
    }
}

/// Loss or gain of stability away from folds.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Change {
    /// What it is.
    pub event: Event,
    /// Spin speed, rad/s.
    pub speed: f64,
    /// Speeds of corrected points on both sides along the branch, rad/s.
    pub bracket: (f64, f64),
    /// The exponent that crosses, 1/s.
    pub exponent: C64,
    /// Frequency of the disturbance, rad/s: of the aliases that the map leaves open the one nearest to a frequency of the machine linearised about the
    /// mean of the motion.
    pub frequency: f64,
    /// Growth rate left at the place, 1/s: how well it is located.
    pub growth: f64,
    /// Exponents that grow before and after it along the branch.
    pub unstable: (usize, usize),
    /// Parts of the period that the multiplier belongs to: 2 where the motion repeats itself turned by half a turn, 4 by a quarter.
    pub parts: usize,
    /// It lies between this point of the branch and the next.
    pub after: usize,
    /// The point itself, with the tangent of the branch.
    pub point: Point,
    /// The growth rate was followed to its zero (else only the bracket is certain).
    pub located: bool,
}

/// Changes located on a branch at most: where exponents are rounding they cross without end.
pub(in crate::harmonic) const MOST_CHANGES: usize = 40;

/// A multiplier this near to the real axis, in rad, is real.
const REAL: f64 = 1e-6;

/// The angle by which the multiplier over the repeated part turns, rad, from -pi to pi; `None` where a pair is complex whatever the period.
fn angle(exponent: C64, exponents: &Exponents, speed: f64) -> Option<f64> {
    if exponents.span == 0.0 {
        return (exponent.im.abs() <= 1e-9 * speed.abs()).then_some(0.0);
    }
    let turned = (exponent.im * exponents.span).rem_euclid(TAU);
    Some(if turned > PI { turned - TAU } else { turned })
}

/// Parts of the base period that the map covers once.
fn parts(exponents: &Exponents, balance: &Balance, speed: f64) -> usize {
    let period = TAU * balance.terms.divisor as f64 / speed.abs();
    if exponents.span > 0.0 { (period / exponents.span).round() as usize } else { 1 }
}

fn event(exponent: C64, exponents: &Exponents, balance: &Balance, speed: f64) -> Event {
    match angle(exponent, exponents, speed) {
        Some(a) if a.abs() <= REAL => Event::BranchPoint,
        Some(a) if PI - a.abs() <= REAL && parts(exponents, balance, speed) > 1 => Event::SymmetryBreaking,
        Some(a) if PI - a.abs() <= REAL => Event::PeriodDoubling,
        _ => Event::NeimarkSacker,
    }
}

/// Frequency of a disturbance of this exponent, rad/s.
pub(in crate::harmonic) fn frequency(
    assessor: &mut Assessor,
    balance: &mut Balance,
    exponent: C64,
    exponents: &Exponents,
    speed: f64,
) -> f64 {
    let own = exponent.im;
    match exponents.method {
        Method::Mean | Method::Determinant => own.abs(),
        // seen from the rotating frame
        Method::Rotating => nearest(assessor, balance, speed, &[own + speed, speed - own]),
        Method::Map => {
            let turn = match parts(exponents, balance, speed) {
                4 if balance.terms.divisor % 4 == 3 => -FRAC_PI_2,
                4 => FRAC_PI_2,
                2 => PI,
                _ => 0.0,
            } * speed.signum();
            let spacing = TAU / exponents.span;
            let alias = |k: i32, sign: f64| sign * own + turn / exponents.span + f64::from(k) * spacing;
            let all: Vec<f64> = (-40..=40).flat_map(|k| [alias(k, 1.0), alias(k, -1.0)]).collect();
            nearest(assessor, balance, speed, &all)
        }
    }
}

/// The candidate nearest to a frequency of the machine linearised about the mean motion, as a size.
fn nearest(assessor: &mut Assessor, balance: &mut Balance, speed: f64, candidates: &[f64]) -> f64 {
    let Some(own) = assessor.stability.as_mut().and_then(|s| s.mean_frequencies(balance, speed)) else { return f64::NAN };
    let distance = |w: f64| own.iter().map(|o| (o.abs() - w.abs()).abs()).fold(f64::INFINITY, f64::min);
    candidates.iter().map(|w| w.abs()).min_by(|a, b| distance(*a).total_cmp(&distance(*b))).unwrap_or(f64::NAN)
}

/// Growth rates in descending order, less their error; where a `fold` lies beside the point, without its own exponent (the one of multiplier +1 nearest
/// to zero).
fn growths(exponents: &Exponents, fold: bool, speed: f64) -> Vec<C64> {
    let mut values = exponents.descending();
    if fold {
        let still = |z: &C64| angle(*z, exponents, speed).is_some_and(|a| a.abs() <= REAL);
        let own = values.iter().enumerate().filter(|(_, z)| still(z)).min_by(|a, b| a.1.re.abs().total_cmp(&b.1.re.abs()));
        if let Some(i) = own.map(|(i, _)| i) {
            values.remove(i);
        }
    }
    values.iter_mut().for_each(|z| z.re -= exponents.error);
    values
}

fn count(values: &[C64]) -> usize {
    values.iter().take_while(|z| z.re > 0.0).count()
}

/// Changes between neighbouring points `a` and `b` of a branch, the first of which is number `after`; with a `fold` between them at these unknowns, the
/// fold's own crossing is left out, and so are others at the very same point (planes that fold together).
pub(in crate::harmonic) fn changes_between(
    assessor: &mut Assessor,
    balance: &mut Balance,
    [a, b]: [(&Point, &Exponents); 2],
    after: usize,
    fold: Option<&Special>,
    settings: &Settings,
    out: &mut Vec<Change>,
) {
    let speed = a.0.p;
    let (before, then) = (growths(a.1, fold.is_some(), speed), growths(b.1, fold.is_some(), speed));
    let (from, to) = (count(&before).min(count(&then)), count(&before).max(count(&then)));
    let ascending = count(&before) < count(&then);
    let mut found: Vec<Change> = Vec::new();
    for k in from..to {
        if out.len() + found.len() >= MOST_CHANGES {
            break;
        }
        // a pair crosses at one point
        let same = |v: &[C64]| k > from && (v[k].re - v[k - 1].re).abs() <= 1e-6 * v[k].abs();
        if let Some(last) = found.last_mut().filter(|_| same(&before) && same(&then)) {
            if ascending {
                last.unstable.1 += 1
            } else {
                last.unstable.0 += 1
            }
            continue;
        }
        let ends = [before[k].re, then[k].re];
        let special = zero_between(balance, [a.0, b.0], ends, settings, |balance, point| {
            let state = assessor.state(balance, &point.x, point.p);
            state.exponents.and_then(|e| growths(&e, fold.is_some(), point.p).get(k).copied()).map_or(f64::NAN, |z| z.re)
        });
        let Ok(special) = special else { continue };
        // motions and their exponents agree to what the orders kept leave out
        let slack = assessor.state(balance, &special.point.x, special.point.p).truncation;
        let at_fold = fold.is_some_and(|f| near(&f.point, &special.point, balance, slack));
        let twin = found.last().is_some_and(|c| near(&c.point, &special.point, balance, 0.0));
        if at_fold || twin {
            if let Some(c) = found.last_mut().filter(|_| twin) {
                if ascending { c.unstable.1 += 1 } else { c.unstable.0 += 1 }
            }
            continue;
        }
        let unstable = if ascending { (k, k + 1) } else { (k + 1, k) };
        found.extend(described(assessor, balance, &special, k, fold.is_some(), unstable, after));
    }
    found.sort_by_number(|a| a.point.s);
    out.extend(found);
}

fn described(
    assessor: &mut Assessor,
    balance: &mut Balance,
    special: &Special,
    k: usize,
    fold: bool,
    unstable: (usize, usize),
    after: usize,
) -> Option<Change> {
    let point = special.point.clone();
    let exponents = assessor.state(balance, &point.x, point.p).exponents?;
    let exponent = growths(&exponents, fold, point.p).get(k).copied()?;
    Some(Change {
        event: event(exponent, &exponents, balance, point.p),
        speed: point.p,
        bracket: (special.bracket[0].p.min(special.bracket[1].p), special.bracket[0].p.max(special.bracket[1].p)),
        exponent,
        frequency: frequency(assessor, balance, exponent, &exponents, point.p),
        growth: exponent.re,
        parts: parts(&exponents, balance, point.p),
        unstable,
        after,
        located: special.status != Status::Bracketed,
        point,
    })
}

/// The same point but for what location leaves open, and a relative `slack`.
pub(in crate::harmonic) fn near(a: &Point, b: &Point, balance: &Balance, slack: f64) -> bool {
    let scaled = |x: &[f64]| x.iter().zip(balance.scales()).map(|(x, s)| x / s).collect::<Vec<f64>>();
    let (x, y) = (scaled(&a.x), scaled(&b.x));
    let size = x.iter().fold(1.0, |m: f64, x| m.max(x.abs()));
    let limit = (1e-4 + slack.sqrt()) * size;
    // beside a fold unknowns move with the root of the speed
    (a.p - b.p).abs() <= (1e-7 + 0.1 * slack) * a.p.abs() && x.iter().zip(&y).all(|(x, y)| (x - y).abs() <= limit)
}
