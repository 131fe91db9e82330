//! Coefficients of a linear bearing over the spin speed: the rows of the table, which are parameters, and the speeds they belong to.

use super::{BearingLinear, BearingLinearParams};
use crate::model::field::Bounds;
use crate::model::params::{Family, Listed, RowCounts, RowFamily};
use crate::model::part::{Beyond, Params};
use crate::params;
use crate::text;
use crate::text::Text;
use laval_num::interpolate::{Knots, Ordinates, TableError};
use laval_num::scalar::Scalar;

params! {
    /// Coefficients in a row of the table of a [`BearingLinear`].
    pub struct TableRow in TableRowFamily {
        kxx: scalar, "N/m", Bounds::within(1e15), default 0.0, "stiffness in x against x";
        kxy: scalar, "N/m", Bounds::within(1e15), default 0.0, "force in -x per displacement in y";
        kyx: scalar, "N/m", Bounds::within(1e15), default 0.0, "force in -y per displacement in x";
        kyy: scalar, "N/m", Bounds::within(1e15), default 0.0, "stiffness in y against y";
        cxx: scalar, "N s/m", Bounds::within(1e12), default 0.0, "damping in x against x";
        cxy: scalar, "N s/m", Bounds::within(1e12), default 0.0, "force in -x per velocity in y";
        cyx: scalar, "N s/m", Bounds::within(1e12), default 0.0, "force in -y per velocity in x";
        cyy: scalar, "N s/m", Bounds::within(1e12), default 0.0, "damping in y against y";
    }
}

impl RowFamily for TableRowFamily {
    const LIST: &'static str = "table";
}

/// A column of the table by its place in [`NAMES`].
struct Column<'a, S>(&'a [TableRow<S>], usize);

impl<S: Scalar> Ordinates<S> for Column<'_, S> {
    #[inline(always)]
    fn at(&self, row: usize) -> S {
        let r = &self.0[row];
        match self.1 {
            0 => r.kxx,
            1 => r.kxy,
            2 => r.kyx,
            3 => r.kyy,
            4 => r.cxx,
            5 => r.cxy,
            6 => r.cyx,
            _ => r.cyy,
        }
    }
}

/// The coefficients in order: kxx kxy kyx kyy cxx cxy cyx cyy.
pub(super) const NAMES: [&str; 8] = ["kxx", "kxy", "kyx", "kyy", "cxx", "cxy", "cyx", "cyy"];

/// What limits a table, as a statement of validity.
pub(super) const RANGE: &str = "distance of the speed from the middle of the bearing table over half its range";

/// Coefficients and their derivatives over speed.
pub(super) struct Coefficients<S> {
    pub value: [S; 8],
    pub slope: [S; 8],
}

/// Coefficients over speed; a coefficient without a column is zero.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    speeds: Knots,
    rows: Vec<TableRow>,
    beyond: Beyond,
}

impl Table {
    /// From increasing speeds (rad/s, at least two) and columns by coefficient name; every mistake is one sentence.
    pub fn new(speed: &[f64], column: impl Fn(&str) -> Option<Vec<f64>>) -> Result<Self, Vec<Text>> {
        let mut wrong = Vec::new();
        let speeds = Knots::new(speed);
        if speed.len() < 2 {
            wrong.push(text!("a table over speed has at least two rows; for one speed give the coefficients themselves"));
        } else if let Err(error) = &speeds {
            let error = *error;
            wrong.push(match error {
                TableError::NotIncreasing(row) => {
                    let shown = |w: f64| text::quantity(w, "rad/s");
                    text!(
                        "speeds must increase from row to row: row {number} has {speed} after {before}",
                        number = row + 1,
                        speed = shown(speed[row]),
                        before = shown(speed[row - 1])
                    )
                }
                other => text!("column speed: {why}", why = other),
            });
        }
        let columns = NAMES.map(|name| {
            let Some(values) = column(name) else { return Some(vec![0.0; speed.len()]) };
            if values.len() != speed.len() {
                wrong.push(text!(
                    "column {name} has {values} rows and column speed has {speed}",
                    name,
                    values = values.len(),
                    speed = speed.len()
                ));
                return None;
            }
            if let Some(row) = values.iter().position(|v| !v.is_finite()) {
                wrong.push(text!("column {name}: row {number} is not a finite number", name, number = row + 1));
            }
            Some(values)
        });
        let columns: Option<Vec<Vec<f64>>> = columns.into_iter().collect();
        let (Ok(speeds), Some(columns), true) = (speeds, columns, wrong.is_empty()) else { return Err(wrong) };
        let row = |k: usize| TableRowFamily::from_slice(&columns.iter().map(|c| c[k]).collect::<Vec<_>>(), RowCounts::default());
        Ok(Table { speeds, rows: (0..speed.len()).map(row).collect(), beyond: Beyond::Refuse })
    }

    /// The same, continued like this outside its range.
    #[must_use]
    pub fn beyond(self, beyond: Beyond) -> Self {
        let speeds = if beyond == Beyond::Linear { self.speeds.straight_outside() } else { self.speeds };
        Table { speeds, beyond, ..self }
    }

    /// Its coefficients as the parameters of a bearing.
    pub fn params(&self) -> Params<BearingLinear, f64> {
        Listed { own: BearingLinearParams::new(), rows: self.rows.clone() }
    }

    /// First and last speed, rad/s.
    pub fn range(&self) -> (f64, f64) {
        self.speeds.range()
    }

    /// How many rows it has.
    #[inline(always)]
    pub(super) fn count(&self) -> usize {
        self.speeds.count()
    }
    /// How it continues outside.
    pub(super) fn beyond_range(&self) -> Beyond {
        self.beyond
    }

    /// The coefficients at a speed, with the values that its rows have now.
    #[inline(always)]
    pub(super) fn coefficients<S: Scalar>(&self, rows: &[TableRow<S>], speed: S) -> Coefficients<S> {
        let mut out = Coefficients { value: [S::zero(); 8], slope: [S::zero(); 8] };
        for i in 0..NAMES.len() {
            let column = Column(rows, i);
            let mut empty = true;
            for k in 0..rows.len() {
                empty &= column.at(k).is_nothing();
            }
            if !empty {
                (out.value[i], out.slope[i]) = self.speeds.value_and_slope(&column, speed);
            }
        }
        out
    }
}
