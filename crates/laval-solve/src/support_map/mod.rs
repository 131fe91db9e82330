//! Undamped critical speeds over the stiffness of the supports.
//!
//! ```text
//! [K + k sum b b^H - W^2 (M - i G)] u = 0        synchronous: s = i W
//! ```
//!
//! Hermitian and linear in W^2. With K + .. positive the number of positive W^2 below a value is the number of negative pivots there, also where M - i G is indefinite
//! (polar above diametral inertia): those that it lacks are no critical speeds. Roots are bracketed by that count and solved for by Rayleigh quotients.
//!
//! Of a machine without preferred direction the forward whirls are a problem of their own: `(x, y) = (r, -i r)`, `(alpha, beta) = (i s, s)`.
//!
//! Theory: `docs/theory/linear-vibration.md#supports`.

mod skyline;

use crate::diagnostic::Diagnostic;
use crate::model::part::{DofKind, Physics};
use crate::model::system::System;
use crate::statics::Statics;
use crate::statics::forces::blocks;
use crate::statics::supports::{Support, is_open};
use laval_model::text;
use laval_num::complex::{C64, c};
use laval_num::dense::Field;
use serde::{Deserialize, Serialize};
use skyline::{Envelope, Factors};

/// A critical speed, or a frequency at rest.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Root {
    /// W, rad/s.
    pub speed: f64,
    /// Share of the strain energy in the supports.
    pub share: f64,
    /// Share of the forward part in the kinetic energy of the displacements.
    pub forward: f64,
    /// Last change of W by an iteration, or rounding where that is more, over W.
    pub change: f64,
    /// The counts on both sides of it say that it is there, and that no other is.
    pub counted: bool,
}

/// What turns at which speed: with the whirl, or not at all.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Spin {
    /// W = whirl: critical speeds.
    Synchronous,
    /// Natural frequencies at rest.
    Rest,
}

/// The problem with all supports alike.
pub struct SupportMap {
    envelope: Envelope,
    stiffness: Vec<C64>,
    /// `M - i G`, and M.
    inertia: [Vec<C64>; 2],
    /// Every support in x and in y: unknowns and factors.
    ties: Vec<Vec<(usize, C64)>>,
    /// Of every unknown that is a displacement in x: itself and the one in y.
    pairs: Vec<(usize, usize)>,
    /// Forward whirls alone.
    forward: bool,
}

/// An entry of a matrix over the coordinates.
type Triplet = (usize, usize, f64);

/// Relative width of a bracket from which on Rayleigh quotients are tried; that is one place.
const NARROW: f64 = 0.03;
const SAME: f64 = 1e-13;
/// Steps of a quotient, at most, and change that is rounding.
const STEPS: usize = 12;
const EXACT: f64 = 4.0 * f64::EPSILON;
/// Share of the supports in the strain energy at a large stiffness below which a root has a limit.
const BOUNDED: f64 = 0.01;
/// Change of W over it that is converged.
const CONVERGED: f64 = 1e-11;
/// Distance over W^2 at which a root is counted on both sides, at least, and over the rounding of W^2.
const BESIDE: f64 = 1e-8;
const OF_ROUNDING: f64 = 4.0;
/// Most steps by a factor of four in W^2 of the search for roots.
const DECADES: i32 = 40;

impl SupportMap {
    /// Of a machine whose parts but the supports are linear and without states of their own.
    ///
    /// # Errors
    /// Another part, by name.
    pub fn new(system: &System, supports: &[Support], at: &Statics) -> Result<Self, Diagnostic> {
        let (mut k, mut m, mut g): (Vec<Triplet>, Vec<Triplet>, Vec<Triplet>) = Default::default();
        for (index, slot) in system.slots().iter().enumerate().filter(|x| supports.iter().all(|s| s.slot != x.0)) {
            if !slot.is_linear() && is_open(system, slot, at) {
                continue;
            }
            let without = slot.layout.coordinates() == 0;
            if (slot.physics != Physics::Linear || !slot.states.is_empty()) && !without {
                return Err(refused(system, index));
            }
            let mut b = blocks(system, slot, at.speed);
            if let Some(ratio) = slot.ratio {
                b.per_spin(ratio.value(system.params()));
            }
            for (grid, list) in [(&b.stiffness, &mut k), (&b.mass, &mut m), (&b.gyroscopic, &mut g)] {
                for (i, rows) in slot.map.iter().enumerate() {
                    for j in grid.columns(i).filter(|&j| grid[(i, j)] != 0.0) {
                        let across = |x: &&(usize, f64)| is_lateral(system.coordinates()[x.0].dof.kind);
                        for &(gi, a) in rows.iter().filter(across) {
                            list.extend(slot.map[j].iter().filter(across).map(|&(gj, b)| (gi, gj, a * grid[(i, j)] * b)));
                        }
                    }
                }
            }
        }
        let places: Vec<Vec<(usize, f64)>> = supports.iter().flat_map(|s| difference(system, s)).collect();
        let forward = isotropic(system, [&k, &m, &g]);
        let unknowns = unknowns(system, forward);
        let count = unknowns.iter().map(|u| u.0 + 1).max().unwrap_or(0);
        let ties: Vec<Vec<(usize, C64)>> =
            places.iter().map(|row| row.iter().map(|&(i, a)| (unknowns[i].0, unknowns[i].1.scale(a))).collect()).collect();
        let all = [&k, &m, &g].into_iter().flatten().map(|x| (unknowns[x.0].0, unknowns[x.1].0));
        let tied = ties.iter().flat_map(|t| t.iter().flat_map(|a| t.iter().map(|b| (a.0, b.0))));
        let envelope = Envelope::new(count, all.chain(tied));
        let reduced = |list: &[Triplet], factor: C64| {
            let mut out = vec![C64::ZERO; envelope.entries()];
            for &(i, j, x) in list {
                let ((u, a), (v, b)) = (unknowns[i], unknowns[j]);
                // the Hermitian part: half of each triangle
                let z = (a.conj() * b * factor).scale(0.5 * x);
                if u >= v {
                    out[envelope.index(u, v)] += z;
                }
                if v >= u {
                    out[envelope.index(v, u)] += z.conj();
                }
            }
            out
        };
        let (stiffness, mass) = (reduced(&k, C64::ONE), reduced(&m, C64::ONE));
        let gyroscopic = reduced(&g, c(0.0, -1.0));
        let inertia = [mass.iter().zip(&gyroscopic).map(|(m, g)| *m + *g).collect(), mass];
        let leads = |i: &usize| system.coordinates()[*i].dof.kind == DofKind::VectorX && i + 1 < system.n();
        let pairs = (0..system.n()).filter(leads).map(|i| (unknowns[i].0, unknowns[i + 1].0)).collect();
        Ok(SupportMap { envelope, stiffness, inertia, ties, pairs, forward })
    }

    /// Only forward whirls are in it: the machine has no preferred direction.
    pub fn forward_alone(&self) -> bool {
        self.forward
    }

    fn inertia(&self, spin: Spin) -> &[C64] {
        &self.inertia[usize::from(spin == Spin::Rest)]
    }

    /// K with supports of stiffness `k` (N/m).
    fn supported(&self, k: f64) -> Vec<C64> {
        let mut out = self.stiffness.clone();
        for tie in &self.ties {
            for &(u, a) in tie {
                // b b^H over the rows: conj(a_u) a_v, as the stiffness
                tie.iter().filter(|x| x.0 <= u).for_each(|&(v, b)| out[self.envelope.index(u, v)] += (a.conj() * b).scale(k));
            }
        }
        out
    }

    /// The lowest roots with supports of stiffness `k`, at most so many, beyond `skipped` of them.
    pub fn roots(&self, k: f64, spin: Spin, (skipped, count): (usize, usize)) -> Vec<Root> {
        Search { map: self, stiffness: self.supported(k), k, spin, factors: Factors::default(), shifted: Vec::new() }.roots(skipped, count)
    }

    /// A stiffness beside which that of the rotor is nothing: the bending of its supports at the largest entries of K.
    fn large(&self) -> f64 {
        let most = self.stiffness.iter().map(|z| z.abs()).fold(0.0, f64::max);
        let inertia = self.inertia[1].iter().map(|z| z.abs()).fold(0.0, f64::max);
        1e3 * most.max(1e6 * inertia)
    }

    /// On rigid supports: `W^2` of a large stiffness, extrapolated by its derivative.
    pub fn rigid(&self, spin: Spin, count: usize) -> Vec<Root> {
        self.limits(self.large(), spin, count)
    }

    /// The lowest root on rigid supports, and its relative difference from that by ten times the large stiffness; infinite where that has none.
    pub fn first_rigid(&self, spin: Spin) -> Option<(Root, f64)> {
        let at = |k: f64| self.limits(k, spin, 1).into_iter().next();
        let root = at(self.large())?;
        let difference = at(10.0 * self.large()).map_or(f64::INFINITY, |stiffer| (stiffer.speed / root.speed - 1.0).abs());
        Some((root, difference))
    }

    /// Limits of the roots for rigid supports, from those of a large stiffness `k`.
    fn limits(&self, k: f64, spin: Spin, count: usize) -> Vec<Root> {
        let mut out = self.roots(k, spin, (0, count));
        // what the supports alone hold rises without bound
        out.retain(|r| r.share < BOUNDED);
        for r in &mut out {
            // W^2 = W0^2 - c/k, and d(W^2)/d(ln k) is the share of the supports
            r.speed *= (1.0 + r.share).sqrt();
            r.share = 0.0;
        }
        out
    }

    /// Without supports; motions of the rigid machine, at W = 0, are left out, and their number is returned.
    pub fn free(&self, spin: Spin, count: usize) -> (Vec<Root>, usize) {
        let mut search =
            Search { map: self, stiffness: self.supported(0.0), k: 0.0, spin, factors: Factors::default(), shifted: Vec::new() };
        let scale = self.rigid(spin, 1).first().map_or(1.0, |r| r.speed * r.speed);
        let still = search.below(1e-5 * scale);
        (search.roots(still, count), still)
    }
}

struct Search<'a> {
    map: &'a SupportMap,
    stiffness: Vec<C64>,
    k: f64,
    spin: Spin,
    factors: Factors,
    shifted: Vec<C64>,
}

impl Search<'_> {
    fn factor(&mut self, square: f64) -> usize {
        self.shifted.clear();
        let inertia = self.map.inertia(self.spin);
        self.shifted.extend(self.stiffness.iter().zip(inertia).map(|(k, b)| *k - b.scale(square)));
        self.factors.factor(&self.map.envelope, &self.shifted)
    }

    /// Number of roots with W^2 below a value.
    fn below(&mut self, square: f64) -> usize {
        self.factor(square)
    }

    fn roots(&mut self, skipped: usize, count: usize) -> Vec<Root> {
        let (mut low, mut high) = (1e6, 1e6);
        let mut steps = 0;
        let mut at_low = self.below(low);
        while at_low > skipped && steps < DECADES {
            low /= 4.0;
            at_low = self.below(low);
            steps += 1;
        }
        let mut at_high = self.below(high);
        steps = 0;
        while at_high < skipped + count && steps < DECADES {
            high *= 4.0;
            at_high = self.below(high);
            steps += 1;
        }
        let mut out = Vec::new();
        self.within((low, at_low), (high, at_high), (skipped, skipped + count), &mut out);
        out
    }

    /// Roots in a bracket whose numbers, from the lowest of all, lie in a range.
    fn within(&mut self, low: (f64, usize), high: (f64, usize), (from, to): (usize, usize), out: &mut Vec<Root>) {
        if low.1 >= high.1 || low.1 >= to || high.1 <= from {
            return;
        }
        let width = high.0 / low.0 - 1.0;
        if high.1 - low.1 == 1
            && width < NARROW
            && let Some(root) = self.polished(low.0, high.0)
        {
            out.push(root);
            return;
        }
        if width < SAME {
            // several in one place
            let middle = (low.0 * high.0).sqrt();
            for _ in low.1.max(from)..high.1.min(to) {
                out.extend(self.quotient(middle, 2, (0.0, f64::INFINITY)).map(|found| found.0));
            }
            return;
        }
        let middle = if width < 1e-3 { 0.5 * (low.0 + high.0) } else { (low.0 * high.0).sqrt() };
        let middle = (middle, self.below(middle));
        self.within(low, middle, (from, to), out);
        self.within(middle, high, (from, to), out);
    }

    fn polished(&mut self, low: f64, high: f64) -> Option<Root> {
        let (mut root, rounding) = self.quotient((low * high).sqrt(), STEPS, (low, high))?;
        if root.change > CONVERGED.max(rounding) {
            return None;
        }
        root.change = root.change.max(0.5 * rounding);
        let (square, beside) = (root.speed * root.speed, BESIDE.max(OF_ROUNDING * rounding));
        let beside = (self.below(square * (1.0 - beside)), self.below(square * (1.0 + beside)));
        root.counted = beside.0 + 1 == beside.1;
        Some(root)
    }

    /// Inverse iteration with the quotient as shift, and the rounding of that over it; `None` where it leaves the bracket.
    fn quotient(&mut self, start: f64, steps: usize, (low, high): (f64, f64)) -> Option<(Root, f64)> {
        let n = self.map.envelope.n();
        let inertia = self.map.inertia(self.spin).to_vec();
        // no vector of a machine is orthogonal to these
        let mut v: Vec<C64> = (0..n).map(|i| c(1.0 + (i as f64 * 0.754_877_666).fract(), 0.0)).collect();
        let (mut square, mut change, mut rounding) = (start, f64::INFINITY, 0.0);
        for step in 0..steps {
            self.factor(square);
            let mut y = self.map.envelope.times(&inertia, &v);
            self.factors.solve(&self.map.envelope, &mut y);
            let size = y.iter().map(|z| z.abs()).fold(0.0, f64::max);
            if !(size > 0.0 && size.is_finite()) {
                break;
            }
            v = y.iter().map(|z| z.scale(1.0 / size)).collect();
            let (potential, kinetic) = (self.map.envelope.form(&self.stiffness, &v, &v).re, self.map.envelope.form(&inertia, &v, &v).re);
            let next = potential / kinetic;
            // the first vectors need not be those of this root yet
            if step < 2 && !(next > low && next < high) {
                continue;
            }
            if !(next > low && next < high) {
                return None;
            }
            change = (next / square - 1.0).abs();
            square = next;
            // of many elements the terms of the potential are large beside it
            rounding = f64::EPSILON * self.map.envelope.size(&self.stiffness, &v) / potential;
            if change <= EXACT.max(0.25 * rounding) {
                break;
            }
        }
        Some((self.root(square, &v, 0.5 * change), rounding))
    }

    fn root(&self, square: f64, v: &[C64], change: f64) -> Root {
        let all = self.map.envelope.form(&self.stiffness, v, v).re;
        let held = |tie: &Vec<(usize, C64)>| tie.iter().fold(C64::ZERO, |s, &(u, a)| s + a * v[u]).abs().powi(2);
        let share = self.k * self.map.ties.iter().map(held).sum::<f64>() / all;
        let (mut f, mut b) = (0.0, 0.0);
        for &(x, y) in &self.map.pairs {
            // of forward whirls alone y is not an unknown
            let (x, y) = (v[x], if self.map.forward { v[x] * c(0.0, -1.0) } else { v[y] });
            f += (x + y * c(0.0, 1.0)).abs().powi(2);
            b += (x - y * c(0.0, 1.0)).abs().powi(2);
        }
        Root { speed: square.sqrt(), share, forward: if f + b > 0.0 { f / (f + b) } else { 0.0 }, change, counted: false }
    }
}

fn refused(system: &System, slot: usize) -> Diagnostic {
    let slot = &system.slots()[slot];
    Diagnostic::error(
        "support_map.part",
        text!(
            "\"{name}\" is not given by mass, gyroscopic and stiffness matrices, and it is no support that the map replaces",
            name = slot.name
        ),
    )
    .at(slot.span.clone())
    .help(text!("name it in supports if it is one; otherwise campbell and critical_speeds take every part"))
}

/// Displacement of the place of a support against what it stands on, x and y.
fn difference(system: &System, support: &Support) -> Vec<Vec<(usize, f64)>> {
    let slot = &system.slots()[support.slot];
    // the local coordinates of the part are that difference, of either sign
    slot.map.iter().take(2).cloned().collect()
}

/// What moves across the axis has to do with critical speeds.
fn is_lateral(kind: DofKind) -> bool {
    !matches!(kind, DofKind::Axial | DofKind::Twist)
}

/// The unknown and the factor of every coordinate.
fn unknowns(system: &System, forward: bool) -> Vec<(usize, C64)> {
    // no unknown of a coordinate along or about the axis
    const NONE: (usize, C64) = (0, C64::ZERO);
    if !forward {
        let mut next = 0..;
        let one = |kind: DofKind| if is_lateral(kind) { next.next().map_or(NONE, |i| (i, C64::ONE)) } else { NONE };
        return system.coordinates().iter().map(|c| c.dof.kind).map(one).collect();
    }
    let (mut out, mut next) = (Vec::with_capacity(system.n()), 0);
    for coordinate in system.coordinates() {
        if !is_lateral(coordinate.dof.kind) {
            out.push(NONE);
            continue;
        }
        let (first, factor) = match coordinate.dof.kind {
            DofKind::VectorX => (true, C64::ONE),
            DofKind::VectorY => (false, c(0.0, -1.0)),
            DofKind::TiltX => (true, c(0.0, 1.0)),
            _ => (false, C64::ONE),
        };
        next += usize::from(first);
        out.push((next - 1, factor));
    }
    out
}

/// Every coordinate belongs to a pair, and no matrix prefers a direction.
fn isotropic(system: &System, matrices: [&Vec<Triplet>; 3]) -> bool {
    let kinds: Vec<DofKind> = system.coordinates().iter().map(|c| c.dof.kind).filter(|k| is_lateral(*k)).collect();
    let paired = kinds.len().is_multiple_of(2)
        && kinds.chunks(2).all(|p| matches!(p, [DofKind::VectorX, DofKind::VectorY] | [DofKind::TiltX, DofKind::TiltY]));
    if !paired {
        return false;
    }
    // what a matrix makes of a forward whirl is one: for every pair of coordinates the part that would be a backward one
    let (unknowns, mut sums) = (unknowns(system, true), std::collections::BTreeMap::<(usize, usize), [C64; 2]>::new());
    matrices.iter().all(|list| {
        sums.clear();
        for &(i, j, x) in list.iter() {
            let ((u, a), (v, b)) = (unknowns[i], unknowns[j]);
            let entry = sums.entry((u, v)).or_insert([C64::ZERO; 2]);
            // backward whirls have the conjugate factors
            entry[0] += (a * b).scale(x);
            entry[1] += c((a.abs() * b.abs() * x).abs(), 0.0);
        }
        sums.values().all(|[wrong, size]| wrong.abs() <= 1e-12 * size.re)
    })
}
