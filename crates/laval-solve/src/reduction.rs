//! Reduction of a linear structure of many coordinates to its ports and a few modes.
//!
//! ```text
//! q = [Psi Phi] [u; p],    u = B q displacements of the ports
//! K Psi = B' f, B Psi = I      static shapes for unit displacements of the ports
//! K Phi + B' f = w^2 M Phi, B Phi = 0      modes with the ports held, the lowest
//! ```
//!
//! All matrices of the structure are projected from both sides with the same basis (Craig and Bampton), so that symmetry, skew symmetry and the sign of energies stay, and statics is exact at
//! the ports. The modes with the ports held are those of a block Krylov space of `K^-1 M` that begins with the loads of inertia of the static shapes. To those up to a multiple of the
//! frequency vectors of that space are added, which stand for all higher modes at once, until the receptance of the ports, `B Z(s)^-1 B'`, is met at places that the reduction did not use.
//!
//! Symbols: K, M symmetric stiffness and mass; Z(s) = s^2 M + s (C + W G) + K + W N with internal states eliminated; w frequency up to which it holds, rad/s.
//!
//! Sources: R. R. Craig, M. C. C. Bampton, AIAA J. 6 (1968) 1313; Z. Bai, Appl. Numer. Math. 43 (2002) 9.

use crate::model::part::At;
use crate::model::station::Row;
use crate::model::system::{Slot, System};
use crate::model::tangent::{SparseTangent, TangentOf, TangentScratch, Triplets};
use laval_num::complex::{C64, c};
use laval_num::dense::{Field, Lu, Mat};
use laval_num::eig::definite;
use laval_num::factor::{Factors, Pattern, Plan};
use laval_num::work::spend;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Distance of the places of comparison from the imaginary axis, over the frequency: undamped resonances lie on it.
const ASIDE: f64 = 0.02;
/// Shares of the frequency at which receptances are compared.
const PLACES: [f64; 6] = [0.11, 0.23, 0.41, 0.59, 0.83, 1.0];
/// Modes that are kept: those below this multiple of the frequency.
const WIDER: f64 = 1.5;
/// Vectors of the Krylov space over the most coordinates of the reduced structure.
const SPACE: usize = 2;
/// Part of a vector that is left when those before it are taken out, below which it is none of its own.
const NEW: f64 = 1e-6;

/// What a machine was reduced to.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Reduced {
    /// Number of coordinates.
    pub coordinates: usize,
    /// Frequency up to which the receptance of the ports was compared, rad/s.
    pub frequency: f64,
    /// Its largest relative difference.
    pub error: f64,
}

impl Reduced {
    /// Of two reductions the one with the larger error.
    pub fn worse(one: Option<Reduced>, other: Option<Reduced>) -> Option<Reduced> {
        one.into_iter().chain(other).reduce(|a, b| if b.error > a.error { b } else { a })
    }
}

/// A basis of few coordinates for a machine's linear parts.
#[derive(Clone, Debug)]
pub struct Reduction {
    /// Coordinates of the machine over the reduced ones, ports first.
    pub basis: Mat,
    /// Number of ports.
    pub ports: usize,
    /// Frequency up to which it was compared, rad/s.
    pub frequency: f64,
    /// Largest difference of the receptance of the ports over its size.
    pub error: f64,
}

/// Linear parts of a machine at one speed, as lists of entries.
struct Linear {
    n: usize,
    m: usize,
    tangent: SparseTangent,
}

impl Linear {
    fn at(system: &System, which: &dyn Fn(&Slot) -> bool, speed: f64) -> Self {
        let (n, m) = (system.n(), system.m());
        let (q, z) = (vec![0.0; n], vec![0.0; m]);
        let at = At { q: &q, v: &q, a: &q, z: &z, phase: 0.0, speed, spin_accel: 0.0, t: 0.0 };
        let (mut tangent, mut scratch) = (SparseTangent::default(), TangentScratch::default());
        system.tangent(&at, false, &mut tangent, &mut scratch, which);
        Linear { n, m, tangent }
    }

    /// `Z(s)` over coordinates and states, on its own pattern.
    fn receptance(&self, s: C64, ports: &[Row]) -> Option<Mat<C64>> {
        let (n, t) = (self.n, &self.tangent);
        let one = c(1.0, 0.0);
        let mut entries: Vec<(usize, usize, C64)> = Vec::new();
        let mut add = |list: &Triplets, row: usize, col: usize, factor: C64| {
            entries.extend(list.0.iter().map(|&(i, j, x)| (row + i, col + j, factor.scale(x))))
        };
        for (list, factor) in [(&t.q, one), (&t.v, s), (&t.a, s * s)] {
            add(list, 0, 0, factor);
        }
        add(&t.z, 0, n, one);
        for (list, factor) in [(&t.rate_q, -one), (&t.rate_v, -s), (&t.rate_a, -(s * s))] {
            add(list, n, 0, factor);
        }
        add(&t.rate_z, n, n, -one);
        entries.extend((n..n + self.m).map(|i| (i, i, s)));
        let pattern = Arc::new(Pattern::new(n + self.m, entries.iter().map(|e| (e.0, e.1))));
        let mut values = vec![C64::ZERO; pattern.entries()];
        for (i, j, x) in entries {
            values[pattern.index(i, j)?] += x;
        }
        let factors = Factors::new(&Plan::new(&pattern), &values).ok()?;
        let mut out = Mat::zeros(ports.len(), ports.len());
        let mut x = vec![C64::ZERO; n + self.m];
        for (j, port) in ports.iter().enumerate() {
            x.fill(C64::ZERO);
            port.iter().for_each(|&(g, f)| x[g] += c(f, 0.0));
            factors.solve(&mut x);
            for (i, row) in ports.iter().enumerate() {
                out[(i, j)] = row.iter().fold(C64::ZERO, |sum, &(g, f)| sum + x[g].scale(f));
            }
        }
        Some(out)
    }
}

/// Tangents with respect to the coordinates of a basis.
pub fn projected(basis: &Mat, from: &SparseTangent, out: &mut TangentOf<Mat>) {
    let (n, r) = (basis.rows(), basis.cols());
    let m = from.rate.len();
    // T' A T, A T and T' A of lists
    let right = |list: &Triplets, rows: usize| {
        let mut x = Mat::zeros(rows, r);
        for &(i, j, a) in &list.0 {
            x.row_mut(i).iter_mut().zip(basis.row(j)).for_each(|(o, b)| *o += a * b);
        }
        x
    };
    let left = |x: &Mat| {
        let mut y = Mat::zeros(r, x.cols());
        for i in 0..n {
            for (k, b) in basis.row(i).iter().enumerate().filter(|(_, b)| **b != 0.0) {
                y.row_mut(k).iter_mut().zip(x.row(i)).for_each(|(o, a)| *o += a * b);
            }
        }
        y
    };
    (out.q, out.v, out.a) = (left(&right(&from.q, n)), left(&right(&from.v, n)), left(&right(&from.a, n)));
    (out.rate_q, out.rate_v, out.rate_a) = (right(&from.rate_q, m), right(&from.rate_v, m), right(&from.rate_a, m));
    let full = |list: &Triplets, rows: usize| {
        let mut x = Mat::zeros(rows, m);
        list.0.iter().for_each(|&(i, j, a)| x[(i, j)] += a);
        x
    };
    out.z = left(&full(&from.z, n));
    out.rate_z = full(&from.rate_z, m);
    out.rate = from.rate.clone();
    out.force = vec![0.0; r];
    for i in 0..n {
        out.force.iter_mut().zip(basis.row(i)).for_each(|(o, b)| *o += from.force[i] * b);
    }
    spend((10 * from.q.0.len() * r) as u64);
}

/// `Z(s)` of projected tangents with its states.
fn dense(t: &TangentOf<Mat>, s: C64) -> Mat<C64> {
    let (r, m) = (t.q.rows(), t.rate_z.rows());
    let s2 = s * s;
    Mat::from_fn(r + m, r + m, |i, j| match (i < r, j < r) {
        (true, true) => c(t.q[(i, j)], 0.0) + s.scale(t.v[(i, j)]) + s2.scale(t.a[(i, j)]),
        (true, false) => c(t.z[(i, j - r)], 0.0),
        (false, true) => -(c(t.rate_q[(i - r, j)], 0.0) + s.scale(t.rate_v[(i - r, j)]) + s2.scale(t.rate_a[(i - r, j)])),
        (false, false) => (if i == j { s } else { C64::ZERO }) - c(t.rate_z[(i - r, j - r)], 0.0),
    })
}

/// The structure with its ports held: factors of `[K B'; B 0]` and products with K and M.
struct Held {
    n: usize,
    pattern: Arc<Pattern>,
    factors: Factors<f64>,
    stiffness: Vec<f64>,
    mass: Vec<f64>,
}

impl Held {
    fn new(linear: &Linear, ports: &[Row], shift: f64) -> Option<Self> {
        let (n, p) = (linear.n, ports.len());
        let lists = [&linear.tangent.q, &linear.tangent.a];
        let border = ports.iter().enumerate().flat_map(|(j, row)| row.iter().map(move |&(g, x)| (g, n + j, x)));
        let places = lists.iter().flat_map(|l| l.0.iter().map(|e| (e.0, e.1))).chain(border.clone().map(|e| (e.0, e.1)));
        let pattern = Arc::new(Pattern::new(n + p, places));
        let symmetric = |list: &Triplets| -> Option<Vec<f64>> {
            let mut out = vec![0.0; pattern.entries()];
            for &(i, j, x) in &list.0 {
                out[pattern.index(i, j)?] += 0.5 * x;
                out[pattern.index(j, i)?] += 0.5 * x;
            }
            Some(out)
        };
        let (mut stiffness, mass) = (symmetric(lists[0])?, symmetric(lists[1])?);
        stiffness.iter_mut().zip(&mass).for_each(|(k, m)| *k += shift * m);
        let mut values = stiffness.clone();
        for (g, row, x) in border {
            values[pattern.index(g, row)?] = x;
            values[pattern.index(row, g)?] = x;
        }
        let factors = Factors::new(&Plan::new(&pattern), &values).ok()?;
        Some(Held { n, pattern, factors, stiffness, mass })
    }
    fn product(&self, values: &[f64], x: &[f64]) -> Vec<f64> {
        let row = |i: usize| self.pattern.row(i).filter(|e| e.1 < self.n).map(|(e, j)| values[e] * x[j]).sum();
        (0..self.n).map(row).collect()
    }
    /// `q` of `[K B'; B 0] [q; f] = [load; displacements]`.
    fn solve(&self, load: &[f64], displacement: Option<usize>) -> Vec<f64> {
        let mut x = load.to_vec();
        x.resize(self.pattern.n(), 0.0);
        if let Some(j) = displacement {
            x[self.n + j] = 1.0;
        }
        self.factors.solve(&mut x);
        x.truncate(self.n);
        spend((20 * self.pattern.entries()) as u64);
        x
    }
}

impl Reduction {
    /// For some linear parts of a machine with these ports, so that receptances are met to the tolerance up to a frequency (rad/s) at these speeds (rad/s), by at
    /// most so many coordinates. `None` where the structure cannot be reduced or too many coordinates are needed for a tenth of accuracy.
    pub fn new(
        system: &System,
        which: &dyn Fn(&Slot) -> bool,
        ports: &[Row],
        frequency: f64,
        speeds: &[f64],
        tolerance: f64,
        most: usize,
    ) -> Option<Self> {
        let all: Vec<Linear> = speeds.iter().map(|&w| Linear::at(system, which, w)).collect();
        let first = all.first()?;
        // a structure that its ports do not hold gets a little stiffness from its mass
        let held = Held::new(first, ports, 0.0).or_else(|| Held::new(first, ports, (0.1 * frequency).powi(2)))?;
        let n = first.n;
        let shapes: Vec<Vec<f64>> = (0..ports.len()).map(|j| held.solve(&vec![0.0; n], Some(j))).collect();
        if shapes.iter().flatten().any(|x| !x.is_finite()) {
            return None;
        }
        let space = krylov(&held, ports, &shapes, most);
        let (modes, squares) = modes(&held, &space)?;
        let places: Vec<(usize, C64, Mat<C64>)> = (0..all.len())
            .flat_map(|k| PLACES.map(|share| (k, c(ASIDE, 1.0).scale(share * frequency))))
            .map(|(k, s)| Some((k, s, all[k].receptance(s, ports)?)))
            .collect::<Option<_>>()?;
        let low = squares.iter().take_while(|w2| **w2 < (WIDER * frequency).powi(2)).count();
        let vectors = added(&held, &modes[..low], &space);
        let most = vectors.len().min(most.saturating_sub(ports.len()));
        let mut count = low;
        let mut best: Option<Reduction> = None;
        loop {
            count = count.min(most);
            let (modes, _) = self::modes(&held, &vectors[..count])?;
            let columns: Vec<&Vec<f64>> = shapes.iter().chain(&modes).collect();
            let basis = Mat::from_fn(n, columns.len(), |i, j| columns[j][i]);
            let error = error(&basis, &all, ports, &places);
            let better = best.as_ref().is_none_or(|b| error < b.error);
            if better {
                best = Some(Reduction { basis, ports: ports.len(), frequency, error });
            }
            if error <= tolerance || count >= most {
                return best.filter(|b| b.error < 0.1);
            }
            count += 4.max(count / 4);
        }
    }

    /// The reduced coordinates over the machine's: displacements of the ports, and by their inertia (entries of M) the shares of the modes in the rest.
    pub fn inverse(&self, mass: &Triplets, ports: &[Row]) -> Mat {
        let (n, r) = (self.basis.rows(), self.basis.cols());
        let mut out = Mat::zeros(r, n);
        for (k, row) in ports.iter().enumerate() {
            row.iter().for_each(|&(g, x)| out[(k, g)] += x);
        }
        // Phi' M (q - Psi u); modes have unit inertia
        for &(i, j, m) in &mass.0 {
            for k in self.ports..r {
                out[(k, j)] += self.basis[(i, k)] * m;
            }
        }
        for k in self.ports..r {
            for (p, row) in ports.iter().enumerate() {
                let share: f64 = (0..n).map(|i| out[(k, i)] * self.basis[(i, p)]).sum();
                row.iter().for_each(|&(g, x)| out[(k, g)] -= share * x);
            }
        }
        out
    }
    /// In numbers.
    pub fn summary(&self) -> Reduced {
        Reduced { coordinates: self.basis.cols(), frequency: self.frequency, error: self.error }
    }
    /// A combination of the machine's coordinates over the reduced ones.
    pub fn row(&self, of: &[(usize, f64)]) -> Row {
        let mut sum = vec![0.0; self.basis.cols()];
        for &(g, x) in of {
            sum.iter_mut().zip(self.basis.row(g)).for_each(|(s, b)| *s += x * b);
        }
        let largest = sum.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        sum.into_iter().enumerate().filter(|(_, x)| x.abs() > 1e-14 * largest).collect()
    }
}

/// A vector that holds the ports, and its product with the stiffness.
type Vector = (Vec<f64>, Vec<f64>);

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// What is left of a vector when others, orthonormal in the stiffness, are taken out, as one of norm one; `None` where that is rounding.
fn orthonormal(held: &Held, mut x: Vec<f64>, others: &[Vector], holding: impl Fn(&mut Vec<f64>)) -> Option<Vector> {
    let size = dot(&x, &held.product(&held.stiffness, &x)).sqrt();
    if !(size > 0.0) {
        return None;
    }
    x.iter_mut().for_each(|x| *x /= size);
    spend((4 * held.n * (others.len() + 1)) as u64);
    for _ in 0..2 {
        for (b, kb) in others {
            let share = dot(&x, kb);
            x.iter_mut().zip(b).for_each(|(x, b)| *x -= share * b);
        }
    }
    holding(&mut x);
    let kx = held.product(&held.stiffness, &x);
    let left = dot(&x, &kx).sqrt();
    let unit = |x: Vec<f64>| x.into_iter().map(|x| x / left).collect::<Vec<f64>>();
    (left > NEW).then(|| (unit(x), unit(kx)))
}

/// The block Krylov space, orthonormal in the stiffness, in the order in which it grows.
fn krylov(held: &Held, ports: &[Row], shapes: &[Vec<f64>], most: usize) -> Vec<Vector> {
    let mut space: Vec<Vector> = Vec::new();
    let wanted = (SPACE * most).min(held.n.saturating_sub(shapes.len()));
    let mut block: Vec<Vec<f64>> = shapes.to_vec();
    // a direction for what the ports do not move
    block.push((0..held.n).map(|i| (1.7 * i as f64 + 0.3).sin()).collect());
    // what little is left must hold the ports, too
    let holding = |x: &mut Vec<f64>| {
        for (shape, port) in shapes.iter().zip(ports) {
            let away: f64 = port.iter().map(|&(g, f)| f * x[g]).sum();
            x.iter_mut().zip(shape).for_each(|(x, s)| *x -= away * s);
        }
    };
    while space.len() < wanted && !block.is_empty() {
        let mut next = Vec::new();
        for v in &block {
            let x = held.solve(&held.product(&held.mass, v), None);
            if let Some(vector) = orthonormal(held, x, &space, holding).filter(|_| space.len() < wanted) {
                next.push(vector.0.clone());
                space.push(vector);
            }
        }
        block = next;
    }
    space
}

/// Some modes, and after them what the vectors of a space add to them.
fn added(held: &Held, modes: &[Vec<f64>], space: &[Vector]) -> Vec<Vector> {
    let mut out: Vec<Vector> = Vec::new();
    for x in modes.iter().chain(space.iter().map(|v| &v.0)) {
        out.extend(orthonormal(held, x.clone(), &out, |_| ()));
    }
    out
}

/// The modes within a space, of unit inertia, by rising square of their frequency.
fn modes(held: &Held, space: &[Vector]) -> Option<(Vec<Vec<f64>>, Vec<f64>)> {
    let products: Vec<Vec<f64>> = space.iter().map(|(x, _)| held.product(&held.mass, x)).collect();
    let size = space.len();
    if size == 0 {
        return Some((Vec::new(), Vec::new()));
    }
    let mass = Mat::from_fn(size, size, |i, j| dot(&space[i].0, &products[j]));
    let gram = Mat::from_fn(size, size, |i, j| dot(&space[i].0, &space[j].1));
    let (values, vectors) = definite(&mass, &gram).ok()?;
    // 1/w^2, largest last
    let rising: Vec<usize> = (0..size).rev().filter(|&k| values[k] > 0.0).collect();
    let mode = |&k: &usize| {
        let mut x = vec![0.0; held.n];
        for (j, (v, _)) in space.iter().enumerate() {
            x.iter_mut().zip(v).for_each(|(x, v)| *x += vectors[(j, k)] * v);
        }
        x.iter_mut().for_each(|x| *x /= values[k].sqrt());
        x
    };
    Some((rising.iter().map(mode).collect(), rising.iter().map(|&k| 1.0 / values[k]).collect()))
}

/// Largest difference of the receptances over their sizes.
fn error(basis: &Mat, all: &[Linear], ports: &[Row], places: &[(usize, C64, Mat<C64>)]) -> f64 {
    let size = |m: &Mat<C64>| m.data().iter().map(|x| x.norm_sqr()).sum::<f64>().sqrt();
    let mut tangents: Vec<TangentOf<Mat>> = Vec::new();
    for linear in all {
        let mut t = TangentOf::default();
        projected(basis, &linear.tangent, &mut t);
        tangents.push(t);
    }
    let mut worst = 0.0f64;
    for (k, s, exact) in places {
        let t = &tangents[*k];
        let p = ports.len();
        // the displacements of the ports are the first coordinates
        let mut x = Mat::from_fn(t.q.rows() + t.rate_z.rows(), p, |i, j| if i == j { C64::ONE } else { C64::ZERO });
        let Ok(lu) = Lu::new(&dense(t, *s)) else { return f64::INFINITY };
        lu.solve_mat(&mut x);
        let gap = Mat::from_fn(p, p, |i, j| x[(i, j)] - exact[(i, j)]);
        let relative = size(&gap) / size(exact);
        if !(relative <= worst) {
            worst = relative;
        }
    }
    worst
}
