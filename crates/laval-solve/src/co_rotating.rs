//! States that turn with the rotor: q = R(phase) Q for vectors, constant for everything else. Only a machine without preferred direction has them.

use super::characteristic::{Equilibrium, Frame};
use super::rest::{instead, rest, settle};
use crate::diagnostic::Diagnostic;
use crate::model::part::{At, Physics, Rows};
use crate::model::system::{Axis, Slot, System, Workspace};
use laval_model::text;
use laval_model::text::Text;
use laval_num::complex::{C64, c};
use laval_num::dense::Mat;

/// State stationary in axes that turn at a given speed (rad/s), by Newton's method from `start` (zero when absent).
///
/// # Errors
/// A part with a preferred direction, by name and with its reason; no state found.
pub fn turning(system: &System, speed: f64, start: Option<Equilibrium>) -> Result<Equilibrium, Diagnostic> {
    isotropic(system, speed)?;
    let start =
        start.map_or_else(|| Equilibrium::zero(system, Frame::Turning, speed), |s| Equilibrium { frame: Frame::Turning, speed, ..s });
    // stationary begins at many places, this at one
    settle(system, start).map_err(|d| match d.code {
        "rest.not_held" | "rest.not_found" => {
            let message = text!("from the undeflected machine no state that turns with the rotor was found");
            Diagnostic::error("turning.not_found", message).help(instead(system, speed))
        }
        _ => d,
    })
}

/// Probes every part at random states turned with the machine to three angles.
///
/// # Errors
/// The first part whose forces do not turn along, with its reason.
pub fn isotropic(system: &System, speed: f64) -> Result<(), Diagnostic> {
    match preferring(system, speed) {
        None => Ok(()),
        Some(slot) => Err(Diagnostic::error(
            "turning.anisotropic",
            text!("the machine has no state that turns with the rotor: {reason}", reason = reason(system, slot, speed)),
        )
        .at(slot.span.clone())
        .help(match rest(system, speed) {
            Ok(_) => text!("studies about rest (about = \"rest\"), by harmonics, and in time (transient, run_up) take such a machine"),
            Err(_) => text!("the machine has no equilibrium at rest either: transient and run_up give the motion in time"),
        })),
    }
}

/// The first part with a preferred direction.
pub(super) fn preferring(system: &System, speed: f64) -> Option<&Slot> {
    system.slots().iter().find(|s| changes(system, s, speed, true))
}

/// The part's forces change when state and machine are turned together.
fn changes(system: &System, slot: &Slot, speed: f64, weight: bool) -> bool {
    if let Physics::Frequency(_) = slot.physics
        && impedance_changes(system, slot, speed)
    {
        return true;
    }
    let mut seed = 0x9e37_79b9_7f4a_7c15u64;
    let mut random = || {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    };
    let w = 1.0 + speed.abs();
    let (dofs, states) = (system.coordinates(), system.states());
    let q: Vec<f64> = dofs.iter().map(|d| d.dof.typical * random()).collect();
    let v: Vec<f64> = dofs.iter().map(|d| d.dof.typical * w * random()).collect();
    let a: Vec<f64> = dofs.iter().map(|d| d.dof.typical * w * w * random()).collect();
    let z: Vec<f64> = states.iter().map(|d| d.dof.typical * random()).collect();
    let evaluate = |angle: f64| {
        let (mut q, mut v, mut a, mut z) = (q.clone(), v.clone(), a.clone(), z.clone());
        for x in [&mut q, &mut v, &mut a] {
            system.turn(x, angle);
        }
        system.turn_states(&mut z, angle);
        let (mut force, mut rate, mut spin) = (vec![0.0; system.n()], vec![0.0; system.m()], 0.0);
        let at = At { q: &q, v: &v, a: &a, z: &z, phase: 0.3 + angle, speed, spin_accel: 0.0, t: 0.0 };
        let mut rows = Rows { force: &mut force, rate: &mut rate, spin: &mut spin };
        let name = &slot.name;
        system.residual(system.params(), &at, &mut rows, &mut Workspace::default(), |s| &s.name == name);
        if !weight {
            // the weight acts through the part's mass: taken out by the difference to a fall
            let mut fall = a.clone();
            for (i, x) in fall.iter_mut().enumerate() {
                if dofs[i].dof.kind == crate::model::part::DofKind::VectorY {
                    *x -= crate::model::system::GRAVITY;
                }
            }
            force.fill(0.0);
            rate.fill(0.0);
            let at = At { q: &q, v: &v, a: &fall, z: &z, phase: 0.3 + angle, speed, spin_accel: 0.0, t: 0.0 };
            let mut rows = Rows { force: &mut force, rate: &mut rate, spin: &mut spin };
            system.residual(system.params(), &at, &mut rows, &mut Workspace::default(), |s| &s.name == name);
        }
        system.turn(&mut force, -angle);
        system.turn_states(&mut rate, -angle);
        (force, rate)
    };
    let (force, rate) = evaluate(0.0);
    let differs = |a: &[f64], b: &[f64]| {
        let size = a.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        a.iter().zip(b).any(|(x, y)| (x - y).abs() > 1e-9 * size || (x - y).is_nan())
    };
    [0.7, 2.1, 4.0].iter().any(|&angle| {
        let (f, r) = evaluate(angle);
        differs(&force, &f) || differs(&rate, &r)
    })
}

/// The impedance of one part couples forward, backward and axial motion.
fn impedance_changes(system: &System, slot: &Slot, speed: f64) -> bool {
    let k = slot.map.len();
    let params = &system.params()[slot.params.clone()];
    let coordinates = super::characteristic::coordinate_sectors(system);
    [c(0.0, 0.7 * speed + 10.0), c(5.0, 1.3 * speed + 50.0)].iter().any(|&s| {
        let mut local = vec![C64::zero(); k * k];
        if let Some(part) = slot.part.frequency_domain() {
            part.impedance_f64(params, s, slot.speed(system.params(), speed), &mut local);
        }
        let mut z = Mat::zeros(system.n(), system.n());
        for (i, rows) in slot.map.iter().enumerate() {
            for (j, cols) in slot.map.iter().enumerate() {
                for &(gi, ci) in rows {
                    for &(gj, cj) in cols {
                        z[(gi, gj)] += local[i * k + j].scale(ci * cj);
                    }
                }
            }
        }
        coordinates.polarise_matrix(&coordinates, &mut z);
        let coupling = coordinates.coupling(&coordinates, &z);
        coupling > 1e-9 || coupling.is_nan()
    })
}

/// Why a part has a preferred direction, as far as its parameters tell.
fn reason(system: &System, slot: &Slot, speed: f64) -> Text {
    if system.machine.axis == Axis::Horizontal && !slot.weight.is_empty() && !changes(system, slot, speed, false) {
        return text!("the weight of \"{name}\" pulls to one side (axis = \"horizontal\")", name = slot.name);
    }
    let slots = &system.param_slots()[slot.params.clone()];
    let values = &system.params()[slot.params.clone()];
    for (i, s) in slots.iter().enumerate() {
        let Some(base) = s.name.strip_suffix(".x") else { continue };
        if let (Some(x), Some(y)) = (values.get(i), values.get(i + 1))
            && x != y
        {
            return text!("{base} differs in x ({x} {unit}) and y ({y} {unit})", base, x, y, unit = s.unit);
        }
    }
    text!(
        "the forces of \"{name}\" ({kind}) do not turn along when machine and state are turned",
        name = slot.name,
        kind = slot.part.kind()
    )
}
