//! The highest derivative that each coordinate has, and the machine as a system of first order in the states that are left.
//!
//! ```text
//! r(q, v, a, z; spin, t) = 0,    h_i = a_i  with inertia,  v_i  without it and with damping,  q_i  with neither
//! H = dr/dh = [M | C | K]  column by column,    dh/dy = -H^-1 dr/dy,    y = states: places but those in h, velocities with inertia, z
//! ```
//!
//! H regular is the condition of index 1. A machine in which it is singular is refused.
//!
//! Symbols: h highest derivatives; H index matrix.
//!
//! Sources: K. E. Brenan, S. L. Campbell, L. R. Petzold, Numerical Solution of Initial-Value Problems in Differential-Algebraic Equations (1996), section 2.4.

use crate::large::is_large;
use crate::model::part::At;
use crate::model::system::System;
use crate::model::tangent::{SparseTangent, Tangent, TangentScratch};
use laval_num::dense::{Lu, Mat};

/// The highest derivative that a coordinate has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Highest {
    /// It has inertia.
    Acceleration,
    /// Without inertia, with damping: its place is a state.
    Rate,
    /// Without inertia and damping: its place follows from the other states.
    Place,
}

/// Pivot over the largest, both scaled, below which H is singular.
const REGULAR: f64 = 1e-13;

/// The highest derivatives of the coordinates of a machine, of which some have no inertia.
#[derive(Clone, Debug)]
pub(crate) struct Orders {
    highest: Vec<Highest>,
    /// The spin angle is a coordinate.
    free: bool,
}

/// The coordinate that nothing determines.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Undetermined(pub usize);

/// Rates of the states and highest derivatives, over the states.
pub(crate) struct FirstOrder {
    /// dh/dy; columns of what is no state are zero.
    pub highest: Mat,
    /// dy'/dy; rows and columns of what is no state are zero.
    pub rates: Mat,
}

/// Every coordinate has an entry in the mass matrix, which for this is not written as a full one.
fn all_have_inertia(system: &System, speed: f64, scratch: &mut TangentScratch) -> bool {
    let (zero, z) = (vec![0.0; system.n()], vec![0.0; system.m()]);
    let here = At { q: &zero, v: &zero, a: &zero, z: &z, phase: 0.3, speed, spin_accel: 0.0, t: 0.0 };
    let mut tangent = SparseTangent::default();
    system.tangent(&here, false, &mut tangent, scratch, |_| true);
    let mut inertia = vec![false; system.n()];
    for &(i, j, _) in tangent.a.0.iter().filter(|e| e.2 != 0.0) {
        (inertia[i], inertia[j]) = (true, true);
    }
    inertia.into_iter().all(|has| has)
}

impl Orders {
    /// By the tangents at `speeds`, at rest and at some states away from it, with velocities of the typical size times `rate` (1/s). `None` where all coordinates have inertia.
    ///
    /// # Errors
    /// A coordinate that nothing determines at any of these states.
    pub fn of(system: &System, free: bool, speeds: &[f64], rate: f64) -> Result<Option<Self>, Undetermined> {
        let (n, m) = (system.n(), system.m());
        let rows = n + usize::from(free);
        let mut scratch = TangentScratch::default();
        if is_large(system) && all_have_inertia(system, speeds.first().copied().unwrap_or(0.0), &mut scratch) {
            return Ok(None);
        }
        let mut tangents: Vec<Tangent> = Vec::new();
        let mut highest = vec![Highest::Acceleration; n];
        for &speed in speeds {
            for share in [0.0, 0.7, -1.0] {
                // different in every coordinate
                let at = |i: usize, typical: f64| share * typical * (1.0 + 0.3 * (i as f64).sin());
                let q: Vec<f64> = system.coordinates().iter().enumerate().map(|(i, c)| at(i, c.dof.typical)).collect();
                let v: Vec<f64> = system.coordinates().iter().enumerate().map(|(i, c)| at(i + 1, rate * c.dof.typical)).collect();
                let (a, z) = (vec![0.0; n], vec![0.0; m]);
                let here = At { q: &q, v: &v, a: &a, z: &z, phase: 0.3, speed, spin_accel: 0.0, t: 0.0 };
                let mut tangent = Tangent::default();
                system.tangent(&here, free, &mut tangent, &mut scratch, |_| true);
                if tangents.is_empty() {
                    let none = |i: usize| (0..rows).all(|j| tangent.a[(i, j)] == 0.0 && tangent.a[(j, i)] == 0.0);
                    highest = (0..n).map(|i| if none(i) { Highest::Place } else { Highest::Acceleration }).collect();
                    if !highest.contains(&Highest::Place) {
                        return Ok(None);
                    }
                }
                tangents.push(tangent);
            }
        }
        for (j, highest) in highest.iter_mut().enumerate() {
            let damped = tangents.iter().any(|t| (0..rows).any(|i| t.v[(i, j)] != 0.0));
            if *highest == Highest::Place && damped {
                *highest = Highest::Rate;
            }
        }
        let orders = Orders { highest, free };
        let mut why = None;
        for t in &tangents {
            match orders.regular(t) {
                Ok(()) => return Ok(Some(orders)),
                Err(what) => why = why.or(Some(what)),
            }
        }
        why.map_or(Ok(None), Err)
    }

    /// H, scaled, is regular to rounding.
    fn regular(&self, t: &Tangent) -> Result<(), Undetermined> {
        let (mut h, rows) = (Mat::default(), self.rows());
        self.index_matrix(t, &mut h);
        let largest = |i: &dyn Fn(usize) -> f64| (0..rows).fold(0.0f64, |m, j| m.max(i(j).abs()));
        let by_column: Vec<f64> = (0..rows).map(|j| largest(&|i| h[(i, j)])).collect();
        // a column of nothing, by name
        if let Some(j) = by_column.iter().position(|x| !(*x > 0.0)) {
            return Err(Undetermined(j));
        }
        let by_row: Vec<f64> = (0..rows).map(|i| largest(&|j| h[(i, j)] / by_column[j])).collect();
        let scaled = Mat::from_fn(rows, rows, |i, j| h[(i, j)] / (by_column[j] * by_row[i]));
        let last = (0..rows).rev().find(|&i| self.order(i) != Highest::Acceleration).unwrap_or(0);
        let lu = Lu::new(&scaled).map_err(|s| Undetermined(if self.order(s.column) == Highest::Acceleration { last } else { s.column }))?;
        // NaN fails
        if lu.pivot_ratio() > REGULAR { Ok(()) } else { Err(Undetermined(last)) }
    }

    /// Number of rows of coordinates, that of a free spin counted.
    fn rows(&self) -> usize {
        self.highest.len() + usize::from(self.free)
    }

    /// That of a coordinate; a free spin has inertia.
    pub fn order(&self, i: usize) -> Highest {
        self.highest.get(i).copied().unwrap_or(Highest::Acceleration)
    }

    /// Of the coordinates.
    pub fn highest(&self) -> &[Highest] {
        &self.highest
    }

    /// Index among (q, v, z) of what is a state.
    pub fn states(&self, m: usize) -> Vec<usize> {
        let n = self.highest.len();
        let places = (0..n).filter(|&i| self.highest[i] != Highest::Place);
        let velocities = (0..n).filter(|&i| self.highest[i] == Highest::Acceleration).map(|i| n + i);
        places.chain(velocities).chain(2 * n..2 * n + m).collect()
    }

    /// H of the tangents.
    pub fn index_matrix(&self, t: &Tangent, h: &mut Mat) {
        let rows = self.rows();
        h.reset(rows, rows);
        for j in 0..rows {
            let column = match self.order(j) {
                Highest::Acceleration => &t.a,
                Highest::Rate => &t.v,
                Highest::Place => &t.q,
            };
            for i in 0..rows {
                h[(i, j)] = column[(i, j)];
            }
        }
    }

    /// The rates of what is a state over the states, in the order of [`Orders::states`]; `None` where H is singular.
    pub fn over_states(&self, t: &Tangent) -> Option<Mat> {
        let mut h = Mat::default();
        self.index_matrix(t, &mut h);
        let lu = Lu::new(&h).ok()?;
        let whole = self.first_order(t, &lu)?.rates;
        let kept = self.states(t.rate_z.rows());
        Some(Mat::from_fn(kept.len(), kept.len(), |i, j| whole[(kept[i], kept[j])]))
    }

    /// Over (q, v, z [, angle, speed]) from the tangents and the factors of H; `None` where the rates of internal states are not determined.
    pub fn first_order(&self, t: &Tangent, lu: &Lu) -> Option<FirstOrder> {
        let (n, m, rows) = (self.highest.len(), t.rate_z.rows(), self.rows());
        let spin = 2 * n + m;
        let states = spin + if self.free { 2 } else { 0 };
        // column of the tangents by places, velocities or internal states that a state is
        let over = |of: [&Mat; 3], i: usize, j: usize| match j {
            j if j < n => match self.highest[j] {
                Highest::Place => 0.0,
                _ => of[0][(i, j)],
            },
            j if j < 2 * n => match self.highest[j - n] {
                Highest::Acceleration => of[1][(i, j - n)],
                _ => 0.0,
            },
            j if j < spin => of[2][(i, j - 2 * n)],
            j if j == spin => of[0][(i, n)],
            _ => of[1][(i, n)],
        };
        let mut highest = Mat::from_fn(rows, states, |i, j| -over([&t.q, &t.v, &t.z], i, j));
        lu.solve_mat(&mut highest);
        let through = |k: usize, i: usize| match self.order(i) {
            Highest::Acceleration => t.rate_a[(k, i)],
            Highest::Rate => t.rate_v[(k, i)],
            Highest::Place => t.rate_q[(k, i)],
        };
        let mut rates = Mat::from_fn(states, states, |i, j| match i {
            i if i < n => match self.highest[i] {
                Highest::Acceleration => f64::from(u8::from(j == n + i)),
                Highest::Rate => highest[(i, j)],
                Highest::Place => 0.0,
            },
            i if i < 2 * n => match self.highest[i - n] {
                Highest::Acceleration => highest[(i - n, j)],
                _ => 0.0,
            },
            i if i < spin => {
                let k = i - 2 * n;
                over([&t.rate_q, &t.rate_v, &t.rate_z], k, j) + (0..rows).map(|c| through(k, c) * highest[(c, j)]).sum::<f64>()
            }
            i if i == spin => f64::from(u8::from(j == spin + 1)),
            _ => highest[(n, j)],
        });
        let places: Vec<usize> = (0..n).filter(|&i| self.highest[i] == Highest::Place).collect();
        if !self.reads_rates_of_places(t) {
            return Some(FirstOrder { highest, rates });
        }
        // (1 - B D) y' = .. with D y' the rates of places and B what internal states make of them
        let coupled = Mat::from_fn(states, states, |i, j| {
            let own = f64::from(u8::from(i == j));
            let of_place = |&p: &usize| t.rate_v[(i - 2 * n, p)] * highest[(p, j)];
            if (2 * n..spin).contains(&i) { own - places.iter().map(of_place).sum::<f64>() } else { own }
        });
        Lu::new(&coupled).ok()?.solve_mat(&mut rates);
        Some(FirstOrder { highest, rates })
    }

    /// The rate of some internal state depends on the velocity of a coordinate whose place follows from others.
    pub fn reads_rates_of_places(&self, t: &Tangent) -> bool {
        let of = |i: usize| (0..t.rate_v.rows()).any(|k| t.rate_v[(k, i)] != 0.0);
        self.highest.iter().enumerate().any(|(i, h)| *h == Highest::Place && of(i))
    }
}
