//! How the cost of linear studies grows with the number of stations of a shaft, on one core, beside all modes by full matrices. Prints the least time of some runs.
//!
//! `cargo bench --workspace --bench stations -- 51` (numbers of stations; several sizes where none is given)

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
use common::shaft::shaft;
use laval::solve::criticals::criticals;
use laval::solve::linear_response::responses;
use laval::solve::pencil::Linearised;
use laval::solve::rest::rest;
use laval::solve::roots::{Request, roots};
use laval::solve::statics::own;
use laval::solve::statics::supports::supports;
use laval::solve::support_map::{Spin, SupportMap};
use laval::solve::sweep::sweep;
use processor::processor;
use row::row;

const SPEED: f64 = 314.0;
/// Full matrices of more stations take minutes.
const FULL: usize = 51;

fn least<T>(runs: usize, mut f: impl FnMut() -> T) -> (f64, Option<T>) {
    let mut out = (f64::INFINITY, None);
    for _ in 0..runs {
        let start = clock();
        let found = f();
        out = (out.0.min((clock() - start) * 1e3), Some(found));
    }
    out
}

fn main() {
    println!("processor: {}", processor());
    println!(
        "stations  coordinates  modes  modes, counted  their number  50 speeds  criticals  200 responses  20 stiffnesses  all modes, full (ms)"
    );
    let given: Vec<usize> = std::env::args().filter_map(|a| a.parse().ok()).collect();
    for stations in if given.is_empty() { vec![26, 51, 101, 201, 501, 998] } else { given } {
        let system = shaft(stations, true, false);
        let state = |w: f64| rest(&system, w);
        let runs = if stations > 300 { 2 } else { 10 };
        let Ok(about) = state(SPEED) else { return println!("no rest") };
        let uncounted = Request { evaluations: Some(0), ..Request::default() };
        let (alone, _) = least(runs, || roots(&system, &about, &uncounted));
        let (modes, found) = least(runs, || roots(&system, &about, &Request::default()));
        let count = found.and_then(Result::ok).map_or(0, |r| r.spectrum.modes.len());
        let speeds: Vec<f64> = (0..50).map(|k| 20.0 + 10.0 * f64::from(k)).collect();
        let (campbell, followed) = least(runs, || sweep(&system, &state, &speeds, 1600.0, |_, _| true));
        let crossings = |f| least(1, || criticals(&system, &state, f, &[1.0])).0;
        let critical = followed.and_then(Result::ok).as_ref().map_or(f64::NAN, crossings);
        let many: Vec<f64> = (0..200).map(|k| 20.0 + 2.5 * f64::from(k)).collect();
        let (responses, _) = least(runs, || responses(&system, &state, &many).iter().filter(|r| r.is_ok()).count());
        // four critical speeds at each stiffness of the supports, from the assembly on
        let supported = shaft(stations, false, false);
        let (map, _) = least(runs, || {
            let at = own(&supported, SPEED).ok()?;
            let map = SupportMap::new(&supported, &supports(&supported, &at), &at).ok()?;
            Some((0..20).map(|k| map.roots(1e5 * 2f64.powi(k), Spin::Synchronous, (0, 4)).len()).sum::<usize>())
        });
        let full = if stations > FULL { f64::NAN } else { least(1, || Linearised::new(&system, &about).map(|l| l.spectrum().is_ok())).0 };
        let beside = full.is_finite().then_some(("all modes, full matrices", full * 1e-3));
        row(&format!("modes, {stations} stations"), alone * 1e-3, beside);
        row(&format!("50 speeds, {stations} stations"), campbell * 1e-3, Some(("50 times the modes of one", 0.05 * alone)));
        row(&format!("200 responses, {stations} stations"), responses * 1e-3, None);
        println!(
            "{stations:8}  {:11}  {alone:5.2}  {modes:14.2}  {count:12}  {campbell:9.1}  {critical:9.1}  {responses:13.1}  {map:14.1}  {full:12.1}",
            system.n()
        );
    }
}
