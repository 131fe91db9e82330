//! What goes to the terminal, and how. All of it leaves here: control characters that are not the program's own are shown as escapes.

use crate::language;
use laval::file::Form;
use laval::plain;
use laval::report::Terminal;
use laval::text;
use laval::text::Text;
use std::io::{self, IsTerminal, Write};
use std::sync::atomic::{AtomicBool, Ordering};
use terminal_size::{Width, terminal_size_of};

/// Standard output took not all it was given.
static LOST: AtomicBool = AtomicBool::new(false);

/// Prints results. A closed pipe (`laval parts | head`) ends the output quietly; any other failure is reported once, and [`lost`] says so.
pub fn print(text: &str) {
    put(&plain::lines(text));
}

/// As [`print`], for text that the program has coloured and in which names are escaped already.
pub fn print_painted(text: &str) {
    put(&plain::painted(text));
}

fn put(text: &str) {
    let mut out = io::stdout().lock();
    let written = out.write_all(text.as_bytes()).and_then(|()| out.flush());
    drop(out);
    if let Err(e) = written
        && e.kind() != io::ErrorKind::BrokenPipe
        && !LOST.swap(true, Ordering::Relaxed)
    {
        say(&text!("laval: cannot write to standard output: {e}", e));
    }
}

/// Something printed was lost.
pub fn lost() -> bool {
    LOST.load(Ordering::Relaxed)
}

/// Prints a sentence in a line of its own to standard error, in the language of the program.
pub fn say(text: &Text) {
    complain(&format!("{}\n", plain::line(&language::said(text))));
}

/// Prints a message to standard error.
pub fn complain(text: &str) {
    let _ = io::stderr().lock().write_all(plain::lines(text).as_bytes());
}

/// As [`complain`], for text that the program has coloured and in which names are escaped already.
pub fn complain_painted(text: &str) {
    let _ = io::stderr().lock().write_all(plain::painted(text).as_bytes());
}

/// Columns of standard output; 80 where it is no terminal.
pub fn width() -> usize {
    columns(terminal_size_of(io::stdout()), 80)
}

fn columns(size: Option<(Width, terminal_size::Height)>, otherwise: usize) -> usize {
    size.map_or(otherwise, |(Width(w), _)| usize::from(w))
}

fn colour(stream: &impl IsTerminal) -> bool {
    stream.is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|v| v.is_empty())
}

/// How findings are shown.
pub fn findings() -> Terminal {
    Terminal { width: width(), colour: colour(&io::stdout()) }
}

/// How diagnostics are shown on standard error: with excerpts of the file on a terminal, one line each elsewhere.
pub fn diagnostics() -> Form {
    Form::for_stream(&io::stderr(), columns(terminal_size_of(io::stderr()), 80))
}
