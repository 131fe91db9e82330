//! Results of long studies: computed in chunks, written as they come, continued after a kill.
//!
//! A study is a number of rows, each computed from its index alone. Rows come in chunks; each chunk is one Parquet file, written under a
//! temporary name, flushed to the disk and renamed, and then named in `manifest.json`. Whatever happens, the folder holds whole chunks only,
//! and the same study in the same folder computes what is missing: its files are then those of the undisturbed run, byte for byte. A folder of
//! another input, another build or another processor level is refused, with what differs.
//!
//! Several processes may compute a study together, each a [`Piece`] of it: a piece writes its chunks alone, and the run that collects them finds all chunks
//! by the checksum and the mark that each file holds. Which process wrote a chunk, when, and how often changes no file.
//!
//! Without a folder ([`Host::keep`]) chunks stay in memory.
//!
//! ```
//! use laval::store::{self, Cells, Column, Plan};
//! use laval::study::Context;
//!
//! # fn main() -> Result<(), laval::diagnostic::Diagnostic> {
//! let plan = Plan { study: "squares".into(), columns: vec![Column::float("square", "", "i^2")], rows: 1000, chunk: 64 };
//! let results = store::run(plan, &Context::quiet("squares"), |rows, _| {
//!     Ok(Some(vec![Cells::Float(rows.map(|i| (i * i) as f64).collect())]))
//! })?;
//! assert!(results.complete());
//! let mut sum = 0.0;
//! for chunk in results.chunks() {
//!     let chunk = chunk?;
//!     sum += (0..chunk.rows.len()).map(|i| chunk.cells[0].number(i)).sum::<f64>();
//! }
//! assert_eq!(sum, 332_833_500.0);
//! # Ok(()) }
//! ```

mod cells;
mod collected;
#[cfg(feature = "parquet")]
mod folder;
#[cfg(feature = "parquet")]
mod manifest;
#[cfg(feature = "parquet")]
mod parquet;
mod piece;
#[cfg(feature = "parquet")]
mod reader;

pub use cells::{Cells, Column, Kind};
pub use collected::Collected;
pub use piece::{Piece, Work};
#[cfg(feature = "parquet")]
pub use reader::Reader;

use crate::diagnostic::Diagnostic;
use crate::outcome::{Arg, End, Finding, Message};
use crate::text;
use crate::text::Text;
#[cfg(feature = "parquet")]
use folder::Folder;
use serde::{Deserialize, Serialize};
use std::ops::Range;
use std::path::PathBuf;
use std::sync::atomic::{AtomicI64, AtomicU64, Ordering};

/// Most chunks of a study: the manifest names each of them and is written anew after each.
const MOST_CHUNKS: usize = 20_000;

/// Where results are kept, and for which input.
#[derive(Clone, Debug)]
pub struct Keep {
    /// The folder of the study; made when missing.
    pub folder: PathBuf,
    /// All that settles the numbers (machine and settings, in SI units), and nothing else.
    pub input: serde_json::Value,
    /// Remove what the folder holds of a study and start anew.
    pub fresh: bool,
    /// Which chunks are computed.
    pub work: Work,
}

/// What surrounds a run: where to keep results, whom to tell, when to stop.
pub trait Host: Sync {
    /// Where to keep results; `None` keeps them in memory.
    fn keep(&self) -> Option<&Keep>;
    /// The user stopped it.
    fn cancelled(&self) -> bool;
    /// What is going to be computed; `chained` when a chunk follows from the one before.
    fn planned(&self, _plan: &Plan, _chained: bool) {}
    /// `done` of `total` rows.
    fn report(&self, done: u64, total: u64);
    /// `done` of `total` rows are there from an earlier run; they say nothing of the rate.
    fn restored(&self, done: u64, total: u64);
    /// Of the rows under way, how much is done.
    fn part(&self, _rows: f64) {}
    /// A remark that the result does not hold, because it does not depend on it.
    fn note(&self, text: &Text);
    /// Most rows; chunks that begin beyond are left out.
    fn most_rows(&self) -> u64;
}

/// What is computed: how many rows of which columns.
#[derive(Clone, Debug)]
pub struct Plan {
    /// Kind of the study.
    pub study: String,
    /// The columns.
    pub columns: Vec<Column>,
    /// Number of rows.
    pub rows: usize,
    /// Rows of a chunk: what memory holds, and what a kill can lose.
    pub chunk: usize,
}

impl Plan {
    /// Number of chunks.
    pub fn chunks(&self) -> usize {
        self.rows.div_ceil(self.chunk)
    }

    /// Rows of a chunk.
    pub fn range(&self, index: usize) -> Range<usize> {
        index * self.chunk..((index + 1) * self.chunk).min(self.rows)
    }

    /// Whether it can be computed.
    ///
    /// # Errors
    /// Why not.
    pub fn check(&self) -> Result<(), Diagnostic> {
        let wrong = |message: Text| Err(Diagnostic::error("store.plan", message));
        if self.rows == 0 || self.chunk == 0 || self.columns.is_empty() {
            return wrong(text!("a study needs at least one row, one row in a chunk, and one column"));
        }
        if self.chunks() > MOST_CHUNKS {
            return wrong(text!(
                "{rows} rows in chunks of {chunk} are more than {most} chunks",
                rows = self.rows,
                chunk = self.chunk,
                most = MOST_CHUNKS
            ));
        }
        match self.columns.iter().enumerate().find(|(i, c)| self.columns[..*i].iter().any(|o| o.name == c.name)) {
            Some((_, c)) => wrong(text!("two columns are named \"{name}\"", name = c.name)),
            None => Ok(()),
        }
    }
}

/// Counts rows while a chunk is computed, from any thread.
pub struct Rows<'a> {
    host: &'a dyn Host,
    done: AtomicU64,
    /// Rows under way, by what is done of them, in thousandths.
    part: AtomicI64,
    total: u64,
    /// Work beside the rows is not counted.
    aside: bool,
}

impl Rows<'_> {
    /// Of a row under way so many thousandths more are done; what was added is taken back before the row counts as done.
    pub fn advance(&self, thousandths: i64) {
        if self.aside {
            return;
        }
        let part = self.part.fetch_add(thousandths, Ordering::Relaxed) + thousandths;
        if thousandths > 0 {
            self.host.part(part.max(0) as f64 / 1000.0);
        }
    }
    /// `n` more rows are done.
    pub fn add(&self, n: u64) {
        if self.aside {
            return;
        }
        let done = self.done.fetch_add(n, Ordering::Relaxed) + n;
        self.host.part(self.part.load(Ordering::Relaxed).max(0) as f64 / 1000.0);
        self.host.report(done.min(self.total), self.total);
    }
    /// The user stopped it.
    pub fn cancelled(&self) -> bool {
        self.host.cancelled()
    }
    /// For work that serves a row and is none.
    pub fn aside(&self) -> Rows<'_> {
        Rows { host: self.host, done: AtomicU64::new(0), part: AtomicI64::new(0), total: 0, aside: true }
    }
    fn set(&self, done: u64) {
        self.done.store(done, Ordering::Relaxed);
        self.host.report(done, self.total);
    }
}

enum Place {
    Memory(Vec<Option<Vec<Cells>>>),
    #[cfg(feature = "parquet")]
    Folder(Box<Folder>),
}

impl Place {
    fn open(host: &dyn Host, plan: &Plan, _mine: &[usize]) -> Result<Place, Diagnostic> {
        match host.keep() {
            None => Ok(Place::Memory(vec![None; plan.chunks()])),
            #[cfg(feature = "parquet")]
            Some(keep) => Folder::open(keep, plan, host, _mine).map(|f| Place::Folder(Box::new(f))),
            #[cfg(not(feature = "parquet"))]
            Some(_) => Err(Diagnostic::error("store.parquet", text!("this build cannot write Parquet, which long studies are kept in"))),
        }
    }

    fn has(&self, index: usize) -> bool {
        match self {
            Place::Memory(chunks) => chunks[index].is_some(),
            #[cfg(feature = "parquet")]
            Place::Folder(folder) => folder.has(index),
        }
    }

    fn put(&mut self, index: usize, plan: &Plan, cells: Vec<Cells>) -> Result<(), Diagnostic> {
        match self {
            Place::Memory(chunks) => {
                chunks[index] = Some(cells);
                Ok(())
            }
            #[cfg(feature = "parquet")]
            Place::Folder(folder) => folder.put(index, &plan.columns, &cells),
        }
    }

    fn read(&self, index: usize, plan: &Plan) -> Result<Vec<Cells>, Diagnostic> {
        match self {
            Place::Memory(chunks) => Ok(chunks[index].clone().unwrap_or_default()),
            #[cfg(feature = "parquet")]
            Place::Folder(folder) => folder.read(index, &plan.columns).map(|r| r.0),
        }
    }
}

/// What [`run_on`] can read: the columns of the chunk before, `None` for the first.
pub type Before<'a> = &'a dyn Fn() -> Result<Option<Vec<Cells>>, Diagnostic>;

/// Computes the rows that are not there yet, chunk by chunk.
///
/// `compute` gets the rows of one chunk and returns its columns, which must depend on the rows' indices alone (not on threads, order, or time);
/// `None` when it was stopped in between: the chunk is then dropped and the run ends.
///
/// # Errors
/// When the folder cannot be written, is in use, or holds results of another input; and whatever `compute` returns. Chunks written
/// until then are kept. A run that only plans or computes a piece ends with the code [`NO_RESULT`], for there is no result yet; one that collects
/// refuses while chunks are missing.
pub fn run(
    plan: Plan,
    host: &dyn Host,
    mut compute: impl FnMut(Range<usize>, &Rows) -> Result<Option<Vec<Cells>>, Diagnostic>,
) -> Result<Results, Diagnostic> {
    fill(plan, host, false, |range, rows, _| compute(range, rows))
}

/// As [`run`], for rows that follow from the row before: a chunk may read the one before it, from which all it needs must follow.
///
/// # Errors
/// As [`run`].
pub fn run_on(
    plan: Plan,
    host: &dyn Host,
    compute: impl FnMut(Range<usize>, &Rows, Before) -> Result<Option<Vec<Cells>>, Diagnostic>,
) -> Result<Results, Diagnostic> {
    fill(plan, host, true, compute)
}

/// The code of a run that has done its work and has no result.
pub const NO_RESULT: &str = "store.no_result";

/// The code of a run that should collect rows and misses some.
pub const MISSING: &str = "store.missing";

fn fill(
    plan: Plan,
    host: &dyn Host,
    chained: bool,
    mut compute: impl FnMut(Range<usize>, &Rows, Before) -> Result<Option<Vec<Cells>>, Diagnostic>,
) -> Result<Results, Diagnostic> {
    plan.check()?;
    host.planned(&plan, chained);
    let work = host.keep().map(|k| k.work).unwrap_or_default();
    if work == Work::Plan {
        return Err(Diagnostic::warning(NO_RESULT, text!("the study is planned, not run")));
    }
    let mine: Vec<usize> = match work {
        Work::Piece(piece) => (0..plan.chunks()).filter(|&i| piece.has(i, chained)).collect(),
        _ => (0..plan.chunks()).collect(),
    };
    let mut place = Place::open(host, &plan, &mine)?;
    let count = |chunks: &mut dyn Iterator<Item = usize>| chunks.map(|i| plan.range(i).len() as u64).sum::<u64>();
    let present = count(&mut mine.iter().copied().filter(|&i| place.has(i)));
    let total = count(&mut mine.iter().copied());
    if work == Work::Collect && present < total {
        return Err(missing(&plan, &mut mine.iter().copied().filter(|&i| !place.has(i)), total - present));
    }
    let rows = Rows { host, done: AtomicU64::new(present), part: AtomicI64::new(0), total, aside: false };
    if present > 0 {
        host.restored(present, rows.total);
    }
    let mut done = present;
    let mut end = End::Reached;
    for index in mine {
        if place.has(index) {
            continue;
        }
        let range = plan.range(index);
        if host.cancelled() || range.start as u64 >= host.most_rows() {
            end = if host.cancelled() { End::Cancelled } else { End::MaxPoints };
            break;
        }
        let count = range.len();
        let before = || if index == 0 { Ok(None) } else { place.read(index - 1, &plan).map(Some) };
        let Some(cells) = compute(range, &rows, &before)? else {
            end = End::Cancelled;
            break;
        };
        cells::check(&plan.columns, count, &cells)?;
        place.put(index, &plan, cells)?;
        done += count as u64;
        rows.set(done);
    }
    if let Work::Piece(piece) = work {
        let (number, of) = (piece.number(), piece.of());
        let message = match total {
            0 => text!("part {number} of {of} has no rows", number, of),
            _ => text!("part {number} of {of}: {done} of {total} rows are there", number, of, done, total),
        };
        return Err(Diagnostic::warning(NO_RESULT, message));
    }
    let kept = host.keep().is_some();
    Ok(Results { plan, place, done, end, kept })
}

/// Chunks that a run should collect and that are not there.
fn missing(plan: &Plan, chunks: &mut dyn Iterator<Item = usize>, rows: u64) -> Diagnostic {
    const SHOWN: usize = 6;
    let chunks: Vec<usize> = chunks.collect();
    let mut shown: Vec<String> = chunks.iter().take(SHOWN).map(|i| (i + 1).to_string()).collect();
    if chunks.len() > SHOWN {
        shown.push("...".into());
    }
    let (all, shown, of) = (plan.rows, shown.join(", "), plan.chunks());
    Diagnostic::error(MISSING, text!("{rows} of {all} rows are missing, those of the chunks {shown} of {of}", rows, all, shown, of)).help(text!(
        "run the parts that have not ended once more; chunk k belongs to part ((k - 1) mod n) + 1 of n. laval run computes what is missing"
    ))
}

/// What a run has computed or found; the folder stays locked while it lives.
pub struct Results {
    plan: Plan,
    place: Place,
    done: u64,
    end: End,
    kept: bool,
}

/// One chunk read back.
#[derive(Clone, Debug, PartialEq)]
pub struct Chunk {
    /// Its rows.
    pub rows: Range<usize>,
    /// Its columns, in the order of the plan.
    pub cells: Vec<Cells>,
}

impl Results {
    /// How the run ended.
    pub fn end(&self) -> End {
        self.end
    }
    /// Whether all rows are there.
    pub fn complete(&self) -> bool {
        self.done == self.requested()
    }
    /// Number of rows requested.
    pub fn requested(&self) -> u64 {
        self.plan.rows as u64
    }
    /// They are kept in a folder.
    pub fn kept(&self) -> bool {
        self.kept
    }
    /// Number of rows that are there.
    pub fn done(&self) -> u64 {
        self.done
    }
    /// The columns.
    pub fn columns(&self) -> &[Column] {
        &self.plan.columns
    }
    /// Position of a column.
    pub fn position(&self, column: &str) -> Option<usize> {
        self.plan.columns.iter().position(|c| c.name == column)
    }

    /// The chunks that are there, in order, one in memory at a time.
    pub fn chunks(&self) -> impl Iterator<Item = Result<Chunk, Diagnostic>> + '_ {
        let present = (0..self.plan.chunks()).filter(|&i| self.place.has(i));
        present.map(|i| Ok(Chunk { rows: self.plan.range(i), cells: self.place.read(i, &self.plan)? }))
    }

    /// One column of numbers, over all rows that are there; NaN where there is none.
    ///
    /// # Errors
    /// When a chunk cannot be read.
    pub fn numbers(&self, column: &str) -> Result<Vec<f64>, Diagnostic> {
        let Some(c) = self.position(column) else {
            return Err(Diagnostic::error("store.columns", text!("there is no column \"{column}\"", column)));
        };
        let mut out = Vec::with_capacity(usize::try_from(self.done).unwrap_or_default());
        for chunk in self.chunks() {
            let chunk = chunk?;
            out.extend((0..chunk.rows.len()).map(|i| chunk.cells[c].number(i)));
        }
        Ok(out)
    }

    /// What a run that ended early owes its reader: how far it came, and how it goes on.
    pub fn remark(&self) -> Option<Finding> {
        self.remark_of("rows")
    }

    /// The same where the rows have a name.
    pub fn remark_of(&self, rows: &str) -> Option<Finding> {
        incomplete(self.done, self.requested(), self.kept, rows)
    }

    /// How far it came.
    pub fn extent(&self) -> Extent {
        Extent { done: self.done, requested: self.requested(), kept: self.kept }
    }
}

/// How far a run came.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Extent {
    /// Rows that are there.
    pub done: u64,
    /// Rows requested.
    pub requested: u64,
    /// They are kept in a folder.
    pub kept: bool,
}

impl Extent {
    /// As [`Results::remark`].
    pub fn remark(&self) -> Option<Finding> {
        incomplete(self.done, self.requested, self.kept, "rows")
    }
}

fn incomplete(done: u64, requested: u64, kept: bool, rows: &str) -> Option<Finding> {
    let key = if kept { "store-incomplete-kept" } else { "store-incomplete" };
    (done != requested).then(|| {
        Finding::warning("incomplete", key)
            .value(done as f64, "")
            .arg("done", Arg::Count(done))
            .arg("requested", Arg::Count(requested))
            .arg("rows", Arg::term(rows))
            .evidence(Message::new("store-requested").arg("rows", Arg::term(rows)), requested as f64, "")
    })
}
