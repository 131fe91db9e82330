//! The units that a machine file writes, for reports in the units of the reader.

use super::tree;
use crate::language::Language;
use crate::units::{Unit, parse_unit};
use std::collections::BTreeMap;
use std::sync::LazyLock;
use toml::de::{DeTable, DeValue};

/// SI units of results.
const RESULTS: [&str; 24] = [
    "rad/s",
    "m",
    "kg",
    "s",
    "N",
    "N/m",
    "N s/m",
    "kg m",
    "kg m^2",
    "rad",
    "Pa",
    "m/s",
    "m^3",
    "m^2/s",
    "kg/m^3",
    "N m",
    "N m/rad",
    "1/s",
    "W",
    "rad/s^2",
    "m^2",
    "N/m^3",
    "m/s^2",
    "N m s/rad",
];

/// Units of a file, by how often they stand there; that of the operating speed first: text, size in the SI unit, SI unit. A file that cannot be read has
/// none.
pub fn written_units(text: &str) -> Vec<(String, f64, String)> {
    if tree::too_deep(text).is_some() {
        return Vec::new();
    }
    let Ok(file) = DeTable::parse(text) else { return Vec::new() };
    let file = file.into_inner();
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    file.values().for_each(|v| walk(v.get_ref(), &mut counts));
    let speed = file.get("machine").and_then(|m| m.get_ref().as_table()).and_then(|m| m.get("speed"));
    if let Some(unit) = speed.and_then(|s| unit(s.get_ref())) {
        *counts.entry(unit).or_default() += 1_000_000;
    }
    let mut sorted: Vec<(&str, usize)> = counts.into_iter().collect();
    sorted.sort_by(|a, b| b.1.cmp(&a.1).then(a.0.cmp(b.0)));
    si_units(sorted.into_iter().map(|s| s.0.to_string()))
}

/// The language that a file asks for in `[report]`, also when the rest of it cannot be read.
pub fn written_language(text: &str) -> Option<Language> {
    if !text.contains("report") || tree::too_deep(text).is_some() {
        return None;
    }
    let (file, _) = DeTable::parse_recoverable(text);
    let report = file.get_ref().get("report")?.get_ref().as_table()?;
    report.get("language")?.get_ref().as_str()?.parse().ok()
}

/// Units with their size in the SI unit and the SI unit; what is no unit of results is left out.
pub fn si_units(names: impl IntoIterator<Item = String>) -> Vec<(String, f64, String)> {
    static KNOWN: LazyLock<Vec<(&str, Unit)>> =
        LazyLock::new(|| RESULTS.iter().filter_map(|si| Some((*si, parse_unit(si).ok()?))).collect());
    let one = |name: String| {
        let unit = parse_unit(&name).ok()?;
        let (si, _) = KNOWN.iter().find(|k| k.1.dimension.same(&unit.dimension))?;
        Some((name, unit.factor(), si.to_string()))
    };
    names.into_iter().filter_map(one).collect()
}

fn walk<'a>(value: &'a DeValue, counts: &mut BTreeMap<&'a str, usize>) {
    match value {
        DeValue::Table(t) => t.values().for_each(|v| walk(v.get_ref(), counts)),
        DeValue::Array(a) => a.iter().for_each(|v| walk(v.get_ref(), counts)),
        other => unit(other).into_iter().for_each(|u| *counts.entry(u).or_default() += 1),
    }
}

/// The unit behind the number of a quantity.
fn unit<'a>(value: &'a DeValue) -> Option<&'a str> {
    let (number, unit) = value.as_str()?.trim().split_once(' ')?;
    number.parse::<f64>().ok()?;
    let unit = unit.trim();
    parse_unit(unit).ok().filter(|u| !u.dimension.is_none()).map(|_| unit)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_speed_comes_first_and_frequent_units_before_rare_ones() {
        let text = r#"
            machine = { speed = "50 Hz" }
            part = [{ a = "3000 rpm", b = "2000 rpm", c = "1 N/mm", d = "2 N/m", e = "3 N/mm", name = "5 drums", share = "5 %" }]
        "#;
        let units: Vec<_> = written_units(text).into_iter().map(|u| (u.0, u.2)).collect();
        let want = [("Hz", "rad/s"), ("N/mm", "N/m"), ("rpm", "rad/s"), ("N/m", "N/m")];
        assert_eq!(units, want.map(|(a, b)| (a.to_string(), b.to_string())));
        assert!(written_units("not = [toml").is_empty());
    }
}
