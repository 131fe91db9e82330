//! Parts that are exact in the frequency domain only, and another part takes their place in motions.

use super::super::params::{Parametric, Params};
use crate::text::Text;

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

/// Why there is no time form.
#[derive(Clone, Debug, PartialEq)]
pub enum Untimed {
    /// There is none.
    No {
        /// Why.
        why: Text,
        /// What may be done about it; studies in the frequency domain unless given.
        help: Option<Text>,
    },
    /// Cancelled.
    Stopped,
}

impl From<Text> for Untimed {
    fn from(why: Text) -> Self {
        Untimed::No { why, help: None }
    }
}

/// A time form in the place of an exact part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fitted {
    /// Its largest relative error.
    pub error: f64,
    /// For which motions that is so, as a phrase: `of motions that ...`.
    pub scope: &'static str,
    /// Growth or decay over the speed from which on it holds.
    pub margin: f64,
    /// Internal states.
    pub states: usize,
}

/// A part in the frequency domain without time form of its own that can be replaced by a rational one for motions in time.
pub trait ReplacedInTime: Parametric {
    /// The same part with a rational form for motions at such speeds, as linear blocks, or why there is none for them; `None` where it
    /// needs none. It stands for the part in motions only, never in spectra. `stop` cancels: nothing is remembered of an unfinished form.
    fn timed(&self, p: &Params<Self, f64>, speeds: Speeds, stop: &dyn Fn() -> bool) -> Option<Result<Self, Untimed>>;
    /// Error of the form that this part is.
    fn fitted(&self) -> Option<Fitted>;
}
