//! From text to [`Spec`].

use super::draft::Draft;
use super::{Catalog, Spec, blocks, syntax, tree};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::text;
use toml::de::DeTable;

/// Largest file, bytes.
const MAX_BYTES: usize = 64 << 20;

/// Reads a machine file. All mistakes are reported together, in the order of their places; there is a spec if none is an error.
pub fn read(text: &str, catalog: &Catalog) -> (Option<Spec>, Diagnostics) {
    let (draft, out) = read_draft(text, catalog);
    (draft.filter(|_| !out.has_errors()).map(Draft::spec), out)
}

/// As [`read`], with every block as far as it could be read; none when the file is no TOML.
pub(super) fn read_draft(text: &str, catalog: &Catalog) -> (Option<Draft>, Diagnostics) {
    let mut out = Diagnostics::default();
    if text.len() > MAX_BYTES {
        out.push(Diagnostic::error("file.size", text!("the file has {size} MB; at most 64 MB are read", size = text.len() >> 20)));
        return (None, out);
    }
    if let Some(span) = tree::too_deep(text) {
        out.push(
            Diagnostic::error("file.depth", text!("tables within more than {most} others are not read", most = tree::DEEPEST))
                .at(span)
                .label(text!("nested too deeply")),
        );
        return (None, out);
    }
    if let Some(at) = text.find('\0') {
        out.push(
            Diagnostic::error(
                "file.binary",
                text!("the file is no text: byte {number} is NUL (0x00), which no text holds", number = at + 1),
            )
            .at(at..at + 1)
            .label(text!("NUL"))
            .help(text!("save it as UTF-8 text; files in UTF-16, and files that were damaged, hold such bytes")),
        );
        return (None, out);
    }
    let (table, errors) = DeTable::parse_recoverable(text);
    let root = tree::from_table(table.into_inner());
    let draft = blocks::read_tree(text, &root, catalog, &mut out);
    if !errors.is_empty() {
        syntax::merge(text, &errors, |word| blocks::several(catalog, word), &mut out);
    }
    out.sort_by_place();
    (errors.is_empty().then_some(draft), out)
}

/// [`read`] for the bytes of a file: text that is not UTF-8 is one diagnostic. Places are those in
/// `String::from_utf8_lossy(bytes)`.
pub fn read_bytes(bytes: &[u8], catalog: &Catalog) -> (Option<Spec>, Diagnostics) {
    let error = match std::str::from_utf8(bytes) {
        Ok(text) => return read(text, catalog),
        Err(e) => e,
    };
    let mut out = Diagnostics::default();
    let at = error.valid_up_to();
    let help = match bytes {
        [0xff, 0xfe, ..] | [0xfe, 0xff, ..] => text!("it looks like UTF-16; save it as UTF-8"),
        _ => text!("save it as UTF-8; often a unit sign such as µ or ° in an older encoding is the cause"),
    };
    out.push(
        Diagnostic::error(
            "file.encoding",
            text!("the file is not UTF-8 text: byte {number} is 0x{byte}", number = at + 1, byte = format_args!("{:02x}", bytes[at])),
        )
        .at(at..at + 1)
        .label(text!("here"))
        .help(help),
    );
    (None, out)
}

/// Reads the JSON form of a machine (as [`write_json`](super::write_json) gives it; quantities may also be texts with units).
pub fn read_json(value: &serde_json::Value, catalog: &Catalog) -> (Option<Spec>, Diagnostics) {
    let mut out = Diagnostics::default();
    let node = tree::from_json(value);
    let Some(root) = node.table() else {
        out.push(Diagnostic::error(
            "value.type",
            text!("a machine is an object with machine, part and study, not {shape}", shape = node.shape()),
        ));
        return (None, out);
    };
    let draft = blocks::read_tree("", root, catalog, &mut out);
    out.sort_by_place();
    ((!out.has_errors()).then(|| draft.spec()), out)
}
