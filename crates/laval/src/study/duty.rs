//! The blocks `[[cup]]` and `[suspension]` of a machine file: what separates, and what is separated.

use crate::diagnostic::{Diagnostic, Diagnostics, nearest};
use crate::model::field::{Attach, Bounds, Extra, Field, FieldKind, KindInfo, Values};
use crate::model::system::{GRAVITY, System};
use crate::separation::cup::{Hanging, SwingingCup};
use crate::separation::ensemble::Powder;
use crate::separation::exit::Cylinder;
use crate::separation::law::{Impossible, Law};
use crate::separation::load::Ring;
use crate::separation::machine::{Bowl, Cup, Decanter, Discs, Separator};
use crate::separation::measures::Cone;
use crate::separation::particle::{Drag, Medium, drop_factor};
use crate::separation::tube::Tube;
use laval_num::interpolate::Interpolant;
use std::f64::consts::FRAC_PI_2;

const fn length(bounds: Bounds) -> FieldKind {
    FieldKind::Quantity { unit: "m", bounds }
}
const POSITIVE: FieldKind = length(Bounds::positive(100.0));
const ON: Field = Field::optional(
    "on",
    FieldKind::Attach { ground: false },
    "",
    "the body that carries it, and the height of the hinges on it; its inertia and unbalance then follow the tilt",
);
const COUNT: Field = Field::optional("count", FieldKind::Integer { min: 1, max: 1000 }, "2", "how many, at equal pitch");
const MASS: Field = Field::optional(
    "mass",
    FieldKind::Quantity { unit: "kg", bounds: Bounds::positive(1e5) },
    "",
    "mass of one with its contents, m; needed when it loads a body",
);
const DIFFERENCES: Field = Field::optional(
    "mass_differences",
    FieldKind::List { unit: "kg", bounds: Bounds::within(1e5) },
    "",
    "what each weighs more than mass, one after the other in the sense of rotation from the key mark; a missing one is - mass",
);

const SWINGING: &[Field] = &[
    ON,
    COUNT,
    Field::required("hinge_radius", length(Bounds::up_to(100.0)), "radius of the hinge from the spin axis, L_st"),
    Field::required("cup_radius", POSITIVE, "inner radius, r"),
    Field::required("bottom", POSITIVE, "distance from the hinge to the bottom along the cup, L"),
    Field::optional(
        "surface",
        length(Bounds::within(100.0)),
        "0 m",
        "distance from the hinge to the surface of the liquid along the cup, y_top",
    ),
    Field::optional(
        "centre_of_mass",
        POSITIVE,
        "",
        "distance from the hinge to the centre of mass of the cup with its contents, l; needed unless tilt is given",
    ),
    Field::optional(
        "tilt",
        FieldKind::Quantity { unit: "rad", bounds: Bounds::closed(0.0, FRAC_PI_2) },
        "",
        "a tilt from the vertical the cup is held at, instead of the one it swings out to",
    ),
    MASS,
    Field::optional("centre_of_mass_across", length(Bounds::within(100.0)), "0 m", "centre of mass across the cup, outwards when it hangs"),
    Field::optional(
        "moment_along",
        FieldKind::Quantity { unit: "kg m^2", bounds: Bounds::positive(1e6) },
        "",
        "second moment about the hinge along the cup, Jy = int y^2 dm; that of a point mass when absent",
    ),
    Field::optional(
        "moment_across",
        FieldKind::Quantity { unit: "kg m^2", bounds: Bounds::up_to(1e6) },
        "0 kg m^2",
        "second moment across the cup, Jx = int x^2 dm",
    ),
    Field::optional("moment_product", FieldKind::Quantity { unit: "kg m^2", bounds: Bounds::within(1e6) }, "0 kg m^2", "Jxy = int x y dm"),
    Field::optional(
        "hinge_damping",
        FieldKind::Quantity { unit: "1/s", bounds: Bounds::up_to(1e6) },
        "0 1/s",
        "rate at which the hinge damps the swing, cd",
    ),
    DIFFERENCES,
    Field::optional(
        "centre_differences",
        FieldKind::List { unit: "m", bounds: Bounds::within(10.0) },
        "",
        "how much farther from the hinge each one's centre of mass lies: pellets of different height in cups that weigh the same",
    ),
];

const FIXED_ANGLE: &[Field] = &[
    ON,
    COUNT,
    Field::required("mouth_radius", length(Bounds::up_to(100.0)), "radius of the centre of the mouth from the spin axis"),
    Field::required(
        "angle",
        FieldKind::Quantity { unit: "rad", bounds: Bounds { min: 0.0, max: FRAC_PI_2, min_open: true } },
        "angle between tube and spin axis",
    ),
    Field::required("tube_radius", POSITIVE, "inner radius, r"),
    Field::required("length", POSITIVE, "from the mouth to the bottom"),
    Field::optional(
        "surface",
        length(Bounds::up_to(100.0)),
        "0 m",
        "from the mouth to the surface of the liquid when the tube stands upright",
    ),
    Field::optional("centre_of_mass", POSITIVE, "", "distance from the mouth to the centre of mass of the tube with its contents"),
    MASS,
    DIFFERENCES,
];

const TUBULAR: &[Field] = &[
    Field::required("length", POSITIVE, "length of the liquid, Lb"),
    Field::required("bowl_radius", POSITIVE, "inner radius of the bowl, r2"),
    Field::required("surface_radius", POSITIVE, "radius of the liquid's surface, r1"),
];
const DISCS: &[Field] = &[
    Field::required("inner_radius", POSITIVE, "inner edge of the discs, r1"),
    Field::required("outer_radius", POSITIVE, "outer edge of the discs, r2"),
    Field::required(
        "angle",
        FieldKind::Quantity { unit: "rad", bounds: Bounds { min: 0.0, max: 1.57, min_open: true } },
        "angle between disc and spin axis, th",
    ),
    Field::required("gaps", FieldKind::Integer { min: 1, max: 100_000 }, "number of gaps, N"),
    Field::optional("spacing", POSITIVE, "0.5 mm", "width of a gap across the discs; it sets the residence time, not the throughput"),
];
const DECANTER: &[Field] = &[
    Field::required("cylinder_length", POSITIVE, "length of the cylinder, L1"),
    Field::required("cone_length", length(Bounds::up_to(100.0)), "wetted length of the cone, L2"),
    Field::required("bowl_radius", POSITIVE, "inner radius of the bowl, r2"),
    Field::required("surface_radius", POSITIVE, "radius of the liquid's surface, r1"),
    Field::optional(
        "cone",
        FieldKind::Choice(&[
            ("textbook", "C = (r2^2 + 3 r1 r2 + 4 r1^2)/8"),
            ("slices", "C = (r2^2 + r1 r2 + 2 r1^2)/4: tubular slices averaged over the cone"),
        ]),
        "textbook",
        "how the cone counts in Sigma",
    ),
];

/// Kinds of `[[cup]]`.
pub fn cup_kinds() -> Vec<KindInfo> {
    let k = |kind, doc, fields: &[Field]| KindInfo { kind, doc, fields: fields.to_vec() };
    vec![
        k(
            "swinging",
            "Cups that hang on hinges and swing out as the rotor turns: their tilt follows from the speed, and what they weigh loads the rotor at the radius they reach.",
            SWINGING,
        ),
        k("fixed_angle", "Tubes held at an angle; the surface of their liquid follows the field.", FIXED_ANGLE),
        k("tubular_bowl", "A bowl that liquid flows through along the axis.", TUBULAR),
        k("disc_stack", "A stack of conical discs that liquid flows through from the outside in.", DISCS),
        k("decanter", "A bowl with a cone and a screw; it separates like a tubular bowl of the same Sigma.", DECANTER),
    ]
}

/// What `[suspension]` is.
pub const SUSPENSION_DOC: &str = "What is separated: the liquid, and the size and density of the particles in it.";

const VISCOSITY: FieldKind = FieldKind::Quantity { unit: "Pa s", bounds: Bounds::positive(1e7) };
const SIZE: FieldKind = FieldKind::Quantity { unit: "m", bounds: Bounds { min: 0.0, max: 1.0, min_open: true } };
const DENSITY: FieldKind = FieldKind::Quantity { unit: "kg/m^3", bounds: Bounds::positive(1e5) };
const TEMPERATURE: FieldKind = FieldKind::Quantity { unit: "K", bounds: Bounds::closed(50.0, 3000.0) };

/// Fields of `[suspension]`.
pub const SUSPENSION: &[Field] = &[
    Field::required("liquid_density", DENSITY, "density of the liquid, rho_f"),
    Field::optional("viscosity", VISCOSITY, "", "dynamic viscosity of the liquid, mu; this or viscosity_table"),
    Field::optional(
        "viscosity_table",
        FieldKind::Columns(&[("temperature", "K", true, "temperatures, increasing"), ("viscosity", "Pa s", true, "viscosity at each")]),
        "",
        "viscosity over temperature; ln mu is joined smoothly",
    ),
    Field::optional("temperature", TEMPERATURE, "", "temperature of the liquid; needed with viscosity_table"),
    Field::required("particle_density", DENSITY, "density of the particles, rho_p; the median where they differ"),
    Field::optional(
        "density_deviation",
        FieldKind::Quantity { unit: "", bounds: Bounds { min: 1.0, max: 10.0, min_open: true } },
        "",
        "geometric standard deviation of the densities (log-normal)",
    ),
    Field::optional(
        "densities",
        FieldKind::Columns(&[("density", "kg/m^3", true, "densities, increasing"), ("share", "", true, "share of each class")]),
        "",
        "classes of density, instead of one",
    ),
    Field::optional("diameter", SIZE, "", "diameter of the particles, when all are equal"),
    Field::optional("median_diameter", SIZE, "", "median diameter of a log-normal powder, by mass"),
    Field::optional(
        "geometric_deviation",
        FieldKind::Quantity { unit: "", bounds: Bounds { min: 1.0, max: 100.0, min_open: true } },
        "",
        "geometric standard deviation of that powder",
    ),
    Field::optional("characteristic_diameter", SIZE, "", "diameter with 63.2 % below, of a powder after Rosin and Rammler"),
    Field::optional("spread", FieldKind::Quantity { unit: "", bounds: Bounds::positive(100.0) }, "", "exponent of that powder, n"),
    Field::optional(
        "sizes",
        FieldKind::Columns(&[
            ("diameter", "m", true, "diameters, increasing"),
            ("undersize", "", false, "share below each, up to 1"),
            ("share", "", false, "share of each class, instead of undersize"),
        ]),
        "",
        "a measured powder",
    ),
    Field::optional(
        "drag",
        FieldKind::Choice(&[
            ("stokes", "proportional to the velocity: Re below 1"),
            ("schiller_naumann", "up to turbulent flow around the particle"),
        ]),
        "stokes",
        "law of the drag",
    ),
    Field::optional(
        "added_mass",
        FieldKind::Quantity { unit: "", bounds: Bounds::up_to(10.0) },
        "0",
        "added-mass coefficient Ca; 0.5 for spheres that are not much denser than the liquid",
    ),
    Field::optional("lift", FieldKind::Quantity { unit: "", bounds: Bounds::within(10.0) }, "0", "lift coefficient CL"),
    Field::optional(
        "volume_fraction",
        FieldKind::Quantity { unit: "", bounds: Bounds { min: 0.0, max: 0.6, min_open: false } },
        "0",
        "volume fraction of the particles, phi",
    ),
    Field::optional(
        "hindered_exponent",
        FieldKind::Quantity { unit: "", bounds: Bounds::up_to(20.0) },
        "4.65",
        "exponent of Richardson and Zaki",
    ),
    Field::optional("drop_viscosity", VISCOSITY, "", "viscosity inside clean drops, whose surface moves and lowers the drag"),
    Field::optional(
        "shape_factor",
        FieldKind::Quantity { unit: "", bounds: Bounds::closed(0.1, 100.0) },
        "1",
        "drag over that of a sphere of the same volume",
    ),
];

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

fn wrong(out: &mut Diagnostics, values: &Values, field: &str, code: &'static str, message: String, help: &str) {
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
                    "the tube holds no liquid: its surface lies at the bottom or below".into(),
                    "measure surface and length from the mouth",
                );
            }
            if tube.mouth - tube.radius * tube.angle.cos() <= 0.0 {
                wrong(out, v, "mouth_radius", "cup.axis", "the tube reaches across the spin axis".into(), "increase mouth_radius");
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
                wrong(out, v, "inner_radius", "cup.radii", "inner_radius must be smaller than outer_radius".into(), "exchange them");
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
                    "the liquid's surface must lie inside the bowl: surface_radius below bowl_radius".into(),
                    "the surface is the inner face of the liquid",
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
            "how far the cup swings out depends on its centre of mass, which is missing".into(),
            "add centre_of_mass = \"60 mm\" (from the hinge, with contents), or hold the cup at a tilt",
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
        wrong(out, v, "moment_along", "cup.mass", "a moment of inertia needs the mass it belongs to".into(), "add mass");
    }
    if body.moment_along * body.moment_across < body.product * body.product || body.moment_along < mass * along * along * (1.0 - 1e-9) {
        wrong(
            out,
            v,
            "moment_along",
            "cup.moments",
            "no body has these second moments about the hinge".into(),
            "moment_along is at least mass times centre_of_mass squared; moment_product squared is at most moment_along times moment_across",
        );
    }
    let vessel = Cylinder { radius: n("cup_radius"), bottom: n("bottom"), top: n("surface") };
    if !(vessel.top < vessel.bottom) {
        wrong(
            out,
            v,
            "surface",
            "cup.empty",
            "the cup holds no liquid: its surface lies at the bottom or below".into(),
            "measure surface and bottom from the hinge, outwards",
        );
    }
    let hinge = n("hinge_radius");
    if hinge + vessel.top.min(0.0) < 0.0 {
        wrong(
            out,
            v,
            "surface",
            "cup.axis",
            "the surface of the liquid reaches across the spin axis when the cup has swung out".into(),
            "increase hinge_radius",
        );
    }
    let hanging = SwingingCup { hinge, body, damping: n("hinge_damping"), gravity: GRAVITY };
    Some(Separator::Cup(Cup { hanging, vessel, held }))
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
            Some(b) => format!("did you mean \"{b}\"? Bodies of this machine: {all}"),
            None => format!("bodies of this machine: {all}"),
        };
        wrong(out, v, "on", "body.missing", format!("\"{name}\", which carries it, does not exist"), &help);
        return None;
    }
    if system.param(&format!("{name}.mass")).is_none() {
        wrong(out, v, "on", "cup.body", format!("\"{name}\" has no mass of its own that cups could add to"), "attach the cups to a disc");
        return None;
    }
    let (Some(mass), Some(centre)) = (v.number("mass"), v.number("centre_of_mass")) else {
        wrong(
            out,
            v,
            "on",
            "cup.mass",
            "what loads a body needs mass and centre_of_mass".into(),
            "add both, with contents; or leave on out",
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
                format!("{} values are given for {count} cups", given.len()),
                "give one for each, 0 for those that fit",
            );
        }
        given
    };
    let (masses, centres) = (list("mass_differences"), list("centre_differences"));
    if masses.iter().any(|d| mass + d < 0.0) {
        wrong(out, v, "mass_differences", "cup.negative", "a cup would weigh less than nothing".into(), "a missing cup is minus its mass");
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
                    "a viscosity in the table is not positive".into(),
                    "check the column and its unit",
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
                            format!("the viscosity table goes from {low} K to {high} K; at {t} K it says nothing"),
                            "extend the table: viscosity is not extrapolated",
                        );
                        return None;
                    }
                    Some(curve.value(t).exp())
                }
                Err(e) => {
                    wrong(out, v, "viscosity_table", "suspension.viscosity", e.to_string(), "give temperatures in increasing order");
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
                "a viscosity table needs the temperature at which the liquid is separated".into(),
                "add temperature = \"60 degC\"",
            );
            None
        }
        (Some(_), Some(_), _) => {
            wrong(out, v, "viscosity", "suspension.viscosity", "both viscosity and viscosity_table are given".into(), "keep one of them");
            None
        }
        (None, None, _) => {
            wrong(
                out,
                v,
                "viscosity",
                "suspension.viscosity",
                "the viscosity of the liquid is missing".into(),
                "add viscosity = \"1 mPa s\", or a viscosity_table and a temperature",
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
            "the size of the particles is missing".to_string()
        } else {
            format!("the sizes are given in several ways: {}", given.join(", "))
        };
        wrong(
            out,
            v,
            given.first().copied().unwrap_or(""),
            "suspension.size",
            message,
            "say one of diameter; median_diameter with geometric_deviation; characteristic_diameter with spread; sizes",
        );
        return None;
    };
    let mut need = |field: &str| {
        let x = v.number(field);
        if x.is_none() {
            wrong(out, v, way, "suspension.size", format!("{way} needs {field} beside it"), &format!("add {field}"));
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
                _ => Err(Impossible("a powder needs either undersize or share for its diameters".into())),
            };
            law.map_err(|Impossible(why)| wrong(out, v, "sizes", "suspension.size", why, "sizes = { diameter = [..], undersize = [..] }"))
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
                "the densities are given in two ways".into(),
                "keep densities or density_deviation",
            );
            None
        }
        (Some(table), None) => {
            let law = Law::classes(table.get("density")?, table.get("share")?);
            law.map_err(|Impossible(why)| {
                wrong(out, v, "densities", "suspension.density", why, "densities = { density = [..], share = [..] }")
            })
            .ok()
        }
        (None, Some(gsd)) => Some(Law::LogNormal { median, gsd }),
        (None, None) => Some(Law::Single(median)),
    }
}

/// The cup a study asks for by name, or the only one.
pub fn the_vessel(values: &Values, system: &System, out: &mut Diagnostics) -> Option<Vessel> {
    let cups: Vec<&Extra> = system.machine.extras.iter().filter(|e| e.word == "cup").collect();
    let names = cups.iter().map(|c| format!("\"{}\"", c.name)).collect::<Vec<_>>().join(", ");
    let found = match values.text("cup") {
        Some(name) => cups
            .iter()
            .find(|c| c.name == name)
            .ok_or_else(|| (format!("there is no cup named \"{name}\""), format!("cups of this machine: {names}"))),
        None if cups.len() > 1 => Err(("this machine has several cups".to_string(), format!("add cup = .. with one of {names}"))),
        None => cups.first().ok_or_else(|| {
            (
                "this machine has nothing that separates".to_string(),
                "add a block [[cup]] with kind = \"swinging\", \"fixed_angle\", \"tubular_bowl\", \"disc_stack\" or \"decanter\""
                    .to_string(),
            )
        }),
    };
    match found {
        Ok(extra) => vessel(extra, system, &mut Diagnostics::default()),
        Err((message, help)) => {
            wrong(out, values, "cup", "separation.cup", message, &help);
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
                "this machine has nothing to separate".into(),
                "add a block [suspension] with liquid_density, viscosity, particle_density and diameter",
            );
            None
        }
    }
}

/// Field: which cup.
pub const CUP: Field = Field::optional("cup", FieldKind::Text, "", "name of the [[cup]]; the only one when left out");
