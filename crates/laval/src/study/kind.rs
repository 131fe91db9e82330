//! What a kind of study is: its word, its fields, and how a machine is studied with it.

use super::Context;
use super::shared::speed_range::{self, SpinSpeeds};
use super::shared::vibration::{self, Vibration};
use super::shared::{headings, size, watch};
use crate::diagnostic::{Diagnostic, Diagnostics, Span};
use crate::model::field::{Field, KindInfo, Values};
use crate::model::system::System;
use crate::outcome::{Kept, Outcome};
use crate::text;
use serde::Serialize;
use serde::de::DeserializeOwned;

/// A kind of study: its struct is the `[[study]]` block. Programs call the methods of [`ErasedStudy`] and [`TypedStudy`], which check the request first.
pub trait Study: Send + Sync + Sized + 'static {
    /// What it computes: plain data, which can be stored and reported again.
    type Result: Serialize + DeserializeOwned + Send + Sync + 'static;
    /// The word in the file.
    const KIND: &'static str;
    /// One paragraph for the documentation.
    const DOC: &'static str;
    /// Lines of a typical block beside a body named `drum`, for the documentation; where it is empty they follow from the fields.
    const EXAMPLE: &'static str = "";
    /// What may be said of it.
    const FIELDS: &'static [Field];
    /// Whether its rows are kept in chunks ([`store`](crate::store)): then several processes can compute it together.
    const IN_CHUNKS: bool = false;
    /// Whether it takes a machine of which parts turn with several spins ([`System::spins`]), or runs another study that may.
    const SEVERAL_SPINS: bool = false;
    /// Builds the study from its fields for this machine; says all that is wrong in `diagnostics`.
    fn build(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<Self>;
    /// Spin speeds at which the study needs the coefficients of the parts; none where it does not rest on the motion of the machine, or runs
    /// another study. Beyond the tables of parts a study is refused, or its findings are marked.
    fn spin_speeds(&self, system: &System) -> Vec<SpinSpeeds>;
    /// Frequencies of vibration at which it needs the coefficients of parts that are tabulated over them. A study that says nothing takes no such part, unless it
    /// needs no speeds either.
    fn vibration(&self, system: &System) -> Vibration {
        if self.spin_speeds(system).is_empty() { Vibration::Elsewhere } else { Vibration::Refused }
    }
    /// Whether this machine can answer the question at all, found out in a few milliseconds: called by `laval check`, and by a run before it begins.
    ///
    /// # Errors
    /// Why it cannot, naming the part.
    fn admit(&self, _: &System) -> Result<(), Diagnostic> {
        Ok(())
    }
    /// What a run keeps in memory, where that depends on the request alone and can be much.
    fn size(&self, _: &System) -> Option<size::Size> {
        None
    }
    /// The same before a run. What takes longer ends with the context, and is then not known: no refusal.
    ///
    /// # Errors
    /// As [`admit`](Self::admit).
    fn prepare(&self, system: &System, _: &Context) -> Result<(), Diagnostic> {
        self.admit(system)
    }
    /// Computes. What ends early is a result with that [`End`](crate::outcome::End).
    ///
    /// # Errors
    /// A request this machine cannot answer, naming the part.
    fn compute(&self, system: &System, context: &Context) -> Result<Self::Result, Diagnostic>;
    /// Tables, figures and findings of a result of [`compute`](Self::compute), in milliseconds, under the name of the study.
    ///
    /// # Errors
    /// A result that is not of this machine.
    fn report(&self, system: &System, result: &Self::Result, name: &str) -> Result<Outcome, Diagnostic>;
    /// What the first page may need of a result.
    fn keep(&self, _: Self::Result) -> Kept {
        Kept::default()
    }
    /// [`report`](Self::report) of a result that is not needed afterwards, with what [`keep`](Self::keep) keeps of it. A study whose result is mostly
    /// tables moves them here, so that they are not in memory twice.
    ///
    /// # Errors
    /// As [`report`](Self::report).
    fn conclude(&self, system: &System, result: Self::Result, name: &str) -> Result<Outcome, Diagnostic> {
        let mut outcome = self.report(system, &result, name)?;
        outcome.kept = self.keep(result);
        Ok(outcome)
    }
}

/// Running a [`Study`], with its type known or forgotten: a machine that is too large, or beyond the tables of its parts, is
/// refused, and a run ends when its context says so, wherever it is. Programs call these methods, not those of [`Study`].
pub trait ErasedStudy: Send + Sync {
    /// The word in the file.
    fn kind(&self) -> &'static str;
    /// Whether its rows are kept in chunks.
    fn in_chunks(&self) -> bool;
    /// Whether this machine can answer it.
    ///
    /// # Errors
    /// As [`Study::admit`].
    fn admit(&self, system: &System) -> Result<(), Diagnostic>;
    /// Whether this machine can answer it, before a run.
    ///
    /// # Errors
    /// As [`Study::prepare`].
    fn prepare(&self, system: &System, context: &Context) -> Result<(), Diagnostic>;
    /// Spin speeds that it covers.
    fn speeds(&self, system: &System) -> Vec<SpinSpeeds>;
    /// Runs it.
    fn run(&self, system: &System, context: &Context) -> Result<Outcome, Diagnostic>;
}

impl<T: Study> ErasedStudy for T {
    fn kind(&self) -> &'static str {
        T::KIND
    }
    fn in_chunks(&self) -> bool {
        T::IN_CHUNKS
    }
    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        speed_range::able(self, system)?;
        watch::admit(self, system)
    }
    fn prepare(&self, system: &System, context: &Context) -> Result<(), Diagnostic> {
        speed_range::able(self, system)?;
        watch::prepare(self, system, context)
    }
    fn speeds(&self, system: &System) -> Vec<SpinSpeeds> {
        self.spin_speeds(system)
    }
    fn run(&self, system: &System, context: &Context) -> Result<Outcome, Diagnostic> {
        speed_range::able(self, system)?;
        let run = || {
            let result = self.compute(system, context)?;
            self.conclude(system, result, context.name)
        };
        let mut outcome = match watch::run(self, system, context, run)? {
            Ok(outcome) => outcome,
            Err(end) => return Ok(watch::nothing_shown::<T>(context.name, end)),
        };
        speed_range::mark_beyond(self, system, &mut outcome);
        headings::name_owners(system, &mut outcome);
        Ok(outcome)
    }
}

/// Typed results of a study. They can be stored, and reported again without being computed again.
pub trait TypedStudy: Study {
    /// Computes, with the checks of [`ErasedStudy::run`].
    ///
    /// # Errors
    /// A request this machine cannot answer, or `study.stopped` where it was stopped within a computation that has no partial result.
    fn result(&self, system: &System, context: &Context) -> Result<Self::Result, Diagnostic> {
        speed_range::able(self, system)?;
        watch::run(self, system, context, || self.compute(system, context))?
            .map_err(|_| Diagnostic::error(watch::STOPPED, text!("the study was stopped within a computation that has no partial result")))
    }
    /// Tables, figures and findings of a result.
    ///
    /// # Errors
    /// As [`Study::report`].
    fn outcome(&self, system: &System, result: &Self::Result, name: &str) -> Result<Outcome, Diagnostic> {
        let mut outcome = self.report(system, result, name)?;
        speed_range::mark_beyond(self, system, &mut outcome);
        headings::name_owners(system, &mut outcome);
        Ok(outcome)
    }
}

impl<T: Study> TypedStudy for T {}

/// A kind of study: what may be said of it, and how it is built.
#[derive(Clone)]
pub struct StudyKind {
    /// Fields and documentation.
    pub info: KindInfo,
    /// Builds one from its fields; says all that is wrong.
    pub build: fn(&Values, &System, &mut Diagnostics) -> Option<Box<dyn ErasedStudy>>,
}

/// The registry entry of a study.
pub fn kind<T: Study>() -> StudyKind {
    StudyKind {
        info: KindInfo { kind: T::KIND, doc: T::DOC, example: T::EXAMPLE, fields: T::FIELDS.to_vec(), lists: Vec::new() },
        build: |values, system, diagnostics| {
            let study = T::build(values, system, diagnostics)?;
            Some(Box::new(Written { study, speeds: speed_range::place(values) }) as Box<dyn ErasedStudy>)
        },
    }
}

/// A study read from a file, with the place of its speeds there.
struct Written<T> {
    study: T,
    speeds: Option<Span>,
}

impl<T> Written<T> {
    fn located(&self, mut d: Diagnostic) -> Diagnostic {
        if (d.code == speed_range::BEYOND || d.code == vibration::BEYOND) && d.span.is_none() {
            d.span.clone_from(&self.speeds);
        }
        d
    }
}

impl<T: Study> ErasedStudy for Written<T> {
    fn kind(&self) -> &'static str {
        T::KIND
    }
    fn in_chunks(&self) -> bool {
        T::IN_CHUNKS
    }
    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        ErasedStudy::admit(&self.study, system).map_err(|d| self.located(d))
    }
    fn prepare(&self, system: &System, context: &Context) -> Result<(), Diagnostic> {
        ErasedStudy::prepare(&self.study, system, context).map_err(|d| self.located(d))
    }
    fn speeds(&self, system: &System) -> Vec<SpinSpeeds> {
        self.study.spin_speeds(system)
    }
    fn run(&self, system: &System, context: &Context) -> Result<Outcome, Diagnostic> {
        ErasedStudy::run(&self.study, system, context).map_err(|d| self.located(d))
    }
}
