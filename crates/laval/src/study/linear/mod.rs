//! Studies of the machine linearised about its equilibrium.

pub mod approximation;
pub mod bearing_coefficients;
pub mod campbell;
pub mod criterion;
pub mod critical_speeds;
pub mod forced_response;
pub(in crate::study) mod growing;
pub mod harmonic_force;
pub mod modes;
mod numbering;
pub(in crate::study) mod operating;
pub(in crate::study) mod over_frequency;
pub mod stability_map;
pub mod stability_threshold;
#[path = "static/mod.rs"]
pub mod statics;
pub mod support_stiffness_map;
pub(in crate::study) mod whirl;
