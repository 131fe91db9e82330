//! Figures: declarative marks over table columns. A figure is a column of panels that share x.

use super::kept;
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

/// Scale of an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Scale {
    /// Equal steps.
    Linear,
    /// Equal ratios; values that are not positive are left out.
    Log,
}

/// An axis. Every value along it (columns and constants alike) is multiplied by `factor` before it is drawn, so that tables
/// and marks stay in SI units while the axis shows `rpm` or `µm`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Axis {
    /// Label, such as `speed`.
    pub label: Arg,
    /// Unit after the factor.
    pub unit: String,
    /// Linear or logarithmic.
    pub scale: Scale,
    /// Factor from the values of the table to the unit of the axis.
    pub factor: f64,
    /// Range to show, in the unit of the axis; from the data when absent.
    pub range: Option<(f64, f64)>,
    /// Without numbers: places along it only have names.
    pub bare: bool,
    /// Names that stand at places of the axis, in its unit, instead of numbers.
    pub names: Vec<(f64, Arg)>,
    /// Linear nearer to zero than this, logarithmic on both sides beyond: for values of both signs and of many sizes.
    pub knee: Option<f64>,
}

impl Axis {
    /// A linear axis.
    pub fn new(label: impl Into<Arg>, unit: impl Into<String>) -> Self {
        Axis {
            label: label.into(),
            unit: unit.into(),
            scale: Scale::Linear,
            factor: 1.0,
            range: None,
            bare: false,
            names: Vec::new(),
            knee: None,
        }
    }

    /// A logarithmic axis.
    pub fn log(label: impl Into<Arg>, unit: impl Into<String>) -> Self {
        Axis { scale: Scale::Log, ..Axis::new(label, unit) }
    }

    /// Factor from the values of the table to the unit of the axis: `1e6` from m to µm.
    pub fn factor(mut self, factor: f64) -> Self {
        self.factor = factor;
        self
    }

    /// For values in m that reach to `most`: in mm, or in µm where that is small.
    pub fn metres(self, most: f64) -> Self {
        let (unit, factor) = if most >= 1e-3 { ("mm", 1e3) } else { ("µm", 1e6) };
        Axis { unit: unit.into(), factor, ..self }
    }

    /// Of the parameter at a path: `radius of oil` for `oil.radius`; metres in mm.
    pub fn parameter(path: &str, unit: &str) -> Self {
        let axis = Axis::new(parameter_name(path), unit);
        if unit == "m" { Axis { unit: "mm".into(), factor: 1e3, ..axis } } else { axis }
    }

    /// Names at places, in the unit of the axis, instead of numbers.
    pub fn names(mut self, names: Vec<(f64, Arg)>) -> Self {
        self.names = names;
        self
    }

    /// Linear nearer to zero than `knee`, in the unit of the axis, and logarithmic on both sides beyond.
    pub fn knee(mut self, knee: f64) -> Self {
        self.knee = Some(knee).filter(|k| k.is_finite() && *k > 0.0);
        self
    }

    /// Without numbers.
    pub fn bare(mut self) -> Self {
        self.bare = true;
        self
    }

    /// Shows this range (in the unit of the axis) whatever the data.
    pub fn range(mut self, from: f64, to: f64) -> Self {
        self.range = Some((from, to));
        self
    }
}

/// A parameter as it is read: `radius of oil` for `oil.radius`.
pub fn parameter_name(path: &str) -> Arg {
    match path.split_once('.') {
        Some((part, field)) => Arg::of(Arg::term(field.replace(['_', '.'], " ")), Arg::name(part)),
        None => Arg::term(path.replace('_', " ")),
    }
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

/// A curve through the rows of a table in their order; it may fold back. NaN breaks it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Line {
    /// Table.
    pub table: String,
    /// Column of x.
    pub x: String,
    /// Column of y.
    pub y: String,
    /// Column whose values split the rows into one line each (mode number, branch).
    pub group: Option<String>,
    /// Flag column: a piece is solid where it is true at both ends, dashed elsewhere.
    pub solid_where: Option<String>,
    /// Flag column: where it is true the curve begins anew, with a gap before it.
    pub begins_where: Option<String>,
    /// Column whose values give pieces of the curves their colour and their name in the legend, in place of the groups.
    pub class: Option<String>,
    /// Values of `class` that always have the same colour, whichever of them occur.
    #[serde(with = "kept::words")]
    pub classes: &'static [&'static str],
    /// Curves of groups coincide: the earlier are drawn wider, so that all are seen.
    pub nested: bool,
    /// Pieces that would be dashed are left out.
    pub solid_only: bool,
    /// What solid and dashed mean in the legend.
    pub solid_dashed: (Arg, Arg),
    /// Name in the legend.
    pub name: Arg,
    /// Drawn thin and grey with its name at its end instead of in the legend: for orders such as 1× and 2×.
    pub reference: bool,
    /// Flag column: what is not valid is drawn thin and grey, and the axes do not reach for it.
    pub valid_where: Option<String>,
    /// An angle in rad, shown from half a turn below zero to half a turn above.
    pub wrapped: bool,
    /// A smooth path: drawn through its points without corners, its start and direction marked.
    pub path: bool,
    /// Values of `class` that are drawn thin and grey.
    #[serde(with = "kept::words")]
    pub muted: &'static [&'static str],
    /// In the colour of text, not of the palette: for intervals on bars.
    pub ink: bool,
    /// Groups, and the words at the ends of their curves.
    pub ends: Vec<(String, Arg)>,
    /// Groups, and their names in the legend, where these are not the values of the column.
    pub called: Vec<(String, Arg)>,
    /// Values that differ by this are the same (angles): the curve is drawn without jumps by it.
    pub period: Option<f64>,
}

impl Line {
    /// A curve of column `y` over column `x`.
    pub fn new(table: impl Into<String>, x: impl Into<String>, y: impl Into<String>) -> Self {
        Line {
            table: table.into(),
            x: x.into(),
            y: y.into(),
            group: None,
            solid_where: None,
            begins_where: None,
            class: None,
            classes: &[],
            nested: false,
            solid_only: false,
            solid_dashed: ("stable".into(), "unstable".into()),
            name: Arg::default(),
            reference: false,
            valid_where: None,
            wrapped: false,
            path: false,
            muted: &[],
            ink: false,
            ends: Vec::new(),
            called: Vec::new(),
            period: None,
        }
    }

    /// Draws pieces of these classes thin and grey.
    pub fn muted(mut self, classes: &'static [&'static str]) -> Self {
        self.muted = classes;
        self
    }

    /// Draws it in the colour of text.
    pub fn ink(mut self) -> Self {
        self.ink = true;
        self
    }

    /// Words at the ends of the curves of these groups.
    pub fn ends(mut self, ends: Vec<(String, Arg)>) -> Self {
        self.ends = ends;
        self
    }

    /// Names of these groups in the legend.
    pub fn called(mut self, names: Vec<(String, Arg)>) -> Self {
        self.called = names;
        self
    }

    /// Values that differ by `period` are the same: the curve goes on without jumps by it.
    pub fn cyclic(mut self, period: f64) -> Self {
        self.period = Some(period);
        self
    }

    /// One line per value of this column.
    pub fn group(mut self, column: impl Into<String>) -> Self {
        self.group = Some(column.into());
        self
    }

    /// Colours and names the pieces by this column, the same for each of these values in every figure: where there are more curves than colours.
    pub fn classes(mut self, column: impl Into<String>, classes: &'static [&'static str]) -> Self {
        self.class = Some(column.into());
        self.classes = classes;
        self
    }

    /// Leaves out what would be dashed.
    pub fn solid_only(mut self, only: bool) -> Self {
        self.solid_only = only;
        self
    }

    /// Solid where this flag column is true (stable), dashed elsewhere (unstable).
    pub fn solid_where(mut self, column: impl Into<String>) -> Self {
        self.solid_where = Some(column.into());
        self
    }

    /// Begins anew, with a gap before, where this flag column is true.
    pub fn begins_where(mut self, column: impl Into<String>) -> Self {
        self.begins_where = Some(column.into());
        self
    }

    /// Draws earlier groups wider, so that curves that coincide are all seen.
    pub fn nested(mut self) -> Self {
        self.nested = true;
        self
    }

    /// What solid and dashed mean, when not stable and unstable.
    pub fn meaning(mut self, solid: impl Into<Arg>, dashed: impl Into<Arg>) -> Self {
        self.solid_dashed = (solid.into(), dashed.into());
        self
    }

    /// Name in the legend.
    pub fn name(mut self, name: impl Into<Arg>) -> Self {
        self.name = name.into();
        self
    }

    /// Grey where this flag column is not true: outside the validity of a part.
    pub fn valid_where(mut self, column: impl Into<String>) -> Self {
        self.valid_where = Some(column.into());
        self
    }

    /// Shows an angle in rad from half a turn below zero to half a turn above.
    pub fn wrapped(mut self) -> Self {
        self.wrapped = true;
        self
    }

    /// Smooth through its points, with its start and direction: for orbits.
    pub fn path(mut self) -> Self {
        self.path = true;
        self
    }

    /// Draws a thin grey line with its name at its end.
    pub fn reference(mut self) -> Self {
        self.reference = true;
        self
    }
}

/// A marker per row.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Points {
    /// Table.
    pub table: String,
    /// Column of x.
    pub x: String,
    /// Column of y.
    pub y: String,
    /// Column whose values choose colour and shape.
    pub group: Option<String>,
    /// Values of `group` that always have the same colour and shape, whichever of them occur: the first, the second, ... Their sizes differ, so that
    /// markers of two classes at one place are both seen.
    #[serde(with = "kept::words")]
    pub classes: &'static [&'static str],
    /// Flag column: filled markers where true, open ones elsewhere.
    pub filled_where: Option<String>,
    /// Values of `group` that are grey.
    #[serde(with = "kept::words")]
    pub muted: &'static [&'static str],
    /// Small, for many.
    pub small: bool,
    /// Name in the legend.
    pub name: Arg,
    /// Groups, and their names in the legend, where these are not the values of the column.
    pub called: Vec<(String, Arg)>,
}

impl Points {
    /// Markers at columns `x`, `y`.
    pub fn new(table: impl Into<String>, x: impl Into<String>, y: impl Into<String>) -> Self {
        Points {
            table: table.into(),
            x: x.into(),
            y: y.into(),
            group: None,
            classes: &[],
            filled_where: None,
            muted: &[],
            small: false,
            name: Arg::default(),
            called: Vec::new(),
        }
    }

    /// Draws markers of these classes grey.
    pub fn muted(mut self, classes: &'static [&'static str]) -> Self {
        self.muted = classes;
        self
    }

    /// Names of these groups in the legend.
    pub fn called(mut self, names: Vec<(String, Arg)>) -> Self {
        self.called = names;
        self
    }

    /// Small markers, for many.
    pub fn small(mut self) -> Self {
        self.small = true;
        self
    }

    /// Colour and shape by this column.
    pub fn group(mut self, column: impl Into<String>) -> Self {
        self.group = Some(column.into());
        self
    }

    /// Colour and shape by this column, the same for each of these values in every figure.
    pub fn classes(mut self, column: impl Into<String>, classes: &'static [&'static str]) -> Self {
        self.classes = classes;
        self.group(column)
    }

    /// Filled where this flag column is true, open elsewhere.
    pub fn filled_where(mut self, column: impl Into<String>) -> Self {
        self.filled_where = Some(column.into());
        self
    }

    /// Name in the legend.
    pub fn name(mut self, name: impl Into<Arg>) -> Self {
        self.name = name.into();
        self
    }
}

/// A shaded interval.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Band {
    /// Where.
    pub place: BandPlace,
    /// Name in the legend; bands of one name look alike.
    pub name: Arg,
    /// Also a strip at the upper border, never too narrow to be seen.
    pub strip: bool,
    /// In full colour: a bar rather than a background.
    pub bar: bool,
    /// The tint: 0 green, 1 red, 2 blue, 3 pink; otherwise the next that is free.
    pub tint: Option<usize>,
    /// Column of numbers that splits the rows between curves into areas of their own.
    pub group: Option<String>,
}

/// Where a [`Band`] lies; values before the axis factor.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum BandPlace {
    /// Between two values of x, the whole height.
    X(f64, f64),
    /// Between two values of y, the whole width.
    Y(f64, f64),
    /// Between two curves: table, x, lower and upper column; NaN breaks it.
    Between(String, String, String, String),
    /// The same along y: table, y, left and right column.
    Across(String, String, String, String),
}

impl Band {
    /// Between two values of x.
    pub fn x(from: f64, to: f64) -> Self {
        Band::new(BandPlace::X(from, to))
    }

    /// Between two values of y.
    pub fn y(from: f64, to: f64) -> Self {
        Band::new(BandPlace::Y(from, to))
    }

    /// Between the columns `low` and `high` over column `x`.
    pub fn between(table: impl Into<String>, x: impl Into<String>, low: impl Into<String>, high: impl Into<String>) -> Self {
        Band::new(BandPlace::Between(table.into(), x.into(), low.into(), high.into()))
    }

    /// Between the columns `left` and `right` of x over column `y`.
    pub fn across(table: impl Into<String>, y: impl Into<String>, left: impl Into<String>, right: impl Into<String>) -> Self {
        Band::new(BandPlace::Across(table.into(), y.into(), left.into(), right.into()))
    }

    fn new(place: BandPlace) -> Self {
        Band { place, name: Arg::default(), strip: false, bar: false, tint: None, group: None }
    }

    /// One area per value of this column.
    pub fn group(mut self, column: impl Into<String>) -> Self {
        self.group = Some(column.into());
        self
    }

    /// In full colour.
    pub fn bar(mut self) -> Self {
        self.bar = true;
        self
    }

    /// Green, of what is allowed.
    pub fn good(mut self) -> Self {
        self.tint = Some(0);
        self
    }

    /// Red, of what is not.
    pub fn bad(mut self) -> Self {
        self.tint = Some(1);
        self
    }

    /// Pink: missing values of another kind than those drawn in red.
    pub fn pink(mut self) -> Self {
        self.tint = Some(3);
        self
    }

    /// Blue, of neither.
    pub fn neutral(mut self) -> Self {
        self.tint = Some(2);
        self
    }

    /// Adds a strip at the upper border of the panel, wide enough to be seen however narrow the interval. For intervals of x.
    pub fn strip(mut self) -> Self {
        self.strip = true;
        self
    }

    /// Name in the legend.
    pub fn name(mut self, name: impl Into<Arg>) -> Self {
        self.name = name.into();
        self
    }
}

/// A straight line across the panel with a label; `at` before the axis factor.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Rule {
    /// True: vertical, at a value of x. False: horizontal, at a value of y.
    pub vertical: bool,
    /// Where.
    pub at: f64,
    /// Label.
    pub label: Arg,
    /// Two values along the same axis that the label ends with, in the unit of the axis: `unstable 100 to 120`.
    pub between: Option<(f64, f64)>,
}

impl Rule {
    /// Vertical, at a value of x.
    pub fn x(at: f64, label: impl Into<Arg>) -> Self {
        Rule { vertical: true, at, label: label.into(), between: None }
    }

    /// Horizontal, at a value of y.
    pub fn y(at: f64, label: impl Into<Arg>) -> Self {
        Rule { vertical: false, at, label: label.into(), between: None }
    }

    /// Adds two values of the same axis to the label, before its factor.
    pub fn between(mut self, from: f64, to: f64) -> Self {
        self.between = Some((from, to));
        self
    }
}

/// A heat map of `value` over a grid of x and y, given row by row in any order; missing cells stay blank.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Heat {
    /// Table.
    pub table: String,
    /// Column of x.
    pub x: String,
    /// Column of y.
    pub y: String,
    /// Column of the value.
    pub value: String,
    /// Label, unit, factor, scale and range of the colours.
    pub colours: Axis,
    /// Colours that part at zero (growth rates) instead of a plain ramp.
    pub diverging: bool,
    /// Green above zero, where it is allowed; hatched red below.
    pub allowed: bool,
    /// Draws the curve where the value (before the factor) equals this.
    pub contour: Option<f64>,
    /// Draws curves at these values (before the factor) instead of cells.
    pub curves: Option<Vec<f64>>,
    /// Words the value may be, each with a colour of its own and an entry in the legend; empty for numbers.
    pub classes: Vec<String>,
    /// Words, and their names in the legend, where these are not the words.
    pub called: Vec<(String, Arg)>,
}

impl Heat {
    /// A heat map; colours part at zero when the data do.
    pub fn new(table: impl Into<String>, x: impl Into<String>, y: impl Into<String>, value: impl Into<String>, colours: Axis) -> Self {
        Heat {
            table: table.into(),
            x: x.into(),
            y: y.into(),
            value: value.into(),
            colours,
            diverging: false,
            allowed: false,
            contour: None,
            curves: None,
            classes: Vec::new(),
            called: Vec::new(),
        }
    }

    /// Names of these words in the legend.
    pub fn called(mut self, names: Vec<(String, Arg)>) -> Self {
        self.called = names;
        self
    }

    /// A map of a column of words: one colour for each of `classes`; cells of other words stay blank.
    pub fn of_classes(mut self, classes: Vec<String>) -> Self {
        self.classes = classes;
        self
    }

    /// Colours that part at zero: blue below, red above.
    pub fn diverging(mut self) -> Self {
        self.diverging = true;
        self
    }

    /// Colours that part at zero: green above, where it is allowed; hatched red below.
    pub fn allowed(mut self) -> Self {
        self.allowed = true;
        self.diverging()
    }

    /// Draws the curves where the value equals each of `levels`, and no cells.
    pub fn curves(mut self, levels: Vec<f64>) -> Self {
        self.curves = Some(levels);
        self
    }

    /// Draws the curve where the value equals `level`.
    pub fn contour(mut self, level: f64) -> Self {
        self.contour = Some(level);
        self
    }
}

/// Words at a place in data coordinates (before the axis factors).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Text {
    /// x.
    pub x: f64,
    /// y.
    pub y: f64,
    /// The words.
    pub text: Arg,
}

impl Text {
    /// Words centred at a place.
    pub fn new(x: f64, y: f64, text: impl Into<Arg>) -> Self {
        Text { x, y, text: text.into() }
    }
}

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
