//! Following modes along a parameter.

use super::mode::Mode;
use super::number::{inner, norm2, overlaps};
use crate::complex::C64;
use crate::dense::{Field, Lu, Mat};

/// How the modes of a new point continue those of the point before.
#[derive(Clone, Debug, PartialEq)]
pub struct Match {
    /// `permutation[i]` is the new mode that continues mode i; `None` if there are fewer new modes.
    pub permutation: Vec<Option<usize>>,
    /// New modes that continue none.
    pub born: Vec<usize>,
    /// Smallest assurance of a matched pair: 1 same shape, 0 nothing in common.
    pub worst_mac: f64,
    /// The match cannot be trusted: shapes have mixed (a veering, or too long a step). The track has not moved; give an intermediate
    /// point, or accept with [`Track::force`] when the step is already as short as wanted.
    pub ambiguous: bool,
    /// Pairs of old modes whose values passed each other while each kept its shape: crossings, or veerings much narrower than the step.
    pub crossings: Vec<(usize, usize)>,
    /// Assurance of every old with every new mode.
    pub assurance: Mat,
}

/// Matches modes from point to point by modal assurance and closeness of the eigenvalues.
///
/// The assurance of modes i and j is `|(y_i^H x_j)(y_j^H x_i)| / |(y_i^H x_i)(y_j^H x_j)|`, which does not depend on units or
/// normalisation, is one for equal modes and zero for different modes of one matrix, also a non-normal one. This needs biorthogonal
/// vectors: those of [`modes`](super::modes), or of `biorthogonal` of a pencil or quadratic problem. Modes without left vectors are
/// compared by right vectors alone. Modes with equal eigenvalues are compared as one subspace, because their vectors are arbitrary in it.
#[derive(Clone, Debug)]
pub struct Track {
    current: Side,
    threshold: f64,
}

/// Modes prepared for comparison: groups of equal eigenvalues, left vectors dual within each group.
#[derive(Clone, Debug)]
struct Side {
    values: Vec<C64>,
    right: Vec<Vec<C64>>,
    dual: Vec<Vec<C64>>,
    group: Vec<usize>,
}

/// Relative distance below which eigenvalues count as equal.
const EQUAL: f64 = 1e-9;

impl Side {
    fn new(modes: &[Mode]) -> Side {
        let n = modes.len();
        let values: Vec<C64> = modes.iter().map(|m| m.value).collect();
        let scale = values.iter().map(|v| v.abs()).fold(0.0, f64::max);
        let mut group: Vec<usize> = (0..n).collect();
        for i in 0..n {
            for j in 0..i {
                if (values[i] - values[j]).abs() <= EQUAL * scale {
                    let (from, to) = (group[i], group[j]);
                    group.iter_mut().filter(|g| **g == from).for_each(|g| *g = to);
                }
            }
        }
        let right: Vec<Vec<C64>> = modes.iter().map(|m| m.right.clone()).collect();
        let pick = |m: &Mode| if m.left.is_empty() { m.right.clone() } else { m.left.clone() };
        let mut dual: Vec<Vec<C64>> = modes.iter().map(pick).collect();
        for g in 0..n {
            let members: Vec<usize> = (0..n).filter(|&i| group[i] == g).collect();
            let left: Vec<Vec<C64>> = members.iter().map(|&i| dual[i].clone()).collect();
            match duals(&left, &members.iter().map(|&i| &right[i][..]).collect::<Vec<_>>()) {
                Some(d) => members.iter().zip(d).for_each(|(&i, d)| dual[i] = d),
                // A defective eigenvalue: left and right vectors are orthogonal, only the shapes themselves are left.
                None => {
                    for &i in &members {
                        group[i] = i;
                        let s = norm2(&right[i]).powi(-2);
                        dual[i] = right[i].iter().map(|z| z.scale(s)).collect();
                    }
                }
            }
        }
        Side { values, right, dual, group }
    }

    /// Some of them, in this order.
    fn ordered(mut self, order: impl Iterator<Item = usize>) -> Side {
        let order: Vec<usize> = order.collect();
        let place = |j: usize| order.iter().position(|&o| o == j);
        // a group is named by one of its members
        let first = |j: usize| order.iter().find(|&&o| self.group[o] == self.group[j]).and_then(|&o| place(o));
        let group = order.iter().filter_map(|&j| first(j)).collect();
        Side {
            values: order.iter().map(|&j| self.values[j]).collect(),
            right: order.iter().map(|&j| std::mem::take(&mut self.right[j])).collect(),
            dual: order.iter().map(|&j| std::mem::take(&mut self.dual[j])).collect(),
            group,
        }
    }

    fn members(&self, g: usize) -> usize {
        self.group.iter().filter(|&&x| x == g).count()
    }
}

/// Vectors w_i in the span of `left` with `w_i^H x_j = delta_ij`; `None` where this is not possible.
fn duals(left: &[Vec<C64>], right: &[&[C64]]) -> Option<Vec<Vec<C64>>> {
    let n = left.len();
    let unit = |v: &[C64]| norm2(v);
    // w = sum_k y_k t_k with G^H t = e, G_kj = y_k^H x_j.
    let g = Mat::from_fn(n, n, |j, k| inner(&left[k], right[j]).conj().scale(1.0 / (unit(&left[k]) * unit(right[j]))));
    let lu = Lu::new(&g).ok()?;
    let strength = (0..n).map(|i| g[(i, i)].abs()).fold(f64::INFINITY, f64::min);
    if lu.pivot_ratio().is_nan() || lu.pivot_ratio() < 1e-7 || (n == 1 && strength < 1e-7) {
        return None;
    }
    let mut t = Mat::identity(n);
    lu.solve_mat(&mut t);
    let mut out = Vec::with_capacity(n);
    for (i, x) in right.iter().enumerate() {
        let mut w = vec![C64::ZERO; left[i].len()];
        for (k, y) in left.iter().enumerate() {
            let f = t[(k, i)].scale(1.0 / (unit(y) * unit(x)));
            w.iter_mut().zip(y).for_each(|(w, &y)| *w += f * y);
        }
        out.push(w);
    }
    Some(out)
}

impl Track {
    /// A track that starts at these modes.
    pub fn new(modes: &[Mode]) -> Track {
        Track { current: Side::new(modes), threshold: 0.8 }
    }

    /// The assurance below which a match is ambiguous (0.8 unless set).
    pub fn with_threshold(self, threshold: f64) -> Track {
        Track { threshold, ..self }
    }

    /// Matches the modes of the next point. Unless the match is ambiguous the track moves there; its mode i is from then on
    /// `modes[permutation[i]]`, followed by those born.
    pub fn next(&mut self, modes: &[Mode]) -> Match {
        let (m, side) = self.compare(modes);
        if !m.ambiguous {
            self.move_to(side, &m);
        }
        m
    }

    /// Like [`Track::next`], but moves also where the match is ambiguous.
    pub fn force(&mut self, modes: &[Mode]) -> Match {
        let (m, side) = self.compare(modes);
        self.move_to(side, &m);
        m
    }

    fn move_to(&mut self, side: Side, m: &Match) {
        self.current = side.ordered(m.permutation.iter().flatten().chain(&m.born).copied());
    }

    /// How these modes continue those of the track; and they themselves.
    fn compare(&self, modes: &[Mode]) -> (Match, Side) {
        let (old, new) = (&self.current, Side::new(modes));
        let (n, m) = (old.values.len(), new.values.len());
        let mac = assurance(old, &new);
        let distance = Mat::from_fn(n, m, |i, j| (old.values[i] - new.values[j]).abs());
        let [sizes, others] = [old, &new].map(|side| side.values.iter().map(|v| v.abs()).collect::<Vec<f64>>());
        let cost = Mat::from_fn(n, m, |i, j| {
            let size = sizes[i] + others[j];
            let apart = if size > 0.0 { distance[(i, j)] / size } else { 0.0 };
            (1.0 - mac[(i, j)]) + 0.25 * apart
        });
        let permutation = if cost.max_size().is_finite() { assign(&cost) } else { vec![None; n] };
        let matched = || permutation.iter().enumerate().filter_map(|(i, p)| p.map(|j| (i, j)));
        let worst_mac = matched().map(|(i, j)| mac[(i, j)]).fold(1.0, f64::min);
        let born = (0..m).filter(|j| !permutation.contains(&Some(*j))).collect();
        let ambiguous = worst_mac < self.threshold || permutation.iter().filter(|p| p.is_some()).count() < n.min(m);
        let mut crossings = vec![];
        for (i, j) in matched() {
            for (k, l) in matched().filter(|&(k, _)| k > i && old.group[k] != old.group[i]) {
                let near = |a: usize, b: usize| distance[(a, b)];
                if near(i, l).max(near(k, j)) < near(i, j).max(near(k, l)) && new.group[j] != new.group[l] {
                    crossings.push((i, k));
                }
            }
        }
        (Match { permutation, born, worst_mac, ambiguous, crossings, assurance: mac }, new)
    }
}

/// Assurance of every old with every new mode: the trace of the product of the two spectral projectors over the smaller dimension.
fn assurance(old: &Side, new: &Side) -> Mat {
    let (n, m) = (old.values.len(), new.values.len());
    let (there, back) = (overlaps(&old.dual, &new.right), overlaps(&new.dual, &old.right));
    let mut sums = Mat::<C64>::zeros(n, m);
    for i in 0..n {
        for j in 0..m {
            sums[(old.group[i], new.group[j])] += there[(i, j)] * back[(j, i)];
        }
    }
    let [of_old, of_new] = [old, new].map(|side| (0..side.group.len()).map(|g| side.members(g)).collect::<Vec<usize>>());
    Mat::from_fn(n, m, |i, j| {
        let (g, h) = (old.group[i], new.group[j]);
        let a = sums[(g, h)].abs() / of_old[g].min(of_new[h]) as f64;
        // Projectors that are not orthogonal may have a trace above one, which is as unlike as its inverse.
        if a > 1.0 { 1.0 / a } else { a }
    })
}

/// Optimal assignment (Hungarian method, O(n^2 m)): for each row its column, with the least sum of costs; rows left over get `None`.
/// Costs must be finite.
pub fn assign(cost: &Mat) -> Vec<Option<usize>> {
    if cost.rows() > cost.cols() {
        let mut rows = vec![None; cost.rows()];
        for (j, i) in assign(&cost.transpose()).into_iter().enumerate() {
            if let Some(i) = i {
                rows[i] = Some(j);
            }
        }
        return rows;
    }
    let (n, m) = (cost.rows(), cost.cols());
    // Potentials u, v; owner[j] is the row (from 1) that holds column j (from 1); column 0 holds the row being placed.
    let (mut u, mut v) = (vec![0.0; n + 1], vec![0.0; m + 1]);
    let (mut owner, mut way) = (vec![0usize; m + 1], vec![0usize; m + 1]);
    for i in 1..=n {
        owner[0] = i;
        let mut j0 = 0;
        let (mut least, mut used) = (vec![f64::INFINITY; m + 1], vec![false; m + 1]);
        while owner[j0] != 0 {
            used[j0] = true;
            let (row, mut delta, mut j1) = (owner[j0], f64::INFINITY, 0);
            for j in 1..=m {
                if used[j] {
                    continue;
                }
                let reduced = cost[(row - 1, j - 1)] - u[row] - v[j];
                if reduced < least[j] {
                    (least[j], way[j]) = (reduced, j0);
                }
                if least[j] < delta {
                    (delta, j1) = (least[j], j);
                }
            }
            for j in 0..=m {
                if used[j] {
                    u[owner[j]] += delta;
                    v[j] -= delta;
                } else {
                    least[j] -= delta;
                }
            }
            j0 = j1;
        }
        while j0 != 0 {
            owner[j0] = owner[way[j0]];
            j0 = way[j0];
        }
    }
    let mut rows = vec![None; n];
    for (j, &i) in owner.iter().enumerate().skip(1) {
        if i > 0 {
            rows[i - 1] = Some(j - 1);
        }
    }
    rows
}
