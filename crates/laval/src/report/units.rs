//! The units in which a reader sees results: those of the machine file, else the usual ones of the field.

use crate::outcome::{Axis, Figure, Mark, Quantity, Role, significant, unit_text};
use std::f64::consts::{PI, TAU};

/// A unit of a reader: its name and its size in the SI unit.
#[derive(Clone, Debug, PartialEq)]
pub struct Rung {
    /// As it is written: `rpm`, `µm`.
    pub name: String,
    /// One of it in the SI unit.
    pub size: f64,
}

impl Rung {
    fn new(name: &str, size: f64) -> Rung {
        Rung { name: name.into(), size }
    }
}

/// Units by SI unit. [`Units::default`] keeps SI units with prefixes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Units {
    /// SI unit, and the unit preferred to it.
    preferred: Vec<(String, Rung)>,
    /// SI units whose preferred unit follows from inches and pounds that the file writes: it has no prefixes, and is kept whatever the size.
    imperial: Vec<&'static str>,
    /// Angles in degrees, unbalance in g mm, small masses in g.
    everyday: bool,
}

/// SI units with the prefixes that readers of the field use for each.
fn prefixes(unit: &str) -> Vec<Rung> {
    let powers: &[(i32, &str)] = match unit {
        "m" => &[(0, ""), (-3, "m"), (-6, "µ"), (-9, "n")],
        "s" => &[(0, ""), (-3, "m"), (-6, "µ")],
        "N" | "N m" | "N/m" | "N s/m" | "N m/rad" | "Pa" | "W" | "J" => &[(9, "G"), (6, "M"), (3, "k"), (0, ""), (-3, "m"), (-6, "µ")],
        _ => &[],
    };
    powers.iter().map(|(p, prefix)| Rung::new(&format!("{prefix}{unit}"), 10f64.powi(*p))).collect()
}

/// Everyday units of some SI units, largest first.
fn everyday(unit: &str) -> Vec<Rung> {
    let rungs: &[(&str, f64)] = match unit {
        "kg m" => &[("kg m", 1.0), ("kg mm", 1e-3), ("g mm", 1e-6)],
        "kg" => &[("kg", 1.0), ("g", 1e-3), ("mg", 1e-6)],
        "rad" => &[("°", PI / 180.0), ("mrad", 1e-3), ("µrad", 1e-6)],
        "m/s" => &[("m/s", 1.0), ("mm/s", 1e-3)],
        "m^3" => &[("m^3", 1.0), ("l", 1e-3), ("ml", 1e-6)],
        "m^2/s" => &[("m^2/s", 1.0), ("mm^2/s", 1e-6)],
        "rad/s^2" => &[("rpm/s", TAU / 60.0)],
        _ => &[],
    };
    rungs.iter().map(|(name, size)| Rung::new(name, *size)).collect()
}

/// Inches and their thousandths, which readers of either have by size; from this length on inches.
const INCH: f64 = 0.0254;
const MIL: f64 = 1e-3 * INCH;
const LONG: f64 = 0.1 * INCH;
/// Who writes lengths in inches or feet, or forces in pounds, reads these.
const IMPERIAL: [(&str, &str, f64); 17] = [
    ("m", "in", INCH),
    ("kg", "lb", POUND),
    ("kg m", "oz in", POUND / 16.0 * INCH),
    ("kg m^2", "lb in^2", POUND * INCH * INCH),
    ("kg/m^3", "lb/in^3", POUND / (INCH * INCH * INCH)),
    ("N", "lbf", POUND_FORCE),
    ("N m", "lbf in", POUND_FORCE * INCH),
    ("N/m", "lbf/in", POUND_FORCE / INCH),
    ("N/m^3", "lbf/in^3", POUND_FORCE / (INCH * INCH * INCH)),
    ("N s/m", "lbf s/in", POUND_FORCE / INCH),
    ("N m/rad", "lbf in/rad", POUND_FORCE * INCH),
    ("N m s/rad", "lbf in s/rad", POUND_FORCE * INCH),
    ("Pa", "psi", POUND_FORCE / (INCH * INCH)),
    ("m/s", "in/s", INCH),
    ("m/s^2", "in/s^2", INCH),
    ("m^3", "in^3", INCH * INCH * INCH),
    ("1/m", "1/in", 1.0 / INCH),
];
const POUND: f64 = 0.453_592_37;
const POUND_FORCE: f64 = 4.448_221_615_260_5;
/// Beginnings of columns and axes of how far something moves.
const MOTIONS: [&str; 11] = [
    "amplitude",
    "largest displacement",
    "displacement",
    "major",
    "minor",
    "forward",
    "backward",
    "in phase",
    "in_phase",
    "quadrature",
    "marked",
];

/// A unit that takes no prefixes.
fn imperial(unit: &str) -> bool {
    unit.split(|c: char| !c.is_alphabetic())
        .any(|w| matches!(w, "in" | "inch" | "ft" | "mil" | "thou" | "lb" | "lbf" | "oz" | "slug" | "psi"))
}

/// Largest number that a preferred unit is used for; beyond, and below its reciprocal, prefixes read better.
const LARGEST: f64 = 1e5;
const SMALLEST: f64 = 1e-2;

impl Units {
    /// From units that a machine file writes: text of the unit, its size in the SI unit and the SI unit, most frequent first. SI units with prefixes are
    /// chosen by size.
    pub fn new(written: impl IntoIterator<Item = (String, f64, String)>) -> Units {
        let mut out = Units::written(written);
        out.complete();
        out
    }

    fn written(written: impl IntoIterator<Item = (String, f64, String)>) -> Units {
        let mut out = Units { preferred: Vec::new(), imperial: Vec::new(), everyday: true };
        for (name, size, si) in written {
            let multiple = prefixes(&si).into_iter().chain(everyday(&si)).any(|r| r.name == name || r.name == name.replacen('u', "µ", 1));
            if (si == "rad/s" || !multiple) && out.of(&si).is_none() {
                let name = if name == "deg" { "°".into() } else { name };
                out.preferred.push((si, Rung { name, size }));
            }
        }
        out
    }

    /// Units chosen by the reader, whatever their size, then those that a machine file writes; both as in [`new`](Units::new).
    pub fn chosen(chosen: Vec<(String, f64, String)>, written: impl IntoIterator<Item = (String, f64, String)>) -> Units {
        let mut out = Units::written(written);
        out.preferred.retain(|p| !chosen.iter().any(|c| c.2 == p.0));
        for (name, size, si) in chosen {
            if out.of(&si).is_none() {
                out.preferred.push((si, Rung { name: if name == "deg" { "°".into() } else { name }, size }));
            }
        }
        out.complete();
        out
    }

    /// Units of quantities that the file does not write, where it writes others in inches and pounds.
    fn complete(&mut self) {
        let pounds = self.of("N").or(self.of("N/m")).is_some_and(|r| r.name.starts_with("lbf"));
        if !(self.inches() || pounds && self.of("m").is_none()) {
            return;
        }
        for (si, name, size) in IMPERIAL {
            if self.of(si).is_none() {
                self.preferred.push((si.into(), Rung::new(name, size)));
                self.imperial.push(si);
            }
        }
    }

    /// Speeds in rpm, displacements in mm, unbalance in g mm: where no machine file says otherwise.
    pub fn everyday() -> Units {
        Units::new([("rpm".into(), TAU / 60.0, "rad/s".into())])
    }

    /// They are those of a machine file or of the field, not SI units alone.
    pub fn is_everyday(&self) -> bool {
        self.everyday
    }

    fn of(&self, si: &str) -> Option<&Rung> {
        self.preferred.iter().find(|p| p.0 == si).map(|p| &p.1)
    }

    /// Lengths are read in inches or mils.
    fn inches(&self) -> bool {
        self.of("m").is_some_and(|r| ["in", "inch", "ft", "mil", "thou"].contains(&r.name.as_str()))
    }

    /// Of inches and mils the one for a length: where a file writes one of both, that under its own name.
    fn inch_or_mil(&self, long: bool) -> Rung {
        let size = if long { INCH } else { MIL };
        let own = self.of("m").filter(|r| (r.size / size - 1.0).abs() < 1e-9);
        own.cloned().unwrap_or(if long { Rung::new("in", INCH) } else { Rung::new("mil", MIL) })
    }

    /// The unit in which speeds are read: `rpm`, or `rad/s` where nothing else is preferred.
    pub fn speed(&self) -> Rung {
        self.of("rad/s").cloned().unwrap_or(Rung::new("rad/s", 1.0))
    }

    /// The unit in which a size of this SI unit is read.
    pub fn rung(&self, size: f64, si: &str, role: Role) -> Rung {
        if role == Role::Percent {
            return Rung::new("%", 1e-2);
        }
        if si == "rad/s" {
            let speed = self.speed();
            return if role == Role::Frequency && speed.size != 1.0 { Rung::new("Hz", TAU) } else { speed };
        }
        let size = size.abs();
        if si == "m" && self.inches() && size.is_finite() {
            return self.inch_or_mil(size >= LONG || size == 0.0);
        }
        let kept = |r: &&Rung| self.imperial.contains(&si) || !self.imperial.is_empty() && imperial(&r.name);
        if let Some(r) = self.of(si).filter(|r| kept(r) || (SMALLEST..LARGEST).contains(&(size / r.size))) {
            return r.clone();
        }
        let rungs = if self.everyday && !everyday(si).is_empty() { everyday(si) } else { prefixes(si) };
        // a value that rounds up to the next prefix takes it: 0.99999e-3 m is 1 mm
        let fits = rungs.iter().find(|r| size >= 0.99995 * r.size && size < 1e6 * r.size);
        let plain = || rungs.iter().find(|r| r.name == si).cloned().unwrap_or(Rung::new(si, 1.0));
        let tiny = || rungs.last().filter(|r| self.everyday && size > 0.0 && size < r.size && size > 1e-6 * r.size).cloned();
        fits.cloned().or_else(tiny).unwrap_or_else(plain)
    }

    /// The unit in which a column or an axis of this name is read, where it is another than that of the results: speeds and frequencies, angles, lengths.
    pub fn column(&self, name: &str, unit: &str) -> Option<Rung> {
        match unit {
            "rad/s" => {
                let role = if name.contains("frequency") { Role::Frequency } else { Role::Plain };
                Some(self.rung(0.0, unit, role)).filter(|r| r.size != 1.0)
            }
            "rad" if self.everyday => Some(Rung::new("°", PI / 180.0)),
            "m" if self.inches() => Some(self.inch_or_mil(!MOTIONS.iter().any(|m| name.starts_with(m)))),
            "m" => self.of("m").cloned().or_else(|| self.everyday.then(|| Rung::new("mm", 1e-3))),
            other => self.of(other).cloned(),
        }
    }

    /// A figure with its axes in the units of the reader.
    pub fn figure(&self, figure: &Figure) -> Figure {
        let mut out = figure.clone();
        self.axis(&mut out.x);
        for panel in &mut out.panels {
            self.axis(&mut panel.y);
            for mark in &mut panel.marks {
                if let Mark::Heat(heat) = mark {
                    self.axis(&mut heat.colours);
                }
            }
        }
        out
    }

    fn axis(&self, axis: &mut Axis) {
        // an axis with a factor has a unit for readers already, but for those who have lengths in another
        if axis.factor != 1.0 {
            let size = match axis.unit.as_str() {
                "mm" => 1e-3,
                "µm" => 1e-6,
                _ => return,
            };
            if ((size * axis.factor) - 1.0).abs() > 1e-9 || self.of("m").is_none() {
                return;
            }
            let own =
                if self.inches() { self.inch_or_mil(axis.unit == "mm") } else { self.of("m").cloned().unwrap_or(Rung::new("m", 1.0)) };
            axis.range = axis.range.map(|(a, b)| (a * size / own.size, b * size / own.size));
            axis.names.iter_mut().for_each(|n| n.0 *= size / own.size);
            axis.knee = axis.knee.map(|k| k * size / own.size);
            (axis.unit, axis.factor) = (own.name, 1.0 / own.size);
            return;
        }
        if let Some(r) = self.column(&axis.label.to_string(), &axis.unit) {
            axis.unit = r.name;
            axis.factor = 1.0 / r.size;
            axis.range = axis.range.map(|(a, b)| (a / r.size, b / r.size));
        }
    }

    /// Number and unit as they are read.
    pub fn split(&self, q: &Quantity) -> (String, String) {
        let speed = q.unit == "rad/s";
        let digits = q.digits.map_or(if speed { 4 } else { 3 }, usize::from);
        if q.unit.is_empty() && q.role == Role::Plain || !q.value.is_finite() {
            return (significant(q.value, digits), String::new());
        }
        let r = self.rung(q.value, &q.unit, q.role);
        (significant(q.value / r.size, digits), unit_text(&r.name))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(units: &Units, value: f64, unit: &str, role: Role) -> String {
        let (number, unit) = units.split(&Quantity { value, unit: unit.into(), role, digits: None });
        format!("{number} {unit}")
    }

    #[test]
    fn units_of_the_file_come_first() {
        let file =
            Units::new([("rpm".into(), TAU / 60.0, "rad/s".into()), ("mm".into(), 1e-3, "m".into()), ("N/mm".into(), 1e3, "N/m".into())]);
        for (value, unit, role, want) in [
            (314.159265, "rad/s", Role::Plain, "3000 rpm"),
            (314.159265, "rad/s", Role::Frequency, "50 Hz"),
            (1.6e-6, "m", Role::Plain, "1.6 µm"),
            (0.0467, "m", Role::Plain, "46.7 mm"),
            (3.26e5, "N/m", Role::Plain, "326 N/mm"),
            (1.1e10, "N/m", Role::Plain, "11 GN/m"),
            (2.5e-5, "kg m", Role::Plain, "25 g mm"),
            (0.0523598, "rad", Role::Plain, "3 °"),
            (2e-4, "rad", Role::Plain, "200 µrad"),
            (0.1534, "", Role::Percent, "15.3 %"),
        ] {
            assert_eq!(shown(&file, value, unit, role), want);
        }
    }

    #[test]
    fn chosen_units_come_before_those_of_the_file() {
        let written = || [("rpm".into(), TAU / 60.0, "rad/s".into()), ("N/mm".into(), 1e3, "N/m".into())];
        let units = Units::chosen(vec![("Hz".into(), TAU, "rad/s".into()), ("mm".into(), 1e-3, "m".into())], written());
        assert_eq!(shown(&units, 314.159265, "rad/s", Role::Plain), "50 Hz");
        assert_eq!(shown(&units, 2e-5, "m", Role::Plain), "0.02 mm");
        assert_eq!(shown(&units, 3.26e5, "N/m", Role::Plain), "326 N/mm");
        assert_eq!(units.column("amplitude", "m").map(|r| r.name), Some("mm".into()));
    }

    #[test]
    fn who_reads_inches_reads_small_lengths_in_mils() {
        for (name, size) in [("in", INCH), ("mil", MIL), ("ft", 12.0 * INCH)] {
            let units = Units::new([(name.into(), size, "m".into())]);
            for (value, want) in [(2.54e-5, "1 mil"), (0.0508, "2 in"), (1.27e-6, "0.05 mil")] {
                assert_eq!(shown(&units, value, "m", Role::Plain), want, "{name}");
            }
            let column = |name: &str| units.column(name, "m").map(|r| r.name);
            assert_eq!((column("amplitude.drum"), column("height")), (Some("mil".into()), Some("in".into())));
            let figure = Figure::new("f", "", "").x(Axis::new("x", "mm").factor(1e3).range(0.0, 25.4));
            let drawn = units.figure(&figure.panel(crate::outcome::Panel::new(Axis::log("amplitude", "µm").factor(1e6))));
            assert_eq!((drawn.x.unit.as_str(), drawn.panels[0].y.unit.as_str()), ("in", "mil"));
            assert!((drawn.x.range.unwrap().1 - 1.0).abs() < 1e-12 && (drawn.panels[0].y.factor * MIL - 1.0).abs() < 1e-12);
        }
        // metric files keep their axes
        let metric = Units::new([("mm".into(), 1e-3, "m".into())]);
        let figure = Figure::new("f", "", "").x(Axis::new("x", "µm").factor(1e6));
        assert_eq!(metric.figure(&figure).x.unit, "µm");
    }

    /// A file in inches and pounds: what it does not write is read in inches and pounds, too.
    #[test]
    fn an_imperial_file_has_no_metric_unit() {
        let file = Units::new([
            ("rpm".into(), TAU / 60.0, "rad/s".into()),
            ("lb".into(), POUND, "kg".into()),
            ("lbf/in".into(), POUND_FORCE / INCH, "N/m".into()),
            ("in".into(), INCH, "m".into()),
        ]);
        for (value, unit, want) in [
            (5e-3, "m/s", "0.197 in/s"),
            (4.448_221_615_260_5e-7, "N", "10⁻⁷ lbf"),
            (1e12, "N/m", "5.71·10⁹ lbf/in"),
            (1.0, "N m", "8.85 lbf in"),
            (2e3, "N s/m", "11.4 lbf s/in"),
            (1e-5, "kg m", "0.0139 oz in"),
            (0.01, "kg m^2", "34.2 lb in²"),
            (6.9e6, "Pa", "1000 psi"),
            (1e-6, "kg", "2.2·10⁻⁶ lb"),
        ] {
            assert_eq!(shown(&file, value, unit, Role::Plain), want);
        }
        for (name, unit, want) in
            [("velocity.drum", "m/s", "in/s"), ("force of front", "N", "lbf"), ("tilt over displacement", "1/m", "1/in")]
        {
            assert_eq!(file.column(name, unit).map(|r| r.name).as_deref(), Some(want));
        }
        // what a reader chooses stands, and an imperial mass alone makes no imperial file
        let chosen = Units::chosen(vec![("mm".into(), 1e-3, "m".into())], [("in".into(), INCH, "m".into())]);
        assert_eq!(shown(&chosen, 5e-3, "m/s", Role::Plain), "5 mm/s");
        let mass = Units::new([("lb".into(), POUND, "kg".into()), ("N/mm".into(), 1e3, "N/m".into())]);
        assert_eq!(shown(&mass, 20.0, "N", Role::Plain), "20 N");
    }

    #[test]
    fn without_a_preference_units_are_si() {
        let si = Units::default();
        assert_eq!(shown(&si, 314.159265, "rad/s", Role::Plain), "314.2 rad/s");
        assert_eq!(shown(&si, 314.159265, "rad/s", Role::Frequency), "314.2 rad/s");
        assert_eq!(shown(&si, 1.234e-4, "m", Role::Plain), "123 µm");
        assert_eq!(shown(&si, 2.5e-5, "kg m", Role::Plain), "2.5·10⁻⁵ kg m");
        assert_eq!(shown(&si, f64::NAN, "m", Role::Plain), "not a number ");
    }
}
