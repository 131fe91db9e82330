//! Motions of machines with many coordinates, whose matrices are kept as entries: their equations, the linear solves of the implicit method, and the motions themselves against the
//! reduced machine and the response to unbalance.

use crate::common::files::load;
use crate::common::shaft::{cubic, isotropic};
use laval::model::part::{At, DofKind, Rows};
use laval::model::system::{Axis, GRAVITY, System, Workspace};
use laval::solve::linear_response::response;
use laval::solve::motion::trajectory::{Choice, Plan, Trajectory, simulate};
use laval::solve::motion::{Motion, SpinLaw};
use laval::solve::programme::{Programme, Shape};
use laval::solve::reduced_machine::ReducedMachine;
use laval::solve::rest::rest;
use laval_num::complex::{C64, c};
use laval_num::dense::Mat;
use laval_num::ode::{Control, DenseSolver, End, Ode, Radau, StiffOde, integrate};

/// A lying shaft on cubic bearings with a cavity part filled with liquid, whose waves are internal states; on request a table over the speed, whose matrices have to be assembled at each speed, and
/// a load of another spin.
fn with_liquid(table: bool, other: bool) -> System {
    let mut text = String::from(
        "[machine]\nname = \"bowl\"\nspeed = 300.0\naxis = \"horizontal\"\n\
         [[part]]\nkind = \"shaft\"\nname = \"s\"\nelements = 24\nrotating_damping = 1e-5\nsection = { length = [0.7], outer_diameter = [0.05] }\n\
         [[part]]\nkind = \"disc\"\nname = \"bowl\"\non = { body = \"s\", at = 0.5 }\nmass = 9.0\npolar_inertia = 0.1\ndiametral_inertia = 0.07\nunbalance = 3e-4\n\
         [[part]]\nkind = \"liquid\"\nname = \"milk\"\nin = \"bowl\"\nmodel = \"strip\"\ncavity_radius = 0.1\ncavity_height = 0.08\ndensity = 1030.0\nfill = { free_surface_radius = 0.09 }\nwave_damping = 5.0\n",
    );
    for (k, at) in [0.0, 0.7].into_iter().enumerate() {
        text += &format!(
            "[[part]]\nkind = \"bearing_cubic\"\nname = \"b{k}\"\nbetween = [{{ body = \"s\", at = {at:?} }}, \"ground\"]\nlaw = \"isotropic\"\nstiffness = 2e6\ncubic_stiffness = 1e13\n\
             [[part]]\nkind = \"damper\"\nname = \"c{k}\"\nbetween = [{{ body = \"s\", at = {at:?} }}, \"ground\"]\ndamping = 300.0\n"
        );
    }
    if table {
        text += "[[part]]\nkind = \"bearing_linear\"\nname = \"seal\"\nbetween = [{ body = \"s\", at = 0.35 }, \"ground\"]\n\
                 table = { speed = [0.0, 200.0, 500.0], kxx = [1e5, 2e5, 4e5], kyy = [1e5, 2e5, 4e5], kxy = [1e4, 3e4, 9e4], kyx = [-1e4, -3e4, -9e4] }\n";
    }
    if other {
        text += "[[part]]\nkind = \"speed_ratio\"\nname = \"other\"\nratio = -1.3\n\
                 [[part]]\nkind = \"disc\"\nname = \"ring\"\nspin = \"other\"\nmass = 5.0\nunbalance = 6e-4\n\
                 [[part]]\nkind = \"bearing_linear\"\nname = \"of ring\"\nbetween = [\"ring\", { body = \"s\", at = 0.1 }]\nkxx = 8e6\nkyy = 8e6\ncxx = 500.0\ncyy = 500.0\n";
    }
    load(&text).system
}

fn ramp(from: f64, to: f64) -> SpinLaw {
    SpinLaw::Programme(Programme::ramp(from, to, 2.0, Shape::Smooth, 0.3).unwrap())
}

/// A state unlike any other, in the size of a motion.
fn state(system: &System, dim: usize) -> Vec<f64> {
    let n = system.n();
    let typical = |i: usize| match i {
        i if i < n => system.coordinates()[i].dof.typical,
        i if i < 2 * n => 300.0 * system.coordinates()[i - n].dof.typical,
        i if i < 2 * n + system.m() => system.states()[i - 2 * n].dof.typical,
        _ => 0.0,
    };
    (0..dim).map(|i| typical(i) * (1.0 + 2.3 * i as f64).sin()).collect()
}

fn machines() -> [System; 4] {
    [cubic(31), with_liquid(false, false), with_liquid(true, false), with_liquid(true, true)]
}

/// The residual of all parts, each by itself, vanishes with the accelerations that were solved for; rates of internal states are those of the parts.
#[test]
fn the_equations_balance() {
    for system in machines() {
        let mut motion = Motion::new(&system, ramp(40.0, 400.0)).unwrap();
        assert!(motion.is_by_entries());
        let y = state(&system, motion.dim());
        // one after the other, so that the matrices of a speed are used several times
        for t in [0.4, 1.1, 0.4, 1.7, 0.9, 1.3, 1.1] {
            let rates = motion.accelerations(t, &y).unwrap().rates.to_vec();
            let forces = |at: &At<f64>| {
                let (mut force, mut rate, mut spin) = (vec![0.0; system.n()], vec![0.0; system.m()], 0.0);
                let mut rows = Rows { force: &mut force, rate: &mut rate, spin: &mut spin };
                system.residual(system.params(), at, &mut rows, &mut Workspace::default(), |_| true);
                (force, rate)
            };
            let zero = vec![0.0; system.n()];
            let ((left, rate), (held, _)) = motion.with_point(t, &y, |_, at| (forces(at), forces(&At { a: &zero, ..*at }))).unwrap();
            let size = |x: &[f64]| x.iter().fold(0.0f64, |m, x| m.max(x.abs()));
            assert!(size(&held) > 1.0 && size(&left) < 1e-9 * size(&held), "{:e} of {:e}", size(&left), size(&held));
            assert!(rates.iter().zip(&rate).all(|(a, b)| (a - b).abs() <= 1e-9 * size(&rate)), "{rates:?} {rate:?}");
        }
    }
}

/// `(s - J) x = b` with the factors of T(s) is solved for the full Jacobian of the same machine.
#[test]
fn solves_are_those_of_the_full_jacobian() {
    for system in machines() {
        let mut motion = Motion::new(&system, ramp(40.0, 400.0)).unwrap();
        let dim = motion.dim();
        let y = state(&system, dim);
        let mut full = Mat::zeros(dim, dim);
        motion.jacobian(0.8, &y, &mut full).unwrap();
        let mut dense = DenseSolver::default();
        motion.linearise(0.8, &y, &mut dense).unwrap();
        let (real, complex) = (3e4, c(2e4, -2.5e4));
        motion.factor(real, complex, &mut dense).unwrap();
        let b: Vec<f64> = state(&system, dim).iter().enumerate().map(|(i, x)| x * (0.7 * i as f64).cos()).collect();
        let (mut x, mut z): (Vec<f64>, Vec<C64>) = (b.clone(), b.iter().map(|&x| c(x, -0.4 * x)).collect());
        motion.solve_real(&mut x, &dense);
        motion.solve_complex(&mut z, &dense);
        // row by row against the sizes of its terms, to the rounding of the inverse of the mass matrix in the full one
        for i in 0..dim {
            let (mut real_left, mut left, mut size) =
                (real * x[i] - b[i], complex * z[i] - c(b[i], -0.4 * b[i]), (real * x[i]).abs() + b[i].abs());
            for j in 0..dim {
                real_left -= full[(i, j)] * x[j];
                left -= z[j].scale(full[(i, j)]);
                size += (full[(i, j)] * x[j]).abs();
            }
            assert!(real_left.abs() <= 1e-8 * size && left.abs() <= 1e-8 * size, "{i}: {real_left:e} {left:?} {size:e}");
        }
    }
}

/// Forces in place of accelerations lead to the same solutions, whether the mass matrix is that of any speed or not.
#[test]
fn forces_need_no_division_by_the_mass() {
    let mut undivided = 0;
    for system in machines() {
        let mut motion = Motion::new(&system, ramp(40.0, 400.0)).unwrap();
        let dim = motion.dim();
        let y = state(&system, dim);
        let mut dense = DenseSolver::default();
        motion.linearise(0.8, &y, &mut dense).unwrap();
        let (real, complex) = (3e4, c(2e4, -2.5e4));
        motion.factor(real, complex, &mut dense).unwrap();
        let (mut rates, mut forces) = (vec![0.0; dim], vec![0.0; dim]);
        motion.rhs(0.8, &y, &mut rates).unwrap();
        motion.forces(0.8, &y, &mut forces).unwrap();
        undivided += usize::from(rates != forces);
        let w: Vec<f64> = y.iter().enumerate().map(|(i, y)| 1e-3 * y * (0.3 * i as f64).sin()).collect();
        let turned: Vec<C64> = w.iter().map(|&w| c(w, 0.6 * w)).collect();
        let mut expected: Vec<f64> = rates.iter().zip(&w).map(|(f, w)| f - real * w).collect();
        let mut expected_turned: Vec<C64> = rates.iter().zip(&turned).map(|(f, w)| c(*f, -*f) - complex * *w).collect();
        motion.solve_real(&mut expected, &dense);
        motion.solve_complex(&mut expected_turned, &dense);
        let mut found_turned: Vec<C64> = forces.iter().map(|&f| c(f, -f)).collect();
        motion.solve_real_forces(real, &mut forces, &w, &dense);
        motion.solve_complex_forces(complex, &mut found_turned, &turned, &dense);
        // places and velocities have units of their own
        for part in [0..system.n(), system.n()..2 * system.n(), 2 * system.n()..dim] {
            let size = expected[part.clone()].iter().fold(0.0f64, |m, x| m.max(x.abs()));
            for i in part {
                assert!((forces[i] - expected[i]).abs() <= 1e-9 * size, "{i}: {} {}", forces[i], expected[i]);
                assert!((found_turned[i] - expected_turned[i]).abs() <= 2e-9 * size, "{i}: {:?} {:?}", found_turned[i], expected_turned[i]);
            }
        }
    }
    assert!(undivided > 0);
}

/// A shaft with a layer that stands on its lower end, with displacement along its axis and rotation about it.
fn standing() -> System {
    let text = "[machine]\nname = \"standing\"\nspeed = 300.0\n\
         [[part]]\nkind = \"shaft\"\nname = \"s\"\nelements = 12\naxial = true\ntorsional = true\nrotating_damping = 1e-5\nmass_damping = 2.0\n\
         section = { length = [0.4, 0.3], outer_diameter = [0.05, 0.06], end_outer_diameter = [0.0, 0.04] }\n\
         layer = { from = [0.1], to = [0.2], outer_diameter = [0.07], inner_diameter = [0.05] }\n\
         [[part]]\nkind = \"disc\"\nname = \"plate\"\non = { body = \"s\", at = 0.5 }\nmass = 9.0\npolar_inertia = 0.1\ndiametral_inertia = 0.07\nunbalance = 3e-4\nskew = 0.01\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"lower\"\nbetween = [\"s\", \"ground\"]\nkxx = 2e7\nkyy = 3e7\nkxy = 1e6\nkyx = -2e6\ncxx = 900.0\ncyy = 700.0\nkzz = 4e7\nczz = 500.0\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"upper\"\nbetween = [{ body = \"s\", at = 0.7 }, \"ground\"]\nkxx = 2e7\nkyy = 2e7\ncxx = 900.0\ncyy = 700.0\n\
         [[part]]\nkind = \"coupling\"\nname = \"drive\"\nbetween = [\"s\", \"ground\"]\ntorsional_stiffness = 1e5\ntorsional_damping = 10.0\n";
    load(text).system
}

/// The weight does the work of gravity on the momentum, which is the derivative of the stored energy over the velocities upwards, and the drive that of the spin
/// row of all parts.
#[test]
fn powers_of_weight_and_drive_are_those_of_energy_and_residual() {
    for (system, upwards) in machines().into_iter().map(|s| (s, DofKind::VectorY)).chain([(standing(), DofKind::Axial)]) {
        let mut motion = Motion::new(&system, ramp(40.0, 400.0)).unwrap();
        let (n, y) = (system.n(), state(&system, motion.dim()));
        for t in [0.4, 1.1] {
            let found = motion.powers(t, &y).unwrap();
            let stored = [-1.0, 1.0].map(|sign| {
                let mut y = y.clone();
                let up = (0..n).filter(|&i| system.coordinates()[i].dof.kind == upwards);
                up.for_each(|i| y[n + i] += sign * GRAVITY);
                motion.stored_energy(t, &y).unwrap()
            });
            let weight = -0.5 * (stored[1] - stored[0]);
            let scale = stored[0].abs().max(stored[1].abs());
            if system.machine.axis == Axis::Horizontal || upwards == DofKind::Axial {
                assert!(found.weight != 0.0 && (found.weight - weight).abs() < 1e-10 * scale, "{t}: {found:?} {weight}");
            } else {
                assert_eq!(found.weight, 0.0);
            }
            let torque = |system: &System, at: &At<f64>| {
                let (mut force, mut rate, mut spin) = (vec![0.0; n], vec![0.0; system.m()], 0.0);
                let mut rows = Rows { force: &mut force, rate: &mut rate, spin: &mut spin };
                system.residual(system.params(), at, &mut rows, &mut Workspace::default(), |_| true);
                spin * at.speed
            };
            let drive = motion.with_point(t, &y, |system, at| torque(system, at)).unwrap();
            assert!(drive != 0.0 && (found.drive - drive).abs() < 1e-12 * drive.abs(), "{t}: {found:?} {drive}");
        }
    }
}

/// Stored energy changes by what the account says, of a shaft that lies and of one that stands.
#[test]
fn the_account_of_a_shaft_closes() {
    for system in [with_liquid(false, true), standing()] {
        let mut motion = Motion::new(&system, ramp(40.0, 400.0)).unwrap();
        motion.keep_account().unwrap();
        let mut y = state(&system, motion.dim());
        let from = motion.account_start().unwrap();
        let before = motion.stored_energy(0.0, &y).unwrap();
        let run = integrate(&mut Radau::new(), &mut motion, 0.0, &mut y, 0.02, &Control::new(1e-10, 1e-13), &mut ());
        assert_eq!(run.end, End::Reached);
        let after = motion.stored_energy(0.02, &y).unwrap();
        let [heat, sources, drive, weight] = [0, 1, 2, 3].map(|k| y[from + k]);
        let exchanged = [heat, sources, drive, weight].iter().map(|x| x.abs()).sum::<f64>();
        let missing = after - before - (-heat + sources + drive + weight);
        // the drive exchanges most of it
        assert!(missing.abs() < 1e-10 * exchanged && missing.abs() < 1e-4 * weight.abs(), "{missing:e} of {exchanged:e}, {weight:e}");
    }
}

fn simulated(system: &System, law: SpinLaw, y: &[f64], (t_end, relative): (f64, f64), choice: Choice) -> Trajectory {
    let outputs: Vec<f64> = (0..=100).map(|k| t_end * f64::from(k) / 100.0).collect();
    let plan = Plan {
        t_end,
        choice,
        relative,
        absolute: 0.01 * relative,
        outputs: &outputs,
        windows: 1,
        rest: &[],
        bound: f64::INFINITY,
        kick: None,
        max_steps: u64::MAX,
        cancel: &|| false,
        progress: &|_| {},
    };
    let mut motion = Motion::new(system, law).unwrap();
    let y = if y.is_empty() { vec![0.0; motion.dim()] } else { y.to_vec() };
    simulate(&mut motion, &y, &plan).unwrap()
}

/// A run-up through resonances of the whole machine, and of the reduced one within its error.
#[test]
fn a_run_up_is_that_of_the_reduced_machine() {
    let system = cubic(31);
    let own = ReducedMachine::of(&system, 250.0).unwrap();
    let law = ramp(60.0, 250.0);
    let whole = simulated(&system, law.clone(), &[], (2.0, 1e-7), Choice::Auto);
    let few = simulated(&own.system, law, &[], (2.0, 1e-7), Choice::Auto);
    assert!(whole.stiff);
    let (a, b) = (whole.peaks[15].amplitude, few.peaks[15].amplitude);
    assert!(a > 1e-5 && (a - b).abs() < 1e-3 * a, "{a:e} {b:e}");
}

/// A linear machine that begins in its response to unbalance stays there, and comes near it from elsewhere as its slowest mode decays.
#[test]
fn a_transient_stays_in_the_response_to_unbalance() {
    let system = load(&isotropic(41)).system;
    let (speed, n) = (95.0, system.n());
    let response = response(&system, &|w| rest(&system, w), speed).unwrap().unwrap();
    let state = |t: f64| -> Vec<f64> {
        let turned = C64::cis(speed * t);
        let places = response.x.iter().take(n).map(|x| (*x * turned).re);
        let rates = response.x.iter().take(n).map(|x| (*x * turned * c(0.0, speed)).re);
        places.chain(rates).collect()
    };
    let law = SpinLaw::Programme(Programme::constant(speed, 0.0));
    let size = response.x.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    let away = |y: &[f64], t: f64| y.iter().zip(&state(t)).take(n).fold(0.0f64, |m, (a, b)| m.max((a - b).abs())) / size;
    let t_end = 0.6;
    for (relative, most) in [(1e-6, 1e-4), (1e-8, 1e-6)] {
        let end = simulated(&system, law.clone(), &state(0.0), (t_end, relative), Choice::Stiff);
        assert!(away(&end.state, t_end) < most, "{:e}", away(&end.state, t_end));
    }
    let decays = [1.0, 2.0].map(|t| away(&simulated(&system, law.clone(), &[], (t, 1e-7), Choice::Auto).state, t));
    assert!(decays[0] < 1.0 && decays[1] < 0.9 * decays[0], "{decays:?}");
}
