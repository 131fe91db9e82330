//! The registry of studies: the only place that names them all.

use super::kind::{StudyKind, kind};
use super::{centrifuge, linear, motion, nonlinear, parameters};

/// All kinds of studies.
pub fn registry() -> Vec<StudyKind> {
    vec![
        kind::<linear::modes::Modes>(),
        kind::<linear::statics::Static>(),
        kind::<linear::bearing_coefficients::BearingCoefficients>(),
        kind::<linear::campbell::Campbell>(),
        kind::<linear::critical_speeds::CriticalSpeeds>(),
        kind::<linear::support_stiffness_map::SupportStiffnessMap>(),
        kind::<linear::stability_map::StabilityMap>(),
        kind::<linear::stability_threshold::StabilityThreshold>(),
        kind::<linear::forced_response::ForcedResponse>(),
        kind::<linear::harmonic_force::HarmonicForce>(),
        kind::<nonlinear::nonlinear_response::NonlinearResponse>(),
        kind::<nonlinear::bifurcation_loci::BifurcationLoci>(),
        kind::<nonlinear::response_map::ResponseMap>(),
        kind::<nonlinear::stationary::Stationary>(),
        kind::<parameters::sensitivity::Sensitivity>(),
        kind::<nonlinear::backbone::Backbone>(),
        kind::<nonlinear::limit_cycles::LimitCycles>(),
        kind::<nonlinear::methods::Methods>(),
        kind::<motion::transient::Transient>(),
        kind::<motion::run_up::RunUp>(),
        kind::<centrifuge::separation::Separation>(),
        kind::<centrifuge::operating_window::OperatingWindow>(),
        kind::<motion::sweep::Sweep>(),
        kind::<motion::motion_map::MotionMap>(),
        kind::<motion::basins::Basins>(),
        kind::<parameters::uncertainty::Uncertainty>(),
        kind::<parameters::optimum::Optimum>(),
    ]
}
