//! The clock of the benchmarks.

#[path = "../../benches/common/clock.rs"]
mod clock;

use clock::{all_threads, clock};
use std::hint::black_box;
use std::time::{Duration, Instant};

/// The clock advances within a millisecond of work of its thread, hundreds of times in a row, and stands while the thread sleeps.
#[test]
fn the_clock_advances_within_a_millisecond_of_work() {
    for read in [clock, all_threads] {
        let mut last = read();
        for _ in 0..300 {
            // work of far less than a millisecond on any processor: about 1e5 additions
            black_box((0..100_000u64).fold(0u64, |s, k| s.wrapping_add(black_box(k))));
            let now = read();
            assert!(now > last, "the clock stands at {last} s through work");
            last = now;
        }
    }
    let (begun, slept) = (clock(), Instant::now());
    std::thread::sleep(Duration::from_millis(200));
    let (worked, passed) = (clock() - begun, slept.elapsed().as_secs_f64());
    assert!(worked < 0.1 * passed, "{worked} s on a processor during {passed} s of sleep");
}
