//! Coefficients over the spin speed and the frequency of vibration: a full grid of both.
//!
//! Between its points a coefficient is interpolated over the frequency in the rows of each speed, then over the speed among these values, each time by the
//! monotone cubic of a table over the speed. In that order the curve over the frequency at the speed of a row rests on the rows of that speed alone, as they were
//! measured or computed, and coefficients that do not depend on the frequency give what the table over the speed gives, to the last digit.

use super::table::{Column, NAMES, TableRow};
use crate::text;
use crate::text::Text;
use laval_num::dual::Dual;
use laval_num::interpolate::{Knots, Ordinates};
use laval_num::lanes::Routine;
use laval_num::order::ascending;
use laval_num::scalar::Scalar;

/// Frequencies, and the row of every pair.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Grid {
    frequencies: Knots,
    /// By speed, then frequency.
    rows: Vec<usize>,
}

/// A scalar in which values of rows in `S` are read: `S` itself, or with a derivative that they do not have.
pub(super) trait Reads<S>: Scalar {
    /// A value of a row.
    fn read(x: S) -> Self;
}
impl<S: Scalar> Reads<S> for S {
    #[inline(always)]
    fn read(x: S) -> S {
        x
    }
}
impl<S: Scalar> Reads<S> for Dual<S, 1> {
    #[inline(always)]
    fn read(x: S) -> Self {
        Dual::lift(x)
    }
}

/// The values of a column at one speed, by frequency.
struct AtSpeed<'a, S> {
    column: &'a Column<'a, S>,
    rows: &'a [usize],
}
impl<S: Scalar, T: Reads<S>> Ordinates<T> for AtSpeed<'_, S> {
    #[inline(always)]
    fn at(&self, k: usize) -> T {
        T::read(self.column.at(self.rows[k]))
    }
}

/// Values at one frequency, by speed.
struct Known<'a, T>(&'a [T]);
impl<T: Scalar> Ordinates<T> for Known<'_, T> {
    #[inline(always)]
    fn at(&self, k: usize) -> T {
        self.0[k]
    }
}

impl Grid {
    /// From the speed and the frequency of every row (rad/s), with the speeds in rising order; every mistake is one sentence.
    pub fn new(speed: &[f64], frequency: &[f64]) -> Result<(Knots, Self), Vec<Text>> {
        let shown = |w: f64| text::quantity(w, "rad/s");
        if let Some(row) = speed.iter().position(|w| !w.is_finite()) {
            return Err(vec![text!("column {name}: row {number} is not a finite number", name = "speed", number = row + 1)]);
        }
        if let Some(row) = frequency.iter().position(|f| *f < 0.0) {
            return Err(vec![text!(
                "frequencies of vibration are not negative: row {number} has {frequency}",
                number = row + 1,
                frequency = shown(frequency[row])
            )]);
        }
        let [speeds, frequencies] = [speed, frequency].map(|all| {
            let mut all = all.to_vec();
            ascending(&mut all);
            all.dedup();
            all
        });
        if frequencies.len() < 2 {
            return Err(vec![text!(
                "a table over speed and frequency has at least two frequencies; leave frequency out where the coefficients do not depend on it"
            )]);
        }
        if speeds.len() < 2 {
            return Err(vec![text!("a table over speed and frequency has at least two speeds")]);
        }
        let mut rows = vec![None; speeds.len() * frequencies.len()];
        let mut wrong = Vec::new();
        for (row, (w, f)) in speed.iter().zip(frequency).enumerate() {
            let at = |all: &[f64], x: f64| all.partition_point(|y| *y < x);
            let place = &mut rows[at(&speeds, *w) * frequencies.len() + at(&frequencies, *f)];
            match *place {
                None => *place = Some(row),
                Some(first) => wrong.push(text!(
                    "rows {first} and {second} are of one speed and frequency: {speed} and {frequency}",
                    first = first + 1,
                    second = row + 1,
                    speed = shown(*w),
                    frequency = shown(*f)
                )),
            }
        }
        let absent: Vec<usize> = (0..rows.len()).filter(|&k| rows[k].is_none()).collect();
        if let Some(&first) = absent.first() {
            let (speed, frequency) = (shown(speeds[first / frequencies.len()]), shown(frequencies[first % frequencies.len()]));
            let (count, all) = (absent.len(), rows.len());
            wrong.push(match count {
                1 => text!(
                    "every speed of the table has all its frequencies, {all} rows: that of {speed} at {frequency} is missing",
                    all,
                    speed,
                    frequency
                ),
                _ => text!(
                    "every speed of the table has all its frequencies, {all} rows: {count} are missing, the first of {speed} at {frequency}",
                    all,
                    count,
                    speed,
                    frequency
                ),
            });
        }
        let rows: Option<Vec<usize>> = rows.into_iter().collect();
        match (Knots::new(&speeds), Knots::new(&frequencies), rows, wrong.is_empty()) {
            (Ok(speeds), Ok(frequencies), Some(rows), true) => Ok((speeds, Grid { frequencies, rows })),
            _ => Err(wrong),
        }
    }

    /// The same with other outsides.
    pub fn map_frequencies(self, f: impl Fn(Knots) -> Knots) -> Self {
        Grid { frequencies: f(self.frequencies), ..self }
    }

    /// First and last frequency.
    pub fn range(&self) -> (f64, f64) {
        self.frequencies.range()
    }

    /// The coefficients at a speed and a frequency.
    #[inline(always)]
    pub fn values<S: Scalar, T: Reads<S>>(&self, speeds: &Knots, rows: &[TableRow<S>], speed: T, frequency: T) -> [T; 8] {
        let mut known = vec![T::zero(); speeds.count()];
        let mut out = [T::zero(); 8];
        for i in 0..NAMES.len() {
            let column = Column(rows, i);
            if !column.is_empty() {
                out[i] = T::apart(OnGrid { grid: self, speeds, column, speed, frequency, known: &mut known });
            }
        }
        out
    }
}

/// A column at a speed and a frequency: one function for all eight.
struct OnGrid<'a, S, T> {
    grid: &'a Grid,
    speeds: &'a Knots,
    column: Column<'a, S>,
    speed: T,
    frequency: T,
    /// Storage for values at the frequency, by speed.
    known: &'a mut [T],
}

impl<S: Scalar, T: Reads<S>> Routine for OnGrid<'_, S, T> {
    type Out = T;
    #[inline(always)]
    fn run(self) -> T {
        let OnGrid { grid, speeds, column, speed, frequency, known } = self;
        let count = grid.frequencies.count();
        for k in speeds.rests_on(speed) {
            let at_speed = AtSpeed { column: &column, rows: &grid.rows[k * count..(k + 1) * count] };
            known[k] = grid.frequencies.value_and_slope(&at_speed, frequency).0;
        }
        speeds.value_and_slope(&Known(known), speed).0
    }
}
