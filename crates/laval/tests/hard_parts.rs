//! Parts as any author may write them, through every study that claims to take them.

#[path = "hard_parts/chain.rs"]
mod chain;
mod common;
#[path = "hard_parts/fractional.rs"]
mod fractional;
#[path = "hard_parts/memory.rs"]
mod memory;
#[path = "hard_parts/pendulum.rs"]
mod pendulum;
#[path = "hard_parts/pendulum_tests.rs"]
mod pendulum_tests;
#[path = "hard_parts/studies.rs"]
mod studies;
#[path = "hard_parts/tabulated.rs"]
mod tabulated;
#[path = "hard_parts/tools.rs"]
mod tools;
