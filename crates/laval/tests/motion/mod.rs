//! Motions in time, alone and by the thousand.

mod any_speed;
mod basins;
mod bystanders;
mod claims;
mod continued;
mod finer_shafts;
mod massless;
mod massless_settled;
mod motion_map;
mod natural;
mod slow_run_ups;
mod spin_load;
mod sweep;
mod transient_motion;
mod transient_start;
mod transient_study;
