//! What a study answers to a machine, and how far two answers are from each other.

use laval::diagnostic::Diagnostic;
use laval::file;
use laval::outcome::{Data, Level, Outcome};
use laval::study::Context;

/// What a study answers to a machine.
pub enum Answer {
    Outcome(Box<Outcome>),
    Refused(Vec<Diagnostic>),
}

pub fn ask(machine: &str, kind: &str, fields: &str) -> Answer {
    let text = format!("{machine}[[study]]\nkind = \"{kind}\"\n{fields}\n");
    let loaded = match file::load(&text) {
        Ok(loaded) => loaded,
        Err(d) => return Answer::Refused(d.0),
    };
    match loaded.studies[0].study.run(&loaded.system, &Context::quiet("walk")) {
        Ok(o) => Answer::Outcome(Box::new(o)),
        Err(d) => Answer::Refused(vec![d]),
    }
}

/// A diagnostic speaks of the part, or of the property of the whole machine that the case has.
fn speaks(d: &Diagnostic, words: &[&str]) -> bool {
    words.iter().any(|w| d.message.contains(w) || d.help.as_deref().is_some_and(|h| h.contains(w)))
}

impl Answer {
    /// Refused for a reason in which one of these words stands.
    pub fn refused(&self, words: &[&str]) -> Option<bool> {
        match self {
            Answer::Outcome(_) => None,
            Answer::Refused(d) => Some(d.iter().any(|d| speaks(d, words))),
        }
    }

    pub fn text(&self) -> String {
        match self {
            Answer::Refused(d) => d.iter().map(|d| d.message.to_string()).collect::<Vec<_>>().join("; "),
            Answer::Outcome(o) => o.findings.iter().map(|f| format!("{} {:?}: {}\n", f.id, f.level, f.sentence())).collect(),
        }
    }

    /// Findings outside the validity of the part of this name.
    pub fn outside(&self, part: &str) -> usize {
        let of = |f: &&laval::outcome::Finding| f.level == Level::Invalid && (f.subject.contains(part) || f.sentence().contains(part));
        match self {
            Answer::Refused(_) => 0,
            Answer::Outcome(o) => o.findings.iter().filter(of).count(),
        }
    }
}

/// Evidence of the computation, and angles that may turn by whole turns.
const ASIDE: [&str; 13] = [
    "error",
    "residual",
    "uncertainty",
    "bracket",
    "remaining",
    "settled",
    "slope left",
    "truncation",
    "growth left",
    "iterations",
    "steps",
    "phase",
    "validity",
];

/// Largest relative difference of findings and columns; infinite where other things are found. Columns that one of them lacks are left out.
pub fn difference(a: &Outcome, b: &Outcome) -> f64 {
    let of = |x: &[f64], y: &[f64]| {
        let size = x.iter().chain(y).filter(|v| v.is_finite()).fold(0.0f64, |m, v| m.max(v.abs()));
        let far = x.iter().zip(y).map(|(x, y)| if x.is_nan() && y.is_nan() || x == y { 0.0 } else { (x - y).abs() });
        let far = far.fold(0.0, |m, d| if d <= m { m } else { d });
        // what is rounding in both is equal
        if far == 0.0 || size < 1e-11 { 0.0 } else { far / size }
    };
    let answers = |o: &Outcome| {
        let all = o.findings.iter().filter(|f| f.id != "energy_balance" && f.level != Level::Invalid);
        all.map(|f| (f.id.clone(), f.subject.clone(), f.value.unwrap_or(0.0))).collect::<Vec<_>>()
    };
    let (x, y) = (answers(a), answers(b));
    if x.len() != y.len() || x.iter().zip(&y).any(|(x, y)| (&x.0, &x.1) != (&y.0, &y.1)) {
        return f64::INFINITY;
    }
    let findings = x.iter().zip(&y).filter(|(x, _)| !ASIDE.iter().any(|w| x.0.contains(w))).map(|(x, y)| of(&[x.2], &[y.2]));
    let mut worst = findings.fold(0.0, |m, d: f64| if d <= m { m } else { d });
    for (t, u) in a.tables.iter().filter_map(|t| Some((t, b.tables.iter().find(|u| u.name() == t.name())?))) {
        if t.rows() != u.rows() {
            return f64::INFINITY;
        }
        for c in t.columns().iter().filter(|c| !ASIDE.iter().any(|w| c.name.contains(w))) {
            if let (Data::Float(x), Some(Data::Float(y))) = (&c.data, u.column(&c.name).map(|c| &c.data)) {
                let d = of(x, y);
                worst = if d <= worst { worst } else { d };
            }
        }
    }
    worst
}
