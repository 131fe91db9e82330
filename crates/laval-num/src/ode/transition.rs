//! Maps of linear systems `y' = A(t) y` over many steps of equal length, side by side in lanes.
//!
//! Each lane integrates one step from the identity by the explicit method of order 8(5,3) of [`Dop853`](super::Dop853); the product of all of them is the
//! map over the whole. A is a constant matrix with some entries that vary, which are given at the nodes of the stages.

use super::tableau::{self as t8, Row as Weights};
use crate::dense::Mat;
use crate::lanes::{Kernel, LANES, LaneScalar, Level, dispatch};
use crate::refill::refill;
use crate::work::spend;

/// A real number for each lane.
pub type Row = [f64; LANES];

/// Number of stages.
pub const STAGES: usize = 12;

/// Nodes of the stages within a step, in parts of it.
pub fn nodes() -> [f64; STAGES] {
    std::array::from_fn(|i| t8::C[i])
}

/// `A(t)` of a square matrix at the nodes of [`LANES`] steps.
#[derive(Clone, Copy, Debug)]
pub struct Varying<'a> {
    /// Number of states.
    pub n: usize,
    /// Constant entries: row, column, value.
    pub constant: &'a [(usize, usize, f64)],
    /// What is added at each instant: row, column, the number that varies, and its factor.
    pub entries: &'a [(usize, usize, usize, f64)],
    /// How many numbers vary.
    pub width: usize,
    /// Their values, stage after stage, a step in each lane.
    pub values: &'a [Row],
}

/// Storage for maps over steps; reuse it to avoid allocation.
#[derive(Clone, Debug, Default)]
pub struct Transition {
    stages: Vec<Row>,
    state: Vec<Row>,
    maps: Vec<Row>,
    later: Vec<Row>,
    step: Mat,
    product: Mat,
}

/// `out = later * earlier` in every lane, n by n.
struct Product<'a> {
    n: usize,
    earlier: &'a [Row],
    later: &'a [Row],
    out: &'a mut [Row],
}

impl Kernel for Product<'_> {
    type Out = ();
    #[inline(always)]
    fn run<S: LaneScalar>(self) {
        let n = self.n;
        for i in 0..n {
            for j in 0..n {
                let mut sum = S::zero();
                for k in 0..n {
                    sum += S::load(&self.later[i * n + k]) * S::load(&self.earlier[k * n + j]);
                }
                sum.store(&mut self.out[i * n + j]);
            }
        }
    }
}

/// `out[stage, e] = sum_i weights[stage, i] samples[i, e]`: what varies at the nodes of steps, from `width` numbers of each sample.
pub fn at_nodes(weights: &[Row], samples: &[f64], width: usize, out: &mut Vec<Row>) {
    refill(out, STAGES * width, [0.0; LANES]);
    spend((weights.len() * width * 4) as u64);
    dispatch(Level::best(), Nodes { weights, samples, width, out });
}

struct Nodes<'a> {
    weights: &'a [Row],
    samples: &'a [f64],
    width: usize,
    out: &'a mut [Row],
}

impl Kernel for Nodes<'_> {
    type Out = ();
    #[inline(always)]
    fn run<S: LaneScalar>(self) {
        let count = self.weights.len() / STAGES;
        for stage in 0..STAGES {
            let weights = &self.weights[stage * count..][..count];
            for e in 0..self.width {
                let mut sum = S::zero();
                for i in 0..count {
                    sum += S::load(&weights[i]).scale(self.samples[i * self.width + e]);
                }
                sum.store(&mut self.out[stage * self.width + e]);
            }
        }
    }
}

struct Columns<'a> {
    a: &'a Varying<'a>,
    h: f64,
    tolerance: f64,
    stages: &'a mut [Row],
    state: &'a mut [Row],
    maps: &'a mut [Row],
}

impl Columns<'_> {
    /// `sum_m w_m k_m` of state `i`.
    #[inline(always)]
    fn sum<S: LaneScalar, const N: usize>(&self, row: &Weights<N>, i: usize) -> S {
        let mut s = S::zero();
        for m in 0..N {
            s += S::load(&self.stages[row[m].0 * self.a.n + i]).scale(row[m].1);
        }
        s
    }

    /// The stage at the state `e_column + h sum_m a_m k_m`.
    #[inline(always)]
    fn stage<S: LaneScalar, const N: usize>(&mut self, stage: usize, row: &Weights<N>, column: usize) {
        let n = self.a.n;
        for i in 0..n {
            let start = S::cst(if i == column { 1.0 } else { 0.0 });
            (start + self.sum::<S, N>(row, i).scale(self.h)).store(&mut self.state[i]);
        }
        let out = &mut self.stages[stage * n..][..n];
        for o in &mut *out {
            *o = [0.0; LANES];
        }
        for &(i, j, value) in self.a.constant {
            (S::load(&out[i]) + S::load(&self.state[j]).scale(value)).store(&mut out[i]);
        }
        let values = &self.a.values[stage * self.a.width..];
        for &(i, j, number, factor) in self.a.entries {
            let value = S::load(&values[number]).scale(factor);
            (S::load(&out[i]) + value * S::load(&self.state[j])).store(&mut out[i]);
        }
    }
}

impl Kernel for Columns<'_> {
    type Out = f64;
    #[inline(always)]
    fn run<S: LaneScalar>(mut self) -> f64 {
        let n = self.a.n;
        let (mut e5, mut e3) = (S::zero(), S::zero());
        let per_h = 1.0 / self.h;
        for column in 0..n {
            self.stage::<S, 0>(0, &[], column);
            self.stage::<S, _>(1, &t8::A1, column);
            self.stage::<S, _>(2, &t8::A2, column);
            self.stage::<S, _>(3, &t8::A3, column);
            self.stage::<S, _>(4, &t8::A4, column);
            self.stage::<S, _>(5, &t8::A5, column);
            self.stage::<S, _>(6, &t8::A6, column);
            self.stage::<S, _>(7, &t8::A7, column);
            self.stage::<S, _>(8, &t8::A8, column);
            self.stage::<S, _>(9, &t8::A9, column);
            self.stage::<S, _>(10, &t8::A10, column);
            self.stage::<S, _>(11, &t8::A11, column);
            for i in 0..n {
                let start = if i == column { 1.0 } else { 0.0 };
                let change = self.sum::<S, _>(&t8::B, i);
                let end = S::cst(start) + change.scale(self.h);
                end.store(&mut self.maps[i * n + column]);
                let x5 = self.sum::<S, _>(&t8::E5, i);
                let x3 = (end - S::cst(start)).scale(per_h) - self.sum::<S, _>(&t8::BHH, i);
                let largest = S::cst(start) + (end.abs() - S::cst(start)).pos();
                let per_scale = S::one() / (S::one() + largest).scale(self.tolerance);
                e5 += (x5 * per_scale) * (x5 * per_scale);
                e3 += (x3 * per_scale) * (x3 * per_scale);
            }
        }
        let (e5, e3) = (e5.to_array(), e3.to_array());
        let mut worst = 0.0f64;
        for lane in 0..LANES {
            let (e5, e3) = (e5[lane], e3[lane]);
            let error = if e5 == 0.0 { 0.0 } else { self.h.abs() * e5 / ((e5 + 0.01 * e3) * (n * n) as f64).sqrt() };
            // a NaN stays
            if error.is_nan() || error > worst {
                worst = error;
            }
        }
        worst
    }
}

impl Transition {
    /// `map` is multiplied from the left by the maps over [`LANES`] steps of length `h`, the first lane first. Gives the error of the worst step over
    /// `tolerance` (1 + the larger of the sizes of an entry at both ends), as [`Dop853`](super::Dop853) estimates it; NaN where a value is not finite.
    ///
    /// # Panics
    /// When `map` is not n by n, or values are missing.
    pub fn steps(&mut self, a: &Varying, h: f64, tolerance: f64, map: &mut Mat) -> f64 {
        let n = a.n;
        assert!(map.rows() == n && map.cols() == n && a.values.len() >= STAGES * a.width, "a map of another size");
        spend((LANES * STAGES * n * (a.constant.len() + a.entries.len() + 6 * n) + LANES * n * n * n) as u64);
        refill(&mut self.stages, STAGES.max(n) * n, [0.0; LANES]);
        refill(&mut self.state, n, [0.0; LANES]);
        refill(&mut self.maps, n * n, [0.0; LANES]);
        let columns = Columns { a, h, tolerance, stages: &mut self.stages, state: &mut self.state, maps: &mut self.maps };
        let worst = dispatch(Level::best(), columns);
        refill(&mut self.later, n * n, [0.0; LANES]);
        let mut width = LANES;
        while width > 1 {
            width /= 2;
            let (all, later) = (&mut self.maps[..n * n], &mut self.later[..n * n]);
            for (all, later) in all.iter_mut().zip(&mut *later) {
                for l in 0..width {
                    (all[l], later[l]) = (all[2 * l], all[2 * l + 1]);
                }
            }
            dispatch(Level::best(), Product { n, earlier: all, later, out: &mut self.stages });
            all.copy_from_slice(&self.stages[..n * n]);
        }
        self.step.reset(n, n);
        self.step.data_mut().iter_mut().zip(&self.maps).for_each(|(x, all)| *x = all[0]);
        self.step.matmul_into(map, &mut self.product);
        std::mem::swap(&mut self.product, map);
        worst
    }
}
