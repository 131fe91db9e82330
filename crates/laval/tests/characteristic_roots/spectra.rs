//! Complete spectra.

use super::{FILE, at, build, changed, isotropic, spatial, truncated};
use crate::common::{number, rows};
use laval::solve::pencil::modes_about;
use laval::solve::rest::rest;
use laval::solve::roots::{Area, Request};
use laval_num::complex::{C64, c};
use rayon::prelude::*;

/// With the series cut off alike, every root of the table is found, and the count of every rectangle agrees with what was found.
#[test]
fn roots_of_a_liquid_with_few_harmonics() {
    let table = rows(include_str!("../reference/spatial/eig_full.csv"));
    assert_eq!(table.len(), 223);
    let mut sets: Vec<(&str, &str, &str)> = table.iter().map(|r| (r[0], r[1], r[2])).collect();
    sets.dedup();
    let results: Vec<(f64, u64, usize)> = sets
        .par_iter()
        .map(|&(name, harmonics, speed)| {
            let (last, speed_value) = (harmonics.rsplit('-').next().unwrap().parse().unwrap(), number(speed));
            let text = truncated(FILE, last);
            let system = build(&if name == "S1i" { isotropic(&text) } else { text });
            let own: Vec<_> = table.iter().filter(|r| (r[0], r[1], r[2]) == (name, harmonics, speed)).collect();
            let should: Vec<C64> = own.iter().map(|r| c(-number(r[4]), number(r[3]))).collect();
            let reach = 1.0001 * should.iter().map(|s| s.im.abs()).fold(0.0, f64::max).max(4.05 * speed_value);
            let found = at(&system, speed_value, &Request { frequency: Some(reach), ..Request::default() });
            assert!(found.areas.len() >= 3 && found.areas.iter().all(Area::complete), "{name} {speed}: {:#?}", found.areas);
            // the table leaves out the surroundings of the speed, and of S1 the mirror images
            let inside = |z: &C64| (z.im.abs() - speed_value).abs() > 0.3 * speed_value;
            let signed = |m: &laval::solve::pencil::MachineMode| {
                if m.sector == Some(laval::solve::sectors::Sector::Backward) { m.value.conj() } else { m.value }
            };
            let mut is: Vec<C64> = found.spectrum.modes.iter().map(signed).filter(inside).collect();
            let mut worst = 0.0f64;
            for z in should {
                let near = (0..is.len()).min_by(|&a, &b| (is[a] - z).abs().total_cmp(&(is[b] - z).abs())).unwrap();
                let off = (is.remove(near) - z).abs() / z.abs();
                worst = worst.max(off);
                assert!(off < 2e-9, "{name} {speed}: {z:?} {off:e}");
            }
            println!("{name} {speed}: {} roots more than in the table: {is:?}", is.len());
            (worst, found.evaluations, is.len())
        })
        .collect();
    println!("{} spectra, largest relative deviation {:.1e}", results.len(), results.iter().map(|r| r.0).fold(0.0, f64::max));
    println!("evaluations: {:?}", results.iter().map(|r| r.1).collect::<Vec<_>>());
}

/// On a machine whose roots an eigenvalue problem has, the count and the search find the same ones.
#[test]
fn the_same_roots_as_an_eigenvalue_problem() {
    for text in [FILE.to_string(), isotropic(FILE)] {
        let system = build(&text);
        for speed in [150.0, 400.0] {
            let pencil = modes_about(&system, &rest(&system, speed).unwrap(), true).unwrap();
            let found = at(&system, speed, &Request { frequency: Some(5e3), ..Request::default() });
            assert!(found.areas.iter().all(Area::complete) && found.counted.iter().all(|c| *c), "{:#?}", found.areas);
            assert_eq!(found.spectrum.modes.len(), pencil.modes.len());
            for (a, b) in found.spectrum.modes.iter().zip(&pencil.modes) {
                assert!((a.value - b.value).abs() < 1e-9 * b.value.abs(), "{:?} {:?}", a.value, b.value);
                assert_eq!((a.sector, a.whirl), (b.sector, b.whirl));
            }
        }
    }
}

/// Without starts the search finds what is missing by itself.
#[test]
fn the_converged_liquid_differs_from_few_harmonics() {
    let speed = 300.0;
    let text = isotropic(FILE);
    let request = Request { margin: 0.05, frequency: Some(1200.0), ..Request::default() };
    let whole = at(&build(&spatial(&text)), speed, &request);
    assert!(whole.areas.iter().all(Area::complete), "{:#?}", whole.areas);
    let few = at(&build(&truncated(&text, 3)), speed, &request);
    let strip = at(&build(&changed(&text, &[])), speed, &request);
    // damped modes of the rotor with the liquid: few harmonics are close, slices without axial flow are not
    let nearest =
        |list: &laval::solve::roots::Roots, z: C64| list.spectrum.modes.iter().map(|m| (m.value - z).abs()).fold(f64::INFINITY, f64::min);
    let strong: Vec<C64> =
        whole.spectrum.modes.iter().zip(&whole.counted).filter(|(m, c)| **c && m.value.re.abs() > 0.1).map(|(m, _)| m.value).collect();
    assert!(strong.len() >= 6, "{strong:?}");
    for z in strong {
        println!("{z:?}: k = 1, 3 differs by {:.4} rad/s, strip by {:.4} rad/s", nearest(&few, z), nearest(&strip, z));
        assert!(nearest(&few, z) < 0.02 * z.abs());
    }
}
