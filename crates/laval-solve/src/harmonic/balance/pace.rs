//! How fast a motion repeats and how fast the rotor turns meanwhile.
//!
//! Under unbalance the two belong together: the base frequency is the spin speed over the subharmonic divisor. A free motion (a whirl that nobody
//! forces) repeats at a frequency of its own: the linear parts are then condensed at `s = i k frequency` with their coefficients at `speed`.

use serde::{Deserialize, Serialize};

/// A parameter of the machine that derivatives are taken in; both halves of a lateral pair may move together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Parameter {
    /// Index of the first among the machine's parameters.
    pub first: usize,
    /// How many, one after the other.
    pub count: usize,
}

impl Parameter {
    /// 1 for a parameter that moves, 0 for others: its derivative.
    pub fn rate(self, index: usize) -> f64 {
        f64::from(u8::from((self.first..self.first + self.count).contains(&index)))
    }
}

/// Spin speed, base frequency and drive of a periodic motion, and their derivatives in the parameter that is followed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pace {
    /// Spin speed, rad/s.
    pub speed: f64,
    /// Base frequency, rad/s: signed, a negative one turns vectors of positive order backward.
    pub frequency: f64,
    /// Drive xi, 1/s: a force `xi M q'` on all masses of linear parts, which keeps a damped machine whirling.
    pub drive: f64,
    /// Derivatives of speed, frequency and drive.
    pub rate: [f64; 3],
    /// The parameter followed is one of the machine, while speed, frequency and drive stand still.
    pub parameter: Option<Parameter>,
}

impl Pace {
    /// Under unbalance, with the speed as the parameter.
    pub fn forced(speed: f64, divisor: usize) -> Pace {
        let divisor = divisor as f64;
        Pace { speed, frequency: speed / divisor, drive: 0.0, rate: [1.0, 1.0 / divisor, 0.0], parameter: None }
    }

    /// Relative derivative of the base frequency: what rates grow by with the harmonics fixed.
    pub fn stretch(&self) -> f64 {
        if self.frequency == 0.0 { 0.0 } else { self.rate[1] / self.frequency }
    }
}
