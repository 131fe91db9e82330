//! Reactions of a cavity partly filled with liquid at one frequency, on one core: planar, strip and backward synchronous in closed form, spatial and viscous
//! by harmonics, with the number of harmonics and the estimate of the error. Then stability maps of a machine over speed and fill: planar and strip liquid with complete
//! spectra, spatial and viscous liquid with the roots that grow counted at every point and the boundary located.
//!
//! `cargo bench --workspace --bench liquid`; a word behind `--` leaves out maps whose name does not contain it.

#[path = "common/allocator.rs"]
mod allocator;

#[path = "common/clock.rs"]
mod clock;
#[path = "common/processor.rs"]
mod processor;
#[path = "common/row.rs"]
mod row;

use clock::clock;
use laval::cavity::{Cavity, Tilt, Truncation};
use laval::file::load;
use laval::model::field::RangeValue;
use laval::study::criterion::Criterion;
use laval::study::stability_map::StabilityMap;
use laval::study::support::About;
use laval::study::{Context, ErasedStudy};
use laval_num::complex::{C64, c};
use processor::processor;
use row::row;
use std::hint::black_box;

/// Least time of one evaluation over many rounds, us, and the last result.
fn time<T>(mut f: impl FnMut() -> T) -> (f64, T) {
    let mut last = f();
    let mut least = f64::INFINITY;
    let mut count = 8u32;
    for _ in 0..40 {
        let start = clock();
        for _ in 0..count {
            last = black_box(f());
        }
        let took = clock() - start;
        if took < 2e-3 {
            count *= 2;
        } else {
            least = least.min(took / f64::from(count) * 1e6);
        }
    }
    (least, last)
}

/// A map over speed and fill on one core.
fn map(name: &str, text: &str, points: usize) {
    let system = load(text).unwrap_or_else(|d| panic!("{d:?}")).system;
    let study = StabilityMap {
        speed: RangeValue { from: 100.0, to: 900.0, points: Some(points) },
        parameter: Some(("water.free_surface_radius".into(), RangeValue { from: 0.06, to: 0.135, points: Some(points) })),
        about: About::Rest,
        criterion: Criterion::Growth,
        threshold: 1.0,
        frequency: Some(1000.0),
    };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap_or_else(|e| panic!("{e}"));
    // the clock is that of the thread that works
    let (out, took) = pool.install(|| {
        let start = clock();
        let out = study.run(&system, &Context::quiet("map")).unwrap_or_else(|d| panic!("{d}"));
        (out, clock() - start)
    });
    let edges = out.special_points.iter().filter(|p| p.kind.starts_with("instability")).count();
    row(&format!("stability map {points} by {points}, {name}"), took, None);
    println!("map of {points} by {points}, {name}: {took:.1} s, {edges} points of the boundary");
    for f in out.findings.iter().filter(|f| f.id.contains("counted")) {
        println!("    {f:?}");
    }
}

fn main() {
    println!("processor: {}", processor());
    reactions();
    let only = std::env::args().skip(1).find(|a| !a.starts_with('-')).unwrap_or_default();
    let file = include_str!("../tests/reference/spatial/s1.toml");
    let strip = "model = \"strip\"";
    let viscous = file.replace("density = \"1000", "viscosity = 1e-5\ndensity = \"1000");
    for (name, text, points) in [
        ("planar", file.replace(strip, "model = \"planar\""), 200),
        ("strip", file.to_string(), 200),
        ("viscous", viscous, 40),
        ("spatial", file.replace(strip, "model = \"spatial\""), 40),
    ] {
        if name.contains(&only) {
            map(name, &text, points);
        }
    }
}

fn reactions() {
    let speed = 100.0;
    let cavities = [
        ("G1", Cavity { radius: 0.15, free: 0.105, height: 0.30, density: 1000.0 }),
        ("G2, thin and flat", Cavity { radius: 0.20, free: 0.18, height: 0.06, density: 1000.0 }),
        ("G3, slender", Cavity { radius: 0.06, free: 0.03, height: 0.60, density: 1000.0 }),
    ];
    for (name, cavity) in cavities {
        println!("{name}");
        let w = c(50.0, 10.0);
        println!("    planar: {:.3} us", time(|| cavity.planar(black_box(w), speed)).0);
        let strip = || {
            let l0 = cavity.planar(black_box(w), speed);
            [l0, l0.scale(cavity.slices())]
        };
        println!("    strip: {:.3} us", time(strip).0);
        let backward = || cavity.tilt(black_box(c(-speed, 0.0)), speed, Truncation::None);
        println!("    backward synchronous: {:.3} us", time(backward).0);
        println!("    planar, viscous: {:.3} us", time(|| cavity.planar_viscous(black_box(w), speed, 1e-6)).0);
        let reported = |what: &str, w: C64, (took, tilt): (f64, Tilt<f64>)| {
            let share = took / tilt.harmonics as f64;
            let error = tilt.error / tilt.value.abs();
            println!("    {what} at {} + {} i: {took:.1} us, {} harmonics of {share:.3} us, error {error:.0e}", w.re, w.im, tilt.harmonics);
        };
        for w in [c(50.0, 10.0), c(150.0, -10.0), c(400.0, 0.0), c(-200.0, 0.0), c(-100.001, 0.0)] {
            reported("spatial", w, time(|| cavity.tilt(black_box(w), speed, Truncation::None)));
            reported("spatial, viscous", w, time(|| cavity.tilt_viscous(black_box(w), speed, 1e-6, Truncation::None)));
        }
    }
}
