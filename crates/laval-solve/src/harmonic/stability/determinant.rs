//! Stability of a periodic motion of a machine with parts that have no time form: zeros of Hill's determinant, counted.
//!
//! A disturbance `exp(L t) sum_n x_n exp(i n w t)` of a motion with base frequency w obeys, at every order n,
//!
//! ```text
//! Z(L + i n w) x_n + B^T sum_m [ T_(n-m) + (L + i m w) R_(n-m) ] B x_m = 0
//! ```
//!
//! with the exact dynamic stiffness Z of the linear parts and the Fourier coefficients T, R of the tangents of the nonlinear ones. With a reference stiffness S on
//! the nonlinear coordinates, `Y = Z + B^T S B` and `G_n = B Y(L + i n w)^-1 B^T`, the determinant is the product of all `det Y(L + i n w)` and of `det(1 + G (T - S))`, which
//! tends to one as orders are added.
//!
//! Exponents repeat with i w, so that one strip of the width w holds all of them. The number of those that grow is counted by the argument principle, right of the margin from
//! which on the parts are analytic (`strip`); orders are added until count and exponents settle. Of what decays only the exponents that starts lead to are known.
//!
//! Theory: `docs/theory/harmonic-balance.md#stability`.

mod strip;

use crate::characteristic::{Equilibrium, Frame};
use crate::harmonic::balance::problem::{Balance, Discretisation};
use crate::harmonic::balance::whole_period::sampled_period;
use crate::harmonic::stability::floquet::{Exponents, Method, Unassessed};
use crate::model::blocks::Grid;
use crate::model::erased::D1;
use crate::model::linear::{Form, LinearModel, LinearScratch};
use crate::model::part::Domain;
use crate::model::system::System;
use crate::pencil::Linearised;
use crate::roots::{self, LEAST, PAIR, SAME};
use laval_num::complex::{C64, Complex, c};
use laval_num::contour::{Region, Sample, newton, zeros};
use laval_num::dense::{Field, Lu, Mat};
use laval_num::dual::Dual;
use laval_num::order::SortByNumber;
use std::f64::consts::TAU;
use std::sync::atomic::{AtomicBool, Ordering};

/// Coefficients of tangents below this part of the largest are left out.
const SMALL: f64 = 1e-13;
/// Exponents have settled when they change by no more than this part of the base frequency.
const SETTLED: f64 = 1e-9;
/// Orders beyond those of the machine's frequencies that a count begins with, at most.
const BESIDE: usize = 4;
/// Most orders on either side.
const MOST_ORDERS: usize = 64;
/// Most evaluations of the determinant for one count.
const BUDGET: u64 = 50_000;
/// Most terms of series, or what costs as much, for the exponents of one motion.
const MOST_TERMS: u64 = 12_000_000;
/// Operations on complex numbers that cost as much as one term.
const OPERATIONS: u64 = 128;
/// Terms that cost as much as the solution of one order.
const ORDER: u64 = 8;
/// Why a count ended early.
const SHORT: &str =
    "counting the exponents that grow takes more work than a motion or a response is given; parts with shorter series make it less";
const UNCOUNTED: &str = "the exponents that grow could not be counted on Hill's determinant";
/// Terms of one dynamic stiffness from which on only so many exponents that decay, the slowest, are followed.
const DEAR: u64 = 50;
const SLOWEST: usize = 6;
/// Place of the strip: real multipliers, which lie at multiples of half the base frequency, are not on its edge.
const BELOW: f64 = 0.381_966;

/// Work that may still be done.
pub struct Effort<'a> {
    /// Terms of series, or what costs as much.
    pub terms: u64,
    /// Ends it.
    pub cancel: Option<&'a AtomicBool>,
}

impl Effort<'_> {
    /// Without limit.
    pub const fn endless() -> Self {
        Effort { terms: u64::MAX, cancel: None }
    }
    /// Says whether so much is there above what must be left, and takes it.
    fn spend(&mut self, terms: u64, floor: u64) -> bool {
        let enough = self.terms.saturating_sub(floor) >= terms && !self.cancel.is_some_and(|c| c.load(Ordering::Relaxed));
        if enough {
            self.terms -= terms;
        }
        enough
    }
}

/// Hill's determinant of one motion.
struct Hill<'a, 'b> {
    system: &'a System,
    /// To count with, where that is another.
    rough: Option<System>,
    params: Vec<D1>,
    model: LinearModel<D1>,
    scratch: LinearScratch<D1>,
    grid: Grid<Complex<D1>>,
    rows: Vec<Vec<(usize, f64)>>,
    reference: Vec<f64>,
    /// Coefficients of orders from 0 up, by displacements and by rates; those below 0 are conjugates.
    tangents: Vec<[Mat<C64>; 2]>,
    speed: f64,
    /// Base frequency with the sign of the speed.
    base: f64,
    orders: usize,
    lu: Lu<C64>,
    /// Domains of the parts.
    domains: Vec<Domain>,
    /// Roots of the machine at rest, of its parts that have a time form.
    own: Vec<C64>,
    /// The highest frequency, rad/s, that counts.
    fastest: f64,
    /// Terms of one dynamic stiffness, and of one to count with.
    terms: u64,
    rough_terms: u64,
    effort: &'a mut Effort<'b>,
    /// What is left of the effort for other motions.
    floor: u64,
    /// There was not enough.
    short: bool,
}

impl Hill<'_, '_> {
    fn tangent(&self, order: isize, which: usize, j: usize, k: usize) -> C64 {
        let t = self.tangents.get(order.unsigned_abs()).map_or(C64::zero(), |t| t[which][(j, k)]);
        if order < 0 { t.conj() } else { t }
    }

    /// Classes of orders that no tangent couples: the greatest common divisor of the orders of tangents.
    fn classes(&self) -> usize {
        let coupled = |t: &[Mat<C64>; 2]| t.iter().any(|m| m.max_size() > 0.0);
        let step = (1..self.tangents.len()).filter(|&k| coupled(&self.tangents[k])).fold(0, gcd);
        if step == 0 { 2 * self.orders + 1 } else { step }
    }

    /// Phase and logarithmic derivative of `det Y` at one order, and `B Y^-1 B^T` with its derivative.
    fn order(&mut self, s: C64, rough: bool) -> Option<(Sample, [Mat<C64>; 2])> {
        let mu = self.rows.len();
        let dual = c(Dual { re: s.re, eps: [1.0] }, Dual { re: s.im, eps: [0.0] });
        let system = self.rough.as_ref().filter(|_| rough).unwrap_or(self.system);
        system.dynamic_stiffness(&self.params, &self.model, Form::Frequency, dual, &mut self.grid, &mut self.scratch);
        let size = self.grid.rows();
        let mut y = Mat::from_fn(size, size, |i, j| c(self.grid[(i, j)].re.re, self.grid[(i, j)].im.re));
        let mut right =
            Mat::from_fn(
                size,
                size + mu,
                |i, j| {
                    if j < size { c(self.grid[(i, j)].re.eps[0], self.grid[(i, j)].im.eps[0]) } else { C64::zero() }
                },
            );
        for (k, (row, &reference)) in self.rows.iter().zip(&self.reference).enumerate() {
            for &(gi, ci) in row {
                right[(gi, size + k)] += c(ci, 0.0);
                for &(gj, cj) in row {
                    y[(gi, gj)] += c(reference * ci * cj, 0.0);
                }
            }
        }
        for i in 0..size {
            let largest = y.row(i).iter().map(|x| x.size()).fold(0.0, f64::max);
            let scale = if largest > 0.0 { largest.recip() } else { 1.0 };
            y.row_mut(i).iter_mut().for_each(|x| *x = x.scale(scale));
            right.row_mut(i).iter_mut().for_each(|x| *x = x.scale(scale));
        }
        self.lu.factor(&y).ok()?;
        self.lu.solve_mat(&mut right);
        // Y^-1 Y' on the left, Y^-1 B^T on the right
        let rate = (0..size).fold(C64::zero(), |sum, i| sum + right[(i, i)]);
        let spread = |i: usize, k: usize| right[(i, size + k)];
        let changed = Mat::from_fn(size, mu, |i, k| -(0..size).fold(C64::zero(), |sum, j| sum + right[(i, j)] * spread(j, k)));
        let read = |at: &dyn Fn(usize, usize) -> C64| {
            Mat::from_fn(mu, mu, |i, k| self.rows[i].iter().fold(C64::zero(), |sum, &(g, x)| sum + at(g, k).scale(x)))
        };
        Some((Sample { phase: self.lu.det().arg(), rate }, [read(&spread), read(&|i, k| changed[(i, k)])]))
    }

    /// The flexibility `B Y^-1 B^T` at every order with its derivative, and phase and logarithmic derivative of the product of all `det Y`.
    fn flexibilities(&mut self, exponent: C64, rough: bool) -> Option<(Sample, Vec<[Mat<C64>; 2]>)> {
        let (n, mu) = (self.orders as isize, self.rows.len());
        let (count, classes) = (2 * self.orders as u64 + 1, self.classes() as u64);
        let size = count.div_ceil(classes) * mu as u64;
        // a count follows the margin
        let terms = if rough { self.rough_terms } else { self.terms };
        if !self.effort.spend(count * (terms + ORDER) + classes * size.pow(3) / OPERATIONS, self.floor) {
            self.short = true;
            return None;
        }
        let mut sample = Sample { phase: 0.0, rate: C64::zero() };
        let mut flexibility: Vec<[Mat<C64>; 2]> = Vec::with_capacity(2 * self.orders + 1);
        for order in -n..=n {
            let (own, g) = self.order(exponent + c(0.0, order as f64 * self.base), rough)?;
            sample.phase += own.phase;
            sample.rate += own.rate;
            flexibility.push(g);
        }
        Some((sample, flexibility))
    }

    /// `1 + G (T - S)` of one class of orders with its derivative; the orders are `class`, and every `classes`-th after it.
    fn coupled(&self, class: usize, exponent: C64, flexibility: &[[Mat<C64>; 2]]) -> (Mat<C64>, Mat<C64>) {
        let (n, mu) = (self.orders as isize, self.rows.len());
        let members: Vec<usize> = (class..flexibility.len()).step_by(self.classes()).collect();
        let size = members.len() * mu;
        let (mut whole, mut slope) = (Mat::zeros(size, size), Mat::zeros(size, size));
        for (a, &row) in members.iter().enumerate() {
            let [g, dg] = &flexibility[row];
            for (b, &col) in members.iter().enumerate() {
                let s = exponent + c(0.0, (col as isize - n) as f64 * self.base);
                let between = row as isize - col as isize;
                for k in 0..mu {
                    for l in 0..mu {
                        let rate = self.tangent(between, 1, l, k);
                        let mut t = self.tangent(between, 0, l, k) + s * rate;
                        if a == b && k == l {
                            t -= c(self.reference[l], 0.0);
                        }
                        for i in 0..mu {
                            whole[(a * mu + i, b * mu + k)] += g[(i, l)] * t;
                            slope[(a * mu + i, b * mu + k)] += dg[(i, l)] * t + g[(i, l)] * rate;
                        }
                    }
                }
            }
        }
        for i in 0..size {
            whole[(i, i)] += C64::one();
        }
        (whole, slope)
    }

    /// The determinant's phase and logarithmic derivative; `rough` is enough to count zeros by.
    fn at(&mut self, exponent: C64, rough: bool) -> Option<Sample> {
        let (mut sample, flexibility) = self.flexibilities(exponent, rough)?;
        // orders that no tangent couples are classes of their own
        for class in 0..self.classes() {
            let (whole, mut slope) = self.coupled(class, exponent, &flexibility);
            let size = whole.rows();
            self.lu.factor(&whole).ok()?;
            self.lu.solve_mat(&mut slope);
            sample.phase += self.lu.det().arg();
            sample.rate += (0..size).fold(C64::zero(), |sum, i| sum + slope[(i, i)]);
        }
        (sample.phase.is_finite() && sample.rate.is_finite()).then_some(sample)
    }

    /// The characteristic function of one order.
    fn alone(&mut self, s: C64) -> Option<Sample> {
        if !self.effort.spend(self.terms + ORDER, self.floor) {
            self.short = true;
            return None;
        }
        self.order(s, true).map(|o| o.0).filter(|o| o.phase.is_finite() && o.rate.is_finite())
    }
}

impl Hill<'_, '_> {
    /// The zero that Newton's method leads to from a start, steps no longer than half of `size`; its error is measured by the base frequency, so that a zero at the origin is one
    /// like any other.
    fn root(&mut self, start: C64, size: f64) -> Option<C64> {
        let away = c(self.base.abs(), 0.0);
        newton(|s| self.at(s - away, false), start + away, size, &[]).map(|z| z - away)
    }
}

fn gcd(a: usize, b: usize) -> usize {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// Coefficients of the tangents of the motion last sampled over a whole period.
fn coefficients(balance: &Balance) -> Vec<[Mat<C64>; 2]> {
    let (count, mu) = (balance.terms.samples, balance.terms.coordinates);
    let derivatives = if balance.nonlinear.members.iter().any(|m| m.uses.velocity) { 2 } else { 1 };
    let one = |k: usize, d: usize| {
        Mat::from_fn(mu, mu, |i, j| {
            if d >= derivatives {
                return C64::zero();
            }
            let tangent = balance.sampled.tangent(d);
            let sum = (0..count)
                .fold(C64::zero(), |sum, s| sum + C64::cis(-TAU * ((k * s) % count) as f64 / count as f64).scale(tangent[(s * mu + i, j)]));
            sum.scale(1.0 / count as f64)
        })
    };
    let mut all: Vec<[Mat<C64>; 2]> = (0..=(count - 1) / 2).map(|k| [one(k, 0), one(k, 1)]).collect();
    let largest = [0, 1].map(|d| all.iter().map(|t| t[d].max_size()).fold(0.0, f64::max));
    for (d, largest) in largest.iter().enumerate() {
        all.iter_mut().filter(|t| t[d].max_size() <= SMALL * largest).for_each(|t| t[d] = Mat::zeros(mu, mu));
    }
    while all.len() > 1 && all.last().is_some_and(|t| t.iter().all(|m| m.max_size() == 0.0)) {
        all.pop();
    }
    all
}

/// Margin from which on all parts are analytic.
pub(in crate::harmonic) fn margin(domains: &[Domain], speed: f64) -> f64 {
    if domains.iter().all(|d| !d.touches_axis() && d.except.is_empty()) { 0.0 } else { LEAST * speed.abs() }
}

/// Longest step: so short that nothing hides beside a wave of a part; with a base frequency waves are at every order.
fn reach(domains: &[Domain], speed: f64, base: Option<f64>, s: C64) -> f64 {
    let mut limit = f64::INFINITY;
    for d in domains {
        let gap = if d.gap.is_finite() { d.gap } else { continue };
        let away = (s.re + gap).abs();
        if d.crowded.is_some() || !d.except.is_empty() {
            limit = limit.min(PAIR * away.max(LEAST * speed.abs()));
        }
        for w in d.waves.iter().flat_map(|&w| [w, -w]) {
            let beside = s.im - w;
            let beside = base.map_or(beside, |base| beside - (beside / base).round() * base);
            limit = limit.min(0.5 * away.hypot(beside));
        }
    }
    limit
}

/// Hill's determinant of a motion `x` of a discretisation at a speed, with as many orders as a count begins with.
fn hill<'a, 'b>(
    system: &'a System,
    d: Discretisation,
    x: &[f64],
    speed: f64,
    effort: &'a mut Effort<'b>,
) -> Result<Hill<'a, 'b>, Unassessed> {
    let failed = |why: &str| Unassessed::Failed(why.into());
    if system.slots().iter().filter(|s| !s.is_linear()).any(|s| s.uses.acceleration || !s.states.is_empty()) {
        return Err(failed("Hill's determinant is for machines whose nonlinear parts have neither mass nor states"));
    }
    let (mut balance, x) = sampled_period(system, d, x, speed);
    if !balance.switches(&x, speed, (0.0, TAU)).0.is_empty() {
        return Err(failed("Hill's determinant is for motions along which no law switches"));
    }
    balance.sample(&x, speed);
    let tangents = coefficients(&balance);
    let base = speed / d.divisor as f64;
    let strip = base.abs();
    let domains = system.domains(speed);
    let rest = Equilibrium::zero(system, Frame::Fixed, speed);
    let own: Vec<C64> =
        Linearised::of_time_forms(system, &rest).spectrum().map_or(Vec::new(), |s| s.modes.iter().map(|m| m.value).collect());
    let waves = domains.iter().flat_map(|d| d.waves.iter().map(|w| w.abs()));
    let fastest = own.iter().map(|s| s.abs()).chain(waves).filter(|x| x.is_finite()).fold(2.0 * speed.abs(), f64::max);
    let mean: Vec<f64> = (0..balance.terms.coordinates).map(|i| tangents[0][0][(i, i)].re.abs()).collect();
    let size = mean.iter().fold(0.0f64, |a, &b| a.max(b));
    let params: Vec<D1> = system.params().iter().map(|&x| Dual::lift(x)).collect();
    let (mut model, mut scratch) = (LinearModel::default(), LinearScratch::default());
    system.linear(&params, Dual::lift(speed), Form::Frequency, &mut model, &mut scratch);
    Ok(Hill {
        system,
        rough: system.rough(),
        params,
        model,
        scratch,
        grid: Grid::empty(),
        rows: balance.nonlinear.basis.rows.clone(),
        reference: mean
            .iter()
            .map(|k| {
                if *k > 0.0 {
                    *k
                } else if size > 0.0 {
                    size
                } else {
                    1.0
                }
            })
            .collect(),
        orders: ((1.2 * fastest / strip).ceil() as usize).saturating_add(tangents.len().min(BESIDE)),
        tangents,
        speed,
        base,
        lu: Lu::default(),
        terms: domains.iter().map(|d| d.terms as u64).sum(),
        rough_terms: domains.iter().map(|d| d.rough_terms as u64).sum(),
        domains,
        own,
        fastest,
        floor: effort.terms.saturating_sub(MOST_TERMS),
        effort,
        short: false,
    })
}

/// Roots of the machine at rest, those below the axis too, and whether all of them that grow are among them.
fn at_rest(hill: &mut Hill, margin: f64) -> Option<(Vec<C64>, bool)> {
    let about = Equilibrium::zero(hill.system, Frame::Fixed, hill.speed);
    let request =
        roots::Request { margin, growing: true, evaluations: Some(BUDGET), cancel: hill.effort.cancel, ..roots::Request::default() };
    let found = roots::roots(hill.system, &about, &request).ok()?;
    if !hill.effort.spend(found.evaluations.saturating_mul(hill.terms + ORDER), hill.floor) {
        hill.effort.terms = hill.floor;
        hill.short = true;
    }
    let values = found.spectrum.modes.iter().flat_map(|m| if m.value.im == 0.0 { vec![m.value] } else { vec![m.value, m.value.conj()] });
    Some((values.collect(), found.growing().is_some()))
}

/// Exponents of a motion `x` of a discretisation at a speed: all that grow, and those that decay to which `starts` lead. The error of the result is at least the margin from
/// which on growth can be counted.
///
/// # Errors
/// Why the motion cannot be assessed.
pub fn exponents(
    system: &System,
    d: Discretisation,
    x: &[f64],
    speed: f64,
    starts: &[C64],
    effort: &mut Effort,
) -> Result<Exponents, Unassessed> {
    let failed = |why: &str| Unassessed::Failed(why.into());
    let mut hill = hill(system, d, x, speed, effort)?;
    let (domains, own, fastest, strip) = (hill.domains.clone(), hill.own.clone(), hill.fastest, hill.base.abs());
    let margin = margin(&domains, speed);
    let done = |mut values: Vec<C64>| {
        values.sort_by_number_down(|a| a.re);
        Ok(Exponents { values, error: margin.max(SETTLED * strip), method: Method::Determinant, span: TAU / strip })
    };
    if system.slots().iter().all(|s| s.is_linear()) {
        return match at_rest(&mut hill, margin) {
            Some((values, true)) => done(values),
            _ => Err(failed(if hill.short { SHORT } else { UNCOUNTED })),
        };
    }
    let into = |z: C64| z - c(0.0, strip * (z.im / strip + BELOW).floor());
    let limit = |s: C64| reach(&domains, speed, Some(strip), s);
    let region =
        Region { re: (margin, 2.0 * fastest), im: (-BELOW * strip, (1.0 - BELOW) * strip), mirrored: false, reach: &limit, noise: SAME };
    let mut starts: Vec<C64> = if starts.is_empty() {
        own.iter().flat_map(|&z| [into(z), into(z.conj())]).collect()
    } else {
        starts.iter().copied().map(into).collect()
    };
    if hill.terms > DEAR {
        starts.sort_by_number_down(|a| a.re);
        let growing = starts.iter().filter(|z| z.re > margin).count();
        starts.truncate(growing + SLOWEST);
    }
    // Newton's method begins beside a zero: on it the determinant cannot be divided by
    let aside = c(1e-6 * strip, 0.0);
    let apart = |a: C64, b: C64| {
        let aside = c(0.0, 1e-6 * strip);
        (a - b).abs() > 1e-7 * strip && (into(a + aside) - into(b + aside)).abs() > 1e-7 * strip
    };
    while hill.orders <= MOST_ORDERS {
        let mut values: Vec<C64> = Vec::new();
        let follow = |hill: &mut Hill, starts: &[C64], values: &mut Vec<C64>| {
            for &start in starts {
                let Some(z) = hill.root(start + aside, 0.2 * strip).map(into) else { continue };
                if z.re > -fastest && values.iter().all(|&k| apart(k, z)) {
                    values.push(z);
                }
            }
            values.sort_by_number_down(|a| a.re);
            values.iter().filter(|z| z.re > margin).count()
        };
        let mut growing = follow(&mut hill, &starts, &mut values);
        let count = strip::count(&mut hill, margin);
        // one more begins to grow: perhaps as it does at rest
        if count.is_some_and(|n| n > growing as i64)
            && let Some((more, _)) = at_rest(&mut hill, margin)
        {
            let more: Vec<C64> = more.into_iter().filter(|z| z.re > 0.0).map(into).collect();
            growing = follow(&mut hill, &more, &mut values);
        }
        if count.is_some_and(|n| n > growing as i64) {
            let found = zeros(|s| hill.at(s, true), &region, &values[..growing], BUDGET);
            if found.missing != Some(0) {
                return Err(failed(if hill.short { SHORT } else { UNCOUNTED }));
            }
            for z in found.zeros {
                let Some(z) = hill.root(z + aside, 1e-3 * strip).filter(|z| values[..growing].iter().all(|&k| apart(k, *z))) else {
                    continue;
                };
                values.insert(growing, z);
                growing += 1;
            }
        }
        if hill.short {
            return Err(failed(SHORT));
        }
        hill.orders += hill.orders.div_ceil(3);
        let settled = |z: &C64| hill.root(*z + aside, 1e-3 * strip).is_some_and(|n| (n - *z).abs() <= SETTLED * strip);
        // all that grow, and one at least
        let looked_at = growing.max(1).min(values.len());
        if count == Some(growing as i64) && values[..looked_at].iter().all(settled) {
            return done(values);
        }
        starts.extend(&values[..growing]);
    }
    Err(Unassessed::Failed(format!("Hill's determinant did not settle with {MOST_ORDERS} orders")))
}

/// The exponent that a start leads to, without a count: by Newton's method, again with a third more orders. `None` where none is so near as `within`, where it does not
/// settle, or where the work that may be done is used up.
pub(in crate::harmonic) fn followed(
    system: &System,
    d: Discretisation,
    x: &[f64],
    speed: f64,
    (start, within): (C64, f64),
    effort: &mut Effort,
) -> Option<C64> {
    let mut hill = hill(system, d, x, speed, effort).ok()?;
    let strip = hill.base.abs();
    let aside = c(1e-6 * strip, 0.0);
    let mut z = hill.root(start + aside, within)?;
    while hill.orders <= MOST_ORDERS {
        hill.orders += hill.orders.div_ceil(3);
        let next = hill.root(z + aside, 1e-3 * strip)?;
        if (next - z).abs() <= SETTLED * strip {
            return ((next - start).abs() <= within).then_some(next);
        }
        z = next;
    }
    None
}

/// What moves at an exponent: order, and the amplitudes of the nonlinear coordinates there.
pub(in crate::harmonic) type Shape = Vec<(isize, Vec<C64>)>;

/// The disturbance of an exponent, by inverse iteration in the class of orders that has it.
pub(in crate::harmonic) fn shape(
    system: &System,
    d: Discretisation,
    x: &[f64],
    speed: f64,
    exponent: C64,
    effort: &mut Effort,
) -> Option<Shape> {
    let mut hill = hill(system, d, x, speed, effort).ok()?;
    let exponent = exponent + c(1e-9 * hill.base.abs(), 0.0);
    let (_, flexibility) = hill.flexibilities(exponent, false)?;
    let (mu, n) = (hill.rows.len(), hill.orders as isize);
    let mut best: Option<(f64, Shape)> = None;
    for class in 0..hill.classes() {
        let (whole, _) = hill.coupled(class, exponent, &flexibility);
        let lu = Lu::new(&whole).ok()?;
        let mut v: Vec<C64> = (0..whole.rows()).map(|i| c(1.0 + 0.3 * (1.7 * i as f64).sin(), 0.2 * (2.3 * i as f64).cos())).collect();
        let mut size = 0.0;
        for _ in 0..4 {
            let before = v.iter().map(|z| z.norm_sqr()).sum::<f64>().sqrt();
            v.iter_mut().for_each(|z| *z = z.scale(1.0 / before));
            lu.solve(&mut v);
            size = v.iter().map(|z| z.norm_sqr()).sum::<f64>().sqrt();
        }
        if size.is_finite() && best.as_ref().is_none_or(|b| size > b.0) {
            let step = hill.classes() as isize;
            let orders = v.chunks(mu).enumerate().map(|(k, x)| (class as isize + k as isize * step - n, x.to_vec())).collect();
            best = Some((size, orders));
        }
    }
    best.map(|b| b.1)
}
