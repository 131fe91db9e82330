//! Harmonic balance: periodic motions from linear parts exact in frequency and nonlinear parts sampled in time.
pub mod backbone;
pub mod condense;
pub mod cycles;
pub mod elliptic;
pub mod floquet;
pub mod fourier;
pub mod free;
pub mod methods;
mod monodromy;
pub mod nonlinear;
pub mod orbit;
pub mod pace;
pub mod peak;
pub mod problem;
pub mod response;
pub mod switching;
pub mod terms;
