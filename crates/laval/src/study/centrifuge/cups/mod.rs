//! The blocks `[[cup]]` and `[suspension]` of a machine file: what separates, and what is separated.

mod carried;
mod fields;
pub mod task;

pub use carried::{Carried, carried, exchanged, part as cup_part, uncarried};
pub use fields::{SUSPENSION, SUSPENSION_DOC, SUSPENSION_EXAMPLE, cup_kinds};

use crate::diagnostic::{Diagnostic, Diagnostics, meant, nearest};
use crate::model::field::{Attach, Extra, Field, FieldKind, Values};
use crate::model::system::{GRAVITY, System};
use crate::separation::cup::{Hanging, SwingingCup};
use crate::separation::exit::Cylinder;
use crate::separation::law::{Impossible, Law};
use crate::separation::load::{Ring, least_hinge_radius};
use crate::separation::measures::Cone;
use crate::separation::particle::{Drag, Medium, drop_factor};
use crate::separation::separator::{Bowl, Cup, Decanter, Discs, Separator};
use crate::separation::suspension::Powder;
use crate::separation::tube::Tube;
use crate::text;
use crate::text::Text;
use laval_num::interpolate::Interpolant;
use std::f64::consts::FRAC_PI_2;

/// One `[[cup]]`.
#[derive(Clone, Debug)]
pub struct Vessel {
    /// Its name.
    pub name: String,
    /// How it separates.
    pub separator: Separator,
    /// How it loads a body.
    pub load: Option<(Attach, Ring)>,
}

/// The `[suspension]`.
#[derive(Clone, Debug, PartialEq)]
pub struct Suspension {
    /// The liquid and the laws of motion in it.
    pub medium: Medium,
    /// The particles.
    pub powder: Powder,
    /// Temperature, K, when it was given.
    pub temperature: Option<f64>,
}

/// Says what is wrong with a cup.
pub fn check_cup(extra: &Extra, system: &System, out: &mut Diagnostics) {
    vessel(extra, system, out);
}
/// Says what is wrong with the suspension.
pub fn check_suspension(extra: &Extra, _: &System, out: &mut Diagnostics) {
    suspension(&extra.values, out);
}

fn wrong(out: &mut Diagnostics, values: &Values, field: &str, code: &'static str, message: Text, help: Text) {
    out.push(Diagnostic::error(code, message).at(values.span_of(field)).help(help));
}

/// Reads a cup; says all that is wrong.
pub fn vessel(extra: &Extra, system: &System, out: &mut Diagnostics) -> Option<Vessel> {
    let (v, before) = (&extra.values, out.0.len());
    let n = |field: &str| v.number(field).unwrap_or(0.0);
    let separator = match extra.kind {
        "swinging" => swinging(v, out)?,
        "fixed_angle" => {
            let tube =
                Tube { mouth: n("mouth_radius"), angle: n("angle"), radius: n("tube_radius"), length: n("length"), surface: n("surface") };
            if !(tube.surface < tube.length) {
                wrong(
                    out,
                    v,
                    "surface",
                    "cup.empty",
                    text!("the tube holds no liquid: its surface lies at the bottom or below"),
                    text!("measure surface and length from the mouth"),
                );
            }
            if v.number("centre_of_mass").is_some_and(|l| !(l <= THICK * tube.length)) {
                let message = text!("the centre of mass lies far below the bottom of the tube");
                wrong(out, v, "centre_of_mass", "cup.centre", message, text!("measure it from the mouth, with contents"));
            }
            if tube.mouth - tube.radius * tube.angle.cos() <= 0.0 {
                wrong(out, v, "mouth_radius", "cup.axis", text!("the tube reaches across the spin axis"), text!("increase mouth_radius"));
            } else {
                apart(v, ("mouth_radius", tube.mouth), (tube.radius, 0.0), &[tube.angle], out);
            }
            Separator::Tube(tube, GRAVITY)
        }
        "disc_stack" => {
            let d = Discs {
                inner: n("inner_radius"),
                outer: n("outer_radius"),
                angle: n("angle"),
                gaps: v.integer("gaps").unwrap_or(1) as f64,
                spacing: n("spacing"),
            };
            if !(d.inner < d.outer) {
                wrong(out, v, "inner_radius", "cup.radii", text!("inner_radius must be smaller than outer_radius"), text!("exchange them"));
            }
            Separator::Discs(d)
        }
        kind => {
            let (radius, surface) = (n("bowl_radius"), n("surface_radius"));
            if !(surface < radius) {
                wrong(
                    out,
                    v,
                    "surface_radius",
                    "cup.radii",
                    text!("the liquid's surface must lie inside the bowl: surface_radius below bowl_radius"),
                    text!("the surface is the inner face of the liquid"),
                );
            }
            if kind == "tubular_bowl" {
                Separator::Bowl(Bowl { length: n("length"), radius, surface })
            } else {
                let rule = if v.choice("cone") == Some("slices") { Cone::Slices } else { Cone::TextBook };
                Separator::Decanter(Decanter { cylinder: n("cylinder_length"), cone: n("cone_length"), radius, surface, rule })
            }
        }
    };
    let load = load(extra, &separator, system, out);
    (out.0.len() == before).then_some(Vessel { name: extra.name.clone(), separator, load })
}

/// Largest size of a cup with its walls over that of its inside.
const THICK: f64 = 1.5;

fn swinging(v: &Values, out: &mut Diagnostics) -> Option<Separator> {
    let n = |field: &str| v.number(field).unwrap_or(0.0);
    let held = v.number("tilt");
    let along = v.number("centre_of_mass");
    if along.is_none() && held.is_none() {
        wrong(
            out,
            v,
            "centre_of_mass",
            "cup.centre",
            text!("how far the cup swings out depends on its centre of mass, which is missing"),
            text!("add centre_of_mass = \"60 mm\" (from the hinge, with contents), or hold the cup at a tilt"),
        );
        return None;
    }
    let (mass, along) = (v.number("mass").unwrap_or(1.0), along.unwrap_or(n("bottom")));
    let body = Hanging {
        mass,
        across: n("centre_of_mass_across"),
        along,
        moment_across: n("moment_across"),
        moment_along: v.number("moment_along").unwrap_or(mass * along * along),
        product: n("moment_product"),
    };
    if v.number("moment_along").is_some() && v.number("mass").is_none() {
        wrong(out, v, "moment_along", "cup.mass", text!("a moment of inertia needs the mass it belongs to"), text!("add mass"));
    }
    if body.moment_along * body.moment_across < body.product * body.product || body.moment_along < mass * along * along * (1.0 - 1e-9) {
        wrong(
            out,
            v,
            "moment_along",
            "cup.moments",
            text!("no body has these second moments about the hinge"),
            text!(
                "moment_along is at least mass times centre_of_mass squared; moment_product squared is at most moment_along times moment_across"
            ),
        );
    }
    let vessel = Cylinder { radius: n("cup_radius"), bottom: n("bottom"), top: n("surface") };
    if !(vessel.top < vessel.bottom) {
        wrong(
            out,
            v,
            "surface",
            "cup.empty",
            text!("the cup holds no liquid: its surface lies at the bottom or below"),
            text!("measure surface and bottom from the hinge, outwards"),
        );
    }
    // the bottom has a thickness and a foot
    if !(along <= THICK * vessel.bottom) && v.number("centre_of_mass").is_some() {
        wrong(
            out,
            v,
            "centre_of_mass",
            "cup.centre",
            text!(
                "the centre of mass lies {along} from the hinge, far below the bottom of the cup at {bottom}",
                along = text::quantity(along, "m"),
                bottom = text::quantity(vessel.bottom, "m")
            ),
            text!("measure both from the hinge"),
        );
    }
    if !(body.across.abs() <= THICK * vessel.radius) {
        wrong(
            out,
            v,
            "centre_of_mass_across",
            "cup.centre",
            text!("the centre of mass lies outside the cup"),
            text!("at most cup_radius to either side of its axis"),
        );
    }
    let hinge = n("hinge_radius");
    if hinge + vessel.top.min(0.0) < 0.0 {
        wrong(
            out,
            v,
            "surface",
            "cup.axis",
            text!("the surface of the liquid reaches across the spin axis when the cup has swung out"),
            text!("increase hinge_radius"),
        );
    }
    const STEPS: usize = 90;
    let way: Vec<f64> = match held {
        Some(tilt) => vec![tilt],
        None => (0..=STEPS).map(|k| FRAC_PI_2 * k as f64 / STEPS as f64).collect(),
    };
    apart(v, ("hinge_radius", hinge), (vessel.radius, vessel.top), &way, out);
    let hanging = SwingingCup { hinge, body, damping: n("hinge_damping"), gravity: GRAVITY };
    Some(Separator::Cup(Cup { hanging, vessel, held }))
}

/// Neighbours of a ring of vessels (radius, begin of the liquid) do not reach into each other, on a radius given by a field, at these tilts.
fn apart(v: &Values, (field, given): (&str, f64), (radius, top): (f64, f64), tilts: &[f64], out: &mut Diagnostics) {
    let count = v.integer("count").unwrap_or(2).max(1) as usize;
    let needed = tilts.iter().map(|&t| (least_hinge_radius(count, radius, top, t), t));
    let Some((least, tilt)) = needed.reduce(|a, b| if b.0 > a.0 { b } else { a }) else { return };
    if !(given >= least - 1e-9 * radius) {
        let inner = text::quantity(radius, "m");
        let message = if tilt == 0.0 {
            text!("{count} cups with an inner radius of {inner} reach into each other as they hang", count, inner)
        } else {
            let tilt = text::quantity(tilt, "rad");
            text!("{count} cups with an inner radius of {inner} reach into each other at a tilt of {tilt}", count, inner, tilt)
        };
        let help = text!(
            "{field} is at least {least} for {count} of them, without their walls; or give fewer with count",
            field,
            least = text::quantity(least, "m"),
            count
        );
        wrong(out, v, field, "cup.overlap", message, help);
    }
}

/// How cups load the body that carries them.
fn load(extra: &Extra, separator: &Separator, system: &System, out: &mut Diagnostics) -> Option<(Attach, Ring)> {
    let v = &extra.values;
    let on = v.attach("on")?;
    let name = on.body.clone()?;
    let bodies = || system.slots().iter().filter(|s| s.layout.body).map(|s| s.name.as_str());
    if !bodies().any(|b| b == name) {
        let all = bodies().collect::<Vec<_>>().join(", ");
        let help = match nearest(&name, bodies()) {
            Some(b) => meant(text::quoted(&b), text!("bodies of this machine: {all}", all)),
            None => text!("bodies of this machine: {all}", all),
        };
        let message = text!("\"{name}\", which carries it, does not exist", name);
        out.push(Diagnostic::error("body.missing", message).at(v.span_of("on")).about(name).help(help));
        return None;
    }
    let parameters = system.slot(&name).and_then(|s| s.part.body()).map(|b| b.parameters()).unwrap_or_default();
    let mass = text!("\"{name}\" has no mass of its own that cups could add to", name);
    let unbalance = text!("\"{name}\" has no unbalance of its own that cups could add to", name);
    for (message, parameter) in [(mass, parameters.mass), (unbalance, parameters.unbalance)] {
        if parameter.is_none() {
            wrong(out, v, "on", "cup.body", message, text!("attach the cups to a disc"));
            return None;
        }
    }
    let (Some(mass), Some(centre)) = (v.number("mass"), v.number("centre_of_mass")) else {
        wrong(
            out,
            v,
            "on",
            "cup.mass",
            text!("what loads a body needs mass and centre_of_mass"),
            text!("add both, with contents; or leave on out"),
        );
        return None;
    };
    let count = v.integer("count").unwrap_or(2).max(1) as usize;
    let mut list = |field: &str| {
        let given = v.list(field).unwrap_or_default().to_vec();
        if !given.is_empty() && given.len() != count {
            wrong(
                out,
                v,
                field,
                "cup.count",
                text!("{given} values are given for {count} cups", given = given.len(), count),
                text!("give one for each, 0 for those that fit"),
            );
        }
        given
    };
    let (masses, centres) = (list("mass_differences"), list("centre_differences"));
    if centres.iter().any(|d| !(d.abs() < centre)) {
        let message = text!("a centre of mass would lie at the hinge or beyond it");
        wrong(out, v, "centre_differences", "cup.centre", message, text!("differences are small against centre_of_mass"));
    }
    if masses.iter().any(|d| mass + d < 0.0) {
        wrong(
            out,
            v,
            "mass_differences",
            "cup.negative",
            text!("a cup would weigh less than nothing"),
            text!("a missing cup is minus its mass"),
        );
    }
    let (hinge, held) = match separator {
        Separator::Cup(c) => (c.hanging, c.held),
        Separator::Tube(t, gravity) => {
            (SwingingCup { hinge: t.mouth, body: Hanging::point(mass, centre), damping: 0.0, gravity: *gravity }, Some(t.angle))
        }
        _ => return None,
    };
    let ring = Ring { cup: hinge, held, count, mass_differences: masses, centre_differences: centres };
    Some((on, ring))
}

/// Reads the suspension; says all that is wrong.
pub fn suspension(v: &Values, out: &mut Diagnostics) -> Option<Suspension> {
    let before = out.0.len();
    let viscosity = viscosity(v, out);
    let size = sizes(v, out);
    let density = densities(v, out);
    let n = |field: &str, default: f64| v.number(field).unwrap_or(default);
    let mut factor = n("shape_factor", 1.0);
    if let (Some(inside), Some(outside)) = (v.number("drop_viscosity"), viscosity) {
        factor *= drop_factor(inside / outside);
    }
    if out.0.len() > before {
        return None;
    }
    let medium = Medium {
        drag: if v.choice("drag") == Some("schiller_naumann") { Drag::SchillerNaumann } else { Drag::Stokes },
        drag_factor: factor,
        added_mass: n("added_mass", 0.0),
        lift: n("lift", 0.0),
        volume_fraction: n("volume_fraction", 0.0),
        hindered_exponent: n("hindered_exponent", 4.65),
        ..Medium::new(n("liquid_density", 1000.0), viscosity?)
    };
    Some(Suspension { medium, powder: Powder { size: size?, density: density? }, temperature: v.number("temperature") })
}

fn viscosity(v: &Values, out: &mut Diagnostics) -> Option<f64> {
    match (v.number("viscosity"), v.columns("viscosity_table"), v.number("temperature")) {
        (Some(mu), None, _) => Some(mu),
        (None, Some(table), Some(t)) => {
            let (ts, mus) = (table.get("temperature")?, table.get("viscosity")?);
            if !mus.iter().all(|m| *m > 0.0) {
                wrong(
                    out,
                    v,
                    "viscosity_table",
                    "suspension.viscosity",
                    text!("a viscosity in the table is not positive"),
                    text!("check the column and its unit"),
                );
                return None;
            }
            let logs: Vec<f64> = mus.iter().map(|m| m.ln()).collect();
            match Interpolant::new(ts, &logs) {
                Ok(curve) => {
                    let (low, high) = curve.range();
                    if t < low || t > high {
                        wrong(
                            out,
                            v,
                            "temperature",
                            "suspension.temperature",
                            text!("the viscosity table goes from {low} K to {high} K; at {t} K it says nothing", low, high, t),
                            text!("extend the table: viscosity is not extrapolated"),
                        );
                        return None;
                    }
                    Some(curve.value(t).exp())
                }
                Err(e) => {
                    wrong(
                        out,
                        v,
                        "viscosity_table",
                        "suspension.viscosity",
                        text!("{why}", why = e),
                        text!("give temperatures in increasing order"),
                    );
                    None
                }
            }
        }
        (None, Some(_), None) => {
            wrong(
                out,
                v,
                "temperature",
                "suspension.temperature",
                text!("a viscosity table needs the temperature at which the liquid is separated"),
                text!("add temperature = \"60 degC\""),
            );
            None
        }
        (Some(_), Some(_), _) => {
            wrong(
                out,
                v,
                "viscosity",
                "suspension.viscosity",
                text!("both viscosity and viscosity_table are given"),
                text!("keep one of them"),
            );
            None
        }
        (None, None, _) => {
            wrong(
                out,
                v,
                "viscosity",
                "suspension.viscosity",
                text!("the viscosity of the liquid is missing"),
                text!("add viscosity = \"1 mPa s\", or a viscosity_table and a temperature"),
            );
            None
        }
    }
}

fn sizes(v: &Values, out: &mut Diagnostics) -> Option<Law> {
    const WAYS: [&str; 4] = ["diameter", "median_diameter", "characteristic_diameter", "sizes"];
    let given: Vec<&str> = WAYS.into_iter().filter(|w| v.get(w).is_some()).collect();
    let [way] = given.as_slice() else {
        let message = if given.is_empty() {
            text!("the size of the particles is missing")
        } else {
            text!("the sizes are given in several ways: {given}", given = given.join(", "))
        };
        wrong(
            out,
            v,
            given.first().copied().unwrap_or(""),
            "suspension.size",
            message,
            text!("say one of diameter; median_diameter with geometric_deviation; characteristic_diameter with spread; sizes"),
        );
        return None;
    };
    let mut need = |field: &str| {
        let x = v.number(field);
        if x.is_none() {
            wrong(out, v, way, "suspension.size", text!("{way} needs {field} beside it", way, field), text!("add {field}", field));
        }
        x
    };
    match *way {
        "diameter" => v.number("diameter").map(Law::Single),
        "median_diameter" => Some(Law::LogNormal { gsd: need("geometric_deviation")?, median: v.number(way)? }),
        "characteristic_diameter" => Some(Law::RosinRammler { spread: need("spread")?, characteristic: v.number(way)? }),
        _ => {
            let table = v.columns("sizes")?;
            let d = table.get("diameter")?;
            let law = match (table.get("undersize"), table.get("share")) {
                (Some(u), None) => Law::cumulative(d, u),
                (None, Some(s)) => Law::classes(d, s),
                _ => Err(Impossible(text!("a powder needs either undersize or share for its diameters"))),
            };
            law.map_err(|Impossible(why)| {
                wrong(out, v, "sizes", "suspension.size", why, text!("sizes = {{ diameter = [..], undersize = [..] }}"))
            })
            .ok()
        }
    }
}

fn densities(v: &Values, out: &mut Diagnostics) -> Option<Law> {
    let median = v.number("particle_density")?;
    match (v.columns("densities"), v.number("density_deviation")) {
        (Some(_), Some(_)) => {
            wrong(
                out,
                v,
                "densities",
                "suspension.density",
                text!("the densities are given in two ways"),
                text!("keep densities or density_deviation"),
            );
            None
        }
        (Some(table), None) => {
            let law = Law::classes(table.get("density")?, table.get("share")?);
            law.map_err(|Impossible(why)| {
                wrong(out, v, "densities", "suspension.density", why, text!("densities = {{ density = [..], share = [..] }}"))
            })
            .ok()
        }
        (None, Some(gsd)) => Some(Law::LogNormal { median, gsd }),
        (None, None) => Some(Law::Single(median)),
    }
}

/// The cup a study requires by name, or the only one.
pub fn the_vessel(values: &Values, system: &System, out: &mut Diagnostics) -> Option<Vessel> {
    let cups: Vec<&Extra> = system.machine.extras.iter().filter(|e| e.word == "cup").collect();
    let names = cups.iter().map(|c| format!("\"{}\"", c.name)).collect::<Vec<_>>().join(", ");
    let found = match values.text("cup") {
        Some(name) => cups
            .iter()
            .find(|c| c.name == name)
            .ok_or_else(|| (text!("there is no cup named \"{name}\"", name), text!("cups of this machine: {names}", names))),
        None if cups.len() > 1 => Err((text!("this machine has several cups"), text!("add cup = .. with one of {names}", names))),
        None => cups.first().ok_or_else(|| {
            (
                text!("this machine has nothing that separates"),
                text!("add a block [[cup]] with kind = \"swinging\", \"fixed_angle\", \"tubular_bowl\", \"disc_stack\" or \"decanter\""),
            )
        }),
    };
    match found {
        Ok(extra) => vessel(extra, system, &mut Diagnostics::default()),
        Err((message, help)) => {
            wrong(out, values, "cup", "separation.cup", message, help);
            None
        }
    }
}

/// The suspension of the machine.
pub fn the_suspension(values: &Values, system: &System, out: &mut Diagnostics) -> Option<Suspension> {
    match system.machine.extras.iter().find(|e| e.word == "suspension") {
        Some(extra) => suspension(&extra.values, &mut Diagnostics::default()),
        None => {
            wrong(
                out,
                values,
                "",
                "separation.suspension",
                text!("this machine has nothing to separate"),
                text!("add a block [suspension] with liquid_density, viscosity, particle_density and diameter"),
            );
            None
        }
    }
}

/// Field: which cup.
pub const CUP: Field = Field::optional("cup", FieldKind::Text, "", "name of the [[cup]]; the only one when left out");
