//! A part: the physics of one piece of the machine, and no analysis.

use super::blocks::Blocks;
use super::erased;
use super::field::{Attach, Field, ParamValues, Values};
use super::params::Family;
use crate::diagnostic::Diagnostics;
use laval_num::scalar::Scalar;

pub use super::capability::frequency::{Domain, Words};
pub use super::capability::movable::{Correction, Outline};
pub use super::capability::scope::{Beyond, Tabulated};
pub use super::capability::time_form::Fitted;

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
    /// Other parts may be attached to this one: it has [`Part::body`].
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
    /// [`impedance`](super::capability::FrequencyDomain::impedance) is exact; the time form, if any, is [`Part::linear`].
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

impl Observed {
    /// Name of the displacement of a body, m.
    pub const DISPLACEMENT: &'static str = "displacement";
    /// Name of the tilt of a body, rad.
    pub const TILT: &'static str = "tilt";
    /// Name of a moment across the axis, N m.
    pub const MOMENT: &'static str = "moment";

    /// A displacement or tilt of a body, which analyses list by body.
    pub fn is_motion_of_body(&self) -> bool {
        [Self::DISPLACEMENT, Self::TILT].contains(&self.name)
    }
}

/// How far a result uses up the validity of a part's model; above 1 it is outside.
#[derive(Clone, Debug, PartialEq)]
pub struct Validity {
    /// What is limited, as a phrase: `surface excursion over layer thickness`.
    pub what: &'static str,
    /// Value over limit.
    pub ratio: f64,
}

/// The physics of one kind of piece.
///
/// A part adds its share to the residual of the machine, written once over [`Scalar`]; see [`Physics`] for the three forms. It is affine in
/// `a` and `spin_accel`. It never sees other parts, positions or analyses.
///
/// The methods down to [`warnings`](Self::warnings) are the part. Those after it declare a [capability](super::capability): a part that
/// implements the trait returns `Some(self)`.
pub trait Part: Send + Sync + Sized + 'static {
    /// The word in the file.
    const KIND: &'static str;
    /// One paragraph for the documentation.
    const DOC: &'static str;
    /// Lines of a typical block beside a body named `drum`, for the documentation; where it is empty they follow from the fields.
    const EXAMPLE: &'static str = "";
    /// Parameters, declared with [`params!`](crate::params).
    type Family: Family;
    /// What the file may say besides the parameters: where it is attached, which force law, tables.
    const FIELDS: &'static [Field];

    /// Builds the part from its fields and reports every mistake in `diagnostics`; values that parameters depend on
    /// (given in another form) are written to `params`.
    fn build(values: &Values, params: &mut ParamValues, diagnostics: &mut Diagnostics) -> Option<Self>;
    /// Relations between parameters that bounds cannot express: the parameter and the mistake.
    fn check(&self, _p: &Params<Self, f64>) -> Vec<(&'static str, String)> {
        Vec::new()
    }
    /// Ports, own coordinates and internal states.
    fn layout(&self) -> Layout;
    /// The form of its physics.
    fn physics(&self) -> Physics;
    /// What a nonlinear residual reads.
    fn uses(&self) -> Uses {
        Uses { velocity: true, acceleration: true, spin: true }
    }
    /// How many of its states, the last ones, are memory states ([`Blocks::memory`]).
    fn memory(&self) -> usize {
        0
    }
    /// Adds its share; only for [`Physics::Nonlinear`].
    fn residual<S: Scalar>(&self, _p: &Params<Self, S>, _at: &At<S>, _out: &mut Rows<S>) {}
    /// Fills the blocks at a spin speed (rad/s); for [`Physics::Linear`] and for the time form of [`Physics::Frequency`].
    fn linear<S: Scalar>(&self, _p: &Params<Self, S>, _speed: S, _blocks: &mut Blocks<S>) {}
    /// Share in the spin row of a part with linear blocks, N m: `inertia spin_accel + ... - torque`.
    fn spin_row<S: Scalar>(&self, _p: &Params<Self, S>, _at: &At<S>) -> S {
        S::zero()
    }
    /// Energy and power; `None` when the part keeps no account.
    fn energy<S: Scalar>(&self, _p: &Params<Self, S>, _at: &At<S>) -> Option<Energy<S>> {
        None
    }
    /// Quantities worth showing.
    fn observe(&self, _p: &Params<Self, f64>, _at: &At<f64>, _out: &mut Vec<Observed>) {}
    /// Use of the model's validity.
    fn validity(&self, _p: &Params<Self, f64>, _at: &At<f64>, _out: &mut Vec<Validity>) {}
    /// Why the part does not serve its purpose although its model is right: sentences that begin with a small letter and end without a stop.
    fn warnings(&self, _p: &Params<Self, f64>) -> Vec<String> {
        Vec::new()
    }

    /// Other parts attach to it: [`BodyPart`](super::capability::BodyPart).
    fn body(&self) -> Option<&dyn erased::BodyPart> {
        None
    }
    /// Gaps and force laws that are not smooth: [`Contacts`](super::capability::Contacts).
    fn contacts(&self) -> Option<&dyn erased::Contacts> {
        None
    }
    /// Masses that move in the rotor: [`MovableMasses`](super::capability::MovableMasses).
    fn movable_masses(&self) -> Option<&dyn erased::MovableMasses> {
        None
    }
    /// A mass matrix of its own that varies with the configuration: [`VaryingInertia`](super::capability::VaryingInertia).
    fn varying_inertia(&self) -> Option<&dyn erased::VaryingInertia> {
        None
    }
    /// Negative added inertia: [`AddedInertia`](super::capability::AddedInertia).
    fn added_inertia(&self) -> Option<&dyn erased::AddedInertia> {
        None
    }
    /// Exact dynamic stiffness and where it is analytic: [`FrequencyDomain`](super::capability::FrequencyDomain).
    fn frequency_domain(&self) -> Option<&dyn erased::FrequencyDomain> {
        None
    }
    /// Another part takes its place in motions: [`ReplacedInTime`](super::capability::ReplacedInTime).
    fn replaced_in_time(&self) -> Option<&dyn erased::ReplacedInTime> {
        None
    }
    /// It drives the spin: [`SpinDrive`](super::capability::SpinDrive).
    fn spin_drive(&self) -> Option<&dyn erased::SpinDrive> {
        None
    }
    /// It is a liquid in a cavity: [`Filling`](super::capability::Filling).
    fn filling(&self) -> Option<&dyn erased::Filling> {
        None
    }
    /// It does not serve every machine or every speed: [`Scope`](super::capability::Scope).
    fn scope(&self) -> Option<&dyn erased::Scope> {
        None
    }
}
