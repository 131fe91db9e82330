use super::*;

/// Any square equations given by closures, with unit scales unless changed.
struct Eqs<F, J> {
    n: usize,
    f: F,
    j: J,
    scale: Vec<f64>,
    row: Vec<f64>,
}

impl<F: Fn(&[f64], &mut [f64]), J: Fn(&[f64], &mut Mat)> Zero for Eqs<F, J> {
    fn dim(&self) -> usize {
        self.n
    }
    fn scale(&self, out: &mut [f64]) {
        out.copy_from_slice(&self.scale);
    }
    fn parameter_scale(&self) -> f64 {
        1.0
    }
    fn eval(&mut self, x: &[f64], _p: f64, r: &mut [f64], jac: Option<&mut Mat>, _: Option<&mut [f64]>) -> Result<(), Failure> {
        (self.f)(x, r);
        for (r, w) in r.iter_mut().zip(&self.row) {
            *r *= w;
        }
        if let Some(jac) = jac {
            (self.j)(x, jac);
            for i in 0..self.n {
                for a in jac.row_mut(i) {
                    *a *= self.row[i];
                }
            }
        }
        Ok(())
    }
}

fn scalar(f: impl Fn(f64) -> f64, d: impl Fn(f64) -> f64) -> impl Zero {
    Eqs {
        n: 1,
        f: move |x: &[f64], r: &mut [f64]| r[0] = f(x[0]),
        j: move |x: &[f64], j: &mut Mat| j[(0, 0)] = d(x[0]),
        scale: vec![1.0],
        row: vec![1.0],
    }
}

fn solve(mut z: impl Zero, x0: f64, o: &Options) -> (Result<Converged, NotConverged>, f64) {
    let mut x = [x0];
    let end = newton(&mut z, &mut x, 0.0, o);
    (end, x[0])
}

#[test]
fn converges_quadratically_and_says_how_well() {
    let (end, x) = solve(scalar(|x| x * x - 2.0, |x| 2.0 * x), 1.0, &Options { to_rounding: true, ..Options::default() });
    let done = end.unwrap();
    assert!((x - 2f64.sqrt()).abs() < 1e-15 && done.step < 1e-15 && done.iterations <= 7, "{done:?}");
    // 1 -> 3/2 -> 17/12: the first two steps are 1/2 and -1/12
    assert!((done.rate - (1.0 / 12.0 / 1.5) / 0.5).abs() < 1e-12, "{}", done.rate);
}

#[test]
fn damping_rescues_the_arctangent() {
    let z = || scalar(f64::atan, |x| 1.0 / (1.0 + x * x));
    let (end, x) = solve(z(), 20.0, &Options::default());
    assert!(end.is_ok() && x.abs() < 1e-9);
    let (end, x) = solve(z(), 20.0, &Options { damped: false, ..Options::default() });
    assert_eq!((end.unwrap_err().cause, x), (Cause::Diverged, 20.0));
}

#[test]
fn no_zero_is_never_called_a_zero() {
    let (end, x) = solve(scalar(|x| x * x + 1.0, |x| 2.0 * x), 3.0, &Options::default());
    let end = end.unwrap_err();
    assert!(matches!(end.cause, Cause::Stalled | Cause::Diverged) && end.residual > 1e-3, "{end:?}");
    assert_eq!(x, 3.0);
}

#[test]
fn singular_and_nan_and_undefined_have_their_names() {
    let cause = |z: (Result<Converged, NotConverged>, f64)| z.0.unwrap_err().cause;
    assert_eq!(cause(solve(scalar(|x| x * x + 1.0, |x| 2.0 * x), 0.0, &Options::default())), Cause::Singular);
    assert_eq!(cause(solve(scalar(|_| f64::NAN, |_| 1.0), 0.0, &Options::default())), Cause::NotFinite);
    assert_eq!(cause(solve(scalar(|_| 1.0, |_| f64::NAN), 0.0, &Options::default())), Cause::NotFinite);
}

/// Rosenbrock's valley as equations, in units that differ by many orders.
#[test]
fn iterates_do_not_depend_on_units() {
    let run = |s: [f64; 2], w: [f64; 2]| {
        let mut z = Eqs {
            n: 2,
            f: move |x: &[f64], r: &mut [f64]| {
                let (u, v) = (x[0] / s[0], x[1] / s[1]);
                (r[0], r[1]) = (10.0 * (v - u * u), 1.0 - u);
            },
            j: move |x: &[f64], j: &mut Mat| {
                let u = x[0] / s[0];
                j[(0, 0)] = -20.0 * u / s[0];
                j[(0, 1)] = 10.0 / s[1];
                j[(1, 0)] = -1.0 / s[0];
            },
            scale: s.to_vec(),
            row: w.to_vec(),
        };
        let mut x = [-1.2 * s[0], s[1]];
        let done = newton(&mut z, &mut x, 0.0, &Options::default()).unwrap();
        (done.iterations, x[0] / s[0], x[1] / s[1])
    };
    let (n, u, v) = run([1.0, 1.0], [1.0, 1.0]);
    let (n2, u2, v2) = run([1e-6, 3e4], [7e5, 1e-9]);
    assert_eq!(n, n2);
    assert!((u - 1.0).abs() < 1e-9 && (v - 1.0).abs() < 1e-9 && (u2 - u).abs() < 1e-12 && (v2 - v).abs() < 1e-12);
}

#[test]
fn a_double_root_is_accepted_only_at_rounding_level() {
    // linear convergence by 1/2; the step is the honest error
    let (end, x) = solve(scalar(|x| x * x, |x| 2.0 * x), 1.0, &Options { max_iterations: 60, ..Options::default() });
    let done = end.unwrap();
    assert!(done.iterations > 10 && x.abs() <= 4.0 * done.step, "{done:?} {x}");
}

#[test]
fn a_law_without_value_shortens_the_step_or_ends_it() {
    // full step from 3 lands at -0.3 where the logarithm has no value
    let z = || scalar(f64::ln, |x| 1.0 / x);
    let (end, x) = solve(z(), 3.0, &Options::default());
    assert!(end.is_ok() && (x - 1.0).abs() < 1e-9);
    assert_eq!(solve(z(), 3.0, &Options { damped: false, ..Options::default() }).0.unwrap_err().cause, Cause::NotFinite);
}
