//! The numbers of a machine file, with the ranges of their sliders.

use crate::offsets::Offsets;
use laval::file::{self, Loaded, Number};
use laval::outcome::Arg;
use laval::report::Style;
use laval::units::{read_in, unit_of};
use serde_json::{Value as Json, json};
use std::collections::HashSet;

/// A slider goes from this share of the value to this multiple of it.
const SPREAD: f64 = 3.0;
/// Rows of lists that get sliders.
const MOST: usize = 400;

/// All numbers whose value is known: of a liquid given by its volume the free surface is that of the machine.
pub(crate) fn numbers(text: &str, loaded: &Loaded) -> Vec<Number> {
    let system = &loaded.system;
    let mut all = file::numbers_of(text, &loaded.spec, file::catalog());
    for n in all.iter_mut().filter(|n| n.value.is_nan()) {
        if let Some(x) = system.param(&n.path).and_then(|i| Some(system.params()[*i.first()?])) {
            n.value = x;
        }
    }
    all.retain(|n| n.value.is_finite());
    written_axes(&mut all);
    all.truncate(MOST);
    all
}

/// A value of both axes stands beside one of each: what the file writes stays, and of defaults the value of both.
fn written_axes(all: &mut Vec<Number>) {
    let of_axis = |path: &str| path.strip_suffix(".x").or_else(|| path.strip_suffix(".y")).map(str::to_string);
    let whole: HashSet<String> = all.iter().map(|n| n.path.clone()).collect();
    let split: HashSet<String> =
        all.iter().filter(|n| n.span.is_some()).filter_map(|n| of_axis(&n.path)).filter(|p| whole.contains(p)).collect();
    all.retain(|n| match of_axis(&n.path) {
        Some(both) if whole.contains(&both) => n.span.is_some(),
        _ => n.span.is_some() || !split.contains(&n.path),
    });
}

/// A value with one or two digits, below or above.
fn round(x: f64, up: bool) -> f64 {
    if x == 0.0 || !x.is_finite() {
        return x;
    }
    let step = 10f64.powf(x.abs().log10().floor() - 1.0);
    (if up { (x / step).ceil() } else { (x / step).floor() }) * step
}

/// The range of a slider, within the admissible interval: about the value, about zero the sizes of other numbers of the same unit.
pub(crate) fn range(n: &Number, all: &[Number]) -> (f64, f64) {
    let size = |unit: &str, position: bool| {
        let same = all.iter().filter(|o| o.unit == unit && o.on.is_some() == position && o.value != 0.0 && o.value.is_finite());
        same.map(|o| o.value.abs()).fold(0.0, f64::max)
    };
    let (low, high) = match n.value {
        x if n.on.is_some() => {
            let reach = size("m", true).max(x.abs()).max(0.05);
            (-1.5 * reach, 1.5 * reach)
        }
        0.0 => {
            let size = match n.unit {
                // of lengths that are zero most are distances of centres
                "m" => 1e-3,
                "rad" => 0.1,
                unit => size(unit, false),
            };
            let size = if size > 0.0 { size } else { 1.0 };
            (if n.bounds.min < 0.0 { -size } else { 0.0 }, size)
        }
        x if x > 0.0 => (x / SPREAD, x * SPREAD),
        x => (x * SPREAD, x / SPREAD),
    };
    let share = n.unit.is_empty() && n.bounds.max <= 1.0;
    let (low, high) = if share { (0.0, 1.0) } else { (round(low, false), round(high, true)) };
    // an open end is not reached
    let least = if n.bounds.min_open { n.bounds.min + 1e-6 * (high - n.bounds.min).abs() } else { n.bounds.min };
    (low.max(least), high.min(n.bounds.max))
}

/// For the page.
pub(crate) fn shown(text: &str, all: &[Number], style: &Style, offsets: &Offsets) -> Json {
    let units: Vec<String> = file::written_units(text).into_iter().map(|u| u.0).collect();
    let one = |n: &Number| {
        let literal = n.span.as_ref().and_then(|s| text.get(s.clone()));
        let written = literal.map(|l| l.trim_matches(['"', '\'']));
        let (number, unit) = read_in(&units, n.value, n.unit, 4);
        let own = written.and_then(unit_of).map_or(unit, str::to_string);
        let shown = written.map_or_else(|| format!("{number} {own}").trim_end().to_string(), str::to_string);
        let (low, high) = range(n, all);
        json!({
            "path": n.path,
            "label": n.path.replace('_', " ").replacen('.', " ", 1),
            "doc": style.arg(&Arg::term(n.doc)),
            "value": n.value,
            "unit": n.unit,
            "display_unit": own,
            "shown": shown,
            "from": n.span.as_ref().map(|s| offsets.units(s.start)),
            "to": n.span.as_ref().map(|s| offsets.units(s.end)),
            "low": low,
            "high": high,
        })
    };
    all.iter().map(one).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_hold_the_value_and_keep_the_bounds() {
        let text = laval_text();
        let loaded = file::load(text).unwrap_or_else(|d| panic!("{d}"));
        let all = numbers(text, &loaded);
        assert!(all.len() > 15);
        for n in &all {
            let (low, high) = range(n, &all);
            assert!(low < high && low <= n.value && n.value <= high, "{}: {} in {low} to {high}", n.path, n.value);
            assert!(n.bounds.contains(low) && n.bounds.contains(high), "{}", n.path);
        }
        // the fill is written by its volume
        assert!(all.iter().any(|n| n.path == "oil.free_surface_radius" && n.span.is_none() && (0.03..0.07).contains(&n.value)));
    }

    fn laval_text() -> &'static str {
        r#"
        machine = { speed = "3000 rpm" }
        part = [
            { kind = "disc", name = "drum", mass = "2.4 kg", eccentricity = "20 um" },
            { kind = "shaft_lumped", name = "shaft", between = ["drum", "ground"], stiffness = "3e5 N/m" },
            { kind = "liquid", name = "oil", in = "drum", cavity_radius = "70 mm", cavity_height = "60 mm", density = "880 kg/m^3",
              fill = { volume_fraction = 0.5 }, wave_damping = "2 1/s" },
        ]"#
    }
}
