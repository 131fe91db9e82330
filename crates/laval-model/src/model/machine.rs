//! Data of a machine as a whole: name, speed, axis, drive.

use super::capability::scope::Axis;
use super::field::Extra;

/// Standard gravity, m/s^2.
pub const GRAVITY: f64 = 9.80665;

/// How the spin angle moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Drive {
    /// A programme: the spin row is not solved, it gives the torque needed.
    #[default]
    Prescribed,
    /// The spin angle is a coordinate.
    Free,
}

/// Data of the machine as a whole.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Machine {
    /// Name.
    pub name: String,
    /// Spin speed for studies that name none, rad/s.
    pub speed: Option<f64>,
    /// The spin that its speed is that of, by the name of the part that gives its ratio; the first spin where there is none.
    pub spin: Option<String>,
    /// Direction of the shaft.
    pub axis: Axis,
    /// Drive.
    pub drive: Drive,
    /// Blocks beside the parts that studies read: cups, suspension, limits.
    pub extras: Vec<Extra>,
    /// Points of bodies that such blocks name: body and height above its reference point, m.
    pub points: Vec<(String, f64)>,
}
