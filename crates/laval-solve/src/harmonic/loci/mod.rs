//! Loci of bifurcations in the plane of spin speed and one parameter.
mod chain;
pub mod crossings;
pub(in crate::harmonic) mod existence;
pub mod folds;
pub mod follow;
pub mod locus;
pub mod search;
pub mod varied;
