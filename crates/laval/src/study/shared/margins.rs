//! Separation margins of API 684 (2nd edition), SP6.8.2.10, as API 617 has them: of a critical speed with amplification factor AF below the operating speeds 17 (1 - 1/(AF - 1.5)) %, at most
//! 16 %; above them 10 + 17 (1 - 1/(AF - 1.5)) %, at most 26 %; none for AF < 2.5.

use crate::model::field::{Field, FieldKind};
use crate::model::system::System;
use crate::outcome::{Arg, Finding};
use crate::study::shared::operation;

/// Field: the standard whose separation margins are assessed.
pub const STANDARD: Field = Field::optional(
    "standard",
    FieldKind::Choice(&[
        ("none", "peaks and their factors of amplification alone"),
        ("api_684", "separation margins of API 684 (SP6.8.2.10) and API 617 against the operating speeds"),
    ]),
    "none",
    "standard whose separation margins are assessed",
);

/// Amplification factor below which a response is critically damped.
pub const CRITICALLY_DAMPED: f64 = 2.5;

/// A mode of this damping ratio shows as a resonance: its amplification factor 1/(2 zeta) counts.
pub fn resonant(damping: f64) -> bool {
    2.0 * CRITICALLY_DAMPED * damping.abs() < 1.0
}

/// Separation margin that is required of a resonance, over the operating speed; NaN where the factor is not known.
pub fn required(factor: f64, below: bool) -> f64 {
    let share = 0.17 * (1.0 - 1.0 / (factor - 1.5));
    match factor {
        f if f < CRITICALLY_DAMPED => 0.0,
        f if f.is_nan() => f64::NAN,
        _ if below => share.min(0.16),
        _ => (0.1 + share).min(0.26),
    }
}

/// As [`required`] of a resonance so far from the operating speeds. Where the factor is not known but is at most so much, none below [`CRITICALLY_DAMPED`]; where nothing is known of it, the
/// largest that any factor requires, if that is kept.
pub fn required_within((factor, at_most): (f64, f64), below: bool, separation: f64) -> f64 {
    let largest = required(f64::INFINITY, below);
    match factor.is_nan() {
        true if at_most < CRITICALLY_DAMPED => 0.0,
        true if separation >= largest => largest,
        _ => required(factor, below),
    }
}

/// A resonance whose factor is not known.
#[derive(Clone, Copy, Debug)]
pub struct Open {
    /// Its speed, rad/s.
    pub speed: f64,
    /// Distance from the operating speeds, over the nearest.
    pub separation: f64,
    /// It lies below them.
    pub below: bool,
    /// Half-power points may lie beyond the ends of the range.
    pub by_range: bool,
}

/// That the margins are not decided, and what the nearest of the open resonances lacks; none is open where the study was stopped.
pub fn undecided(open: impl Iterator<Item = Open>) -> Finding {
    let finding = Finding::warning("separation_margin", "forced-response-margin-unknown");
    match open.min_by(|a, b| a.separation.total_cmp(&b.separation)) {
        None => finding.arg("reason", Arg::word("stopped")),
        Some(o) => finding
            .arg("reason", Arg::word(if o.by_range { "range" } else { "neighbour" }))
            .of("of the nearest resonance whose amplification factor is not known")
            .value_as(Arg::percent(o.separation))
            .arg("resonance", Arg::speed(o.speed))
            .arg("required", Arg::percent(required(f64::INFINITY, o.below))),
    }
}

/// Operating speeds, rad/s: amounts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Speeds {
    /// Lowest.
    pub low: f64,
    /// Highest.
    pub high: f64,
}

impl Speeds {
    /// Those of `[operation]`, else that of the machine; none at standstill.
    pub fn of(system: &System) -> Option<Self> {
        let own = system.machine.speed.filter(|w| *w != 0.0);
        let (a, b) = operation::among(&system.machine.extras).speed.or(own.map(|w| (w, w)))?;
        Some(Speeds { low: a.abs().min(b.abs()), high: a.abs().max(b.abs()) })
    }

    /// A speed is below them.
    pub fn is_above(&self, speed: f64) -> bool {
        speed.abs() < self.low
    }

    /// Distance of a speed from the nearest of them, over that; 0 among them.
    pub fn separation(&self, speed: f64) -> f64 {
        let w = speed.abs();
        if w < self.low {
            (self.low - w) / self.low
        } else if w > self.high {
            (w - self.high) / self.high
        } else if w.is_nan() {
            f64::NAN
        } else {
            0.0
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn margins_are_those_of_the_standard() {
        assert_eq!(required(2.4999, true), 0.0);
        // AF = 2.5 is the first that counts: 17 (1 - 1/1) = 0 below, 10 % above
        assert_eq!((required(2.5, true), required(2.5, false)), (0.0, 0.1));
        assert!((required(5.0, true) - 0.17 * (1.0 - 1.0 / 3.5)).abs() < 1e-15);
        assert!((required(5.0, false) - (0.1 + 0.17 * (1.0 - 1.0 / 3.5))).abs() < 1e-15);
        // the caps act from 17 (1 - 1/(AF - 1.5)) = 16 on, AF = 18.5
        assert!(required(18.4, true) < 0.16 && required(18.6, true) == 0.16);
        assert!(required(18.4, false) < 0.26 && required(18.6, false) == 0.26);
        assert!(required(f64::NAN, true).is_nan() && required(f64::INFINITY, false) == 0.26);
        // a bound decides alone below 2.5
        let nan = f64::NAN;
        assert_eq!([required_within((nan, 2.49), false, 0.0), required_within((2.5, 1.0), false, 0.0)], [0.0, 0.1]);
        assert!(required_within((nan, 2.5), true, 0.1).is_nan() && required_within((nan, nan), true, nan).is_nan());
        // far away the factor does not matter
        assert_eq!([required_within((nan, nan), true, 0.161), required_within((nan, 3.0), false, 0.27)], [0.16, 0.26]);
        assert!(required_within((nan, nan), false, 0.25).is_nan());
        assert!(resonant(0.199) && resonant(-0.1) && !resonant(0.201) && !resonant(nan));
        let s = Speeds { low: 800.0, high: 1000.0 };
        assert_eq!([s.separation(600.0), s.separation(900.0), s.separation(-1200.0)], [0.25, 0.0, 0.2]);
        assert!(s.separation(f64::NAN).is_nan());
    }
}
