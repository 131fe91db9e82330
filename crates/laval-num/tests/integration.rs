//! Tests of the crate against reference values and at every level of the processor. Beside them, in a process of its own: `ode_allocation` (it counts allocations).

mod bessel;
mod lanes;
mod lanes_accuracy;
