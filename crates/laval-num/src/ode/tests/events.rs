//! Events on closed forms.

use super::*;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

fn oscillator() -> impl Ode {
    ode(2, |_, y, dy| dy.copy_from_slice(&[y[1], -y[0]]))
}

fn tight() -> Control<'static> {
    Control::new(1e-14, 1e-14)
}

#[test]
fn zeros_of_a_cosine_are_located_in_order() {
    let (q, v) = (|_: f64, y: &[f64]| y[0], |_: f64, y: &[f64]| y[1]);
    let events = [Event::new(&q), Event::new(&v).direction(Direction::Rising)];
    let (mut y, mut record) = ([1.0, 0.0], Record::default());
    let control = Control { events: &events, ..tight() };
    integrate(&mut Dop853::new(), &mut oscillator(), 0.0, &mut y, 20.0, &control, &mut record);
    // q = cos t; q' = -sin t rises through zero at pi, 3 pi, ...
    let mut expected: Vec<(usize, f64)> =
        (0..6).map(|k| (0, FRAC_PI_2 + k as f64 * PI)).chain((0..3).map(|k| (1, PI + k as f64 * TAU))).collect();
    expected.sort_by(|a, b| a.1.total_cmp(&b.1));
    assert_eq!(record.events.len(), expected.len(), "{:?}", record.events);
    for ((e, (index, t)), y) in record.events.iter().zip(expected).zip(record.event_states.chunks(2)) {
        assert_eq!(e.index, index);
        assert!((e.t - t).abs() < 1e-12, "{e:?} {t}");
        assert!(e.bracket.0 <= e.t && e.t == e.bracket.1 && e.bracket.1 - e.bracket.0 < 2e-14);
        assert!(y[index].abs() < 1e-12);
    }
}

#[test]
fn directions_are_seen_along_the_integration() {
    let q = |_: f64, y: &[f64]| y[0];
    for (t1, direction, expected) in [
        (8.0, Direction::Any, vec![FRAC_PI_2, 3.0 * FRAC_PI_2, 5.0 * FRAC_PI_2]),
        (8.0, Direction::Falling, vec![FRAC_PI_2, 5.0 * FRAC_PI_2]),
        (8.0, Direction::Rising, vec![3.0 * FRAC_PI_2]),
        (-8.0, Direction::Falling, vec![-FRAC_PI_2, -5.0 * FRAC_PI_2]),
        (-8.0, Direction::Rising, vec![-3.0 * FRAC_PI_2]),
    ] {
        let events = [Event::new(&q).direction(direction)];
        let (mut y, mut record) = ([1.0, 0.0], Record::default());
        integrate(&mut Dop853::new(), &mut oscillator(), 0.0, &mut y, t1, &Control { events: &events, ..tight() }, &mut record);
        assert_eq!(record.events.len(), expected.len(), "{direction:?} {:?}", record.events);
        assert!(record.events.iter().zip(expected).all(|(e, t)| (e.t - t).abs() < 1e-12));
    }
}

#[test]
fn many_events_of_one_step_come_in_order_among_the_outputs() {
    struct Log(Vec<f64>);
    impl Observer for Log {
        fn output(&mut self, _: usize, t: f64, _: &[f64]) {
            self.0.push(t);
        }
        fn event(&mut self, c: &Crossing, _: &[f64]) {
            self.0.push(c.t);
        }
        fn step(&mut self, s: &Step<'_>) {
            self.0.push(s.t1);
        }
    }
    // a straight line is one step
    let levels = [0.7, 0.1, 0.35, 0.30, 0.95];
    let g: Vec<_> = levels.iter().map(|l| move |_: f64, y: &[f64]| y[0] - l).collect();
    let events: Vec<Event> = g.iter().map(|g| Event::new(g)).collect();
    let outputs = [0.0, 0.2, 0.32, 0.8, 1.0];
    for terminal in [false, true] {
        let mut events = events.clone();
        if terminal {
            events[0] = events[0].terminal();
        }
        let control = Control { first_step: Some(1.0), outputs: &outputs, events: &events, ..Control::new(1e-9, 1e-9) };
        let (mut y, mut log) = ([0.0], Log(vec![]));
        let run = integrate(&mut Dop853::new(), &mut ode(1, |_, _, dy| dy[0] = 1.0), 0.0, &mut y, 1.0, &control, &mut log);
        let all = [0.0, 0.1, 0.2, 0.30, 0.32, 0.35, 0.7, 0.8, 0.95, 1.0, 1.0];
        let expected: Vec<f64> = if terminal { all[..7].iter().copied().chain([0.7]).collect() } else { all.to_vec() };
        assert!(run.work.steps == 1 && distance(&log.0, &expected) < 1e-14, "{:?}", log.0);
        if terminal {
            assert_eq!(run.end, End::Event { index: 0, t: run.t });
            assert!((y[0] - 0.7).abs() < 1e-15 && y[0] >= 0.7);
        }
    }
}

#[test]
fn one_event_may_occur_twice_in_a_step() {
    let g = |_: f64, y: &[f64]| (y[0] - 0.3) * (y[0] - 0.8);
    let events = [Event::new(&g)];
    let control = Control { first_step: Some(1.0), events: &events, ..tight() };
    let (mut y, mut record) = ([0.0], Record::default());
    let run = integrate(&mut Dop853::new(), &mut ode(1, |_, _, dy| dy[0] = 1.0), 0.0, &mut y, 1.0, &control, &mut record);
    let found: Vec<f64> = record.events.iter().map(|e| e.t).collect();
    assert!(run.work.steps == 1 && distance(&found, &[0.3, 0.8]) < 1e-15, "{found:?}");
    assert_eq!([Direction::Falling, Direction::Rising], [record.events[0].direction, record.events[1].direction]);
}

#[test]
fn a_run_continued_from_an_event_does_not_meet_it_again() {
    let q = |_: f64, y: &[f64]| y[0];
    let events = [Event::new(&q).terminal()];
    let control = Control { events: &events, ..tight() };
    let (mut y, mut t) = ([1.0, 0.0], 0.0);
    for k in 0..8 {
        let run = integrate(&mut Dop853::new(), &mut oscillator(), t, &mut y, 100.0, &control, &mut ());
        t = run.t;
        assert_eq!(run.end, End::Event { index: 0, t });
        assert!((t - FRAC_PI_2 - k as f64 * PI).abs() < 1e-12, "{t}");
    }
}

#[test]
fn an_event_at_the_start_is_not_reported() {
    // exactly zero, and off zero by a rounding on either side
    let q = |_: f64, y: &[f64]| y[0];
    for start in [0.0, 1e-17, -1e-17] {
        for rate in [1.0, -1.0] {
            let events = [Event::new(&q)];
            let (mut y, mut record) = ([start, rate], Record::default());
            integrate(&mut Dop853::new(), &mut oscillator(), 0.0, &mut y, 4.0, &Control { events: &events, ..tight() }, &mut record);
            assert_eq!(record.events.len(), 1, "{start} {rate}: {:?}", record.events);
            assert!((record.events[0].t - PI).abs() < 1e-12);
        }
    }
}

#[test]
fn a_bouncing_ball_keeps_its_closed_form() {
    let height = |_: f64, y: &[f64]| y[0];
    let events = [Event::new(&height).direction(Direction::Falling).terminal()];
    let control = Control { events: &events, ..tight() };
    let mut ball = ode(2, |_, y, dy| (dy[0], dy[1]) = (y[1], -10.0));
    let (mut y, mut t, mut expected) = ([5.0, 0.0], 0.0, 1.0);
    for k in 0..12 {
        let run = integrate(&mut Dop853::new(), &mut ball, t, &mut y, 100.0, &control, &mut ());
        assert!((run.t - expected).abs() < 1e-12, "bounce {k}: {run:?} {expected}");
        t = run.t;
        y = [0.0, -0.7 * y[1]];
        expected += 2.0 * 0.7f64.powi(k + 1);
    }
}

#[test]
fn a_zero_met_exactly_at_the_end_counts() {
    let g = |t: f64, _: &[f64]| t - 1.0;
    let events = [Event::new(&g)];
    let (mut y, mut record) = ([1.0, 0.0], Record::default());
    integrate(&mut Dop853::new(), &mut oscillator(), 0.0, &mut y, 1.0, &Control { events: &events, ..tight() }, &mut record);
    assert_eq!(record.events.len(), 1);
    assert_eq!((record.events[0].t, record.events[0].direction), (1.0, Direction::Rising));
    // and is not counted again by the next run
    integrate(&mut Dop853::new(), &mut oscillator(), 1.0, &mut y, 2.0, &Control { events: &events, ..tight() }, &mut record);
    assert_eq!(record.events.len(), 1);
}

#[test]
fn an_event_that_is_not_a_number_fails() {
    let g = |t: f64, _: &[f64]| if t > 1.0 { f64::NAN } else { 1.0 };
    for t0 in [0.0, 2.0] {
        let events = [Event::new(&g)];
        let mut y = [1.0, 0.0];
        let run = integrate(&mut Dop853::new(), &mut oscillator(), t0, &mut y, 5.0, &Control { events: &events, ..tight() }, &mut ());
        assert_eq!(run.end, End::Failed { t: run.t, what: "event 0 is not a number".to_string().into() });
        assert!(y.iter().all(|y| y.is_finite()));
    }
}

#[test]
fn the_implicit_method_locates_events_on_its_own_interpolant() {
    // a quadratic is exact on a cubic interpolant
    struct Fall;
    impl Ode for Fall {
        fn dim(&self) -> usize {
            2
        }
        fn rhs(&mut self, _: f64, y: &[f64], dy: &mut [f64]) -> Result<(), Failure> {
            (dy[0], dy[1]) = (y[1], -10.0);
            Ok(())
        }
    }
    impl StiffOde for Fall {
        fn jacobian(&mut self, _: f64, _: &[f64], jac: &mut Mat) -> Result<(), Failure> {
            jac[(0, 1)] = 1.0;
            Ok(())
        }
    }
    let height = |_: f64, y: &[f64]| y[0];
    let events = [Event::new(&height).terminal()];
    let mut y = [5.0, 0.0];
    let run = integrate(&mut Radau::new(), &mut Fall, 0.0, &mut y, 9.0, &Control { events: &events, ..Control::new(1e-8, 1e-8) }, &mut ());
    assert_eq!(run.end, End::Event { index: 0, t: run.t });
    assert!((run.t - 1.0).abs() < 1e-12 && (y[1] + 10.0).abs() < 1e-11, "{run:?}");
}
