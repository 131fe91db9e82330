//! Complete spectra.

use super::{FILE, at, build, isotropic, spatial, truncated};
use crate::common::{number, rows};
use laval::solve::characteristic::Characteristic;
use laval::solve::pencil::modes_about;
use laval::solve::rest::rest;
use laval::solve::roots::{Area, Request};
use laval::solve::sectors::Sector;
use laval_num::complex::{C64, c};
use rayon::prelude::*;

/// With the series cut off alike, every root of the table is found, and the count of every rectangle agrees with what was found.
#[test]
fn roots_of_a_liquid_with_few_harmonics() {
    let table = rows(include_str!("../reference/spatial/eig_full.csv"));
    assert_eq!(table.len(), 222);
    let mut sets: Vec<(&str, &str, &str)> = table.iter().map(|r| (r[0], r[1], r[2])).collect();
    sets.dedup();
    assert_eq!(sets.len(), 12);
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

/// With all harmonics a root of the tables moves by an amount that is shown; harmonics up to 41 leave less than a twentieth of it. Roots beside inertial waves of higher harmonics
/// come near their place only when those are there.
#[test]
fn few_harmonics_and_all() {
    let table = rows(include_str!("../reference/spatial/eig_full.csv"));
    let polish = |text: &str, speed: f64, start: C64, sector| {
        let system = build(text);
        let about = rest(&system, speed).unwrap();
        Characteristic::new(&system, &about).polish(start, sector).map(|p| p.value)
    };
    let moved: Vec<(f64, f64, f64)> = table
        .par_iter()
        .filter_map(|r| {
            let last: usize = r[1].rsplit('-').next().unwrap().parse().unwrap();
            let (speed, should) = (number(r[2]), c(-number(r[4]), number(r[3])));
            let (set, sector) = match r[0] {
                "S1i" => (isotropic(FILE), Some(Sector::Forward)),
                _ => (FILE.to_string(), None),
            };
            let off = |last: usize| polish(&truncated(&set, last), speed, should + c(1e-4, 1e-4), sector);
            // of a root that decays or grows too slowly the whole series has no value
            if r[0] != "S1" || should.re.abs() < 0.3 {
                return None;
            }
            let same = off(last).unwrap();
            assert!((same - should).abs() < 2e-9 * should.abs(), "{r:?}: {same:?}");
            let whole = polish(&spatial(&set), speed, should, sector)?;
            let left = [3, 9, 41].map(|last| off(last).map_or(f64::NAN, |z| (z - whole).abs()));
            // followed to another root
            (left[0] < 0.02 * should.abs()).then(|| {
                println!("S1 at {speed}: {should:?} with k = 1, 3 moves by {:.2e} with all harmonics to {whole:?}, k <= 9 {:.1e}, k <= 41 {:.1e}", left[0], left[1], left[2]);
                (left[0], left[1], left[2])
            })
        })
        .collect();
    assert!(moved.len() >= 20, "{}", moved.len());
    let largest = |k: usize| moved.iter().map(|m| [m.0, m.1, m.2][k]).fold(0.0, f64::max);
    println!("largest: {:e} {:e} {:e}", largest(0), largest(1), largest(2));
    assert!(largest(0) > 1e-3 && largest(2) < 0.05 * largest(0), "{:e} {:e} {:e}", largest(0), largest(1), largest(2));
}

/// A rotor that turns the other way has the same roots, the strip beside the place where waves accumulate included.
#[test]
fn the_other_way_round() {
    let values = |text: &str, speed: f64| {
        let found = at(&build(text), speed, &Request::default());
        assert!(found.areas.iter().all(Area::complete), "{speed}: {:?}", found.areas);
        let mut out: Vec<(f64, f64)> = found.spectrum.modes.iter().map(|m| (m.value.im.abs(), m.value.re)).collect();
        out.sort_by(|a, b| a.0.total_cmp(&b.0));
        out
    };
    for text in [truncated(FILE, 3), isotropic(&truncated(FILE, 3))] {
        let (one, other) = (values(&text, 200.0), values(&text, -200.0));
        assert_eq!(one.len(), other.len());
        for (a, b) in one.iter().zip(&other) {
            assert!((a.0 - b.0).hypot(a.1 - b.1) < 1e-9 * a.0.max(1.0), "{a:?} {b:?}");
        }
    }
}

/// A root 1.6e-7 rad/s from the pole of its wave: Newton's method does not see it from where steps of a pole and a zero do.
#[test]
fn a_root_beside_a_pole() {
    let system = build(&isotropic(&truncated(FILE, 5)));
    let mut t = Characteristic::new(&system, &rest(&system, 100.0).unwrap());
    let root = c(8.06e-10, 85.0434732733544);
    for d in [c(8e-6, 0.0), c(-8e-6, 0.0), c(0.0, 8e-6), c(0.0, -8e-6)] {
        let found = t.polish_beside_pole(root + d, Some(Sector::Forward)).unwrap();
        assert!((found.value - root).abs() < 1e-10 && found.defect < 1e-12, "{d:?}: {:?} {:e}", found.value, found.defect);
        let newton = t.polish(root + d, Some(Sector::Forward));
        assert!(newton.is_none_or(|p| (p.value - root).abs() > 1e-3), "{d:?}");
    }
}
