//! Spins of a machine: with which of them its parts turn.
//!
//! A machine has one spin, of angle phase and speed W, and others of fixed ratios to it: angle r phase, speed r W. A part sees the angle, speed and acceleration of
//! its own spin; the torque that it puts on that spin enters the spin row of the machine times r (virtual work).

use super::slot::Slot;
use super::system::System;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::text;

/// Difference of ratios that belong together, over their size.
const SAME: f64 = 1e-6;

impl System {
    /// The parameter that is the ratio of a part's spin: of the one that it names, or of the first turning body that it is attached to.
    pub(super) fn spin_of(&self, k: usize) -> Result<Option<usize>, Box<Diagnostic>> {
        let slot = &self.slots[k];
        if let Some(name) = &slot.layout.spin {
            let ratio = |s: &Slot| Some(s.params.start + own_ratio(s)?);
            if let Some(found) = self.slots.iter().find(|s| &s.name == name).and_then(ratio) {
                if let Some(body) = self.turning(k).find(|b| b.ratio != Some(found)) {
                    let message =
                        text!("\"{slot}\" is fixed to \"{body}\", which turns with another spin", slot = slot.name, body = body.name);
                    let help =
                        text!("leave spin out: it turns with that body; or give it coordinates of its own and a bearing between the two");
                    return Err(Box::new(Diagnostic::error("spin.fixed", message).at(slot.span.clone()).help(help)));
                }
                return Ok(Some(found));
            }
            let spins: Vec<&str> = self.slots.iter().filter(|s| own_ratio(s).is_some()).map(|s| s.name.as_str()).collect();
            let help = if spins.is_empty() {
                text!("add a part of kind = \"speed_ratio\" with this name and its ratio to the speed of the machine")
            } else {
                text!("spins of this machine: {spins}", spins = spins.join(", "))
            };
            let message = text!("\"{slot}\" turns with the spin \"{name}\", which does not exist", slot = slot.name, name);
            return Err(Box::new(Diagnostic::error("spin.missing", message).at(slot.span.clone()).help(help)));
        }
        Ok(self.turning(k).next().and_then(|s| s.ratio))
    }

    /// The part that gives the ratio of a spin, and the ratio.
    pub fn spin(&self, parameter: usize) -> Option<(&Slot, f64)> {
        Some((self.slots.iter().find(|s| s.params.contains(&parameter))?, self.params[parameter]))
    }

    /// The same machine with another of its spins as the one that its speed is that of, by the name of the part that gives its ratio.
    ///
    /// # Errors
    /// No part turns with such a spin.
    pub fn at_spin(&self, name: &str) -> Result<System, Diagnostics> {
        let unknown = || {
            let spins: Vec<&str> = self.spins().iter().filter_map(|&i| Some(self.spin(i)?.0.name.as_str())).collect();
            let message = text!("no part of the machine turns with a spin \"{name}\"", name);
            let help = text!("spins of this machine: {spins}", spins = spins.join(", "));
            Diagnostics(vec![Diagnostic::error("spin.missing", message).help(help)])
        };
        let known = self.spins().into_iter().find(|&i| self.spin(i).is_some_and(|s| s.0.name == name));
        let first = known.ok_or_else(unknown)?;
        let ratio = self.params[first];
        let mut out = System::assemble(self.machine.clone(), self.inputs())?;
        out.machine.speed = out.machine.speed.map(|w| ratio * w);
        for i in self.spins() {
            out.params[i] = if i == first { 1.0 / ratio } else { self.params[i] / ratio };
        }
        for slot in out.slots.iter_mut().filter(|s| own_ratio(s).is_none()) {
            slot.ratio = match slot.ratio {
                None => Some(first),
                Some(i) => Some(i).filter(|i| *i != first),
            };
        }
        Ok(out)
    }

    /// The turning bodies that a part is attached to.
    fn turning(&self, k: usize) -> impl Iterator<Item = &Slot> {
        let bodies = self.slots[k].layout.ports.iter().flat_map(|p| p.link.bodies());
        let body = |name: &str| self.slots.iter().find(|s| s.name == name);
        bodies.filter_map(body).filter(|s| s.ratio.is_some() || s.part.body().is_some_and(|b| b.turns()))
    }

    /// Refuses parts that do not join bodies of their spins.
    pub(super) fn check_spins(&self, diagnostics: &mut Diagnostics) {
        let factor = |s: &Slot| s.ratio.map_or(1.0, |i| self.params[i]);
        for (k, slot) in self.slots.iter().enumerate() {
            let mut ends = self.turning(k).map(factor);
            let (Some(first), Some(second)) = (ends.next(), ends.next()) else { continue };
            if let Some(message) = slot.part.scope().and_then(|s| s.refuses_ratio(&self.params[slot.params.clone()], second / first)) {
                let message = text!("\"{name}\": {message}", name = slot.name, message);
                diagnostics.push(Diagnostic::error("part.spins", message).at(slot.span.clone()));
            }
        }
    }
}

/// The index among its parameters of the ratio of a part that is a spin.
fn own_ratio(slot: &Slot) -> Option<usize> {
    slot.part.scope()?.spin_ratio()
}

/// Two ratios of speeds are one, but for rounding of what a file says.
pub fn same_ratio(a: f64, b: f64) -> bool {
    (a - b).abs() <= SAME * a.abs().max(b.abs())
}
