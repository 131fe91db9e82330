//! `results.json`: everything but the numbers of the tables, for programs.

use super::Report;
use super::write::Names;
use crate::outcome::{Arg, Check, End, Evidence, Finding, Message, Outcome, Overview, SpecialPoint, Status};
use crate::plain;
use serde_json::{Map, Value, json};

/// Version of the layout of `results.json`; changes when a reader would have to.
pub const SCHEMA: u32 = 2;

/// The JSON schema of `results.json`.
pub const RESULTS_SCHEMA: &str = include_str!("results.schema.json");

/// The text of `results.json`; its layout is [`RESULTS_SCHEMA`]. Keys stand in a fixed order; numbers that are not finite are `null`.
pub fn json(report: &Report) -> String {
    let names = Names::new(report);
    let p = &report.provenance;
    let settings: Map<String, Value> = p.settings.iter().map(|(k, v)| (k.clone(), json!(v))).collect();
    let studies: Vec<Value> = report.outcomes.iter().enumerate().map(|(i, o)| study(o, i, &names)).collect();
    let all = json!({
        "schema": SCHEMA,
        "machine": report.machine,
        "provenance": {
            "program": "laval",
            "version": p.version,
            "build": p.build,
            "processor": p.processor,
            "input": p.input_name,
            "input_hash": p.input_hash,
            "seed": p.seed,
            "settings": settings,
        },
        "overview": report.overview.as_ref().map(overview),
        "studies": studies,
    });
    // inside strings these escapes are JSON too, and outside of them there are no such characters
    plain::lines(&format!("{all:#}\n")).into_owned()
}

/// The first page: verdict and checks.
fn overview(page: &Overview) -> Value {
    let message = |m: &Message| json!({ "message": m.key, "args": args(m) });
    let check = |c: &Check| {
        json!({
            "check": c.what.key,
            "verdict": c.verdict.word(),
            "result": message(&c.result),
            "required": c.required.as_ref().map(arg),
            "margin": c.margin.map(number),
        })
    };
    json!({
        "operating_speed": page.operating.map(number),
        "operating_range": page.operating_range.map(|(from, to)| [number(from), number(to)]),
        "verdict": page.verdict.word(),
        "headline": page.headline.iter().map(message).collect::<Vec<_>>(),
        "checks": page.checks.iter().map(check).collect::<Vec<_>>(),
    })
}

/// A number, or null when it is not finite.
fn number(v: f64) -> Value {
    serde_json::Number::from_f64(v).map_or(Value::Null, Value::Number)
}

fn study(o: &Outcome, index: usize, names: &Names) -> Value {
    let tables: Vec<Value> = o
        .tables
        .iter()
        .enumerate()
        .map(|(k, t)| {
            let columns: Vec<Value> =
                t.columns().iter().map(|c| json!({ "name": c.name, "unit": c.unit, "doc": c.doc.to_string() })).collect();
            json!({ "name": t.name(), "doc": t.doc().to_string(), "file": names.table(index, k), "rows": t.rows(), "columns": columns })
        })
        .collect();
    let figures: Vec<Value> = o
        .figures
        .iter()
        .enumerate()
        .map(|(k, f)| json!({ "name": f.name, "title": f.title.to_string(), "alt": f.alt.to_string(), "file": names.figure(index, k) }))
        .collect();
    json!({
        "kind": o.kind,
        "name": o.name,
        "end": end(o),
        "parameter": o.parameter.as_ref().map(|p| json!({ "name": p.name, "unit": p.unit })),
        "findings": o.findings.iter().map(finding).collect::<Vec<_>>(),
        "special_points": o.special_points.iter().map(special).collect::<Vec<_>>(),
        "tables": tables,
        "figures": figures,
        "work": o.work.iter().map(|(k, v)| (k.clone(), json!(v))).collect::<Map<_, _>>(),
    })
}

fn end(o: &Outcome) -> Value {
    let mut end = json!({ "kind": o.end.word() });
    match o.end {
        End::StepTooSmall { at } | End::Unbounded { at } => end["at"] = number(at),
        End::NewtonFailed { at, residual } => {
            end["at"] = number(at);
            end["residual"] = number(residual);
        }
        End::Reached | End::Cancelled | End::MaxPoints | End::WorkLimit | End::Refused => {}
    }
    end["text"] = json!(o.end_in_words());
    end
}

fn finding(f: &Finding) -> Value {
    json!({
        "id": f.id,
        "level": f.level.word(),
        "subject": f.subject,
        "message": f.message.key,
        "args": args(&f.message),
        "notes": f.notes.iter().map(|m| json!({ "message": m.key, "args": args(m) })).collect::<Vec<_>>(),
        "value": f.value.map_or(Value::Null, number),
        "unit": f.unit,
        "evidence": evidence(&f.evidence),
    })
}

/// Arguments by name: `{ value, unit }`, `{ count }`, `{ name }`, `{ word }`, `{ term }`, `{ message, args }`, or an array of such.
fn args(m: &Message) -> Value {
    m.args.iter().map(|(name, a)| (name.to_string(), arg(a))).collect::<Map<_, _>>().into()
}

fn arg(a: &Arg) -> Value {
    match a {
        Arg::Quantity(q) => json!({ "value": number(q.value), "unit": q.unit }),
        Arg::Count(n) => json!({ "count": n }),
        Arg::Name(name) => json!({ "name": name }),
        Arg::Word(word) => json!({ "word": word }),
        Arg::Term(text) => json!({ "term": text }),
        Arg::Said(text) => json!({ "term": text.to_string() }),
        Arg::Phrase(m) => json!({ "message": m.key, "args": args(m) }),
        Arg::List(all) => all.iter().map(arg).collect::<Vec<_>>().into(),
    }
}

fn evidence(list: &[Evidence]) -> Vec<Value> {
    list.iter().map(|e| json!({ "what": e.what.to_string(), "value": number(e.value), "unit": e.unit })).collect()
}

fn special(p: &SpecialPoint) -> Value {
    let mut out =
        json!({ "kind": p.kind, "at": number(p.at), "bracket": [number(p.bracket.0), number(p.bracket.1)], "status": p.status.word() });
    if !p.subject.is_empty() {
        out["subject"] = json!(p.subject);
    }
    if let Status::Doubtful(reason) = &p.status {
        out["reason"] = json!(reason);
    }
    out["evidence"] = json!(evidence(&p.evidence));
    out
}
