//! A part: the physics of one piece of the machine, and no analysis.

use super::blocks::Blocks;
use super::field::{Attach, Field, ParamValues, Values};
use super::params::Family;
use super::system::Axis;
use super::timed::{Speeds, Untimed};
use crate::diagnostic::Diagnostics;
use laval_num::complex::Complex;
use laval_num::scalar::Scalar;

/// The parameters of part `P` as numbers of kind `S`.
pub type Params<P, S> = <<P as Part>::Family as Family>::P<S>;

/// How a coordinate turns when the machine is turned about its axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DofKind {
    /// First component of a lateral vector; the next coordinate is its `VectorY`.
    VectorX,
    /// Second component of a lateral vector.
    VectorY,
    /// First component of a tilt (rotation) vector; the next coordinate is its `TiltY`. Turns like a vector.
    TiltX,
    /// Second component of a tilt vector.
    TiltY,
    /// Along the axis: unchanged by turning.
    Axial,
    /// Unchanged by turning: a rotor-relative angle, a pressure.
    Scalar,
}

impl DofKind {
    /// First of a pair that turns together with the coordinate after it.
    pub fn leads_pair(self) -> bool {
        matches!(self, DofKind::VectorX | DofKind::TiltX)
    }
    /// Second of such a pair.
    pub fn ends_pair(self) -> bool {
        matches!(self, DofKind::VectorY | DofKind::TiltY)
    }
}

/// A coordinate or an internal first-order state.
#[derive(Clone, Debug, PartialEq)]
pub struct Dof {
    /// Short name inside its part: `x`, `tilt_x`, `angle`.
    pub name: String,
    /// How it turns.
    pub kind: DofKind,
    /// SI unit.
    pub unit: &'static str,
    /// A typical size in `unit`, for scaling only.
    pub typical: f64,
}

impl Dof {
    /// A coordinate that does not turn.
    pub fn scalar(name: impl Into<String>, unit: &'static str, typical: f64) -> Self {
        Dof { name: name.into(), kind: DofKind::Scalar, unit, typical }
    }
    /// `x` and `y` of a lateral displacement.
    pub fn lateral() -> Vec<Self> {
        Self::pair("", DofKind::VectorX, "m", 1e-3)
    }
    /// `tilt_x` and `tilt_y`: components of the rotation vector.
    pub fn tilt() -> Vec<Self> {
        Self::pair("tilt_", DofKind::TiltX, "rad", 1e-2)
    }
    /// A pair `<prefix>x`, `<prefix>y` that turns; `kind` is the kind of its first component.
    pub fn pair(prefix: &str, kind: DofKind, unit: &'static str, typical: f64) -> Vec<Self> {
        let second = if kind == DofKind::TiltX { DofKind::TiltY } else { DofKind::VectorY };
        [("x", kind), ("y", second)].map(|(c, kind)| Dof { name: format!("{prefix}{c}"), kind, unit, typical }).to_vec()
    }
}

/// What of a body's motion a port sees.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PortKind {
    /// x, y of the point.
    Point,
    /// x, y of the point and the two components of the body's tilt.
    PointAndTilt,
}

impl PortKind {
    /// Number of local coordinates.
    pub fn size(self) -> usize {
        match self {
            PortKind::Point => 2,
            PortKind::PointAndTilt => 4,
        }
    }
}

/// What a port is linked to.
#[derive(Clone, Debug, PartialEq)]
pub enum Link {
    /// The motion of one point.
    On(Attach),
    /// The motion of the first point relative to the second: action and reaction follow by themselves.
    Between(Attach, Attach),
}

/// A port: where a part meets bodies.
#[derive(Clone, Debug, PartialEq)]
pub struct Port {
    /// What it sees.
    pub kind: PortKind,
    /// Of which point or points.
    pub link: Link,
}

/// Local coordinates of a part: the coordinates of its ports in order, then its own; then its internal states.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Layout {
    /// Ports.
    pub ports: Vec<Port>,
    /// Own coordinates.
    pub own: Vec<Dof>,
    /// Internal first-order states. States that the part's blocks list as memory come last.
    pub states: Vec<Dof>,
    /// Other parts may be attached to this one: it implements [`Part::shape`].
    pub body: bool,
}

impl Layout {
    /// Number of local coordinates.
    pub fn coordinates(&self) -> usize {
        self.ports.iter().map(|p| p.kind.size()).sum::<usize>() + self.own.len()
    }
    /// How each local coordinate turns: those of the ports, then its own.
    pub fn kinds(&self) -> Vec<DofKind> {
        use DofKind::{TiltX, TiltY, VectorX, VectorY};
        let ports = self.ports.iter().flat_map(|p| [VectorX, VectorY, TiltX, TiltY].into_iter().take(p.kind.size()));
        ports.chain(self.own.iter().map(|d| d.kind)).collect()
    }
    /// A part on one port that sees x and y.
    pub fn point(link: Link) -> Self {
        Layout { ports: vec![Port { kind: PortKind::Point, link }], ..Self::default() }
    }
    /// A part on one port that sees x, y and tilt.
    pub fn point_and_tilt(link: Link) -> Self {
        Layout { ports: vec![Port { kind: PortKind::PointAndTilt, link }], ..Self::default() }
    }
    /// A body with these coordinates.
    pub fn body(own: Vec<Dof>) -> Self {
        Layout { own, body: true, ..Self::default() }
    }
}

/// What a part sees: local coordinates only.
#[derive(Clone, Copy, Debug)]
pub struct At<'a, S> {
    /// Coordinates.
    pub q: &'a [S],
    /// Their rates.
    pub v: &'a [S],
    /// Their accelerations.
    pub a: &'a [S],
    /// Internal states.
    pub z: &'a [S],
    /// Spin angle, rad.
    pub phase: S,
    /// Spin speed, rad/s.
    pub speed: S,
    /// Spin acceleration, rad/s^2.
    pub spin_accel: S,
    /// Time, s.
    pub t: S,
}

/// Where a part adds its share.
#[derive(Debug)]
pub struct Rows<'a, S> {
    /// Residual of the local coordinates' rows, N or N m: inertia + damping + stiffness - applied.
    pub force: &'a mut [S],
    /// Rates of the internal states, z' (not a residual), per second.
    pub rate: &'a mut [S],
    /// Residual of the spin row, N m: (polar inertia) spin_accel + ... - torque.
    pub spin: &'a mut S,
}

/// Energy of a part and its exchange.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Energy<S> {
    /// Kinetic and potential energy, J.
    pub stored: S,
    /// Power turned into heat, W.
    pub dissipated: S,
    /// Power brought in from outside other than through ports and spin, W.
    pub supplied: S,
}

impl<S: Scalar> Energy<S> {
    /// None.
    pub fn zero() -> Self {
        Energy { stored: S::zero(), dissipated: S::zero(), supplied: S::zero() }
    }
}

/// The form a part's physics is written in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Physics {
    /// [`Part::residual`].
    Nonlinear,
    /// [`Part::linear`], exact at any constant speed.
    Linear,
    /// [`Part::impedance`] is exact; the time form, if any, is [`Part::linear`].
    Frequency(TimeForm),
}

/// Time-domain form of a part that is exact in the frequency domain only.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TimeForm {
    /// There is none, and why.
    None(&'static str),
    /// A rational fit with this relative error.
    Fit(f64),
}

/// A time form in the place of an exact part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fitted {
    /// Its largest relative error.
    pub error: f64,
    /// For which motions that is so, as a phrase: `of motions that ...`.
    pub scope: &'static str,
    /// Growth or decay over the speed from which on it holds.
    pub margin: f64,
    /// Internal states.
    pub states: usize,
}

/// Where in the plane of s the dynamic stiffness of a part in the frequency domain is analytic, and where it is large because the part has waves of its
/// own. Frequencies are those of the forward sector, in fixed axes; the backward sector is the mirror image.
#[derive(Clone, Debug, PartialEq)]
pub struct Domain {
    /// Analytic for Re s < 0 as well as for Re s > 0.
    pub left: bool,
    /// Analytic on the imaginary axis, once multiplied by [`Part::regular`], but for the places in `except`.
    pub axis: bool,
    /// Frequencies, rad/s, at which singularities accumulate.
    pub except: Vec<f64>,
    /// Range of frequencies, rad/s, in which singularities are dense on the imaginary axis: there is no response to a steady load in it.
    pub dense: Option<[f64; 2]>,
    /// Range of frequencies, rad/s, in which the part has many waves that die out at no less than the rate `gap`.
    pub crowded: Option<[f64; 2]>,
    /// Frequencies, rad/s, of single waves that die out at no less than the rate `gap`.
    pub waves: Vec<f64>,
    /// Rate, 1/s: how far the nearest singularity is from the imaginary axis, roughly and not above it.
    pub gap: f64,
    /// Range of frequencies, rad/s, in which the part answers by the few waves of a truncated series where the whole series has no answer.
    pub truncated: Option<[f64; 2]>,
    /// Terms of a series that one evaluation adds up, roughly; limits of work are counted in them.
    pub terms: usize,
    /// The same of what roots are counted with ([`Part::rough`]), at the margin.
    pub rough_terms: usize,
    /// What there is to say of all this.
    pub words: Words,
}

/// A part's own words for where its dynamic stiffness is not analytic.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Words {
    /// What the part is, with an article: `an ideal liquid`.
    pub name: &'static str,
    /// Its waves without number: `inertial waves`.
    pub waves: &'static str,
    /// What of it decides about growth that is too slow to be told from that of its waves.
    pub decides: &'static str,
    /// What gives it an answer at every order, as the beginning of a sentence without its stop.
    pub remedy: &'static str,
    /// What its answer in a truncated range is, as the end of a sentence without its stop.
    pub kept: &'static str,
    /// What takes up energy in it, where something does: `viscosity in the liquid`.
    pub loss: &'static str,
    /// What that means for its stability, a whole sentence with a leading space.
    pub verdict: &'static str,
    /// What dies out at the rates of the branch cut left of the axis.
    pub layer: &'static str,
}

impl Words {
    /// Of a part without words of its own.
    pub const PLAIN: Words = Words {
        name: "a part",
        waves: "waves",
        decides: "damping in the part",
        remedy: "Damping in the part gives it an answer",
        kept: "what is computed there are the few waves kept",
        loss: "damping in the parts",
        verdict: "",
        layer: "what it remembers",
    };
}

impl Domain {
    /// Least growth over the speed from which on roots are counted beside singularities that are dense on the axis.
    pub const MARGIN: f64 = 1e-3;

    /// A singularity may lie on the imaginary axis and is not taken away by [`Part::regular`].
    pub fn touches_axis(&self) -> bool {
        !self.axis || (!self.left && !self.waves.is_empty() && !(self.gap > 0.0))
    }
    /// It has waves that nothing inside it damps: with any damping outside some of them always grow, slowly.
    pub fn undamped(&self) -> bool {
        self.left && (self.dense.is_some() || !self.except.is_empty())
    }
    /// Of a part that only takes up energy: analytic for Re s >= 0.
    pub fn passive() -> Self {
        Domain {
            left: false,
            axis: true,
            except: Vec::new(),
            dense: None,
            crowded: None,
            waves: Vec::new(),
            gap: f64::INFINITY,
            truncated: None,
            terms: 1,
            rough_terms: 1,
            words: Words::PLAIN,
        }
    }
}

/// Which rates a nonlinear residual reads; what it does not read is not differentiated. Checked by the conformance suite.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Uses {
    /// Reads `v`.
    pub velocity: bool,
    /// Reads `a` (its mass may depend on the configuration).
    pub acceleration: bool,
    /// Reads `phase`, `speed`, `spin_accel` or `t`.
    pub spin: bool,
}

/// A quantity to be shown, computed from a part's local state.
#[derive(Clone, Debug, PartialEq)]
pub struct Observed {
    /// Short name, for instance `force`.
    pub name: &'static str,
    /// SI unit.
    pub unit: &'static str,
    /// Value.
    pub value: f64,
}

/// How far a result uses up the validity of a part's model; above 1 it is outside.
#[derive(Clone, Debug, PartialEq)]
pub struct Validity {
    /// What is limited, as a phrase: `surface excursion over layer thickness`.
    pub what: &'static str,
    /// Value over limit.
    pub ratio: f64,
}

/// How a part that is known at some spin speeds only goes on at others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Beyond {
    /// Not at all: a study there is refused.
    Refuse,
    /// As at the end.
    Hold,
    /// Along the tangent at the end.
    Linear,
}

/// The spin speeds at which a part is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tabulated {
    /// First and last speed, rad/s.
    pub from: f64,
    /// See `from`.
    pub to: f64,
    /// Outside.
    pub beyond: Beyond,
    /// The [`Validity`] that states the same of a motion.
    pub statement: &'static str,
}

/// What a part that balances by itself does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Correction {
    /// Moment of its movable masses, in axes that turn with the rotor, kg m.
    pub moment: [f64; 2],
    /// The largest moment they can have, kg m.
    pub capacity: f64,
    /// Largest force (N; of angles N m) with which they push each other; zero where none touch.
    pub contact: f64,
}

/// A circle by which a part with movable masses is drawn: a track, a ball.
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    /// Short name, for instance `ball 1`.
    pub name: String,
    /// Displacement of what carries it, in fixed axes, m: small, drawn enlarged.
    pub displacement: [f64; 2],
    /// Where its centre lies from there, in fixed axes, m: drawn to scale.
    pub place: [f64; 2],
    /// Radius, m.
    pub radius: f64,
    /// A mass that moves, not what it moves in.
    pub movable: bool,
}

/// The physics of one kind of piece.
///
/// A part adds its share to the residual of the machine, written once over [`Scalar`]; see [`Physics`] for the three forms. It is affine in
/// `a` and `spin_accel`. It never sees other parts, positions, or who is asking.
pub trait Part: Send + Sync + Sized + 'static {
    /// The word in the file.
    const KIND: &'static str;
    /// One paragraph for the documentation.
    const DOC: &'static str;
    /// Lines of a typical block beside a body named `drum`, for the documentation; where it is empty they follow from the fields.
    const EXAMPLE: &'static str = "";
    /// Parameters, declared with [`params!`](crate::params).
    type Family: Family;
    /// What the file may say besides the parameters: where it is attached, which law, tables.
    const FIELDS: &'static [Field];

    /// Builds the part from its fields. Says all that is wrong in `diagnostics`; values that parameters depend on (a fill given as a volume)
    /// are written to `params`.
    fn build(values: &Values, params: &mut ParamValues, diagnostics: &mut Diagnostics) -> Option<Self>;
    /// Ports, own coordinates and internal states.
    fn layout(&self) -> Layout;
    /// The form of its physics.
    fn physics(&self) -> Physics;
    /// How many of its states, the last ones, are memory states ([`Blocks::memory`]).
    fn memory(&self) -> usize {
        0
    }
    /// What a nonlinear residual reads.
    fn uses(&self) -> Uses {
        Uses { velocity: true, acceleration: true, spin: true }
    }
    /// Adds its share; only for [`Physics::Nonlinear`].
    fn residual<S: Scalar>(&self, _p: &Params<Self, S>, _at: &At<S>, _out: &mut Rows<S>) {}
    /// The same, and adds to `mass` what the force rows change by per acceleration of each local coordinate (row-major, symmetric). `false` leaves both to
    /// [`residual`](Self::residual), whose differences tell the masses; a part whose mass depends on the configuration saves time by saying it.
    fn inertial<S: Scalar>(&self, _p: &Params<Self, S>, _at: &At<S>, _out: &mut Rows<S>, _mass: &mut [S]) -> bool {
        false
    }
    /// Fills the blocks at a spin speed (rad/s); for [`Physics::Linear`] and for the time form of [`Physics::Frequency`].
    fn linear<S: Scalar>(&self, _p: &Params<Self, S>, _speed: S, _blocks: &mut Blocks<S>) {}
    /// Share in the spin row of a part with linear blocks, N m: `inertia spin_accel + ... - torque`.
    fn spin_row<S: Scalar>(&self, _p: &Params<Self, S>, _at: &At<S>) -> S {
        S::zero()
    }
    /// Loads of a part in the frequency domain: forces, constant and turning with the rotor, as [`Part::linear`] has them, and in `mass` what weight
    /// sees; only for [`Physics::Frequency`].
    fn load<S: Scalar>(&self, _p: &Params<Self, S>, _speed: S, _blocks: &mut Blocks<S>) {}
    /// Adds the dynamic stiffness (N/m, row-major over local coordinates) at `s` (1/s) and spin `speed`; only for [`Physics::Frequency`].
    /// `Z(conj s) = conj Z(s)`.
    fn impedance<S: Scalar>(&self, _p: &Params<Self, S>, _s: Complex<S>, _speed: S, _out: &mut [Complex<S>]) {}
    /// Of a part in the frequency domain without time form: the same part with a rational one for motions at such speeds, as linear blocks, or why there is none for
    /// them. It stands for the part in motions only, never in spectra. Where making it takes long, `stop` is asked now and then; nothing is remembered of a form that was given up.
    fn timed(&self, _p: &Params<Self, f64>, _speeds: Speeds, _stop: &dyn Fn() -> bool) -> Option<Result<Self, Untimed>> {
        None
    }
    /// Of such a time form.
    fn fitted(&self) -> Option<Fitted> {
        None
    }
    /// Where the dynamic stiffness of a part in the frequency domain is analytic, at a spin speed: what a count of roots rests on. Nothing is counted with a part that
    /// does not say it.
    fn domain(&self, _p: &Params<Self, f64>, _speed: f64) -> Option<Domain> {
        None
    }
    /// The same part with its dynamic stiffness to six digits only, where that costs less, above all at `Re s =` [`Domain::MARGIN`] times the speed; differentiated by s
    /// alone. Roots are counted with it; those found are solved for on the part itself.
    fn rough(&self) -> Option<Self> {
        None
    }
    /// An analytic function of s, up to a positive factor, whose zeros are the poles that [`Part::domain`] does not name, in the forward sector; 1 where there are none.
    fn regular<S: Scalar>(&self, _p: &Params<Self, S>, _s: Complex<S>, _speed: S) -> Complex<S> {
        Complex::one()
    }
    /// Energy and power; `None` when the part keeps no account.
    fn energy<S: Scalar>(&self, _p: &Params<Self, S>, _at: &At<S>) -> Option<Energy<S>> {
        None
    }
    /// Rows of the map from this body's coordinates to x, y, tilt_x, tilt_y of its point at `position` (m): 4 rows of `own` entries.
    fn shape(&self, _p: &Params<Self, f64>, _position: f64) -> Vec<[f64; 4]> {
        Vec::new()
    }
    /// How far an open gap is from contact at a state, m; negative in contact. `None` for a part without a gap.
    fn clearance(&self, _p: &Params<Self, f64>, _at: &At<f64>) -> Option<f64> {
        None
    }
    /// Why the part cannot be linearised where it carries no load, as a sentence that asks for what is missing. A part with an open
    /// [`clearance`](Self::clearance) is linearised nevertheless where others hold what it joins.
    fn refuses_rest(&self, _p: &Params<Self, f64>) -> Option<String> {
        None
    }
    /// Surfaces in the state where the law changes: zero on the surface.
    fn switches<S: Scalar>(&self, _p: &Params<Self, S>, _at: &At<S>, _out: &mut Vec<S>) {}
    /// Quantities worth showing.
    fn observe(&self, _p: &Params<Self, f64>, _at: &At<f64>, _out: &mut Vec<Observed>) {}
    /// Use of the model's validity.
    fn validity(&self, _p: &Params<Self, f64>, _at: &At<f64>, _out: &mut Vec<Validity>) {}
    /// The spin speeds at which it is known, of a part that is given in a table over them.
    fn tabulated(&self) -> Option<Tabulated> {
        None
    }
    /// Why it does not fit a machine with this axis, and what to change.
    fn refuses_axis(&self, _p: &Params<Self, f64>, _axis: Axis) -> Option<String> {
        None
    }
    /// A form of the part with few roots where it has roots without number, and the parameters of that form, to be compared with.
    fn approximation(&self, _p: &Params<Self, f64>) -> Option<(Self, Params<Self, f64>)> {
        None
    }
    /// What inertia the part takes away from its body, as a sentence without a point; the machine is refused where too little is left.
    fn lightens(&self, _p: &Params<Self, f64>) -> Option<String> {
        None
    }
    /// What keeps the part from doing what it is there for, although its model is right: sentences that begin with a small letter and end without a point.
    fn warnings(&self, _p: &Params<Self, f64>) -> Vec<String> {
        Vec::new()
    }
    /// Torque with which a drive moves the spin at a speed, N m; `None` for a part that is no drive, whatever power it supplies.
    fn drives(&self, _p: &Params<Self, f64>, _speed: f64) -> Option<f64> {
        None
    }
    /// Of a part that spins with the rotor and has mass: the parameter for its inertia about the axis, while that is 0.
    fn lacks_spin_inertia(&self, _p: &Params<Self, f64>) -> Option<&'static str> {
        None
    }
    /// Of a body that does not tilt and could: the parameter that lets it.
    fn without_tilt(&self) -> Option<&'static str> {
        None
    }
    /// Where own coordinates are when a motion begins and nothing is said of them: local coordinate and value; others rest.
    fn places(&self, _p: &Params<Self, f64>) -> Vec<(usize, f64)> {
        Vec::new()
    }
    /// Dry friction on own coordinates that rest: local coordinate, and the largest force (N; of an angle N m) that it holds.
    fn grip(&self, _p: &Params<Self, f64>, _at: &At<f64>, _out: &mut Vec<(usize, f64)>) {}
    /// Of a part that balances by itself.
    fn correction(&self, _p: &Params<Self, f64>, _at: &At<f64>) -> Option<Correction> {
        None
    }
    /// What a part with movable masses looks like, seen along the axis.
    fn outlines(&self, _p: &Params<Self, f64>, _at: &At<f64>) -> Vec<Outline> {
        Vec::new()
    }
    /// Relations between parameters that bounds cannot say (a free surface inside its cavity). Says what is wrong and which parameter.
    fn check(&self, _p: &Params<Self, f64>) -> Vec<(&'static str, String)> {
        Vec::new()
    }
}
