//! Self-centring: where bodies go when the speed grows without bound.
//!
//! With Z(i W) the dynamic stiffness of the linear parts at the spin frequency and F(W) what turns with the rotor, both grow like W^2, and
//!
//! ```text
//! Z(i W) x = F(W),   x -> x0 = -M0^-1 (F / W^2)       as W -> infinity
//! ```
//!
//! M0 the masses as the spin sees them: a liquid that partly fills a cavity acts as if the cavity were full. Springs of whatever law drop out, so that nonlinear parts
//! are left out. A rotor of mass m with the eccentricity e whose full cavity holds mL goes to `-m e/(m + mL)`.
//!
//! Validity: on the branch of small motions; parts whose stiffness grows with the square of the speed or faster have no such limit (`None`).
//!
//! Theory: `docs/theory/linear-vibration.md#self-centring`.
//!
//! Sources: `000_a291f7ede1484e56` section 1.4, corrected.

use super::harmonic::balance::orbit::Orbit;
use super::linear_response::of_linear_parts;
use crate::model::system::System;
use serde::{Deserialize, Serialize};

/// The limit.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Limit {
    /// The circular motion of all coordinates, at a speed where it stands for the limit; internal states are left out.
    pub orbit: Orbit,
    /// Relative change from a tenth of that speed.
    pub change: f64,
}

/// Speeds, over the highest of interest, at which the limit is taken and compared.
const FAR: [f64; 2] = [1e4, 1e5];
/// Relative change between them that a limit is allowed.
const SETTLED: f64 = 1e-3;

/// Where the bodies of a machine go beyond `top`, rad/s; `None` when there is no limit or nothing moves them.
pub fn limit(system: &System, top: f64) -> Option<Limit> {
    let [near, far] = FAR.map(|f| of_linear_parts(system, f * top));
    let (near, far) = (near?, far?);
    let n = system.n();
    let size = far.x[..n].iter().fold(0.0f64, |m, z| m.max(z.abs()));
    let apart = far.x[..n].iter().zip(&near.x).fold(0.0f64, |m, (a, b)| m.max((*a - *b).abs()));
    let change = apart / size;
    (size > 0.0 && change <= SETTLED).then(|| Limit {
        orbit: Orbit {
            speed: far.speed,
            frequency: far.speed,
            orders: vec![1],
            coordinates: vec![far.x[..n].to_vec()],
            states: vec![vec![laval_num::complex::C64::zero(); system.m()]],
            ..Orbit::default()
        },
        change,
    })
}
