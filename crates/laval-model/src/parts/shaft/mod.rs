//! An elastic shaft of finite elements: sections with their diameters, bending, shear, rotary inertia, gyroscopic coupling, axial force and torque.
//!
//! Equations, per element in one plane over `u = (w1, s1, w2, s2)` ([`element`]); the plane of x has `u = (x, beta)`, that of y has `u = S (y, alpha)`,
//! `S = diag(1, -1, 1, -1)`, so that beta = dx/dz and alpha = -dy/dz without shear:
//!
//! ```text
//! M q'' + (a M + b K + c K) q' + W G q' + (K + P Ka + T) q + (W c N + W'/2 G) q = 0,   N = -K R,   R: (x, y) -> (-y, x), (alpha, beta) -> (-beta, alpha)
//! G[X, Y] = Gp S, G[Y, X] = -S Gp
//! torque row:  Jp W' + q''' G q / 2 - c (R q)' K (q' - W R q)      (' of a vector: transposed)
//! along and about the axis, as far as it has these coordinates ([`line`]):  Ma u'' + (a Ma + (b + c) Ka) u' + Ka u = 0,
//!   Mt (theta'' + W') + (b + c) Kt theta' + Kt theta = 0,   torque row: + 1' Mt theta''
//! T: T int (d_alpha' beta - d_beta' alpha) dz, end torques of fixed direction
//! ```
//!
//! Symbols: M, K mass and elastic stiffness; P axial force, N, tension positive; T torque, N m; a, b damping in fixed axes, 1/s and s; c damping of the
//! material, in axes that turn with the rotor, s; u displacement along the axis, m; theta rotation about it relative to the spin, rad; Jp moment of inertia about the axis, kg m^2; W spin speed, rad/s.
//!
//! Validity: slopes up to 0.1 rad; sections round; cones as slender beams.
//!
//! Theory: `docs/theory/shafts.md`.
//!
//! Sources: H. D. Nelson, J. M. McVaugh, J. Eng. Ind. 98 (1976) 593; H. D. Nelson, J. Mech. Des. 102 (1980) 793; G. R. Cowper, J. Appl. Mech. 33 (1966) 335;
//! E. S. Zorzi, H. D. Nelson, J. Eng. Power 99 (1977) 71 (rotating damping).

pub mod element;
mod layer;
pub mod line;
mod mesh;
mod places;
mod prepared;
#[cfg(test)]
mod tests;

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::blocks::Blocks;
use crate::model::capability::{BodyPart, Extent};
use crate::model::erased;
use crate::model::field::{Bounds, Field, FieldKind, ParamValues, Values, Word};
use crate::model::params::{RowCounts, RowFamily, WithRows};
use crate::model::part::{At, Dof, Energy, ErasedPart, Layout, Params, Part, Physics, Validity};
use crate::params;
use crate::parts::speed_ratio::SPIN;
use crate::text;
use crate::text::Text;
use element::{Cone, Element, Layers, M4, Material, Shear};
use laval_num::scalar::Scalar;
use layer::{LAYER, LayerFamily};
pub use layer::{Layer, LayerParams};
use line::Line;
use mesh::Mesh;
use places::{Ends, SIGN, add_cross, add_line, add_planes, form, line_form, planes, slip};
use prepared::{Matrices, Prepared};
use std::f64::consts::PI;
use std::sync::Arc;

params! {
    /// Parameters of a [`Shaft`] beside its sections.
    pub struct ShaftParams in ShaftFamily {
        modulus: scalar, "Pa", Bounds::closed(1e5, 1e13), default 2.1e11, "Young's modulus E; left out it is that of the material";
        shear_modulus: scalar, "Pa", Bounds::closed(1e5, 1e13), default 8.08e10, "shear modulus G; left out it is that of the material";
        density: scalar, "kg/m^3", Bounds::closed(1e-3, 1e5), default 7850.0, "density rho; left out it is that of the material";
        axial_force: scalar, "N", Bounds::within(1e12), default 0.0, "axial force P along the whole shaft, tension positive";
        torque: scalar, "N m", Bounds::within(1e12), default 0.0, "torque T through the whole shaft: the upper part acts on the lower with +T about z";
        rotating_damping: scalar, "s", Bounds::up_to(1.0), default 0.0, "viscous damping c of the material over its stiffness, in axes that turn: it destabilises above the critical speed";
        mass_damping: scalar, "1/s", Bounds::up_to(1e6), default 0.0, "damping a over mass, in fixed axes";
        stiffness_damping: scalar, "s", Bounds::up_to(1.0), default 0.0, "damping b over stiffness, in fixed axes";
    }
}

params! {
    /// Parameters of a section of a [`Shaft`].
    pub struct SectionParams in SectionFamily {
        outer_diameter: scalar, "m", Bounds::closed(1e-6, 100.0), required, "outer diameter";
        inner_diameter: scalar, "m", Bounds::up_to(100.0), default 0.0, "inner diameter";
        end_outer_diameter: scalar, "m", Bounds::up_to(100.0), default 0.0, "outer diameter at the upper end of a conical section; 0 where it stays the same";
        end_inner_diameter: scalar, "m", Bounds::up_to(100.0), default 0.0, "inner diameter at the upper end; 0 where it stays the same";
    }
}

impl RowFamily for SectionFamily {
    const LIST: &'static str = "section";
}

const SECTION: &[(&str, &str, bool, &str)] = &[
    ("length", "m", true, "length of the section"),
    ("outer_diameter", "m", true, "outer diameter, of a conical section at its lower end"),
    ("inner_diameter", "m", false, "inner diameter of a hollow section, of a conical one at its lower end"),
    ("end_outer_diameter", "m", false, "outer diameter at the upper end of a conical section; 0 where it stays the same"),
    ("end_inner_diameter", "m", false, "inner diameter at the upper end; 0 where it stays the same"),
];

/// Materials: E, G (Pa), density (kg/m^3).
const MATERIALS: &[(Word, [f64; 3])] = &[
    (("steel", "E 210 GPa, G 80.8 GPa, 7850 kg/m^3"), [2.1e11, 8.08e10, 7850.0]),
    (("stainless_steel", "austenitic: E 193 GPa, G 75 GPa, 7950 kg/m^3"), [1.93e11, 7.5e10, 7950.0]),
    (("aluminium", "wrought alloys: E 70 GPa, G 26.3 GPa, 2700 kg/m^3"), [7.0e10, 2.63e10, 2700.0]),
    (("titanium", "Ti-6Al-4V: E 114 GPa, G 43 GPa, 4430 kg/m^3"), [1.14e11, 4.3e10, 4430.0]),
    (("cast_iron", "with spheroidal graphite: E 169 GPa, G 66 GPa, 7100 kg/m^3"), [1.69e11, 6.6e10, 7100.0]),
];
const WORDS: &[Word] = &[MATERIALS[0].0, MATERIALS[1].0, MATERIALS[2].0, MATERIALS[3].0, MATERIALS[4].0];

/// Most sections, elements of a section, and elements of a shaft.
const MOST_SECTIONS: usize = 500;
const MOST_ELEMENTS: i64 = 500;
const MOST: usize = 1000;
/// Largest slope, rad, whose square is left out.
const SMALL: f64 = 0.1;
/// Length and diameter, m, from which on a number without its unit is more likely than such a shaft.
const LONGEST: f64 = 50.0;
const THICKEST: f64 = 5.0;
/// Coordinates of a node of a shaft that bends only.
const BENDING: usize = 4;

/// See the [module](self).
#[derive(Clone, Debug, PartialEq)]
pub struct Shaft {
    lengths: Vec<f64>,
    /// Outer diameters by which it is divided, m.
    diameters: Vec<f64>,
    elements: Option<usize>,
    shear: Shear,
    cone: Cone,
    /// It also moves along its axis.
    axial: bool,
    /// It also twists.
    torsional: bool,
    /// The part that gives the ratio of its spin.
    spin: Option<String>,
    /// Layers on it or in it.
    layers: Vec<Layer>,
    mesh: Mesh,
    prepared: Option<Arc<Prepared>>,
}

impl Shaft {
    /// Sections of these lengths, m, to be divided by these outer diameters, m.
    pub fn new(lengths: &[f64], diameters: &[f64]) -> Self {
        let mesh = Mesh::new(lengths, diameters, None, &[]);
        Shaft {
            lengths: lengths.to_vec(),
            diameters: diameters.to_vec(),
            elements: None,
            shear: Shear::Cowper,
            cone: Cone::Flexibility,
            axial: false,
            torsional: false,
            spin: None,
            layers: Vec::new(),
            mesh,
            prepared: None,
        }
    }
    /// With layers on it or in it.
    pub fn layers(self, layers: Vec<Layer>) -> Self {
        let shaft = Shaft { layers, ..self };
        Shaft { mesh: shaft.divide(&[]), ..shaft }
    }
    /// Nodes at the ends of the layers and at these positions.
    fn divide(&self, positions: &[f64]) -> Mesh {
        let all: Vec<f64> = positions.iter().copied().chain(self.layers.iter().flat_map(|l| [l.from, l.to])).collect();
        Mesh::new(&self.lengths, &self.diameters, self.elements, &all)
    }
    /// With so many elements in every section.
    pub fn elements(self, count: usize) -> Self {
        let shaft = Shaft { elements: Some(count), ..self };
        Shaft { mesh: shaft.divide(&[]), ..shaft }
    }
    /// With another law of shear.
    pub fn shear(self, shear: Shear) -> Self {
        Shaft { shear, ..self }
    }
    /// With other matrices of conical elements.
    pub fn cone(self, cone: Cone) -> Self {
        Shaft { cone, ..self }
    }
    /// With displacement along the axis and rotation about it as well.
    pub fn coordinates(self, axial: bool, torsional: bool) -> Self {
        Shaft { axial, torsional, ..self }
    }
    /// Turning with another spin than that of the machine: the name of the part that gives its ratio.
    pub fn spin(self, name: impl Into<String>) -> Self {
        Shaft { spin: Some(name.into()), ..self }
    }
    /// Coordinates of a node: x, y, tilt_x, tilt_y, then axial and twist as far as it has them.
    fn node(&self) -> usize {
        BENDING + usize::from(self.axial) + usize::from(self.torsional)
    }
    /// Place of the rotation about the axis among them.
    fn twist(&self) -> usize {
        BENDING + usize::from(self.axial)
    }
    /// Coordinates of an element.
    fn ends(&self, k: usize) -> Ends {
        Ends { lower: self.node() * k, upper: self.node() * (k + 1) }
    }

    /// An element by its number.
    #[inline(always)]
    fn element<S: Scalar>(&self, p: &Params<Self, S>, k: usize) -> Element<S> {
        let piece = self.mesh.pieces[k];
        let s = &p.own.rows[piece.section];
        Element {
            length: piece.length,
            outer: taper(s.outer_diameter, s.end_outer_diameter, (piece.from, piece.to)),
            inner: taper(s.inner_diameter, s.end_inner_diameter, (piece.from, piece.to)),
            material: Material { modulus: p.modulus, shear_modulus: p.shear_modulus, density: p.density },
            shear: self.shear,
            cone: self.cone,
            layers: self.layers_of(p, k),
        }
    }
    /// What the layers add to an element.
    #[inline(always)]
    fn layers_of<S: Scalar>(&self, p: &Params<Self, S>, k: usize) -> Layers<S> {
        let mut out = Layers::none();
        // 0 times NaN is NaN
        let own = |layer: S, shaft: S| layer.select_pos(layer, shaft + layer.scale(0.0));
        for (number, _) in self.covering(k) {
            let l = &p.rows[number];
            let material = Material {
                modulus: own(l.modulus, p.modulus),
                shear_modulus: own(l.shear_modulus, p.shear_modulus),
                density: own(l.density, p.density),
            };
            out = out.with([l.inner_diameter, l.outer_diameter], material, self.shear, l.stiffness);
        }
        out
    }
    /// The layers that cover an element.
    fn covering(&self, k: usize) -> impl Iterator<Item = (usize, &Layer)> {
        let middle = 0.5 * (self.mesh.nodes[k] + self.mesh.nodes[k + 1]);
        self.layers.iter().enumerate().filter(move |l| l.1.covers(middle))
    }
}

/// Diameters at two shares of the length of a section; a cylinder, whose end is 0, stays one to the last digit.
#[inline(always)]
fn taper<S: Scalar>(start: S, end: S, (from, to): (f64, f64)) -> [S; 2] {
    if end.value() == 0.0 {
        return [start, start];
    }
    [start.scale(1.0 - from) + end.scale(from), start.scale(1.0 - to) + end.scale(to)]
}

impl Part for Shaft {
    const KIND: &'static str = "shaft";
    const EXAMPLE: &'static str = r#"section = { length = ["120 mm", "400 mm", "80 mm"], outer_diameter = ["40 mm", "60 mm", "40 mm"] }
material = "steel"
"#;
    const DOC: &'static str = "An elastic shaft of sections: finite elements with bending, shear, rotary inertia and gyroscopic coupling. Other parts attach \
        anywhere along it, at = \"120 mm\" from its lower end, and each gets a node; discs that give on = { body = .., at = .. } sit on it. It holds itself \
        nowhere: bearings do.";
    type Family = WithRows<WithRows<ShaftFamily, SectionFamily>, LayerFamily>;
    const FIELDS: &'static [Field] = &[
        Field::required(
            "section",
            FieldKind::Columns(SECTION),
            "the sections from the lower end to the upper: as many entries in each list",
        ),
        Field::optional("spin", FieldKind::Text, "", SPIN),
        Field::optional(
            "layer",
            FieldKind::Columns(LAYER),
            "",
            "cylindrical layers on the shaft or in its bore, such as sleeves: as many entries in each list; stiffnesses and masses of layers and shaft add up, with one slope and one shear angle",
        ),
        Field::optional(
            "material",
            FieldKind::Choice(WORDS),
            "steel",
            "material; modulus, shear_modulus and density are its values unless given",
        ),
        Field::optional(
            "elements",
            FieldKind::IntegerOrAuto { min: 1, max: MOST_ELEMENTS },
            "auto",
            "number of elements of every section; auto makes them half as long as thick, 60 for the whole shaft at most",
        ),
        Field::optional(
            "shear",
            FieldKind::Choice(&[
                ("cowper", "with Cowper's coefficient"),
                ("hutchinson", "with Hutchinson's coefficient"),
                ("none", "left out: a slender beam of Euler and Bernoulli"),
            ]),
            "cowper",
            "shear deflection",
        ),
        Field::optional(
            "cone",
            FieldKind::Choice(&[
                ("flexibility", "from the flexibility of the cone: it converges fast"),
                ("mid_section", "with the shape functions of the section in the middle, as other programs have it"),
            ]),
            "flexibility",
            "elements of conical sections",
        ),
        Field::optional(
            "axial",
            FieldKind::Flag,
            "false",
            "it also moves along its axis; something must hold it there, such as kzz of a bearing",
        ),
        Field::optional(
            "torsional",
            FieldKind::Flag,
            "false",
            "it also twists: twist is the rotation relative to the spin; a coupling to \"ground\" joins it to a drive that turns at the spin speed",
        ),
    ];

    fn build(values: &Values, params: &mut ParamValues, diagnostics: &mut Diagnostics) -> Option<Self> {
        let columns = values.columns("section")?;
        let (lengths, outer) = (columns.get("length")?, columns.get("outer_diameter")?);
        let mut refuse = |message: Text, help: Text| {
            diagnostics.push(Diagnostic::error("shaft.section", message).at(values.span_of("section")).help(help));
        };
        if lengths.is_empty() || lengths.len() > MOST_SECTIONS {
            refuse(text!("a shaft has 1 to {most} sections", most = MOST_SECTIONS), text!("give each section one entry in every list"));
            return None;
        }
        if let Some(l) = lengths.iter().find(|l| !(1e-6..=1e3).contains(*l)) {
            refuse(text!("a section is {length} long", length = text::quantity(*l, "m")), text!("lengths are between 1 µm and 1 km"));
            return None;
        }
        if let Some(d) = outer.iter().find(|d| !(1e-6..=100.0).contains(*d)) {
            refuse(
                text!("the outer diameter of a section is {diameter}", diameter = text::quantity(*d, "m")),
                text!("diameters are between 1 µm and 100 m"),
            );
            return None;
        }
        let named = values.choice("material").unwrap_or(WORDS[0].0);
        if let Some((_, data)) = MATERIALS.iter().find(|m| m.0.0 == named) {
            for (name, x) in ["modulus", "shear_modulus", "density"].into_iter().zip(data) {
                if !values.written(name) {
                    params.set(name, *x);
                }
            }
        }
        let shear = match values.choice("shear") {
            Some("hutchinson") => Shear::Hutchinson,
            Some("none") => Shear::None,
            _ => Shear::Cowper,
        };
        let cone = if values.choice("cone") == Some("mid_section") { Cone::MidSection } else { Cone::Flexibility };
        let own = |name: &str| values.flag(name) == Some(true);
        let layers = Layer::read(values, lengths.iter().sum(), diagnostics)?;
        let shaft = Shaft::new(lengths, outer).shear(shear).cone(cone).coordinates(own("axial"), own("torsional")).layers(layers);
        let shaft = Shaft { spin: values.text("spin").map(str::to_string), ..shaft };
        let mut refuse = |message: Text, help: Text| {
            diagnostics.push(Diagnostic::error("shaft.section", message).at(values.span_of("section")).help(help));
        };
        let Some(n) = values.integer("elements") else { return Some(shaft) };
        let n = n.clamp(1, MOST_ELEMENTS) as usize;
        if n * lengths.len() > MOST {
            refuse(text!("a shaft of {elements} elements", elements = n * lengths.len()), text!("it has at most {most}", most = MOST));
            return None;
        }
        Some(shaft.elements(n))
    }
    #[inline(never)]
    fn erased(self) -> ErasedPart {
        Arc::new(self)
    }
    fn layout(&self) -> Layout {
        let mut own = Vec::with_capacity(self.node() * self.mesh.nodes.len());
        for k in 1..=self.mesh.nodes.len() {
            let along = self.axial.then(Dof::axial).into_iter().chain(self.torsional.then(Dof::twist));
            let node = Dof::lateral().into_iter().chain(Dof::tilt()).chain(along);
            own.extend(node.map(|d| Dof { name: format!("node_{k}.{}", d.name), ..d }));
        }
        Layout { spin: self.spin.clone(), ..Layout::body(own) }
    }
    fn physics(&self) -> Physics {
        Physics::Linear
    }

    #[inline(always)]
    fn linear<S: Scalar>(&self, p: &Params<Self, S>, _: S, b: &mut Blocks<S>) {
        let one = S::one();
        let (fixed, turning) = (p.stiffness_damping, p.rotating_damping);
        self.each(p, |k, Matrices { plane, torque, axial, torsional, .. }| {
            let ends = self.ends(k);
            add_planes(&mut b.mass, ends, &plane.mass, one);
            add_planes(&mut b.stiffness, ends, &plane.stiffness, one);
            add_planes(&mut b.damping, ends, &plane.mass, p.mass_damping);
            add_planes(&mut b.damping, ends, &plane.stiffness, fixed + turning);
            add_cross(&mut b.gyroscopic, ends, &plane.gyroscopic, one);
            add_cross(&mut b.spin_accel_stiffness, ends, &plane.gyroscopic, S::cst(0.5));
            if !turning.is_nothing() {
                add_cross(&mut b.circulatory, ends, &plane.stiffness, turning);
            }
            if !p.axial_force.is_nothing() {
                add_planes(&mut b.stiffness, ends, &plane.axial, p.axial_force);
            }
            if let Some(t) = torque {
                let (x, y) = (ends.x(), ends.y());
                for i in 0..4 {
                    for j in 0..4 {
                        b.stiffness[(y[i], x[j])] += p.torque.scale(-SIGN[i] * t[i][j]);
                        b.stiffness[(x[i], y[j])] += p.torque.scale(SIGN[j] * t[i][j]);
                    }
                }
            }
            if let Some(line) = axial {
                let at = ends.along(BENDING);
                add_line(&mut b.mass, at, &line.mass, one);
                add_line(&mut b.stiffness, at, &line.stiffness, one);
                add_line(&mut b.damping, at, &line.mass, p.mass_damping);
                add_line(&mut b.damping, at, &line.stiffness, fixed + turning);
            }
            if let Some(line) = torsional {
                let at = ends.along(self.twist());
                add_line(&mut b.mass, at, &line.mass, one);
                add_line(&mut b.stiffness, at, &line.stiffness, one);
                add_line(&mut b.damping, at, &line.stiffness, fixed + turning);
                for (&i, row) in at.iter().zip(&line.mass) {
                    b.spin_accel_force[i] -= row[0] + row[1];
                }
            }
        });
    }

    #[inline(always)]
    fn spin_row<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> S {
        let mut r = S::zero();
        self.each(p, |k, Matrices { plane, spin_inertia, torsional, .. }| {
            let ends = self.ends(k);
            let ([qx, qy], [vx, vy], [ax, ay]) = (planes(ends, at.q), planes(ends, at.v), planes(ends, at.a));
            r += *spin_inertia * at.spin_accel;
            r += (form(&ax, &plane.gyroscopic, &qy) - form(&ay, &plane.gyroscopic, &qx)).scale(0.5);
            if !p.rotating_damping.is_nothing() {
                let [sx, sy] = slip(at.speed, [qx, qy], [vx, vy]);
                r -= p.rotating_damping * (form(&qx, &plane.stiffness, &sy) - form(&qy, &plane.stiffness, &sx));
            }
            if let Some(Line { mass, .. }) = torsional {
                for (i, row) in ends.along(self.twist()).into_iter().zip(mass) {
                    r += (row[0] + row[1]) * at.a[i];
                }
            }
        });
        r
    }

    fn energy<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> Option<Energy<S>> {
        // a torque of fixed direction has no potential
        if !p.torque.is_nothing() {
            return None;
        }
        let (mut stored, mut dissipated) = (S::zero(), S::zero());
        self.each(p, |k, Matrices { plane, spin_inertia, axial, torsional, .. }| {
            let ends = self.ends(k);
            let ([qx, qy], [vx, vy]) = (planes(ends, at.q), planes(ends, at.v));
            let both = |m: &M4<S>, x: &[S; 4], y: &[S; 4]| form(x, m, x) + form(y, m, y);
            let moving = both(&plane.mass, &vx, &vy);
            stored += (moving + both(&plane.stiffness, &qx, &qy)).scale(0.5);
            if !p.axial_force.is_nothing() {
                stored += (p.axial_force * both(&plane.axial, &qx, &qy)).scale(0.5);
            }
            stored += (*spin_inertia * at.speed * at.speed).scale(0.5);
            stored += (at.speed * (form(&vx, &plane.gyroscopic, &qy) - form(&vy, &plane.gyroscopic, &qx))).scale(0.5);
            dissipated += p.mass_damping * moving;
            if !p.stiffness_damping.is_nothing() {
                dissipated += p.stiffness_damping * both(&plane.stiffness, &vx, &vy);
            }
            if !p.rotating_damping.is_nothing() {
                let [sx, sy] = slip(at.speed, [qx, qy], [vx, vy]);
                dissipated += p.rotating_damping * both(&plane.stiffness, &sx, &sy);
            }
            let material = p.stiffness_damping + p.rotating_damping;
            if let Some(line) = axial {
                let place = ends.along(BENDING);
                let moving = line_form(place, &line.mass, at.v);
                stored += (moving + line_form(place, &line.stiffness, at.q)).scale(0.5);
                dissipated += p.mass_damping * moving + material * line_form(place, &line.stiffness, at.v);
            }
            if let Some(line) = torsional {
                let place = ends.along(self.twist());
                stored += (line_form(place, &line.mass, at.v) + line_form(place, &line.stiffness, at.q)).scale(0.5);
                for (&i, row) in place.iter().zip(&line.mass) {
                    stored += at.speed * (row[0] + row[1]) * at.v[i];
                }
                dissipated += material * line_form(place, &line.stiffness, at.v);
            }
        });
        Some(Energy { stored, dissipated, ..Energy::zero() })
    }

    fn validity(&self, _: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Validity>) {
        // NaN stays
        let slope = at.q.chunks_exact(self.node()).map(|q| q[2].hypot(q[3])).fold(0.0, |m, x| if x <= m { m } else { x });
        out.push(Validity { what: "slope over 0.1 rad", ratio: slope / SMALL });
    }

    fn check(&self, p: &Params<Self, f64>) -> Vec<(&'static str, Text)> {
        let mut wrong = Vec::new();
        for (k, s) in p.own.rows.iter().enumerate() {
            let end = |end: f64, start: f64| if end == 0.0 { start } else { end };
            let ends = [
                (s.inner_diameter, s.outer_diameter),
                (end(s.end_inner_diameter, s.inner_diameter), end(s.end_outer_diameter, s.outer_diameter)),
            ];
            if ends.iter().any(|(i, o)| !(i < o)) {
                wrong.push(("section", text!("section {number}: the inner diameter must be less than the outer one", number = k + 1)));
            }
        }
        for (k, layer) in p.rows.iter().enumerate() {
            if let Some((message, _)) = layer.wrong(k + 1) {
                wrong.push(("layer", message));
            }
        }
        for k in 0..self.mesh.pieces.len() {
            let e = self.element(p, k);
            for (number, _) in self.covering(k) {
                let (inner, outer) = (p.rows[number].inner_diameter, p.rows[number].outer_diameter);
                let thin = 1e-6 * outer;
                let overlaps = (0..2).any(|i| inner < e.outer[i] - thin && outer > e.inner[i] + thin);
                if overlaps && !wrong.iter().any(|w: &(&str, Text)| w.0 == "layer") {
                    wrong.push((
                        "layer",
                        text!(
                            "layer {number} overlaps the shaft at {position}: its inner diameter is {inner}, the outer diameter of the shaft there {outer}",
                            number = number + 1,
                            position = text::quantity(self.mesh.nodes[k], "m"),
                            inner = text::quantity(inner, "m"),
                            outer = text::quantity(e.outer[0].max(e.outer[1]), "m")
                        ),
                    ));
                }
            }
        }
        for k in 0..self.mesh.pieces.len() {
            let mut here: Vec<(f64, f64, usize)> =
                self.covering(k).map(|(n, _)| (p.rows[n].inner_diameter, p.rows[n].outer_diameter, n + 1)).collect();
            here.sort_by(|a, b| a.0.total_cmp(&b.0));
            let twice = here.windows(2).find(|w| w[1].0 < w[0].1 * (1.0 - 1e-6));
            if let Some(w) = twice.filter(|_| !wrong.iter().any(|w: &(&str, Text)| w.0 == "layer")) {
                let (first, second) = (w[0].2.min(w[1].2), w[0].2.max(w[1].2));
                let position = text::quantity(self.mesh.nodes[k], "m");
                wrong.push(("layer", text!("layers {first} and {second} are in the same space at {position}", first, second, position)));
            }
        }
        // nu = E/(2 G) - 1
        let nu = p.modulus / (2.0 * p.shear_modulus) - 1.0;
        if self.shear != Shear::None && !(0.0..=0.5).contains(&nu) {
            wrong.push((
                "shear_modulus",
                text!(
                    "modulus and shear_modulus make a Poisson's ratio of {nu}, which no metal has: E = 2 G (1 + nu)",
                    nu = text::number(nu, 3)
                ),
            ));
        }
        wrong
    }
    fn warnings(&self, p: &Params<Self, f64>) -> Vec<Text> {
        let (length, mut out) = (self.lengths.iter().sum::<f64>(), Vec::new());
        let thickest = p.own.rows.iter().map(|s| s.outer_diameter.max(s.end_outer_diameter)).fold(0.0, f64::max);
        if length > LONGEST || thickest > THICKEST {
            let (length, diameter) = (text::quantity(length, "m"), text::quantity(thickest, "m"));
            out.push(text!("it is {length} long and up to {diameter} thick: lengths without a unit are in metres", length, diameter));
        }
        // both ends clamped: no other support of the ends holds more
        let stiffest =
            (0..self.mesh.pieces.len()).map(|k| self.element(p, k)).map(|e| e.bending(0.0).max(e.bending(1.0))).fold(0.0, f64::max);
        let limit = stiffest * (2.0 * PI / length).powi(2);
        if p.axial_force < -limit {
            let (force, limit) = (text::quantity(-p.axial_force, "N"), text::quantity(limit, "N"));
            out.push(text!(
                "a compression of {force} buckles it, unless bearings between its ends hold it: with both ends clamped it bears {limit} at most",
                force,
                limit
            ));
        }
        out
    }
    fn body(&self) -> Option<&dyn erased::BodyPart> {
        Some(self)
    }
    fn extent(&self) -> Option<&dyn erased::Extent> {
        Some(self)
    }
}

impl Extent for Shaft {
    fn reach(&self) -> usize {
        2 * self.node() - 1
    }
    #[inline(always)]
    fn rows(&self) -> RowCounts {
        [self.lengths.len(), self.layers.len()]
    }
    fn is_steady(&self) -> bool {
        true
    }
    fn prepared(&self, p: &Params<Self, f64>) -> Option<ErasedPart> {
        Some(self.prepared_for(p).erased())
    }
}

impl BodyPart for Shaft {
    fn shape(&self, p: &Params<Self, f64>, position: f64) -> Vec<[f64; 6]> {
        let mut out = vec![[0.0; 6]; self.node() * self.mesh.nodes.len()];
        let along = [(self.axial, BENDING, 4), (self.torsional, self.twist(), 5)];
        if let Some(node) = self.mesh.node(position) {
            let first = self.node() * node;
            (0..BENDING).for_each(|i| out[first + i][i] = 1.0);
            along.iter().filter(|x| x.0).for_each(|&(_, place, component)| out[first + place][component] = 1.0);
            return out;
        }
        let (k, share) = self.mesh.place(position);
        let (element, ends) = (self.element(p, k), self.ends(k));
        let ([deflection, slope], line) = (element.shape(share), element.line_shape(share));
        for (i, (x, y)) in ends.x().into_iter().zip(ends.y()).enumerate() {
            // x = N u and beta = R u; y = N S u and alpha = -R S u
            (out[x][0], out[x][3]) = (deflection[i], slope[i]);
            (out[y][1], out[y][2]) = (SIGN[i] * deflection[i], -SIGN[i] * slope[i]);
        }
        for (n, (_, place, component)) in line.into_iter().zip(along).filter(|x| x.1.0) {
            let [lower, upper] = ends.along(place);
            (out[lower][component], out[upper][component]) = (1.0 - n, n);
        }
        out
    }
    fn nodes(&self) -> Option<Vec<f64>> {
        Some(self.mesh.nodes.clone())
    }
    fn profile(&self, p: &Params<Self, f64>) -> Vec<[f64; 4]> {
        let ends = self.mesh.nodes.windows(2).enumerate();
        let outer = |k: usize| {
            let layers = self.covering(k).map(|l| p.rows[l.0].outer_diameter).fold(0.0, f64::max);
            self.element(p, k).outer.map(|d: f64| d.max(layers))
        };
        ends.map(|(k, z)| (z, outer(k))).map(|(z, d)| [z[0], z[1], d[0], d[1]]).collect()
    }
    fn divided(&self, positions: &[f64]) -> Option<ErasedPart> {
        let mesh = self.divide(positions);
        (mesh != self.mesh).then(|| Shaft { mesh, prepared: None, ..self.clone() }.erased())
    }
    fn turns(&self) -> bool {
        true
    }
}

crate::conformance! {
    Shaft {
        tapered: tests::shaft(), tests::params(ShaftParams::new()), Options::default();
        damped: tests::shaft().shear(Shear::Hutchinson).cone(Cone::MidSection),
            tests::params(ShaftParams { rotating_damping: 2e-5, mass_damping: 3.0, stiffness_damping: 1e-5, axial_force: 4e4, ..ShaftParams::new() }),
            Options::default();
        axial_and_torsional: tests::shaft().coordinates(true, true),
            tests::params(ShaftParams { rotating_damping: 2e-5, mass_damping: 3.0, stiffness_damping: 1e-5, ..ShaftParams::new() }),
            Options::default();
        layered: tests::shaft().coordinates(true, true).layers(tests::layers()), tests::layered(ShaftParams { rotating_damping: 2e-5, ..ShaftParams::new() }), Options::default();
        torsional: tests::shaft().coordinates(false, true).cone(Cone::MidSection), tests::params(ShaftParams::new()), Options::default();
        twisted: tests::shaft().shear(Shear::None), tests::params(ShaftParams { torque: 2e3, ..ShaftParams::new() }), Options { energy: false, ..Options::default() };
    }
}
