//! A case as it stands in its document.

use super::markdown::{Block, Kind, blocks};
use super::table::{Expectation, Row};
use crate::diagnostic::{Diagnostic, Diagnostics, Span};
use crate::text;
use crate::text::Text;

/// What kind of evidence the expected numbers are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EvidenceKind {
    /// A formula.
    ClosedForm,
    /// Numbers printed in the source.
    PrintedTable,
    /// Numbers read off a curve.
    ReadFromFigure,
    /// Numbers of another program.
    OtherProgram,
    /// Measurements.
    Experiment,
}

impl EvidenceKind {
    const ALL: [EvidenceKind; 5] = [Self::ClosedForm, Self::PrintedTable, Self::ReadFromFigure, Self::OtherProgram, Self::Experiment];
    /// The word in the document.
    pub fn word(self) -> &'static str {
        match self {
            Self::ClosedForm => "closed form",
            Self::PrintedTable => "printed table",
            Self::ReadFromFigure => "read from figure",
            Self::OtherProgram => "other program",
            Self::Experiment => "experiment",
        }
    }
}

/// Verdict of a case.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verdict {
    /// Every number is within its tolerance.
    Agrees,
    /// Some are outside, but inside the scatter of the source.
    WithinScatter,
    /// Some differ, and the document says why.
    Explained,
    /// Some differ, and nobody knows why.
    Open,
}

impl Verdict {
    /// All of them, the best first.
    pub const ALL: [Verdict; 4] = [Self::Agrees, Self::WithinScatter, Self::Explained, Self::Open];
    /// The words in the document.
    pub fn words(self) -> &'static str {
        match self {
            Self::Agrees => "agrees",
            Self::WithinScatter => "within source scatter",
            Self::Explained => "differs (explained)",
            Self::Open => "open",
        }
    }
}

/// A machine of a case.
#[derive(Clone, Debug, PartialEq)]
pub struct MachineText {
    /// A complete machine file.
    pub text: String,
    /// Its place in the document.
    pub span: Span,
}

/// A case that has been read.
#[derive(Clone, Debug)]
pub struct Case {
    /// `topic/case`: folder and file without extension.
    pub id: String,
    /// Title of the page.
    pub title: String,
    /// What is required.
    pub requirement: String,
    /// Where the numbers come from.
    pub source: String,
    /// What kind of evidence they are.
    pub evidence: EvidenceKind,
    /// The verdict the document states.
    pub verdict: Verdict,
    /// The machines; names of studies are unique among them.
    pub machines: Vec<MachineText>,
    /// The expected values.
    pub expected: Vec<Expectation>,
    /// The document says why numbers differ.
    pub explained: bool,
    /// The document.
    pub text: String,
    pub(super) blocks: Vec<Block>,
    /// The block that holds the expected values.
    pub(super) expected_block: usize,
    /// The block that holds requirement, source, evidence and verdict.
    pub(super) facts_block: usize,
}

/// Heading of the explanation.
const WHY: &str = "Why it differs";

impl Case {
    /// The folder.
    pub fn topic(&self) -> &str {
        self.id.split_once('/').map_or("", |(topic, _)| topic)
    }

    /// Reads a document.
    ///
    /// # Errors
    /// All that is missing or wrong, each at its place.
    pub fn parse(id: &str, text: &str) -> Result<Case, Diagnostics> {
        let mut out = Diagnostics::default();
        let blocks = blocks(text);
        let wrong = |message: Text| Diagnostic::error("validation.document", message);
        let title = blocks.iter().find_map(|b| match &b.kind {
            Kind::Heading(1, t) => Some(t.clone()),
            _ => None,
        });
        if title.is_none() {
            out.push(wrong(text!("the page has no title")).help(text!("begin with # and the title")));
        }
        let facts = facts(&blocks, &mut out);
        for name in ["Symbols", "Machine", "Expected", "Tolerance"] {
            match section(&blocks, name) {
                None => out.push(wrong(text!("the page has no section \"{name}\"", name)).help(text!("add ## {name}", name))),
                Some([]) => out.push(wrong(text!("the section \"{name}\" is empty", name))),
                Some(_) => {}
            }
        }
        let machines: Vec<MachineText> = blocks
            .iter()
            .filter_map(|b| match &b.kind {
                Kind::Code { info, code } if info.split_whitespace().eq(["toml", "machine"]) => {
                    Some(MachineText { text: text[code.clone()].to_string(), span: code.clone() })
                }
                _ => None,
            })
            .collect();
        if machines.is_empty() {
            out.push(wrong(text!("the page has no machine")).help(text!("put a machine file between ```toml machine and ```")));
        }
        let in_section = section(&blocks, "Expected").and_then(|s| {
            s.iter().find_map(|b| match &b.kind {
                Kind::Table(grid) => Some((b, grid)),
                _ => None,
            })
        });
        let mut expected = Vec::new();
        let mut expected_block = 0;
        if let Some((block, grid)) = in_section {
            let before = out.0.len();
            expected = Expectation::read(grid, &mut out);
            expected_block = blocks.iter().position(|b| std::ptr::eq(b, block)).unwrap_or(0);
            if expected.is_empty() && out.0.len() == before {
                out.push(wrong(text!("no value is expected")).at(block.span.clone()));
            }
        } else {
            out.push(wrong(text!("the section \"Expected\" has no table")));
        }
        let explained = section(&blocks, WHY).is_some_and(|s| s.iter().any(|b| matches!(b.kind, Kind::Paragraph(_) | Kind::List { .. })));
        match (title, facts) {
            (Some(title), Some(f)) if !out.has_errors() => {
                let worst = expected.iter().map(|e| e.stated).max().unwrap_or(Row::Differs);
                let follows = verdict(worst, explained);
                if follows != f.verdict {
                    let (stated, follows) = (f.verdict.words(), follows.words());
                    let message = match explained {
                        true => text!("the page states \"{stated}\", but its rows make it \"{follows}\"", stated, follows),
                        false => text!(
                            "the page states \"{stated}\", but its rows without an explanation make it \"{follows}\"",
                            stated,
                            follows
                        ),
                    };
                    out.push(wrong(message).at(f.verdict_span).help(text!("an explanation stands under ## {title}", title = WHY)));
                    return Err(out);
                }
                Ok(Case {
                    id: id.into(),
                    title,
                    requirement: f.requirement,
                    source: f.source,
                    evidence: f.evidence,
                    verdict: f.verdict,
                    machines,
                    expected,
                    explained,
                    text: text.into(),
                    expected_block,
                    facts_block: f.block,
                    blocks,
                })
            }
            _ => Err(out),
        }
    }
}

/// The verdict that follows from the worst row.
pub(super) fn verdict(worst: Row, explained: bool) -> Verdict {
    match worst {
        Row::Agrees => Verdict::Agrees,
        Row::WithinScatter => Verdict::WithinScatter,
        Row::Differs if explained => Verdict::Explained,
        Row::Differs => Verdict::Open,
    }
}

struct Facts {
    requirement: String,
    source: String,
    evidence: EvidenceKind,
    verdict: Verdict,
    verdict_span: Span,
    block: usize,
}

/// The first table of the page.
fn facts(blocks: &[Block], out: &mut Diagnostics) -> Option<Facts> {
    let wrong = |message: Text| Diagnostic::error("validation.document", message);
    let found = blocks.iter().enumerate().find_map(|(i, b)| match &b.kind {
        Kind::Table(grid) => Some((i, grid)),
        _ => None,
    });
    let rows = found.map_or(&[][..], |(_, grid)| &grid.rows);
    let mut get = |name: &str| {
        let cell = rows.iter().find(|r| r.first().is_some_and(|c| c.text == name)).and_then(|r| r.get(1)).filter(|c| !c.text.is_empty());
        if cell.is_none() {
            out.push(
                wrong(text!("the page does not say its {name}", name = name.to_lowercase()))
                    .help(text!("add a row | {name} | ... | to its first table", name)),
            );
        }
        cell
    };
    let (requirement, source, evidence, verdict) = (get("Requirement"), get("Source"), get("Evidence"), get("Verdict"));
    let kind = evidence.and_then(|c| {
        let kind = EvidenceKind::ALL.into_iter().find(|k| k.word() == c.text);
        if kind.is_none() {
            let all = EvidenceKind::ALL.map(EvidenceKind::word).join(", ");
            out.push(wrong(text!("\"{text}\" is no kind of evidence", text = c.text)).at(c.span.clone()).help(text!("kinds: {all}", all)));
        }
        kind
    });
    let stated = verdict.and_then(|c| {
        let stated = Verdict::ALL.into_iter().find(|v| v.words() == c.text);
        if stated.is_none() {
            let all = Verdict::ALL.map(Verdict::words).join(", ");
            out.push(wrong(text!("\"{text}\" is no verdict", text = c.text)).at(c.span.clone()).help(text!("verdicts: {all}", all)));
        }
        stated
    });
    Some(Facts {
        requirement: requirement?.text.clone(),
        source: source?.text.clone(),
        evidence: kind?,
        verdict: stated?,
        verdict_span: verdict?.span.clone(),
        block: found?.0,
    })
}

/// The blocks below a heading of the second level, up to the next one.
fn section<'a>(blocks: &'a [Block], name: &str) -> Option<&'a [Block]> {
    let start = 1 + blocks.iter().position(|b| matches!(&b.kind, Kind::Heading(2, t) if t == name))?;
    let end = blocks[start..].iter().position(|b| matches!(b.kind, Kind::Heading(1 | 2, _))).map_or(blocks.len(), |n| start + n);
    Some(&blocks[start..end])
}
