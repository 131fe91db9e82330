//! Small pictures side by side of how the points of a machine move: one for each mode, for each speed, for each point.

use super::message::Arg;
use super::{Data, OutcomeError, Table};
use serde::{Deserialize, Serialize};

/// Pictures drawn from a table with a row for each point of each picture. The motion of a point is `x + i y = f exp(i a) + b exp(-i a)` over an angle a: a phase
/// reference mark of a response, any instant of a mode is at a = 0.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Tiles {
    /// The table.
    pub table: String,
    /// Column of whole numbers: the picture to which a row belongs.
    pub picture: String,
    /// What the pictures show.
    pub view: View,
    /// The pictures in their order.
    pub pictures: Vec<Picture>,
    /// What the point on every orbit means.
    pub mark: Arg,
    /// Remarks below the pictures.
    pub notes: Vec<Arg>,
}

/// What pictures show.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum View {
    /// Orbits seen along the axis.
    Orbits,
    /// The line through the points in space, with their orbits, and along the axis.
    Shapes {
        /// The axis of the machine lies.
        horizontal: bool,
        /// Places are distances.
        to_scale: bool,
    },
}

/// One picture.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Picture {
    /// Value of its rows in the column that tells pictures apart.
    pub number: i64,
    /// Its title.
    pub title: Arg,
    /// Lines of text.
    pub lines: Vec<Arg>,
    /// A circle that limits the motion, in the unit of the table.
    pub circle: Option<Limit>,
    /// It shows an instability.
    pub unstable: bool,
}

/// A circle that a motion must not cross.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Limit {
    /// Its radius.
    pub radius: f64,
    /// Its centre from that of the orbit: not zero of a machine that sags.
    pub centre: [f64; 2],
}

impl Tiles {
    /// Column of the name of the body.
    pub const BODY: &'static str = "body";
    /// Column of the height above the reference point of the body.
    pub const HEIGHT: &'static str = "height";
    /// Column of the place along the axis.
    pub const PLACE: &'static str = "place";
    /// Columns of the distance of the axis of the body from that of the first, along x and y; absent where all bodies have one axis.
    pub const AXIS: [&'static str; 2] = ["axis_x", "axis_y"];
    /// Column of the line that joins points.
    pub const LINE: &'static str = "line";
    /// Flag column of points that have an orbit to draw; others only guide the line.
    pub const NAMED: &'static str = "named";
    /// Columns of the amplitudes and of their angles.
    pub const FORWARD: &'static str = "forward";
    /// Angle of the forward amplitude.
    pub const FORWARD_PHASE: &'static str = "forward_phase";
    /// Backward amplitude.
    pub const BACKWARD: &'static str = "backward";
    /// Angle of the backward amplitude.
    pub const BACKWARD_PHASE: &'static str = "backward_phase";

    /// Whether all its columns exist and have a fitting type.
    ///
    /// # Errors
    /// The first one that does not.
    pub fn check(&self, figure: &str, tables: &[Table]) -> Result<(), OutcomeError> {
        let wrong = |column: &str, expected| OutcomeError::Reference {
            figure: figure.into(),
            table: self.table.clone(),
            column: column.into(),
            expected,
        };
        let table = tables.iter().find(|t| t.name() == self.table).ok_or_else(|| wrong("", "a table"))?;
        let fits = |column: &str, expected, kind: fn(&Data) -> bool| {
            table.column(column).is_some_and(|c| kind(&c.data)).then_some(()).ok_or_else(|| wrong(column, expected))
        };
        let whole = [self.picture.as_str(), Tiles::LINE];
        let numbers = [Tiles::HEIGHT, Tiles::PLACE, Tiles::FORWARD, Tiles::FORWARD_PHASE, Tiles::BACKWARD, Tiles::BACKWARD_PHASE];
        whole.into_iter().try_for_each(|c| fits(c, "a column of whole numbers", |d| matches!(d, Data::Int(_))))?;
        numbers.into_iter().try_for_each(|c| fits(c, "a column of numbers", |d| matches!(d, Data::Float(_))))?;
        fits(Tiles::NAMED, "a column of flags", |d| matches!(d, Data::Flag(_)))?;
        fits(Tiles::BODY, "a column of names", |d| matches!(d, Data::Text(_)))
    }
}
