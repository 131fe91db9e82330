//! Integration tests of the crate, by subject. Beside them, in a process of their own: `ensemble` (it reads the machine code of its program),
//! `fuzz` and `transient_allocation`.

/// That of the program.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

mod balancer;
mod characteristic_roots;
mod common;
mod faults;
mod hard_parts;
mod harmonic;
mod linear;
mod motion;
mod physics;
mod program;
mod report_in_browser;
mod separation;
mod shaft;
mod spatial_liquid;
mod store;
