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
