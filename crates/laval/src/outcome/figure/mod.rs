//! Figures: declarative marks over table columns. A figure is a column of panels that share x.

mod axis;
mod bands;
mod curves;
mod maps;
mod points;
mod rules;

pub use axis::{Axis, Scale, parameter_name};
pub use bands::{Band, BandPlace};
pub use curves::Line;
pub use maps::Heat;
pub use points::Points;
pub use rules::{Rule, Text};

use super::message::{Arg, Message};
use super::tiles::Tiles;
use super::{Data, OutcomeError, Table};
use serde::{Deserialize, Serialize};

/// A figure: panels, one below the other, sharing the x axis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Figure {
    /// Machine name, also part of the file name.
    pub name: String,
    /// Title for reading.
    pub title: Arg,
    /// What a reader who cannot see the figure should know.
    pub alt: Message,
    /// The common x axis.
    pub x: Axis,
    /// The panels from top to bottom.
    pub panels: Vec<Panel>,
    /// A length along x is as long along y: for orbits, which would not be round otherwise. Both axes have the same unit.
    pub equal: bool,
    /// Small pictures side by side, in place of panels.
    pub tiles: Option<Tiles>,
}

/// One panel: a y axis and marks, drawn in order (heat maps and bands always lie below).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Panel {
    /// The y axis.
    pub y: Axis,
    /// What is drawn.
    pub marks: Vec<Mark>,
    /// Height over that of the other panels.
    pub height: f64,
}

/// One layer of a panel.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Mark {
    /// Curve.
    Line(Line),
    /// Markers.
    Points(Points),
    /// Shaded interval.
    Band(Band),
    /// Straight line across the panel.
    Rule(Rule),
    /// Heat map.
    Heat(Heat),
    /// Words at a place.
    Text(Text),
}

macro_rules! into_mark {
    ($($kind:ident),*) => { $(impl From<$kind> for Mark { fn from(m: $kind) -> Mark { Mark::$kind(m) } })* };
}
into_mark!(Line, Points, Band, Rule, Heat, Text);

impl Panel {
    /// An empty panel.
    pub fn new(y: Axis) -> Self {
        Panel { y, marks: Vec::new(), height: 1.0 }
    }

    /// So many times as high as others.
    pub fn height(mut self, height: f64) -> Self {
        self.height = height;
        self
    }

    /// Adds a mark.
    pub fn mark(mut self, mark: impl Into<Mark>) -> Self {
        self.marks.push(mark.into());
        self
    }
}

impl Figure {
    /// A figure without panels. `alt` tells what it shows to a reader who cannot see it.
    pub fn new(name: impl Into<String>, title: impl Into<Arg>, alt: impl Into<Message>) -> Self {
        Figure {
            name: name.into(),
            title: title.into(),
            alt: alt.into(),
            x: Axis::new("", ""),
            panels: Vec::new(),
            equal: false,
            tiles: None,
        }
    }

    /// Draws x and y to one scale.
    pub fn equal(mut self) -> Self {
        self.equal = true;
        self
    }

    /// Draws small pictures side by side, in place of panels.
    pub fn tiles(mut self, tiles: Tiles) -> Self {
        self.tiles = Some(tiles);
        self
    }

    /// Sets the x axis.
    pub fn x(mut self, axis: Axis) -> Self {
        self.x = axis;
        self
    }

    /// Adds a panel below the others.
    pub fn panel(mut self, panel: Panel) -> Self {
        self.panels.push(panel);
        self
    }

    /// Whether there is anything to see: a place of a curve, a marker, a cell or a band. Rules and reference lines alone are no figure.
    pub fn shows(&self, tables: &[Table]) -> bool {
        let visible = |panel: &Panel, mark: &Mark| {
            let (table, x, y) = match mark {
                // modes without a legend are drawn like reference lines
                Mark::Line(m) if !m.reference || m.group.is_some() => (&m.table, &m.x, &m.y),
                Mark::Points(m) => (&m.table, &m.x, &m.y),
                Mark::Heat(m) => (&m.table, &m.x, &m.y),
                Mark::Band(_) => return true,
                Mark::Line(_) | Mark::Rule(_) | Mark::Text(_) => return false,
            };
            let Some(table) = tables.iter().find(|t| t.name() == table) else { return false };
            let (Some(x), Some(y)) = (table.column(x), table.column(y)) else { return false };
            let fits = |v: Option<f64>, scale: Scale| v.is_some_and(|v| v.is_finite() && (scale == Scale::Linear || v > 0.0));
            (0..table.rows()).any(|i| fits(x.number(i), self.x.scale) && fits(y.number(i), panel.y.scale))
        };
        let pictures = self.tiles.as_ref().is_some_and(|t| !t.pictures.is_empty());
        pictures || self.panels.iter().any(|p| p.marks.iter().any(|m| visible(p, m)))
    }

    /// Whether every mark names columns that exist and have a fitting type.
    ///
    /// # Errors
    /// The first one that does not.
    pub fn check(&self, tables: &[Table]) -> Result<(), OutcomeError> {
        if let Some(tiles) = &self.tiles {
            tiles.check(&self.name, tables)?;
        }
        for mark in self.panels.iter().flat_map(|p| &p.marks) {
            let (table, numbers, group, flags): (&str, Vec<&str>, Option<&String>, Vec<&String>) = match mark {
                Mark::Line(m) => {
                    let group = m.group.as_ref().or(m.class.as_ref());
                    let flags = [&m.solid_where, &m.begins_where, &m.valid_where];
                    (&m.table, vec![&m.x, &m.y], group, flags.into_iter().flatten().collect())
                }
                Mark::Points(m) => (&m.table, vec![&m.x, &m.y], m.group.as_ref(), m.filled_where.iter().collect()),
                Mark::Heat(m) if m.classes.is_empty() => (&m.table, vec![&m.x, &m.y, &m.value], None, vec![]),
                Mark::Heat(m) => (&m.table, vec![&m.x, &m.y], Some(&m.value), vec![]),
                Mark::Band(Band { place: BandPlace::Between(t, x, low, high) | BandPlace::Across(t, x, low, high), .. }) => {
                    (t, vec![x, low, high], None, vec![])
                }
                Mark::Band(_) | Mark::Rule(_) | Mark::Text(_) => continue,
            };
            let wrong = |column: &str, expected| OutcomeError::Reference {
                figure: self.name.clone(),
                table: table.into(),
                column: column.into(),
                expected,
            };
            let found = tables.iter().find(|t| t.name() == table).ok_or_else(|| wrong("", "a table"))?;
            for column in numbers {
                let fits = found.column(column).is_some_and(|c| matches!(c.data, Data::Float(_) | Data::Int(_)));
                fits.then_some(()).ok_or_else(|| wrong(column, "a column of numbers"))?;
            }
            if let Some(column) = group {
                found.column(column).ok_or_else(|| wrong(column, "a column"))?;
            }
            for column in flags {
                let fits = found.column(column).is_some_and(|c| matches!(c.data, Data::Flag(_)));
                fits.then_some(()).ok_or_else(|| wrong(column, "a column of flags"))?;
            }
        }
        Ok(())
    }
}
