//! Axis ticks: steps of 1, 2, 5 on linear axes; decades, with a minor grid, on logarithmic ones.

use crate::outcome::{significant, unit_text};

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
        AxisView { label: label.into(), unit: unit.into(), log, lo, hi, exponent, bare: false }
    }

    /// Place of a value between the ends: 0 at `lo`, 1 at `hi`; NaN for a value that the axis cannot show.
    pub fn place(&self, v: f64) -> f64 {
        if !v.is_finite() {
            return f64::NAN;
        }
        if self.log {
            if v > 0.0 { (v / self.lo).ln() / (self.hi / self.lo).ln() } else { f64::NAN }
        } else {
            (v - self.lo) / (self.hi - self.lo)
        }
    }

    /// Label, power of ten and unit: `force [10³ N]`.
    pub fn title(&self) -> String {
        let power = if self.exponent == 0 { String::new() } else { significant(10f64.powi(self.exponent), 1) };
        let power = if (1..6).contains(&self.exponent) { "10³".into() } else { power };
        let unit = unit_text(&self.unit);
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
        if self.log { log(self.lo, self.hi, most) } else { linear(self.lo, self.hi, most, self.exponent) }
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

fn step(span: f64, most: usize) -> f64 {
    let raw = span / most.max(1) as f64;
    let power = 10f64.powf(raw.log10().floor());
    [1.0, 2.0, 5.0, 10.0].into_iter().map(|m| m * power).find(|s| *s >= raw * (1.0 - 1e-9)).unwrap_or(10.0 * power)
}

fn fixed(v: f64, decimals: usize) -> String {
    let text = format!("{:.decimals$}", v.abs());
    if v < 0.0 && text.bytes().any(|b| b.is_ascii_digit() && b != b'0') { format!("−{text}") } else { text }
}

fn log(lo: f64, hi: f64, most: usize) -> Ticks {
    let plain = lo >= 0.9e-3 && hi <= 1.2e5;
    let label = |m: i32, d: i32| {
        let v = m as f64 * 10f64.powi(d);
        if plain { fixed(v, (-d).max(0) as usize) } else { significant_power(m, d) }
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
        return Ticks { minor: Vec::new(), ..linear(lo, hi, most, 0) };
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
        AxisView::new("a", "m", log, lo, hi).ticks(most).major.into_iter().map(|t| t.1).collect()
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
