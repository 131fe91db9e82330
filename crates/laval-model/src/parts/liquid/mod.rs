//! A cylindrical cavity partly filled with liquid that turns with the rotor.
//!
//! Equations of the plane flow of an ideal liquid, with `z` the cavity centre, `beta` and `eta` (surface displacement) in fixed axes:
//!
//! ```text
//! beta' = i W beta + g (2 i W beta + W^2 eta - z'') - 2 delta beta
//! eta'  = i W eta - beta
//! F     = -mL [g z'' + (1 - g)(2 i W beta + W^2 eta)] + i W' mo eta          on the rotor
//! spin row: (ml/2)(R^2 + r0^2) W'
//! ```
//!
//! Reaction on tilt theta about the cavity centre, by model:
//!
//! ```text
//! planar       none
//! strip        the same flow in every slice: equations above with theta for z and mL h^2/12 for mL
//! planar_tilt  A = -pi rho [R^2 h^3/12 - h (R^4 - r0^4)/4], C = 2 A:  A theta'' - i C W theta' - (i/2) C W' theta
//! spatial      axial flow as well, in the frequency domain: [cavity](crate::cavity)
//! frozen       a rigid ring: ml, A = ml [(R^2 + r0^2)/4 + h^2/12], C = ml (R^2 + r0^2)/2
//! ```
//!
//! In time spatial, and whatever has a viscosity, is a rational function with a stated error: timed.
//!
//! With viscosity the plane flow (of every slice) has its exact force in the frequency domain, and spatial its tilt reaction with ends without friction.
//!
//! Symbols: R cavity radius, r0 radius of the undisturbed free surface, h height, m; rho density, kg/m^3; mL = pi R^2 h rho the full cavity,
//! mo = mL (r0/R)^2, ml = mL - mo the real liquid, kg; g = (R^2 - r0^2)/(R^2 + r0^2); delta damping of the surface wave in rotor axes, 1/s; W spin
//! speed. Empty, full and partly filled are separate cases: a full cavity is frozen liquid in the plane, an empty one is nothing.
//!
//! Validity: surface displacement well below the layer thickness, cavity always wetted (W^2 r0 above the local acceleration), no viscosity but
//! delta or the viscosity given, spin-up slow against r0^2/(14.7 nu). planar: motion without tilt. planar_tilt is an approximation that takes tilt inertia
//! away from a tall cavity. The cavity is straight; it may be off the shaft and skew to it (offset). Ends without friction: the Ekman layers of real ends are
//! not in any model.
//!
//! Theory: `docs/theory/liquid-plane-flow.md#state-form`, `docs/theory/liquid-in-three-dimensions.md#simplified-models`.
//!
//! Sources: `000_a291f7ede1484e56` equations (12)-(24), corrected; state form derived from the same flow; `001_352384e7bf252e35` equations (7)-(34),
//! corrected.

use crate::cavity::line::{Line, Lines};
use crate::cavity::{Cavity, Tilt, Truncation};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::blocks::Blocks;
use crate::model::capability::added_inertia::{AddedInertia, Removed};
use crate::model::capability::{Filling, FrequencyDomain, ReplacedInTime};
use crate::model::erased;
use crate::model::field::{Attach, Bounds, Field, FieldKind, ParamValues, Value, Values};
use crate::model::part::{
    At, Dof, DofKind, Domain, Energy, ErasedPart, Fitted, Layout, Link, Observed, Params, Part, Physics, TimeForm, Validity,
};
use crate::model::timed::{Speeds, Untimed};
use crate::params;
use crate::text;
use crate::text::Text;
use laval_num::analytic::value;
use laval_num::complex::{Complex, c};
use laval_num::scalar::Scalar;
use std::cell::RefCell;
use std::f64::consts::PI;
use std::sync::Arc;

mod check;
mod domain;
mod offset;
mod plane;
mod timed;
mod words;

params! {
    /// Parameters of a [`Liquid`].
    pub struct LiquidParams in LiquidFamily {
        cavity_radius: scalar, "m", Bounds::closed(1e-6, 100.0), required, "cavity radius R";
        cavity_height: scalar, "m", Bounds::closed(1e-6, 1000.0), required, "cavity height h";
        density: scalar, "kg/m^3", Bounds::closed(1e-3, 3e4), required, "liquid density rho";
        free_surface_radius: scalar, "m", Bounds::up_to(100.0), required, "radius r0 of the undisturbed free surface";
        wave_damping: scalar, "1/s", Bounds::up_to(1e6), default 0.0, "damping delta of the surface wave in rotor axes";
        viscosity: scalar, "m^2/s", Bounds::up_to(10.0), default 0.0, "kinematic viscosity nu; above 0 the force is exact in the frequency domain; in time it has a form at constant speed";
        eccentricity: scalar, "m", Bounds::up_to(1.0), default 0.0, "distance e of the middle of the cavity from the shaft";
        eccentricity_phase: scalar, "rad", Bounds::within(1e3), default 0.0, "direction of the eccentricity from the key mark";
        skew: scalar, "rad", Bounds::within(0.5), default 0.0, "angle tau by which the cavity's axis is turned out of the shaft; of a rotor that sits askew on its shaft the same as the disc's";
        skew_phase: scalar, "rad", Bounds::within(1e3), default 0.0, "angle phi_t from the key mark to the axis about which the skew turns";
    }
}

/// How full the cavity is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fill {
    /// No liquid.
    Empty,
    /// A free surface.
    Partial,
    /// No free surface.
    Full,
}

/// How the liquid flows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Model {
    /// In planes across the axis, driven by the motion of the cavity centre.
    Planar,
    /// The same, and of the reaction on tilt what needs no axial flow.
    PlanarTilt,
    /// In planes across the axis, each driven by its own motion.
    Strip,
    /// In three dimensions.
    Spatial,
    /// Not at all.
    Frozen,
}

const MODELS: [(&str, Model); 5] = [
    ("planar", Model::Planar),
    ("planar_tilt", Model::PlanarTilt),
    ("strip", Model::Strip),
    ("spatial", Model::Spatial),
    ("frozen", Model::Frozen),
];
/// Highest axial harmonic that may be requested.
const MOST_HARMONICS: i64 = 999;
/// Relative error of a time form where none is given.
const TIME_ERROR: f64 = 1e-4;
/// Largest share of the tilt reaction that its estimated error may be.
const ACCURACY: f64 = 1e-6;

thread_local! {
    static BLOCKS: RefCell<Blocks<f64>> = RefCell::default();
}

/// See the [module](self).
#[derive(Clone)]
pub struct Liquid {
    attach: Attach,
    fill: Fill,
    model: Model,
    viscous: bool,
    harmonics: Truncation,
    /// Relative error that a time form may have.
    accuracy: f64,
    /// Reactions in time, where they are no closed forms.
    time: Option<Arc<timed::Rationals>>,
    memo: timed::Memo,
    lines: Lines,
}

struct Coefficients<S> {
    full: S,
    void: S,
    g: S,
}

impl Liquid {
    /// Ideal liquid in plane flow in the cavity of a body; the case must agree with the free-surface radius.
    pub fn new(attach: Attach, fill: Fill) -> Self {
        Liquid {
            attach,
            fill,
            model: Model::Planar,
            viscous: false,
            harmonics: Truncation::None,
            accuracy: TIME_ERROR,
            time: None,
            memo: timed::Memo::default(),
            lines: Lines::default(),
        }
    }
    /// The same with this relative error of its time form allowed.
    pub fn accurate(self, accuracy: f64) -> Self {
        Liquid { accuracy, ..self }
    }
    /// The same with another flow.
    pub fn flowing(self, model: Model) -> Self {
        Liquid { model, ..self }
    }
    /// The same with axial harmonics up to this one only.
    pub fn truncated(self, last: usize) -> Self {
        Liquid { harmonics: Truncation::At(last), ..self }
    }
    /// The same with viscosity.
    pub fn viscous(self) -> Self {
        Liquid { viscous: true, ..self }
    }
    #[inline(always)]
    fn coefficients<S: Scalar>(p: &LiquidParams<S>) -> Coefficients<S> {
        let (r2, s2) = (p.cavity_radius.square(), p.free_surface_radius.square());
        let column = p.cavity_height * p.density;
        Coefficients { full: (r2 * column).scale(PI), void: (s2 * column).scale(PI), g: (r2 - s2) / (r2 + s2) }
    }
    /// States of a surface wave.
    fn waves(&self) -> bool {
        self.fill == Fill::Partial && self.physics() == Physics::Linear && self.model != Model::Frozen && !self.viscous
    }
    #[inline(always)]
    fn cavity<S: Scalar>(p: &LiquidParams<S>) -> Cavity<S> {
        Cavity { radius: p.cavity_radius, free: p.free_surface_radius, height: p.cavity_height, density: p.density }
    }
    /// A and C of what turns with the rotor as a rigid body would.
    #[inline(always)]
    fn rigid<S: Scalar>(&self, p: &LiquidParams<S>) -> Option<[S; 2]> {
        let Coefficients { full, void, .. } = Self::coefficients(p);
        let (r2, s2, h2) = (p.cavity_radius.square(), p.free_surface_radius.square(), p.cavity_height.square());
        match (self.model, self.fill) {
            (_, Fill::Empty) => None,
            (Model::Frozen, _) => {
                let square = (r2 + s2).scale(0.25);
                Some([(full - void) * (square + h2.scale(1.0 / 12.0)), (full - void) * square.scale(2.0)])
            }
            (Model::PlanarTilt, _) => {
                let a = (p.density * Self::cavity(p).mean()).scale(-PI);
                Some([a, a.scale(2.0)])
            }
            _ => None,
        }
    }
    /// Forward dynamic stiffness of displacement and tilt at `s`.
    fn forward<S: Scalar>(&self, p: &LiquidParams<S>, s: Complex<S>, speed: S) -> [Complex<S>; 2] {
        let (cavity, w) = (Self::cavity(p), c(s.im, -s.re));
        let planar = match (self.viscous, self.fill) {
            (true, _) => cavity.planar_viscous(w, speed, p.viscosity),
            (_, Fill::Full) => (w * w).scale(cavity.full_mass()),
            _ => cavity.planar(w, speed),
        };
        let tilt = match self.model {
            Model::Spatial => {
                let Tilt { value: tilt, error, .. } = if self.viscous {
                    cavity.tilt_viscous(w, speed, p.viscosity, self.harmonics)
                } else if self.harmonics == Truncation::Rough {
                    self.lines.tilt(Line(Domain::MARGIN), cavity, s, speed)
                } else {
                    cavity.tilt(w, speed, self.harmonics)
                };
                // an inaccurate reaction is none
                let size = value(tilt).abs() + value(cavity.mean_tilt(w, speed)).abs();
                if error <= ACCURACY * size || size == 0.0 { tilt } else { Complex::cst(c(f64::NAN, f64::NAN)) }
            }
            _ => planar.scale(cavity.slices()),
        };
        [-planar, -tilt]
    }
}

impl Part for Liquid {
    const KIND: &'static str = "liquid";
    const EXAMPLE: &'static str = r#"in = "drum"
cavity_radius = "150 mm"
cavity_height = "80 mm"
density = "1000 kg/m^3"
fill = { volume_fraction = 0.1 }    # or free_surface_radius, volume, mass
wave_damping = "4 1/s"
"#;
    const DOC: &'static str = "Liquid in a cylindrical cavity that turns with a body. Partly filled cavities carry waves that can make the \
        rotor whirl by itself; the fill is given by the radius of the free surface, a volume fraction, a volume or a mass. On a disc that tilts, strip \
        lets every slice flow by itself, without the pressure on the end caps (were the liquid solid, 3 (R^2 + r^2)/H^2 of the inertia against tilt that it keeps, with the radii R of \
        the wall and r of the surface and the height H), and spatial adds both that and flow along the axis: exact in the frequency domain, in time by a sum over waves with a stated error. Of a viscous \
        liquid motions in time have a rational form, with a stated error, at one constant speed.";
    type Family = LiquidFamily;
    const FIELDS: &'static [Field] = &[
        Field::required("in", FieldKind::Attach { ground: false }, "the body whose cavity it fills, at the middle of the cavity's height"),
        Field::optional(
            "model",
            FieldKind::Choice(&[
                ("planar", "plane flow, driven by the motion of the cavity centre; no reaction on tilt"),
                ("planar_tilt", "plane flow, and of the reaction on tilt what needs no axial flow: an approximation"),
                ("strip", "plane flow in every slice, driven by the motion of that slice"),
                ("spatial", "flow in three dimensions; exact in the frequency domain, in time a sum over waves"),
                ("frozen", "a rigid ring: for bounds only"),
            ]),
            "planar",
            "flow model",
        ),
        Field::optional(
            "axial_harmonics",
            FieldKind::IntegerOrAuto { min: 1, max: MOST_HARMONICS },
            "auto",
            "with spatial: highest axial harmonic k of the series that is taken (1, 3, 5, ...); auto takes all",
        ),
        Field::optional(
            "time_error",
            FieldKind::Quantity { unit: "", bounds: Bounds::closed(1e-6, 0.1) },
            "",
            "with spatial or a viscosity: relative error that the form of the reaction in time may have; 1e-4 when absent; thin liquids in three dimensions need about 1e-2",
        ),
        Field::required("fill", FieldKind::OneOf(check::FILLS), "how much liquid"),
    ];

    fn build(values: &Values, params: &mut ParamValues, diagnostics: &mut Diagnostics) -> Option<Self> {
        let attach = values.attach("in")?;
        let (kind, value) = values.one_of("fill")?;
        let (radius, height, density) = (params.get("cavity_radius")?, params.get("cavity_height")?, params.get("density")?);
        let cavity = PI * radius * radius * height;
        let fraction = match kind {
            "volume_fraction" => value,
            "volume" => value / cavity,
            "mass" => value / (cavity * density),
            _ => 1.0 - (value / radius) * (value / radius),
        };
        if !(0.0..=1.0 + 1e-12).contains(&fraction) {
            let (message, help) = if kind == "free_surface_radius" {
                (
                    check::outside(value, radius),
                    text!("the free surface is the inner face of the layer on the wall: 0 is full, the cavity radius is empty"),
                )
            } else {
                (
                    text!("this is {fraction} times what the cavity holds", fraction = text::number(fraction, 4)),
                    text!(
                        "the cavity holds {cavity}, {density} of this liquid",
                        cavity = text::quantity(cavity, "m^3"),
                        density = text::quantity(cavity * density, "kg")
                    ),
                )
            };
            diagnostics.push(Diagnostic::error("liquid.fill", message).at(values.span_of("fill")).help(help));
            return None;
        }
        let free = if kind == "free_surface_radius" { value } else { radius * (1.0 - fraction).max(0.0).sqrt() };
        params.set("free_surface_radius", free);
        let fill = if free == 0.0 {
            Fill::Full
        } else if free >= radius {
            Fill::Empty
        } else {
            Fill::Partial
        };
        let word = values.choice("model").unwrap_or("planar");
        let model = MODELS.iter().find(|m| m.0 == word)?.1;
        let harmonics = match values.get("axial_harmonics") {
            Some(Value::Integer(k)) => usize::try_from(*k).map_or(Truncation::None, Truncation::At),
            _ => Truncation::None,
        };
        if let Truncation::At(last) = harmonics
            && last % 2 == 0
        {
            let (less, more) = (last.saturating_sub(1).max(1), last + 1);
            diagnostics.push(
                Diagnostic::error("liquid.axial_harmonics", text!("only odd harmonics act on a tilt, and the last one is to be odd"))
                    .at(values.span_of("axial_harmonics"))
                    .help(text!("give axial_harmonics = {less} or {more}", less, more)),
            );
            return None;
        }
        if harmonics != Truncation::None && model != Model::Spatial {
            diagnostics.push(
                Diagnostic::error("liquid.axial_harmonics", text!("{word} has no axial harmonics", word))
                    .at(values.span_of("axial_harmonics"))
                    .help(text!("model = \"spatial\" has them; leave axial_harmonics out otherwise")),
            );
            return None;
        }
        let viscous = params.get("viscosity").is_some_and(|nu| nu > 0.0);
        let accuracy = values.number("time_error");
        if accuracy.is_some() && model != Model::Spatial && !viscous {
            diagnostics.push(
                Diagnostic::error("liquid.time_error", text!("{word} without viscosity is exact in time", word))
                    .at(values.span_of("time_error"))
                    .help(text!("leave time_error out; with model = \"spatial\" or a viscosity it sets the number of waves")),
            );
            return None;
        }
        let accuracy = accuracy.unwrap_or(TIME_ERROR);
        Some(Liquid { model, viscous, harmonics, accuracy, ..Liquid::new(attach, fill) })
    }

    #[inline(never)]
    fn erased(self) -> ErasedPart {
        Arc::new(self)
    }
    fn layout(&self) -> Layout {
        let link = Link::On(self.attach.clone());
        let tilts = self.model != Model::Planar;
        let mut layout = if tilts { Layout::point_and_tilt(link) } else { Layout::point(link) };
        if self.waves() {
            layout.states = Dof::pair("flow_", DofKind::VectorX, "m/s", 1.0);
            layout.states.extend(Dof::pair("surface_", DofKind::VectorX, "m", 1e-3));
            if self.model == Model::Strip {
                layout.states.extend(Dof::pair("tilt_flow_", DofKind::TiltX, "rad/s", 10.0));
                layout.states.extend(Dof::pair("tilt_surface_", DofKind::TiltX, "rad", 1e-2));
            }
        }
        layout.states.extend(self.time_states());
        layout
    }
    fn physics(&self) -> Physics {
        if self.time.is_some() {
            return Physics::Linear;
        }
        match (self.fill, self.model, self.viscous) {
            (Fill::Empty, ..) | (_, Model::Frozen, _) => Physics::Linear,
            (_, _, true) => Physics::Frequency(TimeForm::None("the layer of a viscous liquid at the wall remembers its whole past")),
            (_, Model::Spatial, _) => Physics::Frequency(TimeForm::None("a liquid that flows along the axis has infinitely many waves")),
            _ => Physics::Linear,
        }
    }

    #[inline(always)]
    fn linear<S: Scalar>(&self, p: &Params<Self, S>, w: S, b: &mut Blocks<S>) {
        match self.model {
            Model::Frozen if self.fill != Fill::Empty => {
                let Coefficients { full, void, .. } = Self::coefficients(p);
                for i in 0..2 {
                    b.mass[(i, i)] = full - void;
                }
            }
            Model::Planar | Model::PlanarTilt if !self.viscous => self.plane(p, w, b, 0, 0, None),
            Model::Spatial if !self.viscous && self.time.is_some() => self.plane(p, w, b, 0, 0, None),
            Model::Strip if !self.viscous => {
                self.plane(p, w, b, 0, 0, None);
                self.plane(p, w, b, 2, 4, Some(Self::cavity(p).slices()));
            }
            _ => {}
        }
        if let Some([a, cp]) = self.rigid(p) {
            for i in [2, 3] {
                b.mass[(i, i)] = a;
            }
            b.gyroscopic[(2, 3)] = cp;
            b.gyroscopic[(3, 2)] = -cp;
            b.spin_accel_stiffness[(2, 3)] = cp.scale(0.5);
            b.spin_accel_stiffness[(3, 2)] = cp.scale(-0.5);
        }
        self.add_time_form(p, w, b, self.plane_states());
        self.add_offsets(p, b);
    }

    #[inline(always)]
    fn spin_row<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> S {
        let mut r = self.polar_inertia(p) * at.spin_accel;
        if self.viscous || matches!(self.physics(), Physics::Frequency(_)) {
            return r;
        }
        let seen = self.seen(p, at);
        let at = &seen.at(at);
        r += self.offset_torque(p, &seen, at);
        let turning = self.time.as_ref().map(|_| self.polar_inertia(p)).or(self.rigid(p).map(|[_, cp]| cp));
        if let Some(cp) = turning {
            r += (at.a[2] * at.q[3] - at.q[2] * at.a[3]) * cp.scale(0.5);
        }
        r
    }

    fn energy<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> Option<Energy<S>> {
        if self.time.is_some() || matches!(self.physics(), Physics::Frequency(_)) {
            return None;
        }
        let seen = self.seen(p, at);
        let at = &seen.at(at);
        let w = at.speed;
        let spin = (self.polar_inertia(p) * w * w).scale(0.5);
        let frozen = self.model == Model::Frozen && self.fill != Fill::Empty;
        let [mut stored, wave, mut dissipated, mut supplied] = if frozen {
            let Coefficients { full, void, .. } = Self::coefficients(p);
            [((full - void) * c(at.v[0], at.v[1]).norm_sqr()).scale(0.5), S::zero(), S::zero(), S::zero()]
        } else {
            self.plane_energy(p, at, 0, 0, None)
        };
        stored = stored + wave + spin;
        if self.model == Model::Strip {
            let [layer, wave, lost, gained] = self.plane_energy(p, at, 2, 4, Some(Self::cavity(p).slices()));
            stored += layer + wave;
            dissipated += lost;
            supplied += gained;
        }
        if let Some([a, cp]) = self.rigid(p) {
            let (theta, rate) = (c(at.q[2], at.q[3]), c(at.v[2], at.v[3]));
            stored += (a * rate.norm_sqr() + cp * w * (rate.re * theta.im - theta.re * rate.im)).scale(0.5);
        }
        Some(Energy { stored, dissipated, supplied })
    }

    fn observe(&self, p: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Observed>) {
        if self.fill != Fill::Empty && self.physics() == Physics::Linear {
            let (mut force, mut rate) = (vec![0.0; at.q.len()], vec![0.0; at.z.len()]);
            // allocating the blocks for every instant of a motion took longer than filling them
            BLOCKS.with_borrow_mut(|blocks| {
                blocks.reset(at.q.len(), at.z.len() - self.memory(), at.speed);
                self.linear(p, at.speed, blocks);
                blocks.residual(at, &mut force, &mut rate);
            });
            out.push(Observed { name: "force", unit: "N", value: force[0].hypot(force[1]) });
        }
        if self.waves() {
            let seen = self.seen(p, at);
            let at = &seen.at(at);
            out.push(Observed { name: "surface displacement", unit: "m", value: at.z[2].hypot(at.z[3]) });
        }
    }
    fn validity(&self, p: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Validity>) {
        if self.fill == Fill::Partial && self.model != Model::Frozen {
            let layer = p.cavity_radius - p.free_surface_radius;
            let seen = self.seen(p, at);
            let at = &seen.at(at);
            if self.waves() {
                // the surface is measured from the cavity centre; with tilt it is displaced most at the ends
                let ends = if self.model == Model::Strip { 0.5 * p.cavity_height * at.z[6].hypot(at.z[7]) } else { 0.0 };
                out.push(Validity { what: "surface excursion over layer thickness", ratio: (at.z[2].hypot(at.z[3]) + ends) / layer });
            }
            if self.hidden_surface() && at.speed != 0.0 {
                out.push(Validity {
                    what: "surface excursion over layer thickness, at the spin frequency",
                    ratio: self.steady_excursion(p, at) / layer,
                });
            }
            if self.time.is_some() && at.spin_accel != 0.0 {
                // the waves are those of the speed at the moment
                let turn = 2.0 * PI * at.spin_accel.abs() / (at.speed * at.speed);
                out.push(Validity { what: "change of the speed within a turn over a tenth of it", ratio: turn / 0.1 });
            }
            if let Some(ratio) = self.off_speed(at.speed) {
                out.push(Validity { what: "distance of the speed from that of its form in time, over a billionth of it", ratio });
            }
            let field = at.speed * at.speed * p.free_surface_radius;
            // without spin nothing holds the layer on the wall
            let ratio = if field == 0.0 { f64::INFINITY } else { at.a[0].hypot(at.a[1]) / field };
            out.push(Validity { what: "wall acceleration over centrifugal acceleration of the layer", ratio });
        }
    }
    fn warnings(&self, p: &Params<Self, f64>) -> Vec<Text> {
        self.removed(p).map(|r| r.what).into_iter().collect()
    }
    fn check(&self, p: &Params<Self, f64>) -> Vec<(&'static str, Text)> {
        self.wrong(p)
    }
    fn frequency_domain(&self) -> Option<&dyn erased::FrequencyDomain> {
        Some(self)
    }
    fn replaced_in_time(&self) -> Option<&dyn erased::ReplacedInTime> {
        Some(self)
    }
    fn added_inertia(&self) -> Option<&dyn erased::AddedInertia> {
        Some(self)
    }
    fn filling(&self) -> Option<&dyn erased::Filling> {
        Some(self)
    }
}

impl Filling for Liquid {
    fn density(&self) -> &'static str {
        "density"
    }
    fn damping(&self) -> &'static str {
        "of the liquid's wave: wave_damping"
    }
    fn cavity(&self) -> Option<[&'static str; 3]> {
        Some(["cavity_radius", "free_surface_radius", "cavity_height"])
    }
    fn rigid(&self, p: &Params<Self, f64>) -> Option<[f64; 3]> {
        let Coefficients { full, void, .. } = Self::coefficients(p);
        let (mass, squares) = (full - void, p.cavity_radius.powi(2) + p.free_surface_radius.powi(2));
        (self.fill != Fill::Empty).then_some([mass, 0.5 * mass * squares, mass * (0.25 * squares + p.cavity_height.powi(2) / 12.0)])
    }
}

impl FrequencyDomain for Liquid {
    fn impedance<S: Scalar>(&self, p: &Params<Self, S>, s: Complex<S>, speed: S, out: &mut [Complex<S>]) {
        let forward = self.forward(p, s, speed);
        // the conjugate coordinates see the reaction at -conj w
        let backward = self.forward(p, s.conj(), speed).map(Complex::conj);
        let n = if self.model == Model::Planar { 2 } else { 4 };
        for (i, (f, b)) in forward.into_iter().zip(backward).enumerate().take(n / 2) {
            let (mean, skew) = ((f + b).scale(S::cst(0.5)), (f - b).mul_i().scale(S::cst(0.5)));
            let (x, y) = (2 * i * (n + 1), (2 * i + 1) * n + 2 * i);
            out[x] += mean;
            out[x + 1] += skew;
            out[y] += -skew;
            out[y + 1] += mean;
        }
    }
    fn load<S: Scalar>(&self, p: &Params<Self, S>, _speed: S, b: &mut Blocks<S>) {
        let Coefficients { full, void, .. } = Self::coefficients(p);
        for i in 0..2 {
            b.mass[(i, i)] = full - void;
        }
        self.add_offsets(p, b);
    }
    fn domain(&self, p: &Params<Self, f64>, speed: f64) -> Option<Domain> {
        Some(self.analytic(p, speed))
    }
    fn rough(&self) -> Option<Self> {
        let whole = self.model == Model::Spatial && self.harmonics == Truncation::None;
        whole.then(|| Liquid { harmonics: Truncation::Rough, ..self.clone() })
    }
    fn regular<S: Scalar>(&self, p: &Params<Self, S>, s: Complex<S>, speed: S) -> Complex<S> {
        match self.harmonics {
            Truncation::At(last) if !self.viscous => Self::cavity(p).regular(c(s.im, -s.re), speed, last),
            _ => Complex::one(),
        }
    }
    fn approximation(&self, p: &Params<Self, f64>) -> Option<(Self, Params<Self, f64>)> {
        let plain = Liquid { model: Model::PlanarTilt, viscous: false, harmonics: Truncation::None, ..self.clone() };
        (self.model == Model::Spatial).then_some((plain, LiquidParams { viscosity: 0.0, ..*p }))
    }
}

impl ReplacedInTime for Liquid {
    fn timed(&self, p: &Params<Self, f64>, speeds: Speeds, stop: &dyn Fn() -> bool) -> Option<Result<Self, Untimed>> {
        matches!(self.physics(), Physics::Frequency(_)).then(|| self.for_motions(p, speeds, stop))
    }
    fn fitted(&self) -> Option<Fitted> {
        self.fit()
    }
}

impl AddedInertia for Liquid {
    fn removed(&self, p: &Params<Self, f64>) -> Option<Removed> {
        let (Model::PlanarTilt, Some([a, _])) = (self.model, self.rigid(p)) else { return None };
        (a < 0.0).then(|| Removed {
            what: text!(
                "planar_tilt takes {taken} from the tilt inertia of a cavity as tall as this: strip and spatial do not",
                taken = text::quantity(-a, "kg m^2")
            ),
            help: text!("give model = \"strip\" or \"spatial\"; or the body more diametral_inertia"),
        })
    }
}

#[cfg(test)]
mod tests;

crate::conformance! {
    Liquid {
        partial: tests::partial(), tests::cavity(0.667, 0.0), Options::default();
        thin_damped: tests::partial(), tests::cavity(0.97, 20.0), Options::default();
        full: Liquid::new(Attach::on("drum"), Fill::Full), tests::cavity(0.0, 0.0), Options::default();
        empty: Liquid::new(Attach::on("drum"), Fill::Empty), tests::cavity(1.0, 0.0), Options::default();
        strip: tests::partial().flowing(Model::Strip), tests::cavity(0.667, 20.0), Options::default();
        strip_full: Liquid::new(Attach::on("drum"), Fill::Full).flowing(Model::Strip), tests::cavity(0.0, 0.0), Options::default();
        planar_tilt: tests::partial().flowing(Model::PlanarTilt), tests::cavity(0.667, 20.0), Options::default();
        frozen: tests::partial().flowing(Model::Frozen), tests::cavity(0.667, 0.0), Options::default();
        spatial: tests::partial().flowing(Model::Spatial), tests::cavity(0.667, 0.0), Options { energy: false, ..Options::default() };
        spatial_full: Liquid::new(Attach::on("drum"), Fill::Full).flowing(Model::Spatial), tests::cavity(0.0, 0.0),
            Options { energy: false, ..Options::default() };
        spatial_truncated: tests::partial().flowing(Model::Spatial).truncated(3), tests::cavity(0.667, 0.0),
            Options { energy: false, ..Options::default() };
        offset: tests::partial(), tests::offset(0.0), Options::default();
        offset_full: Liquid::new(Attach::on("drum"), Fill::Full), LiquidParams { free_surface_radius: 0.0, ..tests::offset(0.0) }, Options::default();
        offset_strip: tests::partial().flowing(Model::Strip), tests::offset(0.03), Options::default();
        offset_planar_tilt: tests::partial().flowing(Model::PlanarTilt), tests::offset(0.03), Options::default();
        offset_frozen: tests::partial().flowing(Model::Frozen), tests::offset(0.03), Options::default();
        offset_spatial: tests::partial().flowing(Model::Spatial), tests::offset(0.03), Options { energy: false, ..Options::default() };
        timed: tests::timed(tests::partial(), &tests::cavity(0.667, 0.0)), tests::cavity(0.667, 0.0),
            Options { energy: false, ..Options::default() };
        timed_full: tests::timed(Liquid::new(Attach::on("drum"), Fill::Full), &tests::cavity(0.0, 0.0)), tests::cavity(0.0, 0.0),
            Options { energy: false, ..Options::default() };
        timed_truncated: tests::timed(tests::partial().truncated(3), &tests::cavity(0.667, 0.0)), tests::cavity(0.667, 0.0),
            Options { energy: false, ..Options::default() };
        timed_offset: tests::timed(tests::partial(), &tests::offset(0.0)), tests::offset(0.0), Options { energy: false, ..Options::default() };
        viscous: tests::partial().viscous(), tests::viscous(), Options { energy: false, ..Options::default() };
        viscous_strip: tests::partial().flowing(Model::Strip).viscous(), tests::viscous(), Options { energy: false, ..Options::default() };
        timed_viscous: tests::in_time(tests::partial().viscous()), tests::viscous(), Options { energy: false, ..Options::default() };
        timed_viscous_strip: tests::in_time(tests::partial().flowing(Model::Strip).viscous()), tests::viscous(),
            Options { energy: false, ..Options::default() };
        timed_viscous_spatial: tests::in_time_spatial(), tests::thick(), Options { energy: false, ..Options::default() };
        viscous_spatial: tests::partial().flowing(Model::Spatial).viscous(), tests::viscous(),
            Options { energy: false, states: 4, ..Options::default() };
    }
}
