//! Table of a linear bearing: its rows, whose coefficients are parameters, over the spin speed or over speed and frequency of vibration.

use super::asynchronous::Grid;
use super::{BearingLinear, BearingLinearParams};
use crate::model::field::Bounds;
use crate::model::params::{Family, Listed, RowCounts, RowFamily};
use crate::model::part::{Beyond, Params};
use crate::params;
use crate::text;
use crate::text::Text;
use laval_num::dual::Dual;
use laval_num::interpolate::{Knots, Ordinates, TableError};
use laval_num::lanes::Routine;
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
pub(super) struct Column<'a, S>(pub &'a [TableRow<S>], pub usize);

impl<S: Scalar> Column<'_, S> {
    /// All its values are zero and constant.
    #[inline(always)]
    pub fn is_empty(&self) -> bool {
        let mut empty = true;
        for k in 0..self.0.len() {
            empty &= self.at(k).is_nothing();
        }
        empty
    }
}

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

/// What limits a table, as statements of validity.
pub(super) const RANGE: &str = "distance of the speed from the middle of the bearing table over half its range";
pub(super) const FREQUENCIES: &str = "distance of the frequency of vibration from the middle of the bearing table over half its range";

/// Coefficients and their derivatives over speed.
pub(super) struct Coefficients<S> {
    pub value: [S; 8],
    pub slope: [S; 8],
}

/// Coefficients over speed, or over speed and frequency of vibration; a coefficient without a column is zero.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    speeds: Knots,
    grid: Option<Grid>,
    rows: Vec<TableRow>,
    beyond: Beyond,
}

impl Table {
    /// From speeds (rad/s, at least two) and columns by coefficient name; every mistake is one sentence. Speeds increase from row to row; with a column `frequency`
    /// (rad/s) the rows are all pairs of the speeds and the frequencies instead, at least two of each, in any order.
    pub fn new(speed: &[f64], column: impl Fn(&str) -> Option<Vec<f64>>) -> Result<Self, Vec<Text>> {
        let mut wrong = Vec::new();
        let mut whole = |name: &'static str| -> Option<Option<Vec<f64>>> {
            let Some(values) = column(name) else { return Some(None) };
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
            Some(Some(values))
        };
        let columns = NAMES.map(|name| Some(whole(name)?.unwrap_or_else(|| vec![0.0; speed.len()])));
        let frequency = whole("frequency");
        let axes = match &frequency {
            Some(Some(frequency)) if frequency.iter().all(|f| f.is_finite()) => {
                Grid::new(speed, frequency).map(|(speeds, grid)| (speeds, Some(grid)))
            }
            Some(None) => increasing(speed).map(|speeds| (speeds, None)),
            _ => Err(Vec::new()),
        };
        let columns: Option<Vec<Vec<f64>>> = columns.into_iter().collect();
        match (axes, columns, wrong.is_empty()) {
            (Ok((speeds, grid)), Some(columns), true) => {
                let row = |k: usize| TableRowFamily::from_slice(&columns.iter().map(|c| c[k]).collect::<Vec<_>>(), RowCounts::default());
                Ok(Table { speeds, grid, rows: (0..speed.len()).map(row).collect(), beyond: Beyond::Refuse })
            }
            (axes, ..) => {
                let mut all = axes.err().unwrap_or_default();
                all.extend(wrong);
                Err(all)
            }
        }
    }

    /// The same, continued like this outside its speeds and frequencies.
    #[must_use]
    pub fn beyond(self, beyond: Beyond) -> Self {
        let straight = |knots: Knots| if beyond == Beyond::Linear { knots.straight_outside() } else { knots };
        Table { speeds: straight(self.speeds), grid: self.grid.map(|g| g.map_frequencies(straight)), beyond, ..self }
    }

    /// Its coefficients as the parameters of a bearing.
    pub fn params(&self) -> Params<BearingLinear, f64> {
        Listed { own: BearingLinearParams::new(), rows: self.rows.clone() }
    }

    /// First and last speed, rad/s.
    pub fn range(&self) -> (f64, f64) {
        self.speeds.range()
    }

    /// Speeds of the rows, rad/s.
    pub fn speeds(&self) -> &[f64] {
        self.speeds.all()
    }

    /// First and last frequency of vibration, rad/s, of a table over it.
    pub fn frequencies(&self) -> Option<(f64, f64)> {
        self.grid.as_ref().map(Grid::range)
    }

    /// How many rows it has.
    #[inline(always)]
    pub(super) fn count(&self) -> usize {
        self.rows.len()
    }
    /// How it continues outside.
    pub(super) fn rule(&self) -> Beyond {
        self.beyond
    }

    /// The coefficients at a speed and a frequency, with the values that its rows have now.
    #[inline(always)]
    pub(super) fn values<S: Scalar>(&self, rows: &[TableRow<S>], speed: S, frequency: S) -> [S; 8] {
        match &self.grid {
            None => self.coefficients(rows, speed, frequency, S::zero()).value,
            Some(grid) => grid.values(&self.speeds, rows, speed, frequency),
        }
    }

    /// The same and its derivative over the speed where the frequency rises with it at a rate.
    #[inline(always)]
    pub(super) fn coefficients<S: Scalar>(&self, rows: &[TableRow<S>], speed: S, frequency: S, rate: S) -> Coefficients<S> {
        let mut out = Coefficients { value: [S::zero(); 8], slope: [S::zero(); 8] };
        if let Some(grid) = &self.grid {
            let all: [Dual<S, 1>; 8] = grid.values(&self.speeds, rows, Dual::seed(speed, 0), Dual { re: frequency, eps: [rate] });
            for i in 0..NAMES.len() {
                (out.value[i], out.slope[i]) = (all[i].re, all[i].eps[0]);
            }
            return out;
        }
        for i in 0..NAMES.len() {
            let column = Column(rows, i);
            if !column.is_empty() {
                (out.value[i], out.slope[i]) = S::apart(AtSpeed { speeds: &self.speeds, column, speed });
            }
        }
        out
    }
}

/// A column at a speed, and its derivative over it: one function for all eight.
struct AtSpeed<'a, S> {
    speeds: &'a Knots,
    column: Column<'a, S>,
    speed: S,
}

impl<S: Scalar> Routine for AtSpeed<'_, S> {
    type Out = (S, S);
    #[inline(always)]
    fn run(self) -> (S, S) {
        self.speeds.value_and_slope(&self.column, self.speed)
    }
}

/// Speeds that increase from row to row.
fn increasing(speed: &[f64]) -> Result<Knots, Vec<Text>> {
    if speed.len() < 2 {
        return Err(vec![text!("a table over speed has at least two rows; for one speed give the coefficients themselves")]);
    }
    Knots::new(speed).map_err(|error| {
        vec![match error {
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
        }]
    })
}
