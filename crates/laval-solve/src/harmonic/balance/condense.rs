//! The linear parts of a machine condensed exactly onto the nonlinear coordinates, at one order of the base frequency.
//!
//! With Z(s) the dynamic stiffness, `u = B x` the nonlinear coordinates, f(u) their forces and F the external ones:
//!
//! ```text
//! Z x = F - B^T f   =>   K u + f = p,   K = (B Z^-1 B^T)^-1,   p = K B Z^-1 F
//! ```
//!
//! A reference stiffness S (diagonal, in the unit of each coordinate) is added to Z on the nonlinear coordinates and taken off again (`f - S u`), so that Z need not be regular without the
//! nonlinear parts (a rotor held only by its bearing). States of linear parts stay in Z: a resonance inside a part is not a pole.

use crate::characteristic::is_polynomial;
use crate::harmonic::balance::orders_in_lanes::{OrdersInLanes, Shared};
use crate::harmonic::balance::pace::Pace;
use crate::model::blocks::Axes;
use crate::model::erased::D1;
use crate::model::linear::{Form, LinearModel, LinearScratch, Loads};
use crate::model::system::System;
use laval_num::complex::{C64, c};
use laval_num::dense::{Lu, Mat, Singular};
use laval_num::factor::{Columns, Factors, Terms};
use laval_num::lanes::LANES;
use laval_num::refill::refill;
use laval_num::scalar::Scalar;

/// Rows of independent nonlinear coordinates over global ones, and every nonlinear part's local coordinates in terms of them.
#[derive(Clone, Debug, Default)]
pub struct Basis {
    /// B, row by row.
    pub rows: Vec<Vec<(usize, f64)>>,
}

impl Basis {
    /// Expresses a row in the basis, adding it when it is independent.
    pub fn express(&mut self, row: &[(usize, f64)], n: usize) -> Vec<(usize, f64)> {
        let dense = |r: &[(usize, f64)]| {
            let mut d = vec![0.0; n];
            for &(g, c) in r {
                d[g] += c;
            }
            d
        };
        let target = dense(row);
        if target.iter().all(|&x| x == 0.0) {
            return Vec::new();
        }
        // the same row again is the common case
        if let Some(k) = self.rows.iter().position(|r| dense(r) == target) {
            return vec![(k, 1.0)];
        }
        if let Some(combination) = combine(&self.rows.iter().map(|r| dense(r)).collect::<Vec<_>>(), &target) {
            return combination;
        }
        self.rows.push(row.to_vec());
        vec![(self.rows.len() - 1, 1.0)]
    }
}

/// Coefficients of `target` over `rows` by least squares, when it lies in their span.
fn combine(rows: &[Vec<f64>], target: &[f64]) -> Option<Vec<(usize, f64)>> {
    let k = rows.len();
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let gram = Mat::from_fn(k, k, |i, j| dot(&rows[i], &rows[j]));
    let mut coefficients: Vec<f64> = rows.iter().map(|r| dot(r, target)).collect();
    Lu::new(&gram).ok()?.solve(&mut coefficients);
    let mut rest = target.to_vec();
    for (row, &c) in rows.iter().zip(&coefficients) {
        for (r, x) in rest.iter_mut().zip(row) {
            *r -= c * x;
        }
    }
    let size = dot(target, target).sqrt();
    (dot(&rest, &rest).sqrt() < 1e-12 * size).then(|| coefficients.into_iter().enumerate().filter(|(_, c)| c.abs() > 1e-14).collect())
}

/// The reference at order `k`: with as much loss as stiffness, so that it brings no resonance of its own.
pub fn lossy(k: usize, reference: f64) -> C64 {
    c(reference, if k == 0 { 0.0 } else { reference })
}

/// F and its derivative at order `k` and unknown `i`, coordinates first; the unbalance acts at the order `turning`.
fn external(loads: &Loads<D1>, coordinates: usize, turning: Option<usize>, k: usize, i: usize) -> (C64, C64) {
    if turning == Some(k) && i < coordinates {
        let (x, y) = (loads.force_cos[i], loads.force_sin[i]);
        return (c(x.re, -y.re), c(x.eps[0], -y.eps[0]));
    }
    if k > 0 {
        return (C64::zero(), C64::zero());
    }
    let x = if i < coordinates { loads.force[i] } else { loads.rate.get(i - coordinates).copied().unwrap_or(D1::zero()) };
    (c(x.re, 0.0), c(x.eps[0], 0.0))
}

/// One order condensed at one pace, where requested with derivatives in the parameter that the pace depends on (the speed, under unbalance).
#[derive(Clone, Debug, Default)]
pub struct Order {
    /// K over the nonlinear coordinates.
    pub stiffness: Mat<C64>,
    /// dK/dparameter.
    pub stiffness_speed: Mat<C64>,
    /// p.
    pub load: Vec<C64>,
    /// dp/dparameter.
    pub load_speed: Vec<C64>,
    /// Z^-1 B^T (with the reference stiffness), for the motion of all coordinates.
    pub spread: Mat<C64>,
    /// Z^-1 F.
    pub free: Vec<C64>,
    /// d spread/dparameter.
    pub spread_speed: Mat<C64>,
    /// d free/dparameter.
    pub free_speed: Vec<C64>,
}

/// Condenses orders of one machine; keeps its scratch.
pub struct Condenser {
    basis: Vec<Vec<(usize, f64)>>,
    /// S: reference stiffness on each nonlinear coordinate, N/m or N m/rad.
    pub reference: Vec<f64>,
    divisor: usize,
    /// The rotating load acts; a free motion leaves it out.
    pub driven: bool,
    frequency: D1,
    drive: D1,
    params: Vec<D1>,
    model: LinearModel<D1>,
    scratch: LinearScratch<D1>,
    dual: Vec<laval_num::complex::Complex<D1>>,
    /// `A0, A1, A2` of Z, of a machine whose Z is a polynomial.
    quadratic: Option<[Vec<D1>; 3]>,
    /// The same as numbers, and the mass alone, of a machine whose matrices are not small.
    polynomial: Option<[Vec<f64>; 4]>,
    /// Entries of the reference stiffness.
    references: Vec<(usize, f64)>,
    /// Places of the entries in a full matrix, of those of the reference stiffness among them, and what a drive adds.
    places: Vec<usize>,
    reference_places: Vec<(usize, f64)>,
    drives: Vec<D1>,
    lanes: OrdersInLanes,
    /// The same by all entries.
    held: Vec<f64>,
    z: Vec<C64>,
    dz: Vec<C64>,
    factors: Factors<C64>,
    columns: Columns,
    rhs: Mat<C64>,
    work: Mat<C64>,
    projected: [Mat<C64>; 2],
    square: Mat<C64>,
    moved: Vec<C64>,
    small: Lu<C64>,
}

impl Condenser {
    /// For a machine whose base frequency is speed / divisor.
    pub fn new(system: &System, basis: &Basis, reference: Vec<f64>, divisor: usize) -> Self {
        Condenser {
            basis: basis.rows.clone(),
            reference,
            divisor,
            driven: true,
            frequency: D1::zero(),
            drive: D1::zero(),
            params: system.params().iter().map(|&x| D1::lift(x)).collect(),
            model: LinearModel::default(),
            scratch: LinearScratch::default(),
            dual: Vec::new(),
            quadratic: None,
            polynomial: None,
            references: Vec::new(),
            places: Vec::new(),
            reference_places: Vec::new(),
            drives: Vec::new(),
            lanes: OrdersInLanes::default(),
            held: Vec::new(),
            z: Vec::new(),
            dz: Vec::new(),
            factors: Factors::default(),
            columns: Columns::default(),
            rhs: Mat::default(),
            work: Mat::default(),
            projected: Default::default(),
            square: Mat::default(),
            moved: Vec::new(),
            small: Lu::default(),
        }
    }

    /// Evaluates the linear parts at a pace; call before [`Condenser::order`].
    pub fn set_pace(&mut self, system: &System, pace: &Pace) {
        let [by_speed, by_frequency, by_drive] = pace.rate.map(|rate| [rate]);
        self.frequency = D1 { re: pace.frequency, eps: by_frequency };
        self.drive = D1 { re: pace.drive, eps: by_drive };
        let speed = D1 { re: pace.speed, eps: by_speed };
        for (i, p) in self.params.iter_mut().enumerate() {
            p.eps = [pace.parameter.map_or(0.0, |q| q.rate(i))];
        }
        system.linear(&self.params, speed, Form::Frequency, &mut self.model, &mut self.scratch);
        self.quadratic = is_polynomial(system).then(|| self.model.polynomial());
        self.polynomial = self.quadratic.as_ref().filter(|_| !self.model.plan().is_dense()).map(|[a0, a1, a2]| {
            let real = |all: &[D1]| all.iter().map(|x| x.re).collect::<Vec<f64>>();
            [real(a0), real(a1), real(a2), real(self.model.mass_values())]
        });
        self.set_references();
    }

    /// Places of the reference stiffness in the pattern, which stays that of the first pace.
    fn set_references(&mut self) {
        let pattern = self.model.pattern();
        if self.held.len() == pattern.entries() {
            return;
        }
        self.references.clear();
        for (row, &reference) in self.basis.iter().zip(&self.reference) {
            for &(gi, ci) in row {
                // coordinates of one part are coupled
                let places = row.iter().filter_map(|&(gj, cj)| Some((pattern.index(gi, gj)?, reference * (ci * cj))));
                self.references.extend(places);
            }
        }
        refill(&mut self.held, pattern.entries(), 0.0);
        for &(e, x) in &self.references {
            self.held[e] += x;
        }
    }

    /// Global indices of the linear states that follow the coordinates in [`Order::spread`] and [`Order::free`].
    pub fn linear_states(&self) -> &[usize] {
        self.model.states()
    }

    /// Fills the memory states that belong to coordinates moving as `amplitude exp(s t)`.
    pub fn memory_states(&self, system: &System, s: C64, coordinates: &[C64], states: &mut [C64]) {
        for mem in &self.model.memory {
            let speed = mem.speed.re;
            let map = &system.slots()[mem.slot].map;
            let input = |i: usize| map[i].iter().fold(C64::zero(), |sum, &(g, x)| sum + coordinates[g].scale(x));
            for (k, z) in mem.list.iter().enumerate() {
                let r = s + c(z.rate.re, 0.0);
                let u = input(z.input);
                states[mem.first + k] = match z.axes {
                    Axes::Fixed => u * r.recip(),
                    Axes::RotorX => (r * u - input(mem.list[k + 1].input).scale(speed)) * (r * r + c(speed * speed, 0.0)).recip(),
                    Axes::RotorY => (r * u + input(mem.list[k - 1].input).scale(speed)) * (r * r + c(speed * speed, 0.0)).recip(),
                };
            }
        }
    }

    /// Condenses orders of the base frequency, side by side where the machine has few coordinates; with derivatives where `slopes` is set.
    pub fn orders(&mut self, system: &System, orders: &[usize], slopes: bool, out: &mut [Order]) -> Result<(), Singular> {
        let (Some(quadratic), true) = (&self.quadratic, self.model.plan().is_dense()) else {
            for (&k, out) in orders.iter().zip(out) {
                self.order(system, k, slopes, out)?;
            }
            return Ok(());
        };
        let (pattern, coordinates) = (self.model.pattern(), system.n());
        let size = pattern.n();
        if self.places.is_empty() {
            for i in 0..size {
                self.places.extend(pattern.row(i).map(|(_, j)| i * size + j));
            }
            self.reference_places.extend(self.references.iter().map(|&(e, x)| (self.places[e], x)));
        }
        self.drives.clear();
        if self.drive.re != 0.0 || self.drive.eps[0] != 0.0 {
            // - xi s M, of coordinates alone
            let inertial = |at: &usize| at / size < coordinates && at % size < coordinates;
            let of = |(at, &mass): (&usize, &D1)| if inertial(at) { -(self.drive * mass) } else { D1::zero() };
            self.drives.extend(self.places.iter().zip(self.model.mass_values()).map(of));
        }
        let shared = Shared {
            size,
            places: &self.places,
            quadratic,
            drive: &self.drives,
            others: self.model.held()..size,
            references: &self.reference_places,
            reference: &self.reference,
            basis: &self.basis,
            frequency: self.frequency,
            slopes,
        };
        let (loads, turning) = (&self.model.loads, self.driven.then_some(self.divisor));
        let load = |k: usize, i: usize| external(loads, coordinates, turning, k, i);
        for (orders, out) in orders.chunks(LANES).zip(out.chunks_mut(LANES)) {
            if !self.lanes.condense(&shared, orders, load, out) {
                return Err(Singular { column: 0 });
            }
        }
        Ok(())
    }

    /// Condenses order `k >= 0` of the base frequency; with derivatives where `slopes` is set.
    pub fn order(&mut self, system: &System, k: usize, slopes: bool, out: &mut Order) -> Result<(), Singular> {
        let (m, size) = (self.basis.len(), self.model.pattern().n());
        self.evaluate(system, k);
        self.factors.factor(self.model.plan(), &self.z)?;
        // columns: B^T, then the load and its derivative
        self.load(system, k, slopes);
        self.solve(k, false);
        if slopes {
            // Z' times those solutions, solved again: derivatives of Z^-1 B^T and of Z^-1 F
            self.work.reset(size, m + 2);
            for i in 0..size {
                let sums = self.work.row_mut(i);
                for (e, j) in self.model.pattern().row(i) {
                    let a = self.dz[e];
                    if a != C64::zero() {
                        sums.iter_mut().zip(self.rhs.row(j)).for_each(|(s, &x)| *s += a * x);
                    }
                }
            }
            self.solve(k, true);
        }
        self.spread(slopes, out);
        self.project(k, slopes, out)
    }

    /// Z, its derivative, and the entries of the reference stiffness.
    fn evaluate(&mut self, system: &System, k: usize) {
        let n = system.n();
        let frequency = self.frequency.scale(k as f64);
        self.z.clear();
        self.dz.clear();
        if let Some([a0, a1, a2]) = &self.quadratic {
            // s = i w: A0 - w^2 A2 + i w A1
            let (w, dw) = (frequency.re, frequency.eps[0]);
            let (square, slope) = (-w * w, -2.0 * w * dw);
            for ((a0, a1), a2) in a0.iter().zip(a1).zip(a2) {
                self.z.push(c(a0.re + square * a2.re, w * a1.re));
                self.dz.push(c(a0.eps[0] + square * a2.eps[0] + slope * a2.re, w * a1.eps[0] + dw * a1.re));
            }
        } else {
            let s = c(D1::zero(), frequency);
            system.dynamic_stiffness_entries(&self.params, &self.model, Form::Frequency, s, &mut self.dual, &mut self.scratch);
            self.z.extend(self.dual.iter().map(|e| c(e.re.re, e.im.re)));
            self.dz.extend(self.dual.iter().map(|e| c(e.re.eps[0], e.im.eps[0])));
        }
        let pattern = self.model.pattern();
        // states of nonlinear parts are not of the linear model
        for i in self.model.held()..pattern.n() {
            pattern.row(i).filter(|x| x.1 == i).for_each(|(e, _)| {
                self.z[e] = C64::one();
                self.polynomial.iter_mut().for_each(|terms| terms[0][e] = 1.0);
            });
        }
        if self.drive.re != 0.0 || self.drive.eps[0] != 0.0 {
            // - xi s M
            let push = -(self.drive * frequency);
            for i in 0..n {
                for (e, _) in pattern.row(i).take_while(|x| x.1 < n) {
                    let x = push * self.model.mass_values()[e];
                    self.z[e] += c(0.0, x.re);
                    self.dz[e] += c(0.0, x.eps[0]);
                }
            }
        }
        let loss = lossy(k, 1.0);
        for &(e, x) in &self.references {
            self.z[e] += loss.scale(x);
        }
    }

    /// Right-hand sides: B^T, F, and its derivative.
    fn load(&mut self, system: &System, k: usize, slopes: bool) {
        let (n, m, size) = (system.n(), self.basis.len(), self.model.pattern().n());
        self.rhs.reset(size, m + 1 + usize::from(slopes));
        for (j, row) in self.basis.iter().enumerate() {
            for &(g, x) in row {
                self.rhs[(g, j)] += c(x, 0.0);
            }
        }
        for i in 0..size {
            let (f, df) = external(&self.model.loads, n, self.driven.then_some(self.divisor), k, i);
            self.rhs[(i, m)] = f;
            if slopes {
                self.rhs[(i, m + 1)] = df;
            }
        }
    }

    /// Solves for the right-hand sides, or for what their derivatives come from. Soft supports of a stiff chain: what rounding makes of the entries of Z
    /// changes from speed to speed, where Z is not known as a sum.
    fn solve(&mut self, k: usize, again: bool) {
        let b = if again { &mut self.work } else { &mut self.rhs };
        let Some([a0, a1, a2, mass]) = &self.polynomial else { return self.factors.solve_mat(b) };
        let frequency = k as f64 * self.frequency.re;
        let (s, push) = (c(0.0, frequency), c(0.0, -(self.drive.re * frequency)));
        let all: [(C64, &[f64]); 5] = [(C64::one(), a0), (s, a1), (s * s, a2), (push, mass), (lossy(k, 1.0), &self.held)];
        // without a drive its term is nothing
        let used: Vec<(C64, &[f64])> = all.into_iter().filter(|t| t.0 != C64::zero()).collect();
        let terms = Terms { pattern: self.model.pattern(), terms: &used };
        self.columns.solve(&terms, &self.factors, b);
    }

    /// What the motion of all coordinates follows from.
    fn spread(&self, slopes: bool, out: &mut Order) {
        let (m, size) = (self.basis.len(), self.rhs.rows());
        out.spread.reset(size, m);
        out.free.clear();
        for i in 0..size {
            out.spread.row_mut(i).copy_from_slice(&self.rhs.row(i)[..m]);
            out.free.push(self.rhs[(i, m)]);
        }
        out.spread_speed.reset(if slopes { size } else { 0 }, m);
        out.free_speed.clear();
        if slopes {
            // d(Z^-1) = -Z^-1 dZ Z^-1
            for i in 0..size {
                for (d, w) in out.spread_speed.row_mut(i).iter_mut().zip(self.work.row(i)) {
                    *d = -*w;
                }
                out.free_speed.push(self.rhs[(i, m + 1)] - self.work[(i, m)]);
            }
        }
    }

    /// Rows of B applied to the solutions: the flexibility and the free motion, and with them K, p and their derivatives.
    fn project(&mut self, k: usize, slopes: bool, out: &mut Order) -> Result<(), Singular> {
        let m = self.basis.len();
        for (w, projected) in [&self.rhs, &self.work].into_iter().zip(&mut self.projected).take(1 + usize::from(slopes)) {
            projected.reset(m, w.cols());
            for (i, row) in self.basis.iter().enumerate() {
                for &(g, x) in row {
                    for (p, w) in projected.row_mut(i).iter_mut().zip(w.row(g)) {
                        *p += w.scale(x);
                    }
                }
            }
        }
        let [flexibility, change] = &self.projected;
        let square = |a: &Mat<C64>, out: &mut Mat<C64>| {
            out.reset(m, m);
            (0..m).for_each(|i| out.row_mut(i).copy_from_slice(&a.row(i)[..m]));
        };
        square(flexibility, &mut self.square);
        self.small.factor(&self.square)?;
        let k_ref = &mut out.stiffness;
        k_ref.reset(m, m);
        (0..m).for_each(|i| k_ref[(i, i)] = C64::one());
        self.small.solve_mat(k_ref);
        let moved = &mut self.moved;
        moved.clear();
        moved.extend((0..m).map(|i| flexibility[(i, m)]));
        refill(&mut out.load, m, C64::zero());
        k_ref.mul_vec_add(moved, &mut out.load);
        if slopes {
            // dK = -K dG K with dG = -B Z^-1 Z' Z^-1 B^T
            square(change, &mut self.square);
            k_ref.matmul_into(&self.square, &mut self.work);
            self.work.matmul_into(k_ref, &mut out.stiffness_speed);
            refill(&mut out.load_speed, m, C64::zero());
            out.stiffness_speed.mul_vec_add(moved, &mut out.load_speed);
            moved.clear();
            moved.extend((0..m).map(|i| flexibility[(i, m + 1)] - change[(i, m)]));
            k_ref.mul_vec_add(moved, &mut out.load_speed);
        }
        for i in 0..m {
            out.stiffness[(i, i)] -= lossy(k, self.reference[i]);
        }
        Ok(())
    }
}
