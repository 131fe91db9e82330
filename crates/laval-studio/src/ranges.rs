//! Ranges of sliders within which the file describes a machine: what limits a number is often another one, as the radius of a cavity its free surface.

use crate::edit::{self, Set};
use crate::machines::Machines;
use crate::parameters;
use laval::diagnostic::Diagnostics;
use laval::file;
use laval::study::Cancel;
use serde::Deserialize;
use serde_json::{Value as Json, json};
use std::sync::atomic::Ordering;

/// `POST api/ranges`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Request {
    #[serde(default)]
    serial: i64,
    text: String,
}

/// Halvings of the way from the value to an end that is refused.
const HALVINGS: u32 = 8;
/// Digits of an end.
const DIGITS: u8 = 4;

/// The ranges that are narrower than those of the check.
pub(crate) fn ranges(machines: &Machines, request: &Request, cancel: &Cancel) -> Result<Json, Diagnostics> {
    let loaded = machines.load(&request.text).map_err(|found| (*found).clone())?;
    let all = parameters::numbers(&request.text, &loaded);
    let fits = |path: &str, value: f64| {
        let set = [Set { path: path.into(), value: Some(value), written: None, digits: Some(DIGITS) }];
        edit::changes(machines, &request.text, &set).is_ok_and(|edits| file::load(&file::edited(&request.text, &edits)).is_ok())
    };
    let mut out = Vec::new();
    for n in &all {
        let wide = parameters::range(n, &all);
        let [low, high] = [wide.0, wide.1].map(|end| {
            if end == n.value || fits(&n.path, end) {
                return end;
            }
            let (mut inside, mut outside) = (n.value, end);
            for _ in 0..HALVINGS {
                if cancel.load(Ordering::Relaxed) {
                    break;
                }
                let middle = 0.5 * (inside + outside);
                *(if fits(&n.path, middle) { &mut inside } else { &mut outside }) = middle;
            }
            inside
        });
        if cancel.load(Ordering::Relaxed) {
            break;
        }
        if (low, high) != wide && low < high {
            out.push(json!({ "path": n.path, "low": low, "high": high }));
        }
    }
    Ok(json!({ "serial": request.serial, "ranges": out }))
}
