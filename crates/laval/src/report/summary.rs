//! The answer in the terminal: verdict, checks, a strip over the speed, at most three remarks, what to do next, in 25 lines of 80 columns with
//! the name of the report behind it.

use super::Report;
use super::first_page::{required, sentence, verdict};
use super::terminal::Terminal;
use super::words::Style;
use crate::outcome::{Check, End, Level, Message, OverSpeed, Overview, Verdict};
use crate::plain;

/// Lines of the summary: of the 25 two are those of the files written.
const MOST_LINES: usize = 23;

/// How much room each kind of line has.
struct Room {
    /// Lines of the result of a check.
    result: usize,
    /// Remarks below the strip, and lines of each.
    remarks: (usize, usize),
    /// Suggestions.
    next: usize,
}

/// From generous to narrow: the first that fits is taken.
const ROOMS: [Room; 6] = [
    Room { result: 2, remarks: (3, 2), next: 2 },
    Room { result: 2, remarks: (3, 1), next: 2 },
    Room { result: 2, remarks: (3, 1), next: 1 },
    Room { result: 1, remarks: (3, 1), next: 1 },
    Room { result: 1, remarks: (2, 1), next: 1 },
    Room { result: 1, remarks: (1, 1), next: 1 },
];
/// Widths of the columns of checks, the last takes what is left.
const WHAT: usize = 24;
const REQUIRED: usize = 11;
const VERDICT: usize = 10;

/// The summary; empty where the report has no first page.
pub fn summary(report: &Report, how: Terminal) -> String {
    let Some(page) = &report.overview else { return String::new() };
    let texts = ROOMS.iter().map(|room| within(report, page, how, room));
    let mut last = String::new();
    for text in texts {
        last = text;
        if last.lines().count() <= MOST_LINES {
            break;
        }
    }
    last
}

fn within(report: &Report, page: &Overview, how: Terminal, room: &Room) -> String {
    let style = &report.style;
    let paint = |text: &str, code: &str| if how.colour { format!("\x1b[{code}m{text}\x1b[0m") } else { text.to_string() };
    let width = how.width.clamp(60, 100);
    let (sign, code) = sign(page.verdict);
    let headline: Vec<String> = page.headline.iter().map(|m| style.message(m)).collect();
    let mut out = format!("{}\n\n", paint(&plain::line(&report.machine), "1"));
    for (k, line) in wrapped(&plain::line(&headline.join(" ")), width - 2).into_iter().enumerate() {
        out.push_str(&format!("{} {}\n", if k == 0 { paint(sign, code) } else { " ".into() }, paint(&line, "1")));
    }
    if !page.checks.is_empty() {
        out.push('\n');
        for c in &page.checks {
            check(&mut out, c, style, width, room.result, &paint);
        }
    }
    if let Some(over) = &page.over_speed {
        strip(&mut out, page, over, style, width);
    }
    let mut remarks = remarks(page, report);
    remarks.truncate(room.remarks.0);
    if !remarks.is_empty() {
        out.push('\n');
    }
    for r in remarks {
        for (k, line) in cut(wrapped(&plain::line(&r), width - 4), room.remarks.1).into_iter().enumerate() {
            out.push_str(&format!("{} {line}\n", if k == 0 { paint("!", "33") } else { " ".into() }));
        }
    }
    if !page.next.is_empty() {
        out.push('\n');
    }
    for m in page.next.iter().take(room.next) {
        for (k, line) in wrapped(&plain::line(&style.message(m)), width - 2).into_iter().enumerate() {
            out.push_str(&format!("{} {line}\n", if k == 0 { ">" } else { " " }));
        }
    }
    out
}

fn sign(verdict: Verdict) -> (&'static str, &'static str) {
    match verdict {
        Verdict::Passed => ("✓", "32"),
        Verdict::Attention => ("▲", "33"),
        Verdict::Failed => ("✗", "31"),
        Verdict::NoLimit | Verdict::NotComputed => ("–", "2"),
    }
}

fn length(text: &str) -> usize {
    text.chars().count()
}

/// Lines no longer than `width`.
fn wrapped(text: &str, width: usize) -> Vec<String> {
    let mut out = vec![String::new()];
    for word in text.split(' ').filter(|w| !w.is_empty()) {
        let last = out.len() - 1;
        let line = &mut out[last];
        if !line.is_empty() && length(line) + 1 + length(word) > width {
            out.push(word.into());
        } else {
            if !line.is_empty() {
                line.push(' ');
            }
            line.push_str(word);
        }
    }
    out
}

/// The first lines, with a mark where some are left out.
fn cut(mut lines: Vec<String>, most: usize) -> Vec<String> {
    if lines.len() > most {
        lines.truncate(most);
        lines[most - 1].push_str(" …");
    }
    lines
}

fn pad(text: &str, width: usize) -> String {
    format!("{text}{}", " ".repeat(width.saturating_sub(length(text))))
}

fn check(out: &mut String, c: &Check, style: &Style, width: usize, lines: usize, paint: &dyn Fn(&str, &str) -> String) {
    let room = width - WHAT - REQUIRED - VERDICT - 2;
    let what = wrapped(&plain::line(&style.message(&c.what)), WHAT - 1);
    let result = cut(wrapped(&plain::line(&style.message(&c.result)), room - 3), lines);
    let required = wrapped(&plain::line(&required(style, c)), REQUIRED - 1);
    let verdict = plain::line(&verdict(style, c, true)).into_owned();
    let cell = |lines: &[String], k: usize| lines.get(k).cloned().unwrap_or_default();
    for k in 0..what.len().max(result.len()).max(required.len()) {
        let last = if k == 0 { paint(&verdict, sign(c.verdict).1) } else { String::new() };
        let line = format!("  {}{}{}{last}", pad(&cell(&what, k), WHAT), pad(&cell(&result, k), room), pad(&cell(&required, k), REQUIRED));
        out.push_str(line.trim_end());
        out.push('\n');
    }
}

/// The range of speeds as one line: unstable ranges, resonances, jumps, the operating speed.
fn strip(out: &mut String, page: &Overview, over: &OverSpeed, style: &Style, width: usize) {
    let unit = style.units.speed();
    let cells = width - 12;
    let (from, to) = over.shown;
    let place = |w: f64| ((w / from).ln() / (to / from).ln() * cells as f64).floor().clamp(0.0, cells as f64 - 1.0) as usize;
    let mut line = vec!['─'; cells];
    for w in over.resonances.iter().map(|r| r.speed) {
        line[place(w)] = '∧';
    }
    for u in &over.unstable {
        line[place(u.from)..=place(u.to)].fill('█');
    }
    if let Some((a, b)) = page.operating_range {
        line[place(a)..=place(b)].iter_mut().filter(|c| **c == '─').for_each(|c| *c = '━');
        for w in [a, b] {
            line[place(w)] = '┃';
        }
    }
    if let Some(w) = page.operating.filter(|w| (from..=to).contains(w)) {
        line[place(w)] = '┃';
    }
    let mut labels = vec![' '; cells];
    let (low, high) = (from / unit.size, to / unit.size);
    let first = low.log10().floor() as i32;
    let ticks = (first..first + 12).flat_map(|e| [1.0, 2.0, 5.0].map(|m| m * 10f64.powi(e)));
    let mut end = 0;
    for t in ticks.filter(|t| (low..=high).contains(t)) {
        let text: Vec<char> = style.language.number(&crate::outcome::significant(t, 2)).chars().collect();
        let at = place(t * unit.size);
        if at >= end && at + text.len() <= cells {
            labels[at..at + text.len()].copy_from_slice(&text);
            end = at + text.len() + 2;
        }
    }
    let name = style.language.unit(&unit.name);
    out.push_str(&format!("\n  {}{}\n", pad(&name, 9), labels.iter().collect::<String>().trim_end()));
    out.push_str(&format!("  {}{}\n", pad("", 9), line.iter().collect::<String>()));
    let mut key = vec!["┃", "axis-operating"];
    if line.contains(&'█') {
        key.extend(["█", "strip-unstable"]);
    }
    if line.contains(&'∧') {
        key.extend(["∧", "strip-resonance"]);
    }
    let words: Vec<String> = key.chunks(2).map(|k| format!("{} {}", k[0], style.message(&Message::new(k[1])))).collect();
    out.push_str(&format!("  {}{}\n", pad("", 9), words.join("   ")));
}

/// What the checks do not say: unstable ranges first, then warnings of the studies.
fn remarks(page: &Overview, report: &Report) -> Vec<String> {
    let style = &report.style;
    let mut out: Vec<String> = Vec::new();
    let stopped = report.outcomes.iter().filter(|o| !matches!(o.end, End::Reached | End::Refused));
    out.extend(stopped.map(|o| format!("{}: {}", o.name, style.message(&o.end_message()))));
    let texts = page.remarks.iter().flat_map(|r| &r.1).filter(|m| m.key == "remark-unstable" || m.key == "remark-jump");
    out.extend(texts.map(|m| sentence(style, m)));
    // what the page says already
    const SAID: [&str; 8] =
        ["unstable", "unstable_mode", "unstable_range", "largest_growth", "margin", "stability_unknown", "not_balanced", "refused"];
    // what studies of parameters say of their own sampling is no news of the machine
    let machine = report.outcomes.iter().filter(|o| o.kind != "uncertainty" && o.kind != "sensitivity");
    let mut urgent: Vec<_> =
        machine.flat_map(|o| &o.findings).filter(|f| f.level > Level::Info && !SAID.contains(&f.id.as_str())).collect();
    urgent.sort_by_key(|f| std::cmp::Reverse(f.level));
    for f in urgent {
        let text = style.sentence(f);
        if !out.contains(&text) {
            out.push(text);
        }
    }
    out
}
