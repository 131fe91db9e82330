//! What a part says of itself and what it is given: coordinates, ports, the local state and where it adds its share.

use super::field::Attach;
use laval_num::scalar::Scalar;
use serde::{Deserialize, Serialize};

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
    /// Rotation about the axis relative to the spin: unchanged by turning.
    Twist,
    /// Unchanged by turning: a rotor-relative angle, a pressure.
    Scalar,
}

impl DofKind {
    /// Number of [classes](Self::class).
    pub const CLASSES: usize = 5;
    /// Kinds that compare with each other: displacements, tilts, displacements along the axis, rotations about it, others.
    pub fn class(self) -> usize {
        match self {
            DofKind::VectorX | DofKind::VectorY => 0,
            DofKind::TiltX | DofKind::TiltY => 1,
            DofKind::Axial => 2,
            DofKind::Twist => 3,
            DofKind::Scalar => 4,
        }
    }
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
    /// `axial`: displacement along the axis, upwards.
    pub fn axial() -> Self {
        Dof { name: "axial".into(), kind: DofKind::Axial, unit: "m", typical: 1e-3 }
    }
    /// `twist`: rotation about the axis relative to the spin.
    pub fn twist() -> Self {
        Dof { name: "twist".into(), kind: DofKind::Twist, unit: "rad", typical: 1e-2 }
    }
    /// A pair `<prefix>x`, `<prefix>y` that turns; `kind` is the kind of its first component.
    pub fn pair(prefix: &str, kind: DofKind, unit: &'static str, typical: f64) -> Vec<Self> {
        let second = if kind == DofKind::TiltX { DofKind::TiltY } else { DofKind::VectorY };
        [("x", kind), ("y", second)].map(|(c, kind)| Dof { name: format!("{prefix}{c}"), kind, unit, typical }).to_vec()
    }
}

/// Components of the motion of a point of a body, in this order: x, y, the two of the tilt, axial, twist.
pub const COMPONENTS: [DofKind; 6] = [DofKind::VectorX, DofKind::VectorY, DofKind::TiltX, DofKind::TiltY, DofKind::Axial, DofKind::Twist];

/// Which components of a body's motion a port sees; its local coordinates are these in the order of [`COMPONENTS`]. A component that the body does not have
/// is zero.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PortKind {
    /// x and y of the point.
    pub lateral: bool,
    /// Both components of the tilt.
    pub tilt: bool,
    /// Displacement along the axis.
    pub axial: bool,
    /// Rotation about the axis relative to the spin.
    pub twist: bool,
}

impl PortKind {
    /// x, y of the point.
    pub const POINT: Self = PortKind { lateral: true, tilt: false, axial: false, twist: false };
    /// x, y of the point and the two components of the body's tilt.
    pub const POINT_AND_TILT: Self = PortKind { tilt: true, ..Self::POINT };
    /// All six.
    pub const ALL: Self = PortKind { lateral: true, tilt: true, axial: true, twist: true };

    /// Indices of its components among [`COMPONENTS`].
    pub fn components(self) -> impl Iterator<Item = usize> {
        let sees = [self.lateral, self.lateral, self.tilt, self.tilt, self.axial, self.twist];
        (0..sees.len()).filter(move |&i| sees[i])
    }
    /// Their kinds.
    pub fn kinds(self) -> impl Iterator<Item = DofKind> {
        self.components().map(|i| COMPONENTS[i])
    }
    /// Number of local coordinates.
    pub fn size(self) -> usize {
        self.components().count()
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

impl Link {
    /// The points.
    pub fn ends(&self) -> impl Iterator<Item = &Attach> {
        let (first, second) = match self {
            Link::On(a) => (a, None),
            Link::Between(a, b) => (a, Some(b)),
        };
        std::iter::once(first).chain(second)
    }
    /// Names of the bodies.
    pub fn bodies(&self) -> impl Iterator<Item = &str> {
        self.ends().filter_map(|a| a.body.as_deref())
    }
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
    /// Other parts may be attached to this one: it has [`Part::body`](super::part::Part::body).
    pub body: bool,
    /// The part that gives the ratio of its spin to that of the machine ([`Scope::spin_ratio`](super::capability::Scope::spin_ratio)). A part without one turns as the
    /// first turning body does that it is attached to.
    pub spin: Option<String>,
}

impl Layout {
    /// Number of local coordinates.
    pub fn coordinates(&self) -> usize {
        self.ports.iter().map(|p| p.kind.size()).sum::<usize>() + self.own.len()
    }
    /// How each local coordinate turns: those of the ports, then its own.
    pub fn kinds(&self) -> Vec<DofKind> {
        self.ports.iter().flat_map(|p| p.kind.kinds()).chain(self.own.iter().map(|d| d.kind)).collect()
    }
    /// A part on one port.
    pub fn on(kind: PortKind, link: Link) -> Self {
        Layout { ports: vec![Port { kind, link }], ..Self::default() }
    }
    /// A part on one port that sees x and y.
    pub fn point(link: Link) -> Self {
        Self::on(PortKind::POINT, link)
    }
    /// A part on one port that sees x, y and tilt.
    pub fn point_and_tilt(link: Link) -> Self {
        Self::on(PortKind::POINT_AND_TILT, link)
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
    /// [`Part::residual`](super::part::Part::residual).
    Nonlinear,
    /// [`Part::linear`](super::part::Part::linear), exact at any constant speed.
    Linear,
    /// [`impedance`](super::capability::FrequencyDomain::impedance) is exact; the time form, if any, is [`Part::linear`](super::part::Part::linear).
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
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Observed {
    /// Short name, for instance `force`.
    #[serde(deserialize_with = "laval_num::text::one")]
    pub name: laval_num::text::Text,
    /// SI unit.
    #[serde(deserialize_with = "laval_num::text::one")]
    pub unit: laval_num::text::Text,
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
    /// Name of the eccentricity of a journal in a film, over its clearance.
    pub const ECCENTRICITY: &'static str = "eccentricity over clearance";
    /// Name of the least thickness of a film, m.
    pub const FILM: &'static str = "least film thickness";
    /// Name of a torque against the spin, N m.
    pub const TORQUE: &'static str = "torque";

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
