//! What a saved model of ROSS says, element by element.

use super::notes::{Note, Notes};
use crate::diagnostic::{Diagnostic, Diagnostics, Span};
use crate::file::tree::{Data, Entry, Node, get};
use crate::text;
use crate::text::Text;
use std::cell::RefCell;

/// Largest number of a node; more nodes than any rotor has would only take memory.
const MOST_NODES: i64 = 10_000;
/// What is smaller beside the largest coefficient is rounding.
const ROUNDING: f64 = 1e-12;

/// What an element becomes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Shaft,
    Disc,
    Mass,
    /// Coefficients that were given.
    Bearing,
    Seal,
    /// Coefficients that ROSS has computed from a geometry.
    Computed,
}

impl Kind {
    /// Classes of ROSS.
    pub const ALL: [(&'static str, Kind); 26] = [
        ("ShaftElement", Kind::Shaft),
        ("DiskElement", Kind::Disc),
        ("GearElement", Kind::Disc),
        ("GearElementTVMS", Kind::Disc),
        ("PointMass", Kind::Mass),
        ("BearingElement", Kind::Bearing),
        ("SealElement", Kind::Seal),
        ("HolePatternSeal", Kind::Seal),
        ("LabyrinthSeal", Kind::Seal),
        ("HybridSeal", Kind::Seal),
        ("BallBearingElement", Kind::Computed),
        ("RollerBearingElement", Kind::Computed),
        ("MagneticBearingElement", Kind::Computed),
        ("CylindricalBearing", Kind::Computed),
        ("BearingFluidFlow", Kind::Computed),
        ("FluidFilmBearing", Kind::Computed),
        ("FixedGeometryBearing", Kind::Computed),
        ("PartialArcBearing", Kind::Computed),
        ("EllipticalBearing", Kind::Computed),
        ("OffsetHalvesBearing", Kind::Computed),
        ("MultiLobeBearing", Kind::Computed),
        ("PressureDamBearing", Kind::Computed),
        ("PlainJournal", Kind::Computed),
        ("SqueezeFilmDamper", Kind::Computed),
        ("ThrustPad", Kind::Computed),
        ("TiltingPad", Kind::Computed),
    ];
    pub fn of(class: &str) -> Option<Kind> {
        Kind::ALL.iter().find(|k| k.0 == class).map(|k| k.1)
    }
}

/// An element of the shaft.
#[derive(Clone, Debug)]
pub(super) struct Shaft {
    pub name: String,
    pub span: Option<Span>,
    pub node: usize,
    pub length: f64,
    /// Outer and inner diameter at the left end, then at the right end.
    pub outer: [f64; 2],
    pub inner: [f64; 2],
    pub material: Material,
    /// "cowper", "hutchinson" or "none".
    pub shear: &'static str,
    pub axial_force: f64,
    pub torque: f64,
    pub damping: Rayleigh,
    /// Rotary inertia and gyroscopic coupling are both on.
    pub turns: bool,
}

#[derive(Clone, Debug, PartialEq)]
pub(super) struct Material {
    pub name: String,
    pub modulus: f64,
    pub shear_modulus: f64,
    pub density: f64,
}

/// Damping `alpha M + beta K`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Rayleigh {
    pub alpha: f64,
    pub beta: f64,
}

/// A disc, or a point mass.
#[derive(Clone, Debug)]
pub(super) struct Mass {
    pub name: String,
    pub tag: String,
    pub span: Option<Span>,
    pub node: usize,
    pub mass: f64,
    /// Diametral and polar.
    pub inertia: [f64; 2],
}

/// A bearing or seal.
#[derive(Clone, Debug)]
pub(super) struct Bearing {
    pub name: String,
    pub tag: String,
    pub span: Option<Span>,
    pub kind: Kind,
    pub node: usize,
    pub link: Option<usize>,
    /// Speeds of the rows; one row without a speed where the coefficients are constant.
    pub speeds: Vec<f64>,
    /// kxx, kxy, kyx, kyy, cxx, cxy, cyx, cyy over the rows.
    pub coefficients: [Vec<f64>; 8],
}

pub(super) const COEFFICIENTS: [&str; 8] = ["kxx", "kxy", "kyx", "kyy", "cxx", "cxy", "cyx", "cyy"];
/// Of a bearing, without a place here.
const LEFT_OUT: [&str; 8] = ["kzz", "czz", "mxx", "mxy", "myx", "myy", "mzz", "radial_clearance"];

/// Keys of elements that say how ROSS draws them, that follow from others, or that a remark on the whole model covers.
const IGNORED: [&str; 9] = ["color", "scale_factor", "n_l", "n_r", "tag", "odr", "idr", "shear_method_calc", "interpolation"];

/// A saved model.
#[derive(Clone, Debug, Default)]
pub(super) struct Model {
    pub version: String,
    pub rated: Option<f64>,
    /// Of the whole rotor without its bearings.
    pub damping: Rayleigh,
    pub shafts: Vec<Shaft>,
    pub discs: Vec<Mass>,
    pub masses: Vec<Mass>,
    pub bearings: Vec<Bearing>,
    pub notes: Notes,
}

/// A table that is read, and where its mistakes go.
pub(super) struct Read<'r, 'n> {
    pub name: &'r str,
    pub table: &'r [Entry<'n>],
    pub span: Option<Span>,
    pub out: &'r mut Diagnostics,
    /// Keys that were looked up.
    seen: RefCell<Vec<String>>,
}

impl<'r, 'n> Read<'r, 'n> {
    pub fn new(name: &'r str, table: &'r [Entry<'n>], span: Option<Span>, out: &'r mut Diagnostics) -> Self {
        Read { name, table, span, out, seen: RefCell::default() }
    }
    /// Keys that mean something to nothing here.
    fn unread(&self) -> Vec<String> {
        let seen = self.seen.borrow();
        let known = |key: &str| seen.iter().any(|s| s == key) || IGNORED.contains(&key);
        let given = self.table.iter().filter(|e| !matches!(e.node.data, Data::Other(_)));
        given.map(|e| e.key.to_string()).filter(|k| !known(k)).collect()
    }
    /// The value of a key; null of JSON is none.
    fn get(&self, key: &str) -> Option<&'r Node<'n>> {
        self.seen.borrow_mut().push(key.to_string());
        get(self.table, key).map(|e| &e.node).filter(|n| !matches!(n.data, Data::Other(_)))
    }
    fn missing(&mut self, key: &str) {
        let message = text!("{element} has no {key}", element = text::quoted(self.name), key);
        self.out.push(Diagnostic::error("ross.key", message).at(self.span.clone()));
    }
    fn wrong(&mut self, key: &str, node: &Node, wanted: Text) {
        let message =
            text!("{key} of {element} must be {wanted}, not {shape}", key, element = text::quoted(self.name), wanted, shape = node.shape());
        self.out.push(Diagnostic::error("ross.value", message).at(node.span.clone().or_else(|| self.span.clone())));
    }
    fn number_or(&mut self, key: &str, default: f64) -> f64 {
        let Some(node) = self.get(key) else { return default };
        number(node).unwrap_or_else(|| {
            self.wrong(key, node, text!("a finite number"));
            default
        })
    }
    fn number(&mut self, key: &str) -> f64 {
        if self.get(key).is_none() {
            self.missing(key);
        }
        self.number_or(key, 0.0)
    }
    fn node(&mut self, key: &str) -> Option<usize> {
        let node = self.get(key)?;
        let n = number(node).filter(|n| n.fract() == 0.0 && (0.0..=MOST_NODES as f64).contains(n));
        if n.is_none() {
            self.wrong(key, node, text!("the number of a node, from 0 to {most}", most = MOST_NODES));
        }
        n.map(|n| n as usize)
    }
    fn own_node(&mut self) -> usize {
        if self.get("n").is_none() {
            self.missing("n");
        }
        self.node("n").unwrap_or_default()
    }
    fn flag(&mut self, key: &str) -> bool {
        match self.get(key) {
            None => true,
            Some(Node { data: Data::Flag(b), .. }) => *b,
            Some(node) => {
                self.wrong(key, node, text!("true or false"));
                true
            }
        }
    }
    fn tag(&self) -> String {
        let own = self.name.split_once('_').map_or(self.name, |n| n.1);
        self.get("tag").and_then(Node::text).unwrap_or(own).to_string()
    }
    fn rayleigh(&mut self) -> Rayleigh {
        Rayleigh { alpha: self.number_or("alpha", 0.0), beta: self.number_or("beta", 0.0) }
    }
    /// A number, a list of numbers or a list of such lists, row by row.
    fn rows(&mut self, key: &str) -> Vec<Vec<f64>> {
        let Some(node) = self.get(key) else { return Vec::new() };
        let one = |n: &Node| match &n.data {
            Data::List(inner) => inner.iter().map(number).collect(),
            _ => number(n).map(|x| vec![x]),
        };
        let rows = match &node.data {
            Data::List(list) => list.iter().map(one).collect(),
            _ => number(node).map(|x| vec![vec![x]]),
        };
        rows.unwrap_or_else(|| {
            self.wrong(key, node, text!("a list of finite numbers"));
            Vec::new()
        })
    }
    fn axis(&mut self, key: &str) -> Vec<f64> {
        self.rows(key).into_iter().flatten().collect()
    }
    /// The keys among these whose value is neither absent, 0 nor an empty list.
    fn used(&self, keys: &[&'static str]) -> Vec<&'static str> {
        let nonzero = |n: &Node| -> bool { number(n).is_none_or(|x| x != 0.0) };
        let any = |n: &Node| match &n.data {
            Data::List(list) => list.iter().any(|n| match &n.data {
                Data::List(inner) => inner.iter().any(nonzero),
                _ => nonzero(n),
            }),
            _ => nonzero(n),
        };
        keys.iter().copied().filter(|k| self.get(k).is_some_and(any)).collect()
    }
}

fn number(node: &Node) -> Option<f64> {
    match node.data {
        Data::Integer(i) => Some(i as f64),
        Data::Float(x) => Some(x).filter(|x| x.is_finite()),
        _ => None,
    }
}

impl Model {
    /// `[parameters]`.
    pub fn settings(&mut self, r: &mut Read) {
        self.rated = Some(r.number_or("rated_w", 0.0)).filter(|w| *w > 0.0);
        if self.rated.is_none() {
            self.left_out(r, &["rated_w"]);
        }
        self.damping = r.rayleigh();
        self.left_out(r, &["modal_damping_ratio", "default_damping_ratio"]);
    }

    fn left_out(&mut self, r: &Read, keys: &[&'static str]) {
        let keys = r.used(keys);
        if !keys.is_empty() {
            self.notes.add(Note::LeftOut(keys), r.name);
        }
    }

    /// Any other table.
    pub fn element(&mut self, kind: Kind, class: &str, r: &mut Read) {
        match kind {
            Kind::Shaft => self.shaft(r),
            Kind::Disc => {
                let (name, tag, span) = (r.name.to_string(), r.tag(), r.span.clone());
                let (node, mass, inertia) = (r.own_node(), r.number("m"), [r.number("Id"), r.number("Ip")]);
                self.discs.push(Mass { name, tag, span, node, mass, inertia });
                if class != "DiskElement" {
                    self.notes.add(Note::NoTeeth, r.name);
                }
            }
            Kind::Mass => {
                let (name, tag, span) = (r.name.to_string(), r.tag(), r.span.clone());
                let all = if r.get("mx").is_none() { r.number("m") } else { 0.0 };
                // of motion across the axis alone
                let _ = [r.get("m"), r.get("mz")];
                let (node, mx, my) = (r.own_node(), r.number_or("mx", all), r.number_or("my", all));
                if mx != my {
                    self.notes.add(Note::MeanMass, r.name);
                }
                self.masses.push(Mass { name, tag, span, node, mass: 0.5 * (mx + my), inertia: [0.0; 2] });
            }
            Kind::Bearing | Kind::Seal | Kind::Computed => self.bearing(kind, r),
        }
        // the geometry of what ROSS computes coefficients from has a remark of its own, and so have teeth
        if matches!(class, "ShaftElement" | "DiskElement" | "PointMass" | "BearingElement") {
            let keys = r.unread();
            if !keys.is_empty() {
                self.notes.add(Note::NotRead(keys), r.name);
            }
        }
    }

    fn shaft(&mut self, r: &mut Read) {
        let material = match r.get("material").map(|n| (n.table(), n)) {
            Some((Some(table), _)) => {
                let mut m = Read::new(r.name, table, r.span.clone(), r.out);
                Material {
                    name: m.get("name").and_then(Node::text).unwrap_or_default().to_string(),
                    modulus: m.number("E"),
                    shear_modulus: m.number("G_s"),
                    density: m.number("rho"),
                }
            }
            other => {
                match other {
                    Some((_, node)) => r.wrong("material", node, text!("a table")),
                    None => r.missing("material"),
                }
                Material { name: String::new(), modulus: 0.0, shear_modulus: 0.0, density: 0.0 }
            }
        };
        let (outer, inner) = (r.number("odl"), r.number("idl"));
        let shear = match r.get("shear_method_calc").and_then(Node::text) {
            _ if !r.flag("shear_effects") => "none",
            Some("hutchinson") => "hutchinson",
            _ => "cowper",
        };
        let element = Shaft {
            name: r.name.to_string(),
            span: r.span.clone(),
            node: r.own_node(),
            length: r.number("L"),
            outer: [outer, r.number_or("odr", outer)],
            inner: [inner, r.number_or("idr", inner)],
            material,
            shear,
            axial_force: r.number_or("axial_force", 0.0),
            torque: r.number_or("torque", 0.0),
            damping: r.rayleigh(),
            turns: r.flag("gyroscopic") & r.flag("rotary_inertia"),
        };
        if element.length <= 0.0 {
            let message = text!("the length of {element} must be positive", element = text::quoted(r.name));
            r.out.push(Diagnostic::error("ross.length", message).at(r.span.clone()));
        }
        self.shafts.push(element);
    }

    fn bearing(&mut self, kind: Kind, r: &mut Read) {
        let (name, tag, span) = (r.name.to_string(), r.tag(), r.span.clone());
        let (node, link) = (r.own_node(), r.node("n_link"));
        let (speed, frequency) = (r.axis("speed"), r.axis("frequency"));
        let both = speed.len() > 1 && frequency.len() > 1;
        let speeds = if speed.is_empty() || (speed.len() == 1 && frequency.len() > 1) { frequency.clone() } else { speed };
        let mut coefficients: [Vec<f64>; 8] = Default::default();
        for (key, column) in COEFFICIENTS.iter().zip(&mut coefficients) {
            if matches!(*key, "kxx" | "cxx") && r.get(key).is_none() {
                r.missing(key);
            }
            let rows = r.rows(key);
            let wanted = speeds.len().max(1);
            let n = rows.iter().map(Vec::len).sum::<usize>();
            let whole = rows.len() == wanted && rows.iter().all(|row| row.len() == if both { frequency.len() } else { 1 });
            *column = match n {
                // one value holds at every speed
                0 | 1 => vec![rows.concat().first().copied().unwrap_or(0.0); wanted],
                // a table over both: speed by speed, the value at the frequency of that speed
                _ if whole && both => rows.iter().zip(&speeds).map(|(row, w)| between(&frequency, row, *w)).collect(),
                _ if whole => rows.concat(),
                _ => {
                    let message =
                        text!("{element} has {n} values of {key} for {wanted} speeds", element = text::quoted(r.name), n, key, wanted);
                    r.out.push(Diagnostic::error("ross.table", message).at(r.span.clone()));
                    vec![0.0; wanted]
                }
            };
        }
        // coefficients in y default to those in x
        for (x, y) in [(0, 3), (4, 7)] {
            if r.get(COEFFICIENTS[y]).is_none() {
                coefficients[y] = coefficients[x].clone();
            }
        }
        // rounding of computed coefficients, as of cross terms of a magnetic bearing
        for group in coefficients.chunks_mut(4) {
            let most = group.iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
            for column in group.iter_mut().filter(|c| c.iter().all(|x| x.abs() < ROUNDING * most)) {
                column.fill(0.0);
            }
        }
        if both {
            self.notes.add(Note::Diagonal, &name);
        } else if frequency.len() > 1 {
            self.notes.add(Note::OverFrequency, &name);
        }
        match kind {
            Kind::Computed => self.notes.add(Note::Computed, &name),
            Kind::Seal => {
                self.notes.add(Note::Seal, &name);
                self.left_out(r, &["seal_leakage"]);
            }
            _ => {}
        }
        self.left_out(r, &LEFT_OUT);
        self.bearings.push(Bearing { name, tag, span, kind, node, link, speeds, coefficients });
    }
}

/// On a straight line between the points, and beyond them the first or last value.
fn between(x: &[f64], y: &[f64], at: f64) -> f64 {
    let k = x.partition_point(|v| *v <= at);
    if k == 0 || k == x.len() {
        return y[k.saturating_sub(1)];
    }
    y[k - 1] + (y[k] - y[k - 1]) * (at - x[k - 1]) / (x[k] - x[k - 1])
}
