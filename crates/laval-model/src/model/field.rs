//! What a part or a study may be given: one declaration each, from which the file reader, the schema, the documentation and
//! the sweep axes follow.

use super::params::List;
use crate::diagnostic::Span;
use crate::text;
use crate::text::Text;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};

/// Admissible interval of a number, in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Lower end.
    pub min: f64,
    /// Upper end.
    pub max: f64,
    /// The lower end itself is not admitted.
    pub min_open: bool,
}

impl Bounds {
    /// From `min` to `max`, both admitted.
    pub const fn closed(min: f64, max: f64) -> Self {
        Bounds { min, max, min_open: false }
    }
    /// Above 0, up to `max`.
    pub const fn positive(max: f64) -> Self {
        Bounds { min: 0.0, max, min_open: true }
    }
    /// From 0 to `max`.
    pub const fn up_to(max: f64) -> Self {
        Bounds { min: 0.0, max, min_open: false }
    }
    /// From `-max` to `max`.
    pub const fn within(max: f64) -> Self {
        Bounds { min: -max, max, min_open: false }
    }
    /// `x` is finite and inside.
    pub fn contains(&self, x: f64) -> bool {
        x.is_finite() && x <= self.max && if self.min_open { x > self.min } else { x >= self.min }
    }
    /// In words, for numbers of an SI unit: "above 0 and at most 1e15 N/m".
    pub fn text(&self, unit: &str) -> Text {
        let n = |x: f64| text::quantity(x, unit.to_string());
        let low = match (self.min, self.min_open) {
            (m, _) if m == f64::NEG_INFINITY => None,
            (0.0, true) => Some(text!("above 0")),
            (m, true) => Some(text!("above {least}", least = n(m))),
            (0.0, false) => Some(text!("0 or more")),
            (m, false) => Some(text!("at least {least}", least = n(m))),
        };
        let high = (self.max != f64::INFINITY).then(|| n(self.max));
        match (low, high) {
            (None, None) => text!("finite"),
            (Some(l), None) => l,
            (None, Some(most)) => text!("at most {most}", most),
            (Some(_), Some(most)) if !self.min_open && self.min != 0.0 => text!("between {least} and {most}", least = n(self.min), most),
            (Some(_), Some(most)) if !self.min_open => text!("between 0 and {most}", most),
            (Some(least), Some(most)) => text!("{least} and at most {most}", least, most),
        }
    }
}

/// A word that may be chosen, and what it means.
pub type Word = (&'static str, &'static str);

/// What kind of value a field takes. `unit` is the SI unit a number is stored in ("" is a pure number), `bounds` its admissible interval.
#[allow(missing_docs)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FieldKind {
    /// One number with a unit.
    Quantity { unit: &'static str, bounds: Bounds },
    /// One number for both lateral directions, or `{ x = .., y = .. }`.
    Lateral { unit: &'static str, bounds: Bounds },
    /// Exactly one of several quantities, as `fill = { volume = "0.3 l" }`.
    OneOf(&'static [(&'static str, &'static str, Bounds, &'static str)]),
    /// One of some words.
    Choice(&'static [Word]),
    /// A whole number from `min` to `max`.
    Integer { min: i64, max: i64 },
    /// A whole number from `min` to `max`, or the word `"auto"`.
    IntegerOrAuto { min: i64, max: i64 },
    /// `true` or `false`.
    Flag,
    /// Free text.
    Text,
    /// One point of a body: `"drum"` or `{ body = "drum", at = "40 mm" }`; `"ground"` where the flag allows it.
    Attach { ground: bool },
    /// Two points of bodies: `["drum", { body = "base", at = "10 mm" }]`; one of them may be `"ground"`.
    Between,
    /// Numbers from a to b: `{ from = .., to = .., points = .. }`; `points` optional.
    Range { unit: &'static str, bounds: Bounds },
    /// A list of numbers with units.
    List { unit: &'static str, bounds: Bounds },
    /// A parameter of a part by path, for instance `"liquid.free_surface_radius"`.
    ParameterPath,
    /// The range of one parameter: `{ parameter = "liquid.free_surface_radius", from = .., to = .., points = .. }`;
    /// its unit is that of the parameter.
    ParameterRange,
    /// Ranges of several parameters: a list of what a [`FieldKind::ParameterRange`] takes, without points.
    ParameterRanges,
    /// A coordinate by name, for instance `"drum.x"`.
    Coordinate,
    /// Numbers in columns of equal length: `{ speed = [..], kxx = [..] }`; each column's name, unit, whether it is required, meaning.
    Columns(&'static [(&'static str, &'static str, bool, &'static str)]),
    /// One quantity for all, or one for each of some names: `"0.5 mm"` or `{ drum = "0.5 mm", base = "0.1 mm" }`.
    Named { unit: &'static str, bounds: Bounds },
    /// Initial values by coordinate or rate: `{ "drum.x" = "1 mm", "drum.x'" = "0.1 m/s" }`.
    StateMap,
    /// Another study: the name of one in the file, or a whole one: `{ kind = "modes", count = 4 }`.
    Study,
    /// Uncertain parameters: `[{ parameter = "drum.mass", distribution = "normal", deviation = "2 %" }]`.
    Tolerances,
}

/// Distributions of an uncertain parameter.
pub const DISTRIBUTIONS: &[Word] = &[
    ("normal", "deviation: standard deviation; mean unless it is the value of the machine"),
    ("log_normal", "the same, for what cannot be negative: its logarithm is normal"),
    ("uniform", "from and to, or tolerance: half the width about the value of the machine"),
    ("triangular", "the same, most probable at mode, the value of the machine unless given"),
];
/// Numbers of the distributions of an uncertain parameter.
pub const AMOUNTS: &[&str] = &["mean", "deviation", "from", "to", "tolerance", "mode"];

/// A number in the unit of a parameter, or a share of the parameter's value in the machine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Amount {
    /// SI.
    Absolute(f64),
    /// `"2 %"` of the parameter's value in the machine, as 2.
    Percent(f64),
}

/// One uncertain parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Tolerance {
    /// Its path.
    pub parameter: String,
    /// One of [`DISTRIBUTIONS`].
    pub distribution: &'static str,
    /// What was given of [`AMOUNTS`].
    pub amounts: Vec<(&'static str, Amount)>,
    /// Place in the file.
    pub span: Option<Span>,
}

impl Tolerance {
    /// A number of the distribution, for a machine in which the parameter has this value.
    pub fn amount(&self, name: &str, nominal: f64) -> Option<f64> {
        self.amounts.iter().find(|a| a.0 == name).map(|a| match a.1 {
            Amount::Absolute(x) => x,
            Amount::Percent(x) => 0.01 * x * nominal,
        })
    }
}

/// A study inside a study.
#[derive(Clone, Debug, PartialEq)]
pub struct InnerStudy {
    /// The study of the file it was named by.
    pub name: Option<String>,
    /// The word of its kind.
    pub kind: &'static str,
    /// Its values.
    pub values: Values,
}

/// One declared key of a part or a study.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Field {
    /// The word in the file.
    pub name: &'static str,
    /// What it takes.
    pub kind: FieldKind,
    /// Must be given; otherwise absent means the default (stated in `default`).
    pub required: bool,
    /// The default as a person would write it in the file, for documentation and for the reader; "" when absence itself has a meaning.
    pub default: &'static str,
    /// What it is, with the symbol of its theory page.
    pub doc: &'static str,
}

impl Field {
    /// A field that must be given.
    pub const fn required(name: &'static str, kind: FieldKind, doc: &'static str) -> Self {
        Field { name, kind, required: true, default: "", doc }
    }
    /// A field that may be left out.
    pub const fn optional(name: &'static str, kind: FieldKind, default: &'static str, doc: &'static str) -> Self {
        Field { name, kind, required: false, default, doc }
    }
    /// The list or table among these in which a parameter's path without its part, as `unbalances.1.phase`, looks for a value. Its values are no parameters:
    /// how many there are is up to the file, and studies hold them.
    pub fn list_of<'f>(fields: &'f [Field], path: &str) -> Option<&'f Field> {
        let name = path.split(['.', '[', ' ']).next()?;
        fields.iter().find(|f| f.name == name && matches!(f.kind, FieldKind::List { .. } | FieldKind::Columns(_)))
    }
}

/// A point of a body, or the ground.
#[derive(Clone, Debug, PartialEq)]
pub struct Attach {
    /// Name of the body; `None` is the ground.
    pub body: Option<String>,
    /// Position along the shaft from the body's reference point, m.
    pub position: f64,
}

impl Attach {
    /// The reference point of a body.
    pub fn on(body: impl Into<String>) -> Self {
        Attach { body: Some(body.into()), position: 0.0 }
    }
    /// A point of a body at a distance (m, along the shaft) from its reference point.
    pub fn at(body: impl Into<String>, position: f64) -> Self {
        Attach { body: Some(body.into()), position }
    }
    /// The ground.
    pub fn ground() -> Self {
        Attach { body: None, position: 0.0 }
    }
}

/// Most points of a range: as many speeds or values as a study keeps the modes of.
pub const MOST_POINTS: usize = 100_000;

/// `{ from, to, points }` in SI units; one value has two equal ends.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct RangeValue {
    /// First value.
    pub from: f64,
    /// Last value.
    pub to: f64,
    /// Number of points, when given.
    pub points: Option<usize>,
}

impl RangeValue {
    /// One value: both ends are the same.
    pub fn is_one(&self) -> bool {
        self.from == self.to
    }

    /// Equally spaced values, `points` of them (or `default` when none were given).
    pub fn linspace(&self, default: usize) -> Vec<f64> {
        if self.is_one() {
            return vec![self.from];
        }
        let n = self.points.unwrap_or(default).max(1);
        (0..n)
            .map(|i| if i + 1 == n && n > 1 { self.to } else { self.from + (self.to - self.from) * i as f64 / (n.max(2) - 1) as f64 })
            .collect()
    }
}

/// A value read from a file or given by a builder, in SI units.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// [`FieldKind::Quantity`].
    Number(f64),
    /// [`FieldKind::Lateral`].
    Lateral([f64; 2]),
    /// [`FieldKind::OneOf`]: which, and its value.
    OneOf(&'static str, f64),
    /// [`FieldKind::Choice`].
    Choice(&'static str),
    /// [`FieldKind::Integer`].
    Integer(i64),
    /// The word "auto" where it is allowed.
    Auto,
    /// [`FieldKind::Flag`].
    Flag(bool),
    /// [`FieldKind::Text`], paths and coordinates.
    Text(String),
    /// [`FieldKind::Attach`].
    Attach(Attach),
    /// [`FieldKind::Between`].
    Between(Attach, Attach),
    /// [`FieldKind::Range`].
    Range(RangeValue),
    /// [`FieldKind::List`].
    List(Vec<f64>),
    /// [`FieldKind::ParameterRange`]: path and range.
    ParameterRange(String, RangeValue),
    /// [`FieldKind::ParameterRanges`]: paths, ranges and their places.
    ParameterRanges(Vec<(String, RangeValue, Option<Span>)>),
    /// [`FieldKind::Columns`]: by column name.
    Columns(BTreeMap<&'static str, Vec<f64>>),
    /// [`FieldKind::StateMap`]; the entries of a [`FieldKind::Named`] that is not one number.
    StateMap(Vec<(String, f64, Span)>),
    /// [`FieldKind::Study`].
    Study(Box<InnerStudy>),
    /// [`FieldKind::Tolerances`].
    Tolerances(Vec<Tolerance>),
}

/// The values of one block, by field name, each with its place in the file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Values {
    map: BTreeMap<String, (Value, Option<Span>)>,
    units: BTreeMap<String, Vec<Option<String>>>,
    /// Fields that stand by default.
    defaults: BTreeSet<String>,
    /// The whole block in the file.
    pub span: Option<Span>,
}

impl Values {
    /// Sets a value.
    pub fn set(&mut self, name: &str, value: Value, span: Option<Span>) {
        self.defaults.remove(name);
        self.map.insert(name.to_string(), (value, span));
    }
    /// The value of a field, if present (defaults are filled in by the reader).
    pub fn get(&self, name: &str) -> Option<&Value> {
        self.map.get(name).map(|(v, _)| v)
    }
    /// Place of a field, or of the block.
    pub fn span_of(&self, name: &str) -> Option<Span> {
        self.map.get(name).and_then(|(_, s)| s.clone()).or_else(|| self.span.clone())
    }
    /// A field that was left out has its default now.
    pub fn mark_default(&mut self, name: &str) {
        self.defaults.insert(name.to_string());
    }
    /// The field was given: it does not stand by default.
    pub fn written(&self, name: &str) -> bool {
        self.map.contains_key(name) && !self.defaults.contains(name)
    }
    /// Sets the units in which the entries of a [`FieldKind::StateMap`] were given.
    pub fn set_units(&mut self, name: &str, units: Vec<Option<String>>) {
        self.units.insert(name.to_string(), units);
    }
    /// For each entry of a [`FieldKind::StateMap`] the SI unit of what was written (`None` for a bare number), so that whoever knows
    /// the coordinate can check its dimension.
    pub fn units_of(&self, name: &str) -> &[Option<String>] {
        self.units.get(name).map_or(&[], Vec::as_slice)
    }
    /// Removes all places in the file, and what stands by default, for comparisons.
    pub fn forget_spans(&mut self) {
        self.span = None;
        self.defaults.clear();
        for (value, span) in self.map.values_mut() {
            *span = None;
            match value {
                Value::StateMap(entries) => entries.iter_mut().for_each(|e| e.2 = 0..0),
                Value::Study(inner) => inner.values.forget_spans(),
                Value::Tolerances(list) => list.iter_mut().for_each(|t| t.span = None),
                Value::ParameterRanges(list) => list.iter_mut().for_each(|r| r.2 = None),
                _ => {}
            }
        }
    }
    /// All names present.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.map.keys().map(String::as_str)
    }
    /// A number.
    pub fn number(&self, name: &str) -> Option<f64> {
        match self.get(name)? {
            Value::Number(x) => Some(*x),
            _ => None,
        }
    }
    /// A number for each lateral direction.
    pub fn lateral(&self, name: &str) -> Option<[f64; 2]> {
        match self.get(name)? {
            Value::Lateral(x) => Some(*x),
            Value::Number(x) => Some([*x, *x]),
            _ => None,
        }
    }
    /// Ranges of several parameters.
    pub fn parameter_ranges(&self, name: &str) -> Option<&[(String, RangeValue, Option<Span>)]> {
        match self.get(name)? {
            Value::ParameterRanges(list) => Some(list),
            _ => None,
        }
    }
    /// A chosen word.
    pub fn choice(&self, name: &str) -> Option<&'static str> {
        match self.get(name)? {
            Value::Choice(x) => Some(x),
            _ => None,
        }
    }
    /// A whole number.
    pub fn integer(&self, name: &str) -> Option<i64> {
        match self.get(name)? {
            Value::Integer(x) => Some(*x),
            _ => None,
        }
    }
    /// A flag.
    pub fn flag(&self, name: &str) -> Option<bool> {
        match self.get(name)? {
            Value::Flag(x) => Some(*x),
            _ => None,
        }
    }
    /// A text, path or coordinate name.
    pub fn text(&self, name: &str) -> Option<&str> {
        match self.get(name)? {
            Value::Text(x) => Some(x),
            _ => None,
        }
    }
    /// One point of a body.
    pub fn attach(&self, name: &str) -> Option<Attach> {
        match self.get(name)? {
            Value::Attach(x) => Some(x.clone()),
            _ => None,
        }
    }
    /// Two points of bodies.
    pub fn between(&self, name: &str) -> Option<(Attach, Attach)> {
        match self.get(name)? {
            Value::Between(a, b) => Some((a.clone(), b.clone())),
            _ => None,
        }
    }
    /// A range.
    pub fn range(&self, name: &str) -> Option<RangeValue> {
        match self.get(name)? {
            Value::Range(x) => Some(*x),
            _ => None,
        }
    }
    /// A list of numbers.
    pub fn list(&self, name: &str) -> Option<&[f64]> {
        match self.get(name)? {
            Value::List(x) => Some(x),
            _ => None,
        }
    }
    /// Which of several, and its value.
    pub fn one_of(&self, name: &str) -> Option<(&'static str, f64)> {
        match self.get(name)? {
            Value::OneOf(k, x) => Some((k, *x)),
            _ => None,
        }
    }
    /// Columns by name.
    pub fn columns(&self, name: &str) -> Option<&BTreeMap<&'static str, Vec<f64>>> {
        match self.get(name)? {
            Value::Columns(x) => Some(x),
            _ => None,
        }
    }
    /// A parameter path and its range.
    pub fn parameter_range(&self, name: &str) -> Option<(&str, RangeValue)> {
        match self.get(name)? {
            Value::ParameterRange(p, r) => Some((p, *r)),
            _ => None,
        }
    }
    /// One number for all names, or the entries by name; empty when the field is absent.
    pub fn named(&self, name: &str) -> Vec<(Option<&str>, f64)> {
        match self.get(name) {
            Some(Value::Number(x)) => vec![(None, *x)],
            Some(Value::StateMap(entries)) => entries.iter().map(|e| (Some(e.0.as_str()), e.1)).collect(),
            _ => Vec::new(),
        }
    }
    /// A study inside this one.
    pub fn study(&self, name: &str) -> Option<&InnerStudy> {
        match self.get(name)? {
            Value::Study(x) => Some(x),
            _ => None,
        }
    }
    /// Uncertain parameters.
    pub fn tolerances(&self, name: &str) -> Option<&[Tolerance]> {
        match self.get(name)? {
            Value::Tolerances(x) => Some(x),
            _ => None,
        }
    }
    /// Initial values.
    pub fn state_map(&self, name: &str) -> Option<&[(String, f64, Span)]> {
        match self.get(name)? {
            Value::StateMap(x) => Some(x),
            _ => None,
        }
    }
}

/// A kind of part or study as the file reader, the schema and the documentation see it.
#[derive(Clone, Debug)]
pub struct KindInfo {
    /// The word in the file.
    pub kind: &'static str,
    /// One paragraph: what it is.
    pub doc: &'static str,
    /// Lines of a typical block; "" where they follow from the fields.
    pub example: &'static str,
    /// Everything that may be said of it, besides `kind` and `name`.
    pub fields: Vec<Field>,
    /// Lists whose rows hold parameters.
    pub lists: Vec<List>,
}

/// A block of the file beside parts and studies, such as `[suspension]` or `[[cup]]`, as the file reader, the schema and the documentation see it.
#[derive(Clone, Debug)]
pub struct BlockInfo {
    /// The word in the brackets.
    pub word: &'static str,
    /// There may be several, in double brackets, each with a kind and a name; else there is one, and one kind of the same word.
    pub several: bool,
    /// Its kinds.
    pub kinds: Vec<KindInfo>,
}

/// A block beside parts and studies, as read: what studies find in [`Machine`](super::system::Machine).
#[derive(Clone, Debug, PartialEq)]
pub struct Extra {
    /// The word in the brackets.
    pub word: &'static str,
    /// Its kind.
    pub kind: &'static str,
    /// Its name.
    pub name: String,
    /// Its values.
    pub values: Values,
}

/// Parameter values of one part while it is built: what the file gave, by slot name; a part may add derived ones.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ParamValues(pub BTreeMap<String, f64>);

impl ParamValues {
    /// A value given so far.
    pub fn get(&self, name: &str) -> Option<f64> {
        self.0.get(name).copied()
    }
    /// Sets a scalar parameter.
    pub fn set(&mut self, name: &str, value: f64) {
        self.0.insert(name.to_string(), value);
    }
}
