//! The reader of numbers and unit expressions.

use super::table::{lookup, suggest};
use super::{Unit, UnitError};
use crate::text;
use crate::text::{Argument, Text};
use std::ops::Range;

/// A decimal number at the start of a text.
pub(super) struct Number {
    /// Cleaned digits, as `f64::from_str` takes them, without exponent.
    mantissa: String,
    exp10: i64,
    /// Byte at which the rest begins.
    pub rest: usize,
}

impl Number {
    /// `number * unit * extra`, relative to `wanted`, rounded once for decimal prefixes.
    pub(super) fn scaled(&self, unit: &Unit, extra: f64, wanted: &Unit) -> Result<f64, UnitError> {
        let exp = self.exp10.saturating_add((unit.exp10 - wanted.exp10) as i64);
        let range = 0..self.rest;
        let decimal: f64 = format!("{}e{exp}", self.mantissa)
            .parse()
            .map_err(|_| UnitError::new("number.invalid", range.clone(), text!("this is not a number")))?;
        let value = decimal * (unit.mantissa / wanted.mantissa * extra) + unit.offset;
        if !value.is_finite() {
            return Err(UnitError::new("number.range", range, text!("the number is too large")));
        }
        if decimal == 0.0 && self.mantissa.bytes().any(|b| (b'1'..=b'9').contains(&b)) {
            return Err(UnitError::new("number.range", range, text!("the number is too small to be distinguished from 0")));
        }
        Ok(value)
    }
}

/// Reads the number a quantity begins with.
pub(super) fn number(text: &str) -> Result<Number, UnitError> {
    let start = text.len() - text.trim_start().len();
    let mut s = &text[start..];
    let whole = start..text.trim_end().len().max(start);
    let mut mantissa = String::with_capacity(s.len().min(40) + 8);
    if let Some(r) = s.strip_prefix('-').or_else(|| s.strip_prefix('−')) {
        mantissa.push('-');
        s = r;
    } else if let Some(r) = s.strip_prefix('+') {
        s = r;
    }
    let head = s.get(..3).unwrap_or("").to_ascii_lowercase();
    if head == "nan" || head == "inf" {
        return Err(UnitError::new("number.invalid", whole, text!("a finite number is needed, not {head}", head)));
    }
    let mut any = false;
    let mut digits = |s: &mut &str, out: &mut String| {
        while let Some(&b) = s.as_bytes().first() {
            let next_digit = s.as_bytes().get(1).is_some_and(u8::is_ascii_digit);
            if b.is_ascii_digit() {
                any = true;
                out.push(b as char);
            } else if !(b == b'_' && next_digit) {
                break;
            }
            *s = &s[1..];
        }
    };
    digits(&mut s, &mut mantissa);
    if s.starts_with('.') {
        mantissa.push('.');
        s = &s[1..];
        digits(&mut s, &mut mantissa);
    }
    if !any {
        let what = if whole.is_empty() {
            text!("this text is empty")
        } else {
            text!("{text} begins with no number", text = text::quoted(&clip(text.trim())))
        };
        return Err(UnitError::new("number.missing", whole, text!("a quantity is a number and a unit; {what}", what))
            .help(text!("write it as in \"70 mm\"")));
    }
    let mut exp10 = 0i64;
    if let Some(r) = s.strip_prefix(['e', 'E']) {
        let (negative, r) = match r.strip_prefix(['-', '−']) {
            Some(r) => (true, r),
            None => (false, r.strip_prefix('+').unwrap_or(r)),
        };
        let n = r.bytes().take_while(u8::is_ascii_digit).count();
        if n > 0 {
            let e = r[..n].parse::<i64>().unwrap_or(i64::MAX / 4).min(1_000_000);
            exp10 = if negative { -e } else { e };
            s = &r[n..];
        }
    }
    let rest = text.len() - s.len();
    let invalid = |message: Text, help: Text| Err(UnitError::new("number.invalid", whole.clone(), message).help(help));
    let after = s.trim_start();
    if s.starts_with(',') {
        return invalid(
            text!("{text} has a comma in its number", text = text::quoted(&clip(text.trim()))),
            text!("write the decimal point, as in \"1.5 mm\", and no separators"),
        );
    }
    if after.starts_with(|c: char| c.is_ascii_digit()) && !after.starts_with("1/") && !after.starts_with("1 /") {
        return invalid(
            text!("{text} has a space inside its number", text = text::quoted(&clip(text.trim()))),
            text!("write the digits together, as in \"3000 rpm\""),
        );
    }
    if after.strip_prefix(['x', '×', '·', '*']).is_some_and(|r| r.trim_start().starts_with("10")) {
        return invalid(
            text!("{text} writes a power of ten in words", text = text::quoted(&clip(text.trim()))),
            text!("write it as in \"1.1e7 N/m\""),
        );
    }
    if s.starts_with('.') {
        return invalid(
            text!("{text} has two decimal points", text = text::quoted(&clip(text.trim()))),
            text!("write the number as in \"1.5 mm\", without separators"),
        );
    }
    Ok(Number { mantissa, exp10, rest })
}

/// The first characters of a text, for messages.
fn clip(s: &str) -> String {
    if s.chars().count() <= 40 { s.to_string() } else { s.chars().take(37).chain("...".chars()).collect() }
}

/// Parses a unit such as `N s/m`; empty is a pure number.
pub fn parse_unit(text: &str) -> Result<Unit, UnitError> {
    unit_at(text, 0)
}

/// Parses a unit that stands `offset` bytes into the quantity, for the places in messages.
pub(super) fn unit_at(text: &str, offset: usize) -> Result<Unit, UnitError> {
    if text.len() > 200 {
        return Err(UnitError::new(
            "unit.invalid",
            offset..offset + text.len(),
            text!("{text} is too long for a unit", text = text::quoted(&clip(text))),
        ));
    }
    let mut p = Parser { text, pos: 0, offset, affine: false, factors: 0 };
    let unit = p.product(0)?;
    p.space();
    if p.pos < text.len() {
        return Err(p.error(p.pos..text.len(), text!("{text} does not belong in a unit", text = text::quoted(&clip(&text[p.pos..])))));
    }
    if p.affine && (p.factors > 1 || unit.dimension.0[4] != 1.0) {
        return Err(p
            .error(0..text.len(), text!("a temperature in degC stands alone"))
            .help(text!("for differences and in products write K")));
    }
    if !unit.factor().is_finite() || unit.factor() == 0.0 {
        return Err(p.error(0..text.len(), text!("this unit is out of all bounds")));
    }
    Ok(unit)
}

struct Parser<'a> {
    text: &'a str,
    pos: usize,
    offset: usize,
    affine: bool,
    factors: usize,
}

impl Parser<'_> {
    fn error(&self, r: Range<usize>, message: Text) -> UnitError {
        UnitError::new("unit.invalid", r.start + self.offset..r.end + self.offset, message)
    }
    fn rest(&self) -> &str {
        &self.text[self.pos..]
    }
    fn space(&mut self) {
        self.pos = self.text.len() - self.rest().trim_start().len();
    }
    fn eat(&mut self, set: &[&str]) -> bool {
        for s in set {
            if self.rest().starts_with(s) {
                self.pos += s.len();
                return true;
            }
        }
        false
    }
    fn product(&mut self, depth: usize) -> Result<Unit, UnitError> {
        let mut unit = Unit::ONE;
        let (mut first, mut divided) = (true, false);
        loop {
            self.space();
            let at = self.pos;
            if self.rest().is_empty() || self.rest().starts_with(')') {
                return Ok(unit);
            }
            let divide = self.eat(&["/", "÷"]);
            let times = !divide && !self.rest().starts_with("**") && self.eat(&["*", "·", "⋅", "×"]);
            if times && first {
                return Err(self.error(at..self.pos, text!("a unit cannot begin with a product sign")));
            }
            if divided && !divide {
                let whole = self.text.trim();
                return Err(self
                    .error(
                        0..self.text.len(),
                        text!(
                            "{whole} has two readings: is what follows the / and a space above or below it?",
                            whole = text::quoted(&whole)
                        ),
                    )
                    .help(text!("put products below a / in parentheses, as in N/(m s), or write them first, as in N s/m")));
            }
            self.space();
            let factor = self.factor(depth)?;
            unit = unit.times(factor, if divide { -1.0 } else { 1.0 });
            divided |= divide;
            first = false;
        }
    }
    fn factor(&mut self, depth: usize) -> Result<Unit, UnitError> {
        let at = self.pos;
        let unit = if self.eat(&["("]) {
            if depth >= 8 {
                return Err(self.error(at..self.text.len(), text!("too many parentheses")));
            }
            let inner = self.product(depth + 1)?;
            if !self.eat(&[")"]) {
                return Err(self.error(at..self.text.len(), text!("a closing parenthesis is missing")));
            }
            inner
        } else if self.rest().starts_with('1') && !self.rest()[1..].starts_with(|c: char| c.is_ascii_digit() || c == '.') {
            self.pos += 1;
            return Ok(Unit::ONE);
        } else {
            let is_word = |c: char| (c.is_alphabetic() && !SUPER.contains(c)) || matches!(c, '°' | '%' | '‰');
            let len = self.rest().find(|c: char| !is_word(c)).unwrap_or(self.rest().len());
            let word = &self.text[at..at + len];
            if word.is_empty() {
                let what = self.rest().chars().next().map_or_else(|| text!("nothing").argument(), |c| text::quoted(&c));
                return Err(self.error(at..self.text.len(), text!("a unit is expected here, not {what}", what)));
            }
            self.pos += len;
            let unit = lookup(word).ok_or_else(|| {
                let mut e = self.error(at..at + len, text!("{word} is not a known unit", word = text::quoted(&clip(word))));
                e.code = "unit.unknown";
                e.help = suggest(word).map(|s| text!("did you mean {near}?", near = text::quoted(&s)));
                e
            })?;
            self.affine |= unit.offset != 0.0;
            self.factors += 1;
            unit
        };
        let power = self.power()?;
        Ok(if power == 1.0 { unit } else { Unit::ONE.times(unit, power) })
    }
    fn power(&mut self) -> Result<f64, UnitError> {
        let at = self.pos;
        let value = if self.eat(&["^", "**"]) {
            if self.eat(&["("]) {
                let a = self.decimal()?;
                let b = if self.eat(&["/"]) { self.decimal()? } else { 1.0 };
                if !self.eat(&[")"]) {
                    return Err(self.error(at..self.text.len(), text!("a closing parenthesis is missing in a power")));
                }
                a / b
            } else {
                self.decimal()?
            }
        } else if let Some((value, len)) = superscript(self.rest()) {
            self.pos += len;
            value
        } else {
            let r = self.rest();
            if r.strip_prefix('-').unwrap_or(r).starts_with(|c: char| c.is_ascii_digit()) { self.decimal()? } else { 1.0 }
        };
        if value.is_finite() && value.abs() <= 20.0 && value != 0.0 {
            Ok(value)
        } else {
            Err(self.error(at..self.pos, text!("this power is not between -20 and 20, or is 0")))
        }
    }
    fn decimal(&mut self) -> Result<f64, UnitError> {
        let at = self.pos;
        self.eat(&["-", "−", "+"]);
        let n = self.rest().find(|c: char| !(c.is_ascii_digit() || c == '.')).unwrap_or(self.rest().len());
        self.pos += n;
        let text = self.text[at..self.pos].replace('−', "-");
        text.parse().map_err(|_| {
            self.error(at..self.pos.max(at + 1).min(self.text.len()), text!("a power is a number, as in m^2, m^1.5 or m^(10/9)"))
        })
    }
}

const SUPER: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹⁻";

fn superscript(s: &str) -> Option<(f64, usize)> {
    let (mut value, mut len, mut sign, mut any) = (0.0, 0, 1.0, false);
    for c in s.chars() {
        match SUPER.chars().position(|d| d == c) {
            Some(10) if len == 0 => sign = -1.0,
            Some(d) if d < 10 => {
                value = value * 10.0 + d as f64;
                any = true;
            }
            _ => break,
        }
        len += c.len_utf8();
    }
    any.then_some((sign * value, len))
}
