//! `laval import`.

use crate::input::Input;
use crate::{DONE, WRONG, input, language, new, terminal};
use clap::Subcommand;
use laval::import::ross;
use laval::report::Language;
use laval::text;
use std::path::{Path, PathBuf};

/// What may be said to `import`.
#[derive(clap::Args)]
pub struct Args {
    #[command(subcommand)]
    from: From,
}

#[derive(Subcommand)]
enum From {
    /// A rotor that the Python program ROSS (2 or 3) saved with rotor.save("rotor.toml") or rotor.save("rotor.json")
    Ross(Saved),
}

#[derive(clap::Args)]
struct Saved {
    /// The saved rotor
    file: PathBuf,
    /// The machine file to write; "-" is standard output [default: NAME-machine.toml]
    #[arg(long)]
    out: Option<PathBuf>,
    /// Language of the messages: en, ru, kk, uz [default: that of LANG]
    #[arg(long, value_name = "LANGUAGE", value_parser = str::parse::<Language>)]
    lang: Option<Language>,
}

/// Writes a machine file, never over an existing one, and says what it leaves out.
pub fn import(args: &Args) -> u8 {
    let From::Ross(args) = &args.from;
    language::request(args.lang);
    let input = match Input::read(&args.file) {
        Ok(input) => input,
        Err(d) => {
            input::complain(&d);
            return WRONG;
        }
    };
    let name = args.file.file_stem().map_or_else(|| "rotor".into(), |s| s.to_string_lossy());
    let imported = match ross::import(&input.bytes, &name) {
        Ok(imported) => imported,
        Err(found) => {
            input.complain(&found);
            return WRONG;
        }
    };
    let said: String = imported.notes.iter().map(|n| format!("- {}\n", language::said(n))).collect();
    let path = args.out.clone().unwrap_or_else(|| PathBuf::from(format!("{name}-machine.toml")));
    if path == Path::new("-") {
        terminal::print(&imported.text);
        terminal::complain(&said);
        return DONE;
    }
    let code = new::create(&path, &imported.text);
    if code == DONE {
        terminal::print(&format!("{}\n{}\n{said}", path.display(), language::said(&text!("Left out, or different in ROSS:"))));
    }
    code
}
