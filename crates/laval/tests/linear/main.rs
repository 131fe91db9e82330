//! Linear machines: modes, responses, stability, sensitivities; the physics of parts.

#[path = "../common/mod.rs"]
mod common;

mod claims;
mod criticals;
mod memory;
mod model_planar;
mod modes;
mod nonlinear_forces;
mod optimum;
mod parts_physics;
mod response;
mod sensitivity;
mod several_unbalances;
mod stability;
mod tilt;
mod uncertainty;
mod viscoelastic;
