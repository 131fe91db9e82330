//! Motions to be played: circles whose places are columns of a table.

use super::message::{Arg, Message};
use super::{Data, OutcomeError, Table};
use serde::{Deserialize, Serialize};

/// Circles that move as the rows of a table say. Places are in axes that turn with the rotor, so that they change slowly; the spin angle turns them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Animation {
    /// Machine name.
    pub name: String,
    /// Title for reading.
    pub title: Arg,
    /// What a reader who cannot see it should know.
    pub alt: Message,
    /// Table whose rows are the frames.
    pub table: String,
    /// Column of the time, s.
    pub time: String,
    /// Column of the spin angle, not wrapped, rad.
    pub phase: String,
    /// Times by which displacements are enlarged beside places.
    pub enlarged: f64,
    /// What moves.
    pub circles: Vec<Circle>,
}

/// A circle that moves.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Circle {
    /// Its name.
    pub name: Arg,
    /// Columns of its displacement, m: drawn enlarged.
    pub displacement: [String; 2],
    /// Columns of its place from there, m: drawn to scale; none where it is not displaced from there.
    pub place: Option<[String; 2]>,
    /// Radius, m; zero for the centre of a body, which is drawn as a point with the key mark of the rotor.
    pub radius: f64,
    /// A mass that moves, not what it moves in.
    pub movable: bool,
}

impl Animation {
    /// Whether all its columns exist and hold numbers.
    ///
    /// # Errors
    /// The first one that does not.
    pub fn check(&self, tables: &[Table]) -> Result<(), OutcomeError> {
        let wrong = |column: &str, expected| OutcomeError::Reference {
            figure: self.name.clone(),
            table: self.table.clone(),
            column: column.into(),
            expected,
        };
        let table = tables.iter().find(|t| t.name() == self.table).ok_or_else(|| wrong("", "a table"))?;
        let circles = self.circles.iter().flat_map(|c| c.displacement.iter().chain(c.place.iter().flatten()));
        for column in [&self.time, &self.phase].into_iter().chain(circles) {
            let fits = table.column(column).is_some_and(|c| matches!(c.data, Data::Float(_)));
            fits.then_some(()).ok_or_else(|| wrong(column, "a column of numbers"))?;
        }
        Ok(())
    }
}
