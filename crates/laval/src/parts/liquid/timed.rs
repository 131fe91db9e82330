//! A liquid that is exact in the frequency domain only, in time: reactions as [rational functions](crate::cavity::rational).
//!
//! ```text
//! row = M theta'' + i W G theta' - (i/2) C W' theta - W sum r_j z_j,   z_j' = i W (1 + x_j) z_j + i theta''
//! ```
//!
//! Of an ideal spatial liquid displacement is exact and tilt a sum over [waves](crate::cavity::waves) whose frequencies grow with the speed, so that one form serves all
//! speeds; while the speed changes it is that of the speed at the moment. C is the polar inertia of the liquid.

use super::{Fill, Liquid, LiquidParams, Model};
use crate::cavity::Truncation;
use crate::cavity::rational::Rational;
use crate::cavity::waves::{MARGIN, MOST_HARMONICS, MOST_WAVES};
use crate::model::blocks::Blocks;
use crate::model::part::{Dof, DofKind};
use crate::model::timed::Speeds;
use crate::units::format_number;
use laval_num::scalar::Scalar;
use std::sync::{Arc, Mutex, PoisonError};

/// What a time form was made for: R, r0, H, density, viscosity.
type Made = [f64; 5];

/// Reactions in time.
#[derive(Debug)]
pub(super) struct Rationals {
    made: Made,
    /// Of displacement, where the plane flow has no states of its own.
    plane: Option<Rational>,
    /// Of tilt.
    tilt: Option<Rational>,
    error: f64,
}

/// The form made last, shared by copies of the part.
#[derive(Clone, Default)]
pub(super) struct Memo(Arc<Mutex<Option<Arc<Rationals>>>>);

fn made(p: &LiquidParams<f64>) -> Made {
    [p.cavity_radius, p.free_surface_radius, p.cavity_height, p.density, p.viscosity]
}

impl Liquid {
    /// The part with its reactions as rational functions.
    pub(super) fn in_time(&self, p: &LiquidParams<f64>, speeds: Speeds) -> Result<Self, String> {
        if speeds == Speeds::Changing && p.skew != 0.0 {
            return Err("that of a cavity that is skew to its shaft holds at constant speed only".into());
        }
        if self.viscous {
            return Err("the layer of a viscous liquid at the wall remembers its whole past".into());
        }
        let mut memo = self.memo.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = memo.as_ref().filter(|m| m.made == made(p)) {
            return Ok(Liquid { time: Some(known.clone()), ..self.clone() });
        }
        let found = Self::cavity(p).tilt_in_time(self.harmonics, self.accuracy, MOST_WAVES).ok_or_else(|| match self.harmonics {
            Truncation::At(last) if last > MOST_HARMONICS => {
                format!("its waves are computed up to axial_harmonics = {MOST_HARMONICS}; leave axial_harmonics out for all of them")
            }
            _ => format!(
                "{MOST_WAVES} waves do not give its reaction with a relative error of {}; allow a larger time_error",
                format_number(self.accuracy, 3)
            ),
        })?;
        let time = Arc::new(Rationals { made: made(p), plane: None, tilt: Some(found.form), error: found.error });
        *memo = Some(time.clone());
        Ok(Liquid { time: Some(time), ..self.clone() })
    }

    /// Error, and for which motions it is that.
    pub(super) fn fit(&self) -> Option<crate::model::part::Fitted> {
        self.time.as_ref().map(|t| crate::model::part::Fitted {
            error: t.error,
            scope: "of tilts that grow or decay by a twentieth of the speed or more, up to four times the speed in rotor axes",
            margin: MARGIN,
            states: self.time_states().len(),
        })
    }

    /// Why the form does not belong to these parameters.
    pub(super) fn outdated(&self, p: &LiquidParams<f64>) -> Option<String> {
        let time = self.time.as_ref()?;
        (time.made != made(p))
            .then(|| "its form in the time domain was made for another cavity; its size and its filling cannot be varied here".into())
    }

    /// States of the waves.
    pub(super) fn time_states(&self) -> Vec<Dof> {
        let Some(time) = &self.time else { return Vec::new() };
        let mut out = Vec::new();
        for (form, name, kind, unit, typical) in
            [(&time.plane, "layer", DofKind::VectorX, "m/s", 1.0), (&time.tilt, "wave", DofKind::TiltX, "rad/s", 10.0)]
        {
            for j in 0..form.as_ref().map_or(0, |f| f.waves.len()) {
                out.extend(Dof::pair(&format!("{name}_{}_", j + 1), kind, unit, typical));
            }
        }
        out
    }

    /// Blocks of the rational reactions; `state` is the first of their states.
    #[inline(always)]
    pub(super) fn add_time_form<S: Scalar>(&self, p: &LiquidParams<S>, w: S, b: &mut Blocks<S>, mut state: usize) {
        let Some(time) = &self.time else { return };
        for (form, row) in [(&time.plane, 0), (&time.tilt, 2)] {
            let Some(form) = form else { continue };
            for i in row..row + 2 {
                b.mass[(i, i)] += S::cst(form.inertia);
            }
            b.gyroscopic.add_complex(row, row, S::zero(), S::cst(form.turning));
            for wave in &form.waves {
                let (x, r) = (wave.place, wave.strength);
                b.state_force.add_complex(row, state, w.scale(-r.re), w.scale(-r.im));
                b.state.add_complex(state, state, w.scale(-x.im), w.scale(1.0 + x.re));
                b.state_a.add_complex(state, row, S::zero(), S::one());
                state += 2;
            }
        }
        if self.model == Model::Spatial && !self.viscous {
            let half = self.polar_inertia(p).scale(0.5);
            b.spin_accel_stiffness.add_complex(2, 2, S::zero(), -half);
        }
    }

    /// States of the plane flow before them.
    pub(super) fn plane_states(&self) -> usize {
        match (self.waves(), self.model) {
            (false, _) => 0,
            (true, Model::Strip) => 8,
            _ => 4,
        }
    }

    /// Surface without states of its own.
    pub(super) fn hidden_surface(&self) -> bool {
        self.fill == Fill::Partial && self.model != Model::Frozen && !self.waves()
    }
}
