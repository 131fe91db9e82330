//! Axis ticks: steps of 1, 2, 5 on linear axes; decades, with a minor grid, on logarithmic ones, lengths each with its own prefix: 100 µm, 1 mm.

use crate::language::Language;
use crate::outcome::{significant, unit_text};
use laval_num::order::SortByNumber;

const SMALLEST: f64 = 1e-280;
const LARGEST: f64 = 1e280;

/// Positions and labels of the ticks of one axis.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Ticks {
    pub major: Vec<(f64, String)>,
    pub minor: Vec<f64>,
}

/// An axis in its display unit, ready to map values to 0..1.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct AxisView {
    pub label: String,
    pub unit: String,
    pub log: bool,
    pub lo: f64,
    pub hi: f64,
    /// Power of ten taken out of the tick labels and written once in the title.
    pub exponent: i32,
    /// Without numbers.
    pub bare: bool,
    /// Names at places instead of numbers.
    pub names: Vec<(f64, String)>,
    /// Linear nearer to zero than this, logarithmic beyond; 0 for none.
    pub knee: f64,
    /// Writes the numbers and units.
    pub language: Language,
}

impl AxisView {
    pub fn new(label: &str, unit: &str, log: bool, lo: f64, hi: f64) -> Self {
        // numbers beyond these have no power of ten that could be taken out
        let (lo, hi) = (lo.clamp(-LARGEST, LARGEST), hi.clamp(-LARGEST, LARGEST));
        let (lo, hi) = match (log, lo.abs().max(hi.abs()) < SMALLEST) {
            (false, true) => (-SMALLEST, SMALLEST),
            (true, _) => (lo.max(SMALLEST), hi.max(10.0 * SMALLEST)),
            _ => (lo, hi),
        };
        let size = lo.abs().max(hi.abs());
        let exponent = if !log && size > 0.0 && !(1e-3..1e5).contains(&size) { (size.log10() / 3.0).floor() as i32 * 3 } else { 0 };
        let (label, unit, language) = (label.into(), unit.into(), Language::English);
        AxisView { label, unit, log, lo, hi, exponent, bare: false, names: Vec::new(), knee: 0.0, language }
    }

    /// Place of a value between the ends: 0 at `lo`, 1 at `hi`; NaN for a value that the axis cannot show.
    pub fn place(&self, v: f64) -> f64 {
        if !v.is_finite() {
            return f64::NAN;
        }
        if self.knee > 0.0 {
            let at = |v: f64| (v / self.knee).asinh();
            (at(v) - at(self.lo)) / (at(self.hi) - at(self.lo))
        } else if self.log {
            if v > 0.0 { (v / self.lo).ln() / (self.hi / self.lo).ln() } else { f64::NAN }
        } else {
            (v - self.lo) / (self.hi - self.lo)
        }
    }

    /// Label, power of ten and unit: `force [10³ N]`.
    pub fn title(&self) -> String {
        let power = if self.exponent == 0 { String::new() } else { significant(10f64.powi(self.exponent), 1) };
        let power = if (1..6).contains(&self.exponent) { "10³".into() } else { power };
        // logarithmic lengths carry their units at the ticks
        let own = self.log && metres(&self.unit).is_some();
        let unit = if own { "".into() } else { self.language.unit(&unit_text(&self.unit)) };
        match (power.is_empty(), unit.is_empty()) {
            (true, true) => self.label.clone(),
            (true, false) => format!("{} [{unit}]", self.label),
            (false, true) => format!("{} [{power}]", self.label),
            (false, false) => format!("{} [{power} {unit}]", self.label),
        }
    }

    /// At most about `most` labelled ticks.
    pub fn ticks(&self, most: usize) -> Ticks {
        if self.bare {
            return Ticks { major: Vec::new(), minor: Vec::new() };
        }
        if !self.names.is_empty() {
            let inside = |n: &&(f64, String)| (self.lo..=self.hi).contains(&n.0);
            return Ticks { major: self.names.iter().filter(inside).cloned().collect(), minor: Vec::new() };
        }
        let mut ticks = self.numbers(most);
        ticks.major.iter_mut().for_each(|t| t.1 = self.language.unit(&self.language.number(&t.1)));
        ticks
    }

    fn numbers(&self, most: usize) -> Ticks {
        if self.knee > 0.0 {
            both_sides(self, most)
        } else if self.unit == "°" && !self.log && self.hi - self.lo > 80.0 && self.exponent == 0 {
            degrees(self.lo, self.hi, most)
        } else if self.log {
            log(self.lo, self.hi, most, metres(&self.unit))
        } else {
            linear(self.lo, self.hi, most, self.exponent)
        }
    }
}

fn linear(lo: f64, hi: f64, most: usize, exponent: i32) -> Ticks {
    // at least three labels, else the scale cannot be read
    let inside = |s: f64| (hi / s + 1e-6).floor() - (lo / s - 1e-6).ceil() + 1.0;
    let mut steps = (most..most + 6).map(|m| step(hi - lo, m));
    let step = steps.find(|s| inside(*s) >= 3.0).unwrap_or_else(|| step(hi - lo, most));
    let decimals = (-(step / 10f64.powi(exponent)).log10() - 1e-9).ceil().clamp(0.0, 12.0) as usize;
    let (first, last) = ((lo / step - 1e-6).ceil() as i64, (hi / step + 1e-6).floor() as i64);
    let major = (first..=last.min(first + 100))
        .map(|k| {
            let v = k as f64 * step;
            (v, fixed(v / 10f64.powi(exponent), decimals))
        })
        .collect();
    Ticks { major, minor: Vec::new() }
}

/// Angles: multiples of parts of a turn.
fn degrees(lo: f64, hi: f64, most: usize) -> Ticks {
    let fits = |s: &f64| (hi - lo) / s <= most.max(2) as f64;
    let step =
        [15.0, 30.0, 45.0, 90.0, 180.0].into_iter().find(fits).unwrap_or_else(|| 360.0 * ((hi - lo) / 360.0 / most.max(2) as f64).ceil());
    let (first, last) = ((lo / step - 1e-6).ceil() as i64, (hi / step + 1e-6).floor() as i64);
    Ticks { major: (first..=last.min(first + 100)).map(|k| (k as f64 * step, fixed(k as f64 * step, 0))).collect(), minor: Vec::new() }
}

/// Zero, and powers of ten on both sides of it, from the knee on; a linear scale where these are too few.
fn both_sides(axis: &AxisView, most: usize) -> Ticks {
    let (lo, hi, knee) = (axis.lo, axis.hi, axis.knee);
    let largest = lo.abs().max(hi.abs());
    let decades = (knee.log10() - 1e-9).ceil() as i32..=(largest.log10() + 1e-9).floor() as i32;
    let room = 1.0 / (most as f64 + 2.0);
    let mut major: Vec<(f64, String)> = Vec::new();
    let label = |v: f64, d: i32| if (-3..=5).contains(&d) { fixed(v, (-d).max(0) as usize) } else { significant(v, 3) };
    let mut put = |v: f64, d: i32, room: f64| {
        let apart = |t: &(f64, String)| (axis.place(t.0) - axis.place(v)).abs() >= room;
        if (lo..=hi).contains(&v) && major.iter().all(apart) {
            major.push((v, label(v, d)));
        }
    };
    put(0.0, 0, room);
    for sign in [-1.0, 1.0] {
        for d in decades.clone().rev() {
            put(sign * 10f64.powi(d), d, room);
        }
    }
    for (m, d) in [2.0, 5.0].into_iter().flat_map(|m| decades.clone().map(move |d| (m, d))) {
        put(m * 10f64.powi(d), d, 1.5 * room);
        put(-m * 10f64.powi(d), d, 1.5 * room);
    }
    if major.len() < 3 {
        return linear(lo, hi, most, 0);
    }
    major.sort_by_number(|a| a.0);
    let all = decades.flat_map(|d| (2..=9).flat_map(move |m| [-1.0, 1.0].map(|s| s * m as f64 * 10f64.powi(d))));
    let minor = all.filter(|v| (lo..=hi).contains(v) && !major.iter().any(|t| t.0 == *v)).collect();
    Ticks { major, minor }
}

fn step(span: f64, most: usize) -> f64 {
    let raw = span / most.max(1) as f64;
    let power = 10f64.powf(raw.log10().floor());
    [1.0, 2.0, 5.0, 10.0].into_iter().map(|m| m * power).find(|s| *s >= raw * (1.0 - 1e-9)).unwrap_or(10.0 * power)
}

fn fixed(v: f64, decimals: usize) -> String {
    let text = format!("{:.decimals$}", v.abs());
    if v < 0.0 && text.bytes().any(|b| b.is_ascii_digit() && b != b'0') { format!("−{text}") } else { text }
}

/// Power of ten of a unit of length in m.
fn metres(unit: &str) -> Option<i32> {
    LENGTHS.iter().find(|l| l.1 == unit).map(|l| l.0)
}

/// Units of length, largest first.
const LENGTHS: [(i32, &str); 4] = [(0, "m"), (-3, "mm"), (-6, "µm"), (-9, "nm")];

/// The unit of length in which `10^d` m is read.
fn length_unit(d: i32) -> (i32, &'static str) {
    *LENGTHS.iter().find(|l| d >= l.0).unwrap_or(&LENGTHS[3])
}

/// `m 10^d` m in the unit in which it is read: `200 µm`.
fn length(m: i32, d: i32) -> String {
    let (power, unit) = length_unit(d);
    let r = d - power;
    let number = if (-3..=5).contains(&r) { fixed(m as f64 * 10f64.powi(r), (-r).max(0) as usize) } else { significant_power(m, r) };
    format!("{number} {unit}")
}

fn log(lo: f64, hi: f64, most: usize, metres: Option<i32>) -> Ticks {
    let plain = lo >= 0.9e-3 && hi <= 1.2e5;
    let label = |m: i32, d: i32| {
        let v = m as f64 * 10f64.powi(d);
        if let Some(unit) = metres {
            length(m, d + unit)
        } else if plain {
            fixed(v, (-d).max(0) as usize)
        } else {
            significant_power(m, d)
        }
    };
    let (a, b) = (lo.log10(), hi.log10());
    let inside = |v: f64| v >= lo * (1.0 - 1e-9) && v <= hi * (1.0 + 1e-9);
    let decades = (a.floor() as i32)..=(b.ceil() as i32);
    let at = |ms: &[i32]| -> Vec<(i32, i32, f64)> {
        let all = decades.clone().flat_map(|d| ms.iter().map(move |m| (*m, d, *m as f64 * 10f64.powi(d))));
        all.filter(|t| inside(t.2)).collect()
    };
    let powers = at(&[1]);
    let fine = at(&[1, 2, 5]);
    if fine.len() < 3 {
        let Some(own) = metres else { return linear(lo, hi, most, 0) };
        let (power, unit) = length_unit((hi.log10() + 1e-9).floor() as i32 + own);
        let size = 10f64.powi(own - power);
        let shown = linear(lo * size, hi * size, most, 0).major;
        return Ticks { major: shown.into_iter().map(|(v, l)| (v / size, format!("{l} {unit}"))).collect(), minor: Vec::new() };
    }
    if powers.len() < 3 && fine.len() <= most + 1 {
        let minor = at(&[1, 2, 3, 4, 5, 6, 7, 8, 9]).into_iter().map(|t| t.2).filter(|v| !fine.iter().any(|f| f.2 == *v)).collect();
        return Ticks { major: fine.iter().map(|t| (t.2, label(t.0, t.1))).collect(), minor };
    }
    let stride = powers.len().div_ceil(most.max(1)).max(1) as i32;
    let (major, rest): (Vec<_>, Vec<_>) = powers.into_iter().partition(|t| t.1.rem_euclid(stride) == 0);
    let minor = if stride == 1 { at(&[2, 3, 4, 5, 6, 7, 8, 9]) } else { rest };
    Ticks { major: major.iter().map(|t| (t.2, label(t.0, t.1))).collect(), minor: minor.into_iter().map(|t| t.2).collect() }
}

fn significant_power(m: i32, d: i32) -> String {
    let power = match d {
        0 => return m.to_string(),
        1 => return (m * 10).to_string(),
        _ => format!("10{}", superscript(d)),
    };
    if m == 1 { power } else { format!("{m}·{power}") }
}

fn superscript(n: i32) -> String {
    unit_text(&format!("^{n}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(lo: f64, hi: f64, log: bool, most: usize) -> Vec<String> {
        of("N", lo, hi, log, most)
    }
    fn of(unit: &str, lo: f64, hi: f64, log: bool, most: usize) -> Vec<String> {
        AxisView::new("a", unit, log, lo, hi).ticks(most).major.into_iter().map(|t| t.1).collect()
    }

    #[test]
    fn linear_steps_are_1_2_5() {
        assert_eq!(labels(0.0, 1.0, false, 5), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        assert_eq!(labels(-3.0, 3.0, false, 6), ["−3", "−2", "−1", "0", "1", "2", "3"]);
        assert_eq!(labels(0.0, 8000.0, false, 5), ["0", "2000", "4000", "6000", "8000"]);
        assert_eq!(labels(25.0, 130.0, false, 4), ["40", "60", "80", "100", "120"]);
        assert_eq!(labels(-450.0, 450.0, false, 3), ["−400", "−200", "0", "200", "400"]);
    }

    #[test]
    fn large_and_small_numbers_share_a_power() {
        let axis = AxisView::new("amplitude", "m", false, 0.0, 3.2e-5);
        assert_eq!(axis.title(), "amplitude [10⁻⁶ m]");
        assert_eq!(axis.ticks(4).major.last().unwrap().1, "30");
        assert_eq!(AxisView::new("force", "N", false, 0.0, 2.4e5).title(), "force [10³ N]");
        assert_eq!(AxisView::new("force", "N", false, 0.0, 2.4e7).title(), "force [10⁶ N]");
        assert_eq!(AxisView::new("speed", "rad/s", false, 0.0, 8000.0).title(), "speed [rad/s]");
    }

    #[test]
    fn logarithmic_lengths_have_their_own_prefixes() {
        assert_eq!(of("mm", 0.5e-3, 2.0, true, 6), ["1 µm", "10 µm", "100 µm", "1 mm"]);
        assert_eq!(of("m", 0.5e-6, 2e-3, true, 6), ["1 µm", "10 µm", "100 µm", "1 mm"]);
        assert_eq!(of("µm", 20.0, 6000.0, true, 9), ["20 µm", "50 µm", "100 µm", "200 µm", "500 µm", "1 mm", "2 mm", "5 mm"]);
        assert_eq!(of("mm", 0.3, 0.42, true, 4), ["300 µm", "350 µm", "400 µm"]);
        assert_eq!(of("µm", 1e-8, 1e-3, true, 9).first().map(String::as_str), Some("10⁻⁵ nm"));
        let axis = |log| AxisView::new("amplitude", "mm", log, 0.01, 1.0).title();
        assert_eq!((axis(true), axis(false)), ("amplitude".into(), "amplitude [mm]".into()));
    }

    #[test]
    fn decades() {
        assert_eq!(labels(0.5e-6, 2e-3, true, 6), ["10⁻⁶", "10⁻⁵", "10⁻⁴", "10⁻³"]);
        assert_eq!(labels(0.1, 20.0, true, 8), ["0.1", "1", "10"]);
        assert_eq!(labels(20.0, 600.0, true, 8), ["20", "50", "100", "200", "500"]);
        assert_eq!(labels(300.0, 420.0, true, 4), ["300", "350", "400"].map(String::from).to_vec());
        assert!(labels(1e-20, 1e20, true, 6).len() <= 7);
        let t = AxisView::new("", "", true, 1.0, 1000.0).ticks(6);
        assert_eq!(t.minor.len(), 24);
    }

    #[test]
    fn places() {
        let axis = AxisView::new("", "", true, 1.0, 100.0);
        assert!((axis.place(10.0) - 0.5).abs() < 1e-15);
        assert!(axis.place(0.0).is_nan() && axis.place(-1.0).is_nan() && axis.place(f64::NAN).is_nan());
    }
}
