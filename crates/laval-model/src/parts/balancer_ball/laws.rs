//! Forces on balls besides inertia and weight: drag, friction, contact.

use super::{BalancerBallParams, Ring};
use crate::model::part::At;
use laval_num::scalar::Scalar;

/// Drag and friction torque on a ball, N m, at a rate in its track; `inertia` m r^2.
#[inline(always)]
pub(super) fn drag<S: Scalar>(p: &BalancerBallParams<S>, inertia: S, speed: S, rate: S) -> S {
    if p.dry_torque.is_nothing() && p.rolling_resistance.is_nothing() {
        return p.drag * rate;
    }
    let turning = speed + rate;
    let dry = p.dry_torque + p.rolling_resistance * inertia * turning * turning;
    p.drag * rate + dry * rate / (rate * rate + p.friction_rate * p.friction_rate).sqrt()
}

/// The largest torque with which friction holds a ball that rests in its track, N m.
pub(super) fn grip(p: &BalancerBallParams, inertia: f64, speed: f64) -> f64 {
    p.dry_torque + p.rolling_resistance * inertia * speed * speed
}

/// Two balls of one track.
pub(super) struct Contact<S> {
    /// Angle between their centres when they touch.
    pub angle: S,
    /// Overlap (negative apart) and its rate.
    pub overlap: S,
    pub rate: S,
    /// 1 where the second ball is ahead, else -1.
    pub side: S,
    /// Torque of the elastic part, and of all, N m.
    pub spring: S,
    pub force: S,
}

impl<S: Scalar> Contact<S> {
    #[inline(always)]
    pub fn between(p: &BalancerBallParams<S>, ring: &Ring<S>, at: &At<S>, first: usize, second: usize) -> Self {
        let x = p.ball_radius / ring.radius;
        let angle = x.atan2((S::one() - x * x).sqrt()).scale(2.0);
        let (s, co) = (at.q[second] - at.q[first]).sin_cos();
        let apart = s.atan2(co);
        let side = apart.select_pos(S::one(), -S::one());
        let overlap = angle - side * apart;
        let rate = -(side * (at.v[second] - at.v[first]));
        let spring = p.contact_stiffness * overlap.pow_pos(1.5);
        let force = spring * (S::one() + p.contact_damping * rate).pos();
        Contact { angle, overlap, rate, side, spring, force }
    }
}
