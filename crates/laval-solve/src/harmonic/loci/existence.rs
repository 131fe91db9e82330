//! Values of a parameter at which a machine exists.

use crate::diagnostic::Diagnostic;
use crate::harmonic::loci::search::Request;
use crate::model::system::System;
use laval_model::text;

/// Part of the range kept from a value beyond which the machine does not exist.
const INSIDE: f64 = 1e-6;
/// A range, and why the machine does not exist below and above it.
pub(super) type Existence = ((f64, f64), [Option<String>; 2]);

/// Values at which the machine exists: the part of the range about those values at which it was assembled, its ends by halving.
pub(super) fn existence(system: &System, request: &Request) -> Result<Existence, Diagnostic> {
    let path = request.parameter.as_str();
    let refusal = |x: f64| match system.with(&[(path, x)]) {
        Ok(_) => None,
        Err(d) => Some(d.into_error().message),
    };
    let inside: Vec<f64> = request.values.iter().copied().filter(|&x| refusal(x).is_none()).collect();
    let (Some(&first), Some(&last)) = (inside.first(), inside.last()) else {
        let help = text!("choose another range of the parameter");
        let message = match refusal(request.range.0) {
            Some(why) => text!("the machine does not exist at any value tried of {path}: {why}", path, why),
            None => text!("the machine does not exist at any value tried of {path}", path),
        };
        return Err(Diagnostic::error("loci.parameter", message).help(help));
    };
    let wide = request.range.1 - request.range.0;
    let edge = |mut good: f64, end: f64| match refusal(end) {
        None => (end, None),
        Some(why) => {
            let mut bad = end;
            for _ in 0..60 {
                let middle = 0.5 * (good + bad);
                if refusal(middle).is_none() { good = middle } else { bad = middle }
            }
            // what ends there may have no limit there
            (good + INSIDE * (if end > good { -wide } else { wide }), Some(why))
        }
    };
    let ((lo, below), (hi, above)) = (edge(first, request.range.0), edge(last, request.range.1));
    if !(hi > lo) {
        return Err(Diagnostic::error("loci.parameter", text!("the machine exists at a single value of {path} in this range", path))
            .help(text!("choose another range of the parameter")));
    }
    Ok(((lo, hi), [below, above].map(|why| why.map(|w| w.to_string()))))
}
