//! The linear parts of a machine at one spin speed: one sparse model in time, dynamic stiffness in frequency.

pub use super::assembly::Form;
use super::assembly::{Assembly, Places, Stamp};
use super::blocks::{Axes, Blocks, Grid};
use super::erased::{Evaluate, FrequencyDomain};
use super::part::{At, Domain, Physics};
use super::slot::{Ratio, Slot, scatter};
use super::system::System;
use laval_num::complex::{Complex, c};
use laval_num::factor::{Pattern, Plan, Selection};
use laval_num::refill::refill;
use laval_num::scalar::Scalar;
use laval_num::work::spend;
use std::sync::Arc;

/// All linear parts over the coordinates and the states of the blocks, as values on one pattern of entries. Memory states stay with their parts.
///
/// ```text
/// rows of coordinates:  M a + (C + W G) v + (K + W N + W' K') q + (H + W' H') z = f0 + fc cos(phase) + fs sin(phase) + W' (g0 + gc cos(phase) + gs sin(phase))
/// rows of states:       z' = A z + Aq q + Av v + Aa a + z0 + W' (hc cos(phase) + hs sin(phase))
/// ```
#[derive(Clone, Debug)]
pub struct LinearModel<S> {
    assembly: Arc<Assembly>,
    /// Number of coordinates.
    n: usize,
    /// Spin speed W of the last assembly, rad/s.
    pub speed: S,
    /// Memory states by part: slot, first global state, and the part's own list.
    pub memory: Vec<SlotMemory<S>>,
    /// M; Aa in the rows of states.
    mass: Vec<S>,
    /// C; Av in the rows of states.
    damping: Vec<S>,
    gyroscopic: Vec<S>,
    /// K and, in the columns of states, H; Aq and A in the rows of states.
    stiffness: Vec<S>,
    circulatory: Vec<S>,
    /// K' and, in the columns of states, H'.
    spin_accel_stiffness: Vec<S>,
    /// Constant and turning loads.
    pub loads: Loads<S>,
}

/// Right sides of a linear model.
#[derive(Clone, Debug)]
pub struct Loads<S> {
    /// f0: constant force, N.
    pub force: Vec<S>,
    /// fc: force on cos(phase), N.
    pub force_cos: Vec<S>,
    /// fs: force on sin(phase), N.
    pub force_sin: Vec<S>,
    /// g0: force per spin acceleration.
    pub spin_accel_force: Vec<S>,
    /// gc: force per spin acceleration on cos(phase).
    pub spin_accel_cos: Vec<S>,
    /// gs: force per spin acceleration on sin(phase).
    pub spin_accel_sin: Vec<S>,
    /// z0: constant rate.
    pub rate: Vec<S>,
    /// hc: rate per spin acceleration on cos(phase).
    pub spin_accel_rate_cos: Vec<S>,
    /// hs: rate per spin acceleration on sin(phase).
    pub spin_accel_rate_sin: Vec<S>,
    /// Loads that turn with other spins.
    pub others: Vec<Turning<S>>,
}

/// Loads that turn with another spin than the machine's, at `ratio` times its angle. Rates are per acceleration of the machine's spin.
#[derive(Clone, Debug)]
pub struct Turning<S> {
    /// The speed of that spin over the machine's.
    pub spin: Ratio,
    /// Its value.
    pub ratio: S,
    /// Forces on cos and sin of the angle of that spin, N.
    pub force: [Vec<S>; 2],
    /// Forces per spin acceleration on them.
    pub spin_accel: [Vec<S>; 2],
    /// Rates of states per spin acceleration on them.
    pub spin_accel_rate: [Vec<S>; 2],
}

impl<S: Scalar> Loads<S> {
    /// Those of another spin, created where there are none yet.
    fn of_spin(&mut self, spin: Ratio, ratio: S) -> &mut Turning<S> {
        let place = self.others.iter().position(|o| o.spin == spin).unwrap_or_else(|| {
            let (n, m) = (self.force.len(), self.rate.len());
            let two = |len: usize| [vec![S::zero(); len], vec![S::zero(); len]];
            self.others.push(Turning { spin, ratio, force: two(n), spin_accel: two(n), spin_accel_rate: two(m) });
            self.others.len() - 1
        });
        &mut self.others[place]
    }
    fn empty() -> Self {
        let v = Vec::new;
        Loads {
            force: v(),
            force_cos: v(),
            force_sin: v(),
            spin_accel_force: v(),
            spin_accel_cos: v(),
            spin_accel_sin: v(),
            rate: v(),
            spin_accel_rate_cos: v(),
            spin_accel_rate_sin: v(),
            others: Vec::new(),
        }
    }
    fn reset(&mut self, n: usize, m: usize) {
        for f in [
            &mut self.force,
            &mut self.force_cos,
            &mut self.force_sin,
            &mut self.spin_accel_force,
            &mut self.spin_accel_cos,
            &mut self.spin_accel_sin,
        ] {
            refill(f, n, S::zero());
        }
        for f in [&mut self.rate, &mut self.spin_accel_rate_cos, &mut self.spin_accel_rate_sin] {
            refill(f, m, S::zero());
        }
        self.others.clear();
    }
}

/// Memory states of one part.
#[derive(Clone, Debug)]
pub struct SlotMemory<S> {
    /// Slot of the part.
    pub slot: usize,
    /// Speed of its spin, rad/s.
    pub speed: S,
    /// Global index of its first memory state.
    pub first: usize,
    /// The states, with local inputs and outputs.
    pub list: Vec<super::blocks::Memory<S>>,
}

impl<S: Scalar> Default for LinearModel<S> {
    fn default() -> Self {
        LinearModel {
            assembly: Arc::default(),
            n: 0,
            speed: S::zero(),
            memory: Vec::new(),
            mass: Vec::new(),
            damping: Vec::new(),
            gyroscopic: Vec::new(),
            stiffness: Vec::new(),
            circulatory: Vec::new(),
            spin_accel_stiffness: Vec::new(),
            loads: Loads::empty(),
        }
    }
}

impl<S: Scalar> LinearModel<S> {
    /// Zeros, or what is kept of some parts, whose loads that turn are those at 1 rad/s.
    pub(super) fn reset(&mut self, assembly: &Arc<Assembly>, n: usize, speed: S, kept: Option<&LinearModel<f64>>) {
        self.assembly = assembly.clone();
        (self.n, self.speed) = (n, speed);
        self.memory.clear();
        self.loads.reset(n, assembly.states.len());
        let own = [
            &mut self.mass,
            &mut self.damping,
            &mut self.gyroscopic,
            &mut self.stiffness,
            &mut self.circulatory,
            &mut self.spin_accel_stiffness,
        ];
        let Some(k) = kept else {
            return own.into_iter().for_each(|values| refill(values, assembly.pattern.entries(), S::zero()));
        };
        let known = [&k.mass, &k.damping, &k.gyroscopic, &k.stiffness, &k.circulatory, &k.spin_accel_stiffness];
        for (values, known) in own.into_iter().zip(known) {
            values.clear();
            values.extend(known.iter().map(|&x| S::cst(x)));
        }
        let (loads, known, square) = (&mut self.loads, &k.loads, speed * speed);
        for (values, known, factor) in [
            (&mut loads.force, &known.force, S::one()),
            (&mut loads.force_cos, &known.force_cos, square),
            (&mut loads.force_sin, &known.force_sin, square),
            (&mut loads.spin_accel_force, &known.spin_accel_force, S::one()),
            (&mut loads.spin_accel_cos, &known.spin_accel_cos, S::one()),
            (&mut loads.spin_accel_sin, &known.spin_accel_sin, S::one()),
        ] {
            values.iter_mut().zip(known).for_each(|(x, &known)| *x = factor.scale(known));
        }
    }

    /// Sparsity over the unknowns: coordinates, [`states`](Self::states), then the states of parts that are not linear, whose rows are empty here.
    pub fn pattern(&self) -> &Arc<Pattern> {
        &self.assembly.pattern
    }
    /// How matrices of that pattern are factored.
    pub fn plan(&self) -> &Plan {
        self.assembly.plan()
    }
    /// Some of the unknowns (in rising order) by themselves.
    pub fn selection(&self, members: &[usize]) -> Arc<Selection> {
        self.assembly.selection(members)
    }
    /// Number of the unknowns of linear parts: coordinates and [`states`](Self::states).
    pub fn held(&self) -> usize {
        self.n + self.assembly.states.len()
    }
    /// Global indices of the states of the blocks.
    pub fn states(&self) -> &[usize] {
        &self.assembly.states
    }
    fn get(&self, values: &[S], i: usize, j: usize) -> S {
        self.assembly.pattern.index(i, j).map_or(S::zero(), |e| values[e])
    }
    /// Entry of M over the coordinates; of Aa in the row of a state.
    pub fn mass(&self, i: usize, j: usize) -> S {
        self.get(&self.mass, i, j)
    }
    /// Entry of C + W G over the coordinates; of Av in the row of a state.
    pub fn damping(&self, i: usize, j: usize) -> S {
        self.get(&self.damping, i, j) + self.speed * self.get(&self.gyroscopic, i, j)
    }
    /// Entry of K + W N over the coordinates, of H in the column of a state; of Aq or A in the row of a state.
    pub fn stiffness(&self, i: usize, j: usize) -> S {
        self.get(&self.stiffness, i, j) + self.speed * self.get(&self.circulatory, i, j)
    }
    /// Entry of K alone, without circulatory terms.
    pub fn stiffness_alone(&self, i: usize, j: usize) -> S {
        self.get(&self.stiffness, i, j)
    }
    /// `A0, A1, A2` of the dynamic stiffness `A0 + s A1 + s^2 A2` of what the blocks hold: everything but memory and impedances.
    pub fn polynomial(&self) -> [Vec<S>; 3] {
        let (pattern, held) = (self.pattern(), self.held());
        if pattern.n() == self.n {
            let with_speed = |fixed: &[S], per_speed: &[S]| fixed.iter().zip(per_speed).map(|(&x, &y)| x + self.speed * y).collect();
            return [with_speed(&self.stiffness, &self.circulatory), with_speed(&self.damping, &self.gyroscopic), self.mass.clone()];
        }
        let mut out = [(); 3].map(|()| vec![S::zero(); pattern.entries()]);
        for i in 0..held {
            for (e, j) in pattern.row(i).take_while(|x| x.1 < held) {
                out.iter_mut().zip(self.term(e, i, j)).for_each(|(all, x)| all[e] = x);
            }
        }
        out
    }
    /// One entry of [`polynomial`](Self::polynomial).
    #[inline]
    fn term(&self, e: usize, i: usize, j: usize) -> [S; 3] {
        let (k, d) = (self.stiffness[e] + self.speed * self.circulatory[e], self.damping[e] + self.speed * self.gyroscopic[e]);
        match i < self.n {
            true if j < self.n => [k, d, self.mass[e]],
            true => [self.stiffness[e], S::zero(), S::zero()],
            false => [-self.stiffness[e], if i == j { S::one() } else { -self.damping[e] }, -self.mass[e]],
        }
    }
    /// One entry of the pattern beside the mass matrix, in the rows of coordinates and of states: factors of places, of places times speed, of
    /// velocities, of velocities times speed and of places times spin acceleration.
    pub(super) fn entry(&self, e: usize) -> [S; 5] {
        [self.stiffness[e], self.circulatory[e], self.damping[e], self.gyroscopic[e], self.spin_accel_stiffness[e]]
    }
    /// Adds what places are multiplied by while the spin accelerates to `A0` of the polynomial.
    pub fn add_spin_accel(&self, spin_accel: S, a0: &mut [S]) {
        if !spin_accel.is_nothing() {
            a0.iter_mut().zip(&self.spin_accel_stiffness).for_each(|(a, &k)| *a += spin_accel * k);
        }
    }
    /// The mass matrix alone, entry by entry of the pattern.
    pub fn mass_values(&self) -> &[S] {
        &self.mass
    }

    /// The force rows and the rates of the [`states`](Self::states) at a point whose `z` holds these states alone, added to `force` and `rate`.
    pub fn residual(&self, at: &At<S>, force: &mut [S], rate: &mut [S]) {
        let (pattern, loads, held) = (&self.assembly.pattern, &self.loads, self.held());
        let (sin, cos) = at.phase.sin_cos();
        for i in 0..self.n {
            let mut r = S::zero();
            for (e, j) in pattern.row(i).take_while(|x| x.1 < held) {
                if j < self.n {
                    let damping = self.damping[e] + self.speed * self.gyroscopic[e];
                    let stiffness = self.stiffness[e] + self.speed * self.circulatory[e] + at.spin_accel * self.spin_accel_stiffness[e];
                    r += self.mass[e] * at.a[j] + damping * at.v[j] + stiffness * at.q[j];
                } else {
                    r += (self.stiffness[e] + at.spin_accel * self.spin_accel_stiffness[e]) * at.z[j - self.n];
                }
            }
            r -= loads.force[i] + loads.force_cos[i] * cos + loads.force_sin[i] * sin;
            r -= at.spin_accel * (loads.spin_accel_force[i] + loads.spin_accel_cos[i] * cos + loads.spin_accel_sin[i] * sin);
            force[i] += r;
        }
        for o in &loads.others {
            let (sin, cos) = (o.ratio * at.phase).sin_cos();
            for (i, force) in force.iter_mut().enumerate() {
                *force -= o.force[0][i] * cos + o.force[1][i] * sin;
                *force -= at.spin_accel * (o.spin_accel[0][i] * cos + o.spin_accel[1][i] * sin);
            }
            for (i, rate) in rate.iter_mut().enumerate() {
                *rate += at.spin_accel * (o.spin_accel_rate[0][i] * cos + o.spin_accel_rate[1][i] * sin);
            }
        }
        for (i, rate) in rate.iter_mut().enumerate() {
            let (mut own, mut q, mut v, mut a) = (S::zero(), S::zero(), S::zero(), S::zero());
            for (e, j) in pattern.row(self.n + i).take_while(|x| x.1 < held) {
                if j < self.n {
                    q += self.stiffness[e] * at.q[j];
                    v += self.damping[e] * at.v[j];
                    a += self.mass[e] * at.a[j];
                } else {
                    own += self.stiffness[e] * at.z[j - self.n];
                }
            }
            *rate +=
                own + q + v + a + loads.rate[i] + at.spin_accel * (loads.spin_accel_rate_cos[i] * cos + loads.spin_accel_rate_sin[i] * sin);
        }
    }

    fn add(&mut self, stamp: &Stamp, b: &Blocks<S>) {
        add_at(&stamp.coordinates, &b.mass, &mut self.mass);
        add_at(&stamp.coordinates, &b.damping, &mut self.damping);
        add_at(&stamp.coordinates, &b.gyroscopic, &mut self.gyroscopic);
        add_at(&stamp.coordinates, &b.stiffness, &mut self.stiffness);
        add_at(&stamp.coordinates, &b.circulatory, &mut self.circulatory);
        add_at(&stamp.coordinates, &b.spin_accel_stiffness, &mut self.spin_accel_stiffness);
        if stamp.states > 0 {
            add_at(&stamp.state_columns, &b.state_force, &mut self.stiffness);
            add_at(&stamp.state_columns, &b.spin_accel_state_force, &mut self.spin_accel_stiffness);
            add_at(&stamp.state_rows, &b.state_a, &mut self.mass);
            add_at(&stamp.state_rows, &b.state_v, &mut self.damping);
            add_at(&stamp.state_rows, &b.state_q, &mut self.stiffness);
            add_at(&stamp.state_block, &b.state, &mut self.stiffness);
        }
    }
}

fn add_at<S: Scalar>(places: &Places, local: &Grid<S>, global: &mut [S]) {
    // most of what a part may hold is zero
    if local.is_nothing() {
        return;
    }
    let mut first = 0;
    for i in 0..local.rows() {
        let row = local.row(i);
        for (k, &x) in row.iter().enumerate().filter(|(_, x)| !x.is_nothing()) {
            for &(e, factor) in places.list(first + k) {
                global[e] += if factor == 1.0 { x } else { x.scale(factor) };
            }
        }
        first += row.len();
    }
}

/// Adds the loads of a part that turn, its states beginning at row `first`, to those of its spin.
fn add_turning<S: Scalar>(slot: &Slot, first: usize, b: &Blocks<S>, params: &[S], loads: &mut Loads<S>) {
    let turning = |x: &Vec<S>| x.iter().any(|x| !x.is_nothing());
    let [force, accel, rate] = match slot.ratio {
        None => [
            [&mut loads.force_cos, &mut loads.force_sin],
            [&mut loads.spin_accel_cos, &mut loads.spin_accel_sin],
            [&mut loads.spin_accel_rate_cos, &mut loads.spin_accel_rate_sin],
        ],
        Some(spin) => {
            let own = [&b.force_cos, &b.force_sin, &b.spin_accel_cos, &b.spin_accel_sin, &b.spin_accel_rate_cos, &b.spin_accel_rate_sin];
            if !own.into_iter().any(turning) {
                return;
            }
            let Turning { force: [fc, fs], spin_accel: [gc, gs], spin_accel_rate: [hc, hs], .. } = loads.of_spin(spin, spin.value(params));
            [[fc, fs], [gc, gs], [hc, hs]]
        }
    };
    for (global, local) in force.into_iter().chain(accel).zip([&b.force_cos, &b.force_sin, &b.spin_accel_cos, &b.spin_accel_sin]) {
        scatter(&slot.map, local, global);
    }
    for (global, local) in rate.into_iter().zip([&b.spin_accel_rate_cos, &b.spin_accel_rate_sin]) {
        for (k, &x) in local.iter().enumerate() {
            global[first + k] += x;
        }
    }
}

/// Scratch for [`System::linear`] and [`System::dynamic_stiffness`].
#[derive(Clone)]
pub struct LinearScratch<S> {
    local: Blocks<S>,
    impedance: Vec<Complex<S>>,
    entries: Vec<Complex<S>>,
}

impl<S: Scalar> Default for LinearScratch<S> {
    fn default() -> Self {
        LinearScratch { local: Blocks::default(), impedance: Vec::new(), entries: Vec::new() }
    }
}

impl System {
    /// Assembles the linear parts at a spin speed (rad/s): those that are the same at every speed first, from what is kept of them where the parameters are those of the machine.
    pub fn linear<S: Evaluate>(&self, params: &[S], speed: S, form: Form, out: &mut LinearModel<S>, scratch: &mut LinearScratch<S>) {
        let kept = self.steady(params, form);
        out.reset(self.assembly(form), self.n(), speed, kept);
        if kept.is_none() {
            self.add_linear(params, form, Slot::is_steady, out, scratch);
        }
        self.add_linear(params, form, |s| !s.is_steady(), out, scratch);
        if form == Form::Frequency {
            self.add_loads(params, speed, &mut out.loads, &mut scratch.local);
        }
    }

    /// Adds some of the linear parts at the speed of the model.
    pub(super) fn add_linear<S: Evaluate>(
        &self,
        params: &[S],
        form: Form,
        which: impl Fn(&Slot) -> bool,
        out: &mut LinearModel<S>,
        scratch: &mut LinearScratch<S>,
    ) {
        for stamp in &self.assembly(form).stamps {
            let slot = &self.slots()[stamp.slot];
            if !which(slot) {
                continue;
            }
            let m = stamp.states;
            let b = &mut scratch.local;
            let own_speed = slot.speed(params, out.speed);
            b.reset_band(slot.map.len(), m, slot.reach, own_speed);
            S::linear(&*slot.part, &params[slot.params.clone()], own_speed, b);
            if let Some(ratio) = slot.ratio {
                b.per_spin(ratio.value(params));
            }
            for (i, &w) in slot.weight.iter().enumerate() {
                for j in b.mass.columns(i) {
                    b.force[j] -= b.mass[(j, i)].scale(w);
                }
                for j in 0..m {
                    b.rate[j] += b.state_a[(j, i)].scale(w);
                }
            }
            out.add(stamp, b);
            let loads = &mut out.loads;
            scatter(&slot.map, &b.force, &mut loads.force);
            scatter(&slot.map, &b.spin_accel_force, &mut loads.spin_accel_force);
            let row = stamp.first_state - self.n();
            for i in 0..m {
                loads.rate[row + i] += b.rate[i];
            }
            add_turning(slot, row, b, params, loads);
            if slot.memory > 0 {
                out.memory.push(SlotMemory { slot: stamp.slot, speed: own_speed, first: slot.states.start + m, list: b.memory.clone() });
            }
        }
    }

    /// Adds the loads of the parts given in the frequency domain, and what their mass weighs.
    fn add_loads<S: Evaluate>(&self, params: &[S], speed: S, out: &mut Loads<S>, local: &mut Blocks<S>) {
        for slot in self.slots().iter().filter(|s| matches!(s.physics, Physics::Frequency(_))) {
            let own_speed = slot.speed(params, speed);
            local.reset(slot.map.len(), 0, own_speed);
            if let Some(part) = slot.part.frequency_domain() {
                S::load(part, &params[slot.params.clone()], own_speed, local);
            }
            for (i, &w) in slot.weight.iter().enumerate() {
                for j in 0..slot.map.len() {
                    local.force[j] -= local.mass[(j, i)].scale(w);
                }
            }
            scatter(&slot.map, &local.force, &mut out.force);
            add_turning(slot, 0, local, params, out);
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
        let mut entries = std::mem::take(&mut scratch.entries);
        self.dynamic_stiffness_entries(params, model, form, s, &mut entries, scratch);
        let pattern = model.pattern();
        let held = model.held();
        out.reset_complex(held);
        for i in 0..held {
            for (e, j) in pattern.row(i).take_while(|x| x.1 < held) {
                out[(i, j)] = entries[e];
            }
        }
        scratch.entries = entries;
    }

    /// The same as values on the [pattern](LinearModel::pattern).
    pub fn dynamic_stiffness_entries<S: Evaluate>(
        &self,
        params: &[S],
        model: &LinearModel<S>,
        form: Form,
        s: Complex<S>,
        out: &mut Vec<Complex<S>>,
        scratch: &mut LinearScratch<S>,
    ) where
        Complex<S>: Copy,
    {
        let pattern = &*model.assembly.pattern;
        refill(out, pattern.entries(), Complex::zero());
        spend((10 * pattern.entries() + 100 * self.slots().len()) as u64);
        let s2 = s * s;
        for i in 0..model.held() {
            for (e, j) in pattern.row(i).take_while(|x| x.1 < model.held()) {
                let [a0, a1, a2] = model.term(e, i, j);
                out[e] = s2.scale(a2) + s.scale(a1) + Complex::real(a0);
            }
        }
        let mut add = |slot: &Slot, row: usize, col: usize, x: Complex<S>| {
            for &(gi, ci) in &slot.map[row] {
                for &(gj, cj) in &slot.map[col] {
                    if let Some(e) = pattern.index(gi, gj) {
                        out[e] += x.scale(S::cst(ci * cj));
                    }
                }
            }
        };
        for mem in &model.memory {
            let slot = &self.slots()[mem.slot];
            for (k, z) in mem.list.iter().enumerate() {
                let r = s + Complex::real(z.rate);
                match z.axes {
                    Axes::Fixed => add(slot, z.output, z.input, r.recip().scale(z.gain)),
                    Axes::RotorX | Axes::RotorY => {
                        let partner = if z.axes == Axes::RotorX { &mem.list[k + 1] } else { &mem.list[k - 1] };
                        let f = (r * r + Complex::real(mem.speed * mem.speed)).recip().scale(z.gain);
                        let w = if z.axes == Axes::RotorX { -mem.speed } else { mem.speed };
                        add(slot, z.output, z.input, f * r);
                        add(slot, z.output, partner.input, f.scale(w));
                    }
                }
            }
        }
        if form == Form::Frequency {
            for (slot, part) in self.in_frequency_domain() {
                let k = slot.map.len();
                refill(&mut scratch.impedance, k * k, Complex::zero());
                S::impedance(part, &params[slot.params.clone()], s, slot.speed(params, model.speed), &mut scratch.impedance);
                for i in 0..k {
                    for j in 0..k {
                        add(slot, i, j, scratch.impedance[i * k + j]);
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
            Physics::Frequency(_) => s.part.frequency_domain()?.domain(&params[s.params.clone()], s.speed(params, speed)),
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
        all.fold(Complex::one(), |product, (slot, part)| {
            product * S::regular(part, &params[slot.params.clone()], s, slot.speed(params, speed))
        })
    }

    fn in_frequency_domain(&self) -> impl Iterator<Item = (&Slot, &dyn FrequencyDomain)> {
        let all = self.slots().iter().filter(|s| matches!(s.physics, Physics::Frequency(_)));
        all.filter_map(|s| Some((s, s.part.frequency_domain()?)))
    }
}

/// The complex number `re + i im` as lifted constants.
pub fn lift<S: Scalar>(re: f64, im: f64) -> Complex<S> {
    c(S::cst(re), S::cst(im))
}
