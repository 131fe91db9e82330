//! `laval check`.

use crate::input::{self, Input};
use crate::{DONE, WRONG, language, terminal};
use laval::diagnostic::{Diagnostic, Diagnostics};
use laval::file::{Loaded, diagnostics_json_in};
use laval::report::Language;
use laval::text;
use laval::text::{Arg, Joint};
use std::path::PathBuf;

/// What may be said to `check`.
#[derive(clap::Args)]
pub struct Args {
    /// The machine file
    file: PathBuf,
    /// Print the result as JSON to standard output, for editors
    #[arg(long)]
    json: bool,
    /// Language of the messages: en, ru, kk, uz [default: that of the file or of LANG]
    #[arg(long, value_name = "LANGUAGE", value_parser = str::parse::<Language>)]
    lang: Option<Language>,
}

/// Reads and assembles, and says what is wrong.
pub fn check(args: &Args) -> u8 {
    language::request(args.lang);
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
            terminal::print(&format!("{}\n", language::said(&text!("ok: {machine}", machine = summary(l)))));
            DONE
        }
        Err(found) => {
            input.complain(found);
            WRONG
        }
    }
}

fn summary(l: &Loaded) -> Arg {
    let (parts, coordinates, states) = (l.system.slots().len(), l.system.n(), l.system.m());
    let mut out = vec![
        if parts == 1 { text!("{n} part", n = parts) } else { text!("{n} parts", n = parts) },
        if coordinates == 1 { text!("{n} coordinate", n = coordinates) } else { text!("{n} coordinates", n = coordinates) },
    ];
    match states {
        0 => {}
        1 => out.push(text!("{n} internal state", n = states)),
        _ => out.push(text!("{n} internal states", n = states)),
    }
    out.push(match l.studies.as_slice() {
        [] => text!("no studies"),
        [one] => text!("study {one}", one = one.name),
        many => text!("studies {names}", names = many.iter().map(|s| s.name.as_str()).collect::<Vec<_>>().join(", ")),
    });
    text::list(out, Joint::Comma)
}

fn as_json(loaded: &Result<Loaded, Diagnostics>, text: &str) -> u8 {
    // what programs read is English unless another language is requested of this call
    let said = language::requested().unwrap_or_default();
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
                "diagnostics": diagnostics_json_in(said, &l.warnings, text),
            }),
        ),
        Err(found) => (WRONG, serde_json::json!({ "ok": false, "diagnostics": diagnostics_json_in(said, found, text) })),
    };
    terminal::print(&format!("{json:#}\n"));
    code
}
