//! `laval check`.

use crate::input::{self, Input};
use crate::{DONE, WRONG, terminal};
use laval::diagnostic::{Diagnostic, Diagnostics};
use laval::file::{Loaded, diagnostics_json};
use std::path::PathBuf;

/// What may be said to `check`.
#[derive(clap::Args)]
pub struct Args {
    /// The machine file
    file: PathBuf,
    /// Print the result as JSON to standard output, for editors
    #[arg(long)]
    json: bool,
}

/// Reads and assembles, and says what is wrong.
pub fn check(args: &Args) -> u8 {
    match Input::read(&args.file) {
        Ok(input) => {
            let loaded = input.check();
            if args.json { as_json(&loaded, &input.text()) } else { in_words(&loaded, &input) }
        }
        Err(d) if args.json => as_json(&Err(Diagnostics(vec![d])), ""),
        Err(d) => refuse(&d),
    }
}

fn refuse(d: &Diagnostic) -> u8 {
    input::complain(d);
    WRONG
}

fn in_words(loaded: &Result<Loaded, Diagnostics>, input: &Input) -> u8 {
    match loaded {
        Ok(l) => {
            input.complain(&l.warnings);
            terminal::print(&format!("ok: {}\n", summary(l)));
            DONE
        }
        Err(found) => {
            input.complain(found);
            WRONG
        }
    }
}

fn summary(l: &Loaded) -> String {
    let count = |n: usize, one: &str, many: &str| format!("{n} {}", if n == 1 { one } else { many });
    let mut out = vec![count(l.system.slots().len(), "part", "parts"), count(l.system.n(), "coordinate", "coordinates")];
    if l.system.m() > 0 {
        out.push(count(l.system.m(), "internal state", "internal states"));
    }
    out.push(match l.studies.as_slice() {
        [] => "no studies".into(),
        [one] => format!("study {}", one.name),
        many => format!("studies {}", many.iter().map(|s| s.name.as_str()).collect::<Vec<_>>().join(", ")),
    });
    out.join(", ")
}

fn as_json(loaded: &Result<Loaded, Diagnostics>, text: &str) -> u8 {
    let (code, json) = match loaded {
        Ok(l) => (
            DONE,
            serde_json::json!({
                "ok": true,
                "machine": l.system.machine.name,
                "parts": l.system.slots().len(),
                "coordinates": l.system.coordinates().iter().map(|c| c.name.as_str()).collect::<Vec<_>>(),
                "states": l.system.states().iter().map(|c| c.name.as_str()).collect::<Vec<_>>(),
                "studies": l.studies.iter().map(|s| serde_json::json!({ "name": s.name, "kind": s.study.kind() })).collect::<Vec<_>>(),
                "diagnostics": diagnostics_json(&l.warnings, text),
            }),
        ),
        Err(found) => (WRONG, serde_json::json!({ "ok": false, "diagnostics": diagnostics_json(found, text) })),
    };
    terminal::print(&format!("{json:#}\n"));
    code
}
