//! Findings as a few calm lines for the terminal.

use super::Report;
use super::words::Style;
use crate::outcome::{Arg, Level, Message, Outcome};
use crate::plain;

/// How to write for the terminal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Terminal {
    /// Columns of the terminal.
    pub width: usize,
    /// Whether it is a terminal that takes colour.
    pub colour: bool,
}

impl Default for Terminal {
    fn default() -> Self {
        Terminal { width: 80, colour: false }
    }
}

/// Most results printed for one study; warnings are always printed.
const MOST_RESULTS: usize = 8;

/// The findings of all studies: one heading a study, one sentence a finding with its first evidence, warnings marked with `!` and
/// results outside the validity of their model with `!!`.
///
/// ```
/// use laval::outcome::{Finding, Outcome};
/// use laval::report::{Report, Terminal, terminal};
/// let outcome = Outcome::new("modes", "modes at rest").finding(Finding::info("f1", "The first mode turns at {}.").value(210.0, "rad/s"));
/// let report = Report { outcomes: vec![outcome], ..Report::default() };
/// assert_eq!(terminal(&report, Terminal::default()), "modes at rest\n  The first mode turns at 210 rad/s.\n");
/// ```
pub fn terminal(report: &Report, how: Terminal) -> String {
    let studies: Vec<String> = report.outcomes.iter().map(|o| study(o, &report.style, how)).collect();
    studies.join("\n")
}

fn study(o: &Outcome, style: &Style, how: Terminal) -> String {
    let paint = |text: &str, code: &str| if how.colour { format!("\x1b[{code}m{text}\x1b[0m") } else { text.to_string() };
    let mut out = format!("{}\n", paint(&plain::line(&o.name), "1"));
    if !o.end.is_complete() {
        wrap(&mut out, &paint("!", "33"), 1, &plain::line(&style.message(&o.end_message())), how.width);
    }
    let mut results = 0;
    for f in &o.findings {
        let (sign, length) = match f.level {
            Level::Info if results == MOST_RESULTS => continue,
            Level::Info => {
                results += 1;
                (String::new(), 0)
            }
            Level::Warning => (paint("!", "33"), 1),
            Level::Invalid => (paint("!!", "31"), 2),
        };
        let mut text = plain::line(&style.sentence(f)).into_owned();
        let first = f.evidence.first().map(|e| format!(" ({} {})", plain::line(&style.arg(&e.what)), style.number(e.value, &e.unit)));
        // evidence only where it is not said already and does not push the finding beyond two lines
        let said = f.evidence.first().is_some_and(|e| {
            let rounded = |digits| style.arg(&Arg::quantity(e.value, &e.unit).digits(digits));
            text.contains(&style.number(e.value, &e.unit)) || (3..=8).any(|digits| text.contains(&rounded(digits)))
        });
        if let Some(e) = first.filter(|e| !said && text.chars().count() + e.chars().count() < 2 * how.width.saturating_sub(8)) {
            match text.strip_suffix('.') {
                Some(open) => text = format!("{open}{e}."),
                None => text.push_str(&e),
            }
        }
        wrap(&mut out, &sign, length, &text, how.width);
    }
    let all = o.findings.iter().filter(|f| f.level == Level::Info).count();
    if all > results {
        let more = Message::new("page-more").arg("count", Arg::count(all - results));
        out.push_str(&format!("  {}\n", style.message(&more)));
    }
    if o.findings.is_empty() && o.end.is_complete() {
        out.push_str(&format!("  {}\n", style.message(&"page-nothing-to-report".into())));
    }
    out
}

fn wrap(out: &mut String, sign: &str, sign_length: usize, text: &str, width: usize) {
    let width = width.clamp(30, 120);
    let indent = if sign_length == 0 { 2 } else { 3 + sign_length };
    out.push_str("  ");
    if sign_length > 0 {
        out.push_str(sign);
        out.push(' ');
    }
    let mut column = indent;
    for (i, word) in text.split_whitespace().enumerate() {
        let length = word.chars().count();
        if i > 0 && column + 1 + length > width {
            out.push('\n');
            out.push_str(&" ".repeat(indent));
            column = indent;
        } else if i > 0 {
            out.push(' ');
            column += 1;
        }
        out.push_str(word);
        column += length;
    }
    out.push('\n');
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::outcome::{End, Finding};

    fn print(o: Outcome, how: Terminal) -> String {
        terminal(&Report { outcomes: vec![o], ..Report::default() }, how)
    }

    #[test]
    fn lines_fit_and_warnings_stand_out_without_colour() {
        let o = Outcome::new("k", "run up").over("speed", "rad/s").end(End::StepTooSmall { at: 512.0 }).finding(
            Finding::warning(
                "w",
                "The drum passes its critical speed at {} with an amplitude that is larger than the clearance of the casing.",
            )
            .value(314.159, "rad/s")
            .evidence("step error", 1e-9, "m"),
        );
        let text = print(o.clone(), Terminal { width: 60, colour: false });
        assert!(text.lines().all(|l| l.chars().count() <= 60), "{text}");
        assert_eq!(text.matches("  ! ").count(), 2);
        // evidence is left out where it would make a third line of it
        assert!(text.ends_with("casing.\n"), "{text}");
        assert!(!text.contains('\x1b'));
        assert!(print(o, Terminal { width: 60, colour: true }).contains("\x1b[33m!\x1b[0m"));
    }

    #[test]
    fn evidence_stands_inside_the_sentence() {
        let o = Outcome::new("k", "n").finding(Finding::info("p", "The peak is {}.").value(8.8e-4, "m").evidence("residual", 3e-9, "N"));
        assert_eq!(print(o, Terminal::default()), "n\n  The peak is 880 µm (residual 3·10⁻⁹ N).\n");
    }

    #[test]
    fn evidence_that_the_sentence_says_is_not_said_twice() {
        let o = Outcome::new("k", "n")
            .finding(Finding::info("p", "The peak is {}, at 512.473 rad/s.").value(8.8e-4, "m").evidence("speed", 512.4731, "rad/s"));
        assert_eq!(print(o, Terminal::default()), "n\n  The peak is 880 µm, at 512.473 rad/s.\n");
    }

    #[test]
    fn names_cannot_steer_the_terminal() {
        let said = Finding::info("i", "Body \"\u{1b}[31m\u{202e}\" is heavy.").evidence("of \u{9b}2J", 1.0, "kg");
        let text = print(Outcome::new("k", "a\x1b[2Jb\nc").finding(said), Terminal::default());
        assert_eq!(text, "a\\u001b[2Jb\\u000ac\n  Body \"\\u001b[31m\\u202e\" is heavy (of \\u009b2J 1 kg).\n");
    }

    #[test]
    fn many_results_are_cut_but_no_warning() {
        let mut o = Outcome::new("k", "n");
        for i in 0..30 {
            o = o.finding(Finding::info("i", "One.")).finding(if i == 29 {
                Finding::warning("w", "Look.")
            } else {
                Finding::info("j", "Two.")
            });
        }
        let text = print(o, Terminal::default());
        assert!(text.contains("! Look.") && text.contains("and 51 more"), "{text}");
    }
}
