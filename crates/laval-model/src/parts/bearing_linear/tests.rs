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
/// Four speeds and three frequencies, frequency by frequency.
pub(super) fn grid() -> Table {
    let (speeds, frequencies) = ([100.0, 250.0, 400.0, 600.0], [0.0, 150.0, 700.0]);
    let pairs: Vec<(f64, f64)> = frequencies.iter().flat_map(|f| speeds.iter().map(move |w| (*w, *f))).collect();
    grid_of(&pairs)
}
/// Smooth coefficients at pairs of speed and frequency.
fn grid_of(pairs: &[(f64, f64)]) -> Table {
    let of = |f: fn(f64, f64) -> f64| Some(pairs.iter().map(|p| f(p.0 / 100.0, p.1 / 100.0)).collect::<Vec<f64>>());
    let columns = |name: &str| match name {
        "frequency" => Some(pairs.iter().map(|p| p.1).collect()),
        "kxx" => of(|w, f| 1e6 * (1.0 + 0.2 * w + 0.1 * w * w + 0.1 * f + 0.05 * f * f)),
        "kxy" => of(|w, f| 1e5 * (1.0 + w) * (1.0 + 0.1 * f)),
        "kyx" => of(|w, f| -2e5 * (1.0 + 0.3 * w + 0.05 * f + 0.02 * f * f)),
        "kyy" => of(|w, f| 2e6 * (1.0 + 0.1 * w - 0.03 * f)),
        "cxx" => of(|w, f| 900.0 / (1.0 + 0.1 * f + 0.2 * w)),
        "cyy" => of(|w, f| 700.0 - 20.0 * f - 10.0 * w * w),
        _ => None,
    };
    Table::new(&pairs.iter().map(|p| p.0).collect::<Vec<f64>>(), columns).unwrap()
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

/// Both ends belong to a table, whatever rounding makes of them; what lies a millionth beyond does not.
#[test]
fn the_ends_of_a_table_are_inside() {
    for k in 1..200 {
        let rpm = std::f64::consts::TAU / 60.0;
        let (first, last) = (f64::from(10 * k) * rpm, f64::from(1000 * k + 7) * rpm);
        let table = Table::new(&[first, last], |name| name.starts_with("kxx").then(|| vec![1e6, 2e6])).unwrap();
        let (p, bearing) = (table.params(), BearingLinear::tabulated(link(), table));
        for (speed, inside) in [(first, true), (last, true), (first * (1.0 - 1e-4), false), (last * (1.0 + 1e-6), false)] {
            let at = At { q: &[0.0; 2], v: &[0.0; 2], a: &[0.0; 2], z: &[], phase: 0.0, speed, spin_accel: 0.0, t: 0.0 };
            let mut v = Vec::new();
            bearing.validity(&p, &at, &mut v);
            assert_eq!(v[0].ratio <= 1.0, inside, "{first} {last} {speed}");
        }
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

fn pairs() -> Vec<(f64, f64)> {
    [100.0, 250.0, 400.0, 600.0].iter().flat_map(|w| [0.0, 150.0, 700.0].map(|f| (*w, f))).collect()
}
/// Coefficients of a table at a speed and a frequency.
fn at(table: &Table, speed: f64, frequency: f64) -> [f64; 8] {
    table.values(&table.params().rows, speed, frequency)
}

/// The rows may come speed by speed, frequency by frequency, or from the last to the first; a parameter is that of its row.
#[test]
fn a_grid_is_read_in_any_order() {
    let (mut by_speed, rest) = (pairs(), grid());
    let first = grid_of(&by_speed);
    by_speed.reverse();
    let last = grid_of(&by_speed);
    for (speed, frequency) in [(100.0, 0.0), (180.0, 90.0), (430.0, 699.0), (600.0, 150.0)] {
        assert_eq!(at(&first, speed, frequency), at(&rest, speed, frequency));
        assert_eq!(at(&first, speed, frequency), at(&last, speed, frequency));
    }
    let row = by_speed.iter().position(|p| *p == (250.0, 150.0)).unwrap();
    let mut params = last.params();
    params.rows[row].kxx = 7e6;
    assert!((last.values(&params.rows, 250.0, 150.0)[0] - 7e6).abs() < 1e-8);
}

/// What does not depend on the frequency is the table over the speed, to the last digit; at a row it is the row.
#[test]
fn a_table_that_is_constant_over_frequency_is_the_table_over_speed() {
    let plain = table();
    let speeds = [50.0, 200.0, 350.0, 600.0];
    let all: Vec<(usize, f64)> = (0..4).flat_map(|k| [10.0, 80.0, 300.0].map(|f| (k, f))).collect();
    let rows = plain.params().rows;
    let columns = |name: &str| match name {
        "frequency" => Some(all.iter().map(|p| p.1).collect()),
        _ => NAMES.iter().position(|n| *n == name).map(|i| {
            all.iter()
                .map(|p| {
                    use laval_num::interpolate::Ordinates;
                    table::Column(&rows, i).at(p.0)
                })
                .collect::<Vec<f64>>()
        }),
    };
    let over = Table::new(&all.iter().map(|p| speeds[p.0]).collect::<Vec<_>>(), columns).unwrap();
    for rule in [Beyond::Hold, Beyond::Linear] {
        let (plain, over) = (plain.clone().beyond(rule), over.clone().beyond(rule));
        for speed in [20.0, 50.0, 77.0, 351.0, 599.0, 700.0] {
            for frequency in [0.0, 10.0, 44.0, 300.0, 900.0] {
                assert_eq!(at(&plain, speed, frequency), at(&over, speed, frequency), "{speed} {frequency}");
            }
        }
    }
}

/// Between the rows first over the frequency at each speed, then over the speed; outside by the rule of the table in both directions.
#[test]
fn a_grid_is_interpolated_over_frequency_first() {
    use laval_num::interpolate::Interpolant;
    let (table, rows) = (grid(), grid().params().rows);
    let (speeds, frequencies) = ([100.0, 250.0, 400.0, 600.0], [0.0, 150.0, 700.0]);
    let by_hand = |w: f64, f: f64, straight: bool| {
        let through = |x: &[f64], y: &[f64], at: f64| {
            let i = Interpolant::new(x, y).unwrap();
            if straight { i.straight_outside().value(at) } else { i.value(at) }
        };
        // frequency by frequency, four speeds each
        let at_speed = |k: usize| through(&frequencies, &[0, 1, 2].map(|j| rows[4 * j + k].cxx), f);
        through(&speeds, &[0, 1, 2, 3].map(at_speed), w)
    };
    for (w, f) in [(100.0, 0.0), (333.0, 420.0), (590.0, 20.0), (700.0, 300.0), (300.0, 900.0), (90.0, 800.0)] {
        for rule in [Beyond::Hold, Beyond::Linear] {
            let (found, wanted) = (at(&table.clone().beyond(rule), w, f)[4], by_hand(w, f, rule == Beyond::Linear));
            assert!((found - wanted).abs() < 1e-12 * wanted.abs(), "{w} {f} {rule:?}: {found} {wanted}");
        }
    }
}

/// With the frequency held it is a linear bearing with the coefficients there, and the dynamic stiffness is the same at that frequency; derivatives over every row too.
#[test]
fn frozen_it_is_the_linear_bearing_of_one_frequency() {
    use crate::model::erased::D1;
    use crate::model::params::Family as _;
    let bearing = BearingLinear::tabulated(link(), grid());
    let p = grid().params();
    assert_eq!(bearing.physics(), Physics::Frequency(TimeForm::None("its coefficients are a table over the frequency of vibration")));
    let stated = FrequencyDomain::frequencies(&bearing).unwrap();
    assert_eq!((stated.from, stated.to, stated.beyond), (0.0, 700.0, Beyond::Refuse));
    for (speed, frequency) in [(120.0, 60.0), (380.0, 380.0), (599.0, 10.0)] {
        for form in [Frozen::At(frequency), Frozen::Order(frequency / speed)] {
            let frozen = FrequencyDomain::frozen(&bearing, form).unwrap();
            assert!(Part::frequency_domain(&frozen).is_none() && frozen.physics() == Physics::Linear);
            let mut b = Blocks::default();
            b.reset(2, 0, speed);
            frozen.linear(&p, speed, &mut b);
            let s = c(0.0, frequency);
            let (linear, mut z) = (local_stiffness(&b, s).unwrap(), vec![Complex::zero(); 4]);
            FrequencyDomain::impedance(&bearing, &p, s, speed, &mut z);
            for (a, b) in linear.data().iter().zip(&z) {
                assert!((*a - *b).abs() <= 1e-14 * b.abs(), "{a:?} {b:?}");
            }
        }
    }
    // over the frequency and over each row against differences
    let flat = <BearingLinear as crate::model::params::Parametric>::Family::to_vec(&p);
    let z = |v: &[f64], f: f64| {
        let mut out = vec![Complex::zero(); 4];
        FrequencyDomain::impedance(&bearing, &crate::model::params::Parametric::given(&bearing, v), c(0.0, f), 300.0, &mut out);
        out
    };
    let seeded = |at: Option<usize>, f: f64| {
        let mut v: Vec<D1> = flat.iter().map(|x| D1::lift(*x)).collect();
        at.iter().for_each(|&i| v[i].eps = [1.0]);
        let s = c(D1::zero(), D1 { re: f, eps: [if at.is_none() { 1.0 } else { 0.0 }] });
        let mut out = vec![Complex::<D1>::zero(); 4];
        FrequencyDomain::impedance(&bearing, &crate::model::params::Parametric::given(&bearing, &v), s, D1::lift(300.0), &mut out);
        out.iter().map(|z| c(z.re.eps[0], z.im.eps[0])).collect::<Vec<_>>()
    };
    let close = |exact: &[Complex<f64>], a: &[Complex<f64>], b: &[Complex<f64>], h: f64, what: &str| {
        for ((e, a), b) in exact.iter().zip(a).zip(b) {
            let difference = (*a - *b).scale(0.5 / h);
            assert!((*e - difference).abs() <= 1e-6 * difference.abs() + 1e-6, "{what}: {e:?} {difference:?}");
        }
    };
    for f in [60.0, 333.0] {
        close(&seeded(None, f), &z(&flat, f + 0.01), &z(&flat, f - 0.01), 0.01, "frequency");
        for i in (10..flat.len()).filter(|&i| flat[i] != 0.0) {
            let h = 1e-4 * flat[i].abs();
            let moved = |d: f64| {
                let mut v = flat.clone();
                v[i] += d;
                z(&v, f)
            };
            close(&seeded(Some(i), f), &moved(h), &moved(-h), h, &format!("row value {i}"));
        }
    }
}

#[test]
fn mistakes_of_a_grid_are_reported() {
    let columns = |speed: &[f64], frequency: &[f64]| {
        Value::Columns(BTreeMap::from([
            ("speed", speed.to_vec()),
            ("frequency", frequency.to_vec()),
            ("kxx", vec![1e6; speed.len()]),
            ("kyy", vec![1e6; speed.len()]),
        ]))
    };
    let said = |speed: &[f64], frequency: &[f64]| {
        let (part, text) = build(|v, _| v.set("table", columns(speed, frequency), None));
        assert_eq!(part.is_none(), !text.is_empty());
        text
    };
    assert!(said(&[200.0, 100.0, 100.0, 200.0], &[50.0, 50.0, 0.0, 0.0]).is_empty());
    let missing = said(&[100.0, 100.0, 200.0], &[0.0, 50.0, 50.0]);
    assert_eq!(missing.len(), 1);
    assert!(missing[0].contains("4 rows: that of 200 rad/s (1910 rpm) at 0 rad/s") && missing[0].ends_with("is missing"), "{missing:?}");
    let several = said(&[100.0, 100.0, 200.0, 300.0], &[0.0, 50.0, 70.0, 50.0]);
    assert!(several[0].contains("9 rows: 5 are missing, the first of 100 rad/s"), "{several:?}");
    let twice = said(&[100.0, 100.0, 200.0, 200.0, 100.0], &[0.0, 50.0, 0.0, 50.0, 50.0]);
    assert!(twice.len() == 1 && twice[0].contains("rows 2 and 5 are of one speed and frequency: 100 rad/s"), "{twice:?}");
    let one = said(&[100.0, 200.0], &[50.0, 50.0]);
    assert!(one[0].contains("at least two frequencies"), "{one:?}");
    let speed = said(&[100.0, 100.0], &[10.0, 50.0]);
    assert!(speed[0].contains("at least two speeds"), "{speed:?}");
    let negative = said(&[100.0, 100.0, 200.0, 200.0], &[-5.0, 50.0, -5.0, 50.0]);
    assert!(negative.len() == 1 && negative[0].contains("frequencies of vibration are not negative: row 1 has -5 rad/s"), "{negative:?}");
    let nan = said(&[100.0, 100.0, 200.0, 200.0], &[f64::NAN, 50.0, 5.0, 50.0]);
    assert_eq!(nan, ["column frequency: row 1 is not a finite number"]);
    let short = said(&[100.0, 100.0, 200.0, 200.0], &[5.0, 50.0]);
    assert_eq!(short, ["column frequency has 2 rows and column speed has 4"]);
}
