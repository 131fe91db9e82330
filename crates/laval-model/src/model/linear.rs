//! The linear parts of a machine at one spin speed: blocks in time, dynamic stiffness in frequency.

use super::blocks::{Axes, Blocks, Grid};
use super::erased::{Evaluate, FrequencyDomain};
use super::part::{Domain, Physics};
use super::system::{Slot, System, scatter};
use laval_num::complex::{Complex, c};
use laval_num::refill::refill;
use laval_num::scalar::Scalar;
use laval_num::work::spend;

/// All linear parts on global coordinates. Memory states stay with their parts (`memory`); the other states of linear parts are `states`.
#[derive(Clone, Debug)]
pub struct LinearModel<S> {
    /// Blocks over `n` coordinates and `states.len()` states.
    pub blocks: Blocks<S>,
    /// Global indices of the states in the blocks.
    pub states: Vec<usize>,
    /// Memory states by part: slot, first global state, and the part's own list.
    pub memory: Vec<SlotMemory<S>>,
}

/// Memory states of one part.
#[derive(Clone, Debug)]
pub struct SlotMemory<S> {
    /// Slot of the part.
    pub slot: usize,
    /// Global index of its first memory state.
    pub first: usize,
    /// The states, with local inputs and outputs.
    pub list: Vec<super::blocks::Memory<S>>,
}

impl<S: Scalar> Default for LinearModel<S> {
    fn default() -> Self {
        LinearModel { blocks: Blocks::default(), states: Vec::new(), memory: Vec::new() }
    }
}

/// Scratch for [`System::linear`] and [`System::dynamic_stiffness`].
pub struct LinearScratch<S> {
    local: Blocks<S>,
    impedance: Vec<Complex<S>>,
}

impl<S: Scalar> Default for LinearScratch<S> {
    fn default() -> Self {
        LinearScratch { local: Blocks::default(), impedance: Vec::new() }
    }
}

/// Which parts enter a linear model through blocks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// For time integration and eigenvalue pencils: frequency-domain parts by their fitted time form.
    Time,
    /// For harmonics: frequency-domain parts enter [`System::dynamic_stiffness`] by their exact impedance.
    Frequency,
}

fn add_mapped<S: Scalar>(slot: &Slot, local: &Grid<S>, global: &mut Grid<S>) {
    for (i, rows) in slot.map.iter().enumerate() {
        for (j, cols) in slot.map.iter().enumerate() {
            let x = local[(i, j)];
            for &(gi, ci) in rows {
                for &(gj, cj) in cols {
                    global[(gi, gj)] += x.scale(ci * cj);
                }
            }
        }
    }
}

impl System {
    /// States that stand in the blocks of a linear model: those of linear parts, without memory.
    pub fn linear_states(&self, form: Form) -> Vec<usize> {
        self.slots().iter().filter(|s| in_blocks(s, form)).flat_map(|s| s.states.start..s.states.end - s.memory).collect()
    }

    /// Assembles the linear parts at a spin speed (rad/s).
    pub fn linear<S: Evaluate>(&self, params: &[S], speed: S, form: Form, out: &mut LinearModel<S>, scratch: &mut LinearScratch<S>) {
        out.states.clear();
        for s in self.slots().iter().filter(|s| in_blocks(s, form)) {
            out.states.extend(s.states.start..s.states.end - s.memory);
        }
        out.blocks.reset(self.n(), out.states.len(), speed);
        out.memory.clear();
        let mut row = 0;
        for (k, slot) in self.slots().iter().enumerate().filter(|(_, s)| in_blocks(s, form)) {
            let m = slot.states.len() - slot.memory;
            let b = &mut scratch.local;
            b.reset(slot.map.len(), m, speed);
            S::linear(&*slot.part, &params[slot.params.clone()], speed, b);
            let g = &mut out.blocks;
            for (local, global) in [
                (&b.mass, &mut g.mass),
                (&b.damping, &mut g.damping),
                (&b.gyroscopic, &mut g.gyroscopic),
                (&b.stiffness, &mut g.stiffness),
                (&b.circulatory, &mut g.circulatory),
                (&b.spin_accel_stiffness, &mut g.spin_accel_stiffness),
            ] {
                add_mapped(slot, local, global);
            }
            for (i, &w) in slot.weight.iter().enumerate() {
                for j in 0..slot.map.len() {
                    b.force[j] -= b.mass[(j, i)].scale(w);
                }
                for j in 0..m {
                    b.rate[j] += b.state_a[(j, i)].scale(w);
                }
            }
            for (local, global) in [
                (&b.force, &mut g.force),
                (&b.force_cos, &mut g.force_cos),
                (&b.force_sin, &mut g.force_sin),
                (&b.spin_accel_cos, &mut g.spin_accel_cos),
                (&b.spin_accel_sin, &mut g.spin_accel_sin),
            ] {
                scatter(&slot.map, local, global);
            }
            for i in 0..m {
                g.rate[row + i] += b.rate[i];
                g.spin_accel_rate_cos[row + i] += b.spin_accel_rate_cos[i];
                g.spin_accel_rate_sin[row + i] += b.spin_accel_rate_sin[i];
                for j in 0..m {
                    g.state[(row + i, row + j)] += b.state[(i, j)];
                }
                for (j, cols) in slot.map.iter().enumerate() {
                    for &(gj, cj) in cols {
                        g.state_q[(row + i, gj)] += b.state_q[(i, j)].scale(cj);
                        g.state_v[(row + i, gj)] += b.state_v[(i, j)].scale(cj);
                        g.state_a[(row + i, gj)] += b.state_a[(i, j)].scale(cj);
                        g.state_force[(gj, row + i)] += b.state_force[(j, i)].scale(cj);
                        g.spin_accel_state_force[(gj, row + i)] += b.spin_accel_state_force[(j, i)].scale(cj);
                    }
                }
            }
            if slot.memory > 0 {
                out.memory.push(SlotMemory { slot: k, first: slot.states.start + m, list: b.memory.clone() });
            }
            row += m;
        }
        if form == Form::Frequency {
            self.add_loads(params, speed, &mut out.blocks, &mut scratch.local);
        }
    }

    /// Adds the loads of the parts given in the frequency domain, and what their mass weighs.
    fn add_loads<S: Evaluate>(&self, params: &[S], speed: S, out: &mut Blocks<S>, local: &mut Blocks<S>) {
        for slot in self.slots().iter().filter(|s| matches!(s.physics, Physics::Frequency(_))) {
            local.reset(slot.map.len(), 0, speed);
            if let Some(part) = slot.part.frequency_domain() {
                S::load(part, &params[slot.params.clone()], speed, local);
            }
            for (i, &w) in slot.weight.iter().enumerate() {
                for j in 0..slot.map.len() {
                    local.force[j] -= local.mass[(j, i)].scale(w);
                }
            }
            for (local, global) in
                [(&local.force, &mut out.force), (&local.force_cos, &mut out.force_cos), (&local.force_sin, &mut out.force_sin)]
            {
                scatter(&slot.map, local, global);
            }
        }
    }

    /// Dynamic stiffness of the linear parts at `s` (1/s) over coordinates and the states of the blocks:
    ///
    /// ```text
    /// [ s^2 M + s (C + W G) + K + W N + memory + impedances    H       ]
    /// [ -(Aq + s Av + s^2 Aa)                                  s I - A ]
    /// ```
    ///
    /// Memory states are eliminated exactly; other states stay as unknowns, so that a resonance of the part itself (a liquid wave) is not a pole here.
    pub fn dynamic_stiffness<S: Evaluate>(
        &self,
        params: &[S],
        model: &LinearModel<S>,
        form: Form,
        s: Complex<S>,
        out: &mut Grid<Complex<S>>,
        scratch: &mut LinearScratch<S>,
    ) where
        Complex<S>: Copy,
    {
        let b = &model.blocks;
        let (n, m) = (self.n(), model.states.len());
        out.reset_complex(n + m);
        spend((10 * (n + m) * (n + m) + 100 * self.slots().len()) as u64);
        let s2 = s * s;
        for i in 0..n {
            for j in 0..n {
                let k = b.stiffness[(i, j)] + b.speed * b.circulatory[(i, j)];
                let d = b.damping[(i, j)] + b.speed * b.gyroscopic[(i, j)];
                out[(i, j)] = s2.scale(b.mass[(i, j)]) + s.scale(d) + Complex::real(k);
            }
            for j in 0..m {
                out[(i, n + j)] = Complex::real(b.state_force[(i, j)]);
            }
        }
        for i in 0..m {
            for j in 0..n {
                out[(n + i, j)] = -(Complex::real(b.state_q[(i, j)]) + s.scale(b.state_v[(i, j)]) + s2.scale(b.state_a[(i, j)]));
            }
            for j in 0..m {
                out[(n + i, n + j)] = Complex::real(-b.state[(i, j)]);
            }
            out[(n + i, n + i)] += s;
        }
        for mem in &model.memory {
            let map = &self.slots()[mem.slot].map;
            let mut add = |row: usize, col: usize, x: Complex<S>| {
                for &(gi, ci) in &map[row] {
                    for &(gj, cj) in &map[col] {
                        out[(gi, gj)] += x.scale(S::cst(ci * cj));
                    }
                }
            };
            for (k, z) in mem.list.iter().enumerate() {
                let r = s + Complex::real(z.rate);
                match z.axes {
                    Axes::Fixed => add(z.output, z.input, r.recip().scale(z.gain)),
                    Axes::RotorX | Axes::RotorY => {
                        let partner = if z.axes == Axes::RotorX { &mem.list[k + 1] } else { &mem.list[k - 1] };
                        let f = (r * r + Complex::real(b.speed * b.speed)).recip().scale(z.gain);
                        let w = if z.axes == Axes::RotorX { -b.speed } else { b.speed };
                        add(z.output, z.input, f * r);
                        add(z.output, partner.input, f.scale(w));
                    }
                }
            }
        }
        if form == Form::Frequency {
            for (slot, part) in self.in_frequency_domain() {
                let k = slot.map.len();
                refill(&mut scratch.impedance, k * k, Complex::zero());
                S::impedance(part, &params[slot.params.clone()], s, b.speed, &mut scratch.impedance);
                for (i, rows) in slot.map.iter().enumerate() {
                    for (j, cols) in slot.map.iter().enumerate() {
                        for &(gi, ci) in rows {
                            for &(gj, cj) in cols {
                                out[(gi, gj)] += scratch.impedance[i * k + j].scale(S::cst(ci * cj));
                            }
                        }
                    }
                }
            }
        }
    }
}

impl System {
    /// Where the dynamic stiffness of the parts given in the frequency domain, and of memory states, is analytic, at a spin speed; of parts that say it
    /// ([`System::undeclared`]).
    pub fn domains(&self, speed: f64) -> Vec<Domain> {
        let params = self.params();
        let one = |s: &Slot| match s.physics {
            Physics::Frequency(_) => s.part.frequency_domain()?.domain(&params[s.params.clone()], speed),
            _ => (s.memory > 0).then(Domain::passive),
        };
        self.slots().iter().filter_map(one).collect()
    }

    /// The machine with the parts that have a cheaper form for counting ([`rough`](super::capability::FrequencyDomain::rough)); `None` where no part has one.
    pub fn rough(&self) -> Option<System> {
        let mut inputs = self.inputs();
        let mut any = false;
        for input in &mut inputs {
            if let Some(rough) = input.part.frequency_domain().and_then(|f| f.rough()) {
                input.part = rough;
                any = true;
            }
        }
        any.then(|| System::assemble(self.machine.clone(), inputs).ok()).flatten()
    }

    /// The first part given in the frequency domain that does not say where it is analytic.
    pub fn undeclared(&self) -> Option<&Slot> {
        let params = self.params();
        let declared = |s: &Slot| s.part.frequency_domain().is_some_and(|f| f.domain(&params[s.params.clone()], 1.0).is_some());
        let silent = |s: &&Slot| matches!(s.physics, Physics::Frequency(_)) && !declared(s);
        self.slots().iter().find(silent)
    }

    /// The product of [`regular`](super::capability::FrequencyDomain::regular) of the parts given in the frequency domain.
    pub fn regular<S: Evaluate>(&self, params: &[S], s: Complex<S>, speed: S) -> Complex<S> {
        let all = self.in_frequency_domain();
        all.fold(Complex::one(), |product, (slot, part)| product * S::regular(part, &params[slot.params.clone()], s, speed))
    }

    fn in_frequency_domain(&self) -> impl Iterator<Item = (&Slot, &dyn FrequencyDomain)> {
        let all = self.slots().iter().filter(|s| matches!(s.physics, Physics::Frequency(_)));
        all.filter_map(|s| Some((s, s.part.frequency_domain()?)))
    }
}

fn in_blocks(slot: &Slot, form: Form) -> bool {
    match slot.physics {
        Physics::Nonlinear => false,
        Physics::Linear => true,
        Physics::Frequency(_) => form == Form::Time,
    }
}

/// The complex number `re + i im` as lifted constants.
pub fn lift<S: Scalar>(re: f64, im: f64) -> Complex<S> {
    c(S::cst(re), S::cst(im))
}
