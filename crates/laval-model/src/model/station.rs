//! Points that results speak of: the reference point of a rigid body, positions along a flexible one.

use super::field::Attach;
use super::probe::{distinct_digits, same_height};
use super::system::System;
use crate::units::format_length;
use laval_num::complex::C64;
use laval_num::order::ascending;
use laval_num::scalar::Scalar;
use serde::{Deserialize, Serialize};

/// A combination of coordinates: index and factor.
pub type Row = Vec<(usize, f64)>;

/// Two components of a vector in x and y, each over the coordinates of the machine.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Pair(pub [Row; 2]);

impl Pair {
    /// A coordinate and the one after it.
    pub fn coordinates(first: usize) -> Self {
        Pair([0, 1].map(|k| vec![(first + k, 1.0)]))
    }
    /// Its first coordinate, where the components are two coordinates one after the other.
    pub fn first(&self) -> Option<usize> {
        match &self.0 {
            [x, y] => match (&x[..], &y[..]) {
                (&[(i, 1.0)], &[(j, 1.0)]) if j == i + 1 => Some(i),
                _ => None,
            },
        }
    }
    /// Both components at these coordinates, or of these rates.
    pub fn of(&self, q: &[f64]) -> [f64; 2] {
        [0, 1].map(|k| self.0[k].iter().map(|&(g, x)| x * q[g]).sum())
    }
    /// Length of the vector.
    pub fn length(&self, q: &[f64]) -> f64 {
        let [x, y] = self.of(q);
        x.hypot(y)
    }
    /// Both components in scalars.
    pub fn scaled<S: Scalar>(&self, q: &[S]) -> [S; 2] {
        [0, 1].map(|k| self.0[k].iter().fold(S::zero(), |s, &(g, x)| s + q[g].scale(x)))
    }
    /// Both components of amplitudes.
    pub fn amplitudes(&self, q: &[C64]) -> [C64; 2] {
        [0, 1].map(|k| self.0[k].iter().fold(C64::zero(), |s, &(g, x)| s + q[g].scale(x)))
    }
}

/// A point that results speak of.
#[derive(Clone, Debug, PartialEq)]
pub struct Station {
    /// Name: that of a rigid body, or "shaft at 120 mm".
    pub name: String,
    /// Slot of the body.
    pub slot: usize,
    /// Position along the axis from the reference point of the body, m.
    pub position: f64,
    /// Significant digits of the position that distinguish the stations of this body.
    pub digits: usize,
    /// The body bends: it has a station wherever something is attached.
    pub flexible: bool,
    /// Its displacement.
    pub lateral: Pair,
    /// Tilt of a rigid body that tilts.
    pub tilt: Option<Pair>,
}

impl Station {
    /// Names of its displacements: "drum.x", "shaft at 120 mm.x".
    pub fn columns(&self) -> [String; 2] {
        ["x", "y"].map(|k| format!("{}.{k}", self.name))
    }
}

impl System {
    /// The stations of the machine, in the order of the parts: one of each rigid body that is displaced, one of each place of a flexible body where a part
    /// that is no body is attached or that a block names, and its ends where there is none.
    pub fn stations(&self) -> &[Station] {
        self.stations.get_or_init(|| all(self))
    }
    /// Displacement of the point of a body at a position (m); `None` of a part that is no body.
    pub fn point(&self, slot: usize, position: f64) -> Option<Pair> {
        let slot_of = self.slots().get(slot)?;
        let [x, y, ..] = self.point_rows(slot, &Attach::at(slot_of.name.clone(), position)).ok()?;
        Some(Pair([x, y]))
    }
    /// Displacement along the axis and rotation about it of the point of a body at a position (m), as coordinates and their factors: empty where the body has
    /// none such. `None` of a part that is no body.
    pub fn point_along(&self, slot: usize, position: f64) -> Option<[Vec<(usize, f64)>; 2]> {
        let slot_of = self.slots().get(slot)?;
        let [.., axial, twist] = self.point_rows(slot, &Attach::at(slot_of.name.clone(), position)).ok()?;
        Some([axial, twist])
    }
}

fn all(system: &System) -> Vec<Station> {
    let mut out = Vec::new();
    for (k, slot) in system.slots().iter().enumerate() {
        let Some(body) = slot.part.body() else { continue };
        let nodes = body.nodes();
        let flexible = nodes.is_some();
        let positions = nodes.map_or_else(|| vec![0.0], |nodes| named(system, &slot.name, &nodes));
        let digits = distinct_digits(&positions);
        for position in positions {
            let Ok([x, y, tilt_x, tilt_y, ..]) = system.point_rows(k, &Attach::at(slot.name.clone(), position)) else { continue };
            if x.is_empty() || y.is_empty() {
                continue;
            }
            let tilts = !flexible && !tilt_x.is_empty() && !tilt_y.is_empty();
            out.push(Station {
                name: if flexible { at_height(&slot.name, position, digits) } else { slot.name.clone() },
                slot: k,
                position,
                digits,
                flexible,
                lateral: Pair([x, y]),
                tilt: tilts.then_some(Pair([tilt_x, tilt_y])),
            });
        }
    }
    out
}

/// "drum at 100 mm".
pub fn at_height(body: &str, height: f64, digits: usize) -> String {
    format!("{body} at {}", format_length(height, digits))
}

/// Places of a flexible body that are named.
fn named(system: &System, body: &str, nodes: &[f64]) -> Vec<f64> {
    let mut out: Vec<f64> =
        attached(system, body, false).chain(system.machine.points.iter().filter(|p| p.0 == body).map(|p| p.1)).collect();
    if out.is_empty() {
        out.extend(nodes.first().into_iter().chain(nodes.last()));
    }
    ascending(&mut out);
    out.dedup_by(|a, b| same_height(*a, *b));
    out
}

/// Positions on a body at which parts are attached to it; with `bodies` those of other bodies too.
pub(super) fn attached<'a>(system: &'a System, body: &'a str, bodies: bool) -> impl Iterator<Item = f64> + 'a {
    let ends = system.slots().iter().filter(move |s| bodies || !s.layout.body).flat_map(|s| &s.layout.ports).flat_map(|p| p.link.ends());
    ends.filter(move |a| a.body.as_deref() == Some(body)).map(|a| a.position)
}
