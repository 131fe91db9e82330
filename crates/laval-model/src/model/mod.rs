//! What a machine is: parts, their parameters and ports, and the system they form.
pub mod assembly;
pub mod blocks;
pub mod builder;
pub mod capability;
pub mod conformance;
pub mod context;
pub mod erased;
mod erasure;
pub mod field;
mod inertia;
pub mod lanes;
pub mod linear;
pub mod params;
pub mod part;
pub mod probe;
pub mod system;
pub mod tangent;
pub mod timed;
