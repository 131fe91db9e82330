//! The machine with the coefficients of one frequency of vibration at all of them.
//!
//! A bearing in a table over the frequency of vibration nu is known at steady vibration alone. In the unbalance response nu is the spin speed W, in a mode it is the
//! frequency of the mode itself. With nu held the machine is an ordinary linear one, with finitely many modes and exact derivatives:
//!
//! ```text
//! F = -K(W, nu) d - C(W, nu) d',   nu = const.  or  nu = r |W|
//! ```
//!
//! Theory: `docs/theory/machine.md#linear-bearings`.

use super::part::{Frozen, Tabulated};
use super::system::{Slot, System};
use crate::diagnostic::Diagnostics;

impl System {
    /// The parts in a table over the frequency of vibration, with the frequencies of the table.
    pub fn over_frequency(&self) -> impl Iterator<Item = (&Slot, Tabulated)> {
        self.slots().iter().filter_map(|s| Some((s, s.part.frequency_domain()?.frequencies()?)))
    }

    /// The machine whose parts in a table over the frequency of vibration have the coefficients of one frequency; an order is that of the speed of the machine.
    /// `None` where no part is such.
    ///
    /// # Errors
    /// As [`System::assemble`].
    pub fn frozen(&self, at: Frozen) -> Option<Result<System, Diagnostics>> {
        self.over_frequency().next()?;
        let mut inputs = self.inputs();
        for (slot, input) in self.slots().iter().zip(&mut inputs) {
            let own = match at {
                Frozen::At(frequency) => Frozen::At(frequency.abs()),
                // its speed may be that of another spin
                Frozen::Order(order) => Frozen::Order((order / slot.speed(self.params(), 1.0)).abs()),
            };
            if let Some(part) = slot.part.frequency_domain().and_then(|f| f.frozen(own)) {
                input.part = part;
            }
        }
        Some(System::assemble(self.machine.clone(), inputs))
    }
}
