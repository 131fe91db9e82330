//! Stability of a periodic motion.
mod counted;
pub mod determinant;
pub mod floquet;
pub mod hill;
pub(in crate::harmonic) mod monodromy;
mod product;
mod series;
