//! Maps of settled motion: against single sweeps, the linear response, machines that do not exist, and mistakes.

use crate::common;

use common::planar_file::{oil, planar_file};
use laval::file::{Form, load, render};
use laval::outcome::{Data, End, Finding, Outcome, Table};
use laval::report::draw;
use laval::study::Context;
use std::f64::consts::TAU;

fn text(law: &str, study: &str) -> String {
    format!("{}\n[[study]]\n{study}\n", planar_file(law, "20 um", ["420", "300"]))
}

fn run(text: &str) -> Outcome {
    let loaded = load(text).unwrap_or_else(|d| panic!("{}", render(&d, text, "m.toml", Form::Lines)));
    let o = loaded.studies[0].study.run(&loaded.system, &Context::quiet("study")).unwrap();
    for f in &o.figures {
        assert!(!f.alt.key.is_empty() && draw(f, &o.tables).unwrap().contains("<svg"));
    }
    o
}

fn refused(study: &str) -> String {
    match load(&text("per_axis", study)) {
        Ok(_) => panic!("accepted: {study}"),
        Err(d) => d.0.iter().map(|d| format!("{d}\n")).collect(),
    }
}

fn numbers(t: &Table, name: &str) -> Vec<f64> {
    let c = t.column(name).unwrap_or_else(|| panic!("no {name}"));
    (0..t.rows()).map(|r| c.number(r).unwrap_or(f64::NAN)).collect()
}

fn words(t: &Table, name: &str) -> Vec<String> {
    match &t.column(name).unwrap().data {
        Data::Text(v) => v.clone(),
        other => panic!("{other:?}"),
    }
}

fn said<'a>(o: &'a Outcome, id: &str) -> &'a Finding {
    o.findings
        .iter()
        .find(|f| f.id == id)
        .unwrap_or_else(|| panic!("no {id} in {:?}", o.findings.iter().map(Finding::sentence).collect::<Vec<_>>()))
}

const Y: &str = "y = { parameter = \"drum.eccentricity\", from = \"10 um\", to = \"40 um\", points = 2 }";

/// A row of the map has the bits of a sweep over the machine with its parameter: the same start, the same integration.
#[test]
fn rows_are_sweeps() {
    let speeds = "speed = { from = 1500, to = 2700, points = 7 }\nrelative_tolerance = 1e-9";
    let map = run(&text("per_axis", &format!("kind = \"motion_map\"\n{speeds}\n{Y}")));
    assert_eq!(map.end, End::Reached);
    let t = map.find_table("map").unwrap();
    assert_eq!(t.rows(), 14);
    for (j, e) in ["10 um", "40 um"].into_iter().enumerate() {
        let file = planar_file("per_axis", e, ["420", "300"]);
        let sweep = run(&format!("{file}\n[[study]]\nkind = \"sweep\"\nstart = \"rest\"\n{speeds}\nmost_periods = 10000\n"));
        let own = sweep.tables.iter().find(|t| t.column("amplitude.drum").is_some() && t.rows() == 7).unwrap();
        for column in ["speed", "amplitude.drum", "rms.drum", "amplitude.base", "steps"] {
            let (a, b) = (numbers(t, column)[7 * j..7 * (j + 1)].to_vec(), numbers(own, column));
            assert!(a.iter().zip(&b).all(|(a, b)| a == b || column == "steps" && b.is_nan()), "{e} {column} {a:?} {b:?}");
        }
    }
    let largest = map.findings.iter().find(|f| f.id == "largest_displacement" && f.subject == "drum").unwrap();
    let top = numbers(t, "amplitude.drum").into_iter().fold(0.0, f64::max);
    assert_eq!(largest.value, Some(top));
}

/// Without a cubic part the displacement is `m e W^2 / |k - m W^2 + i c W|` on a bearing that stands, at every point of a map of two parameters.
#[test]
fn a_linear_machine_moves_as_the_closed_form() {
    let speed = 300.0;
    let file = |study: &str| {
        format!(
            "[machine]\nname = \"one\"\nspeed = {speed}\n[[part]]\nkind = \"disc\"\nname = \"rotor\"\nmass = 10\neccentricity = 1e-4\n[[part]]\nkind = \"shaft_lumped\"\n\
             name = \"side\"\nbetween = [\"rotor\", \"ground\"]\nstiffness = 1e6\n[[part]]\nkind = \"damper\"\nname = \"air\"\nbetween = [\"rotor\", \"ground\"]\n\
             damping = 300\n[[study]]\nkind = \"motion_map\"\n{study}\n"
        )
    };
    let o = run(&file(
        "x = { parameter = \"side.stiffness\", from = 5e5, to = 2e6, points = 4 }\ny = { parameter = \"air.damping\", from = 200, to = 800, points = 3 }\ntolerance = 1e-8",
    ));
    let t = o.find_table("map").unwrap();
    let (k, c, a) = (numbers(t, "side.stiffness"), numbers(t, "air.damping"), numbers(t, "amplitude.rotor"));
    for i in 0..12 {
        let want = 10.0 * 1e-4 * speed * speed / (k[i] - 10.0 * speed * speed).hypot(c[i] * speed);
        assert!((a[i] - want).abs() < 1e-7 * want, "{} {} {:e}", k[i], c[i], (a[i] - want) / want);
    }
    assert!(words(t, "class").iter().all(|c| c == "every turn"));
    assert_eq!(said(&o, "every_turn").value, Some(12.0));
    // the speeds are those about the machine's when nothing is said
    let o = run(&file("y = { parameter = \"air.damping\", from = 200, to = 800, points = 2 }"));
    let w = numbers(o.find_table("map").unwrap(), "speed");
    assert_eq!((w[0], w[49], w.len()), (0.5 * speed, 1.5 * speed, 100));
}

/// A machine that does not exist is a point without a motion, and the others stay as they are.
#[test]
fn machines_that_do_not_exist() {
    let tank = oil("50 mm", "40");
    let file = |to: &str, points: i32| {
        format!(
            "{}{tank}\n[[study]]\nkind = \"motion_map\"\nspeed = {{ from = 300, to = 500, points = 2 }}\ny = {{ parameter = \"oil.free_surface_radius\", from = \
             \"60 mm\", to = \"{to}\", points = {points} }}\n",
            planar_file("per_axis", "20 um", ["420", "300"])
        )
    };
    let (whole, part) = (run(&file("65 mm", 2)), run(&file("80 mm", 5)));
    let (a, b) = (whole.find_table("map").unwrap(), part.find_table("map").unwrap());
    assert_eq!(numbers(a, "amplitude.drum"), numbers(b, "amplitude.drum")[..4].to_vec());
    let classes = words(b, "class");
    assert!(classes[..4].iter().all(|c| c != "failed") && classes[6..].iter().all(|c| c == "failed"), "{classes:?}");
    let reported = part.findings.iter().filter(|f| f.id == "failed_machines");
    let (count, named) =
        reported.fold((0.0, true), |(n, all), f| (n + f.value.unwrap(), all && f.sentence().contains("oil.free_surface_radius = ")));
    assert!(named && count == classes.iter().filter(|c| *c == "failed").count() as f64);
}

/// Where two motions are stable, that of large displacements is reached from one.
#[test]
fn the_start_decides() {
    let study = |x: &str, v: &str| {
        let m = run(&text(
            "isotropic",
            &format!(
                "kind = \"motion_map\"\nspeed = {{ from = 2262, to = 2282, points = 3 }}\ny = {{ parameter = \"air.damping\", from = 40, to = 60, points = 2 }}\ninitial = {{ \"drum.x\" = \"{x}\", \"drum.y'\" = \"{v}\" }}"
            ),
        ));
        numbers(m.find_table("map").unwrap(), "amplitude.drum")
    };
    let (low, again) = (study("0 mm", "0 m/s"), study("0 mm", "0 m/s"));
    assert_eq!(low, again);
    let high = study("2 mm", "4.5 m/s");
    assert!(low.iter().chain(&high).all(|a| a.is_finite()));
    assert!(low.iter().zip(&high).any(|(a, b)| (a - b).abs() > 0.5 * a), "{low:?} {high:?}");
}

#[test]
fn mistakes_are_reported() {
    let map = |rest: &str| refused(&format!("kind = \"motion_map\"\n{rest}"));
    assert!(map(Y).contains("needs a range of speeds"));
    let speed = "speed = { from = 100, to = 200, points = 3 }";
    assert!(map(&format!("{Y}\n{speed}\nx = {{ parameter = \"drum.mass\", from = 1, to = 2 }}")).contains("both a range of speeds"));
    assert!(map(&format!("{Y}\nx = {{ parameter = \"drum.mass\", from = 1, to = 2 }}")).contains("needs a speed above zero"));
    assert!(map(&format!("{speed}\ny = {{ parameter = \"drum.mas\", from = 1, to = 2 }}")).contains("drum.mas"));
    assert!(map(&format!("{Y}\nspeed = {{ from = 0, to = 200, points = 3 }}")).contains("no period at rest"));
    let long = Y.replace("points = 2", "points = 600");
    assert!(map(&format!("{long}\nspeed = {{ from = 1, to = 200, points = 600 }}")).contains("too large"));
}

/// A period of one turn is reported as such; the words of the legend are those of the table.
#[test]
fn classes_follow_periods() {
    let o = run(&text(
        "per_axis",
        &format!("kind = \"motion_map\"\nspeed = {{ from = {}, to = {}, points = 3 }}\n{Y}", 20.0 * TAU, 40.0 * TAU),
    ));
    let t = o.find_table("map").unwrap();
    for (class, period) in words(t, "class").iter().zip(numbers(t, "period")) {
        assert_eq!(class == "every turn", period == 1.0, "{class} {period}");
    }
}
