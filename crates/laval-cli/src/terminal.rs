//! What goes to the terminal, and how.

use laval::file::Form;
use laval::report::Terminal;
use std::io::{self, IsTerminal, Write};
use terminal_size::{Width, terminal_size_of};

/// Prints results. A closed pipe (`laval parts | head`) ends the output quietly.
pub fn print(text: &str) {
    let mut out = io::stdout().lock();
    // nobody is left to be told when standard output is gone
    let _ = out.write_all(text.as_bytes()).and_then(|()| out.flush());
}

/// Prints a message to standard error.
pub fn complain(text: &str) {
    let _ = io::stderr().lock().write_all(text.as_bytes());
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
