//! A machine file that was read and assembled.

use crate::attend::{Watch, attended};
use crate::errors;
use crate::results::Results;
use crate::session::{Ran, Session};
use laval::file::{self, Loaded, catalog, diagnostics_json};
use laval::hash::sha256;
use laval::import::ross;
use laval::outcome::Arg;
use laval::plain;
use laval::report;
use laval::study::Cancel;
use pyo3::exceptions::{PyBaseException, PyValueError};
use pyo3::prelude::*;
use serde_json::{Map, Value, json};
use std::path::PathBuf;
use std::sync::Arc;
use toml::de::{DeTable, DeValue};

/// A machine file that was read and assembled.
#[pyclass(frozen, module = "laval._native")]
pub struct Machine {
    pub(crate) loaded: Arc<Loaded>,
    /// Its text as it was given.
    #[pyo3(get)]
    source: String,
    /// The name by which results refer to it.
    #[pyo3(get)]
    origin: String,
    hash: String,
}

/// Reads and assembles the content of a machine file; `origin` is the name by which results refer to it.
#[pyfunction]
pub fn read(py: Python<'_>, content: &[u8], origin: &str) -> PyResult<Machine> {
    let source = String::from_utf8_lossy(content).into_owned();
    let loaded = py.detach(|| file::load_bytes(content)).map_err(|found| errors::mistakes(py, &found, &source, origin))?;
    Ok(Machine { loaded: Arc::new(loaded), source, origin: origin.into(), hash: format!("sha256:{}", sha256(content)) })
}

/// Makes the text of a machine file of a rotor that ROSS has saved.
#[pyfunction]
pub fn from_ross(py: Python<'_>, content: &[u8], name: &str) -> PyResult<String> {
    let imported = py.detach(|| ross::import(content, name));
    imported.map(|i| i.text).map_err(|found| errors::mistakes(py, &found, &String::from_utf8_lossy(content), name))
}

/// How a run ended early.
type Stopped = Option<Py<PyBaseException>>;

#[pymethods]
impl Machine {
    /// The machine file in canonical form: complete, exact, the same for equal machines.
    fn canonical(&self) -> String {
        file::write(&self.loaded.spec, catalog())
    }

    /// Name for titles.
    #[getter]
    fn name(&self) -> &str {
        &self.loaded.system.machine.name
    }

    /// Speed for studies that name none, rad/s.
    #[getter]
    fn speed(&self) -> Option<f64> {
        self.loaded.system.machine.speed
    }

    /// What the file says, as JSON: values as they are written there, blocks with their names.
    fn tree(&self) -> PyResult<String> {
        let table = DeTable::parse(&self.source).map_err(|e| PyValueError::new_err(e.to_string()))?;
        let mut root = object(table.into_inner());
        for (word, blocks) in [("part", &self.loaded.spec.parts), ("study", &self.loaded.spec.studies)] {
            let list = root.get_mut(word).and_then(Value::as_array_mut).into_iter().flatten();
            for (written, block) in list.zip(blocks) {
                written["name"] = json!(block.name);
            }
        }
        Ok(Value::Object(root).to_string())
    }

    /// The same with all values in SI units, defaults filled in.
    fn values(&self) -> String {
        file::write_json(&self.loaded.spec).to_string()
    }

    /// Remarks of reading, as JSON.
    fn warnings(&self) -> String {
        diagnostics_json(&self.loaded.warnings, &self.source).to_string()
    }

    /// Names of coordinates and of internal states.
    fn coordinates(&self) -> (Vec<String>, Vec<String>) {
        let names = |list: &[laval::model::system::GlobalDof]| list.iter().map(|c| c.name.clone()).collect();
        (names(self.loaded.system.coordinates()), names(self.loaded.system.states()))
    }

    /// Path, SI unit and value of every parameter.
    fn parameters(&self) -> Vec<(String, &'static str, f64)> {
        let system = &self.loaded.system;
        system.param_slots().iter().zip(system.params()).map(|(s, &x)| (s.name.clone(), s.unit, x)).collect()
    }

    /// Name and kind of every study.
    fn studies(&self) -> Vec<(String, &'static str)> {
        self.loaded.studies.iter().map(|s| (s.name.clone(), s.study.kind())).collect()
    }

    /// Runs studies. Returns their results, reasons of refusals as JSON, and the exception that ended the run early.
    fn run(
        &self,
        py: Python<'_>,
        only: Vec<String>,
        folder: Option<PathBuf>,
        fresh: bool,
        work_limit: Option<u64>,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<(Results, String, Stopped)> {
        let chosen = self.loaded.chosen(&only).map_err(|d| errors::request(&d))?;
        let names: Vec<&str> = self.loaded.spec.studies.iter().map(|b| b.name.as_str()).collect();
        // held until the end: the files of two runs at once would be mixed
        let held = folder.as_ref().map(|dir| report::prepare(dir, &names)).transpose().map_err(|d| errors::folder(&d))?;
        let (cancel, watch) = (Cancel::default(), Watch::default());
        let session = Session { loaded: &self.loaded, chosen: &chosen, folder, fresh, work_limit: work_limit.unwrap_or(u64::MAX) };
        let run = attended(py, &cancel, &watch, progress, || session.run(&cancel, &watch))?;
        drop(held);
        let ran: Ran = run.result.map_err(|_| errors::defect("the run failed"))?;
        if let Some(study) = ran.defects.first() {
            return Err(errors::defect(format!("study \"{study}\" failed")));
        }
        let refusals = diagnostics_json(&laval::diagnostic::Diagnostics(ran.refusals), &self.source).to_string();
        let settings = work_limit.map(|n| ("work limit".to_string(), n.to_string())).into_iter().collect();
        let stopped = run.stopped_by.map(|e| e.into_value(py));
        let results = Results::new(self.loaded.clone(), chosen, self.report(ran.outcomes, settings), stopped.is_some(), watch.notes());
        Ok((results, refusals, stopped))
    }
}

impl Machine {
    pub fn report(&self, outcomes: Vec<laval::outcome::Outcome>, settings: Vec<(String, String)>) -> report::Report {
        report::Report {
            machine: self.loaded.system.machine.name.clone(),
            provenance: report::Provenance {
                version: env!("CARGO_PKG_VERSION").into(),
                build: laval::build::ID.into(),
                processor: laval::build::processor().into(),
                input_name: self.origin.clone(),
                input_hash: self.hash.clone(),
                settings,
                seed: None,
            },
            input: Some(self.source.clone()),
            studies: self.loaded.spec.studies.iter().map(|b| b.name.clone()).collect(),
            outcomes,
            overview: None,
            style: crate::results::style(&self.loaded, &self.source),
        }
    }
}

/// A table in the order in which it is written.
fn object(table: DeTable<'_>) -> Map<String, Value> {
    let mut entries: Vec<_> = table.into_iter().collect();
    entries.sort_by_key(|(key, _)| key.span().start);
    entries.into_iter().map(|(key, value)| (key.into_inner().into_owned(), written(value.into_inner()))).collect()
}

/// A value as it is written; what is no value of a machine file is null.
fn written(value: DeValue<'_>) -> Value {
    match value {
        DeValue::String(s) => json!(s),
        DeValue::Integer(i) => i64::from_str_radix(i.as_str(), i.radix()).map_or(Value::Null, Value::from),
        DeValue::Float(x) => x.as_str().parse::<f64>().map_or(Value::Null, Value::from),
        DeValue::Boolean(b) => json!(b),
        DeValue::Datetime(_) => Value::Null,
        DeValue::Array(list) => list.into_iter().map(|v| written(v.into_inner())).collect(),
        DeValue::Table(t) => Value::Object(object(t)),
    }
}

/// A value that a sentence names, for people.
pub fn shown(style: &report::Style, arg: &Arg) -> String {
    plain::line(&style.arg(arg)).into_owned()
}
