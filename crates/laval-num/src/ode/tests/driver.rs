//! Ends, limits, outputs and steps.

use super::*;
use std::cell::Cell;

fn oscillator() -> impl Ode {
    ode(2, |_, y, dy| dy.copy_from_slice(&[y[1], -y[0]]))
}

#[test]
fn outputs_come_on_the_grid_in_both_directions() {
    let grid: Vec<f64> = (0..=40).map(|i| i as f64 * 0.25).collect();
    let back: Vec<f64> = grid.iter().rev().copied().collect();
    for (t0, t1, outputs) in [(0.0f64, 10.0f64, &grid), (10.0, 0.0, &back)] {
        let mut y = [t0.cos(), -t0.sin()];
        let mut record = Record::with_capacity(outputs.len(), 2);
        let control = Control { outputs, ..Control::new(1e-12, 1e-12) };
        let run = integrate(&mut Dop853::new(), &mut oscillator(), t0, &mut y, t1, &control, &mut record);
        assert_eq!((run.end, run.t), (End::Reached, t1));
        assert_eq!(&record.times, outputs);
        for (t, y) in outputs.iter().zip(record.states.chunks(2)) {
            assert!((y[0] - t.cos()).abs() < 1e-10 && (y[1] + t.sin()).abs() < 1e-10, "{t}: {y:?}");
        }
        assert_eq!(record.states[80..], y);
    }
}

#[test]
fn steps_join_without_gaps() {
    fn joins<M: Method<Forced>>(method: &mut M) {
        let mut last = (0.0, Forced::exact(0.0).to_vec());
        let mut y = Forced::exact(0.0);
        let mut watch = |s: &Step<'_>| {
            let mut w = [0.0; 3];
            assert_eq!((s.t0, s.y0), (last.0, &last.1[..]));
            s.eval(s.t0, &mut w);
            assert_eq!(w, s.y0);
            s.eval(s.t1, &mut w);
            assert_eq!(w, s.y1);
            s.eval(s.t1 - 1e-13 * (s.t1 - s.t0), &mut w);
            assert!(distance(&w, s.y1) < 1e-12);
            last = (s.t1, s.y1.to_vec());
        };
        integrate(method, &mut Forced, 0.0, &mut y, 5.0, &Control::new(1e-9, 1e-9), &mut watch);
        assert_eq!(last, (5.0, y.to_vec()));
    }
    joins(&mut Dop853::new());
    joins(&mut Radau::new());
}

#[test]
fn a_right_side_that_is_not_finite_ends_with_a_small_step() {
    fn ends<M: Method<Bell> + Method<Edge>>(method: &mut M) {
        for edge in [Edge { at: 0.5, value: f64::NAN }, Edge { at: 0.5, value: f64::INFINITY }] {
            let mut system = edge;
            let mut y = [0.0];
            let run = integrate(method, &mut system, 0.0, &mut y, 1.0, &Control::new(1e-8, 1e-8), &mut ());
            let End::StepTooSmall { t, cause } = run.end else { panic!("{:?}", run.end) };
            assert_eq!((t, cause), (run.t, Cause::NotFinite));
            assert!(t <= 0.5 && t > 0.5 - 1e-12 && (y[0] - t).abs() < 1e-12, "{t} {y:?}");
        }
        let mut y = [2.0];
        let run = integrate(method, &mut Edge { at: -1.0, value: f64::NAN }, 0.0, &mut y, 1.0, &Control::new(1e-8, 1e-8), &mut ());
        assert_eq!((run.end, y), (End::StepTooSmall { t: 0.0, cause: Cause::NotFinite }, [2.0]));
    }
    ends(&mut Dop853::new());
    ends(&mut Radau::new());
}

/// y' = 1 before `at`, `value` after.
struct Edge {
    at: f64,
    value: f64,
}

impl Ode for Edge {
    fn dim(&self) -> usize {
        1
    }
    fn rhs(&mut self, t: f64, _: &[f64], dy: &mut [f64]) -> Result<(), Failure> {
        dy[0] = if t < self.at { 1.0 } else { self.value };
        Ok(())
    }
}

impl StiffOde for Edge {
    fn jacobian(&mut self, _: f64, _: &[f64], _: &mut Mat) -> Result<(), Failure> {
        Ok(())
    }
}

#[test]
fn a_blow_up_is_met_and_reported() {
    // y = 1/(1 - t)
    let mut y = [1.0];
    let run =
        integrate(&mut Dop853::new(), &mut ode(1, |_, y, dy| dy[0] = y[0] * y[0]), 0.0, &mut y, 2.0, &Control::new(1e-8, 1e-8), &mut ());
    assert!(matches!(run.end, End::StepTooSmall { .. }), "{:?}", run.end);
    assert!((run.t - 1.0).abs() < 1e-6 && y[0] > 1e5 && y[0].is_finite());
}

#[test]
fn a_failure_keeps_the_last_state() {
    struct Broken;
    impl Ode for Broken {
        fn dim(&self) -> usize {
            1
        }
        fn rhs(&mut self, t: f64, y: &[f64], dy: &mut [f64]) -> Result<(), Failure> {
            dy[0] = -y[0];
            if t > 1.0 { Err("out of the table".into()) } else { Ok(()) }
        }
    }
    let mut y = [1.0];
    let mut steps = 0;
    let run = integrate(&mut Dop853::new(), &mut Broken, 0.0, &mut y, 2.0, &Control::new(1e-9, 1e-9), &mut |_: &Step<'_>| steps += 1);
    assert_eq!(run.end, End::Failed { t: run.t, what: "out of the table".into() });
    assert!(run.t > 0.0 && run.t <= 1.0 && (y[0] - (-run.t).exp()).abs() < 1e-8 && steps == run.work.steps);
}

#[test]
fn limits_and_cancellation_end_where_they_strike() {
    let mut y = [1.0, 0.0];
    let control = Control { max_steps: 7, ..Control::new(1e-9, 1e-9) };
    let run = integrate(&mut Dop853::new(), &mut oscillator(), 0.0, &mut y, 100.0, &control, &mut ());
    assert_eq!((run.end.clone(), run.work.steps + run.work.rejected), (End::WorkLimit { t: run.t }, 7));
    assert!((y[0] - run.t.cos()).abs() < 1e-7);

    let requested = Cell::new(0);
    let cancel = || {
        requested.set(requested.get() + 1);
        requested.get() > 5
    };
    let control = Control { cancel: Some(&cancel), ..Control::new(1e-9, 1e-9) };
    let run = integrate(&mut Dop853::new(), &mut oscillator(), 0.0, &mut y, 100.0, &control, &mut ());
    assert_eq!((run.end.clone(), run.work.steps + run.work.rejected), (End::Cancelled { t: run.t }, 5));

    // the longest step is kept
    let mut longest = 0.0f64;
    let control = Control { max_step: 0.01, ..Control::new(1e-3, 1e-3) };
    integrate(&mut Dop853::new(), &mut oscillator(), 0.0, &mut y, 1.0, &control, &mut |s: &Step<'_>| longest = longest.max(s.t1 - s.t0));
    assert!(longest <= 0.01 * 1.011 && longest > 0.009, "{longest}");
}

#[test]
fn senseless_requests_fail_at_once() {
    let good = || Control::new(1e-6, 1e-6);
    let mut cases: Vec<(f64, Vec<f64>, f64, Control)> = vec![
        (0.0, vec![1.0], 1.0, good()),
        (0.0, vec![1.0, f64::NAN], 1.0, good()),
        (0.0, vec![1.0, 0.0], f64::NAN, good()),
        (f64::INFINITY, vec![1.0, 0.0], 1.0, good()),
    ];
    for control in [
        Control::new(-1e-6, 1e-6),
        Control::new(f64::NAN, 1e-6),
        Control::new(0.0, 0.0),
        Control::new(1e-6, vec![1e-6]),
        Control::new(vec![1e-6, 0.0], vec![1e-6, 0.0]),
        Control { max_step: 0.0, ..good() },
        Control { max_step: f64::NAN, ..good() },
        Control { first_step: Some(-1.0), ..good() },
        Control { outputs: &[0.5, 0.25], ..good() },
        Control { outputs: &[1.5], ..good() },
        Control { outputs: &[f64::NAN], ..good() },
    ] {
        cases.push((0.0, vec![1.0, 0.0], 1.0, control));
    }
    for (i, (t0, mut y, t1, control)) in cases.into_iter().enumerate() {
        let run = integrate(&mut Dop853::new(), &mut oscillator(), t0, &mut y, t1, &control, &mut ());
        assert!(matches!(run.end, End::Failed { .. }) && run.work.steps == 0, "case {i}: {run:?}");
    }
}

#[test]
fn an_empty_interval_and_an_empty_state_are_fine() {
    let (mut y, mut record) = ([1.0, 0.0], Record::default());
    let control = Control { outputs: &[3.0], ..Control::new(1e-6, 1e-6) };
    let run = integrate(&mut Dop853::new(), &mut oscillator(), 3.0, &mut y, 3.0, &control, &mut record);
    assert_eq!((run.end, run.work.steps, record.times, record.states), (End::Reached, 0, vec![3.0], vec![1.0, 0.0]));
    let run = integrate(&mut Dop853::new(), &mut ode(0, |_, _, _| ()), 0.0, &mut [], 1.0, &Control::new(1e-6, 1e-6), &mut ());
    assert_eq!(run.end, End::Reached);
}

#[test]
fn a_late_and_long_clock_still_resolves_its_steps() {
    // steps of 1e-3 at t = 1e6 are resolved to 1e-7 of their length only, which must not show
    let mut fast = ode(2, |_, y, dy| dy.copy_from_slice(&[1e3 * y[1], -1e3 * y[0]]));
    let mut y = [1.0, 0.0];
    let t1 = 1e6 + 0.125;
    let run = integrate(&mut Dop853::new(), &mut fast, 1e6, &mut y, t1, &Control::new(1e-11, 1e-11), &mut ());
    assert_eq!(run.end, End::Reached);
    assert!((y[0] - 125f64.cos()).abs() < 1e-8 && (y[1] + 125f64.sin()).abs() < 1e-8, "{y:?}");
}
