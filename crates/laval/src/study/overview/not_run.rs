//! The first page of a machine whose studies have not been run.

use crate::outcome::{Arg, Message, Overview, Verdict};

/// Kinds of studies whose answers are those of the page itself.
const ON_PAGE: [&str; 4] = ["modes", "campbell", "critical_speeds", "forced_response"];

/// Of studies that the page requests it names those of the file, given with name and kind; what they find may be worse than what is on the page, which is therefore never
/// good with them.
pub fn with_studies_not_run(mut page: Overview, studies: &[(&str, &str)]) -> Overview {
    let own = |kinds: &[&str]| studies.iter().find(|s| kinds.contains(&s.1)).map(|s| s.0);
    page.next.retain(|m| match m.key.as_str() {
        "next-studies" => studies.is_empty(),
        "next-run-up" => own(&["run_up"]).is_none(),
        _ => true,
    });
    if own(&["nonlinear_response"]).is_some() {
        page.left_out.iter_mut().filter(|m| m.key == "left-linear").for_each(|m| m.key = "left-linear-modes".into());
    }
    for check in &mut page.checks {
        let kinds: &[&str] = match (check.result.key.as_str(), check.what.key.as_str()) {
            ("stability-needs-stationary", _) => &["stationary"],
            ("balls-no-study", _) => &["stationary", "transient"],
            ("why-too-long", "check-stability" | "check-instability") => &["stability_map", "modes"],
            ("why-too-long", "check-resonance") => &["critical_speeds", "campbell"],
            _ => continue,
        };
        if let Some(name) = own(kinds) {
            check.result = Message::new("check-run-study").arg("study", Arg::name(name));
        }
    }
    let others: Vec<Arg> = studies.iter().filter(|s| !ON_PAGE.contains(&s.1)).map(|s| Arg::name(s.0)).collect();
    if !others.is_empty() {
        page.headline.push(Message::new("headline-studies-not-run").arg("studies", Arg::List(others)));
        page.verdict = page.verdict.max(Verdict::NotComputed);
    }
    page
}
