//! Integration tests of the crate, by subject. Tests that need a process of their own stand beside: `fuzz` and `transient_allocation`.

mod balancer;
mod characteristic_roots;
mod common;
mod ensemble;
mod hard_parts;
mod harmonic;
mod linear;
mod motion;
mod physics;
mod program;
mod report_in_browser;
mod separation;
mod spatial_liquid;
mod store;
