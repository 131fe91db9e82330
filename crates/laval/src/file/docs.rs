//! Documentation of one kind of part or study, from its declaration.

use super::writer::quoted;
use crate::model::field::{Bounds, DISTRIBUTIONS, Field, FieldKind, KindInfo, MOST_POINTS};
use crate::model::params::List;
use crate::units::{describe, examples, write_number, write_si};
use std::fmt::Write as _;

/// A value an example may show: usual for the unit, inside the bounds.
fn nominal(unit: &str, b: &Bounds) -> f64 {
    let usual: &[f64] = match unit {
        "kg" => &[2.0],
        "m" => &[0.07, 1e-3, 1e-5],
        "N/m" => &[1.1e7, 1e5],
        "N s/m" => &[40.0],
        "rad/s" => &[100.0, 10.0],
        "kg/m^3" => &[1000.0],
        "kg m^2" => &[0.01],
        "Pa" | "N/m^2" => &[2.1e11, 1e5],
        "N/m^3" => &[8e10],
        "rad" => &[0.1],
        "K" => &[293.15],
        "N m/rad" => &[1e4],
        "" => &[0.5],
        _ => &[1.0],
    };
    let (low, high) = (b.min.max(-1e12), b.max.min(1e12));
    let middle = if low >= 0.0 && low < 1e-9 * high { high / 2.0 } else { 0.5 * (low + high) };
    usual.iter().copied().find(|&x| b.contains(x)).unwrap_or(if b.contains(middle) { middle } else { b.max })
}

/// A value of an example: without the digits that rounding leaves behind a product.
fn quantity(unit: &str, x: f64) -> String {
    let x = format!("{x:.12e}").parse().unwrap_or(x);
    if unit.is_empty() { write_number(x) } else { quoted(&write_si(x, unit)) }
}

/// The second end of an example range.
fn farther(b: &Bounds, x: f64) -> f64 {
    let candidates = [10.0 * x, 2.0 * x, b.max, b.min, 0.5 * x];
    candidates.into_iter().find(|&y| y != x && b.contains(y)).unwrap_or(x + 1.0)
}

/// A value of a field as it would stand in a file.
fn example_value(f: &Field) -> String {
    let of = |unit: &str, b: &Bounds| quantity(unit, nominal(unit, b));
    match f.kind {
        FieldKind::Quantity { .. } | FieldKind::Lateral { .. } if !f.default.is_empty() => match f.default.trim().parse::<f64>() {
            Ok(_) => f.default.trim().to_string(),
            Err(_) => quoted(f.default.trim()),
        },
        FieldKind::Quantity { unit, bounds } | FieldKind::Lateral { unit, bounds } => of(unit, &bounds),
        FieldKind::OneOf(list) => list.first().map_or("{}".into(), |o| format!("{{ {} = {} }}", o.0, of(o.1, &o.2))),
        FieldKind::Choice(words) => {
            quoted(if f.default.is_empty() { words.first().map_or("", |w| w.0) } else { f.default.trim_matches('"') })
        }
        FieldKind::Integer { min, max } => f.default.parse::<i64>().unwrap_or(5.clamp(min, max)).to_string(),
        FieldKind::IntegerOrAuto { .. } => f.default.parse::<i64>().map_or_else(|_| quoted("auto"), |n| n.to_string()),
        FieldKind::Flag => if f.default == "true" { "true" } else { "false" }.into(),
        FieldKind::Text => quoted(if f.default.is_empty() { "text" } else { f.default }),
        FieldKind::Attach { .. } => quoted("drum"),
        FieldKind::Between => "[\"drum\", \"ground\"]".into(),
        FieldKind::Range { unit, bounds } => {
            let x = nominal(unit, &bounds);
            format!("{{ from = {}, to = {}, points = 200 }}", quantity(unit, x), quantity(unit, farther(&bounds, x)))
        }
        FieldKind::List { unit, bounds } => {
            let x = nominal(unit, &bounds);
            format!("[{}, {}]", quantity(unit, x), quantity(unit, farther(&bounds, x)))
        }
        FieldKind::ParameterPath => quoted("drum.mass"),
        // a second one is of another parameter
        FieldKind::ParameterRange if f.name == "y" => {
            "{ parameter = \"drum.eccentricity\", from = \"10 um\", to = \"100 um\", points = 20 }".into()
        }
        FieldKind::ParameterRange => "{ parameter = \"drum.mass\", from = \"2 kg\", to = \"4 kg\", points = 20 }".into(),
        FieldKind::Coordinate => quoted("drum.x"),
        FieldKind::Columns(list) => {
            let columns: Vec<String> = list
                .iter()
                .filter(|c| c.2)
                .map(|c| {
                    let x = nominal(c.1, &Bounds::within(f64::MAX));
                    format!("{} = [{}, {}]", c.0, quantity(c.1, x), quantity(c.1, 2.0 * x))
                })
                .collect();
            format!("{{ {} }}", columns.join(", "))
        }
        FieldKind::Named { unit, bounds } => of(unit, &bounds),
        // the lower ends of two
        FieldKind::StateMap if f.name == "from" => "{ \"drum.x\" = \"-1 mm\", \"drum.x'\" = \"-0.1 m/s\" }".into(),
        FieldKind::StateMap => "{ \"drum.x\" = \"1 mm\", \"drum.x'\" = \"0.1 m/s\" }".into(),
        FieldKind::Study => "{ kind = \"modes\", speed = \"3000 rpm\" }".into(),
        FieldKind::ParameterRanges => "[{ parameter = \"drum.mass\", from = \"2 kg\", to = \"4 kg\" }]".into(),
        FieldKind::Tolerances => "[{ parameter = \"drum.mass\", distribution = \"normal\", deviation = \"2 %\" }]".into(),
    }
}

/// One line of a file that gives the field, for instance `mass = "2 kg"`: that of the kind's example where it has one.
pub fn example_line(f: &Field, example: &str) -> String {
    let shown = example.lines().find(|l| l.split_once('=').is_some_and(|(key, _)| key.trim() == f.name));
    let without_remark = |l: &str| l.split("   #").next().unwrap_or_default().trim_end().to_string();
    shown.map_or_else(|| format!("{} = {}", f.name, example_value(f)), without_remark)
}

/// A typical block, which reads without mistakes beside a body named `drum`; `what` is `part`, `study` or the word of another block.
pub fn example(what: &str, kind: &KindInfo) -> String {
    let header = if what == kind.kind { format!("[{what}]\n") } else { format!("[[{what}]]\nkind = {}\n", quoted(kind.kind)) };
    if kind.example.is_empty() { every_key(what, kind) } else { header + kind.example }
}

/// A block with every key of the kind: values follow from units, bounds and defaults alone, and optional keys are remarks.
pub fn every_key(what: &str, kind: &KindInfo) -> String {
    if what == kind.kind {
        return single(kind);
    }
    let mut out = format!("[[{what}]]\nkind = {}\n", quoted(kind.kind));
    for f in kind.fields.iter().filter(|f| f.required) {
        let _ = writeln!(out, "{}", example_line(f, ""));
    }
    for f in kind.fields.iter().filter(|f| !f.required) {
        let _ = writeln!(out, "# {}", example_line(f, ""));
    }
    out
}

/// What a field takes, in words.
pub fn takes(f: &Field) -> String {
    let number = |unit: &str, b: &Bounds| {
        let interval = b.text(unit);
        let units = if unit.is_empty() { String::new() } else { format!(" ({})", examples(unit)) };
        format!("{}{units}, {interval}", describe(unit))
    };
    match f.kind {
        FieldKind::Quantity { unit, bounds } => number(unit, &bounds),
        FieldKind::Lateral { unit, bounds } => format!("{}; one value, or {{ x = .., y = .. }}", number(unit, &bounds)),
        FieldKind::OneOf(list) => {
            let each: Vec<String> = list.iter().map(|o| format!("{}: {} [{}]", o.0, o.3, number(o.1, &o.2))).collect();
            format!("exactly one of {{ {} }}", each.join("; "))
        }
        FieldKind::Choice(words) => words.iter().map(|w| format!("\"{}\" ({})", w.0, w.1)).collect::<Vec<_>>().join(" or "),
        FieldKind::Integer { min, max } => format!("a whole number from {min} to {max}"),
        FieldKind::IntegerOrAuto { min, max } => format!("a whole number from {min} to {max}, or \"auto\""),
        FieldKind::Flag => "true or false".into(),
        FieldKind::Text => "a text".into(),
        FieldKind::Attach { ground: true } => "a point: \"drum\", { body = \"drum\", at = \"40 mm\" } or \"ground\"".into(),
        FieldKind::Attach { ground: false } => "a point: \"drum\" or { body = \"drum\", at = \"40 mm\" }".into(),
        FieldKind::Between => "two points: [\"drum\", \"base\"]; one of them may be \"ground\", each may be { body = .., at = .. }".into(),
        FieldKind::Range { unit, bounds } => {
            format!(
                "one value, or {{ from = .., to = .., points = .. }}, points optional, at most {MOST_POINTS}; {}",
                number(unit, &bounds)
            )
        }
        FieldKind::List { unit, bounds } => format!("a list; {}", number(unit, &bounds)),
        FieldKind::ParameterPath => "the path of a parameter: \"drum.mass\"".into(),
        FieldKind::ParameterRange => {
            format!(
                "{{ parameter = \"drum.mass\", from = .., to = .., points = .. }}, in the unit of the parameter; points optional, at most {MOST_POINTS}"
            )
        }
        FieldKind::Coordinate => "the name of a coordinate: \"drum.x\"".into(),
        FieldKind::Columns(list) => {
            let each: Vec<String> =
                list.iter().map(|c| format!("{}: {} [{}]{}", c.0, c.3, describe(c.1), if c.2 { "" } else { ", optional" })).collect();
            format!(
                "columns of equal length {{ {} }}, or a list of rows {{ {} = .., .. }}",
                each.join("; "),
                list.first().map_or("", |c| c.0)
            )
        }
        FieldKind::Named { unit, bounds } => format!("{}; one value, or {{ name = .., name = .. }}", number(unit, &bounds)),
        FieldKind::ParameterRanges => "a list of { parameter = .., from = .., to = .. }, the ends in the unit of the parameter".into(),
        FieldKind::StateMap => "values by coordinate or rate: { \"drum.x\" = \"1 mm\", \"drum.x'\" = \"0.1 m/s\" }".into(),
        FieldKind::Study => "the name of another study of the file, or a whole one: { kind = \"modes\", .. }".into(),
        FieldKind::Tolerances => {
            let each: Vec<String> = DISTRIBUTIONS.iter().map(|d| format!("\"{}\" ({})", d.0, d.1)).collect();
            let distributions = each.join(", ");
            format!(
                "a list of {{ parameter = .., distribution = .., .. }}; distributions {distributions}; numbers in the unit of the parameter, or in % \
                 of its value in the machine"
            )
        }
    }
}

fn presence(f: &Field) -> String {
    match (f.required, f.default) {
        (true, _) => "required".into(),
        (false, "") => "optional".into(),
        (false, d) => format!("default {}", d.trim()),
    }
}

/// Breaks a text into lines of at most `width` columns, each after the first indented.
fn wrap(text: &str, indent: usize, width: usize) -> String {
    let (mut out, mut column) = (String::new(), indent);
    for w in text.split_whitespace() {
        let n = w.chars().count();
        if column > indent && column + 1 + n > width {
            let _ = write!(out, "\n{:indent$}", "");
            column = indent;
        } else if column > indent {
            out.push(' ');
            column += 1;
        }
        out.push_str(w);
        column += n;
    }
    out
}

/// A block that exists once, with its fields.
fn single(kind: &KindInfo) -> String {
    let lines = |required: bool, sign: &str| -> String {
        kind.fields.iter().filter(|f| f.required == required).map(|f| format!("{sign}{}\n", example_line(f, ""))).collect()
    };
    format!("[{}]\n{}{}", kind.kind, lines(true, ""), lines(false, "# "))
}

/// Documentation for a terminal of `width` columns; `what` is `part` or `study`.
pub fn text(what: &str, kind: &KindInfo, width: usize) -> String {
    let width = width.clamp(40, 120);
    let mut out = format!("{}\n  {}\n", kind.kind, wrap(kind.doc, 2, width));
    if !kind.fields.is_empty() {
        out.push_str("\nKeys\n");
    }
    for f in &kind.fields {
        let _ = writeln!(out, "  {} ({})", f.name, presence(f));
        let _ = writeln!(out, "      {}", wrap(f.doc, 6, width));
        let _ = writeln!(out, "      {}", wrap(&takes(f), 6, width));
    }
    for list in &kind.lists {
        let _ = write!(out, "\nParameters in the rows of {}\n  {}\n", list.name, wrap(&rows(list, ""), 2, width));
    }
    out.push_str("\nExample\n");
    let example = example(what, kind);
    for line in example.lines() {
        let _ = writeln!(out, "  {line}");
    }
    out
}

/// What studies vary in the rows of a list; each path between quotes.
fn rows(list: &List, quote: &str) -> String {
    let all: Vec<String> = list.slots.iter().map(|s| format!("{quote}{}{quote}", list.path(0, &s.name))).collect();
    format!("{}. Rows are numbered from 1.", all.join(", "))
}

/// The `[machine]` block in the form of a kind, for [`text`] and [`markdown`] with `what` = `machine`.
pub fn machine() -> KindInfo {
    KindInfo {
        kind: "machine",
        doc: "What belongs to the machine as a whole. A file has this block once, with single brackets; every key may be left out.",
        example: "name = \"oil separator\"\nspeed = \"3000 rpm\"\naxis = \"vertical\"                   # or \"horizontal\": gravity then points to -y\n",
        fields: super::MACHINE_FIELDS.to_vec(),
        lists: Vec::new(),
    }
}

/// Documentation in Markdown; `what` is `part` or `study`.
pub fn markdown(what: &str, kind: &KindInfo) -> String {
    let cell = |s: &str| s.replace('|', "\\|");
    let mut out = format!("## `{}`\n\n{}\n\n", kind.kind, kind.doc);
    if !kind.fields.is_empty() {
        out.push_str("| key | meaning | value | |\n| --- | --- | --- | --- |\n");
        for f in &kind.fields {
            let _ = writeln!(out, "| `{}` | {} | {} | {} |", f.name, cell(f.doc), cell(&takes(f)), cell(&presence(f)));
        }
        out.push('\n');
    }
    for list in &kind.lists {
        let _ = write!(out, "Parameters in the rows of `{}`: {}\n\n", list.name, rows(list, "`"));
    }
    let example = example(what, kind);
    let _ = write!(out, "```toml\n{example}```\n");
    out
}

/// The page of units in Markdown.
pub fn units_page() -> String {
    let mut out = String::from(
        "# Units\n\nA value with a unit is a text: a number, a space, a unit, as in `\"3000 rpm\"`, `\"30 g mm\"`, `\"1.1e7 N/m\"`. Units are\n\
         multiplied by a space, `*` or `·`, divided by `/`, and raised by `^` (`m^3`, `m3`, `m³`, `m^1.5`, `s^-1`); parentheses group. A product\n\
         behind a division (`N/m s`) has two readings and is refused: write `N s/m` or `N/(m s)`. A bare number is in SI units.\n\n\
         Angle is a dimension of its own: `rad/s`, `rpm`, `Hz`, `rev/s` and `deg/s` convert into each other, and `\"60 Hz\"` as a rotational speed is\n\
         377 rad/s. `\"60 1/s\"` as a rotational speed is refused, because it may mean either. A torque (`N m`) is not an energy (`J`).\n\n\
         ## Units\n\n| unit | in SI units | prefixes |\n| --- | --- | --- |\n",
    );
    let mut seen: Vec<&str> = Vec::new();
    for u in crate::units::list() {
        // two code points of the same sign look alike
        if seen.contains(&u.name) || (u.name == "\u{2126}" && seen.contains(&"Ω")) {
            continue;
        }
        seen.push(u.name);
        let unit = if u.si_unit.is_empty() { "1" } else { &u.si_unit };
        let shift = if u.offset == 0.0 { String::new() } else { format!(", from {} {unit}", write_number(u.offset)) };
        let digits = u.si.to_string();
        let number = if digits.len() > 18 { crate::units::format_number(u.si, 15) } else { write_number(u.si) };
        let _ = writeln!(out, "| `{}` | {number} {unit}{shift} | {} |", u.name, u.prefixes);
    }
    out.push_str(
        "\nPrefixes stand before the unit without a space: `p` 1e-12, `n` 1e-9, `u` or `µ` 1e-6, `m` 1e-3, `c` 1e-2, `d` 0.1, `h` 100, `k` 1e3,\n\
         `M` 1e6, `G` 1e9, `T` 1e12.\n\n## Quantities\n\n| quantity | SI unit | units usually written |\n| --- | --- | --- |\n",
    );
    for (si, words, usual) in crate::units::quantities() {
        let name = words.split_once(' ').map_or(*words, |w| w.1);
        let si = if si.is_empty() { "1" } else { si };
        let _ = writeln!(out, "| {name} | `{si}` | {usual} |");
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn examples_have_no_digits_of_rounding() {
        let list = Field::optional("release", FieldKind::List { unit: "m", bounds: Bounds::within(100.0) }, "", "");
        assert_eq!(example_line(&list, ""), "release = [\"70 mm\", \"700 mm\"]");
    }
}
