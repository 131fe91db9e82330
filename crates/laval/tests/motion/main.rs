//! Motions in time, alone and by the thousand.

#[path = "../common/mod.rs"]
mod common;

mod basins;
mod claims;
mod motion_map;
mod spin_load;
mod sweep;
mod transient_motion;
mod transient_start;
mod transient_study;
