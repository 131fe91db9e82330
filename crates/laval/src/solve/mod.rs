//! What motion is sought, and how it is found.
pub mod harmonic;
pub mod motion;
pub mod programme;
pub mod symmetry;
