//! Waiting for a computation: Python stays responsive, signals are handled, progress is shown.

use crate::pool::{self, Borrowed};
use laval::study::{Cancel, Progress};
use laval::text::Text;
use pyo3::prelude::*;
use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Condvar, Mutex, PoisonError};
use std::time::Duration;

/// Between two looks at signals and progress.
const LOOK: Duration = Duration::from_millis(50);

/// How far a run is.
#[derive(Default)]
pub struct Watch {
    study: Mutex<String>,
    done: AtomicU64,
    total: AtomicU64,
    /// Bits of the share of units under way.
    part: AtomicU64,
    notes: Mutex<Vec<String>>,
}

impl Watch {
    /// A study begins.
    pub fn begin(&self, study: &str) {
        *self.study.lock().unwrap_or_else(PoisonError::into_inner) = study.into();
        self.report(0, 0);
    }

    /// Remarks so far.
    pub fn notes(&self) -> Vec<String> {
        self.notes.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    fn now(&self) -> (String, f64, u64) {
        let study = self.study.lock().unwrap_or_else(PoisonError::into_inner).clone();
        let part = f64::from_bits(self.part.load(Ordering::Relaxed));
        (study, self.done.load(Ordering::Relaxed) as f64 + part, self.total.load(Ordering::Relaxed))
    }
}

impl Progress for Watch {
    fn report(&self, done: u64, total: u64) {
        self.part.store(0, Ordering::Relaxed);
        self.done.store(done, Ordering::Relaxed);
        self.total.store(total, Ordering::Relaxed);
    }
    fn part(&self, units: f64) {
        self.part.store(units.to_bits(), Ordering::Relaxed);
    }
    fn note(&self, text: &Text) {
        self.notes.lock().unwrap_or_else(PoisonError::into_inner).push(text.to_string());
    }
}

/// Waits for nothing: what attending to a run costs.
#[pyfunction]
pub fn idle(py: Python<'_>) -> PyResult<()> {
    let run = attended(py, &Cancel::default(), &Watch::default(), None, || ())?;
    run.stopped_by.map_or(Ok(()), Err)
}

/// What a computation gave, or with what it panicked; and the exception that stops it.
pub struct Attended<R> {
    pub result: Result<R, Box<dyn Any + Send>>,
    pub stopped_by: Option<PyErr>,
}

/// Runs `work` on a thread of a pool of its own and waits without the lock of the interpreter. An exception of a signal handler (Ctrl-C) or of `progress`
/// requests the stop; what is done then still comes back.
pub fn attended<R: Send>(
    py: Python<'_>,
    cancel: &Cancel,
    watch: &Watch,
    progress: Option<&Bound<'_, PyAny>>,
    work: impl FnOnce() -> R + Send,
) -> PyResult<Attended<R>> {
    attended_on(&pool::take()?, py, cancel, watch, progress, work)
}

/// The same on a pool that is given.
pub fn attended_on<R: Send>(
    pool: &Borrowed,
    py: Python<'_>,
    cancel: &Cancel,
    watch: &Watch,
    progress: Option<&Bound<'_, PyAny>>,
    work: impl FnOnce() -> R + Send,
) -> PyResult<Attended<R>> {
    let (slot, ready) = (Mutex::new(None), Condvar::new());
    let mut stopped_by = None;
    let mut shown = None;
    pool.in_place_scope(|scope| {
        scope.spawn(|_| {
            let result = catch_unwind(AssertUnwindSafe(work));
            *slot.lock().unwrap_or_else(PoisonError::into_inner) = Some(result);
            ready.notify_one();
        });
        loop {
            let done = py.detach(|| {
                let waiting = slot.lock().unwrap_or_else(PoisonError::into_inner);
                let waited = ready.wait_timeout_while(waiting, LOOK, |result| result.is_none());
                waited.map_or_else(|e| e.into_inner().0.is_some(), |w| w.0.is_some())
            });
            if stopped_by.is_none() {
                let mut look = || -> PyResult<()> {
                    py.check_signals()?;
                    let now = watch.now();
                    if let Some(progress) = progress.filter(|_| shown.as_ref() != Some(&now)) {
                        progress.call1(now.clone())?;
                        shown = Some(now);
                    }
                    Ok(())
                };
                if let Err(e) = look() {
                    cancel.store(true, Ordering::Relaxed);
                    stopped_by = Some(e);
                }
            }
            if done {
                break;
            }
        }
    });
    let result = slot.into_inner().unwrap_or_else(PoisonError::into_inner).expect("the scope has waited for it");
    Ok(Attended { result, stopped_by })
}
