//! A pendulum on the rotor: a point mass on a massless arm, hinged at an eccentric point; its angle from the rotor's x axis is its own coordinate.

use laval::diagnostic::Diagnostics;
use laval::model::field::{Attach, Bounds, Field, ParamValues, Values};
use laval::model::part::{At, Dof, Energy, Layout, Link, Params, Part, Physics, Rows};
use laval::params;
use laval_num::complex::{Complex, c};
use laval_num::scalar::Scalar;

params! {
    /// Parameters of a [`Pendulum`].
    pub struct PendulumParams in PendulumFamily {
        mass: scalar, "kg", Bounds::positive(1e6), required, "mass m";
        arm: scalar, "m", Bounds::positive(10.0), required, "length l of the arm";
        hinge: scalar, "m", Bounds::up_to(10.0), required, "distance b of the hinge from the axis";
        hinge_phase: scalar, "rad", Bounds::within(10.0), default 0.0, "direction of the hinge from the key mark";
        drag: scalar, "N m s", Bounds::up_to(1e6), default 0.0, "drag torque of the hinge per rate";
    }
}

pub struct Pendulum(pub Attach);

/// Directions of hinge and arm, `b exp(i alpha)` and `l exp(i beta)`.
#[inline(always)]
fn arms<S: Scalar>(p: &PendulumParams<S>, at: &At<S>) -> (Complex<S>, Complex<S>) {
    (Complex::cis(at.phase + p.hinge_phase).scale(p.hinge), Complex::cis(at.phase + at.q[2]).scale(p.arm))
}

/// Acceleration of the end of an arm that turns with `rate` and `accel`.
#[inline(always)]
fn along<S: Scalar>(arm: Complex<S>, accel: S, rate: S) -> Complex<S> {
    arm.mul_i().scale(accel) - arm.scale(rate * rate)
}

impl Part for Pendulum {
    const KIND: &'static str = "pendulum";
    const DOC: &'static str = "A pendulum on the rotor.";
    type Family = PendulumFamily;
    const FIELDS: &'static [Field] = &[];
    fn build(_: &Values, _: &mut ParamValues, _: &mut Diagnostics) -> Option<Self> {
        None
    }
    fn layout(&self) -> Layout {
        Layout { own: vec![Dof::scalar("angle", "rad", 0.1)], ..Layout::point(Link::On(self.0.clone())) }
    }
    fn physics(&self) -> Physics {
        Physics::Nonlinear
    }
    #[inline(always)]
    fn residual<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>, out: &mut Rows<S>) {
        let (hinge, arm) = arms(p, at);
        let turn = at.speed + at.v[2];
        let force = (c(at.a[0], at.a[1]) + along(hinge, at.spin_accel, at.speed) + along(arm, at.spin_accel + at.a[2], turn)).scale(p.mass);
        out.force[0] += force.re;
        out.force[1] += force.im;
        out.force[2] += (arm.conj() * force).im + p.drag * at.v[2];
        *out.spin += ((hinge + arm).conj() * force).im;
    }
    fn energy<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> Option<Energy<S>> {
        let (hinge, arm) = arms(p, at);
        let v = c(at.v[0], at.v[1]) + hinge.mul_i().scale(at.speed) + arm.mul_i().scale(at.speed + at.v[2]);
        Some(Energy { stored: (p.mass * v.norm_sqr()).scale(0.5), dissipated: p.drag * at.v[2].square(), ..Energy::zero() })
    }
}
