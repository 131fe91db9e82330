//! Motions in time, alone and by the thousand.

#[path = "../common/mod.rs"]
mod common;

mod basins;
mod motion_map;
mod sweep;
mod transient_motion;
mod transient_start;
mod transient_study;
