//! Parts as any author may write them, through every study that claims to take them.

mod chain;
#[path = "../common/mod.rs"]
mod common;
mod fractional;
mod memory;
mod pendulum;
mod pendulum_tests;
mod studies;
mod tabulated;
mod tools;
