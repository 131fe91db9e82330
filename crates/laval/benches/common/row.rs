//! Rows of the table of all benchmarks (`tools/benches`).

use std::io::Write;

/// Appends a row to the file that `LAVAL_BENCH_ROWS` names: work, its time, s, and the work beside it with its time. Nothing without that variable.
pub fn row(work: &str, seconds: f64, beside: Option<(&str, f64)>) {
    let Some(path) = std::env::var_os("LAVAL_BENCH_ROWS") else { return };
    let (name, other) = beside.map_or(("", String::new()), |(name, t)| (name, t.to_string()));
    let written = std::fs::OpenOptions::new()
        .append(true)
        .create(true)
        .open(path)
        .and_then(|mut f| writeln!(f, "{work}\t{seconds}\t{name}\t{other}"));
    if let Err(e) = written {
        println!("a row of the table cannot be written: {e}");
    }
}
