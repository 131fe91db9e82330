//! Branches of the response to unbalance, and what is read off them.
pub mod agreement;
pub mod around;
pub mod bifurcation;
pub mod branch;
pub mod families;
pub mod measure;
pub mod methods;
pub(in crate::harmonic) mod on_determinant;
pub mod peak;
pub mod response;
pub mod seeds;
pub mod sensitivity;
pub mod sizes;
pub(in crate::harmonic) mod starts;
pub mod time_starts;
pub mod unclosed;
