//! The native half of the Python package `laval`: machines, runs, results and tables. The Python modules beside it give them names, types and documentation.

mod arrow;
mod attend;
mod cases;
mod catalog;
mod derivative;
mod errors;
mod figure;
mod machine;
mod pool;
mod results;
mod session;
mod studio;
mod table;

use pyo3::prelude::*;

#[pymodule]
fn _native(m: &Bound<'_, PyModule>) -> PyResult<()> {
    m.add("__version__", env!("CARGO_PKG_VERSION"))?;
    m.add("BUILD", laval::build::ID)?;
    m.add("LANGUAGES", laval::report::Language::ALL.map(laval::report::Language::code).to_vec())?;
    m.add("FORMATS", laval::report::Format::ALL.iter().map(|f| f.word()).collect::<Vec<_>>())?;
    m.add_class::<machine::Machine>()?;
    m.add_class::<results::Results>()?;
    m.add_class::<table::Table>()?;
    m.add_class::<table::Column>()?;
    m.add_class::<cases::Cases>()?;
    m.add_class::<studio::Studio>()?;
    m.add_function(wrap_pyfunction!(studio::studio, m)?)?;
    m.add_function(wrap_pyfunction!(cases::put, m)?)?;
    m.add_function(wrap_pyfunction!(cases::chunk_of, m)?)?;
    m.add_function(wrap_pyfunction!(machine::read, m)?)?;
    m.add_function(wrap_pyfunction!(machine::from_ross, m)?)?;
    m.add_function(wrap_pyfunction!(results::again, m)?)?;
    m.add_function(wrap_pyfunction!(attend::idle, m)?)?;
    m.add_function(wrap_pyfunction!(catalog::catalog, m)?)?;
    m.add_function(wrap_pyfunction!(catalog::si, m)?)?;
    m.add_function(wrap_pyfunction!(derivative::bounds, m)?)?;
    m.add_function(wrap_pyfunction!(derivative::mode, m)?)?;
    m.add_function(wrap_pyfunction!(derivative::places, m)?)?;
    Ok(())
}
