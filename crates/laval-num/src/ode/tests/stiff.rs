//! The implicit method: order, published stiff problems, closed forms, eliminated memory states.

use super::*;
use crate::complex::{C64, c};
use crate::dense::Singular;

struct Stiff<F, J> {
    dim: usize,
    f: F,
    jac: J,
}

impl<F: FnMut(f64, &[f64], &mut [f64]), J> Ode for Stiff<F, J> {
    fn dim(&self) -> usize {
        self.dim
    }
    fn rhs(&mut self, t: f64, y: &[f64], dy: &mut [f64]) -> Result<(), Failure> {
        (self.f)(t, y, dy);
        Ok(())
    }
}

impl<F: FnMut(f64, &[f64], &mut [f64]), J: FnMut(f64, &[f64], &mut Mat)> StiffOde for Stiff<F, J> {
    fn jacobian(&mut self, t: f64, y: &[f64], jac: &mut Mat) -> Result<(), Failure> {
        (self.jac)(t, y, jac);
        Ok(())
    }
}

fn stiff<F: FnMut(f64, &[f64], &mut [f64]), J: FnMut(f64, &[f64], &mut Mat)>(dim: usize, f: F, jac: J) -> Stiff<F, J> {
    Stiff { dim, f, jac }
}

fn exact_newton() -> Radau {
    // relative to the wide tolerances of uniform steps
    let mut method = Radau::new();
    method.newton_tolerance = Some(1e-26);
    method
}

#[test]
fn is_of_order_five_on_non_autonomous_problems() {
    let end = [32, 64, 128].map(|n| forced_errors(&mut exact_newton(), 3.2, n).0);
    let bell = [20usize, 40, 80].map(|n| {
        let mut y = [Bell::exact(-1.5)];
        let run = integrate(&mut exact_newton(), &mut Bell, -1.5, &mut y, 1.0, &fixed(2.5 / n as f64), &mut ());
        assert_eq!((run.work.steps, run.work.rejected), (n as u64, 0));
        (y[0] - Bell::exact(1.0)).abs()
    });
    for errors in [end, bell] {
        let found = orders(&errors);
        assert!(found.iter().all(|p| *p > 4.7 && *p < 5.6), "{found:?} from {errors:?}");
    }
}

#[test]
fn dense_output_of_one_step_has_local_order_four() {
    let errors = [0.1, 0.05, 0.025].map(|h| forced_errors(&mut exact_newton(), h, 1));
    let found = orders(&errors.map(|e| e.1));
    assert!(found.iter().all(|p| *p > 3.6 && *p < 4.6), "{found:?}");
    let found = orders(&errors.map(|e| e.2));
    assert!(found.iter().all(|p| *p > 2.6 && *p < 3.6), "{found:?}");
}

/// Van der Pol's equation in the scaling eps y'' = (1 - y^2) y' - y with eps = 1e-6.
fn van_der_pol() -> impl StiffOde {
    stiff(
        2,
        |_, y, dy| dy.copy_from_slice(&[y[1], ((1.0 - y[0] * y[0]) * y[1] - y[0]) * 1e6]),
        |_, y, jac| {
            jac[(0, 1)] = 1.0;
            jac[(1, 0)] = -(2.0 * y[0] * y[1] + 1.0) * 1e6;
            jac[(1, 1)] = (1.0 - y[0] * y[0]) * 1e6;
        },
    )
}

#[test]
fn van_der_pol_agrees_with_the_test_set() {
    // Test Set for IVP Solvers, problem vdpol: y(2) from y(0) = (2, 0)
    let reference = [0.1706167732170483e1, -0.8928097010247975];
    let mut last = f64::INFINITY;
    for (tol, bound) in [(1e-5, 1e-3), (1e-7, 1e-5), (1e-9, 1e-7)] {
        let mut y = [2.0, 0.0];
        let run = integrate(&mut Radau::new(), &mut van_der_pol(), 0.0, &mut y, 2.0, &Control::new(tol, tol), &mut ());
        let error = distance(&y, &reference);
        assert_eq!(run.end, End::Reached);
        assert!(error < bound && error < last, "{error} at {tol}: {:?}", run.work);
        assert!(run.work.steps < 2500 && run.work.jacobians <= run.work.factorisations, "{:?}", run.work);
        last = error;
    }
    // the predictive control sees the fast turns coming; without it one step in six is rejected
    let run = integrate(&mut Radau::new(), &mut van_der_pol(), 0.0, &mut [2.0, 0.0], 2.0, &Control::new(1e-4, 1e-4), &mut ());
    assert!(10 * run.work.rejected < run.work.steps, "{:?}", run.work);
}

#[test]
fn robertson_agrees_with_the_test_set() {
    // Test Set for IVP Solvers, problem rober: y(1e11)
    let reference = [0.2083340149701255e-7, 0.8333360770334713e-13, 0.999999979166505];
    let mut robertson = stiff(
        3,
        |_, y, dy| {
            let (a, b, d) = (0.04 * y[0], 1e4 * y[1] * y[2], 3e7 * y[1] * y[1]);
            dy.copy_from_slice(&[b - a, a - b - d, d]);
        },
        |_, y, jac| {
            let rows = [[-0.04, 1e4 * y[2], 1e4 * y[1]], [0.04, -1e4 * y[2] - 6e7 * y[1], -1e4 * y[1]], [0.0, 6e7 * y[1], 0.0]];
            for (i, row) in rows.iter().enumerate() {
                jac.row_mut(i).copy_from_slice(row);
            }
        },
    );
    let mut y = [1.0, 0.0, 0.0];
    let control = Control::new(1e-9, vec![1e-16, 1e-22, 1e-12]);
    let run = integrate(&mut Radau::new(), &mut robertson, 0.0, &mut y, 1e11, &control, &mut ());
    assert_eq!(run.end, End::Reached);
    for (y, r) in y.iter().zip(reference) {
        assert!((y / r - 1.0).abs() < 1e-7, "{y} {r}");
    }
    assert!((y.iter().sum::<f64>() - 1.0).abs() < 1e-12 && run.work.steps < 1500, "{:?}", run.work);
}

#[test]
fn rates_of_a_billion_follow_the_closed_form() {
    // y' = -1e9 (y - cos t) - sin t, w' = y: y = cos t + (y0 - 1) exp(-1e9 t), w = sin t + (y0 - 1) 1e-9 (1 - exp(-1e9 t))
    let mut system = stiff(
        2,
        |t, y, dy| dy.copy_from_slice(&[-1e9 * (y[0] - t.cos()) - t.sin(), y[0]]),
        |_, _, jac| (jac[(0, 0)], jac[(1, 0)]) = (-1e9, 1.0),
    );
    for start in [1.0, 3.0] {
        let mut y = [start, 0.0];
        let outputs = [1e-9, 1e-3, 1.0, 5.0, 10.0];
        let (mut record, control) = (Record::default(), Control { outputs: &outputs, ..Control::new(1e-8, 1e-10) });
        let run = integrate(&mut Radau::new(), &mut system, 0.0, &mut y, 10.0, &control, &mut record);
        assert_eq!(run.end, End::Reached);
        for (t, y) in outputs.iter().zip(record.states.chunks(2)) {
            let decay = (start - 1.0) * (-1e9 * t).exp();
            // the dense output inside a step is two orders less accurate than its ends
            assert!((y[0] - t.cos() - decay).abs() < 1e-4, "{t}: {y:?}");
            assert!((y[1] - t.sin() - 1e-9 * (start - 1.0 - decay)).abs() < 1e-4, "{t}: {y:?}");
        }
        assert!((y[0] - 10f64.cos()).abs() < 1e-7 && (y[1] - 10f64.sin() - 1e-9 * (start - 1.0)).abs() < 1e-7, "{y:?}");
        assert!(run.work.steps < 500, "{:?}", run.work);
    }
}

/// An oscillator q'' = -4 q - q^3 - sum_k w_k z_k + cos t with memory z_k' = -l_k z_k + l_k q, rates 1 to 1e9 1/s.
/// States (q, q', z...). The linear solves eliminate z.
struct Memory {
    rates: Vec<f64>,
    weight: f64,
    eliminate: bool,
    stiffness: f64,
    shifts: (f64, C64),
}

impl Memory {
    fn new(n: usize, eliminate: bool) -> Self {
        let rates = (0..n).map(|k| 10f64.powf(9.0 * k as f64 / (n - 1) as f64)).collect();
        Memory { rates, weight: 2.0 / n as f64, eliminate, stiffness: 0.0, shifts: (0.0, c(0.0, 0.0)) }
    }

    /// s q - v = a, s v + k q + w sum z = b, (s + l_k) z_k - l_k q = d_k, with the field's operations passed as complex numbers.
    fn solve(&self, s: C64, x: &mut [C64]) {
        let (mut pivot, mut rest) = (c(self.stiffness, 0.0), x[1]);
        for (l, d) in self.rates.iter().zip(&x[2..]) {
            let inverse = (s + c(*l, 0.0)).recip();
            pivot += inverse.scale(self.weight * l);
            rest += -(inverse * *d).scale(self.weight);
        }
        // v = s q - a
        let q = (rest + s * x[0]) / (s * s + pivot);
        x[1] = s * q - x[0];
        x[0] = q;
        for (l, d) in self.rates.iter().zip(&mut x[2..]) {
            *d = (*d + q.scale(*l)) / (s + c(*l, 0.0));
        }
    }
}

impl Ode for Memory {
    fn dim(&self) -> usize {
        2 + self.rates.len()
    }
    fn rhs(&mut self, t: f64, y: &[f64], dy: &mut [f64]) -> Result<(), Failure> {
        dy[0] = y[1];
        dy[1] = t.cos() - 4.0 * y[0] - y[0].powi(3) - self.weight * y[2..].iter().sum::<f64>();
        for ((dz, z), l) in dy[2..].iter_mut().zip(&y[2..]).zip(&self.rates) {
            *dz = l * (y[0] - z);
        }
        Ok(())
    }
}

impl StiffOde for Memory {
    fn jacobian(&mut self, _: f64, y: &[f64], jac: &mut Mat) -> Result<(), Failure> {
        (jac[(0, 1)], jac[(1, 0)]) = (1.0, -4.0 - 3.0 * y[0] * y[0]);
        for (k, l) in self.rates.iter().enumerate() {
            (jac[(1, k + 2)], jac[(k + 2, 0)], jac[(k + 2, k + 2)]) = (-self.weight, *l, -l);
        }
        Ok(())
    }
    fn linearise(&mut self, t: f64, y: &[f64], dense: &mut DenseSolver) -> Result<(), Failure> {
        self.stiffness = 4.0 + 3.0 * y[0] * y[0];
        if !self.eliminate {
            dense.set_jacobian(self, t, y)?;
        }
        Ok(())
    }
    fn factor(&mut self, real: f64, complex: C64, dense: &mut DenseSolver) -> Result<(), Singular> {
        self.shifts = (real, complex);
        if self.eliminate { Ok(()) } else { dense.factor(real, complex) }
    }
    fn solve_real(&mut self, b: &mut [f64], dense: &DenseSolver) {
        if !self.eliminate {
            return dense.solve_real(b);
        }
        let mut x: Vec<C64> = b.iter().map(|b| c(*b, 0.0)).collect();
        self.solve(c(self.shifts.0, 0.0), &mut x);
        b.iter_mut().zip(x).for_each(|(b, x)| *b = x.re);
    }
    fn solve_complex(&mut self, b: &mut [C64], dense: &DenseSolver) {
        if self.eliminate { self.solve(self.shifts.1, b) } else { dense.solve_complex(b) }
    }
}

#[test]
fn eliminated_memory_equals_the_dense_path() {
    let n = 200;
    let (mut dense, mut eliminated) = (Memory::new(n, false), Memory::new(n, true));
    // single solutions
    let mut store = DenseSolver::default();
    let y: Vec<f64> = (0..n + 2).map(|i| (i as f64).sin()).collect();
    for system in [&mut dense, &mut eliminated] {
        system.linearise(0.0, &y, &mut store).unwrap();
        system.factor(30.0, c(20.0, -25.0), &mut store).unwrap();
    }
    let (mut a, mut b) = (y.clone(), y.clone());
    dense.solve_real(&mut a, &store);
    eliminated.solve_real(&mut b, &store);
    assert!(distance(&a, &b) < 1e-12);
    let mut a: Vec<C64> = y.iter().map(|y| c(*y, 1.0 - y)).collect();
    let mut b = a.clone();
    dense.solve_complex(&mut a, &store);
    eliminated.solve_complex(&mut b, &store);
    assert!(a.iter().zip(&b).all(|(a, b)| (*a - *b).abs() < 1e-12));
    // whole integrations
    let run = |system: &mut Memory| {
        let mut y = vec![0.0; n + 2];
        let run = integrate(&mut Radau::new(), system, 0.0, &mut y, 3.0, &Control::new(1e-6, 1e-9), &mut ());
        assert_eq!(run.end, End::Reached);
        (y, run.work)
    };
    let ((a, work), (b, same)) = (run(&mut dense), run(&mut eliminated));
    assert!(distance(&a, &b) < 1e-9, "{}", distance(&a, &b));
    assert!(work.steps.abs_diff(same.steps) <= 1 && work.steps < 300, "{work:?} {same:?}");
    // memory faster than the motion follows it: z = q - q'/l to first order in 1/l
    assert!((a[n + 1] - a[0]).abs() < 1e-7 && (a[2] - a[0]).abs() > 1e-3);
}

#[test]
fn agrees_with_the_explicit_method() {
    let mut y = Memory::new(5, false);
    y.rates = vec![1.0, 2.0, 4.0, 8.0, 16.0];
    let (mut a, mut b) = ([0.0; 7], [0.0; 7]);
    let control = Control::new(1e-10, 1e-12);
    integrate(&mut Dop853::new(), &mut y, 0.0, &mut a, 6.0, &control, &mut ());
    integrate(&mut Radau::new(), &mut y, 0.0, &mut b, 6.0, &control, &mut ());
    assert!(distance(&a, &b) < 1e-8, "{a:?} {b:?}");
}

#[test]
fn error_is_proportional_to_the_tolerance() {
    let errors: Vec<f64> = [1e-4, 1e-6, 1e-8, 1e-10]
        .iter()
        .map(|tol| {
            let mut y = Forced::exact(0.0);
            integrate(&mut Radau::new(), &mut Forced, 0.0, &mut y, 10.0, &Control::new(*tol, *tol), &mut ());
            distance(&y, &Forced::exact(10.0))
        })
        .collect();
    for w in errors.windows(2) {
        let decades = (w[0] / w[1]).log10();
        assert!(decades > 1.2 && decades < 2.8, "{errors:?}");
    }
}

#[test]
fn a_failing_newton_iteration_is_reported() {
    // the Jacobian is wrong by 1e9, and at t = 1e9 no step is short enough to do without
    let mut wrong = stiff(1, |_, y, dy| dy[0] = 1.0 - 1e9 * y[0].powi(3), |_, _, _| {});
    let mut y = [1.0];
    let run = integrate(&mut Radau::new(), &mut wrong, 1e9, &mut y, 1e9 + 1.0, &Control::new(1e-6, 1e-6), &mut ());
    assert_eq!(run.end, End::StepTooSmall { t: 1e9, cause: Cause::Newton });
    assert_eq!(y, [1.0]);
}

#[test]
fn a_singular_matrix_only_shortens_the_step() {
    let h = 0.125;
    let rate = super::super::radau::REAL / h;
    let mut growth = stiff(1, |_, y, dy| dy[0] = rate * y[0], |_, _, jac| jac[(0, 0)] = rate);
    let mut y = [1.0];
    let run =
        integrate(&mut Radau::new(), &mut growth, 0.0, &mut y, 0.5, &Control { first_step: Some(h), ..Control::new(1e-9, 1e-9) }, &mut ());
    assert_eq!(run.end, End::Reached);
    assert!(run.work.rejected > 0 && (y[0] / (rate * 0.5).exp() - 1.0).abs() < 1e-6);
}

/// Van der Pol's oscillator (mu = 50) with the integral of its square behind it, and how often each right side was evaluated.
struct WithIntegral {
    behind: bool,
    whole: u64,
    core: u64,
}

impl Ode for WithIntegral {
    fn dim(&self) -> usize {
        3
    }
    fn rhs(&mut self, t: f64, y: &[f64], dy: &mut [f64]) -> Result<(), Failure> {
        self.rhs_without_integrals(t, y, dy)?;
        (self.whole, self.core) = (self.whole + 1, self.core - 1);
        dy[2] = y[0] * y[0];
        Ok(())
    }
    fn integrals(&self) -> usize {
        usize::from(self.behind)
    }
    fn rhs_without_integrals(&mut self, _: f64, y: &[f64], dy: &mut [f64]) -> Result<(), Failure> {
        self.core += 1;
        (dy[0], dy[1]) = (y[1], 50.0 * (1.0 - y[0] * y[0]) * y[1] - y[0]);
        if self.behind {
            dy[2] = f64::NAN
        } else {
            dy[2] = y[0] * y[0]
        }
        Ok(())
    }
}

impl StiffOde for WithIntegral {
    fn jacobian(&mut self, _: f64, y: &[f64], jac: &mut Mat) -> Result<(), Failure> {
        (jac[(0, 1)], jac[(1, 0)], jac[(1, 1)]) = (1.0, -100.0 * y[0] * y[1] - 1.0, 50.0 * (1.0 - y[0] * y[0]));
        if !self.behind {
            jac[(2, 0)] = 2.0 * y[0];
        }
        Ok(())
    }
}

/// An integral is what it is as a state among others, to the tolerance; its rate is evaluated at the stages of accepted steps alone.
#[test]
fn integrals_follow_the_states() {
    let run = |behind: bool, tolerance: f64| {
        let mut system = WithIntegral { behind, whole: 0, core: 0 };
        let mut y = [2.0, 0.0, 0.0];
        let run = integrate(&mut Radau::new(), &mut system, 0.0, &mut y, 60.0, &Control::new(tolerance, tolerance), &mut ());
        assert_eq!(run.end, End::Reached);
        (y, system, run.work)
    };
    let (exact, ..) = run(false, 1e-12);
    for (tolerance, most) in [(1e-6, 1e-4), (1e-9, 1e-7)] {
        let (y, system, work) = run(true, tolerance);
        assert!(exact[2] > 50.0 && distance(&y, &exact) < most, "{y:?} {exact:?}");
        assert!(
            system.core > 2 * system.whole && system.whole <= 3 * (work.steps + work.rejected) + 20,
            "{} {}",
            system.core,
            system.whole
        );
    }
}

/// The explicit method leaves the rates of integrals out of the stages that have no weight, and nothing changes, integrals among states included.
#[test]
fn an_integral_has_no_rate_in_stages_without_weight() {
    let run = |behind: bool| {
        let mut system = WithIntegral { behind, whole: 0, core: 0 };
        let mut y = [2.0, 0.0, 0.0];
        let control = Control::new(1e-9, 1e-9);
        let run = integrate(&mut Dop853::new(), &mut system, 0.0, &mut y, 20.0, &control, &mut ());
        assert_eq!(run.end, End::Reached);
        (y.map(f64::to_bits), run.work, system)
    };
    let ((among, work, all), (apart, same, fewer)) = (run(false), run(true));
    assert_eq!((among, work), (apart, same));
    let steps = work.steps + work.rejected;
    assert!(
        all.core == 0 && fewer.core == 4 * steps && fewer.whole + fewer.core == all.whole,
        "{} {} {}",
        fewer.core,
        fewer.whole,
        all.whole
    );
}
