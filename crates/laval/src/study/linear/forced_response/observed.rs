//! What the parts show along a linear response: forces and moments, and how far their validity is used up.

use crate::diagnostic::Diagnostic;
use crate::model::blocks::Blocks;
use crate::model::part::{At, Physics};
use crate::model::system::{Slot, System, Workspace};
use crate::solve::characteristic::{Characteristic, Equilibrium};
use crate::solve::linear_response::Response;
use crate::solve::locate::State;
use crate::solve::rest::clearance;
use crate::solve::sectors::circular;
use laval_num::complex::{C64, c};
use laval_num::text::Text;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// What the parts show along the response.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Observations {
    /// By part, then quantity.
    pub quantities: Vec<Shows>,
    /// Largest use of validity at every speed.
    pub validity: Vec<f64>,
    /// Statements of validity that do not hold throughout.
    pub outside: Vec<Outside>,
    /// Gaps that are open at rest and that the response would close.
    pub closed: Vec<Closed>,
}

/// A gap, open at rest, that the amplitudes of the response exceed.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Closed {
    /// Name of the part.
    pub part: String,
    /// Clearance at rest, m.
    pub gap: f64,
    /// Deepest penetration, m; infinite at a resonance without bound.
    pub depth: f64,
    /// First speed at which it would close, rad/s.
    pub from: f64,
    /// Last such speed, rad/s.
    pub to: f64,
    /// Speed of the deepest penetration, rad/s.
    pub speed: f64,
}

/// A quantity of a part.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Shows {
    /// Name of the part.
    pub part: String,
    /// Name of the quantity.
    #[serde(deserialize_with = "laval_num::text::one")]
    pub what: Text,
    /// SI unit.
    #[serde(deserialize_with = "laval_num::text::one")]
    pub unit: Text,
    /// Largest value over a turn at every speed.
    pub values: Vec<f64>,
}

/// A statement of validity that is left.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Outside {
    /// Index of the part.
    pub slot: usize,
    /// Its name.
    pub part: String,
    /// The statement.
    #[serde(deserialize_with = "laval_num::text::one")]
    pub what: Text,
    /// Largest use.
    pub ratio: f64,
    /// Speed where it occurs, rad/s.
    pub speed: f64,
    /// First speed outside, rad/s.
    pub from: f64,
    /// Last speed outside, rad/s.
    pub to: f64,
}

/// Quantities that linear parts show, at their largest over one turn, and the use of every part's validity. The observed force of a nonlinear part would
/// be that of a law the motion does not know; its validity is a matter of the motion itself.
///
/// # Errors
/// As the state.
pub(super) fn observed(system: &System, state: State, points: &[Response]) -> Result<Observations, Diagnostic> {
    let mut out: BTreeMap<(String, Text, Text), Vec<f64>> = BTreeMap::new();
    let (mut validity, mut outside) = (vec![0.0f64; points.len()], Vec::<Outside>::new());
    let mut ws = Workspace::default();
    let n = system.n();
    let mut closed = Vec::<Closed>::new();
    for (row, r) in points.iter().enumerate() {
        for (name, force) in exact_forces(system, r) {
            out.entry((name, "force", "N")).or_insert_with(|| vec![0.0; points.len()])[row] = force;
        }
        let rest = state(r.speed)?;
        let t = Characteristic::new(system, &rest);
        let s = c(0.0, r.speed);
        let open = |slot: &'_ Slot| clearance(system, slot, &rest).filter(|gap| *gap > 0.0);
        let gaps: Vec<(&Slot, f64)> = system.slots().iter().filter_map(|slot| Some((slot, open(slot)?))).collect();
        for turn in 0..24 {
            let turning = C64::cis(std::f64::consts::TAU * turn as f64 / 24.0);
            let real = |z: C64| (z * turning).re;
            let q: Vec<f64> = (0..n).map(|i| rest.q[i] + real(r.x[i])).collect();
            let v: Vec<f64> = (0..n).map(|i| real(r.x[i] * s)).collect();
            let a: Vec<f64> = (0..n).map(|i| real(r.x[i] * s * s)).collect();
            let mut z = rest.z.clone();
            for (&k, x) in t.states().iter().zip(&r.x[n..]) {
                z[k] += real(*x);
            }
            for &(slot, gap) in &gaps {
                let moved = Equilibrium { q: q.clone(), z: z.clone(), ..rest.clone() };
                // the amplitude beside a pole is not a number
                let depth = clearance(system, slot, &moved).filter(|left| left.is_finite()).map_or(f64::INFINITY, |left| -left);
                if depth > 0.0 {
                    close(&mut closed, &slot.name, (gap, depth), r.speed);
                }
            }
            let at = At { q: &q, v: &v, a: &a, z: &z, phase: turning.arg(), speed: r.speed, spin_accel: 0.0, t: 0.0 };
            for (k, u) in system.validity(&at, &mut ws) {
                // the amplitude beside a pole is not a number
                if !r.x.iter().all(|x| x.is_finite()) {
                    validity[row] = f64::NAN;
                    continue;
                }
                if !(validity[row].is_nan() || u.ratio <= validity[row]) {
                    validity[row] = if u.ratio.is_finite() { u.ratio } else { f64::NAN };
                }
                if u.ratio <= 1.0 {
                    continue;
                }
                match outside.iter_mut().find(|o| o.slot == k && o.what == u.what) {
                    Some(o) => {
                        o.to = r.speed;
                        if !(u.ratio <= o.ratio) {
                            (o.ratio, o.speed) = (u.ratio, r.speed);
                        }
                    }
                    None => outside.push(Outside {
                        slot: k,
                        part: system.slots()[k].name.clone(),
                        what: u.what,
                        ratio: u.ratio,
                        speed: r.speed,
                        from: r.speed,
                        to: r.speed,
                    }),
                }
            }
            for (slot, o) in system.observe(&at, &mut ws) {
                let slot = &system.slots()[slot];
                // the amplitude of a body is in its own columns; eliminated states are not at hand
                if slot.physics != Physics::Linear || slot.memory > 0 || o.is_motion_of_body() {
                    continue;
                }
                let column: &mut Vec<f64> = out.entry((slot.name.clone(), o.name, o.unit)).or_insert_with(|| vec![0.0; points.len()]);
                if o.value.abs() > column[row] || o.value.is_nan() {
                    column[row] = o.value.abs();
                }
            }
        }
    }
    let quantities = out.into_iter().map(|((part, what, unit), values)| Shows { part, what, unit, values }).collect();
    Ok(Observations { quantities, validity, outside, closed })
}

/// Enters that the gap of a part closes at a speed.
fn close(closed: &mut Vec<Closed>, part: &str, (gap, depth): (f64, f64), speed: f64) {
    match closed.iter_mut().find(|c| c.part == part) {
        Some(c) => {
            c.to = speed;
            if depth > c.depth {
                (c.depth, c.speed, c.gap) = (depth, speed, gap);
            }
        }
        None => closed.push(Closed { part: part.into(), gap, depth, from: speed, to: speed, speed }),
    }
}

/// Forces of the parts that are given in the frequency domain, by their exact reaction: what they put on their first pair of coordinates, such as a liquid on
/// the wall of its cavity. Semi-major axes, N.
fn exact_forces(system: &System, r: &Response) -> Vec<(String, f64)> {
    let slots = system.slots().iter().filter(|s| matches!(s.physics, Physics::Frequency(_)) && s.map.len() >= 2);
    let one = |slot: &Slot| {
        let (n, params) = (slot.map.len(), &system.params()[slot.params.clone()]);
        let moved: Vec<C64> = slot.map.iter().map(|row| row.iter().fold(C64::zero(), |sum, &(g, x)| sum + r.x[g].scale(x))).collect();
        let (mut reaction, mut load) = (vec![C64::zero(); n * n], Blocks::default());
        load.reset(n, 0, r.speed);
        if let Some(part) = slot.part.frequency_domain() {
            part.impedance_f64(params, c(0.0, r.speed), r.speed, &mut reaction);
            part.load_f64(params, r.speed, &mut load);
        }
        let force = |i: usize| (0..n).fold(c(-load.force_cos[i], load.force_sin[i]), |sum, j| sum + reaction[i * n + j] * moved[j]);
        let (forward, backward) = circular(force(0), force(1));
        (slot.name.clone(), forward.abs() + backward.abs())
    };
    slots.map(one).collect()
}
