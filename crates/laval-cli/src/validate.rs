//! `laval validate`: runs the validation cases, writes the gallery, fails when a verdict has changed.

use crate::{DONE, FAILED, WRONG, input, terminal};
use laval::diagnostic::Diagnostic;
use laval::output_folder::{Held, Lasting, write_whole};
use laval::plain;
use laval::text;
use laval::validation::{Document, Page, documents, gallery, run};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

/// What may be said to `validate`.
#[derive(clap::Args)]
pub struct Args {
    /// Folders of cases [default: validation, here or in a folder above]
    folders: Vec<PathBuf>,
    /// Folder of the gallery
    #[arg(long, default_value = "out/validation")]
    out: PathBuf,
    /// Only cases whose topic/case contains this text
    #[arg(long, value_name = "TEXT")]
    only: Option<String>,
    /// Say only what has changed
    #[arg(long, short)]
    quiet: bool,
}

/// Runs the cases.
pub fn validate(args: &Args) -> u8 {
    let cases = match find(args) {
        Ok(cases) => cases,
        Err(d) => {
            input::complain(&d);
            return WRONG;
        }
    };
    let _held = match Held::take(&args.out) {
        Ok(held) => held,
        Err(d) => {
            input::complain(&d);
            return WRONG;
        }
    };
    let width = cases.iter().map(|c| c.id.len()).max().unwrap_or(0);
    let done = AtomicUsize::new(0);
    let pages = run(&cases, |page| {
        let n = done.fetch_add(1, Ordering::Relaxed) + 1;
        if !args.quiet || !page.holds() {
            let mark = if page.holds() { "" } else { "  CHANGED" };
            terminal::print(&format!("{n:3}/{}  {:width$}  {}{mark}\n", cases.len(), page.id(), page.verdict()));
        }
    });
    let changed: Vec<&Page> = pages.iter().filter(|p| !p.holds()).collect();
    for page in &changed {
        terminal::complain_painted(&format!("\n{}", reported(page)));
    }
    match write(&args.out, &pages) {
        Ok(()) => {}
        Err(code) => return code,
    }
    if !args.quiet {
        terminal::print(&format!("\n{}\n", args.out.join("index.html").display()));
    }
    if changed.is_empty() {
        return DONE;
    }
    terminal::complain("\n");
    terminal::say(&text!("{n} of {all} cases are not as their pages state", n = changed.len(), all = pages.len()));
    WRONG
}

fn find(args: &Args) -> Result<Vec<Document>, Diagnostic> {
    let folders = if args.folders.is_empty() { vec![nearest_folder()?] } else { args.folders.clone() };
    let mut all = Vec::new();
    for folder in &folders {
        let found = documents(folder)
            .map_err(|(path, e)| Diagnostic::error("validation.read", text!("cannot read {path}: {e}", path = path.display(), e)))?;
        if found.is_empty() {
            let d = Diagnostic::error("validation.none", text!("there is no case in {folder}", folder = folder.display()));
            return Err(d.help(text!("a case is a page TOPIC/CASE.md; docs/validation.md says how to write one")));
        }
        all.extend(found);
    }
    if let Some(text) = &args.only {
        all.retain(|d| d.id.contains(text.as_str()));
        if all.is_empty() {
            return Err(Diagnostic::error("validation.only", text!("no case has {text} in its name", text = text::quoted(&text))));
        }
    }
    Ok(all)
}

/// `validation` in the current folder or the nearest one above.
fn nearest_folder() -> Result<PathBuf, Diagnostic> {
    let none = || {
        Diagnostic::error("validation.folder", text!("there is no folder \"validation\" here or above"))
            .help(text!("run inside the source repository of laval, or name a folder of cases"))
    };
    let here = std::env::current_dir().map_err(|_| none())?;
    here.ancestors().map(|a| a.join("validation")).find(|v| v.is_dir()).ok_or_else(none)
}

/// Why a page is not as it states.
fn reported(page: &Page) -> String {
    let mut s = format!("{}: {}\n{}", plain::line(page.id()), page.verdict(), page.complaint(terminal::diagnostics()));
    if let Page::Checked(c) = page {
        if c.verdict().is_some_and(|v| v != c.case.verdict) {
            s += &format!("  the page states \"{}\"\n", c.case.verdict.words());
        }
        for (e, found) in c.case.expected.iter().zip(&c.compared).filter(|(e, found)| e.stated != found.row) {
            let at = if e.at.is_empty() { String::new() } else { format!(" at {}", plain::line(&e.at)) };
            s += &format!(
                "  {}: {}{at} is {} {}, expected {}: {} instead of {}\n",
                plain::line(&e.study),
                plain::line(&e.value),
                found.measured,
                e.unit,
                e.expected_text,
                found.row.word(),
                e.stated.word()
            );
        }
    }
    s
}

fn write(out: &Path, pages: &[Page]) -> Result<(), u8> {
    let files = gallery(pages).map_err(|e| {
        terminal::say(&text!("laval: {why}", why = e));
        FAILED
    })?;
    for (name, content) in files {
        let path = out.join(name);
        write_whole(&path, &content.into_bytes(), Lasting::Kill).map_err(|e| {
            terminal::say(&text!("laval: cannot write {path}: {e}", path = path.display(), e));
            WRONG
        })?;
    }
    Ok(())
}
