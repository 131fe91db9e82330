//! The blocks of a file: which exist, their kinds, names and keys.

use super::tree::{Data, Entry, Node, get};
use super::values::{Context, StudyTable, clip, suggestion};
use super::{Axis, Block, Catalog, MACHINE_FIELDS, MachineBlock, Spec};
use crate::diagnostic::{Diagnostic, Diagnostics, Severity, Span, nearest};
use crate::model::field::{Field, FieldKind, KindInfo, Values};
use std::collections::BTreeMap;

/// Longest name of a block.
const MAX_NAME: usize = 64;
const TOP: [&str; 3] = ["machine", "part", "study"];

/// A block before its values are read.
struct Raw<'n, 'a> {
    table: &'n [Entry<'a>],
    span: Option<Span>,
    info: Option<&'n KindInfo>,
    name: String,
    who: String,
}

/// Reads the whole tree. The studies are those without mistakes, the others stand beside; the flag says that nothing else has any.
pub(super) fn read_tree(text: &str, root: &[Entry], catalog: &Catalog, out: &mut Diagnostics) -> (Spec, Vec<Block>, bool) {
    let known = |key: &str| TOP.contains(&key) || catalog.blocks.iter().any(|b| b.word == key);
    for e in root.iter().filter(|e| !known(e.key.as_ref())) {
        unknown_table(e, catalog, out);
    }
    let parts_raw = gather(root, "part", &catalog.parts, out);
    let studies_raw = gather(root, "study", &catalog.studies, out);
    if parts_raw.is_empty() && get(root, "part").is_none() {
        out.push(
            Diagnostic::error("file.no_parts", "the machine has no parts").help("describe each part in a block that begins with [[part]]"),
        );
    }
    let extras_raw: Vec<(&'static str, Vec<Raw>)> = catalog
        .blocks
        .iter()
        .map(|b| (b.word, if b.several { gather(root, b.word, &b.kinds, out) } else { gather_one(root, b.word, &b.kinds, out) }))
        .collect();
    let named = parts_raw.iter().chain(extras_raw.iter().flat_map(|e| &e.1));
    let names: Vec<(String, &'static str)> = named.map(|b| (b.name.clone(), b.info.map_or("", |k| k.kind))).collect();
    let machine = read_machine(text, root, catalog, &names, out);
    let studies: Vec<StudyTable> =
        studies_raw.iter().map(|b| StudyTable { name: &b.name, info: b.info, table: b.table, span: b.span.clone() }).collect();
    let blocks = |raw: &[Raw], out: &mut Diagnostics| -> (Vec<Block>, Vec<Block>) {
        let mut doubtful = Vec::new();
        let mut read = |b: &Raw| {
            let info = b.info?;
            let before = out.0.len();
            let mut values = Values::default();
            values.span = b.span.clone();
            let mut cx = Context { text, catalog, parts: &names, studies: &studies, out, who: &b.who };
            let once = catalog.blocks.iter().any(|x| !x.several && x.word == info.kind);
            let implicit: &[&str] = if once { &[] } else { &["kind", "name"] };
            read_fields(&mut cx, &info.fields, implicit, b.table, b.span.clone(), &mut values);
            let sound = !out.0[before..].iter().any(|d| d.severity == Severity::Error);
            let block = Block {
                kind: info.kind,
                name: b.name.clone(),
                values,
                span: b.span.clone(),
                kind_span: get(b.table, "kind").and_then(|e| e.node.span.clone()),
                name_span: get(b.table, "name").and_then(|e| e.node.span.clone()),
            };
            if sound {
                return Some(block);
            }
            doubtful.push(block);
            None
        };
        let sound = raw.iter().filter_map(&mut read).collect();
        (sound, doubtful)
    };
    let (parts, _) = blocks(&parts_raw, out);
    let mut extras = Vec::new();
    for (word, raw) in &extras_raw {
        extras.extend(blocks(raw, out).0.into_iter().map(|b| (*word, b)));
    }
    let usable = !out.has_errors();
    let (studies, doubtful) = blocks(&studies_raw, out);
    (Spec { machine, parts, studies, extras }, doubtful, usable)
}

/// A block that exists once, in single brackets.
fn gather_one<'n, 'a>(root: &'n [Entry<'a>], word: &'static str, known: &'n [KindInfo], out: &mut Diagnostics) -> Vec<Raw<'n, 'a>> {
    let Some(e) = get(root, word) else { return Vec::new() };
    let Some(table) = e.node.table() else {
        let d = Diagnostic::error("file.brackets", format!("there is one {word} in a file")).at(e.node.span.clone());
        out.push(d.help(format!("write [{word}], with single brackets, once, and its keys below")));
        return Vec::new();
    };
    vec![Raw { table, span: e.node.span.clone(), info: known.first(), name: word.to_string(), who: format!("[{word}]") }]
}

fn unknown_table(e: &Entry, catalog: &Catalog, out: &mut Diagnostics) {
    let key = e.key.as_ref();
    let is_kind = |list: &[KindInfo]| list.iter().any(|k| k.kind == key);
    let help = if is_kind(&catalog.parts) {
        format!("a {key} is a part: write [[part]] and below it kind = \"{key}\"")
    } else if is_kind(&catalog.studies) {
        format!("{key} is a study: write [[study]] and below it kind = \"{key}\"")
    } else if e.node.table().is_none() && !matches!(&e.node.data, Data::List(l) if l.iter().any(|n| n.table().is_some())) {
        let field =
            MACHINE_FIELDS.iter().find(|f| f.name == key).map_or(String::new(), |f| format!("; {:?} belongs below [machine]", f.name));
        format!("every key stands in a block: [machine], [[part]] or [[study]]{field}")
    } else {
        let meant = match key.to_ascii_lowercase().as_str() {
            "studies" | "analysis" | "analyses" => Some("study"),
            _ => nearest(key, TOP),
        };
        let known = "a file has one [machine], and blocks [[part]] and [[study]]";
        match meant {
            Some("machine") => format!("did you mean [machine]? {}", capital(known)),
            Some(m) => format!("did you mean [[{m}]]? {}", capital(known)),
            None => known.to_string(),
        }
    };
    out.push(
        Diagnostic::error("file.unknown_table", format!("{:?} is not a block of a machine file", clip(key)))
            .at(e.span.clone())
            .label("unknown")
            .help(help),
    );
}

fn capital(s: &str) -> String {
    let mut c = s.chars();
    c.next().map(|f| f.to_uppercase().chain(c).collect()).unwrap_or_default()
}

/// Kind and name of every `[[part]]` or `[[study]]`.
fn gather<'n, 'a>(root: &'n [Entry<'a>], what: &'static str, known: &'n [KindInfo], out: &mut Diagnostics) -> Vec<Raw<'n, 'a>> {
    let Some(e) = get(root, what) else { return Vec::new() };
    let nodes: Vec<&'n Node<'a>> = match &e.node.data {
        Data::List(list) => list.iter().collect(),
        Data::Table(_) => {
            out.push(
                Diagnostic::error("file.brackets", format!("[{what}] needs double brackets"))
                    .at(e.node.span.clone())
                    .label("single brackets")
                    .help(format!("write [[{what}]]: there may be several")),
            );
            vec![&e.node]
        }
        _ => {
            out.push(
                Diagnostic::error("file.brackets", format!("{what:?} must be a block"))
                    .at(e.span.clone())
                    .help(format!("write [[{what}]] and its keys below")),
            );
            return Vec::new();
        }
    };
    let mut blocks = Vec::with_capacity(nodes.len());
    let mut taken: BTreeMap<String, (String, Option<Span>)> = BTreeMap::new();
    for node in nodes {
        let Some(table) = node.table() else {
            out.push(Diagnostic::error("file.brackets", format!("a {what} must be a block, not {}", node.shape())).at(node.span.clone()));
            continue;
        };
        let given = get(table, "name");
        let label = given.and_then(|n| n.node.text()).map(clip);
        let info = read_kind(table, node.span.clone(), what, label.as_deref(), known, out);
        let mut name = String::new();
        if let Some(n) = given {
            name = read_name(n, what, out).unwrap_or_default();
            if !name.is_empty() {
                if let Some((first, _)) = taken.get(&name.to_lowercase()) {
                    let same = if *first == name { String::new() } else { format!(" (apart from capitals the same as {first:?})") };
                    out.push(
                        Diagnostic::error("name.twice", format!("two blocks [[{what}]] are named {name:?}{same}"))
                            .at(n.node.span.clone())
                            .label("taken above")
                            .help("give each its own name; others refer to it by that name"),
                    );
                }
                taken.entry(name.to_lowercase()).or_insert_with(|| (name.clone(), n.node.span.clone()));
            }
        }
        let kind = info.map_or(what, |k| k.kind);
        let who = match &label {
            Some(l) => format!("{kind} {l:?}"),
            None => kind.to_string(),
        };
        blocks.push(Raw { table, span: node.span.clone(), info, name, who });
    }
    let mut count: BTreeMap<&str, usize> = BTreeMap::new();
    for b in blocks.iter_mut().filter(|b| b.name.is_empty()) {
        let kind = b.info.map_or(what, |k| k.kind);
        let n = count.entry(kind).or_insert(0);
        loop {
            *n += 1;
            let name = if *n == 1 { kind.to_string() } else { format!("{kind}-{n}") };
            if let std::collections::btree_map::Entry::Vacant(v) = taken.entry(name.to_lowercase()) {
                v.insert((name.clone(), None));
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
        let help = suggestion("", words(), "write kind = \"..\" with one of");
        let mut d =
            Diagnostic::error("kind.missing", format!("this {what}{named} says no kind")).at(span).label("kind = \"..\" is missing");
        d.help = help;
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
        d.help = suggestion(t, words(), &kinds);
        out.push(d);
    }
    found
}

fn read_name(e: &Entry, what: &str, out: &mut Diagnostics) -> Option<String> {
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

pub(super) fn read_fields(cx: &mut Context, fields: &[Field], implicit: &[&str], table: &[Entry], span: Option<Span>, values: &mut Values) {
    for e in table {
        if implicit.contains(&e.key.as_ref()) {
            continue;
        }
        if let Some(f) = fields.iter().find(|f| f.name == e.key) {
            cx.field(f, &e.node, values);
            continue;
        }
        let message = format!("{} has no key {:?}", cx.who, clip(&e.key));
        let absent = fields.iter().filter(|f| get(table, f.name).is_none()).map(|f| f.name);
        let close = nearest(&e.key, absent).or_else(|| nearest(&e.key, fields.iter().map(|f| f.name)));
        let all = fields.iter().map(|f| f.name).chain(implicit.iter().copied()).collect::<Vec<_>>().join(", ");
        let help = match close {
            Some(c) => format!("did you mean {c:?}? Its keys: {all}"),
            None => format!("its keys: {all}"),
        };
        cx.error("key.unknown", e.span.clone(), message, "unknown key", help);
    }
    for f in fields {
        if get(table, f.name).is_some() {
            continue;
        }
        if f.required {
            let message = format!("{} needs {:?}: {}", cx.who, f.name, f.doc);
            let help = match f.kind {
                FieldKind::Choice(words) => {
                    words.iter().map(|w| format!("{} = {:?} ({})", f.name, w.0, w.1)).collect::<Vec<_>>().join(" or ")
                }
                _ => super::docs::example_line(f),
            };
            let help = format!("add {help}");
            cx.error("key.missing", span.clone(), message, &format!("{} = .. is missing", f.name), help);
        } else {
            cx.default(f, values);
        }
    }
}

fn read_machine(text: &str, root: &[Entry], catalog: &Catalog, parts: &[(String, &'static str)], out: &mut Diagnostics) -> MachineBlock {
    let Some(e) = get(root, "machine") else {
        out.push(
            Diagnostic::error("file.no_machine", "the file has no [machine] block")
                .help("begin it with [machine] and, below, name = \"..\" and speed = \"3000 rpm\""),
        );
        return MachineBlock::default();
    };
    let table = match &e.node.data {
        Data::Table(t) => t,
        Data::List(_) => {
            out.push(
                Diagnostic::error("file.brackets", "there is one machine in a file")
                    .at(e.node.span.clone())
                    .label("double brackets")
                    .help("write [machine], with single brackets, once"),
            );
            return MachineBlock::default();
        }
        _ => {
            out.push(
                Diagnostic::error("file.brackets", "\"machine\" must be a block")
                    .at(e.span.clone())
                    .help("write [machine] and its keys below"),
            );
            return MachineBlock::default();
        }
    };
    let mut values = Values::default();
    let mut cx = Context { text, catalog, parts, studies: &[], out, who: "[machine]" };
    read_fields(&mut cx, MACHINE_FIELDS, &[], table, e.node.span.clone(), &mut values);
    MachineBlock {
        name: values.text("name").unwrap_or_default().to_string(),
        speed: values.number("speed"),
        axis: if values.choice("axis") == Some("horizontal") { Axis::Horizontal } else { Axis::Vertical },
        span: e.node.span.clone(),
        speed_span: values.number("speed").and_then(|_| values.span_of("speed")),
    }
}
