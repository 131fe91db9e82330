//! Where the reactions of a liquid are analytic: what a count of roots rests on.

use super::{Liquid, LiquidParams, Model, words};
use crate::cavity::Truncation;
use crate::model::part::Domain;

/// Harmonics that the sum of all of them evaluates, roughly.
const WHOLE_SERIES: usize = 100;
/// Terms that cost as much as reading that sum off a line.
const READ: usize = 2;

impl Liquid {
    /// At a spin speed.
    pub(super) fn analytic(&self, p: &LiquidParams<f64>, speed: f64) -> Domain {
        let cavity = Self::cavity(p);
        let inertial = [speed - 2.0 * speed.abs(), speed + 2.0 * speed.abs()];
        // inertial waves inside that range, surface waves outside it
        let all = (self.model == Model::Spatial).then_some([f64::NEG_INFINITY, f64::INFINITY]);
        let waves = cavity.plane_waves(speed);
        let terms = match (self.model, self.harmonics) {
            (Model::Spatial, Truncation::At(last)) => last.div_ceil(2),
            (Model::Spatial, _) => WHOLE_SERIES,
            _ => 1,
        };
        if self.viscous {
            // a layer of thickness sqrt(nu/W) at the wall takes its energy from a wave; what it takes is more where the liquid is shallow
            let gap = 0.1 * (p.viscosity * speed.abs()).sqrt() / p.cavity_radius;
            return Domain { crowded: all, waves, gap, terms, rough_terms: terms, words: words::VISCOUS, ..Domain::passive() };
        }
        let whole = self.model == Model::Spatial && !matches!(self.harmonics, Truncation::At(_));
        let rough_terms = if whole { READ } else { terms };
        let domain = Domain { left: true, waves, gap: 0.0, terms, rough_terms, words: words::IDEAL, ..Domain::passive() };
        match self.harmonics {
            Truncation::None | Truncation::Rough => Domain { axis: false, dense: Some(inertial), crowded: all, ..domain },
            Truncation::At(_) => Domain { except: vec![speed], truncated: Some(inertial), ..domain },
        }
    }
}
