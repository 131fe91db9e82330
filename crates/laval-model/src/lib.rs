//! What a machine is: [`parts`] on the coordinates of bodies, the [`model`] they form, units and diagnostics.
//!
//! A part knows physics and no analysis.
#![warn(missing_docs)]
#![forbid(unsafe_code)]

pub use laval_num;

pub mod cavity;
pub mod diagnostic;
pub mod model;
mod numerics;
pub mod parts;
pub mod text;
pub mod units;
