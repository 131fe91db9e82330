//! Rotor dynamics: one description of a machine, every analysis.
#![warn(missing_docs)]

pub use laval_num;

pub mod diagnostic;
pub mod file;
pub mod model;
pub mod outcome;
pub mod parts;
pub mod report;
pub mod solve;
pub mod study;
pub mod units;
