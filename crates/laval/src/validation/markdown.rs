//! The part of Markdown that cases are written in: headings, paragraphs, lists, tables, fenced code; code, bold, emphasis and links
//! inside a line.

use crate::diagnostic::Span;
use crate::report::escape;
use std::fmt::Write;

/// A piece of a document and its place in it.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    pub span: Span,
    pub kind: Kind,
}

#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    /// Level and text.
    Heading(usize, String),
    Paragraph(String),
    List {
        ordered: bool,
        items: Vec<String>,
    },
    Table(Grid),
    /// Words behind the fence, and the place of the code itself.
    Code {
        info: String,
        code: Span,
    },
}

/// A table as text.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Grid {
    pub head: Vec<Cell>,
    pub rows: Vec<Vec<Cell>>,
}

/// A cell and its place in the document.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cell {
    pub text: String,
    pub span: Span,
}

struct Line<'a> {
    start: usize,
    text: &'a str,
}

/// Cuts a document into blocks. An open fence runs to the end.
pub fn blocks(text: &str) -> Vec<Block> {
    let mut start = 0;
    let lines: Vec<Line> = text
        .split_inclusive('\n')
        .map(|l| {
            let line = Line { start, text: l.trim_end() };
            start += l.len();
            line
        })
        .collect();
    let mut out = Vec::new();
    let mut i = 0;
    while i < lines.len() {
        let line = &lines[i];
        let from = i;
        let kind = if line.text.is_empty() {
            i += 1;
            continue;
        } else if let Some(info) = line.text.strip_prefix("```") {
            i += 1;
            let code = lines.get(i).map_or(text.len(), |l| l.start);
            while i < lines.len() && !lines[i].text.starts_with("```") {
                i += 1;
            }
            let end = lines.get(i).map_or(text.len(), |l| l.start);
            i += 1;
            Kind::Code { info: info.trim().to_string(), code: code..end.max(code) }
        } else if let Some((level, title)) = heading(line.text) {
            i += 1;
            Kind::Heading(level, title.to_string())
        } else if line.text.starts_with('|') && lines.get(i + 1).is_some_and(|l| is_rule(l.text)) {
            let head = cells(line);
            i += 2;
            let mut rows = Vec::new();
            while i < lines.len() && lines[i].text.starts_with('|') {
                rows.push(cells(&lines[i]));
                i += 1;
            }
            Kind::Table(Grid { head, rows })
        } else if let Some((ordered, _)) = item(line.text) {
            let mut items: Vec<String> = Vec::new();
            while i < lines.len() && !lines[i].text.is_empty() {
                match item(lines[i].text) {
                    Some((_, text)) => items.push(text.to_string()),
                    None if starts_block(lines[i].text) => break,
                    None => join(items.last_mut(), lines[i].text),
                }
                i += 1;
            }
            Kind::List { ordered, items }
        } else {
            let mut words = line.text.trim().to_string();
            i += 1;
            while i < lines.len() && !lines[i].text.is_empty() && !starts_block(lines[i].text) {
                join(Some(&mut words), lines[i].text);
                i += 1;
            }
            Kind::Paragraph(words)
        };
        let end = lines.get(i).map_or(text.len(), |l| l.start);
        out.push(Block { span: lines[from].start..end, kind });
    }
    out
}

fn join(to: Option<&mut String>, line: &str) {
    if let Some(to) = to {
        to.push(' ');
        to.push_str(line.trim());
    }
}

fn heading(line: &str) -> Option<(usize, &str)> {
    let level = line.len() - line.trim_start_matches('#').len();
    let title = line.get(level..)?.strip_prefix(' ')?;
    (1..=6).contains(&level).then_some((level, title.trim()))
}

fn item(line: &str) -> Option<(bool, &str)> {
    if let Some(text) = line.strip_prefix("- ").or_else(|| line.strip_prefix("* ")) {
        return Some((false, text.trim()));
    }
    let digits = line.len() - line.trim_start_matches(|c: char| c.is_ascii_digit()).len();
    let text = line.get(digits..)?.strip_prefix(". ")?;
    (digits > 0).then_some((true, text.trim()))
}

fn starts_block(line: &str) -> bool {
    line.starts_with("```") || line.starts_with('|') || heading(line).is_some() || item(line).is_some()
}

fn is_rule(line: &str) -> bool {
    line.starts_with('|') && line.contains('-') && line.chars().all(|c| matches!(c, '|' | '-' | ':' | ' '))
}

/// Cells between bars; `\|` is a bar inside a cell.
fn cells(line: &Line) -> Vec<Cell> {
    let mut out = Vec::new();
    let mut from = 1;
    let bytes = line.text.as_bytes();
    let mut push = |from: usize, to: usize| {
        let raw = &line.text[from..to];
        let lead = raw.len() - raw.trim_start().len();
        let text = raw.trim();
        let start = line.start + from + lead;
        out.push(Cell { text: text.replace("\\|", "|"), span: start..start + text.len() });
    };
    for i in 1..bytes.len() {
        if bytes[i] == b'|' && bytes[i - 1] != b'\\' {
            push(from, i);
            from = i + 1;
        }
    }
    if from < bytes.len() {
        push(from, bytes.len());
    }
    out
}

/// A block as HTML; `text` is the document.
pub fn html(block: &Block, text: &str) -> String {
    let mut s = String::new();
    match &block.kind {
        Kind::Heading(level, title) => {
            let _ = writeln!(s, "<h{level}>{}</h{level}>", inline(title));
        }
        Kind::Paragraph(words) => {
            let _ = writeln!(s, "<p>{}</p>", inline(words));
        }
        Kind::List { ordered, items } => {
            let tag = if *ordered { "ol" } else { "ul" };
            let items: String = items.iter().map(|i| format!("<li>{}</li>", inline(i))).collect();
            let _ = writeln!(s, "<{tag}>{items}</{tag}>");
        }
        Kind::Table(grid) => {
            let row = |cells: &[Cell], tag: &str| {
                cells.iter().map(|c| format!("<{tag} class=\"w\">{}</{tag}>", inline(&c.text))).collect::<String>()
            };
            s.push_str("<div class=\"scroll\" tabindex=\"0\"><table>");
            if grid.head.iter().any(|c| !c.text.is_empty()) {
                let _ = write!(s, "<thead><tr>{}</tr></thead>", row(&grid.head, "th"));
            }
            let body: String = grid.rows.iter().map(|r| format!("<tr>{}</tr>", row(r, "td"))).collect();
            let _ = writeln!(s, "<tbody>{body}</tbody></table></div>");
        }
        Kind::Code { code, .. } => {
            let _ = writeln!(s, "<pre tabindex=\"0\">{}</pre>", escape(&text[code.clone()]));
        }
    }
    s
}

/// The inside of a line as HTML.
pub fn inline(text: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    while let Some(at) = rest.find(['`', '*', '[']) {
        out.push_str(&escape(&rest[..at]));
        rest = &rest[at..];
        let (html, used) = marked(rest).unwrap_or_else(|| (escape(&rest[..1]), 1));
        out.push_str(&html);
        rest = &rest[used..];
    }
    out + &escape(rest)
}

/// The marked piece a text begins with, and its length.
fn marked(text: &str) -> Option<(String, usize)> {
    for (mark, tag) in [("`", "code"), ("**", "strong"), ("*", "em")] {
        if let Some(inner) = text.strip_prefix(mark) {
            let end = inner.find(mark).filter(|&n| n > 0 && !inner.starts_with(' '))?;
            let content = if tag == "code" { escape(&inner[..end]) } else { inline(&inner[..end]) };
            return Some((format!("<{tag}>{content}</{tag}>"), end + 2 * mark.len()));
        }
    }
    let inner = text.strip_prefix('[')?;
    let (words, behind) = inner.split_once("](")?;
    let (target, _) = behind.split_once(')')?;
    if words.contains('[') {
        return None;
    }
    let web = target.starts_with("https://") || target.starts_with("http://");
    let target_html = if web { target.to_string() } else { gallery_page(target)? };
    Some((format!("<a href=\"{}\">{}</a>", escape(&target_html), inline(words)), words.len() + target.len() + 4))
}

/// The page of the gallery that shows the document `../topic/case.md`.
fn gallery_page(target: &str) -> Option<String> {
    let (topic, case) = target.strip_prefix("../")?.strip_suffix(".md")?.split_once('/')?;
    let plain = |t: &str| !t.is_empty() && t.chars().all(|c| c.is_ascii_alphanumeric() || c == '-');
    (plain(topic) && plain(case)).then(|| format!("{topic}-{case}.html"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_and_their_places() {
        let text =
            "# T\n\nOne\ntwo.\n\n- a\n  b\n- c\n\n```toml machine\nx = 1\n\n# no heading\n```\n| a | b |\n|---|---|\n| 1 \\| 2 | 3 |\n";
        let b = blocks(text);
        assert_eq!(b.len(), 5);
        assert_eq!(b[0].kind, Kind::Heading(1, "T".into()));
        assert_eq!(b[1].kind, Kind::Paragraph("One two.".into()));
        assert_eq!(b[2].kind, Kind::List { ordered: false, items: vec!["a b".into(), "c".into()] });
        let Kind::Code { info, code } = &b[3].kind else { panic!("{:?}", b[3]) };
        assert_eq!((info.as_str(), &text[code.clone()]), ("toml machine", "x = 1\n\n# no heading\n"));
        let Kind::Table(grid) = &b[4].kind else { panic!("{:?}", b[4]) };
        assert_eq!(grid.rows[0].iter().map(|c| c.text.as_str()).collect::<Vec<_>>(), ["1 | 2", "3"]);
        assert_eq!(&text[grid.rows[0][1].span.clone()], "3");
    }

    #[test]
    fn an_open_fence_ends_with_the_document() {
        let b = blocks("```\nx");
        assert_eq!(b[0].kind, Kind::Code { info: String::new(), code: 4..5 });
        assert_eq!(blocks("```")[0].kind, Kind::Code { info: String::new(), code: 3..3 });
    }

    #[test]
    fn inside_a_line() {
        assert_eq!(inline("a `<b>*` **c** *d* e*f"), "a <code>&lt;b&gt;*</code> <strong>c</strong> <em>d</em> e*f");
        assert_eq!(inline("[x](https://e.org/?a&b) [y](javascript:z)"), "<a href=\"https://e.org/?a&amp;b\">x</a> [y](javascript:z)");
        assert_eq!(inline("[x](../a/b-1.md) [y](../a/../b.md)"), "<a href=\"a-b-1.html\">x</a> [y](../a/../b.md)");
        assert_eq!(inline("2 * 3 * 4 ` µ"), "2 * 3 * 4 ` µ");
    }
}
