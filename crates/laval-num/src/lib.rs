//! Numerics for the dynamics of machines: scalars with exact derivatives and lanes, small dense algebra, Newton's method,
//! continuation, time integration, eigenproblems, roots and maxima in one variable, Fourier sampling, minimisation without derivatives, and sampling of uncertain inputs. It knows nothing of rotors.
#![warn(missing_docs)]

pub mod analytic;
pub mod bessel;
pub mod complex;
pub mod continuation;
pub mod contour;
pub mod dense;
pub mod dual;
pub mod eig;
pub mod elliptic;
pub mod ensemble;
pub mod factor;
pub mod fourier;
pub mod gamma;
pub mod interpolate;
pub mod lanes;
pub mod nearest;
pub mod newton;
pub mod ode;
pub mod optimise;
pub mod order;
pub mod quadrature;
pub mod rational;
pub mod refill;
pub mod sampling;
pub mod scalar;
pub mod text;
pub mod univariate;
pub mod work;
