//! Systems of equations `(A0 + i w A1 - w^2 A2) x = b` of one plan, as many side by side as there are lanes, each with matrices of its own.
//!
//! Solutions are corrected with residuals whose products and sums have twice the working precision, until they are exact to rounding for the matrices as they are.

use super::lanes::{InLanes, LaneFactors, Pair, Row};
use super::plan::Target;
use super::sum::Sum;
use super::terms::{CORRECTIONS, EXACT};
use super::{Plan, scales};
use crate::complex::{C64, c};
use crate::lanes::{Kernel, LANES, LaneScalar, Level, dispatch};
use crate::work::spend;

/// One system.
#[derive(Clone, Copy, Debug)]
pub struct Forced<'a> {
    /// w.
    pub frequency: f64,
    /// A0, A1 and A2 by the entries of the pattern.
    pub terms: [&'a [f64]; 3],
    /// b.
    pub right: &'a [C64],
}

/// A solution.
#[derive(Clone, Debug)]
pub struct Solved {
    /// x.
    pub x: Vec<C64>,
    /// Largest component of `b - A x`, which is computed to rounding of b.
    pub residual: f64,
}

#[derive(Debug)]
struct Entry {
    row: usize,
    column: usize,
    target: Target,
    terms: [Row; 3],
}

/// Solver of systems side by side. Reusable: it keeps its memory.
#[derive(Debug, Default)]
pub struct Each {
    factors: LaneFactors<C64>,
    entries: Vec<Entry>,
}

impl Each {
    /// Solves up to as many systems as there are lanes; `None` of a matrix that is singular or not finite. Of a plan that does not suit lanes nothing is solved.
    pub fn solve(&mut self, plan: &Plan, systems: &[Forced]) -> Vec<Option<Solved>> {
        let Each { factors, entries } = self;
        let (Some(band), Some(last)) = (plan.band.as_ref().filter(|_| plan.suits_lanes()), systems.last()) else {
            return systems.iter().map(|_| None).collect();
        };
        let n = plan.n();
        let lane = |l: usize| systems.get(l).unwrap_or(last);
        let frequency: Row = std::array::from_fn(|l| lane(l).frequency);
        entries.clear();
        for row in 0..n {
            for (e, column) in plan.pattern.row(row) {
                let terms: [Row; 3] = std::array::from_fn(|k| std::array::from_fn(|l| lane(l).terms[k][e]));
                if terms.iter().flatten().any(|x| *x != 0.0) {
                    entries.push(Entry { row, column, target: band.targets[e], terms });
                }
            }
        }
        let size = |e: &Entry| {
            let of = |l: usize| {
                let w = frequency[l];
                (e.terms[0][l] - w * w * e.terms[2][l]).abs() + (w * e.terms[1][l]).abs()
            };
            (0..LANES).map(of).fold(0.0, f64::max)
        };
        let sizes: Vec<(usize, usize, f64)> = entries.iter().map(|e| (e.row, e.column, size(e))).collect();
        let (rows, columns) = scales(n, &sizes);
        for e in entries.iter_mut() {
            let scale = rows[e.row] * columns[e.column];
            e.terms.iter_mut().flatten().for_each(|x| *x *= scale);
        }
        let value = |e: &Entry| -> Pair {
            let of = |l: usize| (e.terms[0][l] - frequency[l] * frequency[l] * e.terms[2][l], frequency[l] * e.terms[1][l]);
            [std::array::from_fn(|l| of(l).0), std::array::from_fn(|l| of(l).1)]
        };
        factors.factor_entries(plan, entries.iter().map(|e| (e.target, value(e))));
        let part = |i: usize, f: fn(C64) -> f64| -> Row { std::array::from_fn(|l| f(lane(l).right[i]) * rows[i]) };
        let b: Vec<Pair> = (0..n).map(|i| [part(i, |z| z.re), part(i, |z| z.im)]).collect();
        let mut x = b.clone();
        factors.solve(&mut x, false);
        let mut rest = b.clone();
        let residual = |x: &[Pair], rest: &mut [Pair]| {
            spend(100 * (LANES * entries.len()) as u64);
            rest.copy_from_slice(&b);
            dispatch(Level::best(), Residual { entries, frequency: &frequency, x, rest });
        };
        let (mut open, mut last) = ([true; LANES], [f64::INFINITY; LANES]);
        for _ in 0..CORRECTIONS {
            residual(&x, &mut rest);
            factors.solve(&mut rest, false);
            let (size, more) = (largest(&x), largest(&rest));
            for l in 0..LANES {
                let change = more[l] / size[l];
                // nothing that is not a number is a correction
                let corrects = open[l] && change < 0.5 * last[l];
                if corrects {
                    for (x, r) in x.iter_mut().zip(&rest) {
                        (x[0][l], x[1][l]) = (x[0][l] + r[0][l], x[1][l] + r[1][l]);
                    }
                }
                (open[l], last[l]) = (corrects && change > EXACT, change);
            }
            if !open.contains(&true) {
                break;
            }
        }
        residual(&x, &mut rest);
        let solved = |l: usize| {
            let of = |all: &[Pair], i: usize| c(all[i][0][l], all[i][1][l]);
            let solution: Vec<C64> = (0..n).map(|i| of(&x, i).scale(columns[i])).collect();
            let residual = (0..n).map(|i| of(&rest, i).abs() / rows[i]).fold(0.0, f64::max);
            solution.iter().all(|z| z.is_finite()).then_some(Solved { x: solution, residual })
        };
        (0..systems.len().min(LANES)).map(solved).collect()
    }
}

fn largest(x: &[Pair]) -> Row {
    let mut out = [0.0f64; LANES];
    for [re, im] in x {
        for l in 0..LANES {
            out[l] = out[l].max(re[l].abs() + im[l].abs());
        }
    }
    out
}

/// `rest -= A x`, each row rounded once.
struct Residual<'a> {
    entries: &'a [Entry],
    frequency: &'a Row,
    x: &'a [Pair],
    rest: &'a mut [Pair],
}

impl Kernel for Residual<'_> {
    type Out = ();
    #[inline(always)]
    fn run<S: LaneScalar>(self) {
        let w = S::load(self.frequency);
        let square = w * w;
        let mut at = 0;
        while at < self.entries.len() {
            let row = self.entries[at].row;
            let b = C64::load::<S>(&self.rest[row]);
            let (mut re, mut im) = (Sum::of(b.re), Sum::of(b.im));
            while at < self.entries.len() && self.entries[at].row == row {
                let e = &self.entries[at];
                let x = C64::load::<S>(&self.x[e.column]);
                let (a0, a1, a2) = (S::load(&e.terms[0]), S::load(&e.terms[1]), S::load(&e.terms[2]));
                if !a0.is_nothing() {
                    re.add(-a0, x.re);
                    im.add(-a0, x.im);
                }
                if !a1.is_nothing() {
                    re.add(a1, w * x.im);
                    im.add(-a1, w * x.re);
                }
                if !a2.is_nothing() {
                    re.add(a2, square * x.re);
                    im.add(a2, square * x.im);
                }
                at += 1;
            }
            C64::store::<S>(c(re.value(), im.value()), &mut self.rest[row]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Factors, Pattern, Terms};
    use super::*;
    use crate::dense::Field;
    use std::sync::Arc;

    /// Chains of two directions, each lane with matrices of its own, on a soft support, with and without a foundation that all links couple with.
    #[test]
    fn every_lane_is_its_system() {
        for foundation in [false, true] {
            let (links, n) = (60, 120 + usize::from(foundation));
            let pairs = (0..2 * links).flat_map(|i| [(i, i ^ 1), (i, (i + 2).min(2 * links - 1)), (i, if foundation { n - 1 } else { i })]);
            let pattern = Arc::new(Pattern::new(n, pairs));
            let plan = Plan::new(&pattern);
            assert!(!plan.is_dense() && plan.has_border() == foundation);
            let own = |l: usize| {
                let mut terms = [(); 3].map(|()| vec![0.0; pattern.entries()]);
                for i in 0..n {
                    for (e, j) in pattern.row(i) {
                        let far = foundation && (i == n - 1 || j == n - 1);
                        terms[0][e] = match i.abs_diff(j) {
                            0 => 2e9 + 1e4 * (i + l) as f64,
                            2 if !far => -1e9,
                            _ => 0.0,
                        };
                        terms[1][e] = match i.abs_diff(j) {
                            0 => 10.0,
                            1 if !far && i / 2 == j / 2 => {
                                if i < j {
                                    30.0 + l as f64
                                } else {
                                    -30.0 - l as f64
                                }
                            }
                            _ => 0.0,
                        };
                        terms[2][e] = if i == j {
                            3.0
                        } else if far {
                            0.01
                        } else {
                            0.0
                        };
                    }
                }
                let right: Vec<C64> = (0..n).map(|i| C64::cis((i * (l + 1)) as f64)).collect();
                (terms, right)
            };
            let all: Vec<([Vec<f64>; 3], Vec<C64>)> = (0..11).map(own).collect();
            let frequency = |l: usize| 50.0 * l as f64;
            let systems: Vec<Forced> = all
                .iter()
                .enumerate()
                .map(|(l, (terms, right))| Forced { frequency: frequency(l), terms: terms.each_ref().map(Vec::as_slice), right })
                .collect();
            let solved = Each::default().solve(&plan, &systems);
            assert_eq!(solved.len(), 11);
            for (l, solved) in solved.into_iter().enumerate() {
                let (solved, s) = (solved.unwrap(), c(0.0, frequency(l)));
                let ([a0, a1, a2], right) = &all[l];
                let sum: Vec<C64> = (0..a0.len()).map(|e| c(a0[e], 0.0) + s.scale(a1[e]) + (s * s).scale(a2[e])).collect();
                let terms = [(C64::ONE, &a0[..]), (s, &a1[..]), (s * s, &a2[..])];
                let exact = Terms { pattern: &pattern, terms: &terms };
                let mut x = right.clone();
                exact.solve(&Factors::new(&plan, &sum).unwrap(), &mut x);
                let size = x.iter().map(|x| x.abs()).fold(0.0, f64::max);
                for (a, b) in solved.x.iter().zip(&x) {
                    assert!((*a - *b).abs() <= 1e-14 * size, "{l}: {a:?} {b:?}");
                }
                let worst = exact.residual(&solved.x, right).iter().map(|r| r.abs()).fold(0.0, f64::max);
                assert!((worst - solved.residual).abs() <= 1e-3 * worst + 1e-18, "{worst:e} {:e}", solved.residual);
            }
        }
    }

    #[test]
    fn a_lane_without_solution() {
        let pattern = Arc::new(Pattern::new(40, (1..40).map(|i| (i - 1, i))));
        let plan = Plan::new(&pattern);
        let one: Vec<f64> = (0..40).flat_map(|i| pattern.row(i).map(move |(_, j)| if i == j { 1.0 } else { 0.0 })).collect();
        let (zero, right) = (vec![0.0; one.len()], vec![C64::ONE; 40]);
        let wrong: Vec<f64> = one.iter().map(|_| f64::NAN).collect();
        let system = |terms, frequency| Forced { frequency, terms, right: &right };
        // 1 - w^2 is zero at w = 1
        let systems = [system([&one, &zero, &one], 1.0), system([&one, &zero, &one], 2.0), system([&wrong, &zero, &one], 2.0)];
        let solved = Each::default().solve(&plan, &systems);
        assert!(solved[0].is_none() && solved[2].is_none());
        let x = &solved[1].as_ref().unwrap().x;
        assert!(x.iter().all(|x| (*x - c(-1.0 / 3.0, 0.0)).abs() < 1e-15));
    }
}
