//! The requirements at one speed, each as a dimensionless margin: kept when 0 or more.

use super::Policy;
use super::detail::Detail;
use super::passage::Passage;
use super::steady::{Branches, Growth, State, linear, spectrum, states_validity};
use crate::diagnostic::Diagnostic;
use crate::model::system::{Slot, Station, System};
use crate::separation::batch::Batch;
use crate::separation::load::Load;
use crate::separation::measures::derated;
use crate::separation::particle::Particle;
use crate::separation::separator::Separator;
use crate::study::centrifuge::cups::Carried;
use crate::study::centrifuge::cups::task::{Task, needed};
use crate::study::shared::limits::{Limit, Limits};
use crate::study::shared::speed_range::fastest_ratio;
use crate::study::shared::support::{larger, largest};
use laval_num::complex::{C64, c};
use laval_num::order::{SortByNumber, ascending};
use laval_num::quadrature::gauss;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Names of the requirements, in the order they are shown.
pub(super) const NAMES: [&str; 8] = ["separation", "vibration", "self_centred", "stable", "clear", "passage", "strength", "valid"];
/// Index of the requirement on stability.
pub(super) const STABLE: usize = 3;

/// Index of the requirement that every part is inside its model: what is outside is not known. How far inside does not matter.
pub(super) const VALID: usize = 7;

/// With so many places one of every [`PART`] decides first, 256 or more; the relative error allowed for its time.
const MANY: usize = 256 * PART;
const PART: usize = 8;
const ALLOWANCE: f64 = 0.15;

/// Weight of the next margin beside the least when speeds are compared: a requirement that the speed hardly changes does not choose it.
const NEXT: f64 = 1e-3;

/// A requirement at a speed.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Margin {
    /// Index among the requirements, in the order they are shown: separation, vibration, self-centring, stability, clearance, passage, strength, validity.
    pub name: usize,
    /// Margin; NaN where it is not defined, which counts as not kept.
    pub value: f64,
    /// What binds in it.
    pub detail: Detail,
}

impl Margin {
    /// It is compared with others.
    fn counts(&self) -> bool {
        self.name != VALID || !(self.value >= 0.0)
    }
}

/// Everything at one speed.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Point {
    /// Spin speed, rad/s.
    pub speed: f64,
    /// The requirements.
    pub margins: Vec<Margin>,
    /// Time to reach the recovery, run-up counted as requested, s.
    pub needed: f64,
    /// Tilt of the cups, rad; NaN without cups.
    pub tilt: f64,
    /// Unbalance of the cups, kg m.
    pub unbalance: f64,
    /// Number of stable steady states.
    pub states: usize,
    /// Energy of a batch: kinetic energy of the spin and work of the drive at speed, J.
    pub energy: f64,
    /// Largest growth rate, before and after the separation, 1/s.
    pub growth: f64,
    /// Largest tilt of each body, rad.
    pub leans: Vec<f64>,
}

impl Point {
    /// All requirements are kept.
    pub fn feasible(&self) -> bool {
        self.margins.iter().all(|m| m.value >= 0.0)
    }
    /// Requirements that are not kept.
    pub(super) fn broken(&self) -> Vec<usize> {
        self.margins.iter().filter(|m| !(m.value >= 0.0)).map(|m| m.name).collect()
    }
    /// All but one.
    pub fn feasible_without(&self, name: usize) -> bool {
        self.margins.iter().all(|m| m.name == name || m.value >= 0.0)
    }
    /// The requirement with the least margin; an undefined one binds before all.
    pub fn binding(&self) -> Option<&Margin> {
        let key = |m: &Margin| if m.value.is_nan() { f64::NEG_INFINITY } else { m.value };
        self.margins.iter().filter(|m| m.counts()).min_by(|a, b| key(a).total_cmp(&key(b)))
    }
    /// The least margin; minus infinity when one is undefined.
    pub fn least(&self) -> f64 {
        self.binding().map_or(f64::INFINITY, |m| if m.value.is_nan() { f64::NEG_INFINITY } else { m.value })
    }
    /// For comparison by the least margin: where it hardly differs the next decides, and so on; minus infinity when one is undefined.
    pub fn room(&self) -> f64 {
        let mut all: Vec<f64> =
            self.margins.iter().filter(|m| m.counts()).map(|m| if m.value.is_nan() { f64::NEG_INFINITY } else { m.value }).collect();
        ascending(&mut all);
        all.iter().rev().fold(0.0, |rest, m| m + NEXT * rest)
    }
    /// Index of the requirement with the next margin beside the least.
    pub(super) fn next(&self) -> Option<usize> {
        let mut all: Vec<&Margin> = self.margins.iter().filter(|m| m.counts()).collect();
        all.sort_by_number(|a| a.value);
        all.get(1).map(|m| m.name)
    }
    /// The margin of a requirement.
    pub fn margin(&self, name: usize) -> Option<f64> {
        self.margins.iter().find(|m| m.name == name).map(|m| m.value)
    }
}

/// What is requested of the machine.
#[derive(Clone)]
pub(super) struct Requirements {
    pub task: Option<Task>,
    pub limits: Limits,
    pub cups: Vec<Carried>,
    /// The machine after the separation, where that changes it.
    pub after: Option<Arc<System>>,
    /// Time of the run-up to the top of the range, s.
    pub ramp: Option<f64>,
    pub policy: Policy,
}

/// Evaluates the requirements of one machine.
pub(super) struct Evaluator<'a> {
    pub system: &'a System,
    pub required: &'a Requirements,
    /// Branches of the response; none of a linear machine.
    pub branches: Option<&'a Branches>,
    pub passage: Option<&'a Passage>,
}

fn margin(name: usize, value: f64, detail: Detail) -> Margin {
    Margin { name, value, detail }
}

/// The least of several margins, NaN before all.
fn least(name: usize, all: impl Iterator<Item = (f64, Detail)>) -> Option<Margin> {
    all.reduce(|a, b| if b.0 < a.0 || b.0.is_nan() { b } else { a }).map(|(v, d)| margin(name, v, d))
}

impl Evaluator<'_> {
    /// All requirements at a speed.
    ///
    /// # Errors
    /// When the machine cannot be evaluated at all.
    pub fn at(&self, speed: f64) -> Result<Point, Diagnostic> {
        let mut point = self.mechanical(speed)?;
        self.separated(&mut point);
        Ok(point)
    }

    /// Adds the requirement on the separation, or replaces it.
    pub fn separated(&self, point: &mut Point) {
        if let Some(task) = &self.required.task {
            self.separate(point, task, &task.batch);
        }
    }

    /// The same for the least margin alone, down to `floor`: with a part of the places where the margin is far from deciding it.
    pub fn separated_down_to(&self, floor: f64, point: &mut Point) {
        let Some(task) = &self.required.task else { return };
        point.margins.retain(|m| m.name != 0);
        let others = point.least();
        if task.batch.places >= MANY {
            self.separate(point, task, &Batch { places: task.batch.places / PART, ..task.batch.clone() });
            let [least, most] = [1.0 + ALLOWANCE, 1.0 - ALLOWANCE].map(|k| 1.0 - k * point.needed / task.time);
            // NaN decides nothing
            if least > others || most < floor.min(others) {
                return;
            }
        }
        self.separate(point, task, &task.batch);
    }

    fn separate(&self, point: &mut Point, task: &Task, batch: &Batch) {
        // a path that cannot be computed leaves the margin undefined
        let found = needed(batch, point.speed, task.recovery, &|| true);
        let time = found.as_ref().map_or(f64::NAN, |t| *t);
        let value = 1.0 - time / task.time;
        let detail = found.map_or_else(|d| Detail::Path(d.message.to_string()), |_| Detail::Time);
        point.needed = time;
        point.margins.retain(|m| m.name != 0);
        point.margins.insert(0, margin(0, if value.is_finite() { value } else { f64::NAN }, detail));
    }

    /// Steady states of a machine with its load at a speed, and the growth rate about rest.
    fn states(&self, system: &System, speed: f64, eigen: Growth) -> Result<Vec<State>, Diagnostic> {
        match self.branches {
            None => Ok(linear(system, speed, eigen)?.into_iter().collect()),
            Some(branches) => branches.at(system, speed),
        }
    }

    /// Growth of the machine whose contents have separated; `None` where they weigh as before.
    fn growth_after(&self, speed: f64) -> Result<Option<Growth>, Diagnostic> {
        let Some(system) = self.required.after.as_deref() else { return Ok(None) };
        let eigen = Growth::of(&spectrum(system, speed)?);
        if self.branches.is_none() {
            return Ok(Some(eigen));
        }
        let states = self.states(system, speed, eigen)?;
        let met = self.assessed(system, states.iter().filter(|s| s.stable).collect(), speed);
        Ok(Some(worst_growth(&met, &states)))
    }

    /// All requirements but that on the separation.
    fn mechanical(&self, speed: f64) -> Result<Point, Diagnostic> {
        let required = self.required;
        let (system, loads) = (self.system, required.cups.iter().map(|c| c.ring.at(speed)).collect::<Vec<Load>>());
        let spectrum = spectrum(system, speed)?;
        let eigen = Growth::of(&spectrum);
        let states = self.states(system, speed, eigen)?;
        let nonlinear = self.branches.is_some();
        // a linear state that grows is assessed by its growth; of a nonlinear machine only states that last are met
        let met: Vec<&State> = states.iter().filter(|s| s.stable || !nonlinear).collect();
        let met = self.assessed(system, met, speed);
        let before = if nonlinear { worst_growth(&met, &states) } else { eigen };
        let limit = required.limits.growth;
        // stable before and after the separation; NaN stays
        let (growth, contents) = match self.growth_after(speed)? {
            None => (before, "always"),
            Some(after) if !(after.excess(limit) <= before.excess(limit)) => (after, "after"),
            Some(_) => (before, "before"),
        };
        let mut margins = Vec::new();
        margins.extend(self.vibration(system, &met));
        margins.extend(self.self_centred(system, speed, &met));
        // by the growth rate while borders are sought, then a distance in speed
        margins.push(margin(
            STABLE,
            if growth.rate == f64::NEG_INFINITY { 1.0 } else { -growth.excess(limit) / speed.abs() },
            Detail::Growth { contents },
        ));
        if let Some(clearance) = required.limits.clearance {
            let mut all: Vec<(f64, Detail)> = Vec::new();
            for &order in &required.limits.orders {
                let near = |p: f64| (p - order * speed).abs() / speed.abs() - clearance;
                let own = spectrum.modes.iter().map(|m| m.frequency()).filter(|p| *p > 0.0);
                all.extend(own.map(|p| (near(p), Detail::Mode { frequency: p, order })));
                for (cup, load) in required.cups.iter().zip(&loads).filter(|c| c.0.ring.held.is_none()) {
                    let swing = cup.ring.cup.swing_frequency(speed, load.tilt);
                    let both = [speed.abs() + swing, (speed.abs() - swing).abs()];
                    all.extend(both.map(|p| (near(p), Detail::Swing(order))));
                }
            }
            margins.extend(least(4, all.into_iter()));
        }
        if let Some(p) = self.passage {
            let (value, detail) = p.margin(speed, &required.limits);
            margins.push(margin(5, value, detail));
        }
        if let Some(highest) = required.limits.speed {
            let density = required.task.as_ref().map(|d| {
                let (m, rho) = (&d.suspension.medium, d.suspension.powder.density.quantile(0.5));
                m.density + m.volume_fraction * (rho - m.density)
            });
            let allowed = match (required.limits.rated_density, density) {
                (Some(rated), Some(density)) => derated(highest, rated, density),
                _ => highest,
            };
            let fastest = fastest_ratio(system) * speed.abs();
            margins.push(margin(6, 1.0 - fastest / allowed, Detail::Speed));
        }
        let outside = met.iter().filter_map(|s| s.validity.clone()).map(|(ratio, part)| (1.0 - ratio, part));
        if !nonlinear && states.is_empty() && states_validity(system, speed) {
            margins.push(margin(VALID, f64::NAN, Detail::WithoutBound));
        } else {
            margins.extend(least(VALID, outside));
        }
        let leans = (0..system.stations().len()).map(|k| largest(met.iter().map(|s| s.tilt[k]))).collect();
        let duration = required.task.as_ref().map_or(0.0, |d| d.time);
        let torque = met.iter().map(|s| s.torque.abs()).fold(0.0, f64::max);
        let energy = spin_energy(system, speed) + torque * speed.abs() * duration;
        let unbalance = loads.iter().fold(C64::zero(), |u, l| u + l.unbalance).abs();
        let tilt = required.task.as_ref().and_then(|d| d.vessel.separator.at(speed).tilt()).unwrap_or(f64::NAN);
        Ok(Point { speed, margins, needed: f64::NAN, tilt, unbalance, states: met.len(), energy, growth: growth.rate, leans })
    }

    /// Of the stable states that exist at a speed those that are assessed.
    fn assessed<'s>(&self, system: &System, met: Vec<&'s State>, speed: f64) -> Vec<&'s State> {
        if met.len() < 2 {
            return met;
        }
        let chosen = match self.required.policy {
            Policy::All => return met,
            Policy::Highest => {
                let margin = |s: &&&State| self.vibration(system, &[**s]).map_or(0.0, |m| m.value);
                met.iter().min_by(|a, b| margin(a).total_cmp(&margin(b)))
            }
            Policy::Reached => {
                let Some(moved) = self.passage.and_then(|p| p.reached(speed)) else { return met };
                let far = |s: &&&State| s.displacement.iter().zip(&moved).map(|(a, b)| (a / b).ln().abs()).fold(0.0, f64::max);
                met.iter().min_by(|a, b| far(a).total_cmp(&far(b)))
            }
        };
        chosen.copied().into_iter().collect()
    }

    /// Why no steady state is assessed.
    fn without_state(&self) -> Detail {
        if self.branches.is_none() { Detail::WithoutBound } else { Detail::NoState }
    }

    fn vibration(&self, system: &System, met: &[&State]) -> Option<Margin> {
        let l = &self.required.limits;
        if !l.vibration() {
            return None;
        }
        if met.is_empty() {
            return Some(margin(1, f64::NAN, self.without_state()));
        }
        // of a body with several stations the one that moves most
        let most = |name: &str, list: &[f64]| {
            let own = system.stations().iter().zip(list).filter(|(s, _)| system.slots()[s.slot].name == name).map(|x| *x.1);
            own.reduce(larger)
        };
        let mut all = Vec::new();
        for s in met {
            // a point of a body that does not tilt moves as the body does
            let point = |limit: &Limit| system.probes().iter().position(|p| limit.is_at(p));
            let of_body = |list: &[f64], which: Option<usize>, limit: &Limit| match (point(limit), which) {
                (Some(k), Some(i)) => s.points.get(k).map(|p| p[i]),
                _ => most(&limit.body, list),
            };
            let of_bodies = [
                (&l.displacement, "displacement", &s.displacement, Some(0)),
                (&l.velocity, "velocity", &s.velocity, Some(1)),
                (&l.tilt, "tilt", &s.tilt, None),
            ];
            for (limits, quantity, list, which) in of_bodies {
                for limit in limits {
                    all.extend(of_body(list, which, limit).map(|x| limited(x, quantity, limit)));
                }
            }
            for (limits, quantity, of) in [(&l.force, "force", &s.force), (&l.moment, "moment", &s.moment)] {
                for limit in limits {
                    all.extend(of.get(&limit.name).map(|x| limited(*x, quantity, limit)));
                }
            }
        }
        least(1, all.into_iter())
    }

    /// Distance of the centre of mass of every eccentric body, with the cups it carries, from the axis, over its eccentricity.
    fn self_centred(&self, system: &System, speed: f64, met: &[&State]) -> Option<Margin> {
        let c0 = self.required.limits.self_centring?;
        if met.is_empty() {
            return Some(margin(2, f64::NAN, self.without_state()));
        }
        let mut all = Vec::new();
        for (k, b) in system.stations().iter().enumerate() {
            let carried: Vec<&str> =
                self.required.cups.iter().filter(|c| c.on.body.as_deref() == Some(b.name.as_str())).map(|c| c.name.as_str()).collect();
            let Some((e, height)) = centre_of_mass(system, b, &carried, speed) else { continue };
            let size = e.abs();
            if size > 0.0 && size.is_finite() {
                let centre = |s: &State| s.forward[k] - (s.lean[k] * c(0.0, height)) + e;
                all.extend(met.iter().map(|s| (1.0 - centre(s).abs() / size / c0, Detail::CentreOfMass(b.name.clone()))));
            }
        }
        least(2, all.into_iter())
    }
}

/// Margin of a quantity with this limit.
fn limited(x: f64, quantity: &'static str, limit: &Limit) -> (f64, Detail) {
    (1.0 - x / limit.value, Detail::Limited { quantity, of: limit.name.clone() })
}

/// The growth that decides: of the stable states the one closest to growing, of unstable ones the slowest; NaN without a state.
fn worst_growth(assessed: &[&State], states: &[State]) -> Growth {
    let most = |a: Growth, b: Growth| if b.rate > a.rate { b } else { a };
    let least = |a: Growth, b: Growth| if b.rate < a.rate || a.rate.is_nan() { b } else { a };
    let unstable = states.iter().filter(|s| !s.stable).map(|s| s.growth);
    let found = assessed.iter().map(|s| s.growth).reduce(most).or_else(|| unstable.reduce(least));
    found.unwrap_or(Growth { rate: f64::NAN, beyond: f64::NAN })
}

/// Where the centre of mass of a body with what it carries lies in rotor axes, and its height, m: from the force with which they turn and their inertia.
/// `None` of a body without coordinates of its own.
fn centre_of_mass(system: &System, body: &Station, carried: &[&str], speed: f64) -> Option<(C64, f64)> {
    use crate::model::part::{At, Rows};
    let (n, m) = (system.n(), system.m());
    let (zero, z) = (vec![0.0; n], vec![0.0; m]);
    let row = |speed: f64, a: &[f64]| {
        let (mut force, mut rate, mut spin) = (vec![0.0; n], vec![0.0; m], 0.0);
        let at = At { q: &zero, v: &zero, a, z: &z, phase: 0.0, speed, spin_accel: 0.0, t: 0.0 };
        let mut rows = Rows { force: &mut force, rate: &mut rate, spin: &mut spin };
        let own = |s: &Slot| s.name == body.name || carried.contains(&s.name.as_str());
        system.residual(system.params(), &at, &mut rows, &mut Default::default(), own);
        force
    };
    let x = body.lateral.first()?;
    let tilt = body.tilt.as_ref().and_then(|t| t.first());
    let mut one = zero.clone();
    one[x] = 1.0;
    let (still, turning, inertia) = (row(0.0, &zero), row(speed, &zero), row(speed, &one));
    let lateral = |f: &[f64]| c(f[x], f[x + 1]);
    let mass = inertia[x] - turning[x];
    // of a point at the height h: x + h beta
    let height = tilt.map_or(0.0, |t| (inertia[t + 1] - turning[t + 1]) / mass);
    Some(((lateral(&still) - lateral(&turning)).scale(1.0 / (speed * speed * mass)), height))
}

/// Nodes of the sum over the speeds of a run-up.
const NODES: usize = 32;

/// Energy that a run-up of the undeflected machine takes, J: its moment of inertia about the spin axis, from the spin row, times the speed, summed over the way.
fn spin_energy(system: &System, speed: f64) -> f64 {
    use crate::model::part::{At, Rows};
    let (n, m) = (system.n(), system.m());
    let (q, z) = (vec![0.0; n], vec![0.0; m]);
    let mut ws = Default::default();
    let mut row = |speed: f64, accel: f64| {
        let (mut force, mut rate, mut spin) = (vec![0.0; n], vec![0.0; m], 0.0);
        let at = At { q: &q, v: &q, a: &q, z: &z, phase: 0.0, speed, spin_accel: accel, t: 0.0 };
        let mut rows = Rows { force: &mut force, rate: &mut rate, spin: &mut spin };
        system.residual(system.params(), &at, &mut rows, &mut ws, |_| true);
        spin
    };
    let mut work = |speed: f64| (row(speed, 1.0) - row(speed, 0.0)) * speed;
    // exact for an inertia that does not depend on the speed; that of cups which swing out changes smoothly
    gauss(NODES).into_iter().map(|(x, weight)| work(speed * x) * weight * speed).sum()
}

/// A first guess of the speed that separates: along the radius from the surface to the outermost place, an upper bound of the demand.
pub(super) fn radial_guess(task: &Task) -> Option<f64> {
    let (r1, r2) = match &task.vessel.separator {
        Separator::Cup(c) => (c.hanging.hinge + c.vessel.top, c.hanging.hinge + c.vessel.bottom),
        other => other.at(100.0).radii(),
    };
    let p = &task.suspension.powder;
    let radius = 0.5 * task.batch.from.unwrap_or_else(|| p.size.quantile(1.0 - task.recovery));
    let s = task.suspension.medium.rates(&Particle { radius, density: p.density.quantile(0.5) }).sedimentation.abs();
    let w = ((r2 / r1).ln() / (s * task.time)).sqrt();
    w.is_finite().then_some(w)
}
