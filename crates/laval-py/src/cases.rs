//! Many machines: cases computed in pieces, and read back lazily.

use crate::arrow;
use crate::attend::{Watch, attended, attended_on};
use crate::errors;
use crate::machine::Machine;
use crate::pool;
use crate::table::{Held, Table};
use laval::cases;
use laval::diagnostic::{Diagnostic, Diagnostics};
use laval::file::Loaded;
use laval::outcome::{self, Arg};
use laval::output_folder::{Lasting, write_whole};
use laval::plain;
use laval::store::{self, Cells, Chunk, Kind, MISSING, NO_RESULT, Piece, Reader, Work};
use laval::study::{Cancel, Context};
use laval::text;
use pyo3::exceptions::{PyBlockingIOError, PyIndexError, PyKeyError, PyOSError, PyValueError};
use pyo3::prelude::*;
use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::sync::Arc;

/// Writes a file that is whole or not there, also when the power fails.
#[pyfunction]
pub fn put(py: Python<'_>, path: PathBuf, content: &[u8]) -> PyResult<()> {
    py.detach(|| write_whole(&path, content, Lasting::PowerLoss)).map_err(|e| PyOSError::new_err((e.raw_os_error(), e.to_string(), path)))
}

/// Cases in a file where the request does not say it.
#[pyfunction]
pub fn chunk_of(cases: usize) -> usize {
    cases::chunk_of(cases)
}

/// A request for many machines: what is computed for which cases.
#[pyclass(frozen, module = "laval._native")]
pub struct Cases {
    loaded: Arc<Loaded>,
    request: cases::Request,
    folder: Option<PathBuf>,
    plan: store::Plan,
}

/// What a folder refuses.
fn refused(d: &Diagnostic) -> PyErr {
    let said = plain::line(&d.to_string()).into_owned();
    match d.code {
        "folder.locked" => PyBlockingIOError::new_err(said),
        _ => PyOSError::new_err(said),
    }
}

impl Cases {
    fn made(&self) -> Result<cases::Cases<'_>, Diagnostics> {
        cases::Cases::new(&self.loaded, self.request.clone(), self.folder.as_deref())
    }

    fn folder(&self) -> PyResult<PathBuf> {
        self.folder.clone().ok_or_else(|| PyValueError::new_err("these cases have no folder"))
    }

    fn reader(&self) -> PyResult<Reader> {
        let rows = self.folder()?.join(cases::KIND);
        let made = self.made().map_err(|found| request(&found))?;
        Ok(Reader::new(made.plan(), &made.keep(&rows, Work::Collect)))
    }

    /// Columns by name, all without names.
    fn columns_of(&self, names: Option<Vec<String>>) -> PyResult<Vec<usize>> {
        let all = &self.plan.columns;
        let Some(names) = names else { return Ok((0..all.len()).collect()) };
        if names.iter().enumerate().any(|(k, name)| names[..k].contains(name)) {
            return Err(PyValueError::new_err("a column is named twice"));
        }
        let place = |name: &String| all.iter().position(|c| c.name == *name).ok_or_else(|| PyKeyError::new_err(name.clone()));
        names.iter().map(place).collect()
    }
}

fn request(found: &Diagnostics) -> PyErr {
    PyValueError::new_err(found.0.iter().map(|d| plain::line(&d.to_string()).into_owned()).collect::<Vec<_>>().join("\n"))
}

/// Rows as a table.
fn table(columns: &[store::Column], wanted: &[usize], cells: &[Cells]) -> Result<outcome::Table, String> {
    let mut out = outcome::Table::new(cases::KIND, text!("one machine in each row"));
    for &k in wanted {
        let c = &columns[k];
        let doc = Arg::term(c.doc.as_str());
        out = match (c.kind, cells.get(k).cloned()) {
            (_, Some(Cells::Float(v))) => out.float(&c.name, &c.unit, doc, v),
            (_, Some(Cells::Int(v))) => out.int(&c.name, &c.unit, doc, v.into_iter().map(Option::unwrap_or_default).collect()),
            (_, Some(Cells::Text(v))) => out.text(&c.name, doc, v.into_iter().map(Option::unwrap_or_default).collect()),
            (Kind::Float, None) => out.float(&c.name, &c.unit, doc, Vec::new()),
            (Kind::Int, None) => out.int(&c.name, &c.unit, doc, Vec::new()),
            (Kind::Text, None) => out.text(&c.name, doc, Vec::new()),
        };
    }
    out.build().map_err(|e| e.to_string())
}

fn own(columns: &[store::Column], wanted: &[usize], chunk: Option<Chunk>) -> Result<Held, String> {
    table(columns, wanted, &chunk.map(|c| c.cells).unwrap_or_default()).map(Held::Own)
}

#[pymethods]
impl Cases {
    /// Of a machine; the request is JSON.
    #[new]
    fn new(py: Python<'_>, machine: &Machine, request: &str, folder: Option<PathBuf>) -> PyResult<Self> {
        let loaded = machine.loaded.clone();
        let request: cases::Request = serde_json::from_str(request).map_err(|e| PyValueError::new_err(e.to_string()))?;
        let plan = cases::Cases::new(&loaded, request.clone(), folder.as_deref()).map(|made| made.plan());
        let plan = plan.map_err(|found| errors::mistakes(py, &found, "", "cases"))?;
        Ok(Cases { loaded, request, folder, plan })
    }

    /// Number of cases.
    #[getter]
    fn rows(&self) -> usize {
        self.plan.rows
    }

    /// Rows of a chunk.
    #[getter]
    fn chunk(&self) -> usize {
        self.plan.chunk
    }

    /// Number of chunks.
    #[getter]
    fn chunks(&self) -> usize {
        self.plan.chunks()
    }

    /// Name, unit and explanation of each column.
    #[getter]
    fn columns(&self) -> Vec<(&str, &str, &str)> {
        self.plan.columns.iter().map(|c| (c.name.as_str(), c.unit.as_str(), c.doc.as_str())).collect()
    }

    /// Name and unit of the numbers that should have a column.
    fn numbers(&self, py: Python<'_>) -> PyResult<Vec<(String, String)>> {
        let (cancel, watch) = (Cancel::default(), Watch::default());
        let context = Context { name: cases::KIND, cancel: &cancel, progress: &watch, work_limit: u64::MAX, keep: None };
        let run = attended(py, &cancel, &watch, None, || self.made()?.numbers(&context).map_err(|d| Diagnostics(vec![d])))?;
        if let Some(e) = run.stopped_by {
            return Err(e);
        }
        let found = run.result.map_err(|_| errors::defect("the first cases failed"))?;
        let found = found.map_err(|found| errors::mistakes(py, &found, "", "cases"))?;
        Ok(found.into_iter().map(|n| (n.name, n.unit)).collect())
    }

    /// Computes missing rows, those of one piece where it is given, on so many threads; returns remarks, as on files that were damaged.
    #[pyo3(signature = (piece, threads, progress))]
    fn run(
        &self,
        py: Python<'_>,
        piece: Option<(usize, usize)>,
        threads: Option<NonZeroUsize>,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Vec<String>> {
        let work = match piece {
            None => Work::Missing,
            Some((number, of)) => {
                let piece = Piece::new(number, of);
                Work::Piece(piece.ok_or_else(|| PyValueError::new_err(format!("parts are numbered from 1 to {of}, not {number}")))?)
            }
        };
        self.work(py, work, threads, progress).map(|(notes, _)| notes)
    }

    /// Joins the chunks; says what is missing.
    fn collect(&self, py: Python<'_>) -> PyResult<(Vec<String>, Option<String>)> {
        self.work(py, Work::Collect, None, None)
    }

    /// Whether the file of each chunk is there.
    fn present(&self, py: Python<'_>) -> PyResult<Vec<bool>> {
        let reader = self.reader()?;
        Ok(py.detach(|| (0..self.plan.chunks()).map(|k| reader.file(k).is_file()).collect()))
    }

    /// The file of a chunk.
    fn file(&self, index: usize) -> PyResult<PathBuf> {
        if index >= self.plan.chunks() {
            return Err(PyIndexError::new_err("there is no such chunk"));
        }
        Ok(self.reader()?.file(index))
    }

    /// A chunk, some of its columns where they are named; `None` where it is not there.
    fn read(&self, py: Python<'_>, index: usize, columns: Option<Vec<String>>) -> PyResult<Option<Table>> {
        if index >= self.plan.chunks() {
            return Err(PyIndexError::new_err("there is no such chunk"));
        }
        let (reader, wanted) = (self.reader()?, self.columns_of(columns)?);
        let Some(chunk) = py.detach(|| reader.chunk(index)).map_err(|d| refused(&d))? else { return Ok(None) };
        own(&self.plan.columns, &wanted, Some(chunk)).map(|held| Some(Table::new(held))).map_err(errors::defect)
    }

    /// A stream of the chunks that are there, each read when it is wanted (Arrow PyCapsule interface).
    fn stream<'py>(&self, py: Python<'py>, columns: Option<Vec<String>>) -> PyResult<Bound<'py, PyAny>> {
        let (reader, wanted) = (self.reader()?, self.columns_of(columns)?);
        let plan = self.plan.clone();
        let like = Arc::new(own(&plan.columns, &wanted, None).map_err(errors::defect)?);
        let mut left = 0..plan.chunks();
        let next = move || loop {
            let Some(index) = left.next() else { return Ok(None) };
            if let Some(chunk) = reader.chunk(index).map_err(|d| d.to_string())? {
                return own(&plan.columns, &wanted, Some(chunk)).map(|held| Some(Arc::new(held)));
            }
        };
        arrow::capsule(py, arrow::stream_of(like, Box::new(next)))
    }

    /// The columns, some where they are named, as a schema of Arrow.
    fn schema<'py>(&self, py: Python<'py>, columns: Option<Vec<String>>) -> PyResult<Bound<'py, PyAny>> {
        let wanted = self.columns_of(columns)?;
        let like = own(&self.plan.columns, &wanted, None).map_err(errors::defect)?;
        arrow::capsule(py, arrow::schema(like.get()))
    }
}

impl Cases {
    /// Remarks, and what is missing.
    fn work(
        &self,
        py: Python<'_>,
        work: Work,
        threads: Option<NonZeroUsize>,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<(Vec<String>, Option<String>)> {
        let rows = self.folder()?.join(cases::KIND);
        let pool = threads.map_or_else(pool::take, pool::of)?;
        let (cancel, watch) = (Cancel::default(), Watch::default());
        watch.begin(cases::KIND);
        let run = attended_on(&pool, py, &cancel, &watch, progress, || {
            let made = self.made()?;
            let keep = made.keep(&rows, work);
            let context = Context { name: cases::KIND, cancel: &cancel, progress: &watch, work_limit: u64::MAX, keep: Some(&keep) };
            // the folder is free again before anybody hears of the end
            made.run(&context).map(drop).map_err(|d| Diagnostics(vec![d]))
        })?;
        if let Some(e) = run.stopped_by {
            return Err(e);
        }
        match run.result.map_err(|_| errors::defect("the cases failed"))? {
            Ok(()) => Ok((watch.notes(), None)),
            Err(found) => match found.0.first() {
                Some(d) if d.code == NO_RESULT => Ok((watch.notes(), None)),
                Some(d) if d.code == MISSING => Ok((watch.notes(), Some(plain::line(&d.message.to_string()).into_owned()))),
                Some(d) => Err(refused(d)),
                None => Err(errors::defect("the cases failed")),
            },
        }
    }
}
