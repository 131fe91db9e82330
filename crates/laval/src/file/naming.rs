//! Kinds and names of blocks.

use super::tree::{Entry, get};
use super::values::{clip, suggestion};
use crate::diagnostic::{Diagnostic, Diagnostics, Span};
use crate::model::field::KindInfo;
use crate::text;
use crate::text::Text;

/// Longest name of a block, characters.
const MAX_NAME: usize = 64;

/// The kind of a block, one of those known.
pub(super) fn read_kind<'n>(
    table: &[Entry],
    span: Option<Span>,
    what: &str,
    name: Option<&str>,
    known: &'n [KindInfo],
    out: &mut Diagnostics,
) -> Option<&'n KindInfo> {
    let words = || known.iter().map(|k| k.kind);
    let block = name.map_or_else(|| what.to_string(), |n| format!("{what} {n:?}"));
    let Some(e) = get(table, "kind") else {
        let typed = get(table, "type").and_then(|t| t.node.text()).filter(|t| words().any(|w| w == *t));
        let help = match typed {
            Some(t) => Some(text!("write kind = {t}, not type", t = text::quoted(&t))),
            None => suggestion("", words(), |all| text!("write kind = \"..\" with one of: {all}", all)),
        };
        let mut d =
            Diagnostic::error("kind.missing", text!("this {block} says no kind", block)).at(span).label(text!("kind = \"..\" is missing"));
        d.help = help.map(Box::new);
        out.push(d);
        return None;
    };
    let Some(t) = e.node.text() else {
        out.push(
            Diagnostic::error("value.type", text!("{block}: kind must be a word in quotes, not {shape}", block, shape = e.node.shape()))
                .at(e.node.span.clone()),
        );
        return None;
    };
    let found = known.iter().find(|k| k.kind == t);
    if found.is_none() {
        let mut d = Diagnostic::error("kind.unknown", text!("there is no kind of {what} called {t}", what, t = text::quoted(&clip(t))))
            .at(e.node.span.clone())
            .label(text!("unknown kind"));
        let kinds = |all: String| match what {
            "study" => text!("kinds of studies: {all}", all),
            _ => text!("kinds of {what}s: {all}", what, all),
        };
        d.help = suggestion(t, words(), kinds).map(Box::new);
        out.push(d);
    }
    found
}

/// The name of a block, when it can be one.
pub(super) fn read_name(e: &Entry, what: &str, out: &mut Diagnostics) -> Option<String> {
    let bad = |message: Text, label: Text| Diagnostic::error("name.invalid", message).at(e.node.span.clone()).label(label);
    let Some(t) = e.node.text() else {
        out.push(bad(text!("the name of a {what} must be a text in quotes, not {shape}", what, shape = e.node.shape()), e.node.shape()));
        return None;
    };
    if t == "ground" {
        out.push(
            bad(text!("a {what} cannot be named \"ground\"", what), text!("reserved"))
                .help(text!("\"ground\" is the fixed surroundings that parts may be attached to")),
        );
        return None;
    }
    if valid_name(t) {
        return Some(t.to_string());
    }
    let d = bad(text!("{t} cannot be the name of a {what}", t = text::quoted(&clip(t)), what), text!("not a name"));
    let mut clean: String = t.chars().map(|c| if inner(c) { c } else { '_' }).take(MAX_NAME).collect();
    clean = clean.trim_matches(|c: char| !letter(c)).to_string();
    let mut help = text!(
        "a name is made of letters of any script, digits, spaces, _ and -, begins with a letter or digit and has at most 64 characters"
    );
    if valid_name(&clean) {
        help = text!("for instance {name}: {help}", name = text::quoted(&clean), help);
    }
    out.push(d.help(help));
    None
}

/// Letters and digits of all scripts, but for letters that show nothing.
fn letter(c: char) -> bool {
    c.is_alphanumeric() && !matches!(c, '\u{115f}' | '\u{1160}' | '\u{3164}' | '\u{ffa0}')
}

fn inner(c: char) -> bool {
    letter(c) || matches!(c, '_' | '-' | ' ')
}

/// Letters, digits, inner spaces, `_` and `-` (no dot: `drum.x` is a coordinate of `drum`); names become folders and columns.
pub(super) fn valid_name(t: &str) -> bool {
    t.chars().count() <= MAX_NAME && t.starts_with(letter) && !t.ends_with(' ') && t.chars().all(inner) && t != "ground"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_made_of_the_letters_of_all_scripts() {
        for fine in
            ["drum", "2nd disc", "барабан", "қозғалтқыш-2", "Әуе желдеткіші", "oʻqʻ".replace('ʻ', "").as_str(), "回転体", "Läufer_1"]
        {
            assert!(valid_name(fine), "{fine}");
        }
        assert!(valid_name(&"ж".repeat(64)) && !valid_name(&"ж".repeat(65)));
        for wrong in
            ["", "ground", "a.b", " a", "a ", "-a", "а/б", "..", "a\u{202e}b", "a\u{3164}", "\u{301}a", "a\nb", "a\u{0}", "a<b", "a\"b"]
        {
            assert!(!valid_name(wrong), "{wrong:?}");
        }
    }
}
