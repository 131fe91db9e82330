//! The machine for motions in time: parts that are exact in the frequency domain only by their rational time forms.

use super::part::{Physics, TimeForm};
use super::system::{Slot, System};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::text;
use crate::text::{Argument, Text};
use std::ops::Deref;

pub use super::capability::time_form::{Speeds, Untimed};

/// A machine of which every part has a time form.
pub enum Timed<'a> {
    /// As it is.
    Own(&'a System),
    /// With time forms in the places of some parts.
    Fitted(Box<System>),
}

impl Deref for Timed<'_> {
    type Target = System;
    fn deref(&self) -> &System {
        match self {
            Timed::Own(system) => system,
            Timed::Fitted(system) => system,
        }
    }
}

impl System {
    /// The machine for motions in time at such speeds. Spectra and responses are those of the machine itself.
    ///
    /// # Errors
    /// A part that has no time form.
    pub fn timed(&self, speeds: Speeds) -> Result<Timed<'_>, Diagnostic> {
        Ok(self.timed_until(speeds, &|| false)?.unwrap_or(Timed::Own(self)))
    }

    /// Parts that must be replaced for that.
    pub fn without_time_form(&self) -> impl Iterator<Item = &Slot> {
        self.slots().iter().filter(|slot| matches!(slot.physics, Physics::Frequency(TimeForm::None(_))))
    }

    /// The same; `None` when `stop`, which is polled now and then, said so.
    ///
    /// # Errors
    /// As [`timed`](Self::timed).
    pub fn timed_until(&self, speeds: Speeds, stop: &dyn Fn() -> bool) -> Result<Option<Timed<'_>>, Diagnostic> {
        let mut inputs = self.inputs();
        let mut any = false;
        for (slot, input) in self.slots().iter().zip(&mut inputs) {
            let Physics::Frequency(TimeForm::None(why)) = slot.physics else { continue };
            let no = |why: text::Arg, help: Option<Text>| {
                Diagnostic::error("motion.no_time_form", text!("\"{name}\" has no form in the time domain: {why}", name = slot.name, why))
                    .at(slot.span.clone())
                    .help(help.unwrap_or_else(|| text!("use a study in the frequency domain, such as forced_response")))
            };
            let form = slot.part.replaced_in_time().and_then(|r| r.timed(&input.params, speeds, stop));
            input.part = match form.ok_or_else(|| no(text::term(why), None))? {
                Ok(part) => part,
                Err(Untimed::No { why, help }) => return Err(no(why.argument(), help)),
                Err(Untimed::Stopped) => return Ok(None),
            };
            any = true;
        }
        if !any {
            return Ok(Some(Timed::Own(self)));
        }
        System::assemble(self.machine.clone(), inputs).map(|s| Some(Timed::Fitted(Box::new(s)))).map_err(Diagnostics::into_error)
    }
}
