//! Diagnostics for people and for tools.

use super::written_units;
use crate::diagnostic::{Diagnostic, Diagnostics, Severity, Span};
use crate::language::Language;
use crate::plain;
use crate::text;
use crate::text::Text;
use crate::units;
use miette::{GraphicalReportHandler, GraphicalTheme, LabeledSpan, NamedSource};
use serde_json::{Value as Json, json};
use std::fmt::{self, Write as _};

/// How diagnostics are shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// With the lines of the file and marks below them, for a terminal of this width.
    Excerpts {
        /// Columns.
        width: usize,
        /// ANSI colours.
        colour: bool,
    },
    /// One line each, `file:line:column: error: ...`, for logs and editors.
    Lines,
}

impl Form {
    /// Excerpts on a terminal (with colours unless the environment says `NO_COLOR`), lines elsewhere.
    pub fn for_stream(stream: &impl std::io::IsTerminal, width: usize) -> Self {
        if stream.is_terminal() {
            Form::Excerpts { width, colour: std::env::var_os("NO_COLOR").is_none_or(|v| v.is_empty()) }
        } else {
            Form::Lines
        }
    }
}

/// Most diagnostics shown to people; a broken file can have thousands.
const MOST: usize = 50;
/// Longest line shown in an excerpt, bytes.
const LONGEST_LINE: usize = 400;

struct Shown<'a> {
    d: &'a Diagnostic,
    voice: &'a Voice,
    message: String,
    source: &'a NamedSource<String>,
    span: Span,
}

impl fmt::Debug for Shown<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}
impl fmt::Display for Shown<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}
impl std::error::Error for Shown<'_> {}
impl miette::Diagnostic for Shown<'_> {
    fn code<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        Some(Box::new(self.d.code))
    }
    fn severity(&self) -> Option<miette::Severity> {
        Some(match self.d.severity {
            Severity::Error => miette::Severity::Error,
            Severity::Warning => miette::Severity::Warning,
        })
    }
    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        self.d.help.as_ref().map(|h| Box::new(self.voice.line(h)) as Box<dyn fmt::Display>)
    }
    fn source_code(&self) -> Option<&dyn miette::SourceCode> {
        Some(self.source)
    }
    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let label = self.d.label.as_deref().map(|l| self.voice.line(l));
        let s = LabeledSpan::new_primary_with_span(label, (self.span.start, self.span.len()));
        Some(Box::new(std::iter::once(s)))
    }
}

/// A place inside the text, on character borders and in one line.
fn clamp(text: &str, span: &Span) -> Span {
    let mut start = span.start.min(text.len());
    while !text.is_char_boundary(start) {
        start -= 1;
    }
    let mut end = span.end.clamp(start, text.len());
    while !text.is_char_boundary(end) {
        end += 1;
    }
    if let Some(i) = text[start..end].find('\n') {
        end = start + i;
    }
    start..end
}

/// Line and column (in characters), both from 1.
fn line_column(text: &str, at: usize) -> (usize, usize) {
    let before = &text[..at];
    let line_start = before.rfind('\n').map_or(0, |i| i + 1);
    (before.bytes().filter(|&b| b == b'\n').count() + 1, text[line_start..at].chars().count() + 1)
}

/// How sentences are written: in a language, with values in the units of the file, those at the place that is meant first.
struct Voice {
    language: Language,
    units: Vec<String>,
}

impl Voice {
    fn new(language: Language, file: &[String], text: &str, span: Option<&Span>) -> Voice {
        let here = span.map_or_else(Vec::new, |s| units_at(text, s));
        Voice { language, units: here.into_iter().chain(file.iter().cloned()).collect() }
    }

    fn say(&self, text: &Text) -> String {
        self.language.said_in(text, &self.units)
    }

    /// In one line.
    fn line(&self, text: &Text) -> String {
        plain::line(&self.say(text)).into_owned()
    }
}

/// Units of a file, the most frequent first.
fn units_of(text: &str) -> Vec<String> {
    written_units(text).into_iter().map(|u| u.0).collect()
}

/// Units of the quantities in quotation marks at a place.
fn units_at(text: &str, span: &Span) -> Vec<String> {
    const LONGEST: usize = 2000;
    let here = text.get(span.clone()).filter(|t| t.len() < LONGEST).unwrap_or_default();
    let mut out = Vec::new();
    let mut rest = here;
    while let Some(at) = rest.find(['"', '\'']) {
        let quote = &rest[at..=at];
        let inside = &rest[at + 1..];
        let Some(end) = inside.find(quote) else { break };
        out.extend(units::unit_of(&inside[..end]).map(str::to_string));
        rest = &inside[end + 1..];
    }
    out
}

fn word(s: Severity) -> Text {
    match s {
        Severity::Error => text!("error"),
        Severity::Warning => text!("warning"),
    }
}

/// What stands before a help.
fn help_word() -> Text {
    text!("help")
}

/// The message, with the lines of the other places where the same is wrong.
fn message(d: &Diagnostic, text: &str) -> Text {
    /// Most lines named.
    const LINES: usize = 8;
    let mut lines: Vec<usize> = d.also().iter().map(|s| line_column(text, clamp(text, s).start).0).collect();
    lines.dedup();
    let left = lines.len().saturating_sub(LINES);
    let mut shown: Vec<String> = lines.iter().take(LINES).map(usize::to_string).collect();
    let message = &d.message;
    if left > 0 {
        return text!("{message} (also named in lines {lines} and {left} more)", message, lines = shown.join(", "), left);
    }
    match (shown.pop(), shown.as_slice()) {
        (None, _) => message.clone(),
        (Some(line), []) => text!("{message} (also named in line {line})", message, line),
        (Some(last), many) => text!("{message} (also named in lines {lines} and {last})", message, lines = many.join(", "), last),
    }
}

fn one_line(out: &mut String, d: &Diagnostic, text: &str, file: &str, voice: &Voice) {
    let place = d.span.as_ref().map(|s| line_column(text, clamp(text, s).start)).map_or(String::new(), |(l, c)| format!(":{l}:{c}"));
    let (severity, message) = (voice.line(&word(d.severity)), voice.line(&message(d, text)));
    let _ = writeln!(out, "{}{place}: {severity}[{}]: {message}", plain::line(file), d.code);
    if let Some(h) = &d.help {
        let _ = writeln!(out, "  {}: {}", voice.say(&help_word()), voice.line(h));
    }
}

/// The excerpts of the library that draws them end with its own word for the help.
fn name_help(out: &mut String, begin: usize, language: Language) {
    const WORD: &str = "  help: ";
    let own = language.said(&help_word());
    if let Some(at) = out[begin..].rfind(WORD).filter(|_| language != Language::English) {
        out.replace_range(begin + at..begin + at + WORD.len(), &format!("  {own}: "));
    }
}

/// Shows diagnostics of the file `file` with the content `text`, in the order of their places. Control characters are shown as escapes.
pub fn render(diagnostics: &Diagnostics, text: &str, file: &str, form: Form) -> String {
    render_in(Language::English, diagnostics, text, file, form)
}

/// [`render`] in a language.
pub fn render_in(language: Language, diagnostics: &Diagnostics, text: &str, file: &str, form: Form) -> String {
    let mut sorted = diagnostics.clone();
    sorted.sort_by_place();
    let mut out = String::new();
    let spans: Vec<Option<Span>> = sorted.0.iter().take(MOST).map(|d| d.span.as_ref().map(|s| clamp(text, s))).collect();
    let ends: Vec<usize> = spans.iter().flatten().flat_map(|s| [s.start, s.end]).collect();
    let (excerpts, ends) = plain::lines_at(text, &ends);
    let mut ends = ends.into_iter();
    let source = NamedSource::new(plain::line(file), excerpts.to_string());
    let written = units_of(text);
    for (d, span) in sorted.0.iter().zip(spans) {
        let voice = Voice::new(language, &written, text, d.span.as_ref());
        let span = span.and_then(|_| Some(ends.next()?..ends.next()?));
        let Form::Excerpts { width, colour } = form else {
            one_line(&mut out, d, text, file, &voice);
            continue;
        };
        let span = span.filter(|s| {
            let start = excerpts[..s.start].rfind('\n').map_or(0, |i| i + 1);
            let end = excerpts[s.end..].find('\n').map_or(excerpts.len(), |i| s.end + i);
            end - start <= LONGEST_LINE && !excerpts.is_empty()
        });
        let theme = if colour { GraphicalTheme::unicode() } else { GraphicalTheme::unicode_nocolor() };
        let handler = GraphicalReportHandler::new_themed(theme).with_width(width.clamp(40, 400)).with_links(false).with_context_lines(1);
        let written = match span {
            Some(span) => {
                let message = voice.line(&message(d, text));
                let begin = out.len();
                let written = handler.render_report(&mut out, &Shown { d, voice: &voice, message, source: &source, span });
                name_help(&mut out, begin, language);
                written
            }
            None => {
                one_line(&mut out, d, text, file, &voice);
                Ok(())
            }
        };
        if written.is_err() {
            one_line(&mut out, d, text, file, &voice);
        }
        out.push('\n');
    }
    if sorted.0.len() > MOST {
        let _ = writeln!(out, "{}", language.said(&text!("... and {n} more", n = sorted.0.len() - MOST)));
    }
    out
}

/// Diagnostics for tools: code, severity, message, label, help, and the place in bytes and in lines and columns from 1, with the other places (`also`)
/// where the same name is missing.
pub fn to_json(diagnostics: &Diagnostics, text: &str) -> Json {
    to_json_in(Language::English, diagnostics, text)
}

/// [`to_json`] with its sentences in a language; codes, severities and places are the same in all.
pub fn to_json_in(language: Language, diagnostics: &Diagnostics, text: &str) -> Json {
    let mut sorted = diagnostics.clone();
    sorted.sort_by_place();
    let written = units_of(text);
    let one = |d: &Diagnostic| {
        let voice = Voice::new(language, &written, text, d.span.as_ref());
        let place = |s: &Span| {
            let s = clamp(text, s);
            let ((line, column), (end_line, end_column)) = (line_column(text, s.start), line_column(text, s.end));
            json!({ "start": s.start, "end": s.end, "line": line, "column": column, "end_line": end_line, "end_column": end_column })
        };
        let also: Vec<Json> = d.also().iter().map(place).collect();
        let place = d.span.as_ref().map(place);
        let said = |t: &Option<Box<Text>>| t.as_ref().map(|t| voice.say(t));
        json!({
            "code": d.code,
            "severity": word(d.severity).to_string(),
            "message": voice.say(&d.message),
            "place": place,
            "also": also,
            "label": said(&d.label),
            "help": said(&d.help)
        })
    };
    Json::Array(sorted.0.iter().map(one).collect())
}
