//! One tree for TOML and JSON, with places.

use crate::diagnostic::Span;
use crate::text;
use crate::text::Text;
use std::borrow::Cow;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A value with its place in the text (none for JSON).
#[derive(Debug)]
pub(crate) struct Node<'a> {
    pub data: Data<'a>,
    pub span: Option<Span>,
}

#[derive(Debug)]
pub(crate) enum Data<'a> {
    Text(Cow<'a, str>),
    Integer(i64),
    Float(f64),
    Flag(bool),
    /// A date, or null in JSON.
    Other(fn() -> Text),
    List(Vec<Node<'a>>),
    Table(Vec<Entry<'a>>),
}

#[derive(Debug)]
pub(crate) struct Entry<'a> {
    pub key: Cow<'a, str>,
    pub span: Option<Span>,
    pub node: Node<'a>,
}

impl<'a> Node<'a> {
    pub fn table(&self) -> Option<&[Entry<'a>]> {
        match &self.data {
            Data::Table(t) => Some(t),
            _ => None,
        }
    }
    pub fn text(&self) -> Option<&str> {
        match &self.data {
            Data::Text(t) => Some(t),
            _ => None,
        }
    }
    /// What it is, for messages.
    pub fn shape(&self) -> Text {
        match &self.data {
            Data::Text(_) => text!("a text"),
            Data::Integer(_) | Data::Float(_) => text!("a number"),
            Data::Flag(_) => text!("true or false"),
            Data::Other(what) => what(),
            Data::List(list) if list.is_empty() => text!("an empty list"),
            Data::List(_) => text!("a list"),
            Data::Table(_) => text!("a table"),
        }
    }
}

/// The entry of a key.
pub(crate) fn get<'n, 'a>(table: &'n [Entry<'a>], key: &str) -> Option<&'n Entry<'a>> {
    table.iter().find(|e| e.key == key)
}

pub(crate) fn from_table(table: DeTable<'_>) -> Vec<Entry<'_>> {
    let mut out: Vec<Entry<'_>> = table
        .into_iter()
        .map(|(k, v)| {
            let span = k.span();
            Entry { key: k.into_inner(), span: Some(span), node: from_toml(v) }
        })
        .collect();
    out.sort_by_key(|e| e.span.as_ref().map(|s| s.start));
    out
}

pub(crate) fn from_toml(value: Spanned<DeValue<'_>>) -> Node<'_> {
    let span = Some(value.span());
    let data = match value.into_inner() {
        DeValue::String(s) => Data::Text(s),
        DeValue::Integer(i) => match i64::from_str_radix(i.as_str(), i.radix()) {
            Ok(n) => Data::Integer(n),
            Err(_) if i.radix() == 10 => Data::Float(i.as_str().parse().unwrap_or(f64::NAN)),
            Err(_) => Data::Float(f64::INFINITY),
        },
        DeValue::Float(x) => Data::Float(x.as_str().parse().unwrap_or(f64::NAN)),
        DeValue::Boolean(b) => Data::Flag(b),
        DeValue::Datetime(_) => Data::Other(|| text!("a date")),
        DeValue::Array(list) => Data::List(list.into_iter().map(from_toml).collect()),
        DeValue::Table(t) => Data::Table(from_table(t)),
    };
    Node { data, span }
}

pub(crate) fn from_json(value: &serde_json::Value) -> Node<'_> {
    use serde_json::Value as J;
    let data = match value {
        J::Null => Data::Other(|| text!("null")),
        J::Bool(b) => Data::Flag(*b),
        J::Number(n) => n.as_i64().map_or_else(|| Data::Float(n.as_f64().unwrap_or(f64::NAN)), Data::Integer),
        J::String(s) => Data::Text(Cow::Borrowed(s)),
        J::Array(list) => Data::List(list.iter().map(from_json).collect()),
        J::Object(o) => Data::Table(o.iter().map(|(k, v)| Entry { key: Cow::Borrowed(k), span: None, node: from_json(v) }).collect()),
    };
    Node { data, span: None }
}

/// Tables within tables by which a file may go at most.
pub(crate) const DEEPEST: usize = 64;

/// Where keys and brackets lead deeper than [`DEEPEST`]: what goes through the tree would need more than the stack of a thread has.
pub(crate) fn too_deep(text: &str) -> Option<Span> {
    let bytes = text.as_bytes();
    let mut open: Vec<usize> = Vec::new();
    // of the key that is read: where it begins, its parts, and whether its value has begun
    let (mut start, mut parts, mut value) = (0, 1, false);
    let (mut depth, mut i) = (0, 0);
    while i < bytes.len() {
        match bytes[i] {
            quote @ (b'"' | b'\'') => i = end_of_string(bytes, i, quote),
            b'#' => i += bytes[i..].iter().position(|b| *b == b'\n').map_or(bytes.len() - i, |n| n - 1),
            b'.' if !value => parts += 1,
            b'=' => value = true,
            b'[' | b'{' => {
                open.push(parts);
                depth += parts;
                (start, parts, value) = (i + 1, 1, false);
            }
            b']' | b'}' => {
                depth -= open.pop().unwrap_or(0);
                parts = 1;
            }
            b',' | b'\n' => (start, parts, value) = (i + 1, 1, false),
            _ => {}
        }
        if depth + parts > DEEPEST {
            let end = (i + 1).min(start + 40);
            return Some(start..(end..=text.len()).find(|e| text.is_char_boundary(*e)).unwrap_or(end));
        }
        i += 1;
    }
    None
}

/// The last byte of a string that begins at `i`, or of the text.
fn end_of_string(bytes: &[u8], i: usize, quote: u8) -> usize {
    let long = bytes[i..].starts_with(&[quote; 3]);
    let mut at = i + if long { 3 } else { 1 };
    while at < bytes.len() {
        match bytes[at] {
            b'\\' if quote == b'"' => at += 1,
            b'\n' if !long => return at - 1,
            b if b == quote && (!long || bytes[at..].starts_with(&[quote; 3])) => return at + if long { 2 } else { 0 },
            _ => {}
        }
        at += 1;
    }
    bytes.len() - 1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn depth_is_that_of_keys_and_brackets_together() {
        let deep = |text: &str| too_deep(text).is_some();
        let dotted = |part: &str, n: usize| vec![part; n].join(".");
        assert!(!deep(&format!("{} = 1", dotted("a", DEEPEST))) && deep(&format!("{} = 1", dotted("a", DEEPEST + 1))));
        // quoted keys, empty ones too, are parts as well
        assert!(deep(&format!("{} = 1", dotted("\"\"", DEEPEST + 1))) && deep(&format!("{} = 1", dotted("' '", DEEPEST + 1))));
        let nested = |key: &str, n: usize| format!("{}1{}", format!("{key} = {{ ").repeat(n), " }".repeat(n));
        assert!(!deep(&nested("a", 60)) && deep(&nested("a", 70)) && deep(&nested("a.b.c", 30)));
        assert!(deep(&"[".repeat(70)) && deep(&"{".repeat(70)));
        // what lies beside is not within
        assert!(!deep(&"a.b = { c = 1.5, d = [1.0, 2.0] }\n".repeat(200)) && !deep(&format!("a = [{}]", "1.5, ".repeat(200))));
        assert!(!deep(&"[[part]]\nx = 1\n".repeat(100)) && !deep(&"]".repeat(100)));
        // dots and brackets of texts and comments are none
        let dots = ".[{".repeat(100);
        let quoted = [format!("# {dots}\na = 1"), format!("a = \"{dots}\\\"{dots}\""), format!("a = '''\n{dots}\n'{dots}'''\nb = 1")];
        assert!(quoted.iter().all(|t| !deep(t)));
        assert!(deep(&format!("{} = 1", dotted("\u{439}", DEEPEST + 1))));
        // texts that do not end
        assert!(["\"", "'''", "\"\\", "a = \"\"\"", "#"].iter().all(|t| !deep(t)));
    }
}
