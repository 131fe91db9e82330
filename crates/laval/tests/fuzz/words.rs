//! Values as texts: usual ones, extreme ones, and what is none.

use crate::generate::Random;
use laval::model::field::Bounds;

/// Numbers that break careless arithmetic.
pub const EXTREME: [f64; 20] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    1e308,
    -1e308,
    1e-308,
    5e-324,
    1e154,
    1e-154,
    1e100,
    1e-100,
    1e20,
    1e-20,
    1e9,
    1e-9,
    1e6,
    1e-6,
    0.5,
    1.0000000000000002,
];
/// Values that are none, or not of the type wanted.
pub const ODD: [&str; 30] = [
    "nan",
    "inf",
    "-inf",
    "\"nan m\"",
    "\"-inf kg\"",
    "\"1e999 N/m\"",
    "1e308",
    "\"1e308 km\"",
    "\"\"",
    "\" \"",
    "\"1\"",
    "\"m\"",
    "\"1 m/s\"",
    "\"1 N/m\"",
    "\"3000 rpm\"",
    "true",
    "[]",
    "[[]]",
    "{}",
    "[1, nan]",
    "{ x = 1 }",
    "{ from = 1, to = 2, points = 1000000000 }",
    "1979-05-27",
    "\"\u{b5}\u{b5}m\"",
    "\"1 \u{3a9}\u{1f980}\"",
    "\"ground\"",
    "9223372036854775807",
    "-9223372036854775808",
    "\"1 m^99999999999\"",
    "\"auto\"",
];
const UNITS: [&str; 26] = [
    "m", "mm", "um", "kg", "g", "t", "N/m", "N/mm", "kN/m", "N s/m", "rpm", "rad/s", "Hz", "deg", "rad", "s", "ms", "kg/m^3", "N m",
    "kg m^2", "g mm", "1/s", "N/m^3", "%", "ft", "lbf",
];

/// TOML wants a digit after the point and no `inf` by accident.
pub fn literal(x: f64) -> String {
    if x.is_nan() {
        "nan".into()
    } else if x.is_infinite() {
        if x > 0.0 { "inf" } else { "-inf" }.into()
    } else {
        format!("{x:e}").replace('e', ".0e").replacen(".0e", if format!("{x:e}").contains('.') { "e" } else { ".0e" }, 1)
    }
}

/// A size of the unit that machines have, spread over a few decades.
pub fn usual(r: &mut Random, unit: &str) -> f64 {
    let (lo, hi) = match unit {
        "kg" => (0.1, 100.0),
        "m" => (1e-5, 0.1),
        "N/m" => (1e4, 1e8),
        "N/m^3" => (1e8, 1e12),
        "N/m^1.5" => (1e8, 1e10),
        "N s/m" => (1.0, 1e4),
        "rad/s" => (1.0, 2000.0),
        "rad" => (1e-4, 3.0),
        "kg m" => (1e-6, 1e-3),
        "kg m^2" => (1e-3, 1.0),
        "kg/m^3" => (500.0, 2000.0),
        "s" => (1e-3, 1.0),
        "1/s" => (0.01, 10.0),
        _ => (0.01, 1.0),
    };
    10f64.powf(f64::log10(lo) + r.unit() * f64::log10(hi / lo))
}

pub fn number(r: &mut Random, hostility: usize, unit: &str, bounds: &Bounds) -> f64 {
    let extreme = EXTREME[r.below(EXTREME.len())];
    let sane = usual(r, unit).min(bounds.max);
    match hostility {
        0 => sane,
        1 => match r.below(6) {
            0 if bounds.max.is_finite() => bounds.max,
            1 if bounds.contains(bounds.min) => bounds.min,
            2 | 3 if bounds.contains(extreme) => extreme,
            _ => sane,
        },
        _ if r.chance(15) => extreme,
        _ if r.chance(10) => -sane,
        _ => sane,
    }
}

pub fn quantity(r: &mut Random, hostility: usize, unit: &str, bounds: &Bounds) -> String {
    let x = literal(number(r, hostility, unit, bounds));
    match r.below(20) {
        0 if hostility == 2 => format!("\"{x} {}\"", r.of(&UNITS)),
        1..8 if !unit.is_empty() => format!("\"{x} {unit}\""),
        _ => x,
    }
}

pub fn point(r: &mut Random, hostility: usize, names: &[String]) -> String {
    let body = match r.below(30 + 20 * (2 - hostility)) {
        0 => "nobody",
        1 => names.last().map_or("", String::as_str),
        2 => "",
        n if n % 3 == 0 => "ground",
        n if n % 3 == 1 && names.len() > 1 => names[1].as_str(),
        _ => names.first().map_or("drum", String::as_str),
    };
    if r.chance(10) {
        return format!("{{ body = \"{body}\", at = {} }}", quantity(r, hostility, "m", &Bounds::within(1e4)));
    }
    format!("\"{body}\"")
}

pub fn range(r: &mut Random, hostility: usize, unit: &str, bounds: &Bounds, head: &str) -> String {
    let (mut a, mut b) = (number(r, hostility, unit, bounds), number(r, hostility, unit, bounds));
    if a > b && !r.chance(5) {
        (a, b) = (b, a);
    }
    let points = match r.below(10) {
        0 if hostility > 0 => ", points = 1000000",
        1 if hostility > 1 => ", points = 1000000000",
        2 | 6 | 7 | 8 => ", points = 2",
        3 | 4 => ", points = 17",
        5 => ", points = 300",
        _ => "",
    };
    format!("{{ {head}from = {}, to = {}{points} }}", literal(a), literal(b))
}

pub fn list(r: &mut Random, hostility: usize, unit: &str, bounds: &Bounds, ordered: bool) -> String {
    let mut values: Vec<f64> = (0..1 + r.below(4)).map(|_| number(r, hostility, unit, bounds)).collect();
    if ordered {
        values.sort_by(f64::total_cmp);
    }
    format!("[{}]", values.iter().map(|x| literal(*x)).collect::<Vec<_>>().join(", "))
}

/// The first number in a value replaced by an extreme one.
pub fn other_number(r: &mut Random, value: &str) -> String {
    let Some(start) = value.find(|c: char| c.is_ascii_digit()) else { return value.to_string() };
    let length = value[start..].find(|c: char| !(c.is_ascii_digit() || matches!(c, '.' | 'e' | '-'))).unwrap_or(value.len() - start);
    let x = EXTREME[r.below(EXTREME.len())];
    format!("{}{}{}", &value[..start], literal(x), &value[start + length..])
}

/// The unit at the end of a quoted quantity replaced by another.
pub fn other_unit(r: &mut Random, value: &str) -> String {
    let Some((number, rest)) = value.split_once(' ').filter(|v| v.0.starts_with('"')) else { return r.of(&ODD).to_string() };
    let tail = rest.split_once('"').map_or("", |t| t.1);
    format!("{number} {}\"{tail}", r.of(&UNITS))
}
