//! Tests of the machine file, on a small catalogue of its own.

mod fuzz;
mod mistakes;
mod outputs;

use super::*;
use crate::model::field::{Amount, Attach, InnerStudy, RangeValue, Tolerance, Value};

const LAWS: &[(&str, &str)] = &[("per_axis", "each direction by itself"), ("isotropic", "by the distance")];
type Alternative = (&'static str, &'static str, Bounds, &'static str);
const FILL: &[Alternative] = &[
    ("free_surface_radius", "m", Bounds::positive(10.0), "radius of the free surface, r0"),
    ("volume_fraction", "", Bounds::closed(0.0, 1.0), "filled share of the cavity"),
    ("volume", "m^3", Bounds::positive(10.0), "volume of the liquid"),
    ("mass", "kg", Bounds::positive(1e5), "mass of the liquid"),
];
const COLUMNS: &[(&str, &str, bool, &str)] =
    &[("speed", "rad/s", true, "speed of each row"), ("kxx", "N/m", true, "stiffness"), ("cxx", "N s/m", false, "damping")];

pub(super) fn catalog() -> Catalog {
    let q = |unit, bounds| FieldKind::Quantity { unit, bounds };
    let lateral = |unit, max| FieldKind::Lateral { unit, bounds: Bounds::up_to(max) };
    let k = |kind, doc, fields| KindInfo { kind, doc, example: "", fields, lists: Vec::new() };
    let r = Field::required;
    let o = Field::optional;
    Catalog {
        blocks: vec![],
        parts: vec![
            k(
                "disc",
                "A rigid disc that moves in its plane.",
                vec![
                    r("mass", q("kg", Bounds::positive(1e6)), "mass, m"),
                    o("eccentricity", q("m", Bounds::up_to(1.0)), "0 m", "distance of the centre of mass from the axis, e"),
                    o("eccentricity_phase", q("rad", Bounds::within(10.0)), "0.0 rad", "its direction from the key mark"),
                ],
            ),
            k(
                "foundation",
                "A rigid body on linear springs.",
                vec![
                    r("mass", q("kg", Bounds::positive(1e7)), "mass"),
                    r("stiffness", lateral("N/m", 1e15), "stiffness to the ground"),
                    o("damping", lateral("N s/m", 1e12), "0.0 N s/m", "damping to the ground"),
                ],
            ),
            k(
                "bearing_cubic",
                "A bearing with a cubic restoring force.",
                vec![
                    r("between", FieldKind::Between, "what it connects"),
                    r("stiffness", lateral("N/m", 1e15), "linear stiffness, k1"),
                    o("cubic_stiffness", lateral("N/m^3", 1e25), "0 N/m^3", "cubic stiffness, k3"),
                    o("law", FieldKind::Choice(LAWS), "per_axis", "how the directions combine"),
                ],
            ),
            k(
                "damper",
                "A viscous damper.",
                vec![
                    r("between", FieldKind::Between, "what it connects"),
                    r("damping", lateral("N s/m", 1e12), "damping constant, c"),
                    o("rotating", FieldKind::Flag, "false", "turns with the rotor"),
                ],
            ),
            k(
                "bearing_table",
                "Coefficients over speed.",
                vec![
                    r("on", FieldKind::Attach { ground: false }, "where it sits"),
                    r("table", FieldKind::Columns(COLUMNS), "coefficients"),
                    o("temperature", q("K", Bounds::closed(200.0, 500.0)), "", "oil temperature"),
                ],
            ),
            k(
                "liquid",
                "A cavity partly filled with liquid.",
                vec![
                    r("in", FieldKind::Attach { ground: false }, "the body with the cavity"),
                    r("cavity_radius", q("m", Bounds::positive(10.0)), "inner radius of the cavity, R"),
                    r("cavity_height", q("m", Bounds::positive(10.0)), "height of the cavity"),
                    r("density", q("kg/m^3", Bounds::positive(1e5)), "density"),
                    r("fill", FieldKind::OneOf(FILL), "how much liquid"),
                ],
            ),
        ],
        studies: vec![
            k(
                "nonlinear_response",
                "Steady response over speed.",
                vec![
                    r("speed", FieldKind::Range { unit: "rad/s", bounds: Bounds::up_to(1e6) }, "speeds"),
                    o("harmonics", FieldKind::IntegerOrAuto { min: 1, max: 99 }, "auto", "number of harmonics"),
                ],
            ),
            k(
                "modes",
                "Natural frequencies.",
                vec![
                    o("speeds", FieldKind::List { unit: "rad/s", bounds: Bounds::up_to(1e6) }, "", "speeds"),
                    o("count", FieldKind::Integer { min: 1, max: 1000 }, "6", "number of modes"),
                ],
            ),
            k(
                "transient",
                "Motion in time.",
                vec![
                    r("duration", q("s", Bounds::positive(1e6)), "how long"),
                    o("initial", FieldKind::StateMap, "", "initial values"),
                    o("watch", FieldKind::Coordinate, "", "coordinate to watch"),
                    o("title", FieldKind::Text, "", "title of the figure"),
                ],
            ),
            k(
                "sweep",
                "A family over one parameter.",
                vec![
                    r("over", FieldKind::ParameterRange, "the parameter"),
                    o("also", FieldKind::ParameterPath, "", "a parameter to report"),
                ],
            ),
        ],
    }
}

pub(super) const EXAMPLE: &str = r#"[machine]
name  = "oil separator"
speed = "3000 rpm"               # for studies that name none
axis  = "vertical"               # or "horizontal": gravity then points to -y

[[part]]
kind = "disc"
name = "drum"
mass = "2.4 kg"
eccentricity = "1 mm"

[[part]]
kind = "foundation"
name = "base"
mass = "25 kg"
stiffness = "3.26e5 N/m"
damping = "6.59 N s/m"

[[part]]
kind = "bearing_cubic"
between = ["drum", "base"]
stiffness = "1.1e7 N/m"
cubic_stiffness = "8.7e10 N/m^3"
law = "per_axis"                 # or "isotropic"

[[part]]
kind = "damper"
between = ["drum", "ground"]
damping = "42 N s/m"

[[part]]
kind = "liquid"
in = "drum"
cavity_radius = "70 mm"
cavity_height = "60 mm"
density = "1000 kg/m^3"
fill = { free_surface_radius = "46.7 mm" }   # or volume_fraction, volume, mass

[[study]]
kind  = "nonlinear_response"
speed = { from = "25 rad/s", to = "8000 rad/s" }
harmonics = "auto"
"#;

/// A file that uses every kind of field.
pub(super) const EVERYTHING: &str = r#"
[machine]
name = "all \"kinds\" of fields"
axis = "horizontal"
[[part]]
kind = "disc"
name = "drum"
mass = 2.4
eccentricity_phase = "30 deg"
[[part]]
kind = "disc"
mass = "1 kg"
[[part]]
kind = "disc"
mass = "1 kg"
[[part]]
kind = "bearing_cubic"
between = [{ body = "drum", at = "-40 mm" }, "ground"]
stiffness = { x = "1e7 N/m", y = 2e7 }
law = "isotropic"
[[part]]
kind = "bearing_table"
on = { body = "drum" }
table = { speed = ["0 rpm", "3000 rpm"], kxx = [1e7, "1.1 kN/mm"] }
temperature = "40 degC"
[[part]]
kind = "damper"
between = ["drum", "ground"]
damping = 0
rotating = true
[[part]]
kind = "liquid"
name = "oil"
in = "drum"
cavity_radius = "70 mm"
cavity_height = "60 mm"
density = "1000 kg/m^3"
fill = { volume_fraction = "50 %" }
[[study]]
kind = "nonlinear_response"
speed = { from = "8000 rad/s", to = 0, points = 7 }
harmonics = 5
[[study]]
kind = "modes"
speeds = ["0 rpm", "0.5 Hz", 33.3]
[[study]]
kind = "transient"
duration = "2 min"
initial = { "drum.x" = "1 mm", drum.y = 0.002, "drum.x'" = "0.1 m/s" }
watch = "drum.x"
title = "µ \\ \n\u0007"
[[study]]
kind = "sweep"
over = { parameter = "oil.volume_fraction", from = "10 %", to = 0.9, points = 3 }
also = "bearing_cubic.stiffness.x"
"#;

pub(super) fn good(text: &str) -> Spec {
    let (spec, d) = read(text, &catalog());
    match spec {
        Some(s) if d.0.is_empty() => s,
        _ => panic!("{}", render(&d, text, "machine.toml", Form::Lines)),
    }
}

#[test]
fn the_catalogue_is_sound() {
    assert!(catalog().check().0.is_empty(), "{:?}", catalog().check());
}

#[test]
fn unsound_declarations_are_found() {
    let mut c = catalog();
    c.parts[0].fields.push(Field::optional("mass", FieldKind::Flag, "yes", "twice, and the default is no flag"));
    c.parts[0].fields.push(Field::required("length", FieldKind::Quantity { unit: "mm", bounds: Bounds::up_to(1.0) }, "not SI"));
    c.parts[0].fields.push(Field::optional(
        "gap",
        FieldKind::Quantity { unit: "m", bounds: Bounds::positive(1.0) },
        "0 m",
        "out of bounds",
    ));
    let codes: Vec<&str> = c.check().0.iter().map(|d| d.code).collect();
    assert_eq!(codes, ["declaration.twice", "declaration.default", "declaration.unit", "declaration.default"]);
}

#[test]
fn the_example_reads() {
    let s = good(EXAMPLE);
    assert_eq!(s.machine.name, "oil separator");
    assert!((s.machine.speed.unwrap() - 100.0 * std::f64::consts::PI).abs() < 1e-12);
    assert_eq!(s.machine.axis, RotorAxis::Vertical);
    let names: Vec<&str> = s.parts.iter().map(|b| b.name.as_str()).collect();
    assert_eq!(names, ["drum", "base", "bearing_cubic", "damper", "liquid"]);
    let v = &s.part("bearing_cubic").unwrap().values;
    assert_eq!(v.between("between"), Some((Attach::on("drum"), Attach::on("base"))));
    assert_eq!(v.lateral("cubic_stiffness"), Some([8.7e10; 2]));
    assert_eq!(v.choice("law"), Some("per_axis"));
    assert_eq!(s.part("liquid").unwrap().values.one_of("fill"), Some(("free_surface_radius", 0.0467)));
    assert_eq!(s.studies[0].values.range("speed"), Some(RangeValue { from: 25.0, to: 8000.0, points: None }));
    assert_eq!(s.studies[0].values.get("harmonics"), Some(&Value::Auto));
    // Defaults are filled in, without a place of their own.
    let drum = s.part("drum").unwrap();
    assert_eq!(drum.values.number("eccentricity_phase"), Some(0.0));
    assert_eq!(drum.values.span_of("eccentricity_phase"), drum.span);
    assert_eq!(&EXAMPLE[drum.values.span_of("mass").unwrap()], "\"2.4 kg\"");
    assert_eq!(&EXAMPLE[drum.name_span.clone().unwrap()], "\"drum\"");
    assert_eq!(&EXAMPLE[drum.span.clone().unwrap()], "[[part]]");
}

#[test]
fn every_kind_of_field_reads() {
    let s = good(EVERYTHING);
    let names: Vec<&str> = s.parts.iter().map(|b| b.name.as_str()).collect();
    assert_eq!(names, ["drum", "disc", "disc-2", "bearing_cubic", "bearing_table", "damper", "oil"]);
    assert_eq!(s.parts[3].values.between("between"), Some((Attach::at("drum", -0.04), Attach::ground())));
    assert_eq!(s.parts[3].values.lateral("stiffness"), Some([1e7, 2e7]));
    let t = s.parts[4].values.columns("table").unwrap();
    assert_eq!(t["kxx"], [1e7, 1.1e6]);
    assert_eq!(s.parts[4].values.number("temperature"), Some(313.15));
    assert_eq!(s.parts[5].values.flag("rotating"), Some(true));
    assert_eq!(s.parts[6].values.one_of("fill"), Some(("volume_fraction", 0.5)));
    assert_eq!(s.studies[1].values.integer("count"), Some(6));
    let initial = &s.studies[2].values;
    let map: Vec<(&str, f64)> = initial.state_map("initial").unwrap().iter().map(|e| (e.0.as_str(), e.1)).collect();
    assert_eq!(map, [("drum.x", 0.001), ("drum.y", 0.002), ("drum.x'", 0.1)]);
    assert_eq!(initial.units_of("initial"), [Some("m".to_string()), None, Some("m/s".to_string())]);
    assert_eq!(
        s.studies[3].values.parameter_range("over"),
        Some(("oil.volume_fraction", RangeValue { from: 0.1, to: 0.9, points: Some(3) }))
    );
}

#[test]
fn default_names_avoid_given_ones() {
    let text = "[machine]\n[[part]]\nkind='disc'\nmass=1\n[[part]]\nkind='disc'\nname='disc'\nmass=1\n[[part]]\nkind='disc'\nmass=1\n";
    let s = good(text);
    let names: Vec<&str> = s.parts.iter().map(|b| b.name.as_str()).collect();
    assert_eq!(names, ["disc-2", "disc", "disc-3"]);
}

#[test]
fn written_files_read_back() {
    for text in [EXAMPLE.to_string(), EVERYTHING.to_string()] {
        let spec = good(&text).without_spans();
        let written = write(&spec, &catalog());
        assert_eq!(good(&written).without_spans(), spec, "{written}");
        assert_eq!(write(&good(&written), &catalog()), written);
        let json = write_json(&spec);
        let through_text: serde_json::Value = serde_json::from_str(&json.to_string()).unwrap();
        let (back, d) = read_json(&through_text, &catalog());
        let mut back = back.unwrap_or_else(|| panic!("{d:?}"));
        back = back.without_spans();
        assert_eq!(back, spec);
    }
}

#[test]
fn the_written_example_is_as_a_person_writes() {
    insta::assert_snapshot!(write(&good(EXAMPLE), &catalog()));
}
