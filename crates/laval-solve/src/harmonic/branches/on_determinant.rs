//! Changes of stability of a branch that is assessed by Hill's determinant ([`crate::harmonic::stability::determinant`]).
//!
//! Only the exponents that grow are counted there. One of those that one of two neighbouring points has and the other has not is followed, by Newton's method on the
//! determinant, to the point without it, and further along the branch where it grows there still, slower than what can be counted. Where it decays the imaginary axis lies
//! between: its growth rate is a continuous function of the arclength, whose zero is located on corrected points. Where it cannot be followed the count takes its place.
//!
//! What happens there is recognised by the disturbance itself, whose orders say how it is turned by the symmetry of the motion
//! ([`crate::harmonic::branches::bifurcation`] has the table).

use crate::harmonic::balance::problem::Balance;
use crate::harmonic::branches::bifurcation::{Change, Event, MOST_CHANGES, near};
use crate::harmonic::branches::branch::{Assessor, State};
use crate::harmonic::stability::determinant::{Shape, margin};
use crate::harmonic::stability::floquet::Exponents;
use crate::symmetry::Symmetry;
use laval_num::complex::C64;
use laval_num::continuation::{Branch, Kind, Point, Settings, Special, Status, Zero, zero_between};
use laval_num::order::SortByNumber;
use std::f64::consts::{PI, TAU};

/// An exponent is followed from point to point as long as it moves by no more than this part of the base frequency.
const FOLLOWED: f64 = 0.2;
/// Points of a branch along which an exponent is followed to the axis beyond the two where the count changes.
const FURTHER: usize = 40;
/// Exponents whose growth rates differ by less, over their size, cross together.
const TOGETHER: f64 = 1e-6;
/// A part of a base frequency that is none: exponents settle to less.
const NONE: f64 = 1e-7;

fn base(balance: &Balance, speed: f64) -> f64 {
    speed.abs() / balance.terms.divisor as f64
}

/// A real multiplier of +1 or -1 has a whole or half number of base frequencies.
fn multiple(z: C64, base: f64) -> f64 {
    let turns = z.im / base;
    turns - turns.round()
}

/// Exponents that grow, in descending order.
fn growing(e: &Exponents) -> Vec<C64> {
    e.descending().into_iter().filter(|z| !(z.re <= e.error)).collect()
}

/// Those of both sides without the one that crosses at a fold between them: of the real ones, of which one side has one more, the nearest to zero.
fn without_folds([mut a, mut b]: [Vec<C64>; 2], base: f64) -> [Vec<C64>; 2] {
    let real = |v: &[C64]| v.iter().filter(|z| multiple(**z, base).abs() <= NONE).count();
    let drop = |v: &mut Vec<C64>| {
        if let Some(i) = v.iter().rposition(|z| multiple(*z, base).abs() <= NONE) {
            v.remove(i);
        }
    };
    match (real(&a), real(&b)) {
        (m, n) if m > n => drop(&mut a),
        (m, n) if m < n => drop(&mut b),
        _ => {}
    }
    [a, b]
}

/// Where the growth of one exponent vanishes.
struct Place {
    special: Special,
    exponent: C64,
    after: usize,
}

/// Where the exponent may be at arclength `s`, from those `known` (arclength, exponent): on the line through the neighbours, then at the nearer of them, then
/// at the other. Newton's method may leave one of them for another exponent.
fn guesses(known: &[(f64, C64)], s: f64) -> Vec<C64> {
    let nearest =
        |side: &dyn Fn(f64) -> bool| known.iter().filter(|k| side(k.0)).min_by(|a, b| (a.0 - s).abs().total_cmp(&(b.0 - s).abs())).copied();
    let mut sides: Vec<(f64, C64)> = [nearest(&|a| a < s), nearest(&|a| a >= s)].into_iter().flatten().collect();
    sides.sort_by(|a, b| (a.0 - s).abs().total_cmp(&(b.0 - s).abs()));
    let line = match sides[..] {
        [a, b] => Some(a.1 + (b.1 - a.1).scale((s - a.0) / (b.0 - a.0))),
        _ => None,
    };
    line.into_iter().chain(sides.iter().map(|k| k.1)).collect()
}

/// One branch and what assesses it.
struct Search<'a, 'b, 'c> {
    assessor: &'a mut Assessor,
    balance: &'a mut Balance<'b>,
    points: &'c [Point],
    settings: &'c Settings,
}

impl Search<'_, '_, '_> {
    fn followed(&mut self, at: &Point, start: C64) -> Option<C64> {
        let within = FOLLOWED * base(self.balance, at.p);
        self.assessor.followed(self.balance, &at.x, at.p, (start, within))
    }

    /// The zero of the growth between points `i` and `i + 1`, of the exponent that is `ends` there.
    fn between(&mut self, i: usize, ends: [C64; 2]) -> Option<Place> {
        let (a, b) = (&self.points[i], &self.points[i + 1]);
        let mut known = vec![(a.s, ends[0]), (b.s, ends[1])];
        let (assessor, settings) = (&mut *self.assessor, self.settings);
        let special = zero_between(self.balance, [a, b], ends.map(|z| z.re), settings, |balance, point| {
            let within = FOLLOWED * base(balance, point.p);
            let mut starts = guesses(&known, point.s).into_iter();
            let Some(z) = starts.find_map(|z| assessor.followed(balance, &point.x, point.p, (z, within))) else { return f64::NAN };
            known.push((point.s, z));
            z.re
        });
        let special = special.ok()?;
        let exponent = guesses(&known, special.point.s).into_iter().find_map(|z| self.followed(&special.point, z))?;
        Some(Place { special, exponent, after: i })
    }

    /// The same by the count alone: where the `k`-th exponent ceases to grow.
    fn counted(&mut self, i: usize, k: usize, ends: [f64; 2]) -> Option<Place> {
        let (a, b) = (&self.points[i], &self.points[i + 1]);
        let (assessor, settings) = (&mut *self.assessor, self.settings);
        let size = ends[0].abs().max(ends[1].abs());
        let mut last = None;
        // on the axis nothing can be counted: no reason to call the branch unassessed
        let unassessed = assessor.unassessed.clone();
        let special = zero_between(self.balance, [a, b], ends, settings, |balance, point| {
            let Some(e) = assessor.state(balance, &point.x, point.p).exponents else { return f64::NAN };
            // where it decays only that is known
            growing(&e).get(k).map_or(-1e-3 * size, |&z| {
                last = Some(z);
                z.re
            })
        });
        self.assessor.unassessed = unassessed;
        let special = special.ok()?;
        let exponent = last.and_then(|z| self.followed(&special.point, z)).or(last)?;
        Some(Place { special: Special { status: Status::Bracketed, ..special }, exponent, after: i })
    }

    /// Where the `k`-th exponent `z`, which grows at the latter of points `i` and `j` (`ascending`) or the former, begins to.
    fn place(&mut self, (i, j): (usize, usize), ascending: bool, k: usize, z: C64) -> Option<Place> {
        let many = if ascending { j } else { i };
        let mut here = (many, z);
        for _ in 0..=FURTHER {
            let next = if ascending { here.0.checked_sub(1)? } else { here.0 + 1 };
            let point = self.points.get(next)?;
            if self.balance.cancelled() {
                return None;
            }
            let Some(there) = self.followed(point, here.1) else { break };
            if there.re <= 0.0 {
                let (first, ends) = if ascending { (next, [there, here.1]) } else { (here.0, [here.1, there]) };
                return self.between(first, ends);
            }
            here = (next, there);
        }
        let speed = self.points[many].p;
        let known = margin(&self.balance.system.domains(speed), speed) == 0.0;
        // where slow growth is not counted the count does not change on the axis
        (known && here.0 == many).then(|| self.counted(i, k, if ascending { [-1e-3 * z.re, z.re] } else { [z.re, -1e-3 * z.re] })).flatten()
    }
}

/// The disturbance over the part of the period that the symmetry of the motion repeats, turned back: angle of its multiplier, rad, from -pi to pi, and the
/// number of these parts.
fn turned(balance: &Balance, shape: &Shape, z: C64, speed: f64) -> Option<(f64, usize)> {
    let parts = balance.terms.symmetry.order().max(1);
    let step = TAU / parts as f64 * speed.signum();
    let (sin, cos) = (step * balance.terms.divisor as f64).sin_cos();
    let (mut sum, mut size) = (C64::zero(), 0.0);
    for (order, x) in shape {
        let later = C64::cis(step * *order as f64);
        let mut i = 0;
        while i < x.len() {
            let pair = balance.nonlinear.kinds[i].leads_pair() && i + 1 < x.len();
            let [a, b] = [x[i], if pair { x[i + 1] } else { C64::zero() }];
            let image = if pair { [a.scale(cos) - b.scale(sin), a.scale(sin) + b.scale(cos)] } else { [a, b] };
            for (moved, x) in image.into_iter().zip([a, b]) {
                sum += moved.conj() * (x * later);
                size += x.norm_sqr();
            }
            i += if pair { 2 } else { 1 };
        }
    }
    // a root of one: a disturbance that is none belongs to several
    let of_one = sum.scale(1.0 / size);
    if !((of_one.abs() - 1.0).abs() <= 1e-3) {
        return None;
    }
    let root = (of_one.arg() / TAU * parts as f64).round() * TAU / parts as f64;
    let span = TAU / base(balance, speed) / parts as f64;
    let angle = (z.im * span + root).rem_euclid(TAU);
    Some((if angle > PI { angle - TAU } else { angle }, parts))
}

/// What happens, and the parts of the period it is recognised by.
fn event(balance: &Balance, shape: Option<&Shape>, z: C64, speed: f64) -> (Event, usize) {
    let base = base(balance, speed);
    if balance.terms.symmetry == Symmetry::Circular {
        let still = multiple(z, base).abs() <= NONE;
        return (if still { Event::BranchPoint } else { Event::NeimarkSacker }, 1);
    }
    let whole = TAU * multiple(z, base);
    let (angle, parts) = shape.and_then(|s| turned(balance, s, z, speed)).unwrap_or((whole, 1));
    let small = TAU * NONE;
    let event = match angle.abs() {
        a if a <= small => Event::BranchPoint,
        a if PI - a <= small && parts > 1 => Event::SymmetryBreaking,
        a if PI - a <= small => Event::PeriodDoubling,
        _ => Event::NeimarkSacker,
    };
    (event, parts)
}

/// Frequency of the order that moves most, rad/s.
fn frequency(balance: &Balance, shape: Option<&Shape>, z: C64, speed: f64) -> f64 {
    let size = |x: &[C64]| x.iter().map(|z| z.norm_sqr()).sum::<f64>();
    let most = shape.and_then(|s| s.iter().max_by(|a, b| size(&a.1).total_cmp(&size(&b.1))));
    let signed = speed / balance.terms.divisor as f64;
    most.map_or(f64::NAN, |(order, _)| (z.im + *order as f64 * signed).abs())
}

/// Changes between points `i` and `j` of a branch, neighbours among those that could be assessed.
pub(in crate::harmonic) fn changes_between(
    assessor: &mut Assessor,
    balance: &mut Balance,
    (branch, states): (&Branch, &[State]),
    (i, j): (usize, usize),
    settings: &Settings,
    out: &mut Vec<Change>,
) {
    let (Some(a), Some(b)) = (&states[i].exponents, &states[j].exponents) else { return };
    let fold = branch.of(Kind::Fold).chain(branch.of(Kind::ParameterExtremum)).find(|s| (i..j).contains(&s.after));
    let width = base(balance, states[i].speed);
    let sides = [growing(a), growing(b)];
    let [before, then] = if fold.is_some() { without_folds(sides, width) } else { sides };
    let ascending = before.len() < then.len();
    let (few, many) = if ascending { (&before, &then) } else { (&then, &before) };
    let mut search = Search { assessor, balance, points: &branch.points[..states.len()], settings };
    let mut found: Vec<Change> = Vec::new();
    for k in few.len()..many.len() {
        if out.len() + found.len() >= MOST_CHANGES || search.balance.cancelled() {
            break;
        }
        // a pair crosses at one point
        let same = k > few.len() && (many[k].re - many[k - 1].re).abs() <= TOGETHER * many[k].abs();
        if let Some(last) = found.last_mut().filter(|_| same) {
            if ascending {
                last.unstable.1 += 1
            } else {
                last.unstable.0 += 1
            }
            continue;
        }
        let Some(place) = search.place((i, j), ascending, k, many[k]) else { continue };
        let point = place.special.point.clone();
        search.balance.sample(&point.x, point.p);
        let slack = search.balance.truncation();
        let met = |c: &Change, slack: f64| near(&c.point, &point, search.balance, slack);
        if fold.is_some_and(|f| near(&f.point, &point, search.balance, slack)) || found.iter().chain(&*out).any(|c| met(c, 0.0)) {
            continue;
        }
        let shape = search.assessor.shape(search.balance, &point.x, point.p, place.exponent);
        let (event, parts) = event(search.balance, shape.as_ref(), place.exponent, point.p);
        let bracket = place.special.bracket.map(|s| s.p);
        found.push(Change {
            event,
            speed: point.p,
            bracket: (bracket[0].min(bracket[1]), bracket[0].max(bracket[1])),
            exponent: place.exponent,
            frequency: frequency(search.balance, shape.as_ref(), place.exponent, point.p),
            growth: place.exponent.re,
            unstable: if ascending { (k, k + 1) } else { (k + 1, k) },
            parts,
            after: place.after,
            located: place.special.status != Status::Bracketed,
            point,
        });
    }
    found.sort_by_number(|a| a.point.s);
    out.extend(found);
}

#[cfg(test)]
mod tests {
    use super::*;
    use laval_num::complex::c;

    #[test]
    fn an_exponent_is_looked_for_between_the_places_beside() {
        let known = [(0.0, c(-1.0, 10.0)), (4.0, c(3.0, 14.0)), (1.0, c(0.0, 11.0))];
        assert_eq!(guesses(&known, 2.0), [c(1.0, 12.0), c(0.0, 11.0), c(3.0, 14.0)]);
        // at a place that is known, and beyond all of them, the nearest stands first or alone
        assert_eq!(guesses(&known, 1.0)[..2], [c(0.0, 11.0), c(0.0, 11.0)]);
        assert_eq!(guesses(&known, 5.0), [c(3.0, 14.0)]);
        assert!(guesses(&[], 1.0).is_empty());
    }

    #[test]
    fn the_exponent_of_a_fold_is_left_out_of_the_side_that_has_it() {
        let of = |values: &[(f64, f64)]| values.iter().map(|&(a, b)| c(a, b)).collect::<Vec<C64>>();
        let (pair, real) = ([(3.0, 2.0), (3.0, -2.0)], (0.1, 1e-9));
        let [a, b] = without_folds([of(&pair), of(&[pair[0], pair[1], real])], 10.0);
        assert_eq!((a.len(), b.len()), (2, 2));
        let [a, b] = without_folds([of(&[(5.0, 0.0), real]), of(&[(5.0, 0.0)])], 10.0);
        assert_eq!((a, b), (of(&[(5.0, 0.0)]), of(&[(5.0, 0.0)])));
        // with a pair that crosses as well the pair is left
        let [a, b] = without_folds([of(&[real]), of(&pair)], 10.0);
        assert_eq!((a.len(), b.len()), (0, 2));
    }
}
