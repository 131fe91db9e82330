//! The block `[limits]` of a machine file: what the machine must keep to.

use crate::diagnostic::{Diagnostic, Diagnostics, meant, nearest};
use crate::model::field::{Bounds, Extra, Field, FieldKind, Values};
use crate::model::part::At;
use crate::model::probe::Probe;
use crate::model::system::{Station, System, Workspace};
use crate::study::linear::campbell::spin_orders;
use crate::text;
use crate::units::read_quantity;

/// What `[limits]` is.
pub const EXAMPLE: &str = r#"displacement = { drum = "0.3 mm" }
passage_displacement = "2 mm"
growth_margin = "1 1/s"
clearance = "12 %"
speed = "6000 rpm"
"#;
/// What the block is.
pub const DOC: &str = "What the machine must keep to: each limit that is given becomes a requirement of an operating_window. Limits on bodies and parts are one \
    value for all, or one for each of some names.";

const fn named(unit: &'static str) -> FieldKind {
    FieldKind::Named { unit, bounds: Bounds::positive(1e12) }
}

/// Fields of `[limits]`.
pub const FIELDS: &[Field] = &[
    Field::optional(
        "displacement",
        named("m"),
        "",
        "largest steady displacement of bodies, the foundation among them, at the reference point, wherever something is attached and, of a linear response, at the nodes of a shaft; of one point alone as { \"drum at 100 mm\" = \"0.2 mm\" }",
    ),
    Field::optional(
        "velocity",
        named("m/s"),
        "",
        "largest steady vibration velocity of bodies, at the same points: its peak, which is sqrt(2) times the r.m.s. value of a harmonic vibration",
    ),
    Field::optional("tilt", named("rad"), "", "largest steady tilt of bodies"),
    Field::optional("force", named("N"), "", "largest steady force of parts, such as bearings"),
    Field::optional("moment", named("N m"), "", "largest steady moment of parts, such as shafts"),
    Field::optional("passage_displacement", named("m"), "", "largest displacement of bodies, at the same points, while the speed changes"),
    Field::optional(
        "drive_torque",
        FieldKind::Quantity { unit: "N m", bounds: Bounds::positive(1e9) },
        "",
        "torque of the drive, at hand while the speed changes",
    ),
    Field::optional(
        "growth_margin",
        FieldKind::Quantity { unit: "1/s", bounds: Bounds::up_to(1e6) },
        "0 1/s",
        "least rate at which every disturbance must die out, sig0",
    ),
    Field::optional(
        "clearance",
        FieldKind::Quantity { unit: "", bounds: Bounds::closed(0.0, 1.0) },
        "",
        "least distance of every natural whirl frequency from the excitation, over the speed, dlt",
    ),
    Field::optional(
        "orders",
        FieldKind::List { unit: "", bounds: Bounds::positive(1000.0) },
        "[1]",
        "multiples of the spin speed that excite, for clearance",
    ),
    Field::optional(
        "self_centring",
        FieldKind::Quantity { unit: "", bounds: Bounds::positive(1e3) },
        "",
        "largest distance of a rotor's centre of mass from the spin axis over its eccentricity, c0: 0.5 is usual above the critical speed",
    ),
    Field::optional(
        "speed",
        FieldKind::Quantity { unit: "rad/s", bounds: Bounds::positive(1e6) },
        "",
        "highest speed of any shaft, for strength",
    ),
    Field::optional(
        "rated_density",
        FieldKind::Quantity { unit: "kg/m^3", bounds: Bounds::positive(1e5) },
        "",
        "density of the contents that speed is rated for; denser contents lower it",
    ),
];

/// A limit on one body, on one point of a body, or on one part.
#[derive(Clone, Debug, PartialEq)]
pub struct Limit {
    /// What it is on, as the file says it.
    pub name: String,
    /// The body or part.
    pub body: String,
    /// The point of the body alone: its height above the reference point, m.
    pub at: Option<f64>,
    /// The limit, SI.
    pub value: f64,
}

impl Limit {
    /// It is on the point that this probe measures.
    pub fn is_at(&self, probe: &Probe) -> bool {
        probe.name == self.body && self.at.is_some_and(|z| probe.is_at(z))
    }
}

/// Limits that may be on a point of a body.
const ON_POINTS: [&str; 3] = ["displacement", "velocity", "passage_displacement"];

/// A point of a body as "drum at 100 mm".
fn point(name: &str) -> Option<(&str, f64)> {
    let (body, at) = name.rsplit_once(" at ")?;
    Some((body, read_quantity(at, "m").ok().filter(|z| z.abs() <= FARTHEST)?))
}

/// Height of a point, m, at most.
const FARTHEST: f64 = 100.0;

/// Share of the length of a body by which a point may lie beyond its end: rounding.
const SAME: f64 = 1e-9;

/// First and last position on a body that bends.
fn extent(system: &System, body: &str) -> Option<(f64, f64)> {
    let nodes = system.slots().iter().find(|s| s.name == body)?.part.body()?.nodes()?;
    Some(nodes.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), z| (a.min(*z), b.max(*z))))
}

/// Names of the bodies that have such stations.
fn names(system: &System, such: impl Fn(&Station) -> bool) -> Vec<String> {
    let mut out: Vec<String> = system.stations().iter().filter(|s| such(s)).map(|s| system.slots()[s.slot].name.clone()).collect();
    out.dedup();
    out
}

/// Names of the parts with loads of this unit: all that join bodies, and bodies that show one.
fn loaded(system: &System, unit: &str) -> Vec<String> {
    let (zero, still) = (vec![0.0; system.n()], vec![0.0; system.m()]);
    let speed = system.machine.speed.unwrap_or(0.0);
    let at = At { q: &zero, v: &zero, a: &zero, z: &still, phase: 0.0, speed, spin_accel: 0.0, t: 0.0 };
    let mut scratch = Workspace::default();
    let mut shows = |k: usize| system.observe_part(k, &at, &mut scratch).iter().any(|o| o.unit == unit);
    let slots = system.slots().iter().enumerate();
    slots.filter(|(k, s)| s.part.body().is_none() || shows(*k)).map(|(_, s)| s.name.clone()).collect()
}

/// The points of bodies that limits name.
pub fn points(extra: &Extra, system: &System) -> Vec<(String, f64)> {
    let bodies = names(system, |_| true);
    let is_body = |n: &str| bodies.iter().any(|b| b == n);
    let named = ON_POINTS.into_iter().flat_map(|field| extra.values.named(field)).filter_map(|(name, _)| name);
    let found = named.filter(|n| !is_body(n)).filter_map(point).filter(|p| is_body(p.0));
    found.map(|(body, at)| (body.to_string(), at)).collect()
}

/// The limits.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Limits {
    /// Displacements of bodies, m.
    pub displacement: Vec<Limit>,
    /// Velocities of bodies, m/s.
    pub velocity: Vec<Limit>,
    /// Tilts of bodies, rad.
    pub tilt: Vec<Limit>,
    /// Forces of parts, N.
    pub force: Vec<Limit>,
    /// Moments of parts, N m.
    pub moment: Vec<Limit>,
    /// Displacements of bodies in passage, m.
    pub passage: Vec<Limit>,
    /// Torque of the drive, N m.
    pub torque: Option<f64>,
    /// sig0, 1/s.
    pub growth: f64,
    /// dlt.
    pub clearance: Option<f64>,
    /// Excitation orders.
    pub orders: Vec<f64>,
    /// c0.
    pub self_centring: Option<f64>,
    /// Highest speed, rad/s.
    pub speed: Option<f64>,
    /// Density it is rated for, kg/m^3.
    pub rated_density: Option<f64>,
}

impl Limits {
    /// There is a limit on the steady vibration.
    pub fn vibration(&self) -> bool {
        [&self.displacement, &self.velocity, &self.tilt, &self.force, &self.moment].iter().any(|l| !l.is_empty())
    }
}

/// What a limit is on.
#[derive(Clone, Copy)]
enum Limited {
    Body,
    Tilting,
    Force,
    Moment,
}

/// Says what is wrong with the limits.
pub fn check(extra: &Extra, system: &System, out: &mut Diagnostics) {
    read(&extra.values, system, out);
}

/// Reads the limits; says all that is wrong.
pub fn read(v: &Values, system: &System, out: &mut Diagnostics) -> Limits {
    let bodies = names(system, |_| true);
    let mut list = |field: &str, known: &[String], of: Limited| -> Vec<Limit> {
        let mut found = Vec::new();
        let limit = |name: &str, body: &str, at: Option<f64>, value| Limit { name: name.into(), body: body.into(), at, value };
        for (name, value) in v.named(field) {
            let point = name.and_then(point).filter(|(n, _)| ON_POINTS.contains(&field) && known.iter().any(|k| k == n));
            match (name, point) {
                (None, _) => found.extend(known.iter().map(|n| limit(n, n, None, value))),
                (Some(n), _) if known.iter().any(|k| k == n) => found.push(limit(n, n, None, value)),
                (Some(n), Some((body, at))) => {
                    let off = |(from, to): &(f64, f64)| !(*from - SAME * (to - from) <= at && at <= *to + SAME * (to - from));
                    if let Some((from, to)) = extent(system, body).filter(off) {
                        let place = |x: f64| text::quantity(x, "m");
                        let message = text!("{field} names \"{n}\", a point that \"{body}\" does not have", field, n, body);
                        let help = text!("it reaches from {from} to {to}", from = place(from), to = place(to));
                        out.push(Diagnostic::error("limits.place", message).at(v.span_of(field)).about(n).help(help));
                    }
                    found.push(limit(n, body, Some(at), value));
                }
                (Some(n), None) => {
                    let all = known.join(", ");
                    let there = match ON_POINTS.contains(&field) {
                        true => text!("there are {all}; a point of a body is written as \"drum at 100 mm\"", all),
                        false => text!("there are {all}", all),
                    };
                    let help = match nearest(n, known.iter().map(String::as_str)) {
                        Some(near) => meant(text::quoted(&near), there),
                        None => there,
                    };
                    let message = match of {
                        Limited::Body => text!("{field} names \"{n}\", which is no body of this machine", field, n),
                        Limited::Tilting => text!("{field} names \"{n}\", which is no body that tilts of this machine", field, n),
                        Limited::Force => text!("{field} names \"{n}\", which is no part with a force", field, n),
                        Limited::Moment => text!("{field} names \"{n}\", which is no part with a moment", field, n),
                    };
                    out.push(Diagnostic::error("limits.name", message).at(v.span_of(field)).about(n).help(help));
                }
            }
        }
        found
    };
    let (displacement, velocity) = (list("displacement", &bodies, Limited::Body), list("velocity", &bodies, Limited::Body));
    let tilting = names(system, |s| s.tilt.is_some());
    let [forces, moments] = ["N", "N m"].map(|unit| loaded(system, unit));
    let (tilt, moment) = (list("tilt", &tilting, Limited::Tilting), list("moment", &moments, Limited::Moment));
    let (force, passage) = (list("force", &forces, Limited::Force), list("passage_displacement", &bodies, Limited::Body));
    if v.number("rated_density").is_some() && v.number("speed").is_none() {
        let message = text!("rated_density belongs to a highest speed, which is missing");
        out.push(Diagnostic::error("limits.speed", message).at(v.span_of("rated_density")).help(text!("add speed")));
    }
    Limits {
        displacement,
        velocity,
        tilt,
        force,
        moment,
        passage,
        torque: v.number("drive_torque"),
        growth: v.number("growth_margin").unwrap_or(0.0),
        clearance: v.number("clearance"),
        orders: v.list("orders").filter(|_| v.written("orders")).map_or_else(|| spin_orders(system), <[f64]>::to_vec),
        self_centring: v.number("self_centring"),
        speed: v.number("speed"),
        rated_density: v.number("rated_density"),
    }
}

/// The limits of the machine; none when the file has no such block.
pub fn of(system: &System) -> Limits {
    match system.machine.extras.iter().find(|e| e.word == "limits") {
        Some(e) => read(&e.values, system, &mut Diagnostics::default()),
        None => Limits { orders: spin_orders(system), ..Limits::default() },
    }
}
