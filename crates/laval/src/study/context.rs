//! What surrounds a running study: its name, progress, cancellation, limits, and where it keeps its rows.

use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use crate::model::timed::{Speeds, Timed};
use crate::outcome::{End, significant};
use crate::store::{Host, Keep, Plan};
use crate::text;
use crate::text::Text;
use laval_num::work::{self, Cancel};
use std::cell::Cell;
use std::sync::LazyLock;
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};

/// Receives how far a study is.
pub trait Progress: Sync {
    /// `done` of `total` units of work (`total` 0: unknown).
    fn report(&self, done: u64, total: u64);
    /// `done` of `total` are there from an earlier run; they say nothing of the rate.
    fn restored(&self, done: u64, total: u64) {
        self.report(done, total);
    }
    /// Of the units under way, how much is done: 2.5 when five of them are half done. Where single units take long.
    fn part(&self, _units: f64) {}
    /// What a study that is kept in chunks is going to compute; `chained` when a chunk follows from the one before.
    fn planned(&self, _plan: &Plan, _chained: bool) {}
    /// What is under way, in words, for those who wait.
    fn doing(&self, _text: &Text) {}
    /// How large the work is, in words, before it begins.
    fn job(&self, _text: &Text) {}
    /// A remark that the outcome does not hold, because it does not depend on it.
    fn note(&self, _text: &Text) {}
}

/// No progress display.
pub struct Silent;
impl Progress for Silent {
    fn report(&self, _: u64, _: u64) {}
}

/// What surrounds a running study.
#[derive(Clone, Copy)]
pub struct Context<'a> {
    /// Name of the study in the file.
    pub name: &'a str,
    /// Set to stop: the study ends at its next step and returns what it has.
    pub cancel: &'a Cancel,
    /// Progress display.
    pub progress: &'a dyn Progress,
    /// Most steps (integration steps, continuation points, grid points) before the study ends by itself; it also ends when these have cost
    /// [`STEP`] units of [work](laval_num::work) each on average.
    pub work_limit: u64,
    /// Where a long study keeps its rows; `None` keeps them in memory.
    pub keep: Option<&'a Keep>,
}

/// Units of work that a step of a work limit may cost on average, some 0.1 s.
pub const STEP: u64 = 100_000_000;

/// A time form that takes longer is worth a word.
const LONG: Duration = Duration::from_secs(1);

static NEVER: LazyLock<Cancel> = LazyLock::new(Cancel::default);

impl Context<'static> {
    /// Runs to the end, silently.
    pub fn quiet(name: &'static str) -> Self {
        Context { name, cancel: &NEVER, progress: &Silent, work_limit: u64::MAX, keep: None }
    }
}

impl Context<'_> {
    /// The user stopped it.
    pub fn cancelled(&self) -> bool {
        self.cancel.load(Ordering::Relaxed)
    }

    /// Says how large the work is before it begins, where it is large: `count` of `what`, from `large` on.
    pub fn announce(&self, count: f64, large: f64, what: Text) {
        // a count that is no number is worth a word, too
        if !(count < large) {
            self.progress.job(&text!("{count} {what}", count = significant(count, 3), what));
        }
    }

    /// May a study go on that has done so much work?
    pub fn goes_on(&self, done: u64) -> bool {
        !self.cancelled() && done < self.work_limit && work::spent() < self.work_limit.saturating_mul(STEP)
    }

    /// The end of a study that did all it was requested, or stopped because [`goes_on`](Self::goes_on) said no.
    pub fn end(&self, complete: bool) -> End {
        match (complete, self.cancelled()) {
            (true, _) => End::Reached,
            (false, true) => End::Cancelled,
            (false, false) => End::WorkLimit,
        }
    }
}

impl Context<'_> {
    /// The machine for motions in time; `None` when cancelled. Says so where making it takes long.
    ///
    /// # Errors
    /// As [`System::timed`].
    pub(crate) fn timed<'a>(&self, system: &'a System, speeds: Speeds) -> Result<Option<Timed<'a>>, Diagnostic> {
        let (begun, said) = (Instant::now(), Cell::new(false));
        let stop = || {
            if !said.get() && begun.elapsed() > LONG {
                said.set(true);
                let names: Vec<String> = system.without_time_form().map(|slot| format!("\"{}\"", slot.name)).collect();
                self.progress.job(&text!("making the time form of {names}", names = names.join(", ")));
            }
            self.cancelled()
        };
        system.timed_until(speeds, &stop)
    }
}

impl Host for Context<'_> {
    fn keep(&self) -> Option<&Keep> {
        self.keep
    }
    fn cancelled(&self) -> bool {
        Context::cancelled(self)
    }
    fn planned(&self, plan: &Plan, chained: bool) {
        self.progress.planned(plan, chained);
    }
    fn report(&self, done: u64, total: u64) {
        self.progress.report(done, total);
    }
    fn restored(&self, done: u64, total: u64) {
        self.progress.restored(done, total);
    }
    fn part(&self, rows: f64) {
        self.progress.part(rows);
    }
    fn note(&self, text: &Text) {
        self.progress.note(text);
    }
    fn most_rows(&self) -> u64 {
        self.work_limit
    }
}
