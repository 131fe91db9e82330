//! Coordinates without inertia: the machine is solved for the highest derivative that each coordinate has.
//!
//! ```text
//! H dh = -r(q, v, a, z; spin, t)                              (Newton; a alone enters r linearly)
//! H h' = -(dr/dt along the motion with h held)                 (rates of v_i and q_i)
//! ```
//!
//! h and H are those of `orders`. Coordinates in h keep their places in y and follow with `y' = h' + g (h - y)`, so that steps, events and outputs see them; nothing reads them
//! there but as the first guess of Newton's method.
//!
//! Symbols: g rate at which the places in y follow, 1/s.
//!
//! Sources: K. E. Brenan, S. L. Campbell, L. R. Petzold, Numerical Solution of Initial-Value Problems in Differential-Algebraic Equations (1996), section 2.4.

use super::direct::{Direct, NOT_FOUND, unheld};
use super::point;
use crate::model::erased::D1;
use crate::model::part::{At, Rows};
use crate::model::system::{Slot, System, Workspace};
use crate::model::tangent::{Tangent, TangentScratch};
use crate::orders::{FirstOrder, Highest, Orders};
use crate::programme::Spin;
use laval_num::dense::{Lu, Mat};
use laval_num::ode::Failure;
use laval_num::refill::refill;

/// Most Newton steps, and the largest last one over the sizes of the unknowns.
const STEPS: usize = 50;
const CONVERGED: f64 = 1e-11;
/// Size of a step over that of the one before it from which on H is computed anew.
const SLOW: f64 = 0.01;
/// Share of the typical size that a small unknown is measured by.
const FLOOR: f64 = 1e-3;

/// Solves for the highest derivatives.
pub(super) struct Massless {
    orders: Orders,
    /// H depends on the speed and its rate alone: rows are linear in h.
    affine: bool,
    /// Rates of internal states depend on velocities of places.
    reads_rates: bool,
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
    /// `None` where every coordinate has inertia. `constant` says that the mass matrix of the machine is; it is tried at `speeds`.
    ///
    /// # Errors
    /// A coordinate that nothing determines.
    pub fn new(system: &System, free: bool, constant: bool, speeds: &[f64], follow: f64) -> Result<Option<Self>, Failure> {
        let n = system.n();
        let Some(orders) = Orders::of(system, free, speeds, follow).map_err(|u| unheld(system, u.0))? else { return Ok(None) };
        // its rows are not linear in what is solved for
        let bends = |slot: &Slot| {
            slot.map.iter().flatten().any(|&(g, _)| match orders.order(g) {
                Highest::Acceleration => slot.uses.acceleration,
                Highest::Rate => slot.uses.velocity,
                Highest::Place => true,
            })
        };
        let size = (0..2 * n).map(|k| system.coordinates()[k % n].dof.typical * if k < n { 1.0 } else { follow }).collect();
        let (mut tangent, mut scratch) = (Tangent::default(), TangentScratch::default());
        let zero = vec![0.0; n.max(system.m())];
        let (q, z) = (&zero[..n], &zero[..system.m()]);
        let still = At { q, v: q, a: q, z, phase: 0.0, speed: speeds.last().copied().unwrap_or(0.0), spin_accel: 0.0, t: 0.0 };
        system.tangent(&still, free, &mut tangent, &mut scratch, |_| true);
        Ok(Some(Massless {
            affine: constant && !free && !system.slots().iter().any(|s| !s.is_linear() && bends(s)),
            reads_rates: system.m() > 0 && orders.reads_rates_of_places(&tangent),
            orders,
            follow,
            y: Vec::new(),
            size,
            tangent,
            scratch,
            h: Mat::default(),
            lu: Lu::default(),
            key: None,
            step: Vec::new(),
            dual: Workspace::default(),
            params: system.params().iter().map(|&x| D1::lift(x)).collect(),
            lifted: Default::default(),
            rows: Default::default(),
        }))
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
            if self.orders.order(i) == Highest::Place {
                self.y[n + i] = 0.0;
            }
        }
        let (mut converged, mut slow, mut last) = (false, false, f64::INFINITY);
        for k in 0..STEPS {
            out.evaluate_at_rest(system, t, spin, &self.y);
            let key = [spin.speed.to_bits(), spin.accel.to_bits()];
            let anew = if self.affine { self.key != Some(key) } else { k == 0 || slow };
            if anew {
                let at = point(system, t, spin, &self.y, &out.accel);
                system.tangent(&at, free, &mut self.tangent, &mut self.scratch, |_| true);
                self.orders.index_matrix(&self.tangent, &mut self.h);
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
                let place = match self.orders.order(i) {
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
            // of an affine machine the first step is the solution, and the second has the rates of internal states
            if largest <= CONVERGED || (self.affine && (k == 1 || system.m() == 0)) {
                converged = true;
                break;
            }
            if !largest.is_finite() {
                break;
            }
            slow = largest > SLOW * last;
            last = largest;
        }
        if !converged || out.accel.iter().any(|a| !a.is_finite()) {
            // a trial step that went too far: it is tried again smaller
            out.accel.fill(f64::NAN);
            return Ok(());
        }
        out.add_rates_of_acceleration();
        self.differentiate(system, free, t, spin, out);
        if self.reads_rates && !self.settle_rates(system, free, t, spin, out) {
            out.accel.fill(f64::NAN);
        }
        Ok(())
    }

    /// Velocities of places and rates of internal states that read them: of passive parts each step leaves the share of the stiffness that relaxes. `false` where they do not settle.
    fn settle_rates(&mut self, system: &System, free: bool, t: f64, spin: Spin, out: &mut Direct) -> bool {
        let n = system.n();
        let places: Vec<usize> = (0..n).filter(|&i| self.orders.order(i) == Highest::Place).collect();
        let accel = out.accel.clone();
        for _ in 0..STEPS {
            let before: Vec<f64> = places.iter().map(|&i| self.y[n + i]).collect();
            out.evaluate_at_rest(system, t, spin, &self.y);
            // velocities of damped nodes are among the unknowns, and their rates stand in their places
            for (i, (to, a)) in out.accel.iter_mut().zip(&accel).enumerate() {
                *to = if self.orders.order(i) == Highest::Acceleration { *a } else { 0.0 };
            }
            out.add_rates_of_acceleration();
            self.differentiate(system, free, t, spin, out);
            let moved = |(&i, b): (&usize, &f64)| (self.y[n + i] - b).abs() <= CONVERGED * (self.y[n + i].abs() + FLOOR * self.size[n + i]);
            if places.iter().zip(&before).all(moved) {
                return true;
            }
        }
        false
    }

    /// The rates of the highest derivatives of coordinates without inertia: accelerations of those with damping, velocities of the others.
    fn differentiate(&mut self, system: &System, free: bool, t: f64, spin: Spin, out: &mut Direct) {
        let (n, m) = (system.n(), system.m());
        let accel = if free { out.accel[n] } else { spin.accel };
        let along = |x: &[f64], rate: &dyn Fn(usize) -> f64, to: &mut Vec<D1>| {
            to.clear();
            to.extend(x.iter().enumerate().map(|(i, &x)| seeded(x, rate(i))));
        };
        let (y, highest) = (&self.y, self.orders.highest());
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
            match self.orders.order(i) {
                Highest::Acceleration => {}
                Highest::Rate => out.accel[i] = self.step[i],
                Highest::Place => self.y[n + i] = self.step[i],
            }
        }
    }

    /// Rates of the coordinates and their velocities in y.
    pub fn rates(&self, y: &[f64], accel: &[f64], dy: &mut [f64]) {
        let n = self.orders.highest().len();
        for i in 0..n {
            let behind = |k: usize| self.follow * (self.y[k] - y[k]);
            let (of_place, of_rate) = match self.orders.order(i) {
                Highest::Acceleration => (0.0, accel[i]),
                Highest::Rate => (0.0, accel[i] + behind(n + i)),
                Highest::Place => (behind(i), behind(n + i)),
            };
            (dy[i], dy[n + i]) = (self.y[n + i] + of_place, of_rate);
        }
    }

    /// Writes what follows into a state.
    pub fn settle(&self, y: &mut [f64]) {
        let n = self.orders.highest().len();
        y[..2 * n].copy_from_slice(&self.y[..2 * n]);
    }

    /// The Jacobian of the rates at the point last evaluated, but for second derivatives of the residual in the rows that nothing reads; rows of an account stay
    /// zero.
    ///
    /// # Errors
    /// A coordinate that nothing determines here.
    pub fn jacobian(&mut self, system: &System, free: bool, at: &At<f64>, jac: &mut Mat) -> Result<(), Failure> {
        let n = system.n();
        system.tangent(at, free, &mut self.tangent, &mut self.scratch, |_| true);
        self.key = None;
        self.orders.index_matrix(&self.tangent, &mut self.h);
        self.lu.factor(&self.h).map_err(|s| unheld(system, s.column))?;
        let Some(FirstOrder { highest, rates }) = self.orders.first_order(&self.tangent, &self.lu) else { return Err(NOT_FOUND.into()) };
        let core = rates.rows();
        for i in 0..core {
            for j in 0..core {
                jac[(i, j)] = rates[(i, j)];
            }
        }
        // h' by the rates of the states that h is a function of
        for i in (0..n).filter(|&i| self.orders.order(i) != Highest::Acceleration) {
            let g = self.follow;
            let follows: Vec<f64> =
                (0..core).map(|j| (0..core).filter(|&c| highest[(i, c)] != 0.0).map(|c| highest[(i, c)] * jac[(c, j)]).sum()).collect();
            let place = self.orders.order(i) == Highest::Place;
            for (j, rate) in follows.into_iter().enumerate() {
                let own = g * highest[(i, j)];
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
