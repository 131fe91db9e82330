//! A cavity that is not where the shaft is: its middle off the shaft by an eccentricity, its axis turned out of the shaft by a skew, both fixed in the rotor.
//!
//! ```text
//! z = z_shaft + E,   theta = theta_shaft + T,   E = e exp(i (phi + phi_e)),   T = tau exp(i (phi + phi_t))
//! eta = surface - E                              the state `surface` is measured from the shaft, `eta` from the middle of the cavity
//! beta' = i W beta + g (2 i W beta + W^2 surface - z_shaft'') - i g W' E - 2 delta beta,    surface' = i W surface - beta
//! F     = [mL W^2 - i W' (mL g + mo)] E + the force without eccentricity
//! M     = [mL W^2 - i W' (mL g + mo)] T h^2/12   strip;   [(A - C) W^2 - i W' (A - C/2)] T   planar_tilt, frozen;   Lt(W) T   spatial
//! spin row: Re(conj(i E) F_row) + Re(conj(i T) M_row)
//! ```
//!
//! At constant speed the liquid in an eccentric cavity is an unbalance of the full cavity, whatever the fill: its surface stays round the axis of rotation.
//!
//! Symbols: e eccentricity, m; tau skew, rad; phi_e, phi_t their angles from the key mark, rad; the others as in the [part](super).
//!
//! Theory: `docs/theory/liquid-in-three-dimensions.md#cavity-off-the-shaft`.
//!
//! Sources: the equations of the [part](super) with the motion of the cavity in place of that of the shaft; `L(W) [e; tau]` in the frequency domain.

use super::{Coefficients, Fill, Liquid, LiquidParams, Model};
use crate::model::blocks::{Blocks, rotating};
use crate::model::part::At;
use laval_num::complex::{Complex, c};
use laval_num::scalar::Scalar;

/// A point as the liquid sees it: motion of the cavity, surface measured from its middle.
pub(super) struct Seen<S> {
    q: [S; 4],
    v: [S; 4],
    a: [S; 4],
    z: [S; 8],
    states: usize,
    /// E and T.
    pub offsets: [Complex<S>; 2],
}

impl<S: Scalar> Seen<S> {
    /// The point.
    pub fn at(&self, at: &At<S>) -> At<'_, S> {
        let (n, m) = (at.q.len(), self.states);
        let At { phase, speed, spin_accel, t, .. } = *at;
        At { q: &self.q[..n], v: &self.v[..n], a: &self.a[..n], z: &self.z[..m], phase, speed, spin_accel, t }
    }
}

impl Liquid {
    /// The point with the cavity's offsets.
    #[inline(always)]
    pub(super) fn seen<S: Scalar>(&self, p: &LiquidParams<S>, at: &At<S>) -> Seen<S> {
        let offsets =
            [Complex::cis(at.phase + p.eccentricity_phase).scale(p.eccentricity), Complex::cis(at.phase + p.skew_phase).scale(p.skew)];
        // waves of axial flow see the motion of the shaft
        let (n, m) = (at.q.len(), self.plane_states());
        let zero = S::zero();
        let mut out = Seen { q: [zero; 4], v: [zero; 4], a: [zero; 4], z: [zero; 8], states: m, offsets };
        out.q[..n].copy_from_slice(at.q);
        out.v[..n].copy_from_slice(at.v);
        out.a[..n].copy_from_slice(at.a);
        out.z[..m].copy_from_slice(&at.z[..m]);
        for (i, e) in offsets.into_iter().enumerate().take(n / 2) {
            let rate = e.mul_i().scale(at.speed);
            let accel = e.mul_i().scale(at.spin_accel) - e.scale(at.speed * at.speed);
            for (x, e) in [(&mut out.q, e), (&mut out.v, rate), (&mut out.a, accel)] {
                x[2 * i] += e.re;
                x[2 * i + 1] += e.im;
            }
            if i < m / 4 {
                out.z[4 * i + 2] -= e.re;
                out.z[4 * i + 3] -= e.im;
            }
        }
        out
    }

    /// Forces and rates of eccentricity and skew.
    #[inline(always)]
    pub(super) fn add_offsets<S: Scalar>(&self, p: &LiquidParams<S>, b: &mut Blocks<S>) {
        let Coefficients { full, void, g } = Self::coefficients(p);
        let one = S::one();
        let plane = match (self.model, self.fill) {
            (_, Fill::Empty) => return,
            (Model::Frozen, _) => (full - void, full - void),
            (_, Fill::Full) => (full, full),
            (_, Fill::Partial) => (full, full * g + void),
        };
        let push = rotating(p.eccentricity, p.eccentricity_phase);
        b.add_rotating([(0, one), (1, one)], push, plane.0, plane.1);
        // a part in the frequency domain has no states
        let states = self.plane_states();
        if states > 0 {
            b.add_rotating_rate(0, push, g);
        }
        let slices = Self::cavity(p).slices();
        let tilt = match self.model {
            Model::Planar => return,
            Model::Strip => (plane.0 * slices, plane.1 * slices),
            Model::Spatial => {
                let mean = (p.density * Self::cavity(p).mean()).scale(std::f64::consts::PI);
                (mean, mean)
            }
            Model::PlanarTilt | Model::Frozen => match self.rigid(p) {
                Some([a, cp]) => (a - cp, a - cp.scale(0.5)),
                None => return,
            },
        };
        let turn = rotating(p.skew, p.skew_phase);
        b.add_rotating([(2, one), (3, one)], turn, tilt.0, tilt.1);
        if states > 4 {
            b.add_rotating_rate(4, turn, g);
        }
    }

    /// Largest displacement of the surface in the cavity in steady whirl with the speed and against it, m, from the point as the liquid sees it: with the speed the surface stays
    /// round the axis, against it it moves by `1/(4 gamma + 3)` of the motion (of every slice, where the cavity tilts).
    pub(super) fn steady_excursion(&self, p: &LiquidParams<f64>, at: &At<f64>) -> f64 {
        let (r2, s2) = (p.cavity_radius * p.cavity_radius, p.free_surface_radius * p.free_surface_radius);
        let backward = 1.0 / (4.0 * (r2 + s2) / (r2 - s2) + 3.0);
        let one = |i: usize| {
            let (z, rate) = (c(at.q[2 * i], at.q[2 * i + 1]), c(at.v[2 * i], at.v[2 * i + 1]));
            let turned = rate.mul_i().scale(-1.0 / at.speed);
            0.5 * ((z + turned).abs() + backward * (z - turned).abs())
        };
        one(0) + if at.q.len() > 2 { 0.5 * p.cavity_height * one(1) } else { 0.0 }
    }

    /// What a cavity off the shaft adds to the spin row, from the point as the liquid sees it.
    #[inline(always)]
    pub(super) fn offset_torque<S: Scalar>(&self, p: &LiquidParams<S>, seen: &Seen<S>, at: &At<S>) -> S {
        let mut torque = (seen.offsets[0].mul_i().conj() * self.plane_row(p, at, 0)).re;
        if self.model == Model::Strip {
            torque += (seen.offsets[1].mul_i().conj() * self.plane_row(p, at, 1)).re * Self::cavity(p).slices();
        }
        if let Some([a, cp]) = self.rigid(p) {
            let (w, accel) = (at.speed, at.spin_accel);
            let (theta, rate, bend) = (c(at.q[2], at.q[3]), c(at.v[2], at.v[3]), c(at.a[2], at.a[3]));
            let row = bend.scale(a) - rate.mul_i().scale(cp * w) - theta.mul_i().scale((cp * accel).scale(0.5));
            torque += (seen.offsets[1].mul_i().conj() * row).re;
        }
        torque
    }

    /// The force row of plane flow: of the cavity's middle (0) or of slices that tilt (1).
    #[inline(always)]
    fn plane_row<S: Scalar>(&self, p: &LiquidParams<S>, at: &At<S>, i: usize) -> Complex<S> {
        let Coefficients { full, void, g } = Self::coefficients(p);
        let (w, accel) = (at.speed, at.spin_accel);
        let a = c(at.a[2 * i], at.a[2 * i + 1]);
        match (self.model, self.fill) {
            (_, Fill::Empty) => Complex::zero(),
            (Model::Frozen, _) => a.scale(full - void),
            (_, Fill::Full) => a.scale(full),
            (_, Fill::Partial) => {
                let (flow, eta) = (c(at.z[4 * i], at.z[4 * i + 1]), c(at.z[4 * i + 2], at.z[4 * i + 3]));
                let turning = flow.mul_i().scale(w.scale(2.0)) + eta.scale(w * w);
                a.scale(full * g) + turning.scale(full * (S::one() - g)) - eta.mul_i().scale(accel * void)
            }
        }
    }
}
