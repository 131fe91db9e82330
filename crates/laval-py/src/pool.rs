//! Threads of parallel loops.
//!
//! Every run has a pool to itself while it lasts: loops of one run never wait for another, and the meter of its work is its own. Pools that are idle wait
//! for the next run. A process that was forked has none of the threads of its parent, so that it begins without pools; rayon's global pool, which cannot be
//! replaced, is not used.

use pyo3::PyResult;
use pyo3::exceptions::PyRuntimeError;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::num::NonZeroUsize;
use std::ops::Deref;
use std::process;
use std::ptr::null_mut;
use std::sync::atomic::{AtomicPtr, Ordering};
use std::sync::{Mutex, PoisonError};

/// As large as that of the main thread of most programs, and twice that: runs begin on these threads.
const STACK: usize = 16 << 20;

/// The idle pools of a process.
struct Idle {
    process: u32,
    pools: Mutex<Vec<ThreadPool>>,
}

static IDLE: AtomicPtr<Idle> = AtomicPtr::new(null_mut());

/// Those of this process. Another thread may have held the lock of the parent's when it was forked, so a new process takes a new one.
fn idle() -> &'static Idle {
    let process = process::id();
    let known = IDLE.load(Ordering::Acquire);
    // SAFETY: what the pointer was ever set to is leaked below
    if let Some(idle) = unsafe { known.as_ref() }.filter(|i| i.process == process) {
        return idle;
    }
    let fresh = Box::into_raw(Box::new(Idle { process, pools: Mutex::default() }));
    match IDLE.compare_exchange(known, fresh, Ordering::AcqRel, Ordering::Acquire) {
        // SAFETY: never freed
        Ok(_) => unsafe { &*fresh },
        // SAFETY: another thread of this process was first with one that is never freed
        Err(other) => unsafe { &*other },
    }
}

/// A pool for the time of one run.
pub struct Borrowed {
    process: u32,
    pool: Option<ThreadPool>,
    /// To the idle ones.
    returns: bool,
}

fn started(threads: usize) -> PyResult<ThreadPool> {
    let built = ThreadPoolBuilder::new().num_threads(threads).stack_size(STACK).thread_name(|k| format!("laval-{k}")).build();
    built.map_err(|e| PyRuntimeError::new_err(format!("no thread can be started: {e}")))
}

/// Starts a pool of so many threads, which end with it.
pub fn of(threads: NonZeroUsize) -> PyResult<Borrowed> {
    Ok(Borrowed { process: process::id(), pool: Some(started(threads.get())?), returns: false })
}

/// Takes an idle pool, or starts one.
pub fn take() -> PyResult<Borrowed> {
    let idle = idle();
    let waiting = idle.pools.lock().unwrap_or_else(PoisonError::into_inner).pop();
    // 0: as many as the computer has, or RAYON_NUM_THREADS
    let pool = waiting.map_or_else(|| started(0), Ok)?;
    Ok(Borrowed { process: idle.process, pool: Some(pool), returns: true })
}

impl Deref for Borrowed {
    type Target = ThreadPool;
    fn deref(&self) -> &ThreadPool {
        self.pool.as_ref().expect("it is there until the drop")
    }
}

impl Drop for Borrowed {
    fn drop(&mut self) {
        let Some(pool) = self.pool.take() else { return };
        let idle = idle();
        if idle.process == self.process && !self.returns {
            drop(pool);
        } else if idle.process == self.process {
            idle.pools.lock().unwrap_or_else(PoisonError::into_inner).push(pool);
        } else {
            // the threads are the parent's
            std::mem::forget(pool);
        }
    }
}
