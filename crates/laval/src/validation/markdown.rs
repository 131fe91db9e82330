//! The blocks of a document in Markdown with their places, and blocks and lines as HTML.

use crate::diagnostic::Span;
use pulldown_cmark::{CodeBlockKind, CowStr, Event, Options, Parser, Tag, TagEnd, html::push_html};

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

fn parser(text: &str) -> Parser<'_> {
    Parser::new_ext(text, Options::ENABLE_TABLES)
}

/// Cuts a document into its outermost blocks.
pub fn blocks(text: &str) -> Vec<Block> {
    let mut out = Vec::new();
    let mut events = parser(text).into_offset_iter();
    while let Some((event, span)) = events.next() {
        let Event::Start(tag) = event else { continue };
        let inner = inside(&mut events);
        let kind = match tag {
            Tag::Heading { level, .. } => Kind::Heading(level as usize, words(text, &inner)),
            Tag::List(first) => {
                Kind::List { ordered: first.is_some(), items: parts(&inner, &TagEnd::Item).map(|(i, _)| words(text, i)).collect() }
            }
            Tag::Table(_) => Kind::Table(grid(text, &inner)),
            Tag::CodeBlock(fence) => {
                let info = if let CodeBlockKind::Fenced(info) = fence { info.trim().to_string() } else { String::new() };
                Kind::Code { info, code: extent(&inner).unwrap_or(span.end..span.end) }
            }
            _ => Kind::Paragraph(words(text, &inner)),
        };
        out.push(Block { span, kind });
    }
    out
}

type Placed<'a> = (Event<'a>, Span);

/// What follows the start of an element up to its end.
fn inside<'a>(events: &mut impl Iterator<Item = Placed<'a>>) -> Vec<Placed<'a>> {
    let mut depth = 1;
    let open = |e: &Placed| {
        match e.0 {
            Event::Start(_) => depth += 1,
            Event::End(_) => depth -= 1,
            _ => {}
        }
        depth > 0
    };
    events.take_while(open).collect()
}

/// The elements of one kind, without their own start and end, and the place of each.
fn parts<'e, 'a>(events: &'e [Placed<'a>], end: &TagEnd) -> impl Iterator<Item = (&'e [Placed<'a>], &'e Span)> {
    let is_end = move |e: &Placed| matches!(&e.0, Event::End(t) if t == end);
    events.split_inclusive(is_end).filter_map(move |p| {
        let (last, p) = p.split_last().filter(|(last, _)| is_end(last))?;
        let start = p.iter().position(|e| matches!(&e.0, Event::Start(t) if t.to_end() == *end)).map_or(0, |i| i + 1);
        Some((&p[start..], &last.1))
    })
}

/// From the first to the last event.
fn extent(events: &[Placed]) -> Option<Span> {
    let start = events.iter().map(|e| e.1.start).min()?;
    Some(start..events.iter().map(|e| e.1.end).max()?)
}

/// The source of some events in one line.
fn words(text: &str, events: &[Placed]) -> String {
    extent(events).map_or(String::new(), |s| text[s].lines().map(str::trim).collect::<Vec<_>>().join(" ").trim().to_string())
}

fn grid(text: &str, events: &[Placed]) -> Grid {
    let row = |(events, _): (&[Placed], &Span)| parts(events, &TagEnd::TableCell).map(|(c, place)| cell(text, c, place)).collect();
    Grid {
        head: parts(events, &TagEnd::TableHead).next().map(row).unwrap_or_default(),
        rows: parts(events, &TagEnd::TableRow).map(row).collect(),
    }
}

/// A cell; `\\|` in it stands for a bar.
fn cell(text: &str, events: &[Placed], place: &Span) -> Cell {
    let span = extent(events).unwrap_or(place.start..place.start);
    Cell { text: text[span.clone()].replace("\\|", "|"), span }
}

/// A block as HTML; `text` is the document.
pub fn html(block: &Block, text: &str) -> String {
    let mut out = String::new();
    push_html(&mut out, parser(&text[block.span.clone()]).map(ours));
    out
}

/// The inside of a line as HTML.
pub fn inline(text: &str) -> String {
    let mut out = String::new();
    let paragraph = |e: &Event| !matches!(e, Event::Start(Tag::Paragraph) | Event::End(TagEnd::Paragraph));
    push_html(&mut out, parser(text).filter(paragraph).map(ours));
    out
}

/// HTML of a document is shown as text, links lead to the web or to a page of the gallery, and what may be wide scrolls.
fn ours(event: Event) -> Event {
    let raw = |s: &'static str| Event::Html(CowStr::Borrowed(s));
    match event {
        Event::Html(t) | Event::InlineHtml(t) => Event::Text(t),
        Event::Start(Tag::Link { link_type, dest_url, title, id }) => {
            let web = dest_url.starts_with("https://") || dest_url.starts_with("http://");
            let dest_url = if web { dest_url } else { gallery_page(&dest_url).unwrap_or_else(|| "#".into()).into() };
            Event::Start(Tag::Link { link_type, dest_url, title, id })
        }
        Event::Start(Tag::Table(_)) => raw("<div class=\"scroll\" tabindex=\"0\"><table class=\"words\">"),
        Event::End(TagEnd::Table) => raw("</tbody></table></div>\n"),
        Event::Start(Tag::CodeBlock(_)) => raw("<pre tabindex=\"0\">"),
        Event::End(TagEnd::CodeBlock) => raw("</pre>\n"),
        other => other,
    }
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
        assert_eq!(inline("[x](https://e.org/?a&b) [y](javascript:z)"), "<a href=\"https://e.org/?a&amp;b\">x</a> <a href=\"#\">y</a>");
        assert_eq!(inline("[x](../a/b-1.md) [y](../a/../b.md)"), "<a href=\"a-b-1.html\">x</a> <a href=\"#\">y</a>");
        assert_eq!(inline("2 * 3 * 4 ` µ"), "2 * 3 * 4 ` µ");
    }
}
