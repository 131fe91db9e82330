//! The machine at rest under its weight and constant forces: deflections on the stiffness that its bearings have at a speed, and on rigid supports.
//!
//! ```text
//! K q + n(q) = f0 + B l,   B' q = d        K without circulatory terms, n nonlinear parts, B places held, l the forces that hold them, d their offsets
//! ```
//!
//! A support that is raised by d sees its turning end displaced by -d ([`offsets`]).
//!
//! Nothing turns: what a speed does to the rotor (circulatory terms, memory that turns with it) is left out; bearings have the coefficients of the stated speed.
//!
//! Theory: `docs/theory/shafts.md#sag`.

pub mod alignment;
pub mod beam;
pub mod bearing;
mod equations;
pub mod forces;
pub mod influence;
pub mod masses;
pub mod offsets;
pub mod supports;
pub mod unbalance;

use crate::diagnostic::Diagnostic;
use crate::model::part::DofKind;
use crate::model::station::Row;
use crate::model::system::System;
use crate::rest::rest;
use equations::Equations;
use laval_num::dense::{Lu, Mat};
use offsets::{Offset, Raised};
use serde::{Deserialize, Serialize};
use std::borrow::Cow;

/// A machine at rest.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Statics {
    /// Speed whose coefficients the bearings have, rad/s.
    pub speed: f64,
    /// Coordinates.
    pub q: Vec<f64>,
    /// Internal states of the whole machine.
    pub z: Vec<f64>,
    /// Forces on the places that are held, one for each component.
    pub holding: Vec<f64>,
    /// Parts that are left out, because their places are held.
    pub left_out: Vec<bool>,
    /// Supports that are raised.
    #[serde(default)]
    pub raised: Vec<Raised>,
    /// Newton steps taken.
    pub iterations: usize,
    /// Length of the last one relative to the typical sizes of the coordinates.
    pub last_step: f64,
}

impl Statics {
    /// The coordinates as a part sees them: a support that is raised sees its turning end lower.
    pub fn seen_by(&self, slot: usize) -> Cow<'_, [f64]> {
        match self.raised.iter().find(|r| r.slot == slot && !self.left_out[slot]) {
            Some(r) => Cow::Owned(r.seen(&self.q)),
            None => Cow::Borrowed(&self.q),
        }
    }
}

/// On the stiffness that the parts have at a speed (rad/s).
///
/// # Errors
/// A machine without equilibrium, as [`rest`].
pub fn own(system: &System, speed: f64) -> Result<Statics, Diagnostic> {
    let equations = Equations::new(system, speed, &vec![false; system.slots().len()], &[]);
    let start = if system.slots().iter().all(|s| s.is_linear()) {
        (vec![0.0; system.n()], vec![0.0; system.m()])
    } else {
        let found = rest(system, speed)?;
        (found.q, found.z)
    };
    equations.solve(start, &[], &[], 0.0)
}

/// The same machine with supports raised: from the state at other offsets, in as few steps as converge.
///
/// # Errors
/// Offsets at which no equilibrium is found.
pub fn raised(system: &System, from: &Statics, offsets: &[Offset]) -> Result<Statics, Diagnostic> {
    const SHORTEST: f64 = 1.0 / 256.0;
    let start: Vec<Offset> =
        offsets.iter().map(|o| Offset { by: from.raised.iter().find(|r| r.slot == o.slot).map_or([0.0; 2], |r| r.by), ..*o }).collect();
    let (mut at, mut done, mut step) = (from.clone(), 0.0, 1.0f64);
    while done < 1.0 {
        let to = (done + step).min(1.0);
        let between = |(a, b): (&Offset, &Offset)| Offset { slot: a.slot, by: [0, 1].map(|p| a.by[p] + to * (b.by[p] - a.by[p])) };
        let now = Raised::all(system, &start.iter().zip(offsets).map(between).collect::<Vec<_>>());
        match Equations::new(system, from.speed, &from.left_out, &now).solve((at.q.clone(), at.z.clone()), &[], &[], 0.0) {
            Ok(state) => (at, done) = (state, to),
            Err(e) if 0.5 * step < SHORTEST => return Err(e),
            Err(_) => step *= 0.5,
        }
    }
    Ok(at)
}

/// With places held at offsets (m) instead of the parts that are left out; from the state on their stiffness.
///
/// # Errors
/// A machine that these places do not hold.
pub fn held(system: &System, from: &Statics, ties: &[Row], offsets: &[f64], left_out: &[bool]) -> Result<Statics, Diagnostic> {
    let equations = Equations::new(system, from.speed, left_out, &from.raised);
    equations.solve((from.q.clone(), from.z.clone()), ties, offsets, spring(system, from, &equations.load))
}

/// Stiffness of springs beside the ties, N/m: they only make the matrix regular, and carry nothing.
fn spring(system: &System, from: &Statics, load: &[f64]) -> f64 {
    let vector = |i: &usize| matches!(system.coordinates()[*i].dof.kind, DofKind::VectorX | DofKind::VectorY);
    let (load, moved) = (0..system.n()).filter(vector).fold((0.0, 0.0f64), |(f, x), i| (f + load[i].abs(), x.max(from.q[i].abs())));
    if load > 0.0 && moved > 0.0 { load / moved } else { 1e6 }
}

/// Value of a combination of coordinates.
fn along(row: &Row, x: &[f64]) -> f64 {
    row.iter().map(|&(i, a)| a * x[i]).sum()
}

/// Solves a small system; `None` where it is singular.
fn solved(a: &Mat, mut b: Vec<f64>) -> Option<Vec<f64>> {
    if b.is_empty() {
        return Some(b);
    }
    let lu = Lu::new(a).ok().filter(|lu| lu.pivot_ratio() > 1e-13)?;
    lu.solve(&mut b);
    Some(b)
}
