//! Bands of instability over the speed.

use super::{FILE, at, build, changed, filled, isotropic, spatial, truncated, viscous, without};
use crate::common::{number, rows};
use laval::model::field::RangeValue;
use laval::solve::counted::row;
use laval::solve::pencil::modes_about;
use laval::solve::rest::rest;
use laval::solve::roots::{LEAST, Request};
use laval::solve::stability::row as undamped_row;
use rayon::prelude::*;
use std::sync::atomic::AtomicBool;

/// Edges on a blocked foundation, by fill: roots of the 2 x 2 determinant of
/// `docs/theory/linear-vibration.md#rotor-with-tilt-on-anisotropic-supports` with Bessel functions of another library, the speed found by a secant.
/// Those of the table differ from them by up to 0.0206 rad/s to either side; no mass of the foundation explains that (a heavy one moves all edges up).
const BLOCKED: [(f64, &[f64]); 4] = [
    (0.5, &[313.926070, 469.874496]),
    (0.7, &[283.259011, 493.056186]),
    (0.8, &[266.837255, 495.096138, 723.955870, 866.125810]),
    (0.9, &[248.874961, 476.049871, 516.538047, 593.041421]),
];

#[test]
fn bands_of_a_liquid_with_two_harmonics() {
    let table = rows(include_str!("../reference/spatial/band_edges_S1i_full.csv"));
    assert_eq!(table.len(), 12);
    let wrong: Vec<String> = table
        .par_iter()
        .flat_map(|r| {
            // the name of the model holds a comma
            let r: Vec<&str> = r.to_vec();
            let at = r.iter().position(|x| x.parse::<f64>().is_ok()).unwrap();
            let r = &r[at..];
            let text = truncated(&filled(&isotropic(FILE), number(r[0])), 3);
            let text = if r[1] == "rigid" {
                changed(&without(&text, "base"), &[("[\"rotor\", \"base\"]", "[\"rotor\", \"ground\"]")])
            } else {
                changed(&text, &[("mass = \"250 kg\"", &format!("mass = \"{} kg\"", r[1]))])
            };
            let system = build(&text);
            let speeds = RangeValue { from: 60.0, to: 1000.0, points: Some(95) }.linspace(95);
            let found = row(&system, &|w| rest(&system, w), &speeds, 1.0, (Some(1500.0), &AtomicBool::new(false), true), |_| true).unwrap();
            let edges: Vec<f64> = found.edges.iter().map(|e| e.speed).collect();
            let should: Vec<f64> = r[2].split_whitespace().map(number).collect();
            let mut wrong = Vec::new();
            let blocked = BLOCKED.iter().find(|b| r[1] == "rigid" && b.0 == number(r[0])).map(|b| b.1);
            let off = |to: &[f64], room: f64| edges.len() != to.len() || edges.iter().zip(to).any(|(a, b)| !((a - b).abs() <= room));
            if blocked.is_some_and(|b| off(b, 2e-6)) {
                wrong.push(format!("{r:?}: {edges:?} {blocked:?}"));
            }
            let uncounted = found.samples.iter().filter(|s| s.growing.is_none()).count();
            if uncounted > 0 || off(&should, if blocked.is_some() { 0.021 } else { 1e-4 }) {
                wrong.push(format!("{r:?}: {edges:?}, {uncounted} not counted"));
            }
            let peak = found.samples.iter().map(|s| s.value.re).fold(0.0, f64::max);
            if (peak - number(r[3])).abs() > 1e-4 * peak {
                wrong.push(format!("{r:?}: largest growth {peak}"));
            }
            wrong
        })
        .collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// Where the rotor meets an inertial wave: the strongest root, found without a start beside it.
#[test]
fn band_of_the_inertial_wave() {
    let table = rows(include_str!("../reference/spatial/inertial_band.csv"));
    assert_eq!(table.len(), 8);
    table.par_iter().for_each(|r| {
        let nu = number(r[2]);
        let text = filled(&isotropic(FILE), number(r[0]));
        let text = if nu > 0.0 { viscous(&truncated(&text, 9), r[2]) } else { spatial(&text) };
        let found = at(&build(&text), number(r[1]), &Request { margin: 1.0, growing: true, frequency: Some(1500.0), ..Request::default() });
        assert!(found.growing().is_some(), "{r:?}: {:?}", found.areas);
        let best = found.spectrum.least_stable().unwrap().value;
        let (growth, frequency) = (best.re + number(r[4]), best.im - number(r[3]));
        // the table says how good it is; its ideal rows have harmonics up to 41, which is converged to that
        let room = if nu > 0.0 { 2e-2 } else { 1e-5 };
        assert!(growth.abs() < room && frequency.abs() < room, "{r:?}: {best:?}");
    });
}

/// The largest growth inside the bands of a machine without damping, wherever the speeds of the grid lie, against a fine scan of the roots.
#[test]
fn the_largest_growth_of_a_band_is_found_between_the_speeds_of_any_grid() {
    let still = |text: &str| changed(&without(&without(text, "air"), "material"), &[("damping = \"3000 N s/m\"", "damping = 0")]);
    for (text, bands) in [
        (still(&isotropic(FILE)), vec![(129.777, 166.257), (330.898, 531.833)]),
        (changed(&still(&isotropic(FILE)), &[("mass = \"250 kg\"", "mass = \"100 kg\"")]), vec![(163.889, 237.458), (412.430, 604.938)]),
    ] {
        let system = build(&text);
        let state = |w: f64| rest(&system, w);
        let growth = |w: f64| modes_about(&system, &state(w).unwrap(), false).unwrap().least_stable().unwrap().value.re;
        for (from, to) in bands {
            let scan: Vec<(f64, f64)> = (0..400).map(|k| from + (to - from) * f64::from(k) / 400.0).map(|w| (w, growth(w))).collect();
            let top = scan.iter().copied().max_by(|a, b| a.1.total_cmp(&b.1)).unwrap();
            for points in [3, 4, 5, 7, 10, 16, 33] {
                let speeds = RangeValue { from: from - 7.0, to: to + 9.0, points: Some(points) }.linspace(points);
                let found = undamped_row(&system, &state, &speeds, 0.0, |_| true).unwrap();
                let best = found.peaks.iter().max_by(|a, b| a.value.re.total_cmp(&b.value.re));
                let best = best.unwrap_or_else(|| panic!("{points} {from}: {:?}", found.edges));
                // no less than the scan, and no more than the curve
                assert!(best.value.re >= top.1 * (1.0 - 1e-9), "{points} {from}: {best:?} {top:?}");
                assert!((best.speed - top.0).abs() <= 1.01 * (to - from) / 400.0, "{points} {from}: {best:?} {top:?}");
                assert!((growth(best.speed) / best.value.re - 1.0).abs() < 1e-9, "{points} {from}: {best:?}");
                assert!(best.bracket.0 <= best.speed && best.speed <= best.bracket.1);
            }
        }
    }
}

/// A thin layer on unequal supports: the root that grows beside the place where the waves of a truncated series accumulate is counted at every speed. The pole that the product
/// of their determinants has there stands beside it, on the other side of the edge.
#[test]
fn growth_beside_accumulating_waves_is_counted() {
    let support = |at: &str, x: &str, y: &str| {
        format!(
            "[[part]]\nkind = \"shaft_lumped\"\nbetween = [{{ body = \"r\", at = \"{at} mm\" }}, \"ground\"]\nstiffness = {{ x = \"{x} N/m\", y = \"{y} N/m\" }}\n"
        )
    };
    let text = |free: f64| {
        format!(
            "[machine]\nname = \"thin\"\nspeed = 170\n[[part]]\nkind = \"disc\"\nname = \"r\"\nmass = 25\ndiametral_inertia = 0.5\npolar_inertia = 0.4\n{}{}\
             [[part]]\nkind = \"damper\"\nbetween = [\"r\", \"ground\"]\ndamping = 120\ntilt_damping = 2\n\
             [[part]]\nkind = \"liquid\"\nin = {{ body = \"r\", at = \"-70 mm\" }}\nmodel = \"spatial\"\naxial_harmonics = 3\ncavity_radius = 0.16\ncavity_height = 0.3\n\
             density = 1000\nfill = {{ free_surface_radius = {free} }}\n",
            support("-150", "6e5", "7e5"),
            support("120", "6e5", "9e5"),
        )
    };
    let wrong: Vec<String> = [0.1575, 0.158]
        .par_iter()
        .flat_map(|free| (0..52).into_par_iter().map(move |k| (*free, 152.2 + 0.5 * f64::from(k))))
        .filter_map(|(free, speed)| {
            let system = build(&text(free));
            // a threshold of a thousandth of the speed: roots near it lie in the band in which slow ones are not counted
            let counts = [true, false].map(|growing| {
                let found = at(&system, speed, &Request { margin: LEAST * speed, growing, ..Request::default() });
                let best = found.spectrum.least_stable().map_or(f64::NAN, |m| m.value.re);
                (found.growing(), best)
            });
            let right =
                |&(n, best): &(Option<usize>, f64)| n == Some(1) && best > LEAST * speed && (best - counts[0].1).abs() < 1e-9 * speed;
            (!counts.iter().all(right)).then(|| format!("{free} {speed}: {counts:?}"))
        })
        .collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// Many waves on the axis: which of them is which cannot always be determined, what grows beside them can, in a spectrum and by itself.
#[test]
fn growth_beside_many_waves_is_proven() {
    let wrong: Vec<String> = [(9, 0.66, 90.0), (9, 0.13, -470.0), (19, 0.66, -470.0), (19, 0.99, 90.0)]
        .into_par_iter()
        .filter_map(|(last, fill, speed)| {
            let system = build(&truncated(&filled(FILE, fill), last));
            let counts = [true, false].map(|growing| {
                let found = at(&system, speed, &Request { margin: LEAST * speed.abs(), growing, ..Request::default() });
                let mut values: Vec<f64> = found.spectrum.modes.iter().map(|m| m.value.re).filter(|g| *g > LEAST * speed.abs()).collect();
                values.sort_by(f64::total_cmp);
                (found.growing(), values)
            });
            let [(alone, first), (beside, second)] = &counts;
            // the machine is its own mirror image but for the direction of its spin
            let mirror = at(&system, -speed, &Request { margin: LEAST * speed.abs(), growing: true, ..Request::default() }).growing();
            let same = first.len() == second.len() && first.iter().zip(second).all(|(a, b)| (a - b).abs() < 1e-9 * speed.abs());
            (alone.is_none() || alone != beside || mirror != *alone || *alone != Some(first.len()) || !same)
                .then(|| format!("{last} {fill} {speed}: {counts:?}"))
        })
        .collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}
