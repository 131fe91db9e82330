//! From a [`Spec`] to a machine and its studies, through the registries.

use super::{Axis, Block, Catalog, Spec, held, read_bytes, reader};
use crate::diagnostic::{Diagnostic, Diagnostics, Span, nearest};
use crate::model::field::{Attach, Extra, Field, FieldKind, Value, Values};
use crate::model::part::{At, Rows};
use crate::model::system::{self, Drive, Machine, PartInput, System, Workspace};
use crate::parts;
use crate::study::{self, ErasedStudy, StudyKind};

/// A machine file that has been read and assembled.
pub struct Loaded {
    /// What the file says, in SI units.
    pub spec: Spec,
    /// The machine.
    pub system: System,
    /// The studies, in the order of the file.
    pub studies: Vec<NamedStudy>,
    /// Remarks that stop nothing.
    pub warnings: Diagnostics,
}

/// A study with its name in the file.
pub struct NamedStudy {
    /// Name, unique among the studies of the file.
    pub name: String,
    /// The study.
    pub study: Box<dyn ErasedStudy>,
}

/// A study, or several for the same reason, that the machine cannot answer.
#[derive(Clone, Debug)]
pub struct Refusal {
    /// Numbers of the studies in [`Loaded::studies`].
    pub studies: Vec<usize>,
    /// Why, with the names of the studies, at its place in the file.
    pub diagnostic: Diagnostic,
}

impl Loaded {
    /// Asks every study whether this machine can answer it; one refusal for all that refuse for the same reason.
    pub fn refusals(&self) -> Vec<Refusal> {
        let mut out: Vec<Refusal> = Vec::new();
        for (k, named) in self.studies.iter().enumerate() {
            let Err(mut diagnostic) = named.study.admit(&self.system) else { continue };
            if diagnostic.span.is_none() {
                diagnostic.span = self.spec.study(&named.name).and_then(|b| b.span.clone());
            }
            let same = |r: &&mut Refusal| {
                let d = &r.diagnostic;
                (d.code, &d.message, &d.span, &d.help) == (diagnostic.code, &diagnostic.message, &diagnostic.span, &diagnostic.help)
            };
            match out.iter_mut().find(same) {
                Some(r) => r.studies.push(k),
                None => out.push(Refusal { studies: vec![k], diagnostic }),
            }
        }
        for r in &mut out {
            // only some studies can be asked about another state
            let about = |k: &&usize| self.spec.study(&self.studies[**k].name).is_some_and(|b| b.values.get("about").is_some());
            if matches!(r.diagnostic.code, "rest.refused" | "rest.turning")
                && let Some(&k) = r.studies.iter().find(about)
            {
                let help = r.diagnostic.help.get_or_insert_default();
                *help = format!("give study \"{}\" about = \"turning\"; or {help}", self.studies[k].name);
            }
            let names: Vec<String> = r.studies.iter().map(|&k| format!("\"{}\"", self.studies[k].name)).collect();
            let word = if names.len() == 1 { "study" } else { "studies" };
            r.diagnostic.message = format!("{word} {}: {}", names.join(", "), r.diagnostic.message);
        }
        out
    }
}

/// All kinds of parts and studies this library knows.
pub fn catalog() -> Catalog {
    Catalog {
        parts: parts::registry().into_iter().map(|k| k.info).collect(),
        studies: study::registry().into_iter().map(|k| k.info).collect(),
        blocks: study::blocks().into_iter().map(|b| b.info).collect(),
    }
}

/// Reads and assembles a machine file.
///
/// ```
/// let text = r#"
/// [machine]
/// name = "rigid rotor"
/// [[part]]
/// kind = "disc"
/// name = "drum"
/// mass = "2.4 kg"
/// [[part]]
/// kind = "damper"
/// between = ["drum", "ground"]
/// damping = "42 N s/m"
/// "#;
/// let loaded = laval::file::load(text).unwrap_or_else(|d| panic!("{d:?}"));
/// assert_eq!(loaded.system.n(), 2);
/// let wrong = laval::file::load(&text.replace("\"drum\", \"ground\"", "\"drun\", \"ground\"")).err().unwrap();
/// assert_eq!(wrong.0[0].code, "body.missing");
/// ```
///
/// # Errors
/// All mistakes that could be found, each at its place: those of reading, and those of all studies when the parts can be read and joined;
/// otherwise those of reading, or of the parts and their joints.
pub fn load(text: &str) -> Result<Loaded, Diagnostics> {
    after_reading(reader::read_usable(text, &catalog()))
}

/// [`load`] for the bytes of a file; text that is not UTF-8 is one diagnostic.
///
/// # Errors
/// As [`load`].
pub fn load_bytes(bytes: &[u8]) -> Result<Loaded, Diagnostics> {
    match std::str::from_utf8(bytes) {
        Ok(text) => load(text),
        Err(_) => Err(read_bytes(bytes, &catalog()).1),
    }
}

fn after_reading((spec, read): (Option<(Spec, Vec<Block>)>, Diagnostics)) -> Result<Loaded, Diagnostics> {
    match spec {
        Some((spec, doubtful)) => assemble_with(spec, &doubtful, read),
        None => Err(read),
    }
}

/// Assembles what was read; `diagnostics` holds the warnings of reading.
///
/// # Errors
/// As [`load`].
pub fn assemble(spec: Spec, diagnostics: Diagnostics) -> Result<Loaded, Diagnostics> {
    assemble_with(spec, &[], diagnostics)
}

/// `doubtful` are studies that could be read in part.
fn assemble_with(spec: Spec, doubtful: &[Block], mut diagnostics: Diagnostics) -> Result<Loaded, Diagnostics> {
    let mut own = Diagnostics::default();
    let mut built = build_parts(&spec, &mut own);
    check_joints(&spec, &built, &mut own);
    let wrong = own.has_errors();
    diagnostics.0.append(&mut own.0);
    if wrong {
        return Err(sorted(diagnostics));
    }
    let inputs = built.drain(..).flatten().collect();
    let machine = Machine {
        name: spec.machine.name.clone(),
        speed: spec.machine.speed,
        axis: match spec.machine.axis {
            Axis::Vertical => system::Axis::Vertical,
            Axis::Horizontal => system::Axis::Horizontal,
        },
        drive: Drive::Prescribed,
        extras: spec.extras.iter().map(|(word, b)| Extra { word, kind: b.kind, name: b.name.clone(), values: b.values.clone() }).collect(),
    };
    let system = match System::assemble(machine, inputs) {
        Ok(system) => system,
        Err(found) => {
            diagnostics.0.extend(found.0);
            return Err(sorted(diagnostics));
        }
    };
    let mut own = Diagnostics::default();
    check_finite(&system, &mut own);
    held::check(&system, &mut own);
    check_extras(&spec, &system, &mut own);
    let wrong = own.has_errors();
    diagnostics.0.append(&mut own.0);
    if wrong {
        return Err(sorted(diagnostics));
    }
    let studies = build_studies(&spec, &system, &mut diagnostics);
    for block in doubtful {
        let mut own = Diagnostics::default();
        study::check_starts(&block.values, &system, &mut own);
        place(&mut own, block);
        diagnostics.0.append(&mut own.0);
    }
    let warnings = sorted(diagnostics);
    if warnings.has_errors() { Err(warnings) } else { Ok(Loaded { spec, system, studies, warnings }) }
}

/// Blocks beside the parts; no study is built on one that is wrong.
fn check_extras(spec: &Spec, system: &System, diagnostics: &mut Diagnostics) {
    let known = study::blocks();
    for (extra, (_, block)) in system.machine.extras.iter().zip(&spec.extras) {
        let mut own = Diagnostics::default();
        if let Some(kind) = known.iter().find(|k| k.info.word == extra.word) {
            (kind.check)(extra, system, &mut own);
        }
        place(&mut own, block);
        diagnostics.0.append(&mut own.0);
    }
}

fn sorted(mut diagnostics: Diagnostics) -> Diagnostics {
    diagnostics.sort_by_place();
    diagnostics
}

/// Every part by itself; `None` where it could not be built.
fn build_parts(spec: &Spec, diagnostics: &mut Diagnostics) -> Vec<Option<PartInput>> {
    let registry = parts::registry();
    let mut one = |block: &Block| {
        let kind = registry.iter().find(|k| k.info.kind == block.kind)?;
        let mut own = Diagnostics::default();
        let built = (kind.build)(&block.values, &mut own);
        if built.is_none() && !own.has_errors() {
            own.push(Diagnostic::error("part.incomplete", format!("{} \"{}\" cannot be built from what is given", block.kind, block.name)));
        }
        place(&mut own, block);
        diagnostics.0.append(&mut own.0);
        let (part, params) = built?;
        Some(PartInput { name: block.name.clone(), part, params, span: block.span.clone() })
    };
    spec.parts.iter().map(&mut one).collect()
}

/// A diagnostic of a block says whose it is; without a place of its own it stands at the block.
fn place(diagnostics: &mut Diagnostics, block: &Block) {
    for d in &mut diagnostics.0 {
        if d.span.is_none() {
            d.span.clone_from(&block.span);
        }
        if !d.message.starts_with(block.kind) {
            let name = if block.name == block.kind { String::new() } else { format!(" {:?}", block.name) };
            d.message = format!("{}{name}: {}", block.kind, d.message);
        }
    }
}

/// The points that parts are attached to: the body exists, is a body, and has the position.
fn check_joints(spec: &Spec, built: &[Option<PartInput>], diagnostics: &mut Diagnostics) {
    let is_body = |i: usize| built[i].as_ref().is_none_or(|p| p.part.layout().body);
    let bodies: Vec<&str> = (0..built.len()).filter(|&i| built[i].is_some() && is_body(i)).map(|i| spec.parts[i].name.as_str()).collect();
    let one = |block: &Block, field: &str, attach: &Attach, ground: bool, out: &mut Diagnostics| {
        let Some(name) = &attach.body else { return };
        let known = || {
            let mut all: Vec<String> = bodies.iter().map(|b| format!("\"{b}\"")).collect();
            all.extend(ground.then(|| "\"ground\"".to_string()));
            if all.is_empty() {
                "this machine has no body: add a part such as a disc".to_string()
            } else {
                format!("bodies of this machine: {}", all.join(", "))
            }
        };
        let span = block.values.span_of(field);
        let Some(i) = spec.parts.iter().position(|p| &p.name == name) else {
            let near = nearest(name, bodies.iter().copied().chain(ground.then_some("ground")));
            let help = near.map_or_else(known, |n| format!("did you mean \"{n}\"? {}", capital(&known())));
            let message = format!("{} \"{}\" is attached to \"{name}\", which does not exist", block.kind, block.name);
            out.push(Diagnostic::error("body.missing", message).at(span).label("no such body").help(help));
            return;
        };
        if !is_body(i) {
            let message =
                format!("{} \"{}\" is attached to \"{name}\", which is a {} and not a body", block.kind, block.name, spec.parts[i].kind);
            out.push(Diagnostic::error("body.kind", message).at(span).label("not a body").help(known()));
            return;
        }
        let Some(body) = &built[i] else { return };
        if attach.position != 0.0 && body.part.shape(&body.params, attach.position) == body.part.shape(&body.params, 0.0) {
            let message = format!("the position on \"{name}\" has no effect: that {} does not tilt", spec.parts[i].kind);
            out.push(
                Diagnostic::warning("body.position", message)
                    .at(span)
                    .label("no effect")
                    .help("give a disc its diametral_inertia to let it tilt"),
            );
        }
    };
    for block in &spec.parts {
        for field in block.values.names() {
            match block.values.get(field) {
                Some(Value::Attach(a)) => one(block, field, a, false, diagnostics),
                Some(Value::Between(a, b)) => {
                    one(block, field, a, true, diagnostics);
                    one(block, field, b, true, diagnostics);
                }
                _ => {}
            }
        }
    }
}

fn capital(s: &str) -> String {
    let mut chars = s.chars();
    chars.next().map(|f| f.to_uppercase().chain(chars).collect()).unwrap_or_default()
}

/// Every part gives finite forces at a typical moving state.
fn check_finite(system: &System, diagnostics: &mut Diagnostics) {
    let speed = system.machine.speed.unwrap_or(100.0);
    // different for every coordinate, so that differences between bodies do not vanish
    let share = |i: usize| 1.0 / (i as f64 + 2.0);
    let q: Vec<f64> = system.coordinates().iter().enumerate().map(|(i, c)| c.dof.typical * share(i)).collect();
    let v: Vec<f64> = q.iter().map(|x| x * speed).collect();
    let a: Vec<f64> = v.iter().map(|x| -x * speed).collect();
    let z: Vec<f64> = system.states().iter().enumerate().map(|(i, c)| c.dof.typical * share(i)).collect();
    let at = At { q: &q, v: &v, a: &a, z: &z, phase: 0.3, speed, spin_accel: 0.0, t: 0.0 };
    let mut ws = Workspace::default();
    for slot in system.slots() {
        let (mut force, mut rate, mut spin) = (vec![0.0; system.n()], vec![0.0; system.m()], 0.0);
        let mut rows = Rows { force: &mut force, rate: &mut rate, spin: &mut spin };
        system.residual(system.params(), &at, &mut rows, &mut ws, |s| s.name == slot.name);
        if !force.iter().chain(&rate).chain([&spin]).all(|x| x.is_finite()) {
            let message = format!("{} \"{}\" gives a force that is not a finite number", slot.part.kind(), slot.name);
            diagnostics.push(
                Diagnostic::error("part.not_finite", message)
                    .at(slot.span.clone())
                    .help("a value of this part is too large or too small to compute with"),
            );
        }
    }
}

fn build_studies(spec: &Spec, system: &System, diagnostics: &mut Diagnostics) -> Vec<NamedStudy> {
    let registry = study::registry();
    let mut one = |block: &Block| {
        let kind = registry.iter().find(|k| k.info.kind == block.kind)?;
        let mut own = Diagnostics::default();
        check_names(kind.info.fields.as_slice(), &block.values, &registry, system, &mut own);
        let built = (kind.build)(&block.values, system, &mut own);
        if built.is_none() && !own.has_errors() {
            own.push(Diagnostic::error(
                "study.incomplete",
                format!("{} \"{}\" cannot be built from what is given", block.kind, block.name),
            ));
        }
        place(&mut own, block);
        diagnostics.0.append(&mut own.0);
        Some(NamedStudy { name: block.name.clone(), study: built? })
    };
    spec.studies.iter().filter_map(&mut one).collect()
}

/// Coordinates and parameters that a study names exist.
fn check_names(fields: &[Field], values: &Values, registry: &[StudyKind], system: &System, out: &mut Diagnostics) {
    for field in fields {
        let span = || values.span_of(field.name);
        match (field.kind, values.get(field.name)) {
            (FieldKind::Coordinate, Some(Value::Text(name))) => coordinate(system, name, span(), out),
            (FieldKind::ParameterPath, Some(Value::Text(path))) if system.param(path).is_none() => {
                out.push(system.unknown_param(path).at(span()).label("unknown parameter"));
            }
            (FieldKind::Tolerances, Some(Value::Tolerances(list))) => {
                for t in list.iter().filter(|t| system.param(&t.parameter).is_none()) {
                    out.push(system.unknown_param(&t.parameter).at(t.span.clone()).label("unknown parameter"));
                }
            }
            // one that is named is checked where it stands
            (FieldKind::Study, Some(Value::Study(inner))) if inner.name.is_none() => {
                if let Some(kind) = registry.iter().find(|k| k.info.kind == inner.kind) {
                    check_names(&kind.info.fields, &inner.values, registry, system, out);
                }
            }
            _ => {}
        }
    }
}

fn coordinate(system: &System, name: &str, span: Option<Span>, out: &mut Diagnostics) {
    let all = || system.coordinates().iter().chain(system.states()).map(|c| c.name.as_str());
    if all().any(|n| n == name) {
        return;
    }
    let known = format!("coordinates of this machine: {}", all().collect::<Vec<_>>().join(", "));
    let help = nearest(name, all()).map_or_else(|| known.clone(), |n| format!("did you mean \"{n}\"? {}", capital(&known)));
    out.push(
        Diagnostic::error("coordinate.unknown", format!("there is no coordinate \"{name}\""))
            .at(span)
            .label("unknown coordinate")
            .help(help),
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    const MACHINE: &str = r#"
[machine]
name = "separator"
speed = "3000 rpm"
[[part]]
kind = "disc"
name = "drum"
mass = "2.4 kg"
eccentricity = "10 um"
[[part]]
kind = "foundation"
name = "base"
mass = "25 kg"
stiffness = "3.26e5 N/m"
damping = "6.59 N s/m"
[[part]]
kind = "bearing_cubic"
name = "bearing"
between = ["drum", "base"]
stiffness = "1.1e7 N/m"
cubic_stiffness = "8.7e10 N/m^3"
law = "per_axis"
[[study]]
kind = "nonlinear_response"
speed = { from = "25 rad/s", to = "8000 rad/s" }
"#;

    fn wrong(from: &str, to: &str) -> (String, Diagnostics) {
        let text = MACHINE.replacen(from, to, 1);
        assert_ne!(text, MACHINE);
        let found = load(&text).err().expect("a mistake");
        (text, found)
    }

    fn marked<'a>(text: &'a str, d: &Diagnostic) -> &'a str {
        &text[d.span.clone().expect("a place")]
    }

    #[test]
    fn the_registries_declare_what_the_reader_can_read() {
        assert_eq!(catalog().check().0, []);
    }

    #[test]
    fn a_machine_in_its_order() {
        let l = load(MACHINE).unwrap_or_else(|d| panic!("{d:?}"));
        assert_eq!((l.system.n(), l.system.m(), l.studies.len()), (4, 0, 1));
        assert_eq!(l.system.machine.speed, Some(3000.0 * std::f64::consts::TAU / 60.0));
        assert_eq!(l.system.slots().iter().map(|s| s.name.as_str()).collect::<Vec<_>>(), ["drum", "base", "bearing"]);
        let i = l.system.param("drum.eccentricity").expect("declared")[0];
        assert_eq!(l.system.params()[i], 10e-6);
        assert_eq!(l.studies[0].name, "nonlinear_response");
        assert_eq!(l.warnings.0, []);
        let l = load(&MACHINE.replace("speed = \"3000 rpm\"", "axis = \"horizontal\"")).unwrap_or_else(|d| panic!("{d:?}"));
        assert_eq!((l.system.machine.axis, l.system.machine.speed), (system::Axis::Horizontal, None));
    }

    #[test]
    fn a_missing_body_is_marked_and_the_right_one_proposed() {
        let (text, d) = wrong("\"drum\", \"base\"", "\"drum\", \"bass\"");
        assert_eq!(d.0.len(), 1);
        assert_eq!(d.0[0].code, "body.missing");
        assert!(marked(&text, &d.0[0]).contains("bass"), "{}", marked(&text, &d.0[0]));
        assert!(d.0[0].help.as_deref().is_some_and(|h| h.contains("\"base\"?")), "{d:?}");
    }

    #[test]
    fn mistakes_of_several_parts_come_together() {
        let text = MACHINE.replace("\"drum\", \"base\"", "\"drum\", \"bearing\"").replace(
            "[[study]]",
            "[[part]]\nkind = \"damper\"\nbetween = [\"base\", \"groud\"]\ndamping = 1\n[[part]]\nkind = \"liquid\"\nin = \"drum\"\n\
             cavity_radius = \"70 mm\"\ncavity_height = \"60 mm\"\ndensity = 1000\nfill = { free_surface_radius = \"71 mm\" }\n[[study]]",
        );
        let d = load(&text).err().expect("mistakes");
        assert_eq!(d.0.iter().map(|d| d.code).collect::<Vec<_>>(), ["body.kind", "body.missing", "liquid.fill"]);
        assert!(d.0.iter().all(|d| d.span.is_some()));
        assert!(marked(&text, &d.0[2]).contains("71 mm"));
    }

    #[test]
    fn mistakes_of_a_study_have_its_place() {
        let (text, d) = wrong("to = \"8000 rad/s\"", "to = \"25 rad/s\"");
        assert_eq!(d.0.len(), 1, "{d:?}");
        assert!(marked(&text, &d.0[0]).contains("25 rad/s"));
    }

    #[test]
    fn a_position_without_effect_is_told() {
        let l = load(&MACHINE.replace("[\"drum\", \"base\"]", "[{ body = \"drum\", at = \"40 mm\" }, \"base\"]"))
            .unwrap_or_else(|d| panic!("{d:?}"));
        assert_eq!(l.warnings.0.iter().map(|d| d.code).collect::<Vec<_>>(), ["body.position"]);
        let tilting = MACHINE
            .replace("[\"drum\", \"base\"]", "[{ body = \"drum\", at = \"40 mm\" }, \"base\"]")
            .replace("mass = \"2.4 kg\"", "mass = \"2.4 kg\"\ndiametral_inertia = 0.01\npolar_inertia = 0.015");
        // the position counts; but one bearing holds no disc upright
        let l = load(&tilting).unwrap_or_else(|d| panic!("{d:?}"));
        assert_eq!(l.warnings.0.iter().map(|d| d.code).collect::<Vec<_>>(), ["body.free"]);
    }

    #[test]
    fn studies_that_refuse_for_one_reason_are_told_once() {
        let hertz =
            "[[part]]\nkind = \"bearing_hertz\"\nbetween = [\"drum\", \"ground\"]\nlaw = \"radial\"\ncoefficient = \"1e9 N/m^1.5\"\n";
        let studies = "[[study]]\nkind = \"modes\"\n[[study]]\nkind = \"campbell\"\nspeed = { from = 1, to = 100 }\n";
        let l = load(&format!("{MACHINE}{hertz}{studies}")).unwrap_or_else(|d| panic!("{d:?}"));
        let r = l.refusals();
        assert_eq!(r.len(), 1, "{r:?}");
        assert_eq!(r[0].studies, [1, 2]);
        assert!(r[0].diagnostic.message.starts_with("studies \"modes\", \"campbell\": "), "{:?}", r[0].diagnostic);
        // campbell knows no other state
        assert!(r[0].diagnostic.help.as_deref().is_some_and(|h| h.starts_with("give study \"modes\" about")), "{:?}", r[0].diagnostic);
        assert!(load(MACHINE).unwrap_or_else(|d| panic!("{d:?}")).refusals().is_empty());
    }
}
