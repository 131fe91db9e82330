//! Cost of lanes: nanoseconds per operation and lane at every level of this processor, beside `f64` and the standard library.
//!
//! `cargo run --release -p laval-num --example lanes_cost`

use laval_num::lanes::{Kernel, LANES, LaneScalar, Level, dispatch};
use laval_num::scalar::Scalar;
use std::hint::black_box;
use std::time::Instant;

const GROUPS: usize = 128;
const ROUNDS: usize = 2_000;

/// One function of two numbers.
trait Op: Copy {
    const NAME: &'static str;
    fn of<S: Scalar>(x: S, y: S) -> S;
    /// The same with the standard library's functions.
    fn std(x: f64, y: f64) -> f64;
}

macro_rules! op {
    ($type:ident, $name:literal, |$x:ident, $y:ident| $of:expr, $std:expr) => {
        #[derive(Clone, Copy)]
        struct $type;
        impl Op for $type {
            const NAME: &'static str = $name;
            #[inline(always)]
            fn of<S: Scalar>($x: S, $y: S) -> S {
                $of
            }
            #[inline(always)]
            fn std($x: f64, $y: f64) -> f64 {
                $std
            }
        }
    };
}

op!(
    SinCos,
    "sin_cos",
    |x, y| {
        let (s, c) = x.sin_cos();
        s + c * y
    },
    {
        let (s, c) = f64::sin_cos(x);
        s + c * y
    }
);
op!(Exp, "exp", |x, y| x.exp() + y, f64::exp(x) + y);
op!(Ln, "ln", |x, y| x.abs().ln() + y, f64::ln(f64::abs(x)) + y);
op!(Atan2, "atan2", |x, y| y.atan2(x), f64::atan2(y, x));
op!(Pow, "pow_pos(10/9)", |x, y| x.pow_pos(10.0 / 9.0) + y, f64::powf(f64::max(x, 0.0), 10.0 / 9.0) + y);
op!(Hertz, "pow_pos(3/2)", |x, y| x.pow_pos(1.5) + y, if x > 0.0 { x * f64::sqrt(x) + y } else { y });
// acceleration of a forced Duffing oscillator of displacement x, velocity y, at the phase x + y
op!(
    Duffing,
    "Duffing residual",
    |x, y| (x + y).cos().scale(0.3) - y.scale(0.02) - x - x * x * x,
    (x + y).cos() * 0.3 - y * 0.02 - x - x * x * x
);

struct Lanes<'a, O>(O, &'a [[f64; LANES]], &'a mut [[f64; LANES]]);
impl<O: Op> Kernel for Lanes<'_, O> {
    type Out = ();
    #[inline(always)]
    fn run<S: LaneScalar>(self) {
        for (x, y) in self.1.iter().zip(self.2) {
            O::of(S::load(x), S::load(y)).store(y);
        }
    }
}

/// Best of several repetitions, in nanoseconds per operation and lane.
fn time(x: &[[f64; LANES]], mut f: impl FnMut(&mut [[f64; LANES]])) -> f64 {
    let mut best = f64::INFINITY;
    for _ in 0..7 {
        let mut y = vec![[0.5; LANES]; x.len()];
        let start = Instant::now();
        for _ in 0..ROUNDS / 7 {
            f(black_box(&mut y));
        }
        let ns = start.elapsed().as_secs_f64() * 1e9 / (ROUNDS / 7 * x.len() * LANES) as f64;
        best = best.min(ns);
    }
    best
}

fn row<O: Op>(op: O, x: &[[f64; LANES]]) {
    let each = |f: fn(f64, f64) -> f64| {
        time(x, |y| {
            for (x, y) in x.iter().flatten().zip(y.iter_mut().flatten()) {
                *y = f(*x, *y);
            }
        })
    };
    print!("{:18}{:9.2}{:9.2}", O::NAME, each(O::std), each(O::of::<f64>));
    for level in Level::supported() {
        print!("{:9.2}", time(x, |y| dispatch(level, Lanes(op, x, y))));
    }
    println!();
}

fn main() {
    let x: Vec<[f64; LANES]> =
        (0..GROUPS).map(|g| std::array::from_fn(|i| ((g * LANES + i) as f64 * 0.618).fract() * 20.0 - 8.0)).collect();
    print!("ns per lane       {:>9}{:>9}", "std", "f64");
    for level in Level::supported() {
        print!("{:>9}", level.name());
    }
    println!();
    row(SinCos, &x);
    row(Exp, &x);
    row(Ln, &x);
    row(Atan2, &x);
    row(Pow, &x);
    row(Hertz, &x);
    row(Duffing, &x);
}
