//! Threads whose work stands behind that of the browser on the same processors: a figure that is still computed does not delay the painting of one that is done.

use std::io;
use std::sync::LazyLock;
use tokio::runtime::{Builder, Runtime};

/// Most figures computed at once; more wait.
const FIGURES: usize = 16;

static THREADS: LazyLock<io::Result<Runtime>> =
    LazyLock::new(|| Builder::new_current_thread().max_blocking_threads(FIGURES).on_thread_start(stand_behind).build());

/// Computes on one of these threads.
pub(crate) fn spawn(work: impl FnOnce() + Send + 'static) {
    match &*THREADS {
        Ok(threads) => threads.spawn_blocking(work),
        Err(_) => tokio::task::spawn_blocking(work),
    };
}

/// Lets the threads that share the work of all computations of this process stand behind the browser too. For a process that does nothing but serve; before its first
/// computation.
pub fn share_behind() {
    // another part of the process may have begun them
    let _ = rayon::ThreadPoolBuilder::new().start_handler(|_| stand_behind()).build_global();
}

#[cfg(target_os = "linux")]
fn stand_behind() {
    /// Steps of priority.
    const STEPS: i32 = 10;
    // of the calling thread alone
    let _ = rustix::process::setpriority_process(None, STEPS);
}

/// Elsewhere a priority is that of the whole process.
#[cfg(not(target_os = "linux"))]
fn stand_behind() {}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use super::*;
    use rustix::process::getpriority_process;
    use std::sync::mpsc::channel;

    #[test]
    fn figures_are_computed_behind_the_browser_and_nothing_else_is() {
        let before = getpriority_process(None).unwrap();
        let (send, receive) = channel();
        spawn(move || send.send(getpriority_process(None).unwrap()).unwrap());
        assert_eq!(receive.recv().unwrap(), (before + 10).min(19));
        assert_eq!(getpriority_process(None).unwrap(), before);
    }
}
