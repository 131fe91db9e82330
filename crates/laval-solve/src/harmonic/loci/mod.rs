//! Loci of bifurcations in the plane of spin speed and one parameter.
pub mod crossings;
pub(in crate::harmonic) mod existence;
pub mod folds;
pub mod locus;
pub mod path;
pub mod search;
pub mod varied;
