//! Quantities for people, and quantities that read back exactly.

use super::{Dimension, Unit, check_dimension, parse, parse_unit, read_quantity};
use std::f64::consts::{PI, TAU};

/// Units in which values of an SI unit are shown: text and its power of ten in the SI unit, ascending.
fn ladder(unit: &str) -> Vec<(String, i32)> {
    let fixed: &[(&str, i32)] = match unit {
        "m" => &[("nm", -9), ("µm", -6), ("mm", -3), ("m", 0)],
        "kg" => &[("mg", -6), ("g", -3), ("kg", 0)],
        "s" => &[("ns", -9), ("µs", -6), ("ms", -3), ("s", 0)],
        "kg m" => &[("g mm", -6), ("kg mm", -3), ("kg m", 0)],
        "m^3" => &[("ml", -6), ("l", -3), ("m^3", 0)],
        "m^2/s" => &[("mm^2/s", -6), ("m^2/s", 0)],
        "m^2" => &[("mm^2", -6), ("m^2", 0)],
        "m/s" => &[("mm/s", -3), ("m/s", 0)],
        "H" => &[("µH", -6), ("mH", -3), ("H", 0)],
        _ => &[],
    };
    if !fixed.is_empty() {
        return fixed.iter().map(|(t, e)| (t.to_string(), *e)).collect();
    }
    let end = unit.find(|c: char| !c.is_alphabetic()).unwrap_or(unit.len());
    let first = &unit[..end];
    if matches!(first, "N" | "Pa" | "W" | "J" | "V" | "A" | "Ohm") && !unit[end..].starts_with(['^', '2', '3']) {
        return [("µ", -6), ("m", -3), ("", 0), ("k", 3), ("M", 6), ("G", 9)].iter().map(|(p, e)| (format!("{p}{unit}"), *e)).collect();
    }
    vec![(unit.to_string(), 0)]
}

/// The rung on which `exponent10` digits before the point read best.
fn rung(unit: &str, exponent: i32) -> (String, i32) {
    let rungs = ladder(unit);
    let plain = rungs.iter().find(|r| r.1 == 0).cloned().unwrap_or((unit.to_string(), 0));
    let (low, high) = (rungs[0].1, rungs[rungs.len() - 1].1);
    if exponent < low - 3 || exponent >= high + 3 && high > 0 {
        return plain;
    }
    rungs.iter().rev().find(|r| exponent >= r.1).unwrap_or(&rungs[0]).clone()
}

/// Digits and decimal exponent: `d.ddd * 10^e` as ("dddd", e).
fn digits(text: &str) -> (bool, String, i32) {
    let (negative, text) = text.strip_prefix('-').map_or((false, text), |t| (true, t));
    let (m, e) = text.split_once('e').unwrap_or((text, "0"));
    (negative, m.replace('.', ""), e.parse().unwrap_or(0))
}

/// `0.digits` at exponent `e` as a plain decimal where that is short, else in powers of ten.
fn plain(negative: bool, digits: &str, e: i32) -> String {
    let d = digits.trim_end_matches('0');
    let d = if d.is_empty() { "0" } else { d };
    let sign = if negative && d != "0" { "-" } else { "" };
    if d == "0" {
        return "0".into();
    }
    if (0..6).contains(&e) {
        let n = e as usize + 1;
        if d.len() <= n { format!("{sign}{d}{}", "0".repeat(n - d.len())) } else { format!("{sign}{}.{}", &d[..n], &d[n..]) }
    } else if (-4..0).contains(&e) {
        format!("{sign}0.{}{d}", "0".repeat((-e - 1) as usize))
    } else if d.len() == 1 {
        format!("{sign}{d}e{e}")
    } else {
        format!("{sign}{}.{}e{e}", &d[..1], &d[1..])
    }
}

/// A number with at most `significant` digits, for people.
pub fn format_number(x: f64, significant: usize) -> String {
    if !x.is_finite() {
        return if x.is_nan() {
            "not a number"
        } else if x > 0.0 {
            "infinity"
        } else {
            "-infinity"
        }
        .into();
    }
    let (n, d, e) = digits(&format!("{x:.*e}", significant.clamp(1, 17) - 1));
    plain(n, &d, e)
}

/// A length for people, in m, mm or µm: "120 mm".
pub fn format_length(x: f64, significant: usize) -> String {
    // what rounds up to the next unit takes it
    let (factor, unit) = match x.abs() {
        size if size >= 0.99995 || size == 0.0 => (1.0, "m"),
        size if size >= 0.99995e-3 => (1e-3, "mm"),
        _ => (1e-6, "µm"),
    };
    format!("{} {unit}", format_number(x / factor, significant))
}

/// A number as short as it reads back exactly.
pub fn write_number(x: f64) -> String {
    if !x.is_finite() {
        return if x.is_nan() {
            "nan"
        } else if x > 0.0 {
            "inf"
        } else {
            "-inf"
        }
        .into();
    }
    let (n, d, e) = digits(&format!("{x:e}"));
    plain(n, &d, e)
}

/// Significant digits of a value for people.
pub const DIGITS: u8 = 4;

/// A value in SI units for people, with so many digits, a readable prefix, and the usual second unit for speeds and angles:
/// "70 mm", "11 MN/m", "25 rad/s (238.7 rpm)", "333.1 K (60 degC)".
pub fn format_si(x: f64, unit: &str, significant: u8) -> String {
    let n = |x: f64| format_number(x, significant.into());
    if !x.is_finite() || unit.is_empty() {
        return n(x);
    }
    match unit {
        "rad/s" if x != 0.0 => format!("{} rad/s ({} rpm)", n(x), n(x * 60.0 / TAU)),
        "rad" if x != 0.0 => format!("{} rad ({} deg)", n(x), n(x * 180.0 / PI)),
        "K" if x > 0.0 => format!("{} K ({} degC)", n(x), n(x - 273.15)),
        _ => {
            let (neg, d, e) = digits(&format!("{x:.*e}", usize::from(significant.clamp(1, 17)) - 1));
            let (text, shift) = if x == 0.0 { (unit.to_string(), 0) } else { rung(unit, e) };
            format!("{} {text}", plain(neg, &d, e - shift))
        }
    }
}

/// The unit behind the number of a quantity, as it is written there: `mm` of `46.7 mm`. Nothing where it is no quantity or has no unit.
pub fn unit_of(text: &str) -> Option<&str> {
    let number = parse::number(text).ok()?;
    let unit = text[number.rest..].trim();
    parse_unit(unit).ok().filter(|_| !unit.is_empty()).map(|_| unit)
}

/// A value in SI units with so many digits as number and unit: in the first of the units a reader has chosen that measures it readably, else in the first that
/// measures it at all, else with a readable prefix; speeds then in rpm, angles in degrees.
///
/// ```
/// use laval_model::units::read_in;
/// assert_eq!(read_in(&["lbf/in", "in"], 0.0508, "m", 4), ("2".into(), "in".into()));
/// assert_eq!(read_in(&[""; 0], 314.159265, "rad/s", 4), ("3000".into(), "rpm".into()));
/// ```
pub fn read_in(units: &[impl AsRef<str>], x: f64, unit: &str, significant: u8) -> (String, String) {
    let n = |x: f64| format_number(x, significant.into());
    if !x.is_finite() {
        return (n(x), String::new());
    }
    let in_unit = |u: &Unit| (x - u.offset) / u.factor();
    let fitting = |name: &&str| {
        let u = parse_unit(name).ok()?;
        // a rate in Hz is another number than a speed in Hz
        let same = parse_unit(unit).is_ok_and(|si: Unit| dimension_fits(&u.dimension, &si.dimension));
        (same && check_dimension(name, unit).is_ok()).then_some(u)
    };
    let own: Vec<(&str, Unit)> = units.iter().map(AsRef::as_ref).filter_map(|name| Some((name, fitting(&name)?))).collect();
    let readable = |u: &Unit| x == 0.0 || (1e-2..1e5).contains(&in_unit(u).abs());
    if let Some((name, u)) = own.iter().find(|o| readable(&o.1)).or(own.first()) {
        return (n(in_unit(u)), name.to_string());
    }
    match unit {
        "" => (n(x), String::new()),
        "rad/s" => (n(x * 60.0 / TAU), "rpm".into()),
        "rad" => (n(x * 180.0 / PI), "deg".into()),
        "K" if x > 0.0 => (n(x - 273.15), "degC".into()),
        _ => {
            let (neg, d, e) = digits(&format!("{x:.*e}", usize::from(significant.clamp(1, 17)) - 1));
            let (text, shift) = if x == 0.0 { (unit.to_string(), 0) } else { rung(unit, e) };
            (plain(neg, &d, e - shift), text)
        }
    }
}

/// The same dimension; a radian below the line may be left out.
fn dimension_fits(given: &Dimension, si: &Dimension) -> bool {
    const ANGLE: usize = 5;
    let apart = |i: usize| (given.0[i] - si.0[i]).abs() > 1e-9;
    !(0..ANGLE).any(apart) && (!apart(ANGLE) || si.0[ANGLE] < 0.0 && given.0[ANGLE].abs() < 1e-9)
}

/// A value in SI units as a person would write it, which [`read_quantity`] reads back to the very same number; a speed in rpm
/// or an angle in degrees only where that is exact.
pub fn write_si(x: f64, unit: &str) -> String {
    if unit.is_empty() || !x.is_finite() {
        return write_number(x);
    }
    let other = match unit {
        "rad/s" => Some((x * 60.0 / TAU, "rpm")),
        "rad" => Some((x * 180.0 / PI, "deg")),
        _ => None,
    };
    if let Some((y, name)) = other {
        let text = format!("{} {name}", format_number(y, 7));
        let shorter = text.len() <= write_number(x).len() + 1 + unit.len();
        if shorter && read_quantity(&text, unit).is_ok_and(|z| z == x) {
            return text;
        }
    }
    let (neg, d, e) = digits(&format!("{x:e}"));
    let (text, shift) = if x == 0.0 { (unit.to_string(), 0) } else { rung(unit, e) };
    format!("{} {text}", plain(neg, &d, e - shift))
}
