//! Measuring of states: amplitudes, observed quantities, validity.

use super::result::Measured;
use crate::diagnostic::Diagnostic;
use crate::model::part::{At, Observed};
use crate::model::probe::Probe;
use crate::model::system::{Pair, System, Workspace};
use crate::solve::harmonic::balance::orbit::Orbit;
use crate::solve::harmonic::balance::problem::Balance;
use crate::solve::harmonic::branches::around::Peaks;
use crate::solve::harmonic::branches::measure::Measure;
use crate::solve::harmonic::branches::peak::{Peak, Sense, refine};
use crate::solve::harmonic::branches::response::{Request, Response, Traced, orbits};
use crate::solve::harmonic::branches::sizes::{CLOSER, SAMPLES, Waves, crest, vertex};
use crate::solve::symmetry::Symmetry;
use crate::study::shared::probes;
use crate::study::shared::support::larger;
use crate::study::shared::validity::Uses;
use laval_num::fourier::Roots;
use laval_num::work::Here;
use rayon::prelude::*;
use std::collections::HashMap;
use std::f64::consts::TAU;

/// Measures the states of a response.
pub(super) struct Measuring<'a> {
    pub(super) system: &'a System,
    /// By the discretisation of a branch.
    balances: Vec<Balance<'a>>,
    pub(super) bodies: Vec<(String, Pair)>,
    /// Probes that are measured, the reference points of the bodies first, and their indices among those of the machine.
    pub(super) probes: Vec<Probe>,
    pub(super) which: Vec<usize>,
    /// Slots of parts whose force is measured.
    force_slots: Vec<usize>,
    /// Observed quantities of parts are measured as well.
    observes: bool,
    /// Validity of parts, and extreme values between computed points, are left out.
    sketch: bool,
    /// By branch.
    peaks: HashMap<usize, Peaks>,
    pub(super) measured: Measured,
}

/// Instants at which a circular motion, whose sizes stay, is looked at.
const ROUND: usize = 4;

impl<'a> Measuring<'a> {
    pub(super) fn new(system: &'a System, response: &Response, request: &Request) -> Result<Self, Diagnostic> {
        let mut balances: Vec<Balance> = Vec::new();
        for d in response.branches.iter().map(|b| b.discretisation.whole()) {
            if !balances.iter().any(|b| b.discretisation() == d) {
                balances.push(Balance::new(system, d, request.speeds, None)?);
            }
        }
        let bodies = system.stations().iter().map(|s| (s.name.clone(), s.lateral.clone())).collect();
        let (probes, which) = (probes::all(system), probes::ordered(system));
        Ok(Measuring {
            system,
            balances,
            bodies,
            probes,
            which,
            force_slots: Measure::forces(system),
            observes: true,
            sketch: false,
            peaks: HashMap::new(),
            measured: Measured::default(),
        })
    }

    /// Of displacements, tilts and validity alone.
    pub(super) fn of_sizes(system: &'a System, response: &Response, request: &Request) -> Result<Self, Diagnostic> {
        Ok(Measuring { force_slots: Vec::new(), observes: false, ..Measuring::new(system, response, request)? })
    }

    /// Of displacements and tilts alone, at computed points.
    pub(super) fn sketch(system: &'a System, response: &Response, request: &Request) -> Result<Self, Diagnostic> {
        Ok(Measuring { sketch: true, ..Measuring::of_sizes(system, response, request)? })
    }

    /// Displacements and tilts; the tilts in the columns that parts show them in.
    pub(super) fn sizes(&mut self, response: &Response, request: &Request) -> Measured {
        self.measure(response);
        (self.measured.largest, self.measured.rising) = self.peaks(response, request, false);
        let tilts: Vec<usize> = (0..self.probes.len()).filter(|&k| self.probes[k].is_tilt()).collect();
        self.measured.observed =
            tilts.iter().map(|&k| (format!("{} tilt", self.probes[k].name), self.probes[k].unit().to_string())).collect();
        let of_state = |sizes: &Vec<f64>| tilts.iter().map(|&k| sizes[k]).collect();
        self.measured.observations = self.measured.sizes.iter().map(|b| b.iter().map(of_state).collect()).collect();
        std::mem::take(&mut self.measured)
    }

    /// All that is measured of a response.
    pub(super) fn all(&mut self, response: &Response, request: &Request) -> Measured {
        self.measure(response);
        (self.measured.largest, self.measured.rising) = self.peaks(response, request, false);
        self.measured.forces = self.extreme_forces(response, request);
        (self.measured.tilts, self.measured.tilt_rising) = self.peaks(response, request, true);
        self.measured.centring = self.centring(response);
        self.measured.tuned = self.tuning(response, request);
        std::mem::take(&mut self.measured)
    }

    /// A largest or least value next to a point of a branch.
    pub(super) fn refined(
        &mut self,
        response: &Response,
        (b, i): (usize, usize),
        measure: Measure,
        sense: Sense,
        request: &Request,
    ) -> Option<Peak> {
        if self.sketch {
            return None;
        }
        let branch = &response.branches[b];
        let at = self.balance_of(branch);
        let balance = &mut self.balances[at];
        self.peaks.entry(b).or_default().beside(balance, (branch, i), measure, sense, request.speeds)
    }

    /// The same by corrections of its own, a narrow bracket about the value.
    pub(super) fn confirmed(
        &mut self,
        response: &Response,
        (b, i): (usize, usize),
        measure: Measure,
        sense: Sense,
        request: &Request,
    ) -> Option<Peak> {
        let branch = &response.branches[b];
        refine(self.balance_mut(branch), branch, i, measure, sense, request.speeds)
    }

    /// The whole motion of a state.
    pub(super) fn orbit(&mut self, branch: &Traced, i: usize) -> Option<Orbit> {
        let (at, state) = (self.balance_of(branch), branch.points.get(i)?);
        Orbit::of(&mut self.balances[at], &state.x, state.speed).ok()
    }

    /// Index of the balance whose unknowns a branch has.
    fn balance_of(&self, branch: &Traced) -> usize {
        let d = branch.discretisation.whole();
        self.balances.iter().position(|b| b.discretisation() == d).unwrap_or(0)
    }

    /// The balance whose unknowns a branch has.
    pub(super) fn balance_mut(&mut self, branch: &Traced) -> &mut Balance<'a> {
        let at = self.balance_of(branch);
        &mut self.balances[at]
    }

    /// Sizes, forces and validity at every point of every branch, and at the folds.
    pub(super) fn measure(&mut self, response: &Response) {
        for branch in &response.branches {
            let balance = self.balance_of(branch);
            let balanced = &mut self.balances[balance];
            let orbits = orbits(balanced, &branch.points);
            let at_folds: Vec<Orbit> = branch.folds.iter().map(|f| Orbit::of(balanced, &f.x, f.speed).unwrap_or_default()).collect();
            if self.observes && self.measured.observed.is_empty() {
                self.measured.observed = orbits.iter().find(|o| !o.orders.is_empty()).map_or_else(Vec::new, |o| self.observed_of(o));
            }
            let here = Here::now();
            let seeing = self.seeing(branch, &orbits);
            let one = |orbit: &Orbit| {
                let _counted = here.enter();
                let own = seeing.amplitudes_of(orbit);
                let sizes = seeing.sizes_of(orbit, &own);
                let seen = if self.sketch { Default::default() } else { seeing.observe(orbit) };
                (sizes, own, seeing.forces_of(orbit), seen)
            };
            let all: Vec<_> = orbits.par_iter().map(one).collect();
            let (mut amplitudes, mut observations, mut validity, mut forces) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
            let mut sizes = Vec::new();
            for (size, own, force, (seen, valid)) in all {
                sizes.push(size);
                amplitudes.push(own);
                forces.push(force);
                observations.push(seen);
                validity.push(valid);
            }
            let folds = at_folds.iter().map(|orbit| seeing.sizes_of(orbit, &seeing.amplitudes_of(orbit))).collect();
            self.measured.at_folds.push(folds);
            self.measured.first_forces.push(forces);
            self.measured.sizes.push(sizes);
            self.measured.amplitudes.push(amplitudes);
            self.measured.observations.push(observations);
            self.measured.validity.push(validity);
        }
    }

    /// The machine without the equations of its motion, which threads do not share.
    fn seeing(&self, branch: &Traced, orbits: &[Orbit]) -> Seeing<'_> {
        let (turns, symmetry) = (branch.turns(), branch.discretisation.whole().symmetry);
        // sizes repeat with the part of the period that the symmetry repeats
        let parts = symmetry.order().max(1);
        let instants = if symmetry == Symmetry::Circular { ROUND } else { (SAMPLES * turns).div_ceil(parts) };
        let orders = orbits.iter().map(|o| o.orders.as_slice()).max_by_key(|o| o.len()).unwrap_or_default();
        Seeing {
            system: self.system,
            bodies: &self.bodies,
            which: &self.which,
            force_slots: &self.force_slots,
            observed: self.measured.observed.len(),
            turns,
            symmetry,
            waves: Waves::new(orders, turns, symmetry),
            parts,
            instants: Roots::new(instants * parts),
            force_samples: Measure::samples(orders.last().copied().unwrap_or(1), turns, symmetry),
        }
    }

    /// Names and units of what parts show.
    fn observed_of(&self, orbit: &Orbit) -> Vec<(String, String)> {
        let (n, m) = (self.system.n(), self.system.m());
        let (mut q, mut v, mut a, mut z) = (vec![0.0; n], vec![0.0; n], vec![0.0; n], vec![0.0; m]);
        orbit.at(0.0, &mut q, &mut v, &mut a, &mut z);
        let at = At { q: &q, v: &v, a: &a, z: &z, phase: 0.0, speed: orbit.speed, spin_accel: 0.0, t: 0.0 };
        let seen = self.system.observe(&at, &mut Workspace::default());
        // displacements of bodies have columns of their own
        let shown = seen.iter().filter(|(_, o)| o.name != Observed::DISPLACEMENT);
        shown.map(|(slot, o)| (format!("{} {}", self.system.slots()[*slot].name, o.name), o.unit.to_string())).collect()
    }
}

/// Sizes of the motions of one branch.
struct Seeing<'m> {
    system: &'m System,
    bodies: &'m [(String, Pair)],
    which: &'m [usize],
    force_slots: &'m [usize],
    /// Quantities that parts show.
    observed: usize,
    /// Period in turns.
    turns: usize,
    symmetry: Symmetry,
    waves: Waves,
    /// Parts of the period that repeat, and the instants in all of them.
    parts: usize,
    instants: Roots,
    /// Of the samples from which a force at the spin frequency is found.
    force_samples: Roots,
}

impl Seeing<'_> {
    /// Largest value of every probe; that of a reference point is known already.
    fn sizes_of(&self, orbit: &Orbit, own: &[[f64; 8]]) -> Vec<f64> {
        let (bodies, others) = self.which.split_at(own.len().min(self.which.len()));
        own.iter().take(bodies.len()).map(|a| a[1]).chain(probes::sizes(self.system, others, orbit, self.turns)).collect()
    }

    /// Of every part whose force is measured, its force at the spin frequency.
    fn forces_of(&self, orbit: &Orbit) -> Vec<[f64; 3]> {
        let one = |&slot: &usize| {
            if orbit.orders.is_empty() {
                return [f64::NAN; 3];
            }
            let [x, y] = Measure::Force(slot).first_order(self.system, orbit, self.turns, (self.symmetry, &self.force_samples));
            let (forward, backward) = ((x + y.mul_i()).scale(0.5), (x - y.mul_i()).scale(0.5));
            [forward.abs() + backward.abs(), x.abs(), y.abs()]
        };
        self.force_slots.iter().map(one).collect()
    }

    fn amplitudes_of(&self, orbit: &Orbit) -> Vec<[f64; 8]> {
        self.bodies.iter().map(|(_, pair)| self.waves.sizes(orbit, pair)).collect()
    }

    fn observe(&self, orbit: &Orbit) -> (Vec<f64>, Uses) {
        let mut uses = Uses::default();
        if orbit.orders.is_empty() {
            return (vec![f64::NAN; self.observed], uses);
        }
        let (n, m) = (self.system.n(), self.system.m());
        let (mut q, mut v, mut a, mut z) = (vec![0.0; n], vec![0.0; n], vec![0.0; n], vec![0.0; m]);
        let mut ws = Workspace::default();
        let (divisor, parts, samples) = (self.turns as f64, self.parts, self.instants.count() / self.parts);
        // by quantity
        let mut series: Vec<Vec<f64>> = vec![Vec::with_capacity(samples); self.observed];
        let system = self.system;
        let instant = |tau: f64| (divisor * tau, tau / orbit.frequency);
        let h = TAU / (samples * parts) as f64;
        // part and place among what it shows, of every quantity
        let mut owners: Vec<(usize, usize)> = Vec::new();
        for j in 0..samples {
            let tau = h * j as f64;
            orbit.at_sample(&self.instants, j, [&mut q, &mut v, &mut a, &mut z]);
            let (phase, t) = instant(tau);
            let at = At { q: &q, v: &v, a: &a, z: &z, phase, speed: orbit.speed, spin_accel: 0.0, t };
            if parts > 1 || j % 4 == 0 {
                uses.see(system, &at, &mut ws);
            }
            if self.observed == 0 {
                continue;
            }
            let mut seen = system.observe(&at, &mut ws);
            if owners.is_empty() {
                let mut count = 0;
                for k in 0..seen.len() {
                    count = if k > 0 && seen[k].0 == seen[k - 1].0 { count + 1 } else { 0 };
                    owners.extend((seen[k].1.name != Observed::DISPLACEMENT).then_some((seen[k].0, count)));
                }
            }
            seen.retain(|(_, o)| o.name != Observed::DISPLACEMENT);
            series.iter_mut().zip(&seen).for_each(|(s, (_, o))| s.push(o.value.abs()));
        }
        let mut largest = vec![f64::NAN; self.observed];
        for (k, l) in largest.iter_mut().enumerate() {
            let Some((top, beside)) = crest(&series[k]) else { continue };
            *l = series[k][top];
            let Some(&(part, place)) = owners.get(k).filter(|_| *l > 0.0) else { continue };
            let (slot, tau) = (&system.slots()[part], h * (top as f64 + beside));
            let own = slot.coordinates();
            let mut local = [0; 3].map(|_| vec![0.0; own.len()]);
            // its part alone: the whole machine for each quantity would take the square of its size
            let mut near = |shift: f64| -> f64 {
                let tau = tau + shift * h;
                let [x, rate, second] = &mut local;
                orbit.at_some(&own, slot.states.clone(), tau, [x, rate, second, &mut z[slot.states.clone()]]);
                for (j, &i) in own.iter().enumerate() {
                    (q[i], v[i], a[i]) = (x[j], rate[j], second[j]);
                }
                let (phase, t) = instant(tau);
                let at = At { q: &q, v: &v, a: &a, z: &z, phase, speed: orbit.speed, spin_accel: 0.0, t };
                system.observe_part(part, &at, &mut ws).get(place).map_or(f64::NAN, |o| o.value.abs())
            };
            *l = larger(*l, vertex([near(-CLOSER), near(0.0), near(CLOSER)]).1);
        }
        (largest, uses)
    }
}
