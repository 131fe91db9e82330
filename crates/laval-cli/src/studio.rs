//! `laval studio`.

use crate::new::TEMPLATES;
use crate::{DONE, WRONG, input, interrupt, language, terminal};
use laval::diagnostic::Diagnostic;
use laval::report::Language;
use laval::text;
use laval_studio::{Example, Options, Server, share_behind};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// What may be said to `studio`.
#[derive(clap::Args)]
pub struct Args {
    /// The machine file to open [default: an example]
    file: Option<PathBuf>,
    /// The port of the page on this computer [default: a free one]
    #[arg(long, value_name = "PORT", default_value_t = 0, hide_default_value = true)]
    port: u16,
    /// Print the address of the page, and open no browser
    #[arg(long, visible_alias = "no-open")]
    no_browser: bool,
    /// The secret part of the address, for programs that start the studio: at least 8 letters and digits [default: a random one]
    #[arg(long, value_name = "TOKEN")]
    token: Option<String>,
    /// Language of the page: en, ru, kk, uz [default: that of LANG where it is one of them]
    #[arg(long, value_name = "LANGUAGE", value_parser = str::parse::<Language>)]
    lang: Option<Language>,
}

/// The folder of a machine file, and the file in it.
fn place(file: &Path) -> Result<(PathBuf, PathBuf), Diagnostic> {
    let wrong = |message| Diagnostic::error("studio.file", message);
    if file.is_dir() {
        return Err(wrong(text!("{path} is a folder", path = file.display())));
    }
    let Some(name) = file.file_name().filter(|_| file.extension().is_some_and(|e| e == "toml")) else {
        return Err(wrong(text!("{path} is no machine file: its name does not end in .toml", path = file.display())));
    };
    if !file.exists() {
        let d = wrong(text!("there is no file {path}", path = file.display()));
        return Err(d.help(text!("laval new writes a machine file to start from")));
    }
    let folder = file.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let folder = folder.canonicalize().map_err(|e| wrong(text!("cannot read {path}: {e}", path = file.display(), e)))?;
    Ok((folder.clone(), folder.join(name)))
}

/// Serves the page until Ctrl-C.
pub fn studio(args: &Args) -> u8 {
    language::request(args.lang);
    let complain = |d: &Diagnostic| {
        input::complain(d);
        WRONG
    };
    let (folder, file) = match args.file.as_deref().map(place).transpose() {
        Ok(Some((folder, file))) => (folder, Some(file)),
        Ok(None) => (PathBuf::from("."), None),
        Err(d) => return complain(&d),
    };
    let examples = TEMPLATES.iter().map(|t| Example { name: t.name, title: t.about, text: t.text }).collect();
    let (port, token, language) = (args.port, args.token.clone(), language::current());
    let options = Options { folder, file, port, token, language, examples, ..Options::default() };
    let server = match Server::new(options) {
        Ok(server) => server,
        Err(d) => return complain(&d),
    };
    let handle = server.handle();
    interrupt::listen(move || handle.stop());
    let address = server.address();
    terminal::print(&format!("{address}\n"));
    if !args.no_browser {
        terminal::say(&text!("The studio is open in the browser; Ctrl-C ends it."));
        if !opened(&address) {
            terminal::say(&text!("note: no browser could be opened; open the address above"));
        }
    }
    share_behind();
    match server.serve() {
        Ok(()) => DONE,
        Err(d) => complain(&d),
    }
}

/// Opens an address with the program that the system has for it.
fn opened(address: &str) -> bool {
    let (program, before): (&str, &[&str]) = match std::env::consts::OS {
        "macos" => ("open", &[]),
        "windows" => ("cmd", &["/C", "start", ""]),
        _ => ("xdg-open", &[]),
    };
    let mut command = Command::new(program);
    command.args(before).arg(address).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command.spawn().is_ok()
}
