//! Ensembles against closed forms, against the one-member integrator, and against themselves with other neighbours.

use super::*;
use crate::lanes::{Kernel, Level, dispatch};
use crate::ode::{Control, Dop853 as Scalar853, End, integrate, ode};

/// Forced oscillators x'' = -w^2 x - d x' + cos(v t), v, w, d by member.
struct Oscillators<'a, S> {
    parameters: [S; 3],
    /// x is known as a position.
    positions: usize,
    queue: std::slice::Iter<'a, Member>,
    riding: [Option<Member>; LANES],
    results: &'a mut Vec<(usize, Ended, Vec<f64>)>,
    outputs: &'a mut Vec<(usize, u64, f64, f64)>,
}

#[derive(Clone, Copy, Debug)]
struct Member {
    id: usize,
    w: f64,
    d: f64,
    v: f64,
    t1: f64,
    outputs: Grid,
    /// Ends where x crosses this level.
    level: Option<f64>,
    tolerance: f64,
    start: f64,
}

impl<S: LaneScalar> EnsembleProblem<S> for Oscillators<'_, S> {
    fn dim(&self) -> usize {
        2
    }
    fn positions(&self) -> usize {
        self.positions
    }
    fn time(&mut self, _: S) {}
    #[inline(always)]
    fn rhs(&mut self, t: S, y: &mut [S], dy: &mut [S]) {
        let [w, d, v] = self.parameters;
        if self.positions == 0 {
            dy[0] = y[1];
        }
        dy[1 - self.positions] = (v * t).sin_cos().1 - w * w * y[0] - d * y[1];
    }
    fn load(&mut self, lane: usize, seat: Seat) -> Option<Leg> {
        let m = *self.queue.next()?;
        self.riding[lane] = Some(m);
        for (p, x) in self.parameters.iter_mut().zip([m.w, m.d, m.v]) {
            *p = p.with(lane, x);
        }
        seat.y.copy_from_slice(&[m.start, 0.0]);
        seat.relative.fill(m.tolerance);
        seat.absolute.fill(m.tolerance);
        Some(Leg { outputs: m.outputs, ..Leg::new(0.0, m.t1) })
    }
    fn ended(&mut self, lane: usize, ended: &Ended, y: &mut [f64]) -> Option<Leg> {
        self.results.push((self.riding[lane]?.id, *ended, y.to_vec()));
        None
    }
    fn output(&mut self, lane: usize, index: u64, t: f64, y: &[f64]) {
        if let Some(m) = self.riding[lane] {
            self.outputs.push((m.id, index, t, y[0]));
        }
    }
    fn events(&self) -> usize {
        1
    }
    fn event(&mut self, lane: usize, _: usize, _: f64, y: &[f64]) -> f64 {
        self.riding[lane].and_then(|m| m.level).map_or(1.0, |level| y[0] - level)
    }
}

#[derive(Default, PartialEq, Debug)]
struct Found {
    results: Vec<(usize, Ended, Vec<f64>)>,
    outputs: Vec<(usize, u64, f64, f64)>,
}

/// The members, and of how many states it is said that they are positions.
struct Go<'a>(&'a [Member], usize);
impl Kernel for Go<'_> {
    type Out = Found;
    #[inline(always)]
    fn run<S: LaneScalar>(self) -> Found {
        found(self.0, self.1, |problem: &mut Oscillators<S>| run(problem))
    }
}

struct GoStiff<'a>(&'a [Member]);
impl Kernel for GoStiff<'_> {
    type Out = Found;
    #[inline(always)]
    fn run<S: LaneScalar>(self) -> Found {
        found(self.0, 1, |problem: &mut Oscillators<S>| run_stiff(problem))
    }
}

#[inline(always)]
fn found<S: LaneScalar>(list: &[Member], positions: usize, go: impl FnOnce(&mut Oscillators<S>) -> bool) -> Found {
    let mut found = Found::default();
    let mut problem = Oscillators {
        parameters: [S::one(); 3],
        positions,
        queue: list.iter(),
        riding: [None; LANES],
        results: &mut found.results,
        outputs: &mut found.outputs,
    };
    assert!(go(&mut problem));
    found.results.sort_by_key(|r| r.0);
    found.outputs.sort_by_key(|o| (o.0, o.1));
    found
}

fn members(count: usize) -> Vec<Member> {
    let member = |id: usize| {
        let x = id as f64;
        Member {
            id,
            w: 1.0 + 0.37 * x,
            d: 0.02 * (x % 5.0),
            v: 0.5 + 0.11 * x,
            t1: 3.0 + (7.0 * x) % 11.0,
            outputs: Grid { start: 0.0, step: 0.25, count: 9 },
            level: None,
            tolerance: 1e-11,
            start: 1.0,
        }
    };
    (0..count).map(member).collect()
}

/// Undamped: x = A cos(v t) + (x0 - A) cos(w t), A = 1/(w^2 - v^2).
#[test]
fn many_members_follow_their_closed_forms() {
    let mut list = members(53);
    list.iter_mut().for_each(|m| m.d = 0.0);
    for level in Level::supported() {
        let found = dispatch(level, Go(&list, 1));
        assert_eq!(found.results.len(), 53);
        let exact = |m: &Member, t: f64| {
            let a = 1.0 / (m.w * m.w - m.v * m.v);
            a * (m.v * t).cos() + (m.start - a) * (m.w * t).cos()
        };
        for ((id, ended, y), m) in found.results.iter().zip(&list) {
            assert!(*id == m.id && ended.end == LegEnd::Reached && ended.t == m.t1, "{ended:?}");
            assert!((y[0] - exact(m, m.t1)).abs() < 1e-9, "{} {}", y[0], exact(m, m.t1));
        }
        assert_eq!(found.outputs.len(), 53 * 9);
        for &(id, i, t, x) in &found.outputs {
            assert!(t == 0.25 * i as f64 && (x - exact(&list[id], t)).abs() < 1e-8, "{id} {t} {x}");
        }
    }
}

/// The method is the same one whether positions are known as such: steps, ends, outputs and crossings.
#[test]
fn positions_change_nothing_but_the_work() {
    let mut list = members(40);
    list.iter_mut().filter(|m| m.id % 4 == 3).for_each(|m| m.level = Some(0.2));
    let (known, plain) = (dispatch(Level::best(), Go(&list, 1)), dispatch(Level::best(), Go(&list, 0)));
    for (a, b) in known.results.iter().zip(&plain.results) {
        assert_eq!((a.0, a.1.end, a.1.steps, a.1.rejected), (b.0, b.1.end, b.1.steps, b.1.rejected));
        assert!((a.1.t - b.1.t).abs() < 1e-12, "{a:?} {b:?}");
        assert!(a.2.iter().zip(&b.2).all(|(a, b)| (a - b).abs() < 1e-11), "{a:?} {b:?}");
    }
    assert_eq!(known.outputs.len(), plain.outputs.len());
    for (a, b) in known.outputs.iter().zip(&plain.outputs) {
        assert!((a.0, a.1, a.2) == (b.0, b.1, b.2) && (a.3 - b.3).abs() < 1e-12, "{a:?} {b:?}");
    }
}

#[test]
fn lanes_agree_with_one_member_at_a_time() {
    let list = members(20);
    let found = dispatch(Level::best(), Go(&list, 1));
    for ((_, _, y), m) in found.results.iter().zip(&list) {
        let mut one = ode(2, |t: f64, y: &[f64], dy: &mut [f64]| {
            (dy[0], dy[1]) = (y[1], (m.v * t).cos() - m.w * m.w * y[0] - m.d * y[1]);
        });
        let mut state = [m.start, 0.0];
        let run = integrate(&mut Scalar853::new(), &mut one, 0.0, &mut state, m.t1, &Control::new(1e-12, 1e-12), &mut ());
        assert_eq!(run.end, End::Reached);
        assert!((state[0] - y[0]).abs() < 1e-9 && (state[1] - y[1]).abs() < 1e-9 * m.w.max(1.0));
    }
}

/// The global error falls with the tolerance, and by about 2^8 when the step is halved: with fixed tolerance ratios the work grows as tol^(-1/8).
#[test]
fn the_order_is_eight() {
    let run = |tolerance: f64| {
        let mut m = members(1)[0];
        (m.d, m.w, m.v, m.t1, m.tolerance) = (0.0, 1.0, 2.5, 40.0, tolerance);
        m.outputs.count = 0;
        let found = dispatch(Level::best(), Go(&[m], 1));
        let a = 1.0 / (1.0 - 6.25);
        let exact = a * (100.0f64).cos() + (1.0 - a) * (40.0f64).cos();
        ((found.results[0].2[0] - exact).abs(), found.results[0].1.steps as f64)
    };
    let ((e1, n1), (e2, n2)) = (run(1e-6), run(1e-11));
    let order = (e1 / e2).ln() / (n2 / n1).ln();
    assert!((6.8..9.5).contains(&order), "{order}: {e1:e} in {n1}, {e2:e} in {n2}");
}

/// The same with members between them that fail or meet an event.
fn with_failures(list: &[Member]) -> Vec<Member> {
    let mut mixed = list.to_vec();
    for (k, m) in mixed.iter_mut().enumerate() {
        match k % 8 {
            1 => m.w = f64::NAN,
            3 => m.level = Some(0.2),
            5 => m.start = f64::INFINITY,
            6 => m.d = -1e308,
            _ => {}
        }
    }
    mixed
}

/// Bits do not depend on neighbours, on the lane, on the level; also when neighbours fail or meet an event.
#[test]
fn neighbours_do_not_matter() {
    let list = members(40);
    let alone: Vec<_> = list.iter().map(|&m| dispatch(Level::Base, Go(&[m], 1)).results.remove(0)).collect();
    let mixed = with_failures(&list);
    let mut backwards = mixed.clone();
    backwards.reverse();
    for level in Level::supported() {
        for order in [&mixed, &backwards] {
            let found = dispatch(level, Go(order, 1));
            assert_eq!(found.results.len(), 40);
            for (id, ended, y) in &found.results {
                match id % 8 {
                    1 | 5 => assert_eq!(ended.end, LegEnd::NoStart),
                    3 => assert!(ended.end == LegEnd::Event(0) && (y[0] - 0.2).abs() < 1e-12, "{ended:?} {y:?}"),
                    6 => assert!(matches!(ended.end, LegEnd::StepTooSmall(_) | LegEnd::NoStart), "{ended:?}"),
                    _ => assert_eq!((id, ended, y), (&alone[*id].0, &alone[*id].1, &alone[*id].2)),
                }
            }
        }
    }
}

/// Events end a leg at the root: x = cos t crosses 0.2 first at acos(0.2).
#[test]
fn events_are_located() {
    let mut m = members(1)[0];
    (m.w, m.d, m.v, m.level, m.t1) = (1.0, 0.0, 0.0, Some(0.2), 10.0);
    // x'' = 1 - x from x = 2: x = 1 + cos t, crossing 0.2 where cos t = -0.8
    m.start = 2.0;
    let found = dispatch(Level::best(), Go(&[m], 1));
    let expected = (-0.8f64).acos();
    assert!((found.results[0].1.t - expected).abs() < 1e-10, "{}", found.results[0].1.t);
    let before = (0..9).take_while(|&i| 0.25 * f64::from(i) <= expected).count();
    assert_eq!(found.outputs.len(), before);
}

#[test]
fn a_leg_can_be_limited_and_continued() {
    struct Twice<'a, S>(Oscillators<'a, S>, u32);
    impl<S: LaneScalar> EnsembleProblem<S> for Twice<'_, S> {
        fn dim(&self) -> usize {
            2
        }
        fn positions(&self) -> usize {
            self.0.positions()
        }
        fn time(&mut self, _: S) {}
        #[inline(always)]
        fn rhs(&mut self, t: S, y: &mut [S], dy: &mut [S]) {
            self.0.rhs(t, y, dy);
        }
        fn load(&mut self, lane: usize, seat: Seat) -> Option<Leg> {
            self.0.load(lane, seat).map(|leg| Leg { max_steps: 3, ..leg })
        }
        fn ended(&mut self, lane: usize, ended: &Ended, y: &mut [f64]) -> Option<Leg> {
            if ended.end == LegEnd::WorkLimit && self.1 < 2 {
                self.1 += 1;
                let t1 = self.0.riding[lane]?.t1;
                return Some(Leg { first_step: Some(ended.next_step), ..Leg::new(ended.t, t1) });
            }
            self.0.ended(lane, ended, y)
        }
    }
    struct Run2(Member);
    impl Kernel for Run2 {
        type Out = (Ended, Vec<f64>, u32);
        #[inline(always)]
        fn run<S: LaneScalar>(self) -> Self::Out {
            let (mut results, mut outputs) = (vec![], vec![]);
            let list = [self.0];
            let inner = Oscillators {
                parameters: [S::one(); 3],
                positions: 1,
                queue: list.iter(),
                riding: [None; LANES],
                results: &mut results,
                outputs: &mut outputs,
            };
            let mut problem = Twice(inner, 0);
            assert!(run(&mut problem));
            let times = problem.1;
            (results[0].1, results[0].2.clone(), times)
        }
    }
    let mut m = members(1)[0];
    m.outputs.count = 0;
    let whole = dispatch(Level::best(), Go(&[m], 1)).results.remove(0);
    let (ended, y, times) = dispatch(Level::best(), Run2(m));
    assert!(times == 1 && ended.end == LegEnd::Reached);
    assert!((y[0] - whole.2[0]).abs() < 1e-9);
}

/// y' = -rate (y - cos(v t)) - v sin(v t): whatever the rate, y = cos(v t) (Prothero and Robinson).
struct Relaxing<'a, S> {
    rate: S,
    speed: S,
    queue: std::slice::Iter<'a, [f64; 3]>,
    results: &'a mut Vec<(Ended, f64, f64)>,
    ends: [f64; LANES],
}

impl<S: LaneScalar> EnsembleProblem<S> for Relaxing<'_, S> {
    fn dim(&self) -> usize {
        1
    }
    fn time(&mut self, _: S) {}
    #[inline(always)]
    fn rhs(&mut self, t: S, y: &mut [S], dy: &mut [S]) {
        let (sin, cos) = (self.speed * t).sin_cos();
        dy[0] = -(self.rate * (y[0] - cos)) - self.speed * sin;
    }
    fn load(&mut self, lane: usize, seat: Seat) -> Option<Leg> {
        let &[rate, speed, t1] = self.queue.next()?;
        (self.rate, self.speed) = (self.rate.with(lane, rate), self.speed.with(lane, speed));
        self.ends[lane] = (speed * t1).cos();
        seat.y[0] = 1.0;
        seat.relative[0] = 1e-8;
        seat.absolute[0] = 1e-8;
        Some(Leg::new(0.0, t1))
    }
    fn ended(&mut self, lane: usize, ended: &Ended, y: &mut [f64]) -> Option<Leg> {
        self.results.push((*ended, y[0], self.ends[lane]));
        None
    }
}

#[test]
fn fast_decay_does_not_shorten_the_steps() {
    struct Relax<'a>(&'a [[f64; 3]]);
    impl Kernel for Relax<'_> {
        type Out = Vec<(Ended, f64, f64)>;
        #[inline(always)]
        fn run<S: LaneScalar>(self) -> Self::Out {
            let mut results = vec![];
            let (rate, speed) = (S::one(), S::one());
            let mut problem = Relaxing { rate, speed, queue: self.0.iter(), results: &mut results, ends: [0.0; LANES] };
            assert!(run_stiff(&mut problem));
            results
        }
    }
    let list: Vec<[f64; 3]> = (0..40).map(|k| [10f64.powi(k % 10), 1.0 + 0.1 * f64::from(k), 20.0]).collect();
    for (ended, y, exact) in dispatch(Level::best(), Relax(&list)) {
        assert_eq!(ended.end, LegEnd::Reached);
        assert!((y - exact).abs() < 1e-6, "{ended:?} {y} {exact}");
        // an explicit method takes a sixth of the rate times 20
        assert!(ended.steps + ended.rejected < 6000, "{ended:?}");
    }
}

/// The stiff method against closed forms, at its ends and between them; neither neighbours nor levels change a bit.
#[test]
fn the_stiff_method_in_lanes() {
    let list = members(40);
    let exact = |m: &Member, t: f64| {
        let a = 1.0 / (m.w * m.w - m.v * m.v);
        a * (m.v * t).cos() + (m.start - a) * (m.w * t).cos()
    };
    let mut free = list.clone();
    free.iter_mut().for_each(|m| m.d = 0.0);
    let found = dispatch(Level::best(), GoStiff(&free));
    for ((_, ended, y), m) in found.results.iter().zip(&free) {
        assert!(ended.end == LegEnd::Reached && (y[0] - exact(m, m.t1)).abs() < 1e-7, "{ended:?} {} {}", y[0], exact(m, m.t1));
    }
    assert_eq!(found.outputs.len(), 40 * 9);
    for &(id, i, t, x) in &found.outputs {
        assert!(t == 0.25 * i as f64 && (x - exact(&free[id], t)).abs() < 1e-7, "{id} {t} {x}");
    }
    let alone: Vec<_> = list.iter().map(|&m| dispatch(Level::Base, GoStiff(&[m])).results.remove(0)).collect();
    let mixed = with_failures(&list);
    for level in Level::supported() {
        let found = dispatch(level, GoStiff(&mixed));
        assert_eq!(found.results.len(), 40);
        for (id, ended, y) in &found.results {
            match id % 8 {
                1 | 5 => assert_eq!(ended.end, LegEnd::NoStart),
                3 => assert!(ended.end == LegEnd::Event(0) && (y[0] - 0.2).abs() < 1e-12, "{ended:?} {y:?}"),
                6 => assert!(matches!(ended.end, LegEnd::StepTooSmall(_) | LegEnd::NoStart), "{ended:?}"),
                _ => assert_eq!((id, ended, y), (&alone[*id].0, &alone[*id].1, &alone[*id].2)),
            }
        }
    }
}
