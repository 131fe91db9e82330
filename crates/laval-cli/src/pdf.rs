//! The report as a PDF, printed by a Chromium that is found on this computer.

use laval::diagnostic::Diagnostic;
use laval::text;
use laval::text::{Arg, Argument};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

const BROWSERS: [&str; 6] = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome", "msedge"];

/// Prints the page beside it, as `report.pdf`.
///
/// # Errors
/// No browser is found, or it prints nothing.
pub fn print(page: &Path) -> Result<PathBuf, Diagnostic> {
    let Some(browser) = browser() else {
        let d = Diagnostic::error("pdf.browser", text!("no Chromium was found to print the report with"));
        return Err(d.help(text!(
            "install one of {names}, or open {page} in a browser and print it",
            names = BROWSERS.join(", "),
            page = page.display()
        )));
    };
    let failed =
        |why: Arg| Diagnostic::error("pdf.print", text!("{browser} could not print the report: {why}", browser = browser.display(), why));
    let page = page.canonicalize().map_err(|e| failed(e.argument()))?;
    let pdf = page.with_extension("pdf");
    let profile = page.with_file_name(format!(".laval-{}-browser.part", std::process::id()));
    let _ = std::fs::remove_file(&pdf);
    let run = |more: &[&str]| {
        let mut command = Command::new(&browser);
        command
            .args(["--headless", "--disable-gpu", "--no-first-run", "--disable-background-networking", "--no-pdf-header-footer"])
            .args(more);
        command.arg(format!("--user-data-dir={}", profile.display())).arg(format!("--print-to-pdf={}", pdf.display())).arg(&page);
        command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).status()
    };
    // a browser refuses its sandbox to the superuser; the page is our own and loads nothing
    let status = run(&[]).and_then(|s| if s.success() && pdf.is_file() { Ok(s) } else { run(&["--no-sandbox"]) });
    let _ = std::fs::remove_dir_all(&profile);
    match status {
        Ok(s) if s.success() && pdf.is_file() => Ok(pdf),
        Ok(s) => Err(failed(s.to_string().argument())),
        Err(e) => Err(failed(e.argument())),
    }
}

fn browser() -> Option<PathBuf> {
    let folders: Vec<PathBuf> = std::env::split_paths(&std::env::var_os("PATH")?).collect();
    let found = |name: &&str| folders.iter().map(|f| f.join(name)).find(|p| p.is_file());
    BROWSERS.iter().find_map(found)
}
