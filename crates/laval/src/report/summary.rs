//! The answer in the terminal: verdict, checks, a strip over the speed, at most three remarks, what to do next, in 25 lines of 80 columns with
//! the name of the report behind it.

use super::Report;
use super::first_page::{required, sentence, verdict};
use super::terminal::Terminal;
use super::words::Style;
use crate::outcome::{Arg, Check, End, Level, Message, OverSpeed, Overview, Verdict};
use crate::plain;

/// Lines of the summary: of the 25 two are those of the files written.
const MOST_LINES: usize = 23;
/// Remarks below the strip, and suggestions.
const MOST_REMARKS: usize = 3;
const MOST_NEXT: usize = 2;
/// Remarks that come before the whole results of checks.
const FIRST: usize = 2;
/// Lines of a remark, and of the result of a check before remarks take room.
const LINES: usize = 2;
/// Widths of the columns of checks, the last takes what is left.
const WHAT: usize = 24;
const REQUIRED: usize = 11;
const VERDICT: usize = 11;

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
    let checks: Vec<Cells> = page.checks.iter().map(|c| Cells::new(c, style, width)).collect();
    let mut remarks: Vec<Lines> = remarks(page, report).iter().map(|r| Lines::new(wrapped(&plain::line(r), width - 4))).collect();
    remarks.truncate(MOST_REMARKS);
    let mut next: Vec<Lines> =
        page.next.iter().take(MOST_NEXT).map(|m| Lines::new(wrapped(&plain::line(&style.message(m)), width - 2))).collect();
    next.iter_mut().for_each(|n| n.shown = n.lines.len());

    // one line each, then a second line of the results of checks, the worst first, then more remarks and suggestions, then the whole results
    let fixed = 1 + headline.len() + usize::from(!checks.is_empty()) + strip.len();
    let used = |checks: &[Cells], remarks: &[Lines], next: &[Lines]| {
        let blocks = usize::from(!remarks.is_empty()) + usize::from(!next.is_empty());
        let lines = |l: &[Lines]| l.iter().map(|l| l.shown).sum::<usize>();
        fixed + blocks + checks.iter().map(Cells::height).sum::<usize>() + lines(remarks) + lines(next)
    };
    let mut checks = checks;
    let (mut more_remarks, mut more_next) = (remarks.split_off(remarks.len().min(FIRST)), next.split_off(next.len().min(1)));
    while used(&checks, &remarks, &next) > MOST_LINES && remarks.len() > 1 {
        remarks.pop();
        more_remarks.clear();
    }
    let mut order: Vec<usize> = (0..checks.len()).collect();
    order.sort_by_key(|&k| std::cmp::Reverse(page.checks[k].verdict));
    let lengthen = |checks: &mut [Cells], remarks: &[Lines], next: &[Lines], most: usize| {
        for &k in &order {
            let before = checks[k].result.grow(most);
            if used(checks, remarks, next) > MOST_LINES {
                checks[k].result.shown = before;
            }
        }
    };
    lengthen(&mut checks, &remarks, &next, LINES);
    for (all, more) in [(&mut remarks, &mut more_remarks), (&mut next, &mut more_next)] {
        all.append(more);
    }
    while used(&checks, &remarks, &next) > MOST_LINES && (next.len() > 1 || remarks.len() > 1) {
        if next.len() > 1 {
            next.pop();
        } else {
            remarks.pop();
        }
    }
    for k in 0..remarks.len() {
        let before = remarks[k].grow(LINES);
        if used(&checks, &remarks, &next) > MOST_LINES {
            remarks[k].shown = before;
        }
    }
    lengthen(&mut checks, &remarks, &next, usize::MAX);

    let mut out = vec![paint(&plain::line(&report.machine), "1")];
    out.extend(headline.iter().enumerate().map(|(k, line)| {
        let sign = if k == 0 { paint(sign, code) } else { " ".into() };
        format!("{sign} {}", paint(line, "1"))
    }));
    if !checks.is_empty() {
        out.push(String::new());
    }
    for (c, cells) in page.checks.iter().zip(&checks) {
        out.extend(cells.rows(&paint(&plain::line(&verdict(style, c, true)), self::sign(c.verdict).1)));
    }
    out.extend(strip);
    for (block, mark) in [(&remarks, paint("!", "33")), (&next, ">".into())] {
        if !block.is_empty() {
            out.push(String::new());
        }
        for text in block {
            let lines = text.cut();
            out.extend(lines.iter().enumerate().map(|(k, line)| format!("{} {line}", if k == 0 { &mark } else { " " })));
        }
    }
    out.iter().map(|line| format!("{}\n", line.trim_end())).collect()
}

/// A text in lines, of which the first are shown.
struct Lines {
    lines: Vec<String>,
    shown: usize,
}

impl Lines {
    fn new(lines: Vec<String>) -> Lines {
        let shown = lines.len().min(1);
        Lines { lines, shown }
    }

    /// Shows up to `most` lines; the number shown before.
    fn grow(&mut self, most: usize) -> usize {
        let before = self.shown;
        self.shown = self.lines.len().min(most).max(before);
        before
    }

    /// The lines shown, with a mark where some are left out.
    fn cut(&self) -> Vec<String> {
        let mut out: Vec<String> = self.lines.iter().take(self.shown).cloned().collect();
        if let Some(last) = out.last_mut().filter(|_| self.shown < self.lines.len()) {
            last.push_str(" …");
        }
        out
    }
}

/// A check: its name, what was found, what is required.
struct Cells {
    what: Vec<String>,
    result: Lines,
    required: Vec<String>,
    room: usize,
}

impl Cells {
    fn new(c: &Check, style: &Style, width: usize) -> Cells {
        let room = width - WHAT - REQUIRED - VERDICT - 2;
        Cells {
            what: wrapped(&plain::line(&style.message(&c.what)), WHAT - 1),
            result: Lines::new(wrapped(&plain::line(&style.message(&c.result)), room - 3)),
            required: wrapped(&plain::line(&required(style, c)), REQUIRED - 1),
            room,
        }
    }

    fn height(&self) -> usize {
        self.what.len().max(self.result.shown).max(self.required.len())
    }

    /// The lines of the table, the verdict behind the first.
    fn rows(&self, verdict: &str) -> Vec<String> {
        let result = self.result.cut();
        let cell = |lines: &[String], k: usize, width: usize| pad(lines.get(k).map_or("", String::as_str), width);
        let row = |k: usize| {
            let last = if k == 0 { verdict } else { "" };
            format!("  {}{}{}{last}", cell(&self.what, k, WHAT), cell(&result, k, self.room), cell(&self.required, k, REQUIRED))
        };
        (0..self.height()).map(row).collect()
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
    // where stability was not examined nothing is claimed
    if let Some((low, high)) = over.examined {
        let unknown = (0..cells).filter(|k| *k < place(low) && from < low || *k > place(high) && high < to);
        unknown.for_each(|k| line[k] = '·');
    }
    for (a, b) in &over.unstable_response {
        line[place(*a)..=place(*b)].fill('▒');
    }
    for u in &over.unstable {
        line[place(u.from)..=place(u.to)].fill('█');
    }
    // a resonance in an unstable range or at its edge is no less one
    for w in over.resonances.iter().map(|r| r.speed).filter(|w| (from..=to).contains(w)) {
        line[place(w)] = '∧';
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
    if line.contains(&'·') {
        key.extend(["·", "strip-not-examined"]);
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
    // closer together where that keeps them on one line
    let between = if length(&words.join("   ")) <= cells { "   " } else { "  " };
    let mut line = String::new();
    for word in words {
        if !line.is_empty() && length(&line) + between.len() + length(&word) > cells {
            out.push(row("", std::mem::take(&mut line)));
        }
        if !line.is_empty() {
            line.push_str(between);
        }
        line.push_str(&word);
    }
    out.push(row("", line));
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
