//! A machine with spatial liquid beside its approximation of degree sixteen.

use super::{FILE, build, changed, truncated, viscous};
use laval::file::load;
use laval::outcome::{Outcome, Table};
use laval::solve::pencil::modes_about;
use laval::solve::rest::rest;
use laval::study::Context;

fn study(more: &str) -> String {
    format!(
        "\n[[study]]\nkind = \"campbell\"\nspeed = {{ from = \"300 rad/s\", to = \"312 rad/s\", points = 3 }}\nfrequency_limit = \"900 rad/s\"\n{more}\n"
    )
}

fn run(text: &str) -> Result<Outcome, String> {
    let text = format!("{}{}", text.split("\n[[study]]").next().unwrap(), study("compare = \"approximation\""));
    let machine = load(&text).unwrap_or_else(|d| panic!("{text}\n{d:?}"));
    machine.studies[0].study.run(&machine.system, &Context::quiet("campbell")).map_err(|d| d.message.to_string())
}

fn column(t: &Table, name: &str) -> Vec<f64> {
    match &t.column(name).unwrap_or_else(|| panic!("{name}")).data {
        laval::outcome::Data::Float(x) => x.clone(),
        other => panic!("{other:?}"),
    }
}

/// The points are the spectrum of the machine with `planar_tilt`, whatever the viscosity of the liquid they stand for, and what is said of them follows from the table.
#[test]
fn degree_sixteen_beside_the_whole() {
    let plain = build(&changed(FILE, &[("model = \"strip\"", "model = \"planar_tilt\"")]));
    for text in [truncated(FILE, 3), viscous(&truncated(FILE, 3), "1e-5")] {
        let out = run(&text).unwrap();
        let table = out.tables.iter().find(|t| t.name() == "approximate_modes").unwrap();
        let [speed, frequency, growth, distance, whole] =
            ["speed", "frequency", "growth", "distance", "whole_frequency"].map(|name| column(table, name));
        for w in [300.0, 306.0, 312.0] {
            let modes = modes_about(&plain, &rest(&plain, w).unwrap(), true).unwrap().modes;
            let own: Vec<usize> = (0..speed.len()).filter(|&i| (speed[i] - w).abs() < 1e-9).collect();
            assert_eq!(own.len(), modes.len());
            for m in modes {
                let met = own.iter().any(|&i| (frequency[i] - m.frequency()).abs() + (growth[i] - m.growth()).abs() < 1e-7 * m.value.abs());
                assert!(met, "{w}: {:?}", m.value);
            }
        }
        let finding = out.findings.iter().find(|f| f.id == "approximation").unwrap();
        assert!(finding.number("degree") == Some(16.0) && finding.sentence().contains("degree 16"), "{}", finding.sentence());
        // no root is nearer than the frequencies say
        for i in 0..speed.len() {
            assert!(distance[i] >= (frequency[i] - whole[i]).abs() * (1.0 - 1e-12), "{i}");
        }
        // the plane wave is met, the conical modes are not
        let best = distance.iter().zip(&frequency).map(|(d, f)| d / f).fold(f64::INFINITY, f64::min);
        let worst = distance.iter().zip(&frequency).map(|(d, f)| d / f).fold(0.0, f64::max);
        assert!(best < 1e-3 && worst > 0.02, "{best} {worst}");
        assert!(out.figures.iter().any(|f| f.name == "approximation"));
    }
}

#[test]
fn refusals() {
    let strip = run(FILE).unwrap_err();
    assert!(strip.contains("no part of this machine has an approximation"), "{strip}");
    // planar_tilt would take more inertia than the rotor has
    let tall = changed(
        &truncated(FILE, 3),
        &[
            ("diametral_inertia = \"0.70 kg m^2\"", "diametral_inertia = \"0.30 kg m^2\""),
            ("cavity_height = \"300 mm\"", "cavity_height = \"600 mm\""),
        ],
    );
    let reported = run(&tall).unwrap_err();
    assert!(reported.contains("the approximation is no machine") && reported.contains("no inertia is left"), "{reported}");
}
