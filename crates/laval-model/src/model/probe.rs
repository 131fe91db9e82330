//! What of the motion of bodies counts as motion: the displacement of every point where something is attached or that is named, and the tilt.

use super::field::Attach;
use super::part::Link;
use super::system::System;
use laval_num::complex::C64;
use laval_num::order::ascending;
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
    /// Significant digits of the height that tell the points of this body apart.
    pub digits: usize,
    /// Both components over the coordinates.
    pub rows: [Vec<(usize, f64)>; 2],
}

impl Probe {
    /// The displacement of the reference point of a body.
    pub fn is_reference(&self) -> bool {
        self.sight == Sight::Displacement(0.0)
    }
    /// The displacement of the point at this height.
    pub fn is_at(&self, height: f64) -> bool {
        matches!(self.sight, Sight::Displacement(z) if same_height(z, height))
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
        let reference = [0, 1].map(|i| vec![(body.x + i, 1.0)]);
        let named = system.machine.points.iter().filter(|p| p.0 == body.name).map(|p| p.1);
        let mut heights: Vec<f64> = attached(system, &body.name).chain(named).filter(|z| *z != 0.0).collect();
        ascending(&mut heights);
        heights.dedup_by(|a, b| same_height(*a, *b));
        let digits = distinct_digits(&heights);
        let probe = |sight, rows| Probe { body: k, name: body.name.clone(), sight, digits, rows };
        out.push(probe(Sight::Displacement(0.0), reference.clone()));
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

/// Equal to the rounding of a conversion between units: "235.1 mm" and "0.2351 m".
fn same_height(a: f64, b: f64) -> bool {
    (a - b).abs() <= 4.0 * f64::EPSILON * a.abs().max(b.abs())
}

/// The fewest significant digits, at least four, to which no two of these sorted heights are equal; 17 tell all numbers apart.
fn distinct_digits(heights: &[f64]) -> usize {
    let rounded = |z: f64, digits: usize| format!("{z:.*e}", digits - 1);
    let distinct = |digits: &usize| heights.windows(2).all(|w| rounded(w[0], *digits) != rounded(w[1], *digits));
    (4..17).find(distinct).unwrap_or(17)
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

    /// Points of one body are named apart, however close they are.
    #[test]
    fn digits_tell_heights_apart() {
        for (heights, digits) in [(&[][..], 4), (&[-0.2, 0.1], 4), (&[-0.23512, -0.23508], 5), (&[0.1, 0.1 + 1e-12], 12)] {
            assert_eq!(distinct_digits(heights), digits, "{heights:?}");
        }
        assert!(same_height(0.3, 0.1 + 0.2) && same_height(235.1 * 1e-3, 0.2351) && !same_height(0.3, 0.3 + 1e-14));
    }

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
