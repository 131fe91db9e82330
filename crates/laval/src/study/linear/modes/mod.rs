//! Natural modes at one spin speed: growth, frequency, damping, direction of whirl and shape.
//!
//! Equations: `E x' = A x` over coordinates, rates and internal states, linearised about rest (fixed axes) or about a state that turns with the
//! rotor (rotating axes); every root s is then solved for again on the exact characteristic function, `det T(s) = 0`.
//!
//! Symbols: s = growth + i frequency, 1/s and rad/s; damping ratio = -growth/|s|; growth above 0 is unstable.
//!
//! Validity: small motions about the state; constant speed.
//!
//! Sources: standard linear theory; forward and backward parts in `docs/theory/linear-vibration.md#modes-and-whirl-direction`.

mod along;
mod findings;
mod report;
mod shapes;

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Bounds, Field, FieldKind, Values};
use crate::model::part::Frozen;
use crate::model::probe::Probe;
use crate::model::system::System;
use crate::outcome::{End, Kept, Outcome};
use crate::solve::characteristic::{Characteristic, Equilibrium};
use crate::solve::exact::growing;
use crate::solve::own_frequency::{self, OwnModes};
use crate::solve::pencil::{MachineMode, Spectrum, holds_fit, modes_about};
use crate::solve::roots::{Request, Roots, in_region, roots};
use crate::study::linear::over_frequency::over_frequency;
use crate::study::shared::region;
use crate::study::shared::speed_range::SpinSpeeds;
use crate::study::shared::support::{ABOUT, About, SPEED, admit_roots, admit_threshold, held, speed};
use crate::study::shared::vibration::Vibration;
use crate::study::{Context, Study};
use crate::text;
use serde::{Deserialize, Serialize};
pub use shapes::Shapes;

/// See the [module](self).
#[derive(Clone)]
pub struct Modes {
    /// Spin speed, rad/s.
    pub speed: f64,
    /// State linearised about.
    pub about: About,
    /// Growth above which a mode counts as unstable, 1/s.
    pub threshold: f64,
    /// Largest frequency at which roots of a machine with parts without time form are looked for, rad/s.
    pub frequency: Option<f64>,
}

/// Modes about a state.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct ModesResult {
    /// State linearised about.
    pub about: Equilibrium,
    /// Modes by frequency, with their shapes.
    pub spectrum: Spectrum,
    /// Of a machine with parts that have no time form: its roots, and where they were counted.
    pub roots: Option<Roots>,
    /// How every point of a machine with several moves in each mode.
    pub shapes: Option<Shapes>,
    /// Number of growing roots by the argument principle, of a machine that holds the fit of a part.
    pub growing: Option<usize>,
    /// Of a machine with coefficients over the frequency of vibration: its modes, each with those of its own frequency.
    pub own: Option<OwnModes>,
    /// How the study ended.
    pub end: End,
}

impl Modes {
    /// Modes with the coefficients of their own frequency.
    fn own(&self, system: &System, about: Equilibrium, context: &Context) -> Result<ModesResult, Diagnostic> {
        let range = own_frequency::range(system, &about, self.frequency)?;
        let own = own_frequency::own_modes(system, &about, range, &[], &mut |done| context.goes_on(done))?;
        let modes: Vec<MachineMode> = own.modes.iter().map(|m| m.mode.clone()).collect();
        let shapes = Shapes::of(system, &modes);
        let spectrum = Spectrum { polished: modes.len(), modes, ..Spectrum::default() };
        let end = context.end(own.complete);
        Ok(ModesResult { about, spectrum, roots: None, shapes, growing: None, own: Some(own), end })
    }
}

/// Terms of series that are worth a word beforehand: a count takes seconds.
const SERIES: f64 = 150.0;

/// Field: growth above which a mode counts as unstable.
pub(in crate::study) const THRESHOLD: Field = Field::optional(
    "growth_threshold",
    FieldKind::Quantity { unit: "1/s", bounds: Bounds::within(1e6) },
    "0 1/s",
    "growth rate above which a mode is called unstable",
);

/// What a probe measures of a mode: semi-major axis of its orbit.
pub(in crate::study) fn amplitude(mode: &MachineMode, probe: &Probe) -> f64 {
    let [x, y] = probe.amplitudes(&mode.q);
    let (f, b) = crate::solve::sectors::circular(x, y);
    f.abs() + b.abs()
}

impl Study for Modes {
    type Result = ModesResult;
    const KIND: &'static str = "modes";
    const EXAMPLE: &'static str = r#"speed = "3000 rpm"
"#;
    const DOC: &'static str = "Natural modes at one spin speed: growth rate, frequency, damping ratio, direction of whirl, how much each body \
        takes part, and the shape along the axis of a machine with several points. about = \"turning\" linearises about the state that turns with the rotor. Of a bearing in a table over the frequency of vibration every mode has the coefficients of its own frequency.";
    const SEVERAL_SPINS: bool = true;
    const FIELDS: &'static [Field] =
        &[Field::optional("speed", SPEED, "", "spin speed; the machine's when left out"), ABOUT, THRESHOLD, region::FREQUENCY_LIMIT];

    fn build(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        let speed = speed(values, system, diagnostics)?;
        let threshold = values.number("growth_threshold").unwrap_or(0.0);
        Some(Modes { speed, about: About::read(values), threshold, frequency: values.number("frequency_limit") })
    }

    fn spin_speeds(&self, _: &System) -> Vec<SpinSpeeds> {
        vec![SpinSpeeds::one(self.speed)]
    }

    fn vibration(&self, _: &System) -> Vibration {
        Vibration::Own
    }

    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        admit_roots(system, self.about, self.speed)?;
        admit_threshold(system, self.speed, self.threshold)
    }

    fn compute(&self, system: &System, context: &Context) -> Result<ModesResult, Diagnostic> {
        admit_threshold(system, self.speed, self.threshold)?;
        if over_frequency(system) {
            admit_roots(system, self.about, self.speed)?;
            return self.own(system, self.about.find(system, self.speed, None)?, context);
        }
        let about = self.about.find(system, self.speed, None)?;
        let roots = if in_region(system) {
            let terms: usize = system.domains(self.speed).iter().map(|d| d.terms).sum();
            context.announce(terms as f64, SERIES, text!("terms of series in every evaluation of the function whose roots are counted"));
            let request = Request {
                margin: self.threshold,
                frequency: self.frequency,
                cancel: Some(context.cancel),
                alone: true,
                ..Request::default()
            };
            Some(roots(system, &about, &request)?)
        } else {
            None
        };
        let spectrum = match &roots {
            Some(roots) => roots.spectrum.clone(),
            None => modes_about(system, &about, true)?,
        };
        let growing =
            if roots.is_none() && holds_fit(system) { growing(&mut Characteristic::new(system, &about), &spectrum) } else { None };
        let shapes = Shapes::of(system, &spectrum.modes);
        Ok(ModesResult { about, spectrum, roots, shapes, growing, own: None, end: context.end(!context.cancelled()) })
    }

    fn report(&self, system: &System, result: &ModesResult, name: &str) -> Result<Outcome, Diagnostic> {
        // findings about masses and other parts do not depend on the frequency
        let held = held(system, Frozen::At(result.own.as_ref().map_or(0.0, |o| 0.5 * (o.range.0 + o.range.1))))?;
        report::Shown::new(self, held.as_ref().unwrap_or(system), result).outcome(name, system)
    }

    fn keep(&self, result: Self::Result) -> Kept {
        Kept::of(self.clone(), result)
    }
}

/// Directions of whirl as classes of figures.
pub(in crate::study) const WHIRLS: &[&str] = &["forward", "backward", "mixed", "axial", "torsional", "none"];
