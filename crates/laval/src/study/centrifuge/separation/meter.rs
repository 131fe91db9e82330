//! How far a separation is: counts the paths of particles that are computed, and stops them at a cancellation or the work limit.

use super::Separation;
use super::demand::searched;
use crate::separation::batch::Spinning;
use crate::separation::law::Law;
use crate::separation::particle::Drag;
use crate::separation::suspension::Model;
use crate::study::Context;
use crate::text;
use std::sync::atomic::{AtomicU64, Ordering};

/// Counts paths, for the display and the work limit.
pub(super) struct Meter<'a> {
    context: &'a Context<'a>,
    done: AtomicU64,
    total: u64,
    /// Paths between two reports.
    stride: u64,
}

/// Rounds of exits that a powder without classes takes for one share; times a share is requested at one speed; speeds at which it is requested in a search, the table over
/// the speed and the sensitivities.
const ROUNDS: u64 = 5;
const SHARES: u64 = 2;
const SPEEDS: u64 = 70;
/// Paths to integrate from which on their number is reported.
const LARGE: f64 = 20_000.0;

impl<'a> Meter<'a> {
    /// For a study; says how large the work is where paths have no closed form.
    pub fn new(study: &Separation, spinning: &Spinning, context: &'a Context<'a>) -> Self {
        let n = spinning.crowd.len() as u64;
        let size = &study.task.suspension.powder.size;
        let once = match size {
            Law::Single(_) => n,
            Law::Classes(all) => n * all.len() as u64,
            _ => n * ROUNDS,
        };
        let total = n + SHARES * once + if searched(study, spinning) { SPEEDS * once } else { 0 };
        let integrated = spinning.integrated();
        // with Stokes' drag in balance a run-up is a power series, and what follows has a closed form
        if integrated && (study.task.suspension.medium.drag == Drag::SchillerNaumann || study.task.batch.model == Model::Inertial) {
            context.announce(total as f64, LARGE, text!("paths of particles to integrate, roughly"));
        }
        Meter { context, done: AtomicU64::new(0), total, stride: if integrated { 16 } else { 1024 } }
    }

    /// One path more, a step of the work limit; whether to go on.
    pub fn one(&self) -> bool {
        let done = self.done.fetch_add(1, Ordering::Relaxed) + 1;
        if done.is_multiple_of(self.stride) {
            self.context.progress.report(done.min(self.total), self.total);
        }
        self.goes_on()
    }

    /// Neither cancelled nor beyond the work limit.
    pub fn goes_on(&self) -> bool {
        !self.context.cancelled() && self.done.load(Ordering::Relaxed) <= self.context.work_limit
    }

    /// All is done.
    pub fn finish(&self) {
        self.context.progress.report(self.total, self.total);
    }
}
