//! How the cost of whole studies grows with the number of stations of a shaft, on one core: a chain of discs on two nonlinear bearings. Prints the time of one run each.
//!
//! `cargo bench --workspace --bench chains [-- STATIONS... KINDS...]`

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

use clock::clock;
use common::shaft::cubic_text;
use laval::study::Context;
use processor::processor;
use row::row;

/// Kinds with their fields.
const STUDIES: [(&str, &str); 6] = [
    ("modes", ""),
    ("campbell", "speed = { from = 20, to = 400, points = 50 }"),
    ("critical_speeds", "speed = { from = 20, to = 1000 }"),
    ("forced_response", "speed = { from = 100, to = 400 }"),
    ("nonlinear_response", "speed = { from = 100, to = 400 }"),
    ("transient", "duration = \"0.2 s\"\npoints = 1000"),
];

fn main() {
    println!("processor: {}", processor());
    let words: Vec<String> = std::env::args().skip(1).collect();
    let chosen = |kind: &str| !words.iter().any(|w| STUDIES.iter().any(|s| s.0 == w)) || words.iter().any(|w| w == kind);
    let sizes: Vec<usize> = words.iter().filter_map(|w| w.parse().ok()).collect();
    let sizes = if sizes.is_empty() { vec![11, 21, 51, 101, 201] } else { sizes };
    let Ok(one) = rayon::ThreadPoolBuilder::new().num_threads(1).build() else { return println!("no thread") };
    for (kind, fields) in STUDIES.into_iter().filter(|s| chosen(s.0)) {
        let mut base = None;
        for &stations in &sizes {
            let text = cubic_text(stations) + &format!("[[study]]\nkind = \"{kind}\"\n{fields}\n");
            let loaded = match laval::file::load(&text) {
                Ok(loaded) => loaded,
                Err(d) => return println!("{d:?}"),
            };
            let (done, spent) = one.install(|| {
                let start = clock();
                let done = loaded.studies[0].study.run(&loaded.system, &Context::quiet(kind));
                (done, clock() - start)
            });
            println!("{kind:20} {stations:5} stations {spent:9.3} s");
            // beside the same study of the smallest machine
            let first = *base.get_or_insert(spent);
            row(&format!("{kind}, {stations} stations"), spent, Some((&format!("{} stations", sizes[0]), first)));
            for (what, count) in done.iter().flat_map(|o| &o.work) {
                println!("    {what}: {count}");
            }
        }
    }
}
