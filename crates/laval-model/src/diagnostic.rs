//! One thing that is wrong (or doubtful) in a file or a request, said once, with its place and help.

use crate::text;
use crate::text::{Argument, Text};
use std::fmt;
use std::ops::Range;

/// Byte range in the machine file.
pub type Span = Range<usize>;

/// How bad it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Severity {
    /// The result stands, with this remark.
    Warning,
    /// The file or the request cannot be used.
    Error,
}

/// A diagnostic: a stable code, the sentence, where, and what to do.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnostic {
    /// Stable machine-readable code, for instance `unit.dimension`.
    pub code: &'static str,
    /// Severity.
    pub severity: Severity,
    /// One sentence.
    pub message: Text,
    /// Place in the file, when there is one.
    pub span: Option<Span>,
    /// Short text printed under the marked place.
    pub label: Option<Box<Text>>,
    /// What to do about it.
    pub help: Option<Box<Text>>,
    /// The name that does not exist, where that is what is wrong.
    pub about: Option<Box<Absent>>,
}

/// A name that does not exist.
#[derive(Clone, Debug, PartialEq)]
pub struct Absent {
    /// As it stands in the file: `drum.q`.
    pub name: String,
    /// Further places that use it, in order.
    pub also: Vec<Span>,
}

impl Absent {
    /// The block the name begins with: `drum`.
    pub fn block(&self) -> &str {
        self.name.split('.').next().unwrap_or_default()
    }
}

impl Diagnostic {
    /// An error.
    pub fn error(code: &'static str, message: Text) -> Self {
        Diagnostic { code, severity: Severity::Error, message, span: None, label: None, help: None, about: None }
    }
    /// A warning.
    pub fn warning(code: &'static str, message: Text) -> Self {
        Diagnostic { severity: Severity::Warning, ..Self::error(code, message) }
    }
    /// Adds the place.
    pub fn at(mut self, span: impl Into<Option<Span>>) -> Self {
        self.span = span.into();
        self
    }
    /// Adds the text under the marked place.
    pub fn label(mut self, label: Text) -> Self {
        self.label = Some(Box::new(label));
        self
    }
    /// Adds the name that does not exist.
    pub fn about(mut self, name: impl Into<String>) -> Self {
        self.about = Some(Box::new(Absent { name: name.into(), also: Vec::new() }));
        self
    }
    /// Further places where the same name is missing.
    pub fn also(&self) -> &[Span] {
        self.about.as_ref().map_or(&[], |a| &a.also)
    }
    /// Adds help.
    pub fn help(mut self, help: Text) -> Self {
        self.help = Some(Box::new(help));
        self
    }
}

impl Diagnostic {
    /// The sentence with its help in brackets.
    pub fn sentence(&self) -> Text {
        match &self.help {
            Some(help) => text!("{message} ({help})", message = self.message, help),
            None => self.message.clone(),
        }
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.message.fmt(f)?;
        if let Some(help) = &self.help {
            write!(f, " ({help})")?;
        }
        Ok(())
    }
}
impl std::error::Error for Diagnostic {}

/// Collects all diagnostics of one pass.
#[derive(Clone, Debug, Default)]
pub struct Diagnostics(pub Vec<Diagnostic>);

impl Diagnostics {
    /// Adds one.
    pub fn push(&mut self, d: Diagnostic) {
        self.0.push(d);
    }
    /// Orders them by place, those without one first, and drops repetitions.
    pub fn sort_by_place(&mut self) {
        let key = |d: &Diagnostic| d.span.as_ref().map(|s| (s.start, s.end));
        self.0.sort_by(|a, b| {
            key(a).cmp(&key(b)).then_with(|| a.code.cmp(b.code)).then_with(|| a.message.to_string().cmp(&b.message.to_string()))
        });
        self.0.dedup();
    }
    /// At least one error.
    pub fn has_errors(&self) -> bool {
        self.0.iter().any(|d| d.severity == Severity::Error)
    }
    /// The first error, of a machine that could not be assembled.
    pub fn into_error(self) -> Diagnostic {
        let first = self.0.into_iter().find(|d| d.severity == Severity::Error);
        first.unwrap_or_else(|| Diagnostic::error("machine", text!("it cannot be assembled")))
    }
}

impl fmt::Display for Diagnostics {
    /// One line each: the severity, the sentence and the help.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (k, d) in self.0.iter().enumerate() {
            let severity = match d.severity {
                Severity::Warning => "warning",
                Severity::Error => "error",
            };
            write!(f, "{}{severity}: {d}", if k == 0 { "" } else { "\n" })?;
        }
        Ok(())
    }
}
impl std::error::Error for Diagnostics {}

/// A guess at what was meant, and the list of what there is.
pub fn meant(near: impl Argument, list: Text) -> Text {
    text!("did you mean {near}? {list}", near, list = text::sentence(list))
}

/// The candidate a mistyped word probably means: smallest number of single letters changed, left out, added or swapped with a
/// neighbour, at most a third of the word; capitals do not count.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    const LONGEST: usize = 64;
    let a: Vec<char> = word.chars().take(LONGEST + 1).flat_map(char::to_lowercase).collect();
    if a.is_empty() || a.len() > LONGEST {
        return None;
    }
    let limit = |other: usize| a.len().max(other).div_ceil(3);
    candidates
        .into_iter()
        .filter_map(|c| {
            let b: Vec<char> = c.chars().take(LONGEST + 1).flat_map(char::to_lowercase).collect();
            let allowed = limit(b.len());
            (a.len().abs_diff(b.len()) <= allowed).then(|| (edit_distance(&a, &b), allowed, c))
        })
        .filter(|(d, allowed, _)| d <= allowed)
        .min_by_key(|(d, _, _)| *d)
        .map(|(_, _, c)| c)
}

/// Optimal string alignment distance.
fn edit_distance(a: &[char], b: &[char]) -> usize {
    let width = b.len() + 1;
    let mut rows = [vec![0; width], (0..width).collect::<Vec<_>>(), vec![0; width]];
    for i in 1..=a.len() {
        rows[2][0] = i;
        for j in 1..width {
            let substitute = rows[1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let mut d = substitute.min(rows[1][j] + 1).min(rows[2][j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                d = d.min(rows[0][j - 2] + 1);
            }
            rows[2][j] = d;
        }
        rows.rotate_left(1);
    }
    rows[1][b.len()]
}
