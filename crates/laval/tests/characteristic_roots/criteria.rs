//! What "unstable" means in a stability map, in numbers and in words.

use super::viscous::machine;
use super::{FILE, changed};
use crate::common::{number, rows};
use laval::file::load;
use laval::outcome::Outcome;
use laval::study::Context;

fn study(criterion: &str, from: f64, to: f64, points: usize) -> String {
    format!(
        "\n[[study]]\nkind = \"stability_map\"\ncriterion = \"{criterion}\"\nspeed = {{ from = \"{from} rad/s\", to = \"{to} rad/s\", points = {points} }}\n"
    )
}

fn run(text: &str) -> Result<Outcome, String> {
    let machine = load(text).map_err(|d| format!("{d:?}"))?;
    machine.studies[0]
        .study
        .run(&machine.system, &Context::quiet("map"))
        .map_err(|d| format!("{} {}", d.message, d.help.map_or_else(String::new, |h| h.to_string())))
}

fn words(o: &Outcome) -> String {
    o.findings.iter().find(|f| f.id == "criterion").map_or(String::new(), |f| f.sentence())
}

/// Flutter: edges of the undamped rotor to the digits of its discriminant; refused where something damps.
#[test]
fn flutter() {
    let out = run(&format!("{}{}", machine(0.0, 0.0, 0.5, 0.7), study("flutter", 40.0, 300.0, 80))).unwrap();
    assert!(words(&out).contains("flutter, two frequencies of the undamped machine coincide"), "{:?}", out.findings);
    let table = out.tables.iter().find(|t| t.name() == "boundary").unwrap();
    let edges: Vec<f64> = (0..table.rows()).map(|i| table.column("speed").unwrap().number(i).unwrap()).collect();
    let should = [102.744370186736, 170.445983733862];
    assert!(edges.len() == 2 && edges.iter().zip(should).all(|(a, b)| (a - b).abs() < 1e-9), "{edges:?}");
    let damped = run(&format!("{}{}", machine(0.05, 0.0, 0.5, 0.7), study("flutter", 40.0, 300.0, 8))).unwrap_err();
    assert!(damped.contains("flutter is for machines that nothing damps or drives") && damped.contains("growth_threshold"), "{damped}");
    let s1 = FILE.split("\n[[study]]").next().unwrap();
    assert!(run(&format!("{s1}{}", study("flutter", 40.0, 300.0, 8))).is_err());
}

/// Growth with viscosity: exactly at the speeds of the table's counts; bands of section 10 where something damps, everything above the filled critical speed where nothing does.
#[test]
fn viscous() {
    let table = rows(include_str!("../reference/spatial/viscous_1dof_stability.csv"));
    for (zeta, nu, band) in [
        ("0.05", "0.01", Some((1.0, 1.5))),
        ("0.05", "0.001", Some((1.125, 1.75))),
        ("0.05", "0.0001", Some((1.0, 2.375))),
        ("0", "0.001", None),
    ] {
        let own: Vec<_> = table.iter().filter(|r| number(r[0]) == number(zeta) && number(r[1]) == number(nu)).collect();
        assert!(own.len() > 20, "{zeta} {nu}");
        let (from, to) = (100.0 * number(own[0][2]), 100.0 * number(own[own.len() - 1][2]));
        let out = run(&format!("{}{}", machine(number(zeta), number(nu), 0.5, 0.7), study("viscous", from, to, own.len()))).unwrap();
        assert!(words(&out).contains("with viscosity in the liquid"), "{:?}", out.findings);
        let map = out.tables.iter().find(|t| t.name() == "map").unwrap();
        let value = |name: &str, i: usize| map.column(name).unwrap().number(i).unwrap();
        let growing: Vec<f64> = (0..map.rows()).filter(|&i| value("growth", i) > 0.0).map(|i| 0.01 * value("speed", i)).collect();
        for r in own {
            let speed = number(r[2]);
            let grows = growing.iter().any(|w| (w - speed).abs() < 1e-9);
            assert_eq!(grows, number(r[3]) > 0.0, "{r:?}: {growing:?}");
        }
        let on_grid: Vec<f64> = growing.iter().copied().filter(|w| (8.0 * w - (8.0 * w).round()).abs() < 1e-9).collect();
        let ends = (on_grid[0], on_grid[on_grid.len() - 1]);
        match band {
            Some(band) => assert!((ends.0 - band.0).abs() < 1e-9 && (ends.1 - band.1).abs() < 1e-9, "{zeta} {nu}: {ends:?}"),
            // above 1/sqrt(1.5)
            None => assert!((ends.0 - 0.875).abs() < 1e-9 && (ends.1 - 0.01 * to).abs() < 1e-9, "{ends:?}"),
        }
    }
    let ideal = run(&format!("{}{}", machine(0.05, 0.0, 0.5, 0.7), study("viscous", 40.0, 300.0, 8))).unwrap_err();
    assert!(ideal.contains("no part of this machine has losses like the viscosity") && ideal.contains("give one a viscosity"), "{ideal}");
}

/// With an ideal liquid and damping the sign of the growth does not decide, and the default says so; the slow wave grows at every speed.
#[test]
fn growth() {
    let s1 = FILE.split("\n[[study]]").next().unwrap();
    let spatial = changed(s1, &[("model = \"strip\"", "model = \"spatial\"")]);
    let out = run(&format!("{spatial}{}", study("growth", 100.0, 110.0, 3))).unwrap();
    assert!(words(&out).contains("the sign of the growth rate alone does not decide"), "{:?}", out.findings);
    let out = run(&format!("{}{}", machine(0.01, 0.0, 0.5, 0.7), study("growth", 50.0, 400.0, 29))).unwrap();
    let map = out.tables.iter().find(|t| t.name() == "map").unwrap();
    let growth = map.column("growth").unwrap();
    assert!((0..map.rows()).all(|i| growth.number(i).unwrap() > 0.0));
}

/// Beside a viscous liquid roots are counted where they grow: of slower decay than a threshold nothing can be said, nor which root decays least.
#[test]
fn decay_beside_a_viscous_liquid_is_not_counted() {
    let text = changed(&super::viscous(FILE, "1e-3"), &[("speed = \"400 rad/s\"", "speed = \"60 rad/s\"")]);
    let text = text.split("\n[[study]]").next().unwrap().to_string();
    let run = |study: &str| {
        let machine = load(&format!("{text}\n[[study]]\n{study}\n")).unwrap_or_else(|d| panic!("{d:?}"));
        machine.studies[0].study.run(&machine.system, &Context::quiet("study"))
    };
    for study in ["kind = \"modes\"", "kind = \"stability_map\"\nspeed = { from = \"50 rad/s\", to = \"60 rad/s\", points = 3 }"] {
        let refused = run(&format!("{study}\ngrowth_threshold = \"-1 1/s\"")).unwrap_err();
        assert!(refused.message.contains("are counted where they grow"), "{refused}");
        assert!(run(study).is_ok());
    }
    let outcome = run("kind = \"modes\"").unwrap();
    let said = |id: &str| outcome.findings.iter().find(|f| f.id == id).map(|f| f.sentence());
    assert!(said("least_damped_mode").is_some_and(|s| s.contains("decaying modes found")), "{:?}", said("least_damped_mode"));
    assert!(said("stable").is_some_and(|s| s.contains("may be missing")), "{:?}", said("stable"));
}

/// Beside a viscous liquid decaying roots are not counted; what is drawn of the others ends at the boundary itself, not at the last speed before it.
#[test]
fn the_curve_of_growth_reaches_its_boundary() {
    let text = format!(
        "{}\n[[study]]\nkind = \"stability_map\"\nspeed = {{ from = \"90 rad/s\", to = \"220 rad/s\", points = 14 }}\n",
        super::viscous::one_coordinate(0.05, 1e-3)
    );
    let loaded = laval::file::load(&text).unwrap();
    let o = loaded.studies[0].study.run(&loaded.system, &laval::study::Context::quiet("map")).unwrap();
    let column = |table: &str, name: &str| -> Vec<f64> {
        let t = o.find_table(table).unwrap();
        (0..t.rows()).map(|r| t.column(name).unwrap().number(r).unwrap_or(f64::NAN)).collect()
    };
    let (speed, growth, ends) = (column("map", "speed"), column("map", "growth"), column("boundary", "speed"));
    assert_eq!(ends.len(), 2, "{ends:?}");
    assert!(speed.windows(2).all(|w| w[0] < w[1]), "{speed:?}");
    for (k, end) in ends.iter().enumerate() {
        let i = speed.iter().position(|w| w == end).unwrap();
        // the curve is there, on one side of it roots that grow, on the other nothing known
        let (inside, outside) = if k == 0 { (i + 1, i - 1) } else { (i - 1, i + 1) };
        assert!(growth[i].abs() < 1e-6 && growth[inside] > 0.0 && growth[outside].is_nan(), "{growth:?}");
    }
}
