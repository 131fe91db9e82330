//! Maps over the period as products of equal steps and by adapted steps: two methods, one answer, whatever the symmetry of the motion.

use crate::common;

use common::base::Base;
use laval::model::builder::Builder;
use laval::model::field::Attach;
use laval::model::part::Link;
use laval::model::system::System;
use laval::parts::{bearing_cubic::*, bearing_hertz::*, damper::*, disc::*};
use laval::solve::harmonic::balance::problem::Balance;
use laval::solve::harmonic::branches::response::{Request, respond};
use laval::solve::harmonic::stability::floquet::{Method, Stability};
use laval::solve::symmetry::Symmetry;
use std::sync::atomic::AtomicBool;

/// Compares both methods on up to 40 motions of every branch; gives the symmetries met, and the largest difference of an exponent over the sum of the errors stated.
fn compare(system: &System, request: &Request) -> (Vec<Symmetry>, f64) {
    let response = respond(system, request, &AtomicBool::new(false), &|_| {}).unwrap();
    let (mut symmetries, mut worst) = (Vec::new(), 0.0f64);
    for branch in &response.branches {
        let mut balance = Balance::new(system, branch.discretisation, request.speeds, None).unwrap();
        let [mut products, mut adapted] = [Stability::new(system).unwrap(), Stability::new(system).unwrap().adaptively()];
        let step = branch.points.len().div_ceil(40);
        for p in branch.points.iter().step_by(step) {
            balance.sample(&p.x, p.speed);
            let one = products.exponents(&mut balance, &p.x, p.speed).unwrap();
            balance.sample(&p.x, p.speed);
            let other = adapted.exponents(&mut balance, &p.x, p.speed).unwrap();
            assert_eq!(one.method, other.method);
            if one.method != Method::Map {
                continue;
            }
            let base = p.speed.abs() / branch.discretisation.divisor as f64;
            for z in &one.values {
                // frequencies are known up to multiples of the base frequency
                let apart = |w: &laval_num::complex::C64| {
                    let turns = (z.im - w.im) / (std::f64::consts::TAU / one.span);
                    (z.re - w.re).hypot((turns - turns.round()) * base)
                };
                let nearest = other.values.iter().map(apart).fold(f64::INFINITY, f64::min);
                worst = worst.max(nearest / (one.error + other.error));
            }
            if !symmetries.contains(&branch.discretisation.symmetry) {
                symmetries.push(branch.discretisation.symmetry);
            }
        }
    }
    (symmetries, worst)
}

#[test]
fn products_of_equal_steps_are_the_maps_of_adapted_steps() {
    let range = |from: f64, to: f64| Request { harmonics: Some(7), ..Request::over(from, to) };
    let per_axis = Base { e: 5e-5, ..Base::default() }.builder().build().unwrap();
    let (symmetries, worst) = compare(&per_axis, &range(1500.0, 4000.0));
    assert!(symmetries.contains(&Symmetry::Quarter) && worst < 1.0, "{symmetries:?} {worst}");

    // unequal axes leave the half turn
    let link = || Link::Between(Attach::on("rotor"), Attach::ground());
    let law = |cubic: f64| BearingCubicParams { stiffness: [1e6, 1.7e6], cubic_stiffness: [cubic; 2], valid_to: 0.0 };
    let oval = |horizontal: bool, speed: f64| {
        let b = Builder::new("unequal")
            .speed(speed)
            .part("rotor", Disc::planar(), DiscParams { eccentricity: 4e-5, ..DiscParams::new(2.0) })
            .part("bearing", BearingCubic::per_axis(link()), law(2e14))
            .part("loss", Damper::fixed(link()), DamperParams { damping: [120.0; 2], tilt_damping: 0.0 });
        if horizontal { b.horizontal() } else { b }.build().unwrap()
    };
    let (symmetries, worst) = compare(&oval(false, 700.0), &range(300.0, 1500.0));
    assert!(symmetries == [Symmetry::Half] && worst < 1.0, "{symmetries:?} {worst}");
    // backwards as well
    let (_, worst) = compare(&oval(false, -700.0), &range(-1500.0, -300.0));
    assert!(worst < 1.0, "{worst}");
    // and weight leaves none
    let (symmetries, worst) = compare(&oval(true, 700.0), &range(300.0, 1500.0));
    assert!(symmetries == [Symmetry::None] && worst < 1.0, "{symmetries:?} {worst}");

    // a law that is no polynomial needs more samples
    let hertz = Builder::new("preloaded")
        .part("rotor", Disc::planar(), DiscParams { eccentricity: 2e-5, ..DiscParams::new(6.0) })
        .part("bearing", BearingHertz::radial(link()), BearingHertzParams { coefficient: 1.33e10, clearance: 0.0 })
        .part("loss", Damper::fixed(link()), DamperParams { damping: [900.0; 2], tilt_damping: 0.0 })
        .horizontal()
        .build()
        .unwrap();
    let (_, worst) = compare(&hertz, &range(100.0, 1500.0));
    assert!(worst < 1.0, "{worst}");
}
