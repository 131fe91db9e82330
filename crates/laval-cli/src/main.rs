#![forbid(unsafe_code)]

use std::process::ExitCode;

/// Small matrices come and go by the million: a tenth of the time of studies lies in their allocation.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

fn main() -> ExitCode {
    ExitCode::from(laval_cli::program(std::env::args_os()))
}
