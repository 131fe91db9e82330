//! Studies of a machine that separates: what is recovered, and the speeds at which it may run.

pub mod cups;
pub mod operating_window;
pub mod separation;
