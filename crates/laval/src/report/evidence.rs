//! The numbers that support the findings, in one table of the page.

use super::Report;
use super::html::say;
use super::text::prose;
use super::words::Style;
use crate::outcome::{Evidence, Finding};
use std::fmt::Write;

/// Place of a finding's rows in the table: number of the study, number of the finding.
fn place(study: usize, finding: usize) -> String {
    format!("e{study}-{finding}")
}

/// A link from a finding to its rows; nothing where it has none.
pub(super) fn link(style: &Style, f: &Finding, study: usize, finding: usize) -> String {
    match f.evidence.is_empty() {
        true => String::new(),
        false => format!(" <a class=\"where\" href=\"#{}\">{}</a>", place(study, finding), say(style, "page-evidence")),
    }
}

/// The table: the finding, its value, what it was checked by, and what that gave.
pub(super) fn table(s: &mut String, report: &Report) {
    let style = &report.style;
    let all = report.outcomes.iter().enumerate().flat_map(|(i, o)| o.findings.iter().enumerate().map(move |(k, f)| (i, k, o, f)));
    let known: Vec<_> = all.filter(|(.., f)| !f.evidence.is_empty()).collect();
    if known.is_empty() {
        return;
    }
    let heading = say(style, "page-evidence-all");
    let _ = writeln!(
        s,
        "<section class=\"study\" id=\"evidence\">\n<h2>{heading}</h2>\n<details class=\"table\"><summary>{heading} <span class=\"kind\">{}</span></summary>\n\
         <div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{heading}\"><table><thead><tr><th class=\"w\">{}</th><th class=\"w\">{}</th><th class=\"w\">{}</th><th>{}</th></tr></thead><tbody>",
        known.len(),
        say(style, "page-evidence-finding"),
        say(style, "page-evidence-value"),
        say(style, "page-evidence-checked"),
        say(style, "page-evidence-number"),
    );
    for (i, k, o, f) in known {
        let subject = if f.subject.is_empty() { String::new() } else { format!(" {}", prose(&style.subject(&f.subject))) };
        let value = f.message.args.iter().find(|a| a.0 == "value").map_or(String::new(), |a| prose(&style.arg(&a.1)));
        for (row, e) in f.evidence.iter().enumerate() {
            let Evidence { what, value: number, unit } = e;
            let name = match row {
                0 => format!("<a href=\"#s{i}\">{}</a>: {}{subject}", prose(&o.name), prose(&f.id.replace('_', " "))),
                _ => String::new(),
            };
            let id = if row == 0 { format!(" id=\"{}\"", place(i, k)) } else { String::new() };
            let _ = writeln!(
                s,
                "<tr{id}><td class=\"w\">{name}</td><td class=\"w\">{}</td><td class=\"w\">{}</td><td>{}</td></tr>",
                if row == 0 { value.as_str() } else { "" },
                prose(&style.arg(what)),
                prose(&style.number(*number, unit))
            );
        }
    }
    s.push_str("</tbody></table></div></details>\n</section>\n");
}
