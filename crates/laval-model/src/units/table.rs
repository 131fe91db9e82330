//! Known units, prefixes, and the dimensions in words.

use super::{Dimension, Unit, parse_unit};
use crate::diagnostic::nearest;
use crate::text;
use crate::text::{Arg, Argument};
use std::f64::consts::{PI, TAU};
use std::sync::OnceLock;

/// Which prefixes a unit takes.
#[derive(Clone, Copy, PartialEq)]
enum Prefix {
    No,
    /// Powers of a thousand.
    Si,
    /// Also c, d, h.
    Fine,
    /// Only c and m.
    Small,
}

struct Atom {
    name: &'static str,
    mantissa: f64,
    exp10: i32,
    dim: [i8; 6],
    prefix: Prefix,
}

const fn u(name: &'static str, mantissa: f64, exp10: i32, dim: [i8; 6], prefix: Prefix) -> Atom {
    Atom { name, mantissa, exp10, dim, prefix }
}

use Prefix::{Fine, No, Si, Small};

//                                                 kg  m  s  A  K rad
const NUMBER: [i8; 6] = [0; 6];
const MASS: [i8; 6] = [1, 0, 0, 0, 0, 0];
const LENGTH: [i8; 6] = [0, 1, 0, 0, 0, 0];
const TIME: [i8; 6] = [0, 0, 1, 0, 0, 0];
const ANGLE: [i8; 6] = [0, 0, 0, 0, 0, 1];
const SPEED: [i8; 6] = [0, 0, -1, 0, 0, 1];
const FORCE: [i8; 6] = [1, 1, -2, 0, 0, 0];
const PRESSURE: [i8; 6] = [1, -1, -2, 0, 0, 0];
const ENERGY: [i8; 6] = [1, 2, -2, 0, 0, 0];
const POWER: [i8; 6] = [1, 2, -3, 0, 0, 0];
const IMPULSE: [i8; 6] = [1, 1, -1, 0, 0, 0];

#[rustfmt::skip]
static ATOMS: &[Atom] = &[
    u("m", 1.0, 0, LENGTH, Fine), u("g", 1.0, -3, MASS, Si), u("s", 1.0, 0, TIME, Si), u("N", 1.0, 0, FORCE, Si),
    u("rad", 1.0, 0, ANGLE, Si), u("rpm", TAU / 60.0, 0, SPEED, Si), u("Hz", TAU, 0, SPEED, Si), u("Pa", 1.0, 0, PRESSURE, Fine),
    u("deg", PI / 180.0, 0, ANGLE, No), u("°", PI / 180.0, 0, ANGLE, No), u("rev", TAU, 0, ANGLE, No), u("turn", TAU, 0, ANGLE, No),
    u("arcmin", PI / 10800.0, 0, ANGLE, No), u("arcsec", PI / 648000.0, 0, ANGLE, No),
    u("min", 60.0, 0, TIME, No), u("h", 3600.0, 0, TIME, No), u("t", 1.0, 3, MASS, No), u("l", 1.0, -3, [0, 3, 0, 0, 0, 0], Fine),
    u("L", 1.0, -3, [0, 3, 0, 0, 0, 0], Fine), u("bar", 1.0, 5, PRESSURE, Si), u("%", 1.0, -2, NUMBER, No), u("‰", 1.0, -3, NUMBER, No),
    u("W", 1.0, 0, POWER, Si), u("J", 1.0, 0, ENERGY, Si), u("Wh", 3600.0, 0, ENERGY, Si), u("K", 1.0, 0, [0, 0, 0, 0, 1, 0], Si),
    u("degC", 1.0, 0, [0, 0, 0, 0, 1, 0], No), u("°C", 1.0, 0, [0, 0, 0, 0, 1, 0], No),
    u("Nm", 1.0, 0, ENERGY, Si), u("Nmm", 1.0, -3, ENERGY, Si), u("Ns", 1.0, 0, IMPULSE, Si),
    u("P", 1.0, -1, [1, -1, -1, 0, 0, 0], Small), u("St", 1.0, -4, [0, 2, -1, 0, 0, 0], Small),
    u("A", 1.0, 0, [0, 0, 0, 1, 0, 0], Si), u("V", 1.0, 0, [1, 2, -3, -1, 0, 0], Si), u("Ohm", 1.0, 0, [1, 2, -3, -2, 0, 0], Si),
    u("ohm", 1.0, 0, [1, 2, -3, -2, 0, 0], Si), u("Ω", 1.0, 0, [1, 2, -3, -2, 0, 0], Si), u("Ω", 1.0, 0, [1, 2, -3, -2, 0, 0], Si),
    u("H", 1.0, 0, [1, 2, -2, -2, 0, 0], Si), u("Wb", 1.0, 0, [1, 2, -2, -1, 0, 0], Si), u("T", 1.0, 0, [1, 0, -2, -1, 0, 0], Si),
    u("in", 2.54, -2, LENGTH, No), u("inch", 2.54, -2, LENGTH, No), u("ft", 0.3048, 0, LENGTH, No), u("mil", 2.54, -5, LENGTH, No),
    u("thou", 2.54, -5, LENGTH, No), u("lb", 0.45359237, 0, MASS, No), u("oz", 0.028349523125, 0, MASS, No), u("slug", 14.593902937206365, 0, MASS, No),
    u("lbf", 4.4482216152605, 0, FORCE, No), u("kgf", 9.80665, 0, FORCE, No), u("psi", 6894.757293168361, 0, PRESSURE, No),
    u("atm", 101325.0, 0, PRESSURE, No), u("gn", 9.80665, 0, [0, 1, -2, 0, 0, 0], No),
];

const PREFIXES: &[(&str, i32, bool)] = &[
    ("m", -3, true),
    ("k", 3, false),
    ("M", 6, false),
    ("G", 9, false),
    ("µ", -6, false),
    ("μ", -6, false),
    ("u", -6, false),
    ("n", -9, false),
    ("p", -12, false),
    ("T", 12, false),
    ("c", -2, true),
    ("d", -1, true),
    ("h", 2, true),
];

fn exact(word: &str) -> Option<&'static Atom> {
    ATOMS.iter().find(|a| a.name == word)
}

fn unit_of(a: &Atom, shift: i32) -> Unit {
    let cycles = if a.name == "Hz" { 1.0 } else { 0.0 };
    let joules = if matches!(a.name, "J" | "Wh" | "W") { 1.0 } else { 0.0 };
    let offset = if matches!(a.name, "degC" | "°C") { 273.15 } else { 0.0 };
    Unit { mantissa: a.mantissa, exp10: a.exp10 + shift, dimension: Dimension(a.dim.map(f64::from)), cycles, joules, offset }
}

/// The unit of one word, with its prefix.
pub(super) fn lookup(word: &str) -> Option<Unit> {
    if let Some(a) = exact(word) {
        return Some(unit_of(a, 0));
    }
    for &(p, shift, _) in PREFIXES {
        let Some(rest) = word.strip_prefix(p) else { continue };
        let Some(a) = exact(rest) else { continue };
        let allowed = match a.prefix {
            No => false,
            Si => !matches!(p, "c" | "d" | "h"),
            Fine => true,
            Small => matches!(p, "c" | "m"),
        };
        if allowed {
            return Some(unit_of(a, shift));
        }
    }
    None
}

/// A unit as the documentation lists it.
pub struct Listed {
    /// The word that is written.
    pub name: &'static str,
    /// Value of one in SI units.
    pub si: f64,
    /// SI unit of the value.
    pub si_unit: String,
    /// Added after scaling, for temperatures.
    pub offset: f64,
    /// Prefixes it takes, as they are written; `u` stands for `µ`.
    pub prefixes: &'static str,
}

/// All units that are read. One that has two spellings is listed with each.
pub fn list() -> Vec<Listed> {
    let of = |a: &'static Atom| {
        let unit = unit_of(a, 0);
        let prefixes = match a.prefix {
            No => "",
            Small => "c m",
            Si => "p n u m k M G T",
            Fine => "p n u m c d h k M G T",
        };
        Listed { name: a.name, si: unit.factor(), si_unit: unit.dimension.si_text(), offset: unit.offset, prefixes }
    };
    ATOMS.iter().map(of).collect()
}

/// SI unit of every quantity that has a word, the word, and units a person would write.
pub fn quantities() -> &'static [(&'static str, &'static str, &'static str)] {
    WORDS
}

/// What an unknown word probably means: two units written together, other capitals, a slip of the pen.
pub(super) fn suggest(word: &str) -> Option<String> {
    if word.len() > 24 {
        return None;
    }
    let lower = word.to_lowercase();
    let spelled = match lower.as_str() {
        "rps" => Some("rev/s"),
        "degree" | "degrees" | "grad" => Some("deg"),
        "kmh" | "kph" => Some("km/h"),
        "sec" | "second" | "seconds" => Some("s"),
        "meter" | "metre" | "meters" | "metres" => Some("m"),
        "micron" | "microns" => Some("µm"),
        "liter" | "litre" | "liters" | "litres" => Some("l"),
        "hour" | "hours" | "hr" => Some("h"),
        "kilo" | "kgs" => Some("kg"),
        "slugs" => Some("slug"),
        "lbs" | "lbm" | "pound" | "pounds" => Some("lb"),
        "lbsf" => Some("lbf"),
        "newton" | "newtons" => Some("N"),
        "c" | "celsius" => Some("degC"),
        "percent" => Some("%"),
        "g's" | "gee" => Some("gn"),
        _ => None,
    };
    if let Some(s) = spelled {
        return Some(s.to_string());
    }
    let known: Vec<String> = ATOMS.iter().map(|a| a.name.to_string()).chain(common()).collect();
    if let Some(k) = known.iter().find(|k| k.to_lowercase() == lower) {
        return Some(k.clone());
    }
    for (i, _) in word.char_indices().skip(1) {
        let (a, b) = word.split_at(i);
        if lookup(a).is_some() && lookup(b).is_some() {
            return Some(format!("{a} {b}"));
        }
    }
    nearest(word, known.iter().map(String::as_str)).map(str::to_string)
}

fn common() -> impl Iterator<Item = String> {
    [
        "kg", "mm", "µm", "cm", "km", "ms", "kN", "MN", "kPa", "MPa", "GPa", "mPa", "kW", "MW", "kHz", "mrad", "ml", "cSt", "cP", "mbar",
        "kJ", "kNm", "mA", "mH",
    ]
    .into_iter()
    .map(String::from)
}

/// SI unit, the dimension in words, units a person would write (the first one in examples).
#[rustfmt::skip]
static WORDS: &[(&str, &str, &str)] = &[
    ("", "a pure number", "0.5, 50 %"),
    ("rad/s", "a speed", "rad/s, rpm, Hz"), ("m", "a length", "mm, m, µm"), ("kg", "a mass", "kg, g, t"), ("s", "a time", "s, ms, min"),
    ("rad", "an angle", "deg, rad"), ("N", "a force", "N, kN"), ("N/m", "a stiffness", "N/m, N/mm, MN/m"),
    ("N s/m", "a damping constant", "N s/m, kN s/m"), ("N/m^3", "a cubic stiffness", "N/m^3, N/mm^3"),
    ("N/m^1.5", "a Hertz contact stiffness", "N/m^1.5, N/mm^1.5"), ("N/m^2", "a pressure", "bar, MPa, Pa"), ("Pa", "a pressure", "bar, MPa, Pa"),
    ("N m/rad", "a rotational stiffness", "N m/rad, N m/deg"), ("N m s/rad", "a rotational damping constant", "N m s/rad"),
    ("N m", "a torque", "N m, kN m"), ("J", "an energy", "J, kJ"), ("W", "a power", "kW, W"), ("kg m", "an unbalance", "g mm, kg mm, kg m"),
    ("kg m^2", "a moment of inertia", "kg m^2, kg mm^2"), ("m^2", "an area", "mm^2, m^2"), ("m^3", "a volume", "l, ml, m^3"),
    ("m^4", "a second moment of area", "mm^4, m^4"), ("kg/m^3", "a density", "kg/m^3, g/cm^3"), ("kg/m", "a mass per length", "kg/m"),
    ("m/s", "a velocity", "m/s, mm/s"), ("m/s^2", "an acceleration", "m/s^2, gn"), ("rad/s^2", "an angular acceleration", "rad/s^2, rpm/s"),
    ("1/s", "a rate", "1/s, 1/min"), ("1/s^2", "a rate squared", "1/s^2"), ("1/m", "a number per length", "1/m, 1/mm"),
    ("1/m^2", "a number per area", "1/m^2, 1/mm^2"), ("Pa s", "a dynamic viscosity", "mPa s, Pa s, cP"),
    ("m^2/s", "a kinematic viscosity", "cSt, mm^2/s, m^2/s"), ("m^3/s", "a volume flow", "l/min, l/h, m^3/h"),
    ("K", "a temperature", "degC, K"), ("1/K", "a coefficient per kelvin", "1/K"), ("W/K", "a heat conductance", "W/K"),
    ("J/K", "a heat capacity", "J/K, kJ/K"), ("A", "a current", "A, mA"), ("V", "a voltage", "V, kV"), ("Ohm", "a resistance", "Ohm, mOhm"),
    ("H", "an inductance", "mH, H"), ("N/A", "a force per current", "N/A"), ("N m/A", "a torque per current", "N m/A"),
    ("V s/rad", "a voltage constant", "V s/rad, V/rpm"), ("N s", "an impulse", "N s"), ("N/m^4", "a stiffness density gradient", "N/m^4"),
    ("N m s^2/rad^2", "a torque over the square of a speed", "N m s^2/rad^2, N m/rpm^2"), ("N m s", "an angular momentum", "N m s"), ("rad/m", "an angle per length", "rad/m, deg/m"),
];

fn words() -> &'static [(Dimension, f64, usize)] {
    static PARSED: OnceLock<Vec<(Dimension, f64, usize)>> = OnceLock::new();
    PARSED.get_or_init(|| {
        let unit = |(i, w): (usize, &(&str, &str, &str))| parse_unit(w.0).ok().map(|u| (u.dimension, u.joules, i));
        WORDS.iter().enumerate().filter_map(unit).collect()
    })
}

fn entry(d: &Dimension, joules: f64) -> Option<&'static (&'static str, &'static str, &'static str)> {
    let fits = |j: bool| words().iter().find(|w| w.0.same(d) && (!j || (w.1 - joules).abs() < 1e-9)).map(|w| &WORDS[w.2]);
    fits(true).or_else(|| fits(false))
}

fn entry_of(unit: &str) -> Option<&'static (&'static str, &'static str, &'static str)> {
    WORDS.iter().find(|w| w.0 == unit).or_else(|| parse_unit(unit).ok().and_then(|u| entry(&u.dimension, u.joules)))
}

fn in_unit(unit: &str) -> Arg {
    text!("a quantity in {unit}", unit).argument()
}

/// The dimension of a unit in words, for instance "a length".
pub fn describe(unit: &str) -> Arg {
    entry_of(unit).map_or_else(|| in_unit(unit), |w| text::term(w.1))
}

/// Units a person would write for the unit, for instance "mm, m, µm".
pub fn examples(unit: &str) -> &str {
    match entry_of(unit) {
        Some(w) => w.2,
        None => unit,
    }
}

pub(super) fn describe_dimension(d: &Dimension, joules: f64) -> Arg {
    entry(d, joules).map_or_else(|| in_unit(&d.si_text()), |w| text::term(w.1))
}
