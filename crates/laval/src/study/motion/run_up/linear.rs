//! The steady linear response at the speeds of a run-up: of several spins the sum of what each forces, which their motions reach together once a beat.

use crate::model::blocks::Grid;
use crate::model::linear::{Form, LinearModel, LinearScratch};
use crate::model::part::At;
use crate::model::system::System;
use crate::model::tangent::{Tangent, TangentScratch};
use crate::solve::characteristic::{Equilibrium, Frame};
use crate::solve::rest::unlinearised;
use laval_num::complex::{C64, c};
use laval_num::dense::{Lu, Mat};

/// Steady unbalance response of the machine linearised at rest.
pub(super) struct LinearResponse<'a> {
    system: &'a System,
    model: LinearModel<f64>,
    scratch: LinearScratch<f64>,
    tangent: Tangent,
    tangent_scratch: TangentScratch,
    stiffness: Grid<C64>,
}

impl<'a> LinearResponse<'a> {
    /// `None` when a nonlinear part has no linear form at rest, states of its own, or forces of its own that turn.
    pub fn new(system: &'a System) -> Option<Self> {
        let still = Equilibrium::zero(system, Frame::Fixed, 0.0);
        let fits =
            system.slots().iter().all(|s| s.is_linear() || (s.states.is_empty() && !s.uses.spin)) && unlinearised(system, &still).is_none();
        fits.then(|| LinearResponse {
            system,
            model: LinearModel::default(),
            scratch: LinearScratch::default(),
            tangent: Tangent::default(),
            tangent_scratch: TangentScratch::default(),
            stiffness: Grid::empty(),
        })
    }

    /// Largest |x + i y| of each body, at any of its points; NaN where the stiffness is singular.
    pub fn amplitudes(&mut self, speed: f64) -> Vec<f64> {
        let system = self.system;
        let (n, zero) = (system.n(), vec![0.0; system.n().max(system.m())]);
        let (q, z) = (&zero[..n], &zero[..system.m()]);
        system.linear(system.params(), speed, Form::Frequency, &mut self.model, &mut self.scratch);
        let loads = &self.model.loads;
        let others = loads.others.iter().map(|o| (o.ratio, o.force.clone()));
        let turning: Vec<(f64, [Vec<f64>; 2])> =
            std::iter::once((1.0, [loads.force_cos.clone(), loads.force_sin.clone()])).chain(others).collect();
        let at = At { q, v: q, a: q, z, phase: 0.0, speed, spin_accel: 0.0, t: 0.0 };
        system.tangent(&at, false, &mut self.tangent, &mut self.tangent_scratch, |slot| !slot.is_linear());
        let mut sum = vec![0.0; system.stations().len()];
        for (ratio, load) in turning {
            let own = self.forced(speed, ratio, &load);
            sum.iter_mut().zip(own).for_each(|(s, x)| *s += x);
        }
        sum
    }

    /// The same of loads that turn with a spin of this ratio to the speed.
    fn forced(&mut self, speed: f64, ratio: f64, [cos, sin]: &[Vec<f64>; 2]) -> Vec<f64> {
        let (system, n) = (self.system, self.system.n());
        let count = system.stations().len();
        if ratio != 1.0 && cos.iter().chain(sin).all(|f| *f == 0.0) {
            return vec![0.0; count];
        }
        let s = c(0.0, ratio * speed);
        system.dynamic_stiffness(system.params(), &self.model, Form::Frequency, s, &mut self.stiffness, &mut self.scratch);
        let t = &self.tangent;
        let matrix = Mat::from_fn(self.stiffness.rows(), self.stiffness.cols(), |i, j| {
            let own = self.stiffness[(i, j)];
            if i < n && j < n { own + c(t.q[(i, j)], 0.0) + s.scale(t.v[(i, j)]) + (s * s).scale(t.a[(i, j)]) } else { own }
        });
        let mut x: Vec<C64> = (0..matrix.rows()).map(|i| if i < n { c(cos[i], -sin[i]) } else { c(0.0, 0.0) }).collect();
        let Ok(lu) = Lu::new(&matrix) else { return vec![f64::NAN; count] };
        lu.solve(&mut x);
        // forward and backward parts turn against each other: their radii add up once a turn
        let size = |[x, y]: [C64; 2]| 0.5 * ((x + y.mul_i()).abs() + (x - y.mul_i()).abs());
        let points = |k: usize| system.probes().iter().filter(move |p| p.station == k && !p.is_tilt());
        (0..count).map(|k| crate::study::shared::support::largest(points(k).map(|p| size(p.amplitudes(&x))))).collect()
    }
}
