//! Shafts of many stations: sparse results against dense ones and closed forms, and how the work grows with the number of stations.

use crate::common::files::{findings, load, run_all};
use crate::common::shaft::{DENSITY, LENGTH, MODULUS, RADIUS, SUPPORT, cubic, cubic_text, isotropic, shaft};
use laval::model::blocks::Grid;
use laval::model::linear::{Form, LinearModel, LinearScratch};
use laval::model::system::System;
use laval::solve::characteristic::{Characteristic, Equilibrium, Frame};
use laval::solve::criticals::criticals;
use laval::solve::harmonic::balance::orbit::Orbit;
use laval::solve::harmonic::balance::problem::Balance;
use laval::solve::harmonic::branches::around::Peaks;
use laval::solve::harmonic::branches::branch::State;
use laval::solve::harmonic::branches::measure::Measure;
use laval::solve::harmonic::branches::peak::{Sense, refine};
use laval::solve::harmonic::branches::response::{Request as Response, respond};
use laval::solve::linear_response::response;
use laval::solve::pencil::Linearised;
use laval::solve::rest::rest;
use laval::solve::roots::{Request, roots};
use laval::solve::sectors::Sector;
use laval::solve::sweep::sweep;
use laval::study::Cancel;
use laval_num::complex::{C64, c};
use laval_num::dense::{Lu, Mat};
use laval_num::work::watched;
use std::f64::consts::PI;
use std::sync::atomic::AtomicBool;

/// Modes of a machine with frequencies up to a limit, and growth of the same size, by its full matrices.
fn dense(system: &System, about: &Equilibrium, limit: f64) -> Vec<C64> {
    let all = Linearised::new(system, about).unwrap().spectrum().unwrap().modes;
    all.iter().map(|m| m.value).filter(|s| s.im <= limit && s.re.abs() <= limit).collect()
}

fn same_values(found: &[C64], all: &[C64], what: &str) {
    assert_eq!(found.len(), all.len(), "{what}: {found:?} {all:?}");
    for s in all {
        let away = found.iter().map(|f| (*f - *s).abs()).fold(f64::INFINITY, f64::min);
        // what an element is stiffer than its supports is lost to rounding, in the full matrices more than here
        assert!(away <= 1e-6 * s.abs(), "{what}: {s:?} is {away:e} away");
    }
}

/// Modes up to a frequency are those of the full matrices, all of them, and the count says so.
#[test]
fn modes_up_to_a_frequency() {
    for (stations, founded) in [(26, false), (41, true), (51, false)] {
        let system = shaft(stations, founded, false);
        for speed in [0.0, 314.0] {
            let about = rest(&system, speed).unwrap();
            for frequency in [None, Some(900.0), Some(9000.0)] {
                let found = roots(&system, &about, &Request { frequency, ..Request::default() }).unwrap();
                let what = format!("{stations} stations at {speed} rad/s up to {frequency:?}");
                assert!(found.areas.iter().all(|a| a.complete()) && !found.areas.is_empty(), "{what}: {:?}", found.areas);
                let modes: Vec<C64> = found.spectrum.modes.iter().map(|m| m.value).collect();
                assert!(frequency.is_some() || modes.len() >= 12, "{what}: {}", modes.len());
                same_values(&modes, &dense(&system, &about, found.frequency), &what);
            }
        }
    }
}

/// A planar body on equal springs beside a long shaft on unequal ones has its forward and its backward mode at one root: both are found and counted, as by the full matrices of a coarser shaft.
#[test]
fn two_modes_at_one_root() {
    let (m, k, damping) = (400.0, 4e8, 5e4);
    let system = |elements: usize| {
        let mut text = format!(
            "[machine]\nname = \"t\"\nspeed = 314\n[[part]]\nkind = \"shaft\"\nname = \"shaft\"\nelements = {elements}\nsection = [{{ length = 0.6, outer_diameter = 0.05 }}]\n"
        );
        for (name, at) in [("left", 0.0), ("right", 0.6)] {
            text += &format!(
                "[[part]]\nkind = \"bearing_linear\"\nname = \"{name}\"\nbetween = [{{ body = \"shaft\", at = {at:?} }}, \"ground\"]\nkxx = 5e7\nkyy = 7e7\ncxx = 5e3\ncyy = 5e3\n"
            );
        }
        text += &format!(
            "[[part]]\nkind = \"disc\"\nname = \"alone\"\nmass = {m:?}\n[[part]]\nkind = \"bearing_linear\"\nname = \"b\"\nbetween = [\"alone\", \"ground\"]\nstiffness = {k:?}\ndamping = {damping:?}\n"
        );
        load(&text).system
    };
    let fine = system(45);
    let about = rest(&fine, 314.0).unwrap();
    let found = roots(&fine, &about, &Request::default()).unwrap();
    assert!(found.areas.iter().all(|a| a.complete()) && !found.areas.is_empty(), "{:?}", found.areas);
    assert!(found.counted.iter().all(|x| *x));
    let root = (c(damping * damping - 4.0 * m * k, 0.0).sqrt() - c(damping, 0.0)).scale(0.5 / m);
    let root = c(root.re, root.im.abs());
    let there: Vec<f64> =
        found.spectrum.modes.iter().filter(|s| (s.value - root).abs() <= 1e-9 * root.abs()).map(|s| s.forward_share).collect();
    assert_eq!(there.len(), 2, "{:?}", found.spectrum.modes.iter().map(|s| s.value).collect::<Vec<_>>());
    assert!((there[0] - 1.0).abs() <= 1e-9 && there[1].abs() <= 1e-9, "{there:?}");
    let coarse = system(12);
    let all = dense(&coarse, &rest(&coarse, 314.0).unwrap(), found.frequency);
    assert_eq!(all.len(), found.spectrum.modes.len());
    // what the coarse shaft resolves
    for s in all.iter().filter(|s| s.abs() <= 3e3) {
        let count = |some: &[C64]| some.iter().filter(|z| (**z - *s).abs() <= 1e-3 * s.abs()).count();
        let modes: Vec<C64> = found.spectrum.modes.iter().map(|m| m.value).collect();
        assert_eq!(count(&modes), count(&all), "{s:?} {modes:?}");
    }
}

/// The same of a machine without preferred direction, whose forward sector is solved by itself, and of one with twice the stiffness in it as a nonlinear part.
#[test]
fn modes_of_isotropic_and_nonlinear_machines() {
    let text = |stations: usize, cubic: bool| {
        let mut text = isotropic(stations);
        if cubic {
            text += "[[part]]\nkind = \"bearing_cubic\"\nname = \"seal\"\nbetween = [\"n5\", \"ground\"]\nlaw = \"isotropic\"\nstiffness = 1e6\ncubic_stiffness = 1e14\n";
        }
        text
    };
    for cubic in [false, true] {
        let system = load(&text(31, cubic)).system;
        let about = rest(&system, 500.0).unwrap();
        let found = roots(&system, &about, &Request::default()).unwrap();
        assert!(found.areas.iter().all(|a| a.complete()) && !found.areas.is_empty(), "{:?}", found.areas);
        assert!(found.spectrum.modes.iter().all(|m| m.sector.is_some()));
        let modes: Vec<C64> = found.spectrum.modes.iter().map(|m| m.value).collect();
        same_values(&modes, &dense(&system, &about, found.frequency), if cubic { "cubic" } else { "isotropic" });
    }
}

/// Branches over the speed are continuous, hold the modes of the full matrices at every speed, and their crossings are critical speeds.
#[test]
fn branches_over_the_speed() {
    for (system, name) in [(shaft(41, true, false), "founded"), (load(&isotropic(41)).system, "isotropic")] {
        let state = |w: f64| rest(&system, w);
        let speeds: Vec<f64> = (0..13).map(|k| 50.0 + 50.0 * f64::from(k)).collect();
        let limit = 1500.0;
        let found = sweep(&system, &state, &speeds, limit, |_, _| true).unwrap();
        assert_eq!((found.points.len(), found.ambiguous.len()), (13, 0), "{name}");
        assert!(found.counts.iter().all(|c| c.complete) && found.counts.len() >= 3, "{name}: {:?}", found.counts);
        for (k, &speed) in speeds.iter().enumerate() {
            let here = found.branches.iter().filter_map(|b| b.points.iter().find(|p| p.0 == speed));
            let modes: Vec<C64> = here.map(|p| p.1.value).collect();
            same_values(&modes, &dense(&system, &state(speed).unwrap(), limit), &format!("{name}: {k}"));
        }
        // no branch has a gap
        for b in &found.branches {
            let places: Vec<usize> = b.points.iter().map(|p| speeds.iter().position(|w| *w == p.0).unwrap()).collect();
            assert!(places.windows(2).all(|w| w[1] == w[0] + 1), "{name}: {places:?}");
        }
        let critical = criticals(&system, &state, &found, &[1.0]);
        assert!(critical.len() >= 2, "{name}: {}", critical.len());
        for c in &critical {
            assert!(c.located(), "{name}: {c:?}");
            let all = dense(&system, &state(c.speed).unwrap(), limit);
            assert!(all.iter().any(|s| (s.im - c.speed).abs() <= 1e-6 * c.speed), "{name}: {} {all:?}", c.speed);
        }
    }
}

/// Forced responses by the sparse factorisation are those of the dense matrix.
#[test]
fn responses_are_those_of_the_dense_matrix() {
    for (stations, founded) in [(3, false), (11, true), (51, false), (51, true)] {
        let system = shaft(stations, founded, false);
        let (mut model, mut scratch, mut grid) = (LinearModel::default(), LinearScratch::default(), Grid::empty());
        for speed in [40.0, 150.0, 400.0, 900.0, 2500.0] {
            let found = response(&system, &|w| rest(&system, w), speed).unwrap().unwrap();
            system.linear(system.params(), speed, Form::Frequency, &mut model, &mut scratch);
            system.dynamic_stiffness(system.params(), &model, Form::Frequency, c(0.0, speed), &mut grid, &mut scratch);
            let n = system.n();
            let z = Mat::from_fn(n, n, |i, j| grid[(i, j)]);
            let mut x: Vec<C64> = (0..n).map(|i| c(model.loads.force_cos[i], -model.loads.force_sin[i])).collect();
            Lu::new(&z).unwrap().solve(&mut x);
            let size = x.iter().map(|x| x.abs()).fold(0.0, f64::max);
            // the stiffness of one element over that of the supports is lost to rounding
            let lost = 1e-15 * 12.0 * MODULUS * 0.25 * PI * RADIUS.powi(4) / (LENGTH / (stations - 1) as f64).powi(3) / SUPPORT;
            let worst = x.iter().zip(&found.x).map(|(a, b)| (*a - *b).abs()).fold(0.0, |m: f64, x| if x > m || x.is_nan() { x } else { m });
            assert!(worst <= (1e-11 + 100.0 * lost) * size, "{stations} stations at {speed}: {:e}", worst / size);
            assert!(found.residual < 1e-9, "{:e}", found.residual);
        }
    }
}

fn units(f: impl FnOnce()) -> u64 {
    let stop = Cancel::default();
    watched(Some(&stop), u64::MAX, f).unwrap();
    stop.spent()
}

/// Twice the stations are twice the work: of responses, of the test function whose zeros are roots, of the modes up to a frequency of following them over the speed, and of whole studies.
#[test]
fn work_grows_with_the_number_of_stations() {
    let spent = |stations: usize| {
        let system = shaft(stations, true, false);
        let responses = units(|| {
            for k in 0..40 {
                response(&system, &|w| rest(&system, w), 100.0 + 20.0 * f64::from(k)).unwrap().unwrap();
            }
        });
        let about = Equilibrium::zero(&system, Frame::Fixed, 300.0);
        let test = units(|| {
            let mut t = Characteristic::new(&system, &about);
            let all: Vec<usize> = (0..t.size()).collect();
            let border = t.border(c(-2.0, 430.0), &all).unwrap();
            for k in 0..10 {
                assert!(t.test(c(-2.0, 430.0 + f64::from(k)), &border).is_some());
            }
        });
        let modes = units(|| {
            let found = roots(&system, &about, &Request { frequency: Some(2000.0), ..Request::default() }).unwrap();
            assert!(found.areas.iter().all(|a| a.complete()));
        });
        let speeds: Vec<f64> = (0..9).map(|k| 100.0 + 50.0 * f64::from(k)).collect();
        let branches = units(|| {
            sweep(&system, &|w| rest(&system, w), &speeds, 1500.0, |_, _| true).unwrap();
        });
        let system = shaft(stations, false, false);
        let n = system.n();
        assert!(system.assembly(Form::Frequency).pattern.entries() <= 12 * n, "{}", system.assembly(Form::Frequency).pattern.entries());
        [responses, test, modes, branches]
    };
    let (short, long) = (spent(60), spent(120));
    let study = |kind: &str, stations: usize| {
        let text = cubic_text(stations) + &format!("[[study]]\nkind = \"{kind}\"\nspeed = {{ from = 150, to = 300 }}\n");
        let loaded = laval::file::load(&text).unwrap();
        units(|| assert!(loaded.studies[0].study.run(&loaded.system, &laval::study::Context::quiet("study")).is_ok()))
    };
    // whole studies: what is measured of every station beside what is solved for
    for kind in ["nonlinear_response", "forced_response"] {
        let (s, l) = (study(kind, 20), study(kind, 40));
        assert!(s > 0 && l as f64 <= 2.5 * s as f64, "{kind}: {s} {l}");
    }
    for (s, l) in short.iter().zip(&long) {
        assert!(*s > 0 && *l as f64 <= 2.5 * *s as f64, "{short:?} {long:?}");
    }
}

/// Bending frequencies of a beam on two springs: zeros of the determinant over `cos, sin, cosh, sinh` of its closed form, without rotary inertia.
#[test]
fn roots_converge_to_the_beam() {
    let (area, second) = (PI * RADIUS.powi(2), 0.25 * PI * RADIUS.powi(4));
    let bending = MODULUS * second;
    // y = A cos + B sin + C cosh + D sinh of b z: no moment at the ends, shear force -k y below, k y above
    let determinant = |w: f64| {
        let b = (DENSITY * area * w * w / bending).powf(0.25);
        let (x, k) = (b * LENGTH, SUPPORT / (bending * b.powi(3)));
        let (co, s, ch, sh) = (x.cos(), x.sin(), x.cosh(), x.sinh());
        let rows = [[-1.0, 0.0, 1.0, 0.0], [-co, -s, ch, sh], [k, -1.0, k, 1.0], [s - k * co, -co - k * s, sh - k * ch, ch - k * sh]];
        Lu::new(&Mat::from_fn(4, 4, |i, j| rows[i][j])).map_or(0.0, |lu| lu.det())
    };
    let mut exact = Vec::new();
    let grid = |k: usize| 20.0 + 2.0 * k as f64;
    for k in 0..1200 {
        let (mut a, mut b) = (grid(k), grid(k + 1));
        if determinant(a) * determinant(b) > 0.0 {
            continue;
        }
        for _ in 0..60 {
            let m = 0.5 * (a + b);
            if determinant(a) * determinant(m) > 0.0 { a = m } else { b = m }
        }
        exact.push(a);
    }
    assert!(exact.len() >= 3, "{exact:?}");
    let errors = |stations: usize| -> Vec<f64> {
        let system = shaft(stations, false, true);
        let about = Equilibrium::zero(&system, Frame::Fixed, 0.0);
        let root = |w: f64| Characteristic::new(&system, &about).polish(c(0.0, w), None).unwrap().value.im;
        exact.iter().take(3).map(|&w| (root(w) / w - 1.0).abs()).collect()
    };
    let (coarse, middle, fine) = (errors(25), errors(49), errors(97));
    for k in 0..3 {
        // masses at the stations: the error falls with the square of their distance
        for ratio in [coarse[k] / middle[k], middle[k] / fine[k]] {
            assert!((3.5..4.5).contains(&ratio), "mode {k}: {coarse:?} {middle:?} {fine:?}");
        }
    }
}

/// The jumps of one rotor do not depend on how many stations it is divided into, but for the error of the elements, and stability is known at every size.
#[test]
fn jumps_converge_with_the_stations() {
    let jumps = |stations: usize, stability: bool| -> Vec<f64> {
        let system = cubic(stations);
        let request = Response { stability, ..Response::over(100.0, 400.0) };
        let found = respond(&system, &request, &AtomicBool::new(false), &|_| {}).unwrap();
        assert!(found.unassessed.is_none(), "{stations} stations: {:?}", found.unassessed);
        let points = found.branches.iter().flat_map(|b| &b.points);
        assert!(!stability || points.clone().all(|p| p.exponents.is_some()), "{stations} stations");
        // between the two jumps the middle state is unstable, and no other
        let mut folds: Vec<f64> = found.branches.iter().flat_map(|b| &b.folds).map(|f| f.speed).collect();
        folds.sort_by(f64::total_cmp);
        if stability {
            let unstable: Vec<f64> = points.filter(|p| !p.exponents.as_ref().unwrap().stable()).map(|p| p.speed).collect();
            assert!(unstable.len() > 3 && unstable.iter().all(|w| (folds[0]..=folds[1]).contains(w)), "{folds:?} {unstable:?}");
        }
        assert_eq!(folds.len(), 2, "{stations} stations: {folds:?}");
        folds
    };
    let found: Vec<Vec<f64>> = [13, 25, 49, 97].map(|k| jumps(k, k == 49)).into();
    for k in 0..2 {
        let steps: Vec<f64> = found.windows(2).map(|w| (w[1][k] - w[0][k]).abs()).collect();
        // masses at the stations: the error falls with the square of their distance
        for ratio in [steps[0] / steps[1], steps[1] / steps[2]] {
            assert!((3.0..5.0).contains(&ratio), "jump {k}: {found:?}");
        }
    }
}

/// Near the fold two exponents are real and small beside what rounds in stiff short elements: they are real to the count too, so that stability is known.
#[test]
fn stability_beside_a_fold_of_a_fine_division() {
    let system = cubic(201);
    let found = respond(&system, &Response::over(242.7, 243.7), &AtomicBool::new(false), &|_| {}).unwrap();
    let points = || found.branches.iter().flat_map(|b| &b.points);
    assert!(found.unassessed.is_none() && points().all(|p| p.exponents.is_some()), "{:?}", found.unassessed);
    let real = |p: &State| p.exponents.iter().flat_map(|e| &e.values).filter(|s| s.im == 0.0 && s.re.abs() < 3.0).count();
    assert!(points().filter(|p| real(p) == 2).count() > 3);
    assert!(points().any(State::stable) && points().any(State::unstable));
}

/// What rounding of the entries of T can move a root by, of two masses on springs: the mode is `x = (1, r)` with `r = 1 - m1 w^2 / k`, both rows of `T x = 0`
/// are differences of two equal sizes, and `eps |x|^T |T| |x| / |x^T T' x| = eps 4 |k - m1 w^2| / (2 w (m1 + m2 r^2))`.
#[test]
fn rounding_moves_a_root_of_two_masses_as_its_closed_form_says() {
    let [m1, m2, k, below] = [2.0, 30.0, 1e6, 4e5];
    let text = format!(
        "[machine]\nname = \"two masses\"\n\
         [[part]]\nkind = \"disc\"\nname = \"upper\"\nmass = {m1}\n\
         [[part]]\nkind = \"foundation\"\nname = \"lower\"\nmass = {m2}\nstiffness = {below}\ndamping = 0\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"between\"\nbetween = [\"upper\", \"lower\"]\nkxx = {k}\nkyy = {k}\n"
    );
    let system = load(&text).system;
    // (k - m1 w^2)(k + below - m2 w^2) = k^2
    let (b, product) = (m1 * (k + below) + m2 * k, k * below);
    for sign in [-1.0, 1.0] {
        let w = f64::sqrt((b + sign * f64::sqrt(b * b - 4.0 * m1 * m2 * product)) / (2.0 * m1 * m2));
        let r = 1.0 - m1 * w * w / k;
        let exact = f64::EPSILON * 4.0 * (k - m1 * w * w).abs() / (2.0 * w * (m1 + m2 * r * r));
        let mut t = Characteristic::new(&system, &Equilibrium::zero(&system, Frame::Fixed, 100.0));
        let root = t.polish(c(0.0, 1.001 * w), Some(Sector::Forward)).unwrap();
        assert!((root.value - c(0.0, w)).abs() < 1e-10 * w, "{:?} {w}", root.value);
        let moved = t.rounding(&root);
        assert!((moved / exact - 1.0).abs() < 1e-6, "{moved:e} {exact:e}");
    }
}

/// Peaks of all probes and forces from motions that they share are those that corrections of their own lead to.
#[test]
fn peaks_that_share_motions_are_those_found_one_by_one() {
    let mut checked = 0;
    for (text, speeds) in
        [(cubic_text(9), (100.0, 400.0)), (cubic_text(5).replace("law = \"isotropic\"", "law = \"per_axis\""), (150.0, 300.0))]
    {
        let system = load(&text).system;
        let request = Response { stability: false, ..Response::over(speeds.0, speeds.1) };
        let found = respond(&system, &request, &AtomicBool::new(false), &|_| {}).unwrap();
        let measures: Vec<Measure> =
            (0..system.probes().len()).map(Measure::Probe).chain(Measure::forces(&system).into_iter().map(Measure::Force)).collect();
        for branch in &found.branches {
            let mut balance = Balance::new(&system, branch.discretisation.whole(), speeds, None).unwrap();
            let mut peaks = Peaks::default();
            let orbits: Vec<Orbit> = branch.points.iter().map(|p| Orbit::of(&mut balance, &p.x, p.speed).unwrap()).collect();
            // every measure of a kind has its like at the next stations
            for &measure in measures.iter().step_by(2) {
                let sizes: Vec<f64> = orbits.iter().map(|o| measure.largest(&system, o, 1).0).collect();
                let most = sizes.iter().fold(0.0f64, |a, b| a.max(*b));
                for i in (1..sizes.len() - 1).filter(|&i| sizes[i] > sizes[i - 1] && sizes[i] > sizes[i + 1] && sizes[i] > 1e-6 * most) {
                    let own = refine(&mut balance, branch, i, measure, Sense::Largest, speeds);
                    let shared = peaks.beside(&mut balance, (branch, i), measure, Sense::Largest, speeds);
                    let (Some(own), Some(shared)) = (own, shared) else { continue };
                    assert!(
                        (shared.value / own.value - 1.0).abs() < 1e-9 && (shared.speed / own.speed - 1.0).abs() < 1e-8,
                        "{measure:?} {own:?} {shared:?}"
                    );
                    let (low, high) = (shared.bracket.0.min(shared.bracket.1), shared.bracket.0.max(shared.bracket.1));
                    assert!((low..=high).contains(&shared.speed) && shared.slope.abs() < 1e-6);
                    checked += 1;
                }
            }
        }
    }
    assert!(checked > 25, "{checked}");
}

/// Without damping no mode grows: roots lie on the axis to rounding, and the map of a long shaft says so. A limit below all modes is no error.
#[test]
fn an_undamped_shaft_is_not_unstable() {
    let text = isotropic(31).replace("cxx = 300.0\ncyy = 300.0", "cxx = 0\ncyy = 0")
        + "[[study]]\nkind = \"stability_map\"\nspeed = { from = \"500 rpm\", to = \"3000 rpm\", points = 6 }\n\
           [[study]]\nkind = \"modes\"\nfrequency_limit = \"0.01 Hz\"\n";
    let outcomes = run_all(&text);
    let [map, modes] = &outcomes[..] else { panic!("{}", outcomes.len()) };
    assert_eq!(findings(map, "all_counted").len(), 1, "{:?}", map.findings);
    assert!(map.findings.iter().all(|f| !f.id.starts_with("unstable") && f.id != "threshold_raised"), "{:?}", map.findings);
    assert!(findings(modes, "stable").is_empty() && findings(modes, "all_modes").len() == 1, "{:?}", modes.findings);
}

/// Shafts that nothing holds: motions as a rigid body are roots at zero, counted; bending is that of the free beam; what lies has no equilibrium, and the message says why.
#[test]
fn a_shaft_that_nothing_holds() {
    let text = |speed: f64, axis: &str, more: &str, study: &str| {
        format!(
            "[machine]\nspeed = {speed}\naxis = \"{axis}\"\n[[part]]\nkind = \"shaft\"\nname = \"shaft\"\nelements = 24\nsection = [{{ length = 1.2, outer_diameter = 0.02 }}]\n{more}\
             [[study]]\nkind = \"{study}\"\n"
        )
    };
    // two displacements with their rates; two tilts, with their rates where the shaft does not turn, else tied by the gyroscopic moment: of a slender shaft a slow
    // nutation at W Ip/Id. Of x + i y half of them
    for (speed, more, roots) in [(0.0, "", 4), (300.0, "", 4), (0.0, "stiffness_damping = 1e-6\n", 4)] {
        let loaded = laval::file::load(&text(speed, "vertical", more, "modes")).unwrap();
        let about = rest(&loaded.system, speed).unwrap();
        let found = laval::solve::roots::roots(&loaded.system, &about, &Request::default()).unwrap();
        assert!(found.areas.iter().all(|a| a.complete()), "{speed} {more}: {:?}", found.areas);
        let values = found.spectrum.modes.iter().map(|m| m.value.abs());
        let (small, lowest) = values.fold((0, f64::INFINITY), |(n, low), x| if x < 0.2 { (n + 1, low) } else { (n, low.min(x)) });
        // together or one by one
        assert_eq!(found.at_zero.map_or(0, |a| a.count) + small, roots, "{speed} {more}: {:?}", found.at_zero);
        // (4.730/L)^2 sqrt(E I/(rho A)), lower by shear and rotary inertia
        if speed == 0.0 {
            let beam = (4.730_040_744_862_7_f64 / 1.2).powi(2) * (2.11e11_f64 / 7810.0).sqrt() * 0.005;
            assert!(lowest < beam && lowest > 0.99 * beam, "{lowest} {beam}");
        }
        let outcome = loaded.studies[0].study.run(&loaded.system, &laval::study::Context::quiet("modes")).unwrap();
        let said = |id: &str| findings(&outcome, id).iter().map(|f| f.sentence()).collect::<Vec<_>>().join(" ");
        assert_eq!(said("rigid_body_motions").contains("at zero"), found.at_zero.is_some());
        assert!(found.at_zero.is_none() || said("stable").contains("no stiffness holds the machine"), "{}", said("stable"));
        assert!(said("stable").contains("Marginally stable") && said("stability_unknown").is_empty(), "{speed}: {}", said("stable"));
    }
    let lying = laval::file::load(&text(300.0, "horizontal", "", "static")).unwrap();
    for d in [
        rest(&lying.system, 300.0).err().unwrap(),
        lying.studies[0].study.run(&lying.system, &laval::study::Context::quiet("static")).err().unwrap(),
    ] {
        assert!(d.message.to_string().contains("not held by any stiffness"), "{}", d.message);
    }
}
