//! How matrices of one pattern are factored, decided once.

use super::Pattern;
use super::order::{half_width, reverse_cuthill_mckee};
use std::sync::Arc;

/// Up to this size the dense factorisation is the faster one (measured on chains of four unknowns a station: equal at about 24).
const SMALL: usize = 24;
/// Most unknowns in the border.
const BORDER: usize = 64;
/// A band that is wider than this times the least width that its fullest row allows may be a ring: a chain whose ends couple with one foundation. So many borders that open it are tried.
const RING: usize = 3;
const OPENINGS: usize = 8;

/// Most numbers of a band that is stored for every lane.
const IN_LANES: usize = 250_000;

/// How matrices of one pattern are factored.
///
/// A dense matrix where it is small; else a band after renumbering, and a border of the few unknowns that couple what is far apart. Which of them is used
/// changes rounding and cost alone. A sparse factorisation with columns ordered by COLAMD (that of faer 0.24) took 4 to 5 times as long as the band on plates
/// of 1200 to 4050 unknowns and on lattices in space of 375 to 3993: it is not among them.
#[derive(Clone, Debug)]
pub struct Plan {
    pub(super) pattern: Arc<Pattern>,
    /// `None` of a dense one.
    pub(super) band: Option<Band>,
}

/// A band with a border.
#[derive(Clone, Debug)]
pub(super) struct Band {
    /// Place by place the unknown that stands there; those of the border come last.
    pub order: Vec<usize>,
    /// Number of unknowns in the band.
    pub inner: usize,
    /// Distance of the outermost diagonals.
    pub half: usize,
    /// Where each entry of the pattern goes, in the order of its entries.
    pub targets: Vec<Target>,
}

/// Place of an entry.
#[derive(Clone, Copy, Debug)]
pub(super) enum Target {
    /// In the storage of the band.
    Band(usize),
    /// Row in the band, column of the border.
    Right(usize, usize),
    /// Row of the border, column in the band.
    Below(usize, usize),
    /// Row and column of the border.
    Corner(usize, usize),
}

/// Multiplications of a factorisation of a band with a border.
pub(super) fn effort(inner: usize, half: usize, border: usize) -> f64 {
    let (n, b, k) = (inner as f64, half as f64, border as f64);
    n * b * (2.0 * b + 1.0) + n * k * (3.0 * b + k) + k * k * k / 3.0
}

/// Groups of unknowns that couple with the same others, of the least degree: removing one opens a ring.
fn openings(pattern: &Pattern, by_degree: &[usize]) -> Vec<Vec<usize>> {
    let columns = |i: usize| pattern.row(i).map(|e| e.1);
    let mut taken = vec![false; pattern.n()];
    let mut out = Vec::new();
    for &first in by_degree.iter().rev() {
        if taken[first] {
            continue;
        }
        let group: Vec<usize> = columns(first).filter(|&j| columns(j).eq(columns(first))).collect();
        group.iter().for_each(|&i| taken[i] = true);
        if group.len() <= BORDER {
            out.push(group);
        }
        if out.len() == OPENINGS {
            break;
        }
    }
    out
}

impl Plan {
    /// For the matrices of a pattern.
    pub fn new(pattern: &Arc<Pattern>) -> Self {
        let n = pattern.n();
        let dense = Plan { pattern: pattern.clone(), band: None };
        if n <= SMALL {
            return dense;
        }
        let degree = |i: usize| pattern.row(i).count();
        let mut by_degree: Vec<usize> = (0..n).collect();
        by_degree.sort_by_key(|&i| (std::cmp::Reverse(degree(i)), i));
        // unknowns of equal degree go together: those of one point of a foundation
        let steps = (0..=BORDER.min(n / 2)).filter(|&k| k == 0 || degree(by_degree[k - 1]) > degree(by_degree[k]));
        let mut best: Option<(f64, Vec<usize>, usize, usize)> = None;
        let mut attempt = |border: &[usize]| {
            let mut inside = vec![true; n];
            border.iter().for_each(|&i| inside[i] = false);
            let mut order = reverse_cuthill_mckee(pattern, &inside);
            let (inner, half) = (order.len(), half_width(pattern, &order));
            let cost = effort(inner, half, border.len());
            if best.as_ref().is_none_or(|b| cost < b.0) {
                let mut rest = border.to_vec();
                rest.sort_unstable();
                order.extend(rest);
                best = Some((cost, order, inner, half));
            }
            half
        };
        let narrowest = steps.map(|border| attempt(&by_degree[..border])).min().unwrap_or(0);
        if 2 * narrowest > RING * (degree(by_degree[0]) / 2) {
            for border in openings(pattern, &by_degree) {
                attempt(&border);
            }
        }
        let Some((_, order, inner, half)) = best.filter(|b| b.0 < (n as f64).powi(3) / 3.0) else { return dense };
        let mut place = vec![0; n];
        order.iter().enumerate().for_each(|(k, &i)| place[i] = k);
        let mut targets = vec![Target::Band(0); pattern.entries()];
        for i in 0..n {
            for (e, j) in pattern.row(i) {
                let (r, c) = (place[i], place[j]);
                targets[e] = match (r < inner, c < inner) {
                    (true, true) => Target::Band(stored(half, r, c)),
                    (true, false) => Target::Right(r, c - inner),
                    (false, true) => Target::Below(r - inner, c),
                    (false, false) => Target::Corner(r - inner, c - inner),
                };
            }
        }
        Plan { pattern: pattern.clone(), band: Some(Band { order, inner, half, targets }) }
    }

    /// Unknowns.
    pub fn n(&self) -> usize {
        self.pattern.n()
    }
    /// The pattern.
    pub fn pattern(&self) -> &Arc<Pattern> {
        &self.pattern
    }
    /// The matrix is so small that it is factored as a dense one.
    pub fn is_dense(&self) -> bool {
        self.band.is_none()
    }
    /// Matrices of this plan are factored side by side in lanes: a band of moderate size.
    pub fn suits_lanes(&self) -> bool {
        self.band.as_ref().is_some_and(|b| b.inner * width(b.half) <= IN_LANES)
    }
    /// Some unknowns stand in a border.
    pub(super) fn has_border(&self) -> bool {
        self.band.as_ref().is_some_and(|b| b.order.len() > b.inner)
    }
    /// Multiplications of one factorisation, about.
    pub fn multiplications(&self) -> u64 {
        match &self.band {
            None => (self.n().pow(3) / 3) as u64,
            Some(b) => effort(b.inner, b.half, b.order.len() - b.inner) as u64,
        }
    }
    /// Numbers stored by one factorisation.
    pub fn stored(&self) -> usize {
        match &self.band {
            None => self.n() * self.n(),
            Some(b) => {
                let border = b.order.len() - b.inner;
                b.inner * width(b.half) + border * (2 * b.inner + border)
            }
        }
    }
}

/// Length of a stored column of a band: its diagonals and those that row exchanges add above.
pub(super) fn width(half: usize) -> usize {
    3 * half + 1
}

/// Place of an entry of the band in storage column by column.
#[inline]
pub(super) fn stored(half: usize, row: usize, column: usize) -> usize {
    column * width(half) + 2 * half + row - column
}
