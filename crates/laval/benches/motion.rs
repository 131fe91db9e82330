//! Motions in time of a shaft of 50 elements on one core: a transient on linear bearings, a run-up on nonlinear ones. Prints the least time of some runs, the steps and the time of one; then
//! errors over times, beside Newmark's method with steps of one length.
//!
//! `cargo bench --workspace --bench motion`

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
use laval::model::system::System;
use laval::solve::motion::trajectory::{Choice, Plan, simulate};
use laval::solve::motion::{Motion, SpinLaw};
use laval::solve::programme::{Programme, Shape};
use laval::solve::reduced_machine::ReducedMachine;
use laval_num::complex::c;
use laval_num::ode::{DenseSolver, Ode, StiffOde};
use processor::processor;
use row::row;

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
        let start = clock();
        let Ok(mut motion) = Motion::new(system, law.clone()) else { return println!("{what}: no motion") };
        if account {
            let _ = motion.keep_account();
        }
        let y = vec![0.0; motion.dim()];
        let Ok(found) = simulate(&mut motion, &y, &plan) else { return println!("{what}: no trajectory") };
        let time = clock() - start;
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
    row(&format!("{what}, tolerance {relative:e}, {} coordinates", system.n()), best.0, None);
}

/// State at the end of a motion from rest, and how long it took, s.
fn adaptive(system: &System, law: &SpinLaw, t_end: f64, relative: f64) -> Option<(Vec<f64>, f64, u64)> {
    let start = clock();
    let plan = Plan {
        t_end,
        choice: Choice::Stiff,
        relative,
        absolute: 0.1 * relative,
        outputs: &[t_end],
        windows: 1,
        rest: &[],
        bound: f64::INFINITY,
        kick: None,
        max_steps: u64::MAX,
        cancel: &|| false,
        progress: &|_| {},
    };
    let mut motion = Motion::new(system, law.clone()).ok()?;
    let y = vec![0.0; motion.dim()];
    let found = simulate(&mut motion, &y, &plan).ok()?;
    Some((found.state, clock() - start, found.run.work.steps + found.run.work.rejected))
}

/// The same by Newmark's method of average acceleration, which is the trapezoidal rule on these equations: steps of one length, a tangent kept for some of them, and as many
/// corrections as leave less than a thousandth of the error of the step.
fn newmark(system: &System, law: &SpinLaw, t_end: f64, steps: usize) -> Option<(Vec<f64>, f64, usize)> {
    let start = clock();
    let mut motion = Motion::new(system, law.clone()).ok()?;
    let (n, h) = (motion.dim(), t_end / steps as f64);
    let mut dense = DenseSolver::default();
    let [mut y, mut f, mut next, mut there, mut step]: [Vec<f64>; 5] = std::array::from_fn(|_| vec![0.0; n]);
    motion.rhs(0.0, &y, &mut f).ok()?;
    let mut corrections = 0;
    for k in 0..steps {
        let (t0, t1) = (h * k as f64, h * (k + 1) as f64);
        if k % 50 == 0 {
            motion.linearise(t0, &y, &mut dense).ok()?;
            motion.factor(2.0 / h, c(2.0 / h, 1.0 / h), &mut dense).ok()?;
        }
        for i in 0..n {
            next[i] = y[i] + h * f[i];
        }
        for _ in 0..10 {
            motion.rhs(t1, &next, &mut there).ok()?;
            let (mut size, mut moved) = (0.0f64, 0.0f64);
            for i in 0..n {
                step[i] = f[i] + there[i] - 2.0 / h * (next[i] - y[i]);
            }
            motion.solve_real(&mut step, &dense);
            for i in 0..n {
                next[i] += step[i];
                (size, moved) = (size.max(next[i].abs()), moved.max(step[i].abs()));
            }
            corrections += 1;
            if moved <= 1e-6 * size {
                break;
            }
        }
        motion.rhs(t1, &next, &mut f).ok()?;
        std::mem::swap(&mut y, &mut next);
    }
    Some((y, clock() - start, corrections))
}

/// Errors of the displacements at the end over times.
fn compared(what: &str, system: &System, law: &SpinLaw, t_end: f64) {
    let Some((exact, ..)) = adaptive(system, law, t_end, 1e-11) else { return println!("{what}: no motion") };
    let size = |x: &[f64]| x[..system.n()].iter().fold(0.0f64, |m, x| m.max(x.abs()));
    let error = |y: &[f64]| y.iter().zip(&exact).take(system.n()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / size(&exact);
    println!("{what}: time and error of the displacements after {t_end} s");
    let mut own: Vec<(f64, f64)> = Vec::new();
    for relative in [1e-4, 1e-6, 1e-8] {
        if let Some((y, time, steps)) = adaptive(system, law, t_end, relative) {
            println!(
                "  adaptive, {relative:e}   {:9.1} ms  error {:8.1e}  {steps:7} steps of {:6.1} us",
                time * 1e3,
                error(&y),
                time * 1e6 / steps as f64
            );
            own.push((error(&y), time));
        }
    }
    for steps in [10_000, 20_000, 40_000, 80_000] {
        if let Some((y, time, corrections)) = newmark(system, law, t_end, steps) {
            let each = time * 1e6 / steps as f64;
            // beside the quickest adaptive run that is at least as exact
            let exact = own.iter().filter(|o| o.0 <= error(&y)).map(|o| o.1).reduce(f64::min);
            if let Some(adaptive) = exact {
                row(&format!("{what}, error {:.0e}", error(&y)), adaptive, Some(("Newmark", time)));
            }
            println!(
                "  Newmark          {:9.1} ms  error {:8.1e}  {steps:7} steps of {each:6.1} us, {corrections} corrections",
                time * 1e3,
                error(&y)
            );
        }
    }
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
        match ReducedMachine::of(&cubic, SPEED) {
            Some(r) => run("the same, reduced", &r.system, &rising, (2.0, relative), account),
            None => println!("it has no reduced machine"),
        }
    }
    compared("two nonlinear bearings, run-up", &cubic, &rising, 2.0);
}
