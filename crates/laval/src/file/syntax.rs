//! Mistakes against TOML itself, said so that someone who has never heard of TOML can mend them.

use crate::diagnostic::{Diagnostic, Diagnostics, Span};
use crate::text;
use crate::text::Text;
use toml::de::Error;

/// Line around a byte: its place without the line end.
fn line_at(text: &str, at: usize) -> Span {
    let bytes = text.as_bytes();
    let at = at.min(text.len());
    let start = bytes[..at].iter().rposition(|&b| b == b'\n').map_or(0, |i| i + 1);
    let end = bytes[at..].iter().position(|&b| b == b'\n').map_or(text.len(), |i| at + i);
    start..end
}

/// Adds the syntax errors, and keeps of the others what can be trusted beside them: nothing is called missing when the text
/// around it could not be read, and nothing is said twice about one line.
pub(super) fn merge(text: &str, errors: &[Error], several: impl Fn(&str) -> bool, out: &mut Diagnostics) {
    let mut lines: Vec<Span> = Vec::new();
    let mut found = Vec::new();
    let open = errors.iter().filter_map(Error::span).map(|s| s.start).min().and_then(|first| unclosed(text, first));
    if let Some(open) = &open {
        // all that follows was read as part of the list or table
        out.0.retain(|d| d.span.as_ref().is_none_or(|s| s.start < open.line.start));
        let source = text.get(open.line.clone()).unwrap_or("").trim();
        let key = source.split('=').next().unwrap_or("").trim();
        let message = match open.missing.ends_with(']') {
            true => text!("the list of {key} is not closed", key),
            false => text!("the table of {key} is not closed", key),
        };
        let d = Diagnostic::error("toml.syntax", message).at(open.line.clone());
        let space = if open.missing.starts_with('}') { " " } else { "" };
        found.push(
            d.label(text!("{missing} is missing", missing = open.missing))
                .help(text!("write {line}", line = format_args!("{}{space}{}", source.trim_end_matches(','), open.missing))),
        );
        lines.push(line_at(text, open.line.start));
    }
    let repeated: Vec<Span> = errors.iter().filter_map(|e| repeated_block(text, e)).collect();
    let header = |at: usize| text[line_at(text, at)].trim();
    // keys below a header that stands again run into those of the first
    let swallowed = |at: usize| repeated.iter().any(|b| line_at(text, b.start).end < at && at < b.end);
    for e in errors {
        if let (Some(open), Some(at)) = (&open, e.span())
            && at.start >= open.line.start
        {
            continue;
        }
        // the first of the repetitions speaks for all
        let again = |at: usize| {
            repeated.iter().any(|b| b.contains(&at) && repeated.iter().any(|a| a.start < b.start && header(a.start) == header(b.start)))
        };
        if e.span().is_some_and(|s| swallowed(s.start) || again(s.start)) {
            continue;
        }
        // a block of which there may be several, in single brackets: that is the mistake, not that it stands twice
        if let Some(block) = repeated_block(text, e)
            && let Some((word, place)) = single_brackets(text, header(block.start)).filter(|b| several(b.0))
        {
            out.0.retain(|d| d.code != "file.brackets" || d.span.as_ref().is_none_or(|s| s.start != place.start));
            if !lines.contains(&line_at(text, place.start)) {
                lines.push(line_at(text, place.start));
                found.push(brackets(word, place));
            }
            lines.push(line_at(text, block.start));
            continue;
        }
        let mut at = e.span().unwrap_or(text.len()..text.len());
        at.start = at.start.min(text.len());
        let mut line = line_at(text, at.start);
        // The parser often stops at the line end; a place past the last line belongs to it.
        if line.is_empty() && at.start > 0 {
            let before = text[..line.start].trim_end().len();
            line = line_at(text, before);
        }
        if lines.contains(&line) {
            continue;
        }
        found.push(explain(text, e, at, line.clone()));
        lines.push(line);
    }
    // keys under a header that could not be read belong to no block: they are not mistakes of their own
    let under: Vec<Span> = lines
        .iter()
        .filter(|l| text.get((*l).clone()).is_some_and(|t| t.trim_start().starts_with('[')))
        .map(|l| l.start..text[l.end..].find("\n[").map_or(text.len(), |i| l.end + i))
        .collect();
    out.0.retain(|d| {
        if d.span.as_ref().is_some_and(|s| swallowed(s.start)) {
            return false;
        }
        let orphan = d.code == "file.unknown_table" && d.span.as_ref().is_some_and(|s| under.iter().any(|u| u.contains(&s.start)));
        let missing = matches!(d.code, "key.missing" | "kind.missing" | "file.no_parts" | "file.no_machine" | "parameter.unknown");
        !missing && !orphan && d.span.as_ref().is_none_or(|s| !lines.iter().any(|l| l.start <= s.start && s.start <= l.end))
    });
    // what only the whole tree could tell
    if let Some(last) = found.iter_mut().max_by_key(|d| d.span.as_ref().map(|s| s.start)) {
        let help = match last.help.take() {
            Some(help) => text!("{help} ({only_syntax})", help, only_syntax = only_syntax()),
            None => only_syntax(),
        };
        last.help = Some(Box::new(help));
    }
    out.0.extend(found);
}

/// The block of a header in single brackets that stands a second time, from the header to the next one.
fn repeated_block(text: &str, e: &Error) -> Option<Span> {
    let line = line_at(text, e.span().filter(|_| e.message().starts_with("duplicate key"))?.start);
    let block = line.start..text[line.end..].find("\n[").map_or(text.len(), |i| line.end + i);
    text[line].trim_start().starts_with('[').then_some(block)
}

/// The word of a header and the first place where it stands in single brackets.
fn single_brackets<'a>(text: &str, header: &'a str) -> Option<(&'a str, Span)> {
    let word = header.split('#').next()?.trim().trim_matches(['[', ']']).trim();
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        let body = line.split('#').next().unwrap_or_default().trim();
        let inside = body.strip_prefix('[').and_then(|b| b.strip_suffix(']'));
        if inside.is_some_and(|i| i.trim() == word) {
            let from = start + line.len() - line.trim_start().len();
            return Some((word, from..from + body.len()));
        }
        start += line.len();
    }
    None
}

/// A block of which there may be several stands in single brackets.
pub(super) fn brackets(what: &str, place: impl Into<Option<Span>>) -> Diagnostic {
    Diagnostic::error("file.brackets", text!("[{what}] needs double brackets", what))
        .at(place)
        .label(text!("single brackets"))
        .help(text!("write [[{what}]]: there may be several", what))
}

/// What a file with mistakes of syntax was not examined for.
fn only_syntax() -> Text {
    text!("so far only the syntax and single values were checked: how parts and studies fit together is looked at once the syntax is right")
}

/// A list or table that nobody closed.
struct Unclosed {
    /// The line that opens it, without what surrounds its words and without its remark.
    line: Span,
    /// The brackets to add.
    missing: String,
}

/// A list or table that is still open where the next key or block begins, not after the line of `until`.
fn unclosed(text: &str, until: usize) -> Option<Unclosed> {
    let mut stack: Vec<char> = Vec::new();
    let (mut start, mut opened, mut opened_missing, mut goes_on) = (0, 0..0, String::new(), false);
    for source in text.split_inclusive('\n') {
        let from = start + (source.len() - source.trim_start().len());
        start += source.len();
        let body = source.trim();
        let word = |k: &str| !k.is_empty() && k.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
        let key = body.split_once('=').is_some_and(|(k, _)| word(k.trim()));
        // a table may hold keys on lines of their own, each after a comma
        let key_outside = key && (stack.contains(&']') || !goes_on);
        if !stack.is_empty() && (key_outside || body.starts_with("[[") || body.starts_with("[machine]")) {
            return Some(Unclosed { line: opened, missing: opened_missing });
        }
        if from > until {
            return None;
        }
        if stack.is_empty() && !key {
            continue;
        }
        let first = stack.is_empty();
        let (mut quote, mut end) = (None, body.len());
        for (i, c) in body.char_indices() {
            match (quote, c) {
                (None, '"' | '\'') => quote = Some(c),
                (Some(q), _) if q == c => quote = None,
                (None, '#') => {
                    end = i;
                    break;
                }
                (None, '[') => stack.push(']'),
                (None, '{') => stack.push('}'),
                (None, ']' | '}') if stack.last() == Some(&c) => {
                    stack.pop();
                }
                _ => {}
            }
        }
        let content = body[..end].trim_end();
        goes_on = content.ends_with([',', '{']) || (content.is_empty() && goes_on);
        if first {
            opened = from..from + content.len();
            opened_missing = stack.iter().rev().collect();
        }
    }
    None
}

fn explain(text: &str, e: &Error, at: Span, line: Span) -> Diagnostic {
    let source = text.get(line.clone()).unwrap_or("");
    let body = source.trim();
    let span = if at.is_empty() || at.end > line.end || at.start < line.start {
        let start = line.start + (source.len() - source.trim_start().len());
        start..start + body.len()
    } else {
        at
    };
    let d = |message: Text, label: Text| Diagnostic::error("toml.syntax", message).at(span.clone()).label(label);
    if let Some((i, c)) = source.char_indices().find(|(_, c)| c.is_ascii_control() && *c != '\t' && *c != '\r') {
        let code = format!("0x{:02x}", c as u32);
        let place = line.start + i..line.start + i + 1;
        return Diagnostic::error("toml.syntax", text!("this line holds the control character {code}, which no text has", code))
            .at(place)
            .label(text!("{code}", code))
            .help(text!("remove it"));
    }
    if e.message().starts_with("duplicate key") {
        let word = text.get(span.clone()).unwrap_or("").trim();
        if body.starts_with('[') {
            return d(text!("{body} stands twice in the file", body), text!("the second time"))
                .help(text!("write one block, or double brackets where several are allowed: [[part]], [[study]]"));
        }
        return d(text!("the key {word} is given twice in one block", word = text::quoted(&word)), text!("the second time"))
            .help(text!("keep one of the two; a further part begins with its own [[part]]"));
    }
    if let Some(rest) = body.strip_prefix('[')
        && !rest.contains('=')
    {
        let word = rest.trim_matches(|c| c == '[' || c == ']' || c == ' ');
        return d(text!("the header of this block is not closed properly"), text!("brackets")).help(match word {
            "machine" => text!("write [machine]"),
            _ => text!("write [[{word}]]", word),
        });
    }
    let Some((key, value)) = body.split_once('=') else {
        return d(text!("this line is neither a block header nor a key with a value"), text!("not understood"))
            .help(text!("write key = value, [machine], [[part]] or [[study]]; a remark begins with #"));
    };
    let (key, value) = (key.trim(), value.split('#').next().unwrap_or("").trim());
    if value.is_empty() {
        return d(text!("the value of {key} is missing", key), text!("nothing behind =")).help(text!("write {key} = \"..\"", key));
    }
    let plain_key = !key.is_empty() && key.chars().all(|c| c.is_ascii_alphanumeric() || matches!(c, '_' | '-' | '.'));
    if !plain_key && !key.starts_with(['"', '\'']) {
        return d(text!("{key} cannot be a key", key = text::quoted(&key)), text!("not a key"))
            .help(text!("a key is one word of letters, digits, _ and -; write key = value"));
    }
    let quotes = value.matches('"').count();
    if quotes % 2 == 1 {
        return d(text!("a quotation mark is missing in the value of {key}", key), text!("not closed")).help(
            if value.ends_with('"') && !value.starts_with(['"', '[', '{']) {
                text!("write {key} = \"{value}", key, value)
            } else if value.starts_with('"') {
                text!("write {key} = {value}\"", key, value)
            } else {
                text!("texts and quantities stand between two quotation marks")
            },
        );
    }
    if value.starts_with(['{', '[']) {
        let count = |open: char, close: char| value.matches(open).count() != value.matches(close).count();
        if count('{', '}') {
            return d(text!("a brace is missing in the value of {key}", key), text!("{{ and }} must match"))
                .help(text!("a table is written {{ x = \"..\", y = \"..\" }}"));
        }
        if count('[', ']') {
            return d(text!("a bracket is missing in the value of {key}", key), text!("[ and ] must match"))
                .help(text!("a list is written [\"..\", \"..\"]"));
        }
        return d(text!("the value of {key} cannot be read", key), text!("not understood"))
            .help(text!("inside lists and tables, too, texts and quantities stand in quotes, with commas between entries: {{ x = \"1 mm\", y = \"2 mm\" }}"));
    }
    if value.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '-' | '+' | '.')) && !value.contains('"') {
        return d(text!("the value of {key} must stand in quotes, because it has a unit", key), text!("quotes are missing")).help(text!(
            "write {key} = \"{value}\"",
            key,
            value
        ));
    }
    if !value.starts_with(['"', '\'']) {
        return d(text!("the value of {key} must stand in quotes", key), text!("quotes are missing")).help(text!(
            "write {key} = \"{value}\"",
            key,
            value = value.trim_matches('"')
        ));
    }
    d(text!("this line cannot be read: {why}", why = e.message()), text!("not understood")).help(text!("write {key} = \"..\"", key))
}
