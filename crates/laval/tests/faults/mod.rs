//! Machine files as users wrote them, each with what is right for the whole of it: closed forms, a second
//! method, sentences that follow from them.

mod branches;
mod files;
mod linear;

use crate::common::files::load;
use laval::outcome::{Data, Outcome};
use laval::study::{Cancel, Context};

/// The outcome of one study of a file, by its name, and the units of work it took.
fn run(text: &str, name: &str) -> (Outcome, u64) {
    let loaded = load(text);
    let named = loaded.studies.iter().find(|s| s.name == name).unwrap_or_else(|| panic!("no study {name}"));
    let stop = Cancel::default();
    let context = Context { name, cancel: &stop, ..Context::quiet("") };
    (named.study.run(&loaded.system, &context).unwrap_or_else(|d| panic!("{d:?}")), stop.spent())
}

fn column(o: &Outcome, table: &str, name: &str) -> Vec<f64> {
    match &o.find_table(table).unwrap_or_else(|| panic!("no {table}")).column(name).unwrap_or_else(|| panic!("no {name}")).data {
        Data::Float(v) => v.clone(),
        other => panic!("{name}: {other:?}"),
    }
}

fn words<'o>(o: &'o Outcome, table: &str, name: &str) -> &'o [String] {
    match &o.find_table(table).unwrap_or_else(|| panic!("no {table}")).column(name).unwrap_or_else(|| panic!("no {name}")).data {
        Data::Text(v) => v,
        other => panic!("{name}: {other:?}"),
    }
}

#[track_caller]
fn near(found: f64, known: f64, relative: f64) {
    assert!((found - known).abs() <= relative * known.abs(), "{found} for {known}");
}
