//! Harmonic balance: periodic motions from linear parts exact in frequency and nonlinear parts sampled in time.
pub mod agreement;
pub mod bifurcation;
pub mod branch;
pub mod condense;
pub mod families;
pub mod floquet;
pub mod fourier;
pub mod hill;
mod monodromy;
pub mod nonlinear;
pub mod orbit;
pub mod peak;
pub mod problem;
pub mod response;
pub mod seeds;
pub mod switching;
pub mod terms;
pub mod unclosed;
