//! Tables: named columns with unit and documentation, all of one length.

use super::message::Arg;
use super::{OutcomeError, unique};
use serde::{Deserialize, Serialize};

/// A table whose columns have one length and different names.
///
/// ```
/// use laval::outcome::Table;
/// # fn main() -> Result<(), laval::outcome::OutcomeError> {
/// let modes = Table::new("modes", "Natural modes at 3000 rpm")
///     .int("mode", "", "number in order of frequency", vec![1, 2])
///     .float("frequency", "rad/s", "whirl frequency", vec![210.0, 655.5])
///     .text("whirl", "direction of whirl", vec!["forward".into(), "backward".into()])
///     .build()?;
/// assert_eq!(modes.rows(), 2);
///
/// let same_length = Table::new("t", "").float("a", "", "", vec![1.0]).float("b", "", "", vec![]).build();
/// assert!(same_length.is_err());
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Table {
    name: String,
    doc: Arg,
    columns: Vec<Column>,
    leading: bool,
}

/// One column of a table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Column {
    /// Name, such as `amplitude`.
    pub name: String,
    /// Unit; empty for a pure number, text or flag.
    pub unit: String,
    /// The heading for readers: the name in words, with the name of a body or part apart.
    pub label: Arg,
    /// What it holds.
    pub doc: Arg,
    /// Its words are names of the machine file, which no language translates.
    pub names: bool,
    /// What readers see instead of words that are put together from numbers and names: one for each row, or none at all.
    pub phrases: Vec<Arg>,
    /// Its numbers are in the unit of their row, which the column `unit` names.
    pub in_row_units: bool,
    /// The values.
    pub data: Data,
}

/// Values of a column. NaN stands for "no value".
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Data {
    /// Real numbers.
    Float(Vec<f64>),
    /// Whole numbers.
    Int(Vec<i64>),
    /// Words.
    Text(Vec<String>),
    /// Yes or no.
    Flag(Vec<bool>),
}

impl Data {
    /// Number of values.
    pub fn len(&self) -> usize {
        match self {
            Data::Float(v) => v.len(),
            Data::Int(v) => v.len(),
            Data::Text(v) => v.len(),
            Data::Flag(v) => v.len(),
        }
    }

    /// Whether there is no value.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

impl Column {
    /// The heading: `speed [rad/s]`, or the bare name without a unit.
    pub fn heading(&self) -> String {
        if self.unit.is_empty() { self.name.clone() } else { format!("{} [{}]", self.name, self.unit) }
    }

    /// The numbers of the column; NaN for rows that do not exist. `None` for text and flags.
    pub fn number(&self, row: usize) -> Option<f64> {
        match &self.data {
            Data::Float(v) => Some(v.get(row).copied().unwrap_or(f64::NAN)),
            Data::Int(v) => Some(v.get(row).map_or(f64::NAN, |x| *x as f64)),
            _ => None,
        }
    }
}

impl Table {
    /// Starts a table.
    #[allow(clippy::new_ret_no_self)]
    pub fn new(name: impl Into<String>, doc: impl Into<Arg>) -> TableBuilder {
        TableBuilder { table: Table { name: name.into(), doc: doc.into(), columns: Vec::new(), leading: false } }
    }

    /// A table of real numbers from rows; `columns` holds name, unit and documentation of each.
    ///
    /// ```
    /// use laval::outcome::Table;
    /// let t = Table::from_rows("orbit", "Motion of the drum", [("t", "s", "time"), ("x", "m", "")], &[[0.0, 1.0], [0.1, 2.0]]);
    /// assert_eq!(t.unwrap().rows(), 2);
    /// ```
    ///
    /// # Errors
    /// When two columns have one name.
    pub fn from_rows<const N: usize>(
        name: impl Into<String>,
        doc: impl Into<Arg>,
        columns: [(&str, &str, &'static str); N],
        rows: &[[f64; N]],
    ) -> Result<Table, OutcomeError> {
        let mut builder = Table::new(name, doc);
        for (j, (column, unit, doc)) in columns.into_iter().enumerate() {
            builder = builder.float(column, unit, doc, rows.iter().map(|r| r[j]).collect());
        }
        builder.build()
    }

    /// Name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// What the table holds.
    pub fn doc(&self) -> &Arg {
        &self.doc
    }

    /// The columns, all of one length.
    pub fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// Says in numbers what the study found: shown unfolded.
    pub fn is_leading(&self) -> bool {
        self.leading
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.columns.first().map_or(0, |c| c.data.len())
    }

    /// Gives columns a heading other than their name, where there is one.
    pub(crate) fn head(&mut self, heading: impl Fn(&str) -> Option<Arg>) {
        for column in &mut self.columns {
            if let Some(label) = heading(&column.name) {
                column.label = label;
            }
        }
    }

    /// The column of that name.
    pub fn column(&self, name: &str) -> Option<&Column> {
        self.columns.iter().find(|c| c.name == name)
    }
}

/// Collects the columns of a [`Table`]; [`TableBuilder::build`] checks them.
#[derive(Clone, Debug)]
pub struct TableBuilder {
    table: Table,
}

impl TableBuilder {
    fn add(mut self, name: impl Into<String>, unit: impl Into<String>, doc: impl Into<Arg>, data: Data) -> Self {
        let name = name.into();
        let label = Arg::term(name.replace('_', " "));
        self.table.columns.push(Column {
            name,
            unit: unit.into(),
            label,
            doc: doc.into(),
            names: false,
            phrases: Vec::new(),
            in_row_units: false,
            data,
        });
        self
    }

    /// Says in numbers what the study found: shown unfolded.
    pub fn leading(mut self) -> Self {
        self.table.leading = true;
        self
    }

    /// Adds a column of real numbers.
    pub fn float(self, name: impl Into<String>, unit: impl Into<String>, doc: impl Into<Arg>, values: Vec<f64>) -> Self {
        self.add(name, unit, doc, Data::Float(values))
    }

    /// Adds a column of real numbers unless there are rows and none has a value.
    pub fn float_if_any(self, name: impl Into<String>, unit: impl Into<String>, doc: impl Into<Arg>, values: Vec<f64>) -> Self {
        if !values.is_empty() && values.iter().all(|x| x.is_nan()) { self } else { self.float(name, unit, doc, values) }
    }

    /// Adds a column of whole numbers.
    pub fn int(self, name: impl Into<String>, unit: impl Into<String>, doc: impl Into<Arg>, values: Vec<i64>) -> Self {
        self.add(name, unit, doc, Data::Int(values))
    }

    /// Adds a column of words.
    pub fn text(self, name: impl Into<String>, doc: impl Into<Arg>, values: Vec<String>) -> Self {
        self.add(name, "", doc, Data::Text(values))
    }

    /// Adds a column of words that are put together from numbers and names, each with what readers see instead.
    pub fn phrases(self, name: impl Into<String>, doc: impl Into<Arg>, values: Vec<(String, Arg)>) -> Self {
        let (words, phrases) = values.into_iter().unzip();
        let mut out = self.text(name, doc, words);
        if let Some(column) = out.table.columns.last_mut() {
            column.phrases = phrases;
        }
        out
    }

    /// Adds a column of names of the machine file.
    pub fn names(self, name: impl Into<String>, doc: impl Into<Arg>, values: Vec<String>) -> Self {
        let mut out = self.text(name, doc, values);
        if let Some(column) = out.table.columns.last_mut() {
            column.names = true;
        }
        out
    }

    /// Says that the numbers of these columns are in the unit of their row, which the column `unit` names.
    pub fn in_row_units(mut self, columns: &[&str]) -> Self {
        self.table.columns.iter_mut().filter(|c| columns.contains(&c.name.as_str())).for_each(|c| c.in_row_units = true);
        self
    }

    /// Adds a column of yes and no.
    pub fn flag(self, name: impl Into<String>, doc: impl Into<Arg>, values: Vec<bool>) -> Self {
        self.add(name, "", doc, Data::Flag(values))
    }

    /// The table.
    ///
    /// # Errors
    /// When a column has another length than the first, or two have one name.
    pub fn build(self) -> Result<Table, OutcomeError> {
        let table = self.table;
        let expected = table.rows();
        for column in &table.columns {
            let found = column.data.len();
            if found != expected {
                return Err(OutcomeError::Length { table: table.name.clone(), column: column.name.clone(), found, expected });
            }
        }
        unique("column", table.columns.iter().map(|c| c.name.as_str()))?;
        Ok(table)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_and_names_are_checked() {
        let short = Table::new("t", "").float("a", "m", "", vec![1.0, 2.0]).flag("b", "", vec![true]).build();
        assert_eq!(short, Err(OutcomeError::Length { table: "t".into(), column: "b".into(), found: 1, expected: 2 }));
        let twice = Table::new("t", "").float("a", "m", "", vec![]).int("a", "", "", vec![]).build();
        assert!(matches!(twice, Err(OutcomeError::Twice { .. })));
    }

    #[test]
    fn headings() {
        let t = Table::new("t", "").float("speed", "rad/s", "", vec![]).text("branch", "", vec![]).build().unwrap();
        assert_eq!(t.columns().iter().map(Column::heading).collect::<Vec<_>>(), ["speed [rad/s]", "branch"]);
    }
}
