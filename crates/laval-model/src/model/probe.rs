//! What of the motion of bodies counts as motion: the displacement of every point where something is attached or that is named, and the tilt.

use super::field::Attach;
use super::part::Link;
use super::system::System;
use laval_num::complex::C64;
use laval_num::scalar::Scalar;
use serde::{Deserialize, Serialize};

/// What a probe measures.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Sight {
    /// Displacement of the body's point at this height above its reference point, m.
    Displacement(f64),
    /// Tilt.
    Tilt,
}

/// A pair of components that is measured of a body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Probe {
    /// Index in [`System::bodies`].
    pub body: usize,
    /// Name of the body.
    pub name: String,
    /// What it measures.
    pub sight: Sight,
    /// Both components over the coordinates.
    pub rows: [Vec<(usize, f64)>; 2],
}

impl Probe {
    /// The displacement of the reference point of a body.
    pub fn is_reference(&self) -> bool {
        self.sight == Sight::Displacement(0.0)
    }
    /// It measures the tilt.
    pub fn is_tilt(&self) -> bool {
        self.sight == Sight::Tilt
    }
    /// SI unit.
    pub fn unit(&self) -> &'static str {
        if self.is_tilt() { "rad" } else { "m" }
    }
    /// A typical size, for comparisons with rounding only.
    pub fn typical(&self) -> f64 {
        if self.is_tilt() { 1e-2 } else { 1e-3 }
    }
    /// Both components at these coordinates.
    pub fn of(&self, q: &[f64]) -> [f64; 2] {
        [0, 1].map(|k| self.rows[k].iter().map(|&(g, x)| x * q[g]).sum())
    }
    /// The same in scalars.
    pub fn scaled<S: Scalar>(&self, q: &[S]) -> [S; 2] {
        [0, 1].map(|k| self.rows[k].iter().fold(S::zero(), |s, &(g, x)| s + q[g].scale(x)))
    }
    /// Both components of amplitudes.
    pub fn amplitudes(&self, q: &[C64]) -> [C64; 2] {
        [0, 1].map(|k| self.rows[k].iter().fold(C64::zero(), |s, &(g, x)| s + q[g].scale(x)))
    }
}

/// The probes of a machine.
pub(super) fn all(system: &System) -> Vec<Probe> {
    let mut out = Vec::new();
    for (k, body) in system.bodies().into_iter().enumerate() {
        let probe = |sight, rows| Probe { body: k, name: body.name.clone(), sight, rows };
        let reference = [0, 1].map(|i| vec![(body.x + i, 1.0)]);
        out.push(probe(Sight::Displacement(0.0), reference.clone()));
        let named = system.machine.points.iter().filter(|p| p.0 == body.name).map(|p| p.1);
        let mut heights: Vec<f64> = attached(system, &body.name).chain(named).filter(|z| *z != 0.0).collect();
        heights.sort_by(f64::total_cmp);
        heights.dedup();
        for z in heights {
            if let Ok([x, y, ..]) = system.point_rows(body.slot, &Attach::at(body.name.clone(), z))
                && [&x, &y] != [&reference[0], &reference[1]]
            {
                out.push(probe(Sight::Displacement(z), [x, y]));
            }
        }
        if let Some(t) = body.tilt {
            out.push(probe(Sight::Tilt, [0, 1].map(|i| vec![(t + i, 1.0)])));
        }
    }
    out
}

/// Heights on a body at which parts are attached to it.
fn attached<'a>(system: &'a System, body: &'a str) -> impl Iterator<Item = f64> + 'a {
    let links = system.slots().iter().flat_map(|s| &s.layout.ports).flat_map(|p| match &p.link {
        Link::On(a) => [Some(a), None],
        Link::Between(a, b) => [Some(a), Some(b)],
    });
    links.flatten().filter(move |a| a.body.as_deref() == Some(body)).map(|a| a.position)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::builder::Builder;

    use crate::parts::{bearing_cubic::*, disc::*};

    /// A tilt moves the points above and below the reference point to opposite sides, and not the point itself.
    #[test]
    fn points_tilt_and_reference() {
        let spring = |z: f64| BearingCubic::isotropic(Link::Between(Attach::at("d", z), Attach::ground()));
        let law = BearingCubicParams { stiffness: [1e3; 2], cubic_stiffness: [0.0; 2], valid_to: 0.0 };
        let disc = |diametral: f64| DiscParams { diametral_inertia: diametral, polar_inertia: 0.01, ..DiscParams::new(1.0) };
        let build = |b: Builder| {
            let b = b.part("upper", spring(0.1), law).part("other", spring(0.1), law).part("lower", spring(-0.2), law);
            b.part("middle", spring(0.0), law).build().unwrap_or_else(|d| panic!("{d:?}"))
        };
        let tilting = build(Builder::new("t").part("d", Disc::tilting(), disc(0.01)));
        let sights: Vec<Sight> = tilting.probes().iter().map(|p| p.sight).collect();
        let at = Sight::Displacement;
        assert_eq!(sights, [at(0.0), at(-0.2), at(0.1), Sight::Tilt]);
        let q = [0.5, 0.25, 2.0, 3.0];
        let seen: Vec<[f64; 2]> = tilting.probes().iter().map(|p| p.of(&q)).collect();
        // x + z beta, y - z alpha
        assert_eq!(seen, [[0.5, 0.25], [0.5 - 0.2 * 3.0, 0.25 + 0.2 * 2.0], [0.5 + 0.1 * 3.0, 0.25 - 0.1 * 2.0], [2.0, 3.0]]);
        // of a planar disc all points move alike
        assert_eq!(build(Builder::new("p").part("d", Disc::planar(), disc(0.0))).probes().len(), 1);
    }
}
