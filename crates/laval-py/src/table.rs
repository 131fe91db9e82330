//! Tables and their columns, shared with Python without a copy.

use crate::arrow;
use laval::outcome::{self, Arg, Data};
use laval::report::Report;
use pyo3::IntoPyObjectExt;
use pyo3::exceptions::{PyAttributeError, PyIndexError, PyKeyError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Arc;

/// Where a table lies.
pub enum Held {
    /// In a report: number of the study, number of the table.
    Reported(Arc<Report>, usize, usize),
    /// On its own.
    Own(outcome::Table),
}

impl Held {
    pub fn get(&self) -> &outcome::Table {
        match self {
            Held::Reported(report, study, table) => &report.outcomes[*study].tables[*table],
            Held::Own(table) => table,
        }
    }
}

/// A table: named columns of one length.
#[pyclass(frozen, module = "laval._native")]
pub struct Table(Arc<Held>);

impl Table {
    pub fn new(held: Held) -> Self {
        Table(Arc::new(held))
    }
}

#[pymethods]
impl Table {
    /// From name, explanation and columns of name, unit, explanation, kind and values.
    #[new]
    fn build(name: &str, doc: &str, columns: Vec<(String, String, String, String, Bound<'_, PyAny>)>) -> PyResult<Self> {
        let mut table = outcome::Table::new(name, Arg::name(doc));
        for (name, unit, doc, kind, values) in columns {
            let doc = Arg::name(doc);
            table = match kind.as_str() {
                "float" => table.float(name, unit, doc, values.extract()?),
                "int" => table.int(name, unit, doc, values.extract()?),
                "flag" => table.flag(name, doc, values.extract()?),
                "text" => table.text(name, doc, values.extract()?),
                _ => return Err(PyValueError::new_err("a column is float, int, flag or text")),
            };
        }
        table.build().map(|t| Table::new(Held::Own(t))).map_err(|e| PyValueError::new_err(e.to_string()))
    }

    #[getter]
    fn name(&self) -> &str {
        self.0.get().name()
    }

    #[getter]
    fn doc(&self) -> String {
        self.0.get().doc().to_string()
    }

    #[getter]
    fn rows(&self) -> usize {
        self.0.get().rows()
    }

    /// Names of the columns.
    #[getter]
    fn names(&self) -> Vec<&str> {
        self.0.get().columns().iter().map(|c| c.name.as_str()).collect()
    }

    fn column(&self, name: &str) -> PyResult<Column> {
        let at = self.0.get().columns().iter().position(|c| c.name == name);
        at.map(|k| Column { held: self.0.clone(), at: k }).ok_or_else(|| PyKeyError::new_err(name.to_string()))
    }

    /// The table as a stream of one record batch (Arrow PyCapsule interface).
    #[pyo3(signature = (requested_schema = None))]
    fn __arrow_c_stream__<'py>(&self, py: Python<'py>, requested_schema: Option<Bound<'py, PyAny>>) -> PyResult<Bound<'py, PyAny>> {
        // another schema is a wish that a producer may leave unfulfilled
        let _ = requested_schema;
        arrow::capsule(py, arrow::stream(self.0.clone()))
    }

    fn __arrow_c_schema__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        arrow::capsule(py, arrow::schema(self.0.get()))
    }
}

/// A column of a table.
#[pyclass(frozen, sequence, module = "laval._native")]
pub struct Column {
    held: Arc<Held>,
    at: usize,
}

impl Column {
    fn get(&self) -> &outcome::Column {
        &self.held.get().columns()[self.at]
    }
}

#[pymethods]
impl Column {
    #[getter]
    fn name(&self) -> &str {
        &self.get().name
    }

    /// SI unit; empty for a pure number, text or flag.
    #[getter]
    fn unit(&self) -> &str {
        &self.get().unit
    }

    #[getter]
    fn doc(&self) -> String {
        self.get().doc.to_string()
    }

    /// `float`, `int`, `flag` or `text`.
    #[getter]
    fn kind(&self) -> &'static str {
        match self.get().data {
            Data::Float(_) => "float",
            Data::Int(_) => "int",
            Data::Flag(_) => "flag",
            Data::Text(_) => "text",
        }
    }

    fn __len__(&self) -> usize {
        self.get().data.len()
    }

    fn __getitem__<'py>(&self, py: Python<'py>, row: isize) -> PyResult<Bound<'py, PyAny>> {
        let data = &self.get().data;
        let k = if row < 0 { row + data.len() as isize } else { row };
        let at = usize::try_from(k).ok().filter(|k| *k < data.len());
        let at = at.ok_or_else(|| PyIndexError::new_err(format!("the column has {} rows", data.len())))?;
        match data {
            Data::Float(v) => v[at].into_bound_py_any(py),
            Data::Int(v) => v[at].into_bound_py_any(py),
            Data::Flag(v) => v[at].into_bound_py_any(py),
            Data::Text(v) => v[at].as_str().into_bound_py_any(py),
        }
    }

    /// The values as a list.
    fn to_list<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        match &self.get().data {
            Data::Float(v) => v.into_bound_py_any(py),
            Data::Int(v) => v.into_bound_py_any(py),
            Data::Flag(v) => v.into_bound_py_any(py),
            Data::Text(v) => v.into_bound_py_any(py),
        }
    }

    /// The memory of numbers and flags, for NumPy; it holds this column as long as the view lasts.
    #[getter]
    fn __array_interface__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let (at, kind, length) = match &self.get().data {
            Data::Float(v) => (v.as_ptr() as usize, "f8", v.len()),
            Data::Int(v) => (v.as_ptr() as usize, "i8", v.len()),
            Data::Flag(v) => (v.as_ptr() as usize, "b1", v.len()),
            Data::Text(_) => return Err(PyAttributeError::new_err("texts have no array interface")),
        };
        let order = match kind {
            "b1" => '|',
            _ if cfg!(target_endian = "little") => '<',
            _ => '>',
        };
        let out = PyDict::new(py);
        out.set_item("version", 3)?;
        out.set_item("shape", (length,))?;
        out.set_item("typestr", format!("{order}{kind}"))?;
        out.set_item("data", (at, true))?;
        Ok(out)
    }

    #[pyo3(signature = (requested_schema = None))]
    fn __arrow_c_array__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<Bound<'py, PyAny>>,
    ) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)> {
        let _ = requested_schema;
        let schema = arrow::capsule(py, arrow::schema_of(self.get()))?;
        Ok((schema, arrow::capsule(py, arrow::array_of(&self.held, self.at))?))
    }
}
