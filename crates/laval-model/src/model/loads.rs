//! Loads that deflect a machine at rest.

use super::blocks::Blocks;
use super::part::{DofKind, Physics};
use super::slot::Slot;
use super::system::{Axis, System};

impl System {
    /// The weight acts across the axis, or some part has a constant force across it: displacements of motions count from a state of rest that is not zero.
    pub fn is_loaded(&self) -> bool {
        self.machine.axis == Axis::Horizontal || self.slots().iter().any(|s| self.has_constant_force(s))
    }

    /// Blocks of a linear part at a spin speed of the machine, rad/s; `None` of other parts.
    pub fn blocks(&self, slot: &Slot, speed: f64) -> Option<Blocks<f64>> {
        if slot.physics != Physics::Linear {
            return None;
        }
        let (mut out, speed) = (Blocks::default(), slot.speed(self.params(), speed));
        out.reset_band(slot.map.len(), slot.states.len() - slot.memory, slot.reach, speed);
        slot.part.linear_f64(&self.params()[slot.params.clone()], speed, &mut out);
        Some(out)
    }

    fn has_constant_force(&self, slot: &Slot) -> bool {
        let Some(b) = self.blocks(slot, self.machine.speed.unwrap_or(0.0)) else { return false };
        let along = |row: &[(usize, f64)]| row.iter().all(|&(g, _)| self.coordinates()[g].dof.kind == DofKind::Axial);
        b.force.iter().zip(&slot.map).any(|(f, row)| *f != 0.0 && !along(row))
    }
}
