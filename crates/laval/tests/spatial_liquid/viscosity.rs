//! Viscous liquid: tables, sign of the work, limits.

use super::{apart, cavity, frequencies, named};
use laval::cavity::{Cavity, Truncation};
use laval_num::complex::{C64, c};
use laval_num::dual::Dual;

const SPEED: f64 = 100.0;

#[test]
fn plane_flow() {
    let table = named(include_str!("../reference/spatial/L0_viscous_planar.csv"));
    assert!(table.len() > 150);
    for (name, x) in table {
        let found = cavity(name).planar_viscous(c(x[1], x[2]), SPEED, x[0]);
        assert!(apart(found, c(x[3], x[4])) < 2e-12, "{name} {x:?}: {found:?}");
    }
}

/// Three roots with Bessel functions against collocation in the radius, with the same harmonics.
#[test]
fn tilt_with_ends_that_do_not_hold_the_liquid() {
    let table = named(include_str!("../reference/spatial/Lt_viscous_freeslip_caps.csv"));
    assert_eq!(table.len(), 32);
    for (name, x) in table {
        let (geometry, w, table) = (cavity(name), c(x[1], x[2]), c(x[3], x[4]));
        let cut = geometry.tilt_viscous(w, SPEED, x[0], Truncation::At(81)).value;
        // nine digits are printed
        assert!(apart(cut, table) < 1e-8, "{name} {x:?}: {cut:?}");
        let whole = geometry.tilt_viscous(w, SPEED, x[0], Truncation::None);
        assert!(apart(whole.value, table) < 1e-5 && whole.error < 1e-9 * table.abs(), "{name} {x:?}: {whole:?}");
        // with four times the harmonics the plain sum is far closer to what the tail makes of it
        let longer = geometry.tilt_viscous(w, SPEED, x[0], Truncation::At(321)).value;
        assert!((longer - whole.value).abs() < 0.05 * (cut - whole.value).abs(), "{name} {x:?}: {longer:?} {whole:?}");
    }
}

/// Power lost to viscosity: whirl faster than the rotor or against it is damped, slower whirl is driven.
#[test]
fn sign_of_the_work() {
    for name in ["G1", "G2", "G3", "G4"] {
        let geometry = cavity(name);
        for nu in [1e-6, 1e-4, 1e-2] {
            for j in -40..=60 {
                let w = 7.3 * f64::from(j);
                let at = c(w, 0.0);
                let (planar, tilt) = (geometry.planar_viscous(at, SPEED, nu), geometry.tilt_viscous(at, SPEED, nu, Truncation::None));
                assert!(planar.im * (w - SPEED) <= 1e-9 * planar.abs() * SPEED, "{name} {nu} {w}: {planar:?}");
                assert!(tilt.value.im * (w - SPEED) <= (tilt.error + 1e-9 * tilt.value.abs()) * SPEED, "{name} {nu} {w}: {tilt:?}");
            }
        }
    }
}

/// Towards no viscosity both reactions approach those of the ideal liquid with the square root.
#[test]
fn small_viscosity() {
    for name in ["G1", "G3"] {
        let geometry = cavity(name);
        for w in frequencies() {
            let ideal = [geometry.planar(w, SPEED), geometry.tilt(w, SPEED, Truncation::None).value];
            let viscous = |nu: f64| [geometry.planar_viscous(w, SPEED, nu), geometry.tilt_viscous(w, SPEED, nu, Truncation::None).value];
            let (more, less) = (viscous(1e-9), viscous(1e-11));
            for i in 0..2 {
                let ratio = (more[i] - ideal[i]).abs() / (less[i] - ideal[i]).abs();
                assert!((ratio / 10.0 - 1.0).abs() < 0.1, "{name} {w:?} {i}: {ratio}");
            }
        }
    }
}

/// The flows used close to and away from synchronous whirl are the same flow, and at it the surface stays round the axis.
#[test]
fn close_to_synchronous_whirl() {
    for (name, nu) in [("G1", 1e-4), ("G3", 0.1), ("G4", 1e-6)] {
        let geometry = cavity(name);
        let unit = nu / geometry.radius.powi(2);
        let whole = geometry.full_mass() * SPEED * SPEED;
        assert!(apart(geometry.planar_viscous(c(SPEED, 0.0), SPEED, nu), c(whole, 0.0)) < 1e-12);
        // on a circle across the change of method, values must continue each other: the mean of an analytic function is its value in the middle
        let centre = c(SPEED + 2.25 * unit, 0.0);
        let points = 32;
        let mut mean = C64::zero();
        for j in 0..points {
            mean += geometry.planar_viscous(centre + C64::cis(0.1963495408493621 * f64::from(j)).scale(0.2 * unit), SPEED, nu);
        }
        assert!(apart(mean.scale(1.0 / f64::from(points)), geometry.planar_viscous(centre, SPEED, nu)) < 1e-12, "{name}");
        for aside in [1e-9, 1e-6, 1e-3] {
            let near = geometry.planar_viscous(c(SPEED, aside * unit), SPEED, nu);
            assert!((near.abs() / whole - 1.0).abs() < 10.0 * aside * unit / SPEED + 1e-12, "{name} {aside}");
        }
    }
}

#[test]
fn derivatives() {
    type D = Dual<f64, 2>;
    let g = cavity("G1");
    let lifted = Cavity { radius: D::lift(g.radius), free: D::lift(g.free), height: D::lift(g.height), density: D::lift(g.density) };
    for w in [c(50.0, 10.0), c(130.0, 0.0), c(100.002, 0.0), c(-100.0, 0.0)] {
        let nu = 1e-3;
        let (at, speed, thick) = (c(D::seed(w.re, 0), D::lift(w.im)), D::lift(SPEED), D::seed(nu, 1));
        let exact = [lifted.planar_viscous(at, speed, thick), lifted.tilt_viscous(at, speed, thick, Truncation::None).value];
        for i in 0..2 {
            let size = if i == 0 { 1.0 } else { nu };
            let moved = |x: f64| {
                let (w, nu) = if i == 0 { (w + c(x, 0.0), nu) } else { (w, nu * (1.0 + x)) };
                [g.planar_viscous(w, SPEED, nu), g.tilt_viscous(w, SPEED, nu, Truncation::None).value]
            };
            let h = 1e-4;
            let f = [-2.0, -1.0, 1.0, 2.0].map(|j| moved(j * h));
            for j in 0..2 {
                let difference = ((f[2][j] - f[1][j]).scale(8.0) - (f[3][j] - f[0][j])).scale(1.0 / (12.0 * h));
                let slope = c(exact[j].re.eps[i], exact[j].im.eps[i]).scale(size);
                assert!(
                    (slope - difference).abs() < 1e-7 * slope.abs() + 1e-9 * moved(0.0)[j].abs(),
                    "{w:?} {i} {j}: {slope:?} {difference:?}"
                );
            }
        }
    }
}
