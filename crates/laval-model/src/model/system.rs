//! The assembled machine: parts mapped onto global coordinates. Immutable; scratch lives in a [`Workspace`].

use super::assembly::{Assembly, Form};
use super::blocks::Blocks;
use super::erased::{Evaluate, MovableMasses};
use super::field::{Extra, Field};
use super::linear::LinearModel;
use super::params::ParamSlot;
use super::part::{At, Correction, DofKind, Energy, Observed, Outline, Rows, Validity};
use super::probe::Probe;
use super::projected::Projection;
use super::slot::{gather, scatter};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::text;
use crate::text::Text;
use laval_num::refill::refill;
use laval_num::scalar::Scalar;
use laval_num::work::spend;
use std::sync::{Arc, OnceLock};

pub use super::capability::scope::Axis;
pub use super::machine::{Drive, GRAVITY, Machine};
pub use super::slot::{GlobalDof, PartInput, Slot};
pub use super::station::{Pair, Station};

/// The machine.
pub struct System {
    /// Name, speed, axis, drive.
    pub machine: Machine,
    pub(super) slots: Vec<Slot>,
    pub(super) coordinates: Vec<GlobalDof>,
    pub(super) states: Vec<GlobalDof>,
    pub(super) params: Vec<f64>,
    pub(super) param_slots: Vec<ParamSlot>,
    pub(super) stations: OnceLock<Vec<Station>>,
    pub(super) probes: OnceLock<Vec<Probe>>,
    pub(super) assemblies: [OnceLock<Arc<Assembly>>; 2],
    pub(super) steady: [OnceLock<Option<LinearModel<f64>>>; 2],
    pub(super) projection: Option<Arc<Projection>>,
}

/// Scratch for evaluations in scalar `S`; one per thread.
pub struct Workspace<S> {
    q: Vec<S>,
    v: Vec<S>,
    a: Vec<S>,
    force: Vec<S>,
    rate: Vec<S>,
    blocks: Blocks<S>,
}

impl<S: Scalar> Default for Workspace<S> {
    fn default() -> Self {
        Workspace { q: vec![], v: vec![], a: vec![], force: vec![], rate: vec![], blocks: Blocks::default() }
    }
}

impl System {
    /// The parts in their places.
    pub fn slots(&self) -> &[Slot] {
        &self.slots
    }
    /// A part by name.
    pub fn slot(&self, name: &str) -> Option<&Slot> {
        self.slots.iter().find(|s| s.name == name)
    }
    /// Global coordinates.
    pub fn coordinates(&self) -> &[GlobalDof] {
        &self.coordinates
    }
    /// Global internal states.
    pub fn states(&self) -> &[GlobalDof] {
        &self.states
    }
    /// Number of coordinates.
    pub fn n(&self) -> usize {
        self.coordinates.len()
    }
    /// Number of internal states.
    pub fn m(&self) -> usize {
        self.states.len()
    }
    /// Index of a coordinate by name (`drum.x`), or by that of a station which it is the displacement of (`shaft at 300 mm.x`).
    pub fn coordinate(&self, name: &str) -> Option<usize> {
        let station = |s: &Station| {
            let k = s.columns().iter().position(|c| c == name)?;
            Some(s.lateral.first()? + k)
        };
        self.coordinates.iter().position(|c| c.name == name).or_else(|| self.stations().iter().find_map(station))
    }
    /// Where the entries of parts stand in the linear model of a form.
    pub fn assembly(&self, form: Form) -> &Arc<Assembly> {
        self.assemblies[form as usize].get_or_init(|| Arc::new(Assembly::new(&self.slots, &self.coordinates, &self.states, form)))
    }
    /// Parameter values, SI.
    pub fn params(&self) -> &[f64] {
        &self.params
    }
    /// Parameter declarations by path (`drum.mass`, `bearing.stiffness.x`).
    pub fn param_slots(&self) -> &[ParamSlot] {
        &self.param_slots
    }
    /// Indices of a parameter by path; a lateral pair without `.x` or `.y` names both halves.
    pub fn param(&self, path: &str) -> Option<Vec<usize>> {
        let found = |p: &str| self.param_slots.iter().position(|s| s.name == p);
        match found(path) {
            Some(i) => Some(vec![i]),
            None => Some(vec![found(&format!("{path}.x"))?, found(&format!("{path}.y"))?]),
        }
    }
    /// The same machine with some parameters changed. Refuses inadmissible values.
    pub fn with(&self, overrides: &[(&str, f64)]) -> Result<System, Diagnostics> {
        let mut diagnostics = Diagnostics::default();
        if self.projection.is_some() {
            diagnostics.push(Diagnostic::error("machine.projected", text!("parameters of a reduced machine cannot be changed")));
            return Err(diagnostics);
        }
        let mut inputs: Vec<PartInput> = self.inputs();
        for &(path, value) in overrides {
            let Some(indices) = self.param(path) else {
                diagnostics.push(self.unknown_param(path));
                continue;
            };
            for i in indices {
                if let Some((slot, input)) = self.slots.iter().zip(&mut inputs).find(|(s, _)| s.params.contains(&i)) {
                    input.params[i - slot.params.start] = value;
                }
            }
        }
        if diagnostics.has_errors() { Err(diagnostics) } else { System::assemble(self.machine.clone(), inputs) }
    }
    /// The same parts in a machine with other data beside them.
    ///
    /// # Errors
    /// As [`System::assemble`].
    pub fn with_extras(&self, extras: Vec<Extra>) -> Result<System, Diagnostics> {
        System::assemble(Machine { extras, ..self.machine.clone() }, self.inputs())
    }
    /// The machine with the approximations of its parts in their places ([`approximation`](super::capability::FrequencyDomain::approximation)); `None` where no part has one.
    ///
    /// # Errors
    /// As [`System::assemble`].
    pub fn approximation(&self) -> Option<Result<System, Diagnostics>> {
        let mut inputs = self.inputs();
        let mut any = false;
        for input in &mut inputs {
            if let Some((part, params)) = input.part.frequency_domain().and_then(|f| f.approximation(&input.params)) {
                (input.part, input.params) = (part, params);
                any = true;
            }
        }
        any.then(|| System::assemble(self.machine.clone(), inputs))
    }
    /// The diagnostic for a path that names no parameter.
    pub fn unknown_param(&self, path: &str) -> Diagnostic {
        let (part, rest) = path.split_once('.').unwrap_or((path, ""));
        let near: Vec<&str> = self.param_slots.iter().map(|s| s.name.as_str()).filter(|n| n.split('.').next() == Some(part)).collect();
        let help = if near.is_empty() {
            text!("parts of this machine: {names}", names = self.slots.iter().map(|s| s.name.as_str()).collect::<Vec<_>>().join(", "))
        } else {
            let other = text!("what a file says in another form, as a fill by its volume, is varied by the parameter it stands for");
            text!("parameters of \"{part}\": {near} ({other})", part, near = near.join(", "), other)
        };
        let in_rows = |f: &&Field| self.param_slots.iter().any(|s| s.name.starts_with(&format!("{part}.{}[", f.name)));
        let slot = self.slot(part);
        let list = slot.and_then(|s| Field::list_of(s.part.fields(), rest));
        let of_parameters = |f: &Field| slot.is_some_and(|s| s.part.lists().iter().any(|l| l.name == f.name));
        // a row beyond the last of a list of parameters: section[9] of four
        if let Some((name, _)) = rest.split_once('[') {
            let numbers = self.param_slots.iter().filter_map(|s| {
                let (number, _) = s.name.strip_prefix(part)?.strip_prefix('.')?.strip_prefix(name)?.strip_prefix('[')?.split_once(']')?;
                number.parse::<usize>().ok()
            });
            if let Some(count) = numbers.max() {
                let message = match count {
                    1 => text!("there is no parameter \"{path}\": {name} of \"{part}\" has one row", path, name, part),
                    _ => text!("there is no parameter \"{path}\": {name} of \"{part}\" has {count} rows", path, name, part, count),
                };
                let own = format!("{part}.{name}[{count}].");
                let near = near.into_iter().filter(|n| n.starts_with(&own)).collect::<Vec<_>>().join(", ");
                let help = text!("rows are numbered from 1; parameters of the last: {near}", near);
                return Diagnostic::error("parameter.unknown", message).about(path).help(help);
            }
        }
        let message = match list {
            Some(list) if in_rows(&list) => {
                text!("\"{path}\" is no parameter: \"{name}\" is a list, whose rows are numbered from 1", path, name = list.name)
            }
            Some(list) if of_parameters(list) => {
                text!("there is no parameter \"{path}\": \"{part}\" is given without {name}", path, part, name = list.name)
            }
            Some(list) => text!("\"{path}\" is no parameter: \"{name}\" is a list, and studies hold its values", path, name = list.name),
            None => text!("there is no parameter \"{path}\"", path),
        };
        Diagnostic::error("parameter.unknown", message).about(path).help(help)
    }
    /// The parts as they went into assembly.
    pub fn inputs(&self) -> Vec<PartInput> {
        self.slots
            .iter()
            .map(|s| PartInput {
                name: s.name.clone(),
                part: s.part.clone(),
                params: self.params[s.params.clone()].to_vec(),
                span: s.span.clone(),
            })
            .collect()
    }

    /// Adds the residual of all parts (or of those `which` admits) at a global point: force rows (N, N m), rates of internal states, spin row.
    ///
    /// `at` holds global vectors of lengths [`System::n`] and [`System::m`].
    pub fn residual<S: Evaluate>(&self, params: &[S], at: &At<S>, out: &mut Rows<S>, ws: &mut Workspace<S>, which: impl Fn(&Slot) -> bool) {
        for slot in self.slots.iter().filter(|s| which(s)) {
            self.part_residual(slot, params, at, out, ws);
        }
    }

    /// Adds that of one part.
    pub fn part_residual<S: Evaluate>(&self, slot: &Slot, params: &[S], at: &At<S>, out: &mut Rows<S>, ws: &mut Workspace<S>) {
        self.slot_local(slot, at, ws);
        let n = slot.map.len();
        spend(((10 + 10 * n) * size_of::<S>() / size_of::<f64>()) as u64);
        refill(&mut ws.force, n, S::zero());
        refill(&mut ws.rate, slot.states.len(), S::zero());
        let mut spin = S::zero();
        let local = slot.turned(params, At { q: &ws.q, v: &ws.v, a: &ws.a, z: &at.z[slot.states.clone()], ..*at });
        let mut rows = Rows { force: &mut ws.force, rate: &mut ws.rate, spin: &mut spin };
        S::residual(&*slot.part, &params[slot.params.clone()], &local, &mut rows, &mut ws.blocks);
        *out.spin += slot.torque(params, spin);
        scatter(&slot.map, &ws.force, out.force);
        for (r, &x) in out.rate[slot.states.clone()].iter_mut().zip(&ws.rate) {
            *r += x;
        }
    }

    /// The spin row alone, N m.
    pub fn torque(&self, at: &At<f64>, ws: &mut Workspace<f64>, rows: &mut Rows<f64>) -> f64 {
        let mut sum = 0.0;
        for slot in &self.slots {
            if slot.is_linear() {
                sum += self.part_torque(slot, at, ws);
            } else {
                *rows.spin = 0.0;
                self.part_residual(slot, &self.params, at, rows, ws);
                sum += *rows.spin;
            }
        }
        sum
    }

    /// Share of a linear part in the spin row, N m.
    pub fn part_torque(&self, slot: &Slot, at: &At<f64>, ws: &mut Workspace<f64>) -> f64 {
        let torque = self.with_local(slot, at, ws, |l| slot.part.spin_row_f64(&self.params[slot.params.clone()], l));
        slot.torque(&self.params, torque)
    }

    fn slot_local<S: Scalar>(&self, slot: &Slot, at: &At<S>, ws: &mut Workspace<S>) {
        gather(&slot.map, at.q, &mut ws.q);
        gather(&slot.map, at.v, &mut ws.v);
        gather(&slot.map, at.a, &mut ws.a);
        for (a, &g) in ws.a.iter_mut().zip(&slot.weight) {
            *a += S::cst(g);
        }
    }

    /// Calls `f` with a part's local view of a global point.
    pub fn with_local<S: Scalar, R>(&self, slot: &Slot, at: &At<S>, ws: &mut Workspace<S>, f: impl FnOnce(&At<S>) -> R) -> R {
        self.slot_local(slot, at, ws);
        let local = At { q: &ws.q, v: &ws.v, a: &ws.a, z: &at.z[slot.states.clone()], ..*at };
        f(&match slot.ratio {
            None => local,
            Some(ratio) => {
                let r = ratio.value(&self.params);
                let by = |x: S| x.scale(r);
                At { phase: by(at.phase), speed: by(at.speed), spin_accel: by(at.spin_accel), ..local }
            }
        })
    }

    /// Energy of the machine; `None` when a part keeps no account (its name is the error).
    pub fn energy<S: Evaluate>(&self, params: &[S], at: &At<S>, ws: &mut Workspace<S>) -> Result<Energy<S>, String> {
        let mut sum = Energy::zero();
        for slot in &self.slots {
            let e = self.with_local(slot, at, ws, |l| S::energy(&*slot.part, &params[slot.params.clone()], l));
            let e = e.ok_or_else(|| slot.name.clone())?;
            sum.stored += e.stored;
            sum.dissipated += e.dissipated;
            sum.supplied += e.supplied;
        }
        Ok(sum)
    }

    /// Quantities the parts show at a point, as (part, quantity).
    pub fn observe(&self, at: &At<f64>, ws: &mut Workspace<f64>) -> Vec<(usize, Observed)> {
        self.each(at, ws, |slot, l, out| slot.part.observe(&self.params[slot.params.clone()], l, out))
    }
    /// Those of one part.
    pub fn observe_part(&self, part: usize, at: &At<f64>, ws: &mut Workspace<f64>) -> Vec<Observed> {
        let (slot, mut out) = (&self.slots[part], Vec::new());
        self.with_local(slot, at, ws, |l| slot.part.observe(&self.params[slot.params.clone()], l, &mut out));
        out
    }
    /// Use of validity at a point, as (part, statement).
    pub fn validity(&self, at: &At<f64>, ws: &mut Workspace<f64>) -> Vec<(usize, Validity)> {
        self.each(at, ws, |slot, l, out| slot.part.validity(&self.params[slot.params.clone()], l, out))
    }
    /// Torque of all drives at a speed, N m; `None` without a drive.
    pub fn drive_torque(&self, speed: f64) -> Option<f64> {
        self.slots
            .iter()
            .filter_map(|s| {
                Some(s.torque(&self.params, s.part.spin_drive()?.torque(&self.params[s.params.clone()], s.speed(&self.params, speed))))
            })
            .reduce(|a, b| a + b)
    }
    /// Parameters of parts that spin without inertia about the axis although they have mass, by path.
    pub fn without_spin_inertia(&self) -> Vec<String> {
        let lacks = |s: &Slot| Some(format!("{}.{}", s.name, s.part.body()?.lacks_spin_inertia(&self.params[s.params.clone()])?));
        self.slots.iter().filter_map(lacks).collect()
    }
    /// What damps the waves of the liquids of the machine.
    pub fn damping_of_waves(&self) -> Option<&'static str> {
        self.slots.iter().find_map(|s| s.part.filling()).map(|f| f.damping())
    }
    /// What keeps parts from doing what they are there for, as (part, sentence).
    pub fn warnings(&self) -> Vec<(usize, Text)> {
        let all = self.slots.iter().enumerate();
        all.flat_map(|(k, s)| s.part.warnings(&self.params[s.params.clone()]).into_iter().map(move |w| (k, w))).collect()
    }
    /// What the parts that balance by themselves do at a point, as (part, correction).
    pub fn corrections(&self, at: &At<f64>, ws: &mut Workspace<f64>) -> Vec<(usize, Correction)> {
        self.each_movable(at, ws, |masses, p, l, out| out.extend(masses.correction(p, l)))
    }
    /// Coordinates that dry friction holds where they rest, as (coordinate, largest force): own coordinates of parts.
    pub fn grips(&self, at: &At<f64>, ws: &mut Workspace<f64>) -> Vec<(usize, f64)> {
        let held = self.each_movable(at, ws, |masses, p, l, out| masses.grip(p, l, out));
        held.into_iter().filter(|h| h.1.1 > 0.0).filter_map(|(k, h)| self.own(k, h)).collect()
    }
    /// Where coordinates are when a motion begins and nothing is said of them, as (coordinate, value): own coordinates of parts.
    pub fn places(&self) -> Vec<(usize, f64)> {
        let all =
            self.slots.iter().enumerate().filter_map(|(k, s)| Some((k, s.part.movable_masses()?.places(&self.params[s.params.clone()]))));
        all.flat_map(|(k, places)| places.into_iter().filter_map(move |x| self.own(k, x))).collect()
    }
    /// What a part says of a local coordinate, said of the machine's; `None` of a coordinate that is not its own.
    fn own(&self, slot: usize, (local, value): (usize, f64)) -> Option<(usize, f64)> {
        match self.slots[slot].map.get(local).map(|row| &row[..]) {
            Some(&[(g, 1.0)]) => Some((g, value)),
            _ => None,
        }
    }
    /// What the parts with movable masses look like at a point, as (part, circle).
    pub fn outlines(&self, at: &At<f64>, ws: &mut Workspace<f64>) -> Vec<(usize, Outline)> {
        self.each_movable(at, ws, |masses, p, l, out| out.extend(masses.outlines(p, l)))
    }
    fn each_movable<T>(
        &self,
        at: &At<f64>,
        ws: &mut Workspace<f64>,
        f: impl Fn(&dyn MovableMasses, &[f64], &At<f64>, &mut Vec<T>),
    ) -> Vec<(usize, T)> {
        self.each(at, ws, |slot, l, out| {
            if let Some(masses) = slot.part.movable_masses() {
                f(masses, &self.params[slot.params.clone()], l, out);
            }
        })
    }
    fn each<T>(&self, at: &At<f64>, ws: &mut Workspace<f64>, f: impl Fn(&Slot, &At<f64>, &mut Vec<T>)) -> Vec<(usize, T)> {
        let (mut out, mut own) = (Vec::new(), Vec::new());
        for (k, slot) in self.slots.iter().enumerate() {
            self.with_local(slot, at, ws, |l| f(slot, l, &mut own));
            out.extend(own.drain(..).map(|x| (k, x)));
        }
        out
    }

    /// Turns the vector (and tilt) pairs of a global coordinate vector by `angle` (rad) about the axis, in place.
    pub fn turn<S: Scalar>(&self, x: &mut [S], angle: S) {
        turn(self.coordinates.iter().map(|c| c.dof.kind), x, angle);
    }
    /// The same for internal states.
    pub fn turn_states<S: Scalar>(&self, z: &mut [S], angle: S) {
        turn(self.states.iter().map(|c| c.dof.kind), z, angle);
    }
}

/// Turns the pairs of a vector, whose entries are of these kinds, by `angle` (rad) about the axis, in place.
pub fn turn<S: Scalar>(kinds: impl Iterator<Item = DofKind>, x: &mut [S], angle: S) {
    let (s, c) = angle.sin_cos();
    for (i, kind) in kinds.enumerate() {
        if kind.leads_pair() && i + 1 < x.len() {
            (x[i], x[i + 1]) = (c * x[i] - s * x[i + 1], s * x[i] + c * x[i + 1]);
        }
    }
}
