//! What the samples gave, as numbers: values of every number found, and statistics of them.

use super::collect::{Quantity, cause, decode};
use super::{CONFIDENCE, Design, Uncertainty};
use crate::diagnostic::Diagnostic;
use crate::outcome::End;
use crate::store::{Extent, Results};
use laval_num::order::ascending;
use laval_num::sampling::distribution::normal_quantile;
use laval_num::sampling::morris::Effects;
use laval_num::sampling::quantile::{Interval, quantile, share};
use laval_num::sampling::sobol_indices::Indices;
use laval_num::sampling::{moments, morris, sobol_indices};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Numbers of a study for many machines.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct UncertaintyResult {
    /// None where the study was stopped before the machine as it is was known.
    pub found: Option<Found>,
    /// How the study ended.
    pub end: End,
}

/// The samples and their statistics.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Found {
    /// Numbers of the machine as it is.
    pub nominal: Vec<Quantity>,
    /// The samples that are there.
    pub samples: Samples,
    /// How many of those requested they are.
    pub extent: Extent,
    /// What was made of them.
    pub statistics: Statistics,
    /// By number: indices of Sobol, where requested.
    pub indices: Vec<Option<Shares>>,
}

/// What was made of the samples.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub enum Statistics {
    /// Distributions of the numbers.
    Spreads {
        /// By number.
        spreads: Vec<Spread>,
        /// Samples that are independent draws.
        drawn: usize,
        /// Those of them with a result.
        succeeded: usize,
    },
    /// By number and parameter: elementary effects of Morris.
    Effects(Vec<Vec<Effects>>),
}

/// Indices of Sobol of one number.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Shares {
    /// By parameter.
    pub each: Vec<Indices>,
    /// Base points used.
    pub used: usize,
}

/// All samples, column by column; numbers are NaN where a sample does not have them.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Samples {
    /// Values of each parameter.
    pub parameters: Vec<Vec<f64>>,
    /// Name and unit of each number found, the machine's own first.
    pub names: Vec<(String, String)>,
    /// Values of each number.
    pub values: Vec<Vec<f64>>,
    /// Samples with a result outside the validity of a model.
    pub invalid: usize,
    /// Failures by cause.
    pub failures: BTreeMap<String, Failure>,
    /// Whether a sample has no result.
    pub failed: Vec<bool>,
    /// Number of samples.
    pub count: usize,
}

/// Samples without a result, of one cause.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Failure {
    /// How many.
    pub count: usize,
    /// The first of them.
    pub first: usize,
    /// Its message.
    pub example: String,
}

/// Statistics of one number over the samples that are independent draws.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Spread {
    /// Samples in which it was found.
    pub count: usize,
    /// Smallest value; NaN without values.
    pub smallest: f64,
    /// Largest value; NaN without values.
    pub largest: f64,
    /// Mean and its interval.
    pub mean: Interval,
    /// Standard deviation.
    pub deviation: f64,
    /// Share of the samples with a result in which the number exists.
    pub share: Interval,
    /// Quantiles requested.
    pub quantiles: Vec<Interval>,
}

impl Found {
    /// From the rows that are there.
    ///
    /// # Errors
    /// Rows that cannot be read back.
    pub(super) fn new(study: &Uncertainty, nominal: Vec<Quantity>, results: &Results) -> Result<Self, Diagnostic> {
        let samples = Samples::read(study, &nominal, results)?;
        let inputs = study.parameters.len();
        let statistics = match study.design {
            Design::Morris => {
                let plan = morris::Plan { seed: study.seed, inputs };
                Statistics::Effects(samples.values.iter().map(|v| morris::effects(&plan, v, CONFIDENCE)).collect())
            }
            Design::Plain(_) | Design::Sobol(_) => {
                let drawn = (0..samples.count).filter(|&r| study.independent(r)).count();
                let succeeded = (0..samples.count).filter(|&r| study.independent(r) && !samples.failed[r]).count();
                let of = |v: &Vec<f64>| Spread::of(&study.sorted(v), succeeded, &study.quantiles);
                Statistics::Spreads { spreads: samples.values.iter().map(of).collect(), drawn, succeeded }
            }
        };
        let indices = match study.design {
            Design::Sobol(points) => {
                let plan = sobol_indices::Plan { points, seed: study.seed, inputs };
                let of = |v: &Vec<f64>| sobol_indices::indices(&plan, v, CONFIDENCE).map(|(each, used)| Shares { each, used });
                samples.values.iter().map(of).collect()
            }
            _ => Vec::new(),
        };
        Ok(Found { nominal, samples, extent: results.extent(), statistics, indices })
    }
}

impl Uncertainty {
    /// Of the runs for the indices the first two of each base point are independent draws.
    fn independent(&self, row: usize) -> bool {
        !matches!(self.design, Design::Sobol(_)) || row % self.runs() < 2
    }

    /// Values of a number that exist in independent draws, rising.
    pub(super) fn sorted(&self, values: &[f64]) -> Vec<f64> {
        let own = || values.iter().enumerate().filter(|(r, x)| self.independent(*r) && x.is_finite());
        let mut sorted: Vec<f64> = Vec::with_capacity(own().count());
        sorted.extend(own().map(|(_, x)| *x));
        ascending(&mut sorted);
        sorted
    }
}

impl Samples {
    fn read(study: &Uncertainty, nominal: &[Quantity], results: &Results) -> Result<Samples, Diagnostic> {
        let k = study.parameters.len();
        let rows = results.done() as usize;
        let columns = |n: usize| (0..n).map(|_| Vec::with_capacity(rows)).collect();
        let mut out = Samples {
            parameters: columns(k),
            names: nominal.iter().map(|q| (q.label.clone(), q.unit.clone())).collect(),
            values: columns(nominal.len()),
            invalid: 0,
            failures: BTreeMap::new(),
            failed: Vec::with_capacity(rows),
            count: 0,
        };
        let mut places: BTreeMap<String, usize> = nominal.iter().enumerate().map(|(i, q)| (q.label.clone(), i)).collect();
        for chunk in results.chunks() {
            let chunk = chunk?;
            for i in 0..chunk.rows.len() {
                for (p, column) in out.parameters.iter_mut().enumerate() {
                    column.push(chunk.cells[p + 1].number(i));
                }
                out.values.iter_mut().for_each(|v| v.push(f64::NAN));
                for q in decode(chunk.cells[k + 1].word(i).unwrap_or("{}")) {
                    let at = *places.entry(q.label.clone()).or_insert_with(|| {
                        out.names.push((q.label.clone(), q.unit.clone()));
                        out.values.push(vec![f64::NAN; out.count + 1]);
                        out.values.len() - 1
                    });
                    out.values[at][out.count] = q.value;
                }
                out.invalid += usize::from(chunk.cells[k + 2].number(i) == 1.0);
                let why = chunk.cells[k + 3].word(i);
                out.failed.push(why.is_some());
                if let Some(why) = why {
                    let sample = chunk.rows.start + i;
                    let first = || Failure { count: 0, first: sample, example: why.to_string() };
                    out.failures.entry(cause(why)).or_insert_with(first).count += 1;
                }
                out.count += 1;
            }
        }
        Ok(out)
    }
}

impl Spread {
    /// Of rising values.
    fn of(sorted: &[f64], succeeded: usize, quantiles: &[f64]) -> Spread {
        let (mean, deviation) = moments(sorted);
        let half = normal_quantile(0.5 + 0.5 * CONFIDENCE) * deviation / (sorted.len() as f64).sqrt();
        Spread {
            count: sorted.len(),
            smallest: sorted.first().copied().unwrap_or(f64::NAN),
            largest: sorted.last().copied().unwrap_or(f64::NAN),
            mean: Interval { value: mean, low: mean - half, high: mean + half },
            deviation,
            share: share(sorted.len(), succeeded, CONFIDENCE),
            quantiles: quantiles.iter().map(|&p| quantile(sorted, p, CONFIDENCE)).collect(),
        }
    }
}
