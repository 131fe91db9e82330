//! From a [`Spec`] to a machine and its studies, through the registries.

use super::draft::Draft;
use super::{Block, Catalog, MachineBlock, RotorAxis, Spec, examine, held, joints, read_bytes, reader, stages};
use crate::diagnostic::{Diagnostic, Diagnostics, meant, nearest};
use crate::model::field::{Extra, Value};
use crate::model::part::{At, Rows};
use crate::model::system::{self, Machine, PartInput, System, Workspace};
use crate::parts;
use crate::study::operation;
use crate::study::support::turns_alike;
use crate::study::{self, Context, ErasedStudy};
use crate::text;
use crate::text::Text;
use std::sync::LazyLock;

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
    /// Whether this machine can answer every study; one refusal for all that refuse for the same reason.
    pub fn refusals(&self) -> Vec<Refusal> {
        self.refusals_by(|study| study.admit(&self.system))
    }

    /// The same before a run in such a context: one that is cancelled skips what takes long.
    pub fn refusals_in(&self, context: &Context) -> Vec<Refusal> {
        self.refusals_by(|study| study.prepare(&self.system, context))
    }

    /// Numbers of the studies with these names, or of these kinds where no name fits; all where none is named.
    ///
    /// # Errors
    /// A name that fits no study.
    pub fn chosen(&self, only: &[String]) -> Result<Vec<usize>, Diagnostic> {
        let studies = &self.studies;
        let mut wanted = vec![only.is_empty(); studies.len()];
        for word in only {
            let named = studies.iter().any(|s| &s.name == word);
            let fits = |s: &NamedStudy| if named { &s.name == word } else { s.study.kind() == word };
            if !studies.iter().any(fits) {
                let all = studies.iter().map(|s| s.name.as_str()).collect::<Vec<_>>().join(", ");
                let near = nearest(word, studies.iter().flat_map(|s| [s.name.as_str(), s.study.kind()]));
                let help =
                    near.map_or_else(|| text!("its studies: {all}", all), |n| meant(text::quoted(&n), text!("its studies: {all}", all)));
                return Err(Diagnostic::error("request.study", text!("the machine has no study \"{word}\"", word)).help(help));
            }
            for (w, s) in wanted.iter_mut().zip(studies) {
                *w |= fits(s);
            }
        }
        Ok((0..studies.len()).filter(|&i| wanted[i]).collect())
    }

    fn refusals_by(&self, admit: impl Fn(&dyn ErasedStudy) -> Result<(), Diagnostic>) -> Vec<Refusal> {
        let mut out: Vec<Refusal> = Vec::new();
        for (k, named) in self.studies.iter().enumerate() {
            let Err(mut diagnostic) = admit(&*named.study) else { continue };
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
            let unrested = matches!(r.diagnostic.code, "rest.refused" | "rest.turning" | "rest.not_held" | "rest.not_found")
                && turns_alike(&self.system);
            let able: Vec<usize> = r.studies.iter().filter(|k| unrested && self.admitted_turning(**k)).copied().collect();
            if !able.is_empty() {
                let studies = self.in_words(&able);
                let help = match r.diagnostic.help.take() {
                    Some(or) => text!("give {studies} about = \"turning\"; or {or}", studies, or),
                    None => text!("give {studies} about = \"turning\"", studies),
                };
                r.diagnostic.help = Some(Box::new(help));
            }
            r.diagnostic.message = text!("{studies}: {message}", studies = self.in_words(&r.studies), message = r.diagnostic.message);
        }
        out
    }

    /// A study knows the state that turns with the rotor, and the machine can answer it there.
    fn admitted_turning(&self, study: usize) -> bool {
        let Some(mut block) = self.spec.study(&self.studies[study].name).cloned() else { return false };
        if block.values.get("about").is_none() {
            return false;
        }
        block.values.set("about", Value::Choice("turning"), None);
        let turned = stages::study(&study::registry(), &block, &self.system, &mut Diagnostics::default());
        turned.is_some_and(|s| s.admit(&self.system).is_ok())
    }

    /// Studies by their names.
    fn in_words(&self, studies: &[usize]) -> Text {
        let names: Vec<String> = studies.iter().map(|&k| format!("\"{}\"", self.studies[k].name)).collect();
        match names.as_slice() {
            [one] => text!("study {one}", one),
            _ => text!("studies {names}", names = names.join(", ")),
        }
    }
}

/// All kinds of parts and studies this library knows.
pub fn catalog() -> &'static Catalog {
    static ALL: LazyLock<Catalog> = LazyLock::new(|| Catalog {
        parts: parts::registry().into_iter().map(|k| k.info).collect(),
        studies: study::registry().into_iter().map(|k| k.info).collect(),
        blocks: study::blocks().into_iter().map(|b| b.info).collect(),
    });
    &ALL
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
/// All mistakes, each once and at its place: of reading, of parts and their joints, of blocks beside them and of studies. What a block with
/// mistakes leaves open is no mistake of others. A text that is no TOML is read only.
pub fn load(text: &str) -> Result<Loaded, Diagnostics> {
    after_reading(reader::read_draft(text, catalog()))
}

/// [`load`] for the bytes of a file; text that is not UTF-8 is one diagnostic.
///
/// # Errors
/// As [`load`].
pub fn load_bytes(bytes: &[u8]) -> Result<Loaded, Diagnostics> {
    match std::str::from_utf8(bytes) {
        Ok(text) => load(text),
        Err(_) => Err(read_bytes(bytes, catalog()).1),
    }
}

fn after_reading((draft, read): (Option<Draft>, Diagnostics)) -> Result<Loaded, Diagnostics> {
    match draft {
        Some(draft) if read.has_errors() => Err(sorted(examine::all(&draft, read))),
        Some(draft) => assemble(draft.spec(), read),
        None => Err(read),
    }
}

/// Assembles what was read; `diagnostics` holds the warnings of reading.
///
/// # Errors
/// As [`load`].
pub fn assemble(spec: Spec, diagnostics: Diagnostics) -> Result<Loaded, Diagnostics> {
    let draft = Draft::from(&spec);
    straight(spec, diagnostics).map_err(|found| sorted(examine::all(&draft, found)))
}

/// Coordinates and states of parts at most: matrices are full, 128 MB each at this size.
const MOST: usize = 4000;

/// The system, unless its matrices are larger than what a computer holds.
pub(super) fn assembled(machine: Machine, parts: Vec<PartInput>) -> Result<System, Diagnostics> {
    let system = System::assemble(machine, parts)?;
    let (n, m) = (system.n(), system.m());
    if n + m > MOST {
        let message =
            text!("the machine has {n} coordinates and {m} states of parts; at most {most} together are computed", n, m, most = MOST);
        return Err(Diagnostics(vec![Diagnostic::error("machine.size", message)]));
    }
    Ok(system)
}

/// Assembles what has no mistakes; ends at the first stage that finds one.
fn straight(spec: Spec, mut diagnostics: Diagnostics) -> Result<Loaded, Diagnostics> {
    let registry = parts::registry();
    let mut built = Vec::with_capacity(spec.parts.len());
    for block in &spec.parts {
        let (input, fine) = stages::part(&registry, block, &mut diagnostics);
        if !fine {
            incomplete("part.incomplete", block, &mut diagnostics);
        }
        built.push(input);
    }
    joints::check(&spec.parts, &built, &[], &mut diagnostics);
    if diagnostics.has_errors() {
        return Err(diagnostics);
    }
    let machine = machine(&spec.machine, spec.extras.iter().map(|(word, b)| extra(word, b)).collect());
    let system = match assembled(machine, built.into_iter().flatten().collect()) {
        Ok(system) => system,
        Err(mut found) => {
            diagnostics.0.append(&mut found.0);
            return Err(diagnostics);
        }
    };
    check_finite(&system, &mut diagnostics);
    held::check(&system, &mut diagnostics);
    let known = study::blocks();
    for (extra, (_, block)) in system.machine.extras.iter().zip(&spec.extras) {
        stages::extra(&known, extra, block, &system, &mut diagnostics);
    }
    if diagnostics.has_errors() {
        return Err(diagnostics);
    }
    let system = match study::with_blocks(system) {
        Ok(system) => system,
        Err(mut found) => {
            diagnostics.0.append(&mut found.0);
            return Err(diagnostics);
        }
    };
    let registry = study::registry();
    let mut studies = Vec::with_capacity(spec.studies.len());
    let mut without = Vec::new();
    for block in &spec.studies {
        match stages::study(&registry, block, &system, &mut diagnostics) {
            Some(study) => studies.push(NamedStudy { name: block.name.clone(), study }),
            None => without.push(block),
        }
    }
    without.into_iter().for_each(|block| incomplete("study.incomplete", block, &mut diagnostics));
    let warnings = sorted(diagnostics);
    if warnings.has_errors() { Err(warnings) } else { Ok(Loaded { spec, system, studies, warnings }) }
}

/// A block that could not be built, when nothing says why.
fn incomplete(code: &'static str, block: &Block, diagnostics: &mut Diagnostics) {
    if !diagnostics.has_errors() {
        let message = text!("{kind} \"{name}\" cannot be built from what is given", kind = block.kind, name = block.name);
        diagnostics.push(Diagnostic::error(code, message).at(block.span.clone()));
    }
}

/// The machine as a whole.
pub(super) fn machine(block: &MachineBlock, extras: Vec<Extra>) -> Machine {
    // operating speeds stand for the speed of a machine that gives none
    let operating = operation::among(&extras).speed.map(|(from, to)| if to.abs() > from.abs() { to } else { from });
    Machine {
        name: block.name.clone(),
        speed: block.speed.or(operating),
        axis: match block.axis {
            RotorAxis::Vertical => system::Axis::Vertical,
            RotorAxis::Horizontal => system::Axis::Horizontal,
        },
        drive: block.drive,
        spin: None,
        extras,
        points: Vec::new(),
    }
}

/// A block beside the parts, as studies see it.
pub(super) fn extra(word: &'static str, b: &Block) -> Extra {
    Extra { word, kind: b.kind, name: b.name.clone(), values: b.values.clone() }
}

fn sorted(mut diagnostics: Diagnostics) -> Diagnostics {
    diagnostics.sort_by_place();
    diagnostics
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
            let message = text!("{kind} \"{name}\" gives a force that is not a finite number", kind = slot.part.kind(), name = slot.name);
            diagnostics.push(
                Diagnostic::error("part.not_finite", message)
                    .at(slot.span.clone())
                    .help(text!("a value of this part is too large or too small to compute with")),
            );
        }
    }
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
    fn a_position_without_effect_is_reported() {
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
    fn studies_that_refuse_for_one_reason_are_reported_once() {
        let hertz =
            "[[part]]\nkind = \"bearing_hertz\"\nbetween = [\"drum\", \"ground\"]\nlaw = \"radial\"\ncoefficient = \"1e9 N/m^1.5\"\n";
        let studies = "[[study]]\nkind = \"modes\"\n[[study]]\nkind = \"campbell\"\nspeed = { from = 1, to = 100 }\n";
        // states that turn exist where no direction is preferred
        let machine = MACHINE.replace("per_axis", "isotropic");
        let l = load(&format!("{machine}{hertz}{studies}")).unwrap_or_else(|d| panic!("{d:?}"));
        let r = l.refusals();
        assert_eq!(r.len(), 1, "{r:?}");
        assert_eq!(r[0].studies, [1, 2]);
        assert!(r[0].diagnostic.message.starts_with("studies \"modes\", \"campbell\": "), "{:?}", r[0].diagnostic);
        // campbell knows no other state
        assert!(r[0].diagnostic.help.as_deref().is_some_and(|h| h.starts_with("give study \"modes\" about")), "{:?}", r[0].diagnostic);
        assert!(load(MACHINE).unwrap_or_else(|d| panic!("{d:?}")).refusals().is_empty());
        let map = "[[study]]\nkind = \"stability_map\"\nspeed = { from = 1, to = 100 }\n";
        let help = |studies: &str| {
            let l = load(&format!("{machine}{hertz}{studies}")).unwrap_or_else(|d| panic!("{d:?}"));
            l.refusals()[0].diagnostic.help.as_ref().map_or_else(String::new, |h| h.to_string())
        };
        let campbell = "[[study]]\nkind = \"campbell\"\nspeed = { from = 1, to = 100 }\n";
        assert!(
            help(&format!("{campbell}{map}{studies}")).starts_with("give studies \"stability_map\", \"modes\" about = \"turning\"; or ")
        );
        assert!(!help(campbell).contains("about"), "{}", help(campbell));
    }
}
