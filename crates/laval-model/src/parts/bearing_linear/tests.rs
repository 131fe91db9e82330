//! What only a linear bearing knows.

use super::*;
use crate::model::conformance::local_stiffness;
use crate::model::field::{Attach, Value};
use laval_num::complex::c;
use std::collections::BTreeMap;

pub(super) fn link() -> Link {
    Link::Between(Attach::on("drum"), Attach::ground())
}
pub(super) fn table() -> Table {
    let columns = |name: &str| match name {
        "kxx" => Some(vec![1e6, 3e6, 4e6, 3.5e6]),
        "kyy" => Some(vec![2e6, 2.5e6, 2.6e6, 5e6]),
        "kxy" => Some(vec![1e5, 4e5, 9e5, 1.2e6]),
        "kyx" => Some(vec![-2e5, -3e5, -8e5, -9e5]),
        "cxx" => Some(vec![900.0, 700.0, 500.0, 400.0]),
        "cxy" => Some(vec![90.0, 70.0, -50.0, 40.0]),
        "cyy" => Some(vec![800.0, 810.0, 700.0, 100.0]),
        _ => None,
    };
    Table::new(&[50.0, 200.0, 350.0, 600.0], columns).unwrap()
}
fn build(f: impl Fn(&mut Values, &mut ParamValues)) -> (Option<BearingLinear>, Vec<String>) {
    let (mut values, mut params, mut d) = (Values::default(), ParamValues::default(), Diagnostics::default());
    values.set("between", Value::Between(Attach::on("drum"), Attach::ground()), None);
    f(&mut values, &mut params);
    let part = BearingLinear::build(&values, &mut params, &mut d);
    (part, d.0.iter().map(|d| d.to_string()).collect())
}
fn columns(speed: &[f64], kxx: &[f64]) -> Value {
    Value::Columns(BTreeMap::from([("speed", speed.to_vec()), ("kxx", kxx.to_vec()), ("kyy", vec![1e6; speed.len()])]))
}

#[test]
fn coefficients_stand_where_the_convention_says() {
    let p = BearingLinearParams { kxx: 1.0, kxy: 2.0, kyx: 3.0, kyy: 4.0, cxx: 5.0, cxy: 6.0, cyx: 7.0, cyy: 8.0, kzz: 0.0, czz: 0.0 };
    let mut b = Blocks::default();
    b.reset(2, 0, 100.0);
    BearingLinear::constant(link()).linear(&p.into(), 100.0, &mut b);
    let z = local_stiffness(&b, c(0.0, 10.0)).unwrap();
    assert_eq!((z[(0, 1)], z[(1, 0)]), (c(2.0, 60.0), c(3.0, 70.0)));
    assert_eq!((z[(0, 0)], z[(1, 1)]), (c(1.0, 50.0), c(4.0, 80.0)));
}

/// A forward circle at deflection r receives pi r^2 (kxy - kyx) per turn, a backward one loses it.
#[test]
fn positive_kxy_with_negative_kyx_feeds_forward_whirl() {
    let p = BearingLinearParams { kxy: 3e5, kyx: -1e5, ..BearingLinearParams::new() };
    let bearing = BearingLinear::constant(link());
    for (direction, sign) in [(1.0, 1.0), (-1.0, -1.0)] {
        let (q, v) = ([1e-3, 0.0], [0.0, direction * 1e-3 * 200.0]);
        let at = At { q: &q, v: &v, a: &[0.0; 2], z: &[], phase: 0.0, speed: 300.0, spin_accel: 0.0, t: 0.0 };
        let e = bearing.energy(&p.into(), &at).unwrap();
        let per_turn = e.supplied * std::f64::consts::TAU / 200.0;
        assert!((per_turn - sign * std::f64::consts::PI * 1e-6 * 4e5).abs() < 1e-12);
    }
}

/// The harmonic mean of the slopes beside an inner row, weighted by `p = 2 h_i + h_{i-1}` and `r = h_i + 2 h_{i-1}`, and no slope where the column turns.
#[test]
fn between_its_rows_a_table_is_the_cubic_that_its_documentation_names() {
    let field = BearingLinear::FIELDS.iter().find(|f| f.name == "table").unwrap();
    assert!(field.doc.contains("monotone cubic") && field.doc.contains("PCHIP"), "{}", field.doc);
    let kxx = |speed: f64| BearingLinear::tabulated(link(), table()).coefficients(&table().params(), speed).value[0];
    let (d0, d1, h) = (2e6 / 150.0, 1e6 / 150.0, 150.0);
    let (s1, s2) = (6.0 * h / (3.0 * h / d0 + 3.0 * h / d1), 0.0);
    // cubic Hermite in the middle of the second interval
    let middle = 0.5 * (3e6 + 4e6) + h / 8.0 * (s1 - s2);
    assert!((kxx(275.0) / middle - 1.0).abs() < 1e-12, "{} {middle}", kxx(275.0));
    for k in 0..=60 {
        let speed = 350.0 + 250.0 * f64::from(k) / 60.0;
        assert!((3.5e6 - 1e-3..=4e6 + 1e-3).contains(&kxx(speed)), "{speed}");
    }
}

#[test]
fn a_table_is_exact_at_its_rows_and_marks_speeds_outside() {
    let bearing = BearingLinear::tabulated(link(), table());
    let p = table().params();
    for (speed, kxx, inside) in [(200.0, 3e6, true), (600.0, 3.5e6, true), (900.0, 3.5e6, false), (49.0, 1e6, false)] {
        assert!((bearing.coefficients(&p, speed).value[0] - kxx).abs() < 1e-6);
        let at = At { q: &[0.0; 2], v: &[0.0; 2], a: &[0.0; 2], z: &[], phase: 0.0, speed, spin_accel: 0.0, t: 0.0 };
        let mut v = Vec::new();
        bearing.validity(&p, &at, &mut v);
        assert_eq!(v[0].ratio <= 1.0, inside, "{speed}");
    }
}

#[test]
fn mistakes_are_reported() {
    let (part, text) = build(|v, _| v.set("table", columns(&[100.0, 300.0, 200.0], &[1e6; 3]), None));
    assert!(part.is_none());
    assert_eq!(text, ["speeds must increase from row to row: row 3 has 200 rad/s (1910 rpm) after 300 rad/s (2865 rpm)"]);
    let (_, text) = build(|v, _| v.set("table", columns(&[100.0, 300.0], &[1e6; 3]), None));
    assert_eq!(text, ["column kxx has 3 rows and column speed has 2"]);
    let (_, text) = build(|v, _| v.set("table", columns(&[100.0], &[1e6]), None));
    assert!(text[0].contains("at least two rows"));
    let (_, text) = build(|v, _| v.set("table", columns(&[100.0, 200.0], &[1e6, f64::NAN]), None));
    assert_eq!(text, ["column kxx: row 2 is not a finite number"]);
    let (_, text) = build(|v, p| {
        v.set("table", columns(&[100.0, 200.0], &[1e6; 2]), None);
        p.set("cxx", 3.0);
    });
    assert!(text[0].contains("cxx is given as a constant beside a table"));
    assert!(build(|_, _| ()).1[0].contains("all eight are zero"));
    assert!(build(|_, p| p.set("kxx", 1e6)).1.is_empty());
    let (_, text) = build(|v, p| {
        p.set("kxx", 1e6);
        v.set("beyond", Value::Choice("hold"), Some(0..1));
    });
    assert!(text[0].contains("without a table"));
    let (_, text) = build(|v, _| {
        v.set("table", columns(&[100.0, 200.0], &[1e6; 2]), None);
        v.set("damping", Value::Number(3.0), None);
    });
    assert!(text[0].contains("damping is given as a constant beside a table"));
}

/// `stiffness` and `damping` are kxx = kyy and cxx = cyy, and nothing beside these.
#[test]
fn one_value_stands_for_both_directions() {
    let (mut values, mut params, mut d) = (Values::default(), ParamValues::default(), Diagnostics::default());
    values.set("between", Value::Between(Attach::on("drum"), Attach::ground()), None);
    values.set("stiffness", Value::Number(2e6), None);
    values.set("damping", Value::Number(300.0), None);
    params.set("kxy", 1e5);
    assert!(BearingLinear::build(&values, &mut params, &mut d).is_some() && d.0.is_empty());
    let is = |name: &str, x: f64| params.get(name) == Some(x);
    assert!(is("kxx", 2e6) && is("kyy", 2e6) && is("cxx", 300.0) && is("cyy", 300.0) && is("kxy", 1e5));
    let (_, text) = build(|v, p| {
        v.set("stiffness", Value::Number(2e6), None);
        p.set("kyy", 1e6);
    });
    assert!(text.len() == 1 && text[0].starts_with("stiffness is given beside kyy"), "{text:?}");
}

#[test]
fn beyond_its_ends_a_table_holds_or_goes_straight_on() {
    let p = table().params();
    let kxx = |beyond, speed| BearingLinear::tabulated(link(), table().beyond(beyond)).coefficients(&p, speed);
    let end = kxx(Beyond::Hold, 600.0 - 1e-6).slope[0];
    let (held, straight) = (kxx(Beyond::Hold, 700.0), kxx(Beyond::Linear, 700.0));
    assert!((held.value[0] - 3.5e6).abs() < 1e-3 && held.slope[0] == 0.0);
    assert!((straight.value[0] - 3.5e6 - 100.0 * end).abs() < 1.0 && (straight.slope[0] - end).abs() < 1e-2);
    assert!((kxx(Beyond::Linear, 200.0).value[0] - 3e6).abs() < 1e-6);
    let stated = BearingLinear::tabulated(link(), table()).tabulated().unwrap();
    assert_eq!((stated.from, stated.to, stated.beyond), (50.0, 600.0, Beyond::Refuse));
}
