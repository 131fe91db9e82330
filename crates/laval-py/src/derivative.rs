//! Exact derivatives of results in the parameters of a machine.

use crate::attend::{Watch, attended};
use crate::errors;
use crate::machine::Machine;
use laval::diagnostic::{Diagnostic, Diagnostics};
use laval::file::construct;
use laval::model::system::System;
use laval::solve::harmonic::branches::sensitivity::parameters;
use laval::solve::mode_slopes::{ModeSlopes, mode_slopes};
use laval::solve::symmetry::Symmetry;
use laval::study::modes::Modes;
use laval::study::sensitivity::{Kind, Place, Sensitivity};
use laval::study::{Cancel, Context, TypedStudy};
use laval::text;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// The machine with other values of parameters.
fn changed(machine: &Machine, changes: &[(String, f64)]) -> Result<System, Diagnostics> {
    let changes: Vec<(&str, f64)> = changes.iter().map(|(path, x)| (path.as_str(), *x)).collect();
    machine.loaded.system.with(&changes)
}

/// Indices of parameters by path.
fn indices(system: &System, paths: &[String]) -> Result<Vec<Vec<usize>>, Diagnostics> {
    paths.iter().map(|p| system.param(p).ok_or_else(|| Diagnostics(vec![system.unknown_param(p)]))).collect()
}

fn one(d: Diagnostic) -> Diagnostics {
    Diagnostics(vec![d])
}

/// Runs `work` while Python stays responsive; there is no part of a result, so that a stop is an exception.
fn whole<R: Send>(py: Python<'_>, work: impl FnOnce(&Context) -> Result<R, Diagnostics> + Send) -> PyResult<R> {
    let (cancel, watch) = (Cancel::default(), Watch::default());
    let context = Context { name: "derivatives", cancel: &cancel, progress: &watch, work_limit: u64::MAX, keep: None };
    let run = attended(py, &cancel, &watch, None, || work(&context))?;
    if let Some(e) = run.stopped_by {
        return Err(e);
    }
    run.result.map_err(|_| errors::defect("the derivatives failed"))?.map_err(|found| errors::mistakes(py, &found, "", "derivatives"))
}

fn fields(json: &str) -> Result<serde_json::Value, Diagnostics> {
    serde_json::from_str(json)
        .map_err(|e| one(Diagnostic::error("study.fields", text!("the fields of the study cannot be read: {e}", e = e.to_string()))))
}

/// Derivatives of two numbers in the parameter of this path.
type Slopes = Vec<(String, f64, f64)>;

/// Growth rate and frequency of a mode, and both differentiated.
type ModeAndSlopes = (f64, f64, Slopes);

/// What a place is, whose motion it measures, speed, value and unit, speed and value differentiated.
type PlaceAndSlopes = (&'static str, String, f64, f64, String, Slopes);

/// Bounds of a parameter, SI; both halves of a lateral pair have the same.
#[pyfunction]
pub fn bounds(machine: &Bound<'_, Machine>, path: &str) -> PyResult<(f64, f64)> {
    let system = &machine.get().loaded.system;
    let found = system.param(path).ok_or_else(|| PyValueError::new_err(system.unknown_param(path).to_string()))?;
    let bounds = system.param_slots()[found[0]].bounds;
    Ok((bounds.min, bounds.max))
}

/// A mode by its number in order of frequency, from 1, among those of a direction of whirl where one is given; with the fields of the study `modes` as JSON.
/// Without paths: all parameters that may vary.
#[pyfunction]
pub fn mode(
    py: Python<'_>,
    machine: &Bound<'_, Machine>,
    study: &str,
    number: usize,
    whirl: Option<&str>,
    changes: Vec<(String, f64)>,
    paths: Option<Vec<String>>,
) -> PyResult<ModeAndSlopes> {
    let machine = machine.get();
    whole(py, |context| {
        let system = changed(machine, &changes)?;
        let study: Modes = construct(&system, &fields(study)?)?;
        let result = study.result(&system, context).map_err(one)?;
        let mut own = result.spectrum.modes.iter().filter(|m| whirl.is_none_or(|w| m.whirl.at(study.speed).word() == w));
        let missing = || one(Diagnostic::error("mode.missing", text!("there is no mode {number} of this kind at this speed", number)));
        let mode = number.checked_sub(1).and_then(|k| own.nth(k)).ok_or_else(missing)?;
        let find = |s: &System| study.about.find(s, study.speed, None);
        let paths = paths.unwrap_or_else(|| parameters(&system, Symmetry::Circular).into_iter().map(|p| p.path).collect());
        let slopes = mode_slopes(&system, &find, mode.value, mode.sector, &indices(&system, &paths)?).map_err(one)?;
        let unsolved = || one(Diagnostic::error("mode.unsolved", text!("the characteristic function has no simple root at this mode")));
        let ModeSlopes { value, slopes } = slopes.ok_or_else(unsolved)?;
        Ok((value.re, value.im, paths.into_iter().zip(slopes).map(|(path, s)| (path, s.re, s.im)).collect()))
    })
}

/// Peaks and jumps of the steady response, with the fields of the study `sensitivity` as JSON. Without paths: all parameters that may vary.
#[pyfunction]
pub fn places(
    py: Python<'_>,
    machine: &Bound<'_, Machine>,
    study: &str,
    changes: Vec<(String, f64)>,
    paths: Option<Vec<String>>,
) -> PyResult<Vec<PlaceAndSlopes>> {
    let machine = machine.get();
    whole(py, |context| {
        let system = changed(machine, &changes)?;
        // a path that does not exist is a mistake before anything is computed
        indices(&system, paths.as_deref().unwrap_or_default())?;
        let study: Sensitivity = construct(&system, &fields(study)?)?;
        let found = study.result(&system, context).map_err(one)?.found;
        let paths = paths.unwrap_or_else(|| found.parameters.iter().map(|p| p.path.clone()).collect());
        let wanted = indices(&system, &paths)?;
        // a pair that the response has equal halves of is one parameter there: its halves cannot be had apart
        let mut slopes_of: Vec<Vec<usize>> = Vec::new();
        for (path, indices) in paths.iter().zip(&wanted) {
            let within = |k: &usize| {
                let p = &found.parameters[*k].parameter;
                (p.first..p.first + p.count).all(|i| indices.contains(&i))
            };
            let parts: Vec<usize> = (0..found.parameters.len()).filter(within).collect();
            let covered: usize = parts.iter().map(|&k| found.parameters[k].parameter.count).sum();
            if covered < indices.len() {
                let help =
                    text!("differentiate in the pair, without .x or .y; what is fixed by other values of its part has no derivative");
                return Err(one(Diagnostic::error("parameter.fixed", text!("\"{path}\" cannot vary by itself", path)).help(help)));
            }
            slopes_of.push(parts);
        }
        let place = |p: &Place| {
            let word = match p.kind {
                Kind::Peak => "peak",
                Kind::JumpUp => "jump_up",
                Kind::JumpDown => "jump_down",
            };
            let sum = |(path, parts): (&String, &Vec<usize>)| {
                let own = || parts.iter().map(|&k| p.moved.slopes[k]);
                (path.clone(), own().map(|s| s.speed).sum(), own().map(|s| s.value).sum())
            };
            let slopes = paths.iter().zip(&slopes_of).map(sum).collect();
            (word, p.probe.name.clone(), p.moved.speed, p.moved.value, p.probe.unit().to_string(), slopes)
        };
        Ok(found.places.iter().map(place).collect())
    })
}
