//! Roots that grow with a viscous liquid, against counts by the argument principle in another program.

use super::{FILE, at, build, changed, filled, isotropic, truncated, viscous};
use crate::common::{number, rows};
use laval::solve::characteristic::Characteristic;
use laval::solve::rest::rest;
use laval::solve::roots::Request;
use laval::solve::sweep::sweep;
use laval_num::complex::c;
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

/// Rotor and tilt on unequal bearings or equal ones, with the plane, the strip and the spatial flow of oils.
fn oils() -> Vec<String> {
    let plane = |text: &str| changed(text, &[("model = \"strip\"", "model = \"planar\"")]);
    let mut out = Vec::new();
    for nu in ["1e-8", "1e-7", "1e-5", "1e-4", "1e-3"] {
        let text = viscous(FILE, nu);
        out.extend([plane(&text), isotropic(&text), truncated(&text, 3), truncated(&isotropic(&text), 5), filled(&text, 0.9)]);
    }
    out
}

/// Roots that decay slowly are met although nothing counts them: Newton's method from thousands of places beside the axis finds no others.
#[test]
fn slow_decay_is_not_overlooked() {
    let cases: Vec<(String, f64)> = oils().into_iter().flat_map(|t| [60.0, 150.0, 333.0, 700.0].map(|w| (t.clone(), w))).collect();
    let wrong: Vec<String> = cases
        .par_iter()
        .flat_map(|(text, speed)| {
            let system = build(text);
            let found = at(&system, *speed, &Request::default());
            let known: Vec<_> = found.spectrum.modes.iter().map(|m| m.value).collect();
            let about = rest(&system, *speed).unwrap();
            let mut t = Characteristic::new(&system, &about);
            let mut lost = Vec::new();
            for (k, share) in (0..150).flat_map(|k| [-0.002, -0.01, -0.03].map(|d| (k, d))) {
                let start = c(share * speed, (f64::from(k) + 0.5) / 150.0 * found.frequency);
                let Some(p) = t.polish(start, None) else { continue };
                let z = if p.value.im < 0.0 { p.value.conj() } else { p.value };
                let slow = z.re > -0.02 * speed && z.im < found.frequency && z.im > 1e-3 * speed && p.defect < 1e-9;
                if slow && !known.iter().any(|k| (*k - z).abs() <= 1e-7 * z.abs()) {
                    lost.push(format!("{z:?}"));
                }
            }
            lost.dedup();
            (!lost.is_empty()).then(|| format!("{speed} {} {lost:?}\n{text}", known.len()))
        })
        .collect();
    assert!(wrong.is_empty(), "{} of {}\n{}", wrong.len(), cases.len(), wrong.join("\n"));
}

/// A branch of slow decay goes on from the first speed to the last, unless its frequency or its decay leaves the region.
#[test]
fn branches_begin_at_the_first_speed() {
    // every second: each form and each viscosity is among them
    for text in oils().into_iter().step_by(2) {
        let system = build(&text);
        let speeds: Vec<f64> = (0..13).map(|k| 100.0 + 20.0 * f64::from(k)).collect();
        let limit = 900.0;
        let found = sweep(&system, &|w| rest(&system, w), &speeds, limit, |_, _| true).unwrap();
        for b in &found.branches {
            for (w, m) in &b.points {
                let (_, all) = found.points.iter().find(|p| p.0 == *w).unwrap();
                assert!(all.modes.iter().any(|k| k.value == m.value), "{w} {:?}\n{text}", m.value);
            }
            for (w, m) in [b.points.first().unwrap(), b.points.last().unwrap()] {
                let end = *w == speeds[0] || *w == speeds[12];
                let leaves = m.value.im > 0.9 * limit || m.value.im < 0.05 * w || m.value.re < -0.05 * w;
                assert!(end || leaves, "{w} {:?}\n{text}", m.value);
            }
        }
    }
}
