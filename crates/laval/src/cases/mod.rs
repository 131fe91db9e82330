//! Many machines: what one study finds for each of many cases, kept in chunks that any number of processes may compute.
//!
//! A case is the machine with other values of parameters, as a [design](Written) gives them by the number of the case. Its row holds these values and the
//! numbers that the study finds; a case without a machine or without a result is a row with the reason. All that settles the rows is written down in a
//! [`Request`], so that every process that reads it computes the same.

mod design;
#[cfg(test)]
mod tests;

pub use design::{LIST, Spread, Written};

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::file::{self, Loaded, NamedStudy};
use crate::model::system::System;
use crate::store::{self, Cells, Column, Keep, Plan, Work};
use crate::study::uncertainty::collect::{Quantity, Sample, encode, sample, with_sizes};
use crate::study::{Context, Silent};
use crate::text;
use design::Design;
use laval_num::work::Here;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use serde_json::json;
use std::collections::BTreeSet;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

/// The word of such a run in its files.
pub const KIND: &str = "cases";
/// Columns beside those of parameters and numbers.
const CASE: &str = "case";
const OTHERS: &str = "others";
const INVALID: &str = "invalid";
const FAILURE: &str = "failure";

/// A number that has a column.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Number {
    /// Its name, such as `critical_speed order 1 forward`.
    pub name: String,
    /// Its unit.
    pub unit: String,
}

/// What is computed, beside the machine.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Request {
    /// Name of the study in the machine file.
    pub study: String,
    /// Which cases.
    pub design: Written,
    /// Rows of a chunk; follows from the number of cases unless given.
    #[serde(default)]
    pub chunk: Option<usize>,
    /// Numbers that have a column; others stand together in one.
    #[serde(default)]
    pub numbers: Vec<Number>,
}

/// Many machines and what is computed for each.
pub struct Cases<'a> {
    loaded: &'a Loaded,
    study: &'a NamedStudy,
    design: Design,
    request: Request,
    chunk: usize,
}

/// Most files of a run, as the store has it, and how many there are where cases are many enough.
const MOST_CHUNKS: usize = 20_000;
const CHUNKS: usize = 256;
const LARGEST: usize = 1024;
/// Numbers in a file at most: a file is held in memory.
const LARGEST_FILE: usize = 20_000_000;

/// Cases in a file, settled by the number of cases alone: every run of them has the same files.
pub fn chunk_of(cases: usize) -> usize {
    cases.div_ceil(CHUNKS).clamp(1, LARGEST).max(cases.div_ceil(MOST_CHUNKS))
}

impl<'a> Cases<'a> {
    /// Of a machine; a list of cases has its values in `folder`.
    ///
    /// # Errors
    /// All that is wrong with the request.
    pub fn new(loaded: &'a Loaded, request: Request, folder: Option<&Path>) -> Result<Cases<'a>, Diagnostics> {
        let one = |d| Diagnostics(vec![d]);
        let study = loaded.studies.iter().find(|s| s.name == request.study);
        let missing = || Diagnostic::error("cases.study", text!("the machine has no study \"{name}\"", name = request.study.as_str()));
        let study = study.ok_or_else(|| one(missing()))?;
        study.study.admit(&loaded.system).map_err(one)?;
        let design = Design::new(&request.design, &loaded.system, folder)?;
        let chunk = request.chunk.unwrap_or_else(|| chunk_of(design.cases));
        let out = Cases { loaded, study, design, request, chunk };
        // as the store would say it later
        let plan = out.plan();
        plan.check().map_err(one)?;
        let (rows, columns) = (plan.chunk.min(plan.rows), plan.columns.len());
        if rows.saturating_mul(columns) > LARGEST_FILE {
            let message = text!(
                "files of {rows} cases with {columns} numbers each are too large: at most {most} numbers in a file",
                rows,
                columns,
                most = LARGEST_FILE
            );
            return Err(one(Diagnostic::error("cases.chunk", message)));
        }
        Ok(out)
    }

    /// Number of cases.
    pub fn cases(&self) -> usize {
        self.design.cases
    }

    /// Files, rows and columns.
    pub fn plan(&self) -> Plan {
        let mut columns = vec![Column::int(CASE, "", "number of the case")];
        columns.extend(self.design.parameters.iter().map(|(path, unit)| Column::float(path, *unit, "value of the parameter")));
        columns.extend(self.request.numbers.iter().map(|n| Column::float(&n.name, &n.unit, "number found; NaN where there is none")));
        columns.extend([
            Column::text(OTHERS, "further numbers found, as JSON: name, value in SI units, unit"),
            Column::int(INVALID, "", "1 where a result lies outside the validity of a model"),
            Column::text(FAILURE, "why there are no numbers; empty where there are"),
        ]);
        Plan { study: KIND.into(), columns, rows: self.design.cases, chunk: self.chunk }
    }

    /// Where the rows are kept.
    pub fn keep(&self, folder: &Path, work: Work) -> Keep {
        let mut input = file::canonical(&self.loaded.spec, &self.request.study);
        let design = match &self.request.design {
            // the manifest names each chunk anyhow
            Written::List { parameters, cases, sums } => {
                json!({ "kind": "list", "parameters": parameters, "cases": cases, "sum": crate::hash::sha256(sums.concat().as_bytes()) })
            }
            other => json!(other),
        };
        input["cases"] = json!({ "design": design, "numbers": self.request.numbers });
        Keep { folder: folder.to_path_buf(), input, fresh: false, work }
    }

    /// The machine of a case.
    fn machine(&self, values: &[f64]) -> Result<System, Diagnostic> {
        let changes: Vec<(&str, f64)> = self.design.parameters.iter().zip(values).map(|(p, x)| (p.0.as_str(), *x)).collect();
        // a comparison with a bound may let one pass
        if let Some((path, x)) = changes.iter().find(|c| !c.1.is_finite()) {
            return Err(Diagnostic::error("cases.value", text!("{path}: {x} is no value", path = *path, x = x.to_string())));
        }
        self.loaded.system.with(&changes).map_err(Diagnostics::into_error)
    }

    fn sample(&self, machine: Result<System, Diagnostic>, context: &Context) -> Sample {
        let inner = Context { progress: &Silent, work_limit: u64::MAX, keep: None, ..*context };
        let found = catch_unwind(AssertUnwindSafe(|| sample(&*self.study.study, machine, &inner, with_sizes)));
        // one defect among a million cases is one row
        found.unwrap_or_else(|_| Sample::Failed("defect: the study failed; please report it with the machine".into()))
    }

    /// The numbers that get a column: those of the machine itself, and of the first case, one in the middle and the last.
    ///
    /// # Errors
    /// The reason of the machine itself where none of them has any; a list that cannot be read.
    pub fn numbers(&self, context: &Context) -> Result<Vec<Number>, Diagnostic> {
        let last = self.design.cases - 1;
        let probes: BTreeSet<usize> = [0, last / 2, last].into();
        let mut machines = vec![Ok(None)];
        machines.extend(probes.into_iter().map(|case| self.design.of(case, self.chunk).map(Some)));
        let values: Vec<Option<Vec<f64>>> = machines.into_iter().collect::<Result<_, _>>()?;
        let here = Here::now();
        let found: Vec<Sample> = values
            .into_par_iter()
            .map(|values| {
                let _counted = here.enter();
                self.sample(
                    values.map_or_else(|| self.loaded.system.with(&[]).map_err(Diagnostics::into_error), |v| self.machine(&v)),
                    context,
                )
            })
            .collect();
        if context.cancelled() {
            return Err(Diagnostic::error("cases.stopped", text!("stopped before the first case")));
        }
        let mut out: Vec<Number> = Vec::new();
        for sample in &found {
            let Sample::Found(list, _) = sample else { continue };
            for q in list {
                if !out.iter().any(|n| n.name == q.label) {
                    out.push(Number { name: q.label.clone(), unit: q.unit.clone() });
                }
            }
        }
        match found.into_iter().next() {
            Some(Sample::Failed(why)) if out.is_empty() => {
                Err(Diagnostic::error("cases.numbers", text!("the study has no numbers for this machine: {why}", why)))
            }
            _ => Ok(out),
        }
    }

    /// Computes the rows that are not there yet.
    ///
    /// # Errors
    /// As [`store::run`].
    pub fn run(&self, context: &Context) -> Result<store::Results, Diagnostic> {
        store::run(self.plan(), context, |range, counter| {
            let values = self.design.values(range.clone(), range.start / self.chunk)?;
            let here = Here::now();
            let one = |values: &Vec<f64>| {
                let _counted = here.enter();
                if counter.cancelled() {
                    return Sample::Stopped;
                }
                let found = self.sample(self.machine(values), context);
                counter.add(1);
                // a run that was stopped may end with an error of its own
                if counter.cancelled() { Sample::Stopped } else { found }
            };
            let found: Vec<Sample> = values.par_iter().map(one).collect();
            Ok(self.cells(range.start, &values, &found))
        })
    }

    /// A chunk for the store; `None` when it was stopped in between.
    fn cells(&self, first: usize, values: &[Vec<f64>], found: &[Sample]) -> Option<Vec<Cells>> {
        if found.contains(&Sample::Stopped) {
            return None;
        }
        let rows = values.len();
        let numbers = &self.request.numbers;
        let mut out = vec![Cells::Int((0..rows).map(|i| Some((first + i) as i64)).collect())];
        out.extend((0..self.design.parameters.len()).map(|p| Cells::Float(values.iter().map(|v| v[p]).collect())));
        let mut columns = vec![vec![f64::NAN; rows]; numbers.len()];
        let (mut others, mut invalid, mut failure) = (Vec::new(), Vec::new(), Vec::new());
        for (row, sample) in found.iter().enumerate() {
            let (mut rest, mut beyond, mut why) = (Vec::new(), false, String::new());
            match sample {
                Sample::Found(list, outside) => {
                    beyond = *outside;
                    for q in list {
                        match numbers.iter().position(|n| n.name == q.label && n.unit == q.unit) {
                            Some(k) => columns[k][row] = q.value,
                            None => rest.push(q.clone()),
                        }
                    }
                }
                Sample::Failed(reason) => why.clone_from(reason),
                Sample::Stopped => {}
            }
            others.push(Some(further(&rest)));
            invalid.push(Some(i64::from(beyond)));
            failure.push(Some(why));
        }
        out.extend(columns.into_iter().map(Cells::Float));
        out.extend([Cells::Text(others), Cells::Int(invalid), Cells::Text(failure)]);
        Some(out)
    }
}

fn further(list: &[Quantity]) -> String {
    if list.is_empty() { String::new() } else { encode(list) }
}
