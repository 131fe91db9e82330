//! What a machine is: parts, their parameters and ports, and the system they form.
pub mod field;
pub mod params;
