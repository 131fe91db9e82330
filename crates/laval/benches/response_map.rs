//! A map of responses of the planar machine on one core (empty, per-axis law, 25 to 8000 rad/s, orders to 7, folds and stability at every point) over
//! eccentricity and damping, beside the same responses computed one by one with `nonlinear_response`. Prints responses per second and the ratio.
//!
//! `cargo bench --workspace --bench response_map -- 10` computes 10 by 10 machines (the default); 100 computes all 10 000.

#[path = "common/allocator.rs"]
mod allocator;

#[path = "common/clock.rs"]
mod clock;
#[path = "../tests/common/mod.rs"]
mod common;
#[path = "common/processor.rs"]
mod processor;
#[path = "common/row.rs"]
mod row;

// studies may work on threads of their own
use clock::all_threads as clock;
use laval::model::field::RangeValue;
use laval::outcome::Outcome;
use laval::solve::harmonic::branches::response::Request;
use laval::study::nonlinear_response::NonlinearResponse;
use laval::study::response_map::{ParameterAxis, ResponseMap};
use laval::study::{Context, ErasedStudy};
use processor::processor;
use row::row;

/// Responses computed one by one at most.
const SINGLE: usize = 100;

fn number(o: &Outcome, column: &str, row: usize) -> f64 {
    o.find_table("map").and_then(|t| t.column(column)).and_then(|c| c.number(row)).unwrap_or(f64::NAN)
}

fn main() {
    let side: usize = std::env::args().filter_map(|a| a.parse().ok()).next().unwrap_or(10).max(2);
    let system = match common::Base::default().builder().build() {
        Ok(s) => s,
        Err(d) => return println!("{d:?}"),
    };
    let axis = |path: &str, unit, from, to| ParameterAxis {
        path: path.into(),
        unit,
        range: RangeValue { from, to, points: Some(side) },
        logarithmic: true,
    };
    let request = Request { harmonics: Some(7), max_points: 20_000, ..Request::over(25.0, 8000.0) };
    let axes = [axis("drum.eccentricity", "m", 1e-5, 1e-3), axis("air.damping", "N s/m", 20.0, 1000.0)];
    let study = ResponseMap { axes, request };
    println!("processor: {}", processor());
    let Ok(one) = rayon::ThreadPoolBuilder::new().num_threads(1).build() else { return println!("no thread") };
    let (outcome, spent) = one.install(|| {
        let start = clock();
        (study.run(&system, &Context::quiet("map")), clock() - start)
    });
    let outcome = match outcome {
        Ok(o) => o,
        Err(d) => return println!("{d:?}"),
    };
    let cells = side * side;
    println!("{cells} responses in {spent:.1} s of one core: {:.1} responses/s", cells as f64 / spent);
    for f in &outcome.findings {
        println!("    {}", f.sentence());
    }
    println!("    points: {}", outcome.work.get("points").copied().unwrap_or(0));

    let values = study.axes.each_ref().map(ParameterAxis::values);
    let chosen: Vec<usize> = (0..cells.min(SINGLE)).map(|k| k * cells / cells.min(SINGLE)).collect();
    let single = NonlinearResponse::new(request);
    let (mut alone, mut points, mut compared) = (0.0, 0.0, 0.0);
    for &row in &chosen {
        let (e, chi) = (values[0][row % side], values[1][row / side]);
        let machine = match system.with(&[("drum.eccentricity", e), ("air.damping", chi)]) {
            Ok(m) => m,
            Err(d) => return println!("{d:?}"),
        };
        let start = clock();
        let o = single.run(&machine, &Context::quiet("single"));
        alone += clock() - start;
        points += o.map_or(f64::NAN, |o| o.work.get("points").copied().unwrap_or(0) as f64);
        compared += number(&outcome, "points", row);
    }
    let each = [spent / cells as f64, alone / chosen.len() as f64];
    row("one response in a map of them", each[0], Some(("alone", each[1])));
    println!(
        "{} of them one by one: {:.2} ms each, {:.1} us per point; in the map {:.2} ms each, {:.1} us per point; points agree: {}",
        chosen.len(),
        1e3 * alone / chosen.len() as f64,
        1e6 * alone / points,
        1e3 * spent / cells as f64,
        1e6 * spent / outcome.work.get("points").copied().unwrap_or(1) as f64,
        points == compared
    );
}
