//! A bearing whose coefficients stand in a table over the speed, straight lines between its points.

use super::tools::{advance, check_tangents, orbits, response};
use laval::diagnostic::Diagnostics;
use laval::model::blocks::Blocks;
use laval::model::builder::Builder;
use laval::model::field::{Attach, Bounds, Field, ParamValues, Values};
use laval::model::part::{Layout, Link, Params, Part, Physics};
use laval::model::system::System;
use laval::params;
use laval::parts::{bearing_cubic::*, disc::*};
use laval::solve::harmonic::balance::problem::Balance;
use laval::solve::pencil::modes_about;
use laval::solve::rest::rest;
use laval::solve::symmetry::Symmetry;
use laval_num::complex::{C64, c};
use laval_num::scalar::Scalar;
use std::f64::consts::TAU;

params! {
    /// Parameters of a [`Tabulated`] bearing.
    pub struct TabulatedParams in TabulatedFamily {
        factor: scalar, "", Bounds::positive(1e3), default 1.0, "factor on all coefficients";
    }
}

/// Speed, then kxx, kxy, kyx, kyy, cxx, cyy.
type Row = [f64; 7];

pub struct Tabulated {
    link: Link,
    table: Vec<Row>,
}

impl Tabulated {
    fn at<S: Scalar>(&self, w: S, column: usize) -> S {
        let t = &self.table;
        let mut sum = S::cst(t[0][column]);
        let mut slope = 0.0;
        for i in 0..t.len() - 1 {
            let next = (t[i + 1][column] - t[i][column]) / (t[i + 1][0] - t[i][0]);
            sum += (w - S::cst(t[i][0])).pos().scale(next - slope);
            slope = next;
        }
        sum
    }
}

impl Part for Tabulated {
    const KIND: &'static str = "tabulated";
    const DOC: &'static str = "A bearing with a table over the speed.";
    type Family = TabulatedFamily;
    const FIELDS: &'static [Field] = &[];
    fn build(_: &Values, _: &mut ParamValues, _: &mut Diagnostics) -> Option<Self> {
        None
    }
    fn layout(&self) -> Layout {
        Layout::point(self.link.clone())
    }
    fn physics(&self) -> Physics {
        Physics::Linear
    }
    fn linear<S: Scalar>(&self, p: &Params<Self, S>, w: S, b: &mut Blocks<S>) {
        for (column, (i, j)) in [(0, 0), (0, 1), (1, 0), (1, 1)].into_iter().enumerate() {
            b.stiffness[(i, j)] = p.factor * self.at(w, 1 + column);
        }
        b.damping[(0, 0)] = p.factor * self.at(w, 5);
        b.damping[(1, 1)] = p.factor * self.at(w, 6);
    }
}

const TABLE: [Row; 4] = [
    [100.0, 1.0e6, 2e4, -1e4, 1.5e6, 300.0, 400.0],
    [300.0, 1.4e6, 5e4, -3e4, 1.8e6, 250.0, 300.0],
    [600.0, 1.2e6, 9e4, -5e4, 2.2e6, 200.0, 280.0],
    [900.0, 2.0e6, 1e5, -8e4, 2.4e6, 150.0, 200.0],
];
const MASS: f64 = 4.0;
const ECCENTRICITY: f64 = 1e-4;

fn machine(table: &[Row], cubic: f64) -> System {
    let link = || Link::Between(Attach::on("disc"), Attach::ground());
    let b = Builder::new("tabulated")
        .part("disc", Disc::planar(), DiscParams { eccentricity: ECCENTRICITY, ..DiscParams::new(MASS) })
        .part("bearing", Tabulated { link: link(), table: table.to_vec() }, TabulatedParams::new());
    if cubic == 0.0 {
        return b.build().unwrap();
    }
    let p = BearingCubicParams { stiffness: [0.0; 2], cubic_stiffness: [cubic; 2], valid_to: 0.0 };
    b.part("stop", BearingCubic::isotropic(link()), p).build().unwrap()
}

#[test]
fn modes_at_the_points_of_the_table() {
    let system = machine(&TABLE, 0.0);
    for row in TABLE {
        let mut flat = [row, row];
        flat[1][0] += 1e3;
        let values =
            |s: &System| modes_about(s, &rest(s, row[0]).unwrap(), false).unwrap().modes.iter().map(|m| m.value).collect::<Vec<C64>>();
        let (a, b) = (values(&system), values(&machine(&flat, 0.0)));
        assert_eq!(a.len(), b.len());
        for (x, y) in a.iter().zip(&b) {
            assert!((*x - *y).abs() <= 1e-13 * y.abs(), "{x:?} {y:?}");
        }
    }
}

fn interpolate(w: f64, column: usize) -> f64 {
    let i = TABLE.iter().rposition(|r| r[0] <= w).unwrap_or(0).min(TABLE.len() - 2);
    let (a, b) = (TABLE[i], TABLE[i + 1]);
    a[column] + (w - a[0]) / (b[0] - a[0]) * (b[column] - a[column])
}

#[test]
fn response_at_any_speed() {
    let (system, range) = (machine(&TABLE, 0.0), (120.0, 880.0));
    for o in orbits(&system, &response(&system, range), range) {
        let w = o.speed;
        let k = |column: usize| interpolate(w, column);
        let zx = c(k(1) - MASS * w * w, w * k(5));
        let zy = c(k(4) - MASS * w * w, w * k(6));
        let force = MASS * ECCENTRICITY * w * w;
        let (fx, fy) = (c(force, 0.0), c(0.0, -force));
        let det = zx * zy - c(k(2) * k(3), 0.0);
        let (x, y) = ((zy * fx - fy.scale(k(2))) / det, (zx * fy - fx.scale(k(3))) / det);
        let i = o.orders.iter().position(|&n| n == 1).unwrap();
        let size = x.abs() + y.abs();
        assert!((o.coordinates[i][0] - x).abs() < 1e-12 * size, "{w}: {:?} {x:?}", o.coordinates[i][0]);
        assert!((o.coordinates[i][1] - y).abs() < 1e-12 * size, "{w}: {:?} {y:?}", o.coordinates[i][1]);
    }
}

/// The continuation sees how the coefficients change with the speed.
#[test]
fn derivative_in_the_speed_is_exact() {
    let (system, range) = (machine(&TABLE, 1e12), (300.0, 600.0));
    let found = response(&system, range);
    let mut balance = Balance::new(&system, found.discretisation, range, None).unwrap();
    for p in found.branches[0].points.iter().step_by(20).filter(|p| p.speed > 310.0 && p.speed < 590.0) {
        check_tangents(&mut balance, &p.x, p.speed);
    }
}

#[test]
fn motion_at_constant_speed() {
    let (system, range) = (machine(&TABLE, 1e12), (400.0, 500.0));
    let o = &orbits(&system, &response(&system, range), range)[3];
    let (mut q, mut v, mut a) = ([0.0; 2], [0.0; 2], [0.0; 2]);
    o.at(0.0, &mut q, &mut v, &mut a, &mut []);
    let end = advance(&system, o.speed, &[q[0], q[1], v[0], v[1]], (0.0, 0.7 * TAU / o.speed));
    o.at(0.7 * TAU, &mut q, &mut v, &mut a, &mut []);
    for i in 0..2 {
        assert!((end[i] - q[i]).abs() < 1e-7 * q[0].hypot(q[1]), "{end:?} {q:?}");
    }
}

/// Equal in x and y at both ends and in the middle of the range, not between: the machine has no full symmetry.
#[test]
fn symmetry_is_requested_at_more_than_one_speed() {
    let row = |w: f64, kx: f64, ky: f64| [w, kx, 0.0, 0.0, ky, 200.0, 200.0];
    let table = [row(100.0, 1e6, 1e6), row(300.0, 1e6, 1.3e6), row(500.0, 1e6, 1e6), row(700.0, 1e6, 0.8e6), row(900.0, 1e6, 1e6)];
    let system = machine(&table, 1e12);
    let found = response(&system, (100.0, 900.0));
    assert_eq!(found.discretisation.symmetry, Symmetry::Half);
    assert_eq!(found.broken[0].part, "bearing");
}

/// Without the nonlinear stop.
pub fn linear() -> System {
    machine(&TABLE, 0.0)
}
