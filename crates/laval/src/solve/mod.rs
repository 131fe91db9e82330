//! What motion is sought, and how it is found.
pub mod harmonic;
pub mod symmetry;
