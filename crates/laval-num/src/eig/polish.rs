//! Eigenvalues of a sparse quadratic problem near starts, as many side by side as there are lanes.
//!
//! Inverse iteration for both vectors at a shift p, and the Rayleigh functional, the zero of a quadratic in s:
//!
//! ```text
//! T(p) x' = x,    T(p)^H y' = y,    y'^H T(s) x' = 0
//! ```
//!
//! The functional errs by the product of the errors of both vectors, which every iteration at one shift divides by the distance of the next eigenvalue over that of this
//! one. The last steps take `y^H T(s) x` in twice the working precision, so that the rounding of `K + s D + s^2 M` does not spoil what a stiff chain on soft supports has for
//! low eigenvalues.
//!
//! Source: K. Schreiber, Nonlinear eigenvalue problems: Newton-type methods and nonlinear Rayleigh functionals, dissertation, TU Berlin 2008.

use crate::complex::{C64, c};
use crate::dense::Field;
use crate::factor::{LaneFactors, Pair, ScaledQuadratic};
use crate::lanes::LANES;

/// Factorisations for one start at most, and iterations with each.
const SHIFTS: usize = 6;
const ITERATIONS: usize = 4;
/// Change of an eigenvalue from one pair of vectors to the next, over the eigenvalue, that confirms it.
const CONFIRMED: f64 = 1e-12;
/// Change over the one before from which on it is worth while to go on with a shift.
const SHRINKS: f64 = 0.1;

/// A place near an eigenvalue, with vectors where some are known.
#[derive(Clone, Debug)]
pub struct Start<'a> {
    /// s.
    pub value: C64,
    /// Right and left vector.
    pub vectors: Option<(&'a [C64], &'a [C64])>,
}

/// An eigenvalue.
#[derive(Clone, Debug)]
pub struct Root {
    /// s.
    pub value: C64,
    /// x: `T x = 0`.
    pub right: Vec<C64>,
    /// y: `y^H T = 0`.
    pub left: Vec<C64>,
    /// Size of the change of T, scaled, over its largest entries that makes it exactly singular.
    pub defect: f64,
    /// Last change of s.
    pub step: f64,
    /// `y^H dT/ds x`.
    pub by_s: C64,
    /// Factorisations.
    pub shifts: usize,
}

/// One lane.
#[derive(Clone, Copy)]
struct Lane {
    value: C64,
    step: f64,
    open: bool,
    confirmed: bool,
    shifts: usize,
    form: C64,
}

/// The eigenvalues that some starts, at most as many as there are lanes, lead to; `None` where the iteration did not settle.
pub fn polish(t: &ScaledQuadratic, starts: &[Start], factors: &mut LaneFactors<C64>) -> Vec<Option<Root>> {
    let n = t.n();
    let count = starts.len().min(LANES);
    let (mut x, mut y) = (vec![[[0.0; LANES]; 2]; n], vec![[[0.0; LANES]; 2]; n]);
    // an arbitrary direction, the same every time; where all starts have vectors it fills unused lanes alone
    let any: Vec<C64> = if starts.iter().all(|s| s.vectors.is_some()) {
        vec![C64::ONE; n]
    } else {
        (0..n).map(|i| C64::cis(1.0 + 2.4 * i as f64).scale(1.0 + 0.3 * (i as f64).sin())).collect()
    };
    let mut fresh = false;
    for l in 0..LANES {
        let vectors = starts.get(l).and_then(|s| s.vectors);
        fresh |= l < count && vectors.is_none();
        for i in 0..n {
            let (a, b) = match vectors {
                Some((right, left)) => (right[i].scale(1.0 / t.columns()[i]), left[i].scale(1.0 / t.rows()[i])),
                None => (any[i], any[i]),
            };
            set(&mut x[i], l, a);
            set(&mut y[i], l, b);
        }
    }
    let mut lanes: Vec<Lane> = (0..LANES)
        .map(|l| {
            let value = starts.get(l).or(starts.last()).map_or(C64::ZERO, |s| s.value);
            Lane { value, step: f64::INFINITY, open: l < count, confirmed: false, shifts: 0, form: C64::ZERO }
        })
        .collect();
    for shift in 0..SHIFTS {
        if lanes.iter().all(|l| !l.open) {
            break;
        }
        factors.factor(t, &lanes.iter().map(|l| l.value).collect::<Vec<_>>());
        lanes.iter_mut().filter(|l| l.open).for_each(|l| l.shifts += 1);
        let mut goes_on = [true; LANES];
        for iteration in 0..ITERATIONS {
            // what is settled keeps its vectors
            let settled: Vec<usize> = (0..count).filter(|&l| !lanes[l].open).collect();
            let kept: Vec<[Pair; 2]> = if settled.is_empty() { Vec::new() } else { x.iter().zip(&y).map(|(x, y)| [*x, *y]).collect() };
            improve(factors, &mut x, &mut y);
            if shift == 0 && iteration == 0 && fresh {
                improve(factors, &mut x, &mut y);
            }
            for (i, kept) in kept.iter().enumerate() {
                for &l in &settled {
                    set(&mut x[i], l, get(&kept[0], l));
                    set(&mut y[i], l, get(&kept[1], l));
                }
            }
            let forms = t.forms(&y, &x);
            let mut places = [[0.0; LANES]; 2];
            let first = shift == 0 && iteration == 0;
            let mut moved = [0.0; LANES];
            for (l, lane) in lanes.iter_mut().enumerate() {
                let mut s = lane.value;
                if first {
                    // from afar: Newton's method on the quadratic
                    for _ in 0..3 {
                        let (f, slope) = forms.at(l, s);
                        s -= f / slope;
                    }
                    moved[l] = (s - lane.value).abs();
                    if lane.open {
                        lane.value = s;
                    }
                }
                set(&mut places, l, s);
            }
            let exact = t.exact_form(&places, &y, &x);
            for (l, lane) in lanes.iter_mut().enumerate().filter(|(_, l)| l.open) {
                lane.form = get(&exact, l);
                let (_, slope) = forms.at(l, lane.value);
                let change = -lane.form / slope;
                let length = change.abs() + if first { moved[l] } else { 0.0 };
                if !change.is_finite() {
                    (lane.open, lane.step) = (false, f64::NAN);
                    continue;
                }
                lane.value += change;
                let size = lane.value.abs();
                lane.confirmed = !first && length <= CONFIRMED * size;
                goes_on[l] = length <= SHRINKS * lane.step;
                lane.step = length;
                lane.open = !lane.confirmed;
            }
            if lanes.iter().zip(goes_on).all(|(l, goes_on)| !l.open || !goes_on) {
                break;
            }
        }
    }
    let forms = t.forms(&y, &x);
    let root = |l: usize| {
        let lane = &lanes[l];
        let vector = |all: &[Pair], scale: &[f64]| all.iter().zip(scale).map(|(v, k)| get(v, l).scale(*k)).collect();
        let (_, by_s) = forms.at(l, lane.value);
        let defect = lane.form.abs() / (forms.norms[0][l] * forms.norms[1][l]).sqrt();
        let out = Root {
            value: lane.value,
            right: vector(&x, t.columns()),
            left: vector(&y, t.rows()),
            defect,
            step: lane.step,
            by_s,
            shifts: lane.shifts,
        };
        (lane.confirmed && by_s.is_finite() && defect.is_finite()).then_some(out)
    };
    (0..count).map(root).collect()
}

fn get(x: &Pair, lane: usize) -> C64 {
    c(x[0][lane], x[1][lane])
}

fn set(x: &mut Pair, lane: usize, z: C64) {
    (x[0][lane], x[1][lane]) = (z.re, z.im);
}

/// One inverse iteration for both vectors, each divided by its largest component.
fn improve(factors: &mut LaneFactors<C64>, x: &mut [Pair], y: &mut [Pair]) {
    factors.solve(x, false);
    // with the adjoint
    let conjugate = |y: &mut [Pair]| y.iter_mut().for_each(|y| y[1].iter_mut().for_each(|im| *im = -*im));
    conjugate(y);
    factors.solve(y, true);
    conjugate(y);
    for all in [x, y] {
        let mut largest = [0.0f64; LANES];
        for v in all.iter() {
            for l in 0..LANES {
                let size = v[0][l].abs() + v[1][l].abs();
                largest[l] = if size > largest[l] { size } else { largest[l] };
            }
        }
        let scale = largest.map(|m| if m > 0.0 { 1.0 / m } else { 1.0 });
        for v in all.iter_mut() {
            for l in 0..LANES {
                v[0][l] *= scale[l];
                v[1][l] *= scale[l];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::Quadratic;
    use super::*;
    use crate::factor::{Pattern, Plan};
    use std::sync::Arc;

    /// Equal masses between springs of two directions that a gyroscopic term couples, fixed at both ends, damping proportional to stiffness.
    fn chain(links: usize, stiffness: f64, delay: f64, gyroscopic: f64) -> (Plan, [Vec<C64>; 3], Vec<C64>) {
        let n = 2 * links;
        let pairs = (0..n).flat_map(|i| [(i, i ^ 1), (i, (i + 2).min(n - 1))]);
        let pattern = Arc::new(Pattern::new(n, pairs));
        let mut terms = [(); 3].map(|()| vec![C64::ZERO; pattern.entries()]);
        for i in 0..n {
            let at = |j: usize| pattern.index(i, j).unwrap();
            terms[0][at(i)] = c(2.0 * stiffness, 0.0);
            terms[1][at(i)] = c(2.0 * stiffness * delay, 0.0);
            terms[2][at(i)] = C64::ONE;
            terms[1][at(i ^ 1)] = c(if i % 2 == 0 { gyroscopic } else { -gyroscopic }, 0.0);
            for j in [i.wrapping_sub(2), i + 2].into_iter().filter(|&j| j < n) {
                terms[0][at(j)] = c(-stiffness, 0.0);
                terms[1][at(j)] = c(-stiffness * delay, 0.0);
            }
        }
        // of x + i y: s^2 + (d w^2 -+ i g) s + w^2 = 0
        let mut roots = Vec::new();
        for j in 1..=links {
            let w2 = 4.0 * stiffness * (0.5 * std::f64::consts::PI * j as f64 / (links + 1) as f64).sin().powi(2);
            for g in [gyroscopic, -gyroscopic] {
                let b = c(delay * w2, g);
                let root = (b * b - c(4.0 * w2, 0.0)).sqrt();
                roots.extend([(root - b).scale(0.5), (-root - b).scale(0.5)]);
            }
        }
        (Plan::new(&pattern), terms, roots)
    }

    #[test]
    fn roots_near_starts_with_both_vectors() {
        let (plan, terms, exact) = chain(120, 1e6, 1e-5, 3.0);
        let problem = Quadratic { plan: &plan, terms: terms.each_ref().map(Vec::as_slice) };
        let mut low: Vec<C64> = exact.iter().copied().filter(|s| s.im > 0.0).collect();
        low.sort_by(|a, b| a.im.total_cmp(&b.im));
        let near: Vec<Start> = low[..11].iter().map(|&s| Start { value: s + c(1e-4, -1e-3).scale(s.abs()), vectors: None }).collect();
        let scaled = problem.scaled(400.0).unwrap();
        let found = polish(&scaled, &near, &mut LaneFactors::default());
        assert_eq!(found.len(), 11);
        for (root, s) in found.iter().zip(&low) {
            let root = root.as_ref().unwrap();
            assert!((root.value - *s).abs() <= 1e-12 * s.abs(), "{:?} {s:?}", root.value);
            assert!(root.defect <= 1e-13 && root.step <= 1e-12 * s.abs());
            // null vectors of the matrix as it was given, and the slope between them
            let pattern = plan.pattern();
            let at = |e: usize| terms[0][e] + root.value * (terms[1][e] + root.value * terms[2][e]);
            let slope = |e: usize| terms[1][e] + (root.value * terms[2][e]).scale(2.0);
            let (mut left, mut by_s) = (vec![C64::ZERO; plan.n()], C64::ZERO);
            let size = |x: &[C64]| x.iter().map(|x| x.abs()).fold(0.0, f64::max);
            for i in 0..plan.n() {
                let mut row = C64::ZERO;
                for (e, j) in pattern.row(i) {
                    row += at(e) * root.right[j];
                    left[j] += root.left[i].conj() * at(e);
                    by_s += root.left[i].conj() * slope(e) * root.right[j];
                }
                assert!(row.abs() <= 1e-10 * 4e6 * size(&root.right), "{row:?}");
            }
            assert!(size(&left) <= 1e-10 * 4e6 * size(&root.left));
            assert!((by_s - root.by_s).abs() <= 1e-9 * by_s.abs());
        }
        // with the vectors of another machine nearby
        let (_, beside, moved) = chain(120, 1.01e6, 1e-5, 3.1);
        let beside = Quadratic { plan: &plan, terms: beside.each_ref().map(Vec::as_slice) }.scaled(400.0).unwrap();
        let starts: Vec<Start> =
            found.iter().flatten().map(|r| Start { value: r.value.scale(1.005), vectors: Some((&r.right, &r.left)) }).collect();
        for (root, start) in polish(&beside, &starts, &mut LaneFactors::default()).iter().zip(&starts) {
            let value = root.as_ref().unwrap().value;
            let off = moved.iter().map(|s| (*s - value).abs()).fold(f64::INFINITY, f64::min);
            assert!(off <= 1e-12 * value.abs() && (value - start.value).abs() <= 0.01 * value.abs(), "{off:e}");
        }
    }

    /// What is no eigenvalue problem leads nowhere.
    #[test]
    fn nothing_is_found_of_numbers_that_are_none() {
        let (plan, mut terms, _) = chain(40, 1e6, 0.0, 0.0);
        terms[0][17] = c(f64::NAN, 0.0);
        let scaled = Quadratic { plan: &plan, terms: terms.each_ref().map(Vec::as_slice) }.scaled(100.0).unwrap();
        let starts = [Start { value: c(0.0, 30.0), vectors: None }];
        assert!(polish(&scaled, &starts, &mut LaneFactors::default())[0].is_none());
    }
}
