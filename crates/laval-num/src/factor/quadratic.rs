//! A quadratic matrix `T(s) = A0 + s A1 + s^2 A2` by its entries that are not zero, scaled for some size of s.

use super::plan::Target;
use super::{Number, Plan, scales};
use crate::complex::C64;
use crate::dense::Field;

/// An entry of the matrices.
#[derive(Clone, Copy, Debug)]
pub(super) struct Term {
    pub row: usize,
    pub column: usize,
    /// Its place where matrices are factored as bands.
    pub target: Target,
    /// Its values in A0, A1 and A2.
    pub values: [C64; 3],
}

/// The three matrices of one plan, rows and columns multiplied by powers of two that bring their largest entries near one.
#[derive(Clone, Debug)]
pub struct ScaledQuadratic {
    pub(super) plan: Plan,
    pub(super) terms: Vec<Term>,
    pub(super) rows: Vec<f64>,
    pub(super) columns: Vec<f64>,
}

impl ScaledQuadratic {
    /// Of the entries of the pattern of a plan, for s of about this size. `None` of a plan that does not suit lanes.
    pub fn new(plan: &Plan, [a0, a1, a2]: [&[C64]; 3], size: f64) -> Option<Self> {
        let band = plan.band.as_ref().filter(|_| plan.suits_lanes())?;
        let n = plan.n();
        let mut terms = Vec::with_capacity(a0.len());
        for row in 0..n {
            for (e, column) in plan.pattern.row(row) {
                let values = [a0[e], a1[e], a2[e]];
                if values.iter().any(|x| *x != C64::ZERO) {
                    terms.push(Term { row, column, target: band.targets[e], values });
                }
            }
        }
        let sizes = terms.iter().map(|t| (t.row, t.column, t.values[0].size() + size * (t.values[1].size() + size * t.values[2].size())));
        let (rows, columns) = scales(n, &sizes.collect::<Vec<_>>());
        for t in &mut terms {
            t.values = t.values.map(|x| x.times(rows[t.row] * columns[t.column]));
        }
        Some(ScaledQuadratic { plan: plan.clone(), terms, rows, columns })
    }

    /// Unknowns.
    pub fn n(&self) -> usize {
        self.plan.n()
    }
    /// Powers of two that rows were multiplied by.
    pub fn rows(&self) -> &[f64] {
        &self.rows
    }
    /// Powers of two that columns were multiplied by.
    pub fn columns(&self) -> &[f64] {
        &self.columns
    }
}
