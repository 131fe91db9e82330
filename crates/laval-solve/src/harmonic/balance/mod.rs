//! The balance itself: unknowns, forces of the parts, residual and tangents.
pub mod condense;
pub mod coordinates;
pub mod elliptic;
pub(in crate::harmonic) mod first_order;
pub mod fourier;
pub mod motion;
pub mod nonlinear;
pub mod orbit;
mod orders_in_lanes;
pub mod pace;
pub mod problem;
pub(in crate::harmonic) mod raise;
pub mod refused;
pub(in crate::harmonic) mod sizes;
pub(in crate::harmonic) mod slopes;
pub mod switching;
pub mod terms;
pub(in crate::harmonic) mod whole_period;
