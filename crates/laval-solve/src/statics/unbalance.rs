//! Unbalance of the rotors of a machine as rigid bodies, at the centre of mass and in the planes of two supports.
//!
//! ```text
//! U = sum u_k exp(i phi_k),   S = sum z_k u_k exp(i phi_k) + couples,   P = S - z_c U
//! U_b = (S - z_a U)/(z_b - z_a),   U_a = U - U_b
//! ```
//!
//! u_k, phi_k, z_k size, angle from the key mark and height of the unbalances; z_c centre of mass; P couple unbalance; z_a, z_b planes. U and S are the forces that turn with the rotor, over the square of
//! its speed, along its rigid displacement and its rigid tilt: skews of discs and loads of cups are among them.
//!
//! Sources: ISO 21940-2 (static, couple and dynamic unbalance).

use super::masses::{MassProperties, mass_properties, rigid};
use super::supports::Support;
use crate::model::linear::{Form, LinearModel, LinearScratch};
use crate::model::system::System;
use laval_num::complex::{C64, c};

/// An unbalance in the plane of a support.
#[derive(Clone, Debug, PartialEq)]
pub struct Plane {
    /// Slot of the support.
    pub slot: usize,
    /// Position along the rotor, m, from the point that its centre of mass is measured from.
    pub position: f64,
    /// Size and angle, kg m.
    pub unbalance: C64,
}

/// A rotor as a rigid body.
#[derive(Clone, Debug, PartialEq)]
pub struct Rotor {
    /// Mass properties with all it carries.
    pub mass: MassProperties,
    /// Its own speed, rad/s.
    pub speed: f64,
    /// U, kg m.
    pub resultant: C64,
    /// P about the centre of mass, kg m^2; NaN of a body that does not tilt.
    pub couple: C64,
    /// The planes of its supports, where it has supports in two planes.
    pub planes: Option<[Plane; 2]>,
}

/// The rotors of a machine that turns at a speed (rad/s), whose supports are these.
pub fn rotors(system: &System, speed: f64, supports: &[Support]) -> Vec<Rotor> {
    let (mut model, mut scratch) = (LinearModel::default(), LinearScratch::default());
    system.linear(system.params(), speed, Form::Frequency, &mut model, &mut scratch);
    let whole = mass_properties(system).into_iter().filter(|m| m.part.is_none() && m.mass > 0.0);
    let turning = whole.filter(|m| system.slots()[m.body].part.body().is_some_and(|b| b.turns()));
    turning.filter_map(|mass| rotor(system, &model, speed, supports, mass)).collect()
}

fn rotor(system: &System, model: &LinearModel<f64>, speed: f64, supports: &[Support], mass: MassProperties) -> Option<Rotor> {
    let fields = rigid(system, mass.body)?;
    let own = system.slots()[mass.body].speed(system.params(), speed);
    let dot = |field: &[f64], f: &[f64]| field.iter().zip(f).map(|(a, b)| a * b).sum::<f64>();
    // u exp(i phi) of a force W^2 u cos(W t + phi)
    let along = |field: &[f64]| -> C64 {
        let l = &model.loads;
        let mut sum = c(dot(field, &l.force_cos), -dot(field, &l.force_sin)).scale(1.0 / (speed * speed));
        for o in &l.others {
            sum += c(dot(field, &o.force[0]), -dot(field, &o.force[1])).scale(1.0 / (o.ratio * speed).powi(2));
        }
        sum
    };
    let resultant = along(&fields.along);
    let Some([tilt, _]) = &fields.about_y else {
        return Some(Rotor { mass, speed: own, resultant, couple: c(f64::NAN, f64::NAN), planes: None });
    };
    let first = along(tilt);
    let couple = first - resultant.scale(mass.centre);
    // a place moves by its height with a tilt of 1
    let at = |s: &Support| s.place.0[0].iter().map(|&(g, a)| a * tilt[g]).sum::<f64>();
    let on = |s: &&Support| s.place.0[0].iter().any(|&(g, _)| system.coordinates()[g].slot == mass.body);
    let mut places: Vec<(usize, f64)> = supports.iter().filter(on).map(|s| (s.slot, at(s))).collect();
    places.sort_by(|a, b| a.1.total_cmp(&b.1));
    let size = places.iter().map(|p| p.1.abs()).fold(0.0, f64::max);
    places.dedup_by(|b, a| (b.1 - a.1).abs() <= 1e-9 * size);
    let planes = match places[..] {
        [(a, za), (b, zb)] => {
            let upper = (first - resultant.scale(za)).scale(1.0 / (zb - za));
            let lower = resultant - upper;
            Some([Plane { slot: a, position: za, unbalance: lower }, Plane { slot: b, position: zb, unbalance: upper }])
        }
        _ => None,
    };
    Some(Rotor { mass, speed: own, resultant, couple, planes })
}
