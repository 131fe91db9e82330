//! The gallery: an index and one page for each case.

use super::case::{Case, Verdict};
use super::check::{Checked, Compared};
use super::markdown::{Kind, html, inline};
use super::marks::marked;
use super::table::Expectation;
use crate::diagnostic::Diagnostics;
use crate::file::{Form, render};
use crate::outcome::{OutcomeError, unit_text};
use crate::report::{escape, figure, file_name, page};
use crate::units::format_number;
use std::fmt::Write;

const CSS: &str = include_str!("gallery.css");

/// A case as the gallery shows it.
#[derive(Debug)]
pub enum Page {
    /// It was read and run, as far as it could.
    Checked(Box<Checked>),
    /// Its document cannot be read.
    Unreadable {
        /// `topic/case`.
        id: String,
        /// The document.
        text: String,
        /// What is wrong.
        found: Diagnostics,
    },
}

impl Page {
    /// `topic/case`.
    pub fn id(&self) -> &str {
        match self {
            Page::Checked(c) => &c.case.id,
            Page::Unreadable { id, .. } => id,
        }
    }
    /// The verdicts are those the document states.
    pub fn holds(&self) -> bool {
        match self {
            Page::Checked(c) => c.holds(),
            Page::Unreadable { .. } => false,
        }
    }
    /// The verdict found, in words.
    pub fn verdict(&self) -> &'static str {
        match self {
            Page::Checked(c) => c.verdict().map_or("cannot run", Verdict::words),
            Page::Unreadable { .. } => "cannot be read",
        }
    }
    /// What is wrong, with the lines of the document; empty when nothing is.
    pub fn complaint(&self, form: Form) -> String {
        match self {
            Page::Checked(c) if c.problems.0.is_empty() => String::new(),
            Page::Checked(c) => render(&c.problems, &c.case.text, &format!("{}.md", c.case.id), form),
            Page::Unreadable { id, text, found } => render(found, text, &format!("{id}.md"), form),
        }
    }
    /// The name of its file in the gallery.
    pub fn file(&self) -> String {
        format!("{}.html", file_name(&self.id().replace('/', "-")))
    }
}

/// The gallery as files: name and content, the index first.
///
/// # Errors
/// When a figure of a study contradicts its tables.
pub fn gallery(pages: &[Page]) -> Result<Vec<(String, String)>, OutcomeError> {
    let mut out = vec![("index.html".to_string(), index(pages))];
    for p in pages {
        out.push((p.file(), one(p)?));
    }
    Ok(out)
}

fn badge(words: &str, holds: bool) -> String {
    let class = match words {
        "agrees" => "good",
        "within source scatter" => "fair",
        "differs (explained)" | "differs" => "known",
        _ => "bad",
    };
    let mark = if holds { "" } else { " <span class=\"badge bad\">! changed</span>" };
    format!("<span class=\"badge {class}\">{words}</span>{mark}")
}

fn topic_words(topic: &str) -> String {
    let words = topic.replace(['-', '_'], " ");
    let mut chars = words.chars();
    chars.next().map(|c| c.to_uppercase().chain(chars).collect()).unwrap_or_default()
}

fn index(pages: &[Page]) -> String {
    let count = |words: &str| pages.iter().filter(|p| p.verdict() == words).count();
    let mut parts: Vec<String> = Verdict::ALL
        .iter()
        .map(|v| v.words())
        .chain(["cannot run", "cannot be read"])
        .filter_map(|w| {
            let n = count(w);
            (n > 0).then(|| format!("{w} {n}"))
        })
        .collect();
    let changed = pages.iter().filter(|p| !p.holds()).count();
    if changed > 0 {
        parts.push(format!("<strong class=\"alarm\">{changed} not as the page states</strong>"));
    }
    let mut s = format!(
        "<header>\n<h1>Validation gallery</h1>\n<p class=\"from\">laval {} · {} cases · {}</p>\n</header>\n<main>\n\
         <p>Each case states what is required, where its numbers come from and how far they may be off, then runs a machine the ordinary way and \
         compares. A case that differs stays, with the reason.</p>\n",
        env!("CARGO_PKG_VERSION"),
        pages.len(),
        parts.join(" · ")
    );
    let topic = |p: &Page| p.id().split_once('/').map_or(String::new(), |t| t.0.to_string());
    for group in pages.chunk_by(|a, b| topic(a) == topic(b)) {
        let name = topic_words(&topic(&group[0]));
        let _ = write!(
            s,
            "<h2>{}</h2>\n<div class=\"scroll\" tabindex=\"0\"><table class=\"cases\"><thead><tr><th class=\"w\">case</th><th class=\"w\">evidence</th>\
             <th class=\"w\">verdict</th><th>values</th><th>largest error<small>over tolerance</small></th></tr></thead><tbody>\n",
            escape(&name)
        );
        for p in group {
            let (title, evidence, values, worst) = match p {
                Page::Checked(c) => (inline(&c.case.title), c.case.evidence.word(), c.case.expected.len().to_string(), times(c.worst())),
                Page::Unreadable { id, .. } => (escape(id), "", String::new(), String::new()),
            };
            let _ = writeln!(
                s,
                "<tr><td class=\"w\"><a href=\"{}\">{title}</a></td><td class=\"w\">{evidence}</td><td class=\"w\">{}</td><td>{values}</td><td>{worst}</td></tr>",
                p.file(),
                badge(p.verdict(), p.holds())
            );
        }
        s.push_str("</tbody></table></div>\n");
    }
    s.push_str("</main>\n<footer></footer>\n");
    page("Validation gallery · laval", CSS, &s)
}

/// A ratio for people.
fn times(x: f64) -> String {
    if x.is_infinite() { "∞".into() } else { format_number(x, 2) }
}

fn one(p: &Page) -> Result<String, OutcomeError> {
    let mut s = String::new();
    let title = match p {
        Page::Unreadable { id, text, .. } => {
            let _ = write!(
                s,
                "<header><p class=\"from\"><a href=\"index.html\">Validation gallery</a></p>\n<h1>{}</h1></header>\n<main>\n<p>{}</p>\n<pre tabindex=\"0\">{}</pre>\n\
                 <details><summary>Document</summary><pre tabindex=\"0\">{}</pre></details></main>\n<footer></footer>\n",
                escape(id),
                badge(p.verdict(), false),
                escape(&p.complaint(Form::Lines)),
                escape(text)
            );
            id.clone()
        }
        Page::Checked(c) => {
            checked(&mut s, p, c)?;
            c.case.title.clone()
        }
    };
    Ok(page(&format!("{title} · laval validation"), CSS, &s))
}

fn checked(s: &mut String, p: &Page, c: &Checked) -> Result<(), OutcomeError> {
    let case = &c.case;
    let _ = writeln!(
        s,
        "<header>\n<p class=\"from\"><a href=\"index.html\">Validation gallery</a> · {}</p>\n<h1>{}</h1>\n<p>{}</p>\n</header>\n<main>",
        escape(&topic_words(case.topic())),
        inline(&case.title),
        badge(p.verdict(), p.holds())
    );
    if !p.holds() && c.verdict().is_some() {
        let _ = writeln!(s, "<p class=\"alarm\">The page states \"{}\"; its rows state what is marked below.</p>", case.verdict.words());
    }
    if !c.problems.0.is_empty() {
        let _ = writeln!(s, "<pre class=\"alarm\" tabindex=\"0\">{}</pre>", escape(&p.complaint(Form::Lines)));
    }
    let _ = writeln!(
        s,
        "<dl class=\"facts\"><dt>Requirement</dt><dd>{}</dd><dt>Source</dt><dd>{}</dd><dt>Evidence</dt><dd>{}</dd></dl>",
        inline(&case.requirement),
        inline(&case.source),
        case.evidence.word()
    );
    let mut drawn = false;
    for (i, block) in case.blocks.iter().enumerate() {
        match &block.kind {
            Kind::Heading(1, _) => continue,
            _ if i == case.facts_block => continue,
            _ if i == case.expected_block => {
                expected(s, case, &c.compared);
                figures(s, c)?;
                drawn = true;
            }
            Kind::Code { info, code } if info == "toml machine" => {
                let name = machine_name(&case.text[code.clone()]);
                let _ = write!(s, "<details><summary>Machine file{name}</summary>{}</details>", html(block, &case.text));
            }
            _ => s.push_str(&html(block, &case.text)),
        }
    }
    if !drawn {
        figures(s, c)?;
    }
    s.push_str("</main>\n<footer></footer>\n");
    Ok(())
}

/// The first name of a machine file, which is that of the machine, to stand behind other words.
fn machine_name(text: &str) -> String {
    let name = text.lines().find_map(|l| l.trim().strip_prefix("name")?.trim_start().strip_prefix('='));
    name.map_or(String::new(), |n| format!(": {}", escape(n.trim().trim_matches('"'))))
}

fn figures(s: &mut String, c: &Checked) -> Result<(), OutcomeError> {
    for (i, o) in c.outcomes.iter().enumerate() {
        for (k, f) in o.figures.iter().enumerate() {
            if c.outcomes.len() > 1 && k == 0 {
                let _ = writeln!(s, "<h3>Study {}</h3>", escape(&o.name));
            }
            let id = format!("f{i}-{k}");
            match marked(f, o, &c.case.expected)? {
                Some((f, tables)) => s.push_str(&figure(&f, &tables, &id)?),
                None => s.push_str(&figure(f, &o.tables, &id)?),
            }
        }
    }
    Ok(())
}

fn expected(s: &mut String, case: &Case, compared: &[Compared]) {
    let many = case.expected.iter().any(|e| e.study != case.expected[0].study);
    let notes = case.expected.iter().any(|e| !e.note.is_empty());
    let _ = writeln!(
        s,
        "<div class=\"scroll\" tabindex=\"0\"><table class=\"values\"><thead><tr><th class=\"w\">value</th><th>expected</th><th>measured</th>\
         <th>error<small>tolerance</small></th><th>error over<small>tolerance</small></th><th class=\"w\">verdict</th>{}</tr></thead><tbody>",
        if notes { "<th class=\"w\">note</th>" } else { "" }
    );
    for (i, e) in case.expected.iter().enumerate() {
        let found = compared.get(i).filter(|_| compared.len() == case.expected.len());
        let study = if many { e.study.as_str() } else { "" };
        let place: Vec<&str> = [study, &e.at].into_iter().filter(|t| !t.is_empty()).collect();
        let _ = write!(
            s,
            "<tr><td class=\"w\">{}<small>{}</small></td><td>{}</td>",
            escape(&e.value),
            escape(&place.join(": ")),
            with_unit(&e.expected_text, e)
        );
        let (measured, error, ratio, verdict) = match found {
            Some(c) => (format_number(c.measured, 12), format_number(c.error, 2), times(c.ratio), badge(c.row.word(), c.row == e.stated)),
            None => (String::new(), String::new(), String::new(), badge("not run", true)),
        };
        let _ =
            write!(s, "<td>{measured}</td><td>{error}<small>{}</small></td><td>{ratio}</td><td class=\"w\">{verdict}</td>", tolerance(e));
        if notes {
            let _ = write!(s, "<td class=\"w\">{}</td>", inline(&e.note));
        }
        s.push_str("</tr>\n");
    }
    s.push_str("</tbody></table></div>\n");
}

fn with_unit(number: &str, e: &Expectation) -> String {
    let unit = unit_text(&e.unit);
    match unit.as_str() {
        "" => escape(number),
        u if u.starts_with(|c: char| c.is_ascii_digit()) && !u.starts_with("1/") => {
            format!("{}<small>times {}</small>", escape(number), escape(u))
        }
        u => format!("{} {}", escape(number), escape(u)),
    }
}

fn tolerance(e: &Expectation) -> String {
    let scatter = e.scatter.map_or(String::new(), |t| format!(", scatter {}", t.words()));
    e.tolerance.map_or(String::new(), |t| t.words()) + &scatter
}
