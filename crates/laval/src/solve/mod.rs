//! Solving: equilibria, spectra, responses, motions. An analysis knows the system and no concrete part.

pub mod characteristic;
pub mod harmonic;
pub mod motion;
pub mod pencil;
pub mod programme;
pub mod rest;
pub mod sectors;
pub mod symmetry;
pub mod turning;
