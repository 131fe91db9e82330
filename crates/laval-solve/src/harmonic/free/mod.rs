//! Free whirls and limit cycles.
pub mod backbone;
pub mod cycles;
pub mod whirl;
