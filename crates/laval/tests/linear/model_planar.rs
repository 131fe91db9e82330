//! The planar machine against the reference eigenvalues, through the assembled parts.

use laval::model::blocks::Grid;
use laval::model::builder::Builder;
use laval::model::field::Attach;
use laval::model::linear::{Form, LinearModel, LinearScratch};
use laval::model::part::{At, Link};
use laval::model::system::System;
use laval::model::tangent::{Tangent, TangentScratch};
use laval::parts::{bearing_cubic::*, damper::*, disc::*, foundation::*, liquid::*};
use laval_num::complex::{C64, c};
use laval_num::dense::{Lu, Mat};

fn base(fill: Option<f64>) -> System {
    let joint = || Link::Between(Attach::on("drum"), Attach::on("base"));
    let mut b = Builder::new("base set")
        .part("drum", Disc::planar(), DiscParams { eccentricity: 1e-3, ..DiscParams::new(2.4) })
        .part("base", Foundation, FoundationParams { mass: 25.0, stiffness: [3.26e5; 2], damping: [6.59; 2] })
        .part(
            "bearing",
            BearingCubic::per_axis(joint()),
            BearingCubicParams { stiffness: [1.1e7; 2], cubic_stiffness: [8.7e10; 2], valid_to: 0.0 },
        )
        .part(
            "air",
            Damper::fixed(Link::Between(Attach::on("drum"), Attach::ground())),
            DamperParams { damping: [42.0; 2], tilt_damping: 0.0 },
        );
    if let Some(r) = fill {
        let p = LiquidParams { wave_damping: 0.0, ..LiquidParams::new(0.07, 0.06, 1000.0, 0.07 * r) };
        b = b.part("liquid", Liquid::new(Attach::on("drum"), Fill::Partial), p);
    }
    b.build().unwrap()
}

/// At the reference eigenvalue the dynamic stiffness is singular.
#[test]
fn reference_eigenvalue_is_a_root_of_the_dynamic_stiffness() {
    let system = base(Some(0.667));
    let (q, z) = (vec![0.0; system.n()], vec![0.0; system.m()]);
    let at = At { q: &q, v: &q, a: &q, z: &z, phase: 0.0, speed: 3000.0, spin_accel: 0.0, t: 0.0 };
    let (mut tangent, mut ts) = (Tangent::default(), TangentScratch::default());
    system.tangent(&at, false, &mut tangent, &mut ts, |s| !s.is_linear());
    let (mut model, mut scratch) = (LinearModel::default(), LinearScratch::default());
    system.linear(system.params(), 3000.0, Form::Frequency, &mut model, &mut scratch);
    let mut det = |s: C64| {
        let mut z = Grid::empty();
        system.dynamic_stiffness(system.params(), &model, Form::Frequency, s, &mut z, &mut scratch);
        let n = system.n();
        let m = Mat::from_fn(z.rows(), z.cols(), |i, j| z[(i, j)] + c(if i < n && j < n { tangent.q[(i, j)] } else { 0.0 }, 0.0));
        Lu::new(&m).map(|lu| lu.det().abs()).unwrap_or(0.0)
    };
    let at_root = det(c(192.0108286, 1966.243843));
    let beside = det(c(193.0108286, 1966.243843));
    assert!(at_root < 1e-5 * beside, "{at_root:e} {beside:e}");
}
