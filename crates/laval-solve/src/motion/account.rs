//! Energy and powers of a machine at one moment.
//!
//! ```text
//! drive = W T,   weight = -g' dE/dv = -(v' M g + W (T(a + g) - T(a)))     of a part whose mass is constant and whose torque is linear in accelerations
//! ```
//!
//! Symbols: W spin speed, rad/s; T residual of the spin row, N m; E stored energy, J; g acceleration that stands for the weight, by coordinate; M mass matrix.

use crate::model::blocks::Blocks;
use crate::model::erased::{D1, Evaluate};
use crate::model::part::{At, Rows};
use crate::model::system::{Slot, System, Workspace};
use crate::reduced_machine::is_plain;
use laval_num::ode::Failure;
use laval_num::refill::refill;

/// Powers at one moment, W.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Powers {
    /// Turned into heat.
    pub dissipated: f64,
    /// Brought in by the parts' own sources.
    pub supplied: f64,
    /// Brought in by the drive: torque times speed (0 with a free spin).
    pub drive: f64,
    /// Done by the weight.
    pub weight: f64,
}

/// Scratch of the evaluations.
#[derive(Default)]
pub(super) struct Power {
    force: Vec<f64>,
    rate: Vec<f64>,
    plain: Workspace<f64>,
    weight: Option<Weight>,
}

/// What the work of the weight is computed from.
struct Weight {
    /// M g of the parts of constant mass, over the coordinates of the machine.
    constant: Vec<f64>,
    /// These parts, and the others that have weight.
    turning: Vec<usize>,
    others: Vec<usize>,
    still: Vec<f64>,
    dual: Workspace<D1>,
    params: Vec<D1>,
    lifted: [Vec<D1>; 4],
    falling: Vec<D1>,
}

impl Power {
    pub fn new(system: &System) -> Self {
        let weighs = system.slots().iter().any(|s| s.weight.iter().any(|&g| g != 0.0));
        Power { weight: weighs.then(|| Weight::new(system)), ..Power::default() }
    }

    /// Stored energy, J.
    ///
    /// # Errors
    /// The name of a part that keeps no account.
    pub fn stored(&mut self, system: &System, at: &At<f64>) -> Result<f64, String> {
        Ok(system.energy(system.params(), at, &mut self.plain)?.stored)
    }

    /// All powers; those of the drive where the spin is not free.
    ///
    /// # Errors
    /// A part that keeps no account.
    pub fn powers(&mut self, system: &System, at: &At<f64>, free: bool) -> Result<Powers, Failure> {
        let e = system
            .energy(system.params(), at, &mut self.plain)
            .map_err(|part| Failure::from(format!("\"{part}\" keeps no account of its energy")))?;
        let drive = if free { 0.0 } else { self.torque(system, at) * at.speed };
        let weight = self.weight.as_mut().map_or(0.0, |w| w.power(system, at, &mut self.plain));
        Ok(Powers { dissipated: e.dissipated, supplied: e.supplied, drive, weight })
    }

    /// Residual of the spin row, N m.
    pub fn torque(&mut self, system: &System, at: &At<f64>) -> f64 {
        for (x, len) in [(&mut self.force, system.n()), (&mut self.rate, system.m())] {
            refill(x, len, 0.0);
        }
        let mut spin = 0.0;
        let mut rows = Rows { force: &mut self.force, rate: &mut self.rate, spin: &mut spin };
        system.torque(at, &mut self.plain, &mut rows)
    }
}

impl Weight {
    fn new(system: &System) -> Self {
        let mut out = Weight {
            constant: vec![0.0; system.n()],
            turning: Vec::new(),
            others: Vec::new(),
            still: system.slots().iter().map(|s| s.map.len()).max().map_or_else(Vec::new, |n| vec![0.0; n]),
            dual: Workspace::default(),
            params: system.params().iter().map(|&x| D1::lift(x)).collect(),
            lifted: Default::default(),
            falling: Vec::new(),
        };
        let mut blocks = Blocks::default();
        for (k, slot) in system.slots().iter().enumerate().filter(|(_, s)| s.weight.iter().any(|&g| g != 0.0)) {
            if system.projection().is_some() || !is_plain(system, slot) {
                out.others.push(k);
                continue;
            }
            out.turning.push(k);
            blocks.reset_band(slot.map.len(), 0, slot.reach, 0.0);
            f64::linear(&*slot.part, &system.params()[slot.params.clone()], 0.0, &mut blocks);
            for (i, row) in slot.map.iter().enumerate() {
                let force: f64 = blocks.mass.columns(i).map(|j| blocks.mass[(i, j)] * slot.weight[j]).sum();
                row.iter().for_each(|&(g, c)| out.constant[g] += c * force);
            }
        }
        out
    }

    /// Power of the weight, W.
    fn power(&mut self, system: &System, at: &At<f64>, plain: &mut Workspace<f64>) -> f64 {
        let constant: f64 = self.constant.iter().zip(at.v).map(|(f, v)| f * v).sum();
        let turning: f64 = self.turning.iter().map(|&k| torque_of_weight(system, &system.slots()[k], at, &self.still, plain)).sum();
        -(constant + at.speed * turning) - self.of_others(system, at)
    }

    /// By the derivative of the stored energy, part by part, each with what the weight is in its own coordinates.
    fn of_others(&mut self, system: &System, at: &At<f64>) -> f64 {
        if self.others.is_empty() {
            return 0.0;
        }
        for (lifted, x) in self.lifted.iter_mut().zip([at.q, at.v, at.a, at.z]) {
            lifted.clear();
            lifted.extend(x.iter().map(|&x| D1::lift(x)));
        }
        let [q, v, a, z] = &self.lifted;
        let lift = D1::lift;
        let at = At { q, v, a, z, phase: lift(at.phase), speed: lift(at.speed), spin_accel: lift(at.spin_accel), t: lift(at.t) };
        let Weight { others, dual, params, falling, .. } = self;
        let work = others.iter().map(|&k| {
            let slot = &system.slots()[k];
            let energy = system.with_local(slot, &at, dual, |l| {
                falling.clear();
                falling.extend_from_slice(l.v);
                falling.iter_mut().zip(&slot.weight).for_each(|(v, w)| v.eps[0] = *w);
                D1::energy(&*slot.part, &params[slot.params.clone()], &At { v: &*falling, ..*l })
            });
            energy.map_or(f64::NAN, |e| e.stored.eps[0])
        });
        work.sum()
    }
}

/// What the weight of a part adds to the spin row, N m.
fn torque_of_weight(system: &System, slot: &Slot, at: &At<f64>, still: &[f64], plain: &mut Workspace<f64>) -> f64 {
    let p = &system.params()[slot.params.clone()];
    let torque = system.with_local(slot, at, plain, |l| {
        let still = &still[..l.a.len()];
        slot.part.spin_row_f64(p, &At { a: &slot.weight, ..*l }) - slot.part.spin_row_f64(p, &At { a: still, ..*l })
    });
    slot.torque(system.params(), torque)
}
