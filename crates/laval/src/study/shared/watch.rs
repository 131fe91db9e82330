//! The end of a study that does not end by itself: what it costs is counted in the kernels, and no loop need be trusted.

use super::size::Size;
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use crate::outcome::{End, Finding, Outcome};
use crate::study::{Context, STEP, Study};
use laval_num::work::{Halt, watched};

/// Most units of work that `laval check` spends on one study, about 50 ms.
const CHECK: u64 = 50_000_000;
/// Units of work beyond those of a work limit after which a study is ended from within, some seconds.
const BEYOND: u64 = 4_000_000_000;

/// Code of the diagnostic of a study that was stopped before it had any result.
pub(in crate::study) const STOPPED: &str = "study.stopped";

/// Whether the machine can answer it. What takes longer is left to the run: not known, no refusal.
pub(in crate::study) fn admit<T: Study>(study: &T, system: &System) -> Result<(), Diagnostic> {
    fits(study, system)?;
    watched(None, CHECK, || study.admit(system)).unwrap_or(Ok(()))
}

/// The same before a run, which takes the time it needs.
pub(in crate::study) fn prepare<T: Study>(study: &T, system: &System, context: &Context) -> Result<(), Diagnostic> {
    fits(study, system)?;
    watched(Some(context.cancel), u64::MAX, || study.prepare(system, context)).unwrap_or(Ok(()))
}

fn fits<T: Study>(study: &T, system: &System) -> Result<(), Diagnostic> {
    study.size(system).map_or(Ok(()), Size::check)
}

/// Runs a piece of it. A study that has to end within a computation without partial result has that end alone.
pub(in crate::study) fn run<T: Study, R>(
    study: &T,
    system: &System,
    context: &Context,
    piece: impl FnOnce() -> Result<R, Diagnostic>,
) -> Result<Result<R, End>, Diagnostic> {
    fits(study, system)?;
    let limit = context.work_limit.saturating_mul(STEP).saturating_add(BEYOND);
    match watched(Some(context.cancel), limit, piece) {
        Ok(Err(d)) if context.cancelled() && d.code == STOPPED => Ok(Err(End::Cancelled)),
        // what cannot be computed in time is no reason to refuse
        Ok(Err(_)) if context.cancelled() && admit(study, system).is_ok() => Ok(Err(End::Cancelled)),
        Ok(result) => result.map(Ok),
        Err(Halt::Stopped) => Ok(Err(End::Cancelled)),
        Err(Halt::Limit) => Ok(Err(End::WorkLimit)),
    }
}

/// The outcome of a study without partial result.
pub(in crate::study) fn nothing_shown<T: Study>(name: &str, end: End) -> Outcome {
    Outcome::new(T::KIND, name).end(end).finding(Finding::info("nothing_shown", "watch-nothing-shown"))
}
