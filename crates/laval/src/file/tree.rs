//! One tree for TOML and JSON, with places.

use crate::diagnostic::Span;
use crate::text;
use crate::text::Text;
use std::borrow::Cow;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A value with its place in the text (none for JSON).
#[derive(Debug)]
pub(super) struct Node<'a> {
    pub data: Data<'a>,
    pub span: Option<Span>,
}

#[derive(Debug)]
pub(super) enum Data<'a> {
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
pub(super) struct Entry<'a> {
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
pub(super) fn get<'n, 'a>(table: &'n [Entry<'a>], key: &str) -> Option<&'n Entry<'a>> {
    table.iter().find(|e| e.key == key)
}

pub(super) fn from_table(table: DeTable<'_>) -> Vec<Entry<'_>> {
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

pub(super) fn from_toml(value: Spanned<DeValue<'_>>) -> Node<'_> {
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

pub(super) fn from_json(value: &serde_json::Value) -> Node<'_> {
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

/// A key with so many parts that the tree would be deeper than the stack; returns its place.
pub(super) fn too_deep(text: &str) -> Option<Span> {
    const LIMIT: usize = 64;
    let (mut start, mut dots, mut after_dot) = (0, 0, true);
    for (i, b) in text.bytes().enumerate() {
        match b {
            b'.' if !after_dot => {
                dots += 1;
                after_dot = true;
                if dots > LIMIT {
                    return Some(start..i);
                }
            }
            b'.' | b'\n' | b'=' | b',' | b'[' | b']' | b'{' | b'}' => (start, dots, after_dot) = (i + 1, 0, true),
            b' ' | b'\t' | b'"' | b'\'' => {}
            _ => after_dot = false,
        }
    }
    None
}
