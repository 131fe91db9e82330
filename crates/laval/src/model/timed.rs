//! The machine for motions in time: parts that are exact in the frequency domain only by their rational time forms.

use super::part::{Physics, TimeForm};
use super::system::System;
use crate::diagnostic::{Diagnostic, Diagnostics};
use std::ops::Deref;

/// The spin speeds, rad/s, of motions in time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Speeds {
    /// This one.
    One(f64),
    /// Several, each constant.
    Several,
    /// It changes.
    Changing,
}

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
        let mut inputs = self.inputs();
        let mut any = false;
        for (slot, input) in self.slots().iter().zip(&mut inputs) {
            let Physics::Frequency(TimeForm::None(why)) = slot.physics else { continue };
            let no = |why: &str| {
                Diagnostic::error("motion.no_time_form", format!("\"{}\" has no form in the time domain: {why}", slot.name))
                    .at(slot.span.clone())
                    .help("use a study in the frequency domain, such as forced_response")
            };
            input.part = slot.part.timed(&input.params, speeds).ok_or_else(|| no(why))?.map_err(|e| no(&e))?;
            any = true;
        }
        if !any {
            return Ok(Timed::Own(self));
        }
        System::assemble(self.machine.clone(), inputs).map(|s| Timed::Fitted(Box::new(s))).map_err(Diagnostics::into_error)
    }
}
