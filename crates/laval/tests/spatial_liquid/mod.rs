//! Liquid in three dimensions and with viscosity: reactions of a cavity, and the machine that carries one.

mod machine;
mod offsets;
mod reactions;
mod time_form;
mod viscosity;
mod viscous_time_form;

use laval::cavity::Cavity;
use laval_num::complex::{C64, c};

/// The cavities of the reference tables.
fn cavity(name: &str) -> Cavity<f64> {
    let (radius, free, height) = match name {
        "G1" => (0.15, 0.105, 0.30),
        "G2" => (0.20, 0.18, 0.06),
        "G3" => (0.06, 0.03, 0.60),
        "G4" => (0.15, 0.015, 0.20),
        _ => panic!("{name}"),
    };
    Cavity { radius, free, height, density: 1000.0 }
}

/// Rows of a table with the cavity's name first, the rest as numbers.
fn named(text: &str) -> Vec<(&str, Vec<f64>)> {
    crate::common::rows(text).into_iter().map(|r| (r[0], r[1..].iter().map(|x| crate::common::number(x)).collect())).collect()
}

/// Relative difference of complex numbers.
fn apart(is: C64, should: C64) -> f64 {
    (is - should).abs() / should.abs()
}

/// Frequencies off the real axis and on it outside the dense range, at 100 rad/s.
fn frequencies() -> Vec<C64> {
    vec![c(-300.0, 0.0), c(-125.0, 0.0), c(400.0, 0.0), c(50.0, 10.0), c(150.0, -10.0), c(80.0, 2.0), c(-50.0, -10.0), c(0.0, 20.0)]
}
