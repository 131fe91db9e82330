//! Parts put together to a machine: names, parameters and places checked, local coordinates expressed in those of the machine.

use super::field::Attach;
use super::inertia;
use super::machine::{GRAVITY, Machine};
use super::params::{ParamSlot, inadmissible};
use super::part::{COMPONENTS, Dof, DofKind, ErasedPart, Layout, Link};
use super::slot::{GlobalDof, PartInput, Slot};
use super::system::{Axis, System};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::text;
use crate::text::Text;
use std::sync::OnceLock;

/// Why a position is not on a body that reaches from one end to the other.
pub fn outside(position: f64, [low, high]: [f64; 2]) -> Option<Text> {
    let rounding = 1e-9 * (high - low);
    let on = (low - rounding..=high + rounding).contains(&position);
    let end = if position < low { low } else { high };
    let length = |x: f64, other: f64| text::quantity_beside(x, other, "m");
    (!on).then(|| {
        text!(
            "the position {position} is not on the body, which reaches from {low} to {high}",
            position = length(position, end),
            low = if end == low { length(low, position) } else { text::quantity(low, "m") },
            high = if end == high { length(high, position) } else { text::quantity(high, "m") }
        )
    })
}

/// Whether the map of a part is known.
#[derive(Clone, Copy)]
enum Stand {
    Unknown,
    Sought,
    Placed,
}

/// The part of an input; a body that bends with nodes wherever something is attached to it.
fn divided(input: &PartInput, all: &[PartInput], points: &[(String, f64)]) -> ErasedPart {
    let Some(body) = input.part.body().filter(|b| b.nodes().is_some()) else { return input.part.clone() };
    let layouts: Vec<Layout> = all.iter().map(|p| p.part.layout()).collect();
    let attached = layouts.iter().flat_map(|l| &l.ports).flat_map(|p| p.link.ends());
    let here = attached.filter(|a| a.body.as_deref() == Some(&input.name)).map(|a| a.position);
    let positions: Vec<f64> = here.chain(points.iter().filter(|p| p.0 == input.name).map(|p| p.1)).collect();
    body.divided(&positions).unwrap_or_else(|| input.part.clone())
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
            stations: OnceLock::new(),
            probes: OnceLock::new(),
            assemblies: Default::default(),
            steady: Default::default(),
            projection: None,
        };
        for input in &inputs {
            system.add(input, divided(input, &inputs, &system.machine.points), &mut diagnostics);
        }
        let mut stand = vec![Stand::Unknown; system.slots.len()];
        for k in 0..system.slots.len() {
            system.place(k, &mut stand, &mut diagnostics);
        }
        system.relate_spins(&mut diagnostics);
        if system.coordinates.is_empty() {
            diagnostics.push(
                Diagnostic::error("machine.no_body", text!("the machine has no body that can move"))
                    .help(text!("add a part such as a disc: [[part]] with kind = \"disc\" and a mass")),
            );
        }
        if !diagnostics.has_errors() {
            inertia::check(&system, &mut diagnostics);
        }
        if diagnostics.has_errors() { Err(diagnostics) } else { Ok(system) }
    }

    fn add(&mut self, input: &PartInput, part: ErasedPart, diagnostics: &mut Diagnostics) {
        let k = self.slots.len();
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
        let part = part.prepared(&input.params).unwrap_or(part);
        let (p0, q0, s0) = (self.params.len(), self.coordinates.len(), self.states.len());
        self.params.extend(&input.params);
        self.param_slots.extend(slots.into_iter().map(|s| ParamSlot { name: format!("{}.{}", input.name, s.name), ..s }));
        self.coordinates.extend(own(&layout.own));
        self.states.extend(own(&layout.states));
        self.slots.push(Slot {
            name: input.name.clone(),
            physics: part.physics(),
            uses: part.uses(),
            params: p0..self.params.len(),
            spin: None,
            ratio: None,
            map: vec![],
            weight: vec![],
            own: q0..self.coordinates.len(),
            states: s0..self.states.len(),
            memory: part.memory(),
            reach: part.reach(),
            span: input.span.clone(),
            layout,
            part,
        });
    }

    /// Rows of the components of the motion of a point over global coordinates; empty rows for the ground.
    pub(super) fn point_rows(&self, slot: usize, attach: &Attach) -> Result<[Vec<(usize, f64)>; COMPONENTS.len()], Box<Diagnostic>> {
        let mut rows: [Vec<(usize, f64)>; COMPONENTS.len()] = Default::default();
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
                .help(text!(
                    "\"{name}\" is a {kind}; attach to a disc, a shaft or a foundation",
                    name,
                    kind = b.part.kind()
                )),
            ));
        }
        if let Some(ends) = b.part.body().and_then(|b| b.nodes()).and_then(|n| Some([*n.first()?, *n.last()?]))
            && let Some(beyond) = outside(attach.position, ends)
        {
            return Err(Box::new(
                Diagnostic::error("body.position", text!("\"{slot}\": {beyond}", slot = self.slots[slot].name, beyond))
                    .at(self.slots[slot].span.clone()),
            ));
        }
        let shape = b.part.body().map_or_else(Vec::new, |body| body.shape(&self.params[b.params.clone()], attach.position));
        for (local, column) in b.map.iter().zip(&shape) {
            for (row, &x) in rows.iter_mut().zip(column).filter(|(_, x)| **x != 0.0) {
                for &(g, c) in local {
                    match row.iter_mut().find(|e| e.0 == g) {
                        Some(entry) => entry.1 += c * x,
                        None => row.push((g, c * x)),
                    }
                }
            }
        }
        rows.iter_mut().for_each(|row| row.retain(|e| e.1 != 0.0));
        Ok(rows)
    }

    /// Sets the map of a part, after those of the bodies that it is attached to.
    fn place(&mut self, k: usize, stand: &mut [Stand], diagnostics: &mut Diagnostics) {
        match stand[k] {
            Stand::Placed => return,
            Stand::Unknown => {}
            Stand::Sought => {
                let slot = &self.slots[k];
                let message = text!("\"{name}\" is attached to itself by way of other bodies", name = slot.name);
                return diagnostics.push(Diagnostic::error("body.circle", message).at(slot.span.clone()));
            }
        }
        stand[k] = Stand::Sought;
        for port in self.slots[k].layout.ports.clone() {
            for name in port.link.bodies() {
                // a body that is missing is reported where the map is made
                if let Some(body) = self.slots.iter().position(|s| s.name == name) {
                    self.place(body, stand, diagnostics);
                }
            }
        }
        match self.spin_of(k) {
            Ok(spin) => self.slots[k].spin = spin,
            Err(d) => diagnostics.push(*d),
        }
        match self.local_map(k) {
            Ok(map) => {
                self.slots[k].weight = self.local_weight(&map);
                self.slots[k].map = map;
            }
            Err(d) => diagnostics.push(*d),
        }
        stand[k] = Stand::Placed;
    }

    fn local_map(&self, k: usize) -> Result<Vec<Vec<(usize, f64)>>, Box<Diagnostic>> {
        let slot = &self.slots[k];
        let mut map = Vec::new();
        for port in &slot.layout.ports {
            let mut rows = match &port.link {
                Link::On(a) => self.point_rows(k, a)?,
                Link::Between(a, b) => {
                    if a == b {
                        return Err(Box::new(
                            Diagnostic::error("port.same", text!("\"{name}\" joins a point to itself", name = slot.name))
                                .at(slot.span.clone()),
                        ));
                    }
                    if a.body.is_some() && a.body == b.body {
                        let message = text!("\"{name}\" joins two points of one body", name = slot.name);
                        let help = text!("a bearing or shaft joins a body to another one, or to \"ground\"");
                        return Err(Box::new(Diagnostic::error("port.same", message).at(slot.span.clone()).help(help)));
                    }
                    let (mut first, second) = (self.point_rows(k, a)?, self.point_rows(k, b)?);
                    for (row, minus) in first.iter_mut().zip(second) {
                        row.extend(minus.into_iter().map(|(g, c)| (g, -c)));
                    }
                    first
                }
            };
            map.extend(port.kind.components().map(|i| std::mem::take(&mut rows[i])));
        }
        map.extend(slot.own.clone().map(|g| vec![(g, 1.0)]));
        Ok(map)
    }

    fn local_weight(&self, map: &[Vec<(usize, f64)>]) -> Vec<f64> {
        let upwards = if self.machine.axis == Axis::Vertical { DofKind::Axial } else { DofKind::VectorY };
        let moves = |&(g, _): &(usize, f64)| self.coordinates[g].dof.kind == upwards;
        if !map.iter().flatten().any(moves) {
            return Vec::new();
        }
        let share = |x: &(usize, f64)| if moves(x) { x.1 * GRAVITY } else { 0.0 };
        map.iter().map(|row| row.iter().map(share).sum()).collect()
    }
}
