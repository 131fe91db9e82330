//! Ideal liquid: tables, closed forms at special frequencies, limits, symmetries, derivatives.

use super::{apart, cavity, frequencies, named};
use laval::cavity::{Cavity, Truncation};
use laval_num::complex::{C64, Complex, c};
use laval_num::dual::Dual;
use std::f64::consts::PI;

const SPEED: f64 = 100.0;

fn tilt(name: &str, w: C64) -> C64 {
    cavity(name).tilt(w, SPEED, Truncation::None).value
}

#[test]
fn table_of_reactions() {
    let (mut most, mut worst) = (0, 0.0f64);
    let table = named(include_str!("../reference/spatial/L_ideal.csv"));
    assert_eq!(table.len(), 56);
    for (name, x) in table {
        let (geometry, w) = (cavity(name), c(x[0], x[1]));
        let planar = geometry.planar(w, SPEED);
        let found = geometry.tilt(w, SPEED, Truncation::None);
        let (l0, lt) = (c(x[2], x[3]), c(x[4], x[5]));
        assert!(apart(planar, l0) < 1e-12, "{name} {w:?}");
        let off = (found.value - lt).abs();
        // thirteen digits are printed
        assert!(off <= found.error + 1e-12 * lt.abs(), "{name} {w:?}: off by {off:e}, estimate {:e}", found.error);
        assert!(off <= 1e-12 * lt.abs() && found.error <= 1e-10 * lt.abs(), "{name} {w:?}: {off:e} {:e}", found.error);
        (most, worst) = (most.max(found.harmonics), worst.max(off / lt.abs()));
        // about the bottom of the cavity
        let z = 0.5 * geometry.height;
        let (l12, l22) = (-planar.mul_i().scale(z), planar.scale(z * z) + found.value);
        assert!((l12 - c(x[6], x[7])).abs() <= 1e-12 * l0.abs() * z, "{name} {w:?}");
        assert!((l22 - c(x[8], x[9])).abs() <= 1e-12 * (l0.abs() * z * z + lt.abs()), "{name} {w:?}");
    }
    println!("at most {most} harmonics, worst relative error {worst:.1e}");
}

#[test]
fn partial_sums() {
    let text = include_str!("../reference/spatial/series_convergence.csv");
    let table: Vec<Vec<f64>> =
        crate::common::rows(text).into_iter().map(|r| r.iter().map(|x| crate::common::number(x)).collect()).collect();
    assert!(table.len() > 60);
    for row in table {
        let (w, last) = (c(row[0], row[1]).scale(SPEED), row[2] as usize);
        let sum = cavity("G1").tilt(w, SPEED, Truncation::At(last)).value;
        assert!(apart(sum, c(row[3], row[4])) < 1e-11, "{row:?}: {sum:?}");
    }
}

/// At `sigma = -2 W` each harmonic is rational; the sum of all is closed.
#[test]
fn backward_synchronous() {
    let w = c(-SPEED, 0.0);
    for (name, x) in named(include_str!("../reference/spatial/L_ideal_backward_synchronous.csv")) {
        let geometry = cavity(name);
        assert!(apart(geometry.planar(w, SPEED), c(x[1], 0.0)) < 1e-12, "{name}");
        let whole = tilt(name, w);
        // ten digits
        assert!(apart(whole, c(x[2], 0.0)) < 5e-11 && whole.im == 0.0, "{name} {whole:?}");
        // what is missing from a partial sum falls as 1/N, from N to 2 N by half
        let missing = |n: usize| (geometry.tilt(w, SPEED, Truncation::At(n)).value - whole).re;
        let (few, many) = (missing(20_001), missing(40_003));
        assert!((few / many - 2.0).abs() < 1e-3, "{name}: {few} {many}");
    }
}

/// At `sigma = 2 W` terms fall as `k^-4`.
#[test]
fn forward_thrice_synchronous() {
    let w = c(3.0 * SPEED, 0.0);
    for name in ["G1", "G2", "G3", "G4"] {
        let whole = tilt(name, w);
        let sum = cavity(name).tilt(w, SPEED, Truncation::At(8001)).value;
        assert!(apart(sum, whole) < 1e-10, "{name}: {sum:?} {whole:?}");
        // from above the value is met continuously
        for (aside, within) in [(1e-6, 1e-3), (1e-9, 1e-6), (1e-12, 1e-9)] {
            assert!(apart(tilt(name, w.scale(1.0 + aside)), whole) < within, "{name} {aside}");
        }
    }
}

/// What roots are counted with is the sum to eight digits, for less work where that counts: beside the axis among the inertial waves.
#[test]
fn the_rough_sum_is_the_sum() {
    for name in ["G1", "G2", "G3"] {
        let mut harmonics = [0; 2];
        for k in 0..60 {
            for decay in [1e-2, -1e-2, 0.1, 2.0] {
                let w = c((-2.0 + 0.1 * f64::from(k)) * SPEED, decay * SPEED);
                let [whole, rough] = [Truncation::None, Truncation::Rough].map(|t| cavity(name).tilt(w, SPEED, t));
                assert!(apart(rough.value, whole.value) < 1e-7, "{name} {w:?}: {rough:?} {whole:?}");
                harmonics[0] += whole.harmonics;
                harmonics[1] += rough.harmonics;
                let [whole, rough] = [Truncation::None, Truncation::Rough].map(|t| cavity(name).tilt_viscous(w, SPEED, 1e-5, t).value);
                assert!(apart(rough, whole) < 1e-7, "{name} {w:?}, viscous: {rough:?} {whole:?}");
            }
        }
        assert!(2 * harmonics[1] < harmonics[0], "{name}: {harmonics:?}");
    }
}

/// Flat cavities, whose surface waves lie on either side of the first harmonic, take the other branch of the closed sums.
#[test]
fn closed_sums_of_flat_and_full_cavities() {
    for (free, height) in [(0.18, 0.03), (0.18, 0.06), (0.1, 0.02), (0.01, 0.4), (0.0, 0.3), (0.0, 0.05)] {
        let geometry = Cavity { radius: 0.2, free, height, density: 900.0 };
        for w in [-SPEED, 3.0 * SPEED] {
            let w = c(w, 0.0);
            let whole = geometry.tilt(w, SPEED, Truncation::None).value;
            let part = |n: usize| geometry.tilt(w, SPEED, Truncation::At(n)).value;
            // Richardson's extrapolation of the slower of the two tails
            let (few, many) = (part(20_001), part(40_003));
            let sum = many.scale(2.0) - few;
            assert!(apart(sum, whole) < 2e-8, "{free} {height} {w:?}: {sum:?} {whole:?}");
        }
    }
}

/// From below `sigma = -2 W` the sum approaches its value there, slowly: its slope grows without bound.
#[test]
fn neighbourhood_of_backward_synchronous() {
    for name in ["G1", "G2", "G3", "G4"] {
        let at = tilt(name, c(-SPEED, 0.0));
        let mut last = f64::INFINITY;
        for aside in [1e-4, 1e-6, 1e-8, 1e-10] {
            let found = cavity(name).tilt(c(-SPEED * (1.0 + aside), 0.0), SPEED, Truncation::None);
            let off = apart(found.value, at);
            assert!(off < 0.2 * last && found.error < 1e-9 * at.abs(), "{name} {aside}: {off:e}");
            last = off;
        }
        assert!(last < 1e-4);
    }
}

#[test]
fn synchronous_and_conjugate_frequencies() {
    for name in ["G1", "G2", "G3", "G4"] {
        let geometry = cavity(name);
        let w = c(SPEED, 0.0);
        assert!(apart(geometry.planar(w, SPEED), c(geometry.full_mass() * SPEED * SPEED, 0.0)) < 1e-15);
        // as seen by a rotor: the inertia C - A of the full cavity without the column inside the free surface
        let (r, s, h) = (geometry.radius, geometry.free, geometry.height);
        let closed = PI * geometry.density * SPEED * SPEED * (r * r * h.powi(3) / 12.0 - h * (r.powi(4) - s.powi(4)) / 4.0);
        assert!(apart(tilt(name, w), c(closed, 0.0)) < 1e-14);
        // and no jump towards it off the real axis
        let near = tilt(name, c(SPEED, 1e-6));
        assert!((near.re - closed).abs() < 1e-6 * closed.abs(), "{near:?} {closed}");
        for w in frequencies() {
            let (up, down) = (tilt(name, w), tilt(name, w.conj()).conj());
            assert!(apart(up, down) < 1e-14, "{name} {w:?}");
            assert!(apart(geometry.planar(w, SPEED), geometry.planar(w.conj(), SPEED).conj()) < 1e-14);
            // real for real w
            assert!(w.im != 0.0 || up.im == 0.0);
        }
    }
}

/// A cavity with a thin air core is close to a full one.
#[test]
fn full_cavity() {
    let full = Cavity { free: 0.0, ..cavity("G1") };
    let core = Cavity { free: 1e-4, ..full };
    for w in [c(-300.0, 0.0), c(3.0 * SPEED, 0.0), c(50.0, 10.0), c(150.0, -10.0)] {
        let (a, b) = (full.tilt(w, SPEED, Truncation::None).value, core.tilt(w, SPEED, Truncation::None).value);
        assert!(apart(b, a) < 2e-5, "{w:?}: {a:?} {b:?}");
        let mass = (w * w).scale(full.full_mass());
        assert!(apart(core.planar(w, SPEED), mass) < 1e-5);
    }
    // at rest relative to the axes, a full cavity without spin takes part in translation as a rigid mass, and less in tilt
    let still = full.tilt(c(0.0, 30.0), 1e-9, Truncation::None).value.re / -900.0;
    let rigid = full.full_mass() * (0.25 * full.radius.powi(2) + full.slices());
    assert!(still > 0.0 && still < rigid, "{still} {rigid}");
}

/// Poles of the harmonics: frequencies of the liquid in a cavity at rest.
#[test]
fn fixed_cavity() {
    let text = include_str!("../reference/spatial/liquid_frequencies_fixed_cavity.csv");
    let mut checked = 0;
    for r in crate::common::rows(text) {
        let (geometry, k) = (cavity(r[0]), r[1].parse::<usize>().unwrap());
        let (w, known) = (SPEED * crate::common::number(r[3]), crate::common::number(r[5]));
        let inverse = |w: f64| {
            let at = |last: usize| geometry.tilt(c(w, 0.0), SPEED, Truncation::At(last)).value.re;
            if k == 0 { geometry.planar(c(w, 0.0), SPEED).re.recip() } else { (at(k) - if k > 1 { at(k - 2) } else { 0.0 }).recip() }
        };
        let (mut a, mut b) = (w * (1.0 + 2e-9), w * (1.0 - 3e-9));
        for _ in 0..40 {
            let (fa, fb) = (inverse(a), inverse(b));
            // no number: at the pole
            if (b - a).abs() < 1e-13 * w.abs() || !fb.is_finite() || fa == fb {
                break;
            }
            (a, b) = (b, b - fb * (b - a) / (fb - fa));
        }
        let tolerance = if known > 1e-6 { known } else { 1e-9 };
        assert!((b / w - 1.0).abs() < tolerance, "{r:?}: {b}");
        checked += 1;
    }
    assert!(checked > 100, "{checked}");
}

/// Frequency, speed and lengths, against central differences.
#[test]
fn derivatives() {
    type D = Dual<f64, 5>;
    for name in ["G1", "G3"] {
        let g = cavity(name);
        for w in [c(-300.0, 0.0), c(600.0, 0.0), c(50.0, 10.0), c(150.0, -10.0), c(-105.0, 0.3)] {
            let seeded = Cavity {
                radius: D::seed(g.radius, 2),
                free: D::seed(g.free, 3),
                height: D::seed(g.height, 4),
                density: D::lift(g.density),
            };
            let exact = seeded.tilt(c(D::seed(w.re, 0), D::lift(w.im)), D::seed(SPEED, 1), Truncation::None).value;
            let sizes = [100.0, SPEED, g.radius, g.free, g.height];
            for (i, size) in sizes.into_iter().enumerate() {
                let at = |x: f64| {
                    let mut v = [w.re, SPEED, g.radius, g.free, g.height];
                    v[i] += x * size;
                    let moved = Cavity { radius: v[2], free: v[3], height: v[4], density: g.density };
                    moved.tilt(c(v[0], w.im), v[1], Truncation::None).value
                };
                let step = 1e-5;
                let difference = ((at(step) - at(-step)).scale(8.0) - (at(2.0 * step) - at(-2.0 * step))).scale(1.0 / (12.0 * step));
                let slope = c(exact.re.eps[i], exact.im.eps[i]).scale(size);
                let room = 1e-7 * (slope.abs() + at(0.0).abs());
                assert!((slope - difference).abs() < room, "{name} {w:?} {i}: {slope:?} {difference:?}");
            }
        }
    }
    // along the line of backward whirl with the speed the reaction is quadratic
    let geometry = cavity("G1");
    let lifted = Cavity {
        radius: Dual::<f64, 1>::lift(geometry.radius),
        free: Dual::lift(geometry.free),
        height: Dual::lift(geometry.height),
        density: Dual::lift(geometry.density),
    };
    let speed = Dual::seed(SPEED, 0);
    let along = lifted.tilt(Complex::real(-speed), speed, Truncation::None).value;
    assert!((along.re.eps[0] / (2.0 * along.re.re / SPEED) - 1.0).abs() < 1e-12);
}

/// At real frequencies among the inertial waves no sum has a meaning, and the estimate says so.
#[test]
fn dense_range() {
    for w in [130.0, 200.0, 0.0, -99.9, 299.0] {
        assert!(cavity("G1").tilt(c(w, 0.0), SPEED, Truncation::None).error.is_infinite(), "{w}");
    }
    for w in [-100.1, 300.1, 100.0, 300.0, -100.0] {
        assert!(cavity("G1").tilt(c(w, 0.0), SPEED, Truncation::None).error < 1e-3, "{w}");
    }
    assert!(tilt("G1", c(f64::NAN, 0.0)).re.is_nan());
}
