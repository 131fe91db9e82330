//! The assembled machine: parts mapped onto global coordinates. Immutable; scratch lives in a [`Workspace`].

use super::assembly::{Assembly, Form};
use super::blocks::Blocks;
use super::erased::{Erased, Evaluate, MovableMasses};
use super::field::{Attach, Extra, Field};
use super::params::{ParamSlot, inadmissible};
use super::part::{At, Correction, Dof, DofKind, Energy, Layout, Link, Observed, Outline, Physics, PortKind, Rows, Uses, Validity};
use super::probe::{self, Probe};
use crate::diagnostic::{Diagnostic, Diagnostics, Span};
use crate::text;
use crate::text::Text;
use laval_num::refill::refill;
use laval_num::scalar::Scalar;
use laval_num::work::spend;
use std::ops::Range;
use std::sync::{Arc, OnceLock};

pub use super::capability::scope::Axis;

/// Standard gravity, m/s^2.
pub const GRAVITY: f64 = 9.80665;

/// How the spin angle moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Drive {
    /// A programme: the spin row is not solved, it gives the torque needed.
    #[default]
    Prescribed,
    /// The spin angle is a coordinate.
    Free,
}

/// What is said of the machine as a whole.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Machine {
    /// Name.
    pub name: String,
    /// Spin speed for studies that name none, rad/s.
    pub speed: Option<f64>,
    /// Direction of the shaft.
    pub axis: Axis,
    /// Drive.
    pub drive: Drive,
    /// Blocks beside the parts that studies read: cups, suspension, limits.
    pub extras: Vec<Extra>,
    /// Points of bodies that such blocks name: body and height above its reference point, m.
    pub points: Vec<(String, f64)>,
}

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
    /// Each local coordinate as a combination of global ones: the rows of B.
    pub map: Vec<Vec<(usize, f64)>>,
    /// What the weight adds to the local accelerations the part sees (a body at rest in a field g moves like one accelerated by -g), m/s^2.
    pub weight: Vec<f64>,
    /// Its internal states among the machine's.
    pub states: Range<usize>,
    /// How many of them, at the end, are memory states.
    pub memory: usize,
    /// Place in the file.
    pub span: Option<Span>,
}

impl Slot {
    /// A linear (or time-fitted) part, given by its blocks in time.
    pub fn is_linear(&self) -> bool {
        self.physics != Physics::Nonlinear
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

/// A body (or any part whose first two own coordinates are a lateral pair) that results speak of.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// Name of the part.
    pub name: String,
    /// Its slot.
    pub slot: usize,
    /// Global index of its x; y follows.
    pub x: usize,
    /// Global index of the first component of its tilt, where it tilts; the other follows.
    pub tilt: Option<usize>,
}

/// The machine.
pub struct System {
    /// Name, speed, axis, drive.
    pub machine: Machine,
    slots: Vec<Slot>,
    coordinates: Vec<GlobalDof>,
    states: Vec<GlobalDof>,
    params: Vec<f64>,
    param_slots: Vec<ParamSlot>,
    probes: OnceLock<Vec<Probe>>,
    assemblies: [OnceLock<Arc<Assembly>>; 2],
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

impl System {
    /// Assembles a machine. All mistakes are reported together.
    pub fn assemble(machine: Machine, inputs: Vec<PartInput>) -> Result<System, Diagnostics> {
        let mut diagnostics = Diagnostics::default();
        let mut system = System {
            machine,
            slots: vec![],
            coordinates: vec![],
            states: vec![],
            params: vec![],
            param_slots: vec![],
            probes: OnceLock::new(),
            assemblies: Default::default(),
        };
        for input in &inputs {
            system.add(input, &mut diagnostics);
        }
        for k in 0..system.slots.len() {
            match system.local_map(k) {
                Ok(map) => {
                    system.slots[k].weight = system.local_weight(&map);
                    system.slots[k].map = map;
                }
                Err(d) => diagnostics.push(*d),
            }
        }
        if system.coordinates.is_empty() {
            diagnostics.push(
                Diagnostic::error("machine.no_body", text!("the machine has no body that can move"))
                    .help(text!("add a part such as a disc: [[part]] with kind = \"disc\" and a mass")),
            );
        }
        if !diagnostics.has_errors() {
            super::inertia::check(&system, &mut diagnostics);
        }
        if diagnostics.has_errors() { Err(diagnostics) } else { Ok(system) }
    }

    fn add(&mut self, input: &PartInput, diagnostics: &mut Diagnostics) {
        let (part, k) = (&input.part, self.slots.len());
        if let Some(other) = self.slots.iter().find(|s| s.name == input.name) {
            diagnostics.push(
                Diagnostic::error("part.duplicate", text!("two parts are named \"{name}\"", name = other.name))
                    .at(input.span.clone())
                    .help(text!("give each part its own name")),
            );
        }
        let layout = part.layout();
        let own = |dofs: &[Dof]| -> Vec<GlobalDof> {
            dofs.iter().map(|d| GlobalDof { name: format!("{}.{}", input.name, d.name), slot: k, dof: d.clone() }).collect()
        };
        let slots = part.slots();
        if slots.len() != input.params.len() {
            diagnostics.push(Diagnostic::error(
                "part.parameters",
                text!("part \"{name}\" takes {slots} parameters", name = input.name, slots = slots.len()),
            ));
            return;
        }
        for wrong in inadmissible(&slots, &input.params) {
            diagnostics
                .push(Diagnostic::error("parameter.bounds", text!("\"{name}\": {wrong}", name = input.name, wrong)).at(input.span.clone()));
        }
        if !diagnostics.has_errors() {
            for (_, message) in part.check(&input.params) {
                diagnostics.push(
                    Diagnostic::error("part.check", text!("\"{name}\": {message}", name = input.name, message)).at(input.span.clone()),
                );
            }
            if let Some(message) = part.scope().and_then(|s| s.refuses_axis(&input.params, self.machine.axis)) {
                diagnostics.push(
                    Diagnostic::error("part.axis", text!("\"{name}\": {message}", name = input.name, message)).at(input.span.clone()),
                );
            }
        }
        let (p0, s0) = (self.params.len(), self.states.len());
        self.params.extend(&input.params);
        self.param_slots.extend(slots.into_iter().map(|s| ParamSlot { name: format!("{}.{}", input.name, s.name), ..s }));
        self.coordinates.extend(own(&layout.own));
        self.states.extend(own(&layout.states));
        self.slots.push(Slot {
            name: input.name.clone(),
            part: part.clone(),
            physics: part.physics(),
            uses: part.uses(),
            params: p0..self.params.len(),
            map: vec![],
            weight: vec![],
            states: s0..self.states.len(),
            memory: part.memory(),
            span: input.span.clone(),
            layout,
        });
    }

    /// Rows of x, y, tilt_x, tilt_y of a point over global coordinates; empty rows for the ground.
    pub(super) fn point_rows(&self, slot: usize, attach: &Attach) -> Result<[Vec<(usize, f64)>; 4], Box<Diagnostic>> {
        let mut rows: [Vec<(usize, f64)>; 4] = Default::default();
        let Some(name) = &attach.body else { return Ok(rows) };
        let Some(body) = self.slots.iter().position(|s| &s.name == name) else {
            let bodies: Vec<&str> = self.slots.iter().filter(|s| s.layout.body).map(|s| s.name.as_str()).collect();
            return Err(Box::new(
                Diagnostic::error(
                    "body.missing",
                    text!("\"{slot}\" is attached to \"{name}\", which does not exist", slot = self.slots[slot].name, name),
                )
                .at(self.slots[slot].span.clone())
                .help(text!("bodies of this machine: {bodies}, ground", bodies = bodies.join(", "))),
            ));
        };
        let b = &self.slots[body];
        if !b.layout.body {
            return Err(Box::new(
                Diagnostic::error(
                    "body.kind",
                    text!("\"{slot}\" is attached to \"{name}\", which is not a body", slot = self.slots[slot].name, name),
                )
                .at(self.slots[slot].span.clone())
                .help(text!("\"{name}\" is a {kind}; attach to a disc or a foundation", name, kind = b.part.kind())),
            ));
        }
        let first = self.coordinates.iter().position(|c| c.slot == body).unwrap_or(0);
        let shape = b.part.body().map_or_else(Vec::new, |body| body.shape(&self.params[b.params.clone()], attach.position));
        for (j, column) in shape.iter().enumerate() {
            for (row, &x) in rows.iter_mut().zip(column) {
                if x != 0.0 {
                    row.push((first + j, x));
                }
            }
        }
        Ok(rows)
    }

    fn local_map(&self, k: usize) -> Result<Vec<Vec<(usize, f64)>>, Box<Diagnostic>> {
        let slot = &self.slots[k];
        let mut map = Vec::new();
        for port in &slot.layout.ports {
            let rows = match &port.link {
                Link::On(a) => self.point_rows(k, a)?,
                Link::Between(a, b) => {
                    if a == b {
                        return Err(Box::new(
                            Diagnostic::error("port.same", text!("\"{name}\" joins a point to itself", name = slot.name))
                                .at(slot.span.clone()),
                        ));
                    }
                    let (mut first, second) = (self.point_rows(k, a)?, self.point_rows(k, b)?);
                    for (row, minus) in first.iter_mut().zip(second) {
                        row.extend(minus.into_iter().map(|(g, c)| (g, -c)));
                    }
                    first
                }
            };
            let wanted = match port.kind {
                PortKind::Point => 2,
                PortKind::PointAndTilt => 4,
            };
            map.extend(rows.into_iter().take(wanted));
        }
        map.extend(self.coordinates.iter().enumerate().filter(|(_, c)| c.slot == k).map(|(g, _)| vec![(g, 1.0)]));
        Ok(map)
    }

    fn local_weight(&self, map: &[Vec<(usize, f64)>]) -> Vec<f64> {
        if self.machine.axis == Axis::Vertical {
            return Vec::new();
        }
        let share = |&(g, c): &(usize, f64)| if self.coordinates[g].dof.kind == DofKind::VectorY { c * GRAVITY } else { 0.0 };
        map.iter().map(|row| row.iter().map(share).sum()).collect()
    }

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
    /// Index of a coordinate by name (`drum.x`).
    pub fn coordinate(&self, name: &str) -> Option<usize> {
        self.coordinates.iter().position(|c| c.name == name)
    }
    /// Bodies with a lateral displacement, in file order.
    pub fn bodies(&self) -> Vec<Body> {
        let mut out = Vec::new();
        for (i, c) in self.coordinates.iter().enumerate() {
            if c.dof.kind == DofKind::VectorX && self.slots[c.slot].layout.body && !out.iter().any(|b: &Body| b.slot == c.slot) {
                let tilt = self.coordinates.iter().position(|t| t.slot == c.slot && t.dof.kind == DofKind::TiltX);
                out.push(Body { name: self.slots[c.slot].name.clone(), slot: c.slot, x: i, tilt });
            }
        }
        out
    }
    /// All that is measured of the bodies' motion, by body: the reference point, the points where parts are attached or that a block names, where their
    /// displacement differs from it, the tilt.
    pub fn probes(&self) -> &[Probe] {
        self.probes.get_or_init(|| probe::all(self))
    }
    /// Where the entries of parts stand in the linear model of a form.
    pub fn assembly(&self, form: Form) -> &Arc<Assembly> {
        self.assemblies[form as usize].get_or_init(|| Arc::new(Assembly::new(self, form)))
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
        let list = self.slot(part).and_then(|s| Field::list_of(s.part.fields(), rest));
        let message = match list {
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
            self.slot_local(slot, at, ws);
            let n = slot.map.len();
            spend(((10 + 10 * n) * size_of::<S>() / size_of::<f64>()) as u64);
            refill(&mut ws.force, n, S::zero());
            refill(&mut ws.rate, slot.states.len(), S::zero());
            let mut spin = S::zero();
            let local = At { q: &ws.q, v: &ws.v, a: &ws.a, z: &at.z[slot.states.clone()], ..*at };
            let mut rows = Rows { force: &mut ws.force, rate: &mut ws.rate, spin: &mut spin };
            S::residual(&*slot.part, &params[slot.params.clone()], &local, &mut rows, &mut ws.blocks);
            *out.spin += spin;
            scatter(&slot.map, &ws.force, out.force);
            for (r, &x) in out.rate[slot.states.clone()].iter_mut().zip(&ws.rate) {
                *r += x;
            }
        }
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
        f(&At { q: &ws.q, v: &ws.v, a: &ws.a, z: &at.z[slot.states.clone()], ..*at })
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
    /// Use of validity at a point, as (part, statement).
    pub fn validity(&self, at: &At<f64>, ws: &mut Workspace<f64>) -> Vec<(usize, Validity)> {
        self.each(at, ws, |slot, l, out| slot.part.validity(&self.params[slot.params.clone()], l, out))
    }
    /// Torque of all drives at a speed, N m; `None` without a drive.
    pub fn drive_torque(&self, speed: f64) -> Option<f64> {
        self.slots.iter().filter_map(|s| Some(s.part.spin_drive()?.torque(&self.params[s.params.clone()], speed))).reduce(|a, b| a + b)
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
        let mut out = Vec::new();
        for (k, slot) in self.slots.iter().enumerate() {
            let mut own = Vec::new();
            self.with_local(slot, at, ws, |l| f(slot, l, &mut own));
            out.extend(own.into_iter().map(|x| (k, x)));
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

fn turn<S: Scalar>(kinds: impl Iterator<Item = DofKind>, x: &mut [S], angle: S) {
    let (s, c) = angle.sin_cos();
    for (i, kind) in kinds.enumerate() {
        if kind.leads_pair() && i + 1 < x.len() {
            (x[i], x[i + 1]) = (c * x[i] - s * x[i + 1], s * x[i] + c * x[i + 1]);
        }
    }
}
