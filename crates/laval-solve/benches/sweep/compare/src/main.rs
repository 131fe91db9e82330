//! The sweep benchmark (`../main.rs`) by Rust crates for differential equations: case by case the same equations, tolerances and periods, in
//! microseconds of one core per speed and period. Each deviation is from the converged end state of the first speed listed there.

#[path = "../../../../../laval/benches/common/clock.rs"]
mod clock;

use clock::clock;
use differential_equations::prelude::*;
use diffsol::{NalgebraMat, OdeBuilder, OdeSolverMethod, OdeSolverStopReason, Vector, VectorCommon};
use nalgebra::SVector;
use std::f64::consts::TAU;

type State8 = SVector<f64, 8>;

const MASS: f64 = 2.4;
const BASE: f64 = 25.0;
const C0: f64 = 1.1e7;
const C1: f64 = 8.7e10;
const C2: f64 = 3.26e5;
const CHI0: f64 = 6.59;
const PERIODS: f64 = 250.0;
const RELATIVE: f64 = 1e-8;
const ABSOLUTE: f64 = 1e-11;

struct Machine {
    damping: f64,
    eccentricity: f64,
    speed: f64,
}

impl Machine {
    fn rates(&self, t: f64, y: &[f64], d: &mut [f64]) {
        let (sin, cos) = (self.speed * t).sin_cos();
        let (dx, dy) = (y[0] - y[2], y[1] - y[3]);
        let (fx, fy) = (dx * (C0 + C1 * dx * dx), dy * (C0 + C1 * dy * dy));
        let force = self.eccentricity * self.speed * self.speed;
        d[..4].copy_from_slice(&y[4..8]);
        d[4] = force * cos - (self.damping * y[4] + fx) / MASS;
        d[5] = force * sin - (self.damping * y[5] + fy) / MASS;
        d[6] = (fx - C2 * y[2] - CHI0 * y[6]) / BASE;
        d[7] = (fy - C2 * y[3] - CHI0 * y[7]) / BASE;
    }
    fn end(&self) -> f64 {
        PERIODS * TAU / self.speed
    }
}

impl ODE<f64, State8> for Machine {
    fn diff(&self, t: f64, y: &State8, dydt: &mut State8) {
        self.rates(t, y.as_slice(), dydt.as_mut_slice());
    }
}

/// End state by `differential-equations`; only the end is kept.
fn by_differential_equations(machine: &Machine) -> Option<Vec<f64>> {
    let mut solver = ExplicitRungeKutta::dop853().rtol(RELATIVE).atol(ABSOLUTE).max_steps(100_000_000);
    let end = machine.end();
    let problem = ODEProblem::new(machine, 0.0, end, State8::zeros());
    let solution = problem.t_eval(vec![end]).solve(&mut solver).ok()?;
    solution.y.last().map(|y| y.as_slice().to_vec())
}

/// End state by `diffsol`: its best explicit method is of order 5.
fn by_diffsol(machine: &Machine) -> Option<Vec<f64>> {
    let end = machine.end();
    let problem = OdeBuilder::<NalgebraMat<f64>>::new()
        .rtol(RELATIVE)
        .atol([ABSOLUTE])
        .rhs(|y, _, t, dy| machine.rates(t, y.inner().as_slice(), dy.inner_mut().as_mut_slice()))
        .init(|_, _, y| y.inner_mut().fill(0.0), 8)
        .build()
        .ok()?;
    let mut solver = problem.tsit45().ok()?;
    solver.set_stop_time(end).ok()?;
    while solver.step().ok()? != OdeSolverStopReason::TstopReached {}
    Some(solver.state().y.inner().as_slice().to_vec())
}

fn main() {
    // converged end states of the rotor at one speed
    let cases =
        [("A", 42.0, 1e-3, 275.0, -9.0107751689e-5, 6.675835849e-7), ("B", 420.0, 1e-5, 2275.0, -4.59068183905e-5, -1.11014124666e-4)];
    type Way = fn(&Machine) -> Option<Vec<f64>>;
    let ways: [(&str, Way); 2] = [("differential-equations", by_differential_equations), ("diffsol, order 5", by_diffsol)];
    for (case, damping, eccentricity, known, x, y) in cases {
        println!("case {case}");
        for (name, way) in ways {
            let (mut count, mut deviation) = (0, f64::NAN);
            let start = clock();
            for i in 1..=200 {
                let speed = 25.0 * f64::from(i);
                let Some(end) = way(&Machine { damping, eccentricity, speed }) else { continue };
                count += 1;
                if speed == known {
                    deviation = (end[0] - x).hypot(end[1] - y) / f64::hypot(x, y);
                }
            }
            let cost = (clock() - start) * 1e6 / (f64::from(count) * PERIODS);
            println!("    {name:24} {cost:9.2} us per speed and period, {count} speeds, deviation {deviation:.1e}");
        }
    }
}
