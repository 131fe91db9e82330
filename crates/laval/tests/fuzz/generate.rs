//! Machine files, most of them wrong: deterministic, one per number.

use crate::words::{EXTREME, ODD, list, literal, number, other_number, other_unit, point, quantity, range, usual};
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
    pub fn chance(&mut self, percent: usize) -> bool {
        self.below(100) < percent
    }
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }
    pub fn of<'a, T: ?Sized>(&mut self, list: &[&'a T]) -> &'a T {
        list[self.below(list.len())]
    }
}

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
    catalog: &'static Catalog,
    files: Vec<String>,
}

const BASE: &str = "[machine]\nname = \"small\"\nspeed = \"3000 rpm\"\n[[part]]\nkind = \"disc\"\nname = \"drum\"\nmass = \"2.4 kg\"\neccentricity = \"20 um\"\n\
    [[part]]\nkind = \"foundation\"\nname = \"base\"\nmass = \"25 kg\"\nstiffness = \"3e5 N/m\"\ndamping = \"50 N s/m\"\n\
    [[part]]\nkind = \"bearing_cubic\"\nname = \"bearing\"\nbetween = [\"drum\", \"base\"]\nlaw = \"per_axis\"\nstiffness = \"1.1e7 N/m\"\ncubic_stiffness = \"8.7e10 N/m^3\"\n\
    [[part]]\nkind = \"damper\"\nname = \"losses\"\nbetween = [\"drum\", \"ground\"]\ndamping = \"42 N s/m\"\n";

/// What separates, with few particles.
const SEPARATING: &str = "[[cup]]\nkind = \"swinging\"\nname = \"cups\"\non = \"drum\"\nmass = \"0.1 kg\"\ncentre_of_mass = \"90 mm\"\n\
    hinge_radius = \"80 mm\"\ncup_radius = \"15 mm\"\nbottom = \"110 mm\"\nsurface = \"20 mm\"\n\
    [suspension]\nliquid_density = \"1000 kg/m^3\"\nviscosity = \"1 mPa s\"\nparticle_density = \"1200 kg/m^3\"\ndiameter = \"5 um\"\n\
    [limits]\ndisplacement = \"1 mm\"\ngrowth_margin = 0.0\nspeed = \"6000 rpm\"\n\
    [[study]]\nkind = \"separation\"\ntime = \"5 min\"\nparticles = 32\n\
    [[study]]\nkind = \"operating_window\"\nspeed = { from = \"500 rpm\", to = \"3000 rpm\", points = 6 }\ntime = \"5 min\"\nparticles = 16\n";

/// A search of few runs.
const SEARCHING: &str = "[[study]]\nkind = \"optimum\"\nstudy = { kind = \"modes\" }\nvary = [{ parameter = \"losses.damping\", from = 1, to = 100 }]\n\
    maximise = \"least_damped_mode damping ratio\"\nruns = 20\nstarts = 1\n";

impl Sources {
    pub fn new(catalog: &'static Catalog) -> Self {
        let mut files = vec![
            include_str!("../../../../examples/01-oil-separator/machine.toml").to_string(),
            include_str!("../../../../examples/02-rigid-rotor/machine.toml").to_string(),
            include_str!("../../../../examples/03-overhung-disc/machine.toml").to_string(),
            include_str!("../../../../examples/04-ball-balancer/machine.toml").to_string(),
        ];
        files.extend(catalog.parts.iter().map(|k| format!("{BASE}{}", docs::every_key("part", k))));
        files.extend(catalog.studies.iter().map(|k| format!("{BASE}{}", docs::every_key("study", k))));
        files.push(format!("{BASE}{SEPARATING}"));
        files.push(format!("{BASE}{SEARCHING}"));
        for block in &catalog.blocks {
            files.extend(block.kinds.iter().filter(|_| block.several).map(|k| format!("{BASE}{}", docs::every_key(block.word, k))));
        }
        // with every optional key as well, the remarks of the example turned into keys
        let all_keys = |text: String| text.replace("\n# ", "\n");
        files.extend(catalog.parts.iter().map(|k| all_keys(format!("{BASE}{}", docs::every_key("part", k)))));
        files.extend(catalog.studies.iter().map(|k| all_keys(format!("{BASE}{}", docs::every_key("study", k)))));
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
        if r.chance(20) {
            self.separating(r, hostility, &names, &mut out);
        }
        for _ in 0..1 + r.below(2) {
            let info = &self.catalog.studies[r.below(self.catalog.studies.len())];
            out += &format!("[[study]]\nkind = \"{}\"\n", info.kind);
            self.fields(r, hostility, info, &names, &mut out);
        }
        out
    }

    /// What separates, what is separated and what is kept to, and a study that requires it.
    fn separating(&self, r: &mut Random, hostility: usize, names: &[String], out: &mut String) {
        // most random sizes fit no cup: some of the usual ones are kept, at another scale
        let length = |r: &mut Random, x: f64| {
            if hostility < 2 { literal(x * (0.5 + r.unit())) } else { number(r, 2, "m", &Bounds::positive(100.0)).to_string() }
        };
        for block in &self.catalog.blocks {
            if r.chance(10) {
                continue;
            }
            let kind = &block.kinds[r.below(block.kinds.len())];
            *out += &if block.several { format!("[[{}]]\nkind = \"{}\"\n", block.word, kind.kind) } else { format!("[{}]\n", block.word) };
            if hostility > 0 && r.chance(50) {
                self.fields(r, hostility, kind, names, out);
                continue;
            }
            *out += &match kind.kind {
                "swinging" => format!(
                    "hinge_radius = {}\ncup_radius = {}\nbottom = {}\nsurface = {}\ncentre_of_mass = {}\n",
                    length(r, 0.2),
                    length(r, 0.03),
                    length(r, 0.2),
                    length(r, 0.03),
                    length(r, 0.1)
                ),
                "fixed_angle" => format!(
                    "mouth_radius = {}\nangle = \"{} deg\"\ntube_radius = {}\nlength = {}\nsurface = {}\n",
                    length(r, 0.1),
                    5 + r.below(80),
                    length(r, 0.01),
                    length(r, 0.1),
                    length(r, 0.01)
                ),
                "disc_stack" => {
                    format!(
                        "inner_radius = {}\nouter_radius = {}\nangle = \"40 deg\"\ngaps = {}\n",
                        length(r, 0.03),
                        length(r, 0.1),
                        1 + r.below(90)
                    )
                }
                "tubular_bowl" => {
                    format!("length = {}\nbowl_radius = {}\nsurface_radius = {}\n", length(r, 0.3), length(r, 0.1), length(r, 0.03))
                }
                "decanter" => format!(
                    "cylinder_length = {}\ncone_length = {}\nbowl_radius = {}\nsurface_radius = {}\n",
                    length(r, 0.3),
                    length(r, 0.1),
                    length(r, 0.1),
                    length(r, 0.03)
                ),
                "suspension" => {
                    let size = length(r, 1e-5);
                    let sizes = [
                        format!("diameter = {size}\n"),
                        format!("median_diameter = {size}\ngeometric_deviation = 1.6\n"),
                        format!("characteristic_diameter = {size}\nspread = 1.2\n"),
                        format!("sizes = {{ diameter = [1e-6, {size}], share = [0.3, 0.7] }}\n"),
                    ];
                    let drag = r.of(&["", "drag = \"schiller_naumann\"\n", "volume_fraction = 0.05\n", "density_deviation = 1.1\n"]);
                    format!(
                        "liquid_density = {}\nviscosity = {}\nparticle_density = {}\n{}{drag}",
                        literal(700.0 + 400.0 * r.unit()),
                        literal(usual(r, "Pa s") * 1e-2),
                        literal(700.0 + 2000.0 * r.unit()),
                        sizes[r.below(4)]
                    )
                }
                _ => String::new(),
            };
            if kind.kind == "swinging" || kind.kind == "fixed_angle" {
                if r.chance(50) {
                    let body = names.first().map_or("drum", String::as_str);
                    *out += &format!("on = \"{body}\"\nmass = 0.1\ncount = {}\n", 1 + r.below(6));
                    *out += if kind.kind == "fixed_angle" { "centre_of_mass = 0.05\n" } else { "" };
                }
            } else if block.word == "limits" {
                self.fields(r, hostility, kind, names, out);
            }
        }
        let duty = r.of(&["time = \"5 min\"\n", "throughput = \"0.3 l/s\"\n", "time = \"1 s\"\n", ""]);
        let study = r.of(&[
            "kind = \"separation\"\n",
            "kind = \"separation\"\nramp = \"20 s\"\n",
            "kind = \"separation\"\nstart = \"slowest\"\nmodel = \"drifting\"\n",
            "kind = \"operating_window\"\nspeed = { from = 20.0, to = 300.0, points = 5 }\n",
            "kind = \"operating_window\"\nspeed = { from = 20.0, to = 300.0, points = 4 }\nobjective = \"time\"\n",
        ]);
        let speed =
            if study.contains("separation") && r.chance(60) { format!("speed = {}\n", literal(usual(r, "rad/s"))) } else { String::new() };
        *out += &format!("[[study]]\n{study}{speed}{duty}particles = {}\n", 16 + r.below(48));
    }

    fn fields(&self, r: &mut Random, hostility: usize, info: &KindInfo, names: &[String], out: &mut String) {
        // a few of the optional keys at a time: many exclude each other
        let optional = info.fields.iter().filter(|f| !f.required).count();
        let some = (250 / optional.max(1)).clamp(15, 35);
        for f in &info.fields {
            let given = match f.name {
                _ if f.required => 100 - hostility,
                // small grids come to their end
                "points" => 70,
                _ => some,
            };
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
            FieldKind::Text if f.name == "waterfall" && r.chance(70) => format!("\"{}\"", names.first().map_or("drum", String::as_str)),
            FieldKind::Text if ["minimise", "maximise"].contains(&f.name) && r.chance(90) => match r.below(4) {
                0 => format!("\"largest_displacement {}\"", names.first().map_or("drum", String::as_str)),
                _ => r.of(&["\"stable\"", "\"least_damped_mode damping ratio\"", "\"critical_speed order 1 forward\""]).into(),
            },
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
            FieldKind::ParameterRanges => {
                let each: Vec<String> = (0..1 + r.below(2))
                    .map(|_| {
                        let (path, unit, bounds) = self.path(r, names);
                        range(r, hostility, unit, &bounds, &format!("parameter = \"{path}\", "))
                    })
                    .collect();
                format!("[{}]", each.join(", "))
            }
            // a whole number
            FieldKind::Named { unit: "", .. } if f.name == "points" && r.chance(80) => r.of(&["2", "5", "12"]).into(),
            FieldKind::Named { unit, bounds } if r.chance(50) => {
                format!("{{ {} = {} }}", names.first().map_or("drum", |n| n.as_str()), quantity(r, hostility, unit, &bounds))
            }
            FieldKind::Named { unit, bounds } => quantity(r, hostility, unit, &bounds),
            FieldKind::Study => {
                let kinds = [
                    "modes\", speed = 100.0",
                    "critical_speeds\", speed = { from = 1.0, to = 900.0, points = 9 }",
                    "nonlinear_response\", speed = { from = 1.0, to = 900.0 }, harmonics = 1, max_points = 40",
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
                    // lengths, then diameters, then those inside them
                    let bounds = match c.1 {
                        "m" if hostility < 2 => Bounds::closed(1e-3 * 0.1f64.powi(i as i32), 0.1f64.powi(i as i32)),
                        _ => Bounds::within(1e9),
                    };
                    let mut values: Vec<f64> = (0..rows).map(|_| number(r, hostility, c.1, &bounds)).collect();
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
                if ["from", "to"].contains(&f.name) && r.chance(80) {
                    let sign = if f.name == "from" { -1.0 } else { 1.0 };
                    return format!("{{ \"drum.x\" = {}, \"drum.y\" = {} }}", literal(sign * 1e-4), literal(sign * 1e-3 * r.unit()));
                }
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
