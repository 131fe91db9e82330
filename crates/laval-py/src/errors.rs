//! Mistakes as exceptions of `laval._errors`.

use laval::diagnostic::{Diagnostic, Diagnostics};
use laval::file::{self, Form};
use laval::plain;
use pyo3::exceptions::{PyOSError, PyRuntimeError, PyValueError};
use pyo3::prelude::*;

/// All that is wrong with a machine file of this name and text.
pub fn mistakes(py: Python<'_>, found: &Diagnostics, text: &str, name: &str) -> PyErr {
    let name = if name.is_empty() { "machine" } else { name };
    let shown = file::render(found, text, name, Form::Lines);
    let json = file::diagnostics_json(found, text).to_string();
    let class = py.import("laval._errors").and_then(|m| m.getattr("MachineError"));
    class.and_then(|c| c.call1((shown.trim_end(), json))).map_or_else(|e| e, PyErr::from_value)
}

/// A request that cannot be met, with its help.
pub fn request(d: &Diagnostic) -> PyErr {
    PyValueError::new_err(plain::line(&d.to_string()).into_owned())
}

/// A folder that cannot be written.
pub fn folder(d: &Diagnostic) -> PyErr {
    PyOSError::new_err(plain::line(&d.message.to_string()).into_owned())
}

/// A defect of laval itself.
pub fn defect(what: impl std::fmt::Display) -> PyErr {
    PyRuntimeError::new_err(format!("{what}: this is a defect of laval, not of the machine; please report it with the machine file"))
}
