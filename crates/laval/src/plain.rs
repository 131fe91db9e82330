//! Text for terminals and for files that are read on one: what steers a terminal, or reorders or hides letters, is shown as it is written in a
//! machine file.

use std::borrow::Cow;
use std::fmt::Write;

/// Control characters, which a terminal obeys, and marks that reorder or hide text without being seen.
fn hidden(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{61c}' | '\u{200b}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}' | '\u{fff9}'..='\u{fffb}')
}

/// Text that stays in one line: `\u001b` in place of an escape character, `\u000a` in place of a line end.
///
/// ```
/// assert_eq!(laval::plain::line("a\u{1b}[2Jb\nc"), r"a\u001b[2Jb\u000ac");
/// ```
pub fn line(text: &str) -> Cow<'_, str> {
    if !text.chars().any(hidden) {
        return text.into();
    }
    shown(text, &[], |_, _| false).0.into()
}

/// Text of several lines: line ends and tabs stay.
pub fn lines(text: &str) -> Cow<'_, str> {
    if !text.chars().any(|c| hidden(c) && c != '\n') {
        return text.into();
    }
    shown(text, &[], stays).0.into()
}

/// Text of several lines that was coloured: the sequences that choose a colour stay too.
pub fn painted(text: &str) -> Cow<'_, str> {
    if !text.chars().any(|c| hidden(c) && c != '\n') {
        return text.into();
    }
    shown(text, &[], |c, rest| stays(c, rest) || (c == '\x1b' && colour(rest))).0.into()
}

/// As [`lines`], with where places of the text have gone.
pub fn lines_at<'a>(text: &'a str, places: &[usize]) -> (Cow<'a, str>, Vec<usize>) {
    if !text.chars().any(|c| hidden(c) && c != '\n') {
        return (text.into(), places.to_vec());
    }
    let (text, places) = shown(text, places, stays);
    (text.into(), places)
}

fn stays(c: char, rest: &str) -> bool {
    matches!(c, '\n' | '\t') || (c == '\r' && rest.starts_with('\n'))
}

/// What follows an escape character chooses a colour and does nothing else.
fn colour(rest: &str) -> bool {
    let end = rest.strip_prefix('[').map(|r| r.trim_start_matches(|c: char| c.is_ascii_digit() || c == ';'));
    end.is_some_and(|e| e.starts_with('m'))
}

/// The text with escapes where `keep`, which sees a character and what follows it, does not keep one; and where `places` have gone.
fn shown(text: &str, places: &[usize], keep: impl Fn(char, &str) -> bool) -> (String, Vec<usize>) {
    let mut out = String::with_capacity(text.len());
    let mut gone: Vec<usize> = vec![usize::MAX; places.len()];
    let mut order: Vec<usize> = (0..places.len()).collect();
    order.sort_by_key(|&k| places[k]);
    let mut next = order.into_iter().peekable();
    for (at, c) in text.char_indices() {
        while let Some(k) = next.next_if(|&k| places[k] <= at) {
            gone[k] = out.len();
        }
        if hidden(c) && !keep(c, &text[at + c.len_utf8()..]) {
            // writing to a string does not fail
            let _ = write!(out, "\\u{:04x}", u32::from(c));
        } else {
            out.push(c);
        }
    }
    next.for_each(|k| gone[k] = out.len());
    (out, gone)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_steers_a_terminal() {
        let evil = "a\u{1b}[31mRED\u{1b}]0;title\u{7}\u{9b}2J\u{202e}b\r\rc\td\n\u{7f}\0";
        assert_eq!(line(evil), r"a\u001b[31mRED\u001b]0;title\u0007\u009b2J\u202eb\u000d\u000dc\u0009d\u000a\u007f\u0000");
        assert_eq!(lines(evil), "a\\u001b[31mRED\\u001b]0;title\\u0007\\u009b2J\\u202eb\\u000d\\u000dc\td\n\\u007f\\u0000");
        // a colour and nothing else
        assert_eq!(painted("\u{1b}[1;31mred\u{1b}[0m\u{1b}[2J\u{1b}]0;x\u{7}"), "\u{1b}[1;31mred\u{1b}[0m\\u001b[2J\\u001b]0;x\\u0007");
        assert_eq!(lines("ä\r\nµ²\n"), "ä\r\nµ²\n");
        assert!(matches!(line("Läufer ²"), Cow::Borrowed(_)));
    }

    #[test]
    fn escapes_are_those_of_json_and_toml() {
        let text = serde_json::Value::from("a\u{7f}\u{9b}\u{202e}b").to_string();
        assert_eq!(serde_json::from_str::<String>(&line(&text)).unwrap(), "a\u{7f}\u{9b}\u{202e}b");
    }

    #[test]
    fn places_move_with_the_text() {
        let text = "a\u{1b}b\u{7}c";
        let (shown, places) = lines_at(text, &[0, 1, 2, 4, 5, 2]);
        assert_eq!(shown, r"a\u001bb\u0007c");
        assert_eq!(places, [0, 1, 7, 14, 15, 7]);
        assert_eq!((&shown[7..8], &shown[14..15]), ("b", "c"));
    }
}
