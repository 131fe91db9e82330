//! Spectra along a motion in time: over frequency (waterfall) and over orders of the spin, forward and backward parts apart.
//!
//! Equations: the motion `z = x + i y` of a body from its place of rest is cut into windows of length T that overlap by half. Over frequency
//! `c(w) = 2/N sum h_j z_j e^(-i w t_j)` with Hann's window h, N samples and w a multiple of 2 pi/T; over orders
//! `c(k) = sum h(p_j) W_j z_j e^(-i k p_j) / sum h(p_j) W_j` with the spin angle p and the spin speed W = dp/dt: the integral over the angle, so that an order stays
//! one line while the speed changes. A circular part of amplitude a has a line of height a; positive frequencies and orders turn with the rotor.
//!
//! Symbols: t time; p spin angle; W spin speed; k order, frequency over W; T length of a window; turns of the rotor in it.
//!
//! Validity: two parts are distinguished when they differ by more than four lines of frequency, `8 pi/T`, or by the order 4/turns; between two lines of frequency a height
//! falls by at most 15 %. Parts beyond four times the highest order fold back. Windows of fewer than four turns have no orders.
//!
//! Theory: `docs/theory/motion-in-time.md#spectra`.
//!
//! Sources: F. J. Harris, Proc. IEEE 66 (1978) 51 (windows); P. Goldman and A. Muszynska, J. Eng. Gas Turbines Power 121 (1999) 524 (full spectrum).

mod analyse;
mod natural;
mod report;

use super::record::MotionRecord;
use super::start::Start;
use super::turns::{merged, separated};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Bounds, Field, FieldKind, Values};
use crate::model::system::{Station, System};
use crate::outcome::Outcome;
use crate::solve::motion::Motion;
use crate::solve::motion::trajectory::Trajectory;
use crate::text;
use analyse::Record;
pub use analyse::{Part, Window};
pub use natural::NaturalFrequency;
pub(in crate::study) use natural::natural;
use std::f64::consts::TAU;

/// `waterfall`.
pub(in crate::study) const WATERFALL: Field = Field::optional(
    "waterfall",
    FieldKind::Text,
    "",
    "body whose spectra are wanted, over frequency and over orders of the spin, forward and backward parts apart",
);
/// `spectra`.
pub(in crate::study) const SPECTRA: Field = Field::optional(
    "spectra",
    FieldKind::Integer { min: 2, max: 1000 },
    "60",
    "with a waterfall: number of spectra, from windows that overlap by half",
);
/// `highest_order`.
pub(in crate::study) const HIGHEST_ORDER: Field = Field::optional(
    "highest_order",
    FieldKind::Quantity { unit: "", bounds: Bounds::closed(0.5, 64.0) },
    "4",
    "with a waterfall: highest order; its frequency at the largest speed is the highest frequency",
);
/// `component_threshold`.
pub(in crate::study) const THRESHOLD: Field = Field::optional(
    "component_threshold",
    FieldKind::Quantity { unit: "m", bounds: Bounds::positive(1.0) },
    "",
    "with a waterfall: amplitude from which parts other than the synchronous one are reported; a hundredth of the largest line unless given",
);

/// Samples of the highest frequency.
const OVERSAMPLING: f64 = 8.0;
/// Least samples of a window.
const LEAST: usize = 64;
/// Most samples of a record.
const MOST: usize = 1 << 20;

/// The request.
#[derive(Clone, Debug)]
pub(in crate::study) struct Spectra {
    /// The body.
    body: Station,
    /// Number of windows.
    count: usize,
    /// Highest order.
    highest: f64,
    /// Amplitude from which parts are reported, m.
    threshold: Option<f64>,
    /// Length of the record, s.
    duration: f64,
    /// Largest spin speed, rad/s.
    fastest: f64,
    /// Samples of a window: a power of two.
    samples: usize,
}

impl Spectra {
    /// From the fields, for a record of this length (s) and largest spin speed (rad/s); says all that is wrong.
    pub fn read(values: &Values, system: &System, (duration, fastest): (f64, f64), diagnostics: &mut Diagnostics) -> Option<Spectra> {
        let name = values.text("waterfall").filter(|n| !n.is_empty())?;
        let bodies = system.stations();
        let Some(body) = bodies.iter().find(|b| b.name == name) else {
            let known = bodies.iter().map(|b| format!("\"{}\"", b.name)).collect::<Vec<_>>().join(", ");
            let help =
                if known.is_empty() { text!("no body of this machine moves across the axis") } else { text!("there is {known}", known) };
            let message = text!("there is no body \"{name}\"", name);
            diagnostics.push(Diagnostic::error("spectra.body", message).at(values.span_of("waterfall")).about(name).help(help));
            return None;
        };
        let count = values.integer("spectra").map_or(60, |x| x.clamp(2, 1000) as usize);
        let highest = values.number("highest_order").unwrap_or(4.0);
        let length = 2.0 * duration / (count + 1) as f64;
        let wanted = OVERSAMPLING * highest * fastest / TAU * length;
        let total = 0.5 * wanted * (count + 1) as f64;
        if !(total <= MOST as f64) {
            let message = text!(
                "spectra up to order {highest} of this record need {total} samples, which are too many",
                highest,
                total = text::number(total, 3)
            );
            let help = text!("at most {most}: lower highest_order, or follow a shorter motion", most = MOST);
            diagnostics.push(Diagnostic::error("spectra.samples", message).at(values.span_of("waterfall")).help(help));
            return None;
        }
        let samples = (wanted.ceil() as usize).max(LEAST).next_power_of_two();
        Some(Spectra { body: body.clone(), count, highest, threshold: values.number("component_threshold"), duration, fastest, samples })
    }

    /// Samples from the start of a window to that of the next.
    fn hop(&self) -> usize {
        self.samples / 2
    }

    fn times(&self) -> impl Iterator<Item = f64> + '_ {
        let last = self.hop() * (self.count + 1);
        (0..=last).map(move |j| if j == last { self.duration } else { self.duration * j as f64 / last as f64 })
    }

    /// The times of these outputs and of the samples, each once, rising.
    pub fn with_outputs(&self, outputs: &[f64]) -> Vec<f64> {
        merged(self.times(), outputs)
    }

    /// Takes the samples out of a trajectory, which keeps the outputs requested besides: the spectra of the whole windows.
    pub fn taken(&self, motion: &Motion, start: &Start, trajectory: &mut Trajectory, outputs: &[f64]) -> Vec<Window> {
        let mut record = Record::default();
        // of the machine that moves, which may be a reduced one
        let stations = motion.system().stations();
        let lateral = stations.iter().find(|s| s.name == self.body.name).map_or(&self.body.lateral, |s| &s.lateral);
        let rest = lateral.of(&start.rest);
        separated(trajectory, self.times(), outputs, |t, y| {
            let at = lateral.of(y);
            record.push(t, motion.spin(t, y), (at[0] - rest[0], at[1] - rest[1]))
        });
        analyse::windows(self, &record)
    }

    /// Adds tables, figures and findings of spectra.
    ///
    /// # Errors
    /// A table that contradicts itself.
    pub fn report(&self, record: &MotionRecord, outcome: Outcome) -> Result<Outcome, Diagnostic> {
        report::report(self, &record.spectra, &record.natural, outcome)
    }
}
