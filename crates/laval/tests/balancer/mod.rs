//! Rotors balanced by movable balls: motions, stationary states, run-ups, basins.

mod basins;
mod motion;
mod run_up;
mod stationary;
mod stationary_file;
mod stationary_grip;
mod stationary_limits;
mod stationary_machines;
mod studies;
