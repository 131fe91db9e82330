//! Numerics for the dynamics of machines: scalars with exact derivatives and lanes, small dense algebra, Newton's method,
//! continuation, time integration, eigenproblems, polynomials and Fourier sampling. It knows nothing of rotors.
#![warn(missing_docs)]

pub mod complex;
pub mod continuation;
pub mod dense;
pub mod dual;
pub mod eig;
pub mod fourier;
pub mod interpolate;
pub mod lanes;
pub mod newton;
pub mod ode;
pub mod poly;
pub mod quadrature;
pub mod scalar;
