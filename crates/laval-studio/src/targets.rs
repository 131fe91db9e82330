//! What can be pulled in a figure over the speed.

use crate::answer::Want;
use laval::outcome::{Arg, Data, Outcome, SpecialPoint};
use laval::report::{Style, fragment::Drawn};
use serde_json::{Value as Json, json};

/// Most handles in one figure.
const MOST: usize = 24;

struct Shown<'a> {
    drawn: &'a Drawn,
    style: &'a Style,
}

impl Shown<'_> {
    /// A place at a speed, and at a height where that is known, SI.
    fn target(&self, what: &str, which: Json, name: &str, (speed, height): (f64, Option<f64>), along: &str) -> Json {
        let own = self.drawn.y.first().copied().unwrap_or(1.0);
        json!({
            "what": what,
            "which": which,
            "label": name,
            "panel": 0,
            "x": speed * self.drawn.x,
            "y": height.filter(|h| h.is_finite()).map(|h| h * own),
            "along": along,
            "factor": if along == "x" { self.drawn.x } else { own },
        })
    }
}

fn evidence(p: &SpecialPoint, name: &str) -> Option<f64> {
    p.evidence.iter().find(|e| matches!(&e.what, Arg::Term(t) if t == name)).map(|e| e.value)
}

/// The handles of a figure.
pub(crate) fn targets(want: Want, outcome: &Outcome, drawn: &Drawn, style: &Style) -> Vec<Json> {
    let shown = Shown { drawn, style };
    let points = |kinds: &'static [&'static str]| outcome.special_points.iter().filter(move |p| kinds.contains(&p.kind.as_str()));
    let mut out = Vec::new();
    match want {
        Want::Campbell => {
            for p in points(&["critical_speed"]) {
                let order = evidence(p, "order").unwrap_or(1.0);
                let name = shown.style.word("critical_speed");
                out.push(shown.target("critical_speed", json!({ "at": p.at, "order": order }), &name, (p.at, Some(order * p.at)), "x"));
            }
        }
        Want::Stability => {
            for p in points(&["instability_onset", "instability_end"]) {
                let name = shown.style.word(&p.kind);
                out.push(shown.target("stability_limit", json!({ "at": p.at }), &name, (p.at, None), "x"));
            }
        }
        Want::Forced => {
            for p in points(&["resonance"]) {
                let name = format!("{} {}", shown.style.word(&p.kind), shown.style.subject(&p.subject));
                let height = p.evidence.first().filter(|e| e.unit == "m").map(|e| e.value);
                out.push(shown.target("resonance", json!({ "at": p.at, "body": p.subject }), &name, (p.at, height), "x"));
                if height.is_some() {
                    let which = json!({ "at": p.at, "body": p.subject, "size": true });
                    out.push(shown.target("resonance", which, &name, (p.at, height), "y"));
                }
            }
        }
        Want::Nonlinear => {
            for p in points(&["fold"]) {
                let name = shown.style.word(&p.kind);
                out.push(shown.target("jump", json!({ "at": p.at }), &name, (p.at, None), "x"));
            }
            for (body, speed, height) in largest(outcome) {
                let name = shown.style.owner(&body);
                let which = json!({ "at": speed, "body": body, "size": true });
                out.push(shown.target("peak", which, &name, (speed, Some(height)), "y"));
            }
        }
        Want::Page | Want::Modes | Want::Motion => {}
    }
    out.truncate(MOST);
    out
}

/// Largest displacement of every body, and the speed there, where it is no end of the range.
fn largest(outcome: &Outcome) -> Vec<(String, f64, f64)> {
    const END: &str = " largest displacement";
    let Some(table) = outcome.find_table("response") else { return Vec::new() };
    let numbers = |name: &str| match table.column(name).map(|c| &c.data) {
        Some(Data::Float(v)) => v.as_slice(),
        _ => &[],
    };
    let speeds = numbers("speed");
    let low = speeds.iter().copied().fold(f64::INFINITY, f64::min);
    let high = speeds.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let one = |name: &str| {
        let body = name.strip_suffix(END)?;
        let (speed, height) = speeds.iter().zip(numbers(name)).max_by(|a, b| a.1.total_cmp(b.1))?;
        (*speed > low && *speed < high).then(|| (body.to_string(), *speed, *height))
    };
    table.columns().iter().filter_map(|c| one(&c.name)).collect()
}
