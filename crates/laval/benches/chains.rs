//! How the cost of whole studies grows with the number of stations of a shaft, on one core: a chain of discs on two nonlinear bearings. Prints the time of one run each.
//!
//! `cargo bench -p laval --bench chains [-- STATIONS...]`

#[path = "../tests/common/mod.rs"]
mod common;

#[path = "common/processor.rs"]
mod processor;

use common::shaft::cubic_text;
use laval::study::Context;
use processor::processor;
use std::time::Instant;

const STUDIES: [&str; 2] = ["nonlinear_response", "forced_response"];

fn main() {
    println!("processor: {}", processor());
    let sizes: Vec<usize> = std::env::args().filter_map(|w| w.parse().ok()).collect();
    let sizes = if sizes.is_empty() { vec![11, 21, 51, 101, 201] } else { sizes };
    for kind in STUDIES {
        for &stations in &sizes {
            let text = cubic_text(stations) + &format!("[[study]]\nkind = \"{kind}\"\nspeed = {{ from = 100, to = 400 }}\n");
            let loaded = match laval::file::load(&text) {
                Ok(loaded) => loaded,
                Err(d) => return println!("{d:?}"),
            };
            let start = Instant::now();
            let done = loaded.studies[0].study.run(&loaded.system, &Context::quiet(kind));
            println!("{kind:20} {stations:5} stations {:9.3} s", start.elapsed().as_secs_f64());
            for (what, count) in done.iter().flat_map(|o| &o.work) {
                println!("    {what}: {count}");
            }
        }
    }
}
