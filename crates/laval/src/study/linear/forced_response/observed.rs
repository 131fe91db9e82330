//! What the parts show along a linear response: forces and moments, and how far their validity is used up.

use super::linearised::forces;
use crate::diagnostic::Diagnostic;
use crate::model::blocks::Blocks;
use crate::model::part::{At, Physics};
use crate::model::system::{Slot, System, Workspace};
use crate::solve::characteristic::{Characteristic, Equilibrium};
use crate::solve::extrema::Curve;
use crate::solve::linear_response::{Response, response};
use crate::solve::locate::State;
use crate::solve::rest::clearance;
use crate::solve::sectors::circular;
use crate::study::shared::support::larger;
use laval_num::complex::{C64, c};
use laval_num::fourier;
use laval_num::text::Text;
use laval_num::work::Here;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// What the parts show along the response.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Observations {
    /// By part, then quantity.
    pub quantities: Vec<Shows>,
    /// Forces of nonlinear parts by their law for the linear motion, beside [`LINEARISED`] among the quantities.
    pub laws: Vec<Shows>,
    /// Largest use of validity at every speed.
    pub validity: Vec<f64>,
    /// Use of every statement of validity at every speed.
    pub uses: Vec<Use>,
    /// Statements of validity that do not hold throughout.
    pub outside: Vec<Outside>,
    /// Gaps that are open at rest and that the response would close.
    pub closed: Vec<Closed>,
}

/// Use of a statement of validity of a part; above 1 is outside.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Use {
    /// Name of the part.
    pub part: String,
    /// The statement.
    #[serde(deserialize_with = "laval_num::text::one")]
    pub what: Text,
    /// Largest ratio over a turn at every speed; NaN where it is not known.
    pub ratios: Vec<f64>,
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
    /// Largest use; infinite at a resonance without bound.
    pub ratio: f64,
    /// Speed where it occurs, rad/s.
    pub speed: f64,
    /// First speed outside, rad/s.
    pub from: f64,
    /// Last speed outside, rad/s.
    pub to: f64,
}

/// The quantity that is the force of a nonlinear part by its tangent at rest.
pub const LINEARISED: &str = "linearised force";

/// Instants of a turn at which the parts are evaluated.
const INSTANTS: u32 = 24;
/// Every third of them is one of the samples of squares.
const OF_SQUARES: usize = 3;
/// Distances from a pole, over its speed, of two responses whose difference tells what grows without bound there.
const BESIDE: [f64; 2] = [2e-6, 4e-6];
/// Growth of a use from the farther of them to the nearer from which on it grows with the pole, and the least use that is no rounding.
const GROWS: f64 = 1.01;
const NOTICED: f64 = 1e-6;

/// The machine at one instant of a turn.
struct Instant {
    q: Vec<f64>,
    v: Vec<f64>,
    a: Vec<f64>,
    z: Vec<f64>,
    phase: f64,
}

impl Instant {
    fn at(&self, speed: f64) -> At<'_, f64> {
        At { q: &self.q, v: &self.v, a: &self.a, z: &self.z, phase: self.phase, speed, spin_accel: 0.0, t: 0.0 }
    }
}

/// A turn of a response about its state.
fn turn(system: &System, rest: &Equilibrium, r: &Response) -> Vec<Instant> {
    let t = Characteristic::new(system, rest);
    let (n, s) = (system.n(), c(0.0, r.speed));
    let one = |turn: u32| {
        let turning = C64::cis(std::f64::consts::TAU * f64::from(turn) / f64::from(INSTANTS));
        let real = |z: C64| (z * turning).re;
        let mut z = rest.z.clone();
        for (&k, x) in t.states().iter().zip(&r.x[n..]) {
            z[k] += real(*x);
        }
        Instant {
            q: (0..n).map(|i| rest.q[i] + real(r.x[i])).collect(),
            v: (0..n).map(|i| real(r.x[i] * s)).collect(),
            a: (0..n).map(|i| real(r.x[i] * s * s)).collect(),
            z,
            phase: turning.arg(),
        }
    };
    (0..INSTANTS).map(one).collect()
}

/// Largest use of every statement of validity over a turn, by part and statement; what is no number stays.
fn uses(system: &System, turn: &[Instant], speed: f64, ws: &mut Workspace<f64>) -> Vec<(usize, Text, f64)> {
    let mut out: Vec<(usize, Text, f64)> = Vec::new();
    for instant in turn {
        for (k, (slot, u)) in system.validity(&instant.at(speed), ws).into_iter().enumerate() {
            // at every instant they come in the same order, unless a part states one twice
            let there = out.get(k).is_some_and(|o| (o.0, o.1) == (slot, u.what));
            let known = if there { out.get_mut(k) } else { out.iter_mut().find(|o| (o.0, o.1) == (slot, u.what)) };
            match known {
                Some(o) if !(o.2.is_nan() || u.ratio <= o.2) => o.2 = u.ratio,
                Some(_) => {}
                None => out.push((slot, u.what, u.ratio)),
            }
        }
    }
    out
}

/// Gaps that are open at rest: part, clearance there, and how far the motion of a turn closes it, m.
fn gaps<'s>(system: &'s System, rest: &Equilibrium, turn: &[Instant]) -> Vec<(&'s Slot, f64, f64)> {
    let one = |slot: &'s Slot| {
        let gap = clearance(system, slot, rest).filter(|gap| *gap > 0.0)?;
        let left = |i: &Instant| clearance(system, slot, &Equilibrium { q: i.q.clone(), z: i.z.clone(), ..rest.clone() });
        let closed = turn.iter().map(|i| left(i).filter(|left| left.is_finite()).map_or(f64::INFINITY, |left| gap - left));
        Some((slot, gap, closed.fold(0.0, |most: f64, x| if x <= most { most } else { x })))
    };
    system.slots().iter().filter_map(one).collect()
}

/// What the parts show in one response.
struct Seen<'s> {
    quantities: Vec<((String, Text, Text), f64)>,
    laws: Vec<(String, f64)>,
    gaps: Vec<(&'s Slot, f64, f64)>,
    uses: Vec<(usize, Text, f64)>,
}

fn seen<'s>(system: &'s System, state: State, r: &Response) -> Result<Seen<'s>, Diagnostic> {
    let mut ws = Workspace::default();
    let mut quantities: Vec<_> = exact_forces(system, r).into_iter().map(|(name, force)| ((name, "force", "N"), force)).collect();
    let mut laws = Vec::new();
    let rest = state(r.speed)?;
    for force in forces(system, &rest, r, INSTANTS) {
        laws.push((force.part.clone(), force.law));
        quantities.push(((force.part, LINEARISED, "N"), force.tangent));
    }
    let turn = turn(system, &rest, r);
    // the square of what a linear part shows has two harmonics: between the instants it is known as well
    let mut squares = BTreeMap::<_, Vec<f64>>::new();
    for instant in turn.iter().step_by(OF_SQUARES) {
        for (slot, o) in system.observe(&instant.at(r.speed), &mut ws) {
            let part = &system.slots()[slot];
            // the amplitude of a body is in its own columns; eliminated states are not at hand
            if part.physics == Physics::Linear && part.memory == 0 && !o.is_motion_of_body() {
                squares.entry((slot, o.name, o.unit)).or_default().push(o.value * o.value);
            }
        }
    }
    let shown = |((slot, what, unit), squares): ((usize, Text, Text), Vec<f64>)| {
        ((system.slots()[slot].name.clone(), what, unit), fourier::largest(&squares).sqrt())
    };
    quantities.extend(squares.into_iter().map(shown));
    Ok(Seen { quantities, laws, gaps: gaps(system, &rest, &turn), uses: uses(system, &turn, r.speed, &mut ws) })
}

/// Quantities that linear parts show and forces of nonlinear parts by their tangent, at their largest over one turn, and the use of every part's validity. Beside a pole
/// the amplitudes are no numbers: what grows there is without bound.
///
/// # Errors
/// As the state.
pub(super) fn observed(system: &System, state: State, curve: &Curve) -> Result<Observations, Diagnostic> {
    let points = &curve.points;
    let mut out: BTreeMap<(String, Text, Text), Vec<f64>> = BTreeMap::new();
    let mut laws: BTreeMap<String, Vec<f64>> = BTreeMap::new();
    let (mut validity, mut outside) = (vec![0.0f64; points.len()], Vec::<Outside>::new());
    let mut ws = Workspace::default();
    let mut closed = Vec::<Closed>::new();
    let mut each = BTreeMap::<(usize, Text), Vec<f64>>::new();
    let known = |r: &Response| r.x.iter().all(|x| x.is_finite());
    let here = Here::now();
    let one = |r: &Response| {
        let _counted = here.enter();
        known(r).then(|| seen(system, state, r)).transpose()
    };
    let all = points.par_iter().map(one).collect::<Vec<_>>();
    for (row, (r, now)) in points.iter().zip(all).enumerate() {
        let Some(now) = now? else {
            validity[row] = f64::NAN;
            continue;
        };
        let new = || vec![0.0; points.len()];
        for (what, value) in now.quantities {
            let column = out.entry(what).or_insert_with(new);
            column[row] = larger(column[row], value);
        }
        for (part, law) in now.laws {
            laws.entry(part).or_insert_with(new)[row] = law;
        }
        for (slot, gap, moved) in now.gaps {
            if !(moved <= gap) {
                close(&mut closed, &slot.name, (gap, moved - gap), r.speed);
            }
        }
        for (slot, what, ratio) in now.uses {
            if !(validity[row].is_nan() || ratio <= validity[row]) {
                validity[row] = if ratio.is_finite() { ratio } else { f64::NAN };
            }
            if !(ratio <= 1.0) {
                leave(&mut outside, system, (slot, what, ratio), r.speed);
            }
            each.entry((slot, what)).or_insert_with(new)[row] = ratio;
        }
    }
    for (row, _) in points.iter().enumerate().filter(|(_, r)| !known(r)) {
        out.values_mut().chain(each.values_mut()).chain(laws.values_mut()).for_each(|column| column[row] = f64::NAN);
    }
    for pole in curve.poles() {
        let sides = [1.0, -1.0].into_iter();
        let both = |side: f64| {
            let of = |d: f64| response(system, state, pole * (1.0 + side * d)).ok().flatten();
            Some([of(BESIDE[0])?, of(BESIDE[1])?])
        };
        let Some([near, far]) = sides.into_iter().find_map(both) else { continue };
        let (near_rest, far_rest) = (state(near.speed)?, state(far.speed)?);
        let (near_turn, far_turn) = (turn(system, &near_rest, &near), turn(system, &far_rest, &far));
        let before = uses(system, &far_turn, far.speed, &mut ws);
        for (slot, what, ratio) in uses(system, &near_turn, near.speed, &mut ws) {
            let other = before.iter().find(|o| (o.0, o.1) == (slot, what)).map_or(0.0, |o| o.2);
            if !(ratio <= GROWS * other) && !(ratio <= NOTICED) {
                leave(&mut outside, system, (slot, what, f64::INFINITY), pole);
            }
        }
        let before = gaps(system, &far_rest, &far_turn);
        for (slot, gap, moved) in gaps(system, &near_rest, &near_turn) {
            let other = before.iter().find(|o| o.0.name == slot.name).map_or(0.0, |o| o.2);
            if !(moved <= GROWS * other) && !(moved <= NOTICED * gap) {
                close(&mut closed, &slot.name, (gap, f64::INFINITY), pole);
            }
        }
    }
    let of = |((slot, what), ratios): ((usize, Text), Vec<f64>)| Use { part: system.slots()[slot].name.clone(), what, ratios };
    let statements = each.into_iter().map(of).collect();
    let quantities = out.into_iter().map(|((part, what, unit), values)| Shows { part, what, unit, values }).collect();
    let laws = laws.into_iter().map(|(part, values)| Shows { part, what: LINEARISED, unit: "N", values }).collect();
    Ok(Observations { quantities, laws, validity, uses: statements, outside, closed })
}

/// Uses of the statements of validity of parts (their index, the statement, the use), and gaps that are open at rest: the part, the clearance and how far it closes, m.
pub(in crate::study::linear) struct Assessed<'s> {
    uses: Vec<(usize, Text, f64)>,
    gaps: Vec<(&'s Slot, f64, f64)>,
}

impl<'s> Assessed<'s> {
    /// At a response of another frequency than the spin speed, rad/s.
    ///
    /// # Errors
    /// As the state.
    pub fn of(system: &'s System, state: State, r: &Response, speed: f64) -> Result<Self, Diagnostic> {
        let rest = state(speed)?;
        let turn = turn(system, &rest, r);
        Ok(Assessed { uses: uses(system, &turn, speed, &mut Workspace::default()), gaps: gaps(system, &rest, &turn) })
    }

    /// Enters statements that do not hold, and gaps that would close, at `place`.
    pub fn enter(self, system: &System, place: f64, (outside, closed): (&mut Vec<Outside>, &mut Vec<Closed>)) {
        for used in self.uses {
            if !(used.2 <= 1.0) {
                leave(outside, system, used, place);
            }
        }
        for (slot, gap, moved) in self.gaps {
            if !(moved <= gap) {
                close(closed, &slot.name, (gap, moved - gap), place);
            }
        }
    }
}

/// Enters that a part is outside a statement of its validity at a speed.
fn leave(outside: &mut Vec<Outside>, system: &System, (slot, what, ratio): (usize, Text, f64), speed: f64) {
    match outside.iter_mut().find(|o| o.slot == slot && o.what == what) {
        Some(o) => {
            (o.from, o.to) = (o.from.min(speed), o.to.max(speed));
            if !(ratio <= o.ratio) {
                (o.ratio, o.speed) = (ratio, speed);
            }
        }
        None => outside.push(Outside { slot, part: system.slots()[slot].name.clone(), what, ratio, speed, from: speed, to: speed }),
    }
}

/// Enters that the gap of a part closes at a speed.
fn close(closed: &mut Vec<Closed>, part: &str, (gap, depth): (f64, f64), speed: f64) {
    match closed.iter_mut().find(|c| c.part == part) {
        Some(c) => {
            (c.from, c.to) = (c.from.min(speed), c.to.max(speed));
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
        let speed = slot.speed(system.params(), r.speed);
        load.reset(n, 0, speed);
        if let Some(part) = slot.part.frequency_domain() {
            part.impedance_f64(params, c(0.0, r.speed), speed, &mut reaction);
            part.load_f64(params, speed, &mut load);
        }
        let force = |i: usize| (0..n).fold(c(-load.force_cos[i], load.force_sin[i]), |sum, j| sum + reaction[i * n + j] * moved[j]);
        let (forward, backward) = circular(force(0), force(1));
        (slot.name.clone(), forward.abs() + backward.abs())
    };
    slots.map(one).collect()
}
