//! Plane flow of an ideal liquid in time: blocks and energy.

use super::{Coefficients, Fill, Liquid, LiquidParams};
use crate::model::blocks::Blocks;
use crate::model::part::At;
use laval_num::complex::{Complex, c};
use laval_num::scalar::Scalar;

impl Liquid {
    /// Surface displacement and its rate, from the four states at `first`.
    #[inline(always)]
    fn surface<S: Scalar>(at: &At<S>, first: usize) -> (Complex<S>, Complex<S>) {
        let (beta, eta) = (c(at.z[first], at.z[first + 1]), c(at.z[first + 2], at.z[first + 3]));
        (eta, eta.mul_i().scale(at.speed) - beta)
    }
    /// Plane flow in coordinates and states from these on, its masses multiplied by `slices` where given.
    #[inline(always)]
    pub(super) fn plane<S: Scalar>(&self, p: &LiquidParams<S>, w: S, b: &mut Blocks<S>, row: usize, state: usize, slices: Option<S>) {
        let Coefficients { mut full, mut void, g } = Self::coefficients(p);
        if let Some(s) = slices {
            full *= s;
            void *= s;
        }
        let (zero, one) = (S::zero(), S::one());
        match self.fill {
            Fill::Empty => {}
            Fill::Full => {
                for i in row..row + 2 {
                    b.mass[(i, i)] = full;
                }
            }
            Fill::Partial => {
                for i in row..row + 2 {
                    b.mass[(i, i)] = full * g;
                }
                let outer = full * (one - g);
                let (flow, surface) = (state, state + 2);
                b.state_force.add_complex(row, flow, zero, (outer * w).scale(2.0));
                b.state_force.add_complex(row, surface, outer * w * w, zero);
                b.spin_accel_state_force.add_complex(row, surface, zero, -void);
                b.state.add_complex(flow, flow, p.wave_damping.scale(-2.0), w + (g * w).scale(2.0));
                b.state.add_complex(flow, surface, g * w * w, zero);
                b.state.add_complex(surface, flow, -one, zero);
                b.state.add_complex(surface, surface, zero, w);
                b.state_a.add_complex(flow, row, -g, zero);
            }
        }
    }
    /// What the plane flow stores without spin, loses and gains, from the rate of its coordinates and its states.
    #[inline(always)]
    pub(super) fn plane_energy<S: Scalar>(&self, p: &LiquidParams<S>, at: &At<S>, row: usize, state: usize, slices: Option<S>) -> [S; 4] {
        let Coefficients { mut full, mut void, g } = Self::coefficients(p);
        if let Some(s) = slices {
            full *= s;
            void *= s;
        }
        let v = c(at.v[row], at.v[row + 1]);
        let w = at.speed;
        match self.fill {
            Fill::Empty => [S::zero(); 4],
            Fill::Full => [(full * v.norm_sqr()).scale(0.5), S::zero(), S::zero(), S::zero()],
            Fill::Partial => {
                let (eta, rate) = Self::surface(at, state);
                let gamma = S::one() / g;
                let wave = (gamma * rate.norm_sqr() - (gamma + S::one()) * w * w * eta.norm_sqr()).scale(0.5) - (v * rate.conj()).re;
                let slip = rate - eta.mul_i().scale(w);
                let loss = (rate.scale(gamma) - v) * slip.conj();
                let spin_up = gamma * (rate.conj() * eta.mul_i()).re - (gamma + S::one()) * w * eta.norm_sqr();
                [
                    ((full - void) * v.norm_sqr()).scale(0.5),
                    void * wave,
                    (p.wave_damping * void * loss.re).scale(2.0),
                    void * at.spin_accel * spin_up,
                ]
            }
        }
    }
    /// Moment of inertia of the liquid about the axis, kg m^2.
    #[inline(always)]
    pub(super) fn polar_inertia<S: Scalar>(&self, p: &LiquidParams<S>) -> S {
        let Coefficients { full, void, .. } = Self::coefficients(p);
        let (r2, s2) = (p.cavity_radius.square(), p.free_surface_radius.square());
        match self.fill {
            Fill::Empty => S::zero(),
            _ => ((full - void) * (r2 + s2)).scale(0.5),
        }
    }
}
