//! Changes of single numbers in the text of a machine file: at their places, with comments, units and the writing of everything else kept.

use super::places::{Home, Number, Room, numbers};
use super::{Catalog, Spec, written_units};
use crate::diagnostic::{Diagnostic, Diagnostics, Span, nearest};
use crate::text;
use crate::units::{format_number, parse_unit, read_in, read_quantity, unit_of};
use std::cell::LazyCell;

/// What a number is changed to.
#[derive(Clone, Debug, PartialEq)]
pub enum Change {
    /// A value, SI, written with so many digits in the unit that stands there.
    Value(f64, u8),
    /// As a person writes it: `3 mm`.
    Written(String),
}

/// A piece of text that takes the place of another; an empty place inserts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edit {
    /// Bytes replaced.
    pub span: Span,
    /// What stands there afterwards.
    pub insert: String,
}

/// The text after such changes, which are in order and do not overlap.
pub fn edited(text: &str, edits: &[Edit]) -> String {
    let mut out = String::with_capacity(text.len() + 32);
    let mut at = 0;
    for e in edits {
        out.push_str(text.get(at..e.span.start).unwrap_or_default());
        out.push_str(&e.insert);
        at = e.span.end;
    }
    out.push_str(text.get(at..).unwrap_or_default());
    out
}

/// Changes the numbers at these paths.
///
/// # Errors
/// A path that names no number of the file, a value that cannot stand there, or two changes of one number.
pub fn edits(text: &str, spec: &Spec, catalog: &Catalog, changes: &[(String, Change)]) -> Result<Vec<Edit>, Diagnostics> {
    let all = numbers(text, spec, catalog);
    let units = LazyCell::new(|| written_units(text).into_iter().map(|u| u.0).collect());
    let (mut out, mut wrong) = (Vec::new(), Diagnostics::default());
    for (path, change) in changes {
        let Some(number) = all.iter().find(|n| n.path == *path) else {
            let message = text!("the file has no number \"{path}\"", path);
            let near = nearest(path, all.iter().map(|n| n.path.as_str()));
            let d = Diagnostic::error("edit.path", message);
            wrong.push(match near {
                Some(near) => d.help(text!("did you mean {near}?", near = text::quoted(&near))),
                None => d,
            });
            continue;
        };
        match (Writer { text, units: &units, number }).edits(change) {
            Ok(more) => out.extend(more),
            Err(d) => wrong.push(d.at(number.span.clone())),
        }
    }
    out.sort_by_key(|e: &Edit| (e.span.start, e.span.end));
    // lines added behind one place follow each other
    let overlap = out.windows(2).any(|w| w[0].span.end > w[1].span.start || (w[0].span == w[1].span && !w[0].span.is_empty()));
    if overlap {
        wrong.push(Diagnostic::error("edit.twice", text!("two changes are of the same place in the file")));
    }
    if wrong.has_errors() { Err(wrong) } else { Ok(out) }
}

struct Writer<'a, U> {
    text: &'a str,
    /// Units of the file, read where a unit is to be chosen.
    units: &'a LazyCell<Vec<String>, U>,
    number: &'a Number,
}

impl<U: FnOnce() -> Vec<String>> Writer<'_, U> {
    fn edits(&self, change: &Change) -> Result<Vec<Edit>, Diagnostic> {
        let n = self.number;
        let at = |span: &Span, insert: String| Edit { span: span.clone(), insert };
        Ok(match (&n.home, &n.span) {
            (Home::Written, Some(span)) => vec![at(span, self.instead(span, change)?)],
            (Home::Both(spans), _) => spans.iter().map(|s| Ok(at(s, self.instead(s, change)?))).collect::<Result<_, Diagnostic>>()?,
            (Home::Half(span, half), _) => {
                let (own, old) = (self.instead(span, change)?, self.written(span));
                let (x, y) = if *half == "x" { (own.as_str(), old) } else { (old, own.as_str()) };
                vec![at(span, format!("{{ x = {x}, y = {y} }}"))]
            }
            (Home::Other(span, name), _) => vec![at(span, format!("{{ {name} = {} }}", self.anew(change)?))],
            (Home::Body(span), _) => vec![at(span, format!("{{ body = {}, at = {} }}", self.written(span), self.anew(change)?))],
            (Home::Position(span), _) => self.inside(span.end - 1, "at", change)?,
            (Home::Key(Room::Inline(end), key), _) => self.inside(*end, key, change)?,
            (Home::Key(Room::Line(place), key), _) => {
                let rest = self.text.get(*place..).unwrap_or_default();
                let (end, before) = match rest.find('\n') {
                    Some(i) => (place + i, ""),
                    None => (self.text.len(), ""),
                };
                let end = if self.text.get(..end).is_some_and(|t| t.ends_with('\r')) { end - 1 } else { end };
                let line = if self.text.contains("\r\n") { "\r\n" } else { "\n" };
                vec![at(&(end..end), format!("{before}{line}{key} = {}", self.anew(change)?))]
            }
            (Home::Written, None) => return Err(Diagnostic::error("edit.path", text!("{path} is not written in the file", path = n.path))),
        })
    }

    /// Another entry before the end of an inline table.
    fn inside(&self, end: usize, key: &str, change: &Change) -> Result<Vec<Edit>, Diagnostic> {
        let before = self.text.get(..end).unwrap_or_default();
        let place = before.trim_end().len();
        let joint = if before.trim_end().ends_with(['{', ',']) { " " } else { ", " };
        Ok(vec![Edit { span: place..place, insert: format!("{joint}{key} = {}", self.anew(change)?) }])
    }

    fn written(&self, span: &Span) -> &str {
        self.text.get(span.clone()).unwrap_or_default()
    }

    fn admissible(&self, x: f64) -> Result<f64, Diagnostic> {
        let n = self.number;
        if n.bounds.contains(x) {
            return Ok(x);
        }
        let message = text!(
            "{who} is {value}; it must be {bounds}",
            who = n.path,
            value = text::quantity(x, n.unit.to_string()),
            bounds = n.bounds.text(n.unit)
        );
        Err(Diagnostic::error("value.bounds", message))
    }

    /// A number as it was written, with its unit and its quotation marks.
    fn instead(&self, span: &Span, change: &Change) -> Result<String, Diagnostic> {
        let old = self.written(span);
        let quote = old.chars().next().filter(|c| matches!(c, '"' | '\''));
        match change {
            Change::Written(text) => self.typed(text, quote.unwrap_or('"'), quote.is_none()),
            Change::Value(x, digits) => {
                let x = self.admissible(*x)?;
                let Some(quote) = quote else { return Ok(style(x, old, *digits)) };
                let inner = old.trim_matches(quote);
                let Some(unit) = unit_of(inner) else {
                    // a share in per cent, or a number in quotation marks
                    let share = inner.trim_end().ends_with('%');
                    let number = if share { format!("{} %", style(100.0 * x, inner, *digits)) } else { style(x, inner, *digits) };
                    return Ok(format!("{quote}{number}{quote}"));
                };
                let number = inner.trim_end().strip_suffix(unit).unwrap_or(inner);
                let gap = if number.ends_with(' ') || number.is_empty() { " " } else { "" };
                let value = self.in_unit(x, unit);
                let shown = format!("{}{gap}{unit}", style(value, number, *digits));
                // the unit may be read in another way than it converts
                let read = read_quantity(&shown, self.number.unit).map_err(|e| Diagnostic::error(e.code, e.sentence()))?;
                let near = (read - x).abs() <= 10f64.powi(1 - i32::from(*digits)) * x.abs();
                let shown = if near { shown } else { self.plain(x, *digits) };
                Ok(format!("{quote}{shown}{quote}"))
            }
        }
    }

    fn in_unit(&self, x: f64, unit: &str) -> f64 {
        // one of the unit over what it is read as: 2 pi of Hz where a plain rate is meant
        let one = read_quantity(&format!("1 {unit}"), self.number.unit);
        let zero = read_quantity(&format!("0 {unit}"), self.number.unit);
        match (one, zero) {
            (Ok(one), Ok(zero)) if one != zero => (x - zero) / (one - zero),
            _ => parse_unit(unit).map_or(x, |u| x / u.factor()),
        }
    }

    fn plain(&self, x: f64, digits: u8) -> String {
        let (number, unit) = read_in(self.units, x, self.number.unit, digits);
        if unit.is_empty() { number } else { format!("{number} {unit}") }
    }

    /// A number where there was none, in a unit of the file.
    fn anew(&self, change: &Change) -> Result<String, Diagnostic> {
        match change {
            Change::Written(text) => self.typed(text, '"', true),
            Change::Value(x, digits) => {
                let x = self.admissible(*x)?;
                let shown = self.plain(x, *digits);
                Ok(if self.number.unit.is_empty() { shown } else { format!("\"{shown}\"") })
            }
        }
    }

    /// What a person typed; bare where it is a bare number and may stand so.
    fn typed(&self, text: &str, quote: char, bare: bool) -> Result<String, Diagnostic> {
        let text = text.trim();
        if let (Ok(x), true) = (text.parse::<f64>(), bare || self.number.unit.is_empty())
            && x.is_finite()
        {
            self.admissible(x)?;
            return Ok(text.to_string());
        }
        let x = read_quantity(text, self.number.unit).map_err(|e| Diagnostic::error(e.code, e.sentence()))?;
        self.admissible(x)?;
        if text.contains(['"', '\'', '\\', '\n', '\r']) {
            return Err(Diagnostic::error("edit.text", text!("{text} is no quantity", text = text::quoted(&text))));
        }
        Ok(format!("{quote}{text}{quote}"))
    }
}

/// A number with so many digits, with an exponent where the old one has one.
fn style(x: f64, old: &str, digits: u8) -> String {
    let exponent = old.contains(['e', 'E']) && old.trim().parse::<f64>().is_ok();
    let number = format_number(x, digits.into());
    if !exponent || x == 0.0 || number.contains('e') {
        return number;
    }
    let text = format!("{:.*e}", usize::from(digits.max(1)) - 1, x);
    let Some((mantissa, power)) = text.split_once('e') else { return number };
    let mantissa = if mantissa.contains('.') { mantissa.trim_end_matches('0').trim_end_matches('.') } else { mantissa };
    format!("{mantissa}e{power}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::file::{catalog, load};

    const FILE: &str = r#"# a machine
[machine]
speed = "3000 rpm"   # operating

[[part]]
kind = "disc"  # the rotor
name = "drum"
mass = "2.4 kg" # with its oil
diametral_inertia = 0.01
polar_inertia = 0.015

[[part]]
kind = "shaft_lumped"
name = "lower"
between = ["drum", "ground"]
stiffness = { x = "1.1e7 N/m", y = '2e7 N/m' }   # stiff in y

[[part]]
kind = "damper"
name = "air"
between = ["drum", "ground"]
damping = "100 N s/m"

[[part]]
kind = "bearing_cubic"
name = "upper"
between = [{ body = "drum", at = "40 mm" }, "ground"]
law = "per_axis"
stiffness = "1.1e7 N/m"
cubic_stiffness = "8.7e10 N/m^3"

[[part]]
kind = "liquid"
name = "oil"
in = "drum"
cavity_radius = "70 mm"
cavity_height = "60 mm"
density = "880 kg/m^3"
fill = { volume_fraction = "50 %" }
"#;

    fn changed(changes: &[(&str, Change)]) -> Result<String, Diagnostics> {
        let loaded = load(FILE).unwrap_or_else(|d| panic!("{d}"));
        let changes: Vec<(String, Change)> = changes.iter().map(|c| (c.0.to_string(), c.1.clone())).collect();
        Ok(edited(FILE, &edits(FILE, &loaded.spec, catalog(), &changes)?))
    }

    fn value(x: f64) -> Change {
        Change::Value(x, 6)
    }

    /// Lines of the file before and after that differ.
    fn lines(changes: &[(&str, Change)]) -> Vec<String> {
        let after = changed(changes).unwrap_or_else(|d| panic!("{d}"));
        load(&after).unwrap_or_else(|d| panic!("{after}: {d}"));
        after.lines().filter(|l| !FILE.lines().any(|o| o == *l)).map(str::to_string).collect()
    }

    #[test]
    fn a_value_keeps_its_unit_and_the_comment_beside_it() {
        assert_eq!(lines(&[("machine.speed", value(100.0 * std::f64::consts::PI))]), [""; 0]);
        assert_eq!(lines(&[("machine.speed", value(400.0))]), ["speed = \"3819.72 rpm\"   # operating"]);
        assert_eq!(lines(&[("drum.mass", value(3.25))]), ["mass = \"3.25 kg\" # with its oil"]);
        assert_eq!(lines(&[("drum.polar_inertia", value(0.02))]), ["polar_inertia = 0.02"]);
        assert_eq!(lines(&[("upper.stiffness", value(12_345_678.0))]), ["stiffness = \"1.23457e7 N/m\""]);
        assert_eq!(lines(&[("oil.volume_fraction", value(0.625))]), ["fill = { volume_fraction = \"62.5 %\" }"]);
        assert_eq!(lines(&[("upper.between[1].at", value(0.0525))]), ["between = [{ body = \"drum\", at = \"52.5 mm\" }, \"ground\"]"]);
        let both = [("lower.stiffness.x", value(9e6)), ("lower.stiffness.y", Change::Written("3 kN/mm".into()))];
        assert_eq!(lines(&both), ["stiffness = { x = \"9e6 N/m\", y = '3 kN/mm' }   # stiff in y"]);
    }

    #[test]
    fn what_stands_by_default_gets_a_key() {
        let after = changed(&[("drum.eccentricity", value(2e-5)), ("lower.between[1].at", value(-0.03))]).unwrap();
        assert!(after.contains("polar_inertia = 0.015\neccentricity = \"0.02 mm\"\n\n[[part]]"), "{after}");
        assert!(after.contains("between = [{ body = \"drum\", at = \"-30 mm\" }, \"ground\"]"), "{after}");
        assert_eq!(lines(&[("air.damping.y", value(50.0))]), ["damping = { x = \"100 N s/m\", y = \"50 N s/m\" }"]);
        let inline = "machine = { name = \"a\" }\npart = [{ kind = \"disc\", name = \"d\", mass = 1 }]\n";
        let loaded = load(inline).unwrap();
        let e = edits(inline, &loaded.spec, catalog(), &[("d.eccentricity".into(), value(1e-3))]).unwrap();
        assert_eq!(
            edited(inline, &e).lines().nth(1),
            Some("part = [{ kind = \"disc\", name = \"d\", mass = 1, eccentricity = \"1 mm\" }]")
        );
    }

    #[test]
    fn what_cannot_stand_there_is_refused() {
        let code = |path: &str, c: Change| changed(&[(path, c)]).unwrap_err().0[0].code;
        assert_eq!(code("drum.mas", value(1.0)), "edit.path");
        assert_eq!(code("drum.mass", value(-1.0)), "value.bounds");
        assert_eq!(code("drum.mass", value(f64::NAN)), "value.bounds");
        assert_eq!(code("drum.mass", Change::Written("3 mm".into())), "unit.dimension");
        assert_eq!(code("drum.mass", Change::Written("3 kg\"\n[x]".into())), "unit.invalid");
        assert_eq!(changed(&[("drum.mass", value(1.0)), ("drum.mass", value(2.0))]).unwrap_err().0[0].code, "edit.twice");
    }

    /// Rows of a list that leave columns out, and ends of a range.
    #[test]
    fn sections_of_a_shaft_and_ranges_are_changed_at_their_place() {
        let text = include_str!("../../../../examples/09-cream-separator/machine.toml");
        let loaded = load(text).unwrap_or_else(|d| panic!("{d}"));
        let all = numbers(text, &loaded.spec, catalog());
        let own = |path: &str| all.iter().find(|n| n.path == path).unwrap_or_else(|| panic!("{path}"));
        assert!((own("spindle.section[2].outer_diameter").value - 0.028).abs() < 1e-15);
        assert!(!all.iter().any(|n| n.path == "spindle.section[1].end_outer_diameter"), "the row leaves it out");
        assert!(loaded.system.param("spindle.section[4].end_outer_diameter").is_some());
        let wanted = [
            ("spindle.section[4].end_outer_diameter", "26 mm"),
            ("spindle.section[1].length", "41 mm"),
            ("operation.speed.to", "8100 rpm"),
        ];
        let wanted: Vec<_> = wanted.iter().map(|(p, t)| (p.to_string(), Change::Written(t.to_string()))).collect();
        let now = edited(text, &edits(text, &loaded.spec, catalog(), &wanted).unwrap_or_else(|d| panic!("{d}")));
        let expected = text
            .replace("end_outer_diameter = \"24 mm\"", "end_outer_diameter = \"26 mm\"")
            .replace("length = \"40 mm\",  outer", "length = \"41 mm\",  outer")
            .replace("to = \"8000 rpm\"", "to = \"8100 rpm\"");
        assert_eq!(now, expected);
    }

    /// Every number of the example stands where its place says.
    #[test]
    fn places_hold_the_values() {
        let loaded = load(FILE).unwrap();
        let all = numbers(FILE, &loaded.spec, catalog());
        assert!(all.len() > 20);
        for n in all.iter().filter(|n| n.span.is_some()) {
            let written = FILE[n.span.clone().unwrap()].trim_matches(['"', '\'']);
            let x = read_quantity(written, n.unit).or_else(|_| written.parse::<f64>().map_err(|_| ())).unwrap();
            assert!((x - n.value).abs() <= 1e-12 * x.abs(), "{}: {written}", n.path);
        }
    }
}
