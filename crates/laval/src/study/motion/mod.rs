//! Studies by integration in time.

pub(in crate::study) mod animation;
pub(in crate::study) mod balance;
pub mod basins;
pub(in crate::study) mod drive;
pub(in crate::study) mod history;
pub mod motion_map;
pub(in crate::study) mod moved_roots;
pub(in crate::study) mod passages;
pub mod record;
pub mod run_up;
pub(in crate::study) mod spectra;
pub(in crate::study) mod start;
pub(in crate::study) mod steady_state;
pub mod sweep;
pub mod transient;
pub(in crate::study) mod turns;
pub(in crate::study) mod unstable;
