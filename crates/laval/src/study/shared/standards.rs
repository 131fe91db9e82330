//! Limits of standards on balance and on the vibration of shafts and housings.
//!
//! Balance quality grade G = e_per W (ISO 21940-11:2016, 6.2, formerly ISO 1940-1): of a rotor of mass m that is balanced as a rigid body, at its highest service speed W,
//!
//! ```text
//! U_per = G m/W,   U_per,A = U_per L_B/L,   U_per,B = U_per L_A/L        L_A, L_B distances of the planes from the centre of mass, L between them      (7.2)
//! ```
//!
//! at most 0.7 and at least 0.3 of U_per where the centre of mass lies between the planes, at most 1.3 and at least 0.3 where it lies outside.
//!
//! Vibration of the shaft relative to its bearing, peak to peak in µm, at a speed of n revolutions per minute:
//!
//! ```text
//! ISO 7919-3:2009, annex A: zones A/B 4800/sqrt(n), B/C 9000/sqrt(n), C/D 13200/sqrt(n); n from 1000 to 30 000
//! API 617: 25.4 sqrt(12000/n), at most 25.4
//! ```
//!
//! Vibration of bearing housings, root mean square (ISO 20816-3:2022, formerly ISO 10816-3:2009, annex A): boundaries of velocity and of displacement, whichever is reached first; machines
//! above 15 kW, 120 to 15 000 revolutions per minute.
//!
//! Validity: one frequency, that of the spin; broad-band vibration, run-out and changes of vibration are not assessed. Zones are for coupled industrial machines with fluid-film bearings.

use crate::model::field::{Field, FieldKind};
use std::f64::consts::PI;

/// Grades of ISO 21940-11:2016, table 1.
const GRADES: &[(&str, &str)] = &[
    ("G0.4", "0.4 mm/s: gyroscopes, spindles of high-precision systems"),
    ("G1", "1 mm/s: grinding-machine drives, tape drives"),
    ("G2.5", "2.5 mm/s: compressors, gas and steam turbines, machine-tool drives, fast electric motors"),
    ("G6.3", "6.3 mm/s: centrifuges and separators, fans, pumps, gears, general machinery"),
    ("G16", "16 mm/s: drive shafts, crushers, agricultural machinery"),
    ("G40", "40 mm/s: car wheels, wheel rims, crankshaft drives balanced in themselves"),
    ("G100", "100 mm/s: complete reciprocating engines of cars and locomotives"),
    ("G250", "250 mm/s: crankshaft drives not balanced in themselves, rigidly mounted"),
    ("G630", "630 mm/s: crankshaft drives of large four-stroke engines"),
    ("G1600", "1600 mm/s: crankshaft drives of large slow engines, elastically mounted"),
    ("G4000", "4000 mm/s: crankshaft drives of large slow engines, rigidly mounted"),
];

/// Field: the balance quality grade.
pub const BALANCE_GRADE: Field = Field::optional(
    "balance_grade",
    FieldKind::Choice(GRADES),
    "",
    "balance quality grade of ISO 21940-11: the unbalance of every rotor, and its share in the planes of two bearings, is assessed at the highest operating speed",
);

/// Field: the standard of shaft vibration.
pub const SHAFT_VIBRATION: Field = Field::optional(
    "shaft_vibration",
    FieldKind::Choice(&[
        ("iso_7919_3", "zones A to D of ISO 7919-3 (coupled industrial machines with fluid-film bearings, 1000 to 30 000 rpm)"),
        ("api_617", "API 617: 25.4 µm times the square root of 12 000 rpm over the speed, at most 25.4 µm"),
    ]),
    "",
    "standard whose limits on the vibration of the shaft relative to its bearings, peak to peak, are assessed over the operating speeds",
);

/// Groups and supports of ISO 20816-3: word, meaning, boundaries of velocity (mm/s) and of displacement (µm), root mean square.
type HousingClass = (&'static str, &'static str, [f64; 3], [f64; 3]);
const HOUSINGS: [HousingClass; 4] = [
    (
        "group_1_rigid",
        "above 300 kW, or electrical with a shaft height of 315 mm and more; rigid supports",
        [2.3, 4.5, 7.1],
        [29.0, 57.0, 90.0],
    ),
    ("group_1_flexible", "the same on flexible supports", [3.5, 7.1, 11.0], [45.0, 90.0, 140.0]),
    (
        "group_2_rigid",
        "15 to 300 kW, or electrical with a shaft height of 160 to 315 mm; rigid supports",
        [1.4, 2.8, 4.5],
        [22.0, 45.0, 71.0],
    ),
    ("group_2_flexible", "the same on flexible supports", [2.3, 4.5, 7.1], [37.0, 71.0, 113.0]),
];

/// Field: the group of machines whose limits of housing vibration are assessed.
pub const HOUSING_VIBRATION: Field = Field::optional(
    "housing_vibration",
    FieldKind::Choice(&[
        (HOUSINGS[0].0, HOUSINGS[0].1),
        (HOUSINGS[1].0, HOUSINGS[1].1),
        (HOUSINGS[2].0, HOUSINGS[2].1),
        (HOUSINGS[3].0, HOUSINGS[3].1),
    ]),
    "",
    "group of ISO 20816-3 whose zones A to D for the vibration of bearing housings are assessed over the operating speeds: of bodies that bearings stand on",
);

/// The grade that a word means, m/s.
pub fn grade(word: &str) -> Option<f64> {
    word.strip_prefix('G')?.parse::<f64>().ok().map(|g| 1e-3 * g)
}

/// The word of a grade.
pub fn grade_word(grade: f64) -> &'static str {
    GRADES.iter().map(|g| g.0).find(|w| self::grade(w) == Some(grade)).unwrap_or("G")
}

/// `U_per`, kg m.
pub fn permissible(grade: f64, mass: f64, speed: f64) -> f64 {
    grade * mass / speed.abs()
}

/// Shares of `U_per` in two planes at these positions.
pub fn allocated(total: f64, centre: f64, [a, b]: [f64; 2]) -> [f64; 2] {
    let length = b - a;
    let shares = [(b - centre) / length, (centre - a) / length];
    let inside = shares.iter().all(|s| *s >= 0.0);
    let most = if inside { 0.7 } else { 1.3 };
    shares.map(|s| total * s.abs().clamp(0.3, most))
}

/// Standard of vibration, of the shaft or of housings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VibrationStandard {
    /// Zones of ISO 7919-3.
    Zones,
    /// Limit of API 617.
    Api617,
    /// Zones of ISO 20816-3, by number of the class.
    Housing(usize),
}

/// Where a vibration lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Zone {
    /// As of new machines; of API 617: kept.
    A,
    /// Unrestricted long-term operation.
    B,
    /// Limited operation, until it can be remedied.
    C,
    /// Damage is to be expected; of API 617: exceeded.
    D,
}

impl Zone {
    /// Its letter.
    pub fn word(self) -> &'static str {
        ["A", "B", "C", "D"][self as usize]
    }
}

impl VibrationStandard {
    /// By its word.
    pub fn of(word: &str) -> Option<Self> {
        match word {
            "iso_7919_3" => Some(VibrationStandard::Zones),
            "api_617" => Some(VibrationStandard::Api617),
            _ => HOUSINGS.iter().position(|h| h.0 == word).map(VibrationStandard::Housing),
        }
    }

    /// Its word.
    pub fn word(self) -> &'static str {
        match self {
            VibrationStandard::Zones => "iso_7919_3",
            VibrationStandard::Api617 => "api_617",
            VibrationStandard::Housing(class) => HOUSINGS[class].0,
        }
    }

    /// It is for what bearings stand on, and not for the shaft in them.
    pub fn is_of_housings(self) -> bool {
        matches!(self, VibrationStandard::Housing(_))
    }

    /// It has zones A to D.
    pub fn has_zones(self) -> bool {
        self != VibrationStandard::Api617
    }

    /// It holds at a speed, rad/s.
    pub fn covers(self, speed: f64) -> bool {
        let (low, high) = match self {
            VibrationStandard::Zones => (1000.0, 30_000.0),
            VibrationStandard::Api617 => return speed != 0.0,
            VibrationStandard::Housing(_) => (120.0, 15_000.0),
        };
        (low - 1e-6..=high + 1e-6).contains(&rpm(speed))
    }

    /// Boundaries at a speed (rad/s), m peak to peak at the frequency of the spin: of the zones A/B, B/C, C/D; of API 617 the limit alone.
    pub fn boundaries(self, speed: f64) -> Vec<f64> {
        let n = rpm(speed);
        match self {
            VibrationStandard::Zones => [4800e-6, 9000e-6, 13_200e-6].map(|x| x / n.sqrt()).to_vec(),
            VibrationStandard::Api617 => vec![25.4e-6 * (12_000.0 / n).sqrt().min(1.0)],
            VibrationStandard::Housing(class) => {
                let (_, _, velocity, displacement) = HOUSINGS[class];
                let rms = velocity.iter().zip(displacement).map(|(v, d)| (1e-3 * v / speed.abs()).min(1e-6 * d));
                rms.map(|x| PEAK_TO_PEAK * x).collect()
            }
        }
    }

    /// The vibration up to which operation is unrestricted, m peak to peak.
    pub fn limit(self, speed: f64) -> f64 {
        let all = self.boundaries(speed);
        all[all.len() / 2]
    }

    /// Where a vibration (m peak to peak) lies.
    pub fn zone(self, speed: f64, vibration: f64) -> Zone {
        let above = self.boundaries(speed).iter().filter(|b| !(vibration <= **b)).count();
        match self {
            VibrationStandard::Api617 if above == 0 => Zone::A,
            VibrationStandard::Api617 => Zone::D,
            _ => [Zone::A, Zone::B, Zone::C, Zone::D][above],
        }
    }
}

/// Peak to peak of a sine over its root mean square.
const PEAK_TO_PEAK: f64 = 2.0 * std::f64::consts::SQRT_2;

/// The velocity, root mean square, of a displacement peak to peak at the frequency of a speed, m/s.
pub fn rms_velocity(speed: f64, peak_to_peak: f64) -> f64 {
    speed.abs() * peak_to_peak / PEAK_TO_PEAK
}

fn rpm(speed: f64) -> f64 {
    speed.abs() * 30.0 / PI
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(a: f64, b: f64) {
        assert!((a - b).abs() < 1e-12 * b.abs(), "{a} {b}");
    }

    #[test]
    fn grades() {
        assert!(GRADES.iter().all(|g| grade(g.0).is_some_and(|x| grade_word(x) == g.0)));
        // e_per = 2.5 mm/s/(314.159 rad/s) = 7.96 um at 3000 rpm
        near(permissible(2.5e-3, 1000.0, 100.0 * PI), 2.5 / (100.0 * PI));
        let shares = |centre: f64| allocated(1.0, centre, [0.0, 1.0]);
        assert_eq!(shares(0.5), [0.5, 0.5]);
        assert!(shares(0.4).iter().zip([0.6, 0.4]).all(|(a, b)| (a - b).abs() < 1e-15));
        // near one bearing; outside both
        assert_eq!([shares(0.1), shares(0.9)], [[0.7, 0.3], [0.3, 0.7]]);
        assert_eq!([shares(1.2), shares(2.0)], [[0.3, 1.2], [1.0, 1.3]]);
    }

    #[test]
    fn zones() {
        let w = |n: f64| n * PI / 30.0;
        let iso = VibrationStandard::Zones;
        // 3600 rpm: 80, 150, 220 um
        iso.boundaries(w(3600.0)).iter().zip([80e-6, 150e-6, 220e-6]).for_each(|(a, b)| near(*a, b));
        let at = |x: f64| iso.zone(w(3600.0), x * 1e-6);
        assert_eq!([at(79.0), at(81.0), at(151.0), at(221.0), at(f64::NAN)], [Zone::A, Zone::B, Zone::C, Zone::D, Zone::D]);
        near(iso.limit(w(3600.0)), 150e-6);
        assert!(iso.covers(w(-1000.0)) && iso.covers(w(30_000.0)) && !iso.covers(w(990.0)) && !iso.covers(w(31_000.0)));
        let api = VibrationStandard::Api617;
        near(api.limit(w(6000.0)), 25.4e-6);
        near(api.limit(w(12_000.0)), 25.4e-6);
        near(api.limit(w(48_000.0)), 12.7e-6);
        assert_eq!([api.zone(w(48_000.0), 12e-6), api.zone(w(48_000.0), 13e-6)], [Zone::A, Zone::D]);
    }

    /// Velocity counts above the frequency at which both boundaries of a class meet, displacement below.
    #[test]
    fn housings() {
        let w = |n: f64| n * PI / 30.0;
        let class = VibrationStandard::of("group_1_rigid").unwrap();
        let velocity = |n: f64| class.boundaries(w(n)).iter().map(|x| 1e3 * rms_velocity(w(n), *x)).collect::<Vec<_>>();
        velocity(3000.0).iter().zip([2.3, 4.5, 7.1]).for_each(|(a, b)| near(*a, b));
        class.boundaries(w(300.0)).iter().zip([29e-6, 57e-6, 90e-6]).for_each(|(a, b)| near(*a, 2.0 * 2f64.sqrt() * b));
        assert!(class.covers(w(120.0)) && class.covers(w(15_000.0)) && !class.covers(w(110.0)) && !class.covers(w(15_100.0)));
        for (k, (word, _, v, d)) in HOUSINGS.iter().enumerate() {
            assert_eq!(VibrationStandard::of(word), Some(VibrationStandard::Housing(k)));
            // a sine of 12.5 Hz for group 1, of 10 Hz for group 2, within the rounding of the table
            let meet = if k < 2 { 12.5 } else { 10.0 };
            v.iter().zip(d).for_each(|(v, d)| assert!((1e3 * v / d / (2.0 * PI) / meet - 1.0).abs() < 0.02, "{word} {v} {d}"));
        }
    }
}
