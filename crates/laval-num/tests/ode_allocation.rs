//! Integration allocates at its start only: whatever the number of steps, outputs and events, no step allocates.

use laval_num::dense::Mat;
use laval_num::ode::{Control, Crossing, Dop853, End, Event, Failure, Method, Observer, Ode, Radau, Step, StiffOde, integrate};
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

thread_local! {
    static COUNT: Cell<u64> = const { Cell::new(0) };
}

struct Counting;

fn count() {
    // a thread that is ending has no counter any more, and no test to answer to
    let _ = COUNT.try_with(|c| c.set(c.get() + 1));
}

// SAFETY: every call is passed on unchanged to the system's allocator.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count();
        unsafe { System.alloc(layout) }
    }
    unsafe fn dealloc(&self, p: *mut u8, layout: Layout) {
        unsafe { System.dealloc(p, layout) }
    }
    unsafe fn realloc(&self, p: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        count();
        unsafe { System.realloc(p, layout, size) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Van der Pol's oscillator, forced.
struct Oscillator;

impl Ode for Oscillator {
    fn dim(&self) -> usize {
        2
    }
    fn rhs(&mut self, t: f64, y: &[f64], dy: &mut [f64]) -> Result<(), Failure> {
        (dy[0], dy[1]) = (y[1], 5.0 * (1.0 - y[0] * y[0]) * y[1] - y[0] + t.cos());
        Ok(())
    }
}

impl StiffOde for Oscillator {
    fn jacobian(&mut self, _: f64, y: &[f64], jac: &mut Mat) -> Result<(), Failure> {
        (jac[(0, 1)], jac[(1, 0)], jac[(1, 1)]) = (1.0, -10.0 * y[0] * y[1] - 1.0, 5.0 * (1.0 - y[0] * y[0]));
        Ok(())
    }
}

/// Allocations between the end of the first step and the end of the last.
#[derive(Default)]
struct Watch {
    first: Option<u64>,
    last: u64,
    seen: [usize; 3],
}

impl Observer for Watch {
    fn step(&mut self, s: &Step<'_>) {
        let mut y = [0.0; 2];
        s.eval(0.5 * (s.t0 + s.t1), &mut y);
        s.eval_derivative(s.t0, &mut y);
        self.last = COUNT.get();
        self.first.get_or_insert(self.last);
        self.seen[0] += 1;
    }
    fn output(&mut self, _: usize, _: f64, _: &[f64]) {
        self.seen[1] += 1;
    }
    fn event(&mut self, _: &Crossing, _: &[f64]) {
        self.seen[2] += 1;
    }
}

fn steps_do_not_allocate<M: Method<Oscillator>>(mut method: M) {
    let grid: Vec<f64> = (0..=500).map(|i| i as f64 * 0.1).collect();
    let (q, v) = (|_: f64, y: &[f64]| y[0], |_: f64, y: &[f64]| y[1]);
    let events = [Event::new(&q), Event::new(&v)];
    let control = Control { outputs: &grid, events: &events, ..Control::new(1e-7, 1e-9) };
    for _ in 0..2 {
        let mut watch = Watch::default();
        let mut y = [2.0, 0.0];
        let run = integrate(&mut method, &mut Oscillator, 0.0, &mut y, 50.0, &control, &mut watch);
        assert_eq!(run.end, End::Reached);
        assert!(
            watch.seen[0] > 100 && watch.seen[1] == 501 && watch.seen[2] > 10 && run.work.rejected > 0,
            "{:?} {:?}",
            watch.seen,
            run.work
        );
        assert_eq!(Some(watch.last), watch.first, "{:?}", run.work);
    }
}

#[test]
fn the_counter_counts() {
    let before = COUNT.get();
    std::hint::black_box(vec![0u8; 100]);
    assert_eq!(COUNT.get(), before + 1);
}

#[test]
fn explicit_steps_do_not_allocate() {
    steps_do_not_allocate(Dop853::new());
}

#[test]
fn implicit_steps_do_not_allocate() {
    steps_do_not_allocate(Radau::new());
}
