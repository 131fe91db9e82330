//! A liquid that is exact in the frequency domain only, in time: reactions as [rational functions](crate::cavity::rational).
//!
//! ```text
//! row = M theta'' + i W G theta' - (i/2) C W' theta - W sum r_j z_j,   z_j' = i W (1 + x_j) z_j + i theta''
//! ```
//!
//! Of an ideal spatial liquid displacement is exact and tilt a sum over [waves](crate::cavity::waves) whose frequencies grow with the speed, so that one form serves all
//! speeds; while the speed changes it is that of the speed at the moment. C is the polar inertia of the liquid.
//!
//! With viscosity displacement (of every slice) is [fitted](crate::cavity::layer) at one speed and tilt a sum over [waves that die out](crate::cavity), the x_j complex. The layer at the
//! wall depends on the speed, so that such a form serves no other.

use super::{Fill, Liquid, LiquidParams, Model};
use crate::cavity::Truncation;
use crate::cavity::layer::{MOST_POLES, Refused};
use crate::cavity::rational::Rational;
use crate::cavity::waves::{MARGIN, MOST_HARMONICS, MOST_WAVES};
use crate::model::blocks::Blocks;
use crate::model::part::{Dof, DofKind};
use crate::model::timed::{Speeds, Untimed};
use crate::text;
use crate::text::Text;
use laval_num::scalar::Scalar;
use std::sync::{Arc, Mutex, PoisonError};

/// What a time form was made for.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Made {
    model: Model,
    harmonics: Truncation,
    accuracy: f64,
    /// R, r0, H, density, viscosity.
    liquid: [f64; 5],
    /// Where it is made for one.
    speed: Option<f64>,
}

/// Relative difference of two speeds that are one.
const SAME_SPEED: f64 = 1e-9;
/// Forms that are remembered.
const REMEMBERED: usize = 8;

/// Reactions in time.
#[derive(Debug)]
pub(super) struct Rationals {
    made: Made,
    /// Of displacement, where the plane flow has no states of its own.
    plane: Option<Rational>,
    /// Of tilt.
    tilt: Option<Rational>,
    error: f64,
    /// For which motions that is the error, and for which rates of growth over the speed.
    scope: &'static str,
    margin: f64,
}

const WAVES: &str = "of tilts that grow or decay by a twentieth of the speed or more, up to four times the speed in rotor axes";
const LAYER: &str = "of motions that do not decay, up to four times the speed in rotor axes";

/// A form, or why there is none.
type Form = Result<Arc<Rationals>, Untimed>;

/// The forms made last, shared by copies of the part.
#[derive(Clone, Default)]
pub(super) struct Memo(Arc<Mutex<Vec<(Made, Form)>>>);

fn many_harmonics() -> Text {
    text!("its waves are computed up to axial_harmonics = {most}; leave axial_harmonics out for all of them", most = MOST_HARMONICS)
}

fn waves() -> Text {
    text!("{n} waves", n = MOST_WAVES)
}

impl Liquid {
    fn made(&self, p: &LiquidParams<f64>, speed: Option<f64>) -> Made {
        let liquid = [p.cavity_radius, p.free_surface_radius, p.cavity_height, p.density, p.viscosity];
        Made { model: self.model, harmonics: self.harmonics, accuracy: self.accuracy, liquid, speed }
    }
    /// The part with its reactions as rational functions.
    pub(super) fn for_motions(&self, p: &LiquidParams<f64>, speeds: Speeds, stop: &dyn Fn() -> bool) -> Result<Self, Untimed> {
        if speeds == Speeds::Changing && p.skew != 0.0 && !self.viscous {
            return Err(text!("that of a cavity that is skew to its shaft holds at constant speed only").into());
        }
        let speed = match (self.viscous, speeds) {
            (false, _) => None,
            (true, Speeds::One(speed)) => Some(speed),
            (true, Speeds::Several) => {
                let why = text!(
                    "the layer of a viscous liquid depends on the speed, so that its form is made for one; transient and basins run at one"
                );
                return Err(why.into());
            }
            (true, Speeds::Changing) => {
                return Err(
                    text!("the layer of a viscous liquid depends on the speed, so that its form holds at constant speed only").into()
                );
            }
        };
        let made = self.made(p, speed);
        let mut memo = self.memo.0.lock().unwrap_or_else(PoisonError::into_inner);
        let known = memo.iter().find(|m| m.0 == made).map(|m| m.1.clone());
        let time = match known {
            Some(known) => known,
            None => {
                let new = match speed {
                    Some(speed) => self.layer_in_time(p, made, speed, stop),
                    None => self.waves_in_time(p, made).map_err(Untimed::from),
                };
                let new = match new {
                    // nothing was found out
                    Err(Untimed::Stopped) => return Err(Untimed::Stopped),
                    Err(why) => Err(why),
                    Ok(new) => Ok(Arc::new(new)),
                };
                if memo.len() == REMEMBERED {
                    drop(memo.remove(0));
                }
                memo.push((made, new.clone()));
                new
            }
        }?;
        Ok(Liquid { time: Some(time), ..self.clone() })
    }

    /// Of an ideal liquid.
    fn waves_in_time(&self, p: &LiquidParams<f64>, made: Made) -> Result<Rationals, Text> {
        let found = Self::cavity(p).tilt_in_time(self.harmonics, self.accuracy, MOST_WAVES).ok_or_else(|| match self.harmonics {
            Truncation::At(last) if last > MOST_HARMONICS => many_harmonics(),
            _ => text!(
                "{most} do not give its reaction with a relative error of {allowed}; allow a larger time_error",
                most = waves(),
                allowed = text::number(self.accuracy, 3)
            ),
        })?;
        Ok(Rationals { made, plane: None, tilt: Some(found.form), error: found.error, scope: WAVES, margin: MARGIN })
    }

    /// Of a viscous liquid at one speed.
    fn layer_in_time(&self, p: &LiquidParams<f64>, made: Made, speed: f64, stop: &dyn Fn() -> bool) -> Result<Rationals, Untimed> {
        let cavity = Self::cavity(p);
        let allowed = text::number(self.accuracy, 3);
        let reported = |of: Text, most: Text, strip: Text, refused: Refused| {
            match refused {
            Refused::Speed => return Untimed::No { why: text!("without spin nothing holds the layer on the wall"), help: Some(text!("give the study a speed above 0; for a machine that stands still model = \"frozen\" without viscosity counts the liquid as a mass")) },
            Refused::Accuracy { reached } => {
                let larger = if reached.is_finite() {
                    text!("try time_error = {reached}", reached = crate::units::format_number(reached, 2))
                } else {
                    text!("allow a larger time_error")
                };
                text!("{most} do not give its reaction on {of} with a relative error of {allowed}; {larger}{strip}", most, of, allowed, larger, strip)
            }
            Refused::Harmonics => {
                many_harmonics()
            }
            Refused::Reaction => text!(
                "its reaction on {of} cannot be computed to a tenth of the error allowed, {allowed}, for all motions up to four times the speed{strip}",
                of,
                allowed,
                strip
            ),
            Refused::Work => text!("finding the form of its reaction on {of} takes too much work; allow a larger time_error{strip}", of, strip),
            Refused::Stopped => return Untimed::Stopped,
        }
        .into()
        };
        let plane = cavity
            .planar_in_time(speed, p.viscosity, self.accuracy, stop)
            .map_err(|e| reported(text!("displacement"), text!("{n} poles", n = MOST_POLES), text!(""), e))?;
        let (tilt, error) = match self.model {
            Model::Strip => (Some(plane.form.clone().scaled(cavity.slices())), plane.error),
            Model::Spatial => {
                let tilt = cavity.tilt_viscous_in_time(speed, p.viscosity, self.harmonics, self.accuracy, stop).map_err(|mut e| {
                    // what is advised must do for both
                    if let Refused::Accuracy { reached } = &mut e
                        && cavity.planar_in_time(speed, p.viscosity, *reached, stop).is_err()
                    {
                        *reached = f64::INFINITY;
                    }
                    reported(text!("tilt"), waves(), text!(", or model = \"strip\""), e)
                })?;
                (Some(tilt.form), plane.error.max(tilt.error))
            }
            _ => (None, plane.error),
        };
        Ok(Rationals { made, plane: Some(plane.form), tilt, error, scope: LAYER, margin: 0.0 })
    }

    /// How far the speed is from that of the form, over what is allowed; the form holds at its own alone.
    pub(super) fn off_speed(&self, speed: f64) -> Option<f64> {
        let own = self.time.as_ref()?.made.speed?;
        Some((speed - own).abs() / (SAME_SPEED * own.abs()))
    }

    /// Error, and for which motions it is that.
    pub(super) fn fit(&self) -> Option<crate::model::capability::time_form::Fitted> {
        self.time.as_ref().map(|t| crate::model::capability::time_form::Fitted {
            error: t.error,
            scope: t.scope,
            margin: t.margin,
            states: self.time_states().len(),
        })
    }

    /// Why the form does not belong to these parameters.
    pub(super) fn outdated(&self, p: &LiquidParams<f64>) -> Option<Text> {
        let time = self.time.as_ref()?;
        (time.made != self.made(p, time.made.speed))
            .then(|| text!("its form in the time domain was made for another cavity; its size and its filling cannot be varied here"))
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
