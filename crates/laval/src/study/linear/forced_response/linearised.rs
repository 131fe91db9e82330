//! Forces of nonlinear parts along a linear response: by their tangent at rest, and by their law for the same motion.
//!
//! ```text
//! F(t) = F0 + Re[(K + i W C - W^2 M) x exp(i W t)]      tangent;      F(t) = F(rest + Re[x exp(i W t)])      law
//! ```
//!
//! Both hold the force at rest F0. Where they differ the motion is too large for the tangent.

use crate::model::blocks::Blocks;
use crate::model::erased::{D8, Evaluate};
use crate::model::part::{At, Link, Rows};
use crate::model::slot::gather;
use crate::model::system::{Slot, System};
use crate::solve::characteristic::Equilibrium;
use crate::solve::linear_response::Response;
use crate::solve::rest::clearance;
use crate::study::shared::support::larger;
use laval_num::complex::{C64, c};
use laval_num::fourier;
use laval_num::scalar::Scalar;

/// Of a part that joins two points, at its largest over a turn, N.
pub(super) struct Force {
    /// Its name.
    pub part: String,
    /// By the tangent at rest.
    pub tangent: f64,
    /// By the law.
    pub law: f64,
}

/// Forces of all nonlinear parts that join two points and are in contact at rest, at so many instants of a turn.
pub(super) fn forces(system: &System, rest: &Equilibrium, r: &Response, instants: u32) -> Vec<Force> {
    let joins = |s: &&Slot| s.layout.ports.iter().any(|p| p.kind.lateral && matches!(p.link, Link::Between(..)));
    let held = |s: &&Slot| clearance(system, s, rest).is_none_or(|gap| !(gap > 0.0));
    let slots = system.slots().iter().filter(|s| !s.is_linear() && s.states.is_empty() && s.map.len() >= 2).filter(joins).filter(held);
    slots.map(|s| force(system, s, rest, r, instants)).collect()
}

fn force(system: &System, slot: &Slot, rest: &Equilibrium, r: &Response, instants: u32) -> Force {
    let (mut still, s) = (Vec::new(), c(0.0, r.speed));
    gather(&slot.map, &rest.q, &mut still);
    let moved: Vec<C64> = slot.map.iter().map(|row| row.iter().fold(C64::zero(), |sum, &(g, x)| sum + r.x[g].scale(x))).collect();
    let (n, own) = (still.len(), &system.params()[slot.params.clone()]);
    // the derivatives along the real and the imaginary part of the amplitudes
    let seeded = |rest: f64, by: C64| {
        let mut out = D8::lift(rest);
        (out.eps[0], out.eps[1]) = (by.re, by.im);
        out
    };
    let q: Vec<D8> = (0..n).map(|i| seeded(still[i], moved[i])).collect();
    let v: Vec<D8> = moved.iter().map(|x| seeded(0.0, *x * s)).collect();
    let a: Vec<D8> = moved.iter().map(|x| seeded(0.0, *x * s * s)).collect();
    let speed = slot.speed(system.params(), r.speed);
    let (mut rows, mut spin) = (vec![D8::zero(); n], D8::zero());
    let at = At { q: &q, v: &v, a: &a, z: &[], phase: D8::zero(), speed: D8::lift(speed), spin_accel: D8::zero(), t: D8::zero() };
    let lifted: Vec<D8> = own.iter().map(|&x| D8::lift(x)).collect();
    let mut out = Rows { force: &mut rows, rate: &mut [], spin: &mut spin };
    D8::residual(&*slot.part, &lifted, &at, &mut out, &mut Blocks::default());
    let mut found = Force { part: slot.name.clone(), tangent: 0.0, law: 0.0 };
    let (mut force, mut spin) = (vec![0.0; n], 0.0);
    let mut squares = Vec::new();
    for k in 0..instants {
        let turning = C64::cis(std::f64::consts::TAU * f64::from(k) / f64::from(instants));
        let real = |z: C64| (z * turning).re;
        let by_tangent = |i: usize| rows[i].re + real(c(rows[i].eps[0], rows[i].eps[1]));
        let q: Vec<f64> = (0..n).map(|i| still[i] + real(moved[i])).collect();
        let [v, a]: [Vec<f64>; 2] = [s, s * s].map(|by| moved.iter().map(|x| real(*x * by)).collect());
        let phase = turning.arg();
        let at = At { q: &q, v: &v, a: &a, z: &[], phase, speed: r.speed, spin_accel: 0.0, t: 0.0 };
        force.fill(0.0);
        let mut rows = Rows { force: &mut force, rate: &mut [], spin: &mut spin };
        slot.part.residual_f64(own, &slot.turned(system.params(), at), &mut rows, &mut Blocks::default());
        squares.push(by_tangent(0).powi(2) + by_tangent(1).powi(2));
        found.law = larger(found.law, force[0].hypot(force[1]));
    }
    Force { tangent: fourier::largest(&squares).sqrt(), ..found }
}
