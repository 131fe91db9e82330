//! Harmonic balance: periodic motions from linear parts exact in frequency and nonlinear parts sampled in time.
pub mod balance;
pub mod branches;
pub mod free;
pub mod loci;
pub mod stability;
