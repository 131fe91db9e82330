//! Quantities as a person writes them, `"3000 rpm"`, `"30 g mm"`, `"1e5 N/m^1.5"`, and back.
//!
//! **What is read.** A number, then a unit: words with prefixes (`k`, `M`, `µ` ...), powers (`m^3`, `m3`, `m³`, `m^1.5`,
//! `m^(10/9)`, `s^-1`), products by a space, `*` or `·`, division by `/`, parentheses. A product behind a division, as in
//! `N/m s`, has two readings and is refused; `N s/m`, `N/(m s)` and `N/m/s` have one.
//!
//! **Angle is a dimension of its own.** `rad/s`, `rpm`, `rev/s` and `deg/s` convert into each other, `60 Hz` as a rotational
//! speed is 2 pi 60 rad/s, and `60 1/s` as a rotational speed is refused, because it may mean either. Where a plain rate in
//! 1/s is wanted, `60 Hz` is 60 1/s and `60 rad/s` is refused. A radian in a denominator has only one reading and may be left
//! out: a rotational stiffness is `N m/rad` or `N m`, a rotational damping `N m s/rad` or `N m s`. Degrees there convert:
//! `1 N m/deg` is 57.3 N m/rad.
//!
//! **A torque is not an energy**: `N m` and `J` are kept apart where nothing else tells them apart.
//!
//! **Temperatures**: `20 degC` is 293.15 K, alone only; in products (`W/K`) the unit is K.
//!
//! Decimal prefixes shift the decimal exponent before the number is rounded, so `"46.7 mm"` is the very number `0.0467`.

mod format;
mod parse;
mod table;

pub use format::{DIGITS, format_length, format_number, format_si, read_in, unit_of, write_number, write_si};
pub use parse::parse_unit;
pub use table::{Listed, describe, examples, list, quantities};

use crate::text;
use crate::text::{Argument, Text};
use std::f64::consts::TAU;
use std::fmt;
use std::ops::Range;

/// Exponents of kg, m, s, A, K and rad.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Dimension(pub [f64; 6]);

impl Dimension {
    /// Equal up to the rounding of fractional exponents.
    pub fn same(&self, other: &Dimension) -> bool {
        self.0.iter().zip(&other.0).all(|(a, b)| (a - b).abs() < 1e-9)
    }
    /// A pure number.
    pub fn is_none(&self) -> bool {
        self.same(&Dimension::default())
    }
    /// In base units, for instance `kg m/s^2`.
    pub fn si_text(&self) -> String {
        let write = |out: &mut String, name: &str, e: f64| {
            if !out.is_empty() {
                out.push(' ');
            }
            out.push_str(name);
            if e != 1.0 {
                out.push('^');
                out.push_str(&write_number(e));
            }
        };
        let names = ["kg", "m", "s", "A", "K", "rad"];
        let (mut top, mut bottom, mut count) = (String::new(), String::new(), 0);
        for (name, &e) in names.iter().zip(&self.0) {
            if e > 1e-9 {
                write(&mut top, name, e);
            } else if e < -1e-9 {
                write(&mut bottom, name, -e);
                count += 1;
            }
        }
        match (top.is_empty(), count) {
            (_, 0) => top,
            (true, 1) => format!("1/{bottom}"),
            (false, 1) => format!("{top}/{bottom}"),
            (true, _) => format!("1/({bottom})"),
            (false, _) => format!("{top}/({bottom})"),
        }
    }
}

/// A unit: `mantissa * 10^exp10` SI units of `dimension`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit {
    /// Factor to SI without its powers of ten.
    pub mantissa: f64,
    /// Power of ten of the factor to SI.
    pub exp10: i32,
    /// Dimension.
    pub dimension: Dimension,
    /// Power of Hz in it: so many of its cycles may be read as turns or as pure counts.
    cycles: f64,
    /// Power of J in it, which tells an energy from a torque.
    joules: f64,
    /// Added after scaling (degC).
    offset: f64,
}

impl Unit {
    const ONE: Unit = Unit { mantissa: 1.0, exp10: 0, dimension: Dimension([0.0; 6]), cycles: 0.0, joules: 0.0, offset: 0.0 };

    /// Factor to SI.
    pub fn factor(&self) -> f64 {
        self.mantissa * 10f64.powi(self.exp10)
    }
    fn times(self, o: Unit, power: f64) -> Unit {
        let mut dimension = self.dimension;
        for (a, b) in dimension.0.iter_mut().zip(&o.dimension.0) {
            *a += b * power;
        }
        let tens = o.exp10 as f64 * power;
        let whole = tens.round();
        let rest = if (tens - whole).abs() < 1e-12 { 1.0 } else { 10f64.powf(tens - whole) };
        let scale = if power == 1.0 { o.mantissa } else { o.mantissa.powf(power) };
        Unit {
            mantissa: self.mantissa * scale * rest,
            exp10: self.exp10 + whole as i32,
            dimension,
            cycles: self.cycles + o.cycles * power,
            joules: self.joules + o.joules * power,
            offset: self.offset + o.offset,
        }
    }
}

/// Why a quantity cannot be read, and where in its text.
#[derive(Clone, Debug, PartialEq)]
pub struct UnitError {
    /// Stable code, as in [`crate::diagnostic::Diagnostic`].
    pub code: &'static str,
    /// One sentence.
    pub message: Text,
    /// What to do about it.
    pub help: Option<Text>,
    /// Bytes of the text that are meant.
    pub range: Range<usize>,
}

impl UnitError {
    fn new(code: &'static str, range: Range<usize>, message: Text) -> Self {
        UnitError { code, message, help: None, range }
    }
    /// What is wrong and what to do about it in one.
    pub fn sentence(self) -> Text {
        match self.help {
            Some(help) => text!("{message} ({help})", message = self.message, help),
            None => self.message,
        }
    }
    fn help(mut self, help: Text) -> Self {
        self.help = Some(help);
        self
    }
}

impl fmt::Display for UnitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.message.fmt(f)?;
        if let Some(help) = &self.help {
            write!(f, " ({help})")?;
        }
        Ok(())
    }
}
impl std::error::Error for UnitError {}

/// Reads `text` as a quantity of the unit `expected` (an SI unit; `""` is a pure number) and returns it in that unit.
///
/// ```
/// use laval_model::units::read_quantity;
/// assert_eq!(read_quantity("46.7 mm", "m").unwrap(), 0.0467);
/// assert_eq!(read_quantity("60 Hz", "rad/s").unwrap(), 60.0 * std::f64::consts::TAU);
/// assert!(read_quantity("3 N", "m").is_err());
/// ```
pub fn read_quantity(text: &str, expected: &str) -> Result<f64, UnitError> {
    read_quantity_in(text, expected, &parse_unit(expected)?)
}

/// [`read_quantity`] with the expected unit already parsed.
pub(crate) fn read_quantity_in(text: &str, expected: &str, wanted: &Unit) -> Result<f64, UnitError> {
    let number = parse::number(text)?;
    let unit_text = &text[number.rest..];
    let start = number.rest + (unit_text.len() - unit_text.trim_start().len());
    let unit_text = unit_text.trim();
    let range = start..start + unit_text.len();
    if unit_text.is_empty() && !wanted.dimension.is_none() {
        let digits = text.trim();
        return Err(UnitError::new(
            "unit.missing",
            0..text.len(),
            text!("{wanted} is needed, and {digits} has no unit", wanted = describe(expected), digits = text::quoted(&digits)),
        )
        .help(text!(
            "write the unit behind the number ({examples}); without quotes a number is in {expected}",
            examples = examples(expected),
            expected
        )));
    }
    let unit = parse::unit_at(unit_text, start)?;
    let cycles = compatible(&unit, wanted).map_err(|why| why.error(text, range, unit_text, &unit, expected))?;
    number.scaled(&unit, if cycles == 0.0 { 1.0 } else { TAU.powf(-cycles) }, wanted)
}

/// Reads a quantity of any dimension: its value in SI base units and its unit.
pub fn read_any(text: &str) -> Result<(f64, Unit), UnitError> {
    let number = parse::number(text)?;
    let unit_text = &text[number.rest..];
    let start = number.rest + (unit_text.len() - unit_text.trim_start().len());
    let unit = parse::unit_at(unit_text.trim(), start)?;
    Ok((number.scaled(&unit, 1.0, &Unit::ONE)?, unit))
}

/// Whether values in the unit `given` may stand where the unit `expected` is wanted; the error is the sentence to show.
pub fn check_dimension(given: &str, expected: &str) -> Result<(), UnitError> {
    let unit = parse_unit(given)?;
    compatible(&unit, &parse_unit(expected)?).map(|_| ()).map_err(|why| why.error(given, 0..given.len(), given, &unit, expected))
}

/// The quantity with pounds of force where pounds of mass stand, when that is what is wanted.
fn pounds_as_force(text: &str, unit_text: &str, expected: &str) -> Option<String> {
    let mut force = String::new();
    let mut rest = unit_text;
    while let Some(at) = rest.find(char::is_alphabetic) {
        let end = rest[at..].find(|c: char| !c.is_alphabetic()).map_or(rest.len(), |e| at + e);
        force.push_str(&rest[..at]);
        force.push_str(match &rest[at..end] {
            "lb" => "lbf",
            word => word,
        });
        rest = &rest[end..];
    }
    force.push_str(rest);
    (force != unit_text && check_dimension(&force, expected).is_ok())
        .then(|| format!("{}{force}", text.strip_suffix(unit_text).unwrap_or_default()))
}

enum Mismatch {
    Dimension,
    /// A rate without angle where a rotational speed is wanted.
    AngleLeftOut,
    Torque,
    Energy,
}

/// Power of 2 pi by which the value must be divided (Hz read as a plain rate), or why the units do not fit.
fn compatible(given: &Unit, wanted: &Unit) -> Result<f64, Mismatch> {
    const ANGLE: usize = 5;
    let (a, b) = (given.dimension.0, wanted.dimension.0);
    if (0..ANGLE).any(|i| (a[i] - b[i]).abs() > 1e-9) {
        return Err(Mismatch::Dimension);
    }
    let extra = a[ANGLE] - b[ANGLE];
    if extra.abs() < 1e-9 {
        let energy = [1.0, 2.0, -2.0, 0.0, 0.0, 0.0];
        return match given.joules - wanted.joules {
            _ if !given.dimension.same(&Dimension(energy)) => Ok(0.0),
            d if d > 1e-9 => Err(Mismatch::Energy),
            d if d < -1e-9 => Err(Mismatch::Torque),
            _ => Ok(0.0),
        };
    }
    if given.cycles != 0.0 && (extra - given.cycles).abs() < 1e-9 {
        return Ok(given.cycles);
    }
    if b[ANGLE] < 0.0 && a[ANGLE].abs() < 1e-9 {
        return Ok(0.0);
    }
    Err(if a[ANGLE].abs() < 1e-9 && b[ANGLE] > 0.0 { Mismatch::AngleLeftOut } else { Mismatch::Dimension })
}

impl Mismatch {
    fn error(self, text: &str, range: Range<usize>, unit_text: &str, unit: &Unit, expected: &str) -> UnitError {
        let (need, ex) = (describe(expected), examples(expected));
        let text = text.trim();
        match self {
            Mismatch::Dimension => {
                let is = if unit_text.is_empty() {
                    text!("a pure number").argument()
                } else {
                    table::describe_dimension(&unit.dimension, unit.joules)
                };
                let error = UnitError::new(
                    "unit.dimension",
                    range,
                    text!("{need} is needed ({ex}); {text} is {is}", need, ex, text = text::quoted(&text), is),
                );
                match pounds_as_force(text, unit_text, expected) {
                    Some(meant) => error.help(text!("lb is a mass; the force is lbf: write {meant}", meant = text::quoted(&meant))),
                    None => error,
                }
            }
            Mismatch::AngleLeftOut => UnitError::new(
                "unit.angle",
                range,
                text!(
                    "{need} is needed ({ex}); {text} leaves open whether turns or radians are meant",
                    need,
                    ex,
                    text = text::quoted(&text)
                ),
            )
            .help(text!("for turns write rpm, Hz or rev; for radians write rad")),
            Mismatch::Torque => UnitError::new(
                "unit.dimension",
                range,
                text!("{need} is needed ({ex}); {text} is a torque", need, ex, text = text::quoted(&text)),
            ),
            Mismatch::Energy => UnitError::new(
                "unit.dimension",
                range,
                text!("{need} is needed ({ex}); {text} is an energy", need, ex, text = text::quoted(&text)),
            ),
        }
    }
}

#[cfg(test)]
mod tests;
