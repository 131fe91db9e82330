//! Validity of the separation model: flags attached to every result.
//!
//! Sources: `docs/theory/separation.md#validity`; ISO 13317 (Reynolds number 0.25).

use super::particle::{Drag, Medium, Particle};
use super::separator::Separator;

/// Boltzmann's constant, J/K.
const BOLTZMANN: f64 = 1.380649e-23;
/// Temperature when none is given, K.
const ROOM: f64 = 293.15;

/// A quantity that bounds the model.
#[derive(Clone, Debug, PartialEq)]
pub struct Flag {
    /// Name.
    pub name: &'static str,
    /// Value.
    pub value: f64,
    /// Where doubts begin.
    pub limit: f64,
    /// The value must stay below the limit (else above).
    pub below: bool,
    /// What it means beyond.
    pub meaning: &'static str,
}

impl Flag {
    /// The model is in doubt. A value that is not a number is.
    pub fn raised(&self) -> bool {
        if self.below { !(self.value <= self.limit) } else { !(self.value >= self.limit) }
    }
}

/// Least field at the innermost liquid, over gravity.
pub const FIELD: f64 = 10.0;

/// The field at the innermost liquid over gravity at a speed, where the model leaves gravity out and the field is not large against it: in machines that liquid flows
/// through, below [`FIELD`].
pub fn gravity_felt(separator: &Separator, speed: f64, gravity: f64) -> Option<f64> {
    let field = speed * speed * separator.at(speed).radii().0 / gravity;
    // NaN is felt
    (separator.flow_volume().is_some() && !(field >= FIELD)).then_some(field)
}

/// What is known of a separation when its validity is assessed.
pub struct Case<'a> {
    /// The separator.
    pub separator: &'a Separator,
    /// The liquid.
    pub medium: &'a Medium,
    /// The particle the flags speak of.
    pub particle: &'a Particle,
    /// Spin speed, rad/s.
    pub speed: f64,
    /// Largest Reynolds number on the path.
    pub reynolds: f64,
    /// Share that leaves at the wall.
    pub wall_share: f64,
    /// Duration of the run-up, s.
    pub ramp: f64,
    /// Temperature, K.
    pub temperature: Option<f64>,
}

/// All flags of a case.
pub fn flags(c: &Case) -> Vec<Flag> {
    let rates = c.medium.rates(c.particle);
    let turning = c.separator.at(c.speed);
    let (r1, r2) = turning.radii();
    let w2 = c.speed * c.speed;
    let mut out = Vec::new();
    let mut flag = |name, value, limit, below, meaning| out.push(Flag { name, value, limit, below, meaning });
    match c.medium.drag {
        Drag::Stokes => {
            flag("reynolds", c.reynolds, 0.25, true, "Stokes' law overstates the velocity; above 1 use drag = \"schiller_naumann\"")
        }
        Drag::SchillerNaumann => flag("reynolds", c.reynolds, 2e5, true, "the drag law ends at the drag crisis"),
    }
    flag(
        "inertia",
        0.5 * rates.two_n / c.speed.abs(),
        100.0,
        false,
        "inertia and Coriolis forces are felt; below 10 drag laws of still liquid are doubtful",
    );
    let hindered = c.medium.hindered_exponent > 0.0;
    flag(
        "dilute",
        c.medium.volume_fraction,
        if hindered { 0.3 } else { 0.02 },
        true,
        "particles hinder each other more than the model says",
    );
    let weight = (c.particle.density - c.medium.density).abs() * 4.0 / 3.0 * std::f64::consts::PI * c.particle.radius.powi(3);
    let peclet = weight * w2 * 0.5 * (r1 + r2) * (r2 - r1) / (BOLTZMANN * c.temperature.unwrap_or(ROOM));
    flag("brownian", peclet, 100.0, false, "diffusion works against settling: trajectories alone mislead");
    if let Separator::Cup(cup) = c.separator {
        flag("gravity", w2 * r1 / c.medium.gravity, FIELD, false, "tilt and settling depend strongly on gravity");
        let v = cup.vessel;
        flag(
            "surface",
            v.radius * v.radius / (2.0 * r1) / (v.bottom - v.top),
            0.1,
            true,
            "the free surface is curved, which the model of a swinging cup leaves out",
        );
    }
    if c.separator.flow_volume().is_some() {
        let meaning = "the field at the innermost liquid, over gravity, is not large; the model of machines that liquid flows through leaves gravity out";
        flag("gravity", w2 * r1 / c.medium.gravity, FIELD, false, meaning);
    }
    if let (Separator::Tube(..), Some(f)) = (c.separator, turning.filled()) {
        flag("mouth", f64::from(u8::from(f.at_mouth)), 0.5, true, "the liquid reaches the mouth: without a cap it spills");
    }
    if matches!(c.separator, Separator::Cup(_) | Separator::Tube(..)) {
        flag(
            "wall share",
            c.wall_share,
            0.5,
            true,
            "most particles meet the side wall, where they slide on in reality, which clears the liquid sooner",
        );
    }
    if let (Separator::Cup(cup), true) = (c.separator, c.ramp > 0.0) {
        let spin_up = cup.vessel.radius.powi(2) * c.medium.density / (14.7 * c.medium.viscosity);
        flag("spin-up", spin_up / c.ramp, 1.0, true, "the liquid lags behind the cup while the speed changes");
    }
    out
}
