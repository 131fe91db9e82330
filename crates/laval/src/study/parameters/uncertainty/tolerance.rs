//! Uncertain parameters: from what the file says to distributions.

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::Tolerance;
use crate::model::system::System;
use crate::text;
use crate::text::Text;
use laval_num::sampling::distribution::Distribution;

/// One uncertain parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Uncertain {
    /// Path; a lateral pair without `.x` or `.y` changes both halves together.
    pub path: String,
    /// SI unit.
    pub unit: &'static str,
    /// How it is distributed.
    pub distribution: Distribution,
}

/// All of them; says all that is wrong.
pub fn read(list: &[Tolerance], system: &System, diagnostics: &mut Diagnostics) -> Option<Vec<Uncertain>> {
    let each: Vec<Option<Uncertain>> = list
        .iter()
        .map(|t| match one(t, system) {
            Ok(u) => Some(u),
            Err(d) => {
                diagnostics.push(d.at(t.span.clone()));
                None
            }
        })
        .collect();
    // half of a pair and the pair itself would be set in turn
    for (i, t) in list.iter().enumerate() {
        let indices = system.param(&t.parameter).unwrap_or_default();
        let twice = list[..i].iter().find(|o| system.param(&o.parameter).unwrap_or_default().iter().any(|k| indices.contains(k)));
        if let Some(o) = twice {
            let message = text!("\"{first}\" and \"{second}\" are the same parameter", first = o.parameter, second = t.parameter);
            diagnostics.push(Diagnostic::error("uncertainty.parameter", message).at(t.span.clone()).help(text!("name each once")));
            return None;
        }
    }
    each.into_iter().collect()
}

fn one(t: &Tolerance, system: &System) -> Result<Uncertain, Diagnostic> {
    let path = &t.parameter;
    let wrong =
        |message: Text, help: Text| Diagnostic::error("uncertainty.parameter", text!("{path}: {message}", path, message)).help(help);
    let indices = system.param(path).ok_or_else(|| system.unknown_param(path))?;
    let (value, slot) =
        indices.first().map(|&i| (system.params()[i], &system.param_slots()[i])).ok_or_else(|| system.unknown_param(path))?;
    if indices.iter().any(|&i| system.params()[i] != value) {
        let halves = text!("name {path}.x or {path}.y", path);
        return Err(wrong(text!("its values in x and y differ, so that there is no single one to be uncertain"), halves));
    }
    let unit = slot.unit;
    let say = |x: f64| text::quantity(x, unit.to_string());
    let allowed: &[&str] = match t.distribution {
        "normal" | "log_normal" => &["mean", "deviation"],
        "uniform" => &["from", "to", "tolerance"],
        _ => &["from", "to", "tolerance", "mode"],
    };
    if let Some((other, _)) = t.amounts.iter().find(|a| !allowed.contains(&a.0)) {
        let help = match (t.distribution, *other) {
            ("normal" | "log_normal", "tolerance") => {
                text!("give its standard deviation: a tolerance that 99.7 % of the parts keep is three of them")
            }
            _ => text!("it takes {allowed}", allowed = allowed.join(", ")),
        };
        return Err(wrong(text!("a distribution \"{distribution}\" has no {other}", distribution = t.distribution, other), help));
    }
    let get = |name| t.amount(name, value);
    let distribution = match t.distribution {
        "normal" | "log_normal" => {
            let mean = get("mean").unwrap_or(value);
            let deviation =
                get("deviation").ok_or_else(|| wrong(text!("the standard deviation is missing"), text!("add deviation = \"2 %\"")))?;
            // a share of a negative value is a deviation too
            let deviation =
                if t.amounts.iter().any(|a| a.0 == "deviation" && matches!(a.1, crate::model::field::Amount::Percent(x) if x > 0.0)) {
                    deviation.abs()
                } else {
                    deviation
                };
            if !(deviation > 0.0) {
                let help = if value == 0.0 {
                    text!("the machine's value is 0, of which every share is 0: give a number with a unit")
                } else {
                    text!("it must be above 0")
                };
                return Err(wrong(text!("a standard deviation of {deviation} leaves nothing uncertain", deviation = say(deviation)), help));
            }
            if t.distribution == "normal" {
                Distribution::Normal { mean, deviation }
            } else if mean > 0.0 {
                Distribution::LogNormal { mean, deviation }
            } else {
                return Err(wrong(
                    text!("a log-normal number is positive, its mean cannot be {mean}", mean = say(mean)),
                    text!("use \"normal\", or give a mean"),
                ));
            }
        }
        _ => {
            let (from, to) = match (get("from"), get("to"), get("tolerance")) {
                (Some(a), Some(b), None) => (a, b),
                (None, None, Some(d)) => (value - d.abs(), value + d.abs()),
                _ => {
                    return Err(wrong(
                        text!("either from and to, or tolerance, is needed"),
                        text!("write tolerance = \"5 %\", or from = .., to = .."),
                    ));
                }
            };
            if !(from < to) {
                let help = if value == 0.0 {
                    text!("the machine's value is 0, of which every share is 0: give numbers with a unit")
                } else {
                    text!("from must lie below to")
                };
                return Err(wrong(text!("there is nothing between {from} and {to}", from = say(from), to = say(to)), help));
            }
            for end in [from, to] {
                if !slot.bounds.contains(end) {
                    return Err(wrong(
                        text!("{value} is not admissible for this parameter", value = say(end)),
                        text!("narrow the interval"),
                    ));
                }
            }
            if t.distribution == "uniform" {
                Distribution::Uniform { from, to }
            } else {
                let mode = get("mode").unwrap_or(value);
                if !(from..=to).contains(&mode) {
                    let message = text!(
                        "its most probable value, {mode}, lies outside {from} to {to}",
                        mode = say(mode),
                        from = say(from),
                        to = say(to)
                    );
                    return Err(wrong(message, text!("give mode, or other ends")));
                }
                Distribution::Triangular { from, mode, to }
            }
        }
    };
    Ok(Uncertain { path: path.clone(), unit, distribution })
}
