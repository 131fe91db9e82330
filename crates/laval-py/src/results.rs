//! What a run found out.

use crate::attend::{Watch, attended};
use crate::errors;
use crate::figure;
use crate::machine::{Machine, shown};
use crate::session::overview;
use crate::table::{Held, Table};
use laval::file::{self, Loaded};
use laval::outcome::{Arg, Check, Message, Outcome, Overview};
use laval::plain;
use laval::report::{self, Format, Language, Report, Style, Terminal, Units, WriteError};
use laval::study::{Cancel, presentation};
use pyo3::exceptions::{PyIndexError, PyOSError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};

/// Language and units of a machine file, else English and the units that the file writes. A library does not depend on the language of its environment.
pub fn style(loaded: &Loaded, source: &str) -> Style {
    let own = presentation::among(&loaded.system.machine.extras);
    let written = || file::written_units(source);
    let units = match own.units.as_deref() {
        None | Some("file") => Units::new(written()),
        Some("si") => Units::default(),
        Some(list) => Units::chosen(file::si_units(presentation::listed(list).map(String::from)), written()),
    };
    Style { language: own.language.and_then(|l| l.parse().ok()).unwrap_or_default(), units }
}

/// What a run found out.
#[pyclass(frozen, module = "laval._native")]
pub struct Results {
    loaded: Arc<Loaded>,
    chosen: Vec<usize>,
    report: Mutex<Arc<Report>>,
    /// The run was stopped: there is no first page.
    stopped: bool,
    /// Remarks on the run itself.
    #[pyo3(get)]
    notes: Vec<String>,
}

impl Results {
    pub fn new(loaded: Arc<Loaded>, chosen: Vec<usize>, report: Report, stopped: bool, notes: Vec<String>) -> Self {
        Results { loaded, chosen, report: Mutex::new(Arc::new(report)), stopped, notes }
    }

    fn report(&self) -> Arc<Report> {
        self.report.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// With the first page, which is computed when it is first needed.
    fn whole(&self, py: Python<'_>) -> PyResult<Arc<Report>> {
        let report = self.report();
        if self.stopped || report.overview.is_some() {
            return Ok(report);
        }
        let cancel = Cancel::default();
        let run = attended(py, &cancel, &Watch::default(), None, || overview(&self.loaded, &self.chosen, &report.outcomes, &cancel))?;
        if let Some(e) = run.stopped_by {
            return Err(e);
        }
        let page = run.result.map_err(|_| errors::defect("the first page failed"))?;
        drop(report);
        let mut kept = self.report.lock().unwrap_or_else(PoisonError::into_inner);
        // tables that are in use elsewhere stay where they are
        Arc::make_mut(&mut kept).overview = Some(page);
        Ok(kept.clone())
    }

    /// In this language.
    fn in_language(&self, report: Arc<Report>, language: Option<&str>) -> PyResult<Arc<Report>> {
        let style = self.style(language)?;
        if style == report.style { Ok(report) } else { Ok(Arc::new(Report { style, ..Report::clone(&report) })) }
    }

    fn style(&self, language: Option<&str>) -> PyResult<Style> {
        let mut style = self.report().style.clone();
        if let Some(code) = language {
            style.language = code.parse::<Language>().map_err(PyValueError::new_err)?;
        }
        Ok(style)
    }
}

/// A report as bytes: its machine is kept beside it, its first page is computed again where it is wanted.
#[derive(Serialize, Deserialize)]
struct Kept {
    provenance: (String, String, String, String, String),
    settings: Vec<(String, String)>,
    seed: Option<u64>,
    chosen: Vec<usize>,
    stopped: bool,
    notes: Vec<String>,
    outcomes: Vec<Outcome>,
}

/// Results of this machine from what [`Results::kept`] gave.
#[pyfunction]
pub fn again(machine: &Machine, build: &str, content: &[u8]) -> PyResult<Results> {
    // another build may lay them out differently
    if build != laval::build::ID {
        return Err(PyValueError::new_err(
            "these results were pickled by another build of laval: results are kept in folders, with Results.write",
        ));
    }
    let kept: Kept = postcard::from_bytes(content).map_err(|e| PyValueError::new_err(format!("these are no results: {e}")))?;
    if kept.chosen.iter().any(|&k| k >= machine.loaded.studies.len()) {
        return Err(PyValueError::new_err("these are no results of this machine"));
    }
    let (version, build, processor, input_name, input_hash) = kept.provenance;
    let provenance = report::Provenance { version, build, processor, input_name, input_hash, settings: kept.settings, seed: kept.seed };
    let report = Report { provenance, ..machine.report(kept.outcomes, Vec::new()) };
    Ok(Results::new(machine.loaded.clone(), kept.chosen, report, kept.stopped, kept.notes))
}

fn missing(what: &str) -> PyErr {
    PyIndexError::new_err(format!("there is no such {what}"))
}

fn study(report: &Report, study: usize) -> PyResult<&Outcome> {
    report.outcomes.get(study).ok_or_else(|| missing("study"))
}

#[pymethods]
impl Results {
    /// The text of `results.json`; without `whole` the first page may be missing.
    fn json(&self, py: Python<'_>, whole: bool) -> PyResult<String> {
        let report = if whole { self.whole(py)? } else { self.report() };
        Ok(py.detach(|| report::json(&report)))
    }

    /// Text and name of the machine, the build, and everything that was found out, for [`again`].
    fn kept(&self, py: Python<'_>) -> PyResult<(String, String, &'static str, Py<PyBytes>)> {
        let report = self.report();
        let p = report.provenance.clone();
        let kept = Kept {
            provenance: (p.version, p.build, p.processor, p.input_name.clone(), p.input_hash),
            settings: p.settings,
            seed: p.seed,
            chosen: self.chosen.clone(),
            stopped: self.stopped,
            notes: self.notes.clone(),
            outcomes: report.outcomes.clone(),
        };
        let bytes = postcard::to_stdvec(&kept).map_err(errors::defect)?;
        Ok((report.input.clone().unwrap_or_default(), p.input_name, laval::build::ID, PyBytes::new(py, &bytes).unbind()))
    }

    /// Verdict, headline and checks in words, as JSON.
    fn overview(&self, py: Python<'_>, language: Option<&str>) -> PyResult<String> {
        let (report, style) = (self.whole(py)?, self.style(language)?);
        Ok(report.overview.as_ref().map_or(Value::Null, |page| page_in_words(page, &style)).to_string())
    }

    /// The report as one page of HTML.
    fn html(&self, py: Python<'_>, language: Option<&str>) -> PyResult<String> {
        let report = self.in_language(self.whole(py)?, language)?;
        py.detach(|| report::html(&report)).map_err(errors::defect)
    }

    /// The first page of the report as HTML.
    fn first_page(&self, py: Python<'_>, language: Option<&str>) -> PyResult<String> {
        let report = self.in_language(self.whole(py)?, language)?;
        Ok(py.detach(|| report::page_one(&report)))
    }

    /// The first page as the terminal shows it.
    fn summary(&self, py: Python<'_>, language: Option<&str>, width: usize) -> PyResult<String> {
        let report = self.in_language(self.whole(py)?, language)?;
        Ok(report::summary(&report, Terminal { width, colour: false }))
    }

    /// A finding as sentences.
    fn sentence(&self, study_number: usize, finding: usize, language: Option<&str>) -> PyResult<String> {
        let (report, style) = (self.report(), self.style(language)?);
        let found = study(&report, study_number)?.findings.get(finding).ok_or_else(|| missing("finding"))?;
        Ok(plain::line(&style.sentence(found)).into_owned())
    }

    /// How a study ended, as a sentence.
    fn ending(&self, study_number: usize, language: Option<&str>) -> PyResult<String> {
        let (report, style) = (self.report(), self.style(language)?);
        Ok(plain::line(&style.message(&study(&report, study_number)?.end_message())).into_owned())
    }

    /// A table of a study.
    fn table(&self, study_number: usize, table: usize) -> PyResult<Table> {
        let report = self.report();
        study(&report, study_number)?.tables.get(table).ok_or_else(|| missing("table"))?;
        Ok(Table::new(Held::Reported(report, study_number, table)))
    }

    /// A figure of a study as JSON: what is drawn, over which columns.
    fn figure(&self, study_number: usize, figure: usize, language: Option<&str>) -> PyResult<String> {
        let (report, style) = (self.report(), self.style(language)?);
        let found = study(&report, study_number)?.figures.get(figure).ok_or_else(|| missing("figure"))?;
        Ok(figure::json(&style.units.figure(found), &style).to_string())
    }

    /// A figure of a study as SVG.
    fn svg(&self, py: Python<'_>, study_number: usize, figure: usize, language: Option<&str>) -> PyResult<String> {
        let (report, style) = (self.report(), self.style(language)?);
        let outcome = study(&report, study_number)?;
        let found = outcome.figures.get(figure).ok_or_else(|| missing("figure"))?;
        py.detach(|| report::draw_in(found, &outcome.tables, &style)).map_err(errors::defect)
    }

    /// Writes the files of `laval run` into a folder; returns their paths.
    fn write(&self, py: Python<'_>, folder: PathBuf, formats: Option<Vec<String>>, language: Option<&str>) -> PyResult<Vec<PathBuf>> {
        let formats: Vec<Format> = match formats {
            None => Format::ALL.to_vec(),
            Some(words) => words.iter().map(|w| w.parse().map_err(PyValueError::new_err)).collect::<PyResult<_>>()?,
        };
        let report = self.in_language(self.whole(py)?, language)?;
        let names: Vec<&str> = report.studies.iter().map(String::as_str).collect();
        let held = report::prepare(&folder, &names).map_err(|d| errors::folder(&d))?;
        let written = py.detach(|| report::renew(&folder, &report, &formats));
        drop(held);
        written.map_err(|e| match e {
            WriteError::Io { .. } => PyOSError::new_err(e.to_string()),
            WriteError::Outcome { .. } => errors::defect(e),
        })
    }
}

fn page_in_words(page: &Overview, style: &Style) -> Value {
    let say = |m: &Message| shown(style, &Arg::Phrase(m.clone()));
    let check = |c: &Check| {
        json!({
            "check": c.what.key,
            "verdict": c.verdict.word(),
            "title": say(&c.what),
            "result": say(&c.result),
            "detail": c.detail.as_ref().map(say),
            "required": c.required.as_ref().map(|r| shown(style, r)),
            "margin": c.margin,
        })
    };
    json!({
        "verdict": page.verdict.word(),
        "operating_speed": page.operating,
        "headline": page.headline.iter().map(say).collect::<Vec<_>>().join(" "),
        "checks": page.checks.iter().map(check).collect::<Vec<_>>(),
        "next": page.next.iter().map(say).collect::<Vec<_>>(),
    })
}
