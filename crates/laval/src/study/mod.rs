//! Studies: analyses of a machine, in rooms by method.

mod blocks;
mod context;
mod kind;
mod registry;

mod centrifuge;
mod linear;
mod motion;
mod nonlinear;
mod overview;
mod parameters;
mod shared;

pub use blocks::{BlockKind, blocks, with_blocks};
pub use centrifuge::{cups, operating_window, separation};
pub use context::{Context, Progress, STEP, Silent};
pub use kind::{ErasedStudy, Study, StudyKind, TypedStudy, kind};
pub use laval_num::work::Cancel;
pub use linear::{
    approximation, bearing_coefficients, campbell, criterion, critical_speeds, forced_response, harmonic_force, modes, stability_map,
    stability_threshold, statics, support_stiffness_map,
};
pub use motion::{basins, motion_map, record, run_up, sweep, transient};
pub use nonlinear::{backbone, bifurcation_loci, limit_cycles, methods, nonlinear_response, response_map, stationary};
pub use overview::{
    Beforehand, blocks as machine_blocks, mode as mode_of_page, overview, overview_after, page_range, with_studies_not_run,
};
pub use parameters::{optimum, sensitivity, uncertainty};
pub use registry::registry;
pub use shared::{limits, operation, presentation, speed_range, stations, support};
