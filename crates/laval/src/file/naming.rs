//! Kinds and names of blocks.

use super::tree::{Entry, get};
use super::values::{clip, suggestion};
use crate::diagnostic::{Diagnostic, Diagnostics, Span};
use crate::model::field::KindInfo;

/// Longest name of a block.
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
    let named = name.map(|n| format!(" {n:?}")).unwrap_or_default();
    let Some(e) = get(table, "kind") else {
        let typed = get(table, "type").and_then(|t| t.node.text()).filter(|t| words().any(|w| w == *t));
        let help = match typed {
            Some(t) => Some(format!("write kind = {t:?}, not type")),
            None => suggestion("", words(), "write kind = \"..\" with one of"),
        };
        let mut d =
            Diagnostic::error("kind.missing", format!("this {what}{named} says no kind")).at(span).label("kind = \"..\" is missing");
        d.help = help.map(Into::into);
        out.push(d);
        return None;
    };
    let Some(t) = e.node.text() else {
        out.push(
            Diagnostic::error("value.type", format!("{what}{named}: kind must be a word in quotes, not {}", e.node.shape()))
                .at(e.node.span.clone()),
        );
        return None;
    };
    let found = known.iter().find(|k| k.kind == t);
    if found.is_none() {
        let kinds = if what == "study" { "kinds of studies".to_string() } else { format!("kinds of {what}s") };
        let mut d = Diagnostic::error("kind.unknown", format!("there is no kind of {what} called {:?}", clip(t)))
            .at(e.node.span.clone())
            .label("unknown kind");
        d.help = suggestion(t, words(), &kinds).map(Into::into);
        out.push(d);
    }
    found
}

/// The name of a block, when it can be one.
pub(super) fn read_name(e: &Entry, what: &str, out: &mut Diagnostics) -> Option<String> {
    let bad = |message: String, label: &str| Diagnostic::error("name.invalid", message).at(e.node.span.clone()).label(label.to_string());
    let Some(t) = e.node.text() else {
        out.push(bad(format!("the name of a {what} must be a text in quotes, not {}", e.node.shape()), e.node.shape()));
        return None;
    };
    if t == "ground" {
        out.push(
            bad(format!("a {what} cannot be named \"ground\""), "reserved")
                .help("\"ground\" is the fixed surroundings that parts may be attached to"),
        );
        return None;
    }
    if valid_name(t) {
        return Some(t.to_string());
    }
    let d = bad(format!("{:?} cannot be the name of a {what}", clip(t)), "not a name");
    let mut clean: String =
        t.chars().map(|c| if c.is_ascii_alphanumeric() || matches!(c, '_' | '-' | ' ') { c } else { '_' }).take(MAX_NAME).collect();
    clean = clean.trim_matches(|c: char| !c.is_ascii_alphanumeric()).to_string();
    let mut help =
        "a name is made of letters, digits, spaces, _ and -, begins with a letter or digit and has at most 64 characters".to_string();
    if valid_name(&clean) {
        help = format!("for instance {clean:?}: {help}");
    }
    out.push(d.help(help));
    None
}

/// Letters, digits, inner spaces, `_` and `-` (no dot: `drum.x` is a coordinate of `drum`); names become folders and columns.
pub(super) fn valid_name(t: &str) -> bool {
    let inner = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '-' | ' ');
    t.len() <= MAX_NAME && t.starts_with(|c: char| c.is_ascii_alphanumeric()) && !t.ends_with(' ') && t.chars().all(inner) && t != "ground"
}
