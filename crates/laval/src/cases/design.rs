//! Which machines: the values of the parameters of each case, by its number.

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::hash::sha256;
use crate::model::system::System;
use crate::study::uncertainty::{Uncertain, Uncertainty};
use crate::text;
use laval_num::sampling::latin::Latin;
use laval_num::sampling::{MOST_DIMENSIONS, Points};
use serde::{Deserialize, Serialize};
use serde_json::{Value as Json, json};
use std::fs::File;
use std::io::{Read, Seek, SeekFrom};
use std::ops::Range;
use std::path::{Path, PathBuf};

/// File of the values of a list, beside the cases.
pub const LIST: &str = "list.f64";

/// A design as it is written down.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum Written {
    /// Every combination of the values of the axes; those of the last axis follow each other.
    Grid {
        /// Parameters and their values, SI.
        axes: Vec<(String, Vec<f64>)>,
    },
    /// Points of Sobol's sequence.
    Sobol(Spread),
    /// A Latin hypercube.
    LatinHypercube(Spread),
    /// Independent random points.
    Random(Spread),
    /// A list of cases.
    List {
        /// Its columns.
        parameters: Vec<String>,
        /// Number of cases.
        cases: usize,
        /// SHA-256 of the values of each chunk.
        sums: Vec<String>,
    },
}

/// Points spread over distributions.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Spread {
    /// Number of points.
    pub cases: usize,
    /// Another seed gives other points.
    pub seed: u32,
    /// Parameters with their distributions, as the study `uncertainty` has them.
    pub parameters: Json,
}

/// Paths with their units.
type Parameters = Vec<(String, &'static str)>;

enum Cloud {
    Points(Points),
    Latin,
}

/// A design for a machine.
pub struct Design {
    kind: Kind,
    /// Paths and units of the parameters.
    pub parameters: Parameters,
    /// Number of cases.
    pub cases: usize,
}

enum Kind {
    Grid(Vec<Vec<f64>>),
    Cloud { cloud: Cloud, seed: u32, spread: Vec<Uncertain> },
    List { file: PathBuf, sums: Vec<String> },
}

fn wrong(message: text::Text) -> Diagnostic {
    Diagnostic::error("cases.design", message)
}

impl Design {
    /// For this machine; a list has its values in `folder`.
    pub fn new(written: &Written, system: &System, folder: Option<&Path>) -> Result<Design, Diagnostics> {
        let (kind, parameters, cases) = match written {
            Written::Grid { axes } => {
                let named: Vec<&String> = axes.iter().map(|a| &a.0).collect();
                let mut cases = 1usize;
                for (path, values) in axes {
                    if let Some(x) = values.iter().find(|x| !x.is_finite()) {
                        return Err(one(wrong(text!("{path}: {x} is no value", path, x = x.to_string()))));
                    }
                    let more = cases.checked_mul(values.len());
                    cases = more.ok_or_else(|| one(wrong(text!("the grid has more points than can be counted"))))?;
                }
                (Kind::Grid(axes.iter().map(|a| a.1.clone()).collect()), with_units(system, &named)?, cases)
            }
            Written::Sobol(s) => cloud(system, s, Cloud::Points(Points::Sobol))?,
            Written::Random(s) => cloud(system, s, Cloud::Points(Points::Random))?,
            Written::LatinHypercube(s) => cloud(system, s, Cloud::Latin)?,
            Written::List { parameters, cases, sums } => {
                let folder = folder.ok_or_else(|| one(wrong(text!("the values of a list lie in the folder of its cases"))))?;
                let named: Vec<&String> = parameters.iter().collect();
                (Kind::List { file: folder.join(LIST), sums: sums.clone() }, with_units(system, &named)?, *cases)
            }
        };
        if cases == 0 || parameters.is_empty() {
            return Err(one(wrong(text!("the design has no case"))));
        }
        if u32::try_from(cases).is_err() {
            return Err(one(wrong(text!("{cases} cases are more than can be numbered", cases))));
        }
        Ok(Design { kind, parameters, cases })
    }

    /// Values of the parameters in these cases, case by case; `chunk` is their chunk.
    pub fn values(&self, cases: Range<usize>, chunk: usize) -> Result<Vec<Vec<f64>>, Diagnostic> {
        match &self.kind {
            Kind::Grid(axes) => Ok(cases.map(|case| on_grid(axes, case)).collect()),
            Kind::Cloud { cloud, seed, spread } => {
                let (seed, rows) = (*seed, u32::try_from(self.cases).unwrap_or(u32::MAX));
                let at = |case: usize, d: usize| match cloud {
                    Cloud::Points(points) => points.at(seed, case as u32, d as u32),
                    Cloud::Latin => Latin { seed, rows }.at(case as u32, d as u32),
                };
                let of = |case| spread.iter().enumerate().map(|(d, p)| p.distribution.quantile(at(case, d))).collect();
                Ok(cases.map(of).collect())
            }
            Kind::List { file, sums } => self.listed(file, sums.get(chunk), cases),
        }
    }

    /// One case, whatever its chunk.
    pub fn of(&self, case: usize, rows_of_a_chunk: usize) -> Result<Vec<f64>, Diagnostic> {
        let chunk = case / rows_of_a_chunk;
        match &self.kind {
            // the sum is that of the chunk
            Kind::List { .. } => {
                let first = chunk * rows_of_a_chunk;
                let mut all = self.values(first..(first + rows_of_a_chunk).min(self.cases), chunk)?;
                Ok(all.swap_remove(case - first))
            }
            _ => Ok(self.values(case..case + 1, chunk)?.swap_remove(0)),
        }
    }

    fn listed(&self, path: &Path, sum: Option<&String>, cases: Range<usize>) -> Result<Vec<Vec<f64>>, Diagnostic> {
        let width = self.parameters.len();
        let mut bytes = vec![0; cases.len() * width * 8];
        let mut read = || {
            let mut file = File::open(path)?;
            file.seek(SeekFrom::Start((cases.start * width * 8) as u64))?;
            file.read_exact(&mut bytes)
        };
        read().map_err(|e| Diagnostic::error("store.read", text!("cannot read {path}: {e}", path = path.display(), e)))?;
        if sum != Some(&sha256(&bytes)) {
            return Err(Diagnostic::error("store.read", text!("{path} is damaged", path = path.display())));
        }
        let numbers: Vec<f64> = bytes.as_chunks::<8>().0.iter().map(|b| f64::from_le_bytes(*b)).collect();
        Ok(numbers.chunks(width).map(<[f64]>::to_vec).collect())
    }
}

fn one(d: Diagnostic) -> Diagnostics {
    Diagnostics(vec![d])
}

fn cloud(system: &System, s: &Spread, cloud: Cloud) -> Result<(Kind, Parameters, usize), Diagnostics> {
    // the parameters are read as those of a study that knows distributions; which study it would run does not matter
    let fields = json!({ "study": { "kind": "modes", "speed": 1.0 }, "parameters": s.parameters });
    let spread = crate::file::construct::<Uncertainty>(system, &fields)?.parameters;
    if matches!(cloud, Cloud::Points(Points::Sobol)) && spread.len() > MOST_DIMENSIONS as usize {
        let (k, most) = (spread.len(), MOST_DIMENSIONS);
        return Err(one(wrong(text!("{k} parameters are more than the {most} dimensions of the Sobol sequence", k, most))));
    }
    let parameters = spread.iter().map(|u| (u.path.clone(), u.unit)).collect();
    Ok((Kind::Cloud { cloud, seed: s.seed, spread }, parameters, s.cases))
}

/// Paths with their units; says all that is wrong with them.
fn with_units(system: &System, paths: &[&String]) -> Result<Parameters, Diagnostics> {
    let (mut out, mut found) = (Vec::new(), Diagnostics::default());
    let mut taken: Vec<(usize, &String)> = Vec::new();
    for &path in paths {
        let Some(indices) = system.param(path) else {
            found.push(system.unknown_param(path));
            continue;
        };
        if let Some((_, first)) = taken.iter().find(|t| indices.contains(&t.0)) {
            found.push(wrong(text!("\"{first}\" and \"{second}\" are the same parameter", first = first.as_str(), second = path)));
        }
        out.push((path.clone(), indices.first().map_or("", |&i| system.param_slots()[i].unit)));
        taken.extend(indices.into_iter().map(|i| (i, path)));
    }
    if found.has_errors() { Err(found) } else { Ok(out) }
}

fn on_grid(axes: &[Vec<f64>], case: usize) -> Vec<f64> {
    let mut left = case;
    let mut out: Vec<f64> = axes
        .iter()
        .rev()
        .map(|axis| {
            let x = axis[left % axis.len()];
            left /= axis.len();
            x
        })
        .collect();
    out.reverse();
    out
}
