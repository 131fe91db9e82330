//! Loads of a machine: whether some deflect it at rest, and how fast others turn.

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
        (slot.physics == Physics::Linear).then(|| self.blocks_in_time(slot, speed))
    }

    /// The largest speed of a load that turns over the speed of the machine; 0 where none turns. A nonlinear part that reads its spin counts as such a load.
    pub fn fastest_load(&self) -> f64 {
        let turns = |slot: &Slot| {
            if !slot.is_linear() {
                return slot.uses.spin;
            }
            let b = self.blocks_in_time(slot, 1.0);
            let forces = [&b.force_cos, &b.force_sin, &b.spin_accel_cos, &b.spin_accel_sin];
            let rates = [&b.spin_accel_rate_cos, &b.spin_accel_rate_sin];
            forces.into_iter().chain(rates).flatten().any(|x| *x != 0.0)
        };
        let speeds = self.slots().iter().filter(|slot| turns(slot)).map(|slot| slot.speed(self.params(), 1.0).abs());
        speeds.fold(0.0, f64::max)
    }

    fn blocks_in_time(&self, slot: &Slot, speed: f64) -> Blocks<f64> {
        let (mut out, speed) = (Blocks::default(), slot.speed(self.params(), speed));
        out.reset_band(slot.map.len(), slot.states.len() - slot.memory, slot.reach, speed);
        slot.part.linear_f64(&self.params()[slot.params.clone()], speed, &mut out);
        out
    }

    fn has_constant_force(&self, slot: &Slot) -> bool {
        let Some(b) = self.blocks(slot, self.machine.speed.unwrap_or(0.0)) else { return false };
        let along = |row: &[(usize, f64)]| row.iter().all(|&(g, _)| self.coordinates()[g].dof.kind == DofKind::Axial);
        b.force.iter().zip(&slot.map).any(|(f, row)| *f != 0.0 && !along(row))
    }
}
