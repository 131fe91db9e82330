//! Cups as a linear part of the machine that carries them: mass, inertia and unbalance at the tilt of the
//! current speed.
//!
//! Equations, about the point P of the body at the height of the hinges, `p` its displacement,
//! `theta = alpha + i beta` the tilt of the body, `phi` the spin angle, `W = phi'`; mass m, height V, inertias
//! A and C, unbalance U and its moment Z from [`Load`] at W; an index W means the derivative with respect to W:
//!
//! ```text
//! m (p'' - i V theta'')                        = (W^2 U - i W' (U + W U_W)) exp(i phi)
//! A theta'' + i m V p'' - i C W theta' - (i/2) (C + W C_W) W' theta  = (i W^2 Z + W' (Z + W Z_W)) exp(i phi)
//! (C + W C_W) W' + Im(conj(U e) p'' + W' conj(U_W e) p') - Re(conj(Z e) theta'' + W' conj(Z_W e) theta')
//!    + (C/2) (alpha'' beta - alpha beta'') + (C_W/2) W' (alpha' beta - alpha beta') = torque,    e = exp(i phi)
//! ```
//!
//! The kinetic energy is that of a rigid body with these data; the weight of the cups along the axis is stored as they rise.
//!
//! Symbols: m, V, A, C, U, Z in kg, m, kg m^2, kg m^2, kg m, kg m^2; p in m; theta, phi in rad.
//!
//! Validity: contents frozen; cups at their equilibrium tilt of the current speed, so that the speed changes
//! slowly against their swing. The forces neglect the change of A and m V with the speed; the energy account
//! shows its size.
//!
//! Sources: `docs/theory/operating-window.md#load-of-the-cups`; kinetic energy of a rigid body to second order in the tilt, as for a disc.

use super::load::{Load, Ring, Sums};
use crate::diagnostic::Diagnostics;
use crate::model::blocks::Blocks;
use crate::model::capability::Scope;
use crate::model::erased;
use crate::model::field::{Attach, Field, ParamValues, Values};
use crate::model::params::NoParams;
use crate::model::part::{At, Energy, ErasedPart, Layout, Link, Observed, Params, Part, Physics};
use crate::model::system::Axis;
use laval_model::text;
use laval_model::text::Text;
use laval_num::complex::{Complex, c};
use laval_num::dual::Dual;
use laval_num::scalar::Scalar;
use std::sync::Arc;

/// See the [module](self).
pub struct Cups {
    on: Attach,
    ring: Ring,
    sums: Sums,
}

/// Load of the cups, and its derivative in the speed.
struct Moving<S> {
    now: Load<S>,
    rate: Load<S>,
}

impl Cups {
    /// Cups on a body, with their hinges at this height.
    pub fn new(on: Attach, ring: Ring) -> Self {
        Cups { on, sums: ring.sums(), ring }
    }

    #[inline(always)]
    fn moving<S: Scalar>(&self, speed: S) -> Moving<S> {
        let l = self.ring.loading(&self.sums, Dual::<S, 1>::seed(speed, 0));
        Moving {
            now: Load {
                tilt: l.tilt.re,
                mass: l.mass,
                height: l.height.re,
                polar: l.polar.re,
                diametral: l.diametral.re,
                unbalance: c(l.unbalance.re.re, l.unbalance.im.re),
                couple: c(l.couple.re.re, l.couple.im.re),
            },
            rate: Load {
                tilt: l.tilt.eps[0],
                mass: l.mass,
                height: l.height.eps[0],
                polar: l.polar.eps[0],
                diametral: l.diametral.eps[0],
                unbalance: c(l.unbalance.re.eps[0], l.unbalance.im.eps[0]),
                couple: c(l.couple.re.eps[0], l.couple.im.eps[0]),
            },
        }
    }
}

/// What turns with the rotor, as [`Blocks::add_rotating`] takes it.
#[inline(always)]
fn turning<S: Scalar>(z: Complex<S>) -> [[S; 2]; 2] {
    [[z.re, -z.im], [z.im, z.re]]
}

/// Velocities or accelerations of the point, and of the tilt.
#[inline(always)]
fn rates<S: Scalar>(d: &[S]) -> (Complex<S>, Complex<S>) {
    (c(d[0], d[1]), c(d[2], d[3]))
}

/// `Im(conj(U e) p') - Re(conj(Z e) theta')`.
#[inline(always)]
fn along<S: Scalar>(l: &Load<S>, e: Complex<S>, d: &[S]) -> S {
    let (point, tilt) = rates(d);
    ((l.unbalance * e).conj() * point).im - ((l.couple * e).conj() * tilt).re
}

/// `(alpha' beta - alpha beta')/2`.
#[inline(always)]
fn twist<S: Scalar>(q: &[S], d: &[S]) -> S {
    (d[2] * q[3] - q[2] * d[3]).scale(0.5)
}

impl Part for Cups {
    const KIND: &'static str = "cups";
    const DOC: &'static str = "Cups on a body, from the blocks [[cup]] that say what carries them.";
    type Family = NoParams;
    const FIELDS: &'static [Field] = &[];

    fn build(_: &Values, _: &mut ParamValues, _: &mut Diagnostics) -> Option<Self> {
        None
    }

    #[inline(never)]
    fn erased(self) -> ErasedPart {
        Arc::new(self)
    }
    fn layout(&self) -> Layout {
        Layout::point_and_tilt(Link::On(self.on.clone()))
    }

    fn physics(&self) -> Physics {
        Physics::Linear
    }

    #[inline(always)]
    fn linear<S: Scalar>(&self, _: &Params<Self, S>, speed: S, b: &mut Blocks<S>) {
        let (one, zero) = (S::one(), S::zero());
        let Moving { now, rate } = self.moving(speed);
        for i in [0, 1] {
            b.mass[(i, i)] = S::cst(now.mass);
            b.mass[(i + 2, i + 2)] = now.diametral;
        }
        let mv = now.height.scale(now.mass);
        for (i, j, x) in [(0, 3, mv), (1, 2, -mv)] {
            b.mass[(i, j)] = x;
            b.mass[(j, i)] = x;
        }
        b.gyroscopic[(2, 3)] = now.polar;
        b.gyroscopic[(3, 2)] = -now.polar;
        let half = (now.polar + speed * rate.polar).scale(0.5);
        b.spin_accel_stiffness[(2, 3)] = half;
        b.spin_accel_stiffness[(3, 2)] = -half;
        let (lateral, tilting) = ([(0, one), (1, one)], [(3, one), (2, -one)]);
        b.add_rotating(lateral, turning(now.unbalance), one, one);
        b.add_rotating(tilting, turning(now.couple), one, one);
        b.add_rotating(lateral, turning(rate.unbalance.scale(speed)), zero, one);
        b.add_rotating(tilting, turning(rate.couple.scale(speed)), zero, one);
    }

    #[inline(always)]
    fn spin_row<S: Scalar>(&self, _: &Params<Self, S>, at: &At<S>) -> S {
        let Moving { now, rate } = self.moving(at.speed);
        let e = Complex::cis(at.phase);
        (now.polar + at.speed * rate.polar) * at.spin_accel
            + along(&now, e, at.a)
            + at.spin_accel * along(&rate, e, at.v)
            + now.polar * twist(at.q, at.a)
            + at.spin_accel * rate.polar * twist(at.q, at.v)
    }

    fn energy<S: Scalar>(&self, _: &Params<Self, S>, at: &At<S>) -> Option<Energy<S>> {
        let Moving { now, rate } = self.moving(at.speed);
        let (point, tilt) = rates(at.v);
        let (e, w) = (Complex::cis(at.phase), at.speed);
        // of a part of the body at the height V, and of that of its inertia
        let across = |height: S, diametral: S| {
            let lever = (point.conj() * tilt.mul_i()).re;
            (diametral * tilt.norm_sqr()).scale(0.5) - (height * lever).scale(now.mass)
        };
        let twist = twist(at.q, at.v);
        let spinning = |l: &Load<S>| (l.polar * w * w).scale(0.5) + w * along(l, e, at.v) + w * l.polar * twist;
        let lifted = |height: S| height.scale(now.mass * self.ring.cup.gravity);
        let kinetic = point.norm_sqr().scale(0.5 * now.mass) + across(now.height, now.diametral) + spinning(&now);
        let supplied = at.spin_accel * (lifted(rate.height) + across(rate.height, rate.diametral) - spinning(&rate));
        Some(Energy { stored: kinetic + lifted(now.height), supplied, ..Energy::zero() })
    }

    fn observe(&self, _: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Observed>) {
        out.push(Observed { name: "swing", unit: "rad", value: self.ring.loading(&self.sums, at.speed).tilt });
    }
    fn scope(&self) -> Option<&dyn erased::Scope> {
        Some(self)
    }
}

impl Scope for Cups {
    fn refuses_axis(&self, _: &Params<Self, f64>, axis: Axis) -> Option<Text> {
        let swings = axis == Axis::Horizontal && self.ring.held.is_none();
        swings.then(|| {
            text!("cups swing out against a weight along the axis, which a horizontal machine has not; say at which tilt they are held")
        })
    }
}
