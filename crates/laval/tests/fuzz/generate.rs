//! Machine files, most of them wrong: deterministic, one per number.

use laval::file::{Catalog, docs};
use laval::model::field::{Bounds, Field, FieldKind, KindInfo};

/// SplitMix64: every case has its own, so that cases do not depend on the order in which they run.
pub struct Random(u64);

impl Random {
    pub fn new(case: u64) -> Self {
        Random(case.wrapping_mul(0xD134_2543_DE82_EF95) ^ 0x1885_0000_1EAF)
    }
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }
    pub fn below(&mut self, n: usize) -> usize {
        (self.bits() >> 11) as usize % n.max(1)
    }
    fn chance(&mut self, percent: usize) -> bool {
        self.below(100) < percent
    }
    fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }
    fn of<'a, T: ?Sized>(&mut self, list: &[&'a T]) -> &'a T {
        list[self.below(list.len())]
    }
}

/// Numbers that break careless arithmetic.
const EXTREME: [f64; 20] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    1e308,
    -1e308,
    1e-308,
    5e-324,
    1e154,
    1e-154,
    1e100,
    1e-100,
    1e20,
    1e-20,
    1e9,
    1e-9,
    1e6,
    1e-6,
    0.5,
    1.0000000000000002,
];
/// Values that are none, or not of the type wanted.
const ODD: [&str; 30] = [
    "nan",
    "inf",
    "-inf",
    "\"nan m\"",
    "\"-inf kg\"",
    "\"1e999 N/m\"",
    "1e308",
    "\"1e308 km\"",
    "\"\"",
    "\" \"",
    "\"1\"",
    "\"m\"",
    "\"1 m/s\"",
    "\"1 N/m\"",
    "\"3000 rpm\"",
    "true",
    "[]",
    "[[]]",
    "{}",
    "[1, nan]",
    "{ x = 1 }",
    "{ from = 1, to = 2, points = 1000000000 }",
    "1979-05-27",
    "\"\u{b5}\u{b5}m\"",
    "\"1 \u{3a9}\u{1f980}\"",
    "\"ground\"",
    "9223372036854775807",
    "-9223372036854775808",
    "\"1 m^99999999999\"",
    "\"auto\"",
];
const UNITS: [&str; 26] = [
    "m", "mm", "um", "kg", "g", "t", "N/m", "N/mm", "kN/m", "N s/m", "rpm", "rad/s", "Hz", "deg", "rad", "s", "ms", "kg/m^3", "N m",
    "kg m^2", "g mm", "1/s", "N/m^3", "%", "ft", "lbf",
];
const PIECES: [&str; 40] = [
    "\"",
    "'",
    "[",
    "]",
    "[[part]]",
    "[[study]]",
    "[machine]",
    "{",
    "}",
    "=",
    ",",
    ".",
    "#",
    "\n",
    "\"\"\"",
    "\\",
    "\\u0000",
    "kind",
    "name",
    "mass",
    "= 1e999",
    "nan",
    "-inf",
    "99999999999999999999",
    "0x",
    "1979-05-27",
    "\u{b5}",
    "\u{b0}",
    "\u{b2}",
    "rpm",
    "N/m^",
    "(",
    ")",
    "/",
    " ",
    "\r",
    "\0",
    "e308",
    "-",
    "true",
];

/// What all cases are made from.
pub struct Sources {
    catalog: Catalog,
    files: Vec<String>,
}

const BASE: &str = "[machine]\nname = \"small\"\nspeed = \"3000 rpm\"\n[[part]]\nkind = \"disc\"\nname = \"drum\"\nmass = \"2.4 kg\"\neccentricity = \"20 um\"\n\
    [[part]]\nkind = \"foundation\"\nname = \"base\"\nmass = \"25 kg\"\nstiffness = \"3e5 N/m\"\ndamping = \"50 N s/m\"\n\
    [[part]]\nkind = \"bearing_cubic\"\nname = \"bearing\"\nbetween = [\"drum\", \"base\"]\nlaw = \"per_axis\"\nstiffness = \"1.1e7 N/m\"\ncubic_stiffness = \"8.7e10 N/m^3\"\n\
    [[part]]\nkind = \"damper\"\nname = \"losses\"\nbetween = [\"drum\", \"ground\"]\ndamping = \"42 N s/m\"\n";

impl Sources {
    pub fn new(catalog: Catalog) -> Self {
        let mut files = vec![
            include_str!("../../../../examples/01-oil-separator/machine.toml").to_string(),
            include_str!("../../../../examples/02-rigid-rotor/machine.toml").to_string(),
            include_str!("../../../../examples/03-overhung-disc/machine.toml").to_string(),
        ];
        files.extend(catalog.parts.iter().map(|k| format!("{BASE}{}", docs::example("part", k))));
        files.extend(catalog.studies.iter().map(|k| format!("{BASE}{}", docs::example("study", k))));
        // with every optional key as well, the remarks of the example turned into keys
        let all_keys = |text: String| text.replace("\n# ", "\n");
        files.extend(catalog.parts.iter().map(|k| all_keys(format!("{BASE}{}", docs::example("part", k)))));
        files.extend(catalog.studies.iter().map(|k| all_keys(format!("{BASE}{}", docs::example("study", k)))));
        Sources { catalog, files }
    }

    /// The seed files: the examples, and small files with every kind of part and every kind of study.
    pub fn files(&self) -> &[String] {
        &self.files
    }

    /// The bytes of one case.
    pub fn case(&self, number: u64) -> Vec<u8> {
        let mut r = Random::new(number);
        match number % 10 {
            0 => random_bytes(&mut r),
            1 => self.edited_bytes(&mut r),
            2 => self.edited_lines(&mut r),
            3 | 4 => self.edited_values(&mut r),
            _ => self.composed(&mut r).into_bytes(),
        }
    }

    fn file(&self, r: &mut Random) -> &str {
        &self.files[r.below(self.files.len())]
    }

    fn edited_bytes(&self, r: &mut Random) -> Vec<u8> {
        let mut bytes = self.file(r).as_bytes().to_vec();
        for _ in 0..=r.below(3) {
            let at = r.below(bytes.len() + 1);
            let end = (at + r.below(24)).min(bytes.len());
            match r.below(4) {
                0 if at < bytes.len() => bytes[at] = r.bits() as u8,
                1 => drop(bytes.drain(at..end)),
                2 => drop(bytes.splice(at..at, r.of(&PIECES).bytes())),
                _ => {
                    let piece = bytes[at..end].to_vec();
                    let to = r.below(bytes.len() + 1);
                    bytes.splice(to..to, piece);
                }
            }
        }
        bytes
    }

    fn edited_lines(&self, r: &mut Random) -> Vec<u8> {
        let mut lines: Vec<&str> = self.file(r).lines().collect();
        for _ in 0..=r.below(4) {
            let at = r.below(lines.len());
            match r.below(4) {
                0 => drop(lines.remove(at)),
                1 => lines.insert(r.below(lines.len()), lines[at]),
                2 => {
                    let other = r.below(lines.len());
                    lines.swap(at, other);
                }
                _ => {
                    let from = self.file(r).lines().collect::<Vec<_>>();
                    lines.insert(at, from[r.below(from.len())]);
                }
            }
            if lines.is_empty() {
                break;
            }
        }
        lines.join("\n").into_bytes()
    }

    /// The value of some keys replaced.
    fn edited_values(&self, r: &mut Random) -> Vec<u8> {
        let mut lines: Vec<String> = self.file(r).lines().map(str::to_string).collect();
        let keys: Vec<usize> = (0..lines.len()).filter(|&i| lines[i].contains('=') && !lines[i].trim_start().starts_with('#')).collect();
        for _ in 0..=r.below(2) {
            let at = keys[r.below(keys.len())];
            let Some((key, value)) = lines[at].split_once('=') else { continue };
            let value = match r.below(4) {
                0 => r.of(&ODD).to_string(),
                1 => keys.get(r.below(keys.len())).and_then(|&k| lines[k].split_once('=')).map_or(String::new(), |v| v.1.to_string()),
                2 => other_number(r, value),
                _ => other_unit(r, value),
            };
            lines[at] = format!("{key}= {value}");
        }
        lines.join("\n").into_bytes()
    }

    /// A file from the declarations of the registries.
    fn composed(&self, r: &mut Random) -> String {
        // how far values go: usual ones, all the bounds admit, anything
        let hostility = [0, 0, 0, 1, 1, 2][r.below(6)];
        let mut out = String::from("[machine]\n");
        if r.chance(70) {
            out += &format!("speed = {}\n", quantity(r, hostility, "rad/s", &Bounds::within(1e6)));
        }
        if r.chance(30) {
            out += r.of(&["axis = \"horizontal\"\n", "axis = \"vertical\"\n"]);
        }
        let bodies = if r.chance(60) { 2 } else { 1 };
        let mut names: Vec<String> = Vec::new();
        for i in 0..bodies + r.below(4) {
            let kind = match i {
                0 if hostility < 2 => "disc",
                1 if bodies == 2 => "foundation",
                _ => self.catalog.parts[r.below(self.catalog.parts.len())].kind,
            };
            let Some(info) = self.catalog.part(kind) else { continue };
            let name = match r.below(40) {
                0 => names.last().cloned().unwrap_or_default(),
                1 => "\u{1f980}".into(),
                2 => "x".repeat(70),
                _ => ["drum", "base", "c", "d", "e", "f"][i.min(5)].to_string(),
            };
            out += &format!("[[part]]\nkind = \"{kind}\"\nname = \"{name}\"\n");
            names.push(name);
            self.fields(r, hostility, info, &names, &mut out);
        }
        for _ in 0..1 + r.below(2) {
            let info = &self.catalog.studies[r.below(self.catalog.studies.len())];
            out += &format!("[[study]]\nkind = \"{}\"\n", info.kind);
            self.fields(r, hostility, info, &names, &mut out);
        }
        out
    }

    fn fields(&self, r: &mut Random, hostility: usize, info: &KindInfo, names: &[String], out: &mut String) {
        for f in &info.fields {
            let given = if f.required { 100 - hostility } else { 35 };
            if r.chance(given) {
                let value = if r.chance(hostility * hostility) { r.of(&ODD).to_string() } else { self.value(r, hostility, f, names) };
                *out += &format!("{} = {value}\n", f.name);
            }
        }
    }

    fn value(&self, r: &mut Random, hostility: usize, f: &Field, names: &[String]) -> String {
        match f.kind {
            FieldKind::Quantity { unit, bounds } => quantity(r, hostility, unit, &bounds),
            FieldKind::Lateral { unit, bounds } if r.chance(30) => {
                format!("{{ x = {}, y = {} }}", quantity(r, hostility, unit, &bounds), quantity(r, hostility, unit, &bounds))
            }
            FieldKind::Lateral { unit, bounds } => quantity(r, hostility, unit, &bounds),
            FieldKind::OneOf(list) => {
                let o = &list[r.below(list.len())];
                format!("{{ {} = {} }}", o.0, quantity(r, hostility, o.1, &o.2))
            }
            FieldKind::Choice(words) => format!("\"{}\"", words[r.below(words.len())].0),
            FieldKind::IntegerOrAuto { .. } if r.chance(30) => "\"auto\"".into(),
            FieldKind::Integer { min, max } | FieldKind::IntegerOrAuto { min, max } => match hostility {
                0 => (min + r.below((max - min).clamp(1, 40) as usize) as i64).to_string(),
                1 => [min, max, min + (max - min) / 2][r.below(3)].to_string(),
                _ => [i64::MIN, -1, 0, 1, min, max, max.saturating_add(1), i64::MAX][r.below(8)].to_string(),
            },
            FieldKind::Flag => r.of(&["true", "false"]).into(),
            FieldKind::Text => r.of(&["\"text\"", "\"\"", "\"\\u0000\\n\"", "\"\u{1f980}\""]).into(),
            FieldKind::Attach { .. } => point(r, hostility, names),
            FieldKind::Between => format!("[{}, {}]", point(r, hostility, names), point(r, hostility, names)),
            FieldKind::Range { unit, bounds } => range(r, hostility, unit, &bounds, ""),
            FieldKind::List { unit, bounds } => list(r, hostility, unit, &bounds, false),
            FieldKind::ParameterPath => format!("\"{}\"", self.path(r, names).0),
            FieldKind::ParameterRange => {
                let (path, unit, bounds) = self.path(r, names);
                range(r, hostility, unit, &bounds, &format!("parameter = \"{path}\", "))
            }
            FieldKind::Named { unit, bounds } if r.chance(50) => {
                format!("{{ {} = {} }}", names.first().map_or("drum", |n| n.as_str()), quantity(r, hostility, unit, &bounds))
            }
            FieldKind::Named { unit, bounds } => quantity(r, hostility, unit, &bounds),
            FieldKind::Study => {
                let kinds = [
                    "modes\", speed = 100.0",
                    "critical_speeds\", speed = { from = 1.0, to = 900.0, points = 9 }",
                    "uncertainty\"",
                    "mode\"",
                ];
                if r.chance(20) { "\"modes\"".into() } else { format!("{{ kind = \"{} }}", r.of(&kinds)) }
            }
            FieldKind::Tolerances => {
                let each: Vec<String> = (0..1 + r.below(2))
                    .map(|_| {
                        let path = self.path(r, names).0;
                        let how = r.of(&[
                            "\"normal\", deviation = \"2 %\"",
                            "\"uniform\", tolerance = \"5 %\"",
                            "\"log_normal\", deviation = \"300 %\"",
                            "\"triangular\", from = \"90 %\", to = \"120 %\"",
                            "\"normal\", tolerance = 1",
                            "\"uniform\", from = 3, to = -1e300",
                            "\"cauchy\"",
                        ]);
                        format!("{{ parameter = \"{path}\", distribution = {how} }}")
                    })
                    .collect();
                format!("[{}]", each.join(", "))
            }
            FieldKind::Columns(declared) => {
                let rows = 1 + r.below(4);
                let mut each = Vec::new();
                for (i, c) in declared.iter().enumerate().filter(|c| c.1.2 || c.0 < 5) {
                    let mut values: Vec<f64> = (0..rows).map(|_| number(r, hostility, c.1, &Bounds::within(1e9))).collect();
                    if i == 0 && hostility < 2 {
                        values.sort_by(f64::total_cmp);
                        values[0] = if c.1 == "s" { 0.0 } else { values[0] };
                    }
                    each.push(format!("{} = [{}]", c.0, values.iter().map(|x| literal(*x)).collect::<Vec<_>>().join(", ")));
                }
                format!("{{ {} }}", each.join(", "))
            }
            FieldKind::Coordinate => r.of(&["\"drum.x\"", "\"base.y\"", "\"drum.x'\"", "\"\"", "\"drum\""]).into(),
            FieldKind::StateMap => {
                let name = if f.name == "kick" { "drum.x'" } else { r.of(&["drum.x", "drum.y'", "base.x", "drum.tilt_x", "d.surface_x"]) };
                let size = if hostility == 0 { 1e-4 * r.unit() } else { EXTREME[r.below(EXTREME.len())] };
                format!("{{ \"{name}\" = {} }}", literal(size))
            }
        }
    }

    fn path(&self, r: &mut Random, names: &[String]) -> (String, &'static str, Bounds) {
        let name = names.get(r.below(names.len())).map_or("drum", String::as_str);
        let all: Vec<(&'static str, &'static str, Bounds)> = self
            .catalog
            .parts
            .iter()
            .flat_map(|k| &k.fields)
            .filter_map(|f| match f.kind {
                FieldKind::Quantity { unit, bounds } | FieldKind::Lateral { unit, bounds } => Some((f.name, unit, bounds)),
                _ => None,
            })
            .collect();
        let p = if r.chance(60) { &all[r.below(3)] } else { &all[r.below(all.len())] };
        let name = if p.0 == all[0].0 { "drum" } else { name };
        (format!("{name}.{}", p.0), p.1, p.2)
    }
}

fn random_bytes(r: &mut Random) -> Vec<u8> {
    let n = r.below(300);
    match r.below(3) {
        0 => (0..n).map(|_| r.bits() as u8).collect(),
        1 => (0..n).map(|_| 32 + (r.bits() % 95) as u8).collect(),
        _ => (0..n / 4).flat_map(|_| r.of(&PIECES).bytes()).collect(),
    }
}

/// TOML wants a digit after the point and no `inf` by accident.
fn literal(x: f64) -> String {
    if x.is_nan() {
        "nan".into()
    } else if x.is_infinite() {
        if x > 0.0 { "inf" } else { "-inf" }.into()
    } else {
        format!("{x:e}").replace('e', ".0e").replacen(".0e", if format!("{x:e}").contains('.') { "e" } else { ".0e" }, 1)
    }
}

/// A size of the unit that machines have, spread over a few decades.
fn usual(r: &mut Random, unit: &str) -> f64 {
    let (lo, hi) = match unit {
        "kg" => (0.1, 100.0),
        "m" => (1e-5, 0.1),
        "N/m" => (1e4, 1e8),
        "N/m^3" => (1e8, 1e12),
        "N/m^1.5" => (1e8, 1e10),
        "N s/m" => (1.0, 1e4),
        "rad/s" => (1.0, 2000.0),
        "rad" => (1e-4, 3.0),
        "kg m" => (1e-6, 1e-3),
        "kg m^2" => (1e-3, 1.0),
        "kg/m^3" => (500.0, 2000.0),
        "s" => (1e-3, 1.0),
        "1/s" => (0.01, 10.0),
        _ => (0.01, 1.0),
    };
    10f64.powf(f64::log10(lo) + r.unit() * f64::log10(hi / lo))
}

fn number(r: &mut Random, hostility: usize, unit: &str, bounds: &Bounds) -> f64 {
    let extreme = EXTREME[r.below(EXTREME.len())];
    let sane = usual(r, unit).min(bounds.max);
    match hostility {
        0 => sane,
        1 => match r.below(6) {
            0 if bounds.max.is_finite() => bounds.max,
            1 if bounds.contains(bounds.min) => bounds.min,
            2 | 3 if bounds.contains(extreme) => extreme,
            _ => sane,
        },
        _ if r.chance(15) => extreme,
        _ if r.chance(10) => -sane,
        _ => sane,
    }
}

fn quantity(r: &mut Random, hostility: usize, unit: &str, bounds: &Bounds) -> String {
    let x = literal(number(r, hostility, unit, bounds));
    match r.below(20) {
        0 if hostility == 2 => format!("\"{x} {}\"", r.of(&UNITS)),
        1..8 if !unit.is_empty() => format!("\"{x} {unit}\""),
        _ => x,
    }
}

fn point(r: &mut Random, hostility: usize, names: &[String]) -> String {
    let body = match r.below(30 + 20 * (2 - hostility)) {
        0 => "nobody",
        1 => names.last().map_or("", String::as_str),
        2 => "",
        n if n % 3 == 0 => "ground",
        n if n % 3 == 1 && names.len() > 1 => names[1].as_str(),
        _ => names.first().map_or("drum", String::as_str),
    };
    if r.chance(10) {
        return format!("{{ body = \"{body}\", at = {} }}", quantity(r, hostility, "m", &Bounds::within(1e4)));
    }
    format!("\"{body}\"")
}

fn range(r: &mut Random, hostility: usize, unit: &str, bounds: &Bounds, head: &str) -> String {
    let (mut a, mut b) = (number(r, hostility, unit, bounds), number(r, hostility, unit, bounds));
    if a > b && !r.chance(5) {
        (a, b) = (b, a);
    }
    let points = match r.below(10) {
        0 if hostility > 0 => ", points = 1000000",
        1 if hostility > 1 => ", points = 1000000000",
        2 => ", points = 2",
        3 | 4 => ", points = 17",
        5 => ", points = 300",
        _ => "",
    };
    format!("{{ {head}from = {}, to = {}{points} }}", literal(a), literal(b))
}

fn list(r: &mut Random, hostility: usize, unit: &str, bounds: &Bounds, ordered: bool) -> String {
    let mut values: Vec<f64> = (0..1 + r.below(4)).map(|_| number(r, hostility, unit, bounds)).collect();
    if ordered {
        values.sort_by(f64::total_cmp);
    }
    format!("[{}]", values.iter().map(|x| literal(*x)).collect::<Vec<_>>().join(", "))
}

/// The first number in a value replaced by an extreme one.
fn other_number(r: &mut Random, value: &str) -> String {
    let Some(start) = value.find(|c: char| c.is_ascii_digit()) else { return value.to_string() };
    let length = value[start..].find(|c: char| !(c.is_ascii_digit() || matches!(c, '.' | 'e' | '-'))).unwrap_or(value.len() - start);
    let x = EXTREME[r.below(EXTREME.len())];
    format!("{}{}{}", &value[..start], literal(x), &value[start + length..])
}

/// The unit at the end of a quoted quantity replaced by another.
fn other_unit(r: &mut Random, value: &str) -> String {
    let Some((number, rest)) = value.split_once(' ').filter(|v| v.0.starts_with('"')) else { return r.of(&ODD).to_string() };
    let tail = rest.split_once('"').map_or("", |t| t.1);
    format!("{number} {}\"{tail}", r.of(&UNITS))
}
