//! Solving: equilibria, spectra, responses. An analysis knows the system and no concrete part.

pub mod characteristic;
pub mod extrema;
pub mod locate;
pub mod pencil;
pub mod response;
pub mod rest;
pub mod scalar;
pub mod sectors;
pub mod stability;
pub mod sweep;
pub mod turning;
