//! Stability of a periodic motion: Floquet exponents of the first-order form, internal states included.
//!
//! A small disturbance obeys `y' = A(t) y`. After the part of the period that the symmetry repeats, it is turned back; the eigenvalues mu of that map
//! give the exponents `ln(mu) / T`. Three ways, each exact in its case, none sorts anything:
//!
//! - circular motion of an isotropic machine: eigenvalues of a constant matrix in the rotating frame; of a machine of many states the roots up to a frequency, counted where they
//!   grow (see `crate::harmonic::stability::counted`);
//! - motion so small that A hardly varies: eigenvalues of its mean, when the second-order bound of the rest is below the tolerance;
//! - a machine of many states: as the next two, of its linear parts reduced to the ports of the nonlinear ones (see [`crate::reduction`]);
//! - otherwise: the map itself by a method of order 8, in blocks that do not couple: as a product of equal steps in lanes where the tangents are smooth along the motion
//!   (see `crate::harmonic::stability::product`), else by adaptive integration (see `crate::harmonic::stability::monodromy`).
//!
//! Theory: `docs/theory/harmonic-balance.md#stability`.

use crate::characteristic::is_polynomial;
use crate::harmonic::balance::first_order::{MOST_STATES, first_order};
use crate::harmonic::balance::nonlinear::Sampled;
use crate::harmonic::balance::problem::Balance;
use crate::harmonic::stability::product::Products;
use laval_model::text;
use laval_model::text::{Arg, Argument};
use laval_num::order::SortByNumber;
use serde::{Deserialize, Serialize};

use crate::large::is_large;
use crate::model::part::{At, DofKind};
use crate::model::station::Row;
use crate::model::system::{Slot, System};
use crate::model::tangent::{SparseTangent, Tangent, TangentScratch};
use crate::orders::Orders;
use crate::reduction::{Reduction, projected};
use crate::symmetry::Symmetry;
use laval_num::complex::{C64, c};
use laval_num::dense::{Lu, Mat};
use laval_num::eig::Spectrum;
use laval_num::ode::Dop853;
use std::f64::consts::TAU;

/// How exponents were found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Method {
    /// Constant coefficients in the rotating frame.
    Rotating,
    /// Mean coefficients; the rest is bounded.
    Mean,
    /// Map over the period (or the part a symmetry repeats).
    Map,
    /// Zeros of Hill's determinant ([`crate::harmonic::stability::determinant`]): all that grow, of the others those found.
    Determinant,
}

/// Exponents of one motion.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Exponents {
    /// All exponents `growth + i frequency`, 1/s; frequencies are determined up to the base frequency (or its multiple that a symmetry gives).
    pub values: Vec<C64>,
    /// Estimated error of a growth rate, 1/s.
    pub error: f64,
    /// How.
    pub method: Method,
    /// Time after which the map was taken and turned back, s; 0 where coefficients were constant.
    pub span: f64,
}

impl Exponents {
    /// The largest growth rate, 1/s.
    pub fn growth(&self) -> f64 {
        self.values.iter().fold(f64::NEG_INFINITY, |m, z| if z.re > m || z.re.is_nan() { z.re } else { m })
    }
    /// No growth beyond the error.
    pub fn stable(&self) -> bool {
        self.growth() <= self.error
    }
    /// Exponents in descending order of growth.
    pub fn descending(&self) -> Vec<C64> {
        let mut values = self.values.clone();
        values.sort_by_number_down(|a| a.re);
        values
    }
    /// Number that grow beyond the error; NaN counts.
    pub fn unstable(&self) -> usize {
        self.values.iter().filter(|z| !(z.re <= self.error)).count()
    }
}

/// Why a machine's motions cannot be assessed here.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Unassessed {
    /// A part without a time-domain form, by name, and why it has none.
    NoTimeForm(String, #[serde(deserialize_with = "laval_num::text::one")] laval_num::text::Text),
    /// More states than a map can carry.
    TooManyStates(usize),
    /// A coordinate has no mass.
    Massless,
    /// The force of a part, by name, jumps along the motion.
    Jumps(String),
    /// The integration or an eigenvalue computation failed.
    Failed(String),
}

impl Argument for Unassessed {
    fn argument(&self) -> Arg {
        let said = match self {
            Unassessed::NoTimeForm(part, why) => text!("\"{part}\" has no time-domain form: {why}", part, why = text::term(why)),
            Unassessed::TooManyStates(n) => text!("the machine has {n} first-order states, more than the map of a period can carry", n),
            Unassessed::Jumps(part) => {
                text!("the force of \"{part}\" jumps when it touches, and what such a jump does to a disturbance is not computed", part)
            }
            Unassessed::Massless => text!("a coordinate has no mass"),
            Unassessed::Failed(why) => return why.argument(),
        };
        said.argument()
    }
}
impl std::fmt::Display for Unassessed {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.argument().fmt(f)
    }
}

/// Growth rates are wanted to this part of the largest exponent.
const TOLERANCE: f64 = 1e-9;

/// `A[row, col] += factor * tangent[derivative][j, k]`: how tangents of nonlinear coordinates enter the scaled A.
#[derive(Clone, Copy)]
pub(super) struct Entry {
    pub(super) row: usize,
    pub(super) col: usize,
    pub(super) derivative: usize,
    pub(super) j: usize,
    pub(super) k: usize,
    pub(super) factor: f64,
}

/// States that do not couple with others: their constant matrix and entries, in their own numbering.
pub(super) struct Block {
    pub(super) states: Vec<usize>,
    pub(super) constant: Vec<f64>,
    pub(super) entries: Vec<Entry>,
}

/// Assesses motions of one machine; keeps its scratch.
pub struct Stability {
    pub(super) n: usize,
    pub(super) m: usize,
    pub(super) pairs: Vec<bool>,
    pub(super) constant_mass: bool,
    /// Of a machine with coordinates without inertia.
    pub(super) orders: Option<Orders>,
    speed: f64,
    pub(super) constant: Mat,
    input: Mat,
    pub(super) entries: Vec<Entry>,
    pub(super) tangent: Tangent,
    pub(super) scratch: TangentScratch,
    pub(super) sampled: Sampled,
    pub(super) scale: Vec<f64>,
    spectrum: Spectrum,
    pub(super) dop: Dop853,
    pub(super) products: Products,
    /// Steps of maps have lengths of their own, however smooth the law.
    pub(super) adaptive: bool,
    /// Steps of maps over the period that are left: a law with kinks may require more than anybody waits for.
    pub(super) steps_left: u64,
    /// Tolerance of the integration of maps.
    pub(super) tolerance: f64,
    /// Number of states, where it is more than a map can carry: circular motions are assessed as they are, others of the machine reduced to the ports of its
    /// nonlinear parts.
    many: Option<usize>,
    /// With the speed it was made for, rad/s.
    reduction: Option<(Reduction, f64)>,
    /// Combinations of the nonlinear coordinates over those assessed.
    rows: Vec<Row>,
    sparse: SparseTangent,
    /// Frequency up to which exponents are counted, where they are, rad/s.
    pub(super) frequency: Option<f64>,
}

/// Frequency up to which a reduced machine is compared, over the speed; difference of its receptance that is enough; ratio of the speeds that reductions are made for.
const OF_SPEED: f64 = 5.0;
const REDUCED: f64 = 1e-4;
const FASTER: f64 = 1.5;

/// Speed of a machine that gives none, rad/s.
const TYPICAL_SPEED: f64 = 100.0;

/// Steps of integration spent on the maps of one response, at most.
const MOST_STEPS: u64 = 200_000;

impl Stability {
    /// For one machine, or why not.
    pub fn new(system: &System) -> Result<Stability, Unassessed> {
        use crate::model::part::{Physics, TimeForm};
        for slot in system.slots() {
            if let Physics::Frequency(TimeForm::None(why)) = slot.physics {
                return Err(Unassessed::NoTimeForm(slot.name.clone(), why));
            }
        }
        let (n, m) = (system.n(), system.m());
        let states = 2 * n + m;
        let many = (states > MOST_STATES).then_some(states);
        if many.is_some() && !is_polynomial(system) {
            return Err(Unassessed::TooManyStates(states));
        }
        let speed = system.machine.speed.unwrap_or(TYPICAL_SPEED);
        // a large machine is assessed by determinants, or reduced to one with inertia
        let orders = if many.is_some() {
            None
        } else {
            Orders::of(system, false, &[speed, 0.0, 2.0 * speed], speed.abs()).map_err(|_| Unassessed::Massless)?
        };
        let leads = |kinds: Vec<DofKind>| kinds.into_iter().map(DofKind::leads_pair).collect::<Vec<bool>>();
        let q = leads(system.coordinates().iter().map(|c| c.dof.kind).collect());
        let z = leads(system.states().iter().map(|s| s.dof.kind).collect());
        let mut pairs = [&q[..], &q[..], &z[..]].concat();
        if let Some(orders) = &orders {
            let kept = orders.states(m);
            // a pair of which one half is no state cannot be turned
            let broken = |&&i: &&usize| pairs[i] && !kept.contains(&(i + 1)) || i > 0 && pairs[i - 1] && !kept.contains(&(i - 1));
            if kept.iter().any(|i| broken(&i)) {
                return Err(Unassessed::Massless);
            }
            pairs = kept.iter().map(|&i| pairs[i]).collect();
        }
        Ok(Stability {
            n,
            m,
            pairs,
            constant_mass: orders.is_none()
                && system.slots().iter().filter(|s| !s.is_linear()).all(|s| !s.uses.acceleration && s.states.is_empty()),
            orders,
            speed: f64::NAN,
            constant: Mat::default(),
            input: Mat::default(),
            entries: Vec::new(),
            tangent: Tangent::default(),
            scratch: TangentScratch::default(),
            sampled: Sampled::default(),
            scale: Vec::new(),
            spectrum: Spectrum::default(),
            dop: Dop853::new(),
            products: Products::default(),
            adaptive: false,
            steps_left: MOST_STEPS,
            tolerance: crate::harmonic::stability::monodromy::TOLERANCE,
            many,
            reduction: None,
            rows: Vec::new(),
            sparse: SparseTangent::default(),
            frequency: None,
        })
    }

    /// Forgets the motions assessed before, so that what follows does not depend on them.
    pub(in crate::harmonic) fn begin(&mut self) {
        (self.speed, self.steps_left) = (f64::NAN, MOST_STEPS / 4);
        self.scale.clear();
        self.products.begin();
    }

    /// Integrates maps over the period to another tolerance.
    pub fn with_tolerance(self, tolerance: f64) -> Self {
        Stability { tolerance, ..self }
    }

    /// Integrates maps over the period by steps of adapted length alone: a second method for laws that are smooth along a motion.
    pub fn adaptively(self) -> Self {
        Stability { adaptive: true, ..self }
    }

    /// Exponents by the map over the period, however small the motion. The balance must have been sampled there last, and not be circular.
    pub fn mapped(&mut self, balance: &mut Balance, x: &[f64], speed: f64) -> Result<Exponents, Unassessed> {
        let (places, jumps) = balance.switches(x, speed, (0.0, TAU / balance.terms.symmetry.order().max(1) as f64));
        self.reduce(balance, speed)?;
        match jumps {
            Some(part) => Err(Unassessed::Jumps(part)),
            None if !self.constant_mass => self.general(balance, x, speed),
            None => {
                self.set_speed(balance, speed)?;
                self.map(balance, x, speed, !places.is_empty())
            }
        }
    }

    /// Exponents of the motion `x` of a balance at a speed. The balance must have been sampled there last ([`Balance::sample`]).
    pub fn exponents(&mut self, balance: &mut Balance, x: &[f64], speed: f64) -> Result<Exponents, Unassessed> {
        let (places, jumps) = balance.switches(x, speed, (0.0, TAU / balance.terms.symmetry.order().max(1) as f64));
        if let Some(part) = jumps {
            return Err(Unassessed::Jumps(part));
        }
        if let Some(states) = self.many {
            let circular = balance.terms.symmetry == Symmetry::Circular;
            if !self.constant_mass {
                return Err(Unassessed::TooManyStates(states));
            }
            if circular && is_large(balance.system) {
                return self.counted(balance, x, speed);
            }
            if !circular {
                self.reduce(balance, speed)?;
            }
        }
        if !self.constant_mass {
            return self.general(balance, x, speed);
        }
        self.set_speed(balance, speed)?;
        let terms = &balance.terms;
        let mu = terms.coordinates;
        let sampled = &balance.sampled;
        let mean = means(balance);
        if terms.symmetry == Symmetry::Circular {
            let mut a = self.constant.clone();
            self.add_tangent([&mean[0], &mean[1]], 0, &mut a);
            let turn = balance.pace(speed).frequency * terms.divisor as f64;
            for (i, _) in self.pairs.iter().enumerate().filter(|(_, p)| **p) {
                a[(i, i + 1)] += turn;
                a[(i + 1, i)] -= turn;
            }
            let values = self.eigenvalues(&a)?;
            return Ok(Exponents { values, error: rounding(&a), method: Method::Rotating, span: 0.0 });
        }
        let mut a = self.constant.clone();
        self.add_tangent([&mean[0], &mean[1]], 0, &mut a);
        let mut variation = 0.0f64;
        let mut delta = Mat::<f64>::zeros(a.rows(), a.rows());
        for j in 0..terms.samples {
            delta.reset(a.rows(), a.rows());
            for e in &self.entries {
                let change = sampled.tangent(e.derivative)[(j * mu + e.j, e.k)] - mean[e.derivative][(e.j, e.k)];
                delta[(e.row, e.col)] += e.factor * change;
            }
            let worst = (0..delta.rows()).map(|i| delta.row(i).iter().map(|x| x.abs()).sum::<f64>()).fold(0.0, f64::max);
            variation = variation.max(worst);
        }
        let base = balance.pace(speed).frequency.abs() * if terms.symmetry == Symmetry::None { 1.0 } else { 2.0 };
        let bound = |detuning: f64| variation * variation / detuning.max(variation);
        let largest = (0..a.rows()).map(|i| a.row(i).iter().map(|x| x.abs()).sum::<f64>()).fold(0.0, f64::max);
        // no exponent exceeds that norm, and none is farther than the base frequency from being in tune with itself; a law that switches may do so between the samples
        if places.is_empty() && (bound(base) < 0.1 * TOLERANCE * largest || variation == 0.0) {
            let values = self.eigenvalues(&a)?;
            let size = values.iter().map(|z| z.abs()).fold(0.0, f64::max);
            let bound = bound(detuning(&values, base));
            if bound < 0.1 * TOLERANCE * size || variation == 0.0 {
                return Ok(Exponents { values, error: bound + rounding(&a), method: Method::Mean, span: 0.0 });
            }
        }
        self.map(balance, x, speed, !places.is_empty())
    }

    /// Of a machine of many states: what it is reduced to at a speed.
    fn reduce(&mut self, balance: &Balance, speed: f64) -> Result<(), Unassessed> {
        let Some(states) = self.many else { return Ok(()) };
        if !self.constant_mass {
            return Err(Unassessed::TooManyStates(states));
        }
        // one of a series of speeds, whichever motion comes first
        let typical = if speed == 0.0 { 0.0 } else { FASTER.powf((speed.abs().ln() / FASTER.ln()).round()) };
        if self.reduction.as_ref().is_some_and(|r| r.1 == typical) {
            return Ok(());
        }
        let system = balance.system;
        let frequency = OF_SPEED * typical * FASTER.sqrt();
        let ports = &balance.nonlinear.basis.rows;
        let most = MOST_STATES.saturating_sub(self.m) / 2;
        let found = Reduction::new(system, &Slot::is_linear, ports, frequency, &[0.0, speed.signum() * typical], REDUCED, most)
            .ok_or(Unassessed::TooManyStates(states))?;
        self.n = found.basis.cols();
        self.pairs = vec![false; 2 * self.n + self.m];
        self.rows = ports.iter().map(|r| found.row(r)).collect();
        self.reduction = Some((found, typical));
        (self.speed, self.scale) = (f64::NAN, Vec::new());
        Ok(())
    }

    /// The reduction of the machine whose motions were assessed last, where it was reduced.
    pub fn reduction(&self) -> Option<&Reduction> {
        self.reduction.as_ref().map(|r| &r.0)
    }

    /// Frequencies of the machine linearised about the mean of the motion last sampled, rad/s.
    pub(in crate::harmonic) fn mean_frequencies(&mut self, balance: &mut Balance, speed: f64) -> Option<Vec<f64>> {
        if !self.constant_mass || self.many.is_some() {
            return None;
        }
        self.set_speed(balance, speed).ok()?;
        let mean = means(balance);
        let mut a = self.constant.clone();
        self.add_tangent([&mean[0], &mean[1]], 0, &mut a);
        Some(self.eigenvalues(&a).ok()?.iter().map(|z| z.im).collect())
    }

    pub(super) fn eigenvalues(&mut self, a: &Mat) -> Result<Vec<C64>, Unassessed> {
        self.spectrum.of(a).map(<[C64]>::to_vec).map_err(|e| Unassessed::Failed(format!("eigenvalues: {e}")))
    }

    /// Constant part of A and the input of nonlinear forces, scaled.
    pub(super) fn set_speed(&mut self, balance: &Balance, speed: f64) -> Result<(), Unassessed> {
        if self.speed == speed {
            return Ok(());
        }
        let system = balance.system;
        let (n, m) = (self.n, self.m);
        let (q, z) = (vec![0.0; system.n()], vec![0.0; m]);
        let at = At { q: &q, v: &q, a: &q, z: &z, phase: 0.0, speed, spin_accel: 0.0, t: 0.0 };
        if let Some((reduction, _)) = &self.reduction {
            system.tangent(&at, false, &mut self.sparse, &mut self.scratch, Slot::is_linear);
            projected(&reduction.basis, &self.sparse, &mut self.tangent);
        } else {
            system.tangent(&at, false, &mut self.tangent, &mut self.scratch, Slot::is_linear);
            self.rows.clone_from(&balance.nonlinear.basis.rows);
        }
        self.constant = first_order(&self.tangent).ok_or(Unassessed::Massless)?;
        let rows = &self.rows;
        let mut g = Mat::zeros(n, rows.len());
        for (j, row) in rows.iter().enumerate() {
            for &(i, x) in row {
                g[(i, j)] -= x;
            }
        }
        Lu::new(&self.tangent.a).map_err(|_| Unassessed::Massless)?.solve_mat(&mut g);
        let memory = self.tangent.rate_a.matmul(&g);
        self.input = Mat::from_fn(2 * n + m, rows.len(), |i, j| match i {
            i if i < n => 0.0,
            i if i < 2 * n => g[(i - n, j)],
            i => memory[(i - 2 * n, j)],
        });
        if self.scale.is_empty() {
            // balanced with the nonlinear parts as at the first sample, so that rates and displacements are of one size
            let mut a = self.constant.clone();
            self.scale = vec![1.0; a.rows()];
            self.list_entries(balance);
            self.add_tangent([balance.sampled.tangent(0), balance.sampled.tangent(1)], 0, &mut a);
            self.scale = balance_scale(&a, &self.pairs);
        }
        for i in 0..self.constant.rows() {
            let si = self.scale[i];
            for (a, sj) in self.constant.row_mut(i).iter_mut().zip(&self.scale) {
                *a *= sj / si;
            }
            self.input.row_mut(i).iter_mut().for_each(|x| *x /= si);
        }
        self.list_entries(balance);
        self.speed = speed;
        Ok(())
    }

    /// Lists how tangents of the nonlinear coordinates enter A.
    fn list_entries(&mut self, balance: &Balance) {
        let (n, rows) = (self.n, &self.rows);
        let derivatives = if balance.nonlinear.members.iter().any(|m| m.uses.velocity) { 2 } else { 1 };
        self.entries.clear();
        for row in n..self.input.rows() {
            for j in 0..rows.len() {
                let g = self.input[(row, j)];
                if g == 0.0 {
                    continue;
                }
                for (k, combination) in rows.iter().enumerate() {
                    for derivative in 0..derivatives {
                        for &(c, x) in combination {
                            let col = derivative * n + c;
                            self.entries.push(Entry { row, col, derivative, j, k, factor: g * x * self.scale[col] });
                        }
                    }
                }
            }
        }
    }

    /// Adds the nonlinear parts' tangents to a scaled A.
    fn add_tangent(&self, tangents: [&Mat; 2], from: usize, a: &mut Mat) {
        for e in &self.entries {
            a[(e.row, e.col)] += e.factor * tangents[e.derivative][(from + e.j, e.k)];
        }
    }

    /// States in blocks that neither the constant part nor a tangent seen at a sample (with `all`: any tangent) couples.
    pub(super) fn blocks(&self, balance: &Balance, all: bool) -> Vec<Block> {
        let mut pattern = Mat::from_fn(self.constant.rows(), self.constant.rows(), |i, j| self.constant[(i, j)].abs());
        let mu = balance.terms.coordinates;
        for e in &self.entries {
            let tangent = balance.sampled.tangent(e.derivative);
            let most = (0..balance.terms.samples).map(|s| tangent[(s * mu + e.j, e.k)].abs()).fold(0.0, f64::max);
            pattern[(e.row, e.col)] += if all { 1.0 } else { most };
        }
        let blocks = components(&pattern);
        let place = |states: &[usize], i: usize| states.iter().position(|&s| s == i);
        blocks
            .into_iter()
            .map(|states| {
                let constant = states.iter().flat_map(|&i| states.iter().map(move |&j| (i, j))).map(|ij| self.constant[ij]).collect();
                let entries = self.entries.iter().filter(|e| pattern[(e.row, e.col)] != 0.0);
                let entries =
                    entries.filter_map(|e| Some(Entry { row: place(&states, e.row)?, col: place(&states, e.col)?, ..*e })).collect();
                Block { constant, entries, states }
            })
            .collect()
    }
}

/// Tangents of the nonlinear coordinates by displacements and by rates: means over the period of the motion last sampled.
fn means(balance: &Balance) -> [Mat; 2] {
    let terms = &balance.terms;
    let mu = terms.coordinates;
    let mut mean = [Mat::zeros(mu, mu), Mat::zeros(mu, mu)];
    for (d, mean) in mean.iter_mut().enumerate() {
        let tangent = balance.sampled.tangent(d);
        for j in 0..terms.samples {
            for i in 0..mu {
                for k in 0..mu {
                    mean[(i, k)] += tangent[(j * mu + i, k)] / terms.samples as f64;
                }
            }
        }
        // the rest of the period has these tangents turned
        if terms.symmetry == Symmetry::Quarter {
            average_quarter(&balance.nonlinear.kinds, mean);
        }
    }
    mean
}

/// Rounding of growth rates that come from eigenvalues of `a`.
pub(super) fn rounding(a: &Mat) -> f64 {
    1e-14 * a.max_size() * a.rows() as f64
}

/// Powers of two that bring rows and columns to one size; the same for both halves of a pair.
pub(super) fn balance_scale(a: &Mat, pairs: &[bool]) -> Vec<f64> {
    let n = a.rows();
    let mut scale = vec![1.0; n];
    for _ in 0..20 {
        for i in 0..n {
            let (mut row, mut col) = (0.0, 0.0);
            for j in (0..n).filter(|&j| j != i) {
                row += (a[(i, j)] * scale[j] / scale[i]).abs();
                col += (a[(j, i)] * scale[i] / scale[j]).abs();
            }
            if row > 0.0 && col > 0.0 {
                scale[i] *= (0.5 * (row / col).log2()).round().exp2();
            }
        }
    }
    for i in (0..n).filter(|&i| pairs[i]) {
        scale[i + 1] = scale[i];
    }
    scale
}

/// Distance of `lambda_i - lambda_j` from the nearest non-zero multiple of `i base`, least over all i, j.
fn detuning(values: &[C64], base: f64) -> f64 {
    let mut least = f64::INFINITY;
    for a in values {
        for b in values {
            let d = *a - *b;
            let k = (d.im / base).round();
            for k in [k - 1.0, k, k + 1.0] {
                if k != 0.0 {
                    least = least.min((d - c(0.0, k * base)).abs());
                }
            }
        }
    }
    least
}

/// Mean of a matrix over the four quarter turns of its pairs.
fn average_quarter(kinds: &[DofKind], a: &mut Mat) {
    let n = kinds.len();
    let mut turn = Mat::<f64>::identity(n);
    for i in (0..n).filter(|&i| kinds[i].leads_pair()) {
        turn[(i, i)] = 0.0;
        turn[(i + 1, i + 1)] = 0.0;
        turn[(i, i + 1)] = -1.0;
        turn[(i + 1, i)] = 1.0;
    }
    let back = turn.transpose();
    let mut sum = Mat::zeros(n, n);
    let mut turned = a.clone();
    for _ in 0..4 {
        for (s, t) in sum.data_mut().iter_mut().zip(turned.data()) {
            *s += 0.25 * t;
        }
        turned = turn.matmul(&turned).matmul(&back);
    }
    a.copy_from(&sum);
}

/// Sets of states that the matrix does not couple.
fn components(pattern: &Mat) -> Vec<Vec<usize>> {
    let n = pattern.rows();
    let mut mark = vec![usize::MAX; n];
    let mut blocks: Vec<Vec<usize>> = Vec::new();
    for start in 0..n {
        if mark[start] != usize::MAX {
            continue;
        }
        let id = blocks.len();
        let (mut stack, mut block) = (vec![start], Vec::new());
        mark[start] = id;
        while let Some(i) = stack.pop() {
            block.push(i);
            for j in 0..n {
                if mark[j] == usize::MAX && (pattern[(i, j)] != 0.0 || pattern[(j, i)] != 0.0) {
                    mark[j] = id;
                    stack.push(j);
                }
            }
        }
        block.sort_unstable();
        blocks.push(block);
    }
    blocks
}
