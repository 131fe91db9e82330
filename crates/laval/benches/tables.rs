//! Writing a table of a million rows and eight columns as CSV and as Parquet, to a sink: seconds of all processors and on the wall clock. `tools/benches` puts pyarrow beside it.
//!
//! `cargo bench --workspace --bench tables -- 1000000` (rows)

#[path = "common/allocator.rs"]
mod allocator;

#[path = "common/clock.rs"]
mod clock;

#[path = "common/processor.rs"]
mod processor;

#[path = "common/row.rs"]
mod row;

use clock::{all_threads, wall};
use laval::outcome::Table;
use processor::processor;
use row::row;

const COLUMNS: usize = 8;

/// Decaying oscillations, as a transient has them.
fn table(rows: usize) -> Option<Table> {
    let t: Vec<f64> = (0..rows).map(|i| 20.0 * i as f64 / rows as f64).collect();
    let column = |k: usize| -> Vec<f64> {
        t.iter().map(|t| 1e-4 * (-0.05 * t).exp() * (300.0 * t + k as f64).sin() + 1e-6 * (1234.5 * t * k as f64).cos()).collect()
    };
    let start = Table::new("motion", "Motion").float("t", "s", "time", t.clone());
    (1..COLUMNS)
        .fold(start, |table, k| table.float(format!("x{k}"), "m", "displacement", column(k)))
        .build()
        .map_err(|e| println!("{e:?}"))
        .ok()
}

fn main() {
    println!("processor: {}", processor());
    let rows = std::env::args().filter_map(|a| a.parse().ok()).next().unwrap_or(1_000_000);
    let Some(table) = table(rows) else { return };
    let timed = |what: &str, write: &dyn Fn() -> usize| {
        let start = [wall(), all_threads()];
        let bytes = write();
        let [passed, spent] = [wall() - start[0], all_threads() - start[1]];
        println!("{what:8} {passed:7.3} s, {spent:7.3} s of processors, {:.1} MB", 1e-6 * bytes as f64);
        row(&format!("{what} of {rows} rows, {COLUMNS} columns"), spent, None);
    };
    timed("CSV", &|| laval::report::csv(&table).len());
    #[cfg(feature = "parquet")]
    timed("Parquet", &|| laval::report::parquet(&table).map_or(0, |b| b.len()));
}
