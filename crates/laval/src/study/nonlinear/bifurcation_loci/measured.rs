//! How far the motions on loci go: displacements, tilts and validity.

use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use crate::solve::harmonic::balance::orbit::Orbit;
use crate::solve::harmonic::balance::problem::Balance;
use crate::solve::harmonic::loci::search::{Loci, Request};
use crate::study::shared::probes;
use crate::study::shared::validity::Uses;
use laval_num::work::Here;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// Displacements and validity of one motion.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Measured {
    /// Per probe, the reference points of the bodies first: largest value over a period, m or rad.
    pub sizes: Vec<f64>,
    /// Use of the parts' validity; `None` where the motion could not be had.
    pub uses: Option<Uses>,
}

/// By locus, of its points and of its corners.
pub(super) fn measured(system: &System, request: &Request, found: &Loci) -> Result<[Vec<Vec<Measured>>; 2], Diagnostic> {
    let count = probes::ordered(system).len();
    let template = Balance::new(system, found.discretisation, request.speeds, None)?;
    let measure = |value: f64, speed: f64, x: &[f64]| {
        let unknown = || Measured { sizes: vec![f64::NAN; count], uses: None };
        let Ok(machine) = system.with(&[(&request.parameter, value)]) else { return unknown() };
        let Some(mut balance) = template.of_other(&machine) else { return unknown() };
        let Ok(orbit) = Orbit::of(&mut balance, x, speed) else { return unknown() };
        let turns = template.terms.divisor;
        let sizes = probes::sizes(&machine, &probes::ordered(&machine), &orbit, turns);
        Measured { sizes, uses: Some(Uses::over(&machine, &orbit, turns)) }
    };
    let here = Here::now();
    let counted = |value: f64, speed: f64, x: &[f64]| {
        let _counted = here.enter();
        measure(value, speed, x)
    };
    let points = found.loci.iter().map(|l| l.points.par_iter().map(|p| counted(p.value, p.speed, &p.x)).collect()).collect();
    let corners = found.loci.iter().map(|l| l.corners.par_iter().map(|c| counted(c.turn.value, c.speed, &c.x)).collect()).collect();
    Ok([points, corners])
}
