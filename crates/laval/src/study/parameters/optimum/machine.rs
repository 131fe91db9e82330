//! Parameters between their bounds: from places in the unit cube to machines.

use super::request::few_enough;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{RangeValue, Values};
use crate::model::system::System;
use crate::text;

/// A parameter and its bounds.
#[derive(Clone, Debug, PartialEq)]
pub struct Vary {
    /// Path; a lateral pair without `.x` or `.y` changes both halves together.
    pub path: String,
    /// SI unit.
    pub unit: &'static str,
    /// Bounds, SI.
    pub from: f64,
    /// See [`Vary::from`].
    pub to: f64,
    /// Value of the machine as it is.
    pub now: f64,
}

/// Ratio of the bounds from which on a parameter is searched in its logarithm.
const DECADE: f64 = 10.0;

impl Vary {
    pub(super) fn logarithmic(&self) -> bool {
        self.from > 0.0 && self.to >= DECADE * self.from
    }
    /// Value at a place between 0 and 1; the bounds themselves at the ends.
    pub(super) fn value(&self, u: f64) -> f64 {
        match u {
            u if u <= 0.0 => self.from,
            u if u >= 1.0 => self.to,
            u if self.logarithmic() => self.from * (self.to / self.from).powf(u),
            u => self.from + (self.to - self.from) * u,
        }
    }
    /// Place of a value, within the bounds.
    pub(super) fn place(&self, x: f64) -> f64 {
        let u =
            if self.logarithmic() { (x / self.from).ln() / (self.to / self.from).ln() } else { (x - self.from) / (self.to - self.from) };
        if u.is_nan() { 0.5 } else { u.clamp(0.0, 1.0) }
    }
}

/// Reads the parameters; says all that is wrong.
pub(super) fn vary(values: &Values, system: &System, out: &mut Diagnostics) -> Option<Vec<Vary>> {
    let list = values.parameter_ranges("vary")?;
    let before = out.0.len();
    let mut found: Vec<(Vary, Vec<usize>)> = Vec::new();
    for (path, range, span) in list {
        match one(path, range, system) {
            Err(d) => out.push(d.at(span.clone())),
            Ok((v, indices)) => {
                if let Some(o) = found.iter().find(|o| o.1.iter().any(|i| indices.contains(i))) {
                    let message = text!("\"{first}\" and \"{second}\" are the same parameter", first = path, second = o.0.path);
                    out.push(Diagnostic::error("optimum.parameters", message).at(span.clone()).help(text!("name each once")));
                }
                found.push((v, indices));
            }
        }
    }
    let fine = few_enough(list.len(), values, out) && out.0.len() == before;
    fine.then(|| found.into_iter().map(|f| f.0).collect())
}

fn one(path: &str, range: &RangeValue, system: &System) -> Result<(Vary, Vec<usize>), Diagnostic> {
    let indices = system.param(path).ok_or_else(|| system.unknown_param(path))?;
    let first = *indices.first().ok_or_else(|| system.unknown_param(path))?;
    let (slot, now) = (&system.param_slots()[first], system.params()[first]);
    let (from, to) = (range.from, range.to);
    if !(from < to) {
        let d = Diagnostic::error("optimum.bounds", text!("{path}: the bounds must go from a lower to a higher value", path));
        return Err(d.help(text!("exchange from and to")));
    }
    if let Some(x) = [from, to].into_iter().find(|x| !slot.bounds.contains(*x)) {
        return Err(Diagnostic::error("optimum.bounds", text!("{path}: {x} {unit} is not admissible", path, x, unit = slot.unit)));
    }
    Ok((Vary { path: path.to_string(), unit: slot.unit, from, to, now }, indices))
}

/// The machine at a place of the unit cube.
pub(super) fn at(vary: &[Vary], system: &System, place: &[f64]) -> Result<System, Diagnostic> {
    let changes: Vec<(&str, f64)> = vary.iter().zip(place).map(|(v, u)| (v.path.as_str(), v.value(*u))).collect();
    system.with(&changes).map_err(Diagnostics::into_error)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_and_values() {
        for (from, to) in [(1.0, 3.0), (1e-3, 1e3), (-2.0, 5.0), (0.0, 50.0)] {
            let v = Vary { path: String::new(), unit: "", from, to, now: 0.0 };
            assert_eq!([v.value(0.0), v.value(1.0)], [from, to]);
            assert_eq!([v.place(from - 1e-9), v.place(2.0 * to)], [0.0, 1.0]);
            for u in [0.1, 0.5, 0.93] {
                assert!((v.place(v.value(u)) - u).abs() < 1e-14);
            }
        }
        let wide = Vary { path: String::new(), unit: "", from: 1e-2, to: 1e2, now: 0.0 };
        assert!((wide.value(0.5) - 1.0).abs() < 1e-14);
    }
}
