//! The first page of a report: verdict, checks, machine, behaviour over the speed, modes, what to do next.

mod drawing;
mod over_speed;
mod shapes;

pub(super) use drawing::drawing;
pub(super) use over_speed::{over_speed, tables};
pub(super) use shapes::modes;

use super::text::prose;
use super::words::Style;
use crate::outcome::{Arg, Check, Message, Overview, Verdict};
use std::fmt::Write;

/// Class of the style sheet of a verdict.
fn class(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Passed => "ok",
        Verdict::Attention => "ck",
        Verdict::Failed => "bad",
        Verdict::NoLimit | Verdict::NotComputed => "no",
    }
}

/// The word of a verdict, with the margin: the long word, or the `short` one of the terminal.
pub(super) fn verdict(style: &Style, check: &Check, short: bool) -> String {
    let family = if short { "short-" } else { "verdict-" };
    // beside its margin, a requirement that is not kept needs no longer word
    let key = match (check.verdict, check.margin) {
        (Verdict::Attention, Some(_)) if short => "near",
        _ => check.verdict.word(),
    };
    let word = style.message(&Message::new([family, key].concat()));
    match check.margin {
        Some(m) => format!("{word}{} {}", if short { "" } else { "," }, style.arg(&Arg::percent(m).digits(2))),
        None => word,
    }
}

/// What is required, or that nothing is.
pub(super) fn required(style: &Style, check: &Check) -> String {
    match (&check.required, check.verdict) {
        (Some(r), _) => style.arg(r),
        (None, Verdict::NoLimit) => style.message(&Message::new("page-not-set")),
        (None, _) => String::new(),
    }
}

/// A result begins with a capital letter where it stands as a sentence.
pub(super) fn sentence(style: &Style, m: &Message) -> String {
    let text = style.message(m);
    let mut chars = text.chars();
    match chars.next() {
        Some(first) => first.to_uppercase().chain(chars).collect(),
        None => text,
    }
}

/// Banner, what to do next, checks, machine; the figure over the speed comes from the caller, who draws all figures alike.
pub(super) fn head(s: &mut String, page: &Overview, style: &Style) {
    let say = |m: &Message| prose(&style.message(m));
    let title = |key: &str| prose(&style.message(&Message::new(key)));
    let headline: Vec<String> = page.headline.iter().map(say).collect();
    let _ = write!(s, "<div class=\"verdict {}\" role=\"status\">\n<p class=\"v\">{}</p>\n", class(page.verdict), headline.join(" "));
    if !page.remarks.is_empty() {
        s.push_str("<ul>\n");
        for (heading, texts) in &page.remarks {
            let texts: Vec<String> = texts.iter().map(|t| prose(&sentence(style, t))).collect();
            let _ = writeln!(s, "<li><b>{}</b>{}</li>", say(heading), texts.join(" "));
        }
        s.push_str("</ul>\n");
    }
    s.push_str("</div>\n");
    listed(s, "page-next", &page.next, style);
    s.push_str("<div class=\"two\">\n");
    if !page.checks.is_empty() {
        let _ = write!(
            s,
            "<section><h2>{}</h2>\n<table class=\"chk\"><thead><tr><th>{}</th><th>{}</th><th>{}</th><th>{}</th></tr></thead><tbody>\n",
            title("page-checks"),
            title("page-check"),
            title("page-result"),
            title("page-required"),
            title("page-verdict")
        );
        for c in &page.checks {
            let detail = c.detail.as_ref().map_or(String::new(), |d| format!("<small>{}</small>", say(d)));
            let _ = writeln!(
                s,
                "<tr><td>{}</td><td>{}{detail}</td><td{}>{}</td><td class=\"s {}\">{}</td></tr>",
                say(&c.what),
                say(&c.result),
                // on a narrow screen the heading stands before the value
                if c.required.is_some() || c.verdict == Verdict::NoLimit {
                    format!(" data-head=\"{}\"", title("page-required"))
                } else {
                    String::new()
                },
                prose(&required(style, c)),
                class(c.verdict),
                prose(&verdict(style, c, false))
            );
        }
        s.push_str("</tbody></table></section>\n");
    }
    if !page.machine.is_empty() {
        let _ = writeln!(s, "<figure class=\"mach\"><figcaption>{}</figcaption>", title("page-machine"));
        s.push_str(&drawing(page, style));
        s.push_str("</figure>\n");
    }
    s.push_str("</div>\n");
}

/// Modes, what the page leaves out.
pub(super) fn tail(s: &mut String, page: &Overview, style: &Style) {
    if let (Some(speed), false) = (page.operating, page.modes.is_empty()) {
        let heading = style.message(&Message::new("page-modes").arg("speed", Arg::speed(speed)));
        let _ = writeln!(s, "<section class=\"page\"><h2>{}</h2>", prose(&heading));
        modes(s, page, style);
        s.push_str("</section>\n");
    }
    listed(s, "page-left-out", &page.left_out, style);
}

/// Sentences under a heading; nothing without sentences.
fn listed(s: &mut String, heading: &str, list: &[Message], style: &Style) {
    if list.is_empty() {
        return;
    }
    let _ = writeln!(s, "<section class=\"page\"><h2>{}</h2>\n<ul class=\"plain\">", prose(&style.message(&Message::new(heading))));
    for m in list {
        let _ = writeln!(s, "<li>{}</li>", prose(&style.message(m)));
    }
    s.push_str("</ul></section>\n");
}
