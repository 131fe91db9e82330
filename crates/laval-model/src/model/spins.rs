//! Spins of a machine: with which of them its parts turn.
//!
//! A machine has a first spin and others of fixed ratios to it. Angle, speed W and acceleration of the machine are those of one of them, the first unless
//! [`Machine::spin`] names another; a spin of ratio r to that one has the angle r phase and the speed r W. A part sees the angle, speed and acceleration of its own
//! spin; the torque that it puts on that spin enters the spin row of the machine times r (virtual work).

use super::part::DofKind;
use super::slot::{Ratio, Slot};
use super::system::{Machine, System};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::text;

/// Difference of ratios that belong together, over their size.
const SAME: f64 = 1e-6;

/// A spin that parts turn with.
#[derive(Clone, Debug, PartialEq)]
pub struct OtherSpin {
    /// Name of the part that gives its ratio; none of the first spin.
    pub name: Option<String>,
    /// Its speed over that of the machine.
    pub ratio: f64,
}

impl System {
    /// The spins that parts of the machine turn with, besides the one that its speed is that of.
    pub fn spins(&self) -> Vec<OtherSpin> {
        let mut all: Vec<Ratio> = Vec::new();
        for ratio in self.slots.iter().filter(|s| turns(s)).filter_map(|s| s.ratio) {
            if !all.contains(&ratio) {
                all.push(ratio);
            }
        }
        all.into_iter().map(|r| self.other_spin(r)).collect()
    }

    /// Speeds of the machine between two others at which a part has a row of a table over its own speed, ascending.
    pub fn table_speeds(&self, from: f64, to: f64) -> Vec<f64> {
        let own = |s: &Slot| {
            let ratio = s.speed(self.params(), 1.0);
            let rows = s.part.scope().map(|scope| scope.table_speeds()).unwrap_or_default();
            rows.into_iter().map(move |w| w / ratio).filter(|w| from < *w && *w < to).collect::<Vec<f64>>()
        };
        let mut out: Vec<f64> = self.slots.iter().flat_map(own).collect();
        out.sort_by(f64::total_cmp);
        out.dedup();
        out
    }

    /// A spin by its ratio to that of the machine.
    pub fn other_spin(&self, ratio: Ratio) -> OtherSpin {
        let named = |i: usize| self.slots.iter().find(|s| s.params.contains(&i)).map(|s| s.name.clone());
        OtherSpin { name: ratio.of.and_then(named), ratio: ratio.value(&self.params) }
    }

    /// The same machine with the speed of another of its spins as its own, by the name of the part that gives its ratio.
    ///
    /// # Errors
    /// No part turns with such a spin.
    pub fn at_spin(&self, name: &str) -> Result<System, Diagnostics> {
        let spins = self.spins();
        let Some(own) = spins.iter().find(|s| s.name.as_deref() == Some(name)) else {
            let message = text!("no part of the machine turns with a spin \"{name}\"", name);
            let spins: Vec<&str> = spins.iter().filter_map(|s| s.name.as_deref()).collect();
            let help = text!("spins of this machine: {spins}", spins = spins.join(", "));
            return Err(Diagnostics(vec![Diagnostic::error("spin.missing", message).help(help)]));
        };
        let speed = self.machine.speed.map(|w| own.ratio * w);
        System::assemble(Machine { speed, spin: Some(name.to_string()), ..self.machine.clone() }, self.inputs())
    }

    /// The parameter that is the ratio of a part's spin: of the one that it names, or of the first turning body that it is attached to.
    pub(super) fn spin_of(&self, k: usize) -> Result<Option<usize>, Box<Diagnostic>> {
        let slot = &self.slots[k];
        if let Some(name) = &slot.layout.spin {
            if let Some(found) = self.named_spin(name) {
                if let Some(body) = self.turning(k).find(|b| b.spin != Some(found)) {
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
        Ok(self.turning(k).next().and_then(|s| s.spin))
    }

    fn named_spin(&self, name: &str) -> Option<usize> {
        let slot = self.slots.iter().find(|s| s.name == name)?;
        Some(slot.params.start + own_ratio(slot)?)
    }

    /// The turning bodies that a part is attached to.
    fn turning(&self, k: usize) -> impl Iterator<Item = &Slot> {
        let bodies = self.slots[k].layout.ports.iter().flat_map(|p| p.link.bodies());
        let body = |name: &str| self.slots.iter().find(|s| s.name == name);
        bodies.filter_map(body).filter(|s| s.spin.is_some() || s.part.body().is_some_and(|b| b.turns()))
    }

    /// Sets the ratios of the parts' spins to that of the machine, and refuses parts that do not join bodies of their spins.
    pub(super) fn relate_spins(&mut self, diagnostics: &mut Diagnostics) {
        let to = self.machine.spin.as_ref().and_then(|name| self.named_spin(name));
        for slot in &mut self.slots {
            slot.ratio = Some(Ratio { of: slot.spin, to }).filter(|r| r.of != r.to);
        }
        for slot in &self.slots {
            let untwisted = slot.layout.kinds().iter().zip(&slot.map).any(|(kind, row)| *kind == DofKind::Twist && row.is_empty());
            let refused = slot.part.scope().filter(|_| untwisted).and_then(|s| s.refuses_untwisted(&self.params[slot.params.clone()]));
            if let Some(message) = refused {
                let message = text!("\"{name}\": {message}", name = slot.name, message);
                diagnostics.push(Diagnostic::error("part.spins", message).at(slot.span.clone()));
            }
        }
        for (k, slot) in self.slots.iter().enumerate() {
            let mut ends = self.turning(k).map(|s| s.speed(&self.params, 1.0));
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

/// A part whose spin counts: not the one that only gives a ratio, and of parts at rest those that turn or name a spin.
fn turns(slot: &Slot) -> bool {
    own_ratio(slot).is_none() && (slot.spin.is_some() || slot.part.body().is_some_and(|b| b.turns()))
}

/// Two ratios of speeds are one, but for rounding of what a file says.
pub fn same_ratio(a: f64, b: f64) -> bool {
    (a - b).abs() <= SAME * a.abs().max(b.abs())
}
