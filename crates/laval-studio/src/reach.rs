//! Drag the answer: the request, and what was found, for the page.

use crate::edit;
use crate::machines::Machines;
use laval::diagnostic::{Diagnostic, Diagnostics};
use laval::file::{self, Change};
use laval::reach::{self, Free, Goal, Of};
use laval::report::Language;
use laval::study::{Cancel, Context, Silent};
use laval::text;
use serde::Deserialize;
use serde_json::{Value as Json, json};

/// `POST api/reach`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Request {
    #[serde(default)]
    serial: i64,
    text: String,
    target: Target,
    free: Vec<Released>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Target {
    what: String,
    which: Which,
    to: f64,
}

/// What the targets of a figure say of themselves.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Which {
    at: f64,
    order: Option<f64>,
    body: Option<String>,
    /// The size of a peak, not its speed.
    #[serde(default)]
    size: bool,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Released {
    path: String,
    low: f64,
    high: f64,
}

/// Digits of the values found.
const DIGITS: u8 = 7;

fn goal(target: &Target) -> Result<Goal, Diagnostic> {
    let Which { at, order, body, size } = &target.which;
    Ok(match target.what.as_str() {
        "critical_speed" => Goal::CriticalSpeed { order: order.unwrap_or(1.0), at: *at },
        "stability_limit" => Goal::StabilityLimit { at: *at },
        "resonance" => Goal::Resonance { at: *at, body: body.clone(), of: if *size { Of::Size } else { Of::Speed } },
        "peak" => Goal::Peak { at: *at, body: body.clone(), of: if *size { Of::Size } else { Of::Speed } },
        "jump" => Goal::Jump { at: *at },
        other => {
            return Err(Diagnostic::error("reach.goal", text!("there is no result {what} that can be moved", what = text::quoted(&other))));
        }
    })
}

pub(crate) fn reach(machines: &Machines, request: &Request, language: Language, cancel: &Cancel) -> Result<Json, Diagnostics> {
    let loaded = machines.load(&request.text).map_err(|found| (*found).clone())?;
    let one = |d| Diagnostics(vec![d]);
    let goal = goal(&request.target).map_err(one)?;
    let free: Vec<Free> = request.free.iter().map(|f| Free { path: f.path.clone(), low: f.low, high: f.high }).collect();
    let context = Context { name: "reach", cancel, progress: &Silent, work_limit: u64::MAX, keep: None };
    let found = reach::reach(&request.text, &loaded, file::catalog(), &goal, request.target.to, &free, &context)?;
    let changed = found.moved.iter().filter(|m| m.to != m.from);
    let changes: Vec<(String, Change)> = changed.map(|m| (m.path.clone(), Change::Value(m.to, DIGITS))).collect();
    let edits = file::edits(&request.text, &loaded.spec, file::catalog(), &changes)?;
    let units: Vec<String> = file::written_units(&request.text).into_iter().map(|u| u.0).collect();
    let impossible =
        found.impossible.as_ref().map(|(sentence, bounds)| json!({ "sentence": language.said_in(sentence, &units), "bounds": bounds }));
    let moved: Vec<Json> = found
        .moved
        .iter()
        .map(|m| json!({ "path": m.path, "from": m.from, "to": m.to, "share": m.share, "at_bound": m.at_bound }))
        .collect();
    let trade: Vec<Json> =
        found.alone.iter().map(|a| json!({ "path": a.path, "value": a.value, "target": a.result, "reached": a.reached })).collect();
    Ok(json!({
        "serial": request.serial,
        "edits": edit::shown(&request.text, &edits),
        "reached": found.reached,
        "from": found.from,
        "to": found.to,
        "moved": moved,
        "impossible": impossible,
        "trade": trade,
        "curve": found.curve,
        "evaluations": found.evaluations,
    }))
}
