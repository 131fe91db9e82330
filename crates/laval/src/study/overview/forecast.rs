//! Whether a run-up ends within its bound on the work, seen from its beginning.
//!
//! The work follows the turns of the rotor, of which a share x^2 is done when a share x of the time is over, or, with steps of one length, the time. So it is at least the work
//! done over x.

use super::Known;
use crate::study::{Cancel, Context, Progress};
use laval_num::work::spent;
use std::sync::atomic::Ordering::Relaxed;

/// Share of the bound after which the first estimate is made, and the least work over the bound at which the run-up is given up: its first steps may be shorter.
const LOOKED: f64 = 1.0 / 16.0;
const FAR: f64 = 2.0;

/// Runs a computation over a time; gives it up when its least work exceeds `limit` units by far.
pub(super) fn forecast<R>(context: &Context, limit: u64, run: impl FnOnce(&Context) -> Known<R>) -> Known<R> {
    let (cancel, given_up) = (Cancel::default(), Cancel::default());
    let watch = Watch { of: context, limit: limit as f64, cancel: &cancel, given_up: &given_up };
    let found = run(&Context { cancel: &cancel, progress: &watch, ..*context });
    if given_up.load(Relaxed) { Known::TooLong } else { found }
}

struct Watch<'a> {
    of: &'a Context<'a>,
    limit: f64,
    cancel: &'a Cancel,
    given_up: &'a Cancel,
}

/// With so many units of work for a share of the time it will not end within the limit.
fn too_long(share: f64, units: f64, limit: f64) -> bool {
    units >= LOOKED * limit && units > FAR * limit * share
}

impl Progress for Watch<'_> {
    fn report(&self, done: u64, total: u64) {
        if too_long(done as f64 / total as f64, spent() as f64, self.limit) {
            self.given_up.store(true, Relaxed);
        }
        if self.given_up.load(Relaxed) || self.of.cancelled() {
            self.cancel.store(true, Relaxed);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What ends within the limit is not given up, whether its work follows the time or the turns; what takes many times as long is, after a part of the limit.
    #[test]
    fn what_ends_in_time_is_not_given_up() {
        let gives_up = |total: f64, law: fn(f64) -> f64| (1..=1000).map(|k| k as f64 / 1000.0).find(|x| too_long(*x, total * law(*x), 1.0));
        for total in [0.01, 0.5, 1.0] {
            assert_eq!(gives_up(total, |x| x), None);
            assert_eq!(gives_up(total, |x| x * x), None);
            // the first steps are shorter
            assert_eq!(gives_up(total, |x| x.powf(0.9)), None);
        }
        let spent = |total: f64| gives_up(total, |x| x * x).map(|x| total * x * x);
        assert!(spent(100.0).is_some_and(|units| units < 0.13) && spent(8.0).is_some_and(|units| units < 0.51));
        assert!(gives_up(3.0, |x| x).is_some());
        assert_eq!(gives_up(f64::NAN, |x| x), None);
    }
}
