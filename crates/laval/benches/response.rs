//! The benchmark response of the planar machine (empty, per-axis law, chi = 42 N s/m, e = 50 um, 25 to 8000 rad/s, orders to 7, stability at every
//! point), on one core. Prints the least and median time of many runs, the work done, and the processor.
//!
//! `cargo bench --workspace --bench response`

#[path = "../tests/common/mod.rs"]
mod common;

#[path = "common/allocator.rs"]
mod allocator;

#[path = "common/clock.rs"]
mod clock;

#[path = "common/processor.rs"]
mod processor;

#[path = "common/row.rs"]
mod row;

// studies may work on threads of their own
use clock::all_threads as clock;
use laval::solve::harmonic::branches::response::{Request, respond};
use processor::processor;
use row::row;
use std::sync::atomic::AtomicBool;

fn main() {
    let machine = common::Base { e: 5e-5, ..common::Base::default() };
    let system = match machine.builder().build() {
        Ok(s) => s,
        Err(d) => return println!("{d:?}"),
    };
    let runs = std::env::args().filter_map(|a| a.parse().ok()).next().unwrap_or(30);
    let never = AtomicBool::new(false);
    println!("processor: {}", processor());
    for (name, stability) in [("orders to 7, folds and stability", true), ("orders to 7, folds", false)] {
        let request = Request { harmonics: Some(7), stability, max_points: 20_000, ..Request::over(25.0, 8000.0) };
        let mut times = Vec::new();
        let mut last = None;
        for _ in 0..runs {
            let start = clock();
            last = respond(&system, &request, &never, &|_| {}).ok();
            times.push((clock() - start) * 1e3);
        }
        times.sort_by(f64::total_cmp);
        let Some(response) = last else { return println!("the response failed") };
        println!("{name}: least {:.2} ms, median {:.2} ms over {runs} runs", times[0], times[times.len() / 2]);
        row(&format!("response, {name}"), times[0] * 1e-3, None);
        for (what, count) in &response.work {
            println!("    {what}: {count}");
        }
        for fold in response.branches.iter().flat_map(|b| &b.folds) {
            println!("    fold at {:.10} rad/s", fold.speed);
        }
    }
}
