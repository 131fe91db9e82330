//! Code that studies of several rooms use.

pub(in crate::study) mod half_power;
pub(in crate::study) mod headings;
pub(in crate::study) mod journals;
pub mod limits;
pub(in crate::study) mod margins;
pub mod operation;
pub(in crate::study) mod place;
pub mod presentation;
pub(in crate::study) mod probes;
pub(in crate::study) mod region;
pub(in crate::study) mod size;
pub mod speed_range;
pub(in crate::study) mod standards;
pub mod stations;
pub mod support;
pub(in crate::study) mod supporting;
pub(in crate::study) mod validity;
pub mod vibration;
pub(in crate::study) mod watch;
