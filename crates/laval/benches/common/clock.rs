//! The clock of benchmarks of one core.

use std::sync::OnceLock;
use std::time::Instant;

/// Time this thread has spent on a processor, s, which others on the machine do not disturb; the wall clock where the system does not tell.
pub fn clock() -> f64 {
    static START: OnceLock<Instant> = OnceLock::new();
    let start = START.get_or_init(Instant::now);
    let reported = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = reported.and_then(|t| t.split_whitespace().next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(|| start.elapsed().as_secs_f64(), |t| t * 1e-9)
}
