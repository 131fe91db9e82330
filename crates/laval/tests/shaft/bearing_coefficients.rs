//! Supports at rest over the speed: balance, closed forms, tables, mistakes.

use crate::common::files::{finding, findings, load, run_all};
use laval::outcome::Outcome;
use std::f64::consts::PI;

const OIL: &str = "diameter = \"60 mm\"\nlength = \"25 mm\"\nclearance = \"60 um\"\nviscosity = \"20 mPa s\"";

fn machine(axis: &str, bearings: [&str; 2], study: &str) -> String {
    let mut text = format!(
        "[machine]\nname = \"t\"\nspeed = \"3000 rpm\"\naxis = \"{axis}\"\n[[part]]\nkind = \"shaft\"\nname = \"s\"\nmaterial = \"steel\"\n\
         [[part.section]]\nlength = \"0.8 m\"\nouter_diameter = \"60 mm\"\n\
         [[part]]\nkind = \"disc\"\nname = \"d\"\non = {{ body = \"s\", at = \"0.3 m\" }}\nmass = \"40 kg\"\npolar_inertia = 0.5\ndiametral_inertia = 0.3\n"
    );
    for ((name, at), bearing) in [("a", 0.0), ("b", 0.8)].into_iter().zip(bearings) {
        text += &format!("[[part]]\nname = \"{name}\"\nbetween = [{{ body = \"s\", at = {at:?} }}, \"ground\"]\n{bearing}\n");
    }
    text + &format!("[[study]]\nkind = \"bearing_coefficients\"\n{study}\n")
}

fn journals(axis: &str, study: &str) -> Outcome {
    let film = format!("kind = \"bearing_journal\"\n{OIL}");
    run_all(&machine(axis, [&film, &film], study)).remove(0)
}

fn column(o: &Outcome, name: &str) -> Vec<f64> {
    let table = o.tables.iter().find(|t| t.name() == "bearings").unwrap();
    let column = table.column(name).unwrap_or_else(|| panic!("{name}"));
    (0..table.rows()).map(|i| column.number(i).unwrap()).collect()
}

/// A rotor whose spin has a negative ratio is the mirror image of one that turns with the machine: the film takes power, and its attitude has the sense of the journal.
#[test]
fn a_journal_that_turns_the_other_way_is_mirrored() {
    let turned = |ratio: f64, study: &str| {
        let film = format!("kind = \"bearing_journal\"\n{OIL}");
        let text = machine("horizontal", [&film, &film], study).replacen("name = \"s\"\n", "name = \"s\"\nspin = \"own\"\n", 1);
        let spin = format!("[[part]]\nkind = \"speed_ratio\"\nname = \"own\"\nratio = {ratio:?}\n");
        run_all(&text.replacen("[[part]]", &format!("{spin}[[part]]"), 1).replace("3000 rpm", &format!("{:?} rpm", 3000.0 / ratio.abs())))
            .remove(0)
    };
    let alone = journals("horizontal", "speed = { from = \"1000 rpm\", to = \"9000 rpm\", points = 5 }");
    assert!(column(&alone, "power").iter().chain(&column(&alone, "attitude")).all(|x| *x > 0.0));
    let at = |ratio: f64| {
        let [from, to] = [1000.0, 9000.0].map(|w| w / f64::abs(ratio));
        turned(ratio, &format!("speed = {{ from = \"{from:?} rpm\", to = \"{to:?} rpm\", points = 5 }}"))
    };
    for ratio in [1.0, -1.0, -2.0, 4.0] {
        let other = at(ratio);
        for name in ["load", "eccentricity", "attitude", "film", "power", "kxx", "kyy", "threshold_mass", "whirl_ratio"] {
            let (a, b) = (column(&other, name), column(&alone, name));
            assert_eq!(a.len(), b.len(), "{ratio} {name}");
            let same = |a: f64, b: f64| (a - b).abs() <= 1e-6 * b.abs() || a.is_nan() && b.is_nan();
            a.iter().zip(&b).for_each(|(a, b)| assert!(same(*a, *b), "{ratio} {name}: {a} {b}"));
        }
        let sense = ratio.signum();
        let sideways = column(&other, "x").into_iter().zip(column(&alone, "x"));
        sideways.for_each(|(a, b)| assert!((a - sense * b).abs() <= 1e-6 * b.abs(), "{ratio}: {a} {b}"));
    }
}

/// The bearings carry the weight as a beam on two supports does, at every speed; faster films carry it nearer to the middle, and the attitude turns towards a right angle.
#[test]
fn films_carry_the_weight() {
    let o = journals("horizontal", "speed = { from = \"1000 rpm\", to = \"9000 rpm\", points = 9 }");
    let (load, eccentricity, attitude) = (column(&o, "load"), column(&o, "eccentricity"), column(&o, "attitude"));
    assert_eq!(load.len(), 18);
    let shaft = PI / 4.0 * 0.06f64.powi(2) * 0.8 * 7850.0;
    let g = 9.80665;
    let (near, far) = (g * (40.0 * 0.5 / 0.8 + 0.5 * shaft), g * (40.0 * 0.3 / 0.8 + 0.5 * shaft));
    for (k, pair) in load.chunks(2).enumerate() {
        assert!((pair[0] / near - 1.0).abs() < 1e-3 && (pair[1] / far - 1.0).abs() < 1e-3, "{k}: {pair:?} {near} {far}");
        assert!((pair[0] + pair[1]) / (near + far) - 1.0 < 1e-3);
    }
    for k in 2..18 {
        assert!(eccentricity[k] < eccentricity[k - 2] && attitude[k] > attitude[k - 2], "{k}");
        assert!(attitude[k] > 0.0 && attitude[k] < 0.5 * PI);
    }
    // of the short bearing: tan(attitude) = pi sqrt(1 - e^2)/(4 e)
    for (e, a) in eccentricity.iter().zip(&attitude) {
        assert!((a.tan() * 4.0 * e / (PI * (1.0 - e * e).sqrt()) - 1.0).abs() < 1e-6, "{e} {a}");
    }
    let thickness = column(&o, "film");
    assert!(thickness.iter().zip(&eccentricity).all(|(h, e)| (h / (60e-6 * (1.0 - e)) - 1.0).abs() < 1e-9));
    // findings speak of the operating speed
    let stated = findings(&o, "bearing");
    assert_eq!(stated.len(), 2);
    assert!((stated[0].value.unwrap() / near - 1.0).abs() < 1e-3 && stated[0].subject == "a");
    assert_eq!(o.figures.len(), 2);
}

/// Without a load the journal runs in the middle: cross stiffness alone, half-frequency whirl of every mass, Petrov's friction.
#[test]
fn films_without_a_load() {
    let o = journals("vertical", "speed = \"3000 rpm\"");
    let (w, k) = (100.0 * PI, column(&o, "kxx"));
    assert!(k.iter().all(|k| k.abs() < 1e-6 * column(&o, "kxy")[0]) && column(&o, "attitude")[0].is_nan());
    let petrov = 2.0 * PI * 0.02 * 0.03f64.powi(3) * 0.025 * w * w / 60e-6;
    assert!((column(&o, "power")[0] / petrov - 1.0).abs() < 1e-12);
    assert!((column(&o, "whirl_ratio")[0] - 0.5).abs() < 1e-9 && column(&o, "threshold_mass")[0].abs() < 1e-9);
    assert!(finding(&o, "threshold").sentence().contains("Every rigid mass"));
    assert!(o.figures.is_empty());
}

/// A table gives its rows; a bearing with a gap, as one without stiffness, is none.
#[test]
fn coefficients_of_a_table() {
    let table = "kind = \"bearing_linear\"\ntable = { speed = [100.0, 300.0, 900.0], kxx = [1e6, 2e6, 5e6], kxy = [1e5, 2e5, 3e5], kyy = [3e6, 4e6, 5e6], cxx = [1e3, 2e3, 3e3], cyy = [4e3, 5e3, 6e3] }";
    let constant = "kind = \"bearing_linear\"\nkxx = 7e6\nkyy = 8e6\ncxx = 10.0\ncyy = 20.0";
    let o = run_all(&machine("horizontal", [table, constant], "speed = { from = 100.0, to = 900.0, points = 5 }")).remove(0);
    let speed = column(&o, "speed");
    let row = speed.iter().position(|w| *w == 300.0).unwrap();
    for (name, first, second) in
        [("kxx", 2e6, 7e6), ("kxy", 2e5, 0.0), ("kyx", 0.0, 0.0), ("kyy", 4e6, 8e6), ("cxx", 2e3, 10.0), ("cyy", 5e3, 20.0)]
    {
        let of = column(&o, name);
        assert!((of[row] - first).abs() <= 1e-9 * first.abs() && of[row + 1] == second, "{name}: {of:?}");
    }
    // springs give way below the load
    assert!(column(&o, "y").iter().all(|y| *y < 0.0));
    assert!(o.tables[0].column("eccentricity").is_none() && o.figures.len() == 1);
}

/// A squeeze film beside a spring has an eccentricity, and neither a thickness nor power to show; without a load there is no attitude.
#[test]
fn figures_show_what_is_there() {
    let spring = "kind = \"bearing_linear\"\nkxx = 7e6\nkyy = 8e6";
    let squeeze =
        format!("[[part]]\nkind = \"squeeze_film\"\nname = \"f\"\nbetween = [{{ body = \"s\", at = 0.0 }}, \"ground\"]\n{OIL}\n[[study]]");
    let range = "speed = { from = \"1000 rpm\", to = \"9000 rpm\", points = 3 }";
    let text = machine("horizontal", [spring; 2], &format!("{range}\nsupports = \"a, b, f\"")).replace("[[study]]", &squeeze);
    let o = run_all(&text).remove(0);
    let table = o.tables.iter().find(|t| t.name() == "bearings").unwrap();
    assert!(table.column("eccentricity").is_some() && table.column("film").is_none() && o.figures.len() == 2);
    assert_eq!(findings(&o, "bearing").len(), 3);
    let o = journals("vertical", range);
    assert!(o.figures.len() == 2 && column(&o, "attitude").iter().all(|a| a.is_nan()));
}

#[test]
fn a_machine_without_supports_is_refused() {
    let damper = "kind = \"damper\"\ndamping = 100.0";
    let loaded = load(&machine("vertical", [damper, damper], "speed = \"3000 rpm\""));
    let refusals = loaded.refusals();
    assert!(!refusals.is_empty());
    let text = machine("vertical", ["kind = \"bearing_linear\"\nkxx = 1e6\nkyy = 1e6"; 2], "speed = \"3000 rpm\"\nsupports = \"c\"");
    let wrong = laval::file::load(&text).err().unwrap();
    assert!(wrong.0.len() == 1 && wrong.0[0].code == "study.supports", "{wrong:?}");
}
