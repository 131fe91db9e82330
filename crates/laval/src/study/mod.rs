//! Studies: what is asked of a machine. This file is the registry: the only place that names them all.

mod approximation;
pub mod backbone;
mod balance;
pub mod basins;
pub mod bifurcation_loci;
pub mod campbell;
pub mod criterion;
pub mod critical_speeds;
mod drive;
pub mod duty;
pub mod forced_response;
mod free_motion;
mod growing;
mod history;
pub mod limit_cycles;
pub mod limits;
pub mod methods;
pub mod modes;
pub mod motion_map;
mod moved_roots;
pub mod nonlinear_response;
pub mod operating_window;
pub mod optimum;
mod passages;
mod play;
mod region;
pub mod response_map;
pub mod run_up;
pub mod sensitivity;
pub mod separation;
mod settled;
mod sights;
mod size;
mod spectra;
pub mod speed_range;
pub mod stability_map;
mod start;
pub mod stationary;
pub mod support;
pub mod sweep;
pub mod transient;
mod turns;
pub mod uncertainty;
mod unstable;
mod validity;
mod watch;

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{BlockInfo, Extra, Field, KindInfo, Values};
use crate::model::part::Part;
use crate::model::system::{Machine, PartInput, System};
use crate::model::timed::{Speeds, Timed};
use crate::outcome::{End, Outcome, significant};
use crate::separation::carried::Cups;
use crate::store::{Host, Keep};
use laval_num::work;
pub use laval_num::work::Cancel;
use std::cell::Cell;
use std::sync::LazyLock;
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};

/// Told how far a study is.
pub trait Progress: Sync {
    /// `done` of `total` units of work (`total` 0: unknown).
    fn report(&self, done: u64, total: u64);
    /// `done` of `total` are there from an earlier run; they say nothing of the rate.
    fn restored(&self, done: u64, total: u64) {
        self.report(done, total);
    }
    /// Of the units under way, how much is done: 2.5 when five of them are half done. Where single units take long.
    fn part(&self, _units: f64) {}
    /// How large the work is, in words, before it begins.
    fn job(&self, _text: &str) {}
    /// A remark that the outcome does not hold, because it does not depend on it.
    fn note(&self, _text: &str) {}
}

/// No progress display.
pub struct Silent;
impl Progress for Silent {
    fn report(&self, _: u64, _: u64) {}
}

/// What surrounds a running study.
#[derive(Clone, Copy)]
pub struct Context<'a> {
    /// Name of the study in the file.
    pub name: &'a str,
    /// Set to stop: the study ends at its next step and returns what it has.
    pub cancel: &'a Cancel,
    /// Progress display.
    pub progress: &'a dyn Progress,
    /// Most steps (integration steps, continuation points, grid points) before the study ends by itself; it also ends when these have cost
    /// [`STEP`] units of [work](laval_num::work) each on average.
    pub work_limit: u64,
    /// Where a long study keeps its rows; `None` keeps them in memory.
    pub keep: Option<&'a Keep>,
}

/// Units of work that a step of a work limit may cost on average, some 0.1 s.
pub const STEP: u64 = 100_000_000;

/// A time form that takes longer is worth a word.
const LONG: Duration = Duration::from_secs(1);

static NEVER: LazyLock<Cancel> = LazyLock::new(Cancel::default);

impl Context<'static> {
    /// Runs to the end, silently.
    pub fn quiet(name: &'static str) -> Self {
        Context { name, cancel: &NEVER, progress: &Silent, work_limit: u64::MAX, keep: None }
    }
}

impl Context<'_> {
    /// The user asked to stop.
    pub fn cancelled(&self) -> bool {
        self.cancel.load(Ordering::Relaxed)
    }

    /// Says how large the work is before it begins, where it is large: `count` of `what`, from `large` on.
    pub fn announce(&self, count: f64, large: f64, what: &str) {
        // a count that is no number is worth a word, too
        if !(count < large) {
            self.progress.job(&format!("{} {what}", significant(count, 3)));
        }
    }

    /// May a study go on that has done so much work?
    pub fn goes_on(&self, done: u64) -> bool {
        !self.cancelled() && done < self.work_limit && work::spent() < self.work_limit.saturating_mul(STEP)
    }

    /// The end of a study that did all it was asked, or stopped because [`goes_on`](Self::goes_on) said no.
    pub fn end(&self, complete: bool) -> End {
        match (complete, self.cancelled()) {
            (true, _) => End::Reached,
            (false, true) => End::Cancelled,
            (false, false) => End::WorkLimit,
        }
    }
}

impl Context<'_> {
    /// The machine for motions in time; `None` when cancelled. Says so where making it takes long.
    ///
    /// # Errors
    /// As [`System::timed`].
    pub(crate) fn timed<'a>(&self, system: &'a System, speeds: Speeds) -> Result<Option<Timed<'a>>, Diagnostic> {
        let (begun, said) = (Instant::now(), Cell::new(false));
        let stop = || {
            if !said.get() && begun.elapsed() > LONG {
                said.set(true);
                let names: Vec<String> = system.without_time_form().map(|slot| format!("\"{}\"", slot.name)).collect();
                self.progress.job(&format!("making the time form of {}", names.join(", ")));
            }
            self.cancelled()
        };
        system.timed_until(speeds, &stop)
    }
}

impl Host for Context<'_> {
    fn keep(&self) -> Option<&Keep> {
        self.keep
    }
    fn cancelled(&self) -> bool {
        Context::cancelled(self)
    }
    fn report(&self, done: u64, total: u64) {
        self.progress.report(done, total);
    }
    fn restored(&self, done: u64, total: u64) {
        self.progress.restored(done, total);
    }
    fn part(&self, rows: f64) {
        self.progress.part(rows);
    }
    fn note(&self, text: &str) {
        self.progress.note(text);
    }
    fn most_rows(&self) -> u64 {
        self.work_limit
    }
}

/// A kind of study: its struct is the `[[study]]` block.
pub trait Study: Send + Sync + Sized + 'static {
    /// The word in the file.
    const KIND: &'static str;
    /// One paragraph for the documentation.
    const DOC: &'static str;
    /// Lines of a typical block beside a body named `drum`, for the documentation; where it is empty they follow from the fields.
    const EXAMPLE: &'static str = "";
    /// What may be said of it.
    const FIELDS: &'static [Field];
    /// It rests on the motion of the machine at its spin speeds, and so on parts that are known at some speeds only.
    const TURNS: bool = true;

    /// Lowest and highest spin speed of a request, rad/s, where they are not those of its fields `speed`, `from`, `to` and `programme`.
    fn speeds(_: &Values, _: &System) -> Option<(f64, f64)> {
        None
    }

    /// Builds the study from its fields for this machine; says all that is wrong in `diagnostics`.
    fn build(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<Self>;
    /// Whether this machine can answer the question at all, found out in a few milliseconds: `laval check` asks it, and so does a run before it begins.
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
    /// Runs it. An error is a request this machine cannot answer; a computation that ends early is an outcome with that [`End`](crate::outcome::End).
    fn run(&self, system: &System, context: &Context) -> Result<Outcome, Diagnostic>;
}

/// A study with its type forgotten; it ends when its context says so, wherever it is.
pub trait ErasedStudy: Send + Sync {
    /// The word in the file.
    fn kind(&self) -> &'static str;
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
    /// Runs it.
    fn run(&self, system: &System, context: &Context) -> Result<Outcome, Diagnostic>;
}

impl<T: Study> ErasedStudy for T {
    fn kind(&self) -> &'static str {
        T::KIND
    }
    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        watch::admit(self, system)
    }
    fn prepare(&self, system: &System, context: &Context) -> Result<(), Diagnostic> {
        watch::prepare(self, system, context)
    }
    fn run(&self, system: &System, context: &Context) -> Result<Outcome, Diagnostic> {
        watch::run(self, system, context)
    }
}

/// A kind of study: what may be said of it, and how it is built.
#[derive(Clone)]
pub struct StudyKind {
    /// Fields and documentation.
    pub info: KindInfo,
    /// Builds one from its fields; says all that is wrong.
    pub build: fn(&Values, &System, &mut Diagnostics) -> Option<Box<dyn ErasedStudy>>,
}

/// All kinds of studies.
pub fn registry() -> Vec<StudyKind> {
    vec![
        kind::<modes::Modes>(),
        kind::<campbell::Campbell>(),
        kind::<critical_speeds::CriticalSpeeds>(),
        kind::<stability_map::StabilityMap>(),
        kind::<forced_response::ForcedResponse>(),
        kind::<nonlinear_response::NonlinearResponse>(),
        kind::<bifurcation_loci::BifurcationLoci>(),
        kind::<response_map::ResponseMap>(),
        kind::<stationary::Stationary>(),
        kind::<sensitivity::Sensitivity>(),
        kind::<backbone::Backbone>(),
        kind::<limit_cycles::LimitCycles>(),
        kind::<methods::Methods>(),
        kind::<transient::Transient>(),
        kind::<run_up::RunUp>(),
        kind::<separation::Separation>(),
        kind::<operating_window::OperatingWindow>(),
        kind::<sweep::Sweep>(),
        kind::<motion_map::MotionMap>(),
        kind::<basins::Basins>(),
        kind::<uncertainty::Uncertainty>(),
        kind::<optimum::Optimum>(),
    ]
}

/// A block of the file that studies read beside the parts, and what is wrong with one.
pub struct BlockKind {
    /// Word, kinds, fields.
    pub info: BlockInfo,
    /// Says what is wrong with a block of this machine.
    pub check: fn(&Extra, &System, &mut Diagnostics),
    /// The part of the machine that a sound block is.
    pub part: fn(&Extra, &System) -> Option<PartInput>,
    /// Points of bodies that it names, whose displacement counts: body and height above its reference point, m.
    pub points: fn(&Extra, &System) -> Vec<(String, f64)>,
}

/// All blocks beside parts and studies.
pub fn blocks() -> Vec<BlockKind> {
    let one = |word, doc, example, fields: &[Field]| BlockInfo {
        word,
        several: false,
        kinds: vec![KindInfo { kind: word, doc, example, fields: fields.to_vec() }],
    };
    let cups = BlockInfo { word: "cup", several: true, kinds: duty::cup_kinds() };
    let none = |_: &Extra, _: &System| None;
    let nowhere = |_: &Extra, _: &System| Vec::new();
    vec![
        BlockKind { info: cups, check: duty::check_cup, part: duty::cup_part, points: nowhere },
        BlockKind {
            info: one("suspension", duty::SUSPENSION_DOC, duty::SUSPENSION_EXAMPLE, duty::SUSPENSION),
            check: duty::check_suspension,
            part: none,
            points: nowhere,
        },
        BlockKind {
            info: one("limits", limits::DOC, limits::EXAMPLE, limits::FIELDS),
            check: limits::check,
            part: none,
            points: limits::points,
        },
    ]
}

/// The machine with the parts that its blocks are and the points that they name, in place of what they were before.
///
/// # Errors
/// As [`System::assemble`].
pub fn with_blocks(system: System) -> Result<System, Diagnostics> {
    let (known, extras) = (blocks(), &system.machine.extras);
    let kind = |e: &Extra| known.iter().find(|k| k.info.word == e.word);
    let parts: Vec<PartInput> = extras.iter().filter_map(|e| (kind(e)?.part)(e, &system)).collect();
    let mut points: Vec<(String, f64)> = extras.iter().filter_map(|e| Some((kind(e)?.points)(e, &system))).flatten().collect();
    points.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    points.dedup();
    let mut inputs = system.inputs();
    let before = inputs.len();
    // a part of the file may have the name of a block
    inputs.retain(|i| i.part.kind() != <Cups as Part>::KIND);
    if parts.is_empty() && inputs.len() == before && points == system.machine.points {
        return Ok(system);
    }
    inputs.extend(parts);
    System::assemble(Machine { points, ..system.machine }, inputs)
}

/// The registry entry of a study.
pub fn kind<T: Study>() -> StudyKind {
    StudyKind {
        info: KindInfo { kind: T::KIND, doc: T::DOC, example: T::EXAMPLE, fields: T::FIELDS.to_vec() },
        build: |values, system, diagnostics| {
            let study = T::build(values, system, diagnostics)?;
            Some(Box::new(speed_range::Ranged::new(study, values, system)) as Box<dyn ErasedStudy>)
        },
    }
}
