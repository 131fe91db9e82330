//! Fields that hold more than numbers: a study inside a study, uncertain parameters.

use super::blocks::read_fields;
use super::naming::read_kind;
use super::tree::{Data, Entry, Node, get};
use super::values::{Context, clip, subject, suggestion};
use crate::diagnostic::Diagnostics;
use crate::model::field::{AMOUNTS, Amount, Bounds, DISTRIBUTIONS, FieldKind, InnerStudy, KindInfo, Tolerance, Values};
use crate::text;
use crate::text::{Joint, Text};

/// A kind of study that runs another one.
fn nests(kind: &KindInfo) -> bool {
    kind.fields.iter().any(|f| f.kind == FieldKind::Study)
}

impl Context<'_> {
    /// A study by name, or a whole one.
    pub(super) fn inner_study(&mut self, field: &str, node: &Node) -> Option<InnerStudy> {
        if let Some(name) = node.text() {
            return self.named_study(field, node, name);
        }
        let Some(table) = node.table() else {
            let help = text!("write the name of a study of this file, or {example}", example = self.written_here());
            self.wrong_type(field, node, text!("a study"), help);
            return None;
        };
        let catalog = self.catalog;
        let info = read_kind(table, node.span.clone(), "study", None, &catalog.studies, self.out)?;
        self.not_nested(field, node, info)?;
        let before = self.out.0.len();
        let who = format!("{} ({})", subject(self.who, field), info.kind);
        let values = self.inner_values(info, table, node, &who);
        (self.out.0.len() == before).then_some(InnerStudy { name: None, kind: info.kind, values })
    }

    /// Which studies of the file another study can run: not those that run one themselves.
    fn answering(&self, name: &str) -> Text {
        let names = self.studies.iter().filter(|s| s.info.is_none_or(|k| !nests(k))).map(|s| s.name);
        let help = suggestion(name, names, |all| text!("studies of this file that can be run: {all}", all));
        help.unwrap_or_else(|| text!("add such a study to this file, or write {example} here", example = self.written_here()))
    }

    /// How a study is written in place: the first kind that runs none itself.
    fn written_here(&self) -> String {
        let kind = self.catalog.studies.iter().find(|k| !nests(k)).map_or("..", |k| k.kind);
        format!("{{ kind = \"{kind}\", .. }}")
    }

    fn named_study(&mut self, field: &str, node: &Node, name: &str) -> Option<InnerStudy> {
        let studies = self.studies;
        let Some(found) = studies.iter().find(|s| s.name == name) else {
            let message =
                text!("{who} is {name}, but no study has that name", who = subject(self.who, field), name = text::quoted(&clip(name)));
            let help = self.answering(name);
            self.error("study.unknown", node.span.clone(), message, text!("no such study"), help);
            return None;
        };
        // a study that is not understood is reported where it stands, and so are the mistakes of its values
        let info = found.info?;
        self.not_nested(field, node, info)?;
        let mut own = Diagnostics::default();
        let mut values = Values::default();
        values.span = found.span.clone();
        let mut cx = Context { text: self.text, catalog: self.catalog, parts: self.parts, studies: &[], out: &mut own, who: name };
        read_fields(&mut cx, info, &["kind", "name"], found.table, found.span.clone(), &mut values);
        (!own.has_errors()).then(|| InnerStudy { name: Some(name.to_string()), kind: info.kind, values })
    }

    fn inner_values(&mut self, info: &KindInfo, table: &[Entry], node: &Node, who: &str) -> Values {
        let mut values = Values::default();
        values.span = node.span.clone();
        let mut cx = Context { text: self.text, catalog: self.catalog, parts: self.parts, studies: &[], out: self.out, who };
        read_fields(&mut cx, info, &["kind"], table, node.span.clone(), &mut values);
        values
    }

    fn not_nested(&mut self, field: &str, node: &Node, info: &KindInfo) -> Option<()> {
        if !nests(info) {
            return Some(());
        }
        let message = text!(
            "{who} cannot be a study of kind {kind}, which runs a study itself",
            who = subject(self.who, field),
            kind = text::quoted(&info.kind)
        );
        let help = self.answering("");
        self.error("study.nested", node.span.clone(), message, text!("runs another study"), help);
        None
    }

    /// A list of uncertain parameters.
    pub(super) fn tolerances(&mut self, field: &str, node: &Node) -> Option<Vec<Tolerance>> {
        let help = text!("write [{{ parameter = \"drum.mass\", distribution = \"normal\", deviation = \"2 %\" }}]");
        let list = match &node.data {
            Data::List(list) if !list.is_empty() => list,
            _ => {
                self.wrong_type(field, node, text!("a list of uncertain parameters"), help);
                return None;
            }
        };
        let read: Vec<Option<Tolerance>> =
            list.iter().enumerate().map(|(i, n)| self.tolerance(&format!("{field}[{}]", i + 1), n, &help)).collect();
        let read: Vec<Tolerance> = read.into_iter().collect::<Option<_>>()?;
        for (i, t) in read.iter().enumerate() {
            if read[..i].iter().any(|o| o.parameter == t.parameter) {
                let message =
                    text!("{who} names {parameter} twice", who = subject(self.who, field), parameter = text::quoted(&t.parameter));
                self.error("parameter.twice", t.span.clone(), message, text!("named above"), None);
                return None;
            }
        }
        Some(read)
    }

    fn tolerance(&mut self, field: &str, node: &Node, help: &Text) -> Option<Tolerance> {
        let Some(table) = node.table() else {
            self.wrong_type(field, node, text!("an uncertain parameter"), help.clone());
            return None;
        };
        let mut allowed = vec!["parameter", "distribution"];
        allowed.extend(AMOUNTS);
        let mut fine = self.check_keys(field, table, &allowed);
        let word = |key: &str, cx: &mut Self| {
            let Some(e) = get(table, key) else {
                let message = text!("{who} has no {key}", who = subject(cx.who, field), key = text::quoted(&key));
                cx.error("key.missing", node.span.clone(), message, text!("{key} = .. is missing", key), help.clone());
                return None;
            };
            cx.text_value(&format!("{field}.{key}"), &e.node, text!("a text")).map(|t| (t, e))
        };
        let (path, kind) = (word("parameter", self), word("distribution", self));
        let ((path, at), (kind, kind_at)) = (path?, kind?);
        let unit = self.parameter(field, &at.node, &path)?;
        let Some(distribution) = DISTRIBUTIONS.iter().find(|d| d.0 == kind) else {
            let message = text!(
                "{who} cannot be {kind}",
                who = subject(self.who, &format!("{field}.distribution")),
                kind = text::quoted(&clip(&kind))
            );
            let one = |d: &(&'static str, &'static str)| text!("{name}: {meaning}", name = d.0, meaning = text::term(d.1));
            let meanings = text::list(DISTRIBUTIONS.iter().map(one), Joint::Semicolon);
            let help =
                suggestion(&kind, DISTRIBUTIONS.iter().map(|d| d.0), |all| text!("distributions: {all} ({meanings})", all, meanings));
            self.error("value.choice", kind_at.node.span.clone(), message, text!("not a distribution"), help);
            return None;
        };
        let mut amounts = Vec::new();
        for &name in AMOUNTS {
            let Some(e) = get(table, name) else { continue };
            let key = format!("{field}.{name}");
            let any = Bounds::within(f64::MAX);
            let percent = e.node.text().and_then(|t| t.trim_end().strip_suffix('%'));
            let bare = percent.map(|t| Node { data: Data::Text(t.trim().to_string().into()), span: e.node.span.clone() });
            let amount = match unit {
                _ if bare.is_some() => bare.and_then(|n| self.quantity(&key, &n, "", &any)).map(Amount::Percent),
                Some((unit, _)) => self.quantity(&key, &e.node, unit, &any).map(Amount::Absolute),
                None => self.any_quantity(&key, &e.node).map(|q| Amount::Absolute(q.0)),
            };
            match amount {
                Some(a) => amounts.push((name, a)),
                None => fine = false,
            }
        }
        fine.then_some(Tolerance { parameter: path, distribution: distribution.0, amounts, span: node.span.clone() })
    }
}
