//! Reading a machine file, and saying what is wrong with it.

use crate::{language, terminal};
use laval::diagnostic::{Diagnostic, Diagnostics};
use laval::file::{self, Loaded};
use laval::text;
use laval::text::Text;
use laval::{plain, run};
use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

/// Largest machine file, bytes.
const MAX_BYTES: u64 = 64 << 20;

/// A machine file on disk.
pub struct Input {
    /// Where.
    pub path: PathBuf,
    /// What it holds.
    pub bytes: Vec<u8>,
}

impl Input {
    /// Reads the bytes of a file.
    pub fn read(path: &Path) -> Result<Input, Diagnostic> {
        let wrong = |message: Text| Diagnostic::error("file.read", message);
        if path.is_dir() {
            let inside = path.join("machine.toml");
            let d = wrong(text!("{path} is a folder, not a machine file", path = path.display()));
            return Err(if inside.is_file() { d.help(text!("give the file: {inside}", inside = inside.display())) } else { d });
        }
        let mut bytes = Vec::new();
        match File::open(path).and_then(|f| f.take(MAX_BYTES + 1).read_to_end(&mut bytes)) {
            Ok(_) if bytes.len() as u64 > MAX_BYTES => Err(wrong(text!("{path} is larger than 64 MB", path = path.display()))),
            Ok(_) => {
                language::of_file(&String::from_utf8_lossy(&bytes));
                Ok(Input { path: path.to_path_buf(), bytes })
            }
            Err(e) if e.kind() == io::ErrorKind::NotFound => {
                Err(wrong(text!("there is no file {path}", path = path.display()))
                    .help(text!("laval new writes a machine file to start from")))
            }
            Err(e) => Err(wrong(text!("cannot read {path}: {e}", path = path.display(), e))),
        }
    }

    /// The text, with a mark in place of bytes that are no text.
    pub fn text(&self) -> String {
        String::from_utf8_lossy(&self.bytes).into_owned()
    }

    /// Reads the text and assembles the machine.
    pub fn load(&self) -> Result<Loaded, Diagnostics> {
        file::load_bytes(&self.bytes)
    }

    /// As [`load`](Self::load), where a study that the machine cannot answer is a mistake too.
    pub fn check(&self) -> Result<Loaded, Diagnostics> {
        let loaded = self.load()?;
        let refusals = loaded.refusals();
        if refusals.is_empty() {
            return Ok(loaded);
        }
        let mut all = loaded.warnings;
        all.0.extend(refusals.into_iter().map(|r| r.diagnostic));
        all.sort_by_place();
        Err(all)
    }

    /// The name by which results refer to the file.
    pub fn name(&self) -> String {
        run::name(&self.path)
    }

    /// The name of the machine's folder of results.
    pub fn stem(&self) -> String {
        run::stem(&self.path)
    }

    /// Says on standard error what was found.
    pub fn complain(&self, found: &Diagnostics) {
        if !found.0.is_empty() {
            let (file, form) = (self.path.display().to_string(), terminal::diagnostics());
            terminal::complain_painted(&file::render_in(language::current(), found, &self.text(), &file, form));
        }
    }
}

/// Says one thing that is wrong with the request itself.
pub fn complain(d: &Diagnostic) {
    let line = |text: &Text| plain::line(&language::said(text)).into_owned();
    let help = d.help.as_ref().map_or_else(String::new, |h| format!("  {}: {}\n", line(&text!("help")), line(h)));
    terminal::complain(&format!("{}[{}]: {}\n{help}", line(&text!("error")), d.code, line(&d.message)));
}
