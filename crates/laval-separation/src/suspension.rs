//! Suspension in a separator: one fixed set of particles, so that counts are reproducible and comparable.
//!
//! Equations: with the exit times T_i of N particles, `eta(t) = #(T_i <= t)/N`; the quantile t_q is the order statistic number ceil(q N). Without inertia,
//! time and size enter through `tau = |s| t` alone, so that one set of products tau_i serves every size, viscosity and time:
//!
//! ```text
//! eta(d, t) = #(tau_i <= |s(d)| t)/N         d_q(t) = 2 sqrt(9 mu tau_q k/(2 |rho_p - rho_f| (1 - phi)^n t))
//! powder:  eta(t) = (1/N) sum_i P(size > d_i(t)),  d_i the size at which particle i is just caught
//! ```
//!
//! Sources: `docs/theory/separation.md#ensembles-and-recovery`.

use super::exit::{Exit, Surface};
use super::halton::{self, Point};
use super::law::Law;
use super::particle::{Medium, Particle};
use super::separator::Turning;
use laval_num::order::ascending;
use laval_num::work::Here;
use rayon::prelude::*;

/// Sizes (diameters, m) and densities (kg/m^3) of the particles.
#[derive(Clone, Debug, PartialEq)]
pub struct Powder {
    /// Diameters, m.
    pub size: Law,
    /// Densities, kg/m^3.
    pub density: Law,
}

impl Powder {
    /// The particle of a point of the set.
    pub fn particle(&self, p: &Point) -> Particle {
        Particle { radius: 0.5 * self.size.quantile(p.size), density: self.density.quantile(p.density) }
    }
}

/// A particle of the ensemble with its start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Member {
    /// Its point of the set.
    pub point: Point,
    /// Where it starts.
    pub start: [f64; 3],
}

/// The first `n` members of the set in a separator at one speed.
pub fn members(turning: &Turning, n: usize) -> Vec<Member> {
    // a liquid that fills little of its tube rejects most points
    (1..=(n as u64).saturating_mul(1000))
        .map(halton::point)
        .filter_map(|point| turning.start(&point).map(|start| Member { point, start }))
        .take(n)
        .collect()
}

/// Members in pairs: a point of the set, and its mirror image with all shares counted from the other end but the angle. The pairs have no drift towards the low ends of
/// the shares, which a set that is cut off has.
pub fn paired_members(turning: &Turning, n: usize) -> Vec<Member> {
    let mirrored =
        |p: &Point| Point { along: 1.0 - p.along, area: 1.0 - p.area, turn: p.turn, size: 1.0 - p.size, density: 1.0 - p.density };
    (1..=(n as u64).saturating_mul(1000))
        .map(halton::point)
        .flat_map(|p| [p, mirrored(&p)])
        .filter_map(|point| turning.start(&point).map(|start| Member { point, start }))
        .take(n)
        .collect()
}

/// How the particles leave.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Model {
    /// With inertia; where no closed form holds, of the particles alone whose inertia is felt.
    Adaptive,
    /// With inertia.
    Inertial,
    /// Drag and field in balance.
    Drifting,
}

/// Exit of one member at constant speed with Stokes' drag; `None` when it never leaves.
pub fn leave(turning: &Turning, medium: &Medium, particle: &Particle, member: &Member, model: Model) -> Option<Exit> {
    let rates = medium.rates(particle);
    match model {
        Model::Inertial | Model::Adaptive => turning.settle(&rates, member.start),
        Model::Drifting => turning.drift(rates.sedimentation, member.start),
    }
}

/// Exits of a powder, in the order of the members, on all cores.
pub fn settle(turning: &Turning, medium: &Medium, powder: &Powder, members: &[Member], model: Model) -> Vec<Option<Exit>> {
    let here = Here::now();
    let one = |m: &Member| {
        let _counted = here.enter();
        leave(turning, medium, &powder.particle(&m.point), m, model)
    };
    members.par_iter().map(one).collect()
}

/// Products `tau_i = |s| T_i` without inertia for heavy (`sign` 1) or light particles (`sign` -1), with the surfaces they meet, s^2.
pub fn products(turning: &Turning, members: &[Member], sign: f64) -> Vec<Option<(f64, Surface)>> {
    let here = Here::now();
    let one = |m: &Member| {
        let _counted = here.enter();
        turning.drift(sign, m.start).map(|e| (e.time, e.surface))
    };
    members.par_iter().map(one).collect()
}

/// Exit times in increasing order, infinite at the end for particles that stay.
pub fn sorted(times: impl Iterator<Item = Option<f64>>) -> Vec<f64> {
    let mut out: Vec<f64> = times.map(|t| t.filter(|t| !t.is_nan()).unwrap_or(f64::INFINITY)).collect();
    ascending(&mut out);
    out
}

/// Order statistic number ceil(q N); infinite when fewer leave. NaN without members.
pub fn quantile(sorted: &[f64], q: f64) -> f64 {
    if sorted.is_empty() {
        return f64::NAN;
    }
    let number = (q * sorted.len() as f64 - 1e-9).ceil().clamp(1.0, sorted.len() as f64);
    sorted[number as usize - 1]
}

/// Share that has left by a time.
pub fn efficiency(sorted: &[f64], t: f64) -> f64 {
    sorted.partition_point(|&x| x <= t) as f64 / sorted.len() as f64
}

/// Share of a powder that is caught in a time, by the exact sum over its sizes; `products` sorted or not, `density` of all particles.
pub fn powder_efficiency(products: &[f64], medium: &Medium, size: &Law, density: f64, t: f64) -> f64 {
    let sum: f64 = products.iter().map(|tau| size.above(2.0 * medium.radius_for(tau / t, density))).sum();
    sum / products.len() as f64
}

/// Diameter (m) of which a share q is caught in a time, without inertia.
pub fn cut_size(sorted_products: &[f64], medium: &Medium, density: f64, q: f64, t: f64) -> f64 {
    2.0 * medium.radius_for(quantile(sorted_products, q) / t, density)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn order_statistics() {
        let t = sorted([3.0, 1.0, 2.0, 4.0].into_iter().map(Some).chain([None]));
        assert_eq!(t, [1.0, 2.0, 3.0, 4.0, f64::INFINITY]);
        assert_eq!((quantile(&t, 0.2), quantile(&t, 0.2000001), quantile(&t, 0.8), quantile(&t, 1.0)), (1.0, 2.0, 4.0, f64::INFINITY));
        assert_eq!((efficiency(&t, 2.0), efficiency(&t, 0.5)), (0.4, 0.0));
        assert!(quantile(&[], 0.5).is_nan());
    }
}
