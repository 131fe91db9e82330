//! The blocks of a file: which exist, their kinds, names and keys.

use super::draft::{Draft, Drafted};
use super::naming::{read_kind, read_name};
use super::syntax::brackets;
use super::tree::{Data, Entry, Node, get};
use super::values::{Context, StudyTable, clip};
use super::{Block, Catalog, Drive, MACHINE_FIELDS, MachineBlock, RotorAxis};
use crate::diagnostic::{self, Diagnostic, Diagnostics, Severity, Span, nearest};
use crate::model::field::{Field, FieldKind, KindInfo, Values};
use crate::text;
use crate::text::{Argument, Joint};
use std::collections::BTreeMap;

const TOP: [&str; 3] = ["machine", "part", "study"];

/// A block before its values are read.
struct Raw<'n, 'a> {
    word: &'static str,
    table: &'n [Entry<'a>],
    span: Option<Span>,
    info: Option<&'n KindInfo>,
    name: String,
    who: String,
    /// Nothing was wrong with it so far.
    sound: bool,
    /// The name it was given cannot be one.
    misnamed: bool,
}

/// What a block at the top of the file is, also when its header is misspelt.
struct Top<'n, 'a> {
    entry: &'n Entry<'a>,
    word: Option<&'static str>,
    /// The kind, when the header says it: `[[damper]]`.
    kind: Option<&'n KindInfo>,
}

fn errors(d: &Diagnostics) -> usize {
    d.0.iter().filter(|d| d.severity == Severity::Error).count()
}

/// Reads the whole tree, each block as far as it can be.
pub(super) fn read_tree(text: &str, root: &[Entry], catalog: &Catalog, out: &mut Diagnostics) -> Draft {
    let tops: Vec<Top> = root.iter().map(|e| top(e, root, catalog, out)).collect();
    let of = |word: &str| tops.iter().filter(|t| t.word == Some(word)).collect::<Vec<_>>();
    let mut strange: Vec<String> = tops.iter().filter(|t| t.word.is_none()).flat_map(|t| names_in(t.entry)).collect();
    let parts_raw = gather(&of("part"), "part", &catalog.parts, &mut strange, out);
    let studies_raw = gather(&of("study"), "study", &catalog.studies, &mut strange, out);
    if of("part").is_empty() {
        out.push(
            Diagnostic::error("file.no_parts", text!("the machine has no parts"))
                .help(text!("describe each part in a block that begins with [[part]]")),
        );
    }
    let mut extras_raw = Vec::new();
    for b in &catalog.blocks {
        let found = of(b.word);
        extras_raw.extend(if b.several {
            gather(&found, b.word, &b.kinds, &mut strange, out)
        } else {
            found.first().and_then(|t| gather_one(t.entry, b.word, &b.kinds, out)).into_iter().collect()
        });
    }
    let named = parts_raw.iter().chain(&extras_raw);
    let names: Vec<(String, &'static str)> =
        named.map(|b| (b.name.clone(), b.info.map_or("", |k| k.kind))).chain(strange.iter().map(|n| (n.clone(), ""))).collect();
    let mut cx = Context { text, catalog, parts: &names, studies: &[], out, who: "[machine]" };
    let (machine, machine_unread) = read_machine(&mut cx, of("machine").first().map(|t| t.entry));
    let studies: Vec<StudyTable> = studies_raw
        .iter()
        .map(|b| StudyTable { name: &b.name, info: b.info, table: b.table, span: b.span.clone() })
        .chain(strange.iter().map(|name| StudyTable { name, info: None, table: &[], span: None }))
        .collect();
    let mut read = |raw: &[Raw]| -> Vec<Drafted> {
        let one = |b: &Raw| {
            let before = errors(out);
            let mut values = Values::default();
            values.span = b.span.clone();
            let mut unread = Vec::new();
            if let Some(info) = b.info {
                let mut cx = Context { text, catalog, parts: &names, studies: &studies, out, who: &b.who };
                let once = catalog.blocks.iter().any(|x| !x.several && x.word == info.kind);
                let implicit: &[&str] = if once { &[] } else { &["kind", "name"] };
                unread = read_fields(&mut cx, info, implicit, b.table, b.span.clone(), &mut values);
                if b.word != "study" {
                    super::unusual::check(info, &values, &b.who, out);
                }
            }
            let block = Block {
                kind: b.info.map_or("", |k| k.kind),
                name: b.name.clone(),
                values,
                span: b.span.clone(),
                kind_span: get(b.table, "kind").and_then(|e| e.node.span.clone()),
                name_span: get(b.table, "name").and_then(|e| e.node.span.clone()),
            };
            Drafted { word: b.word, block, sound: b.sound && unread.is_empty() && errors(out) == before, unread, misnamed: b.misnamed }
        };
        raw.iter().map(one).collect()
    };
    let (parts, extras, studies) = (read(&parts_raw), read(&extras_raw), read(&studies_raw));
    Draft { machine, machine_unread, parts, extras, studies, strange }
}

/// The block a header means; says what is wrong with it.
fn top<'n, 'a>(entry: &'n Entry<'a>, root: &[Entry], catalog: &'n Catalog, out: &mut Diagnostics) -> Top<'n, 'a> {
    let key = entry.key.as_ref();
    let words = || TOP.into_iter().chain(catalog.blocks.iter().map(|b| b.word));
    if let Some(word) = words().find(|w| *w == key) {
        return Top { entry, word: Some(word), kind: None };
    }
    unknown_table(entry, catalog, out);
    let of = |list: &'n [KindInfo]| list.iter().find(|k| k.kind == key);
    if let Some(kind) = of(&catalog.parts) {
        return Top { entry, word: Some("part"), kind: Some(kind) };
    }
    if let Some(kind) = of(&catalog.studies) {
        return Top { entry, word: Some("study"), kind: Some(kind) };
    }
    let several = |word: &str| several(catalog, word);
    // taken for what it resembles only where that is plain: blocks with a kind, or the only one of its sort
    let kinds = tables(entry).iter().any(|(t, _)| get(t, "kind").is_some());
    let alone = |word: &str| get(root, word).is_none() && entry.node.table().is_some();
    let word = meant(key, words()).filter(|w| if several(w) { kinds } else { alone(w) });
    Top { entry, word, kind: None }
}

/// There may be several blocks of this word.
pub(super) fn several(catalog: &Catalog, word: &str) -> bool {
    matches!(word, "part" | "study") || catalog.blocks.iter().any(|b| b.several && b.word == word)
}

/// The word a misspelt header resembles.
fn meant(key: &str, words: impl Iterator<Item = &'static str>) -> Option<&'static str> {
    match key.to_ascii_lowercase().as_str() {
        "studies" | "analysis" | "analyses" => Some("study"),
        _ => nearest(key, words),
    }
}

/// The tables of an entry: one, or each of a list.
fn tables<'n, 'a>(e: &'n Entry<'a>) -> Vec<(&'n [Entry<'a>], Option<Span>)> {
    match &e.node.data {
        Data::List(list) => list.iter().filter_map(|n| Some((n.table()?, n.span.clone()))).collect(),
        _ => e.node.table().map(|t| (t, e.node.span.clone())).into_iter().collect(),
    }
}

/// Names given in blocks that are not understood: what refers to them is not wrong.
fn names_in(e: &Entry) -> Vec<String> {
    let given = |t: &[Entry]| get(t, "name").and_then(|n| n.node.text()).map(str::to_string);
    tables(e).into_iter().map(|(t, _)| given(t).unwrap_or_else(|| e.key.to_string())).collect()
}

/// The table of a block that exists once, in single brackets; the first of several.
fn single<'n, 'a>(e: &'n Entry<'a>, word: &str, out: &mut Diagnostics) -> Option<(&'n [Entry<'a>], Option<Span>)> {
    if e.node.table().is_none() {
        let list = matches!(e.node.data, Data::List(_));
        let d = if list {
            Diagnostic::error("file.brackets", text!("there is one {word} in a file", word))
                .at(e.node.span.clone())
                .label(text!("double brackets"))
        } else {
            Diagnostic::error("file.brackets", text!("{word} must be a block", word = text::quoted(&word))).at(e.span.clone())
        };
        out.push(d.help(text!("write [{word}], with single brackets, once, and its keys below", word)));
    }
    tables(e).into_iter().next()
}

/// A block that exists once, in single brackets.
fn gather_one<'n, 'a>(e: &'n Entry<'a>, word: &'static str, known: &'n [KindInfo], out: &mut Diagnostics) -> Option<Raw<'n, 'a>> {
    let sound = e.node.table().is_some() && e.key == word;
    let (table, span) = single(e, word, out)?;
    Some(Raw { word, table, span, info: known.first(), name: word.to_string(), who: format!("[{word}]"), sound, misnamed: false })
}

fn unknown_table(e: &Entry, catalog: &Catalog, out: &mut Diagnostics) {
    let key = e.key.as_ref();
    let is_kind = |list: &[KindInfo]| list.iter().any(|k| k.kind == key);
    let help = if is_kind(&catalog.parts) {
        text!("a {key} is a part: write [[part]] and below it kind = \"{key}\"", key)
    } else if is_kind(&catalog.studies) {
        text!("{key} is a study: write [[study]] and below it kind = \"{key}\"", key)
    } else if e.node.table().is_none() && !matches!(&e.node.data, Data::List(l) if l.iter().any(|n| n.table().is_some())) {
        let field = MACHINE_FIELDS.iter().find(|f| f.name == key);
        match field {
            Some(f) => text!(
                "every key stands in a block: [machine], [[part]] or [[study]]; {name} belongs below [machine]",
                name = text::quoted(&f.name)
            ),
            None => text!("every key stands in a block: [machine], [[part]] or [[study]]"),
        }
    } else {
        let meant = meant(key, TOP.into_iter().chain(catalog.blocks.iter().map(|b| b.word)));
        let beside: Vec<String> =
            catalog.blocks.iter().map(|b| if b.several { format!("[[{}]]", b.word) } else { format!("[{}]", b.word) }).collect();
        let known = match beside.as_slice() {
            [] => text!("a file has one [machine], and blocks [[part]] and [[study]]"),
            _ => text!("a file has one [machine], and blocks [[part]] and [[study]]; also {beside}", beside = beside.join(", ")),
        };
        match meant {
            Some(m) if m == "machine" || catalog.blocks.iter().any(|b| b.word == m && !b.several) => {
                diagnostic::meant(format!("[{m}]"), known)
            }
            Some(m) => diagnostic::meant(format!("[[{m}]]"), known),
            None => known,
        }
    };
    out.push(
        Diagnostic::error("file.unknown_table", text!("{key} is not a block of a machine file", key = text::quoted(&clip(key))))
            .at(e.span.clone())
            .label(text!("unknown"))
            .help(help),
    );
}

/// Kind and name of every block of one word. Names that cannot be used, and are still meant by others, go to `strange`.
fn gather<'n, 'a>(
    tops: &[&Top<'n, 'a>],
    what: &'static str,
    known: &'n [KindInfo],
    strange: &mut Vec<String>,
    out: &mut Diagnostics,
) -> Vec<Raw<'n, 'a>> {
    let mut nodes: Vec<(&'n Node<'a>, &Top<'n, 'a>)> = Vec::new();
    for &t in tops {
        let e = t.entry;
        match &e.node.data {
            Data::List(list) => nodes.extend(list.iter().map(|n| (n, t))),
            Data::Table(_) => {
                if e.key == what {
                    out.push(brackets(what, e.node.span.clone()));
                }
                nodes.push((&e.node, t));
            }
            _ => out.push(
                Diagnostic::error("file.brackets", text!("{what} must be a block", what = text::quoted(&what)))
                    .at(e.span.clone())
                    .help(text!("write [[{what}]] and its keys below", what)),
            ),
        }
    }
    nodes.sort_by_key(|(n, _)| n.span.as_ref().map(|s| s.start));
    let mut blocks = Vec::with_capacity(nodes.len());
    let mut taken: BTreeMap<String, String> = BTreeMap::new();
    for (node, top) in nodes {
        let Some(table) = node.table() else {
            out.push(
                Diagnostic::error("file.brackets", text!("a {what} must be a block, not {shape}", what, shape = node.shape()))
                    .at(node.span.clone()),
            );
            continue;
        };
        let before = errors(out);
        let given = get(table, "name");
        let label = given.and_then(|n| n.node.text()).map(clip);
        let info = match top.kind {
            Some(kind) => Some(kind),
            None => read_kind(table, node.span.clone(), what, label.as_deref(), known, out),
        };
        let mut name = String::new();
        if let Some(n) = given {
            name = read_name(n, what, out).unwrap_or_default();
            match taken.get(&name.to_lowercase()) {
                _ if name.is_empty() => strange.extend(n.node.text().map(str::to_string)),
                Some(first) => {
                    let own = text::quoted(&name);
                    let message = if *first == name {
                        text!("two blocks [[{what}]] are named {name}", what, name = own)
                    } else {
                        let first = text::quoted(first);
                        text!("two blocks [[{what}]] are named {name} (apart from capitals the same as {first})", what, name = own, first)
                    };
                    out.push(
                        Diagnostic::error("name.twice", message)
                            .at(n.node.span.clone())
                            .label(text!("taken above"))
                            .help(text!("give each its own name; others refer to it by that name")),
                    );
                }
                None => drop(taken.insert(name.to_lowercase(), name.clone())),
            }
        }
        let kind = info.map_or(what, |k| k.kind);
        let who = match &label {
            Some(l) => format!("{kind} {l:?}"),
            None => kind.to_string(),
        };
        let sound = errors(out) == before && top.entry.key == what && matches!(top.entry.node.data, Data::List(_));
        blocks.push(Raw {
            word: what,
            table,
            span: node.span.clone(),
            info,
            misnamed: given.is_some() && name.is_empty(),
            name,
            who,
            sound,
        });
    }
    let mut count: BTreeMap<&str, usize> = BTreeMap::new();
    for b in blocks.iter_mut().filter(|b| b.name.is_empty()) {
        let kind = b.info.map_or(what, |k| k.kind);
        let n = count.entry(kind).or_insert(0);
        loop {
            *n += 1;
            let name = if *n == 1 { kind.to_string() } else { format!("{kind}-{n}") };
            if let std::collections::btree_map::Entry::Vacant(v) = taken.entry(name.to_lowercase()) {
                v.insert(name.clone());
                if *n > 1 && b.who == kind {
                    b.who = format!("{kind} {name:?}");
                }
                b.name = name;
                break;
            }
        }
    }
    blocks
}

/// Reads the keys of a block. Returns those that were given, or are needed, and could not be read.
pub(super) fn read_fields(
    cx: &mut Context,
    kind: &KindInfo,
    implicit: &[&str],
    table: &[Entry],
    span: Option<Span>,
    values: &mut Values,
) -> Vec<&'static str> {
    let fields = &kind.fields;
    let mut unread = Vec::new();
    for e in table {
        if implicit.contains(&e.key.as_ref()) {
            continue;
        }
        if let Some(f) = fields.iter().find(|f| f.name == e.key) {
            if !cx.field(f, &e.node, values) {
                unread.push(f.name);
            }
            continue;
        }
        let message = text!("{who} has no key {key}", who = cx.who, key = text::quoted(&clip(&e.key)));
        let holds = |f: &&Field| matches!(f.kind, FieldKind::OneOf(options) if options.iter().any(|o| o.0 == e.key));
        let around = fields.iter().find(holds).map(|f| f.name);
        let absent = around.or_else(|| nearest(&e.key, fields.iter().filter(|f| get(table, f.name).is_none()).map(|f| f.name)));
        // it is the misspelt key that is wrong; the right one is not missing as well
        unread.extend(fields.iter().find(|f| Some(f.name) == absent).map(|f| f.name));
        let close = absent.or_else(|| nearest(&e.key, fields.iter().map(|f| f.name)));
        let all = fields.iter().map(|f| f.name).chain(implicit.iter().copied()).collect::<Vec<_>>().join(", ");
        let help = match (around, close) {
            (Some(f), _) => text!("it stands inside {f}: {f} = {{ {key} = .. }}", f, key = e.key),
            (None, Some(c)) => text!("did you mean {near}? Its keys: {all}", near = text::quoted(&c), all),
            (None, None) => text!("its keys: {all}", all),
        };
        cx.error("key.unknown", e.span.clone(), message, text!("unknown key"), help);
    }
    for f in fields {
        if get(table, f.name).is_some() || unread.contains(&f.name) {
            continue;
        }
        if f.required {
            unread.push(f.name);
            let message = text!("{who} needs {name}: {doc}", who = cx.who, name = text::quoted(&f.name), doc = text::term(f.doc));
            let word = |w: &(&'static str, &'static str)| {
                text!("{name} = {word} ({meaning})", name = f.name, word = text::quoted(&w.0), meaning = text::term(w.1))
            };
            let example = match f.kind {
                FieldKind::Choice(words) => text::list(words.iter().map(word), Joint::Ors),
                _ => super::docs::example_line(f, kind.example).argument(),
            };
            let help = text!("add {example}", example);
            cx.error("key.missing", span.clone(), message, text!("{name} = .. is missing", name = f.name), help);
        } else {
            cx.default(f, values);
        }
    }
    unread
}

/// The `[machine]` block, and its keys that could not be read.
fn read_machine(cx: &mut Context, entry: Option<&Entry>) -> (MachineBlock, Vec<&'static str>) {
    let all = || MACHINE_FIELDS.iter().map(|f| f.name).collect();
    let Some(e) = entry else {
        cx.out.push(
            Diagnostic::error("file.no_machine", text!("the file has no [machine] block"))
                .help(text!("begin it with [machine] and, below, name = \"..\" and speed = \"3000 rpm\"")),
        );
        return (MachineBlock::default(), all());
    };
    let Some((table, span)) = single(e, "machine", cx.out) else { return (MachineBlock::default(), all()) };
    let mut values = Values::default();
    let unread = read_fields(cx, &super::docs::machine(), &[], table, span.clone(), &mut values);
    let block = MachineBlock {
        name: values.text("name").unwrap_or_default().to_string(),
        speed: values.number("speed"),
        axis: if values.choice("axis") == Some("horizontal") { RotorAxis::Horizontal } else { RotorAxis::Vertical },
        drive: if values.choice("drive") == Some("free") { Drive::Free } else { Drive::Prescribed },
        span,
        speed_span: values.number("speed").and_then(|_| values.span_of("speed")),
    };
    (block, unread)
}
