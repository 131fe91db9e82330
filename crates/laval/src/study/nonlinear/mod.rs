//! Studies by harmonic balance and continuation: periodic and stationary motions of the nonlinear machine.

pub mod backbone;
pub mod bifurcation_loci;
pub(in crate::study) mod free_motion;
pub mod limit_cycles;
pub mod methods;
pub mod nonlinear_response;
pub(in crate::study) mod progress;
pub mod response_map;
pub mod stationary;
