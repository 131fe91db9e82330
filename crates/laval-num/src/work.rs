//! Work, counted where it is done, and its end.
//!
//! Kernels count what they do with [`spend`]: a factorisation, a spectrum, a step in time, a term of a series. [`watched`] runs a computation under a
//! [`Cancel`] and a limit. Loops that can hand on what they have so far read the stop themselves and end; where none does, the next kernel ends the
//! computation once it has gone on for [`GRACE`] after the stop, by unwinding to [`watched`]. So every computation ends in time, whatever loops it is made of, and none goes on
//! with numbers that are not there.
//!
//! One unit is about a multiplication and addition: some 1e9 are a second. Counts do not depend on the machine, and on a single thread not on the run.
//!
//! Threads count for the computation that started them where they [`enter`](Here::enter) the place it started them from.

use std::any::Any;
use std::cell::{Cell, RefCell};
use std::ops::Deref;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering::Relaxed};

/// Units after a stop, or beyond a limit, that loops have for ending by themselves.
pub const GRACE: u64 = 1_000_000_000;
/// How often a computation may hand on what it has.
const GRANTS: u64 = 4;
/// Units between two looks at the stop.
const SLICE: u64 = 1_000_000;

/// A request to stop, shared by whoever makes it and the computations it is for; it reads as an [`AtomicBool`].
#[derive(Clone, Debug, Default)]
pub struct Cancel(Arc<Shared>);

#[derive(Debug)]
struct Shared {
    flag: AtomicBool,
    spent: AtomicU64,
    after: AtomicU64,
    grace: AtomicU64,
}

impl Default for Shared {
    fn default() -> Self {
        Shared { flag: AtomicBool::new(false), spent: AtomicU64::new(0), after: AtomicU64::new(u64::MAX), grace: AtomicU64::new(GRACE) }
    }
}

impl Deref for Cancel {
    type Target = AtomicBool;
    fn deref(&self) -> &AtomicBool {
        &self.0.flag
    }
}

impl Cancel {
    /// Not requested, or requested from the start.
    pub fn new(requested: bool) -> Cancel {
        let stop = Cancel::default();
        stop.store(requested, Relaxed);
        stop
    }

    /// Requested by itself once so many units are spent: a test's way of stopping anywhere.
    pub fn after(units: u64) -> Cancel {
        let stop = Cancel::default();
        stop.0.after.store(units, Relaxed);
        stop
    }

    /// With another grace than [`GRACE`].
    pub fn within(self, grace: u64) -> Cancel {
        self.0.grace.store(grace, Relaxed);
        self
    }

    /// Units spent under it so far, to within a slice per thread.
    pub fn spent(&self) -> u64 {
        self.0.spent.load(Relaxed)
    }
}

/// Why a computation was ended from within.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Halt {
    /// The stop was requested.
    Stopped,
    /// The limit on its work was reached.
    Limit,
}

struct Meter {
    stop: Option<Cancel>,
    limit: AtomicU64,
    spent: AtomicU64,
    /// Units spent since the stop was requested.
    late: AtomicU64,
    /// How often it was given time to hand on what it has.
    granted: AtomicU64,
    outer: Option<Arc<Meter>>,
}

/// What unwinds: for which computation, and why.
struct Halted(Arc<Meter>, Halt);

impl Meter {
    /// Counts; says which of the nested computations has to end.
    fn count(self: &Arc<Self>, units: u64) -> Option<Halted> {
        let mut ends = None;
        let mut here = Some(self);
        let mut counted: Vec<*const Shared> = Vec::new();
        while let Some(meter) = here {
            if meter.spent.fetch_add(units, Relaxed).saturating_add(units) > meter.limit.load(Relaxed) {
                ends = Some(Halted(meter.clone(), Halt::Limit));
            }
            if let Some(stop) = &meter.stop {
                let shared = &*stop.0;
                // nested computations may be under the same stop
                if !counted.contains(&std::ptr::from_ref(shared)) {
                    counted.push(shared);
                    if shared.spent.fetch_add(units, Relaxed).saturating_add(units) >= shared.after.load(Relaxed) {
                        shared.flag.store(true, Relaxed);
                    }
                }
                if shared.flag.load(Relaxed) && meter.late.fetch_add(units, Relaxed).saturating_add(units) > shared.grace.load(Relaxed) {
                    ends = Some(Halted(meter.clone(), Halt::Stopped));
                }
            }
            here = meter.outer.as_ref();
        }
        ends
    }

    /// After it was ended from within: time for what comes after, a few times at most.
    fn grant(&self) -> bool {
        let grace = self.stop.as_ref().map_or(GRACE, |stop| stop.0.grace.load(Relaxed));
        let (late, over) = (self.late.load(Relaxed) > grace, self.spent.load(Relaxed) > self.limit.load(Relaxed));
        if !late && !over {
            // another thread was first
            return true;
        }
        if self.granted.fetch_add(1, Relaxed) >= GRANTS {
            return false;
        }
        self.late.store(0, Relaxed);
        if over {
            self.limit.fetch_add(GRACE, Relaxed);
        }
        true
    }
}

thread_local! {
    static CURRENT: RefCell<Option<Arc<Meter>>> = const { RefCell::new(None) };
    static PENDING: Cell<u64> = const { Cell::new(0) };
}

/// Counts work; ends the computation here when it has to end and no loop has ended it.
#[inline]
pub fn spend(units: u64) {
    let sum = PENDING.get().saturating_add(units);
    if sum < SLICE { PENDING.set(sum) } else { settle(sum) }
}

#[cold]
fn settle(units: u64) {
    PENDING.set(0);
    let halted = CURRENT.with_borrow(|c| c.as_ref().and_then(|meter| meter.count(units)));
    if let Some(halted) = halted
        && !std::thread::panicking()
    {
        resume_unwind(Box::new(halted));
    }
}

/// Counts for a computation until it is dropped.
pub struct Counted(Option<Arc<Meter>>);

impl Drop for Counted {
    fn drop(&mut self) {
        let (before, pending) = (self.0.take(), PENDING.take());
        let inner = CURRENT.replace(before);
        if let Some(meter) = inner {
            meter.count(pending);
        }
    }
}

fn enter(meter: Option<Arc<Meter>>) -> Counted {
    let pending = PENDING.take();
    let before = CURRENT.replace(meter);
    if let Some(meter) = &before {
        meter.count(pending);
    }
    Counted(before)
}

/// Runs a computation that ends at the latest [`GRACE`] after `stop` is requested, and when it has spent `limit` units.
///
/// # Errors
/// Why it was ended from within.
pub fn watched<R>(stop: Option<&Cancel>, limit: u64, f: impl FnOnce() -> R) -> Result<R, Halt> {
    let outer = CURRENT.with_borrow(Clone::clone);
    let meter = Arc::new(Meter { stop: stop.cloned(), limit: limit.into(), spent: 0.into(), late: 0.into(), granted: 0.into(), outer });
    let back = enter(Some(meter.clone()));
    // what a computation that was ended leaves behind are caches, whose locks forgive
    let result = catch_unwind(AssertUnwindSafe(f));
    drop(back);
    result.map_err(|payload| halt(payload, &meter))
}

fn halt(payload: Box<dyn Any + Send>, meter: &Arc<Meter>) -> Halt {
    match payload.downcast::<Halted>() {
        Ok(halted) if Arc::ptr_eq(&halted.0, meter) => halted.1,
        Ok(halted) => resume_unwind(halted),
        Err(other) => resume_unwind(other),
    }
}

/// One piece of a computation that can hand on what it has without it: `None` when the computation was ended within the piece.
pub fn piece<R>(f: impl FnOnce() -> R) -> Option<R> {
    match catch_unwind(AssertUnwindSafe(f)) {
        Ok(found) => Some(found),
        Err(payload) => match payload.downcast::<Halted>() {
            Ok(halted) if halted.0.grant() => None,
            Ok(halted) => resume_unwind(halted),
            Err(other) => resume_unwind(other),
        },
    }
}

/// Units spent so far by the innermost computation under way, to within a slice.
pub fn spent() -> u64 {
    CURRENT.with_borrow(|c| c.as_ref().map_or(0, |meter| meter.spent.load(Relaxed)))
}

/// A computation, for threads that work for it.
#[derive(Clone)]
pub struct Here(Option<Arc<Meter>>);

impl Here {
    /// The one that this thread works for.
    pub fn now() -> Here {
        Here(CURRENT.with_borrow(Clone::clone))
    }

    /// Work of this thread counts for it until the guard is dropped. A computation that has to end ends here: each of many pieces would otherwise go on for a slice.
    pub fn enter(&self) -> Counted {
        let counted = enter(self.0.clone());
        settle(0);
        counted
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn forever() {
        loop {
            spend(1000);
        }
    }

    #[test]
    fn what_enters_an_ended_computation_ends_at_once() {
        let ended = watched(None, 10, || {
            let here = Here::now();
            let ends = |units: u64| {
                let piece = || {
                    let _counted = here.enter();
                    spend(units);
                };
                std::thread::scope(|s| s.spawn(|| catch_unwind(AssertUnwindSafe(piece)).is_err()).join().unwrap())
            };
            [ends(9), ends(2 * SLICE), ends(0)]
        });
        assert_eq!(ended, Ok([false, true, true]));
    }

    #[test]
    fn a_computation_that_reads_no_stop_ends_within_its_grace() {
        for at in [0, 5 * SLICE, 7 * GRACE / 3] {
            let stop = Cancel::after(at);
            assert_eq!(watched(Some(&stop), u64::MAX, forever), Err(Halt::Stopped));
            let late = stop.spent() - at;
            assert!(late <= GRACE + 3 * SLICE, "{late} units after {at}");
        }
        assert_eq!(watched(None, 3 * SLICE, forever), Err(Halt::Limit));
        assert_eq!(watched(Some(&Cancel::new(true)), u64::MAX, || 7), Ok(7));
    }

    #[test]
    fn each_of_nested_computations_ends_by_its_own_limit() {
        // the inner one ends, the outer one goes on
        let inner = || (watched(None, SLICE, forever), 1);
        assert_eq!(watched(None, 9 * SLICE, inner), Ok((Err(Halt::Limit), 1)));
        // the outer one ends although the inner one has no limit
        assert_eq!(watched(None, 9 * SLICE, || watched(None, u64::MAX, forever)), Err(Halt::Limit));
        // one stop of both counts once
        let stop = Cancel::default();
        let spend_some = || (0..50).for_each(|_| spend(SLICE));
        watched(Some(&stop), u64::MAX, || watched(Some(&stop), u64::MAX, spend_some)).unwrap().unwrap();
        assert_eq!(stop.spent(), 50 * SLICE);
    }

    #[test]
    fn what_was_done_before_is_handed_on() {
        let stop = Cancel::after(10 * SLICE);
        let some = |left: usize| {
            let mut done = 0;
            while done < 20 && piece(|| if done < left { spend(SLICE) } else { forever() }).is_some() {
                done += 1;
            }
            done
        };
        assert_eq!(watched(Some(&stop), u64::MAX, || some(7)), Ok(7));
        assert!(stop.spent() <= 10 * SLICE + GRACE + 3 * SLICE);
        assert_eq!(watched(None, 10 * SLICE, || some(7)), Ok(7));
        // a loop that will not end is ended
        let stubborn = || loop {
            piece(forever);
        };
        assert_eq!(watched(Some(&Cancel::new(true)), u64::MAX, stubborn), Err(Halt::Stopped));
        assert!(catch_unwind(|| piece(|| panic!("of another kind"))).is_err());
    }

    #[test]
    fn threads_count_for_the_computation_that_started_them() {
        let stop = Cancel::after(10 * SLICE);
        let run = || {
            let here = Here::now();
            let thread = || {
                let _counted = here.enter();
                forever();
            };
            std::thread::scope(|s| s.spawn(thread).join()).unwrap_or_else(|payload| resume_unwind(payload));
        };
        assert_eq!(watched(Some(&stop), u64::MAX, run).err(), Some(Halt::Stopped));
        let panicked = catch_unwind(|| watched(None, u64::MAX, || panic!("of another kind")).is_ok());
        assert!(panicked.is_err());
    }
}
