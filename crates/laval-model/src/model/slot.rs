//! Parts in their places: how their local coordinates stand over those of the machine.

use super::erased::Erased;
use super::part::{At, Dof, Layout, Physics, Uses};
use crate::diagnostic::Span;
use laval_num::scalar::Scalar;
use std::ops::Range;
use std::sync::Arc;

/// A part before assembly.
#[derive(Clone)]
pub struct PartInput {
    /// Name, unique in the machine.
    pub name: String,
    /// The part.
    pub part: Arc<dyn Erased>,
    /// Its parameters in slot order, SI.
    pub params: Vec<f64>,
    /// Place of the block in the file.
    pub span: Option<Span>,
}

/// The speed of one spin over that of another, by the parameters that are their ratios to the first spin of the machine; none of that itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ratio {
    /// The one.
    pub of: Option<usize>,
    /// The other.
    pub to: Option<usize>,
}

impl Ratio {
    /// Its value.
    #[inline(always)]
    pub fn value<S: Scalar>(self, params: &[S]) -> S {
        let of = |k: Option<usize>| k.map_or(S::one(), |i| params[i]);
        match self.to {
            None => of(self.of),
            Some(i) => of(self.of) / params[i],
        }
    }
}

/// A part in its place.
pub struct Slot {
    /// Name.
    pub name: String,
    /// The part.
    pub part: Arc<dyn Erased>,
    /// Its layout.
    pub layout: Layout,
    /// Form of its physics.
    pub physics: Physics,
    /// What its residual reads.
    pub uses: Uses,
    /// Its parameters among the machine's.
    pub params: Range<usize>,
    /// The parameter that is the ratio of its spin to the first spin of the machine; none of what turns with that.
    pub spin: Option<usize>,
    /// Of a part that turns with another spin than the one that the speed of the machine is that of.
    pub ratio: Option<Ratio>,
    /// Each local coordinate as a combination of global ones: the rows of B.
    pub map: Vec<Vec<(usize, f64)>>,
    /// What the weight adds to the local accelerations the part sees (a body at rest in a field g moves like one accelerated by -g), m/s^2.
    pub weight: Vec<f64>,
    /// Its own coordinates among the machine's.
    pub own: Range<usize>,
    /// Its internal states among the machine's.
    pub states: Range<usize>,
    /// How many of them, at the end, are memory states.
    pub memory: usize,
    /// Distance in their order over which its local coordinates are coupled.
    pub reach: usize,
    /// Place in the file.
    pub span: Option<Span>,
}

impl Slot {
    /// A linear (or time-fitted) part, given by its blocks in time.
    pub fn is_linear(&self) -> bool {
        self.physics != Physics::Nonlinear
    }
    /// The coordinates of the machine that it sees, ascending.
    pub fn coordinates(&self) -> Vec<usize> {
        let mut own: Vec<usize> = self.map.iter().flatten().map(|x| x.0).collect();
        own.sort_unstable();
        own.dedup();
        own
    }
    /// The speed of its spin when the machine turns at `speed`.
    #[inline(always)]
    pub fn speed<S: Scalar>(&self, params: &[S], speed: S) -> S {
        self.ratio.map_or(speed, |r| r.value(params) * speed)
    }
    /// The angle, speed and acceleration of its spin at a point of the machine.
    #[inline(always)]
    pub fn turned<'a, S: Scalar>(&self, params: &[S], at: At<'a, S>) -> At<'a, S> {
        match self.ratio {
            None => at,
            Some(ratio) => {
                let r = ratio.value(params);
                At { phase: r * at.phase, speed: r * at.speed, spin_accel: r * at.spin_accel, ..at }
            }
        }
    }
    /// Its share in the spin row of the machine: the torque on its spin, carried over by the ratio.
    #[inline(always)]
    pub fn torque<S: Scalar>(&self, params: &[S], torque: S) -> S {
        self.ratio.map_or(torque, |r| r.value(params) * torque)
    }
    /// Local coordinates that are coupled with one of them.
    pub fn neighbours(&self, i: usize) -> Range<usize> {
        i.saturating_sub(self.reach)..self.map.len().min(i.saturating_add(self.reach).saturating_add(1))
    }
}

/// A global coordinate or state.
#[derive(Clone, Debug, PartialEq)]
pub struct GlobalDof {
    /// `part.name`.
    pub name: String,
    /// Part that owns it.
    pub slot: usize,
    /// Kind, unit and typical size.
    pub dof: Dof,
}

/// Fills `local` with the local coordinates of a map.
#[inline]
pub fn gather<S: Scalar>(map: &[Vec<(usize, f64)>], global: &[S], local: &mut Vec<S>) {
    local.clear();
    for row in map {
        let mut x = S::zero();
        for &(g, c) in row {
            x += if c == 1.0 { global[g] } else { global[g].scale(c) };
        }
        local.push(x);
    }
}

/// Adds local forces to the global rows.
#[inline]
pub fn scatter<S: Scalar>(map: &[Vec<(usize, f64)>], local: &[S], global: &mut [S]) {
    for (row, &f) in map.iter().zip(local) {
        for &(g, c) in row {
            global[g] += if c == 1.0 { f } else { f.scale(c) };
        }
    }
}
