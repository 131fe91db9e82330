//! The answer in the terminal: verdict, checks, a strip over the speed, at most three remarks, what to do next, in lines of 80 columns; with the name of the
//! report behind it some 25 of them.

use super::Report;
use super::first_page::{required, sentence, verdict};
use super::terminal::Terminal;
use super::words::Style;
use crate::outcome::{Arg, Check, End, Level, Message, OverSpeed, Overview, Verdict};
use crate::plain;

/// Lines of the summary that a terminal shows beside the names of the files written: for more, remarks and suggestions are left out. Nothing is cut.
const MOST_LINES: usize = 23;
/// Remarks below the strip, and suggestions.
const MOST_REMARKS: usize = 3;
const MOST_NEXT: usize = 2;
/// Most width of the columns of checks but for the result, which takes what is left.
const WHAT: usize = 23;
const REQUIRED: usize = 12;
/// Distance of columns.
const APART: usize = 2;

/// The summary; empty where the report has no first page.
pub fn summary(report: &Report, how: Terminal) -> String {
    let Some(page) = &report.overview else { return String::new() };
    let style = &report.style;
    let paint = |text: &str, code: &str| if how.colour { format!("\x1b[{code}m{text}\x1b[0m") } else { text.to_string() };
    let width = how.width.clamp(60, 100);
    let (sign, code) = sign(page.verdict);
    let texts: Vec<String> = page.headline.iter().map(|m| style.message(m)).collect();
    let headline: Vec<String> = wrapped(&plain::line(&texts.join(" ")), width - 2);
    let strip = page.over_speed.as_ref().map(|over| strip(page, over, style, width)).unwrap_or_default();
    let checks = Cells::of(&page.checks, style, width);
    let lines = |text: &str, width: usize| wrapped(&plain::line(text), width);
    let mut remarks: Vec<Vec<String>> = remarks(page, report).iter().take(MOST_REMARKS).map(|r| lines(r, width - 4)).collect();
    let mut next: Vec<Vec<String>> = page.next.iter().take(MOST_NEXT).map(|m| lines(&style.message(m), width - 2)).collect();
    let fixed = 1 + headline.len() + usize::from(!checks.is_empty()) + strip.len() + checks.iter().map(|c| c.rows.len()).sum::<usize>();
    let used = |blocks: [&[Vec<String>]; 2]| fixed + blocks.iter().map(|b| usize::from(!b.is_empty()) + b.concat().len()).sum::<usize>();
    while used([&remarks, &next]) > MOST_LINES && (next.len() > 1 || remarks.len() > 1) {
        if next.len() > 1 { &mut next } else { &mut remarks }.pop();
    }

    let mut out = vec![paint(&plain::line(&report.machine), "1")];
    out.extend(headline.iter().enumerate().map(|(k, line)| {
        let sign = if k == 0 { paint(sign, code) } else { " ".into() };
        format!("{sign} {}", paint(line, "1"))
    }));
    if !checks.is_empty() {
        out.push(String::new());
    }
    for (c, cells) in page.checks.iter().zip(&checks) {
        let verdict = paint(&cells.verdict, self::sign(c.verdict).1);
        out.extend(cells.rows.iter().enumerate().map(|(k, row)| if k == 0 { format!("{row}{verdict}") } else { row.clone() }));
    }
    out.extend(strip);
    for (block, mark) in [(&remarks, paint("!", "33")), (&next, ">".into())] {
        if !block.is_empty() {
            out.push(String::new());
        }
        for lines in block {
            out.extend(lines.iter().enumerate().map(|(k, line)| format!("{} {line}", if k == 0 { &mark } else { " " })));
        }
    }
    out.iter().map(|line| format!("{}\n", line.trim_end())).collect()
}

/// A check in lines: its name, what was found, what is required; the verdict goes behind the first.
struct Cells {
    rows: Vec<String>,
    verdict: String,
}

impl Cells {
    /// Columns are as wide as what stands in them, that of the results takes what is left.
    fn of(checks: &[Check], style: &Style, width: usize) -> Vec<Cells> {
        let what: Vec<Vec<String>> = checks.iter().map(|c| wrapped(&plain::line(&style.message(&c.what)), WHAT)).collect();
        let required: Vec<Vec<String>> = checks.iter().map(|c| wrapped(&plain::line(&required(style, c)), REQUIRED)).collect();
        let verdicts: Vec<String> = checks.iter().map(|c| plain::line(&verdict(style, c, true)).into_owned()).collect();
        let widest = |lines: &mut dyn Iterator<Item = &String>| lines.map(|l| length(l)).max().unwrap_or(0);
        let first = widest(&mut what.iter().flatten()) + APART;
        let third = widest(&mut required.iter().flatten()) + APART;
        let room = width.saturating_sub(2 + first + third + widest(&mut verdicts.iter()));
        let one = |(k, c): (usize, &Check)| {
            let result = wrapped(&plain::line(&style.message(&c.result)), room.saturating_sub(APART));
            let cell = |lines: &[String], k: usize, width: usize| pad(lines.get(k).map_or("", String::as_str), width);
            let row = |r: usize| format!("  {}{}{}", cell(&what[k], r, first), cell(&result, r, room), cell(&required[k], r, third));
            let height = what[k].len().max(result.len()).max(required[k].len());
            Cells { rows: (0..height).map(row).collect(), verdict: verdicts[k].clone() }
        };
        checks.iter().enumerate().map(one).collect()
    }
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

fn pad(text: &str, width: usize) -> String {
    format!("{text}{}", " ".repeat(width.saturating_sub(length(text))))
}

/// The range of speeds as one line: unstable ranges, resonances, jumps, the operating speed.
fn strip(page: &Overview, over: &OverSpeed, style: &Style, width: usize) -> Vec<String> {
    let unit = style.units.speed();
    let cells = width - 12;
    let (from, to) = over.shown;
    let place = |w: f64| ((w / from).ln() / (to / from).ln() * cells as f64).floor().clamp(0.0, cells as f64 - 1.0) as usize;
    let mut line = vec!['─'; cells];
    for w in over.resonances.iter().map(|r| r.speed) {
        line[place(w)] = '∧';
    }
    for (a, b) in &over.unstable_response {
        line[place(*a)..=place(*b)].fill('▒');
    }
    for u in &over.unstable {
        line[place(u.from)..=place(u.to)].fill('█');
    }
    for w in over.jumps.iter().filter(|w| (from..=to).contains(*w)) {
        line[place(*w)] = '↕';
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
    let row = |head: &str, line: String| format!("  {}{}", pad(head, 9), line.trim_end());
    let mut out = vec![String::new(), row(&name, labels.iter().collect()), row("", line.iter().collect())];
    let mut key = vec!["┃", "axis-operating"];
    if line.contains(&'█') {
        key.extend(["█", "strip-unstable"]);
    }
    if line.contains(&'▒') {
        key.extend(["▒", "strip-response"]);
    }
    if line.contains(&'↕') {
        key.extend(["↕", "strip-jump"]);
    }
    if line.contains(&'∧') {
        key.extend(["∧", "strip-resonance"]);
    }
    let words: Vec<String> = key.chunks(2).map(|k| format!("{} {}", k[0], style.message(&Message::new(k[1])))).collect();
    out.push(row("", words.join("   ")));
    out
}

/// What the checks do not say: unstable ranges first, then warnings of the studies.
fn remarks(page: &Overview, report: &Report) -> Vec<String> {
    let style = &report.style;
    let mut out: Vec<String> = Vec::new();
    let stopped = report.outcomes.iter().filter(|o| !matches!(o.end, End::Reached | End::Refused));
    out.extend(stopped.map(|o| format!("{}: {}", o.name, style.message(&o.end_message()))));
    // the headline names a single range that the run-up crosses
    let crossed = page.headline.iter().find(|m| m.arg_named("count") == Some(&Arg::Count(1))).and_then(|m| m.arg_named("from")).cloned();
    let said = |m: &Message| m.key == "remark-unstable" && crossed.is_some() && m.arg_named("from") == crossed.as_ref();
    let texts = page.remarks.iter().flat_map(|r| &r.1).filter(|m| m.key == "remark-unstable" || m.key == "remark-jump");
    let texts = texts.filter(|m| !said(m));
    out.extend(texts.map(|m| sentence(style, m)));
    // what the page says already
    const SAID: [&str; 8] =
        ["unstable", "unstable_mode", "unstable_range", "largest_growth", "margin", "stability_unknown", "not_balanced", "refused"];
    // what studies of parameters say of their own sampling is no news of the machine
    let machine = report.outcomes.iter().filter(|o| o.kind != "uncertainty" && o.kind != "sensitivity");
    // of balls the headline names the range without a stable state
    let slip = page.headline.iter().any(|m| m.key == "headline-slip");
    let known = |id: &str| SAID.contains(&id) || slip && id == "no_stable_state";
    let mut urgent: Vec<_> = machine.flat_map(|o| &o.findings).filter(|f| f.level > Level::Info && !known(&f.id)).collect();
    urgent.sort_by_key(|f| std::cmp::Reverse(f.level));
    for f in urgent {
        let text = style.sentence(f);
        if !out.contains(&text) {
            out.push(text);
        }
    }
    out
}
