//! Changes of numbers in the text of the page.

use crate::machines::Machines;
use crate::offsets::Offsets;
use laval::diagnostic::{Diagnostic, Diagnostics};
use laval::file::{self, Change, Edit};
use laval::text;
use serde::Deserialize;
use serde_json::{Value as Json, json};

/// A number and its new value, SI or as it is typed.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Set {
    pub path: String,
    pub value: Option<f64>,
    pub written: Option<String>,
    /// Digits of the value.
    pub digits: Option<u8>,
}

/// `POST api/edit`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Request {
    #[serde(default)]
    pub serial: i64,
    pub text: String,
    pub set: Vec<Set>,
}

/// Digits of a value that is dragged.
const DIGITS: u8 = 6;

/// The changes of a text.
pub(crate) fn changes(machines: &Machines, text: &str, set: &[Set]) -> Result<Vec<Edit>, Diagnostics> {
    if set.is_empty() {
        return Ok(Vec::new());
    }
    let loaded = machines.load(text).map_err(|found| (*found).clone())?;
    let one = |s: &Set| match (&s.value, &s.written) {
        (Some(x), None) => Ok((s.path.clone(), Change::Value(*x, s.digits.unwrap_or(DIGITS).clamp(1, 17)))),
        (None, Some(t)) => Ok((s.path.clone(), Change::Written(t.clone()))),
        _ => {
            let message = text!("{path}: one of value and written is needed", path = s.path.as_str());
            Err(Diagnostics(vec![Diagnostic::error("studio.request", message)]))
        }
    };
    let wanted = set.iter().map(one).collect::<Result<Vec<_>, _>>()?;
    file::edits(text, &loaded.spec, file::catalog(), &wanted)
}

/// Changes in the words of the page.
pub(crate) fn shown(text: &str, edits: &[Edit]) -> Json {
    let offsets = Offsets::new(text);
    let one = |e: &Edit| json!({ "from": offsets.units(e.span.start), "to": offsets.units(e.span.end), "insert": e.insert });
    edits.iter().map(one).collect()
}

pub(crate) fn edit(machines: &Machines, request: &Request) -> Result<Json, Diagnostics> {
    let edits = changes(machines, &request.text, &request.set)?;
    Ok(json!({ "serial": request.serial, "edits": shown(&request.text, &edits) }))
}
