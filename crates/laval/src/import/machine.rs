//! The machine file of a model, as a person writes one.

use super::Imported;
use super::model::{Bearing, COEFFICIENTS, Kind, Mass, Model};
use super::notes::Note;
use super::shaft::{Sections, rounded, sections};
use crate::diagnostic::{Diagnostic, Diagnostics, Span};
use crate::file::writer::quoted;
use crate::model::part::Part;
use crate::parts::bearing_linear::BearingLinear;
use crate::parts::damper::Damper;
use crate::parts::disc::Disc;
use crate::parts::foundation::Foundation;
use crate::parts::shaft::Shaft;
use crate::text;
use crate::units::{format_number, write_number, write_si};
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::PI;
use std::fmt::Write as _;

/// Longest name of a block, characters.
const LONGEST: usize = 64;

pub(super) fn write(model: &Model, name: &str) -> Result<Imported, Diagnostics> {
    let mut notes = model.notes.clone();
    let shaft = sections(model, &mut notes)?;
    let mut w = Writer {
        model,
        shaft: &shaft,
        out: String::new(),
        names: BTreeSet::from(["ground".to_string()]),
        supports: BTreeMap::new(),
        wrong: Diagnostics::default(),
    };
    w.machine(name);
    w.shaft();
    w.discs();
    w.supports();
    for b in model.bearings.iter().filter(|b| !w.supports.values().any(|s| s.1 == Some(b.name.as_str()))).collect::<Vec<_>>() {
        if b.coefficients.iter().flatten().all(|x| *x == 0.0) {
            notes.add(Note::NoLateral, &b.name);
        } else {
            w.bearing(b);
        }
    }
    if w.wrong.has_errors() {
        return Err(w.wrong);
    }
    if model.version.starts_with('2') && model.bearings.iter().any(|b| b.speeds.len() > 2) {
        notes.say(text!("between the rows of a table ROSS 2 draws a spline, laval a monotone cubic as ROSS 3"));
    }
    if shaft.conical {
        notes.say(text!("cone = \"mid_section\" gives the cones of ROSS; without it they converge faster"));
    }
    notes.say(text!("lateral motion alone is carried over; axial = true and torsional = true of the shaft add the others"));
    notes.say(text!("ROSS takes g = 9.8065 m/s^2 in run_static, laval 9.80665 m/s^2"));
    let version = if model.version.is_empty() { String::new() } else { format!(" {}", plain(&model.version)) };
    let mut text = format!("# From a model of ROSS{version}.\n#\n");
    let notes = notes.texts();
    for note in &notes {
        let _ = writeln!(text, "# - {}", plain(&note.to_string()));
    }
    Ok(Imported { text: text + "\n" + &w.out, notes })
}

/// One line without control characters.
fn plain(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect()
}

struct Writer<'a> {
    model: &'a Model,
    shaft: &'a Sections,
    out: String,
    names: BTreeSet<String>,
    /// Name of the body at a node beside the shaft, and of the bearing that is part of it.
    supports: BTreeMap<usize, (String, Option<&'a str>)>,
    wrong: Diagnostics,
}

impl<'a> Writer<'a> {
    fn line(&mut self, key: &str, x: f64, unit: &str) {
        let _ = writeln!(self.out, "{key} = {}", value(x, unit));
    }
    fn given(&mut self, key: &str, x: f64, unit: &str) {
        if x != 0.0 {
            self.line(key, x, unit);
        }
    }
    fn part(&mut self, kind: &str, tag: &str) -> String {
        let name = self.name(tag, kind);
        let _ = write!(self.out, "\n[[part]]\nkind = {}\nname = {}\n", quoted(kind), quoted(&name));
        name
    }
    /// A tag as the name of a block, which no other has.
    fn name(&mut self, tag: &str, kind: &str) -> String {
        let usual = |c: char| c.is_alphanumeric() || matches!(c, ' ' | '_' | '-');
        let clean: String = tag.chars().map(|c| if usual(c) { c } else { ' ' }).take(LONGEST - 4).collect();
        let clean = clean.trim_matches(|c: char| !c.is_alphanumeric());
        let clean = if clean.is_empty() { kind } else { clean };
        let numbered = (2..).map(|k| format!("{clean} {k}"));
        let name = std::iter::once(clean.to_string()).chain(numbered).find(|n| !self.names.contains(n)).unwrap_or_default();
        self.names.insert(name.clone());
        name
    }

    fn machine(&mut self, name: &str) {
        let _ = writeln!(self.out, "[machine]\nname = {}", quoted(&plain(name)));
        if let Some(w) = self.model.rated {
            let _ = writeln!(self.out, "speed = {}", speeds(&[w])[0]);
        }
        self.out.push_str("axis = \"horizontal\"\n");
    }

    fn shaft(&mut self) {
        let (s, first) = (self.shaft, &self.shaft.first);
        self.part(Shaft::KIND, Shaft::KIND);
        if !first.material.name.is_empty() {
            let _ = writeln!(self.out, "# {}", plain(&first.material.name));
        }
        self.line("modulus", first.material.modulus, "Pa");
        self.line("shear_modulus", first.material.shear_modulus, "Pa");
        self.line("density", first.material.density, "kg/m^3");
        if first.shear != "cowper" {
            let _ = writeln!(self.out, "shear = {}", quoted(first.shear));
        }
        self.given("axial_force", first.axial_force, "N");
        self.given("torque", first.torque, "N m");
        self.given("mass_damping", first.damping.alpha + self.model.damping.alpha, "1/s");
        self.given("stiffness_damping", first.damping.beta + self.model.damping.beta, "s");
        let _ = writeln!(self.out, "elements = {}", s.elements);
        if s.conical {
            self.out.push_str("cone = \"mid_section\"\n");
        }
        self.out.push_str("section = [\n");
        let conical = |d: [f64; 2]| d[0] != d[1];
        for row in &s.rows {
            let _ = write!(self.out, "  {{ length = {}, outer_diameter = {}", value(row.length, "m"), value(row.outer[0], "m"));
            if conical(row.outer) {
                let _ = write!(self.out, ", end_outer_diameter = {}", value(row.outer[1], "m"));
            }
            if row.inner != [0.0; 2] {
                let _ = write!(self.out, ", inner_diameter = {}", value(row.inner[0], "m"));
            }
            if conical(row.inner) {
                let _ = write!(self.out, ", end_inner_diameter = {}", value(row.inner[1], "m"));
            }
            self.out.push_str(" },\n");
        }
        self.out.push_str("]\n");
        self.layers();
    }

    fn layers(&mut self) {
        let s = self.shaft;
        if s.layers.is_empty() {
            return;
        }
        let bits = |m: &super::model::Material| [m.modulus, m.shear_modulus, m.density];
        let own = s.layers.iter().any(|l| bits(&l.2.material) != bits(&s.first.material));
        self.out.push_str("layer = [\n");
        for (from, to, l) in &s.layers {
            let _ = write!(self.out, "  {{ from = {}, to = {}", value(*from, "m"), value(*to, "m"));
            let _ = write!(self.out, ", outer_diameter = {}, inner_diameter = {}", value(l.outer[0], "m"), value(l.inner[0], "m"));
            if own {
                let m = &l.material;
                let _ = write!(self.out, ", modulus = {}, shear_modulus = {}", value(m.modulus, "Pa"), value(m.shear_modulus, "Pa"));
                let _ = write!(self.out, ", density = {}", value(m.density, "kg/m^3"));
            }
            self.out.push_str(" },\n");
        }
        self.out.push_str("]\n");
    }

    fn discs(&mut self) {
        let on_shaft = self.model.masses.iter().filter(|m| m.node < self.shaft.nodes.len());
        for d in self.model.discs.iter().chain(on_shaft) {
            let Some(&at) = self.shaft.nodes.get(d.node) else {
                self.nowhere(&d.name, d.node, &d.span);
                continue;
            };
            self.disc(&d.tag, at, [d.mass, d.inertia[0], d.inertia[1]]);
        }
        for (name, at, inertia) in &self.shaft.sleeves {
            let tag = name.split_once('_').map_or(name.as_str(), |n| n.1);
            self.disc(tag, *at, *inertia);
        }
    }

    fn disc(&mut self, tag: &str, at: f64, [mass, diametral, polar]: [f64; 3]) {
        let name = self.part(Disc::KIND, tag);
        let _ = writeln!(self.out, "on = {}", self.place(at));
        self.line("mass", mass, "kg");
        self.given("polar_inertia", polar, "kg m^2");
        self.given("diametral_inertia", diametral, "kg m^2");
        // alpha of the whole rotor acts on discs too
        let alpha = self.model.damping.alpha;
        if alpha != 0.0 {
            self.part(Damper::KIND, &format!("damping of {name}"));
            let _ = writeln!(self.out, "between = [{}, \"ground\"]", quoted(&name));
            self.line("damping", alpha * mass, "N s/m");
            self.given("tilt_damping", alpha * diametral, "N m s");
        }
    }

    fn place(&self, at: f64) -> String {
        if at == 0.0 { quoted(Shaft::KIND) } else { format!("{{ body = \"shaft\", at = {} }}", value(at, "m")) }
    }

    fn nowhere(&mut self, element: &str, node: usize, span: &Option<Span>) {
        let message =
            text!("{element} is at node {node}, where neither the shaft nor a point mass is", element = text::quoted(element), node);
        self.wrong.push(Diagnostic::error("ross.node", message).at(span.clone()));
    }

    /// Pedestals: point masses beside the shaft, with the bearing that holds them when that is all there is.
    fn supports(&mut self) {
        let model = self.model;
        let mut masses: BTreeMap<usize, (&'a Mass, f64)> = BTreeMap::new();
        for m in model.masses.iter().filter(|m| m.node >= self.shaft.nodes.len()) {
            masses.entry(m.node).or_insert((m, 0.0)).1 += m.mass;
        }
        for (node, (m, mass)) in masses {
            let simple = |b: &&Bearing| {
                let c = &b.coefficients;
                let crossed = [1, 2, 5, 6].iter().any(|k| c[*k][0] != 0.0) || c.iter().any(|c| c[0] < 0.0);
                b.node == node && b.link.is_none() && b.speeds.len() < 2 && b.kind == Kind::Bearing && !crossed
            };
            let below = model.bearings.iter().find(simple);
            let name = self.part(Foundation::KIND, &m.tag);
            self.line("mass", mass, "kg");
            let both = |k: usize| below.map_or([0.0; 2], |b| [b.coefficients[k][0], b.coefficients[k + 3][0]]);
            let alpha = model.damping.alpha * mass;
            self.lateral("stiffness", both(0), "N/m");
            let damping = both(4).map(|c| c + alpha);
            if damping != [0.0; 2] {
                self.lateral("damping", damping, "N s/m");
            }
            self.supports.insert(node, (name, below.map(|b| b.name.as_str())));
        }
    }

    fn lateral(&mut self, key: &str, [x, y]: [f64; 2], unit: &str) {
        if x == y {
            self.line(key, x, unit);
        } else {
            let _ = writeln!(self.out, "{key} = {{ x = {}, y = {} }}", value(x, unit), value(y, unit));
        }
    }

    fn bearing(&mut self, b: &Bearing) {
        let mut point = |node: usize| match (self.shaft.nodes.get(node), self.supports.get(&node)) {
            (Some(at), _) => self.place(*at),
            (None, Some(support)) => quoted(&support.0),
            (None, None) => {
                self.nowhere(&b.name, node, &b.span);
                String::new()
            }
        };
        let first = point(b.node);
        let second = b.link.map_or(quoted("ground"), point);
        self.part(BearingLinear::KIND, &b.tag);
        let _ = writeln!(self.out, "between = [{first}, {second}]");
        let unit = |k: usize| if k < 4 { "N/m" } else { "N s/m" };
        let c = &b.coefficients;
        if b.speeds.len() < 2 {
            let alike = |k: usize| c[k][0] == c[k + 3][0] && c[k + 1][0] == 0.0 && c[k + 2][0] == 0.0;
            if alike(0) && alike(4) {
                self.line("stiffness", c[0][0], unit(0));
                self.given("damping", c[4][0], unit(4));
            } else {
                for (k, key) in COEFFICIENTS.iter().enumerate() {
                    self.given(key, c[k][0], unit(k));
                }
            }
            return;
        }
        self.out.push_str("beyond = \"linear\"\ntable = [\n");
        for (row, speed) in speeds(&b.speeds).iter().enumerate() {
            let _ = write!(self.out, "  {{ speed = {speed}");
            for (k, key) in COEFFICIENTS.iter().enumerate() {
                // kxx and kyy stand in every table
                if matches!(k, 0 | 3) || c[k].iter().any(|x| *x != 0.0) {
                    let _ = write!(self.out, ", {key} = {}", value(c[k][row], unit(k)));
                }
            }
            self.out.push_str(" },\n");
        }
        self.out.push_str("]\n");
    }
}

fn value(x: f64, unit: &str) -> String {
    quoted(write_si(rounded(x), unit).trim_end())
}

/// Speeds in rad/s where that is short for all of them or rpm is not, else in rpm.
fn speeds(all: &[f64]) -> Vec<String> {
    let in_rpm = |w: f64| format_number(w * 30.0 / PI, 10);
    let short = |text: String| text.len() <= 8;
    let rpm = !all.iter().all(|w| short(write_number(*w))) && all.iter().all(|w| short(in_rpm(*w)));
    let one = |w: &f64| if rpm { format!("{} rpm", in_rpm(*w)) } else { format!("{} rad/s", write_number(rounded(*w))) };
    all.iter().map(|w| quoted(&one(w))).collect()
}
