//! Machine files run as a whole.

use laval::file::Loaded;
use laval::outcome::{Finding, Outcome};
use laval::study::Context;

/// A machine file without mistakes.
pub fn load(text: &str) -> Loaded {
    laval::file::load(text).unwrap_or_else(|d| panic!("{d:?}"))
}

/// Outcomes of all its studies.
pub fn run_all(text: &str) -> Vec<Outcome> {
    let loaded = load(text);
    loaded.studies.iter().map(|s| s.study.run(&loaded.system, &Context::quiet("study")).unwrap_or_else(|d| panic!("{d:?}"))).collect()
}

/// Findings with this id.
pub fn findings<'o>(o: &'o Outcome, id: &str) -> Vec<&'o Finding> {
    o.findings.iter().filter(|f| f.id == id).collect()
}

/// The first finding with this id.
pub fn finding<'o>(o: &'o Outcome, id: &str) -> &'o Finding {
    let ids = || o.findings.iter().map(|f| (f.id.as_str(), f.sentence())).collect::<Vec<_>>();
    findings(o, id).first().copied().unwrap_or_else(|| panic!("no {id} in {:?}", ids()))
}
