//! Solving: equilibria, spectra, responses. An analysis knows the system and no concrete part.

pub mod characteristic;
pub mod harmonic;
pub mod pencil;
pub mod rest;
pub mod sectors;
pub mod symmetry;
pub mod turning;
