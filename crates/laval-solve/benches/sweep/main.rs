//! The sweep benchmark: 200 speeds 25, 50 .. 5000 rad/s of the planar machine on cubic bearings, 250 forcing periods each from rest, relative
//! tolerance 1e-8, absolute 1e-11, in microseconds of one core per speed and period.
//!
//! The machine is built from parts and goes through the generic ensemble; beside it run a kernel written by hand for this machine in the same
//! lanes ([`kernel`]), and laval's one-member integrator. `benches/sweep/compare/compare.sh` adds other programs on the same work.
//!
//! `cargo bench --workspace --bench sweep [-- source | alone]`; with `source` also the complete study of the source document: 5000 speeds, 25 s each;
//! with `alone` only one member at a time.

#[path = "../../../laval/benches/common/clock.rs"]
mod clock;
mod kernel;
#[path = "../../../laval/benches/common/processor.rs"]
mod processor;
#[path = "../../../laval/benches/common/row.rs"]
mod row;

use clock::{clock, wall};
use laval_model::model::builder::Builder;
use laval_model::model::field::Attach;
use laval_model::model::part::Link;
use laval_model::model::system::System;
use laval_model::parts::{bearing_cubic::*, damper::*, disc::*, foundation::*};
use laval_num::lanes::Level;
use laval_num::ode::{Control, Dop853, integrate};
use laval_solve::ensemble::{self, Ended, EnsembleTask, Form, Leg, Next, Settings, Start};
use laval_solve::motion::{Motion, SpinLaw};
use laval_solve::programme::Programme;
use processor::processor;
use row::row;
use std::f64::consts::TAU;
use std::sync::Arc;

/// A case of the benchmark: damping of the rotor (N s/m) and eccentricity (m).
#[derive(Clone, Copy)]
pub struct Case {
    name: &'static str,
    damping: f64,
    eccentricity: f64,
    /// Converged end states: speed, x and y of the rotor after 250 periods, m.
    converged: &'static [(f64, f64, f64)],
}

const CASES: [Case; 2] = [
    Case {
        name: "A",
        damping: 42.0,
        eccentricity: 1e-3,
        converged: &[
            (275.0, -9.0107751689e-5, 6.675835849e-7),
            (1775.0, 1.36026417963e-3, 4.8356411572e-4),
            (2775.0, 9.70244253793e-3, -1.90103807740e-3),
            (4775.0, -1.34170302347e-3, -2.80175434056e-3),
        ],
    },
    Case {
        name: "B",
        damping: 420.0,
        eccentricity: 1e-5,
        converged: &[(2275.0, -4.59068183905e-5, -1.11014124666e-4), (4775.0, -1.25694543483e-5, -3.3576859092e-6)],
    },
];

fn machine(case: Case) -> Option<System> {
    let joint = Link::Between(Attach::on("drum"), Attach::on("base"));
    let ground = Link::Between(Attach::on("drum"), Attach::ground());
    let law = BearingCubicParams { stiffness: [1.1e7; 2], cubic_stiffness: [8.7e10; 2], valid_to: 0.0 };
    let built = Builder::new("planar rotor of the sweep benchmark")
        .part("drum", Disc::planar(), DiscParams { eccentricity: case.eccentricity, ..DiscParams::new(2.4) })
        .part("base", Foundation, FoundationParams { mass: 25.0, stiffness: [3.26e5; 2], damping: [6.59; 2] })
        .part("bearing", BearingCubic::per_axis(joint), law)
        .part("air", Damper::fixed(ground), DamperParams { damping: [case.damping; 2], tilt_damping: 0.0 })
        .build();
    built.map_err(|d| println!("{d:?}")).ok()
}

/// From rest at each speed.
struct FromRest {
    system: Arc<System>,
    speeds: Vec<f64>,
    /// Seconds at a speed.
    span: fn(f64) -> f64,
    tolerance: f64,
}

/// State at the end, and steps.
type Row = (Vec<f64>, u64);

impl EnsembleTask for FromRest {
    type Log = ();
    type Row = Row;
    fn start(&self, index: usize) -> Result<Start<()>, Row> {
        let speed = self.speeds[index];
        let n = 2 * self.system.n() + self.system.m();
        Ok(Start {
            system: self.system.clone(),
            law: SpinLaw::Programme(Programme::constant(speed, 0.0)),
            y: vec![0.0; n],
            relative: self.tolerance,
            absolute: vec![self.tolerance * 1e-3; n],
            leg: Leg::new(0.0, (self.span)(speed)),
            log: (),
        })
    }
    fn ended(&self, _: usize, (): &mut (), ended: &Ended, y: &mut [f64]) -> Next<Row> {
        Next::Done((y.to_vec(), ended.steps + ended.rejected))
    }
}

const PERIODS: f64 = 250.0;

fn periods(speed: f64) -> f64 {
    PERIODS * TAU / speed
}

fn deviation(case: Case, speeds: &[f64], ends: &[Row]) -> f64 {
    let mut worst = 0.0f64;
    for &(speed, x, y) in case.converged {
        let Some(k) = speeds.iter().position(|&s| s == speed) else { return f64::NAN };
        let d = ((ends[k].0[0] - x).powi(2) + (ends[k].0[1] - y).powi(2)).sqrt() / x.hypot(y);
        worst = if d <= worst { worst } else { d };
    }
    worst
}

/// Least time of some runs, s, and the last result.
fn least<T>(clock: fn() -> f64, runs: usize, mut f: impl FnMut() -> T) -> (f64, T) {
    let (mut best, mut last) = (f64::INFINITY, None);
    for _ in 0..runs {
        let start = clock();
        let result = f();
        best = best.min(clock() - start);
        last = Some(result);
    }
    (best, last.unwrap_or_else(f))
}

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    println!("processor: {}, lanes: {}", processor(), Level::best().name());
    let speeds: Vec<f64> = (1..=200).map(|i| 25.0 * f64::from(i)).collect();
    let work = speeds.len() as f64 * PERIODS;
    for case in CASES {
        let Some(system) = machine(case) else { return };
        let system = Arc::new(system);
        println!("case {}: damping {} N s/m, eccentricity {} m", case.name, case.damping, case.eccentricity);
        if arguments.iter().any(|a| a == "alone") {
            let (time, ends) = least(clock, 5, || one_by_one(&system, &speeds));
            report("one member at a time", time, work, None, deviation(case, &speeds, &ends), &ends);
            continue;
        }
        let by_hand = kernel::Machine { damping: case.damping, eccentricity: case.eccentricity };
        let (hand, ends) = least(clock, 5, || by_hand.sweep(Level::best(), &speeds, periods, 1e-8, 1e-11));
        report("by hand, lanes", hand, work, None, deviation(case, &speeds, &ends), &ends);
        for level in Level::supported() {
            let task = FromRest { system: system.clone(), speeds: speeds.clone(), span: periods, tolerance: 1e-8 };
            let (time, ends) = least(clock, 5, || {
                let settings = Settings { level, threads: 1, ..Settings::default() };
                ensemble::run(&task, &system, Form::of(&system, true), 0..speeds.len(), settings).unwrap_or_default()
            });
            report(&format!("ensemble, {}", level.name()), time, work, Some(hand), deviation(case, &speeds, &ends), &ends);
        }
        let task = FromRest { system: system.clone(), speeds: speeds.clone(), span: periods, tolerance: 1e-8 };
        let (time, ends) = least(wall, 3, || {
            ensemble::run(&task, &system, Form::of(&system, true), 0..speeds.len(), Settings::default()).unwrap_or_default()
        });
        let threads = std::thread::available_parallelism().map_or(1, |n| n.get());
        report(&format!("ensemble, {threads} threads"), time, work, Some(hand), deviation(case, &speeds, &ends), &ends);
        let (time, ends) = least(clock, 3, || one_by_one(&system, &speeds));
        report("one member at a time", time, work, Some(hand), deviation(case, &speeds, &ends), &ends);
        let fine = FromRest { system: system.clone(), speeds: speeds.clone(), span: periods, tolerance: 1e-12 };
        let ends = ensemble::run(&fine, &system, Form::of(&system, true), 0..speeds.len(), Settings::default()).unwrap_or_default();
        println!("    at tolerance 1e-12: deviation from the converged states {:.1e}", deviation(case, &speeds, &ends));
    }
    if arguments.iter().any(|a| a == "source") {
        source_study();
    }
}

/// 5000 speeds, 25 s each, from rest.
fn source_study() {
    let case = CASES[0];
    let Some(system) = machine(case) else { return };
    let system = Arc::new(system);
    let speeds: Vec<f64> = (1..=5000).map(f64::from).collect();
    println!("the complete study of the source: 5000 speeds, 25 s each, case A");
    let task = FromRest { system: system.clone(), speeds: speeds.clone(), span: |_| 25.0, tolerance: 1e-8 };
    let run = |threads| {
        let settings = Settings { threads, ..Settings::default() };
        ensemble::run(&task, &system, Form::of(&system, true), 0..5000, settings).unwrap_or_default()
    };
    let (time, ends) = least(wall, 1, || run(1));
    let steps: u64 = ends.iter().map(|e| e.1).sum();
    println!("    ensemble, 1 thread:  {time:.1} s, {steps} steps");
    let threads = std::thread::available_parallelism().map_or(1, |n| n.get());
    let (shared, again) = least(wall, 1, || run(threads));
    println!("    ensemble, {threads} threads: {shared:.1} s, {:.2} times as fast, end states the same: {}", time / shared, again == ends);
    let by_hand = kernel::Machine { damping: case.damping, eccentricity: case.eccentricity };
    let (time, ends) = least(clock, 1, || by_hand.sweep(Level::best(), &speeds, |_| 25.0, 1e-8, 1e-11));
    let steps: u64 = ends.iter().map(|e| e.1).sum();
    println!("    by hand, 1 thread:   {time:.1} s, {steps} steps");
}

fn one_by_one(system: &System, speeds: &[f64]) -> Vec<Row> {
    let mut method = Dop853::new();
    let mut rows = Vec::new();
    for &speed in speeds {
        let Ok(mut motion) = Motion::new(system, SpinLaw::Programme(Programme::constant(speed, 0.0))) else { continue };
        let mut y = vec![0.0; 2 * system.n() + system.m()];
        let run = integrate(&mut method, &mut motion, 0.0, &mut y, periods(speed), &Control::new(1e-8, 1e-11), &mut ());
        rows.push((y, run.work.steps + run.work.rejected));
    }
    rows
}

fn report(what: &str, time: f64, work: f64, hand: Option<f64>, deviation: f64, ends: &[Row]) {
    let steps: u64 = ends.iter().map(|e| e.1).sum();
    let per_step = time * 1e9 / steps as f64;
    let ratio = hand.map_or(String::new(), |h| format!(", {:.2} of by hand", time / h));
    row(&format!("sweep of 200 speeds, {what}"), time, hand.map(|h| ("by hand, lanes", h)));
    println!("    {what:24} {:7.2} us per speed and period{ratio}, {per_step:.0} ns a step, deviation {deviation:.1e}", time * 1e6 / work);
}
