//! The studio of a machine: its server, on a thread of its own.

use crate::errors::request;
use laval_studio::{Handle, Options, Server};
use pyo3::prelude::*;
use std::path::PathBuf;
use std::thread;

/// A server; it ends with this object.
#[pyclass(frozen, module = "laval._native")]
pub struct Studio {
    /// The address of the page.
    #[pyo3(get)]
    address: String,
    handle: Handle,
}

#[pymethods]
impl Studio {
    /// The text of the page; none before it was opened.
    fn text(&self) -> Option<String> {
        self.handle.text()
    }

    /// Ends the server.
    fn stop(&self) {
        self.handle.stop();
    }
}

impl Drop for Studio {
    fn drop(&mut self) {
        self.handle.stop();
    }
}

/// Serves the studio of a text; files are opened and saved in `folder`.
#[pyfunction]
pub fn studio(text: String, name: PathBuf, folder: PathBuf, language: &str) -> PyResult<Studio> {
    let language = language.parse().map_err(pyo3::exceptions::PyValueError::new_err)?;
    let options = Options { file: Some(folder.join(name)), folder, text: Some(text), framed: true, language, ..Options::default() };
    let server = Server::new(options).map_err(|d| request(&d))?;
    let (address, handle) = (server.address(), server.handle());
    thread::Builder::new().name("laval studio".into()).spawn(move || {
        // the object that would report it has gone
        let _ = server.serve();
    })?;
    Ok(Studio { address, handle })
}
