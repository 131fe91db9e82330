//! The orders of a machine of few coordinates condensed side by side, an order in each lane.
//!
//! The same equations as [`Condenser::order`](super::condense::Condenser::order), for a dynamic stiffness that is a polynomial in s.

use crate::harmonic::balance::condense::Order;
use crate::model::erased::D1;
use laval_num::complex::{C64, Complex, c};
use laval_num::factor::dense_lanes::{factor, load, solve, store};
use laval_num::factor::{Pair, Row};
use laval_num::lanes::{Kernel, LANES, LaneScalar, Level, dispatch};
use laval_num::refill::refill;
use laval_num::work::spend;

/// What all orders of one machine at one pace share.
pub(super) struct Shared<'a> {
    /// Unknowns of the dynamic stiffness, and nonlinear coordinates.
    pub size: usize,
    /// Place of each entry in the matrix, row by row.
    pub places: &'a [usize],
    /// `A0, A1, A2` by entries.
    pub quadratic: &'a [Vec<D1>; 3],
    /// Mass times minus the drive, by entries; none without a drive.
    pub drive: &'a [D1],
    /// Unknowns that belong to states of nonlinear parts.
    pub others: std::ops::Range<usize>,
    /// Places of the reference stiffness, and the stiffness of each nonlinear coordinate.
    pub references: &'a [(usize, f64)],
    pub reference: &'a [f64],
    /// Nonlinear coordinates over the unknowns.
    pub basis: &'a [Vec<(usize, f64)>],
    /// Base frequency.
    pub frequency: D1,
    pub slopes: bool,
}

/// Storage of one computation; reuse it to avoid allocation.
#[derive(Default)]
pub(super) struct OrdersInLanes {
    z: Vec<Pair>,
    dz: Vec<Pair>,
    exchanged: Vec<Row>,
    /// Solutions: B^T, F, F'.
    x: Vec<Pair>,
    /// Z' times the first of them, solved again.
    again: Vec<Pair>,
    flexibility: Vec<Pair>,
    change: Vec<Pair>,
    small: Vec<Pair>,
    stiffness: Vec<Pair>,
    slope: Vec<Pair>,
    load: Vec<Pair>,
    load_slope: Vec<Pair>,
}

/// Zero in all lanes.
const ZERO: Pair = [[0.0; LANES]; 2];

struct Condense<'a> {
    shared: &'a Shared<'a>,
    own: &'a mut OrdersInLanes,
    /// Orders, and what the reference stiffness has of loss.
    orders: Row,
    loss: Row,
}

impl Kernel for Condense<'_> {
    /// Every matrix was regular.
    type Out = bool;
    #[inline(always)]
    fn run<S: LaneScalar>(self) -> bool {
        let Condense { shared, own, orders, loss } = self;
        let (n, m, slopes) = (shared.size, shared.basis.len(), shared.slopes);
        let columns = m + 1 + usize::from(slopes);
        let k = S::load(&orders);
        let (w, dw) = (k.scale(shared.frequency.re), k.scale(shared.frequency.eps[0]));
        let (square, square_slope) = (-(w * w), (w * dw).scale(-2.0));
        let [a0, a1, a2] = shared.quadratic;
        for e in 0..shared.places.len() {
            let at = shared.places[e];
            let (a0, a1, a2) = (a0[e], a1[e], a2[e]);
            store(c(S::cst(a0.re) + square.scale(a2.re), w.scale(a1.re)), &mut own.z[at]);
            if slopes {
                let re = S::cst(a0.eps[0]) + square.scale(a2.eps[0]) + square_slope.scale(a2.re);
                store(c(re, w.scale(a1.eps[0]) + dw.scale(a1.re)), &mut own.dz[at]);
            }
        }
        for e in 0..shared.drive.len() {
            let (at, drive) = (shared.places[e], shared.drive[e]);
            let z = load::<S>(&own.z[at]);
            store(c(z.re, z.im + w.scale(drive.re)), &mut own.z[at]);
            if slopes {
                let dz = load::<S>(&own.dz[at]);
                store(c(dz.re, dz.im + w.scale(drive.eps[0]) + dw.scale(drive.re)), &mut own.dz[at]);
            }
        }
        for i in shared.others.clone() {
            store(c(S::one(), S::zero()), &mut own.z[i * n + i]);
        }
        let lossy = c(S::one(), S::load(&loss));
        for &(at, x) in shared.references {
            let z = load::<S>(&own.z[at]) + lossy.scale(S::cst(x));
            store(z, &mut own.z[at]);
        }
        let mut regular = factor::<S>(&mut own.z, n, &mut own.exchanged).is_none();
        solve::<S>(&own.z, n, &own.exchanged, &mut own.x, columns);
        if slopes {
            let width = m + 1;
            for i in 0..n {
                for j in 0..width {
                    let mut sum = Complex::<S>::zero();
                    for l in 0..n {
                        sum += load::<S>(&own.dz[i * n + l]) * load::<S>(&own.x[l * columns + j]);
                    }
                    store(sum, &mut own.again[i * width + j]);
                }
            }
            solve::<S>(&own.z, n, &own.exchanged, &mut own.again, width);
        }
        project::<S>(shared.basis, &own.x, columns, &mut own.flexibility);
        for i in 0..m {
            for j in 0..m {
                own.small[i * m + j] = own.flexibility[i * columns + j];
                store(if i == j { Complex::<S>::one() } else { Complex::zero() }, &mut own.stiffness[i * m + j]);
            }
        }
        regular &= factor::<S>(&mut own.small, m, &mut own.exchanged).is_none();
        solve::<S>(&own.small, m, &own.exchanged, &mut own.stiffness, m);
        for i in 0..m {
            let mut sum = Complex::<S>::zero();
            for j in 0..m {
                sum += load::<S>(&own.stiffness[i * m + j]) * load::<S>(&own.flexibility[j * columns + m]);
            }
            store(sum, &mut own.load[i]);
        }
        if slopes {
            let width = m + 1;
            project::<S>(shared.basis, &own.again, width, &mut own.change);
            // dK = -K dG K with dG = -B Z^-1 Z' Z^-1 B^T
            for i in 0..m {
                for j in 0..m {
                    let mut sum = Complex::<S>::zero();
                    for l in 0..m {
                        sum += load::<S>(&own.change[i * width + l]) * load::<S>(&own.stiffness[l * m + j]);
                    }
                    store(sum, &mut own.small[i * m + j]);
                }
            }
            for i in 0..m {
                let mut slope = Complex::<S>::zero();
                for j in 0..m {
                    let mut sum = Complex::<S>::zero();
                    for l in 0..m {
                        sum += load::<S>(&own.stiffness[i * m + l]) * load::<S>(&own.small[l * m + j]);
                    }
                    store(sum, &mut own.slope[i * m + j]);
                    let moved = load::<S>(&own.flexibility[j * columns + m]);
                    let faster = load::<S>(&own.flexibility[j * columns + m + 1]) - load::<S>(&own.change[j * width + m]);
                    slope += sum * moved + load::<S>(&own.stiffness[i * m + j]) * faster;
                }
                store(slope, &mut own.load_slope[i]);
            }
        }
        for i in 0..m {
            let k = load::<S>(&own.stiffness[i * m + i]) - lossy.scale(S::cst(shared.reference[i]));
            store(k, &mut own.stiffness[i * m + i]);
        }
        regular
    }
}

/// Rows of B applied to columns.
#[inline(always)]
fn project<S: LaneScalar>(basis: &[Vec<(usize, f64)>], x: &[Pair], columns: usize, out: &mut [Pair]) {
    for (i, row) in basis.iter().enumerate() {
        for j in 0..columns {
            let mut sum = Complex::<S>::zero();
            for &(g, factor) in row {
                sum += load::<S>(&x[g * columns + j]).scale(S::cst(factor));
            }
            store(sum, &mut out[i * columns + j]);
        }
    }
}

impl OrdersInLanes {
    /// Condenses up to [`LANES`] orders. `load` gives F and F' of an order at an unknown. False where a matrix is singular.
    pub(super) fn condense(
        &mut self,
        shared: &Shared,
        orders: &[usize],
        load: impl Fn(usize, usize) -> (C64, C64),
        out: &mut [Order],
    ) -> bool {
        let (n, m, slopes) = (shared.size, shared.basis.len(), shared.slopes);
        let columns = m + 1 + usize::from(slopes);
        spend((8 * orders.len() * n * n * (n + 2 * columns)) as u64);
        // entries outside the pattern stay zero
        let first = if shared.places.len() < n * n { 0 } else { n * n };
        for all in [&mut self.z, &mut self.dz] {
            all.truncate(first);
            all.resize(n * n, ZERO);
        }
        let resized = [
            (&mut self.x, n * columns),
            (&mut self.again, n * (m + 1)),
            (&mut self.flexibility, m * columns),
            (&mut self.change, m * (m + 1)),
            (&mut self.small, m * m),
            (&mut self.stiffness, m * m),
            (&mut self.slope, m * m),
            (&mut self.load, m),
            (&mut self.load_slope, m),
        ];
        for (all, len) in resized {
            refill(all, len, ZERO);
        }
        refill(&mut self.exchanged, n.max(m), [0.0; LANES]);
        for (j, row) in shared.basis.iter().enumerate() {
            for &(g, x) in row {
                self.x[g * columns + j][0].iter_mut().for_each(|lane| *lane += x);
            }
        }
        // lanes that are left repeat the last order
        let order = |lane: usize| orders[lane.min(orders.len() - 1)];
        for lane in 0..LANES {
            for i in 0..n {
                let (f, df) = load(order(lane), i);
                let at = i * columns + m;
                (self.x[at][0][lane], self.x[at][1][lane]) = (f.re, f.im);
                if slopes {
                    (self.x[at + 1][0][lane], self.x[at + 1][1][lane]) = (df.re, df.im);
                }
            }
        }
        let lanes: Row = std::array::from_fn(|lane| order(lane) as f64);
        let loss = lanes.map(|k| if k == 0.0 { 0.0 } else { 1.0 });
        if !dispatch(Level::best(), Condense { shared, own: self, orders: lanes, loss }) {
            return false;
        }
        for (lane, out) in out.iter_mut().enumerate() {
            self.unpack(lane, (n, m, columns), slopes, out);
        }
        true
    }

    /// One order.
    fn unpack(&self, lane: usize, (n, m, columns): (usize, usize, usize), slopes: bool, out: &mut Order) {
        let of = |x: &Pair| c(x[0][lane], x[1][lane]);
        out.spread.reset(n, m);
        out.free.clear();
        for i in 0..n {
            let row = &self.x[i * columns..][..columns];
            out.spread.row_mut(i).iter_mut().zip(row).for_each(|(o, x)| *o = of(x));
            out.free.push(of(&row[m]));
        }
        out.stiffness.reset(m, m);
        out.stiffness.data_mut().iter_mut().zip(&self.stiffness).for_each(|(o, x)| *o = of(x));
        out.load.clear();
        out.load.extend(self.load.iter().map(of));
        out.spread_speed.reset(if slopes { n } else { 0 }, m);
        out.free_speed.clear();
        if !slopes {
            return;
        }
        for i in 0..n {
            let (row, again) = (&self.x[i * columns..][..columns], &self.again[i * (m + 1)..][..m + 1]);
            out.spread_speed.row_mut(i).iter_mut().zip(again).for_each(|(o, x)| *o = -of(x));
            out.free_speed.push(of(&row[m + 1]) - of(&again[m]));
        }
        out.stiffness_speed.reset(m, m);
        out.stiffness_speed.data_mut().iter_mut().zip(&self.slope).for_each(|(o, x)| *o = of(x));
        out.load_speed.clear();
        out.load_speed.extend(self.load_slope.iter().map(of));
    }
}
