//! Machine S1 from its file: spectra, response, bands of instability.

use crate::common::{number, rows};
use laval::file::load;
use laval::model::field::RangeValue;
use laval::model::linear::{Form, LinearModel, LinearScratch};
use laval::model::system::System;
use laval::outcome::Outcome;
use laval::solve::characteristic::Characteristic;
use laval::solve::linear_response::response;
use laval::solve::pencil::modes_about;
use laval::solve::rest::rest;
use laval::solve::stability::row;
use laval::study::Context;
use laval_num::complex::{C64, c};
use rayon::prelude::*;
use std::f64::consts::PI;

pub(super) const FILE: &str = include_str!("../reference/spatial/s1.toml");

pub(super) fn build(text: &str) -> System {
    load(text).unwrap_or_else(|d| panic!("{text}\n{d:?}")).system
}

/// The file with pieces of its text replaced; every piece must be there.
pub(super) fn changed(text: &str, pieces: &[(&str, &str)]) -> String {
    pieces.iter().fold(text.to_string(), |text, (old, new)| {
        assert!(text.contains(old), "{old}");
        text.replace(old, new)
    })
}

/// S1, or S1i with the values of x in y as well.
fn set(name: &str) -> String {
    if name.starts_with("S1i") { changed(FILE, &[("4e6 N/m", "3e6 N/m"), ("1.2e7 N/m", "2e7 N/m")]) } else { FILE.to_string() }
}

/// Without the blocks of these names.
pub(super) fn without(text: &str, names: &[&str]) -> String {
    let parts = text.split("\n[[").filter(|block| !names.iter().any(|n| block.contains(&format!("name = \"{n}\""))));
    parts.collect::<Vec<_>>().join("\n[[")
}

pub(super) fn model(text: &str, word: &str) -> String {
    if word == "none" { without(text, &["water"]) } else { changed(text, &[("model = \"strip\"", &format!("model = \"{word}\""))]) }
}

fn eigenvalues(system: &System, speed: f64) -> Vec<C64> {
    modes_about(system, &rest(system, speed).unwrap(), true).unwrap().modes.iter().map(|m| m.value).collect()
}

#[test]
fn spectra() {
    let table = rows(include_str!("../reference/spatial/eig_planar.csv"));
    let mut worst = 0.0f64;
    let mut start = 0;
    let mut sets = 0;
    while start < table.len() {
        let key = |r: &[&str]| (r[0].to_string(), r[1].to_string(), r[2].to_string());
        let end = start + table[start..].iter().take_while(|r| key(r) == key(&table[start])).count();
        let [name, word, speed] = [table[start][0], table[start][1], table[start][2]];
        let word = if word == "planar" { "planar_tilt" } else { word };
        let mut found = eigenvalues(&build(&model(&set(name), word)), number(speed));
        assert_eq!(found.len(), end - start, "{name} {word} {speed}");
        for r in &table[start..end] {
            // s = i w
            let should = c(-number(r[4]), number(r[3]));
            let near = (0..found.len()).min_by(|&a, &b| (found[a] - should).abs().total_cmp(&(found[b] - should).abs())).unwrap();
            let is = found.remove(near);
            worst = worst.max((is - should).abs() / should.abs());
            assert!((is - should).abs() < 1e-9 * should.abs(), "{r:?}: {is:?}");
        }
        (start, sets) = (end, sets + 1);
    }
    println!("{sets} spectra, largest relative deviation {worst:.1e}");
    assert_eq!(sets, 72);
}

/// The cavity turns with the rotor and has its skew tau about the reference point, in the tables: its middle is off the shaft by `-i z tau`.
#[test]
fn forced_response() {
    let cavity =
        format!("skew = 2e-4\nskew_phase = {:e}\neccentricity = {:e}\neccentricity_phase = {:e}", PI / 3.0, 0.04 * 2e-4, -PI / 6.0);
    let mut worst = 0.0f64;
    let table = rows(include_str!("../reference/spatial/forced_S1.csv"));
    assert_eq!(table.len(), 108);
    for r in &table {
        let word = match r[0] {
            "full" => "spatial",
            other => other,
        };
        let text = model(FILE, word);
        let text = if word == "none" { text } else { changed(&text, &[("density = \"1000", &format!("{cavity}\ndensity = \"1000"))]) };
        let system = build(&text);
        let speed = number(r[1]);
        let found = response(&system, &|w| rest(&system, w), speed).unwrap().unwrap();
        assert!(found.residual < 1e-12);
        for i in 0..3 {
            let (forward, backward) = found.circles(2 * i);
            let at = 2 + 4 * i;
            let (f, b) = (c(number(r[at]), number(r[at + 1])), c(number(r[at + 2]), number(r[at + 3])));
            let size = f.abs() + b.abs();
            let off = ((forward - f).abs() + (backward - b).abs()) / size;
            worst = worst.max(off);
            assert!(off < 1e-8, "{} {speed} {i}: {forward:?} {f:?} {backward:?} {b:?}", r[0]);
        }
    }
    println!("largest relative deviation {worst:.1e}");
}

#[test]
fn bands_of_instability() {
    let table = rows(include_str!("../reference/spatial/band_edges_S1_strip.csv"));
    assert_eq!(table.len(), 140);
    let wrong: Vec<String> = table
        .par_iter()
        .flat_map(|r| {
            let (name, threshold) = (r[0], number(r[1]));
            let free = format!("free_surface_radius = \"{} mm\"", 150.0 * number(r[2]));
            let mut text = changed(&set(name), &[("free_surface_radius = \"105 mm\"", &free)]);
            if name.ends_with("undamped") {
                text = changed(&without(&text, &["air", "material"]), &[("damping = \"3000 N s/m\"", "damping = 0")]);
            }
            text = if r[3] == "rigid" {
                changed(&without(&text, &["base"]), &[("[\"rotor\", \"base\"]", "[\"rotor\", \"ground\"]")])
            } else {
                changed(&text, &[("mass = \"250 kg\"", &format!("mass = \"{} kg\"", r[3]))])
            };
            let system = build(&text);
            let speeds = RangeValue { from: 20.0, to: 1000.0, points: Some(491) }.linspace(491);
            let found = row(&system, &|w| rest(&system, w), &speeds, threshold, |_| true).unwrap();
            let should: Vec<f64> = r[4].split_whitespace().map(number).collect();
            let edges: Vec<f64> = found.edges.iter().map(|e| e.speed).collect();
            let mut wrong = Vec::new();
            for e in &should {
                if !edges.iter().any(|f| (f - e).abs() < 1e-6 * e) {
                    wrong.push(format!("{r:?}: {e} is not among {edges:?}"));
                }
            }
            // bands narrower than the step of the table may be missing from it
            if edges.len() < should.len() || !(edges.len() - should.len()).is_multiple_of(2) {
                wrong.push(format!("{r:?}: {} edges for {}", edges.len(), should.len()));
            }
            let peak = found.samples.iter().map(|s| s.value.re).fold(0.0, f64::max);
            if !(peak > 0.98 * number(r[5])) {
                wrong.push(format!("{r:?}: largest growth {peak}"));
            }
            wrong
        })
        .collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// The part's reaction at a height of the rotor is the cavity's about another point, in fixed axes.
#[test]
fn any_reference_point() {
    let (speed, w) = (100.0, c(-130.0, 7.0));
    let s = w.mul_i();
    let matrix = |text: &str| {
        let system = build(text);
        let (mut model, mut scratch, mut grid) = (LinearModel::default(), LinearScratch::default(), laval::model::blocks::Grid::empty());
        system.linear(system.params(), speed, Form::Frequency, &mut model, &mut scratch);
        system.dynamic_stiffness(system.params(), &model, Form::Frequency, s, &mut grid, &mut scratch);
        // forward coordinates: x + i y for (1, -i)
        let forward = |i: usize, j: usize| grid[(i, j)] - grid[(i, j + 1)].mul_i();
        [forward(0, 0), forward(0, 2), forward(2, 0), forward(2, 2)]
    };
    let dry = matrix(&model(FILE, "none"));
    let cavity = laval::cavity::Cavity { radius: 0.15, free: 0.105, height: 0.3, density: 1000.0 };
    let z = 0.04;
    for (word, nu) in [("spatial", 0.0), ("spatial", 1e-4), ("strip", 1e-4)] {
        let text = changed(&model(FILE, word), &[("density = \"1000", &format!("viscosity = {nu}\ndensity = \"1000"))]);
        let wet = matrix(&text);
        let l0 = if nu > 0.0 { cavity.planar_viscous(w, speed, nu) } else { cavity.planar(w, speed) };
        let lt = match (word, nu > 0.0) {
            ("strip", _) => l0.scale(0.0075),
            (_, true) => cavity.tilt_viscous(w, speed, nu, laval::cavity::Truncation::None).value,
            _ => cavity.tilt(w, speed, laval::cavity::Truncation::None).value,
        };
        let reaction = [l0, -l0.mul_i().scale(z), l0.mul_i().scale(z), l0.scale(z * z) + lt];
        for i in 0..4 {
            let is = dry[i] - wet[i];
            assert!((is - reaction[i]).abs() < 1e-11 * (dry[i].abs() + reaction[i].abs()), "{word} {nu} {i}: {is:?} {:?}", reaction[i]);
        }
    }
}

fn run(text: &str) -> Vec<Result<Outcome, String>> {
    let machine = load(text).unwrap_or_else(|d| panic!("{text}\n{d:?}"));
    let run = |s: &laval::file::NamedStudy| s.study.run(&machine.system, &Context::quiet("study")).map_err(|d| d.to_string());
    machine.studies.iter().map(run).collect()
}

/// The file runs as it stands, and with a viscous liquid, whose roots are counted.
#[test]
fn studies_of_the_file() {
    assert!(run(FILE).iter().all(Result::is_ok));
    let text = changed(FILE, &[("density = \"1000", "viscosity = 1e-5\ndensity = \"1000"), ("points = 120 }", "points = 3 }")]);
    let reported = run(&text);
    let ids = |k: usize| -> Vec<&str> { reported[k].as_ref().unwrap().findings.iter().map(|f| f.id.as_str()).collect() };
    assert!(ids(0).contains(&"all_roots") && ids(2).contains(&"all_counted"), "{:?} {:?}", ids(0), ids(2));
    assert!(reported[1].is_ok());
}

/// Where the reaction of a liquid cannot be had to a millionth nothing is said to grow without bound.
#[test]
fn a_response_that_is_not_known_is_reported() {
    let text = changed(&model(FILE, "spatial"), &[("density = \"1000", "viscosity = 1e-9\ndensity = \"1000")]);
    let blocks = text.split("\n[[").filter(|b| !b.contains("kind = \"modes\"") && !b.contains("kind = \"stability_map\""));
    let reported = run(&changed(&blocks.collect::<Vec<_>>().join("\n[["), &[("points = 100 }", "points = 9 }")])).remove(0).unwrap();
    let ids: Vec<&str> = reported.findings.iter().map(|f| f.id.as_str()).collect();
    assert!(ids.contains(&"response_unknown") && !ids.contains(&"undamped_resonance"), "{ids:?}");
    let system = build(&text);
    let finite = |w: f64| laval::solve::linear_response::is_known(&system, &|w| rest(&system, w), w).unwrap();
    assert_eq!(finite(240.0), response(&system, &|w| rest(&system, w), 240.0).unwrap().is_some());
}

/// A viscous liquid, of which little is left at small viscosity, gives almost the response of the ideal one.
#[test]
fn viscosity_in_the_response() {
    let amplitude = |text: &str| {
        let system = build(text);
        response(&system, &|w| rest(&system, w), 240.0).unwrap().unwrap().circles(0)
    };
    let ideal = amplitude(&model(FILE, "spatial"));
    let viscous =
        |nu: &str| amplitude(&changed(&model(FILE, "spatial"), &[("density = \"1000", &format!("viscosity = {nu}\ndensity = \"1000"))]));
    let (more, less) = (viscous("1e-5"), viscous("1e-7"));
    // forward whirl at the speed of the rotor does not move the liquid against the wall
    assert!((more.0 - ideal.0).abs() < 1e-3 * ideal.0.abs());
    let ratio = (more.1 - ideal.1).abs() / (less.1 - ideal.1).abs();
    assert!((5.0..20.0).contains(&ratio), "{ratio}");
}

/// A viscous liquid in plane flow of every slice has no eigenvalue problem of finite size; roots of its characteristic function are polished all the same.
#[test]
fn strongest_root_with_viscosity() {
    let table = rows(include_str!("../reference/spatial/viscous_S1_stability.csv"));
    assert_eq!(table.len(), 126);
    for r in table {
        let free = format!("free_surface_radius = \"{} mm\"", 150.0 * number(r[0]));
        let liquid = format!("viscosity = {}\ndensity = \"1000", r[1]);
        let system = build(&changed(FILE, &[("free_surface_radius = \"105 mm\"", &free), ("density = \"1000", &liquid)]));
        let mut t = Characteristic::new(&system, &rest(&system, number(r[2])).unwrap());
        let should = c(number(r[4]), number(r[5]));
        let found = t.polish(should + c(-0.02, 0.03), None).unwrap();
        // growth to six digits, frequency to eight
        let (growth, frequency) = ((found.value.re - should.re).abs(), (found.value.im - should.im).abs());
        assert!(growth < 2e-6 * should.re.abs() + 1e-8 && frequency < 1e-7 * should.im, "{r:?}: {:?}", found.value);
        assert!(found.defect < 1e-13, "{r:?}: {:e}", found.defect);
    }
}
