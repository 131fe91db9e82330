//! The explicit method: orders, closed forms, tolerances.

use super::*;
use std::f64::consts::TAU;

#[test]
fn is_of_order_eight_on_a_forced_problem() {
    let errors: Vec<_> = [8, 16, 32].map(|n| forced_errors(&mut Dop853::new(), 3.2, n)).to_vec();
    let end: Vec<f64> = errors.iter().map(|e| e.0).collect();
    let inside: Vec<f64> = errors.iter().map(|e| e.1).collect();
    let slope: Vec<f64> = errors.iter().map(|e| e.2).collect();
    for (name, errors, order) in [("end", end, 8.0), ("inside", inside, 7.0), ("slope", slope, 6.0)] {
        let found = orders(&errors);
        assert!(found.iter().all(|p| *p > order - 0.4 && *p < order + 2.0), "{name}: {found:?} from {errors:?}");
    }
}

#[test]
fn is_of_order_eight_on_a_nonlinear_non_autonomous_problem() {
    let errors = [10usize, 20, 40].map(|n| {
        let mut y = [Bell::exact(-1.5)];
        integrate(&mut Dop853::new(), &mut Bell, -1.5, &mut y, 1.0, &fixed(2.5 / n as f64), &mut ());
        (y[0] - Bell::exact(1.0)).abs()
    });
    let found = orders(&errors);
    assert!(found.iter().all(|p| *p > 7.5 && *p < 10.0), "{found:?} from {errors:?}");
}

#[test]
fn dense_output_of_one_step_has_local_order_eight() {
    let errors = [0.4, 0.2, 0.1].map(|h| forced_errors(&mut Dop853::new(), h, 1).1);
    let found = orders(&errors);
    assert!(found.iter().all(|p| *p > 7.5 && *p < 9.5), "{found:?} from {errors:?}");
}

/// Planar Kepler problem of eccentricity 0.6 from the pericentre, period 2 pi.
fn kepler() -> impl Ode {
    ode(4, |_, y, dy| {
        let r3 = y[0].hypot(y[1]).powi(3);
        dy.copy_from_slice(&[y[2], y[3], -y[0] / r3, -y[1] / r3]);
    })
}
const PERICENTRE: [f64; 4] = [0.4, 0.0, 0.0, 2.0];

fn energy(y: &[f64]) -> f64 {
    0.5 * (y[2] * y[2] + y[3] * y[3]) - 1.0 / y[0].hypot(y[1])
}

#[test]
fn kepler_keeps_its_energy_and_its_period() {
    let mut y = PERICENTRE;
    let mut drift = 0.0f64;
    let mut watch = |s: &Step<'_>| drift = drift.max((energy(s.y1) + 0.5).abs());
    let run = integrate(&mut Dop853::new(), &mut kepler(), 0.0, &mut y, 10.0 * TAU, &Control::new(1e-12, 1e-12), &mut watch);
    assert_eq!(run.end, End::Reached);
    assert!(drift < 1e-10, "{drift}");
    // the period varies by 6 pi per unit of energy, and the velocity at the pericentre by 1/0.4^2 per unit of time
    assert!(distance(&y, &PERICENTRE) < 10.0 * 3.0 * TAU / 0.16 * drift, "{drift} {y:?}");
}

#[test]
fn runs_backwards_to_where_it_started() {
    let mut y = PERICENTRE;
    let (control, mut method) = (Control::new(1e-11, 1e-12), Dop853::new());
    let there = integrate(&mut method, &mut kepler(), 0.0, &mut y, 7.0, &control, &mut ());
    let back = integrate(&mut method, &mut kepler(), 7.0, &mut y, 0.0, &control, &mut ());
    assert_eq!((there.end, back.end, back.t), (End::Reached, End::Reached, 0.0));
    assert!(distance(&y, &PERICENTRE) < 1e-8, "{y:?}");
}

#[test]
fn error_is_proportional_to_the_tolerance() {
    let errors: Vec<(f64, f64)> = (4..=12)
        .map(|k| {
            let tol = 10f64.powi(-k);
            let mut y = PERICENTRE;
            integrate(&mut Dop853::new(), &mut kepler(), 0.0, &mut y, TAU, &Control::new(tol, tol), &mut ());
            (tol, distance(&y, &PERICENTRE))
        })
        .collect();
    for w in errors.windows(3) {
        let decades = (w[0].1 / w[2].1).log10();
        assert!(decades > 1.2 && decades < 2.8, "{errors:?}");
    }
}

#[test]
fn tolerances_act_state_by_state() {
    // two equal oscillators, the second in units a million times smaller
    let mut twice = ode(4, |_, y, dy| dy.copy_from_slice(&[y[1], -y[0], y[3], -y[2]]));
    let mut one = ode(2, |_, y, dy| dy.copy_from_slice(&[y[1], -y[0]]));
    let (mut y, mut z) = ([1.0, 0.0, 1e-6, 0.0], [1.0, 0.0]);
    let each = Control::new(0.0, vec![1e-9, 1e-9, 1e-15, 1e-15]);
    let a = integrate(&mut Dop853::new(), &mut twice, 0.0, &mut y, 20.0, &each, &mut ());
    let b = integrate(&mut Dop853::new(), &mut one, 0.0, &mut z, 20.0, &Control::new(0.0, 1e-9), &mut ());
    assert_eq!(a.work, b.work);
    assert!((y[2] * 1e6 - y[0]).abs() < 1e-12 && (y[0] - 20f64.cos()).abs() < 1e-7);
    // and a tight relative tolerance on one state alone costs steps
    let each = Control::new(vec![1e-4, 1e-4, 1e-11, 1e-11], vec![1e-4, 1e-4, 1e-17, 1e-17]);
    let mut y = [1.0, 0.0, 1e-6, 0.0];
    let c = integrate(&mut Dop853::new(), &mut twice, 0.0, &mut y, 20.0, &each, &mut ());
    assert!(c.work.steps > b.work.steps && (y[2] * 1e6 - 20f64.cos()).abs() < 1e-9);
}

#[test]
fn work_is_what_the_formula_costs() {
    let mut y = Forced::exact(0.0);
    let run = integrate(&mut Dop853::new(), &mut Forced, 0.0, &mut y, 10.0, &Control::new(1e-8, 1e-10), &mut ());
    let Work { steps, rejected, rhs, jacobians, factorisations, iterations } = run.work;
    // the start and the trial of the first step, twelve an accepted step, eleven a rejected one
    assert_eq!(rhs, 2 + 12 * steps + 11 * rejected);
    assert_eq!((jacobians, factorisations, iterations), (0, 0, 0));
    assert!(distance(&y, &Forced::exact(10.0)) < 1e-7 && steps < 60, "{:?}", run.work);
}

/// Two masses in the plane joined by a hardening spring c0 d + c1 d^3 per axis, the second on a soft spring, the first driven by a rotating force
/// growing with the square of the speed (base set of the planar rotor, SI). States (x1, x2, y1, y2) and their rates.
struct Driven {
    speed: f64,
    damping: f64,
    eccentricity: f64,
}

impl Ode for Driven {
    fn dim(&self) -> usize {
        8
    }
    fn rhs(&mut self, t: f64, y: &[f64], dy: &mut [f64]) -> Result<(), Failure> {
        let (s, c) = (self.speed * t).sin_cos();
        let force = 2.4 * self.eccentricity * self.speed * self.speed;
        for (axis, drive) in [(0, c), (2, s)] {
            let (d, v) = (y[axis] - y[axis + 1], &y[4 + axis..6 + axis]);
            let spring = d * (1.1e7 + 8.7e10 * d * d);
            (dy[axis], dy[axis + 1]) = (v[0], v[1]);
            dy[4 + axis] = (force * drive - self.damping * v[0] - spring) / 2.4;
            dy[5 + axis] = (spring - 6.59 * v[1] - 3.26e5 * y[axis + 1]) / 25.0;
        }
        Ok(())
    }
}

#[test]
fn a_forced_nonlinear_transient_agrees_with_other_programs() {
    // x1, y1 after 250 periods from rest, known to 5e-10 from other programs of order 8
    for (speed, damping, eccentricity, x, y) in [
        (275.0, 42.0, 1e-3, -9.0107751689e-5, 6.675835849e-7),
        (1775.0, 42.0, 1e-3, 1.36026417963e-3, 4.8356411572e-4),
        (2775.0, 42.0, 1e-3, 9.70244253793e-3, -1.90103807740e-3),
        (4775.0, 42.0, 1e-3, -1.34170302347e-3, -2.80175434056e-3),
        (2275.0, 420.0, 1e-5, -4.59068183905e-5, -1.11014124666e-4),
        (4775.0, 420.0, 1e-5, -1.25694543483e-5, -3.3576859092e-6),
    ] {
        let mut state = [0.0; 8];
        let mut absolute = vec![1e-16; 4];
        absolute.extend([1e-13; 4]);
        let mut system = Driven { speed, damping, eccentricity };
        let t1 = 250.0 * TAU / speed;
        let run = integrate(&mut Dop853::new(), &mut system, 0.0, &mut state, t1, &Control::new(1e-12, absolute), &mut ());
        assert_eq!(run.end, End::Reached);
        let (error, size) = (distance(&[state[0], state[2]], &[x, y]), f64::hypot(x, y));
        assert!(error < 1e-9 * size, "{speed}: {:e} {:?}", error / size, run.work);
    }
}
