//! The planar machine of the benchmark written by hand in lanes: fixed arrays, its own equations, nothing general. Kept for comparison.

use laval_num::lanes::{Bits, Kernel, LANES, LaneScalar, Level, dispatch};
use laval_num::ode::tableau::{self as t8, Row as Coefficients};

pub struct Machine {
    pub damping: f64,
    pub eccentricity: f64,
}

const MASS: f64 = 2.4;
const BASE: f64 = 25.0;
const C0: f64 = 1.1e7;
const C1: f64 = 8.7e10;
const C2: f64 = 3.26e5;
const CHI0: f64 = 6.59;
const N: usize = 8;

impl Machine {
    /// End states (x, y of rotor, of base, and velocities) and steps of each member.
    pub fn sweep(&self, level: Level, speeds: &[f64], span: fn(f64) -> f64, relative: f64, absolute: f64) -> Vec<super::Row> {
        dispatch(level, Sweep { machine: self, speeds, span, relative, absolute })
    }
}

struct Sweep<'a> {
    machine: &'a Machine,
    speeds: &'a [f64],
    span: fn(f64) -> f64,
    relative: f64,
    absolute: f64,
}

#[inline(always)]
fn combine<S: LaneScalar, const M: usize>(y: &[S; N], h: S, k: &[[S; N]; 13], row: &Coefficients<M>) -> [S; N] {
    let mut out = [S::zero(); N];
    for j in 0..N {
        let mut s = k[row[0].0][j].scale(row[0].1);
        for m in 1..M {
            s += k[row[m].0][j].scale(row[m].1);
        }
        out[j] = y[j] + h * s;
    }
    out
}

/// A function, not a closure: a closure stays a call without the instructions of the level.
#[inline(always)]
fn rhs<S: LaneScalar>(damping: S, speed: S, force: S, t: S, y: &[S; N]) -> [S; N] {
    let (sin, cos) = (speed * t).sin_cos();
    let (dx, dy) = (y[0] - y[2], y[1] - y[3]);
    let fx = dx * (S::cst(C0) + (dx * dx).scale(C1));
    let fy = dy * (S::cst(C0) + (dy * dy).scale(C1));
    let k = C2 / BASE;
    let c = CHI0 / BASE;
    [
        y[4],
        y[5],
        y[6],
        y[7],
        force * cos - damping * y[4] - fx.scale(1.0 / MASS),
        force * sin - damping * y[5] - fy.scale(1.0 / MASS),
        fx.scale(1.0 / BASE) - y[2].scale(k) - y[6].scale(c),
        fy.scale(1.0 / BASE) - y[3].scale(k) - y[7].scale(c),
    ]
}

impl Kernel for Sweep<'_> {
    type Out = Vec<super::Row>;
    #[inline(always)]
    fn run<S: LaneScalar>(self) -> Self::Out {
        let (damping, e) = (S::cst(self.machine.damping / MASS), self.machine.eccentricity);
        let mut speed = S::one();
        let mut force = S::zero();
        let count = self.speeds.len();
        let mut rows: Vec<super::Row> = vec![(vec![], 0); count];
        let (mut next, mut member, mut steps) = (0, [usize::MAX; LANES], [0u64; LANES]);
        let (mut t, mut t_end, mut h) = (S::zero(), S::cst(f64::INFINITY), S::cst(1e-6));
        let mut y = [S::zero(); N];
        let mut k = [[S::zero(); N]; 13];
        let (mut fresh, mut active, mut repeated) = (Bits::MIN, Bits::MIN, Bits::MIN);
        for lane in 0..LANES {
            if next < count {
                let v = self.speeds[next];
                speed = speed.with(lane, v);
                force = force.with(lane, e * v * v);
                t_end = t_end.with(lane, (self.span)(v));
                h = h.with(lane, 1e-2 / v);
                member[lane] = next;
                active |= 1 << lane;
                next += 1;
            }
        }
        fresh |= active;
        while active != 0 {
            if fresh != 0 {
                let f = rhs(damping, speed, force, t, &y);
                for j in 0..N {
                    k[0][j] = pick(fresh, f[j], k[0][j]);
                }
                fresh = 0;
            }
            let last = (t_end - t).le(h.scale(1.01));
            let t1 = S::select(last, t_end, t + h);
            let d = t1 - t;
            k[1] = rhs(damping, speed, force, t + d.scale(t8::C[1]), &combine(&y, d, &k, &t8::A1));
            k[2] = rhs(damping, speed, force, t + d.scale(t8::C[2]), &combine(&y, d, &k, &t8::A2));
            k[3] = rhs(damping, speed, force, t + d.scale(t8::C[3]), &combine(&y, d, &k, &t8::A3));
            k[4] = rhs(damping, speed, force, t + d.scale(t8::C[4]), &combine(&y, d, &k, &t8::A4));
            k[5] = rhs(damping, speed, force, t + d.scale(t8::C[5]), &combine(&y, d, &k, &t8::A5));
            k[6] = rhs(damping, speed, force, t + d.scale(t8::C[6]), &combine(&y, d, &k, &t8::A6));
            k[7] = rhs(damping, speed, force, t + d.scale(t8::C[7]), &combine(&y, d, &k, &t8::A7));
            k[8] = rhs(damping, speed, force, t + d.scale(t8::C[8]), &combine(&y, d, &k, &t8::A8));
            k[9] = rhs(damping, speed, force, t + d.scale(t8::C[9]), &combine(&y, d, &k, &t8::A9));
            k[10] = rhs(damping, speed, force, t + d.scale(t8::C[10]), &combine(&y, d, &k, &t8::A10));
            k[11] = rhs(damping, speed, force, t1, &combine(&y, d, &k, &t8::A11));
            let y1 = combine(&y, d, &k, &t8::B);
            let (mut e5, mut e3) = (S::zero(), S::zero());
            let inverse_d = S::one() / d;
            for j in 0..N {
                let (a, b) = (y[j].abs(), y1[j].abs());
                let inverse = S::one() / (S::cst(self.absolute) + S::select(a.lt(b), b, a).scale(self.relative));
                let (mut x5, mut x3) = (S::zero(), (y1[j] - y[j]) * inverse_d);
                for (stage, c) in t8::E5 {
                    x5 += k[stage][j].scale(c);
                }
                for (stage, c) in t8::BHH {
                    x3 -= k[stage][j].scale(c);
                }
                e5 += (x5 * inverse).square();
                e3 += (x3 * inverse).square();
            }
            let error = d * e5 / ((e5 + e3.scale(0.01)).scale(N as f64)).sqrt();
            let error = S::select(e5.le(S::zero()), S::zero(), error);
            let accepted = S::bits(error.lt(S::one())).0 & active;
            let factor = S::cst(0.9) / error.sqrt().sqrt().sqrt();
            let factor = S::select(S::cst(1.0 / 3.0).lt(factor), factor, S::cst(1.0 / 3.0));
            let factor = S::select(factor.lt(S::cst(6.0)), factor, S::cst(6.0));
            let bounded = S::select(factor.lt(S::one()), factor, S::one());
            let factor = if repeated == 0 { factor } else { pick(repeated, bounded, factor) };
            repeated = active & !accepted;
            h = d * factor;
            k[12] = rhs(damping, speed, force, t1, &y1);
            if accepted == Bits::MAX {
                (y, k[0], t) = (y1, k[12], t1);
            } else {
                for j in 0..N {
                    y[j] = pick(accepted, y1[j], y[j]);
                    k[0][j] = pick(accepted, k[12][j], k[0][j]);
                }
                t = pick(accepted, t1, t);
            }
            for lane in 0..LANES {
                steps[lane] += u64::from(active >> lane & 1);
            }
            let ended = S::bits(last).0 & accepted;
            if ended == 0 {
                continue;
            }
            for lane in (0..LANES).filter(|l| ended >> l & 1 == 1) {
                rows[member[lane]] = (y.iter().map(|s| s.get(lane)).collect(), steps[lane]);
                steps[lane] = 0;
                t = t.with(lane, 0.0);
                for s in &mut y {
                    *s = s.with(lane, 0.0);
                }
                if next < count {
                    let v = self.speeds[next];
                    speed = speed.with(lane, v);
                    force = force.with(lane, e * v * v);
                    t_end = t_end.with(lane, (self.span)(v));
                    h = h.with(lane, 1e-2 / v);
                    member[lane] = next;
                    fresh |= 1 << lane;
                    next += 1;
                } else {
                    active &= !(1 << lane);
                    t_end = t_end.with(lane, f64::INFINITY);
                    h = h.with(lane, 1e-9);
                }
            }
        }
        rows
    }
}

#[inline(always)]
fn pick<S: LaneScalar>(bits: Bits, a: S, b: S) -> S {
    let mut flags = [0.0; LANES];
    for i in 0..LANES {
        flags[i] = f64::from(bits >> i & 1);
    }
    S::select(S::zero().lt(S::load(&flags)), a, b)
}
