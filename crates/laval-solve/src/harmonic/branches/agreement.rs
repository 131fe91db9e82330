//! Stability assessed again: some states of every branch by Hill's method and by the map over the whole period at another tolerance.
//!
//! Neither uses the symmetry of the motion: both see the whole period. The map has steps of adapted length and the tangents of the law itself.

use crate::harmonic::balance::whole_period::whole_period;
use crate::harmonic::branches::branch::Traced;
use crate::harmonic::branches::response::Response;
use crate::harmonic::stability::floquet::Stability;
use crate::harmonic::stability::hill;
use crate::model::system::System;
use laval_num::dense::max_abs;
use serde::{Deserialize, Serialize};
use std::sync::atomic::{AtomicBool, Ordering};

/// Tolerance of the second map.
pub const TOLERANCE: f64 = 1e-12;

/// What came of it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Agreement {
    /// States assessed again.
    pub states: usize,
    /// Of these, found by the map; and by Hill's method.
    pub assessed: [usize; 2],
    /// Largest difference of the largest growth rate, 1/s: of the map, of Hill's method.
    pub difference: [f64; 2],
    /// States called stable by one and unstable by another, beyond the errors of both.
    pub contradictions: usize,
    /// Why a method gave nothing, if it did.
    pub failed: Option<String>,
}

/// Assesses again the ends and the middle of every branch, its largest motion, its largest and its smallest growth rate.
pub fn check(system: &System, response: &Response, cancel: &AtomicBool) -> Agreement {
    let mut out = Agreement::default();
    for branch in &response.branches {
        let Ok(mut second) = Stability::new(system).map(|s| s.with_tolerance(TOLERANCE).adaptively()) else { return out };
        for i in chosen(branch) {
            if cancel.load(Ordering::Relaxed) {
                return out;
            }
            let state = &branch.points[i];
            let Some(first) = &state.exponents else { continue };
            let (mut balance, x) = match whole_period(system, branch.discretisation, &state.x, state.speed) {
                Ok(whole) => whole,
                Err(d) => {
                    out.failed = Some(d.message.to_string());
                    continue;
                }
            };
            balance.sample(&x, state.speed);
            out.states += 1;
            let mapped = second.mapped(&mut balance, &x, state.speed);
            let hill = hill::exponents(&mut second, &mut balance, &x, state.speed);
            for (which, found) in [mapped, hill].into_iter().enumerate() {
                match found {
                    Ok(e) => {
                        out.assessed[which] += 1;
                        let difference = (e.growth() - first.growth()).abs();
                        if !(difference <= out.difference[which]) {
                            out.difference[which] = difference;
                        }
                        let error = first.error + e.error;
                        if first.growth() > error && e.growth() < -error || first.growth() < -error && e.growth() > error {
                            out.contradictions += 1;
                        }
                    }
                    Err(why) => out.failed = Some(why.to_string()),
                }
            }
        }
    }
    out
}

/// Points of a branch that are assessed again.
fn chosen(branch: &Traced) -> Vec<usize> {
    let all = || 0..branch.points.len();
    let by = |f: &dyn Fn(usize) -> f64| all().max_by(|&a, &b| f(a).total_cmp(&f(b)));
    let points = &branch.points;
    let mut out: Vec<usize> = [
        all().next(),
        all().last(),
        all().nth(points.len() / 2),
        by(&|i| max_abs(&points[i].x)),
        by(&|i| points[i].growth()),
        by(&|i| -points[i].growth()),
    ]
    .into_iter()
    .flatten()
    .collect();
    out.sort_unstable();
    out.dedup();
    out
}
