//! Mass, centre of mass and moments of inertia of the bodies of a machine, from its mass matrix; liquids count in full, as if they were rigid.

use super::forces::inertia;
use crate::model::part::DofKind;
use crate::model::slot::gather;
use crate::model::system::System;
use serde::{Deserialize, Serialize};

/// Mass properties of a part, or of a body with all that it carries.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MassProperties {
    /// Slot of the body that gives the coordinates: positions are measured from its reference point.
    pub body: usize,
    /// Slot of the part; `None` of the whole body.
    pub part: Option<usize>,
    /// Mass, kg.
    pub mass: f64,
    /// Position of the centre of mass along the axis, m; NaN of a body without tilt.
    pub centre: f64,
    /// Moment of inertia about the axis, kg m^2; NaN of a body without tilt.
    pub polar: f64,
    /// Moment of inertia about an axis across it through the centre of mass, kg m^2; NaN of a body without tilt.
    pub diametral: f64,
}

/// Motions of a body as a rigid one, over the coordinates of the machine: along x, tilted about y, tilted about x.
pub(super) struct Rigid {
    pub along: Vec<f64>,
    /// Tilted about y, and about x.
    pub about_y: Option<[Vec<f64>; 2]>,
}

pub(super) fn rigid(system: &System, body: usize) -> Option<Rigid> {
    let slot = &system.slots()[body];
    let nodes = slot.part.body()?.nodes().unwrap_or_else(|| vec![0.0]);
    let (mut along, mut y, mut x) = (vec![0.0; system.n()], vec![0.0; system.n()], vec![0.0; system.n()]);
    let (mut node, mut tilts, mut moves) = (0, false, false);
    for i in slot.own.clone() {
        let z = *nodes.get(node)?;
        match system.coordinates()[i].dof.kind {
            DofKind::VectorX => (along[i], y[i], moves) = (1.0, z, true),
            DofKind::VectorY => x[i] = -z,
            DofKind::TiltX => x[i] = 1.0,
            DofKind::TiltY => (y[i], tilts) = (1.0, true),
            _ => {}
        }
        if nodes.len() > 1 && (i + 1 - slot.own.start).is_multiple_of(slot.own.len() / nodes.len()) {
            node += 1;
        }
    }
    moves.then_some(Rigid { along, about_y: tilts.then_some([y, x]) })
}

/// The bodies with coordinates of their own, each after the parts it consists of.
pub fn mass_properties(system: &System) -> Vec<MassProperties> {
    let (q, z) = (vec![0.0; system.n()], vec![0.0; system.m()]);
    let mut out = Vec::new();
    for body in (0..system.slots().len()).filter(|&k| system.slots()[k].layout.body && !system.slots()[k].own.is_empty()) {
        let Some(fields) = rigid(system, body) else { continue };
        let mut all = [0.0; 4];
        for (k, slot) in system.slots().iter().enumerate() {
            let mut locals = [Vec::new(), Vec::new(), Vec::new()];
            gather(&slot.map, &fields.along, &mut locals[0]);
            if let Some([y, x]) = &fields.about_y {
                gather(&slot.map, y, &mut locals[1]);
                gather(&slot.map, x, &mut locals[2]);
            }
            let touched = locals.iter().flatten().any(|x| *x != 0.0);
            if !touched {
                continue;
            }
            let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
            let of = |x: &[f64]| inertia(system, slot, &q, &z, x);
            let mass = dot(&locals[0], &of(&locals[0]).0);
            let mut sums = [mass, 0.0, 0.0, 0.0];
            if fields.about_y.is_some() {
                let (tilted, turning) = of(&locals[1]);
                sums = [mass, dot(&locals[0], &tilted), dot(&locals[1], &tilted), dot(&locals[2], &turning)];
            }
            let liquid = slot.part.filling().and_then(|f| f.rigid(&system.params()[slot.params.clone()]));
            if let Some([own, polar, diametral]) = liquid {
                // the mass matrix holds what moves with the body at once
                let height = if mass == 0.0 { 0.0 } else { sums[1] / mass };
                sums = [own, own * height, diametral + own * height * height, polar];
            }
            if sums.iter().all(|x| *x == 0.0) {
                continue;
            }
            all.iter_mut().zip(sums).for_each(|(a, x)| *a += x);
            out.push(properties(body, Some(k), sums, fields.about_y.is_some()));
        }
        out.push(properties(body, None, all, fields.about_y.is_some()));
    }
    out
}

fn properties(body: usize, part: Option<usize>, [mass, first, second, polar]: [f64; 4], tilts: bool) -> MassProperties {
    let known = |x: f64| if tilts { x } else { f64::NAN };
    let centre = known(first / mass);
    MassProperties { body, part, mass, centre, polar: known(polar), diametral: known(second - first * centre) }
}
