//! Elliptic balance: the deflection of one plane as one phase-shifted elliptic cosine of the forcing period.
//!
//! ```text
//! d(t) = a cn(u, k),   u = (2 K_e/pi)(W t - phi)
//! k^2 = c1 a^2 / (2 mu V^2),   V = 2 K_e(k) W / pi            the free oscillation of mass mu on the bearing alone
//! (K(W) + c0) a C1 + c1 a^3 C3 = p exp(i phi)                 first order of the forces
//! ```
//!
//! K and p condensed stiffness and load, mu the mass that the deflection feels (`1/mu = B M^-1 B^T`), C1 and C3 first coefficients of cn and cn^3 over the
//! period. Two real unknowns; the period is exactly that of the forcing. It applies where one hardening cubic law acts alike in x and y and apart
//! from each other: that is found out by probing the forces, not requested of a part.
//!
//! Theory: `docs/theory/approximate-methods.md#elliptic-balance`.

use crate::harmonic::balance::condense::{Condenser, Order};
use crate::harmonic::balance::nonlinear::Sampled;
use crate::harmonic::balance::orbit::Orbit;
use crate::harmonic::balance::pace::Pace;
use crate::harmonic::balance::problem::{Balance, Discretisation};
use crate::harmonic::balance::terms::Terms;
use crate::model::part::At;
use crate::model::system::{Slot, System};
use crate::model::tangent::{Tangent, TangentScratch};
use crate::symmetry::Symmetry;
use laval_num::complex::{C64, c};
use laval_num::continuation::Zero;
use laval_num::dense::{Lu, Mat};
use laval_num::elliptic::{coefficient, complete_first, cubed_coefficient};
use std::f64::consts::PI;

/// The law of the deflection and the mass it feels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Law {
    /// c0, N/m.
    pub linear: f64,
    /// c1, N/m^3.
    pub cubic: f64,
    /// mu, kg.
    pub mass: f64,
}

/// A motion by elliptic balance.
#[derive(Clone, Debug)]
pub struct Elliptic {
    /// Amplitude a of the deflection, m.
    pub amplitude: f64,
    /// Parameter k^2.
    pub parameter: f64,
    /// First-order amplitude of the deflection: complex, in the direction of the spin.
    pub first: C64,
    /// The motion of all coordinates, at orders 1, 3, 5, ...; internal states are left out.
    pub motion: Orbit,
}

/// Orders of the motion that is put together from the forces.
const ORDERS: usize = 31;

/// The law, when elliptic balance applies; or why it does not.
///
/// # Errors
/// The property of the machine that is missing.
pub fn law(system: &System, symmetry: Symmetry, speed: f64) -> Result<Law, &'static str> {
    if symmetry != Symmetry::Quarter {
        return Err("it is written for a law that acts on x and y apart and alike (symmetric by a quarter turn, not by any)");
    }
    let d = Discretisation { harmonics: 1, divisor: 1, samples: 8, symmetry };
    let balance = Balance::new(system, d, (speed, speed), None).map_err(|_| "the machine drifts")?;
    let nonlinear = &balance.nonlinear;
    let pure = nonlinear.members.iter().all(|m| !m.uses.velocity && !m.uses.acceleration && !m.uses.spin);
    if nonlinear.kinds.len() != 2 || !nonlinear.states.is_empty() || !pure {
        return Err("it is written for one deflection with a force that depends on nothing else");
    }
    let mut sampled = Sampled::default();
    let mut force = |x: f64, y: f64| {
        let zero = [0.0; 2];
        sampled.eval_at(system, &nonlinear.members, &balance.terms, 0.0, [&[x, y], &zero, &zero], Pace::forced(speed, 1), false);
        [sampled.rows[0], sampled.rows[1]]
    };
    let size = nonlinear.typical[0];
    let (one, two) = (force(size, 0.0)[0] / size, force(2.0 * size, 0.0)[0] / (2.0 * size));
    let cubic = (two - one) / (3.0 * size * size);
    let linear = one - cubic * size * size;
    let of = |x: f64| linear * x + cubic * x * x * x;
    let scale = linear.abs() * size + cubic.abs() * size.powi(3);
    let fits = [(0.5, 0.0), (0.0, 1.5), (-1.2, 0.7), (0.4, 1.1), (1.7, -0.3)].iter().all(|&(x, y)| {
        let (x, y) = (x * size, y * size);
        let f = force(x, y);
        (f[0] - of(x)).abs() <= 1e-9 * 8.0 * scale && (f[1] - of(y)).abs() <= 1e-9 * 8.0 * scale
    });
    if !fits {
        return Err("the nonlinear force is not c0 d + c1 d^3 in x and y apart");
    }
    if !(cubic > 0.0) {
        return Err("the law does not harden: its free oscillation is no elliptic cosine");
    }
    // B M^-1 B^T of the deflection in x
    let (n, m) = (system.n(), system.m());
    let (q, z) = (vec![0.0; n], vec![0.0; m]);
    let at = At { q: &q, v: &q, a: &q, z: &z, phase: 0.0, speed, spin_accel: 0.0, t: 0.0 };
    let (mut t, mut scratch) = (Tangent::default(), TangentScratch::default());
    system.tangent(&at, false, &mut t, &mut scratch, Slot::is_linear);
    let mut row = vec![0.0; n];
    nonlinear.basis.rows[0].iter().for_each(|&(g, x)| row[g] += x);
    let mut b = row.clone();
    Lu::new(&t.a).map_err(|_| "a coordinate has no mass")?.solve(&mut b);
    let mass = 1.0 / b.iter().zip(&row).map(|(b, r)| b * r).sum::<f64>();
    if mass > 0.0 && mass.is_finite() { Ok(Law { linear, cubic, mass }) } else { Err("the deflection feels no mass") }
}

/// k^2 of the free oscillation with amplitude `a` whose quarter period is that of the forcing: `m K(m)^2 = c1 a^2 pi^2/(8 mu W^2)`.
pub fn parameter(law: &Law, a: f64, speed: f64) -> f64 {
    let wanted = law.cubic * a * a * PI * PI / (8.0 * law.mass * speed * speed);
    let of = |m: f64| m * complete_first(m).powi(2);
    let (mut lo, mut hi) = (0.0, 1.0 - f64::EPSILON);
    for _ in 0..200 {
        let mid = 0.5 * (lo + hi);
        if of(mid) < wanted {
            lo = mid
        } else {
            hi = mid
        }
        if hi - lo <= 2.0 * f64::EPSILON * hi {
            break;
        }
    }
    0.5 * (lo + hi)
}

/// All motions at a speed, by amplitude, below `most` (m).
pub fn motions(system: &System, law: &Law, speed: f64, most: f64) -> Vec<Elliptic> {
    let d = Discretisation { harmonics: 1, divisor: 1, samples: 8, symmetry: Symmetry::Quarter };
    let Ok(mut balance) = Balance::new(system, d, (speed, speed), None) else { return Vec::new() };
    let n = balance.dim();
    let (mut r, mut jac) = (vec![0.0; n], Mat::zeros(n, n));
    if n != 2 || balance.eval(&[0.0; 2], speed, &mut r, Some(&mut jac), None).is_err() {
        return Vec::new();
    }
    // the tangent at rest holds the linear coefficient
    let stiffness = c(jac[(0, 0)], jac[(1, 0)]);
    let load = c(-r[0], -r[1]);
    let side = |a: f64| {
        let m = parameter(law, a, speed);
        stiffness.scale(a * coefficient(1, m)) + c(law.cubic * a.powi(3) * cubed_coefficient(1, m), 0.0)
    };
    let excess = |a: f64| side(a).abs() / load.abs() - 1.0;
    let mut roots = Vec::new();
    let count = 600;
    let place = |i: usize| most * (1e-6f64).powf(1.0 - i as f64 / count as f64);
    let (mut a, mut fa) = (place(0), excess(place(0)));
    for i in 1..=count {
        let (b, fb) = (place(i), excess(place(i)));
        // between two points of one sign the curve may dip through zero: seen from the middle of three
        if (fa < 0.0) != (fb < 0.0) {
            let (mut x, mut y, sign) = (a, b, fa < 0.0);
            for _ in 0..200 {
                let mid = 0.5 * (x + y);
                if (excess(mid) < 0.0) == sign {
                    x = mid
                } else {
                    y = mid
                }
                if y - x <= 4.0 * f64::EPSILON * y {
                    break;
                }
            }
            roots.push(0.5 * (x + y));
        }
        (a, fa) = (b, fb);
    }
    let mut out = Vec::new();
    for a in roots {
        let turn = (load / side(a)).scale(1.0 / (load / side(a)).abs());
        out.extend(assemble(system, law, speed, a, turn));
    }
    out
}

/// Motion of the machine: the forces of the elliptic deflection act on the linear rest, and the first point of the deflection follows the deflection.
fn assemble(system: &System, law: &Law, speed: f64, a: f64, turn: C64) -> Option<Elliptic> {
    let nonlinear = crate::harmonic::balance::problem::Nonlinear::of(system);
    let terms = Terms::new(&nonlinear.kinds, Symmetry::Quarter, ORDERS, 1, 8);
    let m = parameter(law, a, speed);
    // exp(-i phi n) for signed orders
    let phase = |order: i32| {
        let mut z = C64::one();
        for _ in 0..order.unsigned_abs() {
            z = z * if order < 0 { turn.conj() } else { turn };
        }
        z
    };
    let (mut u, mut f) = (vec![0.0; terms.unknowns], vec![0.0; terms.unknowns]);
    for &(term, at) in &terms.list {
        let order = term.order();
        let n = order.unsigned_abs();
        let d = phase(order).scale(a * coefficient(n, m));
        let force = phase(order).scale(law.linear * a * coefficient(n, m) + law.cubic * a.powi(3) * cubed_coefficient(n, m));
        (u[at], u[at + 1], f[at], f[at + 1]) = (d.re, d.im, force.re, force.im);
    }
    let mut condenser = Condenser::new(system, &nonlinear.basis, vec![0.0; 2], 1);
    condenser.set_pace(system, &Pace::forced(speed, 1));
    let mut order = Order::default();
    let mut motion = Orbit { speed, frequency: speed, orders: terms.orders.clone(), ..Orbit::default() };
    let (mut du, mut df) = (vec![C64::zero(); 2], vec![C64::zero(); 2]);
    for &k in &terms.orders {
        condenser.order(system, k, false, &mut order).ok()?;
        terms.amplitudes(&u, k, &mut du);
        terms.amplitudes(&f, k, &mut df);
        let mut x: Vec<C64> = order.free[..system.n()].to_vec();
        for (i, x) in x.iter_mut().enumerate() {
            for j in 0..2 {
                *x -= order.spread[(i, j)] * df[j];
            }
        }
        for (row, &d) in nonlinear.basis.rows.iter().zip(&du) {
            let own = row.iter().fold(C64::zero(), |s, &(g, b)| s + x[g].scale(b));
            let &(g, b) = row.iter().find(|(_, b)| *b > 0.0)?;
            x[g] += (d - own).scale(1.0 / b);
        }
        motion.coordinates.push(x);
        motion.states.push(Vec::new());
    }
    let first = phase(1).scale(a * coefficient(1, m));
    Some(Elliptic { amplitude: a, parameter: m, first, motion })
}
