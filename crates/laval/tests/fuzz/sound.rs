//! What every outcome must keep: no NaN and no infinity reported as a number.
//!
//! The rule: values and evidence of findings, places of special points and of the end are finite, and no sentence says "not a number".
//! In tables NaN means "no value" and is allowed only in columns whose documentation says so (it names NaN); infinity nowhere.

use laval::outcome::{Data, End, Outcome};
use laval::report::{self, Report, Terminal};

/// Words that a number which is none is printed as.
const NONE: [&str; 4] = ["NaN", "not a number", "inf ", "{}"];

pub fn words(text: &str) -> Result<(), String> {
    match NONE.iter().find(|w| text.contains(**w)) {
        Some(w) => Err(format!("the text {text:?} holds {w:?}")),
        None => Ok(()),
    }
}

fn finite(what: impl FnOnce() -> String, x: f64) -> Result<(), String> {
    if x.is_finite() { Ok(()) } else { Err(format!("{} is {x}", what())) }
}

pub fn check(o: &Outcome) -> Result<(), String> {
    match o.end {
        End::StepTooSmall { at } => finite(|| "the place of the end".into(), at)?,
        End::NewtonFailed { at, .. } => finite(|| "the place of the end".into(), at)?,
        _ => {}
    }
    words(&o.end_in_words())?;
    for f in &o.findings {
        for x in f.value.iter() {
            finite(|| format!("finding {}: {:?}", f.id, f.sentence()), *x)?;
        }
        words(&f.sentence())?;
        for e in &f.evidence {
            finite(|| format!("evidence {:?} of finding {}", e.what, f.id), e.value)?;
        }
    }
    for p in &o.special_points {
        finite(|| format!("special point {}", p.kind), p.at)?;
        finite(|| format!("bracket of special point {}", p.kind), p.bracket.0)?;
        finite(|| format!("bracket of special point {}", p.kind), p.bracket.1)?;
        for e in &p.evidence {
            finite(|| format!("evidence {:?} of special point {}", e.what, p.kind), e.value)?;
        }
    }
    for t in &o.tables {
        for c in t.columns() {
            let Data::Float(values) = &c.data else { continue };
            let place = |i: usize| format!("table {}, column {:?}, row {i} of {}", t.name(), c.name, values.len());
            if let Some(i) = values.iter().position(|x| x.is_infinite()) {
                return Err(format!("{} is infinite", place(i)));
            }
            if let Some(i) = values.iter().position(|x| x.is_nan())
                && !c.doc.to_string().contains("NaN")
            {
                return Err(format!("{} is NaN, which its documentation does not mention", place(i)));
            }
        }
    }
    Ok(())
}

/// The work done stays within the limit: a step or a spectrum under way may be finished, and a response is followed from both ends of the range.
pub fn within(o: &Outcome, limit: u64) -> Result<(), String> {
    let done = |name: &str| o.work.get(name).copied().unwrap_or(0);
    let most = match o.kind.as_str() {
        "modes" => return Ok(()),
        "nonlinear_response" => 2 * limit.max(2),
        // a chunk of responses that is begun is finished
        "response_map" => (1 + 2 * 256) * limit.max(2),
        // every row of a map counts the rows before it as done
        "stability_map" => (limit + 3) * (limit + 1),
        _ => limit + 3,
    };
    let all = done("steps") + done("rejected_steps") + done("eigenproblems") + done("solutions") + done("points");
    if all <= most { Ok(()) } else { Err(format!("{all} units of work were done, {most} allowed")) }
}

/// All text forms can be written, and no picture holds a place that is no number.
pub fn written(outcome: Outcome) -> Result<(), String> {
    for figure in &outcome.figures {
        let svg = report::draw(figure, &outcome.tables).map_err(|e| e.to_string())?;
        if let Some(at) = svg.find("NaN").or_else(|| svg.find("\"inf")) {
            return Err(format!("figure {} holds a place that is no number: {:?}", figure.name, svg.get(at.saturating_sub(60)..at + 20)));
        }
        words(&figure.alt.to_string())?;
    }
    for table in outcome.tables.iter().filter(|t| t.rows() < 2000) {
        report::csv(table);
    }
    let report = Report { outcomes: vec![outcome], ..Report::default() };
    report::json(&report);
    report::terminal(&report, Terminal::default());
    report::html(&report).map_err(|e| e.to_string())?;
    Ok(())
}
