//! Coordinates without inertia: the machine is solved for the highest derivative that each coordinate has.
//!
//! ```text
//! r(q, v, a, z; spin, t) = 0,    h_i = a_i  with inertia,  v_i  without it and with damping,  q_i  with neither
//! H = dr/dh = [M | C | K]  column by column,    H dh = -r     (Newton; a alone enters r linearly)
//! H h' = -(dr/dt along the motion with h held)                 (rates of v_i and q_i)
//! ```
//!
//! H regular is the condition of index 1: the equations are then those of a first-order system in the states that are left. A machine in which it is singular
//! is refused. Coordinates in h keep their places in y and follow with `y' = h' + g (h - y)`, so that steps, events and outputs see them; nothing reads them
//! there but as the first guess of Newton's method.
//!
//! Symbols: h highest derivatives; H index matrix; g rate at which the places in y follow, 1/s.
//!
//! Sources: K. E. Brenan, S. L. Campbell, L. R. Petzold, Numerical Solution of Initial-Value Problems in Differential-Algebraic Equations (1996), section 2.4.

use super::direct::{Direct, unheld};
use super::point;
use crate::model::erased::D1;
use crate::model::part::{At, Rows};
use crate::model::system::{System, Workspace};
use crate::model::tangent::{Tangent, TangentScratch};
use crate::programme::Spin;
use laval_num::dense::{Lu, Mat};
use laval_num::ode::Failure;
use laval_num::refill::refill;

/// The highest derivative that a coordinate has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Highest {
    Acceleration,
    /// Without inertia, with damping: its place is a state.
    Rate,
    /// Without inertia and damping: its place follows from the other states.
    Place,
}

/// Most Newton steps, the largest last one over the sizes of the unknowns, and the pivot over the largest, both scaled, below which H is singular.
const STEPS: usize = 50;
const CONVERGED: f64 = 1e-11;
const REGULAR: f64 = 1e-13;
/// Share of the typical size that a small unknown is measured by.
const FLOOR: f64 = 1e-3;

/// Solves for the highest derivatives.
pub(super) struct Massless {
    highest: Vec<Highest>,
    /// H depends on the speed and its rate alone.
    affine: bool,
    /// The rate g.
    follow: f64,
    /// The state with the places and velocities that follow.
    y: Vec<f64>,
    /// Sizes of the unknowns that are no accelerations.
    size: Vec<f64>,
    tangent: Tangent,
    scratch: TangentScratch,
    h: Mat,
    lu: Lu,
    /// Speed and its rate that H was factored at.
    key: Option<[u64; 2]>,
    step: Vec<f64>,
    dual: Workspace<D1>,
    params: Vec<D1>,
    lifted: [Vec<D1>; 4],
    rows: [Vec<D1>; 2],
}

impl Massless {
    /// `None` where every coordinate has inertia. `direct` has the mass matrix; the machine is tried at `speeds`.
    ///
    /// # Errors
    /// A coordinate that nothing determines.
    pub fn new(system: &System, free: bool, direct: &Direct, speeds: &[f64], follow: f64) -> Result<Option<Self>, Failure> {
        let n = system.n();
        let none: Vec<bool> = (0..n).map(|i| direct.without_inertia(i)).collect();
        if !none.contains(&true) {
            return Ok(None);
        }
        let touches = |slot: &crate::model::system::Slot| slot.map.iter().flatten().any(|&(g, _)| none[g]);
        let size = (0..2 * n).map(|k| system.coordinates()[k % n].dof.typical * if k < n { 1.0 } else { follow }).collect();
        let mut it = Massless {
            highest: none.iter().map(|&none| if none { Highest::Place } else { Highest::Acceleration }).collect(),
            affine: direct.constant_mass() && !free && !system.slots().iter().any(|s| !s.is_linear() && touches(s)),
            follow,
            y: Vec::new(),
            size,
            tangent: Tangent::default(),
            scratch: TangentScratch::default(),
            h: Mat::default(),
            lu: Lu::default(),
            key: None,
            step: Vec::new(),
            dual: Workspace::default(),
            params: system.params().iter().map(|&x| D1::lift(x)).collect(),
            lifted: Default::default(),
            rows: Default::default(),
        };
        it.find_orders(system, free, speeds)?;
        Ok(Some(it))
    }

    /// Which coordinates have damping, by the tangents at rest and at some states away from it; one of them must determine every coordinate.
    fn find_orders(&mut self, system: &System, free: bool, speeds: &[f64]) -> Result<(), Failure> {
        let (n, m) = (system.n(), system.m());
        let rows = n + usize::from(free);
        let mut tangents = Vec::new();
        for &speed in speeds {
            for share in [0.0, 0.7, -1.0] {
                // different in every coordinate
                let at = |i: usize, typical: f64| share * typical * (1.0 + 0.3 * (i as f64).sin());
                let q: Vec<f64> = system.coordinates().iter().enumerate().map(|(i, c)| at(i, c.dof.typical)).collect();
                let v: Vec<f64> = system.coordinates().iter().enumerate().map(|(i, c)| at(i + 1, self.follow * c.dof.typical)).collect();
                let (a, z) = (vec![0.0; n], vec![0.0; m]);
                let here = At { q: &q, v: &v, a: &a, z: &z, phase: 0.3, speed, spin_accel: 0.0, t: 0.0 };
                system.tangent(&here, free, &mut self.tangent, &mut self.scratch, |_| true);
                tangents.push(self.tangent.clone());
            }
        }
        for j in 0..n {
            let damped = tangents.iter().any(|t| (0..rows).any(|i| t.v[(i, j)] != 0.0));
            if self.highest[j] == Highest::Place && damped {
                self.highest[j] = Highest::Rate;
            }
        }
        let mut why = None;
        for t in tangents {
            self.tangent = t;
            match self.regular(system, rows) {
                Ok(()) => return Ok(()),
                Err(what) => why = why.or(Some(what)),
            }
        }
        why.map_or(Ok(()), Err)
    }

    /// H of the tangents, scaled, is regular to rounding.
    fn regular(&mut self, system: &System, rows: usize) -> Result<(), Failure> {
        self.fill(rows);
        let largest = |i: &dyn Fn(usize) -> f64| (0..rows).fold(0.0f64, |m, j| m.max(i(j).abs()));
        let by_column: Vec<f64> = (0..rows).map(|j| largest(&|i| self.h[(i, j)])).collect();
        // a column of nothing, by name
        if let Some(j) = by_column.iter().position(|x| !(*x > 0.0)) {
            return Err(unheld(system, j));
        }
        let by_row: Vec<f64> = (0..rows).map(|i| largest(&|j| self.h[(i, j)] / by_column[j])).collect();
        let scaled = Mat::from_fn(rows, rows, |i, j| self.h[(i, j)] / (by_column[j] * by_row[i]));
        let last = (0..rows).rev().find(|&i| self.order(i) != Highest::Acceleration).unwrap_or(0);
        let lu =
            Lu::new(&scaled).map_err(|s| unheld(system, if self.order(s.column) == Highest::Acceleration { last } else { s.column }))?;
        // NaN fails
        if lu.pivot_ratio() > REGULAR { Ok(()) } else { Err(unheld(system, last)) }
    }

    fn order(&self, i: usize) -> Highest {
        self.highest.get(i).copied().unwrap_or(Highest::Acceleration)
    }

    /// H from the tangents.
    fn fill(&mut self, rows: usize) {
        self.h.reset(rows, rows);
        for i in 0..rows {
            for j in 0..rows {
                self.h[(i, j)] = match self.order(j) {
                    Highest::Acceleration => self.tangent.a[(i, j)],
                    Highest::Rate => self.tangent.v[(i, j)],
                    Highest::Place => self.tangent.q[(i, j)],
                };
            }
        }
    }

    /// The state with what follows from it, after [`evaluate`](Self::evaluate).
    pub fn completed(&self) -> &[f64] {
        &self.y
    }

    /// Fills `accel` and `rate` of `out`, and completes the state.
    ///
    /// # Errors
    /// A coordinate that nothing determines here.
    pub fn evaluate(&mut self, system: &System, free: bool, t: f64, spin: Spin, y: &[f64], out: &mut Direct) -> Result<(), Failure> {
        let n = system.n();
        self.y.clear();
        self.y.extend_from_slice(y);
        out.accel.fill(0.0);
        for i in 0..n {
            if self.highest[i] == Highest::Place {
                self.y[n + i] = 0.0;
            }
        }
        let mut converged = false;
        for k in 0..STEPS {
            out.evaluate_at_rest(system, t, spin, &self.y);
            let key = [spin.speed.to_bits(), spin.accel.to_bits()];
            if !(self.affine && self.key == Some(key)) {
                let at = point(system, t, spin, &self.y, &out.accel);
                system.tangent(&at, free, &mut self.tangent, &mut self.scratch, |_| true);
                self.fill(out.accel.len());
                self.key = None;
                if let Err(s) = self.lu.factor(&self.h) {
                    if self.h.data().iter().all(|x| x.is_finite()) {
                        return Err(unheld(system, s.column));
                    }
                    break;
                }
                self.key = Some(key);
            }
            self.step.clear();
            self.step.extend(out.force.iter().map(|f| -f));
            self.lu.solve(&mut self.step);
            let mut largest = 0.0f64;
            for (i, &x) in self.step.iter().enumerate() {
                let place = match self.order(i) {
                    Highest::Acceleration => {
                        out.accel[i] = x;
                        continue;
                    }
                    Highest::Rate => n + i,
                    Highest::Place => i,
                };
                self.y[place] += x;
                let share = x.abs() / (self.y[place].abs() + FLOOR * self.size[place]);
                largest = if share <= largest { largest } else { share };
            }
            // of an affine machine the first step is the solution, and the second has its rates
            if largest <= CONVERGED || (self.affine && k == 1) {
                converged = true;
                break;
            }
            if !largest.is_finite() {
                break;
            }
        }
        if !converged || out.accel.iter().any(|a| !a.is_finite()) {
            // a trial step that went too far: it is tried again smaller
            out.accel.fill(f64::NAN);
            return Ok(());
        }
        out.add_rates_of_acceleration();
        self.differentiate(system, free, t, spin, out);
        Ok(())
    }

    /// The rates of the highest derivatives of coordinates without inertia: accelerations of those with damping, velocities of the others.
    fn differentiate(&mut self, system: &System, free: bool, t: f64, spin: Spin, out: &mut Direct) {
        let (n, m) = (system.n(), system.m());
        let accel = if free { out.accel[n] } else { spin.accel };
        let along = |x: &[f64], rate: &dyn Fn(usize) -> f64, to: &mut Vec<D1>| {
            to.clear();
            to.extend(x.iter().enumerate().map(|(i, &x)| seeded(x, rate(i))));
        };
        let (y, highest) = (&self.y, &self.highest);
        let [q, v, a, z] = &mut self.lifted;
        along(&y[..n], &|i| if highest[i] == Highest::Place { 0.0 } else { y[n + i] }, q);
        along(&y[n..2 * n], &|i| if highest[i] == Highest::Acceleration { out.accel[i] } else { 0.0 }, v);
        along(&out.accel[..n], &|_| 0.0, a);
        along(&y[2 * n..2 * n + m], &|i| out.rate[i], z);
        let at = At {
            q,
            v,
            a,
            z,
            phase: seeded(spin.phase, spin.speed),
            speed: seeded(spin.speed, accel),
            spin_accel: seeded(accel, 0.0),
            t: seeded(t, 1.0),
        };
        let [force, rate] = &mut self.rows;
        refill(force, n, D1::lift(0.0));
        refill(rate, m, D1::lift(0.0));
        let mut torque = D1::lift(0.0);
        system.residual(&self.params, &at, &mut Rows { force, rate, spin: &mut torque }, &mut self.dual, |_| true);
        self.step.clear();
        self.step.extend(force.iter().map(|f| -f.eps[0]));
        if free {
            self.step.push(-torque.eps[0]);
        }
        self.lu.solve(&mut self.step);
        for i in 0..n {
            match self.highest[i] {
                Highest::Acceleration => {}
                Highest::Rate => out.accel[i] = self.step[i],
                Highest::Place => self.y[n + i] = self.step[i],
            }
        }
    }

    /// Rates of the coordinates and their velocities in y.
    pub fn rates(&self, y: &[f64], accel: &[f64], dy: &mut [f64]) {
        let n = self.highest.len();
        for i in 0..n {
            let behind = |k: usize| self.follow * (self.y[k] - y[k]);
            let (of_place, of_rate) = match self.highest[i] {
                Highest::Acceleration => (0.0, accel[i]),
                Highest::Rate => (0.0, accel[i] + behind(n + i)),
                Highest::Place => (behind(i), behind(n + i)),
            };
            (dy[i], dy[n + i]) = (self.y[n + i] + of_place, of_rate);
        }
    }

    /// Writes what follows into a state.
    pub fn settle(&self, y: &mut [f64]) {
        let n = self.highest.len();
        y[..2 * n].copy_from_slice(&self.y[..2 * n]);
    }

    /// The Jacobian of the rates at the point last evaluated, but for second derivatives of the residual in the rows that nothing reads; rows of an account stay
    /// zero.
    ///
    /// # Errors
    /// A coordinate that nothing determines here.
    pub fn jacobian(&mut self, system: &System, free: bool, at: &At<f64>, jac: &mut Mat) -> Result<(), Failure> {
        let (n, m) = (system.n(), system.m());
        let rows = n + usize::from(free);
        system.tangent(at, free, &mut self.tangent, &mut self.scratch, |_| true);
        self.fill(rows);
        self.key = None;
        self.lu.factor(&self.h).map_err(|s| unheld(system, s.column))?;
        let core = 2 * n + m + 2 * usize::from(free);
        let (t, spin) = (&self.tangent, 2 * n + m);
        // column of the tangents that a state is; places and velocities that follow are read by nothing
        let mut by_state = Mat::from_fn(rows, core, |i, j| match j {
            j if j < n => {
                if self.highest[j] == Highest::Place {
                    0.0
                } else {
                    -t.q[(i, j)]
                }
            }
            j if j < 2 * n => {
                if self.highest[j - n] == Highest::Acceleration {
                    -t.v[(i, j - n)]
                } else {
                    0.0
                }
            }
            j if j < spin => -t.z[(i, j - 2 * n)],
            j if j == spin => -t.q[(i, n)],
            _ => -t.v[(i, n)],
        });
        self.lu.solve_mat(&mut by_state);
        for j in 0..core {
            for i in 0..n {
                match self.highest[i] {
                    Highest::Acceleration => {
                        jac[(i, j)] = f64::from(u8::from(j == n + i));
                        jac[(n + i, j)] = by_state[(i, j)];
                    }
                    Highest::Rate => jac[(i, j)] = by_state[(i, j)],
                    Highest::Place => {}
                }
            }
            for k in 0..m {
                let direct = match j {
                    j if j < n => {
                        if self.highest[j] == Highest::Place {
                            0.0
                        } else {
                            t.rate_q[(k, j)]
                        }
                    }
                    j if j < 2 * n => {
                        if self.highest[j - n] == Highest::Acceleration {
                            t.rate_v[(k, j - n)]
                        } else {
                            0.0
                        }
                    }
                    j if j < spin => t.rate_z[(k, j - 2 * n)],
                    j if j == spin => t.rate_q[(k, n)],
                    _ => t.rate_v[(k, n)],
                };
                let through = |i: usize| match self.order(i) {
                    Highest::Acceleration => t.rate_a[(k, i)],
                    Highest::Rate => t.rate_v[(k, i)],
                    Highest::Place => t.rate_q[(k, i)],
                };
                jac[(2 * n + k, j)] = direct + (0..rows).map(|i| through(i) * by_state[(i, j)]).sum::<f64>();
            }
            if free {
                jac[(spin, j)] = f64::from(u8::from(j == spin + 1));
                jac[(spin + 1, j)] = by_state[(n, j)];
            }
        }
        // h' by the rates of the states that h is a function of
        for i in (0..n).filter(|&i| self.highest[i] != Highest::Acceleration) {
            let g = self.follow;
            let follows: Vec<f64> =
                (0..core).map(|j| (0..core).filter(|&c| by_state[(i, c)] != 0.0).map(|c| by_state[(i, c)] * jac[(c, j)]).sum()).collect();
            let place = self.highest[i] == Highest::Place;
            for (j, rate) in follows.into_iter().enumerate() {
                let own = g * by_state[(i, j)];
                if place {
                    jac[(i, j)] = rate + own - if j == i { g } else { 0.0 };
                }
                jac[(n + i, j)] = if place { g * rate } else { rate + own } - if j == n + i { g } else { 0.0 };
            }
        }
        Ok(())
    }
}

/// A number with its rate.
fn seeded(x: f64, rate: f64) -> D1 {
    D1 { re: x, eps: [rate] }
}
