//! Parts as any author may write them, through every study that claims to take them.

mod chain;
mod fractional;
mod memory;
pub mod pendulum;
mod pendulum_tests;
mod studies;
mod tabulated;
mod tools;
