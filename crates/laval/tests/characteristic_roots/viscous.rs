//! Roots that grow with a viscous liquid, against counts by the argument principle in another program.

use super::{FILE, at, build, filled, viscous};
use crate::common::{number, rows};
use laval::solve::roots::Request;
use rayon::prelude::*;

/// One coordinate, w0 = 100 rad/s, R = 0.1 m, full cavity half the rotor, r0/R = 0.7.
pub(super) fn one_coordinate(zeta: f64, nu: f64) -> String {
    machine(zeta, nu, 0.5, 0.7)
}

/// One coordinate, w0 = 100 rad/s, rotor 20 kg, R = 0.1 m; full cavity over rotor `mu`, r0/R `free`.
pub(super) fn machine(zeta: f64, nu: f64, mu: f64, free: f64) -> String {
    let (w0, mass) = (100.0, 20.0);
    let height = mu * mass / (std::f64::consts::PI * 0.01 * 1000.0);
    let liquid = if nu > 0.0 { format!("viscosity = {:e}\n", nu * w0 * 0.01) } else { String::new() };
    format!(
        "[machine]\nname = \"one\"\nspeed = 100\n[[part]]\nkind = \"disc\"\nname = \"rotor\"\nmass = {mass}\npolar_inertia = 1\n\
         [[part]]\nkind = \"shaft_lumped\"\nname = \"shaft\"\nbetween = [\"rotor\", \"ground\"]\nstiffness = {}\n\
         [[part]]\nkind = \"damper\"\nname = \"air\"\nbetween = [\"rotor\", \"ground\"]\ndamping = {}\n\
         [[part]]\nkind = \"liquid\"\nname = \"water\"\nin = \"rotor\"\ncavity_radius = 0.1\ncavity_height = {height:e}\ndensity = 1000\n{liquid}fill = {{ free_surface_radius = {:e} }}\n",
        mass * w0 * w0,
        2.0 * zeta * mass * w0,
        0.1 * free,
    )
}

#[test]
fn counts_of_one_coordinate() {
    let table = rows(include_str!("../reference/spatial/viscous_1dof_stability.csv"));
    assert_eq!(table.len(), 609);
    let wrong: Vec<String> = table
        .par_iter()
        .filter_map(|r| {
            let (zeta, nu, speed) = (number(r[0]), number(r[1]), 100.0 * number(r[2]));
            let system = build(&one_coordinate(zeta, nu));
            let margin = if nu > 0.0 { 1e-4 } else { 1e-5 };
            let found = at(&system, speed, &Request { margin, growing: true, ..Request::default() });
            let count = found.growing();
            let best = found.spectrum.least_stable().map_or(f64::NAN, |m| m.value.re);
            let growth = 100.0 * number(r[4]);
            let right = count == Some(number(r[3]) as usize) && (number(r[3]) == 0.0 || (best - growth).abs() < 2e-6 * growth + 1e-7);
            (!right).then(|| format!("{r:?}: {count:?} {best} {:?}", found.areas))
        })
        .collect();
    assert!(wrong.is_empty(), "{} wrong\n{:#?}", wrong.len(), &wrong[..wrong.len().min(10)]);
}

#[test]
fn counts_of_the_machine() {
    let table = rows(include_str!("../reference/spatial/viscous_S1_stability.csv"));
    assert_eq!(table.len(), 126);
    let wrong: Vec<String> = table
        .par_iter()
        .filter_map(|r| {
            let system = build(&viscous(&filled(FILE, number(r[0])), r[1]));
            let found = at(&system, number(r[2]), &Request { margin: 1e-3, growing: true, ..Request::default() });
            // the table counts both of a pair
            let count = found.growing().map(|n| 2 * n);
            let best = found.spectrum.least_stable().map_or(f64::NAN, |m| m.value.re);
            let growth = number(r[4]);
            let right = count == Some(number(r[3]) as usize) && (growth < 1e-3 || (best - growth).abs() < 2e-6 * growth + 1e-8);
            (!right).then(|| format!("{r:?}: {count:?} {best} {:?}", found.areas))
        })
        .collect();
    assert!(wrong.is_empty(), "{} wrong\n{:#?}", wrong.len(), &wrong[..wrong.len().min(10)]);
}
