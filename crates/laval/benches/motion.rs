//! Motions in time of a shaft of 50 elements on one core: a transient on linear bearings, a run-up on nonlinear ones. Prints the least time of some runs, the steps and the time of one.
//!
//! `cargo bench -p laval --bench motion`

#[path = "common/processor.rs"]
mod processor;

use laval::model::system::System;
use laval::solve::motion::trajectory::{Choice, Plan, simulate};
use laval::solve::motion::{Motion, SpinLaw};
use laval::solve::programme::{Programme, Shape};
use processor::processor;
use std::time::Instant;

const OUTPUTS: usize = 10_000;
const SPEED: f64 = 314.0;

fn machine(bearing: &str) -> String {
    let mut text = String::from(
        "[machine]\nname = \"shaft\"\nspeed = \"3000 rpm\"\naxis = \"horizontal\"\n\
         [[part]]\nkind = \"shaft\"\nname = \"s\"\nmaterial = \"steel\"\nelements = 50\n[[part.section]]\nlength = 1.5\nouter_diameter = 0.05\n\
         [[part]]\nkind = \"disc\"\nname = \"d\"\non = { body = \"s\", at = 0.75 }\nmass = 20.0\npolar_inertia = 0.2\ndiametral_inertia = 0.1\nunbalance = \"200 g mm\"\n",
    );
    for (k, at) in [0.0, 1.5].into_iter().enumerate() {
        text += &format!(
            "[[part]]\nname = \"b{k}\"\nbetween = [{{ body = \"s\", at = {at:?} }}, \"ground\"]\n{bearing}\n\
             [[part]]\nkind = \"damper\"\nname = \"c{k}\"\nbetween = [{{ body = \"s\", at = {at:?} }}, \"ground\"]\ndamping = 300.0\n"
        );
    }
    text
}

fn system(bearing: &str) -> System {
    laval::file::load(&machine(bearing)).unwrap_or_else(|d| panic!("{d:?}")).system
}

fn run(what: &str, system: &System, law: &SpinLaw, (t_end, relative): (f64, f64), account: bool) {
    let outputs: Vec<f64> = (1..=OUTPUTS).map(|k| t_end * k as f64 / OUTPUTS as f64).collect();
    let plan = Plan {
        t_end,
        choice: Choice::Auto,
        relative,
        absolute: 0.1 * relative,
        outputs: &outputs,
        windows: 400,
        rest: &[],
        bound: f64::INFINITY,
        kick: None,
        max_steps: u64::MAX,
        cancel: &|| false,
        progress: &|_| {},
    };
    let mut best = (f64::INFINITY, String::new());
    for _ in 0..3 {
        let start = Instant::now();
        let Ok(mut motion) = Motion::new(system, law.clone()) else { return println!("{what}: no motion") };
        if account {
            let _ = motion.keep_account();
        }
        let y = vec![0.0; laval_num::ode::Ode::dim(&motion)];
        let Ok(found) = simulate(&mut motion, &y, &plan) else { return println!("{what}: no trajectory") };
        let time = start.elapsed().as_secs_f64();
        let work = found.run.work;
        let steps = work.steps + work.rejected;
        let line = format!(
            "{:9.1} ms  {steps:6} steps of {:6.1} us  {:7} evaluations  {}  {:?}",
            time * 1e3,
            time * 1e6 / steps as f64,
            work.rhs,
            if found.stiff { "implicit" } else { "explicit" },
            found.run.end
        );
        if time < best.0 {
            best = (time, line);
        }
    }
    println!("{what:45} {:4} coordinates  {}", system.n(), best.1);
}

fn main() {
    println!("processor: {}; {OUTPUTS} outputs", processor());
    let constant = SpinLaw::Programme(Programme::constant(SPEED, 0.0));
    let rising = SpinLaw::Programme(Programme::ramp(50.0, SPEED, 2.0, Shape::Linear, 0.0).unwrap_or_else(|_| panic!("no programme")));
    let linear = system("kind = \"bearing_linear\"\nkxx = 2e6\nkyy = 3e6");
    let cubic = system("kind = \"bearing_cubic\"\nlaw = \"isotropic\"\nstiffness = 2e6\ncubic_stiffness = 1e12");
    for (relative, account) in [(1e-4, false), (1e-6, false), (1e-8, false), (1e-8, true)] {
        println!("relative tolerance {relative:e}{}", if account { ", with energy account" } else { "" });
        run("linear, constant speed, 1 s", &linear, &constant, (1.0, relative), account);
        run("linear, run-up, 2 s", &linear, &rising, (2.0, relative), account);
        run("two nonlinear bearings, run-up, 2 s", &cubic, &rising, (2.0, relative), account);
    }
}
