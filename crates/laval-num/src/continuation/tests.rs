use super::*;
use crate::dense::Mat;
use crate::newton::Cause;

type Equations = Box<dyn Fn(&[f64], f64, &mut [f64], &mut Mat, &mut [f64])>;
type Measure = Box<dyn Fn(&[f64], f64, &mut [f64])>;

/// A problem from closures; `units` multiply unknowns, parameter and equations.
struct Problem {
    n: usize,
    f: Equations,
    x_unit: f64,
    p_unit: f64,
    r_unit: f64,
    p_scale: f64,
    monitor: Option<(usize, Measure)>,
    cap: Box<dyn Fn(f64) -> f64>,
    budget: usize,
}

fn problem(n: usize, f: impl Fn(&[f64], f64, &mut [f64], &mut Mat, &mut [f64]) + 'static) -> Problem {
    Problem {
        n,
        f: Box::new(f),
        x_unit: 1.0,
        p_unit: 1.0,
        r_unit: 1.0,
        p_scale: 1.0,
        monitor: None,
        cap: Box::new(|_| f64::INFINITY),
        budget: usize::MAX,
    }
}

impl Zero for Problem {
    fn dim(&self) -> usize {
        self.n
    }
    fn scale(&self, out: &mut [f64]) {
        out.fill(self.x_unit);
    }
    fn parameter_scale(&self) -> f64 {
        self.p_scale * self.p_unit
    }
    fn eval(&mut self, x: &[f64], p: f64, r: &mut [f64], jac: Option<&mut Mat>, dr_dp: Option<&mut [f64]>) -> Result<(), Failure> {
        self.budget = self.budget.saturating_sub(1);
        let x: Vec<f64> = x.iter().map(|x| x / self.x_unit).collect();
        let (mut j, mut d) = (Mat::zeros(self.n, self.n), vec![0.0; self.n]);
        (self.f)(&x, p / self.p_unit, r, &mut j, &mut d);
        r.iter_mut().for_each(|r| *r *= self.r_unit);
        if let Some(jac) = jac {
            for (a, b) in jac.data_mut().iter_mut().zip(j.data()) {
                *a = b * self.r_unit / self.x_unit;
            }
        }
        if let Some(out) = dr_dp {
            for (a, b) in out.iter_mut().zip(&d) {
                *a = b * self.r_unit / self.p_unit;
            }
        }
        Ok(())
    }
    fn monitors(&self) -> usize {
        self.monitor.as_ref().map_or(0, |m| m.0)
    }
    fn monitor_width(&self) -> usize {
        self.monitors().max(1)
    }
    fn measure(&mut self, x: &[f64], p: f64, out: &mut [f64]) -> Result<(), Failure> {
        if let Some(m) = &self.monitor {
            (m.1)(x, p, out);
        }
        Ok(())
    }
    fn max_parameter_step(&mut self, _x: &[f64], p: f64) -> f64 {
        (self.cap)(p)
    }
    fn cancelled(&self) -> bool {
        self.budget == 0
    }
}

/// `g(x) + p = 0` for a function and its derivative.
fn graph(g: impl Fn(f64) -> f64 + 'static, d: impl Fn(f64) -> f64 + 'static) -> Problem {
    problem(1, move |x, p, r, j, dp| {
        r[0] = g(x[0]) + p;
        j[(0, 0)] = d(x[0]);
        dp[0] = 1.0;
    })
}

fn circle() -> Problem {
    problem(1, |x, p, r, j, dp| {
        r[0] = x[0] * x[0] + p * p - 1.0;
        j[(0, 0)] = 2.0 * x[0];
        dp[0] = 2.0 * p;
    })
}

fn folds(b: &Branch) -> Vec<&Special> {
    b.of(Kind::Fold).collect()
}

#[test]
fn a_circle_closes_with_two_folds() {
    let b = trace(&mut circle(), &[1.0], 0.0, Direction::Up, &Settings::new(-3.0, 3.0), &mut []).unwrap();
    assert_eq!(b.end, End::Closed);
    let f = folds(&b);
    assert_eq!((f.len(), b.specials.len()), (2, 2));
    assert!((f[0].point.p - 1.0).abs() < 1e-14 && (f[1].point.p + 1.0).abs() < 1e-14);
    assert!(f.iter().all(|f| f.point.x[0].abs() < 1e-10 && f.status == Status::Confirmed));
    let (first, last) = (&b.points[0], &b.points[b.points.len() - 1]);
    assert_eq!((first.p, &first.x), (last.p, &last.x));
    // sum of chords: the circumference to second order in the step
    assert!((last.s / std::f64::consts::TAU - 1.0).abs() < 2e-3, "{}", last.s);
    for q in &b.points {
        assert!((q.x[0].hypot(q.p) - 1.0).abs() < 1e-9 && q.residual < 1e-9);
        // tangent of a circle
        assert!((q.dp_ds - q.x[0]).abs() < 1e-8 && (q.dx_ds[0] + q.p).abs() < 1e-8);
    }
    let both = trace_both(&mut circle(), &[1.0], 0.0, &Settings::new(-3.0, 3.0), &mut []).unwrap();
    assert_eq!((both.end, both.first_end), (End::Closed, None));
}

#[test]
fn cubic_folds_are_exact_and_ends_lie_on_the_edge() {
    let b = trace_both(&mut graph(|x| x * x * x - x, |x| 3.0 * x * x - 1.0), &[0.0], 0.0, &Settings::new(-2.0, 3.0), &mut []).unwrap();
    assert_eq!((b.first_end, b.end), (Some(End::Reached), End::Reached));
    let (p, x) = (2.0 / (3.0 * 3f64.sqrt()), 1.0 / 3f64.sqrt());
    let f = folds(&b);
    assert_eq!(f.len(), 2);
    for f in &f {
        let sign = f.point.x[0].signum();
        assert!((f.point.p - sign * p).abs() < 1e-14 && (f.point.x[0] - sign * x).abs() < 1e-10, "{f:?}");
        let exact = f.fold.as_ref().unwrap();
        assert!((exact.x[0] - sign * x).abs() < 1e-12 && exact.p_difference.abs() < 1e-14 && f.status == Status::Confirmed);
        assert!(f.bracket[0].value * f.bracket[1].value <= 0.0 && f.bracket[0].s <= f.point.s && f.point.s <= f.bracket[1].s);
        assert!(f.bracket[1].s - f.bracket[0].s < 1e-9);
        assert!(b.points[f.after].s <= f.point.s && f.point.s <= b.points[f.after + 1].s);
    }
    let edges = [b.points[0].p, b.points[b.points.len() - 1].p];
    assert!(edges == [-2.0, 3.0] || edges == [3.0, -2.0], "{edges:?}");
    assert!(b.points.windows(2).all(|w| w[1].s > w[0].s));
}

/// x^3/3 - e^2 x = p with e chosen so that the folds are 1e-4 apart in p: they lie within one step.
#[test]
fn two_folds_within_one_step_are_both_found() {
    let e2 = (0.75e-4f64).powf(2.0 / 3.0);
    // an offset varies where the points fall
    for k in 0..20 {
        let c = 0.9 + 0.013 * k as f64;
        let mut z = graph(
            move |x| -((x - c).powi(3) / 3.0 - e2 * (x - c)) - 0.02 * (x - c).powi(5),
            move |x| -((x - c).powi(2) - e2) - 0.1 * (x - c).powi(4),
        );
        let p0 = c * 0.0 - 1.0;
        let mut set = Settings::new(-1.0, 1.0);
        set.max_parameter_step = 2.0;
        set.first_step = 0.05;
        let b = trace(&mut z, &[c - 1.43], p0, Direction::Up, &set, &mut []).unwrap();
        assert_eq!(b.end, End::Reached);
        let f = folds(&b);
        assert_eq!(f.len(), 2, "offset {c}");
        // zeros of the derivative, x^2 - e2 + x^4/10
        let x2 = (-1.0 + (1.0 + 0.4 * e2).sqrt()) / 0.2;
        let p = |x: f64| x.powi(3) / 3.0 - e2 * x + 0.02 * x.powi(5);
        assert!((f[0].point.p - p(-x2.sqrt())).abs() < 1e-14 && (f[1].point.p - p(x2.sqrt())).abs() < 1e-14);
        assert!((f[0].point.p - f[1].point.p - 1e-4).abs() < 2e-6);
    }
}

/// p x - x^3 = 0: on the line x = 0 the determinant changes sign with the parameter running on; on the bent branch p has a minimum.
#[test]
fn a_pitchfork_is_a_branch_point_on_both_its_branches() {
    let z = || {
        problem(1, |x, p, r, j, dp| {
            r[0] = p * x[0] - x[0].powi(3);
            j[(0, 0)] = p - 3.0 * x[0] * x[0];
            dp[0] = x[0];
        })
    };
    let b = trace(&mut z(), &[0.0], -1.03, Direction::Up, &Settings::new(-2.0, 1.0), &mut []).unwrap();
    assert_eq!(b.end, End::Reached);
    assert_eq!(b.specials.len(), 1);
    assert!(b.specials[0].kind == Kind::BranchPoint && b.specials[0].point.p.abs() < 1e-8, "{:?}", b.specials);
    let b = trace(&mut z(), &[0.9], 0.81, Direction::Down, &Settings::new(-2.0, 1.0), &mut []).unwrap();
    assert_eq!(b.end, End::Reached);
    assert!(b.points[b.points.len() - 1].x[0] < -0.99);
    let kinds: Vec<Kind> = b.specials.iter().map(|s| s.kind).collect();
    assert_eq!(b.specials.len(), 2, "{kinds:?}");
    assert!(kinds.contains(&Kind::BranchPoint) && kinds.contains(&Kind::ParameterExtremum));
    assert!(b.specials.iter().all(|s| s.point.p.abs() < 1e-14 && s.point.x[0].abs() < 1e-14), "{:?}", b.specials);
}

/// Residuals as large as 1 hold a pitchfork of size 1e-6: near it Newton's method on the branches ends in rounding, and the determinant is lost from
/// p = 1e-4 on. The extended system has it where it is, on both branches, and brackets contain it.
#[test]
fn a_pitchfork_drowned_in_rounding_is_where_its_equations_have_it() {
    let (size, place) = (1e-6, 0.3);
    let z = || {
        problem(2, move |x, p, r, j, dp| {
            let q = p - place;
            r[0] = ((1.0 + size * (q * x[0] - x[0].powi(3))) + (x[1] - 0.2)) - 1.0;
            j[(0, 0)] = size * (q - 3.0 * x[0] * x[0]);
            j[(0, 1)] = 1.0;
            dp[0] = size * x[0];
            r[1] = x[1] - 0.2;
            j[(1, 1)] = 1.0;
        })
    };
    let set = Settings::new(-1.0, 1.0);
    // many starts, since they decide where points fall
    for k in 0..100 {
        let x = 0.4 + 0.0034 * f64::from(k);
        let line = ([0.0, 0.2], x - 1.1, Direction::Up, &[Kind::BranchPoint][..]);
        let bent = ([x, 0.2], place + x * x, Direction::Down, &[Kind::BranchPoint, Kind::ParameterExtremum][..]);
        for (start, p, direction, kinds) in [line, bent] {
            let b = trace(&mut z(), &start, p, direction, &set, &mut []).unwrap();
            assert_eq!(b.specials.iter().map(|s| s.kind).collect::<Vec<_>>(), kinds, "{:?} {:?}", b.end, b.specials);
            for s in &b.specials {
                let (low, high) = s.range();
                assert!((s.point.p - place).abs() < 1e-12 && s.status == Status::Confirmed, "{s:?}");
                assert!(low <= place && place <= high && high - low < 1e-9, "{low} {high}");
            }
        }
    }
}

/// Branches x = 0 and x = p cross; x (x - p) = c with small c passes without a branch point.
#[test]
fn branches_that_cross_meet_in_a_branch_point_and_others_do_not() {
    let z = |c: f64| {
        problem(1, move |x, p, r, j, dp| {
            r[0] = x[0] * (x[0] - p) - c;
            j[(0, 0)] = 2.0 * x[0] - p;
            dp[0] = -x[0];
        })
    };
    let set = Settings::new(-1.0, 1.0);
    for start in [0.0, -0.93] {
        let b = trace(&mut z(0.0), &[start], -0.93, Direction::Up, &set, &mut []).unwrap();
        assert_eq!((b.specials.len(), b.specials[0].kind, b.specials[0].status), (1, Kind::BranchPoint, Status::Confirmed));
        assert!(b.specials[0].point.p.abs() < 1e-14 && b.specials[0].point.x[0].abs() < 1e-14, "{:?}", b.specials);
    }
    let c = 1e-3f64;
    let x0 = -0.5 * (0.93 - (0.93f64 * 0.93 + 4.0 * c).sqrt());
    let b = trace(&mut z(c), &[x0], -0.93, Direction::Up, &set, &mut []).unwrap();
    assert!(b.end == End::Reached && b.specials.is_empty(), "{:?}", b.specials);
}

/// Both sides of a bracket round a fold have parameters on one side of it; the range given reaches to it.
#[test]
fn the_range_of_a_fold_contains_it() {
    let want = 2.0 / (3.0 * 3f64.sqrt());
    let mut cubic = graph(|x| x * x * x - x, |x| 3.0 * x * x - 1.0);
    let b = trace_both(&mut cubic, &[0.0], 0.0, &Settings::new(-2.0, 3.0), &mut []).unwrap();
    let mut found = folds(&b).into_iter().cloned().collect::<Vec<_>>();
    assert_eq!(found.len(), 2, "{:?}", b.specials);
    for fold in &mut found {
        // a bracket as wide as noise may leave it
        let x = fold.point.x[0];
        for (side, off) in fold.bracket.iter_mut().zip([-1e-3, 2e-3]) {
            let at = x + off;
            *side = Side { s: fold.point.s + off.abs().copysign(off), p: at - at.powi(3), dp_ds: 1.0 - 3.0 * at * at, value: 0.0 };
        }
        let place = want.copysign(x);
        let ends = fold.bracket.map(|s| s.p);
        assert!(ends.iter().all(|p| p * x.signum() < want), "{ends:?}");
        fold.point.p = ends[0];
        let (low, high) = fold.range();
        assert!(low <= place && place <= high && high - low < 2e-5, "{low} {high} {place}");
    }
}

/// The unknown does not feel a resonance one unit wide in a range of 5000; a body does.
#[test]
fn a_narrow_resonance_of_a_monitored_body_is_resolved() {
    let build = |monitor: bool, cap: bool| {
        let mut z = problem(1, |x, p, r, j, dp| {
            r[0] = x[0] - 1e-3 * p;
            j[(0, 0)] = 1.0;
            dp[0] = -1e-3;
        });
        z.p_scale = 1000.0;
        let (centre, half) = (112.7, 0.5);
        if monitor {
            // 1 + 5 / (1 + i u)
            z.monitor = Some((
                2,
                Box::new(move |_, p, out| {
                    let u = (p - centre) / half;
                    (out[0], out[1]) = (1.0 + 5.0 / (1.0 + u * u), -5.0 * u / (1.0 + u * u));
                }),
            ));
        }
        if cap {
            z.cap = Box::new(move |p| resonance_cap(p, centre, half));
        }
        z
    };
    let within = |mut z: Problem, p0: f64, direction| {
        let b = trace(&mut z, &[1e-3 * p0], p0, direction, &Settings::new(25.0, 5025.0), &mut []).unwrap();
        assert_eq!(b.end, End::Reached);
        (b.points.iter().filter(|q| (q.p - 112.7).abs() <= 0.5).count(), b.points.len())
    };
    assert_eq!(within(build(false, false), 25.0, Direction::Up).0, 0);
    for (monitor, cap) in [(true, true), (false, true)] {
        for p0 in [25.0, 31.0, 60.3] {
            let (n, all) = within(build(monitor, cap), p0, Direction::Up);
            assert!(n >= 8 - 3 * usize::from(!monitor) && all < 300, "{n} of {all}");
        }
        assert!(within(build(monitor, cap), 5025.0, Direction::Down).0 >= 5);
    }
    // without a cap the monitored quantity alone shows it while steps are not much longer than its skirts
    let mut set = Settings::new(25.0, 525.0);
    set.max_parameter_step = 10.0;
    let b = trace(&mut build(true, false), &[0.025], 25.0, Direction::Up, &set, &mut []).unwrap();
    assert!(b.points.iter().filter(|q| (q.p - 112.7).abs() <= 0.5).count() >= 8);
}

/// Duffing's oscillator with one harmonic, a = |A|^2: ((1 - p^2 + 3/4 k a)^2 + (d p)^2) a = f^2.
fn duffing(d: f64, k: f64, f: f64) -> Problem {
    problem(2, move |x, p, r, j, dp| {
        let (u, v) = (x[0], x[1]);
        let (s, q) = (1.0 - p * p + 0.75 * k * (u * u + v * v), 1.5 * k);
        r[0] = s * u - d * p * v - f;
        r[1] = s * v + d * p * u;
        j[(0, 0)] = s + q * u * u;
        j[(0, 1)] = q * u * v - d * p;
        j[(1, 0)] = q * u * v + d * p;
        j[(1, 1)] = s + q * v * v;
        dp[0] = -2.0 * p * u - d * v;
        dp[1] = -2.0 * p * v + d * u;
    })
}

/// Discriminant in `a` of the cubic (3k/4)^2 a^3 + 2 (3k/4) c a^2 + (c^2 + d^2 p^2) a - f^2, c = 1 - p^2.
fn discriminant(p: f64, d: f64, k: f64, f: f64) -> f64 {
    let (g, c) = (0.75 * k, 1.0 - p * p);
    let (a3, a2, a1, a0) = (g * g, 2.0 * g * c, c * c + d * d * p * p, -f * f);
    18.0 * a3 * a2 * a1 * a0 - 4.0 * a2.powi(3) * a0 + a2 * a2 * a1 * a1 - 4.0 * a3 * a1.powi(3) - 27.0 * a3 * a3 * a0 * a0
}

fn root(f: impl Fn(f64) -> f64, mut a: f64, mut b: f64) -> f64 {
    let left = f(a) < 0.0;
    assert_ne!(left, f(b) < 0.0);
    for _ in 0..200 {
        let m = 0.5 * (a + b);
        if (f(m) < 0.0) == left { a = m } else { b = m }
    }
    0.5 * (a + b)
}

#[test]
fn duffing_folds_are_zeros_of_the_discriminant() {
    let (d, k, f) = (0.05, 0.1, 0.2);
    let b = trace(&mut duffing(d, k, f), &[0.2, 0.0], 0.1, Direction::Up, &Settings::new(0.1, 3.0), &mut []).unwrap();
    assert_eq!(b.end, End::Reached);
    assert_eq!(b.points[b.points.len() - 1].p, 3.0);
    let found = folds(&b);
    assert_eq!((found.len(), b.specials.len()), (2, 2));
    let disc = |p| discriminant(p, d, k, f);
    let mut exact = Vec::new();
    for i in 0..2900 {
        let (l, r) = (0.1 + 1e-3 * i as f64, 0.1 + 1e-3 * (i + 1) as f64);
        if (disc(l) < 0.0) != (disc(r) < 0.0) {
            exact.push(root(disc, l, r));
        }
    }
    assert_eq!(exact.len(), 2);
    // upper branch first: its fold has the larger frequency
    for (fold, exact) in found.iter().zip(exact.iter().rev()) {
        assert!((fold.point.p - exact).abs() < 1e-11, "{} {exact}", fold.point.p);
        assert_eq!(fold.status, Status::Confirmed);
        let polished = fold.fold.as_ref().unwrap();
        assert!(polished.p_difference.abs() < 1e-13 && polished.x_difference < 1e-8, "{polished:?}");
    }
}

/// Lightly damped and linear: a spike 1e-3 wide and tall, with no fold; the branch must not turn back at its tip.
#[test]
fn a_sharp_peak_does_not_reverse_the_branch() {
    for d in [1e-2, 1e-3, 1e-4] {
        let b = trace(&mut duffing(d, 0.0, 0.1), &[0.1, 0.0], 0.0, Direction::Up, &Settings::new(0.0, 2.0), &mut []).unwrap();
        assert_eq!(b.end, End::Reached, "damping {d}");
        assert!(b.specials.is_empty() && b.points.windows(2).all(|w| w[1].p > w[0].p));
        let top = b.points.iter().map(|q| q.x[0].hypot(q.x[1])).fold(0.0, f64::max);
        assert!((top / (0.1 / (d * (1.0 - 0.25 * d * d).sqrt())) - 1.0).abs() < 0.02, "{top}");
    }
}

#[test]
fn results_do_not_depend_on_units() {
    let run = |x_unit, p_unit, r_unit| {
        let mut z = duffing(0.05, 0.1, 0.2);
        (z.x_unit, z.p_unit, z.r_unit) = (x_unit, p_unit, r_unit);
        let set = Settings::new(0.1 * p_unit, 3.0 * p_unit);
        trace(&mut z, &[0.2 * x_unit, 0.0], 0.1 * p_unit, Direction::Up, &set, &mut []).unwrap()
    };
    let (a, b) = (run(1.0, 1.0, 1.0), run(3e-6, 700.0, 1.1e7));
    assert_eq!(a.points.len(), b.points.len());
    for (a, b) in a.specials.iter().zip(&b.specials) {
        assert!((b.point.p / 700.0 - a.point.p).abs() < 1e-13 && (b.point.x[0] / 3e-6 - a.point.x[0]).abs() < 1e-8);
    }
    for (a, b) in a.points.iter().zip(&b.points) {
        assert!((b.p / 700.0 - a.p).abs() < 1e-6 && (b.s - a.s).abs() < 1e-6);
    }
}

/// (x^2 - 1)^2 + (p - 1)^2 = 1/4: two detached loops.
#[test]
fn a_detached_loop_closes() {
    let mut z = problem(1, |x, p, r, j, dp| {
        let q = x[0] * x[0] - 1.0;
        r[0] = q * q + (p - 1.0).powi(2) - 0.25;
        j[(0, 0)] = 4.0 * q * x[0];
        dp[0] = 2.0 * (p - 1.0);
    });
    let b = trace(&mut z, &[1.2], 1.2, Direction::Down, &Settings::new(0.0, 3.0), &mut []).unwrap();
    assert_eq!(b.end, End::Closed);
    let mut p: Vec<f64> = folds(&b).iter().map(|f| f.point.p).collect();
    p.sort_by(f64::total_cmp);
    assert!(p.len() == 2 && (p[0] - 0.5).abs() < 1e-14 && (p[1] - 1.5).abs() < 1e-14);
    assert!(b.points.iter().all(|q| q.x[0] > 0.0));
}

#[test]
fn where_the_law_ends_the_points_so_far_are_kept() {
    let mut z = graph(|x| if x > 0.7 { f64::NAN } else { -x }, |_| -1.0);
    let b = trace(&mut z, &[0.0], 0.0, Direction::Up, &Settings::new(0.0, 2.0), &mut []).unwrap();
    let End::StepTooSmall { at, why } = b.end else { panic!("{:?}", b.end) };
    assert_eq!(why, Refusal::Corrector(Cause::NotFinite));
    assert!(b.points.len() > 5 && at <= 0.7 && at > 0.7 - 1e-8 && b.points.iter().all(|q| q.p.is_finite()), "{at}");
}

#[test]
fn a_bad_start_a_stop_and_a_limit_are_ends() {
    let set = Settings::new(0.0, 2.0);
    let none = trace(&mut graph(|x| x * x + 1.0, |x| 2.0 * x), &[1.0], 0.0, Direction::Up, &set, &mut []).unwrap();
    assert!(matches!(none.end, End::NewtonFailed { residual, .. } if residual > 0.0) && none.points.is_empty());
    let mut z = graph(|x| -x, |_| -1.0);
    z.budget = 12;
    let b = trace(&mut z, &[0.0], 0.0, Direction::Up, &set, &mut []).unwrap();
    assert!(b.end == End::Cancelled && b.points.len() > 1);
    let mut z = graph(|x| -x, |_| -1.0);
    let few = Settings { max_points: 4, ..set.clone() };
    let b = trace(&mut z, &[0.0], 0.0, Direction::Up, &few, &mut []).unwrap();
    assert!(b.end == End::MaxPoints && b.points.len() == 4);
    assert!(trace(&mut z, &[0.0], 5.0, Direction::Up, &set, &mut []).is_err());
    assert!(trace(&mut z, &[0.0], 1.0, Direction::Up, &Settings::new(1.0, f64::NAN), &mut []).is_err());
}

/// At the edge the range may cut a fold off: the branch must end there.
#[test]
fn a_fold_just_outside_the_range_ends_the_branch_on_the_edge() {
    for over in [1e-3, 1e-5, 1e-8] {
        let hi = 1.0 - over;
        let b = trace(&mut circle(), &[1.0], 0.0, Direction::Up, &Settings::new(-0.5, hi), &mut []).unwrap();
        assert!(b.end == End::Reached && b.points[b.points.len() - 1].p == hi && b.specials.is_empty(), "{:?}", b.end);
        assert!(b.points.iter().all(|q| q.p <= hi));
    }
}

#[test]
fn a_user_test_is_located_and_a_jump_is_only_bracketed() {
    let mut tests: Vec<Test<'_, Problem>> =
        vec![Box::new(|_, q| q.x[0] - 0.3), Box::new(|_, q| if q.x[0] > 0.4 { 1.0 } else { -1.0 }), Box::new(|_, _| f64::NAN)];
    let mut z = graph(|x| -x - x * x * x, |x| -1.0 - 3.0 * x * x);
    let b = trace(&mut z, &[0.0], 0.0, Direction::Up, &Settings::new(0.0, 2.0), &mut tests).unwrap();
    assert_eq!(b.specials.len(), 2);
    let (a, c) = (&b.specials[0], &b.specials[1]);
    assert!(a.kind == Kind::User(0) && a.status == Status::Located && (a.point.p - 0.327).abs() < 1e-10);
    assert!(c.kind == Kind::User(1) && c.status == Status::Bracketed);
    assert!(c.bracket[0].p < 0.464 + 1e-10 && c.bracket[1].p > 0.464 - 1e-10);
    assert_eq!(b.counters.undefined_tests, b.points.len());
}

/// Two planes that fold together, `p = x_i - x_i^3`: [dr/dx dr/dp] has two null vectors there, and the branch x1 = x2 crosses the ellipse
/// `x1^2 + x1 x2 + x2^2 = 1` on which they part. On both the parameter has its extremum at the crossing: a branch point, and no simple fold.
#[test]
fn planes_that_fold_together_cross_the_branch_on_which_they_part() {
    let z = || {
        problem(2, |x, p, r, j, dp| {
            for i in 0..2 {
                r[i] = x[i].powi(3) - x[i] + p;
                j[(i, i)] = 3.0 * x[i] * x[i] - 1.0;
                dp[i] = 1.0;
            }
        })
    };
    let set = Settings::new(-2.0, 2.0);
    let x0 = 0.9f64;
    let b = trace(&mut z(), &[x0, x0], x0 - x0.powi(3), Direction::Up, &set, &mut []).unwrap();
    let kinds: Vec<Kind> = b.specials.iter().map(|s| s.kind).collect();
    assert_eq!(kinds, [Kind::BranchPoint, Kind::ParameterExtremum, Kind::BranchPoint, Kind::ParameterExtremum], "{:?}", b.specials);
    for (k, s) in b.specials.iter().enumerate() {
        let sign = if k < 2 { 1.0 } else { -1.0 };
        assert!((s.point.p - sign * 2.0 / (3.0 * 3f64.sqrt())).abs() < 1e-14 && s.status == Status::Confirmed, "{s:?}");
        assert!(s.point.x.iter().all(|x| (x - sign / 3f64.sqrt()).abs() < 1e-12), "{s:?}");
        assert!(s.fold.is_none(), "{s:?}");
        let parting = cross(&mut z(), &s.point, &set).unwrap();
        assert_eq!(parting.len(), 2);
        for c in parting {
            let [x, y] = c.x[..] else { panic!("{c:?}") };
            assert!((x * x + x * y + y * y - 1.0).abs() < 1e-12 && (x - y).abs() > 1e-3, "{c:?}");
            // away from it the parameter falls on the upper one, and rises on the lower
            assert!(sign * (s.point.p - c.p) > 0.0 && (c.direction == Direction::Down) == (k < 2), "{c:?}");
        }
    }
}

fn pitchfork() -> Problem {
    problem(1, |x, p, r, j, dp| {
        r[0] = p * x[0] - x[0].powi(3);
        j[(0, 0)] = p - 3.0 * x[0] * x[0];
        dp[0] = x[0];
    })
}

/// From the line x = 0 onto x^2 = p, both halves, away from the branch point.
#[test]
fn the_bent_branch_of_a_pitchfork_is_reached() {
    let set = Settings::new(-2.0, 1.0);
    let line = trace(&mut pitchfork(), &[0.0], -1.03, Direction::Up, &set, &mut []).unwrap();
    let at = &line.of(Kind::BranchPoint).next().unwrap().point;
    let found = cross(&mut pitchfork(), at, &set).unwrap();
    assert_eq!(found.len(), 2);
    assert!(found[0].x[0] * found[1].x[0] < 0.0);
    for c in found {
        assert!((c.null_vector[0].abs() - 1.0).abs() < 1e-8, "{c:?}");
        let b = trace(&mut pitchfork(), &c.x, c.p, c.direction, &set, &mut []).unwrap();
        assert_eq!((b.end, b.points[b.points.len() - 1].p), (End::Reached, 1.0));
        assert!(b.specials.is_empty() && b.points.iter().all(|q| (q.x[0] * q.x[0] - q.p).abs() < 1e-9 && q.x[0] * c.x[0] > 0.0));
    }
}

/// Two iterates of the logistic map f = p x (1 - x): the fixed point 1 - 1/p doubles its period at p = 3, where the cycle
/// `(p + 1 -+ sqrt((p + 1)(p - 3))) / (2 p)` leaves it.
#[test]
fn a_doubled_period_branches_off_the_fixed_point() {
    let z = || {
        problem(2, |x, p, r, j, dp| {
            for (i, k) in [(0, 1), (1, 0)] {
                r[i] = p * x[i] * (1.0 - x[i]) - x[k];
                j[(i, i)] = p * (1.0 - 2.0 * x[i]);
                j[(i, k)] = -1.0;
                dp[i] = x[i] * (1.0 - x[i]);
            }
        })
    };
    let set = Settings::new(1.5, 3.4);
    let x0 = 1.0 - 1.0 / 1.6;
    let fixed = trace(&mut z(), &[x0, x0], 1.6, Direction::Up, &set, &mut []).unwrap();
    let points: Vec<&Special> = fixed.of(Kind::BranchPoint).collect();
    assert!(points.len() == 1 && (points[0].point.p - 3.0).abs() < 1e-8, "{points:?}");
    let found = cross(&mut z(), &points[0].point, &set).unwrap();
    assert_eq!(found.len(), 2);
    for c in found {
        let b = trace(&mut z(), &c.x, c.p, c.direction, &set, &mut []).unwrap();
        assert_eq!(b.points[b.points.len() - 1].p, 3.4);
        for q in &b.points {
            let root = ((q.p + 1.0) * (q.p - 3.0)).sqrt();
            let (low, high) = ((q.p + 1.0 - root) / (2.0 * q.p), (q.p + 1.0 + root) / (2.0 * q.p));
            let (a, b) = (q.x[0].min(q.x[1]), q.x[0].max(q.x[1]));
            assert!((a - low).abs() < 1e-8 && (b - high).abs() < 1e-8, "{q:?} {low} {high}");
        }
    }
}

/// On a circle of radius 1 the abscissa 0.6 is met where p = 0.8, past the fold too.
#[test]
fn a_zero_is_found_between_two_points_of_a_branch() {
    let set = Settings::new(-3.0, 3.0);
    let b = trace(&mut circle(), &[0.9], 0.19f64.sqrt(), Direction::Up, &set, &mut []).unwrap();
    let mut met = 0;
    for w in b.points.windows(2) {
        for target in [0.6, -0.3] {
            let g = |q: &Point| q.x[0] - target;
            if (g(&w[0]) < 0.0) == (g(&w[1]) < 0.0) {
                continue;
            }
            let z = zero_between(&mut circle(), [&w[0], &w[1]], [g(&w[0]), g(&w[1])], &set, |_, q| g(q)).unwrap();
            let want = (1.0 - target * target).sqrt();
            assert!((z.point.p.abs() - want).abs() < 1e-13 && z.status == Status::Located && z.width() < 1e-9, "{z:?}");
            met += 1;
        }
    }
    assert_eq!(met, 4);
}
