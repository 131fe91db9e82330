//! Models that the Python program ROSS (2 and 3) saves by `rotor.save("rotor.toml")` or `rotor.save("rotor.json")`.
//!
//! Such a file has a table for every element, `["DiskElement_Disk 0"]`, with the arguments from which ROSS makes it anew; bearings have their coefficients
//! there, whatever they were computed from. All numbers are in SI units.

use super::Imported;
use super::machine::write;
use super::model::{Kind, Model, Read};
use crate::diagnostic::{Diagnostic, Diagnostics, Span};
use crate::file::load;
use crate::file::tree::{Entry, from_json, from_table, too_deep};
use crate::text;
use crate::text::{Arg, Joint, Text};
use toml::de::DeTable;

/// Makes a machine file of a saved model; `name` is that of the machine.
///
/// # Errors
/// All that is wrong with the model, at its place where it is TOML, and at the element where it is JSON.
pub fn import(bytes: &[u8], name: &str) -> Result<Imported, Diagnostics> {
    let one = |d: Diagnostic| Diagnostics(vec![d]);
    let text = std::str::from_utf8(bytes).map_err(|e| {
        let at = e.valid_up_to();
        one(no_model(text!("it is not UTF-8 text")).at(at..at + 1))
    })?;
    let model = if text.trim_start().starts_with('{') {
        let value: serde_json::Value = serde_json::from_str(text).map_err(|e| one(syntax(&e, place(text, e.line(), e.column()))))?;
        let node = from_json(&value);
        let Some(root) = node.table() else { return Err(one(no_model(text!("it is not a table of elements")))) };
        read(root, |key| {
            let word = serde_json::Value::from(key).to_string();
            text.find(&word).map(|at| at..at + word.len())
        })?
    } else {
        if let Some(span) = too_deep(text) {
            return Err(one(no_model(text!("its tables are nested too deeply")).at(span)));
        }
        let table = DeTable::parse(text).map_err(|e| one(syntax(&e.message(), e.span())))?;
        read(&from_table(table.into_inner()), |_| None)?
    };
    let imported = write(&model, name)?;
    // bounds of values, and what the parts say of each other, are those of every machine file
    match load(&imported.text) {
        Ok(_) => Ok(imported),
        Err(found) => Err(Diagnostics(
            found
                .0
                .into_iter()
                .map(|d| Diagnostic::error("ross.machine", text!("this model is no machine here: {why}", why = d.sentence())))
                .collect(),
        )),
    }
}

fn no_model(why: Text) -> Diagnostic {
    Diagnostic::error("ross.file", text!("this is no model that ROSS has saved: {why}", why))
        .help(text!("rotor.save(\"rotor.toml\") and rotor.save(\"rotor.json\") of ROSS 2 and 3 write models that can be read"))
}

fn syntax(e: &dyn std::fmt::Display, span: Option<Span>) -> Diagnostic {
    let why = e.to_string();
    Diagnostic::error("ross.syntax", text!("the file cannot be read: {why}", why = why.lines().next().unwrap_or_default())).at(span)
}

/// The place of a line and column, counted from 1.
fn place(text: &str, line: usize, column: usize) -> Option<Span> {
    let start: usize = text.split_inclusive('\n').take(line.checked_sub(1)?).map(str::len).sum();
    let at = (start + column.saturating_sub(1)).min(text.len());
    let at = (0..=at).rev().find(|k| text.is_char_boundary(*k))?;
    Some(at..text[at..].chars().next().map_or(at, |c| at + c.len_utf8()))
}

/// Reads the elements; `find` gives the place of a key in a file without places.
fn read(root: &[Entry], find: impl Fn(&str) -> Option<Span>) -> Result<Model, Diagnostics> {
    let mut out = Diagnostics::default();
    let mut model = Model::default();
    for e in root {
        let span = e.span.clone().or_else(|| find(&e.key));
        match (&*e.key, e.node.table()) {
            ("ross_version", _) => model.version = e.node.text().unwrap_or_default().to_string(),
            ("parameters", Some(table)) => model.settings(&mut Read::new("parameters", table, span, &mut out)),
            (_, Some(table)) => {
                let class = e.key.split('_').next().unwrap_or_default();
                let mut element = Read::new(&e.key, table, span, &mut out);
                match Kind::of(class) {
                    Some(kind) => model.element(kind, class, &mut element),
                    None => {
                        let all = Kind::ALL.map(|k| Arg::Plain(k.0.into())).to_vec();
                        let d = Diagnostic::error(
                            "ross.element",
                            text!("elements of the kind {class} are not imported", class = text::quoted(class)),
                        )
                        .help(text!("elements that are imported: {all}", all = text::list(all, Joint::Comma)))
                        .at(element.span.clone());
                        out.push(d);
                    }
                }
            }
            _ => {}
        }
    }
    if model.shafts.is_empty() && !out.has_errors() {
        out.push(no_model(text!("it has no ShaftElement")));
    }
    if out.has_errors() {
        out.sort_by_place();
        return Err(out);
    }
    Ok(model)
}
