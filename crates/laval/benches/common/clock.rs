//! Clocks of the benchmarks: time on a processor, which other programs on the machine do not disturb.
//!
//! The system keeps these clocks at every switch of threads and to the nanosecond; statistics of the scheduler advance in ticks of milliseconds.

use std::sync::OnceLock;
use std::time::Instant;

/// Time this thread has spent on a processor, s; the wall clock on systems without such a clock.
#[allow(dead_code, reason = "a benchmark of all processors needs the other one")]
pub fn clock() -> f64 {
    #[cfg(unix)]
    return seconds(rustix::time::ClockId::ThreadCPUTime);
    #[cfg(not(unix))]
    wall()
}

/// Time all threads of the program together have spent on processors, s; the wall clock on systems without such a clock.
#[allow(dead_code, reason = "a benchmark of one core needs the other one")]
pub fn all_threads() -> f64 {
    #[cfg(unix)]
    return seconds(rustix::time::ClockId::ProcessCPUTime);
    #[cfg(not(unix))]
    wall()
}

/// Time since the first call, s.
#[allow(dead_code, reason = "a benchmark of one core needs none")]
pub fn wall() -> f64 {
    static START: OnceLock<Instant> = OnceLock::new();
    START.get_or_init(Instant::now).elapsed().as_secs_f64()
}

#[cfg(unix)]
fn seconds(id: rustix::time::ClockId) -> f64 {
    let t = rustix::time::clock_gettime(id);
    t.tv_sec as f64 + t.tv_nsec as f64 * 1e-9
}
